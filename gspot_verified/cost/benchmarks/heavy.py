"""The cases of the full benchmark: 10^5 and 10^6 digits, each call in a fresh process with a time limit.

Nothing is warmed up in these processes, neither ours nor the baseline: both compute pi, logarithms and Bernoulli
numbers inside their time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from flint import fmpq

from gspot_verified.cost.times.cases import HALF, SEVEN_THIRDS, SPEED, asked, first_attempt_note, general_beta_fresh
from gspot_verified.cost.times.measure import ChildRun, run_child
from gspot_verified.cost.times.rows import Row, Target, seconds_text

BASELINE_LIMIT = 900.0  # seconds; what takes longer is stopped, and the row says so
MPMATH_LIMIT = 120.0  # seconds
_OURS_LIMIT = 600.0  # seconds

Progress = Callable[[str], None]


def _child(who: str, tau: fmpq, digits: int, limit: float) -> ChildRun:
    return run_child({"who": who, "tau": str(tau), "beta": "1/2", "digits": digits}, limit)


def against_baseline(progress: Progress) -> Iterator[Row]:
    """10^5 digits against the baseline, one run each."""
    for tau in (SEVEN_THIRDS, -SEVEN_THIRDS):
        words = asked(tau, HALF, 100_000)
        progress(f"{words}: ours, then the baseline (minutes)")
        ours, other = _child("ours", tau, 100_000, _OURS_LIMIT), _child("baseline", tau, 100_000, BASELINE_LIMIT)
        speed = other.seconds / ours.seconds if ours.seconds and other.seconds else None
        first = first_attempt_note(other.first_attempt, ours.seconds) if other.first_attempt and ours.seconds else ""
        said = [ours.note, other.note, first, _processor(ours, other)]
        note = "; ".join(["one run each in a fresh process, nothing warmed", *filter(None, said)])
        target = Target("baseline / cold", SPEED[100_000], at_most=False)
        yield Row("many digits", words, target, speed, ours.seconds, baseline=other.seconds, note=note)


def _processor(ours: ChildRun, other: ChildRun) -> str:
    if not ours.processor or not other.processor:
        return ""
    mine, theirs = seconds_text(ours.processor), seconds_text(other.processor)
    return f"processor time {mine} and {theirs}: {other.processor / ours.processor:.3g} x"


def mpmath_at_many_digits(progress: Progress) -> str:
    """What mpmath does with 10^4 digits, in words."""
    progress(f"mpmath at 10^4 digits (at most {MPMATH_LIMIT:g} s)")
    run = _child("mpmath", SEVEN_THIRDS, 10_000, MPMATH_LIMIT)
    return f"mpmath, τ=7/3 β=1/2 10000 digits: {run.note or f'{run.seconds:.1f} s'}"


def general_beta_rows(progress: Progress) -> Iterator[Row]:
    """beta = 7/3 and 7/5 against 1/2 at 10^5 digits."""
    progress("general β at 10^5 digits")
    yield from general_beta_fresh(100_000, _OURS_LIMIT)


def growth(progress: Progress) -> Row:
    """From 10^5 to 10^6 digits: how much longer, and the peak memory."""
    progress("10^6 digits")
    small = _child("ours", SEVEN_THIRDS, 100_000, _OURS_LIMIT)
    large = _child("ours", SEVEN_THIRDS, 1_000_000, _OURS_LIMIT)
    ratio = large.seconds / small.seconds if small.seconds and large.seconds else None
    note = f"peak memory: {_megabytes(small)} at 10^5, {_megabytes(large)} at 10^6 digits"
    note = "; ".join([note, *filter(None, [small.note, large.note])])
    target = Target("time at 10^6 / at 10^5 digits", 20.0)
    return Row("growth", asked(SEVEN_THIRDS, HALF, 1_000_000), target, ratio, large.seconds, note=note)


def _megabytes(run: ChildRun) -> str:
    return "unknown" if run.peak_bytes is None else f"{run.peak_bytes / 1e6:.0f} MB"
