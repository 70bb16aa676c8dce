#!/usr/bin/env python3
"""Compares Taylor's method for batches of bodies with heyoka: ns per step of a body, on one core.

    pip install heyoka
    python3 crates/polhode/benches/ensemble_taylor.py [BODIES]

Runs `cargo bench -p polhode --bench ensemble_taylor`, then the same bodies with heyoka
(https://bluescarni.github.io/heyoka.py), whose integrators are built before the measurement. The
order of heyoka is 20 at its default tolerance 2.2e-16; that of polhode is 20 at 1e-8. Times are the
minimum of many runs.
"""

import math
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
MOMENTS, BATCH, END = (3.1, 4.2, 5.3), 8, 100.0


def equations(problem):
    """Returns the rates of ω in principal axes and of the attitude quaternion."""
    import heyoka as hy

    w1, w2, w3, q0, q1, q2, q3 = hy.make_vars("w1", "w2", "w3", "q0", "q1", "q2", "q3")
    i1, i2, i3 = MOMENTS
    n1 = n2 = n3 = 0.0
    if problem == "heavy top":
        n1, n2 = 2.0 * (q2 * q3 + q0 * q1), -2.0 * (q1 * q3 - q0 * q2)
    if problem == "gravity gradient":
        rate = 0.5
        c, s = hy.cos(rate * hy.time), hy.sin(rate * hy.time)
        r1 = (q0 * q0 + q1 * q1 - q2 * q2 - q3 * q3) * c + 2.0 * (q1 * q2 + q0 * q3) * s
        r2 = 2.0 * (q1 * q2 - q0 * q3) * c + (q0 * q0 - q1 * q1 + q2 * q2 - q3 * q3) * s
        r3 = 2.0 * (q1 * q3 + q0 * q2) * c + 2.0 * (q2 * q3 - q0 * q1) * s
        k = 3.0 * rate * rate
        n1, n2, n3 = k * (i3 - i2) * r2 * r3, k * (i1 - i3) * r3 * r1, k * (i2 - i1) * r1 * r2
    return [
        (w1, ((i2 - i3) * w2 * w3 + n1) / i1), (w2, ((i3 - i1) * w3 * w1 + n2) / i2),
        (w3, ((i1 - i2) * w1 * w2 + n3) / i3), (q0, -0.5 * (q1 * w1 + q2 * w2 + q3 * w3)),
        (q1, 0.5 * (q0 * w1 + q2 * w3 - q3 * w2)), (q2, 0.5 * (q0 * w2 - q1 * w3 + q3 * w1)),
        (q3, 0.5 * (q0 * w3 + q1 * w2 - q2 * w1)),
    ]


def heyoka(problem):
    """Returns order, steps per body, and ns per step of a body."""
    import heyoka as hy
    import numpy as np

    start = np.array([
        [0.3] * BATCH, [0.5 - 3e-4 * k for k in range(BATCH)], [0.9] * BATCH,
        [math.cos(0.5)] * BATCH, [math.sin(0.5)] * BATCH, [0.0] * BATCH, [0.0] * BATCH,
    ])
    bodies = hy.taylor_adaptive_batch(equations(problem), start.copy())
    least = float("inf")
    for _ in range(400):
        bodies.set_time(0.0)
        bodies.state[:] = start
        begin = time.perf_counter()
        bodies.propagate_until(END)
        least = min(least, time.perf_counter() - begin)
    steps = sum(result[3] for result in bodies.propagate_res)
    return bodies.order, steps / BATCH, least * 1e9 / steps


def main():
    command = ["cargo", "bench", "-q", "-p", "polhode", "--bench", "ensemble_taylor", "--", *sys.argv[1:]]
    print(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout, end="")
    for problem in ["free", "heavy top", "gravity gradient"]:
        order, steps, ns = heyoka(problem)
        print(f"{problem}\theyoka, order {order}\t{steps:.1f}\t{ns:.1f}")


if __name__ == "__main__":
    main()
