"""Hard cases of mechanisms: G-spots about to meet, and a ratio β next to an integer."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.hard_cases.hard_case import (
    Case,
    HardCase,
    bits_lost,
    double_text,
    log10,
    near,
    nearest_double,
    real_roots,
    timed,
)
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.numbers.balls import working_bits

CRITICAL = fmpq(4, 3)  # the rod's critical mu: below it it has no G-spot


def spots_that_nearly_meet(k: int) -> HardCase:
    """The number of G-spots of the rod for mu = 4/3 + 10^-k, in one turn of its angle."""
    return _spots(k, 1)


def spots_that_are_gone(k: int) -> HardCase:
    """The same for mu = 4/3 - 10^-k: there is none."""
    return _spots(k, -1)


def _spots(k: int, side: int) -> HardCase:
    friction = CRITICAL + side * fmpq(1, 10**k)
    mechanism = load("genot_brogliato_rod", mu=friction)
    g_spots, seconds = timed(lambda: find_g_spots(mechanism))
    number = len(g_spots.spots) if g_spots.complete else None
    double = 2.0 * real_roots([1.0, -3 * nearest_double(friction), 4.0])

    def discriminant(bits: int) -> arb:
        with working_bits(bits):
            return 9 * arb(friction) ** 2 - 16

    texts = {None: "undecided: boxes are left", 0: "none: proved for the whole turn"}
    return HardCase(
        level=k,
        asked=f"the number of G-spots of the rod, μ = 4/3 {'+' if side > 0 else '−'} 10^−{k}",
        condition=log10(CRITICAL * 10**k),
        lost=bits_lost(discriminant, 1),
        double=double,
        certified=number,
        text=texts.get(number, f"{number}, each alone in its box"),
        work=int(friction.q).bit_length(),
        seconds=seconds,
    )


def side_of_a_mechanism(k: int) -> HardCase:
    """The sign of C_1 that lifts off in the oscillator, beta = 2 + 10^-k."""
    mechanism = load("oscillator", beta=near(2, k))
    classification, seconds = timed(lambda: classify(mechanism))
    sign = classification.lift_off_sign
    alpha_1, alpha_3 = (exact(value) for value in (classification.alpha_1, classification.alpha_3))
    first, third = nearest_double(alpha_1), nearest_double(alpha_3)
    ratio = third / first
    double = None if ratio == round(ratio) else (1.0 if int(ratio) % 2 == 0 else -1.0)

    def distance(bits: int) -> arb:
        with working_bits(bits):
            return arb(alpha_3) / arb(alpha_1) - 2

    return HardCase(
        level=k,
        asked=f"which sign of C₁ lifts off, by the paper's rule as ε → 0, in the oscillator, β = 2 + 10^−{k}",
        condition=log10(2 * fmpq(10) ** k),
        lost=bits_lost(distance, 1),
        double=double,
        double_said=f"α₃/α₁ = {double_text(ratio)}",
        certified=sign,
        text=f"C₁ {'>' if sign == 1 else '<'} 0, the sign of −Γ(−β), Case {classification.case}"
        if sign
        else "undecided",
        work=int((alpha_3 / alpha_1).q).bit_length(),
        seconds=seconds,
    )


def exact(value: fmpq | arb) -> fmpq:
    """A number of this mechanism, whose G-spot is rational."""
    assert isinstance(value, fmpq)
    return value


CASES: dict[str, Case] = {
    "spots-meet": spots_that_nearly_meet,
    "spots-gone": spots_that_are_gone,
    "ratio": side_of_a_mechanism,
}
