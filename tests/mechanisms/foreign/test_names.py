"""Names of others: changed where this library cannot use them, never two made one."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.mechanisms.foreign.names import (
    coordinate_names,
    is_reserved,
    mechanism_name,
    parameter_names,
    renamed_text,
    spelled,
)
from gspot_verified.mechanisms.formulas.names import check_name
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.scenes.motions import mechanism_motion

LETTERS = "aqy_-\\{} 1\N{GREEK SMALL LETTER MU}"
USUAL = ["y", "q_y", "q_y_", "y_dot", "q_y_dot", "sin", "pi", "v", "a_radius"]
WORDS = st.one_of(st.text(LETTERS, max_size=45), st.sampled_from(USUAL))


@settings(max_examples=50)
@given(st.lists(WORDS, unique=True, max_size=8), st.lists(WORDS, unique=True, max_size=4))
def test_every_name_can_be_used_and_none_is_used_twice(coordinates: list[str], parameters: list[str]) -> None:
    found = coordinate_names(coordinates)
    assert list(found) == coordinates
    others = parameter_names(parameters, found)
    words = [*found.values(), *(f"{word}_dot" for word in found.values()), *others.values()]
    assert len(set(words)) == len(words)
    assert [check_name(word) for word in words] == words
    assert not any(is_reserved(word) for word in found.values())


@pytest.mark.parametrize("name", ["theta", "q1", "phi_2", "X", "\N{GREEK SMALL LETTER PHI}", "theta_dot"])
def test_a_name_that_can_be_used_stays(name: str) -> None:
    assert coordinate_names([name]) == {name: name}


def test_who_can_keep_a_name_keeps_it() -> None:
    assert coordinate_names([r"\theta", "theta"]) == {r"\theta": "theta_", "theta": "theta"}
    assert coordinate_names(["a_dot", "a", "c"]) == {"a_dot": "a_dot", "a": "a_", "c": "c"}
    assert coordinate_names(["g", "h"], ["g", "h_dot"]) == {"g": "g_", "h": "h_"}


def test_the_name_of_a_mechanism_is_a_line() -> None:
    assert mechanism_name("a" * 80) == "a" * 80
    with pytest.raises(MechanismError, match="at most 80"):
        mechanism_name("a" * 81)


@pytest.mark.parametrize(
    ("name", "word"),
    [(r"\theta", "theta"), ("q_{12}", "q_12"), ("knee joint", "kneejoint"), ("a/b", "a_b"), ("2", "q_2"), ("", "q"),
     ("sin", "q_sin"), ("pi", "q_pi"), ("_a_", "a"), ("m" * 50, "m" * 24)],
)  # fmt: skip
def test_other_names_are_spelled(name: str, word: str) -> None:
    assert spelled(name) == word


def test_the_names_of_scenes_are_all_of_those_that_scenes_refuse() -> None:
    for name in (*mechanism_motion.SCENE_FUNCTIONS, *mechanism_motion.SCENE_NAMES):
        assert is_reserved(name)
        assert coordinate_names([name]) == {name: f"q_{name}"}
    assert coordinate_names(["a" + mechanism_motion.SCENE_END]) == {"a_radius": "a_radius_"}


def test_what_was_changed_is_told_in_one_line() -> None:
    assert renamed_text({"a": "a"}) == []
    assert renamed_text({"y": "q_y", "a": "a", "v": "q_v"}) == ["renamed: y is q_y, v is q_v here"]
