# %% [markdown]
# # A student of mechanics: tensors by hand, and a racket that flips

# %%
import numpy as np
import polhode
from polhode import plot, shapes

# %% [markdown]
# A cube about its corner: the notes of every course. I = M b² [2/3, −1/4, −1/4; …], principal moments M b²/6 and 11/12 M b² twice.

# %%
cube = shapes.box(size=[1, 1, 1], mass=1.0).placed(position=[0.5, 0.5, 0.5])
about_corner = cube.inertia_about([0, 0, 0])
print(about_corner)
np.testing.assert_allclose(about_corner, 11 / 12 * np.eye(3) - 1 / 4 * np.ones((3, 3)), atol=1e-15)
print(np.linalg.eigvalsh(about_corner), "should be 1/6, 11/12, 11/12")

# %% [markdown]
# A table-tennis bat is a disk and a rod. Thrown with a spin about the axis across the blade, it flips.

# %%
bat = polhode.Body({
    "blade": shapes.cylinder(radius=0.075, length=0.006, mass=0.085).placed(position=[0.14, 0, 0]),
    "handle": shapes.box(size=[0.10, 0.028, 0.022], mass=0.095).placed(position=[0.03, 0, 0]),
})
print(bat, bat.mass_properties.moments)
R = bat.mass_properties.principal_rotation  # takes principal components to body components
intermediate = R @ [0.0, 1.0, 0.0]
flip = polhode.FreeMotion(inertia=bat.mass_properties, omega=12.0 * intermediate + [0.05, 0.0, 0.05])
print(flip)
interval = flip.flip_interval
assert interval is not None  # as it would be of a body with two equal moments
print(f"it flips every {interval:.3f} s")
before, _ = flip.at(0.0)
after, _ = flip.at(interval)
print(f"ω along the intermediate axis: {before @ intermediate:+.2f} → {after @ intermediate:+.2f} rad/s")
assert before @ intermediate * (after @ intermediate) < 0

# %% [markdown]
# Energy and L are what stays. The polhode is where both ellipsoids meet.

# %%
times = np.linspace(0.0, 4 * interval, 400)
omega, _ = flip.at(times)
momentum = flip.rotations(times).apply(omega @ bat.mass_properties.inertia)
print("L in space moves by", np.abs(momentum - flip.momentum).max())
plot.polhode(flip).savefig("polhode.png")
plot.omega(flip).savefig("omega.png")

# %% [markdown]
# In a notebook, `flip` alone in a cell shows it in three dimensions. As a page for a browser:

# %%
with open("bat.html", "w", encoding="utf-8") as page:
    page.write(flip.page())
