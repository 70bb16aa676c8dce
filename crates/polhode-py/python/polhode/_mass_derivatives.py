"""Derivatives of mass properties by particles, by parts, or by the vertices of a mesh."""

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
from ._public import public
from ._record import Record
from ._substance import Given, given
from ._units import Quantity

#: Names of the ten numbers of mass properties.
ROWS = ("mass", "center_x", "center_y", "center_z", "I_xx", "I_yy", "I_zz", "I_xy", "I_xz", "I_yz")


def ten(body: MassProperties) -> Floats:
    """Returns the ten numbers of a body (10,)."""
    inertia = body.inertia
    elements = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return np.concatenate([[body.mass], body.center_of_mass, elements])


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class ParticleDerivatives(Record):
    """Mass properties of particles with their derivatives; see :func:`particle_derivatives`.

    The first axis of all arrays is :attr:`rows`: the mass, kg; the centre of mass, m; and the
    elements of the inertia tensor about the centre of mass, kg·m². All are along the axes of the
    positions. They are exact except for rounding, about 4e-16 of the largest term.
    """

    #: Names of the rows. I_xy = I_yx is one number, an element of the tensor: minus the integral of
    #: xy.
    rows: ClassVar[tuple[str, ...]] = ROWS

    #: Mass properties as ten numbers (10,).
    values: Floats
    #: Derivatives by the mass of each particle (10, n), per kg.
    by_masses: Floats
    #: Derivatives by the coordinates of each particle (10, n, 3), per m.
    by_positions: Floats

    def __repr__(self) -> str:
        return f"ParticleDerivatives({self.by_masses.shape[1]} particles)"


def particle_derivatives(*, masses: npt.ArrayLike, positions: npt.ArrayLike) -> ParticleDerivatives:
    """Computes the derivatives of the mass properties of :func:`particles`, in closed form.

    Parameters
    ----------
    masses
        Masses (n,), kg, positive.
    positions
        Positions (n, 3), m.

    Returns
    -------
    ParticleDerivatives
        Derivatives by the masses (10, n) and by the positions (10, n, 3).

    Raises
    ------
    PolhodeError
        If an argument is invalid; the message names the argument, the element and the rule.

    Examples
    --------
    A dumbbell of 1 kg and 3 kg, 2 m apart. I_xx = μ l² with the reduced mass μ = 3/4 kg, so its
    derivative by l is 2 μ l.

    >>> import polhode
    >>> derivatives = polhode.particle_derivatives(masses=[1, 3], positions=[[0, 0, 0], [0, 0, 2]])
    >>> derivatives.by_positions[derivatives.rows.index("I_xx"), 1, 2]
    np.float64(3.0)
    """
    weights, places = checked_particles(masses, positions)
    values = ten(MassProperties._of(_native.MassProperties.of_particles(weights, places)))
    return ParticleDerivatives(values=values, **_native.particle_derivatives(weights, places))


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class BodyDerivatives(Record):
    """Mass properties of a body with derivatives by its parts; see :meth:`Body.derivatives`.

    The first axis of all arrays is :attr:`rows`: the mass, kg; the centre of mass, m; and the
    elements of the inertia tensor about the centre of mass, kg·m². The second axis is
    :attr:`parts`. All are in body axes. They are exact except for rounding, about 4e-16 of the
    largest term.
    """

    #: Names of the rows. I_xy = I_yx is one number, an element of the tensor: minus the integral of
    #: xy.
    rows: ClassVar[tuple[str, ...]] = ROWS

    #: Names of the n parts.
    parts: tuple[str, ...]
    #: Mass properties as ten numbers (10,).
    values: Floats
    #: Derivatives by the mass of each part (10, n), per kg, for a fixed shape and mass
    #: distribution.
    by_masses: Floats
    #: Derivatives by the density of each part, its mass per volume (10, n), per kg/m³; NaN for a
    #: part whose volume is not known.
    by_densities: Floats
    #: Derivatives by the position of each part (10, n, 3), per m.
    by_positions: Floats
    #: Derivatives by a small rotation vector θ of each part about its point (10, n, 3), per rad:
    #: R → exp(θ) R.
    by_rotations: Floats
    #: Derivatives by the ten numbers of each part where it is placed (10, n, 10), which are about
    #: its own centre of mass, body axes. Use them for the chain rule from a part to the whole:
    #: ``by_parts[:, k] @ …``.
    by_parts: Floats

    def __repr__(self) -> str:
        return f"BodyDerivatives({', '.join(map(repr, self.parts))})"


def body_derivatives(parts: dict[str, MassProperties], whole: MassProperties, about: dict[str, list[float]]) -> BodyDerivatives:
    """Computes the derivatives for parts that each rotate about a point, by default their own
    centre of mass."""
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


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class MeshDerivatives(Record):
    """Mass properties of a solid bounded by triangles, with their derivatives by its vertices.

    :func:`mesh_derivatives` returns it.

    The first axis of its arrays is :attr:`rows`: the mass, kg; the centre of mass, m; and the
    elements of the inertia tensor about the centre of mass, kg·m². All are along the axes of the
    vertices. They are exact except for rounding, about 1e-15 of the largest term, wherever the
    solid is.

    If the solid was given by its density, the density is constant when a vertex moves; if it was
    given by its mass, the mass is constant. Vertices with equal coordinates are one vertex of the
    solid and move together. Each gets an equal share of the derivatives, so that the sum over them
    is right. Vertices in no triangle have zeros.
    """

    #: Names of the rows. I_xy = I_yx is one number, an element of the tensor: minus the integral of
    #: xy.
    rows: ClassVar[tuple[str, ...]] = ROWS

    #: Vertices (n, 3), m.
    vertices: Floats
    #: Indices of the three vertices of each triangle (m, 3).
    triangles: npt.NDArray[np.uint32]
    _given: Given

    @cached_property
    def _solid(self) -> _native.MeshDerivatives:
        return _native.MeshDerivatives.of(self.vertices, self.triangles, self._given)

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass properties of the solid."""
        return MassProperties._of(self._solid.mass_properties)

    @property
    def values(self) -> Floats:
        """Mass properties as ten numbers (10,)."""
        return ten(self.mass_properties)

    @property
    def by_mass(self) -> Floats:
        """Derivatives by the mass (10,), per kg, for a fixed shape."""
        return self._solid.by_mass

    @property
    def by_density(self) -> Floats:
        """Derivatives by the density (10,), per kg/m³."""
        return self._solid.by_density

    @cached_property
    def by_vertices(self) -> Floats:
        """Derivatives by the coordinates of each vertex (10, n, 3), per m.

        It is :meth:`gradient` of each of the ten numbers.
        """
        by_vertices = self.gradient(np.eye(10))
        by_vertices.flags.writeable = False
        return by_vertices

    def gradient(self, of_number: npt.ArrayLike) -> Floats:
        """Computes the derivatives by all vertices of numbers that depend on the mass properties.

        Each number needs one pass over the triangles, about as long as the integrals. For fewer
        than ten numbers, this is faster than :attr:`by_vertices`.

        Parameters
        ----------
        of_number
            Derivatives (10,) of a number by :attr:`rows`, or those of several numbers (…, 10).

        Returns
        -------
        ndarray
            Derivatives (n, 3), or (…, n, 3), per m.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.

        Examples
        --------
        The largest moment of a wedge. Its derivative by the tensor is a aᵀ, where a is its axis.
        I_xy = I_yx is one number, so it counts twice:

        >>> import numpy as np, polhode
        >>> vertices, triangles = [[0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        >>> wedge = polhode.mesh_derivatives((vertices, triangles), density=1.0)
        >>> x, y, z = wedge.mass_properties.axes[2]
        >>> by_vertices = wedge.gradient([0, 0, 0, 0, x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z])
        >>> by_vertices.shape
        (4, 3)

        A moment is homogeneous of degree five in lengths:

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
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
) -> MeshDerivatives:
    """Computes the derivatives of a solid's mass properties by its vertices, in closed form.

    Parameters
    ----------
    mesh
        The tuple ``(vertices, triangles)`` as for :func:`inertia`: vertices (n, 3), m, and the
        indices from 0 of three vertices for each triangle (m, 3). The mesh must be closed. Normals
        that point inward are reversed, with a :class:`PolhodeWarning`.
    density, mass, material
        Exactly one of these: kg/m³, kg, or a name such as ``"steel"``.

    Returns
    -------
    MeshDerivatives
        Arrays (10, n, 3), or the gradient (n, 3) of any number that depends on the mass properties.

    Raises
    ------
    PolhodeError
        If the mesh is not closed, or an argument is invalid.

    Examples
    --------
    The tip of a wedge moves up by 1 m: the mass increases by ρ A/3, and the centre of mass rises by
    1/4 m.

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
        raise PolhodeError(f"mesh is a tuple of {len(mesh)}, but must be (vertices, triangles)")
    substance = given(density=density, mass=mass, material=material)
    vertices, triangles = _arrays.mesh(*mesh)
    # Copies, because the caller may change the originals.
    made = MeshDerivatives(vertices.copy(), triangles.copy(), substance)
    made.mass_properties._heard()
    return made
