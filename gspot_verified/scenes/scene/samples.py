"""The trajectory of a run as arrays, and as files: CSV, or NumPy's NPZ."""

from __future__ import annotations

import csv
import os
import tempfile
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy import ndarray

RADIUS = "_radius"
"""Appended to the name of a column: half the width of the enclosures whose midpoints the column holds."""


@dataclass(frozen=True)
class Boxes:
    """Pieces of time in order, each with bounds of t and of the whole read-out, and its phase.

    From the first lower t to the last upper t the pieces leave no gap, and at each time the trajectory lies within the
    bounds of one of the pieces that hold this time: where the time of an event is a bracket, neighbours overlap by it.
    Bounds are rounded outwards to floats.
    """

    lower: dict[str, ndarray[Any, Any]]
    upper: dict[str, ndarray[Any, Any]]
    phases: tuple[str, ...]


@dataclass(frozen=True)
class Samples:
    """Columns (t after the start, then the read-out), and the phase of each row.

    Of a certified run there is beside each column of midpoints one of radii, its name with ``_radius``. A row encloses
    the values at one time, which lies within ``t_radius`` of t and need not be the double t. ``boxes``, of a run by the
    integrator, enclose all that is between the rows.
    """

    columns: dict[str, ndarray[Any, Any]]
    phases: tuple[str, ...]
    boxes: Boxes | None = None

    def save(self, path: str | Path) -> Path:
        """Write them as CSV or NPZ, by the suffix; a file that is there is replaced when the new one is complete.

        :raises ValueError: another suffix.
        :raises OSError: the file cannot be written; what was there stays, and no part of the new one.
        """
        place = Path(path)
        write = {".csv": self._csv, ".npz": self._npz}.get(place.suffix.lower())
        if write is None:
            raise ValueError(f"{place}: trajectories are written as .csv or .npz")
        _in_one_step(place, write)
        return place

    def _csv(self, stream: IO[bytes]) -> None:
        import io

        text = io.TextIOWrapper(stream, encoding="utf-8", newline="")
        writer = csv.writer(text)
        writer.writerow([*self.columns, "phase"])
        writer.writerows(zip(*(map(float, column) for column in self.columns.values()), self.phases, strict=True))
        text.flush()
        text.detach()

    def _npz(self, stream: IO[bytes]) -> None:
        import numpy as np

        # NumPy's own function takes names as its arguments: a component may be called as one of them.
        columns = {name: np.asarray(column, dtype=float) for name, column in self.columns.items()}
        with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, column in {**columns, "phase": np.array(self.phases)}.items():
                with archive.open(f"{name}.npy", "w", force_zip64=True) as part:
                    np.lib.format.write_array(part, column, allow_pickle=False)


def _in_one_step(place: Path, write: Callable[[IO[bytes]], None]) -> None:
    descriptor, name = tempfile.mkstemp(prefix=f".{place.name}.", suffix=".part", dir=place.parent)
    try:
        with os.fdopen(descriptor, "wb") as stream:
            write(stream)
            stream.flush()
            os.fsync(stream.fileno())
        _as_others(name)
        os.replace(name, place)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def _as_others(name: str) -> None:
    """The rights of a file made by ``open``: mkstemp gives fewer."""
    mask = os.umask(0)
    os.umask(mask)
    os.chmod(name, 0o666 & ~mask)
