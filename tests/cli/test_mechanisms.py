"""The commands expand, classify and iwc, as a user types them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from gspot_verified.cli import main
from gspot_verified.numbers.dyadic import Dyadic


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(list(arguments))
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_expand_prints_the_paper_s_example(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "expand", "extended", "--order", "7", "--chi", "symbolic")
    assert code == 0
    assert (
        "b/delta^2 = 2 s + 6*chi s^2 delta^2 + (12*chi^2 s^3 - 96*chi^2) delta^4 + (138/5*chi^3 s^4 - 10368/5*chi^3 s)"
        in out
    )
    code, out, _ = run(capsys, "expand", "extended", "--order", "7", "--in-time", "--json")
    assert code == 0
    assert [0, 4, "6672/5"] in json.loads(out)["contact"]["z"]


def test_expand_in_balls_when_they_are_asked_for(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "expand", "extended", "--order", "8", "--bits", "90")
    assert code == 0
    assert "certain bits" in out
    exact = run(capsys, "expand", "extended", "--order", "8", "--at", "1,1/10", "--json")[1]
    balls = run(capsys, "expand", "extended", "--order", "8", "--at", "1,1/10", "--bits", "90", "--json")[1]
    assert json.loads(exact)["accuracy"] is None
    assert json.loads(balls)["accuracy"]["reached"]
    for group in ("state", "contact"):
        for key, found in json.loads(exact)["at"][group].items():
            other = json.loads(balls)["at"][group][key]["enclosure"]
            assert Dyadic.parse(found["enclosure"]).overlaps(Dyadic.parse(other))


def test_expand_in_latex_at_a_point_and_with_a_bound(capsys: pytest.CaptureFixture[str]) -> None:
    assert r"\begin{align*}" in run(capsys, "expand", "extended", "--order", "5", "--latex")[1]
    code, out, _ = run(capsys, "expand", "extended", "--order", "8", "--at", "1,1/10")
    assert code == 0
    assert "p/delta^2 = [-0.989893" in out
    code, out, _ = run(capsys, "expand", "oscillator", "--order", "6", "--residual", "1,1/20", "--json")
    assert code == 0
    assert json.loads(out)["residual"]["contact"]["y"] == "0"


def test_an_equation_without_a_bound_is_undecided(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "expand", "rod", "--order", "4", "--residual", "1,100")
    assert code == 2
    assert "\n  p: no bound\n" in out


def test_the_picture_of_the_truncation_error(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    picture = tmp_path / "truncation.png"
    assert run(capsys, "expand", "extended", "--order", "12", "--picture", str(picture))[0] == 0
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert not list(tmp_path.glob("*.part"))


def test_classify(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, _ = run(capsys, "classify", "oscillator", "--verbose")
    assert code == 0
    assert "Case III" in out
    assert "beta = alpha_3/alpha_1 = 7/3" in out
    code, out, _ = run(capsys, "classify", "oscillator")
    assert code == 0
    assert out.splitlines()[1].split() == ["place", "slip", "u", "Case", "β", *["what", "happens", "as", "ε", "→", "0"]]
    assert "-0.6    III   7/3  lift-off if C1 > 0, impact without collision if C1 < 0" in out
    assert "alpha" not in out
    code, out, _ = run(capsys, "classify", "rod", "--json")
    assert code == 0
    assert json.loads(out)["case"] == "II"
    own = tmp_path / "own.toml"
    source = Path(__file__).parents[2] / "gspot_verified" / "mechanisms" / "data" / "extended_system.toml"
    own.write_text(source.read_text(encoding="utf-8").replace('"-3/2"', '"-5/2"'), encoding="utf-8")
    code, out, _ = run(capsys, "classify", str(own))
    assert code == 0
    assert "III   2.5  lift-off" in out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("expand", "nothing"), "no shipped mechanism"),
        (("expand", "missing.toml"), "cannot be read"),
        (("expand", "extended", "--order", "0"), "order"),
        (("expand", "extended", "--set", "chi"), "name=value"),
        (("expand", "extended", "--set", "nu=1"), "no parameter"),
        (("expand", "extended", "--set", "alpha_3=-2"), "integer 2"),
        (("expand", "extended", "--set", "alpha_1=1"), "must be negative"),
        (("expand", "extended", "--at", "1"), "two numbers"),
        (("expand", "extended", "--uniform", "1,2"), "three numbers"),
        (("expand", "extended", "--uniform", "2,1,1/20"), "start must be less than end"),
        (("expand", "extended", "--chi", "symbolic", "--residual", "1,1/10"), "symbols"),
        (("classify", "extended", "--set", "chi=0.1.2"), "chi"),
        (("iwc", "--beta", "2"), "integer"),
        (("iwc",), "beta"),
        (("cost", "nothing"), "expected"),
    ],
)
def test_bad_input_is_a_message_and_64(
    capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str
) -> None:
    code, out, err = run(capsys, *arguments)
    assert (code, out) == (64, "")
    assert message in err


def test_a_file_from_a_stranger_runs_no_code(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    trap = tmp_path / "trap"
    for formula in (f"__import__('pathlib').Path({str(trap)!r}).touch()", "9**9**9**9", "(" * 10_000):
        hostile = tmp_path / "hostile.toml"
        source = Path(__file__).parents[2] / "gspot_verified" / "mechanisms" / "data" / "extended_system.toml"
        text = source.read_text(encoding="utf-8").replace('mu = "1 - p"', f"mu = {json.dumps(formula)}")
        hostile.write_text(text, encoding="utf-8")
        code, _, err = run(capsys, "classify", str(hostile))
        assert code == 64
        assert "mu" in err
    assert not trap.exists()


def test_iwc(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "iwc", "--beta", "7/3")
    assert code == 0
    assert "every ε in (0, 0.630409760912546)" in out
    code, out, _ = run(capsys, "iwc", "--beta", "7/3", "--c1", "1", "--epsilon", "1/1000", "--json")
    assert code == 0
    assert json.loads(out)["leading_order"]["lift_off"]["zeros"] == 1


def test_the_verdict_of_iwc_is_one(capsys: pytest.CaptureFixture[str]) -> None:
    """epsilon lies between the two thresholds: the leading order is refuted, the compliant model proved."""
    code, out, _ = run(capsys, "iwc", "--beta", "7/3", "--eps", "0.65", "--json")
    data = json.loads(out)
    assert (code, data["verdict"]["outcome"], data["leading_order"]["verdict"]["outcome"]) == (0, "proved", "refuted")
    assert data["verdict"] == data["slow_manifold"]["verdict"]
    assert not {"epsilon_0", "largest_epsilon", "lift_off", "whole_line"} & {*data}


def test_a_value_at_a_point_needs_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    for more in ((), ("--in-time",), ("--json",)):
        code, out, err = run(capsys, "expand", "extended", "--chi", "symbolic", "--order", "6", "--at", "1,1/10", *more)
        assert (code, out) == (64, "")
        assert "numbers in the place of the symbols" in err


def test_a_proved_box_keeps_its_bits_at_high_orders(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    source = Path(__file__).parents[2] / "gspot_verified" / "mechanisms" / "data" / "falling_rod.toml"
    own = tmp_path / "own.toml"
    own.write_text(source.read_text(encoding="utf-8").replace("[g_spot]", "[g_spot]\nsearch = true"), encoding="utf-8")
    at = ("--order", "90", "--at", "1,1/10")
    balls = run(capsys, "expand", str(own), *at)[1].splitlines()
    exact = run(capsys, "expand", "rod", *at)[1].splitlines()
    assert len(balls) == 13
    assert balls[-1] == exact[-1]
    assert "is not proved" in balls[-1]
    for ball, number in zip(balls[:-1], exact[:-1], strict=True):
        assert ball[: ball.index("[") + 12] == number[: number.index("[") + 12]


def test_options_that_contradict_each_other_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments, message in (
        (("--chi", "1", "--set", "chi=2"), "chi is given twice"),
        (("--latex", "--in-time"), "--latex"),
        (("--latex", "--at", "1,1/10"), "--latex"),
    ):
        code, out, err = run(capsys, "expand", "extended", "--order", "4", *arguments)
        assert (code, out) == (64, "")
        assert message in err


def test_long_exponents_stand_in_braces_in_latex(capsys: pytest.CaptureFixture[str]) -> None:
    out = run(capsys, "expand", "extended", "--chi", "symbolic", "--order", "22", "--latex")[1]
    assert r"\chi^{10}" in out
    assert r"\chi^1" not in out


def test_a_picture_that_cannot_be_put_in_place_leaves_nothing(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    place = tmp_path / "folder"
    place.mkdir()
    assert run(capsys, "expand", "extended", "--order", "4", "--picture", str(place))[0] == 64
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]


def test_digits_of_an_expansion_in_balls(capsys: pytest.CaptureFixture[str]) -> None:
    name = "frictional impact oscillator, all parameters"
    code, out, _ = run(capsys, "expand", name, "--order", "12", "--digits", "40", "--at", "1,1/10", "--json")
    assert code == 0
    exact = json.loads(
        run(capsys, "expand", "oscillator", "--order", "12", "--digits", "40", "--at", "1,1/10", "--json")[1]
    )
    for key, value in json.loads(out)["at"]["contact"].items():
        assert len(value["value"]) > 38
        assert value["value"][:38] == exact["at"]["contact"][key]["value"][:38]


def test_accuracy_that_is_not_reached_is_said_on_stderr_and_by_the_exit_code(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from gspot_verified.expansion import trajectory

    monkeypatch.setattr(trajectory, "certain_bits", lambda _: 7)
    monkeypatch.setattr("gspot_verified.expansion.trajectory.certain_bits", lambda _: 7)
    code, out, err = run(capsys, "expand", "frictional impact oscillator, all parameters", "--order", "3")
    assert code == 2
    assert "NOT REACHED" in out
    assert "warning: ACCURACY NOT REACHED" in err


def test_expand_warns_of_a_force_that_would_pull(capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "expand", "extended", "--order", "3", "--set", "alpha_3=-1/2")
    assert code == 0
    assert "warning: the mean force is negative" in err
    assert "warning" not in run(capsys, "expand", "extended", "--order", "3")[2]


def test_iwc_of_a_mechanism(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "iwc", "--mechanism", "oscillator", "--set", "beta=5/2", "--digits", "5")
    assert code == 0
    assert "β = 5/2" in out
    for arguments, message in (
        (("--mechanism", "oscillator", "--beta", "5/2"), "the mechanism has its own"),
        (("--mechanism", "oscillator", "--alpha2", "-1"), "the mechanism has its own"),
        (("--beta", "5/2", "--set", "mu=2"), "--set: it goes with --mechanism"),
    ):
        code, out, err = run(capsys, "iwc", *arguments)
        assert (code, out) == (64, "")
        assert message in err


def test_classify_finds_all_g_spots_or_proves_that_there_is_none(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, out, err = run(capsys, "classify", "genot_brogliato_rod", "--set", "mu=13/10")
    assert code == 1
    assert "all G-spots are searched instead" in err
    assert "p > 0 everywhere in contact there" in out
    assert "lies below it: p > 0" in out
    code, out, err = run(capsys, "classify", "genot_brogliato_rod", "--set", "mu=7/5", "--all", "--json")
    assert code == 0
    assert err == ""
    assert len(json.loads(out)["spots"]) == 4
    code, out, _ = run(capsys, "classify", "genot_brogliato_rod", "--set", "mu=4/3")
    assert code == 2
    assert "a fold" in out
    own = tmp_path / "own.toml"
    source = Path(__file__).parents[2] / "gspot_verified" / "mechanisms" / "data" / "falling_rod.toml"
    own.write_text(source.read_text(encoding="utf-8").split("[g_spot]")[0], encoding="utf-8")
    code, out, _ = run(capsys, "classify", str(own))
    assert code == 0
    assert "exactly 4 G-spots" in out
    assert "note: X_dot stands in u, and no condition holds it" in out


def test_a_place_that_is_no_g_spot_for_these_parameters_is_no_wrong_usage(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "classify", "rod", "--set", "mu=13/10")
    assert code == 1
    assert "not a G-spot: p = 131/125 must be 0 at the place given, with these parameters" in err
    assert "all G-spots are searched instead" in err
    assert "lies below it: p > 0 in every configuration in contact with a positive definite mass matrix" in out
    code, out, err = run(capsys, "classify", "rod", "--set", "mu=2", "--json")
    assert code == 0
    assert "not a G-spot" in err
    data = json.loads(out)
    assert data["search"]["complete"] is True
    assert len(data["spots"]) == 4
    code, _, err = run(capsys, "expand", "rod", "--set", "mu=13/10")
    assert code == 64
    assert "classify --all" in err


def test_the_number_of_a_g_spot_serves_in_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    """The oscillator's first: the same β in the table, in JSON, in the expansion's system and in the force's."""
    code, out, _ = run(capsys, "classify", "oscillator", "--all")
    assert code == 0
    first = next(line for line in out.splitlines() if line.startswith("  1 "))
    assert "III   2.26796   lift-off if C1 > 0" in first
    spots = json.loads(run(capsys, "classify", "oscillator", "--all", "--json")[1])["spots"]
    assert [spot["number"] for spot in spots] == [1, 2, 3, 4, 5, 6]
    assert spots[0]["beta"].startswith("[2.26795975")
    assert json.loads(run(capsys, "classify", "oscillator", "--json")[1])["number"] is None
    code, out, _ = run(capsys, "iwc", "--mechanism", "oscillator", "--spot", "1", "--digits", "5", "--tau-start=-2")
    assert code == 0
    assert "Case III: β = [2.26795975" in out
    code, out, _ = run(capsys, "expand", "oscillator", "--spot", "1", "--order", "3", "--json")
    assert code == 0
    assert json.loads(out)["accuracy"]["reached"]
    code, out, _ = run(capsys, "expand", "oscillator", "--spot", "2", "--order", "3", "--json")
    assert json.loads(out)["accuracy"] is None


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("expand", "oscillator", "--spot", "9"),
            "has 6 G-spots in the region searched by default (classify --all lists them): expected a number in 1..6",
        ),
        (("iwc", "--mechanism", "oscillator", "--spot", "0"), "has 6 G-spots"),
        (("iwc", "--beta", "7/3", "--spot", "1"), "--spot: it goes with --mechanism"),
        (("plot", "phase-plane", "x.png", "--spot", "9"), "has 6 G-spots"),
        (("plot", "theta", "x.png", "--spot", "1"), "the figure theta takes no option"),
        (("approach", "rod", "--spot", "9", "--from", "theta=0"), "has 4 G-spots"),
    ],
)
def test_a_wrong_number_is_refused(
    capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, *arguments)
    assert (code, out) == (64, "")
    assert message in err
    assert list(tmp_path.iterdir()) == []


def test_what_no_mechanism_can_have_is_refused(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    source = Path(__file__).parents[2] / "gspot_verified" / "mechanisms" / "data" / "falling_rod.toml"
    own.write_text(source.read_text(encoding="utf-8").replace("m = 1\n", "m = -1\n"), encoding="utf-8")
    for arguments in (("classify", "--all"), ("expand",), ("sweep", "--over", "mu=1..2:2")):
        code, out, err = run(capsys, arguments[0], str(own), *arguments[1:])
        assert (code, out) == (64, "")
        assert f"{own}: falling rod: the mass m is -1: it must not be negative" in err


def test_the_paradox_proper_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "classify", "genot_brogliato_rod", "--box", "theta=4/5..6/5")
    assert code == 1
    region = "theta in [4/5, 6/5]; every value of theta_dot; X = 0, X_dot = 2 fixed"
    line = f"falling rod of Génot and Brogliato has no G-spot in the region (refuted that there is one): {region}"
    assert out.splitlines()[0] == line
    assert "p < 0 everywhere in contact there: the Painlevé paradox proper" in out
    assert "; of all configurations, not of the box alone\n" in out
    assert "exit code 1: there is none in the region, proved." in " ".join(run(capsys, "classify", "--help")[1].split())


def test_classify_in_a_box_and_with_a_budget(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "classify", "genot_brogliato_rod", "--box", "theta=0..1", "--box", "theta_dot=0..10")
    assert code == 0
    assert "exactly one G-spot" in out
    code, out, _ = run(capsys, "classify", "genot_brogliato_rod", "--box", "theta=2..3")
    assert code == 1
    code, out, _ = run(capsys, "classify", "genot_brogliato_rod", "--budget", "1")
    assert code == 2
    assert "the budget of boxes ended" in out


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--box", "theta"), "lower..upper"),
        (("--box", "theta=0"), "lower..upper"),
        (("--box", "theta=0..inf"), "finite"),
        (("--box", "theta=0..1", "--box", "theta=1..2"), "given twice"),
        (("--box", "phi=0..1"), "no component of the state"),
        (("--budget", "-3"), "budget"),
    ],
)
def test_bad_boxes_are_usage_errors(capsys: pytest.CaptureFixture[str], options: tuple[str, ...], message: str) -> None:
    code, _, err = run(capsys, "classify", "genot_brogliato_rod", *options)
    assert code == 64
    assert message in err


def test_expand_uniform_says_how_far_true_solutions_are(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "expand", "extended", "--order", "4", "--uniform=-1/4,1/4,1/20")
    assert code == 0
    assert "proved: every solution in contact within 1 delta^4 of the expansion at s = -1/4" in out
    assert "K of lambda_n: [" in out
    code, out, _ = run(capsys, "expand", "extended", "--order", "4", "--uniform=0,1,9", "--json")
    assert code == 2
    assert json.loads(out)["uniform"]["verdict"]["reason"]


def test_expand_side_says_what_a_family_near_the_g_spot_does(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "expand", "extended", "--order", "8", "--side=-1,1/50")
    assert code == 0
    assert "for every 0 < epsilon <= 1/125000" in out
    assert "contact is lost" in out
    code, out, _ = run(capsys, "expand", "extended", "--order", "8", "--side=-1,1/5", "--json")
    assert (code, json.loads(out)["side"]["side"]) == (2, None)
