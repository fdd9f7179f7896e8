"""False statements are not verified, whatever their certificates say."""

from __future__ import annotations

import pytest
from must_reject.forged import FORGED
from must_reject.mutate import checker

check = checker()


@pytest.mark.parametrize("name", FORGED)
def test_a_false_statement_is_not_verified(name: str) -> None:
    with pytest.raises(check.Rejected):
        check.check_text(FORGED[name])
