"""Products of powers, Γ factors and a phase, compared exactly: exponents are polynomials in β, k, ..., not numbers.

A closed form is  (rational function) · Π base^exponent · e^(iπ phase) · Π Γ(argument)^m · Π sin(π argument)^m  with
polynomials over the rationals as exponents, phase and arguments. Γ is brought to a normal form by three identities:

- Γ(z + 1) = z Γ(z) (DLMF 5.5.1): the constant of the argument lies in (0, 1];
- Γ(z) Γ(1 - z) = π/sin(πz) (DLMF 5.5.3): the coefficient of β is not positive;
- Γ(3z) = 3^(3z - 1/2)/(2π) · Γ(z) Γ(z + 1/3) Γ(z + 2/3) (DLMF 5.5.6): the coefficient of β is not -1.

So two equal normal forms are equal functions wherever both are defined. Different ones may still be equal functions:
"equal" is proved, "not equal" is not.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import reduce

from flint import fmpq, fmpq_mpoly, fmpz

from gspot_verified.functions.symbols import RationalFunction
from gspot_verified.paper.checks.identities import Algebra, rising_signs

ALGEBRA = Algebra("beta k m n i pi e C_1 alpha1 alpha2 alpha3 kappa epsilon c t s tau x lam slope y u v w")
"""The symbols of the formulas; lam is |τ|^(3/2), slope and y stand for values of dΘ/dτ and Θ."""
INTEGERS = ("k", "m", "n")
"""Symbols that stand for integers >= 0: (-1)^(2k) is 1."""
POSITIVE = ("pi", "e", "kappa", "epsilon", "tau", "x", "lam", "u", "v", "w", *INTEGERS)
"""Symbols that stand for positive numbers (the integers: not negative) where a sign is asked for."""
UNIT = "v"
"""A symbol that stands for a number in (0, 1)."""
_SINES = {fmpq(1, 2): (fmpq(1), fmpq(0)), fmpq(1, 3): (fmpq(1, 2), fmpq(1, 2)), fmpq(1, 6): (fmpq(1, 2), fmpq(0))}
"""sin(πr) = q 3^w for r in (0, 1/2]: (q, w)."""


@dataclass(frozen=True)
class ClosedForm:
    """A closed form; bases, Γ and sine arguments are texts. Make it with the functions below or from a text."""

    factor: RationalFunction
    powers: Mapping[str, fmpq_mpoly] = field(default_factory=dict)
    phase: fmpq_mpoly = field(default_factory=lambda: ALGEBRA.constant(0))
    gammas: Mapping[str, int] = field(default_factory=dict)
    sines: Mapping[str, int] = field(default_factory=dict)

    def __mul__(self, other: ClosedForm) -> ClosedForm:
        powers = dict(self.powers)
        for base, exponent in other.powers.items():
            powers[base] = powers.get(base, ALGEBRA.constant(0)) + exponent
        return _folded(
            self.factor * other.factor,
            powers,
            self.phase + other.phase,
            _merged(self.gammas, other.gammas),
            _merged(self.sines, other.sines),
        )

    def inverse(self) -> ClosedForm:
        """One over it.

        :raises ZeroDivisionError: it is 0.
        """
        return ClosedForm(
            rational(1).factor / self.factor,
            {base: -exponent for base, exponent in self.powers.items()},
            -self.phase,
            {argument: -times for argument, times in self.gammas.items()},
            {argument: -times for argument, times in self.sines.items()},
        )

    def __truediv__(self, other: ClosedForm) -> ClosedForm:
        return self * other.inverse()

    def __add__(self, other: ClosedForm) -> ClosedForm:
        if other.is_zero():
            return self
        if self.is_zero():
            return other
        ratio = self / other
        if not ratio.is_rational():
            raise ValueError(f"no closed form of a sum: the quotient of its terms is {ratio}")
        return ClosedForm(ratio.factor + rational(1).factor) * other

    def __pow__(self, exponent: int) -> ClosedForm:
        step = self if exponent >= 0 else self.inverse()
        return reduce(lambda product, _: product * step, range(abs(exponent)), rational(1))

    def is_zero(self) -> bool:
        """Whether it is identically 0."""
        return bool(self.factor.numerator.is_zero())

    def turned(self) -> tuple[ClosedForm, ClosedForm] | None:
        """The real and the imaginary part, when the rest is real and the phase a multiple of 1/6; else ``None``."""
        angle = _constant(self.phase)
        if not self.phase.is_constant() or (6 * angle).q != 1:
            return None
        size = ClosedForm(self.factor, self.powers, ALGEBRA.constant(0), self.gammas, self.sines)
        return size * sine_of_number(angle + fmpq(1, 2)), size * sine_of_number(angle)

    def is_rational(self) -> bool:
        """Whether it is a rational function of the symbols."""
        return not self.powers and not self.gammas and not self.sines and self.phase.is_zero()

    def is_one(self) -> bool:
        """Whether it is proved to be identically 1."""
        return self.is_rational() and self.factor == 1

    def exponent(self, base: str) -> fmpq_mpoly:
        """The whole exponent of a base that is a symbol.

        :raises ValueError: the rational function holds the symbol in another way than as a power.
        """
        found = self.powers.get(base, ALGEBRA.constant(0))
        for part, sign in ((self.factor.numerator, 1), (self.factor.denominator, -1)):
            degrees = list(ALGEBRA.coefficients(part, base))
            if len(degrees) != 1:
                raise ValueError(f"{base} does not occur as one power in {part}")
            found += sign * degrees[0]
        return found

    def is_positive(self) -> bool:
        """Whether it is proved to be positive where the symbols of :data:`POSITIVE` are; any other symbol: False."""
        parts = [self.factor.numerator, self.factor.denominator]
        parts += [ALGEBRA.read(argument) for argument in self.gammas]
        real = all(_symbols_of(exponent) <= set(POSITIVE) | {"beta"} for exponent in self.powers.values())
        bases = all(base.isdigit() or base in POSITIVE for base in self.powers)
        return self.phase.is_zero() and not self.sines and real and bases and all(map(_is_positive, parts))

    def sign(self) -> int | None:
        """1 or -1 when the sign is proved where the symbols of :data:`POSITIVE` are positive, else ``None``."""
        if self.is_zero():
            return None
        return 1 if self.is_positive() else -1 if (rational(-1) * self).is_positive() else None

    def __str__(self) -> str:
        parts = [] if self.factor == 1 else [str(self.factor)]
        parts += [f"{base}^({exponent})" for base, exponent in self.powers.items()]
        parts += [] if self.phase.is_zero() else [f"exp(iπ({self.phase}))"]
        for name, arguments in (("Γ", self.gammas), ("sin π", self.sines)):
            parts += [f"{name}({argument})^{times}" for argument, times in arguments.items()]
        return " ".join(parts) or "1"


def rational(value: int | fmpq | fmpq_mpoly) -> ClosedForm:
    """A rational number or a polynomial."""
    part = value if isinstance(value, fmpq_mpoly) else ALGEBRA.constant(value)
    return ClosedForm(RationalFunction(part, ALGEBRA.constant(1)))


def power(base: str, exponent: fmpq_mpoly) -> ClosedForm:
    """base^exponent for a symbol or a positive integer; i^exponent is a phase, and so is e^(iπ ...).

    :raises ValueError: the exponent is no integer and the base is not known to be positive.
    """
    if base == "i":
        return _folded(rational(1).factor, {}, exponent / 2)
    if base == "e":
        turning = ALGEBRA.coefficient_of(ALGEBRA.coefficient_of(exponent, "i", 1), "pi", 1)
        rest = exponent - turning * ALGEBRA.read("i*pi")
        return _folded(rational(1).factor, {} if rest.is_zero() else {"e": rest}, turning)
    if base == "-1":
        return _folded(rational(1).factor, {}, exponent)
    if not base.isdigit() and base not in POSITIVE and not (exponent.is_constant() and _constant(exponent).q == 1):
        raise ValueError(f"{base}^({exponent}): the base may be negative")
    factors = {base: exponent}
    if base.isdigit():
        factors = {str(prime): times * exponent for prime, times in fmpz(int(base)).factor()}
    return _folded(rational(1).factor, factors, ALGEBRA.constant(0))


def gamma(argument: fmpq_mpoly) -> ClosedForm:
    """Γ(argument) in normal form.

    :raises ValueError: the argument is 0, -1, -2, ...
    """
    slope = _coefficient(argument, "beta")
    if argument.is_constant():
        return _gamma_of_number(_constant(argument))
    if abs(slope) == 1:
        thirds = [gamma((argument + i) / 3) for i in range(3)]
        front = power("3", argument - fmpq(1, 2)) / (rational(2) * rational(ALGEBRA.symbols["pi"]))
        return reduce(ClosedForm.__mul__, thirds, front)
    if slope > 0:
        return rational(ALGEBRA.symbols["pi"]) / (_sine(argument) * gamma(1 - argument))
    found, step = rational(1), 1 - _ceiling(_constant(argument))
    for i in range(step):
        found = found / rational(argument + i)
    for i in range(-step):
        found = found * rational(argument - 1 - i)
    return found * ClosedForm(rational(1).factor, gammas={str(argument + step): 1})


def _gamma_of_number(value: fmpq) -> ClosedForm:
    if value.q == 1 and value <= 0:
        raise ValueError(f"Γ has a pole at {value}")
    found = rational(1)
    while value > 1:
        value -= 1
        found = found * rational(value)
    while value <= 0:
        found = found / rational(value)
        value += 1
    if value == 1:
        return found
    if value == fmpq(1, 2):
        return found * power("pi", ALGEBRA.constant(value))
    if 1 - value in _SINES:
        return found * rational(ALGEBRA.symbols["pi"]) / (_sine(ALGEBRA.constant(value)) * _gamma_of_number(1 - value))
    return found * ClosedForm(rational(1).factor, gammas={str(value): 1})


def _sine(argument: fmpq_mpoly) -> ClosedForm:
    """sin(π argument): whole turns and integer symbols go to the sign."""
    if argument.is_constant():
        return sine_of_number(_constant(argument))
    halves = ALGEBRA.constant(int(_constant(argument).floor()))
    for name in INTEGERS:
        slope = _coefficient(argument, name)
        halves += int(slope.floor()) * ALGEBRA.symbols[name]
    return _folded(rational(1).factor, {}, halves, {}, {str(argument - halves): 1})


def sine_of_number(value: fmpq) -> ClosedForm:
    """sin(π value) for a multiple of 1/6."""
    half_turns = int(value.floor())
    rest = value - half_turns
    if rest == 0:
        return rational(0)
    number, threes = _SINES[min(rest, 1 - rest)]
    return rational(-number if half_turns % 2 else number) * power("3", ALGEBRA.constant(threes))


def _folded(
    factor: RationalFunction,
    powers: Mapping[str, fmpq_mpoly],
    phase: fmpq_mpoly,
    gammas: Mapping[str, int] | None = None,
    sines: Mapping[str, int] | None = None,
) -> ClosedForm:
    """Integer exponents go into the rational function, whole turns of the phase vanish, half turns give a sign."""
    kept = {}
    for base, exponent in powers.items():
        whole = _constant(exponent)
        if exponent.is_constant() and whole.q == 1:
            value = ALGEBRA.constant(int(base)) if base.isdigit() else ALGEBRA.symbols[base]
            factor = factor * RationalFunction(value, ALGEBRA.constant(1)) ** int(whole.p)
        else:
            kept[base] = exponent
    turn = 2 * int((_constant(phase) / 2).floor())
    phase = phase - turn
    for name in INTEGERS:
        turn = 2 * int((_coefficient(phase, name) / 2).floor())
        phase = phase - turn * ALGEBRA.symbols[name]
    if _constant(phase) >= 1:
        factor, phase = -factor, phase - 1
    return ClosedForm(factor, kept, phase, gammas or {}, sines or {})


def _symbols_of(value: fmpq_mpoly) -> set[str]:
    return {name for name, degree in zip(ALGEBRA.symbols, value.degrees(), strict=True) if degree > 0}


def _is_positive(value: fmpq_mpoly) -> bool:
    """Whether all coefficients are positive, with v = w'/(1 + w'), w' > 0, and with 0 for the integer symbols too."""
    if value.is_zero() or not _symbols_of(value) <= set(POSITIVE):
        return False
    unit = ALGEBRA.symbols[UNIT]
    powers = ALGEBRA.coefficients(value, UNIT)
    whole = sum(
        (row * unit**k * (1 + unit) ** (max(powers) - k) for k, row in powers.items()), start=ALGEBRA.constant(0)
    )
    at_zero = ALGEBRA.substitute(whole, {name: ALGEBRA.constant(0) for name in INTEGERS})
    return rising_signs(whole) and rising_signs(at_zero)


def _merged(first: Mapping[str, int], second: Mapping[str, int]) -> dict[str, int]:
    keys: Iterable[str] = {**first, **second}
    found = {key: first.get(key, 0) + second.get(key, 0) for key in keys}
    return {key: times for key, times in found.items() if times}


def _coefficient(value: fmpq_mpoly, name: str) -> fmpq:
    """The coefficient of the single symbol."""
    place = list(ALGEBRA.symbols).index(name)
    wanted = tuple(int(i == place) for i in range(len(ALGEBRA.symbols)))
    return fmpq(value[wanted])


def _constant(value: fmpq_mpoly) -> fmpq:
    return fmpq(value[(0,) * len(ALGEBRA.symbols)])


def _ceiling(value: fmpq) -> int:
    return int(value.ceil())
