"""The fast part of a motion in contact, 2 Re (c_+ P_+) + c_Q Q, at one epsilon: in balls, or only bounded.

Proof page: ``proofs/fast_part.md``, sections 2 and 8.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from flint import acb, arb, fmpq

from gspot_verified.compliant.fast.decaying_coefficient import decaying_coefficient, real_saddle
from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient, saddle
from gspot_verified.compliant.fast.fast_coefficient_bound import (
    decaying_coefficient_bound,
    oscillating_coefficient_bound,
    state_weight,
    unit_weight,
)
from gspot_verified.compliant.fast.fast_path_bound import NAMES, decaying_bounds, oscillating_bounds
from gspot_verified.compliant.fast.fast_solutions import decaying, oscillating
from gspot_verified.compliant.fast.late_bound import late_bounds
from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import add_remainder, nonfinite, working_bits

_BITS = 64  # of a bound, of which a few digits count; any number is right
_LEVELS = 4  # values of p below the first one that share their bounds; any number is right


@dataclass(frozen=True, slots=True)
class _Coefficients:
    """Bounds of c_+ and c_Q times the modulus of the exponential at the saddle (not c_+ and c_Q themselves)."""

    oscillating: arb
    decaying: arb


def fast_bound_at(state: Deviation, p: fmpq, names: tuple[str, ...] = NAMES) -> dict[str, arb]:
    """Bounds of the fast parts of b-hat, lambda-hat, Z-hat and V-hat (or some), from the state at its p > 0.

    For 0 < p <= state.p they hold at every T from -p/epsilon up to 0; for p <= 0 from 0 up to -p/epsilon. Not finite
    when p > state.p, or state.p <= 0.
    """
    if not state.p > 0 or p > state.p:
        return {name: nonfinite() for name in names}
    with working_bits(_bits(state)):
        sizes = _coefficients(state)
        steady = _decaying_bounds(state, max(p, fmpq(0)))
        if p > 0:
            level = _level(state.p, p)
            rate = _height(state.p) - _height(level) if level < state.p else arb(0)
            swing = (-rate / state.epsilon).exp() * sizes.oscillating
            bounds = dict(zip(NAMES, _oscillating(state.beta, state.epsilon, level), strict=True))
            waves = [swing * bounds[name] for name in names]
        else:
            swing = (-_height(state.p) / state.epsilon).exp() * sizes.oscillating
            late = late_bounds(state.beta, state.epsilon, -p / state.epsilon, names)
            waves = [swing * bound for bound in late]
        front = arb(1) / (state.epsilon * state.beta)
        fronts = [arb(1) if name == "b" else front for name in names]
        return {
            name: (2 * unit * wave + steady[name]).abs_upper()
            for name, unit, wave in zip(names, fronts, waves, strict=True)
        }


def _bits(state: Deviation) -> int:
    """Exponents are as large as 1/epsilon."""
    return _BITS + 2 * int(state.epsilon.height_bits()) + int(state.p.height_bits())


def _level(first: fmpq, p: fmpq) -> fmpq:
    """The least multiple of first/4 that is at least p, or nearer to first first (1 - 2^-k): few bounds for many times.

    Any number from p to first is right.
    """
    level = first * fmpq((p * _LEVELS / first).ceil(), _LEVELS)
    if level < first or p == first:
        return level
    gap = 1 - p / first  # in (0, 1/4)
    return first * (1 - fmpq(1, 2 ** int((1 / gap).ceil() - 1).bit_length()))


def _height(p: fmpq) -> arb:
    """Re g(r_+(p)) = Re (psi(r_+) - p r_+), which increases with p from 0."""
    top = saddle(p)
    return (top * (1 - p - top / 2 - top * top / 3) - (1 + top).log()).real


def quasi_static(state: Deviation) -> bool:
    """V = 0, Y = 2 b/p, Z = b/p in hats: the data of the paper's runs.

    >>> quasi_static(Deviation(fmpq(3, 2), fmpq(1), fmpq(1, 2), fmpq(1), fmpq(0), fmpq(4), fmpq(2)))
    True
    """
    ratio = state.b / state.p
    return bool(state.V == 0 and 2 * ratio == state.Y and ratio == state.Z)


def _largest(epsilon: fmpq, p: fmpq) -> fmpq:
    """The epsilon of the sums over boxes: the bounds serve smaller ones too, and few boxes suffice there."""
    return max(epsilon, min(p * p, fmpq(1)) / 256)


@lru_cache(maxsize=64)
def _coefficients(state: Deviation) -> _Coefficients:
    with working_bits(_BITS):
        small = arb(_largest(state.epsilon, state.p))
        front = arb(state.beta) / (2 * arb.pi())
        weight = state_weight(kernel(state))
        if quasi_static(state):
            # One integration by parts (section 9): a factor epsilon, and k = 1.
            weight = unit_weight(arb(state.beta))
            front = front * abs(state.b / state.p * state.epsilon * (state.beta - 1))
        return _Coefficients(
            (front * oscillating_coefficient_bound(weight, state.p, small)).abs_upper(),
            (front * decaying_coefficient_bound(weight, state.p, small)).abs_upper(),
        )


@lru_cache(maxsize=64)
def _oscillating(beta: fmpq, epsilon: fmpq, p: fmpq) -> tuple[arb, ...]:
    with working_bits(_BITS):
        return tuple(oscillating_bounds(arb(beta), p, arb(_largest(epsilon, p))))


@lru_cache(maxsize=64)
def _decaying(beta: fmpq, epsilon: fmpq, p: fmpq) -> tuple[arb, ...]:
    with working_bits(_BITS):
        return tuple(decaying_bounds(arb(beta), p, arb(_largest(epsilon, p))))


def fast_part(state: Deviation, p: fmpq, names: tuple[str, ...], bits: int) -> dict[str, arb]:
    """The fast parts of the named hats at T = -p/epsilon, by quadrature, accurate to near 2^-bits of their moduli."""
    fast = _fast_coefficient(state, bits)
    waves, height = oscillating(state.beta, state.epsilon, p, names, bits)
    with working_bits(bits + _bits(state)):
        swing = fast * height.exp()
        oscillating_parts = {name: 2 * (swing * wave).real for name, wave in zip(names, waves, strict=True)}
        steady = _decaying_bounds(state, p)
        sizes = {name: abs(swing * wave).abs_lower() for name, wave in zip(names, waves, strict=True)}
        if all(steady[name] < sizes[name] * arb(2) ** -bits for name in names):
            return {name: add_remainder(value, steady[name]) for name, value in oscillating_parts.items()}
    falls, depth = decaying(state.beta, state.epsilon, p, names, bits)
    with working_bits(bits + _bits(state)):
        fall = _decaying_coefficient(state, bits) * depth.exp()
        return {name: oscillating_parts[name] + fall * rest for name, rest in zip(names, falls, strict=True)}


def _decaying_bounds(state: Deviation, p: fmpq) -> dict[str, arb]:
    """Bounds of the hats of c_Q Q from T = -p/epsilon on."""
    fall = (real_saddle(state.p) * (state.p - p) / state.epsilon).exp() * _coefficients(state).decaying
    front = arb(1) / (state.epsilon * state.beta)
    named_bounds = zip(NAMES, _decaying(state.beta, state.epsilon, state.p), strict=True)
    return {name: fall * bound * (arb(1) if name == "b" else front) for name, bound in named_bounds}


@lru_cache(maxsize=16)
def _fast_coefficient(state: Deviation, bits: int) -> acb:
    return fast_coefficient(state, bits)


@lru_cache(maxsize=16)
def _decaying_coefficient(state: Deviation, bits: int) -> arb:
    return decaying_coefficient(state, bits)
