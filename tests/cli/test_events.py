"""The command ``events``: exit codes, text and JSON, bad input."""

from __future__ import annotations

import json

import pytest

from gspot_verified.cli import main
from gspot_verified.compliant.model.normal_form import compliant_state


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


def test_a_run_of_the_paper(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "events", "--beta", "3/2", "--eps", "1e-9", "--nu", "2")
    assert code == 0
    assert output.startswith("proved: exactly one flight, then contact for ever: an impact without collision")
    assert "lift-off: [0.500006988019767490" in output
    assert output.endswith("ε = 1e-9\n")


@pytest.mark.parametrize("state", ["1/2,-2,-8e-4,0,-4e-4", "1/2,-2,-1/100,-1,0"])
def test_the_whole_start_is_said(capsys: pytest.CaptureFixture[str], state: str) -> None:
    """From the first one contact lasts for ever, from the other one it is lost: same p, b and numbers."""
    words = ("events", "--beta", "5/2", "--eps", "1e-2", f"--state={state}")
    _, output, _ = run(capsys, *words)
    start = compliant_state(*state.split(","))
    exact = ", ".join(str(getattr(start, name)) for name in "pbyvz")
    assert f"from (p, b, y, v, z) = ({exact}), β = 5/2" in output.splitlines()[-1]
    _, output, _ = run(capsys, *words, "--json")
    assert json.loads(output)["state"] == {name: str(getattr(start, name)) for name in "pbyvz"}


def test_the_same_from_a_state_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("events", "--beta", "3/2", "--eps", "1e-6", "--state=1/2,-2,-8e-12,0,-4e-12", "--digits", "10", "--json")
    code, output, _ = run(capsys, *words)
    assert code == 0
    data = json.loads(output)
    assert [event["event"] for event in data["events"]] == ["lift-off", "touch-down"]
    assert data["start"] == "-1/2"
    assert data["times"] == "measured from the G-spot; the run begins at start"


def test_an_open_question_leaves_with_2(capsys: pytest.CaptureFixture[str]) -> None:
    """A second flight that is not followed."""
    words = ("--beta", "9/32", "--eps", "1/77", "--alpha1=-9/8", "--alpha2", "3/4", "--flights", "1")
    code, output, _ = run(capsys, "events", *words, "--state=7/8,-11/32,-53/94864,43/2464,-27/189728")
    assert code == 2
    assert output.startswith("undecided")
    assert output.endswith(", β = 9/32, α_1 = -9/8, α_2 = 3/4, ε = 1/77\n")


@pytest.mark.parametrize(
    "words",
    [
        ("--beta", "3/2"),
        ("--beta", "3/2", "--nu", "2", "--state=1/2,-2,-1,0,0"),
        ("--beta", "3/2", "--nu", "0"),
        ("--beta", "1", "--nu", "2"),
        ("--beta", "3/2", "--nu", "2", "--digits", "0"),
        ("--beta", "3/2", "--state=1/2,-2"),
    ],
)
def test_bad_input(capsys: pytest.CaptureFixture[str], words: tuple[str, ...]) -> None:
    code, output, errors = run(capsys, "events", *words)
    assert code == 64
    assert output == ""
    assert errors.startswith("error: ")


def test_the_budget_is_named_and_an_option_raises_it(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("events", "--beta", "3/2", "--nu", "2", "--eps", "1/100")
    code, output, _ = run(capsys, *words)
    assert code == 0
    assert output.startswith("proved: exactly one flight, then contact for ever")
    code, output, _ = run(capsys, *words, "--budget", "10")
    assert code == 2
    assert "the power series found no bracket within its budget of 10 (its work, rate times time)" in output
    code, _, errors = run(capsys, *words, "--budget", "0")
    assert code == 64
    assert "budget must be an int and lie in 1..10000" in errors


def test_the_help_says_how_far_a_proved_run_goes(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "events", "--help")
    assert code == 0
    assert "or the run up to a contact that is lost again" in " ".join(output.split())
