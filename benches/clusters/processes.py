"""Descendant processes of this one: their CPU time, and which of them are workers of a sweep. Linux only."""

from __future__ import annotations

import ctypes
import os
import signal
import time
from pathlib import Path

#: Clock ticks per second.
TICKS = os.sysconf("SC_CLK_TCK")

#: PR_SET_CHILD_SUBREAPER of prctl(2).
CHILD_SUBREAPER = 36

#: Texts in the command lines of workers. Dask's workers are processes of Python's multiprocessing; Ray's are named after their task.
WORKERS = {"dask": b"spawn_main", "ray": b"ray::compute"}

#: Library loaded by a process that has received a part.
LOADED = "polhode/_native"


class Processes:
    """All descendants of this process, including those whose parents have ended.

    Their processors' time is added up from looks: what a process takes between the last look and its end is not counted, which is less than
    the time between two looks.
    """

    def __init__(self) -> None:
        # Orphans become children of this process, and remain its descendants.
        if ctypes.CDLL(None, use_errno=True).prctl(CHILD_SUBREAPER, 1, 0, 0, 0):
            raise OSError(ctypes.get_errno(), "prctl")
        self._taken: dict[tuple[int, str], float] = {}

    def look(self) -> list[int]:
        """Returns the existing processes."""
        stat = {}
        for entry in os.listdir("/proc"):
            if entry.isdigit():
                try:
                    stat[int(entry)] = Path("/proc", entry, "stat").read_text().rsplit(")", 1)[1].split()
                except (FileNotFoundError, ProcessLookupError):
                    continue
        below = {os.getpid()}
        grown = True
        while grown:
            more = {pid for pid, fields in stat.items() if int(fields[1]) in below} - below
            below |= more
            grown = bool(more)
        below.discard(os.getpid())
        for pid in below:
            self._taken[pid, stat[pid][19]] = (int(stat[pid][11]) + int(stat[pid][12])) / TICKS
        return sorted(below)

    def workers(self, of: str) -> list[int]:
        """Returns the processes of an engine that compute parts. Starting processes are excluded, because Dask's nannies may lose track of them."""
        found = []
        for pid in self.look():
            try:
                if WORKERS[of] in Path(f"/proc/{pid}/cmdline").read_bytes() and LOADED in Path(f"/proc/{pid}/maps").read_text():
                    found.append(pid)
            except (FileNotFoundError, ProcessLookupError):
                continue
        return found

    @property
    def taken(self) -> float:
        """Returns the CPU time of all processes seen so far, s."""
        return sum(self._taken.values())

    def end(self) -> None:
        """Kills the remaining processes, and waits until they have ended."""
        for _ in range(100):
            left = self.look()
            for pid in left:
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    continue
            try:
                while os.waitpid(-1, os.WNOHANG)[0]:
                    pass
            except ChildProcessError:
                return
            time.sleep(0.05)
        raise RuntimeError(f"processes {left} cannot be ended")


def busy() -> float:
    """Returns the total busy time of all processors since the start of the machine, s."""
    fields = [int(field) for field in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:]]
    idle, waiting = fields[3:5]
    # Guest time is already included in user time.
    return (sum(fields[:8]) - idle - waiting) / TICKS
