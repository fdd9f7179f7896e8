from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import threading
import warnings
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from functools import partial
from multiprocessing import Pipe
from pathlib import Path
from typing import Any

import pytest

from gspot_verified.certificates.text import certificate_text
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.mechanisms.table.approach_table import approach_table
from gspot_verified.mechanisms.table.approached_row import ApproachedRow
from gspot_verified.mechanisms.table.classified_row import ClassifiedRow
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.cover.sign import sign
from gspot_verified.signs.zeros.zeros import ZerosResult, zeros_on_range
from gspot_verified.work import executors
from gspot_verified.work.executors import InProcessExecutor, WorkerEndedError, as_they_end, executor, in_order

ROOT = Path(__file__).resolve().parents[2]


def text_of(result: ZerosResult) -> str:
    assert result.statement is not None
    return certificate_text(result.statement, result.columns)


@pytest.fixture(scope="module")
def expected() -> str:
    return text_of(zeros_on_range("2..4"))


@pytest.fixture
def importable(monkeypatch: pytest.MonkeyPatch) -> None:
    """Worker processes find the package where this process does."""
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")]))


@pytest.mark.parametrize("count", [0, 3, 700])
def test_results_in_order_with_few_calls_at_a_time(count: int) -> None:
    """However many there are, no more are given out than may wait; in-process one after the other."""
    made: list[int] = []

    def calls() -> Iterator[partial[int]]:
        for number in range(count):
            made.append(number)
            yield partial(int, number)

    with ThreadPoolExecutor(2) as pool:
        for taken, result in enumerate(in_order(pool, calls())):
            assert result == taken
            assert len(made) <= taken + executors._IN_FLIGHT + 1
    assert len(made) == count
    made.clear()
    for taken, _ in enumerate(in_order(InProcessExecutor(), calls()), 1):
        assert len(made) == taken


def test_what_a_call_raises_is_raised_in_its_turn() -> None:
    with ThreadPoolExecutor(1) as pool:
        results = in_order(pool, [int, partial(int, "x"), int])
        assert next(results) == 0
        with pytest.raises(ValueError, match="invalid literal"):
            next(results)


@pytest.mark.usefixtures("importable")
def test_a_pool_gives_the_same_certificates(expected: str) -> None:
    with executor(2) as pool:
        assert text_of(zeros_on_range("2..4", executor=pool)) == expected
        alone = sign("-inf..0", "[3..5]")
        assert sign("-inf..0", "[3..5]", executor=pool) == alone
        short = zeros_on_range("2..4", budget=9)
        assert zeros_on_range("2..4", budget=9, executor=pool) == short


def test_in_process(expected: str) -> None:
    with executor() as pool:
        assert isinstance(pool, InProcessExecutor)
        assert pool.submit(max, 2, 3).result() == 3
        assert isinstance(pool.submit(int, "x").exception(), ValueError)
        assert text_of(zeros_on_range("2..4", executor=pool)) == expected


def test_an_interrupt_is_not_kept_in_a_future() -> None:
    def interrupt() -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        InProcessExecutor().submit(interrupt)


@pytest.mark.parametrize("workers", [0, -1, 1025, 1.5, True, "2", None])
def test_bad_numbers_of_workers(workers: Any) -> None:
    with pytest.raises(ValueError, match="workers"), executor(workers):
        pass


def test_the_largest_number_of_workers() -> None:
    """A pool that is not asked for anything starts none of them."""
    with executor(1024) as pool:
        assert not isinstance(pool, InProcessExecutor)


@pytest.mark.parametrize("workers", [1, 2])
def test_a_call_that_fails_is_named(workers: int) -> None:
    calls = {"good": partial(int, "1"), "bad": partial(int, "x")}
    with pytest.raises(RuntimeError, match=r"^bad: ValueError: invalid literal"), executor(workers) as pool:
        dict(as_they_end(pool, calls))


def test_a_worker_that_is_ended_from_outside_is_told() -> None:
    calls = {"killed": partial(os._exit, 1)}
    with pytest.raises(WorkerEndedError, match=r"ended from outside \(.*\); not done: killed$"), executor(2) as pool:
        dict(as_they_end(pool, calls))
    with (
        pytest.raises(WorkerEndedError, match=r"ended from outside \(killed, or out of memory\)$"),
        executor(2) as pool,
    ):
        list(in_order(pool, calls.values()))


@pytest.mark.usefixtures("importable")
def test_an_error_ends_the_workers_of_its_own_pool_alone() -> None:
    with executor(2) as outer:
        assert outer.submit(max, 2, 3).result() == 3
        with pytest.raises(ValueError, match="invalid literal"), executor(2) as inner:
            inner.submit(int, "x").result()
        assert outer.submit(max, 6, 7).result() == 7


def test_a_worker_listens_to_its_line_and_ends_with_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """In a group of its own; where the group is left alive, the worker itself ends, with an error."""
    theirs, ours = Pipe(duplex=False)
    heard, told, done = threading.Event(), list[object](), list[tuple[str, int]]()

    def listen(line: object) -> None:
        told.append(line)
        heard.set()

    monkeypatch.setattr(os, "setpgid", lambda process, group: done.append(("setpgid", process or group)))
    monkeypatch.setattr(os, "killpg", lambda group, sent: done.append(("killpg", group or sent)))
    monkeypatch.setattr(os, "_exit", lambda code: done.append(("exit", bool(code))))
    with monkeypatch.context() as patch:
        patch.setattr(executors, "_end_with", listen)
        executors._begin_worker(theirs, sys.prefix)
        assert heard.wait(60)
    assert told == [theirs]
    ours.close()
    executors._end_with(theirs)
    assert done == [("setpgid", 0), ("killpg", signal.SIGKILL), ("exit", True)]
    theirs.close()


_LONG = """
import subprocess, sys, time
from functools import partial
from gspot_verified.work import executors
from gspot_verified.work.executors import as_they_end, executor

CODE = "import os, time; print(os.getpid(), os.getppid(), flush=True); time.sleep(3600)"

def long():
    if sys.argv[1] == "late":  # the worker comes too late to end its own group
        executors.os.killpg = lambda *_: time.sleep(3600)
    subprocess.call([sys.executable, "-c", CODE])

if __name__ == "__main__":
    with executor(2) as pool:
        dict(as_they_end(pool, {"long": long, "other": partial(time.sleep, 3600)}))
"""


def runs(process: int) -> bool:
    """Whether there is such a process; one that has ended and that nobody has asked for does not count."""
    state = Path(f"/proc/{process}/stat")
    return state.exists() and state.read_text().rpartition(")")[2].split()[0] != "Z"


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="no /proc on this system")
@pytest.mark.parametrize(
    ("sent", "worker"), [(signal.SIGINT, "soon"), (signal.SIGINT, "late"), (signal.SIGKILL, "soon")]
)
def test_nothing_is_left_of_a_run_that_was_interrupted_or_killed(
    tmp_path: Path, sent: signal.Signals, worker: str
) -> None:
    (tmp_path / "long.py").write_text(_LONG)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        [sys.executable, str(tmp_path / "long.py"), worker],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
        env=environment,
        # A job in the background inherits that SIGINT is ignored.
        preexec_fn=partial(signal.signal, signal.SIGINT, signal.SIG_DFL),
    ) as run:  # fmt: skip
        assert run.stdout is not None
        began = [int(word) for word in run.stdout.readline().split()]
        assert len(began) == 2
        assert all(map(runs, began))
        run.send_signal(sent)
        try:
            assert run.wait(300) != 0
        finally:
            run.kill()  # where it goes on, the test fails and does not wait for ever
        # Both hold the pipe, which ends when nobody does; the limit is for a failure alone.
        assert select.select([run.stdout], [], [], 300)[0]
        assert run.stdout.read() == ""


@pytest.fixture
def cluster(request: pytest.FixtureRequest) -> Iterator[Any]:
    request.getfixturevalue("importable")
    distributed = pytest.importorskip("distributed", reason="Dask (distributed) is not installed")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of distributed and what it imports, not of this package
        with distributed.LocalCluster(
            processes=True, n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1",
            silence_logs=50,
        ) as found:  # fmt: skip
            yield found


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning", "ignore::UserWarning")
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning", "ignore::RuntimeWarning")
@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_dask_cluster_that_loses_a_worker(cluster: Any, expected: str) -> None:
    killed: list[int] = []

    def kill_one(step: Any) -> None:
        if step.examined == 6:
            process = next(iter(cluster.workers.values())).process
            killed.append(process.pid)
            os.kill(process.pid, signal.SIGKILL)

    with executor(scheduler=cluster.scheduler_address) as pool:
        result = zeros_on_range("2..4", executor=pool, progress=kill_one)
    assert len(killed) == 1
    assert text_of(result) == expected


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning", "ignore::UserWarning")
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning", "ignore::RuntimeWarning")
@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_dask_cluster_gives_the_same_tables_and_sweeps(cluster: Any) -> None:
    oscillator, model = load("oscillator"), load("model system")
    over = {"beta": "9/4..15/4:40"}  # two portions
    values = [{"beta": f"{number}/32"} for number in range(70, 140)]
    states = [{"b": str(number)} for number in (-2, -3, -4, 2, -5)]

    def found(pool: Executor) -> tuple[Sweep, list[ClassifiedRow], list[ApproachedRow]]:
        swept = sweep(oscillator, over, executor=pool)
        classified = classify_table(oscillator, values, executor=pool)
        approached = approach_table(model, states, {"x": 0, "u": 3, "p": "1/2"}, executor=pool)
        return swept, list(classified), list(approached)

    with executor(scheduler=cluster.scheduler_address) as pool:
        there = found(pool)
    assert there == found(InProcessExecutor())
    assert {row.outcome for row in there[1]} == {"settled", "undecided"}
    assert {row.outcome for row in there[2]} >= {"settled", "refused"}
    assert there[0].verdict.outcome is Outcome.PROVED


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning", "ignore::UserWarning")
def test_without_dask_a_scheduler_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ValueError, match="install the extra"), executor(scheduler="tcp://127.0.0.1:1"):
        pass


@pytest.mark.parametrize("address", ["garbage", "", "tcp://", "tcp://host", "host:port", "ftp://host:1", "a b:1", "h:"])
def test_what_is_no_address_is_refused_at_once(address: str) -> None:
    """Dask itself answers after 40 seconds."""
    with pytest.raises(ValueError, match="scheduler: expected an address such as") as refused, executor(1, address):
        pass
    assert repr(address) in str(refused.value)


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "tls://[::1]:8786", "host.domain:8786", "inproc://h/1/2"])
def test_an_address_is_given_to_dask(monkeypatch: pytest.MonkeyPatch, address: str) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ValueError, match="install the extra"), executor(scheduler=address):
        pass


def test_a_scheduler_has_workers_of_its_own() -> None:
    with pytest.raises(ValueError, match="give one of both"), executor(2, "tcp://127.0.0.1:1"):
        pass
