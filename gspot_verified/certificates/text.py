"""The text of a certificate: canonical, versioned, integers and rationals only. Format: ``proofs/certificate.md``."""

from __future__ import annotations

import hashlib
import json
import os
import re
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol

from gspot_verified.signs.cover.pieces import Column

FORMAT = "gspot_verified certificate"
_TOO_LONG = re.compile(r"[0-9]{4001}")
HYPOTHESES = {
    1: ("certificate", "fold", "identities", "initial_values", "laplace", "negative", "tails"),
    2: ("certificate", "exact_solution", "identities", "initial_values", "laplace", "monotone", "negative", "tails"),
    3: (
        *("certificate", "epsilon_series", "exact_solution", "finite_epsilon_zeros"),
        *("identities", "initial_values", "laplace", "negative"),
    ),
    4: ("invariant_region", "left_out_effects", "run_certificate"),
    5: ("from_state",),
    6: ("approach", "approach_certificate", "run_certificate"),
    7: ("from_state", "uniform"),
}
"""The pages that a certificate rests on, by version: 1 is about Theta, 2 about the compliant model's contact force, 3
about the number of zeros of its slow solution, 4 about a run, 5 about the way from a state towards the G-spot, 6
about slip of a mechanism that reaches one, 7 about what follows from a state of the model system."""
RUN_VERSION = 4  # of certificates of runs
PASSAGE_VERSION = 5  # of certificates of Theorem B
APPROACH_VERSION = 6  # of certificates that slip reaches a G-spot
SIDE_VERSION = 7  # of certificates of lift-off or impact for all small epsilon


class Statement(Protocol):
    """What a certificate states: its version and its plain data, as in ``proofs/certificate.md``."""

    @property
    def version(self) -> int:
        """1, 2 or 3."""
        ...

    def to_json(self) -> dict[str, Any]:
        """Plain data of the certificate."""
        ...


def certificate_text(statement: Statement, columns: Sequence[Column]) -> str:
    """The certificate of a statement that the columns prove. The same columns give the same text, byte for byte.

    :raises ValueError: a number has more than 4,000 digits, the format's limit.

    >>> from gspot_verified import sign
    >>> result = sign("-inf..inf", "0..1", by_theorem=True)
    >>> print(certificate_text(result.statement, result.columns).splitlines()[1])
    {"beta":["0","1/4"],"pieces":[["laplace"]]}
    """
    return sealed(statement.version, statement.to_json(), [_column(column) for column in columns])


def sealed(version: int, statement: dict[str, Any], lines: Sequence[Any]) -> str:
    """The text of a certificate from plain data: the header, the lines, the hash.

    :raises ValueError: a number has more than 4,000 digits, the format's limit.

    >>> print(sealed(1, {"kind": "sign"}, [[1, 2]]).splitlines()[1])
    [1,2]
    """
    header = {"format": FORMAT, "hypotheses": list(HYPOTHESES[version]), "statement": statement, "version": version}
    body = "".join(f"{_canonical(line)}\n" for line in (header, *lines))
    if _TOO_LONG.search(body):
        raise ValueError("a certificate holds numbers of at most 4000 digits; ask for fewer digits or a rounder range")
    return f"{body}sha256 {hashlib.sha256(body.encode()).hexdigest()}\n"


def write_certificate(path: Path, statement: Statement, columns: Sequence[Column]) -> None:
    """Write the certificate; a file that is there is replaced only when the new one is complete on the disk.

    :raises OSError: it cannot be written; its folder is not made.
    :raises ValueError: see :func:`certificate_text`.

    >>> from gspot_verified import sign
    >>> proved = sign("0..1", "1/4..3/4")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "sign.cert"
    ...     write_certificate(file, proved.statement, proved.columns)
    ...     file.read_text() == certificate_text(proved.statement, proved.columns)
    True
    """
    write_text(path, certificate_text(statement, columns))


def write_text(path: Path, text: str) -> None:
    """Write the text of a certificate; a file that is there is replaced only when the new one is complete on the disk.

    :raises OSError: it cannot be written; its folder is not made.

    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_text(Path(folder) / "a.cert", "a")
    ...     (Path(folder) / "a.cert").read_text()
    'a'
    """
    if not path.parent.is_dir():
        raise FileNotFoundError(f"there is no folder {path.parent}")
    descriptor, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(descriptor, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        Path(name).chmod(0o644)
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def _column(column: Column) -> dict[str, Any]:
    lower = "-inf" if column.lower is None else str(column.lower)
    return {"beta": [lower, str(column.upper)], "pieces": [piece.to_list() for piece in column.pieces]}


def _canonical(value: Any) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"))
