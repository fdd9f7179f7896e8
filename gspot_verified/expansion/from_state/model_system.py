"""The model system: constant alpha_1, alpha_2, alpha_3, with the state (p, b, y, v). Paper, Sec. 4."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.expressions import Constant, Variable


def model_system(alpha_1: fmpq, alpha_2: fmpq, alpha_3: fmpq, regularisation: Regularisation) -> System:
    """p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N, y' = v, v' = b + p lambda_N.

    >>> from gspot_verified.expansion.series.regularisation import PAPER
    >>> model_system(fmpq(-1), fmpq(-1), fmpq(-3, 2), PAPER).check()
    (-1, -1, -3/2)
    """
    first, second, third = Constant(alpha_1), Constant(alpha_2), Constant(alpha_3)
    nothing = Constant(fmpq(0))
    p, b, y, v = (Variable(i) for i in range(4))
    return System(
        "model system",
        F=(first, second, v, b),
        G=(nothing, -third, nothing, p),
        y=y,
        v=v,
        p=p,
        b=b,
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
        J=(),
        point=(fmpq(0),) * 4,
        state=("p", "b", "y", "v"),
        regularisation=regularisation,
    )
