"""Bodies of a robot model: groups that fixed joints connect, and a table of all links."""

from __future__ import annotations

import copy
import json
import os
from dataclasses import dataclass
from typing import Any, Iterator, Mapping

import numpy as np

from . import _arrays, _html, _native
from ._arrays import Floats
from ._mass_properties import Finding, MassProperties, findings_of, warn_of
from ._public import public
from ._record import Record
from ._table import NoArray


def positions(joints: object) -> list[tuple[str, float | str]]:
    """Converts joint values by name: numbers in rad or m, or texts with units."""
    if not isinstance(joints, (Mapping, type(None))):
        raise TypeError(f"joints must be a dict of numbers by name, not {type(joints).__name__}")

    def value(name: str, given: object) -> float | str:
        place = f"joints[{name!r}]"
        # The unit depends on whether the joint is revolute or prismatic.
        given = _arrays.as_text(place, given)
        return given if isinstance(given, str) else _arrays.number(place, given)

    return [(_arrays.text("the name of a joint", name), value(name, given)) for name, given in (joints or {}).items()]


def fixed_groups(path: str | os.PathLike[str]) -> dict[str, MassProperties]:
    """Computes the bodies of the groups of links that fixed joints connect, in a robot model.

    The file may be URDF, SDF, MJCF, USD or OpenSim. Groups without mass are omitted.

    Each body is in the frame of its first link, the one nearest the root, and has the name of that
    link.

    Parameters
    ----------
    path
        Path of the model file.

    Returns
    -------
    dict
        A body for each group, by the name of its first link.

    Raises
    ------
    PolhodeError
        If the file is not a robot model, or a link has an unphysical inertia.

    Examples
    --------
    >>> import pathlib, tempfile, polhode
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "arm.urdf"
    >>> inertial = '<inertial><mass value="2"/><inertia ixx="0.2" iyy="0.3" izz="0.4" ixy="0" ixz="0" iyz="0"/></inertial>'
    >>> _ = path.write_text(f'''<robot name="arm"><link name="base">{inertial}</link><link name="arm">{inertial}</link><link name="hand">{inertial}</link>
    ...     <joint name="elbow" type="revolute"><parent link="base"/><child link="arm"/></joint>
    ...     <joint name="flange" type="fixed"><parent link="arm"/><child link="hand"/><origin xyz="0.5 0 0"/></joint></robot>''')
    >>> {name: body.mass for name, body in polhode.fixed_groups(path).items()}
    {'base': 2.0, 'arm': 4.0}
    """
    groups = _native.robot_groups(_arrays.path("path", path))
    bodies = {name: MassProperties._of(body) for name, body in groups}
    for body in list(bodies.values())[:1]:  # findings of the file, reported once
        body._heard()
    return bodies


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class LinkRow(Record):
    """Mass properties of a link, in its own frame."""

    #: Name of the link.
    link: str
    #: Kinds of its shapes, such as ``"box"`` or ``"mesh"``.
    shapes: list[str]
    #: Mass, kg; 0 for a link without mass, which has no tensor either.
    mass: float
    #: Centre of mass (3,), link frame, m; ``None`` without mass.
    center_of_mass: Floats | None
    #: Inertia tensor about the centre of mass (3, 3), link axes, kg·m²; ``None`` without mass.
    inertia: Floats | None
    #: Principal moments (3,), ascending, kg·m²; ``None`` without mass.
    moments: Floats | None

    def __repr__(self) -> str:
        return f"LinkRow({self.link!r}, {self.mass:.6g} kg)"


@public("polhode.results")
class LinkTable(NoArray):
    """Mass properties of all links of a robot, in the order of the file, and of the whole robot.

    It is a sequence of ``rows``.
    """

    _instead = "use to_csv() with pandas.read_csv, or rows"

    def __init__(self, path: str, table: dict[str, Any], text: str, csv: str, findings: list[Finding]) -> None:
        self.path = path
        self._table = table
        self._text = text
        self._csv = csv
        self._findings = findings

    @property
    def rows(self) -> list[LinkRow]:
        """Rows of the links."""
        return [_row(link) for link in self._table["links"]]

    @property
    def whole(self) -> LinkRow:
        """All links together, in the frame of the model; its name is empty."""
        return _row({"link": "", "shapes": [], "massless": False, **self._table["whole"]})

    @property
    def findings(self) -> list[Finding]:
        """Findings, such as a joint beyond its limits, or elements that were not read."""
        return list(self._findings)

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode inertia --table --json`` prints.

        Its keys are stable.
        """
        return copy.deepcopy(self._table)

    def to_csv(self) -> str:
        """Returns the table that ``polhode inertia --table --csv`` prints."""
        return self._csv

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, LinkTable):
            return NotImplemented
        return (self.path, self._table, self._findings) == (other.path, other._table, other._findings)

    #: Not hashable, because ``path`` can be changed.
    __hash__ = None  # type: ignore[assignment]

    def __getitem__(self, which: Any) -> Any:
        """Returns a link by its index or name, or several by a slice."""
        if isinstance(which, str):
            for row in self:
                if row.link == which:
                    return row
            raise KeyError(f"{which!r} is not one of {', '.join(row.link for row in self)}")
        return self.rows[which]

    def __iter__(self) -> Iterator[LinkRow]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self._table["links"])

    def __repr__(self) -> str:
        return f"LinkTable({self.path!r}: {len(self)} links, {self.whole.mass:.6g} kg)"

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        def numbers(row: LinkRow) -> list[str]:
            known = () if row.center_of_mass is None or row.moments is None else (*row.center_of_mass, *row.moments)
            return [_html.number(row.mass), *map(_html.number, known)] + [""] * (6 - len(known))

        lines = [*((row.link, numbers(row)) for row in self), ("together", numbers(self.whole))]
        head = ["mass, kg", "x, m", "y, m", "z, m", "i1, kg·m²", "i2", "i3"]
        return f"<div>{_html.rows(head, lines)}</div>"


def link_table(path: str | os.PathLike[str], *, joints: Mapping[str, float | str] | None = None) -> LinkTable:
    """Computes mass, centre and inertia of each link of a robot model, and of the whole robot.

    The whole robot has its joints at the given values.

    Parameters
    ----------
    path
        Path of the model file.
    joints
        Joint values by name, in rad or m, or as ``"30 deg"``. Mimic joints follow their joint, and
        all other joints are at zero.

    Returns
    -------
    LinkTable
        A row for each link, in the order of the file.

    Raises
    ------
    PolhodeError
        If the file is not a robot model, or does not have such a joint.

    Examples
    --------
    >>> import pathlib, tempfile, polhode
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "arm.urdf"
    >>> inertial = '<inertial><mass value="2"/><inertia ixx="0.2" iyy="0.3" izz="0.4" ixy="0" ixz="0" iyz="0"/></inertial>'
    >>> _ = path.write_text(f'''<robot name="arm"><link name="base">{inertial}</link><link name="arm">{inertial}</link><link name="tip"/>
    ...     <joint name="rail" type="prismatic"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/></joint>
    ...     <joint name="flange" type="fixed"><parent link="arm"/><child link="tip"/></joint></robot>''')
    >>> table = polhode.link_table(path, joints={"rail": "30 cm"})
    >>> [(row.link, row.mass) for row in table]
    [('base', 2.0), ('arm', 2.0), ('tip', 0.0)]
    >>> table.whole.center_of_mass.round(6).tolist()
    [0.0, 0.15, 0.0]
    """
    name = _arrays.path("path", path)
    table, text, csv, remarks = _native.robot_table(name, positions(joints))
    findings = findings_of(remarks)
    warn_of(findings)
    return LinkTable(name, json.loads(table), text, csv, findings)


def _row(link: Mapping[str, Any]) -> LinkRow:
    if link["massless"]:
        return LinkRow(link["link"], list(link["shapes"]), 0.0, None, None, None)
    center, tensor, moments = (
        np.array(numbers, dtype=np.float64)
        for numbers in (link["center_of_mass"], link["inertia"]["tensor"], link["principal"]["moments"])
    )
    return LinkRow(link["link"], list(link["shapes"]), link["mass"], center, tensor, moments)
