"""The mechanisms that come with the package: the paper's, falling rods, and a gallery of others."""

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
    "rod with a wrist": "gallery/rod_with_wrist",
    "rod on a shaken base": "gallery/rod_on_a_shaken_base",
    "ladder on a vertical guide": "gallery/ladder",
    "chalk pushed along a board": "gallery/pushed_chalk",
    "sliding ellipse": "gallery/ellipse",
    "unbalanced wheel": "gallery/unbalanced_wheel",
    "two-link arm": "gallery/two_link_arm",
    "two-link arm on a belt": "gallery/arm_on_a_belt",
    "double pendulum on a rough surface": "gallery/double_pendulum",
    "compass biped": "gallery/compass_biped",
    "frictional impact oscillator on a belt": "gallery/oscillator_on_a_belt",
    "rod with Stribeck friction": "gallery/stribeck_rod",
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
    typed = name.replace("-", "_")
    stem = _FILES.get(name) or next((stem for stem in _FILES.values() if stem.rpartition("/")[2] == typed), None)
    if stem is None:
        raise MechanismError(f"no shipped mechanism {name[:60]!r}; there are: {'; '.join((*SHORT_NAMES, *_FILES))}")
    return resources.files("gspot_verified.mechanisms").joinpath(f"data/{stem}.toml").read_text(encoding="utf-8")


def shipped_system(name: str, **parameters: ExactInput | None) -> System:
    """The system of a mechanism of the package at its G-spot, exact where that is rational.

    :raises MechanismError: an unknown name or parameter.
    :raises GSpotError: these parameters have no G-spot at the mechanism's place.

    >>> shipped_system("oscillator", beta=3).check()[0]
    -175/408
    """
    return find_g_spot(shipped_mechanism(name, **parameters)).system
