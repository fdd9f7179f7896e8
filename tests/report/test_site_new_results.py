"""What is new: no result without its page, its command and its figure, and none in words that no page has."""

import shlex

import pytest
import typer

from gspot_verified.cli.app import app
from gspot_verified.cli.main import COMMANDS, load_commands, main
from gspot_verified.paper.checks.entry import Check, Rung, Section
from gspot_verified.paper.checks.formal_proof import FormalProof, Theorem
from gspot_verified.paper.verify import PARTS
from gspot_verified.report.data import report_data
from gspot_verified.report.parts.proof_page import PROOFS
from gspot_verified.report.site import MACHINE_CHECKED, new_results, pages

RESULTS = {result.key: result for result in new_results()}
OF_THE_PROGRAM = [result for result in RESULTS.values() if result.command.startswith("gspot-verified ")]


def words_of(result):
    return shlex.split(result.command)[1:]


def test_the_results_are_those_that_the_page_is_about():
    assert list(RESULTS) == [
        "sign", "count-law", "epsilon-0", "not-unique", "side-rule", "uniform", MACHINE_CHECKED
    ]  # fmt: skip


@pytest.mark.parametrize("result", RESULTS.values(), ids=RESULTS)
def test_the_precise_statement_is_that_of_a_proof_page(result):
    assert result.passages
    for page, text in result.passages:
        assert (PROOFS / f"{page}.md").read_text(encoding="utf-8").count(text) == 1, text
    ledger = {identifier for builders in PARTS.values() for identifier in builders}
    assert set(result.entries) <= ledger


def test_every_result_has_a_figure_of_its_own(pictures):
    figures = [result.figure for result in RESULTS.values()]
    assert len(set(figures)) == len(figures)
    assert set(figures) <= {picture.name for picture in pictures}


@pytest.mark.parametrize("result", OF_THE_PROGRAM, ids=lambda result: result.key)
def test_the_command_can_be_given(result):
    name, *rest = words_of(result)
    assert name in COMMANDS
    load_commands([name])
    group = typer.main.get_command(app)
    with typer.Context(group) as context:
        assert group.get_command(context, name).make_context(name, rest, parent=context).params
    assert result.prints


def test_the_other_command_is_one_of_the_makefile():
    assert set(RESULTS.values()) - set(OF_THE_PROGRAM) == {RESULTS[MACHINE_CHECKED]}
    make, target = shlex.split(RESULTS[MACHINE_CHECKED].command)
    assert make == "make"
    assert f"\n{target}:\n" in (PROOFS.parent / "Makefile").read_text(encoding="utf-8")


def prints_what_it_should(result, capsys):
    assert main(words_of(result)) in (0, 1)
    assert result.prints in capsys.readouterr().out


def test_a_command_prints_what_the_page_says(capsys):
    prints_what_it_should(RESULTS["count-law"], capsys)
    prints_what_it_should(RESULTS["side-rule"], capsys)


@pytest.mark.slow
@pytest.mark.parametrize("result", OF_THE_PROGRAM, ids=lambda result: result.key)
def test_every_command_prints_what_the_page_says(result, capsys):
    prints_what_it_should(result, capsys)


def test_the_page_shows_each_with_its_page_command_and_figure(pictures):
    checks = [Check(Rung.EXACT, what, True) for what in ("one", "two")]
    formal = FormalProof((Theorem("IWC", "Definition IWC : Prop := x < 1.", "Statement.v"),), False, "not run here")
    entry = Section("Section 4.5").settled("S-iwc", "line 1", "x", "the sign", *checks)
    object.__setattr__(entry, "formal", formal)
    page = pages(report_data([entry], pictures))["new.html"]
    for result in RESULTS.values():
        part = page.split(f'<section id="{result.key}">')[1].split("</section>")[0]
        assert f'src="figures/{result.figure}.svg"' in part
        assert "<pre><code>" in part
        for passage in result.passages:
            assert f'href="proof-{passage.page}.html"' in part
        assert part.count('<blockquote class="passage">') == len(result.passages)
    assert "Definition IWC : Prop := x &lt; 1." in page.split(f'<section id="{MACHINE_CHECKED}">')[1]
    assert "not run here" in page
