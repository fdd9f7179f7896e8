"""Check a run: every step, every event, their order, and contact for ever (run_certificate.md).

The statement is in the first line: a scene in exact numbers, and its changes of phase, each with a bracket of its time.
The equations and the events are those of model.py and mechanism.py; the file has polynomials, bases and bounds that
any producer may have chosen. No radius is believed: each follows from the start, the jumps and the defects.

    Steps     how far solutions can be from a polynomial curve (section 2, Theorems N1' and N2)
    Signs     what stays positive, and what leaves zero (section 3, Theorem N3)
    Impact    contact for ever (invariant_region.md, Theorems R1, R2 and R4)
    The run   from phase to phase, to the statement (section 4)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from intervals import Box, Interval, Matrix, Numbers, add, root_up, size, up, wider
from limits import Limits, Meter, reject, require
from mechanism import MechanismScene, MechanismSystem
from model import Event, Polynomial, Scene, System, number, state
from reading import entries, rational, read_line

AnySystem = System | MechanismSystem

VERSION = 4
HYPOTHESES = ["invariant_region", "left_out_effects", "run_certificate"]
HALVINGS = 40  # of a step, where a sign is open
LENGTH = 400  # of a list of coefficients
BITS = range(64, 1025)
WORK, WORK_PER_BYTE = 10**8, 10_000  # products of digits: for each unit of Limits.work, for each byte

# ---------------------------------------------------------------------------------------------------------------------
# Steps: a polynomial curve x(τ), τ in [0, 1], and how far from it a solution can be.
# ---------------------------------------------------------------------------------------------------------------------


class Basis:
    """A regular matrix S with columns in blocks, and an enclosure of its inverse."""

    def __init__(self, numbers: Numbers, blocks: Any, S: Any, n: int) -> None:
        whole = isinstance(blocks, list) and all(type(b) is int and 0 < b <= n for b in blocks) and sum(blocks) == n
        require(whole and isinstance(S, list) and len(S) == n * n, "a basis of another size")
        exact = [numbers.read(value) for value in S]
        rows = [exact[i * n : i * n + n] for i in range(n)]
        self.numbers, self.starts = numbers, [sum(blocks[:i]) for i in range(len(blocks) + 1)]
        self.S, self.inverse = [[(v, v) for v in row] for row in rows], numbers.inverse(rows)
        self.rows = [self.lengths(row) for row in self.S]

    def lengths(self, values: Sequence[Interval]) -> list[int]:
        """Bounds of the Euclidean length of each block of a vector."""
        return [self.numbers.length(values[a:b]) for a, b in pairwise(self.starts)]

    def reach(self, radii: Sequence[int]) -> list[int]:
        """Bounds of the components of S ζ where block j of ζ has a length ≤ radii[j]."""
        return self.numbers.apply_up(self.rows, radii)

    def norms(self, A: Matrix, other: Basis) -> list[list[int]]:
        """Bounds of the norms of the blocks of a matrix, here by there: the root of the largest row sum of |A'A|."""
        found: list[list[int]] = []
        for a, b in pairwise(self.starts):
            found.append([])
            for c, d in pairwise(other.starts):
                block = [row[c:d] for row in A[a:b]]
                gram = self.numbers.product([list(column) for column in zip(*block, strict=True)], block)
                found[-1].append(root_up(max(sum(map(size, row)) for row in gram) << self.numbers.bits))
        return found

    def growth(self, J: Matrix) -> list[list[int]]:
        """M of Theorem N1': norms of the blocks of S⁻¹JS, in the diagonal logarithmic ones (Gershgorin's discs)."""
        B = self.numbers.product(self.numbers.product(self.inverse, J), self.S)
        M = self.norms(B, self)
        for j, (a, b) in enumerate(pairwise(self.starts)):
            disc = [sum(up(size(add(B[i][k], B[k][i])), 2) for k in range(a, b) if k != i) for i in range(a, b)]
            M[j][j] = max(B[i][i][1] + disc[i - a] for i in range(a, b))
        return M


class Curve:
    """Polynomials in τ on [0, 1] for the states of a phase, in units of 2^-unit, and the length h of the step in T."""

    def __init__(self, numbers: Numbers, system: AnySystem, h: Any, unit: Any, x: Any) -> None:
        self.numbers, self.names, self.h = numbers, system.names, numbers.read(h)
        require(self.h > 0 and type(unit) is int and 1 <= unit <= numbers.bits, "h or the unit of a step")
        given = entries(x, "a curve", *self.names)
        for c in given:
            require(isinstance(c, list) and 1 <= len(c) <= LENGTH, "a list of coefficients")
            require(all(type(v) is int and v.bit_length() <= numbers.bits + unit for v in c), "a coefficient")
        self.x = {name: [v << (numbers.bits - unit) for v in c] for name, c in zip(self.names, given, strict=True)}
        self.products: dict[tuple[str, ...], tuple[list[int], int]] = {(): ([numbers.one], 0)}
        self.start = {name: (c[0], c[0]) for name, c in self.x.items()}
        self.end = {name: (sum(c), sum(c)) for name, c in self.x.items()}

    def on(self, form: Mapping[str, int], a: int, b: int) -> Interval:
        """A sum of ± components for τ in [a, b]: the mean value form about the middle."""
        c = [0] * max(len(self.x[name]) for name in form)
        for name, sign in form.items():
            for k, v in enumerate(self.x[name]):
                c[k] += sign * v
        middle = (a + b) >> 1
        value = self.numbers.on(c, (middle, middle))
        if a == b:
            return value
        slope = self.numbers.on([k * v for k, v in enumerate(c)][1:], (a, b))
        return add(value, self.numbers.mul(slope, (a - middle, b - middle)))

    def box(self, a: int, b: int, radii: Sequence[int]) -> Box:
        """The states within radii of the curve, τ in [a, b]."""
        return {name: wider(self.on({name: 1}, a, b), r) for name, r in zip(self.names, radii, strict=True)}

    def product(self, key: tuple[str, ...]) -> tuple[list[int], int]:
        """A polynomial, and how far on [0, 1] the product of some states' polynomials can be from it (Lemma 1)."""
        if key not in self.products:
            (left, error), right, one = self.product(key[:-1]), self.x[key[-1]], self.numbers.one
            whole = self.numbers.convolution(left, right)
            kept = [c >> self.numbers.bits for c in whole]
            while len(kept) > 1 and kept[-1] in (-1, 0):
                kept.pop()
            exact = sum(c == k * one for c, k in zip(whole, kept, strict=False))
            rounded = len(whole) - exact  # coefficients that are wrong, each by at most a unit
            self.products[key] = kept, up(error * sum(map(abs, right)), one) + rounded
        return self.products[key]

    def defect(self, rates: Mapping[str, Polynomial]) -> list[int]:
        """Bounds of |h f(x) - dx/dτ| for each state: sums of the absolute values of coefficients (Lemma 1)."""
        found = []
        for name in self.names:
            f, multiple = rates[name], self.numbers.multiple
            common = self.numbers.common_denominator(f.values())
            slope = [k * v for k, v in enumerate(self.x[name])][1:]
            terms, rest = [multiple(-common << self.numbers.bits, slope)], 0
            for key, value in f.items():
                factor, (c, error) = self.h * value.numerator * (common // value.denominator), self.product(key)
                terms.append(multiple(factor, c))
                rest += abs(factor) * error
            total = [0] * max(map(len, terms))  # common (h f(x) - x') in units of 2^(-2 bits)
            for term in terms:
                for k, v in enumerate(term):
                    total[k] += v
            found.append(up(sum(map(abs, total)) + rest, common << self.numbers.bits))
        return found


Errors = tuple[Basis, list[int]]
"""A state is S ζ from a curve; block j of ζ is not longer than entry j."""


class Step:
    """One proved step from the time ``clock``: at τ in [0, 1] each solution lies within ``tube`` of the curve, by
    component, and at τ = 1 within ``errors``. ``before``: the errors at the start about another curve, which begins
    ``jump`` higher; None: the solutions start anywhere in the box ``jump`` about the start of this curve.
    """

    def __init__(
        self, curve: Curve, system: AnySystem, pieces: Any, before: Errors | None, jump: list[Interval], clock: Interval
    ) -> None:
        self.curve, self.numbers, self.clock = curve, curve.numbers, clock
        n, left, defect = len(system.names), 0, curve.defect(system.rates)
        self.tube = [0] * n
        require(isinstance(pieces, list), "the pieces are not a list")
        for piece in pieces:
            entry, blocks, end, nodes = entries(piece, "a piece", "basis", "blocks", "end", "nodes")
            basis, right = Basis(self.numbers, blocks, entry, n), self.numbers.read(end)
            require(left < right <= self.numbers.one, "the ends of the pieces")
            bounds = self.read_nodes(nodes, len(blocks))
            entered = self.enter(basis, before, jump)
            require(all(w >= r for w, r in zip(bounds[0], entered, strict=True)), "a bound begins below the errors")
            reach = basis.reach([max(column) + 1 for column in zip(*bounds, strict=True)])
            box = curve.box(left, right, reach)
            M = basis.growth([[derivative.on(box, self.numbers) for derivative in row] for row in system.jacobian])
            self.check_majorant(bounds, M, self.pushes(basis, defect), right - left)
            self.tube = [max(old, new) for old, new in zip(self.tube, reach, strict=True)]
            before, left, jump = (basis, bounds[-1]), right, [(0, 0)] * n
        if before is None or left != self.numbers.one:
            reject("the pieces do not fill the step")
        self.errors = before

    def read_nodes(self, nodes: Any, blocks: int) -> list[list[int]]:
        """Bounds w_0, ..., w_K > 0 of the errors in each block, at equal distances of τ."""
        require(isinstance(nodes, list) and len(nodes) >= 2, "there are not two nodes")
        require(all(isinstance(w, list) and len(w) == blocks for w in nodes), "a node has another number of blocks")
        bounds = [[self.numbers.read(value) for value in w] for w in nodes]
        require(all(value > 0 for w in bounds for value in w), "a node is not positive")
        return bounds

    def enter(self, basis: Basis, before: Errors | None, jump: list[Interval]) -> list[int]:
        """Theorem N2: bounds of the errors in the blocks of another basis, about another curve."""
        found = basis.lengths([row[0] for row in self.numbers.product(basis.inverse, [[v] for v in jump])])
        if before is not None:
            turned = basis.norms(self.numbers.product(basis.inverse, before[0].S), before[0])
            found = [a + b for a, b in zip(found, self.numbers.apply_up(turned, before[1]), strict=True)]
        return found

    def pushes(self, basis: Basis, defect: list[int]) -> list[int]:
        """d of Theorem N1': bounds of the blocks of |S⁻¹| times the defect."""
        absolute = [[size(v) for v in row] for row in basis.inverse]
        return basis.lengths([(0, v) for v in self.numbers.apply_up(absolute, defect)])

    def check_majorant(self, bounds: list[list[int]], M: list[list[int]], d: list[int], length: int) -> None:
        """Theorem N1': K (w_{k+1} - w_k) ≥ l (h M w + d) at both ends of each of the K parts."""
        h, one = self.curve.h, self.numbers.one
        scaled = [[up(entry * h, one) for entry in row] for row in M]
        rates = [[up(entry * length, one) for entry in row] for row in scaled]
        pushes = [up(entry * length, one) for entry in d]
        driven = [self.numbers.apply_up(rates, w) for w in bounds]
        for (v, w), (at_v, at_w) in zip(pairwise(bounds), pairwise(driven), strict=True):
            needed = [max(a, b) + push for a, b, push in zip(at_v, at_w, pushes, strict=True)]
            rises = [(len(bounds) - 1) * (b - a) for a, b in zip(v, w, strict=True)]
            require(all(rise >= least for rise, least in zip(rises, needed, strict=True)), "a bound rises too slowly")

    def states(self, a: int, b: int) -> Box:
        """The states for τ in [a, b]."""
        return self.curve.box(a, b, self.tube)

    def time(self, a: int, b: int) -> Interval:
        """T for τ in [a, b]."""
        return add(self.clock, self.numbers.mul((a, b), (self.curve.h, self.curve.h)))

    def value(self, event: Event, a: int, b: int) -> Interval:
        """An event's function for τ in [a, b]."""
        if not event.form:
            return event.function.on(self.states(a, b), self.numbers)
        reach = sum(r for name, r in zip(self.curve.names, self.tube, strict=True) if name in event.form)
        return wider(self.curve.on(event.form, a, b), reach)

    def slope(self, event: Event, a: int, b: int) -> Interval:
        """Its derivative by T."""
        return event.rate.on(self.states(a, b), self.numbers)


# ---------------------------------------------------------------------------------------------------------------------
# Signs of the events' functions.
# ---------------------------------------------------------------------------------------------------------------------


def positive(step: Step, event: Event, a: int, b: int) -> bool:
    """Whether it is certainly > 0 for all τ in [a, b]: by its range, or as it is monotone and > 0 at the lower end."""
    waiting = [(a, b, HALVINGS)]
    while waiting:
        a, b, left = waiting.pop()
        if step.value(event, a, b)[0] > 0:
            continue
        slope = step.slope(event, a, b)
        if slope[0] > 0 or slope[1] < 0:
            end = a if slope[0] > 0 else b
            if step.value(event, end, end)[0] <= 0:
                return False
        elif left == 0:
            return False
        else:
            middle = (a + b) >> 1
            waiting += [(middle, b, left - 1), (a, middle, left - 1)]
    return True


def risen(step: Step, event: Event, most: int, order: int) -> int:
    """τ ≤ most up to which a function rises that is 0 where the phase begins (with its derivative, where ``order`` is
    2), and at which it is > 0 (Theorem N3)."""
    derivative = event.rate if order == 1 else event.curvature
    for halvings in range(HALVINGS):
        tau = most >> halvings
        rises = derivative.on(step.states(0, tau), step.numbers)[0] > 0
        if rises and step.value(event, tau, tau)[0] > 0:
            return tau
    return reject("a function that is 0 where a phase begins does not certainly rise")


# ---------------------------------------------------------------------------------------------------------------------
# Impact without collision: contact for ever.
# ---------------------------------------------------------------------------------------------------------------------


def contact_for_ever(scene: Scene, system: System, box: Box, numbers: Numbers, cone: Any) -> Fraction:
    """The rate a of growth of λ: Theorem R2 with R1, or with R4 where the cone has a c (invariant_region.md)."""
    require(isinstance(cone, list) and len(cone) in (1, 2), "a cone is not [a] or [a, c]")
    require(system.phase == "slip" and not scene.slides and not scene.coupled, "no cone in this phase of this scene")
    a, c, of, eps, zero = rational(cone[0]), rational(cone[-1]), scene.of, scene.epsilon, Fraction(0)
    k, kappa, gamma = of["k_2"], of["k_1"] / of["damping"], 1 / of["damping"]
    s = kappa + gamma * k

    def least(f: Polynomial) -> Fraction:
        return Fraction(f.on(box, numbers)[0], numbers.one)

    force, W, G = system.force, -state("V"), -system.acceleration
    D = -number(s) * force - number(kappa * k) * state("Y") - number(k) * state("V")
    S = number(kappa) * W + G
    constant, factor = eps * of["alpha_2"], eps * of["alpha_1"] * (1 - of["beta"])  # H = constant + factor λ
    require(of["alpha_1"] <= 0, "cone: q = -p falls")
    require(a > 0 and least(force) > 0 and least(W) >= 0 and least(G) >= 0, "cone: a, λ > 0 and W, G ≥ 0")
    h = max(factor + max(constant, zero) / least(force), zero)
    q_least, q_most = least(-system.p), -least(system.p)
    q_fast = (a * (s + a) + k * h / a) / k  # from this q on Theorem R1 holds
    require(least(D - number(a) * force) >= 0, "cone: D ≥ a λ")
    if len(cone) == 1:
        require(least(number(k) * S - number(a * (s + a)) * force) >= 0, "cone: k S ≥ a (s + a) λ")
        require(q_least >= q_fast, "cone: k q ≥ a (s + a) + k h/a")
        return a
    require(a < kappa and c > 0 and least(S) > 0, "cone: a < κ, c > 0, S > 0")
    require(least(number(k) * S - number(a) * (D + number(s) * force)) >= 0, "cone: k S ≥ a M")
    require(least(number(kappa) * G - number(a) * S) >= 0, "cone: κ G ≥ a S")
    require(least(D - number(c) * S) >= 0, "cone: D ≥ c S")
    require((kappa - a) * c * (q_least - h / a) >= a**2, "cone: (κ - a) c (q - h/a) ≥ a²")
    bracket = k - c * (kappa + s) - c**2 * (max(q_most, q_fast) + max(-factor, zero) / a)
    require(bracket >= 0 and bracket * least(S) >= c * max(-constant, zero), "cone: the second inequality of (4)")
    return a


# ---------------------------------------------------------------------------------------------------------------------
# The run.
# ---------------------------------------------------------------------------------------------------------------------


class Run:
    """Phase after phase: where ``phase`` begins, the states lie in ``box`` and T in ``clock``, and the function of the
    event ``at_zero``, if there is one, is 0, with its derivative where ``order`` is 2. ``found``: the events before.
    ``growth``: of λ for ever, at the end.
    """

    def __init__(self, scene: Scene | MechanismScene, numbers: Numbers, lines: Iterator[bytes]) -> None:
        self.scene, self.numbers, self.lines = scene, numbers, lines
        self.box, self.clock = scene.first_box(numbers), (0, 0)
        self.phase, self.at_zero, self.order = scene.begin(self.box, numbers)
        self.found: list[tuple[str, Interval]] = []
        self.growth: Fraction | None = None

    def next_line(self, name: str, *keys: str) -> list[Any]:
        """The values of the next line."""
        return entries(read_line(next(self.lines, b"null")), name, *keys)

    def follow(self) -> None:
        """All phases, up to one that no event ends."""
        event, one = " ", self.numbers.one
        while event:
            phase, count, event, bracket, cone = self.next_line("a phase", "phase", "steps", "event", "bracket", "cone")
            require(phase == self.phase, f"the phase {phase!a:.50} is not the one that follows")
            require(type(count) is int and count >= 1, "a phase has no step")
            system = self.scene.system(self.phase)
            self.box = system.entered(self.box, self.numbers)
            if event == "":
                require(bracket == [], "a bracket of no event")
                step = self.steps(system, count, "", one, one)
                self.clock = step.time(one, one)
                if cone != []:
                    if not (isinstance(self.scene, Scene) and isinstance(system, System)):
                        reject("no cone for a mechanism")
                    self.growth = contact_for_ever(self.scene, system, step.states(one, one), self.numbers, cone)
                continue
            require(isinstance(event, str) and event in system.endings and cone == [], "no event that ends this phase")
            require(isinstance(bracket, list) and len(bracket) == 2, "the bracket of an event")
            left, right = map(self.numbers.read, bracket)
            require(0 < left < right <= one, "the bracket of an event")
            step = self.steps(system, count, event, left, right)
            require(step.value(system.events[event], right, right)[1] < 0, f"{event}: no change of sign")
            require(step.slope(system.events[event], left, right)[1] < 0, f"{event}: it may touch 0 and rise again")
            self.clock = step.time(left, right)
            self.enter_next(system, event, step.states(left, right))

    def steps(self, system: AnySystem, count: int, event: str, left: int, right: int) -> Step:
        """The last step of a phase. In all steps up to ``right`` of the last all functions are > 0, but for that of the
        event from ``left`` on."""
        before, start, clock, one = None, self.box, self.clock, self.numbers.one
        for index in range(count):
            h, unit, x, pieces = self.next_line("a step", "h", "unit", "x", "pieces")
            curve = Curve(self.numbers, system, h, unit, x)
            jump = [add(start[name], (-curve.start[name][0], -curve.start[name][0])) for name in system.names]
            step = Step(curve, system, pieces, before, jump, clock)
            for name, watched in system.events.items():
                until = one if index < count - 1 else left if name == event else right
                since = risen(step, watched, until, self.order) if index == 0 and name == self.at_zero else 0
                require(positive(step, watched, since, until), f"{name} in {self.phase} is not excluded")
            before, start, clock = step.errors, curve.end, step.time(one, one)
        return step

    def enter_next(self, system: AnySystem, event: str, states: Box) -> None:
        """The phase after an event, from all states in its bracket; a state whose rate is 0 has kept its value."""
        self.found.append((event, self.clock))
        self.box |= {name: side for name, side in states.items() if system.rates[name]} | {"T": self.clock}
        self.phase, self.at_zero, self.order = self.scene.after(event, self.box, self.numbers)

    def statement(self, events: Any, end: Any) -> str:
        """The statement of the file, where it is that of the run."""
        require(isinstance(events, list) and len(events) == len(self.found), "the events are not those of the run")
        unit, words = self.scene.epsilon / self.numbers.one, []
        for claim, (name, at) in zip(events, self.found, strict=True):
            require(isinstance(claim, list) and len(claim) == 3 and claim[0] == name, "an event is not that of the run")
            low, high = rational(claim[1]), rational(claim[2])
            require(low <= at[0] * unit and at[1] * unit <= high, f"{name} is not in the bracket of the statement")
            require(high <= self.scene.until, f"{name} may come after the end of the time")
            words.append(f"{name} at t in [{decimal(low)}, {decimal(high)}]")
        changes = f"just these changes of phase: {', '.join(words)}" if words else "no change of phase"
        if self.growth is None:
            require(end == "time" and self.clock[0] * unit >= self.scene.until, "the end of the time is not reached")
            last = f"until t = {self.scene.until}"
        else:
            require(end == "for ever", "the end is not that of the run")
            last = f"for ever, with λ_N > 0 that grows at least like exp({self.growth} t/ε) in the end"
        return "; ".join([f"{self.scene.words()}: {changes}, {last}", *self.scene.seen()])


def decimal(q: Fraction) -> str:
    """A rational as a decimal where it is a short one."""
    places = next((n for n in range(LENGTH) if (q * 10**n).denominator == 1), None)
    if places in (None, 0):
        return str(q)
    whole, rest = divmod(abs(q.numerator) * 10**places // q.denominator, 10**places)
    return f"{'-' * (q < 0)}{whole}.{rest:0{places}}"


def check_run(hypotheses: Any, statement: Any, lines: Sequence[bytes], limits: Limits, length: int) -> str:
    """The statement that a certificate of so many bytes proves; ``lines``: those after the first."""
    require(hypotheses == HYPOTHESES, "the pages are not those of a run")
    kind = statement.get("kind") if isinstance(statement, dict) else None
    require(kind in ("run", "run of a mechanism"), "unknown kind of statement")
    names = ("effects", "epsilon", "until", "parameters", "start", "events", "end", "kind")
    *scene, events, end, _ = entries(statement, "the statement", *["mechanism"] * (kind != "run"), *names)
    rest = iter(lines)
    (bits,) = entries(read_line(next(rest, b"null")), "the line after the first", "bits")
    require(type(bits) is int and bits in BITS, "the number of bits")
    meter = Meter(limits, limits.work * WORK + WORK_PER_BYTE * length)
    run = Run(Scene(*scene) if kind == "run" else MechanismScene(*scene, meter), Numbers(bits, meter), rest)
    run.follow()
    require(next(rest, None) is None, "lines are left")
    return run.statement(events, end)
