"""Every flint operation that the package uses, against an independent value.

The list below is frozen: a scan of the sources fails when the package uses an operation that is not in it, and a
second test fails when an operation of the list has no test here. Rational results are compared with Python's fractions,
transcendental ones with mpmath at 600 bits (``mpmath.mp``, whose numbers share no code with flint). Containment is
decided on the integers of ``man_exp``, after finiteness.
"""

from __future__ import annotations

import ast
import functools
import itertools
import math
import operator
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, TypeVar

import mpmath
import pytest
from flint import (
    acb,
    acb_poly,
    arb,
    arb_mat,
    arb_poly,
    arb_series,
    ctx,
    fmpq,
    fmpq_mat,
    fmpq_mpoly,
    fmpq_mpoly_ctx,
    fmpq_poly,
    fmpz,
    fmpz_mat,
    fmpz_poly,
)  # fmt: skip
from flint.utils.flint_exceptions import DomainError
from samples.strategies import dyadic_fraction, ends, holds, make_ball, to_fmpq, to_fraction

from gspot_verified.numbers.balls import working_bits

PACKAGE = Path(__file__).resolve().parents[2] / "gspot_verified"

CLASSES = {
    "acb": acb,
    "acb_poly": acb_poly,
    "arb": arb,
    "arb_mat": arb_mat,
    "arb_poly": arb_poly,
    "arb_series": arb_series,
    "fmpq": fmpq,
    "fmpq_mat": fmpq_mat,
    "fmpq_mpoly": fmpq_mpoly,
    "fmpq_mpoly_ctx": fmpq_mpoly_ctx,
    "fmpq_poly": fmpq_poly,
    "fmpz": fmpz,
    "fmpz_mat": fmpz_mat,
    "fmpz_poly": fmpz_poly,
}

# Attribute names of flint objects. A field of the package's own that has the same name is tested here all the same.
_METHODS = """
    abs_lower abs_upper airy_ai atan atan2 bit_length bits ceil coeffs constant contains content contains_interior cos
    cos_pi cosh degree denominator derivative det entries evaluate exp expm1 fac_ui floor gamma gamma_fmpq gcd
    gens get height_bits hypgeom imag integral intersection inv is_constant is_exact is_finite is_one is_prime
    is_zero lcm leading_coefficient length lgamma log log1p lower man_exp max mid min name names nan ncols numerator
    overlaps p pi pos_inf prec q rad real rel_accuracy_bits rgamma rising rising_fmpq_ui root sgn sin sin_pi
    sin_pi_fmpq sinc_pi sinh sqrt str subs table terms truncate union unique_fmpz upper
    from_dict to_dict compose project_to_context total_degree discriminant context ordering is_nan nvars
    repr
    coefficient complex_roots degrees factor ncols nrows rank right_shift solve tolist transpose denom left_shift numer
"""
METHODS = frozenset(_METHODS.split())

# The names of ``ast`` for + - * / // % ** << >> & | and the signs and comparisons.
_OPERATORS = "Add Sub Mult Div FloorDiv Mod Pow LShift RShift BitAnd BitOr USub UAdd Eq NotEq Lt LtE Gt GtE"
OPERATORS = frozenset(_OPERATORS.split())
_NO_OPERATION_OF_FLINT = frozenset(("And", "Or", "Not", "Is", "IsNot", "In", "NotIn"))

_covered: set[str] = set()
_Test = TypeVar("_Test", bound=Callable[..., object])


def covers(*names: str) -> Callable[[_Test], _Test]:
    """State which operations a test is about."""
    _covered.update(names)
    return lambda test: test


# The scan


def _foreign_names(tree: ast.AST) -> set[str]:
    """Names that stand for modules other than flint: ``math.log`` is not flint's."""
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {(alias.asname or alias.name.split(".")[0]) for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] != "flint":
            # `from gspot_verified.theta_function import choice` gives a module; classes begin with a capital.
            names |= {alias.asname or alias.name for alias in node.names if (alias.asname or alias.name).islower()}
    return names - {"flint"}


def _scan(tree: ast.Module) -> tuple[set[str], set[str], set[str]]:
    """Methods, operators and flint names that the source uses."""
    foreign = _foreign_names(tree)
    known = {name for kind in CLASSES.values() for name in dir(kind) if not name.startswith("_")}
    methods, operators, imported = set(), set(), set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr in known:
            if not (isinstance(node.value, ast.Name) and node.value.id in foreign):
                methods.add(node.attr)
        elif isinstance(node, ast.BinOp | ast.UnaryOp | ast.AugAssign):
            operators.add(type(node.op).__name__)
        elif isinstance(node, ast.Compare):
            operators |= {type(op).__name__ for op in node.ops}
        elif isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] == "flint":
            imported |= {alias.name for alias in node.names}
    return methods, operators - _NO_OPERATION_OF_FLINT, imported


def _used(
    package_trees: Mapping[Path, ast.Module],
) -> tuple[dict[str, set[str]], dict[str, set[str]], dict[str, set[str]]]:
    methods: dict[str, set[str]] = {}
    operators: dict[str, set[str]] = {}
    imported: dict[str, set[str]] = {}
    for path, tree in package_trees.items():
        name = path.relative_to(PACKAGE).as_posix()
        found = _scan(tree)
        # Without flint's names a file may still call methods on balls, but numpy's operators are not flint's.
        for table, names in zip((methods, operators, imported), found, strict=True):
            if table is operators and not found[2]:
                continue
            for item in names:
                table.setdefault(item, set()).add(name)
    return methods, operators, imported


def test_the_package_uses_no_operation_beyond_the_list(package_trees: Mapping[Path, ast.Module]) -> None:
    methods, operators, imported = _used(package_trees)
    assert {"abs_upper", "man_exp", "rgamma"} <= set(methods)
    assert {name: files for name, files in methods.items() if name not in METHODS} == {}
    assert {name: files for name, files in operators.items() if name not in OPERATORS} == {}
    assert {name: files for name, files in imported.items() if name not in (*CLASSES, "ctx", "Ordering")} == {}


def test_every_listed_operation_has_a_test() -> None:
    assert _covered == METHODS | OPERATORS


def test_the_scan_sees_operations() -> None:
    source = (
        "import math\nfrom flint import arb\nfrom gspot_verified.theta_function import choice\n"
        "math.erf(1); choice.bits; arb(1).zeta(); f().erfc; x ^ y; a @ b; arb.bell_number(3); -z"
    )
    assert _scan(ast.parse(source)) == ({"zeta", "erfc", "bell_number"}, {"BitXor", "MatMult", "USub"}, {"arb"})


# Samples

_random = random.Random(20240607)
_RATIONALS = [
    Fraction(0), Fraction(1), Fraction(-1), Fraction(1, 2), Fraction(-7, 3), Fraction(10**30 + 1, 10**30),
    Fraction(-5), Fraction(1, 10**40), Fraction(10**25), Fraction(-(2**70) - 1, 3**40),
    *(Fraction(_random.randint(-(10**20), 10**20), _random.randint(1, 10**18)) for _ in range(4)),
]  # fmt: skip
_INTEGERS = [0, 1, -1, 2, -7, 12, 10**18, -(10**18) - 3, 2**64, -(2**64) + 1, 10**40 + 7]
_BALLS = [
    make_ball((0, 0)), make_ball((3, 0)), make_ball((-5, -3)), make_ball((1, -1), (1, -1)), make_ball((0, 0), (1, 0)),
    make_ball((1, 0), (1, -40)), make_ball((-7, 2), (3, -10)), make_ball((10**30 + 1, -50), (12345, -60)),
    make_ball((1, 200)), make_ball((-3, -200), (1, -230)), make_ball((5, 0), (1, 1)), make_ball((-5, 0), (3, 1)),
    *(
        make_ball((_random.getrandbits(80) * (-1) ** j, -70 - j), (_random.getrandbits(30), -90 + 9 * j))
        for j in range(8)
    ),
]  # fmt: skip
_BITS = (2, 30, 53, 64, 200)


def three(value: arb) -> tuple[Fraction, ...]:
    """Both ends and the middle of a finite ball."""
    lower, upper = ends(value)
    return lower, (lower + upper) / 2, upper


def cycle_bits() -> Iterable[int]:
    return itertools.cycle(_BITS)


# Integers and rationals


@covers("Add", "Sub", "Mult", "Div", "Eq", "NotEq", "Lt", "LtE", "Gt", "GtE")
@pytest.mark.parametrize(
    "action",
    [operator.add, operator.sub, operator.mul, operator.truediv, operator.eq, operator.ne, operator.lt, operator.le,
     operator.gt, operator.ge],
)  # fmt: skip
def test_rational_arithmetic(action: Callable[[Any, Any], Any]) -> None:
    for left, right in itertools.product(_RATIONALS, repeat=2):
        forms: list[tuple[Any, Any]] = [(to_fmpq(left), to_fmpq(right))]
        if right.denominator == 1:
            forms += [(to_fmpq(left), int(right)), (to_fmpq(left), fmpz(int(right)))]
        if left.denominator == 1:
            forms += [(int(left), to_fmpq(right)), (fmpz(int(left)), to_fmpq(right))]
        for first, second in forms:
            if action is operator.truediv and right == 0:
                with pytest.raises(ZeroDivisionError):
                    action(first, second)
                continue
            result, expected = action(first, second), action(left, right)
            if isinstance(expected, bool):
                assert result is expected
            else:
                assert isinstance(result, fmpq)
                assert to_fraction(result) == expected


@covers("Pow", "USub", "UAdd")
def test_rational_powers_and_signs() -> None:
    for number in _RATIONALS:
        value = to_fmpq(number)
        assert to_fraction(-value) == -number
        assert to_fraction(+value) == number
        assert to_fraction(abs(value)) == abs(number)
        for power in (0, 1, 2, 3, 7, -1, -2):
            if number == 0 and power < 0:
                continue
            assert to_fraction(value**power) == number**power
            assert to_fraction(value ** fmpz(power)) == number**power


@covers("p", "q", "numerator", "denominator", "floor", "ceil", "height_bits")
def test_rational_parts() -> None:
    for number in _RATIONALS:
        value = fmpq(6 * number.numerator, 6 * number.denominator)
        assert (int(value.p), int(value.q)) == (number.numerator, number.denominator)
        assert (int(value.numerator), int(value.denominator)) == (number.numerator, number.denominator)
        assert int(value.floor()) == math.floor(number)
        assert int(value.ceil()) == math.ceil(number)
        assert value.height_bits() == max(abs(number.numerator).bit_length(), number.denominator.bit_length())
        assert (value == 0) == (number == 0)  # is_zero() of a flint rational or integer answers False even for 0
    assert (int(fmpq(1, -2).p), int(fmpq(1, -2).q)) == (-1, 2)
    with pytest.raises(ZeroDivisionError):
        fmpq(1, 0)


@covers("FloorDiv", "Mod", "LShift", "RShift", "BitAnd", "BitOr")
@pytest.mark.parametrize(
    "action",
    [operator.add, operator.sub, operator.mul, operator.floordiv, operator.mod, operator.and_, operator.or_,
     operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge],
)  # fmt: skip
def test_integer_arithmetic(action: Callable[[Any, Any], Any]) -> None:
    for left, right in itertools.product(_INTEGERS, repeat=2):
        for first, second in ((fmpz(left), fmpz(right)), (fmpz(left), right), (left, fmpz(right))):
            if right == 0 and action in (operator.floordiv, operator.mod):
                with pytest.raises(ZeroDivisionError):
                    action(first, second)
                continue
            assert action(first, second) == action(left, right)


def test_integer_shifts_powers_signs() -> None:
    for number in _INTEGERS:
        value = fmpz(number)
        assert (int(-value), int(+value), abs(value)) == (-number, number, abs(number))
        for count in (0, 1, 5, 64, 131):
            assert int(value << count) == number << count
            assert int(value >> count) == number >> count
            assert int(value ** (count % 7)) == number ** (count % 7)


def test_integer_division_is_exact_or_an_error() -> None:
    for left, right in itertools.product(_INTEGERS, [n for n in _INTEGERS if n]):
        assert int(fmpz(left * right) / right) == left
        assert int(fmpz(left * right) / fmpz(right)) == left
        if left % right:
            with pytest.raises(DomainError):
                fmpz(left) / right
    with pytest.raises(ZeroDivisionError):
        fmpz(1) / 0


@covers("gcd", "lcm", "bit_length", "is_prime", "fac_ui")
def test_integer_functions() -> None:
    for left, right in itertools.product(_INTEGERS, repeat=2):
        assert int(fmpz(left).gcd(fmpz(right))) == math.gcd(left, right)
        assert int(fmpz(left).lcm(fmpz(right))) == math.lcm(left, right)
        assert int(fmpz(left).gcd(right)) == math.gcd(left, right)
    for number in _INTEGERS:
        assert int(fmpz(number).bit_length()) == abs(number).bit_length()
        assert (fmpz(number).numerator, fmpz(number).denominator) == (number, 1)
        assert (fmpz(number) == 0) == (number == 0)
    for number in (-3, -2, -1, *range(200)):
        prime = number > 1 and all(number % d for d in range(2, math.isqrt(number) + 1))
        assert bool(fmpz(number).is_prime()) == prime
    for number in (0, 1, 2, 20, 21, 50, 100):
        assert int(fmpz.fac_ui(number)) == math.factorial(number)


def test_long_texts_of_integers() -> None:
    digits = "9" * 6000
    assert fmpz(digits) == fmpz(10) ** 6000 - 1
    assert fmpz("-" + digits) == 1 - fmpz(10) ** 6000


# Polynomials over the rationals and the integers

_POLYNOMIALS = [
    [],
    [1],
    [0, 1],
    [Fraction(1, 2), Fraction(-1, 3)],
    [1, 0, -2, Fraction(5, 7)],
    [Fraction(-(10**20), 3), 4, Fraction(1, 10**15), 0, 1],
]
_INTEGER_POLYNOMIALS = [[], [1], [0, 1], [-3, 5], [1, 0, -2, 10**20], [7, -1, 0, 0, 2**70]]


def trimmed(coefficients: Sequence[Fraction | int]) -> list[Fraction]:
    result = [Fraction(c) for c in coefficients]
    while result and result[-1] == 0:
        result.pop()
    return result


def horner(coefficients: Sequence[Fraction | int], at: Fraction | int) -> Fraction:
    value = Fraction(0)
    for coefficient in reversed(coefficients):
        value = value * at + coefficient
    return value


def added(left: Sequence[Fraction | int], right: Sequence[Fraction | int], sign: int = 1) -> list[Fraction]:
    pairs = itertools.zip_longest(left, right, fillvalue=0)
    return trimmed([Fraction(a) + sign * Fraction(b) for a, b in pairs])


def multiplied(left: Sequence[Fraction | int], right: Sequence[Fraction | int]) -> list[Fraction]:
    result = [Fraction(0)] * (len(left) + len(right))
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            result[i + j] += Fraction(a) * b
    return trimmed(result)


def composed(outer: Sequence[Fraction | int], inner: Sequence[Fraction | int]) -> list[Fraction]:
    result: list[Fraction] = []
    for coefficient in reversed(outer):
        result = added(multiplied(result, inner), [coefficient])
    return result


def rational_polynomial(coefficients: Sequence[Fraction | int]) -> fmpq_poly:
    return fmpq_poly([to_fmpq(c) for c in coefficients])


def read(polynomial: fmpq_poly | fmpz_poly) -> list[Fraction]:
    return [to_fraction(fmpq(c)) for c in polynomial.coeffs()]


@covers("coeffs", "degree", "length", "derivative")
def test_rational_polynomials() -> None:
    for left, right in itertools.product(_POLYNOMIALS, repeat=2):
        first, second = rational_polynomial(left), rational_polynomial(right)
        assert read(first + second) == added(left, right)
        assert read(first - second) == added(left, right, -1)
        assert read(first * second) == multiplied(left, right)
        assert read(first(second)) == composed(left, right)
        assert (first == second) == (trimmed(left) == trimmed(right))
        assert (first != second) == (trimmed(left) != trimmed(right))
    for coefficients in _POLYNOMIALS:
        polynomial = rational_polynomial(coefficients)
        assert (polynomial.length(), polynomial.degree()) == (len(coefficients), len(coefficients) - 1)
        assert read(polynomial.derivative()) == trimmed([k * c for k, c in enumerate(coefficients)][1:])
        assert read(-polynomial) == added([], coefficients, -1)
        assert read(polynomial**3) == multiplied(coefficients, multiplied(coefficients, coefficients))
        for number in _RATIONALS:
            scalar = to_fmpq(number)
            assert to_fraction(fmpq(polynomial(scalar))) == horner(coefficients, number)
            assert read(polynomial + scalar) == read(scalar + polynomial) == added(coefficients, [number])
            assert read(polynomial - scalar) == added(coefficients, [number], -1)
            assert read(scalar - polynomial) == added([number], coefficients, -1)
            assert read(polynomial * scalar) == read(scalar * polynomial) == multiplied(coefficients, [number])
            if number:
                assert read(polynomial / scalar) == multiplied(coefficients, [1 / number])
            if number.denominator == 1:
                integer = int(number)
                assert read(polynomial + integer) == read(integer + polynomial) == added(coefficients, [integer])
                assert read(polynomial - integer) == added(coefficients, [integer], -1)
                assert read(integer - polynomial) == added([integer], coefficients, -1)
                assert read(polynomial * integer) == read(integer * polynomial) == multiplied(coefficients, [number])
                assert to_fraction(fmpq(polynomial(integer))) == horner(coefficients, integer)
                if integer:
                    assert read(polynomial / integer) == multiplied(coefficients, [1 / number])
        with pytest.raises(ZeroDivisionError):
            polynomial / 0


@covers("content")
def test_integer_polynomials() -> None:
    for left, right in itertools.product(_INTEGER_POLYNOMIALS, repeat=2):
        first, second = fmpz_poly(left), fmpz_poly(right)
        assert read(first + second) == added(left, right)
        assert read(first - second) == added(left, right, -1)
        assert read(first * second) == multiplied(left, right)
        assert read(first(second)) == composed(left, right)
        assert (first == second) == (left == right)
    for coefficients in _INTEGER_POLYNOMIALS:
        polynomial = fmpz_poly(coefficients)
        assert (polynomial.length(), polynomial.degree()) == (len(coefficients), len(coefficients) - 1)
        assert read(-polynomial) == added([], coefficients, -1)
        common = math.gcd(*coefficients)
        assert int(polynomial.content()) == common
        if common:
            assert read(polynomial // fmpz(common)) == [Fraction(c, common) for c in read(polynomial)]
        for number in _INTEGERS:
            for scalar in (number, fmpz(number)):
                assert int(polynomial(scalar)) == horner(coefficients, number)
                assert read(polynomial + scalar) == read(scalar + polynomial) == added(coefficients, [number])
                assert read(polynomial - scalar) == added(coefficients, [number], -1)
                assert read(polynomial * scalar) == read(scalar * polynomial) == multiplied(coefficients, [number])


@covers("denom", "left_shift", "numer")
def test_numerators_and_denominators_of_polynomials() -> None:
    for left, number in itertools.product(_INTEGER_POLYNOMIALS, (1, 6, 35)):
        polynomial = fmpq_poly(fmpz_poly(left), fmpz(number))
        assert read(polynomial) == [Fraction(c, number) for c in read(fmpz_poly(left))]
        numerator, denominator = polynomial.numer(), polynomial.denom()
        assert [Fraction(c, int(denominator)) for c in read(numerator)] == read(polynomial)
        assert math.gcd(int(denominator), *(int(c) for c in numerator.coeffs())) == 1 or not left
        assert read(numerator.left_shift(2)) == ([0, 0, *read(numerator)] if numerator.length() else [])


@covers("evaluate", "truncate", "integral")
def test_ball_polynomials() -> None:
    groups = [_BALLS[:4], _BALLS[5:10], _BALLS[10:], [arb(1)], []]
    for group, bits in zip(groups, cycle_bits(), strict=False):
        with working_bits(bits):
            polynomial = arb_poly(group)
            assert len(polynomial.coeffs()) == polynomial.length() == len(group)
            choices = [[three(c)[pick] for c in group] for pick in range(3)]
            for at in _BALLS[:9]:
                value, slope = polynomial(at), polynomial.derivative()(at)
                primitive, many = polynomial.integral()(at), polynomial.evaluate([at])
                square, short = (polynomial * polynomial)(at), polynomial.truncate(2)(at)
                for coefficients, number in itertools.product(choices, three(at)):
                    assert holds(value, horner(coefficients, number))
                    assert holds(many[0], horner(coefficients, number))
                    assert holds(slope, horner([k * c for k, c in enumerate(coefficients)][1:], number))
                    assert holds(primitive, horner([0, *(c / (k + 1) for k, c in enumerate(coefficients))], number))
                    assert holds(square, horner(coefficients, number) ** 2)
                    assert holds(short, horner(coefficients[:2], number))


# Polynomials in several variables

_Terms = dict[tuple[int, ...], Fraction]
_SEVERAL: list[_Terms] = [
    {},
    {(0, 0): Fraction(1)},
    {(0, 0): Fraction(-7, 3)},
    {(1, 0): Fraction(1), (0, 1): Fraction(-1)},
    {(2, 0): Fraction(1, 2), (0, 1): Fraction(10**20), (0, 0): Fraction(3)},
    {(3, 1): Fraction(-1, 3), (1, 3): Fraction(5), (0, 0): Fraction(-1, 10**15)},
]


def several(context: fmpq_mpoly_ctx, terms: _Terms) -> fmpq_mpoly:
    """Built from generators and constants by sums, products and powers."""
    total = context.constant(0)
    for powers, number in terms.items():
        product = context.constant(to_fmpq(number))
        for generator, power in zip(context.gens(), powers, strict=True):
            product = product * generator**power
        total = total + product
    return total


def terms_of(value: fmpq_mpoly) -> _Terms:
    return {tuple(int(e) for e in powers): to_fraction(number) for powers, number in value.terms()}


def terms_combined(left: _Terms, right: _Terms, sign: int) -> _Terms:
    total = {powers: left.get(powers, Fraction(0)) + sign * right.get(powers, Fraction(0)) for powers in left | right}
    return {powers: number for powers, number in total.items() if number}


def terms_multiplied(left: _Terms, right: _Terms) -> _Terms:
    total: _Terms = {}
    for (first, a), (second, b) in itertools.product(left.items(), right.items()):
        powers = tuple(i + j for i, j in zip(first, second, strict=True))
        total[powers] = total.get(powers, Fraction(0)) + a * b
    return {powers: number for powers, number in total.items() if number}


@covers("get", "name", "names", "gens", "constant", "is_constant", "is_one", "leading_coefficient", "terms", "subs")
def test_polynomials_in_several_variables() -> None:
    context = fmpq_mpoly_ctx.get(("x", "y"), "degrevlex")
    assert [context.name(i) for i in range(2)] == list(context.names()) == ["x", "y"]
    assert [terms_of(g) for g in context.gens()] == [{(1, 0): 1}, {(0, 1): 1}]
    for left, right in itertools.product(_SEVERAL, repeat=2):
        first, second = several(context, left), several(context, right)
        assert terms_of(first) == left
        assert terms_of(first + second) == terms_combined(left, right, 1)
        assert terms_of(first - second) == terms_combined(left, right, -1)
        assert terms_of(first * second) == terms_multiplied(left, right)
        assert (first == second) == (left == right)
        assert (first != second) == (left != right)
        if right:
            assert terms_of((first * second) // second) == left
            if left:
                common = first.gcd(second)
                for part in (first, second):
                    assert (part // common) * common == part
                assert (first // common).gcd(second // common).is_one()
    for terms in _SEVERAL:
        value = several(context, terms)
        assert terms_of(-value) == {powers: -number for powers, number in terms.items()}
        assert terms_of(value**2) == terms_multiplied(terms, terms)
        assert value**0 == 1
        assert terms_of(value / fmpq(-3, 7)) == {powers: number * Fraction(-7, 3) for powers, number in terms.items()}
        assert terms_of(fmpq(2, 3) * value) == {powers: number * Fraction(2, 3) for powers, number in terms.items()}
        assert bool(value.is_zero()) == (not terms)
        assert bool(value.is_one()) == (terms == {(0, 0): 1})
        assert bool(value.is_constant()) == (set(terms) <= {(0, 0)})
        if terms:
            # degrevlex with x > y: by total degree, then the higher power of x.
            assert to_fraction(value.leading_coefficient()) == terms[max(terms, key=lambda p: (sum(p), p[0]))]
        at = {"x": Fraction(-2, 5), "y": Fraction(7)}
        found = value.subs({name: to_fmpq(number) for name, number in at.items()})
        expected = sum((c * at["x"] ** i * at["y"] ** j for (i, j), c in terms.items()), Fraction(0))
        assert terms_of(found) == ({(0, 0): expected} if expected else {})


@covers("from_dict", "to_dict", "compose", "project_to_context", "total_degree", "discriminant")
def test_more_on_polynomials_in_several_variables() -> None:
    context = fmpq_mpoly_ctx.get(("x", "y"), "degrevlex")
    larger = fmpq_mpoly_ctx.get(("x", "z", "y"), "degrevlex")
    for terms in _SEVERAL:
        value = context.from_dict({powers: to_fmpq(number) for powers, number in terms.items()})
        assert value == several(context, terms)
        assert {tuple(map(int, p)): to_fraction(c) for p, c in value.to_dict().items()} == terms
        assert int(value.total_degree()) == max((sum(powers) for powers in terms), default=-1)
        assert terms_of(value.project_to_context(larger)) == {(i, 0, j): number for (i, j), number in terms.items()}
        for other in _SEVERAL:
            # x becomes the other polynomial, y becomes x + 1.
            image = several(context, other)
            expected: _Terms = {}
            for (i, j), number in terms.items():
                product: _Terms = {(0, 0): number}
                for factor in [other] * i + [{(1, 0): Fraction(1), (0, 0): Fraction(1)}] * j:
                    product = terms_multiplied(product, factor)
                expected = terms_combined(expected, product, 1)
            assert terms_of(value.compose(image, context.gens()[0] + 1)) == expected
    x, y = context.gens()
    for a, b, c in itertools.product((fmpq(1), fmpq(-2, 3)), (y, y * y - 1), (3 * y, context.constant(5))):
        assert (a * x * x + b * x + c).discriminant("x") == b * b - 4 * a * c
    # (x - y)(x - 2 y)(x + 1): the product of the squared differences of its roots
    cubic = (x - y) * (x - 2 * y) * (x + 1)
    assert cubic.discriminant("x") == (y * (y + 1) * (2 * y + 1)) ** 2


@covers("context", "ordering", "nvars")
def test_a_polynomial_knows_its_symbols_and_their_order() -> None:
    for order in ("lex", "deglex", "degrevlex"):
        context = fmpq_mpoly_ctx.get(("x", "y"), order)
        x, y = context.gens()
        assert (x * y + 1).context() is context
        assert context.nvars() == 2
        assert fmpq_mpoly_ctx.get(context.names(), context.ordering()) is context
        assert fmpq_mpoly_ctx.get(("y", "x"), context.ordering()) is not context


@covers("is_nan", "repr")
@pytest.mark.parametrize("text", ["nan", "inf", "-inf", "0", "1.5"])
def test_nan_is_told_from_every_other_ball(text: str) -> None:
    ball = arb(text)
    assert ball.is_nan() is (text == "nan")
    assert (ball + arb(0, 1)).is_nan() is (text == "nan")
    assert ball.repr().startswith("arb(")


@covers("factor", "degrees")
def test_factors_of_numbers_and_polynomials() -> None:
    for number in (1, 2, 97, 360, 2**20 * 3**5, 10**12 + 39):
        factors = [(int(prime), int(times)) for prime, times in fmpz(number).factor()]
        assert math.prod(prime**times for prime, times in factors) == number
        assert all(all(prime % d for d in range(2, min(prime, 10**4))) for prime, _ in factors)
    context = fmpq_mpoly_ctx.get(("x", "y"), "degrevlex")
    x, y = context.gens()
    for value, count in ((6 * x**2 * (y - 1), 2), ((x - y) * (x + y) ** 3 / 7, 2), (x * x + y * y + 1, 1)):
        number, factors = value.factor()
        product = context.constant(1) * number
        for part, times in factors:
            product = product * part ** int(times)
        assert product == value
        assert len(factors) == count
        powers = list(terms_of(value))
        assert tuple(map(int, value.degrees())) == tuple(max(p[i] for p in powers) for i in (0, 1))


@covers("coefficient")
def test_coefficients_in_the_order_of_the_terms() -> None:
    context = fmpq_mpoly_ctx.get(("x", "y"), "degrevlex")
    for terms in _SEVERAL:
        value = several(context, terms)
        found = [to_fraction(value.coefficient(k)) for k in range(len(terms))]
        assert found == [terms[powers] for powers in sorted(terms, key=lambda p: (sum(p), p[0]), reverse=True)]


@covers("solve", "rank", "ncols")
def test_rational_linear_systems() -> None:
    rows = ((2, 1, 0), (1, -3, 4), (0, 5, 7))
    solution = (Fraction(1, 3), Fraction(-2), Fraction(9, 7))
    right = [sum(Fraction(a) * s for a, s in zip(row, solution, strict=True)) for row in rows]
    matrix = fmpq_mat([[fmpq(a) for a in row] for row in rows])
    found = matrix.solve(fmpq_mat([[to_fmpq(value)] for value in right]))
    assert tuple(to_fraction(found[i, 0]) for i in range(3)) == solution
    for dependent, rank in ((rows, 3), ((*rows[:2], (3, -2, 4)), 2), (((1, 2, 3), (2, 4, 6), (0, 0, 0)), 1)):
        matrix = fmpq_mat([[fmpq(a) for a in row] for row in dependent])
        assert (int(matrix.rank()), matrix.ncols()) == (rank, 3)
    assert fmpq_mat([[fmpq(1), fmpq(2), fmpq(3)], [fmpq(0), fmpq(1), fmpq(5)]]).ncols() == 3
    for bits in (53, 200):
        with working_bits(bits):
            balls = arb_mat(3, 3, [arb(a) for row in rows for a in row])
            near = balls.solve(arb_mat(3, 1, [arb(to_fmpq(value)) for value in right]))
        assert all(holds(near[i, 0], solution[i]) for i in range(3))


@covers("coeffs", "degree")
def test_complex_polynomials() -> None:
    coefficients = (Fraction(2, 3), Fraction(-1, 4), Fraction(5))
    place = (Fraction(1, 7), Fraction(-2, 5))
    real, imaginary = Fraction(0), Fraction(0)
    for coefficient in reversed(coefficients):
        real, imaginary = (
            real * place[0] - imaginary * place[1] + coefficient,
            real * place[1] + imaginary * place[0],
        )
    for bits in (53, 200):
        with working_bits(bits):
            polynomial = acb_poly([to_fmpq(c) for c in coefficients])
            value = polynomial(acb(arb(to_fmpq(place[0])), arb(to_fmpq(place[1]))))
            assert polynomial.degree() == 2
            assert all(holds(c.real, e) for c, e in zip(polynomial.coeffs(), coefficients, strict=True))
        assert holds(value.real, real)
        assert holds(value.imag, imaginary)


@covers("complex_roots")
def test_complex_roots_of_integer_polynomials() -> None:
    for coefficients, bits in itertools.product(
        ([1, 1, 2, 1], [1, 1, 4, 2], [6, -5, 1], [5, 0, 1], [3, 3, 200, 100]), (53, 300)
    ):
        with working_bits(bits):
            roots = [root for root, times in fmpz_poly(coefficients).complex_roots() for _ in range(int(times))]
        assert len(roots) == len(coefficients) - 1
        with mpmath.workdps(120):
            witnesses = mpmath.polyroots(coefficients[::-1], maxsteps=300, extraprec=400)
            for root in roots:
                inside = [w for w in witnesses if _encloses(root, w)]
                assert len(inside) == 1


def _encloses(root: acb, witness: mpmath.mpc) -> bool:
    """Both parts of the finite ball contain the witness, up to its own 100 digits."""
    slack = Fraction(1, 10**100)
    for part, value in ((root.real, witness.real), (root.imag, witness.imag)):
        sign, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
        number = (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
        lower, upper = ends(part)
        if not lower - slack <= number <= upper + slack:
            return False
    return True


# Balls: rational operations


@covers("entries", "table")
def test_ball_matrices() -> None:
    shapes = [(1, 1, 1), (2, 3, 4), (4, 5, 1), (3, 2, 6)]
    for (rows, inner, columns), bits in zip(shapes * 2, cycle_bits(), strict=False):
        left = [_BALLS[(3 * i) % len(_BALLS)] for i in range(rows * inner)]
        right = [_BALLS[(7 * i + 2) % len(_BALLS)] for i in range(inner * columns)]
        with working_bits(bits):
            first, second = arb_mat(rows, inner, left), arb_mat(inner, columns, right)
            product = first * second
        # What was put in comes out, exactly, at any precision.
        assert [ends(value) for value in first.entries()] == [ends(value) for value in left]
        assert [ends(value) for row in first.table() for value in row] == [ends(value) for value in left]
        for i, k in itertools.product(range(rows), range(inner)):
            assert ends(first[i, k]) == ends(left[i * inner + k])
        assert [ends(value) for row in product.table() for value in row] == [ends(v) for v in product.entries()]
        for i, j, place in itertools.product(range(rows), range(columns), range(3)):
            exact = sum(three(left[i * inner + k])[place] * three(right[k * columns + j])[place] for k in range(inner))
            assert holds(product[i, j], exact)


@covers("tolist")
def test_integer_matrices() -> None:
    numbers = [(-1) ** i * (i + 7) ** (i % 90) for i in range(40)]
    for rows, offset in itertools.product((1, 2), range(0, 30, 3)):
        left = [numbers[(offset + 2 * i) % 40 :][:1] + numbers[(offset + 5 * i) % 40 :][:1] for i in range(rows)]
        right = [numbers[(offset + 1) % 40 :][:2], numbers[(offset + 4) % 37 :][:2]]
        first, second = fmpz_mat(left), fmpz_mat(right)
        product, other, factor = first * second, fmpz_mat(left[::-1]), fmpz(numbers[offset])
        assert [[int(number) for number in row] for row in first.tolist()] == left
        for i, j in itertools.product(range(rows), range(2)):
            assert int(product[i, j]) == sum(left[i][k] * right[k][j] for k in range(2))
            assert int((first + other)[i, j]) == left[i][j] + left[rows - 1 - i][j]
            assert int((first * factor)[i, j]) == left[i][j] * numbers[offset]
            with working_bits(2_000):
                assert holds(arb_mat(first)[i, j], left[i][j])


def test_large_matrices_of_very_unequal_entries() -> None:
    """From some size on flint multiplies in blocks of fixed-point integers: the small entries must stay right."""
    rows, inner, columns = 12, 60, 15
    left = [Fraction((-1) ** i * (i % 7 + 1), 3 ** (i % inner)) for i in range(rows * inner)]
    right = [Fraction(i % 11 - 5, 2 ** (4 * (i // columns))) for i in range(inner * columns)]
    for bits in (20, 64, 300):
        with working_bits(bits):
            first = arb_mat(rows, inner, [arb(to_fmpq(number)) for number in left])
            second = arb_mat(inner, columns, [arb(to_fmpq(number)) for number in right])
            product = first * second
        for i, j in itertools.product(range(rows), range(columns)):
            exact = sum(left[i * inner + k] * right[k * columns + j] for k in range(inner))
            assert holds(product[i, j], exact)
            size = sum(abs(left[i * inner + k] * right[k * columns + j]) for k in range(inner))
            lower, upper = ends(product[i, j])
            assert upper - lower <= size / 2 ** (bits - 10)


@covers("inv", "det")
def test_inverse_matrices_and_determinants() -> None:
    for size, bits in itertools.product((1, 2, 3, 5), (30, 53, 200)):
        entries = [[Fraction(1, i + j + 1) + (i == j) for j in range(size)] for i in range(size)]
        with working_bits(bits):
            matrix = arb_mat([[arb(to_fmpq(number)) for number in row] for row in entries])
            inverse, determinant = matrix.inv(), matrix.det()
            identity = matrix * inverse
        # Gauss with fractions, the determinant on the way.
        work = [[*row, *(Fraction(i == j) for j in range(size))] for i, row in enumerate(entries)]
        expected = Fraction(1)
        for k in range(size):
            expected *= work[k][k]
            work[k] = [number / work[k][k] for number in work[k]]
            for i in range(size):
                if i != k:
                    work[i] = [a - work[i][k] * b for a, b in zip(work[i], work[k], strict=True)]
        assert holds(determinant, expected)
        for i, j in itertools.product(range(size), repeat=2):
            assert holds(inverse[i, j], work[i][size + j])
            assert holds(identity[i, j], int(i == j))
    for singular in ([[1, 2], [2, 4]], [[0]]):
        with pytest.raises(ZeroDivisionError):
            arb_mat([[arb(number) for number in row] for row in singular]).inv()
    with pytest.raises(ZeroDivisionError):
        arb_mat([[make_ball((1, 0), (1, 0))]]).inv()  # may be singular


def test_matrices_refuse_what_does_not_fit() -> None:
    with pytest.raises(ValueError, match="length"):
        arb_mat(2, 2, [arb(1), arb(2), arb(3)])
    with pytest.raises(ValueError, match="shape"):
        arb_mat(2, 3, [arb(0)] * 6) * arb_mat(2, 3, [arb(0)] * 6)
    for outside in ((2, 0), (0, 2), (5, 5)):
        with pytest.raises((IndexError, ValueError)):
            arb_mat(2, 2, [arb(1)] * 4)[outside]


@functools.lru_cache
def reciprocal_gamma_coefficients(at: Fraction) -> list[Fraction]:
    """The first 40 Taylor coefficients of 1/Gamma at a point, by the trapezoidal rule on a circle: to 10^-50."""
    points = 192
    with mpmath.mp.workprec(400):
        circle = [mpmath.expjpi(mpmath.mpf(2 * j) / points) for j in range(points)]
        values = [mpmath.rgamma(mp(at) + z) for z in circle]
        sums = [mpmath.fsum(v * circle[-k * j % points] for j, v in enumerate(values)) for k in range(40)]
        return [mp_fraction(mpmath.re(total) / points) for total in sums]


@covers("prec")
@pytest.mark.parametrize("at", [Fraction(1, 3), Fraction(0), Fraction(-4), Fraction(-7, 2), Fraction(40, 3)])
def test_reciprocal_gamma_of_a_power_series(at: Fraction) -> None:
    slope = Fraction(-2, 3)
    saved = ctx.cap
    try:
        for length, bits in itertools.product((1, 2, 5, 12, 40), (64, 120)):
            ctx.cap = length
            with working_bits(bits):
                series = arb_series([arb(to_fmpq(at)), arb(to_fmpq(slope))], length).rgamma()
            assert series.prec == length
            coefficients = list(series.coeffs())
            assert len(coefficients) <= length  # zeros at the end are left out
            coefficients += [arb(0)] * (length - len(coefficients))
            for i, value in enumerate(coefficients):
                number = reciprocal_gamma_coefficients(at)[i] * slope**i
                lower, upper = ends(value)
                assert lower - Fraction(1, 10**50) <= number <= upper + Fraction(1, 10**50)
                assert upper - lower <= Fraction(1, 2 ** (bits - 40))
    finally:
        ctx.cap = saved


@covers("man_exp", "mid", "rad", "is_exact", "is_finite")
def test_ball_parts() -> None:
    for mantissa, exponent in itertools.product((0, 1, -1, 12, -(3**90), 2**64), (-300, -1, 0, 5, 200)):
        value = arb((mantissa, exponent), (3, exponent - 40))
        middle, power = value.mid().man_exp()
        # Independent of the constructor: the mantissa is odd or zero, and the number is the one that was put in.
        assert dyadic_fraction(int(middle), int(power)) == dyadic_fraction(mantissa, exponent)
        assert mantissa == 0 or int(middle) % 2
        radius, power = value.rad().man_exp()
        assert dyadic_fraction(int(radius), int(power)) == dyadic_fraction(3, exponent - 40)
        assert value.is_finite()
        assert not value.is_exact()
        assert value.mid().is_exact()
        assert value.rad().is_exact()
    for number in (0.1, -2.5, 1e-300, 1.7e308, 5e-324):
        assert three(arb(number)) == (Fraction(number),) * 3
    for text in ("nan", "inf", "-inf", "0 +/- inf"):
        assert not arb(text).is_finite()


@covers("transpose")
def test_the_transposed_matrix() -> None:
    for rows, columns in ((1, 1), (2, 3), (4, 1)):
        entries = [[arb(to_fmpq(_random.choice(_RATIONALS))) for _ in range(columns)] for _ in range(rows)]
        found = arb_mat(entries).transpose().table()
        assert [[ends(value) for value in row] for row in found] == [
            [ends(entries[i][j]) for i in range(rows)] for j in range(columns)
        ]


def test_the_exponential_of_a_matrix() -> None:
    """Against the series of exact rationals, with the rest of the series below 2 |A|^n/n!."""
    for size in (1, 2, 3):
        exact = [[Fraction(_random.randint(-9, 9), 8) for _ in range(size)] for _ in range(size)]
        total = [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]
        power = total
        for k in range(1, 60):
            power = [
                [sum((power[i][m] * exact[m][j] for m in range(size)), Fraction(0)) / k for j in range(size)]
                for i in range(size)
            ]
            total = [[a + b for a, b in zip(x, y, strict=True)] for x, y in zip(total, power, strict=True)]
        rest = Fraction(1, 10**40)
        for bits in (53, 100):
            with working_bits(bits):
                found = arb_mat([[arb(to_fmpq(value)) for value in row] for row in exact]).exp()
                for value, true in zip(found.entries(), [value for row in total for value in row], strict=True):
                    assert value.is_finite()
                    lower, upper = ends(value)
                    assert lower <= true + rest
                    assert true - rest <= upper
                    assert upper - lower < Fraction(1, 10**10)


@covers("ncols")
def test_the_number_of_columns_of_a_matrix() -> None:
    for rows in ([[1, 2, 3]], [[1], [2]], [[1, 2], [3, 4], [5, 6]]):
        assert fmpq_mat(rows).ncols() == len(rows[0])


@covers("pos_inf")
def test_infinity_is_above_every_number_and_not_finite() -> None:
    infinite = arb.pos_inf()
    assert not infinite.is_finite()
    assert not infinite < infinite
    for value in _BALLS:
        assert value < infinite
        assert not infinite < value
        assert not infinite <= value
    assert not (arb.nan() < infinite)


@covers("nan", "is_zero")
def test_nan_is_not_finite() -> None:
    assert not arb.nan().is_finite()
    assert not arb.nan().is_exact()
    assert not arb.nan().is_zero()
    for compare in (operator.lt, operator.le, operator.gt, operator.ge, operator.eq):
        assert compare(arb.nan(), 0) is False
        assert compare(arb.nan(), arb.nan()) is False
    for value in _BALLS:
        assert value.is_zero() == (ends(value) == (0, 0))
        assert value.is_exact() == (ends(value)[0] == ends(value)[1])


def test_ball_constructors_contain() -> None:
    for bits in _BITS:
        with working_bits(bits):
            for number in _RATIONALS:
                assert holds(arb(to_fmpq(number)), number)
                if number.denominator == 1:
                    assert holds(arb(int(number)), number)
                    assert holds(arb(fmpz(int(number))), number)
            for text in ("0.1", "-2.75", "1e-30", "123456789.000000001"):
                assert holds(arb(text), Fraction(text))
            for radius in (arb("0.3"), arb(3), make_ball((7, -70))):
                lower, upper = ends(arb(0, radius))
                assert lower <= -ends(radius)[1]
                assert ends(radius)[1] <= upper


@pytest.mark.parametrize("action", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_ball_arithmetic(action: Callable[[Any, Any], Any]) -> None:
    for (left, right), bits in zip(itertools.product(_BALLS, repeat=2), cycle_bits(), strict=False):
        with working_bits(bits):
            result = action(left, right)
        if action is operator.truediv and ends(right)[0] <= 0 <= ends(right)[1]:
            assert not result.is_finite()
            continue
        lower, upper = ends(result)
        for first, second in itertools.product(three(left), three(right)):
            assert lower <= action(first, second) <= upper


@pytest.mark.parametrize("action", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_ball_arithmetic_with_rationals(action: Callable[[Any, Any], Any]) -> None:
    for (value, number), bits in zip(itertools.product(_BALLS, _RATIONALS), cycle_bits(), strict=False):
        scalars: list[Any] = [to_fmpq(number)]
        scalars += [int(number), fmpz(int(number))] if number.denominator == 1 else []
        for scalar, flipped in itertools.product(scalars, (False, True)):
            divisor = ends(value) if flipped else (number, number)
            with working_bits(bits):
                result = action(scalar, value) if flipped else action(value, scalar)
            if action is operator.truediv and divisor[0] <= 0 <= divisor[1]:
                assert not result.is_finite()
                continue
            lower, upper = ends(result)
            for first in three(value):
                assert lower <= (action(number, first) if flipped else action(first, number)) <= upper


def test_ball_integer_powers() -> None:
    for (value, power), bits in zip(itertools.product(_BALLS, (0, 1, 2, 3, 7, -1, -3)), cycle_bits(), strict=False):
        lower, upper = ends(value)
        if lower == -upper != 0 or (power < 0 and lower <= 0 <= upper):
            continue  # flint answers NaN for a ball around 0: valid, and the package multiplies instead
        for exponent in (power, fmpz(power)):
            with working_bits(bits):
                result = value**exponent
            for number in three(value):
                assert holds(result, number**power)


@covers("abs_upper", "abs_lower", "lower", "upper", "sgn")
def test_ball_signs_and_bounds() -> None:
    for value, bits in itertools.product(_BALLS, _BITS):
        lower, upper = ends(value)
        with working_bits(bits):
            negated, rounded, size = -value, +value, abs(value)
            low, high, largest, least = value.lower(), value.upper(), value.abs_upper(), value.abs_lower()
            sign = value.sgn()
        for number in three(value):
            assert holds(negated, -number)
            assert holds(rounded, number)
            assert holds(size, abs(number))
            assert holds(sign, (number > 0) - (number < 0))
        assert all(bound.is_exact() for bound in (low, high, largest, least))
        slack = max(abs(lower), abs(upper)) * Fraction(4, 2**bits)
        assert lower - slack <= three(low)[0] <= lower
        assert upper <= three(high)[0] <= upper + slack
        assert max(abs(lower), abs(upper)) <= three(largest)[0] <= max(abs(lower), abs(upper)) + slack
        smallest = 0 if lower <= 0 <= upper else min(abs(lower), abs(upper))
        assert smallest - slack <= three(least)[0] <= smallest


@covers("union", "intersection", "max", "min", "contains", "contains_interior", "overlaps")
def test_ball_sets() -> None:
    for (left, right), bits in zip(itertools.product(_BALLS, repeat=2), cycle_bits(), strict=False):
        (a, b), (c, d) = ends(left), ends(right)
        assert left.contains(right) == (a <= c and d <= b)
        assert left.contains_interior(right) == (a < c and d < b)
        assert left.overlaps(right) == (a <= d and c <= b)
        with working_bits(bits):
            both, largest, smallest = left.union(right), left.max(right), left.min(right)
            if a <= d and c <= b:
                common = left.intersection(right)
                assert holds(common, max(a, c))
                assert holds(common, min(b, d))
            elif max(a, c) - min(b, d) > max(abs(e) for e in (a, b, c, d)):
                with pytest.raises(ValueError, match="empty"):
                    left.intersection(right)
        for end in (a, b, c, d):
            assert holds(both, end)
        for first, second in itertools.product(three(left), three(right)):
            assert holds(largest, max(first, second))
            assert holds(smallest, min(first, second))


def test_ball_comparisons() -> None:
    rationals = [(to_fmpq(number), number, number) for number in _RATIONALS]
    integers = [(int(number), number, number) for number in _RATIONALS if number.denominator == 1]
    others = [*((value, *ends(value)) for value in _BALLS), *rationals, *integers]
    for value, (other, c, d) in itertools.product(_BALLS, others):
        a, b = ends(value)
        exact_other = not isinstance(other, fmpq) or other.q & (other.q - 1) == 0
        # A rational that is no dyadic is rounded to a ball first: certain answers stay right, some get lost.
        for answer, truth in (
            (value < other, b < c),
            (value <= other, b <= c),
            (value > other, a > d),
            (value >= other, a >= d),
            (other > value, b < c),
            (other >= value, b <= c),
            (other < value, a > d),
            (other <= value, a >= d),
            (value == other, a == b == c == d),
            (value != other, b < c or d < a),
        ):
            assert truth or not answer
            assert answer or not truth or not exact_other or other_is_long(other)


def other_is_long(other: object) -> bool:
    """An integer or dyadic of more bits than the precision in force is rounded before it is compared."""
    return not isinstance(other, arb) and max(abs(fmpq(other).p).bit_length(), int(fmpq(other).q).bit_length()) > 50


def test_floor_and_ceil_of_balls() -> None:
    for value, bits in itertools.product([*_BALLS, arb("2.5"), make_ball((5, -1), (1, -1)), arb(-4)], (30, 64, 200)):
        with working_bits(bits):
            below, above = value.floor(), value.ceil()
        for number in three(value):
            assert holds(below, math.floor(number))
            assert holds(above, math.ceil(number))


@covers("unique_fmpz", "bits", "rel_accuracy_bits")
def test_ball_properties() -> None:
    for value in [*_BALLS, arb(7), make_ball((7, 0), (1, -2)), make_ball((7, 0), (1, 0)), make_ball((15, -1), (1, -3))]:
        lower, upper = ends(value)
        inside = range(math.ceil(lower), math.floor(upper) + 1) if upper - lower < 10 else None
        unique = value.unique_fmpz()
        if unique is not None:
            assert inside is not None
            assert list(inside) == [int(unique)]
        elif inside is not None and len(inside) == 1:
            assert value.bits() > 1  # flint may fail to see it, but not for the simplest
        assert value.bits() == abs(int(value.mid().man_exp()[0])).bit_length()
        accuracy = int(value.rel_accuracy_bits())
        if lower == upper:
            assert accuracy > 10**9
        elif lower <= 0 <= upper:
            assert accuracy <= 0
        else:
            assert (upper - lower) / 2 <= max(abs(lower), abs(upper)) * Fraction(2) ** -accuracy
    assert arb(7).unique_fmpz() == 7
    assert make_ball((7, 0), (1, -2)).unique_fmpz() == 7


@covers("str")
def test_text_of_balls_contains_them() -> None:
    for value, digits in itertools.product(_BALLS, (1, 5, 30)):
        text = value.str(digits)
        middle, _, radius = text.strip("[]").partition("+/-")
        center, spread = Fraction(middle.strip() or 0), Fraction(radius.strip() or 0)
        lower, upper = ends(value)
        assert center - spread <= lower
        assert upper <= center + spread


# Balls: transcendental functions

_MP_BITS = 600


def mp_fraction(number: Any) -> Fraction:
    """The exact value of an mpmath real."""
    sign, mantissa, exponent, _ = mpmath.mpf(number)._mpf_
    return dyadic_fraction(-int(mantissa) if sign else int(mantissa), int(exponent))


def mp(number: Fraction | int) -> Any:
    return mpmath.mpf(number.numerator) / number.denominator


def reference(function: Callable[..., Any], *arguments: Any) -> Fraction:
    with mpmath.mp.workprec(_MP_BITS):
        return mp_fraction(mpmath.re(function(*(mp(a) if isinstance(a, Fraction) else a for a in arguments))))


def assert_encloses(value: arb, expected: Fraction, bits: int = 0) -> None:
    """``expected`` is right to about 580 bits; with ``bits`` the ball must also be that accurate."""
    doubt = abs(expected) / 2**560 + Fraction(1, 2**2000)
    lower, upper = ends(value)
    assert lower - doubt <= expected <= upper + doubt
    if bits:
        assert upper - lower <= max(abs(expected), Fraction(1, 2**30)) / 2 ** (bits - 1)


F = Fraction
_ANY = (F(0), F(1), F(-1), F(1, 3), F(-7, 2), F(22, 7), F(-1, 10**12), F(25))
_POSITIVE = (F(1), F(1, 3), F(7, 2), F(10**15, 7), F(1, 10**20), F(10**6 + 1, 10**6))
_NO_POLE = (F(1), F(5), F(1, 3), F(-1, 3), F(-7, 2), F(53, 3), F(10**6 + 1, 10**6), F(-3) + F(1, 10**6))

_FUNCTIONS: dict[str, tuple[Callable[[arb], arb], Callable[[Any], Any], tuple[Fraction, ...]]] = {
    "exp": (arb.exp, mpmath.exp, _ANY),
    "expm1": (arb.expm1, mpmath.expm1, _ANY),
    "log": (arb.log, mpmath.log, _POSITIVE),
    "log1p": (arb.log1p, lambda x: mpmath.log(1 + x), (*_POSITIVE, F(0), F(-1, 2))),
    "sqrt": (arb.sqrt, mpmath.sqrt, (*_POSITIVE, F(0), F(4))),
    "sin": (arb.sin, mpmath.sin, _ANY),
    "cos": (arb.cos, mpmath.cos, _ANY),
    "sinh": (arb.sinh, mpmath.sinh, _ANY),
    "cosh": (arb.cosh, mpmath.cosh, _ANY),
    "atan": (arb.atan, mpmath.atan, _ANY),
    "sin_pi": (arb.sin_pi, mpmath.sinpi, _ANY),
    "sinc_pi": (arb.sinc_pi, mpmath.sincpi, _ANY),
    "cos_pi": (arb.cos_pi, mpmath.cospi, _ANY),
    "gamma": (arb.gamma, mpmath.gamma, _NO_POLE),
    "rgamma": (arb.rgamma, mpmath.rgamma, (*_NO_POLE, F(0), F(-1), F(-4))),
    "lgamma": (arb.lgamma, mpmath.loggamma, (F(1), F(2), F(5), F(1, 3), F(53, 3), F(10**15, 7))),
    "airy_ai": (lambda x: x.airy_ai(), mpmath.airyai, (F(0), F(1), F(-7, 2), F(22, 7))),
}


@covers(*_FUNCTIONS)
@pytest.mark.parametrize("name", _FUNCTIONS)
def test_functions(name: str) -> None:
    function, independent, points = _FUNCTIONS[name]
    for number in points:
        expected = reference(independent, number)
        for bits in (30, 53, 200, 400):
            with working_bits(bits + 80):
                argument = arb(to_fmpq(number))
            with working_bits(bits):
                assert_encloses(function(argument), expected, bits - 20)


@pytest.mark.parametrize("name", _FUNCTIONS)
def test_functions_of_wide_balls(name: str) -> None:
    function, independent, points = _FUNCTIONS[name]
    for number in points:
        radius = Fraction(1, 2**8) if number == 0 else abs(number) / 2**8
        if name == "sqrt" and number == 0:
            continue
        with working_bits(64):
            wide = arb(to_fmpq(number), to_fmpq(radius))
            value = function(wide)
        if not value.is_finite():
            assert name == "gamma"  # a pole inside
            assert math.floor(number - radius * 2) != math.floor(number + radius * 2)
            continue
        for inside in three(wide):
            assert_encloses(value, reference(independent, inside))


@covers("pi", "root", "gamma_fmpq", "sin_pi_fmpq", "rising", "rising_fmpq_ui")
@pytest.mark.parametrize("bits", [30, 64, 200, 400])
def test_special_values(bits: int) -> None:
    with working_bits(bits):
        with mpmath.mp.workprec(_MP_BITS):
            pi = mp_fraction(+mpmath.pi)
        assert_encloses(arb.pi(), pi, bits - 5)
        for number, degree in itertools.product((F(3), F(1, 7), F(10**12), F(8)), (1, 2, 3, 6, 24)):
            expected = reference(lambda x, n=degree: mpmath.root(x, n), number)
            assert_encloses(arb(to_fmpq(number)).root(degree), expected, bits - 10)
        for number in (*_NO_POLE, F(7, 24), F(-19, 6), F(1, 60), F(100, 3)):
            assert_encloses(arb.gamma_fmpq(to_fmpq(number)), reference(mpmath.gamma, number), bits - 16)
        for number in _ANY:
            assert_encloses(arb.sin_pi_fmpq(to_fmpq(number)), reference(mpmath.sinpi, number), bits - 16)
        for count in (0, 1, 5, 20, 21, 100):
            assert_encloses(arb.fac_ui(count), Fraction(math.factorial(count)), bits - 8)
        for number, count in itertools.product((F(1, 3), F(-5), F(-7, 2), F(10**9)), (0, 1, 2, 7, 30)):
            product = math.prod((number + j for j in range(count)), start=F(1))
            assert_encloses(arb.rising_fmpq_ui(to_fmpq(number), count), product, bits - 12)
            assert_encloses(arb(to_fmpq(number)).rising(count), product)


@covers("hypgeom")
def test_hypergeometric_series() -> None:
    cases = [
        ([F(1, 3)], [F(2, 3)], F(7, 2)),
        ([F(-1, 6)], [F(1, 3), F(2, 3)], F(-5)),
        ([F(1, 2), F(1, 3)], [F(2, 3), F(4, 3), F(1, 5)], F(12)),
        ([], [F(1, 3)], F(-9, 4)),
        ([F(1, 3), F(1, 4)], [F(5, 7)], F(1, 2)),
    ]
    for (above, below, at), bits in itertools.product(cases, (64, 200)):
        expected = reference(lambda z, a=above, b=below: mpmath.hyper([mp(x) for x in a], [mp(x) for x in b], z), at)
        with working_bits(bits):
            value = arb(to_fmpq(at)).hypgeom([arb(to_fmpq(x)) for x in above], [arb(to_fmpq(x)) for x in below])
        assert_encloses(value, expected, bits - 40)


@covers("atan2")
def test_angles_of_points() -> None:
    numbers = (F(0), F(1), F(-1), F(1, 3), F(-22, 7), F(10**9), F(-1, 10**9))
    for (sine, cosine), bits in itertools.product(itertools.product(numbers, repeat=2), (30, 64, 200)):
        expected = reference(lambda y, x: mpmath.atan2(y, x), sine, cosine)
        with working_bits(bits):
            assert_encloses(arb.atan2(arb(to_fmpq(sine)), arb(to_fmpq(cosine))), expected, bits - 10)


def test_real_powers() -> None:
    bases = (F(3), F(1, 7), F(10**6), F(22, 7))
    exponents = (F(0), F(1), F(1, 3), F(-7, 2), F(100, 3), F(-1, 10**15))
    for (base, exponent), bits in zip(itertools.product(bases, exponents), cycle_bits(), strict=False):
        expected = reference(lambda x, y=exponent: mpmath.power(x, mp(y)), base)
        with working_bits(bits):
            ball, power = arb(to_fmpq(base)), arb(to_fmpq(exponent))
            assert_encloses(ball**power, expected)
            assert_encloses(ball ** to_fmpq(exponent), expected)
            if base.denominator == 1:
                assert_encloses(int(base) ** power, expected)
        with working_bits(64):
            wide, span = arb(to_fmpq(base), to_fmpq(base / 100)), arb(to_fmpq(exponent), fmpq(1, 64))
            value = wide**span
        for x, y in itertools.product(three(wide), three(span)):
            assert_encloses(value, reference(lambda a, b=y: mpmath.power(a, mp(b)), x))


# Complex balls

_COMPLEX = [(F(1), F(0)), (F(1, 3), F(-2)), (F(-5, 2), F(1, 7)), (F(0), F(3)), (F(10**6), F(-1, 10**6))]


@covers("real", "imag")
def test_complex_arithmetic() -> None:
    for ((a, b), (c, d)), bits in zip(itertools.product(_COMPLEX, repeat=2), cycle_bits(), strict=False):
        norm = c * c + d * d
        with working_bits(bits):
            z, w = (acb(arb(to_fmpq(x)), arb(to_fmpq(y))) for x, y in ((a, b), (c, d)))
            results = [
                (z + w, a + c, b + d),
                (z - w, a - c, b - d),
                (z * w, a * c - b * d, a * d + b * c),
                (z / w if bits > 2 else None, (a * c + b * d) / norm, (b * c - a * d) / norm),
                (-z, -a, -b),
                (z * arb(to_fmpq(c)), a * c, b * c),
                (arb(to_fmpq(c)) * z, a * c, b * c),
                (z - 3, a - 3, b),
                (z / 3, a / 3, b / 3),
                (z * to_fmpq(d), a * d, b * d),
            ]
        for value, real, imaginary in results:
            if value is None:
                continue
            assert holds(value.real, real)
            assert holds(value.imag, imaginary)


@pytest.mark.parametrize("name", ["exp", "log", "sqrt"])
def test_complex_functions(name: str) -> None:
    for (a, b), bits in itertools.product(_COMPLEX[:4], (30, 64, 200)):
        with mpmath.mp.workprec(_MP_BITS):
            expected = getattr(mpmath, name)(mpmath.mpc(mp(a), mp(b)))
            real, imaginary = mp_fraction(expected.real), mp_fraction(expected.imag)
        with working_bits(bits):
            value = getattr(acb(arb(to_fmpq(a)), arb(to_fmpq(b))), name)()
        assert_encloses(value.real, real)
        assert_encloses(value.imag, imaginary)


def test_the_analytic_flag_refuses_the_branch_cut() -> None:
    crossing = [acb(make_ball((-2, 0), (1, -3)), make_ball((0, 0), (1, 0))), acb(make_ball((0, 0), (1, 0)), 0)]
    for box in crossing:
        for function in (acb.log, acb.sqrt):
            value = function(box, True)
            assert not (value.real.is_finite() and value.imag.is_finite())
    away = acb(make_ball((2, 0), (1, -3)), make_ball((0, 0), (1, 0)))
    assert away.log(True).real.is_finite()
    assert_encloses(away.log(True).real, reference(mpmath.log, F(2)))


def test_integrals() -> None:
    with working_bits(120):
        cases = [
            (lambda z, _: z * z * z - z, 0, 3, Fraction(81, 4) - Fraction(9, 2)),
            (lambda z, analytic: z.sqrt(analytic), 1, 4, Fraction(14, 3)),
            (lambda z, _: z.exp(), 0, 1, reference(mpmath.e.__add__, F(-1))),
            (lambda z, analytic: 1 / z.sqrt(analytic) if analytic else 1 / z.sqrt(), 1, 9, Fraction(4)),
            (lambda z, analytic: z.log(analytic), 1, 2, reference(mpmath.log, F(2)) * 2 - 1),
        ]
        for integrand, lower, upper, expected in cases:
            value = acb.integral(integrand, acb(lower), acb(upper), eval_limit=20_000)
            assert_encloses(value.real, expected, 60)
            assert holds(value.imag, 0)


@covers("nrows", "right_shift")
def test_rows_of_a_matrix_and_the_upper_part_of_a_polynomial() -> None:
    for rows, columns in ((1, 3), (4, 1), (5, 2)):
        assert arb_mat(rows, columns, [arb(1)] * (rows * columns)).nrows() == rows
    draw = random.Random(7)
    for _ in range(40):
        balls = [make_ball((draw.randint(-99, 99), -4), (1, -6)) for _ in range(6)]
        for shift in (0, 1, 4, 6, 9):
            upper = arb_poly(balls).right_shift(shift)
            assert upper.length() == max(0, 6 - shift)
            assert [ends(value) for value in upper.coeffs()] == [ends(value) for value in balls[shift:]]
