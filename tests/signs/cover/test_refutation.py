"""No point outside the asked set refutes, and nobody says "refuted" of a set by another way."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

import gspot_verified
from gspot_verified import Outcome, Range
from gspot_verified.numbers.evidence import less
from gspot_verified.signs.cover.refutation import Failure, Point, refutation

PACKAGE = Path(gspot_verified.__file__).parent
SAYS_REFUTED = {
    "verdict.py": "where it is defined",
    "signs/cover/refutation.py": "points of ranges, checked",
    "paper/checks/entry.py": "two failing checks of one claim of the paper",
    "scenes/certified/certified_result.py": "an absence that is certainly violated along the run",
    "expansion/time_series.py": "the name of a coefficient that differs",
    "mechanisms/spots/g_spot_list.py": "there is a G-spot: no point refutes it, the exclusion of every box does",
}
ENDS = st.fractions(-3, 3, max_denominator=4)


def always(*_: fmpq) -> Failure:
    """A failure everywhere, to see what the ranges let through."""
    return "it fails", less(0, 1)


@given(ENDS, ENDS, st.booleans(), st.booleans(), st.lists(ENDS, min_size=1, max_size=6))
def test_only_points_of_the_range_serve(
    first: Fraction, second: Fraction, left: bool, right: bool, points: list[Fraction]
) -> None:
    lower, upper = sorted((first, second))
    if lower == upper:
        left = right = True
    asked = Range(to_fmpq(lower), to_fmpq(upper), left, right)
    inside = [p for p in points if lower < p < upper or (left and p == lower) or (right and p == upper)]
    found = refutation("it holds", {"x": asked}, [(to_fmpq(p),) for p in points], always)
    if not inside:
        assert found is None
        return
    assert found is not None
    assert found.point == (to_fmpq(inside[0]),)
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.verdict.statement == "it holds"
    assert found.verdict.witness == f"it fails at x = {inside[0]}"


@pytest.mark.parametrize(
    ("text", "point", "serves"),
    [
        ("0..1", 0, False),
        ("[0..1)", 0, True),
        ("[0..1)", 1, False),
        ("(0..1]", 1, True),
        ("-inf..1", -(10**9), True),
        ("-inf..1", 1, False),
        ("[1..inf)", 1, True),
        ("(1..inf)", 1, False),
        ("7/3", 2, False),
    ],
)
def test_open_and_closed_ends(text: str, point: int, serves: bool) -> None:
    found = refutation("it holds", {"x": Range.parse(text, "x")}, [(fmpq(point),)], always)
    assert (found is not None) is serves


def test_every_number_of_the_point_must_lie_in_its_range() -> None:
    asked = {"τ": Range.parse("0..1", "τ"), "β": Range.parse("[2..3]", "β")}
    half = fmpq(1, 2)
    outside: list[Point] = [(half, fmpq(1)), (fmpq(2), fmpq(2)), (fmpq(0), fmpq(2)), (fmpq(2), half)]
    assert refutation("it holds", asked, outside, always) is None
    found = refutation("it holds", asked, [*outside, (half, fmpq(3))], always)
    assert found is not None
    assert found.verdict.witness == "it fails at τ = 1/2, β = 3"


def test_outside_the_ranges_nothing_is_asked() -> None:
    asked_at: list[fmpq] = []

    def failure(x: fmpq) -> Failure | None:
        asked_at.append(x)
        return None

    points = [(fmpq(k),) for k in range(-2, 3)]
    assert refutation("it holds", {"x": Range.parse("[0..1]", "x")}, points, failure) is None
    assert asked_at == [0, 1]


def test_a_point_outside_one_of_two_ranges_is_not_asked() -> None:
    def failure(*_: fmpq) -> Failure | None:
        raise AssertionError("asked")

    asked = {"x": Range.parse("[0..1]", "x"), "y": Range.parse("[0..1]", "y")}
    points: list[Point] = [(fmpq(0), fmpq(2)), (fmpq(2), fmpq(0)), (fmpq(-1), fmpq(1))]
    assert refutation("it holds", asked, points, failure) is None
    with pytest.raises(AssertionError, match="asked"):
        refutation("it holds", asked, [(fmpq(0), fmpq(1))], failure)


def test_a_point_that_is_not_certain_does_not_refute() -> None:
    found = refutation(
        "x < 1", {"x": Range.parse("[0..2]", "x")}, [(fmpq(0),), (fmpq(2),)], lambda x: ("x > 1", less(1, x))
    )
    assert found is not None
    assert found.point == (2,)
    assert str(found.verdict.against) == "2 = 2; 0 <= 2; 2 <= 2; 1 < 2"


def test_a_range_that_says_that_it_holds_a_point_and_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    """The ends are compared as evidence, whatever the range answers."""
    monkeypatch.setattr(Range, "contains", lambda *_: True)
    for text, point in (("[0..1]", 2), ("0..1", 0), ("0..1", 1), ("[0..inf)", -1), ("(-inf..0]", 1)):
        assert refutation("it holds", {"x": Range.parse(text, "x")}, [(fmpq(point),)], always) is None


def test_a_point_of_another_dimension_is_an_error() -> None:
    asked = {"x": Range.parse("0..1", "x")}
    for point in ((), (fmpq(1, 2), fmpq(1, 2))):
        with pytest.raises(ValueError, match="zip"):
            refutation("it holds", asked, [point], always)


def test_nobody_else_says_refuted(package_trees: Mapping[Path, ast.Module]) -> None:
    """A call of ``Verdict.refuted`` or ``Verdict(...)`` elsewhere would go round the check of the witness."""
    said = set()
    for path, tree in package_trees.items():
        for node in ast.walk(tree):
            named = isinstance(node, ast.Attribute) and node.attr == "refuted" and ast.unparse(node.value) == "Verdict"
            built = isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] == "Verdict"
            if named or built:
                said.add(path.relative_to(PACKAGE).as_posix())
    assert said <= set(SAYS_REFUTED)
    assert "signs/cover/refutation.py" in said
