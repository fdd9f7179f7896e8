"""How far from the G-spot the power series of the alphas may reach. A heuristic: it proves nothing."""

from __future__ import annotations

import math

from flint import arb, fmpq

from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.balls import approximate, ball

_FIRST, _LAST = 6, 12  # two orders whose terms are compared


def radius(chart: Chart) -> float:
    """About the p up to which the series in p of alpha_1, alpha_2, alpha_3 converge, at the mean force."""
    system = chart.system
    functions = system.alpha_1, system.alpha_2, system.alpha_3
    first, second, third = (ball(value) for value in system.values_at_point(functions))
    ray = Cone(fmpq(0), fmpq(0), second / (third - first), fmpq(0), fmpq(0), fmpq(0))
    star = [ball(value) for value in system.point]
    slopes = [[ball(value) for value in row] for row in chart.slopes()]
    series = chart.series(functions, ray.rows(_LAST + 1)[1:], star, slopes, NumberTerms(BALLS), BALLS)
    ratios = [_size(series[one][_FIRST]) / _size(series[one][_LAST]) for one in functions]
    return math.exp(math.log(min(ratios)) / (_LAST - _FIRST))


def _size(value: arb) -> float:
    return max(approximate(abs(value)), 1e-30)
