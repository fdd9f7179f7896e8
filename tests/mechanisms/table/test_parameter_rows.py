"""A table's rows: exact numbers; a wrong column is refused with the table, a wrong row alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from flint import fmpq

from gspot_verified import MechanismError, load
from gspot_verified.mechanisms.table.parameter_rows import ParameterRow, parameter_rows

ROD = load("genot_brogliato_rod")


def read(tmp_path: Path, text: str) -> list[ParameterRow]:
    path = tmp_path / "table.csv"
    path.write_bytes(text.encode())
    return list(parameter_rows(ROD, path).rows)


def test_numbers_are_exact(tmp_path: Path) -> None:
    """Also with blanks, quotes, empty lines, the line ends and the mark that other programs write."""
    rows = read(tmp_path, '\ufeffmu, L\r\n0.1 ,"7/3"\r\n\r\n2,1e-3\r\n')
    assert [row.values for row in rows] == [(fmpq(1, 10), fmpq(7, 3)), (fmpq(2), fmpq(1, 1000))]
    assert [row.number for row in rows] == [1, 2]
    assert rows[0].given == (("mu", "0.1"), ("L", "7/3"))
    given = parameter_rows(ROD, iter([{"mu": "0.1", "L": 2}, {"L": fmpq(1, 2), "mu": 1}]))
    assert given.parameters == ("mu", "L")
    assert [row.values for row in given.rows] == [(fmpq(1, 10), fmpq(2)), (fmpq(1), fmpq(1, 2))]


@pytest.mark.parametrize(
    ("line", "wrong"),
    [
        ("nan,1", "mu: "),
        ("1,inf", "L: "),
        ("1,", "L: "),
        ("x,1", "mu: expected a number"),
        ("1", "one value, 2 are needed: mu, L"),
        ("1,2,3", "3 values, 2 are needed"),
    ],
)
def test_a_wrong_row_is_refused_alone(line: str, wrong: str, tmp_path: Path) -> None:
    first, second, third = read(tmp_path, f"mu,L\n1,1\n{line}\n2,1\n")
    assert (first.values, third.values) == ((fmpq(1), fmpq(1)), (fmpq(2), fmpq(1)))
    assert second.values is None
    assert wrong in second.wrong
    assert [name for name, _ in second.given] == ["mu", "L"]


def test_a_wrong_mapping_is_refused_alone() -> None:
    rows: list[Any] = [{"mu": 1}, {"L": 1}, {}, {"mu": 1, "L": 2}, {"mu": 0.5}]
    first, *others = parameter_rows(ROD, rows).rows
    assert first.values == (fmpq(1),)
    assert [row.number for row in (first, *others)] == [1, 2, 3, 4, 5]
    assert [row.values for row in others] == [None] * 4
    assert [row.given for row in others[:3]] == [(("mu", ""),), (("mu", ""),), (("mu", "1"),)]
    assert "values of nothing; those of mu are needed" in others[1].wrong
    assert "float" in others[3].wrong


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the first line must name parameters"),
        ("\n1\n", "the first line must name parameters"),
        ("mu,l\n1,1\n", "column 2: falling rod of Génot and Brogliato has no parameter 'l'"),
        ("mu,L,mu\n1,1,1\n", "column 3: mu is there twice"),
        ("1,2\n", "column 1: .* has no parameter '1'"),
        ("mu,L\n", "the table has no row"),
        ('mu\n"1\n', "is no CSV file"),
    ],
)
def test_a_wrong_table_is_refused(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(MechanismError, match=message):
        read(tmp_path, text)


def test_no_text_no_table(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_bytes(b"mu\n\xff\xfe\n")
    with pytest.raises(MechanismError, match="is no CSV file"):
        list(parameter_rows(ROD, path).rows)
    with pytest.raises(OSError, match="missing"):
        parameter_rows(ROD, tmp_path / "missing.csv")
    with pytest.raises(MechanismError, match="must name parameters"):
        parameter_rows(ROD, [])
