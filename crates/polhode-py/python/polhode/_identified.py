"""What is found of a body by measuring it."""

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
from ._record import Record

Of = TypeVar("Of")


@dataclass(frozen=True, eq=False, repr=False)
class Identified(Printed):
    """What is common to all answers: :class:`TumbleResult`, :class:`SwingResult`, :class:`PayloadResult`.

    Every answer is a possible body. What the measurements do not determine is not filled in: it has no error, and its directions are in
    ``estimate.unknown``. If what is left is more than noise, ``has_model_error`` is true, and all errors are widened for it.
    """

    #: What it is called.
    title: str
    #: The numbers that were found.
    estimate: Estimate
    #: Principal moments and axes; ``None`` where the tensor is not known.
    principal: PrincipalEstimate | None
    #: Whether what is left is noise, by kind of measurement.
    tests: tuple[ResidualTest, ...]
    #: True if what is left is more than noise.
    has_model_error: bool
    #: What was noticed.
    findings: tuple[Finding, ...]

    def _summary(self) -> str:
        return repr(self.estimate)

    def __repr__(self) -> str:
        odd = ", what is left is no noise" if self.has_model_error else ""
        return f"{type(self).__name__}({self.title!r}: {self._summary()}{odd})"


@dataclass(frozen=True, eq=False, repr=False)
class FlightFit(Record):
    """What was found of a flight."""

    #: What it is called.
    name: str
    #: The time of the state, s.
    time: float
    #: ω there, along the sensor's axes (3,), rad/s.
    omega: Floats
    #: Its standard deviations (3,); NaN where it is not known.
    omega_sd: Floats
    #: The attitude there as a unit quaternion (4,), w, x, y, z; ``None`` if no attitudes were measured.
    attitude: Floats | None
    #: χ²/degrees of freedom of its readings, without those that were left out.
    reduced_chi_square: float
    #: How many readings were used.
    used: int
    #: The times of readings that were left out (k,), s.
    left_out: Floats
    #: Measured less predicted at the gyro's times (n, 3), rad/s.
    gyro_residuals: Floats
    #: The same of attitudes (m, 3), as rotation vectors, rad.
    attitude_residuals: Floats

    def __repr__(self) -> str:
        return f"FlightFit({self.name!r}: {counted(self.used, 'reading')}, {len(self.left_out)} left out)"


@dataclass(frozen=True, eq=False, repr=False)
class TumbleResult(Identified):
    """A body that was found by its tumbles. :func:`identify` and :func:`identify_tumbles` make one."""

    #: True if the moments are in kg·m²; false if only their ratios are known, and tensor and drag are those over the greatest moment.
    scale_is_known: bool
    #: Flight by flight.
    flights: tuple[FlightFit, ...]
    #: By what all errors were multiplied, as residuals show more than noise.
    widening: float

    @property
    def inertia(self) -> Floats:
        """The tensor (3, 3) about the centre of mass along the sensor's axes, kg·m², or over the greatest moment."""
        return _tensor(self.estimate.values[:6])

    def _summary(self) -> str:
        assert self.principal is not None
        return f"{counted(len(self.flights), 'flight')}, {self.principal.ratios_in_words()}"


@dataclass(frozen=True, eq=False, repr=False)
class SwingFit(Record):
    """What became of a swing test."""

    #: What it is called.
    name: str
    #: The body's moment of inertia about the axis of the swing, through its centre of mass; ``None`` of a test without the body.
    moment: Number | None
    #: Amplitude, of a log phase and zero, and damping.
    own: tuple[Number, ...]
    #: Measured less predicted (n,), in standard deviations: times of counted swings and then amplitudes, or values of a log.
    residuals: Floats
    #: Whether that is noise; of counted swings only all together are a test.
    test: ResidualTest

    def __repr__(self) -> str:
        return f"SwingFit({self.name!r}: {self.moment or 'without the body'})"


@dataclass(frozen=True, eq=False, repr=False)
class SwingResult(Identified):
    """A body that was found by its swings. :func:`identify` and :func:`identify_swings` make one."""

    #: Test by test.
    swings: tuple[SwingFit, ...]
    #: By what all errors were multiplied, as residuals show more than noise.
    widening: float
    _body: _native.MassNumbers | None

    @property
    def body(self) -> MassProperties | None:
        """The body; ``None`` unless all of it is known."""
        return _body(self._body)

    def _summary(self) -> str:
        known = "the whole tensor is not known" if self.principal is None else self.principal.ratios_in_words()
        return f"{counted(len(self.swings), 'test')}, {known}"


class LeftOut(NamedTuple):
    """A wrench that was left out."""

    #: Its row, from 0.
    row: int
    #: When, s.
    time: float
    #: How far off it is: root mean square of its six residuals, in standard deviations.
    size: float


class Thin(NamedTuple):
    """A direction in which the likeliest payload has no extent."""

    #: Unit vector along the sensor's axes.
    direction: tuple[float, ...]
    #: ∫ x² dm along it as least squares without regard to what is possible has it: mostly negative, kg·m².
    unconstrained: float
    #: Standard deviation of that.
    sd: float
    #: ∫ x² dm is not more than this, with a confidence of 95 %.
    at_most: float
    #: That as the thickness of a plate, m.
    thickness_at_most: float


class Edge(NamedTuple):
    """The likeliest payload is at the edge of what is possible."""

    #: ``plate``, ``rod`` or ``point``.
    kind: str
    #: Where it has no extent.
    thin: tuple[Thin, ...]
    #: The numbers about the centre, with their errors if the payload is on this very edge; ``None`` where these do not follow.
    along: Estimate | None


class Unconstrained(NamedTuple):
    """Least squares without regard to what is possible."""

    #: In the order of ``about_origin``.
    numbers: tuple[float, ...]
    #: Whether they are a possible body's.
    is_possible: bool
    #: The least eigenvalue of ∫ x xᵀ dm about the centre of mass, kg·m²; ``None`` if the mass is not positive.
    least_second_moment: float | None
    #: By how much χ² rises where the body has to be possible.
    chi_square_rise: float


@dataclass(frozen=True, eq=False, repr=False)
class PayloadResult(Identified):
    """What a wrist carries. :func:`identify` and :func:`identify_payload` make one. Its origin and its axes are the sensor's."""

    #: The numbers in which the wrench is linear: mass, mass times centre, the tensor about the sensor's origin, the bias.
    about_origin: Estimate
    #: If it is at the edge of what is possible.
    edge: Edge | None
    #: What least squares alone would say.
    unconstrained: Unconstrained
    #: Times (n,), s.
    times: Floats
    #: Measured less predicted force (n, 3), N, of all rows.
    force_residuals: Floats
    #: The same of the torque (n, 3), N·m.
    torque_residuals: Floats
    #: Wrenches that were left out.
    left_out: tuple[LeftOut, ...]
    _body: _native.MassNumbers | None

    @property
    def body(self) -> MassProperties | None:
        """The body; ``None`` unless all of it is known."""
        return _body(self._body)

    def _summary(self) -> str:
        return f"{counted(len(self.times), 'row')}, {self.estimate['mass']}"


def identified_of(answer: _native.Identified) -> TumbleResult | SwingResult | PayloadResult:
    """What Rust found, as the classes of Python."""
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
    """One, several or none."""
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
    """The fields of a named tuple, lists as tuples."""
    values = ((key, said[key]) for key in kind.__annotations__)
    return kind(**{key: tuple(value) if isinstance(value, list) else value for key, value in values})


def _tensor(elements: Floats) -> Floats:
    """Of xx, yy, zz, xy, xz, yz."""
    matrix: Floats = elements[np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])]
    return matrix
