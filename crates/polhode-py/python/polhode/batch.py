"""Plans, and the pure functions of record batches that sweeps consist of. Requires PyArrow.

Each input row is a member of a plan, as :func:`inputs` makes it. Each output row is the result of
its member. Rows are independent of each other: the results are bit-identical however a table is
split, and on any machines and threads. A cluster therefore only needs an engine for tables, and
:mod:`polhode.sweep` supports two. A table of the user's own, from arrays or a dataframe, may
replace that of :func:`inputs`.

>>> import polhode.batch
>>> plan = polhode.batch.Plan('''
... [[body.part]]
... shape = "tensor"
... mass = "3 kg"
... moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
...
... [start]
... spin = { body = [0.1, 2, -0.3] }
...
... [run]
... duration = "60 s"
...
... [sweep]
... members = 1_000_000
... sampling = "monte carlo"
... seed = 7
...
... [[sweep.vary]]
... key = "start.spin.body[1]"
... normal = { mean = "2 rad/s", sd = "10 deg/s" }
... ''')
>>> some = polhode.batch.inputs(plan, range(500_000, 500_100))
>>> some.column_names
['member', 'start_spin_body_y_rad_s']
>>> rows = polhode.batch.simulate(some, plan)
>>> rows["status"].unique().to_pylist()
['complete']
>>> polhode.batch.simulate(some.slice(41, 1), plan).equals(rows.slice(41, 1))
True
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from . import _arrays, _html, _native, _pieces
from ._error import PolhodeError
from ._mass_properties import Finding, findings_of, warn_of
from ._scenario import Scenario
from ._vary import Vary, placed, plan_lines, sweep_of

try:
    import pyarrow as pa
except ImportError as error:
    raise ImportError("record batches need PyArrow: pip install pyarrow") from error

# It is documented in this module, but needs no PyArrow.
Vary.__module__ = __name__


class Variable(NamedTuple):
    """A quantity that varies between members: a column of inputs."""

    #: Name of the column.
    name: str
    #: SI unit; empty if there is none.
    unit: str
    #: Description of the quantity.
    description: str


class Plan:
    """A scenario and the quantities that vary between members.

    The source is a file, its text (a ``str`` of more than one line), or a
    :class:`polhode.Scenario`.

    A plan is sent to other processes as its text. Files to which it refers must be at the same path
    there, with the same contents; otherwise the plan is refused. Assumptions, and members that are
    not physical, are reported as :class:`polhode.PolhodeWarning` when a plan is read, and in
    ``findings``.

    Parameters
    ----------
    source
        A path, a text, or a scenario.
    vary
        Quantities that vary, a list of :class:`Vary`; only for a scenario.
    members
        Number of members; omit it for a grid.
    sampling
        Sampling method: ``"monte carlo"``, ``"latin hypercube"``, ``"sobol"`` or ``"grid"``.
    seed, replicates, trajectories, questions
        As in `files <https://github.com/polhode/polhode/blob/main/book/sweep.md#the-plan>`_;
        ``questions`` are conditions by name.

    Raises
    ------
    PolhodeError
        If the plan is invalid. For a file or a text, the error has ``line`` and ``column``; for a
        scenario, the message names the argument.

    Examples
    --------
    Two numbers drawn together by their covariance matrix, and the tensor of the body by standard
    deviations and correlations:

    >>> import numpy as np, polhode
    >>> from polhode.batch import Plan, Vary
    >>> from polhode.scenario import Run, Start
    >>> tumbling = polhode.Scenario(
    ...     polhode.MassProperties(mass=3.0, inertia=[1.0, 2.0, 2.5]),
    ...     start=Start(omega=[0.1, 2.0, -0.3]),
    ...     run=Run(duration=60.0),
    ... )
    >>> covariance = np.array([[4e-4, 5e-4], [5e-4, 1e-2]])
    >>> sd = [0.02, 0.03, 0.03, 0.01, 0.01, 0.01]
    >>> plan = Plan(
    ...     tumbling,
    ...     vary=[
    ...         Vary(key=["start.omega[0]", "start.omega[1]"], correlated=covariance),
    ...         Vary(key="body.inertia", correlated={"sd": sd, "correlation": np.eye(6)}),
    ...     ],
    ...     members=20_000,
    ... )
    >>> drawn = polhode.batch.inputs(plan)
    >>> rates = np.stack([drawn[f"start_spin_body_{axis}_rad_s"] for axis in "xy"])
    >>> bool(abs(np.cov(rates) - covariance).max() < 3e-4)
    True
    """

    __slots__ = ("_native",)

    def __init__(
        self,
        source: str | os.PathLike[str] | Scenario,
        *,
        vary: Sequence[Vary] = (),
        members: int | None = None,
        sampling: str | None = None,
        seed: int | None = None,
        replicates: int | None = None,
        trajectories: bool = False,
        questions: Mapping[str, str] | None = None,
    ) -> None:
        sweep = sweep_of(vary, members, sampling, seed, replicates, trajectories, questions)
        if isinstance(source, Scenario):
            lines = plan_lines(source, vary, sweep)
            path = os.path.join(source.folder, "plan.toml")
            try:
                self._native = _native.Plan.parse("".join(f"{line}\n" for _, line in lines), path)
            except PolhodeError as error:
                raise placed(error, path, lines) from None
        elif not isinstance(source, (str, os.PathLike)):
            raise TypeError(f"source must be a path, a text or a Scenario, not {type(source).__name__}")
        elif len(vary) if isinstance(vary, Sequence) else True:
            raise PolhodeError("vary is only for a Scenario: a file or a text contains its own")
        elif any(value is not None for value in (members, sampling, seed, replicates, questions)) or trajectories:
            raise PolhodeError("members, sampling, seed, replicates, trajectories and questions are only for a Scenario: a file or a text contains its own")
        elif isinstance(source, str) and "\n" in source:
            self._native = _native.Plan.parse(_arrays.text("source", source), "plan.toml")
        else:
            self._native = _native.Plan.read(_arrays.path("source", source))
        warn_of(self.findings)

    @property
    def text(self) -> str:
        """Text of the plan's file."""
        return self._native.text

    @property
    def members(self) -> int:
        """Number of members."""
        return self._native.members

    @property
    def variables(self) -> list[Variable]:
        """Quantities that vary between members."""
        return [Variable(*variable) for variable in self._native.variables]

    @property
    def wants_trajectories(self) -> bool:
        """True if the trajectories of members are to be saved too."""
        return self._native.wants_trajectories

    @property
    def digest(self) -> str:
        """Hash of everything on which results depend.

        This is the text, the contents of its files, and the program's version.
        """
        return self._native.digest

    @property
    def findings(self) -> list[Finding]:
        """Findings, also about members that are not physical."""
        return findings_of(self._native.findings)

    def __eq__(self, other: object) -> bool:
        """Returns true if the results of both plans are the same, whatever their paths."""
        return self.digest == other.digest if isinstance(other, Plan) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.digest)

    def __repr__(self) -> str:
        names = [variable.name for variable in self.variables]
        shown = names if len(names) <= 4 else [*names[:3], f"and {len(names) - 3} more"]
        return f"Plan({self.members} members, {', '.join(shown) or 'nothing'} varied)"

    def _repr_html_(self) -> str:
        """Returns a table of the variables."""
        return f"<div>{_html.rows(['unit', 'description'], ((name, [unit, what]) for name, unit, what in self.variables))}<p>{self.members} members</p></div>"

    def __reduce__(self) -> tuple[Any, ...]:
        sent = self.text, os.path.abspath(self._native.path), self.digest
        return _arrived, (type(self), *sent), getattr(self, "__dict__", None)


def _arrived(kind: type[Plan], text: str, path: str, digest: str) -> Plan:
    """Restores a plan that was sent. Attributes of a subclass are restored afterwards."""
    plan = object.__new__(kind)
    plan._native = _read(text, path, digest)
    return plan


@lru_cache(maxsize=8)
def _read(text: str, path: str, digest: str) -> _native.Plan:
    """Reads a plan, once for each process."""
    plan = _native.Plan.parse(text, path)
    if plan.digest != digest:
        raise PolhodeError(
            f"the plan {path} is different on this machine",
            "use the same data files and the same version of polhode on all machines",
        )
    return plan


def inputs(plan: Plan, members: range | None = None) -> pa.RecordBatch:
    """Returns the inputs of members: ``member``, and a column for each variable, in SI units.

    By default, all members.
    """
    plan = _plan(plan)
    chosen = range(plan.members) if members is None else members
    if not isinstance(chosen, range):
        raise TypeError(f"members must be a range, not {type(chosen).__name__}")
    if chosen.step != 1 or not 0 <= chosen.start <= chosen.stop <= plan.members:
        raise PolhodeError(f"members = {chosen} must be a range of step 1 within range({plan.members})")
    return _arrow(plan._native.inputs(chosen.start, chosen.stop))


def simulate(rows: Any, plan: Plan, *, threads: int | None = None) -> Any:
    """Computes the result of each row: its ending, periods, final state, extrema and events.

    Further columns are kept.

    If a member has an invalid body or motion, or its computation fails, ``status`` and ``cause`` of
    its row say so. A further column with the name of a result is refused.

    Parameters
    ----------
    rows
        A PyArrow record batch or table with ``member`` and a column for each of the plan's
        variables, in SI units, as :func:`inputs` returns it. Or a table of your own with a row for
        each member: a dataframe of pandas or Polars, or a mapping from columns to arrays (n,), or
        to a number that all rows share. Its rows are numbered from 0 unless it has a column
        ``member``. Its values need not be those that the plan draws.
    plan
        Plan of the members.
    threads
        Number of threads; the default is all processors available to this process. The results are
        bit-identical for any number.

    Returns
    -------
    pyarrow.RecordBatch or pyarrow.Table
        Results, as a table unless ``rows`` is a record batch.

    Raises
    ------
    PolhodeError
        If a column is missing, has missing values, or has a unit other than the plan's.
    TypeError
        If a column does not contain numbers.

    Examples
    --------
    >>> import numpy as np, polhode
    >>> from polhode.batch import Plan, Vary, simulate
    >>> from polhode.scenario import Run, Start
    >>> tumbling = polhode.Scenario(
    ...     polhode.MassProperties(mass=3.0, inertia=[1.0, 2.0, 2.5]),
    ...     start=Start(omega=[0.1, 2.0, -0.3]),
    ...     run=Run(duration=60.0),
    ... )
    >>> plan = Plan(tumbling, vary=[Vary(key="start.omega[1]", relative=0.1), Vary(key="start.omega[2]", relative=0.1)], members=10)
    >>> found = simulate({"start_spin_body_y_rad_s": np.linspace(1.0, 3.0, 5), "start_spin_body_z_rad_s": -0.3}, plan)
    >>> found["regime"].to_pylist()
    ['short_axis', 'short_axis', 'short_axis', 'short_axis', 'short_axis']
    """
    plan = _plan(plan)
    names = _names(plan)
    rows = _rows(rows, names)
    _require(rows, plan, names)
    none = [(name, np.empty(0, np.float64 if name != "member" else np.uint64)) for name in names]
    results = [name for name, *_ in plan._native.simulate(none)]
    for name in rows.schema.names:
        if name in results and name not in names:
            hint = f"rename it, or drop it: rows.select({names})"
            raise PolhodeError(f"rows already have a column {name}, which is the name of a result", hint)
    found: Any = _mapped(rows, names, plan._native.simulate, threads)
    for field, column in zip(rows.schema, rows.columns):
        if field.name not in names:
            found = found.append_column(field, column)
    return found


def trajectories(rows: Any, plan: Plan, *, threads: int | None = None) -> Any:
    """Computes the trajectories of the rows' members: a row for each sample time.

    ``rows`` and ``threads`` are as for :func:`simulate`.
    """
    names = _names(_plan(plan))
    rows = _rows(rows, names)
    _require(rows, plan, names)
    return _mapped(rows, names, plan._native.trajectories, threads)


def compute(plan: Plan, start: int, stop: int) -> tuple[pa.RecordBatch, pa.RecordBatch | None]:
    """Computes a part of a sweep, on one thread: results of the members from ``start`` to
    ``stop`` − 1, and their trajectories if the plan requests them."""
    members = inputs(plan, range(start, stop))
    return simulate(members, plan, threads=1), trajectories(members, plan, threads=1) if plan.wants_trajectories else None


def _plan(plan: Plan) -> Plan:
    if not isinstance(plan, Plan):
        raise TypeError(f"plan must be a Plan, not {type(plan).__name__}: polhode.batch.Plan reads one")
    return plan


def _names(plan: Plan) -> list[str]:
    """Returns the names of the columns of inputs."""
    return ["member", *(variable.name for variable in plan.variables)]


def _rows(rows: Any, names: list[str]) -> Any:
    """Converts a table of the user to an Arrow table."""
    if isinstance(rows, (pa.RecordBatch, pa.Table)):
        return rows
    if isinstance(rows, Mapping):
        rows = _of_arrays(rows)
    elif hasattr(rows, "iloc"):
        # The index of a dataframe is not a column.
        rows = pa.Table.from_pandas(rows, preserve_index=False).replace_schema_metadata()
    elif hasattr(rows, "__arrow_c_stream__"):
        rows = pa.table(rows)
    else:
        raise TypeError(
            f"rows must be a pyarrow RecordBatch or Table, a dataframe, or a mapping from columns to arrays, not {type(rows).__module__}.{type(rows).__name__}"
        )
    if "member" not in rows.schema.names:
        rows = rows.add_column(0, "member", pa.array(np.arange(rows.num_rows, dtype=np.uint64)))
    return rows


def _of_arrays(columns: Mapping[Any, Any]) -> pa.Table:
    """Converts arrays of one length, and numbers that all rows share, to a table."""
    given = {_arrays.text("rows: the name of a column", name): _of_array(f"column {name}", values) for name, values in columns.items()}
    counts = {name: len(values) for name, values in given.items() if np.ndim(values)}
    if len(set(counts.values())) > 1:
        said = ", ".join(f"{name} has {count}" for name, count in counts.items())
        raise PolhodeError(f"{said}: give one for each row, or one for all")
    count = next(iter(counts.values()), 1)
    return pa.table({name: values if np.ndim(values) else np.full(count, values) for name, values in given.items()})


def _of_array(name: str, values: Any) -> Any:
    """Converts a column to an array, or to the number that all rows share."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        # Text is kept. Truth values, and ragged or masked arrays, are checked in full.
        array = array if array.dtype.kind == "U" else _arrays.real(name, values)
    _arrays.refuse_masked(name, values)
    if array.ndim > 1:
        raise PolhodeError(f"{name} must have the shape (n,) or be a number, not {array.shape}")
    return array


def _require(rows: Any, plan: Plan, names: list[str]) -> None:
    """Refuses a table that does not have the columns of the plan's inputs."""
    for name, unit in zip(names, ["", *(variable.unit for variable in plan.variables)]):
        found = rows.schema.get_all_field_indices(name)
        if not found:
            raise PolhodeError(f"rows: the column {name} is missing", f"required columns: {', '.join(names)}")
        if len(found) > 1:
            raise PolhodeError(f"there are {len(found)} columns {name}")
        said = ((rows.schema.field(found[0]).metadata or {}).get(b"unit") or b"").decode(errors="replace")
        if said and said != unit:
            raise PolhodeError(f"column {name} is in {said}, as its field says, and must be in {unit or 'no unit'}")


def _mapped(rows: Any, names: list[str], function: Any, threads: int | None) -> Any:
    """Applies a function to columns, in pieces."""
    count = _native.available_threads() if threads is None else _arrays.count("threads", threads)
    columns = [(name, _numbers(name, rows)) for name in names]

    def piece(start: int, stop: int) -> pa.RecordBatch:
        return _arrow(function([(name, numbers[start:stop]) for name, numbers in columns]))

    whole = pa.concat_batches(_pieces.of(piece, rows.num_rows, count))
    return pa.Table.from_batches([whole]) if isinstance(rows, pa.Table) else whole


def _numbers(name: str, rows: Any) -> Any:
    """Returns a column of inputs as an array."""
    column = rows.column(name)
    is_whole, is_member = pa.types.is_integer(column.type), name == "member"
    if not (is_whole or pa.types.is_floating(column.type) and not is_member):
        raise TypeError(f"column {name} must hold {'whole numbers' if is_member else 'numbers'}, not {column.type}")
    if column.null_count:
        raise PolhodeError(f"column {name} has missing values")
    array = column.to_numpy(zero_copy_only=False) if isinstance(column, pa.Array) else column.to_numpy()
    if not is_member:
        return _arrays.real(f"column {name}", array)
    if (array < 0).any():
        raise PolhodeError(f"column {name} has negative numbers")
    return np.require(array, np.uint64, ["C", "A"])


def _arrow(columns: Iterable[_native.Column]) -> pa.RecordBatch:
    """Converts columns of Rust to a record batch.

    Units and descriptions are the metadata of its fields.
    """
    fields, arrays = [], []
    for name, unit, description, values, there in columns:
        array = pa.array(values, pa.string()) if isinstance(values, list) else pa.array(values, mask=None if there is None else ~there)
        nullable = isinstance(values, list) or there is not None
        fields.append(pa.field(name, array.type, nullable, {"unit": unit, "description": description}))
        arrays.append(array)
    return pa.RecordBatch.from_arrays(arrays, schema=pa.schema(fields))


def _columns(rows: pa.RecordBatch) -> list[_native.Column]:
    """Converts a record batch made by :func:`_arrow` to columns for Rust."""
    columns: list[_native.Column] = []
    for field, array in zip(rows.schema, rows.columns):
        about = {key.decode(): value.decode() for key, value in (field.metadata or {}).items()}
        there = np.asarray(array.is_valid()) if field.nullable and pa.types.is_floating(field.type) else None
        if pa.types.is_string(field.type):
            values: Any = array.to_pylist()
        else:
            filled = array.fill_null(0.0) if there is not None else array
            # Arrays from another process may be unaligned.
            values = np.require(filled.to_numpy(zero_copy_only=False), None, ["C", "A"])
        columns.append((field.name, about.get("unit", ""), about.get("description", ""), values, there))
    return columns
