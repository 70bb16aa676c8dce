"""What a body is made of."""

from __future__ import annotations

from typing import TypedDict

from . import _arrays


class Given(TypedDict):
    """What Rust asks for."""

    density: float | None
    mass: float | None
    material: str | None
    area_density: float | None
    line_density: float | None


def given(
    *,
    density: float | None = None,
    mass: float | None = None,
    material: str | None = None,
    area_density: float | None = None,
    line_density: float | None = None,
) -> Given:
    """The arguments, checked to be positive numbers and text."""

    def checked(name: str, value: float | None) -> float | None:
        return None if value is None else _arrays.positive(name, value)

    return {
        "density": checked("density", density),
        "mass": checked("mass", mass),
        "material": None if material is None else _arrays.text("material", material),
        "area_density": checked("area_density", area_density),
        "line_density": checked("line_density", line_density),
    }
