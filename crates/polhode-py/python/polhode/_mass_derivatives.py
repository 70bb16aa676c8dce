"""Derivatives of mass properties by what a body is made of: particles, parts, or the vertices of a mesh."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._arrays import Floats
from ._error import PolhodeError
from ._mass_properties import MassProperties, checked_particles
from ._record import Record
from ._substance import Given, given

#: The ten numbers of mass properties.
ROWS = ("mass", "center_x", "center_y", "center_z", "I_xx", "I_yy", "I_zz", "I_xy", "I_xz", "I_yz")


def ten(body: MassProperties) -> Floats:
    """The ten numbers of a body."""
    inertia = body.inertia
    elements = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return np.concatenate([[body.mass], body.center_of_mass, elements])


@dataclass(frozen=True, eq=False, repr=False)
class ParticleDerivatives(Record):
    """Mass properties of particles with their derivatives by each particle. :func:`particle_derivatives` makes one.

    The first axis of all arrays is :attr:`rows`: the mass, kg; the centre of mass, m; and the elements of the inertia tensor about the centre of
    mass, kg·m². All are along the axes of the positions. They are exact but for rounding, some 4e-16 of the largest term.
    """

    #: What the rows are of. I_xy = I_yx is one number, an element of the tensor: minus the integral of xy.
    rows: ClassVar[tuple[str, ...]] = ROWS

    #: The ten numbers themselves (10,).
    values: Floats
    #: By the mass of each particle (10, n), per kg.
    by_masses: Floats
    #: By the coordinates of each particle (10, n, 3), per m.
    by_positions: Floats

    def __repr__(self) -> str:
        return f"ParticleDerivatives({self.by_masses.shape[1]} particles)"


def particle_derivatives(*, masses: npt.ArrayLike, positions: npt.ArrayLike) -> ParticleDerivatives:
    """The derivatives of what :func:`particles` computes, in closed form.

    Parameters
    ----------
    masses
        Masses (n,), kg, positive.
    positions
        Where they are (n, 3), m.

    Returns
    -------
    ParticleDerivatives
        Arrays (10, n) and (10, n, 3).

    Raises
    ------
    PolhodeError
        Where an argument is refused: its name, the element and the rule are in the message.

    Examples
    --------
    A dumbbell of 1 kg and 3 kg, 2 m apart: I_xx = μ l² with the reduced mass μ = 3/4 kg, so that it grows by 2 μ l for each metre.

    >>> import polhode
    >>> derivatives = polhode.particle_derivatives(masses=[1, 3], positions=[[0, 0, 0], [0, 0, 2]])
    >>> derivatives.by_positions[derivatives.rows.index("I_xx"), 1, 2]
    np.float64(3.0)
    """
    weights, places = checked_particles(masses, positions)
    values = ten(MassProperties._of(_native.MassProperties.of_particles(weights, places)))
    return ParticleDerivatives(values=values, **_native.particle_derivatives(weights, places))


@dataclass(frozen=True, eq=False, repr=False)
class BodyDerivatives(Record):
    """Mass properties of a body with their derivatives by each of its parts. :meth:`Body.derivatives` makes one.

    The first axis of all arrays is :attr:`rows`: the mass, kg; the centre of mass, m; and the elements of the inertia tensor about the centre of
    mass, kg·m². The second is :attr:`parts`. All are along body axes. They are exact but for rounding, some 4e-16 of the largest term.
    """

    #: What the rows are of. I_xy = I_yx is one number, an element of the tensor: minus the integral of xy.
    rows: ClassVar[tuple[str, ...]] = ROWS

    #: The names of the n parts.
    parts: tuple[str, ...]
    #: The ten numbers themselves (10,).
    values: Floats
    #: By the mass of each part (10, n), per kg; its form and the distribution of its mass stay.
    by_masses: Floats
    #: By the density of each part, its mass per volume (10, n), per kg/m³; NaN of a part whose volume is not known.
    by_densities: Floats
    #: By the position of each part (10, n, 3), per m.
    by_positions: Floats
    #: By a small rotation vector θ of each part about its point (10, n, 3), per rad: R → exp(θ) R.
    by_rotations: Floats
    #: By the ten numbers of each part where it is placed (10, n, 10), which are about its own centre of mass, along body axes. It takes derivatives of a
    #: part on to the whole: ``by_parts[:, k] @ …``.
    by_parts: Floats

    def __repr__(self) -> str:
        return f"BodyDerivatives({', '.join(map(repr, self.parts))})"


def body_derivatives(parts: dict[str, MassProperties], whole: MassProperties, about: dict[str, list[float]]) -> BodyDerivatives:
    """Of parts that each turn about a point; about their own centres of mass where none is given."""
    points = [about[name] if name in about else part.center_of_mass.tolist() for name, part in parts.items()]
    by = _native.body_derivatives([part._native for part in parts.values()], points)
    volumes = [np.nan if part.volume is None else part.volume for part in parts.values()]
    return BodyDerivatives(
        parts=tuple(parts),
        values=ten(whole),
        by_masses=by["by_masses"],
        by_densities=by["by_masses"] * volumes,
        by_positions=by["by_positions"],
        by_rotations=by["by_rotations"],
        by_parts=by["by_parts"],
    )


@dataclass(frozen=True, eq=False, repr=False)
class MeshDerivatives(Record):
    """Mass properties of a solid that triangles bound, with their derivatives by its vertices. :func:`mesh_derivatives` makes one.

    The first axis of its arrays is :attr:`rows`: the mass, kg; the centre of mass, m; and the elements of the inertia tensor about the centre of
    mass, kg·m². All are along the axes of the vertices. They are exact but for rounding, some 1e-15 of the largest term, wherever the solid is.

    A solid that is made of a density keeps it where a vertex moves, one of a given mass keeps that. Vertices of equal coordinates are one vertex of the solid,
    so they move together: each has an equal share of its derivatives, and a sum over all of them is right. What is in no triangle has zeros.
    """

    #: What the rows are of. I_xy = I_yx is one number, an element of the tensor: minus the integral of xy.
    rows: ClassVar[tuple[str, ...]] = ROWS

    #: The vertices (n, 3), m.
    vertices: Floats
    #: The numbers of three of them for each triangle (m, 3).
    triangles: npt.NDArray[np.uint32]
    _given: Given

    @cached_property
    def _solid(self) -> _native.MeshDerivatives:
        return _native.MeshDerivatives.of(self.vertices, self.triangles, self._given)

    @cached_property
    def mass_properties(self) -> MassProperties:
        """The mass properties themselves."""
        return MassProperties._of(self._solid.mass_properties)

    @property
    def values(self) -> Floats:
        """The ten numbers themselves (10,)."""
        return ten(self.mass_properties)

    @property
    def by_mass(self) -> Floats:
        """By the mass (10,), per kg, of the same form."""
        return self._solid.by_mass

    @property
    def by_density(self) -> Floats:
        """By the density (10,), per kg/m³."""
        return self._solid.by_density

    @cached_property
    def by_vertices(self) -> Floats:
        """By the coordinates of each vertex (10, n, 3), per m: :meth:`gradient` of each of the ten numbers."""
        by_vertices = self.gradient(np.eye(10))
        by_vertices.flags.writeable = False
        return by_vertices

    def gradient(self, of_number: npt.ArrayLike) -> Floats:
        """The derivatives by all vertices of numbers that depend on the mass properties.

        Each number takes one pass over the triangles, about as long as the integrals take: less than :attr:`by_vertices` for fewer than ten.

        Parameters
        ----------
        of_number
            The derivatives (10,) of a number by :attr:`rows`, or those of several (…, 10).

        Returns
        -------
        ndarray
            (n, 3), or (…, n, 3), per m.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.

        Examples
        --------
        The largest moment of a wedge, whose derivative by the tensor is a aᵀ, a its axis; I_xy = I_yx is one number, so that it counts twice:

        >>> import numpy as np, polhode
        >>> vertices, triangles = [[0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        >>> wedge = polhode.mesh_derivatives((vertices, triangles), density=1.0)
        >>> x, y, z = wedge.mass_properties.axes[2]
        >>> by_vertices = wedge.gradient([0, 0, 0, 0, x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z])
        >>> by_vertices.shape
        (4, 3)

        A moment is of the fifth degree in lengths:

        >>> bool(np.isclose(np.sum(by_vertices * vertices), 5 * wedge.mass_properties.moments[2], rtol=1e-13))
        True
        """
        rows = _arrays.real("of_number", of_number)
        if rows.ndim < 1 or rows.shape[-1] != 10:
            raise PolhodeError(f"of_number must have the shape (10,) or (…, 10), a column for each of rows, not {rows.shape}")
        flat = _arrays.numbers("of_number", rows, rows.shape).reshape(-1, 10)
        return self._solid.gradient(flat).reshape(*rows.shape[:-1], len(self.vertices), 3)

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def __repr__(self) -> str:
        return f"MeshDerivatives({len(self.vertices)} vertices, {len(self.triangles)} triangles)"


def mesh_derivatives(
    mesh: tuple[npt.ArrayLike, npt.ArrayLike],
    *,
    density: float | None = None,
    mass: float | None = None,
    material: str | None = None,
) -> MeshDerivatives:
    """The derivatives of a solid's mass properties by the vertices of its surface, in closed form.

    Parameters
    ----------
    mesh
        The tuple ``(vertices, triangles)`` as :func:`inertia` takes it: vertices (n, 3), m, and the numbers of three of them for each triangle (m, 3), from 0. It
        has to bound a solid; normals that point inward are turned, with a :class:`PolhodeWarning`.
    density, mass, material
        Exactly one: kg/m³, kg, or a name such as ``"steel"``.

    Returns
    -------
    MeshDerivatives
        Arrays (10, n, 3), or the gradient (n, 3) of any number that depends on the mass properties.

    Raises
    ------
    PolhodeError
        Where the mesh bounds no solid, or an argument is refused.

    Examples
    --------
    The tip of a wedge higher by 1 m: the mass is larger by ρ A/3, the centre of mass higher by 1/4 m.

    >>> import polhode
    >>> vertices, triangles = [[0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> wedge = polhode.mesh_derivatives((vertices, triangles), density=1.0)
    >>> wedge.by_vertices.shape
    (10, 4, 3)
    >>> mass, _, _, center_z, *_ = wedge.by_vertices[:, 3, 2].round(12)
    >>> mass, center_z
    (np.float64(1.0), np.float64(0.25))
    """
    if not isinstance(mesh, tuple):
        raise TypeError(f"mesh must be the tuple (vertices, triangles), not {type(mesh).__name__}")
    if len(mesh) != 2:
        raise PolhodeError(f"mesh is a tuple of {len(mesh)}: it is (vertices, triangles)")
    substance = given(density=density, mass=mass, material=material)
    vertices, triangles = _arrays.mesh(*mesh)
    # Copies, as what was given may change.
    made = MeshDerivatives(vertices.copy(), triangles.copy(), substance)
    made.mass_properties._heard()
    return made
