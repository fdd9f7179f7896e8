"""Which derivative diverges: the borders of each step, and what the checks say that they tried."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.paper.section_3 import section_3_smoothness as ledger

PRINTED = {fmpq(1, 2): 0, fmpq(3, 2): 1, fmpq(5, 2): 2}


def stub(patch: pytest.MonkeyPatch, error: arb, *exponents: fmpq) -> None:
    """The error of a regression, and the limit exponents of y, v, b (over ε²: less by 2)."""
    by_name = dict(zip(("y", "v", "b"), exponents, strict=True))
    patch.setattr(ledger, "regression_error", lambda *_: error)
    patch.setattr(ledger, "limit_exponent", lambda _, name: by_name[name])


@pytest.mark.parametrize("beta", PRINTED)
def test_the_printed_orders(beta: fmpq) -> None:
    for order in range(3):
        assert ledger.as_printed(beta, order) is True
        assert (ledger.exponent_over_scale(beta, order) < 0) is (order >= PRINTED[beta])
    assert ledger.exponent_over_scale(beta, PRINTED[beta]) == fmpq(-1, 3)


@pytest.mark.parametrize(
    ("error", "exponent", "answers"),
    [
        ("0.1", fmpq(7, 3), [True, False]),
        ("0.1", fmpq(5, 3), [False, True]),
        ("0.4", fmpq(7, 3), [None, None]),
        ("0.4", fmpq(5, 3), [None, None]),
        ("0", fmpq(2), [None, None]),  # neither sign
        ("1/2", fmpq(3, 2), [None, None]),  # the error reaches it
        ("1/2", fmpq(5, 2), [None, None]),
    ],
)
def test_an_exponent_has_its_sign_beyond_the_error(
    monkeypatch: pytest.MonkeyPatch, error: str, exponent: fmpq, answers: list[bool | None]
) -> None:
    """For β = 3/2 the order 0 must not diverge, and the order 1 must."""
    stub(monkeypatch, arb(fmpq(1, 2)) if error == "1/2" else arb(error), exponent, exponent, fmpq(9))
    assert [ledger.as_printed(fmpq(3, 2), order) for order in (0, 1)] == answers


@pytest.mark.parametrize(
    ("large", "small", "answers"),
    [
        (arb(1), arb(-2), [False, True]),
        (arb(-2), arb(1), [True, False]),
        (arb(2, 1), arb(2), [None, None]),
    ],
)
def test_growth_between_two_epsilon(
    monkeypatch: pytest.MonkeyPatch, large: arb, small: arb, answers: list[bool | None]
) -> None:
    """The deviations over ε² at ε = 10^-3 and 10^-5, for β = 3/2."""
    over = {fmpq(1, 1000): large, fmpq(1, 100000): small}

    def deviations(beta: fmpq, nu: fmpq, epsilon: fmpq) -> dict[str, arb]:
        assert (beta, nu) == (fmpq(3, 2), 2)
        return dict.fromkeys("yvb", over[epsilon] * epsilon**2)

    monkeypatch.setattr(ledger, "deviations", deviations)
    assert [ledger.grows(fmpq(3, 2), order) for order in (0, 1)] == answers


def test_each_sentence_has_its_lines_its_words_and_its_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = ledger.deviations
    asked = set()

    def deviations(beta: fmpq, nu: fmpq, epsilon: fmpq) -> dict[str, arb]:
        asked.add((beta, nu, epsilon))
        return honest(beta, nu, epsilon)

    monkeypatch.setattr(ledger, "deviations", deviations)
    lines = ("lines 799 to 800", "lines 801 to 802", "lines 802 to 803")
    words = ("y itself", "the first derivative of y", "the second derivative of y")
    assert list(ledger.ENTRIES) == ["3-smooth-1_2", "3-smooth-3_2", "3-smooth-5_2"]
    for order, entry in enumerate(build() for build in ledger.ENTRIES.values()):
        assert entry.label == lines[order]
        assert f"at the G-spot {words[order]} has size ε^(-1/3)" in entry.statement
        assert ("the derivatives of lower order" in entry.statement) is (order > 0)  # of y itself there are none
        balls, points = entry.checks
        assert balls.what.endswith("every ε <= 1/2500")
        assert points.what == "certified values at ε = 10^-3 and 10^-5, ν = 2"
        sizes = [text.split(": [")[1].split(" ")[0] for text in points.finding.split("; ")]
        assert [text.split(":")[0] for text in points.finding.split("; ")] == ["ε = 1/1000", "ε = 1/100000"]
        # Like ε^(-1/3): 100^(1/3) = 4.64.
        assert 4 < float(sizes[1]) / float(sizes[0]) < 5.5
    assert asked == {(beta, 2, fmpq(1, 10**k)) for beta in PRINTED for k in (3, 5)}


def test_the_size_is_asked_for_beside_the_signs(monkeypatch: pytest.MonkeyPatch) -> None:
    stub(monkeypatch, arb("0.01"), fmpq(7, 4), fmpq(1), fmpq(1))
    (balls, _) = ledger.ENTRIES["3-smooth-1_2"]().checks
    assert balls.agrees is False  # it diverges, and not like ε^(-1/3)
