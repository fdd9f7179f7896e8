"""The mechanisms that come with the package: the paper's model systems, the oscillator, and falling rods."""

from __future__ import annotations

from importlib import resources

from gspot_verified.expansion.series.system import System
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import ExactInput

_FILES = {
    "model system": "model_system",
    "extended system": "extended_system",
    "frictional impact oscillator": "frictional_impact_oscillator",
    "frictional impact oscillator, all parameters": "frictional_impact_oscillator_all_parameters",
    "falling rod": "falling_rod",
    "falling rod, lower friction": "falling_rod_lower_friction",
    "falling rod of Génot and Brogliato": "genot_brogliato_rod",
}
SHORT_NAMES = {
    "model": "model system",
    "extended": "extended system",
    "oscillator": "frictional impact oscillator",
    "rod": "falling rod",
}
"""The names that people type, and the mechanisms that they mean."""


def shipped_names() -> tuple[str, ...]:
    """The names that :func:`shipped_mechanism` knows.

    >>> shipped_names()[:2]
    ('model system', 'extended system')
    """
    return tuple(_FILES)


def shipped_mechanism(name: str, **parameters: ExactInput | None) -> Mechanism:
    """A mechanism of the package, with other values of its parameters where given.

    Short names: model, extended, oscillator, rod. A file's own name serves too.

    :raises MechanismError: an unknown name or parameter.

    >>> shipped_mechanism("extended system", chi="1/2").state
    ('x', 'u', 'y', 'v', 'p', 'b')
    """
    return parse_mechanism(shipped_text(name)).with_parameters(**parameters)


def shipped_text(name: str) -> str:
    """The file of a mechanism of the package.

    :raises MechanismError: an unknown name.

    >>> shipped_text("rod").splitlines()[-1]
    'theta_dot = 1'
    """
    name = SHORT_NAMES.get(name, name)
    stem = name.replace("-", "_")
    stem = stem if stem in _FILES.values() else _FILES.get(name, "")
    if not stem:
        raise MechanismError(f"no shipped mechanism {name[:60]!r}; there are: {'; '.join((*SHORT_NAMES, *_FILES))}")
    return resources.files("gspot_verified.mechanisms").joinpath("data", f"{stem}.toml").read_text(encoding="utf-8")


def shipped_system(name: str, **parameters: ExactInput | None) -> System:
    """The system of a mechanism of the package at its G-spot, exact where that is rational.

    :raises MechanismError: an unknown name or parameter.
    :raises GSpotError: these parameters have no G-spot at the mechanism's place.

    >>> shipped_system("oscillator", beta=3).check()[0]
    -175/408
    """
    return find_g_spot(shipped_mechanism(name, **parameters)).system
