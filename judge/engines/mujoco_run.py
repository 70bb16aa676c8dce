"""Computes the motions of the suite's cases with MuJoCo: mujoco_run.py DIR --setting
default|implicitfast|rk4.

The angular velocity of a free joint or a ball joint is in body axes. `mjcb_control` applies
torques. MuJoCo calls it whenever it computes accelerations: once per step, or at each stage of RK4.
"""

import mujoco
import numpy as np

import suite

V = f"MuJoCo {mujoco.__version__}"
SETTINGS = {
    "default": (f"{V}, Euler", 0.002),
    "implicitfast": (f"{V}, implicitfast", 0.002),
    "rk4": (f"{V}, RK4", 0.001),
}
INTEGRATORS = {"default": "Euler", "implicitfast": "implicitfast", "rk4": "RK4"}
BAD_STATES = [mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC]


def text(values):
    return " ".join(repr(float(v)) for v in values)


def model(case, integrator, step):
    i, held = case.inertia, case.gravity is not None
    if case.mass < mujoco.mjMINVAL or np.linalg.eigvalsh(i).min() < mujoco.mjMINVAL:
        raise suite.NotRun(f"mass and moments have to be {mujoco.mjMINVAL} at least")
    joint = '<joint type="ball"/>' if held else "<freejoint/>"
    gravity = case.gravity if held else np.zeros(3)
    products = [i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]
    return mujoco.MjModel.from_xml_string(f"""<mujoco>
        <option integrator="{integrator}" timestep="{step!r}" gravity="{text(gravity)}"/>
        <worldbody><body>{joint}
            <inertial pos="{text(case.center_of_mass)}" mass="{case.mass!r}" fullinertia="{text(products)}"/>
        </body></worldbody>
    </mujoco>""")


def run(case, setting, step):
    mujoco.set_mjcb_control(None)  # otherwise compilation would call that of the previous case
    m = model(case, INTEGRATORS[setting], step)
    d = mujoco.MjData(m)
    q, w = slice(m.nq - 4, m.nq), slice(m.nv - 3, m.nv)
    d.qpos[q], d.qvel[w] = case.attitude, case.omega_body

    def control(m, d):
        d.qfrc_applied[w] = case.torque_body(d.time, suite.matrix(d.qpos[q]), d.qvel[w])

    mujoco.set_mjcb_control(control if case.torques else None)
    count, stride = case.steps(step)
    yield 0.0, d.qpos[q].copy(), d.qvel[w].copy()
    for n in range(stride, count + 1, stride):
        mujoco.mj_step(m, d, nstep=stride)
        if any(d.warning[w].number for w in BAD_STATES):
            raise RuntimeError("the motion is unstable, and MuJoCo starts again from its reset state")
        yield n * step, d.qpos[q].copy(), d.qvel[w].copy()


if __name__ == "__main__":
    suite.main(SETTINGS, run)
