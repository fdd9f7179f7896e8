"""A mechanism in a scene: its equations in the scaled variables, y and v in the places of two of its components.

dxi/dt = F + G_T lambda_T + G_N lambda_N and dv/dt = b + B lambda_T + C lambda_N (paper, Sec. 2). With y = epsilon^2 Y,
v = epsilon V and T = t/epsilon: Y' = V, V' = dv/dt, xi' = epsilon dxi/dt. Of xi those components are kept on which
dv/dt (and u, x where an effect sees them), friction and masses depend; the others are cyclic. A component with a
constant rate, as the time, is known and not integrated.

Where y is linear in a coordinate and v in a velocity, y and v take their places. Elsewhere (an arm on a fixed base, a
mechanism with constraints) y and v stand beside all components of xi: dy/dt = v and dv/dt = b + B lambda_T + C lambda_N
hold along every motion, so y(xi) - epsilon^2 Y and v(xi) - epsilon V keep the value 0 that they have at the start, and
constraints and their rates theirs. No chart can end, and nothing small is computed as a difference. The components that
the start leaves out are enclosed as the zero of these functions next to the mechanism's place.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import ZERO, partial_derivative, substitute
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.mechanisms.approach.slip_state import placed_components, solved_components, state_formula
from gspot_verified.mechanisms.derive.mass_matrix import check_mass_matrix
from gspot_verified.mechanisms.derive.slip_speed import at_slip_speed, depends_on_slip_speed
from gspot_verified.mechanisms.derive.to_system import NotRationalError, Shifted, shift
from gspot_verified.mechanisms.foreign.names import SCENE_END, SCENE_FUNCTIONS, SCENE_NAMES
from gspot_verified.mechanisms.formulas.rewriting import replaced, simplified
from gspot_verified.mechanisms.formulas.simplify import constant, minus, negative, product_of, rational_value, sum_of
from gspot_verified.mechanisms.formulas.symbol import variable_indices
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, Place
from gspot_verified.mechanisms.spots.g_spot import place_in
from gspot_verified.numbers.balls import current_bits, sign_of, working_bits
from gspot_verified.scenes.effects.catalogue import EXCLUSIONS
from gspot_verified.scenes.equations.mechanism_terms import Functions, MechanismTerms
from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.equations.terms import PHASES, REVERSE, SLIP, Terms


@dataclass(frozen=True)
class NormalCoordinate:
    """y = ``slope`` xi_i + rest with a rational number ``slope``, and v = ``rate_slope`` xi_j + rest, i = ``place``,
    j = ``velocity``; y does not depend on xi_j."""

    place: int
    velocity: int
    slope: fmpq
    rate_slope: fmpq
    y: Expression
    v: Expression

    @classmethod
    def of(cls, y: Expression, v: Expression, size: int) -> NormalCoordinate | None:
        """The first pair of components with which this works; None: the contact has no free translation along its
        normal."""
        slopes = [(i, slope) for i in range(size) if (slope := free_slope(y, i, size)) is not None]
        rates = [(j, slope) for j in range(size) if (slope := free_slope(v, j, size)) is not None]
        used = variable_indices([y])
        pair = next(((i, j) for i in slopes for j in rates if i[0] != j[0] and j[0] not in used), None)
        if pair is None:
            return None
        (i, slope), (j, rate_slope) = pair
        return cls(i, j, slope, rate_slope, y, v)

    def solved(self, y: Expression, v: Expression) -> dict[Expression, Expression]:
        """The two components as functions of the others, of ``y`` and of ``v``."""
        place, velocity = Variable(self.place), Variable(self.velocity)
        (rest,) = replaced([self.y], {place: ZERO})
        first = product_of(constant(1 / self.slope), minus(y, rest))
        (rate_rest,) = replaced([self.v], {place: first, velocity: ZERO})
        return {place: first, velocity: product_of(constant(1 / self.rate_slope), minus(v, rate_rest))}


def free_slope(function: Expression, index: int, size: int) -> fmpq | None:
    """The derivative, where it is a rational number other than 0."""
    (slope,) = simplified(partial_derivative(function, index, size))
    value = rational_value(slope)
    return None if value is None or value == 0 else value


def _belt(values: Mapping[str, fmpq]) -> Expression:
    return constant(values.get("belt_velocity", fmpq(0)))


_BITS = 160  # for signs and texts at the start
_SCALED = ("Y", "V", "Z")
_FIELDS = ("F", "G", "G_T", "G_N")
_SCALARS = ("a", "b", "A", "B", "C", "p", "mu", "u")


class MechanismMotion:
    """``sees``: which of u and x effects need; ``start``: values or formulas of components, and y, v, z.

    ``kept``: the components that are integrated. ``sees_slip_speed``: whether friction depends on the slip speed;
    then p and mu are those of slip in the phase's direction, with mu(0) in stick and in flight.

    :raises SceneError: the mechanism gives no x where one is needed, or has names that clash.
    :raises MechanismError: the mechanism is not complete.
    """

    is_model = False

    def __init__(
        self, mechanism: Mechanism, sees: Sequence[str], epsilon: fmpq, start: Mapping[str, fmpq | str]
    ) -> None:
        self.mechanism, self._epsilon, self._start = mechanism, epsilon, dict(start)
        if "x" in sees and mechanism.x is None:
            raise SceneError(f"{mechanism.name}: effect 'tangential_place' needs x; it gives a slip velocity")
        self._shifted = shift(mechanism, slip_speed=True)
        self._check_functions()
        self.sees_slip_speed = depends_on_slip_speed(mechanism, self._shifted.functions)
        r = mechanism.regularisation
        self.parameters: Mapping[str, fmpq] = {"k_1": r.k_1, "k_2": r.k_2, "damping": r.c}
        self._sees = tuple(sees)
        self._size = len(mechanism.state)
        f = self._shifted.functions
        constrained = isinstance(mechanism.motion, Lagrangian) and mechanism.motion.constraints
        self._normal = None if constrained else NormalCoordinate.of(f.y, f.v, self._size)
        self._solved: dict[int, list[arb]] = {}
        followed = self._unknown if self._normal is None else (self._normal.place, self._normal.velocity)
        self._known = {
            i: rate
            for i, row in enumerate(zip(f.F, f.G_T, f.G_N, strict=True))
            if (rate := rational_value(row[0])) is not None and row[1] is ZERO and row[2] is ZERO
            and i not in followed
        }  # fmt: skip
        self._functions = self._substituted()
        self.kept = tuple(mechanism.state[i] for i in self._needed())
        self._check_names()

    @property
    def _unknown(self) -> tuple[int, ...]:
        """The components that the start leaves out, where y and v stand beside all of them."""
        motion, state = self.mechanism.motion, self.mechanism.state
        time = motion.time if isinstance(motion, Lagrangian) else None
        return tuple(i for i, name in enumerate(state) if name not in self._start and name != time)

    def _check_functions(self) -> None:
        """A component must not have the name of something else in a scene; p may be p itself. Before the start is read:
        its y, v, z are those of the contact."""
        state, f = self.mechanism.state, self._shifted.functions
        own = {name: getattr(f, name) for name in SCENE_FUNCTIONS}
        clash = [name for name in own if name in state and own[name] is not Variable(state.index(name))]
        self._refuse([*clash, *(name for name in ("z",) if name in state)])

    def _check_names(self) -> None:
        clash = [name for name in SCENE_NAMES if name in self.kept]
        self._refuse([*clash, *(name for name in self.kept if name.endswith(SCENE_END))])

    def _refuse(self, clash: Sequence[str]) -> None:
        if clash:
            raise SceneError(f"{self.mechanism.name}: scenes use the name {clash[0]!r}; give this component another")

    def _substituted(self) -> dict[str, Expression]:
        """All functions with Variable(m) for Y, m + 1 for V, m + 2 for Z and m + 3 for the clock."""
        m, small, f = self._size, self._epsilon, self._shifted.functions
        y, v = product_of(constant(small**2), Variable(m)), product_of(constant(small), Variable(m + 1))
        named = {name: getattr(f, name) for name in (*_SCALARS, "x")}
        named |= {f"{name} {i}": part for name in _FIELDS for i, part in enumerate(getattr(f, name))}
        named |= {f"M {i} {j}": entry for i, row in enumerate(f.inertia) for j, entry in enumerate(row)}
        named = {name: function for name, function in named.items() if function is not None}
        replacing = {} if self._normal is None else self._normal.solved(y, v)
        roots = replaced(list(named.values()), replacing)
        used = variable_indices(roots)
        known: dict[Expression, Expression] = {
            Variable(i): sum_of(constant(self._component(i)), product_of(constant(rate * small), Variable(m + 3)))
            for i, rate in self._known.items()
            if i in used
        }
        return dict(zip(named, replaced(roots, known), strict=True))

    @property
    def _inertia(self) -> list[str]:
        """The names of the entries of what must be positive definite, row by row."""
        size = range(len(self._shifted.functions.inertia))
        return [f"M {i} {j}" for i in size for j in size]

    def _needed(self) -> list[int]:
        """The components on which depends what is seen, or supposed, and those on which their rates depend."""
        seen = ["b", "p", "mu", *self._inertia, *self._sees, *(("a", "A", "B", "C") if "u" in self._sees else ())]
        seen += ["u"] if self.sees_slip_speed else []
        waiting = variable_indices(self._functions[name] for name in seen)
        needed: set[int] = set()
        while waiting:
            i = waiting.pop()
            if i < self._size and i not in needed:
                needed.add(i)
                waiting |= variable_indices(
                    self._functions[name] for name in (*(f"{part} {i}" for part in _FIELDS), "mu")
                )
        return sorted(needed)

    @property
    def depends_on_place(self) -> bool:
        """False where x has a constant slope, not 0, in a component on which no function of the mechanism depends: then
        a translation of it changes x and no equation."""
        x = self._shifted.functions.x
        if x is None:
            return True
        used = variable_indices(function for name, function in self._functions.items() if name != "x")
        normal, f = self._normal, self._shifted.functions
        heights = variable_indices([f.y, f.v, *self._shifted.constraints])
        bound = {*used, *self._known, *(heights if normal is None else (normal.place, normal.velocity))}
        return not any(free_slope(x, i, self._size) for i in range(self._size) if i not in bound)

    def states(self, phase: str) -> tuple[str, ...]:
        """The components that are kept: the same in all phases."""
        if phase not in PHASES:
            raise ValueError(f"phase: expected one of {', '.join(PHASES)}, got {phase!r}")
        return self.kept

    def terms(self, phase: str, states: tuple[str, ...], values: Mapping[str, fmpq]) -> MechanismTerms:
        """The functions of one phase; constants that are balls have the precision in force."""
        m, kept = self._size, self._needed()
        where = {m + k: states.index(name) for k, name in enumerate(_SCALED)}
        where |= {i: states.index(self.mechanism.state[i]) for i in kept} | {m + 3: len(states)}
        variables: list[Expression] = [Variable(where.get(i, 0)) for i in range(m + 4)]
        wanted = [*_SCALARS[:-1], *self._inertia, *self._sees, *(f"{part} {i}" for part in _FIELDS for i in kept)]
        numbered = [substitute(self._functions[name], variables) for name in wanted]
        if self.sees_slip_speed:
            slip = minus(substitute(self._functions["u"], variables), _belt(values))
            speed = {SLIP: slip, REVERSE: negative(slip)}.get(phase, ZERO)
            numbered = self._at_speed(numbered, speed)
        try:
            made = self._shifted.expressions(numbered, RATIONALS)
        except NotRationalError:
            made = self._shifted.expressions(numbered, BALLS)
        expressions = dict(zip(wanted, made, strict=True))
        F, G, G_T, G_N = (tuple(expressions[f"{part} {i}"] for i in kept) for part in _FIELDS)
        scalars = (expressions.get(name, ZERO) for name in (*_SCALARS, "x"))
        masses = [expressions[name] for name in self._inertia] if self._shifted.functions.mass_matrix else []
        functions = Functions(F, G, G_T, G_N, *scalars)
        known = {*kept, *range(m, m + 4)}
        sees_A = known.issuperset(variable_indices([self._functions["A"]]))
        return MechanismTerms(phase, states, self._epsilon, values, functions, masses, sees_A)

    def _at_speed(self, functions: Sequence[Expression], speed: Expression) -> list[Expression]:
        try:
            return at_slip_speed(functions, speed)
        except ZeroDivisionError:
            raise SceneError(f"{self.mechanism.name}: the friction coefficient has no value at slip speed 0") from None

    def rates(self, terms: Terms) -> dict[str, Expression]:
        """epsilon dxi/dt for each kept component."""
        assert isinstance(terms, MechanismTerms)
        return dict(zip(self.kept, terms.own_rates(), strict=True))

    def shown(self, terms: Terms) -> dict[str, Expression]:
        """p and b, u and x where an effect sees them, and the kept components."""
        assert isinstance(terms, MechanismTerms)
        shown = {name: getattr(terms.functions, name) for name in ("p", "b", *self._sees)}
        references = {angle.coordinate: f"{angle.coordinate} - {angle.name}" for angle in self.mechanism.angles}
        return shown | {references.get(name, name): terms.state(name) for name in self.kept if name not in shown}

    @cached_property
    def _given(self) -> dict[str, fmpq]:
        """The components that the scene gives, exactly, and y, v, z."""
        mechanism = self.mechanism
        pair = () if self._normal is None else ((self._normal.place, "y"), (self._normal.velocity, "v"))
        solved = {mechanism.state[i]: word for i, word in pair}
        given: dict[str, fmpq] = {}
        components = {}
        for name, value in self._start.items():
            if name in ("y", "v", "z"):
                given[name] = rational(value, f"start: {name}")
            elif name in solved:
                raise SceneError(f"start: {name} follows from {solved[name]} in this scene: give {solved[name]}")
            elif name == "nu":
                raise SceneError(f"start: nu and a mechanism exclude each other: {EXCLUSIONS['mechanism', 'nu']}")
            elif name not in mechanism.state:
                names = [word for word in mechanism.state if word not in solved]
                raise SceneError(f"start: this scene has no state {name[:40]!r}; give {', '.join(names)}, y, v, z")
            else:
                components[name] = state_formula(mechanism, name, value)
        missing = [name for name in "yvz" if name not in given]
        if len(missing) not in (0, 3):
            raise SceneError(f"start: the state {missing[0]} is missing; give y, v and z, or none of them")
        placed = replace(mechanism, place=Place(tuple(components.items())))
        try:
            values = place_in(replace(self._shifted, mechanism=placed), RATIONALS)
        except (NotRationalError, ValueError) as error:
            raise SceneError(f"start: every component must be a rational number, an angle with a reference counted "
                             f"from it: {error}") from None  # fmt: skip
        return {**dict.fromkeys("yvz", fmpq(0)), **given, **values}

    def _component(self, i: int) -> fmpq:
        name, motion = self.mechanism.state[i], self.mechanism.motion
        if name not in self._given and isinstance(motion, Lagrangian) and name == motion.time:
            return fmpq(0)
        if name not in self._given:
            raise SceneError(f"start: the state {name} is missing")
        return self._given[name]

    def start(self, values: Mapping[str, fmpq]) -> dict[str, fmpq]:
        """The kept components and y, v, z, exactly; y = v = z = 0, just in contact, where these are not given."""
        if not values:
            raise ValueError("values: expected the constants of the scene, got none")
        names = [name for name in self.kept if name not in self._left_out]
        return {name: self._component(self.mechanism.state.index(name)) for name in names} | {
            name: self._given[name] for name in "yvz"
        }

    @property
    def _left_out(self) -> tuple[str, ...]:
        return () if self._normal is not None else tuple(self.mechanism.state[i] for i in self._unknown)

    def enclosed_start(self) -> dict[str, arb]:
        """Those kept components that y, v and the constraints determine: enclosures, with the precision in force.

        :raises SceneError: too many are given, or too few, or they are not certainly determined.
        """
        if self._normal is not None:
            return {}
        state, names = self._whole_state(), self._left_out
        return {name: state[self.mechanism.state.index(name)] for name in self.kept if name in names}

    def _whole_state(self) -> list[arb]:
        """All components, where y and v stand beside them."""
        bits = max(current_bits(), _BITS)
        if bits in self._solved:
            return self._solved[bits]
        mechanism, f, names, at = self.mechanism, self._shifted.functions, self._left_out, self._given
        count = 2 + len(self._shifted.constraints)
        what = "y and v" if count == 2 else "y, v and the constraints"
        if len(names) != count:
            raise SceneError(
                f"start: {what} determine {count} components of {', '.join(mechanism.state)}: give all others; "
                f"left out: {', '.join(names) or 'none'}"
            )
        with working_bits(bits):
            height, rate = (minus(g, constant(at[n])) for g, n in ((f.y, "y"), (f.v, "v")))
            functions = self._shifted.expressions([height, rate, *self._shifted.constraints], BALLS)
            given = {n: self._start.get(n, 0) for n in mechanism.state if n not in names}
            box = placed_components(self._shifted, given, names)
            found = solved_components(BoxProgram(functions, self._size), box, self._unknown)
        if found is None:
            raise SceneError(f"start: {what} do not certainly determine {', '.join(names)} near the mechanism's place")
        self._solved[bits] = list(found)
        return self._solved[bits]

    def check(self, values: Mapping[str, fmpq]) -> None:
        """The mass matrix at the start.

        :raises MechanismError: it is not certainly positive definite.
        """
        with working_bits(_BITS):
            place = dict(zip(self.mechanism.state, self.whole_state(values), strict=True))
            check_mass_matrix(self._at_start_of_slip(values), place, BALLS, "at the start")

    def normal_acceleration(self, values: Mapping[str, fmpq]) -> arb:
        """b, in a ball."""
        return self._at_start("b", values)

    def painleve_parameter(self, values: Mapping[str, fmpq]) -> arb:
        """p, in a ball."""
        return self._at_start("p", values)

    def slip_velocity(self, values: Mapping[str, fmpq]) -> arb:
        """u, in a ball."""
        return self._at_start("u", values)

    def _at_start(self, name: str, values: Mapping[str, fmpq]) -> arb:
        with working_bits(_BITS):
            shifted = self._at_start_of_slip(values)
            (function,) = shifted.expressions([getattr(shifted.functions, name)], BALLS)
            return BoxProgram([function], self._size).values(self.whole_state(values))[0]

    def _at_start_of_slip(self, values: Mapping[str, fmpq]) -> Shifted:
        """The functions with the slip speed of the start in them: u less the velocity of the surface, or minus that."""
        shifted = self._shifted
        if not self.sees_slip_speed:
            return shifted
        slip = minus(shifted.functions.u, _belt(values))
        (function,) = shifted.expressions([slip], BALLS)
        sign = sign_of(BoxProgram([function], self._size).values(self.whole_state(values))[0])
        speed = ZERO if sign == 0 else negative(slip) if sign == -1 else slip
        mu, p = self._at_speed([shifted.functions.mu, shifted.functions.p], speed)
        return replace(shifted, functions=replace(shifted.functions, mu=mu, p=p))

    def whole_state(self, values: Mapping[str, fmpq]) -> list[arb]:
        """All components at the start, angles from their references; a cyclic one that is not given is 0."""
        if self._normal is None:
            return list(self._whole_state())
        given = self.start(values)
        state = [arb(self._given.get(name, fmpq(0))) for name in self.mechanism.state]
        y, v = constant(given["y"]), constant(given["v"])
        solved = self._normal.solved(y, v)
        functions = self._shifted.expressions(list(solved.values()), BALLS)
        normal_values = BoxProgram(functions, self._size).values(state)
        state[self._normal.place], state[self._normal.velocity] = normal_values
        return state
