"""The hypotheses of rigid slip on a box: a positive definite mass matrix, no negative friction, or the doubt is said.

Page: proofs/mechanism_hypotheses.md.
"""

from __future__ import annotations

import pytest
from flint import arb

from gspot_verified.mechanisms.derive.slip_hypotheses import FRICTION, MASS_MATRIX, SlipHypotheses
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Evidence


def doubt_of(found: Evidence | str) -> str | None:
    return found if isinstance(found, str) else None


@pytest.mark.parametrize(
    ("theta", "height", "doubt"),
    [
        (arb(0), arb(0), None),
        (arb(0, "0.1"), arb(1), None),
        (arb("0.49"), arb(0), None),
        (arb("-0.5"), arb(0), MASS_MATRIX),
        (arb("0.45", "0.1"), arb(0), MASS_MATRIX),
        (arb(1), arb(0), MASS_MATRIX),
        (arb("nan"), arb(0), MASS_MATRIX),
        (arb(0), arb(-2), None),  # no friction at all is allowed
        (arb(0), arb(-3), FRICTION),
        (arb(0), arb("-1.95", "0.1"), FRICTION),
        (arb(0), arb("nan"), FRICTION),
        (arb(1), arb(-3), MASS_MATRIX),
    ],
)
def test_the_determinant_and_the_friction(theta: arb, height: arb, doubt: str | None) -> None:
    """M = [[1, 2 theta, 0], [2 theta, 1, 0], [0, 0, 1]] is indefinite from |theta| = 1/2 on; mu = 2 + Y."""
    rows = [[1, "2*theta", 0], ["2*theta", 1, 0], [0, 0, 1]]
    hypotheses = SlipHypotheses(shift(lagrangian("rod", ["X", "Y", "theta"], rows, [0, 0, 0], "X", "Y", "2 + Y")))
    state = [arb(0), height, theta, arb(0), arb(0), arb(0)]
    with working_bits(80):
        assert doubt_of(hypotheses.checked(state)) == doubt
        assert doubt_of(hypotheses.checked([*state, arb("nan")])) == doubt  # what follows the state is not read


@pytest.mark.parametrize(
    ("A", "C", "p", "doubt"),
    [(2, 1, 0, None), (1, 1, 0, MASS_MATRIX), (2, 1, -1, MASS_MATRIX), (-2, -1, -2, MASS_MATRIX), (2, "w", 0, None)],
)
def test_fields_stand_for_the_mass_matrix(A: int, C: int | str, p: int, doubt: str | None) -> None:
    """A, B = C - p, C with A C > B^2 and A > 0, at w = 1."""
    B = f"{C} - ({p})"
    fields = from_fields(
        "fields", ["x", "u", "y", "v", "w"], ["u", 0, "v", 0, 0], [0, A, 0, B, 0], [0, B, 0, C, 0], "x", "y", 1
    )
    with working_bits(80):
        found = SlipHypotheses(shift(fields)).checked([arb(0), arb(1), arb(0), arb(0), arb(1)])
        assert doubt_of(found) == doubt


@pytest.mark.parametrize(("theta", "doubt"), [(1, None), (-1, MASS_MATRIX)])
def test_the_whole_mass_matrix_counts_where_it_is_given(theta: int, doubt: str | None) -> None:
    """M = diag(1, 1, theta): A = C = 1 and B = 0 at the contact are definite, whatever theta is."""
    rows = [[1, 0, 0], [0, 1, 0], [0, 0, "theta"]]
    hypotheses = SlipHypotheses(shift(lagrangian("rod", ["X", "Y", "theta"], rows, [0, 0, 0], "X", "Y", 1)))
    with working_bits(80):
        assert doubt_of(hypotheses.checked([arb(0), arb(0), arb(theta), arb(0), arb(0), arb(0)])) == doubt
