"""The benchmark behind ``gspot-verified cost force``: the compliant model at epsilon = 1e-1 ... 1e-100."""

from __future__ import annotations

import platform
import sys
import time
from collections.abc import Callable
from functools import partial

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_model, compliant_state
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.motion.first_zero import first_zero
from gspot_verified.compliant.slow.slow_solution import slow_solution
from gspot_verified.cost.times.measure import Contestant, machine_load, measure
from gspot_verified.cost.times.rows import Benchmark, Row, Target, TimeCurve
from gspot_verified.numbers.balls import approximate, working_bits

Progress = Callable[[str], None]

TENS = (1, 3, 6, 12, 100)  # epsilon = 10^-n
_TAUS = (-10, -3, 0, 3, 10)  # on both sides of the G-spot, and there
_B = fmpq(3, 2)  # beta - 1
_FEW, _MANY = 16, 50  # digits of a value
_SMALL_FROM = 6  # n: from epsilon = 10^-6 on the limits are stricter
_LIMITS = {(_FEW, True): 0.5e-3, (_MANY, True): 3e-3, (_FEW, False): 20e-3, (_MANY, False): 30e-3}
"""Seconds per value of the slow solution, by digits and by epsilon <= 1e-6."""
_ZERO_LIMIT = 0.5  # seconds for a bracket of a zero
_HEAD = (
    "Times are medians. Slow solution: per value, mean over five τ, called again (nodes at this ε are kept).\n"
    "From a state: the initial values of Fig. varsim1, β = 5/2, ν = 1/2, the package's caches empty before each call."
)


def run(full: bool = False, progress: Progress = lambda _: None) -> Benchmark:
    """Run the benchmark: some seconds; with ``full`` more repeats. A missed target is a row of the report."""
    start, before = time.perf_counter(), machine_load()
    repeats = 15 if full else 5
    rows, points = [], []
    for tens in TENS:
        progress(f"the slow solution at ε = 1e-{tens}")
        for digits in (_FEW, _MANY):
            row = _slow(tens, digits, repeats)
            rows.append(row)
            if digits == _FEW:
                points.append((tens, row.figure or 0.0))
    for tens in TENS[1:]:
        progress(f"from a state at ε = 1e-{tens}")
        rows += [_from_state(tens, repeats), _first_zero(tens, repeats)]
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        f"before: {before}; after: {machine_load()}",
    )
    return Benchmark(
        _HEAD,
        tuple(rows),
        (TimeCurve("slow solution, 16 digits", tuple(points)),),
        remarks,
        time.perf_counter() - start,
    )


def forget() -> None:
    """Empty every ``lru_cache`` of the package."""
    for name, module in list(sys.modules.items()):
        if name.startswith("gspot_verified.") and module is not None:
            for member in list(vars(module).values()):
                if callable(getattr(member, "cache_clear", None)):
                    member.cache_clear()


def _slow(tens: int, digits: int, repeats: int) -> Row:
    epsilon = fmpq(10) ** -tens
    with working_bits(64):
        unit = fmpq(*approximate(1 / (arb(epsilon) / 2).root(3)).as_integer_ratio())

    def values() -> None:
        for tau in _TAUS:
            slow_solution(tau * unit, _B, epsilon, 0, digits)

    figure = measure({"it": Contestant(values, None, repeats)}, 2.0)["it"].median / len(_TAUS)
    limit = _LIMITS[digits, tens >= _SMALL_FROM]
    return Row("slow solution", f"ε = 1e-{tens}, {digits} digits", Target("time", limit, "s"), figure, warm=figure)


def _run_of_the_paper(tens: int) -> tuple[CompliantModel, CompliantState]:
    model = compliant_model("5/2", fmpq(10) ** -tens)
    p, small = fmpq(1, 2), model.epsilon
    b = -fmpq(1, 2) * p * abs(model.mean_force)
    return model, compliant_state(p, b, 2 * small**2 * b / p, 0, small**2 * b / p)


def _from_state(tens: int, repeats: int) -> Row:
    call = partial(force, *_run_of_the_paper(tens), "-1/10")
    figure = measure({"it": Contestant(call, forget, repeats)}, 2.0)["it"].median
    return Row(
        "from a state",
        f"ε = 1e-{tens}, t = -1/10, all variables",
        Target("time", _ZERO_LIMIT, "s"),
        figure,
        cold=figure,
    )


def _first_zero(tens: int, repeats: int) -> Row:
    call = partial(first_zero, *_run_of_the_paper(tens))
    figure = measure({"it": Contestant(call, forget, min(repeats, 3))}, 2.0)["it"].median
    return Row(
        "from a state", f"ε = 1e-{tens}, first zero to 1e-25", Target("time", _ZERO_LIMIT, "s"), figure, cold=figure
    )
