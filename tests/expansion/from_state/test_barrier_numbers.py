"""Theorem B of proofs/from_state.md number by number: its formulas in mpmath, each inequality on both sides of its
edge, and every bound again with few bits, where it must not fall below itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq, fmpq_mpoly
from mpmath import mpf

from gspot_verified.expansion.from_state.barrier import (
    Start,
    Tube,
    extent,
    layer,
    layer_integral,
    paid,
    source,
    start_bound,
    times,
    tube,
)
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.slow_series import Contact, H, R, slow_series, terms_of
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less

FINE, COARSE = 192, 24
DIGITS = 50
BETA, DAMPING = fmpq(7, 3), fmpq(2, 7)
CONTACT = Contact.of(Regularisation.of(2, 3, "1/2"))  # kappa = 6/5, g = 10, l = 9/5
SERIES = replace(  # any polynomials are right: these have both signs, and a residual that is small for h = 1/2
    slow_series(BETA, CONTACT, 3),
    w=fmpq(1, 3) * H**2 - fmpq(2, 5) * H**2 * R**3 + fmpq(3, 7) * H**3 * R,
    residual=(-fmpq(1, 90) * H**2, fmpq(1, 70) * H**2 - fmpq(1, 110) * H * R**3, fmpq(1, 130) * H**3 * R),
)
NORM = Norm(SERIES, fmpq(1), fmpq(1, 2))
RECTANGLE = Rectangle(fmpq(1, 2), fmpq(3, 4))
START = Start(fmpq(4, 9), fmpq(1, 200), arb("0.015625"), 1, fmpq(1, 2))
GROWTH = Growth(fmpq(-2), DAMPING, less(0, 1), 1, "")  # Lemma 1 for granted: Theorem B rests on the numbers alone
LARGEST = fmpq(1, 5)


@pytest.fixture(autouse=True)
def _digits() -> Any:
    with mpmath.workdps(DIGITS), working_bits(FINE):
        yield


def number(value: fmpq | int) -> mpf:
    return mpf(int(value.p)) / int(value.q) if isinstance(value, fmpq) else mpf(value)


def in_mpmath(value: arb) -> mpf:
    mantissa, exponent = value.mid().man_exp()
    return mpf(int(mantissa)) * mpf(2) ** int(exponent)


def rational(value: mpf) -> fmpq:
    return fmpq(int(mpmath.nint(value * mpf(2) ** 150)), 2**150)


def agrees(found: arb, wanted: mpf) -> bool:
    """An upper bound without a radius, at most 10^-40 of itself too large."""
    excess = in_mpmath(found) - wanted
    return bool(found.is_exact() and -(mpf(10) ** -46) * abs(wanted) <= excess <= mpf(10) ** -40 * abs(wanted))


def summed(polynomial: fmpq_mpoly, h: mpf, r: mpf, size: Callable[[mpf], mpf]) -> mpf:
    return sum((size(number(c)) * h**i * r**n for (i, n), c in terms_of(polynomial).items()), mpf(0))


def upper_part(sign: int) -> mpf:
    h, r = number(RECTANGLE.h), number(RECTANGLE.r)
    return summed(SERIES.w, h, r, lambda c: max(sign * c, mpf(0)))


def share() -> mpf:
    """c_W of (5): here m is largest as it falls, at h = h_1."""
    m, n = (number(BETA) - mpf(1) / 2) / 2 * number(RECTANGLE.h), number(RECTANGLE.r)
    assert m > mpf(9) / 100 * number(RECTANGLE.r)
    return 1 / mpmath.sqrt(1 - m**2 / (mpf(6) / 5) - n**2 * mpf(9) / 5 / 100)


def rate(largest: fmpq = LARGEST) -> mpf:
    """Gamma = Gamma_E + beta + beta sup w^+ + beta c_W z_max."""
    beta = number(BETA)
    return -2 + beta + beta * upper_part(1) + beta * share() * number(largest)


def place(start: Start, h: mpf) -> mpf:
    return mpmath.cbrt((number(start.e) / h) ** 2)


def layer_by_page(start: Start, h: mpf, gamma: mpf) -> mpf:
    p, last = number(start.p), place(start, h)
    return (
        in_mpmath(start.z) * (p / last) ** gamma * mpmath.exp(-number(DAMPING) * (p**2 - last**2) / 2 / number(start.e))
    )


def found(start: Start = START, largest: fmpq = LARGEST) -> Tube | str:
    return tube(NORM, GROWTH, RECTANGLE, start, largest)


def good(start: Start = START, largest: fmpq = LARGEST) -> Tube:
    tried = found(start, largest)
    assert isinstance(tried, Tube), tried
    return tried


def steady() -> mpf:
    """Z(h_1, r_1)."""
    h, r = number(RECTANGLE.h), number(RECTANGLE.r)
    return sum((in_mpmath(c) * h**i * r**n for (i, n), c in good().barrier.items()), mpf(0))


def test_the_rate_is_that_of_the_page() -> None:
    assert agrees(good().rate, rate())
    assert agrees(good(largest=fmpq(1, 4)).rate, rate(fmpq(1, 4)))


@pytest.mark.parametrize("h", [fmpq(1, 2), fmpq(1, 5), fmpq(1, 20)])
def test_the_layer_is_that_of_the_page(h: fmpq) -> None:
    """Also near the start, where p is not small beside p_1."""
    for e in (fmpq(1, 60), fmpq(1, 8)):
        start = replace(START, e=e, z=arb("0.3125"))
        assert agrees(layer(start, arb(h), arb("2.5"), DAMPING), layer_by_page(start, number(h), mpf("2.5")))


def test_the_tube_is_made_of_the_steady_part_and_the_layer() -> None:
    one, h, r = good(), fmpq(1, 3), fmpq(2, 5)
    h_1 = number(RECTANGLE.h)
    z = sum((in_mpmath(c) * h_1**i * number(r) ** n for (i, n), c in one.barrier.items()), mpf(0))
    falling = layer_by_page(START, number(h), rate())
    assert falling > mpf(10) ** -6 * z > 0
    assert agrees(one.bound(arb(h), arb(r)), z + falling)
    assert agrees(one.layer(arb(h)), falling)


@pytest.mark.parametrize(("e", "longer"), [(fmpq(1, 60), True), (fmpq(7, 60), False)])
def test_the_integral_of_the_layer(e: fmpq, longer: bool) -> None:
    """(11) by its formula, with U = log(p_1/p_S) and with U = 2/3, above the integral by quadrature."""
    start, gamma = replace(START, e=e, z=arb("0.3125")), mpf("0.03125")
    p, h = number(START.p), number(RECTANGLE.h)
    last = place(start, h)
    reach = mpmath.log(p / last)
    assert (reach > mpf(2) / 3) is longer
    slope = number(DAMPING) * (p**2 - last**2) / (2 * number(e) * max(reach, mpf(2) / 3)) - gamma
    value = layer_integral(start, RECTANGLE, arb("0.03125"), DAMPING)
    assert agrees(value, mpf("0.3125") / slope)

    def inner(log_p: mpf) -> mpf:
        q = mpmath.exp(log_p)
        return mpf("0.3125") * (p / q) ** gamma * mpmath.exp(-number(DAMPING) * (p**2 - q**2) / 2 / number(e))

    assert in_mpmath(value) >= mpmath.quad(inner, [mpmath.log(last), mpmath.log(p)])


def test_a_layer_that_is_not_damped_has_no_bound() -> None:
    assert not layer_integral(START, RECTANGLE, arb(9), DAMPING).is_finite()
    p, last = number(START.p), place(START, number(RECTANGLE.h))
    edge = number(DAMPING) * (p**2 - last**2) / (2 * number(START.e) * mpmath.log(p / last))
    near = mpf(10) ** -20
    assert layer_integral(START, RECTANGLE, arb(rational(edge - near)), DAMPING).is_finite()
    assert not layer_integral(START, RECTANGLE, arb(rational(edge + near)), DAMPING).is_finite()


def test_the_drift_is_that_of_the_page() -> None:
    """beta c_W times r_1^(n - n') A h_1^i r_S^n'/((3i - n')/2), n' = min(n, 3i - 1), summed, and the layer's."""
    terms = {(2, 0): "1.5", (2, 3): "0.75", (1, 2): "0.375", (1, 3): "2.5", (2, 9): "0.625"}
    one = replace(good(), barrier={key: arb(value) for key, value in terms.items()})
    h, r, last = number(RECTANGLE.h), number(RECTANGLE.r), mpf(1) / 8
    total = in_mpmath(layer_integral(START, RECTANGLE, one.rate, DAMPING))
    assert total > mpf(10) ** -6
    for (i, n), value in terms.items():
        least = min(n, 3 * i - 1)
        total += r ** (n - least) * mpf(value) * h**i * last**least / (mpf(3 * i - least) / 2)
    assert agrees(one.drift(arb("0.125")), number(BETA) * share() * total)


def test_the_start_and_the_source_are_those_of_the_page() -> None:
    """(8), and |R|/e of (6) monomial by monomial."""
    p, e, within = fmpq(1, 3), fmpq(1, 50), fmpq(1, 7)
    root = mpmath.sqrt(number(p))
    h = number(e) / root**3
    parts = [summed(one, h, root, abs) for one in (SERIES.v, SERIES.w, SERIES.f)]
    lengths = mpmath.sqrt(mpf(6) / 5), mpf(1), 10 / mpmath.sqrt(mpf(9) / 5)
    wanted = 3 * number(within) + lengths[0] * parts[0] / root + parts[1] + lengths[2] * parts[2] * root
    assert agrees(start_bound(SERIES, p, e, within), wanted)

    total: dict[tuple[int, int], mpf] = {}
    for length, polynomial in zip(lengths, SERIES.residual, strict=True):
        for key, c in terms_of(polynomial).items():
            total[key] = total.get(key, mpf(0)) + length * abs(number(c))
    given = source(SERIES)
    assert given.keys() == total.keys()
    assert any(sum(key in terms_of(one) for one in SERIES.residual) > 1 for key in total)
    assert all(agrees(given[key], value) for key, value in total.items())


def test_the_extent_is_that_of_the_terms_of_one_sign() -> None:
    for sign in (1, -1):
        assert agrees(extent(SERIES.w, RECTANGLE, sign), upper_part(sign))


E_1 = RECTANGLE.h * fmpq(8, 27)  # h_1 p_1^(3/2)
NEAR = mpf(10) ** -30


def test_the_hand_over_must_lie_after_the_start() -> None:
    text = "the hand-over lies before the start"
    for e, refused in ((E_1, True), (E_1 * (1 - fmpq(1, 10**30)), False)):
        assert (text in str(found(replace(START, e=e)))) is refused
        assert isinstance(found(replace(START, e=e)), str)


def test_the_layer_must_fall_with_epsilon() -> None:
    """theta p_1^2/(2 e_0) > 2 Gamma/3."""
    text = "the layer falls with epsilon"
    edge = 3 * number(DAMPING) * number(START.p) ** 2 / (4 * rate())
    for factor, refused in ((1 + NEAR, True), (1 - NEAR, False)):
        assert (text in str(found(replace(START, e=rational(edge * factor))))) is refused


@pytest.mark.parametrize("where", ["start", "hand-over"])
def test_the_barrier_must_stay_below_z_max(where: str) -> None:
    """Z(h_1, r_1) + z_0 and Z(h_1, r_1) + I(p_S): the layer may be larger at either end."""
    e = fmpq(1, 100) if where == "start" else fmpq(1, 9)
    start = replace(START, e=e, z=arb(1))
    at_end = layer_by_page(start, number(RECTANGLE.h), rate())
    assert (at_end < 1) is (where == "start")
    edge = (number(LARGEST) - steady()) / max(at_end, mpf(1))
    assert edge > 0
    for factor, refused in ((1 + NEAR, True), (1 - NEAR, False)):
        text = str(found(replace(start, z=arb(rational(edge * factor)))))
        assert (f"at the {where} stays below 1/5" in text) is refused


def test_a_positive_deviation_must_keep_its_force() -> None:
    """sup w^- + c_W z_max < 1."""
    edge = (1 - upper_part(-1)) / share()
    for factor, refused in ((1 + NEAR, True), (1 - NEAR, False)):
        text = str(found(largest=rational(edge * factor)))
        assert ("the force stays positive" in text) is refused
        assert "the deviation falls" not in text


def test_a_negative_deviation_must_fall_with_p() -> None:
    """beta (sup w^- + c_W z_max) < beta - 1."""
    edge = ((number(BETA) - 1) / number(BETA) - upper_part(-1)) / share()
    for factor, refused in ((1 + NEAR, True), (1 - NEAR, False)):
        text = str(found(replace(START, side=-1), largest=rational(edge * factor)))
        assert ("the deviation falls with p" in text) is refused


def test_a_negative_deviation_must_be_smaller_than_the_force() -> None:
    """|L| (1 + sup w^+ + c_W z_max) < the mean force."""
    edge = 1 / (1 + upper_part(1) + share() * number(LARGEST))
    for factor, refused in ((1 + NEAR, True), (1 - NEAR, False)):
        text = str(found(replace(START, side=-1, share=rational(edge * factor))))
        assert ("the force stays positive" in text) is refused


def test_each_reason_is_said() -> None:
    both = str(found(replace(START, side=-1, share=fmpq(3), e=E_1)))
    assert both.startswith("not certain: the hand-over lies before the start; ")
    assert "; the force stays positive" in both


def test_the_start_is_in_the_rectangle_and_epsilon_is_positive() -> None:
    last = RECTANGLE.r**2
    assert isinstance(found(replace(START, p=last)), Tube)
    for p, e in ((last + fmpq(1, 10**30), START.e), (fmpq(0), START.e), (START.p, fmpq(0)), (START.p, fmpq(-1))):
        with pytest.raises(ValueError, match="p_1 must be at most"):
            found(replace(START, p=p, e=e))


def test_what_is_paid_at_the_edges() -> None:
    """theta = 1/4. E = Gamma is not paid by itself, nor is what is below it or nearly so; what has no r left is."""
    damping = fmpq(1, 4)
    assert isinstance(paid({(2, 0): arb(1)}, arb(3), damping), str)
    assert paid({(1, 1): arb(1)}, arb("2.75"), damping) == {(2, 0): arb(4)}  # E = 1, then 3
    assert paid({(2, 1): arb(1)}, arb("2.375"), damping) == {(3, 0): arb(4)}  # E = 5/2: too near
    assert paid({(3, 2): arb(1)}, arb("1.5"), damping) == {(3, 2): arb("0.5")}  # E = 7/2
    assert paid({(4, 0): arb(1)}, arb("5.875"), damping) == {(4, 0): arb(8)}  # E = 6: near, but nothing else pays
    # E = -1/2, then 3/2: 4 h^2 r^3 with the deficit 2 * 4, which is 32 h^3 r^2 at E = 7/2
    assert paid({(1, 4): arb(1)}, arb("3.5"), damping) == {(2, 3): arb(4), (3, 2): arb(32)}
    assert paid({(1, 4): arb(1), (2, 3): arb(1)}, arb("3.5"), damping) == {(2, 3): arb(4), (3, 2): arb(36)}
    assert paid({(3, 2): arb(1), (2, 3): arb(1)}, arb("1.5"), damping) == {(3, 2): arb("4.5")}


def test_the_product_of_two_sums() -> None:
    """(2 h + 3 h^2 r)(5 r^2 + 7 h r): like monomials are added."""
    first, second = {(1, 0): arb(2), (2, 1): arb(3)}, {(0, 2): arb(5), (1, 1): arb(7)}
    assert times(first, second) == {(1, 2): arb(10), (2, 1): arb(14), (2, 3): arb(15), (3, 2): arb(21)}
    twice = times({(0, 1): arb(2), (1, 0): arb(3)}, {(0, 1): arb(5), (1, 0): arb(7)})
    assert twice == {(0, 2): arb(10), (1, 1): arb(29), (2, 0): arb(21)}


def coarse_and_fine(bound: Callable[[], arb | Mapping[Any, arb]]) -> list[tuple[arb, arb]]:
    values = []
    for bits in (COARSE, FINE):
        with working_bits(bits):
            value = bound()
            values.append(list(value.values()) if isinstance(value, Mapping) else [value])
    return list(zip(*values, strict=True))


def bounds() -> dict[str, Callable[[], Any]]:
    one = good()
    return {
        "source": lambda: source(SERIES),
        "start": lambda: start_bound(SERIES, fmpq(1, 3), fmpq(1, 50), fmpq(1, 7)),
        "paid": lambda: paid({(1, 4): arb(fmpq(1, 7)), (4, 0): arb(fmpq(1, 7))}, one.rate + 2, fmpq(1, 3)),
        "extent": lambda: extent(SERIES.w, RECTANGLE, 1),
        "layer": lambda: one.layer(arb(fmpq(1, 3))),
        "integral": lambda: layer_integral(START, RECTANGLE, arb("0.03125"), DAMPING),
        "tube": lambda: one.bound(arb(fmpq(1, 3)), arb(fmpq(2, 5))),
        "drift": lambda: one.drift(arb("0.125")),
        "rate": lambda: good().rate,
    }


def test_with_few_bits_a_bound_is_larger() -> None:
    for name, bound in bounds().items():
        pairs = coarse_and_fine(bound)
        assert pairs
        assert all(fine < coarse < fine * arb("1.001") for coarse, fine in pairs), name


def test_of_wide_balls_the_largest_number_counts() -> None:
    """r in a ball; Gamma in [3, 4], where 4 h^2 r^3 has E = 3/2 and 40 h^3 r^2 has E = 7/2, perhaps below Gamma."""
    one = good()
    assert one.drift(arb("0.125", "0.0625")) >= one.drift(arb("0.1875"))
    terms = paid({(1, 4): arb(1)}, arb("3.5", "0.5"), fmpq(1, 4))
    assert isinstance(terms, dict)
    for key, least in (((2, 3), 4), ((3, 2), 40), ((4, 1), 80)):
        assert least <= terms.pop(key) < least + arb("0.001")
    assert not terms
    with working_bits(COARSE):  # the sum of two bounds is rounded up, too
        half = replace(one, barrier={(1, 0): arb(1)}, start=replace(START, z=arb((1, -90))))
        assert half.bound(arb("0.25"), arb(1)) > fmpq(1, 2)


def test_a_norm_that_is_none_gives_no_tube() -> None:
    wide = Rectangle(fmpq(9), RECTANGLE.r)
    assert tube(NORM, GROWTH, wide, START, LARGEST) == "the norm is not certainly positive definite"
