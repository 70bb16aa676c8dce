"""Tables of a scenario: start, torques, events, run and others.

Each class is a table of a
`scenario file <https://github.com/polhode/polhode/blob/main/book/scenario.md>`_ and has its keys as
keyword arguments. A key that is a Python keyword ends in ``_``. A quantity is a number in SI units,
or a text with its unit, such as ``"12 mm"``. A vector is any array (3,) or a list of three
quantities. :class:`polhode.Scenario` combines the tables.

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
from ._deprecated import Former, former_keyword
from ._error import PolhodeError
from ._traced_function import asked, formula_torque, where
from ._section import Section, plain, rotation, written
from ._units import Quantity

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

#: A rotation: a quaternion (w, x, y, z), a matrix (3, 3), a ``scipy.spatial.transform.Rotation``, or
#: a form used in files, such as ``{"euler313": [0, 0.3, 0]}`` or
#: ``{"axis": [0, 0, 1], "angle": "90 deg"}``.
Turn = Mapping[str, Any] | Any


class Part(Section):
    """A part of the body with a shape, as in scenario files.

    The keywords are ``shape`` and the keys of that shape, of its material and of its placement.

    >>> from polhode.scenario import Part
    >>> Part(shape="cylinder", radius="20 mm", length=0.3, material="oak", position=[0, 0, "15 cm"])
    Part(shape='cylinder', radius='20 mm', length=0.3, material='oak', position=(0, 0, '15 cm'))
    """

    table = "part"

    def __init__(self, **keys: Any) -> None:
        given = {key: value for key, value in keys.items() if value is not None}
        object.__setattr__(self, "_keys", {key: (rotation if key == "rotate" else plain)(f"part.{key}", value) for key, value in given.items()})

    def to_dict(self) -> dict[str, Any]:
        """Returns the keys of the table and their values, as in files."""
        return {key: written(value) for key, value in self._keys.items()}  # type: ignore[attr-defined]

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Part:
        """Makes a table of these keys and values."""
        return cls(**table)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Part) and self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Part({', '.join(f'{key}={value!r}' for key, value in self._keys.items())})"  # type: ignore[attr-defined]


@dataclass(frozen=True, kw_only=True, repr=False)
class Start(Section):
    """Initial attitude, angular velocity and velocity at t = 0.

    Parameters
    ----------
    attitude
        Attitude R_space_body: a quaternion (w, x, y, z), a matrix (3, 3), a
        ``scipy.spatial.transform.Rotation``, or a form used in files, such as
        ``{"euler313": [0, "30 deg", 0]}``. The default is body axes parallel to space axes. With
        ``relative_to="orbit"``, R_orbit_body.
    omega
        Angular velocity (3,), body axes, rad/s.
    omega_space
        Instead of ``omega``: angular velocity (3,), space axes, rad/s.
    momentum
        Instead of ``omega``: angular momentum (3,), space axes, kg·m²/s, including that of wheels.
    velocity
        Velocity of the centre of mass (3,), space axes, m/s.
    relative_to
        Frame of attitude and angular velocity: ``"space"``, or ``"orbit"`` for the axes of the
        orbit, which rotate themselves.
    """

    table = "start"
    _ROTATIONS = frozenset({"attitude"})
    attitude: Turn | None = None
    omega: Vector | None = None
    omega_space: Vector | None = None
    momentum: Vector | None = None
    velocity: Vector | None = None
    relative_to: str | None = None

    #: Keys of the angular velocity in files, by the names of the arguments.
    _SPIN: ClassVar[dict[str, str]] = {"omega": "body", "omega_space": "space", "momentum": "momentum"}

    def to_dict(self) -> dict[str, Any]:
        """Returns the keys of the table and their values, as in files."""
        table = super().to_dict()
        spin = {key: table.pop(name) for name, key in self._SPIN.items() if name in table}
        return {**table, "spin": spin} if spin else table

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Start:
        """Makes a table of these keys and values."""
        names = {key: name for name, key in cls._SPIN.items()}
        spin = {names[key]: value for key, value in table.get("spin", {}).items()}
        return cls(**spin, **{key: value for key, value in table.items() if key != "spin"})


@dataclass(frozen=True, kw_only=True, repr=False)
class Run(Section):
    """Duration, sample times and method of the computation.

    Parameters
    ----------
    duration
        Duration, s; or a number of orbits, as ``"2 orbits"``.
    samples
        Number of sample times, evenly spaced from 0 to the end. The default is 1001.
    every
        Instead of ``samples``: interval between sample times, s.
    method
        Method: ``"auto"``, ``"exact"``, ``"taylor"``, ``"dop853"`` or ``"splitting"``.
    tolerance
        Error tolerance per step, rad. The default is 1e-13.
    order
        Order of the splitting method: 2, 4 or 6.
    step
        Step size of the splitting method, s.
    table_
        Output of the command: ``"csv"``, ``"parquet"``, or both.
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
    """A train of pulses: pulse k begins at ``first`` + k ``period`` and lasts for ``width``.

    Parameters
    ----------
    width, period
        Duration of a pulse, and interval between the beginnings of pulses, s.
    first
        Beginning of the first pulse, s. The default is 0.
    count
        Number of pulses. By default, they do not end.
    """

    table = "pulses"
    width: Quantity
    period: Quantity
    first: Quantity | None = None
    count: int | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Torque(Section):
    """A torque, with the keys that all torques have.

    It acts about the centre of mass, or about the pivot of a held body.

    Parameters
    ----------
    name
        Name for use in events.
    on
        If ``False``, the torque is off until an event switches it on.
    from_, until
        Interval in which the torque acts, s. By default, it always acts.
    pulses
        Instead of an interval: :class:`Pulses` during which the torque acts.
    """

    table = "torque"
    #: Name of the model in files.
    model: ClassVar[str]
    name: str | None = None
    on: bool | None = None
    from_: Quantity | None = None
    until: Quantity | None = None
    pulses: Pulses | None = None

    def to_dict(self) -> dict[str, Any]:
        """Returns the keys of the table and their values, as in files."""
        return {"model": self.model, **super().to_dict()}

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Torque:
        """Makes a torque of the model that the table names."""
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
        Axes in which the components are constant: ``"body"`` or ``"space"``.
    torque
        Torque (3,), N·m.
    """

    model = "constant"
    axes: str
    torque: Vector


@dataclass(frozen=True, kw_only=True, repr=False)
class Gravity(Torque):
    """Uniform gravity on a body that is held at a pivot.

    Parameters
    ----------
    pivot
        Pivot (3,), body axes, m, unless given by ``Scenario(pivot=…)``.
    acceleration
        Gravitational acceleration (3,), space axes, m/s². The default is (0, 0, −9.80665).
    """

    model = "gravity"
    pivot: Vector | None = None
    acceleration: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class GravityGradient(Torque):
    """Gravity-gradient torque of the point mass that the body orbits: N = 3 (µ/r³) r̂ × I r̂.

    Parameters
    ----------
    mass
        ``"tensor"``, or ``"points"`` for the exact sum over the points of a body of particles.
    """

    model = "gravity_gradient"
    mass: str | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Drag(Torque):
    """A torque that opposes the angular velocity.

    Parameters
    ----------
    law
        Law: ``"linear"``, N = −C ω, or ``"quadratic"``, N = −|ω| D ω.
    coefficient
        Coefficient C, N·m·s, or D, N·m·s²: one number for all axes, (3,) in body axes, or (3, 3).
    """

    model = "drag"
    law: str
    coefficient: Quantity | npt.ArrayLike


@dataclass(frozen=True, kw_only=True, repr=False)
class Torsion(Torque):
    """A torsion spring or a torsion wire.

    Parameters
    ----------
    stiffness
        Stiffness κ, N·m/rad.
    rest
        Attitude without torque, a rotation. The default is body axes parallel to space axes.
    axis
        Axis of a wire (3,), space axes. The wire resists only the twist about it.
    """

    model = "torsion"
    _ROTATIONS = frozenset({"rest"})
    stiffness: Quantity
    rest: Turn | None = None
    axis: npt.ArrayLike | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Thruster(Torque):
    """A force at a point of the body, fixed in the body.

    Parameters
    ----------
    position
        Point of application (3,), body axes, m.
    force
        Force (3,), body axes, N.
    """

    model = "thruster"
    position: Vector
    force: Vector


@dataclass(frozen=True, kw_only=True, repr=False)
class Magnetic(Torque):
    """Torque on a magnetic moment that is fixed in the body, in a field: N = m × B.

    Parameters
    ----------
    moment
        Magnetic moment (3,), body axes, A·m².
    field
        Uniform field B (3,), space axes, T.
    dipole
        Instead of ``field``: moment of a dipole at the centre of the orbit (3,), space axes, A·m².
    """

    model = "magnetic"
    moment: Vector
    field: Vector | None = None
    dipole: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class EnergySink(Torque):
    """Internal dissipation: L is constant, and T decreases at the rate α ‖L × ω‖².

    Parameters
    ----------
    coefficient
        Coefficient α, 1/(N·m·s).
    """

    model = "energy_sink"
    coefficient: Quantity


@dataclass(frozen=True, kw_only=True, repr=False)
class FormulaTorque(Torque):
    """A torque given by formulas of time, ω, L and the attitude.

    :func:`torque` makes one from a function.

    Parameters
    ----------
    axes
        Axes of the components: ``"body"`` or ``"space"``.
    torque
        Three formulas, as in scenario files.
    units
        Units of numbers: ``"checked"``, with units and a check of dimensions, or ``"SI"``, without
        a check.
    """

    model = "formula"
    axes: str
    torque: Sequence[str | float]
    units: str | None = None


@former_keyword("law", "function")
@dataclass(frozen=True, kw_only=True, repr=False)
class FunctionTorque(Torque):
    """A torque that a Python function computes at each step.

    Use it for functions that :func:`torque` cannot trace.

    It has no power series, so DOP853 integrates it. No file can hold it. It always acts; the
    function receives the time.

    Parameters
    ----------
    function
        A function with the parameters described in :func:`torque`. It is called with numbers and
        arrays at each stage of each step. :func:`polhode.simulate` raises its exceptions.
    axes
        Axes of the components: ``"body"`` or ``"space"``.
    vectorized
        If true, one call computes many members of a :class:`polhode.Ensemble`, n of them: t (n,),
        ω, L and the returned torque (n, 3), and the attitude of n rotations. The function may also
        take ``member`` (n,), their indices from 0. Each member has its own time, finished members
        are absent, and the torque of a member must not depend on the others.

    Examples
    --------
    >>> import polhode
    >>> from polhode.scenario import FunctionTorque, Run
    >>> body = polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5])
    >>> pushed = polhode.Scenario(
    ...     body,
    ...     torques=[FunctionTorque(function=lambda t: [0.0, 0.0, 0.5 if t < 2.0 else 0.0])],
    ...     run=Run(duration=2.0, samples=2),
    ... )
    >>> float(polhode.simulate(pushed).omega[-1, 2].round(12))
    0.4

    A thousand bodies, each with its own drag, computed in about a hundred calls:

    >>> import numpy as np
    >>> rng = np.random.default_rng(1)
    >>> drags, omega = rng.uniform(0.1, 0.3, 1000), rng.normal(size=(1000, 3))
    >>> drag = FunctionTorque(function=lambda omega, member: -drags[member, None] * omega, vectorized=True)
    >>> states = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega, torques=[drag]).at([0.0, 2.0])
    >>> states.omega.shape
    (1000, 2, 3)
    """

    model = "function"
    function: Any
    axes: str = "body"
    vectorized: bool = False

    def __post_init__(self) -> None:
        if "kinetic_energy" in asked(self.function, vectorized=_arrays.truth("FunctionTorque.vectorized", self.vectorized)):
            raise PolhodeError("a FunctionTorque does not receive kinetic_energy: for a body without wheels compute it as omega · momentum / 2")
        _arrays.choice("FunctionTorque.axes", self.axes, ["body", "space"])
        if (self.from_, self.until, self.pulses) != (None, None, None):
            raise PolhodeError("a FunctionTorque has no from_, until or pulses: use the time t in its function")

    law = Former("FunctionTorque.law", "function")

    def __setstate__(self, state: dict[str, Any]) -> None:
        # Copies of the former version have ``law``.
        vars(self).update({"function" if name == "law" else name: value for name, value in state.items()})

    def to_dict(self) -> dict[str, Any]:
        """Returns a zero torque of the same name, for texts, which cannot hold the function."""
        named = {key: value for key, value in (("name", self.name), ("on", self.on)) if value is not None}
        return {"model": "constant", **named, "axes": self.axes, "torque": [0.0, 0.0, 0.0]}


@dataclass(frozen=True, kw_only=True, repr=False)
class TorqueTable(Torque):
    """A measured torque: a CSV or Parquet file with the columns ``time_s`` and ``torque_x_n_m`` …

    Parameters
    ----------
    axes
        Axes of the components: ``"body"`` or ``"space"``.
    table_
        Path of the file.
    interpolation
        Interpolation: ``"steps"``, ``"linear"`` or ``"spline"``.
    scale
        Factor for all torques. The default is 1.
    """

    model = "table"
    axes: str
    table_: str
    interpolation: str
    scale: float | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Wheel(Section):
    """A symmetric wheel whose axis is fixed in the body.

    The tensor of the body includes the wheel as if it were locked.

    Parameters
    ----------
    axis
        Axis (3,), body axes.
    momentum
        Momentum along the axis at t = 0, N·m·s.
    inertia, speed
        Instead of ``momentum``: moment of inertia about the axis, kg·m², and speed relative to the
        body, rad/s.
    motor_torque
        Torque on the wheel along its axis, N·m. Without a motor torque, the speed is constant.
    from_, until
        Interval in which the motor acts, s.
    name
        Name of the wheel in reports.
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
    """An event: a measure passes a value.

    Parameters
    ----------
    measure
        ``"omega_body_z"``, ``"kinetic_energy"``, ``"angle"``, ``"nutation"``, ``"formula"`` and
        others; or a function of the state that returns a number. Its parameters are those described
        in :func:`torque`, without ``kinetic_energy``. Python calls it with numbers and arrays along
        the motion, and its sign changes are found as for other measures. It should be continuous,
        and it cannot be written into a file. :func:`polhode.simulate` raises its exceptions.
    value
        Value that the measure passes, in SI units or with its unit; for a function a number, by
        default 0.
    direction
        Direction of the change: ``"rising"``, ``"falling"`` or ``"either"``.
    then
        Action: ``"record"``, ``"stop"``, or ``{"switch": "a torque", "on": False}``.
    between
        Two directions for the measure ``"angle"``: ``{"body": [0, 0, 1]}`` and one of
        ``{"space": …}``, ``"nadir"``, ``"momentum"`` …
    formula
        Formula of the state for the measure ``"formula"``.
    name
        Name of the event in results.

    Examples
    --------
    Motion until the body's z axis has departed by half a radian from its initial direction:

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
                raise PolhodeError('the function of an event does not receive kinetic_energy: use measure = "kinetic_energy"')
            if self.between is not None or self.formula is not None:
                raise PolhodeError("Event: between and formula have no effect with a function")
            object.__setattr__(self, "value", _arrays.number("event.value", 0.0 if self.value is None else self.value))
            # A placeholder while values are converted.
            object.__setattr__(self, "measure", "formula")
            super().__post_init__()
            object.__setattr__(self, "measure", measure)
            return
        super().__post_init__()

    def to_dict(self) -> dict[str, Any]:
        """Returns the keys of the table and their values, as in files.

        A function is replaced by a formula that never passes the value.
        """
        table = super().to_dict()
        return {**table, "measure": "formula", "formula": "0"} if callable(self.measure) else table


@dataclass(frozen=True, kw_only=True, repr=False)
class Pointing(Section):
    """A pointing angle to report: the angle between a direction of the body and a target.

    Parameters
    ----------
    name
        Name of letters, digits and ``_``.
    body
        Direction in the body (3,).
    to
        Target: ``"nadir"``, ``"velocity"``, ``"orbit_normal"``, ``"field"``, or
        ``{"space": [x, y, z]}``.
    limit
        Largest angle that is allowed, rad, between 0 and π: results say for which share of the
        time the angle is within it.
    """

    table = "pointing"
    name: str
    body: npt.ArrayLike
    to: str | Mapping[str, Any]
    limit: Quantity | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Orbit(Section):
    """The orbit of the centre of mass.

    It takes exactly one of ``altitude``, ``radius``, ``rate``, ``position`` and
    ``semi_major_axis``.

    Parameters
    ----------
    mu
        Gravitational parameter µ = G M of the point mass, m³/s². The default is that of the Earth.
    altitude
        Altitude of a circular orbit above the equatorial radius of the Earth, m.
    radius
        Radius of a circular orbit, m.
    rate
        Mean motion n of a circular orbit, rad/s.
    radial, motion
        For a circular orbit: directions (3,) of the position and of the motion at t = 0, space
        axes.
    position, velocity
        Position and velocity at t = 0 (3,), space axes, m and m/s.
    semi_major_axis
        Semi-major axis a, m; negative for a hyperbola.
    eccentricity
        Eccentricity e.
    inclination, node, periapsis
        Inclination, longitude of the node and argument of periapsis, rad.
    mean_anomaly, true_anomaly
        Anomaly at t = 0, rad: one of the two.
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
    """The surface with which a body touches the ground.

    It is convex and contains the centre of mass.

    Parameters
    ----------
    shape
        Shape: ``"sphere"``, ``"ellipsoid"``, ``"rim"`` or ``"cylinder"``.
    radius
        Radius of a sphere, of a cylinder, or of the circle of a rim, m.
    semi_axes
        Semi-axes of an ellipsoid (3,), m.
    tube, thickness
        For a rim: radius of the tube around its circle, and distance of the two rims of a thick
        disk, m.
    length
        Length of a cylinder, m.
    position, rotate
        Centre (3,), body axes, m, and rotation of the surface.
    """

    table = "surface"
    _ROTATIONS = frozenset({"rotate"})
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
    """The ground that a body touches. Its centre is the origin of space.

    Parameters
    ----------
    shape
        Shape: ``"plane"``, ``"sphere"`` or ``"cylinder"``.
    normal
        Normal of a plane (3,), towards the body. The default is +z.
    slope
        Instead of ``normal``: downward slope towards +x, rad.
    radius, side, axis
        For a sphere or a cylinder: radius, m, ``"inside"`` or ``"outside"``, and the direction of
        the axis (3,).
    rate
        Rate of rotation of the ground about its normal or axis, rad/s.
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
    """Contact with the ground on which a body rolls or slides.

    Parameters
    ----------
    surface
        Surface of the body.
    law
        Contact law: ``"rolling"``, ``"friction"`` or ``"frictionless"``.
    ground
        Ground. The default is the level plane z = 0.
    friction, static_friction
        Coefficients of kinetic and static friction, µ and µₛ.
    viscous
        Coefficient of viscous friction in addition to µ, N·s/m.
    rolling_friction, pivoting_friction
        Moment arms of rolling and pivoting friction, m.
    gravity
        Gravitational acceleration (3,), space axes, m/s².
    at
        Contact point on the ground at t = 0 (3,), m.
    rolls
        If true, the body rolls at the start, although the law allows slip.
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
        """Makes a table of these keys and values."""
        inner = {key: kind.from_dict(table[key]) for key, kind in (("surface", Surface), ("ground", Ground)) if key in table}
        return super().from_dict({**table, **inner})


@dataclass(frozen=True, kw_only=True, repr=False)
class GimbalAxis(Section):
    """An axis of a rotor in gimbals: its initial state, constraint, and forces.

    For ``outer`` and ``inner``, it also describes the gimbal that turns about the axis.

    Parameters
    ----------
    angle, rate
        Angle and rate at t = 0, rad and rad/s. A locked axis keeps the angle, and a driven axis the
        rate.
    locked, driven
        If true, a lock keeps the angle, or a motor keeps the rate.
    damping, spring, rest, torque
        Damping, N·m·s/rad; spring stiffness, N·m/rad; rest angle of the spring, rad; constant
        torque, N·m.
    moments, inertia, products
        Inertia of the gimbal, kg·m²: three moments, or a tensor (3, 3) and the sign convention of
        its products.
    mass, center_of_mass, about
        For a gimbal with weight: mass, kg, centre of mass (3,), m, and reference point of its
        tensor.
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
    """The base of gimbals.

    It is on the Earth at a ``latitude``, rad, or rotates at a constant ``rate`` (3,), rad/s.
    """

    table = "base"
    latitude: Quantity | None = None
    rate: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Gimbals(Section):
    """Two gimbals that hold the body as a rotor. Their axes define the start.

    Parameters
    ----------
    outer_axis, inner_axis
        Directions (3,) in the base with all angles zero, perpendicular to each other.
    rotor_axis
        Direction (3,) in the body. The default is +z.
    crossing
        Intersection of the axes (3,), body axes, m. The default is the centre of mass.
    outer, inner, rotor
        States and properties of the axes.
    base
        Base of the gimbals. The default is a base at rest.
    gravity
        Gravitational acceleration (3,), base axes, m/s². The default is 9.80665 along −z.
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
        """Makes a table of these keys and values."""
        axes: tuple[tuple[str, type[Section]], ...] = (
            ("outer", GimbalAxis),
            ("inner", GimbalAxis),
            ("rotor", GimbalAxis),
            ("base", GimbalBase),
        )
        return super().from_dict({**table, **{key: kind.from_dict(table[key]) for key, kind in axes if key in table}})


@dataclass(frozen=True, kw_only=True, repr=False)
class Burn(Section):
    """Mass loss of a part at a constant rate.

    ``part`` is its name, ``from_`` and ``until`` the interval, s, and ``left`` the final mass, kg.
    """

    table = "burn"
    part: str
    until: Quantity
    from_: Quantity | None = None
    left: Quantity | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Drop(Section):
    """Release of a part: its name ``part``, and the ``time``, s."""

    table = "drop"
    part: str
    time: Quantity


@dataclass(frozen=True, kw_only=True, repr=False)
class Exit(Section):
    """A disk through which mass leaves.

    ``position`` (3,), m, is its centre, ``radius``, m, its radius, ``axis`` (3,) its normal, and
    ``share`` its fraction of the flow.
    """

    table = "exit"
    position: Vector
    radius: Quantity | None = None
    axis: npt.ArrayLike | None = None
    share: float | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class MassHistory(Section):
    """Change of the mass properties with time.

    Parameters
    ----------
    burn, drop, exit
        Lists of :class:`Burn`, :class:`Drop` and :class:`Exit`.
    table_
        Instead of ``burn`` and ``drop``: a CSV file with the mass properties of the whole body at
        times.
    products
        Sign convention of the products in the file: ``"negative_integral"`` or
        ``"positive_integral"``.
    in_place
        If true, mass leaves from its own position, with the velocity of the body there.
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
        """Makes a table of these keys and values."""
        kinds: tuple[tuple[str, type[Section]], ...] = (("burn", Burn), ("drop", Drop), ("exit", Exit))
        inner = {key: [kind.from_dict(one) for one in table[key]] for key, kind in kinds if key in table}
        return super().from_dict({**table, **inner})


@dataclass(frozen=True, kw_only=True, repr=False)
class Prescribed(Section):
    """A prescribed motion, for which the required torque is computed.

    Parameters
    ----------
    axis, rate, acceleration
        Rotation about an axis (3,) fixed in the body: rad/s and rad/s².
    euler313, rates
        Euler angles φ, θ, ψ (3,) at t = 0, rad, and their constant rates, rad/s.
    angles, quaternion
        Formulas of t: for φ, θ, ψ, or for w, x, y, z.
    omega
        Angular velocity as three formulas of t: ``{"body": …}`` or ``{"space": …}``.
    table_, columns
        Path of a CSV file, and the meaning of its columns.
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
    """Planes for correction masses.

    ``planes`` are their positions along the shaft, m, and ``radii`` those of the masses, m.
    """

    table = "balance"
    planes: Sequence[Quantity]
    radii: Sequence[Quantity]


@dataclass(frozen=True, kw_only=True, repr=False)
class Shaft(Section):
    """A body on a shaft in two bearings.

    Parameters
    ----------
    axis
        Axis of the shaft (3,), body axes.
    bearings
        Positions of the bearings along the axis (2,), m.
    rate
        Rate of rotation, rad/s.
    point
        Point on the axis (3,), body axes, m.
    acceleration
        Angular acceleration, rad/s².
    gravity
        Gravitational acceleration (3,), space axes, m/s². The default is no gravity.
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
        """Makes a table of these keys and values."""
        inner = {"balance": Balance.from_dict(table["balance"])} if "balance" in table else {}
        return super().from_dict({**table, **inner})


@dataclass(frozen=True, kw_only=True, repr=False)
class Pendulum(Section):
    """The axis of a body that swings under :class:`Gravity`.

    Parameters
    ----------
    axis
        Axis through the pivot (3,), body axes.
    amplitude
        Amplitude of the swing, below π, rad. The default follows from the start.
    """

    table = "pendulum"
    axis: npt.ArrayLike
    amplitude: Quantity | None = None


@former_keyword("law", "function")
def torque(function: Any, *, axes: str = "body", **others: Any) -> FormulaTorque:
    """Makes a torque from a function of the state that returns three components, N·m.

    The function is called once, with symbols for its parameters that have no default: ``t``, s;
    ``omega`` and ``omega_space``, angular velocity (3,) in body and space axes, rad/s; ``momentum``
    and ``momentum_space``, angular momentum (3,), N·m·s; ``kinetic_energy``, J; and ``attitude``,
    with ``as_matrix()``, ``as_quat()``, ``as_rotvec()``, ``as_euler(seq, degrees=False)``,
    ``inv()`` and ``apply(vector, inverse=False)`` as in SciPy's rotations. Operators and NumPy
    functions of symbols give formulas, which are integrated like built-in torques, also in
    ensembles. All numbers are in SI units. Use :func:`where` or ``np.where`` for a choice; a
    function that branches on a symbol is refused.

    Parameters
    ----------
    function
        Function of the state.
    axes
        Axes of the components: ``"body"`` or ``"space"``.
    others
        Further arguments of :class:`Torque`.

    Examples
    --------
    >>> import numpy as np
    >>> from polhode.scenario import torque
    >>> def brake(t, omega, coefficient=0.05):
    ...     return -coefficient * omega * (1 - np.exp(-t / 2.0))
    >>> torque(brake).torque[0]
    '-0.05*wx*(1-exp(-t/2))'

    A controller with saturation, towards the attitude of the space axes:

    >>> def control(omega, attitude):
    ...     return np.clip(-0.4 * attitude.as_rotvec() - 0.6 * omega, -0.1, 0.1)
    >>> torque(control).torque[0].startswith("clip(")
    True
    """
    return FormulaTorque(axes=axes, torque=formula_torque(function), units="SI", **others)
