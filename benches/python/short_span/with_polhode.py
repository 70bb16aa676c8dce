"""One short step of many free bodies by polhode: an ensemble, by Taylor's method, on all processors."""

import polhode


def prepare(moments, omega, time):
    return moments, omega, time


def solve(prepared):
    moments, omega, time = prepared
    states = polhode.Ensemble(moments=moments, omega=omega).at([time], method="taylor", tolerance=1e-15)
    return states.omega[:, 0], states.attitude[:, 0]
