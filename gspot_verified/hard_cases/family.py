"""Families of hard cases: their words (``families.toml``), and the function that asks the question at a level."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from typing import ClassVar

from gspot_verified.hard_cases import (
    compliant_cases,
    expansion_cases,
    fold_cases,
    mechanism_cases,
    sign_cases,
    theta_cases,
)
from gspot_verified.hard_cases.hard_case import Case
from gspot_verified.numbers.written import Written

CASES: dict[str, Case] = {
    **theta_cases.CASES,
    **sign_cases.CASES,
    **expansion_cases.CASES,
    **compliant_cases.CASES,
    **fold_cases.CASES,
    **mechanism_cases.CASES,
}


@dataclass(frozen=True, slots=True)
class Family(Written):
    """Questions that get harder with a number: ``variable`` says what it is, ``work`` what is counted.

    ``part`` is the package that answers. ``formula`` is the usual formula (LaTeX), ``why`` says what is hard in it and
    ``instead`` what the library does.
    """

    written: ClassVar[str] = "name part title variable formula why instead work"

    name: str
    part: str
    title: str
    variable: str
    formula: str
    why: str
    instead: str
    work: str
    levels: tuple[int, ...]

    @property
    def case(self) -> Case:
        """The function that asks the question."""
        return CASES[self.name]


@lru_cache(maxsize=1)
def families() -> tuple[Family, ...]:
    """Every family, in the order of the catalogue.

    >>> {"side", "canard", "spots-meet"} <= {family.name for family in families()}
    True
    """
    text = resources.files("gspot_verified.hard_cases").joinpath("families.toml").read_text(encoding="utf-8")
    return tuple(Family(**{**row, "levels": tuple(row["levels"])}) for row in tomllib.loads(text)["families"])
