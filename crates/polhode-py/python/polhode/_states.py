"""States of a body: angular velocities and attitudes at times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator

import numpy as np

from ._arrays import Floats
from ._estimate import counted
from ._public import public
from ._record import Record, same
from ._table import Column, Table, Variable, vector

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

#: Descriptions of the columns, as in the tables of the command.
OMEGA = "angular velocity relative to space, along body axes"
ATTITUDE = "R_space_body, unit quaternion, Hamilton, scalar first"


@public("polhode.results")
class States(Table):
    """Angular velocities and attitudes at times. It unpacks as ``omega, attitude``.

    The length is the number of times. ``states[k]`` is a state, and ``states[2:5]`` are several.
    For a single time, ``times`` has the shape (), ω (3,) and the attitude (4,).

    >>> import polhode
    >>> states = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01]).at([0.0, 1.0, 2.0])
    >>> states
    States(3 times, 0 … 2 s)
    >>> omega, attitude = states
    >>> states[-1].times, bool((states[-1].omega == omega[2]).all())
    (array(2.), True)
    >>> list(states.columns())[:2]
    ['time_s', 'attitude_w']
    """

    __slots__ = ("times", "omega", "attitude")

    #: Not hashable, because it contains arrays.
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, times: Floats, omega: Floats, attitude: Floats) -> None:
        #: Times (n,), s.
        self.times = times
        #: Angular velocities (n, 3), body axes, rad/s.
        self.omega = omega
        #: Attitudes R_space_body as unit quaternions (n, 4): w, x, y, z, continuous in sign.
        self.attitude = attitude

    def rotations(self) -> Rotation:
        """Returns the attitudes as a ``scipy.spatial.transform.Rotation``, from body to space."""
        return rotations(self.attitude)

    def _table(self) -> list[Column]:
        return [
            Column("time_s", "s", "time", np.array(self.times, ndmin=1)),
            *vector("attitude_{}", "1", ATTITUDE, self.attitude, "wxyz"),
            *vector("omega_body_{}_rad_s", "rad/s", OMEGA, self.omega),
        ]

    def _variables(self) -> list[Variable]:
        along = ("time",) if np.ndim(self.times) else ()
        return [
            Variable("time", along, "s", "time", np.array(self.times)),
            Variable("omega", (*along, "axis"), "rad/s", OMEGA, self.omega.copy()),
            Variable("attitude", (*along, "component"), "1", ATTITUDE, self.attitude.copy()),
        ]

    def __iter__(self) -> Iterator[Floats]:
        return iter((self.omega, self.attitude))

    def __len__(self) -> int:
        return len(self.times)

    def __getitem__(self, which: Any) -> States:
        # A copy, so that writing into it changes nothing else.
        return States(*(np.array(array[which]) for array in (self.times, self.omega, self.attitude)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, States):
            return NotImplemented
        return all(map(same, (self.times, self.omega, self.attitude), (other.times, other.omega, other.attitude)))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.times, self.omega, self.attitude)

    def __repr__(self) -> str:
        if not np.ndim(self.times):
            return f"States(t = {self.times:.6g} s, omega={self.omega.tolist()}, attitude={self.attitude.tolist()})"
        return f"States({counted(len(self), 'time')}{ends(self.times)})"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class MotionError(Table, Record):
    """Error estimates of states: arrays (n,) in the order of the times. It unpacks as these four.

    Where the error is not known, it is π for an attitude and ``inf`` for ω. ``error[k]`` is the
    error of a state, and ``error[2:5]`` those of several.
    """

    #: Error of the computation: angle between the attitudes, rad. It grows with time.
    attitude: Floats
    #: Error of the computation, relative: \|δω\| / \|ω\|.
    omega: Floats
    #: Error due to input rounding (half a unit in the last place of the moments and the start):
    #: angle between the attitudes, rad.
    inputs_attitude: Floats
    #: Error of ω due to input rounding, relative.
    inputs_omega: Floats

    def _table(self) -> list[Column]:
        return [
            Column("attitude_rad", "rad", "numerical error of the attitude", self.attitude.copy()),
            Column("omega_relative", "1", "numerical error of ω, relative", self.omega.copy()),
            Column("inputs_attitude_rad", "rad", "error of the attitude due to input rounding", self.inputs_attitude.copy()),
            Column("inputs_omega_relative", "1", "error of ω due to input rounding, relative", self.inputs_omega.copy()),
        ]

    def _variables(self) -> list[Variable]:
        return [Variable(name, ("row",), unit, description, values) for name, unit, description, values in self._table()]

    def __iter__(self) -> Iterator[Floats]:
        return iter((self.attitude, self.omega, self.inputs_attitude, self.inputs_omega))

    def __len__(self) -> int:
        return len(self.attitude)

    def __getitem__(self, which: Any) -> MotionError:
        # A copy, as for states.
        return MotionError(*(np.array(array[which]) for array in self))

    def __repr__(self) -> str:
        if not self.attitude.ndim:
            return f"MotionError(attitude {self.attitude:.2g} rad, ω {self.omega:.2g})"
        if not len(self):
            return "MotionError(0 times)"
        return f"MotionError({counted(len(self), 'time')}, attitude up to {self.attitude.max():.2g} rad, ω up to {self.omega.max():.2g})"


def ends(times: Floats) -> str:
    """Returns the first and the last time as text."""
    return f", {times[0]:.6g} … {times[-1]:.6g} s" if len(times) else ""


def rotations(attitude: Floats) -> Rotation:
    """Converts quaternions, scalar first, to SciPy rotations."""
    try:
        from scipy.spatial.transform import Rotation
    except ImportError as error:
        raise ImportError("rotations need SciPy: pip install scipy") from error
    return Rotation.from_quat(attitude[..., [1, 2, 3, 0]])
