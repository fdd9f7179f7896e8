"""Mutation testing: ``make mutants FILES="gspot_verified/numbers/dyadic.py"``. See ``tests/mutants/README.md``."""

from __future__ import annotations

import argparse
import gc
import hashlib
import json
import os
import sys
import time
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from mutants.choice import importing, mirrored
from mutants.judged import Judged, outdated, read_judged, write_judged
from mutants.operators import Mutant, code_of, mutants_of
from mutants.process import Reach, reach_of, start
from mutants.survivors import complaints, is_listed, is_waived, read_survivors
from mutants.warm import COLD, outcomes

ROOT = Path(__file__).resolve().parents[2]
_PRELOADED = ("flint", "mpmath", "numpy", "sympy", "hypothesis.strategies")
_KILLED, _LIMIT, _SURVIVED = "killed", "killed by a limit", "survived"


def main(arguments: Sequence[str] | None = None, root: Path = ROOT) -> int:
    """0: every survivor is in the list. 1: one is not, or the list is out of date. 2: the tests fail unchanged."""
    parser = argparse.ArgumentParser(prog="make mutants", description=__doc__)
    parser.add_argument("files", nargs="+", help="source files or folders of the package")
    parser.add_argument("--sample", type=int, metavar="N", help="at most N mutants of each file")
    parser.add_argument("--seed", type=int, default=0, help="which sample (default 0)")
    parser.add_argument("--scope", metavar="NAME", action="append", help="only this function (Dyadic.parse), or module")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--resume", action="store_true", help="leave out what was killed before in the same sources")
    parser.add_argument("--tests", nargs="+", help="test files to use in place of those that are found")
    parser.add_argument("--stated", action="store_true", help="the sample that judged.toml states for each file")
    parser.add_argument(
        "--record", action="store_true", help="write what was judged without a complaint to judged.toml"
    )
    parser.add_argument("--wide", action="store_true", help="survivors: every test that imports the module, too")
    options = parser.parse_args(arguments)
    for name in _PRELOADED:  # once, before the forks; never the package itself
        __import__(name)
    gc.freeze()  # no process searches them for garbage
    listed = read_survivors(root / "tests" / "mutants" / "survivors.toml")
    table = root / "tests" / "mutants" / "judged.toml"
    rows = read_judged(table)
    wrong: list[str] = []
    for file in _files(root, options.files):
        everything = mutants_of(root, file)
        inside = [mutant for mutant in everything if options.scope is None or mutant.scope in options.scope]
        waived = [mutant for mutant in inside if is_waived(mutant, listed)]
        judged = [mutant for mutant in inside if mutant not in waived]
        size, seed = options.sample, options.seed
        if options.stated and everything:
            if file not in rows:
                wrong.append(f"is not in judged.toml: {file}")
                continue
            size, seed = rows[file].sample, rows[file].seed
            if not options.record:
                wrong += outdated(file, rows[file], len(everything))
        chosen = _sample(judged, size, seed)
        if not chosen:
            continue
        try:
            results = _Run(root, file, options.tests or mirrored(root, file), options.workers, options.resume).judge(
                chosen
            )
            left = [mutant for mutant in chosen if results[mutant] == _SURVIVED]
            if options.wide and left:
                results |= _Run(root, file, importing(root, file), options.workers, resume=False).judge(left)
        except RuntimeError as error:
            print(error, file=sys.stderr)
            return 2
        survived = [mutant for mutant in chosen if results[mutant] == _SURVIVED]
        killed = [mutant for mutant in chosen if results[mutant] != _SURVIVED]
        count = Counter(results.values())
        argued = sum(is_listed(mutant, listed) for mutant in survived)
        print(
            f"{file}: {len(everything)} mutants, {len(killed)} killed ({count[_LIMIT]} by a limit), {argued} survivors "
            f"argued, {len(survived) - argued} not argued, {len(waived)} in lines or functions argued as a whole, "
            f"{len(everything) - len(chosen) - len(waived)} not run",
            flush=True,
        )
        found = complaints(listed, everything, killed, survived)
        wrong += found
        if options.record and not found and options.scope is None:
            stated = None if len(chosen) == len(judged) else size
            row = Judged(stated, seed if stated else 0, len(everything), len(killed), argued, len(waived))
            rows = read_judged(table)  # another run may have written rows since
            if file not in rows or not rows[file].holds(row):
                rows[file] = row
                write_judged(table, rows)
    for text in wrong:
        print(f"\n{text}")
    missing = sorted({name for name in [*rows, *(key[0] for key in listed)] if not (root / name).is_file()})
    for name in missing:
        print(f"\nin the list or the table, but there is no such file: {name}")
    return 1 if wrong or missing else 0


def _files(root: Path, names: Sequence[str]) -> list[str]:
    paths = [root / name for name in names]
    files = [file for path in paths for file in (sorted(path.rglob("*.py")) if path.is_dir() else [path])]
    return [file.resolve().relative_to(root).as_posix() for file in files]


def _sample(mutants: list[Mutant], size: int | None, seed: int) -> list[Mutant]:
    """The ``size`` mutants whose hashes are least: a larger sample holds a smaller one, and other lines may change."""

    def order(mutant: Mutant) -> str:
        return hashlib.sha256(
            json.dumps([seed, mutant.file, mutant.scope, mutant.before, mutant.after]).encode()
        ).hexdigest()

    return sorted(sorted(mutants, key=order)[:size], key=lambda mutant: mutant.index)


class _Run:
    """The mutants of one file, each in a process of its own, as many at once as there are workers."""

    def __init__(self, root: Path, file: str, tests: Sequence[str], workers: int, resume: bool) -> None:
        self.root, self.journal = root, root / "build" / "mutants.jsonl"
        self.file, self.tests, self.workers = file, list(tests), workers
        self.digest = hashlib.sha256((root / file).read_bytes()).hexdigest()[:16]
        self.known = self._journal() if resume else set()

    def judge(self, mutants: Sequence[Mutant]) -> dict[Mutant, str]:
        """What became of each mutant."""
        results = {mutant: _KILLED for mutant in mutants if mutant.key in self.known}
        waiting = [mutant for mutant in reversed(mutants) if mutant not in results]
        reach = reach_of(self.root, self.file, self.tests) if waiting else Reach()
        running: dict[int, Mutant] = {}
        began = time.monotonic()
        warm = [mutant for mutant in reversed(waiting) if reach.tests_of(mutant) and not reach.early(mutant)]
        work = [(mutant, (tests := reach.tests_of(mutant)), reach.limit(tests)) for mutant in warm]
        for mutant, code in outcomes(self.root, self.file, self.tests, work, self.workers) if work else ():
            if code != COLD:
                results[mutant] = self._outcome(mutant, code)
                self._write(mutant, results[mutant])
                waiting.remove(mutant)
                self._show(len(waiting), began)
        while waiting or running:
            while waiting and len(running) < self.workers:
                mutant = waiting.pop()
                tests = reach.tests_of(mutant)
                if tests:
                    running[self._start(reach, mutant, tests)] = mutant
                else:
                    results[mutant] = _SURVIVED  # no test comes here
            if running:
                child, status = os.wait()
                mutant = running.pop(child)
                results[mutant] = self._outcome(mutant, os.waitstatus_to_exitcode(status))
                self._write(mutant, results[mutant])
            self._show(len(waiting) + len(running), began)
        print(file=sys.stderr)
        return results

    def _show(self, left: int, began: float) -> None:
        print(f"\r{self.file}: {left} left, {time.monotonic() - began:.0f} s ", end="", file=sys.stderr, flush=True)

    def _start(self, reach: Reach, mutant: Mutant, tests: list[str]) -> int:
        paths = sorted({test.split("::")[0] for test in tests}, key=self.tests.index)
        return start(self.root, self.file, paths, tests, code_of(self.root, mutant), reach.limit(tests))

    def _outcome(self, mutant: Mutant, code: int) -> str:
        """pytest: 0 passed, 1 failed, 2 to 4 tests or a conftest.py cannot be imported, or pytest itself breaks.

        None of these comes from the tests themselves: they have passed without a change.
        """
        if code < 0:
            return _LIMIT
        if code in (0, 1, 2, 3, 4):
            return _SURVIVED if code == 0 else _KILLED
        raise RuntimeError(f"pytest ended with {code} for {mutant}")

    def _journal(self) -> set[tuple[str, str]]:
        lines = self.journal.read_text(encoding="utf-8").splitlines() if self.journal.is_file() else []
        entries = [json.loads(line) for line in lines]
        return {tuple(e["key"]) for e in entries if e["digest"] == self.digest and e["outcome"] != _SURVIVED}

    def _write(self, mutant: Mutant, outcome: str) -> None:
        self.journal.parent.mkdir(exist_ok=True)
        with self.journal.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"digest": self.digest, "key": mutant.key, "outcome": outcome}) + "\n")


if __name__ == "__main__":
    sys.exit(main())
