"""Certificates of the number of zeros at finite epsilon: the bound against the exact solution, good and wrong ones.

Pages: proofs/finite_epsilon_zeros.md, section 4 (f); proofs/certificate.md.
"""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from must_reject.mutate import checker, mutated, state, text_of
from samples.strategies import to_fmpq

from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.compliant.zeros.force_certificate import NotProvable
from gspot_verified.compliant.zeros.zero_certificate import _bound, _cut, _place, slow_zeros_certificate
from gspot_verified.compliant.zeros.zero_count import slow_zeros
from gspot_verified.numbers.balls import working_bits

check = checker()
ROOT = Path(__file__).resolve().parents[3]


def lines(text: str) -> list[Any]:
    return [json.loads(line) for line in text.splitlines()[:-1]]


GOOD = slow_zeros_certificate("9/2..37/8", 10)


@given(
    st.fractions(Fraction(3), Fraction(4), max_denominator=64),
    st.fractions(Fraction(1, 4), Fraction(3), max_denominator=16),
    st.sampled_from([Fraction(1, 100), Fraction(1, 2), Fraction(1), Fraction(17, 10)]),
)
@example(Fraction(4), Fraction(3, 2), Fraction(17, 10))
@example(Fraction(3), Fraction(3, 2), Fraction(17, 10))
def test_the_bound_is_above_the_exact_solution(b: Fraction, tau: Fraction, eta: Fraction) -> None:
    exact_b, place, scale = to_fmpq(b), to_fmpq(tau), to_fmpq(eta)
    force = slow_value(place / scale, exact_b, 2 * scale**3, digits=20).value
    with working_bits(100):
        value = force * arb(scale) ** exact_b
        bound = _bound(place, arb(exact_b), scale)
        assert value.is_finite()
        assert bound.is_finite()
        assert not bound < value - arb(10) ** -9
        # It tends to the value at leading order, and is never far from the truth for small eta.
        assert eta > Fraction(1, 100) or abs(bound - value) < arb("0.2")


def test_at_4_it_is_the_exact_value_plus_what_the_exponential_adds() -> None:
    """b = 4: the lemma's integrand gives Theta + 3 eta ((1 - mu^3)/(3 gamma)) = Theta + 3 eta, which is exact."""
    with working_bits(80):
        for eta in (fmpq(1, 10), fmpq(5, 3)):
            expected = arb(fmpq(81, 16)) - 8 * arb(fmpq(3, 2)) + 3 * arb(eta)
            assert abs(_bound(fmpq(3, 2), arb(4), eta) - expected) < arb(10) ** -8


def test_what_is_found_is_verified() -> None:
    text = check.main.check_text(GOOD.text().encode())
    assert text.startswith(
        "for every β in (9/2, 37/8) that is not an integer, every ε in (0, 10], on the slow manifold"
    )
    for beta in ("9/2", "4.55", "37/8"):
        assert slow_zeros(beta, 10, 2).number == 2


def test_a_place_that_does_not_serve_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The order of the places is that of floats; the one that it chooses is taken by a certain comparison alone."""
    lower, upper, eta = fmpq(7, 2), fmpq(1793, 512), fmpq(17, 10)
    place = _place(lower, upper, eta)
    assert place is not None
    assert _bound(place, arb(lower), eta) < 0
    monkeypatch.setattr("gspot_verified.compliant.zeros.zero_certificate.min", max, raising=False)
    assert _place(lower, upper, eta) is None


def test_the_one_in_the_repository() -> None:
    data = (ROOT / "proofs" / "zeros_4_5.cert").read_bytes()
    assert "for every β in (4, 5) that is not an integer, every ε in (0, 10]," in check.main.check_text(data)
    assert slow_zeros_certificate("4..5", 10).text().encode() == data


def test_it_is_written_as_a_file(tmp_path: Path) -> None:
    GOOD.write(tmp_path / "zeros.cert")
    assert (tmp_path / "zeros.cert").read_bytes() == GOOD.text().encode()


@pytest.mark.parametrize(
    ("lower", "upper"), [("4", "5"), ("9/2", "73/16"), ("65/16", "131/32"), ("401/100", "402/100")]
)
def test_a_range_is_cut_at_the_multiples_of_a_sixteenth(lower: str, upper: str) -> None:
    ends = to_fmpq(Fraction(lower)), to_fmpq(Fraction(upper))
    parts = _cut(*ends)[::-1]
    assert (parts[0][0], parts[-1][1]) == ends
    assert all(first[1] == second[0] for first, second in pairwise(parts))
    assert all((16 * first[1]).q == 1 for first in parts[:-1])
    assert all(0 < b - a <= fmpq(1, 16) for a, b in parts)


def test_one_beta() -> None:
    found = lines(GOOD.text())
    found[0]["statement"]["beta"] = "[73/16, 73/16]"
    last = [line for line in found[1:] if Fraction(line["beta"][0]) <= Fraction(73, 16) <= Fraction(line["beta"][1])]
    assert "at β = 73/16, every ε in (0, 10]" in check.main.check_text(text_of([found[0], *last]))


def _dip(first: str, second: str) -> Any:
    return lambda found: found[1].update(pieces=[["dip", first, second]])


WRONG = [
    ("a larger epsilon", state(epsilon="11"), "2 η³ is less than ε"),
    ("a smaller eta", state(eta="17/10"), "2 η³ is less than ε"),
    ("beyond what the bound can show", state(epsilon="31", eta="5/2"), "is not confirmed"),
    ("a negative eta", state(eta="-2"), "ε or η is not positive"),
    ("a negative epsilon", state(epsilon="-1"), "ε or η is not positive"),
    ("epsilon 0", state(epsilon="0"), "ε or η is not positive"),
    ("beta below 4", state(beta="(7/2, 37/8)"), "not inside [4, 5]"),
    ("beta beyond 5", state(beta="(9/2, 41/8)"), "not inside [4, 5]"),
    ("all beta", state(beta="(-inf, inf)"), "not inside [4, 5]"),
    ("one integer", state(beta="[5, 5]"), "one integer"),
    ("a wider range", state(beta="(4, 37/8)"), "do not cover the whole range"),
    ("a range with another end", state(beta="(9/2, 5)"), "do not cover the whole range"),
    ("a place where G > 0", _dip("7/64", "9/64"), "is not confirmed"),
    ("a place far out", _dip("7", "9"), "is not confirmed"),
    ("a ratio whose cube is more than 1/2", _dip("4/3", "5/3"), "2 t1³ ≤ t2³"),
    ("a negative place", _dip("-1", "2"), "t1 > 0"),
    ("a place at 0", _dip("0", "2"), "t1 > 0"),
    ("two pieces", lambda found: found[1]["pieces"].append(["dip", found[1]["pieces"][0][2], "4"]), "not one piece"),
    ("a piece sign", lambda found: found[1].update(pieces=[["sign", "1", "2", -1]]), "not one piece dip"),
    ("a long denominator", lambda found: found[1]["beta"].__setitem__(0, "40960/9103"), "denominator beyond 4096"),
    ("a column in two cells", lambda found: found[1]["beta"].__setitem__(0, "31/8"), "crosses an integer"),
    ("a column left out", lambda found: found.pop(2), "a gap between columns"),
    ("a column twice", lambda found: found.insert(1, found[1]), "an overlap of columns"),
    ("no column", lambda found: found.__delitem__(slice(1, None)), "do not cover"),
    ("another kind", state(kind="zeros"), "unknown kind"),
    ("version 2", lambda found: found[0].update(version=2), "the hypotheses are not the pages"),
    ("a page less", lambda found: found[0]["hypotheses"].pop(), "the hypotheses are not the pages"),
    ("a key more", state(more="1"), "has not the keys"),
]


@pytest.mark.parametrize(("name", "mutation", "message"), WRONG, ids=[name for name, *_ in WRONG])
def test_wrong_ones_are_rejected(name: str, mutation: Any, message: str) -> None:
    assert name
    with pytest.raises(check.limits.Rejected) as raised:
        check.main.check_text(mutated(lines(GOOD.text()), mutation))
    assert message in str(raised.value)


def test_a_column_is_more_than_its_middle() -> None:
    """At epsilon = 31, tau = 2 the bound is negative at beta = 17/4 and positive at 9/2."""
    header = lines(GOOD.text())[0]
    header["statement"] |= {"epsilon": "31", "eta": "5/2"}

    def over(lower: str, upper: str) -> bytes:
        header["statement"]["beta"] = f"[{lower}, {upper}]"
        return text_of([header, {"beta": [lower, upper], "pieces": [["dip", "2", "18/7"]]}])

    assert "at β = 17/4, every ε in (0, 31]" in check.main.check_text(over("17/4", "17/4"))
    for lower, upper in (("4", "9/2"), ("17/4", "9/2"), ("9/2", "9/2")):
        with pytest.raises(check.limits.Rejected, match="is not confirmed"):
            check.main.check_text(over(lower, upper))


def test_a_dip_gives_no_sign() -> None:
    column = check.pieces.Column(Fraction(9, 2), Fraction(73, 16), 3, [check.pieces.read_piece(["dip", "3/2", "2"])])
    with pytest.raises(check.limits.Rejected, match="a piece dip gives no sign"):
        check.pieces.ColumnCheck(column, check.limits.Limits(), 10**9).piece_sign(column.pieces[0])


@pytest.mark.parametrize(("base", "exponent"), [("7/9", "5/2"), ("1/2", "2"), ("3/4", "147/64"), ("1/3", "0")])
def test_powers_between_neighbours(base: str, exponent: str) -> None:
    low, high = check.force.power_between(
        Fraction(base), Fraction(exponent), 60, check.limits.Meter(check.limits.Limits(), 10**9)
    )
    true = float(Fraction(base)) ** float(Fraction(exponent))
    assert high - low == Fraction(1, 2**60)
    assert abs(float(low) - true) < 1e-15
    with working_bits(200):
        exact = arb(to_fmpq(Fraction(base))) ** to_fmpq(Fraction(exponent))
        assert arb(to_fmpq(low)) <= exact + arb(10) ** -40
        assert exact <= arb(to_fmpq(high)) + arb(10) ** -40


def test_a_power_below_the_unit_is_between_0_and_the_unit() -> None:
    found = check.force.power_between(
        Fraction(1, 10**30), Fraction(4), 60, check.limits.Meter(check.limits.Limits(), 10**9)
    )
    assert found == (0, Fraction(1, 2**60))


@pytest.mark.parametrize("base", ["7/9", "1/3", f"{10**40 + 1}/{10**40 + 9}"])
@pytest.mark.parametrize("exponent", ["3", "13/4", "31/8", "1/8"])
@pytest.mark.parametrize("bits", [30, 59, 120])
def test_the_work_of_a_power_is_paid_before_it_is_done(base: str, exponent: str, bits: int) -> None:
    """In each step two integers of the size of 2^(bits n) base^h are made: a product of their digits for each bit."""
    number, power, budget = Fraction(base), Fraction(exponent), 10**15
    meter = check.limits.Meter(check.limits.Limits(), budget)
    assert check.force.power_between(number, power, bits, meter)
    size = check.limits.digits(number.denominator**power.numerator << (bits * power.denominator))
    assert budget - meter.left >= bits * size**2
    assert budget - meter.left <= bits * (2 * size + 2 * (power.numerator + power.denominator)) ** 2 + 10**4 * bits
    with pytest.raises(check.limits.Rejected, match="work"):
        check.force.power_between(number, power, bits, check.limits.Meter(check.limits.Limits(), bits * size**2 - 1))


@pytest.mark.parametrize(
    ("beta", "epsilon", "message"),
    [
        ("3..5", 1, "inside"), ("4..6", 1, "inside"), ("9/2", 1, "inside"), ("4..inf", 1, "beta"),
        ("4..5", 0, "epsilon"), ("4..5", -1, "epsilon"), ("4..5", arb(1, 1), "one exact"),
    ],
)  # fmt: skip
def test_refused(beta: str, epsilon: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        slow_zeros_certificate(beta, epsilon)  # type: ignore[arg-type]


def test_where_the_bound_is_too_weak() -> None:
    with pytest.raises(NotProvable, match="next to β = "):
        slow_zeros_certificate("9/2..37/8", 30)


class Parts(check.pieces.ColumnCheck):  # type: ignore[misc, name-defined]
    """A column on which F(t1), F'(t1), F'(t2) are given: (value, what b adds, error), once for each accuracy.

    Each comes in a scale of its own, which only what is given tells.
    """

    scales = Fraction(1), Fraction(3, 7), Fraction(10**9)
    units = (4, 20), (4, 20), (4, 20)

    def __init__(self, beta: tuple[Fraction, Fraction], *given: list[tuple[Fraction, Fraction, Fraction]]) -> None:
        super().__init__(check.pieces.Column(*beta, 3, []), check.limits.Limits(), 10**9)
        self.given, self.asked = given, []

    def value(self, box: Any, order: int, bits: int) -> Any:
        low, high, tau, same = box
        assert (low, high, tau) == (self.column.start - 1, self.column.end - 1, same)
        self.asked.append((tau, order, bits))
        accuracies = list(dict.fromkeys(bits for *_, bits in self.asked))
        values = self.given[min(len(accuracies), len(self.given)) - 1]
        place = (len(self.asked) - 1) % 3
        scale = self.scales[place]
        middle, in_b, error = (part * scale for part in values[place])
        return check.theta.Value(middle, Fraction(0), in_b, error, check.theta.Scale(*self.units[place], scale))


def at_the_edge(*values: str, slacks: tuple[int, int, int] = (0, 0, 0)) -> tuple[Any, ...]:
    """β in [4, 9/2], μ = 4/5, η = 3: one unit of F'(t2) moves the bound by 1.32 to 1.48, one of F'(t1) by 2.3."""
    balls = [(Fraction(value), Fraction(slack)) for value, slack in zip(values, slacks, strict=True)]
    return balls, Fraction(4), Fraction(1, 2), Fraction(1), Fraction(5, 4), Fraction(3)


NUMBERS = st.fractions(Fraction(-2), Fraction(2), max_denominator=8)
SIZES = st.sampled_from([Fraction(0), Fraction(1, 8), Fraction(1)])


@given(
    st.lists(st.tuples(NUMBERS, SIZES), min_size=3, max_size=3),
    st.fractions(Fraction(4), Fraction(5), max_denominator=8),
    st.fractions(Fraction(0), Fraction(1, 2), max_denominator=8),
    st.fractions(Fraction(1, 2), Fraction(6), max_denominator=4),
    st.fractions(Fraction(5, 4), Fraction(4), max_denominator=4),
    st.fractions(Fraction(1, 4), Fraction(3), max_denominator=8),
)
@example(*at_the_edge("-1", "0", "0", slacks=(0, 0, 1)))
@example(*at_the_edge("-1", "0", "0", slacks=(0, 1, 0)))
@example(*at_the_edge("-1", "0", "0", slacks=(1, 0, 0)))
@example(*at_the_edge("-7/5", "0", "1"))
@example(*at_the_edge("7/5", "0", "-1"))
@example(*at_the_edge("-3/2", "0", "1"))
@example(*at_the_edge("5/4", "0", "-1"))
def test_the_bound_is_the_largest_value_of_all_balls(
    balls: list[tuple[Fraction, Fraction]],
    beta: Fraction,
    width: Fraction,
    t1: Fraction,
    ratio: Fraction,
    eta: Fraction,
) -> None:
    """Decided as by the greatest of F(t1) + η/(8γ) [μ^(β-2) F'(t2) - F'(t1)], γ = (1 - μ³)/3, over all corners."""
    column = Parts((beta, beta + width), [(value, size, Fraction(0)) for value, size in balls])
    mu = float(1 / ratio)
    weight = float(eta) / (8 * (1 - mu**3) / 3)
    (f, g, h) = ([float(value - size), float(value + size)] for value, size in balls)
    corners = [mu ** (float(b) - 2) * y for y in h for b in (beta, beta + width)]
    largest = max(f) + weight * (max(corners) - min(g))
    if abs(largest) > 1e-9:
        assert check.force.dips(column, t1, t1 * ratio, eta) is (largest < 0)
        assert {(tau, order) for tau, order, _ in column.asked} == {(t1, 0), (t1, 1), (t1 * ratio, 1)}


def test_errors_ask_for_more_bits_and_widths_do_not() -> None:
    """F(t1) = -1 with a slack of 3: of errors, until they are small; of the range of b, never."""
    beta, nothing = (Fraction(9, 2), Fraction(9, 2)), (Fraction(0), Fraction(0), Fraction(0))

    def bits_of(*slacks: tuple[Fraction, Fraction]) -> tuple[bool, list[int]]:
        column = Parts(beta, *([(Fraction(-1), *slack), nothing, nothing] for slack in slacks))
        answer = check.force.dips(column, Fraction(1), Fraction(2), Fraction(1))
        return answer, list(dict.fromkeys(bits for *_, bits in column.asked))

    wide, vague, sharp = (Fraction(3), Fraction(0)), (Fraction(0), Fraction(3)), (Fraction(0), Fraction(0))
    assert bits_of(sharp) == (True, [64])
    assert bits_of(wide) == (False, [64])
    assert bits_of(vague, vague, sharp) == (True, [64, 96, 144])
    assert bits_of(vague, wide) == (False, [64, 96])
    assert bits_of((Fraction(9, 4), Fraction(3, 4))) == bits_of(vague)
    assert bits_of((Fraction(12, 5), Fraction(3, 5))) == bits_of(vague)
    assert bits_of((Fraction(5, 2), Fraction(1, 2))) == bits_of(wide)
    far = [(Fraction(9), *vague), nothing, nothing]
    column = Parts(beta, far)
    assert not check.force.dips(column, Fraction(1), Fraction(2), Fraction(1))
    assert {bits for *_, bits in column.asked} == {64}, "9 with a slack of 3 is not below 0 at any accuracy"
    zero = Parts(beta, [nothing, nothing, nothing])
    assert not check.force.dips(zero, Fraction(1), Fraction(2), Fraction(1)), "0 is not below 0"
    answer, tried = bits_of(vague)
    limit = check.limits.Limits().bits
    assert answer is False
    assert tried[-2] < limit <= tried[-1]


def test_what_is_known_in_different_scales_is_not_added() -> None:
    nothing = (Fraction(0), Fraction(0), Fraction(0))
    for units in ([(4, 20), (4, 20), (4, 21)], [(4, 20), (6, 20), (4, 20)]):
        column = Parts((Fraction(9, 2), Fraction(9, 2)), [(Fraction(-1), *nothing[1:]), nothing, nothing])
        assert check.force.dips(column, Fraction(1), Fraction(2), Fraction(1))
        column.units = units
        with pytest.raises(check.limits.Rejected, match="different scales"):
            check.force.dips(column, Fraction(1), Fraction(2), Fraction(1))


@pytest.mark.parametrize(
    ("beta", "first", "second", "message"),
    [
        (("9/2", "73/16"), "1/2", "2/3", ""),
        (("9/2", "73/16"), "1/2", "3/5", "2 t1³ ≤ t2³"),
        (("9/2", "73/16"), "5", "63/10", ""),
        (("9/2", "73/16"), "5", "31/5", "2 t1³ ≤ t2³"),
        (("18001/4096", "18001/4096"), "3/2", "2", ""),
        (("18001/4097", "73/16"), "3/2", "2", "denominator beyond 4096"),
        (("9/2", "19001/4097"), "3/2", "2", "denominator beyond 4096"),
        (("9/2", "73/16"), "100000", "200000", "limit tau"),
    ],
)
def test_what_a_dip_must_be(
    beta: tuple[str, str], first: str, second: str, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On a column on which every bound holds for η > 0, and none for η = 0."""
    column = check.pieces.Column(*map(Fraction, beta), 3, [check.pieces.read_piece(["dip", first, second])])
    asked = check.pieces.ColumnCheck(column, check.limits.Limits(), 10**9)

    def dips(given: object, *points: Fraction) -> bool:
        assert given is asked
        assert [*points[:2]] == column.pieces[0].points
        return bool(points[2])

    monkeypatch.setattr(check.force, "dips", dips)
    if message:
        with pytest.raises(check.limits.Rejected, match=message):
            check.force.dip_holds(asked, Fraction(1))
    else:
        check.force.dip_holds(asked, Fraction(1))
        with pytest.raises(check.limits.Rejected, match="is not confirmed"):
            check.force.dip_holds(asked, Fraction(0))


@pytest.mark.parametrize(
    ("epsilon", "eta", "accepted"),
    [("1/4", "1/2", True), ("1", "1/2", False), ("2", "1", True), ("3", "1", False), ("9", "171/100", True)],
)
def test_epsilon_is_at_most_2_eta_cubed(epsilon: str, eta: str, accepted: bool) -> None:
    data = mutated(lines(GOOD.text()), state(epsilon=epsilon, eta=eta))
    if accepted:
        assert f"every ε in (0, {epsilon}]" in check.main.check_text(data)
    else:
        with pytest.raises(check.limits.Rejected, match="2 η³ is less than ε"):
            check.main.check_text(data)
