"""A fixed slice of the questions; that each kind notices a package that lies; what the references may import."""

from __future__ import annotations

import ast
import json
import sys
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest
from attack import (
    approaches,
    canards,
    certificates,
    crossings,
    expansions,
    fates,
    floats,
    friction,
    iwc,
    journals,
    kept,
    maps,
    mechanism_expansions,
    mechanisms,
    merged,
    motion,
    scenes,
    sealed,
    side,
    signs,
    sweeps,
    theta,
    uniform,
    zero_maps,
)
from attack.answers import AGREED, Answer, Attack, Tally, undecided, worst, wrong
from attack.runner import KINDS, answered, draw_of
from attack.statements import untrue
from flint import arb, fmpq

from gspot_verified.compliant.contact.iwc import CompliantIwc
from gspot_verified.integrator.field.event import Crossing, Watch
from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Verdict
from gspot_verified.paper.cache import Cache
from gspot_verified.paper.checks.entry import Entry
from gspot_verified.work.journal_file import JournalFile

FOLDER = Path(__file__).parent
SLICE = {
    "theta": range(8),
    "floats": range(8),
    "signs": range(3),
    "motion": range(4),
    "starts": (1, 2, 8, 9),
    "scenes": range(1, 5),
    "turning": range(2, 6),
    "crossings": range(2),
    "mechanisms": range(2),
    "sweeps": (1, 4),
    "maps": (1, 2, 4, 6, 8),
    "approaches": (1, 2, 3),
    "fates": (2, 3, 5, 7, 9, 18),
    "canards": range(4),
    "friction": range(4),
    "side": range(2),
    "zero_maps": (4, 7, 11),
    "iwc": range(3),
    "expansions": range(4),
    "mechanism_expansions": (2, 3, 5),
    "uniform": (2, 3, 5, 6),
    "certificates": (*range(11), 12),
    "sealed": range(12),
    "journals": (*range(3), 5),
    "merged": (0, 2, 4, 5, 7),
    "reports": range(10),
    "costs": range(8),
    "kept": range(8),
}


@pytest.mark.parametrize(("kind", "number"), [(kind, number) for kind, numbers in SLICE.items() for number in numbers])
def test_the_package_agrees_with_the_references(kind: str, number: int) -> None:
    question, answer = answered(draw_of(kind), kind, "slice", number)
    assert answer.tally is not Tally.WRONG, f"{question}\n{answer.detail}"


def test_slip_that_turns_in_flight_is_no_matter() -> None:
    """The run begins in flight, so nothing is assumed of u, which falls; without `stick` the answer is right."""
    question, answer = answered(draw_of("motion"), "motion", "26110", 21)
    assert answer.tally is Tally.AGREED, f"{question}\n{answer.detail}"


def test_every_kind_has_its_part_in_the_slice() -> None:
    assert tuple(SLICE) == KINDS


# The references.


def imported(path: Path) -> set[str]:
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found


REFERENCES = sorted(FOLDER.glob("reference_*.py"))
ALLOWED = {"mpmath", "sympy", "scipy"} | set(sys.stdlib_module_names) - {"importlib"}


def forbidden(names: set[str]) -> set[str]:
    return {
        name for name in names if name.split(".")[0] not in ALLOWED and not name.startswith("attack.reference_")
    }  # fmt: skip


@pytest.mark.parametrize("path", REFERENCES, ids=lambda path: path.stem)
def test_references_import_nothing_of_the_package(path: Path) -> None:
    assert forbidden(imported(path)) == set()
    assert "__import__" not in path.read_text(encoding="utf-8")


def test_the_rule_on_imports_itself() -> None:
    assert len(REFERENCES) >= 4
    names = {
        "gspot_verified.theta",
        "flint.arb",
        "witness",
        "attack.signs.slope",
        "importlib",
        "attack.reference_theta.mp",
    }
    assert forbidden(names) == names - {"attack.reference_theta.mp"}


# Each kind notices a package that lies.


def first_wrong(kind: str, numbers: Iterable[int]) -> int | None:
    """The first of the questions whose answer is wrong."""
    draw = draw_of(kind)
    for number in numbers:
        answer = answered(draw, kind, "teeth", number)[1]
        # An error is no judgement; of Theorem 1 the package itself sees that the lie contradicts what else it says.
        judged = not answer.detail.startswith("raised") or kind in ("expansions", "mechanism_expansions")
        if answer.tally is Tally.WRONG and judged:
            return number
    return None


def shifted(ball: arb) -> arb:
    return ball + 3 * ball.rad() + abs(ball) * arb(2) ** -40 + arb(2) ** -2000


def lying(module: Any, name: str, change: Callable[[Any], Any]) -> Callable[[pytest.MonkeyPatch], None]:
    """What a function of the package returns, changed."""
    true = getattr(module, name)
    return lambda patch: patch.setattr(module, name, lambda *a, **k: change(true(*a, **k)))


def without_its_last(found: Any) -> Any:
    return replace(proved(found), events=found.events[:-1])


def proved(found: Any) -> Any:
    return replace(found, verdict=Verdict.proved(found.verdict.statement, less(0, 1)))


def in_another_case(found: Any) -> Any:
    pieces = [replace(piece, case=piece.case and ("I" if piece.case == "III" else "III")) for piece in found.pieces]
    return replace(found, pieces=tuple(pieces))


def with_a_hole(found: Any) -> Any:
    return replace(found, pieces=found.pieces[1:])


def turned(found: Any) -> Any:
    """What may vanish falls where it grows."""
    crossings = [p.passing and replace(p.passing, direction=-p.passing.direction) for p in found.pieces]
    return replace(found, pieces=tuple(replace(p, passing=q) for p, q in zip(found.pieces, crossings, strict=True)))


def believing_tubes(patch: pytest.MonkeyPatch) -> None:
    """What comes from the forged file has other Cases."""
    true = journals.sweep
    patch.setattr(
        journals,
        "sweep",
        lambda *a, journal, **k: (in_another_case if journal.name == "forged" else lambda found: found)(
            true(*a, journal=journal, **k)
        ),
    )


def believing_first_lines(patch: pytest.MonkeyPatch) -> None:
    """A journal of whatever question is one of this."""
    begin = JournalFile._begin

    def began(self: JournalFile, asked: dict[str, Any]) -> None:
        first = self.path.read_bytes().split(b"\n")[0]
        begin(self, json.loads(first) if first else asked)

    patch.setattr(JournalFile, "_begin", began)


def another_end(found: Any) -> Any:
    return replace(found, end=found.end and ("slip stops" if found.end == "lift-off" else "lift-off"))


def with_other_fates(found: Any) -> Any:
    """Each end of slip is another one, each sign of C_1 the other."""
    pairs = ((Fate.LIFT_OFF, Fate.STOPS), (Fate.BELOW, Fate.ABOVE), (Fate.OPENS, Fate.PAINLEVE))
    other = {one: two for pair in pairs for one, two in (pair, pair[::-1])}
    return replace(found, pieces=tuple(replace(p, fate=other.get(p.fate, p.fate)) for p in found.pieces))


def without_constants(found: Any) -> Any:
    nothing = [replace(one, constants=dict.fromkeys(one.constants, arb(0))) for one in found.stretches]
    return replace(found, stretches=tuple(nothing))


def later(found: Any) -> Any:
    return found and replace(found, lower=found.upper, upper=found.upper + (found.upper - found.lower))


class NarrowWatch(Watch):
    """Hands on the middle of the box alone."""

    def along(self, segment: Any) -> Any:
        found = super().along(segment)
        return replace(found, states=tuple(s.mid() for s in found.states)) if isinstance(found, Crossing) else found


class CredulousCache(Cache):
    """Recalls whatever lies in its folder."""

    def recall(self, identifier: str) -> Entry | None:  # noqa: ARG002
        return kept._true_entry(Random(0))


def believing(data: bytes, limits: Any) -> str:  # noqa: ARG001
    return "whatever is stated"


def moved(result: CompliantIwc) -> CompliantIwc:
    """The largest epsilon too large, the lift-off too late."""
    leading, late = result.leading, fmpq(1, 10)
    if leading.epsilon_0 is not None:
        leading = replace(leading, epsilon_0=leading.epsilon_0 * (1 + late))
    if (time := leading.lift_off) is not None and time.lower is not None and time.upper is not None:
        leading = replace(leading, lift_off=replace(time, lower=time.lower + late, upper=time.upper + late))
    return replace(result, leading=leading)


LIES: dict[str, tuple[Callable[[pytest.MonkeyPatch], None], Iterable[int]]] = {
    "theta": (lying(theta, "evaluate", lambda e: replace(e, value=shifted(e.value), reached=False)), range(6)),
    "floats": (lying(floats, "beta_derivative", shifted), range(6)),
    "signs": (lying(signs, "number_of_zeros", lambda n: n + 1), range(6)),
    "motion": (lying(motion, "certified_run", without_its_last), range(8)),
    "scenes": (lying(scenes, "certified_run", without_its_last), range(8)),
    "turning": (lying(scenes, "certified_run", without_its_last), (4, 9)),
    "uniform": (lying(uniform, "uniform_bound", without_constants), range(8)),
    "zero_maps": (lying(zero_maps, "fold_point", later), (1, 6)),
    "costs": (lambda patch: patch.setattr("gspot_verified.report.parts.cost_page.escape", str), range(40)),
    "sweeps": (lying(sweeps, "sweep", in_another_case), range(8)),
    "approaches": (lying(approaches, "approach", another_end), range(8)),
    "fates": (lying(fates, "fates", with_other_fates), (9, 3)),
    "canards": (lying(canards, "fates", with_other_fates), range(8)),
    "friction": (
        lying(friction, "critical_friction", lambda f: replace(f, value=f.value and f.value * 1.001)), range(6),
    ),
    "starts": (lying(motion, "certified_run", without_its_last), range(8)),
    "maps": (lying(maps, "sweep", in_another_case), range(10)),
    "merged": (believing_first_lines, range(12)),
    "reports": (lambda patch: patch.setattr("gspot_verified.report.data._check_evidence", lambda *_: None), range(8)),
    "crossings": (lambda patch: patch.setattr(crossings, "Watch", NarrowWatch), range(4)),
    "mechanisms": (lying(mechanisms, "classify_all", lambda f: replace(f, spots=f.spots[:-1])), range(8)),
    "side": (lying(side, "side_rule", lambda r: replace(r, side=-r.side)), range(3)),
    "iwc": (lying(iwc, "iwc", moved), range(6)),
    "expansions": (lying(expansions, "expand_system", lambda t: replace(t, b=(*t.b[:2], *t.p[2:]))), range(3)),
    "mechanism_expansions": (
        lying(mechanism_expansions, "expand_system", lambda t: replace(t, lambda_n=(*t.lambda_n[:1], *t.p[1:]))),
        range(8),
    ),
    "certificates": (
        lambda patch: patch.setattr(certificates, "checker", lambda: SimpleNamespace(
            main=SimpleNamespace(check_text=believing),
            limits=SimpleNamespace(Limits=lambda: None, Rejected=ValueError))), range(8),
    ),
    "sealed": (
        lambda patch: patch.setattr(sealed, "checker", lambda: SimpleNamespace(
            main=SimpleNamespace(check_text=believing),
            limits=SimpleNamespace(Limits=lambda: None, Rejected=ValueError))), range(12),
    ),
    "journals": (lying(journals, "sign_on_ranges", proved), (9,)),
    "kept": (lambda patch: patch.setattr(kept, "Cache", CredulousCache), range(6)),
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_a_lie_is_noticed(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    lie, numbers = LIES[kind]
    lie(monkeypatch)
    assert first_wrong(kind, numbers) is not None


MORE_LIES: list[tuple[str, Callable[[pytest.MonkeyPatch], None], Iterable[int]]] = [
    ("maps", lying(maps, "sweep", with_a_hole), range(4)),
    ("maps", lying(maps, "sweep", turned), range(3, 5)),
    ("fates", lying(fates, "fates", with_a_hole), (9,)),
    ("journals", believing_tubes, (1,)),
    ("merged", lying(merged, "sign_on_ranges", proved), (14,)),
    ("reports", lambda patch: patch.setattr("gspot_verified.report.site.typeset", lambda text: text), range(4)),
    ("reports", lambda patch: patch.setattr("gspot_verified.report.data._file_name", lambda *_: None), range(2)),
]


@pytest.mark.parametrize(("kind", "lie", "numbers"), MORE_LIES)
def test_other_lies_are_noticed(
    kind: str, lie: Callable[[pytest.MonkeyPatch], None], numbers: Iterable[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    lie(monkeypatch)
    assert first_wrong(kind, numbers) is not None


@pytest.mark.parametrize(
    ("beta", "sign", "said"),
    [
        ("(-inf, -1/1000]", 1, ""),
        ("(-inf, -1/1000]", -1, "the sign"),
        ("[-20, inf)", 1, "the sign"),
        ("(-inf, -9]", 1, ""),
    ],
)
def test_a_statement_is_asked_within_its_range_alone(beta: str, sign: int, said: str) -> None:
    """The slope is positive for every beta < 0; a sample beyond the end of a range was held against it once."""
    found = untrue({"kind": "sign", "beta": beta, "tau": "(-inf, inf)", "sign": sign})
    assert found is not None
    assert found.startswith(said)
    assert bool(found) == bool(said)


# Answers.


def test_wrong_comes_before_undecided_before_agreed() -> None:
    assert worst([AGREED, undecided("why"), wrong("so")]).tally is Tally.WRONG
    assert worst([AGREED, undecided("why")]) == undecided("why")
    assert worst([AGREED]) == AGREED
    assert worst([]).tally is Tally.UNDECIDED


def test_an_error_that_nobody_expects_is_wrong() -> None:
    def ask() -> Answer:
        raise ZeroDivisionError("by nobody")

    question, answer = answered(lambda _: Attack("1/0", ask), "any", "0", 0)
    assert question == "1/0"
    assert answer.tally is Tally.WRONG
    assert "by nobody" in answer.detail
