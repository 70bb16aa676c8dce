"""Results of identification: mass properties estimated from measurements."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar

import numpy as np

from . import _native
from ._arrays import Floats
from ._estimate import Estimate, Number, PrincipalEstimate, ResidualTest, counted, estimate_of, floats, principal_of, residual_test_of
from ._mass_properties import Finding, MassProperties, findings_of
from ._printed import Printed
from ._public import public
from ._record import Record

Of = TypeVar("Of")


@dataclass(frozen=True, eq=False, repr=False)
class Identified(Printed):
    """Common part of :class:`TumbleResult`, :class:`SwingResult` and :class:`PayloadResult`.

    The estimate is always a physical body. Numbers that the measurements do not determine have no
    error, and the undetermined directions are in ``estimate.unknown``. If the residuals are
    significantly larger than the noise or correlated, ``has_model_error`` is true, and all errors
    are widened accordingly.
    """

    #: Title of the result.
    title: str
    #: Estimated numbers.
    estimate: Estimate
    #: Principal moments and axes; ``None`` if the tensor is not known.
    principal: PrincipalEstimate | None
    #: Tests whether the residuals are noise, one for each kind of measurement.
    tests: tuple[ResidualTest, ...]
    #: True if the residuals are more than noise.
    has_model_error: bool
    #: Findings about the data and the result.
    findings: tuple[Finding, ...]

    def _summary(self) -> str:
        return repr(self.estimate)

    def __repr__(self) -> str:
        odd = ", the residuals are not noise" if self.has_model_error else ""
        return f"{type(self).__name__}({self.title!r}: {self._summary()}{odd})"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class FlightFit(Record):
    """Estimates and residuals of a flight."""

    #: Name of the flight.
    name: str
    #: Time of the state, s.
    time: float
    #: Angular velocity at that time (3,), sensor axes, rad/s.
    omega: Floats
    #: Standard deviations of ``omega`` (3,), rad/s; NaN where not known.
    omega_sd: Floats
    #: Attitude at that time as a unit quaternion (4,), w, x, y, z; ``None`` if no attitudes were
    #: measured.
    attitude: Floats | None
    #: χ²/degrees of freedom of the readings, without excluded ones.
    reduced_chi_square: float
    #: Number of readings used.
    used: int
    #: Times of excluded readings (k,), s.
    left_out: Floats
    #: Measured minus predicted angular velocity at the gyro times (n, 3), rad/s.
    gyro_residuals: Floats
    #: Measured minus predicted attitudes (m, 3), as rotation vectors, rad.
    attitude_residuals: Floats

    def __repr__(self) -> str:
        return f"FlightFit({self.name!r}: {counted(self.used, 'reading')}, {len(self.left_out)} left out)"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class TumbleResult(Identified):
    """Mass properties of a body, identified from its tumbles.

    :func:`identify` and :func:`identify_tumbles` return it.
    """

    #: True if the moments are in kg·m². If false, only their ratios are known, and tensor and drag
    #: are relative to the greatest moment.
    scale_is_known: bool
    #: Results of each flight.
    flights: tuple[FlightFit, ...]
    #: Factor by which all errors were multiplied because the residuals are more than noise.
    widening: float

    @property
    def inertia(self) -> Floats:
        """Inertia tensor (3, 3) about the centre of mass, sensor axes.

        Its unit is kg·m² if ``scale_is_known``; otherwise it is relative to the greatest moment.
        """
        return _tensor(self.estimate.values[:6])

    def _summary(self) -> str:
        assert self.principal is not None
        return f"{counted(len(self.flights), 'flight')}, {self.principal.ratios_in_words()}"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class SwingFit(Record):
    """Estimates and residuals of a swing test."""

    #: Name of the test.
    name: str
    #: Moment of inertia of the body about the axis parallel to the swing axis through its centre of
    #: mass; ``None`` for a test without the body.
    moment: Number | None
    #: Amplitude and damping, and for a log also phase and zero.
    own: tuple[Number, ...]
    #: Measured minus predicted values (n,), in standard deviations: times of counted swings and
    #: then amplitudes, or values of a log.
    residuals: Floats
    #: Test whether the residuals are noise; for counted swings, one test of all swing tests
    #: together.
    test: ResidualTest

    def __repr__(self) -> str:
        return f"SwingFit({self.name!r}: {self.moment or 'without the body'})"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class SwingResult(Identified):
    """Mass properties of a body, identified from its swings.

    :func:`identify` and :func:`identify_swings` return it.
    """

    #: Results of each test.
    swings: tuple[SwingFit, ...]
    #: Factor by which all errors were multiplied because the residuals are more than noise.
    widening: float
    _body: _native.MassNumbers | None

    @property
    def body(self) -> MassProperties | None:
        """Mass properties; ``None`` unless all ten numbers are known."""
        return _body(self._body)

    def _summary(self) -> str:
        known = "the tensor is only partly known" if self.principal is None else self.principal.ratios_in_words()
        return f"{counted(len(self.swings), 'test')}, {known}"


@public("polhode.results")
class LeftOut(NamedTuple):
    """A wrench excluded as an outlier."""

    #: Index of the row, from 0.
    row: int
    #: Time, s.
    time: float
    #: Root mean square of its six residuals, in standard deviations.
    size: float


@public("polhode.results")
class Thin(NamedTuple):
    """A direction in which the maximum-likelihood payload has no extent."""

    #: Unit vector, sensor axes.
    direction: tuple[float, ...]
    #: ∫ x² dm along the direction from unconstrained least squares, kg·m²: usually negative.
    unconstrained: float
    #: Standard deviation of ``unconstrained``, kg·m².
    sd: float
    #: Upper bound of ∫ x² dm at 95 % confidence, kg·m².
    at_most: float
    #: Thickness of a plate with that second moment, m.
    thickness_at_most: float


@public("polhode.results")
class Edge(NamedTuple):
    """Degenerate shape of a maximum-likelihood payload on the boundary of physical bodies."""

    #: Shape: ``plate``, ``rod`` or ``point``.
    kind: str
    #: Directions without extent.
    thin: tuple[Thin, ...]
    #: Numbers about the centre of mass, with their errors if the payload has exactly this shape;
    #: ``None`` if they cannot be derived.
    along: Estimate | None


@public("polhode.results")
class Unconstrained(NamedTuple):
    """Result of least squares without the constraint that the body is physical."""

    #: Numbers in the order of ``about_origin``.
    numbers: tuple[float, ...]
    #: True if the numbers are those of a physical body.
    is_possible: bool
    #: Least eigenvalue of ∫ x xᵀ dm about the centre of mass, kg·m²; ``None`` if the mass is not
    #: positive.
    least_second_moment: float | None
    #: Increase of χ² due to the constraint that the body is physical.
    chi_square_rise: float


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class PayloadResult(Identified):
    """Mass properties of the payload of a wrist. Origin and axes are those of the sensor.

    :func:`identify` and :func:`identify_payload` return it.
    """

    #: Numbers in which the wrench is linear: mass, mass times centre, the tensor about the sensor's
    #: origin, the bias.
    about_origin: Estimate
    #: Degenerate shape, if the payload is on the boundary of physical bodies; else ``None``.
    edge: Edge | None
    #: Result of least squares without the constraint that the body is physical.
    unconstrained: Unconstrained
    #: Times (n,), s.
    times: Floats
    #: Measured minus predicted force (n, 3), N, for all rows.
    force_residuals: Floats
    #: Measured minus predicted torque (n, 3), N·m, for all rows.
    torque_residuals: Floats
    #: Wrenches that were excluded.
    left_out: tuple[LeftOut, ...]
    _body: _native.MassNumbers | None

    @property
    def body(self) -> MassProperties | None:
        """Mass properties; ``None`` unless all ten numbers are known."""
        return _body(self._body)

    def _summary(self) -> str:
        return f"{counted(len(self.times), 'row')}, {self.estimate['mass']}"


def identified_of(answer: _native.Identified) -> TumbleResult | SwingResult | PayloadResult:
    """Converts the answer of Rust to the Python classes."""
    said: dict[str, Any] = json.loads(answer["json"])
    common: dict[str, Any] = {
        "title": said["title"],
        "estimate": estimate_of(said["estimate"]),
        "principal": principal_of(said["principal"]),
        "tests": _tests(said["residuals"]),
        "has_model_error": answer["has_model_error"],
        "findings": tuple(findings_of((f["code"], f["severity"], f["message"], f.get("place")) for f in said["findings"])),
        "_printed": (answer["json"], answer["text"], answer["markdown"], answer["page"]),
    }
    if said["kind"] == "tumble":
        flights = tuple(map(_flight, said["flights"]))
        return TumbleResult(**common, scale_is_known=said["scale_is_known"], flights=flights, widening=said["widening"])
    if said["kind"] == "swing":
        swings = tuple(map(_swing, said["tests"], answer["swings"]))
        return SwingResult(**common, swings=swings, widening=said["widening"], _body=answer["body"])
    wrench, times = answer["wrench"], answer["times"]
    assert wrench is not None and times is not None
    return PayloadResult(
        **common,
        about_origin=estimate_of(said["about_origin"]),
        edge=_edge(said["edge"]),
        unconstrained=_tuple(Unconstrained, said["unconstrained"]),
        times=times,
        force_residuals=wrench[:, :3],
        torque_residuals=wrench[:, 3:],
        left_out=tuple(_tuple(LeftOut, left) for left in said["left_out"]),
        _body=answer["body"],
    )


def _body(numbers: _native.MassNumbers | None) -> MassProperties | None:
    if numbers is None:
        return None
    mass, center, tensor = numbers
    return MassProperties(mass=mass, center_of_mass=center, inertia=tensor)


def _tests(said: Any) -> tuple[ResidualTest, ...]:
    """Converts one residual test, several or none."""
    return tuple(map(residual_test_of, said if isinstance(said, list) else [] if said is None else [said]))


def _flight(said: dict[str, Any]) -> FlightFit:
    wxyz = said["quaternion_wxyz"]
    return FlightFit(
        name=said["name"],
        time=said["time"],
        omega=floats(said["omega"]),
        omega_sd=floats(said["omega_sd"]),
        attitude=None if wxyz is None else floats(wxyz),
        reduced_chi_square=said["reduced_chi_square"],
        used=said["used"],
        left_out=floats(said["left_out"]),
        gyro_residuals=floats(said["gyro_residuals"]).reshape(-1, 3),
        attitude_residuals=floats(said["attitude_residuals"]).reshape(-1, 3),
    )


def _swing(said: dict[str, Any], residuals: Floats) -> SwingFit:
    moment = said["moment"]
    return SwingFit(
        name=said["name"],
        moment=None if moment is None else Number("moment", **moment),
        own=tuple(Number(**number) for number in said["own"]),
        residuals=residuals,
        test=residual_test_of(said["residuals"]),
    )


def _edge(said: dict[str, Any] | None) -> Edge | None:
    if said is None:
        return None
    thin = tuple(_tuple(Thin, one) for one in said["thin"])
    return Edge(said["kind"], thin, None if said["along"] is None else estimate_of(said["along"]))


def _tuple(kind: type[Of], said: dict[str, Any]) -> Of:
    """Makes a named tuple from a dictionary; lists become tuples."""
    values = ((key, said[key]) for key in kind.__annotations__)
    return kind(**{key: tuple(value) if isinstance(value, list) else value for key, value in values})


def _tensor(elements: Floats) -> Floats:
    """Returns the tensor (3, 3) of the elements xx, yy, zz, xy, xz, yz."""
    matrix: Floats = elements[np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])]
    return matrix
