"""Files of every kind."""

from __future__ import annotations

import math
import warnings
from pathlib import Path

import numpy as np
import polhode
import pytest
from polhode import shapes


@pytest.mark.parametrize("name", ["bracket.stl", "meshes/bracket.obj", "meshes/bracket.ply", "meshes/bracket.off"])
def test_one_mesh_in_every_format_has_one_tensor(examples: Path, name: str) -> None:
    wanted = polhode.inertia(examples / "bracket.stl", unit="mm", material="aluminium")
    found = polhode.inertia(examples / name, unit="mm", density=2700.0)
    assert np.allclose(found.inertia, wanted.inertia, rtol=1e-6) and np.isclose(found.mass, wanted.mass, rtol=1e-6)


def test_a_mesh_that_says_its_unit_needs_none(examples: Path) -> None:
    wanted = polhode.inertia(examples / "bracket.stl", unit="mm", material="aluminium")
    for name in ["bracket.glb", "bracket.3mf", "bracket.dae"]:
        found = polhode.inertia(examples / "meshes" / name, density=2700.0)
        assert np.allclose(found.inertia, wanted.inertia, rtol=1e-12), name


def test_hulls_and_sheets(examples: Path) -> None:
    solid = polhode.inertia(examples / "bracket.stl", unit="mm", density=1000.0)
    hull = polhode.inertia(examples / "bracket.stl", unit="mm", density=1000.0, hull=True)
    sheet = polhode.inertia(examples / "bracket.stl", unit="mm", density=1000.0, shell=1e-4)
    assert hull.mass > solid.mass > sheet.mass > 0.0
    assert np.isclose(sheet.mass, 1000.0 * 1e-4 * solid.surface_area, rtol=1e-12)


def test_parts_that_overlap_are_united_if_asked() -> None:
    corner = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    (a, b), (c, d) = ([0.0, 0.0, 0.0], [3.0, 2.0, 1.0]), ([1.0, 0.5, -0.25], [3.5, 1.0, 0.75])
    vertices = np.vstack([a + corner * b, c + corner * d])
    triangles = np.vstack([faces, np.array(faces) + 8])
    with pytest.raises(polhode.PolhodeError, match="union=True, or union = true"):
        polhode.inertia((vertices, triangles), unit="m", density=4.0)
    with pytest.warns(polhode.PolhodeWarning, match=r"2 parts were united.*\[mesh.united\]"):
        body = polhode.inertia((vertices, triangles), unit="m", density=4.0, union=True)
    # of two boxes and what they share
    shared = (np.array([1.0, 0.5, 0.0]), np.array([2.0, 1.0, 0.5]))
    boxes = [(1.0, (np.array(a), np.array(b))), (1.0, (np.array(c), np.array(d))), (-1.0, shared)]
    mass = sum(sign * 4.0 * np.prod(size) for sign, (_, size) in boxes)
    center = sum(sign * 4.0 * np.prod(size) * (low + size / 2) for sign, (low, size) in boxes) / mass
    assert math.isclose(body.mass, mass, rel_tol=1e-12) and np.allclose(body.center_of_mass, center, rtol=1e-12)
    assert math.isclose(body.to_dict()["source"]["union"]["shared_m3"], 1.0, rel_tol=1e-12)
    with pytest.raises(polhode.PolhodeError, match="shell and union are both given"):
        polhode.inertia((vertices, triangles), unit="m", shell=0.01, union=True)


def test_a_mesh_may_be_measured_without_a_search_for_intersections(tmp_path: Path) -> None:
    # A prism over a pentagram, which goes through itself, and the wedge of a box, which does not.
    star = [[round(math.cos(0.3 + 0.8 * math.pi * k), 6), round(math.sin(0.3 + 0.8 * math.pi * k), 6)] for k in range(5)]
    ends = [[*p, z] for z in (0.0, 1.25) for p in [*star, [0.0, 0.0]]]
    sides = [t for a, b in ((k, (k + 1) % 5) for k in range(5)) for t in ([a, b, b + 6], [a, b + 6, a + 6], [5, b, a], [11, a + 6, b + 6])]
    wedge = [[0.5, 0.25, 0.0], [3.5, 0.25, 0.0], [0.5, 2.25, 0.0], [0.5, 0.25, 1.0]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    for mesh, codes in (((ends, sides), ["mesh.overlap"]), (wedge, [])):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            whole = polhode.inertia(mesh, unit="m", density=4.0)
        assert [finding.code for finding in whole.findings] == codes and len(said) == len(codes)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            unchecked = polhode.inertia(mesh, unit="m", density=4.0, check=False)
        assert [finding.code for finding in unchecked.findings] == ["mesh.unchecked"]
        for text in (repr(unchecked), str(unchecked)):
            assert "not checked for self-intersections" in text
        assert "not checked" not in repr(whole)
        assert unchecked.mass == whole.mass and (unchecked.center_of_mass == whole.center_of_mass).all() and (unchecked.inertia == whole.inertia).all()
    with pytest.raises(polhode.PolhodeError, match="the mesh is open"):
        polhode.inertia((wedge[0], wedge[1][1:]), unit="m", density=4.0, check=False)
    for other in ({"hull": True}, {"shell": 0.01}, {"union": True}):
        with pytest.raises(polhode.PolhodeError, match="check=False are both given"):
            polhode.inertia(wedge, unit="m", density=4.0, check=False, **other)
    with pytest.raises(TypeError, match="check must be True or False"):
        polhode.inertia(wedge, unit="m", density=4.0, check=0)  # type: ignore[arg-type]
    # Two parts of a file that overlap: each states the omission.
    lines = []
    for part, shift in enumerate((0.0, 0.25)):
        lines += [f"o part{part}", *(f"v {x + shift} {y} {z}" for x, y, z in wedge[0])]
        lines += [f"f {a + 4 * part + 1} {b + 4 * part + 1} {c + 4 * part + 1}" for a, b, c in wedge[1]]
    path = tmp_path / "two.obj"
    path.write_text("\n".join(lines))
    with pytest.warns(polhode.PolhodeWarning, match=r"\[mesh.parts_overlap\]"):
        both = polhode.inertia(path, unit="m", density=4.0)
    unchecked = polhode.inertia(path, unit="m", density=4.0, check=False)
    assert [finding.code for finding in unchecked.findings] == ["mesh.unchecked"] * 2 and unchecked.mass == both.mass


def test_indices_are_checked_in_every_type() -> None:
    vertices = np.array([[0.5, 0.25, 0.0], [3.5, 0.25, 0.0], [0.5, 2.25, 0.0], [0.5, 0.25, 1.0]])
    triangles = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    mass = polhode.inertia((vertices, triangles), unit="m", density=4.0).mass
    for kind in (np.int64, np.int32, np.uint8, np.uint32, np.uint64):
        assert polhode.inertia((vertices, triangles.astype(kind)), unit="m", density=4.0).mass == mass
    assert polhode.inertia((vertices, triangles.T.copy().T), unit="m", density=4.0).mass == mass
    for wrong in (-1, 4, 2**32, -(2**63)):
        bad = triangles.copy()
        bad[2, 1] = wrong
        with pytest.raises(polhode.PolhodeError, match=rf"triangles\[2, 1\] = {wrong} must be from 0 to 3"):
            polhode.inertia((vertices, bad), unit="m", density=4.0)


def test_torn_and_holed_meshes_are_mended_if_asked(tmp_path: Path) -> None:
    vertices = [[0.1, 0, 0], [2.1, 0, 0], [0.1, 3, 0], [0.1, 0, 1], [0.1000021, 0, 1], [0.1, 0.0000013, 1]]
    torn = [[0, 2, 1], [0, 1, 3], [0, 4, 2], [1, 2, 5]]
    with pytest.raises(polhode.PolhodeError, match=r"the mesh is open.*\n.*it closes if vertices are welded within [^:]*: weld=[0-9.e-]+ \("):
        polhode.inertia((vertices, torn), unit="m", density=4.0)
    for weld in (7e-7, "3 um"):
        with pytest.warns(polhode.PolhodeWarning, match=r"3 vertices were welded to 1 point.*the volume may be off by .*\[mesh.welded\]"):
            body = polhode.inertia((vertices, torn), unit="m", density=4.0, weld=weld)
        source = body.to_dict()["source"]
        assert source["weld"]["points"] == 1 and abs(body.volume - 1.0) <= source["volume_bound_m3"] < 2e-5
    # the scaled mesh is as torn beside its size
    with pytest.warns(polhode.PolhodeWarning, match="mesh.welded"):
        polhode.inertia((vertices, torn), unit="mm", density=4.0, weld=7e-7)
    with pytest.warns(polhode.PolhodeWarning) as said:
        body = polhode.inertia((vertices, torn[1:]), unit="m", density=4.0, weld=7e-7, fill="4 m")
    assert abs(body.volume - 1.0) < 1e-5 and len(said) == 2
    source = body.to_dict()["source"]
    assert (source["triangles"], source["triangles_in_file"], source["fill"]["holes"]) == (4, 3, 1)
    assert source["volume_bound_m3"] > source["weld"]["volume_bound_m3"] + source["fill"]["volume_bound_m3"]
    path = tmp_path / "torn.obj"
    path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in vertices) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in torn))
    with pytest.warns(polhode.PolhodeWarning, match="mesh.welded"):
        assert math.isclose(polhode.inertia(path, unit="m", density=4.0, weld=7e-7).mass, 4.0, rel_tol=1e-5)
    for options, says in (
        ({"weld": -1.0}, "weld = -1.0 must be positive"),
        ({"weld": "3 kg"}, "weld: .*mass where a length belongs"),
        ({"fill": "wide"}, "fill: "),
        ({"weld": 1e-6, "hull": True}, "hull and weld are both given"),
        ({"fill": 1e-6, "shell": 0.1}, "shell and fill are both given"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.inertia((vertices, torn), density=4.0, **options)


def test_holes_are_closed_within_bounds_if_asked() -> None:
    # A box with one raised corner, whose top is missing: the top is either of two pairs of triangles.
    vertices = [[0.2, -1, 3], [1.2, -1, 3], [1.2, 0, 3], [0.2, 0, 3], [0.2, -1, 4], [1.2, -1, 4], [1.2, 0, 4.2], [0.2, 0, 4]]
    sides = [[0, 2, 1], [0, 3, 2], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]]
    with pytest.raises(polhode.PolhodeError, match=r"the mesh is open.*\n.*close_within=\"3.3%\" closes its holes"):
        polhode.inertia((vertices, sides), unit="m", density=4.0)
    for share in ("3.3%", 0.033):
        with pytest.warns(polhode.PolhodeWarning, match=r"closed within bounds: 1 hole, .*at most.*\[mesh.closed_within_bounds\]"):
            body = polhode.inertia((vertices, sides), unit="m", density=4.0, close_within=share)
        bounds = body.to_dict()["bounds"]
        for top in ([[4, 5, 6], [4, 6, 7]], [[4, 5, 7], [5, 6, 7]]):
            truth = polhode.inertia((vertices, sides + top), unit="m", density=4.0)
            assert abs(body.volume - truth.volume) <= bounds["volume"] * (1 + 1e-12)
            assert (abs(body.center_of_mass - truth.center_of_mass) <= np.array(bounds["center_of_mass"]) + 1e-15).all()
            assert (abs(body.inertia - truth.inertia) <= np.array(bounds["inertia"]) + 1e-15).all()
            assert (abs(body.moments - truth.moments) <= bounds["principal_moments"] + 1e-15).all()
        assert math.isclose(bounds["mass"], 4.0 * bounds["volume"], rel_tol=1e-6) and math.isclose(bounds["volume"], 0.2 / 6, rel_tol=1e-6)
    for options, says in (
        ({"close_within": "3.2%"}, r"the holes leave 3.3% of the volume uncertain, more than 3.2%.*\n.*use close_within=\"3.3%\""),
        ({"close_within": 5}, "close_within: 5.0 is not above 0 and at most 50%"),
        ({"close_within": "wide"}, "close_within: .*is not a share"),
        ({"close_within": 0.05, "hull": True}, "hull and close_within are both given"),
        ({"close_within": 0.05, "union": True}, "close_within and union are both given"),
        ({"close_within": 0.05, "check": False}, "close_within and check=False are both given"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.inertia((vertices, sides), unit="m", density=4.0, **options)


def test_an_assumed_density_is_said(examples: Path) -> None:
    with pytest.warns(polhode.PolhodeWarning, match=r"1 kg/m³ is assumed \[mass.assumed\]"):
        body = polhode.inertia(examples / "bracket.stl", unit="mm")
    assert [finding.code for finding in body.findings if finding.severity == "warning"] == ["mass.assumed"]


def test_a_mesh_that_is_absurd_in_metres_is_asked_for_its_unit(examples: Path) -> None:
    vertices, triangles = [[0, 0, 0], [30, 0, 0], [0, 20, 0], [0, 0, 10]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    for source, options in (
        ((vertices, triangles), {"density": 2700.0}),
        ((vertices, triangles), {"density": 2700.0, "hull": True}),
        (examples / "bracket.stl", {"density": 2700.0}),
        (examples / "bracket.stl", {"density": 2700.0, "shell": 0.1}),
    ):
        with pytest.warns(polhode.PolhodeWarning, match=r'is it in mm\? \(give unit="mm", or unit="m" if the file is in metres\) \[mesh.unit\]'):
            body = polhode.inertia(source, **options)
        assert [finding.code for finding in body.findings if finding.severity == "warning"] == ["mesh.unit"]
        for unit in ("m", "mm", 1.0):
            assert "mesh.unit" not in [finding.code for finding in polhode.inertia(source, unit=unit, **options).findings]


def test_molecules_and_their_constants(examples: Path) -> None:
    bodies = [polhode.inertia(examples / f"water.{ending}") for ending in ("xyz", "mol", "pdb")]
    assert all(np.allclose(body.moments, bodies[0].moments, rtol=2e-2) for body in bodies)
    molecule = bodies[0].to_dict()["molecule"]
    assert molecule["top"] == "asymmetric" and len(molecule["rotational_constants_ghz"]) == 3
    average = polhode.inertia(examples / "water.xyz", isotopes="average")
    assert average.mass > bodies[0].mass


def test_several_molecules_are_chosen_from(examples: Path, tmp_path: Path) -> None:
    mol = (examples / "water.mol").read_text()
    path = tmp_path / "two.sdf"
    path.write_text(f"{mol.rstrip()}\n$$$$\n{mol.rstrip()}\n$$$$\n")
    with pytest.raises(polhode.PolhodeError, match="contains 2 molecules\nhint: choose one by molecule, from 0"):
        polhode.inertia(path)
    assert polhode.inertia(path, molecule=1).mass == polhode.inertia(examples / "water.mol").mass
    with pytest.raises(polhode.PolhodeError, match="molecule = 2 must be from 0 to 1"):
        polhode.inertia(path, molecule=2)


def test_particles_and_voxels(tmp_path: Path) -> None:
    rng = np.random.default_rng(7)
    masses, positions = rng.uniform(0.1, 2.0, 20), rng.normal(size=(20, 3))
    table = tmp_path / "points.csv"
    np.savetxt(table, np.column_stack([masses, positions]), delimiter=",", header="mass_kg,x_m,y_m,z_m", fmt="%.17g")
    wanted = polhode.particles(masses=masses, positions=positions)
    assert np.array_equal(polhode.inertia(table).inertia, wanted.inertia)

    grid = tmp_path / "grid.npy"
    np.save(grid, np.ones((4, 3, 2)))
    body = polhode.inertia(grid, spacing=[0.01, 0.02, 0.03], per_value=1800.0)
    brick = shapes.box(size=[0.04, 0.06, 0.06], density=1800.0)
    assert np.isclose(body.mass, brick.mass) and np.allclose(body.inertia, brick.inertia, rtol=1e-12)


def test_scenarios_and_robots(examples: Path) -> None:
    handle = polhode.inertia(examples / "t-handle.toml")
    assert handle.mass > 0.0 and handle.symmetry == "asymmetric"
    arm = examples / "robots" / "arm.urdf"
    straight = polhode.inertia(arm)
    bent = polhode.inertia(arm, joints={"elbow": 0.5})
    assert np.isclose(bent.mass, straight.mass) and not np.allclose(bent.inertia, straight.inertia)
    forearm = polhode.inertia(arm, link="forearm")
    assert 0.0 < forearm.mass < straight.mass
    assert np.isclose(polhode.inertia(examples / "robots" / "arm.sdf").mass, straight.mass)
    with pytest.raises(polhode.PolhodeError, match='unknown link "claw"\nhint: its links are'):
        polhode.inertia(arm, link="claw")


def test_what_means_nothing_is_refused(examples: Path) -> None:
    for name, options, says in (
        ("t-handle.toml", {"density": 1.0}, "density has no effect on .* which is a scenario"),
        ("bracket.stl", {"link": "arm"}, "link has no effect on .* which is a mesh"),
        ("water.xyz", {"hull": True}, "hull has no effect on .* which is a molecule"),
        ("bracket.stl", {"unit": "kg"}, "mass where a length belongs"),
        ("bracket.stl", {"unit": -1.0}, "unit = -1.0 must be positive"),
        ("make_bracket.py", {}, "unknown file extension"),
        ("bracket.stl", {"kind": "stl"}, "kind = 'stl' must be one of"),
        ("water.xyz", {"isotopes": "all"}, "isotopes = 'all' must be"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.inertia(examples / name, **options)


def test_errors_in_files_have_their_place(tmp_path: Path) -> None:
    path = tmp_path / "ball.toml"
    path.write_text('[[body.part]]\nshape = "sphere"\nradius = "20 kg"\nmass = "1 kg"\n')
    with pytest.raises(polhode.PolhodeError, match='"kg" is a mass where a length belongs') as error:
        polhode.inertia(path)
    assert (error.value.path, error.value.line, error.value.column) == (str(path), 3, 10)
    with pytest.raises(FileNotFoundError):
        polhode.inertia(tmp_path / "none.stl", density=1.0)


def test_where_a_body_came_from_is_told_as_the_command_tells_it(examples: Path, tmp_path: Path) -> None:
    """The object that ``polhode inertia --json`` prints has the same keys: what was read, in which unit, along which joints."""
    np.save(tmp_path / "grid.npy", np.random.default_rng(0).uniform(0.5, 2.0, (3, 4, 5)))
    atom = "%10.4f%10.4f%10.4f %-3s 0  0\n"
    counts = "\n\n\n%3d  0  0  0  0  0              1 V2000\n"
    helium = "helium" + counts % 1 + atom % (0, 0, 0, "He") + "M  END\n$$$$\n"
    nitrogen = "nitrogen" + counts % 2 + atom % (0, 0, 0, "N") + atom % (0, 0.3, 1.05, "N") + "M  END\n$$$$\n"
    (tmp_path / "two.sdf").write_text(helium + nitrogen)
    robot = examples / "robots" / "arm.urdf"
    links = ["base", "upper_arm", "forearm", "camera", "hand"]
    mesh = {"encoding": "binary", "triangles": 216, "parts": 1}
    with pytest.warns(polhode.PolhodeWarning, match="is it in mm"):
        in_metres = polhode.inertia(examples / "bracket.stl", mass=0.4)
    for body, path, wanted in (
        (in_metres, examples / "bracket.stl", {"format": "stl", **mesh, "unit_m": 1.0, "vertices": 108, "taken_as": "solid", "unit_assumed": True}),
        (
            polhode.inertia(examples / "bracket.stl", mass=0.4, unit="mm", shell=1e-3),
            examples / "bracket.stl",
            {"format": "stl", **mesh, "unit_m": 0.001, "taken_as": "sheet"},
        ),
        (
            polhode.inertia(tmp_path / "grid.npy", spacing=[0.1, 0.2, 0.3]),
            tmp_path / "grid.npy",
            {"format": "npy", "voxels": [3, 4, 5], "type": "double", "filled": 60},
        ),
        (polhode.inertia(tmp_path / "two.sdf", molecule=1), tmp_path / "two.sdf", {"format": "sdf", "name": "nitrogen", "atoms": 2, "molecule": 2}),
        (polhode.inertia(robot, link="hand"), robot, {"format": "urdf", "link": "hand", "frame": "link"}),
        (
            polhode.inertia(robot, joints={"elbow": 0.3}),
            robot,
            {"format": "urdf", "link": "base", "frame": "link", "links": links, "massless": ["tool"], "joints": {"elbow": 0.3}},
        ),
    ):
        assert body.to_dict()["source"] == {"path": str(path)} | wanted
    assert "all 5 links of arm, elbow = 0.3 rad and other joints at zero, in the frame of base" in str(polhode.inertia(robot, joints={"elbow": 0.3}))
    with pytest.raises(polhode.PolhodeError, match='the link "tool" has no mass\nhint: choose another link, or lump it with other links'):
        polhode.inertia(robot, link="tool")


def test_digits_too_few_for_a_tensor_are_said(tmp_path: Path) -> None:
    """A rod's moments, rounded up: unphysical, but there are physical ones within the digits that are written."""
    path = tmp_path / "rod.urdf"
    path.write_text(
        '''<robot name="rod"><link name="rod"><inertial><mass value="1"/>
        <inertia ixx="0.0833" iyy="0.0833" izz="0.1667" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'''
    )
    for body in (polhode.inertia(path), polhode.inertia(path, link="rod")):
        assert body.to_dict()["source"]["rounding"] > 0.0 and "to satisfy the triangle inequality" in str(body)


#: ``pin.crba`` of Pinocchio 4.1 at left_knuckle = 0.41: the composite below the joint turn, in its frame.
PALM_CENTER = [0.04654461142223511, -0.01649181158020465, 0.00972670870271394]
PALM_TENSOR = [
    [0.0018425042066597015, -1.1027381846990538e-05, -5.918668101769643e-05],
    [-1.1027381846990538e-05, 0.001709464724623935, 0.00011638251436951058],
    [-5.918668101769643e-05, 0.00011638251436951058, 0.002734939254717088],
]


def test_what_hangs_from_a_link_and_what_follows_a_joint(examples: Path) -> None:
    gripper = examples / "robots" / "gripper.urdf"
    palm = polhode.inertia(gripper, subtree="palm", joints={"left_knuckle": 0.41})
    assert np.isclose(palm.mass, 0.803, rtol=1e-15)
    assert np.allclose(palm.center_of_mass, PALM_CENTER, rtol=0, atol=1e-15)
    assert np.allclose(palm.inertia, PALM_TENSOR, rtol=0, atol=1e-16)
    source = palm.to_dict()["source"]
    assert source["joints"] == {"left_knuckle": 0.41} and np.isclose(source["followers"]["right_knuckle"], -0.087)
    turned = polhode.inertia(gripper, subtree="palm", joints={"left_knuckle": "23.5 deg"})
    assert turned.to_dict()["source"]["joints"] == {"left_knuckle": np.radians(23.5)}
    with pytest.warns(polhode.PolhodeWarning, match=r"lift = 0.5 m is outside its limits.*\[position.limits\]"):
        polhode.inertia(gripper, joints={"lift": "50 cm"})
    for options, says in (
        ({"joints": {"right_knuckle": 0.1}}, '"right_knuckle" follows "left_knuckle"'),
        ({"joints": {"lfit": 0.1}}, "did you mean lift"),
        ({"joints": {"lift": "3 deg"}}, "the joint slides: write a length"),
        ({"subtree": "plam"}, "did you mean palm"),
        ({"subtree": "palm", "joints": {"lift": 0.1}}, "moves nothing below"),
        ({"subtree": "palm", "link": "palm"}, "link and subtree are both given"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.inertia(gripper, **options)
    with pytest.raises(polhode.PolhodeError) as error:
        polhode.inertia(gripper, joints={"right_knuckle": 0.1})
    assert (error.value.path, error.value.line) == (str(gripper), 44)


def test_inertials_of_a_robot_are_written_from_its_geometry(tmp_path: Path) -> None:
    box = '<geometry><box size="0.2 0.3 0.5"/></geometry>'
    old = '<inertial><mass value="1.7"/><inertia ixx="3" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    path = tmp_path / "r.urdf"
    path.write_text(
        f'<robot name="r"><link name="base">{old}<visual><origin xyz="0.1 0 0"/>{box}</visual></link><link name="tip"><collision name="cap">{box}</collision>'
        '</link><joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint></robot>'
    )
    written = polhode.write_inertials(path)
    base, tip = written
    assert (base.mass, base.mass_by, base.geometry, base.reason) == (1.7, "kept", "visual", "1 shape; no collision")
    tensor = 1.7 / 12 * np.diag([0.09 + 0.25, 0.04 + 0.25, 0.04 + 0.09])
    assert np.allclose(base.inertia, tensor, rtol=1e-14, atol=0) and np.allclose(base.center_of_mass, [0.1, 0, 0], rtol=1e-15, atol=0)
    assert tip.mass is None and tip.why_not is not None and "by density, material, parts or mass" in tip.why_not
    assert not written.ok and written[1:] == [tip] and written["tip"] == tip and repr(written).endswith("r.urdf': 1 of 2 links)")
    assert "--" not in str(written) and "+++ b/" in written.diff and "1.7 kg (kept)" in str(written)
    written = polhode.write_inertials(path, parts={"tip/cap": {"density": "2 g/cm^3"}, "b*": {"mass": 0.9}})
    assert written.ok and np.isclose(written["tip"].mass, 60.0, rtol=1e-14) and written["base"].mass == 0.9
    path.with_name("new.urdf").write_text(written.text)
    assert polhode.check(path.with_name("new.urdf")).ok and np.isclose(polhode.link_table(path.with_name("new.urdf")).whole.mass, 60.9, rtol=1e-14)
    assert [link.link for link in polhode.write_inertials(path, only="missing", density=900)] == ["tip"]
    share = polhode.write_inertials(path, mass="6 kg")
    assert [link.mass for link in share] == [3.0, 3.0] and share.to_dict()["links"][1]["mass_by"] == "share of the total, 100 kg/m³"
    for options, says in (
        ({"link": "bsae"}, "did you mean base"),
        ({"parts": {"tip/cpa": "steel"}}, "did you mean tip/cap"),
        ({"parts": {"tip": "stel"}}, "no such material"),
        ({"only": "bad"}, "must be one of missing"),
        ({"density": 900.0, "mass": 2.0}, "contradict each other"),
        ({"parts": {"*": {"mass": 2.0}}}, "one mass to 2 links"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.write_inertials(path, **options)


def test_groups_and_the_table_of_a_robot(examples: Path) -> None:
    arm = examples / "robots" / "arm.urdf"
    groups = polhode.fixed_groups(arm)
    assert list(groups) == ["base", "upper_arm", "forearm", "hand"] and np.isclose(groups["forearm"].mass, 1.02)
    table = polhode.link_table(arm, joints={"elbow": "30 deg"})
    whole = polhode.inertia(arm, joints={"elbow": "30 deg"})
    assert [row.link for row in table] == ["base", "upper_arm", "forearm", "camera", "hand", "tool"] and len(table) == 6
    assert table.rows[5] == polhode.results.LinkRow("tool", [], 0.0, None, None, None)
    assert table.rows[0].shapes == ["box"]
    assert np.array_equal(table.rows[3].inertia, polhode.inertia(arm, link="camera").inertia)
    assert np.array_equal(table.whole.inertia, whole.inertia) and np.array_equal(table.whole.moments, whole.moments)
    assert table.to_dict()["whole"] == whole.to_dict()
    assert table.to_csv().splitlines()[7].split(",")[1:4] == ["whole", "arm", "base"]
    assert str(table).splitlines()[-1].startswith("whole robot") and repr(table).endswith("arm.urdf': 6 links, 6.12 kg)")
