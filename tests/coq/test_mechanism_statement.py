"""The mechanism's equations in proofs/coq/StatementCompliant.v and StatementFlight.v are those of the library.

Each formula is read out of the text and evaluated at exact points; each single change of a number, a sign, an operation
or a name must be noticed. Two routes to modelsys1 to modelsys5: the ledger's polynomials, and the rates that runs
integrate.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from coq.coq_terms import Applied, evaluate_term, mutations
from coq.mechanism_terms import (
    LAW,
    POINTS,
    UNREADABLE,
    Point,
    body,
    number,
    only_the_text_holds,
    rates_in_a_run,
    renamed,
    scaled_state,
    terms_of,
)
from flint import fmpq, fmpq_series

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state, deviation
from gspot_verified.paper.section_4.section_4_trivial import ALGEBRA, in_model_system
from gspot_verified.scenes.equations.terms import FLIGHT, SLIP

MODEL_AT = body("model_at")
CLAUSE = re.compile(r"is_derive (?:(\w+)|\(fun s => (.+?)\)) t (.+)")
HERE = object()
"""The time t at which the equations are stated."""


def residuals(text: str, point: Point, law: str = LAW) -> list[fmpq]:
    """Of each clause, where the motion has this state and these rates: the derivative less what it should be."""

    def motion(name: str, with_rate: bool) -> Applied:
        def value(place: object) -> Any:
            assert place is HERE
            return fmpq_series([point[name], point[f"{name}'"]], prec=2) if with_rate else point[name]

        return Applied(1, value)

    def force(eps: fmpq, y: fmpq, z: fmpq) -> Any:
        return evaluate_term(law, {"eps": eps, "y": y, "z": z})

    known = {name: point[name] for name in ("a1", "a2", "a3", "eps")}
    at_t = known | {name: motion(name, False) for name in "pbyvz"} | {"t": HERE, "force": Applied(3, force)}
    along = known | {name: motion(name, True) for name in "pbyvz"} | {"s": HERE}
    found = []
    for clause in text.split(" /\\ "):
        match = CLAUSE.fullmatch(clause)
        assert match
        moved = evaluate_term(f"{match[1]} s" if match[1] else match[2], along)
        found.append(fmpq(moved[1]) - fmpq(evaluate_term(match[3], at_t)))
    return found


def in_the_ledger(point: Point) -> list[fmpq]:
    """The same by the ledger's polynomials, on a motion that is linear in t and has this state at t = 0."""
    time = ALGEBRA.symbols["t"]
    motion = {name: ALGEBRA.constant(point[name]) + point[f"{name}'"] * time for name in "pbyvz"}
    numbers = {"t": fmpq(0), "epsilon": point["eps"], "alpha1": point["a1"], "alpha3": point["a3"]}
    numbers["c"] = point["a2"] / (point["a1"] - point["a3"])
    constants = {name: ALGEBRA.constant(value) for name, value in numbers.items()}
    start, *found = [
        fmpq(ALGEBRA.substitute(value, constants).leading_coefficient()) for value in in_model_system(motion)
    ]
    assert start == point["p"]
    divisors = (fmpq(1), point["eps"] ** 2, fmpq(1), point["eps"] ** 2, fmpq(1))
    return [value / divisor for value, divisor in zip(found, divisors, strict=True)]


def in_a_run(point: Point) -> list[fmpq]:
    """The same by the rates of a run; the last equation is stated for eps z."""
    rates = rates_in_a_run(point)
    return [(point["eps"] if name == "z" else 1) * (point[f"{name}'"] - rates[name]) for name in "pbyvz"]


ROUTES: list[Callable[[Point], list[fmpq]]] = [in_the_ledger, in_a_run]
EXPECTED = {route: [route(point) for point in POINTS] for route in ROUTES}


def same_equations(text: str, route: Callable[[Point], list[fmpq]], law: str = LAW) -> bool:
    """Whether the text states the equations of a route."""
    try:
        return all(residuals(text, point, law) == found for point, found in zip(POINTS, EXPECTED[route], strict=True))
    except UNREADABLE:
        return False


@pytest.mark.parametrize("route", ROUTES)
def test_the_equations_of_the_mechanism_are_those_of_the_library(route: Callable[[Point], list[fmpq]]) -> None:
    assert len(MODEL_AT.split(" /\\ ")) == 5
    assert same_equations(MODEL_AT, route)


@pytest.mark.parametrize("route", ROUTES)
def test_every_change_of_an_equation_is_noticed(route: Callable[[Point], list[fmpq]]) -> None:
    clauses = MODEL_AT.split(" /\\ ")
    changed = [*mutations(MODEL_AT), *renamed(MODEL_AT)]
    changed += [" /\\ ".join(clauses[:i] + clauses[i + 1 :]) for i in range(5)]
    assert len(changed) > 150
    assert [text for text in changed if same_equations(text, route)] == []


@pytest.mark.parametrize("route", ROUTES)
def test_every_change_of_the_law_of_force_is_noticed(route: Callable[[Point], list[fmpq]]) -> None:
    changed = [*mutations(LAW), *renamed(LAW, ("eps", "y", "z"))]
    assert [text for text in changed if same_equations(MODEL_AT, route, text)] == []


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("eps ^ 2", "eps"),
        ("a2 - a3", "a2 + a3"),
        ("b t + p t", "b t - p t"),
        ("- z t -", "- z t +"),
        ("(- z t", "(z t"),
        ("eps * z s", "z s"),
    ],
)
def test_the_changes_that_once_passed(before: str, after: str) -> None:
    text = MODEL_AT.replace(before, after)
    assert text != MODEL_AT
    assert not any(same_equations(text, route) for route in ROUTES)


CONTACT = re.compile(r"if Rlt_dec (\w+) (\w+) then (.+) else (.+)")


def same_force(text: str) -> bool:
    """compl2: contact, and its force, exactly where the library has it; at y = z too."""
    match = CONTACT.fullmatch(text)
    if match is None:
        return False
    for point in POINTS:
        for first, second in ((point["y"], point["z"]), (point["z"], point["y"]), (point["y"], point["y"])):
            here = point | {"y": first, "z": second}
            try:
                compliant_state(here["p"], here["b"], first, here["v"], second)
                phase = SLIP
            except ValueError:
                phase = FLIGHT
            names = {name: here[name] for name in ("eps", "y", "z")}
            try:
                closed = evaluate_term(match[1], names) < evaluate_term(match[2], names)
                value = fmpq(evaluate_term(match[3 if closed else 4], names))
            except UNREADABLE:
                return False
            if value != number(terms_of(here, phase).force, scaled_state(here)) or closed is not (phase == SLIP):
                return False
    return True


def test_the_contact_force() -> None:
    text = body("contact_force")
    assert same_force(text)
    changed = [*mutations(text), *renamed(text, ("eps", "y", "z")), text.replace("Rlt_dec", "Rle_dec")]
    assert [other for other in changed if same_force(other)] == []


def test_the_trivial_part_of_b_in_a_slow_motion() -> None:
    """b less its trivial part at the time -x, against the deviation in the normal form, which is sigma^2 times it."""
    found = re.search(
        r"is_lim \(fun x => \(b \(- x\) - (.+?)\) / Rpower \(x / eps\) \((.+?)\)\) p_infty C", body("slow_motion")
    )
    assert found

    def trivial(point: Point) -> fmpq:
        model = compliant_model(epsilon=point["eps"], alpha_1=point["a1"], alpha_2=point["a2"], alpha_3=point["a3"])
        state = compliant_state(-point["a1"] * point["x"], point["b"], point["y"], point["v"], point["y"] + 1)
        return point["b"] - deviation(model, state).b / model.sigma**2

    places = [point | {"x": fmpq(5, 3) + k} for k, point in enumerate(POINTS)]
    only_the_text_holds(found[1], trivial, places)
    only_the_text_holds(found[2], lambda point: point["a3"] / point["a1"], places)
