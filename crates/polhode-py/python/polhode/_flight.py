"""Readings of a body in free flight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _rotation
from ._arrays import Floats
from ._error import PolhodeError
from ._public import public
from ._record import Record


@public()
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Flight(Record):
    """Readings of a body in free flight: of a gyro, or tracked attitudes, or both.

    No torques act on the body except those given here.

    >>> import numpy as np, polhode
    >>> polhode.Flight(times=[0, 0.01, 0.02, 0.03], gyro=np.ones((4, 3)))
    Flight('flight': 4 readings of a gyro)
    """

    #: Times of the gyro readings (n,), s, ascending.
    times: npt.ArrayLike = ()
    #: Angular velocity as read by the gyro (n, 3), sensor axes, rad/s.
    gyro: npt.ArrayLike = ()
    #: Times of the attitudes (m,), s, ascending; the default is ``times``.
    attitude_times: npt.ArrayLike | None = None
    #: Attitudes of axes fixed in the body: quaternions (m, 4), w, x, y, z, or matrices (m, 3, 3),
    #: from the body to space, or a ``scipy.spatial.transform.Rotation``.
    attitude: object = None
    #: Name of the flight in reports.
    name: str = "flight"
    #: Increase of the tensor about the common centre of mass in this flight (3, 3), kg·m², due to a
    #: known mass attached to the body.
    added: npt.ArrayLike | None = None
    #: Wheels that keep their speed relative to the body: for each, its axis (3,) and its angular
    #: momentum, kg·m²/s.
    wheels: Sequence[tuple[npt.ArrayLike, float]] = ()
    #: Known torques: a text of ``[[torque]]`` tables, as in scenario files.
    torques: str = ""

    def __post_init__(self) -> None:
        name = _arrays.text("name", self.name)
        gyro = np.empty((0, 3)) if np.size(self.gyro) == 0 else _arrays.numbers("gyro", self.gyro, ("n", 3))
        times = _arrays.numbers("times", self.times, ("n",))
        attitude, at = np.empty((0, 4)), np.empty(0)
        if self.attitude is not None:
            attitude = _rotation.quaternions("attitude", self.attitude, ("n", 4))
            at = times if self.attitude_times is None else _arrays.numbers("attitude_times", self.attitude_times, ("n",))
            as_long("attitude_times" if self.attitude_times is not None else "times", at, "attitude", attitude)
        elif self.attitude_times is not None:
            raise PolhodeError("attitude_times have no effect without attitude")
        if len(gyro) or self.attitude is None:
            as_long("times", times, "gyro", gyro)
        for what, when in (("times", times), ("attitude_times", at)):
            later = np.append(True, np.diff(when) > 0.0)[: len(when)]
            _arrays.refuse(what, when, ~later, "greater than the one before")
        wheels = tuple(
            (tuple(_arrays.triple(f"wheels[{k}][0]", axis)), _arrays.number(f"wheels[{k}][1]", momentum))
            for k, (axis, momentum) in enumerate(self.wheels)
        )
        checked: dict[str, object] = {
            "times": times.copy() if len(gyro) else np.empty(0),
            "gyro": gyro.copy(),
            "attitude_times": at.copy(),
            "attitude": attitude.copy(),
            "name": name,
            "added": None if self.added is None else np.array(_arrays.tensor("added", self.added)),
            "wheels": wheels,
            "torques": _arrays.text("torques", self.torques),
        }
        for key, value in checked.items():
            object.__setattr__(self, key, value)
        super().__post_init__()

    def __repr__(self) -> str:
        kinds = ((len(self.times), "readings of a gyro"), (len(self.attitude), "attitudes"))  # type: ignore[arg-type]
        return f"Flight({self.name!r}: {', '.join(f'{n} {kind}' for n, kind in kinds if n)})"

    def _arrays(self) -> _native.FlightArrays:
        added: Any = self.added
        given: Any = self
        six = None if added is None else [added[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        return {
            "name": self.name,
            "times": given.times,
            "gyro": given.gyro,
            "attitude_times": given.attitude_times,
            "attitude": given.attitude,
            "added": six,
            "wheels": [(list(axis), momentum) for axis, momentum in given.wheels],
            "torques": self.torques,
        }


def as_long(name: str, one: Floats, other_name: str, other: Floats) -> None:
    """Refuses arrays of different lengths."""
    if len(one) != len(other):
        raise PolhodeError(f"{name} and {other_name} must be of the same length, not {len(one)} and {len(other)}")
