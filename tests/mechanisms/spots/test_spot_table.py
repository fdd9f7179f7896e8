"""The table of G-spots for people."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_text
from gspot_verified.mechanisms.spots.classify import Classification, classify
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.spot_table import one_spot, spot_table


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"alpha_1": "-3/2", "alpha_3": -1}, "impact without collision"),
        ({"alpha_1": "-3/2", "alpha_2": 1, "alpha_3": -1}, "impact without collision"),
        ({"alpha_3": "-3/2"}, "lift-off if C1 < 0, impact without collision if C1 > 0"),
        ({"alpha_3": "-5/2"}, "lift-off if C1 > 0, impact without collision if C1 < 0"),
        ({"alpha_3": -2}, "the side is open: β is, or may be, the integer 2"),
        ({"alpha_3": -3_000_001}, "the side is open: β is not evaluated"),
        ({"alpha_2": 1, "alpha_3": "-3/2"}, "no Case: alpha_2 > 0 and alpha_3 < alpha_1"),
        ({"alpha_1": 1}, "no Case: alpha_1 is not negative"),
        ({"alpha_2": 0}, "no Case: alpha_2 = 0: between the three ways"),
        ({"alpha_3": -1}, "no Case: alpha_1 = alpha_3, beta = 1"),
    ],
)
def test_what_happens_is_what_the_paper_says_and_no_more(parameters: dict[str, int | str], words: str) -> None:
    found = classify(shipped_mechanism("extended", **parameters))
    assert found.what_happens == words
    assert words in one_spot(found)


def test_an_open_case_is_undecided() -> None:
    found = replace(classify(shipped_mechanism("rod")), case=None, reason="the balls leave it open")
    assert found.what_happens == "undecided: the balls leave it open"
    assert spot_table([found])[1].split()[-8:-5] == ["?", "18/55", "undecided:"]


def test_one_row_for_each_with_its_number_and_the_file_s_own_has_a_star() -> None:
    found = classify_all(shipped_mechanism("oscillator"))
    lines = spot_table(found.spots, ("psi", "psi_dot"), found.at_place)
    assert lines[0].split("  ")[1] == "no."
    assert [line.split()[0] for line in lines[1:7]] == ["1", "2*", "3", "4", "5", "6"]
    assert all("psi" not in line for line in lines[:7])
    assert lines[7].strip().startswith("* found from the place")
    (warning,) = [line for line in lines if "warning" in line]
    assert "warning (G-spot 2): u < 0 at the G-spot" in warning
    # Two of the six are in Case III: what C1 says is said for them.
    assert sum("C1 says on which side" in line for line in lines) == 1
    starts = {line.index(word) for line, word in zip(lines[1:7], ["III"] * 2 + ["none"] * 4, strict=True)}
    assert len(starts) == 1


def test_the_star_is_also_of_a_g_spot_in_balls() -> None:
    """The rod's file names a start only: the G-spot that Newton's method reaches from there is the first of four."""
    assert classify_all(shipped_mechanism("genot_brogliato_rod")).at_place == 1
    assert classify_all(shipped_mechanism("genot_brogliato_rod", mu="13/10")).at_place is None


def test_no_ball_stands_in_it() -> None:
    for name in ("oscillator", "rod", "genot_brogliato_rod"):
        text = str(classify_all(shipped_mechanism(name)))
        assert "+/-" not in text
        assert "e-4" not in text
        assert "+/-" in classify_all(shipped_mechanism(name)).in_full()


def test_without_numbers_there_is_no_column_of_them() -> None:
    found = classify_all(shipped_mechanism("rod"), {"theta": (0, 1)})
    assert [spot.number for spot in found.spots] == [None, None]
    assert "no." not in str(found)
    assert found.at_place is None


def test_notes_and_fixed_components_are_said_once() -> None:
    found = classify(shipped_mechanism("rod"))
    noted = replace(found, notes=("mirrored",))
    assert str(spot_table([noted, noted])).count("note: mirrored") == 1
    first = one_spot(found).splitlines()[0]
    assert first == "falling rod: proved: a G-spot, exactly at the place of its file; X = 0, X_dot = 2 fixed"
    everything: Classification = replace(found, fixed=tuple(word for word, _ in found.point))
    assert "theta = theta_ref" in spot_table([everything])[1]


def test_no_spots_no_table() -> None:
    assert spot_table([]) == []


def test_a_fixed_component_has_all_of_its_digits(tmp_path: Path) -> None:
    text = shipped_text("rod").replace("X_dot = 2\n", 'X_dot = "2.000000001"\n')
    (tmp_path / "rod.toml").write_text(text, encoding="utf-8")
    first, _, row, *_ = one_spot(classify(load(tmp_path / "rod.toml"))).splitlines()
    assert first.endswith("; X = 0, X_dot = 2.000000001 fixed")
    assert " 1.40000 " in row


def test_newton_s_limit_is_found_from_the_place_not_at_it() -> None:
    """With mu = 9/5 the ellipse's G-spot is at Y = 0.609; its file, from where it is searched, has Y = 9/16."""
    first = one_spot(classify(shipped_mechanism("ellipse", mu="9/5"))).splitlines()[0]
    assert first.endswith(", the only one in a box, found from the place of its file; X = 0, X_dot = 2 fixed")


@pytest.mark.parametrize(("search", "found"), [(False, "exactly at"), (True, "the only one in a box, found from")])
def test_given_conditions_are_named(tmp_path: Path, search: bool, found: str) -> None:
    """x and u are free but for them: without them every box around this G-spot holds infinitely many."""
    given = f'conditions = ["x^2 + u^2 - 2", "x - u"]\nsearch = {str(search).lower()}'
    text = shipped_text("model system").replace('fixed = ["x", "u"]', given)
    (tmp_path / "model.toml").write_text(text.replace("\nx = 0\n", "\nx = 1\n"), encoding="utf-8")
    spot = classify(load(tmp_path / "model.toml"))
    end = f"a G-spot, {found} the place of its file; with the given conditions J = 0"
    assert one_spot(spot).splitlines()[0].endswith(end)
    assert "\n  with the given conditions J = 0" in str(spot)
    assert (spot.to_json()["given_conditions"], spot.to_json()["fixed"]) == (True, [])
    assert classify(shipped_mechanism("model system")).to_json()["given_conditions"] is False
