"""Free motion and mass properties as functions of JAX arrays, with exact derivatives.

They work under ``jax.jit``, ``grad``, ``jacfwd``, ``jacrev``, ``jvp``, ``vjp`` and ``vmap``. Values
and partial derivatives are those of :class:`polhode.FreeMotion`,
:func:`polhode.particle_derivatives`, :func:`polhode.mesh_derivatives` and
:meth:`polhode.Body.derivatives`, in closed form, without differentiating an integrator. They are
computed on the host, even for arrays on another device.

Numbers are float64, so JAX must have these enabled: ``jax.config.update("jax_enable_x64", True)``.
Second derivatives are refused.

Errors are raised as :exc:`polhode.PolhodeError`. In compiled calls, under ``jit`` or ``vmap``, JAX
raises its own ``JaxRuntimeError``, whose text ends with the message.
"""

from __future__ import annotations

import functools
from typing import Any, Callable

import jax
import jax.core
import jax.numpy as jnp
import numpy as np
from jax.custom_derivatives import SymbolicZero

from . import _arrays
from ._differentiable import BODY, FREE_MOTION, MESH, PARTICLES, TENSOR, Function, Motion, Properties, no_second_derivatives
from ._error import PolhodeError

__all__ = ["Motion", "Properties", "body", "free_motion", "mesh", "particles"]


def free_motion(inertia: Any, attitude: Any, omega: Any, times: Any) -> Motion:
    """Computes the torque-free motion of a body, as :class:`polhode.FreeMotion`.

    Parameters
    ----------
    inertia
        Inertia tensor (3, 3) about the centre of mass, body axes, kg·m², symmetric.
    attitude
        Attitude R_space_body at t = 0 as a quaternion (4,): w, x, y, z, of any nonzero norm.
    omega
        Angular velocity (3,) at t = 0, body axes, rad/s.
    times
        Times (n,), s, in any order, also before the start; or a single time.

    Returns
    -------
    Motion
        ``omega`` (n, 3), body axes, rad/s, and ``attitude`` (n, 4), unit quaternions. The first has
        w ≥ 0, and each other one is continuous in sign. For a single time, (3,) and (4,). Leading
        axes of the arguments are a batch and are broadcast.

    Notes
    -----
    Derivatives are by all four arguments.

    - A tangent q̇ of an attitude is that of a unit quaternion, q · q̇ = 0. It rotates the body by
      θ = 2 vec(q* ⊗ q̇), rad, body axes: R exp(θ). At the start, the component of a given tangent
      along q has no effect, because the norm of q has none. A gradient by q has no such component.
    - A tensor is symmetric. Only the symmetric part of a tangent counts, and a gradient is
      symmetric, so that a step along it keeps the tensor symmetric. The sum of products of the
      gradient with a symmetric change is the change of the function. I_xy and I_yx have half of the
      derivative each; :attr:`polhode.results.Derivatives.by_inertia` has them as one number.
    - The quaternions q and −q are the same attitude. When the first quaternion passes w = 0, the
      sign of all of them changes. An objective function must not depend on the sign; R and
      (q · q₀)² do not.

    Examples
    --------
    Gradient of the angle between the attitude after 7 s and a target:

    >>> import jax, jax.numpy as jnp
    >>> import polhode.jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> inertia = jnp.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
    >>> target = jnp.array([0.5, 0.5, 0.5, 0.5])
    >>> def miss(omega):
    ...     motion = polhode.jax.free_motion(inertia, jnp.array([1.0, 0.0, 0.0, 0.0]), omega, 7.0)
    ...     return 2.0 * jnp.arccos(jnp.abs(motion.attitude @ target))
    >>> gradient = jax.jit(jax.grad(miss))(jnp.array([0.7, -1.1, 0.4]))
    >>> gradient.shape, str(gradient.dtype)
    ((3,), 'float64')
    """
    single = jnp.ndim(times) == 0
    rows = _free_motion(*_given(FREE_MOTION, inertia, attitude, omega, [times] if single else times))
    rows = rows[..., 0, :] if single else rows
    return Motion(omega=rows[..., 4:], attitude=rows[..., :4])


def particles(masses: Any, positions: Any) -> Properties:
    """Computes the mass properties of point masses.

    ``masses`` (n,), kg, are positive, and ``positions`` (n, 3) are in m.

    The result is the mass, the centre of mass (3,), and the inertia tensor (3, 3) about it, along
    the axes of the positions. Leading axes are a batch.

    Gradient of the least principal moment of four points by their positions:

    >>> import jax, jax.numpy as jnp
    >>> import polhode.jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> masses = jnp.array([1.2, 0.7, 0.9, 1.1])
    >>> positions = jnp.array([[0.3, -0.1, 0.2], [-0.5, 0.4, 0.1], [0.2, 0.6, -0.7], [-0.1, -0.5, 0.4]])
    >>> least = lambda positions: jnp.linalg.eigvalsh(polhode.jax.particles(masses, positions).inertia)[0]
    >>> gradient = jax.grad(least)(positions)
    >>> bool(jnp.isclose(jnp.sum(gradient * positions), 2.0 * least(positions)))  # a moment is of the second degree in lengths
    True
    """
    return _properties(_particles(*_given(PARTICLES, masses, positions)))


def mesh(vertices: Any, triangles: Any, density: Any) -> Properties:
    """Computes the mass properties of a solid bounded by triangles.

    See :func:`polhode.mesh_derivatives`.

    Parameters
    ----------
    vertices
        Vertices (n, 3), m.
    triangles
        Indices from 0 of three vertices for each triangle (m, 3). They are integers and have no
        derivatives.
    density
        Density, kg/m³.

    Returns
    -------
    Properties
        Mass, centre of mass (3,), and the inertia tensor (3, 3) about it. Leading axes are a batch.

    Notes
    -----
    The partial derivatives by the vertices are an array (10, n, 3). Vertices with equal coordinates
    are one vertex of the solid. Each gets an equal share of the derivatives, which is right while
    they move together.

    Examples
    --------
    >>> import jax, jax.numpy as jnp
    >>> import polhode.jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> vertices = jnp.array([[0.0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]])
    >>> triangles = jnp.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    >>> jax.grad(lambda vertices: polhode.jax.mesh(vertices, triangles, 1.0).mass)(vertices)[3].round(12)  # by the tip: a third of the ground's area
    Array([0., 0., 1.], dtype=float64)
    """
    return _properties(_mesh(*_given(MESH, vertices, triangles, density)))


def body(masses: Any, centers_of_mass: Any, inertias: Any) -> Properties:
    """Computes the mass properties of rigidly joined parts.

    Parameters
    ----------
    masses
        Masses of the parts (p,), kg.
    centers_of_mass
        Centres of mass of the parts (p, 3), m.
    inertias
        Inertia tensors of the parts (p, 3, 3), each about the part's own centre of mass, along
        common axes, kg·m². A gradient by them is symmetric, as for :func:`free_motion`.

    Returns
    -------
    Properties
        Mass, centre of mass (3,), and the inertia tensor (3, 3) about it. Leading axes are a batch.

    Examples
    --------
    Moving a part outwards by 1 m moves the centre of mass by the part's share of the mass:

    >>> import jax, jax.numpy as jnp
    >>> import polhode.jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> masses, inertias = jnp.array([0.7, 0.1]), jnp.array([jnp.diag(jnp.array([1e-3, 1e-3, 1e-4]))] * 2)
    >>> center = lambda z: polhode.jax.body(masses, jnp.array([[0.0, 0.0, z], [0.0, 0.0, 0.15]]), inertias).center_of_mass[2]
    >>> jax.grad(center)(0.3).round(12)
    Array(0.875, dtype=float64, weak_type=True)
    """
    return _properties(_body(*_given(BODY, masses, centers_of_mass, inertias)))


def _properties(numbers: Any) -> Properties:
    return Properties(mass=numbers[..., 0], center_of_mass=numbers[..., 1:4], inertia=numbers[..., np.array(TENSOR)])


def _given(function: Function, *given: Any) -> list[Any]:
    """Converts the arguments to arrays of one batch."""
    if not jax.config.read("jax_enable_x64"):
        hint = 'jax.config.update("jax_enable_x64", True) before the first array is made'
        raise PolhodeError(f"{function.name} needs float64, but JAX uses float32, which loses half of the digits", hint)
    arrays = [_array(name, value) for name, value in zip(function.arguments, given)]
    batch, _ = function.sizes([array.shape for array in arrays])
    own = [array.shape[array.ndim - len(letters) :] for array, letters in zip(arrays, function.arguments.values())]
    return [jnp.broadcast_to(array, batch + shape) for array, shape in zip(arrays, own)]


def _array(name: str, value: Any) -> Any:
    """Converts an argument to an array: JAX floats to float64, other numbers as elsewhere in the
    package."""
    if not any(isinstance(leaf, jax.Array) for leaf in jax.tree.leaves(value)):
        # A copy, because the original may change before the derivatives are computed.
        array = jnp.array(value if name == "triangles" else _arrays.real(name, value))
    else:
        array = jnp.asarray(value)
    if jnp.issubdtype(array.dtype, jnp.floating):
        return array.astype(jnp.float64)
    if not jnp.issubdtype(array.dtype, jnp.integer):
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    # Integers are passed unchanged, so that none is rounded.
    return array


def _differentiable(function: Function) -> Callable[..., Any]:
    """Makes a function with derivatives.

    The forward derivative is the product of partial derivatives and tangents, which JAX transposes.
    """

    @functools.cache
    def on_host(by: tuple[str, ...]) -> Callable[..., tuple[Any, ...]]:
        return lambda *arrays: function.with_partials(by, *map(np.asarray, arrays))

    def called(by: tuple[str, ...], given: tuple[Any, ...]) -> tuple[Any, ...]:
        if not any(isinstance(array, jax.core.Tracer) for array in given):
            # Nothing is compiled here, so errors are raised unchanged.
            return tuple(map(jnp.asarray, on_host(by)(*given)))
        shapes = [array.shape for array in given]
        found = [function.output_shape(shapes), *(function.partial_shape(name, shapes) for name in by)]
        kinds = tuple(jax.ShapeDtypeStruct(shape, jnp.float64) for shape in found)
        return tuple(jax.pure_callback(on_host(by), kinds, *given, vmap_method="expand_dims"))

    def value(*given: Any) -> Any:
        return called((), given)[0]

    @functools.cache
    def with_partials(by: tuple[str, ...]) -> Callable[..., Any]:
        def second(primals: Any, tangents: Any) -> Any:
            raise no_second_derivatives(function.name)

        partials = jax.custom_jvp(lambda *given: called(by, given))
        partials.defjvp(second)
        return partials  # type: ignore[no-any-return]

    def along(primals: tuple[Any, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
        moving = {
            name: tangent
            for name, tangent in zip(function.arguments, tangents)
            if name in function.partials and not isinstance(tangent, SymbolicZero) and tangent.dtype != jax.dtypes.float0
        }
        found, *partials = with_partials(tuple(moving))(*primals)
        change = jnp.zeros_like(found)
        for (name, tangent), partial in zip(moving.items(), partials):
            change = change + jnp.einsum(function.tangent(name), partial, tangent, precision="highest")
        return found, change

    made = jax.custom_jvp(value)
    made.defjvp(along, symbolic_zeros=True)
    return made  # type: ignore[no-any-return]


_free_motion = _differentiable(FREE_MOTION)
_particles = _differentiable(PARTICLES)
_mesh = _differentiable(MESH)
_body = _differentiable(BODY)
