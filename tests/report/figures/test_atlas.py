import io
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from flint import fmpq
from matplotlib import image

from gspot_verified.report.figures.atlas import atlas_picture, save_atlas
from gspot_verified.report.figures.atlas_data import Area, Colour, areas, entries, folds, zero_curves
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.signs.cover.witness import sign_at
from gspot_verified.signs.zeros.zeros import ZerosResult, zeros_on_range

ZERO, HALF, ONE = fmpq(0), fmpq(1, 2), fmpq(1)
FIRST, LAST = fmpq(9, 4), fmpq(5, 2)
LEFT = ColumnPiece(Kind.LEFT, None, -ONE)


@pytest.fixture(scope="module")
def result() -> ZerosResult:
    return zeros_on_range("2..7/2")


def column(*pieces: ColumnPiece, lower: fmpq = FIRST, upper: fmpq = LAST) -> Column:
    return Column(lower, upper, pieces)


def test_colours_are_those_of_the_signs() -> None:
    pieces = (
        LEFT,
        ColumnPiece(Kind.SIGN, -ONE, ZERO, -1),
        ColumnPiece(Kind.SIGN, ZERO, ONE, 1),
        ColumnPiece(Kind.RIGHT, ONE, None, 0),
    )
    found = [(area.colour, area.left, area.right) for area in areas(column(*pieces))]
    # dTheta/dtau = -beta F; beta - 1 in (1, 2): F > 0 beyond the last piece.
    assert found == [
        (Colour.NEGATIVE, None, -ONE),
        (Colour.POSITIVE, -ONE, ZERO),
        (Colour.NEGATIVE, ZERO, None),
    ]


@pytest.mark.parametrize(("m", "colour"), [(1, Colour.POSITIVE), (2, Colour.NEGATIVE), (3, Colour.POSITIVE)])
def test_the_sign_at_infinity_alternates(m: int, colour: Colour) -> None:
    last = areas(column(LEFT, ColumnPiece(Kind.RIGHT, ONE, None, 0), lower=fmpq(m), upper=m + HALF))[-1]
    assert (last.colour, last.left, last.right) == (colour, ONE, None)
    assert sign_at(fmpq(40), m + HALF) == (1 if colour is Colour.POSITIVE else -1)


def test_a_monotone_run_is_a_tube_or_keeps_the_sign() -> None:
    run = (ColumnPiece(Kind.MONOTONE, -ONE, ZERO, -1), ColumnPiece(Kind.MONOTONE, ZERO, HALF, -1))
    across = areas(column(LEFT, *run, ColumnPiece(Kind.SIGN, HALF, ONE, -1), ColumnPiece(Kind.RIGHT, ONE, None, 1)))
    assert Area(Colour.ONE_ZERO, -ONE, HALF, fmpq(9, 4), fmpq(5, 2)) in across
    within = areas(column(LEFT, *run, ColumnPiece(Kind.SIGN, HALF, ONE, 1)))
    assert [(area.colour, area.left, area.right) for area in within] == [(Colour.NEGATIVE, None, ONE)]


def test_what_is_not_settled_is_blank() -> None:
    open_tail = areas(column(LEFT, ColumnPiece(Kind.SIGN, -ONE, ONE, 1), ColumnPiece(Kind.RIGHT, ONE, None, 1)))
    assert all(area.right is not None and area.right <= 1 for area in open_tail)
    no_end = areas(column(LEFT, ColumnPiece(Kind.MONOTONE, -ONE, ONE, 1)))
    assert [area.right for area in no_end] == [-ONE]


def test_the_fold_holds_two_zeros_below_its_integer_only() -> None:
    fold = ColumnPiece(Kind.FOLD, -HALF, HALF)
    below = areas(column(LEFT, fold, lower=fmpq(5, 2), upper=fmpq(3)))
    above = areas(column(LEFT, fold, lower=fmpq(3), upper=fmpq(7, 2)))
    assert [area.colour for area in below] == [Colour.NEGATIVE, Colour.TWO_ZEROS]
    assert {area.colour for area in above} == {Colour.NEGATIVE}


def test_below_one_everything_is_negative() -> None:
    whole = ColumnPiece(Kind.LAPLACE, None, None)
    assert areas(Column(ZERO, ONE, (whole,))) == [Area(Colour.NEGATIVE, None, None, ZERO, ONE)]
    assert areas(Column(None, -ONE, (whole,))) == [Area(Colour.POSITIVE, None, None, None, -ONE)]


def test_certified_columns_agree_with_values(result: ZerosResult) -> None:
    wanted = {Colour.NEGATIVE: -1, Colour.POSITIVE: 1}
    checked = 0
    for area in (area for column in result.columns for area in areas(column) if area.colour in wanted):
        assert area.lower is not None
        tau = (area.left + area.right) / 2 if area.left is not None and area.right is not None else None
        tau = tau if tau is not None else area.right - 1 if area.right is not None else area.left + 1
        assert sign_at(tau, (2 * area.lower + area.upper) / 3) == wanted[area.colour]
        checked += 1
    assert checked > 10


def test_areas_of_a_column_do_not_overlap(result: ZerosResult) -> None:
    for settled in result.columns:
        found = areas(settled)
        for area, following in pairwise(found):
            assert area.right is not None
            assert following.left is not None
            assert area.right <= following.left


def test_curves_lie_in_their_tubes(result: ZerosResult) -> None:
    for settled in result.columns:
        curves = zero_curves(settled, fmpq(6))
        assert len(curves) >= len(settled.tubes())
        for curve, (left, right) in zip(curves, settled.tubes(), strict=False):
            assert all(left <= fmpq(round(tau * 2**20), 2**20) <= right for tau, _ in curve)
        for tau, beta in (point for curve in curves for point in curve[1:-1]):
            exact_beta, near = fmpq(round(beta * 2**60), 2**60), fmpq(round(tau * 2**20), 2**20)
            if exact_beta.q > 1 and near:
                width = fmpq(1, 2_000)
                assert sign_at(near - width, exact_beta) != sign_at(near + width, exact_beta)


def test_folds_and_entries(result: ZerosResult) -> None:
    assert folds(result.columns) == [3]
    assert entries(result.columns) == [2, 3]


def test_the_picture_is_written_and_not_empty(result: ZerosResult, tmp_path) -> None:
    path = save_atlas(result, tmp_path / "atlas.png")
    assert [item.name for item in tmp_path.iterdir()] == ["atlas.png"]
    pixels = image.imread(io.BytesIO(path.read_bytes()))
    colours, counts = np.unique(
        (pixels * 255).round().astype(int).reshape(-1, pixels.shape[2]), axis=0, return_counts=True
    )
    assert pixels.shape[1] > 1000
    assert (counts > 0.01 * counts.sum()).sum() >= 4  # paper, two signs, tubes
    assert len(colours) > 50


def test_the_caption_says_what_is_left_open(result: ZerosResult) -> None:
    whole = atlas_picture(result).caption
    assert "Certified: the colours" in whole
    assert "is not an integer, and that each is simple" in whole
    part = replace(result, columns=result.columns[:-1], unfinished=((fmpq(10, 3), fmpq(7, 2)),), statement=None)
    caption = atlas_picture(part).caption
    assert "not settled (ranges of β: 1)" in caption
    assert "number of zeros" not in caption


def test_nothing_to_draw() -> None:
    nothing = zeros_on_range("2..3", budget=0)
    with pytest.raises(ValueError, match="no settled range"):
        atlas_picture(nothing)
    with pytest.raises(ValueError, match="not one value"):
        atlas_picture(zeros_on_range("5/2"))
