"""Rigid slip of a mechanism as a polynomial field: of its states, sines and cosines, and 1/det M.

The producer's side of ``proofs/approach_certificate.md``, section 1. Nothing here is part of a proof: the checker
derives its own equations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.approach.slip_flow import Numbers
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import ball
from gspot_verified.scenes.certificates.polynomial_mechanism import (
    INVERSE,
    NotPolynomial,
    PolynomialMechanism,
    expression,
    number_of,
)

TIME = "t"


class PolynomialSlip:
    """X = p F - b G of the states ``names``, in alphabetical order, and p for the time, which comes last in ``field``.

    ``own``: the coordinates and velocities among them, all but those which y = v = 0 replace, in the statement's order.

    :raises NotPolynomial: no certificate covers the mechanism.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = m = PolynomialMechanism(mechanism)
        if taken := {"C_1", "b", "p"} & set(m.coordinates):
            raise NotPolynomial(f"certificates of approaches have another use for the name {min(taken)}")
        zero = m.number(0)
        dots = [m.of(f"{q}_dot") for q in m.coordinates]
        det = m.minors()[-1]
        w = m.number(1 / number_of(det)) if det.is_constant() else m.of(INVERSE)
        by_x, by_y = ([m.by(f, q) for q in m.coordinates] for f in (m.x, m.y))
        pressed = [y - m.mu * x for x, y in zip(by_x, by_y, strict=True)]
        free, pushed = ([w * _dot(row, force, zero) for row in m.cofactors()] for force in (m.forces, pressed))
        F, G = {INVERSE: -w * w * m.rate(det)}, dict[str, fmpq_mpoly]()
        for q, f, g in zip(m.coordinates, free, pushed, strict=True):
            F |= m.turns(q, fmpq(1)) | {f"{q}_dot": f}
            G[f"{q}_dot"] = g
        p = _dot(by_y, pushed, zero)
        b = _dot(by_y, free, zero) + _dot([m.rate(f) for f in by_y], dots, zero)
        u, slopes = _dot(by_x, dots, zero), [m.rate(p, F), m.rate(b, F), -m.rate(b, G)]
        solved = m.normal(fmpq(0))
        scalars = [m.put_in(each, solved) for each in (p, b, u, *slopes)]
        F, G = ({name: m.put_in(rate, solved) for name, rate in rates.items()} for rates in (F, G))
        places = [name for q in m.coordinates for name in (m.place[q], f"{q}_dot")]
        self.own = [name for name in places if name not in solved]
        self.replaced = " and ".join(name for name in places if name in solved)
        moving = [*scalars, *(rates[name] for rates in (F, G) for name in self.own if name in rates)]
        used = m.names_in([*moving, *(m.put_in(minor, solved) for minor in m.minors())])
        turning = {q: {f"sin({q})", f"cos({q})"} for q in m.coordinates}
        self._angles = [q for q, pair in turning.items() if used & pair]
        if any(m.place[q] in solved for q in self._angles):
            raise NotPolynomial("certificates of approaches do not cover a sine of the coordinate that y replaces")
        kept = {*self.own, *([] if det.is_constant() else [INVERSE])}.union(*(turning[q] for q in self._angles))
        self.names = tuple(sorted(kept))
        self._det = m.put_in(det, solved)
        index = {m.names.index(name): i for i, name in enumerate(self.names)}
        rows = [[rates.get(name, zero) for name in self.names] for rates in (F, G)]
        X = [scalars[0] * f - scalars[1] * g for f, g in zip(*rows, strict=True)]
        self.field = VectorField([expression(each, index) for each in (*X, scalars[0])])
        self._program = BoxProgram(
            [expression(each, index) for each in (*scalars, *rows[0], *rows[1])], len(self.names)
        )
        self._index = index
        limit = expression(scalars[4], index) / expression(scalars[5] - scalars[3], index)
        self._limit = BoxProgram([limit], len(self.names))

    def on(self, box: Sequence[arb]) -> Numbers:
        """p, b, u, the α's, F and G on a box of the states."""
        return Numbers.of(self._program.values(list(box[: len(self.names)])))

    def slope_of_limit(self, box: Sequence[arb], force: arb) -> arb:
        """The rate of α_2/(α_3 - α_1) by time, where the contact force is ``force``."""
        numbers, slopes = self.on(box), self._limit.gradients(list(box[: len(self.names)]))[1][0]
        moves = (f + force * g for f, g in zip(numbers.F, numbers.G, strict=True))
        return sum((slope * move for slope, move in zip(slopes, moves, strict=True)), arb(0))

    def start(self, own: Mapping[str, fmpq]) -> list[arb]:
        """All states where ``own`` are the coordinates and velocities, and the time 0."""
        m, values = self.mechanism, {name: ball(value) for name, value in own.items()}
        for q in self._angles:
            s, c = map(ball, m.references[q])
            angle = values[m.place[q]]
            values |= {
                f"sin({q})": angle.cos() * s + angle.sin() * c,
                f"cos({q})": angle.cos() * c - angle.sin() * s,
            }
        if INVERSE in self.names:
            values[INVERSE] = arb(1)
            det: Expression = expression(self._det, self._index)
            program = BoxProgram([det], len(self.names))
            values[INVERSE] = 1 / program.values([values[name] for name in self.names])[0]
        return [*(values[name] for name in self.names), arb(0)]


def _dot(left: Sequence[fmpq_mpoly], right: Sequence[fmpq_mpoly], zero: fmpq_mpoly) -> fmpq_mpoly:
    return sum((a * b for a, b in zip(left, right, strict=True)), zero)
