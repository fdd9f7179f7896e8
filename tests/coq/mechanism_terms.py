"""The formulas of proofs/coq/StatementCompliant.v and StatementFlight.v at exact points, beside the library's rates."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from functools import cache

from coq.coq_terms import Applied, evaluate_term, mutations, statement
from flint import fmpq

from gspot_verified.functions.derivative import partial_derivative
from gspot_verified.functions.expressions import Constant, Expression, Product, Sum, Variable
from gspot_verified.scenes.effects.compliant_contact import EFFECT
from gspot_verified.scenes.effects.model import MODEL
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.terms import SLIP

UNREADABLE = (AssertionError, ValueError, TypeError, ZeroDivisionError, KeyError, AttributeError)
NAMES = ("a1", "a2", "a3", "eps", "p", "b", "y", "v", "z")
STATES = ("b", "Y", "V", "Z")
Point = dict[str, fmpq]


def points(number: int) -> list[Point]:
    """Values of the parameters, of a state and of its rates, all different and not 0: chosen once and for all."""
    choice = random.Random(20260)
    found = []
    for _ in range(number):
        sizes = choice.sample(range(1, 90), 14)
        point = {name: fmpq(size, 7) for name, size in zip([*NAMES, *(f"{n}'" for n in "pbyvz")], sizes, strict=True)}
        for name in point:
            if name in ("a1", "a3") or (name != "eps" and choice.random() < 0.5):
                point[name] = -point[name]
        found.append(point)
    return found


POINTS = points(6)


def renamed(text: str, names: tuple[str, ...] = NAMES) -> list[str]:
    """The text with one of the names, at one place, replaced by another one."""
    return [
        text[: match.start()] + other + text[match.end() :]
        for match in re.finditer(rf"\b({'|'.join(names)})\b", text)
        for other in names
        if other != match[0]
    ]


@cache
def body(name: str) -> str:
    """What stands after := in a definition, up to its end."""
    return statement(name).partition(":= ")[2].partition(". Definition ")[0]


LAW = body("linear_force")


def number(node: Expression, values: list[fmpq]) -> fmpq:
    """The value of an expression of sums and products."""
    if isinstance(node, Sum):
        return sum((number(term, values) for term in node.terms), fmpq(0))
    if isinstance(node, Product):
        return number(node.left, values) * number(node.right, values)
    assert isinstance(node, Constant | Variable)
    return fmpq(node.value) if isinstance(node, Constant) else values[node.index]


def terms_of(point: Point, phase: str = SLIP) -> ModelTerms:
    """What the equations of a run are written with, at these parameters; p at the clock 0 is the point's."""
    parameters = EFFECT.parameters | {
        "alpha_1": point["a1"],
        "alpha_2": point["a2"],
        "beta": point["a3"] / point["a1"],
    }
    return ModelTerms(phase, STATES, point["eps"], parameters, point["p"])


def scaled_state(point: Point) -> list[fmpq]:
    """b, Y = y/eps^2, V = v/eps, Z = z/eps^2 and the clock 0."""
    eps = point["eps"]
    return [point["b"], point["y"] / eps**2, point["v"] / eps, point["z"] / eps**2, fmpq(0)]


def rates_in_a_run(point: Point) -> Point:
    """dp/dt, db/dt, dy/dt, dv/dt, dz/dt by the rates of a run, which are in the time T = t/eps."""
    eps, terms, state = point["eps"], terms_of(point), scaled_state(point)
    assert EFFECT.states is not None
    rates = MODEL.rates(terms) | EFFECT.states.rates(terms)
    b, y, v, z = (number(rates[name], state) for name in STATES)
    p = number(partial_derivative(terms.p, len(STATES), len(STATES) + 1), state)
    return {"p": p / eps, "b": b / eps, "y": eps * y, "v": v, "z": eps * z}


def holds_at(text: str, expected: Callable[[Point], fmpq], places: list[Point], **more: Applied) -> bool:
    """Whether a formula in the names of a point has the library's value at all of them."""
    try:
        return all(evaluate_term(text, point | more) == expected(point) for point in places)
    except UNREADABLE:
        return False


def only_the_text_holds(text: str, expected: Callable[[Point], fmpq], places: list[Point]) -> None:
    names = tuple(name for name in places[0] if re.search(rf"\b{name}\b", text))
    assert holds_at(text, expected, places)
    changed = [*mutations(text), *renamed(text, names)]
    assert [other for other in changed if holds_at(other, expected, places)] == []
