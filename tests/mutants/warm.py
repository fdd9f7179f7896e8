"""Mutants of one file in forks of one process that has collected the tests already: a start costs milliseconds.

It is the same as a start from nothing when the change stands inside a function whose statement nothing has reached
while the tests were collected: no value that stands by then depends on it. The function's code is replaced where the
function stands, so that all who imported it meet the change.
"""

from __future__ import annotations

import gc
import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import CodeType, FunctionType

import pytest
from mutants.operators import Mutant, code_of
from mutants.process import Changed, Plugin, finish, limit

Work = Sequence[tuple[Mutant, list[str], float]]
"""Each mutant with the tests that it meets, in their order, and its seconds."""
COLD = 72
"""The exit code of a fork in which the code could not be replaced with certainty."""


def outcomes(root: Path, file: str, tests: Sequence[str], work: Work, workers: int) -> Iterator[tuple[Mutant, int]]:
    """Each mutant with the exit code of its tests, as they end; mutants that are missing at the end were not judged."""
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.close(reading)
        path = root / file
        code = compile(path.read_text(encoding="utf-8"), str(path), "exec")
        finish(root, tests, _Server(Changed(root, file, code), root, work, workers, writing))
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as pipe:
        for line in pipe:
            position, status = json.loads(line)
            yield work[position][0], status
    os.waitpid(child, 0)


class _Server(Plugin):
    """Collects the tests once; in place of running them it forks for each mutant."""

    def __init__(self, changed: Changed, root: Path, work: Work, workers: int, pipe: int) -> None:
        super().__init__(changed, sorted({test for _, tests, _ in work for test in tests}))
        self.root, self.work, self.workers, self.pipe = root, work, workers, pipe

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Judge every mutant."""
        items = {item.nodeid: item for item in session.items}
        running: dict[int, int] = {}
        for position, (mutant, tests, seconds) in enumerate(self.work):
            if len(running) == self.workers:
                self._reap(running)
            child = os.fork()
            if not child:
                _judge(session, [items[test] for test in tests], code_of(self.root, mutant), seconds)
            running[child] = position
        while running:
            self._reap(running)
        return True

    def _reap(self, running: dict[int, int]) -> None:
        child, status = os.wait()
        line = json.dumps([running.pop(child), os.waitstatus_to_exitcode(status)])
        os.write(self.pipe, f"{line}\n".encode())


def _judge(session: pytest.Session, items: list[pytest.Item], code: CodeType, seconds: float) -> None:
    status = COLD
    try:
        limit(seconds)
        if _replace(code):
            status = 1
            for item, following in zip(items, [*items[1:], None], strict=True):
                session.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
                if session.testsfailed:
                    break
            else:
                status = 0
    finally:
        os._exit(status)


def _replace(module: CodeType) -> bool:
    """Give every function of the file that stands in memory the code of the changed module; False: not certainly."""
    new: dict[tuple[str, int], list[CodeType]] = {}
    for code in _codes(module):
        new.setdefault((code.co_qualname, code.co_firstlineno), []).append(code)
    pairs = []
    for function in [value for value in gc.get_objects() if type(value) is FunctionType]:
        old = function.__code__
        if old.co_filename == module.co_filename:
            found = new.get((old.co_qualname, old.co_firstlineno), [])
            if old.co_qualname == "<lambda>":  # it stands outside every function: not what has changed
                continue
            if len(found) != 1 or found[0].co_freevars != old.co_freevars:
                return False
            pairs.append((function, found[0]))
    for function, code in pairs:
        function.__code__ = code
    return bool(pairs)


def _codes(code: CodeType) -> Iterator[CodeType]:
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield constant
            yield from _codes(constant)
