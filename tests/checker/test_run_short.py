"""Short runs: the whole sentence that is proved, and for each rule a file that breaks it alone, with what is said.

Page: proofs/run_certificate.md.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from must_reject import runs, short_runs

Change = Callable[[runs.Lines], Any]
GOOD = {name: getattr(short_runs, name)() for name in ("one", "flight", "cone", "stick", "block")}
UNIT, QUARTER = Fraction(1, 2**short_runs.BITS), Fraction(1, 2**37)  # of the width of the first bracket
EVENTS, BRACKET = (0, "statement", "events"), "is not in the bracket of the statement"
BETWEEN = {name: f"lift-off at t in [{low}, {high}], touch-down at t in [" for name, low, high in [
    ("flight", "0.460307888091620043269358575344085693359375", "0.460307888095258022076450288295745849609375"),
    ("stick", "0.4383745850392415377427823841571807861328125", "0.4383745887654413309064693748950958251953125"),
]}  # fmt: skip


def put(*path: Any, to: Any) -> Change:
    """Replace what lies at a path, by a value or by a function of what was there."""

    def change(lines: runs.Lines) -> None:
        at: Any = lines
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = to(at[path[-1]]) if callable(to) else to

    return change


def more(value: Fraction) -> Callable[[str], str]:
    return lambda text: str(Fraction(text) + value)


def shifted(by: Fraction) -> Callable[[list[int]], list[int]]:
    """Of a number [m, e]."""
    return lambda pair: short_runs.dyadic(pair[0] * Fraction(2) ** pair[1] + by)


def said(base: str, *changes: Change) -> str:
    lines = copy.deepcopy(GOOD[base])
    for change in changes:
        change(lines)
    return runs.verdict(lines)


def test_the_sentence_that_is_proved() -> None:
    scene = (
        "ε = 1/2, alpha_1 = -1, alpha_2 = -6, beta = 1, damping = 1, k_1 = 1, k_2 = 1, from b = 3, p = -1/2, v = 0, "
    )
    start = f"the model system with compliant_contact, {{}}{scene}y = -1/4, z = 1/99: "
    assert said("one") == (
        f"VERIFIED {start.format('')}no change of phase, until t = 1/16; "
        "λ_N > 0 all along, as leaving an effect out assumes"
    )
    changes = (
        f"VERIFIED {start.format('lift_off, ')}just these changes of phase: {BETWEEN['flight']}"
        "1.366733429680834888131357729434967041015625, 1.366741059079004116938449442386627197265625], "
    )
    assert said("flight") == f"{changes}until t = 6285835098961/4398046511104"
    assert said("cone") == f"{changes}for ever, with λ_N > 0 that grows at least like exp(1/4 t/ε) in the end"
    assert said("stick").endswith(
        "just these changes of phase: stick at t in [0.1478169094347094869590364396572113037109375, "
        f"0.1478169094356189816608093678951263427734375], {BETWEEN['stick']}"
        "1.3981424920315248527913354337215423583984375, 1.3981730133358496459550224244594573974609375], "
        "until t = 12847947232099/8796093022208"
    )


def test_the_sentence_of_a_mechanism() -> None:
    text = said("block")
    assert text.startswith(
        "VERIFIED the mechanism M q'' = f + λ_N dy/dq + λ_T dx/dq with q = (b, H, d), M = (1, 0, 0; "
    )
    assert text.endswith(
        "just these changes of phase: stick at t in [0.146446609406439165468327701091766357421875, "
        "0.146446609406893912819214165210723876953125], slip forwards at t in "
        "[0.49999999976671460899524390697479248046875, 0.50000000023283064365386962890625], until t = "
        "1236950580735/2199023255552"
    )


def test_the_version_is_the_one_of_the_page() -> None:
    assert GOOD["one"][0]["version"] == runs.part("run").VERSION == 4


def test_the_time_may_end_with_the_last_event() -> None:
    high = GOOD["flight"][0]["statement"]["events"][-1][2]
    assert said("flight", put(0, "statement", "until", to=high)).startswith("VERIFIED")


PIECES = (3, "pieces")
FIRST, SECOND = (*PIECES, 0), (*PIECES, 1)
SIZE = "a basis of another size"
HEAD = 2
LAST = len(GOOD["flight"]) - 2
BEGINS, RISES = "a bound begins below the errors", "a bound rises too slowly"
NO_EVENT, NOT_YET = "an event is not that of the run", "the end of the time is not reached"
NOT_ENDS, NO_BRACKET = "no event that ends this phase", "the bracket of an event"
SHORT: list[tuple[str, str, Change, str]] = [
    # The file.
    ("other pages", "one", put(0, "hypotheses", to=["run_certificate"]), "the pages are not those of a run"),
    ("a text", "one", put(0, "statement", to="run"), "unknown kind of statement"),
    ("another kind", "one", put(0, "statement", "kind", to="force"), "unknown kind of statement"),
    ("a mechanism that is none", "one", put(0, "statement", "kind", to="run of a mechanism"), "has not the keys"),
    ("63 bits", "one", put(1, "bits", to=63), "the number of bits"),
    ("1025 bits", "one", put(1, "bits", to=1025), "the number of bits"),
    ("a line more", "one", lambda lines: lines.append(lines[-1]), "lines are left"),
    ("a line less", "one", lambda lines: lines.pop(), "a step has not the keys"),
    # Phases.
    ("another phase", "one", put(HEAD, "phase", to="flight"), "is not the one that follows"),
    ("no steps", "one", put(HEAD, "steps", to=0), "a phase has no step"),
    ("true steps", "one", put(HEAD, "steps", to=True), "a phase has no step"),
    ("a bracket and no event", "one", put(HEAD, "bracket", to=[[1, -2], [1, -1]]), "a bracket of no event"),
    ("an event that is none", "one", put(HEAD, "event", to="impact"), NOT_ENDS),
    ("an event that is a list", "one", put(HEAD, "event", to=["lift-off"]), NOT_ENDS),
    ("an event that is left out", "one", put(HEAD, "event", to="lift-off"), NOT_ENDS),
    ("the event of another phase", "flight", put(HEAD, "event", to="touch-down"), NOT_ENDS),
    ("an event and a cone", "flight", put(HEAD, "cone", to=["1/4"]), NOT_ENDS),
    ("a bracket that is a number", "flight", put(HEAD, "bracket", to=1), NO_BRACKET),
    ("a bracket that is an object", "flight", put(HEAD, "bracket", to={"0": [1, -1], "1": [1, 0]}), NO_BRACKET),
    ("a bracket of one", "flight", put(HEAD, "bracket", to=lambda ends: ends[:1]), NO_BRACKET),
    ("a bracket of three", "flight", put(HEAD, "bracket", to=lambda ends: [*ends, [1, 0]]), NO_BRACKET),
    ("a bracket from 0", "flight", put(HEAD, "bracket", 0, to=[0, 0]), NO_BRACKET),
    ("a bracket of no width", "flight", put(HEAD, "bracket", to=lambda ends: [ends[0]] * 2), NO_BRACKET),
    ("a bracket beyond the step", "flight", put(HEAD, "bracket", 1, to=[2**80 + 1, -80]), NO_BRACKET),
    (
        "a bracket that ends too early",
        "flight",
        put(HEAD, "bracket", 1, to=shifted(-3 * QUARTER)),
        "lift-off: no change of sign",
    ),
    (
        "a bracket that begins too late",
        "flight",
        put(HEAD, "bracket", 0, to=shifted(3 * QUARTER)),
        "lift-off in slip is not excluded",
    ),
    ("an event that is not seen", "flight", put(HEAD, "event", to=""), "a bracket of no event"),
    (
        "an event that is passed over",
        "flight",
        lambda lines: lines[HEAD].update(event="", bracket=[]),
        "lift-off in slip is not excluded",
    ),
    # Steps.
    ("no coefficients", "one", put(3, "x", "b", to=[]), "a list of coefficients"),
    ("a length of 0", "one", put(3, "h", to=[0, 0]), "h or the unit of a step"),
    ("pieces that are none", "one", put(*PIECES, to=None), "the pieces are not a list"),
    ("pieces that are an object", "one", put(*PIECES, to={}), "the pieces are not a list"),
    ("no pieces", "one", put(*PIECES, to=[]), "the pieces do not fill the step"),
    ("no pieces later", "flight", put(4, "pieces", to=[]), "the pieces do not fill the step"),
    ("half of a step", "one", put(*PIECES, to=lambda pieces: pieces[:1]), "the pieces do not fill the step"),
    ("a piece that ends where it begins", "one", put(*SECOND, "end", to=[1, -1]), "the ends of the pieces"),
    ("a piece beyond the step", "one", put(*SECOND, "end", to=[3, -1]), "the ends of the pieces"),
    ("blocks that are a number", "one", put(*FIRST, "blocks", to=5), SIZE),
    ("too few columns", "one", put(*FIRST, "blocks", to=[2, 2]), SIZE),
    ("a block of no columns", "one", put(*FIRST, "blocks", to=[2, 3, 0]), SIZE),
    ("a block with fewer than none", "one", put(*FIRST, "blocks", to=[2, 4, -1]), SIZE),
    ("a block of all and a half", "one", put(*FIRST, "blocks", to=[6, -1]), SIZE),
    ("a block that is true", "one", put(*FIRST, "blocks", to=[True, 4]), SIZE),
    ("a basis that is a text", "one", put(*FIRST, "basis", to="1" * 25), SIZE),
    ("a shorter basis", "one", put(*FIRST, "basis", to=lambda entries: entries[:-1]), SIZE),
    ("a first bound of a unit", "one", put(*FIRST, "nodes", 0, to=[[1, -short_runs.BITS]] * 2), BEGINS),
    ("one first bound of a unit", "one", put(*FIRST, "nodes", 0, 1, to=[1, -short_runs.BITS]), BEGINS),
    ("a unit less than before", "flight", put(4, "pieces", 0, "nodes", 0, 0, to=shifted(-UNIT)), BEGINS),
    ("bounds that do not rise", "one", put(*SECOND, "nodes", to=lambda nodes: [nodes[0]] * 5), RISES),
    ("one of them", "one", put(*FIRST, "nodes", to=lambda nodes: [[w[0], nodes[0][1]] for w in nodes]), RISES),
    # The statement.
    ("events that are none", "one", put(*EVENTS, to=None), "the events are not those of the run"),
    ("events that are an object", "one", put(*EVENTS, to={}), "the events are not those of the run"),
    ("an event less", "flight", put(*EVENTS, to=lambda events: events[:1]), "the events are not those of the run"),
    ("an event that is a text", "flight", put(*EVENTS, 0, to="abc"), NO_EVENT),
    ("an event that is a number", "flight", put(*EVENTS, 0, to=3), NO_EVENT),
    ("an event without an end", "flight", put(*EVENTS, 0, to=lambda event: event[:2]), NO_EVENT),
    ("another name", "flight", put(*EVENTS, 0, 0, to="touch-down"), NO_EVENT),
    ("a unit too late", "flight", put(*EVENTS, 0, 1, to=more(UNIT / 2)), f"lift-off {BRACKET}"),
    ("a unit too early", "flight", put(*EVENTS, 0, 2, to=more(-UNIT / 2)), f"lift-off {BRACKET}"),
    (
        "an event after the time",
        "flight",
        put(0, "statement", "until", to=more(Fraction(-1, 8))),
        "touch-down may come after the end of the time",
    ),
    ("a unit more of the time", "flight", put(0, "statement", "until", to=more(UNIT / 2)), NOT_YET),
    ("another end", "one", put(0, "statement", "end", to="for ever"), NOT_YET),
    ("another end of a cone", "cone", put(0, "statement", "end", to="time"), "the end is not that of the run"),
    # Cones.
    ("a cone that is a text", "cone", put(LAST, "cone", to="1"), "a cone is not [a] or [a, c]"),
    ("a cone that is an object", "cone", put(LAST, "cone", to={"0": "1/4"}), "a cone is not [a] or [a, c]"),
    ("a cone of three", "cone", put(LAST, "cone", to=["1/4"] * 3), "a cone is not [a] or [a, c]"),
    ("a cone of no rate", "cone", put(LAST, "cone", to=["0"]), "cone: a, λ > 0"),
    ("a cone of a mechanism", "block", lambda lines: lines[-2].update(cone=["1/4"]), "no cone for a mechanism"),
    ("the other slip", "block", lambda lines: lines[-2].update(phase="reverse slip"), "is not the one that follows"),
    ("slip the other way", "block", put(4, "event", to="slip backwards"), "slip forwards in stick is not excluded"),
    ("a stick without an end", "block", lambda lines: lines[4].update(event="", bracket=[]), "is not excluded"),
    ("a block of the model", "block", put(0, "statement", "kind", to="run"), "the statement has not the keys"),
    ("a cone in another scene", "stick", lambda lines: lines[-2].update(cone=["1/4"]), "no cone in this phase"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "base", "change", "why"), SHORT, ids=[row[0] for row in SHORT])
def test_each_rule(name: str, base: str, change: Change, why: str) -> None:
    text = said(base, change)
    assert text.startswith("REJECTED "), name
    assert why in text
