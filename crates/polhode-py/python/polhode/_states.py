"""Where a body was."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator

import numpy as np

from ._arrays import Floats
from ._record import Record, same
from ._table import Column, Table, Variable, vector

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

#: What they are, in the words of the command's tables.
OMEGA = "angular velocity relative to space, along body axes"
ATTITUDE = "R_space_body, unit quaternion, Hamilton, scalar first"


class States(Table):
    """Angular velocities and attitudes, in the order of the times: it unpacks as ``omega, attitude``.

    Its length is the number of times; ``states[k]`` is a state, ``states[2:5]`` are several. Of a single time ``times`` is (), ω is (3,) and the
    attitude (4,).

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

    #: Nothing with arrays in it is hashed.
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, times: Floats, omega: Floats, attitude: Floats) -> None:
        #: Times (n,), s.
        self.times = times
        #: ω along body axes (n, 3), rad/s.
        self.omega = omega
        #: R_space_body as unit quaternions (n, 4): w, x, y, z; each of the sign nearest to the one before it.
        self.attitude = attitude

    def rotations(self) -> Rotation:
        """The attitudes as a ``scipy.spatial.transform.Rotation``: it takes body components to space components."""
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
        # A copy: what is written into it changes nothing else.
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
        return f"States({len(self)} times{ends(self.times)})"


@dataclass(frozen=True, eq=False, repr=False)
class MotionError(Table, Record):
    """How far each state may be from the true one: estimates, arrays (n,) in the order of the times; it unpacks as these four. Where nothing is known, π
    of an attitude, and ``inf`` of ω. ``error[k]`` is that of a state, ``error[2:5]`` of several."""

    #: Of the computation: the angle between the attitudes, rad. It grows along the way.
    attitude: Floats
    #: Of the computation: |δω| / |ω|.
    omega: Floats
    #: What half a unit in the last place of the moments and the start is worth: the angle between the attitudes, rad.
    inputs_attitude: Floats
    #: The same of ω, relative.
    inputs_omega: Floats

    def _table(self) -> list[Column]:
        return [
            Column("attitude_rad", "rad", "error of the computation, of the attitude", self.attitude.copy()),
            Column("omega_relative", "1", "error of the computation, of ω, relative", self.omega.copy()),
            Column("inputs_attitude_rad", "rad", "what the last bit of the inputs is worth, of the attitude", self.inputs_attitude.copy()),
            Column("inputs_omega_relative", "1", "what the last bit of the inputs is worth, of ω, relative", self.inputs_omega.copy()),
        ]

    def _variables(self) -> list[Variable]:
        return [Variable(name, ("row",), unit, description, values) for name, unit, description, values in self._table()]

    def __iter__(self) -> Iterator[Floats]:
        return iter((self.attitude, self.omega, self.inputs_attitude, self.inputs_omega))

    def __len__(self) -> int:
        return len(self.attitude)

    def __getitem__(self, which: Any) -> MotionError:
        # A copy, as those of states are.
        return MotionError(*(np.array(array[which]) for array in self))

    def __repr__(self) -> str:
        if not self.attitude.ndim:
            return f"MotionError(attitude {self.attitude:.2g} rad, ω {self.omega:.2g})"
        if not len(self):
            return "MotionError(0 times)"
        return f"MotionError({len(self)} times, attitude up to {self.attitude.max():.2g} rad, ω up to {self.omega.max():.2g})"


def ends(times: Floats) -> str:
    """Between which times, for a line."""
    return f", {times[0]:.6g} … {times[-1]:.6g} s" if len(times) else ""


def rotations(attitude: Floats) -> Rotation:
    """Quaternions, scalar first, as SciPy has them, scalar last."""
    try:
        from scipy.spatial.transform import Rotation
    except ImportError as error:
        raise ImportError("rotations need SciPy: pip install scipy") from error
    return Rotation.from_quat(attitude[..., [1, 2, 3, 0]])
