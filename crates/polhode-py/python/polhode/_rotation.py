"""Conversion of arguments that are rotations to quaternions, scalar first."""

from __future__ import annotations

import re
from typing import Any, Mapping

import numpy as np

from . import _arrays, _native
from ._arrays import Floats
from ._error import PolhodeError
from ._toml import pair


def rotations(name: str, value: Any) -> Floats:
    """Converts rotations to an array: quaternions (…, 4), scalar first, or matrices (…, 3, 3).

    A ``scipy.spatial.transform.Rotation``, which is scalar last, is reordered. A mapping is a
    single rotation in a form of scenario files, such as ``{"axis": [0, 0, 1], "angle": "30 deg"}``.
    """
    if hasattr(value, "as_quat"):
        # SciPy before 1.14 has no ``scalar_first``: reorder the components here.
        return np.ascontiguousarray(np.asarray(value.as_quat())[..., [3, 0, 1, 2]])
    if isinstance(value, Mapping):
        return np.array(_of_form(name, value))
    return _arrays.real(name, value)


def _of_form(name: str, form: Mapping[str, Any]) -> list[float]:
    """Returns the quaternion of a rotation in a form of scenario files."""
    try:
        return _native.quaternion_of_text(name, pair(name, "rotation", form))
    except PolhodeError as error:
        message = re.sub(rf"^{re.escape(name)}:\d+:\d+: ", "", error.args[0])
        raise PolhodeError(f"{name}: {message}", error.args[1]) from None


def quaternions(name: str, value: Any, shape: tuple[int | str, ...]) -> Floats:
    """Converts :func:`rotations` to quaternions of a shape, scalar first."""
    given = rotations(name, value)
    if given.ndim == len(shape) + 1 and given.shape[-2:] == (3, 3):
        matrices = _arrays.numbers(name, given, (*shape[:-1], 3, 3))
        return _native.quaternions_of_matrices(name, matrices.reshape(-1, 9)).reshape(*matrices.shape[:-2], 4)
    array = _arrays.numbers(name, given, shape)
    _arrays.refuse(name, array, np.broadcast_to(~array.any(axis=-1, keepdims=True), array.shape), "part of a quaternion that is not zero")
    return array


def quaternion(name: str, value: object) -> list[float]:
    """Converts a rotation to the list of its quaternion."""
    if (plain := _arrays.few(value, 4)) is not None and any(plain):
        return plain
    found: list[float] = quaternions(name, value, (4,)).tolist()
    return found
