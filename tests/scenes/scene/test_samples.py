"""Trajectories as arrays and files; enclosures against the float run; a journal after a kill."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.certified_samples import midpoint_and_radius
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.floats.float_run import FloatPhase, float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.samples import Samples
from gspot_verified.scenes.scene.scene import SceneError

SAMPLES = Samples({"t": np.array([0.0, 0.1]), "b": np.array([1 / 3, -2e-9])}, ("slip", "flight"))


@pytest.mark.parametrize(
    ("beta", "nu"), [("3/2", "2"), pytest.param("5/2", "2", marks=pytest.mark.slow), ("1/2", "1/4")]
)
def test_enclosures_hold_what_floats_find(beta: str, nu: str) -> None:
    """In contact, in flight, and into an impact: every value of the float run lies within a small multiple of its
    tolerance of the enclosure, which is much narrower."""
    scene = load_scene("fig-varsim1", beta=beta, nu=nu)
    run, seen = certified_run(scene, points=21), float_run(scene, points=21).samples
    exact = run.samples
    at_events = {round(float(event.lower), 12) for event in run.events}
    assert exact is not None
    assert seen is not None
    places = {t: i for i, t in enumerate(seen.columns["t"].round(12).tolist())}
    rows = [(i, places[t]) for i, t in enumerate(exact.columns["t"].round(12).tolist()) if t in places]
    assert len(rows) >= 10
    for i, j in rows:
        assert exact.phases[i] == seen.phases[j] or round(exact.columns["t"][i], 12) in at_events
        for name in ("p", "b", "y", "v", "z", "lambda_N"):
            middle, radius = exact.columns[name][i], exact.columns[name + "_radius"][i]
            size = max(abs(exact.columns[name]).max(), 1e-30)
            assert abs(seen.columns[name][j] - middle) <= radius + 2e-5 * abs(middle) + 1e-8 * size, (name, i)
            assert radius <= 1e-9 * size


@pytest.mark.parametrize(("name", "settings"), [("rod", {}), ("fig-varsim2", {"chi": 0}), ("fig-varsim1", {})])
def test_enclosures_of_the_integrator(name: str, settings: dict[str, int]) -> None:
    """Every column of the float run passes through the enclosures of all phases, the times of both in order."""
    scene = load_scene(name, **settings)
    exact, seen = certified_run(scene, route="integrator", points=2).samples, float_run(scene, points=4001).samples
    assert exact is not None
    assert seen is not None
    assert {"slip", "flight"} <= set(exact.phases) <= set(seen.phases)
    times = exact.columns["t"]
    assert np.all(np.diff(times) >= 0)
    inside = times <= seen.columns["t"][-1]
    assert np.count_nonzero(inside) > 60
    for column in [word for word in seen.columns if word != "t"]:
        found = np.interp(times[inside], seen.columns["t"], seen.columns[column])
        size = np.abs(exact.columns[column][inside]).max()
        # Between the points of the float run lines are only drawn.
        assert np.abs(found - exact.columns[column][inside]).max() < 1e-2 * size, column
        assert exact.columns[column + "_radius"][inside].max() < 1e-9 * size, column


def test_enclosures_end_where_nothing_is_known() -> None:
    run = certified_run(load_scene("fig-varsim1", until="7/10"), points=29)
    (lift, land), found = run.events, run.samples
    assert found is not None
    times = found.columns["t"]
    assert times[-1] == pytest.approx(float(land.lower.p) / float(land.lower.q), abs=1e-15)
    in_flight = [t for t, phase in zip(times, found.phases, strict=True) if phase == "flight"]
    assert min(in_flight) == pytest.approx(float(lift.upper.p) / float(lift.upper.q), abs=1e-15)
    assert len(in_flight) == 8  # of equal steps 6, and the beginning and the end of the flight


@pytest.mark.parametrize("value", ["0", "1/3", "-7/5", "1e-320", "-1e300"])
def test_midpoint_and_radius_hold_the_ball(value: str) -> None:
    with working_bits(200):
        for radius in ("0", "1e-30", "2"):
            ball = arb(fmpq(*map(int, (str(_fraction(value)) + "/1").split("/")[:2]))) + arb(0, arb(radius))
            middle, half = midpoint_and_radius(ball)
            assert arb(middle) - arb(half) <= ball.lower()
            assert ball.upper() <= arb(middle) + arb(half)
    assert midpoint_and_radius(arb.nan()) == (0.0, float("inf"))


def _fraction(value: str) -> object:
    from fractions import Fraction

    return Fraction(value)


def test_points_are_equal_steps_of_time_and_the_events() -> None:
    scene = load_scene("fig-varsim1", until="3/5")
    run = float_run(scene, points=13)
    assert run.samples is not None
    times = run.samples.columns["t"]
    event = float(run.events[0].lower.p) / float(run.events[0].lower.q)
    # The event twice: the end of slip and the beginning of flight.
    assert times.tolist() == pytest.approx(sorted([0.05 * k for k in range(13)] + 2 * [event]), abs=1e-12)
    steps = float_run(scene).samples
    assert steps is not None
    dense = np.interp(0.25, steps.columns["t"], steps.columns["b"])
    assert run.samples.columns["b"][np.abs(times - 0.25).argmin()] == pytest.approx(dense, abs=1e-6)
    # At the solver's own steps no time comes twice but that of the event.
    assert np.count_nonzero(np.diff(steps.columns["t"]) <= 0) == 1
    with pytest.raises(SceneError, match=r"points: expected 2\.\.1000000, got 1"):
        float_run(scene, points=1)


def test_files_hold_the_arrays(tmp_path: Path) -> None:
    SAMPLES.save(tmp_path / "run.csv")
    SAMPLES.save(tmp_path / "run.npz")
    with (tmp_path / "run.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["b"]) for row in rows] == SAMPLES.columns["b"].tolist()
    with np.load(tmp_path / "run.npz") as found:
        assert found["b"].tolist() == SAMPLES.columns["b"].tolist()
        assert found["phase"].tolist() == ["slip", "flight"]
    with pytest.raises(ValueError, match=r"written as \.csv or \.npz"):
        SAMPLES.save(tmp_path / "run.txt")


@pytest.mark.parametrize("suffix", [".csv", ".npz"])
def test_a_file_holds_numbers_of_every_row_and_nothing_else(tmp_path: Path, suffix: str) -> None:
    """A column of objects is no trajectory (it would be pickled), and a row without a phase is not dropped in
    silence."""
    place = tmp_path / f"run{suffix}"
    SAMPLES.save(place)
    before = place.read_bytes()
    words = Samples({"t": np.array([0.0, 0.1]), "b": np.array(["a", {}], dtype=object)}, ("slip", "flight"))
    with pytest.raises((TypeError, ValueError)):
        words.save(place)
    assert place.read_bytes() == before
    if suffix == ".npz":
        with pytest.raises(ValueError, match="allow_pickle=False"):
            Samples(SAMPLES.columns, ("slip", None)).save(place)  # type: ignore[arg-type]
        assert place.read_bytes() == before
        with np.load(place, allow_pickle=False) as found:
            assert set(found.files) == {"t", "b", "phase"}
    else:
        with pytest.raises(ValueError, match="shorter"):
            Samples(SAMPLES.columns, ("slip",)).save(place)
        assert place.read_bytes() == before


def test_a_column_may_have_any_name(tmp_path: Path) -> None:
    """Also that of an argument of NumPy's."""
    words = ("file", "allow_pickle", "args", "kwds")
    made = Samples({name: np.array([float(i)]) for i, name in enumerate(words)}, ("slip",))
    with np.load(made.save(tmp_path / "run.npz"), allow_pickle=False) as found:
        assert {name: found[name].tolist() for name in words} == {name: [float(i)] for i, name in enumerate(words)}
        assert found["phase"].tolist() == ["slip"]


def test_the_rights_are_those_of_a_file_made_by_open(tmp_path: Path) -> None:
    before = os.umask(0o026)
    try:
        made = SAMPLES.save(tmp_path / "run.csv")
        (tmp_path / "opened").write_text("")
        assert os.umask(0o026) == 0o026
    finally:
        os.umask(before)
    assert made.stat().st_mode & 0o777 == (tmp_path / "opened").stat().st_mode & 0o777 == 0o640


def test_an_interruption_just_after_the_file_is_in_its_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is passed on, and no error about the part that is gone hides it."""
    put = os.replace

    def interrupted(*given: Any) -> None:
        put(*given)
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        SAMPLES.save(tmp_path / "run.csv")
    assert [path.name for path in tmp_path.iterdir()] == ["run.csv"]


@pytest.mark.parametrize("suffix", [".csv", ".npz"])
def test_a_full_disk_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / f"run{suffix}"
    place.write_text("old")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        SAMPLES.save(place)
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [(place.name, "old")]


KILLED = """
import os, signal, sys
from pathlib import Path
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.work.journal_file import JournalFile

add = JournalFile.add

def add_and_die(journal, data):
    add(journal, data)
    if len(journal.lines) == 9:
        os.kill(os.getpid(), signal.SIGKILL)

JournalFile.add = add_and_die
float_run(load_scene("fig-varsim1"), journal=Path(sys.argv[1]))
"""


def test_a_run_that_was_killed_goes_on_to_the_result_of_one_with_a_journal(tmp_path: Path) -> None:
    """It kills itself after a number of lines: a second process could come too late on a loaded machine."""
    journal = tmp_path / "run.journal"
    killed = subprocess.run([sys.executable, "-c", KILLED, str(journal)], check=False)
    assert killed.returncode == -signal.SIGKILL
    before = journal.read_bytes().count(b"\n")
    assert before == 10  # the header as well
    journal.write_bytes(journal.read_bytes() + b'{"phase": "sl')  # a line that the kill cut short
    scene = load_scene("fig-varsim1")
    resumed, whole = float_run(scene, journal=journal), float_run(scene, journal=tmp_path / "whole.journal")
    assert resumed.events == whole.events
    assert resumed.samples is not None
    assert whole.samples is not None
    assert resumed.samples.phases == whole.samples.phases
    for name, column in whole.samples.columns.items():
        assert resumed.samples.columns[name].tolist() == column.tolist()
    assert float_run(scene, journal=journal).events == whole.events
    uncut = float_run(scene)  # other steps: equal within the tolerance only
    assert [event.name for event in uncut.events] == [event.name for event in whole.events]
    for one, other in zip(uncut.events, whole.events, strict=True):
        assert approximate(one.lower) == pytest.approx(approximate(other.lower), abs=1e-6)


def test_the_solver_starts_once_for_each_phase_without_a_journal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[str] = []
    integrate = FloatPhase.integrate

    def counted(compiled: FloatPhase, *asked: Any) -> Any:
        calls.append(compiled.phase)
        return integrate(compiled, *asked)

    monkeypatch.setattr(FloatPhase, "integrate", counted)
    scene = load_scene("fig-varsim1")
    run = float_run(scene)
    assert len(calls) == len(run.events) == 3
    calls.clear()
    float_run(scene, journal=tmp_path / "run.journal")
    assert len(calls) > 20


def test_a_journal_is_of_one_run(tmp_path: Path) -> None:
    journal = tmp_path / "run.journal"
    float_run(load_scene("fig-varsim1", until="1/100", epsilon="1/50"), journal=journal)
    for other in ({"until": "1/99", "eps": "1/50"}, {"until": "1/100", "eps": "1/51"}):
        with pytest.raises(ValueError, match="is not a journal of this question"):
            float_run(load_scene("fig-varsim1", **other), journal=journal)
    lines = journal.read_text().splitlines()
    for change in ({"rows": "x"}, {"rows": [[float("nan")]]}, {"surprise": 1}):
        bad = json.dumps({**json.loads(lines[1]), **change})
        journal.write_text("\n".join([lines[0], bad]) + "\n")
        with pytest.raises(ValueError, match="a line of the journal cannot be read"):
            float_run(load_scene("fig-varsim1", until="1/100", epsilon="1/50"), journal=journal)
