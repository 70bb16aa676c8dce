"""Mass properties of a parts list, with their uncertainty."""

from __future__ import annotations

import csv
import io
import json
import os
from dataclasses import dataclass
from typing import Any, Iterable, Iterator, Mapping, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _rotation, _toml
from ._arrays import Floats
from ._attitude import Turned
from ._error import PolhodeError
from ._estimate import Estimate, counted, floats
from ._mass_properties import Finding, MassProperties, findings_of, warn_of
from ._printed import Printed
from ._public import public
from ._record import Record
from ._table import NoArray


@public("polhode.results")
class BudgetLimit(NamedTuple):
    """A limit and whether it is met."""

    #: Name of the limit.
    name: str
    #: Unit of its numbers; empty for ratios.
    unit: str
    #: Lower and upper limit; ``None`` where there is none.
    least: float | None
    most: float | None
    #: Value for the list as given; ``None`` if it has no value.
    value: float | None
    #: Standard deviation of the value, to first order; ``None`` if it has none.
    sd: float | None
    #: True if the value is within the limits.
    met: bool
    #: Fraction of the draws within the limits.
    probability: float
    #: 95 % confidence interval of the probability.
    interval: tuple[float, float]

    def __str__(self) -> str:
        low, high = (100.0 * p for p in self.interval)
        return f"{self.name}: {'met' if self.met else 'not met'}, probability {100.0 * self.probability:.1f} % ({low:.1f} … {high:.1f} %)"


@public("polhode.results")
class ErrorShare(NamedTuple):
    """Contribution of an error to the variance of a number."""

    #: Row, or ``group NAME`` for the error that the rows of a group share.
    source: str
    #: ``mass``, ``center``, ``tensor``, ``position``, ``rotation`` or ``density``.
    of: str
    #: Fraction of the variance, 0 to 1.
    share: float


@public("polhode.results")
class BudgetRow(NamedTuple):
    """Masses of a row and everything it contains, all copies counted, kg."""

    name: str
    #: Row that contains this row; ``None`` for the top row.
    parent: str | None
    quantity: int
    basic: float
    predicted: float
    #: Allowable mass, kg; ``None`` if not given.
    allowable: float | None
    #: Allowable minus predicted mass, kg.
    margin: float | None


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class BudgetCase(Record):
    """Mass properties of a configuration of a parts list."""

    #: Name of the configuration; ``None`` if the list has no configurations.
    name: str | None
    #: Mass, centre of mass x, y, z, and Ixx, Iyy, Izz, Ixy, Ixz, Iyz about it, with their
    #: covariance to first order: kg, m, kg·m².
    estimate: Estimate
    #: The same ten numbers for the basic masses, as known today.
    basic: Estimate
    #: The same ten numbers for the predicted masses: basic mass plus growth allowance.
    predicted: Estimate
    #: Principal moments (3,), ascending, kg·m².
    moments: Floats
    #: Standard deviations of the moments (3,), kg·m².
    moment_sd: Floats
    #: Principal axes (3, 3), one per row, in body components.
    axes: Floats
    #: Inertia tensor (3, 3) about the requested point along the requested axes, kg·m²; ``None`` if
    #: none were requested.
    asked_inertia: Floats | None
    #: Covariance (10, 10) of mass, centre of mass and the six elements about the requested point
    #: along the requested axes.
    asked_covariance: Floats | None
    #: Ten numbers of each drawn body (n, 10), in the order of ``estimate``.
    draws: Floats
    #: Limits, in the order of the list.
    limits: tuple[BudgetLimit, ...]
    #: Masses of each row.
    rows: tuple[BudgetRow, ...]
    #: Contributions to the variance of each number, the greatest first: ``errors["x"][0].source``.
    errors: Mapping[str, tuple[ErrorShare, ...]]
    #: The whole body as a part of a scenario file, for :func:`simulate`.
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
        """Inertia tensor (3, 3) about the centre of mass, body axes, kg·m²."""
        matrix: Floats = self.estimate.values[4:][np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])]
        return matrix

    @property
    def covariance(self) -> Floats:
        """Covariance (10, 10) of mass, centre of mass and six tensor elements, to first order."""
        return self.estimate.covariance

    @property
    def body(self) -> MassProperties:
        """Mass properties: mass, centre of mass and inertia."""
        return MassProperties(mass=self.mass, center_of_mass=self.center_of_mass, inertia=self.inertia)

    def __repr__(self) -> str:
        name = "" if self.name is None else f"{self.name!r}: "
        return f"BudgetCase({name}{self.estimate['mass']}, {counted(len(self.rows), 'row')})"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class Budget(NoArray, Printed):
    """Mass properties of a parts list, as :func:`budget` returns them.

    For a list with one configuration it also has the attributes of :class:`BudgetCase`.
    """

    _instead = "the rows of each configuration are its table: pandas.DataFrame(budget.only.rows)"

    #: Title of the list.
    title: str
    #: Masses that count: ``basic`` or ``predicted``.
    basis: str
    #: Configurations; a single one without a name if the list has none.
    configurations: tuple[BudgetCase, ...]
    #: True if a limit is not met, or a row is heavier than allowed.
    is_beyond: bool
    #: Findings about the list.
    findings: tuple[Finding, ...]

    def __getitem__(self, name: str) -> BudgetCase:
        """Returns the configuration of this name."""
        for case in self.configurations:
            if case.name == name:
                return case
        raise KeyError(f"{name!r} is not one of {', '.join(str(case.name) for case in self.configurations)}")

    def __iter__(self) -> Iterator[BudgetCase]:
        return iter(self.configurations)

    def __len__(self) -> int:
        return len(self.configurations)

    @property
    def only(self) -> BudgetCase:
        """The single configuration of a list that has exactly one."""
        if len(self.configurations) != 1:
            names = ", ".join(repr(case.name) for case in self.configurations)
            raise PolhodeError(f"there are several configurations: {names}", 'choose one by its name, as in result["NAME"]')
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
        """Inertia tensor (3, 3) about the centre of mass, body axes, kg·m²."""
        return self.only.inertia

    @property
    def covariance(self) -> Floats:
        """Covariance (10, 10) of mass, centre of mass and six tensor elements, to first order."""
        return self.only.covariance

    @property
    def draws(self) -> Floats:
        """Ten numbers of each drawn body (n, 10)."""
        return self.only.draws

    @property
    def limits(self) -> tuple[BudgetLimit, ...]:
        """Limits, in the order of the list."""
        return self.only.limits

    @property
    def body(self) -> MassProperties:
        """Mass properties: mass, centre of mass and inertia."""
        return self.only.body

    def __repr__(self) -> str:
        return f"Budget({self.title!r}: {', '.join(map(repr, self.configurations))})"


def budget(
    parts: str | os.PathLike[str] | Mapping[str, Iterable[object]] | Any,
    *,
    plan: Mapping[str, object] | None = None,
    basis: str | None = None,
    about: npt.ArrayLike | None = None,
    axes: object = None,
    draws: int | None = None,
    seed: int | None = None,
    configuration: str | None = None,
) -> Budget:
    """Computes mass properties of a parts list, with their uncertainty (``polhode budget``).

    Arguments that are not given keep the values of the list.

    Parameters
    ----------
    parts
        A path; the text of a CSV, a ``str`` of more than one line; or a table. A table is a
        dataframe of pandas or Polars, a table of PyArrow, or a dictionary of columns. Its columns
        have the names and units of the CSV headings: ``"mass [g]"``. ``None`` and NaN are empty
        cells. The book's ``budget-file.md`` lists all columns.
    plan
        Settings that go with a table: title, growth, groups and limits, with the keys of the head
        of a CSV.
    basis
        Masses that count: ``"basic"``, as known today, or ``"predicted"``, with their growth
        allowance.
    about
        Additional reference point (3,) for the inertia tensor, m.
    axes
        Additional axes for the inertia tensor: the rotation from components along them to body
        components, as for :meth:`MassProperties.inertia_along`. The columns of its matrix (3, 3)
        are the axes. Tilts are measured from them.
    draws
        Number of random bodies to draw: 0, or at least 10. The default is 10,000, fewer for long
        lists.
    seed
        Seed of the random draws.
    configuration
        Name of the only configuration to compute. The default is all configurations.

    Returns
    -------
    Budget
        Mass properties with covariance, limits, and contributions to the variance, for each
        configuration.

    Raises
    ------
    PolhodeError
        If the list cannot be read or a part is not physical. The message names the place in the
        file, or the row of the table.

    Warns
    -----
    PolhodeWarning
        For each finding: a limit that is not met, a row that is too heavy, undetermined axes.

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
        "axes": None if axes is None else _matrix(axes),
        "draws": None if draws is None else _arrays.count("draws", draws, 0),
        "seed": None if seed is None else _arrays.count("seed", seed, 0),
        "configuration": None if configuration is None else _arrays.text("configuration", configuration),
    }
    if isinstance(parts, (str, os.PathLike)):
        if plan is not None:
            raise PolhodeError("plan is only for a table: a file contains its own plan", "write the plan into the head of the CSV file")
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


def _matrix(axes: object) -> list[list[float]]:
    """Returns the matrix of a rotation; one that is a matrix keeps its bits."""
    given = _rotation.rotations("axes", axes)
    if given.shape != (3, 3):
        quaternion = _rotation.quaternions("axes", given, (4,))
        given = Turned(quaternion / np.linalg.norm(quaternion)).as_matrix()
    rows: list[list[float]] = _arrays.numbers("axes", given, (3, 3)).tolist()
    return rows


def _columns(table: Any) -> dict[str, list[object]]:
    """Returns the columns of a table by name."""
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
    """Returns a value as the cell of a CSV: numbers with all their digits."""
    if value is None or value != value or type(value).__name__ in ("NAType", "NaTType"):
        return ""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        raise TypeError(f"{place} = {value} must be text or a number, not a truth value")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        # A cell must be one line.
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
