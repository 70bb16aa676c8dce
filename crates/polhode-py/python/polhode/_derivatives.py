"""Derivatives of motions by the start, by the inertia tensor, and by parameters of torques."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _units
from ._arrays import Floats
from ._error import PolhodeError
from ._mass_derivatives import ROWS
from ._public import public
from ._record import Record


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class EventDerivatives(Record):
    """An event, with the derivatives of its time and of the state.

    The derivatives of the state include the change of the event's time. They are not derivatives at
    a fixed time.
    """

    #: Name of the event in the scenario.
    name: str
    #: Time of the event, s.
    time: float
    #: Angular velocity (3,), body axes, rad/s.
    omega: Floats
    #: Attitude as a unit quaternion (4,): w, x, y, z.
    attitude: Floats
    #: Derivatives of the state by the start (6, 6): rows and columns as in :class:`Derivatives`.
    by_start: Floats
    #: Derivatives of the state by the inertia tensor (6, 6).
    by_inertia: Floats
    #: Derivatives of the state by the parameters (6, p).
    by_parameters: Floats
    #: Derivatives of the time by the start (6,): s/rad, s/(rad/s).
    time_by_start: Floats
    #: Derivatives of the time by the inertia tensor (6,), s/(kg·m²).
    time_by_inertia: Floats
    #: Derivatives of the time by the parameters (p,).
    time_by_parameters: Floats

    def __repr__(self) -> str:
        return f"EventDerivatives({self.name!r} at {self.time:.6g} s)"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class Derivatives(Record):
    """States of a motion with their derivatives.

    :meth:`FreeMotion.derivatives` returns them, and :func:`simulate` with ``derivatives``.

    The rows of all derivatives are :attr:`rows`: θ, a small rotation vector in body axes, rad, with
    R exp(θ) as the rotated attitude; and ω in body axes, rad/s. The columns are
    :attr:`start_columns`, the same six numbers at the start; :attr:`inertia_columns`, the elements
    of the inertia tensor about the point that the body turns about, kg·m²; and :attr:`parameters`.
    For a single time, the arrays lack the first axis.

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

    #: Names of the rows.
    rows: ClassVar[tuple[str, ...]] = ("theta_x", "theta_y", "theta_z", "omega_x", "omega_y", "omega_z")
    #: Names of the columns of ``by_start``.
    start_columns: ClassVar[tuple[str, ...]] = rows
    #: Names of the columns of ``by_inertia``. I_xy = I_yx is one number, an element of the tensor:
    #: minus the integral of xy.
    inertia_columns: ClassVar[tuple[str, ...]] = ("I_xx", "I_yy", "I_zz", "I_xy", "I_xz", "I_yz")

    #: Names of the columns of ``by_mass_properties``: the rows of :class:`MeshDerivatives`,
    #: :class:`BodyDerivatives` and :class:`ParticleDerivatives`.
    mass_properties_columns: ClassVar[tuple[str, ...]] = ROWS

    #: Times (n,), s.
    times: Floats
    #: Angular velocity (n, 3), body axes, rad/s.
    omega: Floats
    #: Attitudes R_space_body as unit quaternions (n, 4): w, x, y, z, continuous in sign.
    attitude: Floats
    #: State transition matrices (n, 6, 6).
    by_start: Floats
    #: Derivatives of the state by the inertia tensor (n, 6, 6).
    by_inertia: Floats
    #: Derivatives of the state by the parameters (n, 6, p).
    by_parameters: Floats
    #: Derivatives (6, 10) of the tensor about the point that the body turns about by the mass (per
    #: kg), the centre of mass (per m) and the tensor about the centre of mass (dimensionless). Mass
    #: and centre do not matter for a free body.
    inertia_by_mass_properties: Floats
    #: Names of the p torque parameters: the columns of ``by_parameters``.
    parameters: tuple[str, ...]
    #: Events, in the order of time.
    events: tuple[EventDerivatives, ...]

    @property
    def by_mass_properties(self) -> Floats:
        """Derivatives by the body's mass properties (n, 6, 10), through the tensor.

        This is :attr:`by_inertia` times :attr:`inertia_by_mass_properties`. Its columns are
        :attr:`mass_properties_columns`. A matrix product with :class:`MeshDerivatives`,
        :class:`BodyDerivatives` or :class:`ParticleDerivatives` therefore gives the derivatives by
        vertices, parts or particles. Multiply the derivatives of an event and of its time by the
        same matrix.

        For a free body these derivatives are complete. A torque that also depends on the mass or
        the centre of mass, such as gravity about a pivot, has these as parameters of its own
        (``"torque[0].lever.x"``). Their derivatives are in :attr:`by_parameters`.

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
        """Computes the covariance J C Jᵀ of the states, to first order.

        Parameters
        ----------
        start
            Covariance (6, 6) of θ and ω at the start, in the order of :attr:`start_columns`. The
            default is an exact start.
        inertia
            Covariance (6, 6) of the elements of the tensor, in the order of
            :attr:`inertia_columns`. The default is an exact tensor.
        parameters
            Covariance (p, p) of the parameters. The default is exact parameters.
        joint
            Joint covariance (12 + p, 12 + p) of start, inertia and parameters, instead of the
            three, which are treated as independent.

        Returns
        -------
        array (n, 6, 6)
            Covariances of θ and ω, in the order of :attr:`rows`; for a single time (6, 6).

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.

        Examples
        --------
        A spin rate known to 0.01 rad/s gives an angle known to 0.07 rad after 7 s:

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
                raise PolhodeError(f"joint contains all numbers: give either joint or {' and '.join(given)}")
            together = symmetric("joint", joint, 12 + count)
        elif not given:
            raise PolhodeError("no covariance is given: give start, inertia, parameters or joint")
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
    """Checks a covariance: symmetric, no negative variances, no correlation beyond 1."""
    _units.without(name, value)
    matrix = _arrays.numbers(name, value, (size, size))
    diagonal = np.diag(matrix)
    _arrays.refuse(f"the diagonal of {name}", diagonal, diagonal < 0.0, "at least 0: it contains variances")
    bound = np.sqrt(np.outer(diagonal, diagonal))
    _arrays.refuse(name, matrix, np.abs(matrix - matrix.T) > 1e-12 * bound, "equal to the element on the other side of the diagonal")
    _arrays.refuse(name, matrix, np.abs(matrix) > (1.0 + 1e-12) * bound, "at most the square root of the product of the two variances")
    return matrix


def derivatives_of(derived: _native.Derived, single: bool = False) -> Derivatives:
    """Converts derivatives from Rust; for a single time without the first axis."""
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
