"""The real zeros of dTheta/dtau, or at finite epsilon those of the slow force: at one beta, or over a range."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.compliant.zeros.zero_count import SlowZeros, slow_zeros
from gspot_verified.compliant.zeros.zero_map import ZeroMap, zero_map
from gspot_verified.numbers.balls import ExactInput, exact
from gspot_verified.signs.cover.subdivision import Progress
from gspot_verified.signs.zeros.brackets import Brackets, zeros_at
from gspot_verified.signs.zeros.integer_zeros import IntegerZeros, zeros_at_integer
from gspot_verified.signs.zeros.zeros import ZerosResult, zeros_on_range
from gspot_verified.work.ranges import Range

Zeros = Brackets | IntegerZeros | ZerosResult | SlowZeros | ZeroMap


def zeros(
    beta: Range | ExactInput,
    epsilon: Range | ExactInput | None = None,
    *,
    digits: int | None = None,
    budget: int | None = None,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> Zeros:
    """Every real zero of dTheta/dtau: brackets of all of them at one beta, or how many for every beta of a range.

    With ``epsilon``: those of the contact force's deviation on the slow manifold of the compliant model at that
    epsilon, with alpha_1 = -1, or over a range of epsilon, which needs a range of beta.

    :param beta: one number, or a range such as "1..13".
    :param digits: at one beta: decimals of the places; 15 if left out.
    :param budget: over a range: how many ranges of beta may be examined; then what is left is named.
    :param executor, journal, progress: over a range: where the work is done; a file that keeps it; is told each step.
    :returns: at one beta :class:`Brackets`, at an integer :class:`IntegerZeros`, over a range :class:`ZerosResult`;
        with ``epsilon`` :class:`SlowZeros` or :class:`ZeroMap`.
    :raises TypeError: a float.
    :raises ValueError: a number or range outside its domain; an argument of the other kind of question. For
        beta > 200 :func:`number_of_zeros` has the number.
    :raises UndecidedError: two brackets overlap.

    >>> from gspot_verified import zeros
    >>> print(zeros("5/2", digits=5))
    β = 5/2: 2 real zeros of dΘ/dτ, all simple
      -0.30887..-0.30886
      1.53171..1.53172
    >>> zeros("5/2", "1/10").number
    2
    """
    work = {"budget": budget, "executor": executor, "journal": journal, "progress": progress}
    given: dict[str, Any] = {name: value for name, value in work.items() if value is not None}
    if _is_range(beta):
        if digits is not None:
            raise ValueError("digits: for one value of beta")
        betas = _range(beta, "beta")
        return (
            zeros_on_range(betas, **given) if epsilon is None else zero_map(betas, _range(epsilon, "epsilon"), **given)
        )
    if given or isinstance(beta, Range) or isinstance(epsilon, Range) or _is_range(epsilon):
        raise ValueError(f"{next(iter(given), 'epsilon')}: it needs a range of beta, such as 1..13")
    accuracy = 15 if digits is None else digits
    if epsilon is not None:
        return slow_zeros(beta, epsilon, accuracy)
    value = exact(beta, "beta")
    if isinstance(value, fmpq) and value.q == 1:
        return zeros_at_integer(int(value.p), accuracy)
    return zeros_at(value, accuracy)


def _is_range(value: Range | ExactInput | None) -> bool:
    return isinstance(value, Range) or (isinstance(value, str) and ".." in value)


def _range(value: Range | ExactInput, name: str) -> Range | str:
    if isinstance(value, Range | str):
        return value
    point = exact(value, name)
    if not isinstance(point, fmpq):
        raise ValueError(f"{name}: expected a range or one exact number, got a ball")
    return Range(point, point, True, True)
