"""The pictures of the theory say what the paper says: forces, trajectories, where they end."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest
import theory_pictures
from theory_pictures import ALPHAS, FRICTION, STARTS, forces, slip, slope

NUMBER = re.compile(r"-?\d+\.\d+")


@pytest.mark.parametrize("name", theory_pictures.pictures())
def test_the_file_is_what_the_script_draws(name: str) -> None:
    """Up to the last digit of a place on the page, which another processor may round otherwise."""
    drawn = theory_pictures.pictures()[name]
    kept = (theory_pictures.STATIC / name).read_text(encoding="utf-8")
    assert NUMBER.sub("x", drawn) == NUMBER.sub("x", kept), "run: python docs/extensions/theory_pictures.py"
    pairs = zip(NUMBER.findall(drawn), NUMBER.findall(kept), strict=True)
    assert all(abs(float(one) - float(other)) < 0.25 for one, other in pairs)


def test_the_friction_force_is_mu_times_the_normal_one_against_slip() -> None:
    """The picture's y goes downwards; slip is to the right."""
    drawn = forces((10, 20), 100)
    (begin, normal), (_, tangential) = drawn["λ_N"], drawn["λ_T"]
    assert begin == (10, 20)
    assert (normal[0] - 10, 20 - normal[1]) == (0, 100)
    assert tangential == (10 - FRICTION * 100, 20)
    slips = re.search(
        r'x1="(\S+)" y1="\S+" x2="(\S+)"[^>]*/><[^>]*>slip', theory_pictures.mechanism().replace("\n", "")
    )
    assert slips is not None
    assert float(slips[1]) < float(slips[2])


@pytest.mark.parametrize("case", ALPHAS)
def test_the_drawn_alphas_are_of_their_case(case: str) -> None:
    first, second, third = ALPHAS[case]
    assert {
        "I": second < 0 and first < third < 0,
        "II": second > 0 and first < third < 0,
        "III": second < 0 and third < first < 0,
    }[case]


@pytest.mark.parametrize("case", ALPHAS)
def test_trajectories_solve_the_equations_of_slip(case: str) -> None:
    """db/dp = (α_2 p + α_3 b)/(α_1 p) by differences, which share nothing with the closed form; p decreases."""
    first, second, third = ALPHAS[case]
    for start in STARTS[case]:
        path = slip(case, start)
        assert path[0] == pytest.approx(start)
        for (p, b), (q, d) in pairwise(path[:-1]):
            assert 0 < q < p
            assert d <= 1e-12
            p_middle, b_middle = (p + q) / 2, (b + d) / 2
            rate = (second * p_middle + third * b_middle) / (first * p_middle)
            if p - q < 0.04 * p:
                assert (b - d) / (p - q) == pytest.approx(rate, abs=2e-3)


@pytest.mark.parametrize("case", ALPHAS)
def test_they_end_where_the_paper_says(case: str) -> None:
    """Sec. 1.2: Case II from α_2 p < (α_1 − α_3) b on, Cases I and III always, at the G-spot; else b = 0, p > 0."""
    first, second, third = ALPHAS[case]
    ends = []
    for p, b in STARTS[case]:
        end = slip(case, (p, b))[-1]
        reaches = case != "II" or second * p < (first - third) * b
        assert (end == (0, 0)) == reaches
        assert reaches or (end[0] > 0 and end[1] == pytest.approx(0, abs=1e-12))
        ends.append(reaches)
    assert len(set(ends)) == (2 if case == "II" else 1)


@pytest.mark.parametrize(("case", "tends"), [("I", None), ("II", None), ("III", 2 / 3)])
def test_the_force_next_to_the_g_spot(case: str, tends: float | None) -> None:
    """−b/p grows without bound in Cases I and II and tends to α_2/(α_3 − α_1) in Case III."""
    first, second, third = ALPHAS[case]
    for start in STARTS[case]:
        path = slip(case, start)
        if path[-1] == (0, 0):
            (p, b), before = path[-2], path[len(path) // 2]
            if tends is None:
                assert -b / p > 3 * -before[1] / before[0]
            else:
                assert -b / p == pytest.approx(tends, abs=0.01)
    assert -slope(case) == pytest.approx(second / (third - first))
