"""A body under a torque of its own by polhode: a traced function."""

import numpy as np
import polhode


def prepare(inertia, omega, times):
    torque = polhode.scenario.torque(lambda t, omega: [0.1 * np.sin(t) - 0.05 * omega[0], -0.05 * omega[1], -0.05 * omega[2]])
    return polhode.Ensemble(inertia=inertia, omega=[omega], torques=[torque]), times


def solve(prepared):
    ensemble, times = prepared
    states = ensemble.at(times, tolerance=1e-15)
    return states.omega[0], states.attitude[0]
