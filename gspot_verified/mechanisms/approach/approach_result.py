"""What :func:`approach.approach` answers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from flint import arb

from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.verdict import ASK_VERDICT, NoTruthValue, Outcome, Verdict

LIFT_OFF, IMPACT = "lift-off", "impact without collision"
RESTS_ON = (
    "reaching the G-spot and C1 are proved for rigid slip; the side is the paper's statement at leading order as "
    "epsilon -> 0 (Sec. 4.5), not a theorem at a finite epsilon"
)


@dataclass(frozen=True, slots=True)
class SlipPath:
    """Enclosures at some times of the path, in order: the time t, the state (angles from their references) and
    p, b, u, λ_N = -b/p there."""

    time: tuple[arb, ...]
    states: tuple[tuple[arb, ...], ...]
    p: tuple[arb, ...]
    b: tuple[arb, ...]
    u: tuple[arb, ...]
    force: tuple[arb, ...]


@dataclass(frozen=True, slots=True)
class Approach(NoTruthValue):
    """Where positive slip from a state leads.

    ``end`` is "G-spot", "lift-off" or "stick", what is proved to come first; None when it is undecided. ``place`` is
    the G-spot, or the state at the event; ``time`` the time until then. At a G-spot ``case``, ``alphas``, ``beta`` and
    ``coefficient`` (C_1) are what they are there; ``side`` is "lift-off", "impact without collision", or None where it
    is undecided or the theory says none, and ``side_reason`` says why. ``least_slip`` bounds u on the path from below;
    ``notes`` say how the mechanism was read.
    """

    ask: ClassVar[str] = ASK_VERDICT

    name: str
    start: tuple[tuple[str, str], ...]
    solved: tuple[str, ...]
    verdict: Verdict
    end: str | None
    time: arb | None
    place: tuple[tuple[str, str], ...]
    case: str | None
    alphas: tuple[arb, arb, arb] | None
    beta: arb | None
    coefficient: arb | None
    side: str | None
    side_reason: str
    least_slip: arb | None
    surface_velocity: str | None
    notes: tuple[str, ...]
    path: SlipPath
    bits: int

    @property
    def exit_code(self) -> int:
        """0 when the end is proved and, at a G-spot in one of the cases, the side is known; 2 otherwise."""
        open_side = self.end == "G-spot" and self.side is None
        return 0 if self.verdict.outcome is Outcome.PROVED and not open_side else 2

    def __str__(self) -> str:
        lines = [f"{self.name}: slip from " + ", ".join(f"{word} = {value}" for word, value in self.start)]
        if self.solved:
            lines.append(f"  {' and '.join(self.solved)} from y = 0 and v = 0")
        lines.append(f"  {self.verdict}")
        if self.time is not None:
            lines.append(f"  after the time t = {ball_text(self.time)}")
        if self.place:
            lines.append(f"  {self._where()}: " + ", ".join(f"{word} = {value}" for word, value in self.place))
        if self.alphas is not None:
            names = ("alpha_1", "alpha_2", "alpha_3")
            lines.append(
                "  " + ", ".join(f"{n} = {ball_text(value)}" for n, value in zip(names, self.alphas, strict=True))
            )
        if self.beta is not None:
            lines.append(f"  {f'Case {self.case}' if self.case else 'no Case'}, beta = {ball_text(self.beta)}")
        if self.coefficient is not None:
            lines.append(f"  C1 = {ball_text(self.coefficient)}, b = b_distinguished + C1 (-t)^beta + ...")
        if self.end == "G-spot":
            lines.append(f"  side: {self.side or 'undecided'} ({self.side_reason})")
            lines.append(f"  {RESTS_ON}")
        lines += [f"  {line}" for line in (*self.notes, *self.warnings)]
        return "\n".join(lines)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What the statement supposes beyond the mechanism."""
        if self.surface_velocity is None and self.least_slip is not None:
            return (
                f"u is not positive here: positive slip needs a surface that moves with a velocity below "
                f"{ball_text(self.least_slip, 6)}; nothing is said about stick",
            )
        return ()

    def _where(self) -> str:
        return "the G-spot" if self.end == "G-spot" else "there"

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``; balls as text."""

        def text(value: arb | None) -> str | None:
            return None if value is None else ball_text(value)

        return {
            "name": self.name,
            "start": dict(self.start),
            "solved": list(self.solved),
            "verdict": self.verdict.to_json(),
            "end": self.end,
            "time": text(self.time),
            "place": dict(self.place),
            "case": self.case,
            "alphas": None if self.alphas is None else [ball_text(value) for value in self.alphas],
            "beta": text(self.beta),
            "C1": text(self.coefficient),
            "side": self.side,
            "side_reason": self.side_reason,
            "rests_on": RESTS_ON if self.end == "G-spot" else "proved for rigid slip",
            "surface_velocity": self.surface_velocity,
            "least_slip": text(self.least_slip),
            "notes": list(self.notes),
            "warnings": list(self.warnings),
            "bits": self.bits,
            "path": {
                name: [ball_text(value, 10) for value in getattr(self.path, name)]
                for name in ("time", "p", "b", "u", "force")
            },
        }
