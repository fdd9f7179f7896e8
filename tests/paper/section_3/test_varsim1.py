"""The runs of Fig. varsim1: what is stated is what is checked, and each answer decides."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Rung
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.section_3 import varsim1

IMPACT, LIFT_OFF, TRIVIAL = (fmpq(3, 2), fmpq(1, 2)), (fmpq(3, 2), fmpq(2)), (fmpq(3, 2), fmpq(1))


@pytest.mark.parametrize("beta", list(varsim1.PANELS))
@pytest.mark.parametrize("nu", varsim1.FACTORS)
def test_the_initial_state_by_two_routes(beta: fmpq, nu: fmpq) -> None:
    epsilon = fmpq(1, 50)
    model, state = varsim1.initial_state(beta, nu, epsilon)
    assert model == compliant_model(beta, epsilon)
    assert state == paper_state(model, nu)


def test_the_runs_are_those_of_the_figure() -> None:
    assert {fmpq(1, 2): "a", fmpq(3, 2): "b", fmpq(5, 2): "c"} == varsim1.PANELS
    assert (fmpq(1, 4), fmpq(1, 2), 1, 2, 4) == varsim1.FACTORS
    assert {fmpq(1, 2): fmpq(1, 100), fmpq(3, 2): fmpq(1, 100), fmpq(5, 2): fmpq(1, 500)} == varsim1.EPSILON_0
    entry = varsim1.ENTRIES["3-varsim1c-1_4"]()
    assert entry.checks[0].rung is Rung.BALLS
    trivial = varsim1.ENTRIES["3-varsim1c-1"]()
    assert trivial.checks[0].rung is Rung.EXACT
    assert "every ε > 0" in trivial.statement
    assert f"every ε in (0, {varsim1.EPSILON_0[fmpq(5, 2)]}]" in entry.statement
    shown = ", ".join(f"10^-{len(str(int(1 / point))) - 1}" for point in varsim1.POINTS)
    assert entry.checks[1].what.endswith(f"at ε = {shown}")
    assert all(point == fmpq(1, 10 ** (len(str(int(1 / point))) - 1)) for point in varsim1.POINTS)


@pytest.mark.parametrize(("power", "time"), [(3, fmpq(2, 10**2)), (6, fmpq(2, 10**4)), (12, fmpq(2, 10**8))])
def test_a_time_near_two_in_the_scaled_one(power: int, time: fmpq) -> None:
    assert varsim1._some_time(fmpq(1, 10**power)) == time


@pytest.mark.parametrize("beta", varsim1.PANELS)
def test_each_note_says_which_fate_the_text_names(beta: fmpq) -> None:
    """Lines 783 to 785: the lower b(0) take an impact in panel (b), the higher ones in (c); b(0) falls with ν."""
    for nu in varsim1.FACTORS:
        lower = varsim1.initial_state(beta, nu, fmpq(1))[1].b < varsim1.initial_state(beta, fmpq(1), fmpq(1))[1].b
        named = {"a": "impact", "b": "impact" if lower else "lift-off", "c": "lift-off" if lower else "impact"}
        if varsim1.PANELS[beta] != "a" and nu == 1:
            named = dict.fromkeys("bc", "trivial")
        assert varsim1.printed_fate(beta, nu) == named[varsim1.PANELS[beta]]
        other = named[varsim1.PANELS[beta]] != varsim1.FATES[beta][nu]
        assert other is (varsim1.PANELS[beta] != "a" and nu != 1)
        assert ("names the other fate for this run" in varsim1.how_named(beta, nu)) is other


def test_the_note_of_a_run_whose_fate_is_as_printed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(varsim1.section_3.IMPACT, "printed", varsim1.section_3.IMPACT["corrected"])
    assert varsim1.how_named(fmpq(3, 2), fmpq(2)) == "names this fate for this run, by its side of b(0)"
    assert varsim1.how_named(fmpq(3, 2), fmpq(1)) == "has the trivial solution between the two fates"
    assert varsim1.how_named(fmpq(1, 2), fmpq(1)) == (
        "names this fate for all initial conditions that become attracted to the G-spot"
    )


def test_the_fates_of_the_figure() -> None:
    """Panel (a): all impacts; (b): above b(0) of the trivial solution; (c): below it."""
    assert [list(row.values()) for row in varsim1.FATES.values()] == [
        ["impact"] * 5,
        ["impact", "impact", "trivial", "lift-off", "lift-off"],
        ["lift-off", "lift-off", "trivial", "impact", "impact"],
    ]
    assert all(tuple(row) == varsim1.FACTORS for row in varsim1.FATES.values())
    assert list(varsim1.FATES) == list(varsim1.PANELS)


def test_the_trivial_solution_for_every_epsilon() -> None:
    found = {(beta, nu) for beta in varsim1.PANELS for nu in varsim1.FACTORS if varsim1.is_trivial(beta, nu)}
    assert found == {(fmpq(3, 2), 1), (fmpq(5, 2), 1)}


def test_a_run_that_is_not_seen_to_be_trivial_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not varsim1.is_trivial(fmpq(3, 2), fmpq(1001, 1000))
    monkeypatch.setattr(varsim1, "is_trivial", lambda *_: False)
    assert varsim1.ENTRIES["3-varsim1b-1"]().checks[0].agrees is None


@pytest.mark.parametrize("nu", varsim1.FACTORS)
def test_an_impact_goes_down_without_bound(monkeypatch: pytest.MonkeyPatch, nu: fmpq) -> None:
    """y < -ε² λ_N: z < 0 by two routes, from below, and where the surface is pulled down alone."""
    beta = fmpq(1, 2)
    assert varsim1.surface_stays_below(beta, nu) is True
    assert varsim1.surface_by_an_integral(beta, nu) is True
    for wrong in ("-z + lam", "z + lam", "-z", "-2*z - lam"):
        with monkeypatch.context() as patch:
            patch.setattr(varsim1, "RATE_OF_Z", wrong)
            assert not (varsim1.surface_stays_below(beta, nu) and varsim1.surface_by_an_integral(beta, nu)), wrong
    monkeypatch.setattr(varsim1, "FORCE", "y - z")
    assert varsim1.surface_stays_below(beta, nu) is False
    assert varsim1.surface_by_an_integral(beta, nu) is False


@pytest.mark.parametrize(("z", "below"), [(fmpq(-1, 9), True), (fmpq(0), False), (fmpq(1, 9), False)])
def test_the_surface_starts_below(monkeypatch: pytest.MonkeyPatch, z: fmpq, below: bool) -> None:
    monkeypatch.setattr(varsim1, "initial_state", lambda *_: (None, SimpleNamespace(z=z)))
    assert varsim1.surface_stays_below(*IMPACT) is below
    assert varsim1.surface_by_an_integral(*IMPACT) is below


@pytest.mark.parametrize("name", ["surface_stays_below", "surface_by_an_integral"])
def test_an_impact_needs_that_y_goes_down(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setattr(varsim1, "proved_fate", lambda *_: "impact")
    monkeypatch.setattr(varsim1, "fate_at", lambda *_: "impact")
    assert "y → −∞" in varsim1.ENTRIES["3-varsim1a-4"]().statement
    assert varsim1.ENTRIES["3-varsim1a-4"]().verdict.outcome is Outcome.PROVED
    monkeypatch.setattr(varsim1, name, lambda *_: None)
    assert varsim1.ENTRIES["3-varsim1a-4"]().verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize(("margin", "proved"), [(fmpq(1, 9), True), (fmpq(0), False), (fmpq(-1), False), (None, False)])
def test_a_margin_must_be_positive(monkeypatch: pytest.MonkeyPatch, margin: fmpq | None, proved: bool) -> None:
    monkeypatch.setattr(varsim1, "margin_up_to", lambda *_: margin)
    assert varsim1.proved_fate(*IMPACT) == ("impact" if proved else None)
    assert varsim1.proved_fate(*LIFT_OFF) == ("lift-off" if proved else None)
    assert varsim1.proved_fate(*TRIVIAL) is None  # Theorem A' says nothing at ν = 1


@pytest.mark.parametrize(
    ("run", "found", "answer"),
    [
        (IMPACT, ["impact"], True),
        (IMPACT, ["impact", "lift-off"], False),
        (IMPACT, ["impact", None], None),
        (LIFT_OFF, ["impact"], False),
        (LIFT_OFF, ["lift-off before the G-spot"], False),
        (TRIVIAL, ["lift-off"], False),
        (TRIVIAL, [None], None),
    ],
)
def test_fates_beside_that_of_the_figure(run: Any, found: list[str | None], answer: bool | None) -> None:
    assert varsim1.are_drawn(*run, found) is answer


@pytest.mark.parametrize("part", ["b", "V", "Y", "Z"])
def test_a_deviation_in_one_part_is_not_trivial(monkeypatch: pytest.MonkeyPatch, part: str) -> None:
    hat = SimpleNamespace(b=0, V=0, Y=0, Z=0)
    monkeypatch.setattr(varsim1, "deviation", lambda *_: hat)
    monkeypatch.setattr(varsim1, "contact_lasts", lambda *_: SimpleNamespace(outcome=Outcome.PROVED))
    monkeypatch.setattr(varsim1, "side_rule", lambda *_: SimpleNamespace(side=0))
    assert varsim1.fate_at(*IMPACT, fmpq(1, 1000)) == "trivial"
    setattr(hat, part, fmpq(1, 10**9))
    assert varsim1.fate_at(*IMPACT, fmpq(1, 1000)) is None


@pytest.mark.parametrize(
    ("run", "side", "lasts", "lower", "fate"),
    [
        (IMPACT, 1, True, None, "impact"),
        (IMPACT, 1, False, fmpq(1, 9), None),
        (IMPACT, 0, True, fmpq(1, 9), None),
        (LIFT_OFF, -1, True, fmpq(1, 9), "lift-off"),
        (LIFT_OFF, -1, True, None, None),
        (LIFT_OFF, -1, True, fmpq(0), "lift-off before the G-spot"),
        (LIFT_OFF, -1, True, fmpq(-1), "lift-off before the G-spot"),
        (TRIVIAL, 0, True, None, "trivial"),
        (TRIVIAL, 0, False, None, None),
    ],
)
def test_the_fate_at_one_epsilon(
    monkeypatch: pytest.MonkeyPatch, run: Any, side: int, lasts: bool, lower: fmpq | None, fate: str | None
) -> None:
    outcome = Outcome.PROVED if lasts else Outcome.UNDECIDED
    monkeypatch.setattr(varsim1, "side_rule", lambda *_: SimpleNamespace(side=side))
    monkeypatch.setattr(varsim1, "contact_lasts", lambda *_: SimpleNamespace(outcome=outcome))
    monkeypatch.setattr(varsim1, "first_zero", lambda *_, **__: SimpleNamespace(lower=lower))
    assert varsim1.fate_at(*run, fmpq(1, 1000)) == fate


@pytest.mark.parametrize("run", [IMPACT, LIFT_OFF, TRIVIAL])
def test_what_is_seen_at_a_point_is_said_as_it_is(monkeypatch: pytest.MonkeyPatch, run: Any) -> None:
    """That λ_N > 0 up to a time, and the sign of K, are no impact: the theorem alone has all of the statement."""
    monkeypatch.setattr(varsim1, "fate_at", lambda beta, nu, _: varsim1.FATES[beta][nu])
    theorem, points = varsim1.ENTRIES[varsim1.identifier(*run)]().checks
    assert ("on all of the statement" in theorem.what) is (run != TRIVIAL)
    assert ("K > 0, which an impact needs" in points.what) is (run == IMPACT)
    assert ("up to t = 2 ε^(2/3)" in points.what) is (run != LIFT_OFF)
    assert "impact" not in points.finding
    assert points.finding.count(varsim1.FOUND[varsim1.FATES[run[0]][run[1]]]) == len(varsim1.POINTS)
    assert all(varsim1._some_time(point) ** 3 == 8 * point**2 for point in varsim1.POINTS)
