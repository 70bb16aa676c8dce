"""A heavy top by MuJoCo: its Runge–Kutta method with steps of 0.2 ms, as 10⁻¹² rad asks for."""

import mujoco

MODEL = """
<mujoco>
  <option integrator="RK4" timestep="0.0002" gravity="0 0 {gravity}"/>
  <worldbody>
    <body>
      <joint type="ball"/>
      <inertial pos="0 0 1" mass="{mass}" diaginertia="{moments}"/>
    </body>
  </worldbody>
</mujoco>
"""


def prepare(moments, mass, gravity, omega, attitude, time):
    text = MODEL.format(gravity=-gravity, mass=mass, moments=" ".join(map(str, moments)))
    model = mujoco.MjModel.from_xml_string(text)
    return model, mujoco.MjData(model), omega, attitude, round(time / model.opt.timestep)


def solve(prepared):
    model, data, omega, attitude, steps = prepared
    mujoco.mj_resetData(model, data)
    data.qpos[:], data.qvel[:] = attitude, omega
    mujoco.mj_step(model, data, nstep=steps)
    return data.qpos.copy()
