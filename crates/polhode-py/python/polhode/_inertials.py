"""Inertials of robot models from the geometry of their links."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Iterator

import numpy as np

from . import _arrays, _html, _native
from ._arrays import Floats
from ._error import PolhodeError, in_python
from ._public import public
from ._record import Record
from ._substance import given, of_parts
from ._units import Quantity


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class LinkInertial(Record):
    """New inertial of a link, in its own frame, or the reason why it has none."""

    #: Name of the link.
    link: str
    #: Reason why no inertial is written; ``None`` if one is.
    why_not: str | None
    #: Mass, kg; ``None`` without a new inertial, as are the following.
    mass: float | None
    #: Centre of mass (3,), link frame, m.
    center_of_mass: Floats | None
    #: Inertia tensor about the centre of mass (3, 3), link axes, kg·m².
    inertia: Floats | None
    #: Geometry that was used, ``"visual"`` or ``"collision"``, and the reason for it.
    geometry: str | None
    reason: str | None
    #: Origin of the mass, such as ``"kept"`` or ``"2700 kg/m³"``.
    mass_by: str | None
    #: Bound on the error of the moments, relative to the tensor.
    relative_error: float | None

    def __repr__(self) -> str:
        what = f"{self.mass:.6g} kg" if self.mass is not None else f"not written: {self.why_not}"
        return f"LinkInertial({self.link!r}, {what})"


@public("polhode.results")
class WrittenInertials:
    """Model with new inertials. It is a sequence of ``links``."""

    def __init__(self, path: str, text: str, report: dict[str, Any], words: str, ok: bool) -> None:
        self.path = path
        #: Text of the new model. All bytes outside of the inertials are those of the file.
        self.text = text
        #: True if no link is left without an inertial.
        self.ok = ok
        self._report = report
        self._words = words

    @property
    def links(self) -> list[LinkInertial]:
        """Chosen links, in the order of the file."""
        return [_link(link) for link in self._report["links"]]

    @property
    def diff(self) -> str:
        """Unified diff from the file to the new model, for ``patch -p1``."""
        diff: str = self._report["diff"]
        return diff

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode inertia --write-inertials --json`` prints.

        Its keys are stable.
        """
        return copy.deepcopy(self._report)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, WrittenInertials):
            return NotImplemented
        return (self.path, self.text, self._report) == (other.path, other.text, other._report)

    #: Not hashable, because ``path`` can be changed.
    __hash__ = None  # type: ignore[assignment]

    def __getitem__(self, which: Any) -> Any:
        """Returns a link by its index or name, or several by a slice."""
        if isinstance(which, str):
            for link in self:
                if link.link == which:
                    return link
            raise KeyError(f"{which!r} is not one of {', '.join(link.link for link in self)}")
        return self.links[which]

    def __iter__(self) -> Iterator[LinkInertial]:
        return iter(self.links)

    def __len__(self) -> int:
        return len(self._report["links"])

    def __repr__(self) -> str:
        written = sum(link.why_not is None for link in self)
        return f"WrittenInertials({self.path!r}: {written} of {len(self)} links)"

    def __str__(self) -> str:
        return self._words

    def _repr_html_(self) -> str:
        def words(link: LinkInertial) -> list[str]:
            if link.mass is None:
                return ["", "", f"not written: {link.why_not}"]
            return [_html.number(link.mass), str(link.mass_by), f"{link.geometry}: {link.reason}"]

        return f"<div>{_html.rows(['link', 'mass, kg', 'mass by', 'geometry'], [(link.link, words(link)) for link in self])}</div>"


def write_inertials(
    path: str | os.PathLike[str],
    *,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
    parts: Mapping[str, str | Mapping[str, Any]] | None = None,
    link: str | None = None,
    only: str | None = None,
    geometry: str | None = None,
    roots: Sequence[str | os.PathLike[str]] = (),
) -> WrittenInertials:
    """Computes the inertial of each link of a robot model from its geometry, and writes it into the
    text.

    The model may be URDF, SDF, MJCF or USD. The file is not changed: the result has the new text
    and its diff. Each link keeps its mass unless an argument gives another one. Shapes that overlap
    count once. A link is left as it is if its geometry bounds no solid, if it has no mass, or if
    its new inertial has a finding of :func:`check`.

    Parameters
    ----------
    path
        Path of the model file.
    density, mass, material
        Density of all links, kg/m³; or their total mass, kg, which is distributed by volume; or
        their material. At most one.
    parts
        Substances by name: of links, also by a pattern, and of shapes or mesh parts as
        ``"LINK/PART"``: ``{"arm*": "steel", "hand": {"mass": 1.2}, "hand/grip": {"density": 950}}``.
    link
        Name of the link that is written, or a pattern with ``*`` and ``?``. By default, all links.
    only
        ``"missing"`` for links without an inertial, ``"suspect"`` for those with a suspect or
        impossible finding, ``"impossible"`` for those with an impossible one.
    geometry
        ``"visual"`` or ``"collision"``. By default, the more detailed one that bounds a solid.
    roots
        Folders that contain the packages to which the model refers.

    Returns
    -------
    WrittenInertials
        The new text, its diff, and a row for each chosen link.

    Raises
    ------
    PolhodeError
        If the file is not a robot model, a name matches nothing, or arguments contradict each
        other.

    Examples
    --------
    >>> import pathlib, tempfile, polhode
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "arm.urdf"
    >>> _ = path.write_text('''<robot name="arm"><link name="hand">
    ...   <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link></robot>''')
    >>> written = polhode.write_inertials(path, density=500.0)
    >>> round(written["hand"].mass, 12), written["hand"].inertia[0, 0].round(12).item()
    (3.0, 0.0325)
    >>> written["hand"].reason
    '1 shape; no visual'
    >>> _ = path.with_name("new.urdf").write_text(written.text)
    >>> polhode.check(path.with_name("new.urdf")).ok
    True
    """
    name = _arrays.path("path", path)
    if isinstance(roots, (str, os.PathLike, Mapping)) or not isinstance(roots, Iterable):
        raise TypeError(f"roots must be a list of folders, not {type(roots).__name__}")
    whole = given(density=density, mass=mass, material=material)
    request = {
        "file": name,
        "root": [_arrays.path(f"roots[{k}]", root) for k, root in enumerate(roots)],
        "link": None if link is None else _arrays.text("link", link),
        "only": None if only is None else _arrays.choice("only", only, ["missing", "suspect", "impossible"]),
        "geometry": None if geometry is None else _arrays.choice("geometry", geometry, ["visual", "collision"]),
        **{key: whole[key] for key in ("density", "mass", "material")},
        "part": [f"{part}={_in_words(part, what)}" for part, what in of_parts(parts)],
    }
    text, report, words, is_incomplete = _native.robot_inertials(json.dumps(request))
    return WrittenInertials(name, text, json.loads(report), in_python(words), not is_incomplete)


def _in_words(part: str, what: Mapping[str, Any]) -> str:
    """Returns the substance of a part as the option of the command has it."""
    if what["density"] is not None:
        return f"{what['density']!r} kg/m^3"
    if what["mass"] is not None:
        return f"{what['mass']!r} kg"
    if what["material"] not in dict(_native.materials()):
        raise PolhodeError(f"parts[{part!r}]: no such material: {what['material']!r}", "polhode.materials() lists them")
    return str(what["material"])


def _link(link: Mapping[str, Any]) -> LinkInertial:
    if not link["written"]:
        return LinkInertial(link["link"], in_python(link["why_not"]), *[None] * 7)
    center, tensor = (np.array(link[key], dtype=np.float64) for key in ("center_of_mass_m", "tensor_kg_m2"))
    words = (link["geometry"], link["reason"], link["mass_by"])
    return LinkInertial(link["link"], None, link["mass_kg"], center, tensor, *words, link["relative_error"])
