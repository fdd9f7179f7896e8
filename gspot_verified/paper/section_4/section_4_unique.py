"""Ledger of Section 4.1: the trivial solution is unique as a formal series, not as a smooth function.

Transcribes the steps of proofs/smooth_trajectory.md. w stands for ε^n with any n >= 1, f0, f1, ... for the term b_n
and its derivatives, k for the number of a derivative or of a power of t.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Claim, Parts, Route, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_2.extended_system import extended_terms
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, around, with_c
from gspot_verified.paper.section_4.section_4_outer import PRINTED as OUTER
from gspot_verified.paper.section_4.section_4_trivial import CORRECTED as TRIVIAL
from gspot_verified.paper.section_4.section_4_trivial import first_terms

SECTION = Section("Section 4")
_PAGE = "smooth_trajectory"
_SYMBOLS = ALGEBRA.symbols
_WITH_BETA = {"alpha3": ALGEBRA.read("beta*alpha1")}
PRINTED: dict[str, dict[str, str]] = {
    "4-unique": {"order 0": "alpha3*b0 + alpha1*t*(alpha2-b1)", "order n": "alpha3*f0 - alpha1*t*f1", "b": "c*alpha1*t"}
}
FRACTION = {"numerator": "x", "denominator": "x + w"}
"""β is an integer j >= 0 plus this fraction, x and w any positive numbers: β > 0 is not an integer."""
STEPS = {
    "field": "epsilon*alpha3*f0 + (epsilon*(alpha3-alpha1) - alpha1*t)*f1 - alpha1*t*f2 - 2*f3",
    "recurrence": "-2*f3 + epsilon*((alpha3-(k+1)*alpha1)*f1 + (alpha3-k*alpha1)*f0)",
    "first": "(k+1)*(k+2)*(k+3)*(k+4) - (k+1)^3",
    "second": "(k+2)*(k+3)*(k+4) - (k+2)^3",
    "radius": "(4+x)^4 - 2*(4+x)^3 - x*(4+x) - x",
}
"""Section 3 of the page: ε⁴ φ'''' by f_k = ε^k φ^(k), A_(k+4) by f_i = A_(k+i), and three polynomials that are
positive for k >= 0, x = |α_1| + |α_3| > 0."""
ORDERS = 12


def differs_from_integers() -> bool:
    """Whether β − (j − i) and (j + 1 + i) − β are positive for every i >= 0: β differs from every integer."""
    part, whole = (ALGEBRA.read(FRACTION[name]) for name in ("numerator", "denominator"))
    i = _SYMBOLS["k"]
    for value in (i * whole + part, (i + 1) * whole - part):
        at_zero = ALGEBRA.substitute(value, {"k": ALGEBRA.constant(0)})
        if not (rising_signs(value) and rising_signs(at_zero)):
            return False
    return True


def by_derivatives(order: fmpq_mpoly) -> list[fmpq_mpoly]:
    """First proof of the lemma: t f^(k+1) = (β − k) f^(k) for every k, and the coefficient of t^k."""
    order = ALGEBRA.substitute(order, _WITH_BETA)

    def at(k: fmpq_mpoly) -> fmpq_mpoly:
        return ALGEBRA.substitute(order, {"beta": _SYMBOLS["beta"] - k})

    shift = {"f0": _SYMBOLS["f1"], "f1": _SYMBOLS["f2"]}
    step = ALGEBRA.derivative(at(_SYMBOLS["k"]), ALGEBRA.jets("t", "f"))
    # f = t^k: f0 and f1 times t.
    power = ALGEBRA.replaced(order, "f", [_SYMBOLS["t"], _SYMBOLS["k"]], ALGEBRA.constant(0))
    return [step - ALGEBRA.substitute(at(_SYMBOLS["k"] + 1), shift), power - ALGEBRA.read("alpha1*t*(beta-k)")]


def by_integrating_factor(order: fmpq_mpoly) -> list[fmpq_mpoly]:
    """Second proof of the lemma: t d/dt of f |t|^(−β) is zero; |t|^(−β) is the symbol x here."""
    euler = {"f0": ALGEBRA.read("t*f1"), "x": ALGEBRA.read("-beta*x")}
    rate = ALGEBRA.derivative(ALGEBRA.read("f0*x"), euler)
    return [_SYMBOLS["alpha1"] * rate + _SYMBOLS["x"] * ALGEBRA.substitute(order, _WITH_BETA)]


def _by_orders(parts: Parts) -> list[fmpq_mpoly]:
    whole, size = ALGEBRA.read(OUTER["4-eliminated"]["equation"]), _SYMBOLS["w"]
    near = around(whole, parts["b"], size)
    return [
        parts["order 0"] - ALGEBRA.coefficient_of(whole, "epsilon", 0),
        around(whole, parts["b"], ALGEBRA.constant(0)),
        ALGEBRA.coefficient_of(near, "epsilon", 0) - size * parts["order n"],
        *by_derivatives(parts["order n"]),
    ]


def _system(b: tuple[fmpq_mpoly, fmpq_mpoly], names: dict[str, tuple[fmpq_mpoly, fmpq_mpoly]]) -> list[fmpq_mpoly]:
    """modelsys2 to modelsys5 in b, y/ε², v/ε, z/ε², each with its rate."""
    (y, y_rate), (v, v_rate), (z, z_rate) = (names[name] for name in "yvz")
    epsilon, force = _SYMBOLS["epsilon"], z - y
    return [
        b[1] - _SYMBOLS["alpha2"] + _SYMBOLS["alpha3"] * force,
        epsilon * y_rate - v,
        epsilon * v_rate - b[0] - _SYMBOLS["alpha1"] * _SYMBOLS["t"] * force,
        epsilon * z_rate + z + force,
    ]


def _by_system(parts: Parts) -> list[fmpq_mpoly]:
    size, zero = _SYMBOLS["w"], ALGEBRA.constant(0)
    epsilon_squared = _SYMBOLS["epsilon"] ** 2
    rest = {name: ALGEBRA.read(TRIVIAL["2-trivial-zy"][name]) / epsilon_squared for name in "yz"} | {"v": zero}
    unknown = {name: (rest[name] + size * _SYMBOLS[f"{name.upper()}0"], size * _SYMBOLS[f"{name.upper()}1"])
               for name in "yvz"}  # fmt: skip
    line = parts["b"]
    found = _system((line + size * _SYMBOLS["f0"], line.derivative("t") + size * _SYMBOLS["f1"]), unknown)
    orders = [ALGEBRA.coefficients(with_c(value), "w") for value in found]
    at_rest = [value.get(0, zero) for value in orders]
    first = [ALGEBRA.coefficient_of(value.get(1, zero), "epsilon", 0) for value in orders]

    def without_force(rows: list[fmpq_mpoly]) -> fmpq_mpoly:
        return -_SYMBOLS["alpha3"] * rows[2] - _SYMBOLS["alpha1"] * _SYMBOLS["t"] * rows[0]

    free = {name: (_SYMBOLS[f"{name.upper()}0"], _SYMBOLS[f"{name.upper()}1"]) for name in "yvz"}
    leading = [ALGEBRA.coefficient_of(row, "epsilon", 0) for row in _system((_SYMBOLS["b0"], _SYMBOLS["b1"]), free)]
    return [
        *at_rest,
        without_force(leading) - parts["order 0"],
        without_force(first) - parts["order n"],
        *by_integrating_factor(parts["order n"]),
    ]


def _by_recursion(parts: Parts) -> list[fmpq_mpoly]:
    terms = extended_terms(ORDERS, chi=False)
    later = [ALGEBRA.bring(a) for n in range(1, ORDERS) for a in terms["b"][n]]
    return [first_terms()["b"] - parts["b"], *later]


def _unique() -> Entry:
    this = Claim(ALGEBRA, PRINTED["4-unique"])

    def on_page(what: str, route: Route) -> Check:
        return Page(_PAGE, (differs_from_integers,)).carries(this.check(what, route))

    return SECTION.settled(
        "4-unique",
        "lines 1020 to 1058",
        r"\bar b(t,\epsilon)=\frac{\alpha_2^*}{1-\beta}t",
        "For α_1, α_3 < 0, β not an integer: the only formal series Σ b_n(t) ε^n, each b_n smooth near t = 0, that "
        "solves the equation of line 984 is b = α_2 t/(1 - β)",
        on_page("sections 1 and 2: the order ε^n of line 984 for every n; f differentiated k times", _by_orders),
        on_page("sections 1 and 2: the order ε^n of modelsys2 to modelsys5; (|t|^(-β) f)' = 0", _by_system),
        this.check(
            f"Theorem 1's recursion with symbols α_1, α_3, c: every b_n with 0 < n < {ORDERS} vanishes",
            _by_recursion,
            Rung.POINTS,
        ),
        note="c = α_2/(α_1 - α_3). Functions instead of formal series: entry 4-unique-smooth.",
    )


def bounded_in_fast_time() -> bool:
    """Whether ε d/dt of (φ, εφ', ε²φ'', ε³φ''') is the stated one: bounded coefficients for bounded t, ε <= 1."""
    images = [_SYMBOLS["epsilon"] ** (4 - k) * _SYMBOLS[f"f{k}"] for k in range(5)]
    found = ALGEBRA.replaced(ALGEBRA.read(OUTER["4-deviation"]["equation"]), "b", images, ALGEBRA.constant(0))
    stated = ALGEBRA.read(STEPS["field"]) - _SYMBOLS["f4"]
    return bool((found - _SYMBOLS["epsilon"] ** 3 * stated).is_zero())


def bounded_coefficients() -> bool:
    """Whether the recurrence of the page is that of modelSysDev, and its three inequalities hold."""
    equation, epsilon = ALGEBRA.read(OUTER["4-deviation"]["equation"]), _SYMBOLS["epsilon"]
    # The coefficient of t^k in t^i φ^(j), times k! ε^k: k^i A_(k+j-i) ε^(i-j), for i <= 1.
    found = ALGEBRA.constant(0)
    for i, part in ALGEBRA.coefficients(equation, "t").items():
        for j in range(5):
            factor = part.derivative(f"b{j}")
            if not factor.is_zero():
                found += factor * _SYMBOLS["k"] ** i * epsilon ** (4 + i - j) * _SYMBOLS[f"f{j - i}"]
    recurrence = found - epsilon**3 * (ALGEBRA.read(STEPS["recurrence"]) - _SYMBOLS["f4"])
    positive = [rising_signs(ALGEBRA.read(STEPS[name])) for name in ("first", "second", "radius")]
    return bool(recurrence.is_zero()) and all(positive)


def deviation_solves() -> bool:
    """Whether the trivial solution plus w φ leaves w times modelSysDev of φ: a solution for every w."""
    trivial = around(
        ALGEBRA.read(OUTER["4-eliminated"]["equation"]), ALGEBRA.read(PRINTED["4-unique"]["b"]), _SYMBOLS["w"]
    )
    deviation = ALGEBRA.replaced(
        ALGEBRA.read(OUTER["4-deviation"]["equation"]), "b", [_SYMBOLS[f"f{k}"] for k in range(5)], ALGEBRA.constant(0)
    )
    return bool(trivial == _SYMBOLS["w"] * deviation)


def _smooth() -> Entry:
    finding = "b = c α_1 t + exp(-1/ε²) φ solves it too, and exp(-1/ε²) φ is smooth in t and ε >= 0"
    return SECTION.settled(
        "4-unique-smooth",
        "lines 1015 to 1018",
        r"\text{it is the only solution that is smooth in } t \text{ and } \epsilon",
        "For β not an integer the trivial solution is the only one that is smooth (C^∞) in t and ε",
        Page(_PAGE, (deviation_solves, bounded_in_fast_time)).refutation(
            "section 3, first proof: φ and its derivatives grow at most like exp(K/ε), by Gronwall", finding
        ),
        Page(_PAGE, (deviation_solves, bounded_coefficients)).refutation(
            "section 3, second proof: the power series of φ in t/ε, and Cauchy's estimates in ε", finding
        ),
        corrected="the only formal series in ε with smooth coefficients (4-unique), and the only solution analytic in "
        "ε; smooth solutions differ from it by less than every power of ε, for t in a bounded set",
        note="φ solves modelSysDev with φ = 1, φ' = φ'' = φ''' = 0 at t = 0; c = α_2/(α_1 - α_3).",
    )


ENTRIES: Builders = {"4-unique-smooth": _smooth, "4-unique": _unique}
"""Sec. 4.1, in the order of the paper."""
