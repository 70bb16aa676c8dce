"""Parts of a sweep on a Dask cluster."""

from __future__ import annotations

import logging
import time
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Any, Iterator

from distributed import Client, LocalCluster, as_completed

from ._cluster import Watch, lost
from .batch import Plan, compute

if TYPE_CHECKING:
    from ._parts import Done, Parts

#: Seconds between two looks whether a part is done.
POLL = 0.05


def parts(address: str, plan: Plan, missing: Parts, workers: int, worker_timeout: float | None) -> Iterator[Done]:
    """The missing parts as they are done. A part that is lost with its worker is computed again: by Dask, which knows how."""
    on = f"dask://{address}"
    with _client(address, workers) as client:
        watch = Watch(on, worker_timeout, lambda: _workers(client, on))
        # Nothing but this iterator knows the futures, so that a part's memory is free once it has been written.
        waiting = as_completed(
            client.map(partial(_part, plan), list(missing.items()), pure=False),
            with_results=True,
        )
        while not waiting.is_empty():
            while not waiting.has_ready():
                watch.look()
                time.sleep(POLL)
            _, done = next(waiting)
            # Of a scheduler that is lost, futures are cancelled, and their results are exceptions that are not raised.
            if isinstance(done, BaseException):
                raise lost(on, f"its scheduler gave up a part ({type(done).__name__})") from done
            yield done


def _part(plan: Plan, part: tuple[int, tuple[int, int]]) -> Done:
    number, (start, stop) = part
    return (number, *compute(plan, start, stop))


def _workers(client: Client, on: str) -> int:
    try:
        threads: Any = client.nthreads()  # of a client that does not wait it would be a coroutine
        return len(threads)
    except OSError as error:
        raise lost(on, "its scheduler does not answer") from error


@contextmanager
def _client(address: str, workers: int) -> Iterator[Client]:
    """A client of a cluster; one on this machine has so many processes of one thread."""
    # What a lost connection means is said here; the client would log its own traceback of it.
    log = logging.getLogger("distributed.client")
    before = log.level
    log.setLevel(logging.CRITICAL)
    try:
        if address != "local":
            with Client(f"tcp://{address}") as client:
                yield client
            return
        options = {"threads_per_worker": 1, "processes": True, "dashboard_address": None, "host": "127.0.0.1"}
        with LocalCluster(n_workers=workers, **options) as cluster, Client(cluster) as client:
            yield client
    finally:
        log.setLevel(before)
