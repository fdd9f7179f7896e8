"""What notes and consequences of Sec. 1 say of all of the paper: no formula has a D, and β is α_3/α_1 elsewhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

PAPER = Path(__file__).resolve().parents[4] / "shared" / "paper.tex"
SCALAR = r"\\cD(?![A-Za-z])|(?<![A-Za-z\\])D(?![A-Za-z])"
RATIO = r"\\beta\s*=\s*(?:\\frac\{)?\\alpha_(\d)(?:\^\*)?(?:\}\{|/)\\alpha_(\d)"


def found(pattern: str, text: str) -> list[tuple[int, str]]:
    """The lines with it, and what its groups are."""
    return [
        (number, "".join(match.groups()))
        for number, line in enumerate(text.splitlines(), 1)
        for match in re.finditer(pattern, line)
    ]


@pytest.mark.parametrize(
    ("pattern", "text", "lines"),
    [
        (SCALAR, "We have $D$\n$\\cD$, \\Delta, \\cC, ODE", [(1, ""), (2, "")]),
        (RATIO, "$\\beta=\\alpha_1/\\alpha_3$\n\\beta=\\frac{\\alpha_3^*}{\\alpha_1^*}", [(1, "13"), (2, "31")]),
    ],
)
def test_what_is_found(pattern: str, text: str, lines: list[tuple[int, str]]) -> None:
    assert found(pattern, text) == lines


def test_the_paper() -> None:
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    text = PAPER.read_text(encoding="utf-8")
    body = "\n" * text[: text.index(r"\begin{document}")].count("\n") + text[text.index(r"\begin{document}") :]
    assert [number for number, _ in found(SCALAR, body)] == [149]
    ratios = dict(found(RATIO, body))
    assert ratios.pop(380) == "13"
    assert len(ratios) > 3
    assert set(ratios.values()) == {"31"}
