"""Check an approach: rigid slip of a mechanism from a state to a G-spot (approach_certificate.md).

The statement is in the first line: the formulas of a mechanism, as in mechanism.py, a state, the velocity of the
surface, and where and until when a G-spot is reached. The equations are derived here; the file has polynomials, bases
and bounds of the way, and a neighbourhood of its end that any producer may have chosen.

    Slip      p, b, the α's and the field X = pF - bG (section 1)
    Way       steps as in run.py, on which b < 0 and slip is positive (section 2)
    End       Theorem A5 on the neighbourhood, and Theorem A6: the sign of C_1 for 1 < β < 2 (section 3)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from intervals import Box, Interval, Numbers, add, size, up, wider
from limits import Limits, Meter, require
from mechanism import INVERSE, Mechanism, dot, names_of, paid, put_in
from model import Event, Polynomial, number, read_numbers, short, state
from reading import entries, read_line
from run import BITS, WORK, WORK_PER_BYTE, Curve, Errors, Step, decimal, positive

VERSION = 6
HYPOTHESES = ["approach", "approach_certificate", "run_certificate"]
TIME = "t"  # a state beside those of the mechanism

# ---------------------------------------------------------------------------------------------------------------------
# Slip: the flow with the G-spot as an equilibrium.
# ---------------------------------------------------------------------------------------------------------------------


def along(function: Polynomial, rates: Mapping[str, Polynomial], meter: Meter) -> Polynomial:
    """The derivative along a field, which is 0 where it has no entry."""
    found = Polynomial()
    for name in sorted(names_of([function]) & set(rates)):
        found += paid(function.by(name), rates[name], meter)
    return found


class Slip:
    """Rigid slip on the contact as a field X = pF - bG of the states ``names``; without the normal coordinate, which
    y = v = 0 replaces. ``F`` and ``G``: by the states, where they are not 0.
    """

    def __init__(self, mechanism: Mechanism, surface: Fraction | None, meter: Meter) -> None:
        self.mechanism = m = mechanism
        require(not {"C_1", "b", "p"} & set(m.coordinates), "a coordinate has a name of something else")
        dots, det = [state(f"{q}_dot") for q in m.coordinates], m.minors[-1]
        self.inverse = bool(names_of([det]))
        require(self.inverse or det, "det M is 0")
        w = state(INVERSE) if self.inverse else number(1 / det[()])
        by_x, by_y = ([m.by(f, q) for q in m.coordinates] for f in (m.x, m.y))
        pressed = [y - number(m.mu) * x for x, y in zip(by_x, by_y, strict=True)]  # by λ_N, with λ_T = -μ λ_N
        free = [w * dot(row, m.forces) for row in m.cofactors]
        pushed = [w * dot(row, pressed) for row in m.cofactors]
        F, G = {INVERSE: -w * w * m.rate(det)}, {}
        for q, dot_q, f, g in zip(m.coordinates, dots, free, pushed, strict=True):
            sine, cosine = f"sin({q})", f"cos({q})"
            F |= {m.place[q]: dot_q, f"{q}_dot": f, sine: dot_q * state(cosine), cosine: -dot_q * state(sine)}
            G |= {f"{q}_dot": g}
        p, b = dot(by_y, pushed), dot(by_y, free) + dot([m.rate(f) for f in by_y], dots)
        functions = {"p": p, "b": b, "u": dot(by_x, dots)}
        functions |= {"α_1": along(p, F, meter), "α_2": along(b, F, meter), "α_3": -along(b, G, meter)}
        self.solved = m.normal(Polynomial())  # at y = v = 0
        self.of = {name: put_in(function, self.solved, meter) for name, function in functions.items()}
        self.minors = [put_in(minor, self.solved, meter) for minor in m.minors]
        F, G = ({name: put_in(rate, self.solved, meter) for name, rate in rates.items()} for rates in (F, G))
        self.own = [name for q in m.coordinates for name in (m.place[q], f"{q}_dot") if name not in self.solved]
        moving = [rates[name] for rates in (F, G) for name in self.own if name in rates]
        used = names_of([*self.of.values(), *self.minors, *moving])
        pairs = {q: {f"sin({q})", f"cos({q})"} for q in m.coordinates}
        self.angles = [q for q, pair in pairs.items() if used & pair]
        require(not {m.place[q] for q in self.angles} & set(self.solved), "a sine of the coordinate that y replaces")
        self.states = sorted({*self.own, *[INVERSE] * self.inverse}.union(*(pairs[q] for q in self.angles)))
        self.F, self.G = ({name: rates[name] for name in self.states if rates.get(name)} for rates in (F, G))
        p, b, nothing = self.of["p"], self.of["b"], Polynomial()
        self.rates = {
            name: paid(p, self.F.get(name, nothing), meter) - paid(b, self.G.get(name, nothing), meter)
            for name in self.states
        }
        self.rates[TIME] = p  # dt = p ds
        self.names = sorted(self.rates)
        self.jacobian = [[self.rates[i].by(j) for j in self.names] for i in self.names]
        watched = {"b ≥ 0": -b} | ({} if surface is None else {"slip that ends": self.of["u"] - number(surface)})
        self.slope = None if surface is None else watched["slip that ends"]
        self.events = {name: Event(function, self.rates) for name, function in watched.items()}

    def first_box(self, start: Mapping[str, Fraction], numbers: Numbers) -> Box:
        """All states at the start, where M is positive definite (run_certificate.md, Lemma 2)."""
        box = {name: numbers.interval(value) for name, value in start.items()} | {TIME: (0, 0)}
        for q in self.angles:
            box |= self.mechanism.circle(q, start[self.mechanism.place[q]], numbers)
        for minor in self.minors:
            require(minor.on(box, numbers)[0] > 0, "M is not certainly positive definite at the start")
        if self.inverse:
            box[INVERSE] = numbers.reciprocal(self.minors[-1].on(box, numbers))
        require(self.of["p"].on(box, numbers)[0] > 0, "p is not certainly positive at the start")
        return box


# ---------------------------------------------------------------------------------------------------------------------
# Way: steps on which b < 0 and slip is positive.
# ---------------------------------------------------------------------------------------------------------------------


def follow(slip: Slip, box: Box, numbers: Numbers, lines: Sequence[bytes]) -> Box:
    """The states at the end of all steps."""
    before: Errors | None = None
    start, one = box, numbers.one
    for line in lines:
        h, unit, x, pieces = entries(read_line(line), "a step", "h", "unit", "x", "pieces")
        curve = Curve(numbers, slip, h, unit, x)
        jump = [add(start[name], (-curve.start[name][0], -curve.start[name][0])) for name in slip.names]
        step = Step(curve, slip, pieces, before, jump, (0, 0))
        for name, event in slip.events.items():
            require(positive(step, event, 0, one), f"{name} is not excluded")
        before, start, box = step.errors, curve.end, step.states(one, one)
    return box


# ---------------------------------------------------------------------------------------------------------------------
# End: a neighbourhood from which a G-spot is reached.
# ---------------------------------------------------------------------------------------------------------------------


class Reached(NamedTuple):
    """States at the G-spot, a bound of the time that is left, and the certain sign of C_1 (Theorem A5), 0 if there is
    none."""

    place: Box
    time: int
    sign: int


def read_neighbourhood(value: Any, slip: Slip, numbers: Numbers) -> Box:
    """A box of all states but the time."""
    box = {}
    for name, pair in zip(slip.states, entries(value, "the neighbourhood", *slip.states), strict=True):
        require(isinstance(pair, list) and len(pair) == 2, f"{name}: a side of the neighbourhood is not a pair")
        box[name] = numbers.read(pair[0]), numbers.read(pair[1])
    return box


def captured(slip: Slip, at: Box, box: Box, numbers: Numbers) -> Reached:
    """Theorem A5 from all states ``at`` with p > 0, in the neighbourhood ``box``."""
    one, nothing = numbers.one, Polynomial()
    first, second, third = (slip.of[f"α_{k}"].on(box, numbers) for k in (1, 2, 3))
    require(first[1] < 0 and third[1] < 0, "α_1 and α_3 are not certainly negative in the neighbourhood")
    p, b = slip.of["p"].on(at, numbers)[1], slip.of["b"].on(at, numbers)
    require(p > 0 and b[1] < 0, "b is not certainly negative at the end of the way")
    time = up(p * one, -first[1])  # P
    integral = up(size(b) * one + size(second) * time, -third[1])  # B
    place = {}
    for name in slip.states:
        f, g = (size(rates.get(name, nothing).on(box, numbers)) for rates in (slip.F, slip.G))
        place[name] = wider(at[name], up(f * time + g * integral, one))
        inside = box[name][0] < place[name][0] and place[name][1] < box[name][1]
        require(inside, f"{name} may leave the neighbourhood")
    force, rate = -b[1] * one // p, (slip.of["α_3"] - slip.of["α_1"]).on(box, numbers)[0]
    grows = rate * force > max(second[1], 0) * one  # only where rate > 0
    require(second[1] < 0 or grows, "λ_N > 0 is not certain in the neighbourhood")
    if slip.slope is not None:
        require(slip.slope.on(box, numbers)[0] > 0, "slip is not certainly positive in the neighbourhood")
    return Reached(place, time, -1 if grows else 0)


def quotient(a: Interval, d: Interval, numbers: Numbers) -> Interval:
    """a/d, d < 0."""
    return numbers.mul(negative(a), numbers.reciprocal(negative(d)))


def side(slip: Slip, at: Box, box: Box, numbers: Numbers) -> int:
    """The certain sign of C_1 where 1 < β < 2 in the neighbourhood ``box`` of the states ``at`` (Theorem A6); or 0."""
    mul, meter = numbers.mul, numbers.meter
    a, d = slip.of["α_2"], slip.of["α_3"] - slip.of["α_1"]
    fall, rate = d.on(box, numbers), (d - slip.of["α_1"]).on(box, numbers)[0]
    p = slip.of["p"].on(at, numbers)
    if fall[1] >= 0 or rate <= 0 or p[0] <= 0:
        return 0
    force = mul(negative(slip.of["b"].on(at, numbers)), numbers.reciprocal(p))
    limit = quotient(a.on(box, numbers), fall, numbers)  # ℓ
    forces = min(force[0], limit[0]), max(force[1], limit[1])  # Λ
    rates = []  # of α_2 and α_3 - α_1 by t, with λ in Λ
    for function in (a, d):
        free, pushed = (along(function, field, meter).on(box, numbers) for field in (slip.F, slip.G))
        rates.append(add(free, mul(forces, pushed)))
    bent = add(rates[0], negative(mul(limit, rates[1])))
    slope = size(quotient(bent, fall, numbers))  # m, as ℓ' = (α_2' - ℓ d')/d
    excess = add(force, negative(quotient(a.on(at, numbers), d.on(at, numbers), numbers)))
    for sign, least in ((-1, excess[0]), (1, -excess[1])):
        if least * rate > slope * p[1]:
            return sign
    return 0


# ---------------------------------------------------------------------------------------------------------------------
# The statement.
# ---------------------------------------------------------------------------------------------------------------------


def read_range(value: Any) -> tuple[Fraction, Fraction]:
    """The ends of a range."""
    require(isinstance(value, list) and len(value) == 2, f"{value!a:.50} is not a pair of numbers")
    return short(value[0]), short(value[1])


def holds(claim: Any, found: Interval, numbers: Numbers, name: str) -> str:
    """In words that a number lies in the range that is claimed."""
    low, high = read_range(claim)
    within = low * numbers.one <= found[0] and found[1] <= high * numbers.one
    require(within, f"{name} may lie outside of the range of the statement")
    return f"{name} in [{decimal(low)}, {decimal(high)}]"


def check_approach(hypotheses: Any, statement: Any, lines: Sequence[bytes], limits: Limits, length: int) -> str:
    """The statement that a certificate of so many bytes proves; ``lines``: those after the first."""
    require(hypotheses == HYPOTHESES, "the pages are not those of an approach")
    names = ("C_1", "alpha", "beta", "kind", "mechanism", "place", "start", "surface", "time")
    claimed, alpha, beta, kind, mechanism, place, start, surface, time = entries(statement, "the statement", *names)
    require(kind == "approach", "unknown kind of statement")
    require(isinstance(claimed, list), "the sign of C_1")
    require(isinstance(surface, list) and len(surface) <= 1, "the surface is not [] or [velocity]")
    require(isinstance(alpha, list) and len(alpha) == 3, "there are not three ranges of α")
    require(len(lines) >= 2, "there are not two lines after the first")
    (bits,) = entries(read_line(lines[0]), "the line after the first", "bits")
    require(type(bits) is int and bits in BITS, "the number of bits")
    numbers = Numbers(bits, Meter(limits, limits.work * WORK + WORK_PER_BYTE * length))
    slip = Slip(Mechanism(mechanism), *([short(v) for v in surface] or [None]), numbers.meter)
    exact = read_numbers(start, "the start", *slip.own)
    at = follow(slip, slip.first_box(exact, numbers), numbers, lines[1:-1])
    (box,) = entries(read_line(lines[-1]), "the last line", "neighbourhood")
    neighbourhood = read_neighbourhood(box, slip, numbers)
    end = captured(slip, at, neighbourhood, numbers)
    require(short(time) * numbers.one >= at[TIME][1] + end.time, "the G-spot may be reached after the time")
    where = entries(place, "the place", *slip.own)
    said = [holds(claim, end.place[name], numbers, name) for name, claim in zip(slip.own, where, strict=True)]
    found = {name: slip.of[name].on(end.place, numbers) for name in ("α_1", "α_2", "α_3")}
    ratio = quotient(found["α_3"], found["α_1"], numbers)
    signs = [holds(claim, value, numbers, name) for claim, (name, value) in zip(alpha, found.items(), strict=True)]
    signs.append(holds(beta, ratio, numbers, "β = α_3/α_1"))
    if claimed:
        require(claimed in (["negative"], ["positive"]), "the sign of C_1")
        sign = end.sign or side(slip, at, neighbourhood, numbers)
        require(sign == (-1 if claimed == ["negative"] else 1), "the sign of C_1 is not certain")
        signs.append("C_1 < 0" if sign < 0 else "C_1 > 0")
    began = ", ".join(f"{name} = {value}" for name, value in exact.items())
    slides = f"x' > {surface[0]}" if surface else "provided that slip is positive until then, which is not shown"
    return (
        f"{slip.mechanism.words()}, in positive slip, λ_T = -μ λ_N, on the rigid contact y = 0 from {began}, t = 0: "
        f"with p = dy/dq M^-1 (dy/dq - μ dx/dq) and b = y'' at λ_N = 0 it reaches a G-spot, p = b = 0, at a time "
        f"t <= {decimal(short(time))}, λ_N > 0 until then, {slides}; "
        f"there {', '.join(said + signs)}"
    )


def negative(a: Interval) -> Interval:
    """-a."""
    return -a[1], -a[0]
