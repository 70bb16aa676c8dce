"""Identification of mass properties from measured motion."""

from __future__ import annotations

import os
from typing import Iterable, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _rotation, _toml
from ._error import PolhodeError
from ._flight import Flight, as_long
from ._identified import PayloadResult, SwingResult, TumbleResult, identified_of
from ._mass_properties import warn_of
from ._units import Quantity


def identify(plan: str | os.PathLike[str] | Mapping[str, object]) -> TumbleResult | SwingResult | PayloadResult:
    """Estimates a body's mass properties from its measured motion (``polhode identify``).

    Parameters
    ----------
    plan
        A path; the text of a plan, a ``str`` of more than one line; or the plan as a dictionary,
        whose arrays may be NumPy arrays. Paths in a text or a dictionary are relative to the
        current folder. The book's ``identify.md`` lists all keys.

    Returns
    -------
    TumbleResult, SwingResult or PayloadResult
        The type depends on the plan's table: ``[tumble]``, ``[swing]`` or ``[payload]``.

    Raises
    ------
    PolhodeError
        If the plan or a log cannot be read (the message names the place), if there are too few data
        for the requested numbers, or if rates are in a different unit.

    Warns
    -----
    PolhodeWarning
        For each finding: residuals that are more than noise, excluded readings, undetermined
        numbers.

    See Also
    --------
    identify_tumbles, identify_swings, identify_payload : The same from arrays.

    Examples
    --------
    A body on a knife edge 31.2 cm above its centre of mass, as a text:

    >>> import polhode, warnings
    >>> plan = '''
    ... title = "A bat"
    ... [swing]
    ... mass = { value = "0.912 kg", sd = "1 g" }
    ... center = [0, 0, 0]
    ... [[swing.test]]
    ... name = "about x"
    ... rig = "compound"
    ... axis = [1, 0, 0]
    ... pivot = [0, 0, { value = "312 mm", sd = "0.5 mm" }]
    ... counted = { swings = 30, time = "40.15 s", sd = "0.04 s", amplitude = ["10 deg", "8 deg"], amplitude_sd = "0.5 deg" }
    ... '''
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")
    ...     bat = polhode.identify(plan)
    >>> bat
    SwingResult('A bat': 1 test, the tensor is only partly known)
    >>> print(bat.swings[0].moment)
    moment: 0.0374351 ± 0.00027 kg·m²
    """
    if isinstance(plan, Mapping):
        answer = _native.identify_plan("plan.toml", _toml.text_of(plan), False)
    elif isinstance(plan, str) and "\n" in plan:
        answer = _native.identify_plan("plan.toml", _arrays.text("plan", plan), True)
    else:
        answer = _native.identify_plan(_arrays.path("plan", plan), None, True)
    return _told(answer)


def identify_tumbles(
    *,
    flights: Flight | Iterable[Flight],
    bias: bool = True,
    scale: bool = False,
    skew: bool = False,
    clock: bool = False,
    gyro_noise: Quantity | None = None,
    attitude_noise: Quantity | None = None,
    drag: str | None = None,
    outlier: float = 6.0,
    title: str | None = None,
) -> TumbleResult:
    """Estimates the inertia tensor of a body from flights without torque other than air drag.

    Moments are relative to the greatest one. They are in kg·m² if a known mass is attached to the
    body in one of the flights.

    Parameters
    ----------
    flights
        One or several flights of the same body, with the sensor fixed to it.
    bias, scale, skew, clock
        Parameters of the gyro to estimate with the body: reading = (1 + S) ω(t + τ) + b. ``bias``
        is b, ``scale`` the diagonal of S, ``skew`` the other elements of S, ``clock`` τ relative to
        the clock of the attitudes.
    gyro_noise
        Standard deviation of a component, rad/s. By default it is estimated from the readings.
    attitude_noise
        Standard deviation of a component of the attitudes, rad. Required if there are attitudes.
    drag
        ``"linear"`` or ``"quadratic"``: a drag matrix is estimated with the body.
    outlier
        Threshold in standard deviations beyond which a reading is excluded. Excluded readings are
        counted.
    title
        Title of the reports.

    Returns
    -------
    TumbleResult
        Estimates with their uncertainty, and the residuals.

    Raises
    ------
    PolhodeError
        If an argument is invalid, or no physical body fits. The message names the argument and the
        reason.

    Examples
    --------
    Two throws of a body with moments in the ratios 1 : 2 : 2.5, read by a gyro with noise:

    >>> import numpy as np, polhode
    >>> times, noise = np.arange(150) * 0.01, np.random.default_rng(1)
    >>> def thrown(omega):
    ...     motion = polhode.FreeMotion(moments=[1, 2, 2.5], omega=omega)
    ...     return polhode.Flight(times=times, gyro=motion.at(times).omega + 0.01 * noise.normal(size=(150, 3)))
    >>> found = polhode.identify_tumbles(flights=[thrown([9, 1, 2]), thrown([1, 8, -5])])
    >>> bool(abs(found.principal.ratios - [0.4, 0.8]).max() < 4 * found.principal.ratio_sd.max() < 0.004)
    True
    >>> found.scale_is_known, found.estimate["gyro bias x"].unit
    (False, 'rad/s')
    """
    given = [flights] if isinstance(flights, Flight) else flights
    if isinstance(given, (str, Mapping)) or not isinstance(given, Iterable):
        raise TypeError(f"flights must be a Flight or a list of them, not {type(flights).__name__}")
    each = list(given)
    for k, flight in enumerate(each):
        if not isinstance(flight, Flight):
            raise TypeError(f"flights[{k}] must be a Flight, not {type(flight).__name__}")
    options: _native.FlightOptions = {
        "bias": _arrays.truth("bias", bias),
        "scale": _arrays.truth("scale", scale),
        "skew": _arrays.truth("skew", skew),
        "clock": _arrays.truth("clock", clock),
        "drag": "none" if drag is None else _arrays.choice("drag", drag, ["linear", "quadratic"]),
        "gyro_noise": None if gyro_noise is None else _arrays.positive("gyro_noise", gyro_noise),
        "attitude_noise": None if attitude_noise is None else _arrays.positive("attitude_noise", attitude_noise),
        "outlier": _arrays.positive("outlier", outlier),
    }
    found = _told(_native.identify_flights(_title(title), [flight._arrays() for flight in each], options))
    assert isinstance(found, TumbleResult)
    return found


def identify_swings(
    *,
    mass: object,
    center: Sequence[object],
    tests: Sequence[Mapping[str, object]],
    numbers: Mapping[str, object] | None = None,
    gravity: object = None,
    title: str | None = None,
) -> SwingResult:
    """Estimates the inertia tensor of a body from its swings on wires or about an axis.

    Parameters
    ----------
    mass, center
        Mass of the body, and its centre of mass (3), body axes. Here and in tests, an exact
        quantity is a number in SI units or a text with its unit. A measured quantity is
        ``{"value": "3.2 kg", "sd": "1 g"}``, and an unknown one ``{"about": "3 kg"}``.
    tests
        Tests, each a dictionary with the keys of a ``[[swing.test]]`` of a plan. The book's
        ``identify-swing.md`` lists the keys.
    numbers
        Quantities that tests share, by the names that the tests use.
    gravity
        Gravitational acceleration. The default is exactly 9.80665 m/s².
    title
        Title of the reports.

    Returns
    -------
    SwingResult
        Estimates with their uncertainty, and the residuals.

    Raises
    ------
    PolhodeError
        If an argument is invalid, or no physical body fits. The message names the argument and the
        reason.

    Examples
    --------
    A plate on two wires, about one of its axes. The test does not determine the moments about other
    axes.

    >>> import polhode, warnings
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")
    ...     found = polhode.identify_swings(
    ...         mass={"value": 3.2, "sd": 0.001},
    ...         center=[0, 0, -0.06],
    ...         numbers={"radius": {"value": "200 mm", "sd": "0.3 mm"}, "length": {"value": "1.5 m", "sd": "0.5 mm"}},
    ...         tests=[{
    ...             "name": "about z",
    ...             "rig": "bifilar",
    ...             "up": [0, 0, 1],
    ...             "across": [1, 0, 0],
    ...             "radius": "radius",
    ...             "length": "length",
    ...             "counted": {"swings": 40, "time": 65.0, "sd": 0.03, "amplitude": ["15 deg", "11 deg"], "amplitude_sd": "0.3 deg"},
    ...         }],
    ...     )
    >>> print(found.swings[0].moment)
    moment: 0.0555788 ± 0.00018 kg·m²
    >>> found.estimate["Ixx"].sd is None, len(found.estimate.unknown), found.body
    (True, 5, None)
    """
    swing: dict[str, object] = {"mass": mass, "center": center, "test": list(tests)}
    if gravity is not None:
        swing["gravity"] = gravity
    if numbers is not None:
        swing["numbers"] = numbers
    plan: dict[str, object] = {"swing": swing}
    if title is not None:
        plan["title"] = _title(title)
    found = identify(plan)
    assert isinstance(found, SwingResult)
    return found


def identify_payload(
    *,
    times: npt.ArrayLike,
    omega: npt.ArrayLike,
    alpha: npt.ArrayLike,
    acceleration: npt.ArrayLike,
    gravity: npt.ArrayLike,
    force: npt.ArrayLike,
    torque: npt.ArrayLike,
    wrench: str,
    attitude: object = None,
    bias: bool = False,
    force_noise: Quantity | None = None,
    torque_noise: Quantity | None = None,
    wrench_covariance: npt.ArrayLike | None = None,
    omega_noise: Quantity = 0.0,
    alpha_noise: Quantity = 0.0,
    acceleration_noise: Quantity = 0.0,
    kind: str | None = None,
    title: str | None = None,
) -> PayloadResult:
    """Estimates mass, centre of mass and inertia tensor of the payload of a force–torque sensor.

    All vectors are in sensor axes and about the sensor's origin.

    Parameters
    ----------
    times
        Times (n,), s, ascending.
    omega, alpha
        Angular velocity of the sensor (n, 3), rad/s, and its derivative (n, 3), rad/s².
    acceleration
        Acceleration of the sensor's origin (n, 3), m/s²: zero at rest.
    gravity
        Acceleration of free fall, pointing down, m/s²: (n, 3) in sensor axes; or, with
        ``attitude``, (3,) in space axes; or (3,) zeros.
    attitude
        With ``gravity`` (3,): attitudes of the sensor as quaternions (n, 4), w, x, y, z, or
        matrices (n, 3, 3), from the sensor to space, or a ``Rotation`` of n.
    force, torque
        Measured force and torque (n, 3), N and N·m.
    wrench
        Body on which the wrench acts: ``"on_sensor"``, whose force at rest points down, as for a
        scale, or ``"on_payload"``.
    bias
        If true, a constant bias of the sensor is estimated too.
    force_noise, torque_noise, wrench_covariance
        Standard deviations of a component, both; or the covariance (6, 6) of fx, fy, fz, τx, τy,
        τz. By default, the noise is estimated from the residuals.
    omega_noise, alpha_noise, acceleration_noise
        Standard deviations of a component of the motion, if it is noisy.
    kind
        Known shape of the payload: ``"plate"`` or ``"rod"``.
    title
        Title of the reports.

    Returns
    -------
    PayloadResult
        Estimates with their uncertainty, and the residuals.

    Raises
    ------
    PolhodeError
        If an argument is invalid, or no physical body fits. The message names the argument and the
        reason.

    Examples
    --------
    A tool of 1.7 kg, 0.1 m in front of a wrist at rest in four attitudes. Mass and centre are
    determined, the tensor is not.

    >>> import numpy as np, polhode, warnings
    >>> down = np.repeat([[0, 0, -1], [0, -1, 0], [-1, 0, 0], [0.6, 0.8, 0]], 8, axis=0) * 9.81
    >>> still, noise = np.zeros((32, 3)), np.random.default_rng(2)
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")
    ...     found = polhode.identify_payload(
    ...         times=np.arange(32) * 0.1, omega=still, alpha=still, acceleration=still, gravity=down,
    ...         force=1.7 * down + 0.01 * noise.normal(size=(32, 3)),
    ...         torque=np.cross([0, 0, 0.1], 1.7 * down) + 0.001 * noise.normal(size=(32, 3)),
    ...         wrench="on_sensor", force_noise=0.01, torque_noise=0.001,
    ...     )
    >>> print(found.estimate["mass"])
    mass: 1.70007 ± 0.00018 kg
    >>> found.body is None, found.estimate["Ixx"].sd is None
    (True, True)
    """
    when = _arrays.numbers("times", times, ("n",))
    vectors = {"omega": omega, "alpha": alpha, "acceleration": acceleration, "force": force, "torque": torque}
    rows = {name: _arrays.numbers(name, value, ("n", 3)) for name, value in vectors.items()}
    for name, array in rows.items():
        as_long("times", when, name, array)
    down = _arrays.real("gravity", gravity)
    turned = None
    if attitude is not None:
        turned = _rotation.quaternions("attitude", attitude, ("n", 4))
        as_long("times", when, "attitude", turned)
        down = _arrays.numbers("gravity", down, (3,)).reshape(1, 3)
    elif down.shape == (3,) and not down.any():
        down = np.zeros((len(when), 3))
    else:
        if down.shape == (3,):
            hint = "also give attitude, or give gravity (n, 3) along the sensor's axes"
            raise PolhodeError("gravity of shape (3,) is along space axes, but no attitudes are given", hint)
        down = _arrays.numbers("gravity", down, ("n", 3))
        as_long("times", when, "gravity", down)
    if (force_noise is None) != (torque_noise is None):
        raise PolhodeError("give both force_noise and torque_noise, or neither")
    noise = None
    if force_noise is not None and torque_noise is not None:
        if wrench_covariance is not None:
            raise PolhodeError("wrench_covariance contains all the noise: give either it, or force_noise and torque_noise")
        noise = [_arrays.positive("force_noise", force_noise), _arrays.positive("torque_noise", torque_noise)]
    covariance = None if wrench_covariance is None else _arrays.numbers("wrench_covariance", wrench_covariance, (6, 6)).tolist()
    moving = {"omega_noise": omega_noise, "alpha_noise": alpha_noise, "acceleration_noise": acceleration_noise}
    given: _native.WrenchArrays = {
        "times": when,
        "omega": rows["omega"],
        "alpha": rows["alpha"],
        "acceleration": rows["acceleration"],
        "gravity": np.require(down, np.float64, ["C", "A"]),
        "attitude": turned,
        "force": rows["force"],
        "torque": rows["torque"],
    }
    options: _native.WrenchOptions = {
        "on_sensor": _arrays.choice("wrench", wrench, ["on_sensor", "on_payload"]) == "on_sensor",
        "bias": _arrays.truth("bias", bias),
        "noise": noise,
        "covariance": covariance,
        "motion_noise": [_arrays.number(name, value) for name, value in moving.items()],
        "kind": None if kind is None else _arrays.choice("kind", kind, ["plate", "rod"]),
    }
    found = _told(_native.identify_wrenches(_title(title), given, options))
    assert isinstance(found, PayloadResult)
    return found


def _told(answer: _native.Identified) -> TumbleResult | SwingResult | PayloadResult:
    """Converts an answer and issues its warnings."""
    found = identified_of(answer)
    warn_of(found.findings)
    return found


def _title(title: str | None) -> str | None:
    return None if title is None else _arrays.text("title", title)
