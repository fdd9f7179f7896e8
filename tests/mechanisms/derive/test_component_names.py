"""A component with the name of something else is told from it in statements; one that is that function is not."""

from __future__ import annotations

import pytest

from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.mechanism_side import mechanism_side
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.derive.component_names import names_of_other_things
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism

ROD = """
format = 1
name = "a rod in x and y"
[angles.theta]
sine = "3/5"
cosine = "4/5"
[energies]
coordinates = ["x", "y", "theta"]
time = "t"
kinetic = "(x_dot^2 + y_dot^2)/2 + theta_dot^2/6"
potential = "3*y/5"
[contact]
x = "x + cos(theta)"
y = "y - sin(theta)"
mu = "73/36"
[g_spot]
fixed = ["x", "x_dot", "t"]
[g_spot.point]
x = 0
y = "3/5"
theta = "theta_ref"
x_dot = 2
y_dot = "4/5"
theta_dot = 1
t = 2
"""
START: StateInput = {"x": 0, "x_dot": 2, "theta": "theta_ref - 1/10", "theta_dot": "9/10", "t": "3/2"}


def test_the_height_y_and_the_time_t_are_not_the_gap_and_the_time_since_the_start() -> None:
    found = mechanism_side(parse_mechanism(ROD), START)
    for text in (found.verdict.statement, str(found), str(found.approach)):
        assert "the component y = [0.517" in text
        assert "the component t = 1.5" in text
        assert ", y = [" not in text
        assert ", t = " not in text
    assert "\n  the component y and y_dot from y = 0 and v = 0\n" in str(found.approach)
    assert dict(found.approach.start)["y"].startswith("[0.517")


def test_functions_that_are_components_keep_their_names() -> None:
    for name in ("model system", "extended system"):
        assert not names_of_other_things(shift(shipped_mechanism(name)))
    text = str(approach(shipped_mechanism("model system"), {"x": 0, "u": 3, "p": "1/2", "b": "-2"}))
    assert "the component" not in text


@pytest.mark.parametrize("rate", ["v + y", "v - p"])
def test_a_component_v_beside_the_gap_s_rate_is_told_from_it(rate: str) -> None:
    text = """
    format = 1
    name = "v is not the rate"
    [fields]
    state = ["x", "u", "y", "v", "p", "b"]
    F = ["u", 0, "RATE", "b", "-1", "-1"]
    G_T = [0, "3/(2*(1 - p))", 0, "1/2", 0, "-3/(4*(1 - p))"]
    G_N = [0, "1/2", 0, "(1 + p)/2", 0, "3/4"]
    [contact]
    x = "x"
    y = "y"
    mu = "1 - p"
    """
    assert names_of_other_things(shift(parse_mechanism(text.replace("RATE", rate)))) == {"b", "v"}


def test_an_expansion_counts_the_time_from_the_g_spot_on() -> None:
    text = str(expand(parse_mechanism(ROD), 3))
    assert "t is the time, in the mechanism's unit, and 0 where p = 0" in text
    assert "\n  (t - t*)/delta^2 = s + O(delta^3)\n" in text
    assert "lambda_n without a star are the paper's" in text
