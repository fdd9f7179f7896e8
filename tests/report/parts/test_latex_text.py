"""Texts of the ledger as LaTeX: ASCII, balanced, every sign declared; nothing that reads a file or defines a word."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.report.parts.latex_text import escaped, formula_latex, source_latex, text_latex

SPECIAL = "\\{}$&#%_^~<>|\"'“”–−°αβ²₀∞≤ \u0302é/()[]*,.;"


def is_balanced(latex: str) -> bool:
    """Whether braces and dollars outside of \\{, \\}, \\$ have partners."""
    bare = re.sub(r"\\.", "", latex, flags=re.DOTALL)
    depth = 0
    for letter in bare:
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if depth < 0:
            return False
    return depth == 0 and bare.count("$") % 2 == 0


@given(st.text(alphabet=st.one_of(st.sampled_from(SPECIAL), st.characters(codec="utf-8")), max_size=60))
def test_any_text_becomes_balanced_ascii(text: str) -> None:
    for latex in (text_latex(text), escaped(text), f"${formula_latex(text)}$", source_latex(text)):
        assert latex.isascii()
        assert is_balanced(latex), latex
        assert not re.search(r"(?<!\\)[%#&]", latex), latex


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("λ_N = (z - y)/ε²", r"$\lambda_{N} = (z - y)/\varepsilon^{2}$"),
        ("β other than 3m", r"$\beta$ other than $3m$"),
        ("α_3* λ⁺ ≠ 0", r"$\alpha_{3}^{*} \lambda^{+} \ne0$"),
        ("b_n''' of s^(k-3)", r"$b_{n}'''$ of $s^{k-3}$"),
        ("c_φ φ\u0307 and v\u0302", r"$c_{\phi} \dot{\phi}$ and $\hat{v}$"),
        ("u = -3/5 √(g l) < 0", r"$u = -3/5 \sqrt{g l} < 0$"),
        ("ε = 10^-3, 10^-4", r"$\varepsilon = 10^{-3}$, $10^{-4}$"),
        ("[2.5 +/- 1.2e-6]", r"$[2.5 \pm1.2\cdot10^{-6}]$"),
        ("x²' and e^(2x)'", r"$x^{2}{}'$ and $e^{2x}{}'$"),
        ('the "pull" of 50 % & more_1', r"the ``pull'' of 50 \% \& more\_1"),
        ("Várkonyi, Painlevé — “so”", r"V\'{a}rkonyi, Painlev\'{e} \textemdash{} ``so''"),
        ("verify --formal", "verify -{}-formal"),
        ("constant α's, the α’s", r"constant $\alpha$'s, the $\alpha$'s"),
        ("F_n + Σ G_(n-k) λ_k, Π_(k=1)^n β_k", r"$F_{n} + \sum G_{n-k} \lambda_{k}$, $\prod_{k=1}^{n} \beta_{k}$"),
        ("one ☃", r"one $\text{[U+2603]}$"),
        ("every ε in (0, 1/100]: for all", r"every $\varepsilon$ in $(0,\allowbreak1/100]$: for all"),
        ("on [τ_0, ∞) the force", r"on $[\tau_{0},\allowbreak \infty)$ the force"),
        ("a, b, A, B: in Cases I, II", "$a$, $b$, $A$, $B$: in Cases I, II"),
        ("a b, as in panels (b) and (c).", "a $b$, as in panels (b) and (c)."),
        ("F(b) and (t)", "$F(b)$ and $(t)$"),
    ],
)
def test_texts(text: str, latex: str) -> None:
    assert text_latex(text) == latex


@pytest.mark.parametrize(
    ("source", "latex"),
    [
        (r"\beta=\alpha_1/\alpha_3", r"$\beta=\alpha_1/\alpha_3$"),
        (r"\text{lower } b(0) \text{ in (b)},\ \text{higher } b(0)", "lower $b(0)$ in (b), higher $b(0)$"),
        (r"a<0 \text{ on } (1,2),\quad b>0", "$a<0$ on $(1,2)$, $b>0$"),
        (r"\text{red: }\Theta\qquad\text{blue: }\Theta", r"red: $\Theta$; blue: $\Theta$"),
        (r"f(a,\ b)", r"$f(a,\ b)$"),
        (r"\text{a (dTheta\_sign) b}", r"a (dTheta\_sign) b"),
        (r"\left(\frac{a}{b},\quad c\right)", r"$\left(\frac{a}{b},\quad c\right)$"),
    ],
)
def test_a_printed_form_can_break_between_words_and_formulas(source: str, latex: str) -> None:
    assert source_latex(source) == latex


@pytest.mark.parametrize(
    "source",
    [
        r"\input{/etc/passwd}", r"\write18{ls}", r"\def\alpha{x}", r"\csname input\endcsname", r"a}b", r"{a", "a$b",
        "a%b", r"\text{\input{x}}", r"^^41", "é", "a\nb", "\\", r"\begin{x}", r"\text{a{b}c}",
    ],
)  # fmt: skip
def test_what_is_not_known_is_shown_as_its_source(source: str) -> None:
    shown = source_latex(source)
    assert shown.startswith(r"\texttt{")
    assert shown.isascii()
    assert is_balanced(shown)
    assert not re.search(r"\\(input|write|def|csname|begin)", shown)
