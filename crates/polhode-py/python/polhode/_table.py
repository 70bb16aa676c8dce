"""Results as tables for pandas, Polars, PyArrow and xarray."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, NoReturn

import numpy as np
import numpy.typing as npt

from . import _html

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow
    import xarray


class Column(NamedTuple):
    """A column of a table."""

    #: Name, with the unit as suffix.
    name: str
    #: Unit in SI symbols; ``1`` for a pure number.
    unit: str
    #: Description of the quantity.
    description: str
    #: Values, one for each row.
    values: npt.NDArray[Any]


class Variable(NamedTuple):
    """An array with named dimensions."""

    name: str
    dimensions: tuple[str, ...]
    unit: str
    description: str
    values: npt.NDArray[Any]


#: Number of rows at either end of a long table that a notebook shows.
SHOWN = 4


class NoArray:
    """A result that has a length but is not an array.

    NumPy would convert it to an array of objects, and pandas to a table without its columns.
    """

    __slots__ = ()

    #: Advice on how to obtain its numbers.
    _instead: ClassVar[str]

    def __array__(self, dtype: object = None, copy: object = None) -> NoReturn:
        name = type(self).__name__
        raise TypeError(f"{'an' if name[0] in 'AEIOU' else 'a'} {name} is not an array: {self._instead}")


class Table(NoArray):
    """A result with columns.

    Tables of other libraries are copies. Fields of Arrow and variables of xarray have units and
    descriptions.
    """

    __slots__ = ()

    _instead = "use to_pandas() for a DataFrame, or columns() for arrays by name"

    def _table(self) -> list[Column]:
        """Returns the columns, with values that no other object shares."""
        raise NotImplementedError

    def _variables(self) -> list[Variable]:
        """Returns arrays along times and vector components.

        Those with the name of a dimension are its coordinates.
        """
        raise NotImplementedError

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """Returns the arrays by name, with units in the names, as for ``DataFrame``."""
        return {column.name: column.values for column in self._table()}

    def to_pandas(self) -> pandas.DataFrame:
        """Returns the columns as a pandas ``DataFrame``."""
        return _needed("pandas", "to_pandas").DataFrame(self.columns())

    def to_polars(self) -> polars.DataFrame:
        """Returns the columns as a Polars ``DataFrame``."""
        return _needed("polars", "to_polars").DataFrame(self.columns())

    def to_arrow(self) -> pyarrow.Table:
        """Returns the columns as a PyArrow ``Table``.

        Units and descriptions are the metadata of its fields.
        """
        pa = _needed("pyarrow", "to_arrow")
        columns = self._table()
        arrays = [pa.array(column.values) for column in columns]
        fields = [
            pa.field(column.name, array.type, False, {"unit": column.unit, "description": column.description})
            for column, array in zip(columns, arrays)
        ]
        return pa.Table.from_arrays(arrays, schema=pa.schema(fields))

    def to_xarray(self) -> xarray.Dataset:
        """Returns an xarray ``Dataset``.

        Its dimensions are ``time`` (s), ``axis`` (x, y, z) for vectors and ``component``
        (w, x, y, z) for quaternions.
        """
        xr = _needed("xarray", "to_xarray")
        variables = self._variables()
        of = {
            variable.name: (variable.dimensions, variable.values, {"units": variable.unit, "long_name": variable.description})
            for variable in variables
        }
        named = {dimension for variable in variables for dimension in variable.dimensions}
        axes = {name: list(labels) for name, labels in (("axis", "xyz"), ("component", "wxyz")) if name in named}
        coordinates = {name: value for name, value in of.items() if name in named}
        return xr.Dataset({name: value for name, value in of.items() if name not in named}, coords={**coordinates, **axes})

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """Returns an Arrow stream for libraries that import tables without a copy, such as
        ``polars.DataFrame(motion)`` or ``duckdb``. Requires PyArrow."""
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def _repr_html_(self) -> str:
        table = self._table()
        count = len(table[0].values)
        shown = range(count) if count <= 2 * SHOWN + 1 else [*range(SHOWN), -1, *range(count - SHOWN, count)]
        lines = ((str(k), [_html.number(column.values[k]) for column in table]) if k >= 0 else ("⋮", ["⋮"] * len(table)) for k in shown)
        return f"<div>{_html.rows([column.name for column in table], lines)}<p>{count} rows</p></div>"


def _needed(name: str, method: str) -> Any:
    try:
        return import_module(name)
    except ImportError as error:
        raise ImportError(f"{method} needs {name}: pip install {name}") from error


def vector(name: str, unit: str, description: str, values: npt.NDArray[Any], axes: str = "xyz") -> list[Column]:
    """Returns a column for each component of vectors (…, 3) or quaternions (…, 4).

    ``{}`` in the name is replaced by the component.
    """
    rows = values.reshape(-1, len(axes))
    return [Column(name.format(axis), unit, description, rows[:, k].copy()) for k, axis in enumerate(axes)]
