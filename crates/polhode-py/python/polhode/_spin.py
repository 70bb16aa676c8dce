"""Spins of a tumbling body with two given periods."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy.typing as npt

from . import _arrays, _native
from ._arrays import Floats
from ._body import Body
from ._error import PolhodeError, in_python
from ._estimate import floats
from ._free_motion import FreeMotion, tensor_of
from ._mass_properties import MassProperties
from ._public import public
from ._record import Record


@public("polhode.results")
@dataclass(frozen=True, eq=False)
class TumblingSpin(Record):
    """A spin with the given periods. Its mirror images have them too."""

    #: Kind of motion, by the axis that L circles: ``long_axis`` or ``short_axis``.
    regime: str
    #: Angular velocity at one moment of the motion (3,), body axes, rad/s.
    omega: Floats
    #: Magnitude of the angular momentum \|L\|, kg·m²/s.
    momentum: float
    #: Kinetic energy relative to the least with the same L.
    energy_ratio: float
    #: Inertia tensor (3, 3), kg·m².
    inertia: Floats

    @property
    def motion(self) -> FreeMotion:
        """Free motion with this spin."""
        return FreeMotion(inertia=self.inertia, omega=self.omega)


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class Tumbling(Record):
    """All spins of a body with two given periods, as :func:`spins_from_periods` returns them.

    It is a sequence of ``spins``.
    """

    #: Periods of precession and of rotation, s.
    periods: tuple[float, float]
    #: Reference axis of the periods: ``long``, the axis of least moment, or ``short``, that of
    #: greatest.
    convention: str
    #: Spins with these periods.
    spins: tuple[TumblingSpin, ...]
    #: JSON and text, as the command prints them.
    _said: tuple[str, str]

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode spin --periods --json`` prints. Its keys are stable."""
        return dict(json.loads(self._said[0]))

    def __iter__(self) -> Iterator[TumblingSpin]:
        return iter(self.spins)

    def __len__(self) -> int:
        return len(self.spins)

    def __getitem__(self, which: int) -> TumblingSpin:
        return self.spins[which]

    def __repr__(self) -> str:
        return f"Tumbling({', '.join(spin.regime for spin in self.spins)})"

    def __str__(self) -> str:
        return in_python(self._said[1])


def spins_from_periods(
    *,
    periods: npt.ArrayLike,
    convention: str,
    moments: npt.ArrayLike | None = None,
    inertia: npt.ArrayLike | MassProperties | Body | None = None,
) -> Tumbling:
    """Finds all spins of a tumbling body with two given periods (``polhode spin --periods``).

    The light curve of an asteroid shows such periods.

    Parameters
    ----------
    periods
        Periods of precession P_φ and of rotation P_ψ (2,), s.
    convention
        Reference axis of the periods: ``"long"``, the axis of least moment (Samarasinha & A'Hearn
        1991), or ``"short"``, that of greatest (Kaasalainen 2001).
    moments
        Moments (3,) about the body's axes, kg·m², or any multiple of them.
    inertia
        Instead of ``moments``: the tensor (3, 3), mass properties or a body.

    Returns
    -------
    Tumbling

    Raises
    ------
    PolhodeError
        If no spin of this body has these periods.

    Examples
    --------
    (4179) Toutatis. Its long axis precesses with a period of 7.40 days, and the body rotates about
    it in 5.38 days:

    >>> import polhode
    >>> day = 86_400.0
    >>> periods = [7.40 * day, 5.38 * day]
    >>> found = polhode.spins_from_periods(moments=[3.0836, 3.235, 1.0], periods=periods, convention="long")
    >>> [one.regime for one in found], round(found[0].motion.precession_period / day, 9)
    (['long_axis'], 7.4)
    """
    if (moments is None) == (inertia is None):
        raise PolhodeError("give exactly one of moments and inertia")
    given = ("moments", _arrays.triple("moments", moments)) if moments is not None else ("inertia", tensor_of(inertia))
    tensor = _arrays.tensor(*given)
    both = _arrays.numbers("periods", periods, (2,))
    _arrays.refuse("periods", both, both <= 0.0, "positive")
    axis = _arrays.choice("convention", convention, ["long", "short"])
    printed = _native.tumbling_spins(tensor, both.tolist(), axis == "long")
    spins = tuple(
        TumblingSpin(
            regime=said["regime"],
            omega=floats(said["omega_body"]),
            momentum=said["momentum_kg_m2_s"],
            energy_ratio=said["energy_ratio"],
            inertia=floats(tensor),
        )
        for said in json.loads(printed[0])["spins"]
    )
    return Tumbling(periods=(float(both[0]), float(both[1])), convention=axis, spins=spins, _said=printed)
