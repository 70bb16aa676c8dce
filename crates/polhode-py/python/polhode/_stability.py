"""Which steady motions last."""

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
from ._record import Record
from ._scenario import Scenario, formula_source


@dataclass(frozen=True, eq=False)
class SteadyRotation(Record):
    """A permanent rotation: without torque the body goes on turning about this axis; the other way round is another."""

    #: ω along body axes (3,), rad/s.
    omega: Floats
    #: L along body axes (3,), kg·m²/s.
    momentum: Floats
    #: J.
    kinetic_energy: float
    #: ``stable``, ``unstable`` or ``neutral``.
    stability: str
    #: Of the oscillation about it, rad/s; ``None`` unless it is stable.
    frequency: float | None
    #: At which a departure grows, 1/s; ``None`` unless it is unstable.
    growth_rate: float | None
    #: Whether friction inside the body would end it.
    ended_by_friction: bool
    #: What the scenario's friction inside makes of it, and at which rate, 1/s, negative where a departure dies out; ``None`` without such friction.
    with_sink: str | None
    with_sink_rate: float | None


@dataclass(frozen=True, eq=False)
class Oscillation(Record):
    """A small oscillation about an equilibrium."""

    #: rad/s; 0 of what only grows or dies out.
    frequency: float
    #: 1/s, negative of what dies out.
    growth_rate: float
    #: −growth_rate/√(growth_rate² + frequency²).
    damping_ratio: float
    #: About which the body swings (3,), body axes.
    axis: Floats
    #: About which it swings a quarter of a period later (3,), body axes.
    minor_axis: Floats
    #: How many have these rates.
    multiplicity: int


@dataclass(frozen=True, eq=False)
class Equilibrium(Record):
    """An equilibrium under the scenario's torques, and what small departures from it do."""

    #: Which: ``start``, ``on_orbit``, ``top``, ``nearest``, ``nearest_about_the_vertical`` or ``nearest_at_rest``.
    what: str
    #: Its attitude as a unit quaternion (4,): w, x, y, z.
    attitude: Floats
    #: ω along body axes (3,), rad/s.
    omega: Floats
    #: How far the start is from it: rad, and rad/s.
    turned_from_start: float
    omega_from_start: float
    #: Whether no departure grows.
    is_stable: bool
    #: How many rates are zero.
    neutral: int
    #: Small oscillations.
    modes: tuple[Oscillation, ...]


@dataclass(frozen=True, eq=False)
class SteadyMotions(Record):
    """The steady motions while the wheels keep their momentum."""

    #: From when on, s.
    time: float
    #: Momentum of the wheels along body axes (3,), kg·m²/s.
    wheel_momentum: Floats
    #: Permanent rotations without torque, with the angular momentum of the start; ``None`` where they cannot be found.
    rotations: tuple[SteadyRotation, ...] | None
    #: The equilibrium under the torques that act; ``None`` without such torques, or without one.
    equilibrium: Equilibrium | None
    #: Torques that keep the body from an equilibrium, and that without them.
    prevented_by: tuple[str, ...]
    equilibrium_of_the_rest: Equilibrium | None
    #: Torques that do not act.
    idle_torques: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class SteadyOnGround(Record):
    """The steady motion of a body on the ground that the start is near to; :meth:`Stability.to_dict` has more of wheels, rattlebacks and tippe tops."""

    #: ``rolling_upright``, ``spinning_upright``, ``on_vertex`` or another.
    path: str
    #: What the contact does: rolls, slides.
    footing: str
    #: rad/s.
    spin: float
    #: ω along body axes (3,), rad/s.
    omega: Floats
    #: The normal of the ground along body axes (3,).
    normal: Floats
    #: Whether no departure grows.
    is_stable: bool
    #: Frequencies, rad/s, and growth rates, 1/s, of small departures, a row each (n, 2).
    modes: Floats
    #: The spin at which it becomes stable, rad/s, and spin/threshold − 1; ``None`` where there is none.
    threshold: float | None
    margin: float | None


@dataclass(frozen=True, eq=False, repr=False)
class Stability(Record):
    """Which steady motions of a scenario's body last. :func:`stability` makes one."""

    #: For each time from which on the wheels keep their momentum; empty of a body on the ground.
    motions: tuple[SteadyMotions, ...]
    #: Of a body on the ground; ``None`` of others.
    ground: SteadyOnGround | None
    #: What was noticed.
    findings: tuple[Finding, ...]
    #: JSON and text, as the command prints them.
    _said: tuple[str, str]

    @property
    def rotations(self) -> tuple[SteadyRotation, ...]:
        """Permanent rotations, with the wheels as they are first."""
        return (self.motions[0].rotations if self.motions else None) or ()

    @property
    def equilibrium(self) -> Equilibrium | None:
        """The equilibrium under the torques that act, with the wheels as they are first."""
        return self.motions[0].equilibrium if self.motions else None

    def to_dict(self) -> dict[str, Any]:
        """The object that ``polhode stability --json`` prints: its keys are stable."""
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
    """Says which steady motions of a scenario's body last: permanent rotations, small oscillations about an equilibrium, the steady motion on the ground.

    It is what ``polhode stability`` does.

    Parameters
    ----------
    scenario
        A path, or a text of more than one line, as of :func:`simulate`, or a :class:`Scenario`.

    Returns
    -------
    Stability

    Raises
    ------
    PolhodeError
        If the scenario cannot be read, or no motion of it is steady: it is prescribed, or the mass changes.

    Warns
    -----
    PolhodeWarning
        Of what had to be assumed.

    Examples
    --------
    About the intermediate axis a departure grows at √((2 − 1)(3 − 2)/(1·3)) ω:

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
