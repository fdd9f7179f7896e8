"""The checker of approaches: certificates that are right and wrong, with the reasons.

Page: proofs/approach_certificate.md.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from must_reject import mutate

check = mutate.checker()
SHIPPED = mutate.CHECKER.with_name("approach_rod.cert")
LINES = [json.loads(line) for line in SHIPPED.read_text(encoding="utf-8").splitlines()[:-1]]
LAST = len(LINES) - 1
Change = Callable[[list[Any]], object]
WAYS: dict[str, Any] = {}


def said(change: Change = lambda _: None) -> str:
    """What the checker says of the shipped certificate, changed and sealed anew."""
    lines = copy.deepcopy(LINES)
    change(lines)
    return str(check.main.check_text(mutate.text_of(lines)))


def put(*path: Any, to: Any) -> Change:
    """Another value at a path, or a function of the value there."""

    def change(lines: list[Any]) -> None:
        at: Any = lines
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = to(at[path[-1]]) if callable(to) else to

    return change


def state(*path: Any, to: Any) -> Change:
    """In the statement."""
    return put(0, "statement", *path, to=to)


def mechanism(name: str, to: Any) -> Change:
    return state("mechanism", name, to=to)


def both(*changes: Change) -> Change:
    return lambda lines: [change(lines) for change in changes]


def moved(by: str) -> Callable[[str], str]:
    return lambda text: str(Fraction(text) + Fraction(by))


@pytest.fixture
def followed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """For what is said of the end: a way with the same field, start and steps is not followed again."""
    follow = check.approach.follow

    def once(slip: Any, box: Any, numbers: Any, lines: Any) -> Any:
        events = {name: event.function for name, event in slip.events.items()}
        way = repr((slip.rates, events, box, numbers.bits, lines))
        if way not in WAYS:
            WAYS[way] = follow(slip, box, numbers, lines)
        return WAYS[way]

    monkeypatch.setattr(check.approach, "follow", once)


def test_the_shipped_certificate_says_what_it_proves() -> None:
    assert said() == (
        "the mechanism M q'' = f + λ_N dy/dq + λ_T dx/dq with q = (X, Y, theta), sin(theta_ref) = 3/5, "
        "cos(theta_ref) = 4/5, M = (1, 0, 0; 0, 1, 0; 0, 0, 1/3), f = (0, -3/5, 0), x = 1*X + 1*cos(theta), "
        "y = 1*Y + -1*sin(theta), μ = 73/36, in positive slip, λ_T = -μ λ_N, on the rigid contact y = 0 from "
        "X = 0, X_dot = 2, (theta-theta_ref) = -1/10, theta_dot = 9/10, t = 0: with "
        "p = dy/dq M^-1 (dy/dq - μ dx/dq) and b = y'' at λ_N = 0 it reaches a G-spot, p = b = 0, at a time "
        "t <= 0.108345949, λ_N > 0 until then, x' > 0; there X in [0.210759445, 0.210759448], X_dot in "
        "[1.807980546, 1.807981186], (theta-theta_ref) in [-0.000000002, 0.000000002], theta_dot in "
        "[0.999999606, 1.000000002], α_1 in [-4.583334194, -4.583330673], α_2 in [0.799999056, 0.800000002], "
        "α_3 in [-1.500001132, -1.499998279], β = α_3/α_1 in [0.327272288, 0.327273167], C_1 < 0"
    )


def loose(lines: list[Any]) -> None:
    """A place, α's, a β and a time with room for a neighbouring statement."""
    statement = lines[0]["statement"]
    for ranges in (statement["place"].values(), statement["alpha"], [statement["beta"]]):
        for pair in ranges:
            pair[:] = [moved("-1/10")(pair[0]), moved("1/10")(pair[1])]
    statement["time"] = "1"


ACCEPTED: list[tuple[str, Change, str]] = [
    ("a place in wider ranges", loose, "X in [0.110759445, 0.310759448]"),
    ("a slower surface", state("surface", to=["-3"]), "x' > -3"),
    ("a faster surface", state("surface", to=["6/5"]), "x' > 6/5"),
    ("nothing asked of slip", state("surface", to=[]), "provided that slip is positive until then, which is not shown"),
    ("nothing said of C_1", state("C_1", to=[]), "β = α_3/α_1 in [0.327272288, 0.327273167]"),
    ("a later time", state("time", to="7/3"), "t <= 7/3"),
]


@pytest.mark.usefixtures("followed_once")
@pytest.mark.parametrize(("change", "words"), [pytest.param(c, words, id=name) for name, c, words in ACCEPTED])
def test_what_follows_is_accepted(change: Change, words: str) -> None:
    assert words in said(change)


@pytest.mark.usefixtures("followed_once")
def test_what_is_not_shown_is_not_said() -> None:
    assert "x' >" not in said(state("surface", to=[]))
    assert "C_1" not in said(state("C_1", to=[]))


def dyadic(q: Fraction) -> list[int]:
    return [q.numerator * 2**192 // q.denominator, -192]


def whole_neighbourhood(by: str) -> Change:
    def change(lines: list[Any]) -> None:
        for pair in lines[LAST]["neighbourhood"].values():
            low, high = (Fraction(m) * Fraction(2) ** e for m, e in pair)
            pair[:] = [dyadic(low - Fraction(by)), dyadic(high + Fraction(by))]

    return change


def shrunk(name: str) -> Change:
    def change(lines: list[Any]) -> None:
        pair = lines[LAST]["neighbourhood"][name]
        low, high = (Fraction(m) * Fraction(2) ** e for m, e in pair)
        middle = (low + high) / 2
        pair[:] = [dyadic((low + 7 * middle) / 8), dyadic((high + 7 * middle) / 8)]

    return change


def cut(place: tuple[Any, ...], end: int) -> Change:
    """A range of the statement without a share next to one end."""

    def change(lines: list[Any]) -> None:
        pair = lines[0]["statement"]
        for key in place:
            pair = pair[key]
        width = Fraction(pair[1]) - Fraction(pair[0])
        pair[end] = str(Fraction(pair[end]) + (width * 3 / 4 if end == 0 else -width * 3 / 4))

    return change


SLOW_SLIP = both(*(put(LAST, "neighbourhood", name, to=[[0, 0], [3, 0]]) for name in ("X", "X_dot")))
SLOW, NODE = "a bound rises too slowly", "a bound begins below the errors"
PIECE = (5, "pieces", 0)
STATES = sorted(LINES[LAST]["neighbourhood"])
RANGES = [*(("place", name) for name in LINES[0]["statement"]["place"]), *(("alpha", k) for k in range(3)), ("beta",)]

REJECTED: list[tuple[str, Change, str]] = [
    # Steps.
    ("the first step left out", lambda lines: lines.pop(2), NODE),
    ("a step left out", lambda lines: lines.pop(7), NODE),
    ("the last step left out", lambda lines: lines.pop(LAST - 1), "may leave the neighbourhood"),
    ("no steps", lambda lines: lines.__delitem__(slice(2, LAST)), "may leave the neighbourhood"),
    ("a step twice", lambda lines: lines.insert(5, copy.deepcopy(lines[5])), NODE),
    ("two steps in another order", lambda lines: lines.insert(5, lines.pop(6)), NODE),
    ("a longer step", put(4, "h", to=lambda h: [2 * h[0], h[1]]), SLOW),
    ("a step of no length", put(4, "h", to=[0, 0]), "h or the unit"),
    ("a step back", put(4, "h", to=lambda h: [-h[0], h[1]]), "h or the unit"),
    ("another coefficient", put(4, "x", "theta_dot", 3, to=lambda c: c + 2**60), SLOW),
    ("a jump", put(4, "x", "theta_dot", 0, to=lambda c: c + 2**60), NODE),
    ("a state left out", lambda lines: lines[4]["x"].pop("X"), "has not the keys"),
    ("the time left out", lambda lines: lines[4]["x"].pop("t"), "has not the keys"),
    ("a state more", put(4, "x", "Y", to=[0]), "has not the keys"),
    ("no pieces", put(4, "pieces", to=[]), "the pieces do not fill the step"),
    ("half a step", put(4, "pieces", 0, "end", to=[1, -1]), "the pieces do not fill the step"),
    ("a node that is too small", put(*PIECE, "nodes", 0, 0, to=[1, -190]), NODE),
    ("a tube that is too small", put(*PIECE, "nodes", -1, 0, to=[1, -190]), SLOW),
    ("a negative node", put(*PIECE, "nodes", -1, 0, 0, to=lambda m: -m), "a node is not positive"),
    ("a singular basis", put(*PIECE, "basis", to=lambda S: [[0, 0]] * len(S)), "a basis is singular"),
    # The statement.
    *((f"{place} cut at {end}", cut(place, end), "may lie outside") for place in RANGES for end in (0, 1)),
    ("too early", state("time", to=moved("-1/500000000")), "may be reached after the time"),
    ("a sign of C_1 that is no list", state("C_1", to="negative"), "the sign of C_1"),
    ("a surface that slip does not keep above", state("surface", to=["13/10"]), "slip that ends is not excluded"),
    ("a surface that is faster from the start", state("surface", to=["5/2"]), "slip that ends is not excluded"),
    ("two surfaces", state("surface", to=["0", "0"]), "the surface is not"),
    ("a surface that is none", state("surface", to="0"), "the surface is not"),
    ("a surface in decimals", state("surface", to=["0.5"]), "is not a rational number"),
    ("two α's", state("alpha", to=lambda a: a[:2]), "there are not three ranges"),
    ("another kind", state("kind", to="run"), "unknown kind"),
    ("a key more", state("side", to="lift-off"), "has not the keys"),
    # The start.
    ("another start", state("start", "theta_dot", to=moved("1/1000000000000000000000")), NODE),
    ("another X", state("start", "X", to="1/1000000000000000000000"), NODE),
    ("p < 0 at the start", state("start", "(theta-theta_ref)", to="1/10"), "p is not certainly positive"),
    ("p = 0 at the start", state("start", "(theta-theta_ref)", to="0"), "p is not certainly positive"),
    ("an angle far away", state("start", "(theta-theta_ref)", to="9"), "not within 8 of its reference"),
    ("a start with Y", state("start", "Y", to="1/2"), "has not the keys"),
    ("a start without X", lambda lines: lines[0]["statement"]["start"].pop("X"), "has not the keys"),
    ("a start that is no number", state("start", "X", to=0), "more than 400 characters"),
    # The mechanism.
    ("less friction", mechanism("mu", "2"), SLOW),
    ("friction < 0", mechanism("mu", "-2"), "μ < 0"),
    ("another force", mechanism("forces", ["0", "-3/5", "1/1000000"]), SLOW),
    ("another mass", state("mechanism", "mass_matrix", 2, 2, to="1/4"), SLOW),
    ("a negative mass", state("mechanism", "mass_matrix", 2, 2, to="-1/3"), "not certainly positive definite"),
    ("no mass", state("mechanism", "mass_matrix", 2, 2, to="0"), "det M is 0"),
    ("a mass matrix that is not symmetric", state("mechanism", "mass_matrix", 0, 1, to="1"), "not symmetric"),
    ("another end of the rod", mechanism("y", "1*Y + 1*sin(theta)"), "p is not certainly positive|bound rises too"),
    ("another x", mechanism("x", "1*X + -1*cos(theta)"), SLOW),
    ("a rod without a normal coordinate", mechanism("y", "-1*sin(theta)"), "y has no coordinate"),
    ("a force that sees sin(Y)", mechanism("forces", ["1*sin(Y)", "-3/5", "0"]), "a sine of the coordinate that y"),
    ("two coordinates of one name", mechanism("coordinates", ["X", "X", "theta"]), "two coordinates have one name"),
    ("a coordinate t", mechanism("coordinates", ["t", "Y", "theta"]), "no name of a coordinate"),
    ("an angle off the circle", mechanism("angles", {"theta": ["3/5", "3/5"]}), "do not add to 1"),
    # The text.
    ("other pages", put(0, "hypotheses", to=["approach", "run_certificate"]), "the pages are not those"),
    ("the version of passages", put(0, "version", to=5), "the pages are not those"),
    ("no bits", put(1, to={}), "has not the keys"),
    ("true bits", put(1, "bits", to=True), "the number of bits"),
    ("few bits", put(1, "bits", to=63), "the number of bits"),
    ("fewer bits", put(1, "bits", to=128), "is not a number|a number is too large|h or the unit"),
    ("a boolean in a number", put(4, "h", to=lambda h: [True, h[1]]), "is not a number"),
    ("a true unit", put(4, "unit", to=True), "h or the unit"),
    ("a coefficient that is none", put(4, "x", "X", 0, to=True), "a coefficient"),
    ("blocks that are none", put(*PIECE, "blocks", to=lambda blocks: [True, *blocks[1:]]), "a basis of another size"),
    ("a line after the last", lambda lines: lines.append(copy.deepcopy(lines[LAST])), "has not the keys"),
    ("no neighbourhood", lambda lines: lines.pop(), "has not the keys"),
    ("the header alone", lambda lines: lines.__delitem__(slice(1, None)), "there are not two lines"),
]  # fmt: skip


REJECTED_AT_THE_END: list[tuple[str, Change, str]] = [
    # The neighbourhood.
    *((f"a narrow side of {name}", shrunk(name), f"{name} may leave the neighbourhood") for name in STATES),
    ("a side turned", put(LAST, "neighbourhood", "X", to=lambda pair: pair[::-1]), "X may leave"),
    ("a state without a side", lambda lines: lines[LAST]["neighbourhood"].pop("X"), "has not the keys"),
    ("a side for the time", put(LAST, "neighbourhood", "t", to=[[0, 0], [1, 0]]), "has not the keys"),
    ("a side with one end", put(LAST, "neighbourhood", "X", to=[[0, 0]]), "is not a pair"),
    ("a large neighbourhood", whole_neighbourhood("1"), "are not certainly negative in the neighbourhood"),
    ("a neighbourhood where slip may end", SLOW_SLIP, "slip is not certainly positive in the neigh"),
    # The statement.
    ("no time", state("time", to="0"), "may be reached after the time"),
    ("another sign of C_1", state("C_1", to=["positive"]), "the sign of C_1 is not certain"),
    ("no sign of C_1", state("C_1", to=["zero"]), "the sign of C_1$"),
    ("two signs of C_1", state("C_1", to=["negative", "negative"]), "the sign of C_1$"),
    ("a false sign of C_1", state("C_1", to=False), "the sign of C_1"),
    ("a range as a text", state("beta", to="01"), "is not a pair"),
    ("a range of one number", state("beta", to=["1/3"]), "is not a pair"),
    ("a place less", lambda lines: lines[0]["statement"]["place"].pop("X"), "has not the keys"),
    ("a place of the normal coordinate", state("place", "Y", to=["-9", "9"]), "has not the keys"),
]  # fmt: skip


def cases(rows: list[tuple[str, Change, str]]) -> Any:
    return pytest.mark.parametrize(("change", "reason"), [pytest.param(c, why, id=name) for name, c, why in rows])


def is_rejected(change: Change, reason: str) -> None:
    with pytest.raises(check.limits.Rejected) as found:
        said(change)
    text = f"{found.value}$"  # a reason that ends in $ is the end of what is said
    assert any(each in text for each in reason.split("|"))


@cases(REJECTED)
def test_what_does_not_follow_is_rejected(change: Change, reason: str) -> None:
    is_rejected(change, reason)


@pytest.mark.usefixtures("followed_once")
@cases(REJECTED_AT_THE_END)
def test_what_does_not_follow_at_the_end_is_rejected(change: Change, reason: str) -> None:
    is_rejected(change, reason)


@pytest.mark.parametrize("name", ["C_1", "b", "p"])
def test_a_coordinate_has_no_name_of_the_statement(name: str) -> None:
    """Whoever reads "p = b = 0" would take it for the coordinate."""

    def change(lines: list[Any]) -> None:
        statement = lines[0]["statement"]
        for each in (statement["start"], statement["place"]):
            each[name], each[f"{name}_dot"] = each.pop("X"), each.pop("X_dot")
        given = statement["mechanism"]
        given["coordinates"], given["x"] = [name, "Y", "theta"], f"1*{name} + 1*cos(theta)"
        for line in lines[2:LAST]:
            x = line["x"]
            x[name], x[f"{name}_dot"] = x.pop("X"), x.pop("X_dot")

    with pytest.raises(check.limits.Rejected, match="a name of something else"):
        said(change)


@pytest.mark.usefixtures("followed_once")
@pytest.mark.parametrize(("sign", "word", "other"), [(1, "positive", "negative"), (-1, "negative", "positive")])
def test_the_sign_of_c_1_is_that_of_theorem_a6(
    sign: int, word: str, other: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where Theorem A5 gives none."""
    captured = check.approach.captured
    monkeypatch.setattr(check.approach, "captured", lambda *given: captured(*given)._replace(sign=0))
    monkeypatch.setattr(check.approach, "side", lambda *_: sign)
    assert said(state("C_1", to=[word])).endswith(f", C_1 {'>' if sign > 0 else '<'} 0")
    with pytest.raises(check.limits.Rejected, match="the sign of C_1 is not certain"):
        said(state("C_1", to=[other]))


def test_signs_are_asked_from_the_start_to_the_end_of_each_step(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    positive = check.approach.positive

    def recorded(step: Any, event: Any, a: int, b: int) -> bool:
        asked.append((a, b))
        return bool(positive(step, event, a, b))

    monkeypatch.setattr(check.approach, "positive", recorded)
    said()
    assert asked == [(0, 2**192)] * 2 * (LAST - 2)


def test_a_key_twice() -> None:
    data = SHIPPED.read_bytes()[:-72].replace(b'"C_1":', b'"C_1":[],"C_1":')
    with pytest.raises(check.limits.Rejected, match="a key occurs twice"):
        check.main.check_text(mutate.sealed(data))
