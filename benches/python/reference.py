"""Reference results, independent of polhode.

Motions by Taylor series in extended precision, masses of meshes by exact rational arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
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


#: Coefficient n of the torque's series along body axes (3, bodies), N·m, from n, the series of ω up to n, and the time of the step, s.
Law = Callable[[int, np.ndarray, np.longdouble], np.ndarray]


def drag_and_wave(drag: float, amplitude: float) -> Law:
    """Returns the law −``drag`` ω + (``amplitude`` sin t, 0, 0)."""

    def coefficient(n: int, omega: np.ndarray, now: np.longdouble) -> np.ndarray:
        torque = -REAL(drag) * omega[n]
        # dⁿ sin t/dtⁿ = sin (t + ½nπ)
        wave = [np.sin(now), np.cos(now), -np.sin(now), -np.cos(now)][n % 4]
        torque[0] += REAL(amplitude) * wave / REAL(math.factorial(n))
        return torque

    return coefficient


def saturated(limit: float, gain: float) -> Law:
    """Returns the law −``limit`` tanh (``gain`` ω), component by component."""
    series: list[np.ndarray] = []
    rest: list[np.ndarray] = []

    def coefficient(n: int, omega: np.ndarray, now: np.longdouble) -> np.ndarray:
        # y = tanh u, y′ = (1 − y²) u′
        if n == 0:
            series[:], rest[:] = [np.tanh(REAL(gain) * omega[0])], []
        else:
            terms = [(n - k) * REAL(gain) * omega[n - k] * rest[k] for k in range(n)]
            series.append(sum(terms[1:], terms[0]) / n)
        squares = [series[k] * series[n - k] for k in range(n + 1)]
        rest.append((1 if n == 0 else 0) - sum(squares[1:], squares[0]))
        return -REAL(limit) * series[n]

    return coefficient


def driven(inertia: Sequence[Sequence[float]], omega: np.ndarray, law: Law, times: Sequence[float], shorter: float = 1.0) -> np.ndarray:
    """Returns attitudes (times, bodies, 4) of bodies with these ω(0) (bodies, 3), rad/s, body axes, and the attitude (1, 0, 0, 0) at t = 0.

    ``inertia`` is the tensor of all, kg·m². ``shorter`` as in :func:`motion`.
    """
    if np.finfo(REAL).nmant < 63:
        raise SystemExit("the reference needs a long double of 64 bits or more, as x86-64 has it")
    tensor = np.array(inertia, REAL)
    cofactors = np.array([np.cross(tensor[(k + 1) % 3], tensor[(k + 2) % 3]) for k in range(3)])
    inverse = cofactors.T / (tensor[0] * cofactors[0]).sum()
    count = len(omega)
    state = np.zeros((7, count), REAL)
    state[:3], state[3] = np.asarray(omega, REAL).T, 1.0
    series = np.zeros((ORDER + 1, 7, count), REAL)
    momentum = np.zeros((ORDER + 1, 3, count), REAL)
    found = np.empty((len(times), count, 4), REAL)
    now, row = REAL(0.0), 0
    while row < len(times):
        series[0] = state
        for n in range(ORDER):
            momentum[n] = (tensor[:, :, None] * series[n, :3]).sum(axis=1)
            x, y, z, w, i, j, k = series.swapaxes(0, 1)
            a, b, c = momentum.swapaxes(0, 1)

            def product(one: np.ndarray, two: np.ndarray) -> np.ndarray:
                return (one[: n + 1] * two[n::-1]).sum(axis=0)

            # I ω′ = N − ω × L
            across = np.array([product(y, c) - product(z, b), product(z, a) - product(x, c), product(x, b) - product(y, a)])
            rates = [
                *(inverse[:, :, None] * (law(n, series[:, :3], now) - across)).sum(axis=1),
                -(product(i, x) + product(j, y) + product(k, z)) / 2,
                (product(w, x) + product(j, z) - product(k, y)) / 2,
                (product(w, y) + product(k, x) - product(i, z)) / 2,
                (product(w, z) + product(i, y) - product(j, x)) / 2,
            ]
            series[n + 1] = np.array(rates) / (n + 1)
        step = REAL(shorter) * (REAL(LAST) / np.abs(series[ORDER]).max()) ** (REAL(1) / ORDER)
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
