"""What acts on the members of an ensemble: torques, wheels and events, and the orbit of the former, for all of them or for each."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, Sequence

from . import _arrays, _section
from ._computed_law import computed, computed_of_many, measured, needs_momentum
from ._error import PolhodeError
from ._section import Section
from .scenario import Event, FunctionTorque, Orbit, Torque, Wheel

#: Torques as users give them: for all members, or a list for each.
Torques = str | Sequence[Torque] | Sequence[str | Sequence[Torque]]

#: The tables that act, by the argument that has them: what files call them, and their classes.
_TABLES: dict[str, tuple[str, type[Section]]] = {
    "torques": ("torque", Torque),
    "wheels": ("wheel", Wheel),
    "events": ("event", Event),
    "orbit": ("orbit", Orbit),
}

#: A torque that Python computes: whether it is along space axes, how, and whether for many members at once.
Function = tuple[bool, Callable[..., Any], bool]

#: What an event measures that Python computes: whether it depends on the body, and how.
Measure = tuple[bool, Callable[..., float]]

#: Which torques, and which events, functions take the place of: the place of each, and the number of the function.
Placed = tuple[list[tuple[int, int]], list[tuple[int, int]]]

#: What acts on some members, as Rust takes it: what messages call it, the texts of the torques and of all else, and what functions take the place of.
Text = tuple[str, str, str, Placed]


class Functions:
    """The torques that Python computes, and what events measure that it computes, each once, whichever members have it."""

    def __init__(self) -> None:
        self.native: tuple[list[Function], list[Measure]] = ([], [])
        self._known: dict[tuple[Any, ...], int] = {}

    def placed(self, torques: Iterable[Torque], events: Iterable[Event]) -> Placed:
        """Where they are among some torques and events."""
        of_torques = [(k, self._torque(torque)) for k, torque in enumerate(torques) if isinstance(torque, FunctionTorque)]
        measures = ((k, event.measure) for k, event in enumerate(events))
        return of_torques, [(k, self._measure(measure)) for k, measure in measures if callable(measure)]

    def _torque(self, torque: FunctionTorque) -> int:
        functions, _ = self.native
        key = (id(torque.law), torque.axes, torque.vectorized)
        if key not in self._known:
            self._known[key] = len(functions)
            law = computed_of_many(torque.law) if torque.vectorized else computed(torque.law)
            functions.append((torque.axes == "space", law, torque.vectorized))
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
    """What is given of them, by the names of the arguments: a tuple for all members, or a list of these with one for each; torques may be texts."""

    torques: Any
    wheels: Any
    events: Any
    orbit: Any

    @classmethod
    def of(cls, **given: object) -> Actions:
        """Looks at what users give."""
        return cls(**{name: _checked(name, value, kind) for name, value in given.items() for _, kind in [_TABLES[name]]})

    def counts(self) -> dict[str, int]:
        """How many there are of what each member has its own."""
        return {name: len(value) for name, value in vars(self).items() if isinstance(value, list) and len(value) != 1}

    def texts(self, functions: Functions) -> tuple[list[Text], list[int] | None]:
        """The different ones as texts, and which of these each member has; all have the first if that is not said."""
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
        """An error of such a text, at the argument that has it."""
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
        """The place in Python that each line of a member's text comes from; ``None`` of the user's own text."""
        torques = _of(self.torques, member)
        own: list[str | None] = [None] * _ended(torques).count("\n") if isinstance(torques, str) else [place for place, _ in _rows("torques", torques)]
        return own + [place for place, _ in self._others(member)]


def _checked(name: str, value: Any, kind: type[Section]) -> Any:
    """Tables for all members: a tuple, or a text of torques; a list of these with one for each."""
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
    """The orbit of all members, if there is one, as a tuple; a list of these with one for each."""
    if value is None or isinstance(value, Orbit):
        return () if value is None else (value,)
    return [(one,) for one in _section.sections("orbit", value, Orbit)]


def _of(value: Any, member: int) -> Any:
    """What a member has."""
    return value[member if len(value) > 1 else 0] if isinstance(value, list) else value


def _rows(name: str, tables: Sequence[Section]) -> Iterable[tuple[str, str]]:
    """The lines of a file with these tables, each with its place."""
    given = [table.to_dict() for table in tables]
    return _section.lines({_TABLES[name][0]: given[0] if name == "orbit" else given}) if given else ()


def _ended(text: str) -> str:
    """A text whose last line ends."""
    return text if not text or text.endswith("\n") else f"{text}\n"
