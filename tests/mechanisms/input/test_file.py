"""Mechanism files: the shipped ones are read, bad ones get an error that names the key, and none runs code."""

from __future__ import annotations

import re
from datetime import date
from fractions import Fraction
from importlib import resources
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.mechanisms.formulas.simplify import rational_value
from gspot_verified.mechanisms.input.file import KEYS, MAX_BYTES, mechanism_of_table, parse_mechanism, read_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.input.toml_table import TomlTable, toml_table
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_names, shipped_system
from gspot_verified.mechanisms.spots.classify import classify

DATA = Path(str(resources.files("gspot_verified.mechanisms").joinpath("data")))

GOOD = """
format = 1
name = "block"
[parameters]
m = 2
[lagrangian]
coordinates = ["X", "Y"]
mass_matrix = [["m", 0], [0, "m"]]
forces = [0, "-m"]
[contact]
x = "X"
y = "Y"
mu = "1/2"
[g_spot]
[g_spot.point]
X = 0
Y = 0
X_dot = 1
Y_dot = 0
"""


def test_every_shipped_file_is_listed_and_read() -> None:
    files = list(DATA.rglob("*.toml"))
    assert {read_mechanism(file).name for file in files} == set(shipped_names())
    for file in files:
        assert shipped_mechanism(file.stem) == read_mechanism(file)


def test_short_names() -> None:
    assert [shipped_system(name).name for name in ("model", "extended", "oscillator", "rod")] == [
        "model system", "extended system", "frictional impact oscillator", "falling rod"]  # fmt: skip
    with pytest.raises(MechanismError, match="no shipped mechanism 'other'; there are"):
        shipped_mechanism("other")
    with pytest.raises(MechanismError, match="no parameter 'gamma'; it has: chi"):
        shipped_mechanism("extended", gamma=1)


def test_the_good_text_is_read() -> None:
    assert parse_mechanism(GOOD).state == ("X", "Y", "X_dot", "Y_dot")


@pytest.mark.parametrize(
    ("old", "new", "part"),
    [
        ('name = "block"', "", 'key "name" is missing'),
        ('name = "block"', "name = 3", 'key "name" must be a text, got int 3'),
        ("format = 1", "", 'key "format" is missing'),
        ("format = 1", "format = 2", 'key "format" must be 1'),
        ("format = 1", "format = true", 'key "format"'),
        ("format = 1", "format = 1\nextra = 2", 'unknown key "extra"'),
        ("m = 2", "m = 1e101", 'key "parameters.m": a number may have at most 100 digits and an exponent of 100'),
        ("m = 2", "m = 1e-101", 'key "parameters.m": a number may have at most 100 digits and an exponent of 100'),
        ("m = 2", "m = 1e-99999999999", 'key "parameters.m": a number may have'),
        ("m = 2", f"m = 0.{'1' * 200}", 'key "parameters.m": a number may have at most 100 digits'),
        ("m = 2", "m = nan", 'key "parameters.m" must be a formula.*got float nan'),
        ("m = 2", "m = inf", 'key "parameters.m"'),
        ("m = 2", "m = true", 'key "parameters.m"'),
        ("m = 2", "m = 1979-05-27", 'key "parameters.m"'),
        ("m = 2", 'm = "1/0"', "parameter m: division by zero"),
        ("m = 2", 'm = "X"', "parameter m: unknown name 'X'"),
        ("m = 2", 'm = "m"', "circle"),
        ("m = 2", 'm = "k"\nk = "m"', "circle"),
        ("m = 2", 'X = 1\nm = 1', "'X' is used twice"),
        ("m = 2", 'sin = 1\nm = 1', "'sin' is a function"),
        ("m = 2", '"a b" = 1\nm = 1', "is no name"),
        ("m = 2", 'm = "__import__(\'os\').system(\'touch /tmp/no\')"', "unknown name '__import__'"),
        ("m = 2", 'm = "9**9**9**9"', "parameter m"),
        ("m = 2", f'm = {"9" * 5000}', "no TOML|digits"),
        ('forces = [0, "-m"]', 'forces = [0]', "2 forces"),
        ('forces = [0, "-m"]', 'forces = "0"', 'key "lagrangian.forces" must be a list'),
        ('forces = [0, "-m"]', 'forces = [0, "-m*t"]', "force 2: unknown name 't'"),
        ('forces = [0, "-m"]', "", 'key "lagrangian.forces" is missing'),
        ('[["m", 0], [0, "m"]]', '[["m", 0, 0], [0, "m"]]', "2 rows of 2"),
        ('[["m", 0], [0, "m"]]', '[["m", 0]]', "2 rows of 2"),
        ('[["m", 0], [0, "m"]]', '["m", "m"]', 'key "lagrangian.mass_matrix" must be a list of rows'),
        ('[["m", 0], [0, "m"]]', '[["m", 1], [0, "m"]]', "not symmetric: entry .2, 1."),
        ('["X", "Y"]', '["X", 3]', 'key "lagrangian.coordinates"'),
        ('["X", "Y"]', '["X", "X"]', "used twice"),
        ('["X", "Y"]', '["X", "__class__"]', "is no name"),
        ('["X", "Y"]', "[]", "coordinates"),
        ('mu = "1/2"', "", 'key "contact.mu" is missing'),
        ('mu = "1/2"', "mu = [0.5]", 'key "contact.mu" must be a formula.*got list'),
        ('name = "block"', "name = 2.5", 'key "name" must be a text, got float 2.5'),
        ('["X", "Y"]', '["X", 2.5]', 'key "lagrangian.coordinates" must be a list of names, got float 2.5'),
        ("format = 1", "format = 1.0", 'key "format" must be 1, got float 1.0'),
        ('x = "X"', "", 'key "contact.x" is missing'),
        ('x = "X"', 'x = "X"\nslip_velocity = "X_dot"', "x or slip_velocity, not both"),
        ('x = "X"', 'x = "X"\nslip = "left"', "slip must be 'positive' or 'negative', got 'left'"),
        ('x = "X"', 'slip_velocity = "X_dot^2"', "the slip velocity must be linear in the velocities"),
        ('forces = [0, "-m"]', 'forces = [0, "-m"]\nconstraints = ["X", "Y"]', "2 constraints leave none of the 2"),
        ('forces = [0, "-m"]', 'forces = [0, "-m"]\nconstraints = ["X_dot"]', "constraint must not depend on vel"),
        ("[lagrangian]", "[energies]", 'unknown key "energies.mass_matrix"'),
        ("m = 2", "mass = 2\nm = 2\n[contakt]", 'unknown key "contakt"; did you mean \'contact\''),
        ("X_dot = 1", "X_dt = 1", "'X_dt' is no component of the state; did you mean 'X_dot'.; it has: X, Y"),
        ('mu = "1/2"', 'mu = "1/2"\nnu = 1', 'unknown key "contact.nu"'),
        ("X_dot = 1", "X_dot = 1\nZ = 3", "G-spot: 'Z' is no component"),
        ("X_dot = 1", 'X_dot = "Y"', "G-spot, X_dot: unknown name"),
        ("[g_spot]", "[g_spot]\nsearch = 1", 'key "g_spot.search" must be true or false'),
        ("[g_spot]", "[g_spot]\nserach = true", 'unknown key "g_spot.serach"'),
        ("[g_spot]", '[g_spot]\nfixed = ["Z"]', "'Z' is no component"),
        ("[g_spot]", '[g_spot]\nfixed = "X"', 'key "g_spot.fixed" must be a list'),
        ("[g_spot]", "[angles.X]\nsine = 1\n[g_spot]", 'key "angles.X.cosine" is missing'),
        ("[g_spot]", "[angles.X]\nsine = 1\ncosine = 1\n[g_spot]", "sine.2 . cosine.2 = 1"),
        ("[g_spot]", "[angles.Z]\nsine = 1\ncosine = 0\n[g_spot]", "angle 'Z' is no component"),
        ("[g_spot]", "[angles]\nX = 1\n[g_spot]", 'key "angles.X" must be a table'),
        ("[lagrangian]", "[fields]", 'unknown key "fields.coordinates"'),
        ("[lagrangian]", "[fields]\n[lagrangian]", "exactly one of"),
        ("[lagrangian]", "[lagrangian", "no TOML"),
        ("[contact]", "[contact]\n[contact]", "no TOML"),
    ],
)  # fmt: skip
def test_bad_files_are_refused_with_the_key(old: str, new: str, part: str) -> None:
    assert old in GOOD
    with pytest.raises(MechanismError, match=part):
        classify(parse_mechanism(GOOD.replace(old, new)))


@pytest.mark.parametrize("text", ["[" * 100_000, "a = " + "[" * 5000, "\x00", "a" * (MAX_BYTES + 1), "x = {" * 2000])
def test_hostile_texts(text: str) -> None:
    with pytest.raises(MechanismError):
        parse_mechanism(text)


def test_hostile_sizes() -> None:
    names = ", ".join(f'"q{i}"' for i in range(50))
    with pytest.raises(MechanismError, match="between 1 and 12 coordinates"):
        parse_mechanism(GOOD.replace('["X", "Y"]', f"[{names}]"))
    with pytest.raises(MechanismError, match="more than 2000 operations"):
        parse_mechanism(GOOD.replace('"-m"', '"' + "+".join(f"sin({i}*X)" for i in range(900)) + '"'))


def test_a_text_may_have_as_many_characters_as_is_said() -> None:
    whole = GOOD + "\n" * (MAX_BYTES - len(GOOD))
    assert parse_mechanism(whole) == parse_mechanism(GOOD)
    with pytest.raises(MechanismError, match=f"the text is longer than {MAX_BYTES} characters"):
        parse_mechanism(whole + "\n")


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(MechanismError, match="cannot be read"):
        read_mechanism(tmp_path / "none.toml")
    with pytest.raises(MechanismError, match="cannot be read"):
        read_mechanism(tmp_path)
    wrong = tmp_path / "wrong.toml"
    wrong.write_bytes(b"\xff\xfe")
    with pytest.raises(MechanismError, match="not UTF-8"):
        read_mechanism(wrong)
    wrong.write_bytes(b"#" * (MAX_BYTES + 1))
    with pytest.raises(MechanismError, match="larger than"):
        read_mechanism(wrong)
    wrong.write_text("format = 1")
    with pytest.raises(MechanismError, match=r'wrong\.toml: key "name" is missing'):
        read_mechanism(wrong)


def test_the_example_in_the_documentation_is_the_shipped_rod() -> None:
    from gspot_verified.mechanisms.input import file

    assert file.__doc__ is not None
    for line in ('mass_matrix = [["m", 0, 0], [0, "m", 0], [0, 0, "m*l^2/3"]]', 'y = "Y - l*sin(theta)"'):
        assert line in file.__doc__
        assert line in (DATA / "falling_rod.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["", "  ", "a\\nb", "a\\u202eb", "a\\u001b[31m"])
def test_a_name_is_one_line_of_visible_text(name: str) -> None:
    with pytest.raises(MechanismError, match="visible text"):
        parse_mechanism(GOOD.replace('name = "block"', f'name = "{name}"'))


def test_fixed_and_conditions_exclude_each_other() -> None:
    text = (DATA / "extended_system.toml").read_text(encoding="utf-8")
    both = text.replace('fixed = ["x", "u"]', 'fixed = ["x", "u"]\nconditions = ["x", "u - 1"]')
    with pytest.raises(MechanismError, match="fixed or conditions, not both"):
        parse_mechanism(both)


@pytest.mark.parametrize("number", ["1e100", "1e-100", "1.5e+00010"])
def test_exponents_up_to_100_are_read(number: str) -> None:
    values = parse_mechanism(GOOD.replace("m = 2", f"m = {number}")).parameter_values()
    assert rational_value(values["m"]) == fmpq(Fraction(number).numerator, Fraction(number).denominator)


def test_decimals_are_exact() -> None:
    text = GOOD.replace("m = 2", "m = 0.1\nk = 1_0.5e-1\nh = -2E3").replace('mu = "1/2"', "mu = 0.5")
    values = parse_mechanism(text).parameter_values()
    numbers = {name: rational_value(value) for name, value in values.items()}
    assert numbers == {"m": fmpq(1, 10), "k": fmpq(21, 20), "h": fmpq(-2000)}
    assert rational_value(parse_mechanism(text).mu) == fmpq(1, 2)
    assert parse_mechanism(GOOD.replace('[0, "-m"]', "[0, -0.5]")).motion != parse_mechanism(GOOD).motion


def test_a_byte_order_mark_is_no_part_of_the_text(tmp_path: Path) -> None:
    path = tmp_path / "bom.toml"
    path.write_bytes(b"\xef\xbb\xbf" + GOOD.encode())
    assert read_mechanism(path) == parse_mechanism(GOOD) == parse_mechanism("\N{BYTE ORDER MARK}" + GOOD)


def test_greek_names_and_pi() -> None:
    text = GOOD.replace("X", "φ").replace('coordinates = ["φ"', 'coordinates = ["ϕ"').replace("φ = 0", '"φ" = "2*pi"')
    found = parse_mechanism(text.replace("φ_dot = 1", '"φ_dot" = 1'))
    assert found.state == ("φ", "Y", "φ_dot", "Y_dot")


def test_the_keys_in_the_documentation_are_the_parsers() -> None:
    """One line a key, in the order of the parser."""
    from gspot_verified.mechanisms.input import file

    assert file.__doc__ is not None
    listed = re.findall(r"^    ([\w.*]+)  +\S", file.__doc__, re.MULTILINE)
    wanted = []
    for table, names in KEYS.items():
        wanted += [f"{table}.{name}" if table else name for name in names]
    tables = {name for name in wanted if name in KEYS or f"{name}.*" in wanted}
    assert sorted(set(wanted) - tables) == sorted(listed)
    assert len(listed) == len(set(listed)) == 39


@pytest.mark.parametrize("key", [f"{table}.{name}" for table, names in KEYS.items() for name in names])
def test_every_key_of_the_list_is_read(key: str) -> None:
    """A date is no value of any key: the error names the key, so the parser has read it."""
    block: dict[str, Any] = {
        "format": 1, "name": "block", "contact": {"x": "X", "y": "Y", "mu": 1}, "g_spot": {"point": {"X": 0}},
        "lagrangian": {"coordinates": ["X", "Y"], "mass_matrix": [[1, 0], [0, 1]], "forces": [0, 0]},
        "energies": {"coordinates": ["X", "Y"], "kinetic": "X_dot^2 + Y_dot^2", "potential": "Y"},
        "fields": {"state": ["X", "Y"], "F": [0, 0], "G_T": [0, 0], "G_N": [0, 0]},
        "angles": {"X": {"sine": 0, "cosine": 1}},
    }  # fmt: skip
    words = ["X" if word == "*" else word for word in key.strip(".").split(".")]
    motions = ("lagrangian", "energies", "fields")
    motion = words[0] if words[0] in motions else "lagrangian"
    table = {name: value for name, value in block.items() if name not in motions or name == motion}
    if words[-1] == "slip_velocity":
        del table["contact"]["x"]
    place = table
    for word in words[:-1]:
        place = place.setdefault(word, {})
    place[words[-1]] = date(1979, 5, 27)
    with pytest.raises(MechanismError, match=rf'key "{re.escape(".".join(words))}" must be'):
        mechanism_of_table(TomlTable(table, ""))


@pytest.mark.parametrize(
    ("text", "depth", "expected"),
    [
        ('part = [1, "x", 0.5]', 1, [1, "x", Fraction(1, 2)]),
        ('part = [[1, 2.5], ["x"]]', 2, [[1, Fraction(5, 2)], ["x"]]),
        ("part = [[[0.1]], 2]", 3, [[[Fraction(1, 10)]], 2]),
        ("part = []", 1, []),
    ],
)
def test_formulas_in_lists(text: str, depth: int, expected: object) -> None:
    assert toml_table(text).nested_formulas("part", depth) == expected


@pytest.mark.parametrize(
    ("text", "depth", "message"),
    [
        ("part = [[1]]", 1, r"must be a formula.*got list \[1\]"),
        ("part = [[[1]]]", 2, r"must be a formula.*got list \[1\]"),
        ("part = [[[[1]]]]", 3, r"must be a formula.*got list \[1\]"),
        ("part = [[true]]", 2, "must be a formula.*got bool True"),
        ("part = 3", 2, "must be a list, got int 3"),
        ("other = [3]", 2, "is missing"),
    ],
)
def test_what_is_no_formula_in_lists(text: str, depth: int, message: str) -> None:
    with pytest.raises(MechanismError, match=f'^key "part" {message}'):
        toml_table(text).nested_formulas("part", depth)
