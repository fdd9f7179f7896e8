"""What each test costs, as recorded in ``costs.json``: which of them `make test` and `make quick` leave out.

``make costs`` measures all tests but the slow ones: seconds of the processor, of the test and of what it starts.
`make test` leaves out what costs more than LIMIT, but keeps the cheapest case of each test that costs no more than
KEPT; `make test-all`, mutation testing and a run of pytest by itself leave nothing out. A test without a record runs.
`make quick` runs the files that can notice what has changed, the nearest first, within a budget: ``python -m costs``
prints them.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from mutants.choice import importing, mirrored

ROOT = Path(__file__).resolve().parents[1]
RECORD = ROOT / "tests" / "costs.json"
LEAST, LIMIT, KEPT = 0.05, 0.1, 0.2
"""Seconds: what is worth a row; what the fast set may cost a test; what its cheapest case may."""
BUDGET = 40.0
_ALWAYS = ("tests/house/test_layout.py", "tests/house/test_public.py", "tests/house/test_architecture.py")


def recorded(place: Path = RECORD) -> dict[str, float]:
    """The seconds of each test that costs LEAST or more; {}: nothing was recorded."""
    if not place.is_file():
        return {}
    found: dict[str, float] = json.loads(place.read_text(encoding="utf-8"))
    return found


def record(seconds: Mapping[str, float], place: Path = RECORD) -> None:
    """Write what was measured, one line a test; a name that holds the place of this copy is that of no other one."""
    named = sorted((name, cost) for name, cost in seconds.items() if str(ROOT) not in name)
    rows = {name: round(cost, 2) for name, cost in named if cost >= LEAST}
    place.write_text(json.dumps(rows, indent=0, ensure_ascii=False) + "\n", encoding="utf-8")


def costly(seconds: Mapping[str, float]) -> frozenset[str]:
    """The tests that the fast set leaves out."""
    cases: dict[str, list[str]] = {}
    for name in seconds:
        cases.setdefault(name.split("[", 1)[0], []).append(name)
    kept = {min(names, key=lambda name: (seconds[name], name)) for names in cases.values()}
    return frozenset(name for name, cost in seconds.items() if cost > LIMIT and not (name in kept and cost <= KEPT))


def changed_files() -> list[str]:
    """What differs from the last commit; where nothing does, what that commit has changed."""
    for asked in (["diff", "--name-only", "HEAD"], ["diff", "--name-only", "HEAD~1"]):
        new = _git("ls-files", "--others", "--exclude-standard") if asked[-1] == "HEAD" else []
        if found := [*_git(*asked), *new]:
            return found
    return []


def noticing(changed: Iterable[str]) -> list[str]:
    """The files with tests that can notice a change of these, the nearest first."""
    near: list[str] = []
    far: list[str] = []
    for name in changed:
        path = ROOT / name
        if not path.is_file():
            continue
        if name.startswith("tests/") and path.suffix == ".py":
            near += [name] if path.name.startswith("test_") else _users(path.stem)
        elif (name.startswith("gspot_verified/") and path.suffix == ".py") or name.startswith("proofs/checker/"):
            near += mirrored(ROOT, name)
            far += importing(ROOT, name)[1:]
            if name.startswith("gspot_verified/cli/"):
                near += [
                    path.relative_to(ROOT).as_posix() for path in sorted((ROOT / "tests" / "cli").glob("test_*.py"))
                ]
        elif name == "README.md":
            near += [name, "tests/docs/test_readme.py"]
        elif name.startswith("proofs/"):
            near += ["tests/proofs/test_proofs.py", "tests/docs/test_used_by.py", "tests/coq/test_prove.py"]
        elif name.startswith("docs/"):
            near.append("tests/docs/test_pages.py")
    return list(dict.fromkeys([*near, *_ALWAYS, *far]))


def within(files: Sequence[str], seconds: Mapping[str, float], budget: float) -> list[str]:
    """The first files, as long as their tests in the fast set fit into a budget of seconds; at least one."""
    left_out, spent = costly(seconds), dict.fromkeys(files, 0.0)
    for name, cost in seconds.items():
        if (file := name.split("::")[0]) in spent and name not in left_out:
            spent[file] += cost
    chosen: list[str] = []
    for file in files:
        budget -= spent[file]
        if budget < 0 and chosen:
            break
        chosen.append(file)
    return chosen


def _users(helper: str) -> list[str]:
    """Test files that import a module of the tests."""
    tests = sorted((ROOT / "tests").rglob("test_*.py"))
    return [
        path.relative_to(ROOT).as_posix() for path in tests if f"{helper} import" in path.read_text(encoding="utf-8")
    ]


def _git(*words: str) -> list[str]:
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False)
    return done.stdout.split()


if __name__ == "__main__":
    print(*within(noticing(changed_files()), recorded(), BUDGET))
