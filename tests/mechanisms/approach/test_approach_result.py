"""What a result says of itself; how it comes about: test_approach.py."""

from __future__ import annotations

from dataclasses import replace

from flint import arb

from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.approach_result import LIFT_OFF
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.verdict import Reason, Verdict


def test_what_is_said_of_each_end() -> None:
    """One result turned into others: the exit code, what a statement rests on, and the warning of a moving surface."""
    found = approach(shipped_mechanism("model system"), {"x": 0, "u": 100, "p": "1/2", "b": -2})
    assert found.side == LIFT_OFF
    assert (found.exit_code, found.warnings) == (0, ())
    assert replace(found, side=None).exit_code == 2
    assert replace(found, side=None, end="slip stops").exit_code == 0
    assert replace(found, verdict=Verdict.undecided("x", Reason.BUDGET, "y")).exit_code == 2
    text, event = str(found), replace(found, end="slip stops", case=None, solved=("y", "v"), side=None)
    assert f"\n  side: lift-off ({found.side_reason})\n  " in text
    assert "\n  the G-spot: x = " in text
    assert f"\n  Case {found.case}, beta = " in text
    assert "\n  C1 = " in text
    assert " from the start\n" in text
    assert " + C1 (-t)^beta + ... (t counted from the G-spot)\n" in text
    assert "surface" not in text
    assert "\n  on a surface with the velocity u = -12/5\n" in str(replace(found, surface_velocity="-12/5"))
    assert "on a surface with" not in str(replace(found, surface_velocity=None))
    assert "\n  after the time t = " in text
    assert "\n  alpha_1 = " in text
    assert "\n  side: " not in str(event)
    assert "\n  y and v from y = 0 and v = 0\n" in str(event)
    assert "\n  there: x = " in str(event)
    assert "\n  the Case is open, beta = " in str(event)
    assert "\n  no Case, beta = " in str(replace(event, case="none"))
    assert "\n  side: undecided (" in str(replace(found, side=None))
    bare = str(replace(found, time=None, place=(), alphas=None, beta=None, coefficient=None, notes=("noted",)))
    assert not any(part in bare for part in ("after the time", "the G-spot:", "alpha_1", "beta", "C1 ="))
    assert bare.endswith("\n  noted")
    moving = replace(found, surface_velocity=None, least_slip=arb(-2))
    assert moving.warnings[0].startswith("u is not positive here: on a surface that moves with a velocity below -2.000")
    assert moving.warnings[0].endswith(
        " rigid slip is positive until then; nothing is said of where slip stops on others"
    )
    assert replace(moving, least_slip=None).warnings == ()
    assert replace(moving, verdict=Verdict.undecided("it ends", Reason.BUDGET)).warnings == ()
    first, second = replace(moving, supposed=("y", "v")).warnings
    assert first.startswith("the state is supposed to lie on the contact: y, v = 0 there is not shown")
    assert second == moving.warnings[0]
    assert first in str(replace(found, supposed=("y", "v")))
    assert found.supposed == ()
    cosine = shipped_mechanism("frictional impact oscillator")
    psi = {"psi": "cos(phi_ref + 1/10) - 1", "psi_dot": "9/10*sin(phi_ref + 1/10)"}
    whole = approach(cosine, {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"} | psi, max_steps=1)
    assert whole.supposed == ("y", "v")
    assert found.to_json()["rests_on"] != event.to_json()["rests_on"] == "proved for rigid slip"
    assert replace(found, time=None, alphas=None).to_json()["alphas"] is None
    assert len(found.to_json()["alphas"]) == 3


def test_it_rests_on_no_more_than_there_is() -> None:
    """No C1 at beta = 2 or 1, no side at alpha_2 = 0 or without a damper; nothing is proved of an open end."""
    start = {"x": 0, "u": 3, "p": "1/2", "b": -2}
    paper = "the side is the paper's statement at leading order as epsilon -> 0 (Sec. 4.5)"
    for beta in (-2, -1):
        found = approach(shipped_mechanism("model system", alpha_3=beta), start)
        assert found.coefficient is None
        assert found.rests_on == "reaching the G-spot is proved for rigid slip"
        assert f"\n  {found.rests_on}\n" in str(found)
        assert "the side" not in str(found)
    no_side = approach(shipped_mechanism("model system", alpha_2=0, alpha_3="-1/2"), start | {"b": "-1/10"})
    assert (no_side.side, no_side.exit_code) == (None, 2)
    assert no_side.rests_on == "reaching the G-spot and C1 are proved for rigid slip"
    assert paper in approach(shipped_mechanism("model system"), start).rests_on
    undecided = approach(shipped_mechanism("model system"), start | {"u": "5/3"})
    assert (undecided.end, undecided.rests_on) == (None, "")
