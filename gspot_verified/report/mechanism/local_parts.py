"""What is stated next to a G-spot: its class, its side, the expansion and how far true solutions are."""

from __future__ import annotations

import shlex
import warnings
from collections.abc import Callable

from flint import fmpq

from gspot_verified.compliant.model.normal_form import CompliantState, compliant_model
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.expansion.accuracy import AccuracyWarning
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.expansion.true_solutions.side import UniformSide, uniform_side
from gspot_verified.mechanisms.expand import expand
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.mechanism.part import ReportPart, outcome_of
from gspot_verified.report.mechanism.subject import Subject, beta_ends
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.pictures.expansion_picture import expansion_picture
from gspot_verified.report.pictures.mechanism_picture import mechanism_picture
from gspot_verified.report.pictures.phase_plane import phase_plane_picture
from gspot_verified.signs.gamma.side import side, side_text

_COEFFICIENTS = "The coefficients are proved; how far the truncated sums are from the trajectory is not stated here."
_MODEL = "This is about the compliant model with constant α, those of the G-spot, not about the mechanism away from it."
_ORDER = 6  # of the expansion that is shown: p and b with three terms
_SIDE_ORDER = 8  # of the one that true solutions are compared with
_DELTAS = ("1/50", "1/500", "1/5000")  # up to which they are followed, tried in turn
_EPSILONS = ("1/1000", "1/100000")  # of the exact side rule
_SHARES = (fmpq(1, 2), fmpq(2))  # of the trivial solution's b, at the start: one on each side
_START = fmpq(1, 2)  # p there, as in the paper's figures


def side_part(subject: Subject) -> ReportPart:
    """Which sign of C_1 lifts off and which takes an impact, by the sign of Gamma(-beta).

    :raises ValueError: beta is, or may be, an integer and no rational number.
    """
    spot = subject.classified
    assert spot.beta is not None
    ends = beta_ends(spot.beta)
    result = side(*ends)
    known = spot.impact_sign is not None
    what = side_text(spot.lift_off_sign, spot.impact_sign) if known else "no side at leading order: β is an integer"
    about = "the paper's rule, at leading order as ε → 0"
    return ReportPart(
        "The sides, at leading order as ε → 0",
        Outcome.PROVED if known else None,
        f"{result}\nHere: {what} ({about}).",
        (shlex.join(["gspot-verified", "side", *map(str, ends)]),),
        data=result.to_json(),
    )


def expansion_part(subject: Subject) -> ReportPart:
    """The first terms of Theorem 1; below the order at which an integer beta stops them."""
    stop, order = subject.classified.obstructed_order, _order(subject)
    trajectory = _trajectory(subject, order)
    text = f"{trajectory}\n{_COEFFICIENTS}"
    if trajectory.pulls:
        text += "\nwarning: the mean force is negative: this trajectory would have to pull on the surface"
    if stop == order:
        text += f"\nno further: β is, or may be, an integer, and there is no unique term of order {stop}"
    reached = trajectory.accuracy is None or trajectory.accuracy.reached
    return ReportPart(
        "The distinguished trajectory",
        Outcome.PROVED if reached else Outcome.UNDECIDED,
        text,
        (
            subject.source.command("expand", "--order", str(order)),
            subject.source.command("expand", "--order", str(order), "--latex"),
        ),
        data={**trajectory.to_json(), "latex": trajectory.to_latex()},
    )


def _order(subject: Subject) -> int:
    """Of the expansion that is shown; at most that at which an integer beta stops it."""
    stop = subject.classified.obstructed_order
    return _ORDER if stop is None else max(1, min(_ORDER, stop))


def _trajectory(subject: Subject, order: int) -> Trajectory:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", AccuracyWarning)  # said by the part's outcome
        return expand(subject.mechanism, order)


def expansion_picture_part(subject: Subject) -> ReportPart:
    """What the truncated expansion leaves in the equations, under its proved bound."""
    order = _order(subject)
    drawn = expansion_picture(_trajectory(subject, order))
    command = subject.source.command("expand", "--order", str(order), "--picture", "expansion.svg")
    return ReportPart(drawn.title, None, drawn.caption, (command,), drawn)


def phase_plane_part(subject: Subject) -> ReportPart:
    """Runs of rigid slip next to the G-spot."""
    return _drawn_part(subject, phase_plane_picture(subject.mechanism))


def mechanism_picture_part(subject: Subject) -> ReportPart:
    """The mechanism at the G-spot, as its file draws it."""
    return _drawn_part(subject, mechanism_picture(subject.mechanism))


def _drawn_part(subject: Subject, drawn: Picture) -> ReportPart:
    words = ["gspot-verified", "plot", drawn.name, f"{drawn.name}.svg", "--mechanism", subject.source.file]
    words += [word for key, value in subject.source.settings.items() for word in ("--set", f"{key}={value}")]
    return ReportPart(drawn.title, None, drawn.caption, (shlex.join(words),), drawn)


def true_solutions_part(subject: Subject, c1: int, title: str, say: Callable[[str], None]) -> ReportPart:
    """Lift-off or impact of the true solutions next to the expansion, for every epsilon up to one.

    :raises ValueError: beta is no rational number above 1.
    """
    if not isinstance(subject.classified.beta, fmpq) or not subject.classified.beta > 1:
        raise ValueError("Theorem U2 of proofs/uniform.md needs a rational β > 1")
    trajectory = _trajectory(subject, _SIDE_ORDER)
    found: UniformSide | None = None
    for delta in _DELTAS:
        say(f"true solutions with C1 = {c1}, δ <= {delta}")
        found = uniform_side(trajectory, c1, delta)
        if found.side is not None:
            break
    assert found is not None
    return ReportPart(
        title,
        found.verdict.outcome,
        str(found),
        (subject.source.command("expand", "--order", str(_SIDE_ORDER), f"--side={c1},{found.delta}"),),
        data=found.to_json(),
    )


def exact_side_part(subject: Subject) -> ReportPart:
    """The sign of K for the compliant model with the alphas of the G-spot, from starts on both sides.

    :raises ValueError: the G-spot is not in Case III, or its alphas are no rational numbers.
    """
    spot = subject.classified
    alphas = (spot.alpha_1, spot.alpha_2, spot.alpha_3)
    if spot.case != "III" or not all(isinstance(alpha, fmpq) for alpha in alphas):
        raise ValueError("the exact side rule is asked in Case III, and where the alphas are rational")
    if not spot.regularisation.is_papers:
        raise ValueError("the exact side rule is that of the paper's compliance")
    first, second, third = alphas
    lines, commands, verdicts, data = [], [], [], []
    for epsilon in _EPSILONS:
        model = compliant_model(epsilon=epsilon, alpha_1=first, alpha_2=second, alpha_3=third)
        for share in _SHARES:
            b = -share * model.mean_force * _START
            flat = model.epsilon**2 * b / _START
            state = CompliantState(_START, b, 2 * flat, fmpq(0), flat)
            result = side_rule(model, state)
            given = ",".join(str(getattr(state, name)) for name in ("p", "b", "y", "v", "z"))
            lines.append(f"ε = {epsilon}, p = {_START}, b = {b} ({share} of the trivial solution's): {result}")
            words = ["side", "--beta", model.beta, "--eps", epsilon, f"--alpha1={first}", f"--alpha2={second}"]
            commands.append(shlex.join(["gspot-verified", *map(str, words), f"--state={given}"]))
            verdicts.append(result.verdict)
            data.append({"epsilon": epsilon, "state": given, **result.to_json()})
    return ReportPart(
        "The exact side rule of the compliant model with these α",
        outcome_of(verdicts),
        "\n".join([*lines, _MODEL]),
        tuple(commands),
        data=data,
    )
