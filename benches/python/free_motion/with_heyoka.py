"""Free motion by heyoka: Taylor's method at its own tolerance."""

import heyoka as hy


def prepare(moments, omega, times):
    a, b, c = moments
    x, y, z, q, i, j, k = variables = hy.make_vars(*"xyzqijk")
    rates = [
        (b - c) / a * y * z,
        (c - a) / b * z * x,
        (a - b) / c * x * y,
        -0.5 * (i * x + j * y + k * z),
        0.5 * (q * x + j * z - k * y),
        0.5 * (q * y + k * x - i * z),
        0.5 * (q * z + i * y - j * x),
    ]
    start = [*omega, 1.0, 0.0, 0.0, 0.0]
    return hy.taylor_adaptive(list(zip(variables, rates)), start), start, times


def solve(prepared):
    integrator, start, times = prepared
    integrator.time = 0.0
    integrator.state[:] = start
    states = integrator.propagate_grid(times)[-1]
    return states[:, :3], states[:, 3:]
