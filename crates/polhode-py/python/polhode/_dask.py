"""Computation of the parts of a sweep on a Dask cluster."""

from __future__ import annotations

import logging
import time
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple

import dask.config
from distributed import CancelledError, Client, Future, KilledWorker, LocalCluster, TimeoutError, as_completed

from ._cluster import LOOK, LOST_WORKERS, Watch, lost
from .batch import Plan, compute

if TYPE_CHECKING:
    from ._parts import Done, Parts

#: Seconds between two checks whether a part is done.
POLL = 0.05

#: Settings of a cluster on this machine.
LOCAL = {
    # By default, Dask drops a worker for good if its nanny has not restarted it within 15 s. A busy
    # machine takes longer.
    "distributed.deploy.lost-worker-timeout": "10 minutes",
    # The workers would profile themselves 100 times a second and check their event loop 50 times a
    # second. That costs 3 % of two processors, and nobody sees the result.
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500 ms",
}


def parts(address: str, plan: Plan, missing: Parts, workers: int, worker_timeout: float | None) -> Iterator[Done]:
    """Yields the missing parts as they are done.

    Dask computes a part again if its worker is lost.
    """
    on = f"dask://{address}"
    with _client(address, workers) as client:
        watch = Watch(on, worker_timeout, lambda: _workers(client, on))
        # Only this iterator holds the futures, so a part's memory is freed once it has been
        # written. Parts are identified by the keys of their futures.
        sent: dict[Any, _Sent] = {}
        # Results are fetched one by one. If `as_completed` fetched a result while its worker is
        # lost, the result would never arrive.
        waiting = as_completed(_send(client, plan, [_Sent(part, 0) for part in missing.items()], sent))
        while not waiting.is_empty():
            while not waiting.has_ready():
                watch.look()
                time.sleep(POLL)
            future = next(waiting)
            part, workers_lost = sent.pop(future.key)
            try:
                done = _result(future, watch)
            except KilledWorker as error:
                # Dask gives up a part after a few lost workers, possibly only four. On clusters
                # whose workers come and go, that may be chance.
                workers_lost += error.allowed_failures + 1
                if workers_lost > LOST_WORKERS:
                    raise
                waiting.update(_send(client, plan, [_Sent(part, workers_lost)], sent))
                continue
            except (CancelledError, OSError) as error:
                if future.status == "error":
                    raise
                # The futures of a lost scheduler are cancelled.
                raise lost(on, f"its scheduler gave up a part ({type(error).__name__})") from error
            del future
            yield done


def _result(future: Future, watch: Watch) -> Done:
    """Returns the result of a finished future.

    If its worker is lost, Dask computes it again, and there may be no other worker.
    """
    while True:
        try:
            done: Done = future.result(timeout=LOOK)
            return done
        except TimeoutError:
            watch.look()


class _Sent(NamedTuple):
    """A part that the cluster computes."""

    #: Index of the part, and its first member and the one after its last.
    part: tuple[int, tuple[int, int]]
    #: Number of workers lost with this part, as far as Dask has reported.
    workers_lost: int


def _send(client: Client, plan: Plan, parts: list[_Sent], sent: dict[Any, _Sent]) -> list[Future]:
    """Sends parts to the cluster and records them by the keys of their futures."""
    futures: list[Future] = client.map(partial(_part, plan), [each.part for each in parts], pure=False)
    sent.update(zip((future.key for future in futures), parts))
    return futures


def _part(plan: Plan, part: tuple[int, tuple[int, int]]) -> Done:
    number, (start, stop) = part
    return (number, *compute(plan, start, stop))


def _workers(client: Client, on: str) -> int:
    try:
        threads: Any = client.nthreads()  # a coroutine for an asynchronous client
        return len(threads)
    except OSError as error:
        raise lost(on, "its scheduler does not answer") from error


@contextmanager
def _client(address: str, workers: int) -> Iterator[Client]:
    """Opens a client of a cluster; ``local`` starts one on this machine, with ``workers``
    single-threaded processes."""
    # The caller reports a lost connection. The client would also log its own traceback.
    log = logging.getLogger("distributed.client")
    before = log.level
    log.setLevel(logging.CRITICAL)
    try:
        if address != "local":
            with Client(f"tcp://{address}") as client:
                yield client
            return
        options = {"threads_per_worker": 1, "processes": True, "dashboard_address": None, "host": "127.0.0.1"}
        with dask.config.set(LOCAL), LocalCluster(n_workers=workers, **options) as cluster, Client(cluster) as client:
            yield client
    finally:
        log.setLevel(before)
