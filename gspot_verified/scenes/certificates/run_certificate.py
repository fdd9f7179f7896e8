"""A certificate of a certified run: the steps that the integrator chose, written so that each can be proved again.

The producer's side of ``proofs/run_certificate.md``. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

import json
import tempfile
from pathlib import Path
from typing import NamedTuple

from flint import fmpq

from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certificates.bounded_step import NotBounded
from gspot_verified.scenes.certificates.mechanism_writer import BELT, MechanismEquations, MechanismWriter
from gspot_verified.scenes.certificates.polynomial_mechanism import NotPolynomial
from gspot_verified.scenes.certificates.run_writer import RunWriter
from gspot_verified.scenes.certified.certified_integration import MAX_STEPS, integrated_run, is_narrow, precisions_for
from gspot_verified.scenes.certified.run_steps import Progress
from gspot_verified.scenes.effects.stick import STICKS
from gspot_verified.scenes.equations.terms import SLIP
from gspot_verified.scenes.scene.assumption import CHECKED, Assumption
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.scenes.scene.scene import Scene, SceneError

COVERED = ("compliant_contact", "lift_off", "stick", "tangential_motion", "two_way_coupling")
COVERED_OF_MECHANISMS = ("belt", "compliant_contact", "lift_off", "stick", "tangential_motion")


class NotCertified(SceneError):
    """Runs of a scene have no certificates; the message says why."""


def check_covered(scene: Scene) -> None:
    """Passes for a scene whose runs have certificates.

    :raises NotCertified: it is none.
    """
    if scene.mechanism is not None:
        _check_mechanism(scene)
        return
    others = [name for name in scene.effects if name not in COVERED]
    if others:
        raise NotCertified(f"certificates of runs do not cover the effect {others[0]}")
    values, start = scene.values(), scene.initial()
    if not (start["z"] > start["y"] and start.get("u", fmpq(1)) > 0):
        raise NotCertified("certificates of runs begin in contact, y < z, and in slip, u > 0")
    if STICKS in scene.effects and not (values["k_plus"] < 0 < values["k_minus"] and values["a"] == 0):
        raise NotCertified("certificates of runs with stick need k_plus < 0 < k_minus and a = 0")


def _check_mechanism(scene: Scene) -> None:
    others = [name for name in scene.effects if name not in COVERED_OF_MECHANISMS]
    if others:
        raise NotCertified(f"certificates of runs of a mechanism do not cover the effect {others[0]}")
    if BELT in scene.effects and "tangential_motion" in scene.effects:
        raise NotCertified("certificates of runs do not cover tangential motion on a belt")
    if scene.first_phase() != SLIP or not scene.initial()["z"] >= scene.initial()["y"]:
        raise NotCertified("certificates of runs begin in contact and in slip, u > 0")
    try:
        MechanismEquations(scene)
    except NotPolynomial as error:
        raise NotCertified(str(error)) from None


class CertifiedRun(NamedTuple):
    """``text``: the certificate of ``run``; None: there is none, ``why`` says the reason."""

    run: SceneRun
    text: str | None
    why: str = ""


def certified_with_steps(
    scene: Scene, digits: int = 15, budget: int = MAX_STEPS, progress: Progress = lambda _: None
) -> CertifiedRun:
    """The run by the integrator, and a certificate of it where it is proved; arguments as in ``integrated_run``.

    :raises NotCertified: no run of this scene has a certificate.
    :raises SceneError: digits or budget out of range.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> run, text, _ = certified_with_steps(load_scene("fig-varsim1", epsilon="1/5", until="1/10"))
    >>> run.fate, text.splitlines()[1]
    ('no event', '{"bits":320}')
    """
    check_covered(scene)
    writer = RunWriter if scene.mechanism is None else MechanismWriter
    found: CertifiedRun | None = None
    for bits in precisions_for(scene, digits):
        with tempfile.TemporaryDirectory() as folder:
            journal = Path(folder) / "steps"
            run = integrated_run(scene, digits, (bits,), journal=journal, budget=budget, progress=progress)
            phases = _phases(journal)
        if run.verdict.outcome is not Outcome.PROVED:
            found = found or CertifiedRun(run, None, "the run is not proved")
            continue
        if open_ones := [each for each in run.assumptions if not (each.standing == CHECKED or _is_said(scene, each))]:
            return CertifiedRun(run, None, f"what leaving an effect out assumes is not certain: {open_ones[0]}")
        try:
            found = CertifiedRun(run, writer(scene, run, bits).text(phases))
        except NotBounded as error:
            found = CertifiedRun(run, None, str(error)) if found is None or found.text is None else found
            continue
        if all(is_narrow(event, scene.epsilon, digits) for event in run.events):
            break
    assert found is not None
    return found


def _is_said(scene: Scene, assumption: Assumption) -> bool:
    """Whether the statement of a certificate says that this is assumed."""
    return scene.mechanism is not None and BELT in scene.effects and assumption.effect == "tangential_motion"


def _phases(journal: Path) -> list[list[ChosenStep]]:
    """The steps of each phase, as a run kept them."""
    lines = [json.loads(line)[1] for line in journal.read_text().splitlines()[1:]]
    count = max((line["phase"] for line in lines), default=-1) + 1
    return [[ChosenStep.from_json(line["step"]) for line in lines if line["phase"] == i] for i in range(count)]
