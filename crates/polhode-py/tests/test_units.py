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
from astropy.table import Table
from astropy.utils.masked import Masked
from conftest import ROOT
from polhode import plot, scenario, shapes
from polhode._units import DIMENSIONS, NUMBER, Dimension, dimension_of
from test_arguments import TRIANGLES, VERTICES, functions

PINT = pint.UnitRegistry()

#: What is no quantity of one kind: names, files, tables, switches, counts, functions; and covariances, whose elements are of several.
NEITHER = set(
    """a allow_unphysical arguments ax axes_names b basis bias body center changes check clock close_within columns configuration contact convention decimal derivatives drag draws edge ends
    engine error events field findings flight flights folder formalism format geometry gimbals hull infill isotopes joint joints kind knobs link map material mass_history member members mesh method molecule
    motion name nearest numbers of_number omega_axes on only orbit out output parameters parts path pendulum plan pointings prescribed products progress quaternion
    resume roots rows run scale scenario scenarios seed sense shaft skew start stop subtree symbols tests threads title torques triangles union wheels workers wrench
    wrench_covariance force format questions replicates samples sampling trajectories vary""".split()
)

#: Of these a reader of texts knows what kind of quantity each place takes.
TEXTS = {"pivot", "joints", "center", "numbers", "tests"}


def public() -> Iterator[Callable[..., object]]:
    """What users call: functions, classes that they make, and the methods of all."""
    made = (polhode.MassProperties, polhode.Body, polhode.FreeMotion, polhode.Ensemble, polhode.Scenario, polhode.Flight, polhode.batch.Plan)
    for module in (polhode, polhode.results, shapes, plot, polhode.batch, polhode.sweep):
        own = [name for name, value in vars(module).items() if not name.startswith("_") and getattr(value, "__module__", "") == module.__name__]
        names = getattr(module, "__all__", own)
        for value in (getattr(module, name) for name in names):
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


def more() -> Iterator[tuple[Callable[..., Any], dict[str, Any], Callable[[Any], Any]]]:
    """Functions that the tests of arguments do not call, with arguments that are right, and what numbers they give."""
    day = 86_400.0
    yield polhode.spins_from_periods, {"moments": [3.0836, 3.235, 1.0], "periods": [7.4 * day, 5.38 * day], "convention": "long"}, lambda found: found[0].omega
    body = "[[body.part]]\nshape = 'tensor'\nmass = 1\nmoments = [1, 2, 2.5]\n"
    given = {"times": [0.0, 1.0], "masses": [0.5], "positions": [[0.1, 0.0, 0.2]]}
    yield polhode.required_torque, {"scenario": f"{body}[prescribed]\naxis = [0, 3, 4]\nrate = 2\n", **given}, lambda found: found.forces
    thrown = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, -1.2, 0.4])
    times = np.linspace(0.0, 4.0, 201)
    omega, attitude = thrown.at(times)
    log = {"times": times, "gyro": omega, "slowest": 0.5, "shortest": 0.3}
    yield polhode.find_flights, log, lambda found: np.concatenate([np.ravel(flight.gyro) for flight in found])
    yield (
        polhode.judge,
        {"scenario": f"{body}[start]\nspin = {{ body = [0.3, -1.2, 0.4] }}\n", "times": times, "attitude": attitude, "omega": omega, "time_origin": 0.0, "step": 0.02},
        lambda found: found.attitude_error,
    )
    free = {"moments": [1, 2, 2.5], "start_omega": [0.3, -1.2, 0.4], "times": times, "attitude": attitude}
    yield polhode.judge, free, lambda found: found.attitude_error
    down = np.repeat([[0, 0, -1], [0, -1, 0], [-1, 0, 0], [0.6, 0.8, 0]], 8, axis=0) * 9.81
    noise = np.random.default_rng(2)
    motion = {name: 0.01 * noise.normal(size=(32, 3)) for name in ("omega", "alpha", "acceleration")}
    wrenches = {"force": 1.7 * down + 0.01 * noise.normal(size=(32, 3)), "torque": np.cross([0, 0, 0.1], 1.7 * down)}
    noises = {"force_noise": 0.01, "torque_noise": 0.001, "omega_noise": 1e-4, "alpha_noise": 1e-4, "acceleration_noise": 1e-4}
    carried = {"times": np.arange(32) * 0.1, **motion, "gravity": down, **wrenches, "wrench": "on_sensor", **noises}
    yield polhode.identify_payload, carried, lambda found: found.estimate.values[:4]
    flight = polhode.Flight(times=times, gyro=omega + 0.02 * noise.normal(size=omega.shape), attitude_times=times, attitude=attitude)
    yield (
        polhode.identify_tumbles,
        {"flights": flight, "gyro_noise": 0.02, "attitude_noise": 1e-3, "outlier": 6.0},
        lambda found: found.estimate.values[:5],
    )
    for function, name in ((shapes.box, "density"), (shapes.disk, "area_density"), (shapes.rod, "line_density")):
        lengths = {"size": [1.0, 2.0, 3.0]} if function is shapes.box else {"length": 2.0} if function is shapes.rod else {"radius": 2.0}
        yield function, {**lengths, name: 1.7}, numbers_of
    for function in (f for f in vars(shapes).values() if inspect.isfunction(f) and f.__module__ == shapes.__name__ and not f.__name__.startswith("_")):
        named = {"size": [1.0, 2.0] if function is shapes.plate else [1.0, 2.0, 3.0], "semi_axes": [1.0, 2.0, 3.0], "vertices": VERTICES}
        if function in (shapes.triangular_plate, shapes.triangular_prism):
            named["vertices"] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
        known = inspect.signature(function).parameters
        lengths = {name: named.get(name, 0.2 if name in ("tube_radius", "top_radius", "inner_radius") else 1.0) for name in known if name in LENGTHS}
        yield function, {**lengths, "mass": 1.3}, numbers_of


#: Arguments of shapes.
LENGTHS = {"size", "radius", "inner_radius", "length", "base_radius", "top_radius", "height", "semi_axes", "ring_radius", "tube_radius", "vertices"}

#: Arguments that other tests here give: of meshes and flights, of grids and tables of files, which come the same way as those beside them, and of JAX's functions.
ELSEWHERE = {"source", "shell", "walls", "top_layers", "bottom_layers", "weld", "fill", "added", "a wheel's momentum", "a wheel's axis", "the torque of a function", "attitude_times", "unit", "mass_unit"}
ELSEWHERE |= {"spacing", "origin", "per_value", "axes", "centers_of_mass", "inertias", "worker_timeout"}


def numbers_of(found: Any) -> np.ndarray:
    """All numbers of a result."""
    if isinstance(found, polhode.MassProperties):
        return np.array([found.mass, *found.center_of_mass, *found.inertia.ravel()])
    if isinstance(found, polhode.FreeMotion):
        return np.concatenate([found.moments, found.momentum, found.at(0.7).attitude])
    if isinstance(found, polhode.Ensemble):
        return np.concatenate([part.ravel() for part in found.at([0.0, 0.7])])
    if isinstance(found, polhode.results.Motion):
        return np.concatenate([found.times, found.omega.ravel()])
    if isinstance(found, tuple):
        return np.concatenate([numbers_of(part) if isinstance(part, tuple) else np.ravel(part) for part in found if part is not None])
    if isinstance(found, polhode.results.EnsembleStates):
        return np.concatenate([part.ravel() for part in found])
    if isinstance(found, polhode.results.MotionError):
        return np.concatenate([np.ravel(part) for part in found])
    return np.array([]) if isinstance(found, (str, type(None))) else np.ravel(found) if isinstance(found, (np.ndarray, float)) else np.array([])


@pytest.mark.filterwarnings("ignore::polhode.PolhodeWarning")
def test_arguments_take_quantities_of_their_own_kind_alone() -> None:
    """Of all functions that the tests of arguments call, and of those that they do not."""
    seen, compared = set(), 0
    tried = [(function, right, numbers_of) for function, right in functions().items() if function is not polhode.sweep.run]
    for function, right, numbers in [*tried, *more()]:
        expected = numbers(function(**right))
        for name, value in right.items():
            dimension = dimension_of(name)
            if dimension is None or value is None or name in ("unit", "source") or isinstance(value, polhode.MassProperties):
                continue
            if function is polhode.find_flights and name == "torque":
                continue
            what = f"{function.__qualname__}({name})"
            for given in quantities(value, dimension):
                found = numbers(function(**right | {name: given}))
                assert found.shape == expected.shape, what
                if found.size:
                    compared += 1
                    assert np.allclose(found, expected, rtol=1e-9, atol=1e-11), what
            for wrong in quantities(value, NONE_OF_THEM):
                with pytest.raises(polhode.PolhodeError, match=rf"^{name}(\[\d\])? is in .* where {dimension.words} belongs") as error:
                    function(**right | {name: wrong})
                    pytest.fail(f"{what} takes it")
                assert dimension.unit in str(error.value)
            seen.add(name)
    assert compared > 150 and {*DIMENSIONS} - seen == ELSEWHERE


@pytest.mark.filterwarnings("ignore::polhode.PolhodeWarning")
def test_arguments_take_text_with_a_unit() -> None:
    """Of all functions that the tests of arguments call: the same number, to the bit where the unit is a power of ten."""
    compared = 0
    tried = [(function, right, numbers_of) for function, right in functions().items() if function is not polhode.sweep.run]
    for function, right, numbers in [*tried, *more()]:
        expected = numbers(function(**right))
        for name, value in right.items():
            dimension = dimension_of(name)
            if dimension in (None, NUMBER) or value is None or name in ("unit", "source") or isinstance(value, polhode.MassProperties):
                continue
            if function is polhode.find_flights and name == "torque":
                continue
            unit = dimension.unit.replace("·", " ")
            text = np.vectorize(lambda number: f"{float(number)!r} {unit}", otypes=[object])(np.asarray(value, float)).tolist()
            found = numbers(function(**right | {name: text}))
            compared += found.size > 0
            assert np.array_equal(found, expected, equal_nan=True), f"{function.__qualname__}({name})"
            wrong = np.vectorize(lambda number: f"{float(number)!r} kg^2 m", otypes=[object])(np.asarray(value, float)).tolist()
            with pytest.raises(polhode.PolhodeError, match=rf"^{name}(\[\d+\])* = '.* kg\^2 m': \"kg\^2 m\" is .* where {dimension.words} belongs"):
                function(**right | {name: wrong})
                pytest.fail(f"{function.__qualname__}({name}) takes it")
    assert compared > 100


def test_text_without_a_unit_is_refused(generic: polhode.MassProperties) -> None:
    body = shapes.sphere(radius="2 cm", mass="500 g")
    assert body == shapes.sphere(radius=0.02, mass=0.5)
    placed = body.placed(position=[0, "-25.4 mm", "1 in"])
    assert placed.center_of_mass.tolist() == [0.0, -0.0254, 0.0254]
    for given, error, says in (
        (lambda: shapes.sphere(radius="2", mass=1.0), TypeError, "radius must be a real number, not text without a unit, such as m"),
        (lambda: shapes.sphere(radius="wide", mass=1.0), TypeError, "radius must be a real number, not text without a unit, such as m"),
        (lambda: shapes.sphere(radius="2 cmm", mass=1.0), polhode.PolhodeError, "radius = '2 cmm': unknown unit \"cmm\"\nhint: did you mean cm?"),
        (lambda: shapes.sphere(radius="-2 cm", mass=1.0), polhode.PolhodeError, "-0.02"),
        (lambda: generic.placed(position=["1 cm", 2.0, 0]), polhode.PolhodeError, r"position\[1\] has no unit, but other elements have one"),
        (lambda: generic.placed(position=["1 cm", "2", 0]), TypeError, "position must be real numbers, not text"),
        (lambda: generic.placed(position=["1 cm", False, 0]), TypeError, r"position\[1\] = False must be a number, not a truth value"),
        (lambda: generic.inertia_along(["1 rad", 0, 0, 0]), TypeError, "rotation must be real numbers, not text"),
        (lambda: polhode.find_flights(times=[0.0, 1.0], gyro=np.eye(2, 3), torque="0.1 N m"), polhode.PolhodeError, "torque must be a plain number, but has a unit"),
    ):
        with pytest.raises(error, match=says):
            given()


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
        with pytest.raises(polhode.PolhodeError, match="the vertices already have a unit"):
            polhode.inertia(source, density=1.0, unit="mm")
    for unit in ("mm", 1.0 * PINT.millimeter, 1e-3 * astropy.m):
        assert np.allclose(numbers_of(polhode.inertia((VERTICES, TRIANGLES), unit=unit, density=2700.0)), numbers_of(plain), rtol=1e-13, atol=0)
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
    pushed = given.replace(torques=[scenario.FunctionTorque(function=lambda t: np.array([0.0, 0.1, 0.0]) * PINT.newton * PINT.meter)])
    plain = given.replace(torques=[scenario.FunctionTorque(function=lambda t: [0.0, 0.1, 0.0])])
    assert np.array_equal(polhode.simulate(pushed, times=[0.0, 1.0]).omega, polhode.simulate(plain, times=[0.0, 1.0]).omega)
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
        with pytest.raises(polhode.PolhodeError, match="torque must be a plain number, but has a unit"):
            polhode.find_flights(times=times, gyro=gyro, torque=0.1 * (kg * m**2 / second**2))
    derived = polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 0.5]).derivatives(1.0)
    with pytest.raises(polhode.PolhodeError, match="inertia must be a plain number, but has a unit"):
        derived.covariance(inertia=np.eye(6) * PINT.kilogram * PINT.meter**2)


def test_what_has_no_one_meaning_is_refused() -> None:
    omega = np.array([1.0, 2.0, 3.0])
    for wrong, says in (
        (omega * PINT.hertz, "omega is in hertz, which can mean turns or radians"),
        (omega * astropy.kHz, "omega is in kHz, which can mean turns or radians"),
        ([1.0 * PINT.radian / PINT.second, 2.0, 3.0], r"omega\[1\] has no unit, but other elements have one"),
        (omega * astropy.ct / astropy.s, "omega has the unit ct / s, which is not a product of kg, m, s, A and rad"),
        (omega * PINT.delta_degC / PINT.second, "omega has the unit"),
        (np.array([1.0, np.nan, 3.0]) * astropy.rad / astropy.s, r"omega\[1\] = nan must be finite"),
        (Masked(omega * astropy.rad / astropy.s, mask=[False, True, False]), "omega has masked elements"),
        (PINT.Quantity(np.ma.masked_equal(omega, 2.0), "rad/s"), "omega has masked elements"),
        (omega * 1j * astropy.rad / astropy.s, "omega must be real numbers, not complex numbers"),
        (np.array([True, False, True]) * astropy.rad / astropy.s, "omega must be real numbers, not truth values"),
        (astropy.Quantity([1, 2, 2**53 + 1], "rad/s", dtype=int), r"omega\[2\] = 9007199254740993 must be a float64 exactly"),
        ([PINT.meter] * 3, "omega must be real numbers, not Unit"),
        (omega[:2] * astropy.rad / astropy.s, r"omega must have the shape \(3,\), not \(2,\)"),
    ):
        with pytest.raises((polhode.PolhodeError, TypeError), match=says):
            polhode.FreeMotion(moments=[1, 2, 2.5], omega=wrong)
    # The factor is float64's, whatever the numbers were; a column has a unit or none.
    table = Table({"rate": omega})
    assert np.array_equal(polhode.FreeMotion(moments=[1, 2, 2.5], omega=table["rate"]).at(0.0).omega, omega)
    table["rate"].unit = "deg/s"
    exact = polhode.FreeMotion(moments=[1, 2, 2.5], omega=np.deg2rad(omega))
    for few in (table["rate"], np.float32(omega) * astropy.deg / astropy.s, PINT.Quantity(np.float32(omega), "deg/s")):
        assert np.allclose(polhode.FreeMotion(moments=[1, 2, 2.5], omega=few).momentum, exact.momentum, rtol=1e-15, atol=0)
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
