"""Many free bodies by MuJoCo: rollouts of one model, a thread for each processor, Runge–Kutta steps of 10 ms."""

import os

import mujoco
import numpy as np
from mujoco import rollout

MODEL = """
<mujoco>
  <option integrator="RK4" timestep="0.01" gravity="0 0 0"/>
  <worldbody>
    <body>
      <joint type="ball"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{} {} {}"/>
    </body>
  </worldbody>
</mujoco>
"""
ROWS = 50  # states that are kept of each body at a time


def prepare(moments, omega, time):
    model = mujoco.MjModel.from_xml_string(MODEL.format(*moments))
    threads = len(os.sched_getaffinity(0))
    start = np.zeros((len(omega), 8))
    start[:, 1], start[:, 5:] = 1.0, omega
    return model, [mujoco.MjData(model) for _ in range(threads)], start, round(time / model.opt.timestep)


def solve(prepared):
    model, data, state, steps = prepared
    with rollout.Rollout(nthread=len(data)) as pool:
        for _ in range(steps // ROWS):
            state = pool.rollout(model, data, state, nstep=ROWS)[0][:, -1]
    return state[:, 5:], state[:, 1:5]
