"""Verified numerics for the Painlevé paradox: certified values and signs of Θ(τ, β), and the paper claim by claim."""

from gspot_verified.balls import ball_text
from gspot_verified.compliant.iwc import CompliantIwc, iwc
from gspot_verified.dyadic import Dyadic
from gspot_verified.mechanisms.expand import expand
from gspot_verified.signs.brackets import Brackets, zeros_at
from gspot_verified.signs.count_law import number_of_zeros
from gspot_verified.signs.iwc import IwcResult
from gspot_verified.signs.ranges import Range
from gspot_verified.signs.side import SideSwitching, SignInterval, gamma_sign, side_switching
from gspot_verified.signs.sign import SignResult, sign_on_ranges
from gspot_verified.signs.zeros import ZerosResult, zeros_on_range
from gspot_verified.theta_function.asymptotic_coefficients import coefficient, coefficient_by_inversion
from gspot_verified.theta_function.evaluate import Evaluation, evaluate
from gspot_verified.theta_function.initial_values import initial_values, paper_initial_values
from gspot_verified.theta_function.integer import polynomial
from gspot_verified.theta_function.routes import BudgetError, theta_by
from gspot_verified.theta_function.theta import theta
from gspot_verified.verdict import Outcome, Reason, Verdict

__version__ = "0.1.0"

__all__ = [
    "Brackets",
    "BudgetError",
    "CompliantIwc",
    "Dyadic",
    "Evaluation",
    "IwcResult",
    "Outcome",
    "Range",
    "Reason",
    "SideSwitching",
    "SignInterval",
    "SignResult",
    "Verdict",
    "ZerosResult",
    "ball_text",
    "coefficient",
    "coefficient_by_inversion",
    "evaluate",
    "expand",
    "gamma_sign",
    "initial_values",
    "iwc",
    "number_of_zeros",
    "paper_initial_values",
    "polynomial",
    "side_switching",
    "sign_on_ranges",
    "theta",
    "theta_by",
    "zeros_at",
    "zeros_on_range",
]
