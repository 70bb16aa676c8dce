"""A sweep on a Dask cluster of two processes, one of which is killed in the middle."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest
from conftest import PLAN, digest
from polhode import batch, sweep

MEMBERS = 100_000


@pytest.mark.filterwarnings("default")
def test_a_killed_worker_changes_no_byte(tmp_path: Path) -> None:
    from distributed import LocalCluster

    plan = batch.Plan(PLAN.format(members=MEMBERS))
    sweep.run(plan, tmp_path / "alone")
    killed: list[int] = []
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=None
    ) as cluster:
        before = {worker.pid for worker in cluster.workers.values()}

        def kill(done: int, members: int) -> None:
            if not killed and done >= members // 4:
                killed.append(next(iter(cluster.workers.values())).pid)
                os.kill(killed[0], signal.SIGKILL)
                assert done < members

        address = cluster.scheduler_address.removeprefix("tcp://")
        sweep.run(plan, tmp_path / "cluster", on=f"dask://{address}", progress=kill)
    assert killed and killed[0] in before
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")
