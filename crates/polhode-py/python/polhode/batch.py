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
import time
from functools import lru_cache
from typing import Any, Iterable, NamedTuple, TypeVar

import numpy as np

from . import _arrays, _native
from ._error import PolhodeError
from ._mass_properties import Finding, findings_of, warn_of

try:
    import pyarrow as pa
except ImportError as error:
    raise ImportError("record batches need PyArrow: pip install pyarrow") from error

#: Rows that are computed without a look for Ctrl-C, at most, and for how long that may be, s of the processor, where a row does not take longer: by
#: the clock, pieces would shrink to single rows on a busy machine, and rows side by side take less.
PIECE = 256
LOOK = 0.1

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
    the same contents: a plan that arrives as another is refused. What had to be assumed, and members that are not possible, are a
    :class:`polhode.PolhodeWarning` where a plan is read, and in ``findings``.
    """

    __slots__ = ("_native",)

    def __init__(self, source: str | os.PathLike[str]) -> None:
        if isinstance(source, str) and "\n" in source:
            self._native = _native.Plan.parse(_arrays.text("source", source), "plan.toml")
        else:
            self._native = _native.Plan.read(_arrays.path("source", source))
        warn_of(self.findings)

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

    def __eq__(self, other: object) -> bool:
        """Equal are plans with the same results, whatever they are called."""
        return self.digest == other.digest if isinstance(other, Plan) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.digest)

    def __repr__(self) -> str:
        return f"Plan({self.members} members, {', '.join(variable.name for variable in self.variables) or 'nothing'} varied)"

    def __reduce__(self) -> tuple[Any, ...]:
        sent = self.text, os.path.abspath(self._native.path), self.digest
        return _arrived, (type(self), *sent), getattr(self, "__dict__", None)


def _arrived(kind: type[Plan], text: str, path: str, digest: str) -> Plan:
    """A plan that was sent, and what a subclass has added comes later."""
    plan = object.__new__(kind)
    plan._native = _read(text, path, digest)
    return plan


@lru_cache(maxsize=8)
def _read(text: str, path: str, digest: str) -> _native.Plan:
    """A process reads a plan once."""
    plan = _native.Plan.parse(text, path)
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

    A member without a body or a motion, and one whose computation fails, is a row that says so in ``status`` and ``cause``. A further
    column with the name of one of these is refused.
    """
    plan = _plan(plan)
    names = _names(plan)
    _require(rows, plan, names)
    none = [(name, np.empty(0, np.float64 if name != "member" else np.uint64)) for name in names]
    results = [name for name, *_ in plan._native.simulate(none)]
    for name in rows.schema.names:
        if name in results and name not in names:
            hint = f"rename it, or leave it out: rows.select({names})"
            raise PolhodeError(f"rows have a column {name} already, and it is what becomes of them that is called so", hint)
    found: Any = _mapped(rows, plan, names, plan._native.simulate)
    for field, column in zip(rows.schema, rows.columns):
        if field.name not in names:
            found = found.append_column(field, column)
    return found


def trajectories(rows: Rows, plan: Plan) -> Rows:
    """The motions of the rows' members: a row for each sample time."""
    names = _names(_plan(plan))
    _require(rows, plan, names)
    return _mapped(rows, plan, names, plan._native.trajectories)


def compute(plan: Plan, start: int, stop: int) -> tuple[pa.RecordBatch, pa.RecordBatch | None]:
    """What becomes of the members from ``start`` up to ``stop``, and their trajectories if the plan wants them: a part of a sweep."""
    members = inputs(plan, range(start, stop))
    return simulate(members, plan), trajectories(members, plan) if plan.wants_trajectories else None


def _plan(plan: Plan) -> Plan:
    if not isinstance(plan, Plan):
        raise TypeError(f"plan must be a Plan, not {type(plan).__name__}: polhode.batch.Plan reads one")
    return plan


def _names(plan: Plan) -> list[str]:
    """The columns of inputs."""
    return ["member", *(variable.name for variable in plan.variables)]


def _require(rows: Any, plan: Plan, names: list[str]) -> None:
    """Refuses what is no table of a plan's inputs."""
    if not isinstance(rows, (pa.RecordBatch, pa.Table)):
        raise TypeError(
            f"rows must be a pyarrow RecordBatch or Table, not {type(rows).__module__}.{type(rows).__name__}: "
            "pyarrow.Table.from_pandas and DataFrame.to_arrow make one"
        )
    for name, unit in zip(names, ["", *(variable.unit for variable in plan.variables)]):
        found = rows.schema.get_all_field_indices(name)
        if not found:
            raise PolhodeError(f"there is no column {name}", f"a row has {', '.join(names)}")
        if len(found) > 1:
            raise PolhodeError(f"there are {len(found)} columns {name}")
        said = ((rows.schema.field(found[0]).metadata or {}).get(b"unit") or b"").decode(errors="replace")
        if said and said != unit:
            raise PolhodeError(f"column {name} is in {said}, as its field says, and must be in {unit or 'no unit'}")


def _mapped(rows: Any, plan: Plan, names: list[str], function: Any) -> Any:
    """A function of columns, piece by piece: Python looks for signals between them."""
    columns = [(name, _numbers(name, rows)) for name in names]
    start, size = 0, 1
    done: list[pa.RecordBatch] = []
    while start < rows.num_rows or not done:
        began = time.thread_time()
        done.append(_arrow(function([(name, numbers[start : start + size]) for name, numbers in columns])))
        start += size
        size = min(2 * size, PIECE) if time.thread_time() - began < 0.5 * LOOK else max(size // 2, 1)
    # Where the pieces are cut is a matter of time, and nobody's result.
    whole = pa.concat_batches(done)
    return pa.Table.from_batches([whole]) if isinstance(rows, pa.Table) else whole


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
