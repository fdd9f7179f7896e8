"""The checker at the ends of its range: honest certificates are verified within the limits, or the limit is named."""

from __future__ import annotations

import pytest
from flint import fmpq
from must_reject import mutate
from samples.far_certificates import brackets_certificate, sign_certificate

check = mutate.checker()
LAST, MIDDLE, HUNDRED = ((fmpq(399, 2), fmpq(399, 2)), (fmpq(301, 2), fmpq(301, 2)), (fmpq(201, 2), fmpq(201, 2)))


@pytest.fixture
def work(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    return mutate.work_of(check, monkeypatch)


@pytest.mark.parametrize(
    ("beta", "tau", "relation"),
    [
        (LAST, (fmpq(199), fmpq(200)), ">"),
        (HUNDRED, (200 - fmpq(1, 2**20), fmpq(200)), "<"),
        (LAST, (fmpq(-200), fmpq(-199)), "<"),
        (MIDDLE, (fmpq(-200), fmpq(-199)), "<"),
    ],
)
def test_a_sign_at_one_beta_is_verified(
    beta: tuple[fmpq, fmpq], tau: tuple[fmpq, fmpq], relation: str, work: list[int]
) -> None:
    """To the right the sign is (-1)^n, n < β < n + 1 (tails.md)."""
    text = check.main.check_text(sign_certificate(tau, beta))
    assert text == f"dΘ/dτ {relation} 0 for every τ in ({tau[0]}, {tau[1]}) and at β = {beta[0]}"
    assert sum(work) < 2 * 10**9


@pytest.mark.parametrize("n", [199, pytest.param(100, marks=pytest.mark.slow)])
def test_a_whole_cell_on_the_left_is_verified(n: int, work: list[int]) -> None:
    text = check.main.check_text(sign_certificate((fmpq(-200), fmpq(-199)), (fmpq(n), fmpq(n + 1))))
    assert text == f"dΘ/dτ < 0 for every τ in (-200, -199) and every β in ({n}, {n + 1})"
    assert sum(work) < 10**9


@pytest.mark.slow
@pytest.mark.parametrize("n", [199])
def test_a_whole_cell_on_a_wide_range_is_verified(n: int) -> None:
    assert check.main.check_text(sign_certificate((fmpq(-200), fmpq(-151)), (fmpq(n), fmpq(n + 1)))).startswith(
        "dΘ/dτ < 0"
    )


def test_zeros_at_a_large_beta(work: list[int]) -> None:
    data = brackets_certificate(fmpq(61, 2), fmpq(-40), fmpq(30))
    assert check.main.check_text(data).startswith("dΘ/dτ at β = 61/2 has exactly 10 real zeros, all simple")
    assert sum(work) < 10**9


@pytest.mark.slow
def test_zeros_near_the_largest_beta(work: list[int]) -> None:
    data = brackets_certificate(fmpq(399, 2), fmpq(-150), fmpq(80))
    assert check.main.check_text(data).startswith("dΘ/dτ at β = 399/2 has exactly 67 real zeros, all simple")
    assert sum(work) < check.limits.Limits().work * 10**9


RIGHT, LEFT = (fmpq(199), fmpq(200)), (fmpq(-200), fmpq(-199))


@pytest.mark.parametrize(
    ("name", "low", "high", "tau", "beta"),
    [
        ("work", 0, 1, LEFT, LAST),
        ("memory", 1, 160, RIGHT, LAST),
        ("tau", 199, 200, LEFT, LAST),
        ("beta", 199, 200, LEFT, LAST),
        ("bits", 500, 1000, RIGHT, LAST),
        ("splits", 0, 10, (fmpq(-8), fmpq(8)), (fmpq(1, 2), fmpq(1, 2))),
    ],
)
def test_the_limit_that_refuses_is_named_and_can_be_raised(
    name: str, low: int, high: int, tau: tuple[fmpq, fmpq], beta: tuple[fmpq, fmpq], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A true statement: refused by each limit alone, verified when that limit is raised on purpose."""
    monkeypatch.setattr(check.limits, "WORK_PER_BYTE", 0)
    data, wide = sign_certificate(tau, beta), check.limits.Limits(work=2)
    with pytest.raises(check.limits.Rejected, match=rf"{name}={low}[ ,].*on purpose: --limit (NAME|{name})=NUMBER"):
        check.main.check_text(data, wide._replace(**{name: low}))
    assert check.main.check_text(data, wide._replace(**{name: high})).startswith("dΘ/dτ")


@pytest.mark.parametrize("beta", [(fmpq(199), 199 + fmpq(1, 2**60)), (fmpq(100), fmpq(101))])
def test_a_zero_from_infinity_is_not_given_a_sign(beta: tuple[fmpq, fmpq]) -> None:
    """Just above an integer there is a zero far out: near 1/Γ(-b) = 0 the polynomial wins at τ = 200."""
    data = sign_certificate((fmpq(199), fmpq(200)), beta)
    with pytest.raises(check.limits.Rejected):
        check.main.check_text(data, check.limits.Limits(work=1))
