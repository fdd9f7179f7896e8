"""From a state to its fate with affine alphas (proofs/from_state.md, section 8), beside runs in high precision."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from samples.cones import cone_of

from gspot_verified.expansion.from_state import affine_side as module
from gspot_verified.expansion.from_state.affine_side import AffineSide, affine_side, states_text
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, affine_tube, carried
from gspot_verified.expansion.from_state.choice import LARGEST, LARGEST_DELTA, Plan
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle, fast_growth
from gspot_verified.expansion.from_state.slow_manifold import Cut, SlowManifold, excess_terms, slow_manifold
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.true_solutions.delta_ranges import smallest
from gspot_verified.expansion.true_solutions.side_end import SideEnd
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome
from tests.expansion.from_state.test_affine_system import EXTENDED
from tests.witnesses.stiff_contact import StiffContact, at_rest, fate

P, RATIO = fmpq(1, 100), fmpq(3, 2)
SHOWN = less(0, 1)
assert SHOWN is not None
ALPHAS = [[fmpq(-1), fmpq(0), fmpq(1)], [fmpq(-1), fmpq(0), fmpq(0)], [fmpq(-3, 2), fmpq(0), fmpq(0)]]


@cache
def manifold_of(system: AffineSystem = EXTENDED) -> SlowManifold:
    return slow_manifold(system, Cut(4, fmpq(8), 2 * system.beta - 2))


def place_of(excess: fmpq, p: fmpq = P, system: AffineSystem = EXTENDED) -> fmpq:
    """b at p with this L."""
    return p * (AffineStart(manifold_of(system), p, fmpq(0), fmpq(0)).excess - excess)


def test_a_ball_of_states_is_written_no_wider_than_it_is() -> None:
    """What is said holds for each p of the ball; 0.0113, as rounded outward, is none of them."""
    start = AffineStart(manifold_of(), arb("0.01", "0.0012345"), fmpq(-1, 100), fmpq(1, 100))
    text = states_text(start)
    assert "every start in contact at p in [0.008766, 0.011234], b = -1/100 with" in text
    assert ", L in [" in text
    assert "at p = 1/100, b = -1/100 with" in states_text(replace(start, p=P))


STEEP = AffineSystem(EXTENDED.alpha_1, EXTENDED.alpha_2, Affine(fmpq(-5, 2)), PAPER)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("system", "p", "excess", "side", "least"),
    [
        (EXTENDED, P, fmpq(1, 2), "lift-off", fmpq(1, 2 * 10**6)),
        (EXTENDED, P, fmpq(-1, 2), "impact", fmpq(1, 2 * 10**6)),
        (STEEP, fmpq(1, 20), fmpq(1, 3), "impact", fmpq(1, 10**6)),
        (STEEP, fmpq(1, 20), fmpq(-1, 3), "lift-off", fmpq(1, 10**6)),
    ],
)
def test_the_side_is_that_of_runs_at_several_epsilon(
    system: AffineSystem, p: fmpq, excess: fmpq, side: str, least: fmpq
) -> None:
    found = affine_side(system, p, place_of(excess, p, system))
    assert found.verdict.outcome is Outcome.PROVED
    assert found.start.excess == excess
    assert found.side == side
    assert found.epsilon > least
    alphas = [ALPHAS[0], ALPHAS[1], [system.alpha_3.value, fmpq(0), fmpq(0)]]
    for factor in (1, 30, 1000):
        ended, last = fate(StiffContact(alphas, found.epsilon / factor), at_rest(p, found.start.b), 20)
        assert ended == side
        assert last[0] < 0


@cache
def tube_at(delta: fmpq, excess: fmpq) -> tuple[AffineStart, AffineTube]:
    start = AffineStart(manifold_of(), P, place_of(excess), fmpq(1, 100))
    norm = Norm(start.manifold, fmpq(8, 5), fmpq(12, 25))
    rectangle = Rectangle(fmpq(1, 8), fmpq(1, 10))
    growth = fast_growth(norm, rectangle, fmpq(1, 20), fmpq(1, 10))
    tube = affine_tube(start, norm, growth, rectangle, delta**3, fmpq(1, 10), RATIO)
    assert isinstance(tube, AffineTube), tube
    return start, tube


@cache
def run_to(delta: fmpq, excess: fmpq) -> list[arb]:
    """(p, b, Y, V, Z) at the first step with p < 4.6 epsilon^(2/3)."""
    contact = StiffContact(ALPHAS, delta**3)
    return contact.run(at_rest(P, place_of(excess)), lambda u: bool(u[0] < arb("4.6") * arb(delta) ** 2))


@pytest.mark.parametrize("excess", [fmpq(1, 2), fmpq(-1, 2)])
@pytest.mark.parametrize("delta", [fmpq(1, 150), fmpq(1, 2000)])
def test_a_run_stays_in_the_tube_and_c_1_moves_as_said(delta: fmpq, excess: fmpq) -> None:
    """At p = 4.6 epsilon^(2/3): |x_2| <= c_W z p |L|, likewise x_1, x_3; C lies in its carried ball."""
    with working_bits(128):
        start, tube = tube_at(delta, excess)
        manifold = start.manifold
        p, b, y, v, z = run_to(delta, excess)
        h, r = arb(delta**3) / p ** arb("1.5"), p.sqrt()
        place = h, r, arb(0)
        off = -b / p - value_at(manifold.force, *place)
        place, kappa, lag = (h, r, off), arb("0.5"), arb("0.25")
        phi = z - y + kappa * y + lag * v
        x = (
            r * (v - h * r * value_at(manifold.u, *place)),
            b + p * (z - y) - p * value_at(manifold.w, *place),
            r * (phi - p * value_at(manifold.f, *place)),
        )
        bound = tube.bound(h, r)
        for one, share in zip(x, tube.shares, strict=True):
            assert abs(one) < share * bound * p * abs(off)
        assert (
            max(float(abs(one) / (share * bound * p * abs(off))) for one, share in zip(x, tube.shares, strict=True))
            > 1e-5
        )
        now, carry = -off * p ** arb("-0.5"), carried(start, tube, h, r)
        moved = (now / start.coefficient(delta**3)).log()
        assert carry.lower() < moved.upper()
        assert moved.lower() < carry.upper()
        assert abs(moved) > arb("0.01") > carry.rad() / 4


def value_at(polynomial: Any, h: arb, r: arb, excess: arb) -> arb:
    terms = excess_terms(polynomial).items()
    return sum((ball(value) * h**i * r**n * excess**k for (i, n, k), value in terms), arb(0))


def test_from_far_away_it_is_undecided_and_says_why() -> None:
    found = affine_side(EXTENDED, "1/3", place_of(fmpq(1, 2), fmpq(1, 3)))
    assert found.side is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "Theorem B'" in found.verdict.detail


@pytest.mark.slow
def test_without_slopes_it_is_the_model_system() -> None:
    """epsilon_0 of both lie within a factor of 3: the same theorem with other free choices."""
    level = AffineSystem(Affine(fmpq(-1)), Affine(fmpq(-1)), Affine(fmpq(-3, 2)), PAPER)
    found = affine_side(level, "1/2", -2)
    assert found.side == "lift-off"
    assert fmpq(64, 185193) / 3 < found.epsilon < fmpq(64, 185193) * 3


def staged(side: int, until: fmpq) -> Any:
    """A stand-in for ``_followed``: ranges up to ``until`` are proved."""

    def decided(_: Any, __: Any, equations: Any, *___: Any) -> Any:
        least, most = equations.least, equations.exact_delta
        return (
            SideEnd(least, most, side, fmpq(1), cone_of(1), arb(2), arb(3), (), SHOWN) if most <= until else "too large"
        )

    return decided


def asked(monkeypatch: pytest.MonkeyPatch, follow: Any, **words: Any) -> AffineSide:
    monkeypatch.setattr(module, "_prepared", lambda _: iter(()))
    monkeypatch.setattr(module, "_followed", follow)
    return affine_side(EXTENDED, P, place_of(fmpq(-1, 2)), **words)


@pytest.mark.parametrize(("side", "word"), [(-1, "lift-off"), (1, "impact")])
@pytest.mark.parametrize("until", [LARGEST_DELTA, fmpq(1, 50), fmpq(1, 30000)])
def test_ranges_are_followed_as_far_as_they_go(
    side: int, word: str, until: fmpq, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = asked(monkeypatch, staged(side, until))
    assert (found.side, found.verdict.outcome) == (word, Outcome.PROVED)
    assert until * fmpq(9, 10) < fmpq(found.epsilon.p.root(3), found.epsilon.q.root(3)) <= until
    statement = found.verdict.statement
    assert (
        f"for every 0 < epsilon <= {found.epsilon}, as long as slip is positive: lambda_N > 0 until p < 0" in statement
    )
    ends = "it vanishes later: contact is lost" if side < 0 else "until it exceeds 20; p < 0 there"
    assert statement.endswith(ends)


def test_an_impact_is_a_matter_of_later_times(monkeypatch: pytest.MonkeyPatch) -> None:
    """alpha_2 = -1 + p: lambda_N = 403/200 at the start, with p > 0, which is more than 803/400 already."""
    system = AffineSystem(Affine(fmpq(-1)), Affine(fmpq(-1), fmpq(1)), Affine(fmpq(-3, 2)), PAPER)
    force = fmpq(403, 200)
    assert AffineStart(manifold_of(system), P, -P * force, fmpq(0)).excess < 0
    assert force > fmpq(803, 400)
    monkeypatch.setattr(module, "_prepared", lambda _: iter(()))
    monkeypatch.setattr(module, "_followed", staged(1, fmpq(1, 512)))
    found = affine_side(system, P, -P * force, force=fmpq(803, 800))
    assert found.verdict.statement.endswith(
        ": lambda_N > 0 until p < 0; after that it stays so until it exceeds 803/400; p < 0 there"
    )


def test_without_a_range_nothing_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    found = asked(monkeypatch, staged(1, fmpq(0)))
    assert (found.side, found.verdict.outcome) == (None, Outcome.UNDECIDED)
    assert found.verdict.detail == "too large"
    assert found.epsilon == smallest(LARGEST_DELTA) ** 3


def test_ranges_on_different_sides_prove_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def sides(_: Any, __: Any, equations: Any, *___: Any) -> Any:
        return staged(1 if equations.least == 0 else -1, fmpq(1, 50))(_, __, equations, ___)

    found = asked(monkeypatch, sides)
    assert (found.side, found.verdict.detail) == (None, "too large")
    whole = asked(
        monkeypatch, lambda *given: sides(*given) if given[2].least == 0 else staged(-1, LARGEST_DELTA)(*given)
    )
    assert whole.verdict.detail == "different epsilon have different sides"


@pytest.mark.parametrize(
    ("p", "words", "message"),
    [
        ("0", {}, "p must be positive"),
        ("-1/100", {}, "p must be positive"),
        ("1/100", {"within": "-1/1000"}, "within not negative"),
        ("1/100", {"force": "1"}, "force above 1"),
    ],
)
def test_what_is_refused(p: str, words: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        affine_side(EXTENDED, p, "-1/50", **words)


def test_the_reference_itself_and_an_integer_beta_are_refused() -> None:
    with pytest.raises(ValueError, match="nothing decides the side"):
        affine_side(EXTENDED, P, place_of(fmpq(0)))
    with pytest.raises(ValueError, match="no integer"):
        affine_side(AffineSystem(EXTENDED.alpha_1, EXTENDED.alpha_2, Affine(fmpq(-3)), PAPER), P, "-1/50")


def test_what_stands_where_nothing_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[Any] = []
    monkeypatch.setattr(module, "_side", lambda *words: given.append(words))
    affine_side(EXTENDED, P, place_of(fmpq(1)))  # L = 1 is not the reference
    affine_side(EXTENDED, "1/3", "-1/50", within=0, force="1000001/1000000")
    (first, factor), (second, least) = given
    assert (first.manifold.system, first.p, first.excess, first.within, factor) == (EXTENDED, P, 1, fmpq(1, 100), 10)
    assert (second.p, second.b, second.within, least) == (fmpq(1, 3), fmpq(-1, 50), 0, fmpq(1000001, 1000000))


def one_plan(place: int = 2) -> Plan:
    return Plan(fmpq(1), fmpq(1, 2), fmpq(1), fmpq(1, 10), 3, fmpq(place))


def prepared_one(place: int = 2) -> Any:
    return SimpleNamespace(
        plan=one_plan(place), start=f"start {place}", norm="norm", growth="growth", rectangle="rectangle", failed={}
    )


def test_lemma_1_is_shown_once_for_each_norm(monkeypatch: pytest.MonkeyPatch) -> None:
    """r_1^2 >= p_1, the manifold of the plan's order; the first rate that is shown, or the last."""
    system = AffineSystem(Affine(fmpq(-2), fmpq(0), fmpq(1)), Affine(fmpq(-1)), Affine(fmpq(-3)), PAPER)
    given = AffineStart(manifold_of(system), fmpq(1, 7), fmpq(-1), fmpq(0))
    choices = [replace(one_plan(), growth=fmpq(n)) for n in (1, 2, 3)]
    plans = [choices, choices[:1]] if system.a == 2 else []
    monkeypatch.setattr(module, "affine_plans", lambda beta, a, _: plans if (beta, a) == (fmpq(3, 2), 2) else [])

    def growth(norm: Any, rectangle: Any, rate: fmpq, damping: fmpq) -> Any:
        return SimpleNamespace(evidence=SHOWN if rate == 2 else None, given=(norm, rectangle, rate, damping))

    monkeypatch.setattr(module, "fast_growth", growth)
    one, other = list[Any](module._prepared(given))
    assert (one.plan, other.plan) == (choices[1], choices[0])
    assert one.start.manifold == one.norm.series == slow_manifold(system, Cut(3, fmpq(8), fmpq(1)))
    assert (one.start.p, one.start.b, one.start.excess) == (given.p, given.b, given.excess)
    assert one.norm == Norm(one.start.manifold, fmpq(1), fmpq(1, 2))
    assert one.growth.given == (one.norm, one.rectangle, fmpq(2), fmpq(1, 10))
    assert fmpq(1, 7) <= one.rectangle.r**2 < fmpq(1, 6)
    assert one.rectangle.h**2 * 2 * 8 >= 1


def test_each_ratio_and_z_max_is_tried_until_one_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """But for those z_max that the start exceeds: z_0 >= 3 eta."""
    tried, kept = list[Any](), list[Any]()
    passed = object.__new__(AffineTube)

    def bound(*given: Any, ratio: fmpq, known: Any) -> Any:
        words = (*given, ratio)
        kept.append(known)
        tried.append(words)
        return passed if words[5] >= fmpq(1, 5) and words[6] > fmpq(11, 10) else f"not {words[5]}"

    monkeypatch.setattr(module, "affine_tube", bound)
    start, one = AffineStart(manifold_of(), P, fmpq(-1), fmpq(1, 50)), prepared_one()
    assert module._tube(start, one, fmpq(1, 7)) is passed
    likely = [value for value in LARGEST if value > fmpq(3, 50)]
    assert 0 < len(likely) < len(LARGEST)
    first, second = module._RATIOS[:2]
    wanted = [(value, first) for value in likely] + [(value, second) for value in likely if value <= fmpq(1, 5)]
    assert [words[5:] for words in tried] == wanted
    assert all(words[:5] == ("start 2", "norm", "growth", "rectangle", fmpq(1, 7)) for words in tried)
    assert all(ratio > 1 for ratio in module._RATIOS)
    assert all(one is kept[0] for one in kept)
    assert set(one.failed) == {(words[6], words[5]) for words in tried[:-1]}
    tried.clear()
    assert module._tube(start, one, fmpq(1, 7)) is passed  # what failed for this e, or a smaller one, is left out
    assert module._tube(start, one, fmpq(1, 6)) is passed
    assert [words[5:] for words in tried] == wanted[-1:] * 2
    tried.clear()
    assert module._tube(start, one, fmpq(1, 8)) is passed
    assert [words[5:] for words in tried] == wanted
    assert set(one.failed.values()) == {(fmpq(1, 8), f"not {value}") for value in likely}
    text = {fmpq(1, 10): "not certain: a; b", fmpq(1, 5): "not certain: c", fmpq(1, 3): "not certain: d"}
    monkeypatch.setattr(module, "affine_tube", lambda *words, **_: text.get(words[5], "slow"))
    one.failed.clear()
    for _ in range(2):  # the second time all is known
        assert module._tube(start, one, fmpq(1, 7)) == "not certain: c"
    assert module.nearest(["x", "y; z"]) == "x"
    assert module.nearest(["x", "not certain: y; z"]) == "not certain: y; z"
    assert module.nearest([]) == "no norm and no z_max was tried"


def test_a_plan_that_fails_is_followed_by_the_next(monkeypatch: pytest.MonkeyPatch) -> None:
    """By its tube, its hand-over, its end; what the one failed by that came farthest is said. e = a delta^3."""
    system = AffineSystem(Affine(fmpq(-2)), Affine(fmpq(-1)), Affine(fmpq(-3)), PAPER)
    start = AffineStart(manifold_of(system), P, fmpq(-1), fmpq(0))
    equations = SimpleNamespace(exact_delta=fmpq(1, 10))
    end = SideEnd(fmpq(0), fmpq(1), 1, fmpq(1), cone_of(1), arb(2), arb(3), (), SHOWN)
    tube, handed, seen = SimpleNamespace(evidence=SHOWN, cone="cone"), SimpleNamespace(z=arb("0.25")), list[Any]()
    beside = SimpleNamespace(z=arb("0.125"))

    def tubes(_: Any, one: Any, e: fmpq) -> Any:
        seen.append(e)
        return "z" if one.plan.place == 1 else tube

    def hand_over(*given: Any) -> Any:
        assert given[:3] == (equations, f"start {given[3]}", tube)
        return "handed" if given[3] == 2 else beside if given[3] == 4 else handed

    def ended(*given: Any) -> Any:
        assert given[:3] == (start, equations, fmpq(11))
        assert given[3] is (beside if given[4] == 4 else handed)
        return "ended" if given[4] == 3 else end

    for name, stand_in in (("_tube", tubes), ("affine_hand_over", hand_over), ("_ended", ended)):
        monkeypatch.setattr(module, name, stand_in)

    ways = list[Any]()

    def followed(*places: int) -> Any:
        plans = [prepared_one(place) for place in places]
        return module._followed(start, plans, equations, fmpq(11), ways)  # type: ignore[arg-type]

    found = followed(1, 2, 3, 4, 1)
    assert isinstance(found, SideEnd)
    assert found.evidence is not SHOWN
    assert set(seen) == {fmpq(2, 1000)}
    assert len(seen) == 4
    assert followed(1) == "Theorem B': z"
    assert followed(1, 2) == "handed"
    assert followed(2, 3) == "ended"
    assert followed(3, 2, 1) == "ended"
    assert followed(3, 5) == "ended"  # z is no smaller than that of the one that came to no end
    assert isinstance(followed(5), SideEnd)
    ways.pop()
    assert followed(2, 1) == "handed"
    assert followed() == "Theorem B': no norm and no z_max was tried"
    ((cone, later),) = ways
    assert cone == "cone"
    # delta^2 (S + s_1 + log(ratio/delta^mu)/a) at delta = 1: S = 4, mu = 1, ratio = 2, a = 1
    assert abs(later - (5 + arb(2).log())) < arb(2) ** -40
    tube.evidence = None
    assert followed(4, 1) == "Theorem B': z"
    assert len(ways) == 1


def test_the_end_is_looked_for_from_the_hand_over_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """mu = 2 (beta - 1), from s = -S."""
    start, equations = AffineStart(manifold_of(), P, fmpq(-1), fmpq(0)), SimpleNamespace()
    handed = SimpleNamespace(centre="centre", radii="radii", fast="fast", frame="frame", z=arb("0.25"))
    pieces = [SimpleNamespace(end=fmpq(-1)), SimpleNamespace(end=fmpq(1, 2)), SimpleNamespace(end=fmpq(5, 2))]
    given, tracked, reached = list[Any](), SimpleNamespace(pieces=pieces), "end"

    def tracks(*words: Any, **more: Any) -> Any:
        given.append((words, more))
        return tracked

    monkeypatch.setattr(module, "track", tracks)
    monkeypatch.setattr(module, "end_of_track", lambda _, __: fmpq(9))
    monkeypatch.setattr(module, "first_end", lambda *words: reached if words == (tracked, fmpq(-2), fmpq(11)) else 0)

    def ended() -> Any:
        return module._ended(start, equations, fmpq(11), handed, fmpq(2))  # type: ignore[arg-type]

    assert ended() == "end"
    ((words, more),) = given
    assert words == (equations, fmpq(1), fmpq(-2), fmpq(9))
    assert more == {"centre": "centre", "radii": "radii", "fast": "fast", "frame": "frame"}
    reached = None  # type: ignore[assignment]
    assert ended() == "Theorems U1, U2: no end is certain up to s = 5/2; z <= 0.250 at s = -2"
    tracked.pieces = []
    assert "no end is certain up to s = -2;" in ended()
