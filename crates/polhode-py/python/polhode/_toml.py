"""Conversion of plans given as dictionaries to the text of files."""

from __future__ import annotations

import functools
import json
import os
import re
from collections.abc import Mapping

import numpy as np

from . import _arrays


def text_of(plan: Mapping[str, object]) -> str:
    """Converts a plan to TOML, a line for each key. NumPy arrays become lists, paths become text.

    >>> print(text_of({"title": "a \\"body\\"", "swing": {"mass": 3.2, "center": np.zeros(3)}}), end="")
    title = "a \\"body\\""
    swing = { mass = 3.2, center = [0.0, 0.0, 0.0] }
    """
    return "".join(f"{line}\n" for line in _pairs("plan", plan))


def pair(place: str, key: str, value: object) -> str:
    """Returns a key and its value as a line."""
    return f"{key if _is_bare(key) else _quoted(place, key)} = {_value(place, value)}"


@functools.lru_cache(1024)
def _is_bare(key: str) -> bool:
    """Returns true if a key needs no quotes."""
    return re.fullmatch("[A-Za-z0-9_-]+", key, re.ASCII) is not None


def _pairs(place: str, table: Mapping[str, object]) -> list[str]:
    pairs = []
    for key, value in table.items():
        if not isinstance(key, str):
            raise TypeError(f"{place} has the key {key!r}, which must be text")
        pairs.append(pair(f"{place}[{key!r}]", key, value))
    return pairs


#: Types of numbers whose text is that of Python.
_NUMBERS = {float, int}


def _value(place: str, value: object) -> str:
    if type(value) in _NUMBERS:
        return repr(value)
    if isinstance(value, (list, tuple)) and set(map(type, value)) <= _NUMBERS:
        return f"[{', '.join(map(repr, value))}]"
    if isinstance(value, Mapping):
        return f"{{ {', '.join(_pairs(place, value))} }}" if value else "{}"
    value = _arrays.as_text(place, value)
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return _quoted(place, os.fspath(value))
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_value(f'{place}[{k}]', element) for k, element in enumerate(value))}]"
    raise TypeError(f"{place} must be text, a number, true or false, a list or a dictionary, not {type(value).__name__}")


def _quoted(place: str, text: object) -> str:
    """Returns a TOML basic string: as in JSON, except for one more escaped character."""
    return json.dumps(_arrays.text(place, text), ensure_ascii=False).replace("\x7f", "\\u007f")
