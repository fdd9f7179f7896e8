"""The contact force at leading order on a half-line: a certified eps_0 below which it stays positive (impact without
collision), or a certified bracket of the lift-off time.

Proof page: ``proofs/iwc.md``. "At leading order" is the paper's approximation; its error is not bounded here.
"""

from __future__ import annotations

import decimal
import math
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.balls import ExactInput, ball_text, working_bits
from gspot_verified.dyadic import Dyadic
from gspot_verified.signs.brackets import decimal_text
from gspot_verified.signs.contact_force import LEAST_TENS, ContactForce, contact_force, rational, rounded_down
from gspot_verified.signs.stretches import Bracket, NotAbove, first_crossing, minimum, stretches
from gspot_verified.verdict import Outcome, Reason, Verdict

MAX_DIGITS = 100
MAX_START = 10**6
PAPER_EPSILON = fmpq(1, 1000)
GROWTH_EXPONENTS = (10, 100, 1_000, 10_000)
_GROWTH_DIGITS = 3
_CRITICAL_DIGITS = 15
_SHOWN_BITS = 512
_LEADING = "at leading order"
_CONTEXT = decimal.Context(prec=200, Emax=10**6, Emin=-(10**6))


@dataclass(frozen=True, slots=True)
class LiftOff:
    """lambda_N > 0 on [start, lower], and it has one zero, with a change of sign, in the open interval (lower, upper).

    ``number`` counts the zeros on [start, infinity); ``ratio`` is the time over ((beta-1) ln(1/eps))^(2/3), for
    beta > 1 and eps < 1; ``whole_line``: lambda_N > 0 to the left of the start as well. Without a proof both ends are
    None and the verdict says why.
    """

    epsilon: fmpq
    lower: fmpq | None
    upper: fmpq | None
    number: int | None
    ratio: arb | None
    whole_line: bool
    verdict: Verdict

    def __str__(self) -> str:
        if self.lower is None or self.upper is None:
            return f"ε = {_short(self.epsilon)}: {self.verdict.outcome.value}"
        ratio = "" if self.ratio is None else f", over ((β-1) ln(1/ε))^(2/3): {ball_text(self.ratio, 4)}"
        return f"ε = {_short(self.epsilon)}: lift-off in {decimal_text(self.lower, self.upper)}{ratio}"

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``."""
        known = self.lower is not None and self.upper is not None
        return {
            "epsilon": str(self.epsilon),
            "bracket": [str(self.lower), str(self.upper)] if known else None,
            "zeros": self.number,
            "ratio": None if self.ratio is None else str(Dyadic.from_ball(self.ratio)),
            "verdict": self.verdict.to_json(),
        }


@dataclass(frozen=True, slots=True)
class IwcResult:
    """The verdict for one system and one sign of C_1, and the numbers behind it.

    On the side C_1/Gamma(-beta) > 0: ``epsilon_0``, a number certainly below the largest possible one, which
    ``largest_epsilon`` encloses; both None when ``every_epsilon``. ``minimum``: where sign(C_1) dTheta/dtau is least,
    and that value. On the other side: ``lift_off`` and the table ``growth``. ``whole_line``: the verdict, when proved,
    holds to the left of ``start`` as well.
    """

    force: ContactForce
    start: fmpq
    whole_line: bool
    verdict: Verdict
    minimum: Bracket | None = None
    every_epsilon: bool = False
    epsilon_0: fmpq | None = None
    largest_epsilon: arb | None = None
    lift_off: LiftOff | None = None
    growth: tuple[LiftOff, ...] = ()

    def __str__(self) -> str:
        force = self.force
        side = "> 0, λ_N → +∞" if force.takes_impact else "< 0, λ_N → -∞"
        lines = [
            str(self.verdict),
            f"  {force.case}: β = {force.beta}, α1 = {_short(force.alpha_1)}, α2 = {_short(force.alpha_2)}, "
            f"α3 = {_short(force.alpha_3)}, C1 = {_short(force.c1)}: the side C1/Γ(-β) {side}",
            f"  λ_N = {_short(force.mean)} - (C1/α3) κ^(1-β) ε^({force.exponent}) dΘ/dτ, "
            f"κ^3 = {_short(-force.alpha_1 / 2)}",
        ]
        if self.minimum is not None:
            place = _place(self.minimum)
            lines.append(f"  least value of sign(C1) dΘ/dτ: {ball_text(self.minimum.value, 15)} at τ = {place}")
        if self.largest_epsilon is not None:
            lines.append(f"  the largest ε0 possible: {ball_text(self.largest_epsilon, 15)}")
        if self.lift_off is not None:
            lines.append(f"  {self.lift_off}")
        lines += [f"  {row}" for row in self.growth]
        if self.whole_line and self.verdict.outcome is Outcome.PROVED:
            lines.append(f"  it holds for every τ < {self.start} as well")
        return "\n".join([*lines, '  "at leading order" is the paper\'s approximation; its error is not bounded here'])

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``; exact rationals as text, balls as exact intervals."""
        least = self.minimum
        return {
            "force": self.force.to_json(),
            "start": str(self.start),
            "whole_line": self.whole_line,
            "verdict": self.verdict.to_json(),
            "minimum": None if least is None else str(Dyadic.from_ball(least.value)),
            "minimum_at": None if least is None else [str(least.lower), str(least.upper)],
            "every_epsilon": self.every_epsilon,
            "epsilon_0": None if self.epsilon_0 is None else str(self.epsilon_0),
            "largest_epsilon": None if self.largest_epsilon is None else str(Dyadic.from_ball(self.largest_epsilon)),
            "lift_off": None if self.lift_off is None else self.lift_off.to_json(),
            "growth": [row.to_json() for row in self.growth],
        }


def iwc(
    beta: ExactInput | None = None,
    *,
    alpha_1: ExactInput | None = None,
    alpha_2: ExactInput = -1,
    alpha_3: ExactInput | None = None,
    c1: ExactInput | None = None,
    tau_start: ExactInput = -10,
    epsilon: ExactInput | None = None,
    digits: int = 15,
    growth: bool = False,
) -> IwcResult:
    """Whether the contact holds on [tau_start, infinity) at leading order, for all small eps, or when it lifts off.

    On the side C_1/Gamma(-beta) > 0: eps_0, or with ``epsilon`` the answer at that eps. On the other side: the lift-off
    time at ``epsilon`` (1/1000 by default, as in the paper's figures), to ``digits`` decimals, and with ``growth`` a
    table for eps = 10^-10 ... 10^-10000. beta, the alphas and C_1: see :func:`contact_force`.

    :raises TypeError: a float.
    :raises ValueError: an argument out of range: see :func:`contact_force`; |tau_start| > 10^6; epsilon <= 0; digits
        not in 1..100; ``growth`` on the side that does not lift off, or with beta < 1.

    >>> iwc("3/2", c1=1).verdict.statement
    'at leading order, λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.17881880065137)'
    """
    force = contact_force(beta, alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, c1=c1)
    start = rational(tau_start, "tau_start")
    if abs(start) > MAX_START:
        raise ValueError(f"tau_start: expected |tau_start| <= {MAX_START}")
    small = None if epsilon is None else rational(epsilon, "epsilon")
    if small is not None and small <= 0:
        raise ValueError(f"epsilon: expected a number > 0, got {small}")
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}")
    if growth and (force.takes_impact or force.beta < 1):
        raise ValueError("growth: the table needs beta > 1 and the sign of C_1 with C_1/Gamma(-beta) < 0")
    if force.takes_impact:
        return _impact(force, start, small, digits)
    found = lift_off(force, PAPER_EPSILON if small is None else small, start, digits)
    rows = growth_table(force, start) if growth else ()
    return IwcResult(force, start, found.whole_line, found.verdict, lift_off=found, growth=rows)


def _impact(force: ContactForce, start: fmpq, epsilon: fmpq | None, digits: int) -> IwcResult:
    found = stretches(force.beta, force.direction, start, digits)
    least = minimum(found)
    # lambda_N > 0 where the mean force and the least deviation are both >= 0, one of them > 0: dTheta/dtau < 0 for
    # beta < 1 by proofs/signs.md, without numbers.
    if (force.beta > 1 and least.value.lower() >= 0) or (force.beta < 1 and force.mean >= 0):
        whole = force.beta < 1
        verdict = Verdict.proved(_statement(None if whole else start, epsilon, None), _by_theorem(force))
        return IwcResult(force, start, whole, verdict, least, every_epsilon=True)
    whole = found.whole_line and bool(found.critical)
    log_lower, log_upper = _log_bounds(force, least.value, digits)
    size = None if log_upper is None else _exponential(log_lower, log_upper)
    epsilon_0 = rounded_down(log_lower, digits)
    if epsilon is not None:
        verdict = _at_epsilon(force, start, epsilon, least, log_lower, log_upper)
    elif epsilon_0 is None:
        text = f"{_LEADING}, some ε0 > 0 with λ_N > 0 for every τ in [{start}, inf) and every ε in (0, ε0)"
        verdict = Verdict.undecided(text, Reason.BUDGET, f"no ε0 above 10^{LEAST_TENS} was found")
    else:
        verdict = Verdict.proved(_statement(start, None, epsilon_0), _by_theorem(force))
    return IwcResult(force, start, whole, verdict, least, False, epsilon_0, size)


def _by_theorem(force: ContactForce) -> str:
    if force.beta > 1:
        return ""
    return "the deviation of λ_N is > 0 for every real τ and every ε > 0: dΘ/dτ < 0 for 0 < β < 1 (proofs/signs.md)"


def _statement(start: fmpq | None, epsilon: fmpq | None, bound: fmpq | None) -> str:
    tau = "every real τ" if start is None else f"every τ in [{start}, inf)"
    if epsilon is not None:
        return f"{_LEADING}, λ_N > 0 for {tau} at ε = {_short(epsilon)}"
    return f"{_LEADING}, λ_N > 0 for {tau} and " + (
        "every ε > 0" if bound is None else f"every ε in (0, {_short(bound)})"
    )


def _log_bounds(force: ContactForce, least: arb, digits: int) -> tuple[arb, arb | None]:
    """Bounds of the logarithm of the largest eps_0; no upper one where the least value may be 0."""
    accuracy = 2 * digits
    lower = force.log_epsilon(least.lower(), accuracy).lower()
    same_sign = least.upper() < 0 or least.lower() > 0
    return lower, force.log_epsilon(least.upper(), accuracy).upper() if same_sign else None


def _exponential(lower: arb, upper: arb) -> arb | None:
    if not (lower > 3 * LEAST_TENS and upper < -3 * LEAST_TENS):
        return None
    with working_bits(int(max(lower.bits(), upper.bits())) + 64):
        return lower.exp().union(upper.exp())


def _at_epsilon(
    force: ContactForce, start: fmpq, epsilon: fmpq, least: Bracket, lower: arb, upper: arb | None
) -> Verdict:
    text = _statement(start, epsilon, None)
    with working_bits(int(lower.bits()) + 64):
        size = arb(epsilon).log()
    if size < lower:
        return Verdict.proved(text, _by_theorem(force))
    place = (least.lower + least.upper) / 2
    if upper is not None and size > upper and force.value(place, epsilon, 40) < 0:
        return Verdict.refuted(text, f"λ_N < 0 at τ = {place}")
    return Verdict.undecided(text, Reason.BUDGET, "ε is too close to the largest ε0; ask for more digits")


def lift_off(force: ContactForce, epsilon: fmpq, start: fmpq, digits: int = 15) -> LiftOff:
    """The first zero of lambda_N on [start, infinity), where C_1/Gamma(-beta) < 0.

    >>> print(lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-10), 6))
    ε = 0.001: lift-off in 3.590583..3.590584, over ((β-1) ln(1/ε))^(2/3): [1.571 +/- 4.26e-4]
    """
    where = f"{_LEADING} at ε = {_short(epsilon)}"
    least = max(digits, _CRITICAL_DIGITS)
    for accuracy in (least, 4 * least):
        found = stretches(force.beta, force.direction, start, accuracy)
        try:
            crossing = first_crossing(found, lambda places: force.level(epsilon, places), digits)
        except NotAbove:
            verdict = Verdict.refuted(f"{where}, λ_N > 0 at τ = {start}", f"λ_N < 0 at τ = {start}")
            return LiftOff(epsilon, None, None, None, None, False, verdict)
        if crossing is not None:
            break
    if crossing is None:
        text = f"{where}, the first zero of λ_N on [{start}, inf)"
        verdict = Verdict.undecided(text, Reason.BUDGET, "a least or greatest value of λ_N is too close to 0")
        return LiftOff(epsilon, None, None, None, None, False, verdict)
    lower, upper, number = crossing.lower, crossing.upper, crossing.number
    text = f"{where}, λ_N > 0 on [{start}, τ_lo) and λ_N changes sign at τ_lo, τ_lo in ({decimal_text(lower, upper)})"
    count = "" if number is None else f"zeros of λ_N on [{start}, inf): {number}"
    ratio = None
    if force.beta > 1 and epsilon < 1:
        with working_bits(128):
            law = (arb(force.beta - 1) * -arb(epsilon).log()) ** arb(fmpq(2, 3))
            ratio = arb(lower).union(arb(upper)) / law
    return LiftOff(epsilon, lower, upper, number, ratio, found.whole_line, Verdict.proved(text, count))


def growth_table(force: ContactForce, start: fmpq) -> tuple[LiftOff, ...]:
    """The lift-off times for eps = 10^-10 ... 10^-10000, to three decimals."""
    return tuple(lift_off(force, fmpq(10) ** -exponent, start, _GROWTH_DIGITS) for exponent in GROWTH_EXPONENTS)


def _place(least: Bracket) -> str:
    return str(least.lower) if least.lower == least.upper else decimal_text(least.lower, least.upper)


def _short(value: fmpq) -> str:
    """A decimal fraction exactly, as a decimal or with an exponent; another rational as it is.

    >>> _short(fmpq(-1, 8)), _short(fmpq(10) ** -300), _short(fmpq(1, 3)), _short(fmpq(1200))
    ('-0.125', '1e-300', '1/3', '1200')
    """
    denominator = int(value.q)
    twos = (denominator & -denominator).bit_length() - 1
    fives = round((denominator >> twos).bit_length() * math.log(2, 5))
    fives = next((n for n in (fives - 1, fives, fives + 1) if n >= 0 and 5**n == denominator >> twos), -1)
    places = max(twos, fives)
    mantissa = int(value.p) * 10**places // denominator
    if fives < 0 or mantissa.bit_length() > _SHOWN_BITS:
        return str(value)
    number = _CONTEXT.normalize(_CONTEXT.scaleb(decimal.Decimal(mantissa), -places))
    return f"{number:f}" if -7 <= number.adjusted() <= 20 else f"{number:g}"
