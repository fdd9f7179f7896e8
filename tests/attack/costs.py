"""A ``cost.json`` made by hand beside a report: numbers beyond doubles, markup and control characters in texts, lists
that are cut. Refused with a ValueError; or the pages show it as text, say that they show a file, and the charts are
well-formed."""

from __future__ import annotations

import copy
import json
import re
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import Any
from xml.dom import minidom
from xml.parsers.expat import ExpatError

from attack.answers import AGREED, Answer, Attack, wrong
from attack.reports import _MARK, _MARKUP, _true_report, counted, shown_as_text

from gspot_verified.cost.measurement.file import parsed, recorded, written
from gspot_verified.cost.measurement.text import measurement_text
from gspot_verified.report.write import render_report

_NUMBERS = (0, 1, -1, 3, 1.5, -0.0, 1e308, 1e-308, 5e-324, 2**53, 2**80, 10**400, 1e16, True, "1", None)
_PARTS = 2


def attack(random: Random) -> Attack:
    """One file."""
    seed = random.getrandbits(32)
    return Attack(f"a cost.json changed by Random({seed})", lambda: judged(changed(Random(seed))))


@cache
def _true_file() -> Any:
    return json.loads(written(recorded()))


def _places(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    for key, child in data.items() if isinstance(data, dict) else enumerate(data):
        yield (*path, key), child
        if isinstance(child, dict | list):
            yield from _places(child, (*path, key))


def changed(random: Random) -> str:
    """The recorded file with a few places changed; infinity is written as JSON may."""
    data = copy.deepcopy(_true_file())
    data["parts"] = random.sample(data["parts"], _PARTS)
    places = list(_places(data))
    for path, child in random.sample(places, random.choice((1, 1, 2, 5))):
        owner = data
        try:
            for key in path[:-1]:
                owner = owner[key]
            if isinstance(child, str):
                owner[path[-1]] = random.choice(_MARKUP)
            elif isinstance(child, list):
                owner[path[-1]] = child[:1] * random.choice((0, 1, 2))
            elif not isinstance(child, dict):
                owner[path[-1]] = random.choice(_NUMBERS)
        except (KeyError, TypeError, IndexError):
            continue  # an earlier change has taken the place away
    text = json.dumps(data)
    return re.sub(r'("place": )[0-9.e+-]+', r"\g<1>1e999", text, count=1) if random.random() < 0.05 else text


def judged(text: str) -> Answer:
    """Refused, or shown as what it is."""
    try:
        measurement_text(parsed(text))
    except ValueError:
        return AGREED
    with tempfile.TemporaryDirectory() as folder:
        given, pages = Path(folder) / "given", Path(folder) / "pages"
        given.mkdir()
        (given / "report.json").write_text(json.dumps(counted(_true_report(Random(1)))), encoding="utf-8")
        (given / "cost.json").write_text(text, encoding="utf-8")
        render_report(given / "report.json", pages)
        for chart in (pages / "figures").glob("*.svg"):
            drawn = chart.read_text(encoding="utf-8")
            try:
                minidom.parseString(drawn.encode())
            except ExpatError as error:
                return wrong(f"{chart.name} is no XML: {error}")
            if _MARK in drawn or re.search(r'="-?(nan|inf)"', drawn):
                return wrong(f"{chart.name} holds markup of the data, or numbers that are none")
        return shown_as_text({page.name: page.read_text(encoding="utf-8") for page in pages.glob("*.html")})
