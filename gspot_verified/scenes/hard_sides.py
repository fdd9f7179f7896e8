"""A set of starts, and how often float runs report the wrong side of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from importlib import resources
from itertools import product
from typing import ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import rational
from gspot_verified.mechanisms.input.toml_table import toml_table
from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.verdict import NoTruthValue, Verdict
from gspot_verified.numbers.written import Shown, Written
from gspot_verified.scenes.floats.float_run import METHODS
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.side import FAILED, NO_EVENT, CertifiedSide, certified_side, float_side

_LISTS = ("epsilons", "betas", "nus", "solvers", "tolerances")
_KEYS = {"": ("format", "scene", *_LISTS)}


@dataclass(frozen=True)
class HardSides(Shown):
    """Starts (every beta, nu and epsilon), and the float runs that are asked: every solver and tolerance."""

    scene: str
    epsilons: tuple[fmpq, ...]
    betas: tuple[fmpq, ...]
    nus: tuple[fmpq, ...]
    solvers: tuple[str, ...]
    tolerances: tuple[str, ...]

    def starts(self) -> Iterator[Start]:
        """Each start, in the order of epsilon, beta, nu."""
        for epsilon, beta, nu in product(self.epsilons, self.betas, self.nus):
            yield Start(self.scene, epsilon, beta, nu)

    def restricted(self, **lists: Sequence[str] | None) -> HardSides:
        """The set with other lists in place of its own; None or nothing changes nothing.

        :raises SceneError: an unknown solver, a tolerance out of range.
        :raises ValueError: an epsilon, beta or nu that is no number.
        """
        given = {name: tuple(words) for name, words in lists.items() if words}
        numbers = {n: tuple(rational(w, n) for w in words) for n, words in given.items() if n in _LISTS[:3]}
        for tolerance in given.get("tolerances", ()):
            _tolerance(tolerance)
        for solver in given.get("solvers", ()):
            if solver not in METHODS:
                raise SceneError(f"method: expected one of {', '.join(METHODS)}, got {solver[:40]!r}")
        return replace(self, **{**given, **numbers})  # type: ignore[arg-type]


@dataclass(frozen=True)
class Start:
    """One start of the set."""

    scene: str
    epsilon: fmpq
    beta: fmpq
    nu: fmpq

    def load(self) -> Scene:
        """The scene with these numbers."""
        return load_scene(self.scene, beta=self.beta, nu=self.nu, epsilon=self.epsilon)


@dataclass(frozen=True)
class Count(NoTruthValue, Written):
    """How the float runs of one solver and tolerance answered at one epsilon and beta, over the starts nu.

    ``wrong``: the side that the certified answer excludes, of ``decided`` starts; ``silent``: no event up to the end;
    ``failed``: the solver gave up.
    """

    ask: ClassVar[str] = ".wrong is a number"

    solver: str
    tolerance: str
    epsilon: fmpq
    beta: fmpq
    wrong: int
    silent: int
    failed: int
    decided: int


class StartRow(NamedTuple):
    """A start, its certified side (``K`` is its sign), and that of the paper's rule; None: undecided."""

    epsilon: fmpq
    beta: fmpq
    nu: fmpq
    side: str | None
    K: arb
    shown_K: str
    asymptotic: str | None
    rule_fails: bool | None
    verdict: Verdict


@dataclass(frozen=True)
class WrongSides(NoTruthValue, Written):
    """The certified answers, and the counts of the float ones."""

    ask: ClassVar[str] = ".counts says how many are wrong"
    written: ClassVar[str] = "starts counts"

    certified: dict[Start, CertifiedSide]
    counts: tuple[Count, ...]

    @property
    def starts(self) -> list[StartRow]:
        """Every start with its certified side."""
        return [
            StartRow(
                epsilon=start.epsilon,
                beta=start.beta,
                nu=start.nu,
                side=certified.side,
                K=certified.rule.side,
                shown_K=ball_text(certified.rule.side, 3),
                asymptotic=certified.asymptotic,
                rule_fails=certified.rule_fails,
                verdict=certified.verdict,
            )
            for start, certified in self.certified.items()
        ]


def hard_sides() -> HardSides:
    """The set that comes with the package.

    >>> len(list(hard_sides().starts()))
    72
    """
    place = resources.files("gspot_verified.scenes").joinpath("data", "hard-sides.toml")
    table = toml_table(place.read_text(encoding="utf-8"))
    table.only(_KEYS)
    empty = HardSides(table.text("scene"), (), (), (), (), ())
    return empty.restricted(**{name: table.words(name) for name in _LISTS})


def wrong_sides(chosen: HardSides | None = None, progress: Callable[[str], None] | None = None) -> WrongSides:
    """The certified side of every start, and what every float run says of it; nothing is kept.

    ``chosen``: starts and float runs, :func:`hard_sides` if left out (some ten minutes), or a part of them.

    :raises SceneError: an unknown solver, or a tolerance out of range.

    >>> few = hard_sides().restricted(epsilons=["1/1000"], betas=["5/2"], nus=["2"], solvers=["LSODA"])
    >>> [(count.wrong, count.decided) for count in wrong_sides(few.restricted(tolerances=["1e-6"])).counts]
    [(0, 1)]
    """
    chosen = hard_sides() if chosen is None else chosen
    certified: dict[Start, CertifiedSide] = {}
    counts: list[Count] = []
    for epsilon, beta in product(chosen.epsilons, chosen.betas):
        starts = [Start(chosen.scene, epsilon, beta, nu) for nu in chosen.nus]
        if progress is not None:
            progress(f"ε = {epsilon}, β = {beta}")
        for start in starts:
            certified[start] = certified_side(start.load())
        decided = {start: side for start in starts if (side := certified[start].side) is not None}
        for solver, tolerance in product(chosen.solvers, chosen.tolerances):
            pairs = [(float_side(start.load(), solver, _tolerance(tolerance)), side) for start, side in decided.items()]
            silent, failed = (sum(said == word for said, _ in pairs) for word in (NO_EVENT, FAILED))
            wrong = sum(said not in (NO_EVENT, FAILED, side) for said, side in pairs)
            counts.append(
                Count(
                    solver=solver,
                    tolerance=tolerance,
                    epsilon=epsilon,
                    beta=beta,
                    wrong=wrong,
                    silent=silent,
                    failed=failed,
                    decided=len(decided),
                )
            )
    return WrongSides(certified, tuple(counts))


def _tolerance(text: str) -> float:
    try:
        tolerance = float(text)
    except ValueError:
        raise SceneError(f"tolerance: expected a number, got {text[:40]!r}") from None
    if not 1e-13 <= tolerance <= 1e-2:
        raise SceneError(f"tolerance: expected 1e-13..1e-2, got {text[:40]}")
    return tolerance
