"""proofs/coq/source_rules.py: what a source of the formal proofs may say. Each way to say more is refused."""

from __future__ import annotations

import random
import shutil
import subprocess
from pathlib import Path
from types import ModuleType

import pytest

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"
PROJECT = (COQ / "_CoqProject").read_text(encoding="utf-8")
FILES = ["Statement.v", "Lemmas.v"]


@pytest.fixture
def rules(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module, which the scripts import from their own folder."""
    monkeypatch.syspath_prepend(str(COQ))
    import source_rules

    return source_rules


def test_the_development_keeps_the_rules(rules: ModuleType) -> None:
    files = rules.project_files(PROJECT)
    assert len(files) > 100
    assert [name for name in files if rules.refusals((COQ / name).read_text(encoding="utf-8"), files)] == []


GOOD = r"""(** A file. (* Admitted *) "a string *) in a comment" Axiom *)
From Coq Require Import Reals List.
From GSpot Require Import Statement.
From GSpot Require Lemmas.
Import ListNotations.
Open Scope R_scope.
Notation L := (L eps).
Section One.
Hypothesis h : 0 < 1.
Context {T : Type}.
Let x := 2.
Lemma first : 1 = 1. (* a blank follows *)
Proof.
- { reflexivity. }
- 2: lra.
  * + exact I.
Qed.
End One.
Definition text : string := "Axiom. (* Load ""x"". ".
Definition last := 1."""


def test_what_may_be_said(rules: ModuleType) -> None:
    assert rules.refusals(GOOD, FILES) == []
    assert rules.refusals("", FILES) == []


def test_the_sentences_are_those_of_coq(rules: ModuleType) -> None:
    assert rules.sentences(rules.code('Definition s := "a. b".\n- { 2: { apply (f.(g) x.y).\nQed.')) == [
        'Definition s := ""', "apply (f.(g) x.y)", "Qed",
    ]  # fmt: skip


HIDDEN = {
    "between two strings": 'Definition o := "(*".\nUnset Guard Checking.\nDefinition c := "*)".',
    "after a string in a comment": '(* "*)" *) Unset Guard Checking.',
    "after a comment with two ends": "(* (* *) *) Unset Guard Checking.",
    "after a string with quotes": 'Definition o := """(*". Unset Guard Checking. (* " *) " *)',
    "behind bullets": "- { * + Unset Guard Checking.",
    "behind a selector": "2: { Unset Guard Checking.",
    "behind a selector by name": "[x]: { Unset Guard Checking.",
    "on the same line": "Definition a := 1. Unset Guard Checking.",
    "over two lines": "Unset\nGuard\nChecking.",
    "with a comment between": "Unset (* *) Guard Checking.",
    "after a projection": "Definition a := f.(*. Unset Guard Checking. *)",
    "after a tabulator": "Definition a := 1.\tUnset Guard Checking.",
    "after a carriage return": "Definition a := 1.\rUnset Guard Checking.",
    "in letters of another alphabet": "Unset Gu\N{CYRILLIC SMALL LETTER A}rd Checking.",
    "without an end": "Definition a := 1. Unset Guard Checking",
    "in a comment without an end": "Definition a := 1. (* Unset Guard Checking.",
    "in a string without an end": 'Definition a := 1. " Unset Guard Checking.',
}
COMMANDS = [
    "Unset Positivity Checking", "Unset Universe Checking", "Set Bypass Guard", "#[global] Unset Guard Checking",
    "Local Unset Guard Checking", "Time Unset Guard Checking", "Fail Unset Guard Checking", "Global Set Printing All",
    "#[bypass_check(guard)] Fixpoint f (n : nat) : False := f n", "#[global] Definition a := 1", "Print Assumptions a",
    'Load "another"', "Load Another", 'Declare ML Module "plugin"', 'Add LoadPath "x"', 'Add Rec LoadPath "x" as GSpot',
    'Cd "x"', 'Redirect "x" Print nat', "Export Lemmas", "Require Import Lemmas", "Require Lemmas",
    "From GSpot Require Export Statement", "From GSpot Require Import Another", "From Other Require Import Reals",
    "From GSpot.Sub Require Import Statement", "From Coq Require Extraction", "From Coq Require Import Reals.Reals",
    "Import Lemmas", "Axiom a : False", "Axioms a b : False", "Parameter a : False", "Parameters a b : False",
    "Conjecture a : False", "Variable a : False", "Variables a b : False", "Hypothesis a : False",
    "Context {a : False}",
    "Let a := 1", "Admitted", "Admit Obligations", "Proof. admit", "Proof. intros; give_up", "Abort",
    "Primitive int := #int63_type", "Register a as b", "Module A", "Module Type A", "Declare Module A : B",
    "Include A", 'Notation "x < y" := True', 'Infix "<" := le', 'Reserved Notation "x < y"', "Declare Scope R_scope",
    "Delimit Scope R_scope with nat", "Bind Scope R_scope with nat", "Open Scope other_scope",
    "Undelimit Scope R_scope",
    "Local Notation a := (b)", "Notation a := (fun x => True)", 'Fixpoint f (n : nat) := 1 where "x < y" := (f x)',
    "Coercion f : nat >-> Z", "Record r := { f :> nat }", "Canonical Structure a := b", "Identity Coercion a : b >-> c",
    "Existing Instance a", "Instance a : b := c", "Hint Resolve a", "Ltac a := b", 'Tactic Notation "lra" := idtac',
    "Global Transparent a", "Global Arguments a", "Arguments a : clear implicits", "Arguments a {b}", "Opaque a",
    "Extraction a", 'Extract Constant a => "b"', "Function f (n : nat) {measure id n} : nat := n", "Defined",
    "Program Definition a := _", "Next Obligation", "Polymorphic Definition a := 1", "Cumulative Inductive a := b",
    "Unset Universe Polymorphism", "Universe u", "Constraint u < v", "Proof using a", "Proof with auto",
    "Goal False", "Save a", "Drop", "Quit", "Reset a", "Back 1", "Comments a", "Ltac2 a := b", "Elpi a",
    "Eval lazy in a",
    "Compute a", "Check a", "Search a", "Locate a", "native_compute", "exact (a <<: b)", "native_cast_no_check a",
    "exact (ltac:(native_compute))",
]  # fmt: skip


@pytest.mark.parametrize("text", HIDDEN.values(), ids=list(HIDDEN))
def test_a_command_is_found_wherever_coq_finds_it(rules: ModuleType, text: str) -> None:
    assert len(rules.refusals(text, FILES)) == 1


@pytest.mark.parametrize("command", COMMANDS)
def test_what_is_not_listed_is_refused(rules: ModuleType, command: str) -> None:
    assert len(rules.refusals(f"Definition a := 1.\n{command}.\n", FILES)) == 1


SIGNS = (
    "(",
    "*",
    ")",
    '"',
    '""',
    ".",
    " ",
    "\n",
    "(*",
    "*)",
    "a",
    '"(*"',
    '"*)"',
    ". ",
    "**)",
    "(**)",
    "(*)",
    "-",
    "{",
)
CHEAT = "\nAxiom cheat : False.\n"


def random_source(choice: random.Random) -> str:
    """Comments, strings and sentences with signs in disorder, and an axiom somewhere among them."""
    place, pieces = choice.randrange(3), []
    for i in range(3):
        inner = "".join(choice.choices(SIGNS, k=choice.randint(0, 2)))
        if i == place:
            inner += CHEAT * (choice.random() < 0.7) + "".join(choice.choices(SIGNS, k=choice.randint(0, 2)))
        forms = (
            f"(* {inner} *)",
            f'Lemma l{i} : True. Proof. idtac "{inner}". exact I. Qed.',
            f"Definition d{i} := I.",
        )
        pieces.append(choice.choice(forms) + CHEAT * (i == place and choice.random() < 0.6))
    return "\n".join(pieces) + "\n"


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: its own reading is not compared")
def test_coq_sees_no_axiom_that_the_rules_do_not_see(rules: ModuleType, tmp_path: Path) -> None:
    choice, seen = random.Random(7), 0
    for _ in range(60):
        text = random_source(choice)
        (tmp_path / "file.v").write_text(f"{text}Definition last := cheat.\n")
        command = ["coqc", "-q", "file.v"]
        if subprocess.run(command, cwd=tmp_path, capture_output=True, check=False).returncode == 0:
            seen += 1
            assert rules.refusals(text, FILES) != []
    assert seen >= 3


def test_what_needs_a_section_is_refused_after_its_end(rules: ModuleType) -> None:
    section = "Section One.\nVariable a : nat.\nEnd One.\n"
    assert rules.refusals(section, FILES) == []
    assert rules.refusals(f"{section}Variable b : False.\n", FILES) == ["Variable b : False"]
    assert rules.refusals(f"End One.\n{section}", FILES) == ["Variable a : nat"]


def test_the_list_of_files_has_one_form(rules: ModuleType) -> None:
    good = "-R . GSpot\n\nStatement.v\nLemmas.v\n"
    assert rules.project_files(good) == FILES


@pytest.mark.parametrize(
    "text",
    [
        "",
        "-R . GSpot\n\n",
        "-R . GSpot\nStatement.v\n",
        "-R . GSpot\n\nStatement.v",
        "-R . GSpot\r\n\r\nStatement.v\r\n",
        "-R . Other\n\nStatement.v\n",
        "-Q . GSpot\n\nStatement.v\n",
        "-R .. GSpot\n\nStatement.v\n",
        "-arg -type-in-type\n-R . GSpot\n\nStatement.v\n",
        "-R . GSpot\n-arg -type-in-type\n\nStatement.v\n",
        "-R . GSpot\n\n-arg -type-in-type\nStatement.v\n",
        "-R . GSpot\n\nStatement.v\n-arg -type-in-type\n",
        "-R . GSpot\n\nStatement.v -arg -type-in-type\n",
        "-R . GSpot\n\nStatement.v\nCOQEXTRAFLAGS = -type-in-type\n",
        "-R . GSpot\n\nStatement.v\n../Lemmas.v\n",
        "-R . GSpot\n\nStatement.v\nfolder/Lemmas.v\n",
        "-R . GSpot\n\nStatement.v\n\nLemmas.v\n",
        "-R . GSpot\n\nStatement.v\n Lemmas.v\n",
        "-R . GSpot\n\nStatement.v\nlemmas.v\n",
        "-R . GSpot\n\nStatement.v\nLem-mas.v\n",
        "-R . GSpot\n\nStatement.v\nLemmas.vo\n",
        "-R . GSpot\n\nStatement.v\nLemmas.mlg\n",
        "-R . GSpot\n\nStatement.v\n@Lemmas.v\n",
        "-R . GSpot\n\nStatement.v\n#Lemmas.v\n",
        "-R . GSpot\n\nStatement.v\nStatement.v\n",
        "-R . GSpot\n\nStatement.v\nGSpot.v\n",
        "-R . GSpot\n\nStatement.v\nCoq.v\n",
        "-R . GSpot\n\nStatement.v\nCoquelicot.v\n",
    ],
)
def test_another_list_of_files_is_refused(rules: ModuleType, text: str) -> None:
    with pytest.raises(ValueError, match="_CoqProject"):
        rules.project_files(text)
