"""Scenarios: one body, its start, its torques and its run, as an object."""

from __future__ import annotations

import json
import os
import re
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Callable, Mapping, Sequence

from . import _arrays, _html, _native, _section
from ._body import Body
from ._computed_function import Called, computed, computed_of_one, measured, needs_momentum
from ._error import PolhodeError
from ._mass_properties import Finding, MassProperties, findings_of
from ._public import public
from ._section import Section
from .scenario import (
    Contact,
    Event,
    FunctionTorque,
    Gimbals,
    MassHistory,
    Orbit,
    Part,
    Pendulum,
    Pointing,
    Prescribed,
    Run,
    Shaft,
    Start,
    Torque,
    Wheel,
)

if TYPE_CHECKING:
    import numpy.typing as npt

#: Tables that may occur once, and tables that may occur several times: key in files and class, by
#: the keyword in Python.
_ONE: dict[str, tuple[str, type[Section]]] = {
    "start": ("start", Start),
    "orbit": ("orbit", Orbit),
    "contact": ("contact", Contact),
    "gimbals": ("gimbals", Gimbals),
    "mass_history": ("mass_history", MassHistory),
    "prescribed": ("prescribed", Prescribed),
    "shaft": ("shaft", Shaft),
    "pendulum": ("pendulum", Pendulum),
    "run": ("run", Run),
}
_SEVERAL: dict[str, tuple[str, type[Section]]] = {
    "torques": ("torque", Torque),
    "wheels": ("wheel", Wheel),
    "events": ("event", Event),
    "pointings": ("pointing", Pointing),
}


@public()
class Scenario:
    """One body and its motion.

    It is checked when it is made, so that every scenario can be computed.

    Parameters
    ----------
    body
        Mass properties, a body of named parts, or one :class:`polhode.scenario.Part` or a list of
        these.
    pivot
        Fixed point of the body (3,), body axes, m.
    start, orbit, contact, gimbals, mass_history, prescribed, shaft, pendulum, run
        Tables of :mod:`polhode.scenario`.
    torques, wheels, events, pointings
        Lists of tables of :mod:`polhode.scenario`.
    title
        Title of the scenario.
    symbols
        Quantities by name, such as ``{"b": "0.3 m"}``, for formulas in place of quantities: ``"b/2"``.
    folder
        Folder of the files to which the scenario refers. The default is the current folder.

    Raises
    ------
    PolhodeError
        If the body or the motion is invalid; the message names the argument.

    Examples
    --------
    >>> import polhode
    >>> from polhode import shapes
    >>> from polhode.scenario import Event, Gravity, Run, Start
    >>> scenario = polhode.Scenario(
    ...     shapes.cylinder(radius=0.032, length=0.009, material="brass").placed(position=[0, 0, 0.038]),
    ...     start=Start(attitude={"euler313": [0, "30 deg", 0]}, omega=[0, 0, "2300 rpm"]),
    ...     torques=[Gravity(pivot=[0, 0, 0])],
    ...     events=[Event(name="lower", measure="nutation", value="31 deg")],
    ...     run=Run(duration=0.2, samples=201),
    ... )
    >>> polhode.simulate(scenario).events[0].name
    'lower'
    >>> polhode.Scenario.from_toml(scenario.to_toml()) == scenario
    True
    """

    def __init__(
        self,
        body: MassProperties | Body | Part | Sequence[Part],
        *,
        pivot: npt.ArrayLike | Sequence[float | str] | None = None,
        start: Start | None = None,
        torques: Sequence[Torque] = (),
        wheels: Sequence[Wheel] = (),
        events: Sequence[Event] = (),
        pointings: Sequence[Pointing] = (),
        orbit: Orbit | None = None,
        contact: Contact | None = None,
        gimbals: Gimbals | None = None,
        mass_history: MassHistory | None = None,
        prescribed: Prescribed | None = None,
        shaft: Shaft | None = None,
        pendulum: Pendulum | None = None,
        run: Run | None = None,
        title: str | None = None,
        symbols: Mapping[str, float | str] | None = None,
        folder: str | os.PathLike[str] = ".",
    ) -> None:
        one = {
            "start": start,
            "orbit": orbit,
            "contact": contact,
            "gimbals": gimbals,
            "mass_history": mass_history,
            "prescribed": prescribed,
            "shaft": shaft,
            "pendulum": pendulum,
            "run": run,
        }
        several = {"torques": torques, "wheels": wheels, "events": events, "pointings": pointings}
        self._title = None if title is None else _arrays.text("title", title)
        self._symbols = {name: _section.plain(f"symbols[{name!r}]", value) for name, value in (symbols or {}).items()}
        self._parts = _parts_of(body)
        self._pivot = None if pivot is None else _section.plain("pivot", pivot)
        self._one = {name: _section.section(name, value, _ONE[name][1]) for name, value in one.items() if value is not None}
        self._several = {name: _section.sections(name, value, _SEVERAL[name][1]) for name, value in several.items()}
        self._folder = _arrays.path("folder", folder)
        self._findings = tuple(findings_of(self._read.findings))

    @classmethod
    def from_toml(cls, scenario: str | os.PathLike[str], *, folder: str | os.PathLike[str] | None = None) -> Scenario:
        """Reads the scenario of a file, or of its text.

        Numbers and units are kept as written. Comments are lost.

        Parameters
        ----------
        scenario
            A path, or a text of more than one line.
        folder
            Folder of the files to which a text refers. The default is the current folder.

        Returns
        -------
        Scenario
            Scenario with the contents of the file.

        Raises
        ------
        PolhodeError
            If the text is not a valid scenario; the error has ``line`` and ``column``.
        """
        if isinstance(scenario, str) and "\n" in scenario:
            text, path = _arrays.text("scenario", scenario), None
            where = "." if folder is None else _arrays.path("folder", folder)
        else:
            text, path = None, _arrays.path("scenario", scenario)
            where = os.path.dirname(path) or "."
            if folder is not None:
                raise PolhodeError("folder is only for a text: the files of a scenario file are relative to its own folder")
        tables = json.loads(_native.scenario_tables(path or os.path.join(where, "scenario.toml"), text))
        return cls._of(tables, where)

    @classmethod
    def _of(cls, tables: Mapping[str, Any], folder: str, functions: Mapping[tuple[str, int], Section] = MappingProxyType({})) -> Scenario:
        """Makes the scenario of a file's tables.

        ``functions`` are the torques and events that cannot be written into a file, by table and index.
        """
        known = {"title", "symbols", "body", *(key for key, _ in (*_ONE.values(), *_SEVERAL.values()))}
        other = [key for key in tables if key not in known]
        if other:
            hint = "polhode.batch.Plan reads plans" if other == ["sweep"] else None
            raise PolhodeError(f"the file has [{other[0]}], which is not a table of a single scenario", hint)
        given: dict[str, Any] = {}
        for name, (key, kind) in _ONE.items():
            if key in tables:
                given[name] = kind.from_dict(tables[key])
        for name, (key, kind) in _SEVERAL.items():
            given[name] = [functions.get((key, k)) or kind.from_dict(table) for k, table in enumerate(tables.get(key, ()))]
        body = tables["body"]
        parts = [Part.from_dict(part) for part in body["part"]]
        return cls(parts, pivot=body.get("pivot"), title=tables.get("title"), symbols=tables.get("symbols"), folder=folder, **given)

    def to_toml(self, path: str | os.PathLike[str] | None = None) -> str:
        """Returns the text of the scenario's file.

        Paths in the text are relative to :attr:`folder`, so save a copy there.

        Parameters
        ----------
        path
            Path of the file to write, if any.

        Returns
        -------
        str
            The text of the file.

        Raises
        ------
        PolhodeError
            If a torque is a :class:`polhode.scenario.FunctionTorque`, or the measure of an event is
            a function, which cannot be written into a file.
        """
        if self._functions():
            raise PolhodeError("a FunctionTorque is a Python function, which cannot be written into a file", "convert it to a formula by polhode.scenario.torque")
        if self._measures():
            raise PolhodeError("an event measures a Python function, which cannot be written into a file", "use a formula of the state")
        text = self._text()
        if path is not None:
            with open(_arrays.path("path", path), "w", encoding="utf-8", newline="\n") as file:
                file.write(text)
        return text

    @property
    def title(self) -> str | None:
        """Title of the scenario."""
        return self._title

    @property
    def symbols(self) -> dict[str, float | str]:
        """Quantities by name, for formulas in place of quantities."""
        return dict(self._symbols)

    @property
    def folder(self) -> str:
        """Folder of the files to which the scenario refers."""
        return self._folder

    @property
    def body(self) -> tuple[Part, ...]:
        """Parts of the body."""
        return self._parts

    @property
    def pivot(self) -> Any:
        """Fixed point of the body, as it was given."""
        return self._pivot

    @property
    def start(self) -> Start | None:
        """Initial attitude and angular velocity."""
        return self._one.get("start")  # type: ignore[return-value]

    @property
    def run(self) -> Run | None:
        """Duration, samples and method of the computation."""
        return self._one.get("run")  # type: ignore[return-value]

    @property
    def torques(self) -> tuple[Torque, ...]:
        """Torques that act on the body."""
        return self._several["torques"]  # type: ignore[return-value]

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        """Wheels that spin inside the body."""
        return self._several["wheels"]  # type: ignore[return-value]

    @property
    def events(self) -> tuple[Event, ...]:
        """Events to detect."""
        return self._several["events"]  # type: ignore[return-value]

    @property
    def pointings(self) -> tuple[Pointing, ...]:
        """Pointing angles to report."""
        return self._several["pointings"]  # type: ignore[return-value]

    @property
    def orbit(self) -> Orbit | None:
        """Orbit of the centre of mass."""
        return self._one.get("orbit")  # type: ignore[return-value]

    @property
    def contact(self) -> Contact | None:
        """Contact with the ground."""
        return self._one.get("contact")  # type: ignore[return-value]

    @property
    def gimbals(self) -> Gimbals | None:
        """Gimbals that hold the body."""
        return self._one.get("gimbals")  # type: ignore[return-value]

    @property
    def mass_history(self) -> MassHistory | None:
        """Change of the mass properties with time."""
        return self._one.get("mass_history")  # type: ignore[return-value]

    @property
    def prescribed(self) -> Prescribed | None:
        """Prescribed motion."""
        return self._one.get("prescribed")  # type: ignore[return-value]

    @property
    def shaft(self) -> Shaft | None:
        """Shaft in two bearings."""
        return self._one.get("shaft")  # type: ignore[return-value]

    @property
    def pendulum(self) -> Pendulum | None:
        """Axis of a pendulum."""
        return self._one.get("pendulum")  # type: ignore[return-value]

    @property
    def findings(self) -> list[Finding]:
        """Findings, such as an assumption about the body, or a torque that is never switched on."""
        return list(self._findings)

    def replace(self, **changes: Any) -> Scenario:
        """Returns a copy with other arguments: ``scenario.replace(run=Run(duration=20))``.

        Parameters
        ----------
        **changes
            Arguments of :class:`Scenario`, by name.

        Returns
        -------
        Scenario
            The new scenario. This one is not changed.

        Raises
        ------
        PolhodeError
            If the new motion is invalid.
        """
        given: dict[str, Any] = {**self._one, **self._several, "pivot": self._pivot, "title": self._title, "symbols": self._symbols, "folder": self._folder}
        return Scenario(changes.pop("body", list(self._parts)), **{**given, **changes})

    def _tables(self) -> dict[str, Any]:
        """Returns the tables of the file, in its order."""
        tables: dict[str, Any] = {}
        if self._title is not None:
            tables["title"] = self._title
        if self._symbols:
            tables["symbols"] = {name: _section.written(value) for name, value in self._symbols.items()}
        pivot = {} if self._pivot is None else {"pivot": _section.written(self._pivot)}
        tables["body"] = {**pivot, "part": [part.to_dict() for part in self._parts]}
        for name in ("orbit", "start"):
            if name in self._one:
                tables[name] = self._one[name].to_dict()
        for name, (key, _) in _SEVERAL.items():
            if self._several[name]:
                tables[key] = [one.to_dict() for one in self._several[name]]
        for name, (key, _) in _ONE.items():
            if name in self._one and key not in tables:
                tables[key] = self._one[name].to_dict()
        return tables

    def _text(self) -> str:
        """Returns the text of the file, with a zero torque or measure in place of each Python
        function."""
        return self._written

    @cached_property
    def _written(self) -> str:
        # The scenario is immutable, so the text never changes.
        return "".join(f"{line}\n" for _, line in _section.lines(self._tables())).lstrip("\n")

    def _functions(self) -> list[tuple[int, bool, Called]]:
        """Returns the torques that Python computes: their indices, whether they are in space axes,
        and the functions."""
        torques = enumerate(self.torques)
        functions = [(k, one) for k, one in torques if isinstance(one, FunctionTorque)]
        return [(k, one.axes == "space", computed_of_one(one.function) if one.vectorized else computed(one.function)) for k, one in functions]

    def _measures(self) -> list[tuple[int, bool, Called]]:
        """Returns the event measures that Python computes: their indices, whether they depend on
        the body, and the functions."""
        events = ((k, event.measure) for k, event in enumerate(self.events))
        return [(k, needs_momentum(measure), measured(measure)) for k, measure in events if callable(measure)]

    def _own(self) -> dict[tuple[str, int], Section]:
        """Returns the torques and events that cannot be written into a file, by table and index."""
        torques = {("torque", k): one for k, one in enumerate(self.torques) if isinstance(one, FunctionTorque)}
        return {**torques, **{("event", k): one for k, one in enumerate(self.events) if callable(one.measure)}}

    @property
    def _path(self) -> str:
        """Path that the file of the scenario would have."""
        return os.path.join(self._folder, "scenario.toml")

    @cached_property
    def _read(self) -> _native.ReadScenario:
        """The scenario as the reader of files has it, with the files that it refers to. Errors are
        reported in terms of the arguments."""
        try:
            return _native.ReadScenario.of_text(self._path, self._text())
        except PolhodeError as error:
            raise self._placed(error) from None

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "_read"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)

    def _placed(self, error: PolhodeError) -> PolhodeError:
        """Returns an error in the scenario's text as an error of the argument that the text came
        from."""
        if error.path != self._path or error.line is None:
            return error
        lines = list(_section.lines(self._tables()))
        while lines and not lines[0][1]:
            del lines[0]
        place = lines[error.line - 1][0] if 0 < error.line <= len(lines) else "scenario"
        message = re.sub(rf"^{re.escape(self._path)}:\d+:\d+: ", "", error.args[0])
        names = {key: name for name, (key, _) in _SEVERAL.items()}
        first, *rest = re.split(r"(?=[.\[])", place.removeprefix("body."), maxsplit=1)
        name = {**names, "part": "body"}.get(first, first)
        return PolhodeError(f"{name}{''.join(rest)}: {message}", error.args[1])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scenario):
            return NotImplemented
        same = self._tables() == other._tables() and self._own() == other._own()
        return same and os.path.abspath(self._folder) == os.path.abspath(other._folder)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        words = [self._title or f"a body of {len(self._parts)} part{'s' if len(self._parts) > 1 else ''}"]
        words += [f"{len(tables)} {name[:-1] if len(tables) == 1 else name}" for name, tables in self._several.items() if tables]
        words += [name for name in self._one if name not in ("start", "run")]
        if self.run is not None:
            words.append(f"{self.run.duration}{'' if isinstance(self.run.duration, str) else ' s'}")
        return f"Scenario({'; '.join(words)})"

    def __str__(self) -> str:
        """Returns the text of the file.

        Functions, which cannot be written into a file, are listed first and replaced by zero.
        """
        own = "".join(f"# {table}[{k}] is a Python function, which cannot be written into a file; zero is written instead.\n" for table, k in self._own())
        return own + self._text()

    def _repr_html_(self) -> str:
        return _html.text(str(self))


def _parts_of(body: object) -> tuple[Part, ...]:
    """Converts a body to parts of a file."""
    if isinstance(body, MassProperties):
        return (_tensor(None, body),)
    if isinstance(body, Body):
        return tuple(_tensor(name, part) for name, part in body.parts.items())
    if isinstance(body, (str, os.PathLike)):
        raise TypeError("body must be mass properties or parts: Scenario.from_toml(path) reads a scenario, polhode.inertia(path) a body")
    parts = _section.sections("body", body, Part)
    if not parts:
        raise PolhodeError("body must have at least one part")
    return parts


def _tensor(name: str | None, body: MassProperties) -> Part:
    return Part(name=name, shape="tensor", mass=body.mass, center_of_mass=body.center_of_mass, inertia=body.inertia)


def formula_source(scenario: str | os.PathLike[str] | Scenario) -> tuple[str, str | None]:
    """Returns the path of a scenario whose torques have formulas, and its text if there is one.

    A ``str`` of more than one line is a text.
    """
    if isinstance(scenario, Scenario):
        return scenario._path, scenario.to_toml()
    if isinstance(scenario, str) and "\n" in scenario:
        return "scenario.toml", _arrays.text("scenario", scenario)
    return _arrays.path("scenario", scenario), None
