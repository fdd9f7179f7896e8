"""simulate(): the certified run or the float run, by an argument; what belongs to the other kind is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gspot_verified import load_scene, scene_names, simulate
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.floats.float_run import float_run

QUICK: dict[str, Any] = {"method": "LSODA", "tolerance": 1e-5, "points": 3}


def test_it_is_the_certified_run() -> None:
    scene = load_scene("fig-varsim1", beta="1/2")
    found = simulate(scene, digits=20)
    assert found.to_json() == certified_run(scene, 20).to_json()
    assert found.strength == "certified"
    assert found.verdict.outcome.value == "proved"


def test_what_is_left_out_and_what_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    """The page's 15 decimals and 20 000 steps, Radau at 1e-10; each that is given is passed on, a 0 too."""
    scene, asked = load_scene("fig-varsim1"), list[tuple[Any, ...]]()
    for name in ("certified_run", "float_run"):
        monkeypatch.setattr(f"gspot_verified.scenes.simulate.{name}", lambda *given: asked.append(given))
    simulate(scene)
    simulate(scene, digits=0, budget=0, route="integrator", points=0, journal=Path("x"), progress=print)
    simulate(scene, floats=True)
    simulate(scene, floats=True, method="BDF", tolerance=0.0, points=0, journal=Path("x"))
    silent = asked[0][-1]
    assert asked == [
        (scene, 15, None, None, None, 20_000, silent),
        (scene, 0, "integrator", 0, Path("x"), 0, print),
        (scene, "Radau", 1e-10, None, None),
        (scene, "BDF", 0.0, 0, Path("x")),
    ]
    silent("nothing is shown")


def test_or_the_float_run() -> None:
    scene = load_scene("fig-varsim1", beta="3/2", nu=2)
    found = simulate(scene, floats=True, method="LSODA", tolerance=1e-6, points=5)
    assert found.to_json() == float_run(scene, "LSODA", 1e-6, 5).to_json()
    assert found.strength == "simulated"
    assert found.verdict.outcome.value == "undecided"


def test_a_name_or_a_file_is_loaded(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(
        'format = 1\nname = "mine"\neffects = ["compliant_contact", "lift_off"]\nepsilon = "1/1000"\nuntil = 1\n'
        '[parameters]\nbeta = "1/2"\n[start]\np = "1/2"\nb = 1\ny = "-2/1000000"\nv = 0\nz = "-1/1000000"\n'
    )
    assert simulate(path, floats=True, **QUICK).to_json() == float_run(load_scene(path), **QUICK).to_json()
    assert simulate("rod", floats=True, **QUICK).to_json() == float_run(load_scene("rod"), **QUICK).to_json()
    assert set(scene_names()) >= {"fig-varsim1", "rod"}


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"method": "LSODA"}, "method: it is for a float run"),
        ({"tolerance": 1e-6}, "tolerance: it is for a float run"),
        ({"floats": True, "digits": 20}, "digits: it is for a certified run"),
        ({"floats": True, "route": "exact"}, "route: it is for a certified run"),
        ({"floats": True, "budget": 5}, "budget: it is for a certified run"),
        ({"route": "guess"}, "route: expected exact or integrator"),
        ({"floats": True, "method": "Euler"}, "method"),
    ],
)
def test_what_is_of_the_other_kind_is_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(SceneError, match=message):
        simulate("fig-varsim1", **options)
