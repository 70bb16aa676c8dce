"""Parts of a sweep on a Dask cluster."""

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

#: Seconds between two looks whether a part is done.
POLL = 0.05

#: What a cluster on this machine is told.
LOCAL = {
    # A worker that its nanny has not brought back within 15 s is dropped for good, unless Dask is told otherwise; a busy machine takes longer.
    "distributed.deploy.lost-worker-timeout": "10 minutes",
    # Its processes look 100 times a second at what they do, and 50 times at whether they answer: 3 % of two processors, and nobody is shown it.
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500 ms",
}


def parts(address: str, plan: Plan, missing: Parts, workers: int, worker_timeout: float | None) -> Iterator[Done]:
    """The missing parts as they are done. A part that is lost with its worker is computed again: by Dask, which knows how."""
    on = f"dask://{address}"
    with _client(address, workers) as client:
        watch = Watch(on, worker_timeout, lambda: _workers(client, on))
        # Nothing but this iterator knows the futures, so that a part's memory is free once it has been written; the parts are known by their keys.
        sent: dict[Any, _Sent] = {}
        # Results are asked for one by one: what `as_completed` asks for is never told if the worker that has it is lost just then.
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
                # Dask gives a part up after some workers, as few as four: where workers come and go, that may be chance.
                workers_lost += error.allowed_failures + 1
                if workers_lost > LOST_WORKERS:
                    raise
                waiting.update(_send(client, plan, [_Sent(part, workers_lost)], sent))
                continue
            except (CancelledError, OSError) as error:
                if future.status == "error":
                    raise
                # The futures of a scheduler that is lost are cancelled.
                raise lost(on, f"its scheduler gave up a part ({type(error).__name__})") from error
            del future
            yield done


def _result(future: Future, watch: Watch) -> Done:
    """The result of a future that is done; it is computed anew if the worker that has it is lost, and there may be no other."""
    while True:
        try:
            done: Done = future.result(timeout=LOOK)
            return done
        except TimeoutError:
            watch.look()


class _Sent(NamedTuple):
    """A part that is with the cluster."""

    #: Its number, and its first member and the one after its last.
    part: tuple[int, tuple[int, int]]
    #: How many workers have been lost while they had it, as far as Dask has said.
    workers_lost: int


def _send(client: Client, plan: Plan, parts: list[_Sent], sent: dict[Any, _Sent]) -> list[Future]:
    """Hands parts to the cluster, and remembers them by the keys of their futures."""
    futures: list[Future] = client.map(partial(_part, plan), [each.part for each in parts], pure=False)
    sent.update(zip((future.key for future in futures), parts))
    return futures


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
        with dask.config.set(LOCAL), LocalCluster(n_workers=workers, **options) as cluster, Client(cluster) as client:
            yield client
    finally:
        log.setLevel(before)
