"""Reference results, independent of polhode.

Motions by Taylor series in extended precision, masses of meshes by exact rational arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

#: Relative size of the last term of the series. The cheapest order is near −ln(LAST)/2.
LAST, ORDER = 1e-21, 30

REAL = np.longdouble


def motion(
    moments: Sequence[float], omega: np.ndarray, attitude: Sequence[float], weight: float, times: Sequence[float], shorter: float = 1.0
) -> np.ndarray:
    """Returns attitudes (times, bodies, 4) of bodies with these ω(0) (bodies, 3), rad/s, along body axes.

    The bodies are free, or under ``weight`` = M g l, N·m, with the centre of mass on e3.

    Steps are ``shorter`` times those that the last term asks for: another value says how well this is known.
    """
    if np.finfo(REAL).nmant < 63:
        raise SystemExit("the reference needs a long double of 64 bits or more, as x86-64 has it")
    a, b, c = map(REAL, moments)
    count = len(omega)
    q = np.array(attitude, REAL)
    q /= np.sqrt((q * q).sum())
    state = np.concatenate([np.asarray(omega, REAL).T, np.repeat(q[:, None], count, axis=1)])
    series = np.zeros((ORDER + 1, 7, count), REAL)
    up = np.zeros((ORDER + 1, 3, count), REAL)
    found = np.empty((len(times), count, 4), REAL)
    now, row = REAL(0.0), 0
    while row < len(times):
        series[0] = state
        for n in range(ORDER):
            x, y, z, w, i, j, k = series.swapaxes(0, 1)

            def product(one: np.ndarray, two: np.ndarray) -> np.ndarray:
                return (one[: n + 1] * two[n::-1]).sum(axis=0)

            # Components along body axes of e3 of space that produce a torque.
            up[n, 0], up[n, 1] = 2 * (product(i, k) - product(w, j)), 2 * (product(j, k) + product(w, i))
            rates = [
                ((b - c) * product(y, z) + REAL(weight) * up[n, 1]) / a,
                ((c - a) * product(z, x) - REAL(weight) * up[n, 0]) / b,
                (a - b) * product(x, y) / c,
                -(product(i, x) + product(j, y) + product(k, z)) / 2,
                (product(w, x) + product(j, z) - product(k, y)) / 2,
                (product(w, y) + product(k, x) - product(i, z)) / 2,
                (product(w, z) + product(i, y) - product(j, x)) / 2,
            ]
            series[n + 1] = np.array(rates) / (n + 1)
        largest = np.abs(series[ORDER]).max()
        step = REAL(shorter) * (REAL(LAST) / largest) ** (REAL(1) / ORDER) if largest > 0 else REAL(math.inf)
        while row < len(times) and REAL(times[row]) - now <= step:
            found[row] = _sum(series, REAL(times[row]) - now)[3:].T
            row += 1
        if row < len(times):
            state, now = _sum(series, step), now + step
    return found


def _sum(series: np.ndarray, step: np.longdouble) -> np.ndarray:
    total = series[-1]
    for term in series[-2::-1]:
        total = total * step + term
    return total


def largest_angle(attitude: np.ndarray, truth: np.ndarray) -> float:
    """Returns the largest angle between attitudes (n, 4), whose norm need not be 1, rad."""
    one, two = [q / np.sqrt((q * q).sum(axis=-1, keepdims=True)) for q in (attitude.astype(REAL), truth)]
    near = np.where(((one - two) ** 2).sum(axis=-1) < ((one + two) ** 2).sum(axis=-1), 1, -1)
    apart = np.sqrt(((one - near[..., None] * two) ** 2).sum(axis=-1))
    return float((4 * np.arcsin(np.minimum(apart / 2, 1))).max())


def mass_properties(vertices: np.ndarray, triangles: np.ndarray, density: float) -> tuple[Fraction, list[list[Fraction]]]:
    """Returns the exact mass and inertia tensor about the centre of mass of a mesh with vertices at multiples of 2⁻²⁰."""
    scale = 2**20
    points = [[int(round(c * scale)) for c in vertex] for vertex in vertices.tolist()]
    assert all(p / scale == c for point, vertex in zip(points, vertices.tolist()) for p, c in zip(point, vertex))
    six, first, second = 0, [0] * 3, [[0] * 3 for _ in range(3)]
    for corners in triangles.tolist():
        a, b, c = (points[corner] for corner in corners)
        d = (
            a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
        )
        s = [a[k] + b[k] + c[k] for k in range(3)]
        six += d
        for i in range(3):
            first[i] += d * s[i]
            for j in range(i, 3):
                second[i][j] += d * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j])
    rho, volume = Fraction(density), Fraction(six, 6 * scale**3)
    center = [Fraction(x, 24 * scale**4) / volume for x in first]
    about = [[Fraction(second[min(i, j)][max(i, j)], 120 * scale**5) - volume * center[i] * center[j] for j in range(3)] for i in range(3)]
    trace = about[0][0] + about[1][1] + about[2][2]
    return rho * volume, [[rho * ((trace if i == j else 0) - about[i][j]) for j in range(3)] for i in range(3)]
