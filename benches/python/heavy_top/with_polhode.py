"""A heavy top by polhode: the closed form, with the estimate of its error."""

import polhode
from polhode.scenario import Gravity, Start


def prepare(moments, mass, gravity, omega, attitude, time):
    top = polhode.MassProperties(mass=mass, center_of_mass=[0, 0, 1], inertia=moments)
    weight = Gravity(acceleration=[0, 0, -gravity], pivot=[0, 0, 0])
    return polhode.Scenario(top, start=Start(attitude={"quaternion": attitude}, omega=omega), torques=[weight]), time


def solve(prepared):
    scenario, time = prepared
    return polhode.simulate(scenario, times=[0.0, time], error="cheap").attitude[-1]
