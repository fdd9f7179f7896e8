"""The house: which way imports point, who may touch flint's context, how long a file is, what a docstring names."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import warnings
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "gspot_verified"
MAX_LINES = 500
MAX_FILES = 15

# From the top down: a layer imports only from lower rows (and from itself).
LAYERS = (
    ("cli",),
    ("report",),
    ("hard_cases",),
    ("paper", "cost"),
    ("scenes",),
    ("testing",),
    ("mechanisms",),
    ("compliant",),
    ("expansion", "leading_order"),
    ("certificates",),
    ("integrator", "signs"),
    ("functions", "theta_function", "work"),
    ("numbers",),
)
# The rooms of a layer, from the top down; "" are the files of the folder itself.
ROOMS: dict[str, tuple[tuple[str, ...], ...]] = {
    "cli": (("commands",), ("",)),
    "report": (("mechanism",), ("",), ("parts",), ("figures",), ("pictures",)),
    "cost": (("",), ("parts",), ("measurement",), ("benchmarks",), ("peers",), ("times",)),
    "paper": (
        ("",),
        ("section_4_5", "section_5"),
        ("section_1", "section_4"),
        ("appendix_a", "section_2", "section_3", "section_6"),
        ("checks", "numerics"),
    ),
    "scenes": (
        ("",),
        ("certificates",),
        ("certified", "simulators"),
        ("floats",),
        ("scene",),
        ("motions",),
        ("effects",),
        ("equations",),
    ),
    "mechanisms": (
        ("", "table"),
        ("fates", "own_state"),
        ("approach", "sweep"),
        ("foreign", "spots"),
        ("derive",),
        ("input",),
        ("formulas", "zeros"),
    ),
    "compliant": (("motion",), ("side", "zeros"), ("contact", "fast", "patches"), ("slow",), ("model",)),
    "expansion": (("from_state",), ("chart", "true_solutions"), ("",), ("series",)),
    "integrator": (("norm_steps",), ("box_steps",), ("field",)),
    "signs": (("zeros",), ("gamma",), ("cover",)),
    "theta_function": (("",), ("arrays",), ("boxes", "value"), ("sums",), ("gamma",)),
}
LAYER_ROW = {layer: row for row, layers in enumerate(LAYERS) for layer in layers}
ROOM_ROW = {f"{layer}/{room}".rstrip("/"): row for layer, rows in ROOMS.items() for row, rooms in enumerate(rows)
            for room in rooms}  # fmt: skip

BOUND_MODULES = (
    "initial_values",
    "taylor",
    "beta_series",
    "splitting",
    "negative",
    "positive",
    "laplace",
    "finite_part",
    "reciprocal_gamma",
    "asymptotic_coefficients",
    "parameter_series",
    "box",
    "local_series",
    "carried_series",
    "recurrence",
    "majorant",
    "mean_value",
)
HEAVY = ("numpy", "scipy", "sympy", "matplotlib", "mpmath", "jinja2", "typer", "rich")

FILES = sorted(PACKAGE.rglob("*.py"))


@cache
def tree_of(path: Path) -> ast.Module:
    """The file as it is parsed; what the compiler warns of is judged by its own rule."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ast.parse(path.read_text(encoding="utf-8"), str(path))


@cache
def nodes_of(path: Path) -> tuple[ast.AST, ...]:
    """All nodes of the file: it is walked once for all rules."""
    return tuple(ast.walk(tree_of(path)))


def name_of(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


def room_of(path: Path) -> str:
    """``signs/gamma`` for gspot_verified/signs/gamma/x.py, "" for the package itself."""
    folder = path.relative_to(PACKAGE).parent.as_posix()
    return {"__main__.py": "cli"}.get(path.name, "") if folder == "." else folder


def imported_modules(path: Path, nodes: Iterable[ast.AST]) -> list[tuple[int, str]]:
    """(line, dotted name) of every import in the file, at any depth; ``from a import b`` gives ``a.b``."""
    found = []
    package = ["gspot_verified", *path.relative_to(PACKAGE).parts[:-1]]
    for node in nodes:
        if isinstance(node, ast.Import):
            found += [(node.lineno, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, *([node.module] if node.module else [])])
            found += [(node.lineno, f"{module}.{alias.name}") for alias in node.names]
    return found


def room_of_name(dotted: str) -> str:
    """The room of a module, a package or a name in one, by its dotted name without ``gspot_verified.``."""
    parts = dotted.split(".")
    length = next(n for n in range(len(parts), -1, -1) if (PACKAGE.joinpath(*parts[:n])).is_dir())
    return "/".join(parts[:length])


def inner_imports(path: Path) -> list[tuple[int, str]]:
    """(line, room) of every import from the package itself."""
    rooms = []
    for line, dotted in imported_modules(path, nodes_of(path)):
        first, _, rest = dotted.partition(".")
        if first == "gspot_verified" and not rest.startswith("__"):
            rooms.append((line, room_of_name(rest)))
    return rooms


def may_import(importer: str, imported: str) -> bool:
    """By the rows of their layers, and within a layer by those of their rooms."""
    if importer in ("", imported):
        return True
    above, below = importer.split("/")[0], imported.split("/")[0]
    if above != below:
        return below in LAYER_ROW and LAYER_ROW[above] < LAYER_ROW[below]
    return ROOM_ROW[importer] < ROOM_ROW[imported]


def test_there_is_something_to_check() -> None:
    assert {"numbers/balls.py", "theta_function/sums/taylor.py"} <= {name_of(path) for path in FILES}


def test_every_room_has_its_row() -> None:
    rooms = {room_of(path) for path in FILES} - {""}
    assert rooms <= set(ROOM_ROW) | set(LAYER_ROW)
    assert {room.split("/")[0] for room in rooms} == set(LAYER_ROW)
    assert {room for room in ROOM_ROW if "/" in room} <= rooms


def test_a_room_can_be_seen_at_once() -> None:
    """So many files, and one sentence that says what they are about."""
    files: dict[str, list[str]] = {}
    for path in FILES:
        files.setdefault(room_of(path), []).append(path.name)
    assert {room: names for room, names in files.items() if len(set(names) - {"__init__.py"}) > MAX_FILES} == {}
    assert [room for room, names in files.items() if "__init__.py" not in names and room != "cli"] == []


def imports_point_downwards(path: Path) -> None:
    room = room_of(path)
    wrong = [f"{name_of(path)}:{line} imports {name or 'the root'}" for line, name in inner_imports(path)
             if not may_import(room, name)]  # fmt: skip
    assert not wrong


def module_of(path: Path) -> str:
    """The dotted name of the module that the file is."""
    return ".".join([PACKAGE.name, *path.relative_to(PACKAGE).with_suffix("").parts]).removesuffix(".__init__")


def module_imports(path: Path, modules: frozenset[str]) -> set[str]:
    """Which of the modules the file imports, at any depth: the longest part of each dotted name that is one."""
    found = set()
    for _, dotted in imported_modules(path, nodes_of(path)):
        parts = dotted.split(".")
        prefixes = [".".join(parts[:length]) for length in range(len(parts), 0, -1)]
        found |= set(next(([name] for name in prefixes if name in modules), []))
    return found


def import_circles(edges: dict[str, set[str]]) -> set[str]:
    """What is left when modules that import none of the others are taken away, again and again."""
    left = set(edges)
    while leaves := {module for module in left if not edges[module] & left}:
        left -= leaves
    return left


def test_there_is_no_import_circle() -> None:
    """Between the modules of a folder, and of the package: imports inside functions and for types count too."""
    modules = frozenset(map(module_of, FILES))
    edges = {module_of(path): module_imports(path, modules) for path in FILES}
    assert edges["gspot_verified.theta_function.arrays.arrays"] >= {"gspot_verified.theta_function.value.evaluate"}
    assert import_circles(edges) == set()


def test_circles_are_found() -> None:
    assert import_circles({"a": {"b"}, "b": {"c"}, "c": set()}) == set()
    assert import_circles({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": set()}) == {"a", "b", "c"}
    assert import_circles({"a": {"a"}}) == {"a"}


@pytest.mark.parametrize(
    ("importer", "imported", "allowed"),
    [
        ("cli", "report", True),
        ("report", "cli", False),
        ("paper/section_1", "cost/times", False),
        ("cost", "paper", False),
        ("theta_function/value", "signs/gamma", False),
        ("signs/gamma", "theta_function/value", True),
        ("signs/zeros", "signs/gamma", True),
        ("signs/gamma", "signs/zeros", False),
        ("mechanisms/sweep", "mechanisms/approach", False),
        ("mechanisms", "mechanisms/spots", True),
        ("mechanisms/spots", "mechanisms", False),
        ("numbers", "theta_function", False),
        ("numbers", "numbers", True),
        ("theta_function", "", False),
        ("theta_function", "unheard_of", False),
        ("", "cli", True),
    ],
)
def test_the_rule_itself(importer: str, imported: str, allowed: bool) -> None:
    assert may_import(importer, imported) is allowed


def test_the_scan_sees_every_form_of_import() -> None:
    source = (
        "import gspot_verified.cli\nfrom gspot_verified import cli as c\nfrom gspot_verified.cli import main\n"
        "from ..cli import main\nfrom .. import cli\ndef f():\n    from gspot_verified import cli\n"
    )
    dotted = [name for _, name in imported_modules(PACKAGE / "theta_function" / "x.py", ast.walk(ast.parse(source)))]
    assert len(dotted) == 6
    assert all(name.startswith("gspot_verified.cli") for name in dotted)


def only_balls_touches_the_context_of_flint(path: Path) -> None:
    if path == PACKAGE / "numbers" / "balls.py":
        return
    modules = [name for _, name in imported_modules(path, nodes_of(path)) if name.split(".")[0] == "flint"]
    wrong = [name for name in modules if name.endswith((".ctx", ".*")) or name.count(".") > 1]
    assert not wrong
    # `import flint` gives ctx by another road: only what describes the module may be read through it.
    through = [n.attr for n in nodes_of(path)
               if isinstance(n, ast.Attribute) and isinstance(n.value, ast.Name) and n.value.id == "flint"]  # fmt: skip
    assert all(name.startswith("__") for name in through)
    bare = [n for n in nodes_of(path) if isinstance(n, ast.Name) and n.id == "flint"]
    assert len(bare) == len(through)
    renamed = [a.asname for n in nodes_of(path) if isinstance(n, ast.Import) for a in n.names
               if a.name.split(".")[0] == "flint" and a.asname]  # fmt: skip
    assert not renamed
    assert not [n for n in nodes_of(path) if isinstance(n, ast.Constant) and n.value == "flint"]


def nobody_takes_the_context_from_balls(path: Path) -> None:
    hidden = (
        "gspot_verified.numbers.balls.ctx",
        "gspot_verified.numbers.balls._lock",
        "gspot_verified.numbers.balls.*",
    )
    assert not [name for _, name in imported_modules(path, nodes_of(path)) if name in hidden]
    attributes = [n.lineno for n in nodes_of(path) if isinstance(n, ast.Attribute) and n.attr == "ctx"]
    assert not attributes


def sources_compile_without_a_warning(path: Path) -> None:
    """An invalid escape such as ``\\|`` is an error when warnings are, and only until a .pyc hides it."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        compile(path.read_text(encoding="utf-8"), str(path), "exec")


def test_files_are_short() -> None:
    lengths = {name_of(path): len(path.read_text(encoding="utf-8").splitlines()) for path in FILES}
    assert {name: length for name, length in lengths.items() if length > MAX_LINES} == {}


def test_init_files_are_the_public_list_and_nothing_else() -> None:
    allowed = (ast.Import, ast.ImportFrom)
    wrong = []
    for path in FILES:
        for node in tree_of(path).body if path.name == "__init__.py" else []:
            docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
            listing = isinstance(node, ast.Assign | ast.AnnAssign) and all(
                isinstance(target, ast.Name) and target.id.startswith("__")
                for target in (node.targets if isinstance(node, ast.Assign) else [node.target])
            )
            # A public list that loads on demand needs the module functions of PEP 562.
            lazy = isinstance(node, ast.FunctionDef) and node.name in ("__getattr__", "__dir__")
            if not (docstring or listing or lazy or isinstance(node, allowed)):
                wrong.append(f"{name_of(path)}:{node.lineno}")
    assert not wrong


def undocumented(path: Path) -> list[str]:
    """Public functions, classes and methods without a docstring."""
    missing = []

    def visit(body: list[ast.stmt], prefix: str) -> None:
        for node in body:
            if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
                continue
            if node.name.startswith("_") or any(ast.unparse(d).endswith("overload") for d in node.decorator_list):
                continue
            if not (ast.get_docstring(node) or "").strip():
                missing.append(f"{name_of(path)}:{node.lineno} {prefix}{node.name}")
            if isinstance(node, ast.ClassDef):
                visit(node.body, f"{node.name}.")

    visit(tree_of(path).body, "")
    return missing


def public_names_have_docstrings(path: Path) -> None:
    assert not undocumented(path)


def modules_have_docstrings(path: Path) -> None:
    assert ast.get_docstring(tree_of(path)) or not path.read_text(encoding="utf-8").strip()


@pytest.mark.parametrize("module", BOUND_MODULES)
def test_bound_modules_name_their_proof_page(module: str) -> None:
    path = next((PACKAGE / "theta_function").rglob(f"{module}.py"))
    pages = re.findall(r"proofs/[A-Za-z0-9_/-]+\.md", ast.get_docstring(tree_of(path)) or "")
    assert pages, f"{name_of(path)} names no page"
    assert [page for page in pages if not (ROOT / page).is_file()] == []


def whoever_adds_a_remainder_names_a_proof_page(path: Path) -> None:
    if path == PACKAGE / "numbers" / "balls.py":
        return
    calls = [n for n in nodes_of(path) if isinstance(n, ast.Name) and n.id == "add_remainder"]
    assert not calls or "proofs/" in (ast.get_docstring(tree_of(path)) or "")


def every_page_that_is_named_exists(path: Path) -> None:
    pages = re.findall(r"proofs/[A-Za-z0-9_/-]+\.md", path.read_text(encoding="utf-8"))
    assert [page for page in pages if not (ROOT / page).is_file()] == []


def quadrature_is_called_where_its_contract_stands(path: Path) -> None:
    """An integrand that ignores ``analytic`` gives a wrong ball without a warning."""
    calls = [n for n in nodes_of(path) if isinstance(n, ast.Attribute) and n.attr == "integral"
             and ast.unparse(n) == "acb.integral"]  # fmt: skip
    assert not calls or path == PACKAGE / "theta_function" / "sums" / "quadrature.py"


RULES = (
    imports_point_downwards,
    only_balls_touches_the_context_of_flint,
    nobody_takes_the_context_from_balls,
    sources_compile_without_a_warning,
    public_names_have_docstrings,
    modules_have_docstrings,
    whoever_adds_a_remainder_names_a_proof_page,
    every_page_that_is_named_exists,
    quadrature_is_called_where_its_contract_stands,
)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_the_rules_of_a_file(path: Path) -> None:
    for rule in RULES:
        rule(path)


def test_the_import_is_light() -> None:
    script = f"import sys, gspot_verified; print(*(name for name in {HEAVY!r} if name in sys.modules))"
    run = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert run.stdout.split() == []
