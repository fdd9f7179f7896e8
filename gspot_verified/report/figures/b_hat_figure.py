"""b-hat on the slow manifold of the compliant model at several epsilon, against Theta, its limit."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import ExactInput, ball, exact, float_bounds, working_bits
from gspot_verified.report.pictures.canvas import COLOURS, INK, STYLES, Picture, canvas, picture, styled
from gspot_verified.theta_function.value.evaluate import evaluate

_EPSILONS = (fmpq(1), fmpq(1, 10), fmpq(1, 1000))  # from far to close to leading order
_POINTS = tuple(fmpq(k, 12) for k in range(-48, 37))
_BITS = 100  # beyond what a picture shows; any is correct
_MAX_BETA = 20  # a limit of effort


def scaled_b_hat(beta: fmpq, epsilon: fmpq, tau: fmpq) -> arb:
    """kappa^beta epsilon^(-2 beta/3) b-hat/C_1 at a T next to tau/eta: G_beta(tau; eta) (proofs/monotone.md, section
    1)."""
    with working_bits(_BITS):
        eta = scale(epsilon)
        time = (arb(tau) / eta).mid()
    value = slow_value(time, beta, epsilon, digits=15).value
    with working_bits(_BITS):
        return value * eta ** ball(beta)


def b_hat_picture(beta: ExactInput = "7/3", epsilons: Sequence[ExactInput] = _EPSILONS) -> Picture:
    """The curves as a figure.

    :raises ValueError: beta is not a rational in (0, 20], or an epsilon is not a positive rational.
    """
    parameter = exact(beta, "beta")
    if not isinstance(parameter, fmpq) or not 0 < parameter <= _MAX_BETA:
        raise ValueError(f"beta: expected a rational in (0, {_MAX_BETA}], got {beta}")
    small = []
    for value in epsilons:
        epsilon = exact(value, "epsilon")
        if not isinstance(epsilon, fmpq) or not epsilon > 0:
            raise ValueError(f"epsilon: expected a rational > 0, got {value}")
        small.append(epsilon)
    return styled(lambda: _draw(parameter, small))()


def _draw(beta: fmpq, epsilons: Sequence[fmpq]) -> Picture:
    figure = canvas(4.2)
    axes = figure.add_subplot()
    at = [float(ball(tau).mid()) for tau in _POINTS]
    for epsilon, colour, style in zip(epsilons, COLOURS, STYLES[1:], strict=False):
        bounds = [float_bounds(scaled_b_hat(beta, epsilon, tau)) for tau in _POINTS]
        middles = [(low + high) / 2 for low, high in bounds]
        axes.plot(at, middles, color=colour, linestyle=style, label=f"ε = {epsilon}")
    axes.plot(at, [float(evaluate(tau, beta).value.mid()) for tau in _POINTS], color=INK, label=f"Θ(τ, {beta})")
    axes.axhline(0, color=INK, linewidth=0.7)
    axes.set(xlabel=r"$\tau = \kappa\,t\,\varepsilon^{-2/3}$", xlim=(at[0], at[-1]))
    axes.set_ylabel(r"$\hat{b}$ in units of $C_1\,\kappa^{-\beta}\,\varepsilon^{2\beta/3}$")
    axes.set_title(f"the compliant model on its slow manifold, β = {beta}", loc="left")
    axes.legend()
    return picture(
        figure,
        "b-hat",
        f"b̂(t) on the slow manifold against Θ(τ, {beta})",
        f"Certified: enclosures of b̂, from the exact solution of the compliant model, and of Θ at {len(_POINTS)} "
        "points τ = −4, …, 3 for each ε (α₁ = −1, else ε|α₁|). Only drawn: the lines between them. That the curves "
        "tend to Θ as ε → 0 is a theorem (proofs/epsilon_series.md), not shown by the points.",
        "Curves that lie on one another on the left and part on the right; for small epsilon they are next to Theta.",
    )
