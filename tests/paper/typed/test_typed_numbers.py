"""Numbers and short formulas that the ledger holds from prose, captions and tables are those of the quoted lines."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

import pytest
from flint import fmpq
from paper.typed.test_typed_formulas import changed, quoted

from gspot_verified.paper.numerics.oscillator_formulas import PRINTED_NUMBERS
from gspot_verified.paper.section_1 import section_1_sentences
from gspot_verified.paper.section_3 import section_3, section_3_captions, table_1, varsim1, varsim2
from gspot_verified.paper.section_4 import section_4_fast, section_4_matching, section_4_outer, section_4_slow
from gspot_verified.paper.section_4_5 import lift_off, section_4_5_signs
from gspot_verified.paper.section_5 import section_5_count, section_5_sentences
from gspot_verified.paper.section_6 import section_6, section_6_runs, section_6_theta

WORDS = {"one": "1", "four": "4", "seven": "7"}
N = r"(-?[\d.]+)"
Number = int | fmpq | str


class Printed(NamedTuple):
    """Lines of the source, a pattern whose groups are what is printed there, and what the ledger has, in its order."""

    first: int
    last: int
    pattern: str
    typed: Iterable[Number]


def decimal(text: str) -> fmpq:
    """A printed number, or a fraction, or a word for one."""
    text = WORDS.get(text, text)
    if "/" in text:
        return fmpq(*map(int, text.split("/")))
    digits = len(text.partition(".")[2])
    return fmpq(int(text.replace(".", "")), 10**digits)


def as_printed(latex: str) -> str:
    """A formula of a table or a sentence in the ledger's letters."""
    found = latex.replace(r"\beta", "beta").replace(r"\alpha_", "alpha")
    return re.sub(r"(\d)(?=[a-z(])", r"\1*", found)


def _power(value: fmpq) -> str:
    """The exponent of a power of ten."""
    return next(str(-k) for k in range(10) if value == fmpq(1, 10**k))


def _table() -> list[Printed]:
    """The rows of Table 1: measured numbers, the formula, theoretical numbers."""
    found = []
    for name, line in table_1.LINES.items():
        cells = r"\s*&\s*".join([N] * 3)
        pattern = rf"\}} &\s*{cells}\s*&\s*\$(.*?)\$\s*&\s*{cells}\s*\\\\"
        typed = [*table_1.MEASURED[name].values(), table_1.FORMULAS[name], *table_1.THEORETICAL[name].values()]
        found.append(Printed(line, line, pattern, typed))
    return found


def _again() -> list[Printed]:
    """The theoretical numbers as the other entry on them has them, by its order."""
    places = table_1.LINES
    by_name = {name: [text for text, other, _ in section_4_matching.TABLE if other == name] for name in places}
    cells = r"\s*&\s*".join([N] * 3)
    return [Printed(line, line, rf"\$\s*&\s*{cells}\s*\\\\", by_name[name]) for name, line in places.items()]


_CAPTION = section_3_captions
_ROWS = [
    *_table(),
    *_again(),
    Printed(889, 889, rf"beta={N}\$ & \$\\beta={N}\$ & \$\\beta={N}", table_1.BETAS),
    Printed(
        729,
        733,
        rf"eps=10\^\{{{N}\}}\$ with \$\\alpha_1\^\*=\\alpha_2\^\*={N}\$.*?beta= {N}.*?beta={N}.*?beta={N}.*?p\(0\)={N}",
        [
            _power(section_3.EPS),
            _CAPTION.ALPHA_1,
            *_CAPTION.BETAS.values(),
            _CAPTION.FIRST_P,
        ],
    ),
    Printed(733, 733, rf"nu={N}\$, \${N}\$, {N}, {N}, {N} \$y", _CAPTION.NU),
    Printed(733, 733, rf"nu={N}\$, \${N}\$, {N}, {N}, {N} \$y", varsim1.FACTORS),
    Printed(946, 947, rf"u\(0\)={N}\$ and \$\\chi={N}\$.*?chi={N}\$", [varsim2.FIRST_SLIP, 0, 1]),
    Printed(949, 952, rf"nu={N}\$ and\s+\${N}\$.*?in (\w+) out of (\w+) cases", [
        *dict.fromkeys(nu for _, nu in varsim2.RUNS), varsim2.WITHOUT_STICK, len(varsim2.RUNS),
    ]),
    Printed(986, 986, r"(\d)rd-order", [section_4_outer.PRINTED["4-order"]["order"]]),
    Printed(1109, 1111, rf"the sum\s+of the eigenvalues is \${N}\$.*?product is \$(-p)\$", [
        section_4_fast.PRINTED["4-roots-sum"]["sum"].removesuffix(" + 0*p"),
        section_4_fast.PRINTED["4-roots-sum"]["product"],
    ]),
    Printed(380, 380, r"beta=(\\alpha_1)/(\\alpha_3)\$", [
        section_4_slow.PRINTED["1-beta"][part] for part in ("numerator", "denominator")
    ]),
    Printed(1269, 1271, r"is negative.*?in \((\S+),(\S+)\).*?in \((\S+),(\S+)\)\$", [
        section_4_5_signs.PRINTED["S-gamma-intervals"][part]
        for part in ("negative from", "negative to", "positive from", "positive to")
    ]),
    Printed(1303, 1303, r"log\(\\eps\)\^\{(\S+)\}\$", [lift_off.PRINTED["S-growth"]["power"]]),
    Printed(1436, 1438, r"\$(m\+1)\$.*?\$(m\+5)\$.*?specify (\w+) further", [
        section_5_count.PRINTED[part].replace(" ", "").removesuffix("+0*m")
        for part in ("conditions", "equations", "left")
    ]),
    Printed(1651, 1652, r"system of (\w+) coupled ODEs.*?and (\w+) algebraic",
            section_5_sentences.KINDS["printed"].values()),
    Printed(333, 335, r"parameter \$\\eps\^(\d)\$", [section_1_sentences.STIFFNESS["printed"]]),
    Printed(2190, 2191, rf"beta=(\S+)\$, \$\\kappa={N}\$.*?={N}\$,\s+\$.*?={N}\$, and \$.*?={N}\$", [
        *section_6.CASE.values(), *PRINTED_NUMBERS.values(),
    ]),
    Printed(2192, 2192, r"eps=10\^\{(-6)\}", [_power(section_6_runs.EPSILON)]),
    Printed(2195, 2195, rf"phi\^\*\+0\.1,.*?={N}\\text.*?phi\^\*\+0\.1,.*?={N}$", section_6_runs.STARTS.values()),
    Printed(2237, 2237, r"M=(\d+)\$", [section_6_theta.ORDER]),
    Printed(2251, 2251, r"t=10\^\{(-3)\}", [_power(section_6_runs.PRINTED_TIME)]),
]  # fmt: skip


def said(row: Printed, latex: str = "") -> list[str] | None:
    """What is printed; ``None`` where the pattern is not there once."""
    latex = latex or "\n".join(quoted()[line] for line in range(row.first, row.last + 1))
    found = list(re.finditer(row.pattern, latex, re.DOTALL))
    return list(found[0].groups()) if len(found) == 1 else None


def is_the_same(printed: str, typed: Number) -> bool:
    """Whether a printed number or formula is the ledger's; both as texts where neither is a number."""
    if isinstance(typed, str) and re.search(r"[a-z]", typed + printed) and printed not in WORDS:
        return as_printed(printed) == typed.replace(" ", "")
    return decimal(printed) == (decimal(typed) if isinstance(typed, str) else fmpq(typed))


def holds(row: Printed, latex: str = "") -> bool:
    """Whether all that is printed is what the ledger has."""
    printed, typed = said(row, latex), list(row.typed)
    if printed is None or len(printed) != len(typed):
        return False
    return all(is_the_same(*pair) for pair in zip(printed, typed, strict=True))


@pytest.mark.parametrize("row", _ROWS, ids=lambda row: f"{row.first} to {row.last}")
def test_the_typed_number_is_the_printed_one(row: Printed) -> None:
    assert said(row) is not None
    assert holds(row), (said(row), list(row.typed))


@pytest.mark.parametrize("row", _ROWS, ids=lambda row: f"{row.first} to {row.last}")
def test_another_printed_number_is_noticed(row: Printed) -> None:
    """Each digit and each sign within what is compared; a word for a number too."""
    latex = "\n".join(quoted()[line] for line in range(row.first, row.last + 1))
    [found] = re.finditer(row.pattern, latex, re.DOTALL)
    for group in range(1, len(found.groups()) + 1):
        start, end = found.span(group)
        others = list(changed(found[group])) or ["seven"]
        for other in others:
            assert not holds(row, latex[:start] + other + latex[end:]), (found[group], other)
