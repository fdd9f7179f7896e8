"""A table of answers as a file: CSV, or Parquet by its suffix, with the same doubles."""

from __future__ import annotations

import csv
import importlib.util
from collections.abc import Collection, Iterable
from pathlib import Path

from gspot_verified.work.draft import draft

PARQUET = ".parquet"
_BOUNDS = ("_lower", "_upper")


def require_writer(option: str, path: Path | None) -> None:
    """Before the work: that what writes this kind of file is installed.

    :raises ValueError: it is not.
    """
    if path is not None and path.suffix.lower() == PARQUET and importlib.util.find_spec("pyarrow") is None:
        raise ValueError(f"{option}: {path} needs pyarrow, the extra 'columnar'; a file .csv needs nothing")


def write_answers(path: Path, lines: Iterable[str], texts: Collection[str] = ()) -> None:
    """Write lines of CSV with their line feeds, the first one names the columns, whole or not at all.

    As Parquet a column whose name ends with ``_lower`` or ``_upper`` holds doubles, those of the CSV, and null where
    that has nothing; the others, and those in ``texts``, hold text. Memory does not grow with the number of lines.

    :raises ImportError: Parquet without pyarrow.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     place = Path(folder) / "answers.csv"
    ...     write_answers(place, ["case,beta_lower\\n", "III,1.5\\n"])
    ...     place.read_text(encoding="utf-8")
    'case,beta_lower\\nIII,1.5\\n'
    """
    with draft(path) as unfinished:
        if path.suffix.lower() != PARQUET:
            _write_lines(unfinished, lines)
            return
        rows = unfinished.with_name(f"{unfinished.name}.csv")
        try:
            _write_lines(rows, lines)
            _as_parquet(rows, unfinished, texts)
        finally:
            rows.unlink(missing_ok=True)


def _write_lines(path: Path, lines: Iterable[str]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.writelines(lines)


def _as_parquet(source: Path, target: Path, texts: Collection[str]) -> None:
    from pyarrow import float64, string
    from pyarrow.csv import ConvertOptions, ParseOptions, open_csv
    from pyarrow.parquet import ParquetWriter

    with source.open(encoding="utf-8", newline="") as file:
        names = next(csv.reader(file))
    types = {name: float64() if name.endswith(_BOUNDS) and name not in texts else string() for name in names}
    convert = ConvertOptions(column_types=types, null_values=[""], strings_can_be_null=False)
    # The reader looks through blocks of the file: it never holds the whole of it.
    with (
        open_csv(source, parse_options=ParseOptions(newlines_in_values=True), convert_options=convert) as reader,
        ParquetWriter(target, reader.schema) as writer,
    ):
        for batch in reader:
            writer.write_batch(batch)
