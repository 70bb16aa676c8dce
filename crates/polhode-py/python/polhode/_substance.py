"""Material, density or mass of bodies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypedDict

from . import _arrays, _native
from ._error import PolhodeError
from ._units import Quantity


class Given(TypedDict):
    """Density, mass or material as Rust takes it."""

    density: float | None
    mass: float | None
    material: str | None
    area_density: float | None
    line_density: float | None


def materials() -> dict[str, float]:
    """Returns the materials that ``material=`` accepts, with their densities, kg/m³.

    The densities are rounded values in common use.

    Returns
    -------
    dict
        Densities by name, kg/m³.

    Examples
    --------
    >>> import polhode
    >>> polhode.materials()["steel"]
    7850.0
    """
    return dict(_native.materials())


def of_parts(parts: object) -> list[tuple[str, Given]]:
    """Checks the substances of parts of a mesh by name: a material, or a dictionary with a density,
    a mass or a material."""
    if not isinstance(parts, (Mapping, type(None))):
        raise TypeError(f"parts must be a dict from part names to materials, not {type(parts).__name__}")
    made: list[tuple[str, Given]] = []
    for name, what in (parts or {}).items():
        place = f"parts[{_arrays.text('the name of a part', name)!r}]"
        if isinstance(what, str):
            what = {"material": what}
        if not isinstance(what, Mapping):
            raise TypeError(f"{place} must be a material or a dict, not {type(what).__name__}")
        if len(what) != 1 or not set(what) <= {"density", "mass", "material"}:
            raise PolhodeError(f"{place} must have one of density, mass and material")
        ((key, value),) = what.items()
        named = f"{place}[{key!r}]"
        if key == "material":
            made.append((name, given(material=_arrays.text(named, value))))
        elif key == "mass":
            made.append((name, given(mass=_arrays.positive(named, value))))
        else:
            made.append((name, given(density=_arrays.positive(named, value))))
    return made


def given(
    *,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
    area_density: Quantity | None = None,
    line_density: Quantity | None = None,
) -> Given:
    """Checks that the arguments are positive numbers and text."""

    def checked(name: str, value: Quantity | None) -> float | None:
        return None if value is None else _arrays.positive(name, value)

    return {
        "density": checked("density", density),
        "mass": checked("mass", mass),
        "material": None if material is None else _arrays.text("material", material),
        "area_density": checked("area_density", area_density),
        "line_density": checked("line_density", line_density),
    }
