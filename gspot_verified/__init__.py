"""Verified numerics for the Painlevé paradox: certified values and signs of Θ(τ, β), and the paper claim by claim."""

from gspot_verified.balls import ball_text
from gspot_verified.dyadic import Dyadic
from gspot_verified.signs.side import SideSwitching, SignInterval, gamma_sign, side_switching
from gspot_verified.theta.asymptotic_coefficients import coefficient, coefficient_by_inversion
from gspot_verified.theta.evaluate import Evaluation, evaluate, theta
from gspot_verified.theta.initial_values import initial_values, paper_initial_values
from gspot_verified.theta.integer import polynomial
from gspot_verified.theta.routes import BudgetError, theta_by
from gspot_verified.verdict import Outcome, Reason, Verdict

__version__ = "0.1.0"

__all__ = [
    "BudgetError",
    "Dyadic",
    "Evaluation",
    "Outcome",
    "Reason",
    "SideSwitching",
    "SignInterval",
    "Verdict",
    "ball_text",
    "coefficient",
    "coefficient_by_inversion",
    "evaluate",
    "gamma_sign",
    "initial_values",
    "paper_initial_values",
    "polynomial",
    "side_switching",
    "theta",
    "theta_by",
]
