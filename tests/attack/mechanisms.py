"""All G-spots of random small mechanisms, their Case and beta, against sympy and dense sampling."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
import sympy
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import holds, to_fraction
from attack.reference_mechanism import Body, Plane
from flint import arb, fmpq

from gspot_verified import Outcome, classify_all
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.spots.classify import Classification

_NUMBERS = ("alpha_1", "alpha_2", "alpha_3", "a", "A", "B", "C")
_SLACK = mpmath.mpf(10) ** -18


def _eighth(random: Random, low: float, high: float) -> Fraction:
    return Fraction(round(random.uniform(low, high) * 8), 8)


def drawn_body(random: Random) -> tuple[dict[str, Any], Fraction]:
    """A body with a contour, a spring, perhaps an eccentric centre and a second mass on its arm; its slip velocity."""
    values: dict[str, Any] = {
        "mu": abs(_eighth(random, 0.3, 4)) or Fraction(1), "J": abs(_eighth(random, 0.1, 1)) + Fraction(1, 8),
        "g": _eighth(random, -0.2, 1.5), "c": random.choice((Fraction(0), _eighth(random, -0.3, 0.3))),
        "s": random.choice((Fraction(0), _eighth(random, -0.3, 0.3))),
        "tau": _eighth(random, -2, 2), "l": abs(_eighth(random, 0.3, 1.5)) + Fraction(1, 8),
        "k": random.choice((Fraction(0), _eighth(random, 0, 2))),
        "d": random.choice((Fraction(0), _eighth(random, 0, 2))),
        "q": random.choice((Fraction(0), _eighth(random, -1, 1))), "w": random.choice((0, 1, 2, 3)),
        "push": random.choice((Fraction(0), _eighth(random, -1, 1))),
    }  # fmt: skip
    return values, _eighth(random, 0.5, 3)


def attack(random: Random) -> Attack:
    """All spots of such a body."""
    values, slip = drawn_body(random)
    seed = random.getrandbits(32)
    periodic = random.random() < 0.6
    if periodic:
        values["k"] = Fraction(0)
    text = file_of(values, slip)
    return Attack(f"classify_all(parse_mechanism('''{text}'''))", lambda: _judged(text, values, slip, Random(seed)))


def _formulas(values: dict[str, Any]) -> dict[str, str]:
    number = {name: f"({value})" for name, value in values.items()}
    kinetic = "(X_dot^2 + H_dot^2 + J*th_dot^2)/2 + c*H_dot*th_dot*cos(th) + s*X_dot*th_dot*sin(th)"
    found = {
        "kinetic": kinetic, "potential": "g*H + k*(th - 1)^2/2", "X": "push", "H": "0", "th": "tau - d*th_dot",
        "x": "X + l*cos(th)", "y": "H - l*sin(th) + q*cos(w*th)/4", "mu": "mu",
    }  # fmt: skip
    for name, value in number.items():
        found = {key: _put(text, name, value) for key, text in found.items()}
    return found


def _put(text: str, name: str, value: str) -> str:
    return re.sub(rf"(?<![A-Za-z_]){name}(?![A-Za-z_])", value, text)


def file_of(values: dict[str, Any], slip: Fraction, parameters: Mapping[str, str] | None = None) -> str:
    """The mechanism's file; a value may be the name of a parameter."""
    f = _formulas(values)
    given = [f'{name} = "{value}"' for name, value in (parameters or {}).items()]
    return "\n".join([
        "format = 1", 'name = "attack"', *(["[parameters]", *given] if given else []), "[energies]",
        'coordinates = ["X", "H", "th"]', f'kinetic = "{f["kinetic"]}"',
        f'potential = "{f["potential"]}"', f'forces = ["{f["X"]}", "{f["H"]}", "{f["th"]}"]', "[contact]",
        f'x = "{f["x"]}"', f'y = "{f["y"]}"', f'mu = "{f["mu"]}"', "[g_spot]", "search = true",
        'fixed = ["X", "X_dot"]', "[g_spot.point]", "X = 0", f'X_dot = "{slip}"', 'th = "1"', 'th_dot = "1"', "H = 1",
        "H_dot = 1",
    ])  # fmt: skip


def body(values: dict[str, Any]) -> Body:
    """The same mechanism for the reference."""
    q = sympy.symbols("X H th", real=True)
    dq = sympy.symbols("X_dot H_dot th_dot", real=True)
    known = {str(symbol): symbol for symbol in (*q, *dq)}
    f = {
        name: sympy.sympify(text.replace("^", "**"), locals=known, rational=True)
        for name, text in _formulas(values).items()
    }
    return Body(q, dq, f["kinetic"], f["potential"], (f["X"], f["H"], f["th"]), f["x"], f["y"], f["mu"])


def _judged(text: str, values: dict[str, Any], slip: Fraction, random: Random) -> Answer:
    try:
        found = classify_all(parse_mechanism(text), budget=30_000)
    except MechanismError as error:
        return undecided(f"MechanismError: {str(error)[:70]}")
    with mpmath.workdps(40):
        at = mpmath.mpf(slip.numerator) / slip.denominator
        spots, sure = Plane(body(values), (mpmath.mpf(0), at)).spots(random)
    # Where the angle stands outside of sine and cosine its turns differ, and the search has its own region.
    turns = values["k"] == 0
    outcome = found.verdict.outcome
    shown = f"{found}\n  reference: {[{k: mpmath.nstr(v, 12) for k, v in s.items()} for s in spots]}"
    with mpmath.workdps(40):
        trouble = _each_is_one(found.spots, spots, turns)
    if trouble:
        return wrong(f"{trouble}\n{shown}")
    if not sure or not turns:
        return undecided("the reference is not sure") if not sure else undecided("the angle is not periodic: list only")
    if outcome is Outcome.UNDECIDED or found.found.patch is not None:
        return undecided(f"{found.verdict.reason}")
    if len(found.spots) != len(spots):
        return wrong(f"{len(found.spots)} listed, the reference has {len(spots)}\n{shown}")
    return AGREED


def _each_is_one(listed: tuple[Classification, ...], spots: list[dict[str, Any]], turns: bool) -> str:
    """Each of the list is a spot of the reference, with its numbers and its Case; a message where it is not."""
    left = [*spots]
    for each in listed:
        match = [s for s in left if all(_near(getattr(each, name), s[name]) for name in _NUMBERS)]
        if not match:
            if not turns:
                continue
            return f"no spot of the reference has the numbers of {each}"
        left.remove(match[0])
        case = case_of(*(match[0][name] for name in ("alpha_1", "alpha_2", "alpha_3")))
        if each.case is not None and case is not None and each.case != case:
            return f"Case {each.case}, the reference says {case}: {each}"
        beta = match[0]["alpha_3"] / match[0]["alpha_1"] if match[0]["alpha_1"] else None
        if each.beta is not None and beta is not None and not _near(each.beta, beta):
            return f"beta {each.beta}, the reference {mpmath.nstr(beta, 20)}"
    return ""


def _near(value: fmpq | arb, reference: mpmath.mpf) -> bool:
    ball = arb(value) if isinstance(value, fmpq) else value
    if isinstance(value, fmpq):
        exact = to_fraction(value)
        return bool(abs(mpmath.mpf(exact.numerator) / exact.denominator - reference) <= _SLACK * (1 + abs(reference)))
    return holds(ball, reference, _SLACK * (1 + abs(reference)))


def case_of(first: mpmath.mpf, second: mpmath.mpf, third: mpmath.mpf) -> str | None:
    """The paper's three Cases; None next to a border."""
    if min(abs(first), abs(second), abs(third), abs(third - first)) < _SLACK:
        return None
    if first > 0 or third > 0:
        return "none"
    if first < third:
        return "I" if second < 0 else "II"
    return "III" if second < 0 else "none"
