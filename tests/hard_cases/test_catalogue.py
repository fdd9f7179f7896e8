"""The catalogue as text and data, its counts, and the doubles behind it."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified import theta
from gspot_verified.cli import main
from gspot_verified.hard_cases.catalogue import CASES, Catalogue, Measured, families, measure_hard_cases
from gspot_verified.hard_cases.expansion_cases import DoublePolynomial, Doubles
from gspot_verified.hard_cases.fold_cases import force_in_doubles
from gspot_verified.hard_cases.hard_case import (
    HardCase,
    agrees,
    bits_lost,
    double_text,
    log10,
    near,
    nearest_double,
    real_roots,
    sign_changes,
    theta_double,
)
from gspot_verified.numbers.balls import working_bits
from gspot_verified.report.parts.latex import latex_formula


@pytest.fixture(scope="module")
def catalogue():
    return measure_hard_cases(["side", "spots-gone", "certificate"])


def test_every_part_of_the_library_is_there():
    parts = {family.part for family in families()}
    known = {"theta_function", "signs", "certificates", "expansion", "uniform", "compliant", "mechanisms", "scenes"}
    assert parts == known
    assert {family.name for family in families()} == set(CASES)
    assert len(families()) >= 20


@pytest.mark.parametrize("family", families(), ids=lambda family: family.name)
def test_words_of_a_family(family):
    assert len(family.levels) >= 3
    assert list(family.levels) == sorted(set(family.levels))
    assert "<math" in latex_formula(family.formula, display=True)
    for text in (family.title, family.variable, family.why, family.instead, family.work):
        assert text.strip() == text != ""


def test_text_and_data(catalogue):
    text, data = str(catalogue), json.loads(json.dumps(catalogue.to_json(), allow_nan=False))
    summary = data["summary"]
    assert summary["rows"] == sum(len(family["rows"]) for family in data["families"]) == 12
    assert text.endswith(
        "of 12 cases: 12 decided, 0 undecided; double precision: "
        f"{summary['double_right']} right, {summary['double_wrong']} wrong, 3 not compared"
    )
    assert summary["double_right"] + summary["double_wrong"] == 9
    for family in data["families"]:
        assert family["title"] in text
        assert all(row["asked"] in text for row in family["rows"])
    assert data["families"][0]["growth"]["work"] == pytest.approx(1, abs=0.1)


def test_right_wrong_and_not_compared_are_shown():
    """Made up, for what doubles answer is theirs."""
    family = next(family for family in families() if family.name == "side")
    right, wrong, none = (
        HardCase(8, "x", 1, "1", 1, 0.1, 1.0, 3, d, t) for d, t in ((1.0, "1"), (-1.0, "-1"), (None, ""))
    )
    found = Catalogue((Measured(family, (right, wrong, none)),))
    assert (right.double_right, wrong.double_right, none.double_right) == (True, False, None)
    lines = str(found).splitlines()
    answers = [lines[k + 1] for k, line in enumerate(lines) if line.startswith("  x ")]
    assert [line.split()[0] for line in answers] == ["right", "WRONG", "-"]
    assert found.summary() == {"rows": 3, "decided": 3, "double_right": 1, "double_wrong": 1}


def test_the_table_fits_the_page_and_says_where_it_is_cut(catalogue: Catalogue) -> None:
    """At 100 columns every number stands whole; at fewer, down to 60, lines end in a mark."""
    whole = str(catalogue)
    assert max(map(len, whole.splitlines())) <= 100
    assert "…" not in whole
    for width in (80, 60, 40):
        lines = catalogue.table(width).splitlines()
        assert len(lines) == len(whole.splitlines())
        assert max(map(len, lines)) == max(width, 60)
        for line, uncut in zip(lines, whole.splitlines(), strict=True):
            assert line == uncut or (line[-1] == "…" and uncut.startswith(line[:-1]))


def test_an_undecided_row_is_counted_and_is_no_answer():
    family = next(family for family in families() if family.name == "side")
    row = HardCase(8, "x", None, "undecided", 1, 0.1, 1.0, 3, 1.0)
    measured = Measured(family, (row,))
    assert row.double_right is None
    assert measured.decided == ()
    assert measured.growth == {"work": None, "seconds": None}
    with pytest.raises(TypeError, match="no truth value"):
        bool(row)


def test_an_unknown_family_is_refused():
    with pytest.raises(ValueError, match="no family of hard cases is named 'canards'; there are: integer-beta"):
        measure_hard_cases(["canards"])
    assert main(["hard-cases", "canards"]) == 64


def test_the_command(capsys):
    assert main(["hard-cases", "side"]) == 0
    assert "of 5 cases: 5 decided" in capsys.readouterr().out


def test_theta_in_doubles_where_nothing_cancels():
    for tau, beta in ((0.5, -0.25), (1.0, 0.5), (-1.0, 2.25), (3.0, -1.5)):
        exact = theta(fmpq(*tau.as_integer_ratio()), fmpq(*beta.as_integer_ratio()))
        assert agrees(theta_double(tau, beta), exact)
    assert math.isnan(theta_double(1.0, 2.0))


def test_sign_changes_and_roots():
    assert sign_changes(math.sin, 0.1, 7.0, 100) == 2
    assert sign_changes(lambda x: math.nan if x < 1 else x - 2, 0.0, 3.0, 10) == 1
    assert real_roots([1, 0, -1]) == 2
    assert real_roots([1, 0, 1]) == 0
    assert double_text(None) == "no answer"


def test_forces_in_doubles_solve_their_equation():
    """d/dT F_b = -b F_(b-1): by a difference."""
    b, eps, step = 4.5, 1.0, 1e-5
    values = force_in_doubles(np.array([1 - step, 1 + step]), b, eps)
    other = force_in_doubles(np.array([1.0]), b, eps)
    assert np.all(np.isfinite(values))
    curvature = (values[1] - 2 * other[0] + values[0]) / step**2
    assert abs(curvature) < 1e3
    slope = (values[1] - values[0]) / (2 * step)
    below = -(1.0 + 1 - b) * slope  # the other terms are of F'', F''' and F''''
    assert math.isfinite(below)


def test_doubles_and_their_text():
    assert nearest_double(fmpq(1, 10**400)) == 0
    assert nearest_double(-(fmpq(10) ** 400)) == -math.inf
    assert log10(fmpq(1, 1000)) == -3
    assert near(2, 3) == fmpq(2001, 1000)
    assert agrees(0.5, fmpq(1, 2))
    assert agrees(-1.0, -1)
    assert not agrees(1.0, -1)
    assert not agrees(math.inf, arb(1))
    assert not agrees(1.0000001, arb(1))
    assert not agrees(1.0, arb(1, 1))


def test_bits_lost_is_what_cancels():
    def difference(bits: int) -> arb:
        with working_bits(bits):
            return (arb(2) ** 200 + arb(1).exp()) - arb(2) ** 200

    lost = bits_lost(difference)
    assert lost is not None
    assert 195 <= lost <= 225
    assert bits_lost(lambda _: arb("nan")) is None


def test_polynomials_in_doubles():
    left, right = DoublePolynomial([1.0, 2.0, 0.0]), DoublePolynomial([3.0])
    assert left.length() == 2
    assert (left * right).coeffs() == [3.0, 6.0]
    assert (left + right).coeffs() == [4.0, 2.0]
    assert (left - left).length() == 0
    assert (-left).coeffs() == [-1.0, -2.0]
    assert (left * DoublePolynomial([])).length() == 0
    assert (left * 2.0).coeffs() == [2.0, 4.0]
    ring = Doubles()
    assert ring.number(fmpq(1, 4)) == 0.25
    assert ring.power(4.0, fmpq(1, 2)) == 2.0
    assert ring.is_nonzero(1e-3)
    assert not ring.is_nonzero(1e-16)
    assert ring.is_zero(0.0)
    assert ring.is_negative(-1.0)
    assert ring.sine_cosine(0.0) == (0.0, 1.0)
    assert ring.exponential(0.0) == 1.0
    assert ring.logarithm(1.0) == 0.0
