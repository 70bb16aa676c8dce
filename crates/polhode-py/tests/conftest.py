"""What the tests share: a generic body, and where the project's example files are."""

from __future__ import annotations

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
