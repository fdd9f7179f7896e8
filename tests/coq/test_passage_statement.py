"""The formulas of proofs/coq/StatementPassage.v are those of the library; each single change of one is noticed."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import pytest
from coq.coq_terms import Applied, evaluate_term, mutations, statement
from coq.mechanism_terms import UNREADABLE, body, renamed
from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.barrier import Start, layer, start_bound
from gspot_verified.expansion.from_state.fast_growth import Matrix, Norm, fast_matrix, surplus
from gspot_verified.expansion.from_state.slow_series import (
    RING,
    Contact,
    H,
    R,
    SlowSeries,
    change,
    slow_series,
    terms_of,
)
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.numbers.balls import ball, working_bits

Names = dict[str, Any]
Vector = tuple[Fraction, Fraction, Fraction]


class Place(NamedTuple):
    """A model system, its slow part, a norm, and a point (h, r) with a vector."""

    alphas: list[fmpq]
    springs: Regularisation
    norm: Norm[SlowSeries]
    h: Fraction
    r: Fraction
    x: Vector

    @property
    def series(self) -> SlowSeries:
        return self.norm.series

    def at(self, polynomial: fmpq_mpoly) -> Fraction:
        """The value at the point."""
        return value(polynomial, self.h, self.r)

    def here(self, h: Fraction, r: Fraction) -> Place:
        """The place itself; a text that speaks of another point is not the one of the file."""
        assert (h, r) == (self.h, self.r)
        return self

    def form(self, matrix: Matrix) -> Fraction:
        """x^T M x."""
        return dot([[self.at(entry) for entry in row] for row in matrix], self.x, self.x)


def places() -> list[Place]:
    """Chosen once and for all: no two numbers of one are alike."""
    found = []
    for alphas, springs, k, point, x in (
        ("-2 -3/5 -3", "3 1/2 5/7", "3/2 4/9", "1/3 2/7", "5 -7/4 11/6"),
        ("-1 -9/7 -12/5", "2/3 7 1/5", "1/8 6/5", "5/4 3/8", "-2/9 13 3/10"),
    ):
        model, contact = exact(alphas), Regularisation(*exact(springs))
        series = slow_series(model[2] / model[0], Contact.of(contact), 4)
        h, r = map(plain, exact(point))
        one, two, three = map(plain, exact(x))
        found.append(Place(model, contact, Norm(series, *exact(k)), h, r, (one, two, three)))
    return found


def exact(words: str) -> list[fmpq]:
    return [fmpq(value.numerator, value.denominator) for value in map(Fraction, words.split())]


def plain(number: fmpq) -> Fraction:
    return Fraction(int(number.p), int(number.q))


def value(polynomial: fmpq_mpoly, h: Fraction, r: Fraction) -> Fraction:
    return sum((plain(c) * h**i * r**n for (i, n), c in terms_of(polynomial).items()), Fraction(0))


def names(place: Place) -> Names:
    """What the names of the file stand for."""
    contact, series = place.series.contact, place.series

    def constant(of: fmpq | fmpq_mpoly) -> Applied:
        plainly = plain(of) if isinstance(of, fmpq) else of
        return Applied(1, lambda _: plainly)

    def entry(index: int) -> Applied:
        return Applied(1, lambda vector: vector[index])

    gram = [[place.at(one) for one in row] for row in place.norm.matrix]
    alphas = {f"alpha{i + 1}": alpha for i, alpha in enumerate(place.alphas)}
    springs = {"k1": place.springs.k_1, "k2": place.springs.k_2, "c": place.springs.c, "beta_of": series.beta}
    lengths = {"kappa_of": contact.kappa, "g_of": contact.rate, "l_of": contact.lag}
    chosen = {"at_m": place.norm.k_2, "at_n": place.norm.k_1}
    parts = {"slow_v": series.v, "slow_w": series.w, "slow_f": series.f}
    constants: dict[str, fmpq | fmpq_mpoly] = {**alphas, **springs, **lengths, **chosen, **parts}
    known: Names = {name: constant(of) for name, of in constants.items()}
    known |= {"h": place.h, "r": place.r, "x": place.x, "first": entry(0), "second": entry(1), "third": entry(2)}
    return known | {
        **dict.fromkeys(("M", "P", "K", "F", "eps", "t")),
        "value_of": Applied(3, value),
        "D_along": Applied(5, lambda _M, _P, F, h, r: value(along(series, F), h, r)),
        "B_times": Applied(5, lambda _M, _P, h, r, x: times(place.here(h, r), x)),
        "Vector": Applied(3, lambda *entries: entries),
        "m_entry": Applied(4, lambda *_: gram[0][1]),
        "n_entry": Applied(2, lambda *_: gram[1][2]),
        "product_M": Applied(6, lambda _M, _K, h, r, x, y: dot(gram, x, y) if place.here(h, r) else None),
    }


def along(series: SlowSeries, polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """D F of the page, section 2."""
    return change(polynomial) - H * R * ((series.beta - 1) + series.beta * series.w) * polynomial


def times(place: Place, x: Vector) -> tuple[Fraction, ...]:
    """B x."""
    rows = fast_matrix(place.series)
    return tuple(sum((place.at(row[j]) * x[j] for j in range(3)), Fraction(0)) for row in rows)


def dot(gram: list[list[Fraction]], x: Vector, y: Vector) -> Fraction:
    return sum((x[i] * gram[i][j] * y[j] for i in range(3) for j in range(3)), Fraction(0))


def rate_of_growth(place: Place) -> Fraction:
    """x^T (M B + B^T M + M') x, by N at rate 0 and damping 0."""
    return -place.form(surplus(place.norm, fmpq(0), fmpq(0)))


def mean_force(place: Place) -> fmpq:
    first, second, third = map(Affine, place.alphas)
    return AffineSystem(first, second, third, place.springs).mean_force


FORMULAS: dict[str, Callable[[Place], Any]] = {
    "beta_of": lambda place: plain(place.series.beta),
    "mean_of": lambda place: plain(mean_force(place)),
    "kappa_of": lambda place: plain(place.series.contact.kappa),
    "g_of": lambda place: plain(place.series.contact.rate),
    "l_of": lambda place: plain(place.series.contact.lag),
    "r_V": lambda place: place.at(place.series.residual[0] * H * R**2),
    "r_W": lambda place: place.at(place.series.residual[1] * H * R**3),
    "r_phi": lambda place: place.at(place.series.residual[2] * H * R**2),
    "m_entry": lambda place: place.at(place.norm.matrix[0][1]),
    "n_entry": lambda place: place.at(place.norm.matrix[1][2]),
    "B_times": lambda place: times(place, place.x),
    "growth_form": rate_of_growth,
}


@pytest.mark.parametrize("name", FORMULAS)
def test_a_formula(name: str) -> None:
    found, text = places(), body(name)
    known = [names(place) for place in found]

    def holds(text: str) -> bool:
        try:
            return all(
                evaluate_term(text, given, Fraction) == FORMULAS[name](place)
                for given, place in zip(known, found, strict=True)
            )
        except UNREADABLE:
            return False

    assert holds(text)
    words = tuple(word for word in ("first", "second", "third", "h", "r", "slow_v", "slow_w", "slow_f") if word in text)
    others = [*mutations(text), *(renamed(text, words) if words else [])]
    assert [other for other in others if holds(other)] == []


def test_the_form_is_that_of_the_norm() -> None:
    for place in places():
        given = names(place) | {"y": place.x}
        assert evaluate_term(body("product_M"), given, Fraction) == place.form(place.norm.matrix)


def test_the_growth_of_a_monomial() -> None:
    """E: - p d/dp h^i r^n = E h^i r^n, and F' = hr E F."""
    for i, n in ((0, 0), (2, 5), (3, 1)):
        own = evaluate_term(
            body("E_of"),
            {
                "a": (i, n),
                "INR": Applied(1, fmpq),
                "by_h": Applied(1, lambda a: a[0]),
                "by_r": Applied(1, lambda a: a[1]),
            },
            fmpq,
        )
        assert change(H**i * R**n) == own * H ** (i + 1) * R ** (n + 1) + RING.constant(0)


def test_the_equations_are_those_of_the_mechanism() -> None:
    """With k1 = k2 = c = 1 they are those of StatementCompliant.v."""
    text = statement("moves_by").partition(":= ")[2]
    for general, special in (
        ("force M eps x t", "force eps (y t) (z t)"),
        ("c M * ", ""),
        ("- (k1 M * z x t)", "- z t"),
        *((f"alpha{i} M", f"a{i}") for i in (1, 2, 3)),
        *((f"({name} x)", name) for name in "pbyv"),
        *((f"{name} x t", f"{name} t") for name in "pbyvz"),
        ("z x s", "z s"),
    ):
        text = text.replace(general, special)
    said = statement("model_at").partition(":= ")[2]
    assert text.replace("(a1)", "a1") == said


def test_the_layer_and_the_start() -> None:
    with working_bits(200):
        for place in places():
            p, e, z, theta, rate = (ball(value) for value in exact("1/3 1/2000 3/50 1/7 5/3"))
            h = ball(exact("1/5")[0])
            start = Start(fmpq(1, 3), fmpq(1, 2000), z, 1, fmpq(1))
            below = evaluate_term(body("p_at_h"), {"e": e, "h": h, "Rpower": POWER}, arb)
            given = {"Gamma": rate, "theta": theta, "z0": z, "p1": p, "e": e, "p": below, "exp": EXP, "Rpower": POWER}
            assert near(evaluate_term(body("layer"), given, arb), layer(start, h, rate, theta))
            others = [*mutations(body("layer")), *renamed(body("layer"), ("theta", "z0", "p1", "e", "p"))]
            assert [text for text in others if same_layer(text, given, layer(start, h, rate, theta))] == []
            lets, _, text = body("start_bound").rpartition(" in ")
            assert lets == "let r := sqrt p1 in let h := e0 / (p1 * sqrt p1)"
            root = p.sqrt()
            known = names(place) | {"eta": ball(fmpq(1, 90)), "r": root, "h": e / root**3, "sqrt": Applied(1, root_of)}
            contact = place.series.contact
            known |= {name: held(ball(of)) for name, of in (("kappa_of", contact.kappa), ("g_of", contact.rate))}
            known["l_of"] = held(ball(contact.lag))
            known["size"] = Applied(3, size)
            found = evaluate_term(text, known, arb)
            assert near(found, start_bound(place.series, start.p, start.e, fmpq(1, 90)))


EXP = Applied(1, lambda number: number.exp())
POWER = Applied(2, lambda base, exponent: base**exponent)


def held(number: arb) -> Applied:
    return Applied(1, lambda _: number)


def root_of(number: arb) -> arb:
    return number.sqrt()


def size(polynomial: fmpq_mpoly, h: arb, r: arb) -> arb:
    return sum((abs(ball(c)) * h**i * r**n for (i, n), c in terms_of(polynomial).items()), arb(0))


def near(first: arb, second: arb) -> bool:
    return bool(abs(first - second) < abs(second) * arb("1e-30"))


def same_layer(text: str, given: Names, expected: arb) -> bool:
    try:
        return near(evaluate_term(text, given, arb), expected)
    except UNREADABLE:
        return False
