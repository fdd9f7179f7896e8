"""Scaled motions in contact by scipy, from equations typed from the paper: they share no formula with the package."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def _run(rates: Any, start: float, state: Sequence[float], places: Sequence[float]) -> list[np.ndarray]:
    found = solve_ivp(
        rates, (start, max(places)), list(state), method="Radau", rtol=1e-11, atol=1e-13, dense_output=True
    )
    assert found.success
    return [found.sol(s) for s in places]


def extended_motion(
    chi: float,
    alpha: tuple[float, float, float],
    delta: float,
    start: float,
    state: Sequence[float],
    places: Sequence[float],
) -> list[dict[str, float]]:
    """Eqs. newex1 to newex5 in positive slip, scaled: p, b, y, v, z at the places; ``state`` is (p, b, y, v, z)."""
    first, second, third = alpha

    def rates(_: float, x: np.ndarray) -> list[float]:
        p, b, y, v, z = x
        force = z - y
        return [first + delta**2 * chi * b, second - third * force, v, b + p * force, (-z - force) / delta]

    rows = _run(rates, start, state, places)
    return [{**dict(zip("pbyvz", row, strict=True)), "lambda_n": row[4] - row[2]} for row in rows]


BETA = 7 / 3
MU = 25 / 12
PHI = float(np.arccos(0.6))
PHI_0 = PHI + 49 / 20 - 7 * BETA / 12
DAMPER = 25 / 108 * (18 - 7 * BETA)


def _oscillator(phi: float, phi_dot: float, psi_dot: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The inverse of M, f, and Q_N - mu Q_T; paper, Sec. 6, kappa = 0, units m_1 = l = g = 1."""
    sine, cosine = np.sin(phi), np.cos(phi)
    inverse = np.linalg.inv(np.array([[1, sine], [sine, 2]]))
    force = np.array([-(phi - PHI_0) - sine, -DAMPER * psi_dot - 2 - cosine * phi_dot**2])
    return inverse, force, np.array([sine - MU * cosine, 1])


def _p_and_b(phi: float, phi_dot: float, psi_dot: float) -> tuple[float, float, np.ndarray]:
    inverse, force, contact = _oscillator(phi, phi_dot, psi_dot)
    normal = np.array([np.sin(phi), 1]) @ inverse
    return normal @ contact, normal @ force + np.cos(phi) * phi_dot**2, inverse


def oscillator_start(delta: float, p: float, b: float, v: float) -> tuple[float, float]:
    """phi and phi_dot at which the mechanism's own p and b are delta^2 p, delta^2 b."""

    def psi_dot(phi: float, phi_dot: float) -> float:
        return delta**4 * v - np.sin(phi) * phi_dot

    reach = 60 * delta**2
    phi = brentq(lambda x: _p_and_b(x, 0, 0)[0] - delta**2 * p, PHI - reach, PHI + reach, xtol=1e-16, rtol=1e-15)
    phi_dot = brentq(
        lambda w: _p_and_b(phi, w, psi_dot(phi, w))[1] - delta**2 * b, -1 - reach, -1 + reach, xtol=1e-16, rtol=1e-15
    )
    return phi, phi_dot


def oscillator_motion(
    delta: float, start: float, state: Sequence[float], places: Sequence[float]
) -> list[dict[str, float]]:
    """The frictional impact oscillator in contact; ``state`` is (phi, phi_dot, y, v, z) with y, v, z scaled."""

    def rates(_: float, x: np.ndarray) -> list[float]:
        phi, phi_dot, y, v, z = x
        psi_dot = delta**4 * v - np.sin(phi) * phi_dot
        inverse, force, contact = _oscillator(phi, phi_dot, psi_dot)
        p, b, _ = _p_and_b(phi, phi_dot, psi_dot)
        pushed = z - y
        turned = (inverse @ (force + contact * pushed))[0]
        return [delta**2 * phi_dot, delta**2 * turned, v, (b + p * pushed) / delta**2, (-z - pushed) / delta]

    found = []
    for phi, phi_dot, y, v, z in _run(rates, start, state, places):
        p, b, _ = _p_and_b(phi, phi_dot, delta**4 * v - np.sin(phi) * phi_dot)
        scaled = {"p": p / delta**2, "b": b / delta**2, "y": y, "v": v, "z": z, "lambda_n": z - y}
        found.append({"xi_1": (phi - PHI) / delta**2, "xi_3": (phi_dot + 1) / delta**2, **scaled})
    return found
