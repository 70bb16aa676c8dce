"""Free motion by SciPy: DOP853 at the smallest tolerance that it takes."""

import numpy as np
from scipy.integrate import solve_ivp


def prepare(moments, omega, times):
    a, b, c = moments

    def rate(_, state):
        x, y, z, q, i, j, k = state
        return [
            (b - c) / a * y * z,
            (c - a) / b * z * x,
            (a - b) / c * x * y,
            -0.5 * (i * x + j * y + k * z),
            0.5 * (q * x + j * z - k * y),
            0.5 * (q * y + k * x - i * z),
            0.5 * (q * z + i * y - j * x),
        ]

    return rate, np.array([*omega, 1.0, 0.0, 0.0, 0.0]), times


def solve(prepared):
    rate, start, times = prepared
    span = times[0], times[-1]
    states = solve_ivp(rate, span, start, "DOP853", t_eval=times, rtol=2.3e-14, atol=1e-15).y.T
    return states[:, :3], states[:, 3:]
