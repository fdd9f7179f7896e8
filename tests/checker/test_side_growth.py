"""The hypotheses of Theorem U2 in the checker of lift-off and impact: each one holds up to its edge and no farther.

Page: proofs/from_state.md, section 11, transcribed a second time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from checker.test_side_sharp import ONE, Page, check, made, numbers, real, side


@pytest.fixture(autouse=True)
def _digits() -> Iterator[None]:
    with mpmath.workdps(60):
        yield


Values = dict[str, Any]
GROWTH: Values = {
    "rho": "9/10", "c": "13/10", "B": "21/5", "C": "18/5", "y_0": "9/10", "y_1": "19/20", "v_0": "3/2", "v_1": "31/20",
    "N_0": "7/2", "N_1": "4", "fast": "9/200", "s": "3", "top": "9", "by": "9", "reaches": "0", "b": "-3",
    "k_1": "3", "k_2": "2", "damper": "1/2",
}  # fmt: skip
LOW: Values = {"y_0": "2/5", "y_1": "21/50", "v_1": "8/5", "top": "3", "fast": "1/50"}
HYPOTHESES: list[tuple[str, str, str, Values, str]] = [
    # What it is, what is moved beyond its edge, how far, what else is changed, and what is said there.
    ("V > ρY", "rho", "8/5", {"c": "2"}, "V does not lie in the cone"),
    ("V < BY", "v_1", "9/5", LOW, "V does not lie in the cone"),
    ("N > cV", "N_0", "2", {}, "N does not lie in the cone"),
    ("N < CV", "N_1", "6", {}, "N does not lie in the cone"),
    ("Y_1 < Y_max", "top", "6", {"b": "-30"}, "end before it begins"),
    ("G1", "c", "1", {}, r"\(G1\)"),
    ("G1", "c", "1", {"fast": "0"}, r"\(G1\)"),
    ("G2", "c", "9/4", {}, r"\(G2\)"),
    ("G3", "B", "37/10", {}, r"\(G3\)"),
    ("G4", "C", "3", {}, r"\(G4\)"),
    ("G7", "rho", "2/5", {"b": "-90", "top": "20", "c": "3/4", "rho": "1/2"}, r"\(G7\)"),
    ("φ falls", "damper", "20000", {"k_1": "1000", "k_2": "6/5", "damper": "10000"}, r"\(G7\)"),
    ("force", "top", "11/20", {}, "not followed to the force"),
    ("force", "top", "1", {"reaches": "3"}, "not followed to the force"),
    ("by", "by", "1/10", {}, "later than is stated"),
]


def grown(values: Values) -> tuple[Any, Any, Any, list[Fraction]]:
    """The statement, a range, a piece and a cone of these numbers; the deviation is as for a force that falls."""
    cone = [Fraction(values[name]) for name in ("rho", "c", "B", "C")]
    contact = tuple(str(values[name]) for name in ("k_1", "k_2", "damper"))
    of = made(b=values["b"], contact=contact, end=Fraction(values["s"]), top=Fraction(values["top"]))
    kappa_q = of.start.kappa * of.start.a * of.end
    y, v, N = ([Fraction(values[f"{name}_{k}"]) for k in (0, 1)] for name in ("y", "v", "N"))
    b = [one - kappa_q * two for one, two in zip(N, y, strict=True)]
    end = [tuple(value * ONE for value in pair) for pair in (b, y, v)]
    assert all(low <= high for low, high in end)
    statement = SimpleNamespace(by=Fraction(values["by"]), reaches=Fraction(values["reaches"]))
    return statement, of, side.Piece((0, 0), end, Fraction(values["fast"]) * ONE, None), cone


def margins(
    values: Values, to: Callable[[Any], Any] = real, logarithm: Callable[[Any], Any] = mpmath.log
) -> dict[str, Any]:
    """By how much each hypothesis of section 11 holds; in numbers that ``to`` makes."""
    statement, of, _, cone = grown(values)
    page, (rho, c, B, C) = Page(of, of.most, to), map(to, cone)
    y_0, y_1, v_0, v_1, N_0, N_1 = (to(Fraction(values[name])) for name in ("y_0", "y_1", "v_0", "v_1", "N_0", "N_1"))
    first, top = y_0 * to(of.amplitude(numbers())[0]), to(of.top)
    last = to(of.end) + (logarithm(top / first) if top > first else to(0)) / rho
    phi = max(to(Fraction(values["fast"])) / v_0, page.delta * page.l / page.g)
    q_1, most, nu = page.a * to(of.end), page.a * last, page.a * page.beta * phi
    pi, k = most * phi, page.a * (page.beta - 1)
    force = to(statement.reaches) - page.mean if statement.reaches else page.mean
    return {
        "V > ρY": v_0 - rho * y_1,
        "V < BY": B * y_0 - v_1,
        "N > cV": N_0 - c * v_1,
        "N < CV": C * v_0 - N_1,
        "Y_1 < Y_max": top - first,
        "G1": c - rho - pi,
        "G2": page.kappa * q_1 - page.kappa * k / rho - nu - c * (c + q_1 * phi),
        "G3": B - C - pi,
        "G4": C * (C - pi) - page.kappa * most - nu,
        "G7": rho * last - 2 * (page.beta - 1),
        "φ falls": (page.g - page.l / page.g * page.delta**2 * page.a * page.S) * (to(of.end) + page.S) - page.delta,
        "force": (page.kappa - phi * B) * top - force,
        "by": to(statement.by) - page.delta**2 * last,
    }


def edge(name: str, moved: str, values: Values, far: Fraction) -> tuple[Fraction, Fraction]:
    """Two numbers that differ by little; at the first one the hypothesis holds, at the second it does not."""
    good, bad = Fraction(values[moved]), far
    for _ in range(80):
        middle = (good + bad) / 2
        holds = margins(values | {moved: middle})[name] > 0
        good, bad = (middle, bad) if holds else (good, middle)
    room = (far - Fraction(values[moved])) / 10**9
    return good - room, bad + room


@pytest.mark.parametrize(("name", "moved", "far", "others", "reason"), HYPOTHESES)
def test_a_hypothesis_of_the_growth_holds_up_to_its_edge_and_no_farther(
    name: str, moved: str, far: str, others: Values, reason: str
) -> None:
    values = GROWTH | others
    good, bad = edge(name, moved, values, Fraction(far))
    held = margins(values | {moved: good})
    assert min(held.values()) == held[name] > 0
    statement, of, piece, cone = grown(values | {moved: good})
    assert side.growing(numbers(), statement, of, piece, cone) == -1
    other = piece._replace(end=[(-high, -low) for low, high in piece.end])  # and a deviation of the other sign
    assert side.growing(numbers(), statement, of, other, cone) == 1
    statement, of, piece, cone = grown(values | {moved: bad})
    with pytest.raises(check.limits.Rejected, match=reason):
        side.growing(numbers(), statement, of, piece, cone)


@pytest.mark.parametrize("low", [-1, 0])
def test_a_deviation_without_a_certain_sign_does_not_grow(low: int) -> None:
    statement, of, piece, cone = grown(GROWTH)
    piece.end[side.Y] = low, 2 * ONE
    for end in (piece.end[side.Y], (-2 * ONE, -low)):
        piece.end[side.Y] = end
        with pytest.raises(check.limits.Rejected, match="the sign of the deviation is not certain"):
            side.growing(numbers(), statement, of, piece, cone)


EXACT: list[tuple[str, str, Values]] = [
    # What it is, in which number it is affine, what else is changed.
    ("V > ρY", "rho", {"c": "2"}),
    ("V < BY", "v_1", LOW),
    ("N > cV", "N_0", {}),
    ("N < CV", "N_1", {}),
    ("Y_1 < Y_max", "top", {"reaches": "7/10"}),
    ("G1", "c", {}),
    ("G2", "fast", {"c": "19/10"}),
    ("G3", "B", {}),
    ("G4", "fast", {"C": "16/5"}),
    ("G7", "rho", {"c": "3/4"}),
    ("force", "top", {}),
]


@pytest.mark.parametrize(("name", "moved", "others"), EXACT)
def test_equality_is_not_enough(monkeypatch: pytest.MonkeyPatch, name: str, moved: str, others: Values) -> None:
    """With a logarithm and an amplitude that are rational numbers each hypothesis can be met exactly."""
    amount = Fraction(1, 10) if name == "G7" else Fraction(2)
    monkeypatch.setattr(side, "log_above", lambda _: amount)
    monkeypatch.setattr(side.Range, "amplitude", lambda *_: (Fraction(1, 2), Fraction(1)))

    def exact(number: Fraction) -> dict[str, Fraction]:
        return margins(GROWTH | others | {moved: number}, Fraction, lambda _: amount)

    near = Fraction((GROWTH | others)[moved])
    far = near * Fraction(101, 100)
    at_near, at_far = exact(near)[name], exact(far)[name]
    edge_of_it = near - at_near * (far - near) / (at_far - at_near)
    met = exact(edge_of_it)
    assert met.pop(name) == 0 < min(met.values())
    statement, of, piece, cone = grown(GROWTH | others | {moved: edge_of_it})
    with pytest.raises(check.limits.Rejected):
        side.growing(numbers(), statement, of, piece, cone)


def test_the_time_that_is_stated_may_be_the_latest_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(side, "log_above", lambda _: Fraction(2))
    statement, of, piece, cone = grown(GROWTH)
    statement.by = of.most**2 * (of.end + Fraction(2) / cone[0])
    assert side.growing(numbers(), statement, of, piece, cone) == -1
    statement.by -= Fraction(1, 10**40)
    with pytest.raises(check.limits.Rejected, match="later than is stated"):
        side.growing(numbers(), statement, of, piece, cone)
