"""Rows piece by piece, on several threads, with a look for Ctrl-C between pieces."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from concurrent.futures import FIRST_EXCEPTION, Future, ThreadPoolExecutor, wait
from typing import TypeVar

#: Rows that are computed without a look for Ctrl-C, at most, and for how long that may be, s of the processor, where a row does not take longer: by
#: the clock, pieces would shrink to single rows on a busy machine, and rows side by side take less.
PIECE = 256
LOOK = 0.1

Of = TypeVar("Of")


class _Rows:
    """Rows that are not computed yet; threads take pieces of them."""

    def __init__(self, count: int) -> None:
        self._count = count
        self._next = 0
        self._lock = threading.Lock()
        self.ends = False

    def take(self, size: int) -> tuple[int, int] | None:
        """The next piece; ``None`` if there is no more to do."""
        with self._lock:
            # Of no rows there is one piece, which has the columns.
            if self.ends or self._next >= max(self._count, 1):
                return None
            start, self._next = self._next, max(min(self._next + size, self._count), 1)
            return start, min(start + size, self._count)


def of(function: Callable[[int, int], Of], count: int, threads: int) -> list[Of]:
    """A function of the rows from one up to another, of pieces of ``count`` rows, in their order. Where these are cut is a matter of time, and nobody's result."""
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
                # The thread that hears of Ctrl-C waits, and is woken by it.
                while wait(working, LOOK, FIRST_EXCEPTION).not_done and not any(one.done() and one.exception() for one in working):
                    pass
            finally:
                rows.ends = True
        for one in working:
            one.result()
    return [done[start] for start in sorted(done)]
