"""Every argument of every public function, given what it cannot be: refused by its name, in its kind, in the words of Python."""

from __future__ import annotations

import contextlib
import decimal
import errno
import fractions
import inspect
import io
import os
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import polhode.batch
import polhode.sweep
import pyarrow as pa
import pytest
from conftest import PLAN, ROOT
from polhode import plot, scenario, shapes
from polhode._error import in_python
from scipy.spatial.transform import Rotation

VERTICES = [[0, 0, 0], [30, 0, 0], [0, 20, 0], [0, 0, 10]]
TRIANGLES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


class Quantity(np.ndarray):
    """An array with a unit of its own."""

    unit = "m"


#: What no argument can be: neither a number, nor an array of any shape, nor a text, a path or a function.
NEVER: list[Any] = [
    b"x",
    10**20,
    -(10**30),
    10**400,
    [10**20] * 3,
    float("nan"),
    float("inf"),
    [[]],
    {1, 2},
    object(),
    (x for x in []),
    np.zeros((3, 0)),
    np.ones((3, 4, 5)),
    np.array([1, 2, 3], object),
    np.array([1, None, 3], object),
    np.ones(3, np.longdouble),
    np.ones(3, complex),
    np.ma.masked_equal([1.0, 2.0, 3.0], 2.0),
    [1.0, np.ma.masked, 2.0],
    [True, 2.0, 3.0],
    [2.0, 1.0, 2**53 + 1],
    [1.0, [2.0]],
    [fractions.Fraction(1, 3)] * 3,
    [decimal.Decimal(1)] * 3,
    [np.array([True]), np.array([1.0])],
    np.array([1.0, 2.0, 3.0]).view(Quantity),
    [np.array(1.0).view(Quantity)] * 3,
    np.zeros(3, "M8[s]"),
    np.zeros(2, [("a", float)]),
    1 + 2j,
    pa.array([1, None]),
    Ellipsis,
]

#: Arguments that take such a thing all the same: folders and torques may come from a generator, and a class is a function.
TAKEN = {("check", "roots"), ("compare", "roots"), ("write_inertials", "roots"), ("Ensemble", "torques"), ("Ensemble", "wheels"), ("Ensemble", "events"), ("Ensemble", "orbit"), ("Ensemble.from_scenarios", "scenarios")}


def functions() -> dict[Callable[..., object], dict[str, Any]]:
    """All public functions, with arguments that are right."""
    body = shapes.sphere(radius=1.0, mass=2.0)
    free = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, 0.5, 0.9])
    motion = polhode.simulate(ROOT / "examples" / "t-handle.toml")
    ensemble = polhode.Ensemble(moments=[1, 2, 2.5], omega=[[0.3, 0.5, 0.9]] * 2)
    plan = polhode.batch.Plan(PLAN.format(members=10))
    rows = polhode.batch.inputs(plan)
    found: dict[Callable[..., object], dict[str, Any]] = {
        polhode.MassProperties: {"mass": 1.0, "inertia": [1.0, 1.0, 1.0], "center_of_mass": [0, 0, 0], "about": [0, 0, 0]},
        polhode.particles: {"masses": [1.0, 2.0], "positions": [[0, 0, 0], [1, 1, 1]]},
        polhode.inertia: {"source": (VERTICES, TRIANGLES), "density": 1.0, "unit": "mm", "hull": False, "shell": None, "kind": None},
        polhode.FreeMotion: {"omega": [1.0, 2, 3], "moments": [1.0, 2, 2.5], "attitude": [1, 0, 0, 0], "allow_unphysical": False},
        polhode.Ensemble: {
            **{"body": body, "omega": [[1.0, 2, 3]] * 2, "pivot": [0.1, 0.3, -0.2], "attitude": [1, 0, 0, 0]},
            **{"torques": [scenario.Gravity()], "wheels": [], "events": [], "orbit": None},
        },
        polhode.Ensemble.from_scenarios: {"scenarios": [polhode.Scenario(body)]},
        polhode.simulate: {"scenario": ROOT / "examples" / "t-handle.toml", "times": [0.0, 1.0], "error": "cheap"},
        polhode.check: {"path": ROOT / "examples" / "robots" / "arm.urdf", "roots": [], "nearest": True},
        polhode.nearest_possible: {"inertia": [1.0, 1.1, 2.9], "about": [0.1, 0.0, 0.2], "mass": 1.0, "center_of_mass": [0, 0, 0]},
        polhode.compare: {"a": ROOT / "examples" / "robots" / "arm.urdf", "b": ROOT / "examples" / "robots" / "arm.xml", "tolerance": 1e-5, "map": None, "roots": []},
        polhode.fixed_groups: {"path": ROOT / "examples" / "robots" / "arm.urdf"},
        polhode.write_inertials: {
            **{"path": ROOT / "examples" / "robots" / "arm.urdf", "density": 900.0, "parts": {"hand": "steel"}, "link": "h*"},
            **{"only": "missing", "geometry": "collision", "roots": []},
        },
        polhode.link_table: {"path": ROOT / "examples" / "robots" / "arm.urdf", "joints": {"elbow": 0.3}},
        polhode.Body: {"parts": {"a": body}},
        body.inertia_about: {"point": [1, 2, 3]},
        body.inertia_along: {"rotation": [1, 0, 0, 0]},
        body.placed: {"position": [0, 0, 0], "rotation": [1, 0, 0, 0]},
        body.export: {"format": "urdf", "name": "x"},
        free.at: {"times": [1.0, 2.0]},
        free.error: {"times": [1.0, 2.0]},
        free.page: {"duration": 3.0},
        ensemble.at: {"times": [0.0, 1.0], "threads": 1, "tolerance": 1e-9},
        motion.extend: {"duration": 1.0, "samples": 3, "error": "cheap"},
        plot.omega: {"motion": free, "times": [0.0, 1.0]},
        plot.attitude: {"motion": free, "times": [0.0, 1.0]},
        plot.momentum: {"motion": motion},
        plot.energy: {"motion": motion},
        plot.polhode: {"motion": free},
        polhode.batch.Plan: {"source": PLAN.format(members=10)},
        polhode.batch.inputs: {"plan": plan, "members": range(3)},
        polhode.batch.simulate: {"rows": rows, "plan": plan, "threads": 1},
        polhode.batch.trajectories: {"rows": rows, "plan": plan, "threads": 1},
        polhode.sweep.run: {"plan": plan, "output": "x", "on": None, "threads": 1, "workers": None, "resume": False, "force": True, "progress": max, "worker_timeout": 3.0},
    }
    values = {"size": [1, 2, 3], "semi_axes": [1, 2, 3], "vertices": VERTICES, "mass": 1.0, "ends": False, "tube_radius": 0.1, "top_radius": 0.1, "inner_radius": 0.1}
    unset = {"density", "material", "area_density", "line_density"}
    for name, function in vars(shapes).items():
        if inspect.isfunction(function) and function.__module__ == "polhode.shapes" and not name.startswith("_"):
            found[function] = {n: None if n in unset else values.get(n, 1.0) for n in inspect.signature(function).parameters}
    found[shapes.plate]["size"] = [1, 2]
    found[shapes.triangular_plate]["vertices"] = found[shapes.triangular_prism]["vertices"] = [[0, 0], [1, 0], [0, 1]]
    return found


def test_every_argument_is_refused_by_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    count = 0
    for function, right in functions().items():
        with contextlib.redirect_stdout(io.StringIO()):
            function(**right)
        for name, wrong in ((name, wrong) for name in right for wrong in NEVER):
            what = f"{function.__qualname__}({name}={wrong!r:.50})"
            if (function.__qualname__, name) in TAKEN and not isinstance(wrong, (str, bytes)):
                continue
            count += 1
            with pytest.raises((polhode.PolhodeError, TypeError)) as error:
                function(**right | {name: wrong})
                pytest.fail(f"{what} is taken")
            known = (name, f"the {name}", *(("vertices", "triangles") if name == "source" else ()))
            assert str(error.value).startswith(known), f"{what}: {error.value}"
            assert not re.search(r"NoneType(?! among)|'.*' object|argument '|-- ?[a-z]", str(error.value)), f"{what}: {error.value}"
    assert count > 2500


@pytest.mark.parametrize(
    ("value", "error", "says"),
    [
        ([1, 2, 10**20], polhode.PolhodeError, r"^omega\[2\] = 100000000000000000000 must be a float64 exactly: give a float, or an integer up to 2"),
        (np.array([1, 2, 3], object), TypeError, r"^omega must be real numbers, not objects \(dtype object\): convert them"),
        ([1.0, True, 3.0], TypeError, r"^omega\[1\] = True must be a number, not a truth value$"),
        ([np.array(1.0).view(Quantity)] * 3, TypeError, r"^omega\[0\] has a unit that is neither .* would be lost"),
        ([[1.0], [2.0, 3.0]], polhode.PolhodeError, r"^omega must have rows of one length"),
        (None, TypeError, "^omega must be real numbers, not NoneType$"),
        ([1, 2, -(10**5000)], polhode.PolhodeError, r"^omega\[2\] = an integer of about 5000 digits must be a float64 exactly"),
    ],
)
def test_messages_say_what_is_there(value: object, error: type[Exception], says: str) -> None:
    with pytest.raises(error, match=says):
        polhode.FreeMotion(moments=[1, 2, 2.5], omega=value)


def test_a_text_is_no_truth_value_and_a_third_element_no_part_of_a_mesh() -> None:
    mesh = (VERTICES, TRIANGLES)
    for call, says in (
        (lambda: polhode.inertia(mesh, density=1.0, hull="no"), "hull must be True or False, not str"),
        (lambda: shapes.cylinder_shell(radius=1.0, length=2.0, ends="no", mass=1.0), "ends must be True or False, not str"),
        (lambda: polhode.FreeMotion(moments=[1, 2, 9], omega=[1, 2, 3], allow_unphysical="no"), "allow_unphysical must be True or False"),
        (lambda: polhode.inertia((*mesh, [[0, 0, 1]] * 4), density=1.0), r"source is a tuple of 3, but a mesh must be \(vertices, triangles\)"),
        (lambda: polhode.inertia((VERTICES, np.ma.masked_equal(TRIANGLES, 3)), density=1.0), "triangles has masked elements"),
        (lambda: polhode.inertia(mesh, density=1.0, kind="voxels"), "kind = 'voxels' has no effect on arrays"),
        (lambda: polhode.inertia(mesh, density=1.0, unit="kg"), 'unit = \'kg\': "kg" is a mass'),
        (lambda: polhode.check("arm.urdf", roots="models"), "roots must be a list of folders, not str"),
        (lambda: polhode.inertia((VERTICES, [[0, 2, 10**20]]), density=1.0), r"triangles\[0, 2\] = 100000000000000000000 must be from 0 to 3"),
        (lambda: polhode.inertia((VERTICES, [[0, 2, True]]), density=1.0), r"triangles\[0, 2\] = True must be a number, not a truth value"),
        (lambda: polhode.inertia((VERTICES, np.array(TRIANGLES, object)), density=1.0), r"convert them, as by .astype\(int\)"),
        (lambda: polhode.inertia((np.zeros((0, 3)), TRIANGLES), density=1.0), "vertices has no rows"),
        (lambda: polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0]), r"inertia must have the shape \(3, 3\), or \(3,\) for moments"),
    ):
        with pytest.raises((TypeError, polhode.PolhodeError), match=says):
            call()


def test_batches_say_what_they_are_given() -> None:
    plan = polhode.batch.Plan(PLAN.format(members=4))
    rows = polhode.batch.inputs(plan)
    own = pa.Table.from_batches([rows]).append_column("name", pa.array(list("abcd")))
    assert polhode.batch.simulate(own, plan)["name"].to_pylist() == list("abcd")
    whole = rows.set_column(1, rows.schema.names[1], pa.array([1, 0, -1, 2]))
    floats = rows.set_column(1, rows.schema.names[1], pa.array([1.0, 0.0, -1.0, 2.0]))
    assert polhode.batch.simulate(whole, plan).equals(polhode.batch.simulate(floats, plan))
    huge = rows.set_column(1, rows.schema.names[1], pa.array([1, 0, -1, 2**60]))
    for call, says in (
        (lambda: polhode.batch.simulate(rows.schema.names, plan), "rows must be a pyarrow RecordBatch or Table, a dataframe, or a mapping from columns to arrays, not builtins.list"),
        (lambda: polhode.batch.simulate(huge, plan), r"column start_spin_body_x_rad_s\[3\] = 1152921504606846976 must be a float64 exactly"),
        (lambda: polhode.batch.inputs(plan, [1, 2]), "members must be a range, not list"),
    ):
        with pytest.raises((TypeError, polhode.PolhodeError), match=says):
            call()


LIBRARIES = ["polhode", *(f"polhode-{name}" for name in "budget document identify judge robot scenario shape source sweep table".split())]


def test_hints_name_keywords(tmp_path: Path) -> None:
    """Of every hint that the library's crates hold, and of two that are really given."""
    crates = [ROOT / "crates" / name / "src" for name in LIBRARIES]
    sources = [path.read_text() for crate in crates for path in crate.rglob("*.rs")]
    lines = [line for source in sources for line in source.splitlines() if re.search(r"(?<![\w-])--[a-z]", line) and not line.strip().startswith("//")]
    assert len(lines) > 10
    for line in lines:
        assert not re.search(r"(?<!the command's )(?<![\w-])--[a-z]", in_python(line)), in_python(line)
    for flag, keyword in (
        ("--weld 5e-07 (3 vertices", "weld=5e-07 (3 vertices"),
        ('--weld "3 um" or --fill', 'weld="3 um" or fill'),
        ("--fill 0.25, or", "fill=0.25, or"),
        ("use --close-within 3.3%, or", 'use close_within="3.3%", or'),
        ("united by --union:", "united by union=True:"),
        ("use --lump fixed, which", "use fixed_groups(), which"),
        ("--lump fixed, --lump all or --subtree, or list them by --table; its", "fixed_groups(), inertia() or subtree, or list them by link_table(); its"),
        ("run without --body to see", "run without the attribute body to see"),
        ("`polhode simulate` computes it, `polhode torque` its torque", "polhode.simulate computes it, polhode.required_torque its torque"),
        ("but --draws is 0", "but draws is 0"),
    ):
        assert in_python(flag) == keyword
    with pytest.raises(polhode.PolhodeError, match=r"hull=True.*shell a sheet along it") as error:
        polhode.inertia((VERTICES, TRIANGLES[:3]), density=1.0)
    assert "--" not in str(error.value)
    table = tmp_path / "points.csv"
    table.write_text("mass,x,y,z\n1,0,0,0\n2,1,0,0\n3,0,1,2\n")
    with pytest.raises(polhode.PolhodeError, match="give the unit by (unit|mass_unit)") as error:
        polhode.inertia(table)
    assert "--" not in str(error.value)


def test_options_that_exclude_each_other_are_refused(tmp_path: Path) -> None:
    """None of them is left out in silence."""
    torque = '[[torque]]\nmodel = "drag"\nlaw = "linear"\ncoefficient = "0.3 N m s"\n'
    sweep = '[sweep]\nmembers = 9\nseed = 7\nsampling = "monte carlo"\n[[sweep.vary]]\nkey = "torque[0].coefficient"\nuniform = { from = 1, to = 3 }\n'
    bodies: dict[str, Any] = {"moments": [1, 2, 2.5], "omega": [[1, 2, 3]]}
    assert len(polhode.Ensemble(**bodies, torques=torque)) == 1
    for call, says in (
        (lambda: polhode.inertia((VERTICES, TRIANGLES), density=1.0, hull=True, shell=0.1), "hull and shell are both given"),
        (lambda: polhode.FreeMotion(inertia=[1, 2, 2.5], omega=[1, 2, 3], allow_unphysical=True), "allow_unphysical = True has no effect on inertia"),
        (lambda: polhode.Ensemble(**bodies, torques=torque + sweep), r"torques may contain only \[\[torque\]\] tables"),
        (lambda: polhode.Ensemble(**bodies, torques='title = "drag"\n' + torque), r"torques may contain only \[\[torque\]\] tables"),
        (lambda: polhode.Ensemble(inertia=[[1, 0.1, 0], [0, 2, 0], [0, 0, 2.5]], omega=[[1, 2, 3]]), "member 0: .*not symmetric.*\nhint: give each product"),
        (lambda: polhode.Ensemble(**bodies).at([1.0], tolerance=1e300), "the tolerance = 1e300 must be between"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            call()


def test_paths_of_any_bytes_are_read(tmp_path: Path) -> None:
    """Names of files are bytes on most systems, and need not be UTF-8."""
    path = tmp_path / os.fsdecode(b"caf\xe9.stl")
    try:
        path.write_bytes((ROOT / "examples" / "bracket.stl").read_bytes())
    except (OSError, UnicodeError):
        return  # a system of other names has no such file
    assert polhode.inertia(path, unit="mm", density=1.0).mass == polhode.inertia(ROOT / "examples" / "bracket.stl", unit="mm", density=1.0).mass
    for call in (
        lambda: polhode.inertia(path.with_suffix(".csv")),
        lambda: polhode.check(path.with_suffix(".urdf")),
        lambda: polhode.simulate(path.with_suffix(".toml")),
        lambda: polhode.batch.Plan(path.with_suffix(".toml")),
        lambda: polhode.inertia(tmp_path / "nowhere.xml"),
        lambda: polhode.inertia(tmp_path / "nowhere.world"),
    ):
        with pytest.raises(FileNotFoundError) as missing:
            call()
        assert missing.value.errno == errno.ENOENT and missing.value.strerror and missing.value.filename in str(missing.value)
    with pytest.raises(IsADirectoryError) as folder:
        polhode.inertia(tmp_path, kind="scenario")
    assert folder.value.filename == str(tmp_path)
    for call in (
        lambda: polhode.simulate("title = '\udce9'\n"),
        lambda: polhode.batch.Plan("title = '\udce9'\n"),
        lambda: shapes.sphere(radius=1.0, material="\udce9"),
    ):
        with pytest.raises(polhode.PolhodeError, match=r"a lone surrogate\), which is not valid text"):
            call()


def test_a_kind_of_many_formats_needs_an_ending(tmp_path: Path) -> None:
    for kind, known in (("mesh", ".stl .obj .ply"), ("molecule", ".xyz .extxyz .mol")):
        with pytest.raises(polhode.PolhodeError, match=f"is not a known format of a {kind}\nhint: known extensions: {known}"):
            polhode.inertia(tmp_path / "body.dat", kind=kind)


def test_matrices_are_attitudes() -> None:
    """The same turns as quaternions, as SciPy's, and as matrices: one for all, or one for each."""
    turns = Rotation.from_rotvec([[0.4, -1.2, 0.7], [3.1, 0.2, -0.1], [0.0, 0.0, 0.0]])
    matrices, wxyz = turns.as_matrix(), turns.as_quat()[:, [3, 0, 1, 2]]
    body = polhode.MassProperties(mass=2.0, inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
    for matrix, quaternion in zip(matrices, wxyz):
        states = [polhode.FreeMotion(inertia=body, omega=[1, 2, 3], attitude=given).at(0.3) for given in (matrix, matrix.tolist(), quaternion)]
        assert np.abs(states[0].attitude - states[2].attitude).max() < 1e-14 and states[0] == states[1]
        assert np.allclose(body.inertia_along(matrix), body.inertia_along(quaternion), rtol=0, atol=1e-14)
        assert np.allclose(body.placed(rotation=matrix).inertia, body.placed(rotation=quaternion).inertia, rtol=0, atol=1e-14)
    for matrix, quaternion in ((matrices, wxyz), (matrices[0], wxyz[0])):
        one, two = (polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=np.eye(3), attitude=given).at([0.3]) for given in (matrix, quaternion))
        assert np.abs(one.attitude - two.attitude).max() < 1e-14
    flight = polhode.Flight(attitude_times=[0, 1, 2], attitude=matrices)
    assert np.abs(np.abs((flight.attitude * wxyz).sum(axis=1)) - 1.0).max() < 1e-15
    with pytest.raises(polhode.PolhodeError, match=r"attitude\[1\]: "):
        polhode.Flight(attitude_times=[0, 1], attitude=[np.eye(3), -np.eye(3)])
    with pytest.raises(polhode.PolhodeError, match="attitude: "):
        polhode.FreeMotion(inertia=body, omega=[1, 2, 3], attitude=[[1, 0, 0], [0, 1, 1e-3], [0, 0, 1]])


def test_a_rotation_is_the_same_at_every_door() -> None:
    """A quaternion, a matrix, SciPy's rotation, and the forms of files."""
    turn = Rotation.from_euler("ZXZ", [0.4, 1.1, -0.7])
    x, y, z, w = turn.as_quat().tolist()
    angle = np.linalg.norm(turn.as_rotvec())
    given: list[Any] = [
        *([w, x, y, z], np.array([w, x, y, z]), turn.as_matrix(), turn.as_matrix().tolist(), turn),
        *({"quaternion": [w, x, y, z]}, {"matrix": turn.as_matrix().tolist()}, {"euler313": ["0.4 rad", f"{np.rad2deg(1.1)} deg", "-0.7 rad"]}),
        {"axis": turn.as_rotvec() / angle, "angle": f"{angle} rad"},
    ]
    body = polhode.MassProperties(mass=2.0, inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
    ball = scenario.Contact(surface=scenario.Surface(shape="sphere", radius=0.2), law="rolling")

    def started(**of: Any) -> np.ndarray:
        given = {"body": body, "run": scenario.Run(duration=0.5, samples=2)} | of
        return polhode.simulate(polhode.Scenario(**given), error="cheap").attitude

    doors: dict[str, Callable[[Any], Any]] = {
        "attitude": lambda turn: polhode.FreeMotion(inertia=body, omega=[1, 2, 3], attitude=turn).at(0.0).attitude,
        "rotation": lambda turn: body.inertia_along(turn),
        "rotation ": lambda turn: body.placed(rotation=turn).inertia,
        "rotation  ": lambda turn: polhode.Body({"one": body}).placed(rotation=turn).mass_properties.inertia,
        "attitude ": lambda turn: polhode.Ensemble(body, omega=[1, 2, 3], attitude=turn).at([0.0]).attitude,
        "start.attitude": lambda turn: started(start=scenario.Start(attitude=turn, omega=[0.1, 2.0, 0.3])),
        "torque.rest": lambda turn: started(torques=[scenario.Torsion(stiffness=2.0, rest=turn)]),
        "surface.rotate": lambda turn: started(contact=replace(ball, surface=replace(ball.surface, rotate=turn)), start=scenario.Start(omega=[0.1, 2.0, 0.3])),
        "part.rotate": lambda turn: started(body=scenario.Part(shape="box", size=[0.1, 0.2, 0.3], mass=2.0, rotate=turn), start=scenario.Start(omega=[0.1, 2.0, 0.3])),
    }
    for name, door in doors.items():
        first, *others = (np.asarray(door(one)) for one in given)
        assert all(np.allclose(one, first, rtol=0, atol=1e-13) for one in others), name
        for wrong, says in (
            ([1.0, 0.0, 0.0], r"must have the shape \(4,\), not \(3,\)"),
            ([0.0, 0.0, 0.0, 0.0], "part of a quaternion that is not zero"),
            (-np.eye(3), "not a rotation|determinant|left-handed|reflection"),
            ("30 deg", "must be real numbers, not text"),
        ):
            with pytest.raises((polhode.PolhodeError, TypeError), match=rf"^{name.strip()}.*({says})"):
                door(wrong)
        with pytest.raises(polhode.PolhodeError, match="(?s)axiss.*did you mean axis"):
            door({"axiss": [0, 0, 1], "angle": 1.0})


def test_a_body_is_the_same_at_every_door() -> None:
    """Mass properties, or a body of named parts."""
    parts = {"a": shapes.box(size=[0.1, 0.2, 0.4], mass=1.5), "b": shapes.sphere(radius=0.1, mass=0.7).placed(position=[0.1, -0.2, 0.3])}
    body = polhode.Body(parts)
    whole = body.mass_properties
    doors: list[Callable[[Any], Any]] = [
        lambda body: polhode.FreeMotion(inertia=body, omega=[1, 2, 3]).at(0.7).omega,
        lambda body: polhode.Ensemble(body, omega=[1, 2, 3]).at([0.7]).omega,
        lambda body: polhode.Ensemble([body], omega=[1, 2, 3]).at([0.7]).omega,
        lambda body: polhode.Ensemble(inertia=body, omega=[1, 2, 3]).at([0.7]).omega,
        lambda body: polhode.Body({"inner": body, "more": parts["a"]}).mass_properties.inertia,
        lambda body: polhode.simulate(polhode.Scenario(body, start=scenario.Start(omega=[1, 2, 3])), times=[0.0, 0.7]).omega,
        lambda body: polhode.spins_from_periods(inertia=body, periods=[2.1, 9.3], convention="short")[0].omega,
    ]
    for door in doors:
        assert np.allclose(door(body), door(whole), rtol=1e-12, atol=1e-14)
    with pytest.raises(TypeError, match="part 'a' must be MassProperties or a Body, not float"):
        polhode.Body({"a": 1.0})  # type: ignore[dict-item]


def test_counts_are_whole_numbers_of_any_kind() -> None:
    ensemble = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=np.eye(3))
    for threads in (2, np.int64(2), np.uint8(2)):
        assert ensemble.at([0.0, 1.0], threads=threads) == ensemble.at([0.0, 1.0])
    for threads in (0, -1, 2.0, True, "2"):
        with pytest.raises((TypeError, polhode.PolhodeError), match="threads"):
            ensemble.at([0.0, 1.0], threads=threads)
