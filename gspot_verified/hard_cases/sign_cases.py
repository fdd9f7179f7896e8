"""Hard cases of the signs: the side next to an integer, zeros that nearly meet, their certificate, wide ranges."""

from __future__ import annotations

import tempfile
from itertools import pairwise
from pathlib import Path

from flint import arb, fmpq

from gspot_verified.certificates.checker import check
from gspot_verified.certificates.text import certificate_text
from gspot_verified.cost.times.baseline import flint_attempt
from gspot_verified.hard_cases.hard_case import (
    Case,
    HardCase,
    bits_lost,
    log10,
    near,
    nearest_double,
    sign_changes,
    theta_double,
    timed,
)
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.signs.zeros.brackets import zeros_at

_SIDES = {1: "Γ(−β) > 0", -1: "Γ(−β) < 0"}
SPARE = 8  # digits beyond those that tell the closest zeros apart
_POINTS = 200  # at which a user looks at the sign


def side_next_to_an_integer(k: int) -> HardCase:
    """The sign of Gamma(-beta), which decides the side that lifts off, at beta = 2 + 10^-k."""
    from scipy.special import gamma

    beta = near(2, k)
    sign, seconds = timed(lambda: gamma_sign(beta))
    double = float(gamma(-nearest_double(beta)))
    double = double if double != double else float((double > 0) - (double < 0))

    def ball_of(bits: int) -> arb:
        with working_bits(bits):
            return (-arb(beta)).gamma()

    return HardCase(
        level=k,
        asked=f"the sign of Γ(−β), β = 2 + 10^−{k}",
        condition=log10(2 * fmpq(10) ** k),
        lost=bits_lost(ball_of, 1),
        double=double,
        certified=sign,
        text=_SIDES[sign] if sign else "undecided",
        work=int(beta.q).bit_length(),
        seconds=seconds,
    )


def zeros_that_nearly_meet(k: int) -> HardCase:
    """The number of real zeros of dTheta/dtau at beta = 6 - 10^-k: two of them meet at tau = 0 when beta = 6."""
    beta = near(6, k, -1)
    digits = k // 2 + SPARE
    zeros, seconds = timed(lambda: zeros_at(beta, digits))
    number = len(zeros.brackets)
    middles = [(lower + upper) / 2 for lower, upper in zeros.brackets]
    gap = min(after - before for before, after in pairwise(middles))
    shifted = nearest_double(beta) - 1
    double = float(sign_changes(lambda tau: theta_double(tau, shifted), -2.0, 6.0, 1001))
    return HardCase(
        level=k,
        asked=f"the number of zeros of dΘ/dτ, β = 6 − 10^−{k}",
        condition=log10(6 * fmpq(10) ** k),
        lost=bits_lost(lambda bits: flint_attempt(fmpq(0), beta - 1, bits), 1),
        double=double,
        certified=number,
        text=f"{number} zeros, two of them {gap_text(gap)} apart",
        work=digits,
        seconds=seconds,
    )


def gap_text(gap: fmpq) -> str:
    """A small positive number as a decimal of two digits."""
    return f"{nearest_double(gap):.2g}"


def zero_far_out(k: int) -> HardCase:
    """The number of sign changes of dTheta/dtau on (1, 100) at beta = 3 + 10^-k: one, which comes in from infinity."""
    beta = near(3, k)
    zeros, seconds = timed(lambda: zeros_at(beta, SPARE))
    inside = [lower for lower, upper in zeros.brackets if lower > 1 and upper < 100]
    shifted = nearest_double(beta) - 1
    double = float(sign_changes(lambda tau: theta_double(tau, shifted), 1.0, 100.0, 301))
    place = inside[-1] if inside else fmpq(1)
    return HardCase(
        level=k,
        asked=f"sign changes of dΘ/dτ on (1, 100), β = 3 + 10^−{k}",
        condition=log10(3 * fmpq(10) ** k),
        lost=bits_lost(lambda bits: flint_attempt(2 * place, beta - 1, bits), 1),
        double=double,
        certified=len(inside),
        text=f"{len(inside)}, at τ = {nearest_double(place):.6g}",
        work=SPARE,
        seconds=seconds,
    )


def wide_range(x: int) -> HardCase:
    """The sign of dTheta/dtau on (-x, 5), for all beta in (3/10, 7/10) at once."""
    signs, seconds = timed(lambda: sign_on_ranges(f"-{x}..5", "3/10..7/10"))
    proved = signs.verdict.outcome is Outcome.PROVED
    pieces = sum(len(column.pieces) for column in signs.columns)
    points = [theta_double(-x + (x + 5) * n / _POINTS, -0.5) for n in range(_POINTS + 1)]
    negative = sum(-value / 2 < 0 for value in points)
    return HardCase(
        level=x,
        asked=f"the sign of dΘ/dτ for −{x} < τ < 5, 3/10 < β < 7/10",
        double=-1.0 if negative == len(points) else 0.0,
        double_said=f"negative at {negative} of {len(points)} points of β = 1/2",
        certified=-1 if proved else None,
        text="dΘ/dτ < 0, proved" if proved else "undecided",
        work=pieces,
        seconds=seconds,
    )


def brackets_certificate(k: int) -> str:
    """The certificate of the zeros of dTheta/dtau at beta = 6 - 10^-k, apart from each other."""
    zeros = zeros_at(near(6, k, -1), k // 2 + SPARE)
    return certificate_text(zeros.statement, [zeros.column])


def checked_brackets(k: int) -> HardCase:
    """What the independent checker says of it: 1 where it verified."""
    text, seconds = timed(lambda: brackets_certificate(k))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "brackets.cert"
        path.write_text(text, encoding="utf-8")
        result = check(path)
    said = "VERIFIED by the checker" if result.verified else result.text.splitlines()[-1][:80]
    return HardCase(
        level=k,
        asked=f"a certificate of all zeros of dΘ/dτ, β = 6 − 10^−{k}",
        condition=log10(6 * fmpq(10) ** k),
        certified=1 if result.verified else None,
        text=said,
        work=len(text),
        seconds=seconds,
    )


CASES: dict[str, Case] = {
    "side": side_next_to_an_integer,
    "zeros-meet": zeros_that_nearly_meet,
    "zero-far-out": zero_far_out,
    "wide-range": wide_range,
    "certificate": checked_brackets,
}
