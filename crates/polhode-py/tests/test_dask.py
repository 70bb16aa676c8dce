"""Sweeps on a Dask cluster: workers that are killed, a scheduler that is, a cluster without workers; and engines that fail in other ways."""

from __future__ import annotations

import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from conftest import PLAN, digest, engines_for_tables
from polhode import PolhodeError, _cluster, batch, sweep


@contextmanager
def without_patience() -> Iterator[Any]:
    """Two workers of a scheduler that gives a part up with the first worker that is lost with it; but whose nannies may take their time."""
    import dask
    from distributed import LocalCluster

    options = {"threads_per_worker": 1, "processes": True, "host": "127.0.0.1", "dashboard_address": None}
    settings = {"distributed.scheduler.allowed-failures": 0, "distributed.deploy.lost-worker-timeout": "10 minutes"}
    with dask.config.set(settings), LocalCluster(n_workers=2, **options) as cluster:
        yield cluster


@pytest.mark.filterwarnings("default")
def test_workers_killed_again_and_again_change_no_byte(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=20_000))
    sweep.run(plan, tmp_path / "alone")
    drawn, killed = random.Random(11), list[int]()
    with without_patience() as cluster:

        def kill(done: int, members: int) -> None:
            # Of those that have not connected yet, nannies may lose count.
            there = [worker.pid for worker in cluster.workers.values() if worker.worker_address in cluster.scheduler.workers]
            living = [pid for pid in there if pid is not None and pid not in killed]
            if len(killed) < 3 and done < members and living and drawn.random() < 0.7:
                killed.append(drawn.choice(living))
                os.kill(killed[-1], signal.SIGKILL)

        address = cluster.scheduler_address.removeprefix("tcp://")
        sweep.run(plan, tmp_path / "cluster", on=f"dask://{address}", progress=kill)
    assert len(killed) == 3
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")


@pytest.mark.filterwarnings("default")
def test_a_part_that_loses_every_worker_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("polhode._dask.LOST_WORKERS", 0)
    with without_patience() as cluster:

        def kill(done: int, members: int) -> None:
            for worker in cluster.workers.values():
                if worker.pid is not None:
                    os.kill(worker.pid, signal.SIGKILL)

        address = cluster.scheduler_address.removeprefix("tcp://")
        with pytest.raises(PolhodeError, match=f"^dask://{address} cannot compute the plan: KilledWorker"):
            sweep.run(batch.Plan(PLAN.format(members=100_000)), tmp_path / "cluster", on=f"dask://{address}", progress=kill)


@contextmanager
def scheduler(folder: Path) -> Iterator[tuple[subprocess.Popen[bytes], str]]:
    """One without workers, in a process of its own, and its address."""
    told = folder / "scheduler.json"
    command = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--no-show"]
    process = subprocess.Popen([*command, "--scheduler-file", str(told)], stderr=subprocess.DEVNULL)
    try:
        until = time.monotonic() + 60.0
        while not (told.exists() and told.read_text()):
            assert time.monotonic() < until and process.poll() is None
            time.sleep(0.05)
        yield process, json.loads(told.read_text())["address"].removeprefix("tcp://")
    finally:
        process.kill()
        process.wait()


@contextmanager
def worker(address: str) -> Iterator[None]:
    command = [sys.executable, "-m", "distributed.cli.dask_worker", f"tcp://{address}", "--nthreads", "1", "--no-dashboard", "--no-nanny"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    try:
        yield
    finally:
        process.kill()
        process.wait()


@pytest.mark.filterwarnings("default")
def test_a_scheduler_that_dies_is_an_error_and_what_is_done_is_kept(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=12_000))
    sweep.run(plan, tmp_path / "alone")
    with scheduler(tmp_path) as (process, address), worker(address):
        with pytest.raises(ConnectionError, match=f"^the connection to dask://{address} was lost: .*; finished parts are saved: continue with resume=True$"):
            sweep.run(plan, tmp_path / "cluster", on=f"dask://{address}", progress=lambda done, members: process.kill())
    assert list((tmp_path / "cluster").rglob("*.parquet"))
    sweep.run(plan, tmp_path / "cluster", resume=True)
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")


@pytest.mark.filterwarnings("default")
def test_a_cluster_without_workers_is_told_and_given_up(tmp_path: Path) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(PLAN.format(members=40))
    with scheduler(tmp_path) as (_, address):
        url, command = f"dask://{address}", [sys.executable, "-m", "polhode.sweep", str(path), "-o", str(tmp_path / "out")]
        ended = subprocess.run([*command, "--on", url, "--worker-timeout", "3"], capture_output=True, text=True, timeout=120)
    warned, error = ended.stderr.splitlines()
    assert warned == f"warning: {url} has no worker: waiting for one at most 3 s"
    assert re.fullmatch(f"error: {url} has had no worker for [3-9] s; finished parts are saved: start workers, and continue with resume=True", error)
    assert ended.returncode == 2 and not ended.stdout


def test_no_worker_is_told_again_and_again(monkeypatch: pytest.MonkeyPatch) -> None:
    now, workers = [1000.0], [0]
    monkeypatch.setattr(_cluster.time, "monotonic", lambda: now[0])
    watch = _cluster.Watch("dask://here:1", 200.0, lambda: workers[0])
    heard: list[str] = []
    monkeypatch.setattr(_cluster, "warn", lambda text: heard.append(f"{now[0]:.0f}: {text}"))
    for now[0], workers[0] in [(1000, 0), (1001, 0), (1030, 0), (1062, 0), (1070, 2), (1100, 2), (1110, 0), (1200, 0)]:
        watch.look()
    assert heard == [
        "1000: dask://here:1 has no worker: waiting for one at most 200 s",
        "1062: dask://here:1 has no worker (for 62 s so far): waiting for one at most 200 s",
        "1110: dask://here:1 has no worker: waiting for one at most 200 s",
        "1200: dask://here:1 has no worker (for 90 s so far): waiting for one at most 200 s",
    ]
    now[0] = 1310.0
    with pytest.raises(TimeoutError, match="has had no worker for 200 s"):
        watch.look()


@pytest.mark.parametrize(
    ("raised", "wanted", "says"),
    [
        (RuntimeError("KilledWorker"), PolhodeError, "^dask://local cannot compute the plan: RuntimeError: KilledWorker\nhint: finished parts are saved"),
        (ConnectionError("refused"), ConnectionError, "^refused$"),
        (PolhodeError("the plan is another one"), PolhodeError, "^the plan is another one$"),
        (KeyboardInterrupt(), KeyboardInterrupt, "^$"),
    ],
)
def test_what_an_engine_raises_is_put_into_words(
    raised: BaseException, wanted: type[BaseException], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And the folder is not in use any more, whoever remembers the error."""
    plan = batch.Plan(PLAN.format(members=12_000))

    def parts(address: str, plan: batch.Plan, missing: sweep.Parts, *_: Any) -> Iterator[sweep.Done]:
        number, (start, stop) = next(iter(missing.items()))
        yield (number, *batch.compute(plan, start, stop))
        raise raised

    monkeypatch.setattr("polhode._dask.parts", parts)
    told: list[int] = []
    with pytest.raises(wanted, match=says):
        sweep.run(plan, tmp_path / "out", on="dask://local", progress=lambda done, members: told.append(done))
    assert told and 0 < told[0] < 12_000
    sweep.run(plan, tmp_path / "out", resume=True)


def test_a_mistake_in_progress_is_the_users(tmp_path: Path) -> None:
    def progress(done: int, members: int) -> None:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        sweep.run(batch.Plan(PLAN.format(members=40)), tmp_path / "out", progress=progress)


@pytest.mark.filterwarnings("default")
def test_dask_takes_tables_as_the_book_says() -> None:
    import dask.dataframe
    import polhode
    import pyarrow as pa

    plan = batch.Plan(PLAN.format(members=40))
    *before, last = [line for line in engines_for_tables() if not line.startswith("ray.")]
    names = {"dask": dask, "pa": pa, "plan": plan, "polhode": polhode}
    exec("\n".join(before), names)
    assert "dask.dataframe" in last
    with dask.config.set(scheduler="synchronous"):
        found = eval(last, names).compute()
    wanted = batch.simulate(batch.inputs(plan), plan).to_pandas()
    assert list(found.columns) == list(wanted.columns) and len(found) == 40
    for name in wanted.columns:
        one, other = found[name].tolist(), wanted[name].tolist()
        assert all(a == b or (a != a and b != b) or (a is None and b != b) for a, b in zip(one, other)), name
