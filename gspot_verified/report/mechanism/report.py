"""Everything that is stated about one mechanism, in the order of the page."""

from __future__ import annotations

import hashlib
import shlex
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from flint import fmpq

from gspot_verified.compliant.model.normal_form import CompliantState, compliant_model
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.expansion.trajectory import AccuracyWarning, Trajectory
from gspot_verified.expansion.true_solutions.side import UniformSide, uniform_side
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.classify import Classification, classify_g_spot
from gspot_verified.mechanisms.spots.classify_all import AllClassified, classify_all
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.verdict import NoTruthValue, Outcome
from gspot_verified.numbers.written import Written
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.data import versions
from gspot_verified.report.mechanism.certified_force import force_part, force_picture_part, zeros_part
from gspot_verified.report.mechanism.runs import (
    CHOSEN,
    ReportScene,
    State,
    chosen_run,
    scene_parts,
    slip_part,
    state_text,
)
from gspot_verified.report.mechanism.subject import (
    ReportPart,
    Source,
    Subject,
    attempted,
    beta_ends,
    outcome_of,
    placed_at,
)
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.pictures.expansion_picture import expansion_picture
from gspot_verified.report.pictures.mechanism_picture import mechanism_picture
from gspot_verified.report.pictures.phase_plane import phase_plane_picture
from gspot_verified.signs.gamma.side import side, side_text

_COEFFICIENTS = "The coefficients are proved; how far the truncated sums are from the trajectory is not stated here."
_MODEL = "This is about the compliant model with constant α, those of the G-spot, not about the mechanism away from it."
_SIDES = "The sign of Γ(-β), which gives the sides by the paper's rule as ε → 0"
_ORDER = 6  # of the expansion that is shown: p and b with three terms
_SIDE_ORDER = 8  # of the one that true solutions are compared with
_DELTAS = ("1/50", "1/500", "1/5000")  # up to which they are followed, tried in turn
_EPSILONS = ("1/1000", "1/100000")  # of the exact side rule
_SHARES = (fmpq(1, 2), fmpq(2))  # of the trivial solution's b, at the start: one on each side
_START = fmpq(1, 2)  # p there, as in the paper's figures


def side_part(subject: Subject) -> ReportPart:
    """The sign of Gamma(-beta), which is proved, and what the paper's rule makes of it.

    :raises ValueError: beta is, or may be, an integer and no rational number.
    """
    spot = subject.classified
    assert spot.beta is not None
    ends = beta_ends(spot.beta)
    result = side(*ends)
    known = spot.impact_sign is not None
    what = side_text(spot.lift_off_sign, spot.impact_sign) if known else "no side at leading order: β is an integer"
    return ReportPart(
        _SIDES,
        Outcome.PROVED if known else None,
        f"{result}\nHere: {what}.",
        (shlex.join(["gspot-verified", "side", *map(str, ends)]),),
        data=result.to_json(),
    )


def expansion_part(subject: Subject) -> ReportPart:
    """The first terms of Theorem 1; below the order at which an integer beta stops them."""
    stop, order = subject.classified.obstructed_order, _order(subject)
    trajectory = _trajectory(subject, order)
    text = f"{trajectory}\n{_COEFFICIENTS}"
    if trajectory.pulls:
        text += "\nwarning: the mean force is negative: this trajectory would have to pull on the surface"
    if stop == order:
        text += f"\nno further: β is, or may be, an integer, and there is no unique term of order {stop}"
    reached = trajectory.accuracy is None or trajectory.accuracy.reached
    return ReportPart(
        "The distinguished trajectory",
        Outcome.PROVED if reached else Outcome.UNDECIDED,
        text,
        (
            subject.source.command("expand", "--order", str(order)),
            subject.source.command("expand", "--order", str(order), "--latex"),
        ),
        data={**trajectory.to_json(), "latex": trajectory.to_latex()},
    )


def _order(subject: Subject) -> int:
    """Of the expansion that is shown; at most that at which an integer beta stops it."""
    stop = subject.classified.obstructed_order
    return _ORDER if stop is None else max(1, min(_ORDER, stop))


def _trajectory(subject: Subject, order: int) -> Trajectory:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", AccuracyWarning)  # said by the part's outcome
        return expand(subject.mechanism, order)


def expansion_picture_part(subject: Subject) -> ReportPart:
    """What the truncated expansion leaves in the equations, under its proved bound."""
    order = _order(subject)
    drawn = expansion_picture(_trajectory(subject, order))
    command = subject.source.command("expand", "--order", str(order), "--picture", "expansion.svg")
    return ReportPart(drawn.title, None, drawn.caption, (command,), drawn)


def phase_plane_part(subject: Subject) -> ReportPart:
    """Runs of rigid slip next to the G-spot."""
    return _drawn_part(subject, phase_plane_picture(subject.mechanism))


def mechanism_picture_part(subject: Subject) -> ReportPart:
    """The mechanism at the G-spot, as its file draws it."""
    return _drawn_part(subject, mechanism_picture(subject.mechanism))


def _drawn_part(subject: Subject, drawn: Picture) -> ReportPart:
    words = ["gspot-verified", "plot", drawn.name, f"{drawn.name}.svg", "--mechanism", subject.source.file]
    words += [word for key, value in subject.source.settings.items() for word in ("--set", f"{key}={value}")]
    return ReportPart(drawn.title, None, drawn.caption, (shlex.join(words),), drawn)


def true_solutions_part(subject: Subject, c1: int, title: str, say: Callable[[str], None]) -> ReportPart:
    """Lift-off or impact of the true solutions next to the expansion, for every epsilon up to one.

    :raises ValueError: beta is no rational number above 1.
    """
    if not isinstance(subject.classified.beta, fmpq) or not subject.classified.beta > 1:
        raise ValueError("Theorem U2 of proofs/uniform.md needs a rational β > 1")
    trajectory = _trajectory(subject, _SIDE_ORDER)
    found: UniformSide | None = None
    for delta in _DELTAS:
        say(f"true solutions with C1 = {c1}, δ <= {delta}")
        found = uniform_side(trajectory, c1, delta)
        if found.side is not None:
            break
    assert found is not None
    return ReportPart(
        title,
        found.verdict.outcome,
        str(found),
        (subject.source.command("expand", "--order", str(_SIDE_ORDER), f"--side={c1},{found.delta}"),),
        data=found.to_json(),
    )


def exact_side_part(subject: Subject) -> ReportPart:
    """The sign of K for the compliant model with the alphas of the G-spot, from starts on both sides.

    :raises ValueError: the G-spot is not in Case III, or its alphas are no rational numbers.
    """
    spot = subject.classified
    alphas = (spot.alpha_1, spot.alpha_2, spot.alpha_3)
    if spot.case != "III" or not all(isinstance(alpha, fmpq) for alpha in alphas):
        raise ValueError("the exact side rule is asked in Case III, and where the alphas are rational")
    if not spot.regularisation.is_papers:
        raise ValueError("the exact side rule is that of the paper's compliance")
    first, second, third = alphas
    lines, commands, verdicts, data = [], [], [], []
    for epsilon in _EPSILONS:
        model = compliant_model(epsilon=epsilon, alpha_1=first, alpha_2=second, alpha_3=third)
        for share in _SHARES:
            b = -share * model.mean_force * _START
            flat = model.epsilon**2 * b / _START
            state = CompliantState(_START, b, 2 * flat, fmpq(0), flat)
            result = side_rule(model, state)
            given = ",".join(str(getattr(state, name)) for name in ("p", "b", "y", "v", "z"))
            lines.append(f"ε = {epsilon}, p = {_START}, b = {b} ({share} of the trivial solution's): {result}")
            words = ["side", "--beta", model.beta, "--eps", epsilon, f"--alpha1={first}", f"--alpha2={second}"]
            commands.append(shlex.join(["gspot-verified", *map(str, words), f"--state={given}"]))
            verdicts.append(result.verdict)
            data.append({"epsilon": epsilon, "state": given, **result.to_json()})
    return ReportPart(
        "The exact side rule of the compliant model with these α",
        outcome_of(verdicts),
        "\n".join([*lines, _MODEL]),
        tuple(commands),
        data=data,
    )


_BUDGET = 100_000  # boxes of the search for all G-spots: as the command classify has it


@dataclass(frozen=True)
class ReportedSpot(NoTruthValue, Written):
    """One G-spot: what it is, and what is stated about it."""

    ask: ClassVar[str] = ".parts have an outcome each"
    written: ClassVar[str] = "number file classification parts"

    number: int
    file: str
    classification: Classification
    parts: tuple[ReportPart, ...]


@dataclass(frozen=True)
class MechanismReport(NoTruthValue, Written):
    """The page on one mechanism as data.

    ``search`` is about the whole region, ``spots`` about the file's own G-spot and all others in a Case, ``runs`` about
    the user's states and scene. ``files`` are the mechanism files beside the page, by name.
    """

    ask: ClassVar[str] = ".exit_code is 0, 1 or 2"
    written: ClassVar[str] = "name sha256=hashes settings exit_code search spots runs command versions"

    name: str
    settings: tuple[tuple[str, str], ...]
    files: tuple[tuple[str, bytes], ...]
    search: ReportPart
    spots: tuple[ReportedSpot, ...]
    runs: tuple[ReportPart, ...]
    command: str

    @property
    def parts(self) -> tuple[ReportPart, ...]:
        """All parts, in the order of the page."""
        return (self.search, *(part for spot in self.spots for part in spot.parts), *self.runs)

    @property
    def certificates(self) -> tuple[CheckedCertificate, ...]:
        """All certificates, in the order of the page."""
        return tuple(file for part in self.parts for file in part.certificates)

    @property
    def hashes(self) -> dict[str, str]:
        """The SHA-256 of each file beside the page, by its name."""
        made = {name: hashlib.sha256(content).hexdigest() for name, content in self.files}
        return made | {file.name: file.sha256 for file in self.certificates}

    @property
    def versions(self) -> dict[str, str]:
        """What computed it."""
        return versions()

    @property
    def exit_code(self) -> int:
        """1 when a statement is refuted (as that there are G-spots) or a certificate rejected, 2 when one is open."""
        outcomes = {part.outcome for part in self.parts}
        if Outcome.REFUTED in outcomes or not all(file.verified for file in self.certificates):
            return 1
        return 2 if Outcome.UNDECIDED in outcomes else 0


def report_on(
    source: Source, states: Sequence[State], scene: ReportScene | None, budget: int | None, say: Callable[[str], None]
) -> MechanismReport:
    """Compute all parts.

    :raises MechanismError: the file describes no complete mechanism.
    """
    mechanism = source.mechanism
    say("all G-spots")
    chosen = _BUDGET if budget is None else budget
    found = classify_all(mechanism, budget=chosen)
    first, *region = found.found.about()
    words = [] if budget is None else ["--budget", str(budget)]
    own, left_out = _own(mechanism)
    search = ReportPart(
        "That there is a G-spot" if found.verdict.outcome is Outcome.REFUTED else "All G-spots",
        found.verdict.outcome,
        "\n".join(
            dict.fromkeys(
                [first, *str(found.verdict).splitlines()[1:], *region, str(found.critical), *left_out],
            )
        ),
        (source.command("classify", "--all", *words),),
        data=found.to_json(),
    )
    spots, files = [], {source.file: source}
    for number, (spot, is_own) in enumerate(_spots(mechanism, own, found), 1):
        say(f"G-spot {number}")
        try:
            used, there = (source, spot) if is_own else _in_a_file(source, spot, f"g-spot-{number}.toml")
        except ValueError as error:
            spots.append(_without_file(number, source, spot, str(error)))
            continue
        subject = Subject(number, used, used.mechanism, there, classify_g_spot(there))
        files[used.file] = used
        spots.append(ReportedSpot(number, used.file, subject.classified, _parts(subject, not states, say)))
    runs = []
    for number, state in enumerate(states, 1):
        say(f"slip from state {number}")
        title = f"Slip from the given state {number}"
        runs.append(attempted(title, partial(slip_part, source, state, title)))
    if scene is not None:
        say(f"the scene {scene.scene.name}")
        shown: list[ReportPart] = []

        def run_of_scene() -> ReportPart:
            shown.extend(scene_parts(scene, say))
            return shown[0]

        runs += [attempted("The scene", run_of_scene), *shown[1:]]
    return MechanismReport(
        name=mechanism.name,
        settings=tuple(source.settings.items()),
        files=(*((file, used.text.encode()) for file, used in files.items()), *(scene.files if scene else ())),
        search=search,
        spots=tuple(spots),
        runs=tuple(runs),
        command=_command(source, states, scene, words),
    )


def _command(source: Source, states: Sequence[State], scene: ReportScene | None, words: Sequence[str]) -> str:
    """The command that makes the page again."""
    given = [word for state in states for word in ("--from", state_text(state))]
    beside = [] if scene is None else ["--scene", scene.file]
    return source.command("report", *given, *beside, *words, "--output", "again", option="--mechanism")


def _own(mechanism: Mechanism) -> tuple[list[GSpot], list[str]]:
    """The file's own G-spot; or why there is none: it names no place, or one that is no G-spot."""
    try:
        return [find_g_spot(mechanism)], []
    except ValueError as error:
        return [], [f"the file's own place is not described: {error}"]


def _spots(mechanism: Mechanism, own: list[GSpot], found: AllClassified) -> list[tuple[GSpot, bool]]:
    """The file's own G-spot (True) first; then those of the search that are others and, perhaps, in a Case."""
    free = {mechanism.state.index(word) for word in found.found.free}
    others = [
        spot
        for spot, told in zip(found.found.spots, found.spots, strict=True)
        if told.case != "none" and not any(_meet(spot, first, free) for first in own)
    ]
    return [*((spot, True) for spot in own), *((spot, False) for spot in others)]


def _meet(spot: GSpot, other: GSpot, free: set[int]) -> bool:
    """Whether the boxes meet in all components but the free ones."""
    with working_bits(spot.bits):
        pairs = list(zip(spot.system.point, other.system.point, strict=True))
        return all(ball(x).overlaps(ball(y)) for i, (x, y) in enumerate(pairs) if i not in free)


def _in_a_file(source: Source, spot: GSpot, file: str) -> tuple[Source, GSpot]:
    """A file that names the place of this G-spot, and the G-spot as it is found from there.

    :raises ValueError: no such file can be made, or another G-spot is found from there.
    """
    used = placed_at(source, spot, file)
    there = find_g_spot(used.mechanism)
    if not _meet(spot, there, set()):
        raise ValueError("from its place in a file it is not certain that the same G-spot is found")
    return used, there


def _without_file(number: int, source: Source, spot: GSpot, why: str) -> ReportedSpot:
    classified = classify_g_spot(spot)
    parts = (
        _classification(classified, source.command("classify", "--all")),
        ReportPart("Further statements", None, f"left out: {why}"),
    )
    return ReportedSpot(number, source.file, classified, parts)


def _classification(classified: Classification, command: str) -> ReportPart:
    outcome = Outcome.UNDECIDED if classified.case is None else Outcome.PROVED
    return ReportPart("What it is", outcome, str(classified), (command,), data=classified.to_json())


def _parts(subject: Subject, choose: bool, say: Callable[[str], None]) -> tuple[ReportPart, ...]:
    """What is stated about one G-spot, or why it is not; ``choose``: starts of slip are chosen here."""
    case, planned = subject.classified.case, list[tuple[str, Callable[[], ReportPart]]]()
    if subject.mechanism.drawing is not None:
        planned.append(("The mechanism there", partial(mechanism_picture_part, subject)))
    has_sides = case in ("I", "II", "III") and subject.mechanism.regularisation.c > 0
    if has_sides:
        planned.append((_SIDES, partial(side_part, subject)))
    impact, lift_off = subject.classified.impact_sign, subject.classified.lift_off_sign
    for c1, after in ((impact, "impact"), (lift_off, "lift-off")):
        if c1 is None:
            continue
        name = f"C1 = {c1}, the side of the {after}"
        force, solutions = f"The contact force with {name}", f"True solutions with {name}"
        planned.append((force, partial(force_part, subject, c1, force)))
        if case == "III":
            planned.append((solutions, partial(true_solutions_part, subject, c1, solutions, say)))
    if has_sides:
        planned.append(("The sign and the zeros of dΘ/dτ", partial(zeros_part, subject)))
    if case == "III":
        planned.append(("The contact force at leading order", partial(force_picture_part, subject)))
        planned.append(("The exact side rule", partial(exact_side_part, subject)))
    planned += [
        ("The distinguished trajectory", partial(expansion_part, subject)),
        ("What the expansion leaves", partial(expansion_picture_part, subject)),
        ("The phase plane", partial(phase_plane_part, subject)),
    ]
    if choose and case in ("I", "II", "III"):
        for which in CHOSEN:
            title = f"Slip from a state that was chosen here, {which}"
            planned.append((title, partial(chosen_run, subject, which, title)))
    parts = [_classification(subject.classified, subject.source.command("classify"))]
    for title, make in planned:
        say(f"G-spot {subject.number}: {title}")
        parts.append(attempted(title, make))
    return tuple(parts)
