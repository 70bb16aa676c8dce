#!/usr/bin/env python3
"""Solves the same problems by polhode and by its peers, each in a process of its own, and writes book/peers.md.

    pip install heyoka scipy mujoco trimesh numpy ./crates/polhode-py
    python3 benches/python/measure.py           # measures, and writes measured.json and the page
    python3 benches/python/measure.py --small   # measures only the small meshes; manifold3d too, if it is installed
    python3 benches/python/measure.py --page    # writes the page of what was measured
    python3 benches/python/measure.py --check   # fails unless the page is that

A program is a file `PROBLEM/with_PEER.py` with `prepare`, which is set-up, and `solve`, whose time counts. Set-up is the first call of
`prepare` that imports nothing; time the least of repeated calls of `solve` after one that is not counted, or that one where it takes long; both are of
the processors, all together, which other programs on the machine disturb least. Memory is the most that the process has had when
it has solved the problem once. All are the least of several processes, the programs in turn. The median and the spread are those of the process
with the least median. Errors are against `reference.py`.
"""

from __future__ import annotations

import importlib.util
import json
import os
import pickle
import platform
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

from machine import processor, version  # noqa: E402

ROUNDS = 2
#: Duration of the repetitions of a problem, s, and their maximum number.
ENOUGH, OFTEN = 1.0, 2000
#: A solution that takes longer than this, s, is not repeated.
LONG = 5.0
MEASURED = HERE / "measured.json"
PACKAGES = ("polhode", "heyoka", "mujoco", "trimesh", "scipy", "numpy")


def main() -> int:
    import page

    match sys.argv[1:]:
        case ["--one", name, peer, place]:
            one(name, peer, Path(place))
        case ["--small"]:
            measured = json.loads(MEASURED.read_text()) | {"small_meshes": measure_small_meshes()}
            MEASURED.write_text(json.dumps(measured, indent=1, sort_keys=True) + "\n")
            page.write(measured)
        case ["--idle"]:
            idle()
        case ["--check"]:
            return page.check(json.loads(MEASURED.read_text()))
        case ["--page"]:
            page.write(json.loads(MEASURED.read_text()))
        case []:
            MEASURED.write_text(json.dumps(measure(), indent=1, sort_keys=True) + "\n")
            page.write(json.loads(MEASURED.read_text()))
        case _:
            print(__doc__, file=sys.stderr)
            return 2
    return 0


def measure() -> dict[str, Any]:
    """Returns the measurements of each problem's programs, the machine, and the versions."""
    import page
    import problem

    found: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as folder:
        for of in problem.PROBLEMS:
            rows: dict[str, list[dict[str, float]]] = {peer: [] for peer in page.peers(of.folder)}
            place = Path(folder) / "answer"
            for round in range(ROUNDS):
                for peer, runs in rows.items():
                    runs.append(json.loads(child("--one", of.folder, peer, str(place))))
                    if not round:
                        runs[0]["error"] = of.error(pickle.loads(place.read_bytes()))
                    print(of.folder, peer, runs[-1], file=sys.stderr)
            found[of.folder] = {peer: {"error": runs[0].pop("error")} | {key: min(run[key] for run in runs) for key in runs[0]} for peer, runs in rows.items()}
    return {
        "problems": found,
        "small_meshes": measure_small_meshes(),
        "idle": json.loads(child("--idle"))["memory"],
        "load": os.getloadavg()[0],
        "machine": f"{processor()}, {len(os.sched_getaffinity(0))} processors",
        "python": platform.python_version(),
        "versions": {name: version(name) for name in PACKAGES},
        "month": time.strftime("%B %Y"),
    }


def measure_small_meshes() -> dict[str, Any]:
    """Returns time and error of small meshes, by program and number of triangles, and the versions of packages that only they need."""
    import page
    import problem

    rows: dict[str, dict[str, dict[str, float]]] = {peer: {} for peer in page.SMALL if importlib.util.find_spec(page.SMALL[peer].package)}
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "answer"
        for of in problem.SMALL_MESHES:
            for _ in range(ROUNDS):
                for peer, row in rows.items():
                    run = json.loads(child("--one", of.name, peer, str(place)))
                    least = min(run["time"], row.get(of.title, run)["time"])
                    row[of.title] = {"time": least, "error": of.error(pickle.loads(place.read_bytes()))}
                    print(of.name, peer, run, file=sys.stderr)
    return {"rows": rows, "versions": {peer: version(peer) for peer in rows if peer in page.SMALL_ONLY}}


def child(*arguments: str) -> str:
    done = subprocess.run([sys.executable, __file__, *arguments], check=True, stdout=subprocess.PIPE, text=True)
    return done.stdout.splitlines()[-1]


def one(name: str, peer: str, place: Path) -> None:
    """Solves a problem by a program; writes the answer to a file and the measurements to standard output."""
    import problem

    of = problem.named(name)
    given = of.given()
    spec = importlib.util.spec_from_file_location("program", HERE / of.folder / f"with_{peer}.py")
    assert spec and spec.loader
    program = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(program)
    known = 0
    while known < len(sys.modules):
        known, begun = len(sys.modules), time.process_time()
        prepared = program.prepare(**given)
        set_up = time.process_time() - begun
    begun = time.process_time()
    answer = program.solve(prepared)
    times = [time.process_time() - begun]
    memory = peak()
    place.write_bytes(pickle.dumps(list(answer) if isinstance(answer, tuple) or hasattr(answer, "omega") else answer))
    if times[0] < LONG:
        times = []
        begun = time.perf_counter()
        while len(times) < 2 or len(times) < OFTEN and time.perf_counter() - begun < ENOUGH:
            once = time.process_time()
            program.solve(prepared)
            times.append(time.process_time() - once)
    times.sort()
    # The median, and the times that a tenth of the solutions is below and above.
    spread = [times[round(share * (len(times) - 1))] for share in (0.5, 0.1, 0.9)]
    print(json.dumps({"set_up": set_up, "time": times[0], "spread": spread, "memory": memory}))


def idle() -> None:
    """Returns the memory of a process that has loaded only NumPy, bytes."""
    import numpy  # noqa: F401

    print(json.dumps({"memory": peak()}))


def peak() -> int:
    """Returns the peak memory of this process, bytes."""
    status = Path("/proc/self/status")
    if status.exists():
        # `ru_maxrss` starts at the value of the parent process, so VmHWM is read instead.
        return 1024 * next(int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmHWM:"))
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


if __name__ == "__main__":
    sys.exit(main())
