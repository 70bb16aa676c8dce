"""What the tests share: a generic body, and where the project's example files are."""

from __future__ import annotations

import hashlib
import re
import signal
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import polhode
import pytest

#: The root of the checkout: the tests read its examples and fixtures, the package under test is the installed one.
ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def examples() -> Path:
    return ROOT / "examples"


@pytest.fixture
def fixtures() -> Path:
    return ROOT / "fixtures"


@pytest.fixture
def generic() -> polhode.MassProperties:
    """Distinct moments, all products non-zero, mass not 1, centre of mass off the origin, mixed signs."""
    return polhode.MassProperties(
        mass=2.3, center_of_mass=[0.11, -0.07, 0.23], inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]
    )


@pytest.fixture
def ctrl_c() -> Iterator[None]:
    """Ctrl-C interrupts: what a shell starts in the background ignores it, and a computation that waits for it would not end."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def matrix(wxyz: np.ndarray) -> np.ndarray:
    """R with v_A = R v_B of a unit quaternion, written out here once more."""
    w, x, y, z = np.asarray(wxyz) / np.linalg.norm(wxyz)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def steiner(mass: float, a: np.ndarray) -> np.ndarray:
    """m (a² 1 − a aᵀ)"""
    return mass * (a @ a * np.eye(3) - np.outer(a, a))


def digest(folder: Path) -> str:
    """One hash of all files of a sweep, names and contents; the lock is nobody's result."""
    whole = hashlib.sha256()
    for path in sorted(path for path in folder.rglob("*") if path.is_file() and path.name != "sweep.lock"):
        whole.update(f"{path.relative_to(folder)}\0{path.stat().st_size}\0".encode())
        whole.update(path.read_bytes())
    return whole.hexdigest()


#: A plan of free motions, of generic bodies and starts; members and what is kept are filled in.
PLAN = """
title = "Debris that tumbles"

[[body.part]]
shape = "tensor"
mass = "3 kg"
moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]

[start]
attitude = {{ axis = [2, -1, 1.5], angle = "150 deg" }}
spin = {{ body = [0.1, 2, -0.3] }}

[run]
duration = "60 s"
samples = 3

[sweep]
members = {members}
sampling = "monte carlo"
seed = 7

[[sweep.vary]]
key = "start.spin.body[0]"
uniform = {{ from = "-0.2 rad/s", to = "0.2 rad/s" }}

[[sweep.vary]]
key = "start.spin.body[1]"
normal = {{ mean = "2 rad/s", sd = "10 deg/s" }}

[[sweep.vary]]
key = "body.part[0].mass"
normal = {{ mean = "3 kg", sd = "0.8 kg" }}
"""


def satellite(members: int) -> str:
    """A plan of motions in steps, a third of a millisecond each: the example of a satellite, with so many members."""
    text = (ROOT / "examples" / "sweeps" / "uncertain-satellite.toml").read_text()
    changed, times = re.subn(r"(?m)^members = \d+$", f"members = {members}", text)
    assert times == 1
    return changed


def engines_for_tables() -> list[str]:
    """The lines of `book/clusters.md` that hand tables to Ray and to Dask."""
    page = (ROOT / "book" / "clusters.md").read_text()
    (block,) = (block for block in page.split("```") if block.startswith("python\nsimulated"))
    return block.splitlines()[1:]
