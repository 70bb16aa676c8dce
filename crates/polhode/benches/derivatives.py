#!/usr/bin/env python3
"""Measures the cost of derivatives in polhode and in heyoka and prints a table.

    pip install heyoka numpy
    cargo build --release -p polhode --example derivatives
    python3 crates/polhode/benches/derivatives.py

Both compute the state transition matrix at the end. polhode differentiates with respect to θ and ω
and to the six elements of the inertia tensor, twelve columns. heyoka differentiates with respect to
(ω, q), seven columns. Times are the minimum of many runs, one process after the other, without
compilation. The error is the largest error of an element of Φ relative to its largest element,
compared with heyoka in 80-bit numbers at 1e-18.
"""

import math
import subprocess
import time
from pathlib import Path

import heyoka as hy
import numpy as np

ROOT = Path(__file__).resolve().parents[3]

# Moments, ω, end time; tilt, weight M g l, orbital rate n, damping: as in work_precision.py.
PROBLEMS = {
    "A": ((1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0, 0.0, 0.0, 0.0, 0.0),
    "B": ((1.0, 1.0, 0.5), (0.0, 0.0, 5.0), 100.0, math.pi / 3, 1.0, 0.0, 0.0),
    "C-gg": ((1.0, 2.0, 2.5), (0.3, 0.5, 0.9), 20.0, 0.0, 0.0, 0.5, 0.0),
    "C-damp": ((1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0, 0.0, 0.0, 0.0, 0.05),
}


def equations(problem):
    """Returns the rates of ω and q."""
    (i1, i2, i3), _, _, _, weight, n, damping = PROBLEMS[problem]
    variables = hy.make_vars("w1", "w2", "w3", "a", "b", "c", "d")
    w1, w2, w3, a, b, c, d = variables
    n1, n2, n3 = [-damping * w for w in (w1, w2, w3)]
    if weight:
        n1, n2 = n1 + weight * 2.0 * (c * d + a * b), n2 - weight * 2.0 * (b * d - a * c)
    if n:
        x, y = hy.cos(n * hy.time), hy.sin(n * hy.time)
        u1 = (a * a + b * b - c * c - d * d) * x + 2.0 * (b * c + a * d) * y
        u2 = 2.0 * (b * c - a * d) * x + (a * a - b * b + c * c - d * d) * y
        u3 = 2.0 * (b * d + a * c) * x + 2.0 * (c * d - a * b) * y
        f = 3.0 * n * n
        n1, n2, n3 = n1 + f * (i3 - i2) * u2 * u3, n2 + f * (i1 - i3) * u3 * u1, n3 + f * (i2 - i1) * u1 * u2
    rates = [((i2 - i3) * w2 * w3 + n1) / i1, ((i3 - i1) * w3 * w1 + n2) / i2, ((i1 - i2) * w1 * w2 + n3) / i3,
             -0.5 * (b * w1 + c * w2 + d * w3), 0.5 * (a * w1 + c * w3 - d * w2),
             0.5 * (a * w2 + d * w1 - b * w3), 0.5 * (a * w3 + b * w2 - c * w1)]
    return list(zip(variables, rates))


def start(problem, kind=float):
    _, omega, _, tilt, *_ = PROBLEMS[problem]
    half = kind(tilt) / 2
    if tilt and kind is np.longdouble:
        half = np.arctan2(np.longdouble(1), np.sqrt(np.longdouble(3)))
    return np.array([*omega, np.cos(half), np.sin(half), 0, 0], dtype=kind)


def integrator(problem, tolerance, kind=float, compact=False):
    """Returns a compiled integrator of the variational equations, and its initial state."""
    system = hy.var_ode_sys(equations(problem), hy.var_args.vars, order=1)
    made = hy.taylor_adaptive(system, start(problem, kind), tol=kind(tolerance), fp_type=kind, compact_mode=compact)
    return made, np.array(made.state)


def run(made, first, end):
    made.time = type(end)(0)
    made.state[:] = first
    made.propagate_until(end)


def least_of(seconds, made, first, end):
    least, begin = math.inf, time.perf_counter()
    while time.perf_counter() - begin < seconds or least == math.inf:
        once = time.perf_counter()
        run(made, first, end)
        least = min(least, time.perf_counter() - once)
    return least


def turned(q, v):
    """Returns ½ q ∘ v."""
    a, b, c, d = q
    x, y, z = v
    return np.array([-b * x - c * y - d * z, a * x + c * z - d * y, a * y + d * x - b * z, a * z + b * y - c * x]) / 2


def transition(made, q0):
    """Returns Φ for θ and ω from derivatives with respect to (ω, q): θ = 2 q̄ ∘ δq."""
    state = np.array(made.state)
    by, (a, b, c, d) = state[7:].reshape(7, 7), state[3:7]
    phi = np.zeros((6, 6), dtype=state.dtype)
    for k in range(6):
        column = by[:, k - 3] if k >= 3 else by[:, 3:] @ turned(q0, np.eye(3)[k])
        w, x, y, z = column[3:]
        phi[:3, k] = [2 * (a * x - b * w - c * z + d * y), 2 * (a * y - c * w - d * x + b * z), 2 * (a * z - d * w - b * y + c * x)]
        phi[3:, k] = column[:3]
    return phi


def error(phi, exact):
    return float(np.max(np.abs(phi - exact)) / np.max(np.abs(exact)))


def at(curve, target):
    """Returns the time at an error, s, by log-log interpolation; NaN outside the range of runs."""
    errors, seconds = np.log([[wrong, seconds] for seconds, wrong in sorted(curve, key=lambda run: run[1])]).T
    return math.exp(np.interp(math.log(target), errors, seconds, left=math.nan, right=math.nan))


def main():
    command = [str(ROOT / "target/release/examples/derivatives")]
    ours = {}
    for line in subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines():
        name, _, without, with_, numbers = line.split("\t")
        phi = np.array([float(x) for x in numbers.split()]).reshape(6, 6)
        ours.setdefault(name, []).append((float(without), float(with_), phi))
    print("problem, error of heyoka's run, at which: µs here without and with derivatives, in heyoka with Φ, here/heyoka")
    for problem, (_, _, end, *_) in PROBLEMS.items():
        truth, first = integrator(problem, 1e-18, np.longdouble, True)
        run(truth, first, np.longdouble(end))
        exact = transition(truth, start(problem, np.longdouble)[3:])
        here = [(with_, error(phi, exact)) for _, with_, phi in ours[problem]]
        alone = [(without, error(phi, exact)) for without, _, phi in ours[problem]]
        there = []
        for exponent in (5, 7, 9, 11, 13):
            made, first = integrator(problem, 10.0**-exponent)
            there.append((least_of(0.1, made, first, end), error(transition(made, start(problem)[3:]), exact)))
        for seconds, wrong in there:
            a, b = at(alone, wrong), at(here, wrong)
            print(f"{problem:7s} {wrong:.0e} {a * 1e6:8.1f} {b * 1e6:8.1f} {seconds * 1e6:8.1f} {b / seconds:6.2f}", flush=True)


if __name__ == "__main__":
    main()
