"""The fastest oscillation at the start of a scene, and what the integrator pays for it: floats, nothing is proved."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.scene.scene import Scene

_ANGLE_OF_A_STEP = 2.2  # radians of the oscillation in one step at 192 bits, as counted; a little more at more bits
_DECAYED = 90.0  # -log of what is left of it where it no longer shortens the steps: 2^-130


@dataclass(frozen=True)
class FastOscillation:
    """``rate`` in radians, ``growth`` e^(growth t), both in a unit of time; it is followed up to the time ``until``."""

    rate: float
    growth: float
    until: float

    @property
    def periods(self) -> float:
        """How many of them the integrator follows."""
        return self.rate * self.until / (2 * math.pi)

    @property
    def steps(self) -> int:
        """About so many steps that takes, at each precision."""
        return math.ceil(self.rate * self.until / _ANGLE_OF_A_STEP)

    def __str__(self) -> str:
        return (
            f"the fastest oscillation at the start has {self.rate:.3g} radians in a unit of time and goes like "
            f"exp({self.growth:.3g} t): {self.periods:.3g} periods to follow up to t = {self.until:.3g}, "
            f"about {self.steps} steps at each precision (floats)"
        )


def fast_oscillation(scene: Scene) -> FastOscillation | None:
    """That of the largest imaginary part among the eigenvalues of the equations' derivative; None where all are real.

    Where it decays, it is followed until nothing of it is left, or to the end of the scene.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> print(fast_oscillation(load_scene("rod")))
    the fastest oscillation at the start has 515 radians in a unit of time and goes like exp(-62.5 t): 20.5 periods to \
follow up to t = 0.25, about 59 steps at each precision (floats)
    """
    import numpy as np

    system, start = scene.system(scene.first_phase()), scene.scaled_initial()
    state = [*(approximate(start[name]) for name in system.states), 0.0]
    entries = float_function([entry for row in system.jacobian() for entry in row])
    slopes = np.array(entries(state)).reshape(len(system.states), -1)
    if not np.isfinite(slopes).all():
        return None
    value = max(np.linalg.eigvals(slopes), key=lambda each: each.imag) / approximate(scene.epsilon)
    until, growth = approximate(scene.until), float(value.real)
    if not value.imag > 0:
        return None
    return FastOscillation(float(value.imag), growth, min(until, _DECAYED / -growth) if growth < 0 else until)
