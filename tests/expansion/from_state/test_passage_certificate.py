"""Certificates of Theorem B are accepted, and what they say is so for the exact solution (proofs/from_state.md, 10)."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified.certificates.checker import check
from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.expansion.from_state.model_side import ModelSide, model_side
from gspot_verified.expansion.from_state.passage_certificate import passage_certificate
from gspot_verified.numbers.balls import ball, working_bits

CASES = [
    ("3/2", "-2", "1/3000"),
    ("3/2", "-1/2", "1/4500"),
    ("5/2", "-2/3", "1e-8"),
    ("7/3", "-3/4", "1/32000"),
    ("5/4", "-3", "1e-12"),
]


def asked(beta: str, b: str, epsilon: str) -> ModelSide:
    return model_side(beta, "1/2", b, epsilon=epsilon)


def drift_of(beta: fmpq, b: fmpq, epsilon: fmpq, p: fmpq) -> arb:
    """log of C at p over C at 1/2 for the start at rest, by the exact solution; the force is positive on the way."""
    model, half = compliant_model(beta, epsilon), fmpq(1, 2)
    force_before, mean = -b / half, 1 / (beta - 1)
    at_rest = (-2 * epsilon**2 * force_before, 0, -(epsilon**2) * force_before)
    state = compliant_state(half, b, *at_rest)
    for part in range(1, 9):
        assert force(model, state, -(half + (p - half) * part / 8), 20).force > 0
    there = force(model, state, -p, 20)
    excess = -there.b / ball(p) - ball(mean)
    return abs(excess / ball(force_before - mean) * (ball(p) / ball(half)) ** ball(1 - beta)).log()


@pytest.mark.parametrize(
    ("beta", "b", "epsilon"), [CASES[0], *(pytest.param(*case, marks=pytest.mark.slow) for case in CASES[1:])]
)
def test_a_certificate_is_accepted_and_the_exact_solution_does_what_it_says(
    beta: str, b: str, epsilon: str, tmp_path: Path
) -> None:
    side = asked(beta, b, epsilon)
    text = passage_certificate(side)
    file = tmp_path / "passage.cert"
    file.write_text(text, encoding="utf-8")
    result = check(file)
    assert result.verified, result.text
    assert f"for every ε in (0, {side.epsilon}]" in result.text
    statement = json.loads(text.splitlines()[0])["statement"]
    drift, scaled = fmpq(*map(int, statement["drift"].split("/"))), fmpq(int(statement["scaled"]))
    assert drift < 1
    for smaller in (1, 8):
        small = side.epsilon / smaller
        with working_bits(200):
            lowest = (ball(scaled**3 * small**2).root(3) * 1024).ceil().unique_fmpz()
            assert lowest is not None
            moved = drift_of(side.start.beta, side.start.b, small, max(fmpq(lowest, 1024), fmpq(1, 8)))
            assert abs(moved) < drift


def test_where_theorem_b_is_not_shown_there_is_no_certificate() -> None:
    side = asked("3/2", "-2", "1e-6")
    far = ModelSide(side.start, fmpq(1), side.c_1, side=None, ends=(), drift=None, verdict=side.verdict)
    with pytest.raises(ValueError, match="Theorem B is not shown for epsilon up to 1: "):
        passage_certificate(far)
