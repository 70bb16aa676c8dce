"""A body of named parts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy.typing as npt

from . import _arrays, _html
from ._error import PolhodeError
from ._mass_derivatives import BodyDerivatives, body_derivatives
from ._mass_properties import IDENTITY, MassProperties, joined
from ._public import public
from ._table import NoArray


@public()
class Body(NoArray, Mapping[str, MassProperties]):
    """Named parts, rigidly joined: a mapping from names to mass properties in the body's frame.

    Parameters
    ----------
    parts
        Mass properties or bodies by name, each at its place in the body.

    Raises
    ------
    PolhodeError
        If there are no parts.
    TypeError
        If a part is not :class:`MassProperties` or a :class:`Body`, or a name is not text.

    Examples
    --------
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
    >>> list(hammer), "claw" in hammer
    (['head', 'handle'], False)
    """

    _instead = "its numbers are in its parts and in mass_properties"

    def __init__(self, parts: Mapping[str, MassProperties | Body]) -> None:
        if not isinstance(parts, Mapping):
            raise TypeError(f"parts must be a dict of MassProperties by name, not {type(parts).__name__}")
        self._parts = {_arrays.text("the name of a part", name): whole(f"part {name!r}", part) for name, part in parts.items()}
        if not parts:
            raise PolhodeError("a body has at least one part")
        self._whole = joined(list(self._parts.values()))

    @property
    def parts(self) -> dict[str, MassProperties]:
        """Parts by name, each at its place in the body."""
        return dict(self._parts)

    @property
    def mass_properties(self) -> MassProperties:
        """Mass properties of all parts together."""
        return self._whole

    def placed(self, *, position: npt.ArrayLike = (0.0, 0.0, 0.0), rotation: object = IDENTITY) -> Body:
        """Returns the body with all parts moved; see :meth:`MassProperties.placed`.

        Parameters
        ----------
        position
            New position of the body's origin (3,), m.
        rotation
            Rotation from present components to new ones: a quaternion (w, x, y, z), a matrix
            (3, 3), a ``scipy.spatial.transform.Rotation``, or a form of scenario files.

        Returns
        -------
        Body
            The moved parts, under the same names.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.
        """
        return Body({name: part.placed(position=position, rotation=rotation) for name, part in self._parts.items()})

    def derivatives(self, *, about: Mapping[str, npt.ArrayLike] | None = None) -> BodyDerivatives:
        """Computes the derivatives of the mass properties by those of each part, in closed form.

        Parameters
        ----------
        about
            Points (3,), m, about which parts rotate, by the names of the parts. The default is the
            part's own centre of mass.

        Returns
        -------
        BodyDerivatives
            Arrays (10, n, …): derivatives by masses, densities, positions and rotations, and by the
            parts' own mass properties.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.

        Examples
        --------
        Moving the head outwards by 1 m moves the centre of mass by the head's share of the mass:

        >>> import polhode
        >>> from polhode import shapes
        >>> hammer = polhode.Body({
        ...     "head": shapes.box(size=[0.10, 0.03, 0.03], mass=0.7).placed(position=[0, 0, 0.3]),
        ...     "handle": shapes.cylinder(radius=0.012, length=0.3, mass=0.1).placed(position=[0, 0, 0.15]),
        ... })
        >>> derivatives = hammer.derivatives()
        >>> derivatives.by_positions.shape
        (10, 2, 3)
        >>> derivatives.by_positions[derivatives.rows.index("center_z"), 0, 2].round(12)
        np.float64(0.875)
        """
        if about is not None and not isinstance(about, Mapping):
            raise TypeError(f"about must be a dict of points by names of parts, not {type(about).__name__}")
        points = {}
        for name, point in (about or {}).items():
            if name not in self._parts:
                raise PolhodeError(f"about has {name!r}, which is not a part", f"known parts: {', '.join(self._parts)}")
            points[name] = _arrays.triple(f"about[{name!r}]", point)
        return body_derivatives(self._parts, self._whole, points)

    def __getitem__(self, name: str) -> MassProperties:
        """Returns the part of this name."""
        return self._parts[name]

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


def is_body(value: object) -> bool:
    """Returns true for what every argument that is a body accepts."""
    return isinstance(value, (MassProperties, Body))


def whole(name: str, value: object) -> MassProperties:
    """Converts a body to its mass properties."""
    if isinstance(value, Body):
        return value.mass_properties
    if not isinstance(value, MassProperties):
        raise TypeError(f"{name} must be MassProperties or a Body, not {_arrays.kind_of(value)}")
    return value
