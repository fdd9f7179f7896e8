"""The series in (t, ε) put into the system of the extended example, far beyond the printed terms."""

from __future__ import annotations

import pytest
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.section_5.double_series import ALPHA, POWER_OF_DELTA, example_series, scaled_series

CONTEXT = fmpq_mpoly_ctx.get(["t", "epsilon"], "degrevlex")
T, EPS = CONTEXT.gens()
WEIGHT = 24


def terms(name: str, chi: fmpq) -> fmpq_mpoly:
    found = {(i, j): value(chi) for (i, j), value in example_series(WEIGHT)[name].items()}
    return CONTEXT.from_dict({key: value for key, value in found.items() if value})


@pytest.mark.parametrize("chi", [fmpq(0), fmpq(1), fmpq(-3, 7)])
def test_the_series_satisfy_the_system(chi: fmpq) -> None:
    """b' = α2 - α3 λ, p' = α1 + χ b, y' = v, v' = b + p λ, ε z' + z + ε² λ = 0, with ε² λ = z - y."""
    b, p, y, v, z = (terms(name, chi) for name in "bpyvz")
    force = z - y
    residuals = [
        EPS**2 * (b.derivative("t") - ALPHA[1]) + ALPHA[2] * force,
        p.derivative("t") - ALPHA[0] - chi * b,
        y.derivative("t") - v,
        EPS**2 * (v.derivative("t") - b) - p * force,
        EPS * z.derivative("t") + z + force,
    ]
    for residual in residuals:
        assert min((2 * i + 3 * j for i, j in residual.to_dict()), default=WEIGHT) > WEIGHT - 3
    assert not b.is_zero()
    assert p.to_dict()[1, 0] == ALPHA[0]
    assert (chi == 0) is (len(b.to_dict()) == 1)


def test_the_scaled_series_are_the_same_terms() -> None:
    algebra = Algebra("s delta chi")
    for name, power in POWER_OF_DELTA.items():
        found = scaled_series(algebra, name, 9).to_dict()
        assert all(0 <= n < 9 for _, n, _ in found)
        tables = example_series(WEIGHT)
        for i in range(4):
            for j in range(4):
                n = 2 * i + 3 * j - power
                value = (
                    tables[name].get((i, j), fmpq_poly([]))
                    if name != "lam"
                    else tables["z"].get((i, j), fmpq_poly([])) - tables["y"].get((i, j), fmpq_poly([]))
                )
                if 0 <= n < 9:
                    shown = {k: a for (s, delta, k), a in found.items() if (s, delta) == (i, n)}
                    assert shown == {k: a for k, a in enumerate(value.coeffs()) if a}
                elif n < 0:
                    assert value.degree() < 0
