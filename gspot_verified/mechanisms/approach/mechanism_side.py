"""From a state of a mechanism to lift-off or impact without collision, for every epsilon below some epsilon_0 > 0.

Proof page: ``proofs/papers_rule.md``, Theorem R: its hypotheses are compared here, beta and C_1 in balls.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from typing import ClassVar

from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.from_state.affine_side import AffineSide
from gspot_verified.expansion.from_state.limit_side import OTHER, rule_of
from gspot_verified.expansion.from_state.slow_series import Contact, contact_text
from gspot_verified.expansion.series.regularisation import NO_DAMPER
from gspot_verified.mechanisms.approach.approach import MAX_STEPS, Goal, followed
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.approach.slip_programs import slip_programs
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.spot_conditions import components_of
from gspot_verified.numbers.balls import ExactInput, ball_text, relative_bits, working_bits
from gspot_verified.numbers.evidence import differ, every, less, signed
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written, under

_KEPT = 8  # flows whose components are known


@dataclass(frozen=True)
class OwnSide(NoTruthValue, Written):
    """What becomes of all starts around the user's own state, for every epsilon in (0, ``epsilon``] at once.

    The starts: in contact, every component within ``beside`` epsilon of the state on the contact, and the contact's
    fast part at most ``share`` of \\|b\\|, as the statement says. ``side``: "lift-off", "impact", or None: undecided,
    and ``verdict.detail`` says which inequality is not certain.
    """

    written: ClassVar[str] = "beside share epsilon side verdict"

    beside: fmpq
    share: fmpq
    epsilon: fmpq
    side: str | None
    verdict: Verdict

    def __str__(self) -> str:
        return str(self.verdict)


@dataclass(frozen=True)
class MechanismSide(NoTruthValue, Written):
    """What the compliant mechanism does at the G-spot that slip from a state reaches, for small epsilon.

    ``side``: "lift-off" (contact lasts until p < 0 and is then lost), "impact" (without collision: lambda_N exceeds a
    given force without contact having been lost; that the impact is completed is not proved), or None: undecided, and
    ``verdict.detail`` says what is not certain. "For small epsilon": there is an epsilon_0 > 0, in an impact for every
    force; it is not computed, and nothing is said of any one epsilon.
    ``approach`` is what was proved for rigid slip, ``active`` names the components on which the contact depends.
    ``explicit``, where it was asked for: an epsilon_0 for a set of starts. Where p, b, y, v are no components it is
    a set around a state of rigid slip near the G-spot, which slip reaches at the time ``reached``; then ``own`` is
    about the starts around the state itself. ``not_explicit``: why there is none, where a chart was asked for.
    """

    written: ClassVar[str] = "side active verdict explicit not_explicit reached own " + under(
        "approach",
        "name start solved end place case alphas beta C1=coefficient surface_velocity least_slip notes warnings bits",
    )

    approach: Approach
    active: tuple[str, ...]
    side: str | None
    verdict: Verdict
    explicit: AffineSide | None = None
    reached: str | None = None
    own: OwnSide | None = None
    not_explicit: str | None = None

    def __str__(self) -> str:
        found = self.approach
        lines = [str(self.verdict)]
        if found.end == "G-spot":
            lines.append(f"  the G-spot: {found.components(found.place)}")
        if found.case in ("I", "II", "III") and found.beta is not None:
            lines.append(f"  Case {found.case}, beta = {ball_text(found.beta)}")
        if found.coefficient is not None:
            lines.append(f"  C_1 = {ball_text(found.coefficient)}")
        if self.side is not None:
            lines.append("  rests on proofs/papers_rule.md, Theorem R; epsilon_0 is not computed")
        if self.explicit is not None:
            lines.append(f"  for an explicit epsilon_0 (proofs/from_state.md, section 8): {self.explicit}")
        if self.not_explicit is not None:
            lines.append(f"  no explicit epsilon_0 (proofs/chart.md): {self.not_explicit}")
        if self.reached is not None:
            comes = f"  rigid slip from the state is at one of these starts after t = {self.reached}"
            beside = "; that the compliant motion from the state comes there too is not part of it"
            lines.append(comes if self.own is not None and self.own.side is not None else comes + beside)
        if self.own is not None:
            lines.append(f"  from the state itself (proofs/from_own_state.md): {self.own}")
        return "\n".join([*lines, *(f"  {line}" for line in (*found.notes, *found.warnings))])


def mechanism_side(
    mechanism: Mechanism,
    start: StateInput,
    *,
    surface_velocity: ExactInput | None = None,
    max_steps: int = MAX_STEPS,
    spot: int | None = None,
) -> MechanismSide:
    """Whether the mechanism with its compliant contact lifts off or takes an impact, for every small epsilon.

    The arguments are those of :func:`approach`, which proves that rigid slip from ``start`` reaches a G-spot and
    encloses C_1. Proved with it, for every family of starts that tends to this state as the statement says: there is an
    epsilon_0 > 0 such that for every 0 < epsilon <= epsilon_0 the compliant motion keeps contact and slip until p < 0,
    and what follows then. Case III, beta > 1 in a
    ball without an integer, p, b, y, v independent at the G-spot. No slow manifold is assumed.

    :raises StateError: the state is not on the contact, p <= 0, b >= 0, or slip is not positive there.
    :raises MechanismError: the mechanism is not complete.
    :raises ValueError: there is no G-spot of that number.

    >>> from gspot_verified import load
    >>> found = mechanism_side(load("model system"), {"x": 0, "u": 3, "p": "1/2", "b": "-2"})
    >>> found.side, found.verdict.outcome.value, found.active
    ('lift-off', 'proved', ('y', 'v', 'p', 'b'))
    """
    return side_from(
        shift(at_spot(mechanism, spot)),
        start,
        surface_velocity=surface_velocity,
        max_steps=max_steps,
        beside_place=spot is not None,
    )


def side_from(
    shifted: Shifted,
    start: StateInput,
    *,
    surface_velocity: ExactInput | None = None,
    max_steps: int = MAX_STEPS,
    beside_place: bool = False,
    precisions: Sequence[int] | None = None,
    coefficient_bits: int | None = None,
) -> MechanismSide:
    """The same for a mechanism whose functions are derived; the arguments are those of :func:`followed`.

    ``coefficient_bits``: a run ends when the side, Theorem R's too where it may say one, and so many bits of C_1 are
    known; None: as in :func:`approach`.
    """
    judged: list[tuple[Approach, tuple[tuple[str, ...], tuple[str, Evidence] | _Open]]] = []

    def enough(found: Approach) -> bool:
        """Whether going on would say no more that is asked for."""
        if found.coefficient is None or found.exit_code != 0:
            return False
        if coefficient_bits and relative_bits(found.coefficient) < coefficient_bits:
            return False
        with working_bits(found.bits):
            judged[:] = [(found, _outcome(shifted, found))]
        outcome = judged[0][1][1]
        return not isinstance(outcome, _Open) or outcome.reason is Reason.BEYOND

    found = followed(
        shifted,
        start,
        surface_velocity=surface_velocity,
        max_steps=max_steps,
        beside_place=beside_place,
        precisions=precisions,
        goal=None if coefficient_bits is None else Goal(enough, coefficient_bits),
    )
    whole = _statement(shifted.mechanism, found)
    if judged and judged[0][0] is found:
        names, outcome = judged[0][1]
    else:
        with working_bits(found.bits):
            names, outcome = _outcome(shifted, found)
    if isinstance(outcome, _Open):
        verdict = Verdict.undecided(f"{whole} lift-off or impact", outcome.reason, outcome.why)
        return MechanismSide(found, names, None, verdict)
    side, evidence = outcome
    ends = {"lift-off": "contact is lost", "impact": "lambda_N exceeds Lambda without contact being lost"}
    return MechanismSide(found, names, side, Verdict.proved(f"{whole} {ends[side]}", evidence))


@dataclass(frozen=True)
class _Open:
    """Which hypothesis of Theorem R is not certain."""

    reason: Reason
    why: str


def _statement(mechanism: Mechanism, found: Approach) -> str:
    springs = mechanism.regularisation
    surface = (
        " on any surface whose constant velocity is below u on the whole way, the G-spot included"
        if found.surface_velocity is None
        else f" {found.on_surface}".rstrip()
    )
    below = ""
    if springs.c > 0:
        contact = Contact.of(springs)
        below = (
            " and the limsup of (kappa p (v/epsilon)^2 + (b + p lambda_N)^2 + "
            "(g^2/l) p (lambda_N + kappa y/epsilon^2 + (l/g) v/epsilon)^2)/b^2 below 1, "
            f"kappa = {contact.kappa}, g = {contact.rate}, l = {contact.lag} (it is 0 at rest in the "
            "contact: v = 0, lambda_N = -b/p, y = -epsilon^2 lambda_N/kappa)"
        )
    return (
        f"{mechanism.name} with {contact_text(springs)}{surface}: for every family of starts in contact that tends to "
        f"{found.components(found.start)}, on the contact, as epsilon -> 0, with y/epsilon^2, v/epsilon, lambda_N "
        f"bounded{below}, and every force Lambda, there is an epsilon_0 > 0 such that for every 0 < epsilon <= "
        "epsilon_0 contact and positive slip last until p < 0, and then, in positive slip,"
    )


def _outcome(shifted: Shifted, found: Approach) -> tuple[tuple[str, ...], tuple[str, Evidence] | _Open]:
    """The active components, and the side with what was compared."""
    mechanism = shifted.mechanism
    if found.verdict.evidence is None or found.end is None:
        return (), _Open(found.verdict.reason or Reason.HYPOTHESIS, found.verdict.detail)
    if found.end != "G-spot" or found.alphas is None or found.beta is None:
        return (), _Open(Reason.BEYOND, f"in rigid slip from this state: {found.end} before any G-spot")
    if found.case != "III":
        case = f"Case {found.case}" if found.case in ("I", "II") else found.side_reason
        return (), _Open(Reason.BEYOND, f"Theorem R is about Case III: {case}")
    if found.coefficient is None:
        return (), _Open(Reason.HYPOTHESIS, found.side_reason)
    if not mechanism.regularisation.c > 0:
        return (), _Open(Reason.BEYOND, NO_DAMPER)
    programs = slip_programs(shifted)
    active = active_components(programs.flow)
    names = tuple(mechanism.state[i] for i in active)
    regular = independent(programs.numbers, active, found.spot)
    if regular is None:
        return names, _Open(Reason.HYPOTHESIS, "the differentials of p, b, y, v at the G-spot may be dependent")
    rule, of_coefficient = rule_of(found.beta, mechanism.regularisation), signed(found.coefficient)
    if rule is None or of_coefficient is None or of_coefficient[0] == 0:
        return names, _Open(Reason.WIDE_INPUT, found.side_reason)
    evidence = every(
        [found.verdict.evidence, *(less(each, 0) for each in found.alphas), regular, rule[1], of_coefficient[1]]
    )
    if evidence is None:
        return names, _Open(Reason.HYPOTHESIS, "the sign of an alpha is not certain")
    return names, (rule[0] if of_coefficient[0] > 0 else OTHER[rule[0]], evidence)


@lru_cache(_KEPT)
def active_components(flow: SlipFlow) -> tuple[int, ...]:
    """The components on which p, b, y, v, the alphas, and their own rates depend or may depend, in order."""
    active = frozenset[int]().union(
        *(components_of(f) for f in (flow.p, flow.b, flow.y, flow.v, flow.alpha_1, flow.alpha_2, flow.alpha_3))
    )
    while True:
        rates = (function for i in active for function in (flow.F[i], flow.G[i]))
        whole = active.union(*(components_of(rate) for rate in rates))
        if whole == active:
            return tuple(sorted(active))
        active = whole


def independent(numbers: SlipNumbers, components: Sequence[int], box: Sequence[arb]) -> Evidence | None:
    """That d(p, b, y, v) by these components has the rank 4 at every state of the box: a minor that is not 0."""
    rows = numbers.condition_rows(list(box))
    minors = (arb_mat([[row[i] for i in four] for row in rows]).det() for four in combinations(components, len(rows)))
    return next((shown for minor in minors if (shown := differ(0, minor)) is not None), None)
