"""The coefficients of a state: constant along the motion, 1 and 0 on slow data, K by its own contour.

Page: proofs/first_integrals.md.
"""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
from flint import acb, arb, fmpq
from samples.strategies import ends
from witnesses.contact import moved
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.fast.fast_bound import fast_bound
from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient
from gspot_verified.compliant.model.normal_form import Deviation, compliant_model, compliant_state, deviation
from gspot_verified.compliant.side.side_rule import SideRule, coefficients, side_rule
from gspot_verified.compliant.slow.slow_coefficient import slow_coefficient
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma

BITS = 80
_VERDICT = Verdict.undecided("the sign of K", Reason.BUDGET, "left open here")
STATES = [
    Deviation(fmpq(3, 2), fmpq(1, 10), fmpq(1, 2), fmpq(1), fmpq(-2, 3), fmpq(1, 5), fmpq(2)),
    Deviation(fmpq(1, 2), fmpq(1), fmpq(2), fmpq(-1, 3), fmpq(2), fmpq(1), fmpq(-1)),
    Deviation(fmpq(13, 2), fmpq(1, 40), fmpq(1, 3), fmpq(1), fmpq(0), fmpq(-4), fmpq(-2)),
    Deviation(fmpq(3), fmpq(8), fmpq(1), fmpq(1), fmpq(1), fmpq(1), fmpq(2)),
]


def number(value: fmpq) -> mpmath.mpf:
    return mpmath.mpf(int(value.p)) / int(value.q)


def paper_state(beta: str, epsilon: str, nu: fmpq):
    model = compliant_model(beta, epsilon)
    p, small = fmpq(1, 2), model.epsilon
    b = -nu * p * abs(model.mean_force)
    return model, compliant_state(p, b, 2 * small**2 * b / p, 0, small**2 * b / p)


@pytest.mark.parametrize("state", STATES, ids=lambda s: f"beta={s.beta}, eps={s.epsilon}")
def test_coefficients_are_first_integrals(state: Deviation) -> None:
    duration = fmpq(1)
    with mpmath.workdps(60):
        hats = [number(value) for value in (state.b, state.V, state.Y, state.Z)]
        later, p = moved(hats, number(state.p), number(state.beta), number(state.epsilon), number(duration))
        exact = [_rational(value) for value in later]
        assert abs(p - number(state.p - state.epsilon * duration)) < 1e-30
    after = replace(state, p=state.p - state.epsilon * duration, b=exact[0], V=exact[1], Y=exact[2], Z=exact[3])
    slow, later_slow = slow_coefficient(state, BITS), slow_coefficient(after, BITS)
    assert _near(slow, later_slow)
    if after.p > 0:
        fast, later_fast = fast_coefficient(state, BITS), fast_coefficient(after, BITS)
        assert _near(fast.real, later_fast.real)
        assert _near(fast.imag, later_fast.imag)


def _rational(value: mpmath.mpf) -> fmpq:
    found = to_fraction(value)
    return fmpq(found.numerator, found.denominator)


def _near(first: arb, second: arb) -> bool:
    """Finite, narrow and equal up to the witness's 40 digits."""
    with working_bits(300):
        assert first.is_finite()
        assert second.is_finite()
        return bool(abs(first - second) < arb(10) ** -17 * (1 + abs(first)))


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(7, 3), fmpq(13, 2)])
@pytest.mark.parametrize("epsilon", [fmpq(4), fmpq(1, 10), fmpq(1, 2000)])
def test_slow_data_have_c_one_and_no_fast_part(beta: fmpq, epsilon: fmpq) -> None:
    p = fmpq(1, 2)
    time = -p / epsilon
    with working_bits(400):
        values = [slow_value(time, beta, epsilon, k, digits=100).value for k in range(4)]
        force, first, second = (values[k] / (epsilon * beta) for k in (1, 2, 3))
        velocity = -second - 2 * first - values[0] - arb(p) * force
        place = -first - 2 * force - velocity
        hats = [_exact(v / values[0]) for v in (values[0], velocity, place, place + force)]
        scale = values[0]
    state = Deviation(beta, epsilon, p, *hats)
    slow = slow_coefficient(state, BITS)
    with working_bits(400):
        assert _near(slow * scale, arb(1))
        fast = fast_coefficient(state, BITS)
        size = abs(fast_coefficient(replace(state, V=state.V + 1), BITS))
        assert abs(fast) < size * arb(10) ** -15


def _exact(value: arb) -> fmpq:
    lower, upper = ends(value)
    middle = (lower + upper) / 2
    return fmpq(middle.numerator, middle.denominator)


def side_by_its_contour(state: Deviation) -> mpmath.mpf:
    """K = -(beta/(2 pi i)) int s^(beta-1) e^((-psi(s) + p s)/eps) k(s) ds over the positive axis, by mpmath."""
    beta, epsilon, p, b, V, Y, force = (
        number(v) for v in (state.beta, state.epsilon, state.p, state.b, state.V, state.Y, state.force)
    )

    def integrand(s: mpmath.mpc) -> mpmath.mpc:
        psi = s - s**2 / 2 - s**3 / 3 - mpmath.log(1 + s)
        k = b + s * V + s**2 * (Y - s * force) / (1 + s)
        return s ** (beta - 1) * mpmath.exp((-psi + p * s) / epsilon) * k

    direction = mpmath.expjpi(mpmath.mpf(1) / 3)
    start = mpmath.cbrt(epsilon) / 2
    reach = 12 * mpmath.cbrt(epsilon) + 3
    points = [start + direction * reach * i / 12 for i in range(13)]
    return -(beta / mpmath.pi) * mpmath.quad(integrand, points).imag


@pytest.mark.parametrize("state", STATES, ids=lambda s: f"beta={s.beta}, eps={s.epsilon}")
def test_k_by_its_own_contour(state: Deviation) -> None:
    with mpmath.workdps(40):
        witness = to_fraction(side_by_its_contour(state))
    assert contains_witness(coefficients(state, 60)[2], witness, 14)


@pytest.mark.parametrize(
    ("beta", "nu", "epsilon", "sign", "differs"),
    [
        # Figure varsim1: the side of each run (nu = 1 is the trivial solution when beta > 1).
        *[("1/2", nu, "1/1000", 1, None) for nu in ("1/4", "1/2", "1", "2", "4")],
        *[("3/2", nu, "1/1000", 1, False) for nu in ("1/4", "1/2")],
        *[("3/2", nu, "1/1000", -1, False) for nu in ("2", "4")],
        *[("5/2", nu, "1/1000", -1, False) for nu in ("1/4", "1/2")],
        *[("5/2", nu, "1/1000", 1, False) for nu in ("2", "4")],
        # Here the fast part of the paper's own data wins.
        ("13/2", "2", "1/1000", -1, True),
        ("13/2", "2", "1/1000000", 1, False),
        ("15/2", "1/2", "1/1000", -1, True),
        ("15/2", "2", "1/1000", 1, True),
        ("15/2", "2", "1e-300", -1, False),
    ],
)
def test_sides_of_the_paper_s_runs(beta: str, nu: str, epsilon: str, sign: int, differs: bool | None) -> None:
    numerator, _, denominator = nu.partition("/")
    found = side_rule(*paper_state(beta, epsilon, fmpq(int(numerator), int(denominator or 1))))
    assert found.verdict.outcome is Outcome.PROVED
    assert (found.side > 0) is (sign > 0)
    assert found.paper_differs is differs


@pytest.mark.parametrize(
    ("beta", "alpha_2", "values"),
    [
        ("1/2", 1, ("1/2", "-1/2", "-2e-6", 0, "-1e-6")),  # Case II, C_1 > 0: does not occur in the paper
        ("1/2", -1, ("1/2", "1/2", "-2e-6", 0, "-1e-6")),
        ("5/2", 1, ("1/2", -1, "-2e-6", 0, "-1e-6")),  # no Case
        ("5/2", 0, ("1/2", -1, "-2e-6", 0, "-1e-6")),
        ("2", -1, ("1/2", -1, "-2e-6", 0, "-1e-6")),  # C/Gamma(-beta) = 0
    ],
)
def test_outside_case_iii_the_paper_has_no_rule(beta: str, alpha_2: int, values: tuple[str | int, ...]) -> None:
    found = side_rule(compliant_model(beta, alpha_2=alpha_2), compliant_state(*values))
    assert (found.verdict.outcome, found.paper_side, found.paper_differs) == (Outcome.PROVED, None, None)
    assert str(found).endswith("  the paper's rule, of Case III (β > 1, no integer, α2 < 0), does not apply")


def test_the_trivial_solution_is_the_canard() -> None:
    found = side_rule(*paper_state("5/2", "1/100", fmpq(1)))
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.verdict.reason is Reason.BEYOND  # K is exactly 0: no budget has ended
    assert found.paper_differs is None
    with pytest.raises(TypeError, match="verdict"):
        bool(found)


@pytest.mark.parametrize("beta", ["1/2", "5/2", "13/2"])
def test_one_bound_serves_all_smaller_epsilons(beta: str) -> None:
    model, state = paper_state(beta, "1/100", fmpq(2))
    hats = deviation(model, state)
    bound = fast_bound(hats, fmpq(1, 100))
    for epsilon in (fmpq(1, 100), fmpq(1, 150), fmpq(1, 1000), fmpq(1, 3000)):
        true = abs(fast_coefficient(replace(hats, epsilon=epsilon), 30))
        assert true.is_finite()
        assert true < bound.at(epsilon)
        assert bound.at(epsilon) < true * 10**5
    assert not bound.at(fmpq(1, 50)).is_finite()


def test_fast_coefficients_need_a_state_before_the_g_spot() -> None:
    assert not fast_coefficient(replace(STATES[0], p=fmpq(-1)), 30).is_finite()


def test_precision_does_not_change_the_answer() -> None:
    for state in STATES:
        coarse, fine = coefficients(state, 30), coefficients(state, 120)
        for one, other in zip(coarse, fine, strict=True):
            assert one.is_finite()
            assert acb(one).overlaps(acb(other))


@pytest.mark.parametrize("exponent", [-4000, -400, 400])
@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(0)])
def test_the_size_of_a_state_does_not_matter(exponent: int, p: fmpq) -> None:
    """The coefficients are linear in it, and their relative accuracy does not depend on it."""
    model = compliant_model("5/2", "1/100", alpha_2=0)
    values = (fmpq(-1), fmpq(-1, 7000), fmpq(1, 9), fmpq(-1, 9000))
    size = fmpq(10) ** exponent
    plain = side_rule(model, compliant_state(p, *values))
    scaled = side_rule(model, compliant_state(p, *(value * size for value in values)))
    assert scaled.verdict == plain.verdict
    assert plain.verdict.outcome is Outcome.PROVED
    with working_bits(200):
        assert scaled.side.is_finite()
        assert (scaled.side / size).overlaps(plain.side)
        assert scaled.side.rel_accuracy_bits() > 45
        assert (scaled.slow is None) is (p == 0)
        if scaled.slow is not None and plain.slow is not None:
            assert (scaled.slow / size).overlaps(plain.slow)


def test_the_text_says_whose_side_it_is() -> None:
    """The paper's rule with the same side, with the other one, and left open."""
    state = STATES[0]
    with working_bits(80):
        slow, sign = arb(1), reciprocal_gamma(-state.beta, 80)
        around = acb(0)
        same, other = (
            SideRule(state, slow, around, sign, _VERDICT, True),
            SideRule(state, slow, around, -sign, _VERDICT, True),
        )
        unsure = SideRule(state, slow, around, arb(0, 1), _VERDICT, True)
    assert "the paper's rule gives the same side" in str(same)
    assert "the paper's rule gives the other side" in str(other)
    assert "whether the paper's rule gives the same side is open" in str(unsure)
    assert [rule.paper_differs for rule in (same, other, unsure)] == [False, True, None]
