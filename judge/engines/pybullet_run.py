"""Computes the motions of the suite's cases with PyBullet: pybullet_run.py DIR --setting
default|fine|maximal.

The inertia of PyBullet's body is diagonal, so its axes are the principal axes, and input and output
are rotated accordingly. A free body is the base of a multibody, or with `maximal` a btRigidBody. A
held body is a link on a spherical joint. PyBullet resets a torque after each step. Its quaternions
are (x, y, z, w), and its angular velocities are in space axes.
"""

import numpy as np
import pybullet as p
from importlib.metadata import version

import suite

V = f"PyBullet {version('pybullet')}"
SETTINGS = {
    "default": (f"{V}, multibody", 1 / 240),
    "fine": (f"{V}, multibody", 0.0005),
    "maximal": (f"{V}, maximal coordinates", 1 / 240),
}


def xyzw(q):
    return [q[1], q[2], q[3], q[0]]


class Body:
    def __init__(self, case, maximal):
        self.moments, self.axes = case.principal()
        r = suite.matrix(case.attitude)
        self.held = case.gravity is not None
        self.link = 0 if self.held else -1
        quiet = dict(linearDamping=0, angularDamping=0, jointDamping=0, maxJointVelocity=1e6,
                     activationState=p.ACTIVATION_STATE_DISABLE_SLEEPING)
        if self.held:
            if maximal:
                raise suite.NotRun("a spherical joint needs a multibody")
            # The link's axes are the body's own; its inertial frame has the principal axes.
            self.id = p.createMultiBody(
                baseMass=0, linkMasses=[case.mass], linkCollisionShapeIndices=[-1], linkVisualShapeIndices=[-1],
                linkPositions=[[0, 0, 0]], linkOrientations=[[0, 0, 0, 1]],
                linkInertialFramePositions=[case.center_of_mass], linkParentIndices=[0],
                linkInertialFrameOrientations=[xyzw(suite.quaternion(self.axes))],
                linkJointTypes=[p.JOINT_SPHERICAL], linkJointAxis=[[0, 0, 1]])
            p.setJointMotorControlMultiDof(self.id, 0, p.POSITION_CONTROL, targetPosition=[0, 0, 0, 1],
                                           positionGain=0, velocityGain=0, force=[0, 0, 0])
        else:
            self.id = p.createMultiBody(baseMass=case.mass, useMaximalCoordinates=maximal)
        # If both are set in one call, the inertia of a link is set to zero. Without a mass, a body
        # in maximal coordinates loses its inertia.
        p.changeDynamics(self.id, self.link, **quiet)
        p.changeDynamics(self.id, self.link, mass=case.mass, localInertiaDiagonal=[*self.moments])
        if not np.allclose(p.getDynamicsInfo(self.id, self.link)[2], self.moments, rtol=1e-12, atol=0):
            raise suite.NotRun("the inertia is not what was set")
        if self.held:
            # Quaternion and velocity of a spherical joint are in the axes of the link's inertial
            # frame.
            q = [*self.axes.T @ case.attitude[1:], case.attitude[0]]
            p.resetJointStateMultiDof(self.id, 0, q, self.axes.T @ case.omega_body)
        else:
            p.resetBasePositionAndOrientation(self.id, [0, 0, 0], xyzw(suite.quaternion(r @ self.axes)))
            p.resetBaseVelocity(self.id, [0, 0, 0], r @ case.omega_body)

    def state(self):
        """Returns R_space_body and the angular velocity in body axes."""
        if self.held:
            s = p.getLinkState(self.id, 0, computeLinkVelocity=1, computeForwardKinematics=1)
            q, w = s[1], s[7]
        else:
            q, w = p.getBasePositionAndOrientation(self.id)[1], p.getBaseVelocity(self.id)[1]
        r = suite.matrix([q[3], q[0], q[1], q[2]]) @ self.axes.T
        return r, r.T @ np.array(w)


def run(case, setting, step):
    p.resetSimulation()
    p.setTimeStep(step)
    p.setGravity(*(case.gravity if case.gravity is not None else (0, 0, 0)))
    body = Body(case, setting == "maximal")
    count, stride = case.steps(step)
    r, w = body.state()
    yield 0.0, suite.quaternion(r), w
    for n in range(1, count + 1):
        if case.torques:
            torque = r @ case.torque_body((n - 1) * step, r, w)
            p.applyExternalTorque(body.id, body.link, torque, p.WORLD_FRAME)
        p.stepSimulation()
        if case.torques or n % stride == 0:
            r, w = body.state()
        if n % stride == 0:
            yield n * step, suite.quaternion(r), w


if __name__ == "__main__":
    p.connect(p.DIRECT)
    suite.main(SETTINGS, run)
