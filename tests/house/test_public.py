"""The public list: every name has one home, loads on demand, and the types say the same."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import gspot_verified
from gspot_verified.cli.app import app
from gspot_verified.cli.main import COMMANDS, load_commands

ROOT = Path(__file__).resolve().parents[2]
PROOFS = ROOT / "proofs"


def in_a_fresh_process(script: str) -> str:
    run = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_the_list_for_types_is_the_list() -> None:
    tree = ast.parse(Path(gspot_verified.__file__).read_text(encoding="utf-8"))
    (block,) = (node for node in tree.body if isinstance(node, ast.If))
    typed = {}
    for node in block.body:
        assert isinstance(node, ast.ImportFrom)
        typed.update({alias.asname: f"gspot_verified.{home}" for alias in node.names
                      for home in [str(node.module).removeprefix("gspot_verified.")]})  # fmt: skip
        assert all(alias.asname == alias.name for alias in node.names)
    assert typed == {name: f"gspot_verified.{home}" for name, home in gspot_verified.__homes__.items()}
    assert sorted(typed) == sorted(gspot_verified.__all__)


@pytest.mark.parametrize("name", gspot_verified.__all__)
def test_every_name_is_what_its_home_defines(name: str) -> None:
    value = getattr(gspot_verified, name)
    home = importlib.import_module(f"gspot_verified.{gspot_verified.__homes__[name]}")
    assert value is getattr(home, name)
    assert value.__module__ == home.__name__
    assert name in dir(gspot_verified)


def test_a_name_that_is_not_there() -> None:
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = gspot_verified.nothing  # type: ignore[attr-defined]


def test_the_import_loads_no_arithmetic() -> None:
    assert in_a_fresh_process("import sys, gspot_verified; print('flint' in sys.modules)") == "False\n"


def test_help_loads_no_arithmetic() -> None:
    script = "import sys; from gspot_verified.cli import main; main(['--help']); print('flint' in sys.modules)"
    assert in_a_fresh_process(script).endswith("\nFalse\n")


HEAVY = {"pydantic", "rich", "numpy", "scipy", "sympy", "mpmath", "matplotlib", "jinja2", "asyncio", "multiprocessing"}


@pytest.mark.parametrize(
    ("command", "further"),
    [
        (("theta", "1", "1/2", "--digits", "20"), set()),
        (("side", "1/2", "4"), set()),
        (("sign", "--tau", "1", "--beta", "1/2"), set()),
        (("check", str(PROOFS / "iwc_0_1.cert")), {"flint"}),
        (("classify", "rod"), set()),
    ],
)  # fmt: skip
def test_a_short_command_loads_what_it_uses(command: tuple[str, ...], further: set[str]) -> None:
    """A third of a second of processor time is a module too many."""
    script = f"import sys; from gspot_verified.cli import main; assert not main({command!r}); print(*sys.modules)"
    loaded = set(in_a_fresh_process(script).splitlines()[-1].split())
    assert not loaded & (HEAVY | further)
    own = {name.rpartition(".")[2] for name in loaded if name.endswith(("_command", "_commands"))}
    assert own == {COMMANDS[command[0]]}


def test_each_command_is_where_it_is_sought() -> None:
    load_commands()
    found = {info.callback.__name__: info.callback.__module__ for info in app.registered_commands if info.callback}
    assert found == {name: f"gspot_verified.cli.commands.{module}" for name, module in COMMANDS.items()}


def test_one_way_in() -> None:
    script = "from gspot_verified import load, classify, expand; print(classify(load('rod')).case)"
    assert in_a_fresh_process(script) == "II\n"
