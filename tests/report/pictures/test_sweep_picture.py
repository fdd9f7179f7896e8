"""Pictures of sweeps: every format, deterministic, whole or not at all; every kind of piece has a look."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_piece import Kind
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.report.pictures.sweep_picture import caption, fates_caption, look, save_sweep

BEGINNINGS = {".png": b"\x89PNG", ".pdf": b"%PDF", ".svg": b"<?xml"}


@pytest.fixture(scope="module")
def line() -> Sweep:
    return sweep(shipped_mechanism("genot_brogliato_rod"), {"mu": "1.3..1.6:6"})


@pytest.mark.parametrize("suffix", [".png", ".pdf", ".svg", ".PNG"])
def test_formats(line: Sweep, tmp_path: Path, suffix: str) -> None:
    found = []
    for name in ("first", "second"):
        path = save_sweep(line, tmp_path / f"{name}{suffix}")
        found.append(path.read_bytes())
    assert found[0].startswith(BEGINNINGS[suffix.lower()])
    assert found[0] == found[1]
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"first{suffix}", f"second{suffix}"]


def test_another_suffix_is_refused_and_nothing_is_written(line: Sweep, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"\.png, \.pdf, \.svg"):
        save_sweep(line, tmp_path / "picture.gif")
    assert list(tmp_path.iterdir()) == []


def test_the_legend_says_what_there_is(line: Sweep, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from matplotlib.axes import Axes

    labels: list[str] = []
    own = Axes.legend

    def legend(self: Axes, *arguments: object, **options: object) -> object:
        handles = options["handles"]
        assert isinstance(handles, list)
        labels.extend(handle.get_label() for handle in handles)
        return own(self, *arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(Axes, "legend", legend)
    save_sweep(line, tmp_path / "line.svg")
    assert labels == ["beyond a fold", "next to a fold", "no Case", "Case or side may change", "Case II"]


def test_a_map_and_pieces_that_are_left(tmp_path: Path) -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "7/4..9/4:2", "kappa": "0..1:2"})
    whole = save_sweep(result, tmp_path / "whole.svg").read_bytes()
    first = replace(result.pieces[0], kind=Kind.OPEN, case=None, lift_off_sign=None, impact_sign=None, unsure=("x",))
    undecided = replace(result, pieces=(first, *result.pieces[1:]))
    assert save_sweep(undecided, tmp_path / "left.svg").read_bytes() != whole


def test_no_change_is_claimed_where_a_zero_is_not_shown(line: Sweep) -> None:
    """Of two parameters a quantity may pass 0 on a piece; of one it does so in a bracket at most once."""
    assert "Dotted: where Case or side may change (1)." in caption(line)


def test_the_caption_of_fates_has_the_condition_on_the_starts() -> None:
    """Theorem R is about starts at rest in the contact; the text of the sweep says so, too."""
    found = fates(shipped_mechanism("model system"), {"x": 0, "u": 5}, {"p": "1/2..3/5:1", "b": "-3..-2:1"})
    assert found.sides.below is not None
    assert "for starts at rest in the contact" in str(found)
    assert "What follows the G-spot: for starts at rest in the contact, and epsilon below" in fates_caption(found)


def test_the_caption_and_the_legend_of_a_contact_without_a_damper(line: Sweep) -> None:
    """No side is named, of which G-spot is said."""
    pieces = tuple(replace(each, lift_off_sign=None, impact_sign=None) for each in line.pieces)
    undamped = replace(line, pieces=pieces, fixed=("X", "X_dot"))
    assert ": Case of the continued G-spot with X, X_dot fixed. Certified: on each of the " in caption(undamped)
    settled = next(each for each in pieces if each.kind is Kind.SETTLED and each.case == "II")
    labels = [look(replace(settled, case=case))[1] for case in ("I", "II", "III")]
    assert labels == [f"Case {case}, no side: no damper" for case in ("I", "II", "III")]


def test_the_caption_says_whose_rule_the_side_is(line: Sweep) -> None:
    """What is certified is the Case and the sign of Gamma(-beta)."""
    pieces = tuple(replace(piece, case="III", lift_off_sign=1, impact_sign=-1) for piece in line.pieces)
    assert "Which sign of C₁ lifts off: by the paper's rule as ε → 0." in caption(replace(line, pieces=pieces))
    assert "lifts off" not in caption(line)
