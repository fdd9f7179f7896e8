"""A block on a surface, integrated plainly with many digits: a reference that shares nothing with the package.

M (X'', H'')ᵀ = f + (λ_T, λ_N)ᵀ with constant M, f; λ_N = (z - y)/ε² in contact, λ_T = -μ λ_N as in positive slip,
ε z' = -z - ε² λ_N. Each mode is linear with constant coefficients: the matrix exponential, and bisection between modes.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp, mpf

STEPS = 400
DIGITS = 30


@dataclass(frozen=True)
class Block:
    """``coupling``: off the diagonal of M, the diagonal is 1."""

    coupling: Fraction
    forces: tuple[Fraction, Fraction]
    mu: Fraction
    epsilon: Fraction


@dataclass(frozen=True)
class Start:
    """The slip velocity, y >= 0 and v <= 0; z = 0."""

    slip: Fraction
    height: Fraction
    speed: Fraction


@dataclass(frozen=True)
class Seen:
    """The least slip velocity in contact and the least force of a motion, without the instant at which it starts."""

    slip: mpf
    force: mpf


def exact(value: Fraction) -> mpf:
    return mpf(value.numerator) / value.denominator


def plain_motion(block: Block, start: Start, until: Fraction, lifts_off: bool) -> Seen:
    """Without lift-off the surface may pull."""
    with mp.workdps(DIGITS):
        inner = 1 - exact(block.coupling) ** 2
        cross = -exact(block.coupling) / inner

        def acceleration(tangential: mpf, normal: mpf) -> tuple[mpf, mpf]:
            return tangential / inner + cross * normal, cross * tangential + normal / inner

        def generator(contact: bool) -> mp.matrix:
            """Of (u, y, v, z, 1)."""
            stiff = 1 / exact(block.epsilon) ** 2
            a, b = acceleration(exact(block.forces[0]), exact(block.forces[1]))
            pulled, pushed = acceleration(-exact(block.mu), mpf(1))
            made = mp.zeros(5)
            made[0, 4], made[2, 4], made[1, 2] = a, b, 1
            made[3, 3] = -1 / exact(block.epsilon)
            if contact:
                for row, slope in ((0, pulled), (2, pushed)):
                    made[row, 3], made[row, 1] = slope * stiff, -slope * stiff
                made[3, 3], made[3, 1] = -2 / exact(block.epsilon), 1 / exact(block.epsilon)
            return made

        def force(state: mp.matrix) -> mpf:
            return (state[3] - state[1]) / exact(block.epsilon) ** 2

        modes = {mode: generator(mode) for mode in (True, False)}
        step = exact(until) / STEPS
        moves = {mode: mp.expm(modes[mode] * step) for mode in modes}
        state = mp.matrix([exact(start.slip), exact(start.height), exact(start.speed), 0, 1])
        contact, least, weakest = start.height == 0, mpf("inf"), mpf("inf")
        for _ in range(STEPS):
            after = moves[contact] * state
            # At the start in contact λ is 0 and rises.
            if lifts_off and (force(after) > 0) != contact:
                left, right = mpf(0), step
                for _ in range(40):
                    middle = (left + right) / 2
                    at = mp.expm(modes[contact] * middle) * state
                    left, right = (middle, right) if (force(at) > 0) == contact else (left, middle)
                switched = mp.expm(modes[contact] * right) * state
                contact = not contact
                if contact:
                    least = min(least, switched[0])
                after = mp.expm(modes[contact] * (step - right)) * switched
            if contact:
                least, weakest = min(least, after[0]), min(weakest, force(after))
            state = after
        return Seen(least, weakest)
