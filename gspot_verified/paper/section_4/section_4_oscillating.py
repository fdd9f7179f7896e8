"""Ledger of Section 4.4: (-τ)^β alone does not determine Θ, since oscillating solutions are smaller.

Transcribes the steps of proofs/oscillating_solutions.md. F0, F1 are Ai, Ai' and G0, G1 are Bi, Bi' at c τ.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.appendix_a.hypergeometric import SERIES, SMALL
from gspot_verified.paper.checks.closed_forms import ALGEBRA as FORMS
from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.formulas import closed_form
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_4.section_4_inner import PRINTED as INNER

_PAGE = "oscillating_solutions"
SINES = ("-sine", "root*cosine/2 - sine/2", "root*cosine/2 + sine/2")
"""sin(π(j - β)/3), j = 0, 1, 2, by the sine and the cosine of πβ/3, with root² = 3."""
ALGEBRA = Algebra("tau c F0 F1 G0 G1 u sine cosine")
_SYMBOLS = ALGEBRA.symbols
POWERS = {"power series": "beta", "oscillating": "-beta/2 - 3/4"}
"""The powers of -τ of h and of e_r, e_i in Theorem 5 (th:4) of the paper."""
BETA = "x - 1/2"
"""All the β that the page speaks of, as x takes all positive values."""
AIRY = {"solution": "tau*F0*G0 - 4*c^2*F1*G1", "beta": "1/2", "4 c^3": "1"}
"""A solution, its β and its constant."""
LEADING = {("F0", "G0"): "-sine*cosine", ("F1", "G1"): "u^2*sine*cosine"}
"""π X^(1/2) Ai Bi and π X^(1/2) Ai' Bi' up to O(1/ζ) relative to u² = X = -c τ (DLMF 9.7.9 to 9.7.12)."""


def powers_of_the_series() -> bool:
    """Whether these are the powers of -τ in the first terms of h and of e_r + i e_i, as the paper prints them."""
    first = {"k": FORMS.constant(0)}
    return all(
        bool(FORMS.substitute(closed_form(SERIES[name]).exponent("x"), first) == FORMS.read(POWERS[power]))
        for name, power in (("h", "power series"), ("e", "oscillating"))
    )


def smaller_than_the_power() -> bool:
    """Whether the power of the oscillating solutions is below that of h for every β of the page."""
    exponents = Algebra("beta x")
    difference = exponents.read(POWERS["power series"]) - exponents.read(POWERS["oscillating"])
    return rising_signs(exponents.substitute(difference, {"beta": exponents.read(BETA)}))


def next_term_is_smaller() -> bool:
    """Whether the term t_N of the series, of the power β - 3N, is below the oscillating solutions for 2N > β + 1/2."""
    exponents = Algebra("beta x N")
    number = exponents.read("(beta + 1/2 + x)/2")
    rest = exponents.substitute(exponents.read(f"{POWERS['power series']} - 3*N"), {"N": number})
    return rising_signs(exponents.read(POWERS["oscillating"]) - rest)


def parts_of_the_determinant() -> bool:
    """Whether the matrix of h, e_r, e_i in th:4 has the determinant 18 √3 Σ (-1)^j Γ((3 - j + β)/3) r_k r_m.

    r_j = 1/Γ((j - β)/3); k < m are the two other numbers: the minor of row j has the sign (-1)^j in the sum.
    """
    found = []
    for j, (k, m) in enumerate(((1, 2), (0, 2), (0, 1))):
        real, imaginary = ([f"({SMALL[f'{part} {row}']})" for row in (k, m)] for part in ("real", "imaginary"))
        minor = f"{real[0]}*{imaginary[1]} - {real[1]}*{imaginary[0]}"
        product = closed_form(f"({SMALL[f'h {j}']})*({SMALL[f'e {k}']})*({SMALL[f'e {m}']})*({minor})")
        gammas = closed_form(f"Gamma(({3 - j}+beta)/3)/(Gamma(({k}-beta)/3)*Gamma(({m}-beta)/3))")
        found.append((product / (closed_form("18*sqrt(3)") * gammas)).is_one())
    return all(found)


def sines_do_not_cancel() -> bool:
    """Whether 1/S_0 - 1/S_1 + 1/S_2 is 3/4 over the product of the S_j = sin(π(j - β)/3): Γ(1 - x) Γ(x) = π/sin πx.

    So the determinant is finite and not 0 for β not an integer.
    """
    sines = Algebra("sine cosine root")
    first, second, third = map(sines.read, SINES)
    total = second * third - first * third + first * second - sines.read("3/4")
    for name, square in (("root", "3"), ("cosine", "1 - sine^2")):
        reduced = sines.constant(0)
        for power, part in sines.coefficients(total, name).items():
            reduced += part * sines.read(square) ** (power // 2) * sines.symbols[name] ** (power % 2)
        total = reduced
    return bool(total.is_zero())


def modulo_constant(value: fmpq_mpoly) -> fmpq_mpoly:
    """A polynomial with the value of 4 c³ put in."""
    cube = ALGEBRA.read(AIRY["4 c^3"]) / 4
    total = ALGEBRA.constant(0)
    for power, part in ALGEBRA.coefficients(value, "c").items():
        total += part * cube ** (power // 3) * _SYMBOLS["c"] ** (power % 3)
    return total


def airy_solves() -> bool:
    """Whether the Airy form solves hypergeomeqn with β = 1/2, by Ai''(z) = z Ai(z) with z = c τ."""
    images = {"tau": "1 + 0*c", "F0": "c*F1", "F1": "c^2*tau*F0", "G0": "c*G1", "G1": "c^2*tau*G0"}
    rates = {name: ALGEBRA.read(text) for name, text in images.items()}
    solution = ALGEBRA.read(AIRY["solution"])
    operator = Algebra("tau beta h0 h1 h2 h3")
    equation = operator.substitute(operator.read(INNER["4-theta"]["equation"]), {"beta": operator.read(AIRY["beta"])})
    total = ALGEBRA.constant(0)
    for k in range(4):
        factor = ALGEBRA.bring(equation.derivative(f"h{k}"))
        total += factor * ALGEBRA.derivative(solution, rates, k)
    return bool(modulo_constant(total).is_zero())


def airy_leading_term_cancels() -> bool:
    """Whether the terms of order X^(1/2) of the Airy form, times c, cancel: c τ is -u², and 4 c³ = 1."""
    solution = ALGEBRA.read(AIRY["solution"])
    total = ALGEBRA.constant(0)
    for (first, second), leading in LEADING.items():
        factor = solution.derivative(first).derivative(second)
        constant, linear = (ALGEBRA.coefficient_of(factor, "tau", power) for power in (0, 1))
        total += (_SYMBOLS["c"] * constant - _SYMBOLS["u"] ** 2 * linear) * ALGEBRA.read(leading)
    return bool(modulo_constant(total).is_zero())


def _behaves_like() -> Entry:
    finding = "Θ + θ ~ (-τ)^β for every oscillating solution θ"
    at_half = "β = 1/2: θ = τ Ai(cτ) Bi(cτ) - 4c² Ai'(cτ) Bi'(cτ), 4c³ = 1, is O(1/τ), so that Θ + θ ~ (-τ)^(1/2)"
    smaller = (powers_of_the_series, smaller_than_the_power)
    section_2 = (next_term_is_smaller, parts_of_the_determinant, sines_do_not_cancel)
    return Section("Section 4").settled(
        "4-behaves-like",
        "line 1219",
        r"\text{there is a unique solution } \Theta(\tau,\beta) \text{ that behaves like } (-\tau)^\beta",
        "Θ is the only solution with θ ~ (-τ)^β as τ → −∞",
        Page(_PAGE, (*smaller, *section_2)).refutation(
            "section 1, first proof: oscillating solutions are O((-τ)^(-β/2-3/4)), a smaller power; section 2: the "
            "corrected form",
            finding,
        ),
        Page(_PAGE, (airy_solves, airy_leading_term_cancels)).refutation(
            "section 1, second proof: a product of Airy functions at β = 1/2", at_half
        ),
        corrected="for β > -1/2 not an integer: the only solution that is the sum of the first N terms of the series "
        "of 3^(1-β/3) Γ(1+β) h (eq. hdef) up to o((-τ)^(-β/2-3/4)), for 2N > β + 1/2: the only one without e_r and "
        "e_i that is ~ (-τ)^β",
        note="'Behaves like' is ~ in lines 1201 to 1203. The first half of the sentence, that the coefficients of "
        "e_r and e_i must vanish, determines Θ together with it.",
    )


ENTRIES: Builders = {"4-behaves-like": _behaves_like}
"""The sentence on the choice of Θ."""
