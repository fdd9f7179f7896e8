"""Functions that are derived once for many values of parameters say what those of each value say."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, arb_series

from gspot_verified import MechanismError, load
from gspot_verified.functions.expressions import Variable
from gspot_verified.integrator.norm_steps.taylor_curve import TaylorCurve
from gspot_verified.mechanisms.approach.slip_programs import slip_programs
from gspot_verified.mechanisms.approach.slip_state import slip_state
from gspot_verified.mechanisms.derive.shared_derivation import shared_derivation, with_numbers
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import add_remainder, series_length, working_bits

STATE = {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"}


def shared(mechanism: Mechanism, *parameters: str) -> Shifted:
    found = shared_derivation(mechanism, parameters)
    assert found is not None
    return found


def test_programs_with_numbers_enclose_what_those_of_each_value_enclose() -> None:
    """Values, derivatives, series and Taylor coefficients; several values one after the other, and the first again."""
    rod = load("rod")
    common = shared(rod, "mu", "l")
    for values in ({"mu": "2", "l": "1"}, {"mu": "7/3", "l": "3/2"}, {"mu": "2", "l": "1"}):
        mechanism = rod.with_parameters(**values)
        own = shift(mechanism)
        with working_bits(100):
            both = [
                (slip_programs(each), slip_state(each, STATE).box) for each in (with_numbers(common, mechanism), own)
            ]
            (first, box), (second, other) = both
            for side, expected in zip(box, other, strict=True):
                assert side.is_finite()
                assert side.overlaps(expected)
            wide = [add_remainder(side, arb((1, -20))) for side in box]
            found, known = first.numbers.on(wide), second.numbers.on(wide)
            for a, b in zip(
                (found.p, found.b, *found.F, *found.G), (known.p, known.b, *known.F, *known.G), strict=True
            ):
                assert a.is_finite()
                assert a.overlaps(b)
            assert not isinstance(first.hypotheses.checked(wide), str)
            states = [*wide, arb(0)]
            for field, direct in ((first.desingularised, second.desingularised), (first.by_p, second.by_p)):
                for row, expected_row in zip(field.on_box(states)[1], direct.on_box(states)[1], strict=True):
                    for a, b in zip(row, expected_row, strict=True):
                        assert a.is_finite()
                        assert a.overlaps(b)
                with series_length(4):
                    curve = [arb_series([side, 1], 4) for side in states]
                    for f, g in zip(field.series(curve), direct.series(curve), strict=True):
                        for a, b in zip(f.coeffs(), g.coeffs(), strict=False):
                            assert a.is_finite()
                            assert a.overlaps(b)
            lengths = [
                TaylorCurve(field).advance([*box, arb(0)], None, 0)
                for field in (first.desingularised, second.desingularised)
            ]
            assert abs(float(lengths[0][0]) - float(lengths[1][0])) < 1e-6
            for p, q in zip(lengths[0][1], lengths[1][1], strict=True):
                assert abs(p(arb(1)) - q(arb(1))) < 1e-6


def test_without_numbers_nothing_is_known() -> None:
    common = shared(load("rod"), "mu")
    with working_bits(64):
        programs = slip_programs(common)
        box = [arb(0), arb(1), arb(0), arb(2), arb(0), arb(0)]
        assert not programs.numbers.on(box).p.is_finite()
        assert isinstance(programs.hypotheses.checked(box), str)


def test_where_nothing_can_be_derived_nothing_is_shared() -> None:
    """A friction coefficient that depends on a velocity."""
    rod = load("rod")
    assert shared_derivation(replace(rod, mu=Variable(3)), ("mu",)) is None


def test_a_divisor_that_the_derivation_loses_is_refused_where_it_vanishes() -> None:
    """mu j/k with j = k is mu for every k but 0."""
    rod = load("rod")
    words = {name: Symbol(name) for name in ("mu", "j", "k")}
    more = (("k", parse_formula("1", {})), ("j", Symbol("k")))
    odd = replace(rod, mu=parse_formula("mu*j/k", words), parameters=(*rod.parameters, *more))
    common = shared(odd, "k")
    assert common.functions.mu == shift(rod).functions.mu
    with_numbers(common, odd.with_parameters(k=2))
    nothing = odd.with_parameters(k=0)
    with pytest.raises(MechanismError):
        shift(nothing)
    with pytest.raises(MechanismError, match="with the values of the parameters"):
        with_numbers(common, nothing)


def test_a_number_that_is_no_rational_is_not_put_in() -> None:
    rod = load("rod")
    odd = replace(
        rod, parameters=tuple((n, parse_formula("sqrt(2)", {}) if n == "l" else v) for n, v in rod.parameters)
    )
    with_one = with_numbers(shared(rod, "l", "mu"), odd)
    assert [name for name, _ in with_one.numbers] == ["mu"]
    with working_bits(64):
        assert not slip_programs(with_one).numbers.on([arb(0), arb(1), arb(0), arb(2), arb(0), arb(0)]).p.is_finite()
