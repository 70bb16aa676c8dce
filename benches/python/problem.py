"""Problems for the comparison of packages: inputs, and true results."""

from __future__ import annotations

import functools
import math
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

import reference  # noqa: E402


class Problem(NamedTuple):
    """A problem: folder of its programs, input, and error of an answer."""

    folder: str
    title: str
    #: Statement of the problem on the page.
    text: str
    #: Quantity of the error, with its unit.
    error_of: str
    #: Packages that cannot solve it, with the reason.
    without: str
    given: Any
    error: Any
    #: Name; the folder's by default.
    name: str = ""


# Free motion

MOMENTS, OMEGA, TIMES = (1.0, 2.0, 3.0), (0.3, 0.5, 0.9), np.linspace(0.0, 100.0, 1001)


def error_of_free_motion(answer: Any) -> float:
    truth = reference.motion(MOMENTS, np.array([OMEGA]), [1.0, 0.0, 0.0, 0.0], 0.0, TIMES)
    return reference.largest_angle(np.asarray(answer[1]), truth[:, 0])


# A heavy top: its moments are about the centre of mass, 1 m from the pivot, and about the pivot (1, 1, 0.5); M g l = 1 N·m

TOP = {
    "moments": (0.75, 0.75, 0.5),
    "mass": 0.25,
    "gravity": 4.0,
    "omega": (0.0, 0.0, 5.0),
    "attitude": (math.cos(math.pi / 6), math.sin(math.pi / 6), 0.0, 0.0),
    "time": 100.0,
}


def error_of_heavy_top(answer: Any) -> float:
    truth = reference.motion((1.0, 1.0, 0.5), np.array([TOP["omega"]]), TOP["attitude"], 1.0, [0.0, 100.0])
    return reference.largest_angle(np.asarray(answer)[None], truth[-1])


# Many bodies

BODIES, EVERY = 10_000, 10


def bodies() -> dict[str, Any]:
    return {"moments": (1.0, 2.0, 2.5), "omega": np.random.default_rng(1).normal(size=(BODIES, 3)), "time": 10.0}


def error_of_many_bodies(answer: Any) -> float:
    given = bodies()
    truth = reference.motion(given["moments"], given["omega"][::EVERY], [1.0, 0.0, 0.0, 0.0], 0.0, [0.0, given["time"]])
    return reference.largest_angle(np.asarray(answer[1])[::EVERY], truth[-1])


# A torque of one's own

INERTIA = ((3.1, -0.4, 0.3), (-0.4, 4.2, -0.2), (0.3, -0.2, 5.3))
DRAG, AMPLITUDE = 0.05, 0.1
SPAN = np.linspace(0.0, 10.0, 2)


def error_of_driven(answer: Any) -> float:
    truth = reference.driven(INERTIA, np.array([OMEGA]), reference.drag_and_wave(DRAG, AMPLITUDE), SPAN)
    return reference.largest_angle(np.asarray(answer[1]), truth[:, 0])


def error_of_saturated(answer: Any) -> float:
    truth = reference.driven(INERTIA, np.array([OMEGA]), reference.saturated(0.2, 3.0), SPAN)
    return reference.largest_angle(np.asarray(answer[1]), truth[:, 0])


def driven_bodies() -> dict[str, Any]:
    return {"inertia": INERTIA, "omega": np.random.default_rng(1).normal(size=(BODIES, 3)), "time": 10.0}


def error_of_driven_bodies(answer: Any) -> float:
    given = driven_bodies()
    truth = reference.driven(INERTIA, given["omega"][::EVERY], reference.drag_and_wave(DRAG, AMPLITUDE), [0.0, given["time"]])
    return reference.largest_angle(np.asarray(answer[1])[::EVERY], truth[-1])


# One short step of many bodies


def short_span() -> dict[str, Any]:
    return bodies() | {"time": 0.1}


def error_of_short_span(answer: Any) -> float:
    given = short_span()
    truth = reference.motion(given["moments"], given["omega"][::EVERY], [1.0, 0.0, 0.0, 0.0], 0.0, [0.0, given["time"]])
    return reference.largest_angle(np.asarray(answer[1])[::EVERY], truth[-1])


# A mesh

DENSITY = 2700.0


@functools.cache
def solid() -> tuple[np.ndarray, np.ndarray]:
    """Returns a deformed sphere of 100,000 triangles in 201 bands of 250 meridians, without symmetry; vertices are multiples of 2⁻²⁰."""
    bands, meridians = 201, 250
    polar, azimuth = np.pi * np.arange(1, bands) / bands, 2.0 * np.pi * np.arange(meridians) / meridians
    theta, phi = [a.ravel() for a in np.meshgrid(polar, azimuth, indexing="ij")]
    points = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=1)
    points = np.concatenate([points, [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    radius = 1.0 + 0.15 * np.sin(3.0 * points[:, 0] + 1.0) * np.cos(2.0 * points[:, 1]) + 0.1 * points[:, 2] * points[:, 0]
    vertices = np.rint(points * radius[:, None] * [0.31, 0.47, 0.39] * 2.0**20) / 2.0**20
    north, south = (bands - 1) * meridians, (bands - 1) * meridians + 1
    ring = np.arange(meridians)
    after = (ring + 1) % meridians
    triangles = [np.stack([np.full(meridians, north), ring, after], axis=1)]
    for band in range(bands - 2):
        a, b = band * meridians + ring, band * meridians + after
        triangles += [np.stack([a, a + meridians, b], axis=1), np.stack([b, a + meridians, b + meridians], axis=1)]
    last = (bands - 2) * meridians
    triangles.append(np.stack([np.full(meridians, south), last + after, last + ring], axis=1))
    return vertices, np.concatenate(triangles)


def mesh() -> dict[str, Any]:
    vertices, triangles = solid()
    return {"vertices": vertices, "triangles": triangles, "density": DENSITY}


@functools.cache
def ball(level: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns an icosphere of 20 · 4^level triangles, radius 0.3 m, away from the origin; vertices are displaced by up to 1 µm, to multiples of 2⁻²⁰."""
    g = (1.0 + math.sqrt(5.0)) / 2.0
    turns = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
    corners = [[(0.0, s, t * g)[turn.index(k)] for k in range(3)] for turn in turns for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    vertices = [np.array(corner) for corner in corners]
    near = [{j for j in range(12) if j != i and math.dist(corners[i], corners[j]) < 2.1} for i in range(12)]
    faces = [(i, j, k) for i in range(12) for j in near[i] for k in near[i] & near[j] if i < j < k]
    faces = [(i, j, k) if np.dot(np.cross(vertices[i], vertices[j]), vertices[k]) > 0.0 else (i, k, j) for i, j, k in faces]
    for _ in range(level):
        middles: dict[tuple[int, int], int] = {}

        def middle(i: int, j: int) -> int:
            if (min(i, j), max(i, j)) not in middles:
                middles[min(i, j), max(i, j)] = len(vertices)
                vertices.append(vertices[i] / np.linalg.norm(vertices[i]) + vertices[j] / np.linalg.norm(vertices[j]))
            return middles[min(i, j), max(i, j)]

        divided = [(i, j, k, middle(i, j), middle(j, k), middle(k, i)) for i, j, k in faces]
        faces = [face for i, j, k, p, q, r in divided for face in ((i, p, r), (j, q, p), (k, r, q), (p, q, r))]
    points = np.array([0.3 * vertex / np.linalg.norm(vertex) for vertex in vertices]) + [0.7, -0.4, 1.1]
    points += np.random.default_rng(1).uniform(-1e-6, 1e-6, points.shape)
    return np.rint(points * 2.0**20) / 2.0**20, np.array(faces)


def small_mesh(level: int) -> dict[str, Any]:
    vertices, triangles = ball(level)
    return {"vertices": vertices, "triangles": triangles, "density": DENSITY}


def error_of_small_mesh(level: int, answer: Any) -> float:
    return error_of(answer, *ball(level))


def error_of_mesh(answer: Any) -> float:
    return error_of(answer, *solid())


def error_of(answer: Any, vertices: np.ndarray, triangles: np.ndarray) -> float:
    """Returns the larger of two errors: relative error of the mass, and largest error of the central tensor, if there is one, over half its trace."""
    mass, _, inertia = answer
    true_mass, true_inertia = reference.mass_properties(vertices, triangles, DENSITY)
    of_mass = float(abs(Fraction(float(mass)) - true_mass) / true_mass)
    if inertia is None:
        return of_mass
    half = sum(true_inertia[k][k] for k in range(3)) / 2
    wrong = [abs(Fraction(float(inertia[i][j])) - true_inertia[i][j]) / half for i in range(3) for j in range(3)]
    return float(max(*wrong, of_mass))


PROBLEMS = [
    Problem(
        "free_motion",
        "Free motion",
        "A body with moments (1, 2, 3) kg·m² and ω(0) = (0.3, 0.5, 0.9) rad/s: ω and attitude at 1,001 times, 0 to 100 s.",
        "largest angle between an attitude and the true one, rad",
        "",
        lambda: {"moments": MOMENTS, "omega": OMEGA, "times": TIMES},
        error_of_free_motion,
    ),
    Problem(
        "heavy_top",
        "A heavy top, to 10⁻¹² rad",
        "Moments (1, 1, 0.5) kg·m² about the pivot, M g l = 1 N·m, leaning by 60°, ω(0) = (0, 0, 5) rad/s: the attitude after 100 s.",
        "angle between the attitude and the true one, rad",
        "",
        lambda: TOP,
        error_of_heavy_top,
    ),
    Problem(
        "many_bodies",
        "10,000 bodies",
        "Moments (1, 2, 2.5) kg·m², 10,000 spins ω(0), each component normal with 1 rad/s: ω and attitude of all after 10 s.",
        f"largest angle of every {EVERY}th body's attitude from the true one, rad",
        "",
        bodies,
        error_of_many_bodies,
    ),
    Problem(
        "driven",
        "A torque of one's own",
        "A tensor with products, the torque −0.05 ω + (0.1 sin t, 0, 0) N·m along body axes: ω and attitude after 10 s.",
        "angle between the attitude and the true one, rad",
        "MuJoCo computes such a torque only at the start of each step.",
        lambda: {"inertia": INERTIA, "omega": OMEGA, "times": SPAN},
        error_of_driven,
    ),
    Problem(
        "saturated",
        "A saturated law",
        "The same body under −0.2 tanh 3ω N·m, component by component: ω and attitude after 10 s.",
        "angle between the attitude and the true one, rad",
        "MuJoCo computes such a torque only at the start of each step.",
        lambda: {"inertia": INERTIA, "omega": OMEGA, "times": SPAN},
        error_of_saturated,
    ),
    Problem(
        "driven_bodies",
        "10,000 bodies under it",
        "The same body and torque, 10,000 spins ω(0), each component normal with 1 rad/s: ω and attitude of all after 10 s.",
        f"largest angle of every {EVERY}th body's attitude from the true one, rad",
        "MuJoCo computes such a torque only at the start of each step.",
        driven_bodies,
        error_of_driven_bodies,
    ),
    Problem(
        "short_span",
        "One short step of 10,000 bodies",
        "The 10,000 free bodies again, each from a new start over 0.1 s, as in control: the time contains all that depends on the start.",
        f"largest angle of every {EVERY}th body's attitude from the true one, rad",
        "",
        short_span,
        error_of_short_span,
    ),
    Problem(
        "mesh",
        "Mass properties of a mesh",
        "100,000 triangles in memory, a deformed sphere without symmetry: mass, centre of mass and inertia tensor.",
        "largest of an element of the tensor, in units of half its trace, and of the mass, relative",
        "SciPy and heyoka have nothing for it.",
        mesh,
        error_of_mesh,
    ),
]

#: Meshes of the table of small meshes: 320, 1,280 and 5,120 triangles.
SMALL_MESHES = [
    Problem(
        "mesh",
        f"{20 * 4**level:,}",
        "",
        "",
        "",
        functools.partial(small_mesh, level),
        functools.partial(error_of_small_mesh, level),
        f"small_mesh_{20 * 4**level}",
    )
    for level in (2, 3, 4)
]


def named(name: str) -> Problem:
    (found,) = (of for of in PROBLEMS + SMALL_MESHES if name == (of.name or of.folder))
    return found
