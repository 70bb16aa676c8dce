"""Sources other than paths: meshes of other libraries, triangles, open files."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from . import _arrays, _units
from ._arrays import Floats
from ._error import PolhodeError
from ._mass_properties import MassProperties, rebuilt

#: Accepted sources, for messages.
KNOWN = (
    "a path, an open file, a mesh as the tuple (vertices, triangles), an object that has vertices and faces, such as a trimesh.Trimesh, "
    "or triangles (n, 3, 3)"
)


#: Number of bytes read or written between two checks for Ctrl-C.
PIECE = 1 << 23


def mesh_of(source: Any) -> tuple[object, object] | Floats | None:
    """Returns vertices and triangles, or triangles given by their corners (n, 3, 3); ``None`` for a
    path or an open file."""
    # A closed mesh has more than two triangles, so a pair is vertices and indices.
    kind = type(source)
    if kind is tuple and len(source) == 2:
        return source[0], source[1]
    if isinstance(source, (str, os.PathLike)) or hasattr(source, "read"):
        return None
    if hasattr(source, "vertices"):
        for name in ("faces", "triangles"):
            if hasattr(source, name):
                vertices = source.vertices if _units.has_units(source.vertices) else np.asarray(source.vertices)
                return vertices, np.asarray(getattr(source, name))
    if _units.has_units(source) and not (isinstance(source, (tuple, list)) and len(source) == 2):
        source = _arrays.real("source", source)
    if isinstance(source, (tuple, list)) and len(source) == 2:
        return source[0], source[1]
    if isinstance(source, tuple):
        raise PolhodeError(f"source is a tuple of {len(source)}, but a mesh must be (vertices, triangles)")
    if isinstance(source, (list, np.ndarray)):
        corners = _arrays.numbers("source", source, ("n", 3, 3))
        if not len(corners):
            raise PolhodeError("source has no triangles")
        return corners
    more = ": give its whole mesh, scene.to_mesh()" if type(source).__name__ == "Scene" else ""
    raise TypeError(f"source must be {KNOWN}, not {type(source).__name__}{more}")


def has_units_of_length(source: Any) -> bool:
    """Returns true if vertices or corners are quantities with a unit."""
    return _units.has_units(source) or _units.has_units(getattr(source, "vertices", None))


def unit_of(source: Any) -> str | None:
    """Returns the unit of length of a mesh, if it has one."""
    unit = getattr(source, "units", None)
    return unit if isinstance(unit, str) else None


def read(source: Any, format: str | None, function: Callable[[str], MassProperties]) -> MassProperties:
    """Reads a body from an open file through a temporary file, whose path is removed from messages
    and results."""
    given = getattr(source, "name", None)
    name = Path(given).name if isinstance(given, str) and given else "file"
    ending = Path(name).suffix if format is None else f".{_arrays.text('format', format).lstrip('.')}"
    if not ending:
        raise PolhodeError("the open file has no name, so its format is unknown", 'give the extension: format="stl"')
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{Path(name).stem}{ending}"
        with open(path, "wb") as file:
            for data in _pieces(source):
                file.write(data)
        hidden = f"{folder}{os.sep}"
        try:
            body = function(str(path))
        except PolhodeError as error:
            raise PolhodeError(*_without(hidden, error.args)) from None
        except FileNotFoundError as error:  # a file to which the source refers
            raise FileNotFoundError(error.errno, *_without(hidden, (error.strerror, error.filename))) from None
        return rebuilt(MassProperties, _without(hidden, body._native.state()))


def _pieces(source: Any) -> Iterator[bytes | bytearray | memoryview]:
    """Yields the contents of an open file in pieces. Python checks for Ctrl-C between them."""
    # An object that has only ``read()`` may not accept a size.
    pieces = iter(lambda: source.read(PIECE), None) if hasattr(source, "readable") else iter([source.read()])
    for data in pieces:
        if isinstance(data, str):
            data = data.encode()
        if not isinstance(data, (bytes, bytearray, memoryview)):
            raise TypeError(f"source.read() must give bytes or text, not {type(data).__name__}")
        if not len(data):
            break
        yield data


def _without(folder: str, value: Any) -> Any:
    """Returns the value without the folder in any text."""
    if isinstance(value, (tuple, list)):
        return type(value)(_without(folder, element) for element in value)
    return value.replace(folder, "") if isinstance(value, str) else value
