"""Computes the motions of the suite's cases with Drake: drake_run.py DIR --setting
default|rk3|rk3-accurate|rk5-accurate.

`default` is the discrete plant. The other settings use the continuous plant with error control, or
with --step a fixed step. Poses and spatial velocities are in space axes. A held body is on a
BallRpyJoint.
"""

import numpy as np
from importlib.metadata import version
from pydrake.common.value import AbstractValue
from pydrake.math import RigidTransform, RollPitchYaw, RotationMatrix
from pydrake.multibody.math import SpatialForce, SpatialVelocity
from pydrake.multibody.plant import ExternallyAppliedSpatialForce, MultibodyPlant
from pydrake.multibody.tree import BallRpyJoint, FixedOffsetFrame, SpatialInertia, UnitInertia
from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig
from pydrake.systems.framework import DiagramBuilder, LeafSystem

import suite

V = f"Drake {version('drake')}"
SETTINGS = {
    "default": (f"{V}, discrete plant", 0.001),
    "rk3": (f"{V}, runge_kutta3, accuracy 1e-4", None),
    "rk3-accurate": (f"{V}, runge_kutta3, accuracy 1e-10", None),
    "rk5-accurate": (f"{V}, runge_kutta5, accuracy 1e-12", None),
}
SCHEMES = {"rk3": ("runge_kutta3", 1e-4), "rk3-accurate": ("runge_kutta3", 1e-10), "rk5-accurate": ("runge_kutta5", 1e-12)}


class Torque(LeafSystem):
    """Torque of the case as a spatial force, computed from the plant's poses and velocities."""

    def __init__(self, case, plant, body):
        super().__init__()
        self.case, self.plant, self.body = case, plant, body
        self.poses = self.DeclareAbstractInputPort("poses", AbstractValue.Make([RigidTransform()]))
        self.velocities = self.DeclareAbstractInputPort("velocities", AbstractValue.Make([SpatialVelocity()]))
        self.DeclareAbstractOutputPort("forces", lambda: AbstractValue.Make([ExternallyAppliedSpatialForce()]), self.calc)

    def calc(self, context, output):
        r = self.poses.Eval(context)[self.body.index()].rotation().matrix()
        w = r.T @ self.velocities.Eval(context)[self.body.index()].rotational()
        force = ExternallyAppliedSpatialForce()
        force.body_index = self.body.index()
        force.p_BoBq_B = self.case.center_of_mass
        force.F_Bq_W = SpatialForce(tau=r @ self.case.torque_body(context.get_time(), r, w), f=np.zeros(3))
        output.set_value([force])


def spatial_inertia(case):
    i = case.inertia / case.mass
    unit = UnitInertia(i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
    about_origin = unit.ShiftFromCenterOfMass(-case.center_of_mass)
    return SpatialInertia(case.mass, case.center_of_mass, about_origin)


def joint_frames(case):
    """Returns the axes between which the joint's angles are measured, in the world and in the body.

    The angles are singular if the first axis of the body is along the third of the world. The
    former is the line from the pivot to the centre of mass, and the latter is horizontal.
    """
    def frame(first, second):
        x = first / np.linalg.norm(first)
        z = np.cross(x, second) / np.linalg.norm(np.cross(x, second))
        return np.column_stack([x, np.cross(z, x), z])
    return frame(case.gravity, np.array([1.0, 2.0, 0.0])), frame(case.center_of_mass, np.array([1.0, 2.0, 3.0]))


def run(case, setting, step):
    builder = DiagramBuilder()
    plant = builder.AddSystem(MultibodyPlant(time_step=step if setting == "default" else 0.0))
    body = plant.AddRigidBody("body", spatial_inertia(case))
    if case.gravity is not None:
        frames = joint_frames(case)
        on_world, on_body = [
            plant.AddFrame(FixedOffsetFrame(name, parent, RigidTransform(RotationMatrix(r), np.zeros(3))))
            for name, parent, r in zip(["on_world", "on_body"], [plant.world_frame(), body.body_frame()], frames)]
        joint = plant.AddJoint(BallRpyJoint("pivot", on_world, on_body, damping=0.0))
    plant.mutable_gravity_field().set_gravity_vector(case.gravity if case.gravity is not None else np.zeros(3))
    plant.Finalize()
    if case.torques:
        torque = builder.AddSystem(Torque(case, plant, body))
        builder.Connect(plant.get_body_poses_output_port(), torque.poses)
        builder.Connect(plant.get_body_spatial_velocities_output_port(), torque.velocities)
        builder.Connect(torque.get_output_port(), plant.get_applied_spatial_force_input_port())
    diagram = builder.Build()
    simulator = Simulator(diagram)
    if setting != "default":
        scheme, accuracy = SCHEMES[setting]
        ApplySimulatorConfig(SimulatorConfig(
            integration_scheme=scheme, accuracy=accuracy, use_error_control=step is None, max_step_size=step or 0.1), simulator)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    r = suite.matrix(case.attitude)
    if case.gravity is None:
        plant.SetFreeBodyPose(context, body, RigidTransform(RotationMatrix(r), np.zeros(3)))
        plant.SetFreeBodySpatialVelocity(context, body, SpatialVelocity(w=r @ case.omega_body, v=np.zeros(3)))
    else:
        across = RotationMatrix.ProjectToRotationMatrix(frames[0].T @ r @ frames[1])
        joint.set_angles(context, RollPitchYaw(across).vector())
        joint.set_angular_velocity(context, frames[0].T @ r @ case.omega_body)
    simulator.Initialize()

    def row(t):
        r = plant.EvalBodyPoseInWorld(context, body).rotation().matrix()
        return t, suite.quaternion(r), r.T @ plant.EvalBodySpatialVelocityInWorld(context, body).rotational()

    yield row(0.0)
    if step is None:
        times = [n * case.rows_every for n in range(1, round(case.duration / case.rows_every) + 1)]
    else:
        count, stride = case.steps(step)
        times = [n * step for n in range(stride, count + 1, stride)]
    for t in times:
        simulator.AdvanceTo(t)
        yield row(t)


if __name__ == "__main__":
    suite.main(SETTINGS, run)
