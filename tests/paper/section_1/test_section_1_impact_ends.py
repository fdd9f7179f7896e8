"""How an impact with p > 0 ends: the bound of u, by an impact that is followed impulse by impulse."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gspot_verified.paper.section_1 import section_1_sentences as ledger

A, B, C, MU = 1.0, 1.0, 2.0, 1.75
"""p = C - μB = 1/4, μA - B = 3/4, AC - B² = 1."""
_STEPS = 20_000


def ends_in_slip(u: float, r: float, energetic: bool) -> bool:
    """Whether u > 0 at the end of a rigid impact from v = -1, in small steps of the normal impulse."""
    v, step = -1.0, 4.0 / _STEPS
    impulse = work = back = gained = 0.0
    while v < 0:
        friction = -MU if u > 0 else -B / A
        u, v = max(u + (B + A * friction) * step, 0.0), v + (C + B * friction) * step
        impulse, work = impulse + step, work - v * step
    while gained < r * r * work if energetic else back < r * impulse:
        friction = -MU if u > 0 else -B / A
        u, v = max(u + (B + A * friction) * step, 0.0), v + (C + B * friction) * step
        back, gained = back + step, gained + v * step
    return u > 0


@pytest.mark.parametrize("energetic", [False, True])
@pytest.mark.parametrize("r", [0.25, 1.0])
def test_both_laws_have_the_same_bound(r: float, energetic: bool) -> None:
    """BOUND is that of p u, for v = -1."""
    bound = eval(ledger.BOUND, {}, {"k": MU * A - B, "r": r, "m": 1}) / (C - MU * B)
    assert ends_in_slip(1.01 * bound, r, energetic)
    assert not ends_in_slip(0.99 * bound, r, energetic)


def test_the_works_are_those_of_the_law() -> None:
    """The integral of v = -m + p P up to p P = i is i²/2 - m i, over p."""
    m, r = Fraction(3), Fraction(1, 2)
    values = {name: Fraction(0) for name in ledger.ALGEBRA.symbols} | {"m": m, "r": r}

    def work(impulse: str) -> Fraction:
        return eval(str(ledger.twice_the_work(impulse)).replace("^", "**"), {}, values)

    assert work("m") == -(m**2)
    assert work("(1 + r)*m") - work("m") == -(r**2) * work("m")
    assert ledger.works_have_the_same_bound() is True


def test_another_share_of_the_impulse_has_another_work(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = ledger.twice_the_work
    monkeypatch.setattr(ledger, "twice_the_work", lambda impulse: honest(impulse.replace("(1 + r)", "(1 + 2*r)")))
    assert ledger.works_have_the_same_bound() is False


@pytest.mark.parametrize(
    ("near", "answer"),
    [
        ({"p": "-x", "k": "m"}, True),
        ({"p": "x", "k": "A*x + B^2"}, True),
        ({"p": "x"}, False),
        ({"p": "x", "k": "A*x"}, False),
        ({"p": "x", "k": "A*x - m"}, False),
    ],
)
def test_the_sign_of_the_change_of_slip(monkeypatch: pytest.MonkeyPatch, near: dict[str, str], answer: bool) -> None:
    """B - μA < 0 for p <= 0, and for p > 0 where A p < k = AC - B²."""
    assert ledger.factor_is_negative()
    assert ledger.factor_is_negative_by_impulses()
    assert MU * A > B
    monkeypatch.setattr(ledger, "NEAR_THE_G_SPOT", (near,))
    assert [ledger.factor_is_negative(), ledger.factor_is_negative_by_impulses()] == [answer, answer]


@pytest.mark.parametrize("wrong", ["B - mu*C", "mu*A - B", "B - 2*mu*A"])
def test_the_sign_is_that_of_the_claimed_factor(monkeypatch: pytest.MonkeyPatch, wrong: str) -> None:
    monkeypatch.setitem(ledger.SLOPE, "u", wrong)
    assert not ledger.factor_is_negative()
    assert not ledger.factor_is_negative_by_impulses()


@pytest.mark.parametrize(("name", "wrong"), [("u", "A*T + 2*B*P"), ("v", "C*P + 2*B*T"), ("v", "2*C*P + B*T")])
def test_the_sign_is_that_of_these_impulses(monkeypatch: pytest.MonkeyPatch, name: str, wrong: str) -> None:
    monkeypatch.setitem(ledger.section_1_negative_p.STICK, name, wrong)
    assert not ledger.factor_is_negative_by_impulses()
