# %% [markdown]
# # A chemist: rotational constants, and what an isotope does to them

# %%
from pathlib import Path

import polhode

EXAMPLES = Path(__file__).resolve().parents[1]

# %%
water = polhode.inertia(EXAMPLES / "water.xyz")
print(water)
constants = water.to_dict()["molecule"]
print(constants["top"], constants["rotational_constants_ghz"], "GHz; Ray's κ =", constants["ray_kappa"])

# %% [markdown]
# By hand: A = h/(8π² I_a). The masses are those of the most abundant isotopes.

# %%
import math

h = 6.62607015e-34
for moment, constant in zip(water.moments, constants["rotational_constants_ghz"]):
    by_hand = h / (8 * math.pi**2 * moment) / 1e9
    print(f"{by_hand:.4f} GHz")
    assert math.isclose(by_hand, constant, rel_tol=1e-12)

# %% [markdown]
# Heavy water: the file names the isotope. The oxygen hardly notices, the axis through it does.

# %%
text = (EXAMPLES / "water.xyz").read_text()
Path("heavy-water.xyz").write_text("\n".join("D" + line[1:] if line.startswith("H") else line for line in text.splitlines()) + "\n")
heavy = polhode.inertia("heavy-water.xyz")
for light, deuterated in zip(constants["rotational_constants_ghz"], heavy.to_dict()["molecule"]["rotational_constants_ghz"]):
    print(f"{light:9.3f} → {deuterated:9.3f} GHz   ratio {deuterated / light:.4f}")
assert heavy.mass > water.mass

# %% [markdown]
# Standard atomic weights are for balances, not for spectra: the constants differ in the fourth digit.

# %%
average = polhode.inertia(EXAMPLES / "water.xyz", isotopes="average").to_dict()["molecule"]
print([a / b for a, b in zip(average["rotational_constants_ghz"], constants["rotational_constants_ghz"])])
