"""One thing is one thing, not 1 things."""

import pytest

from gspot_verified.numbers.counted import counted


@pytest.mark.parametrize(
    ("number", "words", "text"),
    [
        (0, ("piece",), "0 pieces"),
        (1, ("piece",), "one piece"),
        (2, ("piece",), "2 pieces"),
        (1, ("box", "boxes"), "one box"),
        (11, ("box", "boxes"), "11 boxes"),
    ],
)
def test_the_plural_is_for_all_numbers_but_one(number: int, words: tuple[str, ...], text: str) -> None:
    assert counted(number, *words) == text
