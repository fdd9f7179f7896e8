"""The model system of a run, from the paper: its states, equations and events in each phase (run_certificate.md, 1).

Units: T = t/ε, ' = d/dT, Y = y/ε², V = v/ε, Z = z/ε². Nothing of it is read from a certificate but the numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from intervals import Box, Interval, Numbers, add
from limits import require
from reading import entries, rational

LONGEST = 400  # characters of a number of the scene
PAIRS, DEGREE, COEFFICIENT = 2_000, 40, 4_000  # of a product: pairs of terms, degree, bits of a coefficient
MODEL = ("alpha_1", "alpha_2", "beta", "damping", "k_1", "k_2")
BY_EFFECT: dict[str, tuple[str, ...]] = {
    "compliant_contact": (),
    "lift_off": (),
    "tangential_motion": ("a", "k_plus"),
    "stick": ("k_minus", "p_minus"),
    "two_way_coupling": ("chi",),
}  # the parameters that each effect brings


class Polynomial(dict[tuple[str, ...], Fraction]):
    """A polynomial of named states: {(name, ...): coefficient}."""

    def __add__(self, other: Polynomial) -> Polynomial:
        total = Polynomial(self)
        for key, value in other.items():
            total.take(key, value)
        return total

    def __mul__(self, other: Polynomial) -> Polynomial:
        require(len(self) * len(other) <= PAIRS, "a product of two polynomials has too many terms")
        total = Polynomial()
        for left, a in self.items():
            for right, b in other.items():
                total.take(tuple(sorted(left + right)), a * b)
        return total

    def take(self, key: tuple[str, ...], value: Fraction) -> None:
        """Add a term to this one."""
        total = self.get(key, Fraction(0)) + value
        bits = max(total.numerator.bit_length(), total.denominator.bit_length())
        require(len(key) <= DEGREE and bits <= COEFFICIENT, "a polynomial has too high a degree, or too long a number")
        if total:
            self[key] = total
        else:
            self.pop(key, None)

    def __neg__(self) -> Polynomial:
        return Polynomial({key: -value for key, value in self.items()})

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def by(self, name: str) -> Polynomial:
        """The partial derivative."""
        total = Polynomial()
        for key, value in self.items():
            if name in key:
                at = key.index(name)
                total.take(key[:at] + key[at + 1 :], value * key.count(name))
        return total

    def on(self, box: Mapping[str, Interval], numbers: Numbers) -> Interval:
        """An enclosure on a box."""
        total = (0, 0)
        for key, value in self.items():
            total = add(total, numbers.term(value, [box[name] for name in key]))
        return total


def number(value: Fraction | int) -> Polynomial:
    """A constant."""
    return Polynomial({(): Fraction(value)} if value else {})


def state(name: str) -> Polynomial:
    """A state."""
    return Polynomial({(name,): Fraction(1)})


def short(value: Any) -> Fraction:
    """A rational number that is not long."""
    require(
        isinstance(value, str) and len(value) <= LONGEST, f"a number of the scene has more than {LONGEST} characters"
    )
    return rational(value)


def read_numbers(value: Any, name: str, *keys: str) -> dict[str, Fraction]:
    """Rational numbers by their names."""
    return dict(zip(keys, map(short, entries(value, name, *keys)), strict=True))


class Scene:
    """What is simulated: effects, ε, the end of the time, parameters ``of`` the system, the start; all of it exact."""

    def __init__(self, effects: Any, epsilon: Any, until: Any, parameters: Any, start: Any) -> None:
        known = isinstance(effects, list) and all(isinstance(name, str) and name in BY_EFFECT for name in effects)
        require(known and sorted(set(effects)) == effects, "the effects are not some of those known, in order")
        require("compliant_contact" in effects, "the contact is not compliant")
        self.slides, self.sticks = "tangential_motion" in effects, "stick" in effects
        self.lifts, self.coupled = "lift_off" in effects, "two_way_coupling" in effects
        require(self.slides or not self.sticks, "stick without tangential motion")
        self.effects, self.epsilon, self.until = effects, short(epsilon), short(until)
        names = [*MODEL, *(name for effect in effects for name in BY_EFFECT[effect])]
        self.of = read_numbers(parameters, "the parameters", *names)
        self.start = read_numbers(start, "the start", *"bpvyz", *("u" * self.slides))
        require(self.epsilon > 0 and self.until > 0, "ε or the time is not positive")
        require(min(self.of["k_1"], self.of["k_2"], self.of["damping"]) > 0, "a stiffness or the damping is not > 0")
        if self.sticks:  # then friction holds a contact at rest whatever its force is (section 1)
            held = self.of["k_plus"] < 0 < self.of["k_minus"] and self.of["a"] == 0
            require(held, "k_plus < 0 < k_minus and a = 0 do not hold: friction may end a stick")
        require(
            self.start["z"] > self.start["y"] and self.start.get("u", 1) > 0, "the start is not in contact and slip"
        )

    def first_box(self, numbers: Numbers) -> Box:
        """The start in units of ε."""
        e, at = self.epsilon, self.start
        exact = {"Y": at["y"] / e**2, "V": at["v"] / e, "Z": at["z"] / e**2, "T": Fraction(0)}
        exact |= {name: value for name, value in at.items() if name not in "yvz"}
        return {name: numbers.interval(value) for name, value in exact.items()}

    def system(self, phase: str) -> System:
        """The equations of a phase."""
        return System(self, phase)

    def begin(self, box: Box, numbers: Numbers) -> tuple[str, str, int]:  # noqa: ARG002
        """The first phase, the event whose function is 0 where it begins, and which of its derivatives is not."""
        return "slip", "", 0

    def after(self, event: str, box: Box, numbers: Numbers) -> tuple[str, str, int]:  # noqa: ARG002
        """The same of the phase after an event, where the states lie in ``box``."""
        if event == "stick":
            box["u"] = (0, 0)
        u = box.get("u", (1, 1))
        if event == "lift-off":
            return "flight", "touch-down", 1
        if event == "stick":
            return "stick", "", 0
        if u[0] > 0:
            return "slip", "lift-off", 1
        require(self.sticks and (u[1] < 0 or u == (0, 0)), "the direction of slip at touch-down is not certain")
        return ("stick" if u == (0, 0) else "reverse slip"), "lift-off", 1

    def words(self) -> str:
        """The scene in the statement."""
        lists = [", ".join(f"{name} = {value}" for name, value in sorted(of.items())) for of in (self.of, self.start)]
        return f"the model system with {', '.join(self.effects)}, ε = {self.epsilon}, {lists[0]}, from {lists[1]}"

    def seen(self) -> list[str]:
        """What is seen to hold of the effects that are left out (left_out_effects.md)."""
        signs = ["λ_N > 0"] * (not self.lifts) + ["u > 0 in contact"] * (self.slides and not self.sticks)
        return [f"{sign} all along, as leaving an effect out assumes" for sign in signs]


def along(function: Polynomial, rates: Mapping[str, Polynomial]) -> Polynomial:
    """The derivative along the flow."""
    total = Polynomial()
    for name in sorted({name for key in function for name in key}):
        total += function.by(name) * rates[name]
    return total


class Event:
    """A function that is positive in a phase, and its derivatives along the flow.

    ``form``: the signs, where it is a sum of ± states.
    """

    def __init__(self, function: Polynomial, rates: Mapping[str, Polynomial]) -> None:
        self.function, self.rates, self.rate = function, rates, along(function, rates)
        linear = all(len(key) == 1 and abs(value) == 1 for key, value in function.items())
        self.form = {key[0]: int(value) for key, value in function.items()} if linear else {}

    @cached_property
    def curvature(self) -> Polynomial:
        """The second derivative."""
        return along(self.rate, self.rates)


class System:
    """The equations of one phase (paper, eqs. compl1, compl2, modelsys1, lambda+ to newex5), and its events."""

    def __init__(self, scene: Scene, phase: str) -> None:
        c, eps, self.phase = scene.of, number(scene.epsilon), phase
        contact = phase != "flight"
        self.force = number(c["k_2"] * contact) * (state("Z") - state("Y"))
        self.p = state("p") if scene.coupled else number(scene.start["p"]) + eps * number(c["alpha_1"]) * state("T")
        share = (
            c["k_minus"] / (c["k_minus"] - c["k_plus"]) if phase == "stick" else Fraction(phase == "slip")
        )  # eq. cdot
        forward, backward = number(share) * self.force, number(1 - share) * self.force
        self.acceleration = state("b") + self.p * forward + number(c.get("p_minus", 0)) * backward
        rates = {
            "b": eps * (number(c["alpha_2"]) - number(c["beta"] * c["alpha_1"]) * forward),
            "Y": state("V"),
            "V": self.acceleration,
            "Z": number(1 / c["damping"]) * (number(-c["k_1"]) * state("Z") - self.force),
        }
        if scene.coupled:
            rates["p"] = eps * (number(c["alpha_1"]) + number(c["chi"]) * state("b"))
        if scene.slides and phase != "stick":
            rates["u"] = eps * (number(c["a"]) + number(c["k_plus"]) * forward + number(c.get("k_minus", 0)) * backward)
        if any("T" in key for rate in rates.values() for key in rate):
            rates["T"] = number(1)
        self.rates, self.names = rates, sorted(rates)
        self.jacobian = [[rates[i].by(j) for j in self.names] for i in self.names]
        gap = state("Y") - state("Z")
        functions = {"lift-off": -gap} if contact else {"touch-down": gap}
        if contact and "u" in rates:
            functions["stick"] = state("u") if phase == "slip" else -state("u")
        self.events = {name: Event(function, rates) for name, function in functions.items()}
        allowed = {"lift-off": scene.lifts, "touch-down": scene.lifts, "stick": scene.sticks}
        self.endings = [name for name in self.events if allowed[name]]  # the others belong to effects that are left out

    def entered(self, box: Box, numbers: Numbers) -> Box:  # noqa: ARG002
        """The states where the phase begins."""
        return box
