"""Steady motions of a scenario's body and their stability."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any

from . import _native
from ._arrays import Floats
from ._error import in_python
from ._estimate import floats
from ._mass_properties import Finding, findings_of, warn_of
from ._public import public
from ._record import Record
from ._scenario import Scenario, formula_source


@public("polhode.results")
@dataclass(frozen=True, eq=False)
class SteadyRotation(Record):
    """A permanent rotation: without torque, the body keeps turning about this axis.

    Rotation in the opposite sense is a separate element.
    """

    #: Angular velocity (3,), body axes, rad/s.
    omega: Floats
    #: Angular momentum (3,), body axes, kg·m²/s.
    momentum: Floats
    #: Kinetic energy, J.
    kinetic_energy: float
    #: ``stable``, ``unstable`` or ``neutral``.
    stability: str
    #: Frequency of the oscillation about it, rad/s; ``None`` unless it is stable.
    frequency: float | None
    #: Growth rate of a deviation, 1/s; ``None`` unless it is unstable.
    growth_rate: float | None
    #: True if internal friction would end the rotation.
    ended_by_friction: bool
    #: Stability with the internal friction of the scenario, and growth rate, 1/s, negative if a
    #: deviation decays; ``None`` without such friction.
    with_sink: str | None
    with_sink_rate: float | None


@public("polhode.results")
@dataclass(frozen=True, eq=False)
class Oscillation(Record):
    """A small oscillation about an equilibrium."""

    #: Frequency, rad/s; 0 for pure growth or decay.
    frequency: float
    #: Growth rate, 1/s; negative for decay.
    growth_rate: float
    #: Damping ratio −growth_rate/√(growth_rate² + frequency²).
    damping_ratio: float
    #: Axis about which the body swings (3,), body axes.
    axis: Floats
    #: Axis about which the body swings a quarter of a period later (3,), body axes.
    minor_axis: Floats
    #: Number of oscillations with these rates.
    multiplicity: int


@public("polhode.results")
@dataclass(frozen=True, eq=False)
class Equilibrium(Record):
    """An equilibrium under the scenario's torques, with the modes of small deviations from it."""

    #: Kind: ``start``, ``on_orbit``, ``top``, ``nearest``, ``nearest_about_the_vertical`` or
    #: ``nearest_at_rest``.
    what: str
    #: Attitude as a unit quaternion (4,): w, x, y, z.
    attitude: Floats
    #: Angular velocity (3,), body axes, rad/s.
    omega: Floats
    #: Difference between the start and the equilibrium: angle, rad, and angular velocity, rad/s.
    turned_from_start: float
    omega_from_start: float
    #: True if no deviation grows.
    is_stable: bool
    #: Number of zero rates.
    neutral: int
    #: Small oscillations.
    modes: tuple[Oscillation, ...]


@public("polhode.results")
@dataclass(frozen=True, eq=False)
class SteadyMotions(Record):
    """Steady motions in an interval in which the wheels keep their momentum."""

    #: Beginning of the interval, s.
    time: float
    #: Momentum of the wheels (3,), body axes, kg·m²/s.
    wheel_momentum: Floats
    #: Permanent rotations without torque, with the angular momentum of the start; ``None`` if they
    #: cannot be found.
    rotations: tuple[SteadyRotation, ...] | None
    #: Equilibrium under the active torques; ``None`` if there are no such torques, or no
    #: equilibrium.
    equilibrium: Equilibrium | None
    #: Torques that prevent an equilibrium, and the equilibrium without them.
    prevented_by: tuple[str, ...]
    equilibrium_of_the_rest: Equilibrium | None
    #: Torques that are not active.
    idle_torques: tuple[str, ...]


@public("polhode.results")
@dataclass(frozen=True, eq=False)
class SteadyOnGround(Record):
    """The steady motion on the ground that is nearest to the start.

    :meth:`Stability.to_dict` has more on wheels, rattlebacks and tippe tops.
    """

    #: Kind: ``rolling_upright``, ``spinning_upright``, ``on_vertex`` or another.
    path: str
    #: Kind of contact: rolling or sliding.
    footing: str
    #: Spin, rad/s.
    spin: float
    #: Angular velocity (3,), body axes, rad/s.
    omega: Floats
    #: Normal of the ground (3,), body axes.
    normal: Floats
    #: True if no deviation grows.
    is_stable: bool
    #: Frequencies, rad/s, and growth rates, 1/s, of small deviations, a row each (n, 2).
    modes: Floats
    #: Spin at which the motion becomes stable, rad/s, and spin/threshold − 1; ``None`` if there is
    #: none.
    threshold: float | None
    margin: float | None


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class Stability(Record):
    """Steady motions of a scenario's body and their stability; see :func:`stability`."""

    #: Steady motions for each interval in which the wheels keep their momentum; empty for a body on
    #: the ground.
    motions: tuple[SteadyMotions, ...]
    #: Steady motion of a body on the ground; ``None`` for other bodies.
    ground: SteadyOnGround | None
    #: Findings, such as an assumption about the body.
    findings: tuple[Finding, ...]
    #: JSON and text, as the command prints them.
    _said: tuple[str, str]

    @property
    def rotations(self) -> tuple[SteadyRotation, ...]:
        """Permanent rotations with the initial momentum of the wheels."""
        return (self.motions[0].rotations if self.motions else None) or ()

    @property
    def equilibrium(self) -> Equilibrium | None:
        """Equilibrium under the active torques, with the initial momentum of the wheels."""
        return self.motions[0].equilibrium if self.motions else None

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode stability --json`` prints. Its keys are stable."""
        return dict(json.loads(self._said[0]))

    def __repr__(self) -> str:
        if self.ground is not None:
            return f"Stability({self.ground.path}: {'stable' if self.ground.is_stable else 'unstable'})"
        found = ", ".join(rotation.stability for rotation in self.rotations)
        more = "" if self.equilibrium is None else f"; {self.equilibrium.what}: {'stable' if self.equilibrium.is_stable else 'unstable'}"
        return f"Stability(rotations: {found or 'none'}{more})"

    def __str__(self) -> str:
        return in_python(self._said[1])


def stability(scenario: str | os.PathLike[str] | Scenario) -> Stability:
    """Finds the steady motions of a scenario's body and their stability (``polhode stability``).

    These are permanent rotations, small oscillations about an equilibrium, and steady motion on the
    ground.

    Parameters
    ----------
    scenario
        A path, or a text of more than one line, as for :func:`simulate`, or a :class:`Scenario`.

    Returns
    -------
    Stability

    Raises
    ------
    PolhodeError
        If the scenario cannot be read, or cannot have a steady motion because its motion is
        prescribed or its mass changes.

    Warns
    -----
    PolhodeWarning
        For each assumption about the body.

    Examples
    --------
    Growth rate of a deviation from rotation about the intermediate axis, √((2 − 1)(3 − 2)/(1·3)) ω:

    >>> import polhode
    >>> found = polhode.stability('''
    ... [[body.part]]
    ... shape = "tensor"
    ... mass = "1 kg"
    ... moments = ["1 kg m^2", "2 kg m^2", "3 kg m^2"]
    ...
    ... [start]
    ... spin = { body = [0, 1, 0] }
    ... ''')
    >>> fastest = max(found.rotations, key=lambda rotation: rotation.growth_rate or 0.0)
    >>> fastest.stability, round(fastest.growth_rate, 6)
    ('unstable', 0.57735)
    """
    printed = _native.scenario_stability(*formula_source(scenario))
    said: dict[str, Any] = json.loads(printed[0])
    findings = tuple(findings_of((f["code"], f["severity"], f["message"], f.get("where")) for f in said["findings"]))
    warn_of(findings)
    ground = said.get("on_ground")
    motions = () if ground is not None else tuple(map(_motions, [said, *said["later"]]))
    return Stability(motions=motions, ground=None if ground is None else _on_ground(ground), findings=findings, _said=printed)


def _motions(said: dict[str, Any]) -> SteadyMotions:
    rotations = said["permanent_rotations"]
    return SteadyMotions(
        time=said["judged_at_s"],
        wheel_momentum=floats(said["wheel_momentum_body"]),
        rotations=None if rotations is None else tuple(map(_rotation, rotations)),
        equilibrium=_equilibrium(said["small_oscillations"]),
        prevented_by=tuple(said["prevented_by"]),
        equilibrium_of_the_rest=_equilibrium(said["small_oscillations_of_the_rest"]),
        idle_torques=tuple(said["torques_that_do_not_act"]),
    )


def _rotation(said: dict[str, Any]) -> SteadyRotation:
    keys = ("stability", "frequency", "growth_rate", "ended_by_friction", "with_sink", "with_sink_rate")
    return SteadyRotation(
        omega=floats(said["omega_body"]),
        momentum=floats(said["momentum_body"]),
        kinetic_energy=said["kinetic_energy_j"],
        **{key: said[key] for key in keys},
    )


def _equilibrium(said: dict[str, Any] | None) -> Equilibrium | None:
    if said is None:
        return None
    return Equilibrium(
        what=said["equilibrium"],
        attitude=floats(said["attitude_wxyz"]),
        omega=floats(said["omega_body"]),
        turned_from_start=said["turned_from_start"],
        omega_from_start=said["omega_from_start"],
        is_stable=said["stable"],
        neutral=said["neutral"],
        modes=tuple(
            Oscillation(
                frequency=mode["frequency"],
                growth_rate=mode["growth_rate"],
                damping_ratio=mode["damping_ratio"],
                axis=floats(mode["axis_body"]),
                minor_axis=floats(mode["minor_axis_body"]),
                multiplicity=mode["multiplicity"],
            )
            for mode in said["modes"]
        ),
    )


def _on_ground(said: dict[str, Any]) -> SteadyOnGround:
    return SteadyOnGround(
        path=said["path"],
        footing=said["footing"],
        spin=said["spin"],
        omega=floats(said["omega_body"]),
        normal=floats(said["normal_body"]),
        is_stable=said["stable"],
        modes=floats([[mode["frequency"], mode["growth_rate"]] for mode in said["modes"]]).reshape(-1, 2),
        threshold=said["threshold"],
        margin=said["margin"],
    )
