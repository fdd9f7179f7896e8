"""Certificates of lift-off and impact are accepted, and say what the verdict says (proofs/from_state.md, 11)."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified.certificates.checker import check
from gspot_verified.expansion.from_state.model_side import model_side
from gspot_verified.expansion.from_state.side_certificate import side_certificate

CASES = [
    ("3/2", "-2", "1e-7"),
    ("3/2", "-1/2", "1/4500"),
    ("5/4", "-3", None),
    ("5/2", "-2/3", "1e-6"),
    ("7/3", "-3/4", "1/32000"),
    ("7/2", "-1", "1e-12"),
]


@pytest.mark.parametrize(
    ("beta", "b", "epsilon"), [CASES[0], *(pytest.param(*case, marks=pytest.mark.slow) for case in CASES[1:])]
)
def test_a_certificate_is_accepted_and_says_what_the_verdict_says(
    beta: str, b: str, epsilon: str | None, tmp_path: Path
) -> None:
    side = model_side(beta, "1/2", b, epsilon=epsilon)
    text = side_certificate(side)
    file = tmp_path / "side.cert"
    file.write_text(text, encoding="utf-8")
    result = check(file)
    assert result.verified, result.text
    assert f"for every ε in (0, {side.epsilon}] and every start in contact at p = 1/2, b = {b} with" in result.text
    end = "contact is lost" if side.side == "lift-off" else f"until it exceeds {side.force}, with p < 0"
    assert end in result.text
    statement = json.loads(text.splitlines()[0])["statement"]
    by = fmpq(*map(int, statement["by"].split("/")))
    assert side.latest(side.epsilon) <= by <= 2 * side.latest(side.epsilon).upper()


@pytest.mark.slow
def test_other_springs_and_another_damper(tmp_path: Path) -> None:
    side = model_side("3/2", "1/2", -2, epsilon="1e-8", alpha_1="-3/2", alpha_2="-2/3", contact=(2, 1, "1/2"))
    file = tmp_path / "side.cert"
    file.write_text(side_certificate(side), encoding="utf-8")
    result = check(file)
    assert result.verified, result.text
    assert "α = (-3/2, -2/3, -9/4) and (k_1 ε², k_2 ε², c ε) = (2, 1, 1/2)" in result.text


def test_what_is_undecided_has_no_certificate() -> None:
    side = model_side("3/2", "1/2", -2, epsilon=1, within="1/3")
    assert side.side is None
    with pytest.raises(ValueError, match="no side is proved for epsilon up to 1"):
        side_certificate(side)


def test_what_the_checker_does_not_confirm_is_not_written() -> None:
    side = model_side("3/2", "1/2", -2, epsilon="1e-8")
    soon = replace(side, ends=tuple(replace(end, entered=end.entered / 10) for end in side.ends))
    with pytest.raises(ValueError, match="the checker does not confirm it: REJECTED "):
        side_certificate(soon)
