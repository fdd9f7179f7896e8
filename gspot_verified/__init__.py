"""Verified numerics for the Painlevé paradox: Θ(τ, β) and its signs, the paper claim by claim, your own mechanism.

A name is loaded when it is first used, so that the import is quick.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gspot_verified.balls import ball_text as ball_text
    from gspot_verified.compliant.iwc import CompliantIwc as CompliantIwc
    from gspot_verified.dyadic import Dyadic as Dyadic
    from gspot_verified.expansion.residual import residual_bounds as residual_bounds
    from gspot_verified.expansion.system import GSpotError as GSpotError
    from gspot_verified.expansion.trajectory import Trajectory as Trajectory
    from gspot_verified.mechanisms.all_g_spots import find_g_spots as find_g_spots
    from gspot_verified.mechanisms.approach import approach as approach
    from gspot_verified.mechanisms.approach_result import Approach as Approach
    from gspot_verified.mechanisms.classify import Classification as Classification
    from gspot_verified.mechanisms.classify import classify as classify
    from gspot_verified.mechanisms.classify_all import classify_all as classify_all
    from gspot_verified.mechanisms.critical_friction import critical_friction as critical_friction
    from gspot_verified.mechanisms.expand import expand as expand
    from gspot_verified.mechanisms.iwc import iwc as iwc
    from gspot_verified.mechanisms.load import load as load
    from gspot_verified.mechanisms.mechanism import Mechanism as Mechanism
    from gspot_verified.mechanisms.mechanism import MechanismError as MechanismError
    from gspot_verified.mechanisms.shipped import shipped_names as shipped_names
    from gspot_verified.mechanisms.sweep import sweep as sweep
    from gspot_verified.mechanisms.sweep_result import Sweep as Sweep
    from gspot_verified.report.canvas import Picture as Picture
    from gspot_verified.report.plot import plot as plot
    from gspot_verified.signs.brackets import Brackets as Brackets
    from gspot_verified.signs.brackets import zeros_at as zeros_at
    from gspot_verified.signs.count_law import number_of_zeros as number_of_zeros
    from gspot_verified.signs.iwc import IwcResult as IwcResult
    from gspot_verified.signs.ranges import Range as Range
    from gspot_verified.signs.side import SideSwitching as SideSwitching
    from gspot_verified.signs.side import SignInterval as SignInterval
    from gspot_verified.signs.side import gamma_sign as gamma_sign
    from gspot_verified.signs.side import side_switching as side_switching
    from gspot_verified.signs.sign import SignResult as SignResult
    from gspot_verified.signs.sign import sign_on_ranges as sign_on_ranges
    from gspot_verified.signs.zeros import ZerosResult as ZerosResult
    from gspot_verified.signs.zeros import zeros_on_range as zeros_on_range
    from gspot_verified.theta_function.arrays import theta_of_floats as theta_of_floats
    from gspot_verified.theta_function.asymptotic_coefficients import coefficient as coefficient
    from gspot_verified.theta_function.asymptotic_coefficients import (
        coefficient_by_inversion as coefficient_by_inversion,
    )
    from gspot_verified.theta_function.evaluate import Evaluation as Evaluation
    from gspot_verified.theta_function.evaluate import evaluate as evaluate
    from gspot_verified.theta_function.float_balls import FloatBalls as FloatBalls
    from gspot_verified.theta_function.initial_values import initial_values as initial_values
    from gspot_verified.theta_function.initial_values import paper_initial_values as paper_initial_values
    from gspot_verified.theta_function.integer import polynomial as polynomial
    from gspot_verified.theta_function.prepared import PreparedTheta as PreparedTheta
    from gspot_verified.theta_function.routes import BudgetError as BudgetError
    from gspot_verified.theta_function.routes import theta_by as theta_by
    from gspot_verified.theta_function.theta import theta as theta
    from gspot_verified.uniform.bound import UniformBound as UniformBound
    from gspot_verified.uniform.bound import uniform_bound as uniform_bound
    from gspot_verified.uniform.side import UniformSide as UniformSide
    from gspot_verified.uniform.side import uniform_side as uniform_side
    from gspot_verified.verdict import Outcome as Outcome
    from gspot_verified.verdict import Reason as Reason
    from gspot_verified.verdict import Verdict as Verdict

__version__ = "0.1.0"

__homes__ = {
    "Approach": "mechanisms.approach_result",
    "Brackets": "signs.brackets",
    "BudgetError": "theta_function.routes",
    "Classification": "mechanisms.classify",
    "CompliantIwc": "compliant.iwc",
    "Dyadic": "dyadic",
    "Evaluation": "theta_function.evaluate",
    "FloatBalls": "theta_function.float_balls",
    "GSpotError": "expansion.system",
    "IwcResult": "signs.iwc",
    "Mechanism": "mechanisms.mechanism",
    "MechanismError": "mechanisms.mechanism",
    "Outcome": "verdict",
    "Picture": "report.canvas",
    "PreparedTheta": "theta_function.prepared",
    "Range": "signs.ranges",
    "Reason": "verdict",
    "SideSwitching": "signs.side",
    "SignInterval": "signs.side",
    "SignResult": "signs.sign",
    "Sweep": "mechanisms.sweep_result",
    "Trajectory": "expansion.trajectory",
    "UniformBound": "uniform.bound",
    "UniformSide": "uniform.side",
    "Verdict": "verdict",
    "ZerosResult": "signs.zeros",
    "approach": "mechanisms.approach",
    "ball_text": "balls",
    "classify": "mechanisms.classify",
    "classify_all": "mechanisms.classify_all",
    "coefficient": "theta_function.asymptotic_coefficients",
    "coefficient_by_inversion": "theta_function.asymptotic_coefficients",
    "critical_friction": "mechanisms.critical_friction",
    "evaluate": "theta_function.evaluate",
    "expand": "mechanisms.expand",
    "find_g_spots": "mechanisms.all_g_spots",
    "gamma_sign": "signs.side",
    "initial_values": "theta_function.initial_values",
    "iwc": "mechanisms.iwc",
    "load": "mechanisms.load",
    "number_of_zeros": "signs.count_law",
    "paper_initial_values": "theta_function.initial_values",
    "plot": "report.plot",
    "polynomial": "theta_function.integer",
    "residual_bounds": "expansion.residual",
    "shipped_names": "mechanisms.shipped",
    "side_switching": "signs.side",
    "sign_on_ranges": "signs.sign",
    "sweep": "mechanisms.sweep",
    "theta": "theta_function.theta",
    "theta_by": "theta_function.routes",
    "theta_of_floats": "theta_function.arrays",
    "uniform_bound": "uniform.bound",
    "uniform_side": "uniform.side",
    "zeros_at": "signs.brackets",
    "zeros_on_range": "signs.zeros",
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
