"""Symbolic numbers, and the formulas that they are written as."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from typing import Any, NoReturn

import numpy as np

from . import _arrays
from ._error import PolhodeError

#: Precedence levels of expressions: lowest for a choice and a comparison, highest for a name.
COMPARISON, SUM, PRODUCT, SIGN, POWER, NAME = range(6)

#: Maximum length of a formula in characters, as in the reader.
LONGEST = 65536

#: Formulas up to this length repeat expressions that are used several times; longer formulas give
#: them names.
REPEATED = 500

#: Alternatives to a formula that is too long.
TOO_LONG = "use polhode.scenario.FunctionTorque, which calls the function; for a table of times, use polhode.scenario.TorqueTable"

_EQUALITY = "the function compares a symbol for equality, but its value is unknown when the function is traced: compare with < or >"

_serials = itertools.count()


class Symbol:
    """A symbolic expression. Operators and NumPy functions of it return other expressions."""

    __slots__ = ("_pieces", "_holds", "_length", "_serial")

    #: Text, and operands with the precedence below which they are in parentheses.
    _pieces: tuple[str | tuple[Symbol, int], ...]
    _holds: int
    #: Length of the formula without names, up to parentheses.
    _length: int
    #: Order of creation: operands come first.
    _serial: int

    def __init__(self, *pieces: str | tuple[Symbol, int], holds: int = NAME) -> None:
        self._pieces, self._holds, self._serial = pieces, holds, next(_serials)
        self._length = sum(len(piece) if isinstance(piece, str) else piece[0]._length for piece in pieces)

    @property
    def text(self) -> str:
        """Formula of the expression."""
        return _written(self)

    @property
    def _literal(self) -> str | None:
        """Name or number that the expression consists of."""
        (first, *others) = self._pieces
        return first if isinstance(first, str) and not others else None

    def _join(self, other: object, sign: str, holds: int, *, turned: bool = False) -> Any:
        one = symbol_of(other)
        if one is None:
            return NotImplemented
        left, right = (one, self) if turned else (self, one)
        simple = _simple(left._literal, sign, right._literal)
        if simple is not None:
            return (Symbol("0"), left, right, -right)[simple]
        # The operators are left-associative: the right operand needs higher precedence, and
        # parentheses if it has a sign.
        return Symbol((left, holds), sign, (right, POWER if right._holds == SIGN else holds + 1), holds=holds)

    def __add__(self, other: object) -> Any:
        return self._join(other, "+", SUM)

    def __radd__(self, other: object) -> Any:
        return self._join(other, "+", SUM, turned=True)

    def __sub__(self, other: object) -> Any:
        return self._join(other, "-", SUM)

    def __rsub__(self, other: object) -> Any:
        return self._join(other, "-", SUM, turned=True)

    def __mul__(self, other: object) -> Any:
        return self._join(other, "*", PRODUCT)

    def __rmul__(self, other: object) -> Any:
        return self._join(other, "*", PRODUCT, turned=True)

    def __truediv__(self, other: object) -> Any:
        return self._join(other, "/", PRODUCT)

    def __rtruediv__(self, other: object) -> Any:
        return self._join(other, "/", PRODUCT, turned=True)

    def __mod__(self, other: object) -> Any:
        one = symbol_of(other)
        return NotImplemented if one is None else call("mod", self, one)

    def __rmod__(self, other: object) -> Any:
        one = symbol_of(other)
        return NotImplemented if one is None else one % self

    def __floordiv__(self, other: object) -> Any:
        one = symbol_of(other)
        # The remainder is exact; the quotient without it is an integer up to rounding.
        return NotImplemented if one is None else call("floor", (self - self % one) / one + 0.5)

    def __rfloordiv__(self, other: object) -> Any:
        one = symbol_of(other)
        return NotImplemented if one is None else one // self

    def __pow__(self, other: object) -> Any:
        one = symbol_of(other)
        # Powers are right-associative and bind tighter than a sign: put each operand in parentheses
        # unless it is a name.
        return NotImplemented if one is None else Symbol((self, NAME), "^", (one, NAME), holds=POWER)

    def __rpow__(self, other: object) -> Any:
        one = symbol_of(other)
        return NotImplemented if one is None else one**self

    def __neg__(self) -> Symbol:
        return Symbol("-", (self, POWER), holds=SIGN)

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        return call("abs", self)

    def __floor__(self) -> Symbol:
        return call("floor", self)

    def __ceil__(self) -> Symbol:
        return -call("floor", -self)

    def __lt__(self, other: object) -> Any:
        return self._join(other, "<", COMPARISON)

    def __le__(self, other: object) -> Any:
        return self._join(other, "<=", COMPARISON)

    def __gt__(self, other: object) -> Any:
        return self._join(other, ">", COMPARISON)

    def __ge__(self, other: object) -> Any:
        return self._join(other, ">=", COMPARISON)

    def __and__(self, other: object) -> Any:
        return self._both(other, " and ")

    def __or__(self, other: object) -> Any:
        return self._both(other, " or ")

    __rand__, __ror__ = __and__, __or__

    def _both(self, other: object, word: str) -> Any:
        one = symbol_of(other)
        return NotImplemented if one is None else Symbol("(", (self, COMPARISON), word, (one, COMPARISON), ")")

    def __eq__(self, other: object) -> NoReturn:
        raise TypeError(_EQUALITY)

    def __ne__(self, other: object) -> NoReturn:
        raise TypeError(_EQUALITY)

    __hash__ = object.__hash__

    def __bool__(self) -> NoReturn:
        raise TypeError(
            "the function branches on a symbol, whose value is unknown when the function is traced: use polhode.scenario.where(condition, then, otherwise), "
            "and np.stack([x, y, z]), not np.array, for an array that np.clip or np.maximum takes"
        )

    def __float__(self) -> NoReturn:
        raise TypeError(
            "the function converts a symbol to a number, but its value is unknown when the function is traced: "
            "use NumPy's functions, not those of math, and np.array([x, y, z]), not elements of np.zeros(3)"
        )

    __int__ = __index__ = __complex__ = __float__

    def __iter__(self) -> NoReturn:
        raise TypeError("a symbol is a single number and has no elements")

    def conjugate(self) -> Symbol:
        """Returns the number itself, which is real."""
        return self

    def __repr__(self) -> str:
        return f"Symbol({self.text})"


def _written(result: Symbol) -> str:
    """Returns the formula of an expression.

    In a long formula, an expression that is used several times has a name: ``a1=wx+wy;a1*(1+a1)``.
    """
    found, waiting, uses = {result._serial: result}, [result], Counter[int]()
    while waiting:
        for piece in waiting.pop()._pieces:
            if isinstance(piece, tuple):
                uses[piece[0]._serial] += 1
                if piece[0]._serial not in found:
                    found[piece[0]._serial] = piece[0]
                    waiting.append(piece[0])
    texts: dict[int, tuple[str, int]] = {}
    named: list[str] = []
    length = 0

    def taken(serial: int) -> tuple[str, int]:
        # Long texts that are used once are not kept.
        return texts.pop(serial) if uses[serial] == 1 else texts[serial]

    for serial in sorted(found):
        one = found[serial]
        text = "".join(piece if isinstance(piece, str) else _operand(*taken(piece[0]._serial), piece[1]) for piece in one._pieces)
        holds = one._holds
        if result._length > REPEATED and uses[serial] > 1 and one._literal is None:
            named.append(f"a{len(named) + 1}={text};")
            length += len(named[-1])
            text, holds = f"a{len(named)}", NAME
        if length + len(text) > LONGEST:
            raise PolhodeError(f"the formula of this function is too long: it must have at most {LONGEST} characters", TOO_LONG)
        texts[serial] = text, holds
    return "".join(named) + texts[result._serial][0]


def _operand(text: str, holds: int, least: int) -> str:
    """Returns the text, in parentheses if its precedence is lower than ``least``."""
    return text if holds >= least else f"({text})"


def symbol_of(value: object) -> Symbol | None:
    """Converts a symbol or a number to a symbol; returns ``None`` for anything else."""
    if isinstance(value, Symbol):
        return value
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
        if isinstance(value, Symbol):
            return value
    if isinstance(value, (bool, np.bool_)):
        return Symbol(str(int(value)))
    if not isinstance(value, (int, float, np.integer, np.floating)):
        return None
    number = _arrays.number("a number of a function", value)
    text = repr(abs(number)).removesuffix(".0")
    return Symbol(f"-{text}", holds=SIGN) if math.copysign(1.0, number) < 0.0 else Symbol(text)


def _simple(left: str | None, sign: str, right: str | None) -> int | None:
    """Simplifies a sum or a product with 0 or 1, which are frequent in vectors and matrices.

    Returns 0 for the result 0, 1 for the left operand, 2 for the right, 3 for minus the right,
    ``None`` if there is no simplification.
    """
    if sign == "*":
        return 0 if "0" in (left, right) else 1 if right == "1" else 2 if left == "1" else None
    if sign in ("+", "-") and right == "0":
        return 1
    return {"+": 2, "-": 3}.get(sign) if left == "0" else None


def call(name: str, *given: Symbol) -> Symbol:
    """Returns a function of formulas with its arguments."""
    pieces: list[str | tuple[Symbol, int]] = []
    for one in given:
        pieces += [",", (one, COMPARISON)]
    return Symbol(f"{name}(", *pieces[1:], ")")
