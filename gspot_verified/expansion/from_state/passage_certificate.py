"""A certificate of Theorem B for the model system: the way from a state towards the G-spot, for all small epsilon.

The producer's side of ``proofs/from_state.md``, section 10. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

from typing import Any

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.certificates.text import PASSAGE_VERSION, sealed
from gspot_verified.expansion.from_state.barrier import Tube
from gspot_verified.expansion.from_state.choice import Plan, plans
from gspot_verified.expansion.from_state.model_side import ModelSide
from gspot_verified.expansion.from_state.passage import ModelStart, rounded_up, tube_from
from gspot_verified.expansion.from_state.slow_series import Contact, slow_series, terms_of
from gspot_verified.expansion.true_solutions.bound import BITS
from gspot_verified.numbers.balls import ball, working_bits

_SHORT = 2**20  # denominators of the bounds that are written
_LAST = 2**60  # of p at the end of the rectangle, which may be small
_MORE = fmpq(257, 256)  # what the written bounds exceed the computed ones by: any number above 1 is right


def passage_certificate(side: ModelSide) -> str:
    """The text of a certificate that ``gspot-verified check`` reads: contact lasts from the state of ``side`` down to
    p = S a epsilon^(2/3), L keeps its sign and C_1 moves by no more than stated, for every epsilon up to that of
    ``side``. What happens after that, lift-off or impact, is not part of it.

    :raises ValueError: Theorem B is not shown at that epsilon.

    >>> from gspot_verified import model_side
    >>> print(passage_certificate(model_side("3/2", "1/2", -2, epsilon="1e-6"))[:36])
    {"format":"gspot_verified certificat
    """
    with working_bits(BITS):
        plan, tube = _passed(side.start, side.epsilon)
        return sealed(PASSAGE_VERSION, *_content(side.start, side.epsilon, plan, tube))


def _passed(start: ModelStart, epsilon: fmpq) -> tuple[Plan, Tube]:
    """The tube of the first S at which there is one."""
    failed = list[str]()
    for choices in plans(start.beta, -start.alpha_1, Contact.of(start.regularisation)):
        found = tube_from(start, rounded_up(ball(epsilon).root(3)), choices)
        if not isinstance(found, str):
            return found
        failed.append(found)
    raise ValueError(f"Theorem B is not shown for epsilon up to {epsilon}: {failed[0]}")


def _content(start: ModelStart, epsilon: fmpq, plan: Plan, tube: Tube) -> tuple[dict[str, Any], list[Any]]:
    """The statement, and the one line with what the producer chose."""
    contact, springs = Contact.of(start.regularisation), start.regularisation
    series = slow_series(start.beta, contact, plan.order)
    end = (ball(-start.alpha_1 * epsilon / tube.rectangle.h) ** 2).root(3)
    least = rounded_up(end, _LAST)
    statement: dict[str, Any] = {
        "alpha": _texts(start.alpha_1, start.alpha_2, start.beta * start.alpha_1),
        "b": str(start.b),
        "contact": _texts(springs.k_1, springs.k_2, springs.c),
        "drift": str(rounded_up(_drift(tube, series.w, ball(least).sqrt()), _SHORT)),
        "epsilon": str(epsilon),
        "kind": "passage",
        "p": str(start.p),
        "scaled": str(plan.place),
        "within": str(start.within),
    }
    line: dict[str, Any] = {
        "damping": str(plan.damping),
        "f": _terms(series.f),
        "growth": str(plan.growth),
        "largest": str(tube.largest),
        "least": str(least),
        "norm": _texts(plan.k_1, plan.k_2),
        "rate": str(rounded_up(tube.rate, _LAST)),
        "rectangle": _texts(tube.rectangle.h, tube.rectangle.r),
        "v": _terms(series.v),
        "w": _terms(series.w),
    }
    return statement, [line]


def _drift(tube: Tube, w: fmpq_mpoly, last: arb) -> arb:
    """A bound of \\|log(C/C_1)\\| down to where sqrt(p) = ``last``, with some room."""
    h = ball(tube.rectangle.h)
    slow = sum((ball(abs(c) * 2 / (3 * i - n)) * h**i * last**n for (i, n), c in terms_of(w).items()), arb(0))
    return (tube.beta * slow + tube.drift(last)) * ball(_MORE)


def _texts(*values: fmpq) -> list[str]:
    return [str(value) for value in values]


def _terms(polynomial: fmpq_mpoly) -> list[list[Any]]:
    return [[*key, str(value)] for key, value in sorted(terms_of(polynomial).items())]
