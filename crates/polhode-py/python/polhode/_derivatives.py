"""Derivatives of motions by what they start with, by the inertia tensor, and by numbers of torques."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _units
from ._arrays import Floats
from ._error import PolhodeError
from ._mass_derivatives import ROWS
from ._record import Record


@dataclass(frozen=True, eq=False, repr=False)
class EventDerivatives(Record):
    """An event, and how its time and the state then change. The state's derivatives are those with its time, not those at a fixed time."""

    #: The event's name in the scenario.
    name: str
    #: When, s.
    time: float
    #: ω along body axes (3,), rad/s.
    omega: Floats
    #: The attitude as a unit quaternion (4,): w, x, y, z.
    attitude: Floats
    #: Of the state (6, 6), by the start: rows and columns as of :class:`Derivatives`.
    by_start: Floats
    #: Of the state (6, 6), by the inertia tensor.
    by_inertia: Floats
    #: Of the state (6, p), by the parameters.
    by_parameters: Floats
    #: Of the time (6,), by the start: s/rad, s/(rad/s).
    time_by_start: Floats
    #: Of the time (6,), by the inertia tensor, s/(kg·m²).
    time_by_inertia: Floats
    #: Of the time (p,), by the parameters.
    time_by_parameters: Floats

    def __repr__(self) -> str:
        return f"EventDerivatives({self.name!r} at {self.time:.6g} s)"


@dataclass(frozen=True, eq=False, repr=False)
class Derivatives(Record):
    """States of a motion with their derivatives. :meth:`FreeMotion.derivatives` makes one, and :func:`simulate` with ``derivatives``.

    The rows of all of them are :attr:`rows`: θ, a small rotation vector along body axes by which the attitude is turned, R exp(θ), rad; and ω
    along body axes, rad/s. Columns are :attr:`start_columns`, the same of the start; :attr:`inertia_columns`, the elements of the inertia tensor
    about the point that the body turns about, kg·m²; and :attr:`parameters`. Of a single time the first axis is left out.

    >>> import numpy as np, polhode
    >>> motion = polhode.FreeMotion(inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]], omega=[0.7, -1.1, 0.4])
    >>> derivatives = motion.derivatives([0.0, 20.0])
    >>> derivatives.by_start.shape, derivatives.by_inertia.shape
    ((2, 6, 6), (2, 6, 6))
    >>> derivatives.start_columns
    ('theta_x', 'theta_y', 'theta_z', 'omega_x', 'omega_y', 'omega_z')
    >>> bool(np.allclose(derivatives.by_start[0], np.eye(6), atol=1e-15))
    True
    """

    #: What the rows are of.
    rows: ClassVar[tuple[str, ...]] = ("theta_x", "theta_y", "theta_z", "omega_x", "omega_y", "omega_z")
    #: What the columns of ``by_start`` are by.
    start_columns: ClassVar[tuple[str, ...]] = rows
    #: What the columns of ``by_inertia`` are by. I_xy = I_yx is one number, an element of the tensor: minus the integral of xy.
    inertia_columns: ClassVar[tuple[str, ...]] = ("I_xx", "I_yy", "I_zz", "I_xy", "I_xz", "I_yz")

    #: What the columns of ``by_mass_properties`` are by, as rows of :class:`MeshDerivatives`, :class:`BodyDerivatives` and :class:`ParticleDerivatives` are of.
    mass_properties_columns: ClassVar[tuple[str, ...]] = ROWS

    #: Times (n,), s.
    times: Floats
    #: ω along body axes (n, 3), rad/s.
    omega: Floats
    #: R_space_body as unit quaternions (n, 4): w, x, y, z, continuous.
    attitude: Floats
    #: (n, 6, 6): the state transition matrix.
    by_start: Floats
    #: (n, 6, 6).
    by_inertia: Floats
    #: (n, 6, p).
    by_parameters: Floats
    #: (6, 10): how the elements of the tensor about the point that the body turns about depend on its mass, its centre of mass, and the tensor about that,
    #: per kg, per m, and 1. Of a free body mass and centre do not matter.
    inertia_by_mass_properties: Floats
    #: The p numbers of torques: what the columns of ``by_parameters`` are by.
    parameters: tuple[str, ...]
    #: What happened on the way, in the order of time.
    events: tuple[EventDerivatives, ...]

    @property
    def by_mass_properties(self) -> Floats:
        """By the body's mass properties (n, 6, 10), through the tensor about the point that it turns about: :attr:`by_inertia` times
        :attr:`inertia_by_mass_properties`. Its columns are :attr:`mass_properties_columns`, so that a matrix product takes it on to what the body is
        made of. An event's own derivatives, and those of its time, are multiplied by the same matrix.

        Of a free body this is all. A torque that knows the mass or the centre of mass besides, as gravity about a pivot does, has them as
        parameters of its own (``"torque[0].lever.x"``), by which there are :attr:`by_parameters`.

        >>> import numpy as np, polhode
        >>> masses, positions = [1.2, 0.7, 0.9, 1.1], [[0.3, -0.1, 0.2], [-0.5, 0.4, 0.1], [0.2, 0.6, -0.7], [-0.1, -0.5, 0.4]]
        >>> body = polhode.particles(masses=masses, positions=positions)
        >>> after = polhode.FreeMotion(inertia=body, omega=[0.7, -1.1, 0.4]).derivatives(5.0)
        >>> of_body = polhode.particle_derivatives(masses=masses, positions=positions)
        >>> by_masses = after.by_mass_properties @ of_body.by_masses
        >>> by_positions = np.tensordot(after.by_mass_properties, of_body.by_positions, axes=1)
        >>> by_masses.shape, by_positions.shape
        ((6, 4), (6, 4, 3))
        """
        return self.by_inertia @ self.inertia_by_mass_properties

    def covariance(
        self,
        *,
        start: npt.ArrayLike | None = None,
        inertia: npt.ArrayLike | None = None,
        parameters: npt.ArrayLike | None = None,
        joint: npt.ArrayLike | None = None,
    ) -> Floats:
        """The covariance of the states (n, 6, 6), to first order: J C Jᵀ, in the order of :attr:`rows`.

        Parameters
        ----------
        start
            The covariance (6, 6) of θ and ω at the start, in the order of :attr:`start_columns`; without it the start is exact.
        inertia
            The covariance (6, 6) of the elements of the tensor, in the order of :attr:`inertia_columns`; without it the body is exact.
        parameters
            The covariance (p, p) of the parameters; without it they are exact.
        joint
            Instead of these three, which do not depend on each other, the covariance (12 + p, 12 + p) of all: start, inertia, parameters.

        Returns
        -------
        array (n, 6, 6)
            The covariances of θ and ω; of a single time (6, 6).

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.

        Examples
        --------
        A spin about an axis that is known to 0.01 rad/s turns by an angle that is known to 0.07 rad after 7 s:

        >>> import numpy as np, polhode
        >>> derivatives = polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 0.5]).derivatives([0.0, 7.0])
        >>> covariance = derivatives.covariance(start=np.diag([0, 0, 0, 0, 0, 0.01**2]))
        >>> np.sqrt(covariance[1, 2, 2]).round(12)
        np.float64(0.07)
        """
        count = len(self.parameters)
        blocks = [("start", start, 0, 6), ("inertia", inertia, 6, 6), ("parameters", parameters, 12, count)]
        given = [name for name, value, _, _ in blocks if value is not None]
        if joint is not None:
            if given:
                raise PolhodeError(f"joint has all numbers in it: give it, or {' and '.join(given)}")
            together = symmetric("joint", joint, 12 + count)
        elif not given:
            raise PolhodeError("a covariance is needed: start, inertia, parameters, or joint")
        else:
            together = np.zeros((12 + count, 12 + count))
            for name, value, first, size in blocks:
                if value is not None:
                    together[first : first + size, first : first + size] = symmetric(name, value, size)
        by_start, by_inertia = self.by_start.reshape(-1, 6, 6), self.by_inertia.reshape(-1, 6, 6)
        by_parameters = self.by_parameters.reshape(len(by_start), 6, count)
        return _native.carried_covariance(by_start, by_inertia, by_parameters, together).reshape(self.by_start.shape)

    def __repr__(self) -> str:
        times = f"{len(self.times)} times" if self.times.ndim else f"t = {self.times:.6g} s"
        by = ", ".join(["by start", "inertia", *self.parameters])
        return f"Derivatives({times}, {by})"


def symmetric(name: str, value: npt.ArrayLike, size: int) -> Floats:
    """A covariance: symmetric, nothing negative on its diagonal, no correlation beyond 1."""
    _units.without(name, value)
    matrix = _arrays.numbers(name, value, (size, size))
    diagonal = np.diag(matrix)
    _arrays.refuse(f"the diagonal of {name}", diagonal, diagonal < 0.0, "zero or positive: it has variances")
    bound = np.sqrt(np.outer(diagonal, diagonal))
    _arrays.refuse(name, matrix, np.abs(matrix - matrix.T) > 1e-12 * bound, "that of the other side of the diagonal")
    _arrays.refuse(name, matrix, np.abs(matrix) > (1.0 + 1e-12) * bound, "no more than the root of the two variances' product")
    return matrix


def derivatives_of(derived: _native.Derived, single: bool = False) -> Derivatives:
    """What Rust derived; of a single time without the first axis."""
    return Derivatives(
        times=_first(derived["times"], single),
        omega=_first(derived["omega"], single),
        attitude=_first(derived["attitude"], single),
        by_start=_first(derived["by_start"], single),
        by_inertia=_first(derived["by_inertia"], single),
        by_parameters=_first(derived["by_parameters"], single),
        inertia_by_mass_properties=derived["inertia_by_mass_properties"],
        parameters=tuple(derived["parameters"]),
        events=tuple(EventDerivatives(**event) for event in derived["events"]),
    )


def _first(array: Floats, single: bool) -> Floats:
    return np.asarray(array[0]) if single else array
