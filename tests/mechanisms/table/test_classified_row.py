"""A row as a line of CSV, and what makes a motion through its G-spot impossible."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from fractions import Fraction

from gspot_verified import load
from gspot_verified.mechanisms.table.classified_row import ClassifiedRow
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.numbers.dyadic import Dyadic

ROWS = list(classify_table(load("genot_brogliato_rod"), [{"mu": "2", "L": "1/3"}, {"mu": "a, b", "L": "1"}]))


def fields(row: ClassifiedRow) -> dict[str, str]:
    head, line = csv.reader([row.csv_head(), row.to_csv()])
    return dict(zip(head, line, strict=True))


def test_a_line_holds_what_the_row_says() -> None:
    settled, refused = map(fields, ROWS)
    assert list(settled) == list(refused)
    assert [settled[key] for key in ("mu", "L", "outcome", "case", "lift_off_sign_of_C1", "impact_sign_of_C1")] == [
        "2", "1/3", "settled", "II", "", "-1",
    ]  # fmt: skip
    assert (refused["mu"], refused["outcome"], refused["case"], refused["beta_lower"]) == ("a, b", "refused", "", "")
    assert "'a, b'" in refused["reason"]
    for name, number in (*ROWS[0].numbers, *ROWS[0].point):
        assert number is not None
        lower, upper = (Fraction(float(settled[f"{name}_{end}"])) for end in ("lower", "upper"))
        assert lower <= number.endpoints()[0] <= number.endpoints()[1] <= upper


def test_plain_data() -> None:
    data = json.loads(json.dumps(ROWS[0].to_json()))
    assert data["given"] == {"mu": "2", "L": "1/3"}
    assert Dyadic.parse(data["numbers"]["beta"]) == dict(ROWS[0].numbers)["beta"]


def test_warnings() -> None:
    row = ROWS[0]
    assert row.warnings == ()
    for name, text in (("mean_force", "tensile"), ("slip_velocity", "u <= 0")):
        for bad in (None, Dyadic(-1, -1), Dyadic(-1, 1), Dyadic(0, 0)):
            numbers = tuple((word, bad if word == name else number) for word, number in row.numbers)
            (warning,) = replace(row, numbers=numbers).warnings
            assert text in warning
            assert replace(row, numbers=numbers, case="none").warnings == ()


def test_no_two_columns_have_one_name() -> None:
    """A parameter may be called case, and a component beta."""
    row = replace(ROWS[0], given=(("case", "1"), ("beta_upper", "2")), point=(("beta", ROWS[0].point[0][1]),))
    found = fields(row)
    assert len(found) == len(next(csv.reader([row.csv_head()])))
    assert (found["case"], found["answer_case"], found["beta_upper"]) == ("1", "II", "2")
    assert float(found["beta_lower"]) <= float(found["spot_beta_upper"])
    assert {"state_beta_lower", "beta_lower"} <= set(found)
