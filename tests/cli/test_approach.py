"""The command ``approach``, and ``classify --from``."""

from __future__ import annotations

import json

import pytest

from gspot_verified.cli import main

PAPER = "phi=phi_ref + 1/10,phi_dot=-9/10"


def test_the_papers_first_start(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["approach", "oscillator", "--from", PAPER]) == 0
    printed = capsys.readouterr().out
    assert "proved: slip reaches a G-spot in finite time" in printed
    assert "side: lift-off (Case III, C1 > 0)" in printed
    assert "leading order as epsilon -> 0" in printed
    assert main(["classify", "oscillator", "--from", PAPER, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["schema"] == "gspot-verified/approach/3"
    assert data["side"] == "lift-off"


def test_slip_that_stops_and_undecided(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["approach", "oscillator", "--surface-velocity=-1/2", "--from", "phi=phi_ref + 1/10,phi_dot=-1/2"]
    # x_dot = cos(phi) phi_dot = -0.26 at the start, -0.6 at the G-spot: slip stops on the way.
    assert main(arguments) == 0
    stops = "proved: slip stops before any G-spot (then stick, or slip the other way)"
    assert stops in capsys.readouterr().out
    assert main(["approach", "model", "--from", "x=0,u=5,p=1/2,b=-1"]) == 2
    assert "too close to the distinguished trajectory" in capsys.readouterr().out
    no_case = ["--from", "x=0,u=3,p=1/2,b=-1/10", "--set", "alpha_3=-1/2", "--set", "alpha_2=0"]
    assert main(["approach", "model", *no_case]) == 2
    assert "C1 = [-0.1414" in capsys.readouterr().out
    assert main(["approach", "--help"]) == 0
    assert "at a G-spot, the side is known" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ("x=0", "missing: u, y, v, p, b"),
        ("x", "--from: expected \"name=value,name=value\", got 'x'"),
        ("x=1,x=2", "--from: x is given twice"),
        ("x=0,u=1,p=-1,b=-1", "p = -1.00000000000000 is not certainly positive"),
    ],
)
def test_bad_states(capsys: pytest.CaptureFixture[str], state: str, message: str) -> None:
    assert main(["approach", "model", "--from", state]) == 64
    assert message in capsys.readouterr().err
