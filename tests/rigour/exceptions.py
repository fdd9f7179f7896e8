"""The files that may conclude, those with nothing but heuristics, and the places that break a rule and are argued."""

from __future__ import annotations

import tomllib
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from rigour.rules import EVIDENCE, FLOATS, NEGATION, ORDER, RULES, SAYS, WRITTEN, ZERO, Finding

LIST = Path(__file__).with_name("exceptions.toml")

_FREE_OF = {
    "heuristics": (FLOATS, ORDER, ZERO, NEGATION, WRITTEN),
    "faces": tuple(rule for rule in RULES if rule not in (EVIDENCE, SAYS)),
}

Place = tuple[str, str, str]
"""A rule, a file and the function in it."""


@dataclass(frozen=True, slots=True)
class Exceptions:
    """What the list allows: by file the rules that do not hold in it, who may conclude, and how often which place may
    break which rule."""

    free: Mapping[str, tuple[str, ...]]
    says: frozenset[str]
    places: Mapping[Place, int]

    def allows(self, file: str, rule: str) -> bool:
        """Whether the rule does not hold in the file at all."""
        if rule == SAYS:
            return file in self.says
        return any(rule in rules and (file == name or file.startswith(name)) for name, rules in self.free.items())


def exceptions(text: str) -> Exceptions:
    """The list as it is written.

    :raises ValueError: a rule that there is not, no argument, a place that is written twice, or not as it should be.
    """
    data = tomllib.loads(text)
    free: dict[str, tuple[str, ...]] = {}
    for kind, rules in _FREE_OF.items():
        for name, why in data.pop(kind, {}).items():
            _argued(why, name)
            free[name] = rules
    says = data.pop("concludes", {})
    for name, why in says.items():
        _argued(why, name)
    places: dict[Place, int] = {}
    for entry in data.pop("exception", []):
        rule, why, listed = entry.pop("rule"), entry.pop("why"), entry.pop("at")
        if rule not in RULES or rule == SAYS or entry:
            raise ValueError(f"not a rule, or more than rule, why and at: {rule} {entry}")
        _argued(why, rule)
        for place in listed:
            file, _, rest = place.partition(" ")
            scope, _, number = rest.partition(" ")
            key = (rule, file, "" if scope == "-" else scope)
            if key in places or not scope:
                raise ValueError(f"{rule}: {place}: written twice, or without a function")
            places[key] = int(number or 1)
    if data:
        raise ValueError(f"unknown parts: {', '.join(data)}")
    return Exceptions(free, frozenset(says), places)


def _argued(why: str, name: str) -> None:
    if len(why.split()) < 2:
        raise ValueError(f"{name}: an exception needs an argument")


def complaints(found: Mapping[str, list[Finding]], listed: Exceptions) -> list[str]:
    """What the list does not allow, and what it allows and there is not, or not any more."""
    wrong, counted = [], Counter[Place]()
    for file, findings in found.items():
        for finding in findings:
            if listed.allows(file, finding.rule):
                continue
            place = (finding.rule, file, finding.scope)
            counted[place] += 1
            if counted[place] > listed.places.get(place, 0):
                wrong.append(f"{file}:{finding.line}: {finding.rule} [{finding.scope or '-'}]: {finding.text}")
    for place, number in listed.places.items():
        if counted[place] < number:
            rule, file, scope = place
            wrong.append(f"{file}: {rule} [{scope or '-'}]: argued for {number} places, there are {counted[place]}")
    for file in sorted(listed.says):
        if not any(finding.rule == SAYS for finding in found.get(file, [])):
            wrong.append(f"{file}: it may conclude, and does not")
    for name in listed.free:
        if not any(file == name or file.startswith(name) for file in found):
            wrong.append(f"{name}: there is no such file")
    return wrong
