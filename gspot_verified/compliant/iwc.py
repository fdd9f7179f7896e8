"""Whether the contact holds: what is proved at leading order, and what is proved about the compliant model itself.

Proof page: ``proofs/monotone.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from gspot_verified.balls import ExactInput
from gspot_verified.compliant.slow_manifold import SlowManifold, impact
from gspot_verified.compliant.threshold import MAX_BETA_OF_THEOREM
from gspot_verified.signs.contact_force import rational
from gspot_verified.signs.iwc import CAVEAT, IwcResult
from gspot_verified.signs.iwc import iwc as leading_order
from gspot_verified.verdict import ASK_VERDICT, NoTruthValue, Verdict


@dataclass(frozen=True, slots=True)
class CompliantIwc(NoTruthValue):
    """The result of :func:`iwc`: the statement at leading order and, where a theorem covers it, the one about the
    compliant model on its slow manifold."""

    ask: ClassVar[str] = ASK_VERDICT

    leading: IwcResult
    slow: SlowManifold | None

    @property
    def verdict(self) -> Verdict:
        """That of the compliant model where there is one, else that at leading order."""
        return self.leading.verdict if self.slow is None else self.slow.verdict

    def __str__(self) -> str:
        if self.slow is None:
            return str(self.leading)
        return "\n".join([*self.leading.lines(), *self.slow.lines()])

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``: that of the leading order, and ``slow_manifold`` (null: nothing is proved).

        ``statements`` lists what is stated, each with the system that it is about.
        """
        slow = self.slow
        about = [("leading order", self.leading.verdict)] + ([] if slow is None else [("slow manifold", slow.verdict)])
        return {
            **self.leading.to_json(),
            "slow_manifold": None if slow is None else slow.to_json(),
            "statements": [{"system": name, **verdict.to_json()} for name, verdict in about],
            "caveat": CAVEAT if slow is None else None,
        }


def iwc(
    beta: ExactInput | None = None,
    *,
    alpha_1: ExactInput | None = None,
    alpha_2: ExactInput = -1,
    alpha_3: ExactInput | None = None,
    c1: ExactInput | None = None,
    tau_start: ExactInput = -10,
    epsilon: ExactInput | None = None,
    digits: int = 15,
    growth: bool = False,
) -> CompliantIwc:
    """Whether the contact holds on [tau_start, infinity), or when it lifts off: at leading order, and for the compliant
    model on its slow manifold.

    Arguments and errors: :func:`gspot_verified.signs.iwc.iwc`. On the side C_1/Gamma(-beta) > 0, for 0 < beta < 5,
    every eps_0 at leading order is one for the compliant model (Theorem C of the page), and the exact eps_0 is found.

    >>> iwc("5/2").verdict.statement
    'on the slow manifold of the compliant model, λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.894881353)'
    """
    leading = leading_order(
        beta, alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, c1=c1, tau_start=tau_start, epsilon=epsilon,
        digits=digits, growth=growth,
    )  # fmt: skip
    force = leading.force
    if not (force.takes_impact and force.beta < MAX_BETA_OF_THEOREM):
        return CompliantIwc(leading, None)
    return CompliantIwc(leading, impact(leading, None if epsilon is None else rational(epsilon, "epsilon"), digits))
