"""Comparison of two models of one robot."""

from __future__ import annotations

import copy
import json
import os
from typing import Any, Iterable, Iterator, Mapping, NamedTuple, Sequence

from . import _arrays, _html, _native
from ._error import in_python
from ._public import public


@public("polhode.results")
class ModelDifference(NamedTuple):
    """A difference of two models, or a note about them."""

    #: Stable identifier for programs, such as ``"compare.mass"``.
    code: str
    #: Link or joint of the second model; empty if it concerns the whole model.
    link: str
    #: Further links of a sum or of a group.
    others: list[str]
    #: Description with both values.
    message: str
    #: Numbers by name, SI units; ``None`` for a number that cannot be read.
    numbers: dict[str, float | None]
    #: File, line and column in the first model, from 1; ``None`` without a counterpart.
    a: dict[str, Any] | None
    #: File, line and column in the second model.
    b: dict[str, Any] | None


@public("polhode.results")
class Comparison:
    """Differences of two models, in the order of the second file.

    The comparison is a sequence of ``differences``.
    """

    def __init__(self, report: dict[str, Any], text: str) -> None:
        self._report = report
        self._text = text

    @property
    def differences(self) -> list[ModelDifference]:
        """Differences beyond the tolerance."""
        return [ModelDifference(**found) for found in self.to_dict()["differences"]]

    @property
    def notes(self) -> list[ModelDifference]:
        """Facts that do not count as differences.

        Examples are another zero or another name of a joint, and links without a partner.
        """
        return [ModelDifference(**found) for found in self.to_dict()["notes"]]

    @property
    def equal(self) -> bool:
        """True if the models agree within the tolerance."""
        return bool(self._report["equal"])

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode compare --json`` prints. Its keys are stable."""
        return copy.deepcopy(self._report)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Comparison):
            return NotImplemented
        return self._report == other._report

    #: Not hashable, because the report is a dict.
    __hash__ = None  # type: ignore[assignment]

    def __getitem__(self, which: Any) -> Any:
        """Returns the difference at an index, or several for a slice."""
        return self.differences[which]

    def __iter__(self) -> Iterator[ModelDifference]:
        return iter(self.differences)

    def __len__(self) -> int:
        return len(self._report["differences"])

    def __repr__(self) -> str:
        a, b = (self._report[side]["file"] for side in ("a", "b"))
        return f"Comparison({a!r}, {b!r}: {len(self)} difference{'' if len(self) == 1 else 's'})"

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        lines = (("suspect", [found.link, found.code, found.message]) for found in self.differences)
        return f"<div>{_html.rows(['link', 'rule', 'what'], lines)}</div>"


def compare(
    a: str | os.PathLike[str],
    b: str | os.PathLike[str],
    *,
    tolerance: float = 1e-6,
    map: str | os.PathLike[str] | None = None,
    roots: Sequence[str | os.PathLike[str]] = (),
) -> Comparison:
    """Compares two models of one robot link by link, also in different languages.

    The mass, the centre of mass and the inertia tensor of each link, and the type and the axis of
    each joint. Links merged by fixed joints, other link frames, other joint zeros and another place
    of the base do not count as differences.

    Parameters
    ----------
    a
        Path of the first model: URDF, SDF, MJCF, USD or OpenSim.
    b
        Path of the second model.
    tolerance
        Largest relative difference of equal numbers.
    map
        Path of a TOML file with names that differ: tables ``[links]`` and ``[joints]`` of
        ``"name in a" = "name in b"``.
    roots
        Folders that contain the packages to which the models refer.

    Returns
    -------
    Comparison
        Differences, each with both places and both values, and notes.

    Raises
    ------
    PolhodeError
        If a file is not a robot model, or has numbers that cannot be compared.

    Examples
    --------
    >>> import pathlib, tempfile, polhode
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> text = '''<robot name="arm"><link name="hand"><inertial><mass value="2"/>
    ...     <inertia ixx="0.1" iyy="0.2" izz="0.25" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'''
    >>> _ = (folder / "old.urdf").write_text(text)
    >>> _ = (folder / "new.urdf").write_text(text.replace('"2"', '"2.1"'))
    >>> for found in polhode.compare(folder / "old.urdf", folder / "new.urdf"):
    ...     print(found.link, found.code, found.numbers)
    hand compare.mass {'a': 2.0, 'b': 2.1}
    """
    first, second = _arrays.path("a", a), _arrays.path("b", b)
    limit = _arrays.positive("tolerance", tolerance)
    names = None if map is None else _arrays.path("map", map)
    if isinstance(roots, (str, os.PathLike, Mapping)) or not isinstance(roots, Iterable):
        raise TypeError(f"roots must be a list of folders, not {type(roots).__name__}")
    folders = [_arrays.path(f"roots[{k}]", root) for k, root in enumerate(roots)]
    report, text = _native.compare_files(first, second, limit, names, folders)
    return Comparison(json.loads(report), in_python(text))
