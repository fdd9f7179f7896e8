"""A mechanism of a run, from its mass matrix, forces and contact point (run_certificate.md, section 1a).

M(q) q'' = f(q, q') + λ_N ∂y/∂q + λ_T ∂x/∂q. All functions are polynomials of coordinates, velocities, sines and cosines
of coordinates. Sines, cosines and the divisors 1/det M, 1/A are states with polynomial rates (Lemma 2), so that
all of run.py is used as it is. Everything is derived here from what the statement says, and nothing else is read.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import permutations
from typing import Any

from intervals import Box, Numbers, add
from limits import Meter, digits, reject, require
from model import Event, Polynomial, number, read_numbers, short, state
from reading import entries

LENGTH, COORDINATES = 1_000, 4  # characters of a formula; how many coordinates
PAIR = 60  # operations of the interpreter for a term of a product that is made, differentiated and kept
NAME = "[A-Za-z][A-Za-z0-9_]{0,39}"
TAKEN = ("M", "T", "damping", "f", "k_1", "k_2", "t", "u", "v", "x", "y", "z")  # names of other things in the statement
EFFECTS = ("belt", "compliant_contact", "lift_off", "stick", "tangential_motion")
Y, V, Z, INVERSE, SLIDE = "y/eps^2", "v/eps", "z/eps^2", "1/det M", "1/A det M"  # states beside those of the mechanism
LIFT, TOUCH, STICK, FORWARDS, BACKWARDS = "lift-off", "touch-down", "stick", "slip forwards", "slip backwards"


def total(polynomials: Sequence[Polynomial]) -> Polynomial:
    """The sum."""
    found = Polynomial()
    for each in polynomials:
        found += each
    return found


def dot(left: Sequence[Polynomial], right: Sequence[Polynomial]) -> Polynomial:
    """The scalar product."""
    return total([a * b for a, b in zip(left, right, strict=True)])


def determinant(rows: Sequence[Sequence[Polynomial]]) -> Polynomial:
    """The determinant, by Leibniz' formula."""
    found = Polynomial()
    for order in permutations(range(len(rows))):
        odd = sum(order[i] > order[j] for j in range(len(rows)) for i in range(j)) % 2
        product = number(-1 if odd else 1)
        for row, column in zip(rows, order, strict=True):
            product = product * row[column]
        found += product
    return found


def adjugate(rows: Sequence[Sequence[Polynomial]]) -> list[list[Polynomial]]:
    """det M times the inverse of a symmetric matrix M."""
    n = range(len(rows))
    minors = [[[[rows[k][m] for m in n if m != j] for k in n if k != i] for j in n] for i in n]
    return [[number((-1) ** (i + j)) * determinant(minors[i][j]) for j in n] for i in n]


def put_in(function: Polynomial, table: Mapping[str, Polynomial], meter: Meter) -> Polynomial:
    """The function with polynomials in the places of some names: its terms can become very many, so they are paid."""
    found = Polynomial()
    for key, value in function.items():
        product = Polynomial({tuple(name for name in key if name not in table): value})
        meter.spend(0, PAIR)
        for name in key:
            if name in table:
                product = paid(product, table[name], meter)
        for name, share in product.items():
            found.take(name, share)
    return found


def paid(left: Polynomial, right: Polynomial, meter: Meter) -> Polynomial:
    """The product."""
    pairs = len(left) * len(right)
    meter.spend(pairs * 8 * (longest_number(left) + longest_number(right)) ** 2, pairs * PAIR)
    return left * right


def longest_number(function: Polynomial) -> int:
    """The length of its longest coefficient, in digits."""
    return max((digits(value.numerator, value.denominator) for value in function.values()), default=1)


def names_of(functions: Sequence[Polynomial]) -> set[str]:
    """What occurs in them."""
    return {name for function in functions for key in function for name in key}


class Mechanism:
    """The formulas, as the statement writes them: terms c*name*name*... joined by " + ".

    A coordinate q has the names q, q_dot, sin(q), cos(q); where q is an angle with a reference q_ref, whose sine and
    cosine are given, (q-q_ref) stands in the place of q.
    """

    def __init__(self, given: Any) -> None:
        parts = ("angles", "coordinates", "forces", "mass_matrix", "mu", "x", "y")
        angles, coordinates, forces, rows, mu, x, y = entries(given, "the mechanism", *parts)
        require(isinstance(coordinates, list) and 1 <= len(coordinates) <= COORDINATES, "the number of coordinates")
        for q in coordinates:
            plain = isinstance(q, str) and re.fullmatch(NAME, q) and not q.endswith(("_dot", "_ref"))
            require(plain and q not in TAKEN, f"{q!a:.50} is no name of a coordinate")
        require(len(set(coordinates)) == len(coordinates), "two coordinates have one name")
        require(isinstance(angles, dict) and set(angles) <= set(coordinates), "the angles are not coordinates")
        self.references = dict.fromkeys(coordinates, (Fraction(0), Fraction(1)))
        for q, pair in angles.items():
            require(isinstance(pair, list) and len(pair) == 2, "an angle without sine and cosine")
            sine, cosine = map(short, pair)
            require(sine**2 + cosine**2 == 1, "a sine and a cosine with squares that do not add to 1")
            self.references[q] = (sine, cosine)
        self.given, self.coordinates = given, coordinates
        self.place = {q: f"({q}-{q}_ref)" if q in angles else q for q in coordinates}
        n = len(coordinates)
        require(isinstance(forces, list) and len(forces) == n, "the number of forces")
        square = isinstance(rows, list) and all(isinstance(row, list) and len(row) == n for row in rows)
        require(square and len(rows) == n, "the size of the mass matrix")
        self.x, self.y = self.formula(x, still=True), self.formula(y, still=True)
        self.mass = [[self.formula(entry, still=True) for entry in row] for row in rows]
        require(all(self.mass[i][j] == self.mass[j][i] for i in range(n) for j in range(i)), "M is not symmetric")
        self.minors = [determinant([row[:k] for row in self.mass[:k]]) for k in range(1, n + 1)]
        self.cofactors = adjugate(self.mass)
        self.forces, self.mu = [self.formula(force) for force in forces], short(mu)
        require(self.mu >= 0, "μ < 0")

    def formula(self, text: Any, still: bool = False) -> Polynomial:
        """A polynomial; ``still``: without velocities."""
        require(isinstance(text, str) and len(text) <= LENGTH, f"a formula has more than {LENGTH} characters")
        names = {name for q in self.coordinates for name in (self.place[q], f"sin({q})", f"cos({q})")}
        names |= set() if still else {f"{q}_dot" for q in self.coordinates}
        found = Polynomial()
        for term in text.split(" + "):
            first, *factors = term.split("*")
            require(set(factors) <= names, f"{term!a:.80} has a name that it cannot have")
            found += number(short(first)) * Polynomial({tuple(sorted(factors)): Fraction(1)})
        return found

    def by(self, function: Polynomial, q: str) -> Polynomial:
        """The derivative by a coordinate."""
        sine, cosine = f"sin({q})", f"cos({q})"
        through = function.by(sine) * state(cosine) - function.by(cosine) * state(sine)
        return function.by(self.place[q]) + through

    def rate(self, function: Polynomial) -> Polynomial:
        """The derivative by time of a function without velocities."""
        return total([self.by(function, q) * state(f"{q}_dot") for q in self.coordinates])

    def normal(self, eps: Polynomial) -> dict[str, Polynomial]:
        """The coordinate q_n where y = r q_n + rest, r a number, and its velocity, by Y, V and the others."""
        for q in self.coordinates:
            slope, names = self.y.by(self.place[q]), names_of([self.y])
            if slope and not names_of([slope]) and not names & {f"sin({q})", f"cos({q})"}:
                rest, share = self.y - slope * state(self.place[q]), number(1 / slope[()])
                height, speed = eps * eps * state(Y) - rest, eps * state(V) - self.rate(rest)
                return {self.place[q]: share * height, f"{q}_dot": share * speed}
        return reject("y has no coordinate of which it is a multiple beside the others")

    def circle(self, q: str, angle: Fraction, numbers: Numbers) -> Box:
        """Sine and cosine of a coordinate, which is counted from its reference."""
        sine, cosine = numbers.sine_cosine(angle)
        s, c = self.references[q]
        return {
            f"sin({q})": add(numbers.scaled(s, cosine), numbers.scaled(c, sine)),
            f"cos({q})": add(numbers.scaled(c, cosine), numbers.scaled(-s, sine)),
        }

    def words(self) -> str:
        """The mechanism in the statement."""
        given, angles = self.given, []
        for q, (sine, cosine) in self.references.items():
            if q in given["angles"]:
                angles.append(f", sin({q}_ref) = {sine}, cos({q}_ref) = {cosine}")
        rows = "; ".join(", ".join(row) for row in given["mass_matrix"])
        return (
            "the mechanism M q'' = f + λ_N dy/dq + λ_T dx/dq with "
            f"q = ({', '.join(self.coordinates)}){''.join(angles)}, "
            f"M = ({rows}), f = ({', '.join(given['forces'])}), x = {given['x']}, y = {given['y']}, μ = {self.mu}"
        )


class MechanismScene:
    """What is simulated: the mechanism, effects, ε, the end of the time, the contact, the start; all of it exact."""

    def __init__(
        self, mechanism: Any, effects: Any, epsilon: Any, until: Any, parameters: Any, start: Any, meter: Meter
    ) -> None:
        known = isinstance(effects, list) and all(isinstance(name, str) and name in EFFECTS for name in effects)
        require(known and sorted(set(effects)) == effects, "the effects are not some of those known, in order")
        require("compliant_contact" in effects, "the contact is not compliant")
        self.slides, self.sticks = "tangential_motion" in effects, "stick" in effects
        self.lifts, self.coupled = "lift_off" in effects, False
        self.follows = "belt" not in effects  # u, which is counted from the surface: its velocity is not known there
        require(self.slides or not self.sticks, "stick without tangential motion")
        require(not (self.slides and "belt" in effects), "tangential motion on a belt")
        self.effects, self.epsilon, self.until = effects, short(epsilon), short(until)
        self.of = read_numbers(parameters, "the parameters", "damping", "k_1", "k_2")
        require(self.epsilon > 0 and self.until > 0, "ε or the time is not positive")
        require(min(self.of.values()) > 0, "a stiffness or the damping is not > 0")
        self.mechanism = Mechanism(mechanism)
        phases = ["slip", *["flight"] * self.lifts, *["stick", "reverse slip"] * self.sticks]
        motions = {phase: Motion(self, phase, meter) for phase in phases}
        self.kept = self.needed([(each.rates, names_of(each.functions.values())) for each in motions.values()])
        self.systems = {phase: MechanismSystem(self, motion) for phase, motion in motions.items()}
        for motion in motions.values():
            self.check_others(motion)
        normal = {
            f"{name}({q})"
            for name in ("sin", "cos")
            for q in self.mechanism.coordinates
            if self.mechanism.place[q] in motions["slip"].solved
        }
        require(not normal & self.kept, "a sine of the coordinate that y replaces")
        self.start = read_numbers(start, "the start", *self.given(), "y", "v", "z")
        require(self.start["z"] >= self.start["y"], "the start is not in contact")

    def needed(self, parts: Sequence[tuple[Mapping[str, Polynomial], set[str]]]) -> set[str]:
        """The states on which V and what is watched depend, and those on which their rates depend."""
        found: set[str] = set()
        waiting = {V}.union(*(names for _, names in parts))
        while waiting:
            found |= waiting
            waiting = names_of([rates[name] for rates, _ in parts for name in found if name in rates]) - found
        return found

    def check_others(self, motion: Motion) -> None:
        """What is not kept is found from what is, by integrals of known functions: it exists as long as that does."""
        known, places = set(self.kept), self.mechanism.place
        left = [{places[q], f"{q}_dot"} - known - set(motion.solved) for q in self.mechanism.coordinates]
        waiting = set().union(*left)
        while waiting:
            found = {name for name in waiting if names_of([motion.rates[name]]) <= known}
            require(found, "a coordinate that is not followed may be one that ends to exist")
            known, waiting = known | found, waiting - found

    def given(self) -> list[str]:
        """What the start gives of the coordinates and velocities."""
        found = []
        for q in self.mechanism.coordinates:
            place = self.mechanism.place[q]
            found += [place] * bool(self.kept & {place, f"sin({q})", f"cos({q})"}) + [f"{q}_dot"] * (
                f"{q}_dot" in self.kept
            )
        return found

    def first_box(self, numbers: Numbers) -> Box:
        """The start in units of ε."""
        e, at, mechanism = self.epsilon, self.start, self.mechanism
        exact = {Y: at["y"] / e**2, V: at["v"] / e, Z: at["z"] / e**2, "T": Fraction(0)}
        box = {name: numbers.interval(value) for name, value in (exact | at).items() if name not in ("y", "v", "z")}
        for q in mechanism.coordinates:
            if mechanism.place[q] in at:
                box |= mechanism.circle(q, at[mechanism.place[q]], numbers)
        system = self.systems["slip"]
        for minor in system.motion.minors:
            require(names_of([minor]) <= set(box), "M depends on what is not followed")
            require(minor.on(box, numbers)[0] > 0, "M is not certainly positive definite at the start")
        if system.motion.inverse:
            box[INVERSE] = numbers.reciprocal(system.motion.minors[-1].on(box, numbers))
        return box

    def system(self, phase: str) -> MechanismSystem:
        """The equations of a phase."""
        return self.systems[phase]

    def begin(self, box: Box, numbers: Numbers) -> tuple[str, str, int]:
        """The first phase, the event whose function is 0 where it begins, and which of its derivatives is not."""
        event = self.systems["slip"].events[LIFT]
        if self.start["z"] > self.start["y"]:
            return "slip", "", 0
        return "slip", LIFT, 2 if event.rate.on(box, numbers) == (0, 0) else 1

    def after(self, event: str, box: Box, numbers: Numbers) -> tuple[str, str, int]:
        """The same of the phase after an event."""
        if event == LIFT:
            return "flight", TOUCH, 1
        if event == STICK:
            return "stick", "", 0
        if event in (FORWARDS, BACKWARDS):
            return ("slip" if event == FORWARDS else "reverse slip"), STICK, 2
        if not self.follows:
            return "slip", LIFT, 1
        u = self.systems["slip"].events[STICK].function.on(box, numbers)
        require(u[0] > 0 or (u[1] < 0 and self.sticks), "the direction of slip at touch-down is not certain")
        return ("slip" if u[0] > 0 else "reverse slip"), LIFT, 1

    def words(self) -> str:
        """The scene in the statement."""
        lists = [", ".join(f"{name} = {value}" for name, value in sorted(of.items())) for of in (self.of, self.start)]
        scene = f"{', '.join(self.effects)}, ε = {self.epsilon}, {lists[0]}, from {lists[1]}"
        return f"{self.mechanism.words()}, with {scene}"

    def seen(self) -> list[str]:
        """What is seen to hold of the effects that are left out, or is assumed (left_out_effects.md)."""
        after = " after the start, where it is 0" * (self.start["z"] == self.start["y"])
        found = [f"λ_N > 0 all along{after}, as leaving an effect out assumes"] * (not self.lifts)
        found += ["u > 0 in contact all along, as leaving an effect out assumes"] * (self.follows and not self.sticks)
        return found + ["provided that in contact slip is positive, which is not shown"] * (not self.follows)


class Motion:
    """The derivatives by T of all that a phase may depend on, and its events' functions, in terms of the coordinates.

    ``minors``: the leading ones of M. ``inverse``: whether 1/det M is a state; ``divisor``: A det M where its inverse
    is one, as in stick.
    """

    def __init__(self, scene: MechanismScene, phase: str, meter: Meter) -> None:
        m, c, eps = scene.mechanism, scene.of, number(scene.epsilon)
        dots = [state(f"{q}_dot") for q in m.coordinates]
        table = m.normal(eps)
        self.phase, det, cofactors = phase, m.minors[-1], m.cofactors
        self.inverse = bool(names_of([det]))
        require(self.inverse or det, "det M is 0")
        w = state(INVERSE) if self.inverse else number(1 / det[()])
        by_x, by_y = ([m.by(f, q) for q in m.coordinates] for f in (m.x, m.y))
        gap = state(Y) - state(Z)
        force = number(-c["k_2"] * (phase != "flight")) * gap
        pushed = [f + force * y for f, y in zip(m.forces, by_y, strict=True)]  # all but friction
        across = [dot(by_x, row) for row in cofactors]  # det M times M⁻¹ ∂x/∂q
        A = dot(by_x, across)  # A det M
        still = dot(across, pushed) + det * dot([m.rate(f) for f in by_x], dots)  # u' det M without friction
        self.divisor = A if phase == "stick" and names_of([A]) else Polynomial()
        require(phase != "stick" or A, "A is 0")
        share = state(SLIDE) if self.divisor else number(1 / A.get((), Fraction(1)))
        friction = {
            "slip": number(-m.mu) * force, "reverse slip": number(m.mu) * force, "stick": -share * still,
        }.get(phase, Polynomial())  # fmt: skip
        forces = [f + friction * x for f, x in zip(pushed, by_x, strict=True)]
        accelerations = [w * dot(row, forces) for row in cofactors]
        rates = {
            Y: state(V),
            V: dot(by_y, accelerations) + dot([m.rate(f) for f in by_y], dots),
            Z: number(1 / c["damping"]) * (number(-c["k_1"]) * state(Z) - force),
            INVERSE: -eps * w * w * m.rate(det),
            SLIDE: -eps * share * share * m.rate(self.divisor),
        }
        for q, dot_q, acceleration in zip(m.coordinates, dots, accelerations, strict=True):
            rates |= {m.place[q]: eps * dot_q, f"{q}_dot": eps * acceleration}
            rates |= {f"sin({q})": eps * dot_q * state(f"cos({q})"), f"cos({q})": -eps * dot_q * state(f"sin({q})")}
        functions = {LIFT: -gap} if phase != "flight" else {TOUCH: gap}
        u = dot(by_x, dots)
        if scene.follows and phase in ("slip", "reverse slip"):
            functions[STICK] = u if phase == "slip" else -u
        if phase == "stick":  # |λ_T| ≤ μ λ_N, times A det M > 0
            functions[FORWARDS] = number(m.mu) * A * force - still
            functions[BACKWARDS] = number(m.mu) * A * force + still
        self.solved = table
        self.rates = {name: put_in(rate, table, meter) for name, rate in rates.items()}
        self.functions = {name: put_in(function, table, meter) for name, function in functions.items()}
        self.minors = [put_in(minor, table, meter) for minor in m.minors]
        self.divisor = put_in(self.divisor, table, meter)


class MechanismSystem:
    """The equations of one phase for the states that are kept, and its events."""

    def __init__(self, scene: MechanismScene, motion: Motion) -> None:
        self.phase, self.motion = motion.phase, motion
        self.names = sorted(scene.kept - (set() if motion.divisor else {SLIDE}))
        self.rates = {name: motion.rates[name] for name in self.names}
        self.jacobian = [[self.rates[i].by(j) for j in self.names] for i in self.names]
        self.events = {name: Event(function, self.rates) for name, function in motion.functions.items()}
        allowed = {LIFT: scene.lifts, TOUCH: scene.lifts, STICK: scene.sticks}
        self.endings = [name for name in self.events if allowed.get(name, True)]

    def entered(self, box: Box, numbers: Numbers) -> Box:
        """The states where the phase begins: with the divisor of stick, which is certainly > 0."""
        if not self.motion.divisor:
            return box
        return box | {SLIDE: numbers.reciprocal(self.motion.divisor.on(box, numbers))}
