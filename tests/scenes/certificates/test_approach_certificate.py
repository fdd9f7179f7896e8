"""Certificates of approaches: mechanisms that have one, those that have none and why, provers that leave work out.

Page: proofs/approach_certificate.md.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import load
from gspot_verified.certificates.checker import check
from gspot_verified.certificates.text import write_text
from gspot_verified.cli.main import main
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.capture import Capture
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.numbers.balls import add_remainder, float_bounds, sign_of, working_bits
from gspot_verified.scenes.certificates import approach_certificate as module
from gspot_verified.scenes.certificates.approach_certificate import approach_certificate
from gspot_verified.scenes.certificates.bounded_step import NotBounded
from gspot_verified.scenes.certificates.polynomial_mechanism import NotPolynomial
from gspot_verified.scenes.certificates.polynomial_slip import PolynomialSlip

DATA = Path(__file__).resolve().parents[3] / "gspot_verified" / "mechanisms" / "data"
PAPER = {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}
ROD = {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"}
ACCEPTED: list[tuple[str, dict[str, Any], str | None, str, str]] = [
    ("rod", ROD, None, "x' > 0", "<"),
    ("oscillator", PAPER, "-1", "x' > -1", ""),
    ("genot_brogliato_rod.toml", {"X": 0, "X_dot": 2, "theta": "637/1000", "theta_dot": "87/50"}, "1", "x' > 1", "<"),
    ("gallery/ladder.toml", {"theta": "7/20", "theta_dot": "7/5"}, None, "which is not shown", "<"),
    ("gallery/rod_with_wrist.toml", {"X": 0, "X_dot": 5, "theta": "39/50", "theta_dot": "79/25"}, None, "x' > 0", "<"),
]


def place(name: str) -> Any:
    return DATA / name if name.endswith(".toml") else name


def checked(text: str, tmp_path: Path) -> str:
    write_text(tmp_path / "a.cert", text)
    return check(tmp_path / "a.cert").text


@pytest.mark.parametrize(("name", "state", "surface", "words", "sign"), ACCEPTED, ids=[name for name, *_ in ACCEPTED])
def test_a_mechanism_with_a_certificate(
    name: str, state: dict[str, Any], surface: str | None, words: str, sign: str, tmp_path: Path
) -> None:
    """The checker says what `approach` found by other steps, of other functions."""
    mechanism = load(place(name))
    text = approach_certificate(mechanism, state, surface_velocity=surface)
    said = checked(text, tmp_path)
    assert said.startswith("VERIFIED the mechanism M q'' = f")
    assert words in said
    assert re.findall("C_1 (.) 0", said) == [*sign]
    statement = json.loads(text.splitlines()[0])["statement"]
    found = approach(mechanism, state, surface_velocity=surface)
    assert found.end == "G-spot"
    assert found.time is not None
    assert found.alphas is not None
    assert found.beta is not None
    assert found.coefficient is not None
    time = float(Fraction(statement["time"]))
    assert time - 1e-4 < float_bounds(found.time)[0] <= float_bounds(found.time)[1] <= time
    for claim, value in zip([*statement["alpha"], statement["beta"]], [*found.alphas, found.beta], strict=True):
        low, high = (float(Fraction(end)) for end in claim)
        assert low - 1e-9 < float_bounds(value)[0] <= float_bounds(value)[1] < high + 1e-9
        assert high - low < 1e-3 * max(1, abs(low))
    if float_bounds(found.beta)[0] < 2:  # then the certificate says it
        assert sign == {-1: "<", 1: ">"}[sign_of(found.coefficient) or 0]


@pytest.mark.parametrize(("phi_dot", "sign"), [("-4/5", "<"), ("-9/10", ">")])
def test_the_side_for_beta_between_1_and_2(phi_dot: str, sign: str, tmp_path: Path) -> None:
    mechanism, state = load("oscillator", beta="3/2"), {"phi": "phi_ref + 1/20", "phi_dot": phi_dot}
    text = approach_certificate(mechanism, state, surface_velocity=-2)
    assert f"C_1 {sign} 0" in checked(text, tmp_path)
    found = approach(mechanism, state, surface_velocity=-2)
    assert found.coefficient is not None
    assert sign_of(found.coefficient) == (-1 if sign == "<" else 1)


def test_the_shipped_certificate_is_that_of_the_library() -> None:
    state = {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/10", "theta_dot": "9/10"}
    shipped = (DATA.parents[2] / "proofs" / "approach_rod.cert").read_text(encoding="utf-8")
    made, kept = (json.loads(text.splitlines()[0]) for text in (approach_certificate(load("rod"), state), shipped))
    (new, ours), (old, theirs) = (_taken_apart(head.pop("statement")) for head in (made, kept))
    assert (made, new) == (kept, old)
    assert len(ours) == len(theirs) == 8
    for one, other in zip(ours, theirs, strict=True):  # of the same numbers, by steps that floats choose
        assert max(one[0], other[0]) <= min(one[1], other[1])


def _taken_apart(statement: dict[str, Any]) -> tuple[dict[str, Any], list[list[Fraction]]]:
    """What does not depend on the steps, and the intervals of the rest."""
    place = statement.pop("place")
    del statement["time"]  # a bound: another run has another one
    intervals = [*statement.pop("alpha"), statement.pop("beta"), *place.values()]
    return {**statement, "place": [*place]}, [[Fraction(end) for end in ends] for ends in intervals]


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("model", "cover mechanisms with a mass matrix and forces"),
        ("extended", "cover mechanisms with a mass matrix and forces"),
        ("gallery/pushed_chalk.toml", "need x, not a slip velocity"),
        ("gallery/ellipse.toml", "need x, not a slip velocity"),
        ("gallery/rod_on_a_shaken_base.toml", "without constraints and time"),
        ("gallery/double_pendulum.toml", "cosine of more than one coordinate"),
        ("gallery/two_link_arm.toml", "cosine of more than one coordinate"),
    ],
)
def test_a_mechanism_without_one(name: str, why: str) -> None:
    with pytest.raises(NotPolynomial, match=why):
        PolynomialSlip(shift(load(place(name))).mechanism)


@pytest.mark.parametrize(
    ("state", "surface", "why"),
    [
        ({"phi": "1/2", "phi_dot": "-9/10"}, None, "phi_ref and a rational number for phi"),
        ({"phi": "phi_ref + 1/10", "psi_dot": "4/5"}, None, "a certificate needs phi_dot; leave out psi and psi_dot"),
        (PAPER, arb("1/3"), "a rational number for the surface's velocity"),
        ({"phi": "phi_ref + 1/10"}, None, "give all components"),
        (PAPER | {"psi": 3, "psi_dot": 0}, None, "not on the contact"),
    ],
)
def test_a_state_without_one(state: dict[str, Any], surface: Any, why: str) -> None:
    with pytest.raises(StateError, match=why):
        approach_certificate(load("oscillator"), state, surface_velocity=surface)


@pytest.mark.parametrize(
    ("state", "surface"),
    [
        ({"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "3/2"}, None),  # b > 0 at the start
        ({"X": 0, "X_dot": 2, "theta": "theta_ref + 1/20", "theta_dot": "1/2"}, None),  # p < 0 at the start
        (ROD, "8/5"),  # stick comes first
    ],
)
def test_no_way_to_a_g_spot(state: dict[str, Any], surface: str | None) -> None:
    with pytest.raises(NotBounded):
        approach_certificate(load("rod"), state, surface_velocity=surface)


class Near(module._Writer):
    """Takes no step: the neighbourhood is about the start."""

    def _way(self) -> Any:
        return []

    def _written(self, steps: Any, unit: int, last: int) -> Any:  # noqa: ARG002
        return [], self._slip.start(self._start)


@pytest.mark.parametrize(
    ("theta", "rate", "surface", "why"),
    [
        ("-1/1000000", "999999/1000000", fmpq(6, 5), ""),
        ("-1/1000000", "1000001/1000000", None, "no neighbourhood"),  # b > 0
        ("1/1000000", "1", None, "no neighbourhood"),  # p < 0
    ],
)
def test_a_start_within_a_neighbourhood(theta: str, rate: str, surface: Any, why: str, tmp_path: Path) -> None:
    """No step is needed, and none is written."""
    shifted = shift(load("rod"))
    slip = PolynomialSlip(shifted.mechanism)
    state = {"X": 0, "X_dot": 2, "theta": f"theta_ref + {theta}", "theta_dot": rate}
    writer = Near(slip, module._exact_start(shifted, state, slip), surface)
    if why:
        with pytest.raises(NotBounded):
            writer.text(128)
        return
    text = writer.text(128)[1]
    assert len(text.splitlines()) == 4
    said = checked(text, tmp_path)
    assert "VERIFIED" in said
    assert "x' > 6/5" in said
    assert "C_1 < 0" in said


class Lazy(module._Writer):
    """Takes so many steps, asks for no sign, and has any neighbourhood."""

    count = 3

    def _way(self) -> Any:
        kept = module._Kept(self.count)
        for _ in module.NormRun(self._slip.field, self._slip.start(self._start), steps=kept):
            pass
        return kept.steps

    def _captured(self, states: Sequence[arb]) -> Capture | None:
        box = tuple(add_remainder(side, arb(1) / 1000) for side in states[:-1])
        numbers = self._slip.on(box)
        return Capture(box, tuple(arb(1) / 2000 for _ in box), numbers, arb(1), arb(1), arb(1), arb(1), None)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("state", "surface", "count", "why"),
    [
        ({"theta": "theta_ref - 1/10", "theta_dot": "53/50"}, None, 3, "b ≥ 0 is not excluded"),
        ({"theta": "theta_ref - 1/10", "theta_dot": "9/10"}, fmpq(7, 5), 3, "slip that ends is not excluded"),
        ({"theta": "theta_ref - 1/10", "theta_dot": "9/10"}, fmpq(0), 3, "may leave the neighbourhood"),
        ({"theta": "theta_ref + 1/10", "theta_dot": "9/10"}, None, 1, "p is not certainly positive at the start"),
        ({"theta": "theta_ref - 1/10", "theta_dot": "3/2"}, None, 1, "b ≥ 0 is not excluded"),
    ],
)
def test_a_lazy_prover(state: dict[str, Any], surface: Any, count: int, why: str, tmp_path: Path) -> None:
    shifted = shift(load("rod"))
    slip = PolynomialSlip(shifted.mechanism)
    start = module._exact_start(shifted, {"X": 0, "X_dot": 2} | state, slip)
    writer = Lazy(slip, start, surface)
    writer.count = count
    said = checked(writer.text(128)[1], tmp_path)
    assert said.startswith("REJECTED ")
    assert why in said


def test_the_lazy_prover_shows_what_it_says() -> None:
    """From that start b is certainly positive somewhere on the three steps, where p > 0."""
    shifted = shift(load("rod"))
    slip = PolynomialSlip(shifted.mechanism)
    state = {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/10", "theta_dot": "53/50"}
    with working_bits(128):
        start = slip.start(module._exact_start(shifted, state, slip))
        assert slip.on(start).b < 0
        kept = module._Kept(3)
        runs = [slip.on(segment.step.enclosure(arb(1))) for segment in module.NormRun(slip.field, start, steps=kept)]
        assert any(found.b > 0 and found.p > 0 for found in runs)


def test_the_command_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "rod.cert"
    state = "X=0,X_dot=2,theta=theta_ref - 1/20,theta_dot=1/2"
    assert main(["approach", "rod", "--from", state, "--certificate", str(file)]) == 0
    assert f"certificate that the G-spot is reached: {file}" in capsys.readouterr().out
    assert main(["check", str(file)]) == 0
    assert "VERIFIED the mechanism" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--surface-velocity=8/5"], 0, "was not written"),
        (["--surface-velocity=19/10"], 64, "no positive slip"),
        (["--spot", "1"], 64, "not together with"),
    ],
)
def test_the_command_writes_none(
    words: list[str], code: int, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "rod.cert"
    state = "X=0,X_dot=2,theta=theta_ref - 1/20,theta_dot=1/2"
    assert main(["approach", "rod", "--from", state, *words, "--certificate", str(file)]) == code
    assert said in capsys.readouterr().err
    assert not file.exists()
