"""Each statement names its system, and the two systems agree where the theorem says so."""

from __future__ import annotations

import inspect
import json
from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import Outcome, iwc
from gspot_verified.compliant.contact.iwc import BALLS_CAVEAT, compliant_iwc, iwc_over_balls
from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.leading_order.iwc import CAVEAT
from gspot_verified.leading_order.iwc import leading_order_iwc as leading_order
from gspot_verified.leading_order.iwc_over_balls import iwc_over_balls as leading_order_over_balls
from gspot_verified.numbers.balls import working_bits


def test_the_theorem_takes_the_place_of_the_caveat() -> None:
    text = str(iwc("5/2"))
    assert "proved: at leading order" in text
    assert "proved: on the slow manifold of the compliant model" in text
    assert "(0, 0.894881353)" in text
    assert text.count("every τ < -10") == 2
    assert CAVEAT not in text
    assert CAVEAT in str(iwc("27/2"))


def test_between_the_two_thresholds_the_systems_differ() -> None:
    """eps = 0.14 lies above eps_0 at leading order, 0.1343, and below the exact one, 0.14579 (beta = 9/2)."""
    found = iwc("9/2", epsilon="0.14")
    assert found.slow is not None
    assert found.leading.verdict.outcome is Outcome.REFUTED
    assert found.slow.verdict.outcome is Outcome.PROVED
    assert found.verdict is found.slow.verdict
    place = fmpq(4866881417624873, 2 * 10**15)
    assert found.leading.force.value(place, "0.14") < 0
    assert slow_force(found.leading.force, place, fmpq(14, 100)) > 0
    above = iwc("9/2", epsilon="0.15")
    assert above.slow is not None
    assert above.slow.verdict.outcome is Outcome.REFUTED


def test_below_1() -> None:
    second = iwc("1/2", alpha_2=1)
    assert second.slow is not None
    assert second.slow.verdict.statement.endswith("for every real τ and every ε > 0")
    assert "as well" not in str(second)
    first = iwc("1/2")
    assert first.slow is not None
    assert first.slow.threshold is not None
    assert first.leading.epsilon_0 is not None
    assert first.slow.threshold.lower is not None
    assert first.slow.threshold.lower > first.leading.epsilon_0
    assert not first.slow.whole_line


def test_to_the_left_only_with_a_start_where_the_function_is_not_negative() -> None:
    """At 3/10 the function at leading order is < 0 and still decreasing: nothing is said to the left above eps_0."""
    found = iwc("5/2", tau_start="1/2")
    assert found.slow is not None
    assert found.leading.whole_line
    assert not found.slow.whole_line


@pytest.mark.parametrize("options", [{}, {"epsilon": "1/2"}, {"c1": 1}, {"tau_start": 5}, {"beta": "27/2"}])
def test_json(options: dict[str, object]) -> None:
    data = json.loads(json.dumps(iwc(**{"beta": "7/2", **options}).to_json()))  # type: ignore[arg-type]
    systems = [statement["system"] for statement in data["statements"]]
    assert systems[0] == "leading order"
    assert (data["caveat"] is None) == ("slow manifold" in systems)
    assert (data["slow_manifold"] is None) == ("slow manifold" not in systems)


def test_epsilon_outside_the_range_of_the_slow_solution_is_undecided() -> None:
    found = iwc("5/2", epsilon=10**7)
    assert found.slow is not None
    assert found.slow.verdict.outcome is Outcome.UNDECIDED
    assert iwc("7/2", tau_start=5, epsilon=10**7).verdict.outcome is Outcome.PROVED


def test_above_5_the_leading_order_is_no_lower_bound() -> None:
    """At beta = 21/4 the exact eps_0 is smaller than the one at leading order: in between the two differ."""
    found = iwc("21/4")
    assert found.slow is not None
    assert found.slow.threshold is not None
    assert found.slow.threshold.upper is not None
    assert found.leading.epsilon_0 is not None
    assert found.slow.threshold.upper < found.leading.epsilon_0
    between = (found.slow.threshold.upper + found.leading.epsilon_0) / 2
    assert found.leading.force.value(-10, between) > 0
    at = iwc("21/4", epsilon=between)
    assert at.slow is not None
    assert at.leading.verdict.outcome is Outcome.PROVED
    assert at.slow.verdict.outcome is Outcome.REFUTED


def test_the_arguments_are_those_of_the_leading_order() -> None:
    for here, there in ((compliant_iwc, leading_order), (iwc_over_balls, leading_order_over_balls)):
        assert [(p.name, p.default) for p in inspect.signature(here).parameters.values()] == [
            (p.name, p.default) for p in inspect.signature(there).parameters.values()
        ]


def test_the_caveat_names_what_is_open() -> None:
    """At one beta that no theorem covers, and over balls on the side where the contact is lost: nothing is stated about
    the compliant model there. At one beta on that side the lift-off is."""
    one = iwc("27/2")
    assert (one.compliant, one.caveat) == (None, CAVEAT)
    with working_bits(128):
        alphas = (arb(-1), arb(-1), arb(fmpq(-3, 2), fmpq(1, 10**9)))
    impact = iwc_over_balls(*alphas, tau_start=-1)
    assert impact.slow is not None
    assert impact.caveat is None
    assert impact.leading.force is not None
    lost = iwc_over_balls(*alphas, c1=-impact.leading.force.direction, tau_start=-1)
    assert (lost.compliant, lost.caveat) == (None, BALLS_CAVEAT)
    lifted = iwc("3/2", c1=-impact.leading.force.direction, tau_start=-1, epsilon="1/100", digits=5)
    assert lifted.slow is None
    assert lifted.lift_off is not None
    assert lifted.compliant is lifted.lift_off
    assert lifted.verdict is lifted.lift_off.verdict
    assert lifted.lift_off.uniform is not None
    assert [statement.verdict for statement in lifted.statements[1:]] == [lifted.verdict, lifted.lift_off.uniform]
    at_one_epsilon = replace(lifted, lift_off=replace(lifted.lift_off, uniform=None))
    assert at_one_epsilon.statements == lifted.statements[:2]


def test_over_balls_the_half_line_is_named_unless_a_theorem_holds_on_the_whole_line() -> None:
    """At beta = 7/2 the function falls below 0 to the left of 5; from there on it is positive, for every epsilon."""
    with working_bits(128):
        late, early = ((arb(-1), arb(second), arb(third, fmpq(1, 10**9))) for second, third in ((-1, -3.5), (1, -0.5)))
    from_5 = iwc_over_balls(*late, tau_start=5)
    everywhere = iwc_over_balls(*early, tau_start=5)
    for found, where in ((from_5, "every τ in [5, inf)"), (everywhere, "every real τ")):
        assert found.leading.every_epsilon
        assert found.slow is not None
        assert found.slow.verdict.outcome is Outcome.PROVED
        assert ", for all α1, α2, α3 in the balls, β = " in found.slow.verdict.statement
        assert found.slow.verdict.statement.endswith(f": λ_N > 0 for {where} and every ε > 0")
    assert (from_5.slow.start, everywhere.slow.start) == (fmpq(5), None)  # type: ignore[union-attr]
    assert not iwc_over_balls(*late, tau_start=5).leading.whole_line
    bounded = iwc_over_balls(*late)
    assert bounded.slow is not None
    assert bounded.leading.epsilon_0 is not None
    assert "every ε in (0, " in bounded.slow.verdict.statement


SYSTEM = "with β = 7/3, α1 = -1, α2 = -1, α3 = -7/3, C1 = "


@pytest.mark.parametrize("charge", ["-1", "1", "-0.5"])
@pytest.mark.parametrize("options", [{}, {"epsilon": "1/100"}, {"epsilon": 10**7}, {"tau_start": 5}])
def test_each_statement_names_its_numbers(charge: str, options: dict[str, Any]) -> None:
    """Statements about two C_1, of which one is false of the other, had the same text."""
    found = iwc("7/3", c1=charge, digits=6, **options)
    systems = {"leading order": "at leading order", "slow manifold": "on the slow manifold of the compliant model"}
    for stated in found.statements:
        begin, _, rest = stated.verdict.statement.partition(f" {SYSTEM}{charge}")
        assert (begin, rest[:1] in {":", ","}) == (systems[stated.system], True)


def test_the_two_times_have_two_names() -> None:
    found = iwc("3/2", c1=-1, digits=6)
    assert found.lift_off is not None
    assert "changes sign at τ_LO, τ_LO in (" in found.leading.verdict.statement
    assert "changes sign at τ_lo, τ_lo in (" in found.lift_off.verdict.statement
    assert "τ_lo" not in found.leading.verdict.statement


@pytest.mark.parametrize("beta", ["5/2", "1/2"])
def test_the_latest_start(beta: str) -> None:
    """T = τ/η is a ball there, which is not certainly below its own bound."""
    found = iwc(beta, c1=1, tau_start=10**6)
    assert found.verdict.outcome is found.leading.verdict.outcome is Outcome.REFUTED
