"""Simulation of scenarios."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._body import Body
from ._computed_function import Called
from ._error import PolhodeError, warn
from ._mass_properties import Finding, MassProperties, warn_of
from ._motion import Motion
from ._scenario import Scenario
from ._units import Quantity
from .scenario import ConstantTorque, FunctionTorque, Run, Start, Torque, torque as traced


def simulate(
    scenario: Scenario | MassProperties | Body | str | os.PathLike[str],
    *,
    omega: npt.ArrayLike | None = None,
    attitude: Any = None,
    torque: Torque | Sequence[Torque] | Callable[..., Any] | npt.ArrayLike | None = None,
    duration: Quantity | None = None,
    samples: int | None = None,
    times: npt.ArrayLike | None = None,
    error: str = "auto",
    derivatives: Sequence[str] | None = None,
) -> Motion:
    """Computes the motion of a :class:`Scenario`, of a scenario's file or its text, or of a body.

    Parameters
    ----------
    scenario
        A :class:`Scenario`, a path, or a text. A text is a ``str`` of more than one line, and its
        paths are relative to the current folder. The files of a :class:`Scenario` are read when it
        is made. Or a :class:`MassProperties` or a :class:`Body`, with the following five arguments.
    omega
        Angular velocity (3,) of a body at t = 0, body axes, rad/s.
    attitude
        Attitude of a body at t = 0, as in :class:`polhode.scenario.Start`.
    torque
        Torque on a body: one or several of :mod:`polhode.scenario`, three constant components along
        body axes, N·m, or a Python function of the state as in :func:`polhode.scenario.torque`.
    duration
        Duration, s, of the motion of a body.
    samples
        Number of sample times of a body, evenly spaced from 0 to the end. The default is 1001.
    times
        Times (n,), s, ascending, instead of ``duration`` and ``samples``. They replace those of
        ``[run]``.
    error
        Method of the estimate :attr:`Motion.error`: ``"thorough"`` costs 12 to 20 times as much as
        the motion, ``"cheap"`` three to seven times, and ``"none"`` nothing: the error is then
        ``None``. ``"auto"`` is thorough if that is fast, and cheap if a Python function computes a
        torque or the measure of an event.
    derivatives
        Parameters of torques for :attr:`Motion.derivatives`, in addition to the start and the
        inertia tensor. ``"torque[0].factor"`` is a factor of the first torque, equal to 1;
        ``"torque[0].stiffness"`` is one of its own numbers. An empty list gives the derivatives by
        start and tensor alone.

    Returns
    -------
    Motion
        The motion. If it cannot be computed to its end, it is valid up to its
        :attr:`Motion.ending`, which has the cause, and a :class:`PolhodeWarning` is issued. Further
        warnings report assumptions, and a ``[sweep]``, which is not simulated.

    Raises
    ------
    PolhodeError
        If the motion is invalid; for a file or a text, the error has ``line`` and ``column``.
    KeyboardInterrupt
        On Ctrl-C, which ends the computation.

    Examples
    --------
    >>> import numpy as np, polhode
    >>> body = polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5])
    >>> driven = polhode.simulate(body, omega=[0.0, 0.0, 1.0], torque=lambda t: [0.0, 0.0, 5.0 * np.cos(2.0 * t)], times=[0.0, 1.0])
    >>> driven.omega[-1, 2].round(12) == (1.0 + np.sin(2.0)).round(12)  # ω = ω₀ + ∫ N dt/I
    np.True_
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

    A torque about a principal axis spins the body up from rest. Derivatives by the torque are those
    of the final rate, and of the time of an event:

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
    functions: list[tuple[int, bool, Called]] = []
    measures: list[tuple[int, bool, Called]] = []
    source: _native.ReadScenario | tuple[str, str | None]
    given = {"omega": omega, "attitude": attitude, "torque": torque, "duration": duration, "samples": samples}
    given = {name: value for name, value in given.items() if value is not None}
    if isinstance(scenario, (MassProperties, Body)):
        scenario = _of_body(scenario, times, **given)
    elif given:
        has = ", ".join(given)
        raise PolhodeError(f"{has}: these arguments are for a body, and this is a scenario, which has its own [start], [[torque]] and [run]")
    if isinstance(scenario, Scenario):
        source, functions, measures = scenario._read, scenario._functions(), scenario._measures()
    elif isinstance(scenario, str) and "\n" in scenario:
        source = ("scenario.toml", _arrays.text("scenario", scenario))
    else:
        source = (_arrays.path("scenario", scenario), None)
    error = _arrays.choice("error", error, ["auto", "cheap", "thorough", "none"])
    sampled = None if times is None else _arrays.numbers("times", times, ("n",))
    try:
        native = _native.simulate(source, sampled, error, _keys(derivatives), (functions, measures))
    except PolhodeError as refused:
        if isinstance(scenario, Scenario) and refused.line is not None:
            raise scenario._placed(refused) from None
        raise
    motion = Motion(native, sampled, bool(functions or measures))
    warn_of_scenario(motion.findings)
    motion._warn_of_failure()
    return motion


def _of_body(
    body: MassProperties | Body,
    times: npt.ArrayLike | None,
    *,
    omega: npt.ArrayLike | None = None,
    attitude: Any = None,
    torque: Any = (),
    duration: Quantity | None = None,
    samples: int | None = None,
) -> Scenario:
    """Makes the scenario of a body."""
    if omega is None:
        raise PolhodeError("omega is missing: give the angular velocity (3,) of the body at t = 0, body axes, rad/s")
    if (duration is None) == (times is None):
        raise PolhodeError("give the body either a duration, with or without samples, or times")
    if samples is not None and times is not None:
        raise PolhodeError("samples is for a duration: times are the sample times themselves")
    run = None if duration is None else Run(duration=duration, samples=samples)
    return Scenario(body, start=Start(omega=omega, attitude=attitude), torques=_torques_of(torque), run=run)


def _torques_of(torque: Any) -> list[Torque]:
    """Converts a torque model, several of them, a function, or three components, to models."""
    if isinstance(torque, Torque):
        return [torque]
    if callable(torque):
        try:
            return [traced(torque)]
        except (TypeError, PolhodeError):
            # What is not a formula is called; a mistake in it is raised again there.
            return [FunctionTorque(function=torque, axes="body")]
    several = list(torque) if isinstance(torque, Iterable) and not isinstance(torque, (str, np.ndarray)) else None
    if several is not None and all(isinstance(one, Torque) for one in several):
        return several
    components = _arrays.numbers("torque", torque, (3,))
    return [ConstantTorque(axes="body", torque=components.tolist())]


def _keys(derivatives: Sequence[str] | None) -> list[str] | None:
    """Checks names of parameters."""
    if derivatives is None:
        return None
    if isinstance(derivatives, (str, Mapping)) or not isinstance(derivatives, Iterable):
        raise TypeError(f"derivatives must be a list of numbers' names, not {type(derivatives).__name__}")
    return [_arrays.text(f"derivatives[{k}]", key) for k, key in enumerate(derivatives)]


def warn_of_scenario(findings: list[Finding]) -> None:
    """Issues warnings for findings, also for a ``[sweep]``, which is not simulated."""
    warn_of(findings)
    for finding in findings:
        if finding.code == "sweep.nominal":
            warn(f"{finding.message} [{finding.code}]")
