"""Other programs on the same question, where they are installed: PARI's ``gp``, and ore_algebra in Sage.

Each measurement is one process that takes its own time inside; starting the program is not counted. A program that is
not there is reported as not installed, never as an error.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.cost.times.baseline import right_digits
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.theta import theta

NOT_INSTALLED = "not installed"
_TRACE = re.compile(r"Warning|at top-level|in function|\^")

# getwalltime counts milliseconds: the call is repeated until 200 of them have passed (a longer one is not repeated).
# A first call that takes none of them is said to take as long as a repeated one.
_PARI = """
default(recover, 0);
default(parisizemax, "1G");
evaluate(t, b) = {{
  my(lower = [[1/3, 2/3], [2/3, 4/3], [4/3, 5/3]], z = t^3/9.);
  sum(j = 0, 2, gamma((j - b)/3)/gamma(-b)/3.^((3 - j + b)/3)*t^j/j!*hypergeom([(j - b)/3], lower[j + 1], z));
}}
default(realprecision, {digits});
start = getwalltime(); value = evaluate({tau}, {beta}); first = getwalltime() - start;
count = 0; start = getwalltime();
while(first + getwalltime() - start < 200, evaluate({tau}, {beta}); count++);
again = if(count, (getwalltime() - start)/count, first);
print(max(first, again)/1000.); print(again/1000.); print(value);
"""

_SAGE = """
import time
from sage.all import QQ, RealBallField, gamma
from ore_algebra import DifferentialOperators
operators, x, D = DifferentialOperators(QQ, 'x')
tau, beta, bits = QQ('{tau}'), QQ('{beta}'), int({digits}*3.33) + 32
R = RealBallField(bits)
def evaluate():
    b = R(beta)
    initial = [((j - b)/3).gamma()/(-b).gamma()/R(3)**((3 - j + b)/3)/(1 + (j > 1)) for j in range(3)]
    return (D**3 - x*D + beta).numerical_solution(initial, [0, tau], R('1e-{digits}'))
times = []
while not times or (len(times) < 20 and sum(times) < 0.2):
    start = time.perf_counter(); value = evaluate(); times.append(time.perf_counter() - start)
print(times[0]); print(sorted(times)[len(times)//2])
print((value.real() if hasattr(value, 'real') else value).mid())
"""


@dataclass(frozen=True, slots=True)
class Program:
    """A program that can be asked: its name here, what to look for, its arguments, and its script."""

    name: str
    executable: str
    arguments: tuple[str, ...]
    script: str
    guard_digits: int

    def text(self, tau: fmpq, beta: fmpq, digits: int) -> str:
        """The script for one question."""
        return self.script.format(tau=f"({tau})", beta=f"({beta})", digits=digits + self.guard_digits)


PARI = Program("PARI/GP", "gp", ("-q", "-f"), _PARI, guard_digits=10)
ORE_ALGEBRA = Program("Sage ore_algebra", "sage", ("--python", "-"), _SAGE, guard_digits=0)
PROGRAMS = (PARI, ORE_ALGEBRA)


@dataclass(frozen=True, slots=True)
class ExternalTime(Written):
    """What one program needed for one question: first call and repeated call, in seconds; or why there is no time."""

    program: str
    tau: str
    beta: str
    digits: int
    first: float | None
    again: float | None
    right: int | None
    note: str = ""


def ask(program: Program, tau: fmpq, beta: fmpq, digits: int, time_limit: float = 60.0) -> ExternalTime:
    """Let ``program`` evaluate Theta(tau, beta) to ``digits`` digits, and count how many of them are right."""
    executable = shutil.which(program.executable)
    if executable is None:
        return _without(program, tau, beta, digits, NOT_INSTALLED)
    try:
        done = subprocess.run(
            [executable, *program.arguments],
            input=program.text(tau, beta, digits),
            capture_output=True,
            text=True,
            timeout=time_limit,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return _without(program, tau, beta, digits, f"no answer within {time_limit:g} s")
    except OSError as error:
        return _without(program, tau, beta, digits, f"cannot be started: {error}")
    return _answer(program, tau, beta, digits, done)


def _answer(
    program: Program, tau: fmpq, beta: fmpq, digits: int, done: subprocess.CompletedProcess[str]
) -> ExternalTime:
    lines = done.stdout.split("\n")
    try:
        first, again, value = (line.replace(" ", "") for line in lines[:3])
        right = right_digits(value, theta(tau, beta, digits=digits + 5), digits)
        return ExternalTime(program.name, str(tau), str(beta), digits, float(first), float(again), right)
    except ValueError:
        return _without(program, tau, beta, digits, f"failed: {_last_line(done)}")


def _last_line(done: subprocess.CompletedProcess[str]) -> str:
    """The line that says what went wrong: PARI marks its own with ``***``, Python's is the last."""
    lines = [line.strip(" *") for line in done.stderr.splitlines() if line.strip()]
    marked = [line.strip(" *") for line in done.stderr.splitlines() if "***" in line and not _TRACE.search(line)]
    return (marked or lines or [f"exit code {done.returncode}"])[-1][:120]


def _without(program: Program, tau: fmpq, beta: fmpq, digits: int, note: str) -> ExternalTime:
    return ExternalTime(
        program=program.name, tau=str(tau), beta=str(beta), digits=digits, first=None, again=None, right=None, note=note
    )
