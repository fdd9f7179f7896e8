"""b-hat, v-hat and y-hat of a run at p = 0, and the time at which b-hat vanishes, in balls.

Proof pages: those of ``compliant_force``; for what is measured ``proofs/scaling_exponents.md``.
"""

from __future__ import annotations

from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_model
from gspot_verified.compliant.motion.compliant_force import ContactMotion, contact_motion, force
from gspot_verified.numbers.balls import approximate, hull, sign_of, working_bits
from gspot_verified.paper.numerics.paper_state import paper_state

_DIGITS = 9
_BITS = 128
_VALUE_BITS = 40
_STEPS = 12
_HALF_WIDTH = fmpq(1, 10**7)


@lru_cache(maxsize=512)
def deviations(beta: fmpq, nu: fmpq, epsilon: fmpq) -> dict[str, arb]:
    """b-hat, v-hat and y-hat at p = 0 of the run of Fig. varsim1 with nu.

    >>> found = deviations(fmpq(5, 2), fmpq(2), fmpq(1, 1000))
    >>> found["b"] < 0 < found["v"]
    True
    """
    model, state = _run(beta, nu, epsilon)
    there = force(model, state, 0, _DIGITS)
    with working_bits(_BITS):
        return {"b": there.b, "v": there.v, "y": there.y + 2 * epsilon**2 * model.mean_force}


@lru_cache(maxsize=128)
def crossing(beta: fmpq, nu: fmpq, epsilon: fmpq, scaled_guess: fmpq) -> arb | None:
    """The time from p = 0 to a zero of b-hat near tau = ``scaled_guess``, relative width 2 10^-7; None: not found."""
    motion = contact_motion(*_run(beta, nu, epsilon))
    unit = fmpq(*((2 * approximate(epsilon) ** 2) ** (1 / 3)).as_integer_ratio())
    place = _rounded(scaled_guess * unit)
    step = _rounded(place / 64)
    before = _value(motion, place - step)
    for _ in range(_STEPS):
        here = _value(motion, place)
        change = approximate((here - before).mid())
        if change == 0:
            return None
        step, before = _rounded(-step * fmpq(*(approximate(here.mid()) / change).as_integer_ratio())), here
        place += step
        if abs(step) < abs(place) * _HALF_WIDTH / 16:
            break
    first, last = place * (1 - _HALF_WIDTH), place * (1 + _HALF_WIDTH)
    signs = {sign_of(_value(motion, time)) for time in (first, last)}
    if signs != {1, -1}:
        return None
    with working_bits(_BITS):
        return hull([arb(first), arb(last)])


def _run(beta: fmpq, nu: fmpq, epsilon: fmpq) -> tuple[CompliantModel, CompliantState]:
    model = compliant_model(beta, epsilon)
    return model, paper_state(model, nu)


def _value(motion: ContactMotion, time: fmpq) -> arb:
    """b-hat at t, in the normal form: only its sign and its ratios are used."""
    slow, fast, _ = motion.hats(motion.model.alpha_1 * time, _VALUE_BITS, ("b",))
    with working_bits(_BITS):
        return slow["b"] + fast["b"]


def _rounded(value: fmpq) -> fmpq:
    """A rational near the value with few bits: heuristic places stay short."""
    return fmpq(*approximate(value).as_integer_ratio())
