"""One statement for all alphas in balls against the statements of rational alphas in them.

Page: proofs/iwc.md, section 6.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.leading_order.iwc_over_balls import iwc_over_balls
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.verdict import Outcome, Reason

NARROW, WIDE = Fraction(1, 10**6), Fraction(1, 500)
ENDS = [(a, b, c) for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)]


def around(value: Fraction, radius: Fraction) -> arb:
    with working_bits(128):
        return arb(to_fmpq(value), arb(to_fmpq(radius)))


def inside(centres: tuple[Fraction, ...], parts: tuple[int | Fraction, ...], radius: Fraction) -> dict[str, fmpq]:
    names = ("alpha_1", "alpha_2", "alpha_3")
    return {name: to_fmpq(centre + part * radius) for name, centre, part in zip(names, centres, parts, strict=True)}


CASE_III = [(Fraction(-1), Fraction(-1), beta) for beta in map(Fraction, ("-3/2", "-7/3", "-7/2", "-26/5"))]
CASE_I = (Fraction(-2), Fraction(-1), Fraction(-1))


@pytest.mark.parametrize("centres", [*CASE_III, CASE_I])
@pytest.mark.parametrize("radius", [NARROW, WIDE])
def test_the_bound_serves_the_ends_and_the_middle(centres: tuple[Fraction, ...], radius: Fraction) -> None:
    every = iwc_over_balls(*(around(centre, radius) for centre in centres), tau_start=-3, digits=8)
    assert every.verdict.outcome is Outcome.PROVED
    assert every.epsilon_0 is not None
    assert every.largest_epsilon is not None
    worst = None
    for parts in ENDS:
        one = leading_order_iwc(**inside(centres, parts, radius), tau_start=-3, digits=12)
        assert one.largest_epsilon is not None
        assert one.minimum is not None
        assert every.minimum is not None
        assert every.minimum.value.contains(one.minimum.value)
        assert every.largest_epsilon.contains(one.largest_epsilon)
        assert one.largest_epsilon > every.epsilon_0
        worst = one.largest_epsilon if worst is None else worst.min(one.largest_epsilon)
        # At the common eps_0 itself each system alone is proved to be positive.
        alone = leading_order_iwc(**inside(centres, parts, radius), tau_start=-3, epsilon=every.epsilon_0, digits=12)
        assert alone.verdict.outcome is Outcome.PROVED
    assert worst is not None
    slack = Fraction(1, 1000) if radius == NARROW else Fraction(1, 3)
    assert arb(every.epsilon_0) > worst * (1 - to_fmpq(slack))


@settings(max_examples=25)
@given(
    st.sampled_from([*CASE_III, CASE_I]),
    st.tuples(*(st.fractions(-1, 1, max_denominator=99) for _ in range(3))),
    st.sampled_from([Fraction(1, 10**20), Fraction(1, 10**8), WIDE]),
)
def test_inclusion(centres: tuple[Fraction, ...], parts: tuple[Fraction, ...], radius: Fraction) -> None:
    every = iwc_over_balls(*(around(centre, radius) for centre in centres), digits=8)
    one = leading_order_iwc(**inside(centres, parts, radius * Fraction(999, 1000)), digits=30)
    assert one.largest_epsilon is not None
    if every.largest_epsilon is not None:
        assert every.largest_epsilon.is_finite()
        assert every.largest_epsilon.contains(one.largest_epsilon)
    if every.verdict.outcome is Outcome.PROVED:
        assert every.epsilon_0 is not None
        assert every.epsilon_0 < one.largest_epsilon
        assert not every.whole_line or one.whole_line


@pytest.mark.parametrize("centres", [*CASE_III, CASE_I])
@pytest.mark.parametrize("radius", [NARROW, Fraction(1, 10**18)])
def test_the_lift_off_times_are_in_the_bracket(centres: tuple[Fraction, ...], radius: Fraction) -> None:
    balls = [around(centre, radius) for centre in centres]
    impact = iwc_over_balls(*balls, tau_start=-1)
    assert impact.force is not None
    charge = -impact.force.direction
    found = iwc_over_balls(*balls, c1=charge, tau_start=-1, digits=12)
    for parts in ENDS[::3]:
        one = leading_order_iwc(**inside(centres, parts, radius), c1=charge, tau_start=-1, digits=25)
        assert one.verdict.outcome is found.verdict.outcome
        if one.verdict.outcome is Outcome.REFUTED:
            continue
        assert found.lift_off is not None
        assert one.lift_off is not None
        assert None not in (found.lift_off.lower, found.lift_off.upper, one.lift_off.lower, one.lift_off.upper)
        assert found.lift_off.lower <= one.lift_off.lower  # type: ignore[operator]
        assert one.lift_off.upper <= found.lift_off.upper  # type: ignore[operator]
        assert found.lift_off.number == one.lift_off.number
        assert ("zeros of λ_N" in found.verdict.detail) is (found.lift_off.number is not None)
        if one.lift_off.ratio is not None:
            assert found.lift_off.ratio is not None
            assert found.lift_off.ratio.is_finite()
            assert found.lift_off.ratio.contains(one.lift_off.ratio.mid())


def test_one_epsilon_below_between_and_above() -> None:
    balls = (-1, -1, around(Fraction(-5, 2), NARROW))
    size = iwc_over_balls(*balls).largest_epsilon
    assert size is not None
    below, between, above = (
        iwc_over_balls(*balls, epsilon=place)
        for place in (fmpq(1, 2), Fraction(*map(int, float(size.mid()).as_integer_ratio())), 2)
    )
    assert below.verdict.outcome is Outcome.PROVED
    assert (between.verdict.outcome, between.verdict.reason) == (Outcome.UNDECIDED, Reason.WIDE_INPUT)
    assert above.verdict.outcome is Outcome.REFUTED
    assert "for all α1, α2, α3 in the balls" in (above.verdict.witness or "")


def test_case_ii_holds_everywhere() -> None:
    found = iwc_over_balls(-3, around(Fraction(2), WIDE), around(Fraction(-1), WIDE))
    assert found.verdict.outcome is Outcome.PROVED
    assert (found.every_epsilon, found.whole_line) == (True, True)
    assert found.verdict.statement.endswith("λ_N > 0 for every real τ and every ε > 0")


def test_between_cases_i_and_ii_the_mean_force_is_0() -> None:
    found = iwc_over_balls(-3, 0, around(Fraction(-1), WIDE))
    assert found.verdict.outcome is Outcome.PROVED
    assert (found.every_epsilon, found.whole_line) == (True, True)


@pytest.mark.parametrize(("epsilon", "known"), [("999/1000", True), (1, False), (2, False)])
def test_the_ratio_of_a_lift_off_needs_an_epsilon_below_1(epsilon: str | int, known: bool) -> None:
    balls = (-1, -1, around(Fraction(-3, 2), NARROW))
    impact = iwc_over_balls(*balls).force
    assert impact is not None
    found = iwc_over_balls(*balls, c1=-impact.direction, tau_start=-1, epsilon=epsilon)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.lift_off is not None
    assert (found.lift_off.ratio is not None) is known


@pytest.mark.parametrize(
    ("alphas", "charge", "detail"),
    [
        ((-1, -1, around(Fraction(-2), NARROW)), None, "holds an integer"),
        ((around(Fraction(0), NARROW), -1, -1), None, "alpha_1"),
        ((-1, around(Fraction(0), NARROW), around(Fraction(-3, 2), NARROW)), None, "alpha_2"),
        ((-1, -1, around(Fraction(-11, 2), Fraction(49, 100))), None, "too wide"),
        # The sign of the mean force is open between Cases I and II.
        ((-1, around(Fraction(0), NARROW), around(Fraction(-1, 2), NARROW)), None, "no ε0"),
        # At the start the sign of the force is open.
        ((-2, around(Fraction(-1), Fraction(9, 10)), around(Fraction(-1), Fraction(1, 10))), 1, ""),
    ],
)
def test_undecided_with_the_reason(alphas: tuple[arb | int, ...], charge: int | None, detail: str) -> None:
    found = iwc_over_balls(*alphas, c1=charge)
    if charge is None:
        assert (found.verdict.outcome, found.verdict.reason) == (Outcome.UNDECIDED, Reason.WIDE_INPUT)
    assert detail in found.verdict.detail
    assert found.epsilon_0 is None
    assert not (found.whole_line and found.minimum is None)
    assert found.verdict.statement in str(found)
    assert found.to_json()["verdict"]["outcome"] == found.verdict.outcome.value


def test_texts_and_json() -> None:
    found = iwc_over_balls(-1, -1, around(Fraction(-5, 2), NARROW), digits=6)
    assert "Case III" in str(found)
    assert "the side C1/Γ(-β) > 0, λ_N → +∞" in str(found)
    assert "\n  κ^3 = -α1/2, τ = κ t ε^(-2/3), p = α1 t\n" in str(found)
    assert "least value of sign(C1) dΘ/dτ on [-10, inf): " in str(found)
    assert "it holds for every τ < -10 as well" in str(found)
    data = found.to_json()
    assert found.force is not None
    assert data["force"]["alpha_3"] == str(Dyadic.from_ball(found.force.alpha_3))
    assert data["growth"] == []
    assert data["epsilon_0"] == str(found.epsilon_0)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tau_start": 10**7}, "tau_start"),
        ({"epsilon": 0}, "epsilon"),
        ({"epsilon": -1}, "epsilon"),
        ({"digits": 0}, "digits"),
        ({"digits": 101}, "digits"),
        ({"c1": 0}, "C_1 = 0"),
    ],
)
def test_bad_input(options: dict[str, int], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        iwc_over_balls(-1, -1, around(Fraction(-5, 2), NARROW), **options)  # type: ignore[arg-type]


def test_one_epsilon_where_the_sign_of_the_mean_force_is_open() -> None:
    alphas = (-1, around(Fraction(0), NARROW), around(Fraction(-1, 2), NARROW))
    found = iwc_over_balls(*alphas, epsilon=10)
    assert (found.verdict.outcome, found.verdict.reason) == (Outcome.UNDECIDED, Reason.WIDE_INPUT)
    assert found.largest_epsilon is None


def test_a_wide_ball_far_to_the_left_is_no_proof() -> None:
    for start in (-50, -1000, -(10**6)):
        found = iwc_over_balls(-1, -1, around(Fraction(-7, 2), Fraction(1, 10)), tau_start=start)
        assert found.verdict.outcome in (Outcome.UNDECIDED, Outcome.PROVED)
        if found.epsilon_0 is not None:
            one = leading_order_iwc("18/5", tau_start=start)
            assert one.largest_epsilon is not None
            assert one.largest_epsilon > found.epsilon_0
        assert found.to_json()["start"] == str(start)


@pytest.mark.parametrize(("epsilon_0", "proved"), [(fmpq(17, 100), True), (fmpq(9, 50), False), (fmpq(1), False)])
def test_an_epsilon_0_that_is_not_certainly_below_the_threshold_is_undecided(
    monkeypatch: pytest.MonkeyPatch, epsilon_0: fmpq, proved: bool
) -> None:
    """The largest is 0.1788..."""
    monkeypatch.setattr("gspot_verified.leading_order.iwc.rounded_down", lambda *_: epsilon_0)
    verdict = iwc_over_balls(-1, -1, arb("-1.5", "1e-9"), digits=6).verdict
    assert verdict.outcome is (Outcome.PROVED if proved else Outcome.UNDECIDED)
    assert verdict.reason is (None if proved else Reason.WIDE_INPUT)


@pytest.mark.parametrize("backwards", [False, True])
def test_no_verdict_hangs_on_the_order_of_the_places(monkeypatch: pytest.MonkeyPatch, backwards: bool) -> None:
    monkeypatch.setattr(
        "gspot_verified.leading_order.iwc.sorted",
        lambda pieces, **_: list(pieces)[:: -1 if backwards else 1],
        raising=False,
    )
    verdict = iwc_over_balls(-1, -1, arb("-2.5", "1e-9"), epsilon=1, digits=6).verdict
    assert verdict.outcome is Outcome.REFUTED
    assert str(verdict.against).endswith("< 0")


@pytest.mark.parametrize(("tau_start", "everywhere"), [("153171613/100000000", False), ("8/5", True), (2, True)])
def test_every_epsilon_serves_only_where_the_deviation_is_certainly_not_negative(
    tau_start: str | int, everywhere: bool
) -> None:
    """dTheta/dtau has its last zero near 1.53171613: from there on the least value may be below 0 for some systems."""
    found = iwc_over_balls(-1, -1, arb("-2.5", "1e-6"), tau_start=tau_start, digits=6)
    assert found.minimum is not None
    assert found.verdict.outcome is Outcome.PROVED
    assert (found.minimum.value >= 0) is everywhere
    assert found.every_epsilon is everywhere
    assert found.verdict.statement.endswith("every ε > 0") is everywhere
    assert not (everywhere and found.whole_line)


def test_every_epsilon_serves_between_1_and_2_too() -> None:
    found = iwc_over_balls(-1, -1, arb("-1.5", "1e-6"), tau_start=3, digits=6)
    assert (found.verdict.outcome, found.every_epsilon, found.whole_line) == (Outcome.PROVED, True, False)


def test_without_a_lift_off_nothing_is_said_of_the_whole_line() -> None:
    found = iwc_over_balls(-1, -1, arb("-2.5", "1e-6"), c1=1, tau_start=6, epsilon="1/1000")
    assert found.lift_off is not None
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.lift_off.bracket is None
    assert (found.whole_line, found.lift_off.whole_line) == (False, False)


def test_balls_that_are_written_wider_are_said_to_be_so() -> None:
    """beta in [2.089, 2.209] is written [2e+0 +/- 0.210], which holds 1.9, where the other side takes an impact."""
    found = iwc_over_balls(-1, -1, around(Fraction(-2149, 1000), Fraction(60, 1000)))
    assert found.verdict.outcome is Outcome.PROVED
    assert "[2e+0 +/- 0.21" in str(found)
    assert " (balls rounded outward), C1 = -1: " in str(found)
    assert "λ_N changes sign" in leading_order_iwc("1.9", c1=-1).verdict.statement
