"""Formulas as texts: read as exact closed forms, evaluated in balls, and compared with what a route gives.

The notation is that of FLINT with Gamma(...), fac(...) and sqrt(...): "3^(1-beta/3)*Gamma(1+beta)". A text is both what
is proved (as a closed form, for all values of its symbols) and what is evaluated (at points), so the two routes speak
of the same formula.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from flint import acb, arb, fmpq, fmpq_mpoly

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.checks.closed_forms import ALGEBRA, ClosedForm, gamma, power, rational
from gspot_verified.paper.checks.entry import Check, Rung
from gspot_verified.paper.checks.identities import in_greek

Number = fmpq | arb | acb
Forms = Mapping[str, ClosedForm]
Route = Callable[[Forms], Sequence[ClosedForm]]
"""From the formulas of a claim, by name, to quotients."""


@lru_cache(maxsize=512)
def closed_form(text: str) -> ClosedForm:
    """The closed form that a text says.

    :raises ValueError: it is not one: a sum of terms whose quotient is not rational, or a power of a sum.

    >>> (closed_form("Gamma(-beta)*beta") / closed_form("Gamma(1-beta)")).factor
    -1
    """
    return _form(_tree(text))


def put(text: str, **images: str) -> str:
    """The text with texts in place of some symbols, all at once.

    >>> put("x^beta", beta="beta-1")
    '(x)^(beta-1)'
    """
    names = "|".join(map(re.escape, {**images, "x": "x"}))
    return re.sub(rf"\b({names})\b", lambda found: f"({images.get(found[1], found[1])})", text)


def evaluate_text(text: str, values: Mapping[str, Number], bits: int) -> acb:
    """The formula in balls, exact before it is rounded once where all is rational. 1/Γ is 0 at a pole of Γ."""
    with working_bits(bits):
        return acb(_number(_tree(text), {**values, "pi": arb.pi(), "e": arb(1).exp(), "i": acb(0, 1)}))


def quotient(first: ClosedForm, second: ClosedForm) -> ClosedForm:
    """first/second; 1 when both are 0 and 0 when only one is: it is 1 when they are equal."""
    if first.is_zero() or second.is_zero():
        return rational(int(first.is_zero() and second.is_zero()))
    return first / second


def mended(printed: bool | None, corrected: bool | None) -> bool | None:
    """The answer for the printed form, when the corrected form stands the same check; else a failure is open."""
    return None if printed is False and corrected is not True else printed


def rational_value(text: str, **values: fmpq | int) -> fmpq:
    """A formula without irrational numbers at rational values of its symbols, exactly.

    :raises ValueError: the value is not rational.

    >>> rational_value("2*n-1", n=3)
    5
    """
    found = _number(_tree(text), {name: fmpq(value) for name, value in values.items()})
    if not isinstance(found, fmpq):
        raise ValueError(f"{text} is not rational")
    return found


@dataclass(frozen=True)
class FormulaClaim:
    """Formulas as printed, and in the corrected form where the printed one fails."""

    printed: Mapping[str, str]
    corrected: Mapping[str, str] = field(default_factory=dict)

    def under(self, **images: str) -> FormulaClaim:
        """The claim under hypotheses: symbols replaced by texts in positive symbols; beta="u" says β > 0."""
        return FormulaClaim(
            {name: put(text, **images) for name, text in self.printed.items()},
            {name: put(text, **images) for name, text in self.corrected.items()},
        )

    def check(self, what: str, route: Route, rung: Rung = Rung.EXACT, finding: str = "") -> Check:
        """Whether every quotient of the route is 1. A failure needs the corrected form, if there is one, to give 1.

        A quotient that is another rational function fails; with powers or Γ left over the answer is open.
        """
        return self._check(what, route, rung, _is_one, "1", finding)

    def check_sign(self, what: str, route: Route, rung: Rung = Rung.EXACT, finding: str = "") -> Check:
        """Whether every quotient of the route is positive; where no sign is proved the answer is open."""
        signs = {1: True, -1: False, None: None}
        return self._check(what, route, rung, lambda found: signs[found.sign()], "positive", finding)

    def _check(
        self, what: str, route: Route, rung: Rung, holds: Callable[[ClosedForm], bool | None], wanted: str, finding: str
    ) -> Check:
        return Check(rung, what, *self._answer(route, holds, wanted, finding))

    def _answer(
        self, route: Route, holds: Callable[[ClosedForm], bool | None], wanted: str, finding: str
    ) -> tuple[bool | None, str]:
        found = _first_failure(route, self.printed, holds)
        if found is None:
            return True, ""
        answer, value = found
        if answer is None:
            return None, f"open: {value}"
        if self.corrected and _first_failure(route, {**self.printed, **self.corrected}, holds) is not None:
            return None, "the printed and the corrected form fail"
        repair = f"; with the corrected form it is {wanted}" if self.corrected else ""
        return False, finding or f"the quotient is {in_greek(value)}, not {wanted}{repair}"


def _is_one(form: ClosedForm) -> bool | None:
    return form.is_one() if form.is_rational() else None


def _first_failure(
    route: Route, texts: Mapping[str, str], holds: Callable[[ClosedForm], bool | None]
) -> tuple[bool | None, str] | None:
    found = route({name: closed_form(text) for name, text in texts.items()})
    if not found:
        return None, "nothing was checked"
    answers = [(holds(value), str(value)) for value in found]
    failures = [pair for pair in answers if pair[0] is not True]
    return min(failures, key=lambda pair: pair[0] is None) if failures else None


@lru_cache(maxsize=512)
def _tree(text: str) -> ast.expr:
    return ast.parse(text.replace("^", "**"), mode="eval").body


def _polynomial(node: ast.expr) -> fmpq_mpoly:
    return ALGEBRA.read(ast.unparse(node).replace("**", "^"))


def _form(node: ast.expr) -> ClosedForm:
    match node:
        case ast.Constant(value=int(value)):
            return rational(value)
        case ast.Name(id=name):
            return power(name, ALGEBRA.constant(1))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return rational(-1) * _form(operand)
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return _form(left) * _form(right)
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            return _form(left) / _form(right)
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return _form(left) + _form(right)
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return _form(left) + rational(-1) * _form(right)
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            return _power(left, _polynomial(right))
        case ast.Call(func=ast.Name(id="Gamma"), args=[argument]):
            return gamma(_polynomial(argument))
        case ast.Call(func=ast.Name(id="fac"), args=[argument]):
            return gamma(_polynomial(argument) + 1)
        case ast.Call(func=ast.Name(id="sqrt"), args=[argument]):
            return _power(argument, ALGEBRA.constant(fmpq(1, 2)))
    raise ValueError(f"not a closed form: {ast.unparse(node)}")


def _power(base: ast.expr, exponent: fmpq_mpoly) -> ClosedForm:
    match base:
        case ast.Constant(value=int(value)) if value > 0:
            return power(str(value), exponent)
        case ast.Name(id=name):
            return power(name, exponent)
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)):
            return power("-1", exponent)
        case ast.BinOp(left=left, op=ast.Mult() | ast.Div() as operation, right=right) if not exponent.is_constant():
            first, second = _power(left, exponent), _power(right, exponent)
            return first * second if isinstance(operation, ast.Mult) else first / second
    number = exponent.leading_coefficient() if not exponent.is_zero() else fmpq(0)
    if not exponent.is_constant() or number.q != 1:
        raise ValueError(f"a power of {ast.unparse(base)} with the exponent {exponent}")
    return _form(base) ** int(number.p)


def _number(node: ast.expr, values: Mapping[str, Number]) -> Number:
    """Exact as long as all numbers are rational."""
    match node:
        case ast.Constant(value=int(value)):
            return fmpq(value)
        case ast.Name(id=name):
            return values[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_number(operand, values)
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            below = _reciprocal(right, values)
            return _number(left, values) / _number(right, values) if below is None else _number(left, values) * below
        case ast.BinOp(left=left, op=operation, right=right):
            first, second = _number(left, values), _number(right, values)
            match operation:
                case ast.Mult():
                    return first * second
                case ast.Add():
                    return first + second
                case ast.Sub():
                    return first - second
                case ast.Pow():
                    return _raised(first, second)
        case ast.Call(func=ast.Name(id="Gamma"), args=[argument]):
            return acb(_number(argument, values)).gamma()
        case ast.Call(func=ast.Name(id="fac"), args=[argument]):
            return acb(_number(argument, values) + 1).gamma()
        case ast.Call(func=ast.Name(id="sqrt"), args=[argument]):
            return acb(_number(argument, values)).sqrt()
    raise ValueError(f"not a formula: {ast.unparse(node)}")


def _raised(base: Number, exponent: Number) -> Number:
    if isinstance(exponent, fmpq) and exponent.q == 1:
        return base ** int(exponent.p)
    return acb(base) ** acb(exponent)


def _reciprocal(node: ast.expr, values: Mapping[str, Number]) -> Number | None:
    """1/Γ and its products with numbers; ``None`` for a number, by which one divides (exactly, where that is exact)."""
    match node:
        case ast.Call(func=ast.Name(id="Gamma"), args=[argument]):
            return acb(_number(argument, values)).rgamma()
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            first, second = _reciprocal(left, values), _reciprocal(right, values)
            if first is None and second is None:
                return None
            first = 1 / _number(left, values) if first is None else first
            return first / _number(right, values) if second is None else first * second
    return None
