"""What a cluster may do wrong while a sweep waits for it, in words."""

from __future__ import annotations

import time
from typing import Callable, Iterator, TypeVar

from ._error import PolhodeError, warn

#: Seconds between two looks at a cluster from which nothing comes.
LOOK = 2.0

#: Seconds between two warnings that there is still no worker.
REMIND = 60.0

#: Workers that may be lost with the same part before that is given up: it may be the part that ends them, by the memory that it takes.
LOST_WORKERS = 16

Part = TypeVar("Part")


class Watch:
    """Counts a cluster's workers while nothing comes from it: says that there are none, and gives up after ``timeout`` seconds of that."""

    def __init__(self, on: str, timeout: float | None, workers: Callable[[], int]) -> None:
        self.on = on
        self._timeout = timeout
        self._workers = workers
        self._looked = float("-inf")
        self._alone: float | None = None
        self._said = float("-inf")

    def look(self) -> None:
        """To be called as often as may be while one waits."""
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
                f"{self.on} has had no worker for {waited:.0f} s; what is done is kept: start workers, and go on with resume"
            )
        if now - self._said >= REMIND:
            self._said = now
            until = "for as long as it takes" if self._timeout is None else f"for {self._timeout:.0f} s at most"
            since = f", for {waited:.0f} s by now" if waited >= LOOK else ""
            warn(f"{self.on} has no worker{since}: waiting for one {until}")


def lost(on: str, why: str) -> ConnectionError:
    """The cluster is gone."""
    return ConnectionError(f"{on} was lost on the way: {why}; what is done is kept: go on with resume")


def in_words(on: str, parts: Iterator[Part]) -> Iterator[Part]:
    """The parts; what an engine raises in its own words becomes an error of ours."""
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
                "what is done is kept; every worker needs polhode in the same version, and memory for a part",
            ) from error
        yield part
