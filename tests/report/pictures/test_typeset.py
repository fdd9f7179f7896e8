"""Names as formulas: what is a formula can be read by matplotlib, and anything else stays."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.report.pictures.canvas import LAMBDA_N, typeset


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("theta", r"$\theta$"),
        ("phi_dot", r"$\dot{\varphi}$"),
        ("x_1", "$x_{1}$"),
        ("q_ddot_1", r"$\ddot{q}_{1}$"),
        ("v_rel", r"$v_{\mathrm{rel}}$"),
        ("k_theta", r"$k_{\theta}$"),
    ],
)
def test_letters_with_accents_and_an_index(name: str, formula: str) -> None:
    assert typeset(name) == formula


@pytest.mark.parametrize("name", ["angle", "a_b_c", "x_dot_dot", "x_", "_", "x__1", "ß", "x_ß", "theta2"])
def test_other_names_stay(name: str) -> None:
    assert typeset(name) == name


PARTS = st.sampled_from(["x", "X", "theta", "Omega", "epsilon", "dot", "hat", "1", "rel", "angle", ""])


@settings(max_examples=40)
@given(st.lists(PARTS, min_size=1, max_size=4).map("_".join))
def test_matplotlib_reads_every_formula(name: str) -> None:
    from matplotlib.mathtext import MathTextParser

    for text in (typeset(name), LAMBDA_N):
        if text.startswith("$"):
            MathTextParser("path").parse(text)
