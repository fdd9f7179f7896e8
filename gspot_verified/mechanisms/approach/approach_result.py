"""What :func:`approach.approach` answers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar

from flint import arb

from gspot_verified.mechanisms.derive.component_names import component
from gspot_verified.mechanisms.spots.classify import case_text
from gspot_verified.numbers.balls import ShownBall, ball_text, float_bounds, rounded_text
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Verdict
from gspot_verified.numbers.written import Written

LIFT_OFF, IMPACT = "lift-off", "impact without collision"
SLIP_STOPS = "slip stops"
STOPS_BEFORE = "slip stops before any G-spot (then stick, or slip the other way)"
EVENTS = {
    LIFT_OFF: "lift-off before any G-spot: the contact force -b/p falls to 0 while p > 0",
    SLIP_STOPS: f"{STOPS_BEFORE}: u falls to the surface's velocity while p > 0",
}
_SIDE_RESTS_ON = (
    "; the side is the paper's statement at leading order as epsilon -> 0 (Sec. 4.5), not a theorem at a finite epsilon"
)


def _rough(value: arb) -> str:
    return ball_text(value, 10)


RoughBall = Annotated[arb, _rough]


@dataclass(frozen=True, slots=True)
class SlipPath(Written):
    """Enclosures at some times of the path, in order: the time t, the state (angles from their references) and
    p, b, u, λ_N = -b/p there."""

    written: ClassVar[str] = "time p b u force"

    time: tuple[RoughBall, ...]
    states: tuple[tuple[arb, ...], ...]
    p: tuple[RoughBall, ...]
    b: tuple[RoughBall, ...]
    u: tuple[RoughBall, ...]
    force: tuple[RoughBall, ...]


@dataclass(frozen=True, slots=True)
class Approach(NoTruthValue, Written):
    """Where positive slip from a state leads.

    ``end`` is "G-spot", "lift-off" or "slip stops", what is proved to come first; None when it is undecided. ``place``
    is the G-spot, or the state at the event; ``time`` the time until then. At a G-spot ``case`` ("none": in no Case,
    None: the balls leave it open), ``alphas``, ``beta`` and ``coefficient`` (C_1) are what they are there; ``side`` is
    "lift-off", "impact without collision", or None where it is undecided or the theory says none, and ``side_reason``
    says why. ``least_slip`` bounds u on the path from below; ``notes`` say how the mechanism was read. ``supposed``
    names what is 0 on the contact and was not shown to be exactly 0 in the state that was given: the statement is then
    about the state on the contact. ``fast_exponent``: E, where about e^(-E/epsilon) of the contact's fast oscillation
    at the start is left at the G-spot; a float, no bound; None where the contact has no damper.
    ``spot`` encloses the G-spot as numbers, angles counted from their references; empty where there is none.
    ``surface`` is the velocity of the surface, 0 where none was given; None where nothing is asked of u. What was
    proved holds for each velocity in a ball; ``surface_velocity`` is then an interval in it. ``other_names``: of the
    components whose names statements use for something else.
    """

    written: ClassVar[str] = (
        "name start solved verdict end time place case alphas beta C1=coefficient side side_reason rests_on "
        "surface_velocity least_slip fast_exponent notes warnings bits path"
    )

    name: str
    start: tuple[tuple[str, str], ...]
    solved: tuple[str, ...]
    verdict: Verdict
    end: str | None
    time: ShownBall | None
    place: tuple[tuple[str, str], ...]
    case: str | None
    alphas: tuple[ShownBall, ShownBall, ShownBall] | None
    beta: ShownBall | None
    coefficient: ShownBall | None
    side: str | None
    side_reason: str
    least_slip: ShownBall | None
    surface_velocity: str | None
    notes: tuple[str, ...]
    path: SlipPath
    bits: int
    supposed: tuple[str, ...] = ()
    fast_exponent: float | None = None
    spot: tuple[arb, ...] = ()
    surface: arb | None = None
    other_names: frozenset[str] = frozenset()

    @property
    def on_surface(self) -> str:
        """In words which surface that moves; empty where it does not, or nothing is asked of u."""
        if self.surface_velocity in (None, "0"):
            return ""
        relation = "in" if str(self.surface_velocity).startswith("[") else "="
        return f"on a surface with the velocity u {relation} {self.surface_velocity}"

    def components(self, values: Sequence[tuple[str, str]]) -> str:
        """Values of components in words; a name that statements use for something else is said to be a component's."""
        return ", ".join(f"{component(word, self.other_names)} = {value}" for word, value in values)

    @property
    def rests_on(self) -> str:
        """What the result supposes; empty where nothing is known."""
        if self.end != "G-spot":
            return "proved for rigid slip" if self.end else ""
        proved = "reaching the G-spot is" if self.coefficient is None else "reaching the G-spot and C1 are"
        return f"{proved} proved for rigid slip{_SIDE_RESTS_ON if self.side else ''}"

    @property
    def exit_code(self) -> int:
        """0 when the end is proved and, at a G-spot, the side is known; 2 otherwise."""
        open_side = self.end == "G-spot" and self.side is None
        return 0 if self.verdict.outcome is Outcome.PROVED and not open_side else 2

    def __str__(self) -> str:
        lines = [f"{self.name}: slip from {self.components(self.start)}"]
        if self.solved:
            solved = " and ".join(component(word, self.other_names) for word in self.solved)
            lines.append(f"  {solved} from y = 0 and v = 0")
        lines.append(f"  {self.verdict}")
        if self.on_surface:
            lines.append(f"  {self.on_surface}")
        if self.time is not None:
            lines.append(f"  after the time t = {ball_text(self.time)} from the start")
        if self.place:
            lines.append(f"  {self._where()}: {self.components(self.place)}")
        if self.alphas is not None:
            names = ("alpha_1", "alpha_2", "alpha_3")
            lines.append(
                "  " + ", ".join(f"{n} = {ball_text(value)}" for n, value in zip(names, self.alphas, strict=True))
            )
        if self.beta is not None:
            lines.append(f"  {case_text(self.case)}, beta = {ball_text(self.beta)}")
        if self.coefficient is not None:
            lines.append(
                f"  C1 = {ball_text(self.coefficient)}, b = b_distinguished + C1 (-t)^beta + ..."
                " (t counted from the G-spot)"
            )
        if self.end == "G-spot":
            lines.append(f"  side: {self.side or 'undecided'} ({self.side_reason})")
            lines.append(f"  {self.rests_on}")
        if self.fast_exponent is not None:
            lines.append(
                f"  beside slip: about e^(-{self.fast_exponent:.4g}/epsilon) of a fast oscillation at the start is "
                f"left at the G-spot{', which may turn the side where this is not small' if self.side else ''} "
                "(floats: not proved)"
            )
        lines += [f"  {line}" for line in (*self.notes, *self.warnings)]
        return "\n".join(lines)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What the statement supposes beyond the mechanism."""
        texts = []
        if self.supposed:
            texts.append(
                f"the state is supposed to lie on the contact: {', '.join(self.supposed)} = 0 there is not shown, its "
                "ball holds 0; leave out two components that y = 0 and v = 0 determine"
            )
        followed = self.verdict.outcome is Outcome.PROVED
        if followed and self.surface_velocity is None and self.least_slip is not None:
            texts.append(
                f"u is not positive here: on a surface that moves with a velocity below "
                f"{rounded_text(float_bounds(self.least_slip)[0], -1, 6)} rigid slip is positive until then; nothing "
                "is said of where slip stops on others"
            )
        return tuple(texts)

    def _where(self) -> str:
        return "the G-spot" if self.end == "G-spot" else "there"
