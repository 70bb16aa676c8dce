"""From a scenario to its motion."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy.typing as npt

from . import _arrays, _native
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
        A :class:`Scenario`, a path, or a text: a ``str`` of more than one line, whose files are found from the current folder.
    times
        Times (n,), ascending, s, in the place of those of its ``[run]``.
    error
        How much work :attr:`Motion.error` is worth: ``"thorough"`` costs 12 to 20 times the motion, ``"cheap"``
        three to seven times, ``"auto"`` is thorough where that takes a moment.
    derivatives
        Asks for :attr:`Motion.derivatives`, by the start, by the inertia tensor, and by these numbers of torques: ``"torque[0].factor"`` is
        what the first torque is multiplied by, which is 1; ``"torque[0].stiffness"`` a number of its own. An empty list has start and tensor alone.

    Returns
    -------
    Motion
        As far as it is good: a motion that cannot be computed to its end has an :attr:`Motion.ending` that says why, and there is a
        :class:`PolhodeWarning`. What had to be assumed, and a ``[sweep]``, which is not simulated, are warned of too.

    Raises
    ------
    PolhodeError
        Where there is no such motion; of a file or a text it has ``line`` and ``column``.
    KeyboardInterrupt
        By Ctrl-C, which ends the computation.

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
    functions: list[tuple[int, bool, Callable[..., tuple[float, ...]]]] = []
    measures: list[tuple[int, bool, Callable[..., float]]] = []
    if isinstance(scenario, Scenario):
        path, text, functions, measures = scenario._path, scenario._text(), scenario._functions(), scenario._measures()
    elif isinstance(scenario, str) and "\n" in scenario:
        path, text = "scenario.toml", _arrays.text("scenario", scenario)
    else:
        path, text = _arrays.path("scenario", scenario), None
    error = _arrays.choice("error", error, ["auto", "cheap", "thorough"])
    sampled = None if times is None else _arrays.numbers("times", times, ("n",))
    try:
        native = _native.simulate(path, text, sampled, error, _keys(derivatives), (functions, measures))
    except PolhodeError as refused:
        if isinstance(scenario, Scenario) and refused.line is not None:
            raise scenario._placed(refused) from None
        raise
    motion = Motion(native, sampled, bool(functions or measures))
    warn_of_scenario(motion.findings)
    motion._warn_of_failure()
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
