"""The certified side of a start, the float one, and the counts: wrong only where the certified one is decided.

Which side SciPy gives near the canard is no property of this package: it is recorded, never asserted.
"""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict
from gspot_verified.scenes import hard_sides, side
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.side import FAILED, LASTS, LOST, NO_EVENT, CertifiedSide, certified_side, float_side

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = DOCS / "where_floats_fail.md"


def start(beta: str, nu: str, eps: str) -> Scene:
    return load_scene("fig-varsim1", beta=beta, nu=nu, epsilon=eps)


@pytest.mark.parametrize(
    ("beta", "nu", "eps", "expected", "rule_fails"),
    [
        ("5/2", "1/2", "1e-4", LOST, False),
        ("5/2", "2", "1e-4", LASTS, False),
        ("15/2", "2", "1e-5", LOST, False),
        ("13/2", "2", "1e-3", LOST, True),
        ("15/2", "1/2", "1e-3", LOST, True),
    ],
)
def test_the_certified_side_and_whether_the_rule_of_the_paper_has_it(
    beta: str, nu: str, eps: str, expected: str, rule_fails: bool
) -> None:
    found = certified_side(start(beta, nu, eps))
    assert (found.side, found.rule_fails) == (expected, rule_fails)
    assert found.verdict.outcome is Outcome.PROVED


@pytest.mark.slow
@pytest.mark.parametrize(
    ("beta", "nu", "expected", "rule_fails"),
    [("13/2", "1/2", LASTS, True), ("15/2", "2", LOST, False), ("9/2", "2", LASTS, False)],
)
def test_where_the_fast_part_is_large_the_power_series_decides(
    beta: str, nu: str, expected: str, rule_fails: bool
) -> None:
    """β = 15/2, ν = 2: K > 0, and contact is lost all the same."""
    found = certified_side(start(beta, nu, "1e-3"))
    assert (found.side, found.rule_fails) == (expected, rule_fails)
    assert bool(found.rule.side > 0)


@pytest.mark.parametrize(("beta", "nu", "eps"), [("15/2", "2", "1e-4"), ("13/2", "1/2", "1e-5")])
def test_a_factor_2_from_the_canard_k_settles_the_side(beta: str, nu: str, eps: str) -> None:
    """Float runs may take the other side here; which do hangs on SciPy and on the processor, so they are not asked."""
    found = certified_side(start(beta, nu, eps))
    assert found.side == LOST
    assert bool(found.rule.side < 0)


@pytest.mark.slow
def test_the_answers_of_float_runs_are_counted_against_decided_starts() -> None:
    """One row of the set, with SciPy's own answers: what they are is not known beforehand, that each counts once is."""
    chosen = hard_sides.hard_sides().restricted(
        epsilons=["1/100000"], betas=["11/2"], solvers=["LSODA"], tolerances=["1e-10", "1e-12"]
    )
    found = hard_sides.wrong_sides(chosen)
    assert {start.nu: row.side for start, row in found.certified.items()} == {
        fmpq(1, 2): LASTS, fmpq(2): LOST, fmpq(1001, 1000): LOST,
    }  # fmt: skip
    assert [count.decided for count in found.counts] == [3, 3]
    for count in found.counts:
        said = [float_side(at.load(), count.solver, float(count.tolerance)) for at in found.certified]
        right = sum(word == row.side for word, row in zip(said, found.certified.values(), strict=True))
        assert count.wrong + count.silent + count.failed == 3 - right


BETAS = ("5/2", "7/2", "9/2", "11/2", "13/2", "15/2")
EPSILONS = {f"1/{10**n}": f"10{sign}" for n, sign in ((3, "⁻³"), (4, "⁻⁴"), (5, "⁻⁵"), (6, "⁻⁶"))}
TOLERANCES, SOLVERS = ("1e-6", "1e-10", "1e-12"), ("Radau", "LSODA", "BDF")
Recorded = list[dict[str, Any]]


@pytest.fixture(scope="module")
def recorded() -> dict[str, Any]:
    """What SciPy answered when the page was written: measured once, on one machine; not what it answers here."""
    found: dict[str, Any] = json.loads((DOCS / "where_floats_fail.json").read_text(encoding="utf-8"))
    return found


def cell(counts: Recorded) -> str:
    """The counts of one place of the page."""
    wrong, silent, failed = (sum(count[name] for count in counts) for name in ("wrong", "silent", "failed"))
    return " ".join([str(wrong), *[f"{number}{sign}" for number, sign in ((silent, "s"), (failed, "f")) if number]])


def total(counts: Recorded) -> str:
    """The counts of one place of the second table."""
    return cell(counts).replace(" ", ", ").replace("s", " silent").replace("f", " failed")


def chosen_from(counts: Recorded, **place: str) -> Recorded:
    return [count for count in counts if all(count[name] == value for name, value in place.items())]


def test_the_tables_of_the_page_are_the_recorded_measurement(recorded: dict[str, Any]) -> None:
    counts, page = recorded["counts"], PAGE.read_text(encoding="utf-8")
    assert len(counts) == len(EPSILONS) * len(BETAS) * len(SOLVERS) * len(TOLERANCES)
    assert f"scipy {recorded['versions']['scipy']}" in page
    assert all(count["wrong"] + count["silent"] + count["failed"] <= count["decided"] == 3 for count in counts)
    rows = [line for line in page.splitlines() if line.startswith("| 10") and any(name in line for name in SOLVERS)]
    assert rows == [
        f"| {printed} | {solver} {tolerance} | "
        + " | ".join(
            cell(chosen_from(counts, epsilon=epsilon, solver=solver, tolerance=tolerance, beta=beta)) for beta in BETAS
        )
        + " |"
        for epsilon, printed in EPSILONS.items()
        for tolerance in TOLERANCES
        for solver in SOLVERS
    ]
    for tolerance in TOLERANCES:
        totals = [total(chosen_from(counts, solver=solver, tolerance=tolerance)) for solver in SOLVERS]
        assert f"\n| {tolerance} | {' | '.join(totals)} |\n" in page


@pytest.mark.parametrize(("eps", "beta", "column"), [("1e-4", "11/2", 6), ("1e-5", "5/2", 3), ("1e-5", "15/2", 8)])
def test_the_page_prints_k_as_it_is(eps: str, beta: str, column: int) -> None:
    page = PAGE.read_text(encoding="utf-8")
    digits = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")
    rows = [row.translate(digits) for row in page.splitlines() if "**K**" in row]
    (shown,) = (row.split("|")[column].strip() for row in rows if row.startswith(f"| 10{eps[2:]} "))
    mantissa, exponent = shown.split("·10")
    found = certified_side(start(beta, "2", eps)).rule.side
    assert found.is_finite()
    assert abs(float(found.mid()) / float(f"{mantissa}e{exponent}") - 1) < 0.005


def test_a_scene_that_the_exact_solution_does_not_cover_is_refused() -> None:
    with pytest.raises(SceneError, match="the exact solution covers"):
        certified_side(load_scene("fig-varsim2"))


def test_without_the_sign_of_k_a_loss_rests_on_the_lift_off_of_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = start("5/2", "1/2", "1e-4")
    assert certified_side(scene).verdict.detail == "K < 0"
    monkeypatch.setattr(side, "less", lambda *_: None)
    found = certified_side(scene)
    assert (found.side, found.verdict.outcome) == (LOST, Outcome.PROVED)
    assert "cover" in str(found.verdict.evidence)
    runs = side.compliant_run
    for names in ((), ("touch-down",)):  # only a lift-off is a loss of contact

        def renamed(*given: Any, names: tuple[str, ...] = names) -> Any:
            run = runs(*given)
            events = [dataclasses.replace(run.events[0], name=name) for name in names]
            return dataclasses.replace(run, events=tuple(events))

        monkeypatch.setattr(side, "compliant_run", renamed)
        assert certified_side(scene).verdict.outcome is Outcome.UNDECIDED


def test_what_the_power_series_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """α₁ = −1/2, so that no unit is 1: the mean force is λ_N of the start less its deviation, and the time reaches to
    the p of the state that lasts, as dp/dT = −ε."""
    scene = load_scene("fig-varsim1", beta="3/2", nu="1/4", epsilon="1/100", alpha_1="-1/2")
    asked, lasting = [], []
    series, lasts = side.positive_by_series, side.lasting_contact
    monkeypatch.setattr(side, "positive_by_series", lambda *given: asked.append(given) or series(*given))
    monkeypatch.setattr(side, "lasting_contact", lambda *given: lasting.append(given[0]) or lasts(*given))
    assert certified_side(scene).side == LASTS
    ((start, mean, until),) = asked
    state = scene.initial()
    force = (state["z"] - state["y"]) / scene.epsilon**2
    assert mean == 4 * force - start.force  # the unit of time is 2
    assert (start.p, start.epsilon) == (state["p"], scene.epsilon / 2)
    rest = lasting[-1].p + until * start.epsilon - start.p
    assert rest.rad() < 1e-15
    assert rest.contains(0)


def refused(*_: object) -> None:
    raise AssertionError("this route was not to be asked")


def test_the_power_series_looks_on_until_a_state_lasts(monkeypatch: pytest.MonkeyPatch) -> None:
    """A first time at which nothing is shown, then one at which the contact lasts; no other route is needed."""
    scene = load_scene("fig-varsim1", beta="3/2", nu="1/4", epsilon="1/100", alpha_1="-1/2")
    lasts, asked = side.lasting_contact, []

    def second(*given: Any) -> Verdict:
        asked.append(given)
        return Verdict.undecided("?", Reason.BUDGET, "for the test") if len(asked) == 1 else lasts(*given)

    monkeypatch.setattr(side, "lasting_contact", second)
    monkeypatch.setattr(side, "compliant_run", refused)
    found = certified_side(scene)
    assert (found.side, found.verdict.outcome) == (LASTS, Outcome.PROVED)
    assert len(asked) >= 2


def test_a_zero_by_the_power_series_is_a_loss_and_none_is_left_to_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = load_scene("fig-varsim1", beta="3/2", nu="1/4", epsilon="1/100")
    shown = less(0, 1)
    monkeypatch.setattr(side, "later_times", lambda _: ())
    with monkeypatch.context() as patch:
        patch.setattr(side, "zero_by_series", lambda *_: SimpleNamespace(evidence=shown))
        patch.setattr(side, "compliant_run", refused)
        found = certified_side(scene)
        assert (found.side, found.verdict.outcome, found.verdict.evidence) == (LOST, Outcome.PROVED, shown)
    monkeypatch.setattr(side, "zero_by_series", lambda *_: None)
    open_run = SimpleNamespace(verdict=Verdict.undecided("?", Reason.BUDGET, "for the test"), events=())
    monkeypatch.setattr(side, "compliant_run", lambda *_: open_run)
    found = certified_side(scene)
    assert (found.side, found.verdict.outcome) == (None, Outcome.UNDECIDED)
    assert found.asymptotic is not None
    assert found.rule_fails is None  # it cannot be wrong where nothing is known


def test_what_a_float_run_says(monkeypatch: pytest.MonkeyPatch) -> None:
    """Far from the canard: |K| is 10^5 times the tolerance, so every solver that keeps it has the right side."""
    scene = start("5/2", "2", "1e-2")
    assert bool(abs(certified_side(scene).rule.side) > fmpq(1, 10**5))
    assert float_side(scene, "LSODA", 1e-10) == LASTS
    assert float_side(start("5/2", "1/2", "1e-2"), "LSODA", 1e-10) == LOST
    assert float_side(scene.with_settings(until="1/10"), "LSODA", 1e-10) == NO_EVENT

    def gives_up(*_: object) -> None:
        raise SceneError("the float run failed")

    monkeypatch.setattr(side, "float_run", gives_up)
    assert float_side(scene, "LSODA", 1e-6) == FAILED


def fake(answers: dict[fmpq, str | None], said: dict[fmpq, str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Certified and float answers by ν."""
    model = compliant_model("5/2", "1/100")
    rule = side_rule(model, compliant_state("1/2", "-2/3", "-8/30000", 0, "-4/30000"))

    def certified(scene: Scene) -> CertifiedSide:
        found = answers[scene.start["nu"]]
        open_verdict = Verdict.undecided("which side", Reason.BUDGET, "for the test")
        return CertifiedSide(found, rule, open_verdict if found is None else Verdict.proved(found, less(0, 1)))

    monkeypatch.setattr(hard_sides, "certified_side", certified)
    monkeypatch.setattr(hard_sides, "float_side", lambda scene, *_: said[scene.start["nu"]])


def test_only_decided_starts_count_and_silence_is_not_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    nus = [fmpq(n) for n in (2, 3, 4, 5, 6)]
    fake(
        dict(zip(nus, (LOST, LOST, LASTS, LOST, None), strict=True)),
        dict(zip(nus, (LASTS, LOST, NO_EVENT, FAILED, LASTS), strict=True)),
        monkeypatch,
    )
    chosen = hard_sides.hard_sides().restricted(
        epsilons=["1/100"], betas=["5/2"], nus=["2", "3", "4", "5", "6"], solvers=["BDF"], tolerances=["1e-6"]
    )
    told: list[str] = []
    found = hard_sides.wrong_sides(chosen, told.append)
    (count,) = found.counts
    assert (count.wrong, count.silent, count.failed, count.decided) == (1, 1, 1, 4)
    assert told == ["ε = 1/100, β = 5/2"]
    assert [row["side"] for row in found.to_json()["starts"]] == [LOST, LOST, LASTS, LOST, None]


def test_all_of_the_set_is_asked_where_nothing_is_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    shipped = hard_sides.hard_sides().restricted(epsilons=["1/100"], betas=["5/2"], nus=["2"])
    fake({fmpq(2): LOST}, {fmpq(2): LOST}, monkeypatch)
    monkeypatch.setattr(hard_sides, "hard_sides", lambda: shipped)
    found = hard_sides.wrong_sides()
    assert len(found.counts) == len(shipped.solvers) * len(shipped.tolerances) > 1
    assert {(count.wrong, count.decided) for count in found.counts} == {(0, 1)}


def test_the_tightest_and_the_loosest_tolerance() -> None:
    assert hard_sides.hard_sides().restricted(tolerances=["1e-13", "1e-2"]).tolerances == ("1e-13", "1e-2")
    for beyond in ("9e-14", "1.001e-2", "nan", "inf", "-1e-6"):
        with pytest.raises(SceneError, match=r"tolerance: expected 1e-13\.\.1e-2, got"):
            hard_sides.hard_sides().restricted(tolerances=[beyond])


def test_the_shipped_set() -> None:
    found = hard_sides.hard_sides()
    assert len(list(found.starts())) == 72
    assert found.solvers == ("Radau", "LSODA", "BDF")
    assert (min(found.betas), max(found.betas)) == (fmpq(5, 2), fmpq(15, 2))
    assert (min(found.epsilons), max(found.epsilons)) == (fmpq(1, 10**6), fmpq(1, 1000))
    assert {fmpq(1, 2), fmpq(2)} < set(found.nus)
    assert found.restricted(betas=None, nus=[]) == found


@pytest.mark.parametrize(
    ("lists", "message"),
    [
        ({"solvers": ["RK45"]}, "method: expected one of Radau, LSODA, BDF"),
        ({"tolerances": ["1e-15"]}, "tolerance: expected 1e-13..1e-2"),
        ({"tolerances": ["tight"]}, "tolerance: expected a number"),
        ({"betas": ["two"]}, "betas"),
    ],
)
def test_a_wrong_choice_is_refused(lists: dict[str, list[str]], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        hard_sides.hard_sides().restricted(**lists)
