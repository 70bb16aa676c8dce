"""A body under a saturated law by polhode: a traced function."""

import numpy as np
import polhode


def prepare(inertia, omega, times):
    torque = polhode.scenario.torque(lambda t, omega: -0.2 * np.tanh(3.0 * omega))
    return polhode.Ensemble(inertia=inertia, omega=[omega], torques=[torque]), times


def solve(prepared):
    ensemble, times = prepared
    states = ensemble.at(times, tolerance=1e-15)
    return states.omega[0], states.attitude[0]
