"""Theorem 1's recursion written directly in sympy, as one would at first: the baseline of ``cost expand``."""

from __future__ import annotations

from fractions import Fraction
from typing import Any


def sympy_extended(order: int, chi: int = 1) -> list[list[Fraction]]:
    """The coefficients of b_0, ..., b_(order-1) for the extended system, alpha = (-1, -1, -3/2).

    The same four steps on sympy expressions: substitute, expand, take coefficients, solve by the ansatz.
    """
    import sympy

    s, delta = sympy.symbols("s delta")
    state = sympy.symbols("xi1:7")
    alpha_1, alpha_2, alpha_3 = sympy.Integer(-1), sympy.Integer(-1), sympy.Rational(-3, 2)
    drift = (state[1], 0, state[3], state[5], alpha_1 + chi * state[5], alpha_2)
    control = (0, -1, 0, state[4], 0, -alpha_3)
    p: list[Any] = []
    b: list[Any] = []
    y: list[Any] = []
    z: list[Any] = []
    v: list[Any] = []
    force: list[Any] = []
    xi: list[list[Any]] = []

    def term(function: Any, n: int) -> Any:
        """The coefficient of delta^n of a function of the state."""
        values = {x: sum(xi[k][i] * delta ** (k + 2) for k in range(max(n - 1, 0))) for i, x in enumerate(state)}
        return sympy.expand(sympy.sympify(function).subs(values)).coeff(delta, n)

    for n in range(order):
        p.append(sympy.integrate(term(alpha_1 + chi * state[5], n), s))
        right_b = term(alpha_2, n)
        right_v = sum(p[n - k] * force[k] for k in range(n))
        before = z[n - 1] if n else sympy.Integer(0)
        right = sympy.Poly(
            sympy.expand(
                2 * sympy.diff(right_b, s, 2) + alpha_3 * sympy.diff(before, s, 3)
                + alpha_1 * s * right_b + alpha_3 * right_v
            ),
            s,
        )  # fmt: skip
        unknown = sympy.symbols(f"c0:{right.degree() + 1}") if not right.is_zero else ()
        ansatz = sum((c * s**k for k, c in enumerate(unknown)), sympy.Integer(0))
        left = 2 * sympy.diff(ansatz, s, 3) + alpha_1 * s * sympy.diff(ansatz, s) - alpha_3 * ansatz
        equations = sympy.Poly(sympy.expand(left - right.as_expr()), s).all_coeffs() if unknown else []
        b.append(ansatz.subs(sympy.solve(equations, unknown, dict=True)[0]) if unknown else ansatz)
        force.append(sympy.expand((right_b - sympy.diff(b[n], s)) / alpha_3))
        y.append(sympy.expand(-2 * force[n] - sympy.diff(before, s)))
        v.append(sympy.diff(y[n], s))
        z.append(sympy.expand(-force[n] - sympy.diff(before, s)))
        slopes = [
            term(f, n) + sum(term(g, n - k) * force[k] for k in range(n + 1))
            for f, g in zip(drift, control, strict=True)
        ]
        # At s = 0: xi_1 = xi_2 = 0, y = xi_3, v = xi_4, p = xi_5, b = xi_6 with their powers of delta.
        constants = (
            0,
            0,
            y[n - 4].subs(s, 0) if n >= 4 else 0,
            v[n - 2].subs(s, 0) if n >= 2 else 0,
            0,
            b[n].subs(s, 0),
        )
        xi.append([sympy.expand(sympy.integrate(f, s) + c) for f, c in zip(slopes, constants, strict=True)])
    return [[Fraction(int(c.p), int(c.q)) for c in sympy.Poly(term_n, s).all_coeffs()[::-1]] for term_n in b]
