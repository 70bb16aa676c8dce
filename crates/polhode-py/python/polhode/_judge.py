"""Accuracy of a motion that another program computed."""

from __future__ import annotations

import os
from typing import Any

import numpy.typing as npt

from . import _arrays, _native, _rotation
from ._arrays import Floats
from ._error import PolhodeError
from ._judgement import Judgement
from ._mass_properties import findings_of
from ._scenario import Scenario, formula_source
from ._simulate import warn_of_scenario
from ._units import Quantity


def judge(
    scenario: str | os.PathLike[str] | Scenario | None = None,
    run: str | os.PathLike[str] | None = None,
    *,
    moments: npt.ArrayLike | None = None,
    start_omega: npt.ArrayLike | None = None,
    times: npt.ArrayLike | None = None,
    attitude: object = None,
    omega: npt.ArrayLike | None = None,
    columns: str | None = None,
    quaternion: str | None = None,
    sense: str | None = None,
    omega_axes: str | None = None,
    axes: str | None = None,
    time_origin: Quantity | None = None,
    step: Quantity | None = None,
    engine: str | None = None,
) -> Judgement:
    """Compares a motion that another program computed with the exact motion of a scenario.

    Assumptions about the body are reported as :class:`PolhodeWarning`.

    Parameters
    ----------
    scenario
        A path, or a text of more than one line, as for :func:`simulate`, or a :class:`Scenario`;
        its ``[run]`` is not used.
    run
        The motion as a log file: CSV, Parquet or JSON lines.
    moments
        Instead of ``scenario``: principal moments (3,) about the body axes of the run, kg·m², of a
        free body that starts with the attitude and ω of the first row.
    start_omega
        ω (3,) at the first row along body axes, rad/s, with ``moments``; by default that of the
        run.
    times, attitude, omega
        The motion as arrays: times (n,), ascending, s; quaternions (n, 4), matrices (n, 3, 3) or a
        ``scipy.spatial.transform.Rotation`` of n; optionally angular velocities (n, 3), rad/s.
    columns
        Meaning of the columns of a log, if it does not follow from their names.
    quaternion
        ``"wxyz"`` or ``"xyzw"``. By default, this and the following four arguments are found from
        the beginning of the run.
    sense
        ``"body_to_space"`` or ``"space_to_body"``: the components that rotations transform, and the
        result. A ``Rotation`` has the first.
    omega_axes
        Axes of the angular velocity: ``"body"`` or ``"space"``.
    axes
        The run's x, y, z in terms of the scenario's axes, such as ``"x,z,-y"``.
    time_origin
        Time of the run at the scenario's time 0, s.
    step, engine
        Time step of the program, s, and its name.

    Returns
    -------
    Judgement
        Errors, their pattern and the most likely causes.

    Raises
    ------
    PolhodeError
        If several readings of the run are equally good, if the arrays are not a motion, or if a log
        is invalid.

    Examples
    --------
    >>> import numpy as np, polhode
    >>> scenario = '''
    ... [[body.part]]
    ... shape = "tensor"
    ... mass = "1 kg"
    ... moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
    ...
    ... [start]
    ... spin = { body = [0.3, -1.2, 0.4] }
    ... '''
    >>> times = np.linspace(0.0, 4.0, 201)
    >>> omega = np.array([0.3, -1.2, 0.4])
    >>> half = 0.5 * times[:, None] * omega
    >>> angle = np.linalg.norm(half, axis=1, keepdims=True)
    >>> attitude = np.hstack([half * np.sinc(angle / np.pi), np.cos(angle)])
    >>> judgement = polhode.judge(scenario, times=times, attitude=attitude)
    >>> judgement.reading.quaternion, judgement.reading.sense
    ('xyzw', 'body_to_space')
    >>> bool(judgement.largest_attitude_error > 0.1)
    True
    >>> judgement.likeliest.id
    'no_gyroscopic_term'
    >>> judgement = polhode.judge(moments=[1, 2, 2.5], start_omega=omega, times=times, attitude=attitude)
    >>> judgement.likeliest.id
    'no_gyroscopic_term'
    """
    compared = _compared(scenario, moments, start_omega, axes, time_origin)
    said: _native.Said = {
        "quaternion": _one_of("quaternion", quaternion, ["wxyz", "xyzw"]),
        "sense": _one_of("sense", sense, ["body_to_space", "space_to_body"]),
        "omega_axes": _one_of("omega_axes", omega_axes, ["body", "space"]),
        "axes": None if axes is None else _arrays.text("axes", axes),
        "time_origin": None if time_origin is None else _arrays.number("time_origin", time_origin),
        "step": None if step is None else _arrays.positive("step", step),
        "engine": None if engine is None else _arrays.text("engine", engine),
    }
    arrays = {"times": times, "attitude": attitude, "omega": omega}
    if run is not None:
        given = [name for name, value in arrays.items() if value is not None]
        if given:
            raise PolhodeError(f"{' and '.join(given)} have no effect on a log: give either run, or times and attitude")
        told = None if columns is None else _arrays.text("columns", columns)
        judged = _native.judge_file(compared, _arrays.path("run", run), told, said)
    else:
        if times is None or attitude is None:
            raise PolhodeError("give either run, or both times and attitude")
        if columns is not None:
            raise PolhodeError("columns have no effect on arrays: they describe a log")
        if omega is None and omega_axes is not None:
            raise PolhodeError("omega_axes has no effect without omega")
        rates = None if omega is None else _arrays.numbers("omega", omega, ("n", 3))
        judged = _native.judge_arrays(compared, _arrays.numbers("times", times, ("n",)), _attitudes(attitude, said), rates, said)
    warn_of_scenario(findings_of(judged["findings"]))
    return Judgement(judged)


def _compared(
    scenario: str | os.PathLike[str] | Scenario | None,
    moments: npt.ArrayLike | None,
    start_omega: npt.ArrayLike | None,
    axes: str | None,
    time_origin: float | str | None,
) -> _native.Compared:
    """Returns the motion with which a run is compared: that of a scenario or of a free body."""
    if (scenario is None) == (moments is None):
        raise PolhodeError("give exactly one of scenario and moments: judge(run=..., moments=...) needs no scenario")
    if moments is None:
        if start_omega is not None:
            raise PolhodeError("start_omega has no effect without moments: a scenario states its ω in [start]")
        assert scenario is not None
        path, text = formula_source(scenario)
        return {"path": path, "text": text, "moments": None, "start_omega": None}
    if axes is not None:
        raise PolhodeError("axes has no effect with moments: they are about the body axes of the run")
    if time_origin is not None:
        raise PolhodeError("time_origin has no effect with moments: the motion starts at the first row")
    omega = None if start_omega is None else _arrays.triple("start_omega", start_omega)
    return {"path": "moments", "text": None, "moments": _arrays.triple("moments", moments), "start_omega": omega}


def _attitudes(attitude: Any, said: _native.Said) -> Floats:
    """Converts attitudes to quaternions (n, 4), or matrices to rows (n, 9), and records in ``said``
    the conventions that are certain."""
    if hasattr(attitude, "as_quat"):
        if said["quaternion"] is not None:
            raise PolhodeError("quaternion has no effect on a Rotation, whose order is known")
        said["quaternion"] = "xyzw"
        said["sense"] = said["sense"] or "body_to_space"
        return _arrays.numbers("attitude", attitude.as_quat(), ("n", 4))
    given = _arrays.real("attitude", attitude)
    if given.ndim == 3:
        if said["quaternion"] is not None:
            raise PolhodeError("quaternion has no effect on matrices")
        return _arrays.numbers("attitude", given, ("n", 3, 3)).reshape(-1, 9)
    if given.ndim != 2 or given.shape[1] != 4:
        raise PolhodeError(f"attitude must have the shape (n, 4), or (n, 3, 3) for matrices, not {given.shape}")
    return _rotation.quaternions("attitude", given, ("n", 4))


def _one_of(name: str, value: object, known: list[str]) -> str | None:
    return None if value is None else _arrays.choice(name, value, known)
