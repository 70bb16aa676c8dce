"""Torques that are Python functions, traced with symbols to obtain formulas."""

from __future__ import annotations

import inspect
import math
from functools import reduce
from typing import Any, Callable, NoReturn

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._arrays import Floats
from ._error import PolhodeError

#: Precedence levels of expressions: lowest for a choice and a comparison, highest for a name.
_COMPARISON, _SUM, _PRODUCT, _SIGN, _POWER, _NAME = range(6)

#: Maximum length of a formula in characters, as in the reader.
LONGEST = 65536


class Symbol:
    """A symbolic expression. Operators and NumPy functions of it return other expressions."""

    __slots__ = ("text", "_holds")

    def __init__(self, text: str, holds: int = _NAME) -> None:
        if len(text) > LONGEST:
            rule = f"at most {LONGEST} characters: an expression that is used several times is repeated in the formula"
            raise PolhodeError(f"the formula of this function is too long, which must have {rule}")
        self.text = text
        self._holds = holds

    def _as(self, holds: int) -> str:
        """Returns the text, in parentheses if its precedence is lower than ``holds``."""
        return self.text if self._holds >= holds else f"({self.text})"

    def _join(self, other: object, sign: str, holds: int, *, turned: bool = False) -> Any:
        one = _symbol(other)
        if one is None:
            return NotImplemented
        left, right = (one, self) if turned else (self, one)
        simple = _simple(left.text, sign, right.text)
        if simple is not None:
            return (Symbol("0"), left, right, -right)[simple]
        # The operators are left-associative: the right operand needs higher precedence, and
        # parentheses if it has a sign.
        return Symbol(f"{left._as(holds)}{sign}{right._as(_POWER if right._holds == _SIGN else holds + 1)}", holds)

    def __add__(self, other: object) -> Any:
        return self._join(other, "+", _SUM)

    def __radd__(self, other: object) -> Any:
        return self._join(other, "+", _SUM, turned=True)

    def __sub__(self, other: object) -> Any:
        return self._join(other, "-", _SUM)

    def __rsub__(self, other: object) -> Any:
        return self._join(other, "-", _SUM, turned=True)

    def __mul__(self, other: object) -> Any:
        return self._join(other, "*", _PRODUCT)

    def __rmul__(self, other: object) -> Any:
        return self._join(other, "*", _PRODUCT, turned=True)

    def __truediv__(self, other: object) -> Any:
        return self._join(other, "/", _PRODUCT)

    def __rtruediv__(self, other: object) -> Any:
        return self._join(other, "/", _PRODUCT, turned=True)

    def __pow__(self, other: object) -> Any:
        one = _symbol(other)
        # Powers are right-associative and bind tighter than a sign: put each operand in parentheses
        # unless it is a name.
        return NotImplemented if one is None else Symbol(f"{self._as(_NAME)}^{one._as(_NAME)}", _POWER)

    def __rpow__(self, other: object) -> Any:
        one = _symbol(other)
        return NotImplemented if one is None else one**self

    def __neg__(self) -> Symbol:
        return Symbol(f"-{self._as(_POWER)}", _SIGN)

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        return _call("abs", self)

    def __lt__(self, other: object) -> Any:
        return self._join(other, "<", _COMPARISON)

    def __le__(self, other: object) -> Any:
        return self._join(other, "<=", _COMPARISON)

    def __gt__(self, other: object) -> Any:
        return self._join(other, ">", _COMPARISON)

    def __ge__(self, other: object) -> Any:
        return self._join(other, ">=", _COMPARISON)

    def __eq__(self, other: object) -> NoReturn:
        raise TypeError("the function compares a symbol for equality, but its value is unknown when the function is traced: compare with < or >")

    def __ne__(self, other: object) -> NoReturn:
        raise TypeError("the function compares a symbol for equality, but its value is unknown when the function is traced: compare with < or >")

    __hash__ = object.__hash__

    def __bool__(self) -> NoReturn:
        raise TypeError(
            "the function branches on a symbol, whose value is unknown when the function is traced: use polhode.scenario.where(condition, then, otherwise)"
        )

    def __float__(self) -> NoReturn:
        raise TypeError("the function converts a symbol to a number, but its value is unknown when the function is traced: use NumPy's functions, not those of math")

    __int__ = __index__ = __complex__ = __float__

    def __iter__(self) -> NoReturn:
        raise TypeError("a symbol is a single number and has no elements")

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        return _applied(ufunc, method, inputs, options)

    def __repr__(self) -> str:
        return f"Symbol({self.text})"


class Symbols(np.ndarray):
    """An array of symbols. NumPy functions apply to it element by element."""

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        return _applied(ufunc, method, inputs, options)

    def __array_function__(self, function: Any, types: Any, given: Any, options: Any) -> Any:
        if function is np.where:
            return where(*given, **options)
        return super().__array_function__(function, types, given, options)


def array(values: Any) -> Symbols:
    """Converts an array of objects to an array of symbols."""
    return np.asarray(values, dtype=object).view(Symbols)


def _symbol(value: object) -> Symbol | None:
    """Converts a symbol or a number to a symbol; returns ``None`` for anything else."""
    if isinstance(value, Symbol):
        return value
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)):
        return Symbol(str(int(value)))
    if not isinstance(value, (int, float, np.integer, np.floating)):
        return None
    number = _arrays.number("a number of a function", value)
    text = repr(abs(number)).removesuffix(".0")
    return Symbol(f"-{text}", _SIGN) if math.copysign(1.0, number) < 0.0 else Symbol(text)


def _simple(left: str, sign: str, right: str) -> int | None:
    """Simplifies a sum or a product with 0 or 1, which are frequent in vectors and matrices.

    Returns 0 for the result 0, 1 for the left operand, 2 for the right, 3 for minus the right,
    ``None`` if there is no simplification.
    """
    if sign == "*":
        return 0 if "0" in (left, right) else 1 if right == "1" else 2 if left == "1" else None
    if sign in ("+", "-") and right == "0":
        return 1
    return {"+": 2, "-": 3}.get(sign) if left == "0" else None


def _call(name: str, *given: Symbol) -> Symbol:
    return Symbol(f"{name}({','.join(one.text for one in given)})")


def _named(name: str) -> Callable[..., Symbol]:
    return lambda *given: _call(name, *given)


#: Symbolic forms of NumPy functions.
_FUNCTIONS: dict[np.ufunc, Callable[..., Any]] = {
    np.add: lambda a, b: a + b,
    np.subtract: lambda a, b: a - b,
    np.multiply: lambda a, b: a * b,
    np.divide: lambda a, b: a / b,
    np.power: lambda a, b: a**b,
    np.float_power: lambda a, b: a**b,
    np.negative: lambda a: -a,
    np.positive: lambda a: a,
    np.square: lambda a: a**2,
    np.reciprocal: lambda a: 1 / a,
    np.absolute: _named("abs"),
    np.fabs: _named("abs"),
    np.sign: lambda a: where(a > 0, 1, where(a < 0, -1, 0)),
    np.less: lambda a, b: a < b,
    np.less_equal: lambda a, b: a <= b,
    np.greater: lambda a, b: a > b,
    np.greater_equal: lambda a, b: a >= b,
    np.logical_and: lambda a, b: Symbol(f"({a.text} and {b.text})"),
    np.logical_or: lambda a, b: Symbol(f"({a.text} or {b.text})"),
    np.bitwise_and: lambda a, b: Symbol(f"({a.text} and {b.text})"),
    np.bitwise_or: lambda a, b: Symbol(f"({a.text} or {b.text})"),
    np.minimum: _named("min"),
    np.fmin: _named("min"),
    np.maximum: _named("max"),
    np.fmax: _named("max"),
    np.sqrt: _named("sqrt"),
    np.exp: _named("exp"),
    np.log: _named("log"),
    np.sin: _named("sin"),
    np.cos: _named("cos"),
    np.tan: _named("tan"),
    np.arcsin: _named("asin"),
    np.arccos: _named("acos"),
    np.arctan: _named("atan"),
    np.arctan2: _named("atan2"),
    np.hypot: _named("hypot"),
    np.radians: lambda a: a * (math.pi / 180.0),
    np.deg2rad: lambda a: a * (math.pi / 180.0),
    np.degrees: lambda a: a * (180.0 / math.pi),
    np.rad2deg: lambda a: a * (180.0 / math.pi),
}


def _applied(ufunc: np.ufunc, method: str, inputs: tuple[Any, ...], options: dict[str, Any]) -> Any:
    """Applies a NumPy function to symbols, or to arrays of them."""
    if ufunc is np.matmul and method == "__call__" and not options:
        return _unwrapped(np.matmul(*(np.asarray(one, dtype=object) for one in inputs)))
    function = _FUNCTIONS.get(ufunc)
    if function is None or set(options) - {"axis", "keepdims"}:
        raise TypeError(f"the function cannot use np.{ufunc.__name__} on a symbol: formulas do not have this function")

    def of(*values: Any) -> Symbol:
        given = [_symbol(value) for value in values]
        for value, one in zip(values, given):
            if one is None:
                raise TypeError(f"the function uses {type(value).__name__} as a number")
        return function(*given)  # type: ignore[no-any-return]

    if method == "__call__":
        given = [np.asarray(one, dtype=object) for one in inputs]
        return _unwrapped(np.frompyfunc(of, len(inputs), 1)(*given))
    if method == "reduce" and ufunc.nin == 2:
        rows = np.asarray(inputs[0], dtype=object)
        axis = options.get("axis", 0)
        rows = rows.reshape(-1) if axis is None else np.moveaxis(rows, axis, 0)
        return _unwrapped(reduce(np.frompyfunc(of, 2, 1), rows))
    raise TypeError(f"the function cannot use np.{ufunc.__name__}.{method} on symbols")


def _unwrapped(found: Any) -> Any:
    return array(found) if isinstance(found, np.ndarray) and found.ndim else found.item() if isinstance(found, np.ndarray) else found


def where(condition: Any, then: Any, otherwise: Any) -> Any:
    """Selects ``then`` where the condition holds, else ``otherwise``, also for symbols.

    >>> from polhode.scenario import torque, where
    >>> torque(lambda t, omega: where(t < 2.0, 0.3, 0.0) * omega).torque[0]
    'if(t<2,0.3,0)*wx'
    """

    def of(*values: Any) -> Symbol:
        given = [_symbol(value) for value in values]
        if any(one is None for one in given):
            raise TypeError("where takes a condition and two values, numbers or symbols")
        return _call("if", *given)  # type: ignore[arg-type]

    return _unwrapped(np.frompyfunc(of, 3, 1)(*(np.asarray(one, dtype=object) for one in (condition, then, otherwise))))


class Attitude:
    """Symbolic attitude. It takes body components to space components."""

    def as_matrix(self) -> Symbols:
        """Returns the rotation matrix R_space_body (3, 3)."""
        return array([[Symbol(f"r{row}{column}") for column in (1, 2, 3)] for row in (1, 2, 3)])

    def as_quat(self, *, scalar_first: bool = False) -> Symbols:
        """Returns the quaternion (4,): x, y, z, w as in SciPy, or w first."""
        return array([Symbol(f"q{name}") for name in ("wxyz" if scalar_first else "xyzw")])

    def apply(self, vector: npt.ArrayLike, inverse: bool = False) -> Any:
        """Returns the space components of a vector (3,) in body components; with ``inverse``, the
        reverse."""
        matrix = self.as_matrix()
        return (matrix.T if inverse else matrix) @ np.asarray(vector)


#: Parts of the state that a function may take, by the names of its parameters.
_STATE: dict[str, Callable[[], Any]] = {
    "t": lambda: Symbol("t"),
    "omega": lambda: array([Symbol(f"w{axis}") for axis in "xyz"]),
    "omega_space": lambda: array([Symbol(f"w{axis}") for axis in "XYZ"]),
    "momentum": lambda: array([Symbol(f"L{axis}") for axis in "xyz"]),
    "momentum_space": lambda: array([Symbol(f"L{axis}") for axis in "XYZ"]),
    "kinetic_energy": lambda: Symbol("T_rot"),
    "attitude": Attitude,
}


def asked(function: Any, *, vectorized: bool = False) -> list[str]:
    """Returns the parts of the state that a function takes: the names of its parameters without a
    default."""
    if not callable(function):
        raise TypeError(f"function must be a function of the state, not {type(function).__name__}")
    known = [*_STATE, "member"] if vectorized else [*_STATE]
    needed = [
        one.name
        for one in inspect.signature(function).parameters.values()
        if one.default is one.empty and one.kind in (one.POSITIONAL_ONLY, one.POSITIONAL_OR_KEYWORD, one.KEYWORD_ONLY)
    ]
    unknown = [name for name in needed if name not in known]
    if unknown:
        hint = f"use parameters from {', '.join(known)}; give other parameters a default value"
        raise PolhodeError(f"the function has the parameter {unknown[0]}, which is not part of the state", hint)
    return needed


def formula_torque(function: Any) -> tuple[str, ...]:
    """Returns the formulas of the three components of a function."""
    given = {name: _STATE[name]() for name in asked(function)}
    found = np.asarray(called_with(function, given), dtype=object)
    if found.shape != (3,):
        raise PolhodeError(f"the function must return three components, of shape (3,), not {found.shape}")
    components = [_symbol(component) for component in found]
    for component, one in zip(found, components):
        if one is None:
            raise TypeError(f"the function must return numbers or symbols, not {type(component).__name__}")
    return tuple(one.text for one in components if one is not None)


def called_with(function: Any, given: dict[str, Any]) -> Any:
    """Calls a function with the parts of the state that it takes.

    Parameters before a ``/`` are positional.
    """
    kinds = inspect.signature(function).parameters
    first = [value for name, value in given.items() if kinds[name].kind is inspect.Parameter.POSITIONAL_ONLY]
    return function(*first, **{name: value for name, value in given.items() if kinds[name].kind is not inspect.Parameter.POSITIONAL_ONLY})
