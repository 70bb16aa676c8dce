"""The same on Ray: two processes, one of which is killed in the middle; and a cluster that this process is only a client of.

No part of the gate, as Ray is large: `pip install 'ray[data,client]'`, and `pytest tests/test_ray.py`.
"""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from conftest import PLAN, digest, engines_for_tables
from polhode import PolhodeError, PolhodeWarning, batch, sweep

MEMBERS = 20_000


def parent(pid: int) -> int:
    return int(Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])


def workers() -> list[int]:
    """The processes of this process's cluster that compute."""
    found = []
    for folder in Path("/proc").iterdir():
        try:
            if folder.name.isdigit() and b"ray::MapBatches" in (folder / "cmdline").read_bytes():
                if parent(parent(int(folder.name))) == os.getpid():
                    found.append(int(folder.name))
        except (FileNotFoundError, ProcessLookupError):
            continue
    return found


@pytest.mark.filterwarnings("default")
def test_a_killed_worker_changes_no_byte(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=MEMBERS))
    sweep.run(plan, tmp_path / "alone")
    killed: list[int] = []

    def kill(done: int, members: int) -> None:
        if not killed and members // 5 < done < members:
            for pid in workers()[:1]:
                os.kill(pid, signal.SIGKILL)
                killed.append(pid)

    sweep.run(plan, tmp_path / "cluster", on="ray://local", workers=2, progress=kill)
    assert killed
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")


@contextmanager
def head(processors: int) -> Iterator[tuple[Path, str]]:
    """A cluster that runs already: its program, and its address for clients."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    ray = Path(sys.executable).with_name("ray")
    start = [ray, "start", "--head", f"--num-cpus={processors}", "--node-ip-address=127.0.0.1", f"--ray-client-server-port={port}"]
    subprocess.run([*start, "--include-dashboard=false", "--disable-usage-stats"], check=True, capture_output=True)
    try:
        yield ray, f"ray://127.0.0.1:{port}"
    finally:
        subprocess.run([ray, "stop", "--force"], check=True, capture_output=True)


@pytest.mark.filterwarnings("default")
def test_a_client_outside_the_cluster_gets_the_same_bytes(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=MEMBERS))
    sweep.run(plan, tmp_path / "alone")
    with head(2) as (_, address):
        sweep.run(plan, tmp_path / "cluster", on=address)
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")


@pytest.mark.filterwarnings("default")
def test_a_cluster_without_processors_is_told_and_given_up(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=40))
    with head(0) as (_, address), pytest.warns(PolhodeWarning, match="has no worker"):
        with pytest.raises(TimeoutError, match=f"^{address} has had no worker for"):
            sweep.run(plan, tmp_path / "out", on=address, worker_timeout=3.0)


@pytest.mark.filterwarnings("default")
def test_a_cluster_that_dies_is_an_error_and_what_is_done_is_kept(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=MEMBERS))
    stopped: list[int] = []

    def stop(done: int, members: int) -> None:
        if not stopped:
            stopped.append(done)
            subprocess.run([ray, "stop", "--force"], check=True, capture_output=True)

    with head(2) as (ray, address):
        with pytest.raises((ConnectionError, PolhodeError), match=f"^{address} (was lost on the way|cannot compute the plan)"):
            sweep.run(plan, tmp_path / "cluster", on=address, progress=stop)
    sweep.run(plan, tmp_path / "cluster", resume=True)
    sweep.run(plan, tmp_path / "alone")
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")


@pytest.mark.filterwarnings("default")
def test_ray_takes_tables_as_the_book_says() -> None:
    import polhode
    import pyarrow as pa
    import ray

    plan = batch.Plan(PLAN.format(members=40))
    lines = engines_for_tables()
    last = next(k for k, line in enumerate(lines) if line.startswith("ray."))
    names = {"ray": ray, "pa": pa, "plan": plan, "polhode": polhode}
    exec("\n".join(lines[:last]), names)
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, _node_ip_address="127.0.0.1")
    try:
        found = eval(lines[last], names).to_pandas()
    finally:
        ray.shutdown()
    wanted = batch.simulate(batch.inputs(plan), plan).to_pandas()
    assert list(found.columns) == list(wanted.columns)
    assert found.sort_values("member")["status"].tolist() == wanted["status"].tolist()
