"""Many bodies under a torque of their own by polhode: an ensemble, on all processors."""

import numpy as np
import polhode


def prepare(inertia, omega, time):
    torque = polhode.scenario.torque(lambda t, omega: [0.1 * np.sin(t) - 0.05 * omega[0], -0.05 * omega[1], -0.05 * omega[2]])
    return polhode.Ensemble(inertia=inertia, omega=omega, torques=[torque]), time


def solve(prepared):
    ensemble, time = prepared
    states = ensemble.at([time], tolerance=1e-15)
    return states.omega[:, 0], states.attitude[:, 0]
