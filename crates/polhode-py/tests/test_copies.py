"""Copies of every public class, here and in another process: all that they say is the same, bit for bit."""

from __future__ import annotations

import copy
import functools
import inspect
import multiprocessing
import pickle
import struct
import warnings
from collections.abc import Callable, ItemsView, KeysView, ValuesView
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import polhode.batch
import polhode.sweep
import pytest
from conftest import PLAN, ROOT
from polhode import scenario, shapes
from polhode._deprecated import Former
from test_derivatives import PUSHED

TURN = [0.4, -0.7, 1.1, 0.3]
EXAMPLES = ROOT / "examples"

#: Tables of other libraries, of what ``columns`` says.
TABLES = ("to_arrow", "to_pandas", "to_polars", "to_xarray")

#: What methods that need arguments are asked; ``export`` has all its formats.
ASKED: dict[str, list[dict[str, Any]]] = {
    "inertia_about": [{"point": [-1.0, 0.4, 0.7]}],
    "inertia_along": [{"rotation": TURN}],
    "placed": [{"position": [0.3, -0.2, 1.7], "rotation": TURN}],
    "export": [
        {"format": f}
        for f in (
            *("urdf", "sdf", "mjcf", "mjcf-principal", "usd"),
            *("jsbsim", "rocketpy", "basilisk", "solidworks", "csv"),
        )
    ],
    "at": [{"times": [0.25, 1.5, 40.0]}],
    "error": [{"times": [0.25, 1.5, 40.0]}],
    "rotations": [{}, {"times": [0.25, 1.5]}, {"member": 1}],
    "page": [{}],
    "event_times": [{"name": "slow"}],
    "gradient": [{"of_number": np.linspace(-1.0, 1.5, 10)}],
}


def failed_states() -> polhode.results.EnsembleStates:
    """Two of three members run away."""
    torque = '[[torque]]\nmodel = "formula"\naxes = "body"\ntorque = ["0", "0", "0.1[kg m^2 s]*wz^3"]\n'
    ensemble = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=[[0.1, 0.2, 0.3], [1e3, 2e3, -1e3], [1, 2, -3]], torques=torque)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ensemble.at([0.0, 0.5, 2.0])


def report(tmp_path: Path) -> polhode.results.CheckReport:
    path = tmp_path / "arm.urdf"
    path.write_text(
        '''<robot name="arm"><link name="hand"><inertial><mass value="2"/>
        <inertia ixx="0.1" iyy="0.1" izz="0.9" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'''
    )
    return polhode.check(path)


def bodies(tmp_path: Path) -> list[polhode.MassProperties]:
    """Of every source: each knows something that the others do not."""
    rng = np.random.default_rng(3)
    np.save(tmp_path / "grid.npy", rng.uniform(0.5, 2.0, (3, 4, 5)))
    table = np.column_stack([rng.uniform(0.1, 2.0, 5), rng.normal(size=(5, 3))])
    np.savetxt(tmp_path / "points.csv", table, delimiter=",", header="mass_kg,x_m,y_m,z_m", comments="")
    vertices = np.array([[0.1, -0.2, 0.3], [1.4, 0.2, -0.1], [0.3, 1.7, 0.2], [-0.2, 0.4, 1.9]])
    inward = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
    robot = sorted((EXAMPLES / "robots").rglob("*.urdf"))[0]
    tensor = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]
    numbers = polhode.MassProperties(mass=2.3, center_of_mass=[0.11, -0.07, 0.23], inertia=tensor)
    with pytest.warns(polhode.PolhodeWarning):
        mesh = polhode.inertia((vertices, inward), material="aluminium")
    assert mesh.findings and mesh.volume and mesh.surface_area and mesh.density
    molecule = polhode.inertia(EXAMPLES / "water.xyz")
    assert molecule.to_dict()["molecule"]
    box = shapes.box(size=[0.2, 0.1, 0.06], material="steel")
    return [
        numbers,
        mesh,
        molecule,
        molecule.placed(position=[1e-10, 2e-10, -3e-10], rotation=TURN),
        box,
        numbers + box.placed(position=[0.5, -0.25, 1.5], rotation=TURN),
        mesh + box,
        polhode.inertia(EXAMPLES / "bracket.stl", unit="mm", mass=0.4),
        polhode.inertia(EXAMPLES / "bracket.toml"),
        polhode.inertia(EXAMPLES / "heavy-top.toml"),
        polhode.inertia(tmp_path / "grid.npy", spacing=[0.1, 0.2, 0.3]),
        polhode.inertia(tmp_path / "points.csv"),
        polhode.inertia(robot),
        polhode.particles(masses=[0.3, 1.1, 2.0], positions=[[0.1, -0.4, 0.2], [0.7, 0.1, -0.3], [-0.2, 0.5, 0.9]]),
        # The smallest numbers there are, and zeros with a sign.
        polhode.MassProperties(mass=5e-324, center_of_mass=[-0.0, 0.1, 5e-324], inertia=[0.3, 0.4, 0.5]),
    ]


def motions() -> list[polhode.results.Motion]:
    """Closed forms, steps, events, a motion that is given, a mesh, what cannot go on."""
    names = ["t-handle", "heavy-top", "events", "gravity-gradient", "prescribed-table", "shaft", "torsion-pendulum", "bracket"]
    return [polhode.simulate(EXAMPLES / f"{name}.toml") for name in names]


def judgement(with_omega: bool) -> polhode.results.Judgement:
    """Of a program that is late."""
    body = '[[body.part]]\nshape = "tensor"\nmass = "3 kg"\nmoments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]\n'
    scenario = body + f"[start]\nattitude = {{ quaternion = {TURN} }}\nspin = {{ body = [0.3, -0.5, 0.9] }}\n"
    times = 0.02 * np.arange(151)
    motion = polhode.simulate(scenario, times=times)
    omega = motion.omega_space[:-1] if with_omega else None
    return polhode.judge(scenario, times=times[1:], attitude=motion.attitude[:-1], omega=omega, time_origin=0.0)


def plate() -> polhode.results.PayloadResult:
    """A plate at a wrist, which noise makes impossible without the constraint, and a wrench that is far off."""
    rng = np.random.default_rng(0)
    omega, alpha, acceleration = (size * rng.normal(size=(80, 3)) for size in (2.0, 6.0, 3.0))
    gravity = rng.normal(size=(80, 3))
    gravity *= 9.81 / np.linalg.norm(gravity, axis=1, keepdims=True)
    mass, center, inertia = 1.3, np.array([0.05, -0.02, 0.11]), np.diag([0.004, 0.006, 0.010])
    about = inertia + mass * (center @ center * np.eye(3) - np.outer(center, center))
    free = acceleration - gravity
    force = mass * (free + np.cross(alpha, center) + np.cross(omega, np.cross(omega, center)))
    torque = mass * np.cross(center, free) + alpha @ about + np.cross(omega, omega @ about)
    force[17] += 5.0
    with pytest.warns(polhode.PolhodeWarning, match="discarded"):
        return polhode.identify_payload(
            times=0.1 * np.arange(80),
            omega=omega,
            alpha=alpha,
            acceleration=acceleration,
            gravity=gravity,
            force=force + 0.1 * rng.normal(size=(80, 3)),
            torque=torque + 0.02 * rng.normal(size=(80, 3)),
            wrench="on_payload",
            force_noise=0.1,
            torque_noise=0.02,
        )


def asked() -> list[object]:
    """Answers about scenarios."""
    wheel, orbit, stone = (polhode.stability(EXAMPLES / f"{name}.toml") for name in ("gyrostat", "gravity-gradient", "rattleback"))
    assert orbit.equilibrium is not None
    tumbling = polhode.spins_from_periods(inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]], periods=[2.1, 9.3], convention="short")
    return [
        polhode.Scenario.from_toml(EXAMPLES / "heavy-top.toml"),
        polhode.Knob(low=0.1, high=2.5, label="spin"),
        polhode.explain(EXAMPLES / "t-handle.toml"),
        polhode.required_torque(EXAMPLES / "shaft.toml"),
        wheel,
        wheel.motions[0],
        wheel.rotations[0],
        orbit,
        orbit.equilibrium,
        orbit.equilibrium.modes[0],
        stone.ground,
        tumbling,
        tumbling[0],
    ]


def everything(tmp_path: Path) -> list[object]:
    """Objects of every public class, filled as generically as can be."""
    made = bodies(tmp_path)
    moved = motions()
    plan = polhode.batch.Plan(PLAN.format(members=40))
    states = failed_states()
    checked = report(tmp_path)
    compared = polhode.compare(EXAMPLES / "robots" / "arm.urdf", EXAMPLES / "robots" / "gripper.urdf")
    assert compared.differences and compared.notes
    omega = np.random.default_rng(5).normal(size=(4, 3))
    attitude = np.random.default_rng(6).normal(size=(4, 4))
    free = polhode.FreeMotion(inertia=made[0], omega=[0.3, -0.5, 0.9], attitude=TURN)
    shared = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega, torques='[[torque]]\nmodel = "constant"\ntorque = ["0.1 N m", "0 N m", "0.2 N m"]\naxes = "body"\n')
    own = polhode.Ensemble(inertia=np.stack([made[0].inertia, made[5].inertia, made[6].inertia, made[0].inertia]), omega=omega, attitude=attitude)
    events = [scenario.Event(name="slow", measure="omega", value=1.0, then="stop"), scenario.Event(measure="nutation", value=1.1)]
    watched = polhode.Ensemble(made[0], omega=omega, attitude=attitude, wheels=[scenario.Wheel(axis=[1, 2, 3], momentum=0.1)], events=events)
    links = polhode.link_table(EXAMPLES / "robots" / "arm.urdf", joints={"elbow": 0.3})
    written = polhode.write_inertials(EXAMPLES / "robots" / "arm.urdf", material="oak")
    error = polhode.PolhodeError("radius is wrong", "repair it", "a.toml", 3, 7)
    judged = [judgement(with_omega) for with_omega in (True, False)]
    with pytest.warns(polhode.PolhodeWarning) as heard:
        polhode.inertia(EXAMPLES / "bracket.stl", unit="mm")
    tumbled, swung = (polhode.identify(EXAMPLES / "identify" / f"{name}.toml") for name in ("racket-like", "bifilar"))
    carried = plate()
    assert isinstance(tumbled, polhode.results.TumbleResult) and isinstance(swung, polhode.results.SwingResult) and carried.edge is not None
    derived = polhode.simulate(PUSHED, derivatives=["torque[0].factor"])
    assert derived.derivatives is not None and derived.derivatives.events
    joined = polhode.Body({"main": made[0], "mesh": made[1], "water": made[2]})
    corner = [[0.1, -0.2, 0.3], [1.4, 0.2, -0.1], [0.3, 1.7, 0.2], [-0.2, 0.4, 1.9]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    columns = {"name": ["a", "b", "c"], "mass [kg]": [1.5, 2.0, 0.7], "mass sd [kg]": [0.1, 0.2, 0.0], "x [m]": [0.1, -0.2, 0.0], "y [m]": [0.2, 0.0, 0.3], "z [m]": [-0.3, 0.1, 0.0]}
    listed = polhode.budget(columns, plan={"limit": [{"of": "mass", "most": "5 kg"}]}, draws=50)
    return [
        *made,
        compared,
        compared[0],
        *moved,
        joined,
        joined.derivatives(about={"mesh": [0.1, 0.2, 0.3]}),
        polhode.particle_derivatives(masses=[0.3, 1.1, 2.0], positions=[[0.1, -0.4, 0.2], [0.7, 0.1, -0.3], [-0.2, 0.5, 0.9]]),
        polhode.mesh_derivatives(corner, material="aluminium"),
        polhode.nearest_possible([[0.7, 0.1, -0.2], [0.1, 1.1, 0.05], [-0.2, 0.05, 2.6]]),
        polhode.nearest_possible([0.7, 1.1, 2.6]).frobenius,
        free,
        polhode.FreeMotion(moments=[1, 2, 9], omega=[0.3, -0.5, 0.9], allow_unphysical=True),
        free.at([0.0, 2.5, -7.0]),
        shared,
        own,
        states,
        watched,
        watched.at([0.0, 2.5, 4.0]),
        polhode.results.Failure(3, 1.25, "too large for a double"),
        polhode.results.Stop(3, "lower", 1.25),
        checked,
        *checked.findings[:2],
        links,
        links.rows[3],
        links.rows[-1],
        written,
        written.links[0],
        written.links[-1],
        *(motion.events[0] for motion in moved if motion.events),
        *(motion.ending for motion in moved),
        *(motion.error for motion in moved if motion.error),
        free.error([0.5, -1e6, 3.0]),
        *made[1].findings,
        *judged,
        judged[0].reading,
        judged[0].reading.tried[1],
        judged[0].growth,
        judged[0].split,
        judged[0].split.parts[1],
        judged[0].likeliest,
        derived,
        derived.derivatives,
        derived.derivatives.events[0],
        free.derivatives(2.5),
        tumbled,
        tumbled.estimate,
        tumbled.estimate["gyro bias y"],
        tumbled.principal,
        tumbled.tests[0],
        tumbled.flights[1],
        swung,
        swung.swings[2],
        carried,
        carried.edge,
        carried.edge.thin[0],
        carried.unconstrained,
        carried.left_out[0],
        listed,
        listed.only,
        listed.only.limits[0],
        listed.only.rows[1],
        listed.only.errors["mass"][0],
        polhode.Flight(times=[0, 0.1, 0.3], gyro=omega[:3], attitude=attitude[:3], added=[1e-3, 2e-3, 2.5e-3], wheels=[([0, 0, 1], 0.2)]),
        polhode.results.Flights([polhode.Flight(times=[0, 0.1, 0.3], gyro=omega[:3])]),
        polhode.batch.Vary(key="start.omega[0]", relative=0.1),
        *asked(),
        error,
        heard[0].message,
        plan,
        *plan.variables,
        polhode.sweep.run(plan, tmp_path / "sweep"),
    ]


@functools.cache
def public_classes() -> set[type]:
    """All that a user can have an object of."""
    found = set()
    for module in (polhode, polhode.results, polhode.batch, polhode.sweep, shapes, polhode.plot):
        for name, value in inspect.getmembers(module, inspect.isclass):
            if not name.startswith("_") and value.__module__ in ("polhode", "polhode.results", "polhode.batch", "polhode.sweep"):
                found.add(value)
    return found


def plain(value: Any) -> Any:
    """A value of an attribute as something that equals only what has its bits."""
    if isinstance(value, np.ndarray):
        return ("array", value.dtype.str, value.shape, value.flags.writeable, value.tobytes())
    if isinstance(value, (float, np.floating)):
        return ("float", struct.pack("<d", value))
    if isinstance(value, dict):
        return ("dict", [(plain(k), plain(v)) for k, v in value.items()])
    if isinstance(value, (list, tuple)):
        return (type(value).__name__, [plain(v) for v in value])
    if hasattr(value, "as_quat"):
        return ("rotation", plain(value.as_quat()))
    if value is None or isinstance(value, (str, bytes, int, bool)):
        return value
    if type(value) in public_classes():
        return (type(value).__name__, said(value, deep=False))
    if isinstance(value, polhode.scenario.Section):
        return (type(value).__name__, plain(value.to_dict()))
    if isinstance(value, (KeysView, ValuesView, ItemsView)):
        return plain(list(value))
    raise AssertionError(f"{type(value)} is not compared")


def said(thing: object, deep: bool = True) -> dict[str, Any]:
    """All that an object says: every public attribute, every method, its text, its length, its elements."""
    found: dict[str, Any] = {"": type(thing).__qualname__}
    for name in dir(thing):
        here = inspect.getattr_static(thing, name)
        if name.startswith("_") or name == "with_traceback" or isinstance(here, Former) or "Former name" in (inspect.getdoc(here) or ""):
            continue
        value = getattr(thing, name)
        if not callable(value):
            found[name] = plain(value)
        elif deep and name not in ("add_note", "count", "index", *TABLES):
            for given in ASKED.get(name, [{}]):
                try:
                    needed = inspect.signature(value).bind(**given)
                except TypeError:
                    continue
                try:
                    found[f"{name}({given})"] = plain(value(*needed.args, **needed.kwargs))
                except polhode.PolhodeError as refused:  # a format that cannot hold a molecule's moments
                    found[f"{name}({given})"] = str(refused)
    if deep:
        found |= {"str": str(thing), "repr": repr(thing)}
        found |= {"len": len(thing)} if hasattr(thing, "__len__") else {}
        found |= {"list": plain(list(thing))} if hasattr(thing, "__iter__") else {}
        found |= {"html": thing._repr_html_()} if hasattr(thing, "_repr_html_") else {}
    return found


TRANSPORTS: dict[str, Callable[[Any], Any]] = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    **{f"pickle {p}": lambda it, p=p: pickle.loads(pickle.dumps(it, protocol=p)) for p in range(pickle.HIGHEST_PROTOCOL + 1)},
}


def test_copies_say_all_that_the_original_says(tmp_path: Path) -> None:
    things = everything(tmp_path)
    assert {type(thing) for thing in things} == public_classes()
    for thing in things:
        before = said(thing)
        assert any(len(name) > 3 for name in before)
        for transport, function in TRANSPORTS.items():
            after = said(function(thing))
            for name in before.keys() | after.keys():
                assert before.get(name) == after.get(name), f"{type(thing).__name__}.{name} by {transport}"


def test_copies_in_another_process_say_the_same(tmp_path: Path) -> None:
    things = everything(tmp_path)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        there = pool.map(both, things)
    for thing, (again, heard) in zip(things, there, strict=True):
        # What the other process read off it, and what came back.
        assert said(thing) == heard == said(again), type(thing).__name__


def both(thing: object) -> tuple[object, dict[str, Any]]:
    return thing, said(thing)


def test_a_motion_needs_no_file_where_it_arrives(tmp_path: Path) -> None:
    mesh = (EXAMPLES / "bracket.stl").read_bytes()
    (tmp_path / "part.stl").write_bytes(mesh)
    path = tmp_path / "scenario.toml"
    path.write_text(
        '[[body.part]]\nshape = "mesh"\nfile = "part.stl"\nunit = "mm"\nmass = "0.4 kg"\n'
        '[start]\nspin = { body = [0.1, 2, -0.3] }\n[run]\nduration = "3 s"\nsamples = 4\n'
    )
    motion = polhode.simulate(path)
    wanted = said(motion)
    sent = pickle.dumps(motion)
    path.unlink()
    (tmp_path / "part.stl").unlink()
    assert said(pickle.loads(sent)) == wanted


def test_what_a_subclass_adds_is_kept() -> None:
    body = Named(mass=2.3, inertia=[3.1, 4.2, 5.3])
    body.name = "trunk"
    for function in TRANSPORTS.values():
        again = function(body)
        assert type(again) is Named and again.name == "trunk" and again.mass == 2.3
    plan = NamedPlan(PLAN.format(members=7))
    plan.name = "spring"
    for function in TRANSPORTS.values():
        sent = function(plan)
        assert type(sent) is NamedPlan and sent.name == "spring" and sent.members == 7
        sent.name = "autumn"
    assert plan.name == "spring"


class Named(polhode.MassProperties):
    """A body with a name."""

    name: str


class NamedPlan(polhode.batch.Plan):
    """A plan with a name."""

    name: str


def test_a_copy_has_the_numbers_that_were_given(tmp_path: Path) -> None:
    """Not those that the array has by now."""
    omega = np.random.default_rng(8).normal(size=(3, 3))
    ensemble = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega)
    before = ensemble.at([2.5]).omega.copy()
    omega[:] = 99.0
    assert np.array_equal(pickle.loads(pickle.dumps(ensemble)).at([2.5]).omega, before)


def test_what_is_written_into_an_answer_changes_no_other(examples: Path, tmp_path: Path) -> None:
    motion = polhode.simulate(examples / "heavy-top.toml")
    free = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, 0.5, 0.9])
    checked = report(tmp_path)
    before = said(motion), said(free), said(checked)
    for value in [getattr(motion, name) for name in dir(motion) if not name.startswith("_")] + [*motion.columns().values()]:
        if isinstance(value, np.ndarray):
            value[...] = 99.0
        elif isinstance(value, (dict, list)):
            value.clear()
    motion.summary["motion"].clear()
    free.summary["motion"].clear()
    checked.findings[0].numbers.clear()
    checked.to_dict()["findings"].clear()
    assert (said(motion), said(free), said(checked)) == before
