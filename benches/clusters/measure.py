#!/usr/bin/env python3
"""Measures a sweep in one process, on Dask and on Ray, with and without killed workers.

Writes book/clusters-dask.md and book/clusters-ray.md.

    pip install distributed ray pyarrow ./crates/polhode-py
    python3 benches/clusters/measure.py           # measures, and writes measured.json and the pages
    python3 benches/clusters/measure.py --more    # adds a round to what was measured, or ends the one that was begun
    python3 benches/clusters/measure.py --page    # writes the pages of what was measured
    python3 benches/clusters/measure.py --check   # fails unless the pages are that
    python3 benches/clusters/measure.py --try 20000 dask ray   # a small sweep, on these; writes nothing

The plan is examples/sweeps/uncertain-satellite.toml with more members. A round is the sweep once in the threads of one process, and on each engine
once undisturbed and once while its workers are killed (SIGKILL, at times and of workers drawn by a seed); clusters are local, with as many
workers of one thread as the process has threads. Each run is a process of its own. Its time is that of `polhode.sweep.run`, which starts the cluster
and ends it; processors' time is that of the process and of all below it. A run fails unless its folder has the bytes of the first.
"""

from __future__ import annotations

import hashlib
import json
import os
import platform
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Iterator

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

from machine import processor, version  # noqa: E402

PLAN = HERE.parents[1] / "examples" / "sweeps" / "uncertain-satellite.toml"
MEASURED = HERE / "measured.json"
MEMBERS = 1_000_000
ROUNDS = 2
#: Number of threads of the single process, and of workers of a cluster.
WORKERS = 2
#: Interval between two inspections of the processes of a run, s.
LOOK = 0.25
#: Number of workers killed in a run: the mean for the duration of the sweep in one process, and the minimum.
KILLS, KILLS_AT_LEAST = 8, 4
SEED = 2026
#: Upper limit of the shared memory of all Ray processes.
BOUNDED = {"RAY_DEFAULT_OBJECT_STORE_MAX_MEMORY_BYTES": str(500 * 10**6)}
ALONE, ENGINES, KILLED = "alone", ("dask", "ray"), ", killed"
#: The runs of a round, in their order.
NAMES = (ALONE, *(engine + how for how in ("", KILLED) for engine in ENGINES))
PACKAGES = ("polhode", "distributed", "ray", "pyarrow")


def main() -> int:
    import page

    match sys.argv[1:]:
        case ["--one", on, members, folder]:
            one(on, int(members), Path(folder))
        case ["--check"]:
            return page.check(json.loads(MEASURED.read_text()))
        case ["--page"]:
            page.write(json.loads(MEASURED.read_text()))
        case ["--try", members, *engines] if members.isdigit() and set(engines) <= set(ENGINES):
            names = tuple(name for name in NAMES if name.removesuffix(KILLED) in {ALONE, *engines})
            for _ in runs(int(members), names, [{}], SEED):
                pass
        case ["--more"]:
            more(json.loads(MEASURED.read_text()))
            page.write(json.loads(MEASURED.read_text()))
        case []:
            found: dict[str, Any] = {**about(), "members": MEMBERS, "rounds": []}
            for _ in range(ROUNDS):
                more(found)
            page.write(found)
        case _:
            print(__doc__, file=sys.stderr)
            return 2
    return 0


def about() -> dict[str, Any]:
    """Returns the machine and the versions."""
    return {
        "machine": f"{processor()}, {len(os.sched_getaffinity(0))} processors",
        "python": platform.python_version(),
        "versions": {name: version(name) for name in PACKAGES},
        "workers": WORKERS,
        "month": time.strftime("%B %Y"),
    }


def more(found: dict[str, Any]) -> None:
    """Adds a round on the same machine to the results, or finishes an incomplete round; each run is saved immediately."""
    now = about()
    if wrong := [key for key in now if found[key] != now[key]]:
        raise SystemExit(f"what was measured has other {', '.join(wrong)}: measure all of it anew")
    if not found["rounds"] or len(found["rounds"][-1]) == len(NAMES):
        found["rounds"].append({})
    for _ in runs(found["members"], NAMES, found["rounds"], SEED + len(found["rounds"])):
        MEASURED.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")


def runs(members: int, names: tuple[str, ...], rounds: list[dict[str, Any]], seed: int) -> Iterator[None]:
    """Makes the missing runs of the last round, one by one; all folders must have the same bytes."""
    last = rounds[-1]
    for name in names:
        if name in last:
            continue
        engine, is_killed = name.removesuffix(KILLED), name.endswith(KILLED)
        # The number of kills is then nearly independent of the load of the machine.
        mean = last[ALONE]["time"] / KILLS if is_killed else None
        last[name] = run(engine, members, mean, random.Random(f"{seed} {engine}"))
        if differing := {name: one["folder"] for of in rounds for name, one in of.items() if one["folder"] != last[name]["folder"]}:
            raise SystemExit(f"{name} has another folder than {', '.join(differing)}")
        yield


def run(engine: str, members: int, mean: float | None, drawn: random.Random) -> dict[str, Any]:
    """Makes a run in a separate process. Workers are killed at exponentially distributed intervals with this mean, s; without a mean none is killed."""
    from processes import Processes, busy

    folder = Path(tempfile.mkdtemp(prefix="polhode-"))
    processes, busy_before, own_before = Processes(), busy(), time.process_time()
    killed: list[float] = []
    try:
        command = [sys.executable, __file__, "--one", engine, str(members), str(folder / "out")]
        begun = time.monotonic()
        child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=os.environ | BOUNDED)
        assert child.stdout
        until = None
        while child.poll() is None:
            time.sleep(LOOK)
            if mean is None:
                processes.look()
                continue
            # The time is counted from the first worker.
            workers, now = processes.workers(engine), time.monotonic()
            if workers and until is None:
                until = now + drawn.expovariate(1.0 / mean)
            elif workers and until is not None and now >= until:
                os.kill(drawn.choice(workers), signal.SIGKILL)
                killed.append(round(now - begun, 2))
                until = now + drawn.expovariate(1.0 / mean)
        lasted = time.monotonic() - begun
        if child.returncode:
            raise SystemExit(f"the sweep on {engine} ended with {child.returncode}; workers were killed after {killed} s")
        if mean is not None and len(killed) < KILLS_AT_LEAST:
            raise SystemExit(f"only {len(killed)} workers were killed: too few members")
        others = busy() - busy_before - processes.taken - (time.process_time() - own_before)
        found: dict[str, Any] = json.loads(child.stdout.read().splitlines()[-1])
        found |= {"processors": processes.taken, "others": max(0.0, others / lasted), "folder": digest(folder / "out"), "kills": killed}
        print(engine, {key: value if isinstance(value, (str, list)) else round(value, 2) for key, value in found.items()}, file=sys.stderr, flush=True)
        return found
    finally:
        processes.end()
        shutil.rmtree(folder)


def one(on: str, members: int, folder: Path) -> None:
    """Runs the sweep and prints the measurements. Times from the call: first finished part, last finished part, and end."""
    from polhode import batch, sweep

    at: list[float] = []

    def progress(done: int, of: int) -> None:
        at.append(time.perf_counter() - begun)

    text, changed = re.subn(r"(?m)^members = \d+$", f"members = {members}", PLAN.read_text())
    assert changed == 1
    plan = batch.Plan(text)
    begun = time.perf_counter()
    if on == ALONE:
        sweep.run(plan, folder, threads=WORKERS, progress=progress)
    else:
        sweep.run(plan, folder, on=f"{on}://local", workers=WORKERS, progress=progress)
    print(json.dumps({"time": time.perf_counter() - begun, "first": at[0], "last": at[-1]}))


def digest(folder: Path) -> str:
    """Returns a hash of the names and contents of all files except the lock."""
    whole = hashlib.sha256()
    for path in sorted(path for path in folder.rglob("*") if path.is_file() and path.name != "sweep.lock"):
        whole.update(f"{path.relative_to(folder)}\0{path.stat().st_size}\0".encode())
        whole.update(path.read_bytes())
    return whole.hexdigest()


if __name__ == "__main__":
    sys.exit(main())
