"""Values that belong together, with arrays among them."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np


class Record:
    """What frozen dataclasses with arrays have in common: equal are those whose numbers are equal, NaN to NaN; arrays are read-only, in copies too."""

    #: Nothing with arrays in it is hashed.
    __hash__ = None  # type: ignore[assignment]

    def __post_init__(self) -> None:
        for value in vars(self).values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(same(getattr(self, field.name), getattr(other, field.name)) for field in fields(self))  # type: ignore[arg-type]

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        Record.__post_init__(self)


def same(one: object, other: object) -> bool:
    """Whether two values of fields are equal."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return isinstance(one, np.ndarray) and isinstance(other, np.ndarray) and np.array_equal(one, other, equal_nan=True)
    if isinstance(one, tuple) and isinstance(other, tuple) and type(one) is type(other):
        return len(one) == len(other) and all(map(same, one, other))
    return bool(one == other)
