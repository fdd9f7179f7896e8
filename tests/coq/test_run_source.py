"""proofs/coq/run_source.py (proofs/run_certificate.md): a certificate of a run as a Coq source."""

from __future__ import annotations

import json
import random
import re
from fractions import Fraction
from types import ModuleType
from typing import Any

import pytest
from coq.coq_terms import COQ, script_named

RUN = COQ.parent / "run_fig_varsim1.cert"
NUMBER = re.compile(r"-?\d+(?: / \d+)?")
START = ("p", "b", "y", "v", "z")


@pytest.fixture
def script() -> ModuleType:
    """The script as a module."""
    return script_named("run_source")


def numbers(text: str) -> list[Fraction]:
    """The numbers of a text, in its order."""
    return [Fraction(number.replace(" ", "")) for number in NUMBER.findall(text)]


def header() -> dict[str, Any]:
    """The statement of the shipped run."""
    statement: dict[str, Any] = json.loads(RUN.read_text("utf-8").partition("\n")[0])["statement"]
    return statement


def test_the_theorem_has_the_numbers_of_the_certificate() -> None:
    theorem = (COQ / "StatementRun.v").read_text("utf-8").partition("Definition run_fig_varsim1_checked : Prop :=")[2]
    start = re.search(r":= starts(.*?) in\n", theorem, re.DOTALL)
    bracket = re.search(r"first_lift_off(.*?) y v z\.", theorem, re.DOTALL)
    assert start
    assert bracket
    held = header()
    of = {name: Fraction(text) for name, text in (held["parameters"] | held["start"]).items()}
    alpha_3 = of["alpha_1"] * of["beta"]
    epsilon = Fraction(held["epsilon"])
    expected = [of["alpha_1"], of["alpha_2"], alpha_3, epsilon, *(of[name] for name in START)]
    assert numbers(start[1]) == expected
    kind, early, late = held["events"][0]
    assert kind == "lift-off"
    assert numbers(bracket[1]) == [epsilon, Fraction(early), Fraction(late)]
    assert {of[name] for name in ("k_1", "k_2", "damping")} == {1}


def test_the_scene_is_that_of_the_certificate(script: ModuleType) -> None:
    held = header()
    of = held["parameters"] | held["start"]
    names = ("alpha_1", "alpha_2", "beta", *"bpvyz")
    words = [held["epsilon"], *(of[name] for name in names), *held["events"][0][1:]]
    scene = " ".join(script.number(Fraction(word)) for word in words)
    assert f"Definition other_scene : scene := (Scene {scene})%Q." in script.source("other", RUN.read_text("utf-8"))


@pytest.mark.parametrize(
    ("true", "other"),
    [
        ('"k_2":"1"', '"k_2":"2"'),
        ('"damping":"1"', '"damping":"1/2"'),
        ('"compliant_contact","lift_off"', '"compliant_contact"'),
        ('"event":"lift-off"', '"event":"stick"'),
        ('["lift-off"', '["touch-down"'),
        ('"events":[', '"events":[],"others":['),
    ],
)
def test_a_run_that_is_not_known_is_refused(script: ModuleType, true: str, other: str) -> None:
    text = RUN.read_text("utf-8")
    assert true in text
    with pytest.raises(ValueError, match="knows a first lift-off of the model"):
        script.source("other", text.replace(true, other, 1))


def test_another_bracket_is_another_source(script: ModuleType) -> None:
    text = RUN.read_text("utf-8")
    early = header()["events"][0][1]
    assert script.source("same", text) != script.source("same", text.replace(early, "1/2", 1))


def test_numbers_as_terms(script: ModuleType) -> None:
    assert [script.integer(value) for value in (7, -7, 2**60, -(2**61))] == ["7", "(-7)", str(2**60), f"(-{2**61:#x})"]
    assert [script.number(Fraction(-1, 3)), script.number(Fraction(2))] == ["((-1) # 3)", "(2 # 1)"]
    assert [script.exact([3, -2]), script.up(-3, 2), script.up(3, 2)] == [Fraction(3, 4), -1, 2]
    assert [script.root(square) for square in (0, 1, 2, 4, 5)] == [0, 1, 2, 2, 3]
    with pytest.raises(ValueError, match="finer than its unit"):
        script.integer(Fraction(1, 2))


def test_a_start_between_two_units_has_its_distance_as_an_error(script: ModuleType) -> None:
    """Coq finds the same ([first_errors]): of b = 1/3 and a first coefficient 1, in quarters."""
    start = [Fraction(1, 3), *map(Fraction, (1, -2, 0))]
    errors = script.Errors([1, 1, 1, 1, 1], 1, 4, start, [1, 4, -8, -1])
    third = -(-errors.fine // 3)
    assert errors.radii == [third, 0, 0, errors.fine]
    assert errors.middle == [1, 4, -8, -1]


def test_the_inverse_times_the_matrix_is_the_factor(script: ModuleType) -> None:
    choice = random.Random(5)
    for _ in range(20):
        matrix = [[choice.randint(-9, 9) for _ in range(4)] for _ in range(4)]
        try:
            inverse, factor = script.inverse(matrix)
        except ValueError:
            continue
        assert factor > 0
        product = [[sum(a[m] * matrix[m][k] for m in range(4)) for k in range(4)] for a in inverse]
        assert product == [[factor * (i == k) for k in range(4)] for i in range(4)]
    with pytest.raises(ValueError, match="not regular"):
        script.inverse([[1, 2, 3, 4]] * 4)


def test_a_basis_without_the_clock(script: ModuleType) -> None:
    """The column that moves T most is left out; it must be a block by itself."""
    names = ["T", "V", "Y", "Z", "b"]
    columns = [[0, 1, 0, 0, 0], [1, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 1]]
    basis = [[columns[k][i], 0] for i in range(5) for k in range(5)]
    one = 2**script.FINEST
    kept, first = script.without_clock({"basis": basis, "blocks": [1, 1, 2, 1]}, names)
    rows = {"b": [0, 0, 0, one], "Y": [0, one, 0, 0], "V": [one, 0, 0, 0], "Z": [0, 0, one, 0]}
    assert kept == [rows[name] for name in script.COORDINATES]
    assert first == [0, 1, 1, 3]
    basis[3] = [1, -60]  # what floats leave of a zero
    assert script.without_clock({"basis": basis, "blocks": [1, 1, 2, 1]}, names) == (kept, first)
    with pytest.raises(ValueError, match="no block by itself"):
        script.without_clock({"basis": basis, "blocks": [2, 2, 1]}, names)
