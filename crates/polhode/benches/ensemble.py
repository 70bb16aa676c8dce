#!/usr/bin/env python3
"""Measures ensembles and other programs in one run and writes the numbers of book/ensembles.md.

    pip install heyoka numpy scipy
    python3 crates/polhode/benches/ensemble.py

Every rate is the best of many runs. Each program has one core unless stated otherwise.
"""

import os
import platform
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PAGE = ROOT / "book/ensembles.md"
BEGIN, END = "<!-- written by crates/polhode/benches/ensemble.py -->", "<!-- end of what is written -->"
MOMENTS, OMEGA = (1.0, 2.0, 3.0), (0.3, 0.5, 0.9)


def bench(flags="", features=()):
    """Returns the lines of the benchmark, {name: (number, unit)}."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / ("speed" + "".join(c for c in flags if c.isalnum()))
    environment = dict(os.environ, RUSTFLAGS=flags, CARGO_TARGET_DIR=str(target))
    command = ["cargo", "bench", "-q", "-p", "polhode", "--bench", "ensemble", *features]
    text = subprocess.run(command, cwd=ROOT, env=environment, check=True, capture_output=True, text=True).stdout
    return {name: (value, unit) for name, value, unit in (line.split("\t") for line in text.splitlines() if "\t" in line)}


def best(work, seconds=2.0):
    """Returns the minimum time of many runs, s."""
    least, begin = float("inf"), time.perf_counter()
    while time.perf_counter() - begin < seconds:
        start = time.perf_counter()
        work()
        least = min(least, time.perf_counter() - start)
    return least


def heyoka():
    """Returns ns per body and step of heyoka's Taylor method, order 20, in batches."""
    import heyoka as hy
    import numpy as np

    w1, w2, w3, q0, q1, q2, q3 = hy.make_vars("w1", "w2", "w3", "q0", "q1", "q2", "q3")
    i1, i2, i3 = MOMENTS
    equations = [
        (w1, (i2 - i3) / i1 * w2 * w3), (w2, (i3 - i1) / i2 * w3 * w1), (w3, (i1 - i2) / i3 * w1 * w2),
        (q0, -0.5 * (q1 * w1 + q2 * w2 + q3 * w3)), (q1, 0.5 * (q0 * w1 + q2 * w3 - q3 * w2)),
        (q2, 0.5 * (q0 * w2 - q1 * w3 + q3 * w1)), (q3, 0.5 * (q0 * w3 + q1 * w2 - q2 * w1)),
    ]
    width = hy.recommended_simd_size()
    state = np.array([*OMEGA, 1.0, 0.0, 0.0, 0.0])[:, None] * np.ones((7, width))
    state[0] += 1e-3 * np.arange(width)
    integrator = hy.taylor_adaptive_batch(equations, state, tol=2.2e-16)

    def work():
        integrator.set_time(0.0)
        integrator.state[:] = state
        for _ in range(100):
            integrator.step()

    return best(work) / (100 * width) * 1e9, width, hy.__version__


def scipy_loop():
    """Returns µs per body and unit of time of solve_ivp, DOP853 at 1e-9, body after body."""
    import scipy
    from scipy.integrate import solve_ivp

    i1, i2, i3 = MOMENTS

    def slope(_, y):
        a, b, c, w, p, q, r = y
        return [(i2 - i3) / i1 * b * c, (i3 - i1) / i2 * c * a, (i1 - i2) / i3 * a * b,
                -0.5 * (p * a + q * b + r * c), 0.5 * (w * a + q * c - r * b),
                0.5 * (w * b + r * a - p * c), 0.5 * (w * c + p * b - q * a)]

    def work():
        solve_ivp(slope, (0.0, 100.0), [*OMEGA, 1.0, 0.0, 0.0, 0.0], method="DOP853", rtol=1e-9, atol=1e-9)

    return best(work) / 100 * 1e6, scipy.__version__


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def main():
    def first(*command):
        return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()

    own = {"widest vectors": bench(), "AVX2": bench("--cfg no_avx512"), "SSE2": bench("--cfg no_avx512 --cfg no_avx2"), "no vectors": bench("", ["--no-default-features"])}
    widest = own["widest vectors"]

    def row(label, *names):
        cells = ([lines.get(name, ("–", ""))[0].replace("NaN", "–") for name in names] for lines in own.values())
        return f"| {label} | " + " | ".join(" (".join(cell) + ")" * (len(cell) - 1) for cell in cells) + " |"

    rates = [name for name, (_, unit) in widest.items() if name.startswith("exact") and unit == "million states/s"]
    rows = "\n".join(row(name.removeprefix("exact, "), name) for name in rates)
    torques = "\n".join(row(name.removeprefix("Taylor "), name, f"{name}, alone") for name in widest if f"{name}, alone" in widest)
    taylor_ns, width, heyoka_version = heyoka()
    scipy_us, scipy_version = scipy_loop()
    own_taylor = float(widest["Taylor free"][0])
    text = f"""{BEGIN}
{processor()}, {first("rustc", "--version")}, commit {first("git", "rev-parse", "--short", "HEAD")}.

Closed forms, million states/s:

| | {" | ".join(own)} |
|---|{"---|" * len(own)}
{rows}

To prepare a body takes {widest["exact, to prepare a body"][0]} µs and {widest["a prepared body"][0]} bytes.

Taylor's method, ns per body-step; in brackets ns per step of a body alone:

| | {" | ".join(own)} |
|---|{"---|" * len(own)}
{torques}

Other programs in the same run, free motion:

- heyoka {heyoka_version}, order 20, {width} bodies a batch: {taylor_ns:.0f} ns per body-step, {taylor_ns / own_taylor:.1f} times polhode's {own_taylor:.0f}
- SciPy {scipy_version}, DOP853 at 1e-9: {scipy_us:.1f} µs per body and s of motion
{END}"""
    page = PAGE.read_text()
    head, rest = page.split(BEGIN)
    PAGE.write_text(head + text + rest.split(END)[1])
    sys.stdout.write(text + "\n")


if __name__ == "__main__":
    main()
