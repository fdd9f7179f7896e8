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
    assert "a certified run takes an impact: λ_N is more than 1000 times that of rigid slip" in claim.why
    assert "at the start by t = 0.02404" in claim.why
