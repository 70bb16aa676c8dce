"""How many threads there are to use."""

from __future__ import annotations

import os


def available() -> int:
    """The processors that this process may run on: fewer than the machine's under ``taskset``, and of a job in a batch system."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
