"""The public list: every name has one home, loads on demand, and the types say the same."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import gspot_verified
from gspot_verified.cli.app import app
from gspot_verified.cli.main import COMMANDS, load_commands, name_of

ROOT = Path(__file__).resolve().parents[2]
PROOFS = ROOT / "proofs"


def in_a_fresh_process(script: str) -> str:
    run = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout


def stub() -> list[ast.stmt]:
    """The file that holds the public names, as it is parsed."""
    return ast.parse(Path(gspot_verified.__file__).with_suffix(".pyi").read_text(encoding="utf-8")).body


def test_the_stub_is_the_list() -> None:
    """Who reads types takes only ``from home import name as name`` for public, and each name once."""
    imports = [line for line in stub() if isinstance(line, ast.ImportFrom)]
    names = [alias.name for line in imports for alias in line.names]
    assert all(alias.asname == alias.name for line in imports for alias in line.names)
    assert sorted(names) == sorted(set(names)) == sorted(gspot_verified.__all__)
    assert {"theta", "classify", "Verdict"} <= set(names)


def test_the_stub_holds_what_the_module_has_and_nothing_else() -> None:
    others = [line for line in stub()[1:] if not isinstance(line, ast.ImportFrom)]
    assert all(isinstance(line, ast.AnnAssign) and hasattr(gspot_verified, ast.unparse(line.target)) for line in others)


def test_the_stub_is_installed() -> None:
    data = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]["package-data"]
    assert {"py.typed", "__init__.pyi"} <= set(data["gspot_verified"])


@pytest.mark.parametrize("name", gspot_verified.__all__)
def test_every_name_is_what_its_home_defines(name: str) -> None:
    value = getattr(gspot_verified, name)
    home = importlib.import_module(gspot_verified.__homes__[name])
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


HEAVY = {"rich", "pydantic", "numpy", "scipy", "sympy", "mpmath", "matplotlib", "jinja2", "asyncio", "multiprocessing"}


@pytest.mark.parametrize(
    ("command", "further"),
    [
        (("theta", "1", "1/2", "--digits", "20"), set()),
        (("side", "1/2", "4"), set()),
        (("sign", "--tau", "1", "--beta", "1/2"), set()),
        (("check", str(PROOFS / "iwc_0_1.cert")), {"flint"}),
        (("classify", "rod"), set()),
        (("scenes",), set()),
        (("plot", "--help"), {"flint"}),
    ],
)  # fmt: skip
def test_a_short_command_loads_what_it_uses(command: tuple[str, ...], further: set[str]) -> None:
    """A third of a second of processor time is a module too many."""
    script = f"import sys; from gspot_verified.cli import main; assert not main({command!r}); print(*sys.modules)"
    loaded = set(in_a_fresh_process(script).splitlines()[-1].split())
    assert not loaded & (HEAVY | further)
    own = {name.rpartition(".")[2] for name in loaded if name.endswith(("_command", "_commands"))}
    assert own == {COMMANDS[command[0]]}


@pytest.mark.parametrize(
    ("command", "loaded"),
    [
        (("approach", "rod", "--from", "X=0,X_dot=2,theta=theta_ref-1/20,theta_dot=1/2"), {"numpy"}),
        (("iwc", "--beta", "3/2", "--epsilon", "1/100"), set()),
        (("expand", "model", "--order", "5"), set()),
        (("simulate", "fig-varsim1"), {"numpy"}),
    ],
)
def test_a_longer_command_loads_no_library_that_it_does_not_use(command: tuple[str, ...], loaded: set[str]) -> None:
    script = f"import sys; from gspot_verified.cli import main; main({command!r}); print(*sys.modules)"
    assert HEAVY & set(in_a_fresh_process(script).splitlines()[-1].split()) == loaded


def test_each_command_is_where_it_is_sought() -> None:
    load_commands()
    found = {name_of(info.callback): info.callback.__module__ for info in app.registered_commands if info.callback}
    assert found == {name: f"gspot_verified.cli.commands.{module}" for name, module in COMMANDS.items()}


def test_one_way_in() -> None:
    script = "from gspot_verified import load, classify, expand; print(classify(load('rod')).case)"
    assert in_a_fresh_process(script) == "II\n"
