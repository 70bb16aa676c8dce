"""Base class of results with arrays."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np

from . import _html

#: Greatest number of array elements that are displayed one by one.
SHOWN = 6


class Record:
    """Base class of frozen dataclasses with arrays.

    Objects are equal if their numbers are equal, where NaN equals NaN. Arrays are read-only, also
    in copies.
    """

    #: Not hashable, because it contains arrays.
    __hash__ = None  # type: ignore[assignment]

    def __post_init__(self) -> None:
        for value in vars(self).values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(same(getattr(self, field.name), getattr(other, field.name)) for field in fields(self))  # type: ignore[arg-type]

    def _repr_html_(self) -> str | None:
        """Returns the printed text, or a table of the fields if that is a single line."""
        said = str(self)
        if "\n" in said:
            return _html.text(said)
        named = ((field.name, getattr(self, field.name)) for field in fields(self) if not field.name.startswith("_"))  # type: ignore[arg-type]
        return _html.rows([type(self).__name__], ((name, [_brief(value)]) for name, value in named))

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        Record.__post_init__(self)


def _brief(value: object) -> str:
    """Returns a short text for the value of a field."""
    if isinstance(value, np.ndarray):
        shape = f"array ({', '.join(map(str, value.shape))}{',' if value.ndim == 1 else ''})"
        return ", ".join(map(_html.number, value.ravel())) if value.size <= SHOWN and value.dtype.kind == "f" else shape
    if isinstance(value, float):
        return _html.number(value)
    words = repr(value) if not isinstance(value, str) else value
    return words if len(words) <= 100 else f"{words[:97]}…"


def same(one: object, other: object) -> bool:
    """Returns true if two values of fields are equal."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return isinstance(one, np.ndarray) and isinstance(other, np.ndarray) and np.array_equal(one, other, equal_nan=True)
    if isinstance(one, tuple) and isinstance(other, tuple) and type(one) is type(other):
        return len(one) == len(other) and all(map(same, one, other))
    return bool(one == other)
