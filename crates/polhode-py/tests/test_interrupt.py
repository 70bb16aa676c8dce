"""Ctrl-C while a body is read or measured: it is heard at once, whatever the piece of work."""

from __future__ import annotations

import io
import os
import signal
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest

pytestmark = pytest.mark.usefixtures("ctrl_c")


def torus(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Of 2 n² triangles."""
    u, v = np.meshgrid(*[np.linspace(0.0, 2.0 * np.pi, n, endpoint=False)] * 2, indexing="ij")
    r = 1.0 + 0.3 * np.cos(v)
    vertices = np.stack([r * np.cos(u) + 0.1, r * np.sin(u) - 0.2, 0.3 * np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a, b, c, d = (p % n * n + q % n for p, q in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
    return vertices, np.concatenate([np.stack(three, axis=-1).reshape(-1, 3) for three in ((a, b, c), (a, c, d))])


def heard(call: Callable[[], Any], after: float) -> float:
    """How long after the signal the call ends, s."""
    sent = [0.0]

    def send() -> None:
        time.sleep(after)
        sent[0] = time.perf_counter()
        os.kill(os.getpid(), signal.SIGINT)

    sender = threading.Thread(target=send)
    sender.start()
    with pytest.raises(KeyboardInterrupt):
        call()
    ended = time.perf_counter()
    sender.join()
    return ended - sent[0]


def timed(call: Callable[[], Any]) -> float:
    """How long the call takes, s."""
    begun = time.perf_counter()
    call()
    return time.perf_counter() - begun


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no os.mkfifo, which makes the file that the test waits for")
@pytest.mark.parametrize("name", ["body.stl", "points.csv", "molecule.xyz", "scenario.toml"])
def test_a_file_that_does_not_come(name: str, tmp_path: Path) -> None:
    """Nothing is asked while the system waits for the file."""
    path = tmp_path / name
    os.mkfifo(path)
    assert heard(lambda: polhode.inertia(path), 0.1) < 1.0
    # What has read it is let go.
    os.close(os.open(path, os.O_WRONLY))


def test_a_mesh_that_takes_long() -> None:
    vertices, triangles = torus(400)
    corners = vertices[triangles]
    for call in (
        lambda: polhode.inertia((vertices, triangles), mass=1.0, unit="m"),
        lambda: polhode.inertia(corners, mass=1.0, unit="m"),
        lambda: polhode.mesh_derivatives((vertices, triangles), density=1.0),
    ):
        # The least of a few: the machine may have other things to do, and a first call imports modules.
        takes = min(timed(call) for _ in range(3))
        assert min(heard(call, 0.2 * takes) for _ in range(3)) < max(0.3 * takes, 0.1)


def test_an_open_file_is_read_piece_by_piece() -> None:
    class Endless(io.RawIOBase):
        name = "body.stl"

        def read(self, size: int = -1) -> bytes:
            assert 0 < size <= 1 << 24
            time.sleep(0.01)
            return b"\0"

    assert heard(lambda: polhode.inertia(Endless()), 0.1) < 1.0


def test_corners_are_a_mesh() -> None:
    vertices, triangles = torus(12)
    one, other = polhode.inertia((vertices, triangles), density=2.0, unit="m"), polhode.inertia(vertices[triangles], density=2.0, unit="m")
    assert np.allclose(one.inertia, other.inertia, rtol=1e-13, atol=1e-15) and one.to_dict()["source"]["vertices"] == other.to_dict()["source"]["vertices"] == 144
