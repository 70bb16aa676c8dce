"""From a parts list to mass properties, with their uncertainty."""

from __future__ import annotations

import csv
import io
import json
import os
from dataclasses import dataclass
from typing import Any, Iterable, Iterator, Mapping, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _toml
from ._arrays import Floats
from ._error import PolhodeError
from ._estimate import Estimate, floats
from ._mass_properties import Finding, MassProperties, findings_of, warn_of
from ._printed import Printed
from ._record import Record
from ._table import NoArray


class BudgetLimit(NamedTuple):
    """Whether a limit is met."""

    #: What it is called.
    name: str
    #: The unit of its numbers; empty of ratios.
    unit: str
    #: The least and the most that is allowed; ``None`` without.
    least: float | None
    most: float | None
    #: Of the list as it is given; ``None`` where it has no value.
    value: float | None
    #: Its standard deviation to first order; ``None`` where it has none.
    sd: float | None
    #: Whether that is allowed.
    met: bool
    #: In which share of the draws it is.
    probability: float
    #: Between which probabilities the truth is, with 95 %.
    interval: tuple[float, float]

    def __str__(self) -> str:
        low, high = (100.0 * p for p in self.interval)
        return f"{self.name}: {'met' if self.met else 'not met'}, probability {100.0 * self.probability:.1f} % ({low:.1f} … {high:.1f} %)"


class ErrorShare(NamedTuple):
    """What an error contributes to the variance of a number."""

    #: The row, or ``group NAME`` for what its rows have in common.
    source: str
    #: ``mass``, ``center``, ``tensor``, ``position``, ``rotation`` or ``density``.
    of: str
    #: Its part of the variance, 0 to 1.
    share: float


class BudgetRow(NamedTuple):
    """The masses of a row with all in it, all copies counted, kg."""

    name: str
    #: The row in which it stands; ``None`` of that in which all stand.
    parent: str | None
    quantity: int
    basic: float
    predicted: float
    #: What it may become at most; ``None`` if that is not given.
    allowable: float | None
    #: Allowable less predicted mass.
    margin: float | None


@dataclass(frozen=True, eq=False, repr=False)
class BudgetCase(Record):
    """A configuration of a parts list: what all its parts come to."""

    #: ``None`` where the list has no configurations.
    name: str | None
    #: Mass, centre of mass x, y, z, Ixx, Iyy, Izz, Ixy, Ixz, Iyz about it, with their covariance to first order: kg, m, kg·m².
    estimate: Estimate
    #: The same of the masses as they are known today.
    basic: Estimate
    #: And with their growth allowance.
    predicted: Estimate
    #: Principal moments (3,), ascending, kg·m².
    moments: Floats
    #: Their standard deviations (3,).
    moment_sd: Floats
    #: Principal axes (3, 3), a row each, along those of the body.
    axes: Floats
    #: The tensor (3, 3) about the point and along the axes that were asked for; ``None`` if none were.
    asked_inertia: Floats | None
    #: Mass, centre and six elements about the point and along the axes that were asked for: covariance (10, 10).
    asked_covariance: Floats | None
    #: The ten numbers of each drawn body (n, 10), in the order of ``estimate``.
    draws: Floats
    #: Limits, in the order of the list.
    limits: tuple[BudgetLimit, ...]
    #: Masses, row by row.
    rows: tuple[BudgetRow, ...]
    #: What each number's variance comes from, the greatest first: ``errors["x"][0].source``.
    errors: Mapping[str, tuple[ErrorShare, ...]]
    #: The whole as a part of a scenario file, for :func:`simulate`.
    scenario: str

    @property
    def mass(self) -> float:
        """Mass, kg."""
        return float(self.estimate.values[0])

    @property
    def center_of_mass(self) -> Floats:
        """Centre of mass (3,) from the body's origin, m."""
        return self.estimate.values[1:4]

    @property
    def inertia(self) -> Floats:
        """The tensor (3, 3) about the centre of mass along the axes of the body, kg·m²."""
        matrix: Floats = self.estimate.values[4:][np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])]
        return matrix

    @property
    def covariance(self) -> Floats:
        """Covariance (10, 10) of mass, centre and the six elements of the tensor, to first order."""
        return self.estimate.covariance

    @property
    def body(self) -> MassProperties:
        """Mass, centre of mass and inertia."""
        return MassProperties(mass=self.mass, center_of_mass=self.center_of_mass, inertia=self.inertia)

    def __repr__(self) -> str:
        name = "" if self.name is None else f"{self.name!r}: "
        return f"BudgetCase({name}{self.estimate['mass']}, {len(self.rows)} rows)"


@dataclass(frozen=True, eq=False, repr=False)
class Budget(NoArray, Printed):
    """What a parts list comes to. :func:`budget` makes one; of a list with one configuration it has all that :class:`BudgetCase` has."""

    _instead = "the rows of each configuration are its table: pandas.DataFrame(budget.only.rows)"

    #: What it is called.
    title: str
    #: Which masses count: ``basic`` or ``predicted``.
    basis: str
    #: Each configuration; one without a name where the list has none.
    configurations: tuple[BudgetCase, ...]
    #: True if a limit is not met, or something is heavier than allowed.
    is_beyond: bool
    #: What was noticed.
    findings: tuple[Finding, ...]

    def __getitem__(self, name: str) -> BudgetCase:
        """The configuration of this name."""
        for case in self.configurations:
            if case.name == name:
                return case
        raise KeyError(f"{name!r} is none of {', '.join(str(case.name) for case in self.configurations)}")

    def __iter__(self) -> Iterator[BudgetCase]:
        return iter(self.configurations)

    def __len__(self) -> int:
        return len(self.configurations)

    @property
    def only(self) -> BudgetCase:
        """The configuration of a list that has one."""
        if len(self.configurations) != 1:
            names = ", ".join(repr(case.name) for case in self.configurations)
            raise PolhodeError(f"there are several configurations: {names}", 'name one, as in result["NAME"]')
        return self.configurations[0]

    @property
    def mass(self) -> float:
        """Mass, kg."""
        return self.only.mass

    @property
    def center_of_mass(self) -> Floats:
        """Centre of mass (3,) from the body's origin, m."""
        return self.only.center_of_mass

    @property
    def inertia(self) -> Floats:
        """The tensor (3, 3) about the centre of mass along the axes of the body, kg·m²."""
        return self.only.inertia

    @property
    def covariance(self) -> Floats:
        """Covariance (10, 10) of mass, centre and the six elements of the tensor, to first order."""
        return self.only.covariance

    @property
    def draws(self) -> Floats:
        """The ten numbers of each drawn body (n, 10)."""
        return self.only.draws

    @property
    def limits(self) -> tuple[BudgetLimit, ...]:
        """Limits, in the order of the list."""
        return self.only.limits

    @property
    def body(self) -> MassProperties:
        """Mass, centre of mass and inertia."""
        return self.only.body

    def __repr__(self) -> str:
        return f"Budget({self.title!r}: {', '.join(map(repr, self.configurations))})"


def budget(
    parts: str | os.PathLike[str] | Mapping[str, Iterable[object]] | Any,
    *,
    plan: Mapping[str, object] | None = None,
    basis: str | None = None,
    about: npt.ArrayLike | None = None,
    axes: npt.ArrayLike | None = None,
    draws: int | None = None,
    seed: int | None = None,
    configuration: str | None = None,
) -> Budget:
    """Says what a parts list comes to: what ``polhode budget`` does. What no argument says is as the list has it.

    Parameters
    ----------
    parts
        A path; or the text of a CSV, a ``str`` of more than one line; or a table: a dataframe of pandas or Polars, a table of PyArrow, or a
        dictionary of columns, with the names and units that the headings of a CSV have: ``"mass [g]"``. ``None`` and NaN are empty cells. The
        book's ``budget-file.md`` has all columns.
    plan
        What the list says besides its parts, with a table: title, growth, groups, limits, with the keys that the head of a CSV has.
    basis
        Which masses count: ``"basic"``, as they are known, or ``"predicted"``, with their growth allowance.
    about
        A point (3,) that the tensor is wanted about too, m.
    axes
        Axes that it is wanted along too, the columns of a rotation matrix (3, 3). Tilts are from them.
    draws
        How many possible bodies are drawn: 0, or 10 at least. Usually 10,000, of long lists fewer.
    seed
        Other draws.
    configuration
        Only this one.

    Returns
    -------
    Budget
        The mass properties with their covariance, limits, and whose errors matter, of each configuration.

    Raises
    ------
    PolhodeError
        If the list cannot be read, with the place, or of a table the row; if a part cannot exist.

    Warns
    -----
    PolhodeWarning
        Of findings: a limit is not met, something is too heavy, axes are not known.

    Examples
    --------
    >>> import polhode
    >>> found = polhode.budget({
    ...     "name": ["sat", "sat/bus", "sat/battery"],
    ...     "mass [kg]": [None, "3.1 ± 0.05", "0.9 ± 0.1"],
    ...     "x [mm]": [None, 0, 0],
    ...     "y [mm]": [None, 0, 0],
    ...     "z [mm]": [None, 120, 20],
    ...     "growth": [None, "5 %", "10 %"],
    ... }, draws=0)
    >>> print(found.only.estimate["mass"])
    mass: 4.245 ± 0.12 kg
    >>> most = found.only.errors["z"][0]
    >>> most.source, round(most.share, 3)
    ('battery', 0.979)
    """
    asked: _native.BudgetAsked = {
        "is_basic": None if basis is None else _arrays.choice("basis", basis, ["basic", "predicted"]) == "basic",
        "about": None if about is None else _arrays.numbers("about", about, (3,)).tolist(),
        "axes": None if axes is None else _arrays.numbers("axes", axes, (3, 3)).tolist(),
        "draws": None if draws is None else _arrays.count("draws", draws, 0),
        "seed": None if seed is None else _arrays.count("seed", seed, 0),
        "configuration": None if configuration is None else _arrays.text("configuration", configuration),
    }
    if isinstance(parts, (str, os.PathLike)):
        if plan is not None:
            raise PolhodeError("a plan goes with a table; a file has its own", "write it into the head of the CSV")
        if isinstance(parts, str) and "\n" in parts:
            answer = _native.budget_list("parts.csv", _arrays.text("parts", parts), None, asked)
        else:
            answer = _native.budget_list(_arrays.path("parts", parts), None, None, asked)
    else:
        head = "".join(f"# {line}\n" for line in _toml.text_of(plan or {}).splitlines())
        answer = _native.budget_list("parts.csv", head + _csv_of(_columns(parts)), head.count("\n"), asked)
    found = _found(answer)
    warn_of(found.findings)
    return found


def _columns(table: Any) -> dict[str, list[object]]:
    """The columns of a table by their names."""
    if isinstance(table, Mapping):
        names = list(table)
    elif hasattr(table, "column_names"):
        names = list(table.column_names)
    elif hasattr(table, "columns"):
        names = list(table.columns)
    else:
        raise TypeError(f"parts must be a path, a text, a dataframe or a dictionary of columns, not {type(table).__name__}")
    columns: dict[str, list[object]] = {}
    for name in names:
        if _arrays.text("a column's name", name) in columns:
            raise PolhodeError(f"there are two columns {name!r}")
        columns[name] = _cells(name, table[name])
    lengths = {name: len(cells) for name, cells in columns.items()}
    if len(set(lengths.values())) > 1:
        raise PolhodeError(f"columns have different lengths: {', '.join(f'{name} {n}' for name, n in lengths.items())}")
    return columns


def _cells(name: str, column: Any) -> list[object]:
    if isinstance(column, str):
        raise TypeError(f"the column {name!r} must be a list, not text")
    for method in ("to_pylist", "to_list", "tolist"):
        if hasattr(column, method):
            return list(getattr(column, method)())
    return list(column)


def _csv_of(columns: Mapping[str, list[object]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    for row in range(len(next(iter(columns.values()), []))):
        writer.writerow([_cell(f"{name}[{row}]", cells[row]) for name, cells in columns.items()])
    return out.getvalue()


def _cell(place: str, value: object) -> str:
    """A value as the cell of a CSV: numbers with all their digits."""
    if value is None or value != value or type(value).__name__ in ("NAType", "NaTType"):
        return ""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        raise TypeError(f"{place} = {value} must be text or a number, not a truth value")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        # A cell is one line.
        return " ".join(value.split("\n"))
    if isinstance(value, os.PathLike):
        return _arrays.path(place, value)
    raise TypeError(f"{place} must be text or a number, not {type(value).__name__}")


def _found(answer: _native.Budgeted) -> Budget:
    said: dict[str, Any] = json.loads(answer["json"])
    cases = zip(said["configurations"], answer["draws"], answer["scenarios"])
    return Budget(
        title=said["title"],
        basis=said["basis"],
        configurations=tuple(_case(*case) for case in cases),
        is_beyond=answer["is_beyond"],
        findings=tuple(findings_of((f["code"], f["severity"], f["message"], f["where"]) for f in said["findings"])),
        _printed=(answer["json"], answer["text"], answer["markdown"], answer["page"]),
    )


def _case(said: dict[str, Any], draws: Floats, scenario: str) -> BudgetCase:
    principal, asked, limits = said["principal"], said["asked"], said["limits"]
    return BudgetCase(
        name=said["name"],
        estimate=_estimate(said["estimate"]),
        basic=_estimate(said["basic"]),
        predicted=_estimate(said["predicted"]),
        moments=floats(principal["moments"]),
        moment_sd=floats(principal["moment_sd"]),
        axes=floats(principal["axes"]),
        asked_inertia=None if asked is None else floats(asked["inertia"]),
        asked_covariance=None if asked is None else floats(asked["covariance"]),
        draws=draws,
        limits=() if limits is None else tuple(map(_limit, limits["each"])),
        rows=tuple(map(_row, said["rows"])),
        errors={error["number"]: tuple(ErrorShare(by["source"], by["of"], by["share"]) for by in error["by"]) for error in said["errors"]},
        scenario=scenario,
    )


def _estimate(said: dict[str, Any]) -> Estimate:
    numbers = said["numbers"]
    return Estimate(
        names=tuple(number["name"] for number in numbers),
        units=tuple(number["unit"] for number in numbers),
        values=floats([number["value"] for number in numbers]),
        sd=floats([number["sd"] for number in numbers]),
        covariance=floats(said["covariance"]),
        unknown=np.zeros((0, len(numbers))),
    )


def _limit(said: dict[str, Any]) -> BudgetLimit:
    low, high = said["draws"]["interval"]
    keys = ("name", "unit", "least", "most", "value", "sd", "met")
    return BudgetLimit(**{key: said[key] for key in keys}, probability=said["draws"]["probability"], interval=(low, high))


def _row(said: dict[str, Any]) -> BudgetRow:
    return BudgetRow(said["name"], said["in"], *(said[key] for key in ("quantity", "basic", "predicted", "allowable", "margin")))
