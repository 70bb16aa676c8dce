"""The tables of a scenario: what a body starts with, what turns it, what to look out for, and for how long to compute.

Each class is a table of a `scenario file <https://github.com/polhode/polhode/blob/main/book/scenario.md>`_ and has its keys as keyword arguments;
one that is a word of Python's ends in ``_``. A quantity is a number in SI, or a text with its unit, such as ``"12 mm"``; three of them are
any array (3,) or a list. :class:`polhode.Scenario` puts them together.

>>> import polhode
>>> from polhode.scenario import Drag, Run, Start
>>> scenario = polhode.Scenario(
...     polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5]),
...     start=Start(omega=[0.1, 3.0, 0.2]),
...     torques=[Drag(law="linear", coefficient="0.02 N m s")],
...     run=Run(duration="10 s", samples=101),
... )
>>> polhode.simulate(scenario).omega.shape
(101, 3)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, ClassVar, Mapping, Sequence

import numpy.typing as npt

from . import _arrays
from ._error import PolhodeError
from ._law import asked, formula_torque, where
from ._section import Quantity, Section, plain, written

__all__ = [
    "Balance",
    "Burn",
    "ConstantTorque",
    "Contact",
    "Drag",
    "Drop",
    "EnergySink",
    "Event",
    "Exit",
    "FormulaTorque",
    "FunctionTorque",
    "GimbalAxis",
    "GimbalBase",
    "Gimbals",
    "Gravity",
    "GravityGradient",
    "Ground",
    "Magnetic",
    "MassHistory",
    "Orbit",
    "Part",
    "Pendulum",
    "Pointing",
    "Prescribed",
    "Pulses",
    "Run",
    "Shaft",
    "Start",
    "Surface",
    "Thruster",
    "Torque",
    "TorqueTable",
    "Torsion",
    "Wheel",
    "torque",
    "where",
]

#: Three quantities, or an array (3,).
Vector = npt.ArrayLike | Sequence[Quantity]

#: A rotation: a ``scipy.spatial.transform.Rotation``, or one of the forms that files have, such as ``{"euler313": [0, 0.3, 0]}``,
#: ``{"quaternion": [w, x, y, z]}``, ``{"matrix": …}`` or ``{"axis": [0, 0, 1], "angle": "90 deg"}``.
Turn = Mapping[str, Any] | Any


class Part(Section):
    """A part of the body, of a shape that files know: ``shape``, and the keys of that shape, of its substance and of its place.

    >>> from polhode.scenario import Part
    >>> Part(shape="cylinder", radius="20 mm", length=0.3, material="oak", position=[0, 0, "15 cm"])
    Part(shape='cylinder', radius='20 mm', length=0.3, material='oak', position=(0, 0, '15 cm'))
    """

    table = "part"

    def __init__(self, **keys: Any) -> None:
        object.__setattr__(self, "_keys", {key: plain(f"part.{key}", value) for key, value in keys.items() if value is not None})

    def to_dict(self) -> dict[str, Any]:
        """The keys of the table and their values, as files have them."""
        return {key: written(value) for key, value in self._keys.items()}  # type: ignore[attr-defined]

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Part:
        """A table of these keys and values."""
        return cls(**table)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Part) and self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Part({', '.join(f'{key}={value!r}' for key, value in self._keys.items())})"  # type: ignore[attr-defined]


@dataclass(frozen=True, kw_only=True, repr=False)
class Start(Section):
    """Attitude, spin and velocity at t = 0.

    Parameters
    ----------
    attitude
        R_space_body: a rotation; without one the body's axes lie along those of space. With ``relative_to="orbit"`` R_orbit_body.
    omega
        ω along body axes (3,), rad/s.
    omega_space
        Instead: ω along space axes (3,), rad/s.
    momentum
        Instead: L along space axes (3,), kg·m²/s, that of wheels included.
    velocity
        Of the centre of mass, along space axes (3,), m/s.
    relative_to
        ``"space"``, or ``"orbit"``: attitude and spin are relative to the orbit's axes, which turn themselves.
    """

    table = "start"
    attitude: Turn | None = None
    omega: Vector | None = None
    omega_space: Vector | None = None
    momentum: Vector | None = None
    velocity: Vector | None = None
    relative_to: str | None = None

    #: How the forms of the spin are called in files.
    _SPIN: ClassVar[dict[str, str]] = {"omega": "body", "omega_space": "space", "momentum": "momentum"}

    def to_dict(self) -> dict[str, Any]:
        """The keys of the table and their values, as files have them."""
        table = super().to_dict()
        spin = {key: table.pop(name) for name, key in self._SPIN.items() if name in table}
        return {**table, "spin": spin} if spin else table

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Start:
        """A table of these keys and values."""
        names = {key: name for name, key in cls._SPIN.items()}
        spin = {names[key]: value for key, value in table.get("spin", {}).items()}
        return cls(**spin, **{key: value for key, value in table.items() if key != "spin"})


@dataclass(frozen=True, kw_only=True, repr=False)
class Run(Section):
    """For how long, at which times, and how.

    Parameters
    ----------
    duration
        s; or a number of orbits, as ``"2 orbits"``.
    samples
        How many times, evenly from 0 to the end; 1001 unless said.
    every
        Instead: the time from one to the next, s.
    method
        ``"auto"``, ``"exact"``, ``"taylor"``, ``"dop853"`` or ``"splitting"``.
    tolerance
        Bounds the error of a step, rad; 1e-13 unless said.
    order
        2, 4 or 6, of splitting.
    step
        The length of a step of splitting, s.
    table_
        Of the command: ``"csv"``, ``"parquet"``, or both.
    """

    table = "run"
    duration: Quantity
    samples: int | None = None
    every: Quantity | None = None
    method: str | None = None
    tolerance: float | None = None
    order: int | None = None
    step: Quantity | None = None
    table_: str | Sequence[str] | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Pulses(Section):
    """A train of pulses: pulse k acts from ``first`` + k ``period`` for ``width``.

    Parameters
    ----------
    width, period
        s
    first
        When the first begins, s; 0 unless said.
    count
        How many there are; without end unless said.
    """

    table = "pulses"
    width: Quantity
    period: Quantity
    first: Quantity | None = None
    count: int | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Torque(Section):
    """What every torque may have besides what is its own; it acts about the centre of mass, or about the pivot of a held body.

    Parameters
    ----------
    name
        What events call it.
    on
        ``False``: it does not act until an event switches it on.
    from_, until
        When it acts, s; always, unless said.
    pulses
        Instead: in :class:`Pulses`.
    """

    table = "torque"
    #: What files call the model.
    model: ClassVar[str]
    name: str | None = None
    on: bool | None = None
    from_: Quantity | None = None
    until: Quantity | None = None
    pulses: Pulses | None = None

    def to_dict(self) -> dict[str, Any]:
        """The keys of the table and their values, as files have them."""
        return {"model": self.model, **super().to_dict()}

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Torque:
        """A torque of the model that the table names."""
        given = {key: value for key, value in table.items() if key != "model"}
        if isinstance(given.get("pulses"), Mapping):
            given["pulses"] = Pulses.from_dict(given["pulses"])
        model = next((kind for kind in cls.__subclasses__() if kind.model == table["model"]), None)
        made = super(Torque, model or cls).from_dict(given)
        assert isinstance(made, Torque)
        return made


@dataclass(frozen=True, kw_only=True, repr=False)
class ConstantTorque(Torque):
    """A torque with constant components.

    Parameters
    ----------
    axes
        ``"body"`` or ``"space"``: along which axes they are constant.
    torque
        (3,), N·m.
    """

    model = "constant"
    axes: str
    torque: Vector


@dataclass(frozen=True, kw_only=True, repr=False)
class Gravity(Torque):
    """Uniform gravity on a body that is held at a point.

    Parameters
    ----------
    pivot
        The point that is held (3,), body axes, m, unless ``Scenario(pivot=…)`` says it.
    acceleration
        Along space axes (3,), m/s²; (0, 0, −9.80665) unless said.
    """

    model = "gravity"
    pivot: Vector | None = None
    acceleration: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class GravityGradient(Torque):
    """The gravity of the point mass that the body orbits: N = 3 (µ/r³) r̂ × I r̂.

    Parameters
    ----------
    mass
        ``"tensor"``, or ``"points"``: the exact sum over the points of a body of particles.
    """

    model = "gravity_gradient"
    mass: str | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Drag(Torque):
    """A torque against the angular velocity.

    Parameters
    ----------
    law
        ``"linear"``, N = −C ω, or ``"quadratic"``, N = −|ω| D ω.
    coefficient
        C, N·m·s, or D, N·m·s²: one for all axes, (3,) along body axes, or (3, 3).
    """

    model = "drag"
    law: str
    coefficient: Quantity | npt.ArrayLike


@dataclass(frozen=True, kw_only=True, repr=False)
class Torsion(Torque):
    """A spring, or a wire.

    Parameters
    ----------
    stiffness
        κ, N·m/rad.
    rest
        The attitude without torque, a rotation; along the axes of space unless said.
    axis
        Of a wire (3,), space axes: only the twist about it is resisted.
    """

    model = "torsion"
    stiffness: Quantity
    rest: Turn | None = None
    axis: npt.ArrayLike | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Thruster(Torque):
    """A force at a point of the body.

    Parameters
    ----------
    position
        Where it pushes (3,), body axes, m.
    force
        Along body axes (3,), N.
    """

    model = "thruster"
    position: Vector
    force: Vector


@dataclass(frozen=True, kw_only=True, repr=False)
class Magnetic(Torque):
    """A magnetic moment that is fixed in the body, in a field: N = m × B.

    Parameters
    ----------
    moment
        Along body axes (3,), A·m².
    field
        B, the same everywhere, along space axes (3,), T.
    dipole
        Instead: the moment of a dipole at the centre of the orbit, along space axes (3,), A·m².
    """

    model = "magnetic"
    moment: Vector
    field: Vector | None = None
    dipole: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class EnergySink(Torque):
    """What rubs inside the body: L stays what it is, and T falls at the rate α ‖L × ω‖².

    Parameters
    ----------
    coefficient
        α, 1/(N·m·s).
    """

    model = "energy_sink"
    coefficient: Quantity


@dataclass(frozen=True, kw_only=True, repr=False)
class FormulaTorque(Torque):
    """A torque of formulas of time, ω, L and the attitude; :func:`torque` makes one of a function.

    Parameters
    ----------
    axes
        ``"body"`` or ``"space"``: along which axes its components are.
    torque
        Three formulas, as scenario files have them.
    units
        ``"checked"``: numbers have units and dimensions are checked; ``"SI"``: all numbers are in SI, and nothing is checked.
    """

    model = "formula"
    axes: str
    torque: Sequence[str | float]
    units: str | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class FunctionTorque(Torque):
    """A torque that Python computes, at each step, from numbers: for what :func:`torque` cannot make a formula of.

    It has no power series, so DOP853 integrates it, and no file can hold it. It acts always: the function knows the time.

    Parameters
    ----------
    law
        A function as that of :func:`torque`; it is called with numbers and arrays, at each stage of each step. What it raises is raised by
        :func:`polhode.simulate`.
    axes
        ``"body"`` or ``"space"``: along which axes its components are.
    vectorized
        Whether one call is for many members of a :class:`polhode.Ensemble`, n of them: t (n,), ω, L and the torque that it gives (n, 3), the attitude n
        turns, and ``member`` (n,), their numbers from 0, which it may ask for besides. They are at times of their own, those that have come to the end are
        left out, and the torque of one must not depend on the others.

    Examples
    --------
    >>> import polhode
    >>> from polhode.scenario import FunctionTorque, Run
    >>> body = polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5])
    >>> pushed = polhode.Scenario(
    ...     body,
    ...     torques=[FunctionTorque(law=lambda t: [0.0, 0.0, 0.5 if t < 2.0 else 0.0])],
    ...     run=Run(duration=2.0, samples=2),
    ... )
    >>> float(polhode.simulate(pushed).omega[-1, 2].round(12))
    0.4

    Of a thousand bodies, each with a drag of its own, in some hundred calls:

    >>> import numpy as np
    >>> rng = np.random.default_rng(1)
    >>> drags, omega = rng.uniform(0.1, 0.3, 1000), rng.normal(size=(1000, 3))
    >>> drag = FunctionTorque(law=lambda omega, member: -drags[member, None] * omega, vectorized=True)
    >>> states = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega, torques=[drag]).at([0.0, 2.0])
    >>> states.omega.shape
    (1000, 2, 3)
    """

    model = "function"
    law: Any
    axes: str = "body"
    vectorized: bool = False

    def __post_init__(self) -> None:
        if "kinetic_energy" in asked(self.law, vectorized=_arrays.truth("FunctionTorque.vectorized", self.vectorized)):
            raise PolhodeError("a FunctionTorque is not told kinetic_energy: it is half the product of omega and momentum of a body without wheels")
        _arrays.choice("FunctionTorque.axes", self.axes, ["body", "space"])
        if (self.from_, self.until, self.pulses) != (None, None, None):
            raise PolhodeError("a FunctionTorque has no from_, until or pulses: its function knows the time")

    def to_dict(self) -> dict[str, Any]:
        """What stands for it in a text: nothing, by its name."""
        named = {key: value for key, value in (("name", self.name), ("on", self.on)) if value is not None}
        return {"model": "constant", **named, "axes": self.axes, "torque": [0.0, 0.0, 0.0]}


@dataclass(frozen=True, kw_only=True, repr=False)
class TorqueTable(Torque):
    """A torque that was measured: a CSV or Parquet file with ``time_s`` and ``torque_x_n_m`` …

    Parameters
    ----------
    axes
        ``"body"`` or ``"space"``.
    table
        The file.
    interpolation
        ``"steps"``, ``"linear"`` or ``"spline"``.
    scale
        A factor of all torques; 1 unless said.
    """

    model = "table"
    axes: str
    table_: str
    interpolation: str
    scale: float | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Wheel(Section):
    """A symmetric wheel whose axis is fixed in the body; the body's tensor holds the wheel's, as if it were locked.

    Parameters
    ----------
    axis
        (3,), body axes.
    momentum
        Along the axis at t = 0, N·m·s.
    inertia, speed
        Instead: about the axis, kg·m², and relative to the body, rad/s.
    motor_torque
        On the wheel along its axis, N·m; without one its speed is held.
    from_, until
        When the motor acts, s.
    name
        What reports call it.
    """

    table = "wheel"
    axis: npt.ArrayLike
    momentum: Quantity | None = None
    inertia: Quantity | None = None
    speed: Quantity | None = None
    motor_torque: Quantity | None = None
    from_: Quantity | None = None
    until: Quantity | None = None
    name: str | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Event(Section):
    """Something that is measured and passes a value.

    Parameters
    ----------
    measure
        ``"omega_body_z"``, ``"kinetic_energy"``, ``"angle"``, ``"nutation"``, ``"formula"`` and so on; or a function of the state, whose parameters are
        those of a law of :func:`torque` without ``kinetic_energy``, that gives a number. Python calls it with numbers and arrays along the motion; its
        changes of sign are found as those of other measures. It should be continuous, and no file can hold it. What it raises is raised by :func:`polhode.simulate`.
    value
        That it passes, in SI or with its unit; of a function a number, 0 unless said.
    direction
        ``"rising"``, ``"falling"`` or ``"either"``.
    then
        ``"record"``, ``"stop"``, or ``{"switch": "a torque", "on": False}``.
    between
        Two directions, of the measure ``"angle"``: ``{"body": [0, 0, 1]}`` and one of ``{"space": …}``, ``"nadir"``, ``"momentum"`` …
    formula
        A formula of the state, of the measure ``"formula"``.
    name
        What results call it.

    Examples
    --------
    When the body's z axis is within half a radian of where it began:

    >>> import numpy as np, polhode
    >>> from polhode.scenario import Event, Run, Start
    >>> def off(attitude):
    ...     return np.arccos(attitude.apply([0, 0, 1])[2])
    >>> racket = polhode.Scenario(
    ...     polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5]),
    ...     start=Start(omega=[0.0, 3.0, 0.1]),
    ...     events=[Event(name="away", measure=off, value=0.5, direction="rising", then="stop")],
    ...     run=Run(duration=10.0, samples=11),
    ... )
    >>> motion = polhode.simulate(racket)
    >>> motion.ending.kind, float(np.round(off(motion.rotations()[-1]), 12))
    ('stopped', 0.5)
    """

    table = "event"
    measure: str | Callable[..., Any]
    value: Quantity | None = None
    direction: str | None = None
    then: str | Mapping[str, Any] | None = None
    between: Sequence[Any] | None = None
    formula: str | None = None
    name: str | None = None

    def __post_init__(self) -> None:
        if callable(self.measure):
            measure = self.measure
            if "kinetic_energy" in asked(measure):
                raise PolhodeError('a function of an event is not told kinetic_energy: measure = "kinetic_energy" has it')
            if self.between is not None or self.formula is not None:
                raise PolhodeError("Event: between and formula mean nothing beside a function")
            object.__setattr__(self, "value", _arrays.number("event.value", 0.0 if self.value is None else self.value))
            # What stands for it where values are made plain.
            object.__setattr__(self, "measure", "formula")
            super().__post_init__()
            object.__setattr__(self, "measure", measure)
            return
        super().__post_init__()

    def to_dict(self) -> dict[str, Any]:
        """The keys of the table and their values, as files have them; for a function a formula stands that passes nothing."""
        table = super().to_dict()
        return {**table, "measure": "formula", "formula": "0"} if callable(self.measure) else table


@dataclass(frozen=True, kw_only=True, repr=False)
class Pointing(Section):
    """An angle that is of interest.

    Parameters
    ----------
    name
        Letters, digits and ``_``.
    body
        A direction of the body (3,).
    to
        ``"nadir"``, ``"velocity"``, ``"orbit_normal"``, ``"field"``, or ``{"space": [x, y, z]}``.
    """

    table = "pointing"
    name: str
    body: npt.ArrayLike
    to: str | Mapping[str, Any]


@dataclass(frozen=True, kw_only=True, repr=False)
class Orbit(Section):
    """The orbit of the centre of mass: exactly one of ``altitude``, ``radius``, ``rate``, ``position`` and ``semi_major_axis``.

    Parameters
    ----------
    mu
        µ = G M of the point mass, m³/s²; the Earth's unless said.
    altitude
        Of a circle about the Earth, above its equatorial radius, m.
    radius
        Of a circle, m.
    rate
        n of a circle, rad/s.
    radial, motion
        Of a circle: where the body is at t = 0, and whereto it moves, directions (3,) along space axes.
    position, velocity
        At t = 0, along space axes (3,), m and m/s.
    semi_major_axis
        a, m; negative of a hyperbola.
    eccentricity
        e
    inclination, node, periapsis
        Angles, rad.
    mean_anomaly, true_anomaly
        At t = 0, rad; one of them.
    """

    table = "orbit"
    mu: Quantity | None = None
    altitude: Quantity | None = None
    radius: Quantity | None = None
    rate: Quantity | None = None
    radial: npt.ArrayLike | None = None
    motion: npt.ArrayLike | None = None
    position: Vector | None = None
    velocity: Vector | None = None
    semi_major_axis: Quantity | None = None
    eccentricity: float | None = None
    inclination: Quantity | None = None
    node: Quantity | None = None
    periapsis: Quantity | None = None
    mean_anomaly: Quantity | None = None
    true_anomaly: Quantity | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Surface(Section):
    """What a body touches the ground with; it is convex, and the centre of mass lies in it.

    Parameters
    ----------
    shape
        ``"sphere"``, ``"ellipsoid"``, ``"rim"`` or ``"cylinder"``.
    radius
        Of a sphere, of a cylinder, of the circle of a rim, m.
    semi_axes
        Of an ellipsoid (3,), m.
    tube, thickness
        Of a rim: the radius of the tube round its circle, and the distance of the two rims of a thick disk, m.
    length
        Of a cylinder, m.
    position, rotate
        Its centre (3,), body axes, m, and how it is turned.
    """

    table = "surface"
    shape: str
    radius: Quantity | None = None
    semi_axes: Vector | None = None
    tube: Quantity | None = None
    thickness: Quantity | None = None
    length: Quantity | None = None
    position: Vector | None = None
    rotate: Turn | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Ground(Section):
    """What a body touches; its centre is the origin of space.

    Parameters
    ----------
    shape
        ``"plane"``, ``"sphere"`` or ``"cylinder"``.
    normal
        Of a plane (3,), towards the body; +z unless said.
    slope
        Instead: how steep it goes down towards +x, rad.
    radius, side, axis
        Of a sphere or a cylinder: m, ``"inside"`` or ``"outside"``, and a direction (3,).
    rate
        How fast it turns about its normal or axis, rad/s.
    """

    table = "ground"
    shape: str | None = None
    normal: npt.ArrayLike | None = None
    slope: Quantity | None = None
    radius: Quantity | None = None
    side: str | None = None
    axis: npt.ArrayLike | None = None
    rate: Quantity | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Contact(Section):
    """The ground on which a body rolls or slides.

    Parameters
    ----------
    surface
        What it touches the ground with.
    law
        ``"rolling"``, ``"friction"`` or ``"frictionless"``.
    ground
        What it touches; the level plane z = 0 unless said.
    friction, static_friction
        µ and µₛ.
    viscous
        Besides µ, N·s/m.
    rolling_friction, pivoting_friction
        Levers, m.
    gravity
        Along space axes (3,), m/s².
    at
        The point of the ground that is touched at t = 0 (3,), m.
    rolls
        The start rolls, where the body may slip.
    """

    table = "contact"
    surface: Surface
    law: str
    ground: Ground | None = None
    friction: float | None = None
    static_friction: float | None = None
    viscous: Quantity | None = None
    rolling_friction: Quantity | None = None
    pivoting_friction: Quantity | None = None
    gravity: Vector | None = None
    at: Vector | None = None
    rolls: bool | None = None

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Contact:
        """A table of these keys and values."""
        inner = {key: kind.from_dict(table[key]) for key, kind in (("surface", Surface), ("ground", Ground)) if key in table}
        return super().from_dict({**table, **inner})


@dataclass(frozen=True, kw_only=True, repr=False)
class GimbalAxis(Section):
    """An axis of a rotor in gimbals: how it starts, what holds it, and, of ``outer`` and ``inner``, the gimbal that turns about it.

    Parameters
    ----------
    angle, rate
        At t = 0, rad and rad/s; of a locked axis the angle, of a driven one the rate, always.
    locked, driven
        A lock keeps the angle, a motor the rate.
    damping, spring, rest, torque
        N·m·s/rad, N·m/rad, the angle where the spring is at rest, rad, and a constant torque, N·m.
    moments, inertia, products
        Of the gimbal, kg·m²: three moments, or a tensor (3, 3) and the sign of its products.
    mass, center_of_mass, about
        Of a gimbal that hangs: kg, m (3,), and the point that its tensor is about.
    """

    table = "axis"
    angle: Quantity | None = None
    rate: Quantity | None = None
    locked: bool | None = None
    driven: bool | None = None
    damping: Quantity | None = None
    spring: Quantity | None = None
    rest: Quantity | None = None
    torque: Quantity | None = None
    moments: Vector | None = None
    inertia: Any | None = None
    products: str | None = None
    mass: Quantity | None = None
    center_of_mass: Vector | None = None
    about: str | Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class GimbalBase(Section):
    """What carries gimbals: on the Earth at a ``latitude``, rad, or turning at a constant ``rate`` (3,), rad/s."""

    table = "base"
    latitude: Quantity | None = None
    rate: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Gimbals(Section):
    """Two gimbals in which the body hangs as a rotor; their axes say how it starts.

    Parameters
    ----------
    outer_axis, inner_axis
        Directions (3,) in the base with all angles zero, perpendicular to each other.
    rotor_axis
        Direction (3,) in the body; +z unless said.
    crossing
        Where the axes cross (3,), body axes, m; the centre of mass unless said.
    outer, inner, rotor
        The axes.
    base
        What carries them; at rest unless said.
    gravity
        Along the axes of the base (3,), m/s²; 9.80665 along −z unless said.
    """

    table = "gimbals"
    outer_axis: npt.ArrayLike
    inner_axis: npt.ArrayLike
    rotor_axis: npt.ArrayLike | None = None
    crossing: Vector | None = None
    outer: GimbalAxis | None = None
    inner: GimbalAxis | None = None
    rotor: GimbalAxis | None = None
    base: GimbalBase | None = None
    gravity: Vector | None = None

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Gimbals:
        """A table of these keys and values."""
        axes: tuple[tuple[str, type[Section]], ...] = (
            ("outer", GimbalAxis),
            ("inner", GimbalAxis),
            ("rotor", GimbalAxis),
            ("base", GimbalBase),
        )
        return super().from_dict({**table, **{key: kind.from_dict(table[key]) for key, kind in axes if key in table}})


@dataclass(frozen=True, kw_only=True, repr=False)
class Burn(Section):
    """A part that becomes lighter at a steady rate: ``part`` by its name, ``from_`` and ``until``, s, and what is ``left``, kg."""

    table = "burn"
    part: str
    until: Quantity
    from_: Quantity | None = None
    left: Quantity | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Drop(Section):
    """A part that is dropped: ``part`` by its name, and the ``time``, s."""

    table = "drop"
    part: str
    time: Quantity


@dataclass(frozen=True, kw_only=True, repr=False)
class Exit(Section):
    """Where mass leaves: its centre ``position`` (3,), m, ``radius``, m, and ``axis`` (3,) of a disc, its ``share`` of the flow."""

    table = "exit"
    position: Vector
    radius: Quantity | None = None
    axis: npt.ArrayLike | None = None
    share: float | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class MassHistory(Section):
    """How the mass properties change with time.

    Parameters
    ----------
    burn, drop, exit
        Of :class:`Burn`, :class:`Drop` and :class:`Exit`.
    table_
        Instead of the first two: a CSV file of the whole body at times.
    products
        What its products are: ``"negative_integral"`` or ``"positive_integral"``.
    in_place
        What leaves stays where it was, with the velocity that it has there.
    """

    table = "mass_history"
    burn: Sequence[Burn] | None = None
    drop: Sequence[Drop] | None = None
    table_: str | None = None
    products: str | None = None
    exit: Sequence[Exit] | None = None
    in_place: bool | None = None

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> MassHistory:
        """A table of these keys and values."""
        kinds: tuple[tuple[str, type[Section]], ...] = (("burn", Burn), ("drop", Drop), ("exit", Exit))
        inner = {key: [kind.from_dict(one) for one in table[key]] for key, kind in kinds if key in table}
        return super().from_dict({**table, **inner})


@dataclass(frozen=True, kw_only=True, repr=False)
class Prescribed(Section):
    """A motion that is given; the torque that it needs is the answer.

    Parameters
    ----------
    axis, rate, acceleration
        About an axis (3,) fixed in the body: rad/s and rad/s².
    euler313, rates
        φ, θ, ψ (3,) at t = 0, rad, and their constant rates, rad/s.
    angles, quaternion
        Formulas of t: of φ, θ, ψ, or of w, x, y, z.
    omega
        ``{"body": …}`` or ``{"space": …}``: three formulas of t.
    table_, columns
        A CSV file, and which of its columns.
    """

    table = "prescribed"
    axis: npt.ArrayLike | None = None
    rate: Quantity | None = None
    acceleration: Quantity | None = None
    euler313: Vector | None = None
    rates: Vector | None = None
    angles: Sequence[Quantity] | None = None
    quaternion: Sequence[Quantity] | None = None
    omega: Mapping[str, Any] | None = None
    table_: str | None = None
    columns: str | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Balance(Section):
    """Planes for correction masses: distances of ``planes`` along the shaft, m, and ``radii`` of the masses, m."""

    table = "balance"
    planes: Sequence[Quantity]
    radii: Sequence[Quantity]


@dataclass(frozen=True, kw_only=True, repr=False)
class Shaft(Section):
    """A body on two bearings that turns about a line.

    Parameters
    ----------
    axis
        (3,), body axes.
    bearings
        Where they are along the axis (2,), m.
    rate
        rad/s
    point
        On the axis (3,), body axes, m.
    acceleration
        rad/s²
    gravity
        Along space axes (3,), m/s²; none unless said.
    balance
        Planes for correction masses.
    """

    table = "shaft"
    axis: npt.ArrayLike
    bearings: Vector
    rate: Quantity
    point: Vector | None = None
    acceleration: Quantity | None = None
    gravity: Vector | None = None
    balance: Balance | None = None

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Shaft:
        """A table of these keys and values."""
        inner = {"balance": Balance.from_dict(table["balance"])} if "balance" in table else {}
        return super().from_dict({**table, **inner})


@dataclass(frozen=True, kw_only=True, repr=False)
class Pendulum(Section):
    """The axis from which a body hangs under :class:`Gravity`.

    Parameters
    ----------
    axis
        (3,), body axes, through the pivot.
    amplitude
        Of the swing, below π, rad; that of the start unless said.
    """

    table = "pendulum"
    axis: npt.ArrayLike
    amplitude: Quantity | None = None


def torque(law: Any, *, axes: str = "body", **others: Any) -> FormulaTorque:
    """A torque of your own, from a function of the state that gives three components, N·m.

    The function is called once, with symbols, for those of its parameters that have no default: ``t``, s; ``omega``, ``omega_space``: ω along body
    axes and along those of space (3,), rad/s; ``momentum``, ``momentum_space``: L (3,), N·m·s; ``kinetic_energy``, J; and ``attitude``, which has
    ``as_matrix()``, ``as_quat()`` and ``apply(vector, inverse=False)`` as SciPy's rotations have. Operators and NumPy's functions make formulas of
    them, which are integrated as built-in torques are, in ensembles too. All numbers are in SI. :func:`where` chooses; a function that branches on a
    symbol is refused.

    Parameters
    ----------
    law
        The function.
    axes
        ``"body"`` or ``"space"``: along which axes the components are.
    others
        What every :class:`Torque` may have.

    Examples
    --------
    >>> import numpy as np
    >>> from polhode.scenario import torque
    >>> def brake(t, omega, coefficient=0.05):
    ...     return -coefficient * omega * (1 - np.exp(-t / 2.0))
    >>> torque(brake).torque[0]
    '-0.05*wx*(1-exp(-t/2))'
    """
    return FormulaTorque(axes=axes, torque=formula_torque(law), units="SI", **others)
