"""Names and scales: text, JSON and LaTeX say the same, with the mechanism's own names."""

from __future__ import annotations

import re

import pytest

from gspot_verified.expansion.residual import residual_bounds
from gspot_verified.expansion.series.legend import CONTACT, DELTA_FACTORS, latex_symbol, left_side
from gspot_verified.expansion.time_series import time_series
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.load import load
from gspot_verified.testing import extended_example

ROD = expand(load("rod"), 4)
STATE = ("X", "Y", "theta", "X_dot", "Y_dot", "theta_dot")


def test_the_mechanism_s_own_names_in_all_three_forms() -> None:
    data = ROD.to_json()
    assert tuple(data["state"]) == STATE
    assert tuple(data["contact"]) == CONTACT
    left = [line.split(" = ")[0].strip() for line in str(ROD).splitlines() if re.match(r"  \S.* = .*O\(", line)]
    assert left[:6] == [f"({name} - {name}*)/delta^2" for name in STATE]
    assert left[6:] == ["p/delta^2", "b/delta^2", "y/delta^6", "v/delta^4", "z/delta^6", "lambda_n"]
    latex = ROD.to_latex().splitlines()[1:-1]
    assert len(latex) == len(left)
    for line, name in zip(latex, STATE, strict=False):
        assert line.startswith(rf"  \delta^{{-2}}({latex_symbol(name)} - ")


def test_in_time_and_in_the_residual_too() -> None:
    series = ROD.in_time()
    assert tuple(series.to_json()["state"]) == STATE
    assert "\n  theta_dot - theta_dot* = " in str(series)
    bounds = residual_bounds(ROD, 1, "1/10")
    data = bounds.to_json()
    assert tuple(data["state"]) == STATE
    assert set(data["start"]) == {"p", "b", "y", "v", "J_1", "J_2"}
    assert "equation of theta_dot: " in str(bounds)
    assert "is not proved" in str(bounds)


def test_symbols_keep_the_names_too() -> None:
    assert tuple(expand(load("extended", chi=None), 3).to_json()["state"]) == ("x", "u", "y", "v", "p", "b")


def test_a_component_may_be_called_p() -> None:
    """The extended system's own p is the Painlevé parameter: two tables, the same polynomials."""
    data = expand(load("extended"), 4).to_json()
    assert data["state"]["p"] == data["contact"]["p"]
    assert data["state"]["y"] != data["contact"]["y"]  # (y - y*)/delta^2 and y/delta^6


def test_the_scales_are_those_of_the_coefficients() -> None:
    """t = delta^2 s and epsilon = delta^3: every term of the series in time has its order in the scaled one."""
    series = time_series(extended_example(1), 6).tables()
    scaled = expand(extended_example(1), 6).terms()
    for key, table in series.items():
        factor = DELTA_FACTORS["xi" if key.startswith("xi_") else key]
        for (k, m), value in table.items():
            assert scaled[key][2 * k + 3 * m - factor].coefficients()[k] == value
        suffix = f"/delta^{factor}" if factor else ""
        assert left_side(key, [f"c_{i}" for i in range(6)], True).endswith(suffix)


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("theta", r"\theta"),
        ("theta_dot", r"\dot{\theta}"),
        ("q_1_dot", r"\dot{q_{1}}"),
        ("theta_ref", r"\theta_{\mathrm{ref}}"),
        ("hip", r"\mathrm{hip}"),
        ("X", "X"),
    ],
)
def test_symbols(name: str, shown: str) -> None:
    assert latex_symbol(name) == shown
