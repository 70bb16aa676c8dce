"""The processes below this one: what they have taken of the processors, and which of them a sweep's workers are. Linux alone."""

from __future__ import annotations

import ctypes
import os
import signal
import time
from pathlib import Path

#: Ticks of the system's clock in a second.
TICKS = os.sysconf("SC_CLK_TCK")

#: PR_SET_CHILD_SUBREAPER of prctl(2).
CHILD_SUBREAPER = 36

#: What the command lines of workers begin with or have in them: Dask's are of Python's multiprocessing, Ray's are called by what they do.
WORKERS = {"dask": b"spawn_main", "ray": b"ray::compute"}

#: What a process has loaded that has been given a part.
LOADED = "polhode/_native"


class Processes:
    """All processes below this one, also those whose parents have ended.

    Their processors' time is added up from looks: what a process takes between the last look and its end is not counted, which is less than
    the time between two looks.
    """

    def __init__(self) -> None:
        # Orphans become children of this process, and remain below it.
        if ctypes.CDLL(None, use_errno=True).prctl(CHILD_SUBREAPER, 1, 0, 0, 0):
            raise OSError(ctypes.get_errno(), "prctl")
        self._taken: dict[tuple[int, str], float] = {}

    def look(self) -> list[int]:
        """The processes that there are."""
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
        """Those that compute parts, of an engine: not those that are about to start, of which Dask's nannies may lose count."""
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
        """Seconds of the processors, of all processes that were ever seen."""
        return sum(self._taken.values())

    def end(self) -> None:
        """Kills what is left, and waits for it."""
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
    """Seconds that the processors of this machine have not been idle, all together, since it started."""
    fields = [int(field) for field in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:]]
    idle, waiting = fields[3:5]
    # Guests are counted under users too.
    return (sum(fields[:8]) - idle - waiting) / TICKS
