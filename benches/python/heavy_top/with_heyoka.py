"""A heavy top by heyoka: Taylor's method at its own tolerance."""

import heyoka as hy


def prepare(moments, mass, gravity, omega, attitude, time):
    a, b, c = moments[0] + mass, moments[1] + mass, moments[2]  # about the pivot, 1 m below
    x, y, z, q, i, j, k = variables = hy.make_vars(*"xyzqijk")
    weight = mass * gravity
    rates = [
        ((b - c) * y * z + 2.0 * weight * (j * k + q * i)) / a,
        ((c - a) * z * x - 2.0 * weight * (i * k - q * j)) / b,
        (a - b) / c * x * y,
        -0.5 * (i * x + j * y + k * z),
        0.5 * (q * x + j * z - k * y),
        0.5 * (q * y + k * x - i * z),
        0.5 * (q * z + i * y - j * x),
    ]
    start = [*omega, *attitude]
    return hy.taylor_adaptive(list(zip(variables, rates)), start), start, time


def solve(prepared):
    integrator, start, time = prepared
    integrator.time = 0.0
    integrator.state[:] = start
    integrator.propagate_until(time)
    return integrator.state[3:]
