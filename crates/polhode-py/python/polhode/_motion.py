"""Computed motion of a scenario."""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _display, _native
from ._arrays import Floats
from ._derivatives import Derivatives, derivatives_of
from ._error import PolhodeError, warn
from ._mass_properties import Finding, findings_of
from ._public import public
from ._record import same
from ._states import MotionError, States, rotations
from ._table import Column, Table, Variable
from ._units import Quantity

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


@public("polhode.results")
class EventOccurrence(NamedTuple):
    """An occurrence of an event."""

    #: Name of the event in the scenario.
    name: str
    #: Time, s.
    time: float
    #: True if the measure was rising.
    rising: bool
    #: Angular velocity, body axes, rad/s.
    omega: tuple[float, ...]
    #: Attitude as a unit quaternion w, x, y, z.
    attitude: tuple[float, ...]


@public("polhode.results")
class Ending(NamedTuple):
    """Ending of a motion."""

    #: Kind: ``complete``, ``stopped`` (by an event) or ``failed``. In all cases the states before
    #: the ending are valid.
    kind: str
    #: Event that stopped the motion, or cause of the failure.
    cause: str | None
    #: Time of the ending, s.
    time: float | None


@public("polhode.results")
class Motion(Table):
    """A computed motion: arrays with a row for each of ``times``, as :func:`simulate` returns it.

    Each access returns a new array. The length is the number of times. ``motion[k]`` is the
    :class:`States` at the kth time, and ``motion[2:5]`` those at several. Copies, also in other
    processes, hold the whole motion by value.
    """

    def __init__(
        self, native: _native.Motion, sampled: Floats | None = None, has_functions: bool = False, continued: tuple[Floats, ...] = ()
    ) -> None:
        self._native = native
        #: True if torques or events are Python functions, which copies do not have.
        self._has_functions = has_functions
        #: Times that replaced those of the scenario.
        self._sampled = None if sampled is None else sampled.copy()
        #: Times of each motion in a chain of extensions, up to this one; empty for a motion from
        #: the scenario's start.
        self._continued = continued

    @property
    def times(self) -> Floats:
        """Times (n,), s."""
        return self._column("time_s")

    @property
    def attitude(self) -> Floats:
        """Attitudes R_space_body as unit quaternions (n, 4): w, x, y, z, continuous in sign."""
        return self._stacked("attitude_{}", "wxyz")

    @property
    def omega(self) -> Floats:
        """Angular velocity relative to space (n, 3), body axes, rad/s."""
        return self._stacked("omega_body_{}_rad_s", "xyz")

    @property
    def omega_space(self) -> Floats:
        """Angular velocity relative to space (n, 3), space axes, rad/s."""
        return self._stacked("omega_space_{}_rad_s", "xyz")

    @property
    def momentum(self) -> Floats:
        """Angular momentum (n, 3), space axes, kg·m²/s.

        Its reference point is the point that the body turns about.
        """
        return self._stacked("momentum_space_{}_kg_m2_s", "xyz")

    @property
    def torque(self) -> Floats:
        """Torque about the point that the body turns about (n, 3), body axes, N·m."""
        return self._stacked("torque_body_{}_n_m", "xyz")

    @property
    def kinetic_energy(self) -> Floats:
        """Kinetic energy of rotation about the point that the body turns about (n,), J."""
        return self._column("kinetic_energy_j")

    @property
    def potential_energy(self) -> Floats | None:
        """Potential energy of the torques (n,), J; ``None`` if a torque has no potential."""
        return self._column("potential_energy_j") if "potential_energy_j" in self._columns else None

    @property
    def work(self) -> Floats:
        """Work of the torque since the start (n,), J."""
        return self._column("work_j")

    @property
    def events(self) -> list[EventOccurrence]:
        """Occurrences of events, in the order of time."""
        return list(self._events)

    @property
    def error(self) -> MotionError | None:
        """Error estimates at each time; ``None`` for a prescribed motion, and if none was wanted."""
        return self._error

    @cached_property
    def derivatives(self) -> Derivatives | None:
        """Derivatives of the motion and its events; ``None`` if they were not requested."""
        derived = self._native.derivatives()
        return None if derived is None else derivatives_of(derived)

    @cached_property
    def ending(self) -> Ending:
        """Ending of the motion: complete, stopped or failed."""
        return Ending(*self._native.ending)

    @property
    def findings(self) -> list[Finding]:
        """Findings, such as an assumption about the body, or a torque that is never switched on."""
        return list(self._findings)

    @cached_property
    def title(self) -> str | None:
        """Title of the scenario."""
        return self._native.title

    @property
    def summary(self) -> dict[str, Any]:
        """Contents of ``summary.json``: mass properties, kind of motion, numerical error.

        Its keys are stable.
        """
        return dict(json.loads(self._json))

    @property
    def states(self) -> States:
        """Times, angular velocities and attitudes."""
        return States(self.times, self.omega, self.attitude)

    def at(self, times: npt.ArrayLike) -> States:
        """Computes ω and the attitude at further times, by integrating again, to full accuracy.

        The times may be in any order, from the start up to the last of :attr:`times`.

        A copy, such as one in another process, reads the scenario and its files again for this. It
        is refused if these have changed.

        Parameters
        ----------
        times
            Times (n,), s, or a single one.

        Returns
        -------
        States
            Angular velocities (n, 3) and attitudes (n, 4); for a single time (3,) and (4,).

        Raises
        ------
        PolhodeError
            If a time is not within the motion, or the files of a copy have changed.

        Examples
        --------
        >>> import numpy as np, polhode
        >>> motion = polhode.simulate('''
        ... [[body.part]]
        ... shape = "tensor"
        ... mass = "1 kg"
        ... moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
        ...
        ... [start]
        ... spin = { body = [0, 0, 3] }
        ...
        ... [[torque]]
        ... model = "drag"
        ... law = "linear"
        ... coefficient = "0.5 N m s"
        ...
        ... [run]
        ... duration = "10 s"
        ... samples = 2
        ... ''')
        >>> bool(abs(motion.at(5.0).omega[2] - 3 * np.exp(-0.5 * 5.0 / 2.5)) < 1e-12)
        True
        """
        given = _arrays.real("times", times)
        if given.ndim > 1:
            raise PolhodeError(f"times must have the shape (n,) or be a number, not {given.shape}")
        asked = _arrays.numbers("times", np.atleast_1d(given), ("n",))
        first, last = float(self._columns["time_s"].values[0]), float(self._columns["time_s"].values[-1])
        if self._continued:
            _arrays.refuse("times", asked, asked < first, f"at least {first}, where this motion continues another one")
        _arrays.refuse("times", asked, asked > last, f"at most {last}, the last time of the motion; for later times, use the argument times of simulate")
        states = States(asked.copy(), *self._computed().at(asked))
        return states[0] if given.ndim == 0 else states

    def extend(self, duration: Quantity, *, samples: int = 1001, error: str = "auto") -> Motion:
        """Continues the motion from its end.

        The torques, their switching states and the events continue. Together, both motions are that
        of a longer run, within the tolerance of the steps. A motion that an event stopped continues
        from there. ``work``, ``error`` and ``findings`` of the result count from its first time.

        Parameters
        ----------
        duration
            Additional duration, s.
        samples
            Number of times, evenly spaced from the end of this motion to the end of the new one,
            both included.
        error
            Method of the error estimate, as for :func:`simulate`.

        Returns
        -------
        Motion
            The continuation alone, without the times of this motion.

        Raises
        ------
        PolhodeError
            If the motion cannot be continued: it has failed, or the body is on the ground or in
            gimbals, and its state is more than attitude and ω. Simulate these for longer instead.
        KeyboardInterrupt
            On Ctrl-C, which ends the computation.

        Examples
        --------
        >>> import polhode
        >>> from polhode.scenario import Event, Run, Start
        >>> racket = polhode.Scenario(
        ...     polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5]),
        ...     start=Start(omega=[0.0, 3.0, 0.1]),
        ...     events=[Event(name="over", measure="omega_body_y", value=0.0, then="stop")],
        ...     run=Run(duration=100.0, samples=101),
        ... )
        >>> first = polhode.simulate(racket)
        >>> second = first.extend(100.0)
        >>> first.ending.kind, second.ending.kind, bool(second.times[0] == first.times[-1])
        ('stopped', 'stopped', True)
        """
        further = _arrays.positive("duration", duration)
        count = _arrays.count("samples", samples, 2)
        error = _arrays.choice("error", error, ["auto", "cheap", "thorough", "none"])
        last = float(self._columns["time_s"].values[-1])
        times = last + further * (np.arange(count) / (count - 1))
        if not (np.diff(times) > 0.0).all():
            raise PolhodeError(f"duration = {further} s is too short for {count} samples at t = {last} s")
        native = self._computed().after(times, error)
        motion = Motion(native, self._sampled, self._has_functions, (*self._continued, times))
        motion._warn_of_failure()
        return motion

    def _warn_of_failure(self) -> None:
        if self.ending.kind == "failed":
            warn(f"the motion ends at t = {self.ending.time} s: {self.ending.cause}")

    def rotations(self) -> Rotation:
        """Returns the attitudes as a ``scipy.spatial.transform.Rotation``, from body to space."""
        return rotations(self.attitude)

    def page(self) -> str:
        """Returns an HTML page that shows the motion in 3-D, with the worked solution."""
        return _native.motion_page(self.title, self._page_data)

    @cached_property
    def _columns(self) -> dict[str, Column]:
        # These arrays are private: writing into an array that was handed out changes no other
        # result.
        return {column[0]: Column(*column) for column in self._native.columns()}

    def _column(self, name: str) -> Floats:
        return self._columns[name].values.copy()

    def _stacked(self, name: str, axes: str) -> Floats:
        return np.column_stack([self._columns[name.format(axis)].values for axis in axes])

    def _table(self) -> list[Column]:
        return [column._replace(values=column.values.copy()) for column in self._columns.values()]

    def _variables(self) -> list[Variable]:
        rest, found = dict(self._columns), []
        for name, columns, axes, dimension in _VECTORS:
            parts = [rest.pop(columns.format(axis)) for axis in axes]
            values = np.column_stack([part.values for part in parts])
            found.append(Variable(name, ("time", dimension), parts[0].unit, parts[0].description, values))
        time = rest.pop("time_s")
        return [
            Variable("time", ("time",), time.unit, time.description, time.values.copy()),
            *found,
            *(Variable(name, ("time",), column.unit, column.description, column.values.copy()) for name, column in rest.items()),
        ]

    @cached_property
    def _source(self) -> tuple[str, str]:
        path, text = self._native.source
        return os.path.abspath(path), text

    def _computed(self) -> _native.Motion:
        """Returns the computed motion of Rust; a copy computes it again."""
        if "_native" not in vars(self):
            if self._has_functions:
                raise PolhodeError("this copy of a motion does not contain the Python functions of its torques or events", "use the original motion")
            again = _native.simulate(self._source, self._sampled, "none", None, ([], []))
            for times in self._continued:
                again = again.after(times, "none")
            there = {name: values for name, _, _, values in again.columns()}
            # The errors are not estimated again.
            if not all(same(there.get(name), self._columns[name].values) for name in _STATE):
                message = "reading the scenario again gives a different motion: one of its files has changed"
                raise PolhodeError(message, "simulate it again")
            self._native = again
        return self._native

    @cached_property
    def _error(self) -> MotionError | None:
        estimate = self._native.error
        return None if estimate is None else MotionError(*estimate[0], *estimate[1])

    @cached_property
    def _events(self) -> tuple[EventOccurrence, ...]:
        events = self._native.events
        return tuple(EventOccurrence(name, time, rising, tuple(omega), tuple(wxyz)) for name, time, rising, omega, wxyz in events)

    @cached_property
    def _findings(self) -> tuple[Finding, ...]:
        return tuple(findings_of(self._native.findings))

    @cached_property
    def _json(self) -> str:
        return self._native.json()

    @cached_property
    def _text(self) -> str:
        return self._native.text()

    @cached_property
    def _page_data(self) -> str:
        return self._native.page_data(None)

    @cached_property
    def _coarser_data(self) -> str | None:
        """Page data of a body with possibly too many triangles for a notebook output, simplified;
        else ``None``."""
        return self._native.page_data(_TRIANGLES) if self._native.has_triangles else None

    @property
    def _output_data(self) -> str:
        return self._coarser_data or self._page_data

    def __getitem__(self, which: Any) -> States:
        return self.states[which]

    def __iter__(self) -> Iterator[States]:
        states = self.states
        return (states[k] for k in range(len(states)))

    def __eq__(self, other: object) -> bool:
        """Returns true if the numbers, times, events and the ending are equal."""
        if not isinstance(other, Motion):
            return NotImplemented
        if (self.ending, self._events, self._columns.keys()) != (other.ending, other._events, other._columns.keys()):
            return False
        return all(same(column.values, other._columns[name].values) for name, column in self._columns.items())

    def __hash__(self) -> int:
        return hash((len(self), self.ending, self._events))

    def __getstate__(self) -> dict[str, Any]:
        # By value: the receiver needs neither the scenario's files nor the computation.
        for name in _VALUES:
            getattr(self, name)
        return {name: value for name, value in vars(self).items() if name != "_native"}

    def __len__(self) -> int:
        return len(self._columns["time_s"].values)

    def __repr__(self) -> str:
        return f"Motion({self.title or 'a scenario'}: {len(self)} times, {self.ending.kind})"

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        return _display.html(self.title or "motion", self._output_data)


#: Vectors among the columns: name of the array, pattern of its columns, components, and name of the
#: dimension.
_VECTORS = (
    ("attitude", "attitude_{}", "wxyz", "component"),
    ("omega", "omega_body_{}_rad_s", "xyz", "axis"),
    ("omega_space", "omega_space_{}_rad_s", "xyz", "axis"),
    ("momentum", "momentum_space_{}_kg_m2_s", "xyz", "axis"),
    ("torque", "torque_body_{}_n_m", "xyz", "axis"),
)

#: Size of the triangles in a notebook output before compression, bytes: some ten thousand
#: triangles.
_TRIANGLES = 240_000

#: Columns that identify a motion.
_STATE = ("time_s", *(columns.format(axis) for _, columns, axes, _ in _VECTORS[:2] for axis in axes))

#: Attributes that copies of a motion contain.
_VALUES = tuple(name for name, value in vars(Motion).items() if isinstance(value, cached_property))
