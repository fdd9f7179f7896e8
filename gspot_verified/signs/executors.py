"""Where work runs: in this process, in a pool of processes, or on a Dask cluster, all as ``concurrent.futures``."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from typing import Any, TypeVar

_Result = TypeVar("_Result")

_MAX_WORKERS = 1_024


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

    :raises ValueError: the number of workers is not in 1..1024, or Dask (``distributed``) is not installed.

    >>> with executor() as pool:
    ...     pool.submit(max, 2, 3).result()
    3
    """
    if type(workers) is not int or not 1 <= workers <= _MAX_WORKERS:
        raise ValueError(f"workers must be an int in 1..{_MAX_WORKERS}")
    if scheduler is not None:
        yield from _dask(scheduler)
    elif workers == 1:
        yield InProcessExecutor()
    else:
        import multiprocessing
        from concurrent.futures import ProcessPoolExecutor

        # Fresh processes: flint's global context of this one is not inherited half-changed.
        with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn")) as pool:
            yield pool


def _dask(scheduler: str) -> Iterator[Executor]:
    try:
        from distributed import Client
    except ImportError:
        raise ValueError("a scheduler needs Dask: install the extra gspot_verified[distributed]") from None
    connect: Any = Client  # its annotations are partial
    with connect(scheduler, timeout="20s", set_as_default=False) as client:
        yield client.get_executor(pure=False)
