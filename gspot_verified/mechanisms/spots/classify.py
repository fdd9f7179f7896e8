"""What a G-spot is: α_1*, α_2*, α_3*, β, the mean force, Case I, II or III, and which side lifts off.

Paper, Sec. 1.2 (the three cases) and Sec. 4.5 (the side). Exact at rational points, certain comparisons of balls
elsewhere: what the balls leave open is said to be undecided.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, ClassVar

from flint import fmpq

from gspot_verified.expansion.series.regularisation import NO_DAMPER, PAPER, Regularisation
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS, GSpot, find_g_spot
from gspot_verified.numbers.balls import Exact, ball_text, sign_of, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.signs.gamma.side import MAX_BETA, follows_text, gamma_sign, side_text

GIVEN_CONDITIONS = "with the given conditions J = 0"
_CASES = {"I": "alpha_2 < 0, alpha_1 < alpha_3 < 0", "II": "alpha_2 > 0, alpha_1 < alpha_3 < 0"}
_NOT_THREE = "trajectories do not approach in the three ways: "
_CASES["III"] = "alpha_2 < 0, alpha_3 < alpha_1 < 0"


def _text(value: Exact) -> str:
    return str(value) if isinstance(value, fmpq) else ball_text(value)


Shown = Annotated[Exact, _text]
"""A number that is written for people."""


@dataclass(frozen=True, slots=True)
class Classification(NoTruthValue, Written):
    """The result of :func:`classify`.

    ``case`` is "I", "II", "III", "none", or None when the balls leave it open; ``reason`` says why. ``beta``,
    ``mean_force`` are None where they do not exist (or may not). ``lift_off_sign`` is the sign of C_1 that lifts off,
    None except in Case III; ``impact_sign`` the one that takes an impact without collision, None in no Case.
    Both are None where the contact has no damper.
    ``integer_beta`` is the integer (up to 10^6) that beta is or may be, at whose order 2 (beta - 1) of delta there is
    no unique expansion. ``slip_velocity`` is u at the G-spot; ``a``, ``A``, ``B``, ``C`` and ``p`` = C - mu B (it is 0,
    or a ball around 0) are those of Sec. 1.1. ``notes`` say how the mechanism was read: negative slip is mirrored.
    ``number`` is that of the G-spot in the list of all, which ``spot`` takes everywhere; None where no list was made,
    or one of a box. ``short_point`` is the point with six digits. In a box that is not exact the G-spot is the only one
    with the components of ``fixed``, or where ``given_conditions`` with the conditions J that the mechanism gives.
    """

    ask: ClassVar[str] = '.case is "I", "II", "III", "none", or None (undecided)'
    written: ClassVar[str] = (
        "name point exact alpha_1 alpha_2 alpha_3 beta mean_force slip_velocity a A B C p case reason "
        "lift_off_sign_of_C1=lift_off_sign impact_sign_of_C1=impact_sign warnings integer_beta obstructed_order "
        "fixed given_conditions notes number"
    )

    name: str
    point: tuple[tuple[str, str], ...]
    exact: bool
    alpha_1: Shown
    alpha_2: Shown
    alpha_3: Shown
    beta: Shown | None
    mean_force: Shown | None
    case: str | None
    reason: str
    lift_off_sign: int | None
    impact_sign: int | None
    integer_beta: int | None
    slip_velocity: Shown
    a: Shown
    A: Shown
    B: Shown
    C: Shown
    p: Shown
    fixed: tuple[str, ...] = ()
    given_conditions: bool = False
    notes: tuple[str, ...] = ()
    regularisation: Regularisation = PAPER
    number: int | None = field(default=None, compare=False)
    short_point: tuple[tuple[str, str], ...] = field(default=(), compare=False, repr=False)

    @property
    def what_happens(self) -> str:
        """What the paper says of slip at this G-spot as ε → 0, in one phrase: impact, lift-off or impact, or nothing.

        >>> from gspot_verified import load
        >>> classify(load("falling rod")).what_happens
        'impact without collision'
        """
        if self.case is None:
            return f"undecided: {self.reason}"
        if self.case == "none":
            return f"no Case: {self.reason.removeprefix(_NOT_THREE)}"
        if self.impact_sign is None:
            why = "is not evaluated" if self.integer_beta is None else f"is, or may be, the integer {self.integer_beta}"
            return f"the side is open: {f'β {why}' if self.regularisation.c else NO_DAMPER}"
        return follows_text(self.lift_off_sign, self.impact_sign)

    @property
    def obstructed_order(self) -> int | None:
        """The order of delta at which an integer beta stops the expansion (beta = 1, 2, ...)."""
        return 2 * (self.integer_beta - 1) if self.integer_beta else None

    @property
    def warnings(self) -> tuple[str, ...]:
        """What makes a motion through this G-spot impossible, or not certainly possible, as the paper means it."""
        texts = []
        if self.mean_force is not None and sign_of_exact(self.mean_force) in (-1, None):
            may = "is" if sign_of_exact(self.mean_force) == -1 else "may be"
            texts.append(
                f"the mean force {may} tensile (negative): the distinguished trajectory would have to pull on the "
                "surface, no contact does that"
            )
        slip = sign_of_exact(self.slip_velocity)
        if slip != 1:
            velocity = {-1: "u < 0", 0: "u = 0", None: "u is not certainly positive"}[slip]
            texts.append(
                f"{velocity} at the G-spot: no positive slip on a surface at rest; "
                "the paper's theory applies only on a surface that moves with a velocity below u"
            )
        return tuple(texts)

    def __str__(self) -> str:
        case = "undecided" if self.case is None else f"Case {self.case}" if self.case != "none" else "no Case"
        lines = [
            f"{self.name}: {case} ({self.reason})",
            f"  {'exact point' if self.exact else 'proved box'}: " + ", ".join(f"{k} = {v}" for k, v in self.point),
            f"  alpha_1 = {_text(self.alpha_1)}, alpha_2 = {_text(self.alpha_2)}, alpha_3 = {_text(self.alpha_3)}",
        ]
        if self.beta is not None:
            lines.append(f"  beta = alpha_3/alpha_1 = {_text(self.beta)}")
        if self.mean_force is not None:
            lines.append(f"  mean force alpha_2/(alpha_3 - alpha_1) = {_text(self.mean_force)}")
        lines.append(f"  slip velocity u = {_text(self.slip_velocity)}")
        contact = (("a", self.a), ("A", self.A), ("B", self.B), ("C", self.C), ("p = C - mu B", self.p))
        lines.append("  " + ", ".join(f"{name} = {_text(value)}" for name, value in contact))
        if self.impact_sign is not None:
            lines.append(f"  {side_text(self.lift_off_sign, self.impact_sign)}")
        elif self.case in _CASES and not self.regularisation.c:
            lines.append(f"  no side: {NO_DAMPER}")
        if self.integer_beta:
            lines.append(
                f"  beta is, or may be, the integer {self.integer_beta}: no unique expansion, obstructed at order "
                f"{self.obstructed_order} of delta"
            )
        if self.fixed:
            lines.append(f"  fixed components (conditions J): {', '.join(self.fixed)}")
        if self.given_conditions:
            lines.append(f"  {GIVEN_CONDITIONS}")
        lines += [f"  note: {note}" for note in self.notes]
        lines += [f"  warning: {warning}" for warning in self.warnings]
        return "\n".join(lines)


def classify(mechanism: Mechanism, bits: int = DEFAULT_BITS) -> Classification:
    """Find the mechanism's G-spot and say which of the three cases it is.

    :raises MechanismError: the mechanism is not complete, or its mass matrix is not positive definite.
    :raises GSpotError: not a G-spot, or a degenerate one.

    >>> from gspot_verified import load
    >>> print(classify(load("falling rod")))
    falling rod: Case II (alpha_2 > 0, alpha_1 < alpha_3 < 0)
      exact point: X = 0, Y = 3/5, theta = theta_ref, X_dot = 2, Y_dot = 4/5, theta_dot = 1
      alpha_1 = -55/12, alpha_2 = 4/5, alpha_3 = -3/2
      beta = alpha_3/alpha_1 = 18/55
      mean force alpha_2/(alpha_3 - alpha_1) = 48/185
      slip velocity u = 7/5
      a = -4/5, A = 52/25, B = 36/25, C = 73/25, p = C - mu B = 0
      Cases I and II, by the paper's rule as ε → 0: C1 < 0 takes an IWC, no other sign occurs
      fixed components (conditions J): X, X_dot
    """
    return classify_g_spot(find_g_spot(mechanism, bits))


def classify_g_spot(spot: GSpot) -> Classification:
    """The same for a G-spot that was found."""
    with working_bits(spot.bits + 40):
        system = spot.system
        f = spot.shifted.functions
        contact = spot.shifted.expressions([f.u, f.a, f.A, f.B, f.C], system.ring)
        alphas = (system.alpha_1, system.alpha_2, system.alpha_3)
        first, second, third, u, a, A, B, C, p = system.values_at_point((*alphas, *contact, system.p))
        case, reason = case_of(first, second, third)
        beta = third / first if sign_of_exact(first) in (1, -1) else None
        force = second / (third - first) if sign_of_exact(third - first) in (1, -1) else None
        approached = not {sign_of_exact(first), sign_of_exact(third)} & {0, 1}
        integer = _integer_in(beta) if approached else None
        lift_off, impact = sides_of(case, beta) if spot.mechanism.regularisation.c else (None, None)
        return Classification(
            name=system.name,
            point=tuple(spot.to_json().items()),
            exact=spot.exact,
            alpha_1=first,
            alpha_2=second,
            alpha_3=third,
            beta=beta,
            mean_force=force,
            case=case,
            reason=reason,
            lift_off_sign=lift_off,
            impact_sign=impact,
            integer_beta=integer,
            slip_velocity=u,
            a=a,
            A=A,
            B=B,
            C=C,
            p=p,
            fixed=spot.fixed,
            given_conditions=bool(spot.mechanism.place.conditions),
            notes=spot.mechanism.notes,
            regularisation=spot.mechanism.regularisation,
            short_point=tuple(spot.in_short().items()),
        )


def sign_of_exact(value: Exact) -> int | None:
    """1, 0, -1, or None when a ball leaves it open."""
    if isinstance(value, fmpq):
        return (value > 0) - (value < 0)
    return sign_of(value)


def case_of(first: Exact, second: Exact, third: Exact) -> tuple[str | None, str]:
    """The case that α_1*, α_2*, α_3* make, and why; paper, Sec. 1.2."""
    signs = [sign_of_exact(value) for value in (first, second, third, third - first)]
    for name, sign in zip(("alpha_1", "alpha_3"), (signs[0], signs[2]), strict=True):
        if sign in (0, 1):
            return "none", f"{_NOT_THREE}{name} is not negative"
    if signs[3] == 0:
        return "none", f"{_NOT_THREE}alpha_1 = alpha_3, beta = 1"
    if signs[1] == 0:
        return "none", "alpha_2 = 0: between the three ways"
    names = ("alpha_1", "alpha_2", "alpha_3", "alpha_3 - alpha_1")
    unsure = [name for name, sign in zip(names, signs, strict=True) if sign is None]
    if unsure:
        return None, f"the balls leave the sign of {', '.join(unsure)} open: give more bits or exact numbers"
    case = {(-1, 1): "I", (1, 1): "II", (-1, -1): "III"}.get((signs[1] or 0, signs[3] or 0))
    if case is None:
        return "none", f"{_NOT_THREE}alpha_2 > 0 and alpha_3 < alpha_1"
    return case, _CASES[case]


def case_text(case: str | None) -> str:
    """A case in words.

    >>> case_text("II"), case_text("none"), case_text(None)
    ('Case II', 'no Case', 'the Case is open')
    """
    return {None: "the Case is open", "none": "no Case"}.get(case, f"Case {case}")


def sides_of(case: str | None, beta: Exact | None) -> tuple[int | None, int | None]:
    """The signs of C_1 that lift off and that take an impact; None where the theory gives none (integer beta too)."""
    if case in ("I", "II"):
        return None, -1
    if case != "III" or beta is None or not beta <= MAX_BETA:
        return None, None
    sign = gamma_sign(beta)
    return (-sign, sign) if sign else (None, None)


def _integer_in(beta: Exact | None) -> int | None:
    """The integer in 1..10^6 that beta is or may be; above, the order that it obstructs is beyond every expansion."""
    if beta is None:
        return None
    if isinstance(beta, fmpq):
        return int(beta.p) if beta.q == 1 and 1 <= beta <= MAX_BETA else None
    if not abs(beta) <= MAX_BETA:
        return None
    near = beta.mid().floor().unique_fmpz()
    # The integers >= 1 next to the midpoint: if the ball holds any such integer, it holds one of these.
    candidates = [max(int(near) + k, 1) for k in (0, 1)] if near is not None else []
    return next((k for k in candidates if beta.overlaps(type(beta)(k))), None)
