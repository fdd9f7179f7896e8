"""All G-spots: known answers in closed form, proofs of absence, folds, ends of intervals, budgets, surfaces.

proofs/all_g_spots.md.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, Place
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.all_g_spots import _Search, _singular, find_g_spots
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS, GSpot, find_g_spot
from gspot_verified.mechanisms.spots.g_spot_list import Account, GSpots, Left, Patch, in_words
from gspot_verified.mechanisms.spots.search_region import Region
from gspot_verified.mechanisms.spots.spot_conditions import Stage
from gspot_verified.mechanisms.zeros.all_zeros import Zeros, ZeroSearch
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Evidence, Outcome, Reason

CRITICAL = Fraction(4, 3)


def classical_rod(mu: Fraction, length: Fraction = Fraction(1), gravity: Fraction = Fraction(1)) -> Mechanism:
    """The slender rod of Genot and Brogliato."""
    return shipped_mechanism("genot_brogliato_rod", mu=mu, L=length, g=gravity)


def polynomial(p: str, b: str, extra: tuple[str, ...] = ("w", "s"), fixed: bool = True, x: str = "0") -> Mechanism:
    """A system with these p and b, functions of further components; A = 2, C = 1, B = 1 - p, mu = 1."""
    state = ["x", "u", "y", "v", *extra]
    none = [0] * len(extra)
    options: dict[str, Any] = {"fixed": ["x", "u"], "place": {"x": x, "u": 1}} if fixed else {}
    return from_fields(
        "polynomial", state, ["u", 0, "v", b, *([1] * len(extra))], [0, 2, 0, f"1 - ({p})", *none],
        [0, f"1 - ({p})", 0, 1, *none], "x", "y", 1, **options,
    )  # fmt: skip


def components(spot: GSpot, *words: str) -> list[arb]:
    state = spot.mechanism.state
    return [spot.system.point[state.index(word)] for word in words]


def by_formula(mu: Fraction, length: Fraction, gravity: Fraction) -> list[tuple[arb, arb]]:
    """p = 0: tan(theta)^2 - 3 mu tan(theta) + 4 = 0; b = 0: theta_dot^2 = 2 g/(L sin(theta)). (theta, theta_dot)."""
    root = (9 * arb(to_fmpq(mu * mu)) - 16).sqrt()
    found = []
    for sign in (-1, 1):
        theta = ((3 * arb(to_fmpq(mu)) + sign * root) / 2).atan()
        speed = (2 * arb(to_fmpq(gravity / length)) / theta.sin()).sqrt()
        found += [(theta, -speed), (theta, speed)]
    return found


def agree(found: GSpots, expected: list[tuple[arb, arb]]) -> bool:
    """Each expected pair is in exactly one proved box, and there are no more boxes."""
    boxes = [components(spot, "theta", "theta_dot") for spot in found.spots]
    hits = [sum(x.overlaps(a) and y.overlaps(c) for x, y in boxes) for a, c in expected]
    return len(boxes) == len(expected) and hits == [1] * len(expected)


@settings(deadline=None, max_examples=12)
@given(
    st.fractions(Fraction(-1), Fraction(3), max_denominator=20),
    st.sampled_from([Fraction(1), Fraction(1, 1000), Fraction(7, 3)]),
    st.sampled_from([Fraction(1), Fraction(981, 100)]),
)
def test_the_classical_rod_for_any_friction_and_in_any_units(mu: Fraction, length: Fraction, gravity: Fraction) -> None:
    found = find_g_spots(classical_rod(mu, length, gravity))
    if mu < CRITICAL and mu > -CRITICAL:
        assert found.complete
        assert found.spots == ()
        assert found.verdict.outcome is Outcome.REFUTED
    elif mu > CRITICAL:
        assert found.complete
        assert found.verdict.outcome is Outcome.PROVED
        with working_bits(150):
            assert agree(found, by_formula(mu, length, gravity))
    elif mu == CRITICAL:
        assert not found.complete


def test_the_four_spots_at_seven_fifths() -> None:
    """tan(theta) = (21 -+ sqrt(41))/10."""
    found = find_g_spots(classical_rod(Fraction(7, 5)))
    with working_bits(150):
        tangents = [(21 + sign * arb(41).sqrt()) / 10 for sign in (-1, 1)]
        for spot in found.spots:
            (theta, speed, Y, Y_dot) = components(spot, "theta", "theta_dot", "Y", "Y_dot")
            assert sum(theta.tan().overlaps(t) for t in tangents) == 1
            assert (speed * speed * theta.sin()).overlaps(arb(2))
            assert (2 * Y).overlaps(theta.sin())
            assert (2 * Y_dot).overlaps(theta.cos() * speed)
            assert theta.rad() < arb(2) ** -100
    assert dict(found.searched)["theta"].startswith("every angle")
    assert dict(found.searched)["theta_dot"] == "every value"


@pytest.mark.parametrize("box", [{"X": (1, 2)}, {"X": (-1, 2), "X_dot": (1, 3)}, {"X_dot": (2, 2)}])
def test_an_interval_of_a_fixed_component_is_refused(box: dict[str, tuple[int, int]]) -> None:
    """A rod stands anywhere: "no G-spot with X in [1, 2]", and "exactly 4 with X in [-1, 2]", hold at X = 0 alone."""
    with pytest.raises(MechanismError, match=r"box: X(_dot)? is among the components that the mechanism fixes"):
        find_g_spots(classical_rod(Fraction(7, 5)), box)


def test_an_interval_of_a_free_component_is_no_condition() -> None:
    """There are four for each X, and not "exactly 4 with X in [1, 2]"."""
    rod = replace(classical_rod(Fraction(7, 5)), place=Place())
    found = find_g_spots(rod, {"X": (1, 2)})
    assert found.verdict.outcome is Outcome.PROVED
    assert found.verdict.statement.endswith(
        "every angle theta; every value of theta_dot; any X in [1, 2], X_dot (no condition holds them)"
    )
    assert dict(found.searched)["X"] == "[1, 2]; free: no condition holds it"


@pytest.mark.parametrize("digits", [6, 12, 24, 45])
def test_next_to_the_fold(digits: int) -> None:
    """Two pairs of spots as near as 10^(-digits/2), or none; at the fold itself neither is said."""
    above = find_g_spots(classical_rod(CRITICAL + Fraction(1, 10**digits)))
    below = find_g_spots(classical_rod(CRITICAL - Fraction(1, 10**digits)))
    assert above.complete
    assert len(above.spots) == 4
    assert below.verdict.outcome is Outcome.REFUTED


def test_the_fold_is_bracketed_and_named() -> None:
    found = find_g_spots(classical_rod(CRITICAL))
    assert found.spots == ()
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.verdict.reason is Reason.HYPOTHESIS
    assert len(found.left) == 2
    for left in found.left:
        assert "fold" in left.why
        assert dict(left.sides)["theta"].startswith("[1.1071487177940")  # tan(theta) = 2
    assert {dict(left.sides)["theta_dot"][:15] for left in found.left} == {"[1.495348781221", "[-1.49534878122"}


def two_link_arm(mu: str, height: str) -> Mechanism:
    """Two slender links of length 1 and mass 1 hang from a hinge; absolute angles from the vertical."""
    return lagrangian(
        "two-link arm", ["a", "c"], [["4/3", "cos(a - c)/2"], ["cos(a - c)/2", "1/3"]],
        ["-sin(a - c)*c_dot^2/2 - 3*g*sin(a)/2", "sin(a - c)*a_dot^2/2 - g*sin(c)/2"],
        "sin(a) + sin(c)", "h - cos(a) - cos(c)", mu, {"g": 1, "h": height},
    )  # fmt: skip


@pytest.mark.parametrize(("mu", "count"), [("8/10", 4), ("2", 6), ("3/10", 0)])
def test_two_link_arm_against_a_scan(mu: str, count: int) -> None:
    """Two routes: the search; sign changes of p along the configurations in contact and the quadratic for speeds."""
    found = find_g_spots(two_link_arm(mu, "3/2"))
    assert found.complete
    assert len(found.spots) == count == scanned_arm(float(Fraction(mu)), 1.5)


def scanned_arm(mu: float, height: float) -> int:
    """Counts in floats: no proof, but nothing shared with the search."""
    import math

    def at(a: float, side: int) -> tuple[float, float]:
        c = side * math.acos(height - math.cos(a))
        coupling = math.cos(a - c) / 2
        determinant = 4 / 9 - coupling**2

        def solved(f: tuple[float, float]) -> tuple[float, float]:
            return (f[0] / 3 - coupling * f[1]) / determinant, (4 / 3 * f[1] - coupling * f[0]) / determinant

        gx, gy = (math.cos(a), math.cos(c)), (math.sin(a), math.sin(c))
        n, t = solved(gy), solved(gx)
        p = gy[0] * n[0] + gy[1] * n[1] - mu * (gy[0] * t[0] + gy[1] * t[1])
        # v = 0: (a', c') = s (sin c, -sin a).
        x, z = math.sin(c), -math.sin(a)

        def b(s: float) -> float:
            rest = solved((
                -math.sin(a - c) * (z * s) ** 2 / 2 - 1.5 * math.sin(a),
                math.sin(a - c) * (x * s) ** 2 / 2 - math.sin(c) / 2,
            ))  # fmt: skip
            return gy[0] * rest[0] + gy[1] * rest[1] + math.cos(a) * (x * s) ** 2 + math.cos(c) * (z * s) ** 2

        curvature, constant = b(1.0) - b(0.0), b(0.0)
        return p, -constant / curvature

    end = math.acos(height - 1)
    count = 0
    for side in (-1, 1):
        grid = [-end + 2 * end * (k + 0.5) / 4001 for k in range(4001)]
        pairs = [at(a, side) for a in grid]
        for (p, square), (q, _) in itertools.pairwise(pairs):
            count += 2 * (p * q < 0 and square > 0)
    return count


def test_the_oscillator_has_the_papers_spot_and_others() -> None:
    found = find_g_spots(shipped_mechanism("oscillator"))
    assert found.complete
    exact = find_g_spot(shipped_mechanism("oscillator"))
    here = [
        spot
        for spot in found.spots
        if all(x.overlaps(arb(y)) for x, y in zip(spot.system.point, exact.system.point, strict=True))
    ]
    assert len(here) == 1
    with working_bits(150):
        for spot in found.spots:
            (phi,) = components(spot, "phi")
            sine, cosine = (
                fmpq(4, 5) * phi.cos() + fmpq(3, 5) * phi.sin(),
                fmpq(3, 5) * phi.cos() - fmpq(4, 5) * phi.sin(),
            )
            # M^-1 = [[2, -s], [-s, 1]]/(2 - s^2), y_q = (s, 1), x_q = (c, 0): C = 1/(2 - s^2), B = s c/(2 - s^2).
            assert (1 - fmpq(25, 12) * sine * cosine).overlaps(arb(0))
    assert "more than one period" in dict(found.searched)["phi"]


def test_the_systems_of_the_paper_have_one_spot_each() -> None:
    for name in ("model", "extended"):
        found = find_g_spots(shipped_mechanism(name))
        assert found.complete
        assert len(found.spots) == 1
        assert all(value.overlaps(arb(int(i == 1))) for i, value in enumerate(found.spots[0].system.point))


def test_turning_the_coordinate_turns_the_spots() -> None:
    """The same rod with theta = 1 + angle: the seam lies elsewhere, and so do the boxes."""

    def rod(argument: str) -> Mechanism:
        return lagrangian(
            "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/12"]], [0, -1, 0],
            f"X + cos({argument})/2", f"Y - sin({argument})/2", "7/5",
        )  # fmt: skip

    plain, turned = find_g_spots(rod("theta")), find_g_spots(rod("theta + 1"))
    mirrored = find_g_spots(rod("-theta"))
    assert plain.complete
    assert turned.complete
    assert mirrored.complete
    assert plain.free == ("X", "X_dot")
    for spots, sign, move in ((turned, 1, 1), (mirrored, -1, 0)):
        expected = [
            (sign * theta - move, sign * speed)
            for theta, speed in (components(spot, "theta", "theta_dot") for spot in plain.spots)
        ]
        assert agree(spots, expected)


@pytest.mark.parametrize(("sine", "cosine"), [("-3/5", "-4/5"), ("3/5", "4/5"), ("-3/5", "4/5")])
def test_a_spot_at_the_seam_of_the_period_is_found_once(sine: str, cosine: str) -> None:
    """Angles are counted from the reference: with (-3/5, -4/5) the rational spot lies exactly at +-pi."""
    rod = lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, "-3/5", 0], "X + cos(theta)",
        "Y - sin(theta)", "73/36", {}, {"theta": (sine, cosine)},
    )  # fmt: skip
    found = find_g_spots(rod)
    assert found.complete
    assert len(found.spots) == 4
    heights = sorted(float(components(spot, "Y")[0]) for spot in found.spots)
    assert heights[0] == pytest.approx(0.6)
    assert heights[1] == pytest.approx(0.6)


@pytest.mark.parametrize(
    ("box", "inside", "boundary"),
    [
        ({"w": (0, 2), "s": (0, 2)}, 1, 0),
        ({"w": (-2, 2), "s": (-2, 2)}, 2, 0),
        ({"w": ("1/2", "3/5"), "s": (-1, 1)}, 0, 0),
        ({"w": (1, 2), "s": (0, 3)}, 0, 1),
        ({"w": (0, 1), "s": (1, 3)}, 0, 1),
        ({"w": (1, 1), "s": (-5, 5)}, 0, 1),
        ({"w": (-1, 1), "s": (-1, 1)}, 0, 2),
        ({"w": (-1, 1), "s": (-3, 0)}, 0, 1),
        ({"s": (0, 3)}, 1, 0),
        ({}, 2, 0),
    ],
)
def test_spots_at_ends_and_corners_of_the_box(box: dict[str, Any], inside: int, boundary: int) -> None:
    """p = w^2 - 1 and b = s^3 - w: spots at w = s = 1 and w = s = -1."""
    found = find_g_spots(polynomial("w^2 - 1", "s^3 - w"), box)
    assert (len(found.spots), len(found.boundary), len(found.left)) == (inside, boundary, 0)
    expected = Outcome.UNDECIDED if boundary else Outcome.PROVED if inside else Outcome.REFUTED
    assert found.verdict.outcome is expected


@pytest.mark.parametrize("budget", [1, 2, 5])
def test_a_small_budget_is_undecided_and_says_what_is_left(budget: int) -> None:
    found = find_g_spots(polynomial("w^2 - 2 + sin(s)", "s^3 - w"), budget=budget)
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.verdict.reason is Reason.BUDGET
    assert found.left
    assert all("budget" in left.why for left in found.left)
    assert find_g_spots(polynomial("w^2 - 2 + sin(s)", "s^3 - w")).complete


NEVER_NONE = {
    "p vanishes identically": ("sin(w)^2 + cos(w)^2 - 1", "s - 1/3"),
    "a double zero of p": ("(w - 1/3)^2", "s"),
    "a double zero of b": ("w - 1/3", "s^2 - 2*s + 1"),
    "curves that touch": ("w^2 + s^2 - 2", "w*s - 1"),
    "a quadruple zero": ("w^2", "s^2"),
    "a cusp": ("w - s^3", "w*s"),
}


@pytest.mark.parametrize(("p", "b"), NEVER_NONE.values(), ids=NEVER_NONE)
def test_what_cannot_be_settled_is_never_called_none(p: str, b: str) -> None:
    found = find_g_spots(polynomial(p, b), budget=4000)
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.left


def test_a_root_from_infinity_is_searched_within_stated_bounds() -> None:
    """b = w s^2 + s - 1 at w = 0, where the quadratic term vanishes."""
    found = find_g_spots(polynomial("sin(w)", "w*s^2 + s - 1"), {"w": ("-1", "1")})
    assert dict(found.searched)["s"] == "[-10, 10] (default bound)"
    assert len(found.spots) == 1
    assert components(found.spots[0], "s")[0].overlaps(arb(1))


def test_a_constant_p_is_decided_at_once() -> None:
    found = find_g_spots(polynomial("1", "s"), budget=1)
    assert found.verdict.outcome is Outcome.REFUTED


def test_more_unknowns_than_conditions_give_a_patch_or_a_proof_of_absence() -> None:
    sphere = find_g_spots(polynomial("w^2 + s^2 + r^2 - 1", "w - s^2", ("w", "s", "r")))
    assert sphere.patch is not None
    assert sphere.patch.dimension == 1
    assert not sphere.complete
    assert sphere.verdict.outcome is Outcome.PROVED
    assert "curve" in sphere.verdict.statement
    assert (
        find_g_spots(polynomial("w^2 + s^2 + r^2 + 1", "w - s^2", ("w", "s", "r"))).verdict.outcome is Outcome.REFUTED
    )
    free = find_g_spots(polynomial("w^2 + s^2 + r^2 - 1", "w - s^2", ("w", "s", "r"), fixed=False))
    assert free.patch is not None
    assert free.patch.dimension == 3


def test_a_patch_names_what_is_fixed() -> None:
    """For each X another X_dot: "for all th_dot exactly one with X_dot in [-3.68, -3.43]" holds at one X."""
    mass, forces = [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, "-3/5 - X_dot/5 - X/3", 0]
    for held, said in (({"fixed": ["X"]}, "; X = 0 fixed"), ({"conditions": ["X"]}, "; the given conditions J = 0")):
        dragged = lagrangian(
            "dragged", ["X", "Y", "th"], mass, forces, "X + cos(th)", "Y - sin(th)", 2, place={"X": 0}, **held
        )
        verdict = find_g_spots(dragged).verdict
        assert verdict.outcome is Outcome.PROVED
        assert verdict.statement.startswith("dragged has G-spots that form a curve in the region: every angle th; ")
        assert verdict.statement.endswith(said)


def test_what_may_vanish_gives_no_patch() -> None:
    """b = w (w^2 - 2) + 10^-180 is not 0 at the zeros of p = w^2 - 2, but no precision in use shows it."""
    state = ["x", "u", "y", "v", "w", "s", "r"]
    nearly = from_fields(
        "nearly", state, ["u", 0, "v", "w*(w^2 - 2) + 1/10^60/10^60/10^60", 1, 1, 1], [0, 2, 0, "3 - w^2", 0, 0, 0],
        [0, "3 - w^2", 0, 1, 0, 0, 0], "x", "y", 1, conditions=["s^2 + r^2 - 1", "x", "u - 1"],
    )  # fmt: skip
    found = find_g_spots(nearly, budget=100)
    assert found.patch is None
    assert found.verdict.outcome is Outcome.UNDECIDED


def test_a_component_that_follows_from_a_free_one_is_not_called_inside() -> None:
    """Contact with a slope: Y = sin(theta)/2 + X/10 with X free; for X in [0, 1] some spots leave Y < 1/2."""
    rod = lagrangian(
        "rod on a slope", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/12"]], [0, -1, 0],
        "X + cos(theta)/2", "Y - sin(theta)/2 - X/10", 2,
    )  # fmt: skip
    found = find_g_spots(rod, {"X": (0, 1), "Y": (0, "1/2")})
    assert found.spots == found.boundary == ()
    assert all("depends on a free one" in left.why for left in found.left)
    assert len(found.left) == 4
    free = find_g_spots(rod)
    assert len(free.spots) == 4
    assert all(spot.bits >= DEFAULT_BITS for spot in free.spots)


def test_two_functions_have_no_fold_of_one() -> None:
    square, line = Variable(0) * Variable(0), Variable(1)
    box = [arb(0, "0.1"), arb(0, "0.1")]
    assert _singular([square], Stage(("p",), (0,)), box).startswith("a fold: two zeros of p meet")
    assert _singular([square * Variable(0)], Stage(("p",), (0,)), box).startswith(
        "singular, or nearly: zeros of p meet"
    )
    assert _singular([square, line], Stage(("p", "b"), (0, 1)), box).startswith("singular, or nearly: zeros of p, b")


def test_a_mass_matrix_that_is_not_positive_definite_is_said() -> None:
    bad = from_fields(
        "bad", ["x", "u", "y", "v", "w", "s"], ["u", 0, "v", "s", 1, 1], [0, 0, 0, 0, 0, 0], [0, 0, 0, "w", 0, 0],
        "x", "y", 0, fixed=["x", "u"], place={"x": 0, "u": 1},
    )  # fmt: skip
    found = find_g_spots(bad)
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "A = L_GT u must be positive" in found.left[0].why


def test_bad_input_is_named() -> None:
    rod = classical_rod(Fraction(2))
    with pytest.raises(MechanismError, match="'phi' is no component of the state"):
        find_g_spots(rod, {"phi": (0, 1)})
    with pytest.raises(MechanismError, match="interval of theta is empty or reversed"):
        find_g_spots(rod, {"theta": (1, 0)})
    with pytest.raises(MechanismError, match="a float is not taken as exact"):
        find_g_spots(rod, {"theta": (0.5, 1)})  # type: ignore[dict-item]
    for budget in (0, -1, True, 1.5):
        with pytest.raises(ValueError, match="budget"):
            find_g_spots(rod, budget=budget)  # type: ignore[arg-type]
    with pytest.raises(MechanismError, match="the fixed component x has no value"):
        find_g_spots(from_fields(
            "f", ["x", "u", "y", "v", "w", "s"], ["u", 0, "v", "s", 1, 1], [0, 2, 0, 1, 0, 0], [0, 1, 0, 1, 0, 0],
            "x", "y", 1, fixed=["x", "u"],
        ))  # fmt: skip


def test_results_have_text_and_plain_data() -> None:
    import json

    found = find_g_spots(classical_rod(Fraction(7, 5)))
    text = str(found)
    assert "exactly 4 G-spots" in text
    assert text.count("G-spot 4") == 1
    words = ", ".join(f"{name} = {value}" for name, value in found.spots[0].to_json().items())
    assert f"  G-spot 1: {words}" in text.splitlines()
    assert "theta_dot = " in words
    data = json.loads(json.dumps(found.to_json()))
    assert data["verdict"]["outcome"] == "proved"
    assert len(data["spots"]) == 4
    with pytest.raises(TypeError, match="complete"):
        bool(found)


def test_only_an_angle_is_counted_from_its_reference() -> None:
    """The second angle from its own one; its velocity from none, though the mechanism has angles."""
    rod = shipped_mechanism("rod")
    (angle,) = rod.angles
    other = replace(angle, coordinate="eta")
    both = replace(rod, angles=(other, angle))
    said = [in_words(both, word, arb(1) / 2) for word in ("theta", "eta", "theta_dot", "X")]
    assert said == [f"{name}0.500000000000000" for name in ("theta_ref + ", "eta_ref + ", "", "")]


def sloped(surface: str) -> Mechanism:
    """The rod over a surface Y = surface(X): Y follows from the contact, X is free or not."""
    return lagrangian(
        "sloped", ["X", "Y", "w"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/12"]], [0, -1, 0], "X + cos(w)/2",
        f"Y - sin(w)/2 - {surface}", 2,
    )  # fmt: skip


def test_an_interval_for_a_free_component_never_hides_the_spots() -> None:
    """X = 5 is as good as X = 0: the spots repeat for every value of the free component."""
    rod = sloped("0")
    for box in ({"X": (5, 6)}, {"X": (0, 1), "X_dot": (-3, -2)}, {"X": (7, 7)}):
        found = find_g_spots(rod, box)
        assert found.complete
        assert len(found.spots) == 4
        assert find_g_spots(rod).free == ("X", "X_dot")


def test_an_interval_for_a_component_that_follows_from_a_free_one() -> None:
    """On Y = X the height follows from X: an interval for it excludes nothing while X is free."""
    incline = sloped("X/100")
    everywhere = find_g_spots(incline)
    assert everywhere.complete
    assert len(everywhere.spots) == 4
    far = find_g_spots(incline, {"Y": (50, 51)})
    assert far.verdict.outcome is not Outcome.REFUTED
    assert far.spots or far.left
    both = find_g_spots(incline, {"Y": (50, 51), "X": (0, 1)})
    assert both.complete
    assert both.verdict.outcome is Outcome.REFUTED


def test_a_patch_lies_in_the_box_and_has_a_positive_definite_mass_matrix() -> None:
    def sphere(box: dict[str, Any]) -> GSpots:
        return find_g_spots(polynomial("w^2 + s^2 + r^2 - 1", "w - s^2", ("w", "s", "r")), box)

    inside = sphere({"w": (0, 1), "s": (-1, 1), "r": (0, 1)})
    assert inside.patch is not None
    for word, text in (*inside.patch.parameters, *inside.patch.box):
        if word == "r":
            assert not text.startswith("[-")
    assert sphere({"w": (2, 3)}).verdict.outcome is Outcome.REFUTED
    bad = from_fields(
        "bad", ["x", "u", "y", "v", "w", "s", "r"], ["u", 0, "v", "s - r", 1, 1, 1], [0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, "w^2 + s^2 - 1", 0, 0, 0], "x", "y", 0, fixed=["x", "u"], place={"x": 0, "u": 1},
    )  # fmt: skip
    found = find_g_spots(bad, budget=500)
    assert found.patch is None
    assert found.verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize(
    ("mu", "length", "gravity"),
    [
        (Fraction(10**6), Fraction(1), Fraction(1)),
        (Fraction(2), Fraction(10**6), Fraction(1, 10**9)),
        (Fraction(2), Fraction(1, 10**6), Fraction(10**6)),
        (CRITICAL + Fraction(1, 10**18), Fraction(1, 999), Fraction(7)),
    ],
)
def test_wide_parameters(mu: Fraction, length: Fraction, gravity: Fraction) -> None:
    found = find_g_spots(classical_rod(mu, length, gravity))
    assert found.complete
    with working_bits(150):
        assert agree(found, by_formula(mu, length, gravity))


@pytest.mark.parametrize(
    ("mu", "height", "fixed"),
    [
        ("38/10", "1", {"a1": "-1/5", "a3_dot": "-4/5"}),
        ("2", "11/5", {"a1": "-93/100", "a2_dot": "1/10"}),
        ("33/10", "7/5", {"a1": "-69/100", "a1_dot": "-11/5"}),
    ],
)
def test_no_start_of_newtons_method_finds_a_spot_that_is_not_listed(
    mu: str, height: str, fixed: dict[str, str]
) -> None:
    """Two routes to the spots of a leg of three links: the list, and Newton's method in floats from 400 starts."""
    import random

    import numpy as np

    from gspot_verified.cost.benchmarks.mechanism import leg
    from gspot_verified.mechanisms.derive.to_system import shift
    from gspot_verified.mechanisms.spots.all_g_spots import spot_conditions

    made = leg(3, height, mu, fixed=list(fixed), place=fixed)
    found = find_g_spots(made)
    assert found.complete
    program = BoxProgram(list(spot_conditions(shift(made)).values()), 6)
    listed = [[float(value) for value in spot.system.point] for spot in found.spots]
    hit = set()
    source = random.Random(1)
    for _ in range(400):
        point = np.array([source.uniform(-3.2, 3.2) for _ in range(3)] + [source.uniform(-4, 4) for _ in range(3)])
        for _ in range(60):
            values, rows = program.gradients([arb(float(value)) for value in point])
            matrix = np.array([[float(entry) for entry in row] for row in rows])
            if not np.all(np.isfinite(matrix)) or abs(np.linalg.det(matrix)) < 1e-12 or np.max(np.abs(point)) > 1e6:
                break
            step = np.linalg.solve(matrix, np.array([float(value) for value in values]))
            point = point - step
            if np.max(np.abs(step)) < 1e-12:
                turned = point - 2 * np.pi * np.round(np.array([*point[:3], 0, 0, 0]) / (2 * np.pi))
                near = [i for i, spot in enumerate(listed) if np.max(np.abs(np.array(spot) - turned)) < 1e-8]
                assert len(near) == 1, turned
                hit.update(near)
                break
    assert len(hit) >= len(listed) - 2


def free_rod(mu: Fraction, vertical: str, **options: Any) -> Mechanism:
    """The slender rod with a vertical force of the user's own."""
    return lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/12"]], [0, vertical, 0],
        "X + cos(theta)/2", "Y - sin(theta)/2", mu, **options,
    )  # fmt: skip


def test_no_patch_over_a_configuration_that_is_not_proved() -> None:
    """Below 4/3 by 10^-190 no configuration has p = 0, but no enclosure tells: velocities cannot make a patch of it."""
    found = find_g_spots(free_rod(CRITICAL - Fraction(1, 10**190), "-1 - X_dot"), budget=3000)
    assert found.patch is None
    assert found.left
    assert found.verdict.outcome is Outcome.UNDECIDED
    above = find_g_spots(free_rod(Fraction(2), "-1 - X_dot"), budget=3000)
    assert above.patch is not None


def test_a_fixed_component_that_is_not_rational_lies_in_its_enclosure() -> None:
    mechanism = free_rod(Fraction(2), "-1", place={"X": "2^(1/2)", "X_dot": 0}, fixed=["X", "X_dot"])
    found = find_g_spots(mechanism)
    assert len(found.spots) == 4
    assert found.complete
    with working_bits(600):
        root = arb(2).sqrt()
        assert all(spot.system.point[0].is_finite() and spot.system.point[0].contains(root) for spot in found.spots)


@pytest.mark.parametrize("end", ["4/5", "1/2", Fraction(1, 3)])
def test_an_interval_of_one_rational_point(end: Any) -> None:
    """It is not empty, whether or not the number is dyadic; 4/5 is the Y_dot of the rod's place."""
    found = find_g_spots(shipped_mechanism("falling rod"), {"Y_dot": (end, end)})
    assert not found.left
    assert not found.spots
    assert len(found.boundary) == (1 if end == "4/5" else 0)
    with pytest.raises(MechanismError, match="empty or reversed"):
        find_g_spots(shipped_mechanism("falling rod"), {"Y_dot": ("1/3", "33333333333333333333/100000000000000000000")})


def test_what_is_left_open_is_not_called_complete() -> None:
    """The list of four with a box left, with one spot at the boundary, and as it is; and how each is shown."""
    found = find_g_spots(classical_rod(Fraction(7, 5)))
    spot, left = found.spots[0], Left((("theta", "[0, 1]"), ("X", "0")), "the budget of boxes ended")
    assert found.verdict.outcome is Outcome.PROVED
    assert found.verdict.statement.endswith(
        "exactly 4 G-spots in the region: every angle theta; every value of theta_dot; X = 0, X_dot = 2 fixed"
    )
    assert str(left) == "theta = [0, 1], X = 0: the budget of boxes ended"
    for other, reason in (
        (replace(found, left=(left,)), Reason.BUDGET),
        (replace(found, left=(replace(left, why="singular"),)), Reason.HYPOTHESIS),
        (replace(found, boundary=(spot,)), Reason.HYPOTHESIS),
        (replace(found, spots=(), boundary=(spot,)), Reason.HYPOTHESIS),
    ):
        assert not other.complete
        assert (other.verdict.outcome, other.verdict.reason) == (Outcome.UNDECIDED, reason)
    lines = str(replace(found, left=(left,) * 23, boundary=(spot,))).splitlines()
    assert sum(line == f"  left open: {left}" for line in lines) == 20
    assert "  and 3 boxes more left open" in lines
    assert not any("more are left" in line for line in str(replace(found, left=(left,) * 20)).splitlines())
    shown = [line.split(":")[0] for line in lines if line.startswith(("  G-spot", "  at the"))]
    assert shown == [*(f"  G-spot {n}" for n in range(1, 5)), "  at the boundary of the region 1"]
    patch = Patch(2, (("w", "[0, 1]"),), (("s", "[2, 3]"),))
    assert replace(found, patch=patch).verdict.outcome is Outcome.UNDECIDED
    patched = replace(found, patch=replace(patch, shown=less(0, 1)))
    assert (patched.complete, patched.verdict.outcome) == (False, Outcome.PROVED)
    assert "form a surface" in patched.verdict.statement
    assert "  fix components (fixed, conditions) for isolated G-spots and a complete list" in str(patched)
    assert "  for all w in [0, 1] exactly one with s in [2, 3]" in str(patched)


SPIN = {"theta_dot": (0, 100)}
"""Two of the four spots of the rod lie in this box, two outside."""


def test_each_solution_is_accounted_for() -> None:
    found = find_g_spots(classical_rod(Fraction(7, 5)), SPIN)
    account = found.account
    assert (len(account.inside), len(account.outside)) == (2, 2)
    assert sum(account.extensions) - len(account.extensions) == 3
    evidence = account.evidence(2, 0)
    assert evidence is not None
    assert found.verdict.evidence is not None
    assert found.verdict.evidence.facts == evidence.facts
    assert len(evidence.facts) > 20
    assert account.evidence(3, 0) is None
    assert account.evidence(2, 1) is None
    for wrong in (
        Account(),
        replace(account, stages=[None, *account.stages[1:]]),
        replace(account, inside=account.inside[1:]),
        replace(account, outside=account.outside[1:]),
        replace(account, outside=[*account.outside[1:], None]),
        replace(account, inside=[None, *account.inside[1:]]),
        replace(account, extensions=account.extensions[1:]),
        replace(account, extensions=[*account.extensions, 0]),
    ):
        other = replace(found, account=wrong)
        assert not other.complete
        assert other.verdict.outcome is Outcome.UNDECIDED
    fewer = replace(found, spots=found.spots[1:])
    assert (fewer.complete, fewer.verdict.outcome) == (False, Outcome.UNDECIDED)


def test_a_solution_that_is_lost_leaves_the_list_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a stage, or at its end."""
    solve, finish = _Search._solve, _Search._finish
    for attribute, lossy in (
        ("_solve", lambda self, *rest: solve(self, *rest)[1:]),
        ("_finish", lambda self, partial, *rest: rest[0] or finish(self, partial, *rest)),
    ):
        with monkeypatch.context() as patched:
            patched.setattr(_Search, attribute, lossy)
            found = find_g_spots(classical_rod(Fraction(7, 5)))
        assert len(found.spots) < 4
        assert found.verdict.outcome is Outcome.UNDECIDED
        assert not found.complete


def test_what_is_claimed_without_a_comparison_leaves_the_list_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """That a spot lies outside, or inside; that its zero is that of the stages; that a stage has no zero."""
    rod = classical_rod(Fraction(7, 5))
    for place, word in (("outside", 0), ("inside", 4)):
        with monkeypatch.context() as patched:
            patched.setattr(Region, "position", lambda *_, place=place: (place, None))
            found = find_g_spots(rod)
        assert len(found.spots) == word
        assert found.verdict.outcome is Outcome.UNDECIDED
    with monkeypatch.context() as patched:
        patched.setattr(ZeroSearch, "same", lambda *_: None)
        assert find_g_spots(rod).left
    with monkeypatch.context() as patched:
        patched.setattr(ZeroSearch, "run", lambda *_: Zeros())
        found = find_g_spots(rod)
        assert (found.spots, found.left) == ((), ())
        assert found.verdict.outcome is Outcome.UNDECIDED


def test_a_stage_that_is_left_out_proves_no_spot(monkeypatch: pytest.MonkeyPatch) -> None:
    solve = _Search._solve
    monkeypatch.setattr(
        _Search, "_solve", lambda self, stage, part: [part] if part.values else solve(self, stage, part)
    )
    found = find_g_spots(classical_rod(Fraction(7, 5)))
    assert not found.spots
    assert found.verdict.outcome is Outcome.UNDECIDED


def test_a_patch_hands_over_what_shows_it(monkeypatch: pytest.MonkeyPatch) -> None:
    sphere = polynomial("w^2 + s^2 + r^2 - 1", "w - s^2", ("w", "s", "r"))
    found = find_g_spots(sphere)
    assert isinstance(found.verdict.evidence, Evidence)
    assert sum("lies in the interior" in fact for fact in found.verdict.evidence.facts) == 2
    monkeypatch.setattr(Region, "position", lambda *_: ("inside", None))
    assert find_g_spots(sphere).patch is None


@pytest.mark.parametrize(
    ("angle", "region", "number", "turn"),
    [
        ("theta", "every angle theta;", 4, 4),
        ("2*theta", "every angle theta (counted in one period, pi);", 4, 8),
        ("theta/2", "every angle theta (counted in one period, 4 pi);", 4, 4),
    ],
)
def test_the_region_says_in_which_period_the_spots_are_counted(angle: str, region: str, number: int, turn: int) -> None:
    """A spot at theta is one at theta + pi where theta stands in sines and cosines of 2 theta: one turn has eight."""
    inertia = {"theta": "1/3", "2*theta": "4/3", "theta/2": "1/12"}[angle]
    rows = [[1, 0, 0], [0, 1, 0], [0, 0, inertia]]
    rod = lagrangian("rod", ["X", "Y", "theta"], rows, [0, "-1", 0], f"X + cos({angle})", f"Y - sin({angle})", 2)
    found = find_g_spots(rod)
    assert f"exactly {number} G-spots in the region: {region}" in found.verdict.statement
    given = find_g_spots(rod, {"theta": ("-1/10", "61/10")})  # a little less than a turn
    assert f"exactly {turn} G-spots in the region: theta in" in given.verdict.statement


def beside(mass: str, mu: str = "2") -> Mechanism:
    """The rod and a mass s beside it that p, b, y and v do not see."""
    rows = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, mass]]
    forces = [0, "-1", 0, 0]
    return lagrangian("rod", ["X", "Y", "theta", "s"], rows, forces, "X + cos(theta)", "Y - sin(theta)", mu)


def test_what_the_mass_matrix_holds_and_no_condition_is_stated_at_the_value_shown() -> None:
    """At |X| > 2 the mass of s is negative: there is no G-spot at X = 3, whatever X the conditions allow."""
    held = "X = 0 (the mass matrix or mu depends on it, no condition does)"
    found = find_g_spots(beside("4 - X^2"))
    assert "exactly 4 G-spots" in found.verdict.statement
    assert held in found.verdict.statement
    assert "any s, X_dot, s_dot (no condition holds them)" in found.verdict.statement
    assert "X = 1.5" in find_g_spots(beside("4 - X^2"), {"X": ("1/2", "5/2")}).verdict.statement
    within = find_g_spots(beside("4 - X^2"), {"X": (-1, 1)})
    assert "any X in [-1, 1], s, X_dot, s_dot (no condition holds them)" in within.verdict.statement
    plain = find_g_spots(beside("4"), {"X": (-1, 1)}).verdict.evidence
    assert within.verdict.evidence is not None
    assert plain is not None
    assert len(within.verdict.evidence.facts) > len(plain.facts)
    assert "any X, s, X_dot, s_dot" in find_g_spots(beside("4 - X^2", "1")).verdict.statement  # none at any X


def test_an_angle_with_which_the_mass_matrix_does_not_repeat_is_stated_for_one_period() -> None:
    """The mass of s is positive for |theta| < 2 only: two turns on, nothing is a G-spot."""
    statement = find_g_spots(beside("4 - theta^2")).verdict.statement
    assert "exactly 4 G-spots in the region: the angle theta, one period of it as shown" in statement
    assert "(the mass matrix or mu does not repeat with it)" in statement
    assert "region: every angle theta;" in find_g_spots(beside("4 + sin(theta)")).verdict.statement


def sprung(mu: str = "5/3") -> Mechanism:
    """A rod on a torsion spring: p = 0 at tan(theta) = 1 and 4; there theta_dot^2 = (1 - 3 theta cos/10)/sin."""
    return lagrangian(
        "sprung rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, -1, "-theta/10"],
        "X + cos(theta)", "Y - sin(theta)", mu, place={"X": 0, "X_dot": 1}, fixed=["X", "X_dot"],
    )  # fmt: skip


@pytest.mark.parametrize("box", [None, {"theta": (-20, 20)}, {"theta": (4, 11)}])
def test_where_a_spring_breaks_the_period_the_searched_interval_is_said(box: Any) -> None:
    lower, upper = (-3.25, 3.25) if box is None else box["theta"]
    angles = [math.atan(tangent) + math.pi * n for tangent in (1, 4) for n in range(-8, 8)]
    speeds = {at: (1 - 0.3 * at * math.cos(at)) / math.sin(at) for at in angles if lower < at < upper}
    expected = sorted(at for at, square in speeds.items() if square > 0 for _ in range(2))
    found = find_g_spots(sprung(), box)
    theta = found.spots[0].shifted.mechanism.state.index("theta")
    places = sorted(float(ball(spot.system.point[theta]).mid()) for spot in found.spots)
    assert found.complete
    assert places == pytest.approx(expected, abs=1e-12)
    region = "theta in [-13/4, 13/4] (default)" if box is None else f"theta in [{lower}, {upper}]"
    assert f"exactly {len(expected)} G-spots in the region: {region};" in found.verdict.statement
    remark = "theta in [-13/4, 13/4]: beyond it nothing was searched"
    assert (remark in str(found)) is (box is None)
    with pytest.raises(
        ValueError, match="G-spots in the region searched by default" if box is None else "G-spots .class"
    ):
        found.spot(99)


def test_a_fixed_component_is_named_exactly() -> None:
    """With x = 0.333333, six digits of it, there is no G-spot: w^2 + s^2 < 0."""
    found = find_g_spots(polynomial("w^2 + s^2 - x + 33333305/100000000", "w - s", x="3333331/10000000"))
    assert len(found.spots) == 2
    assert "x = [0.333333100000000 +/- 3e-20], u = 1 fixed" in str(found)
