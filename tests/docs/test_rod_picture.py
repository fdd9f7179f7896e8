"""The picture of README.md shows what the library finds."""

from __future__ import annotations

import math
import re

import pytest
import rod_picture

NUMBER = re.compile(r"-?\d+\.\d+")


def test_the_file_is_what_the_script_draws() -> None:
    """Up to the last digit of a place on the page, which another processor may round otherwise."""
    drawn, kept = rod_picture.picture(), rod_picture.PLACE.read_text(encoding="utf-8")
    assert NUMBER.sub("x", drawn) == NUMBER.sub("x", kept), "run: python docs/extensions/rod_picture.py"
    pairs = zip(NUMBER.findall(drawn), NUMBER.findall(kept), strict=True)
    assert all(abs(float(one) - float(other)) < 0.25 for one, other in pairs)


def test_the_dots_lie_where_p_and_b_vanish() -> None:
    """The formulas of the curves are written by hand; the dots are those that are proved."""
    spots = rod_picture.g_spots()
    assert len(spots) == 4
    for spot in spots:
        assert rod_picture.p(spot[0]) == pytest.approx(0, abs=1e-12)
        assert rod_picture.b(*spot) == pytest.approx(0, abs=1e-12)
    assert (rod_picture.ANGLE, 1.0) in [(pytest.approx(x), pytest.approx(y)) for x, y in spots]


def test_the_band_is_where_p_is_negative() -> None:
    first, last = (rod_picture.g_spots()[i][0] for i in (0, -1))
    assert rod_picture.p((first + last) / 2) < 0
    assert min(rod_picture.p(first - 0.1), rod_picture.p(last + 0.1)) > 0


def test_slip_comes_near_the_g_spot_or_lifts_off() -> None:
    paths = [rod_picture.slip(start) for start in rod_picture.STARTS]
    near = [math.dist(path[-1], (rod_picture.ANGLE, 1)) < 0.25 and rod_picture.p(path[-1][0]) < 0.02 for path in paths]
    assert near == [True, False, True, True, True]
    assert rod_picture.b(*paths[1][-1]) > 0
