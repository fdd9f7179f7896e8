"""What the sign of C_1 means at a G-spot, and by which hypothesis of Theorem R nothing is said (papers_rule.md)."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.mechanisms.fates import spot_sides as module
from gspot_verified.mechanisms.fates.spot_sides import SpotSides, spot_sides
from gspot_verified.mechanisms.shipped import shipped_mechanism

MODEL = shipped_mechanism("model system")


@pytest.mark.parametrize(
    ("alpha_3", "below", "above"),
    [("-3/2", "lift-off", "impact"), ("-5/2", "impact", "lift-off"), ("-7/2", "lift-off", "impact")],
)
def test_the_sides_change_at_each_integer(alpha_3: str, below: str, above: str) -> None:
    """As Gamma(-beta) does."""
    found = spot_sides(shipped_mechanism("model system", alpha_3=alpha_3))
    assert (found.case, found.below, found.above, found.why) == ("III", below, above, "")
    assert found.beta.contains(-fmpq(*map(int, alpha_3.split("/"))))
    assert found.evidence is not None


def test_beta_is_a_ratio() -> None:
    found = spot_sides(shipped_mechanism("model system", alpha_1="-2", alpha_3="-5"))
    assert found.beta.contains(fmpq(5, 2))
    assert found.below == "impact"


def said(found: SpotSides) -> str:
    assert (found.below, found.above, found.evidence) == (None, None, None)
    return found.why


def test_what_is_not_case_iii() -> None:
    assert said(spot_sides(shipped_mechanism("rod"))) == "Theorem R is about Case III: Case II"
    none = spot_sides(shipped_mechanism("model system", alpha_2="1"))
    assert said(none).startswith("Theorem R is about Case III: ")
    assert "Case none" not in none.why
    assert "Case None" not in none.why


def test_what_theorem_r_does_not_hold_for(monkeypatch: pytest.MonkeyPatch) -> None:
    undamped = replace(MODEL, regularisation=Regularisation.of(1, 1, 0))
    assert said(spot_sides(undamped)) == "the contact has no damper (c = 0): nothing is damped"
    assert said(spot_sides(shipped_mechanism("model system", alpha_3="-2"))) == "beta is, or may be, an integer"
    monkeypatch.setattr(module, "independent", lambda *_: None)
    assert said(spot_sides(MODEL)) == "p, b, y, v may be dependent at the G-spot"
