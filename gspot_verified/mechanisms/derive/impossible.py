"""What no mechanism can have, as far as it is known before any state is: refused when a mechanism is loaded.

A friction coefficient below 0; a mass below 0; a mass matrix that is not positive definite in any state, or at the
place that the mechanism names. Only what is certain is refused: a parameter without a value, or a component without
one, leaves open what depends on it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import powers_as_products, rewritten
from gspot_verified.functions.expressions import Constant, Expression
from gspot_verified.mechanisms.derive.mass_matrix import leading_minors
from gspot_verified.mechanisms.derive.to_system import Preparation, angle_ball
from gspot_verified.mechanisms.formulas.simplify import constant, product_of, sum_of
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol, symbol_names
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError
from gspot_verified.numbers.balls import nonfinite, working_bits
from gspot_verified.numbers.short_text import table_text

_BITS = 128  # any number is correct: what these do not decide is not refused here
_MASS = re.compile(r"(m|M|mass|I|J|inertia)(_?\d+|_\w+)?")
"""The names of parameters that are masses or moments of inertia, where they stand in the mass matrix or in G_T, G_N."""


def refuse_impossible(mechanism: Mechanism) -> None:
    """Refuse a mechanism that cannot be, for the values that its parameters have.

    :raises MechanismError: it cannot be, or its formulas have no value with these parameters; the message names what.

    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> refuse_impossible(shipped_mechanism("rod", mu="-1/2"))
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.input.mechanism.MechanismError: falling rod: the friction coefficient mu is -0.5: it \
must not be negative
    """
    with working_bits(_BITS):
        numbers = _Numbers(mechanism)
        _refuse_masses(mechanism, numbers)
        _refuse_friction(mechanism, numbers)
        _refuse_mass_matrix(mechanism, numbers)


class _Numbers:
    """Enclosures of formulas for any state, and at the place that the mechanism names."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._prepare = Preparation(mechanism)
        self._angles = {angle.name: angle for angle in mechanism.angles}
        self._any = [nonfinite()] * len(mechanism.state)
        self._place = list(self._any)
        if mechanism.place.search:  # a start of Newton's method, no state of the mechanism
            return
        minus = {angle.coordinate: product_of(constant(-1), Symbol(angle.name)) for angle in mechanism.angles}
        given = dict(mechanism.place.values)
        words = [word for word in mechanism.state if word in given]
        values = self._of([sum_of(given[word], minus[word]) if word in minus else given[word] for word in words], [])
        for word, value in zip(words, values, strict=True):
            self._place[mechanism.state.index(word)] = value

    def __call__(self, formulas: Sequence[Expression]) -> tuple[list[arb], list[arb]]:
        """Their values in any state, and at the place; nothing is known of one that depends on what has no value."""
        return self._of(formulas, self._any), self._of(formulas, self._place)

    def _of(self, formulas: Sequence[Expression], state: Sequence[arb]) -> list[arb]:
        prepared = self._prepare(formulas)
        named = rewritten(prepared, self._value)
        made = powers_as_products([named[formula] for formula in prepared])
        return BoxProgram([made[named[formula]] for formula in prepared], len(state), ()).values(state)

    def _value(self, node: Expression) -> Expression | None:
        if not isinstance(node, Symbol):
            return None
        if node.name in self._angles:
            return Constant(angle_ball(self._angles[node.name]))
        return Constant(arb.pi() if node.name == PI else nonfinite())


def _refuse_masses(mechanism: Mechanism, numbers: _Numbers) -> None:
    motion = mechanism.motion
    inertial = motion.mass_matrix if isinstance(motion, Lagrangian) else (motion.G_T, motion.G_N)
    used = symbol_names([entry for row in inertial for entry in row])
    words = [word for word, _ in mechanism.parameters if word in used and _MASS.fullmatch(word)]
    values, _ = numbers([Symbol(word) for word in words])
    for word, value in zip(words, values, strict=True):
        if value < 0:
            raise MechanismError(
                f"{mechanism.name}: the mass {word} is {table_text(value)}: it must not be negative (if it is no mass, "
                "give the parameter another name)"
            )


def _refuse_friction(mechanism: Mechanism, numbers: _Numbers) -> None:
    (anywhere,), (there,) = numbers([mechanism.mu])
    for value, where in ((anywhere, ""), (there, " at the place of the G-spot")):
        if value < 0:
            raise MechanismError(
                f"{mechanism.name}: the friction coefficient mu is {table_text(value)}{where}: it must not be negative"
            )


def _refuse_mass_matrix(mechanism: Mechanism, numbers: _Numbers) -> None:
    """Each entry of the diagonal, and each leading minor, is positive where the matrix is positive definite."""
    if not isinstance(mechanism.motion, Lagrangian):
        return
    rows = mechanism.motion.mass_matrix
    for values, where in zip(
        numbers([entry for row in rows for entry in row]), ("", " at the place of the G-spot"), strict=True
    ):
        matrix = [values[i * len(rows) : (i + 1) * len(rows)] for i in range(len(rows))]
        named = [(f"entry ({i + 1}, {i + 1})", matrix[i][i], [rows[i][i]]) for i in range(len(rows))]
        minors = enumerate(leading_minors(matrix), start=1)
        named += [
            (f"leading minor of size {n}", value, [e for row in rows[:n] for e in row[:n]]) for n, value in minors
        ]
        for what, value, formulas in named:
            if value <= 0:
                raise MechanismError(
                    f"{mechanism.name}: the mass matrix is not positive definite{where}: its {what} is "
                    f"{table_text(value)}{_with(mechanism, formulas)}"
                )


def _with(mechanism: Mechanism, formulas: Sequence[Expression]) -> str:
    """The parameters in the formulas."""
    used = symbol_names(formulas)
    words = [word for word, _ in mechanism.parameters if word in used]
    return f"; it depends on {', '.join(words)}" if words else ""
