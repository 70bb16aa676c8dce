"""What users give, as arrays that the library takes: contiguous, aligned float64, of a known shape, finite.

An array that is so already is not copied. Everything that has an exact float64 is converted: integers up to 2**53, float16 and float32,
either byte order, any strides, lists of lists. Everything else is refused, with the name of the argument, the element and the rule.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._error import PolhodeError

Floats = npt.NDArray[np.float64]

#: Integers beyond it are not all float64.
EXACT = 2**53


def numbers(name: str, value: object, shape: tuple[int | str, ...]) -> Floats:
    """The numbers of an argument; ``shape`` has a number where a length is given, and a letter where it is free.

    >>> numbers("omega", [[1, 2, 3]], ("n", 3))
    array([[1., 2., 3.]])
    >>> numbers("omega", [1.0, float("nan"), 0.0], (3,))
    Traceback (most recent call last):
    polhode.PolhodeError: omega[1] = nan must be finite
    """
    array = real(name, value)
    if len(array.shape) != len(shape) or any(
        isinstance(wanted, int) and found != wanted for found, wanted in zip(array.shape, shape)
    ):
        wanted = "(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")"
        raise PolhodeError(f"{name} must have the shape {wanted}, not {array.shape}")
    refuse(name, array, ~np.isfinite(array), "finite")
    return array


def real(name: str, value: object) -> Floats:
    """Any real numbers as float64, exactly."""
    for word in ("unit", "units"):
        if hasattr(value, word):
            raise TypeError(f"{name} has a unit of its own, which would be lost: give plain numbers in SI units")
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise PolhodeError(f"{name} has masked elements: give all of them, or leave their rows out")
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise PolhodeError(f"{name} must have rows of one length ({error})") from None
    kind, size = array.dtype.kind, array.dtype.itemsize
    if array.size == 0 and kind == "f" or kind == "f" and size <= 8 or kind in "iu":
        if kind in "iu" and size == 8:
            refuse(name, array, (array > EXACT) | (array < -EXACT if kind == "i" else False), "a float64 exactly")
        return np.require(array, np.float64, ["C", "A"]).reshape(array.shape)
    raise TypeError(f"{name} must be real numbers, not {described(array)}")


def described(array: npt.NDArray[Any]) -> str:
    """What an array holds instead of numbers."""
    if array.dtype.kind == "O":
        odd = (element for element in array.flat if not isinstance(element, (int, float)))
        return f"{type(next(odd, None)).__name__} among others (dtype object)"
    if array.dtype.kind == "f":
        return f"{array.dtype}, which has more digits than float64"
    return {"c": "complex numbers", "U": "text", "S": "bytes", "b": "truth values"}.get(array.dtype.kind, str(array.dtype))


def refuse(name: str, array: npt.NDArray[Any], wrong: npt.NDArray[np.bool_], rule: str) -> None:
    """Refuses the first element that is wrong."""
    if wrong.any():
        index = tuple(int(k) for k in np.argwhere(wrong)[0])
        place = f"[{', '.join(map(str, index))}]" if index else ""
        raise PolhodeError(f"{name}{place} = {array[index]} must be {rule}")


def quaternions(name: str, value: object, shape: tuple[int | str, ...]) -> Floats:
    """Rotations as quaternions, scalar first; a ``scipy.spatial.transform.Rotation``, which is scalar-last, is turned round."""
    if hasattr(value, "as_quat"):
        # Before SciPy 1.14 there is no scalar_first: the last goes first by hand.
        value = np.asarray(value.as_quat())[..., [3, 0, 1, 2]]
    array = numbers(name, value, shape)
    refuse(name, array, np.broadcast_to(~array.any(axis=-1, keepdims=True), array.shape), "part of a quaternion that is not zero")
    return array


def triple(name: str, value: object) -> list[float]:
    """A vector as a list."""
    found: list[float] = numbers(name, value, (3,)).tolist()
    return found


def tensor(name: str, value: object) -> list[list[float]]:
    """An inertia tensor: (3, 3), or three moments about the body's own axes."""
    given = real(name, value)
    array = numbers(name, given, (3,)) if given.shape == (3,) else numbers(name, given, (3, 3))
    rows: list[list[float]] = (np.diag(array) if array.ndim == 1 else array).tolist()
    return rows


def number(name: str, value: object) -> float:
    """One number."""
    return float(numbers(name, value, ()))


def positive(name: str, value: object) -> float:
    """One number above zero."""
    found = number(name, value)
    if not found > 0.0:
        raise PolhodeError(f"{name} = {found} must be positive")
    return found


def indices(name: str, value: object, shape: tuple[int | str, ...], below: int) -> npt.NDArray[np.uint32]:
    """Whole numbers from 0 up to ``below``."""
    array = np.asarray(value)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be whole numbers, not {described(array) if array.dtype.kind != 'f' else array.dtype}")
    if array.ndim != len(shape) or array.shape[-1] != shape[-1]:
        raise PolhodeError(f"{name} must have the shape ({', '.join(map(str, shape))}), not {array.shape}")
    refuse(name, array, (array < 0) | (array >= below), f"from 0 to {below - 1}")
    return np.require(array, np.uint32, ["C", "A"])
