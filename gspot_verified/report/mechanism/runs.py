"""Certified runs: rigid slip from states next to a G-spot or from the user's, and the user's compliant scene."""

from __future__ import annotations

import re
import shlex
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from pathlib import Path

from flint import arb, fmpq

from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.slip_state import StateError, slip_state
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import approximate, ball, working_bits
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.mechanism.subject import ReportPart, Source, Subject
from gspot_verified.report.pictures.mechanism_animation import mechanism_animation
from gspot_verified.report.pictures.phase_plane import RigidSlip
from gspot_verified.scenes.scene.file import load_scene, parse_scene, scene_names
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.simulate import simulate

_BITS = 80  # of the search for a start: any start is as good
_PLACES = 10**8  # a start is rounded to so many parts of 1
_SIZES = tuple(fmpq(1, 2**k) for k in (5, 7, 9, 12))  # p at the start, tried in turn
_STEPS = 4000  # of the integrator at each precision, in a scene: a limit against endless work
_FRAMES = 101  # enclosures asked for where the run is shown in motion; the integrator has times of its own
_SCENE_FILE = "scene.toml"
_MECHANISM = re.compile(r"^mechanism\s*=.*$", re.MULTILINE)
CHOSEN = {"the first of two": fmpq(3, 4), "the second of two": fmpq(5, 4)}
"""Starts next to a G-spot, by their b over that of the distinguished trajectory at leading order."""

State = Mapping[str, str]


def check_state(mechanism: Mechanism, state: State) -> None:
    """Passes for a state on the contact of the mechanism.

    :raises StateError: it is none.
    """
    with working_bits(_BITS):
        slip_state(shift(mechanism), state)


def slip_part(source: Source, state: State, title: str) -> ReportPart:
    """Where slip from this state leads.

    :raises ValueError: the state is no start.
    """
    result = approach(source.mechanism, state)
    return ReportPart(
        title,
        Outcome.UNDECIDED if result.exit_code else result.verdict.outcome,
        str(result),
        (source.command("approach", "--from", state_text(state)),),
        data=result.to_json(),
    )


def chosen_run(subject: Subject, which: str, title: str) -> ReportPart:
    """The run from a start next to the G-spot, one of :data:`CHOSEN`, at the largest p that gives a proved answer.

    :raises ValueError: no start was found.
    """
    part: ReportPart | None = None
    for size in _SIZES:
        state = chosen_state(subject, size, CHOSEN[which])
        if state is None:
            continue
        part = slip_part(subject.source, state, title)
        if part.outcome is Outcome.PROVED:
            break
    if part is None:
        raise ValueError("no state in contact was found next to the G-spot; give one with --from")
    return part


def chosen_state(subject: Subject, p: fmpq, share: fmpq) -> State | None:
    """A state with about this p, and b about ``share`` of the distinguished trajectory's (or of -p, where that pulls).

    All components but two, which y = 0 and v = 0 determine. None where none was found.
    """
    mechanism, spot = subject.mechanism, subject.spot
    with working_bits(_BITS):
        alphas = (subject.classified.alpha_1, subject.classified.alpha_2, subject.classified.alpha_3)
        first, second, third = (ball(alpha).mid() for alpha in alphas)
        slope = (second / (first - third)).mid() if subject.classified.case != "I" else arb(-1)
        found = RigidSlip(spot).state_at(ball(p), (ball(share) * slope * ball(p)).mid())
        if found is None:
            return None
        references = {angle.coordinate: angle.name for angle in mechanism.angles}
        texts = {}
        for word, value in zip(mechanism.state, found, strict=True):
            number = fmpq(round(approximate(value) * _PLACES), _PLACES)
            sign, size = ("-", -number) if number < 0 else ("+", number)
            text = short_text(number)
            texts[word] = f"{references[word]} {sign} {short_text(size)}" if word in references else text
        shifted = shift(mechanism)
        pairs = sorted(combinations(mechanism.state, 2), key=lambda pair: pair[1] != f"{pair[0]}_dot")
        for pair in pairs:
            state = {word: text for word, text in texts.items() if word not in pair}
            try:
                slip_state(shifted, state)
            except StateError:
                continue
            return state
    return None


def state_text(state: State) -> str:
    """The state as the option --from has it."""
    return ",".join(f"{word}={value}" for word, value in state.items())


@dataclass(frozen=True)
class ReportScene:
    """A scene of the mechanism: ``file`` is its name on the command line, ``files`` what stands beside the page."""

    scene: Scene
    file: str
    files: tuple[tuple[str, bytes], ...] = ()


def report_scene(name: str, source: Source) -> ReportScene:
    """The scene with this name or in this file, in which the mechanism is named as beside the page.

    :raises SceneError: there is no such scene, it is that of another mechanism, or beside the page it would be another.
    :raises MechanismError: no TOML, or a key is wrong.
    """
    scene, own = load_scene(name), source.mechanism
    # A name says which parameters --set changed: those of the scene may be written elsewhere.
    if scene.mechanism is None or replace(scene.mechanism, place=own.place, name=own.name) != own:
        raise SceneError(f"{name[:60]}: the scene is of another mechanism, or of other parameters, than the report")
    if name in scene_names():
        return ReportScene(scene, name)
    text = Path(name).read_text(encoding="utf-8-sig")
    named = _MECHANISM.sub(f'mechanism = "{source.file}"', text, count=1)
    if not _is_the_same_beside(named, source, scene):
        raise SceneError(
            f"{name[:60]}: beside the page the scene would be another: let it name the file of the report, and give "
            "parameters that --set changes in the scene's own table"
        )
    return ReportScene(scene, _SCENE_FILE, ((_SCENE_FILE, named.encode()),))


def _is_the_same_beside(text: str, source: Source, scene: Scene) -> bool:
    """Whether the text is this scene where the mechanism's file is that of the report.

    The place in that file may be another, unless the start follows from it.
    """
    assert scene.mechanism is not None
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / source.file).write_text(source.text, encoding="utf-8", newline="\n")
        there = parse_scene(text, Path(folder))
    if there.mechanism is None:
        return False
    if there.mechanism.place != scene.mechanism.place and scene.enclosed_initial():
        return False
    return replace(there, mechanism=replace(there.mechanism, place=scene.mechanism.place)) == scene


def scene_parts(scene: ReportScene, say: Callable[[str], None]) -> tuple[ReportPart, ...]:
    """The certified run of the scene, with so many steps of the integrator at most; and in motion where the file of the
    mechanism says how the bodies look, and something of the run is known."""
    shown = scene.scene
    drawn = shown.mechanism is not None and shown.mechanism.drawing is not None
    result = simulate(shown, budget=_STEPS, points=_FRAMES if drawn else None, progress=say)
    command = shlex.join(["gspot-verified", "simulate", scene.file, "--budget", str(_STEPS)])
    assumed = [f"without {name}: {line}" for name, line in shown.assumes().items()]
    run = ReportPart(
        f"The scene {shown.name}, ε = {shown.epsilon}",
        result.verdict.outcome,
        "\n".join([str(result), *assumed]),
        (command,),
        data=result.to_json(),
    )
    try:
        moving = mechanism_animation(shown, result)
    except ValueError:  # no drawing, or nothing of the run is known
        return (run,)
    return run, ReportPart(moving.title, None, moving.caption, (f"{command} --animation motion.svg",), moving)
