"""Wrong numbers, values and bounds for Table 1."""

from __future__ import annotations

from typing import Any

from flint import arb, fmpq
from paper.bite import Bite, Teeth, Tooth, scaled

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_3 import table_1 as ledger

ENTRIES = ledger.ENTRIES
OTHER_PLACE = dict(zip(ledger.BETAS, (fmpq(-4), fmpq(3, 2), fmpq(-4)), strict=True))
"""Where b-hat does not vanish, or (β = 3/2) its other zero lies."""


def last_digit(honest: str) -> str:
    """One unit more or less in the fourth decimal."""
    return honest[:-1] + ("1" if honest[-1] == "0" else str(int(honest[-1]) - 1))


def in_row(table: dict[str, dict[fmpq, str]], name: str, beta: fmpq, change: Any) -> Any:
    """The table with one number changed."""
    return lambda honest: {**honest, name: {**honest[name], beta: change(table[name][beta])}}


def with_power(power: fmpq, places: Any = None) -> Any:
    """What is measured times a power of epsilon, or only where epsilon is one of the places."""

    def change(honest: Any) -> Any:
        def value(name: str, beta: fmpq, epsilon: fmpq) -> arb:
            with working_bits(96):
                other = places is not None and epsilon not in places
                return honest(name, beta, epsilon) * (arb(1) if other else arb(epsilon) ** power)

        return value

    return change


def decades_as_printed(name: str, beta: fmpq) -> Any:
    """Values that are right at one end, with the printed slope over the decades."""
    printed, _ = ledger.rounding(ledger.MEASURED[name][beta])
    return lambda _: lambda _name, _beta, epsilon: arb(epsilon) ** arb(printed)


def _possible(name: str, beta: fmpq) -> tuple[Tooth, ...]:
    first, second = (set(ledger.epsilons(series)) for series in ledger.SERIES[name, beta])
    large = {(name, beta): ((3, 2, 3), *ledger.SERIES[name, beta][1:])}
    outside = lambda honest: {**honest, **large}  # noqa: E731
    return (
        Bite("factor", ledger, "MEASURED", in_row(ledger.MEASURED, name, beta, last_digit)),
        Bite("factor", ledger, "value", with_power(fmpq(1, 1000))),
        Bite("hidden factor", ledger, "value", with_power(fmpq(1, 1000), second - first)),
        Bite("hypothesis", ledger, "SERIES", outside)
        if name != "t"
        else Bite("hypothesis", ledger, "CROSSINGS", lambda honest: dict.fromkeys(honest, OTHER_PLACE[beta])),
        Bite("order", ledger, "value", with_power(fmpq(1))),
    )


def _impossible(name: str, beta: fmpq) -> tuple[Tooth, ...]:
    def mended(_: str) -> str:
        return str(round(float(ledger.limit_exponent(beta, name).p) / float(ledger.limit_exponent(beta, name).q), 4))

    return (
        Bite("factor", ledger, "MEASURED", in_row(ledger.MEASURED, name, beta, mended)),
        Bite("hidden factor", ledger, "value", decades_as_printed(name, beta)),
        Bite("hypothesis", ledger, "LARGEST", lambda _: fmpq(1, 300)),
        Bite("order", ledger, "series_error", lambda honest: lambda *a: honest(*a) * 10),
        Bite("order", ledger, "regression_error", lambda honest: lambda *a: honest(*a) * 10),
    )


def _theory(name: str) -> tuple[Tooth, ...]:
    first, last = ledger.BETAS[0], ledger.BETAS[-1]
    if name == "t":
        return (
            Bite("factor", ledger.FORMULAS, "t", scaled),
            Bite("factor", ledger, "THEORETICAL", in_row(ledger.THEORETICAL, "t", first, last_digit)),
            Bite("hidden factor", ledger, "value", with_power(fmpq(1, 1000), {fmpq(1, 10**14)})),
            Bite("hypothesis", ledger, "CROSSINGS", lambda honest: {**honest, last: fmpq(1, 1000)}),
            Bite("order", ledger, "value", with_power(fmpq(1))),
        )
    return (
        Bite("factor", ledger.FORMULAS, name, scaled),
        Bite("factor", ledger, "THEORETICAL", in_row(ledger.THEORETICAL, name, last, lambda text: text + "9")),
        Bite("hidden factor", ledger.FORMULAS, name, lambda honest: f"{honest} + (beta-1/2)*(beta-3/2)/100"),
        Bite("hidden factor", ledger, "value", with_power(fmpq(1, 1000), {fmpq(1, 10**14)})),
        Bite("hypothesis", ledger, "TINY", lambda _: fmpq(1, 10**6)),
        Bite("order", ledger, "limit_exponent", lambda honest: lambda *a: honest(*a) + 1),
    )


def _teeth() -> Teeth:
    found: Teeth = {}
    for name in ledger.MEASURED:
        for beta in ledger.BETAS:
            rows = _possible if (name, beta) in ledger.SERIES else _impossible
            found[ledger.identifier(name, beta)] = rows(name, beta)
        found[f"3-table-1-theory-{name}"] = _theory(name)
    (name, beta), (_, other) = ledger.PAIR
    found["3-table-1-one-series"] = (
        Bite("factor", ledger, "MEASURED", in_row(ledger.MEASURED, name, beta, lambda _: ledger.MEASURED["y"][other])),
        Bite("hidden factor", ledger, "MEASURED", in_row(ledger.MEASURED, *ledger.SINGLE, lambda _: "1.6653")),
        Bite("hypothesis", ledger, "COMMON", lambda _: fmpq(1, 300)),
        Bite("order", ledger, "pair_error", lambda honest: lambda *a: honest(*a) * 10),
    )
    return found


TEETH: Teeth = _teeth()
