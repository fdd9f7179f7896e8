"""The motion of the compliant model in contact, from any initial state or on the slow manifold, in balls.

Proof pages: ``proofs/exact_solution.md``, ``proofs/first_integrals.md``, ``proofs/fast_part.md``; near the initial
state ``proofs/contact_series.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast, overload

from flint import arb, fmpq

from gspot_verified.compliant.fast.fast_part import fast_bound_at, fast_part
from gspot_verified.compliant.model.force_result import CompliantForce
from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, Deviation, deviation
from gspot_verified.compliant.motion.contact_series import MAX_WORK, carried, series_work
from gspot_verified.compliant.slow.slow_coefficient import slow_coefficient
from gspot_verified.compliant.slow.slow_part import slow_part
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import (
    ExactInput,
    add_remainder,
    approximate,
    bits_for_digits,
    nonfinite,
    relative_bits,
    shrink_to_bits,
    working_bits,
)
from gspot_verified.numbers.verdict import Reason

if TYPE_CHECKING:
    from numpy import ndarray

MAX_DIGITS = 1_000  # as many as slow_solution.py gives
_ATTEMPTS = 4  # with as many bits more as were missing; then what was reached
_GUARD_BITS = 16  # bits beyond those asked for, lost on the way; any number is right
_NEGLIGIBLE_BITS = 8  # that a bounded fast part may cost before it is computed; any number is right
LEAST_EPSILON_OF_QUADRATURE = fmpq(1, 20_000)
"""Below it the fast part is only bounded; any number is right."""
_WORK_OF_SERIES = 2_000  # rate times time, up to which the power series costs less than the parts; any number is right

VARIABLES = ("b", "force", "V", "Z")


@dataclass(frozen=True, slots=True)
class SlowMotions:
    """The motions b-hat ~ C_1 (-t)^beta, t -> -infinity, of the model: multiples of the slow solution."""

    c1: fmpq


@overload
def force(
    model: CompliantModel, start: CompliantState | SlowMotions, time: ExactInput, digits: int = 15
) -> CompliantForce: ...


@overload
def force(
    model: CompliantModel, start: CompliantState | SlowMotions, time: ndarray[Any, Any], digits: int = 15
) -> ndarray[Any, Any]: ...


def force(
    model: CompliantModel, start: CompliantState | SlowMotions, time: Any, digits: int = 15
) -> CompliantForce | ndarray[Any, Any]:
    """The contact force of the compliant model at t (p = alpha_1 t), with relative accuracy 10^-digits, and b, y, v, z.

    ``start``: an initial state, and t not before it; or the slow manifold with its C_1. From a state with p > 0 every
    later time is in reach; with p <= 0 about 3 000 units epsilon/|alpha_1| of time. The values are those
    of the contact phase: they hold for the model when contact has lasted until t (:func:`contact_lasts`). A numpy
    array of times gives an object array of balls of the force; floats in it stand for their binary values.

    :param digits: 1..1000.
    :raises TypeError: a float.
    :raises ValueError: a time before the state, or too long after a state with p <= 0; an argument out of range.

    >>> from gspot_verified import ball_text, compliant_model, compliant_state
    >>> model = compliant_model("5/2", "1e-6")
    >>> print(ball_text(force(model, SlowMotions(fmpq(1)), "1e-4", digits=8).force, 8))
    [0.66666748 +/- 3.77e-9]
    """
    if type(time).__name__ == "ndarray":  # by name: numpy is not imported before someone uses it
        import numpy as np

        times = cast("ndarray[Any, Any]", time)
        forces = np.empty(times.shape, dtype=object)
        for index, entry in np.ndenumerate(times):
            forces[index] = force(model, start, _entry(entry), digits).force
        return forces
    moment = rational(time, "t")
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}, got {digits}")
    motion = contact_motion(model, start)
    if motion.state is not None and model.alpha_1 * moment > motion.state.p:
        raise ValueError(f"t: {moment} is before the initial state")
    return motion.at(moment, digits)


def _entry(value: Any) -> ExactInput:
    if isinstance(value, float):
        if value - value != 0:
            raise ValueError(f"t: every entry must be finite, got {value}")
        return fmpq(*value.as_integer_ratio())
    return int(value) if hasattr(value, "__index__") else cast("ExactInput", value)


@dataclass(frozen=True, slots=True)
class ContactMotion:
    """The contact phase of one model: from a state (its difference from the trivial solution), or on the slow
    manifold with the coefficient C_1."""

    model: CompliantModel
    state: Deviation | None
    c1: fmpq | None

    def at(self, time: fmpq, digits: int, parts: bool = True) -> CompliantForce:
        """All variables at one time, with rising precision until the force is accurate.

        Without ``parts`` the slow and the fast part may be missing, which costs less.

        :raises ValueError: a state with p <= 0, and the time too long after it.
        """
        if self.state is None:
            return self._accurate(time, digits, by_series=False)
        work = series_work(self.state, self._since(time))
        late = not self.state.p > 0
        if late and work > MAX_WORK:
            raise ValueError(
                f"t: {time} is too long after an initial state with p <= 0: the power series needs a work of "
                f"{approximate(work):.3g}, its limit is {MAX_WORK}"
            )
        soon = self.model.scaled_epsilon < LEAST_EPSILON_OF_QUADRATURE or not parts
        if late or (soon and work <= _WORK_OF_SERIES):
            return self._accurate(time, digits, by_series=True)
        contact_force = self._accurate(time, digits, by_series=False)
        if not contact_force.reached and work <= MAX_WORK:
            return self._accurate(time, digits, by_series=True)
        return contact_force

    def _since(self, time: fmpq) -> fmpq:
        """How long after the state a time is, in T."""
        assert self.state is not None
        return (self.state.p - self.model.alpha_1 * time) / self.model.scaled_epsilon

    def _accurate(self, time: fmpq, digits: int, by_series: bool) -> CompliantForce:
        goal = bits_for_digits(digits)
        bits = goal + _GUARD_BITS
        contact_force = None
        for _ in range(_ATTEMPTS):
            contact_force = self._by_series(time, digits, bits) if by_series else self._once(time, digits, bits)
            if contact_force.reached:
                return contact_force
            certain = relative_bits(contact_force.force)
            bits = bits + (goal - certain if certain > 0 else bits) + _GUARD_BITS
        assert contact_force is not None
        return contact_force

    def hats(
        self, p: fmpq, bits: int, names: tuple[str, ...] = VARIABLES
    ) -> tuple[dict[str, arb], dict[str, arb], bool]:
        """The slow and the fast part of the named hats at p, and whether the fast one is only a ball around 0."""
        beta, small = self.model.beta, self.model.scaled_epsilon
        slow = slow_part(beta, small, p, names, bits)
        with working_bits(bits + 64 + 2 * int(small.height_bits())):
            factor = self.coefficient(bits)
            slow = {name: factor * value for name, value in slow.items()}
            if self.state is None:
                return slow, {name: arb(0) for name in names}, False
            bounds = fast_bound_at(self.state, p)
            negligible = all(
                bounds[name] < (slow[name].abs_lower() + self._mean(name, p)) * arb(2) ** -(bits - _NEGLIGIBLE_BITS)
                for name in names
            )
            if negligible or small < LEAST_EPSILON_OF_QUADRATURE:
                return slow, {name: add_remainder(arb(0), bounds[name]) for name in names}, True
            return slow, fast_part(self.state, p, names, bits), False

    def hats_at(self, place: fmpq, bits: int) -> dict[str, arb]:
        """All hats at T: by the power series about the state where that costs less, else by the two parts."""
        assert self.state is not None
        since = place - self.state.time
        if series_work(self.state, since) <= _WORK_OF_SERIES:
            return carried(self.state, since, bits)
        slow, fast, _ = self.hats(-place * self.model.scaled_epsilon, bits)
        with working_bits(self._bits(bits)):
            return {name: slow[name] + fast[name] for name in VARIABLES}

    def _mean(self, name: str, p: fmpq) -> arb:
        """The size of the variable on the trivial solution."""
        mean = abs(self.model.mean_force * self.model.sigma**2)
        return arb({"b": abs(p) * mean, "V": fmpq(0)}.get(name, mean))

    def coefficient(self, bits: int) -> arb:
        """C, the coefficient of F_beta."""
        if self.state is not None:
            return slow_coefficient(self.state, bits)
        assert self.c1 is not None
        beta = arb(self.model.beta)
        return self.c1 * arb(self.model.sigma) ** (2 + beta) * arb(self.model.scaled_epsilon) ** beta

    def _by_series(self, time: fmpq, digits: int, bits: int) -> CompliantForce:
        """All variables at one time by the power series about the state."""
        assert self.state is not None
        hats = carried(self.state, self._since(time), bits)
        return self._in_units_of_the_paper(time, digits, bits, hats, None)

    def _once(self, time: fmpq, digits: int, bits: int) -> CompliantForce:
        """All variables at one time from the slow and the fast part."""
        slow, fast, by_bound = self.hats(self.model.alpha_1 * time, bits)
        with working_bits(self._bits(bits)):
            hats = {name: slow[name] + fast[name] for name in VARIABLES}
        return self._in_units_of_the_paper(time, digits, bits, hats, (slow["force"], fast["force"], by_bound))

    def _bits(self, bits: int) -> int:
        return bits + 64 + 2 * int(self.model.scaled_epsilon.height_bits())

    def _in_units_of_the_paper(
        self, time: fmpq, digits: int, bits: int, hats: dict[str, arb], parts: tuple[arb, arb, bool] | None
    ) -> CompliantForce:
        model = self.model
        small, sigma = model.scaled_epsilon, model.sigma
        mean = model.mean_force * sigma**2
        slow, fast, by_bound = parts or (nonfinite(), nonfinite(), False)
        with working_bits(self._bits(bits)):
            force = (hats["force"] + mean) / sigma**2
            reached = relative_bits(force) >= bits_for_digits(digits)
            values = {
                "force": force,
                "b": (hats["b"] - model.alpha_1 * time * mean) / sigma**2,
                "y": small**2 * (hats["Z"] - hats["force"] - 2 * mean),
                "v": small * hats["V"] / sigma,
                "z": small**2 * (hats["Z"] - mean),
                "slow": (slow + mean) / sigma**2,
                "fast": fast / sigma**2,
            }
        short = {name: shrink_to_bits(value, bits + 16) for name, value in values.items()}
        reason = None if reached else Reason.BUDGET
        return CompliantForce(
            model,
            time,
            **short,
            fast_by_bound=by_bound,
            digits=digits,
            reached=reached,
            reason=reason,
            by_series=parts is None,
        )


def contact_motion(model: CompliantModel, start: CompliantState | SlowMotions) -> ContactMotion:
    """The contact phase from a state, or on the slow manifold."""
    if isinstance(start, SlowMotions):
        return ContactMotion(model, None, start.c1)
    return ContactMotion(model, deviation(model, start), None)
