"""Base class of the tables of a scenario, and conversion to the text of a file."""

from __future__ import annotations

import functools
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import Field, dataclass, fields
from typing import Any, ClassVar, TypeVar

import numpy as np

from . import _arrays, _rotation
from ._toml import pair
from ._units import has_units

_Section = TypeVar("_Section", bound="Section")


@dataclass(frozen=True, kw_only=True)
class Section:
    """A table of a scenario.

    Fields that are ``None`` are not written. A field whose name is a Python keyword ends in ``_``.
    """

    #: Name of the table in reports and errors.
    table: ClassVar[str]
    #: Names of the fields that are rotations.
    _ROTATIONS: ClassVar[frozenset[str]] = frozenset()

    def __post_init__(self) -> None:
        for field in _fields(type(self)):
            if (given := getattr(self, field.name)) is not None:
                convert = rotation if field.name in self._ROTATIONS else plain
                object.__setattr__(self, field.name, convert(f"{self.table}.{field.name}", given))

    def to_dict(self) -> dict[str, Any]:
        """Returns the keys of the table and their values, as in files."""
        return {key_of(field): written(value) for field in _fields(type(self)) if (value := getattr(self, field.name)) is not None}

    @classmethod
    def from_dict(cls: type[_Section], table: Mapping[str, Any]) -> _Section:
        """Makes a table of these keys and values."""
        names = {key_of(field): field.name for field in _fields(cls)}
        return cls(**{names[key]: value for key, value in table.items()})

    def __repr__(self) -> str:
        given = ((field, getattr(self, field.name)) for field in _fields(type(self)))
        return f"{type(self).__name__}({', '.join(f'{f.name}={value!r}' for f, value in given if value is not f.default)})"


#: ``fields`` makes a new tuple each time.
_known_fields = functools.cache(fields)


def _fields(kind: Any) -> tuple[Field[Any], ...]:
    """Returns the fields of a kind of table."""
    return _known_fields(kind)


def key_of(field: Field[Any]) -> str:
    """Returns the key of a field in files."""
    return field.name.rstrip("_")


def plain(name: str, value: object) -> Any:
    """Converts a value to its stored form.

    Stored forms are numbers, text, truth values, tuples, dictionaries and tables. Arrays become
    tuples.
    """
    if value is None or isinstance(value, (bool, str, Section)) or type(value) is float and math.isfinite(value):
        return value
    if isinstance(value, (list, tuple)) and set(map(type, value)) == {float} and all(map(math.isfinite, value)):
        return tuple(value)
    if isinstance(value, os.PathLike):
        return _arrays.path(name, value)
    if isinstance(value, Mapping):
        return {_arrays.text(f"a key of {name}", key): plain(f"{name}.{key}", inner) for key, inner in value.items()}
    if isinstance(value, (int, float)):
        return value if isinstance(value, int) and abs(value) <= _arrays.EXACT else _arrays.number(name, value)
    if isinstance(value, (list, tuple)):
        return tuple(plain(f"{name}[{k}]", element) for k, element in enumerate(value))
    if isinstance(value, np.bool_):
        return bool(value)
    if isinstance(value, np.integer):
        return int(value)
    if has_units(value):
        return plain(name, _arrays.as_text(name, value))
    array = _arrays.real(name, value)
    _arrays.refuse(name, array, ~np.isfinite(array), "finite")
    return _tuples(array.tolist())


def rotation(name: str, value: object) -> Any:
    """Converts a rotation to its stored form, a dictionary as in files."""
    if value is None or isinstance(value, Mapping):
        return plain(name, value)
    return {"quaternion": plain(name, _rotation.quaternions(name, value, (4,)))}


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def written(value: Any) -> Any:
    """Converts a stored value to its form in files."""
    if isinstance(value, Section):
        return value.to_dict()
    if isinstance(value, tuple):
        return [written(element) for element in value]
    if isinstance(value, dict):
        return {key: written(inner) for key, inner in value.items()}
    return value


def sections(name: str, value: object, kind: type[_Section]) -> tuple[_Section, ...]:
    """Checks a list of tables of a kind."""
    given = (value,) if isinstance(value, kind) else value
    if isinstance(given, (str, Mapping)) or not isinstance(given, Iterable):
        raise TypeError(f"{name} must be a list of {kind.__name__}, not {type(value).__name__}")
    found: tuple[Any, ...] = tuple(given)
    for k, one in enumerate(found):
        section(f"{name}[{k}]", one, kind)
    return found


def section(name: str, value: object, kind: type[_Section]) -> _Section:
    """Checks a table of a kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a polhode.scenario.{kind.__name__}, not {type(value).__name__}")
    return value


def lines(tables: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yields the lines of a file, each with the place in Python that it comes from."""
    simple = {key: value for key, value in tables.items() if not isinstance(value, dict) and not _is_tables(value)}
    for key, value in simple.items():
        yield key, pair(key, key, value)
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from _table(key, f"[{key}]", key, value)
        elif _is_tables(value):
            for k, one in enumerate(value):
                yield from _table(key, f"[[{key}]]", f"{key}[{k}]", one)


def _table(key: str, header: str, place: str, table: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    nested = {name: value for name, value in table.items() if key == "body" and _is_tables(value)}
    if not nested or table.keys() != nested.keys():
        yield place, ""
        yield place, header
    for name, value in table.items():
        if name not in nested:
            yield f"{place}.{name}", pair(f"{place}.{name}", name, value)
    for name, rows in nested.items():
        for k, one in enumerate(rows):
            yield from _table(name, f"[[{key}.{name}]]", f"{place}.{name}[{k}]", one)


def _is_tables(value: object) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(one, dict) for one in value)
