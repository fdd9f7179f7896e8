"""The key of kept results changes with everything that a result depends on."""

from __future__ import annotations

import ast
import hashlib
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from types import SimpleNamespace

import pytest

from gspot_verified.paper import content_key as keys


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    folder = tmp_path / "package"
    (folder / "inner" / "__pycache__").mkdir(parents=True)
    (folder / "code.py").write_text("one = 1\n")
    (folder / "inner" / "data.toml").write_text("a = 1\n")
    (folder / "inner" / "__pycache__" / "code.pyc").write_bytes(b"compiled")
    return folder


def test_every_source_is_in_the_key(sources: Path) -> None:
    first = keys.content_key([sources])
    assert keys.content_key([sources]) == first
    seen = {first}
    for file in ("code.py", "inner/data.toml"):
        path = sources / file
        text = path.read_text()
        path.write_text(text + "#")
        seen.add(keys.content_key([sources]))
        path.write_text(text)
        assert keys.content_key([sources]) == first
    (sources / "more.json").write_text("{}")
    seen.add(keys.content_key([sources]))
    (sources / "more.json").rename(sources / "other.json")
    seen.add(keys.content_key([sources]))
    assert len(seen) == 5


def test_what_python_compiled_is_not(sources: Path) -> None:
    first = keys.content_key([sources])
    (sources / "inner" / "__pycache__" / "code.pyc").write_bytes(b"compiled again")
    assert keys.content_key([sources]) == first


def test_a_file_is_a_source_and_compiled_files_are_none_wherever_they_are(sources: Path) -> None:
    (sources / "code.pyc").write_bytes(b"compiled")
    (sources / "inner" / "__pycache__" / "notes.txt").write_text("of Python")
    kept = [sources / "code.py", sources / "inner" / "data.toml"]
    assert list(keys.source_files([sources])) == kept
    assert list(keys.source_files([kept[1], sources, sources / "missing"])) == [kept[1], *kept]


def test_a_distribution_without_a_list_of_files_has_its_metadata() -> None:
    def row(texts: dict[str, str]) -> list[object]:
        found = SimpleNamespace(metadata={"Name": "toy"}, version="1.0", files=None, read_text=texts.get)
        return keys._distribution(found)  # type: ignore[arg-type]

    rows = [row({}), row({"METADATA": "m"}), row({"METADATA": "n"}), row({"METADATA": "m", "RECORD": "r"})]
    rows.append(row({"RECORD": "r"}))
    assert all(found[:2] == ["toy", "1.0"] for found in rows)
    assert len({str(found) for found in rows[:4]}) == 4
    assert rows[3] == rows[4]
    nameless = SimpleNamespace(metadata={"Name": None}, version="1.0", files=None, read_text={}.get)
    assert keys._distribution(nameless)[0] == ""  # type: ignore[arg-type]


def test_the_checker_is_where_an_installation_puts_it() -> None:
    assert Path(sys.prefix) / "share" / "gspot_verified" / "checker" == keys.CHECKER
    text = (keys.PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8")
    assert '"share/gspot_verified/checker" = ["proofs/checker/*.py"]' in text


def test_the_package_and_its_proofs_are_sources() -> None:
    paths = [path for path in keys.source_files() if keys.CHECKER not in path.parents]
    files = {path.relative_to(keys.PACKAGE.parent).as_posix() for path in paths}
    assert {
        "gspot_verified/numbers/balls.py",
        "gspot_verified/paper/claims.toml",
        "proofs/checker/theta.py",
        "proofs/iwc.md",
    } <= files
    assert all(name.startswith(("gspot_verified/", "proofs/")) for name in files)
    assert {"proofs/iwc_0_1.cert", "proofs/coq/Statement.v", "gspot_verified/paper/paper_source.json"} <= files


def test_versions_are_in_the_key(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = keys.ingredients([sources])
    named = [row[0].lower() for row in first["distributions"]]
    assert {"python-flint", "mpmath", "sympy", "numpy", "scipy"} <= set(named)
    monkeypatch.setattr("flint.__FLINT_VERSION__", "3.0.0")
    monkeypatch.setattr(sys, "version", "2.7")
    other = keys.ingredients([sources])
    assert {name for name in first if first[name] != other[name]} == {"FLINT", "python"}


def test_a_changed_file_of_a_distribution_is_in_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "toy.py").write_text("1\n")
    info = tmp_path / "toy-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: toy\nVersion: 1.0\n")
    (info / "RECORD").write_text("toy.py,sha256=0,2\ntoy.pyc,,\ntoy-1.0.dist-info/METADATA,,\n")
    monkeypatch.setattr(metadata, "distributions", lambda: metadata.Distribution.discover(path=[str(tmp_path)]))

    def key() -> str:
        keys.distributions.cache_clear()
        return keys.content_key([])

    found = [key()]
    (tmp_path / "toy.pyc").write_bytes(b"compiled")
    assert key() == found[0]
    os.utime(tmp_path / "toy.py", (1, 1))
    found.append(key())
    (info / "RECORD").write_text("toy.py,sha256=1,2\n")
    found.append(key())
    (tmp_path / "toy.py").unlink()
    found.append(key())
    keys.distributions.cache_clear()
    assert len(set(found)) == 4


def test_a_module_that_no_distribution_brought_is_in_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Found first on the path of modules, without metadata: a copy by hand, or a folder that is edited in place."""
    monkeypatch.setattr(keys, "MODULES", ("toy",))

    def part() -> str:
        keys.module_files.cache_clear()
        return str(keys.ingredients([])["modules"])

    (tmp_path / "toy").mkdir()
    (tmp_path / "toy" / "__init__.py").write_text("")
    found = [part()]
    monkeypatch.syspath_prepend(str(tmp_path))
    found.append(part())
    for text in ("1", "22"):
        (tmp_path / "toy" / "inner.py").write_text(text)
        found.append(part())
    assert part() == found[-1]
    keys.module_files.cache_clear()
    assert len(set(found)) == 4


def test_a_module_is_a_file_a_folder_or_a_folder_without_init(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each with its place, which a folder without ``__init__.py`` does not have, and with its files."""
    monkeypatch.syspath_prepend(str(tmp_path))
    (tmp_path / "toy_file.py").write_text("1")
    for name in ("toy_folder", "toy_bare"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "inner.py").write_text("1")
    start = tmp_path / "toy_folder" / "__init__.py"
    start.write_text("")
    changed = {
        "toy_file": (str(tmp_path / "toy_file.py"), tmp_path / "toy_file.py"),
        "toy_folder": (str(start), tmp_path / "toy_folder" / "inner.py"),
        "toy_bare": ("", tmp_path / "toy_bare" / "inner.py"),
    }
    for name, (place, file) in changed.items():
        keys.module_files.cache_clear()
        before = keys.module_files(name)
        file.write_text("22")
        keys.module_files.cache_clear()
        after = keys.module_files(name)
        keys.module_files.cache_clear()
        assert before[0] == after[0] == place
        assert before[1] != after[1]


def test_files_are_taken_in_one_order(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file system may give them in any."""
    source_files, listed = keys.source_files, Path.glob
    (sources / "a.pth").write_text("1")
    (sources / "b.pth").write_text("2")
    monkeypatch.setattr(sys, "path", [str(sources)])

    def found() -> list[object]:
        keys.module_files.cache_clear()
        keys.startup.cache_clear()
        result = keys.module_files("inner"), keys.source_state([sources]), keys.startup()
        keys.module_files.cache_clear()
        keys.startup.cache_clear()
        return list(result)

    (sources / "inner" / "more.py").write_text("")
    (sources / "inner" / "again.py").write_text("")
    first = found()
    assert first[0] != ("", "")
    monkeypatch.setattr(keys, "source_files", lambda places: iter([*source_files(places)][::-1]))
    monkeypatch.setattr(Path, "glob", lambda folder, pattern: iter([*listed(folder, pattern)][::-1]))
    assert found() == first


def test_what_acts_before_any_program_is_in_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("sitecustomize", "usercustomize"):
        monkeypatch.setitem(sys.modules, name, SimpleNamespace())
    (tmp_path / "site.py").write_text("1")

    def begun() -> list[list[str]]:
        keys.startup.cache_clear()
        rows = keys.startup()
        keys.startup.cache_clear()
        return rows

    without = begun()
    for name in ("sitecustomize", "usercustomize"):
        with monkeypatch.context() as patch:
            patch.setitem(sys.modules, name, SimpleNamespace(__file__=str(tmp_path / "site.py")))
            (row,) = (row for row in begun() if row not in without)
            assert row == [str(tmp_path / "site.py"), hashlib.sha256(b"1").hexdigest()]


def test_other_libraries_are_in_the_key(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = keys.ingredients([sources])
    monkeypatch.setenv("LD_PRELOAD", "/opt/libflint.so")
    other = keys.ingredients([sources])
    assert {name for name in first if first[name] != other[name]} == {"libraries"}


def test_what_computes_is_in_the_key(package_trees: Mapping[Path, ast.Module]) -> None:
    """Every module of others that the package imports, but for what shows results or is asked for by other commands."""
    shown = {
        "distributed",
        "jinja2",
        "latex2mathml",
        "markdown_it",
        "markupsafe",
        "matplotlib",
        "pyarrow",
        "pygments",
        "typer",
    }
    rivals = {"heyoka", "mujoco", "ore_algebra", "pydrake", "sage"}
    found = set()
    for tree in package_trees.values():
        for node in ast.walk(tree):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            names += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            found |= {name.partition(".")[0] for name in names}
    assert found - set(sys.stdlib_module_names) - shown - rivals == {"gspot_verified", "flint", *keys.MODULES}


def test_a_file_behind_a_link_is_a_source(sources: Path, tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    (tmp_path / "far" / "code.py").write_text("1")
    (sources / "linked").symlink_to(tmp_path / "far")
    assert sources / "linked" / "code.py" in keys.source_files([sources])


def test_a_change_is_seen_whatever_the_clock_says(sources: Path, tmp_path: Path) -> None:
    """A clock that was set back, a folder that was put in the place of another, a file that was removed."""
    states = [keys.source_state([sources])]
    assert keys.source_state([sources]) == states[0]
    shutil.copytree(sources, tmp_path / "copy", copy_function=shutil.copy2)
    sources.rename(tmp_path / "old")
    (tmp_path / "copy").rename(sources)
    states.append(keys.source_state([sources]))
    os.utime(sources / "code.py", (1, 1))
    states.append(keys.source_state([sources]))
    (sources / "code.py").unlink()
    states.append(keys.source_state([sources]))
    assert len(set(states)) == 4


def test_changes_are_seen_under_an_old_date(sources: Path, tmp_path: Path) -> None:
    (tmp_path / "earlier").touch()
    os.utime(sources / "code.py", (1, 1))
    assert keys.newest_change([sources]) >= (tmp_path / "earlier").stat().st_ctime
    assert keys.newest_change([]) == 0


def test_the_newest_of_all_changes_counts(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = [SimpleNamespace(stat=lambda time=time: SimpleNamespace(st_ctime=time)) for time in (2.0, 5.0, 3.0)]
    monkeypatch.setattr(keys, "source_files", lambda _: iter(files))
    assert keys.newest_change([sources]) == 5.0


def test_the_start_of_the_process() -> None:
    """By the kernel's own count: what has run since the process began is less than the age that is found."""
    script = (
        "import time; a = time.time(); time.sleep(0.5)\n"
        "from gspot_verified.paper.content_key import process_start\nprint(a - process_start())"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert float(run.stdout) > -0.05
    assert keys.process_start() < time.time()


def test_the_start_is_read_from_the_kernel(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A process whose name holds blanks and brackets, begun 40 ticks after the machine, 100 s ago."""
    ticks = os.sysconf("SC_CLK_TCK")
    fields = ["S", *map(str, range(4, 22)), str(40 * ticks), "23"]
    stat = tmp_path / "stat"
    stat.write_text("17 (a) b) " + " ".join(fields))
    monkeypatch.setattr(keys, "Path", lambda name: stat if name == "/proc/self/stat" else Path(name))
    monkeypatch.setattr(
        keys, "time", SimpleNamespace(time=lambda: 1000.0, clock_gettime=lambda _: 140.0, CLOCK_BOOTTIME=7)
    )
    monkeypatch.setattr(keys, "_IMPORTED", 950.0)
    assert keys.process_start() == 900.0
    monkeypatch.setattr(keys, "_IMPORTED", 850.0)
    assert keys.process_start() == 850.0
    for text in ("", "17 (a) S 4 5", "17 (a) " + " ".join(["x"] * 25)):
        stat.write_text(text)
        assert keys.process_start() == 850.0
    stat.unlink()
    assert keys.process_start() == 850.0


def test_the_key_does_not_hang_on_the_order_of_its_parts() -> None:
    assert keys._canonical({"b": 1, "a": [1, {"d": 2, "c": 3}]}) == '{"a":[1,{"c":3,"d":2}],"b":1}'
