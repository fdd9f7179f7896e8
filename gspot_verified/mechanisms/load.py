"""The one way to a mechanism: a file, or one that comes with the package."""

from __future__ import annotations

from pathlib import Path

from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.input.file import parse_mechanism, read_text, refuse_robot
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.numbers.balls import ExactInput


def load(name_or_path: str | Path, /, **parameters: ExactInput | None) -> Mechanism:
    """The mechanism in a TOML file or, where there is no such file, the one of the package with that name.

    ``parameters`` replace values of the file, and the name says so; None makes a parameter a symbol. Names of the
    package: model, extended, oscillator, rod, and those of
    :func:`gspot_verified.mechanisms.shipped.shipped_names`.

    :raises MechanismError: neither a file nor a name, the file of a robot, a part of the file is wrong, there is no
        such parameter, or no mechanism is like that: a friction coefficient or a mass below 0, a mass matrix that is
        not positive definite.

    >>> load("rod").state
    ('X', 'Y', 'theta', 'X_dot', 'Y_dot', 'theta_dot')
    >>> load("extended", chi="1/2").name
    'extended system, chi = 1/2'
    """
    text, origin = mechanism_text(name_or_path)
    try:
        mechanism = parse_mechanism(text)
    except MechanismError as error:
        raise MechanismError(f"{origin}: {error}") from None
    mechanism = mechanism.changed(**parameters)
    try:
        refuse_impossible(mechanism)
    except MechanismError as error:
        raise MechanismError(f"{origin}: {error}") from None
    return mechanism


def mechanism_text(name_or_path: str | Path) -> tuple[str, str]:
    """The text of that file, and how messages name it.

    :raises MechanismError: neither a file nor a name, or the file cannot be read.

    >>> mechanism_text("rod")[1]
    'rod'
    """
    if not isinstance(name_or_path, str | Path):
        raise TypeError(f"load: expected a path or a name, got {type(name_or_path).__name__}")
    path = Path(name_or_path)
    if isinstance(name_or_path, Path) or path.suffix == ".toml" or path.is_file():
        refuse_robot(path)
        return read_text(path), str(path)
    try:
        return shipped_text(name_or_path), name_or_path
    except MechanismError as error:
        place = f"{path} is a folder" if name_or_path and path.is_dir() else f"there is no file {name_or_path[:60]!r}"
        raise MechanismError(f"{place}, and {error}") from None
