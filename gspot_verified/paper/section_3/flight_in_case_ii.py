"""Ledger of Section 3: in Case II a flight does not end. Proof page: proofs/flight.md, Theorem F1 (b)."""

from __future__ import annotations

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.run import events
from gspot_verified.numbers.balls import certainly_less
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.scenes.certified_run import INTEGRATOR, certified_run
from gspot_verified.scenes.scene.file import load_scene

ALGEBRA = Algebra("u rate b alpha2 v m w d s")
"""u: time since lift-off; rate = 1/ε; w = e^(-u/ε); -m = y = z and v at lift-off, m >= 0."""
_SYMBOLS = ALGEBRA.symbols
FLIGHT = {"b": "b + alpha2*u", "v": "v + b*u + alpha2*u^2/2", "y": "-m + v*u + b*u^2/2 + alpha2*u^3/6", "z": "-m*w"}
AT_LIFT_OFF = {"v": "m*rate + d"}
"""λ_N falls there: z' = m/ε < v, by d > 0."""
BEGIN = {"u": ALGEBRA.constant(0), "w": ALGEBRA.constant(1)}
TANGENT = "1 - rate*u"
"""Of w at lift-off."""
BETAS = (fmpq(1, 4), fmpq(1, 2), fmpq(9, 10))
SIGN = 1
"""Case II: that of α_2."""
NU, EPSILON = fmpq(1, 4), fmpq(1, 100)
DIGITS = 12


def along(value: fmpq_mpoly) -> fmpq_mpoly:
    """The derivative in u."""
    return ALGEBRA.derivative(value, {"u": ALGEBRA.constant(1), "w": -_SYMBOLS["rate"] * _SYMBOLS["w"]})


def is_free_motion() -> bool:
    """b' = α_2, v' = b, y' = v, ε z' = -z."""
    b, v, y, z = (ALGEBRA.read(FLIGHT[name]) for name in "bvyz")
    rates = (along(b) - _SYMBOLS["alpha2"], along(v) - b, along(y) - v, along(z) + _SYMBOLS["rate"] * z)
    return all(value.is_zero() for value in rates)


def in_case_ii(value: fmpq_mpoly) -> fmpq_mpoly:
    """With what is known of α_2, and of v at lift-off."""
    images = {name: ALGEBRA.read(text) for name, text in AT_LIFT_OFF.items()}
    return ALGEBRA.substitute(value, images | {"alpha2": SIGN * _SYMBOLS["alpha2"]})


def gap() -> fmpq_mpoly:
    """y - z."""
    return in_case_ii(ALGEBRA.read(FLIGHT["y"]) - ALGEBRA.read(FLIGHT["z"]))


def never_closes() -> bool | None:
    """Whether y - z begins at 0 with a positive slope and is convex (w = 1 at lift-off); False: it tends to -∞."""
    nothing, slope = (ALGEBRA.substitute(value, BEGIN) for value in (gap(), along(gap())))
    if nothing.is_zero() and rising_signs(slope) and rising_signs(along(along(gap()))):
        return True
    highest = max(ALGEBRA.coefficients(gap(), "u").items(), default=(0, gap()))
    return False if highest[0] > 0 and rising_signs(-highest[1]) else None


def is_above_its_tangent() -> bool:
    """e^(-x) >= 1 - x: w - TANGENT is convex, and 0 at lift-off with its slope."""
    above = _SYMBOLS["w"] - ALGEBRA.read(TANGENT)
    begins = [ALGEBRA.substitute(value, BEGIN).is_zero() for value in (above, along(above))]
    return all(begins) and rising_signs(along(along(above)))


def is_a_sum_of_positive_terms() -> bool | None:
    """y - z with w = 1 - u/ε + s, where s >= 0: every coefficient is positive."""
    image = {"w": ALGEBRA.read(TANGENT) + _SYMBOLS["s"]}
    holds = is_free_motion() and is_above_its_tangent() and rising_signs(ALGEBRA.substitute(gap(), image))
    return True if holds else None


def motion_increases() -> bool | None:
    """Whether b, v and y increase: their rates have positive coefficients; False when all those of one are negative."""
    rates = [in_case_ii(along(ALGEBRA.read(FLIGHT[name]))) for name in "bvy"]
    return all_of(True if rising_signs(rate) else False if rising_signs(-rate) else None for rate in rates)


def runs_do_not_touch_down() -> bool | None:
    """Whether certified runs lose contact and do nothing else up to t = 1."""
    answers = []
    for beta in BETAS:
        run = certified_run(load_scene("fig-varsim1", beta=beta, nu=NU, epsilon=EPSILON, alpha_2=SIGN), 12, INTEGRATOR)
        answers.append(run.fate == "lift-off" if run.verdict.outcome is Outcome.PROVED else None)
    return all_of(answers)


def begins_as_stated(beta: fmpq) -> bool | None:
    """Whether the exact solution of a run loses contact with p > 0, b > 0 and y < 0."""
    model = compliant_model(beta, EPSILON, alpha_2=SIGN)
    first = next(iter(events(model, paper_state(model, NU), DIGITS).events), None)
    if first is None:
        return None
    state = first.state
    return all_of(certainly_less(arb(0), value) for value in (state.p, state.b, -state.Y))


def _persists() -> Entry:
    return Section("Section 3").settled(
        "3-flight-persists",
        "lines 912 to 914",
        r"\text{Case II: }\dot b>0,\ b, y, v\text{ increase, lift-off persists}",
        "In Case II (α_2 > 0) of the model system a flight that begins with b >= 0, y <= 0 and y - z increasing never "
        "ends, at every ε: b, v and y increase for ever, and y > z",
        Page("flight", (is_free_motion,)).carries(
            Rung.EXACT.check("Theorem F1 (b): y - z begins with a positive slope and is convex", never_closes())
        ),
        Rung.EXACT.check(
            "y - z, and the rates of b, v, y, are sums of positive terms, with e^(-x) >= 1 - x",
            all_of([is_a_sum_of_positive_terms(), motion_increases()]),
        ),
        Rung.POINTS.check(
            f"certified runs with α_2 = {SIGN}, ε = {EPSILON}, ν = {NU}, β = "
            f"{', '.join(map(str, BETAS))}: lift-off, by the exact solution with p > 0, b > 0 and y < 0, and no other "
            "change of phase until t = 1",
            all_of([runs_do_not_touch_down(), *map(begins_as_stated, BETAS)]),
        ),
        note="Of b < 0 at lift-off nothing is said.",
    )


ENTRIES: Builders = {"3-flight-persists": _persists}
"""The flight in Case II."""
