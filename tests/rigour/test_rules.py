"""Each rule: what it must flag and what it must let pass; the faults that made it are flagged."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from pathlib import Path

import pytest
from rigour.exceptions import LIST, complaints, exceptions
from rigour.rules import (
    ASSERT,
    EVIDENCE,
    EXCEPT,
    FLOATS,
    HULL,
    NEGATION,
    ORDER,
    RULES,
    SAYS,
    WRITTEN,
    ZERO,
    Finding,
    findings,
)
from rigour.types_of_expressions import Kinds, kinds_in_files

HEAD = """
from collections.abc import Sequence
from functools import reduce
from flint import arb, fmpq
from typing import Any

approximate: Any; ball_text: Any; hull: Any; inner_text: Any
nonfinite: Any; sign_of: Any; Outcome: Any; Reason: Any; Verdict: Any

class Hit:
    time: arb
    number: int

def f(x: arb, y: arb, q: fmpq, parts: Sequence[arb], hits: list[Hit], either: fmpq | arb, unknown) -> object:
"""

FLAGGED = {
    "the order of events": (ORDER, "return min(hits, key=lambda hit: float(hit.time.mid()))"),
    "a float of an event": (FLOATS, "return min(hits, key=lambda hit: float(hit.time.mid()))"),
    "the least bound": (ORDER, "return min(parts, key=lambda value: float(value))"),
    "float as a function": (ORDER, "return sorted(parts, key=float)"),
    "a midpoint": (FLOATS, "return x.mid()"),
    "a midpoint as a function": (FLOATS, "return list(map(arb.mid, parts))"),
    "approximate": (FLOATS, "return approximate(x) < 0"),
    "least of balls": (ORDER, "return min(x, y)"),
    "largest of a list of balls": (ORDER, "return max(parts)"),
    "sorted balls": (ORDER, "return sorted(parts)"),
    "a list sorted in place": (ORDER, "hits.sort(key=lambda hit: hit.time)"),
    "a key that is not known": (ORDER, "return min(hits, key=unknown)"),
    "the least of balls and numbers": (ORDER, "return min(q, either)"),
    "a negation": (NEGATION, "return not x < 0"),
    "a negation with brackets": (NEGATION, "return not (x < y)"),
    "a negation of a conjunction": (NEGATION, "return not (q > 0 and x > 0)"),
    "a negation of all": (NEGATION, "return not all(part > 0 for part in parts)"),
    "a negation of bool": (NEGATION, "return not bool(x < 0)"),
    "a negation of what may be a ball": (NEGATION, "return not either < 0"),
    "a negation of what is not known": (NEGATION, "return not unknown < 0"),
    "a negation of an equality": (NEGATION, "return not x == y"),
    "a negation that decides": (NEGATION, "if not x < 0:\n        return True"),
    "a negation that proves": (NEGATION, "if not x < 0:\n        return Verdict.proved('x >= 0')"),
    "a refusal that needs another comparison": (NEGATION, "if y > 1 and not x < 0:\n        raise ValueError"),
    "zero or not": (ZERO, "return 1 if x.is_zero() else 2"),
    "a union": (HULL, "return x.union(y)"),
    "a union by pairs": (HULL, "return [a.union(b) for a, b in zip(parts, parts)]"),
    "a hull of first and last": (HULL, "return hull([parts[0], parts[-1]])"),
    "bare": (EXCEPT, "try:\n        return 1 / q\n    except:\n        return None"),
    "any error": (EXCEPT, "try:\n        return 1 / q\n    except Exception:\n        return 0"),
    "one of several": (
        EXCEPT,
        "try:\n        return 1 / q\n    except (ZeroDivisionError, ValueError):\n        return 0",
    ),
    "a hypothesis": (ASSERT, "assert x < 0"),
    "a hypothesis about a number": (ASSERT, "assert q > 0"),
    "who says proved": (SAYS, "return Verdict.proved('it holds', unknown)"),
    "who hands the constructor on": (SAYS, "return Verdict.refuted"),
    "evidence made by hand": (EVIDENCE, "return Verdict.proved('it holds', unknown._of_facts(('it holds',)))"),
    "who builds a verdict": (SAYS, "return Verdict(Outcome.PROVED, 'it holds')"),
    "a ball as text": (WRITTEN, "return f'for every beta in {ball_text(x)}'"),
    "the text of balls handed on": (WRITTEN, "return [*map(ball_text, parts)]"),
    "a ball in a text": (WRITTEN, "return f'for every beta in {x}'"),
    "what may be a ball in a text": (WRITTEN, "return f'for every beta in {either}'"),
    "str of a ball": (WRITTEN, "return str(x)"),
    "digits of a ball": (WRITTEN, "return x.str(5)"),
    "a ball beside an error": (WRITTEN, "text = ball_text(x)\n    raise ValueError(text)"),
}

PASSES = {
    "the least number": "return min(q, 2, 3)",
    "numbers by a key": "return sorted(hits, key=lambda hit: hit.number)",
    "the least of balls, enclosed": "return reduce(arb.min, parts), x.max(y)",
    "a negation of numbers": "return not q < 0",
    "a negation of an answer": "return not x.overlaps(y)",
    "an error": "if not x < 0:\n        raise ValueError",
    "an error, of two": "if not (x < 0 and y < 0) or not q < 0:\n        raise ValueError",
    "an error where it is asked for": "if q > 0 and not x < 0:\n        raise ValueError",
    "no answer": "if not x < 0:\n        return None",
    "not finite": "if not x < 0:\n        return nonfinite()",
    "undecided": "if not x < 0:\n        return Verdict.undecided('x < 0', Reason.HYPOTHESIS)",
    "a hull of all": "return hull(parts)",
    "a hull of two ends": "return hull([arb(q), arb(q + 1)])",
    "a union of sets": "return frozenset[int]().union({1}, {2})",
    "a sign": "return sign_of(x)",
    "zero as a number": "return q == 0",
    "its own error": "try:\n        return 1 / q\n    except ZeroDivisionError:\n        return None",
    "raised again": "try:\n        return 1 / q\n    except ValueError as error:\n        raise TypeError from error",
    "what mypy cannot see": "assert unknown is not None\n    assert isinstance(x, arb)",
    "names of types": "values: list[float] = []\n    return isinstance(x, float | int), values",
    "a ball rounded inward": "return f'for every beta in {inner_text(x)}'",
    "a number as text": "return f'for beta = {q}', str(q)",
    "an error about a ball": "raise ValueError(f'{ball_text(x)} holds an integer, as {x}')",
    "undecided about a ball": "return Verdict.undecided(f'beta in {ball_text(x)}', Reason.HYPOTHESIS, str(x))",
    "what others concluded": "return unknown.verdict.outcome is Outcome.PROVED",
}


def source(body: str) -> str:
    return f"{HEAD}    {body}\n"


@pytest.fixture(scope="module")
def kinds(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, Kinds]:
    """One run of mypy for all snippets."""
    folder = tmp_path_factory.mktemp("snippets")
    bodies = [*(body for _, body in FLAGGED.values()), *PASSES.values()]
    files = {f"snippet_{number}": folder / f"snippet_{number}.py" for number in range(len(bodies))}
    for path, body in zip(files.values(), bodies, strict=True):
        path.write_text(source(body), encoding="utf-8")
    found = kinds_in_files(files, strict=False)
    return dict(zip(bodies, found.values(), strict=True))


def broken(body: str, kinds: Mapping[str, Kinds]) -> list[Finding]:
    return list(findings(ast.parse(source(body)), kinds[body]))


@pytest.mark.parametrize("name", FLAGGED)
def test_must_be_flagged(name: str, kinds: Mapping[str, Kinds]) -> None:
    rule, body = FLAGGED[name]
    found = [finding for finding in broken(body, kinds) if finding.rule == rule]
    assert found
    assert {finding.scope for finding in found} == {"f"}


@pytest.mark.parametrize("name", PASSES)
def test_must_pass(name: str, kinds: Mapping[str, Kinds]) -> None:
    assert broken(PASSES[name], kinds) == []


def test_every_rule_is_tried() -> None:
    assert {rule for rule, _ in FLAGGED.values()} == set(RULES)


def test_what_mypy_refuses_is_an_error(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.py"
    wrong.write_text("x: int = 'text'\n", encoding="utf-8")
    with pytest.raises(ValueError, match="Incompatible types"):
        kinds_in_files({"wrong": wrong})


LISTED = """
[heuristics]
"guess.py" = "any choice is correct"
[faces]
"face/" = "it shows what others concluded"
[concludes]
"end.py" = "it compares two balls"
[[exception]]
rule = "floats"
why = "only printed"
at = ["middle.py Shown.text 2", "middle.py -"]
"""


def finding(rule: str, scope: str = "g") -> Finding:
    return Finding(rule, 7, scope, "text")


def found(**more: list[Finding]) -> dict[str, list[Finding]]:
    """What the list above allows exactly, with other findings in the place of those of some files."""
    needed = {
        "guess.py": [finding(FLOATS), finding(ORDER)],
        "face/page.py": [finding(FLOATS), finding(EXCEPT)],
        "end.py": [finding(SAYS)],
        "middle.py": [finding(FLOATS, "Shown.text"), finding(FLOATS, "Shown.text"), finding(FLOATS, "")],
    }
    return needed | {f"{name}.py": findings for name, findings in more.items()}


def test_what_the_list_allows() -> None:
    assert complaints(found(other=[]), exceptions(LISTED)) == []


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"other": [finding(FLOATS)]}, "other.py:7: floats"),
        ({"other": [finding(SAYS)]}, "other.py:7: says"),
        ({"guess": [finding(SAYS)]}, "guess.py:7: says"),
        ({"guess": [finding(HULL)]}, "guess.py:7: hull"),
        ({"end": []}, "it may conclude, and does not"),
        ({"middle": [finding(FLOATS, "Shown.text"), finding(FLOATS, "")]}, "argued for 2 places, there are 1"),
        ({"middle": [*[finding(FLOATS, "Shown.text")] * 3, finding(FLOATS, "")]}, "middle.py:7: floats"),
        ({"middle": [*[finding(FLOATS, "Shown.text")] * 2, finding(ORDER, "")]}, "middle.py:7: order"),
    ],
)
def test_what_it_does_not_allow(more: dict[str, list[Finding]], said: str) -> None:
    wrong = complaints(found(**more), exceptions(LISTED))
    assert wrong
    assert any(said in line for line in wrong)


def test_a_file_that_is_gone() -> None:
    without = {name: findings for name, findings in found().items() if name != "face/page.py"}
    assert complaints(without, exceptions(LISTED)) == ["face/: there is no such file"]


@pytest.mark.parametrize(
    "text",
    [
        '[heuristics]\n"guess.py" = ""',
        '[concludes]\n"end.py" = "why"',
        '[[exception]]\nrule = "unheard"\nwhy = "only printed"\nat = ["a.py f"]',
        '[[exception]]\nrule = "says"\nwhy = "only printed"\nat = ["a.py f"]',
        '[[exception]]\nrule = "floats"\nwhy = ""\nat = ["a.py f"]',
        '[[exception]]\nrule = "floats"\nwhy = "only printed"\nat = ["a.py"]',
        '[[exception]]\nrule = "floats"\nwhy = "only printed"\nat = ["a.py f", "a.py f 2"]',
        '[[exception]]\nrule = "floats"\nwhy = "only printed"\nat = ["a.py f"]\nline = 3',
        '[other]\n"a.py" = "only printed"',
    ],
)
def test_a_list_that_is_not_as_it_should_be(text: str) -> None:
    with pytest.raises(ValueError, match=r".+"):
        exceptions(text)


def test_the_list_of_the_package_can_be_read() -> None:
    listed = exceptions(LIST.read_text(encoding="utf-8"))
    assert listed.places
    assert listed.says
