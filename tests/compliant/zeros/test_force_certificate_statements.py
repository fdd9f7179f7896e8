"""What the statements on the force say, as text and as it stands in a certificate; they are no verdicts.

Page: proofs/certificate.md, version 2.
"""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.compliant.zeros.force_certificate import ForceStatement, LiftOffStatement
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.work.ranges import Range

SYSTEM = "on the slow manifold of the compliant model with α = (-1, -1, -5/2) and C1 = -1, τ = κ t ε^(-2/3), κ^3 = 1/2"
FORCE = ForceStatement(
    contact_force("5/2", c1=-1), Range(fmpq(-10), None, True, False), fmpq(4, 5), fmpq(1, 3)
)  # fmt: skip
LIFT_OFF = LiftOffStatement(contact_force("5/2", c1=-1), fmpq(7, 2), fmpq(1, 100), fmpq(1, 3))


def test_texts() -> None:
    assert str(FORCE) == f"{SYSTEM}, λ > 0 for every τ in [-10, inf) and every ε in (0, 4/5]"
    assert str(LIFT_OFF) == f"{SYSTEM}, λ < 0 at τ = 7/2 for every ε ≥ 1/100"


@pytest.mark.parametrize(
    ("statement", "kind", "epsilon", "tau"),
    [(FORCE, "force", "4/5", "[-10, inf)"), (LIFT_OFF, "lift_off", "1/100", "7/2")],
)
def test_as_it_stands_in_a_certificate(
    statement: ForceStatement | LiftOffStatement, kind: str, epsilon: str, tau: str
) -> None:
    assert statement.version == 2
    data = statement.to_json()
    assert {name: str(value) for name, value in data.items()} == {
        "kind": kind, "alpha": "['-1', '-1', '-5/2']", "c1": "-1", "epsilon": epsilon, "level": "1/3", "tau": tau,
    }  # fmt: skip
    with pytest.raises(TypeError, match="epsilon is what is stated"):
        bool(statement)
