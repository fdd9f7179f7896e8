"""Journals that somebody wrote by hand, or that another version left: no answer becomes wrong, whatever stands in them.

Each kind of forgery, for each kind of work; and two runs on one journal.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gspot_verified.cli import main
from gspot_verified.compliant.zeros.zero_map import zero_map
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.cover import sign
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.signs.cover.sign import SignResult
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.cover.subdivision import proved_again
from gspot_verified.signs.cover.zero_column import zero_column
from gspot_verified.signs.zeros import zeros
from gspot_verified.signs.zeros.zeros import ZerosResult, zeros_on_range

Lines = list[list[Any]]
RANGE = ("-2..-1", "2..3")


def of_sign(path: Path, wanted: int = -1) -> SignResult:
    return sign_on_ranges(*RANGE, wanted, journal=path)


def written(path: Path) -> Lines:
    """The lines of a journal without its header."""
    return [json.loads(line) for line in path.read_text().splitlines()[1:]]


def forge(path: Path, lines: Lines) -> None:
    """The same header with other lines."""
    header = path.read_text().splitlines()[0]
    path.write_text("\n".join([header, *map(json.dumps, lines)]) + "\n")


def test_three_lines_made_by_hand_prove_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """dΘ/dτ < 0 does not hold on this range. One line cuts it, two show columns of one piece for the halves; no point
    against the statement is met at first, so that they would be the only evidence."""
    monkeypatch.setattr(sign, "find_witness", lambda *_: None)
    path, false = tmp_path / "journal", ("1..2", "9/4..5/2")
    whole = sign_on_ranges(*false)
    assert whole.verdict.outcome is Outcome.REFUTED
    sign_on_ranges(*false, budget=1, journal=path)
    halves = (["9/4", "19/8"], ["19/8", "5/2"])
    columns = [[*ends, {"column": ends, "pieces": [["sign", "1", "2", 1]]}] for ends in halves]
    forge(path, [["9/4", "5/2", None], *columns])
    found = sign_on_ranges(*false, journal=path)
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.sign_there == whole.sign_there == 1


@pytest.mark.parametrize(
    "pieces",
    [
        [["laplace", None, None, 0]],
        [["left", None, "-2", 0], ["right", "-2", None, 0]],
        [["left", None, "5", 0], ["right", "5", None, 0]],
        [["left", None, "-1", 0], ["sign", "-1", "1", 1], ["right", "1", None, 1]],
        [["right", "0", None, 0]],
        [["right", "1/3", None, 0]],
        [["right", "100000", None, 0]],
        [["right", "-1", None, 1]],
        [["fold", "-1", "1", 0]],
        [["sign", f"{k}/{10**200}", f"{k + 1}/{10**200}", 1] for k in range(3)],
        [["sign", "1/3", "1/2", 10**100]],
    ],
)
def test_zeros_from_a_forged_journal(tmp_path: Path, pieces: Lines) -> None:
    path, whole = tmp_path / "journal", zeros_on_range("2..5/2")
    zeros_on_range("2..5/2", budget=0, journal=path)
    forge(path, [["2", "5/2", {"column": ["2", "5/2"], "pieces": pieces}]])
    found = zeros_on_range("2..5/2", journal=path)
    assert found.statement == whole.statement
    assert found.columns == whole.columns
    assert zeros_on_range("2..5/2", journal=path) == whole  # the right column stands in the file now


def test_a_witness_from_a_journal_is_not_believed(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    whole = of_sign(path)
    assert whole.verdict.outcome is Outcome.PROVED
    forge(path, [["2", "3", {"witness": ["-3/2", "5/2"]}]])
    assert of_sign(path) == whole


def test_ranges_that_a_journal_calls_open_are_cut_and_then_examined(tmp_path: Path) -> None:
    path, whole = tmp_path / "journal", zeros_on_range("[5/2..5/2]")
    zeros_on_range("[5/2..5/2]", budget=0, journal=path)
    forge(path, [["5/2", "5/2", None]])
    assert zeros_on_range("[5/2..5/2]", journal=path) == whole


def damaged(lines: Lines) -> Iterator[Lines]:
    """Each end and each mark of each piece changed, pieces left out, doubled and in another order."""
    for i, (lower, upper, data) in enumerate(lines):
        if data is None or "column" not in data:
            continue
        pieces = data["pieces"]
        changes = [pieces[1:], pieces[:-1], pieces[::-1], [*pieces, *pieces]]
        for j, piece in enumerate(pieces):
            for k in (0, 1, 2, 3):
                value = ("monotone" if piece[0] == "sign" else "sign", "1/7", "5/3", -piece[3] or 1)[k]
                changes.append([*pieces[:j], [*piece[:k], value, *piece[k + 1 :]], *pieces[j + 1 :]])
            changes.append([*pieces[:j], *pieces[j + 1 :]])
        for changed in filter(None, changes):
            yield [*lines[:i], [lower, upper, {**data, "pieces": changed}], *lines[i + 1 :]]


def test_every_changed_piece_of_a_column_gives_the_same_answer(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    whole = of_sign(path)
    lines = written(path)
    tried = 0
    for changed in damaged(lines):
        forge(path, changed)
        assert of_sign(path) == whole
        tried += 1
    assert tried > 20


@pytest.mark.slow
def test_every_changed_piece_of_a_run_over_zeros_gives_the_same_answer(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    whole = zeros_on_range("2..7/2", journal=path)
    for changed in list(damaged(written(path)))[::5]:
        forge(path, changed)
        assert zeros_on_range("2..7/2", journal=path) == whole


RATIONALS = st.builds(fmpq, st.integers(-60, 60), st.integers(1, 12))
PIECES = st.lists(
    st.builds(ColumnPiece, st.sampled_from(Kind), st.none() | RATIONALS, st.none() | RATIONALS, st.integers(-2, 2)),
    min_size=1,
    max_size=12,
)


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(PIECES, st.sampled_from([(fmpq(2), fmpq(9, 4)), (fmpq(11, 4), fmpq(3)), (fmpq(7, 3), fmpq(7, 3))]))
def test_along_any_pieces_a_column_is_the_same(pieces: list[ColumnPiece], ends: tuple[fmpq, fmpq]) -> None:
    assert proved_again(zero_column, Column(*ends, tuple(pieces))) == zero_column(*ends)


def test_along_its_own_pieces_a_column_is_proved_with_no_box_that_stays_open(monkeypatch: pytest.MonkeyPatch) -> None:
    from gspot_verified.signs.cover.column_models import ColumnModels

    ends, asked = (fmpq(9, 2), fmpq(37, 8)), []
    whole = zero_column(*ends)
    assert whole is not None
    real = ColumnModels.changes

    def counted(models: ColumnModels, tau: fmpq, n: int) -> int | None:
        asked.append(tau)
        return real(models, tau, n)

    monkeypatch.setattr(ColumnModels, "changes", counted)
    assert zero_column(*ends, whole) == whole
    assert asked == [whole.pieces[-1].lower]


def of_zeros(path: Path) -> ZerosResult:
    return zeros_on_range("2..5/2", journal=path)


BEGIN: dict[str, Callable[[Path], Any]] = {
    "sign": of_sign,
    "zeros": of_zeros,
    "zeros at finite epsilon": lambda path: zero_map("17/4..35/8", "1/10", journal=path.with_suffix("")),
}


@pytest.mark.parametrize("kind", BEGIN)
def test_what_other_sources_left_is_refused(tmp_path: Path, kind: str) -> None:
    path, begin = tmp_path / "journal.0", BEGIN[kind]
    begin(path)
    head, *rest = path.read_text().splitlines(keepends=True)
    other = json.loads(head)
    other["sources"] = "0" * 64
    before = json.dumps(other, sort_keys=True) + "\n" + "".join(rest)
    path.write_text(before)
    with pytest.raises(ValueError, match="differs in: the sources of this package"):
        begin(path)
    del other["sources"]  # as earlier versions wrote it
    path.write_text(json.dumps(other, sort_keys=True) + "\n" + "".join(rest))
    with pytest.raises(ValueError, match="is not a journal of this question"):
        begin(path)


@pytest.mark.parametrize("garbage", [b"\x00" * 4096 + b"\n", bytes(range(11, 256)) * 8 + b"\n", b"[" * 100_000 + b"\n"])
def test_binary_garbage_is_refused_and_left(tmp_path: Path, garbage: bytes) -> None:
    path = tmp_path / "journal"
    whole = of_sign(path)
    data = path.read_bytes()
    path.write_bytes(data + garbage)
    with pytest.raises(ValueError, match="cannot be read"):
        of_sign(path)
    path.write_bytes(garbage)
    with pytest.raises(ValueError, match="is not a journal"):
        of_sign(path)
    assert path.read_bytes() == garbage
    path.write_bytes(data + garbage[:-1])  # not a whole line: as a kill leaves it
    assert of_sign(path) == whole


def test_every_truncation_gives_the_same_answer(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    whole = of_zeros(path)
    data = path.read_bytes()
    for length in range(0, len(data), len(data) // 20):
        path.write_bytes(data[:length])
        assert of_zeros(path) == whole


def test_a_huge_journal(tmp_path: Path) -> None:
    """Many lines of other ranges, one line of a million digits, a file that never ends."""
    path = tmp_path / "journal"
    whole = of_zeros(path)
    with path.open("a") as file:
        file.writelines(f'["{k}","{k + 1}",null]\n' for k in range(50_000))
    assert of_zeros(path) == whole
    with path.open("a") as file:
        file.write(json.dumps(["2", "5/2", {"witness": ["1" * 1_000_000, "2"]}]) + "\n")
    assert of_zeros(path) == whole
    with pytest.raises(ValueError, match="not a file"):
        of_zeros(Path("/dev/zero"))


HOLDER = """
import sys, time
from pathlib import Path
from gspot_verified.work.journal_file import JournalFile
import json
path = Path(sys.argv[1])
held = JournalFile(path, json.loads(path.read_text().splitlines()[0])["journal"])
print("held", flush=True)
time.sleep(600)
"""


def test_a_second_run_on_a_journal_is_refused_until_the_first_ends(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "journal"
    words = ["zeros", "--beta", "2..5/2", "--journal", str(path)]
    assert main(words) == 0
    before = path.read_bytes()
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parents[2])}
    with subprocess.Popen([sys.executable, "-c", HOLDER, str(path)], stdout=subprocess.PIPE, env=environment) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"held\n"
        capsys.readouterr()
        assert main(words) == 64
        shown = capsys.readouterr()
        assert shown.out == ""
        assert "another run uses this journal" in shown.err
        assert path.read_bytes() == before
        holder.send_signal(signal.SIGKILL)
        holder.wait()
    assert main(words) == 0


def test_a_journal_is_free_again_after_an_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "journal"
    with monkeypatch.context() as patched:
        patched.setattr(zeros, "zero_column", lambda *_: 1 / 0)
        with pytest.raises(ZeroDivisionError) as kept:
            of_zeros(path)
    assert of_zeros(path).statement is not None
    assert kept.value.__traceback__ is not None  # which held the frames of the first run
