"""Mass properties of shapes with closed-form integrals, in their own axes.

Each function takes exactly one of ``density`` (kg/m³), ``mass`` (kg) and ``material`` (a name, such
as ``"steel"``). Thin shapes take ``mass``, ``area_density`` (kg/m²) or ``line_density`` (kg/m).
Lengths are in m, or text with a unit, such as ``"2 cm"``. ``placed`` moves a shape, and ``+`` joins
shapes.

>>> from polhode import shapes
>>> shapes.sphere(radius="2 cm", mass=0.5).inertia[0, 0].round(9)
np.float64(8e-05)
"""

from __future__ import annotations

from typing import Sequence

import numpy.typing as npt

from . import _arrays, _native
from ._mass_properties import MassProperties
from ._substance import Given, given
from ._units import Quantity


def _shape(kind: str, lengths: Sequence[float], substance: Given, *, ends: bool = False) -> MassProperties:
    return MassProperties._of(_native.shape(kind, list(lengths), ends, substance))


def box(
    *, size: npt.ArrayLike, density: Quantity | None = None, mass: Quantity | None = None, material: str | None = None
) -> MassProperties:
    """Returns a solid box with edges ``size`` (3,) along x, y and z, centred at the origin.

    >>> from polhode import shapes
    >>> shapes.box(size=[0.2, 0.1, 0.06], density=1800).mass
    2.16
    """
    return _shape("box", _arrays.triple("size", size), given(density=density, mass=mass, material=material))


def box_shell(*, size: npt.ArrayLike, mass: Quantity | None = None, area_density: Quantity | None = None) -> MassProperties:
    """Returns the six thin faces of a box with edges ``size`` (3,), centred at the origin."""
    return _shape("box_shell", _arrays.triple("size", size), given(mass=mass, area_density=area_density))


def capsule(
    *, radius: Quantity, length: Quantity, density: Quantity | None = None, mass: Quantity | None = None, material: str | None = None
) -> MassProperties:
    """Returns a cylinder along z with a half ball at each end, centred at the origin.

    ``length`` is that of the cylinder without the half balls.
    """
    lengths = [_arrays.number("radius", radius), _arrays.number("length", length)]
    return _shape("capsule", lengths, given(density=density, mass=mass, material=material))


def cone(
    *,
    base_radius: Quantity,
    height: Quantity,
    top_radius: Quantity = 0.0,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
) -> MassProperties:
    """Returns a cone or a truncated cone along z: its base at z = 0, its top at z = ``height``."""
    lengths = [
        _arrays.number("base_radius", base_radius),
        _arrays.number("top_radius", top_radius),
        _arrays.number("height", height),
    ]
    return _shape("cone", lengths, given(density=density, mass=mass, material=material))


def cone_shell(
    *,
    base_radius: Quantity,
    height: Quantity,
    top_radius: Quantity = 0.0,
    ends: bool = False,
    mass: Quantity | None = None,
    area_density: Quantity | None = None,
) -> MassProperties:
    """Returns the thin wall of a cone or a truncated cone along z, open or with ends.

    Its base is at z = 0, and its top at z = ``height``.

    >>> from polhode import shapes
    >>> shapes.cone_shell(base_radius=0.3, height=0.6, mass=2.0).center_of_mass[2].round(12)
    np.float64(0.2)
    """
    lengths = [
        _arrays.number("base_radius", base_radius),
        _arrays.number("top_radius", top_radius),
        _arrays.number("height", height),
    ]
    return _shape("cone_shell", lengths, given(mass=mass, area_density=area_density), ends=_arrays.truth("ends", ends))


def cylinder(
    *,
    radius: Quantity,
    length: Quantity,
    inner_radius: Quantity = 0.0,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
) -> MassProperties:
    """Returns a cylinder along z, centred at the origin.

    It is solid, or has a coaxial bore of ``inner_radius``.

    >>> from polhode import shapes
    >>> shapes.cylinder(radius=0.5, inner_radius=0.4, length=0.1, mass=8.0).inertia[2, 2].round(12)
    np.float64(1.64)
    """
    lengths = [
        _arrays.number("radius", radius),
        _arrays.number("inner_radius", inner_radius),
        _arrays.number("length", length),
    ]
    return _shape("cylinder", lengths, given(density=density, mass=mass, material=material))


def cylinder_shell(
    *, radius: Quantity, length: Quantity, ends: bool = False, mass: Quantity | None = None, area_density: Quantity | None = None
) -> MassProperties:
    """Returns the thin wall of a cylinder along z, open or with ends, centred at the origin."""
    lengths = [_arrays.number("radius", radius), _arrays.number("length", length)]
    return _shape("cylinder_shell", lengths, given(mass=mass, area_density=area_density), ends=_arrays.truth("ends", ends))


def disk(*, radius: Quantity, mass: Quantity | None = None, area_density: Quantity | None = None) -> MassProperties:
    """Returns a thin disk in the x-y plane, centred at the origin."""
    return _shape("disk", [_arrays.number("radius", radius)], given(mass=mass, area_density=area_density))


def ellipsoid(
    *, semi_axes: npt.ArrayLike, density: Quantity | None = None, mass: Quantity | None = None, material: str | None = None
) -> MassProperties:
    """Returns a solid ellipsoid with ``semi_axes`` (3,) along x, y and z, centred at the origin."""
    return _shape("ellipsoid", _arrays.triple("semi_axes", semi_axes), given(density=density, mass=mass, material=material))


def plate(*, size: npt.ArrayLike, mass: Quantity | None = None, area_density: Quantity | None = None) -> MassProperties:
    """Returns a thin plate with edges ``size`` (2,) along x and y, centred at the origin."""
    return _shape("plate", _arrays.numbers("size", size, (2,)).tolist(), given(mass=mass, area_density=area_density))


def rod(*, length: Quantity, mass: Quantity | None = None, line_density: Quantity | None = None) -> MassProperties:
    """Returns a thin rod along z, centred at the origin."""
    return _shape("rod", [_arrays.number("length", length)], given(mass=mass, line_density=line_density))


def sphere(
    *,
    radius: Quantity,
    inner_radius: Quantity = 0.0,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
) -> MassProperties:
    """Returns a ball, centred at the origin.

    It is solid, or has a concentric cavity of ``inner_radius``.
    """
    lengths = [_arrays.number("radius", radius), _arrays.number("inner_radius", inner_radius)]
    return _shape("sphere", lengths, given(density=density, mass=mass, material=material))


def sphere_shell(*, radius: Quantity, mass: Quantity | None = None, area_density: Quantity | None = None) -> MassProperties:
    """Returns a thin spherical shell, centred at the origin."""
    return _shape("sphere_shell", [_arrays.number("radius", radius)], given(mass=mass, area_density=area_density))


def tetrahedron(
    *, vertices: npt.ArrayLike, density: Quantity | None = None, mass: Quantity | None = None, material: str | None = None
) -> MassProperties:
    """Returns a solid tetrahedron with the given ``vertices`` (4, 3)."""
    lengths = _arrays.numbers("vertices", vertices, (4, 3)).ravel().tolist()
    return _shape("tetrahedron", lengths, given(density=density, mass=mass, material=material))


def torus(
    *,
    ring_radius: Quantity,
    tube_radius: Quantity,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
) -> MassProperties:
    """Returns a solid torus about z, centred at the origin.

    The centre line of its tube has the radius ``ring_radius``.
    """
    lengths = [_arrays.number("ring_radius", ring_radius), _arrays.number("tube_radius", tube_radius)]
    return _shape("torus", lengths, given(density=density, mass=mass, material=material))


def triangular_plate(*, vertices: npt.ArrayLike, mass: Quantity | None = None, area_density: Quantity | None = None) -> MassProperties:
    """Returns a thin triangular plate in the x-y plane with the given ``vertices`` (3, 2).

    >>> from polhode import shapes
    >>> shapes.triangular_plate(vertices=[[0, 0], [0.3, 0], [0, 0.6]], mass=2.0).inertia[0, 1].round(12)
    np.float64(0.01)
    """
    lengths = _arrays.numbers("vertices", vertices, (3, 2)).ravel().tolist()
    return _shape("triangular_plate", lengths, given(mass=mass, area_density=area_density))


def triangular_prism(
    *, vertices: npt.ArrayLike, length: Quantity, density: Quantity | None = None, mass: Quantity | None = None, material: str | None = None
) -> MassProperties:
    """Returns a solid triangular prism along z, from z = −``length``/2 to ``length``/2.

    Its cross-section has the given ``vertices`` (3, 2).
    """
    lengths = [*_arrays.numbers("vertices", vertices, (3, 2)).ravel().tolist(), _arrays.number("length", length)]
    return _shape("triangular_prism", lengths, given(density=density, mass=mass, material=material))
