"""A heavy top by SciPy: DOP853 at the smallest tolerance that it takes."""

from scipy.integrate import solve_ivp


def prepare(moments, mass, gravity, omega, attitude, time):
    a, b, c = moments[0] + mass, moments[1] + mass, moments[2]  # about the pivot, 1 m below
    weight = mass * gravity

    def rate(_, state):
        x, y, z, q, i, j, k = state
        return [
            ((b - c) * y * z + 2.0 * weight * (j * k + q * i)) / a,
            ((c - a) * z * x - 2.0 * weight * (i * k - q * j)) / b,
            (a - b) / c * x * y,
            -0.5 * (i * x + j * y + k * z),
            0.5 * (q * x + j * z - k * y),
            0.5 * (q * y + k * x - i * z),
            0.5 * (q * z + i * y - j * x),
        ]

    return rate, [*omega, *attitude], time


def solve(prepared):
    rate, start, time = prepared
    return solve_ivp(rate, (0.0, time), start, "DOP853", rtol=2.3e-14, atol=1e-15).y[3:, -1]
