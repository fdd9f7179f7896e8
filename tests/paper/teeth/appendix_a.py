"""Wrong formulas for Appendix A."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from flint import fmpq, fmpq_poly
from paper.bite import Bite, NotApplicable, Teeth, raised, scaled, unseen_at

from gspot_verified.paper.appendix_a import appendix_a as ledger
from gspot_verified.paper.appendix_a import appendix_a_asymptotics as asymptotics
from gspot_verified.paper.appendix_a import hypergeometric as printed
from gspot_verified.paper.checks.entry import Entry

_FEW = 3
_TRIED = ledger.BETAS[-_FEW:]
_IN_BETA = unseen_at("beta", _TRIED)


def _at_few(build: Callable[[], Entry]) -> Entry:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ledger, "BETAS", ledger.BETAS[-_FEW:])
        return build()


ENTRIES = {identifier: partial(_at_few, build) for identifier, build in ledger.ENTRIES.items()}
"""The entries of the module, tried at few values of β: a bite must be noticed there too."""


def with_beta(beta: int) -> Any:
    """The values of β that are tried, and an excluded one."""
    return lambda betas: (*betas, fmpq(beta))


def turned(honest: str) -> str:
    """The formula with the other sign."""
    return f"-({honest})"


def doubled(honest: str) -> str:
    """Twice the formula."""
    return f"2*({honest})"


def near_coefficient(honest: Any) -> Any:
    """The generic factor in front of every c_k."""
    return lambda k: honest(k) * fmpq(1000003, 1000000)


def unseen_coefficient(honest: Any) -> Any:
    """A factor in front of c_k that is 1 at β = 0, 1, ..., 5."""
    vanishing = fmpq_poly([1])
    for n in range(6):
        vanishing *= fmpq_poly([-n, 1])
    return lambda k: honest(k) * (1 + vanishing)


def _small(j: int, excluded: int) -> tuple[Any, ...]:
    combination = ["real", "imaginary"] if j else ["real"]
    return (
        *(Bite("factor", printed.SMALL, f"{name} {j}", scaled) for name in ("h", "e", *combination)),
        *(Bite("factor", printed.SMALL, f"{name} {j}", turned, True) for name in ("h", "e", *combination)),
        *(Bite("factor", printed.SMALL, f"{name} {j}", doubled, True) for name in ("h", "e", *combination)),
        *(Bite("factor", printed.SERIES, name, scaled) for name in ("h", "e")),
        *(Bite("hidden factor", printed.SMALL, f"{name} {j}", _IN_BETA) for name in ("h", "e")),
        Bite("hidden factor", printed.SERIES, "h", unseen_at("k", range(10))),
        Bite("hidden factor", printed.SERIES, "e", unseen_at("k", range(5))),
        Bite("hypothesis", ledger, "BETAS", with_beta(excluded)),
        *(Bite("order", printed.SERIES, name, raised("x")) for name in ("h", "e")),
    )


def _initial_value(label: str, excluded: int) -> tuple[Any, ...]:
    tables = (printed.INITIAL_VALUES, printed.ENTIRE_INITIAL_VALUES)
    return (
        *(Bite("factor", table, label, scaled) for table in tables),
        *(Bite("hidden factor", table, label, _IN_BETA) for table in tables),
        Bite("hypothesis", ledger, "BETAS", with_beta(excluded)),
        *(Bite("order", table, label, raised("3")) for table in tables),
    )


def _large(j: int) -> tuple[Any, ...]:
    return (
        Bite("factor", printed.LARGE, f"factor {j}", scaled),
        *(Bite("factor", printed.LARGE, f"factor {j}", wrong, refutes=True) for wrong in (turned, doubled)),
        *(Bite("factor", printed.SERIES, "e_1", wrong, refutes=True) for wrong in (scaled, turned, doubled)),
        Bite("hidden factor", printed.LARGE, f"factor {j}", _IN_BETA),
        Bite("hidden factor", printed.SERIES, "e_1", unseen_at("k", range(5))),
        Bite("hypothesis", asymptotics.EXCEPTIONS, str(j), lambda honest: f"{honest}+3"),
        Bite("order", printed.LARGE, f"factor {j}", raised("3")),
        Bite("order", printed.SERIES, "e_1", raised("tau")),
    )


TEETH: Teeth = {
    "A-th3": (
        *(Bite("factor", printed.FUNCTIONS, name, scaled) for name in ("argument", "front 1", "upper 0", "lower 2")),
        Bite("hidden factor", printed.FUNCTIONS, "upper 0", _IN_BETA),
        Bite("hidden factor", printed.FUNCTIONS, "front 2", unseen_at("tau", (-9, 8))),
        NotApplicable("hypothesis", "the theorem is for every β and every τ"),
        *(Bite("order", printed.FUNCTIONS, name, raised("tau")) for name in ("front 2", "argument")),
    ),
    "A-coefficients": (
        Bite("factor", ledger, "coefficient", near_coefficient),
        Bite("factor", ledger, "coefficient_by_inversion", near_coefficient),
        Bite("hidden factor", ledger, "coefficient", unseen_coefficient),
        NotApplicable("hypothesis", "polynomials in β, compared for every β; k < 8 is the claim itself"),
        Bite("order", ledger, "coefficient", lambda honest: lambda k: honest(k + 1)),
    ),
    # Γ((3 + β)/3), Γ((2 + β)/3), Γ((1 + β)/3) have poles at β = -3, -2, -1.
    "A-bsmall1": _small(0, -3),
    "A-bsmall2": _small(1, -2),
    "A-bsmall3": _small(2, -1),
    "A-cancellation": (
        *(Bite("factor", printed.INITIAL_VALUES, label, scaled) for label in printed.INITIAL_VALUES),
        *(Bite("factor", printed.SMALL, f"{name} {j}", scaled) for name in ("e", "real") for j in range(3)),
        Bite("factor", printed.SMALL, "imaginary 1", scaled),
        *(Bite("hidden factor", printed.INITIAL_VALUES, label, _IN_BETA) for label in printed.INITIAL_VALUES),
        Bite("hidden factor", printed.SMALL, "e 1", _IN_BETA),
        Bite("hypothesis", ledger, "BETAS", with_beta(3)),
        *(Bite("order", printed.INITIAL_VALUES, label, raised("3")) for label in printed.INITIAL_VALUES),
    ),
    "A-t01": _initial_value("t01", 3),
    "A-t02": _initial_value("t02", 4),
    "A-t03": _initial_value("t03", 2),
    "A-leading": (
        *(Bite("factor", printed.THETA, name, scaled) for name in ("small front", "small leading")),
        *(Bite("factor", printed.THETA, name, turned, True) for name in ("small front", "small leading")),
        *(Bite("factor", printed.THETA, name, doubled, True) for name in ("small front", "small leading")),
        Bite("factor", printed.SERIES, "h", scaled),
        *(Bite("hidden factor", printed.THETA, name, _IN_BETA) for name in ("small front", "small leading")),
        Bite("hidden factor", printed.SERIES, "h", unseen_at("k", range(12))),
        Bite("hypothesis", ledger, "BETAS", with_beta(-1)),
        Bite("order", printed.THETA, "small leading", raised("x")),
        Bite("order", printed.SERIES, "h", raised("x")),
    ),
    "A-blarge1": _large(0),
    "A-blarge2": _large(1),
    "A-blarge3": _large(2),
    "A-th5-condition": (
        *(Bite("factor", asymptotics.EXCEPTIONS, str(j), scaled) for j in range(3)),
        *(Bite("factor", printed.LARGE, f"factor {j}", scaled) for j in range(3)),
        *(Bite("hidden factor", asymptotics.EXCEPTIONS, str(j), unseen_at("m", range(3))) for j in range(3)),
        # Without the first exception: said to hold at β = j.
        *(Bite("hypothesis", asymptotics.EXCEPTIONS, str(j), lambda honest: f"{honest}+3") for j in range(3)),
        *(Bite("order", asymptotics.EXCEPTIONS, str(j), lambda honest: f"{honest}+1") for j in range(3)),
    ),
    "A-tlarge": (
        *(Bite("factor", printed.THETA, name, scaled) for name in ("large front", "large leading")),
        *(Bite("factor", printed.THETA, name, turned, True) for name in ("large front", "large leading")),
        *(Bite("factor", printed.THETA, name, doubled, True) for name in ("large front", "large leading")),
        Bite("factor", printed.SERIES, "e_1", scaled),
        Bite("factor", printed.THETA, "integer leading", scaled),
        Bite("hidden factor", printed.THETA, "integer leading", unseen_at("n", range(6))),
        *(Bite("hidden factor", printed.THETA, name, _IN_BETA) for name in ("large front", "large leading")),
        Bite("hidden factor", printed.SERIES, "e_1", unseen_at("k", range(5))),
        Bite("hypothesis", ledger, "BETAS", with_beta(2)),
        Bite("order", printed.THETA, "large leading", raised("tau")),
        Bite("order", printed.SERIES, "e_1", raised("tau")),
    ),
}
