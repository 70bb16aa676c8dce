"""Simulation of scenarios."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence

import numpy.typing as npt

from . import _arrays, _native
from ._computed_function import Called
from ._error import PolhodeError, warn
from ._mass_properties import Finding, warn_of
from ._motion import Motion
from ._scenario import Scenario


def simulate(
    scenario: Scenario | str | os.PathLike[str],
    *,
    times: npt.ArrayLike | None = None,
    error: str = "auto",
    derivatives: Sequence[str] | None = None,
) -> Motion:
    """Computes the motion of a :class:`Scenario`, of a scenario's file, or of its text.

    Parameters
    ----------
    scenario
        A :class:`Scenario`, a path, or a text. A text is a ``str`` of more than one line, and its
        paths are relative to the current folder. The files of a :class:`Scenario` are read when it
        is made.
    times
        Times (n,), s, ascending, which replace those of ``[run]``.
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
