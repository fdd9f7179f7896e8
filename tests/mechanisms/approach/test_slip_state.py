"""The two components that y = v = 0 determine, against formulas by hand."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.mechanisms.approach.slip_state import StateError, slip_state
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits

OSCILLATOR = shipped_mechanism("frictional impact oscillator")


@pytest.mark.parametrize("bits", [64, 160, 400])
def test_the_oscillators_contact(bits: int) -> None:
    """psi = cos(phi) - 1, psi_dot = -sin(phi) phi_dot."""
    with working_bits(bits):
        found = slip_state(shift(OSCILLATOR), {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})
        phi = arb(fmpq(3, 5)).acos() + arb(fmpq(1, 10))
        assert found.solved == ("psi", "psi_dot")
        assert all(side.is_finite() and side.rad() < arb(2) ** (24 - bits) for side in found.box)
        assert found.box[0].contains(fmpq(1, 10))
        assert found.box[1].overlaps(phi.cos() - 1)
        assert found.box[3].overlaps(phi.sin() * fmpq(9, 10))


def test_an_angle_that_is_solved_for() -> None:
    """phi from psi = cos(phi) - 1: the solution next to the G-spot."""
    with working_bits(160):
        found = slip_state(shift(OSCILLATOR), {"psi": "-2/5", "phi_dot": "-1"})
        assert found.solved == ("phi", "psi_dot")
        assert found.box[0].contains(0)
        assert found.box[0].rad() < 1e-30
        assert found.box[3].contains(fmpq(4, 5))


def test_no_solution() -> None:
    with working_bits(100), pytest.raises(StateError, match="do not certainly determine phi and psi_dot"):
        slip_state(shift(OSCILLATOR), {"psi": "1", "phi_dot": "-1"})


def test_balls_are_taken_whole() -> None:
    with working_bits(100):
        found = slip_state(shift(OSCILLATOR), {"phi": "phi_ref", "psi": "-2/5", "phi_dot": "-1", "psi_dot": "4/5"})
        assert found.solved == ()
        assert found.box[0].contains(0)


@pytest.mark.parametrize(
    ("change", "part"),
    [
        ({"Z": 1}, "constraint 1 must be 0 in the state, it is 1"),
        ({"W": 1}, "constraint 2 must be 0"),
        ({"Z_dot": 1}, "the rate of constraint 1 must be 0"),
        ({"W_dot": 1}, "the rate of constraint 2 must be 0"),
    ],
)
def test_a_state_off_a_constraint_is_none(change: dict[str, int], part: str) -> None:
    """Z = X and W = 2 X, all at rest at 0, Y on the contact: given whole, or with Y and Y_dot to be solved for."""
    identity = [[int(i == j) for j in range(4)] for i in range(4)]
    tied = shift(
        lagrangian(
            "tied", ["X", "Y", "Z", "W"], identity, [0, 0, 0, 0], "X", "Y - X^2", 1, constraints=["Z - X", "W - 2*X"]
        )
    )
    state = dict.fromkeys(tied.mechanism.state, 0)
    short = {word: value for word, value in state.items() if word not in ("Y", "Y_dot")}
    with working_bits(100):
        assert slip_state(tied, state).solved == ()
        assert slip_state(tied, state).supposed == slip_state(tied, short).supposed == ()
        assert slip_state(tied, short).solved == ("Y", "Y_dot")
        perhaps = {"Z": "sin(1)^2 + cos(1)^2 - 1", "W_dot": "sin(2)^2 + cos(2)^2 - 1"}
        for given in (state, short):
            assert slip_state(tied, given | perhaps).supposed == ("constraint 1", "the rate of constraint 2")
        for given in (state, short):
            with pytest.raises(StateError, match=f"tied: {part}"):
                slip_state(tied, given | change)


def test_a_wide_state_has_a_wide_solution() -> None:
    """phi in a ball: psi = cos(phi) - 1 and psi_dot = -sin(phi) phi_dot for each of its numbers."""
    with working_bits(100):
        found = slip_state(shift(OSCILLATOR), {"phi": "phi_ref", "phi_dot": "-1"})
        assert found.box[1].overlaps(arb(-2) / 5)


@pytest.mark.parametrize(("word", "name"), [("psi", "y"), ("psi_dot", "v")])
@pytest.mark.parametrize("off", ["1/1000000", "-1"])
def test_a_full_state_off_the_contact_is_none(word: str, name: str, off: str) -> None:
    state = {"phi": "phi_ref", "psi": "-2/5", "phi_dot": "-1", "psi_dot": "4/5"}
    moved = str(fmpq(*map(int, (state[word]).split("/"))) + fmpq(*map(int, off.split("/"))))
    with working_bits(100), pytest.raises(StateError, match=f"not on the contact: {name} = .* must be 0"):
        slip_state(shift(OSCILLATOR), state | {word: moved})


@pytest.mark.parametrize("word", ["phi", "phi_dot"])
def test_a_component_that_is_too_large_for_a_ball_is_named(word: str) -> None:
    state = {"phi": "phi_ref", "phi_dot": "-1"} | {word: "exp(exp(exp(100)))"}
    for given in (state, state | {"psi": "-2/5", "psi_dot": "4/5"}):
        with working_bits(100), pytest.raises(StateError, match=f"{word} is not finite"):
            slip_state(shift(OSCILLATOR), given)


@pytest.mark.parametrize("given", [("phi",), ("phi", "psi", "phi_dot"), ()])
def test_two_components_or_none_may_be_missing(given: tuple[str, ...]) -> None:
    state = {"phi": "phi_ref", "psi": "-2/5", "phi_dot": "-1"}
    with pytest.raises(StateError, match=r"give all components of the state, or all but the two .* missing: p"):
        slip_state(shift(OSCILLATOR), {word: state[word] for word in given})


def test_a_full_state_is_on_the_contact_exactly_or_that_is_said() -> None:
    """psi = cos(phi) - 1 cut after 50 digits lies 10^-50 off the contact, and the balls do not see it."""
    state = {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}
    with working_bits(400):
        solved = slip_state(shift(OSCILLATOR), state)
        assert solved.supposed == ()
        digits = {
            word: solved.box[OSCILLATOR.state.index(word)].mid().str(50, radius=False) for word in ("psi", "psi_dot")
        }
    with working_bits(160):
        assert slip_state(shift(OSCILLATOR), state | digits).supposed == ("y", "v")
    with working_bits(400), pytest.raises(StateError, match="not on the contact"):
        slip_state(shift(OSCILLATOR), state | digits)
    model = shift(shipped_mechanism("model system"))
    with working_bits(160):
        exact = {word: {"u": 3, "p": "1/2", "b": -2}.get(word, 0) for word in model.mechanism.state}
        assert slip_state(model, exact).supposed == ()
