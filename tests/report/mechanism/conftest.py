"""G-spots with and without rational numbers, as the report names them."""

from __future__ import annotations

import pytest

from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.mechanisms.spots.classify import classify_g_spot
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.report.mechanism.subject import Source, Subject


def subject_of(name: str, **settings: str) -> Subject:
    source = Source("mechanism.toml", shipped_text(name), settings)
    spot = find_g_spot(source.mechanism)
    return Subject(1, source, source.mechanism, spot, classify_g_spot(spot))


@pytest.fixture(scope="session")
def exact() -> Subject:
    """The model system, beta = 3/2: Case III, everything is rational."""
    return subject_of("model")


@pytest.fixture(scope="session")
def in_balls() -> Subject:
    """The oscillator whose G-spot is searched, so that its numbers are balls: Case III."""
    return subject_of("frictional_impact_oscillator_all_parameters")


@pytest.fixture(scope="session")
def second_case() -> Subject:
    """The rod of Case II, in balls."""
    return subject_of("genot_brogliato_rod")


@pytest.fixture(scope="session")
def integer() -> Subject:
    """beta = 3: no side at leading order, and no further term than four."""
    return subject_of("extended", alpha_3="-3")
