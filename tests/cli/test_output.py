"""Files that commands write: refused before the work where they cannot be, and never a reason to lose the result."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any

import pytest
import typer
from full_disk import full_after

# Imported before anything is replaced: modules that take a name from another must take the true one.
from gspot_verified.cli import main
from gspot_verified.cli.output import Outputs
from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.paper.section_4_5 import cases

SCENE = """
format = 1
name = "own"
effects = ["compliant_contact", "lift_off"]
epsilon = "1/5"
until = "1/10"
start = {p = "1/2", nu = 2}
"""
POINT = ("--tau", "[0..1]", "--beta", "1/2")


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(list(arguments))
    captured = capsys.readouterr()
    return code, captured.out, captured.err


@pytest.fixture
def no_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every piece of work that a command may start fails the test."""

    def started(*_: Any, **__: Any) -> None:
        raise AssertionError("the work was started")

    for place in (
        "signs.cover.sign.sign",
        "signs.zeros.zeros.zeros_on_range",
        "signs.zeros.brackets.zeros_at",
        "compliant.zeros.zero_map.zero_map",
        "mechanisms.expand.expand",
        "paper.verify.verify_paper",
        "report.write.render_report",
        "cost.benchmarks.theta.run",
    ):
        monkeypatch.setattr(f"gspot_verified.{place}", started)


COMMANDS = [
    ("--certificate", ("sign", *POINT)),
    ("--journal", ("sign", *POINT)),
    ("--certificate", ("zeros", "--beta", "1..2")),
    ("--certificate", ("zeros", "--beta", "7/3")),
    ("--journal", ("zeros", "--beta", "1..2")),
    ("--picture", ("zeros", "--beta", "1..2")),
    ("--picture", ("expand", "extended")),
    ("--picture", ("cost", "theta")),
    ("--output", ("verify",)),
]


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize(("option", "command"), COMMANDS)
def test_paths_are_checked_before_the_work(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, option: str, command: tuple[str, ...]
) -> None:
    (tmp_path / "file.png").write_text("good")
    missing = tmp_path / "missing" / "x.png"
    for path, message in (
        (missing, f"{option}: there is no folder {missing.parent}"),
        (tmp_path / "file.png" / "x.png", f"there is no folder {tmp_path / 'file.png'}"),
    ):
        code, out, err = run(capsys, *command, option, str(path))
        assert (code, out) == (64, "")
        assert message in err
    assert not missing.parent.exists()
    if option == "--output":
        code, out, err = run(capsys, *command, option, str(tmp_path / "file.png"))
        assert "is a file, not a folder" in err
    else:
        code, out, err = run(capsys, *command, option, str(tmp_path))
        assert f"{option}: {tmp_path} is a folder, not a file" in err
    assert (code, out) == (64, "")
    assert (tmp_path / "file.png").read_text() == "good"


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize("name", ["atlas.xyz", "atlas", "atlas.jpg", "atlas.png.txt"])
@pytest.mark.parametrize("command", [("zeros", "--beta", "1..2"), ("expand", "extended"), ("cost", "theta")])
def test_a_picture_of_an_unknown_kind_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, command: tuple[str, ...], name: str
) -> None:
    code, out, err = run(capsys, *command, "--picture", str(tmp_path / name))
    assert (code, out) == (64, "")
    assert "allowed: .png, .pdf, .svg" in err
    suffix = Path(name).suffix
    path = tmp_path / name
    assert (f"the suffix {suffix!r} of {path};" if suffix else f"cannot write {path} without a suffix;") in err
    assert not list(tmp_path.iterdir())


@pytest.mark.usefixtures("no_work")
def test_two_outputs_with_one_name_are_refused(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    same = str(tmp_path / "x")
    code, _, err = run(capsys, "sign", *POINT, "--certificate", same, "--journal", same)
    assert code == 64
    assert "--journal and --certificate name the same file" in err


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize("row", [0, 2])
def test_the_journal_of_a_row_is_no_certificate(capsys: pytest.CaptureFixture[str], tmp_path: Path, row: int) -> None:
    asked = ("--beta", "9/2..37/8", "--epsilon", "0..1", "--journal", str(tmp_path / "J"))
    code, _, err = run(capsys, "zeros", *asked, "--certificate", str(tmp_path / f"J.{row}"))
    assert code == 64
    assert "--journal and --certificate name the same file" in err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "command", "option"),
    [
        (SCENE, ("simulate", "FILE"), "--certificate"),
        (shipped_text("oscillator"), ("iwc", "--mechanism", "FILE"), "--certificate"),
        (shipped_text("oscillator"), ("sweep", "FILE", "--over", "beta=9/4..11/4:1"), "--csv"),
    ],
)
def test_what_a_command_reads_it_does_not_replace(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, command: tuple[str, ...], option: str
) -> None:
    own = tmp_path / "own.toml"
    own.write_text(text, encoding="utf-8")
    before = own.read_bytes()
    words = [str(own) if word == "FILE" else word for word in command]
    code, out, err = run(capsys, *words, option, str(tmp_path / "." / "own.toml"))
    assert (code, out) == (64, "")
    assert f"{option}: {own} is what the command reads" in err
    assert own.read_bytes() == before


@pytest.mark.usefixtures("no_work")
def test_a_device_is_no_place_for_a_certificate(capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "sign", *POINT, "--certificate", os.devnull)
    assert code == 64
    assert "not an ordinary file" in err


@pytest.mark.usefixtures("no_work")
def test_a_folder_that_cannot_be_written_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    code, _, err = run(capsys, "sign", *POINT, "--certificate", str(tmp_path / "x"))
    assert code == 64
    assert "cannot be written" in err


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize("option", ["--certificate", "--journal"])
def test_a_file_system_that_takes_no_file_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, option: str
) -> None:
    """The rights are there, and yet no file can be: a full disk, or one that nobody writes."""

    def none(**_: Any) -> None:
        raise OSError(30, "Read-only file system")

    monkeypatch.setattr(tempfile, "TemporaryFile", none)
    code, _, err = run(capsys, "sign", *POINT, option, str(tmp_path / "x"))
    assert code == 64
    assert f"{option}: the folder {tmp_path} cannot be written: Read-only file system" in err


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="no /proc on this system")
@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize("place", ["/proc", "/proc/report"])
def test_a_report_in_a_place_without_files_is_refused(capsys: pytest.CaptureFixture[str], place: str) -> None:
    code, out, err = run(capsys, "verify", "--output", place)
    assert (code, out) == (64, "")
    assert "--output: the folder /proc cannot be written" in err


def test_a_folder_that_is_there_is_taken_if_it_can_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    Outputs().folder("--output", tmp_path)
    Outputs().folder("--output", tmp_path / "new")
    monkeypatch.setattr(os, "access", lambda folder, _: folder != tmp_path)
    for path in (tmp_path, tmp_path / "new"):
        with pytest.raises(ValueError, match=f"--output: the folder {tmp_path} cannot be written"):
            Outputs().folder("--output", path)


def test_what_was_written_and_what_was_not(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    for write, code in ((lambda: None, 2), (full, 74)):
        outputs = Outputs()
        assert outputs.write("--certificate", tmp_path / "x", write) is (code == 2)
        with pytest.raises(typer.Exit) as left:
            outputs.leave(2)
        assert left.value.exit_code == code
    assert "NOT written" in capsys.readouterr().err


def full(*_: Any, **__: Any) -> None:
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize(
    ("option", "name", "writer", "command", "outcome"),
    [
        ("--certificate", "x.cert", "certificates.text.write_certificate", ("sign", *POINT), "proved"),
        ("--certificate", "x.cert", "certificates.text.write_certificate", ("zeros", "--beta", "5/2"), "2 real zeros"),
        (
            "--picture",
            "x.png",
            "report.pictures.expansion_picture.save_expansion",
            ("expand", "extended", "--order", "3"),
            "lambda_n",
        ),
    ],
)
def test_the_result_outlives_a_full_disk(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    option: str,
    name: str,
    writer: str,
    command: tuple[str, ...],
    outcome: str,
) -> None:
    assert run(capsys, *command)[0] == 0
    monkeypatch.setattr(f"gspot_verified.{writer}", full)
    code, out, err = run(capsys, *command, option, str(tmp_path / name))
    assert code == 74
    assert outcome in out
    assert "certificate of" not in out
    assert f"{option}: {tmp_path / name} was NOT written: [Errno 28]" in err


@pytest.mark.parametrize(
    ("command", "written", "outcome"),
    [
        (("sign", "--tau", "[0..1]", "--beta", "[1/3..1/2]"), "", "proved"),
        (("zeros", "--beta", "9/4..5/2"), "", "exactly N real zeros"),
        (("zeros", "--beta", "17/4..35/8", "--eps", "1/10"), ".0", "proved"),
        (("sweep", "oscillator", "--over", "beta=9/4..11/4:1"), "", "proved"),
    ],
)
@pytest.mark.parametrize("room", [0, 230])
def test_a_journal_on_a_full_disk_is_dropped(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, command: tuple[str, ...],
    written: str, outcome: str, room: int,
) -> None:  # fmt: skip
    """Full before the first line, or in the midst of it."""
    whole = run(capsys, *command)
    assert whole[0] == 0
    journal = tmp_path / "kept"
    full_after(room, Path(f"{journal}{written}"), monkeypatch)
    code, out, err = run(capsys, *command, "--journal", str(journal))
    assert (code, out) == (74, whole[1])
    assert outcome in out
    assert err.count(f"warning: --journal: the journal {journal}{written} could not be written: [Errno 28]") == 1
    monkeypatch.undo()
    assert run(capsys, *command, "--journal", str(journal))[:2] == whole[:2]


def test_parts_of_a_measurement_on_a_full_disk(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from gspot_verified.cost.measurement.measurement import Part

    def measured(_: bool, __: object, kept: Any) -> Any:
        kept.keep(Part(key="a", title="", question="", axis="", symbol="", routes=()))
        raise KeyboardInterrupt

    monkeypatch.setattr("gspot_verified.cost.run.measure_cost", measured)
    parts = tmp_path / "cost.json.parts"
    full_after(0, parts, monkeypatch)
    code, _, err = run(capsys, "cost", "--output", str(tmp_path / "cost.json"))
    assert code == 130
    assert f"warning: --output: the journal {parts} could not be written" in err


def test_other_warnings_are_shown_as_they_are(capsys: pytest.CaptureFixture[str]) -> None:
    outputs = Outputs()
    with pytest.warns(UserWarning, match="another"), outputs.journal(None):
        warnings.warn("another", stacklevel=1)
    assert capsys.readouterr() == ("", "")
    with pytest.raises(typer.Exit) as left:
        outputs.leave(0)
    assert left.value.exit_code == 0


def test_a_number_too_long_for_a_certificate_leaves_the_result(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def long(*_: Any) -> str:
        raise ValueError("a certificate holds numbers of at most 4000 digits")

    monkeypatch.setattr("gspot_verified.certificates.text.certificate_text", long)
    code, out, err = run(capsys, "sign", *POINT, "--certificate", str(tmp_path / "x"), "--json")
    assert code == 74
    assert json.loads(out)["verdict"]["outcome"] == "proved"
    assert "at most 4000 digits" in err
    assert not list(tmp_path.iterdir())


def test_a_report_that_cannot_be_written_leaves_the_verdicts(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    entries = [cases.ENTRIES["S-iwc"]()]
    monkeypatch.setattr("gspot_verified.paper.verify.verify_paper", lambda *_: entries)
    monkeypatch.setattr("gspot_verified.report.write.write_report", full)
    code, out, err = run(capsys, "verify", "--output", str(tmp_path / "report"))
    assert code == 74
    assert entries[0].label in out
    assert "report:" not in out
    assert "NOT written" in err


def test_no_certificate_of_what_is_not_proved(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "x.cert"
    path.write_text("an older one")
    code, _, err = run(
        capsys, "sign", "--tau", "-inf..inf", "--beta", "0..1", "--budget", "1", "--certificate", str(path)
    )
    assert code == 2
    assert "nothing was proved" in err
    assert path.read_text() == "an older one"


def test_a_full_stdout_is_no_outcome(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.signs.gamma.side.side", full)
    code, _, err = run(capsys, "side", "1/2")
    assert code == 74
    assert "No space left" in err


@pytest.mark.skipif(not hasattr(signal, "SIGPIPE"), reason="no SIGPIPE on this system")
def test_a_closed_pipe_ends_the_program_as_it_ends_others() -> None:
    """Exit code 1 would read as "refuted"."""
    command = [sys.executable, "-c", "from gspot_verified.__main__ import run; run()", "side", "0", "50000"]
    # An unbuffered stdout of Python takes a partial write for a whole one, and then there is nothing to notice.
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONUNBUFFERED"}
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert process.stdout.read(3)
        process.stdout.close()
        # On a machine that is busy the command may say that it is at work, and nothing else.
        said = process.stderr.read().decode().splitlines()
    assert [line for line in said if "at work for" not in line] == []
    assert process.returncode == -signal.SIGPIPE


@pytest.mark.parametrize("option", ["--journal", "--scheduler"])
def test_options_for_ranges_are_not_ignored_at_one_value(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, option: str
) -> None:
    code, _, err = run(capsys, "zeros", "--beta", "7/3", option, str(tmp_path / "x"))
    assert code == 64
    assert f"{option}: it needs a range" in err
