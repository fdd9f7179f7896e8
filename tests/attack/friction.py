"""The critical friction of random bodies and of arms that hang on a pivot: the largest B/C where y = 0, by a fine grid
and a local search from its best points."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from random import Random

import scipy.optimize
import sympy
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import exactly
from attack.mechanisms import body, drawn_body, file_of
from attack.reference_mechanism import Body

from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.spots.critical_friction import critical_friction

_GRID = 4000
_OFF = 1e-9
_NONE = -1e9
"""Less than any B/C: there is no such configuration."""


def attack(random: Random) -> Attack:
    """One of the two."""
    return random.choice((_body, _arm))(random)


def _body(random: Random) -> Attack:
    values, slip = drawn_body(random)
    values["w"] = random.choice((0, 1, 2, 3, 5))
    values["mu"] = random.choice((values["mu"], values["mu"] / 4, 3 * values["mu"]))
    text = file_of(values, slip)

    def largest() -> float:
        ratio, th = _ratio(body(values)), sympy.Symbol("th", real=True)
        return _largest(sympy.lambdify(th, ratio, "math"), [(-3.1416, 3.1416)])

    return Attack(f"critical_friction(parse_mechanism('''{text}'''))",
                  lambda: judged(text, largest, float(values["mu"])))  # fmt: skip


@dataclass(frozen=True)
class Arm:
    """Two links on a pivot at the height h: y = h - l cos(th) - m cos(ph)."""

    numbers: tuple[Fraction, ...]
    """h, l, m, the two inertias, their coupling."""
    mu: Fraction

    def formulas(self) -> tuple[str, str, str]:
        """x, y and the kinetic energy."""
        h, first, second, one, two, both = self.numbers
        kinetic = f"({one})*th_dot^2/2 + ({two})*ph_dot^2/2 + ({both})*th_dot*ph_dot*cos(th - ph)"
        return (f"({first})*sin(th) + ({second})*sin(ph)",
                f"({h}) - ({first})*cos(th) - ({second})*cos(ph)", kinetic)  # fmt: skip

    @property
    def text(self) -> str:
        """The mechanism's file."""
        x, y, kinetic = self.formulas()
        return "\n".join([
            "format = 1", 'name = "attack"', "[energies]", 'coordinates = ["th", "ph"]', f'kinetic = "{kinetic}"',
            'potential = "-cos(th) - cos(ph)"', "[contact]", f'x = "{x}"', f'y = "{y}"', f'mu = "{self.mu}"',
        ])  # fmt: skip

    def body(self) -> Body:
        """The same for the reference."""
        q, dq = sympy.symbols("th ph", real=True), sympy.symbols("th_dot ph_dot", real=True)
        known = {str(symbol): symbol for symbol in (*q, *dq)}
        x, y, kinetic = (sympy.sympify(f.replace("^", "**"), locals=known, rational=True) for f in self.formulas())
        return Body(q, dq, kinetic, sympy.Integer(0), (sympy.Integer(0),) * 2, x, y, sympy.Rational(1))

    def largest(self) -> float:
        """Along both branches of ph over th."""
        h, first, second, *_ = self.numbers
        th, ph = sympy.symbols("th ph", real=True)
        ratio = sympy.lambdify([th, ph], _ratio(self.body()), "math")
        height = sympy.lambdify(th, (h - first * sympy.cos(th)) / second, "math")
        bend = sympy.lambdify(th, sympy.acos((h - first * sympy.cos(th)) / second), "math")
        found = [_NONE]
        for sign in (1, -1):

            def value(at: float, sign: int = sign) -> float:
                return float(ratio(at, sign * bend(at))) if abs(height(at)) <= 1 else _NONE

            found.append(_largest(value, [(-3.1416, 3.1416)]))
        return max(found)


def _arm(random: Random) -> Attack:
    part = [Fraction(random.randint(2, 16), 8) for _ in range(5)]
    coupling = Fraction(random.randint(-6, 6), 8) * min(part[3], part[4])
    arm = Arm((part[0] * random.choice((1, 1, 2)), *part[1:5], coupling), Fraction(random.randint(1, 24), 8))
    return Attack(f"critical_friction(parse_mechanism('''{arm.text}'''))",
                  lambda: judged(arm.text, arm.largest, float(arm.mu)))  # fmt: skip


def _ratio(mechanism: Body) -> sympy.Expr:
    found = mechanism.functions()
    return found["B"] / found["C"]


def _largest(function: Callable[[float], float], ends: list[tuple[float, float]]) -> float:
    best = _NONE
    for low, high in ends:
        step = (high - low) / _GRID
        values = [function(low + k * step) for k in range(_GRID + 1)]
        best = max(best, *values)
        for k in sorted(range(_GRID + 1), key=values.__getitem__)[-8:]:
            around = (low + (k - 1) * step, low + (k + 1) * step)
            found = scipy.optimize.minimize_scalar(lambda at: -function(at), bounds=around, method="bounded",
                                                   options={"xatol": 1e-13})  # fmt: skip
            best = max(best, float(-found.fun))
    return best


def judged(text: str, largest: Callable[[], float], mu: float) -> Answer:
    """1/max(B/C), or infinite."""
    try:
        found = critical_friction(parse_mechanism(text))
    except MechanismError as error:
        return undecided(f"MechanismError: {str(error)[:60]}")
    if found.value is None:
        return undecided(found.reason[:60])
    most = largest()
    shown = f"{found}\n  reference: the largest B/C is {most}"
    if not found.value.is_finite():
        return AGREED if most <= _OFF else wrong(shown)
    if most <= 0:
        return wrong(shown)
    middle, radius = float(exactly(found.value.mid())), float(exactly(found.value.rad()))
    if abs(middle - 1 / most) > radius + 1e-6 / most:
        return wrong(shown)
    sure = abs(mu - 1 / most) > 1e-6
    return wrong(shown) if sure and found.is_below not in (None, mu < 1 / most) else AGREED
