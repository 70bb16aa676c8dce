"""States of the members of an ensemble, and their events, stops and failures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, overload

import numpy as np

from . import _arrays
from ._arrays import Floats
from ._motion import Ending, EventOccurrence
from ._public import public
from ._record import same
from ._states import ATTITUDE, OMEGA, States, ends, rotations
from ._table import Column, Table, Variable, vector

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


#: Description of the time of a state.
REACHED = "time; after an event that stopped the member, the time of the event; after a failure, the last valid time"


@public("polhode.results")
class Failure(NamedTuple):
    """A member whose computation failed."""

    #: Index of the member, from 0.
    member: int
    #: Last of the requested times with a good state, s; 0 if there is none.
    time: float
    #: Reason of the failure.
    cause: str


@public("polhode.results")
class Stop(NamedTuple):
    """A member that an event stopped."""

    #: Index of the member, from 0.
    member: int
    #: Name of the event.
    event: str
    #: Time of the stop, s.
    time: float


@public("polhode.results")
class EnsembleStates(Table):
    """States of the members of an ensemble. It unpacks as ``omega, attitude``.

    Its length is the number of members. ``states[417]`` is the :class:`States` of one member, at
    the times that it reached; ``states[400:420]`` are those of some members, numbered from 0 again.
    All arrays are read-only views of one array, in which the numbers of a state are contiguous. A
    member that an event stopped keeps the state of the event, and one whose computation failed
    keeps its last good state.
    """

    #: Not hashable, because it contains arrays.
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, times: Floats, rows: Floats, failures: list[Failure], stops: list[Stop], happened: list[tuple[int, EventOccurrence]]) -> None:
        #: Requested times (t,), s.
        self.times = times
        #: Members whose computation failed.
        self.failures = failures
        #: Members that an event stopped.
        self.stops = stops
        self._happened = happened
        self._rows = rows
        self._lock()

    def _lock(self) -> None:
        self.times.flags.writeable = self._rows.flags.writeable = False

    @property
    def omega(self) -> Floats:
        """Angular velocities (n, t, 3), body axes, rad/s."""
        return self._rows[:, :, 5:]

    @property
    def attitude(self) -> Floats:
        """Attitudes R_space_body as unit quaternions (n, t, 4): w, x, y, z, continuous in sign."""
        return self._rows[:, :, 1:5]

    @property
    def reached(self) -> Floats:
        """Times of the states (n, t), s.

        Each is the requested time, the time of the event that stopped the member, or the last good
        time of a member whose computation failed.
        """
        return self._rows[:, :, 0]

    @property
    def events(self) -> list[list[EventOccurrence]]:
        """Events of each member, in the order of time, as in :attr:`Motion.events`."""
        each: list[list[EventOccurrence]] = [[] for _ in range(len(self))]
        for member, event in self._happened:
            each[member].append(event)
        return each

    @property
    def endings(self) -> list[Ending]:
        """Ending of each member, ``complete``, ``stopped`` or ``failed``: see :class:`Ending`."""
        each = [Ending("complete", None, None)] * len(self)
        for stop in self.stops:
            each[stop.member] = Ending("stopped", stop.event, stop.time)
        for failure in self.failures:
            each[failure.member] = Ending("failed", failure.cause, failure.time)
        return each

    def event_times(self, name: str) -> Floats:
        """Returns the time of the first occurrence of an event, for each member.

        Parameters
        ----------
        name
            Name of the event.

        Returns
        -------
        array (n,)
            Times, s; NaN for a member to which the event has not happened up to the last time.

        Raises
        ------
        TypeError
            If the name is not text.

        Examples
        --------
        >>> import polhode
        >>> from polhode.scenario import ConstantTorque, Event
        >>> push = ConstantTorque(axes="body", torque=[0.0, 0.0, 0.5])
        >>> fast = Event(name="fast", measure="omega_body_z", value=3.0)
        >>> spun = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=[[0, 0, 0], [0, 0, 2], [0, 0, 4]], torques=[push], events=[fast])
        >>> spun.at([0.0, 20.0]).event_times("fast").round(9)
        array([15.,  5., nan])
        """
        found = np.full(len(self), np.nan)
        wanted = _arrays.text("name", name)
        for member, event in reversed(self._happened):
            if event.name == wanted:
                found[member] = event.time
        return found

    def rotations(self, member: int) -> Rotation:
        """Returns the attitudes of a member as a ``scipy.spatial.transform.Rotation``.

        Parameters
        ----------
        member
            Index of the member, from 0.

        Returns
        -------
        scipy.spatial.transform.Rotation
            One rotation for each time, from body components to space components.

        Raises
        ------
        ImportError
            If SciPy is not installed.
        """
        return rotations(self.attitude[member])

    def _table(self) -> list[Column]:
        members, times, _ = self._rows.shape
        return [
            Column("member", "1", "the member, from 0", np.repeat(np.arange(members), times)),
            Column("time_s", "s", REACHED, self.reached.ravel()),
            *vector("attitude_{}", "1", ATTITUDE, self.attitude, "wxyz"),
            *vector("omega_body_{}_rad_s", "rad/s", OMEGA, self.omega),
        ]

    def _variables(self) -> list[Variable]:
        along = ("member", "time")
        return [
            Variable("member", ("member",), "1", "the member, from 0", np.arange(len(self))),
            Variable("time", ("time",), "s", "requested time", self.times.copy()),
            Variable("reached", along, "s", REACHED, self.reached.copy()),
            Variable("omega", (*along, "axis"), "rad/s", OMEGA, self.omega.copy()),
            Variable("attitude", (*along, "component"), "1", ATTITUDE, self.attitude.copy()),
        ]

    def __iter__(self) -> Iterator[Floats]:
        return iter((self.omega, self.attitude))

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, which: int) -> States: ...

    @overload
    def __getitem__(self, which: slice) -> EnsembleStates: ...

    def __getitem__(self, which: int | slice) -> States | EnsembleStates:
        """Returns the states of a member, or those of some members, numbered from 0 again."""
        if not isinstance(which, slice):
            return States(self.reached[which].copy(), self.omega[which].copy(), self.attitude[which].copy())
        new = {member: k for k, member in enumerate(range(len(self))[which])}
        failures = sorted(one._replace(member=new[one.member]) for one in self.failures if one.member in new)
        stops = sorted(one._replace(member=new[one.member]) for one in self.stops if one.member in new)
        happened = sorted(((new[member], event) for member, event in self._happened if member in new), key=lambda one: one[0])
        return EnsembleStates(self.times.copy(), self._rows[which].copy(), failures, stops, happened)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, EnsembleStates):
            return NotImplemented
        if (self.failures, self.stops, self._happened) != (other.failures, other.stops, other._happened):
            return False
        return same(self._rows, other._rows) and same(self.times, other.times)

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._lock()

    def __repr__(self) -> str:
        members, times, _ = self._rows.shape
        counts = (("stopped", self.stops), ("events", self._happened), ("failures", self.failures))
        more = "".join(f", {len(found)} {what}" for what, found in counts if found)
        return f"EnsembleStates({members} members, {times} times{ends(self.times)}{more})"
