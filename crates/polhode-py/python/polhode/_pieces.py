"""Computation of rows in pieces, on several threads, with a check for Ctrl-C between pieces."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from concurrent.futures import FIRST_EXCEPTION, Future, ThreadPoolExecutor, wait
from typing import TypeVar

#: Maximum number of rows between two checks for Ctrl-C, and maximum processor time between them, s,
#: unless a single row takes longer. Processor time is used because with wall-clock time the pieces
#: would shrink to single rows on a busy machine, which is less efficient.
PIECE = 256
LOOK = 0.1

Of = TypeVar("Of")


class _Rows:
    """Rows that are not computed yet. Threads take pieces of them."""

    def __init__(self, count: int) -> None:
        self._count = count
        self._next = 0
        self._lock = threading.Lock()
        self.ends = False

    def take(self, size: int) -> tuple[int, int] | None:
        """Returns the next piece; ``None`` if nothing remains."""
        with self._lock:
            # Zero rows are one empty piece, which has the columns.
            if self.ends or self._next >= max(self._count, 1):
                return None
            start, self._next = self._next, max(min(self._next + size, self._count), 1)
            return start, min(start + size, self._count)


def of(function: Callable[[int, int], Of], count: int, threads: int) -> list[Of]:
    """Applies a function to ``count`` rows, in pieces, and returns the results in order.

    The function takes the first row and the one after the last. The sizes of the pieces depend on
    timing, but the combined result does not.
    """
    rows = _Rows(count)
    done: dict[int, Of] = {}

    def work() -> None:
        size = 1
        while (piece := rows.take(size)) is not None:
            began = time.thread_time()
            done[piece[0]] = function(*piece)
            size = min(2 * size, PIECE) if time.thread_time() - began < 0.5 * LOOK else max(size // 2, 1)

    if min(threads, count) <= 1:
        work()
    else:
        with ThreadPoolExecutor(min(threads, count)) as pool:
            working: list[Future[None]] = []
            try:
                working += [pool.submit(work) for _ in range(min(threads, count))]
                # The main thread receives Ctrl-C: it waits with a timeout, so that Ctrl-C can
                # interrupt it.
                while wait(working, LOOK, FIRST_EXCEPTION).not_done and not any(one.done() and one.exception() for one in working):
                    pass
            finally:
                rows.ends = True
        for one in working:
            one.result()
    return [done[start] for start in sorted(done)]
