"""A set of states in contact from which lambda_N grows for as long as the scene slips: an impact without collision.

Proof page: ``proofs/invariant_region.md``, Theorems R1 to R6.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from flint import arb

from gspot_verified.numbers.balls import add_remainder, approximate, current_bits
from gspot_verified.scenes.certified.growth_cone import ContactPoint, GrowthCone, cones, likely_first
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.motions.contact_form import ContactBounds, ContactForm

CLOCK = "T"
_DOUBLINGS = (3, 4, 6, 8, 10, 13, 16, 20, 24, 30, 40)
_ROUNDS = 6  # in which a box is enlarged until it is not left; then nothing is said
_LONGER = 1.5  # by which a time is made longer, so that a bound can hold; any factor is right
_STOP_TRIES = 3  # such times; then nothing is said
_BOXES_TRIED = 6  # of the cones, the likely ones first, against endless work


@dataclass(frozen=True)
class ExponentialGrowth:
    """From the state on lambda_N > 0 grows at least like e^(rate T), T = t/epsilon: as long as the scene slips, which
    it certainly does not any more after the time ``within`` (None: not known); or until lambda_N exceeds ``until``
    times its value at the beginning (None: no such limit), if slip lasts so long."""

    rate: arb
    until: int | None
    within: arb | None = None


Impulse = Callable[[ContactBounds], arb | None]
"""A bound on the integral of λ from bounds on a box; None: there is none."""


class InvariantRegion:
    """The growth cones of one phase in contact. Its structure is read off the equations, and checked.

    :raises NotOfThisForm: the equations are not of the form of :class:`ContactForm`.
    """

    def __init__(self, system: ScaledSystem) -> None:
        self._form = ContactForm(system)

    def growth(self, state: Mapping[str, arb], limited: bool = True) -> ExponentialGrowth | None:
        """What is certain of all states in the ball; None: nothing was shown.

        ``limited``: growth to a multiple of the force is asked for, too, where no other is certain.
        """
        form = self._form
        box = [state[name] for name in form.names]
        force = form.k * (state["Z"] - state["Y"])
        box += [state.get(CLOCK, arb(0)), force]
        if not (force > 0 and box[form.V] <= 0):
            return None
        bounds = form.bounds(box)
        if not bounds.are_finite():
            return None
        kept_cones = [cone for cone in cones(form, ContactPoint.of(form, box), bounds) if cone.is_kept(bounds)]
        if form.constant_load:
            return next(
                (ExponentialGrowth(cone.rate, None) for cone in kept_cones if cone.is_kept_for_ever(bounds)), None
            )
        kept_cones = likely_first(kept_cones, bounds)[:_BOXES_TRIED]
        for cone in kept_cones:
            for i in range(len(bounds.stops)):
                within = self._until_stop(cone, box, bounds, i)
                if within is not None:
                    return ExponentialGrowth(cone.rate, None, within)
        for cone in kept_cones if limited else ():
            times = self._most_times(cone, box)
            if times is not None:
                return ExponentialGrowth(cone.rate, times)
        return None

    def _until_stop(self, cone: GrowthCone, box: list[arb], bounds: ContactBounds, i: int) -> arb | None:
        """Theorem R6: a time by which function i has certainly reached 0, with the cone kept until then."""
        form, first, a = self._form, bounds.stops[i], cone.rate
        if not (form.affine and first > 0 and bounds.stop_pushes[i] < 0):
            return None

        def impulse(over: ContactBounds) -> arb | None:
            push, rate = over.stop_pushes[i], over.stop_rates[i]
            if not (push < 0 and rate.is_finite()):
                return None
            return ((first + rate.max(arb(0)) * time) / -push).upper()

        needed = a * first / -bounds.stop_pushes[i] / box[-1]
        time = ((1 + needed).log() / a).upper()
        for _ in range(_STOP_TRIES):
            time = (time * _LONGER).upper()
            largest = self._kept_until(cone, box, time, arb(0), impulse)
            if largest is None:  # nor is it for longer
                return None
            if box[-1] * ((a * time).exp() - 1) / a > largest:
                return time
        return None

    def _most_times(self, cone: GrowthCone, box: list[arb]) -> int | None:
        """Theorem R5: how many times λ can be seen to grow, among some powers of 2."""
        if not self._holds_until(cone, box, 2 ** _DOUBLINGS[0]):
            return None
        low, high = 0, len(_DOUBLINGS)
        while high - low > 1:
            middle = (low + high) // 2
            if self._holds_until(cone, box, 2 ** _DOUBLINGS[middle]):
                low = middle
            else:
                high = middle
        return 1 << _DOUBLINGS[low]

    def _holds_until(self, cone: GrowthCone, box: list[arb], times: int) -> bool:
        largest = (times * box[-1]).upper()
        time = (arb(times).log() / cone.rate).upper()
        impulse = (largest / cone.rate).upper()
        return self._kept_until(cone, box, time, largest, lambda _: impulse) is not None

    def _kept_until(self, cone: GrowthCone, box: list[arb], time: arb, largest: arb, impulse: Impulse) -> arb | None:
        """Section 5: a box that is not left for a time, with the cone kept on it, by the bound on ∫λ that is returned.

        ``largest``: the range of λ, where it matters.
        """
        form = self._form
        tried = [add_remainder(side, _little(side)) for side in box]
        tried[-2:] = box[-2] + _from_zero(time), _from_zero(largest)
        for _ in range(_ROUNDS):
            bounds = form.bounds(tried)
            # Where the cone is not kept on this box, it will hardly be on a larger one: the work ends.
            total = impulse(bounds) if bounds.are_finite() and cone.is_kept(bounds) else None
            if total is None or not total.is_finite():
                return None
            spent, pushed = _from_zero(time), _from_zero(total)
            needed = list(box)
            for i, rate, push in zip(form.slow, bounds.rates, bounds.pushes, strict=True):
                needed[i] = box[i] + spent * rate + pushed * push
            gained = (abs(bounds.still) * time + abs(bounds.slope) * total).upper()
            needed[form.V] = box[form.V] - _from_zero(gained)
            speed = (abs(box[form.V]) + gained).upper()
            needed[form.Y] = box[form.Y] - _from_zero((speed * time).upper())
            moving = [i for i in range(form.size) if i != form.Z]
            if all(tried[i].contains_interior(needed[i]) for i in moving):
                return total
            for i in moving:
                tried[i] = add_remainder(needed[i], arb(approximate(needed[i].rad()) / 4) + _little(needed[i]))
        return None


def _little(side: arb) -> arb:
    """A width that hardly matters: it makes room where a side is a point."""
    return (1 + abs(side)) * arb((1, -current_bits() // 2))


def _from_zero(end: arb) -> arb:
    """The numbers from 0 to ``end``."""
    return arb(0).union(end)
