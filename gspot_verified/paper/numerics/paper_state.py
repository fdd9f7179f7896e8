"""The initial data of the paper's simulations (Fig. varsim1)."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_state
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import ExactInput

START = fmpq(1, 2)


def paper_state(model: CompliantModel, nu: ExactInput) -> CompliantState:
    """p = 1/2, b = -|nu p alpha_2/(alpha_3 - alpha_1)|, y = 2 epsilon^2 b/p, z = epsilon^2 b/p, v = 0.

    :raises TypeError: a float.
    :raises ValueError: a ball; nu = 0 or alpha_2 = 0 (y = z = 0: not in contact).

    >>> from gspot_verified import compliant_model
    >>> paper_state(compliant_model("5/2", "1/1000"), "1/2").b
    -1/6
    """
    b = -abs(rational(nu, "nu") * START * model.mean_force)
    if b == 0:
        raise ValueError("nu: expected nu and alpha_2 other than 0; the state would not be in contact")
    z = model.epsilon**2 * b / START
    return compliant_state(START, b, 2 * z, 0, z)
