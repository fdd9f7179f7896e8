"""The slow part of a motion in contact, C F_beta(T; epsilon), in every variable.

Proof page: ``proofs/fast_part.md``, section 8.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.compliant.slow.slow_solution import MAX_DIGITS, slow_value
from gspot_verified.numbers.balls import digits_for_bits, working_bits

_ORDER = {"b": (0,), "force": (1,), "V": (1, 2, 3, 4), "Z": (1, 2, 3, 4)}


def slow_part(beta: fmpq, epsilon: fmpq, p: fmpq, names: tuple[str, ...], bits: int) -> dict[str, arb]:
    """F_beta in the named hats at T = -p/epsilon (C = 1): b-hat = F, lambda-hat = F'/(epsilon beta), and

    V = lambda''' + lambda'' + (p - 2) lambda' + epsilon (beta - 1) lambda,   Z = -lambda' - lambda - V.
    """
    digits = min(MAX_DIGITS, digits_for_bits(bits) + 1)
    time = -p / epsilon
    needed = sorted({order for name in names for order in _ORDER[name]})
    values = {order: slow_value(time, beta, epsilon, order, digits).value for order in needed}
    with working_bits(bits + 64 + 2 * int(epsilon.height_bits()) + int(p.height_bits())):
        front = 1 / arb(epsilon * beta)
        force = {order - 1: front * value for order, value in values.items() if order}
        hats = {}
        if "b" in names:
            hats["b"] = values[0]
        if "force" in names:
            hats["force"] = force[0]
        if "V" in names or "Z" in names:
            speed = force[3] + force[2] + (p - 2) * force[1] + epsilon * (beta - 1) * force[0]
            hats["V"], hats["Z"] = speed, -force[1] - force[0] - speed
        return {name: hats[name] for name in names}
