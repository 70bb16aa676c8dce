"""Numbers that were found by measurements, with what is known of them."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Iterator, NamedTuple

import numpy as np

from . import _html
from ._arrays import Floats
from ._record import Record


class Number(NamedTuple):
    """A number that was found."""

    #: What it is: ``Ixx``, ``gyro bias x``, ``radius`` …
    name: str
    #: Its unit: ``kg·m²``, ``rad/s``; ``1`` of a ratio.
    unit: str
    #: In that unit; NaN of an angle or a ratio whose standard deviation exceeds its possible range.
    value: float
    #: Its standard deviation: zero of what was given as exact, ``None`` if the measurements do not say the number.
    sd: float | None
    #: The reason why it is not determined; ``None`` if it is.
    reason: str | None = None

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        if self.sd is None:
            return f"{self.name}: not determined" + (f" ({self.reason})" if self.reason else "")
        return f"{self.name}: {self.value:.6g}{f' ± {self.sd:.2g}' if self.sd > 0.0 else ''}{unit}"


@dataclass(frozen=True, eq=False, repr=False)
class Estimate(Record):
    """Numbers that were found, and their errors: ``estimate["Ixx"]`` is a :class:`Number`, and iteration gives all of them.

    What the measurements do not determine is a direction in :attr:`unknown`: along it the numbers could be moved, and the measurements would be
    predicted as well. The covariance is that of the rest.
    """

    #: The n numbers' names.
    names: tuple[str, ...]
    #: Their units.
    units: tuple[str, ...]
    #: Their values (n,), in these units.
    values: Floats
    #: Standard deviations (n,); NaN of a number that changes along a direction that is unknown.
    sd: Floats
    #: Covariance (n, n).
    covariance: Floats
    #: Directions in which nothing is known (k, n), each of length 1 in the numbers' units.
    unknown: Floats
    #: Reasons why numbers are not determined; ``None`` of those that are.
    reasons: tuple[str | None, ...] = ()

    @property
    def correlation(self) -> Floats:
        """Correlations (n, n); NaN of numbers that are not known, or exact."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.covariance / np.outer(self.sd, self.sd)

    def __getitem__(self, name: str) -> Number:
        """The number of this name."""
        if name not in self.names:
            raise KeyError(f"{name!r} is none of {', '.join(self.names)}")
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


@dataclass(frozen=True, eq=False, repr=False)
class PrincipalEstimate(Record):
    """Principal moments and axes with their errors, to first order in those of the tensor. What is not known has an error of NaN or ``None``."""

    #: Moments (3,), ascending, kg·m²; over the greatest where their size is not known.
    moments: Floats
    #: Their standard deviations (3,).
    moment_sd: Floats
    #: Their covariance (3, 3); ``None`` unless all three are known.
    moment_covariance: Floats | None
    #: i1/i3 and i2/i3 (2,); NaN where the standard deviation exceeds the possible range.
    ratios: Floats
    #: Their standard deviations (2,).
    ratio_sd: Floats
    #: The correlation of the two.
    ratio_correlation: float | None
    #: (i1 + i2 − i3)/i3: zero of a lamina, and never negative; ``None`` where it is not determined.
    thickness: float | None
    #: Its standard deviation.
    thickness_sd: float | None
    #: Principal axes as rows (3, 3): ``axes[k]`` belongs to ``moments[k]``.
    axes: Floats
    #: Standard deviation of the turn of all axes about each (3,), rad; NaN where the other two moments are equal, or the turn is not known.
    turn_sd: Floats

    #: Reasons of numbers that are not determined, by name: ``i1/i3``, ``i2/i3``, ``thickness``, ``turn about axis 1`` …
    not_determined: dict[str, str]

    @property
    def principal_rotation(self) -> Floats:
        """Rotation matrix R_body_principal (3, 3): takes principal components to body components; column ``k`` is the axis of ``moments[k]``."""
        return np.ascontiguousarray(self.axes.T)

    def ratios_in_words(self) -> str:
        """The ratios with their errors, in a line."""
        each = (f"{value:.5g} ± {sd:.2g}" if sd >= 0.0 else "not determined" for value, sd in zip(self.ratios, self.ratio_sd))
        return ", ".join(f"i{k}/i3 = {one}" for k, one in enumerate(each, 1))

    def __repr__(self) -> str:
        return f"PrincipalEstimate({self.ratios_in_words()})"


class ResidualTest(NamedTuple):
    """Whether what is left of one kind of measurement is noise."""

    #: What was measured: ``angular velocity``, ``force`` …
    what: str
    #: How many numbers were measured.
    count: int  # type: ignore[assignment]
    #: ``count`` less the share of the numbers that were found from them.
    degrees_of_freedom: float
    #: Standard deviation of the noise that they were weighed by.
    noise: float
    #: True if that was told; else it was found from how the readings jump.
    noise_is_told: bool
    #: χ²/degrees of freedom: about 1 if the model is right, and the noise what it was taken for.
    reduced_chi_square: float
    #: Correlation of residuals that follow each other; ``None`` where none do.
    lag_correlation: float | None
    #: Residuals are larger than the noise, beyond chance.
    is_too_large: bool
    #: Residuals follow each other, beyond chance.
    is_correlated: bool


def counted(number: int, noun: str) -> str:
    """How many there are."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def floats(values: Any) -> Floats:
    """Numbers of a report, in which what is not known is ``null``, as NaN."""
    return np.array(values, dtype=np.float64)


def estimate_of(said: dict[str, Any]) -> Estimate:
    """What a report has of an estimate."""
    numbers = said["numbers"]
    names, units = (tuple(number[key] for number in numbers) for key in ("name", "unit"))
    values, sd = (floats([number[key] for number in numbers]) for key in ("value", "sd"))
    reasons = tuple(number.get("reason") for number in numbers)
    unknown = floats(said["unknown"]).reshape(-1, len(names))
    return Estimate(names, units, values, sd, floats(said["covariance"]), unknown, reasons)


def principal_of(said: dict[str, Any] | None) -> PrincipalEstimate | None:
    """The same of principal moments; there are none where the tensor is not known."""
    if said is None:
        return None
    values: dict[str, Any] = {field.name: said[field.name] for field in fields(PrincipalEstimate)}
    arrays = {name: floats(value) for name, value in values.items() if isinstance(value, list)}
    return PrincipalEstimate(**{**values, **arrays})


def residual_test_of(said: dict[str, Any]) -> ResidualTest:
    """The same of a test of residuals."""
    return ResidualTest(**{key: said[key] for key in ResidualTest._fields})
