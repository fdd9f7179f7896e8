"""The contact force on the slow manifold and its zeros: statements of versions 2 and 3 (certificate.md).

How sizes of F are compared with a level is on check.md, section 5a, and how one finds a dip of G_b in section 5b.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, NamedTuple

from limits import DIGIT, Meter, require
from pieces import ColumnCheck
from reading import Range, check_cover, entries, rational, read_range
from statements import Checker
from theta import Box, Scale, Theta, Value

# ---------------------------------------------------------------------------------------------------------------------
# Sizes of F: check.md, sections 5a and 5b.
# ---------------------------------------------------------------------------------------------------------------------


def compared(value: int, scale: Scale, b: Fraction, level: Fraction, meter: Meter) -> int:
    """The sign of value x^b/2^p - level for value ≥ 0, level > 0, b = h/n ≥ 0, in integers: both sides to the n."""
    require(scale.s == 1, "the size of a derivative is not compared")
    h, n = b.numerator, b.denominator
    one = meter.product((value * level.denominator, n), (scale.x, h))
    two = meter.product((level.numerator << scale.p, n))
    return (one > two) - (one < two)


def within(theta: Theta, box: Box, level: Fraction, splits: int | None = None) -> bool:
    """|F| ≤ level on a box at one b ≥ 0."""

    def ask(part: Box, bits: int) -> tuple[int, Value | None]:
        value = theta.value(part, 0, bits)
        size, b = abs(value.middle), box[0]
        if compared(size + value.slack(), value.scale, b, level, theta.meter) <= 0:
            return 1, value
        # In the middle of the box |F| may exceed the level for certain: then nothing helps.
        refuted = compared(max(size - value.error, 0), value.scale, b, level, theta.meter) > 0
        return 0, None if refuted else value

    return theta.settle(ask, box, splits) == 1


def beyond(theta: Theta, b: Fraction, tau: Fraction, level: Fraction, sign: int) -> bool:
    """sign F ≥ level > 0 at one point, b ≥ 0."""

    def ask(part: Box, bits: int) -> tuple[int, Value | None]:
        value = theta.value(part, 0, bits).times(sign)
        if compared(max(value.low(), 0), value.scale, b, level, theta.meter) >= 0:
            return 1, value
        below = compared(max(value.high(), 0), value.scale, b, level, theta.meter) < 0
        return 0, None if below else value

    return theta.settle(ask, (b, b, tau, tau), 0) == 1


def power_between(base: Fraction, exponent: Fraction, bits: int, meter: Meter) -> tuple[Fraction, Fraction]:
    """base^(h/n) for 0 < base < 1, h/n ≥ 0, between neighbouring multiples of 2^-bits: r^n ≤ 2^(bits n) base^h."""
    h, n, low, high = exponent.numerator, exponent.denominator, 0, 1 << bits
    left, right = meter.product((base.denominator, h)), meter.product((base.numerator, h), (1 << bits, n))
    while high - low > 1:  # low^n ≤ 2^(bits n) base^h < high^n
        middle = (low + high) // 2
        below = meter.product((middle, n), (left, 1)) <= right
        low, high = (middle, high) if below else (low, middle)
    return Fraction(low, 1 << bits), Fraction(high, 1 << bits)


def dips(check: ColumnCheck, first: Fraction, second: Fraction, eta: Fraction) -> bool:
    """Whether F(t1) + η/(8γ) [μ^(b-1) F'(t2) - F'(t1)] < 0 on the column; μ = t1/t2 > 0, γ = (1 - μ³)/3."""
    low, high, ratio = check.column.start - 1, check.column.end - 1, first / second
    weight = 3 * eta / (8 * (1 - ratio**3))
    least, most = (power_between(ratio, b - 1, 2 * DIGIT, check.meter)[i] for i, b in enumerate((high, low)))

    def ask(part: Box, bits: int) -> tuple[int, Value | None]:
        places = ((first, 0), (first, 1), (second, 1))
        value, slope, later = (check.value((*part[:2], tau, tau), k, bits).unscaled() for tau, k in places)
        power = most if later.high() > 0 else least
        total = value.plus(slope.times(-weight)).plus(later.times(weight * power))
        return (1 if total.high() < 0 else 0), (None if total.low() > 0 else total)

    return check.settle(ask, (low, high, first, second), 0) == 1


# ---------------------------------------------------------------------------------------------------------------------
# One column: certificate.md, force, lift_off and slow_zeros.
# ---------------------------------------------------------------------------------------------------------------------


def force_holds(check: ColumnCheck, tau: Range, sign: int, level: Fraction) -> None:
    """On the one column, at one β: sign F ≥ -level on the range of τ (certificate.md, force)."""
    column = check.column
    check.begin(tau.start, tau.end)
    for piece in column.pieces:
        if piece.kind == "level":
            held = within(check, (column.start - 1, column.end - 1, piece.start, piece.end), level)
            require(held, f"|F| ≤ {level} is not confirmed from τ = {piece.start!s:.50} to {piece.end!s:.50}")
            continue
        allowed = piece.kind in ("left", "sign", "right") and (piece.kind, piece.value) != ("right", 1)
        require(allowed, f"a piece {piece.kind} does not bound the force")
        require(check.piece_sign(piece) == sign, f"a piece {piece.kind} gives F the other sign")


def lift_off_holds(check: ColumnCheck, beta: Fraction, tau: Fraction, sign: int, level: Fraction) -> None:
    """On the one column, at one β: sign F ≥ level at one τ (certificate.md, lift_off)."""
    check.begin(tau, tau, [tau])
    require(len(check.column.pieces) == 1 and check.column.pieces[0].kind == "level", "there is not one piece level")
    require(beyond(check, beta - 1, tau, level, sign), f"F beyond the level is not confirmed at τ = {tau!s:.50}")


def dip_holds(check: ColumnCheck, eta: Fraction) -> None:
    """On one column: G_b < 0 at one τ for every ε of the statement (certificate.md, slow_zeros)."""
    column = check.column
    require([piece.kind for piece in column.pieces] == ["dip"], "a column is not one piece dip")
    first, second = column.pieces[0].points
    require(first > 0 and 2 * first**3 <= second**3, "a piece dip has not t1 > 0 and 2 t1³ ≤ t2³")
    short = max(column.start.denominator, column.end.denominator) <= 4096
    require(short, "a column with a piece dip has an end of a denominator beyond 4096")
    check.begin(first, second)
    where = f"the piece dip at τ = {first!s:.50} of the column from β = {column.start!s:.50}"
    require(dips(check, first, second, eta), f"{where} is not confirmed {check.limits.effort()}")


# ---------------------------------------------------------------------------------------------------------------------
# Statements: certificate.md, From pieces to the statement.
# ---------------------------------------------------------------------------------------------------------------------


class System(NamedTuple):
    """The compliant model with its C_1: rational numbers, 1 < β = α_3/α_1 < 5 not an integer, α_1, α_2, α_3 < 0."""

    alpha: list[Fraction]
    c1: Fraction
    beta: Fraction

    def side(self) -> int:
        """The sign of C_1/Γ(-β): Γ(-β) has the sign (-1)^(⌊β⌋ + 1) (side_switching.md)."""
        return (-1) ** (math.floor(self.beta) + 1) * (1 if self.c1 > 0 else -1)

    def compared(self, epsilon: Fraction, level: Fraction, meter: Meter) -> int:
        """The sign of A ε^p β level - mean force, A = |C_1/α_3| κ^(1-β), p = 2(β-1)/3, κ^3 = -α_1/2 (iwc.md).

        With β - 1 = h/n: of (|C_1/α_3| β level/mean)^(3n) (2 ε²/-α_1)^h - 1, exactly.
        """
        first, second, third = self.alpha
        h, n = (self.beta - 1).numerator, self.beta.denominator
        one = abs(self.c1 / third) * self.beta * level * (third - first) / second
        two = 2 * epsilon * epsilon / -first
        above = meter.product((one.numerator, 3 * n), (two.numerator, h))
        below = meter.product((one.denominator, 3 * n), (two.denominator, h))
        return (above > below) - (above < below)

    def words(self) -> str:
        """The system, as a statement begins."""
        numbers, scale = ", ".join(map(str, self.alpha)), f"τ = κ t ε^(-2/3), κ^3 = {-self.alpha[0] / 2}"
        return f"on the slow manifold of the compliant model with α = ({numbers}) and C_1 = {self.c1}, {scale}"


def read_system(alpha: Any, c1: Any) -> System:
    """The numbers of a statement on the compliant model."""
    require(isinstance(alpha, list) and len(alpha) == 3, "alpha is not a list of three numbers")
    numbers, charge = [rational(value) for value in alpha], rational(c1)
    require(all(number < 0 for number in numbers) and charge, "one of the α is not negative, or C_1 = 0")
    beta = numbers[2] / numbers[0]
    require(1 < beta < 5 and 1 < beta.denominator <= 4096, "β is not in (1, 5), an integer, or of a long denominator")
    return System(numbers, charge, beta)


def read_statement(checker: Checker) -> tuple[System, Fraction, Fraction, Any]:
    """System, ε, level and the entry tau of a statement on the force; what it says of ε needs ε > 0 and level > 0."""
    names = ("alpha", "c1", "epsilon", "kind", "level", "tau")
    alpha, c1, epsilon_text, _, level_text, tau = entries(checker.statement, "the statement", *names)
    system, epsilon, level = read_system(alpha, c1), rational(epsilon_text), rational(level_text)
    require(epsilon > 0 and level > 0, "ε or the level is not positive")
    return system, epsilon, level, tau


def check_one_column(checker: Checker, beta: Fraction) -> None:
    """One column, the point β of the statement: F is compared in units of x^b at the one b of the column."""
    require([one[:2] for one in checker.columns] == [(beta, beta)], "there is not one column, the point β")


def check_force(checker: Checker) -> str:
    """The contact force on the slow manifold stays positive, for every ε up to one."""
    system, epsilon, level, tau_text = read_statement(checker)
    tau, meter = read_range(tau_text, "τ"), Meter(checker.limits, checker.left)
    require(system.side() == 1, "C_1/Γ(-β) is not positive")
    require(system.compared(epsilon, level, meter) <= 0, "at this level the deviation exceeds the mean force")
    check_one_column(checker, system.beta)
    checker.on_each_column(force_holds, tau, (-1) ** math.floor(system.beta), level)
    return f"{system.words()}, λ > 0 {tau.text} and every ε in (0, {epsilon}]"


def check_lift_off(checker: Checker) -> str:
    """The contact force on the slow manifold is negative at one τ, for every ε from one on."""
    system, epsilon, level, tau_text = read_statement(checker)
    tau, meter = rational(tau_text), Meter(checker.limits, checker.left)
    require(system.side() == -1, "C_1/Γ(-β) is not negative")
    require(system.compared(epsilon, level, meter) >= 0, "at this level the mean force exceeds the deviation")
    check_one_column(checker, system.beta)
    checker.on_each_column(lift_off_holds, system.beta, tau, (-1) ** math.floor(system.beta), level)
    return f"{system.words()}, λ < 0 at τ = {tau} for every ε ≥ {epsilon}"


def check_slow_zeros(checker: Checker) -> str:
    """Two zeros of the slow solution for every β of a range inside [4, 5] and every ε up to one."""
    names = ("beta", "epsilon", "eta", "kind")
    beta_text, epsilon_text, eta_text, _ = entries(checker.statement, "the statement", *names)
    beta, epsilon, eta = read_range(beta_text, "β"), rational(epsilon_text), rational(eta_text)
    require(beta.start >= 4 and beta.end <= 5, "the range of β is not inside [4, 5]")
    require(beta.start < beta.end or beta.end.denominator > 1, "the range of β is one integer")
    require(epsilon > 0 and eta > 0, "ε or η is not positive")
    meter = Meter(checker.limits, checker.left)
    above = meter.product((2 * epsilon.denominator, 1), (eta.numerator, 3))
    require(above >= meter.product((epsilon.numerator, 1), (eta.denominator, 3)), "2 η³ is less than ε")
    check_cover(checker.columns, beta.start, beta.end, "columns")
    checker.on_each_column(dip_holds, eta)
    where = beta.text + (" that is not an integer" if beta.start < beta.end else "")
    model = "on the slow manifold of the compliant model with α_1 = -1, C_1 ≠ 0"
    return f"{where}, every ε in (0, {epsilon}], {model} λ minus its mean has exactly two real zeros, both simple"


FORCE = {"force": check_force, "lift_off": check_lift_off}
SLOW_ZEROS = {"slow_zeros": check_slow_zeros}
