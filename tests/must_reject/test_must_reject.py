"""Every bad certificate is rejected, each kind of fault with its own message; the good ones are accepted."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from must_reject import mutate
from must_reject.mutate import (
    GOOD,
    HYPOTHESES,
    Mutation,
    column_ends,
    drop_column,
    drop_piece,
    head,
    move_column_end,
    move_end,
    put_piece,
    put_pieces,
    sealed,
    state,
    swap_columns,
    text_of,
)

check = mutate.checker()
TINY = Fraction(1, 10**30)
DEEP = b"[" * 100_000 + b"]" * 100_000
LONG = 10**4000

CONTENT: list[tuple[str, str, Mutation, str]] = [
    # Cover.
    ("dropped last column", "iwc", drop_column(2), "the columns do not cover the whole range"),
    ("dropped first column", "iwc", drop_column(1), "the columns do not cover the whole range"),
    ("no column", "iwc by theorem", drop_column(1), "the columns do not cover the whole range"),
    ("dropped piece", "iwc", drop_piece(1, 1), "a gap between pieces"),
    ("dropped first piece", "iwc", drop_piece(1, 0), "the pieces do not cover the whole range"),
    ("dropped last piece", "iwc", drop_piece(2, 2), "the pieces do not cover the whole range"),
    ("gap of pieces", "iwc", move_end(1, 1, 2, -TINY), "a gap between pieces"),
    ("overlap of pieces", "iwc", move_end(1, 1, 2, TINY), "an overlap of pieces"),
    ("gap of columns", "iwc", move_column_end(1, 1, -TINY), "a gap between columns"),
    ("overlap of columns", "iwc", move_column_end(2, 0, -TINY), "an overlap of columns"),
    ("columns start late", "iwc", move_column_end(1, 0, TINY), "the columns do not cover the whole range"),
    ("columns swapped", "iwc", swap_columns(1, 2), "an overlap of columns"),
    ("no pieces", "iwc", put_pieces(1), "the pieces do not cover the whole range"),
    ("column outside", "right", state(beta="[1, 5/4)"), "the columns do not cover the whole range"),
    ("column beyond", "negative beta", state(beta="(-inf, -3)"), "one of the columns lies outside the range"),
    ("single point", "iwc", lambda lines: lines.insert(2, {"beta": ["1/2"] * 2, "pieces": [["laplace"]]}), "point"),
    (
        "single point at the end",
        "iwc",
        lambda lines: lines.append({"beta": ["1", "1"], "pieces": [["laplace"]]}),
        "point",
    ),
    (
        "single point at the start",
        "iwc",
        lambda lines: lines.insert(1, {"beta": ["0", "0"], "pieces": [["laplace"]]}),
        "point",
    ),
    (
        "columns before the range",
        "iwc",
        lambda lines: lines.__setitem__(
            slice(1, 1), [{"beta": [low, high], "pieces": [["laplace"]]} for low, high in (("-2", "-1"), ("-1", "0"))]
        ),
        "one of the columns lies outside the range",
    ),
    # Shape.
    ("crosses an integer", "right", column_ends(1, "3/4", "3/2"), "crosses an integer"),
    ("column reversed", "right", column_ends(1, "3/2", "5/4"), "ends before it begins"),
    ("-inf with numbers", "iwc", column_ends(1, "-inf", "1/2"), "is not the piece laplace alone"),
    ("unbounded above", "negative beta", state(beta="(-inf, inf)"), "the range of β holds 0"),
    ("unknown piece", "iwc", put_piece(1, 3, "tailor"), "unknown piece ['tailor']"),
    ("piece is a number", "iwc", put_piece(1, 3, 7), "unknown piece [7]"),
    ("piece is no list", "iwc", lambda lines: lines[1]["pieces"].__setitem__(3, "taylor"), "unknown piece 'taylor'"),
    ("too few arguments", "iwc", put_piece(1, 1, "sign", "-4/3", "-1/2"), "a piece sign has 2 arguments"),
    ("too many arguments", "iwc", put_piece(1, 3, "taylor", 1), "a piece taylor has 1 arguments"),
    ("swapped ends", "iwc", put_piece(1, 1, "sign", "-1/2", "-4/3", 1), "does not go from left to right"),
    ("empty piece", "iwc", put_piece(1, 1, "sign", "-4/3", "-4/3", 1), "does not go from left to right"),
    ("sign 2", "iwc", put_piece(1, 1, "sign", "-4/3", "-1/2", 2), "the last entry of a piece sign is 2"),
    ("sign true", "iwc", put_piece(1, 1, "sign", "-4/3", "-1/2", True), "the last entry of a piece sign is True"),
    ("sign as text", "iwc", put_piece(1, 1, "sign", "-4/3", "-1/2", "1"), "the last entry of a piece sign is '1'"),
    ("v = 2", "right", put_piece(1, 0, "right", "4", 2), "the last entry of a piece right is 2"),
    ("end as a number", "iwc", put_piece(1, 0, "left", -2), "-2 is not a rational number as text"),
    ("not in lowest terms", "iwc", put_piece(1, 0, "left", "-8/6"), "'-8/6' is not in lowest terms"),
    ("denominator 1", "iwc", put_piece(1, 0, "left", "-2/1"), "'-2/1' is not in lowest terms"),
    ("minus zero", "iwc", put_piece(1, 0, "left", "-0"), "'-0' is not in lowest terms"),
    ("zero denominator", "iwc", put_piece(1, 0, "left", "-1/0"), "is not a rational number as text"),
    ("decimal text", "iwc", put_piece(1, 0, "left", "-1.5"), "'-1.5' is not a rational number as text"),
    ("exponent text", "iwc", put_piece(1, 0, "left", "-1e1000000000"), "is not a rational number as text"),
    ("underscore", "iwc", put_piece(1, 0, "left", "-1_0"), "'-1_0' is not a rational number as text"),
    ("other digits", "iwc", put_piece(1, 0, "left", "-\u0662"), "is not a rational number as text"),
    ("line feed in text", "iwc", put_piece(1, 0, "left", "-2\n"), "is not a rational number as text"),
    ("leading zero", "iwc", put_piece(1, 0, "left", "-02"), "'-02' is not a rational number as text"),
    ("plus sign", "iwc", put_piece(1, 0, "left", "+2"), "'+2' is not a rational number as text"),
    ("long rational", "iwc", put_piece(1, 0, "left", f"-1{'0' * 4000}"), "of at most 4000 digits"),
    ("other keys", "iwc", lambda lines: lines[1].update(note=""), "a column has not the keys beta, pieces"),
    ("column is a list", "iwc", lambda lines: lines.__setitem__(1, []), "a column has not the keys beta, pieces"),
    ("three ends", "iwc", column_ends(1, "0", "1/4", "1/2"), "a column has not its two lists"),
    # Header.
    ("unknown version", "iwc", head(version=8), "the version is 8"),
    ("version of the zeros at finite epsilon", "iwc", head(version=3), "the hypotheses are not the pages"),
    ("version of the force", "iwc", head(version=2), "the hypotheses are not the pages"),
    ("version true", "iwc", head(version=True), "the version is True"),
    ("unknown format", "iwc", head(format="certificate"), "the format is 'certificate'"),
    ("fewer hypotheses", "iwc", head(hypotheses=HYPOTHESES[1:]), "the hypotheses are not the pages"),
    ("more hypotheses", "iwc", head(hypotheses=[*HYPOTHESES, "riemann"]), "the hypotheses are not the pages"),
    ("unknown kind", "iwc", state(kind="signs"), "unknown kind of statement"),
    ("kind is a list", "iwc", state(kind=["sign"]), "unknown kind of statement"),
    ("statement is text", "iwc", head(statement="sign"), "unknown kind of statement"),
    ("more in the header", "iwc", head(note=""), "the header has not the keys"),
    ("more in the statement", "iwc", state(note=""), "the statement has not the keys"),
    # Statements about a sign.
    ("other sign", "iwc", state(sign=1), "gives dΘ/dτ the sign -1, not 1"),
    ("sign zero", "iwc", state(sign=0), "the sign 0 is possible at one point"),
    ("wider beta", "iwc", state(beta="(0, 2)"), "the columns do not cover the whole range"),
    ("closed at beta = 0", "iwc", state(beta="[0, 1)"), "the range of β holds 0"),
    ("beta around 0", "negative beta", state(beta="(-inf, 1)"), "the range of β holds 0"),
    ("negative beta, other sign", "negative beta", state(sign=-1), "gives dΘ/dτ the sign 1, not -1"),
    ("wider tau", "hinge", state(tau="(-inf, 1)"), "the pieces do not cover the whole range"),
    ("hinge closed at 0", "hinge", state(tau="(-inf, 0]", beta="(1, 2]"), "τ = 0 is a zero in a piece hinge"),
    ("range reversed", "iwc", state(beta="(1, 0)"), "the range '(1, 0)' is empty"),
    ("closed range reversed", "iwc", state(beta="[1, 0]"), "the range '[1, 0]' is empty"),
    ("range empty", "iwc", state(beta="(1, 1]"), "the range '(1, 1]' is empty"),
    ("closed at infinity", "iwc", state(tau="[-inf, inf)"), "is closed at infinity"),
    ("closed at plus infinity", "iwc", state(tau="(-inf, inf]"), "is closed at infinity"),
    ("no range", "iwc", state(tau="(-inf,inf)"), "'(-inf,inf)' is not a range"),
    ("range is a number", "iwc", state(tau=1), "1 is not a range"),
    ("tau holds the fold", "fold sign", state(beta="[3, 49/16]"), "τ = 0 is a zero in a piece fold"),
    ("integer, other sign", "integer", state(sign=1), "the sign at this integer β is -1, not 1"),
    ("integer, zero", "integer", state(sign=0), "the sign at this integer β is -1, not 0"),
    ("zero, other sign", "zero", state(sign=-1), "the sign at this integer β is 0, not -1"),
    ("zero elsewhere", "zero", state(tau="[1, 1]"), "the sign at this integer β is -1, not 0"),
    ("zero, no integer", "zero", state(beta="[5/2, 5/2]"), "the sign 0 is possible at one point"),
    ("integer with a column", "zero", lambda lines: lines.append(GOOD["right"][1]), "there is no column"),
    # Pieces.
    ("flipped sign", "iwc", put_piece(1, 1, "sign", "-4/3", "-1/2", -1), "the sign is 1, not -1"),
    ("left too far right", "iwc", put_pieces(2, ["left", "-3/4"], ["sign", "-3/4", "0", 1], ["taylor"]), "too large"),
    ("left at the limit", "iwc", put_pieces(2, ["left", "-7/9"], ["sign", "-7/9", "0", 1], ["taylor"]), "too large"),
    ("left not negative", "right", put_pieces(1, ["left", "5"], ["right", "5", 0]), "too large"),
    ("laplace beyond", "right", put_pieces(1, ["laplace"]), "needs b ≤ 0"),
    ("taylor beyond", "right", put_pieces(1, ["taylor"]), "needs b ≤ 0"),
    ("monotone in a sign", "hinge", put_piece(2, 2, "monotone", "-1/2", "0", -1), "a piece monotone gives no sign"),
    ("right with a zero", "right", put_piece(1, 0, "right", "4", 1), "a piece right gives no sign"),
    ("right for b <= 0", "iwc", put_piece(1, 3, "right", "0", 0), "is not allowed for b ≤ 0"),
    ("right for b = 0", "iwc", put_piece(2, 2, "right", "0", 0), "is not allowed for b ≤ 0"),
    ("right too early", "right", put_pieces(1, ["sign", "3", "4", 1], ["right", "1", 0]), "an overlap of pieces"),
    ("hinge away from 0", "hinge", put_piece(2, 1, "hinge", "-3/4", "-1/2"), "does not begin or end at τ = 0"),
    ("hinge against F(0, b)", "hinge", lambda lines: _hinge_in_the_next_cell(lines), "F(0, b) has the other sign"),
    ("sign piece with a zero", "zeros", put_piece(2, 4, "sign", "2", "3", 1), "no sign is confirmed"),
    ("fold away from 3", "zeros", put_piece(1, 1, "fold", "-3/8", "0"), "is not around τ = 0 at β = 3, 6, 9"),
    ("fold with a zero in a sign", "fold sign", column_ends(1, "95/32", "3"), "cover"),
    (
        "fold too wide",
        "fold",
        put_pieces(2, ["left", "-3/8"], ["sign", "-3/8", "-1/4", 1], ["fold", "-1/4", "4"], ["right", "4", 1]),
        "a hypothesis of the fold is not confirmed",
    ),
    # Zeros.
    ("other count", "zeros", state(counts=[[1, 2]]), "1 zeros on the column from β = 1, not 2"),
    ("count missing", "fold", state(counts=[[2, 2]]), "counts does not list the cells"),
    ("cells swapped", "fold", state(counts=[[3, 1], [2, 2]]), "counts does not list the cells"),
    ("count true", "zeros", state(counts=[[1, True]]), "counts does not list the cells"),
    ("counts without fold", "fold", state(counts=[[2, 0], [3, 1]]), "2 zeros on the column from β = 95/32, not 0"),
    ("wider range", "zeros", state(beta="(1, 2)"), "the columns do not cover the whole range"),
    ("integers only", "zeros", state(beta="[1, 1]", counts=[]), "counts does not list the cells"),
    ("negative range", "zeros", state(beta="(-1, 1)"), "is claimed for β < 0"),
    ("flipped direction", "zeros", put_piece(2, 3, "monotone", "3/2", "2", 1), "the sign is -1, not 1"),
    ("v too large", "zeros", put_piece(2, 5, "right", "3", 1), "0 changes of sign, not 1"),
    ("v too small", "zeros", put_piece(1, 3, "right", "1/2", 0), "1 changes of sign, not 0"),
    ("right too early for v = 0", "zeros", put_piece(2, 5, "right", "5/2", 0), "an overlap of pieces"),
    ("hinge in zeros", "zeros", put_piece(1, 1, "hinge", "-3/8", "0"), "a piece hinge does not count zeros"),
    (
        "two directions",
        "brackets",
        put_pieces(
            1, ["left", "-1/2"], ["monotone", "-1/2", "0", -1], ["monotone", "0", "5/2", 1], ["right", "5/2", 0]
        ),
        "no sign is confirmed",
    ),
    (
        "monotone last",
        "zeros",
        put_pieces(1, ["monotone", "-3/8", "0", -1], ["right", "0", 1]),
        "the pieces do not cover the whole range",
    ),
    # Brackets.
    ("other beta", "brackets", state(beta="5/2"), "the columns do not cover the whole range"),
    ("integer beta", "brackets", state(beta="2"), "β is not positive, or it is an integer"),
    ("shrunk bracket", "brackets", state(brackets=[["-6/25", "-1/5"], ["2077/1000", "1039/500"]]), "does not change"),
    ("bracket dropped", "brackets", state(brackets=[["2077/1000", "1039/500"]]), "there are 2 zeros, not 1"),
    ("bracket added", "brackets", state(brackets=[["-1", "0"], ["0", "1"], ["1", "3"]]), "there are 2 zeros, not 3"),
    ("brackets swapped", "brackets", state(brackets=[["2", "5/2"], ["-1", "0"]]), "not in order or overlap"),
    ("brackets overlap", "brackets", state(brackets=[["-1", "1"], ["1/2", "3"]]), "not in order or overlap"),
    ("bracket reversed", "brackets", state(brackets=[["0", "-1"], ["2", "3"]]), "not in order or overlap"),
    ("bracket empty", "brackets", state(brackets=[["0", "0"], ["2", "3"]]), "not in order or overlap"),
    ("bracket is a number", "brackets", state(brackets=[["-1", "0"], 7]), "are not a list of pairs"),
    ("bracket of three", "brackets", state(brackets=[["0", "1", "2"]]), "are not a list of pairs"),
    # Range of the checker.
    ("beta too large", "right", lambda lines: _far(lines, "1000"), "the limit beta=200"),
    ("beta far too large", "right", lambda lines: _far(lines, str(LONG // 10)), "the limit beta=200"),
    ("tau too large", "right", put_pieces(1, ["sign", "4", "1000", 1], ["right", "1000", 0]), "the limit tau=200"),
]


def _far(lines: mutate.Lines, beta: str) -> None:
    lines[0]["statement"]["beta"] = f"[{beta}, {beta}]"
    lines[1]["beta"] = [beta, beta]


def _hinge_in_the_next_cell(lines: mutate.Lines) -> None:
    lines[0]["statement"].update(beta="(9/4, 5/2)", tau="[-1/4, 0)")
    lines[1:] = [{"beta": ["9/4", "5/2"], "pieces": [["hinge", "-1/4", "0"]]}]


def rejection(data: bytes) -> str:
    with pytest.raises(check.limits.Rejected) as caught:
        check.main.check_text(data)
    text = str(caught.value)
    assert "\n" not in text
    assert len(text) < 500
    return text


@pytest.mark.parametrize("name", GOOD)
def test_good_ones_are_accepted(name: str) -> None:
    assert check.main.check_text(text_of(GOOD[name]))


@pytest.mark.parametrize(("name", "good", "mutation", "message"), CONTENT, ids=[row[0] for row in CONTENT])
def test_content(name: str, good: str, mutation: Mutation, message: str) -> None:
    assert message in rejection(mutate.mutated(GOOD[good], mutation)), name


@pytest.mark.parametrize("shift", [Fraction(-1, 8), Fraction(1, 8), Fraction(1, 2), Fraction(1)])
def test_a_left_piece_beyond_its_threshold(shift: Fraction) -> None:
    """On β in [1/2, 1], b in [-1/2, 0]: x^3 > (1/2)(3/2)(5/2)/3, x > 0.855."""
    x = Fraction(-855, 1000) + shift
    pieces = [["left", str(x)], ["sign", str(x), "0" if x < 0 else "1", 1]]
    data = mutate.mutated(GOOD["iwc"], put_pieces(2, *pieces, *([["taylor"]] if x < 0 else [])))
    if shift < 0:
        assert check.main.check_text(data)
    else:
        assert "remainder is too large" in rejection(data) or "cover" in rejection(data)


BODY = text_of(GOOD["iwc"])[:-72]
HEADER, FIRST, SECOND, _ = BODY.split(b"\n")


def with_line(line: bytes) -> bytes:
    return sealed(b"\n".join([HEADER, line, SECOND, b""]))


TEXTS: list[tuple[str, bytes, str]] = [
    ("duplicate key", with_line(FIRST[:-1] + b',"pieces":[["laplace"]]}'), "a key occurs twice"),
    ("duplicate column range", with_line(b'{"beta":["0","1/2"],' + FIRST[1:]), "a key occurs twice"),
    ("NaN", with_line(b'{"beta":["0","1/2"],"pieces":NaN}'), "'NaN' is not an integer"),
    ("Infinity", with_line(b'{"beta":["0","1/2"],"pieces":-Infinity}'), "'-Infinity' is not an integer"),
    ("float", with_line(FIRST.replace(b",1]", b",1.0]")), "'1.0' is not an integer"),
    ("exponent", with_line(FIRST.replace(b",1]", b",1e0]")), "'1e0' is not an integer"),
    ("huge exponent", with_line(FIRST.replace(b",1]", b",1e1000000000]")), "'1e1000000000' is not an integer"),
    ("huge integer", with_line(FIRST.replace(b",1]", b"," + b"9" * 500_000 + b"]")), "at most 4000 digits"),
    ("integer of 4301 digits", with_line(FIRST.replace(b",1]", b"," + b"9" * 4301 + b"]")), "at most 4000 digits"),
    ("minus zero", with_line(FIRST.replace(b",1]", b",-0]")), "a line is not canonical JSON"),
    ("deep nesting", with_line(b'{"beta":["0","1/2"],"pieces":' + DEEP + b"}"), "JSON is nested too deeply"),
    ("deep objects", with_line(b'{"a":' * 50_000 + b"1" + b"}" * 50_000), "JSON is nested too deeply"),
    ("many lists", with_line(b'{"beta":["0","1/2"],"pieces":[' + b"[]," * 210_000 + b"[]]}"), "the limit lists=200000"),
    ("long line", with_line(b'{"beta":"' + b"1" * 3_000_000 + b'"}'), "the limit line=2000000"),
    ("spaces", with_line(FIRST.replace(b":", b": ")), "a line is not canonical JSON"),
    ("order of keys", with_line(b'{"pieces":[["laplace"]],"beta":["0","1/2"]}'), "a line is not canonical JSON"),
    ("carriage return", with_line(FIRST + b"\r"), "a line is not canonical JSON"),
    ("escape", with_line(FIRST.replace(b'"sign"', b'"\\u0073ign"')), "a line is not canonical JSON"),
    ("no escape", with_line(FIRST.replace(b"taylor", "τ".encode())), "a line is not canonical JSON"),
    ("lone surrogate", with_line(FIRST.replace(b"taylor", b"\\ud800")), "unknown piece"),
    ("not UTF-8", with_line(FIRST.replace(b"taylor", b"\xff")), "the text is not UTF-8"),
    ("byte order mark", sealed(b"\xef\xbb\xbf" + BODY), "a line is not JSON"),
    ("not JSON", with_line(FIRST[:-1]), "a line is not JSON"),
    ("two objects", with_line(FIRST + FIRST), "a line is not JSON"),
    ("empty line", with_line(b""), "a line is not JSON"),
    ("column is null", with_line(b"null"), "a column has not the keys"),
    ("wrong hash", BODY + b"sha256 " + b"0" * 64 + b"\n", "the hash does not match"),
    ("hash of another file", BODY + text_of(GOOD["hinge"])[-72:], "the hash does not match"),
    ("hash in capitals", BODY + sealed(BODY)[-72:].upper(), "the last line is not sha256 and a hash"),
    ("no hash", BODY, "the last line is not sha256 and a hash"),
    ("hash alone", sealed(b""), "the last line is not sha256 and a hash"),
    ("two hashes", sealed(BODY) + sealed(BODY)[-72:], "the hash does not match"),
    ("twice", sealed(sealed(BODY)), "a line is not JSON"),
    ("empty", b"", "the last line is not sha256 and a hash"),
    ("one bit", sealed(BODY).replace(b'"-4/3"', b'"-5/3"', 1), "the hash does not match"),
    ("byte after the end", sealed(BODY) + b"\n", "the last line is not sha256 and a hash"),
    ("line after the end", sealed(BODY) + b"{}\n", "the last line is not sha256 and a hash"),
    ("zeros after the end", sealed(BODY) + bytes(100), "the last line is not sha256 and a hash"),
    ("too long", sealed(b"\n" * 20_000_000), "the limit bytes=20000000"),
]


@pytest.mark.parametrize(("name", "data", "message"), TEXTS, ids=[row[0] for row in TEXTS])
def test_text(name: str, data: bytes, message: str) -> None:
    assert message in rejection(data), name


def test_every_prefix_is_rejected() -> None:
    data = text_of(GOOD["hinge"])
    for length in range(len(data)):
        assert "the last line is not sha256 and a hash" in rejection(data[:length])


def test_every_prefix_of_lines_with_its_own_hash_is_rejected() -> None:
    lines = GOOD["fold"]
    for length in range(1, len(lines)):
        assert "the columns do not cover the whole range" in rejection(text_of(lines[:length]))


@pytest.mark.parametrize("wrong", [0, 2, 3, -1, 10**100])
def test_no_other_count_passes(wrong: int) -> None:
    rejection(mutate.mutated(GOOD["zeros"], state(counts=[[1, wrong]])))


def test_hostile_numbers_end_within_the_budget() -> None:
    """Long numbers in a right place: the answer may be either, but it comes within a fifth of the usual work."""
    near = f"{10**3999 + 1}/{3 * 10**3999}"
    for good, mutation in [
        ("iwc", put_pieces(1, ["left", f"-{near}"], ["sign", f"-{near}", "0", 1], ["taylor"])),
        ("integer", state(tau=f"[{near}, {near}]", beta="[30, 30]")),
        ("right", put_pieces(1, ["right", near, 0])),
        ("iwc", move_column_end(1, 1, Fraction(1, 10**3998))),
    ]:
        assert "limit work" not in answer(mutate.mutated(GOOD[good], mutation), check.limits.Limits(work=3))


def answer(data: bytes, limits: Any = None) -> str:
    """The statement, or the reason against it."""
    try:
        return str(check.main.check_text(data, limits))
    except check.limits.Rejected as reason:
        return str(reason)
