"""Many bodies under a torque of their own by heyoka: batches as wide as the vectors, a thread for each processor."""

import os
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy

import heyoka as hy
import numpy as np


def prepare(inertia, omega, time):
    x, y, z, q, i, j, k = variables = hy.make_vars(*"xyzqijk")
    a, b, c = (sum(row[n] * w for n, w in enumerate((x, y, z))) for row in inertia)
    torque = [0.1 * hy.sin(hy.time) - 0.05 * x - (y * c - z * b), -0.05 * y - (z * a - x * c), -0.05 * z - (x * b - y * a)]
    rates = [
        *(sum(row[n] * torque[n] for n in range(3)) for row in np.linalg.inv(inertia)),
        -0.5 * (i * x + j * y + k * z),
        0.5 * (q * x + j * z - k * y),
        0.5 * (q * y + k * x - i * z),
        0.5 * (q * z + i * y - j * x),
    ]
    batch = hy.recommended_simd_size()
    first = hy.taylor_adaptive_batch(list(zip(variables, rates)), np.ones((7, batch)))
    integrators = [first, *(deepcopy(first) for _ in range(len(os.sched_getaffinity(0)) - 1))]
    start = np.zeros((7, len(omega)))
    start[:3], start[3] = omega.T, 1.0
    return integrators, start, time


def solve(prepared):
    integrators, start, time = prepared
    states = np.empty_like(start)

    def propagate(integrator, members):
        for first in range(0, members.size, integrator.batch_size):
            batch = members[first : first + integrator.batch_size]
            integrator.set_time(0.0)
            integrator.state[:, : batch.size] = start[:, batch]
            integrator.propagate_until(time)
            states[:, batch] = integrator.state[:, : batch.size]

    with ThreadPoolExecutor(len(integrators)) as pool:
        list(pool.map(propagate, integrators, np.array_split(np.arange(start.shape[1]), len(integrators))))
    return states[:3].T, states[3:].T
