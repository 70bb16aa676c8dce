"""A body under a saturated law by heyoka: Taylor's method, compiled for these equations."""

import heyoka as hy
import numpy as np


def prepare(inertia, omega, times):
    x, y, z, q, i, j, k = variables = hy.make_vars(*"xyzqijk")
    a, b, c = (sum(row[n] * w for n, w in enumerate((x, y, z))) for row in inertia)
    f, g, h = (-0.2 * hy.tanh(3.0 * w) for w in (x, y, z))
    torque = [f - (y * c - z * b), g - (z * a - x * c), h - (x * b - y * a)]
    rates = [
        *(sum(row[n] * torque[n] for n in range(3)) for row in np.linalg.inv(inertia)),
        -0.5 * (i * x + j * y + k * z),
        0.5 * (q * x + j * z - k * y),
        0.5 * (q * y + k * x - i * z),
        0.5 * (q * z + i * y - j * x),
    ]
    start = np.array([*omega, 1.0, 0.0, 0.0, 0.0])
    return hy.taylor_adaptive(list(zip(variables, rates)), start), start, times


def solve(prepared):
    integrator, start, times = prepared
    integrator.time = 0.0
    integrator.state[:] = start
    states = integrator.propagate_grid(times)[-1]
    return states[:, :3], states[:, 3:]
