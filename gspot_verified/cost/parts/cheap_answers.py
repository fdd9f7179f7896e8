"""What accuracy buys: signs that doubles or mpmath at its own precision get wrong, beside the certified ones.

The cheap answers are taken in the plainest way that a user would write; each certified one comes by two routes, which
must agree.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.cost.measurement.measurement import NO_ANSWER, NOT_ASKED, CheapAnswer
from gspot_verified.cost.times.baseline import mpmath_sum
from gspot_verified.numbers.balls import approximate, sign_of, working_bits
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT
from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.scenes.side import FAILED, LASTS, LOST, NO_EVENT, certified_side, float_side
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.value.routes import shifted_parameter, theta_by

_TERMS = 2_000  # of each chain: a limit, as a user would set one
_SIGNS = {1: "positive", -1: "negative", 0: "zero"}
_BITS = 400  # enough for a difference of size r^3 of terms of size r


@dataclass(frozen=True, slots=True)
class Case:
    """One question; ``certified``: two routes by name, each giving the answer in words, or None where it is open."""

    question: str
    why: str
    certified: tuple[tuple[str, Callable[[], str | None]], ...]
    doubles: Callable[[], str]
    doubles_how: str
    mpmath: Callable[[], str]

    def answered(self) -> CheapAnswer:
        """All three answers.

        :raises ArithmeticError: the two certified routes do not agree, or one has no answer.
        """
        (first, by_first), (second, by_second) = self.certified
        one, other = by_first(), by_second()
        if one is None or one != other:
            raise ArithmeticError(f"{self.question}: {first} says {one}, {second} says {other}")
        cheap = self.doubles(), self.doubles_how, self.mpmath()
        return CheapAnswer(self.question, self.why, one, (first, second), *cheap)


def answers() -> tuple[CheapAnswer, ...]:
    """Every case, asked now."""
    return tuple(case.answered() for case in cases())


def cases() -> tuple[Case, ...]:
    """All cases."""
    loss = "the terms of the series reach {}, and cancel"
    slope = f"{loss.format('6·10²³')}; a positive slope for a β in (0, 1) would refute the paper’s central claim"
    waves = "the three terms with ₁F₂ are more than 10¹⁷ times their sum, and cancel"
    return (
        _theta("Θ(−25, 1/2)", fmpq(-25), fmpq(1, 2), 0, ("negative", "laplace"), loss.format("9·10³²")),
        _theta("dΘ/dτ(−20, 1/2)", fmpq(-20), fmpq(1, 2), 1, ("negative", "laplace"), slope),
        _theta("Θ(−10⁴, −7/2)", fmpq(-(10**4)), fmpq(-7, 2), 0, ("negative", "laplace"), waves),
        _theta("d³Θ/dτ³(−10⁶, 1/2)", fmpq(-(10**6)), fmpq(1, 2), 3, ("negative", "laplace"), waves),
        _at_a_zero(),
        _side_of_an_integer(),
        _exponent(),
        _run(),
    )


def _theta(name: str, tau: fmpq, beta: fmpq, derivative: int, routes: tuple[str, str], why: str) -> Case:
    shifted, factor = shifted_parameter(beta, derivative, 53)
    assert isinstance(shifted, fmpq)
    turned = -1 if factor < 0 else 1

    def by(route: str) -> Callable[[], str | None]:
        return lambda: _word(sign_of(theta_by(route, tau, beta, derivative=derivative, digits=15)))

    return Case(
        f"the sign of {name}",
        why,
        tuple((f"the route “{route}”", by(route)) for route in routes),
        lambda: _float_word(theta_in_doubles(tau, shifted), turned),
        "the Taylor series",
        lambda: _mpmath_word(tau, shifted, turned),
    )


def theta_in_doubles(tau: fmpq, beta: fmpq) -> float | None:
    """Theta by t01-t03 and the three chains of its Taylor series in doubles; None where that overflows."""
    point, parameter, total = approximate(tau), approximate(beta), 0.0
    try:
        for j in range(3):
            start = math.gamma((j - parameter) / 3) / math.gamma(-parameter) / 3 ** ((3 - j + parameter) / 3)
            term = start * point**j / (1 + (j > 1))
            for n in range(j, 3 * _TERMS, 3):
                total += term
                term *= (n - parameter) * point**3 / ((n + 1) * (n + 2) * (n + 3))
    except (ValueError, OverflowError, ZeroDivisionError):
        return None
    return total if math.isfinite(total) else None


def _mpmath_word(tau: fmpq, beta: fmpq, turned: int) -> str:
    import mpmath  # type: ignore[import-untyped]

    with mpmath.workprec(53):
        try:
            value = turned * mpmath_sum(mpmath.mp, tau, beta, {"maxterms": 10**6})
        except (mpmath.mp.NoConvergence, ValueError, ZeroDivisionError, OverflowError):
            return NO_ANSWER
        return _SIGNS[int(mpmath.sign(value))]


def _at_a_zero() -> Case:
    beta = fmpq(5, 2)
    tau = zeros_at(beta, 18).brackets[1][0]
    routes = ("taylor", "laplace")

    def by(route: str) -> Callable[[], str | None]:
        return lambda: _word(sign_of(theta_by(route, tau, beta, derivative=1, digits=30)))

    return Case(
        "the sign of dΘ/dτ(τ, 5/2) at the left end of a bracket of width 10⁻¹⁸ of its zero near 1.53",
        "the value is about 10⁻¹⁸, below the rounding errors of its terms, and τ itself is rounded",
        tuple((f"the route “{route}”", by(route)) for route in routes),
        lambda: _float_word(theta_in_doubles(tau, beta - 1), -1),
        "the Taylor series",
        lambda: _mpmath_word(tau, beta - 1, -1),
    )


def _side_of_an_integer() -> Case:
    beta = (fmpq(3, 10) + fmpq(1, 10**17)) * 10

    def by_gamma() -> str | None:
        return _word(sign_of(reciprocal_gamma(-beta, 100)))

    def by_floor() -> str | None:
        return _word(1 if int(beta.floor()) % 2 else -1) if beta > 0 and beta.q != 1 else None

    def in_mpmath() -> str:
        import mpmath

        with mpmath.workprec(53):
            try:
                return _SIGNS[
                    int(mpmath.sign(mpmath.gamma(-(mpmath.mpf("0.3") + mpmath.mpf("1e-17")) / mpmath.mpf("0.1"))))
                ]
            except ValueError:
                return NO_ANSWER

    def in_doubles() -> str:
        return _float_word(math.gamma(-(0.3 + 1e-17) / 0.1), 1)

    return Case(
        "the sign of Γ(−β), which chooses the side that lifts off, at β = (3/10 + 10⁻¹⁷)/(1/10)",
        "β = 3 + 10⁻¹⁶, and the quotient of the rounded numbers is less than 3",
        (("1/Γ in balls", by_gamma), ("the parity of ⌊β⌋", by_floor)),
        in_doubles,
        "the quotient, then Γ",
        in_mpmath,
    )


def _exponent() -> Case:
    r = fmpq(1, 10**8)

    def in_balls() -> str | None:
        with working_bits(_BITS):
            x = arb(r)
            return _word(sign_of(x - x**2 / 2 - x**3 / 3 - (1 + x).log()))

    def by_its_series() -> str | None:
        # -2 r^3/3 + r^4/4 - r^5/5 + ...: from r^4 on alternating and decreasing, so its sum is between 0 and r^4/4.
        return "negative" if -2 * r**3 / 3 + r**4 / 4 < 0 else None

    def in_mpmath() -> str:
        import mpmath

        with mpmath.workprec(53):
            x = mpmath.mpf(1) / 10**8
            return _SIGNS[int(mpmath.sign(x - x**2 / 2 - x**3 / 3 - mpmath.log(1 + x)))]

    def in_doubles() -> str:
        x = 1e-8
        return _float_word(x - x**2 / 2 - x**3 / 3 - math.log(1 + x), 1)

    return Case(
        "the sign of ψ(r) = r − r²/2 − r³/3 − ln(1 + r), the exponent of the exact solution, at r = 10⁻⁸",
        "r cancels against ln(1 + r), and −2r³/3 is left",
        (("balls of 400 bits", in_balls), ("two terms of its series, exactly", by_its_series)),
        in_doubles,
        "the formula",
        in_mpmath,
    )


def _run() -> Case:
    scene: Scene = load_scene("fig-varsim1", beta=fmpq(13, 2), nu=2)

    def by_integrator() -> str | None:
        return {LIFT_OFF: LOST, IMPACT: LASTS}.get(_first_event(scene))

    def in_doubles() -> str:
        side = float_side(scene, "Radau", 1e-3)
        return NO_ANSWER if side in (FAILED, NO_EVENT) else side

    return Case(
        "whether contact is lost or lasts, Fig. varsim1 with β = 13/2, ν = 2, ε = 10⁻³",
        "next to the G-spot the signal is smaller than the tolerance",
        (("the exact solution", lambda: certified_side(scene).side), ("the validated integrator", by_integrator)),
        in_doubles,
        "scipy Radau, its own tolerance 10⁻³",
        lambda: NOT_ASKED,
    )


def _first_event(scene: Scene) -> str:
    run = integrated_run(scene)
    return run.events[0].name if run.events else run.fate


def _word(sign: int | None) -> str | None:
    return None if sign is None else _SIGNS[sign]


def _float_word(value: Any, turned: int) -> str:
    return NO_ANSWER if value is None else _SIGNS[(value * turned > 0) - (value * turned < 0)]
