"""The memory of one call, in a process of its own: ``python -m gspot_verified.cost.alone REQUEST``.

REQUEST is JSON: ``part``, ``panel``, ``route``, ``position`` of the argument. The answer is one line of JSON:
``grown``, the peak memory during the call less what the process held before it; where the call starts another program
that is larger, the peak of that program.
"""

from __future__ import annotations

import importlib
import json
import resource
import sys
from pathlib import Path
from typing import Any

from gspot_verified.cost.times.child import peak_bytes

_LIBRARIES = ("mpmath", "scipy.integrate", "sympy")
"""Loaded before the call: what they take is not the call's."""
_STATUS = Path("/proc/self/status")


def perform(request: dict[str, Any]) -> dict[str, int]:
    """Do the call, and say how far memory grew."""
    from gspot_verified.cost.run import contestants_of

    for library in _LIBRARIES:
        importlib.import_module(library)
    name = (request["panel"], request["route"])
    [contestant] = [c for c in contestants_of(request["part"]) if c.own_name == name]
    call = contestant.call(contestant.all_arguments[request["position"]])
    before = held_bytes()
    call()
    children = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * (1 if sys.platform == "darwin" else 1024)
    return {"grown": max(peak_bytes() - before, children, 0)}


def held_bytes() -> int:
    """What the process holds now, on Linux; elsewhere its peak."""
    if _STATUS.is_file():
        for line in _STATUS.read_text(encoding="ascii", errors="replace").splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) * 1024
    return peak_bytes()


if __name__ == "__main__":
    print(json.dumps(perform(json.loads(sys.argv[1]))))
