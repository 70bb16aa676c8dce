"""Functions of arrays with their partial derivatives, for :mod:`polhode.jax` and
:mod:`polhode.torch`.

Each function takes and returns plain arrays, whose leading axes are a batch. Letters, as in
:func:`numpy.einsum`, name the axes of the arguments, of the value and of the partial derivatives.
JAX and PyTorch only add the product of partial derivatives with tangents or cotangents, which is
linear.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _rotation
from ._arrays import Floats
from ._error import PolhodeError
from ._free_motion import FreeMotion
from ._mass_derivatives import body_derivatives, mesh_derivatives, particle_derivatives, ten
from ._mass_properties import MassProperties, joined, particles

#: Lengths of axes that always have the same length: vector components, and components of a
#: quaternion.
_LENGTHS = {"i": 3, "j": 3, "k": 3, "q": 4}

#: Index of each element of a tensor (3, 3) in the list xx yy zz xy xz yz, and the weight of its
#: derivative: an off-diagonal number is two elements, each with half of the derivative.
_ELEMENTS = np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])
_SHARES = np.where(np.eye(3, dtype=bool), 1.0, 0.5)

#: Index of each element of the tensor (3, 3) among the ten numbers of mass properties.
TENSOR = (4 + _ELEMENTS).tolist()


class Motion(NamedTuple):
    """States of a free motion, as arrays of the calling library (JAX or PyTorch)."""

    #: Angular velocity (…, n, 3), body axes, rad/s.
    omega: Any
    #: Attitudes R_space_body as unit quaternions (…, n, 4): w, x, y, z.
    attitude: Any


class Properties(NamedTuple):
    """Mass properties, as arrays of the calling library (JAX or PyTorch)."""

    #: Mass (…), kg.
    mass: Any
    #: Centre of mass (…, 3), m.
    center_of_mass: Any
    #: Inertia tensor about the centre of mass (…, 3, 3), kg·m².
    inertia: Any


@dataclass(frozen=True)
class Function:
    """A function of arrays, and its partial derivatives."""

    #: Name of the function for users.
    name: str
    #: Letters of the axes of each argument, without those of the batch.
    arguments: Mapping[str, str]
    #: Letters of the axes of the value.
    output: str
    #: Lengths of the axes of the value that no argument has.
    lengths: Mapping[str, int]
    #: Letters of the axes of the partial derivatives, by the argument with respect to which they
    #: are taken.
    partials: Mapping[str, str]
    _value: Callable[..., Floats]
    _partials: Callable[..., tuple[Floats, Mapping[str, Callable[[], Floats]]]]
    #: The value and its partial derivatives for a whole batch (b) of arguments, if they can be
    #: computed in one call. It returns ``None`` if an element is not valid.
    _batched: Callable[..., list[Floats] | None] | None = None

    def sizes(self, shapes: Sequence[tuple[int, ...]]) -> tuple[tuple[int, ...], dict[str, int]]:
        """Returns the shape of the batch and the length of each axis, for arguments of these
        shapes."""
        lengths: dict[str, int] = {**_LENGTHS, **self.lengths}
        batches = []
        for (name, letters), shape in zip(self.arguments.items(), shapes):
            first = len(shape) - len(letters)
            wrong = first < 0
            for letter, length in zip(letters, shape[max(first, 0) :]):
                wrong = wrong or lengths.setdefault(letter, length) != length
            if wrong:
                axes = ", ".join(str(lengths[letter]) if letter in lengths else letter for letter in letters)
                raise PolhodeError(f"{name} must have the shape ({', '.join(filter(None, ['…', axes]))}), not {shape}")
            batches.append(shape[:first])
        try:
            return np.broadcast_shapes(*batches), lengths
        except ValueError:
            said = ", ".join(f"{name} has {batch}" for name, batch in zip(self.arguments, batches))
            raise PolhodeError(f"{said}: leading axes must be the same, or 1") from None

    def output_shape(self, shapes: Sequence[tuple[int, ...]]) -> tuple[int, ...]:
        """Returns the shape of the value."""
        batch, lengths = self.sizes(shapes)
        return batch + tuple(lengths[letter] for letter in self.output)

    def partial_shape(self, by: str, shapes: Sequence[tuple[int, ...]]) -> tuple[int, ...]:
        """Returns the shape of the partial derivatives by an argument."""
        batch, lengths = self.sizes(shapes)
        return batch + tuple(lengths[letter] for letter in self.partials[by])

    def tangent(self, by: str) -> str:
        """Returns the ``einsum`` subscripts of partial derivatives by an argument times its
        tangent."""
        return f"...{self.partials[by]},...{self.arguments[by]}->...{self.output}"

    def cotangent(self, by: str) -> str:
        """Returns the ``einsum`` subscripts of partial derivatives by an argument times the
        cotangent of the value."""
        return f"...{self.partials[by]},...{self.output}->...{self.arguments[by]}"

    def value(self, *given: Any) -> Floats:
        """Computes the value for each element of the batch."""
        return self._each(given, ())[0]

    def with_partials(self, by: Sequence[str], *given: Any) -> tuple[Floats, ...]:
        """Computes the value and its partial derivatives by some of the arguments."""
        return tuple(self._each(given, by))

    def _each(self, given: Sequence[Any], by: Sequence[str]) -> list[Floats]:
        arrays = [np.asarray(array) for array in given]
        shapes = [array.shape for array in arrays]
        batch, _ = self.sizes(shapes)
        found = [np.empty(self.output_shape(shapes)), *(np.empty(self.partial_shape(name, shapes)) for name in by)]
        own = [array.shape[array.ndim - len(letters) :] for array, letters in zip(arrays, self.arguments.values())]
        each = [np.broadcast_to(array, batch + shape) for array, shape in zip(arrays, own)]
        if self._batched is not None and batch and all(array.size for array in each):
            given = [np.ascontiguousarray(array, np.float64).reshape(-1, *shape) for array, shape in zip(each, own)]
            together = self._batched(by, *given)
            if together is not None:
                return [part.reshape(place.shape) for part, place in zip(together, found)]
        # One by one, also to find the element that is not valid.
        for index in np.ndindex(batch):
            one = [array[index] for array in each]
            try:
                if by:
                    value, partials = self._partials(*one)
                    parts = [value, *(partials[name]() for name in by)]
                else:
                    parts = [self._value(*one)]
            except PolhodeError as error:
                if not batch:
                    raise
                raise PolhodeError(f"of the batch, [{', '.join(map(str, index))}]: {error.message}", error.hint) from None
            for array, part in zip(found, parts):
                array[index] = part
        return found


def no_second_derivatives(name: str) -> PolhodeError:
    """Returns the error for a request for second derivatives."""
    hint = "for an optimizer that needs a Hessian, use J^T J of the residuals (Gauss-Newton) or finite differences of gradients"
    return PolhodeError(f"{name} has only first derivatives: second derivatives are not available (they are not zero)", hint)


def half_turn(quaternion: Floats) -> Floats:
    """Returns E (…, 4, 3) for quaternions q (…, 4), with q ⊗ (0, θ) = E θ: a small rotation θ in
    body axes changes q by E θ/2."""
    w, x, y, z = np.moveaxis(quaternion, -1, 0)
    return np.stack([np.stack(row, -1) for row in ([-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w])], -2)


def _states(motion: FreeMotion, times: Floats) -> Floats:
    omega, attitude = motion.at(times)
    return np.hstack([attitude, omega])


def _motion(inertia: Floats, attitude: Floats, omega: Floats) -> FreeMotion:
    # Both are checked here because elsewhere a matrix (3, 3) is also accepted as an attitude, and
    # three moments as a tensor.
    return FreeMotion(inertia=_arrays.numbers("inertia", inertia, (3, 3)), attitude=_rotation.quaternions("attitude", attitude, (4,)), omega=omega)


def _motion_partials(
    inertia: Floats, attitude: Floats, omega: Floats, times: Floats
) -> tuple[Floats, Mapping[str, Callable[[], Floats]]]:
    motion = _motion(inertia, attitude, omega)
    found = motion.derivatives(times)
    value = np.hstack([found.attitude, found.omega])
    start = np.asarray(attitude, np.float64), np.asarray(inertia, np.float64)
    return value, _partials_of(*start, value, found.by_start, found.by_inertia)


def _motions(by: Sequence[str], inertia: Floats, attitude: Floats, omega: Floats, times: Floats) -> list[Floats] | None:
    """Computes free motions of a batch (b) in one call; ``None`` if one of them is not valid."""
    tensors = _arrays.symmetric("inertia", inertia)
    found = _native.free_motions(tensors.reshape(-1, 9), attitude, omega, times, bool(set(by) - {"times"}))
    if found is None:
        return None
    value, derivatives = found
    partials = _partials_of(attitude, tensors, value, *derivatives)
    return [value, *(partials[name]() for name in by)]


def _partials_of(
    attitude: Floats, inertia: Floats, value: Floats, by_start: Floats, by_inertia: Floats
) -> Mapping[str, Callable[[], Floats]]:
    """Returns the partial derivatives of states (…, n, 7) from those of θ and ω. Leading axes are a
    batch."""
    quaternions, rates = value[..., :4], value[..., 4:]

    def outward() -> Floats:
        # Maps from θ and ω to q and ω.
        maps = np.zeros((*value.shape, 6))
        maps[..., :4, :3] = 0.5 * half_turn(quaternions)
        maps[..., 4:, 3:] = np.eye(3)
        return maps

    def inward() -> Floats:
        # A map from q(0) to θ(0). A change of the length of q(0) does not change θ(0).
        size = np.linalg.norm(attitude, axis=-1)[..., None]
        return np.asarray((2.0 * half_turn(attitude / size) / size[..., None]).swapaxes(-1, -2)[..., None, :, :])

    def by_times() -> Floats:
        # The equations of motion: θ̇ = ω and I ω̇ = I ω × ω.
        torque = np.cross(np.einsum("...ij,...nj->...ni", inertia, rates), rates)
        acceleration = np.linalg.solve(inertia[..., None, :, :], torque[..., None])[..., 0]
        return np.asarray(np.einsum("...os,...s->...o", outward(), np.concatenate([rates, acceleration], axis=-1)))

    return {
        "inertia": lambda: (outward() @ by_inertia)[..., _ELEMENTS] * _SHARES,
        "attitude": lambda: (outward() @ by_start[..., :3]) @ inward(),
        "omega": lambda: outward() @ by_start[..., 3:],
        "times": by_times,
    }


def _particle_partials(masses: Floats, positions: Floats) -> tuple[Floats, Mapping[str, Callable[[], Floats]]]:
    found = particle_derivatives(masses=masses, positions=positions)
    return found.values, {"masses": lambda: found.by_masses, "positions": lambda: found.by_positions}


def _mesh_partials(
    vertices: Floats, triangles: npt.NDArray[Any], density: Floats
) -> tuple[Floats, Mapping[str, Callable[[], Floats]]]:
    found = mesh_derivatives((vertices, triangles), density=_arrays.positive("density", density))
    return found.values, {"vertices": lambda: found.by_vertices, "density": lambda: found.by_density}


def _parts(masses: Floats, centers_of_mass: Floats, inertias: Floats) -> list[MassProperties]:
    if not len(masses):
        raise PolhodeError("masses is empty: a body has at least one part")
    parts = []
    for k, (mass, center, inertia) in enumerate(zip(masses, centers_of_mass, inertias)):
        given = (
            _arrays.positive(f"masses[{k}]", mass),
            _arrays.numbers(f"centers_of_mass[{k}]", center, (3,)),
            _arrays.numbers(f"inertias[{k}]", inertia, (3, 3)),
        )
        try:
            parts.append(MassProperties(mass=given[0], center_of_mass=given[1], inertia=given[2]))
        except PolhodeError as error:
            raise PolhodeError(f"part {k}: {error.message}", error.hint) from None
    return parts


def _body_partials(
    masses: Floats, centers_of_mass: Floats, inertias: Floats
) -> tuple[Floats, Mapping[str, Callable[[], Floats]]]:
    parts = {str(k): part for k, part in enumerate(_parts(masses, centers_of_mass, inertias))}
    found = body_derivatives(parts, joined(list(parts.values())), {})
    return found.values, {
        "masses": lambda: found.by_parts[..., 0],
        "centers_of_mass": lambda: found.by_parts[..., 1:4],
        "inertias": lambda: found.by_parts[..., 4:][..., _ELEMENTS] * _SHARES,
    }


#: Free motion: rows (n, 7) of w, x, y, z and ω.
FREE_MOTION = Function(
    name="free_motion",
    arguments={"inertia": "ij", "attitude": "q", "omega": "i", "times": "n"},
    output="no",
    lengths={"o": 7},
    partials={"inertia": "noij", "attitude": "noq", "omega": "noi", "times": "no"},
    _value=lambda inertia, attitude, omega, times: _states(_motion(inertia, attitude, omega), times),
    _partials=_motion_partials,
    _batched=_motions,
)

#: Mass properties of particles, as ten numbers.
PARTICLES = Function(
    name="particles",
    arguments={"masses": "n", "positions": "ni"},
    output="o",
    lengths={"o": 10},
    partials={"masses": "on", "positions": "oni"},
    _value=lambda masses, positions: ten(particles(masses=masses, positions=positions)),
    _partials=_particle_partials,
)

#: Mass properties of a mesh, as ten numbers.
MESH = Function(
    name="mesh",
    arguments={"vertices": "ni", "triangles": "mk", "density": ""},
    output="o",
    lengths={"o": 10},
    partials={"vertices": "oni", "density": "o"},
    _value=lambda vertices, triangles, density: _mesh_partials(vertices, triangles, density)[0],
    _partials=_mesh_partials,
)

#: Mass properties of a body of parts, as ten numbers.
BODY = Function(
    name="body",
    arguments={"masses": "p", "centers_of_mass": "pi", "inertias": "pij"},
    output="o",
    lengths={"o": 10},
    partials={"masses": "op", "centers_of_mass": "opi", "inertias": "opij"},
    _value=lambda masses, centers_of_mass, inertias: ten(joined(_parts(masses, centers_of_mass, inertias))),
    _partials=_body_partials,
)
