"""A measurement as text for a terminal, and the words that the report shares with it."""

from __future__ import annotations

from collections.abc import Iterator

from gspot_verified.cost.measurement.findings import Crossover, PowerLaw, certificate_prices, crossovers, growth
from gspot_verified.cost.measurement.measurement import CERTIFIED, CheapAnswer, Measurement, Part, Point, Route
from gspot_verified.cost.times.rows import seconds_text

_UNITS = ((2**30, "GiB"), (2**20, "MiB"), (2**10, "KiB"))


def measurement_text(measurement: Measurement) -> str:
    """All parts as aligned text."""
    blocks = ["\n".join(part_lines(part)) for part in measurement.parts]
    blocks.append("\n".join(answer_lines(measurement.answers)))
    blocks.append(
        f"{measurement.machine}; {', '.join(f'{name} {version}' for name, version in measurement.versions)}\n"
        f"{measurement.date}; {measurement.load}; {measurement.seconds:.0f} s in all. Processor time."
    )
    return "\n\n".join(blocks)


def part_lines(part: Part) -> Iterator[str]:
    """The lines of one part."""
    yield part.title
    yield f"  {part.question}"
    for route in part.routes:
        yield f"  {panel_words(route.panel)}{route.name}{'' if route.kind == CERTIFIED else f' ({route.kind})'}"
        for point in route.points:
            memory = "" if point.memory is None else f"  memory {bytes_text(point.memory)}"
            times = f"{seconds_text(point.best):>9}  median {seconds_text(point.median):>9} of {point.repeats:2}"
            yield f"    {point.asked:>16}  {place_text(point.place):>9}  {times}{memory}"
        if route.note:
            yield f"    {route.note}"
    for item in map(growth, part.routes):
        if item.exponent is not None:
            yield f"  {panel_words(item.route.panel)}{item.route.name}: {growth_text(item)}"
    for crossover in crossovers(part):
        yield f"  {crossover_text(crossover, part)}"
    for price in certificate_prices(part):
        yield (
            f"  {panel_words(price.panel)}at {place_text(price.place)}: {price.certified}, certified, takes "
            f"{price.factor:.3g} times the time of {price.cheap}, without a bound"
        )
    if part.shares:
        yield f"  the time of {part.shares_of}: " + ", ".join(f"{s.words} {s.part:.0%}" for s in part.shares)
    if part.limit is not None:
        yield f"  {limit_text(part)}"


def answer_lines(answers: tuple[CheapAnswer, ...]) -> Iterator[str]:
    """The table of cheap answers, a block for each."""
    yield "What accuracy buys: the same question at 53 bits, of mpmath as it comes, and certified"
    for answer in answers:
        yield f"  {answer.question}"
        yield f"    certified: {answer.certified} ({' and '.join(answer.routes)})"
        for name, said in ((f"53 bits, {answer.doubles_how}", answer.doubles), ("mpmath", answer.mpmath)):
            yield f"    {name}: {said}{' (wrong)' if answer.wrong(said) else ''}"


def panel_words(panel: str) -> str:
    """The panel before the name of a route, when there is one."""
    return f"{panel}: " if panel else ""


def place_text(place: float) -> str:
    """A place in up to four digits.

    >>> place_text(15.0), place_text(12.9), place_text(1e6).split()
    ('15', '12.9', ['1', '000', '000'])
    """
    text = f"{place:,.0f}" if place >= 1000 or place == int(place) else f"{place:.3g}"
    return text.replace(",", "\N{NARROW NO-BREAK SPACE}")


def bytes_text(size: int) -> str:
    """A size in memory.

    >>> bytes_text(3 * 2**20)
    '3 MiB'
    """
    for scale, unit in _UNITS:
        if size >= scale:
            return f"{size / scale:.3g} {unit}"
    return f"{size} bytes"


def growth_text(item: PowerLaw) -> str:
    """The fitted exponent, where it was fitted, and what theory expects."""
    if item.exponent is None:
        return "not fitted"
    expected = "" if item.route.exponent is None else f", expected in the long run {item.route.exponent:g}"
    return f"power {item.exponent:.2f} from {place_text(item.first)} to {place_text(item.last)}{expected}"


def crossover_text(item: Crossover, part: Part) -> str:
    """The sentence on one crossover."""
    where = f" ({item.panel})" if item.panel else ""
    place = place_text(round_place(item.place))
    return f"From {part.symbol} ≈ {place} on, {item.faster} is faster than {item.slower}{where}."


def round_place(place: float) -> float:
    """Two digits of a place that was found by interpolation.

    >>> round_place(95.37), round_place(5882.0)
    (95.0, 5900.0)
    """
    return float(f"{place:.2g}")


def limit_text(part: Part) -> str:
    """The sentence on the limit; empty where there is none."""
    limit = part.limit
    if limit is None:
        return ""
    return (
        f"{limit.asked}: {seconds_text(limit.took)}, {limit.factor:.3g} times the limit, "
        f"{seconds_text(limit.seconds)}: {limit.words}."
    )


def first_and_last(route: Route) -> tuple[Point, Point] | None:
    """The points at the least and at the largest place."""
    if not route.points:
        return None
    ordered = sorted(route.points, key=lambda point: point.place)
    return ordered[0], ordered[-1]
