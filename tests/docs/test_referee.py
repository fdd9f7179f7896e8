"""docs/extensions/referee.py: the page that shows the paper's claims beside the formal statements."""

from __future__ import annotations

import re

import pytest
import referee

from gspot_verified.paper.checks.formal_proof import COQ, statement_of
from gspot_verified.paper.checks.formal_routes import CARRIED, CONTRADICTED

ROUTES = [*CARRIED.values(), *(names for names, _ in CONTRADICTED.values())]


def test_the_page_is_the_one_that_is_written_now_and_short_enough() -> None:
    written = referee.PAGE.read_text(encoding="utf-8")
    assert written == referee.page(), "python docs/extensions/referee.py writes it anew"
    assert len(written.splitlines()) <= referee.LONGEST


def test_each_theorem_that_carries_a_claim_is_stated_once_word_for_word() -> None:
    written = referee.page()
    for name in {name for names in ROUTES for name in names}:
        assert written.count(statement_of(name)[0]) == 1, name
        assert f"`{name}`" in written


def test_every_definition_that_a_statement_uses_is_there() -> None:
    """Names of the files of statements, read without regard to how the page finds them."""
    written = referee.page()
    stated = "\n".join((COQ / file).read_text(encoding="utf-8") for file in referee.stated_in())
    defined = {*re.findall(r"^(?:Definition|Fixpoint|Record|Inductive) (\w+)", stated, re.MULTILINE)}
    shown = {*re.findall(r"^(?:Definition|Fixpoint|Record|Inductive) (\w+)", written, re.MULTILINE)}
    code = re.sub(r"\(\*.*?\*\)", "", "".join(re.findall(r"```coq\n(.*?)```", written, re.DOTALL)), flags=re.DOTALL)
    assert {*re.findall(r"\w+", code)} & defined == shown
    assert {"is_Theta", "GammaInt", "contact_force"} < shown


def test_a_definition_of_a_definition_is_found_and_a_comment_uses_nothing() -> None:
    assert referee.used(["Gamma (- b)"]) == ["GammaInt", "Gamma_aux", "Gamma"]
    assert referee.used(["(** Gamma *) b"]) == []


def test_a_condition_a_part_and_a_contradiction_are_said() -> None:
    written = referee.page()
    assert "- l. 1073–1076: The deviations of y, v, z and λ_N are recovered from that of b by eqs." in written
    assert (
        "- l. 912–914: In Case II b, y and v increase after lift-off, and it persists [in the model system" in written
    )
    assert "[2-trivial-zy] – **not as printed**: the printed z and y solve the equations never\n" in written


def test_a_theorem_without_a_claim_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(referee, "CARRIED", CARRIED | {"no-entry": ("count_law",)})
    with pytest.raises(ValueError, match="count_law"):
        referee.page()
