"""Files that a command writes: checked before the work, and never a reason to lose its result."""

from __future__ import annotations

import os
import tempfile
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NoReturn

import typer

from gspot_verified.cli.app import warn

NOT_WRITTEN = 74
"""Exit code: the result was printed and stands, but a file that was asked for could not be written."""

PICTURES = (".png", ".pdf", ".svg")


class Outputs:
    """The files that one command was asked to write.

    :meth:`file` and :meth:`folder` come before the work, :meth:`write` after it, :meth:`leave` last.
    """

    def __init__(self) -> None:
        self._taken: dict[Path, str] = {}
        self._read: set[Path] = set()
        self._failed = False

    def reads(self, name: str | Path) -> None:
        """Name what the command reads, if it is a file, before its options: none of them may replace it."""
        if os.path.isfile(name):  # False also for what can be no path
            self._read.add(Path(name).resolve())

    def file(self, option: str, path: Path | None, suffixes: tuple[str, ...] = ()) -> None:
        """Check that a file can be written there.

        :raises ValueError: its folder is missing or closed to us, the path is no ordinary file, the suffix is none of
            ``suffixes``, or another option names the same file, or the command reads it.
        """
        if path is None:
            return
        if path.is_dir():
            raise ValueError(f"{option}: {path} is a folder, not a file")
        if path.exists() and not path.is_file():
            raise ValueError(f"{option}: {path} is not an ordinary file")
        if suffixes and path.suffix.lower() not in suffixes:
            refused = f"the suffix {path.suffix!r} of {path}" if path.suffix else f"{path} without a suffix"
            raise ValueError(f"{option}: cannot write {refused}; allowed: {', '.join(suffixes)}")
        _check_folder(option, path.parent)
        place = path.resolve()
        if place in self._read:
            raise ValueError(f"{option}: {path} is what the command reads")
        if place in self._taken:
            raise ValueError(f"{option} and {self._taken[place]} name the same file {path}")
        self._taken[place] = option

    def folder(self, option: str, path: Path) -> None:
        """Check that files can be written into the folder; only its last part may be missing.

        :raises ValueError: it is a file, it cannot be written, or its own folder is missing.
        """
        if path.is_dir():
            _check_folder(option, path)
        elif path.exists():
            raise ValueError(f"{option}: {path} is a file, not a folder")
        else:
            _check_folder(option, path.parent)

    def write(self, option: str, path: Path, write: Callable[[], object]) -> bool:
        """Call ``write``; where it fails say so on stderr and go on."""
        try:
            write()
        except (OSError, ValueError) as error:
            warn(f"{option}: {path} was NOT written: {error}")
            self._failed = True
            return False
        return True

    @contextmanager
    def journal(self, path: Path | None, option: str = "--journal") -> Iterator[None]:
        """Around the work: a journal that is dropped is told on stderr at once, and the exit code says it; an interrupt
        says how the work goes on."""
        from gspot_verified.work.journal_file import JournalWarning

        with warnings.catch_warnings():
            others = warnings.showwarning

            def show(text: Warning | str, kind: type[Warning], *place: Any) -> None:
                if issubclass(kind, JournalWarning):
                    self.missing(option, str(text))
                else:
                    others(text, kind, *place)

            warnings.simplefilter("always", JournalWarning)
            warnings.showwarning = show  # type: ignore[assignment]
            try:
                yield
            except KeyboardInterrupt:
                again = f"with {option} FILE it would go on" if path is None else "the same command goes on"
                typer.echo(f"{again} where it was interrupted", err=True)
                raise

    def missing(self, option: str, why: str) -> None:
        """Say that a file is not what it should be; the result stands."""
        warn(f"{option}: {why}")
        self._failed = True

    def leave(self, code: int) -> NoReturn:
        """End the command with ``code``, or with 74 where a file is missing."""
        raise typer.Exit(NOT_WRITTEN if self._failed else code)


def _check_folder(option: str, folder: Path) -> None:
    if not folder.is_dir():
        raise ValueError(f"{option}: there is no folder {folder}")
    try:
        if not os.access(folder, os.W_OK | os.X_OK):
            raise PermissionError
        # Rights are not all: a file system may be full, or written by nobody. This file has no name where that is
        # possible, and is gone at once.
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        why = f": {error.strerror}" if error.strerror else ""
        raise ValueError(f"{option}: the folder {folder} cannot be written{why}") from None
