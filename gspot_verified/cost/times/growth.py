"""How the cost of certified zeros grows: with the size of the range of beta, and with beta."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from gspot_verified.certificates.text import certificate_text
from gspot_verified.cost.times.measure import clear_caches
from gspot_verified.cost.times.rows import TimeCurve, seconds_text
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.signs.zeros.zeros import ZerosResult, zeros_on_range


@dataclass(frozen=True, slots=True)
class RangeTime(NoTruthValue, Written):
    """What one range of beta took, with empty caches before it; the text of the certificate is included.

    ``processor`` is processor time, which other work on the machine lengthens less than ``seconds``.
    """

    ask: ClassVar[str] = ".proved says whether the statement was proved"

    lower: int
    upper: int
    seconds: float
    processor: float
    columns: int
    pieces: int
    proved: bool

    def __str__(self) -> str:
        words = f"({self.lower}, {self.upper})".ljust(8)
        each = self.processor / max(self.pieces, 1)
        outcome = "" if self.proved else ", not proved"
        times = f"{seconds_text(self.seconds):>8}  processor {seconds_text(self.processor):>8}"
        counts = f"{self.columns:4} columns  {self.pieces:5} pieces"
        return f"{words} {times}  {counts}  {seconds_text(each)} for each piece{outcome}"


def time_range(lower: int, upper: int) -> tuple[RangeTime, ZerosResult, str]:
    """The zeros over (lower, upper), timed; the result, and its certificate ("" when nothing was proved)."""
    clear_caches()
    start, processor = time.perf_counter(), time.process_time()
    result = zeros_on_range(f"{lower}..{upper}")
    text = "" if result.statement is None else certificate_text(result.statement, result.columns)
    seconds, processor = time.perf_counter() - start, time.process_time() - processor
    pieces = sum(len(column.pieces) for column in result.columns)
    return RangeTime(lower, upper, seconds, processor, len(result.columns), pieces, bool(text)), result, text


@dataclass(frozen=True, slots=True)
class FittedGrowth(Written):
    """Times of several ranges, a number for each (its size, or where it lies), and the fitted exponent."""

    written: ClassVar[str] = "name variable points exponent"

    name: str
    variable: str
    points: tuple[tuple[int, RangeTime], ...]

    @property
    def exponent(self) -> float | None:
        """Processor time grows like this power of the number; None with fewer than two points."""
        return fitted_exponent([(x, item.processor) for x, item in self.points])

    @property
    def curve(self) -> TimeCurve:
        """The points of the picture."""
        return TimeCurve(self.name, tuple((x, item.processor) for x, item in self.points))

    def __str__(self) -> str:
        power = "not fitted" if self.exponent is None else f"like {self.variable}^{self.exponent:.2f}"
        lines = [f"{self.name}: {power} (asked: about linearly)", *(f"  {item}" for _, item in self.points)]
        return "\n".join(lines)


def fitted_exponent(points: Sequence[tuple[float, float]]) -> float | None:
    """The slope of the least-squares line through (log x, log y).

    >>> fitted_exponent([(1, 3.0), (2, 12.0), (4, 48.0)])
    2.0
    """
    pairs = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len({x for x, _ in pairs}) < 2:
        return None
    middle_x, middle_y = (math.fsum(values) / len(pairs) for values in zip(*pairs, strict=True))
    above = math.fsum((x - middle_x) * (y - middle_y) for x, y in pairs)
    return above / math.fsum((x - middle_x) ** 2 for x, _ in pairs)


def from_one(times: Sequence[RangeTime]) -> FittedGrowth:
    """Ranges (1, k). The larger ones reach to larger beta, where a unit of beta costs more."""
    return FittedGrowth("ranges (1, k)", "(k - 1)", tuple((item.upper - item.lower, item) for item in times))


def around(times: Sequence[RangeTime]) -> FittedGrowth:
    """Ranges with one middle: only the size grows, not the mean beta."""
    middle = times[0].lower + times[0].upper if times else 0
    name = f"ranges around β = {middle // 2 if middle % 2 == 0 else middle / 2}"
    return FittedGrowth(name, "size", tuple((item.upper - item.lower, item) for item in times))


def cells(times: Sequence[RangeTime]) -> FittedGrowth:
    """Cells (m, m + 1): only beta grows."""
    return FittedGrowth("cells (m, m + 1)", "m", tuple((item.lower, item) for item in times))
