"""What StatementCertificate.v says of the pieces of a certificate is what proofs/checker checks of them.

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
from coq.coq_terms import STATEMENTS, Applied, evaluate_term, mutations, statement
from must_reject import mutate

check = mutate.checker()
METER = check.limits.Meter(check.limits.Limits(), 10**18)


def between(text: str, before: str, after: str) -> str:
    """The one part of a text between two others."""
    found = re.findall(re.escape(before) + "(.*?)" + re.escape(after), text)
    assert len(found) == 1, found
    return str(found[0])


LEVEL = Fraction(3, 11)
SYSTEMS = [
    check.force.System([Fraction(-2), Fraction(second), -2 * beta], Fraction(c1), beta)
    for beta in (Fraction(3, 2), Fraction(5, 2), Fraction(13, 3))
    for second, c1 in (("-1", "1/3"), ("-7/5", "-4"))
]


def balanced(system: check.force.System) -> Fraction:
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
                if holds != check.pieces.ColumnCheck.left_holds(
                    SimpleNamespace(meter=METER), low - 1, high - 1, m - 1, x
                ):
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


DIP = statement("dip_checked").partition(":= ")[2]
BOUND_BY_THETA = DIP.rpartition("-> ")[2].removesuffix(" < 0").replace("Derive (F b)", "Derive b")
RATIO = between(DIP, "let mu := ", " in")
PLACES = [(Fraction(4), Fraction(5)), (Fraction(5), Fraction(63, 10)), (Fraction(1, 7), Fraction(1))]


def dip_as_checked(ratio: str, bound: str) -> bool:
    """Where the bound is just below 0 the checker answers yes, just above it no: one b, chosen values of F and F'."""
    for (first, second), b, eta in product(PLACES[1:], (3, 4), (Fraction(5, 3), Fraction(1, 4))):
        slopes = {first: Fraction(-3, 2), second: Fraction(7, 5)}
        names = {"t1": first, "t2": second, "b": b, "eta0": eta}
        names |= {"Rpower": Applied(2, lambda x, y: x**y), "Derive": Applied(2, lambda _, t, s=slopes: s[t])}
        try:
            names["mu"] = evaluate_term(ratio, names)
            rest = evaluate_term(bound, names | {"F": Applied(2, lambda *_: 0)})
            for side in (-1, 1):
                values = {(first, 0): side * Fraction(1, 10**6) - rest} | {(t, 1): s for t, s in slopes.items()}
                negative = evaluate_term(bound, names | {"F": Applied(2, lambda _, t, v=values: v[t, 0])}) < 0
                column = check.pieces.Column(Fraction(b + 1), Fraction(b + 1), 3, [])
                stub = check.pieces.ColumnCheck(column, check.limits.Limits(), 10**18)
                scale = check.theta.Scale(4, 20, Fraction(1))
                stub.value = lambda box, order, _, v=values, s=scale: check.theta.Value(v[box[2], order], 0, 0, 0, s)
                if (negative, check.force.dips(stub, first, second, eta)) != (side < 0, side < 0):
                    return False
        except (AssertionError, KeyError, ZeroDivisionError, TypeError):
            return False
    return True


def test_the_piece_dip() -> None:
    assert dip_as_checked(RATIO, BOUND_BY_THETA)
    assert [mutated for mutated in mutations(RATIO) if dip_as_checked(mutated, BOUND_BY_THETA)] == []
    assert [mutated for mutated in mutations(BOUND_BY_THETA) if dip_as_checked(RATIO, mutated)] == []


def refused_place(first: Fraction, second: Fraction, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Whether the checker refuses a dip for its place, when what it computes from F holds."""
    column = check.pieces.Column(
        Fraction(4), Fraction(5), 3, [check.pieces.Piece(first, second, "dip", [first, second], 0)]
    )
    stub = SimpleNamespace(column=column, begin=lambda *_: None, limits=check.limits.Limits())
    monkeypatch.setattr(check.force, "dips", lambda *_: True)
    try:
        check.force.dip_holds(stub, Fraction(1))
    except check.limits.Rejected:
        return True
    return False


def refused_because(beta: str, epsilon: str, eta: str) -> str:
    """What the checker says of a statement without columns: it looks at the numbers first."""
    said = {"beta": beta, "epsilon": epsilon, "eta": eta, "kind": "slow_zeros"}
    with pytest.raises(check.limits.Rejected) as refused:
        check.force.check_slow_zeros(check.statements.Checker(said, [], check.limits.Limits(), 10**12))
    return str(refused.value)


def test_the_place_of_a_dip_its_eta_and_the_range(monkeypatch: pytest.MonkeyPatch) -> None:
    supposed = statement("slow_zeros_certificate").split(" -> ")
    assert DIP.split(" /\\ ")[:2] == ["0 < t1 < t2", "2 * t1 ^ 3 <= t2 ^ 3"]
    for first, second in [*PLACES, (Fraction(-1), Fraction(1))]:
        assert refused_place(first, second, monkeypatch) is not (0 < first < second and 2 * first**3 <= second**3)
    assert supposed[2:5] == ["4 <= x <= 5)", "0 < eta0", "eps0 <= 2 * eta0 ^ 3"]
    assert "columns" in refused_because("[4, 5]", "27/4", "3/2")
    assert refused_because("[4, 5]", "271/40", "3/2") == "2 η³ is less than ε"
    assert "inside [4, 5]" in refused_because("[39/10, 5]", "27/4", "3/2")
    assert "inside [4, 5]" in refused_because("[4, 51/10]", "27/4", "3/2")


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
    return text, check.pieces.Piece(Fraction(0), Fraction(0), kind, [], value), sign


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
    column = check.pieces.Column(Fraction(cell), Fraction(cell + 1), cell - 1, [piece for _, piece, _ in pieces])
    stub = SimpleNamespace(column=column, begin=lambda *_: None, piece_sign=lambda piece: signs[id(piece)])
    try:
        return int(check.statements.number_of_zeros(stub))
    except check.limits.Rejected:
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
    theirs = ("StatementChecker", "StatementForce", "StatementRun")  # which need the checkers themselves
    needed = [file for file in STATEMENTS if file.stem not in theirs]
    for file in needed:
        shutil.copyfile(file, tmp_path / file.name)
    (tmp_path / "Walk.v").write_text(
        "From Coq Require Import Reals List.\nFrom Coquelicot Require Import Coquelicot.\n"
        "From GSpot Require Import StatementCertificate.\nImport ListNotations.\nOpen Scope nat_scope.\n"
        "Set Printing Width 100.\n"
        "Eval lazy in map (fun case => zeros_counted (Column m_infty 0%R (fst case) []) None None (snd case))\n"
        f"[{lists}].\n"
    )
    for name in (*(file.name for file in needed), "Walk.v"):
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
