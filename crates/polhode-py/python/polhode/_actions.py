"""Torques, wheels, events and orbits of an ensemble: shared by all members, or one set for each."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, Sequence

from . import _arrays, _section
from ._computed_function import Called, computed, computed_of_many, measured, needs_momentum
from ._error import PolhodeError
from ._section import Section
from .scenario import Event, FunctionTorque, Orbit, Torque, Wheel

#: Torques as users pass them: one set for all members, or a list with one set for each member.
Torques = str | Sequence[Torque] | Sequence[str | Sequence[Torque]]

#: Name of the table in scenario files and class of its elements, by the name of the argument.
_TABLES: dict[str, tuple[str, type[Section]]] = {
    "torques": ("torque", Torque),
    "wheels": ("wheel", Wheel),
    "events": ("event", Event),
    "orbit": ("orbit", Orbit),
}

#: Torque computed by a Python function: whether it is in space axes, and the function of one member,
#: or of many at once.
Function = tuple[bool, Called | Callable[..., Any]]

#: Event measure computed by a Python function: whether it depends on the body, and the function.
Measure = tuple[bool, Called]

#: Torques and events that Python functions compute: for each, its position in the list and the
#: index of the function.
Placed = tuple[list[tuple[int, int]], list[tuple[int, int]]]

#: Actions on some members as Rust takes them: name for messages, text of the torques, text of the
#: other tables, and the torques and events that functions replace.
Text = tuple[str, str, str, Placed]


class Functions:
    """Python functions of torques and event measures.

    Each is kept once, however many members use it.
    """

    def __init__(self) -> None:
        self.native: tuple[list[Function], list[Measure]] = ([], [])
        self._known: dict[tuple[Any, ...], int] = {}

    def placed(self, torques: Iterable[Torque], events: Iterable[Event]) -> Placed:
        """Returns the positions of Python functions among some torques and events."""
        of_torques = [(k, self._torque(torque)) for k, torque in enumerate(torques) if isinstance(torque, FunctionTorque)]
        measures = ((k, event.measure) for k, event in enumerate(events))
        return of_torques, [(k, self._measure(measure)) for k, measure in measures if callable(measure)]

    def _torque(self, torque: FunctionTorque) -> int:
        functions, _ = self.native
        key = (id(torque.function), torque.axes, torque.vectorized)
        if key not in self._known:
            self._known[key] = len(functions)
            called = computed_of_many(torque.function) if torque.vectorized else computed(torque.function)
            functions.append((torque.axes == "space", called))
        return self._known[key]

    def _measure(self, measure: Callable[..., Any]) -> int:
        _, measures = self.native
        key = ("measure", id(measure))
        if key not in self._known:
            self._known[key] = len(measures)
            measures.append((needs_momentum(measure), measured(measure)))
        return self._known[key]


@dataclass(frozen=True)
class Actions:
    """Torques, wheels, events and orbit as given: a tuple for all members, or a list of tuples with
    one for each member. Torques may be text."""

    torques: Any
    wheels: Any
    events: Any
    orbit: Any

    @classmethod
    def of(cls, **given: object) -> Actions:
        """Checks the arguments of the user."""
        return cls(**{name: _checked(name, value, kind) for name, value in given.items() for _, kind in [_TABLES[name]]})

    def counts(self) -> dict[str, int]:
        """Number of entries of each argument that is given for each member separately."""
        return {name: len(value) for name, value in vars(self).items() if isinstance(value, list) and len(value) != 1}

    def texts(self, functions: Functions) -> tuple[list[Text], list[int] | None]:
        """Returns the distinct texts, and the index of the text of each member; ``None`` instead of
        indices if all members have the first."""
        count = next(iter(self.counts().values()), None)
        if count is None:
            return [self._text("torques", 0, functions)], None
        found: list[Text] = []
        known: dict[tuple[Any, ...], int] = {}
        which = []
        for k in range(count):
            key = tuple(id(_of(value, k)) for value in vars(self).values())
            if key not in known:
                known[key] = len(found)
                found.append(self._text(f"torques[{k}]", k, functions))
            which.append(known[key])
        return found, which

    def placed(self, error: PolhodeError) -> PolhodeError:
        """Returns an error in such a text as an error of the argument that the text came from."""
        called = re.fullmatch(r"torques(?:\[(\d+)\])?", error.path or "")
        if called is None or error.line is None:
            return error
        own, member = self._lines(int(called[1] or 0)), f"[{called[1]}]" if called[1] else ""
        place = own[error.line - 1] if 0 < error.line <= len(own) else None
        if place is None:
            return error
        first, *rest = re.split(r"(?=[.\[])", place, maxsplit=1)
        name = next(name for name, (key, _) in _TABLES.items() if key == first)
        each = member if isinstance(getattr(self, name), list) else ""
        message = re.sub(rf"{re.escape(str(error.path))}:\d+:\d+: ", f"{name}{each}{''.join(rest)}: ", error.args[0], count=1)
        return PolhodeError(message, error.args[1])

    def _text(self, name: str, member: int, functions: Functions) -> Text:
        torques = _of(self.torques, member)
        own = _ended(torques) if isinstance(torques, str) else "".join(f"{line}\n" for _, line in _rows("torques", torques))
        others = "".join(f"{line}\n" for _, line in self._others(member))
        return name, own, others, functions.placed(() if isinstance(torques, str) else torques, _of(self.events, member))

    def _others(self, member: int) -> list[tuple[str, str]]:
        return [line for name in ("wheels", "events", "orbit") for line in _rows(name, _of(getattr(self, name), member))]

    def _lines(self, member: int) -> list[str | None]:
        """Returns the argument that each line of a member's text comes from; ``None`` for lines of
        the user's own text."""
        torques = _of(self.torques, member)
        own: list[str | None] = [None] * _ended(torques).count("\n") if isinstance(torques, str) else [place for place, _ in _rows("torques", torques)]
        return own + [place for place, _ in self._others(member)]


def _checked(name: str, value: Any, kind: type[Section]) -> Any:
    """Returns the tables for all members as a tuple (torques possibly as text), or a list of these
    with one for each member."""
    if name == "orbit":
        return _orbits(value)
    several = (list, tuple, str) if name == "torques" else (list, tuple)
    if name == "torques" and isinstance(value, str):
        return _arrays.text(name, value)
    if isinstance(value, (str, Mapping, kind)) or not isinstance(value, Iterable):
        return _section.sections(name, value, kind)
    given = list(value)
    if not any(isinstance(one, several) for one in given):
        return _section.sections(name, given, kind)
    return [_arrays.text(f"{name}[{k}]", one) if isinstance(one, str) else _section.sections(f"{name}[{k}]", one, kind) for k, one in enumerate(given)]


def _orbits(value: Any) -> Any:
    """Returns the orbit of all members as a tuple, empty if there is none, or a list of tuples with
    one for each member."""
    if value is None or isinstance(value, Orbit):
        return () if value is None else (value,)
    return [(one,) for one in _section.sections("orbit", value, Orbit)]


def _of(value: Any, member: int) -> Any:
    """Returns the entry of a member."""
    return value[member if len(value) > 1 else 0] if isinstance(value, list) else value


def _rows(name: str, tables: Sequence[Section]) -> Iterable[tuple[str, str]]:
    """Returns the lines of a file with these tables, each with its place."""
    given = [table.to_dict() for table in tables]
    return _section.lines({_TABLES[name][0]: given[0] if name == "orbit" else given}) if given else ()


def _ended(text: str) -> str:
    """Returns the text with a newline at its end."""
    return text if not text or text.endswith("\n") else f"{text}\n"
