"""The command ``report --mechanism``: what is refused before the work, and the exit codes."""

from __future__ import annotations

import json
import os
import re
from importlib import resources
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from gspot_verified import mechanism_report
from gspot_verified.cli import main
from gspot_verified.cli.app import schema_name
from gspot_verified.cli.schema import schema_of
from gspot_verified.mechanisms.shipped import shipped_text

NO_G_SPOT = ("report", "--mechanism", "genot_brogliato_rod", "--set", "mu=13/10")


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(list(arguments))
    captured = capsys.readouterr()
    return code, captured.out, captured.err


@pytest.fixture
def no_work(monkeypatch: pytest.MonkeyPatch) -> None:
    def started(*_: object, **__: object) -> None:
        raise AssertionError("the work was started")

    monkeypatch.setattr("gspot_verified.report.mechanism.mechanism_report.report_on", started)


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--mechanism", "missing.toml"), "missing.toml: cannot be read: No such file or directory"),
        (("--mechanism", "nothing"), "there is no file 'nothing', and no shipped mechanism 'nothing'"),
        (("--mechanism", "."), ". is a folder, and no shipped mechanism"),
        (("--mechanism", "syntax.toml"), "syntax.toml: "),
        (("--mechanism", "scene.toml"), 'scene.toml: unknown key "mechanism"'),
        (("--mechanism", "binary.toml"), "binary.toml: not UTF-8 text"),
        (("--mechanism", "rod", "--set", "mu"), "--set: expected"),
        (("--mechanism", "rod", "--set", "nu=1"), "falling rod has no parameter 'nu'"),
        (("--mechanism", "rod", "--set", "mu=symbolic"), "rod: the report needs a number for mu"),
        (("--mechanism", "rod", "--from", "theta"), "--from: expected"),
        (("--mechanism", "rod", "--scene", "oscillator"), "the scene is of another mechanism"),
        (("--mechanism", "rod", "--scene", "missing.toml"), "no scene file 'missing.toml'"),
        (("--mechanism", "rod", "--from", "theta=1"), "give all components of the state, or all but the two"),
        (("--mechanism", "rod", "--from", "nu=1"), "'nu' is no component of the state"),
        (("--mechanism", "rod", "--check", "x"), "--check, --cost and --supplement are for the report on the paper"),
        (("--from", "p=1"), "--set, --from, --scene and --budget go with --mechanism"),
    ],
)
def test_what_is_refused(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("syntax.toml").write_text("format = = 1")
    Path("scene.toml").write_text('format = 1\nname = "x"\nmechanism = "rod"\n')
    Path("binary.toml").write_bytes(b"\xff\xfe")
    before = sorted(tmp_path.iterdir())
    code, out, err = run(capsys, "report", *arguments)
    assert (code, out) == (64, "")
    assert message in err
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.usefixtures("no_work")
def test_a_folder_that_cannot_be_written_is_refused_before_the_work(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("good")
    for place, message in (
        (tmp_path / "missing" / "x", "there is no folder"),
        (tmp_path / "file", "is a file, not a folder"),
    ):
        code, out, err = run(capsys, *NO_G_SPOT, "--output", str(place))
        assert (code, out) == (64, "")
        assert message in err
    monkeypatch.setattr(os, "access", lambda _, mode: not mode & os.W_OK)
    code, _, err = run(capsys, *NO_G_SPOT, "--output", str(tmp_path))
    assert code == 64
    assert "cannot be written" in err


def test_a_budget_is_a_number_of_boxes(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, err = run(capsys, *NO_G_SPOT, "--budget", "0", "--output", str(tmp_path / "out"))
    assert (code, out) == (64, "")
    assert "budget: expected a number of boxes, 1 or more" in err
    assert not list(tmp_path.iterdir())


def test_no_g_spot_is_exit_code_1_and_a_page(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, _ = run(capsys, *NO_G_SPOT)
    assert code == 1
    assert out.splitlines() == [
        "refuted    That there is a G-spot",
        f"page: {Path('mechanism_report') / 'mechanism.html'}",
    ]
    page = Path("mechanism_report/mechanism.html").read_text(encoding="utf-8")
    assert "No G-spot is described on this page" in page
    assert "every box of the region was excluded" in page


def test_its_json_satisfies_the_schema(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, _ = run(capsys, *NO_G_SPOT, "--json", "--output", str(tmp_path / "new"))
    assert code == 1
    schema = schema_of("report", schema_name("report"))
    data = json.loads(out)
    assert list(Draft202012Validator(schema).iter_errors(data)) == []
    assert data["exit_code"] == 1
    del data["sha256"]
    assert list(Draft202012Validator(schema).iter_errors(data)) != []


def test_a_search_that_ends_too_early_is_undecided(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    text = shipped_text("oscillator").partition("[g_spot.point]")[0]
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    words = ("--mechanism", str(tmp_path / "own.toml"), "--budget", "1", "--output", str(tmp_path / "out"))
    code, out, _ = run(capsys, "report", *words)
    assert code == 2
    assert out.startswith("undecided  All G-spots")
    page = (tmp_path / "out" / "mechanism.html").read_text(encoding="utf-8")
    assert '<span class="badge undecided">undecided</span>' in page
    assert '<span class="badge proved">' not in page


def test_a_page_that_cannot_be_written_after_the_work_is_exit_code_74(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("gspot_verified.report.mechanism.mechanism_report.write_pages", full)
    code, out, err = run(capsys, *NO_G_SPOT, "--output", str(tmp_path / "out"))
    assert code == 74
    assert "refuted    That there is a G-spot" in out
    assert "was NOT written" in err


@pytest.mark.usefixtures("no_work")
def test_what_is_read_is_not_replaced(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    files = {name: tmp_path / name for name in ("own.toml", "scene.toml", "g-spot-1.toml", "mechanism.toml")}
    for path in files.values():
        path.write_text(shipped_text("rod"), encoding="utf-8")
    scene = (resources.files("gspot_verified.scenes") / "data" / "rod.toml").read_text(encoding="utf-8")
    files["scene.toml"].write_text(re.sub(r"(?m)^mechanism = .*$", 'mechanism = "own.toml"', scene), encoding="utf-8")
    before = {path: path.read_bytes() for path in files.values()}
    for words in (
        ("--mechanism", "own.toml", "--scene", "scene.toml"),
        ("--mechanism", "g-spot-1.toml"),
        ("--mechanism", "folder/../mechanism.toml"),
    ):
        code, _, errors = run(capsys, "report", *words, "--output", ".")
        assert code == 64
        assert "is read, and the report would take its place" in errors
    assert {path: path.read_bytes() for path in files.values()} == before
    with pytest.raises(FileExistsError, match="is read"):
        mechanism_report("mechanism.toml", tmp_path)
