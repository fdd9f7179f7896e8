from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from gspot_verified.cli import main
from gspot_verified.dyadic import Dyadic


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


@pytest.mark.parametrize(
    "arguments",
    [
        ("theta", "--", "-50", "7/3", "--digits", "20"),
        ("theta", "-50", "7/3", "--digits", "20"),
        ("theta", "--digits", "20", "--", "-50", "7/3"),
        ("theta", "--digits=20", "-50", "7/3"),
        ("theta", "-50.0", "--digits", "20", "7/3"),
    ],
)
def test_theta_with_a_negative_argument(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...]) -> None:
    code, output, errors = run(capsys, *arguments)
    assert code == 0
    assert output.startswith("[9210.1042163477515727")
    assert errors == ""


def test_theta_json(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "theta", "1e6", "1/2", "--derivative", "2", "--json")
    data = json.loads(output)
    assert code == 0
    assert data["reached"] is True
    assert Dyadic.parse(data["enclosure"]).sign() == -1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("theta", "abc", "1"), "tau: expected a number"),
        (("theta", "1", "nan"), "beta: expected a number"),
        (("theta", "1", "1", "--digits", "0"), "digits must lie in"),
        (("theta", "1", "1", "--digits", "-5"), "digits must lie in"),
        (("theta", "1", "1", "--digits", "99999999999"), "digits must lie in"),
        (("theta", "1", "1", "--digits", "abc"), "--digits"),
        (("theta", "1e13", "1"), "tau: the library covers"),
        (("theta", "1"), "Missing argument"),
        (("theta", "1", "1", "1"), "extra argument"),
        (("theta", "1", "1", "--digit", "3"), "No such option"),
        (("side", "5", "1"), "reversed"),
        (("side", "0", "1e6000000"), "exponent"),
        (("nonsense",), "No such command"),
        (("report", "no-such-file.json"), "no-such-file.json"),
    ],
)
def test_bad_usage(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str) -> None:
    code, output, errors = run(capsys, *arguments)
    assert code == 64
    assert output == ""
    assert message in errors


def test_side(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "side", "1/2", "4")
    assert code == 0
    assert "[1/2, 1): Γ(-β) < 0; Cases I and II: only C1 < 0 occurs, it takes an IWC" in output
    assert "C1 > 0 lifts off" not in output.splitlines()[0]
    assert "β = 1, 2, 3, 4" in output
    code, output, _ = run(capsys, "side", "-2", "--json")
    assert code == 0
    assert json.loads(output)["intervals"][0]["sign"] == 1


def test_verify_and_report(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, output, errors = run(capsys, "verify", "--output", str(tmp_path))
    assert code == 1  # the paper has misprints
    assert "refuted" in output
    assert "corrected:" in output
    assert "Appendix A" in errors
    assert re.search(r"^proved: .*\d+ on exact identity or certificate, \d+ on proof page", output, re.M)
    assert re.search(r"^refuted: \d+ on exact identity or certificate", output, re.M)
    assert re.search(r"^\d+ of \d+ rest on a proof page alone", output, re.M)
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert data["counts"]["undecided"] == 0
    assert "misprint" in page.lower() or "refuted" in page.lower()
    (tmp_path / "index.html").unlink()
    code, output, _ = run(capsys, "report", str(tmp_path / "report.json"), "--output", str(tmp_path))
    assert code == 0
    assert (tmp_path / "index.html").read_text(encoding="utf-8") == page


@pytest.mark.parametrize("command", [(), ("theta",), ("side",), ("verify",), ("report",), ("cost",)])
def test_help_has_an_example(capsys: pytest.CaptureFixture[str], command: tuple[str, ...]) -> None:
    code, output, _ = run(capsys, *command, "--help")
    assert code == 0
    if command:
        assert "Example: gspot-verified" in output


def test_the_examples_in_the_help_run() -> None:
    for arguments in (["theta", "--", "-50", "7/3", "--digits", "100"], ["side", "1/2", "4"]):
        command = [sys.executable, "-c", "from gspot_verified.cli import run; run()", *arguments]
        done = subprocess.run(command, capture_output=True, timeout=60, check=False)
        assert done.returncode == 0
        assert done.stdout


def test_an_internal_error_is_never_an_outcome(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from gspot_verified.ledger import verify

    def broken(_: object) -> list[object]:
        raise ArithmeticError("two enclosures are disjoint")

    monkeypatch.setattr(verify, "verify_paper", broken)
    code, output, errors = run(capsys, "verify", "--output", str(tmp_path))
    assert code == 70
    assert output == ""
    assert "internal error" in errors


def test_a_stream_without_greek_letters() -> None:
    command = [sys.executable, "-c", "from gspot_verified.cli import run; run()", "side", "1/2", "2"]
    environment = {**os.environ, "PYTHONIOENCODING": "cp1252"}
    done = subprocess.run(command, capture_output=True, timeout=60, check=False, env=environment)
    assert done.returncode == 0
    assert b"lifts off" in done.stdout


@pytest.mark.parametrize("arguments", [["--version"], ["side", "1/2"], ["theta", "1"]])
def test_python_dash_m_is_the_same_program(capsys: pytest.CaptureFixture[str], arguments: list[str]) -> None:
    done = subprocess.run([sys.executable, "-m", "gspot_verified", *arguments], capture_output=True, check=False)
    assert done.returncode == main(arguments)
    assert done.stdout.decode() == capsys.readouterr().out


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    import tomllib

    project = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert run(capsys, "--version") == (0, f"gspot-verified {project['version']}\n", "")
