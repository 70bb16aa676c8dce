"""Mass properties: against formulas written out here, there and back, and of files."""

from __future__ import annotations

import pickle

import numpy as np
import polhode
import pytest
from conftest import matrix, steiner
from polhode import shapes
from scipy.spatial.transform import Rotation

TURN = np.array([0.4, -0.7, 1.1, 0.3])
PLACE = np.array([0.5, -0.25, 1.5])


def test_a_tensor_about_another_point_comes_back(generic: polhode.MassProperties) -> None:
    point = np.array([-1.0, 0.4, 0.7])
    about = generic.inertia_about(point)
    assert np.allclose(about, generic.inertia + steiner(2.3, generic.center_of_mass - point), rtol=0, atol=4e-15)
    again = polhode.MassProperties(mass=2.3, center_of_mass=generic.center_of_mass, inertia=about, about=point)
    assert np.allclose(again.inertia, generic.inertia, rtol=0, atol=1e-14)


def test_principal_axes_are_rows(generic: polhode.MassProperties) -> None:
    axes, moments = generic.axes, generic.moments
    assert (np.diff(moments) > 0).all()
    for moment, axis in zip(moments, axes):
        assert np.allclose(generic.inertia @ axis, moment * axis, rtol=0, atol=5e-15)
    assert np.isclose(np.linalg.det(axes), 1.0)
    assert np.allclose(generic.gyration_radii, np.sqrt(moments / 2.3))


def test_the_principal_rotation_takes_principal_components_to_body_components(generic: polhode.MassProperties) -> None:
    rotation = generic.principal_rotation
    assert np.allclose(rotation @ np.diag(generic.moments) @ rotation.T, generic.inertia, rtol=0, atol=1e-14)
    assert not np.allclose(rotation.T @ np.diag(generic.moments) @ rotation, generic.inertia, rtol=0, atol=1e-3)
    assert np.isclose(np.linalg.det(rotation), 1.0)
    # L = I ω, with ω along the intermediate axis
    omega = rotation @ [0.0, 2.0, 0.0]
    assert np.allclose(generic.inertia @ omega, generic.moments[1] * omega, rtol=0, atol=1e-14)


@pytest.mark.parametrize("turn", [TURN, Rotation.from_matrix(matrix(TURN))], ids=["wxyz", "scipy"])
def test_placed_and_joined_is_what_the_formula_says(generic: polhode.MassProperties, turn: object) -> None:
    other = shapes.box(size=[0.2, 0.1, 0.06], mass=1.7)
    placed = other.placed(position=PLACE, rotation=turn)
    r = matrix(TURN)
    assert np.allclose(placed.center_of_mass, PLACE)
    inertia = np.diag([0.1**2 + 0.06**2, 0.2**2 + 0.06**2, 0.2**2 + 0.1**2]) * 1.7 / 12
    assert np.allclose(placed.inertia, r @ inertia @ r.T, rtol=0, atol=1e-17)
    assert np.allclose(placed.inertia_along(turn), inertia, rtol=0, atol=1e-17)

    both = generic + placed
    center = (2.3 * generic.center_of_mass + 1.7 * PLACE) / 4.0
    wanted = generic.inertia + steiner(2.3, generic.center_of_mass - center) + placed.inertia + steiner(1.7, PLACE - center)
    assert both.mass == 4.0
    assert np.allclose(both.center_of_mass, center, rtol=0, atol=1e-16)
    assert np.allclose(both.inertia, wanted, rtol=0, atol=4e-15)
    assert np.allclose(sum([generic, placed]).inertia, both.inertia, rtol=0, atol=0)
    body = polhode.Body({"main": generic, "brick": placed})
    assert np.array_equal(body.mass_properties.inertia, both.inertia) and body["brick"] is placed


def test_particles_are_their_sums() -> None:
    masses, positions = np.array([0.3, 1.1, 2.0]), np.array([[0.1, -0.4, 0.2], [0.7, 0.1, -0.3], [-0.2, 0.5, 0.9]])
    body = polhode.particles(masses=masses, positions=positions)
    center = masses @ positions / masses.sum()
    assert np.allclose(body.center_of_mass, center)
    assert np.allclose(body.inertia, sum(steiner(m, p - center) for m, p in zip(masses, positions)), rtol=0, atol=4e-16)
    with pytest.raises(polhode.PolhodeError, match=r"masses\[1\] = 0.0 must be positive"):
        polhode.particles(masses=[1.0, 0.0], positions=[[0, 0, 0], [1, 1, 1]])
    with pytest.raises(polhode.PolhodeError, match="one mass for each point"):
        polhode.particles(masses=[1.0], positions=[[0, 0, 0], [1, 1, 1]])


def capsule(r: float, length: float, density: float) -> list[float]:
    """A cylinder, and two half balls whose centres are 3/8 r beyond its ends."""
    middle, ends = density * np.pi * r**2 * length, density * 4 / 3 * np.pi * r**3
    across = middle * (r**2 / 4 + length**2 / 12) + ends * (2 / 5 * r**2 + length**2 / 4 + 3 / 8 * r * length)
    return [across, across, (middle / 2 + 2 / 5 * ends) * r**2]


@pytest.mark.parametrize(
    ("shape", "diagonal"),
    [
        (shapes.box_shell(size=[0.2, 0.2, 0.2], mass=1.5), [5 / 18 * 1.5 * 0.04] * 3),
        (shapes.capsule(radius=0.2, length=1.2, density=1000.0), capsule(0.2, 1.2, 1000.0)),
        (shapes.cone(base_radius=0.3, height=0.8, mass=2.0), [2.0 * (3 / 20 * 0.09 + 3 / 80 * 0.64)] * 2 + [0.3 * 2.0 * 0.09]),
        (shapes.cone_shell(base_radius=0.3, height=0.8, mass=2.0), [2.0 * (0.09 / 4 + 0.64 / 18)] * 2 + [2.0 * 0.09 / 2]),
        (shapes.cylinder(radius=0.3, inner_radius=0.2, length=0.8, mass=2.0), [2.0 * (3 * 0.13 + 0.64) / 12] * 2 + [0.13]),
        (shapes.sphere(radius=0.3, inner_radius=0.2, mass=2.0), [0.4 * 2.0 * (0.3**5 - 0.2**5) / (0.3**3 - 0.2**3)] * 3),
        (shapes.triangular_plate(vertices=[[0.1, 0.2], [0.4, 0.2], [0.1, 0.8]], mass=2.0), [0.04, 0.01, 0.05]),
        (shapes.triangular_prism(vertices=[[0.1, 0.2], [0.4, 0.2], [0.1, 0.8]], length=0.6, mass=2.0), [0.1, 0.07, 0.05]),
        (shapes.cylinder(radius=0.3, length=0.8, mass=2.0), [2.0 * (3 * 0.09 + 0.64) / 12] * 2 + [0.09]),
        (shapes.cylinder_shell(radius=0.3, length=0.8, mass=2.0), [2.0 * (6 * 0.09 + 0.64) / 12] * 2 + [0.18]),
        (shapes.disk(radius=0.3, area_density=2.0 / (np.pi * 0.09)), [0.045, 0.045, 0.09]),
        (shapes.ellipsoid(semi_axes=[0.1, 0.2, 0.3], mass=5.0), [0.13, 0.10, 0.05]),
        (shapes.plate(size=[0.3, 0.4], mass=1.2), [1.2 * 0.16 / 12, 1.2 * 0.09 / 12, 1.2 * 0.25 / 12]),
        (shapes.rod(length=0.6, line_density=2.0), [1.2 * 0.36 / 12, 1.2 * 0.36 / 12, 0.0]),
        (shapes.sphere(radius=0.3, density=2.0 / (4 / 3 * np.pi * 0.027)), [0.4 * 2.0 * 0.09] * 3),
        (shapes.sphere_shell(radius=0.3, mass=2.0), [2.0 / 3.0 * 2.0 * 0.09] * 3),
        (shapes.torus(ring_radius=0.5, tube_radius=0.1, mass=2.0), [2.0 * (0.125 + 0.00625)] * 2 + [2.0 * (0.25 + 0.0075)]),
    ],
)
def test_shapes_are_their_formulas(shape: polhode.MassProperties, diagonal: list[float]) -> None:
    assert np.allclose(np.diag(shape.inertia), diagonal, rtol=1e-13, atol=1e-15)


def test_a_density_beyond_the_range_of_numbers_is_none() -> None:
    heavy = shapes.box(size=[3e-90, 4e-90, 5e-90], mass=1e50)
    assert heavy.density is None and heavy.volume > 0.0
    assert shapes.box(size=[3.0, 4.0, 5.0], mass=120.0).density == 2.0


def test_a_tetrahedron_is_the_mesh_of_its_faces() -> None:
    vertices = np.array([[0.1, -0.2, 0.3], [1.4, 0.2, -0.1], [0.3, 1.7, 0.2], [-0.2, 0.4, 1.9]])
    solid = shapes.tetrahedron(vertices=vertices, density=1234.5)
    mesh = polhode.inertia((vertices, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]), density=1234.5)
    assert np.isclose(mesh.mass, solid.mass, rtol=1e-14) and np.allclose(mesh.inertia, solid.inertia, rtol=1e-12)
    assert np.isclose(mesh.volume, abs(np.linalg.det(vertices[1:] - vertices[0])) / 6)
    in_mm = polhode.inertia((vertices * 1e3, np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])), unit="mm", mass=mesh.mass)
    assert np.allclose(in_mm.inertia, mesh.inertia, rtol=1e-12)


def test_substances_are_one() -> None:
    for wrong, says in (
        ({}, "no density, mass or material is given"),
        ({"mass": 1.0, "density": 2.0}, "density and mass are both given"),
        ({"material": "cheese"}, 'unknown material "cheese"'),
        ({"mass": -1.0}, "mass = -1.0 must be positive"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            shapes.sphere(radius=0.1, **wrong)
    assert np.isclose(shapes.sphere(radius=0.1, material="Steel").density, 7850.0, rtol=1e-15)


def test_copies_keep_their_numbers(generic: polhode.MassProperties) -> None:
    copy = pickle.loads(pickle.dumps(generic))
    assert copy.mass == generic.mass and np.array_equal(copy.inertia, generic.inertia)
    assert np.array_equal(copy.center_of_mass, generic.center_of_mass)


def test_exports_are_read_back(generic: polhode.MassProperties, tmp_path: object) -> None:
    path = tmp_path / "body.urdf"
    path.write_text(generic.export("urdf", name="trunk"))
    again = polhode.inertia(path, link="trunk")
    assert np.allclose(again.inertia, generic.inertia, rtol=1e-15) and again.mass == generic.mass
    with pytest.raises(polhode.PolhodeError, match="unknown format"):
        generic.export("step")
