"""Theta as one function of a number or of a numpy array."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast, overload

from gspot_verified.numbers.balls import ExactInput
from gspot_verified.numbers.complex_numbers import ComplexInput
from gspot_verified.theta_function.value.evaluate import RealNumber, enclosure

if TYPE_CHECKING:
    from flint import acb, arb
    from numpy import ndarray


@overload
def theta(tau: RealNumber, beta: ExactInput, derivative: int = 0, digits: int = 15) -> arb: ...


@overload
def theta(tau: ComplexInput, beta: ExactInput, derivative: int = 0, digits: int = 15) -> acb: ...


@overload  # a text may stand for a real or a complex number
def theta(tau: str, beta: ExactInput, derivative: int = 0, digits: int = 15) -> Any: ...


@overload
def theta(
    tau: ndarray[Any, Any], beta: ExactInput | ndarray[Any, Any], derivative: int = 0, digits: int = 15
) -> ndarray[Any, Any]: ...


@overload
def theta(
    tau: ExactInput | ComplexInput, beta: ndarray[Any, Any], derivative: int = 0, digits: int = 15
) -> ndarray[Any, Any]: ...


def theta(
    tau: ExactInput | ComplexInput | ndarray[Any, Any],
    beta: ExactInput | ndarray[Any, Any],
    derivative: int = 0,
    digits: int = 15,
) -> Any:
    """An enclosure of d^k Theta/dtau^k (tau, beta) with relative accuracy 10^-digits, as an ``arb``.

    At a complex tau (a string such as ``"1+2i"``, an ``acb``, an ``mpc`` of mpmath) it is an ``acb``, a rectangle, and
    the accuracy is that of the complex number.

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
    >>> ball_text(theta("1+2i", "7/3", digits=10), 10)
    '[0.1550477658 +/- 4.01e-11] + [6.813060144 +/- 4.40e-10]i'
    """
    if "ndarray" in (type(tau).__name__, type(beta).__name__):  # by name: numpy is not imported before someone uses it
        from gspot_verified.theta_function.arrays.arrays import theta_array

        return theta_array(tau, beta, derivative, digits)
    return enclosure(cast("ExactInput | ComplexInput", tau), cast("ExactInput", beta), derivative, digits)
