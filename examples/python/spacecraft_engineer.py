# %% [markdown]
# # A spacecraft engineer: nutation, a flat spin, and a satellite that hangs in the field of gravity

# %%
from pathlib import Path

import numpy as np
import polhode
from polhode import plot

EXAMPLES = Path(__file__).resolve().parents[1]

# %% [markdown]
# A spinner with a wobble. The periods are exact, and so is the state in a year.

# %%
spinner = polhode.FreeMotion(inertia=[[92, 1.5, -0.8], [1.5, 105, 2.1], [-0.8, 2.1, 130]], omega=[0.02, -0.01, 0.5])
print(spinner)
least, greatest = np.degrees(spinner.nutation_range)
print(f"nutation between {least:.3f}° and {greatest:.3f}°, ω repeats every {spinner.period:.3f} s")
omega, _ = spinner.at(365.25 * 86400.0)
print("ω in a year:", omega)
np.testing.assert_allclose(np.linalg.norm(omega @ spinner.axes.T * spinner.moments), np.linalg.norm(spinner.momentum), rtol=1e-13)

# %% [markdown]
# Ten thousand of them: how far does the spin axis wander in an hour, if the separation leaves tip-off rates of 1 deg/s?

# %%
rng = np.random.default_rng(11)
rates = np.array([0.0, 0.0, 0.5]) + np.radians(1.0) * rng.normal(size=(10_000, 3)) * [1, 1, 0]
tensor = [[92, 1.5, -0.8], [1.5, 105, 2.1], [-0.8, 2.1, 130]]
_, attitude = polhode.Ensemble(inertia=tensor, omega=rates).at(np.linspace(0.0, 3600.0, 61))
w, x, y, z = np.moveaxis(attitude, -1, 0)
tilt = np.degrees(np.arccos(np.clip(1 - 2 * (x * x + y * y), -1.0, 1.0))).max(axis=1)
print(f"largest tilt of z: median {np.median(tilt):.1f}°, 99 % below {np.percentile(tilt, 99):.1f}°")
assert 0.0 < np.median(tilt) < 90.0

# %% [markdown]
# Explorer 1: a spinner about its axis of least inertia loses energy inside, and ends in a flat spin.

# %%
flat = polhode.simulate(EXAMPLES / "flat-spin.toml")
spin_axis = flat.rotations().apply([0.0, 0.0, 1.0])
along = flat.momentum / np.linalg.norm(flat.momentum, axis=1, keepdims=True)
nutation = np.degrees(np.arccos(np.clip((spin_axis * along).sum(axis=1), -1.0, 1.0)))
print(f"nutation {nutation[0]:.2f}° at the start, {nutation[-1]:.2f}° after {flat.times[-1]:.0f} s")
print(f"energy {flat.kinetic_energy[0]:.3f} J → {flat.kinetic_energy[-1]:.3f} J, |L| stays to {np.ptp(np.linalg.norm(flat.momentum, axis=1)):.1e}")
assert nutation[-1] > 89.0

# %% [markdown]
# A boom that hangs in the field of gravity and swings.

# %%
boom = polhode.simulate(EXAMPLES / "gravity-gradient.toml")
figure = plot.attitude(boom)
figure.savefig("gravity-gradient.png")
print(boom.summary["drift"])
