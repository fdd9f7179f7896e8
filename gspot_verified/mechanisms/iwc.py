"""Whether the contact holds after the G-spot of a mechanism: :mod:`compliant.contact.iwc` with its alphas."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from flint import arb

from gspot_verified.compliant.contact.iwc import CompliantIwc, compliant_iwc, iwc_over_balls
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.classify import Classification, classify
from gspot_verified.numbers.balls import ExactInput, exact


def iwc(
    beta: ExactInput | Mechanism | Classification | None = None,
    *,
    alpha_1: ExactInput | None = None,
    alpha_2: ExactInput | None = None,
    alpha_3: ExactInput | None = None,
    c1: ExactInput | None = None,
    tau_start: ExactInput = -10,
    epsilon: ExactInput | None = None,
    digits: int = 15,
    growth: bool = False,
    spot: int | None = None,
) -> CompliantIwc:
    """Whether the contact holds on [tau_start, infinity), or when it lifts off: at leading order, and for the compliant
    model on its slow manifold; :func:`gspot_verified.compliant.contact.iwc.compliant_iwc`, also for a mechanism.

    ``beta`` is a number, a mechanism (its G-spot is found, or that of the number ``spot`` as ``classify_all`` lists
    them), or a classification. The compliant model has constant alphas, those of the G-spot: nothing is stated about
    the mechanism away from it.

    Where the G-spot is not rational its alphas are balls, and the statements are for all alphas in them; alphas that
    are given may be balls too, without ``beta``.

    :raises ValueError: as for numbers; the G-spot is in no Case; numbers beside a mechanism; ``growth`` where the
        alphas are balls; there is no G-spot of the number ``spot``, or no mechanism beside it.
    :raises GSpotError: the mechanism has no G-spot there.

    >>> from gspot_verified import load
    >>> iwc(load("oscillator", beta="5/2")).leading.force.beta
    5/2
    """
    chosen: dict[str, Any] = {"c1": c1, "tau_start": tau_start, "epsilon": epsilon, "digits": digits, "growth": growth}
    if isinstance(beta, Mechanism):
        beta = classify(at_spot(beta, spot))
    elif spot is not None:
        raise ValueError("spot: it is the number of a mechanism's G-spot; give the mechanism")
    if not isinstance(beta, Classification):
        second = -1 if alpha_2 is None else alpha_2
        first = -1 if alpha_1 is None else alpha_1
        if beta is None and alpha_3 is not None and any(_is_wide(value) for value in (first, second, alpha_3)):
            return _over_balls("the numbers", first, second, alpha_3, chosen)
        return compliant_iwc(beta, alpha_1=alpha_1, alpha_2=second, alpha_3=alpha_3, **chosen)
    if not (alpha_1 is alpha_2 is alpha_3 is None):
        raise ValueError("alpha_1, alpha_2, alpha_3: the mechanism has its own")
    if not beta.regularisation.is_papers:
        raise ValueError(
            f"{beta.name}: the compliant model has k_1 = k_2 = 1/epsilon^2 and c = 1/epsilon; for other constants "
            "nothing is stated (in the leading order they change epsilon alone)"
        )
    if beta.case not in ("I", "II", "III"):
        raise ValueError(f"{beta.name}: the statements are about Cases I, II and III, and here: {beta.reason}")
    alphas = (beta.alpha_1, beta.alpha_2, beta.alpha_3)
    if any(isinstance(value, arb) for value in alphas):
        return replace(_over_balls(beta.name, *alphas, chosen), of_mechanism=True)
    first, second, third = alphas
    return replace(compliant_iwc(alpha_1=first, alpha_2=second, alpha_3=third, **chosen), of_mechanism=True)


def _is_wide(value: ExactInput) -> bool:
    return isinstance(exact(value, "alpha"), arb)


def _over_balls(
    name: str, alpha_1: ExactInput, alpha_2: ExactInput, alpha_3: ExactInput, chosen: dict[str, Any]
) -> CompliantIwc:
    if chosen["growth"]:
        raise ValueError(f"growth: the table needs rational alphas, and those of {name} are balls")
    options = {key: value for key, value in chosen.items() if key != "growth"}
    return iwc_over_balls(alpha_1, alpha_2, alpha_3, **options)
