"""Errors of clusters during a sweep, reported in plain words."""

from __future__ import annotations

import time
from typing import Callable, Iterator, TypeVar

from ._error import PolhodeError, warn

#: Seconds between two checks of a cluster that returns nothing.
LOOK = 2.0

#: Seconds between two warnings that there is still no worker.
REMIND = 60.0

#: Number of workers that may be lost with the same part before the sweep gives up. The part itself
#: may end them, for example by the memory that it needs.
LOST_WORKERS = 16

Part = TypeVar("Part")


class Watch:
    """Counts a cluster's workers while no results arrive.

    Warns if there are none, and gives up after ``timeout`` seconds without any.
    """

    def __init__(self, on: str, timeout: float | None, workers: Callable[[], int]) -> None:
        self.on = on
        self._timeout = timeout
        self._workers = workers
        self._looked = float("-inf")
        self._alone: float | None = None
        self._said = float("-inf")

    def look(self) -> None:
        """Checks the workers. Call it often during a wait: it limits its own rate."""
        now = time.monotonic()
        if now - self._looked < LOOK:
            return
        self._looked = now
        if self._workers() > 0:
            self._alone, self._said = None, float("-inf")
            return
        self._alone = now if self._alone is None else self._alone
        waited = now - self._alone
        if self._timeout is not None and waited >= self._timeout:
            raise TimeoutError(
                f"{self.on} has had no worker for {waited:.0f} s; finished parts are saved: start workers, and continue with resume=True"
            )
        if now - self._said >= REMIND:
            self._said = now
            until = "without a time limit" if self._timeout is None else f"at most {self._timeout:.0f} s"
            since = f" (for {waited:.0f} s so far)" if waited >= LOOK else ""
            warn(f"{self.on} has no worker{since}: waiting for one {until}")


def lost(on: str, why: str) -> ConnectionError:
    """Returns the error for a cluster whose connection is lost."""
    return ConnectionError(f"the connection to {on} was lost: {why}; finished parts are saved: continue with resume=True")


def in_words(on: str, parts: Iterator[Part]) -> Iterator[Part]:
    """Yields the parts. Exceptions of the cluster's engine are raised as :class:`PolhodeError`."""
    while True:
        try:
            part = next(parts)
        except StopIteration:
            return
        except (PolhodeError, OSError, ImportError):
            raise
        except Exception as error:
            raise PolhodeError(
                f"{on} cannot compute the plan: {type(error).__name__}: {error}",
                "finished parts are saved; every worker needs the same version of polhode, and memory for one part",
            ) from error
        yield part
