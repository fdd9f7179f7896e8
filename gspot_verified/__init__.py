"""Verified numerics for the Painlevé paradox: Θ(τ, β) and its signs, the paper claim by claim, your own mechanism.

A name is loaded when it is first used, so that the import is quick.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gspot_verified.compliant.contact.iwc import CompliantIwc as CompliantIwc
    from gspot_verified.expansion.residual import residual_bounds as residual_bounds
    from gspot_verified.expansion.series.system import GSpotError as GSpotError
    from gspot_verified.expansion.trajectory import Trajectory as Trajectory
    from gspot_verified.expansion.true_solutions.bound import UniformBound as UniformBound
    from gspot_verified.expansion.true_solutions.bound import uniform_bound as uniform_bound
    from gspot_verified.expansion.true_solutions.side import UniformSide as UniformSide
    from gspot_verified.expansion.true_solutions.side import uniform_side as uniform_side
    from gspot_verified.leading_order.iwc import IwcResult as IwcResult
    from gspot_verified.mechanisms.approach.approach import approach as approach
    from gspot_verified.mechanisms.approach.approach_result import Approach as Approach
    from gspot_verified.mechanisms.expand import expand as expand
    from gspot_verified.mechanisms.input.mechanism import Mechanism as Mechanism
    from gspot_verified.mechanisms.input.mechanism import MechanismError as MechanismError
    from gspot_verified.mechanisms.iwc import iwc as iwc
    from gspot_verified.mechanisms.load import load as load
    from gspot_verified.mechanisms.shipped import shipped_names as shipped_names
    from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots as find_g_spots
    from gspot_verified.mechanisms.spots.classify import Classification as Classification
    from gspot_verified.mechanisms.spots.classify import classify as classify
    from gspot_verified.mechanisms.spots.classify_all import classify_all as classify_all
    from gspot_verified.mechanisms.spots.critical_friction import critical_friction as critical_friction
    from gspot_verified.mechanisms.sweep.sweep import sweep as sweep
    from gspot_verified.mechanisms.sweep.sweep_result import Sweep as Sweep
    from gspot_verified.numbers.balls import ball_text as ball_text
    from gspot_verified.numbers.dyadic import Dyadic as Dyadic
    from gspot_verified.numbers.verdict import Outcome as Outcome
    from gspot_verified.numbers.verdict import Reason as Reason
    from gspot_verified.numbers.verdict import Verdict as Verdict
    from gspot_verified.report.pictures.canvas import Picture as Picture
    from gspot_verified.report.plot import plot as plot
    from gspot_verified.signs.cover.sign import SignResult as SignResult
    from gspot_verified.signs.cover.sign import sign_on_ranges as sign_on_ranges
    from gspot_verified.signs.gamma.count_law import number_of_zeros as number_of_zeros
    from gspot_verified.signs.gamma.side import SideSwitching as SideSwitching
    from gspot_verified.signs.gamma.side import SignInterval as SignInterval
    from gspot_verified.signs.gamma.side import gamma_sign as gamma_sign
    from gspot_verified.signs.gamma.side import side_switching as side_switching
    from gspot_verified.signs.zeros.brackets import Brackets as Brackets
    from gspot_verified.signs.zeros.brackets import zeros_at as zeros_at
    from gspot_verified.signs.zeros.zeros import ZerosResult as ZerosResult
    from gspot_verified.signs.zeros.zeros import zeros_on_range as zeros_on_range
    from gspot_verified.theta_function.arrays.arrays import theta_of_floats as theta_of_floats
    from gspot_verified.theta_function.arrays.float_balls import FloatBalls as FloatBalls
    from gspot_verified.theta_function.arrays.prepared import PreparedTheta as PreparedTheta
    from gspot_verified.theta_function.gamma.initial_values import initial_values as initial_values
    from gspot_verified.theta_function.gamma.initial_values import paper_initial_values as paper_initial_values
    from gspot_verified.theta_function.theta import theta as theta
    from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient as coefficient
    from gspot_verified.theta_function.value.asymptotic_coefficients import (
        coefficient_by_inversion as coefficient_by_inversion,
    )
    from gspot_verified.theta_function.value.evaluate import Evaluation as Evaluation
    from gspot_verified.theta_function.value.evaluate import evaluate as evaluate
    from gspot_verified.theta_function.value.integer import polynomial as polynomial
    from gspot_verified.theta_function.value.routes import BudgetError as BudgetError
    from gspot_verified.theta_function.value.routes import theta_by as theta_by
    from gspot_verified.work.ranges import Range as Range

__version__ = "0.1.0"

__homes__ = {
    "Approach": "mechanisms.approach.approach_result",
    "Brackets": "signs.zeros.brackets",
    "BudgetError": "theta_function.value.routes",
    "Classification": "mechanisms.spots.classify",
    "CompliantIwc": "compliant.contact.iwc",
    "Dyadic": "numbers.dyadic",
    "Evaluation": "theta_function.value.evaluate",
    "FloatBalls": "theta_function.arrays.float_balls",
    "GSpotError": "expansion.series.system",
    "IwcResult": "leading_order.iwc",
    "Mechanism": "mechanisms.input.mechanism",
    "MechanismError": "mechanisms.input.mechanism",
    "Outcome": "numbers.verdict",
    "Picture": "report.pictures.canvas",
    "PreparedTheta": "theta_function.arrays.prepared",
    "Range": "work.ranges",
    "Reason": "numbers.verdict",
    "SideSwitching": "signs.gamma.side",
    "SignInterval": "signs.gamma.side",
    "SignResult": "signs.cover.sign",
    "Sweep": "mechanisms.sweep.sweep_result",
    "Trajectory": "expansion.trajectory",
    "UniformBound": "expansion.true_solutions.bound",
    "UniformSide": "expansion.true_solutions.side",
    "Verdict": "numbers.verdict",
    "ZerosResult": "signs.zeros.zeros",
    "approach": "mechanisms.approach.approach",
    "ball_text": "numbers.balls",
    "classify": "mechanisms.spots.classify",
    "classify_all": "mechanisms.spots.classify_all",
    "coefficient": "theta_function.value.asymptotic_coefficients",
    "coefficient_by_inversion": "theta_function.value.asymptotic_coefficients",
    "critical_friction": "mechanisms.spots.critical_friction",
    "evaluate": "theta_function.value.evaluate",
    "expand": "mechanisms.expand",
    "find_g_spots": "mechanisms.spots.all_g_spots",
    "gamma_sign": "signs.gamma.side",
    "initial_values": "theta_function.gamma.initial_values",
    "iwc": "mechanisms.iwc",
    "load": "mechanisms.load",
    "number_of_zeros": "signs.gamma.count_law",
    "paper_initial_values": "theta_function.gamma.initial_values",
    "plot": "report.plot",
    "polynomial": "theta_function.value.integer",
    "residual_bounds": "expansion.residual",
    "shipped_names": "mechanisms.shipped",
    "side_switching": "signs.gamma.side",
    "sign_on_ranges": "signs.cover.sign",
    "sweep": "mechanisms.sweep.sweep",
    "theta": "theta_function.theta",
    "theta_by": "theta_function.value.routes",
    "theta_of_floats": "theta_function.arrays.arrays",
    "uniform_bound": "expansion.true_solutions.bound",
    "uniform_side": "expansion.true_solutions.side",
    "zeros_at": "signs.zeros.brackets",
    "zeros_on_range": "signs.zeros.zeros",
}
"""The public names and the modules that define them."""

__all__ = [*__homes__]


def __getattr__(name: str) -> Any:
    if name not in __homes__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{__homes__[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__homes__})
