"""The benchmark of mechanisms: every row is there, nothing is asserted about times; the models are what they say."""

from __future__ import annotations

import json

import pytest
from flint import arb

from gspot_verified.cli import main
from gspot_verified.cost.benchmarks import mechanism, mechanism_states
from gspot_verified.cost.benchmarks.mechanism import chain, leg
from gspot_verified.cost.times.measure import Contestant, Timing, timing
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify import classify


def test_every_row_has_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mechanism, "measure", lambda contestants, _: {k: once(c) for k, c in contestants.items()})
    monkeypatch.setattr(mechanism, "_chains", lambda *_: [])
    monkeypatch.setattr(mechanism, "CASES", (("genot_brogliato_rod", {"mu": "1.3..1.6:3"}, 3),))
    monkeypatch.setattr(mechanism_states, "CASES", (("model", {"x": "0", "u": "3", "p": "1/2", "b": "-2"}),))
    monkeypatch.setattr(mechanism, "APPROACH_ROWS", 1)
    steps: list[str] = []
    report = mechanism.run(progress=steps.append)
    assert len(report.rows) == 23
    assert all(row.figure is not None and row.figure > 0 for row in report.rows)
    assert "the fold" in str(report)
    assert len(json.loads(json.dumps(report.to_json()))["rows"]) == 23
    assert "critical friction" in steps


def once(contestant: Contestant) -> Timing:
    """The call is made once: that it works is what is tested."""
    contestant.call()
    return timing([0.001])


def test_the_command_names_what_there_is(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cost", "mechanisms"]) == 64
    assert '"mechanism"' in capsys.readouterr().err


def test_a_chain_of_one_rod_is_the_rod() -> None:
    """Two descriptions of one mechanism: by its end, and by its centre."""
    place = {"X": "0", "X_dot": "0"}
    by_end = find_g_spots(chain(1, "7/5", fixed=list(place), place=place))
    by_centre = find_g_spots(
        lagrangian(
            "rod", ["X", "Y", "a"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/12"]], [0, -1, 0], "X + sin(a)/2",
            "Y - cos(a)/2", "7/5", fixed=list(place), place=place,
        )
    )  # fmt: skip
    assert len(by_end.spots) == len(by_centre.spots) == 4
    for spot in by_end.spots:
        angle, rate = spot.system.point[2], spot.system.point[5]
        hits = [
            other
            for other in by_centre.spots
            if other.system.point[2].overlaps(angle) and other.system.point[5].overlaps(rate)
        ]
        assert len(hits) == 1


def test_a_leg_found_without_a_place_is_found_from_its_place() -> None:
    fixed = {"a1": "-1", "a1_dot": "-2"}
    found = find_g_spots(leg(3, fixed=list(fixed), place=fixed))
    assert found.complete
    assert len(found.spots) == 2
    for spot in found.spots:
        near = {
            word: f"{float(value):.6f}" for word, value in zip(spot.mechanism.state, spot.system.point, strict=True)
        }
        again = classify(leg(3, fixed=list(fixed), place={**near, **fixed}, search=True))
        assert again.alpha_1.is_finite()
        alpha = spot.system.values_at_point([spot.system.alpha_1])[0]
        assert isinstance(alpha, arb)
        assert (again.alpha_1 - alpha).contains(0)


def test_a_chain_of_five_links_has_spots_that_are_proved() -> None:
    place = {"X": "0", "X_dot": "0"}
    for i in range(4):
        place |= {f"a{i + 1}": f"{i}/20", f"a{i + 1}_dot": "0"}
    found = find_g_spots(chain(5, "4", fixed=list(place), place=place))
    assert found.complete
    assert len(found.spots) == 4
