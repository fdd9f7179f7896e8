"""All G-spots classified: each as it is near its place, what depends on free components, the exit codes."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.functions.expressions import Constant, Sine, Variable
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify import classify, classify_g_spot
from gspot_verified.mechanisms.spots.classify_all import _has_period, _is_named, classify_all, named_spot


def test_one_of_them_is_the_exact_one() -> None:
    """Two routes: rational arithmetic at the place of the file, and the search in balls that knows no place."""
    for name in ("oscillator", "rod", "falling_rod_lower_friction"):
        exact, found = classify(shipped_mechanism(name)), classify_all(shipped_mechanism(name))
        assert found.exit_code == 0
        assert len(found.found.spots) == len(found.spots)
        assert [spot for spot in found.spots if spot.exact] == [exact]
        # The box that stood in its place has the same numbers.
        near = [
            spot
            for spot in map(classify_g_spot, find_g_spots(shipped_mechanism(name)).spots)
            if (spot.alpha_1 - exact.alpha_1).contains(0) and (spot.slip_velocity - exact.slip_velocity).contains(0)
        ]
        assert len(near) == 1
        assert not near[0].exact
        for part in ("alpha_2", "alpha_3", "beta", "mean_force", "a", "A", "B", "C", "p"):
            left, right = getattr(near[0], part), getattr(exact, part)
            assert left.is_finite()
            assert (left - right).contains(0), part
        assert (near[0].case, near[0].lift_off_sign) == (exact.case, exact.lift_off_sign)


def test_the_rod_of_opposite_spin_is_the_rod_in_reversed_time() -> None:
    """Reversing all velocities keeps p and b, and changes the sign of the three alphas."""
    found = classify_all(shipped_mechanism("genot_brogliato_rod", mu=2))
    pairs = [(found.spots[i], found.spots[i + 1]) for i in (0, 2)]
    for left, right in pairs:
        for part in ("alpha_1", "alpha_2", "alpha_3"):
            assert (getattr(left, part) + getattr(right, part)).contains(0)
    assert {spot.case for spot in found.spots} == {"none", "II"}


def test_free_components_are_named() -> None:
    rod = lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/12"]], ["-X", -1, 0], "X + cos(theta)/2",
        "Y - sin(theta)/2", 2,
    )  # fmt: skip
    found = classify_all(rod)
    assert found.found.free == ("X", "X_dot")
    assert dict(found.vary) == {"X": ("a",), "X_dot": ("u",)}
    assert "note: X stands in a" in str(found)


def test_exit_codes() -> None:
    assert classify_all(shipped_mechanism("genot_brogliato_rod", mu="13/10")).exit_code == 1
    assert classify_all(shipped_mechanism("genot_brogliato_rod", mu="4/3")).exit_code == 2
    found = classify_all(shipped_mechanism("genot_brogliato_rod", mu=2))
    assert found.exit_code == 0
    assert replace(found, spots=(replace(found.spots[0], case=None),)).exit_code == 2
    with pytest.raises(TypeError, match="verdict"):
        bool(found)


def test_plain_data() -> None:
    data = json.loads(json.dumps(classify_all(shipped_mechanism("model")).to_json()))
    assert data["spots"][0]["case"] == "III"
    assert data["vary"] == {}
    assert data["search"]["complete"] is True


def test_what_the_contact_is_like_is_exact_at_a_rational_point() -> None:
    """The rod at sine 3/5, cosine 4/5: A = 1 + 3 sin^2, B = 3 sin cos, C = 1 + 3 cos^2, a = -cos (X has no force)."""
    found = classify(shipped_mechanism("rod"))
    assert (found.A, found.B, found.C, found.p) == (fmpq(52, 25), fmpq(36, 25), fmpq(73, 25), fmpq(0))
    assert found.a == fmpq(-4, 5)


def rod_with_a_rotor(torque: str, inertia: str = "1") -> Mechanism:
    """The slender rod below a rotor whose angle phi stands in the vertical force by its sine."""
    mass = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/12", 0], [0, 0, 0, inertia]]
    fixed = {"X": 0, "X_dot": 1, "theta_dot": "7/4", "phi_dot": 0}
    return lagrangian(
        "rod", ["X", "Y", "theta", "phi"], mass, [0, "-1 + sin(phi) + phi_dot/10", 0, torque], "X + cos(theta)/2",
        "Y - sin(theta)/2", 2, place=fixed, fixed=list(fixed),
    )  # fmt: skip


def test_what_has_not_the_period_of_the_conditions_is_named() -> None:
    """p, b, y, v have the period 2 pi in phi; alpha_2 holds phi'' = -phi: a turn further it is 2 pi/10 C less."""
    found = classify_all(rod_with_a_rotor("-phi"))
    assert len(found.spots) == 4
    assert dict(found.vary) == {"phi": ("alpha_2",)}
    assert "note: phi stands in alpha_2, and they have not the period of the conditions" in str(found)
    further = classify_all(rod_with_a_rotor("-phi"), {"phi": (4, 10)})
    assert found.spots[0].alpha_2 != further.spots[0].alpha_2
    assert further.vary == ()
    assert classify_all(rod_with_a_rotor("-sin(phi)")).vary == ()
    assert dict(classify_all(rod_with_a_rotor("0", "1 + phi^2")).vary) == {"phi": ("the mass matrix",)}


def test_the_exact_one_is_named_also_where_something_is_left() -> None:
    """p = w^2 (w - 1): a simple zero at the place given, and a double one, which cannot be settled."""
    mu = "1 - w^2*(w - 1)"
    made = from_fields(
        "left", ["x", "u", "y", "v", "w", "s"], ["u", 0, "v", "s", 1, 1], [0, 2, 0, mu, 0, 0], [0, mu, 0, 1, 0, 0],
        "x", "y", 1, place={"x": 0, "u": 1, "y": 0, "v": 0, "w": 1, "s": 0}, fixed=["x", "u"],
    )  # fmt: skip
    found = classify_all(made, {"w": (-1, 2)}, budget=300)
    assert found.found.left
    assert [spot.exact for spot in found.spots] == [True]
    assert found.exit_code == 2


def test_spots_at_the_boundary_are_shown() -> None:
    found = classify_all(shipped_mechanism("model"))
    moved = replace(found, found=replace(found.found, spots=(), boundary=found.found.spots), spots=())
    assert "\nat the boundary of the region: x = 0, u = 1, y = 0, v = 0, p = 0, b = 0" in str(moved)
    assert "boundary" not in str(found)


def test_a_period_is_a_whole_multiple_of_the_functions_own() -> None:
    half, double = Sine(Constant(fmpq(1, 2)) * Variable(0)), Sine(Constant(fmpq(2)) * Variable(0))
    assert [_has_period([half], 0, fmpq(n)) for n in (1, 2, 3, 4)] == [False, True, False, True]
    assert [_has_period([double], 0, fmpq(n, 4)) for n in (1, 2, 3, 4)] == [False, True, False, True]
    assert _has_period([double], 1, fmpq(1, 7))
    assert not _has_period([Variable(0)], 0, fmpq(1))


def test_the_table_leaves_out_what_follows_and_what_is_fixed() -> None:
    text = str(classify_all(shipped_mechanism("genot_brogliato_rod", mu="7/5")))
    assert " 1    theta = 0.970155, theta_dot = -1.55702  2.64225 " in text


@pytest.mark.parametrize("name", ["genot_brogliato_rod", "oscillator"])
def test_the_named_spot_is_one_of_the_list_with_the_same_fixed_components(name: str) -> None:
    """Its box is narrower than that of the list, or it is a point; with other fixed components it is another one."""
    mechanism = shipped_mechanism(name)
    found = find_g_spots(mechanism)
    named = named_spot(mechanism, found, 128)
    assert named is not None
    (own,) = [spot for spot in found.spots if _is_named(spot, named)]
    assert not _is_named(replace(own, fixed=(*own.fixed, mechanism.state[-1])), named)
    if not named.exact:
        pairs = [pair for pair in zip(own.system.point, named.system.point, strict=True) if pair[0].rad() > 0]
        assert pairs
        for wide, narrow in pairs:
            assert narrow.rad() < wide.rad()
