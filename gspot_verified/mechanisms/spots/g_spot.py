"""Find a G-spot p = b = y = v = 0 of a mechanism: exactly at a rational point, otherwise by Newton and a proof.

The proof of existence and uniqueness in a small box is :func:`krawczyk.krawczyk`, page ``proofs/krawczyk.md``.
The m - 4 further unknowns are fixed by conditions J: given, or components of the state that keep their values.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.linear import inverse
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS, Ring
from gspot_verified.mechanisms.derive.mass_matrix import check_mass_matrix
from gspot_verified.mechanisms.derive.to_system import NotRationalError, Shifted, shift, stays, to_system
from gspot_verified.mechanisms.formulas.simplify import constant, product_of, rational_value, sum_of
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.zeros.newton import NotFoundError, newton_point, proved_box
from gspot_verified.numbers.balls import Exact, ball_text, checked_bits, exact, working_bits
from gspot_verified.numbers.evidence import every
from gspot_verified.numbers.short_text import short_text, table_text
from gspot_verified.numbers.verdict import Evidence

DEFAULT_BITS = 128  # working bits of the search and of its proof: more give a narrower box


class NotThereError(GSpotError):
    """The place that the mechanism names is no G-spot for these parameters. There may be some elsewhere, or none."""


@dataclass(frozen=True)
class GSpot:
    """A G-spot with what Theorem 1 needs there. In balls, work with ``system`` inside ``working_bits(bits)``.

    ``fixed`` names the components that the conditions J keep (empty when J was given as formulas); ``shown``: by it
    the box holds exactly one, and the mass matrix is positive definite there.
    """

    shifted: Shifted
    system: System
    exact: bool
    bits: int
    fixed: tuple[str, ...]
    shown: Evidence | None = field(default=None, compare=False, repr=False)

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism it belongs to."""
        return self.shifted.mechanism

    def to_json(self) -> dict[str, str]:
        """The components of the state as text; an angle as ``reference + deviation``."""
        references = {angle.coordinate: angle.name for angle in self.mechanism.angles}
        components = {}
        for word, value in zip(self.mechanism.state, self.system.point, strict=True):
            text = str(value) if self.exact else ball_text(value)
            if word in references:
                text = references[word] if text == "0" else f"{references[word]} + {text}"
            components[word] = text
        return components

    def in_short(self) -> dict[str, str]:
        """The same for a table: exact numbers where they are short, six digits elsewhere; all of them of what is fixed,
        which a statement names."""
        pairs = zip(self.mechanism.state, self.system.point, strict=True)
        return {
            word: (whole_component if word in self.fixed else short_component)(self.mechanism, word, value)
            for word, value in pairs
        }


def short_component(mechanism: Mechanism, word: str, value: Exact) -> str:
    """A component of the shifted state for a table; an angle with a reference as ``reference + deviation``."""
    return _counted_from(mechanism, word, table_text(value))


def whole_component(mechanism: Mechanism, word: str, value: Exact) -> str:
    """The same for a statement: no digit is cut off, what is not exact is a ball."""
    number = exact(value, word)
    return _counted_from(mechanism, word, short_text(number) if isinstance(number, fmpq) else ball_text(number))


def _counted_from(mechanism: Mechanism, word: str, text: str) -> str:
    reference = next((angle.name for angle in mechanism.angles if angle.coordinate == word), None)
    if reference is None:
        return text
    if text in ("0", "0.000000"):
        return reference
    return f"{reference} - {text[1:]}" if text.startswith("-") else f"{reference} + {text}"


def find_g_spot(mechanism: Mechanism, bits: int = DEFAULT_BITS) -> GSpot:
    """The G-spot at the place that the mechanism names, or the one that Newton's method finds from it.

    Exact when the place is rational and everything there is; otherwise a box that holds exactly one G-spot (with the
    conditions J), with a proof.

    :raises ValueError: ``bits`` is no int, or below 2.
    :raises NotThereError: the place is no G-spot.
    :raises GSpotError: the conditions are degenerate, or nothing could be proved.
    :raises MechanismError: the mechanism is not complete.

    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> spot = find_g_spot(shipped_mechanism("frictional impact oscillator"))
    >>> spot.exact, spot.to_json()["psi"], spot.to_json()["phi"]
    (True, '-2/5', 'phi_ref')
    """
    bits = checked_bits(bits, 2)
    shifted = shift(mechanism)
    missing = [word for word in mechanism.state if word not in dict(mechanism.place.values)]
    if missing:
        raise GSpotError(
            f"{mechanism.name}: the G-spot's place lacks a value for {', '.join(missing)} "
            "(classify_all, or classify --all, finds all G-spots without a place)"
        )
    if len(mechanism.state) < 4:
        raise GSpotError(f"{mechanism.name}: p, b, y and v need a state of 4 components at least")
    if not mechanism.place.search:
        try:
            return _exact(shifted, bits)
        except NotRationalError:
            pass
        except (GSpotError, MechanismError):
            raise
        except ValueError:  # a sine, exponential or root that is not rational; what balls cannot do either they refuse
            pass
    with working_bits(bits + 40):
        return _proved(shifted, bits + 40)


def _exact(shifted: Shifted, bits: int) -> GSpot:
    values = {}
    for word, value in symbolic_place(shifted).items():
        number = rational_value(value)
        if number is None:
            raise NotRationalError(f"{shifted.mechanism.name}: {word} is not rational")
        values[word] = number
    check_mass_matrix(shifted, values, RATIONALS)
    system, fixed = with_conditions(shifted, values, RATIONALS)
    _check_conditions(system)
    _check_regular(system)
    # Raises where one of the numbers is not rational: the expansion and the classification need them all.
    f = shifted.functions
    contact = shifted.expressions([f.u, f.a, f.A, f.B, f.C], RATIONALS)
    system.values_at_point([*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3, *contact])
    return GSpot(shifted, system, True, bits, fixed)


def symbolic_place(shifted: Shifted) -> dict[str, Expression]:
    """The components that the place gives, with the parameters put in; angles counted from their references."""
    mechanism = shifted.mechanism
    minus = {angle.coordinate: product_of(constant(-1), Symbol(angle.name)) for angle in mechanism.angles}
    given = dict(mechanism.place.values)
    words = [word for word in mechanism.state if word in given]
    deviations = [sum_of(given[word], minus[word]) if word in minus else given[word] for word in words]
    return dict(zip(words, shifted.prepare(deviations), strict=True))


def _check_g_spot(system: System) -> None:
    for name, value in zip("pbyv", system.values_at_point((system.p, system.b, system.y, system.v)), strict=True):
        if value != 0:
            raise NotThereError(
                f"{system.name}: not a G-spot: {name} = {value} must be 0 at the place given, with these parameters "
                "(classify_all, or classify --all, finds all G-spots, or proves that there is none)"
            )


def _check_conditions(system: System) -> None:
    _check_g_spot(system)
    for i, value in enumerate(system.values_at_point(system.J)):
        if value != 0:
            raise GSpotError(f"{system.name}: the condition J_{i + 1} = {value} must be 0 at the G-spot")


def _check_regular(system: System) -> None:
    try:
        inverse(system.jacobian(), system.ring)
    except ZeroDivisionError:
        raise GSpotError(degenerate(system.name, "with the given conditions J")) from None


def degenerate(name: str, detail: str) -> str:
    """The message for a singular Jacobian."""
    return (
        f"{name}: degenerate: the Jacobian [p_xi, b_xi, y_xi, v_xi, J_xi] at the G-spot must be regular "
        f"(eq. genSysGSpotNonSing), it is singular or not certainly regular {detail}"
    )


def with_conditions(shifted: Shifted, values: Mapping[str, Any], ring: Ring) -> tuple[System, tuple[str, ...]]:
    """The system with the conditions J: constraints and their rates, and what the mechanism gives or what is chosen."""
    mechanism = shifted.mechanism
    place, state = mechanism.place, mechanism.state
    constraints = len(shifted.constraints)
    wanted = len(state) - 4 - constraints
    if wanted < 0:
        raise GSpotError(f"{mechanism.name}: the constraints leave no room for the conditions p = b = y = v = 0")
    if place.conditions is not None:
        if len(place.conditions) != wanted:
            raise GSpotError(f"{mechanism.name}: {wanted} conditions J are needed, got {len(place.conditions)}")
        return to_system(shifted, values, ring, shifted_conditions(shifted)), ()
    open_conditions = [stays(i, ring.number(0), ring) for i in range(wanted)]
    draft = to_system(shifted, values, ring, [*shifted_conditions(shifted), *open_conditions])
    if ring is RATIONALS:
        _check_g_spot(draft)
    if place.fixed is not None:
        fixed = place.fixed
        if len(set(fixed)) != wanted or len(fixed) != wanted:
            raise GSpotError(f"{mechanism.name}: {wanted} components must be fixed, got {list(fixed)}")
    else:
        fixed = _choose_fixed(draft, state, 4 + constraints)
    J = draft.J[:constraints] + tuple(stays(state.index(word), values[word], ring) for word in fixed)
    return System(**{**vars(draft), "J": J}), fixed


def shifted_conditions(shifted: Shifted) -> list[Expression]:
    """The conditions J that are functions, with parameters put in and angles shifted.

    The constraints of the mechanism and their rates come first, then the conditions that it gives as formulas.
    """
    return [*shifted.constraints, *shifted.prepare(shifted.mechanism.place.conditions or ())]


def _choose_fixed(draft: System, state: Sequence[str], count: int) -> tuple[str, ...]:
    """The components without a pivot when the first ``count`` conditions are eliminated.

    These are p, b, y, v and the constraints; with the components fixed the Jacobian is regular.
    """
    ring = draft.ring
    rows = [list(row) for row in draft.jacobian()[:count]]
    free = []
    done = 0
    for j in range(len(state)):
        pivot = next((i for i in range(done, count) if ring.is_nonzero(rows[i][j])), None)
        if pivot is None:
            free.append(state[j])
            continue
        rows[done], rows[pivot] = rows[pivot], rows[done]
        for i in range(done + 1, count):
            factor = rows[i][j] / rows[done][j]
            rows[i] = [value - factor * own for value, own in zip(rows[i], rows[done], strict=True)]
        done += 1
    if done < count:
        names = "p, b, y, v" if count == 4 else "p, b, y, v and the constraints"
        raise GSpotError(degenerate(draft.name, f"for every choice of J: {names} have rank {done} there, not {count}"))
    return tuple(free)


def place_in(shifted: Shifted, ring: Ring) -> dict[str, Any]:
    """The components that the place gives, as numbers of the ring."""
    place = symbolic_place(shifted)
    expressions = shifted.expressions(list(place.values()), ring)
    series = SeriesOfFunctions(expressions, NumberTerms(ring), ring)
    series.extend([ring.number(0)] * len(shifted.mechanism.state))
    return dict(zip(place, (series[expression][0] for expression in expressions), strict=True))


def _proved(shifted: Shifted, bits: int) -> GSpot:
    """Newton's method from the place, then a box around its limit that holds exactly one zero."""
    name = shifted.mechanism.name
    try:
        start = place_in(shifted, BALLS)
    except (GSpotError, MechanismError):
        raise
    except ValueError as error:
        raise GSpotError(f"{name}: no G-spot found: {error}") from None
    spot = prove_near(shifted, start, bits)
    if not shifted.mechanism.place.search:
        for word, enclosure, given in zip(shifted.mechanism.state, spot.system.point, start.values(), strict=True):
            if not enclosure.overlaps(given):
                raise NotThereError(
                    f"{name}: not a G-spot: {word} = {ball_text(given)}, the nearest has {ball_text(enclosure)}"
                )
    return spot


def prove_near(shifted: Shifted, start: Mapping[str, arb], bits: int) -> GSpot:
    """A box around the limit of Newton's method from here, with a proof that it holds exactly one G-spot.

    Exactly one with the conditions J: given, or components that keep their values at the start.

    :raises GSpotError: no convergence, degenerate conditions, or nothing could be proved.
    :raises MechanismError: the mass matrix is not positive definite there.
    """
    name = shifted.mechanism.name
    try:
        if not all(value.is_finite() for value in start.values()):
            raise GSpotError(f"{name}: the G-spot's place is not finite")
        system, fixed = with_conditions(shifted, start, BALLS)
        program = BoxProgram(system.conditions, len(system.point))
        point = newton_point(system, program)
    except ZeroDivisionError:
        raise GSpotError(degenerate(name, "during the search")) from None
    except (GSpotError, MechanismError):
        raise
    except ValueError as error:
        raise GSpotError(f"{name}: no G-spot found: {error}") from None
    proved = proved_box(program, point)
    if proved is None:
        raise NotFoundError(f"{name}: no G-spot could be proved near {[ball_text(value, 6) for value in point]}")
    box, inclusion = proved
    definite = check_mass_matrix(shifted, dict(zip(shifted.mechanism.state, box, strict=True)), BALLS)
    shown = every([inclusion, definite])
    return GSpot(shifted, System(**{**vars(system), "point": tuple(box)}), False, bits, fixed, shown)
