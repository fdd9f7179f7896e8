from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from gspot_verified.cli import main
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.paper.cache import Cache
from gspot_verified.paper.checks.entry import Entry
from gspot_verified.paper.claims import Standing
from gspot_verified.report.hard_cases import NONE


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


@pytest.mark.parametrize("arguments", [("1-2i", "7/3"), ("1-2j", "7/3", "--digits", "15"), ("--", "1 - 2i", "7/3")])
def test_theta_at_complex_tau(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...]) -> None:
    code, output, errors = run(capsys, "theta", *arguments)
    assert (code, errors) == (0, "")
    assert output == "[0.155047765840013 +/- 3.36e-16] + [-6.81306014356076 +/- 5.85e-16]i\n"


def test_complex_numbers_that_begin_with_a_minus(capsys: pytest.CaptureFixture[str]) -> None:
    for negative, positive in (("-i", "i"), ("-1/2-3i", "-1/2+3i"), ("-2.5j", "2.5j")):
        code, output, _ = run(capsys, "theta", negative, "7/3", "--json")
        assert code == 0
        below, above = json.loads(output), json.loads(run(capsys, "theta", positive, "7/3", "--json")[1])
        assert Dyadic.parse(below["enclosure"]["real"]).overlaps(Dyadic.parse(above["enclosure"]["real"]))
        sides = {Dyadic.parse(data["enclosure"]["imaginary"]).sign() for data in (below, above)}
        assert sides == {1, -1}


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
        (("theta", "1+2k", "1"), "tau: expected a number"),
        (("theta", "infi", "1"), "tau: expected a complex number"),
        (("theta", "1e13i", "1"), "tau: the library covers"),
        (("theta", "1+2i", "2i"), "beta: expected a number"),
        (("theta", "1e9+i", "1/2"), "no route reaches"),
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
    assert "[1/2, 1): Γ(-β) < 0; Cases I and II, by the paper's rule as ε → 0: C1 < 0 takes an IWC," in output
    assert "C1 > 0 lifts off" not in output.splitlines()[0]
    assert "β = 1, 2, 3, 4" in output
    code, output, _ = run(capsys, "side", "-2", "--json")
    assert code == 0
    assert json.loads(output)["intervals"][0]["sign"] == 1


def test_verify_and_report(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    ledger_cache: Cache,
    whole_ledger: list[Entry],
) -> None:
    # The catalogue of hard cases has tests of its own, one for each row.
    monkeypatch.setattr("gspot_verified.report.write.hard_cases", lambda _: NONE)
    code, output, errors = run(capsys, "verify", "--output", str(tmp_path), "--cache", str(ledger_cache.folder))
    assert code == 1  # the paper has misprints
    assert "refuted" in output
    assert "corrected:" in output
    assert "Appendix A" in errors
    assert re.search(r"^proved: .*\d+ on exact identity or certificate, \d+ on proof page", output, re.M)
    assert re.search(r"^refuted: .*\d+ on exact identity or certificate", output, re.M)
    assert re.search(r"^\d+ of \d+ rest on a proof page alone", output, re.M)
    assert re.search(r"^proved: (\d+) of (\d+): ", output, re.M)
    standings = ", ".join(rf"\d+ {standing.value}" for standing in Standing)
    assert re.search(rf"^of the paper's \d+ claims: {standings}$", output, re.M)
    # A source that was changed since the tests began closes the cache: then all is run again.
    whole = len(whole_ledger)
    assert re.search(rf"^run now: (all {whole}$|0 of {whole}; cached .*: {whole} of {whole} )", output, re.M)
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert data["counts"]["undecided"] == 0
    assert "misprint" in page.lower() or "refuted" in page.lower()
    (tmp_path / "index.html").unlink()
    code, output, _ = run(capsys, "report", str(tmp_path / "report.json"), "--output", str(tmp_path))
    assert code == 0
    assert (tmp_path / "index.html").read_text(encoding="utf-8") == page
    code, output, _ = run(capsys, "report", "--check", str(tmp_path))
    assert code == 0
    assert output.count("verified   ") == output.count("VERIFIED ") == len(data["certificates"]) > 3
    (tmp_path / "certificates" / "iwc_0_1.cert").write_text("{}")
    code, output, _ = run(capsys, "report", "--check", str(tmp_path))
    assert code == 1
    assert "FAILED     iwc_0_1.cert  another file than the report names" in output


def test_a_check_of_no_report(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _, errors = run(capsys, "report", "--check", str(tmp_path))
    assert code == 64
    assert "there is no file" in errors


@pytest.mark.parametrize("command", [(), ("theta",), ("side",), ("verify",), ("report",), ("cost",)])
def test_help_has_an_example(capsys: pytest.CaptureFixture[str], command: tuple[str, ...]) -> None:
    code, output, _ = run(capsys, *command, "--help")
    assert code == 0
    if command:
        assert "\n  Example:\n    gspot-verified " in output


def test_the_examples_in_the_help_run() -> None:
    for arguments in (["theta", "--", "-50", "7/3", "--digits", "100"], ["side", "1/2", "4"]):
        command = [sys.executable, "-c", "from gspot_verified.__main__ import run; run()", *arguments]
        done = subprocess.run(command, capture_output=True, check=False)
        assert done.returncode == 0
        assert done.stdout


@pytest.mark.parametrize("error", [ArithmeticError("two enclosures are disjoint"), TypeError("'NoneType' object")])
def test_an_internal_error_is_never_an_outcome_nor_wrong_usage(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, error: Exception
) -> None:
    from gspot_verified.paper import verify

    def broken(*_: object) -> list[object]:
        raise error

    monkeypatch.setattr(verify, "verify_paper", broken)
    code, output, errors = run(capsys, "verify", "--output", str(tmp_path))
    assert code == 70
    assert output == ""
    assert f"internal error, please report it: {type(error).__name__}: {error}" in errors


def test_a_worker_that_is_ended_from_outside_is_no_internal_error(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where the memory is too small: nothing is to be reported. Two workers that end at their first cell."""
    monkeypatch.setattr("gspot_verified.mechanisms.sweep.sweep.portions", lambda _: iter([_Killing()]))
    code, output, errors = run(capsys, "sweep", "oscillator", "--over", "beta=2..4:4", "--workers", "2")
    assert (code, output) == (70, "")
    assert "error: a worker process was ended from outside (killed, or out of memory); with fewer workers" in errors
    assert "report" not in errors


class _Killing:
    """A portion of cells that ends the process in which it is unpacked."""

    def __reduce__(self) -> tuple[Callable[[int], None], tuple[int]]:
        return os._exit, (1,)


def test_a_stream_without_greek_letters() -> None:
    command = [sys.executable, "-c", "from gspot_verified.__main__ import run; run()", "side", "1/2", "2"]
    environment = {**os.environ, "PYTHONIOENCODING": "cp1252"}
    done = subprocess.run(command, capture_output=True, check=False, env=environment)
    assert done.returncode == 0
    assert b"lifts off" in done.stdout


@pytest.mark.parametrize("arguments", [["--version"], ["side", "1/2"], ["theta", "1"]])
def test_python_dash_m_is_the_same_program(capsys: pytest.CaptureFixture[str], arguments: list[str]) -> None:
    done = subprocess.run([sys.executable, "-m", "gspot_verified", *arguments], capture_output=True, check=False)
    assert done.returncode == main(arguments)
    assert done.stdout.decode() == capsys.readouterr().out


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    import tomllib

    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert run(capsys, "--version") == (0, f"gspot-verified {project['version']}\n", "")


def test_long_work_is_not_silent(capsys: pytest.CaptureFixture[str]) -> None:
    """Heavy requests such as `theta 1000000 7/3 --digits 100000` said nothing for minutes."""
    from gspot_verified.cli.app import signs_of_life

    with signs_of_life(0.001):
        seen = ""
        while seen.count("... at work for") < 2:
            output, errors = capsys.readouterr()
            assert output == ""
            seen += errors
    alive = threading.active_count()
    with signs_of_life(1000.0):
        assert threading.active_count() == alive + 1
    assert threading.active_count() == alive
    assert capsys.readouterr() == ("", "")


def test_every_command_works_under_the_signs_of_life(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from gspot_verified.signs.gamma import side

    monkeypatch.setattr(side, "side", lambda *_: threading.enumerate())
    assert run(capsys, "side", "1/2")[0] == 70  # a list has no verdict: internal
    names: list[list[threading.Thread]] = []
    monkeypatch.setattr(side, "side", lambda *_: names.append(threading.enumerate()))
    run(capsys, "side", "1/2")
    assert any(thread.daemon for thread in names[0])


@pytest.mark.parametrize("command", ["expand", "classify"])
def test_a_mechanism_that_is_neither_file_nor_name(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, command: str
) -> None:
    for name, words in (("nothing", "there is no file 'nothing'"), ("", "there is no file ''"),
                        (str(tmp_path), f"{tmp_path} is a folder")):  # fmt: skip
        code, output, errors = run(capsys, command, name)
        assert (code, output) == (64, "")
        assert words in errors
        assert "model; extended; oscillator; rod; model system;" in errors


def test_check_of_a_folder(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    for name, words in ((str(tmp_path), "is a folder, not a certificate"), (str(tmp_path / "x"), "there is no file")):
        code, _, errors = run(capsys, "check", name)
        assert code == 64
        assert words in errors


@pytest.mark.parametrize("name", ["missing.json", "."])
def test_report_of_no_file(capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str) -> None:
    code, _, errors = run(capsys, "report", str(tmp_path / name), "--output", str(tmp_path))
    assert code == 64
    assert "SOURCE: there is no file" in errors


LONG = "1" + "0" * 4999 + "7"
"""More digits than CPython prints or reads."""


@pytest.mark.parametrize(
    "arguments",
    [
        ("side", f"-{LONG}/{LONG[:-1]}1", "1"),
        ("theta", "1/3", f"1/{LONG}"),
        ("sign", "--tau", "1..2", "--beta", f"1/{LONG}"),
        ("zeros", "--beta", f"1/{LONG}"),
        ("iwc", "--beta", f"1/{LONG}"),
        ("classify", "extended", "--set", f"alpha_3=-{LONG}"),
        ("expand", "extended", "--order", "3", "--chi", LONG),
    ],
)
@pytest.mark.parametrize("form", [(), ("--json",)])
def test_numbers_longer_than_cpython_prints(
    capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], form: tuple[str, ...]
) -> None:
    code, output, errors = run(capsys, *arguments, *form)
    assert code == 0
    assert "Exceeds the limit" not in errors
    assert output
    if form:
        json.loads(output)


def test_the_typeset_minus_on_the_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "theta", "−3", "−1/2") == run(capsys, "theta", "-3", "-1/2")
    assert run(capsys, "sign", "--tau", "−inf..0", "--beta", "−1/2") == run(
        capsys, "sign", "--tau", "-inf..0", "--beta", "-1/2"
    )
    assert (
        run(capsys, "classify", "extended", "--set", "alpha_3=−5/2")[1]
        == (run(capsys, "classify", "extended", "--set", "alpha_3=-5/2")[1])
    )


def test_very_many_digits_are_announced_before_the_work(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    found = run(capsys, "theta", "0", "1", "--digits", "20000")
    assert "... 20000 digits, route splitting: about 1 s on one core, roughly\n" in found[2]
    assert run(capsys, "theta", "0", "1", "--digits", "100")[2] == ""
    assert "20000 digits: this may take minutes; there is no" in run(capsys, "theta", "0i", "1", "--digits", "20000")[2]
    monkeypatch.setattr("gspot_verified.theta_function.value.effort.expected_effort", lambda *_: None)
    found = run(capsys, "theta", "7/3333333333333333333331", "22/71234567891234567", "--digits", "1000000")
    assert "1000000 digits: this may take minutes; there is no estimate for these arguments" in found[2]
    assert found[0] == 64
