"""The figure of Theorem U1: its caption says what the bound says."""

from __future__ import annotations

from dataclasses import replace

from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.report.figures import uniform_figure


def test_the_caption_is_the_statement_or_says_that_it_is_not_proved(monkeypatch) -> None:
    bound = uniform_figure.drawn_bound()
    monkeypatch.setattr(uniform_figure, "drawn_bound", lambda: bound)
    caption = uniform_figure.uniform_picture().caption
    assert "Certified: every solution in contact within 1 δ^6 of the expansion at s" in caption
    assert f"each of {len(bound.stretches)} pieces" in caption
    undecided = Verdict.undecided("s", Reason.HYPOTHESIS, "it fails from s = 1 on")
    monkeypatch.setattr(uniform_figure, "drawn_bound", lambda: replace(bound, verdict=undecided))
    caption = uniform_figure.uniform_picture().caption
    assert "Not proved to the end: it fails from s" in caption
    assert "Certified" not in caption
