"""K of any state: by C and c+ for p > 0, by mpmath along another path for p <= 0, and constant along the motion."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
from flint import arb, fmpq
from samples.strategies import ends
from witnesses.contact import moved
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import CompliantState, Deviation, compliant_model, deviation
from gspot_verified.compliant.motion.growth_set import in_slow_set
from gspot_verified.compliant.side import side_later
from gspot_verified.compliant.side.side_later import side
from gspot_verified.compliant.side.side_rule import coefficients, side_rule
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.numbers.verdict import Outcome

BITS = 80
NONE = fmpq(0)
BEFORE = [
    Deviation(fmpq(3, 2), fmpq(1, 10), fmpq(1, 2), fmpq(1), fmpq(-2, 3), fmpq(1, 5), fmpq(2)),
    Deviation(fmpq(1, 2), fmpq(1), fmpq(2), fmpq(-1, 3), fmpq(2), fmpq(1), fmpq(-1)),
    Deviation(fmpq(13, 2), fmpq(1, 40), fmpq(1, 3), fmpq(1), fmpq(0), fmpq(-4), fmpq(-2)),
    Deviation(fmpq(3), fmpq(8), fmpq(1), fmpq(1), fmpq(1), fmpq(1), fmpq(2)),
]


def contact(hats: Deviation, alpha_2: fmpq = NONE) -> ContactState:
    """The state whose deviation from the trivial solution is ``hats``."""
    mean = alpha_2 / (1 - hats.beta)
    values = (hats.p, hats.b - hats.p * mean, hats.V, hats.Y - 2 * mean, hats.force + mean)
    with working_bits(200):
        return ContactState(hats.beta, hats.epsilon, alpha_2, *map(arb, values))


@pytest.mark.parametrize("hats", BEFORE, ids=lambda s: f"beta={s.beta}, eps={s.epsilon}")
@pytest.mark.parametrize("alpha_2", [fmpq(0), fmpq(-2)])
def test_k_before_the_g_spot_is_that_of_the_side_rule(hats: Deviation, alpha_2: fmpq) -> None:
    value, other = side(contact(hats, alpha_2), BITS), coefficients(hats, BITS)[2]
    assert relative_bits(value) > 40
    assert relative_bits(other) > 40
    assert value.overlaps(other)


def later_witness(hats: Deviation) -> mpmath.mpf:
    """K by mpmath from a point of the axis that is not the saddle, to infinity at 75 degrees."""
    beta, epsilon, p, b, V, Y, force = (
        mpmath.mpf(int(v.p)) / int(v.q) for v in (hats.beta, hats.epsilon, hats.p, hats.b, hats.V, hats.Y, hats.force)
    )

    def integrand(s: mpmath.mpc) -> mpmath.mpc:
        exponent = (mpmath.log(1 + s) - s + s**2 / 2 + s**3 / 3 + p * s) / epsilon
        return s ** (beta - 1) * mpmath.exp(exponent) * (b + s * V + s**2 * (Y - s * force) / (1 + s))

    size = mpmath.cbrt(epsilon) + mpmath.sqrt(abs(p))
    start = mpmath.cbrt(epsilon) + mpmath.sqrt(abs(p)) * 0.6
    direction = mpmath.expjpi(mpmath.mpf(5) / 12)
    points = [start + direction * size * i / 3 for i in range(46)]
    return -(beta / mpmath.pi) * mpmath.quad(integrand, points).imag


@pytest.mark.parametrize("p", [fmpq(0), fmpq(-1, 5), fmpq(-2)])
@pytest.mark.parametrize(("beta", "epsilon"), [(fmpq(1, 2), fmpq(1, 5)), (fmpq(5, 2), fmpq(1, 50)), (fmpq(4), fmpq(2))])
def test_k_after_the_g_spot_by_another_path(p: fmpq, beta: fmpq, epsilon: fmpq) -> None:
    hats = Deviation(beta, epsilon, p, fmpq(-1, 3), fmpq(-1), fmpq(1, 7), fmpq(2))
    value = side(contact(hats), BITS)
    assert relative_bits(value) > 40
    with mpmath.workdps(40):
        assert contains_witness(value, to_fraction(later_witness(hats)), 12)


@pytest.mark.parametrize("p", [fmpq(0), fmpq(-1, 5), fmpq(-2)])
@pytest.mark.parametrize(("beta", "epsilon"), [("1/2", "1/5"), ("5/2", "1/50"), ("4", "2")])
@pytest.mark.parametrize("depth", [-1, 3])
def test_the_side_rule_of_states_at_or_after_the_g_spot(p: fmpq, beta: str, epsilon: str, depth: int) -> None:
    """y < z < 0, either sign of K: the sign, and K itself, against mpmath on another path."""
    model = compliant_model(beta, epsilon)
    small = model.epsilon * model.epsilon
    state = CompliantState(p, fmpq(depth), -4 * small, model.epsilon * fmpq(depth, 7), -small)
    found = side_rule(model, state)
    with mpmath.workdps(40):
        witness = later_witness(deviation(model, state))
        assert contains_witness(found.side, to_fraction(witness), 12)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.verdict.statement.startswith("K > 0" if witness > 0 else "K < 0")
    assert (found.slow, found.fast, found.slow_side, found.paper_differs) == (None, None, None, None)
    assert found.to_json()["C"] is None


@pytest.mark.parametrize("share", [0.25, 0.3, 0.4])
@pytest.mark.parametrize("p", [fmpq(0), fmpq(-1, 5)])
def test_any_end_of_the_integral_is_right(monkeypatch: pytest.MonkeyPatch, share: float, p: fmpq) -> None:
    """An end that comes early leaves a rest that counts: its bound makes the ball wide, and holds K all the same."""
    hats = Deviation(fmpq(5, 2), fmpq(1, 50), p, fmpq(-1, 3), fmpq(-1), fmpq(1, 7), fmpq(2))
    best, late = side_later.side_of_deviation(hats, BITS), side_later._last
    monkeypatch.setattr(side_later, "_last", lambda *given: share * late(*given))
    value = side_later.side_of_deviation(hats, BITS)
    assert best.is_finite()
    assert value.is_finite()
    assert not best.overlaps(value.mid())
    assert value.contains(best.mid())


def test_the_trivial_solution_after_the_g_spot_is_the_canard() -> None:
    model = compliant_model("5/2", "1/100")
    small, force = model.epsilon * model.epsilon, model.mean_force
    found = side_rule(model, CompliantState(fmpq(-1, 3), force / 3, -2 * small * force, fmpq(0), -small * force))
    assert found.verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("epsilon", [10, 1000, 3 * 10**4, 10**6, 10**12, 10**100])
def test_k_is_constant_along_the_motion(epsilon: int) -> None:
    """One step of the motion in mpmath; the series and the closed form of the exponent both occur."""
    size = round(epsilon ** (2 / 3)) if epsilon < 10**50 else 10**67
    hats = Deviation(fmpq(5, 2), fmpq(1, epsilon), fmpq(-5, size), fmpq(-1, 3), fmpq(-1), fmpq(1, 7), fmpq(-1))
    with mpmath.workdps(40):
        start = [mpmath.mpf(int(v.p)) / int(v.q) for v in (hats.b, hats.V, hats.Y, hats.Z)]
        later, p = moved(start, -mpmath.mpf(5) / size, mpmath.mpf(5) / 2, 1 / mpmath.mpf(epsilon), mpmath.mpf(1), 10)
        exact = [fmpq(v.numerator, v.denominator) for v in map(to_fraction, later)]
    after = Deviation(hats.beta, hats.epsilon, hats.p - hats.epsilon, *exact)
    assert abs(float(p) - float(after.p.p) / float(after.p.q)) < 1e-15
    first, second = side(contact(hats), BITS), side(contact(after), BITS)
    assert relative_bits(first) > 30
    assert relative_bits(second) > 30
    assert (first - second).abs_upper() < abs(first) * arb("1e-9")


def test_k_is_not_negative_in_the_growth_sets() -> None:
    state = ContactState(
        fmpq(2),
        fmpq(1, 1000),
        fmpq(-1),
        arb(fmpq(-1, 4)),
        arb(fmpq(-31, 32)),
        arb(-1),
        arb(fmpq(-1, 4)),
        arb(fmpq(1, 8)),
    )
    assert in_slow_set(state, fmpq(1, 10), fmpq(1, 4))
    assert side(state, BITS) > 0


def test_a_wide_state_gives_a_wide_k_that_holds_the_narrow_one() -> None:
    narrow = contact(BEFORE[0])
    wide = ContactState(*(narrow.beta, narrow.epsilon, narrow.alpha_2), narrow.p, narrow.b, narrow.V + arb(0, "1e-3"),
                        narrow.Y, narrow.force)  # fmt: skip
    value = side(wide, BITS)
    assert value.is_finite()
    assert value.rad() > 1e-6
    assert value.contains(side(narrow, BITS).mid())
    assert not side(ContactState(narrow.beta, narrow.epsilon, narrow.alpha_2, narrow.p, arb("nan"), narrow.V, narrow.Y,
                                 narrow.force), BITS).is_finite()  # fmt: skip


def _upper(value: arb) -> mpmath.mpf:
    assert value.is_finite()
    top = ends(value)[1]
    return mpmath.mpf(top.numerator) / top.denominator


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2)])
@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(0), fmpq(-2)])
def test_the_rest_beyond_the_end_is_that_of_the_page(beta: fmpq, p: fmpq) -> None:
    """B (1 + 2R)^2 (2R)^max(beta-1, 0) R^min(beta-1, 0) e^(Re E(R)/epsilon)/(d(R)/epsilon - n/R)."""
    hats = Deviation(beta, fmpq(1, 3), p, fmpq(-1, 3), fmpq(-1), fmpq(1, 7), fmpq(2))
    height = fmpq(1, 2)
    with mpmath.workdps(30), working_bits(150):
        found = side_later._beyond(kernel(hats), arb(1), arb(2), arb(height))
        b, power, eps, m = (mpmath.mpf(int(v.p)) / int(v.q) for v in (hats.b, beta, hats.epsilon, p))
        V, Y, force = (mpmath.mpf(int(v.p)) / int(v.q) for v in (hats.V, hats.Y, hats.force))
        way, B, R = mpmath.expjpi(mpmath.mpf(1) / 3), abs(b) + abs(V) + abs(Y) + abs(force), mpmath.mpf(2)

        def exponent(s: mpmath.mpc) -> mpmath.mpf:
            return ((mpmath.log(1 + s) - s + s**2 / 2 + s**3 / 3 + m * s) / eps).real - mpmath.mpf(1) / 2

        d, n = R**2 + R - mpmath.mpf(1) / 2 - m / 2, 2 + max(power - 1, mpmath.mpf(0))
        front = B * (1 + 2 * R) ** 2 * (2 * R) ** max(power - 1, mpmath.mpf(0)) * R ** min(power - 1, mpmath.mpf(0))
        page = front * mpmath.exp(exponent(1 + way * R)) / (d / eps - n / R)
        assert page * (1 - mpmath.mpf("1e-15")) <= _upper(found) <= page * (1 + mpmath.mpf("1e-12"))

        def weight(rho: mpmath.mpf) -> mpmath.mpf:
            s = 1 + way * rho
            return abs(s) ** (power - 1) * abs(b + s * V + s**2 * (Y - s * force) / (1 + s)) * mpmath.exp(exponent(s))

        assert mpmath.quad(weight, [R, R + 1, R + 3]) < page


def test_the_rest_is_refused_without_its_hypotheses() -> None:
    hats = Deviation(fmpq(5, 2), fmpq(1, 3), fmpq(-2), fmpq(1), fmpq(1), fmpq(1), fmpq(2))

    def rest(start: fmpq, last: fmpq, hats: Deviation = hats) -> arb:
        return side_later._beyond(kernel(hats), arb(start), arb(last), arb(0))

    with working_bits(100):
        assert rest(fmpq(2), fmpq(2)).is_finite()
        assert not rest(fmpq(2), fmpq(199, 100)).is_finite()  # R < s_0
        assert not rest(fmpq(0), fmpq(2)).is_finite()
        assert not rest(fmpq(1), fmpq(2), replace(hats, p=fmpq(12))).is_finite()  # d(R) < 0
        assert not rest(fmpq(1), fmpq(2), replace(hats, epsilon=fmpq(100))).is_finite()  # the power still wins
