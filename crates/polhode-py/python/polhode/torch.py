"""Free motion and mass properties as functions of PyTorch tensors, with exact derivatives.

They work with ``backward``, ``torch.autograd``, forward mode, and ``torch.func``. Values and
partial derivatives are those of :class:`polhode.FreeMotion`, :func:`polhode.particle_derivatives`,
:func:`polhode.mesh_derivatives` and :meth:`polhode.Body.derivatives`, in closed form, without
differentiating an integrator. They are computed on the CPU, in float64. Arguments of lower
precision are converted, and results are float64. If an argument is on another device, the result is
moved there. Second derivatives are refused.
"""

# If PyTorch is not installed, pyright takes this module for it.
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import torch

from . import _arrays
from ._differentiable import BODY, FREE_MOTION, MESH, PARTICLES, TENSOR, Function, Motion, Properties, no_second_derivatives

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
        ``omega`` (n, 3), body axes, rad/s, and ``attitude`` (n, 4), unit quaternions. For a single
        time, (3,) and (4,). Leading axes of the arguments are a batch and are broadcast.

    Notes
    -----
    Derivatives are by all four arguments. :func:`polhode.jax.free_motion` describes derivatives by
    a quaternion and by a symmetric tensor, and the signs of quaternions.

    Examples
    --------
    Gradient of the angle between the attitude after 7 s and a target:

    >>> import torch, polhode.torch
    >>> inertia = torch.tensor([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]], dtype=torch.float64)
    >>> omega = torch.tensor([0.7, -1.1, 0.4], dtype=torch.float64, requires_grad=True)
    >>> motion = polhode.torch.free_motion(inertia, [1, 0, 0, 0], omega, 7.0)
    >>> miss = 2.0 * torch.arccos(abs(motion.attitude @ torch.full((4,), 0.5, dtype=torch.float64)))
    >>> miss.backward()
    >>> omega.grad.shape
    torch.Size([3])
    """
    moment = _tensor("times", times)
    rows = _called(FREE_MOTION, inertia, attitude, omega, moment[None] if moment.ndim == 0 else moment)
    rows = rows[..., 0, :] if moment.ndim == 0 else rows
    return Motion(omega=rows[..., 4:], attitude=rows[..., :4])


def particles(masses: Any, positions: Any) -> Properties:
    """Computes the mass properties of point masses.

    ``masses`` (n,), kg, are positive, and ``positions`` (n, 3) are in m.

    The result is the mass, the centre of mass (3,), and the inertia tensor (3, 3) about it, along
    the axes of the positions. Leading axes are a batch.

    >>> import torch, polhode.torch
    >>> positions = torch.tensor([[0.0, 0, 0], [0, 0, 2]], dtype=torch.float64, requires_grad=True)
    >>> polhode.torch.particles([1.0, 3.0], positions).inertia[0, 0].backward()  # μ l², μ = 3/4 kg
    >>> positions.grad[1]
    tensor([0., 0., 3.], dtype=torch.float64)
    """
    return _properties(_called(PARTICLES, masses, positions))


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

    Examples
    --------
    >>> import torch, polhode.torch
    >>> vertices = torch.tensor([[0.0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]], dtype=torch.float64, requires_grad=True)
    >>> triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> polhode.torch.mesh(vertices, triangles, 1.0).mass.backward()
    >>> vertices.grad[3].round(decimals=12)  # by the tip: a third of the ground's area
    tensor([0., 0., 1.], dtype=torch.float64)
    """
    return _properties(_called(MESH, vertices, triangles, density))


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
        common axes, kg·m². A gradient by them is symmetric.

    Returns
    -------
    Properties
        Mass, centre of mass (3,), and the inertia tensor (3, 3) about it. Leading axes are a batch.

    Examples
    --------
    Moving a part outwards by 1 m moves the centre of mass by the part's share of the mass:

    >>> import torch, polhode.torch
    >>> centers = torch.tensor([[0.0, 0.0, 0.3], [0.0, 0.0, 0.15]], dtype=torch.float64, requires_grad=True)
    >>> polhode.torch.body([0.7, 0.1], centers, [[[1e-3, 0, 0], [0, 1e-3, 0], [0, 0, 1e-4]]] * 2).center_of_mass[2].backward()
    >>> centers.grad[0].round(decimals=12)
    tensor([0.0000, 0.0000, 0.8750], dtype=torch.float64)
    """
    return _properties(_called(BODY, masses, centers_of_mass, inertias))


def _properties(numbers: Any) -> Properties:
    return Properties(mass=numbers[..., 0], center_of_mass=numbers[..., 1:4], inertia=numbers[..., torch.tensor(TENSOR)])


def _tensor(name: str, value: Any) -> Any:
    """Converts an argument to a tensor of float64 or of integers."""
    if not isinstance(value, torch.Tensor):
        # A copy, because the original may change before the derivatives are computed.
        value = torch.tensor(value if name == "triangles" else _arrays.real(name, value))
    if value.dtype == torch.bool or value.is_complex() or value.is_quantized:
        raise TypeError(f"{name} must be real numbers, not {value.dtype}")
    return value.to(torch.float64) if value.is_floating_point() else value


def _called(function: Function, *given: Any) -> Any:
    tensors = [_tensor(name, value) for name, value in zip(function.arguments, given)]
    batch, _ = function.sizes([tuple(tensor.shape) for tensor in tensors])
    place = next((tensor.device for tensor in tensors if tensor.device.type != "cpu"), torch.device("cpu"))
    own = [tensor.shape[tensor.ndim - len(letters) :] for tensor, letters in zip(tensors, function.arguments.values())]
    here = [tensor.cpu().broadcast_to((*batch, *shape)) for tensor, shape in zip(tensors, own)]
    return _Call.apply(function, *here).to(place)


def _on_host(tensors: Sequence[Any]) -> list[Any]:
    return [tensor.detach().numpy() for tensor in tensors]


def _batched(call: Any, first: tuple[Any, ...], in_dims: tuple[int | None, ...], given: tuple[Any, ...]) -> Any:
    """Applies a call whose arguments have an additional batch axis, which is moved to the front."""
    count = next(tensor.shape[axis] for tensor, axis in zip(given, in_dims) if axis is not None)
    moved = [
        tensor.expand(count, *tensor.shape) if axis is None else tensor.movedim(axis, 0) for tensor, axis in zip(given, in_dims)
    ]
    return call.apply(*first, *moved)


class _Call(torch.autograd.Function):  # type: ignore[misc]
    """A function whose derivatives are products of partial derivatives with (co)tangents."""

    @staticmethod
    def forward(function: Function, *given: Any) -> Any:
        return torch.from_numpy(function.value(*_on_host(given)))

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
        ctx.function = inputs[0]
        ctx.save_for_backward(*inputs[1:])
        ctx.save_for_forward(*inputs[1:])

    @staticmethod
    def backward(ctx: Any, cotangent: Any) -> tuple[Any, ...]:
        function = ctx.function
        by = tuple(name for name, is_needed in zip(function.arguments, ctx.needs_input_grad[1:]) if is_needed)
        partials = _Partials.apply(function, by, *ctx.saved_tensors)
        found = {name: torch.einsum(function.cotangent(name), partial, cotangent) for name, partial in zip(by, partials)}
        return None, *(found.get(name) for name in function.arguments)

    @staticmethod
    def jvp(ctx: Any, _: None, *tangents: Any) -> Any:
        function = ctx.function
        moving = {name: tangent for name, tangent in zip(function.arguments, tangents) if tangent is not None and name in function.partials}
        partials = _Partials.apply(function, tuple(moving), *ctx.saved_tensors)
        return sum(torch.einsum(function.tangent(name), partial, moving[name]) for name, partial in zip(moving, partials))

    @staticmethod
    def vmap(info: Any, in_dims: tuple[Any, ...], function: Function, *given: Any) -> tuple[Any, int]:
        return _batched(_Call, (function,), in_dims[1:], given), 0


class _Partials(torch.autograd.Function):  # type: ignore[misc]
    """Partial derivatives, without derivatives of their own.

    With ``once_differentiable`` they would count as constants, and a Hessian would be zero.
    """

    @staticmethod
    def forward(function: Function, by: tuple[str, ...], *given: Any) -> tuple[Any, ...]:
        return tuple(map(torch.from_numpy, function.with_partials(by, *_on_host(given))[1:]))

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
        ctx.function = inputs[0]

    @staticmethod
    def backward(ctx: Any, *cotangents: Any) -> Any:
        raise no_second_derivatives(ctx.function.name)

    @staticmethod
    def jvp(ctx: Any, *tangents: Any) -> Any:
        raise no_second_derivatives(ctx.function.name)

    @staticmethod
    def vmap(info: Any, in_dims: tuple[Any, ...], function: Function, by: tuple[str, ...], *given: Any) -> tuple[Any, Any]:
        return _batched(_Partials, (function, by), in_dims[2:], given), (0,) * len(by)
