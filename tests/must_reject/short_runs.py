"""Short runs of the model system, written without the package and without the checker: a few steps, rough bounds.

A step is a Taylor polynomial in rational numbers, rounded; its bounds are chosen large enough, and nothing of them is
computed. So a file is made in milliseconds, and one rule that is broken in it is the only one.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import Any

BITS, UNIT, ORDER = 96, 80, 16  # of the checker's numbers; of the coefficients; of the polynomials
FIRST = Fraction(1, 2**60)  # the bounds at the start
PARTS, GROWTH = 4, Fraction(5, 4)  # of a piece: how many, and of the bounds from one node to the next
PAGES = ["invariant_region", "left_out_effects", "run_certificate"]

Lines = list[Any]
States = dict[str, Fraction]


def dyadic(value: Fraction) -> list[int]:
    """[m, e], exactly."""
    return [value.numerator, 1 - value.denominator.bit_length()]


def up(value: Fraction) -> Fraction:
    """The next number of the checker's grid, not below this one."""
    return Fraction(-(-value * 2**BITS // 1), 2**BITS)


class ShortRun:
    """A run from phase to phase. ``lines``: of its file; ``events``: those before; ``clock``: where a step begins."""

    def __init__(
        self, effects: list[str], epsilon: str, parameters: Mapping[str, str], start: Mapping[str, str]
    ) -> None:
        self.effects, self.epsilon, self.parameters, self.given = (
            effects,
            Fraction(epsilon),
            dict(parameters),
            dict(start),
        )
        self.of = {name: Fraction(value) for name, value in parameters.items()}
        at, e = {name: Fraction(value) for name, value in start.items()}, self.epsilon
        self.states = at | {"Y": at["y"] / e**2, "V": at["v"] / e, "Z": at["z"] / e**2, "T": Fraction(0)}
        self.states |= {"y/eps^2": at["y"] / e**2, "v/eps": at["v"] / e, "z/eps^2": at["z"] / e**2}
        self.clock, self.bound = (Fraction(0), Fraction(0)), FIRST
        self.lines: Lines = []
        self.events: list[list[str]] = []

    def names(self, phase: str) -> list[str]:
        """The states of a phase."""
        found = ["V", "Y", "Z", "b"]
        found += ["p"] if "two_way_coupling" in self.effects else ["T"] * (phase != "flight")
        return sorted(found + ["u"] * ("tangential_motion" in self.effects and phase != "stick"))

    def rates(self, phase: str, x: Mapping[str, list[Fraction]], k: int) -> States:
        """The coefficients of τ^k of the right-hand sides (run_certificate.md, section 1)."""
        of, e, zero = self.of, self.epsilon, Fraction(0)
        one = Fraction(k == 0)
        contact = phase != "flight"
        force = [of["k_2"] * contact * (z - y) for z, y in zip(x["Z"], x["Y"], strict=True)]
        minus, plus = of.get("k_minus", zero), of.get("k_plus", zero)
        c = minus / (minus - plus) if phase == "stick" else Fraction(phase == "slip")
        p = x["p"] if "p" in x else [self.states["p"] * (i == 0) + e * of["alpha_1"] * t for i, t in enumerate(x["T"])]
        pushed = c * sum((p[i] * force[k - i] for i in range(k + 1)), zero)
        found = {
            "b": e * (of["alpha_2"] * one - of["beta"] * of["alpha_1"] * c * force[k]),
            "Y": x["V"][k],
            "V": x["b"][k] + pushed + of.get("p_minus", zero) * (1 - c) * force[k],
            "Z": (-of["k_1"] * x["Z"][k] - force[k]) / of["damping"],
            "T": one,
            "p": e * (of["alpha_1"] * one + of.get("chi", zero) * x["b"][k]),
            "u": e * (of.get("a", zero) * one + (plus * c + minus * (1 - c)) * force[k]),
        }
        return {name: found[name] for name in x}

    def step(self, phase: str, h: Fraction, split: bool) -> dict[str, list[Fraction]]:
        """Write one step, and go to its end: the polynomials."""
        names = self.names(phase)
        x = {name: [self.states[name]] for name in {*names, "T"} - ({"T"} if "p" in names else set())}
        for k in range(ORDER):
            for name, rate in self.rates(phase, x, k).items():
                x[name].append(Fraction(round(h * rate / (k + 1) * 2**UNIT), 2**UNIT))
        x = {name: [Fraction(round(v * 2**UNIT), 2**UNIT) for v in x[name]] for name in names}
        n, pieces = len(names), []
        for end, blocks, scale in ([1, -1], [2, n - 2], 2), ([1, 0], [n], 1):
            if split or scale == 1:
                basis = [[scale if i == j == 0 else int(i == j), 0] for i in range(n) for j in range(n)]
                bounds = [up(self.bound * (4 if split else 1) * GROWTH**k) for k in range(PARTS + 1)]
                nodes = [[dyadic(w)] * len(blocks) for w in bounds]
                pieces.append({"basis": basis, "blocks": blocks, "end": end, "nodes": nodes})
                self.bound = bounds[-1]
        coefficients = {name: [int(v * 2**UNIT) for v in c] for name, c in x.items()}
        self.lines.append({"h": dyadic(h), "pieces": pieces, "unit": UNIT, "x": coefficients})
        self.states |= {name: sum(c, Fraction(0)) for name, c in x.items()}
        return x

    def phase(self, phase: str, steps: int, h: str, event: str = "", half: str = "0", split: bool = False) -> None:
        """Write a phase of equal steps; ``event``: its function changes its sign in the last one, where the bracket has
        this half width. ``split``: the first step has two pieces with unlike bases."""
        head: dict[str, Any] = {"bracket": [], "cone": [], "event": event, "phase": phase, "steps": steps}
        self.lines.append(head)
        length = Fraction(h)
        for k in range(steps):
            began = self.clock
            x = self.step(phase, length, split and k == 0)
            self.clock = (began[0] + length, began[1] + length)
            self.states["T"] = sum(self.clock) / 2
        if not event:
            return
        tau = self.zero(x, event)
        left, right = tau - Fraction(half), tau + Fraction(half)
        head["bracket"] = [dyadic(left), dyadic(right)]
        self.clock = (began[0] + left * length, began[1] + right * length)
        self.events.append([event, *(str(time * self.epsilon) for time in self.clock)])
        for name, c in x.items():
            self.states[name] = sum((v * tau**k for k, v in enumerate(c)), Fraction(0))
        self.states |= {"T": sum(self.clock) / 2} | ({"u": Fraction(0)} if event == "stick" else {})
        self.bound = 16 * (self.bound + Fraction(half))

    def zero(self, x: Mapping[str, list[Fraction]], event: str) -> Fraction:
        """Where the function of an event is 0, on the grid."""
        low, high = Fraction(0), Fraction(1)
        for _ in range(40):
            middle = (low + high) / 2
            at = {name: sum((v * middle**k for k, v in enumerate(c)), Fraction(0)) for name, c in x.items()}
            low, high = (middle, high) if self.value(event, at) > 0 else (low, middle)
        return low

    def value(self, event: str, at: States) -> Fraction:
        """The function of an event."""
        if event == "stick":
            return at["u"]
        return (at["Z"] - at["Y"]) * (1 if event == "lift-off" else -1)

    def file(self, end: str = "time", until: str = "") -> Lines:
        """The lines of the certificate."""
        statement = {
            "effects": self.effects, "end": end, "epsilon": str(self.epsilon), "events": self.events, "kind": "run",
            "parameters": self.parameters, "start": self.given, "until": until or str(self.clock[0] * self.epsilon),
        }  # fmt: skip
        header = {"format": "gspot_verified certificate", "hypotheses": PAGES, "statement": statement, "version": 4}
        return copy.deepcopy([header, {"bits": BITS}, *self.lines])


BLOCK = {
    "angles": {}, "coordinates": ["b", "H", "d"], "forces": ["1*d", "-1", "0"],
    "mass_matrix": [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]], "mu": "1/2", "x": "1*b", "y": "1*H",
}  # fmt: skip


class BlockRun(ShortRun):
    """A block that its weight presses down and that a force d pushes, which grows with the time: λ = 1, z = y + ε²."""

    def names(self, phase: str) -> list[str]:  # noqa: ARG002
        return ["b_dot", "d", "d_dot", "v/eps", "y/eps^2", "z/eps^2"]

    def rates(self, phase: str, x: Mapping[str, list[Fraction]], k: int) -> States:
        Y, Z, e, zero = x["y/eps^2"][k], x["z/eps^2"][k], self.epsilon, Fraction(0)
        friction = {"slip": -(Z - Y) / 2, "reverse slip": (Z - Y) / 2, "stick": -x["d"][k]}[phase]
        return {
            "b_dot": e * (x["d"][k] + friction), "d": e * x["d_dot"][k], "d_dot": zero, "T": Fraction(k == 0),
            "v/eps": Z - Y - (k == 0), "y/eps^2": x["v/eps"][k], "z/eps^2": Y - 2 * Z,
        }  # fmt: skip

    def value(self, event: str, at: States) -> Fraction:
        if event == "stick":
            return at["b_dot"]
        return (at["z/eps^2"] - at["y/eps^2"]) / 2 - at["d"]

    def file(self, end: str = "time", until: str = "") -> Lines:
        lines = super().file(end, until)
        lines[0]["statement"] |= {"kind": "run of a mechanism", "mechanism": copy.deepcopy(BLOCK)}
        return lines


@cache
def _flight() -> ShortRun:
    parameters = {"alpha_1": "-1", "alpha_2": "-6", "beta": "1", "damping": "1", "k_1": "1", "k_2": "1"}
    run = ShortRun(
        ["compliant_contact", "lift_off"],
        "1/2",
        parameters,
        {"b": "3", "p": "-1/2", "v": "0", "y": "-1/4", "z": "1/99"},
    )
    run.phase("slip", 4, "1/4", "lift-off", f"1/{2**36}", split=True)
    run.phase("flight", 4, "1/2", "touch-down", f"1/{2**16}")
    run.phase("slip", 1, "1/8")
    return run


@cache
def _stick() -> ShortRun:
    parameters = {
        "a": "0", "alpha_1": "-1", "alpha_2": "-6", "beta": "1", "chi": "1/4", "damping": "1", "k_1": "1", "k_2": "1",
        "k_minus": "2", "k_plus": "-1", "p_minus": "1/2",
    }  # fmt: skip
    effects = ["compliant_contact", "lift_off", "stick", "tangential_motion", "two_way_coupling"]
    run = ShortRun(effects, "1/2", parameters, {"b": "3", "p": "-1/2", "u": "1/8", "v": "0", "y": "-1/4", "z": "0"})
    run.phase("slip", 2, "1/4", "stick", f"1/{2**38}", split=True)
    run.phase("stick", 3, "1/4", "lift-off", f"1/{2**26}")
    run.phase("flight", 4, "1/2", "touch-down", f"1/{2**14}")
    run.phase("stick", 1, "1/8")
    return run


def flight() -> Lines:
    """Lift-off and touch-down, up to a time."""
    return _flight().file()


def cone() -> Lines:
    """The same, and contact for ever."""
    lines = _flight().file(end="for ever")
    lines[-2]["cone"] = ["1/4"]
    return lines


def stick() -> Lines:
    """Stick, lift-off and touch-down at rest, with every effect."""
    return _stick().file()


@cache
def _one() -> ShortRun:
    run = ShortRun(["compliant_contact"], "1/2", _flight().parameters, _flight().given)
    run.phase("slip", 1, "1/8", split=True)
    return run


def one() -> Lines:
    """One step in slip."""
    return _one().file()


@cache
def _block() -> ShortRun:
    effects = ["compliant_contact", "lift_off", "stick", "tangential_motion"]
    start = {"b_dot": "1/16", "d": "0", "d_dot": "1", "v": "0", "y": "-1/2", "z": "-1/4"}
    run = BlockRun(effects, "1/2", {"damping": "1", "k_1": "1", "k_2": "1"}, start)
    run.phase("slip", 1, "1/2", "stick", f"1/{2**40}", split=True)
    run.phase("stick", 2, "1/2", "slip forwards", f"1/{2**30}")
    run.phase("slip", 1, "1/8")
    return run


def block() -> Lines:
    """A mechanism: slip, stick, slip again."""
    return _block().file()
