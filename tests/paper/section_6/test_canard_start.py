"""The start next to the distinguished trajectory: what the claim and the page on scenes say of its certified run."""

from __future__ import annotations

import pytest

from gspot_verified.paper.claims import paper_claims
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT


@pytest.mark.slow
def test_the_certified_run_takes_the_impact_that_the_claim_names() -> None:
    run = certified_run(load_scene("oscillator-canard"))
    assert [event.name for event in run.events] == [IMPACT]
    assert "by t = 0.02403" in str(run)
    claim = next(claim for claim in paper_claims() if claim.first == 2234)
    assert "a certified run takes an impact, where that float run lifts off: λ_N is more than 1000" in claim.why
    assert "times that of rigid slip at the start by t = 0.02404" in claim.why


@pytest.mark.slow
def test_the_second_start_takes_the_impact_sooner_after_p_is_0() -> None:
    """As the claim says of the third one, that it follows the expansion further."""
    run = certified_run(load_scene("oscillator", phi_dot="-1/2", until="137/1000"))
    assert [event.name for event in run.events] == [IMPACT]
    assert "by t = 0.13667" in str(run)
    assert "0.0015 after p = 0 in a certified run" in next(claim for claim in paper_claims() if claim.first == 2234).why
