# %% [markdown]
# # A planetary scientist: Toutatis, which tumbles

# %%
from pathlib import Path

import numpy as np
import polhode

EXAMPLES = Path(__file__).resolve().parents[1]
DAY = 86400.0

# %% [markdown]
# Ratios of moments and the spin of 1992 November 9, after Takahashi, Busch & Scheeres (2013).

# %%
toutatis = polhode.FreeMotion(moments=[3.0836, 3.235, 1.0], omega=np.radians([14.51, 33.529, -98.709]) / DAY)
print(toutatis)
periods = toutatis.summary["motion"]["periods"]["long_axis"]
print(f"long axis: P_φ = {periods['precession_period_s'] / DAY:.3f} d, P_ψ = {periods['rotation_period_s'] / DAY:.3f} d")
assert toutatis.regime == "long_axis"

# %% [markdown]
# A light curve of a kind: the area of an ellipsoid that is lit and seen from the same side, over 400 days. Its spectrum has peaks at
# combinations of the two frequencies.

# %%
semi_axes = np.array([0.7, 0.8, 2.2])
times = np.arange(0.0, 400 * DAY, 0.05 * DAY)
seen_from = toutatis.rotations(times).inv().apply([0.6, 0.3, np.sqrt(1 - 0.45)])
area = np.pi * np.prod(semi_axes) * np.linalg.norm(seen_from / semi_axes, axis=1)
power = np.abs(np.fft.rfft((area - area.mean()) * np.hanning(len(area)))) ** 2
frequency = np.fft.rfftfreq(len(area), 0.05)
f_phi, f_psi = DAY / periods["precession_period_s"], DAY / periods["rotation_period_s"]
lines = {f"{j} f_φ {k:+} f_ψ": abs(j * f_phi + k * f_psi) for j in range(5) for k in range(-4, 5)}
is_peak = (power[1:-1] > power[:-2]) & (power[1:-1] > power[2:]) & (power[1:-1] > 0.02 * power.max())
peaks = 1 + np.flatnonzero(is_peak)
for k in peaks[np.argsort(power[peaks])[::-1]]:
    name = min(lines, key=lambda name: abs(lines[name] - frequency[k]))
    print(f"{frequency[k]:.4f} /d, {power[k] / power.max():5.2f} of the strongest   {name} = {lines[name]:.4f} /d")
    assert abs(lines[name] - frequency[k]) < 0.004

# %% [markdown]
# The same as a scenario: its summary says how far the numbers are to be trusted.

# %%
motion = polhode.simulate(EXAMPLES / "toutatis.toml")
print(motion)
