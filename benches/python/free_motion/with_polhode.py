"""Free motion by polhode: the closed form."""

import polhode


def prepare(moments, omega, times):
    return polhode.FreeMotion(moments=moments, omega=omega), times


def solve(prepared):
    motion, times = prepared
    return motion.at(times)
