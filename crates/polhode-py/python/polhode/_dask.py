"""Parts of a sweep on a Dask cluster."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Iterator

from distributed import Client, LocalCluster, as_completed

from .batch import Plan, compute

if TYPE_CHECKING:
    from .sweep import Done, Parts


def parts(address: str, plan: Plan, missing: Parts, workers: int) -> Iterator[Done]:
    """The missing parts as they are done. A part that is lost with its worker is computed again: by Dask, which knows how."""
    with _cluster(address, workers) as client:
        # Nothing but this iterator knows the futures, so that a part's memory is free once it has been written.
        waiting = as_completed(
            client.map(partial(_part, plan), list(missing.items()), pure=False),
            with_results=True,
        )
        for _, done in waiting:
            yield done


def _part(plan: Plan, part: tuple[int, tuple[int, int]]) -> Done:
    number, (start, stop) = part
    return (number, *compute(plan, start, stop))


def _cluster(address: str, workers: int) -> Client:
    """A client of a cluster; one on this machine has so many processes of one thread."""
    if address != "local":
        return Client(f"tcp://{address}")
    local = LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, host="127.0.0.1")
    return Client(local)
