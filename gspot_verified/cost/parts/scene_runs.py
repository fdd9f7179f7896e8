"""The part on certified scenes: decimals of the time of lift-off against time, certified and with floats."""

from __future__ import annotations

import math
import tempfile
from functools import partial
from pathlib import Path
from typing import Any

from flint import fmpq, fmpz

from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, best_time
from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Limit
from gspot_verified.cost.peers.lift_off_runs import (
    CERTIFIED_BITS,
    HEYOKA_TOLERANCES,
    LIMITS,
    NAMES,
    bracket_decimals,
    certified_bracket,
    exact_bracket,
    float_time,
    heyoka_call,
    heyoka_missing,
    right_decimals,
    scene_of,
)
from gspot_verified.integrator.box_steps.choice import order_for
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.scene.scene import Scene

# epsilon = 10^-(k + 3): the k of each scene.
_QUICK_EPSILONS: dict[str, tuple[int, ...]] = {"model": (0, 2), "extended": (0,), "oscillator": (0,)}
_FULL_EPSILONS: dict[str, tuple[int, ...]] = dict.fromkeys(NAMES, (0, 1, 2, 3))
_MORE_BITS = (384,)  # in full
_EXACT_DIGITS = (15, 30, 60)  # of the exact solution's bracket
_TOLERANCES = (1e-4, 1e-7, 1e-10, 1e-12)  # of Radau
_LIMIT_BITS, _CALLS = 192, 10_000  # working precision of the run; products that are timed together


def panel_of(name: str, k: int) -> str:
    """The words for one scene at one epsilon."""
    return f"{name}, ε = 10{'⁻³⁻⁴⁻⁵⁻⁶'[2 * k : 2 * k + 2]}"


def contestants(epsilons: dict[str, tuple[int, ...]]) -> tuple[TimedRoute, ...]:
    """All routes for the scenes at the values of epsilon."""
    return tuple(c for name, ks in epsilons.items() for k in ks for c in _of_one(name, k))


def _of_one(name: str, k: int) -> tuple[TimedRoute, ...]:
    panel = panel_of(name, k)
    scene = scene_of(name, k)

    def right(_: Any, time: fmpq) -> float | None:
        return right_decimals(name, k, time)

    def by_bits(bits: int) -> Call:
        return partial(certified_bracket, scene, bits)

    def tolerance_words(tolerance: float) -> str:
        return f"tolerance {tolerance:g}"

    routes = [
        TimedRoute(
            "certified, integrator", CERTIFIED, CERTIFIED_BITS, by_bits, _MORE_BITS, panel=panel,
            place=lambda _, bracket: bracket_decimals(bracket), words=lambda bits: f"{bits} bits",
        ),
        TimedRoute(
            "scipy Radau", NO_BOUND, _TOLERANCES, lambda t: partial(float_time, scene, "Radau", t),
            panel=panel, place=right, words=tolerance_words,
        ),
        TimedRoute(
            "heyoka", NO_BOUND, HEYOKA_TOLERANCES, partial(heyoka_call, scene), panel=panel, place=right,
            words=tolerance_words, missing=heyoka_missing(),
        ),
    ]  # fmt: skip
    if name == "model":
        exact = TimedRoute(
            "certified, exact solution", CERTIFIED, _EXACT_DIGITS,
            lambda digits: partial(exact_bracket, scene, digits), panel=panel,
            place=lambda _, bracket: bracket_decimals(bracket), words=lambda digits: f"{digits} digits",
        )  # fmt: skip
        routes.insert(1, exact)
    return tuple(routes)


def _profiled(_: bool) -> tuple[str, Call]:
    scene = scene_of("extended", 0)
    return "extended, ε = 10⁻³, 192 bits", partial(certified_bracket, scene, 192)


def _steps(scene: Scene, bits: int) -> int:
    """How many steps a run proves: after its first line a journal has one line for each."""
    with tempfile.TemporaryDirectory() as folder:
        journal = Path(folder) / "steps"
        integrated_run(scene, bits=(bits,), journal=journal)
        return len(journal.read_text().splitlines()) - 1


def _limit(_: bool) -> Limit:
    """The integrator alone: every coefficient of each product of the equations is a sum of so many products."""
    scene, order = scene_of("extended", 0), order_for(_LIMIT_BITS)
    steps = _steps(scene, _LIMIT_BITS)
    one = fmpz(3) ** round(_LIMIT_BITS / math.log2(3))

    def products() -> None:
        for _ in range(_CALLS):
            one * one

    seconds = steps * order**2 * best_time(products, 5, fresh=False) / _CALLS
    words = f"{steps} steps of order {order}, with {order**2} products of {_LIMIT_BITS} bits for its two bilinear terms"
    took = best_time(partial(certified_bracket, scene, _LIMIT_BITS), 2)
    return Limit(f"{panel_of('extended', 0)}, {_LIMIT_BITS} bits", words, seconds, took)


def blueprint(full: bool) -> Blueprint:
    """The part, with the values of epsilon of the size."""
    epsilons = _FULL_EPSILONS if full else _QUICK_EPSILONS
    return Blueprint(
        key="scenes",
        title="Certified scenes",
        question="The time of the first lift-off to D decimals, its fate certified or simulated: "
        "what the certificate costs.",
        axis="decimals D of the time of lift-off",
        symbol="D",
        contestants=partial(contestants, epsilons),
        profiled=_profiled,
        limit=_limit,
        remarks=(
            "A certified run brackets the event and proves that there was none before; a float run stands where its "
            "time is right, which it does not know. heyoka’s equations are compiled before its time is taken.",
        ),
        targets=tuple((panel_of(name, k), LIMITS[name][k]) for name, ks in epsilons.items() for k in ks),
    )
