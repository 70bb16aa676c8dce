# %% [markdown]
# # An author of a physics engine: how good is my integrator?
#
# A closed form to compare with: the error of a step is the distance to the exact state, not to somebody else's integrator.

# %%
import numpy as np
import polhode
from scipy.spatial.transform import Rotation

MOMENTS = np.array([1.0, 2.0, 2.7])
START = np.array([0.3, 1.0, -0.2])
END = 10.0
exact = polhode.FreeMotion(moments=MOMENTS, omega=START)
print(exact)

# %% [markdown]
# Two integrators that engines use: semi-implicit Euler with the gyroscopic torque left explicit, and RK4 of (ω, q).


# %%
def acceleration(w):
    return np.cross(MOMENTS * w, w) / MOMENTS


def semi_implicit_euler(w, q, dt):
    w = w + dt * acceleration(w)
    return w, q * Rotation.from_rotvec(dt * w)


def rk4(w, q, dt):
    """Of (ω, q) together, q̇ = ½ q ω, scalar last as SciPy has it; SciPy normalises q."""

    def rate(y):
        w, u, s = y[:3], y[3:6], y[6]
        return np.concatenate([acceleration(w), 0.5 * (s * w + np.cross(u, w)), [-0.5 * u @ w]])

    y = np.concatenate([w, q.as_quat()])
    k1 = rate(y)
    k2 = rate(y + dt / 2 * k1)
    k3 = rate(y + dt / 2 * k2)
    k4 = rate(y + dt * k3)
    y = y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return y[:3], Rotation.from_quat(y[3:])


def error(step, dt):
    w, q = START, Rotation.identity()
    for _ in range(round(END / dt)):
        w, q = step(w, q, dt)
    omega, _ = exact.at(END)
    apart = (exact.rotations(END).inv() * q).magnitude()
    return np.linalg.norm(w - omega), apart, 0.5 * w @ (MOMENTS * w) / exact.kinetic_energy - 1


# %%
for step in (semi_implicit_euler, rk4):
    print(step.__name__)
    before = None
    for dt in (0.04, 0.02, 0.01):
        omega, apart, energy = error(step, dt)
        order = "" if before is None else f"   order of ω {np.log2(before / omega):.2f}"
        print(f"   dt = {dt:5.3f} s   ω {omega:.2e} rad/s   attitude {np.degrees(apart):.2e}°   energy {energy:+.1e}{order}")
        before = omega

# %% [markdown]
# The order shows whether the code does what its author thinks: half a step, a sixteenth of the error, in ω and in the attitude.

# %%
coarse, fine = error(rk4, 0.04), error(rk4, 0.02)
assert all(14.0 < a / b < 18.0 for a, b in zip(coarse[:2], fine[:2])), (coarse, fine)

# %% [markdown]
# Many bodies with one call: 2000 exact states, to hold 2000 runs of an engine against. Here RK4 of ω, all bodies in one array.

# %%
starts = np.random.default_rng(3).normal(size=(2000, 3))
true, _ = polhode.Ensemble(moments=MOMENTS, omega=starts).at([END])


def worst(dt):
    w = starts
    for _ in range(round(END / dt)):
        k1 = acceleration(w)
        k2 = acceleration(w + dt / 2 * k1)
        k3 = acceleration(w + dt / 2 * k2)
        w = w + dt / 6 * (k1 + 2 * k2 + 2 * k3 + acceleration(w + dt * k3))
    return np.abs(w - true[:, 0]).max()


errors = worst(0.02), worst(0.01)
print(f"worst error in ω of 2000 bodies: {errors[0]:.1e} at 0.02 s, {errors[1]:.1e} at 0.01 s")
assert 12.0 < errors[0] / errors[1] < 20.0
