"""Ledger of the example after the corollary (lines 1844 to 1907): every printed coefficient, chi as a symbol."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts
from gspot_verified.paper.section_2.extended_system import extended_terms
from gspot_verified.paper.section_4 import section_4_trivial as trivial
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA as MODEL
from gspot_verified.paper.section_5 import double_series
from gspot_verified.paper.section_5.double_series import example_series, scaled_series

SECTION = Section("Section 5, example")
ALGEBRA = Algebra("s delta t epsilon chi")
_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "5-example-p": {
        "series": "-s + s^2*chi*delta^2 + 2*s^3*chi^2*delta^4 + (3*s^4*chi^3 - 96*s*chi^3)*delta^6",
        "error": "delta^8",
    },
    "5-example-b": {
        "series": "2*s + 6*chi*s^2*delta^2 + (12*chi^2*s^3 - 96*chi^2)*delta^4"
        " + (138*chi^3*s^4/5 - 10368*s*chi^3/5)*delta^6",
        "error": "delta^7",
    },
    "5-example-b-error": {"error": "delta^8", "term 7": "0*chi"},
    "5-example-y": {
        "series": "-4 - 16*chi*s*delta^2 + 8*chi*delta^3 - 48*chi^2*s^2*delta^4 + 48*s*chi^2*delta^5"
        " + (-736*chi^3*s^3/5 + 13824*chi^3/5 - 48*chi^2)*delta^6",
        "error": "delta^7",
    },
    "5-example-v": {
        "series": "-16*chi*delta^2 - 96*s*chi^2*delta^4 + 48*chi^2*delta^5 - 2208*s^2*chi^3/5*delta^6",
        "error": "delta^7",
    },
    "5-example-z": {
        "series": "-2 - 8*s*chi*delta^2 + 8*chi*delta^3 - 24*s^2*chi^2*delta^4 + 48*s*chi^2*delta^5"
        " + (-368*s^3*chi^3/5 + 6912*chi^3/5 - 48*chi^2)*delta^6",
        "error": "delta^7",
    },
    "5-example-zbar": {
        "scaled": "-2 - 8*s*delta^2 + 8*delta^3 - 24*s^2*delta^4 + 48*s*delta^5 + (-368*s^3/5 + 6672/5)*delta^6",
        "first": "-2 - 8*t + 8*epsilon - 24*t^2 + 48*t*epsilon - 368*t^3/5 + 6672/5*epsilon^2",
        "second": "-2 - 8*t - 24*t^2 - 368/5*t^3 + (8 + 48*t)*epsilon + 6672/5*epsilon^2",
        "error": "delta^7",
    },
}
CORRECTED: dict[str, dict[str, str]] = {"5-example-b-error": {"error": "delta^7", "term 7": "2208*chi^3/5"}}
STATED_ERROR = {"5-example-zbar": ((4, 0), (2, 1), (1, 2), (0, 3))}
"""O(t^4, epsilon t^2, epsilon^2 t, epsilon^3): the exponents of t and epsilon."""
_LATEX = {
    "p": r"\tilde{\bar p}=-s+\chi s^2\delta^2+2\chi^2s^3\delta^4+(3\chi^3s^4-96\chi^3s)\delta^6+O(\delta^8)",
    "b": r"\tilde{\bar b}=2s+6\chi s^2\delta^2+\ldots+(\tfrac{138}5\chi^3s^4-\tfrac{10368}5\chi^3s)\delta^6",
    "y": r"\tilde{\bar y}=-4-16\chi s\delta^2+8\chi\delta^3-\ldots+O(\delta^7)",
    "v": r"\tilde{\bar v}=-16\chi\delta^2-96\chi^2s\delta^4+48\chi^2\delta^5-\ldots+O(\delta^7)",
    "z": r"\tilde{\bar z}=-2-8\chi s\delta^2+8\chi\delta^3-\ldots+O(\delta^7)",
}
_ORDERS, _FURTHER = 9, 12


def by_recursion(name: str, orders: int) -> fmpq_mpoly:
    """The terms n < orders by Theorem 1's recursion."""
    total = ALGEBRA.constant(0)
    for n, row in enumerate(extended_terms(_ORDERS, chi=True)[name][:orders]):
        for k, value in enumerate(row):
            total += ALGEBRA.bring(value) * _SYMBOLS["s"] ** k * _SYMBOLS["delta"] ** n
    return total


def by_double_series(name: str, orders: int) -> fmpq_mpoly:
    """The same terms from the series in (t, epsilon)."""
    return scaled_series(ALGEBRA, name, orders)


def _order(parts: Parts) -> int:
    return int(parts["error"].total_degree())


def _series(name: str) -> Entry:
    identifier = f"5-example-{name}"
    this = Claim(ALGEBRA, PRINTED[identifier])
    what = {"b": "through δ^6 (its error term: entry 5-example-b-error)"}.get(name, "below the stated error term")
    return SECTION.settled(
        identifier,
        {"p": "line 1848", "b": "line 1853", "y": "line 1859", "v": "line 1865", "z": "line 1870"}[name],
        _LATEX[name],
        f"In the example the expansion of {name} is the printed one, in every coefficient {what}",
        this.check(
            "Theorem 1's recursion with χ as a symbol",
            lambda parts: [parts["series"] - by_recursion(name, _order(parts))],
        ),
        this.check(
            "power series in (t, ε) from one equation for b, without the inner scale",
            lambda parts: [parts["series"] - by_double_series(name, _order(parts))],
        ),
    )


def _b_error() -> Entry:
    this = Claim(ALGEBRA, PRINTED["5-example-b-error"], CORRECTED["5-example-b-error"])
    series = ALGEBRA.read(PRINTED["5-example-b"]["series"])

    def differences(parts: Parts, found: Callable[[str, int], fmpq_mpoly]) -> list[fmpq_mpoly]:
        exact = found("b", 8)
        through = series - found("b", _order(parts))
        return [ALGEBRA.coefficient_of(exact, "delta", 7) - parts["term 7"], through]

    return SECTION.settled(
        "5-example-b-error",
        "line 1857",
        r"\tilde{\bar b}=\ldots+\mathcal O(\delta^8)",
        "The error of the printed expansion of b is O(δ^8)",
        this.check(
            "Theorem 1's recursion",
            lambda parts: differences(parts, by_recursion),
            fault="the coefficient of δ⁷ is {left}, not 0",
        ),
        this.check(
            "power series in (t, ε)",
            lambda parts: differences(parts, by_double_series),
            fault="the coefficient of δ⁷ is {left}, not 0",
        ),
        corrected="O(δ^7): the next term is b_7 = (2208/5) χ³, in P_0 as Theorem 1 allows (ν = 3)",
        note="For p, O(δ^8) is right: p_7 = 0.",
    )


def _zbar() -> Entry:
    this = Claim(ALGEBRA, PRINTED["5-example-zbar"])
    chi_is_1 = {"chi": ALGEBRA.constant(1)}
    inner = {"t": ALGEBRA.read("delta^2*s"), "epsilon": ALGEBRA.read("delta^3")}

    def recursion(parts: Parts) -> list[fmpq_mpoly]:
        exact = ALGEBRA.substitute(by_recursion("z", _order(parts)), chi_is_1)
        outer = [ALGEBRA.substitute(parts[name], inner) for name in ("first", "second")]
        return [exact - parts["scaled"], *(exact - value for value in outer)]

    def direct(parts: Parts) -> list[fmpq_mpoly]:
        total = ALGEBRA.constant(0)
        for (i, j), value in example_series(_ORDERS + 3)["z"].items():
            if j < 2:  # epsilon^2 in front
                return [ALGEBRA.constant(1)]
            if not any(i >= k and j - 2 >= m for k, m in STATED_ERROR["5-example-zbar"]):
                total += value(1) * _SYMBOLS["t"] ** i * _SYMBOLS["epsilon"] ** (j - 2)
        # Below the stated order in delta, where t^i epsilon^j counts as 2 i + 3 j.
        below = ALGEBRA.coefficients(ALGEBRA.substitute(total, inner), "delta")
        terms = (value * _SYMBOLS["delta"] ** n for n, value in below.items() if n < _order(parts))
        scaled = sum(terms, start=ALGEBRA.constant(0))
        return [total - parts["first"], total - parts["second"], scaled - parts["scaled"]]

    return SECTION.settled(
        "5-example-zbar",
        "lines 1896 to 1906",
        r"\bar z=\epsilon^2(-2-8t-24t^2-\tfrac{368}5t^3+(8+48t)\epsilon+\tfrac{6672}5\epsilon^2"
        r"+O(t^4,\epsilon t^2,\epsilon^2t,\epsilon^3))",
        "For χ = 1 the expansion of z is, below the stated errors, the printed polynomial in t and ε, in all three "
        "forms",
        this.check("Theorem 1's recursion through δ⁶ with t = δ² s, ε = δ³", recursion),
        this.check("power series in (t, ε): all terms below the stated error", direct),
        note="6672/5 = 6912/5 - 48. χ = 0: 5-example-trivial.",
    )


def at_chi_0(name: str) -> fmpq_mpoly | None:
    """The printed series of a variable for χ = 0, in t and ε; ``None`` where it has other powers of them."""
    series = ALGEBRA.substitute(ALGEBRA.read(PRINTED[f"5-example-{name}"]["series"]), {"chi": ALGEBRA.constant(0)})
    total = MODEL.constant(0)
    for n, in_s in ALGEBRA.coefficients(series, "delta").items():
        for k, number in ALGEBRA.coefficients(in_s, "s").items():
            power, rest = divmod(n + double_series.POWER_OF_DELTA[name] - 2 * k, 3)
            if rest or power < 0:
                return None
            total += MODEL.bring(number) * MODEL.symbols["t"] ** k * MODEL.symbols["epsilon"] ** power
    return total


def in_the_example(value: fmpq_mpoly) -> fmpq_mpoly:
    """The value for the α's of the example; c is α_2/(α_1 - α_3)."""
    first, second, third = double_series.ALPHA
    numbers = {"alpha1": first, "alpha2": second, "alpha3": third, "c": second / (first - third)}
    return MODEL.substitute(value, {name: MODEL.constant(number) for name, number in numbers.items()})


def is_the_trivial_solution() -> bool | None:
    """Whether each series for χ = 0 is what 2-trivial and 2-trivial-zy have."""
    texts = trivial.PRINTED["2-trivial"] | trivial.CORRECTED["2-trivial-zy"]
    return all(at_chi_0(name) == in_the_example(MODEL.read(text)) for name, text in texts.items())


def solves_the_motivating_example() -> bool | None:
    """Whether the series for χ = 0 solve modelsys1 to modelsys5 in contact, with v = 0, y and z constant."""
    found = {name: value for name in "pbyvz" if (value := at_chi_0(name)) is not None}
    if len(found) < len("pbyvz"):
        return False
    at_rest = [found["v"], *(found[name].derivative("t") for name in "yz")]
    return all(in_the_example(value).is_zero() for value in (*at_rest, *trivial.in_model_system(found)))


def further_terms_vanish() -> bool | None:
    """Whether the recursion for χ = 0 has no term of the orders 1, ..., 11, for symbols α_1, α_3, c."""
    terms = extended_terms(_FURTHER, chi=False)
    return all(a == 0 for name in "pbyvz" for row in terms[name][1:] for a in row)


def _trivial() -> Entry:
    return SECTION.settled(
        "5-example-trivial",
        "lines 1885 to 1886",
        r"\chi=0:\ \bar p=\alpha_1^*t,\ \bar b=\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}\alpha_1^*t,\ \bar v=0",
        "For χ = 0 the printed expansions of the example are, through their printed orders, the trivial solution, "
        "with the corrected z and y of 2-trivial-zy",
        Rung.EXACT.check(
            "the five printed series with χ = 0, in t and ε, against the formulas of the trivial solution",
            is_the_trivial_solution(),
        ),
        Rung.EXACT.check(
            "the five printed series with χ = 0 put into modelsys1 to modelsys5; v = 0, y and z constant",
            solves_the_motivating_example(),
        ),
        Rung.POINTS.check(
            f"Theorem 1's recursion for χ = 0: no term of the orders 1 to {_FURTHER - 1}, symbols α_1, α_3, c",
            further_terms_vanish(),
        ),
    )


ENTRIES: Builders = {
    "5-example-p": partial(_series, "p"),
    "5-example-b": partial(_series, "b"),
    "5-example-b-error": _b_error,
    "5-example-y": partial(_series, "y"),
    "5-example-v": partial(_series, "v"),
    "5-example-z": partial(_series, "z"),
    "5-example-trivial": _trivial,
    "5-example-zbar": _zbar,
}
"""The printed series, in the order of the paper."""
