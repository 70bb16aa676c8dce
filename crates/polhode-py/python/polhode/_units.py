"""Conversion of quantities to SI: of Pint, of Astropy, and of text with a unit, such as ``"2 cm"``.
Neither library is imported unless it is already loaded."""

from __future__ import annotations

import re
import sys
from typing import Any, NamedTuple

import numpy as np

from . import _native
from ._error import PolhodeError

#: A number in SI units, or a text of a number and a unit, such as ``"12 mm"``.
Quantity = float | str


class Dimension(NamedTuple):
    """A kind of physical quantity."""

    #: Name in messages.
    words: str
    #: SI unit.
    unit: str
    #: Exponents of kg, m and s; the radian counts as 1.
    powers: tuple[int, int, int]


NUMBER = Dimension("a plain number", "1", (0, 0, 0))
ANGLE = Dimension("an angle", "rad", (0, 0, 0))
TIME = Dimension("a time", "s", (0, 0, 1))
LENGTH = Dimension("a length", "m", (0, 1, 0))
MASS = Dimension("a mass", "kg", (1, 0, 0))
DENSITY = Dimension("a density", "kg/m³", (1, -3, 0))
AREA_DENSITY = Dimension("a mass per area", "kg/m²", (1, -2, 0))
LINE_DENSITY = Dimension("a mass per length", "kg/m", (1, -1, 0))
INERTIA = Dimension("a moment of inertia", "kg·m²", (1, 2, 0))
ANGULAR_VELOCITY = Dimension("an angular velocity", "rad/s", (0, 0, -1))
ANGULAR_ACCELERATION = Dimension("an angular acceleration", "rad/s²", (0, 0, -2))
ANGULAR_MOMENTUM = Dimension("an angular momentum", "kg·m²/s", (1, 2, -1))
ACCELERATION = Dimension("an acceleration", "m/s²", (0, 1, -2))
FORCE = Dimension("a force", "N", (1, 1, -2))
TORQUE = Dimension("a torque", "N·m", (1, 2, -2))

#: Dimensions of arguments by name. Other arguments are not physical quantities.
DIMENSIONS: dict[str, Dimension] = {
    **dict.fromkeys(["times", "attitude_times", "duration", "periods", "shortest", "time_origin", "step", "worker_timeout"], TIME),
    **dict.fromkeys(["center_of_mass", "centers_of_mass", "about", "pivot", "point", "position", "positions", "vertices", "source"], LENGTH),
    **dict.fromkeys(["size", "radius", "inner_radius", "length", "base_radius", "top_radius", "height", "semi_axes", "ring_radius", "tube_radius"], LENGTH),
    **dict.fromkeys(["shell", "walls", "top_layers", "bottom_layers", "spacing", "origin", "weld", "fill", "unit"], LENGTH),
    **dict.fromkeys(["mass", "masses", "mass_unit"], MASS),
    **dict.fromkeys(["density", "per_value"], DENSITY),
    "area_density": AREA_DENSITY,
    "line_density": LINE_DENSITY,
    **dict.fromkeys(["inertia", "inertias", "moments", "added"], INERTIA),
    **dict.fromkeys(["omega", "start_omega", "gyro", "gyro_noise", "slowest", "omega_noise"], ANGULAR_VELOCITY),
    **dict.fromkeys(["alpha", "alpha_noise"], ANGULAR_ACCELERATION),
    **dict.fromkeys(["acceleration", "acceleration_noise", "gravity"], ACCELERATION),
    **dict.fromkeys(["force", "force_noise"], FORCE),
    **dict.fromkeys(["torque", "torque_noise", "the torque of a function"], TORQUE),
    "attitude_noise": ANGLE,
    "a wheel's momentum": ANGULAR_MOMENTUM,
    **dict.fromkeys(["attitude", "rotation", "axes", "a wheel's axis", "tolerance", "outlier"], NUMBER),
}

#: Types of numbers without a unit, and of values without a unit.
_BARE = {float, int, np.float64}
_PLAIN = {*_BARE, np.ndarray}

#: Names of SI base units in Pint and Astropy, and their symbols here.
_BASE = {
    **{"kilogram": "kg", "gram": "kg", "meter": "m", "metre": "m", "second": "s", "radian": "rad", "ampere": "A"},
    **{"kg": "kg", "m": "m", "s": "s", "rad": "rad", "A": "A"},
}
_PINT = {"kg": "kilogram", "m": "meter", "s": "second", "rad": "radian", "A": "ampere"}


def library_of(value: object) -> str | None:
    """Returns the library of a quantity; ``None`` for anything else."""
    if type(value) is np.ndarray:
        return None
    for kind in type(value).__mro__:
        name = kind.__module__.partition(".")[0]
        if name in ("pint", "astropy") and name in sys.modules:
            return None if getattr(value, "unit" if name == "astropy" else "units", None) is None else name
    return None


def has_units(value: object) -> bool:
    """Returns true if the value is a quantity of a library, or a list that contains one."""
    if isinstance(value, (list, tuple)):
        return not set(map(type, value)) <= _PLAIN and any(map(has_units, value))
    return library_of(value) is not None


def has_text(value: object) -> bool:
    """Returns true if the value is a text, or a list that contains one."""
    if isinstance(value, (list, tuple)):
        return not set(map(type, value)) <= _BARE and any(map(has_text, value))
    return isinstance(value, str)


def number_of(name: str, text: str, dimension: Dimension) -> float | None:
    """Returns the number in SI units of a text with a unit; ``None`` for other texts."""
    angle = 1 if dimension.unit.startswith("rad") else 0
    try:
        return _native.quantity(text, (*dimension.powers, angle))
    except UnicodeEncodeError:  # a lone surrogate
        return None
    except PolhodeError as error:
        raise PolhodeError(f"{name} = {text!r}: {error.message}", error.hint) from None


def without(name: str, value: object) -> None:
    """Refuses a quantity where a plain number is required, even if the argument's name has a
    dimension elsewhere."""
    if has_units(value) or has_text(value):
        raise PolhodeError(f"{name} must be {NUMBER.words}, but has a unit")


def dimension_of(name: str) -> Dimension | None:
    """Returns the dimension of an argument or of an element of one: ``masses[3]``,
    ``parts['hub']['mass']``."""
    if wheel := re.match(r"wheels\[\d+\]\[([01])\]", name):
        return DIMENSIONS[("a wheel's axis", "a wheel's momentum")[int(wheel[1])]]
    if within := re.match(r"parts\[.*\]\['(\w+)'\]$", name):
        return DIMENSIONS.get(within[1])
    return DIMENSIONS.get(name.partition("[")[0])


def taken_apart(name: str, value: Any) -> tuple[Any, float, dict[str, int]]:
    """Returns the numbers of a quantity, the factor for conversion to SI, and the exponents of its
    base units."""
    library = library_of(value)
    try:
        given, powers = _of_pint(value) if library == "pint" else _of_astropy(value)
    except Exception as error:  # any error of the library for units that it cannot convert
        raise TypeError(f"{name} has a unit that cannot be converted to SI ({type(error).__name__}: {error})") from None
    if "Hz" in given or "hertz" in given:
        raise PolhodeError(f"{name} is in {given}, which can mean turns or radians per second", "give rad/s, or turns per second")
    bases: dict[str, int] = {}
    for base, power in powers.items():
        symbol = _BASE.get(base)
        if symbol is None or power != int(power):
            raise PolhodeError(f"{name} has the unit {given}, which is not a product of kg, m, s, A and rad")
        bases[symbol] = int(power)
    if library == "pint":
        product = "*".join(f"{_PINT[symbol]}**{power}" for symbol, power in bases.items()) or "dimensionless"
        number, factor = value.magnitude, (1.0 * value.units).to(product).magnitude
    else:
        number, factor = value.value, float(value.unit.to(_product(bases)))
    return number, factor, bases


def _of_pint(value: Any) -> tuple[str, dict[str, Any]]:
    return f"{value.units:P}", dict((1.0 * value.units).to_root_units().unit_items())


def _of_astropy(value: Any) -> tuple[str, dict[str, Any]]:
    base = value.unit.decompose()
    return str(value.unit), {str(one): power for one, power in zip(base.bases, base.powers)}


def _product(bases: dict[str, int]) -> Any:
    units = sys.modules["astropy.units"]
    product = units.dimensionless_unscaled
    for symbol, power in bases.items():
        product = product * getattr(units, symbol) ** power
    return product
