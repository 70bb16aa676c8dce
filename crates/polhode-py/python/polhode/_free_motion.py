"""Free motion in closed form."""

from __future__ import annotations

import json
import math
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _display, _native, _rotation
from ._arrays import Floats
from ._body import Body, is_body, whole
from ._derivatives import Derivatives, derivatives_of
from ._error import PolhodeError
from ._mass_properties import IDENTITY, MassProperties
from ._public import public
from ._states import MotionError, States, rotations
from ._units import Quantity

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

#: Number of states below which the C library keeps the memory for reuse.
FEW = 2048


@public()
class FreeMotion:
    """Torque-free motion of a body: ω and attitude at any time, computed in constant time.

    Parameters
    ----------
    omega
        Angular velocity at t = 0 (3,), body axes, rad/s.
    moments
        Moments (3,) about the body's axes x, y and z, kg·m².
    inertia
        Instead of ``moments``: a tensor (3, 3) about the centre of mass, kg·m²,
        :class:`MassProperties`, or a :class:`Body`.
    attitude
        Rotation from body components to space components at t = 0: a quaternion (w, x, y, z), a
        matrix (3, 3), a ``scipy.spatial.transform.Rotation``, or a form of scenario files, such as
        ``{"axis": [0, 0, 1], "angle": "30 deg"}``. By default, body axes and space axes coincide.
    allow_unphysical
        If true, accepts unphysical moments, for which Euler's equations also have a solution.

    Raises
    ------
    PolhodeError
        If the body is not physical, or the energy or L exceeds the range of float64.

    Examples
    --------
    >>> import polhode
    >>> motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
    >>> motion.regime
    'short_axis'
    >>> round(motion.period, 10)
    39.1057341973
    >>> omega, attitude = motion.at([0.0, motion.flip_interval])
    >>> omega[1].round(12)
    array([-0.01, -1.  ,  0.01])

    Accuracy: 4e-15 (ω relative, attitude in rad) up to 1e9 periods before or after the start; the
    measured errors are in the book's ``accuracy.md``. :meth:`at` refuses times beyond some 1e25
    turns, at which the phase has fewer than six correct digits.
    """

    def __init__(
        self,
        *,
        omega: npt.ArrayLike,
        moments: npt.ArrayLike | None = None,
        inertia: npt.ArrayLike | MassProperties | Body | None = None,
        attitude: object = IDENTITY,
        allow_unphysical: bool = False,
    ) -> None:
        start = _arrays.triple("omega", omega)
        wxyz = IDENTITY if attitude is IDENTITY or attitude is None else _rotation.quaternion("attitude", attitude)
        unphysical = allow_unphysical is not False and _arrays.truth("allow_unphysical", allow_unphysical)
        if (moments is None) == (inertia is None):
            raise PolhodeError("give exactly one of moments and inertia")
        if unphysical and moments is None:
            raise PolhodeError("allow_unphysical = True has no effect on inertia: use it with moments")
        along, tensor = None, None
        if moments is not None:
            along = _arrays.triple("moments", moments)
            self._native = _native.FreeMotion.of_moments(along, start, wxyz, unphysical)
        else:
            tensor = _arrays.tensor("inertia", tensor_of(inertia))
            self._native = _native.FreeMotion.of_tensor(tensor, start, wxyz)
        self._arguments: dict[str, Any] = {"omega": start, "moments": along, "inertia": tensor, "attitude": wxyz, "allow_unphysical": unphysical}

    @property
    def regime(self) -> str:
        """Kind of motion.

        It is ``long_axis``, ``short_axis``, ``separatrix``, ``symmetric``, ``permanent`` or
        ``at_rest``.
        """
        return self._native.regime

    @property
    def period(self) -> float | None:
        """Period of ω in the body, s; ``None`` if ω is constant or never repeats."""
        return self._native.period

    @property
    def flip_interval(self) -> float | None:
        """Time between flips of ω along the intermediate axis, s; ``None`` for equal moments."""
        return self._native.flip_interval

    @property
    def precession_period(self) -> float | None:
        """Mean period of precession about L of the body axis that L circles, s."""
        return self._optional("precession_period_s")

    @property
    def rotation_period(self) -> float | None:
        """Period of the body's rotation about the axis that L circles, s."""
        return self._optional("rotation_period_s")

    @property
    def growth_rate(self) -> float | None:
        """Growth rate of a deviation from rotation about the intermediate axis, 1/s.

        It is ``None`` unless ω is near that axis.
        """
        return self._optional("growth_rate_per_s")

    @property
    def nutation_range(self) -> tuple[float, float]:
        """Least and greatest angle between L and the axis that it circles, rad."""
        least, greatest = self.summary["motion"]["nutation_range_rad"]
        return least, greatest

    @property
    def kinetic_energy(self) -> float:
        """Kinetic energy T, J: constant."""
        return self._native.kinetic_energy

    @property
    def momentum(self) -> Floats:
        """Angular momentum L (3,), space axes, kg·m²/s: constant."""
        return self._native.momentum

    @property
    def moments(self) -> Floats:
        """Principal moments (3,), ascending, kg·m²."""
        return self._native.moments

    @property
    def axes(self) -> Floats:
        """Principal axes as rows (3, 3).

        ``axes[k]`` is the unit vector of ``moments[k]`` in body components.
        """
        return self._native.axes

    @property
    def summary(self) -> dict[str, Any]:
        """The object that ``polhode spin --json`` prints. Its keys are stable."""
        return dict(json.loads(self._json))

    @cached_property
    def _json(self) -> str:
        return self._native.json()

    def at(self, times: npt.ArrayLike, *, out: tuple[Floats, Floats] | None = None) -> States:
        """Computes ω and the attitude at times, s, in any order, also before the start.

        Parameters
        ----------
        times
            Times (n,), s, or a single one.
        out
            Two C-contiguous float64 arrays, (n, 3) and (n, 4), to fill and return, so that their
            memory is reused. They must not share memory with each other or with the times.

        Returns
        -------
        States
            Angular velocities (n, 3) and attitudes (n, 4), unit quaternions of which the first has
            w ≥ 0. For a single time, (3,) and (4,).

        Raises
        ------
        PolhodeError
            If a time is too far away for the attitude to be known; the message names the first one.

        Examples
        --------
        >>> import numpy as np, polhode
        >>> motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
        >>> omega, attitude = np.empty((1000, 3)), np.empty((1000, 4))
        >>> states = motion.at(np.linspace(0.0, 60.0, 1000), out=(omega, attitude))
        >>> states.omega is omega, states.attitude is attitude
        (True, True)
        """
        if type(times) in (float, np.float64, int) and out is None and -_arrays.EXACT <= times <= _arrays.EXACT:  # type: ignore[operator]
            return States(np.array(times, np.float64), *self._native.at_time(times))  # type: ignore[arg-type]
        given = _arrays.real("times", times)
        shape = given.shape
        if len(shape) > 1:
            raise PolhodeError(f"times must have the shape (n,) or be a number, not {shape}")
        if not shape:
            if out is not None:
                raise PolhodeError("out needs several times: a single time has no arrays to fill")
            return States(given.copy(), *self._native.at_time(_arrays.number("times", given)))
        try:
            if out is not None:
                _filled(out, given)
                self._native.fill(given, *out)
                return States(given.copy(), *out)
            if shape[0] < FEW:
                return States(*self._native.few(given))
            out, kept = _room(given)
            self._native.fill(given, *out)
            return States(kept, *out)
        except PolhodeError:
            _arrays.numbers("times", given, ("n",))  # names the time that is not finite
            raise

    def derivatives(self, times: npt.ArrayLike) -> Derivatives:
        """Computes the states with their derivatives by the start and the tensor, in closed form.

        Parameters
        ----------
        times
            Times (n,), s, in any order, also before the start; or a single time.

        Returns
        -------
        Derivatives
            Arrays (n, 6, 6) with the names of their rows and columns, and the propagation of
            covariances.

        Raises
        ------
        PolhodeError
            If the derivatives do not exist: for unphysical moments (``allow_unphysical``), for
            moments of which one is less than 1e-8 of the greatest, and where derivatives exceed the
            range of float64, next to the intermediate axis.

        Examples
        --------
        Effect of 1 rad/s more about the axis of the spin after 7 s, on θ about it and on ω:

        >>> import polhode
        >>> motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 0.5])
        >>> motion.derivatives(7.0).by_start[[2, 5], 5].round(12)
        array([7., 1.])
        """
        given = _arrays.real("times", times)
        if given.ndim > 1:
            raise PolhodeError(f"times must have the shape (n,) or be a number, not {given.shape}")
        derived = self._native.derivatives(_arrays.numbers("times", np.atleast_1d(given), ("n",)))
        return derivatives_of(derived, single=given.ndim == 0)

    def error(self, times: npt.ArrayLike) -> MotionError:
        """Estimates the errors of the states: those of the formulas, and those of input rounding.

        Parameters
        ----------
        times
            Times (n,), s.

        Returns
        -------
        MotionError
            Four arrays (n,): errors of attitude and ω, due to the computation and due to input
            rounding.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.

        Examples
        --------
        >>> import polhode
        >>> error = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, 0.5, 0.9]).error([1e3, 1e9])
        >>> bool(error.attitude.max() < 2.1e-15), bool(error.inputs_attitude[1] > 1e-8)
        (True, True)
        """
        computation, inputs = self._native.error(_arrays.numbers("times", times, ("n",)))
        return MotionError(*computation, *inputs)

    def rotations(self, times: npt.ArrayLike) -> Rotation:
        """Computes the attitudes at times as a ``scipy.spatial.transform.Rotation``.

        Parameters
        ----------
        times
            Times (n,), s, or a single one.

        Returns
        -------
        scipy.spatial.transform.Rotation
            One rotation for each time, from body components to space components.

        Raises
        ------
        PolhodeError
            As for :meth:`at`.
        ImportError
            If SciPy is not installed.

        Examples
        --------
        >>> import polhode
        >>> motion = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, 0.5, 0.9])
        >>> omega, _ = motion.at([0.0, 7.0])
        >>> momentum = motion.rotations([0.0, 7.0]).apply(omega * [1, 2, 2.5])
        >>> bool(abs(momentum[1] - momentum[0]).max() < 1e-14)
        True
        """
        return rotations(self.at(times).attitude)

    def page(self, duration: Quantity | None = None) -> str:
        """Returns an HTML page that shows the motion in 3-D in a browser.

        Parameters
        ----------
        duration
            Duration of the motion shown, s. The default is some periods.

        Returns
        -------
        str
            Self-contained HTML.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.
        """
        return self._native.page(self._sensible() if duration is None else _arrays.positive("duration", duration))

    def _sensible(self) -> float:
        """Returns a duration of some periods or turns, s, limited to what the samples can
        resolve."""
        rate = float(np.linalg.norm(self._arguments["omega"]))
        if rate == 0.0:
            return 1.0
        turn = 2.0 * math.pi / rate
        return min(4.0 * max(self.period or 2.0 * turn, turn), 0.25 * 2001 / rate)

    def _optional(self, key: str) -> float | None:
        value: float | None = self.summary["motion"][key]
        return value

    def __eq__(self, other: object) -> bool:
        """Returns true if the bodies (given in the same way) and the starts are equal."""
        return self._key == other._key if isinstance(other, FreeMotion) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key)

    @property
    def _key(self) -> tuple[object, ...]:
        given, (_, attitude) = self._arguments, self.at(0.0)
        body = given["moments"] or [element for row in given["inertia"] for element in row]
        return given["moments"] is None, *body, *given["omega"], *attitude.tolist()

    def __repr__(self) -> str:
        period = "none" if self.period is None else f"{self.period:.6g} s"
        return f"FreeMotion(regime={self.regime!r}, period={period})"

    def __str__(self) -> str:
        return self._native.text()

    def _repr_html_(self) -> str:
        return _display.html("Free motion", _display.data_of(self.page()))

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "_native"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        # The same arguments give the same motion, bit for bit.
        FreeMotion.__init__(self, **state["_arguments"])
        vars(self).update(state)


def tensor_of(inertia: object) -> object:
    """Returns the tensor of a body; other values are returned unchanged."""
    return whole("inertia", inertia).inertia if is_body(inertia) else inertia


def _room(times: Floats) -> tuple[tuple[Floats, Floats], Floats]:
    """Allocates arrays for ω and the attitudes of many times, and copies the times.

    The copy is at the end of the array of attitudes. glibc returns memory to the system once the
    free memory at the end of the heap exceeds twice the largest freed block. Three arrays of 8, 24
    and 32 bytes per state exceed that. Every call would get its memory from the system again, page
    by page, which takes longer than the states.
    """
    count = times.size
    both = np.empty(5 * count)
    both[4 * count :] = times
    return (np.empty((count, 3)), both[: 4 * count].reshape(count, 4)), both[4 * count :]


def _filled(out: object, times: Floats) -> None:
    """Refuses output arrays that cannot hold the states."""
    if not isinstance(out, tuple) or len(out) != 2:
        raise TypeError("out must be a tuple of two arrays, for ω and the attitudes")
    for name, array, columns in (("out[0]", out[0], 3), ("out[1]", out[1], 4)):
        if not isinstance(array, np.ndarray) or array.dtype != np.float64:
            raise TypeError(f"{name} must be an array of float64, not {_arrays.kind_of(array)}")
        if array.shape != (times.size, columns):
            raise PolhodeError(f"{name} must have the shape ({times.size}, {columns}), not {array.shape}")
        if not (array.flags.c_contiguous and array.flags.aligned and array.flags.writeable):
            raise PolhodeError(f"{name} must be C-contiguous, aligned and writeable")
        # For contiguous arrays, the bounds of the memory are sufficient.
        if np.may_share_memory(array, times):
            raise PolhodeError("out shares memory with times", "give separate arrays: the times are read while these are filled")
    if np.may_share_memory(out[0], out[1]):
        raise PolhodeError("out[0] and out[1] must not share memory")
