"""The command ``verdict``: exit codes, which system it speaks of, bad input."""

from __future__ import annotations

import pytest

from gspot_verified.cli import main


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(("verdict", *arguments))
    output, errors = capsys.readouterr()
    return code, output, errors


def test_from_a_state_it_speaks_of_the_model_system(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "--beta", "3/2", "--from", "p=1/2,b=-2", "--eps", "1e-6")
    assert code == 0
    assert output.startswith("proved: the model system with alpha = (-1, -1, -3/2)")
    assert "for every 0 < epsilon <= 1/1000000" in output
    assert "contact is lost" in output


def test_without_a_state_it_speaks_of_every_mechanism_and_names_no_epsilon(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "--beta", "3/2")
    assert code == 0
    assert output.startswith("proved: for every mechanism of Case III with analytic functions, p, b, y, v independent ")
    assert ", beta = 3/2 and " in output
    assert "there is an epsilon_0 > 0" in output


def test_of_a_mechanism_it_names_its_system_and_no_epsilon(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "model", "--from", "x=0,u=3,p=1/2,b=-2")
    assert code == 0
    assert output.startswith("proved: model system with")
    assert "there is an epsilon_0 > 0" in output
    assert "contact is lost\n" in output
    assert "epsilon_0 is not computed" in output


def test_of_a_mechanism_undecided_says_why(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "model", "--from", "x=0,u=100,p=1/2,b=-2", "--set", "alpha_3=-1/2")
    assert code == 2
    assert "Theorem R is about Case III: Case I" in output


def test_undecided_says_which_inequality_fails(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "--beta", "3/2", "--from", "p=1/20,b=-1/8", "--eps", "1/10")
    assert code == 2
    assert "Theorem U2: up to s = " in output
    assert "it is proved up to epsilon = " in output


@pytest.mark.slow
def test_an_explicit_bound_that_was_asked_for_and_is_undecided_leaves_with_2(
    capsys: pytest.CaptureFixture[str],
) -> None:
    words = ("extended-system", "--from", "x=0,u=70,p=1/2,b=-2")
    code, output, _ = run(capsys, *words, "--explicit")
    assert code == 2
    assert output.startswith("proved: extended system")
    assert "section 8): undecided: " in output
    assert run(capsys, *words)[0] == 0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--beta", "3/2", "--from", "p=1/2"), "it needs p and b"),
        (("--beta", "3/2", "--eps", "1e-6"), "--epsilon: it goes with --from"),
        (("--beta", "3/2", "--within", "1/2"), "--within: it goes with --from"),
        (("--beta", "3/2", "--alpha1", "5"), "--alpha1: it goes with --from"),
        (("--beta", "3/2", "--alpha2", "5"), "--alpha2: it goes with --from"),
        (("--beta", "2"), "no integer"),
        ((), "give a mechanism or --beta"),
        (("model", "--beta", "3/2"), "give a mechanism or --beta"),
        (("model",), "--from: a mechanism needs a state"),
        (("model", "--from", "p=1/2", "--eps", "1e-6"), "--epsilon: it goes with --beta"),
        (("--beta", "3/2", "--set", "mu=2"), "--set: it goes with a mechanism"),
        (("--beta", "3/2", "--spot", "1"), "--spot: it goes with a mechanism"),
        (("--beta", "3/2", "--surface-velocity", "1"), "--surface-velocity: it goes with a mechanism"),
        (("--beta", "3/2", "--from", "p=1/2,b=-1"), "distinguished trajectory"),
    ],
)
def test_bad_input(capsys: pytest.CaptureFixture[str], words: tuple[str, ...], message: str) -> None:
    code, _, errors = run(capsys, *words)
    assert code == 64
    assert message in errors
