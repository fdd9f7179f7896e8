"""Where work runs: in this process, in a pool of processes, or on a Dask cluster, all as ``concurrent.futures``."""

from __future__ import annotations

import os
import re
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import BrokenExecutor, Executor, Future, as_completed
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.process import BaseProcess

_Result = TypeVar("_Result")

_MAX_WORKERS = 1_024  # a limit of input: ValueError beyond it
_IN_FLIGHT = 256  # calls that are given out and not yet taken back: more than the workers of one machine
_ENDED = "a worker process was ended from outside (killed, or out of memory)"
_ADDRESS = re.compile(r"((tcp|tls|ucx|ws|wss)://)?(\[[0-9A-Fa-f:.%]+\]|[^\s:/\[\]]+):[0-9]{1,5}/?|inproc://\S+")
"""Of a scheduler. Asked before Dask is: it answers to anything else after 40 seconds."""
_ENDED = "a worker process was ended from outside (killed, or out of memory)"


class WorkerEndedError(RuntimeError):
    """A worker process was ended from outside, as where the memory is too small; what was kept stays."""


class InProcessExecutor(Executor):
    """Runs each call at once, in this process. An interrupt is not caught."""

    def submit(self, function: Callable[..., _Result], /, *args: Any, **kwargs: Any) -> Future[_Result]:
        """A future that is done already."""
        future: Future[_Result] = Future()
        try:
            future.set_result(function(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


@contextmanager
def executor(workers: int = 1, scheduler: str | None = None) -> Iterator[Executor]:
    """An executor: in-process for one worker, a pool of processes for more, or Dask's at the address ``scheduler``.

    :raises ValueError: the number of workers is not in 1..1024, it stands beside a scheduler, which has workers of its
        own, the scheduler is no address, or Dask (``distributed``) is not installed.
    :raises WorkerEndedError: a process of the pool was ended from outside.

    >>> with executor() as pool:
    ...     pool.submit(max, 2, 3).result()
    3
    """
    if type(workers) is not int or not 1 <= workers <= _MAX_WORKERS:
        raise ValueError(f"workers must be an int in 1..{_MAX_WORKERS}")
    if scheduler is not None and workers != 1:
        raise ValueError("workers: the scheduler has workers of its own; give one of both")
    if scheduler is not None:
        yield from _dask(scheduler)
    elif workers == 1:
        yield InProcessExecutor()
    else:
        try:
            with _pool(workers) as pool:
                yield pool
        except BrokenExecutor:
            raise WorkerEndedError(_ENDED) from None


def cores() -> int:
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def as_they_end(pool: Executor, calls: Mapping[str, Callable[[], _Result]]) -> Iterator[tuple[str, _Result]]:
    """The name and the result of each call as it ends; they begin in the order given. In-process one after the other.

    :raises RuntimeError: a call raised an exception, or its process was ended from outside; the message has its name.

    >>> with executor() as pool:
    ...     list(as_they_end(pool, {"a": int, "b": str}))
    [('a', 0), ('b', '')]
    """
    ended: Iterator[tuple[str, Future[_Result]]]
    if isinstance(pool, InProcessExecutor):
        ended = ((name, pool.submit(call)) for name, call in calls.items())
    else:
        names = {pool.submit(call): name for name, call in calls.items()}
        ended = ((names[future], future) for future in as_completed(names))
    left = list(calls)
    for name, future in ended:
        try:
            result = future.result()
        except BrokenExecutor:
            raise WorkerEndedError(f"{_ENDED}; not done: {', '.join(left)}") from None
        except Exception as error:
            raise RuntimeError(f"{name}: {type(error).__name__}: {error}") from error
        left.remove(name)
        yield name, result


def in_order(pool: Executor, calls: Iterable[Callable[[], _Result]], in_flight: int = _IN_FLIGHT) -> Iterator[_Result]:
    """The results of the calls in their order; what a call raises is raised here.

    In-process none begins before its turn. Elsewhere at most ``in_flight`` calls are given out and not yet taken back,
    so that neither they nor their results pile up; the next calls are made (and taken from ``calls``) as results are
    taken.

    >>> with executor() as pool:
    ...     list(in_order(pool, [int, str]))
    [0, '']
    """
    if isinstance(pool, InProcessExecutor):
        yield from (call() for call in calls)
        return
    waiting: deque[Future[_Result]] = deque()
    for call in calls:
        if len(waiting) == in_flight:
            yield waiting.popleft().result()
        waiting.append(pool.submit(call))
    while waiting:
        yield waiting.popleft().result()


@contextmanager
def _pool(workers: int) -> Iterator[Executor]:
    """Fresh processes: flint's global context of this one is not inherited half-changed.

    After an error or an interrupt here they end at once; they end too when this process is killed.
    """
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    context = multiprocessing.get_context("spawn")
    theirs, ours = context.Pipe(duplex=False)
    others = set(multiprocessing.active_children())
    with theirs, ours:
        pool = ProcessPoolExecutor(workers, context, _begin_worker, (theirs, sys.prefix))
        try:
            yield pool
        except BaseException:
            _end_groups([child for child in multiprocessing.active_children() if child not in others])
            ours.close()
            pool.shutdown(cancel_futures=True)
            raise
        pool.shutdown()


def _end_groups(workers: list[BaseProcess]) -> None:
    """Each worker with the programs that it started. Left to itself it may be too late: when the first has ended, the
    pool ends the others, each alone."""
    for worker in workers:
        if worker.pid is not None and hasattr(os, "killpg"):
            with suppress(ProcessLookupError):  # it has no group yet, and then no program; the line ends it
                os.killpg(worker.pid, signal.SIGKILL)


def _begin_worker(line: Connection, prefix: str) -> None:
    """A process group of its own, with the programs that it starts; the group ends when the line closes.

    Without the module ``site``, as where Python is isolated, a worker does not know ``sys.prefix``.
    """
    sys.prefix = prefix
    if hasattr(os, "setpgid"):
        os.setpgid(0, 0)
    threading.Thread(target=_end_with, args=(line,), daemon=True).start()


def _end_with(line: Connection) -> None:
    line.poll(None)
    if hasattr(os, "killpg"):
        os.killpg(0, signal.SIGKILL)
    os._exit(1)


def _dask(scheduler: str) -> Iterator[Executor]:
    if not _ADDRESS.fullmatch(scheduler):
        raise ValueError(f'scheduler: expected an address such as "tcp://127.0.0.1:8786", got {scheduler[:60]!r}')
    try:
        from distributed import Client
    except ImportError:
        raise ValueError("a scheduler needs Dask: install the extra gspot_verified[distributed]") from None
    connect: Any = Client  # its annotations are partial
    with connect(scheduler, timeout="20s", set_as_default=False) as client:
        yield client.get_executor(pure=False)
