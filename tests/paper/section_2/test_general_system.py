"""What forces change at once: a sum over coordinates and velocities, and a rod."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_2 import general_system as ledger


def test_accelerations_alone_are_changed_at_once() -> None:
    assert ledger.of_two_coordinates() is True
    assert ledger.of_each_coordinate() is True
    assert not ledger.painleve_parameter().is_zero()


@pytest.mark.parametrize(
    ("target", "name", "text"),
    [
        ("MOTION", "q1", "w1 + lam"),
        ("MOTION", "q2", "w2 - lamT"),
        ("SLOPES", "x", ("t1", "t2", "1", "0")),
        ("SLOPES", "y", ("n1", "n2", "0", "yt")),
        ("FRICTION", "mu", "mu + w1"),  # a coefficient of friction that changes with the velocity
        ("NORMAL", "v", "n1*w1^2 + n2*w2 + yt"),
    ],
)
def test_what_depends_on_a_velocity_is_changed_at_once(
    monkeypatch: pytest.MonkeyPatch, target: str, name: str, text: str | tuple[str, ...]
) -> None:
    monkeypatch.setitem(getattr(ledger, target), name, text)
    assert ledger.of_two_coordinates() is False
    assert ledger.of_each_coordinate() is False


def test_p_is_that_of_the_projected_equations() -> None:
    """det M times C - μB with B and C as inner products of the gradients."""
    read = ledger.MECHANISM.read
    c = "m22*n1^2 - 2*m12*n1*n2 + m11*n2^2"
    b = "m22*n1*t1 - m12*(n1*t2 + n2*t1) + m11*n2*t2"
    assert ledger.painleve_parameter() == read(f"{c} - mu*({b})")


@pytest.mark.parametrize("force", ["T", "N"])
@pytest.mark.parametrize("place", ["x", "y"])
def test_a_place_with_a_velocity_in_it_is_changed_at_once(
    monkeypatch: pytest.MonkeyPatch, force: str, place: str
) -> None:
    assert ledger.of_the_rod() is True
    speed = {"T": "U", "N": "W"}[force]
    monkeypatch.setitem(ledger.PLACES, place, f"{ledger.PLACES[place]} + {speed}")
    assert ledger.of_the_rod() is False


def test_the_forces_are_those_of_the_motion_in_slip(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ledger.FORCES["T"], "w", "k*s")
    assert ledger.of_the_rod() is False


@pytest.mark.parametrize(
    ("target", "name", "text"),
    [
        ("MOTION", "w1", "m22*(f1 + t1*lamT + n1*lam) - m11*(f2 + t2*lamT + n2*lam)"),  # no symmetric mass matrix
        ("MOTION", "w2", "m11*(f2 + t2*lamT + n2*lam^2) - m12*(f1 + t1*lamT + n1*lam)"),
        ("MOTION", "q1", "w1 + lam"),
        ("TANGENTIAL", "u", "n1*w1 + t2*w2 + xt"),
    ],
)
def test_one_b_needs_a_symmetric_mass_matrix(
    monkeypatch: pytest.MonkeyPatch, target: str, name: str, text: str
) -> None:
    assert ledger.one_coefficient() is True
    monkeypatch.setitem(getattr(ledger, target), name, text)
    assert ledger.one_coefficient() is False


def test_one_b_needs_forces_that_stand_linearly(monkeypatch: pytest.MonkeyPatch) -> None:
    """A push along the direction that does not change u: B is one, and v' has λ_N²."""
    for name, extra in (("w1", "- t2*lam^2"), ("w2", "+ t1*lam^2")):
        monkeypatch.setitem(ledger.MOTION, name, f"{ledger.MOTION[name]} {extra}")
    assert ledger.one_coefficient() is False


def test_one_b_of_the_rod(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.one_coefficient_of_the_rod() is True
    monkeypatch.setitem(ledger.FORCES["N"], "w", "-k*s")
    assert ledger.one_coefficient_of_the_rod() is False


def test_one_b_coordinate_by_coordinate(monkeypatch: pytest.MonkeyPatch) -> None:
    """Any number of coordinates: the parts of u' and v' of one of them, where M is diagonal."""
    assert ledger.one_coefficient_of_each() is True
    honest = ledger.MOTION["w1"]
    for wrong in ("2*n1*lam", "n1*lam^2", "n1*lam + lam*lamT"):
        monkeypatch.setitem(ledger.MOTION, "w1", honest.replace("n1*lam", wrong))
        assert ledger.one_coefficient_of_each() is False
    monkeypatch.setitem(ledger.MOTION, "w1", f"{honest} + (n1*lam + t1*lamT)^2")  # one B, and not linear
    assert ledger.one_coefficient_of_each() is False
    monkeypatch.setitem(ledger.MOTION, "w1", "m22*(f1 + n1*lam^2)")
    monkeypatch.setitem(ledger.TANGENTIAL, "u", "t2*w2 + xt")  # in v' alone
    assert ledger.one_coefficient_of_each() is False


def test_a_factor_of_a_force_has_no_velocity(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.one_coefficient_of_each() is True
    honest = ledger.MOTION["w1"]
    monkeypatch.setitem(ledger.MOTION, "w1", honest.replace("t1*lamT", "t1*w1*lamT").replace("n1*lam)", "n1*w1*lam)"))
    assert ledger.one_coefficient_of_each() is False
