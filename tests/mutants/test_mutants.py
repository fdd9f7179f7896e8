"""The mutation tool: what it changes, that its verdicts are right, and that its list of survivors cannot go stale."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from mutants.choice import mirrored, parts
from mutants.operators import Mutant, code_of, mutants_of
from mutants.survivors import complaints, entry, read_survivors, stale

ROOT = Path(__file__).resolve().parents[2]

SETTINGS = '[tool.pytest.ini_options]\naddopts = "--import-mode=importlib --doctest-modules"\nmarkers = ["slow"]\n'
SOURCE = '''"""A module under test."""

LIMIT = 3


def clamp(value: int) -> int:
    """
    >>> clamp(5)
    3
    """
    if value < 0:
        raise ValueError(f"{value} < 0")
    return min(value, LIMIT)
'''
STRONG = """import pytest
from package.source import clamp

def test_clamp():
    assert [clamp(k) for k in range(6)] == [0, 1, 2, 3, 3, 3]

def test_refused():
    with pytest.raises(ValueError):
        clamp(-1)
"""


def changes(tmp_path: Path, source: str) -> set[str]:
    (tmp_path / "x.py").write_text(source)
    return {mutant.after for mutant in mutants_of(tmp_path, "x.py")}


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("a = b < c", {"a = b <= c"}),
        ("a = b < c < d", {"a = b <= c < d", "a = b < c <= d"}),
        ("a = b + c", {"a = b - c", "a = b", "a = c"}),
        ("a = b and c", {"a = b", "a = c"}),
        ("a = not b", {"a = b"}),
        ("a = -b", {"a = b"}),
        ("a = 7", {"a = 8"}),
        ("with precision(192):\n    a()", {"with precision(2):", "pass"}),
        ("a = True", {"a = False"}),
        ("a = abs(b)", {"a = b"}),
        ("a = min(b, c)", {"a = max(b, c)", "a = b", "a = c"}),
        ("a = add_remainder(b, c)", {"a = b"}),
        ("a = b.abs_upper()", {"a = b.abs_lower()", "a = b"}),
        ("a = b if c else d", {"a = b", "a = d"}),
        ("a = [b for b in c if d]", {"a = [b for b in c]"}),
        ("if a:\n    raise b", {"if False:"}),
        ("if a:\n    b()", {"if False:", "if True:", "pass"}),
        ("check(a)", {"pass"}),
        ("a += b", {"a -= b", "pass"}),
        ("try:\n    a()\nexcept b:\n    raise", {"pass"}),
        ('a: list[3] = "text"', set()),
        ('@decorated(3)\ndef f(a: 3 = b) -> 3:\n    "text"', set()),
        ('raise ValueError(f"{a + 1}")', {"pass"}),
    ],
)
def test_operators(tmp_path: Path, source: str, expected: set[str]) -> None:
    assert changes(tmp_path, source) == expected


def test_equal_changes_are_numbered_and_the_code_is_the_changed_one(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_text("def f():\n    a = [1]\n    a = a[:]\n    a = [1]\n    return a\n")
    mutants = mutants_of(tmp_path, "x.py")
    assert len({mutant.key for mutant in mutants}) == len(mutants)
    found = {}
    for mutant in mutants:
        names: dict[str, object] = {}
        exec(code_of(tmp_path, mutant), names)
        found[mutant.after] = names["f"]()  # type: ignore[operator]
    assert found["a = [2]  # occurrence 2"] == [2]
    assert found["a = [2]"] == [1]


def test_a_file_of_the_ledger_meets_the_verdicts_and_the_wrong_formulas_of_the_parts_that_rest_on_it() -> None:
    paper = "gspot_verified/paper"
    assert parts(ROOT, f"{paper}/section_6/section_6.py") == {"section_6"}
    resting = {"section_6", "section_6_relaxation", "section_6_sentences"}
    assert parts(ROOT, f"{paper}/section_6/oscillator.py") == resting
    assert {"section_5_spaces", "section_5_theorem"} <= parts(ROOT, f"{paper}/section_4/powers_of_epsilon.py")
    assert parts(ROOT, f"{paper}/checks/entry.py") == parts(ROOT, "gspot_verified/numbers/dyadic.py") == set()
    chosen = mirrored(ROOT, f"{paper}/section_6/oscillator.py")
    names = ("section_6/test_oscillator", "test_verdicts", "test_teeth", "test_steps")
    assert {f"tests/paper/{name}.py" for name in names} <= {*chosen}
    assert "tests/paper/test_verdicts.py" not in mirrored(ROOT, "gspot_verified/numbers/dyadic.py")


def test_a_test_of_a_longer_name_belongs_to_the_file_of_that_name(tmp_path: Path) -> None:
    for name in ("package/room/fig.py", "package/room/fig_a.py", "package/room/other.py"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    tests = [f"tests/room/test_{name}.py" for name in ("fig", "fig_a", "fig_a_b", "fig_c", "figure")]
    for name in tests:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    assert mirrored(tmp_path, "package/room/fig.py") == ["package/room/fig.py", tests[0], tests[3]]
    assert mirrored(tmp_path, "package/room/fig_a.py") == ["package/room/fig_a.py", tests[1], tests[2]]


def test_the_list_is_held_against_the_run(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_text("a = b < c\n")
    (mutant,) = mutants_of(tmp_path, "x.py")
    assert complaints([mutant.key], [mutant], [], [mutant]) == []
    assert complaints([], [mutant], [mutant], []) == []
    assert "not in the list" in complaints([], [mutant], [], [mutant])[0]
    assert "was killed" in complaints([mutant.key], [mutant], [mutant], [])[0]
    gone = ("x.py", "module: a = c [< → <=] b")
    assert "no longer" in complaints([gone], [mutant], [mutant], [])[0]
    whole_line = ("x.py", "module: a = *")
    assert complaints([whole_line], [mutant], [], [mutant]) == complaints([whole_line], [mutant], [mutant], []) == []
    assert "no longer" in complaints([("x.py", "module: b = *")], [mutant], [mutant], [])[0]
    for scope in ("f: *", "module: *"):  # what is argued as a whole is a function
        assert "not in the list" in complaints([("x.py", scope)], [mutant], [], [mutant])[0]
        assert "no longer" in complaints([("x.py", scope)], [mutant], [mutant], [])[0]
    assert complaints([("y.py", gone[1])], [mutant], [mutant], []) == []  # of a file that was not run


def test_an_entry_can_be_read_back_and_needs_an_argument(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_text("""a = {'b': "'"} == '\\\\'\n""")
    (mutant,) = mutants_of(tmp_path, "x.py")
    path = tmp_path / "survivors.toml"
    path.write_text(entry(mutant))
    with pytest.raises(ValueError, match="no argument"):
        read_survivors(path)
    argued = entry(mutant).replace(' = ""', ' = "Equal."')
    path.write_text(argued)
    assert read_survivors(path) == {mutant.key: "Equal."}
    path.write_text(f"{argued}\n{argued.splitlines()[1]}")
    with pytest.raises(ValueError, match="Cannot overwrite"):
        read_survivors(path)


def test_a_change_is_named_by_what_stands_around_it(tmp_path: Path) -> None:
    """Not by the rest of its line, nor by the value of a constant where every change of it is argued."""
    line = "return [c(first_argument_of_it, 1), second_argument_of_the_list, LONG_ARGUMENT]"
    text = f"LIMIT = 5\n\ndef f():\n    if a > 0 and b > 0:\n        {line}\n"

    def mutants(source: str) -> list[Mutant]:
        (tmp_path / "x.py").write_text(source)
        return mutants_of(tmp_path, "x.py")

    old, new = mutants(text), mutants(text.replace("LONG_ARGUMENT", "SOMETHING_ELSE"))
    assert [mutant.change for mutant in old] == [mutant.change for mutant in new]
    assert [mutant.change for mutant in old][:3] == [
        "module: LIMIT = [5 → 6]",
        "f: if [a > 0 and b > 0 → False]:",
        "f: if [a > 0 and b > 0 → True]:",
    ]
    assert old[0].wider == {("x.py", "module: LIMIT = *")} == mutants(text.replace("5", "7"))[0].wider
    assert old[1].wider == {("x.py", "f: if a > 0 and b > 0:*"), ("x.py", "f: *")}
    twice = mutants("def f():\n    a = 1\n    a = 1\n")
    assert [mutant.change for mutant in twice] == ["f: a = [1 → 2]", "f: a = [1 → 2] #2"]


def test_the_committed_list_reads() -> None:
    listed = read_survivors(ROOT / "tests" / "mutants" / "survivors.toml")
    assert {key[0] for key in listed if not (ROOT / key[0]).is_file()} == set()


def test_every_committed_entry_still_names_a_mutant_of_its_source() -> None:
    """A line that was changed, or moved to another function, has its survivors judged anew."""
    listed = read_survivors(ROOT / "tests" / "mutants" / "survivors.toml")
    scopes: dict[str, set[str]] = {}
    for file, change in listed:
        scopes.setdefault(file, set()).add(change.split(": ")[0])
    assert stale(listed, [mutant for file, some in scopes.items() for mutant in mutants_of(ROOT, file, some)]) == []


@pytest.mark.parametrize(
    "source", ["def f():\n    a = b <= c\n", "def g():\n    a = b < c\n", "def f():\n    pass\n", ""]
)
def test_an_entry_is_stale_once_its_line_has_changed_moved_or_gone(tmp_path: Path, source: str) -> None:
    def mutants(text: str) -> list[Mutant]:
        (tmp_path / "x.py").write_text(text)
        return mutants_of(tmp_path, "x.py")

    before = mutants("def f():\n    a = b < c\n")
    assert mutants_of(tmp_path, "x.py", {"f"}) == before
    assert mutants_of(tmp_path, "x.py", {"g"}) == []
    listed = [before[0].key, ("x.py", "f: a = b < c*"), ("x.py", "f: *")]
    assert stale(listed, before) == []
    kept = [key for key in listed if source.startswith("def f():\n    a") and key[1] == "f: *"]
    assert stale(listed, mutants(source)) == sorted(set(listed) - set(kept))


def run(
    folder: Path, tests: str, survivors: str = "", source: str = SOURCE, package: str = "", options: str = ""
) -> tuple[int, str]:
    """The tool on a small project, in a process of its own."""
    files = {"pyproject.toml": SETTINGS, "package/__init__.py": package, "package/source.py": source,
             "tests/test_source.py": tests, "tests/mutants/survivors.toml": survivors}  # fmt: skip
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    script = (
        "import sys; from pathlib import Path; from mutants.__main__ import main; sys.path.insert(0, sys.argv[1]); "
        "sys.exit(main(['package/source.py', '--workers', '1', *sys.argv[2].split()], Path(sys.argv[1])))"
    )
    command = [sys.executable, "-c", script, str(folder), options]
    environment = {"PYTHONPATH": str(ROOT / "tests"), "PATH": ""}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    return done.returncode, done.stdout + done.stderr


LIVING = "['package/source.py']\n'clamp: if [value < 0 → False]:' = 'For this test.'\n"


@pytest.mark.slow
def test_every_mutant_meets_the_tests(tmp_path: Path) -> None:
    code, text = run(tmp_path, STRONG)
    assert "package/source.py: 7 mutants, 7 killed (0 by a limit), 0 survivors argued, 0 not argued, 0 in lines" in text
    assert "argued as a whole, 0 not run" in text
    assert code == 0
    assert (tmp_path / "package" / "source.py").read_text() == SOURCE


WEAK = STRONG[: STRONG.index("def test_refused")]


def test_a_survivor_fails_the_run(tmp_path: Path) -> None:
    code, text = run(tmp_path, WEAK)
    assert code == 1
    assert text.count("not in the list") == 1
    assert "'clamp: if [value < 0 → False]:' = \"\"" in text
    assert "package/source.py: 7 mutants, 6 killed" in text


@pytest.mark.slow
def test_an_argued_survivor_does_not_and_a_killed_one_does(tmp_path: Path) -> None:
    assert run(tmp_path, WEAK, LIVING)[0] == 0
    code, text = run(tmp_path, STRONG, LIVING)
    assert code == 1
    assert "was killed" in text


@pytest.mark.slow
def test_what_is_argued_as_a_whole_is_not_run(tmp_path: Path) -> None:
    whole = LIVING.replace("if [value < 0 → False]:", "*")
    code, text = run(tmp_path, WEAK, whole)
    assert code == 0
    assert "package/source.py: 7 mutants, 1 killed" in text  # the constant stands outside the function
    assert "0 not argued, 6 in lines or functions argued as a whole, 0 not run" in text


@pytest.mark.slow
def test_no_verdict_when_the_tests_fail_without_a_change(tmp_path: Path) -> None:
    code, text = run(tmp_path, STRONG.replace("3, 3, 3]", "3, 3, 4]"))
    assert code == 2
    assert "do not pass without a change" in text


@pytest.mark.slow
def test_a_mutant_that_never_ends_is_killed_by_its_limit(tmp_path: Path) -> None:
    source = "def down(value):\n    while value > 0:\n        value -= 1\n    return value\n"
    code, text = run(tmp_path, "from package.source import down\n\ndef test():\n    assert down(3) == 0\n", "", source)
    assert "by a limit" in text
    assert "(0 by a limit)" not in text
    assert code in (0, 1)


@pytest.mark.slow
def test_a_module_that_a_conftest_imports_is_changed_before(tmp_path: Path) -> None:
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "conftest.py").write_text("from package.source import LIMIT\n")
    code, text = run(tmp_path, STRONG, "", f"{SOURCE}\n\n(0, 0)[LIMIT - 2]\n")
    assert "package/source.py: 12 mutants, 9 killed" in text  # three of the last line are good places, too
    assert code == 1


@pytest.mark.slow
def test_a_module_that_its_package_imports_is_loaded_once(tmp_path: Path) -> None:
    """Loaded twice, it has two classes of one name, and no value of the one equals a value of the other."""
    source = "class Value:\n    pass\n\ndef make():\n    return Value() if 1 < 2 else None\n"
    tests = (
        "from package import make\nfrom package.source import Value\n\ndef test():\n    assert type(make()) is Value\n"
    )
    code, text = run(tmp_path, tests, "", source, "from package.source import make\n")
    assert code in (0, 1), text
    assert "do not pass" not in text


CLOSURES = """from functools import cache

class Box:
    @property
    def half(self):
        return 8 / 2

def adder(n):
    def add(value):
        return value + n
    return add

plus_one = adder(1)

@cache
def nine():
    return (lambda: 9)()
"""
USES = """from package.source import Box, nine, plus_one

def test_box():
    assert Box().half == 4

def test_closure():
    assert plus_one(1) == 2

def test_cached():
    assert nine() == 9
"""


@pytest.mark.slow
@pytest.mark.parametrize("left_out", ["", "test_closure"])
def test_the_change_reaches_properties_closures_and_cached_functions(tmp_path: Path, left_out: str) -> None:
    """Also those that stand in memory before the change: with a test for each, no mutant lives; without it, some do."""
    tests = USES.replace(f"def {left_out}", "def left_out") if left_out else USES
    code, text = run(tmp_path, tests, "", CLOSURES)
    assert code == bool(left_out), text
