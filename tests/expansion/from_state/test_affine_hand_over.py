"""The hand-over of proofs/from_state.md, section 8, (17): states of the tube, made from its letters alone, lie in the
set; what its reference and Theorem 1 differ by is as large as what the fast part leaves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import product
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq, fmpq_poly
from mpmath import mpf

from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.from_state.affine_hand_over import _beside, _in_delta, _over, affine_hand_over
from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, ExcessBounds, carried
from gspot_verified.expansion.from_state.barrier import Start
from gspot_verified.expansion.from_state.fast_growth import Rectangle
from gspot_verified.expansion.from_state.hand_over import HandOver
from gspot_verified.expansion.from_state.slow_manifold import Cut, H, L, R, SlowManifold, excess_terms, slow_manifold
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.evidence import less
from tests.expansion.from_state.test_affine_system import BENT, STEEPER
from tests.expansion.from_state.test_barrier_numbers import in_mpmath, number

FAR, DELTA = fmpq(5), fmpq(1, 100)
P, H_1 = fmpq(1, 25), fmpq(1, 2)
with mpmath.workdps(50):
    KAPPA, LAG = mpf(6) / 5, mpf(9) / 50  # kappa, l/g
SHARES = (arb("1.25"), arb("1.5"), arb("0.75"))
CONE = Cone(fmpq(0), P, fmpq(0), fmpq(4), fmpq(4), fmpq(4))
STEEP = BENT  # beta = 5/4


@pytest.fixture(autouse=True)
def _digits() -> Iterator[None]:
    with mpmath.workdps(50), working_bits(192):
        yield


@cache
def equations(system: AffineSystem, delta: fmpq = DELTA) -> DeviationEquations:
    with working_bits(192):
        return DeviationEquations(expand_system(system.system(), 8), delta)


@cache
def manifold_of(system: AffineSystem, weight: int = 4) -> SlowManifold:
    return slow_manifold(system, Cut(3, fmpq(weight), 2 * system.beta - 2))


def start(system: AffineSystem, excess: fmpq, p: fmpq = P, weight: int = 4) -> AffineStart:
    manifold = manifold_of(system, weight)
    return AffineStart(manifold, p, p * (AffineStart(manifold, p, fmpq(0), fmpq(0)).excess - excess), fmpq(1, 100))


def tube(system: AffineSystem, z: str, h: fmpq = H_1, e: fmpq | None = None, drift: str = "0.01") -> AffineTube:
    """Z = z r h^2, without a layer."""
    shown = less(0, 1)
    assert shown is not None
    begun = Start(P, system.a * DELTA**3 if e is None else e, arb(0), 1, fmpq(1, 2))
    one = Rectangle(h, fmpq(1, 4))
    bounds = ExcessBounds.around(2 * system.beta - 2, arb(30), arb("0.001"))
    return AffineTube(begun, one, {(2, 1): arb(z)}, arb(1), arb("0.1"), SHARES, arb(drift), bounds, CONE, shown)


def handed(system: AffineSystem, excess: fmpq, z: str) -> HandOver:
    found = affine_hand_over(equations(system), start(system, excess), tube(system, z), FAR)
    assert isinstance(found, HandOver), found
    return found


def scaled(system: AffineSystem, name: str, delta: mpf) -> mpf:
    """A polynomial of Theorem 1 at s = -S."""
    terms = equations(system).trajectory.terms()[name]
    values = [sum((number(c) * (-number(FAR)) ** k for k, c in enumerate(t.coefficients())), mpf(0)) for t in terms]
    return sum((value * delta**n for n, value in enumerate(values)), mpf(0))


def state_of(system: AffineSystem, c: mpf, z: mpf, delta: mpf, signs: tuple[int, int, int]) -> tuple[list[mpf], mpf]:
    """The deviations and phi, over delta^mu, of the state whose fast deviation is as large as z allows."""
    manifold, beta, a = manifold_of(system), number(system.beta), number(system.a)
    p = delta**2 * scaled(system, "p", delta)
    r, e = mpmath.sqrt(p), a * delta**3
    h = e / r**3
    off = -c * p ** (beta - 1)
    x = [sign * in_mpmath(share) * z * p * abs(off) for sign, share in zip(signs, SHARES, strict=True)]
    reference, u, w, f = (
        sum((number(q) * h**i * r**n * off**k for (i, n, k), q in excess_terms(one).items()), mpf(0))
        for one in (manifold.force, manifold.u, manifold.w, manifold.f)
    )
    rigid = reference + off
    speed = h * r * u + x[0] / r
    force = rigid + w + x[1] / p
    phi = r**2 * f + x[2] / r
    height = (phi - force - LAG * speed) / KAPPA
    values = {
        "xi_1": p / delta**2, "xi_2": -p * rigid / delta**2, "xi_3": height * delta**4, "xi_4": speed * delta,
        "p": p / delta**2, "b": -p * rigid / delta**2, "y": height, "v": speed / delta,
    }  # fmt: skip
    power = delta ** (2 * beta - 2)
    known = {name: scaled(system, name, delta) for name in (*values, "lambda_n")}
    fast = phi - known["lambda_n"] - KAPPA * known["y"] - LAG * delta * known["v"]
    return [(value - known[name]) / power for name, value in values.items()], fast / power


# L so small that both parts count, and larger
@pytest.mark.parametrize("excess", [fmpq(1, 3), fmpq(-1, 4), fmpq(1, 10**4), fmpq(-1, 10**5)])
@pytest.mark.parametrize("system", [STEEP, STEEPER], ids=["beta 5/4", "beta 7/3"])
def test_every_state_of_the_tube_lies_in_the_set(system: AffineSystem, excess: fmpq) -> None:
    found = handed(system, excess, "0.5")
    z = in_mpmath(found.z)
    column = [in_mpmath(found.frame[i, 5]) for i in range(8)]
    radii, reached, fast = [in_mpmath(one) for one in found.radii], [mpf(0)] * 8, mpf(0)
    deltas = [number(DELTA) * share for share in (mpf(1), mpf("0.5"), mpf(10) ** -6)]
    ends = in_mpmath(found.coefficient.lower()), in_mpmath(found.coefficient.upper())
    for c, delta, *signs in product(ends, deltas, *[(1, -1)] * 3):
        e, phi = state_of(system, c, z, delta, (signs[0], signs[1], signs[2]))
        share = e[5] / column[5]
        u = [one - share * column[i] if i != 5 else share - 1 for i, one in enumerate(e)]
        reached = [max(old, abs(one)) for old, one in zip(reached, u, strict=True)]
        fast = max(fast, abs(phi))
    assert all(one <= radius + mpf(10) ** -40 for one, radius in zip(reached, radii, strict=True))
    # what is beside it in y lies along the slow vector nearly, and its bound does not know that
    for i, (one, radius) in enumerate(zip(reached, radii, strict=True)):
        assert radius <= (400 if i == 6 else 35) * one + mpf(10) ** -40
    assert max(reached[i] / radii[i] for i in (2, 3)) > mpf("0.5")
    assert reached[5] > mpf("0.95") * radii[5]
    assert fast <= in_mpmath(found.fast) <= 2 * fast


def test_the_bound_and_the_coefficient_at_the_hand_over() -> None:
    """h = a p^(-3/2) and r = sqrt(p) delta there; C is that of the start, carried."""
    system, given, one = STEEP, start(STEEP, fmpq(1, 3)), tube(STEEP, "0.5")
    found = handed(system, fmpq(1, 3), "0.5")
    p = scaled(system, "p", number(DELTA))
    assert abs(in_mpmath(found.z) - mpf("0.125") * mpmath.sqrt(p) * number(DELTA)) < mpf(10) ** -3
    for delta in (number(DELTA), number(DELTA) / 10**4):
        p = scaled(system, "p", delta)
        h, r = number(system.a) / p ** mpf("1.5"), mpmath.sqrt(p) * delta
        h_ball, r_ball = (arb(fmpq(int(x * 2**150), 2**150)) for x in (h, r))
        log, first = carried(given, one, h_ball, r_ball), given.coefficient(one.start.e)
        for end in (log.lower(), log.upper()):
            assert ((first * end.exp()).upper() - found.coefficient.lower()) > arb("-1e-9")
            assert found.coefficient.upper() - (first * end.exp()).lower() > arb("-1e-9")
    wide = hull([log.lower(), log.upper()]).exp() * first
    assert found.coefficient.rad() < 4 * wide.rad()


def tried(**changes: Any) -> HandOver | str:
    given = start(STEEP, fmpq(1, 3), changes.pop("p", P))
    return affine_hand_over(equations(STEEP), given, tube(STEEP, "0.5", **changes), FAR)


def test_the_tube_must_reach_the_hand_over_and_this_epsilon() -> None:
    """p^3 h_1^2 >= a^2, for all delta; e = a delta^3 is enough."""
    values = [scaled(STEEP, "p", number(DELTA) * k / 4) for k in range(5)]
    edge = number(STEEP.a) / min(values) ** mpf("1.5")
    for factor, refused in ((mpf("0.999"), True), (mpf("1.02"), False)):
        h = fmpq(int(edge * factor * 2**60), 2**60)
        assert (tried(h=h) == "the tube ends before the hand-over") is refused
    with pytest.raises(ValueError, match="larger epsilon only"):
        tried(e=STEEP.a * DELTA**3 * (1 - fmpq(1, 10**12)))


def test_the_hand_over_must_lie_after_the_start() -> None:
    """delta^2 p < p_1."""
    edge = number(DELTA) ** 2 * scaled(STEEP, "p", number(DELTA))
    for factor, refused in ((mpf("0.99"), True), (mpf("1.03"), False)):
        p = fmpq(int(edge * factor * 2**60), 2**60)
        assert (tried(p=p) == "the start lies after the hand-over") is refused


@pytest.mark.parametrize("name", ["alpha_1", "alpha_2", "alpha_3"])
def test_another_system_is_noticed(name: str) -> None:
    """Its reference is another one at order 2, below mu = 8/3."""
    off = replace(getattr(STEEPER, name), by_p=fmpq(1, 7))
    system = replace(STEEPER, **{name: off})
    found = affine_hand_over(equations(STEEPER), start(system, fmpq(1, 3)), tube(system, "0.5"), FAR)
    assert found == "the reference differs from Theorem 1 at an order below mu, or is no polynomial in p and epsilon"


@pytest.mark.parametrize("system", [STEEP, STEEPER], ids=["beta 5/4", "beta 7/3"])
def test_what_the_reference_and_theorem_1_differ_by(system: AffineSystem) -> None:
    """(17): sums of |coefficients| delta_0^(n - mu), over the powers of p that the reference divides by."""
    manifold = manifold_of(system)
    found = _beside(equations(system), manifold, FAR)
    assert found is not None
    known = {
        name: fmpq_poly([fmpq_poly(list(t.coefficients()))(-FAR) for t in terms])
        for name, terms in equations(system).trajectory.terms().items()
    }
    delta, kappa, lag = fmpq_poly([0, 1]), fmpq(6, 5), fmpq(9, 50)
    p, e = delta**2 * known["p"], system.a * delta**3
    lowest = 2  # powers of 1/p are taken out of all, more than there are

    def of(polynomial: Any, shift: int) -> fmpq_poly:
        """p^lowest times the reference, h^i r^n = e^i p^((n - 3 i)/2)."""
        terms = excess_terms(polynomial).items()
        return sum(
            (c * e**i * p ** ((n - 3 * i) // 2 + lowest + shift) for (i, n, k), c in terms if k == 0), fmpq_poly([0])
        )

    force, fast = of(manifold.force, 0) + of(manifold.w, 0), of(manifold.f, 1)
    speed = sum(
        (c * e ** (i + 1) * p ** ((n - 3 * i) // 2 - 1 + lowest)
         for (i, n, k), c in excess_terms(manifold.u).items() if k == 0), fmpq_poly([0]),
    )  # fmt: skip
    own = p**lowest
    wanted = [
        (known["b"] * delta**2 * own + of(manifold.force, 1), 2 * lowest + 2),
        (kappa * known["y"] * own + force + lag * speed - fast, 2 * lowest),
        (known["v"] * delta * own - speed, 2 * lowest + 1),
        ((known["lambda_n"] + kappa * known["y"] + lag * delta * known["v"]) * own - fast, 2 * lowest),
        (known["xi_1"] - known["p"], 0), (known["xi_2"] - known["b"], 0),
        (known["xi_3"] - delta**4 * known["y"], 0), (known["xi_4"] - delta**2 * known["v"], 0),
    ]  # fmt: skip
    power, place = 2 * number(system.beta) - 2, number(known["p"](DELTA))
    for one, (polynomial, least) in zip(
        (found.b, kappa * found.y, found.v, found.fast, *found.state), wanted, strict=True
    ):
        terms = [(n, c) for n, c in enumerate(polynomial.coeffs()) if c]
        assert all(n - least >= power for n, _ in terms)
        value = abs(number(polynomial(DELTA))) / place ** (lowest if least else 0) / number(DELTA) ** (least + power)
        assert value <= in_mpmath(abs(one).upper())
        assert in_mpmath(abs(one).upper()) <= 300 * value + mpf(10) ** -40
    assert found.b.rad() > 0
    assert found.y.rad() > 0
    assert found.state[2].rad() > 0  # its polynomial has another order


@pytest.mark.parametrize("system", [STEEP, STEEPER], ids=["beta 5/4", "beta 7/3"])
def test_a_reference_of_higher_weight_is_nearer_to_theorem_1(system: AffineSystem) -> None:
    """Up to the order of Theorem 1's polynomials."""
    sizes = list[mpf]()
    for weight in (1, 3, 5):
        found = _beside(equations(system), manifold_of(system, weight), FAR)
        assert found is not None
        sizes.append(in_mpmath(found.b.rad()))
    assert sizes[1] < sizes[0] / 50
    assert sizes[2] < sizes[1] / 20


def test_what_is_beside_is_bounded_from_mu_on() -> None:
    one, tenth = equations(STEEP), number(DELTA)
    level = _over(one, fmpq_poly([0, 0, 0, 2]), fmpq(3))
    assert level is not None
    assert arb(2) <= level.rad() < arb("2.0000001")
    assert _over(one, fmpq_poly([0, 0, 0, 2]), fmpq(3) + fmpq(1, 10**9)) is None
    assert _over(one, fmpq_poly([0, 0, 1, 2]), fmpq(3)) is None
    value = _over(one, fmpq_poly([0, 0, 0, -2, 0, 5]), fmpq(5, 2))
    assert value is not None
    wanted = 2 * mpmath.sqrt(tenth) + 5 * tenth ** mpf("2.5")
    assert wanted <= in_mpmath(value.rad()) < wanted * (1 + mpf(10) ** -8)
    assert value.mid() == 0
    with working_bits(24):
        rough = _over(one, fmpq_poly([0, 0, 0, -2, 0, 5]), fmpq(5, 2))
        assert rough is not None
        assert in_mpmath(rough.rad()) >= wanted


def test_only_a_polynomial_in_p_and_e_is_one_in_delta() -> None:
    """h^3 r^11 = e^3 p; h r^2 and h r are not."""
    p, a = fmpq_poly([0, 0, 3, 1]), fmpq(5, 2)
    found = _in_delta(2 * H**3 * R**11 + 7 * R**4 * (1 + L), p, a)
    assert found == 2 * (a * fmpq_poly([0, 0, 0, 1])) ** 3 * p + 7 * p**2
    for other in (H * R, H * R**2, H**2 * R**4, R):
        assert _in_delta(R**2 + other, p, a) is None


@pytest.mark.parametrize("part", ["force", "w", "u", "f"])
def test_another_reference_is_noticed(part: str) -> None:
    """One that is no polynomial in p and e, and one that is another at an order below mu."""
    manifold = manifold_of(STEEPER)
    for other in (H, R**0, *[H**2 * R**4] * (part in ("force", "w"))):  # e^2/p
        assert _beside(equations(STEEPER), replace(manifold, **{part: getattr(manifold, part) + other}), FAR) is None
