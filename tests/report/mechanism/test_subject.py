"""A mechanism file for each G-spot that was found: the same mechanism, another place."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb

from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.report.mechanism.subject import Source, beta_ends, placed_at


def same(one: GSpot, other: GSpot) -> bool:
    with working_bits(one.bits):
        pairs = zip(one.system.point, other.system.point, strict=True)
        return all(ball(x).overlaps(ball(y)) for x, y in pairs)


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("genot_brogliato_rod", {"mu": "7/5"}),
        ("falling_rod", {}),
        ("falling_rod_lower_friction", {"g": "1"}),
        ("oscillator", {}),
        ("extended", {"alpha_3": "-7/2"}),
    ],
)
def test_each_g_spot_is_found_again_from_its_file(name: str, settings: dict[str, str]) -> None:
    source = Source("mechanism.toml", shipped_text(name), settings)
    spots = find_g_spots(source.mechanism).spots
    assert spots
    for spot in spots:
        used = placed_at(source, spot, "other.toml")
        assert replace(used.mechanism, place=source.mechanism.place) == source.mechanism
        there = find_g_spot(used.mechanism)
        assert [same(other, there) for other in spots].count(True) == 1
        assert same(spot, there)


def test_without_a_place_in_the_file() -> None:
    text = shipped_text("rod").partition("[g_spot]")[0]
    source = Source("mechanism.toml", text, {})
    spots = find_g_spots(source.mechanism).spots
    assert len(spots) > 1
    assert all(same(spot, find_g_spot(placed_at(source, spot, "x.toml").mechanism)) for spot in spots)


def test_a_file_that_cannot_be_changed_is_refused() -> None:
    before, _, _ = shipped_text("rod").partition("[g_spot]")
    inline = f"g_spot = {{fixed = ['X', 'X_dot']}}\n{before}"
    spot = find_g_spots(Source("mechanism.toml", before, {}).mechanism).spots[0]
    with pytest.raises(ValueError, match=r"write \[g_spot\] as a table of its own"):
        placed_at(Source("mechanism.toml", inline, {}), spot, "x.toml")
    held = replace(spot.mechanism, place=replace(spot.mechanism.place, conditions=()))
    formulas = replace(spot, shifted=replace(spot.shifted, mechanism=held))
    with pytest.raises(ValueError, match="its conditions J are formulas"):
        placed_at(Source("mechanism.toml", before, {}), formulas, "x.toml")


def test_commands_name_the_file_and_its_settings() -> None:
    source = Source("mechanism.toml", "", {"mu": "2", "k": "-1/3"})
    assert source.command("classify", "--all") == "gspot-verified classify mechanism.toml --set mu=2 --set k=-1/3 --all"
    assert source.command("iwc", option="--mechanism").startswith("gspot-verified iwc --mechanism mechanism.toml --set")
    line = source.python("load", "print({mechanism}.name)")
    assert line.startswith("python -c 'from gspot_verified import load; print(load(")


@pytest.mark.parametrize("middle", ["2.00012", "0.00012", "1.00012", "2.99988", "7.000000012", "900001.000000012"])
def test_no_integer_lies_in_the_range_around_a_ball(middle: str) -> None:
    beta = arb(middle, "1e-10")
    lower, upper = beta_ends(beta)
    with working_bits(128):
        assert lower < beta < upper
    assert lower.floor() == upper.floor() < lower


@pytest.mark.parametrize("beta", [arb("2", "1e-9"), arb("0", "1e-9"), arb("1.5", 1), arb("nan")])
def test_a_ball_that_may_be_an_integer_has_no_range(beta: arb) -> None:
    with pytest.raises(ValueError, match="may be, an integer"):
        beta_ends(beta)
