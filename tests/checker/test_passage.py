"""The checker of Theorem B: certificates that are right and wrong, and each of its bounds beside another computation.

Page: proofs/from_state.md, section 10.
"""

from __future__ import annotations

import copy
import json
import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from must_reject import mutate

check = mutate.checker()
passage = check.passage
SHIPPED = mutate.CHECKER.with_name("passage_3_2.cert")
LINES = [json.loads(line) for line in SHIPPED.read_text(encoding="utf-8").splitlines()[:-1]]
STEP = Fraction(1, 2**40)
Change = Callable[[dict[str, Any], dict[str, Any]], None]


def text(change: Change = lambda *_: None) -> bytes:
    """The shipped certificate, changed in its statement and its line, and sealed anew."""
    lines = copy.deepcopy(LINES)
    change(lines[0]["statement"], lines[1])
    return mutate.text_of(lines)


def said(change: Change = lambda *_: None) -> str:
    return str(check.main.check_text(text(change)))


def put(where: int, **values: Any) -> Change:
    """Change the statement (0) or the line (1)."""
    return lambda *parts: parts[where].update(values)


def moved(where: int, name: str, factor: Fraction) -> Change:
    return lambda *parts: parts[where].update({name: str(Fraction(parts[where][name]) * factor)})


def term(name: str, index: int, value: str) -> Change:
    """Another coefficient of one of the polynomials."""
    return lambda _, line: line[name][index].__setitem__(2, value)


def test_the_shipped_certificate_says_what_it_proves() -> None:
    assert said() == (
        "the model system with α = (-1, -1, -3/2) and (k_1 ε², k_2 ε², c ε) = (1, 1, 1): for every ε in (0, 1/4000] "
        "and every start in contact at p = 1/2, b = -2 with |λ + b/p| ≤ η|L|, √κ|v|/ε ≤ η√p|L|, (g/√l)|φ| ≤ η√p|L|, "
        "η = 1/100, L = -b/p - 2, φ = λ + κy/ε² + (l/g)v/ε, κ = 1/2, g = 2, l = 1/2, as long as slip is positive: "
        "λ > 0 down to p = 4 ε^(2/3), where L has kept its sign, and |log(C/C_1)| ≤ 6829/524288 on the way, "
        "C = -L p^(-1/2), C_1 its value at the start"
    )


def in_units(c: Fraction) -> Change:
    """The same motion, with another unit of T: p, r, ε, the damper and what belongs to them have other numbers."""

    def change(statement: dict[str, Any], line: dict[str, Any]) -> None:
        for name, power in (("p", 2), ("b", 2), ("epsilon", 3)):
            statement[name] = str(Fraction(statement[name]) * c**power)
        statement["contact"][2] = str(1 / c)
        line["damping"], line["least"] = str(Fraction(line["damping"]) / c), str(Fraction(line["least"]) * c**2)
        line["rectangle"][1] = str(Fraction(line["rectangle"][1]) * c)
        for name, power in (("v", 1), ("w", 0), ("f", -2)):
            line[name] = [[i, n, str(Fraction(value) * c ** (power - n))] for i, n, value in line[name]]

    return change


ACCEPTED: list[tuple[str, Change]] = [
    ("a smaller ε", moved(0, "epsilon", Fraction(1, 1000))),
    ("fewer starts", put(0, within="0")),
    ("a larger drift", put(0, drift="1")),
    ("an end that is farther away", put(0, scaled="5")),
    ("a larger rate", moved(1, "rate", Fraction(1001, 1000))),
    ("a larger p at the end", moved(1, "least", Fraction(1001, 1000))),
    ("another λ̄", put(0, alpha=["-1", "-2", "-3/2"], b="-4")),
    ("another unit of time", in_units(Fraction(1, 4))),
    ("a slow part that is nearly right", term("v", 4, "3624/1000")),
]


@pytest.mark.parametrize("change", [pytest.param(change, id=name) for name, change in ACCEPTED])
def test_what_follows_is_accepted(change: Change) -> None:
    def whole(statement: dict[str, Any], line: dict[str, Any]) -> None:
        change(statement, line)
        statement["drift"] = str(max(Fraction(statement["drift"]), Fraction(1, 50)))
        for key, value in line.items():  # in lowest terms
            if isinstance(value, list) and value and isinstance(value[0], list):
                line[key] = [[i, n, str(Fraction(c))] for i, n, c in value]

    assert said(whole).startswith("the model system with α = ")


REJECTED: list[tuple[str, Change, str]] = [
    # Each hypothesis of Theorem B.
    ("ε too large", moved(0, "epsilon", Fraction(2)), "p at the end of the rectangle is not the one given"),
    ("a p that the rounding cannot tell from 0", in_units(Fraction(1, 10**70)), "the barrier is not below z_max"),
    ("ε far too large", put(0, epsilon="1"), "the passage would end before its start"),
    ("starts too far from rest", put(0, within="1/50"), "the barrier is not below z_max at the start"),
    ("more drift than stated", put(0, drift="6000/524288"), "not in lowest terms"),
    ("a little more drift than stated", put(0, drift="3/250"), "C_1 may drift more than is stated"),
    ("no drift", put(0, drift="0"), "C_1 may drift more than is stated"),
    ("a nearer end", put(0, scaled="399/100"), "the passage ends beyond the rectangle"),
    ("start beyond the rectangle", put(0, p="3/5", b="-12/5"), "the start is not on the rectangle"),
    ("p at the end too small", moved(1, "least", 1 - STEP), "p at the end of the rectangle is not the one given"),
    ("p at the end beyond the start", put(1, least="1/2"), "p at the end of the rectangle is not the one given"),
    ("a rate too small", moved(1, "rate", Fraction(999, 1000)), "the rate is too small"),
    ("a negative rate", put(1, rate="-1", growth="-4"), "the rate is too small"),
    ("a growth too small", put(1, growth="-3/20"), "not confirmed (Lemma 1)"),
    ("too much damping", put(1, damping="1/2"), "not confirmed (Lemma 1)"),
    ("no damping", put(1, damping="0"), "a number of the norm is negative"),
    ("hardly any damping", put(1, damping="1/100000"), "the layer does not fall with ε"),
    ("z_max too small", put(1, largest="1/40"), "the barrier is not below z_max"),
    ("z_max too large for the rate", put(1, largest="1/2"), "the rate is too small"),
    ("a negative number of the norm", put(1, norm=["-1", "1/2"]), "a number of the norm is negative"),
    ("a norm that is none", put(1, norm=["9", "1/2"]), "the norm is not positive definite"),
    ("an empty rectangle", put(1, rectangle=["0", "3/4"]), "a number of the norm is negative"),
    ("a force that vanishes", put(0, b="-1/1000", within="0"), "the force is not certainly positive"),
    # The slow part.
    ("no slow part", put(1, v=[], w=[], f=[]), "a source is not paid"),
    ("a sign in v", term("v", 0, "-1"), "a source is not paid"),
    ("another factor in v", term("v", 0, "1001/1000"), "a source is not paid"),
    ("a sign in w", term("w", 0, "-1/2"), "a source is not paid"),
    ("v without h", put(1, v=[[0, 1, "1"]]), "a polynomial is not divisible"),
    ("v without r", put(1, v=[[1, 0, "1"]]), "a polynomial is not divisible"),
    ("another last term of v", term("v", 4, "-29/8"), "the barrier is not below z_max"),
    ("no list of terms", put(1, v={}), "v is not a list of at most 200 terms"),
    ("a term with more", lambda _, line: line["v"][0].append("1"), "is not a term of v"),
    ("a power that is true", lambda _, line: line["v"][0].__setitem__(0, True), "is not a term of v"),
    ("terms out of order", lambda _, line: line["v"].reverse(), "the terms of v are not in order"),
    ("a term twice", lambda _, line: line["w"].append(line["w"][-1]), "the terms of w are not in order"),
    # The statement.
    ("another kind", put(0, kind="run"), "unknown kind of statement"),
    ("b on the distinguished trajectory", put(0, b="-1"), "the distinguished trajectory"),
    ("p not positive", put(0, p="0"), "p, ε, S or η"),
    ("a negative share", put(0, within="-1/100"), "p, ε, S or η"),
    ("ε = 0", put(0, epsilon="0"), "p, ε, S or η"),
    ("β = 1", put(0, alpha=["-1", "-1", "-1"]), "β is not above 1"),
    ("α_1 positive", put(0, alpha=["1", "-1", "-3/2"]), "β is not above 1"),
    ("α_2 positive", put(0, alpha=["-1", "1", "-3/2"]), "β is not above 1"),
    ("α_2 = 0", put(0, alpha=["-1", "0", "-3/2"]), "α_1 and α_2 are not negative"),
    ("alphas without an order", put(0, alpha={"-1": "", "-3/2": "", "-2": ""}), "is not a list of 3 numbers"),
    ("S = 0", put(0, scaled="0"), "p, ε, S or η"),
    ("the end at the start", put(0, epsilon="1/8", scaled="2"), "the passage would end before its start"),
    ("two alphas", put(0, alpha=["-1", "-1"]), "is not a list of 3 numbers"),
    ("another β", put(0, alpha=["-1", "-1", "-8/5"]), "the rate is too small"),
    ("another contact", put(0, contact=["1", "1", "9/10"]), "a source is not paid"),
    ("no damper", put(0, contact=["1", "1", "0"]), "a constant of the contact is not positive"),
    ("a boolean", put(0, within=True), "more than 400 characters"),
    ("a key too many", put(0, more="1"), "has not the keys"),
    ("a key too many in the line", put(1, more="1"), "has not the keys"),
]


@pytest.mark.parametrize(
    ("change", "reason"), [pytest.param(change, reason, id=name) for name, change, reason in REJECTED]
)
def test_what_does_not_follow_is_rejected(change: Change, reason: str) -> None:
    with pytest.raises(check.limits.Rejected) as found:
        said(change)
    assert reason in str(found.value)


@pytest.mark.parametrize("lines", [LINES[:1], [*LINES, LINES[1]]])
def test_there_is_one_line(lines: list[Any]) -> None:
    with pytest.raises(check.limits.Rejected, match="there is not one line"):
        check.main.check_text(mutate.text_of(lines))


def test_the_pages_are_those_of_a_passage() -> None:
    lines = copy.deepcopy(LINES)
    lines[0]["hypotheses"] = ["run_certificate"]
    with pytest.raises(check.limits.Rejected, match="the pages are not those"):
        check.main.check_text(mutate.text_of(lines))


@given(st.fractions(min_value=Fraction(1, 10**30), max_value=10**30))
def test_roots_and_logarithms_are_bounds_and_close_ones(q: Fraction) -> None:
    root, unit = passage.root_above(q), Fraction(1, 2**passage.BITS)
    assert max(root - 2 * unit, 0) ** 2 <= q <= root**2
    assert 0 <= passage.above(q) - q < unit
    exact = math.log(q.numerator) - math.log(q.denominator)
    assert -1e-12 <= float(passage.log_above(q)) - exact <= 1e-12 + 1e-15 * exact**2


def test_powers_of_e_are_computed_as_far_as_their_bound_is_one() -> None:
    """e^x ≤ (1 - x/2^60)^(-2^60) holds for x < 2^60 alone."""
    assert passage.exp_above(Fraction(999)) >= Fraction(math.e) ** 999 * (1 - Fraction(1, 10**9))
    for x in (Fraction(1000), Fraction(2**61)):
        with pytest.raises(check.limits.Rejected, match="a power of e is too large"):
            passage.exp_above(x)


def parts() -> tuple[Any, Any, Any]:
    """Start, slow part and norm of the shipped certificate."""
    statement, line = LINES[0]["statement"], LINES[1]
    start = passage.Start(statement)
    slow = passage.Slow(start, *(passage.read_polynomial(line[name], name) for name in "vwf"))
    growth = Fraction(line["growth"]), Fraction(line["damping"])
    return start, slow, passage.Norm(*map(Fraction, line["norm"]), *growth, *map(Fraction, line["rectangle"]))


def on(polynomial: Any, h: float, r: float) -> float:
    return sum(float(c) * h ** key.count("h") * r ** key.count("r") for key, c in polynomial.items())


def field(start: Any, h: float, r: float, u: np.ndarray) -> np.ndarray:
    """(L, V, W, φ)' of the model system, equation (2) of the page, at h, r."""
    L, V, W, phi = u
    beta, kappa, g, lag, p = (float(x) for x in (start.beta, start.kappa, start.rate, start.lag, r * r))
    return np.array(
        [
            -h * r * ((beta - 1) * L + beta * W / p),
            W,
            -kappa * p * V - g * p * phi + h * r * (beta - 1) * (W + p * L),
            -g * phi + lag / g * W,
        ]
    )


def test_the_residuals_are_those_of_the_equations() -> None:
    """By difference quotients along the slow solution, L' = -hr((β-1) + βw)L."""
    start, slow, _ = parts()
    h, r, L, t = 0.09, 0.5, 1.0, 1e-6

    def at(time: float) -> np.ndarray:
        e = h * r**3
        p = r * r - e * time  # p' = -e
        r_then = math.sqrt(p)
        h_then = e / p**1.5
        L_then = L * (1 - h * r * (0.5 + 1.5 * on(slow.w, h, r)) * time)
        v, w, f = (on(one, h_then, r_then) for one in (slow.v, slow.w, slow.f))
        return L_then * np.array([1, v, p * w, p * f])

    left = (at(t) - at(-t)) / (2 * t)
    rest = np.abs(field(start, h, r, at(0)) - left)[1:] / (h * r**3)
    bound = float(passage.at(slow.source, Fraction(h), Fraction(r)))
    one, two, three = map(float, slow.lengths())
    true = one * r * rest[0] + two * rest[1] + three * r * rest[2]
    assert true <= bound + 1e-8
    assert true >= bound / 30  # term by term it is larger, not by orders of magnitude


def test_the_surplus_is_that_of_the_equations() -> None:
    """N of Lemma 1 beside a matrix from difference quotients of (2) in x = (r(V - Lv), W - Lr²w, r(φ - Lr²f))."""
    start, slow, norm = parts()
    h, r, t = 0.1, 0.6, 1e-6
    e = h * r**3

    def shape(time: float) -> tuple[float, float]:
        p = r * r - e * time
        return e / p**1.5, math.sqrt(p)

    def deviation(u: np.ndarray, time: float) -> np.ndarray:
        h_then, r_then = shape(time)
        v, w, f = (on(one, h_then, r_then) for one in (slow.v, slow.w, slow.f))
        L, V, W, phi = u
        return np.array([r_then * (V - L * v), W - L * r_then**2 * w, r_then * (phi - L * r_then**2 * f)])

    L = 1.0
    v, w, f = (on(one, h, r) for one in (slow.v, slow.w, slow.f))
    slow_state = np.array([L, L * v, L * r * r * w, L * r * r * f])

    def rate(x: np.ndarray) -> np.ndarray:
        u = slow_state + np.array([0, x[0] / r, x[1], x[2] / r])
        step = field(start, h, r, u) * t
        return (deviation(u + step, t) - deviation(u - step, -t)) / (2 * t)

    B = np.array([rate(unit) - rate(np.zeros(3)) for unit in np.eye(3)]).T
    M = np.array([[on(entry, h, r) for entry in row] for row in norm.matrix(start)])
    before, after = (
        np.array([[on(entry, *shape(time)) for entry in row] for row in norm.matrix(start)]) for time in (-t, t)
    )
    change = (after - before) / (2 * t)
    factor = 2 * (float(norm.growth) * h * r - float(norm.damping) * r * r)
    expected = factor * M - (M @ B + B.T @ M + change)
    found = np.array([[on(entry, h, r) for entry in row] for row in norm.surplus(slow)])
    assert np.abs(found - expected).max() <= 1e-7
    assert np.linalg.eigvalsh(found).min() > 0


def test_the_barrier_is_an_upper_solution_and_no_larger_than_needed() -> None:
    """(9): -p dZ/dp - (Γ - θr/h)Z - 𝓕 ≥ 0, and with half of each coefficient it is not."""
    _, slow, norm = parts()
    rate = Fraction(LINES[1]["rate"])
    Z = passage.barrier(slow.source, rate, norm.damping)

    def lack(h: Fraction, r: Fraction, share: Fraction = Fraction(1)) -> Fraction:
        total = -sum(c * h**i * r**n for (i, n), c in slow.source.items())
        for (i, n), c in Z.items():
            own = Fraction(3 * i - n, 2) - rate + norm.damping * r / h
            total += share * own * c * h**i * r**n
        return total

    places = [(norm.h * Fraction(k, 8), norm.r * Fraction(j, 8)) for k in range(1, 9) for j in range(1, 9)]
    assert all(lack(h, r) >= 0 for h, r in places)
    assert any(lack(h, r, Fraction(1, 2)) < 0 for h, r in places)


def test_a_hostile_file_ends_soon() -> None:
    """Long numbers and as many terms as are allowed: rejected, within the budget of work."""
    long = str(Fraction(10**190 + 1, 10**190))
    terms = [[i, n, long] for i in range(1, 15) for n in range(1, 15)]
    for change in (put(1, v=terms), put(1, w=terms), put(1, v=terms, w=terms, f=terms)):
        with pytest.raises(check.limits.Rejected):
            said(change)
    with pytest.raises(check.limits.Rejected, match="at most 200 terms"):
        said(put(1, v=[[i, n, "1"] for i in range(15) for n in range(15)]))
    with pytest.raises(check.limits.Rejected, match="is not a term of v"):
        said(put(1, v=[[1, 31, "1"]]))
    with pytest.raises(check.limits.Rejected, match="is not a term of v"):
        said(put(1, v=[[1, -1, "1"]]))


def test_the_start_is_bounded_by_the_formula_of_the_page() -> None:
    """(8), with springs and a damper that are not 1."""
    statement = LINES[0]["statement"] | {"contact": ["2", "1", "1"]}  # κ = 2/3, g = 3, l = 1/3
    start = passage.Start(statement)
    polynomials = [[[1, 1, "-5"], [2, 3, "7"]], [[2, 0, "4000"]], [[2, 0, "-9000"], [3, 1, "1"]]]
    slow = passage.Slow(start, *(passage.read_polynomial(terms, "v") for terms in polynomials))
    h, r = 1 / 4000 / 0.5**1.5, math.sqrt(0.5)
    v, w, f = 5 * h + 7 * h**2 * r**2, 4000 * h**2, 9000 * h**2 + h**3 * r
    expected = 0.03 + math.sqrt(2 / 3) * v + w + 3 * math.sqrt(3) * r * f
    assert float(passage.start_bound(slow, start)) == pytest.approx(expected, rel=1e-12)
    assert [*map(float, slow.lengths())] == pytest.approx([math.sqrt(2 / 3), 1, 3 * math.sqrt(3)], rel=1e-12)


@pytest.mark.parametrize(("i", "n"), [(1, 0), (1, 2), (1, 3), (1, 5), (1, 7), (2, 7)])
def test_the_integral_of_a_monomial_of_the_barrier_is_no_larger(i: int, n: int) -> None:
    """∫ h^i r^n dp/p at one e from p_S = 1/4 to p_1 = 4, exactly, beside the bound."""
    _, _, norm = parts()
    bound = passage.passed({(i, n): Fraction(1)}, norm._replace(r=Fraction(2)), Fraction(1, 2))
    own = (3 * i - n) / 2
    total = (2 ** (2 * own) - 2 ** (-2 * own)) / own if own else math.log(16)
    assert total * (float(norm.h) / 8) ** i <= float(bound)  # h = h_1/(2r)^3


Terms = dict[tuple[int, int], Fraction]
NEAR = Fraction(1, 10**5)


def ended(
    *,
    w: Terms | None = None,
    source: Terms | None = None,
    damping: Fraction | None = None,
    least: str = LINES[1]["least"],
    **statement: Any,
) -> str:
    """Why Theorem B is rejected for the shipped numbers with other w, 𝓕, θ, without v and f; nothing if it holds."""
    start = passage.Start(LINES[0]["statement"] | {"drift": "0"} | statement)
    _, slow, norm = parts()
    slow.start, slow.source, slow.v, slow.f = start, source or {}, passage.NOTHING, passage.NOTHING
    slow.w = passage.Polynomial({("h",) * i + ("r",) * n: c for (i, n), c in (w or {}).items()})
    norm = norm._replace(damping=damping or norm.damping)
    rate, largest = (Fraction(LINES[1][name]) for name in ("rate", "largest"))
    try:
        passage.check_barrier(start, slow, norm, rate, largest, Fraction(least))
    except check.limits.Rejected as reason:
        return str(reason)
    return ""


def test_the_layer_must_fall_by_enough_at_the_end() -> None:
    rate, largest, least = (float(Fraction(LINES[1][name])) for name in ("rate", "largest", "least"))
    length = math.log(0.5**3 / 8**2 * 4000**2) / 3
    damping = Fraction((rate * length - math.log(largest / 0.03)) * 2 / 4000 / (0.25 - least**2))
    assert ended(damping=damping * (1 - NEAR)) == "the barrier is not below z_max at the end"
    assert ended(damping=damping * (1 + NEAR)) == "the integral of the layer is not bounded"
    damping = Fraction(4 * rate / 4000 / 0.75)
    assert ended(damping=damping * (1 - NEAR)) == "the layer does not fall with ε"
    assert ended(damping=damping * (1 + NEAR)) == "the barrier is not below z_max at the end"


def test_w_must_leave_the_force_positive_and_the_deviation_falling() -> None:
    start, _, norm = parts()
    moved = norm.share(start) * Fraction(LINES[1]["largest"])
    for b, limit, reason in (
        ("-2", 1 - moved, "the force is not certainly positive"),
        ("-1/2", Fraction(1, 3) - moved, "the deviation does not certainly fall with p"),
    ):
        for side, expected in ((1 + NEAR, reason), (1 - NEAR, "C_1 may drift more than is stated")):
            assert ended(w={(2, 0): -limit * side / norm.h**2}, b=b) == expected
    assert ended(w={(1, 3): Fraction(-1, 1000)}) == "w has a monomial that does not grow"


def test_the_drift_is_the_sum_of_the_page() -> None:
    """Item 5 of section 10, with one monomial of w and one of 𝓕."""
    start, _, norm = parts()
    rate, least = (float(Fraction(LINES[1][name])) for name in ("rate", "least"))
    length, decay = math.log(0.5**3 / 8**2 * 4000**2) / 3, 0.05 * (0.25 - least**2) * 2000
    first = 0.03 + 0.1 * (1 / 4000 / 0.5**1.5) ** 2 * 0.5
    area = first / (decay / length - rate) + 2 * 3 / (6 - rate) * 8**-4 / 12
    drift = 1.5 * (2 * 0.1 * 8**-2 * least / 4 + float(norm.share(start)) * area)
    chosen = {"w": {(2, 2): Fraction(-1, 10)}, "source": {(4, 0): Fraction(3)}}
    assert ended(**chosen, drift=str(Fraction(drift) * (1 - NEAR))) == "C_1 may drift more than is stated"
    assert not ended(**chosen, drift=str(Fraction(drift) * (1 + NEAR)))


def test_the_layer_of_a_short_passage_is_bounded_for_smaller_epsilon_too() -> None:
    """(11) with log(p_1/p_S) < 2/3."""
    start, _, norm = parts()
    epsilon, least, damping = Fraction(1, 42), 0.332, Fraction(3)
    assert (8 / 42) ** (2 / 3) < least < 0.5 * math.exp(-0.4)
    fall = 3 * (0.25 - least**2) * 21 / (2 / 3) - float(Fraction(LINES[1]["rate"]))
    drift = Fraction(1.5 * float(norm.share(start)) * 0.03 / fall)
    chosen: dict[str, Any] = {"damping": damping, "epsilon": str(epsilon), "least": str(Fraction(332, 1000))}
    assert ended(**chosen, drift=str(drift * (1 - NEAR))) == "C_1 may drift more than is stated"
    assert not ended(**chosen, drift=str(drift * (1 + NEAR)))
