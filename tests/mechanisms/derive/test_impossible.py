"""What no mechanism can have is refused when it is loaded; what may be is not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.input.given import from_energies, from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_names

DATA = Path(__file__).parents[3] / "gspot_verified" / "mechanisms" / "data"


@pytest.mark.parametrize(
    ("name", "parameters", "message"),
    [
        ("rod", {"mu": "-1/2"}, "friction coefficient mu is -0.5: it must not be negative"),
        ("rod", {"mu": "-1e-30"}, "friction coefficient mu is -1.00000e-30"),
        ("rod", {"m": -1}, "the mass m is -1: it must not be negative"),
        ("rod", {"m": 0}, r"not positive definite: its entry \(1, 1\) is 0; it depends on m$"),
        ("rod", {"l": 0}, r"its entry \(3, 3\) is 0; it depends on m, l$"),
        ("frictional_impact_oscillator_all_parameters", {"m_2": "-1/2"}, "the mass m_2 is -0.5"),
        ("frictional_impact_oscillator_all_parameters", {"m_1": "-1/2"}, "the mass m_1 is -0.5"),
        ("frictional_impact_oscillator_all_parameters", {"m_1": 0, "m_2": 0}, r"its entry \(1, 1\) is 0"),
    ],
)
def test_what_cannot_be_is_refused_with_its_name(name: str, parameters: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        load(name, **parameters)


@pytest.mark.parametrize("name", shipped_names())
def test_every_shipped_mechanism_may_be(name: str) -> None:
    assert load(name).name == name


@pytest.mark.parametrize(
    ("name", "parameters"),
    [
        ("rod", {"mu": 0}),
        ("rod", {"g": -1}),
        ("rod", {"l": -1}),
        ("rod", {"mu": None, "m": None}),
        ("oscillator", {"c_psi": -3, "k_psi": -1, "offset": -2}),
        ("frictional_impact_oscillator_all_parameters", {"m_2": 0}),
        ("extended", {"alpha_1": 1, "alpha_3": 5, "chi": -7}),
    ],
)
def test_what_may_be_is_not_refused(name: str, parameters: dict[str, Any]) -> None:
    """A massless slider, a rod drawn to the other side, a force upwards, negative damping: all have motions."""
    load(name, **parameters)


def test_the_message_names_the_file(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text((DATA / "falling_rod.toml").read_text("utf-8").replace("m = 1\n", "m = -2\n"), encoding="utf-8")
    with pytest.raises(MechanismError, match=rf"^{path}: falling rod: the mass m is -2"):
        load(path)
    assert load(path, m=2).name == "falling rod, m = 2"


def block(matrix: list[list[Any]], mu: Any = 1, place: dict[str, Any] | None = None, **options: Any) -> Mechanism:
    return lagrangian("block", ["X", "Y"], matrix, [0, -1], "X", "Y", mu, place=place, **options)


def test_a_matrix_that_is_nowhere_positive_definite() -> None:
    for matrix, what in (
        ([[1, 2], [2, 1]], r"its leading minor of size 2 is -3$"),
        ([[1, 1], [1, 1]], r"its leading minor of size 2 is 0$"),
        ([[1, "sin(X)"], ["sin(X)", "-2"]], r"its entry \(2, 2\) is -2$"),
    ):
        with pytest.raises(MechanismError, match=what):
            refuse_impossible(block(matrix))
    refuse_impossible(block([[1, "2*sin(X)"], ["2*sin(X)", 1]]))  # at some X it is


def test_at_the_place_it_is_known_what_the_state_decides() -> None:
    matrix: list[list[Any]] = [[1, "2*sin(X)"], ["2*sin(X)", 1]]
    refuse_impossible(block(matrix, place={"X": 0}))
    with pytest.raises(MechanismError, match=r"not positive definite at the place of the G-spot: its leading minor"):
        refuse_impossible(block(matrix, place={"X": 1}))
    refuse_impossible(block(matrix, place={"X": 1}, search=True))  # a start, no state
    with pytest.raises(MechanismError, match=r"mu is -0\.841471 at the place of the G-spot: it must not be negative"):
        refuse_impossible(block([[1, 0], [0, 1]], "-sin(X)", {"X": 1}))
    with pytest.raises(MechanismError, match=r"mu is -3\.14159: it must not be negative"):
        refuse_impossible(block([[1, 0], [0, 1]], "-pi"))
    refuse_impossible(block([[1, 0], [0, 1]], "-sin(X)", {"X": -1}))
    refuse_impossible(block([[1, 0], [0, 1]], "-sin(X)"))


def test_an_angle_counts_from_its_reference() -> None:
    def tilted(deviation: str) -> Mechanism:
        return lagrangian(
            "tilted", ["phi"], [[1]], [0], "phi", "sin(phi)", "-sin(phi)", None, {"phi": ("-3/5", "4/5")},
            {"phi": f"phi_ref + {deviation}"},
        )  # fmt: skip

    refuse_impossible(tilted("0"))
    with pytest.raises(MechanismError, match=r"mu is -0\.0294946 at the place"):
        refuse_impossible(tilted("0.673"))


def test_only_a_mass_by_its_name_and_in_the_mass_matrix() -> None:
    """A negative parameter that is added to a mass is no mass; one with the name of a mass elsewhere is none either."""

    def energies(name: str, where: str) -> Mechanism:
        kinetic, potential = (
            ("(2 + {0})*(X_dot^2 + Y_dot^2)/2", "Y") if where == "T" else ("X_dot^2 + Y_dot^2", "{0}*Y")
        )
        return from_energies(
            "fall", ["X", "Y"], kinetic.format(name), potential.format(name), "X", "Y", 1, {name: "-1/3"}
        )

    for name in ("m", "M_2", "mass", "mass_of_arm", "I", "J1", "inertia", "m3"):
        with pytest.raises(MechanismError, match=f"the mass {name} is "):
            refuse_impossible(energies(name, "T"))
        refuse_impossible(energies(name, "V"))
    for name in ("offset", "delta", "k", "mill", "ml", "Im"):
        refuse_impossible(energies(name, "T"))


def test_fields_are_asked_too() -> None:
    def fields(m: str, mu: str) -> Mechanism:
        return from_fields(
            "fall", ["y", "v"], ["v", -1], [0, 0], [0, "1/m"], "0", "y", mu, {"m": m, "k": "-m"}, place={"y": 0, "v": 0}
        )

    refuse_impossible(fields("2", "1"))
    with pytest.raises(MechanismError, match="the mass m is -2"):
        refuse_impossible(fields("-2", "1"))
    with pytest.raises(MechanismError, match="mu is -2"):
        refuse_impossible(fields("2", "k"))
