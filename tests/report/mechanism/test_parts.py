"""Each part of the page states what its result proved, with a command that prints the same, or says why it does not."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gspot_verified import load_scene
from gspot_verified.cli import main
from gspot_verified.compliant.contact.iwc import CONSTANT_ALPHAS
from gspot_verified.expansion.series.regularisation import NO_DAMPER, Regularisation
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_text
from gspot_verified.mechanisms.spots.classify import classify_g_spot
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict
from gspot_verified.report.mechanism import certified_force, report, runs
from gspot_verified.report.mechanism.certified_force import force_part, zeros_part
from gspot_verified.report.mechanism.report import (
    exact_side_part,
    expansion_part,
    expansion_picture_part,
    mechanism_picture_part,
    side_part,
    true_solutions_part,
)
from gspot_verified.report.mechanism.runs import chosen_run, chosen_state, report_scene, scene_parts, slip_part
from gspot_verified.report.mechanism.subject import ReportPart, Source, Subject, attempted, outcome_of
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.signs.zeros.slope_at import UndecidedError


@pytest.fixture
def printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[[Source, str], str]:
    """What a command prints, in a folder with the mechanism's file."""

    def run(source: Source, command: str) -> str:
        monkeypatch.chdir(tmp_path)
        Path(source.file).write_text(source.text, encoding="utf-8")
        words = shlex.split(command)
        assert words[0] == "gspot-verified"
        assert main(words[1:]) in (0, 1, 2), command
        return capsys.readouterr().out

    return run


def says_the_same(part: ReportPart, printed: str) -> bool:
    """Whether each line that was printed stands in the part, but for those that name files."""
    lines = [line.strip() for line in printed.splitlines()]
    assert any(lines)
    names = ("the compliant model from the initial state", "certificate of: ")
    return all(line in part.text for line in lines if not line.startswith(names))


def certified(part: ReportPart, folder: Path) -> list[str]:
    """The names of the certificates that lie in the folder as the part has them."""
    return [
        file.name for file in part.certificates if (folder / file.name).read_bytes() == file.content and file.verified
    ]


def test_the_exact_g_spot(exact: Subject, printed: Callable[[Source, str], str], tmp_path: Path) -> None:
    for part, names in (
        (side_part(exact), []),
        (zeros_part(exact), ["g-spot-1-zeros.cert"]),
        (force_part(exact, -1, "lift-off"), ["g-spot-1-lift-off.cert"]),
        (expansion_part(exact), []),
    ):
        assert part.outcome is Outcome.PROVED
        assert says_the_same(part, printed(exact.source, part.commands[0]))
        assert certified(part, tmp_path) == names
        assert [f"gspot-verified check {name}" for name in names] == list(part.commands[1:])[: len(names)]
        if names:
            assert printed(exact.source, part.commands[1]).strip() == part.certificates[0].said


def test_the_side_is_that_of_the_classification(exact: Subject, in_balls: Subject, second_case: Subject) -> None:
    assert (
        "Here: Case III, by the paper's rule as ε → 0: C1 < 0 lifts off, C1 > 0 takes an IWC" in side_part(exact).text
    )
    assert side_part(exact).title == "The sign of Γ(-β), which gives the sides by the paper's rule as ε → 0"
    assert in_balls.classified.lift_off_sign == 1
    assert (
        "Here: Case III, by the paper's rule as ε → 0: C1 > 0 lifts off, C1 < 0 takes an IWC"
        in side_part(in_balls).text
    )
    assert "Here: Cases I and II, by the paper's rule as ε → 0: C1 < 0 takes an IWC" in side_part(second_case).text


def test_without_a_damper_neither_sides_nor_zeros_of_the_force_are_stated() -> None:
    undamped = replace(shipped_mechanism("falling rod"), regularisation=Regularisation.of(1, 1, 0))
    spot = find_g_spot(undamped)
    subject = Subject(1, Source("rod.toml", "", {}), undamped, spot, classify_g_spot(spot))
    parts = report._parts(subject, choose=False, say=lambda _: None)
    assert not any(word in part.title for part in parts for word in ("sides", "impact", "dΘ/dτ"))
    assert f"no side: {NO_DAMPER}" in parts[0].text


def test_balls_of_beta_lie_in_the_range_of_the_command(
    in_balls: Subject, second_case: Subject, printed: Callable[[Source, str], str], tmp_path: Path
) -> None:
    for subject in (in_balls, second_case):
        side, zeros = side_part(subject), zeros_part(subject)
        lower, upper = report.beta_ends(subject.classified.beta)  # type: ignore[arg-type]
        assert lower < subject.classified.beta < upper  # type: ignore[operator]
        assert side.commands == (f"gspot-verified side {lower} {upper}",)
        assert f"{lower}..{upper}" in zeros.commands[0]
        assert zeros.outcome is Outcome.PROVED
        assert says_the_same(side, printed(subject.source, side.commands[0]))
        printed(subject.source, zeros.commands[0])
        assert len(certified(zeros, tmp_path)) == 1


def test_a_force_in_balls_has_no_certificate(second_case: Subject, printed: Callable[[Source, str], str]) -> None:
    part = force_part(second_case, -1, "impact")
    assert part.outcome is Outcome.PROVED
    assert part.certificates == ()
    assert "no certificate: it needs rational alphas" in part.text
    assert CONSTANT_ALPHAS in part.text
    assert says_the_same(part, printed(second_case.source, part.commands[0]))


def test_an_integer_beta(integer: Subject, printed: Callable[[Source, str], str]) -> None:
    side, zeros, expansion = side_part(integer), zeros_part(integer), expansion_part(integer)
    assert side.outcome is None
    assert "no side at leading order: β is an integer" in side.text
    assert zeros.certificates == ()
    assert "no certificate: at an integer β" in zeros.text
    assert says_the_same(zeros, printed(integer.source, zeros.commands[0]))
    assert "orders of delta below 4" in expansion.text
    assert "there is no unique term of order 4" in expansion.text
    assert says_the_same(expansion, printed(integer.source, expansion.commands[0]))


def test_the_picture_is_that_of_the_expansion_that_is_shown(
    exact: Subject, integer: Subject, monkeypatch: pytest.MonkeyPatch
) -> None:
    def drawn(trajectory: Trajectory) -> Picture:
        return Picture("expansion", f"order {trajectory.order}", "caption", "", "<svg></svg>", b"")

    monkeypatch.setattr(report, "expansion_picture", drawn)
    for subject, order in ((exact, 6), (integer, 4)):
        part = expansion_picture_part(subject)
        assert part.title == f"order {order}"
        assert part.outcome is None
        assert part.commands == (subject.source.command("expand", "--order", str(order), "--picture", "expansion.svg"),)


def test_the_mechanism_is_shown_where_something_says_how_it_looks(
    second_case: Subject, exact: Subject, printed: Callable[[Source, str], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    part = mechanism_picture_part(second_case)
    assert part.outcome is None
    assert part.picture is not None
    assert part.picture.title == part.title == "Falling rod of Génot and Brogliato at its G-spot"
    assert printed(second_case.source, part.commands[0]) == f"{part.title}\n{part.text}\n"
    monkeypatch.setattr(report, "attempted", lambda title, _: ReportPart(title, None, ""))
    named = [[each.title for each in report._parts(one, False, lambda _: None)] for one in (second_case, exact)]
    assert named[0][:2] == ["What it is", "The mechanism there"]
    assert "The mechanism there" not in named[1]


def test_the_exact_side_rule(exact: Subject, in_balls: Subject, printed: Callable[[Source, str], str]) -> None:
    part = exact_side_part(exact)
    assert part.outcome is Outcome.PROVED
    assert part.text.count("K > 0") == part.text.count("K < 0") == 2
    for command in part.commands:
        assert says_the_same(part, printed(exact.source, command))
    with pytest.raises(ValueError, match="where the alphas are rational"):
        exact_side_part(in_balls)


def test_true_solutions(
    exact: Subject, in_balls: Subject, printed: Callable[[Source, str], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[str] = []
    monkeypatch.setattr(report, "_DELTAS", ("1/5", "1/50"))
    part = true_solutions_part(exact, -1, "lift-off", said.append)
    assert len(said) == 2
    assert part.outcome is Outcome.PROVED
    assert part.commands == ("gspot-verified expand mechanism.toml --order 8 --side=-1,1/50",)
    output = printed(exact.source, part.commands[0])
    assert says_the_same(part, output[output.rindex("model system:") :])
    monkeypatch.setattr(report, "_DELTAS", ("1/5",))
    open_part = true_solutions_part(exact, -1, "lift-off", said.append)
    assert open_part.outcome is Outcome.UNDECIDED
    assert "undecided" in open_part.text
    with pytest.raises(ValueError, match="needs a rational β > 1"):
        true_solutions_part(in_balls, 1, "lift-off", said.append)


@pytest.mark.parametrize(
    ("which", "found"), list(zip(runs.CHOSEN, ("impact without collision", "lift-off"), strict=True))
)
def test_runs_from_chosen_states(exact: Subject, printed: Callable[[Source, str], str], which: str, found: str) -> None:
    part = chosen_run(exact, which, "Slip")
    assert part.outcome is Outcome.PROVED
    assert f"side: {found}" in part.text
    assert says_the_same(part, printed(exact.source, part.commands[0]))


def test_a_chosen_state_leaves_out_what_contact_determines(in_balls: Subject, second_case: Subject) -> None:
    for subject in (in_balls, second_case):
        state = chosen_state(subject, runs._SIZES[0], runs.CHOSEN["the first of two"])
        assert state is not None
        assert len(state) == len(subject.mechanism.state) - 2
        assert all(re.search(r"\d", value) for value in state.values())


def test_a_state_that_is_no_start(exact: Subject) -> None:
    with pytest.raises(StateError, match=r"p = .* is not certainly positive"):
        slip_part(exact.source, {"x": "0", "u": "1", "p": "-1", "b": "-1"}, "Slip")


def test_a_scene_is_of_this_mechanism(tmp_path: Path, exact: Subject) -> None:
    rod = Source("mechanism.toml", shipped_text("rod"), {})
    assert report_scene("rod", rod).files == ()
    (tmp_path / "own.toml").write_text(shipped_text("rod"), encoding="utf-8")
    scene = 'format = 1\nname = "own"\nmechanism = "own.toml"\neffects = ["compliant_contact"]\n'
    scene += 'epsilon = "1/1000"\nuntil = "1/100"\nstart = {theta = "theta_ref - 1/10", theta_dot = "1/2", X_dot = 2}\n'
    place = tmp_path / "scene.toml"
    place.write_text(scene, encoding="utf-8")
    found = report_scene(str(place), rod)
    assert found.files == (("scene.toml", scene.replace("own.toml", "mechanism.toml").encode()),)
    for other in (exact.source, Source("mechanism.toml", shipped_text("rod"), {"mu": "2"})):
        with pytest.raises(ValueError, match="of another mechanism, or of other parameters"):
            report_scene(str(place), other)


def test_a_scene_beside_the_page_is_the_same(tmp_path: Path) -> None:
    """The command on the page runs the files beside it: no parameter and no start may be another there."""
    scene = 'format = 1\nname = "own"\nmechanism = "own.toml"\neffects = ["compliant_contact", "lift_off"]\n'
    scene += 'epsilon = "1/1000"\nuntil = "1/100"\n'
    rod, place = shipped_text("rod"), tmp_path / "scene.toml"
    (tmp_path / "own.toml").write_text(rod.replace('mu = "73/36"', "mu = 2"), encoding="utf-8")
    start = 'start = {theta = "theta_ref - 1/10", theta_dot = "1/2", X_dot = 2}\n'
    place.write_text(scene + start, encoding="utf-8")
    with pytest.raises(ValueError, match="beside the page the scene would be another"):
        report_scene(str(place), Source("mechanism.toml", rod, {"mu": "2"}))
    place.write_text(scene + start + "parameters = {mu = 2}\n", encoding="utf-8")
    assert report_scene(str(place), Source("mechanism.toml", rod, {"mu": "2"})).files
    arm = shipped_text("two_link_arm")
    other = arm.replace('theta_2 = "8/11"', "theta_2 = 3")
    assert other != arm
    (tmp_path / "own.toml").write_text(other, encoding="utf-8")
    place.write_text(scene + 'start = {theta_1 = "1/4", theta_1_dot = -1}\n', encoding="utf-8")
    assert report_scene(str(place), Source("mechanism.toml", other, {})).files
    with pytest.raises(ValueError, match="beside the page the scene would be another"):
        report_scene(str(place), Source("mechanism.toml", arm, {}))


def test_a_scene_is_run_with_a_budget(printed: Callable[[Source, str], str], monkeypatch: pytest.MonkeyPatch) -> None:
    rod = Source("mechanism.toml", shipped_text("rod"), {})
    short = replace(report_scene("rod", rod), scene=load_scene("rod", until="1/1000"))
    part = scene_parts(short, lambda _: None)[0]
    assert part.outcome is Outcome.PROVED
    assert part.title == "The scene rod, ε = 1/1000"
    assert part.commands == ("gspot-verified simulate rod --budget 4000",)
    assert says_the_same(part, printed(rod, f"{part.commands[0]} --until 1/1000").partition("  rod, ε = ")[0])
    monkeypatch.setattr(runs, "_STEPS", 1)
    assert scene_parts(replace(short, scene=load_scene("rod")), lambda _: None)[0].outcome is Outcome.UNDECIDED


def test_a_scene_is_shown_in_motion_where_its_bodies_are_drawn() -> None:
    """From the certified enclosures; without a drawing, or without one step that is proved, there is none."""
    rod = Source("mechanism.toml", shipped_text("rod"), {})
    short = replace(report_scene("rod", rod), scene=load_scene("rod", until="1/1000"))
    run, moving = scene_parts(short, lambda _: None)
    assert moving.picture is not None
    assert moving.picture.name == "animation"
    assert "From the middles of certified enclosures" in moving.picture.svg
    assert moving.commands == ("gspot-verified simulate rod --budget 4000 --animation motion.svg",)
    assert (moving.outcome, run.picture) == (None, None)
    assert short.scene.mechanism is not None
    plain = replace(short.scene, mechanism=replace(short.scene.mechanism, drawing=None))
    (bare,) = scene_parts(replace(short, scene=plain), lambda _: None)
    assert bare.text == run.text


def test_what_fails_is_a_part_that_says_why() -> None:
    def fails(error: Exception) -> Callable[[], ReportPart]:
        def make() -> ReportPart:
            raise error

        return make

    assert attempted("T", fails(ValueError("the reason"))) == ReportPart("T", None, "nothing is stated: the reason")
    found = attempted("T", fails(UndecidedError("near 0")))
    assert found.outcome is Outcome.UNDECIDED
    with pytest.raises(ZeroDivisionError):
        attempted("T", fails(ZeroDivisionError()))


def test_the_outcome_of_several() -> None:
    open_one = Verdict.undecided("x", Reason.BUDGET)
    assert outcome_of([open_one]) is Outcome.UNDECIDED


def test_a_rejected_certificate_is_kept_as_rejected(exact: Subject, monkeypatch: pytest.MonkeyPatch) -> None:
    true_text = certified_force.certificate_text
    monkeypatch.setattr(certified_force, "certificate_text", lambda *a: true_text(*a).replace('"3/2"', '"5/3"', 1))
    (file,) = zeros_part(exact).certificates
    assert file.verified is False
    assert file.said.startswith("REJECTED ")
