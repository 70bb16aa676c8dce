"""What takes long gives the interpreter's lock away: other threads go on meanwhile."""

from __future__ import annotations

import sys
import threading
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np
import polhode
import pytest

TIMES = np.linspace(0.0, 1e3, 300_000)
MOTION = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.3, 0.5, 0.9])
TURNS = np.broadcast_to(np.eye(3), (400_000, 3, 3)).copy()


def robot(folder: Path) -> Path:
    """One of many links."""
    inertial = '<inertial><mass value="2"/><inertia ixx="0.2" iyy="0.3" izz="0.4" ixy="0" ixz="0" iyz="0"/></inertial>'
    links = [f'<link name="l{k}">{inertial}</link>' for k in range(300)]
    joints = [f'<joint name="j{k}" type="fixed"><parent link="l0"/><child link="l{k}"/></joint>' for k in range(1, 300)]
    path = folder / "robot.urdf"
    path.write_text(f'<robot name="many">{"".join(links + joints)}</robot>')
    return path


CALLS: dict[str, Callable[[Path], Callable[[], Any]]] = {
    "FreeMotion.at": lambda _: lambda: MOTION.at(TIMES),
    "FreeMotion.derivatives": lambda _: lambda: MOTION.derivatives(TIMES[:30_000]),
    "FreeMotion.error": lambda _: lambda: MOTION.error(TIMES),
    "Ensemble.at": lambda _: lambda: polhode.Ensemble(moments=[1, 2, 3], omega=np.full((3000, 3), 0.3)).at([1.0, 2.0], threads=1),
    "matrices": lambda _: lambda: polhode._native.quaternions_of_matrices("turns", TURNS.reshape(-1, 9)),
    "link_table": lambda folder: lambda path=robot(folder): polhode.link_table(path),
    "inertia of a robot": lambda folder: lambda path=robot(folder): polhode.inertia(path),
}


def alone(call: Callable[[], Any]) -> float:
    """The least time of a call, s."""
    found = float("inf")
    for _ in range(3):
        begun = time.perf_counter()
        call()
        found = min(found, time.perf_counter() - begun)
    return found


def until_another_runs(call: Callable[[], Any], tries: int, enough: float) -> float:
    """The least time from the start of a call to where another thread has the lock, s; where the call keeps it, that is after its end."""
    waits, first, ends, found = [False], [0.0], threading.Event(), float("inf")

    def work() -> None:
        while not ends.is_set():
            if waits[0]:
                first[0], waits[0] = time.perf_counter(), False

    other = threading.Thread(target=work)
    other.start()
    try:
        for _ in range(tries):
            waits[0], begun = True, time.perf_counter()
            call()
            while waits[0]:
                time.sleep(1e-4)
            found = min(found, first[0] - begun)
            if found < enough:
                break
    finally:
        ends.set()
        other.join()
    return found


@pytest.mark.parametrize("name", CALLS)
def test_another_thread_goes_on(name: str, tmp_path: Path) -> None:
    call = CALLS[name](tmp_path)
    takes = alone(call)
    assert takes > 2e-3, "a call that is too short to tell"
    assert until_another_runs(call, 20, takes / 2) < takes / 2


def test_what_keeps_the_lock_is_found() -> None:
    """Where there is one: free-threaded Python has none."""
    has_lock = getattr(sys, "_is_gil_enabled", lambda: True)()
    many = list(range(2_000_000))
    takes = alone(lambda: sum(many))
    assert (until_another_runs(lambda: sum(many), 5, takes / 2) > takes / 2) == has_lock
