"""What there is to say of a motion that another program computed."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from . import _html, _native
from ._arrays import Floats
from ._error import in_python
from ._record import same


class TriedReading(NamedTuple):
    """What the numbers of a run may mean, and how well it then begins as its scenario."""

    #: The order of its quaternions: ``wxyz`` or ``xyzw``.
    quaternion: str
    #: Which way its rotations go: ``body_to_space``, as polhode has it, or ``space_to_body``.
    sense: str
    #: Its axes x, y, z, each an axis of the scenario or its opposite: ``(x, z, −y)`` has y upwards.
    axes: str
    #: The run's time at the scenario's time 0, s.
    time_origin: float
    #: The angle between the attitudes that are read so and the exact ones, rad: root of the mean square over the beginning.
    residual: float
    #: The same as a part of the angle that the exact motion turns through in the beginning.
    relative: float


class Reading(NamedTuple):
    """What the numbers of a run mean."""

    #: The order of its quaternions: ``wxyz`` or ``xyzw``; of matrices ``wxyz``.
    quaternion: str
    #: Which way its rotations go: ``body_to_space``, as polhode has it, or ``space_to_body``.
    sense: str
    #: Its axes x, y, z, each an axis of the scenario or its opposite: ``(x, z, −y)`` has y upwards.
    axes: str
    #: Along which axes its ω is, ``body`` or ``space``; ``None`` without ω.
    omega_axes: str | None
    #: The run's time at the scenario's time 0, s.
    time_origin: float
    #: True if no reading begins with the scenario's attitude, so that the turn since the first row was compared.
    from_own_start: bool
    #: All readings that were tried, best first.
    tried: tuple[TriedReading, ...]
    #: Seconds per stated second of the run's clock: 1 if the unit of its times is the stated one, 0.001 if it is ms.
    time_factor: float
    #: Order and signs of the components of ω: ``(x, y, z)`` as stated; ``None`` without ω.
    omega_components: str | None
    #: rad/s per stated rad/s of ω: 1 if its unit is the stated one; ``None`` without ω.
    omega_factor: float | None
    #: Whether the reading contradicts the names of the run's columns.
    against_names: bool


class ErrorGrowth(NamedTuple):
    """The law by which the largest error so far grows."""

    #: ``power`` (t to the power of ``exponent``) or ``exponential``.
    law: str
    #: 0 of a wrong start, ½ of rounding by chance, 1 of a wrong rate, 2 of a rate that drifts; ``None`` of an exponential.
    exponent: float | None
    #: Of an exponential, 1/s.
    rate: float | None


class ErrorPart(NamedTuple):
    """One respect in which a run differs from the exact motion."""

    #: ``start`` (turned, in space), ``body_axes`` (turned), ``clock`` (ahead), ``rate`` (too fast) or ``drift`` (in space).
    name: str
    #: Its one or three numbers; ``None`` where in this run it looks like the parts before it.
    value: tuple[float, ...] | None
    #: Their unit: ``rad``, ``s``, ``1`` or ``rad/s``.
    unit: str
    #: What it takes from the error that the parts before it leave, rad, root of the mean square.
    attitude: float


class ErrorSplit(NamedTuple):
    """What an error is made of, as far as it is below 0.3 rad: angles are roots of mean squares, rad."""

    #: In the order in which they were fitted.
    parts: tuple[ErrorPart, ...]
    #: What changes from row to row without rule.
    noise: float
    #: What no part has, the noise included.
    rest: float
    #: All of it.
    total: float
    #: Until when it could be split, s.
    until: float


class Cause(NamedTuple):
    """What a program may do that its run is not the exact motion: the motion that it then makes was computed and compared."""

    #: A stable name for programs, such as ``no_gyroscopic_term``.
    id: str
    #: What the program does.
    text: str
    #: False of what is no mistake: a method of order 2 or more, single precision.
    is_mistake: bool
    #: Whether it explains the run: well enough, and no other one much better.
    named: bool
    #: The angle between the run and what such a program computes, rad, root of the mean square.
    residual: float
    #: The part of the error that it explains; 0 or less if none.
    explained: float
    #: What to write instead.
    hint: str


class Judgement:
    """How far a run is off the exact motion, in what respect, and what the likely cause is. :func:`judge` makes one.

    Arrays have a row for each time, and are read-only. Those of ω are ``None`` of a run without ω.
    """

    def __init__(self, judged: _native.Judged) -> None:
        self._judged = judged
        self._report: dict[str, Any] = json.loads(judged["json"])

    #: Nothing with arrays in it is hashed.
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
        """The run's R_space_body in the scenario's axes, as quaternions (n, 4): w, x, y, z, of the length that they have in the run."""
        return _shown(self._judged["attitude"])

    @property
    def omega(self) -> Floats | None:
        """The run's ω along the scenario's body axes (n, 3), rad/s."""
        return _shown_if(self._judged["omega"])

    @property
    def exact_attitude(self) -> Floats:
        """The exact R_space_body as unit quaternions (n, 4): w, x, y, z, continuous."""
        return _shown(self._judged["exact_attitude"])

    @property
    def exact_omega(self) -> Floats:
        """The exact ω along body axes (n, 3), rad/s."""
        return _shown(self._judged["exact_omega"])

    @property
    def attitude_error(self) -> Floats:
        """The angle between the run's attitude and the exact one (n,), rad."""
        return _shown(self._judged["attitude_error"])

    @property
    def attitude_error_vector(self) -> Floats:
        """θ of R = R_exact exp(θ), along body axes (n, 3), rad."""
        return _shown(self._judged["attitude_error_vector"])

    @property
    def omega_error(self) -> Floats | None:
        """\\|δω\\| (n,), as a part of the largest exact \\|ω\\| of the run."""
        return _shown_if(self._judged["omega_error"])

    @property
    def kinetic_energy_error(self) -> Floats | None:
        """The error of ½ ω · I ω (n,), with its sign, as a part of the largest exact one."""
        return _shown_if(self._judged["kinetic_energy_error"])

    @property
    def momentum_error(self) -> Floats | None:
        """The error of \\|L\\| (n,), with its sign, as a part of the largest exact one."""
        return _shown_if(self._judged["momentum_error"])

    @property
    def momentum_direction_error(self) -> Floats | None:
        """The angle between L in space and the exact one (n,), rad."""
        return _shown_if(self._judged["momentum_direction_error"])

    @property
    def largest_attitude_error(self) -> float:
        """The largest of ``attitude_error``, rad."""
        return self._number("error", "attitude_largest_rad")

    @property
    def last_attitude_error(self) -> float:
        """The last of ``attitude_error``, rad."""
        return self._number("error", "attitude_last_rad")

    @property
    def exact_to(self) -> float:
        """What the exact attitude may be wrong by itself at the last row, rad: nothing below it can be told."""
        return self._number("error", "exact_to_rad")

    @property
    def is_exact(self) -> bool:
        """True if the run cannot be told from the exact motion."""
        return self._judged["is_exact"]

    @property
    def step(self) -> float | None:
        """The program's time step, s: as it was said, else the distance of the rows; ``None`` where that is not even."""
        step: float | None = self._run["step_s"]
        return step

    @property
    def engine(self) -> str | None:
        """The program that made the run, if that was said."""
        engine: str | None = self._run["engine"]
        return engine

    @property
    def reading(self) -> Reading:
        """What the run's numbers mean, and all that they were tried as."""
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
        """How the error grows; ``None`` where it is too small or too short to say."""
        said = self._run["growth"]
        return None if said is None else ErrorGrowth(said["law"], said.get("exponent"), said.get("rate_per_s"))

    @property
    def split(self) -> ErrorSplit:
        """What the error is made of."""
        said = self._run["split"]
        parts = (
            ErrorPart(part["part"], None if part["value"] is None else tuple(part["value"]), part["unit"], part["attitude_rad"])
            for part in said["parts"]
        )
        return ErrorSplit(tuple(parts), said["noise_rad"], said["rest_rad"], said["total_rad"], said["until_s"])

    @property
    def causes(self) -> list[Cause]:
        """All causes that were tried, likeliest first; none where there is nothing to explain, or no cause can be tried."""
        tried = self._run["causes"]["tried"]
        return [
            Cause(it["id"], it["cause"], it["is_mistake"], it["named"], it["residual_rad"], it["explained"], it["hint"]) for it in tried
        ]

    @property
    def likeliest(self) -> Cause | None:
        """The cause that explains the run best, if one does."""
        return next((cause for cause in self.causes if cause.named), None)

    def to_dict(self) -> dict[str, Any]:
        """The object that ``polhode judge --json`` prints: its keys are stable."""
        return dict(json.loads(self._judged["json"]))

    def report(self) -> str:
        """The text that ``polhode judge`` prints."""
        return in_python(self._judged["text"])

    def page(self) -> str:
        """The report as a page with plots, for a browser."""
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
            return f"Judgement({len(self)} rows, right to {self.exact_to:.1e} rad)"
        cause = "no cause found" if self.likeliest is None else self.likeliest.id
        return f"Judgement({len(self)} rows, up to {self.largest_attitude_error:.1e} rad off, {cause})"

    def __str__(self) -> str:
        return self.report()

    def _repr_markdown_(self) -> str:
        return self._judged["markdown"]

    def _repr_html_(self) -> str:
        return _html.frame(self.page())


def _shown(array: Floats) -> Floats:
    """To be looked at only: a view, as copies from other processes can be written to."""
    view = array.view()
    view.flags.writeable = False
    return view


def _shown_if(array: Floats | None) -> Floats | None:
    return None if array is None else _shown(array)


def _read(reading: dict[str, Any]) -> tuple[str, str, str, float]:
    return reading["quaternion"], reading["sense"], reading["axes"], reading["time_origin_s"]
