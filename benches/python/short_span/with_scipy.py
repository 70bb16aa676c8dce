"""One short step of many free bodies by SciPy: one system of all, whose rates NumPy computes at once, by DOP853."""

import numpy as np
from scipy.integrate import solve_ivp


def prepare(moments, omega, time):
    a, b, c = moments
    count = len(omega)

    def rate(_, state):
        x, y, z, q, i, j, k = state.reshape(7, count)
        rates = [
            (b - c) / a * y * z,
            (c - a) / b * z * x,
            (a - b) / c * x * y,
            -0.5 * (i * x + j * y + k * z),
            0.5 * (q * x + j * z - k * y),
            0.5 * (q * y + k * x - i * z),
            0.5 * (q * z + i * y - j * x),
        ]
        return np.concatenate(rates)

    start = np.zeros((7, count))
    start[:3], start[3] = omega.T, 1.0
    return rate, start.ravel(), time


def solve(prepared):
    rate, start, time = prepared
    states = solve_ivp(rate, (0.0, time), start, "DOP853", t_eval=[time], rtol=1e-12, atol=1e-12).y.reshape(7, -1)
    return states[:3].T, states[3:].T
