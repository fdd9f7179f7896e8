"""Whether the statement of a certificate is false, by samples of the references."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from attack.reference_contact import slow_force, slow_values
from attack.signs import sign_changes, slope


def _numbers(text: str, far: Fraction) -> tuple[Fraction, Fraction]:
    """The ends of a range, one of them finite or none; in the place of an infinite one ``far``, or 1 beyond the other
    one."""
    low, high = text[1:-1].split(", ")
    last = far if high == "inf" else Fraction(high)
    first = min(-far, last - 1) if low == "-inf" else Fraction(low)
    return first, max(last, first + 1) if high == "inf" else last


def untrue(statement: dict[str, Any]) -> str | None:
    """Where the statement is false; empty: nothing was found against it; None: there is no reference."""
    kind = statement["kind"]
    if kind == "sign":
        (t0, t1), (b0, b1) = _numbers(statement["tau"], Fraction(12)), _numbers(statement["beta"], Fraction(6))
        for i in range(9):
            for j in range(25):
                tau, beta = t0 + (t1 - t0) * Fraction(j, 24), b0 + (b1 - b0) * Fraction(i + 1, 10)
                if j not in (0, 24) and slope(tau, beta) not in (statement["sign"], None):
                    return f"the sign at tau = {tau}, beta = {beta} is {slope(tau, beta)}"
        return ""
    if kind == "zeros":
        low, high = _numbers(statement["beta"], Fraction(13))
        counts = dict(map(tuple, statement["counts"]))
        for i in range(1, 8):
            beta = low + (high - low) * Fraction(i, 8) + Fraction(1, 10**7 + 19)
            if low < beta < high and beta.denominator != 1:
                changes = sign_changes(beta, Fraction(-10), Fraction(40), Fraction(1, 4))
                if counts.get(int(beta)) != len(changes) and len(changes) > counts.get(int(beta), -1):
                    return f"{len(changes)} changes of sign at beta = {beta}"
        return ""
    if kind == "brackets":
        beta = Fraction(statement["beta"])
        for low, high in statement["brackets"]:
            if slope(Fraction(low), beta, 40) == slope(Fraction(high), beta, 40):
                return f"no change of sign in {low}, {high}"
        more = len(sign_changes(beta, Fraction(-10), Fraction(20)))
        return f"{more} changes of sign" if more > len(statement["brackets"]) else ""
    if kind in ("force", "lift_off"):
        return _untrue_force(statement)
    return _untrue_slow(statement) if kind == "slow_zeros" else None


def _untrue_force(statement: dict[str, Any]) -> str:
    """The force at samples of tau and the epsilon of the statement, and at one less (force) or greater (lift-off)."""
    alpha, c1, epsilon = (
        list(map(Fraction, statement["alpha"])),
        Fraction(statement["c1"]),
        Fraction(statement["epsilon"]),
    )
    if statement["kind"] == "lift_off":
        places, sign, smaller = [Fraction(statement["tau"])], -1, Fraction(4)
    else:
        low, high = _numbers(statement["tau"], Fraction(3))
        places, sign, smaller = [low + (high - low) * Fraction(k, 8) for k in range(9)], 1, Fraction(1, 4)
    for small in (epsilon, epsilon * smaller):
        for tau in places:
            value = slow_force(alpha, c1, small, tau)
            if sign * value < -1e-9:
                return f"lambda = {value} at tau = {tau}, epsilon = {small}"
    return ""


def _untrue_slow(statement: dict[str, Any]) -> str:
    """Two zeros for every beta of the range and every epsilon up to the bound: by samples of F_(beta-1)."""
    low, high = _numbers(statement["beta"], Fraction(5))
    epsilon = Fraction(statement["epsilon"])
    for share in (Fraction(1, 2), Fraction(99, 100)):
        beta = low + (high - low) * share
        if beta.denominator == 1:
            continue
        scale = Fraction(round((2 / float(epsilon)) ** (1 / 3) * 2**20), 2**20)
        values = [value for _, value in slow_values(beta - 1, epsilon, 7 * scale, 200)]
        if all(value > 0 for value in values):
            return f"F_(beta-1) > 0 at all samples for beta = {beta}, epsilon = {epsilon}: no zeros"
    return ""
