"""Numbers of a scenario by key: those that can be varied, and scenarios with other values."""

from __future__ import annotations

import copy
import difflib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from . import _arrays, _native
from ._error import PolhodeError
from ._public import public
from ._scenario import _SEVERAL, Scenario
from .scenario import Start

#: Number of knobs if the user names none.
FEW = 4

#: Names of :class:`polhode.Scenario` arguments as patterns, and the keys of scenario files.
_ALIASES = [
    *((rf"^start\.{name}(?=\[|$)", f"start.spin.{key}") for name, key in Start._SPIN.items()),
    *((rf"^{name}(?=\[)", key) for name, (key, _) in _SEVERAL.items()),
    (r"^body(?=\[)", "body.part"),
]


@public()
@dataclass(frozen=True, kw_only=True)
class Knob:
    """Range and label of a slider for a number of a scenario.

    Parameters
    ----------
    low, high
        Ends of the slider, in the unit of the number in the scenario, or SI if it has none. The
        default suits the number.
    label
        Label of the slider; the default is the number's name in the scenario. The unit is added.

    Examples
    --------
    >>> import polhode
    >>> polhode.Knob(low=0, high=3000, label="spin")
    Knob(low=0.0, high=3000.0, label='spin')
    """

    low: float | None = None
    high: float | None = None
    label: str | None = None

    def __post_init__(self) -> None:
        for name in ("low", "high"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, _arrays.number(name, getattr(self, name)))
        if self.label is not None:
            _arrays.text("label", self.label)


Knobs = Sequence[str] | Mapping[str, Knob | tuple[float, float] | None]


def knobs_of(scenario: Scenario, asked: Knobs | None) -> list[dict[str, Any]]:
    """Returns the requested knobs, or the most informative ones: objects with key, label, unit,
    what, value, low, high and scale."""
    there = {knob["key"]: knob for knob in json.loads(_native.scenario_knobs(scenario._path, scenario._text()))}
    own = tuple(f"{table}[{k}]." for table, k in scenario._own())
    there = {key: knob for key, knob in there.items() if not key.startswith(own)}
    if asked is None:
        return [_knob(knob, Knob()) for knob in list(there.values())[:FEW]]
    if isinstance(asked, str) or not isinstance(asked, Iterable):
        raise TypeError(f"knobs must be keys, or a mapping from keys to Knob or (low, high), not {type(asked).__name__}")
    ranges = dict(asked) if isinstance(asked, Mapping) else dict.fromkeys(asked)
    found = {}
    for name, ends in ranges.items():
        key = _key(scenario, _arrays.text("a key of knobs", name))
        if key not in there:
            raise PolhodeError(f"knobs: the scenario has no number {name}", _near(key, list(there)))
        if key in found:
            raise PolhodeError(f"knobs: {name} is given twice")
        found[key] = _knob(there[key], _given(name, ends))
    if not found:
        raise PolhodeError("knobs must have at least one key")
    return list(found.values())


def _given(name: str, ends: object) -> Knob:
    if ends is None:
        return Knob()
    if isinstance(ends, Knob):
        return ends
    if isinstance(ends, (tuple, list)) and len(ends) == 2:
        return Knob(low=ends[0], high=ends[1])
    raise TypeError(f"knobs[{name!r}] must be a Knob, (low, high) or None, not {type(ends).__name__}")


def _knob(knob: Mapping[str, Any], given: Knob) -> dict[str, Any]:
    value = knob["value"]
    unit = knob["unit"] or knob["si"]
    low = knob["low"] if given.low is None else given.low
    high = knob["high"] if given.high is None else given.high
    if not low < high:
        raise PolhodeError(f"knobs: low = {low:g} of {knob['key']} must be less than high = {high:g}")
    if not low <= value <= high:
        raise PolhodeError(f"knobs: {knob['key']} is {value:g} {unit}".rstrip() + f", which is not from {low:g} to {high:g}", "give low and high in the unit of the number")
    return {
        "key": knob["key"],
        "label": given.label or knob["label"],
        "unit": unit,
        "what": knob["what"],
        "value": value,
        "written": knob["unit"],
        "low": low,
        "high": high,
        "scale": knob["scale"] if low > 0 else "linear",
    }


def key_of_argument(name: str) -> str:
    """Converts the name of an argument to the key of scenario files."""
    for pattern, key in _ALIASES:
        name = re.sub(pattern, key, name)
    return name


def _key(scenario: Scenario, name: str) -> str:
    """Converts the name of an argument to a key, with indices in place of the ``name`` of
    elements."""
    name = key_of_argument(name)
    for table, rows in (("body.part", scenario.body), *((key, scenario._several[several]) for several, (key, _) in _SEVERAL.items())):
        for k, row in enumerate(rows):
            called = row.to_dict().get("name", "")
            name = name.replace(f'{table}["{called}"]', f"{table}[{k}]")
    return name


def _near(key: str, there: list[str]) -> str:
    near = difflib.get_close_matches(key, there, 3, 0.5)
    if near:
        return f"did you mean {' or '.join(near)}?"
    return f"known: {', '.join(there[:12])}{', …' if len(there) > 12 else ''}"


def with_values(scenario: Scenario, knobs: Sequence[Mapping[str, Any]], values: Mapping[str, float]) -> Scenario:
    """Returns the scenario with these numbers, in the units in which they are written."""
    tables = copy.deepcopy(scenario._tables())
    for knob in knobs:
        value = values[knob["key"]]
        *way, last = [int(k) if k else name for name, k in re.findall(r"([\w-]+)|\[(\d+)\]", knob["key"])]
        place: Any = tables
        for step in way:
            place = place[step]
        place[last] = f"{value!r} {knob['written']}" if knob["written"] else value
    return Scenario._of(tables, scenario.folder, scenario._own())
