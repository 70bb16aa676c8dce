"""Comparison of a motion of another program with the exact one."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from . import _html, _native
from ._arrays import Floats
from ._deprecated import warn_of_name
from ._error import in_python
from ._estimate import counted
from ._public import public
from ._record import same


@public("polhode.results")
class TriedReading(NamedTuple):
    """Possible conventions of a run, and the residual at its beginning with these."""

    #: Order of the quaternion components: ``wxyz`` or ``xyzw``.
    quaternion: str
    #: Sense of the rotations: ``body_to_space``, as in polhode, or ``space_to_body``.
    sense: str
    #: Axes x, y, z of the run, each an axis of the scenario or its opposite: ``(x, z, −y)`` has y
    #: upwards.
    axes: str
    #: Time of the run at the scenario's time 0, s.
    time_origin: float
    #: Angle between the attitudes with these conventions and the exact ones, rad: root mean square
    #: over the beginning.
    residual: float
    #: ``residual`` relative to the angle of the exact rotation during the beginning.
    relative: float


@public("polhode.results")
class Reading(NamedTuple):
    """Conventions of a run."""

    #: Order of the quaternion components: ``wxyz`` or ``xyzw``; ``wxyz`` for matrices.
    quaternion: str
    #: Sense of the rotations: ``body_to_space``, as in polhode, or ``space_to_body``.
    sense: str
    #: Axes x, y, z of the run, each an axis of the scenario or its opposite: ``(x, z, −y)`` has y
    #: upwards.
    axes: str
    #: Axes of ω: ``body`` or ``space``; ``None`` without ω.
    omega_axes: str | None
    #: Time of the run at the scenario's time 0, s.
    time_origin: float
    #: True if no reading begins with the scenario's attitude, so that the rotation since the first
    #: row was compared.
    from_own_start: bool
    #: All readings that were tried, best first.
    tried: tuple[TriedReading, ...]
    #: Seconds per stated second of the run's clock: 1 if its times are in the stated unit, 0.001 if
    #: they are in ms.
    time_factor: float
    #: Order and signs of the components of ω: ``(x, y, z)`` as stated; ``None`` without ω.
    omega_components: str | None
    #: rad/s per stated rad/s of ω: 1 if its unit is the stated one; ``None`` without ω.
    omega_factor: float | None
    #: True if the reading contradicts the names of the run's columns.
    against_names: bool


@public("polhode.results")
class ErrorGrowth(NamedTuple):
    """Growth of the largest error so far."""

    #: Kind of growth: ``power`` (t to the power of ``exponent``) or ``exponential``.
    kind: str
    #: Exponent: 0 for a wrong start, ½ for random rounding errors, 1 for a wrong rate, 2 for a
    #: drifting rate; ``None`` for an exponential.
    exponent: float | None
    #: Growth rate of an exponential, 1/s; else ``None``.
    rate: float | None

    @property
    def law(self) -> str:
        """Former name of ``kind``."""
        warn_of_name("ErrorGrowth.law", "ErrorGrowth.kind")
        return self.kind


@public("polhode.results")
class ErrorPart(NamedTuple):
    """A component of the error of a run."""

    #: Component: ``start`` (rotation in space), ``body_axes`` (rotation), ``clock`` (lead),
    #: ``rate`` (excess) or ``drift`` (in space).
    name: str
    #: One or three numbers; ``None`` if the component cannot be distinguished from those before it
    #: in this run.
    value: tuple[float, ...] | None
    #: Unit of the value: ``rad``, ``s``, ``1`` or ``rad/s``.
    unit: str
    #: Reduction of the error by this component, after those before it, rad, root mean square.
    attitude: float


@public("polhode.results")
class ErrorSplit(NamedTuple):
    """Components of an error, while it is below 0.3 rad: angles are root mean squares, rad."""

    #: Components in the order in which they were fitted.
    parts: tuple[ErrorPart, ...]
    #: Random error from row to row.
    noise: float
    #: Error that no component explains, including the noise.
    rest: float
    #: Total error.
    total: float
    #: End of the interval in which the error was split, s.
    until: float


@public("polhode.results")
class Cause(NamedTuple):
    """A possible cause of the error.

    The motion that it would produce was computed and compared with the run.
    """

    #: Stable identifier for programs, such as ``no_gyroscopic_term``.
    id: str
    #: Description of the cause.
    text: str
    #: False for a cause that is not an error of the program, such as a method of order 2 or more,
    #: or single precision.
    is_mistake: bool
    #: True if the cause explains the run well enough, and no other much better.
    named: bool
    #: Angle between the run and the motion computed with this cause, rad, root mean square.
    residual: float
    #: Fraction of the error that the cause explains; 0 or less if none.
    explained: float
    #: Suggested fix.
    hint: str


@public("polhode.results")
class Judgement:
    """Deviation of a run from the exact motion, with its likely cause; see :func:`judge`.

    Arrays have a row for each time, and are read-only. Those of ω are ``None`` for a run without ω.
    """

    def __init__(self, judged: _native.Judged) -> None:
        self._judged = judged
        self._report: dict[str, Any] = json.loads(judged["json"])

    #: Not hashable, because it contains arrays.
    __hash__ = None  # type: ignore[assignment]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Judgement):
            return NotImplemented
        one: Any = self._judged
        two: Any = other._judged
        return all(same(value, two[name]) for name, value in one.items())

    @property
    def times(self) -> Floats:
        """Times (n,), s, in the scenario's time."""
        return _shown(self._judged["times"])

    @property
    def attitude(self) -> Floats:
        """Attitudes R_space_body of the run, scenario's axes, as quaternions (n, 4): w, x, y, z.

        They keep the norm that they have in the run.
        """
        return _shown(self._judged["attitude"])

    @property
    def omega(self) -> Floats | None:
        """Angular velocity of the run (n, 3), scenario's body axes, rad/s."""
        return _shown_if(self._judged["omega"])

    @property
    def exact_attitude(self) -> Floats:
        """Exact attitudes R_space_body as unit quaternions (n, 4): w, x, y, z.

        They are continuous in sign.
        """
        return _shown(self._judged["exact_attitude"])

    @property
    def exact_omega(self) -> Floats:
        """Exact angular velocity (n, 3), body axes, rad/s."""
        return _shown(self._judged["exact_omega"])

    @property
    def attitude_error(self) -> Floats:
        """Angle between the run's attitude and the exact one (n,), rad."""
        return _shown(self._judged["attitude_error"])

    @property
    def attitude_error_vector(self) -> Floats:
        """Rotation vectors θ with R = R_exact exp(θ), body axes (n, 3), rad."""
        return _shown(self._judged["attitude_error_vector"])

    @property
    def omega_error(self) -> Floats | None:
        """Error \\|δω\\| (n,), relative to the largest exact \\|ω\\| of the run."""
        return _shown_if(self._judged["omega_error"])

    @property
    def kinetic_energy_error(self) -> Floats | None:
        """Signed error of ½ ω · I ω (n,), relative to the largest exact kinetic energy."""
        return _shown_if(self._judged["kinetic_energy_error"])

    @property
    def momentum_error(self) -> Floats | None:
        """Signed error of \\|L\\| (n,), relative to the largest exact \\|L\\|."""
        return _shown_if(self._judged["momentum_error"])

    @property
    def momentum_direction_error(self) -> Floats | None:
        """Angle between L in space and the exact L (n,), rad."""
        return _shown_if(self._judged["momentum_direction_error"])

    @property
    def largest_attitude_error(self) -> float:
        """Largest element of ``attitude_error``, rad."""
        return self._number("error", "attitude_largest_rad")

    @property
    def last_attitude_error(self) -> float:
        """Last element of ``attitude_error``, rad."""
        return self._number("error", "attitude_last_rad")

    @property
    def exact_to(self) -> float:
        """Uncertainty of the exact attitude at the last row, rad.

        Smaller errors cannot be detected.
        """
        return self._number("error", "exact_to_rad")

    @property
    def is_exact(self) -> bool:
        """True if the run cannot be distinguished from the exact motion."""
        return self._judged["is_exact"]

    @property
    def step(self) -> float | None:
        """Time step of the program, s.

        It is as given, or else the interval between rows; ``None`` if that is not constant.
        """
        step: float | None = self._run["step_s"]
        return step

    @property
    def engine(self) -> str | None:
        """Program that made the run, if given."""
        engine: str | None = self._run["engine"]
        return engine

    @property
    def reading(self) -> Reading:
        """Conventions of the run, and all that were tried."""
        said = self._run["reading"]
        tried = tuple(
            TriedReading(*_read(one["reading"]), one["attitude_rad"], one["of_the_turn"]) for one in said["tried"]
        )
        quaternion, sense, axes, origin = _read(said["found"])
        return Reading(
            quaternion,
            sense,
            axes,
            said["omega_axes"],
            origin,
            said["from_own_start"],
            tried,
            said["found"]["time_factor"],
            said["omega_components"],
            said["omega_factor"],
            said["against_names"],
        )

    @property
    def growth(self) -> ErrorGrowth | None:
        """Growth of the error; ``None`` if the error is too small or the run too short."""
        said = self._run["growth"]
        return None if said is None else ErrorGrowth(said["law"], said.get("exponent"), said.get("rate_per_s"))

    @property
    def split(self) -> ErrorSplit:
        """Components of the error."""
        said = self._run["split"]
        parts = (
            ErrorPart(part["part"], None if part["value"] is None else tuple(part["value"]), part["unit"], part["attitude_rad"])
            for part in said["parts"]
        )
        return ErrorSplit(tuple(parts), said["noise_rad"], said["rest_rad"], said["total_rad"], said["until_s"])

    @property
    def causes(self) -> list[Cause]:
        """All causes that were tried, most likely first.

        The list is empty if there is no error to explain, or no cause can be tried.
        """
        tried = self._run["causes"]["tried"]
        return [
            Cause(it["id"], it["cause"], it["is_mistake"], it["named"], it["residual_rad"], it["explained"], it["hint"]) for it in tried
        ]

    @property
    def likeliest(self) -> Cause | None:
        """Cause that explains the run best; ``None`` if no cause does."""
        return next((cause for cause in self.causes if cause.named), None)

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode judge --json`` prints. Its keys are stable."""
        return dict(json.loads(self._judged["json"]))

    def report(self) -> str:
        """Returns the text that ``polhode judge`` prints."""
        return in_python(self._judged["text"])

    def page(self) -> str:
        """Returns the report as an HTML page with plots."""
        return self._judged["page"]

    @property
    def _run(self) -> dict[str, Any]:
        run: dict[str, Any] = self._report["runs"][0]
        return run

    def _number(self, block: str, key: str) -> float:
        return float(self._run[block][key])

    def __len__(self) -> int:
        return len(self._judged["times"])

    def __repr__(self) -> str:
        if self.is_exact:
            return f"Judgement({counted(len(self), 'row')}, correct to {self.exact_to:.1e} rad)"
        cause = "no cause found" if self.likeliest is None else self.likeliest.id
        return f"Judgement({counted(len(self), 'row')}, up to {self.largest_attitude_error:.1e} rad off, {cause})"

    def __str__(self) -> str:
        return self.report()

    def _repr_markdown_(self) -> str:
        return self._judged["markdown"]

    def _repr_html_(self) -> str:
        return _html.frame(self.page())


def _shown(array: Floats) -> Floats:
    """Returns a read-only view. Arrays in copies from other processes would be writeable."""
    view = array.view()
    view.flags.writeable = False
    return view


def _shown_if(array: Floats | None) -> Floats | None:
    return None if array is None else _shown(array)


def _read(reading: dict[str, Any]) -> tuple[str, str, str, float]:
    return reading["quaternion"], reading["sense"], reading["axes"], reading["time_origin_s"]
