"""Many free bodies by polhode: an ensemble, on all processors."""

import polhode


def prepare(moments, omega, time):
    return polhode.Ensemble(moments=moments, omega=omega), time


def solve(prepared):
    ensemble, time = prepared
    states = ensemble.at([time])
    return states.omega[:, 0], states.attitude[:, 0]
