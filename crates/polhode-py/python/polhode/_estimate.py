"""Estimates from measurements, with their uncertainty."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Iterator, NamedTuple

import numpy as np

from . import _html
from ._arrays import Floats
from ._public import public
from ._record import Record


@public("polhode.results")
class Number(NamedTuple):
    """An estimated number with its standard deviation."""

    #: Name, such as ``Ixx``, ``gyro bias x`` or ``radius``.
    name: str
    #: Unit, such as ``kg·m²`` or ``rad/s``; ``1`` for a ratio.
    unit: str
    #: Value in that unit; NaN for an angle or a ratio whose standard deviation exceeds its possible
    #: range.
    value: float
    #: Standard deviation; zero for a number given as exact, ``None`` if the measurements do not
    #: determine the number.
    sd: float | None
    #: Reason why the number is not determined; ``None`` if it is.
    reason: str | None = None

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        if self.sd is None:
            return f"{self.name}: not determined" + (f" ({self.reason})" if self.reason else "")
        return f"{self.name}: {self.value:.6g}{f' ± {self.sd:.2g}' if self.sd > 0.0 else ''}{unit}"


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class Estimate(Record):
    """Estimated numbers with their covariance.

    ``estimate["Ixx"]`` is a :class:`Number`, and iteration yields all numbers.

    Each row of :attr:`unknown` is a direction that the measurements do not determine: a change of
    the numbers along it leaves the predicted measurements unchanged. The covariance is that of the
    determined part.
    """

    #: Names of the n numbers.
    names: tuple[str, ...]
    #: Units of the numbers.
    units: tuple[str, ...]
    #: Values (n,), in these units.
    values: Floats
    #: Standard deviations (n,); NaN for a number that changes along an unknown direction.
    sd: Floats
    #: Covariance (n, n).
    covariance: Floats
    #: Undetermined directions (k, n), each a unit vector in the units of the numbers.
    unknown: Floats
    #: Reasons why numbers are not determined; ``None`` for those that are.
    reasons: tuple[str | None, ...] = ()

    @property
    def correlation(self) -> Floats:
        """Correlations (n, n); NaN for numbers that are not determined or exact."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.covariance / np.outer(self.sd, self.sd)

    def __getitem__(self, name: str) -> Number:
        """Returns the number of this name."""
        if name not in self.names:
            raise KeyError(f"{name!r} is not one of {', '.join(self.names)}")
        k = self.names.index(name)
        sd = float(self.sd[k])
        reason = self.reasons[k] if self.reasons else None
        return Number(name, self.units[k], float(self.values[k]), None if np.isnan(sd) else sd, reason)

    def __iter__(self) -> Iterator[Number]:
        return map(self.__getitem__, self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        unknown = f", {counted(len(self.unknown), 'direction')} unknown" if len(self.unknown) else ""
        return f"Estimate({counted(len(self), 'number')}{unknown})"

    def __str__(self) -> str:
        return "\n".join(map(str, self))

    def _repr_html_(self) -> str:
        def shown(number: Number) -> tuple[str, ...]:
            return _html.number(number.value), "not known" if number.sd is None else f"{number.sd:.2g}", number.unit

        return _html.rows(["value", "sd", "unit"], [(number.name, shown(number)) for number in self])


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class PrincipalEstimate(Record):
    """Principal moments and axes with their errors, to first order in those of the tensor.

    Undetermined numbers have an error of NaN or ``None``.
    """

    #: Moments (3,), ascending, kg·m²; relative to the greatest if only ratios are known.
    moments: Floats
    #: Standard deviations of the moments (3,).
    moment_sd: Floats
    #: Covariance of the moments (3, 3); ``None`` unless all three are known.
    moment_covariance: Floats | None
    #: Ratios i1/i3 and i2/i3 (2,); NaN where the standard deviation exceeds the possible range.
    ratios: Floats
    #: Standard deviations of the ratios (2,).
    ratio_sd: Floats
    #: Correlation of the two ratios.
    ratio_correlation: float | None
    #: (i1 + i2 − i3)/i3: zero for a lamina, never negative; ``None`` if not determined.
    thickness: float | None
    #: Standard deviation of the thickness.
    thickness_sd: float | None
    #: Principal axes as rows (3, 3): ``axes[k]`` belongs to ``moments[k]``.
    axes: Floats
    #: Standard deviation of the rotation of all axes about each axis (3,), rad; NaN if the other
    #: two moments are equal, or the rotation is not determined.
    turn_sd: Floats

    #: Reasons why numbers are not determined, by name: ``i1/i3``, ``i2/i3``, ``thickness``,
    #: ``turn about axis 1`` …
    not_determined: dict[str, str]

    @property
    def principal_rotation(self) -> Floats:
        """Rotation matrix R_body_principal (3, 3), from principal to body components.

        Column ``k`` is the axis of ``moments[k]``.
        """
        return np.ascontiguousarray(self.axes.T)

    def ratios_in_words(self) -> str:
        """Returns the ratios with their errors, as one line of text."""
        each = (f"{value:.5g} ± {sd:.2g}" if sd >= 0.0 else "not determined" for value, sd in zip(self.ratios, self.ratio_sd))
        return ", ".join(f"i{k}/i3 = {one}" for k, one in enumerate(each, 1))

    def __repr__(self) -> str:
        return f"PrincipalEstimate({self.ratios_in_words()})"


@public("polhode.results")
class ResidualTest(NamedTuple):
    """Test whether the residuals of one kind of measurement are noise."""

    #: Measured quantity: ``angular velocity``, ``force`` …
    what: str
    #: Number of measured values.
    count: int  # type: ignore[assignment]
    #: ``count`` minus the share of the parameters estimated from these measurements.
    degrees_of_freedom: float
    #: Standard deviation of the noise used for the weights.
    noise: float
    #: True if the noise was given; false if it was estimated from the scatter of the readings.
    noise_is_told: bool
    #: χ²/degrees of freedom: about 1 if the model and the assumed noise are right.
    reduced_chi_square: float
    #: Correlation of successive residuals; ``None`` if there are none.
    lag_correlation: float | None
    #: True if the residuals are significantly larger than the noise.
    is_too_large: bool
    #: True if successive residuals are significantly correlated.
    is_correlated: bool


def counted(number: int, noun: str) -> str:
    """Returns a count with its noun in the singular or plural."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def floats(values: Any) -> Floats:
    """Converts numbers of a report to an array, with ``null`` as NaN."""
    return np.array(values, dtype=np.float64)


def estimate_of(said: dict[str, Any]) -> Estimate:
    """Converts the estimate of a report."""
    numbers = said["numbers"]
    names, units = (tuple(number[key] for number in numbers) for key in ("name", "unit"))
    values, sd = (floats([number[key] for number in numbers]) for key in ("value", "sd"))
    reasons = tuple(number.get("reason") for number in numbers)
    unknown = floats(said["unknown"]).reshape(-1, len(names))
    return Estimate(names, units, values, sd, floats(said["covariance"]), unknown, reasons)


def principal_of(said: dict[str, Any] | None) -> PrincipalEstimate | None:
    """Converts the principal moments of a report; ``None`` if the tensor is not known."""
    if said is None:
        return None
    values: dict[str, Any] = {field.name: said[field.name] for field in fields(PrincipalEstimate)}
    arrays = {name: floats(value) for name, value in values.items() if isinstance(value, list)}
    return PrincipalEstimate(**{**values, **arrays})


def residual_test_of(said: dict[str, Any]) -> ResidualTest:
    """Converts the residual test of a report."""
    return ResidualTest(**{key: said[key] for key in ResidualTest._fields})
