"""Conversion of arguments to arrays that the library takes: contiguous, aligned float64 of a known
shape, finite.

An array that already has this form is not copied. Values that are exact in float64 are converted:
integers up to 2**53, float16 and float32, either byte order, any strides, lists of lists. All other
values are refused. The message names the argument, the element and the rule.
"""

from __future__ import annotations

import math
import os
from typing import Any, Iterable, Sequence

import numpy as np
import numpy.typing as npt

from . import _native, _units
from ._error import PolhodeError, warn

Floats = npt.NDArray[np.float64]

#: Greatest integer up to which all integers are exact in float64.
EXACT = 2**53

#: Data type that needs no conversion.
FLOAT64 = np.dtype(np.float64)

#: Data type of NumPy's indices.
INT64 = np.dtype(np.int64)

#: Rule for values that are not exact in float64, for messages.
INEXACT = "a float64 exactly: give a float, or an integer up to 2**53"


def numbers(name: str, value: object, shape: tuple[int | str, ...]) -> Floats:
    """Converts an argument to an array of numbers.

    In ``shape``, a number is a required length and a letter is any length.

    >>> numbers("omega", [[1, 2, 3]], ("n", 3))
    array([[1., 2., 3.]])
    >>> numbers("omega", [1.0, float("nan"), 0.0], (3,))
    Traceback (most recent call last):
    polhode.PolhodeError: omega[1] = nan must be finite
    """
    if len(shape) == 1 and isinstance(value, (list, tuple)) and all(type(x) is float and math.isfinite(x) for x in value):
        array = np.array(value)
    else:
        array = real(name, value, "real numbers" if shape else "a real number")
    if len(array.shape) != len(shape) or any(
        isinstance(wanted, int) and found != wanted for found, wanted in zip(array.shape, shape)
    ):
        raise PolhodeError(f"{name} must {_having(shape)}, not {array.shape}")
    is_finite = np.isfinite(array)
    if not is_finite.all():
        refuse(name, array, ~is_finite, "finite")
    return array


def _having(shape: tuple[int | str, ...]) -> str:
    return f"have the shape ({', '.join(map(str, shape))}{',' if len(shape) == 1 else ''})" if shape else "be one number, of shape ()"


def real(name: str, value: object, what: str = "real numbers") -> Floats:
    """Converts real numbers to float64, exactly."""
    if type(value) is np.ndarray and value.dtype is FLOAT64 and value.flags.carray:
        return value
    array = _array(name, value, what)
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "f" and size <= 8 or kind in "iu":
        if kind in "iu" and size == 8:
            refuse(name, array, (array > EXACT) | (array < -EXACT if kind == "i" else False), INEXACT)
        return np.require(array, np.float64, ["C", "A"]).reshape(array.shape)
    if kind == "O":
        _look(name, array.flat, ())
    dimension = _units.dimension_of(name) if kind == "U" else None
    unit = "" if dimension in (None, _units.NUMBER) else f" without a unit, such as {dimension.unit}"
    raise TypeError(f"{name} must be {what}, not {described(array, 'float')}{unit}")


def _array(name: str, value: object, what: str, rule: str = INEXACT) -> npt.NDArray[Any]:
    """Converts a value to an array of any type, without rounding or dropping anything."""
    value = _in_si(name, value)
    # A table may have a column that is named ``unit``.
    if not hasattr(value, "iloc") and any(getattr(value, word, None) is not None for word in ("unit", "units")):
        raise TypeError(f"{name} has a unit that is neither Pint's nor Astropy's and would be lost: give plain numbers in SI units")
    refuse_masked(name, value)
    if isinstance(value, (list, tuple)):
        _look(name, value, (), rule)
    try:
        return np.asarray(value)
    except (TypeError, OverflowError) as error:
        raise TypeError(f"{name} must be {what} ({error})") from None
    except ValueError as error:
        raise PolhodeError(f"{name} must have rows of one length ({error})") from None


def refuse_masked(name: str, value: object) -> None:
    """Refuses masked elements of NumPy and Astropy, because the mask would be lost."""
    mask = getattr(value, "mask", False)
    if mask is not False and not callable(mask) and np.any(mask):
        raise PolhodeError(f"{name} has masked elements: fill them in, or delete their rows")


def _look(name: str, value: Iterable[Any], place: tuple[int, ...], rule: str = INEXACT) -> None:
    """Refuses elements of lists that NumPy would convert silently: truth values, integers that it
    rounds, quantities that lose their unit."""
    if isinstance(value, (list, tuple)) and set(map(type, value)) <= {float, np.float64}:
        return
    for k, element in enumerate(value):
        index = (*place, k)
        here = f"{name}[{', '.join(map(str, index))}]" if not isinstance(value, np.flatiter) else name
        if isinstance(element, (list, tuple)):
            _look(name, element, index, rule)
        elif isinstance(element, np.ndarray) or hasattr(element, "unit") or hasattr(element, "units"):
            real(here, element)
        elif isinstance(element, (bool, np.bool_)):
            raise TypeError(f"{here} = {element} must be a number, not a truth value")
        elif isinstance(element, (int, np.integer)) and not -EXACT <= element <= EXACT:
            raise PolhodeError(f"{here} = {shown(element)} must be {rule}")


def _in_si(name: str, value: Any) -> Any:
    """Converts a quantity to numbers in the SI unit of the argument; returns values without a unit
    unchanged.

    >>> _in_si("omega", [1.0, 2.0, 3.0])
    [1.0, 2.0, 3.0]
    >>> _in_si("radius", "25.4 mm"), _in_si("position", [0, "-2 cm", "1 in"])
    (0.0254, [0, -0.02, 0.0254])
    """
    if type(value).__module__.startswith("xarray") and _units.has_units(value.data):
        value = value.data
    has_units = _units.has_units(value)
    if not has_units and not _units.has_text(value):
        return value
    dimension = _units.dimension_of(name)
    if not has_units and dimension in (None, _units.NUMBER):
        return value  # text, which the caller refuses
    if dimension is None:
        raise TypeError(f"{name} has a unit, but it is not one physical quantity: give plain numbers")
    return _numbers(name, value, dimension)


def as_text(name: str, value: Any) -> Any:
    """Converts a quantity to texts of a number and its SI unit, for the reader to check.

    Lists and arrays become lists of texts. Values without a unit are returned unchanged.
    """
    if isinstance(value, (list, tuple)):
        return type(value)(as_text(f"{name}[{k}]", element) for k, element in enumerate(value)) if _units.has_units(value) else value
    if _units.library_of(value) is None:
        return value
    magnitude, powers = _si(name, value)
    unit = " ".join(symbol if power == 1 else f"{symbol}^{power}" for symbol, power in powers.items())

    def texts(number: Any) -> Any:
        return [*map(texts, number)] if isinstance(number, list) else f"{number!r} {unit}" if unit else number

    return texts(np.asarray(magnitude).tolist())


def _numbers(name: str, value: Any, dimension: _units.Dimension) -> Any:
    if isinstance(value, (list, tuple)):
        return [_numbers(f"{name}[{k}]", element, dimension) for k, element in enumerate(_with_units(name, value))]
    if isinstance(value, str):
        number = _units.number_of(name, value, dimension)
        return value if number is None else number
    if _units.library_of(value) is None:
        return value
    magnitude, powers = _si(name, value)
    found = {symbol: power for symbol, power in powers.items() if symbol != "rad"}
    if found != {symbol: power for symbol, power in zip(("kg", "m", "s"), dimension.powers) if power}:
        said = " ".join(symbol if power == 1 else f"{symbol}^{power}" for symbol, power in powers.items())
        given = str(value.unit if _units.library_of(value) == "astropy" else value.units) or "no unit"
        raise PolhodeError(f"{name} is in {given}, {said or 'a plain number'} in SI, where {dimension.words} belongs", f"give {dimension.unit}")
    if dimension is _units.NUMBER and powers:
        raise PolhodeError(f"{name} is an angle, where {dimension.words} belongs")
    return magnitude


def _with_units(name: str, value: Sequence[Any]) -> Sequence[Any]:
    """Refuses a number without a unit next to quantities, unless it is 0."""
    for k, element in enumerate(value):
        if not (_units.has_units(element) or _units.has_text(element)) and np.any(np.asarray(element, dtype=object)):
            raise PolhodeError(f"{name}[{k}] has no unit, but other elements have one: give all of them a unit, or none")
    return value


def _si(name: str, value: Any) -> tuple[Any, dict[str, int]]:
    """Returns the numbers of a quantity in SI, and the powers of its base units."""
    refuse_masked(name, value)
    number, factor, bases = _units.taken_apart(name, value)
    # The rules for numbers do not depend on units. The product is computed in float64 whatever the
    # type was, so that the factor keeps all its bits.
    return real(name, number) * factor, bases


def kind_of(value: object) -> str:
    """Returns the type of a value, for a message."""
    return f"an array of {value.dtype}" if isinstance(value, np.ndarray) else type(value).__name__


def shown(number: Any) -> str:
    """Returns a number as text; for an integer of hundreds of digits, the count of its digits."""
    if isinstance(number, int) and number.bit_length() > 128:
        return f"an integer of about {round(0.30103 * number.bit_length())} digits"
    return str(number)


def described(array: npt.NDArray[Any], wanted: str) -> str:
    """Returns a description of the elements of an array that are not numbers."""
    if array.dtype.kind == "O":
        odd = [type(element).__name__ for element in array.flat if not isinstance(element, (int, float, np.number))]
        if not array.ndim and odd:
            return odd[0]
        return f"{odd[0]} among others (dtype object)" if odd else f"objects (dtype object): convert them, as by .astype({wanted})"
    if array.dtype.kind == "f":
        return f"{array.dtype}, which has more digits than float64"
    return {"c": "complex numbers", "U": "text", "S": "bytes", "b": "truth values"}.get(array.dtype.kind, str(array.dtype))


def refuse(name: str, array: npt.NDArray[Any], wrong: npt.NDArray[np.bool_], rule: str) -> None:
    """Refuses the first element that ``wrong`` marks."""
    if wrong.any():
        index = tuple(int(k) for k in np.argwhere(wrong)[0])
        place = f"[{', '.join(map(str, index))}]" if index else ""
        raise PolhodeError(f"{name}{place} = {array[index]} must be {rule}")


def triple(name: str, value: object) -> list[float]:
    """Converts a vector to a list of three numbers."""
    return few(value, 3) or numbers(name, value, (3,)).tolist()


def few(value: Any, count: int) -> list[float] | None:
    """Returns the numbers of a short list, tuple or array as a list if they are certainly valid,
    otherwise ``None``: the caller then checks them in full."""
    if type(value) is np.ndarray and value.dtype is FLOAT64 and value.shape == (count,):
        value = value.tolist()
    if (type(value) is list or type(value) is tuple) and len(value) == count:
        for number in value:
            if type(number) is not float and type(number) is not int or not -EXACT <= number <= EXACT:  # false for NaN
                return None
        return [*map(float, value)]
    return None


#: Largest asymmetry of a tensor, relative to its greatest moment, that rounding to float64
#: explains; and that rounding to float32 explains.
_ROUNDING, _SINGLE = 1e-12, 1e-6


def symmetric(name: str, tensors: Floats) -> Floats:
    """Symmetrises tensors (…, 3, 3) whose halves differ by no more than float32 rounding, with a
    warning. Larger asymmetry is kept, and the library refuses it."""
    mirrored = tensors.swapaxes(-1, -2)
    size = np.abs(tensors[..., [0, 1, 2], [0, 1, 2]]).max(axis=-1, initial=0.0)
    apart = np.abs(tensors - mirrored).max(axis=(-1, -2), initial=0.0)
    rounded = (apart > _ROUNDING * size) & (apart <= _SINGLE * size)
    if not rounded.any():
        return tensors
    most = (apart[rounded] / size[rounded]).max()
    warn(f"{name} is not symmetric: its halves differ by {most:.2g} of the greatest moment (float32 rounding); their mean is used")
    return np.where(rounded[..., None, None], 0.5 * tensors + 0.5 * mirrored, tensors)


def tensor(name: str, value: object) -> list[list[float]]:
    """Converts an inertia tensor (3, 3), or three moments about the body's own axes, to rows."""
    if (moments := few(value, 3)) is not None:
        a, b, c = moments
        return [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]
    if type(value) is np.ndarray and value.dtype is FLOAT64 and value.shape == (3, 3):
        plain: list[list[float]] = value.tolist()
        (_, xy, xz), (yx, _, yz), (zx, zy, _) = plain
        if math.isfinite(sum(map(sum, plain))) and (xy, xz, yz) == (yx, zx, zy):
            return plain
    given = real(name, value)
    if given.shape not in ((3, 3), (3,)):
        raise PolhodeError(f"{name} must have the shape (3, 3), or (3,) for moments about the body's axes, not {given.shape}")
    array = numbers(name, given, given.shape)
    rows: list[list[float]] = (np.diag(array) if array.ndim == 1 else symmetric(name, array)).tolist()
    return rows


def number(name: str, value: object) -> float:
    """Converts a value to a number."""
    if type(value) is float and math.isfinite(value):
        return value
    return float(numbers(name, value, ()))


def positive(name: str, value: object) -> float:
    """Converts a value to a positive number."""
    found = number(name, value)
    if not found > 0.0:
        raise PolhodeError(f"{name} = {found} must be positive")
    return found


def indices(name: str, value: object, shape: tuple[int | str, ...], below: int) -> npt.NDArray[np.uint32]:
    """Converts whole numbers from 0 to ``below`` − 1."""
    if type(value) is np.ndarray and value.dtype is INT64 and value.flags.c_contiguous and value.size:
        # As unsigned numbers, negative ones are above all others.
        if value.ndim == len(shape) and value.shape[-1] == shape[-1] and value.view(np.uint64).max() < below:
            return value.astype(np.uint32)
    rule = f"from 0 to {below - 1}"
    array = _array(name, value, "whole numbers", rule)
    if array.size and array.dtype.kind not in "iu":
        if array.dtype.kind == "O":
            _look(name, array.flat, (), rule)
        raise TypeError(f"{name} must be whole numbers, not {described(array, 'int') if array.dtype.kind != 'f' else array.dtype}")
    if array.ndim != len(shape) or array.shape[-1] != shape[-1]:
        raise PolhodeError(f"{name} must {_having(shape)}, not {array.shape}")
    refuse(name, array, (array < 0) | (array >= below), rule)
    return np.require(array, np.uint32, ["C", "A"])


def mesh(vertices: object, triangles: object) -> tuple[Floats, npt.NDArray[np.uint32]]:
    """Converts vertices (n, 3), and the indices (m, 3) of the three vertices of each triangle."""
    points = numbers("vertices", vertices, ("n", 3))
    if not len(points):
        raise PolhodeError("vertices has no rows")
    return points, indices("triangles", triangles, ("m", 3), len(points))


def count(name: str, value: object, least: int = 1) -> int:
    """Converts a whole number of at least ``least``."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer, float, np.floating)):
        raise TypeError(f"{name} must be a whole number, not {type(value).__name__}")
    if isinstance(value, (float, np.floating)) or not least <= value <= EXACT:
        raise PolhodeError(f"{name} = {shown(value)} must be a whole number from {least} to 2**53")
    return int(value)


def truth(name: str, value: object) -> bool:
    """Converts True or False. Text such as ``"no"`` is refused."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} must be True or False, not {type(value).__name__}")
    return bool(value)


def text(name: str, value: object) -> str:
    """Checks that a value is text."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be text, not {type(value).__name__}")
    try:
        value.encode()
    except UnicodeEncodeError as error:
        raise PolhodeError(f"{name} has half a character at {error.start} (a lone surrogate), which is not valid text") from None
    return value


def choice(name: str, value: object, known: Sequence[str]) -> str:
    """Checks that a value is one of the known words."""
    if text(name, value) not in known:
        raise PolhodeError(f"{name} = {value!r} must be one of {', '.join(known)}")
    return str(value)


def path(name: str, value: object) -> str:
    """Converts a path of a file or a folder to text."""
    found = os.fspath(value) if isinstance(value, (str, os.PathLike)) else None
    if not isinstance(found, str):
        raise TypeError(f"{name} must be a path, as a str or a pathlib.Path, not {type(value).__name__}")
    if not found or "\0" in found:
        raise PolhodeError(f"{name} = {found!r} must be a path")
    return found
