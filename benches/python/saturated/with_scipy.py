"""A body under a saturated law by SciPy: DOP853 at its tightest usual tolerance."""

from math import tanh

import numpy as np
from scipy.integrate import solve_ivp


def prepare(inertia, omega, times):
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = np.asarray(inertia).tolist()
    inverse = np.linalg.inv(inertia).tolist()

    def rate(t, state):
        x, y, z, q, i, j, k = state.tolist()
        a, b, c = xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z
        f, g, h = (-0.2 * tanh(3.0 * w) for w in (x, y, z))
        torque = [f - (y * c - z * b), g - (z * a - x * c), h - (x * b - y * a)]
        return [
            *(row[0] * torque[0] + row[1] * torque[1] + row[2] * torque[2] for row in inverse),
            -0.5 * (i * x + j * y + k * z),
            0.5 * (q * x + j * z - k * y),
            0.5 * (q * y + k * x - i * z),
            0.5 * (q * z + i * y - j * x),
        ]

    return rate, [*omega, 1.0, 0.0, 0.0, 0.0], times


def solve(prepared):
    rate, start, times = prepared
    states = solve_ivp(rate, (times[0], times[-1]), start, "DOP853", t_eval=times, rtol=1e-13, atol=1e-13).y
    return states[:3].T, states[3:].T
