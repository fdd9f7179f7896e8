"""Typesetting changes how a formula looks and never what it says."""

from __future__ import annotations

import doctest
import html
import re
from pathlib import Path

import pytest

from gspot_verified.report.parts import formulas as module
from gspot_verified.report.parts.formulas import formula, typeset

PAGES = sorted((Path(__file__).resolve().parents[3] / "proofs").glob("*.md"))


def said(markup: str) -> str:
    """The characters that a reader sees."""
    return html.unescape(re.sub(r"</?(i|sub|sup|span)( class=\"formula\")?>", "", markup))


def signs(text: str) -> str:
    """Typed signs as printed ones."""
    for typed, printed in (("<=", "≤"), (">=", "≥"), ("!=", "≠"), ("->", "→"), ("-", "−"), ("*", "·")):
        text = text.replace(typed, printed)
    return text


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_no_character_of_a_proof_is_lost(page: Path) -> None:
    for line in page.read_text(encoding="utf-8").splitlines():
        for shown in (typeset(line), formula(line)):
            left, right = signs(said(shown)), signs(line)
            assert re.sub(r"[_^{}()]", "", left) == re.sub(r"[_^{}()]", "", right)
            assert len(left) >= len(right) - sum(right.count(mark) for mark in "_^{}()")
            for tag in ("i", "sub", "sup", "span"):
                assert shown.count(f"<{tag}>") + shown.count(f"<{tag} ") == shown.count(f"</{tag}>")


@pytest.mark.parametrize(
    ("source", "shown"),
    [
        ("p_n", "<i>p</i><sub><i>n</i></sub>"),
        ("e^(−x²)", "<i>e</i><sup>−<i>x</i>²</sup>"),
        ("P_(ν−4)", "<i>P</i><sub><i>ν</i>−4</sub>"),
        ("y_(n-4)(0)", "<i>y</i><sub><i>n</i>−4</sub>(0)"),
        ("(f_ξ)_(k)", "(<i>f</i><sub><i>ξ</i></sub>)<sub><i>k</i></sub>"),
        ("f^(n)", "<i>f</i><sup>(<i>n</i>)</sup>"),
        ("Σ_{n<M} a_n", "Σ<sub><i>n</i>&lt;<i>M</i></sub> <i>a</i><sub><i>n</i></sub>"),
        ("α_1*", "<i>α</i><sub>1</sub><sup>*</sup>"),
        ("2^10x", "2<sup>10</sup><i>x</i>"),
        ("x^-1", "<i>x</i><sup>−1</sup>"),
        ("sin u", "sin <i>u</i>"),
        ("ξ̃", "<i>ξ̃</i>"),
    ],
)
def test_formulas(source: str, shown: str) -> None:
    assert formula(source) == shown


@pytest.mark.parametrize(
    "text",
    ["A sentence without a formula.", "Used by test_trajectory.py and slow_manifold.", "I see a page; see and/or."],
)
def test_prose_stays(text: str) -> None:
    assert typeset(text) == text


def test_a_formula_ends_with_its_sentence() -> None:
    assert typeset("Let β > 1. Then") == 'Let <span class="formula"><i>β</i> &gt; 1</span>. Then'
    assert typeset("so |R(s, δ)| ≤ K, as").endswith("</span>, as")


def test_an_index_in_brackets_makes_a_formula() -> None:
    assert typeset("of z_(n-1) is") == 'of <span class="formula"><i>z</i><sub><i>n</i>−1</sub></span> is'


@pytest.mark.parametrize("mark", ["'", "’"])
def test_the_s_of_a_plural_is_no_variable(mark: str) -> None:
    alpha = '<span class="formula"><i>α</i></span>'
    assert typeset(f"the α{mark}s, and α{mark}s") == f"the {alpha}{mark}s, and {alpha}{mark}s"
    assert f"<i>α</i></span>{mark}s)" in typeset(f"it (constant α{mark}s) is")
    assert typeset(f"(α{mark}s)").endswith(f"{mark}s)")
    assert typeset(f"the paper{mark}s") == f"the paper{mark}s"


def test_markup_in_the_source_is_text() -> None:
    assert "<script>" not in typeset("x_1 <script> y^2")
    assert "<script>" not in formula("<script>")


def test_the_examples_of_the_docstrings() -> None:
    assert doctest.testmod(module) == (0, 2)
