"""A system in which no slope of F, G, alpha_i vanishes by chance."""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from gspot_verified.expansion.series.system import System
from gspot_verified.functions.derivative import plus, times
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.testing import extended_example


def varying_example(chi: fmpq) -> System:
    """The extended example with alpha_1 = -1 + chi b + v^2, alpha_2 = -1 + 2 x + 5 v, alpha_3 = -3/2 + 3 v."""
    system = extended_example(chi=chi)
    x = [Variable(i) for i in range(6)]
    first = plus(system.alpha_1, times(x[3], x[3]))
    second = plus(plus(Constant(fmpq(-1)), times(Constant(fmpq(2)), x[0])), times(Constant(fmpq(5)), x[3]))
    rising = times(Constant(fmpq(3)), x[3])
    third, control = plus(Constant(fmpq(-3, 2)), rising), plus(Constant(fmpq(3, 2)), times(Constant(fmpq(-1)), rising))
    return replace(
        system,
        F=(*system.F[:4], first, second),
        G=(*system.G[:5], control),
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
    )
