#!/usr/bin/env python3
"""Measures the time of calls of the Python package and of the same calls in Rust, in one run, and prints both with their required limits.

    pip install numpy ./crates/polhode-py
    python3 benches/python/calls.py              # builds crates/polhode/benches/calls.rs
    python3 benches/python/calls.py PROGRAM      # takes it as it was built

The package has to be a release build. Times are the least of many runs, of both in turn. Two threads are started once and wait for each other before
every run; they are as fast as two if each does in the time of one what one does alone.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Callable

import numpy as np
import polhode

ROOT = Path(__file__).resolve().parents[2]
ROUNDS = 3
COUNTS = (1_000, 10_000, 100_000, 1_000_000)
SECONDS = 0.3


def least(call: Callable[[], object], repeated: int = 1) -> float:
    """Returns the minimum time of a call, s; calls too short for the clock are repeated."""
    found, begun = float("inf"), time.perf_counter()
    while time.perf_counter() - begun < SECONDS:
        once = time.perf_counter()
        for _ in range(repeated):
            call()
        found = min(found, (time.perf_counter() - once) / repeated)
    return found


def together(calls: list[Callable[[], object]]) -> float:
    """Returns the minimum time from the start until the last call has ended, with one thread per call, s."""
    begin, end = threading.Barrier(len(calls) + 1), threading.Barrier(len(calls) + 1)
    times: list[tuple[float, float]] = [(0.0, 0.0)] * len(calls)
    goes_on = True

    def work(k: int) -> None:
        while True:
            begin.wait()
            if not goes_on:
                return
            once = time.perf_counter()
            calls[k]()
            times[k] = once, time.perf_counter()
            end.wait()

    threads = [threading.Thread(target=work, args=(k,)) for k in range(len(calls))]
    for thread in threads:
        thread.start()
    found, begun = float("inf"), time.perf_counter()
    while time.perf_counter() - begun < 2 * SECONDS:
        begin.wait()
        end.wait()
        found = min(found, max(stop for _, stop in times) - min(start for start, _ in times))
    goes_on = False
    begin.wait()
    for thread in threads:
        thread.join()
    return found


def python() -> dict[str, float]:
    """Returns times by the names in `calls.rs`, ns; per state for calls with many states."""
    given = {"moments": [1.0, 2.0, 3.0], "omega": [0.3, 0.5, 0.9]}
    motion = polhode.FreeMotion(**given)
    found = {"construction": least(lambda: polhode.FreeMotion(**given), 100), "one state": least(lambda: motion.at(3.7), 1000)}
    single = np.array([3.7])
    found["one state, in an array"] = least(lambda: motion.at(single), 1000)
    for count in COUNTS:
        times = np.linspace(0.0, 1e3, count)
        one, two = [(np.empty((count, 3)), np.empty((count, 4))) for _ in range(2)]
        found[f"{count} states, filled"] = least(lambda: motion.at(times, out=one)) / count
        found[f"{count} states, fresh"] = least(lambda: motion.at(times)) / count
        both: list[Callable[[], object]] = [lambda: motion.at(times, out=one), lambda: motion.at(times, out=two)]
        found[f"{count} states, filled by each of two threads"] = together(both) / count
    return {name: seconds * 1e9 for name, seconds in found.items()}


def rust(command: list[str]) -> dict[str, float]:
    printed = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return {name: float(value) for name, value, _ in (line.split("\t") for line in printed.splitlines())}


def main() -> None:
    command = sys.argv[1:] or ["cargo", "bench", "-q", "-p", "polhode", "--bench", "calls"]
    ours: dict[str, float] = {}
    theirs: dict[str, float] = {}
    for _ in range(ROUNDS):
        for all_rounds, once in ((theirs, rust(command)), (ours, python())):
            for name, value in once.items():
                all_rounds[name] = min(value, all_rounds.get(name, value))
    theirs["one state, in an array"] = theirs["one state"]
    print(f"{'ns':48}{'Python':>10}{'Rust':>10}{'ratio':>8}  asked")
    for name, value in ours.items():
        other = theirs[name]
        if name == "construction":
            asked = f"<= 8000 ns: {value <= 8000}"
        elif name.startswith("one"):
            asked = f"<= 2000 ns above Rust: {value - other <= 2000}"
        elif name.endswith("threads"):
            alone = name.partition(" by each")[0]
            gain = 2 * ours[alone] / value
            asked = f"two threads {gain:.2f} times as fast as one (Rust {2 * theirs[alone] / other:.2f}); >= 1.8: {gain >= 1.8}"
        else:
            # 2000 ns per call are allowed, spread over its states.
            call = 2000 / int(name.split()[0])
            asked = f"<= 1.3 times Rust and 2000 ns a call: {value <= 1.3 * other + call}"
        print(f"{name:48}{value:10.1f}{other:10.1f}{value / other:8.2f}  {asked}")
    print(f"{len(os.sched_getaffinity(0))} processors, load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
