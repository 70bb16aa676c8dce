"""Mass properties of a mesh by MuJoCo: those that the compiler gives a body with it."""

import mujoco
import numpy as np


def prepare(vertices, triangles, density):
    return vertices, triangles, density


def solve(prepared):
    vertices, triangles, density = prepared
    spec = mujoco.MjSpec()
    spec.add_mesh(name="mesh", uservert=vertices.ravel(), userface=triangles.ravel(), inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_EXACT)
    body = spec.worldbody.add_body()
    body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="mesh", density=density)
    model = spec.compile()
    axes = np.empty(9)
    mujoco.mju_quat2Mat(axes, model.body_iquat[1])
    axes = axes.reshape(3, 3)
    return model.body_mass[1], model.body_ipos[1], axes * model.body_inertia[1] @ axes.T
