"""Certificates of runs: good ones, ways to make each of them wrong, and the checker with one rule changed.

After a change of the content the hash is computed anew, so that the check of the content has to find the fault.
"""

from __future__ import annotations

import copy
import json
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

from must_reject.mutate import text_of

from gspot_verified.scenes.certificates.run_certificate import certified_with_steps
from gspot_verified.scenes.scene.file import load_scene

CHECKER = Path(__file__).resolve().parents[2] / "proofs" / "checker"

Lines = list[Any]
Change = Callable[[Lines], Any]


def part(name: str) -> ModuleType:
    """A part of the checker, which is not a part of the package."""
    if str(CHECKER) not in sys.path:
        sys.path.append(str(CHECKER))
    return import_module(name)


def changed(*replacements: tuple[str, str], name: str = "run") -> ModuleType:
    """The checker of runs with other words in one of its files, as modules of its own."""
    names = ("intervals", "model", "mechanism", "run")
    kept = {each: part(each) for each in names}
    try:
        for each in names:
            source = (CHECKER / f"{each}.py").read_text(encoding="utf-8")
            for old, new in replacements if each == name else ():
                assert source.count(old) == 1, old
                source = source.replace(old, new)
            sys.modules[each] = ModuleType(each)
            exec(compile(source, f"{each}, changed", "exec"), sys.modules[each].__dict__)
        return sys.modules["run"]
    finally:
        sys.modules.update(kept)


def lines_of(text: str) -> Lines:
    """The lines of a certificate without its hash."""
    return [json.loads(line) for line in text.splitlines()[:-1]]


@cache
def _good(scene: str, settings: tuple[tuple[str, str], ...]) -> Lines:
    text = certified_with_steps(load_scene(scene, **dict(settings))).text
    assert text is not None
    return lines_of(text)


def flight() -> Lines:
    """Lift-off, touch-down and contact for ever."""
    return copy.deepcopy(_good("fig-varsim1", (("epsilon", "1/20"), ("until", "3"))))


def stick() -> Lines:
    """Stick and lift-off, with tangential motion and two-way coupling."""
    return copy.deepcopy(_good("fig-varsim2", (("nu", "4"), ("u", "1"), ("epsilon", "1/5"), ("until", "2"))))


def rod() -> Lines:
    """A mechanism: slip, stick, reverse slip and flight."""
    return copy.deepcopy(_good("rod", (("epsilon", "1/20"), ("until", "1/2"))))


def oscillator() -> Lines:
    """A mechanism with a divisor, in slip."""
    return copy.deepcopy(_good("oscillator", (("epsilon", "1/20"), ("until", "1/10"))))


def verdict(lines: Lines | bytes, run: ModuleType | None = None) -> str:
    """What the checker says of these lines."""
    data = lines if isinstance(lines, bytes) else text_of(lines)
    limits, reading = part("limits"), part("reading")
    own = limits.Limits()
    try:
        first, *rest = reading.read_lines(data, own)
        version, hypotheses, statement = reading.read_header(first)
        assert version == 4
        return f"VERIFIED {(run or part('run')).check_run(hypotheses, statement, rest, own, len(data))}"
    except limits.Rejected as reason:
        return f"REJECTED {reason}"


def phases(lines: Lines) -> list[int]:
    """At which lines phases begin."""
    return [i for i, line in enumerate(lines) if "phase" in line]


def changes(lines: Lines) -> Iterator[tuple[str, Change]]:
    """Ways to make a good certificate wrong, with their names."""
    yield from _of_events(lines)
    yield from _of_scene(lines)
    yield from _of_phases(lines)
    yield from _of_steps(lines)
    yield from _of_types(lines)
    if "mechanism" in lines[0]["statement"]:
        yield from _of_mechanism(lines)


def _set(*path: Any, to: Callable[[Any], Any]) -> Change:
    """Replace what lies at a path by a function of it."""

    def change(lines: Lines) -> None:
        at: Any = lines
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = to(at[path[-1]])

    return change


def _plus(value: Fraction) -> Callable[[str], str]:
    return lambda text: str(Fraction(text) + value)


def _of_events(lines: Lines) -> Iterator[tuple[str, Change]]:
    at = (0, "statement", "events")
    events = lines[0]["statement"]["events"]
    for i, (name, low, high) in enumerate(events):
        width = Fraction(high) - Fraction(low)
        moved = {
            "up": (width, width),
            "down": (-width, -width),
            "cut above": (0, -width / 2),
            "cut below": (width / 2, 0),
        }
        for how, (first, second) in moved.items():
            new = [name, str(Fraction(low) + first), str(Fraction(high) + second)]
            yield f"bracket of {name} {how}", _set(*at, i, to=lambda _, new=new: new)
        yield f"bracket of {name} turned", _set(*at, i, to=lambda event: [event[0], event[2], event[1]])
        yield f"{name} renamed", _set(*at, i, 0, to=lambda old: "touch-down" if old == "lift-off" else "lift-off")
        yield f"{name} left out", _set(*at, to=lambda old, i=i: old[:i] + old[i + 1 :])
        yield f"{name} twice", _set(*at, to=lambda old, i=i: old[: i + 1] + old[i:])
        for wrong in (0.5, None, "nan", "1/0", "0x1", True, "1.5", "-inf"):
            yield f"bracket of {name} from {wrong!r}", _set(*at, i, 1, to=lambda _, wrong=wrong: wrong)
    if events:
        yield "events in another order", _set(*at, to=lambda old: old[::-1])
        yield "no events", _set(*at, to=lambda _: [])
    other = {"time": "for ever", "for ever": "time"}
    yield "another end", _set(0, "statement", "end", to=lambda old: other[old])


def _of_scene(lines: Lines) -> Iterator[tuple[str, Change]]:
    statement = lines[0]["statement"]
    for name in statement["parameters"]:
        yield f"{name} + 1e-15", _set(0, "statement", "parameters", name, to=_plus(Fraction(1, 10**15)))
        yield f"{name} left out", lambda lines, name=name: lines[0]["statement"]["parameters"].pop(name)
    for name in statement["start"]:
        yield f"{name} moved at the start", _set(0, "statement", "start", name, to=_plus(Fraction(1, 10**25)))
    for name in ("k_1", "k_2", "damping"):
        yield f"{name} < 0", _set(0, "statement", "parameters", name, to=lambda old: f"-{old}")
    yield "no contact at the start", _set(0, "statement", "start", "z", to=lambda _: "-1")
    yield "epsilon + 1e-15", _set(0, "statement", "epsilon", to=_plus(Fraction(1, 10**15)))
    yield "epsilon < 0", _set(0, "statement", "epsilon", to=lambda old: f"-{old}")
    yield "epsilon as a float", _set(0, "statement", "epsilon", to=lambda _: 0.05)
    yield "epsilon too long", _set(0, "statement", "epsilon", to=lambda _: f"1/{10**500 + 1}")
    if statement["events"]:
        yield "until before the last event", _set(0, "statement", "until", to=lambda _: statement["events"][-1][1])
    if statement["end"] == "time":
        yield "until later", _set(0, "statement", "until", to=_plus(Fraction(1, 10**12)))
    for effect in statement["effects"] if statement["events"] else ["compliant_contact"]:  # others: also true
        yield f"without {effect}", _set(0, "statement", "effects", to=lambda old, e=effect: [x for x in old if x != e])
    yield "an unknown effect", _set(0, "statement", "effects", to=lambda old: [*old, "wind"])
    yield "an effect twice", _set(0, "statement", "effects", to=lambda old: [old[0], *old])
    yield "effects in another order", _set(0, "statement", "effects", to=lambda old: old[::-1])
    yield "another kind", _set(0, "statement", "kind", to=lambda _: "force")
    yield "other pages", _set(0, "hypotheses", to=lambda old: old[:-1])
    for bits in (0, 64, 100, 10**9, True, "320"):
        yield f"bits {bits!r}", _set(1, "bits", to=lambda _, bits=bits: bits)


def _of_phases(lines: Lines) -> Iterator[tuple[str, Change]]:
    heads = phases(lines)
    for i in heads:
        head = lines[i]
        for other in {"slip", "flight", "stick", "reverse slip", "rest"} - {head["phase"]}:
            yield f"phase at {i} called {other}", _set(i, "phase", to=lambda _, other=other: other)
        yield f"a step less in the phase at {i}", _set(i, "steps", to=lambda n: n - 1)
        yield f"a step more in the phase at {i}", _set(i, "steps", to=lambda n: n + 1)
        yield f"no steps in the phase at {i}", _set(i, "steps", to=lambda _: 0)
        yield f"true steps in the phase at {i}", _set(i, "steps", to=lambda _: True)
        if not head["event"]:
            continue
        (left, e), (right, _) = head["bracket"]
        width = 1000 * (right - left)
        brackets = {
            "left": [[left - width, e], [right - width, e]],
            "right": [[left + width, e], [right + width, e]],
            "turned": [[right, e], [left, e]],
            "of no width": [[right, e], [right, e]],
            "from 0": [[0, 0], [right, e]],
            "from before 0": [[-1, 0], [right, e]],
            "beyond 1": [[left, e], [3, -1]],
            "empty": [],
            "of three": [[left, e], [right, e], [right, e]],
        }
        for how, new in brackets.items():
            yield f"bracket at {i} {how}", _set(i, "bracket", to=lambda _, new=new: new)
        yield f"no event at {i}", lambda lines, i=i: lines[i].update(event="", bracket=[])
        for event in {"lift-off", "touch-down", "stick", "slip"} - {head["event"]}:
            yield f"{event} at {i}", _set(i, "event", to=lambda _, event=event: event)
        yield f"a cone at {i}", _set(i, "cone", to=lambda _: ["1/10"])
    last = heads[-1]
    cone = lines[last]["cone"]
    if cone:
        yield "the end of the time in place of a cone", _set(last, "cone", to=lambda _: [])
        yield "a steeper cone", _set(last, "cone", 0, to=lambda a: str(50 * Fraction(a)))
        yield "a cone that falls", _set(last, "cone", 0, to=lambda a: f"-{a}")
        yield "a cone of a point", _set(last, "cone", 0, to=lambda _: "0")
        yield "a slow cone with a large c", _set(last, "cone", to=lambda old: [old[0], "1000"])
        yield "a slow cone with c < 0", _set(last, "cone", to=lambda old: [old[0], "-1/1000"])
        yield "three numbers of a cone", _set(last, "cone", to=lambda old: [old[0]] * 3)
    else:
        yield "a cone in place of the end of the time", _set(last, "cone", to=lambda _: ["1/10"])
    yield "a line too many", lambda lines: lines.append(lines[-1])
    yield "the last line left out", lambda lines: lines.pop()
    yield "the bits left out", lambda lines: lines.pop(1)
    yield "the phases alone", lambda lines: lines.__setitem__(slice(None), [x for x in lines if "x" not in x])


def _of_steps(lines: Lines) -> Iterator[tuple[str, Change]]:
    at = [i for i, line in enumerate(lines) if "x" in line]
    for i in sorted({at[0], at[len(at) // 2], at[-1]}):
        step = lines[i]
        for name, c in step["x"].items():
            if len(c) < 2 or not any(c):
                continue
            for k in sorted({0, 1, len(c) // 4}):
                moved = _set(i, "x", name, k, to=lambda v, u=step["unit"]: v + (1 << (u - 80)))
                yield f"coefficient {k} of {name} at {i} moved", moved
        m, e = step["h"]
        for bits in (60, -60):
            h = Fraction(m) * Fraction(2) ** e + Fraction(2) ** -abs(bits) * (1 if bits > 0 else -1)
            dyadic = [h.numerator, 1 - h.denominator.bit_length()]
            yield f"h at {i} changed by {bits} bits", _set(i, "h", to=lambda _, dyadic=dyadic: dyadic)
        wrong_lengths = {
            "negative": [-m, e], "of 0": [0, 0], "true": [True, 0], "alone": [m], "an integer": m, "vast": [m, 10**9],
            "tiny": [m, -(10**9)], "with a float": [m, float(e)], "a text": "1",
        }  # fmt: skip
        for how, wrong in wrong_lengths.items():
            yield f"h at {i} {how}", _set(i, "h", to=lambda _, wrong=wrong: wrong)
        yield f"unit at {i} finer", _set(i, "unit", to=lambda u: u + 1)
        yield f"unit at {i} of 0", _set(i, "unit", to=lambda _: 0)
        yield f"the step at {i} twice", lambda lines, i=i: lines.insert(i, lines[i])
        piece = (i, "pieces", 0)
        yield f"first nodes at {i} lower", _set(*piece, "nodes", 0, to=lambda w: [[m, e - 8] for m, e in w])
        yield f"last nodes at {i} lower", _set(*piece, "nodes", -1, to=lambda w: [[m, e - 8] for m, e in w])
        yield f"all nodes at {i} lower", _set(*piece, "nodes", to=lambda n: [[[m, e - 8] for m, e in w] for w in n])
        yield f"all nodes at {i} huge", _set(*piece, "nodes", to=lambda n: [[[1, 40]] * len(w) for w in n])
        yield f"a node at {i} of 0", _set(*piece, "nodes", 0, 0, to=lambda _: [0, 0])
        yield f"a node at {i} below 0", _set(*piece, "nodes", -1, 0, to=lambda w: [-w[0], w[1]])
        yield f"one node at {i}", _set(*piece, "nodes", to=lambda n: n[:1])
        yield f"blocks at {i} of 0", _set(*piece, "blocks", to=lambda b: [0, *b])
        yield f"other blocks at {i}", _set(*piece, "blocks", to=lambda b: [sum(b) + 1])
        yield f"a singular basis at {i}", _set(*piece, "basis", to=lambda b: [[0, 0]] * len(b))
        yield f"a shorter basis at {i}", _set(*piece, "basis", to=lambda b: b[:-1])
        yield f"pieces at {i} end early", _set(i, "pieces", -1, "end", to=lambda _: [15, -4])
        yield f"pieces at {i} end late", _set(i, "pieces", -1, "end", to=lambda _: [3, -1])
        yield f"no pieces at {i}", _set(i, "pieces", to=lambda _: [])
        yield f"a state at {i} left out", lambda lines, i=i: lines[i]["x"].pop(min(lines[i]["x"]))
    first = at[0]
    yield (
        "two steps exchanged",
        lambda lines: lines.__setitem__(slice(first, first + 2), lines[first : first + 2][::-1]),
    )
    yield "a step left out", lambda lines: (lines.pop(first + 1), lines[2].update(steps=lines[2]["steps"] - 1))


def _of_types(lines: Lines) -> Iterator[tuple[str, Change]]:
    first = next(i for i, line in enumerate(lines) if "x" in line)
    state = min(lines[first]["x"])
    for wrong in (0.5, None, True, "1", [], 10**500):
        yield f"a coefficient {wrong!r:.9}", _set(first, "x", state, 0, to=lambda _, wrong=wrong: wrong)
        yield f"a node {wrong!r:.9}", _set(first, "pieces", 0, "nodes", 0, 0, to=lambda _, wrong=wrong: wrong)
        yield f"an entry {wrong!r:.9}", _set(first, "pieces", 0, "basis", 0, to=lambda _, wrong=wrong: wrong)
    for key in ("x", "pieces", "h", "unit"):
        yield f"{key} is null", _set(first, key, to=lambda _: None)
    yield "401 coefficients", _set(first, "x", state, to=lambda c: c + [0] * (401 - len(c)))


def _of_mechanism(lines: Lines) -> Iterator[tuple[str, Change]]:
    at = (0, "statement", "mechanism")
    given = lines[0]["statement"]["mechanism"]
    n = len(given["coordinates"])
    for q, (sine, cosine) in given["angles"].items():
        yield f"sine of {q}_ref + 1e-20", _set(*at, "angles", q, 0, to=_plus(Fraction(1, 10**20)))
        yield f"{q}_ref turned", _set(*at, "angles", q, to=lambda _, new=[cosine, sine]: new)
        yield f"{q}_ref of a long pair", _set(*at, "angles", q, to=lambda _: ["1", "1"])
        yield f"{q}_ref without a cosine", _set(*at, "angles", q, to=lambda pair: pair[:1])
        yield f"{q} without a reference", _set(*at, "angles", to=lambda _: {})
    for i in range(n):
        force = (*at, "forces", i)
        yield f"force {i} + 1e-20", _set(*force, to=lambda text: f"{text} + 1/{10**20}")
        yield f"force {i} with a power", _set(*force, to=lambda text: f"{text} + 1*sin(x)**2")
        yield f"force {i} with a bracket", _set(*force, to=lambda text: f"2*({text})")
        yield f"force {i} empty", _set(*force, to=lambda _: "")
        yield f"force {i} null", _set(*force, to=lambda _: None)
        yield f"force {i} with an unknown name", _set(*force, to=lambda text: f"{text} + 0*w")
        yield f"force {i} with the clock", _set(*force, to=lambda text: f"{text} + 1*T")
        yield f"force {i} with a scaled state", _set(*force, to=lambda text: f"{text} + 1*y/eps^2")
        yield f"force {i} too long", _set(*force, to=lambda text: f"{text} + 0" * 300)
        yield f"mass {i} + 1e-20", _set(*at, "mass_matrix", i, i, to=lambda text: f"{text} + 1/{10**20}")
        yield f"mass {i} < 0", _set(*at, "mass_matrix", i, i, to=lambda _: "-1")
        yield f"mass {i} of 0", _set(*at, "mass_matrix", i, i, to=lambda _: "0")
        yield f"row {i} of 0", _set(*at, "mass_matrix", i, to=lambda row: ["0"] * len(row))
        yield f"row {i} shorter", _set(*at, "mass_matrix", i, to=lambda row: row[:-1])
        speed = f"1*{given['coordinates'][i]}_dot"
        yield f"mass {i} with a velocity", _set(*at, "mass_matrix", i, i, to=lambda text, v=speed: f"{text} + {v}")
    yield "a matrix that is not symmetric", _set(*at, "mass_matrix", 0, n - 1, to=lambda text: f"{text} + 1/{10**20}")
    yield "mu + 1e-20", _set(*at, "mu", to=_plus(Fraction(1, 10**20)))
    yield "mu < 0", _set(*at, "mu", to=lambda text: f"-{text}")
    yield "mu as a formula", _set(*at, "mu", to=lambda text: f"{text}*1")
    for name in ("x", "y"):
        other = given["y" if name == "x" else "x"]
        yield f"{name} doubled", _set(*at, name, to=lambda text: f"{text} + {text}")
        yield f"{name} that of the other", _set(*at, name, to=lambda _, other=other: other)
        yield f"{name} constant", _set(*at, name, to=lambda _: "1")
        yield f"{name} with a velocity", _set(*at, name, to=lambda text: f"{text} + {speed}")
    yield "coordinates exchanged", _set(*at, "coordinates", to=lambda q: q[::-1])
    for wrong in ("T", "y", "q_dot", "q_ref", "sin(q)", "", 1, "q" * 41, "q-q"):
        yield f"a coordinate {wrong!r:.8}", _set(*at, "coordinates", 0, to=lambda _, wrong=wrong: wrong)
    yield "a coordinate twice", _set(*at, "coordinates", to=lambda q: [q[0]] * len(q))
    yield "no coordinates", _set(*at, "coordinates", to=lambda _: [])
    yield "no mechanism", _set(*at, to=lambda _: None)
    yield "a run of the model", _set(0, "statement", "kind", to=lambda _: "run")
    yield "another mechanism", _set(*at, to=lambda _, n=n: _another(n))
    yield "a number more at the start", _set(0, "statement", "start", to=lambda old: old | {"w": "0"})
    angle = next(name for name in lines[0]["statement"]["start"] if name.startswith("("))
    yield "an angle far from its reference", _set(0, "statement", "start", angle, to=lambda _: "9")
    first = next(i for i, line in enumerate(lines) if "x" in line)
    for name, c in lines[first]["x"].items():
        if name.startswith(("sin", "cos", "1/")):
            unit = lines[first]["unit"]
            yield f"{name} off its value", _set(first, "x", name, 0, to=lambda v, unit=unit: v + (1 << (unit - 60)))
            yield f"{name} at rest", _set(first, "x", name, to=lambda c: c[:1])
            yield f"{name} turned", _set(first, "x", name, to=lambda c: [-v for v in c])


def _another(n: int) -> Any:
    """The mechanism of the other certificate."""
    return (oscillator() if n == 3 else rod())[0]["statement"]["mechanism"]
