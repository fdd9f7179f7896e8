"""The state from which slip is followed: the user's free components, the two others from y = 0 and v = 0.

Proof page: ``proofs/krawczyk.md`` (existence of the components that are solved for).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, reduce

from flint import arb, arb_mat

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.krawczyk import krawczyk
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.shared_derivation import given_numbers
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.simplify import constant
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, Place, exact_rational
from gspot_verified.mechanisms.spots.g_spot import place_in
from gspot_verified.mechanisms.spots.spot_conditions import take_apart
from gspot_verified.numbers.balls import ExactInput, add_remainder, ball_text, current_bits, sign_of

_KEPT = 8  # mechanisms and precisions whose programs are kept
_NEWTON_STEPS = 40  # a limit of effort
_INFLATIONS = 8  # tries, each 32 times as wide: any number is correct, Krawczyk's test decides

StateInput = Mapping[str, ExactInput]
"""A number, or a formula of parameters and reference angles such as "phi_ref + 1/10", for components of the state."""


class StateError(MechanismError):
    """The state is not one from which positive slip in contact can be followed; the message says why."""


@dataclass(frozen=True, slots=True)
class SlipState:
    """A box of the state (angles from their references) in which the state on the contact lies, and what was solved.

    ``supposed`` names what is 0 on the contact and was not shown to be 0 in the state that was given: its ball holds 0.
    """

    box: tuple[arb, ...]
    solved: tuple[str, ...]
    supposed: tuple[str, ...] = ()


def slip_state(shifted: Shifted, state: StateInput, beside_place: bool = False) -> SlipState:
    """The state with y = v = 0, at the precision in force.

    All components may be given, or all but two, which are then solved for. With ``beside_place`` more may be left out:
    but for two in which y and v are linear they have the values of the mechanism's place.

    :raises StateError: names that are none, too few components, a state that is not on the contact, or no certain
        solution of y = v = 0.
    """
    mechanism = shifted.mechanism
    if not isinstance(state, Mapping) or not all(isinstance(word, str) for word in state):
        raise StateError(f"{mechanism.name}: the state must give values by the names {', '.join(mechanism.state)}")
    unknown = [word for word in state if word not in mechanism.state]
    if unknown:
        raise StateError(
            f"{mechanism.name}: {unknown[0][:40]!r} is no component of the state; it has: {', '.join(mechanism.state)}"
        )
    left_out = [word for word in mechanism.state if word not in state]
    missing = _linear(shifted, left_out) if beside_place and len(left_out) > 2 else left_out
    if len(missing) not in (0, 2):
        raise StateError(
            f"{mechanism.name}: give all components of the state, or all but the two that y = 0 and v = 0 determine; "
            f"missing: {', '.join(left_out)}"
        )
    if beside_place and not left_out:
        raise StateError(f"{mechanism.name}: the state gives all components: nothing of the G-spot is left to be used")
    box = placed_components(shifted, state, left_out)
    program = _contact(shifted.shared or shifted, current_bits()).at(given_numbers(shifted))
    if missing:
        solution = _solved(mechanism, program, box, missing)
        return SlipState(solution, tuple(missing), _supposed_constraints(shifted, solution))
    constraints = _supposed_constraints(shifted, box)
    y, v = program.values(box)
    for name, value in (("y", y), ("v", v)):
        if not value.contains(0) or not value.is_finite():
            raise StateError(
                f"{mechanism.name}: the state is not on the contact: {name} = {ball_text(value)} must be 0; "
                "leave out two components that y = 0 and v = 0 determine"
            )
    supposed = tuple(name for name, value in (("y", y), ("v", v)) if _perhaps_not_zero(value))
    return SlipState(tuple(box), (), (*supposed, *constraints))


def _linear(shifted: Shifted, left_out: Sequence[str]) -> list[str]:
    """Two of these components, one for each of y and v, which hold them with constant factors; or all of them."""
    mechanism, functions = shifted.mechanism, shifted.functions
    y, v = shifted.expressions([functions.y, functions.v], BALLS)
    given = [i for i, word in enumerate(mechanism.state) if word not in left_out]
    explicit = {each.index for each in take_apart({"y": y, "v": v}, len(mechanism.state), given).explicit}
    solved = [word for i, word in enumerate(mechanism.state) if i in explicit and word in left_out]
    return solved if len(solved) == 2 else list(left_out)


def _supposed_constraints(shifted: Shifted, box: Sequence[arb]) -> tuple[str, ...]:
    """The constraints that hold perhaps; one that fails is an error: such a state is none of the mechanism's, though
    the equations of motion hold there."""
    if not shifted.constraints:
        return ()
    supposed: list[str] = []
    program = _constraints(shifted, current_bits())
    for i, value in enumerate(program.values(list(box))):
        count = len(shifted.constraints) // 2
        what = f"constraint {i + 1}" if i < count else f"the rate of constraint {i + 1 - count}"
        if not value.contains(0) or not value.is_finite():
            raise StateError(f"{shifted.mechanism.name}: {what} must be 0 in the state, it is {ball_text(value)}")
        if _perhaps_not_zero(value):
            supposed.append(what)
    return tuple(supposed)


@lru_cache(_KEPT)
def _contact(shifted: Shifted, bits: int) -> BoxProgram:  # noqa: ARG001
    """y and v; constants that are balls have the precision in force."""
    functions = shifted.functions
    return BoxProgram(shifted.expressions([functions.y, functions.v], BALLS), len(functions.F))


@lru_cache(_KEPT)
def _constraints(shifted: Shifted, bits: int) -> BoxProgram:  # noqa: ARG001
    """The constraints and their rates, likewise."""
    return BoxProgram(shifted.expressions(shifted.constraints, BALLS), len(shifted.functions.F))


def _perhaps_not_zero(value: arb) -> bool:
    """Whether the ball is more than the exact 0."""
    return sign_of(value) != 0


def placed_components(shifted: Shifted, state: StateInput, missing: Sequence[str]) -> list[arb]:
    """The given components; the missing ones at the place of the G-spot, or 0.

    :raises StateError: a value is no formula, or not finite.
    """
    mechanism = shifted.mechanism
    start = dict(mechanism.place.values)
    values = {word: state_formula(mechanism, word, state[word]) for word in state}
    values |= {word: start.get(word, constant(0)) for word in missing}
    placed = replace(mechanism, place=Place(tuple(values.items())))
    try:
        components = place_in(replace(shifted, mechanism=placed), BALLS)
    except ValueError as error:
        raise StateError(f"{mechanism.name}: {error}") from None
    for word, value in components.items():
        if not value.is_finite():
            raise StateError(f"{mechanism.name}: {word} is not finite")
    return [components[word] for word in mechanism.state]


def state_formula(mechanism: Mechanism, word: str, value: ExactInput) -> Expression:
    """A value of a component as a formula of the parameters and the reference angles.

    :raises StateError: it is none.
    """
    words = [*(name for name, _ in mechanism.parameters), *(angle.name for angle in mechanism.angles)]
    try:
        try:
            return constant(exact_rational(value, word))
        except MechanismError:
            if not isinstance(value, str):
                raise
        return parse_formula(value, {name: Symbol(name) for name in words})
    except (TypeError, ValueError, ZeroDivisionError) as error:
        raise StateError(f"{mechanism.name}: {word}: {str(error).removeprefix(f'{word}: ')}") from None


def _solved(mechanism: Mechanism, program: BoxProgram, box: list[arb], missing: Sequence[str]) -> tuple[arb, ...]:
    places = [mechanism.state.index(word) for word in missing]
    solution = solved_components(program, box, places)
    if solution is None:
        raise StateError(
            f"{mechanism.name}: y = 0 and v = 0 do not certainly determine {missing[0]} and {missing[1]} there; "
            "leave out two other components"
        )
    return solution


def solved_components(program: BoxProgram, box: Sequence[arb], places: Sequence[int]) -> tuple[arb, ...] | None:
    """The box with enclosures of a zero of the functions in these components: Newton's method from where they are, then
    Krawczyk's proof of a zero next to it. None: there is none for certain.

    The functions are as many as the components; the others are what the box says.
    """

    def put(found: Sequence[arb]) -> list[arb]:
        full = list(box)
        for place, value in zip(places, found, strict=True):
            full[place] = value
        return full

    def values(found: list[arb]) -> list[arb]:
        return program.values(put(found))

    def rows(found: list[arb]) -> list[list[arb]]:
        return [[row[place] for place in places] for row in program.gradients(put(found))[1]]

    found = [box[place].mid() for place in places]
    for _ in range(_NEWTON_STEPS):
        try:
            move = arb_mat(rows(found)).solve(arb_mat([[value] for value in values(found)])).entries()
        except ZeroDivisionError:
            return None
        found = [(old - change).mid() for old, change in zip(found, move, strict=True)]
        if not all(value.is_finite() for value in found):
            return None
        small = arb(2) ** (8 - current_bits())
        if all(abs(change.mid()) <= small * (1 + abs(value)) for change, value in zip(move, found, strict=True)):
            break
    width = reduce(arb.max, (side.rad() for side in box), arb(0))
    radius = 16 * width + arb(2) ** (16 - current_bits())
    for _ in range(_INFLATIONS):
        solution = krawczyk(values, rows, [add_remainder(value, radius * (1 + abs(value))) for value in found])
        if solution is not None:
            return tuple(put(solution))
        radius = radius * 32
    return None
