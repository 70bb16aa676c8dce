"""Lists of flights, and how to cut them out of a log."""

from __future__ import annotations

from typing import Any, Iterable, Iterator, overload

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _units
from ._arrays import Floats
from ._flight import Flight, as_long
from ._public import public
from ._table import Column, Table, Variable
from ._units import Quantity

#: Descriptions of the columns.
_FLIGHT, _TIME = "the flight's number, from 0", "time of the reading"
_GYRO, _ATTITUDE = "angular velocity along the sensor's axes, as it was read", "attitude of axes fixed in the body, unit quaternion, as it was measured"


@public("polhode.results")
class Flights(Table):
    """Flights of a body, in order.

    :func:`find_flights` returns them, and :func:`identify_tumbles` takes them.

    ``flights[k]`` is a :class:`Flight`, and ``flights[2:5]`` is a :class:`Flights`. As a table they
    have a row for each time of each flight. Missing readings are NaN, and a quantity that no flight
    has gets no column.

    Parameters
    ----------
    flights
        The flights, each a :class:`Flight`.

    Raises
    ------
    TypeError
        If an element is not a :class:`Flight`.

    Examples
    --------
    >>> import numpy as np, polhode
    >>> flight = polhode.Flight(times=[0, 0.01], gyro=[[1, 2, 3], [1.1, 1.9, 3]], name="first")
    >>> flights = polhode.results.Flights([flight, polhode.Flight(times=[2.0], gyro=[[0.5, 3, 1]], name="second")])
    >>> flights
    Flights(first, second: 3 readings)
    >>> flights[1].times, flights[:1] == polhode.results.Flights([flight])
    (array([2.]), True)
    >>> {name: values.tolist() for name, values in flights.columns().items()}["flight"]
    [0, 0, 1]
    """

    __slots__ = ("_flights",)

    #: Not hashable, because it contains arrays.
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, flights: Iterable[Flight] = ()) -> None:
        if not isinstance(flights, Iterable):
            raise TypeError(f"flights must be a list of Flight, not {type(flights).__name__}")
        given = tuple(flights)
        for k, flight in enumerate(given):
            if not isinstance(flight, Flight):
                raise TypeError(f"flights[{k}] must be a Flight, not {type(flight).__name__}")
        self._flights = given

    def __len__(self) -> int:
        return len(self._flights)

    @overload
    def __getitem__(self, which: int) -> Flight: ...

    @overload
    def __getitem__(self, which: slice) -> Flights: ...

    def __getitem__(self, which: int | slice) -> Flight | Flights:
        return Flights(self._flights[which]) if isinstance(which, slice) else self._flights[which]

    def __iter__(self) -> Iterator[Flight]:
        return iter(self._flights)

    def index(self, flight: Flight) -> int:
        """Returns the index of the first flight that equals the given one.

        Parameters
        ----------
        flight
            The flight to find.

        Returns
        -------
        int
            Its index, from 0.

        Raises
        ------
        ValueError
            If no flight is equal.
        """
        return self._flights.index(flight)

    def count(self, flight: Flight) -> int:
        """Returns the number of flights that equal the given one.

        Parameters
        ----------
        flight
            The flight to count.

        Returns
        -------
        int
            The count.

        Raises
        ------
        Nothing
            Zero if no flight is equal.
        """
        return self._flights.count(flight)

    def __eq__(self, other: object) -> bool:
        return self._flights == other._flights if isinstance(other, Flights) else NotImplemented

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._flights,)

    def __repr__(self) -> str:
        if not self._flights:
            return "Flights(none)"
        names = [flight.name for flight in self._flights]
        shown = names if len(names) <= 4 else [*names[:2], "…", names[-1]]
        count = sum(len(rows) for rows in self._times())
        return f"Flights({', '.join(shown)}: {count} {'reading' if count == 1 else 'readings'})"

    def _times(self) -> list[Floats]:
        """Returns the times of each flight: those of its gyro and of its attitudes."""
        return [np.union1d(_floats(flight.times), _floats(flight.attitude_times)) for flight in self._flights]

    def _rows(self, times: list[Floats], name: str, when: str, width: int) -> Floats | None:
        """Returns the readings of one kind, NaN where there is none; ``None`` if no flight has
        any."""
        parts = []
        for flight, rows in zip(self._flights, times):
            part = np.full((len(rows), width), np.nan)
            part[np.searchsorted(rows, _floats(getattr(flight, when)))] = _floats(getattr(flight, name)).reshape(-1, width)
            parts.append(part)
        found = np.concatenate([np.empty((0, width)), *parts])
        return None if np.isnan(found).all() else found

    def _parts(self) -> tuple[npt.NDArray[np.int64], Floats, Floats | None, Floats | None]:
        """Returns the flight's index, the time, the gyro reading and the attitude of each row."""
        times = self._times()
        numbers = np.repeat(np.arange(len(times)), [len(rows) for rows in times])
        gyro, attitude = self._rows(times, "gyro", "times", 3), self._rows(times, "attitude", "attitude_times", 4)
        return numbers, np.concatenate([np.empty(0), *times]), gyro, attitude

    def _table(self) -> list[Column]:
        numbers, times, gyro, attitude = self._parts()
        columns = [Column("flight", "1", _FLIGHT, numbers), Column("time_s", "s", _TIME, times)]
        if gyro is not None:
            columns += [Column(f"gyro_{axis}_rad_s", "rad/s", _GYRO, gyro[:, k].copy()) for k, axis in enumerate("xyz")]
        if attitude is not None:
            columns += [Column(f"attitude_{axis}", "1", _ATTITUDE, attitude[:, k].copy()) for k, axis in enumerate("wxyz")]
        return columns

    def _variables(self) -> list[Variable]:
        numbers, times, gyro, attitude = self._parts()
        found = [Variable("flight", ("reading",), "1", _FLIGHT, numbers), Variable("time", ("reading",), "s", _TIME, times)]
        if gyro is not None:
            found.append(Variable("gyro", ("reading", "axis"), "rad/s", _GYRO, gyro))
        if attitude is not None:
            found.append(Variable("attitude", ("reading", "component"), "1", _ATTITUDE, attitude))
        return found


def _floats(values: Any) -> Floats:
    """Returns an array of a flight, which has been checked already."""
    return np.asarray(values, np.float64)


def find_flights(
    *,
    times: npt.ArrayLike,
    gyro: npt.ArrayLike,
    slowest: Quantity = 3.0,
    shortest: Quantity = 0.3,
    torque: float = 0.2,
) -> Flights:
    """Cuts the flights out of a long log: intervals of fast rotation without applied torque.

    Parameters
    ----------
    times, gyro
        Times (n,), s, and angular velocities in sensor axes (n, 3), rad/s.
    slowest
        Least angular speed during a flight, rad/s.
    shortest
        Least duration of a flight, s.
    torque
        Greatest torque during a flight, relative to \\|I ω²\\|. The torque of a hand is about as
        large as \\|I ω²\\|.

    Returns
    -------
    Flights
        The flights in the order of time. Their names are their number and their first time.

    Raises
    ------
    PolhodeError
        If an argument is invalid; the message names the argument, the element and the rule.

    Examples
    --------
    A log at rest contains no flights:

    >>> import numpy as np, polhode
    >>> polhode.find_flights(times=np.arange(100) * 0.01, gyro=np.full((100, 3), 0.001))
    Flights(none)
    """
    when, omega = _arrays.numbers("times", times, ("n",)), _arrays.numbers("gyro", gyro, ("n", 3))
    as_long("times", when, "gyro", omega)
    _units.without("torque", torque)
    limits = _arrays.positive("slowest", slowest), _arrays.positive("shortest", shortest), _arrays.positive("torque", torque)
    flights = []
    for k, (start, end) in enumerate(_native.find_flights(when, omega, *limits)):
        inside = (when >= start) & (when <= end)
        flights.append(Flight(name=f"flight {k + 1}, {start:.2f} s", times=when[inside], gyro=omega[inside]))
    return Flights(flights)
