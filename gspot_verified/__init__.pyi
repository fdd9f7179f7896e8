"""The public names and their homes: the only list. ``__init__.py`` reads it, and so does who reads types."""

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
from gspot_verified.signs.cover.sign import sign as sign
from gspot_verified.signs.gamma.count_law import number_of_zeros as number_of_zeros
from gspot_verified.signs.gamma.side import SideSwitching as SideSwitching
from gspot_verified.signs.gamma.side import SignInterval as SignInterval
from gspot_verified.signs.gamma.side import gamma_sign as gamma_sign
from gspot_verified.signs.gamma.side import side as side
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

__version__: str
__homes__: dict[str, str]
__all__: list[str]
