"""Torque that a prescribed motion requires."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._arrays import Floats
from ._error import PolhodeError, in_python
from ._mass_properties import Finding, checked_particles, findings_of, warn_of
from ._public import public
from ._record import Record
from ._scenario import Scenario, formula_source
from ._states import ends
from ._table import Column, Table, Variable


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class RequiredTorque(Table, Record):
    """Torque, power and forces that a prescribed motion requires; see :func:`required_torque`."""

    #: Times (n,), s.
    times: Floats
    #: Angular velocity (n, 3), body axes, rad/s.
    omega: Floats
    #: Angular acceleration (n, 3), body axes, rad/s².
    acceleration: Floats
    #: Torque (n, 3), body axes, N·m.
    torque: Floats
    #: Torque (n, 3), space axes, N·m.
    torque_space: Floats
    #: Power of the torque (n,), W.
    power: Floats
    #: Work of the torque since the first time (n,), J.
    work: Floats
    #: Forces on points (n, p, 3), body axes, N: on the particles of a body that consists only of
    #: particles, and on the requested masses.
    forces: Floats
    #: Forces of the two bearings of a shaft (n, 2, 3), body axes, N; ``None`` without a shaft.
    bearings: Floats | None
    #: Findings, such as an assumption about the body.
    findings: tuple[Finding, ...]
    #: Names, units and descriptions of the columns.
    _columns: tuple[tuple[str, str, str], ...]
    #: JSON and text, as the command prints them.
    _said: tuple[str, str]

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode torque --json`` prints. Its keys are stable.

        It also has the greatest torque, means, and the correction masses of a shaft.
        """
        return dict(json.loads(self._said[0]))

    def _parts(self) -> list[Floats]:
        """Returns the arrays in the order of the columns, each (n, k)."""
        count = len(self.times)
        more = [self.forces] if self.bearings is None else [self.forces, self.bearings]
        all_of_them = [self.times, self.omega, self.acceleration, self.torque, self.torque_space, self.power, self.work, *more]
        return [array.reshape(count, -1) if array.size else np.empty((count, 0)) for array in all_of_them]

    def _table(self) -> list[Column]:
        numbers = np.hstack(self._parts())
        return [Column(*about, numbers[:, k].copy()) for k, about in enumerate(self._columns)]

    def _variables(self) -> list[Variable]:
        along = ("time",)
        variables = [
            Variable("time", along, "s", "time", self.times.copy()),
            Variable("omega", (*along, "axis"), "rad/s", "angular velocity, along body axes", self.omega.copy()),
            Variable("acceleration", (*along, "axis"), "rad/s²", "rate of change of the angular velocity, along body axes", self.acceleration.copy()),
            Variable("torque", (*along, "axis"), "N·m", "torque along body axes", self.torque.copy()),
            Variable("torque_space", (*along, "axis"), "N·m", "torque along space axes", self.torque_space.copy()),
            Variable("power", along, "W", "its power", self.power.copy()),
            Variable("work", along, "J", "work of the torque since the first time", self.work.copy()),
            Variable("forces", (*along, "point", "axis"), "N", "forces on points, along body axes", self.forces.copy()),
        ]
        if self.bearings is not None:
            what = "forces of the bearings, along body axes"
            variables.append(Variable("bearings", (*along, "bearing", "axis"), "N", what, self.bearings.copy()))
        return variables

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return f"RequiredTorque({len(self)} times{ends(self.times)}, up to {np.linalg.norm(self.torque, axis=1).max():.6g} N·m)"

    def __str__(self) -> str:
        return in_python(self._said[1])


def required_torque(
    scenario: str | os.PathLike[str] | Scenario,
    *,
    times: npt.ArrayLike | None = None,
    masses: npt.ArrayLike | None = None,
    positions: npt.ArrayLike | None = None,
) -> RequiredTorque:
    """Computes the torque and forces that a prescribed motion requires (``polhode torque``).

    Parameters
    ----------
    scenario
        A path, or a text of more than one line, as for :func:`simulate`, or a :class:`Scenario`;
        with ``[prescribed]`` or ``[shaft]``.
    times
        Times (n,), s, ascending, which replace those of ``[run]``. Without either, only the start
        is computed.
    masses, positions
        Masses (p,), kg, fixed to the body at ``positions`` (p, 3), body axes, m, for which the
        forces are computed too.

    Returns
    -------
    RequiredTorque

    Raises
    ------
    PolhodeError
        If the scenario cannot be read or does not prescribe a motion, or the motion is not finite
        at a time.

    Warns
    -----
    PolhodeWarning
        For each assumption about the body.

    Examples
    --------
    N = ω × I ω, about an axis that is not a principal axis:

    >>> import polhode
    >>> needed = polhode.required_torque('''
    ... [[body.part]]
    ... shape = "tensor"
    ... mass = "1 kg"
    ... moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
    ...
    ... [prescribed]
    ... axis = [0, 3, 4]
    ... rate = "2 rad/s"
    ... ''', times=[0.0, 1.0])
    >>> needed.torque.round(12) + 0.0
    array([[0.96, 0.  , 0.  ],
           [0.96, 0.  , 0.  ]])
    """
    if (masses is None) != (positions is None):
        raise PolhodeError("give masses and positions together, one mass for each point")
    points = np.empty((0, 4))
    if masses is not None and positions is not None:
        points = np.column_stack(checked_particles(masses, positions))
    asked = None if times is None else _arrays.numbers("times", times, ("n",))
    if asked is not None:
        _arrays.refuse("times", asked[1:], np.diff(asked) <= 0.0, "later than the one before it")
    found = _native.required_torque(*formula_source(scenario), asked, points)
    findings = tuple(findings_of(found["findings"]))
    warn_of(findings)
    names = [name for name, _, _, _ in found["columns"]]
    numbers = np.column_stack([values for _, _, _, values in found["columns"]])

    def vectors(prefix: str) -> Floats:
        return numbers[:, [k for k, name in enumerate(names) if name.startswith(prefix)]]

    bearings = vectors("bearing_")
    return RequiredTorque(
        times=numbers[:, 0].copy(),
        omega=vectors("omega_"),
        acceleration=vectors("acceleration_"),
        torque=vectors("torque_body_"),
        torque_space=vectors("torque_space_"),
        power=vectors("power_")[:, 0],
        work=vectors("work_")[:, 0],
        forces=vectors("force_").reshape(len(numbers), -1, 3),
        bearings=bearings.reshape(len(numbers), 2, 3) if bearings.size else None,
        findings=findings,
        _columns=tuple((name, unit, description) for name, unit, description, _ in found["columns"]),
        _said=(found["json"], found["text"]),
    )
