"""The checker of lift-off and impact for all small ε: certificates that are right and wrong.

Page: proofs/from_state.md, section 11. Its bounds stand beside other computations in test_side_pieces.py and
test_side_sharp.py, the hypotheses of the growth in test_side_growth.py.
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
side = check.side
SHIPPED = mutate.CHECKER.with_name("side_3_2.cert")
LINES = [json.loads(line) for line in SHIPPED.read_text(encoding="utf-8").splitlines()[:-1]]
Change = Callable[[dict[str, Any], dict[str, Any]], None]


def first_range(change: Change = lambda *_: None, more: int = 0) -> list[Any]:
    """The shipped certificate cut to its first range, or some more, changed in its statement and that range."""
    lines = copy.deepcopy(LINES[: 2 + more])
    lines[0]["statement"]["epsilon"] = str(Fraction(lines[-1]["delta"]) ** 3)
    change(lines[0]["statement"], lines[1])
    return lines


def said(change: Change = lambda *_: None, more: int = 0) -> str:
    return str(check.main.check_text(mutate.text_of(first_range(change, more))))


def put(where: int, **values: Any) -> Change:
    """Change the statement (0) or the range (1)."""
    return lambda *parts: parts[where].update(values)


def moved(where: int, name: str, factor: Fraction) -> Change:
    return lambda *parts: parts[where].update({name: str(Fraction(parts[where][name]) * factor)})


def cone(index: int, factor: Fraction) -> Change:
    """Another number of the cone: a, c, B, C."""

    def change(_: Any, line: dict[str, Any]) -> None:
        line["cone"][index] = str(Fraction(line["cone"][index]) * factor)

    return change


def below_a(line: dict[str, Any]) -> str:
    """Three quarters of the a of a cone: for all flatter ones that are tried it is too small."""
    return str(Fraction(line["cone"][0]) * Fraction(3, 4))


def of_passage(name: str, value: str) -> Change:
    return lambda _, line: line["passage"].update({name: value})


def both(*changes: Change) -> Change:
    def change(statement: Any, line: Any) -> None:
        for each in changes:
            each(statement, line)

    return change


@pytest.mark.slow
def test_the_shipped_certificate_is_verified_whole() -> None:
    assert check.main.check_text(SHIPPED.read_bytes()) == (
        "the model system with α = (-1, -1, -3/2) and (k_1 ε², k_2 ε², c ε) = (1, 1, 1): for every ε in "
        "(0, 64/185193] and every start in contact at p = 1/2, b = -2 with |λ + b/p| ≤ η|L|, √κ|v|/ε ≤ η√p|L|, "
        "(g/√l)|φ| ≤ η√p|L|, η = 1/100, L = -b/p - 2, φ = λ + κy/ε² + (l/g)v/ε, κ = 1/2, g = 2, l = 1/2, as long "
        "as slip is positive: λ > 0 until p = -172/101 ε^(2/3), and it vanishes later: contact is lost, at the latest "
        f"at the time {LINES[0]['statement']['by']} after p = 0"
    )


def test_its_first_ranges_say_what_they_prove() -> None:
    text = said(more=1)
    assert f"for every ε in (0, {Fraction(LINES[2]['delta']) ** 3}]" in text
    assert " ε^(2/3), and it vanishes later: contact is lost" in text


def test_an_impact_says_no_more_than_it_proves() -> None:
    """By linearity the same numbers prove it for the other sign of L; what follows after that force is not shown."""
    assert said(put(0, b="-1/2", reaches="3")).endswith(
        ": λ > 0 until p = -172/101 ε^(2/3), and on until it exceeds 3, where p < 0, at the latest at the time "
        f"{LINES[0]['statement']['by']} after p = 0"
    )


ACCEPTED: list[tuple[str, Change]] = [
    ("as it is", put(0)),
    ("a smaller ε", moved(0, "epsilon", Fraction(1, 1000))),
    ("fewer starts", put(0, within="0")),
    ("a later time", moved(0, "by", Fraction(2))),
    ("more pieces", put(1, pieces=LINES[1]["pieces"] + 7)),
    ("a cone that is a little too steep", cone(0, Fraction(26, 25))),
    ("a wider cone", both(cone(2, Fraction(101, 100)), cone(3, Fraction(1001, 1000)))),
    ("a hand-over farther out", put(1, scaled="33/8", pieces=LINES[1]["pieces"] + 5)),
]


@pytest.mark.parametrize("change", [pytest.param(change, id=name) for name, change in ACCEPTED])
def test_what_follows_is_accepted(change: Change) -> None:
    assert said(change).endswith("after p = 0")


REJECTED: list[tuple[str, Change, str]] = [
    # What is said.
    ("ε beyond the ranges", moved(0, "epsilon", Fraction(1001, 1000)), "the ranges do not reach the ε"),
    ("an impact", put(0, reaches="21/10"), "it is the other side"),
    ("a large force", put(0, reaches="20"), "the growth is not followed to the force"),
    ("a force below the mean", put(0, reaches="1"), "an impact is a force above the mean"),
    ("the mean force", put(0, reaches="2"), "an impact is a force above the mean"),
    ("a negative force", put(0, reaches="-1"), "an impact is a force above the mean"),
    ("a time too soon", put(0, by="1/100000"), "it may happen later than is stated"),
    ("ε = 0", put(0, epsilon="0"), "ε is not positive"),
    ("another kind", put(0, kind="passage"), "unknown kind of statement"),
    ("a key too many", put(0, more="1"), "has not the keys"),
    ("b on the other side", put(0, b="-1/2"), "it is the other side"),
    ("b on the distinguished trajectory", put(0, b="-1"), "the distinguished trajectory"),
    ("a force that vanishes too soon", put(0, b="-2000000"), "the force is not certainly positive before the cone"),
    ("starts too far from rest", put(0, within="1"), "the barrier is not below z_max"),
    ("another β", put(0, alpha=["-1", "-1", "-8/5"]), "the rate is too small"),
    ("another damper", put(0, contact=["1", "1", "9/10"]), "a source is not paid"),
    # The range.
    ("δ = 0", put(1, delta="0"), "the ranges of δ are not in order"),
    ("a negative δ", put(1, delta="-1/512"), "the ranges of δ are not in order"),
    ("δ too large for the passage", put(1, delta="1/2"), "the passage would end before its start"),
    ("no pieces", put(1, pieces=0), "there are not 1 to 600 pieces"),
    ("too many pieces", put(1, pieces=601), "there are not 1 to 600 pieces"),
    ("pieces that are no integer", put(1, pieces="5"), "there are not 1 to 600 pieces"),
    ("pieces that are a truth value", put(1, pieces=True), "there are not 1 to 600 pieces"),
    ("pieces longer than 1", put(1, pieces=5), "a piece is longer than 1"),
    ("long pieces", put(1, pieces=6), "Theorem U1|a piece is too long"),
    ("an end before p = 0", put(1, end="-1"), "a number of the range is not positive"),
    ("an end at p = 0", put(1, end="0"), "a number of the range is not positive"),
    ("an end too soon", put(1, end="1/8"), r"\(G0\)|is not certain where the cone begins"),
    ("an end too late", put(1, end="12", pieces=400), r"the force is not certainly positive before the cone"),
    ("a nearer hand-over", put(1, scaled="399/100"), "the passage ends beyond the rectangle"),
    ("a key too many in the range", put(1, more="1"), "has not the keys"),
    ("a key too many in the passage", of_passage("more", "1"), "has not the keys"),
    # The passage.
    ("a rate too small", of_passage("rate", "1"), "the rate is too small"),
    ("a growth too small", of_passage("growth", "-3/20"), r"not confirmed \(Lemma 1\)"),
    ("no slow part", lambda _, line: line["passage"].update(v=[], w=[], f=[]), "a source is not paid"),
    # The cone.
    ("a cone of three numbers", lambda _, line: line["cone"].pop(), "is not a list of 4 numbers"),
    ("a growth of 0", cone(0, Fraction(0)), "a number of the range is not positive"),
    ("a steeper cone", cone(0, Fraction(10)), r"V does not lie in the cone \(G0\)"),
    ("a flatter top", cone(2, Fraction(1, 3)), r"V does not lie in the cone \(G0\)"),
    ("c too large", cone(1, Fraction(3)), r"N does not lie in the cone \(G0\)"),
    ("C far too small", cone(3, Fraction(1, 100)), r"N does not lie in the cone \(G0\)"),
    ("C too small for later", cone(3, Fraction(1, 3)), r"\(G4\) does not hold"),
    ("c below a", lambda _, line: line["cone"].__setitem__(1, below_a(line)), r"\(G1\) does not hold"),
    ("B no larger than C", lambda _, line: line["cone"].__setitem__(2, line["cone"][3]), r"\(G3\) does not hold"),
    ("c a little too large", cone(1, Fraction(11, 10)), r"\(G2\) does not hold"),
    ("a slow growth", cone(0, Fraction(10, 13)), r"\(G2\) does not hold"),
    ("a growth that nearly vanishes", cone(0, Fraction(1, 100)), r"\(G1\) does not hold"),
    ("a small Y_max", put(1, top="3"), "the growth is not followed to the force"),
    ("a tiny Y_max", put(1, top="1/1000000"), "the growth would end before it begins"),
    ("an enormous Y_max", put(1, top="1" + 300 * "0"), r"\(G[134]\) does not hold"),
]


@pytest.mark.parametrize(
    ("change", "reason"), [pytest.param(change, reason, id=name) for name, change, reason in REJECTED]
)
def test_what_does_not_follow_is_rejected(change: Change, reason: str) -> None:
    with pytest.raises(check.limits.Rejected, match=reason):
        said(change)


def test_the_ranges_are_in_order() -> None:
    lines = first_range()
    with pytest.raises(check.limits.Rejected, match="the ranges of δ are not in order"):
        check.main.check_text(mutate.text_of([*lines, LINES[1]]))


def test_a_certificate_has_ranges_and_its_pages() -> None:
    lines = first_range()
    with pytest.raises(check.limits.Rejected, match="there are not 1 to 400 ranges"):
        check.main.check_text(mutate.text_of(lines[:1]))
    lines[0]["hypotheses"] = ["from_state"]
    with pytest.raises(check.limits.Rejected, match="the pages are not those of a side"):
        check.main.check_text(mutate.text_of(lines))


def test_work_is_counted_before_it_is_done() -> None:
    """Four hundred ranges of six hundred pieces each are more than a certificate may ask for."""
    lines = first_range(put(1, pieces=600))
    limits = check.limits.Limits(work=1)
    wide = [{**lines[1], "delta": str(Fraction(1, 512) - Fraction(399 - k, 10**9))} for k in range(400)]
    with pytest.raises(check.limits.Rejected, match="the limit work=1"):
        check.main.check_text(mutate.text_of([lines[0], *wide]), limits)
