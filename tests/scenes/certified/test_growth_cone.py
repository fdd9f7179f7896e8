"""The cones of growing force: the formulas of their proofs, each inequality alone, runs that stay in them.

Page: proofs/invariant_region.md.
"""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.growth_cone import ContactPoint, FastCone, SlowCone, cones
from gspot_verified.scenes.certified.invariant_region import InvariantRegion
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.contact_form import ContactBounds, ContactForm
from gspot_verified.scenes.scene.file import load_scene

MODEL = ContactForm(load_scene("fig-varsim1").system("slip"))
STIFF_SCENE = load_scene("fig-varsim1", k_1=2, k_2="1/3", damping=5)
STIFF = ContactForm(STIFF_SCENE.system("slip"))


def rational(chance: random.Random) -> fmpq:
    return fmpq(chance.randint(-50, 50), chance.randint(1, 20))


def test_the_derivatives_of_the_proof() -> None:
    """Theorem R4: f', g', j', m', n' along (2), at random rational states, q, H and constants."""
    chance = random.Random(4)
    for _ in range(50):
        k, kappa, gamma, a, c, q, H = (rational(chance) for _ in range(7))
        force, D, W, G = (rational(chance) for _ in range(4))
        s = kappa + gamma * k
        S, M = kappa * W + G, D + s * force
        # (2)
        force_, D_, W_, G_ = D, -s * D + k * S, G, q * D - H
        S_, M_ = kappa * W_ + G_, D_ + s * force_
        f, g, j, m = D - a * force, k * S - a * M, kappa * G - a * S, D - c * S
        assert k * S == M_
        assert D_ - a * force_ == g - s * f
        assert k * S_ - a * M_ == k * (j + G_)
        assert j + a * S + G_ == S_
        assert kappa * G_ - a * S_ == (kappa - a) * G_ - a * j - a * a * S
        right = -(s + c * q) * m + (k - c * (kappa + s) - c * c * q) * S + c * kappa * kappa * W + c * H
        assert D_ - c * S_ == right


@pytest.mark.parametrize("name", ["force", "D", "S", "G"])
def test_a_cone_holds_all_states_of_a_ball(name: str) -> None:
    """Theorem R4's four inequalities, for certain, at a point of which one component is a wide ball."""
    point = ContactPoint(force=arb(1), W=arb(1), G=arb(fmpq(1, 8)), D=arb(2), S=arb(2))
    bounds, given = of("-0.1"), 0
    for radius in (fmpq(0), fmpq(1, 100), fmpq(1, 20), fmpq(1, 10)):
        at = replace(point, **{name: arb(getattr(point, name).mid(), arb(radius))})
        for cone in cones(MODEL, at, bounds):
            assert cone.rate * at.force <= at.D
            if isinstance(cone, FastCone):
                assert MODEL.k * at.S >= cone.rate * (MODEL.s + cone.rate) * at.force
                continue
            assert isinstance(cone, SlowCone)
            assert MODEL.k * at.S >= cone.rate * (at.D + MODEL.s * at.force)
            assert MODEL.kappa * at.G >= cone.rate * at.S
            assert cone.c * at.S <= at.D
            given += 1
    assert given


def of(slope: str, constant: str = "0", factor: str = "0") -> ContactBounds:
    return ContactBounds(arb(0), arb(slope), arb(constant), arb(factor), (), (), (), (), ())


@pytest.mark.parametrize(
    ("bounds", "kept"),
    [
        (of("-0.1"), True),
        (of("-0.1", factor="0.002"), True),
        (of("0.1"), False),  # p > 0
        (of("[-0.1 +/- 0.2]"), False),  # p changes its sign
        (of("-0.001"), False),  # q too small for a
        (of("-0.1", factor="0.1"), False),  # H grows with the force: b falls short of it
        (of("-0.1", constant="0.1"), False),  # H = 0.1 and the force is 1
        (of("-0.1", constant="-100"), False),  # the force falls behind S
        (of("-0.1", factor="-100"), False),
        (of("-100"), False),
        (of("nan"), False),
        (of("-0.1", factor="nan"), False),
        (of("-0.1", constant="inf"), False),
    ],
)
def test_each_inequality_of_the_slow_cone(bounds: ContactBounds, kept: bool) -> None:
    cone = SlowCone(MODEL, arb("0.08"), arb("0.2"), arb(1), arb(1))
    assert cone.is_kept(bounds) is kept


@pytest.mark.parametrize("a", ["0", "-0.1", "1", "2", "nan"])
def test_a_rate_out_of_range(a: str) -> None:
    """0 < a < kappa."""
    assert not SlowCone(MODEL, arb(a), arb("0.2"), arb(1), arb(1)).is_kept(of("-50"))


def test_growth_for_ever_needs_the_way_to_large_q() -> None:
    """c = 0.332 serves q = 0.01, not q = 0.084 yet, where the cone of Theorem R1 takes over."""
    bounds = of("-0.01", factor="0.0001")
    good, late = (SlowCone(MODEL, arb("0.04"), arb(c), arb(1), arb(1)) for c in ("0.3", "0.332"))
    assert good.is_kept(bounds)
    assert good.is_kept_for_ever(bounds)
    assert late.is_kept(bounds)
    assert not late.is_kept_for_ever(bounds)


def states(chance: random.Random) -> dict[str, arb]:
    """Random states around the cones, p from -0.01 to -0.3."""
    q, force = 10 ** chance.uniform(-2, -0.5), 10 ** chance.uniform(-1, 2)
    a = q**0.5 * chance.uniform(0.1, 0.8)
    D = a * force
    S = (2 + a) * D * chance.uniform(0.7, 1.3)
    G = a * S * chance.uniform(0.7, 2)
    V = G - S
    Y = -D - 2 * force - V
    values = {"b": -G + q * force, "Y": Y, "V": V, "Z": Y + force, "T": (0.5 + q) * 1000}
    return {name: arb(value) for name, value in values.items()}


@pytest.mark.parametrize("beta", ["3/2", "7/2"])
def test_the_exact_solution_agrees(beta: str) -> None:
    """Growth for ever asks for K >= 0 (proofs/flight.md, section 6): a second route, which knows no cones."""
    scene = load_scene("fig-varsim1", beta=beta, epsilon="1e-3")
    system = scene.system("slip")
    chance = random.Random(7)
    seen = 0
    slow = 0
    with working_bits(128):
        region = InvariantRegion(system)
    model = compliant_model(beta, "1e-3")
    for _ in range(60):
        with working_bits(128):
            state = states(chance)
            found = region.growth(state)
            if found is None:
                continue
            at = {name: fmpq(*map(int, fraction(state[name]))) for name in state}
            form = ContactForm(system)
            box = [state[name] for name in (*form.names, "T")] + [state["Z"] - state["Y"]]
            bounds = form.bounds(box)
            kept = [c for c in cones(form, ContactPoint.of(form, box), bounds) if c.is_kept_for_ever(bounds)]
            slow += all(isinstance(cone, SlowCone) for cone in kept)
        eps = scene.epsilon
        p = fmpq(1, 2) - eps * at["T"]
        exact = compliant_state(p, at["b"], at["Y"] * eps**2, at["V"] * eps, at["Z"] * eps**2)
        side = side_rule(model, exact).side
        assert side.is_finite()
        assert not side < 0
        seen += 1
    assert seen > 10
    assert slow > 3


def fraction(value: arb) -> tuple[int, int]:
    mantissa, exponent = value.mid().man_exp()
    number = fmpq(int(mantissa)) * fmpq(2) ** int(exponent)
    return int(number.p), int(number.q)


def contact_state(form: ContactForm, chance: random.Random) -> list[arb]:
    """The states, the clock and λ of a point around the cones, for any stiffness."""
    k, kappa, s = form.k, form.kappa, form.s
    q, force = (arb(10 ** chance.uniform(*ends)) for ends in ((-2, -0.5), (-1, 2)))
    a = (k * q).sqrt() * arb(chance.uniform(0.1, 0.5))
    D = a * force
    S = (s + a) * D / k * arb(chance.uniform(0.8, 1.6))
    G = a * S / kappa * arb(chance.uniform(0.8, 3))
    V = (G - S) / kappa
    Y = -(D + s * force + k * V) / (kappa * k)
    values = {"b": -G + q * force, "Y": Y, "V": V, "Z": Y + force / k, "T": (arb("0.5") + q) * 1000}
    return [*(values[name] for name in (*form.names, "T")), force]


@pytest.mark.parametrize("form", [MODEL, STIFF], ids=["paper", "stiff"])
def test_cones_hold_the_whole_ball(form: ContactForm) -> None:
    """Each inequality of Theorems R1 and R4. A ball of states that is not certainly in the cone yields none."""
    chance, kinds = random.Random(2), set[type]()
    k, kappa, s = form.k, form.kappa, form.s
    with working_bits(128):
        for _ in range(60):
            box = contact_state(form, chance)
            bounds, at = form.bounds(box), ContactPoint.of(form, box)
            for cone in cones(form, at, bounds):
                kinds.add(type(cone))
                assert cone.rate * at.force <= at.D
                if isinstance(cone, FastCone):
                    assert cone.rate * (s + cone.rate) * at.force <= k * at.S
                else:
                    assert isinstance(cone, SlowCone)
                    assert cone.rate * (at.D + s * at.force) <= k * at.S
                    assert cone.rate * at.S <= kappa * at.G
                    assert cone.c * at.S <= at.D
            wide = arb(box[-1].mid(), box[-1].mid())
            assert not list(cones(form, replace(at, force=wide), bounds))
            assert not list(cones(form, replace(at, W=arb(-1)), bounds))
            assert not list(cones(form, replace(at, G=arb(-1)), bounds))
            assert not list(cones(form, at, replace(bounds, slope=-bounds.slope)))
    assert kinds == {FastCone, SlowCone}


@pytest.mark.parametrize("form", [MODEL, STIFF], ids=["paper", "stiff"])
def test_the_point_of_a_cone(form: ContactForm) -> None:
    """λ' = k (Z' - Y'), with the equations of the scene."""
    system = (STIFF_SCENE if form is STIFF else load_scene("fig-varsim1")).system("slip")
    with working_bits(128):
        box = contact_state(form, random.Random(5))
        at = ContactPoint.of(form, box)
        rates = float_function(system.right_hand_side)([approximate(value) for value in box[:-1]])
    by_name = dict(zip(system.states, rates, strict=True))
    k, kappa = approximate(form.k), approximate(form.kappa)
    assert pytest.approx(k * (by_name["Z"] - by_name["Y"])) == approximate(at.D)
    assert pytest.approx(-by_name["Y"]) == approximate(at.W)
    assert pytest.approx(-by_name["V"]) == approximate(at.G)
    assert pytest.approx(-kappa * by_name["Y"] - by_name["V"]) == approximate(at.S)


@pytest.mark.parametrize(
    ("slope", "constant", "factor", "kept"),
    [
        ("-0.2101", "0", "0", True),
        ("-0.2099", "0", "0", False),
        ("0.2101", "0", "0", False),
        ("[-0.3 +/- 0.1]", "0", "0", False),
        ("-0.2301", "0", "0.002", True),
        ("-0.2299", "0", "0.002", False),
        ("-0.2301", "0.001", "0", True),
        ("-0.2299", "0.001", "0", False),
        ("-0.2101", "-5", "0", True),
        ("-0.2101", "0", "-5", True),
        ("-0.2301", "-5", "0.002", True),
        ("-0.2299", "-5", "0.002", False),
        ("nan", "0", "0", False),
    ],
)
def test_the_inequality_of_the_fast_cone(slope: str, constant: str, factor: str, kept: bool) -> None:
    """q >= a (2 + a) + h/a, with a = 1/10 and h = factor + constant/λ_0, λ_0 = 1/2, but not below 0."""
    cone = FastCone(MODEL, arb("0.1"), arb("0.5"))
    assert cone.is_kept(of(slope, constant, factor)) is kept
    assert cone.is_kept_for_ever(of(slope, constant, factor)) is kept


@pytest.mark.parametrize(
    ("bounds", "kept"),
    [
        (of("-0.1", constant="-1.979"), True),
        (of("-0.1", constant="-1.981"), False),
        (of("-0.1", factor="-0.789"), True),
        (of("-0.1", factor="-0.793"), False),
        (of("-9.9"), True),
        (of("-10.1"), False),
    ],
)
def test_the_second_inequality_of_the_slow_cone_is_sharp(bounds: ContactBounds, kept: bool) -> None:
    """(k - c (κ + s) - c² q - c² h'/a) S >= c A with k = κ = 1, s = 2, c = 1/5, a = 0.08, S = 1. With q = 1/10 the
    bracket is 0.396 - h'/2, so A <= 1.98, or h' <= 0.792 where A = 0; with h' = A = 0 it is 0.4 - q/25."""
    assert SlowCone(MODEL, arb("0.08"), arb("0.2"), arb(1), arb(1)).is_kept(bounds) is kept


@pytest.mark.parametrize(("S", "kept"), [("0.506", True), ("0.504", False)])
def test_the_lift_is_measured_by_S(S: str, kept: bool) -> None:
    """0.396 S >= c A with A = 1: S >= 0.50505."""
    assert SlowCone(MODEL, arb("0.08"), arb("0.2"), arb(1), arb(S)).is_kept(of("-0.1", constant="-1")) is kept


@pytest.mark.parametrize(("slope", "kept"), [("-0.0349", True), ("-0.0347", False)])
def test_the_first_inequality_of_the_slow_cone_is_sharp(slope: str, kept: bool) -> None:
    """(κ - a) c q >= a²: q >= 0.0064/0.184 = 0.034783."""
    assert SlowCone(MODEL, arb("0.08"), arb("0.2"), arb(1), arb(1)).is_kept(of(slope)) is kept


@pytest.mark.parametrize(
    ("factor", "constant", "kept"),
    [("0.00521", "0", True), ("0.00522", "0", False), ("0", "0.0104", True), ("0", "0.0105", False)],
)
def test_the_load_of_the_slow_cone_is_sharp(factor: str, constant: str, kept: bool) -> None:
    """(κ - a) c (q - h/a) >= a² with q = 1/10: h <= 0.0052174; h = factor + constant/λ_0 with λ_0 = 2."""
    assert SlowCone(MODEL, arb("0.08"), arb("0.2"), arb(2), arb(1)).is_kept(of("-0.1", constant, factor)) is kept


def test_equality_is_enough() -> None:
    """Both inequalities of (4) as equalities, in numbers that balls hold: a = 1/2, c = 1/4, k = κ = 1, s = 2."""
    a, c = arb(1) / 2, arb(1) / 4
    # q = 2: (κ - a) c q = a² = 1/4, and (1/4 - q/16) S = c A = 1/4 with S = 2, A = 1.
    assert SlowCone(MODEL, a, c, arb(1), arb(2)).is_kept(of("-2", constant="-1"))
    # q = 4: the bracket is 0, and so is A.
    assert SlowCone(MODEL, a, c, arb(1), arb(2)).is_kept(of("-4"))


def test_no_cone_where_the_force_does_not_act() -> None:
    with working_bits(128):
        box = contact_state(MODEL, random.Random(2))
        bounds, at = MODEL.bounds(box), ContactPoint.of(MODEL, box)
        assert list(cones(MODEL, at, replace(bounds, slope=arb(0)))) == []


def test_the_stiffness_counts_where_the_ball_is_wide() -> None:
    """k S >= a M for all of the ball: with k = 1/3, S between 2 and 198 percent of its midpoint is too wide."""
    found = 0
    with working_bits(128):
        for seed in range(20):
            box = contact_state(STIFF, random.Random(seed))
            bounds, at = STIFF.bounds(box), ContactPoint.of(STIFF, box)
            wide = replace(at, S=arb(at.S.mid(), at.S.mid() * 0.98), G=at.G * 100)
            found += any(isinstance(cone, SlowCone) for cone in cones(STIFF, replace(at, G=at.G * 100), bounds))
            assert not any(isinstance(cone, SlowCone) for cone in cones(STIFF, wide, bounds))
    assert found == 20
