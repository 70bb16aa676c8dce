"""The same on Ray: two processes, which are killed again and again; and a cluster that this process is only a client of.

Ray is large: `cargo xtask test --ray` runs this, and the ordinary gate does not.
"""

from __future__ import annotations

import os
import random
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from conftest import PLAN, digest, engines_for_tables, satellite
from polhode import PolhodeError, PolhodeWarning, batch, sweep

MEMBERS = 20_000


def parent(pid: int) -> int:
    return int(Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])


def workers() -> list[int]:
    """The processes of this process's cluster that compute."""
    found = []
    for folder in Path("/proc").iterdir():
        try:
            if folder.name.isdigit() and b"ray::compute" in (folder / "cmdline").read_bytes():
                if parent(parent(int(folder.name))) == os.getpid():
                    found.append(int(folder.name))
        except (FileNotFoundError, ProcessLookupError):
            continue
    return found


@pytest.mark.filterwarnings("default")
def test_workers_killed_again_and_again_change_no_byte(tmp_path: Path) -> None:
    plan = batch.Plan(satellite(members=10_000))
    sweep.run(plan, tmp_path / "alone")
    drawn, killed = random.Random(11), list[int]()

    def kill(done: int, members: int) -> None:
        if len(killed) < 6 and done < members and drawn.random() < 0.5:
            for pid in drawn.sample(found, 1) if (found := workers()) else []:
                os.kill(pid, signal.SIGKILL)
                killed.append(pid)

    sweep.run(plan, tmp_path / "cluster", on="ray://local", workers=2, progress=kill)
    assert len(killed) >= 4
    assert digest(tmp_path / "cluster") == digest(tmp_path / "alone")


@pytest.mark.filterwarnings("default")
def test_a_part_that_loses_every_worker_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("polhode._ray.LOST_WORKERS", 0)

    def kill(done: int, members: int) -> None:
        for pid in workers():
            os.kill(pid, signal.SIGKILL)

    with pytest.raises(PolhodeError, match="^ray://local cannot compute the plan: WorkerCrashedError"):
        sweep.run(batch.Plan(satellite(members=10_000)), tmp_path / "cluster", on="ray://local", workers=2, progress=kill)


@pytest.mark.filterwarnings("default")
def test_what_a_worker_refuses_is_said_as_it_says_it(tmp_path: Path) -> None:
    class Impossible(batch.Plan):
        """Arrives as another plan, as one does whose files differ there."""

        def __reduce__(self) -> tuple[Any, ...]:
            return batch._arrived, (batch.Plan, self.text, str(self._native.path), "0" * 64)

    plan = Impossible(PLAN.format(members=40))
    with pytest.raises(PolhodeError, match="is different on this machine"):
        sweep.run(plan, tmp_path / "cluster", on="ray://local", workers=1)


@contextmanager
def head(processors: int) -> Iterator[tuple[Path, str]]:
    """A cluster that runs already: its program, and its address for clients."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    ray = Path(sys.executable).with_name("ray")
    # Ray's proxy forks the server for a client while other threads call gRPC, whose handlers of a fork now and then end it by SIGSEGV.
    surroundings = {**os.environ, "GRPC_ENABLE_FORK_SUPPORT": "0"}
    start = [ray, "start", "--head", f"--num-cpus={processors}", "--node-ip-address=127.0.0.1", f"--ray-client-server-port={port}"]
    subprocess.run([*start, "--include-dashboard=false", "--disable-usage-stats"], check=True, capture_output=True, env=surroundings)
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
def test_a_cluster_that_does_not_answer_is_told(tmp_path: Path) -> None:
    with pytest.raises(ConnectionError, match="^ray://127.0.0.1:1 does not answer: .*RAY_AUTH_MODE=token"):
        sweep.run(batch.Plan(PLAN.format(members=40)), tmp_path / "out", on="ray://127.0.0.1:1")


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
        with pytest.raises((ConnectionError, PolhodeError), match=f"^(the connection to {address} was lost|{address} cannot compute the plan)"):
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
