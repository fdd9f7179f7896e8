"""Ledger of Section 1: the falling rod of Génot and Brogliato is in Case II, for every friction above its threshold.

Length, mass and gravity are 1. C, S are cosine and sine of its angle, w the rate of the angle; x is C² - 3/7, and g is
S w. The contact point is (X + C/2, Y - S/2) from the centre (X, Y); the moment of inertia is 1/12.
"""

from __future__ import annotations

from collections.abc import Mapping

from flint import fmpq, fmpq_mpoly

from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs

ALGEBRA = Algebra("C S w mu lam q x")
_SYMBOLS = ALGEBRA.symbols
CONTACT = {"x": "C/2", "y": "-S/2"}
"""The contact point from the centre."""
INERTIA = fmpq(1, 12)
PARTS = {"p": "1 + 3*C^2 - 3*mu*S*C", "b": "S*w^2/2 - 1"}
"""The functions p and b in positive slip, by hand."""
AT_THE_SPOT = {"S C α_1/w": "1 - 5*C^2", "2 α_2/w³": "C", "C α_3/(S w)": "-2 + 0*C"}
"""The α's where p = b = 0, by hand."""
FRICTION = {"top": "(1 + 3*q)^2", "bottom": "9*q*(1 - q)"}
"""μ² at p = 0 as a quotient, q = C²."""
THRESHOLD, BOUND = fmpq(3, 7), fmpq(64, 27)
"""q at which α_1 = α_3, and μ² there: μ = 8/(3 sqrt 3)."""
PLACE_OF_LEAST, LEAST = fmpq(1, 5), fmpq(16, 9)
"""q at which α_1 = 0, and μ² there, the least for which p = 0 somewhere: μ = 4/3."""
AT = (fmpq(2), fmpq(9, 4))
"""μ at which the library's own G-spot is classified."""
MECHANISM = "falling rod of Génot and Brogliato"


def turned(value: fmpq_mpoly) -> fmpq_mpoly:
    """The derivative in the angle."""
    return ALGEBRA.derivative(value, {"C": -_SYMBOLS["S"], "S": _SYMBOLS["C"]})


def on_the_circle(value: fmpq_mpoly) -> fmpq_mpoly:
    """The value with S² = 1 - C²."""
    found = ALGEBRA.constant(0)
    for power, part in ALGEBRA.coefficients(value, "S").items():
        found += part * ALGEBRA.read("1 - C^2") ** (power // 2) * _SYMBOLS["S"] ** (power % 2)
    return found


def turning() -> fmpq_mpoly:
    """dw/dt for λ_N = 1 in positive slip: the generalised force of the angle over the moment of inertia."""
    levers = {name: turned(ALGEBRA.read(text)) for name, text in CONTACT.items()}
    return (levers["y"] - _SYMBOLS["mu"] * levers["x"]) / INERTIA


def quantities() -> dict[str, fmpq_mpoly]:
    """The functions b, p and the α's, from y = Y - S/2: dv/dt = Y'' + y_θ w' + y_θθ w²."""
    lever = turned(ALGEBRA.read(CONTACT["y"]))
    b = turned(lever) * _SYMBOLS["w"] ** 2 - 1
    p = 1 + lever * turning()
    rates = {name: turned(value) * _SYMBOLS["w"] for name, value in (("alpha_1", p), ("alpha_2", b))}
    return {"p": p, "b": b, **rates, "alpha_3": -b.derivative("w") * turning()}


def by_hand() -> bool | None:
    """Whether b and p are the functions written by hand."""
    found = quantities()
    return all(on_the_circle(found[name] - ALGEBRA.read(text)).is_zero() for name, text in PARTS.items())


def alphas_at_the_spot() -> bool | None:
    """Whether the α's are as written where 3 μ S C = 1 + 3C² and S w² = 2."""
    found, C, S, w = quantities(), _SYMBOLS["C"], _SYMBOLS["S"], _SYMBOLS["w"]
    friction = ALGEBRA.read("(1 + 3*C^2)/3")  # μ S C

    def with_friction(value: fmpq_mpoly) -> fmpq_mpoly:
        """S C times a value that is linear in μ."""
        slope = value.derivative("mu")
        return (value - slope * _SYMBOLS["mu"]) * S * C + slope * friction

    texts = {name: ALGEBRA.read(text) for name, text in AT_THE_SPOT.items()}
    left = {
        "S C α_1/w": with_friction(found["alpha_1"]) - texts["S C α_1/w"] * w,
        "2 α_2/w³": 2 * found["alpha_2"] - texts["2 α_2/w³"] * w**3,
        "C α_3/(S w)": with_friction(found["alpha_3"]) - S * texts["C α_3/(S w)"] * S * w,
    }
    return all(on_the_circle(value).is_zero() for value in left.values())


def signs_of_case_ii() -> bool | None:
    """Whether for C, S, w > 0 and C² = 3/7 + x, x > 0: α_2 > 0, α_1 < 0 and S C (α_3 - α_1)/w > 0."""
    first, second, third = (ALGEBRA.read(text) for text in AT_THE_SPOT.values())
    if not (third.derivative("C").is_zero() and rising_signs(second) and rising_signs(-third)):
        return False
    above = third * ALGEBRA.read("1 - C^2") - first  # S C (α_3 - α_1)/w, S² = 1 - C²
    return all(
        rising_signs(_at_square(value, ALGEBRA.constant(THRESHOLD) + _SYMBOLS["x"])) for value in (above, -first)
    )


def are_independent() -> bool | None:
    """Whether p, b, y, v have independent gradients where α_1 is not 0.

    y has the height of the centre and v its rate, p and b have neither: their slopes in the angle and w decide.
    p has no w, its slope in the angle is α_1/w, and that of b in w, S w, is not 0.
    """
    found, w = quantities(), _SYMBOLS["w"]
    by_angle = turned(found["p"]) * w - found["alpha_1"]
    return found["p"].derivative("w").is_zero() and by_angle.is_zero() and rising_signs(found["b"].derivative("w"))


def others_are_in_no_case() -> bool | None:
    """Whether, for C, S > 0, p = 0 needs μ² >= LEAST, and all other places where b = 0 too are in no Case.

    For w > 0: α_1 > 0 for q < PLACE_OF_LEAST, and α_3 < α_1 for q < THRESHOLD, where α_2 > 0 as beyond it; for w < 0:
    α_3 > 0.
    """
    first, second, third = (ALGEBRA.read(text) for text in AT_THE_SPOT.values())
    top, bottom = (ALGEBRA.read(text) for text in FRICTION.values())
    square = top - LEAST * bottom - (_SYMBOLS["q"] / PLACE_OF_LEAST - 1) ** 2
    below = first - third * ALGEBRA.read("1 - C^2")  # S C (α_1 - α_3)/w, S² = 1 - C²
    signs = [
        rising_signs(_at_square(first, ALGEBRA.constant(PLACE_OF_LEAST) - _SYMBOLS["x"])),
        rising_signs(_at_square(below, ALGEBRA.constant(THRESHOLD) - _SYMBOLS["x"])),
        rising_signs(second) and rising_signs(-third),
    ]
    return square.is_zero() and all(signs)


def _at_square(value: fmpq_mpoly, square: fmpq_mpoly) -> fmpq_mpoly:
    """An even polynomial in C, with this in place of C²."""
    powers = ALGEBRA.coefficients(value, "C")
    return sum((part * square ** (power // 2) for power, part in powers.items()), start=ALGEBRA.constant(0))


def friction_rises() -> bool | None:
    """Whether μ² rises with q from BOUND at THRESHOLD to infinity at q = 1: one q for every μ² > BOUND."""
    top, bottom = (ALGEBRA.read(text) for text in FRICTION.values())
    slope = top.derivative("q") * bottom - top * bottom.derivative("q")
    # slope is 9 (1 + 3q) (5q - 1), positive for q > 1/5
    factored = (slope - ALGEBRA.read("9*(1 + 3*q)*(5*q - 1)")).is_zero()
    start = {"q": ALGEBRA.constant(THRESHOLD)}
    begins = (ALGEBRA.substitute(top, start) - BOUND * ALGEBRA.substitute(bottom, start)).is_zero()
    ends = ALGEBRA.substitute(bottom, {"q": ALGEBRA.constant(1)}).is_zero()
    return factored and begins and ends and 5 * THRESHOLD > 1


def friction_is_that_of_p() -> bool | None:
    """Whether p = 0 is μ² = (1 + 3q)²/(9 q (1 - q)), for q = C² and S C > 0."""
    top, bottom = (ALGEBRA.substitute(ALGEBRA.read(text), {"q": _SYMBOLS["C"] ** 2}) for text in FRICTION.values())
    p = ALGEBRA.read(PARTS["p"])
    rest = ALGEBRA.substitute(p, {"mu": ALGEBRA.constant(0)})
    square = p.derivative("mu") ** 2
    return on_the_circle(rest**2 - top).is_zero() and on_the_circle(square - bottom).is_zero()


def classified(friction: fmpq) -> bool | None:
    """Whether the library's own derivation and G-spot, in balls, are in Case II."""
    found = classify(shipped_mechanism(MECHANISM, mu=friction))
    return None if found.case is None else found.case == "II"


def _rod() -> Entry:
    steps: Mapping[str, bool | None] = {
        "b and p": by_hand(),
        "the α's": alphas_at_the_spot(),
        "their signs": signs_of_case_ii(),
        "independence": are_independent(),
        "one place": all_of([friction_is_that_of_p(), friction_rises()]),
        "the other places": others_are_in_no_case(),
    }
    return Section("Section 1").settled(
        "1-rod",
        "lines 305 to 306",
        r"\text{the classical falling rod problem is in Case II}",
        "The falling rod of Génot and Brogliato, length 1, in positive slip with its angle rising: for "
        "every μ > 8/(3 sqrt 3) there is one place with cos² > 3/7 where p = b = 0, it is in Case II, and p, b, y, v "
        "are independent there",
        Rung.EXACT.check(
            "b, p and the α's by the rod's geometry; their signs by positive symbols; the slopes of p and b in the "
            "angle and its rate; μ at p = 0 rises with cos²; the signs at the other places",
            all_of(steps.values()),
        ),
        Rung.POINTS.check(
            f"the library's own derivation and the G-spot in balls, μ = {', '.join(map(str, AT))}",
            all_of(classified(friction) for friction in AT),
        ),
        note="8/(3 sqrt 3) is where α_1 = α_3, and for μ < 4/3 there is no G-spot. For 4/3 < μ < 8/(3 sqrt 3) both "
        "places with a rising angle are in no Case: α_1 > 0 where cos² < 1/5, and α_2 > 0, α_3 < α_1 at the other one. "
        "A G-spot with a falling angle is in no Case: α_3 > 0.",
    )


ENTRIES: Builders = {"1-rod": _rod}
"""The falling rod."""
