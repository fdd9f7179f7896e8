"""Ledger of Table 1: every printed exponent, measured and theoretical.

The series of epsilon of the simulations is not printed. A measured number is possible when some series of epsilon up to
10^-3 gives it, a series of its own; it is refuted when no series of small epsilon does, and the decades from 10^-3 to
10^-6 neither. That one series gives all the numbers is another statement.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from flint import arb, fmpq, fmpz

from gspot_verified.numbers.balls import ball_text, certainly_less, hull, sign_of, working_bits
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, in_greek, in_latex
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.numerics.at_the_g_spot import crossing, deviations
from gspot_verified.paper.numerics.scaling_exponents import (
    NAMES,
    exponent_error,
    limit_exponent,
    pair_error,
    regression_error,
    regression_slope,
    series_error,
)
from gspot_verified.theta_function.value.evaluate import evaluate

SECTION = Section("Section 3")
BETAS = (fmpq(1, 2), fmpq(3, 2), fmpq(5, 2))
NU = fmpq(2)


def _row(*texts: str) -> dict[fmpq, str]:
    return dict(zip(BETAS, texts, strict=True))


LINES = {"b": 892, "v": 893, "y": 894, "t": 895}
MEASURED: dict[str, dict[fmpq, str]] = {
    "b": _row("0.3326", "0.9982", "1.6635"),
    "v": _row("0.9983", "1.6652", "2.3396"),
    "y": _row("1.6538", "2.3384", "2.9808"),
    "t": _row("0.6650", "0.6656", "0.6659"),
}
THEORETICAL: dict[str, dict[fmpq, str]] = {
    "b": _row("0.3333", "1.0", "1.6667"),
    "v": _row("1.0", "1.6667", "2.3333"),
    "y": _row("1.6667", "2.3333", "3.000"),
    "t": _row("0.6667", "0.6667", "0.6667"),
}
FORMULAS = {"b": "2*beta/3", "v": "(2*beta+2)/3", "y": "(2*beta+4)/3", "t": "2/3"}
DECADES = (1000, 10, 4)
"""1/epsilon of the first, the ratio of neighbours, how many."""
Series = tuple[int, int | fmpq, int]
SERIES: dict[tuple[str, fmpq], tuple[Series, ...]] = {
    ("b", BETAS[0]): (DECADES, (2000, 5, 4)),
    ("b", BETAS[1]): ((1000, 8, 4), (2000, 3, 5)),
    ("b", BETAS[2]): ((1000, fmpq(3, 2), 3), (1250, fmpq(6, 5), 3)),
    ("v", BETAS[0]): (DECADES, (2000, 5, 4)),
    ("v", BETAS[1]): ((1000, 5, 5), (2000, 10, 3)),
    ("v", BETAS[2]): ((2000, 3, 4), (2500, 2, 5)),
    ("y", BETAS[1]): (DECADES, (2500, 3, 5)),
    ("y", BETAS[2]): ((2000, 3, 5), (2500, 7, 3)),
    ("t", BETAS[0]): ((2000, 5, 4), (2500, 2, 7)),
    ("t", BETAS[1]): ((1000, 5, 5), (2500, 2, 7)),
    ("t", BETAS[2]): ((10000, 5, 5), (20000, 10, 3)),
}
"""Series of epsilon that give a printed number; any that does will do, if it begins at BEGIN or below."""
BEGIN = fmpq(1, 1000)
LARGEST = fmpq(1, 1024)
"""Theorem E3 reaches every series of epsilon up to here."""
COMMON = fmpq(1, 2500)
"""So do Theorems E3 and E5 for the two reasons against one series for all numbers."""
PAIR = (("v", BETAS[2]), ("y", BETAS[1]))
"""Two quantities whose exponents are the same over every series."""
SINGLE = ("b", BETAS[2])
"""A quantity whose printed exponent no series up to COMMON gives (Theorem E3)."""
CORRECTED_Y = "from the trivial solution with the corrected y (2-trivial-zy)"
"""What y-hat is the deviation from."""
NONE_BELOW = {("b", BETAS[2]): fmpq(1, 2500), ("y", BETAS[2]): fmpq(1, 20000)}
"""No series of epsilon up to here (Theorem E3) gives the printed number; series of larger ones do."""
WAVES = (
    "from ε = 1/1000 to 1/1050, 1/1100 and 1/1200 the slopes are 1.6634, 1.6620 and 1.6635, and 1.6631, 1.6631 and "
    "1.6632 without them"
)
"""Of b-hat at β = 5/2."""
TINY = fmpq(1, 10**15)
"""Below it every series gives the printed limits."""
SMALL: Series = (10**13, 10, 2)
"""Two very small epsilon, at which the values are certified to more digits than the table has."""
CROSSINGS = dict(zip(BETAS, (fmpq(69, 100), fmpq(-31, 100), fmpq(12, 5)), strict=True))
"""Near a zero of Θ(τ, β); for β = 3/2 of the two that before the G-spot."""
TIME = fmpq(2, 3)
"""The power of ε in t = (2 ε²)^(1/3) τ (Theorem E4)."""
SYMBOLS = {"b": "b-hat", "v": "v-hat", "y": "y-hat", "t": "the time from p = 0 to b-hat = 0"}
_ALGEBRA = Algebra("beta")
_BITS = 96
_NEAR = fmpq(1, 20)


def rounding(text: str) -> tuple[fmpq, fmpq]:
    """A printed number and half a unit of its fourth decimal, the accuracy of the table."""
    digits = len(text.partition(".")[2])
    return fmpq(int(text.replace(".", "")), 10**digits), fmpq(1, 2 * 10**4)


def epsilons(series: Series) -> list[fmpq]:
    """The epsilon of a series."""
    first, ratio, count = series
    return [1 / (first * fmpq(ratio) ** k) for k in range(count)]


def value(name: str, beta: fmpq, epsilon: fmpq) -> arb | None:
    """What is measured: |b-hat|, |v-hat|, |y-hat| at p = 0, or |t| at a zero of b-hat."""
    found = crossing(beta, NU, epsilon, CROSSINGS[beta]) if name == "t" else deviations(beta, NU, epsilon)[name]
    return None if found is None else abs(found)


def slope(name: str, beta: fmpq, series: Series) -> arb | None:
    """The slope of the regression over a series."""
    found = [value(name, beta, epsilon) for epsilon in epsilons(series)]
    with working_bits(_BITS):
        logarithms = [entry.log() for entry in found if entry is not None]
        return regression_slope(logarithms, epsilons(series)) if len(logarithms) == len(found) else None


def is_the_number(text: str, found: arb | None) -> bool | None:
    """Whether a ball rounds to the printed number, certainly."""
    printed, half = rounding(text)
    if found is None or not found.is_finite():
        return None
    with working_bits(_BITS):
        distance = abs(found - printed)
        return True if distance < half else False if distance > half else None


def decimals(found: arb) -> str:
    """A positive number rounded to four decimals, as the table prints, where that is certain; else the ball."""
    with working_bits(_BITS):
        return _four_decimals((found * 10**4 + fmpq(1, 2)).floor().unique_fmpz()) or ball_text(found, 6)


def rounded_up(found: arb) -> str:
    """A number of four decimals that is at least the ball's, where the next one is certain; else the ball."""
    with working_bits(_BITS):
        return _four_decimals((found * 10**4).ceil().unique_fmpz()) or ball_text(found, 4)


def _four_decimals(units: fmpz | None) -> str:
    return "" if units is None or units < 0 else f"{int(units) // 10**4}.{int(units) % 10**4:04}"


def can_be_the_number(text: str, name: str, beta: fmpq, largest: fmpq) -> bool | None:
    """False when no series of epsilon up to ``largest`` gives the printed number; None: E3 does not exclude it."""
    printed, half = rounding(text)
    error = regression_error(beta, name, largest)
    with working_bits(_BITS):
        return False if certainly_less(error + half, arb(abs(limit_exponent(beta, name) - printed))) else None


def can_be_of_the_series(text: str, name: str, beta: fmpq, series: Series) -> bool | None:
    """False when the printed number is further from the limit than the slope over one series can be; else None."""
    printed, half = rounding(text)
    error = series_error(beta, name, epsilons(series))
    with working_bits(_BITS):
        return False if certainly_less(error + half, arb(abs(limit_exponent(beta, name) - printed))) else None


def either(first: bool | None, second: bool | None) -> bool | None:
    """Whether one of two claims holds: False when both fail, ``None`` when that is not certain."""
    return True if True in (first, second) else False if (first, second) == (False, False) else None


def text_of(series: Series) -> str:
    """A series in words."""
    first, ratio, count = series
    return f"ε = 1/{first} and on, each {1 / fmpq(ratio)} of the one before, {count} in all"


def by_series(name: str, beta: fmpq, series: Series) -> Check:
    """Whether the regression over one series gives the printed number; open for a series that begins above BEGIN."""
    found = slope(name, beta, series) if max(epsilons(series)) <= BEGIN else None
    finding = "" if found is None else f"the slope is {decimals(found)}"
    return Rung.BALLS.check(
        f"certified values and regression for {text_of(series)}", is_the_number(MEASURED[name][beta], found), finding
    )


def as_an_example(found: Check) -> Check:
    """The check of a statement that there is a series: one that gives another number shows nothing."""
    return replace(found, agrees=found.agrees or None)


def slope_with_the_printed_y(beta: fmpq, series: Series) -> arb | None:
    """The slope of |y less the y of eq. (29) as printed|, whose sign is the other one: y = 2 ε² α_2/(α_3 - α_1)."""
    points = epsilons(series)
    with working_bits(_BITS):
        twice = 4 * fmpq(-1) / (1 - beta)
        found = [abs(deviations(beta, NU, epsilon)["y"] - twice * epsilon**2) for epsilon in points]
        return regression_slope([entry.log() for entry in found], points)


def _with_the_printed_y(beta: fmpq) -> str:
    """What the slope over the decades is with eq. (29) as printed, where it is the printed number."""
    found, text = slope_with_the_printed_y(beta, DECADES), MEASURED["y"][beta]
    if not is_the_number(text, found):
        return ""
    return f"; {text} is the slope over these of y less eq. (29) as printed, which has the other sign (2-trivial-zy)"


def _from(name: str) -> str:
    return f" {CORRECTED_Y}," if name == "y" else ""


def _front(name: str, beta: fmpq) -> str:
    number = MEASURED[name][beta]
    return f"Table 1(a): the measured exponent of {SYMBOLS[name]},{_from(name)} β = {beta}, ν = 2, is {number},"


def _possible(name: str, beta: fmpq) -> Entry:
    return SECTION.settled(
        identifier(name, beta),
        f"line {LINES[name]} (β = {beta})",
        rf"\gamma={MEASURED[name][beta]}",
        f"{_front(name, beta)} the slope of the regression over some series of ε <= 10^-3, rounded to four decimals",
        *(as_an_example(by_series(name, beta, series)) for series in SERIES[name, beta]),
        note=_notes(name, beta),
    )


def _impossible(name: str, beta: fmpq) -> Entry:
    text, decades = MEASURED[name][beta], slope(name, beta, DECADES)
    by_value, limit = by_series(name, beta, DECADES), limit_exponent(beta, name)
    over_all = can_be_the_number(text, name, beta, LARGEST)
    every = f"every slope of the first kind is within {rounded_up(regression_error(beta, name, LARGEST))} of {limit}"
    bound = rounded_up(series_error(beta, name, epsilons(DECADES)))
    page = f"proofs/scaling_exponents.md: Theorem E3 for all series of ε <= {LARGEST} at once;"
    return SECTION.settled(
        identifier(name, beta),
        f"line {LINES[name]} (β = {beta})",
        rf"\text{{exponent for }}\hat {name},\ \beta={beta}\text{{: }}{text}",
        f"{_front(name, beta)} the slope of the regression over some series of ε <= {LARGEST} (neighbours at least 1 % "
        "apart), or over ε = 10^-3, 10^-4, 10^-5, 10^-6, rounded to four decimals",
        Rung.BALLS.check(
            f"{page} {by_value.what}", either(over_all, by_value.agrees), f"{every}; of the second {by_value.finding}"
        ),
        Rung.BALLS.check(
            f"{page} without values, Theorem E1 and the fast part at each ε, for {text_of(DECADES)}",
            either(over_all, can_be_of_the_series(text, name, beta, DECADES)),
            f"{every}; of the second the slope is within {bound} of {limit}",
        ),
        corrected=""
        if decades is None
        else f"{decimals(decades)} over ε = 10^-3, 10^-4, 10^-5, "
        f"10^-6{_with_the_printed_y(beta) if name == 'y' else ''}",
        note=f"{_notes(name, beta)} For the series of ε <= {LARGEST} both checks have the one derivation, Theorem E3.",
    )


def can_be_of_one_series(largest: fmpq) -> bool | None:
    """False when over one series of epsilon up to ``largest`` the numbers of PAIR are too near each other."""
    numbers, halves = zip(*(rounding(MEASURED[name][beta]) for name, beta in PAIR), strict=True)
    error = pair_error(PAIR[1][1], largest)
    with working_bits(_BITS):
        return False if certainly_less(error + sum(halves), arb(abs(numbers[0] - numbers[1]))) else None


def _one_series() -> Entry:
    (first, second), (third, beta) = PAIR, SINGLE
    decades = [slope(name, beta, DECADES) for name, beta in PAIR]
    printed = [MEASURED[name][beta] for name, beta in PAIR]
    return SECTION.settled(
        "3-table-1-one-series",
        "lines 844 to 847",
        r"\text{their values in a series of simulations where }\epsilon\text{ was varied}",
        "Table 1(a): the measured numbers are the slopes of regressions over one series for all of them, with "
        f"ε <= {COMMON} (neighbours at least 1 % apart), rounded to four decimals, y-hat being taken {CORRECTED_Y}",
        Rung.BALLS.check(
            f"proofs/scaling_exponents.md, Theorem E5: over one series the slopes of {SYMBOLS[first[0]]} at β = "
            f"{first[1]} and of {SYMBOLS[second[0]]} at β = {second[1]}",
            can_be_of_one_series(COMMON),
            f"they differ by at most {rounded_up(pair_error(second[1], COMMON))}; printed {' and '.join(printed)}",
        ),
        Rung.BALLS.check(
            f"Theorem E3: {SYMBOLS[third]} at β = {beta} over all series of ε <= {COMMON} at once",
            can_be_the_number(MEASURED[third][beta], third, beta, COMMON),
            f"{MEASURED[third][beta]} is the slope over none",
        ),
        corrected=""
        if None in decades
        else f"the series of the numbers differ, begin above {COMMON} or have neighbours less than 1 % apart, or some "
        "numbers are inexact or misprinted: over ε = 10^-3, 10^-4, 10^-5, 10^-6 the "
        f"slopes are {' and '.join(decimals(found) for found in decades if found is not None)} where "
        f"{' and '.join(printed)} are printed",
        note="Each number by itself, but for y-hat at β = 1/2, is the slope over some series of ε <= 10^-3. That one "
        f"is the slope over no series of ε <= {LARGEST}, nor over ε = 10^-3, 10^-4, 10^-5, 10^-6, unless the y of "
        "eq. (29) is taken as printed (3-table-1-y-1_2).",
    )


def _notes(name: str, beta: fmpq) -> str:
    found = (
        "The paper does not print its series of ε; the exponent is that of every ν > 0, but for ν = 1 where β > 1: "
        "that run is the trivial solution."
    )
    if name == "t" and beta == fmpq(3, 2):
        found += (
            " For small ε b-hat, as the formula of contact continues it, is 0 before and after the G-spot; this is the "
            "time before it."
        )
    if name == "b" and beta == fmpq(5, 2):
        found += f" At ε near 1/1000 the oscillations of the contact still show: {WAVES}."
    if (name, beta) in NONE_BELOW:
        found += f" No series of ε <= {NONE_BELOW[name, beta]} (neighbours 1 % apart or more) gives this number "
        found += "(proofs/scaling_exponents.md, Theorem E3)."
    return found


def identifier(name: str, beta: fmpq) -> str:
    """The identifier of one measured number."""
    return f"3-table-1-{name}-{str(beta).replace('/', '_')}"


def formula(name: str, beta: fmpq) -> fmpq:
    """The printed formula at one β."""
    found = _ALGEBRA.substitute(_ALGEBRA.read(FORMULAS[name]), {"beta": _ALGEBRA.constant(beta)})
    return found.leading_coefficient()


def printed_are(numbers: Mapping[fmpq, fmpq], name: str) -> bool | None:
    """Whether every printed theoretical number of a row is the rounded one."""
    pairs = [(numbers[beta], rounding(text)) for beta, text in THEORETICAL[name].items()]
    return all(abs(number - printed) <= half for number, (printed, half) in pairs)


def every_series_gives(name: str) -> bool | None:
    """Whether each regression over epsilon <= TINY rounds to the printed theoretical numbers."""
    answers = []
    for beta, text in THEORETICAL[name].items():
        error = regression_error(beta, name, TINY)
        with working_bits(_BITS):
            answers.append(is_the_number(text, limit_exponent(beta, name) + arb(0, error.abs_upper())))
    return all_of(answers)


def leading_terms_are_not_0() -> bool | None:
    """Whether Theorem E1 has its hypothesis, |N(0)| > η₀ D, in each row and at each β."""
    return all_of(exponent_error(beta, name, TINY).is_finite() or None for beta in BETAS for name in NAMES)


def _theoretical(name: str) -> Entry:
    formulas = {beta: formula(name, beta) for beta in BETAS}
    limits = {beta: limit_exponent(beta, name) for beta in BETAS}
    return SECTION.settled(
        f"3-table-1-theory-{name}",
        f"line {LINES[name]} (theoretical)",
        rf"\gamma\to {in_latex(FORMULAS[name])}",
        f"Table 1(b): for the start ν = 2 of Figure 6 the exponent of {SYMBOLS[name]} at p = 0{_from(name)} tends to "
        f"{in_greek(FORMULAS[name]).replace('*', '')} as ε → 0, for β = 1/2, 3/2, 5/2; its decimals are "
        f"{', '.join(THEORETICAL[name].values())}",
        Page("scaling_exponents", (leading_terms_are_not_0,)).carries(
            Rung.EXACT.check(
                "Theorem E1: the powers of C, η and ε in the exact solution are those of the printed formula, rounded "
                "to the decimals",
                all_of([formulas == limits, printed_are(limits, name)]),
            )
        ),
        Rung.BALLS.check(
            "proofs/scaling_exponents.md, Theorems E1 to E3: every series of ε <= 10^-15 (neighbours 1 % apart or "
            "more) gives the decimals",
            every_series_gives(name),
        ),
        Rung.POINTS.check(
            "certified values at ε = 10^-13 and 10^-14, without the limit of Theorem E1", values_follow(name)
        ),
        note=f"{SYMBOLS[name]} is negative there at ε = 10^-13 for {_betas(negative(name))}: the power is that of its "
        "size.",
    )


def negative(name: str) -> list[fmpq]:
    """The β at which the quantity is certainly negative at the first epsilon of SMALL."""
    found = {beta: deviations(beta, NU, epsilons(SMALL)[0])[name] for beta in BETAS}
    return [beta for beta, here in found.items() if sign_of(here) == -1]


def _betas(found: Sequence[fmpq]) -> str:
    return f"β = {' and '.join(map(str, found))}" if found else "no β"


def zeros_are_simple() -> bool | None:
    """Theorem E4 needs a simple zero of Θ(τ, β) other than 0 near each place."""
    return all_of([_simple_zero(beta, place) for beta, place in CROSSINGS.items()])


def _simple_zero(beta: fmpq, place: fmpq) -> bool | None:
    first, last = place - _NEAR, place + _NEAR
    signs = [sign_of(evaluate(tau, beta).value) for tau in (first, last)]
    with working_bits(_BITS):
        slope = evaluate(hull([arb(first), arb(last)]), beta, derivative=1).value
    if None in signs or sign_of(slope) is None:
        return None
    return set(signs) == {-1, 1} and sign_of(slope) != 0 and not first <= 0 <= last


def values_follow(name: str) -> bool | None:
    """Whether the exponent between the two epsilon of SMALL rounds to the printed limits."""
    return all_of(is_the_number(text, slope(name, beta, SMALL)) for beta, text in THEORETICAL[name].items())


def _theoretical_time() -> Entry:
    formulas = {beta: formula("t", beta) for beta in BETAS}
    return SECTION.settled(
        "3-table-1-theory-t",
        f"line {LINES['t']} (theoretical)",
        r"\gamma\to 2/3",
        f"Table 1(b): for the start ν = 2 of Figure 6 the exponent of {SYMBOLS['t']} tends to {FORMULAS['t']} as "
        "ε → 0, for β = 1/2, 3/2, 5/2",
        Page("scaling_exponents", (zeros_are_simple,)).carries(
            Rung.EXACT.check(
                "Theorem E4: t = (2 ε²)^(1/3) τ at a simple zero τ of G_β, and the decimals",
                all_of([set(formulas.values()) == {TIME}, printed_are(formulas, "t")]),
            )
        ),
        Rung.POINTS.check("certified crossings at ε = 10^-13 and 10^-14", values_follow("t")),
        note="For β = 3/2, at leading order, b-hat vanishes after the G-spot too: Θ(τ, 3/2) has one zero on each "
        "side of τ = 0 (that of dΘ/dτ(τ, 5/2): proofs/count_law.md). The time of the table is the one before.",
    )


def _builders() -> dict[str, Callable[[], Entry]]:
    found: dict[str, Callable[[], Entry]] = {"3-table-1-one-series": _one_series}
    for name in MEASURED:
        for beta in BETAS:
            build = _possible if (name, beta) in SERIES else _impossible
            found[identifier(name, beta)] = partial(build, name, beta)
        found[f"3-table-1-theory-{name}"] = _theoretical_time if name == "t" else partial(_theoretical, name)
    return found


ENTRIES: Builders = _builders()
"""The rows of Table 1, each measured number by itself, and all of them over one series."""
