"""The statements that columns prove; texts and data as in ``proofs/certificate.md``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from flint import fmpq

from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.work.ranges import Range

_MANY_ZEROS = 16  # beta from which on columns must be narrower to begin with
_RELATION = {1: ">", 0: "=", -1: "<"}


@dataclass(frozen=True, slots=True)
class SignStatement(NoTruthValue, Written):
    """dTheta/dtau has the sign ``sign`` at every point of the two ranges."""

    version: ClassVar[int] = 1
    kind: ClassVar[Literal["sign"]] = "sign"
    ask: ClassVar[str] = ".sign is what is stated; that it holds is proved elsewhere"
    written: ClassVar[str] = "kind tau beta sign"

    tau: Range
    beta: Range
    sign: int

    def __str__(self) -> str:
        tau = f"at τ = {self.tau.lower}" if self.tau.is_point else f"for every τ in {self.tau}"
        beta = f"at β = {self.beta.lower}" if self.beta.is_point else f"every β in {self.beta}"
        return f"dΘ/dτ {_RELATION[self.sign]} 0 {tau} and {beta}"


@dataclass(frozen=True, slots=True)
class ZerosStatement(NoTruthValue, Written):
    """For every beta of the range that is not an integer dTheta/dtau has exactly counts[floor(beta)] real zeros."""

    version: ClassVar[int] = 1
    kind: ClassVar[Literal["zeros"]] = "zeros"
    ask: ClassVar[str] = ".counts is what is stated; that it holds is proved elsewhere"
    written: ClassVar[str] = "kind beta counts"

    beta: Range
    counts: tuple[tuple[int, int], ...]

    def __str__(self) -> str:
        table = ", ".join(f"N = {count} on ({m}, {m + 1})" for m, count in self.counts)
        return f"for every β in {self.beta} that is not an integer, dΘ/dτ has exactly N real zeros, all simple: {table}"


@dataclass(frozen=True, slots=True)
class BracketsStatement(NoTruthValue, Written):
    """dTheta/dtau at one beta has exactly one real zero in each open interval, and no other."""

    version: ClassVar[int] = 1
    kind: ClassVar[Literal["brackets"]] = "brackets"
    ask: ClassVar[str] = ".brackets is what is stated; that it holds is proved elsewhere"
    written: ClassVar[str] = "kind beta brackets"

    beta: fmpq
    brackets: tuple[tuple[fmpq, fmpq], ...]

    def __str__(self) -> str:
        where = ", ".join(f"({lower}, {upper})" for lower, upper in self.brackets)
        number = counted(len(self.brackets), "real zero")
        simple = "simple, in" if len(self.brackets) == 1 else "all simple, one in each of:"
        return f"at β = {self.beta} dΘ/dτ has exactly {number}, {simple} {where}"


Statement = SignStatement | ZerosStatement | BracketsStatement


def cells_of(beta: Range) -> list[tuple[fmpq, fmpq]]:
    """The closure of a finite range of beta, cut at the integers and into equal parts between them.

    Wider ranges are seldom settled at once, and take the checker longer. A heuristic.

    :raises ValueError: the range is infinite.

    >>> cells_of(Range.parse("1/2..5/4", "beta"))
    [(1/2, 3/4), (3/4, 1), (1, 5/4)]
    """
    if beta.lower is None or beta.upper is None:
        raise ValueError("the range of beta must be finite")
    if beta.is_point:
        return [(beta.lower, beta.lower)]
    cells = range(int(beta.lower.floor()), int(beta.upper.ceil()))
    parts = [(m + fmpq(k, _parts(m)), m + fmpq(k + 1, _parts(m))) for m in cells for k in range(_parts(m))]
    return [(max(beta.lower, a), min(beta.upper, b)) for a, b in parts if a < beta.upper and b > beta.lower]


def _parts(m: int) -> int:
    """How many ranges (m, m + 1) is cut into to begin with. A heuristic."""
    return 4 if m < _MANY_ZEROS else 16
