"""Free motion by MuJoCo: its Runge–Kutta method with steps of a millisecond."""

import mujoco
import numpy as np

MODEL = """
<mujoco>
  <option integrator="RK4" timestep="0.001" gravity="0 0 0"/>
  <worldbody>
    <body>
      <joint type="ball"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{} {} {}"/>
    </body>
  </worldbody>
</mujoco>
"""


def prepare(moments, omega, times):
    model = mujoco.MjModel.from_xml_string(MODEL.format(*moments))
    return model, mujoco.MjData(model), omega, times


def solve(prepared):
    model, data, omega, times = prepared
    mujoco.mj_resetData(model, data)
    data.qvel[:] = omega
    states = np.empty((len(times), 7))
    for row, steps in enumerate(np.diff(np.rint(times / model.opt.timestep).astype(int), prepend=0)):
        mujoco.mj_step(model, data, nstep=steps)
        states[row] = *data.qvel, *data.qpos
    return states[:, :3], states[:, 3:]
