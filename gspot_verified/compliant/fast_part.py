"""The fast part of a motion in contact, 2 Re (c_+ P_+) + c_Q Q, at one epsilon: in balls, or only bounded.

Proof page: ``proofs/fast_part.md``, sections 2 and 8.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from flint import acb, arb, fmpq

from gspot_verified.balls import nonfinite, working_bits
from gspot_verified.compliant.decaying_coefficient import decaying_coefficient, real_saddle
from gspot_verified.compliant.fast_coefficient import fast_coefficient, saddle
from gspot_verified.compliant.fast_coefficient_bound import (
    decaying_coefficient_bound,
    oscillating_coefficient_bound,
    state_weight,
)
from gspot_verified.compliant.fast_path_bound import NAMES, decaying_bounds, oscillating_bounds
from gspot_verified.compliant.fast_solutions import decaying, oscillating
from gspot_verified.compliant.kernel import kernel
from gspot_verified.compliant.late_bound import late_bounds
from gspot_verified.compliant.normal_form import Deviation

_BITS = 64
_LEVELS = 8


@dataclass(frozen=True, slots=True)
class _Coefficients:
    """Bounds of c_+ and c_Q times the modulus of the exponential at the saddle (not c_+ and c_Q themselves)."""

    oscillating: arb
    decaying: arb


def fast_bound_at(state: Deviation, p: fmpq) -> dict[str, arb]:
    """Bounds of the fast parts of b-hat, lambda-hat, Z-hat and V-hat, from the state at its p > 0.

    For 0 < p <= state.p they hold at every T from -p/epsilon up to 0; for p <= 0 at T = -p/epsilon. Not finite
    when p > state.p, or state.p <= 0.
    """
    if not state.p > 0 or p > state.p:
        return {name: nonfinite() for name in NAMES}
    with working_bits(_bits(state)):
        sizes = _coefficients(state)
        duration = (state.p - p) / state.epsilon
        fall = (real_saddle(state.p) * duration).exp() * sizes.decaying
        steady = [fall * bound for bound in _decaying(state.beta, state.epsilon, state.p)]
        if p > 0:
            level = _level(state.p, p)
            rate = _height(state.p) - _height(level) if level < state.p else arb(0)
            swing = (-rate / state.epsilon).exp() * sizes.oscillating
            waves = [swing * bound for bound in _oscillating(state.beta, state.epsilon, level)]
        else:
            swing = (-_height(state.p) / state.epsilon).exp() * sizes.oscillating
            waves = [swing * bound for bound in late_bounds(state.beta, state.epsilon, -p / state.epsilon)]
        front = arb(1) / (state.epsilon * state.beta)
        total = [(2 * wave + rest).abs_upper() for wave, rest in zip(waves, steady, strict=True)]
        return {name: bound * (arb(1) if name == "b" else front) for name, bound in zip(NAMES, total, strict=True)}


def _bits(state: Deviation) -> int:
    """Exponents are as large as 1/epsilon."""
    return _BITS + 2 * int(state.epsilon.height_bits()) + int(state.p.height_bits())


def _level(first: fmpq, p: fmpq) -> fmpq:
    """The least multiple of first/8 that is at least p: few bounds for many times."""
    return first * fmpq((p * _LEVELS / first).ceil(), _LEVELS)


def _height(p: fmpq) -> arb:
    """Re g(r_+(p)) = Re (psi(r_+) - p r_+), which increases with p from 0."""
    top = saddle(p)
    return (top * (1 - p - top / 2 - top * top / 3) - (1 + top).log()).real


@lru_cache(maxsize=64)
def _coefficients(state: Deviation) -> _Coefficients:
    with working_bits(_BITS):
        weight, small = state_weight(kernel(state)), arb(state.epsilon)
        front = arb(state.beta) / (2 * arb.pi())
        return _Coefficients(
            (front * oscillating_coefficient_bound(weight, state.p, small)).abs_upper(),
            (front * decaying_coefficient_bound(weight, state.p, small)).abs_upper(),
        )


@lru_cache(maxsize=64)
def _oscillating(beta: fmpq, epsilon: fmpq, p: fmpq) -> tuple[arb, ...]:
    with working_bits(_BITS):
        return tuple(oscillating_bounds(arb(beta), p, arb(epsilon)))


@lru_cache(maxsize=64)
def _decaying(beta: fmpq, epsilon: fmpq, p: fmpq) -> tuple[arb, ...]:
    with working_bits(_BITS):
        return tuple(decaying_bounds(arb(beta), p, arb(epsilon)))


def fast_part(state: Deviation, p: fmpq, names: tuple[str, ...], bits: int) -> dict[str, arb]:
    """The fast parts of the named hats at T = -p/epsilon, by quadrature, accurate to near 2^-bits of their moduli."""
    fast, steady = _fast_coefficient(state, bits), _decaying_coefficient(state, bits)
    waves, height = oscillating(state.beta, state.epsilon, p, names, bits)
    falls, depth = decaying(state.beta, state.epsilon, p, names, bits)
    with working_bits(bits + _bits(state)):
        swing, fall = fast * height.exp(), steady * depth.exp()
        return {
            name: 2 * (swing * wave).real + fall * rest for name, wave, rest in zip(names, waves, falls, strict=True)
        }


@lru_cache(maxsize=16)
def _fast_coefficient(state: Deviation, bits: int) -> acb:
    return fast_coefficient(state, bits)


@lru_cache(maxsize=16)
def _decaying_coefficient(state: Deviation, bits: int) -> arb:
    return decaying_coefficient(state, bits)
