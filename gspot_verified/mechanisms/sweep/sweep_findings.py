"""What a tube says of the G-spots in it: α_1*, α_2*, α_3*, β, the Case and the side, for every parameter value.

Proof page: ``proofs/sweep.md``, sections 3 and 4. Paper, Sec. 1.2 and Sec. 4.5.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram, common
from gspot_verified.mechanisms.derive.mass_matrix import positive_definite
from gspot_verified.mechanisms.spots.parametric_system import ParametricSystem
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece, TubeRecord, interval
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Quantity
from gspot_verified.numbers.balls import nonfinite, sign_of
from gspot_verified.numbers.evidence import at_most
from gspot_verified.numbers.packed import PackedIntervals
from gspot_verified.signs.gamma.side import MAX_BETA, gamma_sign

DIFFERENCE = "alpha_3 - alpha_1"
HYPOTHESES = ("the mass matrix is positive definite", "mu >= 0", "all formulas have values")
TOO_LARGE = "beta <= 10^6"
SEVERAL = "beta - n for several n"

_SEVERAL = 2  # a piece with more than three integers beta is halved: any number is correct
_CASES = {(-1, 1): "I", (1, 1): "II", (-1, -1): "III"}


@dataclass(frozen=True, slots=True)
class Findings:
    """Enclosures on a tube and what follows. ``unsure`` is empty when Case, side and hypotheses are settled."""

    numbers: Mapping[str, arb]
    case: str | None
    lift_off_sign: int | None
    impact_sign: int | None
    unsure: tuple[str, ...]

    def shown(self) -> PackedIntervals:
        """The enclosures of ``sweep_piece.NUMBERS``."""
        difference = self.numbers[DIFFERENCE]
        force = self.numbers["alpha_2"] / difference if sign_of(difference) in (1, -1) else None
        beta = self.numbers["beta"] if sign_of(self.numbers["alpha_1"]) in (1, -1) else None
        shown = [self.numbers[name] for name in ("alpha_1", "alpha_2", "alpha_3")]
        return PackedIntervals(map(interval, (*shown, beta, force, self.numbers["slip_velocity"])))

    def piece(self, on: OnTube, kind: Kind) -> SweepPiece:
        """The piece of a sweep; Case and side only where it is settled."""
        settled = (self.case, self.lift_off_sign, self.impact_sign) if kind is Kind.SETTLED else (None, None, None)
        tube = on.tube
        return SweepPiece(
            tube.lower, tube.upper, kind, *settled, unsure=self.unsure, numbers=self.shown(), record=TubeRecord.of(tube)
        )


def equations(system: ParametricSystem) -> Equations:
    """The conditions and, as further functions, what :func:`findings` looks at."""
    functions = [
        *system.conditions, system.alpha_1, system.alpha_2, system.alpha_3, system.slip, system.friction, system.domain,
        *(entry for row in system.matrix for entry in row),
    ]  # fmt: skip
    return Equations(BoxProgram(functions, system.dimension + len(system.parameters)), system.dimension)


def quantity(on: OnTube, name: str) -> Quantity:
    """One of "alpha_1", "alpha_2", "alpha_3", "alpha_3 - alpha_1", "beta", "beta - n" next to the tube."""
    first, second, third = on.quantities[:3]
    if name.startswith("beta"):
        beta = third / first
        shift = int(name.partition(" - ")[2] or 0)
        return Quantity(beta.at_centre - shift, beta.over_tube - shift, beta.along, beta.by_state)
    return third - first if name == DIFFERENCE else {"alpha_1": first, "alpha_2": second, "alpha_3": third}[name]


def findings(on: OnTube, known: Mapping[str, int], *, damped: bool) -> Findings:
    """What the tube says; ``known`` holds signs of some boundaries (quantities, "beta - n") that hold on it. Where the
    contact is not ``damped`` no side is named."""
    first, second, third = on.quantities[:3]
    own = {"alpha_1": first, "alpha_2": second, "alpha_3": third, DIFFERENCE: third - first}
    numbers = {name: on.value(value) for name, value in own.items()}
    signs = {name: known.get(name, sign_of(value)) for name, value in numbers.items()}
    numbers["slip_velocity"] = on.value(on.quantities[3])
    numbers["beta"] = _beta(on, numbers)
    doubts = _doubts(on)
    case, unsure = case_of_signs(signs)
    lift_off = impact = None
    if case in ("I", "II") and damped:
        impact = -1
    elif case == "III" and damped:
        lift_off, impact, unsure = _side(numbers["beta"], known)
    return Findings(numbers, case, lift_off, impact, (*doubts, *unsure))


def case_of_signs(signs: Mapping[str, int | None]) -> tuple[str | None, tuple[str, ...]]:
    """The Case ("none" where it is certainly none of the three), or None and the names whose signs are needed.

    >>> case_of_signs({"alpha_1": -1, "alpha_2": 1, "alpha_3": -1, "alpha_3 - alpha_1": 1})
    ('II', ())
    """
    if signs["alpha_1"] in (0, 1) or signs["alpha_3"] in (0, 1) or 0 in (signs["alpha_2"], signs[DIFFERENCE]):
        return "none", ()
    if signs["alpha_2"] == 1 and signs[DIFFERENCE] == -1:
        return "none", ()
    unsure = tuple(name for name, sign in signs.items() if sign is None)
    if unsure:
        return None, unsure
    return _CASES[signs["alpha_2"] or 0, signs[DIFFERENCE] or 0], ()


def _beta(on: OnTube, numbers: Mapping[str, arb]) -> arb:
    if sign_of(numbers["alpha_1"]) not in (1, -1):
        return nonfinite()
    beta = common(numbers["alpha_3"] / numbers["alpha_1"], 1 + numbers[DIFFERENCE] / numbers["alpha_1"])
    own = on.value(quantity(on, "beta"))
    return common(beta, own) if own.is_finite() else beta


def _doubts(on: OnTube) -> tuple[str, ...]:
    """The hypotheses that are not certain on the whole tube."""
    friction, domain, *entries = on.quantities[4:]
    definite, pushes = positive_definite([on.value(entry) for entry in entries]), at_most(0, on.value(friction))
    shown = definite is not None, pushes is not None, on.value(domain).is_finite()
    return tuple(name for name, holds in zip(HYPOTHESES, shown, strict=True) if not holds)


def _side(beta: arb, known: Mapping[str, int]) -> tuple[int | None, int | None, tuple[str, ...]]:
    """The signs of C_1 that lift off and that take an impact, in Case III, where beta > 1 holds by the signs."""
    if not beta < MAX_BETA:
        return None, None, (TOO_LARGE,)
    low, high = _integer(beta.lower().ceil()), _integer(beta.upper().floor())
    low = max(low, 2)
    if high > low + _SEVERAL:
        return None, None, (SEVERAL,)
    boundaries = {n: f"beta - {n}" for n in range(low, high + 1)}
    unsure = tuple(boundary for boundary in boundaries.values() if boundary not in known)
    if unsure:
        return None, None, unsure
    # beta lies in (n, n + 1), n being the largest integer below it.
    below = [n for n, boundary in boundaries.items() if known[boundary] > 0]
    n = max([1, low - 1, *below])
    sign = gamma_sign(fmpq(2 * n + 1, 2))
    assert sign
    return -sign, sign, ()


def _integer(value: arb) -> int:
    integer = value.unique_fmpz()
    assert integer is not None
    return int(integer)
