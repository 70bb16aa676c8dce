"""Derivatives of mass properties: against central differences at generic points, the relations that they obey, and motions by them."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable

import numpy as np
import polhode
import pytest
from conftest import matrix
from polhode import shapes
from scipy.spatial.transform import Rotation
from test_derivatives import ATTITUDE, OMEGA, between

MASSES = np.array([1.3, 0.4, 2.2, 0.9])
PLACES = np.array([[0.3, -1.1, 0.2], [0.7, 0.5, -0.9], [-0.6, 0.1, 1.4], [0.2, 0.8, 0.5]])

#: A solid of 20 triangles off the origin: an icosahedron, pulled about.
GOLDEN = (1.0 + np.sqrt(5.0)) / 2.0
CORNERS = np.array([np.roll([0.0, a, b * GOLDEN], k) for k in range(3) for a in (-1, 1) for b in (-1, 1)])
VERTICES = CORNERS @ [[0.7, 0.2, -0.1], [0.0, 0.5, 0.1], [0.1, 0.0, 0.4]] + 0.1 * np.sin(3.0 * CORNERS[:, [1, 2, 0]]) + [0.5, -0.25, 0.75]


def faces() -> np.ndarray:
    """Three corners that are 2 apart from each other, counter-clockwise from outside."""
    near = np.isclose(np.linalg.norm(CORNERS[:, None] - CORNERS[None], axis=2), 2.0)
    found = [(i, j, k) for i in range(12) for j in range(i) for k in range(j) if near[i, j] and near[j, k] and near[k, i]]
    return np.array([f if np.linalg.det(CORNERS[list(f)]) > 0.0 else f[::-1] for f in found])


TRIANGLES = faces()


def numbers(body: polhode.MassProperties) -> np.ndarray:
    inertia = body.inertia
    return np.array([body.mass, *body.center_of_mass, *inertia.diagonal(), inertia[0, 1], inertia[0, 2], inertia[1, 2]])


def body_of(ten: np.ndarray) -> polhode.MassProperties:
    xx, yy, zz, xy, xz, yz = ten[4:]
    return polhode.MassProperties(mass=ten[0], center_of_mass=ten[1:4], inertia=[[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def differenced(of: Callable[[float], np.ndarray], h: float = 1e-2) -> np.ndarray:
    """f′(0) by differences of the sixth order."""
    a, b, c = ((of(k * h) - of(-k * h)) / (2.0 * k * h) for k in (1, 2, 3))
    return np.asarray(1.5 * a - 0.6 * b + 0.1 * c)


def moved(array: np.ndarray, place: tuple[int, ...], by: float) -> np.ndarray:
    array = array.copy()
    array[place] += by
    return array


def near(by: np.ndarray, want: np.ndarray, tolerance: float = 1e-8) -> None:
    assert by.shape == want.shape
    assert np.abs(by - want).max() <= tolerance * max(1.0, np.abs(want).max())


def test_particles_have_the_derivatives_of_differences() -> None:
    of = polhode.particle_derivatives(masses=MASSES, positions=PLACES)
    assert of.by_masses.shape == (10, 4) and of.by_positions.shape == (10, 4, 3)
    assert np.array_equal(of.values, numbers(polhode.particles(masses=MASSES, positions=PLACES)))
    assert np.abs(of.values).min() > 1e-3
    for k in range(4):
        near(of.by_masses[:, k], differenced(lambda h: numbers(polhode.particles(masses=moved(MASSES, (k,), h), positions=PLACES))))
        for axis in range(3):
            places = lambda h: moved(PLACES, (k, axis), h)  # noqa: E731
            near(of.by_positions[:, k, axis], differenced(lambda h: numbers(polhode.particles(masses=MASSES, positions=places(h)))))


def solid(vertices: np.ndarray = VERTICES, **substance: float) -> polhode.MassProperties:
    return polhode.inertia((vertices, TRIANGLES), unit="m", **substance)  # type: ignore[arg-type]


@pytest.mark.parametrize("substance", [{"density": 1.7}, {"mass": 2.9}])
def test_a_mesh_has_the_derivatives_of_differences(substance: dict[str, float]) -> None:
    mesh = polhode.mesh_derivatives((VERTICES, TRIANGLES), **substance)  # type: ignore[arg-type]
    assert mesh.by_vertices.shape == (10, 12, 3)
    assert np.array_equal(mesh.values, numbers(solid(**substance))) and np.abs(mesh.values).min() > 1e-3
    for vertex in range(12):
        for axis in range(3):
            of = differenced(lambda h: numbers(solid(moved(VERTICES, (vertex, axis), h), **substance)), 2e-3)
            near(mesh.by_vertices[:, vertex, axis], of)
    density, mass = solid(**substance).density, solid(**substance).mass
    assert density is not None
    near(mesh.by_density, differenced(lambda h: numbers(solid(density=density + h))))
    near(mesh.by_mass, differenced(lambda h: numbers(solid(mass=mass + h))))


@pytest.mark.parametrize("substance", [{"density": 1.7}, {"mass": 2.9}])
def test_what_moves_all_vertices_together(substance: dict[str, float]) -> None:
    mesh = polhode.mesh_derivatives((VERTICES, TRIANGLES), **substance)  # type: ignore[arg-type]
    body, values = mesh.mass_properties, mesh.values

    def along(velocity: np.ndarray) -> np.ndarray:
        return np.tensordot(mesh.by_vertices, velocity, axes=2)

    scaled = values * np.array([0, 1, 1, 1, *[2] * 6] if "mass" in substance else [3, 1, 1, 1, *[5] * 6])
    near(along(VERTICES), scaled, 1e-13)
    for axis in np.eye(3):
        near(along(np.broadcast_to(axis, VERTICES.shape)), np.array([0.0, *axis, *np.zeros(6)]), 1e-13)
        cross = np.cross(np.eye(3), axis)
        turned = cross @ body.inertia - body.inertia @ cross
        want = [0.0, *np.cross(axis, body.center_of_mass), *turned.diagonal(), turned[0, 1], turned[0, 2], turned[1, 2]]
        near(along(np.cross(axis, VERTICES)), np.array(want), 1e-13)


def test_a_gradient_is_a_row_times_the_ten() -> None:
    mesh = polhode.mesh_derivatives((VERTICES, TRIANGLES), density=1.7)
    of_numbers = np.random.default_rng(5).normal(size=(2, 3, 10))
    gradient = mesh.gradient(of_numbers)
    assert gradient.shape == (2, 3, 12, 3)
    near(gradient, np.tensordot(of_numbers, mesh.by_vertices, axes=1), 1e-14)
    assert np.array_equal(mesh.gradient(of_numbers[1, 2]), gradient[1, 2])
    assert mesh.gradient(np.empty((0, 10))).shape == (0, 12, 3)


def test_equal_vertices_move_together() -> None:
    """Triangles that share nothing by index, and a vertex that nothing uses."""
    shared = polhode.mesh_derivatives((VERTICES, TRIANGLES), mass=2.9).by_vertices
    soup = np.vstack([VERTICES[TRIANGLES].reshape(-1, 3), VERTICES[:1]])
    alone = polhode.mesh_derivatives((soup, np.arange(60).reshape(-1, 3)), mass=2.9).by_vertices
    assert not alone[:, 60].any()
    for vertex in range(12):
        corners = TRIANGLES.ravel() == vertex
        near(alone[:, :60][:, corners].sum(axis=1), shared[:, vertex], 1e-14)
        assert (alone[:, :60][:, corners] == alone[:, :60][:, corners][:, :1]).all()


def test_a_mesh_is_turned_with_a_warning() -> None:
    with pytest.warns(polhode.PolhodeWarning, match="pointed inward"):
        inward = polhode.mesh_derivatives((VERTICES, TRIANGLES[:, ::-1]), density=1.7)
    near(inward.by_vertices, polhode.mesh_derivatives((VERTICES, TRIANGLES), density=1.7).by_vertices, 1e-14)
    assert [finding.code for finding in inward.mass_properties.findings] == ["mesh.inverted"]


#: Parts in their own axes; one of them thin, of no volume.
PARTS = {
    "egg": shapes.ellipsoid(semi_axes=[0.5, 0.9, 1.2], density=2.3).placed(position=[0.3, -0.2, 0.1]),
    "rod": shapes.rod(length=1.7, mass=1.4).placed(position=[-0.1, 0.2, 0.4]),
    "lump": solid(density=1.4),
}
POSITIONS = np.array([[0.2, -0.4, 0.1], [1.1, 0.3, -0.6], [-0.8, 0.7, 0.5]])
TURNS = np.array([[0.4, -0.3, 0.9], [-1.1, 0.2, 0.5], [0.1, 2.0, -0.7]])


def built(positions: np.ndarray = POSITIONS, turned: np.ndarray = np.zeros((3, 3)), parts: dict[str, polhode.MassProperties] = PARTS) -> polhode.Body:
    turn = [Rotation.from_rotvec(more) * Rotation.from_rotvec(turn) for more, turn in zip(turned, TURNS)]
    each = zip(parts.items(), positions, turn)
    return polhode.Body({name: part.placed(position=position, rotation=turn) for (name, part), position, turn in each})


def whole(**given: object) -> np.ndarray:
    return numbers(built(**given).mass_properties)  # type: ignore[arg-type]


def test_a_body_has_the_derivatives_of_differences() -> None:
    body = built()
    of = body.derivatives(about=dict(zip(PARTS, POSITIONS)))
    assert of.parts == ("egg", "rod", "lump") and np.array_equal(of.values, whole())
    assert [of.by_masses.shape, of.by_densities.shape, of.by_positions.shape] == [(10, 3), (10, 3), (10, 3, 3)]
    assert [of.by_rotations.shape, of.by_parts.shape] == [(10, 3, 3), (10, 3, 10)]
    for k, name in enumerate(PARTS):

        def heavier(h: float) -> np.ndarray:
            part = PARTS[name]
            ten = numbers(part) * [1.0 + h / part.mass, 1, 1, 1, *[1.0 + h / part.mass] * 6]
            return whole(parts={**PARTS, name: body_of(ten)})

        near(of.by_masses[:, k], differenced(heavier))
        for axis in range(3):
            near(of.by_positions[:, k, axis], differenced(lambda h: whole(positions=moved(POSITIONS, (k, axis), h))))
            near(of.by_rotations[:, k, axis], differenced(lambda h: whole(turned=moved(np.zeros((3, 3)), (k, axis), h))))

        def changed(number: int, h: float) -> np.ndarray:
            parts = {**body.parts, name: body_of(moved(numbers(body[name]), (number,), h))}
            return numbers(polhode.Body(parts).mass_properties)

        # Next to a rod are tensors of no body.
        for number in range(0 if name == "rod" else 10):
            near(of.by_parts[:, k, number], differenced(lambda h: changed(number, h), 2e-3))
    dense = differenced(lambda h: whole(parts={**PARTS, "lump": solid(density=1.4 + h)}))
    near(of.by_densities[:, 2], dense)
    assert np.isnan(of.by_densities[:, 1]).all() and not np.isnan(of.by_densities[:, [0, 2]]).any()


def test_a_part_turns_about_its_centre_unless_a_point_is_said() -> None:
    body = built()
    centers = {name: part.center_of_mass for name, part in body.parts.items()}
    of = body.derivatives()
    near(of.by_rotations, body.derivatives(about=centers).by_rotations, 0.0)
    assert not of.by_rotations[:4].any()
    # The whole turned about the origin, and moved.
    about = body.derivatives(about={name: [0, 0, 0] for name in body}).by_rotations.sum(axis=1)
    for axis, turned in zip(np.eye(3), about.T):
        near(turned[1:4], np.cross(axis, body.mass_properties.center_of_mass), 1e-14)
    near(of.by_positions.sum(axis=1), np.vstack([np.zeros((1, 3)), np.eye(3), np.zeros((6, 3))]), 1e-14)
    # All heavier by the same part.
    masses = np.array([part.mass for part in body.parts.values()])
    near(of.by_masses @ masses, of.values * [1, 0, 0, 0, *[1] * 6], 1e-14)


def test_far_from_the_origin_nothing_is_lost() -> None:
    far = np.array([2.0**30, -(2.0**29), 2.0**31])
    whole_numbers = np.round(PLACES * 1024) / 1024
    near_by, away = (polhode.particle_derivatives(masses=MASSES, positions=whole_numbers + offset) for offset in (0.0, far))
    near(away.by_masses, near_by.by_masses, 1e-13)
    near(away.by_positions, near_by.by_positions, 1e-13)
    vertices = np.round(VERTICES * 1024) / 1024
    near_by_mesh, away_mesh = (polhode.mesh_derivatives((vertices + offset, TRIANGLES), mass=2.9) for offset in (0.0, far))
    near(away_mesh.by_vertices, near_by_mesh.by_vertices, 1e-13)


def motion_of(ten: np.ndarray) -> polhode.results.States:
    return polhode.FreeMotion(inertia=body_of(ten), omega=OMEGA, attitude=ATTITUDE).at([2.0, 5.0])


def test_a_free_motion_by_masses_and_vertices() -> None:
    """Of a body with a mesh among its parts, and of particles."""
    body = built()
    after = polhode.FreeMotion(inertia=body.mass_properties, omega=OMEGA, attitude=ATTITUDE).derivatives([2.0, 5.0])
    by_ten = after.by_mass_properties
    assert by_ten.shape == (2, 6, 10) and after.mass_properties_columns == polhode.results.MeshDerivatives.rows
    assert not by_ten[:, :, :4].any() and np.array_equal(by_ten[:, :, 4:], after.by_inertia)
    of = body.derivatives()
    here = motion_of(of.values)
    changes = np.tensordot(by_ten, of.by_positions, axes=1)
    assert changes.shape == (2, 6, 3, 3)
    near(changes[:, :, 1, 2], differenced(lambda h: between(here, motion_of(whole(positions=moved(POSITIONS, (1, 2), h))))))
    dense = differenced(lambda h: between(here, motion_of(whole(parts={**PARTS, "lump": solid(density=1.4 + h)}))))
    near(by_ten @ of.by_densities[:, 2], dense)

    turn = matrix(Rotation.from_rotvec(TURNS[2]).as_quat()[[3, 0, 1, 2]])
    placed = polhode.mesh_derivatives((VERTICES @ turn.T + POSITIONS[2], TRIANGLES), density=1.4)
    by_vertices = placed.gradient(by_ten @ of.by_parts[:, 2]) @ turn
    assert by_vertices.shape == (2, 6, 12, 3)

    def shifted(h: float) -> np.ndarray:
        lump = solid(moved(VERTICES, (7, 1), h), density=1.4)
        return between(here, motion_of(whole(parts={**PARTS, "lump": lump})))

    near(by_vertices[:, :, 7, 1], differenced(shifted, 4e-3))

    particles = polhode.particle_derivatives(masses=MASSES, positions=PLACES)
    after = polhode.FreeMotion(inertia=body_of(particles.values), omega=OMEGA, attitude=ATTITUDE).derivatives([2.0, 5.0])
    here = motion_of(particles.values)
    heavier = lambda h: numbers(polhode.particles(masses=moved(MASSES, (2,), h), positions=PLACES))  # noqa: E731
    near((after.by_mass_properties @ particles.by_masses)[:, :, 2], differenced(lambda h: between(here, motion_of(heavier(h)))))


PIVOTED = """
[body]
pivot = [0.4, -0.3, 0.2]
[[body.part]]
shape = "tensor"
mass = {ten[0]!r}
center_of_mass = [{ten[1]!r}, {ten[2]!r}, {ten[3]!r}]
inertia = [[{ten[4]!r}, {ten[7]!r}, {ten[8]!r}], [{ten[7]!r}, {ten[5]!r}, {ten[9]!r}], [{ten[8]!r}, {ten[9]!r}, {ten[6]!r}]]
[start]
attitude = {{ quaternion = [0.4, -0.7, 1.1, 0.3] }}
spin = {{ body = [0.7, -1.1, 0.4] }}
[[torque]]
model = "constant"
axes = "body"
torque = [0.3, -0.4, 0.2]
[[event]]
name = "faster"
measure = "omega_body_x"
value = 0.5
[run]
duration = 3
samples = 4
"""


def test_a_pivoted_motion_by_mass_centre_and_tensor() -> None:
    def run(ten: np.ndarray, derivatives: list[str] | None = None) -> polhode.results.Motion:
        return polhode.simulate(PIVOTED.format(ten=ten.tolist()), error="cheap", derivatives=derivatives)

    values = built().derivatives().values
    here = run(values, [])
    derivatives = here.derivatives
    assert derivatives is not None and derivatives.inertia_by_mass_properties.shape == (6, 10)
    step = 2e-3
    (event,) = derivatives.events
    for number in range(10):
        runs = {k * step: run(moved(values, (number,), k * step)) for k in (-3, -2, -1, 1, 2, 3)}
        states = differenced(lambda h: between((here.omega, here.attitude), (runs[h].omega, runs[h].attitude)), step)
        near(derivatives.by_mass_properties[:, :, number], states)
        by_number = derivatives.inertia_by_mass_properties[:, number]
        near(np.asarray(event.time_by_inertia @ by_number), differenced(lambda h: np.array(runs[h].events[0].time), step))
        events = {h: (np.array([it.events[0].omega]), np.array([it.events[0].attitude])) for h, it in runs.items()}
        there = event.omega[None], event.attitude[None]
        near((event.by_inertia @ by_number)[None], differenced(lambda h: between(there, events[h]), step))


def test_what_has_no_derivatives_is_refused() -> None:
    mesh = (VERTICES, TRIANGLES)
    for given, message in [
        ({}, "no density, mass or material is given"),
        ({"density": 1.0, "mass": 2.0}, "both given"),
        ({"density": -1.0}, "positive"),
    ]:
        with pytest.raises(polhode.PolhodeError, match=message):
            polhode.mesh_derivatives(mesh, **given)  # type: ignore[arg-type]
    with pytest.raises(polhode.PolhodeError, match="is open"):
        polhode.mesh_derivatives((VERTICES, TRIANGLES[:-1]), density=1.0)
    with pytest.raises(polhode.PolhodeError, match="from 0 to 10"):
        polhode.mesh_derivatives((VERTICES[:-1], TRIANGLES), density=1.0)
    with pytest.raises(polhode.PolhodeError, match="tuple of 3"):
        polhode.mesh_derivatives((*mesh, 1), density=1.0)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="the tuple"):
        polhode.mesh_derivatives("part.stl", density=1.0)  # type: ignore[arg-type]
    for odd in (1.0, np.ones(9), np.ones((10, 3))):
        with pytest.raises(polhode.PolhodeError, match="a column for each of rows"):
            polhode.mesh_derivatives(mesh, density=1.0).gradient(odd)
    with pytest.raises(polhode.PolhodeError, match=r"of_number\[1, 2\] = nan must be finite"):
        polhode.mesh_derivatives(mesh, density=1.0).gradient(np.where(np.arange(20).reshape(2, 10) == 12, np.nan, 1.0))
    with pytest.raises(polhode.PolhodeError, match="differ too much in magnitude"):
        far = 1e100 * np.vstack([np.zeros(3), np.eye(3)])
        polhode.mesh_derivatives((moved(far, (0, 0), 1e-230), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]), mass=1.0)
    with pytest.raises(polhode.PolhodeError, match="too large for a double"):
        polhode.mesh_derivatives(mesh, density=1e3).gradient(np.full(10, 1e307))
    with pytest.raises(polhode.PolhodeError, match="one mass for each point"):
        polhode.particle_derivatives(masses=[1.0], positions=PLACES)
    with pytest.raises(polhode.PolhodeError, match="positive"):
        polhode.particle_derivatives(masses=-MASSES, positions=PLACES)
    with pytest.raises(polhode.PolhodeError, match="not a part") as error:
        built().derivatives(about={"eg": [0, 0, 0]})
    assert error.value.hint == "known parts: egg, rod, lump"
    with pytest.raises(polhode.PolhodeError, match=r"about\['egg'\]"):
        built().derivatives(about={"egg": [0, 0]})
    with pytest.raises(TypeError, match="dict of points"):
        built().derivatives(about=[0, 0, 0])  # type: ignore[arg-type]


def test_they_are_values() -> None:
    vertices = VERTICES.copy()
    mesh = polhode.mesh_derivatives((vertices, TRIANGLES), density=1.7)
    particles, body = polhode.particle_derivatives(masses=MASSES, positions=PLACES), built().derivatives()
    others = (
        polhode.mesh_derivatives((VERTICES, TRIANGLES), density=1.8),
        polhode.particle_derivatives(masses=MASSES[::-1], positions=PLACES),
        built().derivatives(about={"egg": [0, 0, 0]}),
    )
    for it, other in zip((mesh, particles, body), others):
        for again in (pickle.loads(pickle.dumps(it)), copy.copy(it), copy.deepcopy(it)):
            assert again == it and again != other and again != 3
            assert np.array_equal(again.values, it.values) and len(again.values) == len(again.rows)
    again = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(again.by_vertices, mesh.by_vertices)
    # What was given may change.
    vertices[:] = 99.0
    assert np.array_equal(mesh.by_vertices, again.by_vertices) and np.array_equal(mesh.vertices, VERTICES)
    assert repr(mesh) == "MeshDerivatives(12 vertices, 20 triangles)"
    assert repr(particles) == "ParticleDerivatives(4 particles)"
    assert repr(body) == "BodyDerivatives('egg', 'rod', 'lump')"
    for array in (mesh.by_vertices, mesh.vertices, again.by_vertices, particles.by_masses, body.by_parts):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0
    with pytest.raises(AttributeError):
        mesh.vertices = VERTICES  # type: ignore[misc]
