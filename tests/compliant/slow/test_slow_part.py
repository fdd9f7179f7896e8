"""The slow part in all variables: it solves the equations of contact. Pages: proofs/fast_part.md, section 8."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.slow import slow_part as module
from gspot_verified.compliant.slow.slow_part import slow_part
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits

NAMES = ("b", "force", "V", "Z")


@pytest.mark.parametrize(("beta", "epsilon"), [(fmpq(5, 2), fmpq(1, 10)), (fmpq(1, 2), fmpq(2))])
@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(0), fmpq(-1, 3)])
def test_the_equations_of_contact(beta: fmpq, epsilon: fmpq, p: fmpq) -> None:
    """b' = epsilon beta lambda, V' = b + p lambda, Y' = V, Y = Z - lambda, Z' = -Z - lambda: by differences in T."""
    step = fmpq(1, 2**20)
    with working_bits(300):
        now, after, before = (slow_part(beta, epsilon, p - epsilon * s, NAMES, 200) for s in (fmpq(0), step, -step))

        def rate(name: str) -> arb:
            return (after[name] - before[name]) / (2 * step)

        force = now["force"]
        size = sum((abs(value) for value in now.values()), arb(0))
        for left, right in (
            (rate("b"), epsilon * beta * force),
            (rate("V"), now["b"] + p * force),
            (rate("Z") - rate("force"), now["V"]),
            (rate("Z"), -now["Z"] - force),
        ):
            assert abs(left - right) < size * 1e-10


def test_one_name_alone_is_the_same() -> None:
    """C = 1: b is F itself."""
    beta, epsilon, p = fmpq(5, 2), fmpq(1, 10), fmpq(1, 2)
    whole = slow_part(beta, epsilon, p, NAMES, 100)
    assert list(whole) == list(NAMES)
    for name in NAMES:
        (value,) = slow_part(beta, epsilon, p, (name,), 100).values()
        assert value.overlaps(whole[name])
        assert abs(value - whole[name]) < abs(value) * 1e-20
    assert whole["b"].overlaps(slow_value(-p / epsilon, beta, epsilon, 0, 40).value)


def test_no_more_digits_are_asked_for_than_there_are(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def value(*given: object) -> object:
        asked.append(int(str(given[-1])))
        return slow_value(fmpq(1), fmpq(5, 2), fmpq(1, 10), 0, 5)

    monkeypatch.setattr(module, "slow_value", value)
    for bits in (100, 10**6):
        slow_part(fmpq(5, 2), fmpq(1, 10), fmpq(1, 2), ("b",), bits)
    assert asked == [32, module.MAX_DIGITS]
