"""One forked process per run of the tests: with the module under test changed, and within limits of work and memory."""

from __future__ import annotations

import builtins
import contextlib
import importlib.abc
import importlib.machinery
import importlib.util
import json
import os
import resource
import signal
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from types import CodeType
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, settings
from mutants.choice import parts
from mutants.operators import Mutant, traced_code

NOT_LOADED = 71
_REPORTER = "__mutants_reach__"
_MEMORY = 4 * 2**30
_CACHED = type(lru_cache(len))
_OPTIONS = [
    "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:faulthandler", "--tb=no", "-x", "-m", "not slow",
    "-W", "ignore:Module already imported:pytest.PytestAssertRewriteWarning",
]  # fmt: skip


@dataclass
class Reach:
    """Which lines of a file the tests reach, each by itself and all while they are collected; CPU seconds of each."""

    collected: list[int] = field(default_factory=list)
    lines: dict[str, list[int]] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)

    def tests_of(self, mutant: Mutant) -> list[str]:
        """The tests that reach the mutant's statement (all, if it runs before them), quick and narrow ones first."""
        early = self.early(mutant)
        reached = [test for test, lines in self.lines.items() if early or mutant.line in lines]
        return sorted(reached, key=lambda test: ((self.seconds[test] + 0.01) * len(self.lines[test]), test))

    def early(self, mutant: Mutant) -> bool:
        """Whether the mutant's statement runs before the tests do."""
        return mutant.everywhere or mutant.line in self.collected

    def limit(self, tests: Sequence[str]) -> float:
        """How many seconds of the processor a mutant has for these tests."""
        return 5 + 3 * sum(self.seconds[test] for test in tests)


class Changed(importlib.abc.MetaPathFinder):
    """Gives the module under test its changed code; every other module is found as usual."""

    def __init__(self, root: Path, file: str, code: CodeType) -> None:
        self.module, self.code = file.removesuffix(".py").replace("/", "."), code
        self.path = Path(os.path.realpath(root / file))
        self.loaded = False

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> importlib.machinery.ModuleSpec | None:  # noqa: ARG002
        if fullname != self.module:
            return None
        loader = importlib.machinery.SourceFileLoader(fullname, str(self.path))
        loader.get_code = self._get_code  # type: ignore[method-assign]
        return importlib.util.spec_from_file_location(fullname, self.path, loader=loader)

    def install(self) -> None:
        """In front of pytest's own hook, which would read the file itself; and for who loads the file by its path."""
        sys.meta_path.insert(0, self)
        unchanged, path = importlib.machinery.SourceFileLoader.get_code, str(self.path)

        def get_code(loader: importlib.machinery.SourceFileLoader, fullname: str) -> CodeType | None:
            return self._get_code(fullname) if os.path.realpath(loader.path) == path else unchanged(loader, fullname)

        importlib.machinery.SourceFileLoader.get_code = get_code  # type: ignore[method-assign, assignment]

    def import_it(self) -> None:
        """Import the module where it is part of a package; a script is loaded by its tests."""
        if (self.path.parent / "__init__.py").is_file():
            importlib.import_module(self.module)

    def _get_code(self, _: str) -> CodeType:
        self.loaded = True
        return self.code


class Plugin:
    """Sets Hypothesis up (no shrinking: one failure is enough); chooses and orders the tests; records their reach."""

    def __init__(self, changed: Changed, chosen: Sequence[str] | None = None, parts: set[str] | None = None) -> None:
        self.changed, self.parts, self.alone = changed, parts, chosen is None
        self.chosen = None if chosen is None else {test: k for k, test in enumerate(chosen)}
        self.hit: set[int] = set()
        self.reach = Reach()

    @pytest.hookimpl(trylast=True)
    def pytest_configure(self, config: pytest.Config) -> None:
        config.addinivalue_line("markers", "xdist_group(name): of the plugin that is left out")
        quick = settings(phases=(Phase.explicit, Phase.generate), suppress_health_check=(HealthCheck.too_slow,))
        settings.register_profile("mutants", quick)
        settings.load_profile("mutants")

    @pytest.hookimpl(tryfirst=True)
    def pytest_load_initial_conftests(self) -> None:
        """Import the module before a conftest.py does, and as a user does: pytest would run the file a second time."""
        self.changed.install()
        with contextlib.suppress(Exception):  # what cannot be imported is reported when the tests are collected
            self.changed.import_it()

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        if self.parts:
            items[:] = [i for i in items if {m.args[0] for m in i.iter_markers("part")} <= self.parts]
        if self.chosen is not None:
            order = self.chosen
            items[:] = sorted((i for i in items if i.nodeid in order), key=lambda item: order[item.nodeid])

    def pytest_collection_finish(self) -> None:
        self.reach.collected = sorted(self.hit)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Any:
        if self.alone:
            _forget(self.changed.module.partition(".")[0])
        self.hit.clear()
        begin = time.process_time()
        result = yield
        self.reach.seconds[item.nodeid] = time.process_time() - begin
        self.reach.lines[item.nodeid] = sorted(self.hit)
        return result


def _forget(package: str) -> None:
    """Empty the caches of the package: a test reaches also what an earlier one has left there."""
    for name, module in list(sys.modules.items()):
        if name.partition(".")[0] == package and module is not None:
            for value in list(vars(module).values()):
                if isinstance(value, _CACHED):
                    value.cache_clear()


def start(root: Path, file: str, tests: Sequence[str], chosen: Sequence[str], code: CodeType, seconds: float) -> int:
    """Fork a process that runs the chosen tests on the changed code, and give its number at once."""
    child = os.fork()
    if child:
        return child
    limit(seconds)
    finish(root, tests, Plugin(Changed(root, file, code), chosen))
    raise AssertionError("the process has ended")


def limit(seconds: float) -> None:
    """Limit this process in time of the processor and in memory."""
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
    signal.alarm(int(10 * seconds) + 60)  # a mutant that waits for ever uses no time of the processor


def reach_of(root: Path, file: str, tests: Sequence[str]) -> Reach:
    """Run the tests as they stand and record which of them reach which lines of the file.

    :raises RuntimeError: they do not pass: then no mutant can be judged.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.close(reading)
        plugin = Plugin(Changed(root, file, traced_code(root, file, _REPORTER)), parts=parts(root, file))
        setattr(builtins, _REPORTER, plugin.hit.add)
        finish(root, tests, plugin, writing)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as pipe:
        text = pipe.read()
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    if status != 0:
        raise RuntimeError(f"{file}: its tests do not pass without a change (exit {status}): {' '.join(tests)}")
    return Reach(**json.loads(text))


def finish(root: Path, tests: Sequence[str], plugin: Plugin, pipe: int | None = None) -> None:
    """Run the tests in this process, send their reach if a pipe is given, and end the process."""
    code = 70
    try:
        os.chdir(root)
        quiet = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(quiet, stream)
        code = int(pytest.main([*_OPTIONS, *tests], plugins=[plugin]))
        if not plugin.changed.loaded:
            code = NOT_LOADED
        if pipe is not None:
            with os.fdopen(pipe, "w", encoding="utf-8") as file, contextlib.suppress(BrokenPipeError):
                json.dump(vars(plugin.reach), file)
    finally:
        os._exit(code)
