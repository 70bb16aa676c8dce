"""Mass, centre of mass and inertia."""

from __future__ import annotations

import json
from html import escape
from typing import Any, Iterable, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _html, _native
from ._arrays import Floats
from ._error import PolhodeError, in_python, warn

#: No turn, as a quaternion.
IDENTITY = (1.0, 0.0, 0.0, 0.0)


class Finding(NamedTuple):
    """Something that was noticed on the way to a body's mass properties."""

    #: A stable name for programs, such as ``"mass.assumed"``.
    code: str
    #: ``"info"``, ``"warning"`` or ``"error"``.
    severity: str
    #: What it is, in a sentence.
    message: str
    #: Where, if it has a place.
    place: str | None


def findings_of(remarks: Iterable[_native.Remark]) -> list[Finding]:
    """What Rust noticed, in the words of Python."""
    return [Finding(code, severity, in_python(message), place) for code, severity, message, place in remarks]


def warn_of(findings: Iterable[Finding]) -> None:
    """A :class:`PolhodeWarning` for each finding that is worth one."""
    for finding in findings:
        if finding.severity != "info":
            warn(f"{finding.message} [{finding.code}]")


class MassProperties:
    """A body's mass, centre of mass and inertia tensor.

    Parameters
    ----------
    mass
        Mass, kg.
    inertia
        The tensor (3, 3), or three moments about the body's axes, kg·m²: about the centre of mass, or about the point ``about``. Its off-diagonal
        elements are *minus* the integrals, I_xy = -∫xy dm, so that L = I ω.
    center_of_mass
        Body axes (3,), m.
    about
        The point that the tensor is about (3,), m; the centre of mass unless given.

    Raises
    ------
    PolhodeError
        Where there is no such body: a tensor that violates the triangle inequality, a mass that is not positive.

    Examples
    --------
    >>> import polhode
    >>> body = polhode.MassProperties(
    ...     mass=12.5,
    ...     center_of_mass=[-0.5, 0.5, 0.25],
    ...     inertia=[[10, 1, -1], [1, 5, 1], [-1, 1, 8]],
    ... )
    >>> body.moments.round(3)
    array([ 4.413,  8.113, 10.474])
    >>> body.about([0, 0, 0])[0, 1]
    np.float64(4.125)

    Bodies add up: ``a + b`` is both rigidly joined, ``a.placed(position=…)`` moves one first.
    """

    __slots__ = ("_native",)

    def __init__(
        self,
        *,
        mass: float,
        inertia: npt.ArrayLike,
        center_of_mass: npt.ArrayLike = (0.0, 0.0, 0.0),
        about: npt.ArrayLike | None = None,
    ) -> None:
        self._native = _native.MassProperties.of_tensor(
            _arrays.positive("mass", mass),
            _arrays.triple("center_of_mass", center_of_mass),
            _arrays.tensor("inertia", inertia),
            None if about is None else _arrays.triple("about", about),
        )

    @classmethod
    def _of(cls, native: _native.MassProperties) -> MassProperties:
        """What Rust made."""
        self = object.__new__(cls)
        self._native = native
        return self

    def _heard(self) -> MassProperties:
        """The same, with a warning for each of its findings that is worth one."""
        warn_of(self.findings)
        return self

    @property
    def mass(self) -> float:
        """Mass, kg."""
        return self._native.mass

    @property
    def center_of_mass(self) -> Floats:
        """Centre of mass from the origin, along body axes (3,), m."""
        return self._native.center_of_mass

    @property
    def inertia(self) -> Floats:
        """Inertia tensor about the centre of mass, along body axes (3, 3), kg·m²."""
        return self._native.inertia

    @property
    def moments(self) -> Floats:
        """Principal moments about the centre of mass (3,), ascending, kg·m²."""
        return self._native.moments

    @property
    def axes(self) -> Floats:
        """Principal axes as rows (3, 3): ``axes[k]`` is a unit vector in body components and belongs to ``moments[k]``; right-handed."""
        return self._native.axes

    @property
    def principal_rotation(self) -> Floats:
        """Rotation matrix R_body_principal (3, 3): takes principal components to body components.

        Column ``k`` is the principal axis of ``moments[k]``, and ``inertia = R @ np.diag(moments) @ R.T``. Its transpose takes body components to
        principal components. Right-handed: its determinant is 1.

        Examples
        --------
        >>> import numpy as np, polhode
        >>> body = polhode.MassProperties(mass=2.0, inertia=[[10, 1, -1], [1, 5, 1], [-1, 1, 8]])
        >>> R = body.principal_rotation
        >>> np.allclose(R @ np.diag(body.moments) @ R.T, body.inertia)
        True
        >>> omega = R @ [0.0, 3.0, 0.0]  # 3 rad/s about the intermediate axis, body components
        >>> np.allclose(body.inertia @ omega, body.moments[1] * omega)
        True
        """
        return np.ascontiguousarray(self._native.axes.T)

    @property
    def symmetry(self) -> str:
        """``spherical``, ``oblate``, ``prolate``, ``asymmetric``, ``rod`` or ``point``."""
        return self._native.symmetry

    @property
    def gyration_radii(self) -> Floats:
        """Radii of gyration about the principal axes, √(i/m) (3,), m."""
        return self._native.gyration_radii

    @property
    def volume(self) -> float | None:
        """Volume, m³, where it is known."""
        return self._native.volume

    @property
    def surface_area(self) -> float | None:
        """Surface area, m², where it is known."""
        return self._native.surface_area

    @property
    def density(self) -> float | None:
        """Mass per volume, kg/m³, where it is known and a number below 1.8e308."""
        return self._native.density

    @property
    def findings(self) -> list[Finding]:
        """What was noticed on the way: normals that were turned, a density that was assumed."""
        return findings_of(self._native.findings)

    def about(self, point: npt.ArrayLike) -> Floats:
        """The inertia tensor about a point, along body axes (3, 3), kg·m²: parallel axes.

        Parameters
        ----------
        point
            Body axes (3,), m.

        Returns
        -------
        array (3, 3)
            I + m (a² 1 − a aᵀ), where a leads from the centre of mass to the point.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.

        Examples
        --------
        >>> import polhode
        >>> ball = polhode.shapes.sphere(radius=0.1, mass=2.0)
        >>> ball.about([0.5, 0, 0]).diagonal().round(6)
        array([0.008, 0.508, 0.508])
        """
        return self._native.about(_arrays.triple("point", point))

    def along(self, rotation: object) -> Floats:
        """The inertia tensor about the centre of mass along turned axes (3, 3), kg·m².

        Parameters
        ----------
        rotation
            What takes components along those axes to body components: a quaternion (w, x, y, z), a matrix (3, 3), or a ``scipy.spatial.transform.Rotation``.

        Returns
        -------
        array (3, 3)
            Rᵀ I R.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.
        """
        return self._native.along(_arrays.quaternions("rotation", rotation, (4,)).tolist())

    def placed(self, *, position: npt.ArrayLike = (0.0, 0.0, 0.0), rotation: object = IDENTITY) -> MassProperties:
        """The body described in a frame in which its origin is at ``position`` and its axes are turned by ``rotation``.

        Parameters
        ----------
        position
            Where the body's origin is in the new frame (3,), m.
        rotation
            What takes the body's present components to the new ones: a quaternion (w, x, y, z), a matrix (3, 3), or a ``scipy.spatial.transform.Rotation``.

        Returns
        -------
        MassProperties
            The same body, described there.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.
        """
        turn = _arrays.quaternions("rotation", rotation, (4,)).tolist()
        return MassProperties._of(self._native.placed(_arrays.triple("position", position), turn))

    def __add__(self, other: object) -> MassProperties:
        """Both rigidly joined."""
        if not isinstance(other, MassProperties):
            return NotImplemented
        return joined([self, other])

    def __radd__(self, other: object) -> MassProperties:
        """``sum(parts)`` begins with 0."""
        return self if isinstance(other, int) and other == 0 else NotImplemented

    def __eq__(self, other: object) -> bool:
        """Equal are bodies of the same mass, centre of mass and tensor, wherever they came from."""
        return self._key == other._key if isinstance(other, MassProperties) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key)

    @property
    def _key(self) -> tuple[float, ...]:
        return self.mass, *self.center_of_mass.tolist(), *self.inertia.ravel().tolist()

    def to_dict(self) -> dict[str, Any]:
        """The object that ``polhode inertia --json`` prints: its keys are stable."""
        return dict(json.loads(self._native.json()))

    def export(self, format: str, *, name: str = "body") -> str:
        """As another program reads it.

        Parameters
        ----------
        format
            ``urdf``, ``sdf``, ``mjcf``, ``mjcf-principal``, ``usd``, ``jsbsim``, ``rocketpy``, ``basilisk``, ``solidworks`` or ``csv``.
        name
            What the body is called there.

        Returns
        -------
        str
            The text, in that program's frames, points, signs and units.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.
        """
        return self._native.export(_arrays.text("format", format), _arrays.text("name", name))

    def __repr__(self) -> str:
        moments = ", ".join(f"{moment:.6g}" for moment in self.moments)
        return f"MassProperties(mass={self.mass:.6g}, moments=[{moments}], symmetry={self.symmetry!r})"

    def __str__(self) -> str:
        return self._native.text()

    def _repr_html_(self) -> str:
        center = ", ".join(map(_html.number, self.center_of_mass))
        tensor = _html.rows("xyz", zip("xyz", ([_html.number(e) for e in row] for row in self.inertia)))
        principal = _html.rows(
            ["moment, kg·m²", "axis x", "y", "z"],
            (
                (str(k + 1), [_html.number(moment), *map(_html.number, axis)])
                for k, (moment, axis) in enumerate(zip(self.moments, self.axes))
            ),
        )
        findings = "".join(f"<li>{escape(f.severity)}: {escape(f.message)}</li>" for f in self.findings)
        return (
            f"<div><p>mass {_html.number(self.mass)} kg, centre of mass ({center}) m</p>"
            f"<p>inertia about the centre of mass, along body axes, off-diagonal = −∫xy dm, kg·m²</p>{tensor}"
            f"<p>principal, {escape(self.symmetry)}</p>{principal}" + (f"<ul>{findings}</ul>" if findings else "") + "</div>"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        # By value, bit for bit, with all that is known of where the body came from; and what a subclass has added.
        return rebuilt, (type(self), self._native.state()), getattr(self, "__dict__", None)


def rebuilt(kind: type[MassProperties], state: _native.MassState) -> MassProperties:
    """A body by value."""
    made = object.__new__(kind)
    made._native = _native.MassProperties.of_state(state)
    return made


def joined(parts: list[MassProperties]) -> MassProperties:
    """Several bodies rigidly joined, all of them at once: the sums are about a local point, so that no place costs digits."""
    return MassProperties._of(_native.MassProperties.combined([part._native for part in parts]))


def particles(*, masses: npt.ArrayLike, positions: npt.ArrayLike) -> MassProperties:
    """The mass properties of points.

    Parameters
    ----------
    masses
        Masses (n,), kg, positive.
    positions
        Where they are (n, 3), m.

    Returns
    -------
    MassProperties
        Of all of them.

    Raises
    ------
    PolhodeError
        Where an argument is refused: its name, the element and the rule are in the message.

    Examples
    --------
    >>> import polhode
    >>> dumbbell = polhode.particles(masses=[1.0, 3.0], positions=[[0, 0, 0], [0, 0.4, 0]])
    >>> dumbbell.center_of_mass
    array([0. , 0.3, 0. ])
    >>> dumbbell.symmetry
    'rod'
    """
    return MassProperties._of(_native.MassProperties.of_particles(*checked_particles(masses, positions)))


def checked_particles(masses: npt.ArrayLike, positions: npt.ArrayLike) -> tuple[Floats, Floats]:
    """A positive mass for each point."""
    masses = _arrays.numbers("masses", masses, ("n",))
    positions = _arrays.numbers("positions", positions, ("n", 3))
    if len(masses) != len(positions):
        raise PolhodeError(f"masses has {len(masses)} elements and positions {len(positions)} rows: one mass for each point")
    _arrays.refuse("masses", masses, np.asarray(masses <= 0.0), "positive")
    return masses, positions
