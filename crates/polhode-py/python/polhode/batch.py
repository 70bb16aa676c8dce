"""Plans, and the pure function from a record batch to a record batch that sweeps are made of; it needs PyArrow.

Rows in, a member of a plan each, as :func:`inputs` makes them; rows out, each with what becomes of its member. A row knows of no other row:
wherever a table is cut, and on whatever machines its pieces are computed, the bits are the same. So an engine for tables is all that a cluster
needs, and :mod:`polhode.sweep` brings two.

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
from functools import lru_cache
from typing import Any, Iterable, NamedTuple, TypeVar

import numpy as np

from . import _arrays, _native
from ._error import PolhodeError
from ._mass_properties import Finding, findings_of

try:
    import pyarrow as pa
except ImportError as error:
    raise ImportError("record batches need PyArrow: pip install pyarrow") from error

#: Rows that are computed without a look for Ctrl-C.
PIECE = 256

#: A record batch, or a table of several.
Rows = TypeVar("Rows", pa.RecordBatch, pa.Table)


class Variable(NamedTuple):
    """Something that differs from member to member: a column of inputs."""

    #: The column's name.
    name: str
    #: The unit in SI; empty if there is none.
    unit: str
    #: What it is.
    description: str


class Plan:
    """A scenario, and what differs from member to member: of a file, or of its text (a ``str`` of more than one line).

    A plan travels to other processes as its text. The files that it names, if there are any, have to be at the same path there, with
    the same contents: a plan that arrives as another is refused.
    """

    __slots__ = ("_native",)

    def __init__(self, source: str | os.PathLike[str]) -> None:
        if isinstance(source, str) and "\n" in source:
            self._native = _native.Plan.parse(source, "plan.toml")
        else:
            self._native = _native.Plan.read(_arrays.path("source", source))

    @property
    def text(self) -> str:
        """The text of its file."""
        return self._native.text

    @property
    def members(self) -> int:
        """How many members there are."""
        return self._native.members

    @property
    def variables(self) -> list[Variable]:
        """What differs."""
        return [Variable(*variable) for variable in self._native.variables]

    @property
    def wants_trajectories(self) -> bool:
        """True if the motions of members are to be kept too."""
        return self._native.wants_trajectories

    @property
    def digest(self) -> str:
        """A name for everything that results depend on: the text, the contents of the files that it names, and the program's version."""
        return self._native.digest

    @property
    def findings(self) -> list[Finding]:
        """What was noticed, about members that are not possible too."""
        return findings_of(self._native.findings)

    def __repr__(self) -> str:
        return f"Plan({self.members} members, {', '.join(variable.name for variable in self.variables) or 'nothing'} varied)"

    def __reduce__(self) -> tuple[Any, ...]:
        return _arrived, (self.text, os.path.abspath(self._native.path), self.digest)


@lru_cache(maxsize=8)
def _arrived(text: str, path: str, digest: str) -> Plan:
    """A plan that was sent; a process reads it once."""
    plan: Plan = object.__new__(Plan)
    plan._native = _native.Plan.parse(text, path)
    if plan.digest != digest:
        raise PolhodeError(
            f"the plan {path} is another one on this machine",
            "the files that it names, and polhode's version, have to be the same everywhere",
        )
    return plan


def inputs(plan: Plan, members: range | None = None) -> pa.RecordBatch:
    """The inputs of some members, or of all: ``member``, and a column for each variable, in SI."""
    plan = _plan(plan)
    chosen = range(plan.members) if members is None else members
    if not isinstance(chosen, range):
        raise TypeError(f"members must be a range, not {type(chosen).__name__}")
    if chosen.step != 1 or not 0 <= chosen.start <= chosen.stop <= plan.members:
        raise PolhodeError(f"members = {chosen} must be a range of step 1 within range({plan.members})")
    return _arrow(plan._native.inputs(chosen.start, chosen.stop))


def simulate(rows: Rows, plan: Plan) -> Rows:
    """The rows, each with what becomes of its member: how it ended, periods, final state, extrema, events; further columns go along.

    A member without a body or a motion, and one whose computation fails, is a row that says so in ``status`` and ``cause``.
    """
    found: Any = _mapped(rows, plan, _plan(plan)._native.simulate)
    for field, column in zip(rows.schema, rows.columns):
        if field.name not in found.schema.names:
            found = found.append_column(field, column)
    return found


def trajectories(rows: Rows, plan: Plan) -> Rows:
    """The motions of the rows' members: a row for each sample time."""
    return _mapped(rows, plan, _plan(plan)._native.trajectories)


def compute(plan: Plan, start: int, stop: int) -> tuple[pa.RecordBatch, pa.RecordBatch | None]:
    """What becomes of the members from ``start`` up to ``stop``, and their trajectories if the plan wants them: a part of a sweep."""
    members = inputs(plan, range(start, stop))
    return simulate(members, plan), trajectories(members, plan) if plan.wants_trajectories else None


def _plan(plan: Plan) -> Plan:
    if not isinstance(plan, Plan):
        raise TypeError(f"plan must be a Plan, not {type(plan).__name__}: polhode.batch.Plan reads one")
    return plan


def _mapped(rows: Any, plan: Plan, function: Any) -> Any:
    """A function of columns, piece by piece: Python looks for signals between them."""
    if not isinstance(rows, (pa.RecordBatch, pa.Table)):
        raise TypeError(
            f"rows must be a pyarrow RecordBatch or Table, not {type(rows).__module__}.{type(rows).__name__}: "
            "pyarrow.Table.from_pandas and DataFrame.to_arrow make one"
        )
    names = ["member", *(variable.name for variable in plan.variables)]
    missing = [name for name in names if name not in rows.schema.names]
    if missing:
        raise PolhodeError(f"there is no column {missing[0]}", f"a row has {', '.join(names)}")
    chosen = rows.select(names)
    pieces = [chosen.slice(k, PIECE) for k in range(0, max(chosen.num_rows, 1), PIECE)]
    done = [_arrow(function([(name, _numbers(name, piece)) for name in names])) for piece in pieces]
    return pa.Table.from_batches(done) if isinstance(rows, pa.Table) else pa.concat_batches(done)


def _numbers(name: str, rows: Any) -> Any:
    """A column of inputs as an array."""
    column = rows.column(name)
    is_whole, is_member = pa.types.is_integer(column.type), name == "member"
    if not (is_whole or pa.types.is_floating(column.type) and not is_member):
        raise TypeError(f"column {name} must hold {'whole numbers' if is_member else 'numbers'}, not {column.type}")
    if column.null_count:
        raise PolhodeError(f"column {name} has rows without a value")
    array = column.to_numpy(zero_copy_only=False) if isinstance(column, pa.Array) else column.to_numpy()
    if not is_member:
        return _arrays.real(f"column {name}", array)
    if (array < 0).any():
        raise PolhodeError(f"column {name} has negative numbers")
    return np.require(array, np.uint64, ["C", "A"])


def _arrow(columns: Iterable[_native.Column]) -> pa.RecordBatch:
    """Columns of Rust as a record batch; units and descriptions are the metadata of its fields."""
    fields, arrays = [], []
    for name, unit, description, values, there in columns:
        array = pa.array(values, pa.string()) if isinstance(values, list) else pa.array(values, mask=None if there is None else ~there)
        nullable = isinstance(values, list) or there is not None
        fields.append(pa.field(name, array.type, nullable, {"unit": unit, "description": description}))
        arrays.append(array)
    return pa.RecordBatch.from_arrays(arrays, schema=pa.schema(fields))


def _columns(rows: pa.RecordBatch) -> list[_native.Column]:
    """A record batch as columns for Rust: what :func:`_arrow` gave."""
    columns: list[_native.Column] = []
    for field, array in zip(rows.schema, rows.columns):
        about = {key.decode(): value.decode() for key, value in (field.metadata or {}).items()}
        there = np.asarray(array.is_valid()) if field.nullable and pa.types.is_floating(field.type) else None
        if pa.types.is_string(field.type):
            values: Any = array.to_pylist()
        else:
            filled = array.fill_null(0.0) if there is not None else array
            # What came from another process need not lie as processors like it.
            values = np.require(filled.to_numpy(zero_copy_only=False), None, ["C", "A"])
        columns.append((field.name, about.get("unit", ""), about.get("description", ""), values, there))
    return columns
