"""Theta as one function of a number or of a numpy array."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast, overload

from gspot_verified.numbers.balls import ExactInput
from gspot_verified.theta_function.value.evaluate import enclosure

if TYPE_CHECKING:
    from flint import arb
    from numpy import ndarray


@overload
def theta(tau: ExactInput, beta: ExactInput, derivative: int = 0, digits: int = 15) -> arb: ...


@overload
def theta(
    tau: ndarray[Any, Any], beta: ExactInput | ndarray[Any, Any], derivative: int = 0, digits: int = 15
) -> ndarray[Any, Any]: ...


@overload
def theta(tau: ExactInput, beta: ndarray[Any, Any], derivative: int = 0, digits: int = 15) -> ndarray[Any, Any]: ...


def theta(
    tau: ExactInput | ndarray[Any, Any],
    beta: ExactInput | ndarray[Any, Any],
    derivative: int = 0,
    digits: int = 15,
) -> Any:
    """An enclosure of d^k Theta/dtau^k (tau, beta) with relative accuracy 10^-digits, as an ``arb``.

    Numpy arrays for ``tau`` or ``beta`` are broadcast and give an object array of balls; ``theta_of_floats`` gives
    midpoints and radii as doubles (see :mod:`gspot_verified.theta_function.arrays.arrays`).
    Arguments and errors: see :func:`gspot_verified.theta_function.value.evaluate.evaluate`, which also says whether the
    accuracy was reached: next to a zero of Theta, or for wide input balls, the ball returned here is valid but wider
    than asked.

    Printing an ``arb`` shows as many digits as flint's own precision; ``ball_text`` shows as many as asked.

    >>> from gspot_verified import ball_text
    >>> ball_text(theta(-50, "7/3", digits=20), 20)
    '[9210.1042163477515727 +/- 4.20e-17]'
    >>> theta(2, 3, derivative=1)
    -12.0000000000000
    """
    if "ndarray" in (type(tau).__name__, type(beta).__name__):  # by name: numpy is not imported before someone uses it
        from gspot_verified.theta_function.arrays.arrays import theta_array

        return theta_array(tau, beta, derivative, digits)
    return enclosure(cast("ExactInput", tau), cast("ExactInput", beta), derivative, digits)
