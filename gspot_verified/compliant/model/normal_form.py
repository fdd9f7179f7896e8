"""The compliant model (paper, modelsys1-modelsys5 with compl2) in its normal form, exactly.

Proof page: ``proofs/exact_solution.md``, section 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.numbers.written import Written

LEAST_EPSILON = fmpq(10) ** -300  # of epsilon |alpha_1|: slow_solution.py goes as far down
MAX_EPSILON = 10**6  # of epsilon |alpha_1|: slow_solution.py goes as far up
MAX_BETA = 100  # a limit of input: ValueError beyond it


@dataclass(frozen=True, slots=True)
class CompliantModel(Written):
    """alpha_1, alpha_2, alpha_3 and epsilon of the model; make it with :func:`compliant_model`."""

    written: ClassVar[str] = "alpha_1 alpha_2 alpha_3 epsilon beta"

    alpha_1: fmpq
    alpha_2: fmpq
    alpha_3: fmpq
    epsilon: fmpq

    @property
    def beta(self) -> fmpq:
        """alpha_3/alpha_1."""
        return self.alpha_3 / self.alpha_1

    @property
    def numbers(self) -> str:
        """beta and the alphas, as an output names them."""
        return f"β = {self.beta}, α_1 = {self.alpha_1}, α_2 = {self.alpha_2}"

    @property
    def sigma(self) -> fmpq:
        """1/|alpha_1|, the unit of time of the normal form."""
        return -1 / self.alpha_1

    @property
    def scaled_epsilon(self) -> fmpq:
        """epsilon in the normal form, epsilon |alpha_1|."""
        return self.epsilon / self.sigma

    @property
    def mean_force(self) -> fmpq:
        """lambda on the trivial solution, alpha_2/(alpha_3 - alpha_1); beta is not 1."""
        return self.alpha_2 / (self.alpha_3 - self.alpha_1)


@dataclass(frozen=True, slots=True)
class CompliantState(Written):
    """p, b, y, v, z of the paper, in its units; in contact when y < z."""

    p: fmpq
    b: fmpq
    y: fmpq
    v: fmpq
    z: fmpq


@dataclass(frozen=True, slots=True)
class Deviation:
    """A state in contact in the normal form, as its difference from the trivial solution (hats on the page).

    ``p`` is p, so T = -p/epsilon; b, V, Y, Z are b-hat, V-hat, Y-hat, Z-hat; lambda-hat = Z - Y.
    """

    beta: fmpq
    epsilon: fmpq
    p: fmpq
    b: fmpq
    V: fmpq
    Y: fmpq
    Z: fmpq

    @property
    def force(self) -> fmpq:
        """lambda-hat = Z-hat - Y-hat, in the units of the normal form (times |alpha_1|^2: those of the paper)."""
        return self.Z - self.Y

    @property
    def time(self) -> fmpq:
        """T = -p/epsilon."""
        return -self.p / self.epsilon


def compliant_model(
    beta: ExactInput | None = None,
    epsilon: ExactInput = "1/1000",
    *,
    alpha_1: ExactInput = -1,
    alpha_2: ExactInput = -1,
    alpha_3: ExactInput | None = None,
) -> CompliantModel:
    """The model from beta (then alpha_3 = beta alpha_1) or from the alphas.

    :raises TypeError: a float.
    :raises ValueError: a ball; alpha_1 or alpha_3 not negative; both beta and alpha_3, in contradiction, or neither;
        beta = 1 (no trivial solution) or beta > 100; epsilon |alpha_1| not in [10^-300, 10^6].

    >>> compliant_model("5/2", "1/100", alpha_1=-2).alpha_3
    -5
    """
    first, second = rational(alpha_1, "alpha_1"), rational(alpha_2, "alpha_2")
    small = rational(epsilon, "epsilon")
    given = None if beta is None else rational(beta, "beta")
    third = None if alpha_3 is None else rational(alpha_3, "alpha_3")
    if third is None:
        if given is None:
            raise ValueError("beta: give beta or alpha_3")
        third = given * first
    if first >= 0:
        raise ValueError(f"alpha_1: expected a number < 0, got {first}")
    if third >= 0:
        raise ValueError(f"alpha_3 = beta alpha_1: expected a number < 0, got {third}")
    if given is not None and given != third / first:
        raise ValueError(f"beta: {given} was given, but alpha_3/alpha_1 = {third / first}")
    if third == first or third / first > MAX_BETA:
        raise ValueError(f"beta: expected a number in (0, {MAX_BETA}] other than 1, got {third / first}")
    model = CompliantModel(first, second, third, small)
    if not (small > 0 and LEAST_EPSILON <= model.scaled_epsilon <= MAX_EPSILON):
        raise ValueError(f"epsilon: expected epsilon |alpha_1| in [1e-300, {MAX_EPSILON}], got {small}")
    return model


def compliant_state(p: ExactInput, b: ExactInput, y: ExactInput, v: ExactInput, z: ExactInput) -> CompliantState:
    """A state of the model, in contact.

    :raises TypeError: a float.
    :raises ValueError: a ball; z <= y (not in contact: the contact force would not be positive).

    >>> compliant_state("1/2", -1, "-1e-6", 0, "-5e-7").y
    -1/1000000
    """
    values = [rational(value, name) for value, name in zip((p, b, y, v, z), "pbyvz", strict=True)]
    state = CompliantState(*values)
    if state.z <= state.y:
        raise ValueError(f"y, z: in contact y < z, got y = {state.y}, z = {state.z}")
    return state


def deviation(model: CompliantModel, state: CompliantState) -> Deviation:
    """The state in the normal form, minus the trivial solution at the same p.

    >>> model = compliant_model("5/2", "1/100")
    >>> trivial = compliant_state("1/2", "-1/3", "-1/7500", 0, "-1/15000")
    >>> deviation(model, trivial).b, deviation(model, trivial).Y
    (0, 0)
    """
    sigma, epsilon = model.sigma, model.scaled_epsilon
    mean = model.mean_force * sigma**2
    return Deviation(
        model.beta,
        epsilon,
        state.p,
        state.b * sigma**2 + state.p * mean,
        state.v * sigma / epsilon,
        state.y / epsilon**2 + 2 * mean,
        state.z / epsilon**2 + mean,
    )
