"""The schema of each command's ``--json``, read off the type hints of what the command prints."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple, NotRequired, TypedDict

from flint import fmpq

from gspot_verified.certificates.checker import CheckResult
from gspot_verified.compliant.contact.iwc import CompliantIwc
from gspot_verified.compliant.model.force_result import CompliantForce
from gspot_verified.compliant.motion.run import CompliantRun
from gspot_verified.compliant.side.side_rule import SideRule
from gspot_verified.compliant.zeros.zero_count import SlowZeros
from gspot_verified.compliant.zeros.zero_map import ZeroMap
from gspot_verified.cost.benchmarks.expand import ExpandCost
from gspot_verified.cost.benchmarks.sign import SignCost
from gspot_verified.cost.benchmarks.theta import CostReport
from gspot_verified.cost.measurement.measurement import Measurement
from gspot_verified.cost.times.rows import Benchmark
from gspot_verified.expansion.from_state.limit_side import LimitSide
from gspot_verified.expansion.from_state.model_side import ModelSide
from gspot_verified.expansion.residual import ResidualBounds
from gspot_verified.expansion.time_series import TimeSeries
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.expansion.true_solutions.bound import UniformBound
from gspot_verified.expansion.true_solutions.side import UniformSide
from gspot_verified.hard_cases.catalogue import Catalogue
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.mechanisms.spots.classify import Classification
from gspot_verified.mechanisms.spots.classify_all import AllClassified
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.numbers.verdict import Verdict
from gspot_verified.numbers.written import DEFINITIONS, Schema, form
from gspot_verified.paper.checks.entry import Entry
from gspot_verified.report.check_again import CheckedAgain
from gspot_verified.report.mechanism.report import MechanismReport
from gspot_verified.scenes.floats.fast_part import FastPart
from gspot_verified.scenes.hard_sides import WrongSides
from gspot_verified.scenes.scene.effect_cost import EffectCost
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.scenes.simulators.comparison import SimulatorComparison
from gspot_verified.signs.cover.sign import SignResult
from gspot_verified.signs.gamma.side import SideSwitching
from gspot_verified.signs.zeros.brackets import Brackets
from gspot_verified.signs.zeros.integer_zeros import IntegerZeros
from gspot_verified.signs.zeros.zeros import ZerosResult
from gspot_verified.theta_function.value.complex_value import ComplexEvaluation
from gspot_verified.theta_function.value.evaluate import Evaluation


class _System(TypedDict):
    system: str
    contact_lasts: NotRequired[Verdict]


class _ByCountLaw(TypedDict):
    beta: fmpq
    number: int
    route: Literal["the count law"]


class _Value(TypedDict):
    value: str
    enclosure: str


class _Values(TypedDict):
    values_of: str
    state: dict[str, _Value]
    contact: dict[str, _Value]
    s: NotRequired[str]
    delta: NotRequired[str]
    t: NotRequired[str]
    epsilon: NotRequired[str]


class _AboutExpansion(TypedDict):
    at: NotRequired[_Values]
    residual: NotRequired[ResidualBounds]
    uniform: NotRequired[UniformBound]
    side: NotRequired[UniformSide]


class _Scene(TypedDict):
    name: str
    mechanism: str | None
    notes: list[str]
    effects: list[str]
    costs: list[EffectCost]
    assumes: dict[str, str]
    epsilon: fmpq
    until: fmpq
    parameters: dict[str, fmpq]
    start: dict[str, fmpq]
    enclosed_start: dict[str, str]
    start_not_integrated: dict[str, str]
    slow_start: str | None
    fast_part: FastPart | None
    states: dict[str, list[str]]


class _SceneRuns(TypedDict):
    scene: _Scene
    runs: list[SceneRun]
    agree: bool | None


class _Effect(TypedDict):
    name: str
    left_out: str
    needs: list[str]
    parameters: dict[str, fmpq]


class _Exclusion(NamedTuple):
    first: str
    second: str
    reason: str


class _Scenes(TypedDict):
    scenes: list[_Scene]
    effects: list[_Effect]
    exclusions: list[_Exclusion]


class _Claim(TypedDict):
    lines: tuple[int, int]
    claim: str
    standing: Literal[
        "proved", "proved under a condition", "overtaken", "refuted", "undecided", "premise", "not checkable", "not run"
    ]
    entries: list[str]
    why: str


class _WasRun(TypedDict):
    entries: int
    now: int
    cached: int


class _Ledger(TypedDict):
    counts: dict[str, int]
    rungs: dict[str, dict[str, int]]
    page_alone: int
    run: _WasRun
    standings: dict[str, int] | None
    claims: list[_Claim]
    entries: list[Entry]
    named_by_checks: list[Entry]


class _Page(TypedDict):
    page: str


class _Supplement(TypedDict):
    files: list[str]
    warnings: list[str]


class _Again(TypedDict):
    certificates: list[CheckedAgain]


RESULTS: dict[str, tuple[Any, ...]] = {
    "theta": (Evaluation, ComplexEvaluation),
    "side": (SideSwitching, (SideRule, _System)),
    "sign": (SignResult,),
    "zeros": (Brackets, IntegerZeros, _ByCountLaw, ZerosResult, SlowZeros, ZeroMap),
    "check": (CheckResult,),
    "iwc": (CompliantIwc,),
    "verdict": (ModelSide, LimitSide, MechanismSide),
    "force": ((CompliantForce, _System),),
    "events": (CompliantRun,),
    "simulate": (_SceneRuns,),
    "scenes": (_Scenes,),
    "wrong-sides": (WrongSides,),
    "simulators": (SimulatorComparison,),
    "classify": (Classification, AllClassified),
    "expand": ((Trajectory, _AboutExpansion), (TimeSeries, _AboutExpansion)),
    "approach": (Approach,),
    "sweep": (Sweep, Fates),
    "verify": (_Ledger,),
    "report": (_Page, _Supplement, _Again, (_Page, MechanismReport)),
    "cost": (Benchmark, CostReport, ExpandCost, SignCost, Measurement),
    "hard-cases": (Catalogue,),
}
"""What each command prints: one of these types; the keys of several, where they stand together."""


def schema_of(command: str, name: str) -> Schema:
    """The schema (JSON Schema, draft 2020-12) of the command's ``--json``, with its name.

    :raises ValueError: the command has no ``--json``.
    """
    if command not in RESULTS:
        raise ValueError(f"schema: expected one of {', '.join(RESULTS)}, got {command[:60]!r}")
    variants = [_joined(kinds if isinstance(kinds, tuple) else (kinds,), name) for kinds in RESULTS[command]]
    definitions: Schema = {}
    _collect(variants, definitions)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": name,
        "title": f"gspot-verified {command} --json",
        "anyOf": variants,
        "$defs": definitions,
    }


def _joined(kinds: tuple[Any, ...], name: str) -> Schema:
    """The keys of all the types in one object, and the name of the schema."""
    joined: Schema = {"required": ["schema"], "properties": {"schema": {"const": name}}}
    for schema in (form(kind).schema for kind in kinds):
        joined["required"] += schema["required"]
        joined["properties"] |= schema["properties"]
    return {"type": "object", "additionalProperties": False, **joined}


def _collect(part: Any, definitions: Schema) -> None:
    """Add every definition that the part refers to."""
    if isinstance(part, dict):
        name = str(part.get("$ref", "")).rpartition("/")[2]
        if name and name not in definitions:
            definitions[name] = DEFINITIONS[name]
            _collect(definitions[name], definitions)
    for each in part.values() if isinstance(part, dict) else part if isinstance(part, list) else ():
        _collect(each, definitions)
