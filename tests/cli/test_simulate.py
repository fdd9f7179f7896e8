"""The commands ``simulate`` and ``scenes``: exit codes, text, files, bad input."""

from __future__ import annotations

import csv
import json
import math
import re
import shutil
from dataclasses import replace
from importlib import resources
from pathlib import Path

import numpy as np
import pytest
from full_disk import full_after

from gspot_verified import load
from gspot_verified.cli import main
from gspot_verified.cli.commands.simulate_command import _not_integrated
from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.scenes.certified import run_steps
from gspot_verified.scenes.scene.before_spot import scene_before_spot


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


def test_a_certified_run(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("--beta", "3/2", "--nu", "2", "--eps", "1e-3")
    code, output, _ = run(capsys, "simulate", "fig-varsim1", *words)
    assert code == 0
    assert output.startswith("certified: lift-off, touch-down, impact without collision\n  proved: exactly one flight")
    assert "lift-off: t = [0.535370832662700" in output


@pytest.mark.parametrize(("u", "code"), [("70", 0), ("1/10", 1)])
def test_a_start_that_decides_and_is_not_integrated_is_named(
    capsys: pytest.CaptureFixture[str], u: str, code: int
) -> None:
    """What leaving stick out assumes is asked of u, which is none of the states without tangential_motion."""
    words = ("extended", "--drop-effect", "stick", "--drop-effect", "tangential_motion", "--set", f"u={u}")
    found, output, _ = run(capsys, "simulate", *words)
    assert found == code
    assert f"at the start, not integrated: u = {u}\n" in output
    _, output, _ = run(capsys, "simulate", *words, "--json")
    assert json.loads(output)["scene"]["start_not_integrated"] == {"u": u}


def test_the_clock_at_the_start_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    """The forces of a shaken base depend on it; it is 0 where it is not given."""
    base = resources.files("gspot_verified") / "mechanisms" / "data" / "gallery" / "rod_on_a_shaken_base.toml"
    place = ("--set", "theta=62400181/100000000", "--set", "theta_dot=98644581/100000000", "--until", "1/10000")
    for given, t in (((), "0"), (("--set", "t=3"), "3")):
        _, output, _ = run(capsys, "simulate", str(base), "--spot", "1", *place, *given)
        assert re.search(rf"at the start, not integrated: .*\bt = {t}\n", output)


def test_both_side_by_side_with_files(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table, arrays = tmp_path / "run.csv", tmp_path / "run.npz"
    words = ("fig-varsim1", "--compare", "--csv", str(table), "--npz", str(arrays), "--json")
    code, output, _ = run(capsys, "simulate", *words)
    data = json.loads(output)
    assert code == 0
    assert data["agree"] is True
    assert [found["strength"] for found in data["runs"]] == ["certified", "simulated"]
    with table.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    with np.load(arrays) as found:
        assert found["lambda_N"].tolist() == [float(row["lambda_N"]) for row in rows]
        assert found["phase"].tolist() == [row["phase"] for row in rows]
    assert {row["phase"] for row in rows} == {"slip", "flight"}
    assert sorted(tmp_path.iterdir()) == [table, arrays]


def test_a_certificate_and_its_check(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / "run.cert"
    words = ("fig-varsim1", "--eps", "1/20", "--until", "1/4", "--certificate", str(file))
    code, output, _ = run(capsys, "simulate", *words)
    assert code == 0
    assert output.endswith(f"  certificate of this run: {file}\n")
    code, output, _ = run(capsys, "check", str(file))
    assert code == 0
    assert output.startswith("VERIFIED the model system with compliant_contact, lift_off, ε = 1/20, ")
    assert output.endswith(": no change of phase, until t = 1/4\n")


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (("stribeck",), "certificates of runs need a friction coefficient that is a number"),
        (("fig-varsim1", "--float", "--points", "3"), "--float, --points: not together with --certificate"),
        (("fig-varsim1", "--route", "exact"), "--route: not together with --certificate"),
    ],
)
def test_no_certificate_of_such_a_run(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, words: tuple[str, ...], why: str
) -> None:
    code, _, errors = run(capsys, "simulate", *words, "--certificate", str(tmp_path / "run.cert"))
    assert code == 64
    assert why in errors
    assert not any(tmp_path.iterdir())


def test_an_undecided_run_has_no_certificate(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    words = ("fig-varsim1", "--eps", "1/20", "--budget", "1", "--json", "--certificate", str(tmp_path / "run.cert"))
    code, output, errors = run(capsys, "simulate", *words)
    assert code == 2
    assert json.loads(output)["runs"][0]["fate"] == "open"
    assert "--certificate: the run is not proved" in errors
    assert not any(tmp_path.iterdir())


def test_floats_alone_prove_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "simulate", "fig-varsim2", "--float", "--set", "chi=0")
    assert code == 2
    assert output.startswith("simulated: stick, lift-off")
    assert "\n    reason: a float run proves nothing\n" in output
    assert "hypothesis" not in output


@pytest.mark.parametrize(("until", "fate"), [("1/2", "lift-off"), ("2/5", "no event")])
def test_how_long_to_look(capsys: pytest.CaptureFixture[str], until: str, fate: str) -> None:
    """The lift-off is at 0.4411..., and the scene's own time is 1."""
    code, output, _ = run(capsys, "simulate", "fig-varsim2", "--until", until, "--json")
    data = json.loads(output)
    assert (code, data["scene"]["until"], data["runs"][0]["fate"]) == (0, until, fate)
    said = "no change of phase" if fate == "no event" else fate
    assert data["runs"][0]["verdict"]["statement"].startswith(f"{said} until t = {until} after the start")


def test_the_exact_solution_answers_for_all_times(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "simulate", "fig-varsim1", "--until", "1/10", "--compare", "--json")
    data = json.loads(output)
    assert code == 0
    assert [found["fate"] for found in data["runs"]] == ["lift-off, touch-down, impact without collision", "no event"]
    assert data["agree"] is None


def test_what_is_left_out_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "simulate", "oscillator", "--float", "--eps", "1/50", "--set", "until=1/10")
    assert code == 2
    assert "oscillator, ε = 1/50, from phi - phi_ref = 1/10, phi_dot = -9/10, y = 0, v = 0, z = 0\n" in output
    assert "  without tangential_motion: the slip velocity stays positive: the contact never sticks\n" in output
    assert "  without tangential_motion, the slip velocity is positive in contact: assumed from t = 0 " in output
    assert "chi" not in output


def test_enclosures_in_files_and_a_picture(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table, drawing = tmp_path / "run.csv", tmp_path / "run.svg"
    words = ("fig-varsim1", "--points", "9", "--csv", str(table), "--picture", str(drawing))
    code, _, _ = run(capsys, "simulate", *words)
    assert code == 0
    with table.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    times = [float(row["t"]) for row in rows]
    lift, land = 0.5353708326627003, 0.693119756350954
    assert times == pytest.approx([0, 0.125, 0.25, 0.375, 0.5, lift, lift, 0.625, land], abs=1e-14)
    assert [row["phase"] for row in rows] == ["slip"] * 6 + ["flight"] * 3
    assert all(0 < float(row["b_radius"]) < 1e-9 for row in rows)
    assert drawing.read_text(encoding="utf-8").startswith("<svg")
    assert sorted(tmp_path.iterdir()) == [table, drawing]


def test_an_animation_of_the_float_run(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    place = tmp_path / "rod.svg"
    words = ("simulate", "rod", "--epsilon", "1/100", "--float", "--points", "21", "--animation", str(place))
    assert run(capsys, *words)[0] == 2
    text = place.read_text(encoding="utf-8")
    assert "From a run with floats" in text
    assert "<animate " in text


@pytest.mark.slow
def test_an_animation_of_a_certified_run(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """No points are asked for: the integrator has its own."""
    place = tmp_path / "rod.svg"
    words = ("simulate", "rod", "--epsilon", "1/100", "--until", "1/20", "--animation", str(place))
    assert run(capsys, *words)[0] == 0
    assert "From the middles of certified enclosures" in place.read_text(encoding="utf-8")


def test_a_journal_that_cannot_be_written(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The result is printed, the exit code says that a file is missing, and the journal stays good."""
    kept = tmp_path / "run.journal"
    words = ("simulate", "oscillator", "--float", "--eps", "1/50", "--set", "until=1/10", "--journal", str(kept))
    full_after(9_000, kept, monkeypatch)
    code, output, errors = run(capsys, *words)
    assert code == 74
    assert "No space left on device; the run went on without it" in errors
    monkeypatch.undo()
    again, same, _ = run(capsys, *words)
    assert (again, same) == (2, output)


def test_a_certified_run_goes_on(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Out of budget, then on from the journal to the answer of a run without one; the float run has its own file."""
    kept = tmp_path / "run.journal"
    words = ("simulate", "fig-varsim2", "--eps", "1/10", "--set", "chi=0", "--until", "3/2")
    _, whole, _ = run(capsys, *words)
    code, output, _ = run(capsys, *words, "--journal", str(kept), "--budget", "3")
    assert code == 2
    assert "the budget of 3 steps ended (t = " in output
    assert len(kept.read_text().splitlines()) == 4
    assert run(capsys, *words, "--journal", str(kept)) == (0, whole, "")
    run(capsys, *words, "--journal", str(kept), "--compare")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.journal", "run.journal.float"]


def test_what_a_run_may_cost_is_said_before_its_steps(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Once, with the first sign of life."""
    monkeypatch.setattr(run_steps, "QUIET_SECONDS", 0.0)
    _, _, errors = run(capsys, "simulate", "rod", "--until", "1/200", "--budget", "3")
    first, second, *others = errors.splitlines()
    assert first.startswith("... the fastest oscillation at the start has 515 radians in a unit of time")
    assert "192 bits: slip at t = " in second
    assert not any("oscillation" in line for line in others)


def test_a_contradiction_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    """On the canard: what floats find depends on their rounding, and is said where it is wrong."""
    code, output, errors = run(capsys, "simulate", "fig-varsim1", "--nu", "1", "--compare", "--json")
    data = json.loads(output)
    assert code == 0
    assert data["runs"][0]["fate"] == "trivial solution"
    assert data["agree"] is (False if data["runs"][1]["events"] else None)
    assert ("contradicts" in errors) is (data["agree"] is False)


def test_the_list(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "scenes")
    assert code == 0
    assert "fig-varsim1 (model): compliant_contact, lift_off\n" in output
    assert "mechanism and two_way_coupling: chi belongs to the model system" in output
    assert "two_way_coupling: the normal motion does not act back" in output


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("fig-varsim1", "--eps", "0"), "epsilon must be > 0"),
        (("fig-varsim1", "--eps", "-1e-3"), "epsilon must be > 0"),
        (("fig-varsim1", "--set", "chi=1"), "no setting 'chi'"),
        (("fig-varsim1", "--set", "nu"), "expected name=value"),
        (("fig-varsim2", "--budget", "0"), "budget must be >= 1, got 0"),
        (("fig-varsim1", "--picture", "a.jpg"), "allowed: .png, .pdf, .svg"),
        (("rod", "--animation", "a.png"), "--animation: cannot write the suffix '.png' of a.png; allowed: .svg"),
        (("fig-varsim1", "--animation", "a.svg"), "no animation: the model system of the paper has no bodies"),
        (("fig-varsim1", "--float", "--points", "1", "--csv", "a.csv"), "points: expected 2..1000000, got 1"),
        (("oscillator", "--nu", "1"), "no setting 'nu'"),
        (("fig-varsim1", "--float", "--compare"), "not both"),
        (("fig-varsim1", "--float", "--method", "RK"), "method: expected one of"),
        (("fig-varsim1", "--float", "--csv", "a.txt"), "allowed: .csv"),
        (("nothing",), "no scene file 'nothing'"),
        (("fig-varsim2", "--until", "0"), "until must be > 0, got 0"),
        (("fig-varsim2", "--until=-1"), "until must be > 0, got -1"),
        (("fig-varsim2", "--until", "inf"), "until: expected a number"),
        (("fig-varsim2", "--until", "1 s"), "until: '1 s' has a unit (s)"),
        (("fig-varsim2", "--until", "1/0"), "until: the denominator of '1/0' is zero"),
        (("fig-varsim2", "--until", "1e9999"), "until: a number of"),
        (("fig-varsim2", "--until", "1", "--set", "until=2"), "give --until or --set until=..., not both"),
        (("fig-varsim2", "--eps", "1", "--set", "epsilon=2"), "give --epsilon or --set epsilon=..., not both"),
        (("fig-varsim2", "--epsilon", "1", "--set", "eps=2"), "give --epsilon or --set eps=..., not both"),
    ],
)
def test_bad_input(capsys: pytest.CaptureFixture[str], words: tuple[str, ...], message: str) -> None:
    code, output, errors = run(capsys, "simulate", *words)
    assert code == 64
    assert output == ""
    assert errors.startswith("error: ")
    assert message in errors


HOSTILE = Path(__file__).parents[1] / "scenes" / "hostile"


@pytest.mark.parametrize("name", ["left_out_effect", "g_touch", "c_notang_neg", "pulls"])
def test_an_absence_that_is_wrong_has_exit_code_1(capsys: pytest.CaptureFixture[str], name: str) -> None:
    """Each was "certified ... proved", with exit code 0."""
    code, output, _ = run(capsys, "simulate", str(HOSTILE / f"{name}.toml"))
    assert code == 1
    assert re.search(r"\n  refuted: .* until t = .*, as leaving \w+ out assumes\n", output)
    assert "proved" not in output
    assert ": violated at t = " in output


def test_assumptions_as_json(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    (tmp_path / "block.toml").write_text((HOSTILE / "block.toml").read_text())
    text = (HOSTILE / "c_notang_neg.toml").read_text().replace("until = 2", 'until = "1/10"')
    found = {}
    for start in ("X_dot = -1", "X_dot = 1", ""):
        (tmp_path / "scene.toml").write_text(text.replace("X_dot = -1", start))
        code, output, _ = run(capsys, "simulate", str(tmp_path / "scene.toml"), "--json")
        data = json.loads(output)["runs"][0]
        (each,) = data["assumptions"]
        assert (each["effect"], each["assumes"]) == ("tangential_motion", "the slip velocity is positive in contact")
        assert (each["time"] is None) is (each["standing"] == "checked")
        found[start] = (code, each["standing"], "provided that" in data["verdict"]["statement"])
    assert found == {
        "X_dot = -1": (1, "violated", False),
        "X_dot = 1": (0, "checked", False),
        "": (0, "assumed", True),
    }


def test_a_start_on_the_slow_manifold_says_what_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "simulate", "fig-varsim1", "--beta", "1/2", "--set", "start=slip", "--route", "exact")
    assert code == 0
    assert "  start on slip: an exact point next to its slow manifold, from the expansion to epsilon^" in output
    assert "about e^(-0.01559/ε) = 1.7e-07 is left where rigid slip reaches the G-spot, t = 0.5 (floats)\n" in output
    assert ", v = -0.0000119812" in output  # a decimal
    _, output, _ = run(capsys, "simulate", "fig-varsim1", "--beta", "1/2", "--route", "exact", "--json")
    scene = json.loads(output)["scene"]
    assert scene["slow_start"] is None
    assert scene["fast_part"]["factor"] == pytest.approx(math.exp(-1000 * scene["fast_part"]["exponent"]))


def test_effects_are_added_and_dropped(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("simulate", "fig-varsim1", "--float", "--until", "1/100", "--json")
    _, output, _ = run(capsys, *words, "--add-effect", "tangential_motion", "--add-effect", "stick", "--set", "u=70")
    scene = json.loads(output)["scene"]
    assert scene["effects"] == ["compliant_contact", "lift_off", "tangential_motion", "stick"]
    assert [cost["effect"] for cost in scene["costs"]] == ["lift_off", "tangential_motion", "stick"]
    _, output, _ = run(capsys, *words[:-1], "--drop-effect", "lift_off")
    assert "  4 states and 11 operations in slip\n" in output
    assert "  without lift_off: the contact is never lost: the surface may pull\n" in output
    code, _, errors = run(capsys, *words, "--drop-effect", "stick")
    assert code == 64
    assert "effect 'stick' is not in the scene" in errors


def test_a_mechanism_starts_before_its_g_spot(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """A name and the path of a file give the same; parameters are changed before the G-spot is sought."""
    place = Path(str(resources.files("gspot_verified.mechanisms") / "data" / "falling_rod.toml"))
    shutil.copy(place, tmp_path / "mine.toml")
    shown = []
    for name in ("rod", str(tmp_path / "mine.toml")):
        assert main(["simulate", name, "--spot", "1", "--float", "--eps", "1/100"]) == 2
        shown.append(capsys.readouterr().out)
    assert shown[0] == shown[1]
    assert "slip before falling rod, G-spot 1, ε = 1/100, from theta - theta_ref = -" in shown[0]
    words = ["simulate", "genot_brogliato_rod", "--spot", "1", "--float", "--set", "mu=5/2", "--json"]
    assert main(words) == 2
    assert "slip before falling rod of" in json.loads(capsys.readouterr().out)["scene"]["name"]


def test_what_was_set_is_in_the_text(capsys: pytest.CaptureFixture[str]) -> None:
    """Parameters of the mechanism with the name, those of the model and of effects in a line of their own."""
    words = ["simulate", "rod", "--float", "--eps", "1/10", "--until", "1/100", "--set", "mu=3/2"]
    assert main([*words, "--add-effect", "belt", "--set", "belt_velocity=-1/2"]) == 2
    output = capsys.readouterr().out
    assert "\n  rod, mu = 3/2, ε = 1/10, from theta" in output
    assert "\n  with k_1 = 1, k_2 = 1, damping = 1, belt_velocity = -1/2\n" in output
    assert main([*words, "--json"]) == 2
    assert json.loads(capsys.readouterr().out)["scene"]["name"] == "rod, mu = 3/2"
    assert main([*words, "--set", f"m={'1' * 40}/{'1' * 39}2", "--set", "l=1.23456", "--json"]) == 2
    name = json.loads(capsys.readouterr().out)["scene"]["name"]
    assert name == f"rod, m = {'1' * 40}/{'1' * 39}2, l = 1.23456, mu = 3/2"  # no value is cut off
    assert main(["simulate", "rod", "--spot", "1", "--float", "--until", "1/1000", "--set", "mu=2"]) == 2
    assert "\n  slip before falling rod, mu = 2, G-spot 1, ε = " in capsys.readouterr().out
    assert main(["simulate", "fig-varsim1", "--float", "--eps", "1/10", "--until", "1/10", "--beta", "5/2"]) == 2
    output = capsys.readouterr().out
    assert "\n  with k_1 = 1, k_2 = 1, damping = 1, alpha_1 = -1, alpha_2 = -1, beta = 5/2\n" in output


def test_the_note_on_the_compliance_is_that_of_the_run(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """The file of the mechanism has k_1 = 2: the note said so beside a run with another one, too."""
    text = shipped_text("falling rod").replace("[drawing]", "[regularisation]\nk_1 = 2\n\n[drawing]")
    (tmp_path / "soft.toml").write_text(text, encoding="utf-8")
    words = ["simulate", str(tmp_path / "soft.toml"), "--spot", "1", "--float", "--eps", "1/10", "--until", "1/100"]
    assert main(words) == 2
    assert "\n  note: compliance k_1 = 2/epsilon^2, k_2" in capsys.readouterr().out
    assert main([*words, "--set", "k_1=5"]) == 2
    assert "\n  note: compliance k_1 = 5/epsilon^2, k_2" in capsys.readouterr().out
    assert main([*words, "--set", "k_1=1"]) == 2
    assert "note: compliance" not in capsys.readouterr().out


def test_it_is_said_which_way_u_and_a_belt_count(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """The falling rod to the left: as the mirrored mechanism slips forwards, a belt moves against the x of the file."""
    text = shipped_text("falling rod").replace('"X + l*cos(theta)"\n', '"X - l*cos(theta)"\nslip = "negative"\n')
    (tmp_path / "left.toml").write_text(text.replace("X_dot = 2", "X_dot = -2"), encoding="utf-8")
    words = ["simulate", str(tmp_path / "left.toml"), "--spot", "1", "--float", "--eps", "1/10"]
    assert main(words) == 2
    assert "\n  note: negative slip: mirrored, x counts in the opposite direction" in capsys.readouterr().out
    assert main([*words, "--json"]) == 2
    (note,) = json.loads(capsys.readouterr().out)["scene"]["notes"]
    assert note.endswith("; the velocity of a surface counts as u does")
    assert main(["simulate", "rod", "--spot", "1", "--float", "--eps", "1/10", "--json"]) == 2
    assert json.loads(capsys.readouterr().out)["scene"]["notes"] == []


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["genot_brogliato_rod"], "is a mechanism, not a scene: with a G-spot's number, --spot 1"),
        (["mine.toml"], "mine.toml: this is a mechanism, not a scene"),
        (["fig-varsim1", "--spot", "1"], "fig-varsim1"),
        (["rod", "--spot", "9"], "G-spot"),
        (["genot_brogliato_rod", "--spot", "2"], "no start before it: no Case: alpha_1 is not negative"),
        (["genot_brogliato_rod", "--spot", "1", "--set", "mu=1"], "G-spot"),
        (["rod", "--spot", "1", "--nu", "2"], "nu"),
    ],
)
def test_what_is_no_start_before_a_g_spot(
    words: list[str], said: str, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = Path(str(resources.files("gspot_verified.mechanisms") / "data" / "falling_rod.toml"))
    shutil.copy(place, tmp_path / "mine.toml")
    monkeypatch.chdir(tmp_path)
    assert main(["simulate", *words]) == 64
    assert said in capsys.readouterr().err


@pytest.mark.parametrize("words", [(), ("--float",), ("--compare",), ("--route", "exact")])
def test_points_go_with_a_file(capsys: pytest.CaptureFixture[str], words: tuple[str, ...]) -> None:
    code, _, errors = run(capsys, "simulate", "fig-varsim1", *words, "--points", "5")
    assert code == 64
    assert "--points: it goes with --csv, --npz, --picture or --animation" in errors


def test_what_the_exact_solution_has_no_use_for_is_said(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    words = ("simulate", "fig-varsim1", "--beta", "1/2", "--journal", str(tmp_path / "j"), "--budget", "7")
    code, output, errors = run(capsys, *words)
    assert code == 0
    assert output.startswith("certified: impact without collision")
    assert "--journal: the exact solution decided this run" in errors
    assert "--budget: the exact solution decided this run" in errors
    assert not any(tmp_path.iterdir())


def test_the_file_of_the_scenes_mechanism_is_not_replaced(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    own, scene = tmp_path / "own.toml", tmp_path / "scene.toml"
    own.write_text(shipped_text("rod"), encoding="utf-8")
    text = (resources.files("gspot_verified.scenes") / "data" / "rod.toml").read_text(encoding="utf-8")
    scene.write_text(re.sub(r"(?m)^mechanism = .*$", 'mechanism = "own.toml"', text), encoding="utf-8")
    for option, place in (("--certificate", own), ("--certificate", scene), ("--journal", own)):
        code, _, errors = run(capsys, "simulate", str(scene), option, str(place))
        assert code == 64
        assert "is what the command reads" in errors
    assert own.read_text(encoding="utf-8") == shipped_text("rod")


@pytest.mark.parametrize(
    "words",
    [
        ("fig-varsim1", "--set", "eps=1/10", "--set", "epsilon=1/100"),
        ("fig-varsim1", "--set", "b=-1", "--nu", "2"),
    ],
)
def test_one_setting_under_two_names(capsys: pytest.CaptureFixture[str], words: tuple[str, ...]) -> None:
    code, _, errors = run(capsys, "simulate", *words)
    assert code == 64
    assert "are both given: give one of them" in errors


def test_a_parameter_with_the_name_of_a_setting(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """With --spot it was the mechanism's that changed, in a scene the scene's."""
    own = tmp_path / "own.toml"
    own.write_text(shipped_text("rod").replace("[parameters]", "[parameters]\nepsilon = 1"), encoding="utf-8")
    code, _, errors = run(capsys, "simulate", str(own), "--spot", "1", "--epsilon", "1/100")
    assert code == 64
    assert "'epsilon' is a parameter of falling rod and a setting of every scene" in errors


def test_a_parameter_of_a_spots_mechanism_and_of_an_effect_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Before a G-spot --set k_1 changed the mechanism's own k_1, and the stiffness of the contact stayed 1."""
    own = tmp_path / "own.toml"
    own.write_text(
        re.sub(r"\bl\b", "k_1", shipped_text("rod").partition("[drawing]")[0]) + "[g_spot]\n", encoding="utf-8"
    )
    code, _, err = run(capsys, "simulate", str(own), "--spot", "1", "--float", "--set", "k_1=1")
    assert code == 64
    assert "'k_1' is one of the mechanism and of an effect" in err


def test_a_clock_that_no_start_gives_is_0() -> None:
    base = resources.files("gspot_verified") / "mechanisms" / "data" / "gallery" / "rod_on_a_shaken_base.toml"
    scene = scene_before_spot(load(str(base)), 1)
    without = replace(scene, start={name: value for name, value in scene.start.items() if name != "t"})
    assert "t" in scene.start
    assert _not_integrated(without)["t"] == "0"


def test_the_nu_of_the_model_says_its_b(capsys: pytest.CaptureFixture[str]) -> None:
    """It was named as if it were a component that is not integrated."""
    output = run(capsys, "simulate", "fig-varsim1", "--beta", "5/2", "--nu", "4")[1]
    assert "from p = 1/2, b = -4/3, " in output
    assert "not integrated: nu" not in output
