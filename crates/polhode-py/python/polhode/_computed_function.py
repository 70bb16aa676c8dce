"""Torques and event measures that are Python functions: for one body, or for many at once."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._arrays import Floats
from ._error import PolhodeError
from ._traced_function import asked, called_with

#: Largest difference between the torque of a member alone and among others, relative to the
#: greatest torque. Sums of different lengths round differently.
ALONE = 1e-9


def computed(function: Any) -> Callable[..., tuple[float, ...]]:
    """Returns the function of a torque as one of plain numbers: time, ω, attitude quaternion and L, body
    axes."""
    needed = asked(function)

    def of(t: float, omega: list[float], quaternion: list[float], momentum: list[float]) -> tuple[float, ...]:
        state = State(t, np.array(omega), np.array(quaternion), np.array(momentum), 0)
        torque = _arrays.real("the torque of a function", called_with(function, {name: getattr(state, name) for name in needed}))
        if torque.shape != (3,):
            raise PolhodeError(f"the function must return three components, of shape (3,), not {torque.shape}")
        return tuple(torque.tolist())

    return of


def measured(function: Any) -> Callable[..., float]:
    """Returns the function of an event as one of plain numbers: time, ω, attitude quaternion and L,
    body axes."""
    needed = asked(function)

    def of(t: float, omega: list[float], quaternion: list[float], momentum: list[float]) -> float:
        state = State(t, np.array(omega), np.array(quaternion), np.array(momentum), 0)
        value = called_with(function, {name: getattr(state, name) for name in needed})
        return _arrays.number(f"what an event measures at t = {t} s", value)

    return of


def needs_momentum(function: Any) -> bool:
    """Returns true if a function takes L, which depends on the body."""
    return any(name.startswith("momentum") for name in asked(function))


def computed_of_many(function: Any) -> Callable[..., Floats]:
    """Returns a vectorised function as one of times (n,), ω (n, 3), quaternions (n, 4), L (n, 3)
    and members (n,), body axes."""
    needed = asked(function, vectorized=True)

    def rows(state: State) -> Floats:
        torque = _arrays.real("the torque of a function", called_with(function, {name: getattr(state, name) for name in needed}))
        if torque.shape != (len(state.t), 3):
            rule = f"a vectorised function must return a row for each member, of shape ({len(state.t)}, 3)"
            raise PolhodeError(f"{rule}, not {torque.shape}")
        return torque

    is_known = False

    def of(*given: Any) -> Floats:
        nonlocal is_known
        state = State(*given)
        # A function may modify the arrays that it receives.
        last = None if is_known or len(state.t) < 2 else State(*(array[-1:].copy() for array in given))
        found = rows(state)
        if last is not None:
            # A function written for one body may take a row for a component, and still return the right
            # shape.
            alone = rows(last)
            if np.isfinite(found).all() and not np.abs(alone - found[-1:]).max() <= ALONE * np.abs(found).max():
                rule = "the torque of a member must not depend on other members"
                raise PolhodeError(f"the torque of member {state.member[-1]} is {alone[0]} alone and {found[-1]} among others: {rule}")
            is_known = True
        return found

    return of


def computed_of_one(function: Any) -> Callable[..., tuple[float, ...]]:
    """Returns a vectorised function as one for a single body."""
    many = computed_of_many(function)

    def of(t: float, omega: list[float], quaternion: list[float], momentum: list[float]) -> tuple[float, ...]:
        alone = (np.array([t]), np.array([omega]), np.array([quaternion]), np.array([momentum]), np.array([0]))
        return tuple(many(*alone)[0].tolist())

    return of


class State(NamedTuple):
    """State of one body, or rows of states of many, by the names of the parameters of functions."""

    t: Any
    omega: Floats
    quaternion: Floats
    momentum: Floats
    member: Any

    @property
    def attitude(self) -> Turned:
        return Turned(self.quaternion)

    @property
    def omega_space(self) -> Floats:
        return self.attitude.apply(self.omega)

    @property
    def momentum_space(self) -> Floats:
        return self.attitude.apply(self.momentum)


class Turned:
    """Attitude of one body, or rows of attitudes of many.

    It takes body components to space components.
    """

    def __init__(self, quaternion: Floats) -> None:
        self._quaternion = quaternion

    def as_quat(self, *, scalar_first: bool = False) -> Floats:
        """Returns the quaternion (…, 4): x, y, z, w as in SciPy, or w first."""
        return self._quaternion.copy() if scalar_first else np.roll(self._quaternion, -1, axis=-1)

    def as_matrix(self) -> Floats:
        """Returns the rotation matrix R_space_body (…, 3, 3)."""
        w, x, y, z = np.moveaxis(self._quaternion, -1, 0)
        # R = (w² − q²) 1 + 2 q qᵀ + 2 w [q]×
        rows = (
            (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        )
        return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)

    def apply(self, vector: npt.ArrayLike, inverse: bool = False) -> Floats:
        """Returns the space components of a vector (3,) in body components, or of one for each body
        (n, 3); with ``inverse``, the reverse."""
        matrix = self.as_matrix()
        if inverse:
            matrix = np.swapaxes(matrix, -1, -2)
        if matrix.ndim == 2:
            one: Floats = matrix @ np.asarray(vector)
            return one
        given = np.asarray(vector)
        if given.shape not in ((3,), (len(matrix), 3)):
            raise PolhodeError(f"a vector must have the shape (3,), or ({len(matrix)}, 3) with a row for each member, not {given.shape}")
        many: Floats = (matrix @ given[..., None])[..., 0]
        return many
