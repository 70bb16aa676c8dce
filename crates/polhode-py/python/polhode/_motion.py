"""The motion of a scenario."""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterable, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _html, _native
from ._arrays import Floats
from ._derivatives import Derivatives, derivatives_of
from ._error import PolhodeError, warn
from ._free_motion import MotionError, rotations
from ._mass_properties import Finding, findings_of, warn_of
from ._scenario import Scenario

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


class Event(NamedTuple):
    """Something that happened on the way."""

    #: The event's name in the scenario.
    name: str
    #: When, s.
    time: float
    #: True if what it watches was rising.
    rising: bool
    #: ω along body axes, rad/s.
    omega: tuple[float, ...]
    #: The attitude as a unit quaternion w, x, y, z.
    attitude: tuple[float, ...]


class Ending(NamedTuple):
    """How a motion ended."""

    #: ``complete``, ``stopped`` (by an event) or ``failed``: what comes before is good.
    kind: str
    #: The event that stopped it, or the cause of the failure.
    cause: str | None
    #: When, s.
    time: float | None


class Motion:
    """A computed motion: arrays with a row for each of ``times``. :func:`simulate` makes one.

    Each access gives an array of its own. Copies, in other processes too, hold all of the motion by value.
    """

    def __init__(self, native: _native.Motion) -> None:
        self._native = native

    @property
    def times(self) -> Floats:
        """Times (n,), s."""
        return self._columns["time_s"].copy()

    @property
    def attitude(self) -> Floats:
        """R_space_body as unit quaternions (n, 4): w, x, y, z, continuous."""
        return self._stacked("attitude_{}", "wxyz")

    @property
    def omega(self) -> Floats:
        """ω relative to space, along body axes (n, 3), rad/s."""
        return self._stacked("omega_body_{}_rad_s", "xyz")

    @property
    def omega_space(self) -> Floats:
        """ω relative to space, along space axes (n, 3), rad/s."""
        return self._stacked("omega_space_{}_rad_s", "xyz")

    @property
    def momentum(self) -> Floats:
        """L about the point that the body turns about, along space axes (n, 3), kg·m²/s."""
        return self._stacked("momentum_space_{}_kg_m2_s", "xyz")

    @property
    def torque(self) -> Floats:
        """The torque about that point, along body axes (n, 3), N·m."""
        return self._stacked("torque_body_{}_n_m", "xyz")

    @property
    def kinetic_energy(self) -> Floats:
        """Kinetic energy of rotation about that point (n,), J."""
        return self._columns["kinetic_energy_j"].copy()

    @property
    def potential_energy(self) -> Floats | None:
        """Potential energy of the torques (n,), J; ``None`` if one has no potential."""
        potential = self._columns.get("potential_energy_j")
        return None if potential is None else potential.copy()

    @property
    def work(self) -> Floats:
        """Work of the torque since the start (n,), J."""
        return self._work.copy()

    @property
    def events(self) -> list[Event]:
        """What happened, in the order of time."""
        return list(self._events)

    @property
    def error(self) -> MotionError | None:
        """Estimates of its error at each time; ``None`` of a prescribed motion."""
        return None if self._error is None else MotionError(*(errors.copy() for errors in self._error))

    @cached_property
    def derivatives(self) -> Derivatives | None:
        """Its derivatives, and those of its events; ``None`` unless :func:`simulate` was asked for them."""
        derived = self._native.derivatives()
        return None if derived is None else derivatives_of(derived)

    @cached_property
    def ending(self) -> Ending:
        """How it ended."""
        return Ending(*self._native.ending)

    @property
    def findings(self) -> list[Finding]:
        """What was noticed on the way: what had to be assumed of the body, a torque that nothing switches on."""
        return list(self._findings)

    @cached_property
    def title(self) -> str | None:
        """The scenario's title."""
        return self._native.title

    @property
    def summary(self) -> dict[str, Any]:
        """The object that is ``summary.json``: mass properties, the kind of motion, the error of the numbers; its keys are stable."""
        return dict(json.loads(self._json))

    def columns(self) -> dict[str, Floats]:
        """The trajectory by columns, as the tables of the command name them: what a ``DataFrame`` takes."""
        return {name: values.copy() for name, values in self._columns.items()}

    def rotations(self) -> Rotation:
        """The attitudes as a ``scipy.spatial.transform.Rotation``: it takes body components to space components."""
        return rotations(self.attitude)

    def page(self) -> str:
        """The page that shows the motion in three dimensions, with the worked solution, for a browser."""
        return _native.motion_page(self.title, self._page_data)

    @cached_property
    def _columns(self) -> dict[str, Floats]:
        # Nobody else has these: what is written into an array that was handed out changes no other answer.
        return dict(self._native.columns())

    @cached_property
    def _work(self) -> Floats:
        return self._native.work

    def _stacked(self, name: str, axes: str) -> Floats:
        return np.column_stack([self._columns[name.format(axis)] for axis in axes])

    @cached_property
    def _error(self) -> MotionError | None:
        estimate = self._native.error
        return None if estimate is None else MotionError(*estimate[0], *estimate[1])

    @cached_property
    def _events(self) -> tuple[Event, ...]:
        events = self._native.events
        return tuple(Event(name, time, rising, tuple(omega), tuple(wxyz)) for name, time, rising, omega, wxyz in events)

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
        return self._native.page_data()

    def __getstate__(self) -> dict[str, Any]:
        # By value: where it arrives, neither the scenario's files nor its computation are needed again.
        for name in _VALUES:
            getattr(self, name)
        return {name: value for name, value in vars(self).items() if name != "_native"}

    def __len__(self) -> int:
        return len(self._columns["time_s"])

    def __repr__(self) -> str:
        return f"Motion({self.title or 'a scenario'}: {len(self)} times, {self.ending.kind})"

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        return _html.frame(self.page())


#: All that a motion is: what its copies have.
_VALUES = tuple(name for name, value in vars(Motion).items() if isinstance(value, cached_property))


def simulate(
    scenario: Scenario | str | os.PathLike[str],
    *,
    times: npt.ArrayLike | None = None,
    error: str = "auto",
    derivatives: Sequence[str] | None = None,
) -> Motion:
    """Computes the motion of a :class:`Scenario`, of a scenario's file, or of its text.

    A ``str`` of more than one line is a text; the files that it names are found from the current folder. ``times`` (n,), ascending, s,
    take the place of the times of its ``[run]``. A motion that cannot be computed to its end is returned as far as it is good, with a
    :class:`PolhodeWarning`; what had to be assumed, and a ``[sweep]``, which is not simulated, are warned of too. Ctrl-C ends the
    computation.

    ``error`` says how much work :attr:`Motion.error` is worth: ``"thorough"`` takes twelve times as long as the motion, ``"cheap"`` as
    long as the motion, ``"auto"`` is thorough where that takes a moment.

    ``derivatives`` asks for :attr:`Motion.derivatives`, by the start, by the inertia tensor, and by these numbers of torques:
    ``"torque[0].factor"`` is what the first torque is multiplied by, which is 1; ``"torque[0].stiffness"`` a number of its own. An empty list
    has start and tensor alone.

    >>> import polhode
    >>> motion = polhode.simulate('''
    ... [[body.part]]
    ... shape = "box"
    ... size = ["20 cm", "13 cm", "3 cm"]
    ... mass = "0.6 kg"
    ...
    ... [start]
    ... spin = { body = ["0.01 rad/s", "5 rad/s", "0.02 rad/s"] }
    ...
    ... [run]
    ... duration = "4 s"
    ... samples = 401
    ... ''')
    >>> motion.omega.shape, motion.attitude.shape
    ((401, 3), (401, 4))
    >>> bool(abs(motion.momentum - motion.momentum[0]).max() < 1e-16)
    True

    Spun up by a torque about a principal axis, with its derivatives by the torque and when a rate is reached:

    >>> motion = polhode.simulate('''
    ... [[body.part]]
    ... shape = "tensor"
    ... mass = "1 kg"
    ... moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
    ...
    ... [start]
    ... spin = { body = [0, 0, 0] }
    ...
    ... [[torque]]
    ... model = "constant"
    ... axes = "body"
    ... torque = [0, 0, "0.5 N m"]
    ...
    ... [[event]]
    ... name = "fast"
    ... measure = "omega_body_z"
    ... value = "0.6 rad/s"
    ...
    ... [run]
    ... duration = "4 s"
    ... samples = 2
    ... ''', derivatives=["torque[0].z"])
    >>> motion.derivatives.by_parameters[1, 5, 0].round(12)  # ω = N t/I
    np.float64(1.6)
    >>> motion.derivatives.events[0].time_by_parameters.round(12)
    array([-6.])
    """
    functions = []
    if isinstance(scenario, Scenario):
        path, text, functions = scenario._path, scenario._text(), scenario._functions()
    elif isinstance(scenario, str) and "\n" in scenario:
        path, text = "scenario.toml", _arrays.text("scenario", scenario)
    else:
        path, text = _arrays.path("scenario", scenario), None
    error = _arrays.choice("error", error, ["auto", "cheap", "thorough"])
    sampled = None if times is None else _arrays.numbers("times", times, ("n",))
    try:
        motion = Motion(_native.simulate(path, text, sampled, error, _keys(derivatives), functions))
    except PolhodeError as refused:
        if isinstance(scenario, Scenario) and refused.line is not None:
            raise scenario._placed(refused) from None
        raise
    warn_of_scenario(motion.findings)
    if motion.ending.kind == "failed":
        warn(f"the motion ends at t = {motion.ending.time} s: {motion.ending.cause}")
    return motion


def _keys(derivatives: Sequence[str] | None) -> list[str] | None:
    """Names of numbers."""
    if derivatives is None:
        return None
    if isinstance(derivatives, (str, Mapping)) or not isinstance(derivatives, Iterable):
        raise TypeError(f"derivatives must be a list of numbers' names, not {type(derivatives).__name__}")
    return [_arrays.text(f"derivatives[{k}]", key) for k, key in enumerate(derivatives)]


def warn_of_scenario(findings: list[Finding]) -> None:
    """What is worth a warning, and that a ``[sweep]`` is not simulated."""
    warn_of(findings)
    for finding in findings:
        if finding.code == "sweep.nominal":
            warn(f"{finding.message} [{finding.code}]")
