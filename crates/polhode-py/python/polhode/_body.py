"""A body of named parts."""

from __future__ import annotations

from typing import Iterator, Mapping

from . import _arrays, _html
from ._error import PolhodeError
from ._mass_properties import MassProperties, joined


class Body:
    """Parts with names, rigidly joined.

    >>> import polhode
    >>> from polhode import shapes
    >>> hammer = polhode.Body({
    ...     "head": shapes.box(size=[0.10, 0.03, 0.03], material="steel").placed(position=[0, 0, 0.3]),
    ...     "handle": shapes.cylinder(radius=0.012, length=0.3, material="oak").placed(position=[0, 0, 0.15]),
    ... })
    >>> round(hammer.mass_properties.mass, 4)
    0.8083
    >>> hammer["head"].mass > hammer["handle"].mass
    True
    """

    def __init__(self, parts: Mapping[str, MassProperties]) -> None:
        if not isinstance(parts, Mapping):
            raise TypeError(f"parts must be a dict of MassProperties by name, not {type(parts).__name__}")
        for name, part in parts.items():
            _arrays.text("the name of a part", name)
            if not isinstance(part, MassProperties):
                raise TypeError(f"part {name!r} must be MassProperties, not {type(part).__name__}")
        if not parts:
            raise PolhodeError("a body has at least one part")
        self._parts = dict(parts)
        self._whole = joined(list(self._parts.values()))

    @property
    def parts(self) -> dict[str, MassProperties]:
        """The parts by name, where they are placed."""
        return dict(self._parts)

    @property
    def mass_properties(self) -> MassProperties:
        """All parts together."""
        return self._whole

    def __getitem__(self, name: str) -> MassProperties:
        """The part of a name."""
        return self._parts[name]

    def __contains__(self, name: object) -> bool:
        return name in self._parts

    def __iter__(self) -> Iterator[str]:
        return iter(self._parts)

    def __len__(self) -> int:
        return len(self._parts)

    def __repr__(self) -> str:
        return f"Body({', '.join(map(repr, self._parts))}; mass={self._whole.mass:.6g})"

    def _repr_html_(self) -> str:
        whole = self.mass_properties
        listed = [*self.parts.items(), ("together", whole)]
        table = _html.rows(
            ["mass, kg", "x, m", "y, m", "z, m", "i1, kg·m²", "i2", "i3"],
            (
                (name, [*map(_html.number, (part.mass, *part.center_of_mass, *part.moments))])
                for name, part in listed
            ),
        )
        return f"<div>{table}{whole._repr_html_()}</div>"
