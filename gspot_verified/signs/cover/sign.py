"""The sign of dTheta/dtau on ranges of tau and beta: proved, refuted with a point, or undecided with what is left.

Proof pages: ``proofs/certificate.md`` (what the pieces prove), ``proofs/signs.md``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import ClassVar

from flint import fmpq

from gspot_verified.numbers.balls import ball, hull, working_bits
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.evidence import cover, equal, signed
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.journal import opened
from gspot_verified.signs.cover.pieces import Column
from gspot_verified.signs.cover.refutation import Failure, refutation
from gspot_verified.signs.cover.sign_column import SignQuestion, sign_column
from gspot_verified.signs.cover.statements import SignStatement, cells_of
from gspot_verified.signs.cover.subdivision import Progress, Subdivision
from gspot_verified.signs.cover.witness import find_witness, sign_at, value_at
from gspot_verified.work.executors import InProcessExecutor
from gspot_verified.work.ranges import Range

MAX_BETA = 200  # up to which a proof is sought: the independent checker goes as far (proofs/check.md)
DEFAULT_BUDGET = 2_000  # ranges of beta that are examined, against endless work


@dataclass(frozen=True, slots=True)
class SignResult(NoTruthValue, Written):
    """The verdict; ``columns`` prove the statement, or ``point`` and ``sign_there`` refute it and ``columns`` prove the
    sign at that point. At one point with an integer beta there are no columns: an integer polynomial is evaluated."""

    written: ClassVar[str] = "statement verdict columns=columns.__len__ pieces examined point sign_there"

    statement: SignStatement
    verdict: Verdict
    columns: tuple[Column, ...] = ()
    point: tuple[fmpq, fmpq] | None = None
    sign_there: int | None = None
    examined: int = 0

    @property
    def pieces(self) -> int:
        """How many pieces the columns have."""
        return sum(len(column.pieces) for column in self.columns)

    def __str__(self) -> str:
        return str(self.verdict)

    @property
    def proved_statement(self) -> SignStatement | None:
        """What a certificate states: the statement itself, or the sign at the point that refutes it."""
        if self.verdict.outcome is Outcome.PROVED:
            return self.statement
        if self.point is None or self.sign_there is None:
            return None
        tau, beta = (Range(value, value, True, True) for value in self.point)
        at_point = SignStatement(tau, beta, self.sign_there)
        return at_point if self.columns or _at_integer(tau, beta) else None


def sign(
    tau: Range | str,
    beta: Range | str,
    sign: int = -1,
    *,
    budget: int = DEFAULT_BUDGET,
    by_theorem: bool = False,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> SignResult:
    """Whether dTheta/dtau has the sign ``sign`` (1 or -1) at every tau and beta of the two ranges.

    Ranges as in :meth:`Range.parse`. ``budget`` counts examined ranges of beta. ``by_theorem``: take the Laplace
    integral for beta <= 1 instead of numbers. A ``journal`` file lets a killed run go on; every column that it recalls
    is proved again.

    :raises ValueError: an argument is out of range.

    >>> result = sign("-inf..inf", "0..1")
    >>> str(result)
    'proved: dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)'
    >>> sign("-1..1", "[2..3]").verdict.witness
    'dΘ/dτ = 0 at τ = 0, β = 2'
    """
    tau = tau if isinstance(tau, Range) else Range.parse(tau, "tau")
    beta = beta if isinstance(beta, Range) else Range.parse(beta, "beta")
    if type(sign) is not int or sign not in (1, -1):
        raise ValueError("sign must be 1 or -1")
    if type(budget) is not int or budget < 0:
        raise ValueError("the budget must be a nonnegative int")
    statement = SignStatement(tau, beta, sign)
    if budget == 0:
        return SignResult(
            statement, _undecided(statement, Reason.BUDGET, "nothing was examined", [(beta.lower, beta.upper)])
        )
    witness = find_witness(tau, beta, sign)
    if witness is not None:
        return _refuted(statement, witness, 0)
    there = sign_at(*_point(tau, beta)) if _at_integer(tau, beta) else None
    if there is not None and (same := equal(there, sign)) is not None:
        return SignResult(statement, Verdict.proved(str(statement), same))
    if beta.upper is None or beta.upper > MAX_BETA:
        detail = f"no point against it was found; a proof is sought for beta <= {MAX_BETA} only"
        return SignResult(statement, _undecided(statement, Reason.BEYOND, detail, [(beta.lower, beta.upper)]))
    # dTheta/dtau = -beta F; a range with beta = 0 inside was refuted above, so beta has one sign.
    wanted = sign if beta.upper <= 0 else -sign
    question = SignQuestion(tau, beta, wanted, by_theorem)
    with opened(journal, {**statement.to_json(), "by_theorem": by_theorem}) as kept:
        tree = Subdivision(_cells(beta), budget, journal=kept)
        for step in tree.steps(partial(sign_column, question), executor or InProcessExecutor()):
            if progress is not None:
                progress(step)
    if tree.witness is not None:
        return _refuted(statement, tree.witness, tree.examined)
    if tree.unfinished:
        detail = f"{counted(tree.examined, 'range')} of beta examined, {len(tree.finished)} settled"
        reason = Reason.BUDGET if tree.examined >= budget else Reason.HYPOTHESIS
        return SignResult(statement, _undecided(statement, reason, detail, tree.unfinished), examined=tree.examined)
    covered = cover(((column.lower, column.upper) for column in tree.finished), (beta.lower, beta.upper))
    if covered is None:
        detail = "the columns that were found leave a part of the range out"
        return SignResult(statement, _undecided(statement, Reason.HYPOTHESIS, detail, []), examined=tree.examined)
    return SignResult(statement, Verdict.proved(str(statement), covered), tuple(tree.finished), examined=tree.examined)


def _cells(beta: Range) -> list[tuple[fmpq | None, fmpq]]:
    assert beta.upper is not None
    if beta.lower is not None and beta.lower >= 0:
        return [*cells_of(beta)]
    # beta < 0: one column by the Laplace integral.
    return [(beta.lower, beta.upper)]


def _refuted(statement: SignStatement, point: tuple[fmpq, fmpq], examined: int) -> SignResult:
    def failure(tau: fmpq, beta: fmpq) -> Failure | None:
        value = value_at(tau, beta)
        certain_sign = None if value is None else signed(value)
        if certain_sign is None or certain_sign[0] == statement.sign:
            return None
        return f"dΘ/dτ {({1: '>', 0: '=', -1: '<'})[certain_sign[0]]} 0", certain_sign[1]

    against = refutation(str(statement), {"τ": statement.tau, "β": statement.beta}, [point], failure)
    tau, beta = point
    there = sign_at(tau, beta)
    if against is None or there is None:
        detail = f"the sign at τ = {tau}, β = {beta} could not be confirmed"
        return SignResult(statement, _undecided(statement, Reason.HYPOTHESIS, detail, []), examined=examined)
    return SignResult(statement, against.verdict, _columns_at(tau, beta, there), point, there, examined)


def _columns_at(tau: fmpq, beta: fmpq, sign: int) -> tuple[Column, ...]:
    """A column that proves the sign at one point for a certificate; none at an integer, or if it was not found."""
    ranges = Range(tau, tau, True, True), Range(beta, beta, True, True)
    if _at_integer(*ranges) or abs(beta) > MAX_BETA or not sign:
        return ()
    column = sign_column(SignQuestion(*ranges, sign if beta < 0 else -sign), beta, beta)
    return (column,) if isinstance(column, Column) else ()


def _at_integer(tau: Range, beta: Range) -> bool:
    """Whether the ranges are one point with an integer beta >= 0."""
    return tau.is_point and beta.is_point and beta.lower is not None and beta.lower >= 0 and beta.lower.q == 1


def _point(tau: Range, beta: Range) -> tuple[fmpq, fmpq]:
    assert tau.lower is not None
    assert beta.lower is not None
    return tau.lower, beta.lower


def _undecided(
    statement: SignStatement, reason: Reason, detail: str, left: Sequence[tuple[fmpq | None, fmpq | None]]
) -> Verdict:
    text = "; left: β in " + ", ".join(f"[{_end(a, '-inf')}, {_end(b, 'inf')}]" for a, b in left[:8]) if left else ""
    boxes = tuple((_dyadic(a, b),) for a, b in left if a is not None and b is not None)
    return Verdict.undecided(str(statement), reason, detail + text, boxes)


def _end(value: fmpq | None, infinite: str) -> str:
    return infinite if value is None else str(value)


def _dyadic(lower: fmpq, upper: fmpq) -> Dyadic:
    with working_bits(128):
        return Dyadic.from_ball(hull([ball(lower), ball(upper)]))
