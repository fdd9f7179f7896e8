"""The rules of the house read the whole package."""

import pytest


@pytest.fixture(autouse=True, scope="session")
def parsed_before(package_trees: object) -> None:
    """No test is charged with what all share."""
