"""What StatementCertificate.v says of the pieces of a certificate is what proofs/check.py checks of them.

The formulas are read out of the text and compared with the checker at rational points; Coq itself runs the walk.
"""

from __future__ import annotations

import math
import random
import re
import shutil
import subprocess
from fractions import Fraction
from itertools import product
from pathlib import Path
from types import SimpleNamespace

import pytest
from coq_terms import STATEMENTS, Applied, evaluate_term, mutations, statement
from must_reject import mutate

check = mutate.checker()
METER = check.Meter(check.Limits(), 10**18)


def between(text: str, before: str, after: str) -> str:
    """The one part of a text between two others."""
    found = re.findall(re.escape(before) + "(.*?)" + re.escape(after), text)
    assert len(found) == 1, found
    return str(found[0])


LEVEL = Fraction(3, 11)
SYSTEMS = [
    check.System([Fraction(-2), Fraction(second), -2 * beta], Fraction(c1), beta)
    for beta in (Fraction(3, 2), Fraction(5, 2), Fraction(13, 3))
    for second, c1 in (("-1", "1/3"), ("-7/5", "-4"))
]


def balanced(system: check.System) -> Fraction:
    """α₁ = -2, β = 5/2, that is 3n = 2h: the rational ε at which the deviation at the level is the mean force."""
    first, second, third = system.alpha
    return second / (abs(system.c1 / third) * system.beta * LEVEL * (third - first))


COMPARED = statement("compared").partition(":= ")[2]


def compared_as_checked(text: str) -> bool:
    """The text is on the same side of 1 as the checker's numbers; where they balance both are equal to 1."""
    for system in SYSTEMS:
        names = dict(zip(("a1", "a2", "a3"), system.alpha, strict=True))
        names |= {"C1": system.c1, "level": LEVEL, "Rabs": Applied(1, abs)}
        names |= {"h": (system.beta - 1).numerator, "n": system.beta.denominator}
        points = [Fraction(1, 50), Fraction(3), Fraction(10**4), *([balanced(system)] if system.beta == 2.5 else [])]
        for epsilon in points:
            try:
                value = evaluate_term(text, names | {"eps": epsilon})
            except (AssertionError, ZeroDivisionError, TypeError):
                return False
            if (value > 1) - (value < 1) != system.compared(epsilon, LEVEL, METER):
                return False
    return True


def test_the_comparison_of_the_force_with_its_mean() -> None:
    assert all(system.compared(balanced(system), LEVEL, METER) == 0 for system in SYSTEMS if system.beta == 2.5)
    assert compared_as_checked(COMPARED)
    assert [mutated for mutated in mutations(COMPARED) if compared_as_checked(mutated)] == []


LEFT = between(statement("piece_checked"), "| left_piece X => ", " | sign_piece")
COUNT = between(LEFT, "let N := ", " in")
ENDS = re.findall(r"Rabs \((.*?) - INR i\)", LEFT)
BOUND = LEFT.rpartition(" < ")[2]
COLUMNS = [
    (m, m + Fraction(low), m + Fraction(high)) for m in (1, 2, 3, 4, 8) for low, high in (("1/5", "2/3"), ("0", "1"))
]


def left_as_checked(count: str, ends: list[str], bound: str) -> bool:
    """Just above and just below the least x that the text allows, the checker answers as the text does."""
    for m, low, high in COLUMNS:
        names = {
            "real": Applied(1, lambda x: x),
            "c": None,
            "INR": Applied(1, Fraction),
            "fact": Applied(1, math.factorial),
        }
        names |= {
            "column_low": Applied(1, lambda _, low=low: low),
            "column_high": Applied(1, lambda _, high=high: high),
        }
        try:
            n = evaluate_term(count, {"S": Applied(1, lambda k: k + 1), "m": m})
            factors = [[abs(evaluate_term(end, names) - i) for end in ends] for i in range(3 * n)]
            least = float(math.prod(map(max, factors)) / (3**n * math.factorial(n))) ** (1 / (3 * n))
            for x in (Fraction(least) * (1 + Fraction(side, 10**6)) for side in (-1, 1)):
                right = evaluate_term(bound, names | {"X": -x, "N": n})
                holds = math.prod(map(max, factors)) < right
                if holds != check.ColumnCheck.left_holds(SimpleNamespace(meter=METER), low - 1, high - 1, m - 1, x):
                    return False
        except (AssertionError, ZeroDivisionError, TypeError, OverflowError, ValueError):
            return False
    return True


def test_the_piece_left() -> None:
    assert len(ENDS) == 2
    assert left_as_checked(COUNT, ENDS, BOUND)
    assert not any(left_as_checked(mutated, ENDS, BOUND) for mutated in mutations(COUNT))
    assert not any(left_as_checked(COUNT, [mutated, ENDS[1]], BOUND) for mutated in mutations(ENDS[0]))
    assert not any(left_as_checked(COUNT, [ENDS[0], mutated], BOUND) for mutated in mutations(ENDS[1]))
    # The power is even if N is: then the sign of X does not matter, and only the odd N notice it.
    assert not any(left_as_checked(COUNT, ENDS, mutated) for mutated in mutations(BOUND))


def random_piece(cell: int, direction: int, choice: random.Random) -> tuple[str, object, int]:
    """A piece as Coq writes it, as the checker reads it, and the sign that it has when its hypotheses hold."""
    kind = choice.choice([*["sign"] * 6, *["monotone"] * 8, "left", "fold", "hinge", "right"])
    value = choice.choice((0, 1)) if kind == "right" else choice.choice((direction, direction, direction, -direction))
    text = {
        "left": "left_piece 0%R",
        "sign": f"sign_piece 0%R 0%R {str(value == 1).lower()}",
        "monotone": f"monotone_piece 0%R 0%R {str(value == 1).lower()}",
        "fold": "fold_piece 0%R 0%R",
        "hinge": "hinge_piece 0%R 0%R",
        "right": f"right_piece 0%R {value}",
    }[kind]
    sign = {"sign": value, "monotone": 0, "right": (-1) ** (cell + value)}.get(kind, 1)
    return text, check.Piece(Fraction(0), Fraction(0), kind, [], value), sign


def random_pieces(cell: int, length: int, choice: random.Random) -> list[tuple[str, object, int]]:
    """Pieces of which many fit together: a sign follows the direction of the pieces before it."""
    pieces: list[tuple[str, object, int]] = []
    for place in range(length):
        before = pieces[-1][1] if place else None
        fits = before is not None and before.kind in ("sign", "monotone") and (before.kind, place % 3) != ("sign", 0)
        pieces.append(random_piece(cell, before.value if fits else choice.choice((-1, 1)), choice))
    return pieces


def counted(cell: int, pieces: list[tuple[str, object, int]]) -> int | None:
    """The checker's number of zeros in a column [m, m + 1] if its pieces hold; None: rejected."""
    signs = {id(piece): sign for _, piece, sign in pieces}
    column = check.Column(Fraction(cell), Fraction(cell + 1), cell - 1, [piece for _, piece, _ in pieces])
    stub = SimpleNamespace(column=column, begin=lambda *_: None, piece_sign=lambda piece: signs[id(piece)])
    try:
        return int(check.number_of_zeros(stub))
    except check.Rejected:
        return None


@pytest.mark.slow
@pytest.mark.skipif(
    shutil.which("coqc") is None, reason="Coq is not installed: the walk of StatementCertificate.v is not run"
)
def test_the_walk_through_the_pieces(tmp_path: Path) -> None:
    choice = random.Random(13)
    cases = [
        (cell, random_pieces(cell, length, choice))
        for cell, length in product(range(1, 7), (0, 1, 2, *[3] * 20, *[4] * 20, *[5] * 20, *[6] * 20))
    ]
    expected = [counted(*case) for case in cases]
    assert {number for number in expected if number is not None} >= {0, 1, 2, 3}
    lists = ";\n".join(f"({cell}, [{'; '.join(text for text, _, _ in pieces)}])" for cell, pieces in cases)
    for file in STATEMENTS:
        shutil.copyfile(file, tmp_path / file.name)
    (tmp_path / "Walk.v").write_text(
        "From Coq Require Import Reals List.\nFrom Coquelicot Require Import Coquelicot.\n"
        "From GSpot Require Import StatementCertificate.\nImport ListNotations.\nOpen Scope nat_scope.\n"
        "Set Printing Width 100.\n"
        "Eval lazy in map (fun case => zeros_counted (Column m_infty 0%R (fst case) []) None None (snd case))\n"
        f"[{lists}].\n"
    )
    for name in (*(file.name for file in STATEMENTS), "Walk.v"):
        done = subprocess.run(
            ["coqc", "-q", "-R", ".", "GSpot", name],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=600,
            check=True,
        )
    found = [
        int(number) if number else None for number in re.findall(r"None|Some (\d+)", done.stdout.partition(": list")[0])
    ]
    assert found == expected
