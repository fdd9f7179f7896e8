"""Ledger of Section 4 on its outer scale: the fast system with its eigenvalues.

f0, f1, ... are b and its derivatives in the fast time; p = alpha1 t is a constant there.
"""

from __future__ import annotations

from itertools import pairwise

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of, same_sign
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts, rising_signs
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, along, field
from gspot_verified.paper.section_4.section_4_outer import PRINTED as OUTER

SECTION = Section("Section 4")
_SYMBOLS = ALGEBRA.symbols
_STATES = Algebra("y v z p")
PRINTED: dict[str, dict[str, str]] = {
    "4-fast": {"equation": "-(p*(f1+f2) + 2*f3 + f4) + epsilon*(alpha3*f0 + (alpha3-alpha1)*f1)"},
    "4-fast-polynomial": {"polynomial": "-lam*(lam^3 + 2*lam^2 + p*lam + p)"},
    "4-discriminant": {"discriminant": "-p*(4*p^2 - 13*p + 32)"},
    "4-roots-sum": {"sum": "-2 + 0*p", "product": "-p"},
}
FAST_RATES = {"y": "v", "v": "p*(z - y)", "z": "-z - (z - y)"}
"""The contact at fixed p and b in the fast time t/ε: y/ε², v/ε and z/ε² less their values at rest."""
CUBIC = "lam^3 + 2*lam^2 + p*lam + p"
"""The second factor of the characteristic polynomial."""
ALLOWED = {"4-stable": "x", "4-saddle": "-x"}
"""All the values of p that a statement speaks of, as x takes all positive ones."""


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier])


def _fast() -> Entry:
    this = _claim("4-fast")
    p_is = {"p": ALGEBRA.read("alpha1*t")}

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        epsilon = _SYMBOLS["epsilon"]
        images = [epsilon ** (4 - k) * _SYMBOLS[f"f{k}"] for k in range(5)]
        slow = ALGEBRA.replaced(ALGEBRA.read(OUTER["4-deviation"]["equation"]), "b", images, epsilon**4)
        return [epsilon * slow - epsilon**4 * ALGEBRA.substitute(parts["equation"], p_is)]

    return SECTION.settled(
        "4-fast",
        "line 1087",
        r"-[p(\hat b_f'+\hat b_f'')+2\hat b_f'''+\hat b_f'''']+\epsilon[\ldots]=0",
        "In the fast time t_f = t/ε, with p = α_1 t, eq. modelSysDev becomes the equation of line 1087",
        this.check("chain rule in modelSysDev, times ε", chain_rule),
        this.check(
            "along the vector field of the deviations in fast time",
            lambda parts: [along(ALGEBRA.substitute(parts["equation"], p_is), "f", False)],
        ),
    )


def fast_matrix() -> list[list[fmpq_mpoly]]:
    """lam I minus the matrix of the fast system in (b, y, v, z) at epsilon = 0, with p for alpha1 t."""
    rates, states = field(False), ("b0", "y", "v", "z")
    limit = {"epsilon": ALGEBRA.constant(0), "alpha1": _SYMBOLS["p"], "t": ALGEBRA.constant(1)}
    rows = [[-ALGEBRA.substitute(rates[row].derivative(name), limit) for name in states] for row in states]
    return [[value + _SYMBOLS["lam"] * (i == j) for j, value in enumerate(row)] for i, row in enumerate(rows)]


def _polynomial() -> Entry:
    this = _claim("4-fast-polynomial")

    def exponential(parts: Parts) -> list[fmpq_mpoly]:
        equation = ALGEBRA.coefficient_of(ALGEBRA.read(PRINTED["4-fast"]["equation"]), "epsilon", 0)
        powers = [_SYMBOLS["lam"] ** k for k in range(5)]
        return [ALGEBRA.replaced(equation, "f", powers, ALGEBRA.constant(0)) - parts["polynomial"]]

    return SECTION.settled(
        "4-fast-polynomial",
        "line 1096",
        r"-\lambda[\lambda^3+2\lambda^2+p\lambda+p]=0",
        "The characteristic polynomial of the fast system is -λ(λ³ + 2 λ² + p λ + p)",
        this.check("exponentials in the fast equation at ε = 0", exponential),
        this.check(
            "determinant of λ I minus the 4 x 4 matrix of the fast system in (b, y, v, z)",
            lambda parts: [parts["polynomial"] + ALGEBRA.determinant(fast_matrix())],
        ),
    )


def _cubic_coefficients() -> list[fmpq_mpoly]:
    cubic = ALGEBRA.read(CUBIC)
    return [ALGEBRA.coefficient_of(cubic, "lam", k) for k in range(4)]


def _is_the_factor() -> bool:
    """Whether the cubic is the characteristic polynomial of the contact, and lam times it that of the fast system."""
    rates = [[ALGEBRA.read(str(value)) for value in row] for row in small_matrix()]
    rows = [[_SYMBOLS["lam"] * (i == j) - value for j, value in enumerate(row)] for i, row in enumerate(rates)]
    cubic, whole = ALGEBRA.read(CUBIC), ALGEBRA.determinant(fast_matrix())
    return bool(ALGEBRA.determinant(rows) == cubic and whole == _SYMBOLS["lam"] * cubic)


def _sign(identifier: str, value: fmpq_mpoly) -> int | None:
    """The sign for every p that the entry speaks of, when all coefficients have one sign."""
    value = ALGEBRA.substitute(value, {"p": ALGEBRA.read(ALLOWED[identifier])})
    return 1 if rising_signs(value) else -1 if rising_signs(-value) else None


def sums_of_two_roots(zero: fmpq_mpoly, one: fmpq_mpoly, two: fmpq_mpoly) -> fmpq_mpoly:
    """Of a monic cubic f with these coefficients: -f(-two - λ), whose roots are -two minus a root."""
    argument = -two - _SYMBOLS["lam"]
    return -(argument**3 + two * argument**2 + one * argument + zero)


def _stable() -> Entry:
    zero, one, two, three = _cubic_coefficients()
    hurwitz = [two, two * one - three * zero, zero]
    sums = sums_of_two_roots(zero, one, two)
    all_sums = [ALGEBRA.coefficient_of(sums, "lam", k) for k in range(4)]

    def all_positive(values: list[fmpq_mpoly]) -> bool | None:
        # With a negative one of either list there is a root with a real part >= 0.
        return all_of(same_sign(_sign("4-stable", value), 1) for value in values)

    return SECTION.settled(
        "4-stable",
        "lines 1101 to 1105",
        r"p>0:\ \operatorname{Re}\lambda_i<0",
        "For p > 0 all three roots of λ³ + 2 λ² + p λ + p, the rates of the contact at fixed p and b in the fast time "
        "t/ε, have negative real parts",
        Rung.EXACT.check(
            "Routh-Hurwitz: 1, 2, 2 p - p and p are polynomials in p with positive coefficients only",
            all_positive(hurwitz) if _is_the_factor() and all_positive([three]) else None,
        ),
        Rung.EXACT.check(
            "no real root is >= 0 (all coefficients positive), and twice the real part of a pair is a real root of the "
            "polynomial of the sums of two roots, λ³ + 4 λ² + (4 + p) λ + p, which has none >= 0 either",
            all_positive([zero, one, two, *all_sums]) if _is_the_factor() and three.is_one() else None,
        ),
    )


def _discriminant() -> Entry:
    this = _claim("4-discriminant")

    def formula(parts: Parts) -> list[fmpq_mpoly]:
        d, c, b, a = _cubic_coefficients()
        value = b**2 * c**2 - 4 * a * c**3 - 4 * b**3 * d - 27 * a**2 * d**2 + 18 * a * b * c * d
        return [value - parts["discriminant"]]

    return SECTION.settled(
        "4-discriminant",
        "line 1108",
        r"\Delta=-p(4p^2-13p+32)",
        "The discriminant of λ³ + 2 λ² + p λ + p is -p(4 p² - 13 p + 32)",
        this.check("the formula for the discriminant of a cubic", formula),
        this.check(
            "FLINT's discriminant of a polynomial in several variables",
            lambda parts: [ALGEBRA.read(CUBIC).discriminant("lam") - parts["discriminant"]],
        ),
    )


def sturm_chain() -> list[list[fmpq_mpoly]]:
    """The Sturm chain of the cubic in lam, each as coefficients from lam^0 up, for p < 0.

    Remainders are multiplied by squares of leading coefficients, so that no sign changes.
    """
    first = _cubic_coefficients()
    chain = [first, [k * a for k, a in enumerate(first)][1:]]
    while len(chain[-1]) > 1:
        rest, divisor = list(chain[-2]), chain[-1]
        while len(rest) >= len(divisor):
            leading = rest[-1]
            shift = len(rest) - len(divisor)
            scaled = [divisor[-1] ** 2 * value for value in rest]
            for k, value in enumerate(divisor):
                scaled[k + shift] -= leading * divisor[-1] * value
            rest = scaled[:-1]
        chain.append([-value for value in rest])
    return chain


def roots_for_negative_p() -> tuple[int, int] | None:
    """The numbers of real roots below and above 0 for every p < 0, by Sturm's theorem; None: a sign is open."""
    counts = []
    for place in (-1, 0, 1):
        signs = []
        for values in sturm_chain():
            sign = _sign("4-saddle", values[-1] if place else values[0])
            if sign is None:
                return None
            signs.append(sign * (-1) ** (len(values) - 1) if place < 0 else sign)
        counts.append(sum(a != b for a, b in pairwise(signs)))
    return counts[0] - counts[1], counts[1] - counts[2]


def small_matrix() -> list[list[fmpq_mpoly]]:
    """The matrix of the fast system in (y, v, z) with b = 0: Sec. 5's M, from the equations in contact."""
    return [[_STATES.read(FAST_RATES[row]).derivative(column) for column in "yvz"] for row in "yvz"]


def _roots() -> Entry:
    this = _claim("4-roots-sum")

    def vieta(parts: Parts) -> list[fmpq_mpoly]:
        zero, _, two, three = _cubic_coefficients()
        return [parts["sum"] * three + two, parts["product"] * three + zero]

    def trace_and_determinant(parts: Parts) -> list[fmpq_mpoly]:
        matrix = small_matrix()
        trace = sum((matrix[k][k] for k in range(3)), start=_STATES.constant(0))
        found = {"sum": trace, "product": _STATES.determinant(matrix)}
        return [parts[name] - ALGEBRA.read(str(value)) for name, value in found.items()]

    return SECTION.settled(
        "4-roots-sum",
        "lines 1109 to 1111",
        r"\sum\lambda_i=-2,\ \prod\lambda_i=-p",
        "The three roots of λ³ + 2 λ² + p λ + p have the sum -2 and the product -p",
        this.check("Vieta's formulas", vieta),
        this.check("trace and determinant of the 3 x 3 matrix of the fast system in (y, v, z)", trace_and_determinant),
    )


def _saddle() -> Entry:
    zero, _, two, three = _cubic_coefficients()
    real = same_sign(_sign("4-saddle", ALGEBRA.read(CUBIC).discriminant("lam")), 1)
    # Product of the roots -zero > 0: one or three positive roots, else none or two; their sum -two < 0 leaves one.
    one_positive = all_of([same_sign(_sign("4-saddle", zero), -1), _sign("4-saddle", two) == 1 or None])
    found = roots_for_negative_p()
    return SECTION.settled(
        "4-saddle",
        "lines 1107 to 1113",
        r"p<0:\ \lambda_1<\lambda_2<0<\lambda_3",
        "For p < 0 the three roots of λ³ + 2 λ² + p λ + p, the rates of the contact at fixed p and b in the fast time "
        "t/ε, are real and exactly one is positive",
        Rung.EXACT.check(
            "discriminant, sum and product of the roots, for every p < 0",
            all_of([real, one_positive]) if _is_the_factor() and three.is_one() else None,
        ),
        Rung.EXACT.check(
            "Sturm's theorem with p as a symbol: two roots below 0, one above",
            found == (2, 1) if _is_the_factor() and found is not None else None,
        ),
    )


ENTRIES: Builders = {
    "4-fast": _fast,
    "4-fast-polynomial": _polynomial,
    "4-stable": _stable,
    "4-discriminant": _discriminant,
    "4-roots-sum": _roots,
    "4-saddle": _saddle,
}
"""The fast system, in the order of the paper."""
