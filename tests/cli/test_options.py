"""No option is left aside in silence, and what a command does not take is said before the work, with what it takes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gspot_verified.cli import main
from gspot_verified.cli.app import refuse


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


@pytest.fixture
def no_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every piece of work that these commands may start fails the test."""

    def started(*_: Any, **__: Any) -> None:
        raise AssertionError("the work was started")

    for place in (
        "report.plot.plot",
        "scenes.simulate.simulate",
        "compliant.side.side_rule.side_rule",
        "signs.gamma.side.side",
        "signs.zeros.brackets.zeros_at",
        "signs.zeros.zeros.zeros_on_range",
        "compliant.zeros.zero_count.slow_zeros",
        "compliant.zeros.zero_map.zero_map",
        "mechanisms.iwc.iwc",
        "mechanisms.approach.approach.approach",
        "signs.cover.sign.sign",
    ):
        monkeypatch.setattr(f"gspot_verified.{place}", started)


STATE = "1/2,-1/10,0,0,0"


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("plot", "force", "x.png", "--beta", "9"), "--beta: the figure force takes no option"),
        (("plot", "theta", "x.png", "--mechanism", "rod"), "--mechanism: the figure theta takes no option"),
        (("plot", "b-hat", "x.png", "--eps", "1"), "--epsilon: the figure b-hat takes --beta"),
        (
            ("plot", "contact-force", "x.png", "--set", "mu=2", "--from", "p=1"),
            "--set, --from: the figure contact-force takes --beta, --epsilon",
        ),
        (("plot", "phase-plane", "x.png", "--beta", "3"), "phase-plane takes --mechanism, --set, --spot, --from"),
        (("plot", "side-map", "x.png", "--epsilon", "1"), "--epsilon: the figure side-map takes no option"),
        (("plot", "threshold", "x.png", "--beta", "1"), "--beta: the figure threshold takes no option"),
        (("side", "5/2", "4", "--state", STATE), "--state: it needs one β, not the range 5/2..4"),
        (("side", "5/2", "--beta", "4", "--state", STATE), "--beta: β is given as an argument already"),
        (("side", "--state", STATE), "β: give it as an argument or with --beta"),
        (("side", "5/2", "--eps", "1/10", "--alpha2", "1"), "--epsilon, --alpha2: it goes with --state"),
        (("simulate", "fig-varsim1", "--float", "--route", "exact"), "--route: it is for a certified run"),
        (("simulate", "fig-varsim1", "--float", "--digits", "9"), "--digits: it is for a certified run"),
        (("simulate", "fig-varsim1", "--method", "BDF"), "--method: it is for a float run; add --float or --compare"),
        (("simulate", "fig-varsim1", "--tolerance", "1e-5"), "--tolerance: it is for a float run"),
        (("simulate", "fig-varsim1", "--route", "exact", "--budget", "9"), "--budget: it is for the integrator"),
        (("simulate", "fig-varsim1", "--route", "exact", "--journal", "x"), "--journal: it is for the integrator"),
        (("classify", "rod", "--from", "theta=1", "--all"), "--all: --from follows slip from that state, as approach"),
        (("classify", "rod", "--from", "theta=1", "--box", "theta=0..1"), "--box: --from follows slip"),
        (("classify", "rod", "--from", "theta=1", "--budget", "9"), "--budget: --from follows slip"),
        (("classify", "rod", "--from", "theta=1", "--verbose", "--all"), "--all, --verbose: --from follows slip"),
        (("zeros", "--beta", "1..2", "--digits", "3"), "--digits: it is for one value of β"),
        (("zeros", "--beta", "7/3", "--budget", "0"), "--budget: it needs a range of β"),
        (("zeros", "--beta", "7/3", "--workers", "2"), "--workers: it needs a range of β"),
        (("zeros", "--beta", "7/3", "--picture", "x.png"), "--picture: it needs a range of β"),
        (("zeros", "--beta", "7/3", "--eps", "1", "--budget", "9"), "--budget: it needs a range of β"),
        (("zeros", "--beta", "7/3", "--eps", "1", "--certificate", "x"), "--certificate: with --epsilon it needs"),
        (("zeros", "--beta", "1..201", "--certificate", "x"), "--certificate: no column is sought for β > 200"),
        (("sign", "--tau", "0..1", "--beta", "1/2", "--scheduler", "garbage"), "scheduler: expected an address such"),
        (("sign", "--tau", "0..1", "--beta", "1/2", "--scheduler", "h:1", "--workers", "2"), "give one of both"),
        (("iwc", "--beta", "13/2", "--certificate", "x"), "needs 1 < beta < 5, got 13/2"),
        (("iwc", "--alpha3", "-1/2", "--certificate", "x"), "needs 1 < beta < 5, got 1/2"),
        (("iwc", "--mechanism", "oscillator", "--set", "beta=13/2", "--certificate", "x"), "got 13/2"),
        (("iwc", "--beta", "3", "--certificate", "x"), "that is not an integer, got 3"),
    ],
)
def test_what_has_no_use_is_refused(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    words: tuple[str, ...],
    said: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    code, output, errors = run(capsys, *words)
    assert (code, output) == (64, "")
    assert said in errors
    assert not list(tmp_path.iterdir())


def test_given_and_not_given() -> None:
    """A number 0 and an empty text were given; a flag that is off and an empty list were not."""
    refuse("", {"--a": None, "--b": False, "--c": []})
    for value in (0, "", True, ["x"]):
        with pytest.raises(ValueError, match=r"^--a: with b only$"):
            refuse("with b only", {"--a": value, "--b": None})


@pytest.mark.parametrize("word", ["-inf", "-Infinity", "-nan", "-INF"])
@pytest.mark.parametrize("command", [("theta", "1"), ("side",)])
def test_minus_infinity_is_a_number_that_is_refused(
    capsys: pytest.CaptureFixture[str], command: tuple[str, ...], word: str
) -> None:
    code, output, errors = run(capsys, *command, word)
    assert (code, output) == (64, "")
    assert f'expected a number such as "-50", "7/3" or "0.1", got {word!r}' in errors


@pytest.mark.parametrize("method", ["Euler", ""])
def test_a_wrong_float_run_is_refused_before_the_certified_one(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, method: str
) -> None:
    def started(*_: Any, **__: Any) -> None:
        raise AssertionError("the work was started")

    monkeypatch.setattr("gspot_verified.scenes.simulate.certified_run", started)
    code, output, errors = run(capsys, "simulate", "fig-varsim1", "--compare", "--method", method)
    assert (code, output) == (64, "")
    assert f"method: expected one of Radau, LSODA, BDF, got {method!r}" in errors


@pytest.mark.parametrize("points", ["0", "1", "100001"])
def test_points_of_a_certified_run_are_checked_before_it(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, points: str
) -> None:
    def started(*_: Any, **__: Any) -> None:
        raise AssertionError("the work was started")

    monkeypatch.setattr("gspot_verified.scenes.certified_run._exact_run", started)
    monkeypatch.setattr("gspot_verified.scenes.certified_run.integrated_run", started)
    place = str(tmp_path / "x.csv")
    code, output, errors = run(capsys, "simulate", "fig-varsim1", "--points", points, "--csv", place)
    assert (code, output) == (64, "")
    assert f"points: expected 2..100000, got {points}" in errors
