"""The saddle point in proofs/coq/Statement.v: its coefficients, remainder and inequality are those of the library."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any, NamedTuple

import pytest
from coq.coq_terms import Applied, Names, evaluate_term, mutations
from coq.mechanism_terms import UNREADABLE, body, renamed
from flint import arb, fmpq

from gspot_verified import evaluate, polynomial
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.theta_function.sums.finite_part import near_integers
from gspot_verified.theta_function.sums.positive import (
    SaddlePlan,
    _algebraic_part,
    _near_zero,
    _saddle_remainder,
)
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient

BITS = 60
NAMES = ("b", "t", "lambda", "eta", "rho", "N", "m", "M", "p", "sigma")
FUNCTIONS: Names = {
    "INR": Applied(1, lambda n: n),
    "sqrt": Applied(1, lambda x: arb(x).sqrt()),
    "exp": Applied(1, lambda x: arb(x).exp()),
    "Gamma": Applied(1, lambda x: arb(x).gamma()),
    "Rpower": Applied(2, lambda x, y: arb(x) ** arb(y)),
    "Rmax": Applied(2, lambda x, y: arb(x).max(arb(y))),
    "PI": arb.pi(),
}


class Place(NamedTuple):
    """Arguments of saddle_remainder; the integers that stand apart are those of the library."""

    b: fmpq
    t: fmpq
    eta: fmpq
    rho: fmpq
    N: int
    m: int

    @property
    def apart(self) -> tuple[int, ...]:
        return tuple(near_integers(self.b))

    @property
    def plan(self) -> SaddlePlan:
        return SaddlePlan(self.N, self.eta, self.rho)

    def names(self) -> dict[str, Any]:
        """The names of the statements."""
        given = {name: ball(of) for name, of in zip(("b", "t", "eta", "rho"), self[:4], strict=True)}
        return {**FUNCTIONS, **given, "N": self.N, "m": self.m, "lambda": given["t"] * given["t"].sqrt()}


PLACES = (
    Place(fmpq(7, 3), fmpq(17, 2), fmpq(3, 5), fmpq(1, 3), 2, 0),
    Place(fmpq(-7, 2), fmpq(9), fmpq(2, 5), fmpq(1, 5), 1, 3),
)
"""Not far out: there all of E_1, ..., E_5 count."""


def lets(text: str, names: Names) -> tuple[str, Names]:
    """What stands after the last "in", and what the names before it stand for."""
    *before, last = text.split(" in ")
    known = dict(names)
    for line in before:
        found = re.fullmatch(r"let (\w+) := (.*)", line)
        assert found
        known[found[1]] = evaluate_term(found[2], known, arb)
    return last, known


def near(first: arb, second: arb) -> bool:
    return bool(abs(first - second) < abs(second) * arb("1e-9"))


def unnoticed(text: str, same: Callable[[str], bool]) -> list[str]:
    """The single changes of the text with which it says the same."""

    def holds(text: str) -> bool:
        try:
            return same(text)
        except UNREADABLE:
            return False

    assert holds(text)
    names = tuple(name for name in NAMES if re.search(rf"\b{name}\b", text))
    return [other for other in [*mutations(text), *renamed(text, names)] if holds(other)]


def test_the_coefficients() -> None:
    """Those that the differential equation gives."""
    found = re.fullmatch(r"(.*) \* sum_first \(fun j => (.*)\) \((S \(2 \* k\))\)", body("saddle_coefficient"))
    assert found
    front, term, count = found.groups()
    whole = {
        "INR": Applied(1, lambda n: n),
        "S": Applied(1, lambda n: n + 1),
        "fact": Applied(1, lambda n: fmpq(math.factorial(integer(n)))),
        "rising": Applied(2, rising),
    }

    def same(text: str) -> bool:
        front, term = text.split(" | ")
        for b in (fmpq(2, 7), fmpq(-9, 4)):
            for k in range(4):
                names = {**whole, "b": b, "k": k}
                last = integer(evaluate_term(count, names, fmpq))
                total = sum((evaluate_term(term, {**names, "j": j}, fmpq) for j in range(last)), fmpq(0))
                if evaluate_term(front, names, fmpq) * total != coefficient(k)(b) * fmpq(3, 2) ** k:
                    return False
        return True

    assert unnoticed(f"{front} | {term}", same) == []


def integer(number: fmpq | int) -> int:
    """The number itself, as an integer."""
    if isinstance(number, fmpq) and number.q != 1:
        raise ValueError
    return int(number.p) if isinstance(number, fmpq) else number


def rising(x: fmpq, n: fmpq | int) -> fmpq:
    return math.prod((x + i for i in range(integer(n))), start=fmpq(1))


def test_the_remainder() -> None:
    def same(text: str) -> bool:
        for place in PLACES:
            last, names = lets(text, place.names())
            found = names["lambda"].sqrt() * evaluate_term(last, names, arb)
            if not near(found, _saddle_remainder(names["lambda"], ball(place.b), place.plan)):
                return False
        return True

    with working_bits(BITS):
        assert unnoticed(body("saddle_error"), same) == []


def parts() -> dict[str, str]:
    """The lets of saddle_remainder by their names, and the two sides of its inequality."""
    text = body("saddle_remainder")
    found = dict(re.findall(r"let (\w+) := (?:fun n => )?(.*?) in ", text))
    sides = re.fullmatch(r".* in Rabs \((.*)\) <= (.*)", text)
    assert sides
    left = sides[1].replace("fold_right Rplus 0 (map near A)", "apart")
    left = left.replace("sum_first (fun k => saddle_coefficient b k / lambda ^ k) N", "series")
    return {**found, "left": left, "right": sides[2]}


PARTS = parts()


def series(place: Place, large: arb) -> arb:
    return sum((coefficient(k)(place.b) * (fmpq(3, 2) / large) ** k for k in range(place.N)), arb(0))


def all_names(place: Place) -> dict[str, Any]:
    """With the left side's parts as the library has them."""
    names = place.names()
    reciprocal = (-names["b"]).rgamma()
    names["K"] = evaluate_term(PARTS["K"], names, arb)
    names["series"] = series(place, names["lambda"])
    names["apart"] = _algebraic_part(names["t"], place.b, place.plan, BITS) / reciprocal if place.apart else arb(0)
    names["theta"] = Applied(1, lambda t: evaluate(place.t, place.b, digits=40).value if t is names["t"] else t)
    names["fact"] = Applied(1, lambda n: math.factorial(n))
    return names


def polynomial_at(n: int, t: arb) -> arb:
    """P_n(t)."""
    return sum((ball(c) * t**i for i, c in enumerate(polynomial(n).coeffs())), arb(0))


def test_what_stands_apart() -> None:
    """The algebraic part."""
    places = (PLACES[0], PLACES[0]._replace(b=fmpq(10, 3)))

    def same(text: str) -> bool:
        for place in places:
            names = all_names(place)
            names["Poly"] = Applied(2, polynomial_at)
            found = sum((evaluate_term(text, {**names, "n": n}, arb) for n in place.apart), arb(0))
            if not near(found, names["apart"]):
                return False
        return True

    with working_bits(BITS):
        assert unnoticed(PARTS["near"], same) == []


def test_the_inequality() -> None:
    """The right side is E_1 + ... + E_5 of the library; the left side is below it, and no changed one is."""
    assert PARTS["lambda"] == "t * sqrt t"
    assert PARTS["sigma"] == "eta * sqrt (1 - eta / 3)"

    def right(text: str) -> bool:
        for place in PLACES:
            names = all_names(place)
            root = names["lambda"].sqrt()
            rest = _saddle_remainder(names["lambda"], names["b"], place.plan) / root
            names["saddle_error"] = Applied(6, lambda *given, rest=rest, names=names: chosen(given, names, rest))
            expected = names["K"] * rest + _near_zero(arb(1), names["t"], names["b"], place.plan)
            if not near(evaluate_term(text, names, arb), expected):
                return False
        return True

    def chosen(given: tuple[Any, ...], names: Names, rest: arb) -> arb:
        assert all(one is names[name] for one, name in zip(given, ("b", "lambda", "eta", "rho", "N", "m"), strict=True))
        return rest

    sharp = (
        Place(2 + fmpq(1, 10**9), fmpq(9), fmpq(3, 5), fmpq(1, 3), 2, 0),
        Place(fmpq(-7, 2), fmpq(50), fmpq(3, 5), fmpq(1, 3), 6, 3),
    )

    def left(text: str) -> bool:
        for place in sharp:
            names = all_names(place)
            rest = _saddle_remainder(names["lambda"], names["b"], place.plan) / names["lambda"].sqrt()
            bound = names["K"] * rest + _near_zero(arb(1), names["t"], names["b"], place.plan)
            if not abs(evaluate_term(text, names, arb)) < bound:
                return False
        return True

    with working_bits(200):
        assert unnoticed(PARTS["right"], right) == []
        assert unnoticed(PARTS["left"], left) == []
        assert unnoticed(PARTS["K"], lambda text: left(PARTS["left"].replace("K", f"({text})"))) == []


@pytest.mark.parametrize("place", PLACES)
def test_the_places_are_within_the_hypotheses(place: Place) -> None:
    names = place.names()
    sigma = evaluate_term(PARTS["sigma"], names, arb)
    assert names["lambda"] * sigma**2 >= 2 * place.N
    assert 2 * names["lambda"] * sigma > max(fmpq(0), -place.b - 1)
    assert all(abs(n - place.b) >= fmpq(1, 2) for n in range(20) if n not in place.apart)
    assert (fmpq(place.m) >= -place.b - 1, place.m == max(0, math.ceil(-place.b - 1))) == (True, True)
