"""Mass properties: mass, centre of mass and inertia tensor."""

from __future__ import annotations

import json
from html import escape
from typing import Any, Iterable, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _html, _native, _rotation
from ._arrays import Floats
from ._deprecated import Former
from ._error import PolhodeError, in_python, warn
from ._public import public
from ._units import Quantity

#: Identity rotation, as a quaternion.
IDENTITY = (1.0, 0.0, 0.0, 0.0)


@public("polhode.results")
class Finding(NamedTuple):
    """A remark about a body's mass properties: an assumption, a correction or an error."""

    #: Stable identifier for programs, such as ``"mass.assumed"``.
    code: str
    #: ``"info"``, ``"warning"`` or ``"error"``.
    severity: str
    #: Description in a sentence.
    message: str
    #: Place, if the finding has one.
    place: str | None


def findings_of(remarks: Iterable[_native.Remark]) -> list[Finding]:
    """Converts the findings of Rust, with options written as in Python."""
    return [Finding(code, severity, in_python(message), place) for code, severity, message, place in remarks]


def warn_of(findings: Iterable[Finding]) -> None:
    """Issues a :class:`PolhodeWarning` for each finding that is not only information."""
    for finding in findings:
        if finding.severity != "info":
            warn(f"{finding.message} [{finding.code}]")


@public()
class MassProperties:
    """Mass, centre of mass and inertia tensor of a body.

    Parameters
    ----------
    mass
        Mass, kg.
    inertia
        Inertia tensor (3, 3), or three moments about the body's axes, kg·m²: about the centre of
        mass, or about the point ``about``. Its off-diagonal elements are *minus* the integrals,
        I_xy = -∫xy dm, so that L = I ω.
    center_of_mass
        Centre of mass (3,), body axes, m.
    about
        Reference point of the tensor (3,), m. The default is the centre of mass.

    Raises
    ------
    PolhodeError
        If the body is not physical: a tensor that violates the triangle inequality, or a mass that
        is not positive.

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
    >>> body.inertia_about([0, 0, 0])[0, 1]
    np.float64(4.125)

    Bodies can be added: ``a + b`` is both rigidly joined, and ``a.placed(position=…)`` moves one
    first.
    """

    __slots__ = ("_native",)

    def __init__(
        self,
        *,
        mass: Quantity,
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
        """Wraps mass properties from Rust."""
        self = object.__new__(cls)
        self._native = native
        return self

    def _heard(self) -> MassProperties:
        """Returns the object itself, after a warning for each finding that is not only
        information."""
        warn_of(findings_of(remark for remark in self._native.findings if remark[1] != "info"))
        return self

    @property
    def mass(self) -> float:
        """Mass, kg."""
        return self._native.mass

    @property
    def center_of_mass(self) -> Floats:
        """Centre of mass from the origin (3,), body axes, m."""
        return self._native.center_of_mass

    @property
    def inertia(self) -> Floats:
        """Inertia tensor about the centre of mass (3, 3), body axes, kg·m²."""
        return self._native.inertia

    @property
    def moments(self) -> Floats:
        """Principal moments about the centre of mass (3,), ascending, kg·m²."""
        return self._native.moments

    @property
    def axes(self) -> Floats:
        """Principal axes as rows (3, 3), right-handed.

        ``axes[k]`` is the unit vector of ``moments[k]`` in body components.
        """
        return self._native.axes

    @property
    def principal_rotation(self) -> Floats:
        """Rotation matrix R_body_principal (3, 3): takes principal components to body components.

        Column ``k`` is the principal axis of ``moments[k]``, so that
        ``inertia = R @ np.diag(moments) @ R.T``. The transpose takes body components to principal
        components. The matrix is a proper rotation: its determinant is 1.

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
        """Symmetry of the tensor.

        It is ``spherical``, ``oblate``, ``prolate``, ``asymmetric``, ``rod`` or ``point``.
        """
        return self._native.symmetry

    @property
    def gyration_radii(self) -> Floats:
        """Radii of gyration about the principal axes, √(i/m) (3,), m."""
        return self._native.gyration_radii

    @property
    def volume(self) -> float | None:
        """Volume, m³; ``None`` if not known."""
        return self._native.volume

    @property
    def surface_area(self) -> float | None:
        """Surface area, m²; ``None`` if not known."""
        return self._native.surface_area

    @property
    def density(self) -> float | None:
        """Mass per volume, kg/m³; ``None`` if not known or above 1.8e308."""
        return self._native.density

    @property
    def findings(self) -> list[Finding]:
        """Assumptions and corrections, such as reversed normals or an assumed density."""
        return findings_of(self._native.findings)

    def inertia_about(self, point: npt.ArrayLike) -> Floats:
        """Computes the inertia tensor about a point, body axes, kg·m² (parallel axis theorem).

        Parameters
        ----------
        point
            Reference point (3,), body axes, m.

        Returns
        -------
        array (3, 3)
            I + m (a² 1 − a aᵀ), where a is the vector from the centre of mass to the point.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.

        Examples
        --------
        >>> import polhode
        >>> ball = polhode.shapes.sphere(radius=0.1, mass=2.0)
        >>> ball.inertia_about([0.5, 0, 0]).diagonal().round(6)
        array([0.008, 0.508, 0.508])
        """
        return self._native.about(_arrays.triple("point", point))

    def inertia_along(self, rotation: object) -> Floats:
        """Returns the inertia tensor about the centre of mass along rotated axes (3, 3), kg·m².

        Parameters
        ----------
        rotation
            Rotation from components along those axes to body components: a quaternion (w, x, y, z),
            a matrix (3, 3), a ``scipy.spatial.transform.Rotation``, or a form of scenario files.

        Returns
        -------
        array (3, 3)
            Rᵀ I R.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.
        """
        return self._native.along(_rotation.quaternions("rotation", rotation, (4,)).tolist())

    about = Former("MassProperties.about", "inertia_about")
    along = Former("MassProperties.along", "inertia_along")

    def placed(self, *, position: npt.ArrayLike = (0.0, 0.0, 0.0), rotation: object = IDENTITY) -> MassProperties:
        """Returns the body in a frame where its origin is at ``position`` and its axes are rotated.

        Parameters
        ----------
        position
            Position of the body's origin in the new frame (3,), m.
        rotation
            Rotation from the body's present components to the new ones: a quaternion (w, x, y, z),
            a matrix (3, 3), a ``scipy.spatial.transform.Rotation``, or a form of scenario files.

        Returns
        -------
        MassProperties
            The same body in the new frame.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.
        """
        turn = _rotation.quaternions("rotation", rotation, (4,)).tolist()
        return MassProperties._of(self._native.placed(_arrays.triple("position", position), turn))

    def __add__(self, other: object) -> MassProperties:
        """Joins both bodies rigidly."""
        if not isinstance(other, MassProperties):
            return NotImplemented
        return joined([self, other])

    def __radd__(self, other: object) -> MassProperties:
        """Accepts 0 on the left, because ``sum(parts)`` begins with 0."""
        return self if isinstance(other, int) and other == 0 else NotImplemented

    def __eq__(self, other: object) -> bool:
        """Returns true if mass, centre of mass and tensor are equal; the origin of the numbers does
        not matter."""
        return self._key == other._key if isinstance(other, MassProperties) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key)

    @property
    def _key(self) -> tuple[float, ...]:
        return self.mass, *self.center_of_mass.tolist(), *self.inertia.ravel().tolist()

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode inertia --json`` prints. Its keys are stable."""
        return dict(json.loads(self._native.json()))

    def export(self, format: str, *, name: str = "body") -> str:
        """Returns the body in the format of another program.

        Parameters
        ----------
        format
            Format: ``urdf``, ``sdf``, ``mjcf``, ``mjcf-principal``, ``usd``, ``jsbsim``,
            ``rocketpy``, ``basilisk``, ``solidworks`` or ``csv``.
        name
            Name of the body in the output.

        Returns
        -------
        str
            The text, with that program's frames, reference points, signs and units.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.
        """
        return self._native.export(_arrays.text("format", format), _arrays.text("name", name))

    def __repr__(self) -> str:
        moments = ", ".join(f"{moment:.6g}" for moment in self.moments)
        unchecked = any(finding.code == "mesh.unchecked" for finding in self.findings)
        remark = "; not checked for self-intersections" if unchecked else ""
        return f"MassProperties(mass={self.mass:.6g}, moments=[{moments}], symmetry={self.symmetry!r}{remark})"

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
        # By value, bit for bit, with the origin of the numbers and the attributes of a subclass.
        return rebuilt, (type(self), self._native.state()), getattr(self, "__dict__", None)


def rebuilt(kind: type[MassProperties], state: _native.MassState) -> MassProperties:
    """Makes a body from its pickled state."""
    made = object.__new__(kind)
    made._native = _native.MassProperties.of_state(state)
    return made


def joined(parts: list[MassProperties]) -> MassProperties:
    """Joins several bodies rigidly.

    The sums are about a local point, so that large coordinates cost no accuracy.
    """
    return MassProperties._of(_native.MassProperties.combined([part._native for part in parts]))


def particles(*, masses: npt.ArrayLike, positions: npt.ArrayLike) -> MassProperties:
    """Computes the mass properties of point masses.

    Parameters
    ----------
    masses
        Masses (n,), kg, positive.
    positions
        Positions (n, 3), m.

    Returns
    -------
    MassProperties
        Mass properties of all points together.

    Raises
    ------
    PolhodeError
        If an argument is invalid; the message names the argument, the element and the rule.

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
    """Checks masses and positions: one positive mass for each point."""
    masses = _arrays.numbers("masses", masses, ("n",))
    positions = _arrays.numbers("positions", positions, ("n", 3))
    if len(masses) != len(positions):
        raise PolhodeError(f"masses has {len(masses)} elements and positions {len(positions)} rows: one mass for each point")
    _arrays.refuse("masses", masses, np.asarray(masses <= 0.0), "positive")
    return masses, positions
