"""Where a file is written before it takes its place in one step."""

from __future__ import annotations

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def draft(path: Path) -> Iterator[Path]:
    """A place beside ``path`` for its new content, which is ``path`` when all went well, and gone otherwise.

    No other run writes there, and no file of the user's has this name.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with draft(Path(folder) / "a.csv") as place:
    ...         _ = place.write_text("1,2", encoding="utf-8")
    ...     [each.name for each in Path(folder).iterdir()]
    ['a.csv']
    """
    place = path.with_name(f".{path.name}.{secrets.token_hex(6)}.part")
    try:
        yield place
        place.replace(path)
    finally:
        place.unlink(missing_ok=True)
