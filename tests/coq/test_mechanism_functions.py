"""Functions of the mechanism's state in proofs/coq/StatementCompliant.v and StatementFlight.v are the library's.

Each formula is read out of the text and evaluated; each single change of it must be noticed.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any

import pytest
from coq.coq_terms import Applied, evaluate_term, mutations, statement
from coq.mechanism_terms import (
    LAW,
    NAMES,
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
from flint import arb, fmpq, fmpq_series

from gspot_verified import evaluate
from gspot_verified.compliant.model.flight import ContactState, Flight
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.numbers.balls import working_bits

HERE = object()
"""The time of lift-off."""


def normal_form() -> list[tuple[Point, ContactState]]:
    """Points with a1 = -1, and each as a state of a flight."""
    found = []
    for point in POINTS:
        here = point | {"a1": fmpq(-1)}
        state = scaled_state(here)
        force = state[3] - state[1]
        balls = [arb(value) for value in (here["p"], here["b"], state[2], state[1], force)]
        found.append((here, ContactState(-here["a3"], here["eps"], here["a2"], *balls)))
    return found


def test_the_force_rate() -> None:
    places = [point for point, _ in normal_form()]

    def rate(point: Point) -> fmpq:
        state = scaled_state(point)
        return -2 * (state[3] - state[1]) - state[1] - state[2]

    with working_bits(200):
        assert all((state.force_rate - arb(rate(point))).contains(0) for point, state in normal_form())
    only_the_text_holds(body("force_rate"), rate, places)


def test_the_rate_at_lift_off_and_the_deceleration() -> None:
    places = [point for point, _ in normal_form()]

    def rate(point: Point) -> fmpq:
        _, height, speed, depth, _ = scaled_state(point)
        with working_bits(200):
            zero = arb(0)
            start = ContactState(-point["a3"], point["eps"], point["a2"], zero, zero, arb(speed), arb(depth), zero)
            assert (Flight(start).gap_rate(zero) - arb(speed + depth)).contains(0)
        assert height != depth
        return point["eps"] * (speed + depth)

    only_the_text_holds(body("separation_rate"), rate, places)
    law = Applied(3, lambda eps, y, z: evaluate_term(LAW, {"eps": eps, "y": y, "z": z}))
    text = body("deceleration")
    expected = [-rates_in_a_run(point)["v"] for point in POINTS]

    def same(candidate: str) -> bool:
        try:
            found = [evaluate_term(candidate, point | {"linear_force": law}) for point in POINTS]
        except UNREADABLE:
            return False
        return found == expected

    assert same(text)
    assert [other for other in [*mutations(text), *renamed(text, ("eps", "p", "b", "y", "z"))] if same(other)] == []


ORDERS = ("force_excess", "force_excess1", "force_excess2", "force_excess3")
FIRST = Applied(
    4, lambda *values: evaluate_term(body(ORDERS[1]), dict(zip(("eps", "y", "v", "z"), values, strict=True)))
)


def derivatives_of_the_force(order: int, text: str) -> bool:
    """Whether a text is the force less its mean (order 0), or the derivative of the one before along a run."""
    for point in POINTS:
        names: dict[str, Any] = {name: point[name] for name in NAMES} | {ORDERS[1]: FIRST}
        rates = rates_in_a_run(point)
        motion = {name: fmpq_series([point[name], rate], prec=2) for name, rate in rates.items()}
        if order:
            should = fmpq(evaluate_term(body(ORDERS[order - 1]), names | motion)[1])
        else:
            force = contact_force(alpha_1=point["a1"], alpha_2=-abs(point["a2"]), alpha_3=point["a3"])
            mean = force.mean * (1 if point["a2"] < 0 else -1)
            should = number(terms_of(point).force, scaled_state(point)) - mean
        try:
            if fmpq(evaluate_term(text, names)) != should:
                return False
        except UNREADABLE:
            return False
    return True


@pytest.mark.parametrize("order", range(4))
def test_the_derivatives_of_the_force_in_contact(order: int) -> None:
    text = body(ORDERS[order])
    assert derivatives_of_the_force(order, text)
    changed = [*mutations(text.replace(ORDERS[1], "FIRST")), *renamed(text)]
    changed = [other.replace("FIRST", ORDERS[1]) for other in changed]
    assert [other for other in changed if derivatives_of_the_force(order, other)] == []


def in_flight(name: str, text: str) -> bool:
    """Whether b, v or y a time u after lift-off is what the library's flight has at T = u/eps."""
    for u, (point, _) in enumerate(normal_form(), start=2):
        names: dict[str, Any] = {"a2": point["a2"], "u": u, "t0": HERE}
        names |= {other: Applied(1, lambda _, value=point[other]: value) for other in "bvy"}
        try:
            stated = fmpq(evaluate_term(text, names))
        except UNREADABLE:
            return False
        with working_bits(200):
            state, eps = scaled_state(point), arb(point["eps"])
            balls = [arb(value) for value in (point["p"], point["b"], state[2], state[1], fmpq(0))]
            flight, later = Flight(ContactState(-point["a3"], point["eps"], point["a2"], *balls)), arb(u) / eps
            landed = flight.landed(later)
            height = flight.gap(later) + landed.Y  # the gap is y - z, and landed.Y is z there
            value = {"b": landed.b, "v": landed.V * eps, "y": height * eps**2}[name]
            if not (value - arb(stated)).contains(0) or not value.rad() < 1e-20:
                return False
    return True


def test_the_motion_in_flight() -> None:
    clauses = body("in_flight").removeprefix("let u := t - t0 in ").split(" /\\ ")
    sides = dict(clause.split(" = ") for clause in clauses)
    assert list(sides) == ["b t", "v t", "y t", "z t"]
    assert sides["z t"] == "z t0 * exp (- u / eps)"
    for name in "bvy":
        text = sides[f"{name} t"]
        assert in_flight(name, text)
        changed = [*mutations(text), *renamed(text, ("b", "v", "y"))]
        assert [other for other in changed if in_flight(name, other)] == []


def with_lets(text: str, names: dict[str, Any]) -> Any:
    """The value of a formula in real numbers that introduces names with ``let``."""
    while match := re.match(r"let (\w+) := (.+?) in (.+)", text):
        names = names | {match[1]: evaluate_term(match[2], names, fmpq)}
        text = match[3]
    return evaluate_term(text, names, fmpq)


LEADING = [
    (fmpq(-2), fmpq(-3), fmpq(-5), fmpq(1, 7), fmpq(-3)),
    (fmpq(-1, 3), fmpq(-2), fmpq(-5, 2), fmpq(9, 4), fmpq(2)),
]


def same_leading_force(text: str) -> bool | None:
    """Whether the force at leading order is the library's; None: not certain."""
    with working_bits(160):
        for a1, a2, a3, eps, c1 in LEADING:
            force = contact_force(alpha_1=a1, alpha_2=a2, alpha_3=a3, c1=c1)
            tau = fmpq(2, 3)
            # t with kappa t eps^(-2/3) = tau
            kappa = arb(-a1 / 2) ** arb(fmpq(1, 3))
            names: dict[str, Any] = {"a1": a1, "a2": a2, "a3": a3, "eps": eps, "C1": c1, "theta": force.beta}
            names["t"] = arb(tau) * arb(eps) ** arb(fmpq(2, 3)) / kappa
            names["Rpower"] = Applied(2, lambda x, y: arb(x) ** arb(y))
            names["Derive"] = Applied(2, lambda beta, place: evaluate(place, beta, derivative=1, digits=30).value)
            try:
                difference = arb(with_lets(text, names)) - force.value(tau, eps, digits=30)
            except UNREADABLE:
                return False
            if not difference.is_finite() or not difference.contains(0):
                return False
            if difference.rad() > 1e-12:
                return None
    return True


def test_the_force_at_leading_order() -> None:
    text = body("leading_force")
    assert same_leading_force(text) is True
    changed = [*mutations(text), *renamed(text, ("a1", "a2", "a3", "eps", "C1", "beta", "kappa"))]
    assert [other for other in changed if same_leading_force(other) is not False] == []


DEVIATION = statement("deviation_equation").rpartition("forall t, ")[2]


@cache
def slow_derivatives(b: fmpq, e: fmpq, time: fmpq) -> list[arb]:
    """The slow solution of the library and its first four derivatives."""
    return [slow_value(time, b, e, derivative=k, digits=30).value for k in range(5)]


def solved_by_the_slow_solution(text: str) -> bool:
    """The equation of the deviation, with the library's slow solution and its derivatives put into it."""
    left, right = text.split(" = ")
    for b, e, time in ((fmpq(1, 2), fmpq(3, 7), fmpq(2, 3)), (fmpq(7, 3), fmpq(5, 4), fmpq(-3, 2))):
        values = slow_derivatives(b, e, time)

        def derivative(
            _function: object, order: object, place: object, at: fmpq = time, found: list[arb] = values
        ) -> arb:
            assert place is at
            return found[int(order)]  # type: ignore[call-overload]

        names: dict[str, Any] = {"b": b, "e": e, "t": time}
        names["f"] = Function(derivative)
        names["Derive"] = Applied(2, lambda f, place, get=derivative: get(f, 1, place))
        names["Derive_n"] = Applied(3, derivative)
        try:
            with working_bits(200):
                difference = arb(evaluate_term(left, names)) - arb(evaluate_term(right, names))
        except (*UNREADABLE, IndexError):
            return False
        if not (difference.is_finite() and difference.contains(0) and difference.rad() < 1e-20):
            return False
    return True


class Function(Applied):
    """f: applied to a place, or itself the argument of Derive and Derive_n."""

    def __init__(self, derivative: Callable[..., arb]) -> None:
        super().__init__(1, lambda place: derivative(None, 0, place))


def test_the_equation_of_the_deviation() -> None:
    assert solved_by_the_slow_solution(DEVIATION)
    changed = [*mutations(DEVIATION), *renamed(DEVIATION, ("b", "e", "t"))]
    assert [text for text in changed if solved_by_the_slow_solution(text)] == []
