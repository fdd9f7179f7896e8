"""The command ``wrong-sides``: text, exit codes, bad input."""

from __future__ import annotations

import pytest

from gspot_verified.cli import main
from gspot_verified.cli.main import USAGE
from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.scenes import hard_sides
from gspot_verified.scenes.side import CertifiedSide, certified_side

ONE = ("wrong-sides", "--eps", "1/10000", "--beta", "15/2", "--method", "LSODA", "--tolerance", "1e-10")


def test_a_table_and_the_certified_sides(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*ONE, "--nu", "2", "--nu", "1/2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "wrong sides of decided starts; s: runs without an event, f: runs that failed"
    assert lines[1].split() == ["ε", "=", "1/10000", "β", "=", "15/2"]
    assert lines[2].split()[:2] == ["LSODA", "1e-10"]
    assert lines[2].split()[2].endswith("/2")
    assert lines[3].split() == ["the", "paper's", "rule", "0/2"]
    assert lines[5].startswith("  ε = 1/10000, β = 15/2, ν = 2: proved: contact is lost")


def test_where_the_rule_of_the_paper_fails(capsys: pytest.CaptureFixture[str]) -> None:
    words = (
        "wrong-sides",
        "--eps",
        "1/1000",
        "--beta",
        "13/2",
        "--method",
        "LSODA",
        "--tolerance",
        "1e-3",
        "--nu",
        "2",
    )
    assert main([*words]) == 0
    output = capsys.readouterr().out
    assert "the paper's rule      1/1" in output
    assert output.rstrip().endswith("the paper's rule gives the other side")


def test_an_undecided_start_is_no_count_and_ends_with_2(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def undecided(scene: hard_sides.Scene) -> CertifiedSide:
        found = certified_side(scene)
        return CertifiedSide(None, found.rule, Verdict.undecided("which side", Reason.BUDGET, "for the test"))

    monkeypatch.setattr(hard_sides, "certified_side", undecided)
    assert main([*ONE, "--nu", "2"]) == 2
    assert "0/0" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--method", "Euler"), "method: expected one of Radau, LSODA, BDF"),
        (("--tolerance", "0"), "tolerance: expected 1e-13..1e-2"),
        (("--beta", "1"), "beta = 1"),
        (("--eps", "x"), "epsilons"),
    ],
)
def test_bad_input(capsys: pytest.CaptureFixture[str], words: tuple[str, str], message: str) -> None:
    assert main(["wrong-sides", *words]) == USAGE
    assert message in capsys.readouterr().err
