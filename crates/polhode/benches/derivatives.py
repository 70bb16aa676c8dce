#!/usr/bin/env python3
"""What derivatives cost, here and in heyoka, in one run: prints a table.

    pip install heyoka numpy
    cargo build --release -p polhode --example derivatives
    python3 crates/polhode/benches/derivatives.py

Both find the state transition matrix at the end: here by θ and ω, with the derivatives by the inertia tensor besides, in heyoka by
(ω, q), seven variables, and in a second run by three moments of inertia too. Times are the least of many runs, one process after the other;
compilation is not counted. Errors are the largest of Φ's elements relative to its largest, against heyoka in 80-bit numbers at 1e-18.
"""

import math
import subprocess
import time
from pathlib import Path

import heyoka as hy
import numpy as np

ROOT = Path(__file__).resolve().parents[3]
TARGETS = (1e-6, 1e-9, 1e-12)

# Moments, ω, the end; a tilt, a weight M g l, an orbit's n, a damping: those of work_precision.py.
PROBLEMS = {
    "A": ((1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0, 0.0, 0.0, 0.0, 0.0),
    "B": ((1.0, 1.0, 0.5), (0.0, 0.0, 5.0), 100.0, math.pi / 3, 1.0, 0.0, 0.0),
    "C-gg": ((1.0, 2.0, 2.5), (0.3, 0.5, 0.9), 20.0, 0.0, 0.0, 0.5, 0.0),
    "C-damp": ((1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0, 0.0, 0.0, 0.0, 0.05),
}


def equations(problem):
    """Seven, with the moments as parameters, and the variables."""
    _, _, _, _, weight, n, damping = PROBLEMS[problem]
    variables = hy.make_vars("w1", "w2", "w3", "a", "b", "c", "d")
    w1, w2, w3, a, b, c, d = variables
    i1, i2, i3 = hy.par[0], hy.par[1], hy.par[2]
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
    return list(zip(variables, rates)), variables


def start(problem, kind=float):
    _, omega, _, tilt, *_ = PROBLEMS[problem]
    half = kind(tilt) / 2
    if tilt and kind is np.longdouble:
        half = np.arctan2(np.longdouble(1), np.sqrt(np.longdouble(3)))
    return np.array([*omega, np.cos(half), np.sin(half), 0, 0], dtype=kind)


def integrator(problem, tolerance, what, kind=float):
    """Of the motion alone (what = None), of Φ ("start"), or with the moments too ("all")."""
    system, variables = equations(problem)
    if what:
        args = list(variables) + ([hy.par[0], hy.par[1], hy.par[2]] if what == "all" else [])
        system = hy.var_ode_sys(system, args, order=1)
    moments = [kind(i) for i in PROBLEMS[problem][0]]
    made = hy.taylor_adaptive(system, start(problem, kind), pars=moments, tol=kind(tolerance), fp_type=kind, compact_mode=bool(what) and what == "all")
    return made, np.array(made.state)


def run(made, first, end):
    made.time = 0.0
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
    """½ q ∘ v"""
    a, b, c, d = q
    x, y, z = v
    return np.array([-b * x - c * y - d * z, a * x + c * z - d * y, a * y + d * x - b * z, a * z + b * y - c * x]) / 2


def transition(made, columns):
    """Φ of θ and ω, of derivatives by (ω, q): θ = 2 q̄ ∘ δq."""
    state = np.array(made.state)
    by = state[7:].reshape(7, columns)[:, :7]
    q0, q = START[made_problem], state[3:7]
    phi = np.zeros((6, 6), dtype=state.dtype)
    for k in range(6):
        column = by[:, :3] @ np.eye(3)[k - 3] if k >= 3 else by[:, 3:7] @ turned(q0, np.eye(3)[k])
        a, b, c, d = q
        w, x, y, z = column[3:]
        phi[:3, k] = [2 * (a * x - b * w - c * z + d * y), 2 * (a * y - c * w - d * x + b * z), 2 * (a * z - d * w - b * y + c * x)]
        phi[3:, k] = column[:3]
    return phi


def error(phi, exact):
    return float(np.max(np.abs(phi - exact)) / np.max(np.abs(exact)))


def at(curve, target):
    """Seconds at an error: the least of all runs that are as good."""
    good = [seconds for seconds, wrong in curve if wrong <= target]
    return min(good) if good else math.nan


START = {}
made_problem = ""


def main():
    global made_problem
    command = [str(ROOT / "target/release/examples/derivatives")]
    ours = {}
    for line in subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines():
        name, tolerance, without, with_, numbers = line.split("\t")
        phi = np.array([float(x) for x in numbers.split()]).reshape(6, 6)
        ours.setdefault(name, []).append((float(tolerance), float(without), float(with_), phi))
    print("problem  error   here: motion, with derivatives (µs) | heyoka: motion, Φ, Φ and moments (µs) | here/heyoka by Φ, by all")
    for problem, (_, _, end, *_) in PROBLEMS.items():
        made_problem = problem
        START[problem] = start(problem, np.longdouble)[3:]
        truth, first = integrator(problem, 1e-18, "start", np.longdouble)
        run(truth, first, np.longdouble(end))
        exact = transition(truth, 7)
        START[problem] = start(problem)[3:]
        here = [(with_, error(phi, exact)) for _, _, with_, phi in ours[problem]]
        plain = [(without, error(phi, exact)) for _, without, _, phi in ours[problem]]
        theirs = {None: [], "start": [], "all": []}
        for exponent in (4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15):
            tolerance, wrong = 10.0**-exponent, math.nan
            for what in ("start", "all", None):
                made, first = integrator(problem, tolerance, what)
                seconds = least_of(0.06, made, first, end)
                if what:
                    wrong = error(transition(made, 7 if what == "start" else 10), exact)
                theirs[what].append((seconds, wrong))
        print(problem, "errors here", " ".join(f"{e:.1e}" for _, e in here), "| heyoka", " ".join(f"{e:.1e}" for _, e in theirs["start"]))
        for target in TARGETS:
            a, b = at(plain, target), at(here, target)
            c, d, e = [at(theirs[what], target) for what in (None, "start", "all")]
            micro = " ".join(f"{x * 1e6:8.1f}" for x in (a, b, c, d, e))
            print(f"{problem:7s} {target:.0e} {micro}   {b / d:.2f} {b / e:.2f}", flush=True)


if __name__ == "__main__":
    main()
