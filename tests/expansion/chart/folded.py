"""A system whose state is a known function of p, b, y, v: p = x - x^2, which folds at p = 1/4, and b = (1 + x) w."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.expressions import Constant, Expression, Power, Variable
from gspot_verified.functions.rings import RATIONALS

X, W, Y, V = (Variable(i) for i in range(4))
ONE, NOTHING = Constant(fmpq(1)), Constant(fmpq(0))
P, B = X - X * X, (ONE + X) * W
ROOT = Power(ONE - Constant(fmpq(4)) * Variable(0), fmpq(1, 2))
INVERSE = (ONE - ROOT) * Constant(fmpq(1, 2))
"""x as a function of p, which is variable 0."""


def folded(first: Expression, second: Expression, third: Expression) -> System:
    """With these alphas, functions of (x, w, y, v): x' = alpha_1/(1 - 2 x), w' = (b' - w x')/(1 + x)."""
    turn = first / (ONE - Constant(fmpq(2)) * X)
    return System(
        "folded system",
        F=(turn, (second - W * turn) / (ONE + X), V, B),
        G=(NOTHING, Constant(fmpq(-1)) * third / (ONE + X), NOTHING, P),
        y=Y,
        v=V,
        p=P,
        b=B,
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
        J=(),
        point=(fmpq(0),) * 4,
        ring=RATIONALS,
        state=("x", "w", "y", "v"),
        regularisation=PAPER,
    )


def charted(system: System, order: int = 4) -> AffineSystem:
    """Its alphas by the chart."""
    chart = Chart(system)
    first, second, third = (
        Analytic(function, order, "alpha", chart) for function in (system.alpha_1, system.alpha_2, system.alpha_3)
    )
    return AffineSystem(first, second, third, system.regularisation, chart)
