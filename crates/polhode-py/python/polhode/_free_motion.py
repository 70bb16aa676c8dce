"""Free motion in closed form."""

from __future__ import annotations

import json
import math
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _display, _native
from ._arrays import Floats
from ._body import Body
from ._derivatives import Derivatives, derivatives_of
from ._error import PolhodeError
from ._mass_properties import IDENTITY, MassProperties
from ._states import MotionError, States, rotations

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

#: So many states lie in memory that the C library keeps.
FEW = 2048


class FreeMotion:
    """The torque-free motion of a body: ω and attitude at any time, past or future, in constant time.

    Parameters
    ----------
    omega
        Angular velocity at t = 0 (3,), along body axes, rad/s.
    moments
        Moments (3,) about the body's axes x, y and z, kg·m².
    inertia
        Instead of ``moments``: a tensor (3, 3) about the centre of mass, kg·m², :class:`MassProperties`, or a :class:`Body`.
    attitude
        What takes body components to space components at t = 0: a quaternion (w, x, y, z), a matrix (3, 3), or a
        ``scipy.spatial.transform.Rotation``. Without it the axes of both coincide.
    allow_unphysical
        Takes moments that are no body's, which Euler's equations do not mind.

    Raises
    ------
    PolhodeError
        Where there is no such body, or the energy or L is beyond the range of numbers.

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

    Accuracy: 4e-15 (ω relative, attitude in rad) up to 1e9 periods from the start, either way; the measured errors are in the book's ``accuracy.md``.
    Beyond some 1e25 turns, where the phase has no six digits left, :meth:`at` refuses a time.
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
        wxyz = IDENTITY if attitude is IDENTITY or attitude is None else _arrays.quaternion("attitude", attitude)
        unphysical = allow_unphysical is not False and _arrays.truth("allow_unphysical", allow_unphysical)
        if (moments is None) == (inertia is None):
            raise PolhodeError("a body is given by moments or by inertia, exactly one of them")
        if unphysical and moments is None:
            raise PolhodeError("allow_unphysical = True means nothing for inertia: it is for moments")
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
        """``long_axis``, ``short_axis``, ``separatrix``, ``symmetric``, ``permanent`` or ``at_rest``."""
        return self._native.regime

    @property
    def period(self) -> float | None:
        """The time after which ω repeats in the body, s; ``None`` where it never moves or never repeats."""
        return self._native.period

    @property
    def flip_interval(self) -> float | None:
        """The time between reversals of ω's component along the intermediate axis, s, for three different moments."""
        return self._native.flip_interval

    @property
    def precession_period(self) -> float | None:
        """How long the axis that L circles takes to go about L, on average, s."""
        return self._optional("precession_period_s")

    @property
    def rotation_period(self) -> float | None:
        """How long the body takes to turn about the axis that L circles, s."""
        return self._optional("rotation_period_s")

    @property
    def growth_rate(self) -> float | None:
        """The rate at which a departure from rotation about the intermediate axis grows, 1/s, where ω is near to it."""
        return self._optional("growth_rate_per_s")

    @property
    def nutation_range(self) -> tuple[float, float]:
        """The smallest and the largest angle between L and the axis that it circles, rad."""
        least, greatest = self.summary["motion"]["nutation_range_rad"]
        return least, greatest

    @property
    def kinetic_energy(self) -> float:
        """T, J: constant."""
        return self._native.kinetic_energy

    @property
    def momentum(self) -> Floats:
        """L along space axes (3,), kg·m²/s: constant."""
        return self._native.momentum

    @property
    def moments(self) -> Floats:
        """Principal moments (3,), ascending, kg·m²."""
        return self._native.moments

    @property
    def axes(self) -> Floats:
        """Principal axes as rows (3, 3): ``axes[k]`` is a unit vector in body components and belongs to ``moments[k]``."""
        return self._native.axes

    @property
    def summary(self) -> dict[str, Any]:
        """The object that ``polhode spin --json`` prints: its keys are stable."""
        return dict(json.loads(self._json))

    @cached_property
    def _json(self) -> str:
        return self._native.json()

    def at(self, times: npt.ArrayLike, *, out: tuple[Floats, Floats] | None = None) -> States:
        """ω and the attitude at times, s: any, in any order, before the start too.

        Parameters
        ----------
        times
            Times (n,), s, or a single one.
        out
            Two arrays, (n, 3) and (n, 4), C-contiguous float64, that are filled and returned, so that their memory is used again. They share memory neither with
            each other nor with the times.

        Returns
        -------
        States
            ω (n, 3) and attitudes (n, 4), unit quaternions of which the first has w ≥ 0; of a single time (3,) and (4,).

        Raises
        ------
        PolhodeError
            Where a time is too far away for the attitude to be known: the first such is named.

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
                raise PolhodeError("out is for several times: a single one has no arrays to fill")
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
            _arrays.numbers("times", given, ("n",))  # says which is not finite
            raise

    def derivatives(self, times: npt.ArrayLike) -> Derivatives:
        """The states at times with their derivatives by the start and by the inertia tensor, in closed form.

        Parameters
        ----------
        times
            Times (n,), s: any, in any order, before the start too; or a single one.

        Returns
        -------
        Derivatives
            Arrays (n, 6, 6), whose rows and columns it names, and what carries a covariance along.

        Raises
        ------
        PolhodeError
            Where there are none: of moments that are no body's (``allow_unphysical``), of moments of which one is less than 1e-8 of the greatest, and
            where they grow beyond the range of numbers, next to the intermediate axis.

        Examples
        --------
        What 1 rad/s more about the axis of the spin does in 7 s, to θ about it and to ω:

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
        """Estimates of the error of the states at times (n,), s: that of the formulas, and what the last bit of the inputs is worth.

        Parameters
        ----------
        times
            Times (n,), s.

        Returns
        -------
        MotionError
            Four arrays (n,): of attitude and ω, by the computation and by the inputs.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.

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
        """The attitudes at times as a ``scipy.spatial.transform.Rotation``: it takes body components to space components.

        Parameters
        ----------
        times
            Times (n,), s, or a single one.

        Returns
        -------
        scipy.spatial.transform.Rotation
            One for each time.

        Raises
        ------
        PolhodeError
            As of :meth:`at`.
        ImportError
            Without SciPy.

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

    def page(self, duration: float | None = None) -> str:
        """The page that shows the motion in three dimensions, for a browser.

        Parameters
        ----------
        duration
            How long the motion is shown, s; some periods unless given.

        Returns
        -------
        str
            HTML that loads nothing from elsewhere.

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.
        """
        return self._native.page(self._sensible() if duration is None else _arrays.positive("duration", duration))

    def _sensible(self) -> float:
        """Some periods, or some turns, but no longer than samples can follow the body, s."""
        rate = float(np.linalg.norm(self._arguments["omega"]))
        if rate == 0.0:
            return 1.0
        turn = 2.0 * math.pi / rate
        return min(4.0 * max(self.period or 2.0 * turn, turn), 0.25 * 2001 / rate)

    def _optional(self, key: str) -> float | None:
        value: float | None = self.summary["motion"][key]
        return value

    def __eq__(self, other: object) -> bool:
        """Equal are motions of the same body, given alike, with the same start."""
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
        # The same arguments are the same motion, bit for bit.
        FreeMotion.__init__(self, **state["_arguments"])
        vars(self).update(state)


def tensor_of(inertia: object) -> object:
    """The tensor of a body, or what is given."""
    if isinstance(inertia, Body):
        inertia = inertia.mass_properties
    return inertia.inertia if isinstance(inertia, MassProperties) else inertia


def _room(times: Floats) -> tuple[tuple[Floats, Floats], Floats]:
    """Arrays for ω and the attitudes of many times, and a copy of these.

    The copy lies behind the attitudes in one array. glibc gives memory back to the system where twice the largest piece that was ever
    freed is free, and three arrays of 8, 24 and 32 bytes a state are just that: every call would get its memory anew, page by page, which takes longer
    than the states.
    """
    count = times.size
    both = np.empty(5 * count)
    both[4 * count :] = times
    return (np.empty((count, 3)), both[: 4 * count].reshape(count, 4)), both[4 * count :]


def _filled(out: object, times: Floats) -> None:
    """Refuses what states cannot be put into."""
    if not isinstance(out, tuple) or len(out) != 2:
        raise TypeError("out must be a tuple of two arrays, for ω and the attitudes")
    for name, array, columns in (("out[0]", out[0], 3), ("out[1]", out[1], 4)):
        if not isinstance(array, np.ndarray) or array.dtype != np.float64:
            raise TypeError(f"{name} must be an array of float64, not {_arrays.kind_of(array)}")
        if array.shape != (times.size, columns):
            raise PolhodeError(f"{name} must have the shape ({times.size}, {columns}), not {array.shape}")
        if not (array.flags.c_contiguous and array.flags.aligned and array.flags.writeable):
            raise PolhodeError(f"{name} must be C-contiguous, aligned and writeable")
        # Of contiguous arrays the bounds say it.
        if np.may_share_memory(array, times):
            raise PolhodeError("out shares memory with times", "give arrays of their own: the times are read while these are filled")
    if np.may_share_memory(out[0], out[1]):
        raise PolhodeError("out[0] and out[1] must not share memory")
