"""One result of each public type, made in little time: what is shown and pickled in the tests."""

from __future__ import annotations

import importlib
import inspect
import typing
from collections.abc import Callable, Iterator
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import flint
import numpy as np
from flint import fmpq

import gspot_verified as g
from gspot_verified.compliant.motion.compliant_force import SlowMotions
from gspot_verified.cost.measurement.file import recorded
from gspot_verified.paper.checks.entry import Check, Rung, conclude
from gspot_verified.report.check_again import CheckedAgain
from gspot_verified.testing import extended_example

PROOFS = Path(__file__).resolve().parents[2] / "proofs"


def classes_in(hint: Any) -> Iterator[type]:
    """The classes that a type is made of."""
    if inspect.isclass(hint) and not typing.get_args(hint):
        yield hint
    for part in typing.get_args(hint):
        yield from classes_in(part)


def result_types() -> set[type]:
    """The public classes, and those of this package that public functions return."""
    found = set()
    public = {name: getattr(g, name) for name in g.__all__}
    for value in public.values():
        if inspect.isclass(value):
            found.add(value)
            continue
        place = {**public, **vars(flint), **vars(np), **vars(importlib.import_module(value.__module__))}
        note = inspect.unwrap(value).__annotations__["return"]
        found |= set(classes_in(eval(note, place) if isinstance(note, str) else note))
    own = {kind for kind in found if kind.__module__.startswith("gspot_verified.")}
    return {kind for kind in own if not issubclass(kind, Enum | BaseException)}


@cache
def trajectory() -> g.Trajectory:
    """Exact terms."""
    return g.expand(extended_example(chi=1), 8)


@cache
def _iwc() -> g.CompliantIwc:
    return g.iwc("5/2", c1=-1)


def _state() -> g.CompliantState:
    return g.compliant_state("1/2", -2, "-8e-12", 0, "-4e-12")


def _entry() -> object:
    good = (Check(Rung.PAGE, "proofs/signs.md", True, "found <b>it</b>"), Check(Rung.POINTS, "40 points", True))
    return g.Entry("t01", "eq:t01", "Appendix A", r"\Theta(0)", "value <at> 0 & 'more'", good, conclude("t", good))


def _comparison() -> object:
    start = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}
    return g.simulators(g.load("rod with a wrist"), start, epsilons=[], steps=[1e-2], programs=[])


def _wrong_sides() -> object:
    few = g.hard_sides().restricted(epsilons=["1/1000"], betas=["5/2"], nus=["2"], solvers=["LSODA"])
    return g.wrong_sides(few.restricted(tolerances=["1e-6"]))


RESULTS: dict[str, Callable[[], object]] = {
    "AllClassified": lambda: g.classify_all(g.load("genot_brogliato_rod", mu="13/10")),
    "Approach": lambda: g.approach(g.load("model system"), {"x": 0, "u": 3, "p": "1/2", "b": "-2"}),
    "Brackets": lambda: g.zeros("5/2", digits=5),
    "Catalogue": lambda: g.measure_hard_cases(["fold"]),
    "CheckResult": lambda: g.check(PROOFS / "iwc_0_1.cert"),
    "CheckedAgain": lambda: CheckedAgain("iwc_0_1.cert", True, "VERIFIED"),
    "Classification": lambda: g.classify(g.load("genot_brogliato_rod", mu="7/5")),
    "ComplexEvaluation": lambda: g.evaluate("1+2i", "7/3", digits=30),
    "CompliantForce": lambda: g.force(g.compliant_model("5/2", "1e-6"), SlowMotions(fmpq(1)), "1e-4", digits=8),
    "CompliantIwc": _iwc,
    "CompliantModel": lambda: g.compliant_model("5/2", "1e-6"),
    "CompliantRun": lambda: g.events(g.compliant_model("3/2", "1e-6"), _state()),
    "CompliantState": _state,
    "CriticalFriction": lambda: g.critical_friction(g.load("genot_brogliato_rod")),
    "Dyadic": lambda: g.Dyadic(-3, 5, -2),
    "Entry": _entry,
    "Evaluation": lambda: g.evaluate(-50, "7/3", digits=30),
    "FloatBalls": lambda: g.theta_of_floats(np.linspace(-1.0, 1.0, 5), "7/3"),
    "ForceCertificate": lambda: g.iwc_certificate(_iwc().leading),
    "GSpots": lambda: g.find_g_spots(g.load("genot_brogliato_rod", mu="13/10")),
    "HardSides": g.hard_sides,
    "IntegerZeros": lambda: g.zeros(6),
    "IwcResult": lambda: _iwc().leading,
    "Measurement": recorded,
    "LimitSide": lambda: g.limit_side("3/2"),
    "Mechanism": lambda: g.load("rod"),
    "MechanismReport": lambda: g.mechanism_report("falling-rod-lower-friction", settings={"mu": "13/10"}),
    "MechanismSide": lambda: g.mechanism_side(g.load("model system"), {"x": 0, "u": 3, "p": "1/2", "b": "-2"}),
    "ModelSide": lambda: g.model_side("3/2", "1/2", -2, epsilon="1e-6"),
    "Picture": lambda: g.plot(g.iwc("7/3"), epsilon="1/100"),
    "PreparedTheta": lambda: g.PreparedTheta("7/3", digits=30, reach=1),
    "Range": lambda: g.Range.parse("0..1/3", "beta"),
    "ResidualBounds": lambda: g.residual_bounds(trajectory(), s=1, delta="1/10"),
    "Scene": lambda: g.load_scene("fig-varsim1", beta="1/2"),
    "SceneRun": lambda: g.simulate(g.load_scene("fig-varsim1", beta="1/2"), floats=True, points=5),
    "SideRule": lambda: g.side_rule(g.compliant_model("13/2", "1/1000"), _state()),
    "SideSwitching": lambda: g.side("1/2", "9/2"),
    "SignInterval": lambda: g.side("1/2", "9/2").intervals[0],
    "SignResult": lambda: g.sign("-1..1", "[2..3]"),
    "SimulatorComparison": _comparison,
    "SlowZeros": lambda: g.zeros("5/2", "1/10"),
    "SlowZerosCertificate": lambda: g.slow_zeros_certificate("9/2..37/8", 10),
    "ApproachedRow": lambda: next(g.approach_table(g.load("model system"), [{"x": 0, "u": 3, "p": "1/2", "b": "-2"}])),
    "ClassifiedRow": lambda: next(g.classify_table(g.load("genot_brogliato_rod"), [{"mu": "8/5"}])),
    "Sweep": lambda: g.sweep(g.load("oscillator"), {"beta": "9/4..11/4:4"}),
    "Fates": lambda: g.fates(g.load("model system"), {"x": 0, "u": 3, "p": "1/2"}, {"b": "-5/2..-3/2:2"}),
    "Trajectory": trajectory,
    "UniformBound": lambda: g.uniform_bound(g.expand(extended_example(chi=1), 6), -3, 2, "1/20"),
    "UniformSide": lambda: g.uniform_side(trajectory(), -1, "1/50"),
    "Verdict": lambda: g.sign("0", "1/2").verdict,
    "WrongSides": _wrong_sides,
    "ZeroMap": lambda: g.zeros("1..5", "1/2..1", budget=0),
    "ZerosResult": lambda: g.zeros("2..5/2"),
}
"""By the name of the type."""


@cache
def result(name: str) -> object:
    """The result of this type, made once."""
    return RESULTS[name]()
