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

    if not (material is None or isinstance(material, str)):
        raise TypeError(f"material must be a name, not {type(material).__name__}")
    return {
        "density": checked("density", density),
        "mass": checked("mass", mass),
        "material": material,
        "area_density": checked("area_density", area_density),
        "line_density": checked("line_density", line_density),
    }
