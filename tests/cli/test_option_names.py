"""The options of all commands: one name has one meaning, and one meaning has one name."""

from __future__ import annotations

import types
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

import typer

from gspot_verified.cli.app import app
from gspot_verified.cli.main import load_commands, name_of

OPTIONS: dict[str, tuple[type, str]] = {
    "--add-effect": (str, "an effect that the scene has not"),
    "--all": (bool, "all G-spots, from no start"),
    "--alone": (bool, "named claims without those that their checks name"),
    "--alpha1": (str, "the first coefficient of the normal form"),
    "--alpha2": (str, "the second one"),
    "--alpha3": (str, "the third one"),
    "--animation": (Path, "the moving picture of a mechanism to write"),
    "--at": (str, "the point at which the expansion is evaluated"),
    "--beta": (str, "the ratio alpha3/alpha1, a value or a range"),
    "--bits": (int, "working precision of ball coefficients"),
    "--box": (str, "the interval of a component in the search for G-spots"),
    "--budget": (int, "how much work may be done before the answer is undecided"),
    "--by-theorem": (bool, "the proof by the Laplace integral"),
    "--c1": (str, "the constant C1 of the slow trajectory"),
    "--cache": (Path, "the folder in which results of checks are kept"),
    "--certificate": (Path, "the certificate to write"),
    "--certify": (bool, "whether contact has lasted"),
    "--check": (Path, "the report whose certificates are checked again"),
    "--chi": (str, "short for --set chi="),
    "--compare": (bool, "a float run beside the certified one"),
    "--cost": (Path, "the measurement for the report's page on cost"),
    "--csv": (Path, "the table to write"),
    "--derivative": (int, "which derivative"),
    "--digits": (int, "accuracy of the answer in decimal digits"),
    "--drop-effect": (str, "an effect of the scene that is left out"),
    "--epsilon/--eps": (str, "the compliance, a value or a range"),
    "--explicit": (bool, "a number for how small epsilon must be"),
    "--float": (bool, "a float run in place of the certified one"),
    "--formal": (bool, "the Coq proofs too"),
    "--from": (str, "a state, component by component"),
    "--flights": (int, "how many flights of a run are followed"),
    "--full": (bool, "run every check again"),
    "--growth": (bool, "how the lift-off time grows"),
    "--in-time": (bool, "the expansion in t and epsilon"),
    "--journal": (Path, "the file that keeps finished work"),
    "--json": (bool, "print JSON"),
    "--large/--quick": (bool, "larger cases too"),
    "--latex": (bool, "print LaTeX"),
    "--limit": (str, "a limit of the checker that is raised"),
    "--mechanism": (str, "a mechanism, where the command is not on mechanisms alone"),
    "--method": (str, "the solver of a float run"),
    "--npz": (Path, "the numpy file to write"),
    "--nu": (str, "where the paper's initial data start"),
    "--order": (int, "the order of the expansion"),
    "--output": (Path, "where the result of the command is written"),
    "--over": (str, "a parameter and the range over which it varies"),
    "--peers": (bool, "other programs beside"),
    "--picture": (Path, "the picture to write"),
    "--points": (int, "how many samples"),
    "--positive": (bool, "the other sign"),
    "--residual": (str, "the range on which the residual is bounded"),
    "--route": (str, "which certified way"),
    "--rows": (str, "which rows of a table are done"),
    "--scene": (str, "a scene of the mechanism"),
    "--scheduler": (str, "a Dask scheduler"),
    "--set": (str, "the value of a parameter"),
    "--side": (str, "the range on which lift-off or impact is shown"),
    "--spot": (int, "which G-spot, by its number"),
    "--start": (str, "where on a sweep the G-spot is proved first"),
    "--state": (str, "a state of the compliant model: p,b,y,v,z"),
    "--supplement": (Path, "the folder of the errata and theorems"),
    "--surface-velocity": (str, "how the surface moves"),
    "--t": (str, "the time at which the force is asked"),
    "--table": (Path, "the rows of values for each of which the question is asked"),
    "--tau": (str, "the argument of the function Theta, a value or a range"),
    "--tau-start": (str, "from which tau on a statement holds"),
    "--tolerance": (float, "the relative tolerance of a float run"),
    "--uniform": (str, "the range on which true solutions are close"),
    "--trajectory": (Path, "a table of a simulator's motion"),
    "--until": (str, "when a run ends"),
    "--verbose": (bool, "all numbers"),
    "--within": (str, "the half-width of a set of states"),
    "--workers": (int, "how many processes"),
}
"""Name, what its value is in every command that has it, and what it means there."""

AS_TEXT = ("wrong-sides", "--tolerance")
"""The same numbers, kept as they were written, because they are printed so."""

WORDS = {
    "Radau": "--method",
    "Dask": "--scheduler",
    "PNG": "--picture",
    "Print JSON": "--json",
    "p,b,y,v,z": "--state",
    "classify --all": "--spot",
    "Write a certificate": "--certificate",
    "Processes ": "--workers",
    "TOML file": "--mechanism",
    '"mu=2"; in expand': "--set",
}
"""A word in the help of an option, and the name of every option that has it."""


def base(annotation: Any) -> type:
    """The type of one value: without None, and of one in a list."""
    if get_origin(annotation) in (Union, types.UnionType):
        [annotation] = [each for each in get_args(annotation) if each is not type(None)]
    found: type = get_args(annotation)[0] if get_origin(annotation) is list else annotation
    return found


def options() -> Iterator[tuple[str, str, type, str]]:
    """Command, spellings, type and help of every option of every command."""
    load_commands()
    group: Any = typer.main.get_command(app)
    for info in app.registered_commands:
        assert info.callback is not None
        name = name_of(info.callback)
        hints = get_type_hints(info.callback, include_extras=True)
        for option in group.commands[name].params:
            if option.param_type_name != "option" or option.name not in hints:
                continue
            assert get_origin(hints[option.name]) is Annotated
            spelled = "/".join([*option.opts, *option.secondary_opts])
            yield name, spelled, base(get_args(hints[option.name])[0]), option.help


def test_one_name_has_one_meaning() -> None:
    """A new option is written into the table, beside what the others mean."""
    found = list(options())
    assert {spelled for _, spelled, _, _ in found} == set(OPTIONS)
    for command, spelled, kind, _ in found:
        expected = str if (command, spelled) == AS_TEXT else OPTIONS[spelled][0]
        assert (command, spelled, kind) == (command, spelled, expected)


def test_one_meaning_has_one_name() -> None:
    meanings = [meaning for _, meaning in OPTIONS.values()]
    assert len(set(meanings)) == len(meanings)
    single = [name for spelled in OPTIONS for name in spelled.split("/")]
    assert len(set(single)) == len(single)
    for word, name in WORDS.items():
        assert {spelled for _, spelled, _, text in options() if word in text} == {name}, word


def test_every_option_says_what_it_is_for() -> None:
    for command, spelled, _, text in options():
        assert text, (command, spelled)
        assert text.endswith((".", ". ")), (command, spelled)
