from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest

from gspot_verified.cli import main


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    output, errors = capsys.readouterr()
    return code, output, errors


@pytest.mark.parametrize(
    "tau", [("--tau=-inf..inf",), ("--tau", "-inf..inf"), ("--tau", "(-inf..inf)")], ids=["joined", "apart", "brackets"]
)
def test_a_range_that_begins_with_a_minus(capsys: pytest.CaptureFixture[str], tau: tuple[str, ...]) -> None:
    code, output, _ = run(capsys, "sign", *tau, "--beta", "0..1")
    assert code == 0
    assert output.startswith("proved: dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)")


@pytest.mark.parametrize(
    ("arguments", "code", "word"),
    [
        (("--tau", "-inf..0", "--beta", "[3..4]"), 0, "proved"),
        (("--tau", "-1..1", "--beta", "2..3"), 1, "refuted"),
        (("--tau", "1", "--beta", "3", "--positive"), 1, "refuted"),
        (("--tau", "-inf..inf", "--beta", "-2..-1", "--positive"), 0, "proved"),
        (("--tau", "-inf..inf", "--beta", "0..1", "--by-theorem"), 0, "proved"),
        (("--tau", "-inf..inf", "--beta", "0..1", "--budget", "0"), 2, "undecided"),
        (("--tau", "1e9..inf", "--beta", "2..3", "--budget", "5"), 2, "undecided"),
    ],
)
def test_sign_exit_codes(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], code: int, word: str) -> None:
    found, output, _ = run(capsys, "sign", *arguments)
    assert found == code
    assert output.startswith(word)
    found, output, _ = run(capsys, "sign", *arguments, "--json")
    assert found == code
    assert json.loads(output)["verdict"]["outcome"] == word


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("sign", "--tau", "1..0", "--beta", "0..1"), "tau: the range is reversed"),
        (("sign", "--tau", "[0..inf]", "--beta", "0..1"), "tau: a range must be open"),
        (("sign", "--tau", "0..1", "--beta", "nan"), "beta: expected a number"),
        (("sign", "--tau", "0..1", "--beta", "0...5"), "beta: expected a range"),
        (("sign", "--tau", "0..1"), "--beta"),
        (("sign", "--tau", "0..1", "--beta", "0..1", "--budget", "-1"), "budget"),
        (("sign", "--tau", "0..1", "--beta", "0..1", "--workers", "0"), "workers"),
        (("sign", "--tau", "0..1", "--beta", "0..1", "--sing"), "No such option"),
        (("zeros", "--beta", "3", "--picture", "x.png"), "--picture: it needs a range"),
        (("zeros", "--beta", "3", "--certificate", "x.cert"), "no certificate is made"),
        (("zeros", "--beta", "-1..1"), "must lie inside"),
        (("zeros", "--beta", "0..inf"), "must lie inside"),
        (("zeros", "--beta", "5/2", "--digits", "0"), "digits"),
        (("zeros", "--beta", "5/2", "--digits", "5000"), "digits"),
        (("check", "no-such-file.cert"), "there is no file"),
        (("check",), "Missing argument"),
    ],
)
def test_bad_usage(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str) -> None:
    code, output, errors = run(capsys, *arguments)
    assert code == 64
    assert output == ""
    assert message in errors


@pytest.mark.parametrize(
    "arguments",
    [
        ("sign", "--tau=-inf..inf", "--beta", "0..1"),
        ("sign", "--tau", "3..4", "--beta", "1.1..1.2"),
        ("sign", "--tau", "0", "--beta", "3"),
        ("sign", "--tau", "1", "--beta", "3"),
        ("zeros", "--beta", "2..5/2"),
        ("zeros", "--beta", "7/3", "--digits", "20"),
        ("zeros", "--beta", "299/100", "--digits", "5"),
    ],
)
def test_certificates_are_verified(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, arguments: tuple[str, ...]
) -> None:
    path = tmp_path / "a.cert"
    code, _, _ = run(capsys, *arguments, "--certificate", str(path))
    assert code in (0, 1)
    code, output, _ = run(capsys, "check", str(path))
    assert code == 0
    assert output.startswith("VERIFIED ")
    code, output, _ = run(capsys, "check", str(path), "--json")
    assert code == 0
    assert json.loads(output)["verified"] is True
    path.write_bytes(path.read_bytes().replace(b'"version":1', b'"version":2'))
    code, output, errors = run(capsys, "check", str(path))
    assert code == 1
    assert output == ""
    assert errors.startswith("REJECTED ")


def test_nothing_is_written_when_nothing_is_shown(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "a.cert"
    for arguments in (("sign", "--tau", "1e9..inf", "--beta", "2..3"), ("zeros", "--beta", "2..4")):
        code, _, _ = run(capsys, *arguments, "--budget", "3", "--certificate", str(path))
        assert code == 2
        assert not path.exists()


def test_zeros(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, errors = run(capsys, "zeros", "--beta", "2..7/2")
    assert code == 0
    assert "N = 2 on (2, 3)" in output
    assert "ranges of β examined" in errors
    code, output, _ = run(capsys, "zeros", "--beta", "2..7/2", "--json")
    assert json.loads(output)["statement"]["counts"] == [[2, 2], [3, 1]]
    code, output, _ = run(capsys, "zeros", "--beta", "5/2", "--digits", "8", "--json")
    assert code == 0
    assert json.loads(output)["number"] == 2
    code, output, errors = run(capsys, "zeros", "--beta", "2..5", "--budget", "2")
    assert code == 2
    assert "\nundecided by columns: " in output
    assert errors.startswith("... by the count law, for every β in (2, 5)")


def test_zeros_above_the_reach_of_columns(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "a.cert"
    code, output, _ = run(capsys, "zeros", "--beta", "300..301")
    assert code == 0
    assert "N = 100 on (300, 301)\n  route: the count law" in output
    code, output, errors = run(capsys, "zeros", "--beta", "300..301", "--certificate", str(path))
    assert (code, output) == (64, "")
    assert "no column is sought for β > 200" in errors
    assert not path.exists()
    code, output, _ = run(capsys, "zeros", "--beta", "403/2")
    assert (code, output.splitlines()[0]) == (0, "β = 403/2: 67 different real zeros of dΘ/dτ")
    for beta, number in (("403/2", 67), ("1000", 333), ("1001", 334), ("1e4", 3333)):
        code, output, _ = run(capsys, "zeros", "--beta", beta, "--json")
        assert (code, json.loads(output)["number"], json.loads(output)["route"]) == (0, number, "the count law")
    code, _, errors = run(capsys, "zeros", "--beta", "403/2", "--certificate", str(path))
    assert code == 64
    assert "no column is sought" in errors


def test_zeros_say_where_tubes_are_found(capsys: pytest.CaptureFixture[str]) -> None:
    _, _, errors = run(capsys, "zeros", "--beta", "5/2..11/4")
    assert "β in [5/2, 11/4]: 2 tubes" in errors


def test_zeros_that_stay_open_are_undecided(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from gspot_verified.signs.zeros import brackets

    monkeypatch.setattr(brackets, "_changes", lambda *_: [])
    monkeypatch.setattr(brackets, "zero_column", lambda *_: None)
    code, output, errors = run(capsys, "zeros", "--beta", "5/2")
    assert code == 2
    assert output == ""
    assert errors.startswith("undecided: no certain column")


def test_a_journal_is_gone_on_with(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "journal"
    first = run(capsys, "zeros", "--beta", "2..7/2", "--budget", "9", "--journal", str(path))
    assert first[0] == 2
    assert len(path.read_text().splitlines()) == 10
    second = run(capsys, "zeros", "--beta", "2..7/2", "--journal", str(path))
    assert second[0] == 0
    assert run(capsys, "zeros", "--beta", "2..4", "--journal", str(path))[0] == 64


@pytest.mark.parametrize("command", ["sign", "zeros", "check"])
def test_the_example_in_the_help_runs(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.chdir(tmp_path)
    if command == "check":  # its example reads what the example of `sign` writes
        assert run(capsys, "sign", "--tau=-inf..inf", "--beta", "0..1", "--certificate", "iwc.cert")[0] == 0
    code, output, _ = run(capsys, command, "--help")
    assert code == 0
    words = shlex.split(output.split("Example:\n    gspot-verified ")[1])
    assert words[0] == command
    code, output, _ = run(capsys, *words)
    assert code == 0
    assert output


def test_zeros_at_finite_epsilon(capsys: pytest.CaptureFixture[str]) -> None:
    code, output, _ = run(capsys, "zeros", "--beta", "5.95", "--eps", "0.1", "--digits", "6")
    assert code == 0
    assert output.startswith("proved: the number of real zeros T = t/ε (p = −t) of λ − λ̄ on the slow manifold of the ")
    assert "β = 119/20, ε = 1/10: 1 (for Θ (ε → 0): 3)" in output
    code, output, _ = run(capsys, "zeros", "--beta", "5", "--eps", "32", "--json")
    assert (code, json.loads(output)["number"]) == (0, 1)
    code, output, errors = run(capsys, "zeros", "--beta", "17/4..35/8", "--eps", "1", "--json")
    stretch = {"beta": ["17/4", "35/8"], "fold_inside": False, "numbers": [2]}
    assert (code, json.loads(output)["rows"][0]["stretches"]) == (0, [stretch])
    assert "1 settled" in errors
    code, output, _ = run(capsys, "zeros", "--beta", "17/4..35/8", "--eps", "1", "--budget", "0")
    assert (code, output.startswith("undecided")) == (2, True)
    assert run(capsys, "zeros")[0] == 64


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--eps", "0"), "epsilon: expected a number in"),
        (("--eps", "x"), "epsilon: expected a number"),
        (("--eps", "1", "--certificate", "x.cert"), "--certificate: with --epsilon it needs a range of β inside 4..5"),
        (("--beta", "4..5", "--eps", "1..2", "--certificate", "x.cert"), "it needs a range from 0 on"),
        (("--beta", "3..5", "--eps", "0..2", "--certificate", "x.cert"), "the range must lie inside [4, 5]"),
        (("--eps", "1", "--journal", "x"), "--journal: it needs a range"),
        (("--eps", "1..2"), "needs a range of β"),
        (("--eps", "1", "--picture", "x.png"), "--picture: it needs a range of β"),
        (("--eps", "1", "--digits", "0"), "digits"),
    ],
)
def test_zeros_at_finite_epsilon_refuses(
    capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], message: str
) -> None:
    code, output, errors = run(capsys, "zeros", "--beta", "5/2", *arguments)
    assert (code, output) == (64, "")
    assert message in errors


@pytest.mark.parametrize(
    ("arguments", "statement"),
    [
        (("--beta", "5/2", "--tau-start", "-2"), "λ > 0 for every τ in [-2, inf) and every ε in (0, 79/100]"),
        (("--beta", "7/3", "--c1=1", "--epsilon", "1e-3"), "λ < 0 at τ = 5309/1000 for every ε ≥ 1/1000"),
    ],
)
def test_certificates_of_the_force(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, arguments: tuple[str, ...], statement: str
) -> None:
    place = tmp_path / "force.cert"
    code, output, errors = run(capsys, "iwc", *arguments, "--certificate", str(place))
    assert code == 0
    [line] = [line for line in output.splitlines() if line.startswith("certificate of: ")]
    assert statement in line
    assert line.endswith(f": {place}")
    assert statement not in errors
    code, output, errors = run(capsys, "iwc", *arguments, "--certificate", str(place), "--json")
    assert json.loads(output)
    assert statement in errors
    code, output, _ = run(capsys, "check", str(place))
    assert code == 0
    assert statement in output


def test_no_certificate_beyond_theorem_c(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    place = tmp_path / "force.cert"
    code, output, errors = run(capsys, "iwc", "--beta", "13/2", "--certificate", str(place))
    assert (code, output) == (64, "")
    assert "beta: a certificate of the force needs 1 < beta < 5" in errors
    assert not place.exists()


def test_iwc_of_a_mechanism_in_balls(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Statements, but no certificate: it needs rational alphas."""
    code, output, _ = run(capsys, "iwc", "--mechanism", "genot_brogliato_rod")
    assert code == 0
    assert output.startswith("proved: at leading order, for all α1, α2, α3 in the balls, β = ")
    assert "C1 = -1: λ_N > 0 for every real τ" in output.splitlines()[0]
    path = tmp_path / "x.cert"
    code, output, errors = run(capsys, "iwc", "--mechanism", "genot_brogliato_rod", "--certificate", str(path))
    assert (code, output) == (64, "")
    assert "it needs rational alphas" in errors
    assert not path.exists()
