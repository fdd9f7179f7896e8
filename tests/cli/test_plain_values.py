"""Plain words are taken as typer takes them, and all others by typer itself."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
import typer

from gspot_verified.cli.app import app
from gspot_verified.cli.main import load_commands, main
from gspot_verified.cli.plain_values import plain_value, take_plain_values

WORDS = ("", " ", "1", "-7", "007", "1.0", "1e3", "1_000", " 5", "+5", "٣", "9" * 30, "x", "-", "true", "no/such/file")


def every_parameter() -> list[Any]:
    load_commands()
    whole = typer.main.get_command(app)
    commands: dict[str, Any] = getattr(whole, "commands", {})
    return [parameter for each in (whole, *commands.values()) for parameter in each.params]


def test_a_plain_word_is_what_typer_makes_of_it(tmp_path: Path) -> None:
    """For every parameter of every command; the file and the folder are there, the link leads nowhere."""
    (tmp_path / "file").touch()
    (tmp_path / "link").symlink_to("nowhere")
    words = (*WORDS, *(str(tmp_path / name) for name in ("", "file", "link", "none")))
    taken = set()
    for parameter in every_parameter():
        if not hasattr(parameter, "get_runtime_param"):
            pytest.skip("this release of typer coerces by itself")
        annotation, typers = parameter.type_descriptor.annotation, parameter.get_runtime_param()
        many = parameter.multiple or parameter.nargs == -1
        for word in words:
            value = (word, "further") if many else word
            try:
                found = plain_value(value, annotation)
            except ValueError:
                continue
            expected = typers.coerce(value, param=parameter, ctx=None)
            assert (type(found), found) == (type(expected), expected), (parameter.name, word)
            taken.add(annotation)
    assert taken == {str, int, Path, list[str], list[Path]}


@pytest.mark.skipif(os.geteuid() == 0, reason="root reads every file")
def test_a_file_that_cannot_be_read_is_left_to_typer(tmp_path: Path) -> None:
    (tmp_path / "closed").touch(0)
    with pytest.raises(ValueError, match="is not plain"):
        plain_value(str(tmp_path / "closed"), Path)


@pytest.mark.parametrize(
    ("value", "annotation"),
    [(None, str), (1, str), (True, int), ("1.5", int), ("1" * 16, int), ("٣", int), ("1\n", int), ("1", float)],
)
def test_what_is_not_plain_is_refused(value: Any, annotation: Any) -> None:
    with pytest.raises(ValueError, match="is not plain"):
        plain_value(value, annotation)


def test_a_word_that_is_no_number_gets_the_message_of_typer(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["theta", "1", "1/2", "--digits", "few"]) == 64
    assert "--digits" in capsys.readouterr().err


class Parameter:
    """One of a release that coerces by an object of its own, which must not be asked."""

    multiple = False
    nargs = 1

    class type_descriptor:
        annotation = int

    def get_runtime_param(self) -> Any:
        raise AssertionError("was asked")


class Command:
    """A command whose help option is made when its parameters are asked for."""

    def __init__(self, *parameters: object) -> None:
        self.parameters = list(parameters)

    def get_params(self, _: object) -> list[object]:
        return self.parameters


def test_parameters_take_plain_values_without_typer() -> None:
    command: Any = Command(Parameter(), Older())
    take_plain_values(command)
    first, second = command.get_params(None)
    taken = first.get_runtime_param
    assert command.get_params(None)[0].get_runtime_param is taken
    assert [taken().coerce(value, param=first, ctx=None) for value in ("12", 3, None)] == [12, 3, None]
    first.nargs = -1
    assert taken().coerce(None, param=first, ctx=None) == ()
    first.nargs, first.multiple = 1, True
    assert taken().coerce(None, param=first, ctx=None) == ()
    with pytest.raises(AssertionError, match="was asked"):
        taken().coerce("many", param=first, ctx=None)
    assert vars(second) == {}


class Older:
    """A parameter of an older release: nothing is to be changed."""
