"""The bound of Theorem A1 in proofs/coq/StatementApproach.v is the one of the library; each change of it is noticed."""

from __future__ import annotations

from coq.coq_terms import Applied, evaluate_term, mutations, stated, statement
from coq.mechanism_terms import UNREADABLE, body, renamed
from flint import arb

from gspot_verified.mechanisms.approach.capture import capture
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits

NAMES = ("a1", "a3", "A2", "p", "b", "f", "g")
Case = tuple[dict[str, arb], arb]


def cases() -> list[Case]:
    """What the formula gets for each component of the model system, and the reach that the library finds."""
    found = []
    for alphas in (("-2", "-1", "-3/2"), ("-3", "-1/2", "-5/4")):
        values = dict(zip(("alpha_1", "alpha_2", "alpha_3"), alphas, strict=True))
        numbers = SlipNumbers(SlipFlow.of(shift(shipped_mechanism("model system", **values))))
        p, b = arb("0.01"), arb("-0.07")
        caught = capture(numbers, [arb(0), arb(5), arb(0), arb(0), p, b], None)
        assert caught is not None
        inside = caught.numbers
        given = {"a1": caught.decay_1, "a3": caught.decay_3, "A2": inside.alpha_2.abs_upper(), "p": p, "b": b}
        for F, G, reach in zip(inside.F, inside.G, caught.reach, strict=True):
            found.append((given | {"f": F.abs_upper(), "g": G.abs_upper()}, reach))
    return found


def holds(text: str, places: list[Case]) -> bool:
    """Whether the text has the library's value at each place."""
    absolute = Applied(1, abs)
    try:
        values = [evaluate_term(text, given | {"Rabs": absolute}, arb) for given, _ in places]
        return all(abs(value - reach) < arb("1e-20") for value, (_, reach) in zip(values, places, strict=True))
    except UNREADABLE:
        return False


def test_the_reach() -> None:
    with working_bits(200):
        places, text = cases(), body("reach")
        assert holds(text, places)
        others = [*mutations(text), *renamed(text, NAMES)]
        assert [other for other in others if holds(other, places)] == []


def test_the_relations_are_those_of_the_paper() -> None:
    """Section 2: L_F y = v, L_F v = b, L_F p = alpha_1, L_F b = alpha_2; L_G y = 0, L_G v = p, L_G p = 0, ..."""
    text = " ".join(stated().split())
    for field, values in (("F", ("v xi", "b xi", "alpha1 xi", "alpha2 xi")), ("G", ("0", "p xi", "0", "- alpha3 xi"))):
        pairs = zip("yvpb", values, strict=True)
        said = " /\\ ".join(f"along all {name}' {field} xi = {value}" for name, value in pairs)
        assert f"along_{field} : forall xi, in_box low high xi -> {said}" in text
    assert statement("slip_flow").endswith(": R := p xi * F i xi - b xi * G i xi")
