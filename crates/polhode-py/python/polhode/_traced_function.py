"""Torques that are Python functions, traced with symbols to obtain formulas."""

from __future__ import annotations

import inspect
import math
from functools import reduce
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._attitude import Turned
from ._error import PolhodeError
from ._symbol import TOO_LONG, Symbol, call, symbol_of


class Symbols(np.ndarray):
    """An array of symbols. NumPy functions apply to it element by element."""

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        return _applied(ufunc, method, inputs, options)

    def __array_function__(self, function: Any, types: Any, given: Any, options: Any) -> Any:
        return _computed(function, given, options)

    # The methods of arrays bypass the functions of the same names.
    def sum(self, *given: Any, **options: Any) -> Any:
        return np.sum(self, *given, **options)

    def prod(self, *given: Any, **options: Any) -> Any:
        return np.prod(self, *given, **options)

    def mean(self, *given: Any, **options: Any) -> Any:
        return np.mean(self, *given, **options)

    def max(self, *given: Any, **options: Any) -> Any:
        return np.max(self, *given, **options)

    def min(self, *given: Any, **options: Any) -> Any:
        return np.min(self, *given, **options)

    def clip(self, *given: Any, **options: Any) -> Any:
        return np.clip(self, *given, **options)

    def dot(self, *given: Any, **options: Any) -> Any:
        return np.dot(self, *given, **options)


def array(values: Any) -> Symbols:
    """Converts an array of objects to an array of symbols."""
    return np.asarray(values, dtype=object).view(Symbols)


def _named(name: str) -> Callable[..., Symbol]:
    return lambda *given: call(name, *given)


#: Symbolic forms of NumPy functions.
_FUNCTIONS: dict[np.ufunc, Callable[..., Any]] = {
    np.add: lambda a, b: a + b,
    np.subtract: lambda a, b: a - b,
    np.multiply: lambda a, b: a * b,
    np.divide: lambda a, b: a / b,
    np.remainder: lambda a, b: a % b,
    np.floor_divide: lambda a, b: a // b,
    np.power: lambda a, b: a**b,
    np.float_power: lambda a, b: a**b,
    np.negative: lambda a: -a,
    np.positive: lambda a: a,
    np.conjugate: lambda a: a,
    np.square: lambda a: a**2,
    np.reciprocal: lambda a: 1 / a,
    np.absolute: _named("abs"),
    np.fabs: _named("abs"),
    np.floor: _named("floor"),
    np.ceil: math.ceil,
    np.trunc: lambda a: where(a < 0, math.ceil(a), math.floor(a)),
    np.sign: lambda a: where(a > 0, 1, where(a < 0, -1, 0)),
    np.heaviside: lambda a, at_zero: where(a > 0, 1, where(a < 0, 0, at_zero)),
    np.less: lambda a, b: a < b,
    np.less_equal: lambda a, b: a <= b,
    np.greater: lambda a, b: a > b,
    np.greater_equal: lambda a, b: a >= b,
    np.logical_and: lambda a, b: a & b,
    np.logical_or: lambda a, b: a | b,
    np.logical_not: lambda a: where(a, 0, 1),
    np.bitwise_and: lambda a, b: a & b,
    np.bitwise_or: lambda a, b: a | b,
    np.minimum: _named("min"),
    np.fmin: _named("min"),
    np.maximum: _named("max"),
    np.fmax: _named("max"),
    np.sqrt: _named("sqrt"),
    np.exp: _named("exp"),
    np.exp2: lambda a: 2**a,
    np.expm1: _named("expm1"),
    np.log: _named("log"),
    np.log2: lambda a: call("log", a) / math.log(2.0),
    np.log10: lambda a: call("log", a) / math.log(10.0),
    np.log1p: _named("log1p"),
    np.sin: _named("sin"),
    np.cos: _named("cos"),
    np.tan: _named("tan"),
    np.arcsin: _named("asin"),
    np.arccos: _named("acos"),
    np.arctan: _named("atan"),
    np.arctan2: _named("atan2"),
    np.sinh: _named("sinh"),
    np.cosh: _named("cosh"),
    np.tanh: _named("tanh"),
    np.hypot: _named("hypot"),
    np.radians: lambda a: a * (math.pi / 180.0),
    np.deg2rad: lambda a: a * (math.pi / 180.0),
    np.degrees: lambda a: a * (180.0 / math.pi),
    np.rad2deg: lambda a: a * (180.0 / math.pi),
}

#: Functions that users call where NumPy calls the reduction of another function.
_REDUCTIONS: dict[np.ufunc, str] = {np.add: "sum", np.multiply: "prod", np.maximum: "max", np.minimum: "min", np.logical_and: "all", np.logical_or: "any"}

#: Options of NumPy functions, with their values if they are not given.
_DEFAULTS: dict[str, Any] = {"dtype": None, "where": True, "initial": np._NoValue}


def _applied(ufunc: np.ufunc, method: str, inputs: tuple[Any, ...], options: dict[str, Any]) -> Any:
    """Applies a NumPy function to symbols, or to arrays of them."""
    (into,) = options.pop("out", None) or (None,)
    if into is not None:
        # An operation in place, such as ``torque *= 2``.
        into[...] = _applied(ufunc, method, inputs, options)
        return into
    name = _REDUCTIONS.get(ufunc, ufunc.__name__) if method == "reduce" else ufunc.__name__
    options = {key: value for key, value in options.items() if key not in _DEFAULTS or value is not _DEFAULTS[key]}
    if ufunc is np.matmul and method == "__call__" and not options:
        return _unwrapped(np.matmul(*(np.asarray(one, dtype=object) for one in inputs)))
    if ufunc not in _FUNCTIONS:
        raise TypeError(f"the function cannot use np.{name} on a symbol: formulas do not have this function")
    if method == "__call__" and not options:
        return _elementwise(_FUNCTIONS[ufunc], *inputs)
    if method == "reduce" and ufunc.nin == 2 and set(options) <= {"axis", "keepdims"}:
        return _reduced(_FUNCTIONS[ufunc], inputs[0], **{"axis": 0, **options})
    options_given = f" with {', '.join(options)}" if options else ""
    raise TypeError(f"the function cannot use np.{name}{'' if method in ('__call__', 'reduce') else f'.{method}'}{options_given} on symbols")


def _elementwise(function: Callable[..., Any], *inputs: Any) -> Any:
    """Applies a function of symbols to the elements of arrays, which are broadcast."""

    def of(*values: Any) -> Any:
        return function(*(_number(value) for value in values))

    return _unwrapped(np.frompyfunc(of, len(inputs), 1)(*(np.asarray(one, dtype=object) for one in inputs)))


def _number(value: Any) -> Symbol:
    one = symbol_of(value)
    if one is None:
        raise TypeError(f"the function uses {type(value).__name__} as a number")
    return one


def _reduced(function: Callable[..., Any], given: Any, axis: Any = None, keepdims: bool = False) -> Any:
    """Joins the elements along axes by a function of two symbols."""
    values = np.asarray(given, dtype=object)
    along = tuple(range(values.ndim)) if axis is None else tuple(k % values.ndim for k in np.atleast_1d(axis).tolist())
    others = [k for k in range(values.ndim) if k not in along]
    rows = values.transpose(*along, *others).reshape(-1, *(values.shape[k] for k in others))
    found = reduce(lambda a, b: np.asarray(_elementwise(function, a, b), dtype=object), rows)
    return _unwrapped(np.expand_dims(np.asarray(found, dtype=object), along if keepdims else ()))


def _mean(given: Any, axis: Any = None, keepdims: bool = False) -> Any:
    total = _reduced(_FUNCTIONS[np.add], given, axis, keepdims)
    return total / (np.size(given) / np.size(total))


def _clip(a: Any, a_min: Any = None, a_max: Any = None, *, min: Any = None, max: Any = None) -> Any:
    low, high = a_min if a_min is not None else min, a_max if a_max is not None else max
    if low is not None and high is not None:
        return _elementwise(_named("clip"), a, low, high)
    if low is not None:
        return np.maximum(a, low)
    return a if high is None else np.minimum(a, high)


#: Maximum number of points in a table of np.interp: a formula computes all intervals and chooses
#: one, so with more points it is slower than a call of the function.
_MOST_POINTS = 200


def _interp(x: Any, xp: npt.ArrayLike, fp: npt.ArrayLike, left: Any = None, right: Any = None) -> Any:
    """Interpolates linearly in a table, by a choice between its intervals."""
    places, values = _arrays.numbers("xp of np.interp", xp, ("n",)), _arrays.numbers("fp of np.interp", fp, ("n",))
    if len(places) == 0 or len(places) != len(values):
        raise PolhodeError(f"xp and fp of np.interp must have one length of at least 1, not {len(places)} and {len(values)}")
    _arrays.refuse("xp of np.interp", places, np.diff(places, prepend=places[0]) < 0.0, "at least the one before it")
    if len(places) > _MOST_POINTS:
        raise PolhodeError(f"np.interp has a table of {len(places)} points, and a formula chooses between at most {_MOST_POINTS}", TOO_LONG)

    def of(at: Symbol) -> Symbol:
        found = _number(values[-1])
        for k in range(len(places) - 2, -1, -1):
            if places[k] < places[k + 1]:
                slope = (values[k + 1] - values[k]) / (places[k + 1] - places[k])
                found = call("if", at < places[k + 1], values[k] + slope * (at - places[k]), found)
        found = call("if", at < places[0], _number(values[0] if left is None else left), found)
        return found if right is None else call("if", at > places[-1], _number(right), found)

    return _elementwise(of, x)


def where(condition: Any, then: Any, otherwise: Any) -> Any:
    """Selects ``then`` where the condition holds, else ``otherwise``, also for symbols.

    >>> from polhode.scenario import torque, where
    >>> torque(lambda t, omega: where(t < 2.0, 0.3, 0.0) * omega).torque[0]
    'if(t<2,0.3,0)*wx'
    """
    return _elementwise(_named("if"), condition, then, otherwise)


#: Symbolic forms of NumPy functions of arrays. Others compute with the elements as objects.
_OF_ARRAYS: dict[Any, Callable[..., Any]] = {
    np.where: where,
    np.sum: lambda a, axis=None, keepdims=False: _reduced(_FUNCTIONS[np.add], a, axis, keepdims),
    np.prod: lambda a, axis=None, keepdims=False: _reduced(_FUNCTIONS[np.multiply], a, axis, keepdims),
    np.max: lambda a, axis=None, keepdims=False: _reduced(_FUNCTIONS[np.maximum], a, axis, keepdims),
    np.min: lambda a, axis=None, keepdims=False: _reduced(_FUNCTIONS[np.minimum], a, axis, keepdims),
    np.all: lambda a, axis=None, keepdims=False: _reduced(_FUNCTIONS[np.logical_and], a, axis, keepdims),
    np.any: lambda a, axis=None, keepdims=False: _reduced(_FUNCTIONS[np.logical_or], a, axis, keepdims),
    np.mean: _mean,
    np.clip: _clip,
    np.interp: _interp,
}


def _computed(function: Any, given: tuple[Any, ...], options: dict[str, Any]) -> Any:
    """Calls a NumPy function of arrays with symbols among its arguments."""
    symbolic = _OF_ARRAYS.get(function)
    try:
        if symbolic is not None:
            return symbolic(*given, **options)
        return _unwrapped(function(*(_plain(one) for one in given), **{name: _plain(one) for name, one in options.items()}))
    except TypeError as error:
        module = function.__module__.replace("numpy", "np", 1)
        raise TypeError(f"the function cannot use {module}.{function.__name__} like this on symbols: {error}") from None


def _plain(value: Any) -> Any:
    """Returns symbols as an array of objects, also inside lists."""
    if isinstance(value, (Symbol, Symbols)):
        return np.asarray(value, dtype=object)
    return type(value)([_plain(one) for one in value]) if type(value) in (list, tuple) else value


def _unwrapped(found: Any) -> Any:
    return array(found) if isinstance(found, np.ndarray) and found.ndim else found.item() if isinstance(found, np.ndarray) else found


def _method(function: np.ufunc) -> Callable[..., Any]:
    return lambda *given: function(*given)


# NumPy calls these methods for the elements of arrays of objects, which np.array makes.
for _function in _FUNCTIONS:
    if not hasattr(Symbol, _function.__name__):
        setattr(Symbol, _function.__name__, _method(_function))
Symbol.__array_ufunc__ = lambda self, ufunc, method, *inputs, **options: _applied(ufunc, method, inputs, options)  # type: ignore[attr-defined]
Symbol.__array_function__ = lambda self, function, types, given, options: _computed(function, given, options)  # type: ignore[attr-defined]


class Attitude(Turned):
    """Symbolic attitude. It takes body components to space components."""

    def __init__(self, is_inverse: bool = False) -> None:
        quaternion = array([Symbol(f"q{name}") for name in "wxyz"])
        super().__init__(quaternion)
        self._quaternion = self._conjugate() if is_inverse else quaternion
        self._is_inverse = is_inverse

    def _joined(self, *parts: Any) -> Symbols:
        return array(parts)

    def as_matrix(self) -> Symbols:
        """Returns the rotation matrix R_space_body (3, 3)."""
        matrix = array([[Symbol(f"r{row}{column}") for column in (1, 2, 3)] for row in (1, 2, 3)])
        return matrix.T if self._is_inverse else matrix

    def inv(self) -> Attitude:
        """Returns the inverse rotation, which takes space components to body components."""
        return Attitude(not self._is_inverse)


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


def positional(function: Any, names: list[str]) -> Callable[..., Any]:
    """Returns a function that takes the parts of the state in this order, without names.

    The parameters are looked up here, once, as a call is made at each stage of each step.
    """
    kinds = inspect.signature(function).parameters
    by_name = [name for name in names if kinds[name].kind is inspect.Parameter.KEYWORD_ONLY]
    if not by_name:
        called: Callable[..., Any] = function
        return called
    first = len(names) - len(by_name)
    return lambda *given: function(*given[:first], **dict(zip(by_name, given[first:])))


def formula_torque(function: Any) -> tuple[str, ...]:
    """Returns the formulas of the three components of a function."""
    names = asked(function)
    found = np.asarray(positional(function, names)(*(_STATE[name]() for name in names)), dtype=object)
    if found.shape != (3,):
        raise PolhodeError(f"the function must return three components, of shape (3,), not {found.shape}")
    components = [symbol_of(component) for component in found]
    for component, one in zip(found, components):
        if one is None:
            raise TypeError(f"the function must return numbers or symbols, not {type(component).__name__}")
    return tuple(one.text for one in components if one is not None)
