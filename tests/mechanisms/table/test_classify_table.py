"""Each row of a table says what ``classify`` says of that mechanism alone; page: proofs/sweep.md, sections 1 to 4."""

from __future__ import annotations

import random
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from importlib import resources
from pathlib import Path

import pytest
from flint import arb

from gspot_verified import GSpotError, MechanismError, classify, load
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.mechanisms.table import classify_table as module
from gspot_verified.mechanisms.table.classified_row import ClassifiedRow
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.numbers.balls import ball, working_bits

ROD = load("genot_brogliato_rod")


def rods(count: int, seed: int = 5) -> list[dict[str, str]]:
    dice = random.Random(seed)
    return [
        {"mu": f"{dice.randrange(1340, 3000)}/1000", **{word: f"{dice.randrange(200, 3000)}/1000" for word in "mLg"}}
        for _ in range(count)
    ]


def agrees(row: ClassifiedRow, name: str, **values: str) -> None:
    """The same by the other route: derived anew with the numbers put in, its own search and its own box."""
    alone = classify(load(name, **values))
    assert (row.case, row.lift_off_sign, row.impact_sign) == (alone.case, alone.lift_off_sign, alone.impact_sign)
    with working_bits(60):
        for word, value in (("alpha_1", alone.alpha_1), ("beta", alone.beta), ("slip_velocity", alone.slip_velocity)):
            own = dict(row.numbers)[word]
            assert own is not None
            assert value is not None
            assert own.to_ball().rad() < arb("1e-15")
            assert own.to_ball().overlaps(ball(value))


def test_a_row_says_what_classify_says() -> None:
    rows = rods(12)
    found = list(classify_table(ROD, rows))
    assert [row.number for row in found] == list(range(1, 13))
    assert {row.outcome for row in found} == {"settled"}
    assert len({row.case for row in found}) > 1
    for row, values in zip(found, rows, strict=True):
        agrees(row, "genot_brogliato_rod", **values)


def test_without_a_damper_a_row_names_no_side() -> None:
    undamped = replace(ROD, regularisation=Regularisation.of(1, 1, 0))
    (row,) = classify_table(undamped, rods(1))
    (damped,) = classify_table(ROD, rods(1))
    assert (row.outcome, row.case, row.numbers) == ("settled", damped.case, damped.numbers)
    assert damped.impact_sign is not None
    assert (row.lift_off_sign, row.impact_sign) == (None, None)
    assert (row.reason, damped.reason) == ("no side: the contact has no damper (c = 0): nothing is damped", "")


def test_both_sides_of_an_integer_and_what_is_between() -> None:
    """β is the parameter of the oscillator: C_1 changes its side at 2, and at 2 itself the row says that it is open."""
    table = [{"beta": value} for value in ("3/2", "1999999999/1000000000", "2", "2.000000001", "7/2", "5/2")]
    found = list(classify_table(load("oscillator"), table))
    for row, values in zip(found, table, strict=True):
        if values["beta"] != "2":
            assert row.outcome == "settled"
            agrees(row, "oscillator", **values)
    assert [row.lift_off_sign for row in found] == [-1, -1, None, 1, None, 1]
    assert (found[2].outcome, found[2].case) == ("undecided", "III")
    assert found[2].reason == "not certain: the sign of beta - 2"


def test_nothing_is_said_where_a_hypothesis_is_not_certain(tmp_path: Path) -> None:
    """The fields of the model with A < 0 in the place of A > 0 are those of no mechanism: there is no Case."""
    text = (resources.files("gspot_verified.mechanisms.data") / "model_system.toml").read_text(encoding="utf-8")
    text = text.replace("[parameters]", "[parameters]\nk = 1").replace('"3/(2*(1 - p))"', '"k*3/(2*(1 - p))"')
    file = tmp_path / "fields.toml"
    file.write_text(text.replace('fixed = ["x", "u"]', 'fixed = ["x", "u"]\nsearch = true'), encoding="utf-8")
    right, wrong = classify_table(load(str(file)), [{"k": "1"}, {"k": "-1"}])
    assert (right.outcome, right.case, right.lift_off_sign, right.impact_sign) == ("settled", "III", -1, 1)
    assert (wrong.outcome, wrong.case, wrong.lift_off_sign, wrong.impact_sign) == ("undecided", None, None, None)
    assert wrong.reason == "not certain: the mass matrix is positive definite"
    assert wrong.summary == "undecided"


def test_angles_that_are_counted_from_a_reference() -> None:
    rod = load("rod")
    (row,) = classify_table(rod, [{"mu": dict(rod.parameters)["mu"].value}])  # type: ignore[union-attr]
    agrees(row, "rod")
    with working_bits(60):
        (angle,) = rod.angles
        theta = dict(row.point)["theta"]
        assert theta is not None
        assert theta.to_ball().sin().overlaps(arb(angle.sine))
        (other,) = classify_table(rod, [{"mu": "8/5"}])
        height, turned = (dict(other.point)[word] for word in ("Y", "theta"))
        assert height is not None
        assert turned is not None
        assert turned.to_ball().sin().overlaps(height.to_ball())  # l = 1: the tip is on the ground
        assert not turned.to_ball().overlaps(theta.to_ball())


def test_a_row_that_is_wrong_is_refused_alone() -> None:
    """Before what load refuses: a mass or a friction below 0. Where there is no G-spot (μ < 4/3) that is said."""
    table = [{"mu": "8/5", "m": 1}, {"mu": -1, "m": 1}, {"mu": 2, "m": "-1"}, {"mu": "x", "m": 1}, {"mu": 1, "m": 1}]
    found = list(classify_table(ROD, table))
    assert [row.outcome for row in found] == ["settled", "refused", "refused", "refused", "undecided"]
    assert "the friction coefficient mu is -1" in found[1].reason
    assert "the mass m is -1" in found[2].reason
    assert "mu: expected a number" in found[3].reason
    assert found[4].reason == "no G-spot was found from the place that the mechanism names"
    assert all(number is None for row in found[1:] for _, number in (*row.numbers, *row.point))


@pytest.mark.parametrize("values", [{"mu": "1e300", "L": "1e-300"}, {"mu": "1e-9", "L": 1}, {"mu": 2, "L": 0}])
def test_absurd_values_settle_nothing(values: dict[str, str | int]) -> None:
    (row,) = classify_table(ROD, [values])
    assert row.outcome != "settled"
    assert row.reason


def test_the_same_for_every_executor_and_after_a_kill(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The journal's lines are proved again; those of another table are not believed."""
    monkeypatch.setattr(module, "_PORTION", 3)
    rows = [*rods(7), {"mu": "1", "m": "1", "L": "1", "g": "1"}]
    expected = list(classify_table(ROD, rows))
    path = tmp_path / "journal"
    assert list(classify_table(ROD, rows, journal=path)) == expected
    whole = path.read_bytes()
    assert whole.count(b"\n") == 4
    path.write_bytes(whole[:-20])
    done: list[int] = []
    asked: list[int] = []
    with ThreadPoolExecutor(1, initializer=asked.append, initargs=(1,)) as pool:
        assert list(classify_table(ROD, rows, journal=path, executor=pool, progress=done.append)) == expected
    assert done == [3, 6, 8]
    assert asked
    assert path.read_bytes() == whole
    other = rods(7, seed=6)
    found = list(classify_table(ROD, other))
    assert list(classify_table(ROD, other, journal=path)) == found
    with monkeypatch.context() as patch:
        patch.setattr(module, "searched", lambda *_: pytest.fail("the tubes of the other table are known now"))
        assert list(classify_table(ROD, other, journal=path)) == found
    with pytest.raises(ValueError, match="not a journal of this question"):
        classify_table(ROD, [{"mu": 2}], journal=path)


def test_a_recalled_tube_of_another_spot_is_not_the_rows(tmp_path: Path) -> None:
    """The rod's mirrored G-spot is of no Case; its journal under this question's first line changes nothing."""
    rod, rows = load("genot_brogliato_rod"), [{"mu": 2}, {"mu": "9/4"}]
    expected = list(classify_table(rod, rows, journal=tmp_path / "own"))
    assert {row.case for row in expected} == {"II"}
    there = {word: -value if word in ("Y_dot", "theta_dot") else value for word, value in rod.place.values}
    mirrored = replace(rod, place=replace(rod.place, values=tuple(there.items())))
    assert {row.case for row in classify_table(mirrored, rows, journal=tmp_path / "other")} == {"none"}
    first, other = ((tmp_path / name).read_text().splitlines() for name in ("own", "other"))
    (tmp_path / "forged").write_text(f"{first[0]}\n{other[1]}\n")
    assert list(classify_table(rod, rows, journal=tmp_path / "forged")) == expected


def test_known_tubes_save_the_search(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "journal"
    expected = list(classify_table(ROD, rods(2), journal=path))
    monkeypatch.setattr(module, "searched", lambda *_: pytest.fail("the tube was known"))
    assert list(classify_table(ROD, rods(2), journal=path)) == expected


def test_rows_are_taken_as_they_are_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PORTION", 2)
    taken: list[int] = []

    def endless() -> Iterator[dict[str, str]]:
        while True:
            taken.append(1)
            yield {"mu": "8/5"}

    found = classify_table(ROD, endless())
    assert [next(found).number for _ in range(3)] == [1, 2, 3]
    assert len(taken) == 4


def test_a_mechanism_that_has_no_g_spot_or_is_none() -> None:
    with pytest.raises(MechanismError, match="has no parameter 'nu'"):
        classify_table(ROD, [{"nu": 1}])
    with pytest.raises(GSpotError):
        classify_table(load("genot_brogliato_rod", mu="1/2"), [{"mu": 2}])
    with pytest.raises(TypeError, match="expected a mechanism"):
        classify_table("rod", [{"mu": 2}])  # type: ignore[arg-type]
