"""Certificates of runs, from the scene to the checker's statement.

Page: proofs/run_certificate.md.
"""

from __future__ import annotations

import random
import re
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from must_reject import runs

from gspot_verified.certificates.checker import check
from gspot_verified.certificates.text import write_text
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certificates import run_certificate
from gspot_verified.scenes.certificates.bounded_step import NotBounded
from gspot_verified.scenes.certificates.run_certificate import NotCertified, certified_with_steps
from gspot_verified.scenes.certified_run import EXACT, certified_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene


def said_of(scene: Scene) -> str:
    """The checker's line."""
    run, text, why = certified_with_steps(scene)
    assert text is not None, f"{why}: {run}"
    return runs.verdict(text.encode())


def brackets(said: str) -> list[tuple[str, Fraction, Fraction]]:
    found = re.findall(r"([a-z-]+) at t in \[([\d.]+), ([\d.]+)\]", said)
    return [(name, Fraction(low), Fraction(high)) for name, low, high in found]


def test_events_are_those_of_the_exact_solution() -> None:
    scene = load_scene("fig-varsim1", epsilon="1/20", until="3")
    found = brackets(said_of(scene))
    exact = certified_run(scene, route=EXACT).events
    assert [name for name, _, _ in found] == [event.name for event in exact[:2]] == ["lift-off", "touch-down"]
    for (_, low, high), event in zip(found, exact, strict=False):
        assert high - low < Fraction(1, 10**25)
        assert low <= Fraction(str(event.upper))
        assert high >= Fraction(str(event.lower))


def test_contact_for_ever() -> None:
    said = said_of(load_scene("fig-varsim1", beta="1/2", nu="1/4", epsilon="1/20"))
    assert said.startswith("VERIFIED")
    assert "no change of phase, for ever, with λ_N > 0 that grows at least like exp(" in said


def test_effects_that_are_left_out() -> None:
    scene = load_scene("fig-varsim2", epsilon="1/5", until="1").with_effects(drop=("stick", "lift_off"))
    said = said_of(scene)
    assert "no change of phase, until t = 1" in said
    assert "; λ_N > 0 all along, as leaving an effect out assumes; " in said
    assert said.endswith("; u > 0 in contact all along, as leaving an effect out assumes")


def test_a_mechanism_on_a_belt() -> None:
    said = said_of(load_scene("oscillator", epsilon="1/20", until="1/100"))
    assert said.startswith("VERIFIED the mechanism")
    assert said.endswith("provided that in contact slip is positive, which is not shown")


def test_a_process_of_its_own(tmp_path: Path) -> None:
    text = certified_with_steps(load_scene("fig-varsim1", epsilon="1/20", until="1/4")).text
    assert text is not None
    write_text(tmp_path / "run.cert", text)
    result = check(tmp_path / "run.cert")
    assert result.verified
    assert result.text == runs.verdict(text.encode())


@pytest.mark.parametrize(
    ("name", "settings", "why"),
    [
        ("stribeck", {}, "need a friction coefficient that is a number"),
        ("rod", {"X_dot": "-2"}, "begin in contact and in slip"),
        ("fig-varsim1", {"y": "0", "v": "0", "z": "0"}, "begin in contact, y < z"),
        ("fig-varsim2", {"a": "1/10"}, "a = 0"),
        ("fig-varsim2", {"k_minus": "0"}, "k_plus < 0 < k_minus"),
        ("fig-varsim2", {"u": "-1"}, "in slip, u > 0"),
    ],
)
def test_refused(name: str, settings: dict[str, str], why: str) -> None:
    with pytest.raises(NotCertified, match=why):
        certified_with_steps(load_scene(name, **settings))


def test_a_run_that_is_not_proved_has_none() -> None:
    run, text, why = certified_with_steps(load_scene("fig-varsim1", epsilon="1/20"), budget=1)
    assert run.verdict.exit_code == 2
    assert text is None
    assert why == "the run is not proved"


SHIPPED = [
    ("fig-varsim1", {}),
    ("fig-varsim1", {"beta": "1/2", "nu": "1/4"}),
    ("fig-varsim1", {"epsilon": "1e-5"}),
    ("fig-varsim2", {}),
    ("fig-varsim2", {"chi": "0"}),
    ("fig-varsim2", {"nu": "4"}),
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "settings"), SHIPPED)
def test_the_runs_of_the_paper(name: str, settings: dict[str, str]) -> None:
    assert said_of(load_scene(name, **settings)).startswith("VERIFIED")


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(30))
def test_random_scenes(seed: int) -> None:
    """The equations that the checker writes down again are those of the library, for all parameters."""
    chance = random.Random(seed)

    def between(low: float, high: float) -> str:
        return f"{chance.randint(int(low * 100), int(high * 100))}/100"

    settings = {"beta": between(0.2, 4.8), "nu": between(0.2, 4), "epsilon": chance.choice(["1/10", "1/50", "1/200"])}
    settings |= {"alpha_1": between(-2, -0.3), "alpha_2": between(-2, -0.3), "p": between(0.2, 0.6)}
    settings |= {name: between(0.5, 2) for name in ("k_1", "k_2", "damping")}
    name = ("fig-varsim1", "fig-varsim2")[seed % 2]
    if name == "fig-varsim2":
        settings |= {"chi": between(0, 1), "u": between(0.2, 70), "p_minus": between(0.2, 2)}
        settings |= {"k_plus": between(-2, -0.3), "k_minus": between(0.3, 2)}
    run, text, why = certified_with_steps(load_scene(name, **settings))
    if run.verdict.exit_code == 0:
        assert text is not None, why
        assert runs.verdict(text.encode()).startswith("VERIFIED")


RUNS: list[tuple[list[str], str | None, str]] = [
    (["wide", "narrow", "unused"], "narrow", ""),
    (["wide", "half", "narrow"], "narrow", ""),
    (["wide", "not bounded"], "wide", ""),
    (["not bounded", "narrow"], "narrow", ""),
    (["not bounded", "not bounded"], None, "not bounded"),
    (["not bounded", "not proved"], None, "not bounded"),
    (["not proved", "narrow"], "narrow", ""),
    (["not proved", "not proved"], None, "the run is not proved"),
]
NARROW = {"wide": (False, False), "half": (True, False), "narrow": (True, True)}


@pytest.mark.parametrize(("found", "text", "why"), RUNS)
def test_more_bits_until_the_brackets_are_narrow(
    found: list[str], text: str | None, why: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is proved is kept where more bits prove less; the first precision with narrow brackets is the last."""
    scene = load_scene("fig-varsim1")

    class Writer:
        def __init__(self, _scene: Scene, run: Any, _bits: int) -> None:
            self.name = run.name

        def text(self, _phases: Any) -> str:
            if self.name == "not bounded":
                raise NotBounded(self.name)
            return str(self.name)

    def run_of(_scene: Scene, _digits: int, bits: tuple[int], **_others: Any) -> Any:
        name = found[bits[0]]
        assert name != "unused"
        outcome = Outcome.UNDECIDED if name == "not proved" else Outcome.PROVED
        return SimpleNamespace(
            name=name, verdict=SimpleNamespace(outcome=outcome), assumptions=(), events=NARROW.get(name, ())
        )

    monkeypatch.setattr(run_certificate, "precisions_for", lambda *_: range(len(found)))
    monkeypatch.setattr(run_certificate, "integrated_run", run_of)
    monkeypatch.setattr(run_certificate, "RunWriter", Writer)
    monkeypatch.setattr(run_certificate, "_phases", lambda _: [])
    monkeypatch.setattr(run_certificate, "is_narrow", lambda event, *_: event)
    result = certified_with_steps(scene)
    assert (result.text, result.why) == (text, why)
