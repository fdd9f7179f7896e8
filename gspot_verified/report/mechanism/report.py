"""Everything that is stated about one mechanism, in the order of the page."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

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
from gspot_verified.report.mechanism.local_parts import (
    exact_side_part,
    expansion_part,
    expansion_picture_part,
    mechanism_picture_part,
    phase_plane_part,
    side_part,
    true_solutions_part,
)
from gspot_verified.report.mechanism.part import ReportPart, attempted
from gspot_verified.report.mechanism.runs import (
    CHOSEN,
    ReportScene,
    State,
    chosen_run,
    scene_parts,
    slip_part,
    state_text,
)
from gspot_verified.report.mechanism.subject import Source, Subject, placed_at

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
    if case in ("I", "II", "III"):
        planned.append(("The sides", partial(side_part, subject)))
    impact, lift_off = subject.classified.impact_sign, subject.classified.lift_off_sign
    for c1, side in ((impact, "impact"), (lift_off, "lift-off")):
        if c1 is None:
            continue
        name = f"C1 = {c1}, the side of the {side}"
        force, solutions = f"The contact force with {name}", f"True solutions with {name}"
        planned.append((force, partial(force_part, subject, c1, force)))
        if case == "III":
            planned.append((solutions, partial(true_solutions_part, subject, c1, solutions, say)))
    if case in ("I", "II", "III"):
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
