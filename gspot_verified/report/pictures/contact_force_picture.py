"""lambda_N(tau) at leading order for one system, on both sides of the distinguished trajectory."""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from gspot_verified.leading_order.contact_force import ContactForce, rational
from gspot_verified.numbers.balls import ExactInput, ball, float_bounds
from gspot_verified.report.pictures.canvas import BLUE, INK, LAMBDA_N, VERMILION, Picture, canvas, picture, styled

_POINTS = tuple(fmpq(k, 16) for k in range(-80, 65))
_SIDES = ((1, BLUE, "-"), (-1, VERMILION, "--"))


def contact_force_picture(force: ContactForce, epsilon: ExactInput = "1/1000") -> Picture:
    """The contact force with the C_1 of ``force`` and with its negative.

    :raises ValueError: epsilon is not a positive rational.
    """
    small = rational(epsilon, "epsilon")
    if not small > 0:
        raise ValueError(f"epsilon: expected a number > 0, got {epsilon}")
    return styled(lambda: _draw(force, small))()


def _draw(force: ContactForce, epsilon: fmpq) -> Picture:
    figure = canvas(4.2)
    axes = figure.add_subplot()
    at = [float(ball(tau).mid()) for tau in _POINTS]
    for sign, colour, style in _SIDES:
        side = replace(force, c1=sign * force.c1)
        bounds = [float_bounds(side.value(tau, epsilon)) for tau in _POINTS]
        label = f"C₁ = {str(side.c1).replace('-', '−')}: λ_N → {'+' if side.takes_impact else '−'}∞"
        axes.plot(at, [(low + high) / 2 for low, high in bounds], color=colour, linestyle=style, label=label)
    axes.axhline(0, color=INK, linewidth=0.9)
    mean = float(ball(force.mean if isinstance(force, ContactForce) else force.mean()).mid())
    axes.axhline(mean, color=INK, linewidth=0.9, linestyle=":", label="mean force")
    axes.set(xlabel=r"$\tau = \kappa\,t\,\varepsilon^{-2/3}$", ylabel=f"force {LAMBDA_N}", xlim=(at[0], at[-1]))
    axes.set_title(f"β = {force.beta}, ε = {epsilon}, at leading order", loc="left")
    axes.legend(loc="best")
    return picture(
        figure,
        "contact-force",
        f"λ_N(τ) at leading order, β = {force.beta}, ε = {epsilon}",
        f"Certified: enclosures of the paper's leading order at {len(_POINTS)} points τ = −5, …, 4. Only drawn: the "
        "lines between them. The compliant model's own force at this ε is another function (see the command force).",
        "Two curves that leave the mean force in opposite directions.",
    )
