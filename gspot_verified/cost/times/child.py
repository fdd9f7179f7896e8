"""One measurement in a process of its own: ``python -m gspot_verified.cost.times.child REQUEST``.

REQUEST is JSON: ``who`` ("ours", "baseline" or "mpmath"), ``tau`` and ``beta`` as fractions, ``digits``. Nothing is
warmed up: constants and Bernoulli numbers that FLINT or mpmath keep are computed inside the time. The answer is one
line of JSON: ``seconds``, ``processor`` (processor time), ``peak_bytes``, ``answered``, and ``first_attempt``, the
time of the baseline's first precision.
"""

from __future__ import annotations

import json
import resource
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.cost.times.baseline import Answer, flint_theta, mpmath_theta
from gspot_verified.numbers.balls import exact
from gspot_verified.theta_function.value.evaluate import evaluate

_STATUS = Path("/proc/self/status")


def perform(request: dict[str, Any]) -> dict[str, Any]:
    """Do the one call that ``request`` describes, and say how long it took and how much memory the process has used."""
    tau, beta, digits = _fraction(request, "tau"), _fraction(request, "beta"), int(request["digits"])
    calls: dict[str, Callable[[], object]] = {
        "ours": lambda: evaluate(tau, beta, digits=digits).reached or None,
        "baseline": lambda: flint_theta(tau, beta, digits=digits, max_bits=64 * digits),
        "mpmath": lambda: mpmath_theta(tau, beta, digits=digits),
    }
    call = calls[request["who"]]
    start, processor = time.perf_counter(), time.process_time()
    result = call()
    seconds, processor = time.perf_counter() - start, time.process_time() - processor
    first = result.seconds[0] if isinstance(result, Answer) else None
    return {
        "seconds": seconds,
        "processor": processor,
        "peak_bytes": peak_bytes(),
        "answered": result is not None,
        "first_attempt": first,
    }


def _fraction(request: dict[str, Any], name: str) -> fmpq:
    value = exact(request[name], name)
    if not isinstance(value, fmpq):
        raise ValueError(f"{name}: expected a fraction")
    return value


def peak_bytes() -> int:
    """The peak memory of this process.

    On Linux from /proc: ``getrusage`` would start from the size of the process that started this one.
    """
    if _STATUS.is_file():
        for line in _STATUS.read_text(encoding="ascii", errors="replace").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024


if __name__ == "__main__":
    print(json.dumps(perform(json.loads(sys.argv[1]))))
