"""proofs/coq/coq_output.py: what Coq and coqchk print; whatever is not understood is refused."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"


@pytest.fixture
def printed(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module, which the scripts import from their own folder."""
    monkeypatch.syspath_prepend(str(COQ))
    import coq_output

    return coq_output


FIRST = """Axioms:
ClassicalDedekindReals.sig_not_dec : forall P : Prop, {~ ~ P} + {~ P}
Classical_Prop.classic : forall P : Prop, P \\/ ~ P
"""
ANSWER = FIRST + "Closed under the global context\n"


def test_what_coq_prints_is_read(printed: ModuleType) -> None:
    first = ["ClassicalDedekindReals.sig_not_dec", "Classical_Prop.classic"]
    assert printed.axioms_printed(ANSWER, ["first", "second"]) == {"first": sorted(first), "second": []}
    assert printed.axioms_printed("", []) == {}


@pytest.mark.parametrize(
    "text",
    [
        "",
        ANSWER + "Closed under the global context\n",
        FIRST,
        ANSWER.replace("P \\/ ~ P", "P"),
        ANSWER.replace("Classical_Prop.classic", "Mine.Classical_Prop.classic"),
        ANSWER.replace("ClassicalDedekindReals", "GSpot.ClassicalDedekindReals"),
        ANSWER.replace("Axioms:\n", "Axioms:\ng is assumed to be guarded.\n"),
        ANSWER.replace("Axioms:\n", "Axioms:\ng is assumed to be positive.\n"),
        ANSWER.replace("Axioms:\n", "Axioms:\ng relies on an unsafe hierarchy.\n"),
        ANSWER.replace("Axioms:\n", "Axioms:\ncheat : False\n"),
        ANSWER.replace("Axioms:\n", "Axioms:\ncheat\n  : False\n"),
        ANSWER.replace("Axioms:\n", "Axioms:\nSection Variables:\n"),
        ANSWER + "g is assumed to be guarded.\n",
        ANSWER + "Theory: Set is impredicative\n",
        "Section Variables:\nx : nat\n" + ANSWER,
        "theorem first\n" + ANSWER,
        ANSWER + "\n",
        "Axioms:\n" + ANSWER,
        FIRST + FIRST.splitlines()[-1] + "\nClosed under the global context\n",
        "Closed under the global context\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n",
        "Error: not found\n" + ANSWER,
    ],
)
def test_a_line_that_is_not_understood_is_a_refusal(printed: ModuleType, text: str) -> None:
    with pytest.raises(RuntimeError):
        printed.axioms_printed(text, ["first", "second"])


SUMMARY = """
CONTEXT SUMMARY
===============

* Theory: Set is predicative
  
* Axioms:
    Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
    Coq.Reals.ClassicalDedekindReals.sig_not_dec
  
* Constants/Inductives relying on type-in-type: <none>
  
* Constants/Inductives relying on unsafe (co)fixpoints: <none>
  
* Inductives whose positivity is assumed: <none>
  
"""  # noqa: W293


def test_the_summary_of_the_kernel_checker_is_read(printed: ModuleType) -> None:
    assert printed.kernel_accepts(SUMMARY)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Coq.Reals.ClassicalDedekindReals.sig_not_dec", "Mine.axiom"),
        ("Coq.Reals.Classical", "GSpot.Classical"),
        ("Set is predicative", "Set is impredicative"),
        ("type-in-type: <none>", "type-in-type: GSpot.t"),
        ("type-in-type: <none>", "type-in-type:\n    GSpot.t"),
        ("(co)fixpoints: <none>", "(co)fixpoints: GSpot.t"),
        ("assumed: <none>", "assumed: GSpot.t"),
        ("assumed: <none>\n", "assumed: <none>\n* More: GSpot.t\n"),
        ("CONTEXT", "Error: a file is missing\nCONTEXT"),
        ("* Theory", "* Another: GSpot.t\n* Theory"),
        (SUMMARY, ""),
    ],
)
def test_another_summary_is_refused(printed: ModuleType, before: str, after: str) -> None:
    changed = SUMMARY.replace(before, after)
    assert changed != SUMMARY
    assert not printed.kernel_accepts(changed)


GLOB = """DIGEST 05563b3756a4d7755ca5d8b5cc428d6a
FGSpot.Statement
R313:317 Coq.Reals.Reals <> <> lib
R401:409 GSpot.StatementModels <> <> lib
def 632:644 <> claim
binder 647:649 <> eps:1
R657:657 Coq.Reals.Rdefinitions RbaseSymbolsImpl R defax
R678:678 GSpot.Statement <> y:2 var
R680:680 GSpot.Checker <> <> lib
R690:690 GSpot.Checker <> accepts def
"""


def strange(printed: ModuleType, glob: str) -> list[str]:
    found = printed.strange_references(glob, ("Statement", "StatementModels"), {"Checker": {"accepts"}})
    return list(found)


def test_where_coq_finds_the_names_of_a_statement(printed: ModuleType) -> None:
    assert strange(printed, GLOB) == []
    # Coq 8.20 notes what it makes of a definition, and of no other name.
    made = "ind 700:705 <> pays\nscheme 700:705 <> pays_ind\nscheme 700:705 <> pays_sind\n"
    assert strange(printed, GLOB + made) == []
    assert strange(printed, GLOB + made.replace("pays_ind", "claim_ind")) == ["scheme 700:705 <> claim_ind"]
    assert strange(printed, GLOB + made.replace("pays_ind", "pays")) == ["scheme 700:705 <> pays"]


@pytest.mark.parametrize(
    ("before", "after", "found"),
    [
        ("Checker <> accepts", "Checker <> Derive", "GSpot.Checker: Derive"),
        ("Checker <> accepts", "Checker <> :R_scope:x_'<'_x", "GSpot.Checker: :R_scope:x_'<'_x"),
        ("Checker <> accepts", "Other <> accepts", "GSpot.Other: accepts"),
        ("Checker <> accepts", "Other <> <>", "GSpot.Other: <>"),
        ("Coq.Reals.Rdefinitions", "Other.Reals", "Other.Reals: R"),
        ("Coq.Reals.Rdefinitions", "Coqx.Reals", "Coqx.Reals: R"),
        ("Coq.Reals.Rdefinitions", "Checker", "Checker: R"),
        ("def 632:644 <> claim", "not 632:644 <> claim", "not 632:644 <> claim"),
        ("def 632:644 <> claim", "mod 632:644 <> claim", "mod 632:644 <> claim"),
    ],
)
def test_a_name_that_is_found_elsewhere_is_told(printed: ModuleType, before: str, after: str, found: str) -> None:
    assert found in strange(printed, GLOB.replace(before, after))
