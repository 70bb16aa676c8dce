#!/usr/bin/env python3
"""Measures the cost of accuracy in polhode and other programs.

Writes book/work-precision.md and its figures.

    pip install heyoka scipy mujoco mpmath numpy
    python3 crates/polhode/benches/work_precision.py

All programs run in this process or are started by it, one after the other, in rounds. A time is the
minimum over all rounds, without set-up: compilation (heyoka, numba) and models (MuJoCo). Errors are
relative to a Taylor series with 40 digits, in this file. With numba, SciPy's right-hand sides are
compiled; without it they are plain Python, and the page states this.
"""

import math
import os
import platform
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
ROUNDS = 3
DIGITS = 40
TARGETS = (1e-6, 1e-9, 1e-12)
# Tolerances at which the two Taylor methods are compared.
EQUAL = (1e-6, 1e-9, 1e-12, 1e-15)


class Problem:
    """A test problem: inertia I, initial ω and q = (w, x, y, z), end time, and torques.

    The torques are a weight M g l along e3, an orbital rate n, a damping c, and a wave (a sin t, 0, 0).
    """

    def __init__(self, name, title, moments, omega, end, tilt=0.0, weight=0.0, orbit=0.0, damping=0.0, wave=0.0):
        self.name, self.title, self.moments, self.omega, self.end = name, title, moments, omega, end
        self.tilt, self.weight, self.orbit, self.damping, self.wave = tilt, weight, orbit, damping, wave

    def start(self):
        return [*self.omega, math.cos(self.tilt / 2), math.sin(self.tilt / 2), 0.0, 0.0]


PROBLEMS = [
    Problem("A", "A: a free body, 100 s", (1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0),
    Problem("B", "B: a heavy top, 100 s", (1.0, 1.0, 0.5), (0.0, 0.0, 5.0), 100.0, tilt=math.pi / 3, weight=1.0),
    Problem("C-gg", "C-gg: gravity gradient, 20 s", (1.0, 2.0, 2.5), (0.3, 0.5, 0.9), 20.0, orbit=0.5),
    Problem("C-damp", "C-damp: damping, 100 s", (1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0, damping=0.05),
    Problem("C-law", "C-law: damping and a wave, as formulas, 100 s", (1.0, 2.0, 3.0), (0.3, 0.5, 0.9), 100.0, damping=0.05, wave=0.1),
]


HEAVY_TOP = PROBLEMS[1]
# Problem B with other spins. At the tightest tolerance only rounding errors remain, and one start is
# one sample of these.
TOPS = [Problem(f"top {k}", "", (1.0, 1.0, 0.5), (0.0, 0.0, 5.0 + 0.01 * k), 100.0, tilt=math.pi / 3, weight=1.0) for k in range(12)]


# Reference solution


def truth(problem):
    """Returns the quaternion at the end to about 35 digits.

    It is computed by Taylor series with a last term below 10^-DIGITS.

    u and v are space directions along body axes. With a weight, u is the vertical, u̇ = u × ω. On
    an orbit, u is the direction to the body and v that along its path, u̇ = u × ω + n v,
    v̇ = v × ω − n u.
    """
    from mpmath import cos, fdot, mp, mpf, sin

    mp.dps = DIGITS + 8
    order = DIGITS + 6
    i1, i2, i3 = map(mpf, problem.moments)
    n, weight, damping, wave = mpf(problem.orbit), mpf(problem.weight), mpf(problem.damping), mpf(problem.wave)
    # The tilt is exactly 60°.
    half = mp.pi / 6 if problem.tilt else mpf(0)
    q = [cos(half), sin(half), mpf(0), mpf(0)]
    omega = [mpf(w) for w in problem.omega]
    u, v = seen_from_body(q, (0, 0, 1) if weight else (1, 0, 0)), seen_from_body(q, (0, 1, 0))
    state = [*omega, *q, *u, *v]
    t, end = mpf(0), mpf(problem.end)
    while t < end:
        s = [[x] for x in state]
        sines = [sin(t), cos(t), -sin(t), -cos(t)]
        w, qs, us, vs = s[0:3], s[3:7], s[7:10], s[10:13]
        product = lambda a, b, k: fdot(a[: k + 1], b[k::-1])
        for k in range(order):
            torque = [mpf(0)] * 3
            if weight:
                torque = [weight * us[1][k], -weight * us[0][k], mpf(0)]
            if n:
                f = 3 * n * n
                torque = [f * (i3 - i2) * product(us[1], us[2], k), f * (i1 - i3) * product(us[2], us[0], k),
                          f * (i2 - i1) * product(us[0], us[1], k)]
            torque = [a - damping * w[j][k] for j, a in enumerate(torque)]
            torque[0] += wave * sines[k % 4] / math.factorial(k)
            rate = [((i2 - i3) * product(w[1], w[2], k) + torque[0]) / i1, ((i3 - i1) * product(w[2], w[0], k) + torque[1]) / i2,
                    ((i1 - i2) * product(w[0], w[1], k) + torque[2]) / i3]
            a, b, c, d = qs
            x, y, z = w
            rate += [-(product(b, x, k) + product(c, y, k) + product(d, z, k)) / 2,
                     (product(a, x, k) + product(c, z, k) - product(d, y, k)) / 2,
                     (product(a, y, k) + product(d, x, k) - product(b, z, k)) / 2,
                     (product(a, z, k) + product(b, y, k) - product(c, x, k)) / 2]
            if weight or n:
                for this, other, sign in ((us, vs, 1), (vs, us, -1)):
                    e, g, h = this
                    cross = [product(g, z, k) - product(h, y, k), product(h, x, k) - product(e, z, k),
                             product(e, y, k) - product(g, x, k)]
                    rate += [c + sign * n * other[j][k] for j, c in enumerate(cross)]
            else:
                rate += [mpf(0)] * 6
            for series, r in zip(s, rate):
                series.append(r / (k + 1))
        last = max(abs(series[order]) ** (mpf(1) / order) for series in s)
        h = min(mpf(10) ** (-mpf(DIGITS) / order) / last, end - t)
        state = [sum_of(series, h) for series in s]
        t += h
    norm = mp.sqrt(sum(x * x for x in state[3:7]))
    return [x / norm for x in state[3:7]]


def sum_of(series, h):
    total = series[-1]
    for c in series[-2::-1]:
        total = total * h + c
    return total


def matrix(q):
    a, b, c, d = q
    return [[a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d]]


def seen_from_body(q, v):
    """Returns a space vector along body axes."""
    m = matrix(q)
    return [sum(m[i][k] * v[i] for i in range(3)) for k in range(3)]


def angle(q, exact):
    """Returns the angle between two attitudes, rad."""
    from mpmath import asin, mp, mpf, sqrt

    mp.dps = DIGITS
    a = [mpf(float(c)) for c in q]
    norm = sqrt(sum(c * c for c in a))
    a = [c / norm for c in a]
    sign = 1 if sum(c * d for c, d in zip(a, exact)) > 0 else -1
    return float(4 * asin(min(mpf(1), sqrt(sum((c - sign * d) ** 2 for c, d in zip(a, exact))) / 2)))


# Programs: each returns {(problem, method, tolerance or step): (seconds, quaternion)}


def polhode():
    command = ["cargo", "run", "--release", "-q", "-p", "polhode", "--example", "work_precision"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    runs = {}
    for line in text.splitlines():
        name, method, size, seconds, _, q = line.split("\t")
        runs[name, f"polhode {method}", float(size)] = (float(seconds), [float(c) for c in q.split()])
    return runs


def least_of(seconds, run):
    """Returns the minimum time of runs with this total duration, and the result of the last one."""
    least, result, begin = float("inf"), None, time.perf_counter()
    while result is None or time.perf_counter() - begin < seconds:
        once = time.perf_counter()
        result = run()
        least = min(least, time.perf_counter() - once)
    return least, result


def heyoka_integrators():
    """Builds the integrators before the measurement: (problem, tolerance) → integrator."""
    import heyoka as hy

    w1, w2, w3, a, b, c, d = hy.make_vars("w1", "w2", "w3", "a", "b", "c", "d")
    built = {}
    for problem in PROBLEMS:
        i1, i2, i3 = problem.moments
        n1, n2, n3 = [-problem.damping * w for w in (w1, w2, w3)]
        if problem.wave:
            n1 = n1 + problem.wave * hy.sin(hy.time)
        if problem.weight:
            n1, n2 = n1 + problem.weight * 2.0 * (c * d + a * b), n2 - problem.weight * 2.0 * (b * d - a * c)
        if problem.orbit:
            n = problem.orbit
            u1, u2, u3 = seen_from_body((a, b, c, d), (hy.cos(n * hy.time), hy.sin(n * hy.time), 0.0))
            f = 3.0 * n * n
            n1, n2, n3 = n1 + f * (i3 - i2) * u2 * u3, n2 + f * (i1 - i3) * u3 * u1, n3 + f * (i2 - i1) * u1 * u2
        equations = [
            (w1, ((i2 - i3) * w2 * w3 + n1) / i1), (w2, ((i3 - i1) * w3 * w1 + n2) / i2), (w3, ((i1 - i2) * w1 * w2 + n3) / i3),
            (a, -0.5 * (b * w1 + c * w2 + d * w3)), (b, 0.5 * (a * w1 + c * w3 - d * w2)),
            (c, 0.5 * (a * w2 + d * w1 - b * w3)), (d, 0.5 * (a * w3 + b * w2 - c * w1)),
        ]
        for tolerance in {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 2.2e-16, *EQUAL}:
            built[problem, tolerance] = hy.taylor_adaptive(equations, problem.start(), tol=tolerance)
    return built | {(top, tolerance): built[HEAVY_TOP, tolerance] for top in TOPS for tolerance in EQUAL}


def heyoka(built):
    runs = {}
    for (problem, tolerance), integrator in built.items():
        start = problem.start()

        def run():
            integrator.time = 0.0
            integrator.state[:] = start
            integrator.propagate_until(problem.end)

        seconds, _ = least_of(0.06, lambda: run() or True)
        runs[problem.name, "heyoka", tolerance] = (seconds, [float(c) for c in integrator.state[3:7]])
    return runs


def heyoka_call(built):
    """Returns the time in s of a run without a step: the call from Python and the reset."""
    integrator, start = built[HEAVY_TOP, EQUAL[0]], HEAVY_TOP.start()

    def run():
        integrator.time = 0.0
        integrator.state[:] = start
        integrator.propagate_until(0.0)

    return least_of(0.1, lambda: run() or True)[0]


def right_hand_side(problem):
    """Returns ẏ of (ω, q) for SciPy, and True if it is compiled."""
    i1, i2, i3 = problem.moments
    weight, orbit, damping, wave = problem.weight, problem.orbit, problem.damping, problem.wave

    def f(t, y):
        w1, w2, w3, a, b, c, d = y[0], y[1], y[2], y[3], y[4], y[5], y[6]
        n1, n2, n3 = -damping * w1 + wave * math.sin(t), -damping * w2, -damping * w3
        if weight != 0.0:
            n1 += weight * 2.0 * (c * d + a * b)
            n2 -= weight * 2.0 * (b * d - a * c)
        if orbit != 0.0:
            x, y0 = math.cos(orbit * t), math.sin(orbit * t)
            u1 = (a * a + b * b - c * c - d * d) * x + 2.0 * (b * c + a * d) * y0
            u2 = 2.0 * (b * c - a * d) * x + (a * a - b * b + c * c - d * d) * y0
            u3 = 2.0 * (b * d + a * c) * x + 2.0 * (c * d - a * b) * y0
            g = 3.0 * orbit * orbit
            n1 += g * (i3 - i2) * u2 * u3
            n2 += g * (i1 - i3) * u3 * u1
            n3 += g * (i2 - i1) * u1 * u2
        out = np.empty(7)
        out[0] = ((i2 - i3) * w2 * w3 + n1) / i1
        out[1] = ((i3 - i1) * w3 * w1 + n2) / i2
        out[2] = ((i1 - i2) * w1 * w2 + n3) / i3
        out[3] = -0.5 * (b * w1 + c * w2 + d * w3)
        out[4] = 0.5 * (a * w1 + c * w3 - d * w2)
        out[5] = 0.5 * (a * w2 + d * w1 - b * w3)
        out[6] = 0.5 * (a * w3 + b * w2 - c * w1)
        return out

    try:
        from numba import njit
    except ImportError:
        return f, False
    compiled = njit(f)
    compiled(0.0, np.array(problem.start()))
    return compiled, True


def scipy(functions):
    from scipy.integrate import solve_ivp

    runs = {}
    for problem, f in functions.items():
        for tolerance in (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 2.3e-14):
            run = lambda: solve_ivp(f, (0.0, problem.end), problem.start(), method="DOP853", rtol=tolerance, atol=tolerance)
            seconds, result = least_of(0.0, run)
            runs[problem.name, "SciPy DOP853", tolerance] = (seconds, [float(c) for c in result.y[3:7, -1]])
    return runs


def mujoco():
    """Runs a body on a ball joint.

    The gravity gradient and the wave are omitted: they would be Python callbacks, not MuJoCo.
    """
    import mujoco as mj

    runs = {}
    for problem in PROBLEMS:
        if problem.orbit or problem.wave:
            continue
        mass = 1e-3 if problem.weight else 1.0
        lever = 1.0 if problem.weight else 0.0
        inertia = [i - mass * lever * lever * (k < 2) for k, i in enumerate(problem.moments)]
        for exponent in range(1, 6 if problem.weight else 5):
            step = 0.1 * 4.0**-(exponent - 1)
            count = math.ceil(problem.end / step)
            model = mj.MjModel.from_xml_string(f"""<mujoco><option integrator="RK4" timestep="{problem.end / count!r}"
                gravity="0 0 {-1e3 if problem.weight else 0}"><flag contact="disable" energy="disable"/></option><worldbody>
                <body><joint type="ball" damping="{problem.damping}"/><inertial pos="0 0 {lever}" mass="{mass}"
                diaginertia="{' '.join(map(repr, inertia))}"/></body></worldbody></mujoco>""")
            data = mj.MjData(model)

            def run():
                mj.mj_resetData(model, data)
                data.qpos[:], data.qvel[:] = problem.start()[3:], problem.omega
                mj.mj_step(model, data, nstep=count)
                return data.qpos.copy()

            seconds, q = least_of(0.0, run)
            runs[problem.name, "MuJoCo RK4", step] = (seconds, [float(c) for c in q])
    return runs


# Page


STYLES = {  # colour, dashes
    "polhode exact": ("#000000", ""),
    "polhode taylor": ("#d55e00", ""),
    "polhode dop853": ("#e69f00", ""),
    "polhode splitting 2": ("#56b4e9", ""),
    "polhode splitting 4": ("#009e73", ""),
    "polhode splitting 6": ("#0072b2", ""),
    "heyoka": ("#cc79a7", "7 2.5"),
    "SciPy DOP853": ("#6e7781", "7 2.5"),
    "MuJoCo RK4": ("#6e7781", "1.6 2.4"),
}


def figure(problem, curves):
    """Plots attitude error against time, both logarithmic: lower left is better."""
    left, right, top, bottom, width, height = 66, 500, 52, 362, 672, 413
    points = [point for curve in curves.values() for point in curve if 0 < point[1]]
    x0, x1 = [f(math.log10(p[0])) for f, p in ((math.floor, min(points)), (math.ceil, max(points)))]
    y0, y1 = -16, 0
    x = lambda seconds: left + (math.log10(seconds) - x0) / (x1 - x0) * (right - left)
    y = lambda error: bottom - (min(max(math.log10(max(error, 1e-99)), y0), y1) - y0) / (y1 - y0) * (bottom - top)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
           "font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"11.5\" fill=\"none\" "
           'stroke-linecap="round" stroke-linejoin="round">',
           f"<title>{problem.title}: attitude error against time</title>", f'<rect width="{width}" height="{height}" fill="#fff"/>',
           f'<text x="14" y="27.5" fill="#1f2328" font-size="13.5">{problem.title}</text>']
    for k in range(x0, x1 + 1):
        at = x(10.0**k)
        name = {0: "1 s", -3: "1 ms", -6: "1 µs"}.get(k) or {0: "", 1: "10", 2: "100"}[k % 3] + {-1: " ms", -2: " µs", -3: " ns"}.get(k // 3, " s")
        out.append(f'<path d="M{at:.1f} {top}L{at:.1f} {bottom}" stroke="#e3e7eb" stroke-width="0.8"/>'
                   f'<text x="{at:.1f}" y="{bottom + 17}" fill="#3d444d" text-anchor="middle">{name}</text>')
    for k in range(y0, y1 + 1, 2):
        at = y(10.0**k)
        out.append(f'<path d="M{left} {at:.1f}L{right} {at:.1f}" stroke="#e3e7eb" stroke-width="0.8"/>'
                   f'<text x="{left - 8}" y="{at + 4:.1f}" fill="#3d444d" text-anchor="end">1e{k}</text>')
    out.append(f'<text x="{left}" y="{top - 9}" fill="#6e7781">attitude error, rad</text>'
               f'<text x="{right}" y="{height - 14}" fill="#6e7781" text-anchor="end">time of the run</text>')
    for row, (name, curve) in enumerate(curves.items()):
        colour, dashes = STYLES[name]
        stroke = f'stroke="{colour}" stroke-width="1.7"' + (f' stroke-dasharray="{dashes}" stroke-linecap="butt"' if dashes else "")
        shown = [(x(seconds), y(error)) for seconds, error in curve]
        path = "M" + "L".join(f"{a:.1f} {b:.1f}" for a, b in shown)
        out.append(f'<path d="{path}" {stroke}/>' if len(shown) > 1 else "")
        out += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="2.2" fill="{colour}"/>' for a, b in shown]
        at = top + 10 + 19 * row
        out.append(f'<path d="M{right + 18} {at}L{right + 42} {at}" {stroke}/>'
                   f'<text x="{right + 48}" y="{at + 4}" fill="#3d444d">{name}</text>')
    return "\n".join(line for line in out if line) + "\n</svg>\n"


def table(curves):
    """Returns ms of the fastest run that reaches each target."""
    rows = []
    for name, curve in curves.items():
        cells = []
        for target in TARGETS:
            reached = [seconds for seconds, error in curve if error <= target]
            cells.append(f"{min(reached) * 1e3:.2g}" if reached else "–")
        rows.append(f"| {name} | {' | '.join(cells)} | {min(error for _, error in curve):.0e} |")
    return "\n".join(rows)


def equal_tolerance(runs, exact):
    """Returns the rows of the table of both Taylor methods.

    The twelve tops give the median time and error at the tightest tolerance.
    """

    def middle(values):
        return sorted(values)[len(values) // 2]

    rows = []
    for name, problems in [*((problem.name, [problem]) for problem in PROBLEMS), ("twelve tops", TOPS)]:
        for tolerance in EQUAL if len(problems) == 1 else EQUAL[-1:]:
            sides = [[runs[problem.name, method, tolerance] for problem in problems] for method in ("polhode taylor", "heyoka")]
            times = [middle([seconds for seconds, _ in side]) * 1e6 for side in sides]
            errors = [middle([angle(q, exact[problem.name]) for problem, (_, q) in zip(problems, side)]) for side in sides]
            rows.append(f"| {name} | {tolerance:.0e} | {times[0]:.3g}, {times[1]:.3g} | **{times[0] / times[1]:.2f}** "
                        f"| {errors[0]:.0e}, {errors[1]:.0e} |")
    return "\n".join(rows)


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def versions():
    from importlib.metadata import version

    return ", ".join(f"{name} {version(package)}" for name, package in
                     [("heyoka", "heyoka"), ("SciPy", "scipy"), ("MuJoCo", "mujoco"), ("NumPy", "numpy")])


def main():
    def first(*command):
        return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()

    exact = {problem.name: truth(problem) for problem in PROBLEMS}
    exact |= {top.name: truth(top) for top in TOPS}
    built = heyoka_integrators()
    functions = {problem: right_hand_side(problem) for problem in PROBLEMS}
    is_compiled = all(compiled for _, compiled in functions.values())
    functions = {problem: f for problem, (f, _) in functions.items()}
    polhode()  # builds
    # Alternating rounds average over changes of the machine's speed.
    runs, call = {}, math.inf
    for _ in range(ROUNDS):
        call = min(call, heyoka_call(built))
        for found in (polhode(), heyoka(built), scipy(functions), mujoco()):
            for key, (seconds, q) in found.items():
                runs[key] = (min(seconds, runs.get(key, (math.inf,))[0]), q)

    sections = []
    for problem in PROBLEMS:
        of_problem = sorted(((key, found) for key, found in runs.items() if key[0] == problem.name), key=lambda run: -run[0][2])
        curves = {name: [(seconds, angle(q, exact[problem.name])) for (_, method, _), (seconds, q) in of_problem if method == name]
                  for name in STYLES}
        curves = {name: curve for name, curve in curves.items() if curve}
        path = f"figures/work-precision-{problem.name.lower()}.svg"
        (ROOT / "book" / path).write_text(figure(problem, curves))
        sections.append(f"""## {problem.title}

![Error against time: {problem.name}]({path})

| ms to an attitude error of | {" | ".join(f"{target:.0e}" for target in TARGETS)} | least error |
|---|---|---|---|---|
{table(curves)}
""")

    load = os.getloadavg()[0]
    busy = f"\n\n**The machine was busy (load {load:.0f}): times are too long, and not all alike.**" if load > 2.0 else ""
    note = "compiled by numba" if is_compiled else "in plain Python: compiled by numba they are several times faster"
    page = f"""# Cost of accuracy under torque, compared with other programs

Written by `crates/polhode/benches/work_precision.py`. Time to one state at the end, against the angle (rad) from
the true attitude, a Taylor series in {DIGITS} digits. Each point is a tolerance or step; lower left is better. Times are the
least of {ROUNDS} round{'s' * (ROUNDS > 1)} on one core, without set-up and compilation.{busy}

{processor()}, {first("rustc", "--version")}, commit {first("git", "rev-parse", "--short", "HEAD")}, {versions()}, Python {platform.python_version()}.

SciPy's right-hand sides are {note}. MuJoCo has no gravity gradient and no wave;
`splitting` takes no damping.

{chr(10).join(sections)}
## The problems

ω along body axes, q from body to space, 1 at the start unless given; I ω̇ = (I ω) × ω + N.

| | I, kg·m² | ω at the start, rad/s | N |
|---|---|---|---|
| A | 1, 2, 3 | 0.3, 0.5, 0.9 | 0 |
| B | 1, 1, 0.5 | 0, 0, 5; tilted by 60° | of the weight, M g l = 1 N·m |
| C-gg | 1, 2, 2.5 | 0.3, 0.5, 0.9 | 3n² r × I r, r = (cos nt, sin nt, 0) in space, n = 0.5 rad/s |
| C-damp | 1, 2, 3 | 0.3, 0.5, 0.9 | −0.05 ω |
| C-law | 1, 2, 3 | 0.3, 0.5, 0.9 | −0.05 ω + (0.1 sin t, 0, 0), in polhode as three formulas |

C-gg amplifies errors, so its span is short.

## At equal tolerance

The two Taylor methods, polhode and heyoka. At 1e-15 the error is rounding, which depends on the start: see the medians of twelve tops, B with
ω3 = 5 … 5.11 rad/s. heyoka's times include {call * 1e6:.2g} µs of the call from Python and the return to the start; polhode's
are of `Simulation::states`, with its set-up.

| problem | tolerance | µs | ratio | error, rad |
|---|---|---|---|---|
{equal_tolerance(runs, exact)}
"""
    (ROOT / "book/work-precision.md").write_text(page)
    sys.stdout.write(page)


if __name__ == "__main__":
    main()
