"""Quantities of Pint and of Astropy at every argument that takes one: the same as in SI, and refused where they are of another kind."""

from __future__ import annotations

import inspect
import itertools
import subprocess
import sys
import warnings
from collections.abc import Callable, Iterator
from typing import Any

import astropy.units as astropy
import numpy as np
import pint
import polhode
import polhode.batch
import polhode.sweep
import pytest
from conftest import ROOT
from polhode import plot, scenario, shapes
from polhode._units import DIMENSIONS, NUMBER, Dimension, dimension_of
from test_arguments import TRIANGLES, VERTICES, functions

PINT = pint.UnitRegistry()

#: What is no quantity of one kind: names, files, tables, switches, counts, functions; and covariances, whose elements are of several.
NEITHER = set(
    """allow_unphysical arguments ax axes_names basis bias body center changes clock columns configuration contact convention decimal derivatives drag draws edge ends
    engine error events field findings flights folder format gimbals hull isotopes joint joints kind link material mass_history member members mesh molecule
    motion name numbers of_number omega_axes on orbit out output parameters parts path pendulum pivot plan pointings prescribed products progress quaternion
    resume roots rows run scale scenario seed sense shaft skew start stop subtree tests threads title torques triangles union wheels workers wrench
    wrench_covariance force format""".split()
)

#: Of these a reader of texts knows what kind of quantity each place takes.
TEXTS = {"pivot", "joints", "center", "numbers", "tests"}


def public() -> Iterator[Callable[..., object]]:
    """What users call: functions, classes that they make, and the methods of all."""
    made = (polhode.MassProperties, polhode.Body, polhode.FreeMotion, polhode.Ensemble, polhode.Scenario, polhode.Flight, polhode.batch.Plan)
    for module in (polhode, shapes, plot, polhode.batch, polhode.sweep):
        own = [name for name, value in vars(module).items() if not name.startswith("_") and getattr(value, "__module__", "") == module.__name__]
        names = getattr(module, "__all__", own)
        for value in (vars(module)[name] for name in names):
            if inspect.isfunction(value) and value.__module__.startswith("polhode"):
                yield value
            elif inspect.isclass(value) and value.__module__.startswith("polhode"):
                yield from ([value] if value in made else [])
                yield from (member for name, member in vars(value).items() if not name.startswith("_") and inspect.isfunction(member))


def test_every_argument_has_a_dimension_or_none() -> None:
    """A new argument is said to be one or the other."""
    found = {name for function in public() for name in inspect.signature(function).parameters} - {"self"}
    assert len(found) > 100 and not (DIMENSIONS.keys() & NEITHER - {"force"})
    assert found - DIMENSIONS.keys() - NEITHER == set()


def units(dimension: Dimension, factor: float) -> tuple[Any, Any]:
    """A unit of a kind of Pint and of Astropy, of which so many are one of SI: it is made of others than SI's."""
    kg, m, s = dimension.powers
    rate = dimension.unit.startswith("rad")
    angle = 1 if rate else 0
    one = (PINT.gram * 1e3) ** kg * (PINT.centimeter * 1e2) ** m * (PINT.minute / 60.0) ** s * (PINT.degree * (180.0 / np.pi)) ** angle
    two = (1e3 * astropy.g) ** kg * (100.0 * astropy.cm) ** m * (astropy.min / 60.0) ** s * (astropy.deg * (180.0 / np.pi)) ** angle
    return one * factor, two * factor


#: What no argument is.
NONE_OF_THEM = Dimension("nothing", "kg² m s", (2, 1, 1))


def quantities(value: Any, dimension: Dimension) -> tuple[Any, Any]:
    return tuple(np.asarray(value, float) * unit for unit in units(dimension, 1.0))  # type: ignore[return-value]


def numbers_of(found: Any) -> np.ndarray:
    """All numbers of a result."""
    if isinstance(found, polhode.MassProperties):
        return np.array([found.mass, *found.center_of_mass, *found.inertia.ravel()])
    if isinstance(found, polhode.FreeMotion):
        return np.concatenate([found.moments, found.momentum, found.at(0.7).attitude])
    if isinstance(found, polhode.Ensemble):
        return np.concatenate([part.ravel() for part in found.at([0.0, 0.7])])
    if isinstance(found, polhode.Motion):
        return np.concatenate([found.times, found.omega.ravel()])
    if isinstance(found, tuple):
        return np.concatenate([np.ravel(part) for part in found if part is not None])
    if isinstance(found, polhode.EnsembleStates):
        return np.concatenate([part.ravel() for part in found])
    if isinstance(found, polhode.MotionError):
        return np.concatenate([np.ravel(part) for part in found])
    return np.array([]) if isinstance(found, (str, type(None))) else np.ravel(found) if isinstance(found, (np.ndarray, float)) else np.array([])


def test_arguments_take_quantities_of_their_own_kind_alone() -> None:
    """Of all functions that the tests of arguments call."""
    seen, compared = set(), 0
    for function, right in functions().items():
        if function is polhode.sweep.run:
            continue
        for name, value in right.items():
            dimension = dimension_of(name)
            if dimension is None or value is None or name in ("unit", "kind") or function is polhode.plot.polhode:
                continue
            if name == "source":  # its vertices: test_meshes
                continue
            what = f"{function.__qualname__}({name})"
            expected = numbers_of(function(**right))
            for given in quantities(value, dimension):
                if isinstance(value, polhode.MassProperties):
                    continue
                found = numbers_of(function(**right | {name: given}))
                assert found.shape == expected.shape, what
                if found.size:
                    compared += 1
                    assert np.allclose(found, expected, rtol=1e-12, atol=1e-12), what
            for wrong in quantities(value, NONE_OF_THEM):
                with pytest.raises(polhode.PolhodeError, match=rf"^{name}(\[\d\])? is in .* where {dimension.words} belongs") as error:
                    function(**right | {name: wrong})
                    pytest.fail(f"{what} takes it")
                assert dimension.unit in str(error.value)
            seen.add(name)
    assert compared > 40 and {"omega", "times", "moments", "mass", "density", "masses", "positions", "duration", "size", "area_density"} <= seen


def test_meshes() -> None:
    plain = polhode.inertia((np.array(VERTICES) * 1e-3, TRIANGLES), density=2700.0)
    corners = np.array(VERTICES)[np.array(TRIANGLES)]
    for source in (
        (np.array(VERTICES) * PINT.millimeter, TRIANGLES),
        (np.array(VERTICES) * astropy.mm, TRIANGLES),
        corners * PINT.millimeter,
        corners * astropy.mm,
    ):
        body = polhode.inertia(source, density=2.7 * PINT.gram / PINT.centimeter**3)
        assert np.allclose(numbers_of(body), numbers_of(plain), rtol=1e-13, atol=0)
        with pytest.raises(polhode.PolhodeError, match="a unit is given twice"):
            polhode.inertia(source, density=1.0, unit="mm")
    derived = polhode.mesh_derivatives((np.array(VERTICES) * PINT.millimeter, TRIANGLES), mass=1e3 * astropy.g)
    assert derived.values[0] == 1.0
    shell = polhode.inertia((VERTICES, TRIANGLES), unit="mm", density=1.0, shell=0.1 * PINT.millimeter)
    assert shell.mass == polhode.inertia((VERTICES, TRIANGLES), unit="mm", density=1.0, shell=1e-4).mass
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        mended = [polhode.inertia((VERTICES, TRIANGLES[:3]), unit="mm", density=1.0, fill=fill) for fill in ("40 mm", 4.0 * astropy.cm)]
    assert mended[0] == mended[1]
    arm = ROOT / "examples" / "robots" / "arm.urdf"
    turned = [polhode.inertia(arm, joints={"elbow": angle}) for angle in (0.3, np.rad2deg(0.3) * PINT.degree)]
    assert np.allclose(numbers_of(turned[0]), numbers_of(turned[1]), rtol=1e-13, atol=1e-15)
    with pytest.raises(polhode.PolhodeError, match="length"):
        polhode.inertia(arm, joints={"elbow": 0.3 * PINT.meter})


def test_tables_of_scenarios(generic: polhode.MassProperties) -> None:
    """A quantity is a text with its unit, which the reader checks."""
    given = polhode.Scenario(
        generic,
        start=scenario.Start(omega=np.array([30.0, 20.0, -10.0]) * PINT.rpm),
        torques=[scenario.Drag(law="linear", coefficient=2.0 * astropy.N * astropy.mm * astropy.s / astropy.rad)],
        run=scenario.Run(duration=2.0 * astropy.min, samples=3),
    )
    plain = given.replace(
        start=scenario.Start(omega=np.array([30.0, 20.0, -10.0]) * np.pi / 30.0),
        torques=[scenario.Drag(law="linear", coefficient=2e-3)],
        run=scenario.Run(duration=120.0, samples=3),
    )
    assert np.allclose(polhode.simulate(given).omega, polhode.simulate(plain).omega, rtol=1e-11, atol=0)
    with pytest.raises(polhode.PolhodeError, match=r"torques\[0\].coefficient: .* is an energy or a torque where a torque per angular velocity belongs"):
        given.replace(torques=[scenario.Drag(law="linear", coefficient=2.0 * PINT.newton * PINT.meter)])
    swung = {"value": 3.2 * PINT.kilogram, "sd": 1.0 * astropy.g}
    with pytest.raises(polhode.PolhodeError, match="where a mass belongs"):
        polhode.identify_swings(mass=swung | {"sd": 1.0 * astropy.m}, center=[0, 0, 0], tests=[])


def test_flights_and_wheels() -> None:
    times, gyro = np.arange(4) * 0.01, np.ones((4, 3))
    plain = polhode.Flight(times=times, gyro=gyro, wheels=[([0, 0, 1], 0.2)], added=np.eye(3))
    for unit in (PINT, astropy):
        second, degree, kg, m = (unit.second, unit.degree, unit.kilogram, unit.meter) if unit is PINT else (unit.s, unit.deg, unit.kg, unit.m)
        given = polhode.Flight(
            times=times / 60.0 * (unit.minute if unit is PINT else unit.min),
            gyro=np.rad2deg(gyro) * (degree / second),
            wheels=[([0, 0, 1], 0.2 * (kg * m**2 / second))],
            added=np.eye(3) * (kg * m**2),
        )
        one, two = given._arrays(), plain._arrays()
        assert all(np.allclose(one[key], two[key], rtol=1e-14) for key in ("times", "gyro", "added"))
        with pytest.raises(polhode.PolhodeError, match=r"wheels\[0\]\[1\] is in .* where an angular momentum belongs"):
            polhode.Flight(times=times, gyro=gyro, wheels=[([0, 0, 1], 0.2 * kg)])
        with pytest.raises(polhode.PolhodeError, match="torque must be a plain number, and has a unit"):
            polhode.find_flights(times=times, gyro=gyro, torque=0.1 * (kg * m**2 / second**2))
    derived = polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 0.5]).derivatives(1.0)
    with pytest.raises(polhode.PolhodeError, match="inertia must be a plain number, and has a unit"):
        derived.covariance(inertia=np.eye(6) * PINT.kilogram * PINT.meter**2)


def test_what_has_no_one_meaning_is_refused() -> None:
    omega = np.array([1.0, 2.0, 3.0])
    for wrong, says in (
        (omega * PINT.hertz, "omega is in Hz, which may be turns or radians"),
        (omega * astropy.kHz, "omega is in kHz, which may be turns or radians"),
        ([1.0 * PINT.radian / PINT.second, 2.0, 3.0], r"omega\[1\] has no unit, and others beside it have one"),
        (omega * astropy.ct / astropy.s, "omega has the unit ct / s, which is no product of kg, m, s, A and rad"),
        (omega * PINT.delta_degC / PINT.second, "omega has the unit"),
        (np.array([1.0, np.nan, 3.0]) * astropy.rad / astropy.s, r"omega\[1\] = nan must be finite"),
        (omega[:2] * astropy.rad / astropy.s, r"omega must have the shape \(3,\), not \(2,\)"),
    ):
        with pytest.raises((polhode.PolhodeError, TypeError), match=says):
            polhode.FreeMotion(moments=[1, 2, 2.5], omega=wrong)
    # In SI a radian is 1: so 1/s is an angular velocity, as L/I has it.
    same = [polhode.FreeMotion(moments=[1, 2, 2.5], omega=given) for given in (omega, omega / PINT.second, omega / astropy.s)]
    assert same[0] == same[1] == same[2]
    with pytest.raises(polhode.PolhodeError, match="attitude is an angle, where a plain number belongs"):
        polhode.FreeMotion(moments=[1, 2, 2.5], omega=omega, attitude=[1, 0, 0, 0] * PINT.degree)
    assert NUMBER is dimension_of("attitude")
    # Quantities in a list, and one within another.
    mixed = [1.0 * PINT.kilogram * PINT.meter**2, 2e7 * PINT.gram * PINT.centimeter**2, 2.5 * astropy.kg * astropy.m**2]
    assert np.allclose(polhode.FreeMotion(moments=mixed, omega=omega).moments, [1.0, 2.0, 2.5], rtol=1e-14)
    places = [[0.0 * PINT.meter] * 3, list(np.array([1.0, 2.0, 3.0]) * PINT.millimeter)]
    assert polhode.particles(masses=[1.0, 1.0], positions=places).center_of_mass[2] == 1.5e-3


def test_neither_is_imported() -> None:
    said = "import sys, numpy, polhode; polhode.FreeMotion(moments=[1, 2, 3], omega=[numpy.float32(1), 2, 3]); assert not {'pint', 'astropy'} & {*sys.modules}"
    subprocess.run([sys.executable, "-c", said], check=True)


def test_the_table_has_units_of_si() -> None:
    """Each unit is what its powers say, by Astropy."""
    for dimension in {*DIMENSIONS.values()}:
        kg, m, s = dimension.powers
        text = dimension.unit.replace("·", " ").replace("²", "2").replace("³", "3")
        given = astropy.dimensionless_unscaled if dimension is NUMBER else astropy.Unit(text)
        bases = astropy.kg**kg * astropy.m**m * astropy.s**s
        assert (given / bases).decompose(bases=[astropy.kg, astropy.m, astropy.s, astropy.rad]).scale == 1.0, dimension
        assert (given / bases).is_equivalent(astropy.rad) or (given / bases).is_equivalent(astropy.dimensionless_unscaled), dimension
    assert len({*itertools.chain(DIMENSIONS.values())}) > 12
