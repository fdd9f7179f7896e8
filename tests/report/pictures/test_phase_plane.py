"""The arrow of time on a run: between two neighbours of its points, the later one at the head."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.report.pictures.phase_plane import arrow_of_time

POINTS = st.tuples(st.floats(-10, 10), st.floats(-10, 10))


@given(st.lists(POINTS, min_size=2, max_size=9), st.floats(0.1, 10), st.floats(0.1, 10))
def test_it_lies_in_the_middle_of_the_length_and_points_forward(
    run: list[tuple[float, float]], width: float, height: float
) -> None:
    """Before its head lies at least half of the run, before its tail at most that."""

    def length(points: list[tuple[float, float]]) -> float:
        pairs = zip(points[1:], points[:-1], strict=True)
        return math.fsum(math.dist((a / width, b / height), (c / width, d / height)) for (a, b), (c, d) in pairs)

    arrow = arrow_of_time(tuple(run), width, height)
    if arrow is None:
        assert length(run) < 1e-150
        return
    places = [k for k in range(len(run) - 1) if (run[k], run[k + 1]) == arrow]
    room = 1e-9 * length(run)
    assert any(length(run[: k + 1]) - room <= length(run) / 2 <= length(run[: k + 2]) + room for k in places)


def test_a_run_that_rests_has_none() -> None:
    assert arrow_of_time(((1.0, 2.0), (1.0, 2.0)), 1, 1) is None
    assert arrow_of_time(((1.0, 2.0),), 1, 1) is None
