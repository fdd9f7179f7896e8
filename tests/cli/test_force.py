"""The command ``force``: exit codes, what it says about the system, bad input."""

from __future__ import annotations

import json

import pytest

from gspot_verified.cli import main

STATE = "1/2,-2/3,-8/3000000,0,-4/3000000"


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


def test_on_the_slow_manifold(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "force", "--beta", "5/2", "--eps", "1e-6", "--t", "1e-4")
    assert code == 0
    assert output.startswith("λ_N = [0.666665849564909 +/-")
    assert "slow manifold" in output
    assert "C1 = -1" in output


def test_from_a_state(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("force", "--beta", "5/2", "--eps", "1/1000", "--t", "-1/2", f"--state={STATE}")
    code, output, _ = run(capsys, *words, "--json")
    assert code == 0
    data = json.loads(output)
    assert data["reached"] is True
    assert "initial state" in data["system"]
    code, output, _ = run(capsys, *words, "--digits", "5")
    assert code == 0
    assert "1.3333" in output


def test_the_force_is_that_of_the_contact_phase(capsys: pytest.CaptureFixture[str]) -> None:
    """Contact is lost at t = 0.035; what follows it in contact is not the model's force."""
    words = ("force", "--beta", "3/2", "--eps", "1e-3", "--t", "1/10", "--state=1/2,-2,-8e-6,0,-4e-6")
    said = (
        "the contact phase of the compliant model (the model as long as contact has lasted), from the initial state "
        "(p, b, y, v, z) = (1/2,-2,-8e-6,0,-4e-6), β = 3/2, α_1 = -1, α_2 = -1, ε = 1e-3"
    )
    _, output, _ = run(capsys, *words)
    assert output.splitlines()[-1].strip() == said
    _, output, _ = run(capsys, *words, "--json")
    assert json.loads(output)["system"] == said


def test_whether_contact_has_lasted(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("force", "--beta", "5/2", "--eps", "1/1000", f"--state={STATE}", "--certify")
    code, output, _ = run(capsys, *words, "--t", "1/100")
    assert code == 0
    assert "proved: in the compliant model" in output
    # A run on the other side, nu = 1/2: contact is lost before t = 0.069.
    words = ("force", "--beta", "5/2", "--eps", "1/1000", "--state=1/2,-1/6,-0.0000006666,0,-0.0000003333", "--certify")
    code, output, _ = run(capsys, *words, "--t", "7/100", "--json")
    assert code == 2
    assert json.loads(output)["contact_lasts"]["outcome"] == "undecided"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--beta", "5/2", "--t", "x"), "t: expected a number"),
        (("--t", "0"), "beta: give beta or alpha_3"),
        (("--beta", "5/2", "--t", "0", "--state=1,2"), "state: expected five numbers"),
        (("--beta", "5/2", "--t", "0", f"--state={STATE}", "--c1", "1"), "--c1: it is for the slow manifold"),
        (("--beta", "5/2", "--t", "0", "--certify"), "--certify: it needs"),
        (("--beta", "5/2", "--t", "-1", f"--state={STATE}"), "before the initial state"),
        (("--beta", "5/2", "--t", "0", "--eps", "0"), "epsilon: expected"),
    ],
)
def test_bad_input(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str) -> None:
    code, _, errors = run(capsys, "force", *arguments)
    assert code == 64
    assert message in errors


def test_the_exact_side_rule_of_a_state(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "side", "--beta", "5/2", "--eps", "1/1000", f"--state={STATE}")
    assert code == 0
    assert output.startswith("proved: K > 0")
    assert "the paper's rule gives the same side" in output
    assert "initial state" in output
    assert output.endswith(", β = 5/2, α_1 = -1, α_2 = -1, ε = 1/1000\n")
    # beta = 13/2: with the paper's own data the fast part wins at eps = 1/1000.
    words = ("side", "13/2", "--state=1/2,-2/11,-8/11000000,0,-4/11000000", "--json")
    code, output, _ = run(capsys, *words)
    assert code == 0
    data = json.loads(output)
    assert data["paper_differs"] is True
    assert data["verdict"]["statement"].startswith("K < 0")


def test_the_side_of_a_state_after_the_g_spot(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("side", "5/2", "--eps", "1/1000", "--state=-1/100,-1,-4/1000000,0,-1/1000000")
    code, output, _ = run(capsys, *words)
    assert code == 0
    assert output.startswith("proved: K > 0")
    assert "does not apply" in output
    code, output, _ = run(capsys, *words, "--json")
    assert json.loads(output)["slow_part"] is None


def test_the_trivial_state_is_the_canard(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "side", "5/2", "--state=1/2,-1/3,-1/750000,0,-1/1500000")
    assert code == 2
    assert output.startswith("undecided")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "give it as an argument"),
        (("--beta", "5/2"), "--beta goes with --state"),
        (("5/2", "--state=1,2,3"), "state: expected five numbers"),
        (("--state=-1/2,1,-1,0,1",), "β: give it as an argument or with --beta"),
    ],
)
def test_bad_input_for_the_side(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str) -> None:
    code, _, errors = run(capsys, "side", *arguments)
    assert code == 64
    assert message in errors
