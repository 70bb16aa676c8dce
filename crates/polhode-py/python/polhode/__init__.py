"""Rigid-body dynamics: from mass to motion, exact wherever an exact answer exists.

- :func:`inertia`, :class:`MassProperties`, :class:`Body`, :mod:`shapes`, :func:`particles`: mass,
  centre of mass and inertia tensor
- :func:`mesh_derivatives`, :func:`particle_derivatives`, :meth:`Body.derivatives`: derivatives of
  mass properties
- :func:`budget`: mass properties of a parts list, with their uncertainty
- :class:`FreeMotion`: torque-free motion at any time, in closed form
- :func:`identify`, :func:`identify_tumbles`, :func:`identify_swings`, :func:`identify_payload`:
  mass properties estimated from measured motion
- :class:`Scenario`, :mod:`scenario`: one body, its start and its torques; :func:`simulate`: its
  motion; :func:`judge`: accuracy of a motion that another program computed
- :func:`stability`: steady motions and their stability; :func:`required_torque`: torque that a
  prescribed motion requires; :func:`spins_from_periods`: spins with two measured periods;
  :func:`explain`: the worked solution
- :class:`Ensemble`: many bodies at once; :mod:`polhode.batch` and :mod:`polhode.sweep`: parameter
  sweeps, on one machine or on clusters
- :func:`check`: checks of the inertias of a robot model; :func:`compare`: comparison of two models;
  :func:`nearest_possible`: possible tensors nearest to an impossible one;
  :func:`link_table`, :func:`fixed_groups`: the links of a model as bodies;
  :func:`write_inertials`: inertials of its links from their geometry
- :mod:`plot`: figures (requires Matplotlib); :func:`widget`: an interactive motion with sliders in
  a notebook
- :mod:`polhode.results`: classes of what functions return

SI units: m, kg, s, rad, N·m, J. Quaternions are scalar first (w, x, y, z), Hamilton convention, and
take body components to space components. ω is given in body axes. Off-diagonal elements of an
inertia tensor are minus the integrals, so that L = I ω. Most arguments are keyword-only. Arrays of
any type are accepted if their values are exact in float64.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from ._public import on_first_use as _on_first_use

#: Modules of the public names. They are imported on first use, so that a program pays only for what it uses.
_HOMES = {
    "Body": "_body",
    "Ensemble": "_ensemble",
    "Flight": "_flight",
    "FreeMotion": "_free_motion",
    "Knob": "_knob",
    "MassProperties": "_mass_properties",
    "PolhodeError": "_error",
    "PolhodeWarning": "_error",
    "Scenario": "_scenario",
    "budget": "_budget",
    "check": "_check",
    "compare": "_compare",
    "explain": "_explain",
    "find_flights": "_flights",
    "fixed_groups": "_robot",
    "identify": "_identify",
    "identify_payload": "_identify",
    "identify_swings": "_identify",
    "identify_tumbles": "_identify",
    "inertia": "_inertia",
    "judge": "_judge",
    "link_table": "_robot",
    "materials": "_substance",
    "mesh_derivatives": "_mass_derivatives",
    "nearest_possible": "_nearest",
    "particle_derivatives": "_mass_derivatives",
    "particles": "_mass_properties",
    "plot": "plot",
    "required_torque": "_torque",
    "results": "results",
    "scenario": "scenario",
    "shapes": "shapes",
    "simulate": "_simulate",
    "spins_from_periods": "_spin",
    "stability": "_stability",
    "widget": "_live",
    "write_inertials": "_inertials",
}

__all__ = [
    "Body",
    "Ensemble",
    "Flight",
    "FreeMotion",
    "Knob",
    "MassProperties",
    "PolhodeError",
    "PolhodeWarning",
    "Scenario",
    "__version__",
    "budget",
    "check",
    "compare",
    "explain",
    "find_flights",
    "fixed_groups",
    "identify",
    "identify_payload",
    "identify_swings",
    "identify_tumbles",
    "inertia",
    "judge",
    "link_table",
    "materials",
    "mesh_derivatives",
    "nearest_possible",
    "particle_derivatives",
    "particles",
    "plot",
    "required_torque",
    "results",
    "scenario",
    "shapes",
    "simulate",
    "spins_from_periods",
    "stability",
    "widget",
    "write_inertials",
]

if TYPE_CHECKING:
    from . import plot, results, scenario, shapes
    from ._body import Body
    from ._budget import budget
    from ._check import check
    from ._compare import compare
    from ._ensemble import Ensemble
    from ._error import PolhodeError, PolhodeWarning
    from ._explain import explain
    from ._flight import Flight
    from ._flights import find_flights
    from ._free_motion import FreeMotion
    from ._identify import identify, identify_payload, identify_swings, identify_tumbles
    from ._inertia import inertia
    from ._inertials import write_inertials
    from ._judge import judge
    from ._knob import Knob
    from ._live import widget
    from ._mass_derivatives import mesh_derivatives, particle_derivatives
    from ._mass_properties import MassProperties, particles
    from ._native import VERSION as __version__
    from ._nearest import nearest_possible
    from ._robot import fixed_groups, link_table
    from ._scenario import Scenario
    from ._simulate import simulate
    from ._spin import spins_from_periods
    from ._stability import stability
    from ._substance import materials
    from ._torque import required_torque

if TYPE_CHECKING:
    from .results import (
        BodyDerivatives as BodyDerivatives, Budget as Budget, BudgetCase as BudgetCase, BudgetLimit as BudgetLimit,
        BudgetRow as BudgetRow, Cause as Cause, CheckReport as CheckReport, Derivatives as Derivatives, Edge as Edge,
        Ending as Ending, EnsembleStates as EnsembleStates, Equilibrium as Equilibrium, ErrorGrowth as ErrorGrowth,
        ErrorPart as ErrorPart, ErrorShare as ErrorShare, ErrorSplit as ErrorSplit, Estimate as Estimate,
        EventDerivatives as EventDerivatives, Explanation as Explanation, Failure as Failure, Finding as Finding,
        FlightFit as FlightFit, Flights as Flights, Judgement as Judgement, LeftOut as LeftOut,
        LinkRow as LinkRow, LinkTable as LinkTable, MeshDerivatives as MeshDerivatives,
        ModelFinding as ModelFinding, Motion as Motion,
        MotionError as MotionError, Number as Number, Oscillation as Oscillation,
        ParticleDerivatives as ParticleDerivatives, PayloadResult as PayloadResult,
        PrincipalEstimate as PrincipalEstimate, Reading as Reading, RequiredTorque as RequiredTorque,
        ResidualTest as ResidualTest, Stability as Stability, States as States, SteadyMotions as SteadyMotions,
        SteadyOnGround as SteadyOnGround, SteadyRotation as SteadyRotation, Stop as Stop, SwingFit as SwingFit,
        SwingResult as SwingResult, Thin as Thin, TriedReading as TriedReading, TumbleResult as TumbleResult,
        Tumbling as Tumbling, TumblingSpin as TumblingSpin, Unconstrained as Unconstrained,
    )

    Event = results.EventOccurrence
    spin = spins_from_periods
    torque = required_torque
else:
    #: Present names of functions by former ones; results had been here too.
    _FORMER = {"Event": "results.EventOccurrence", "spin": "spins_from_periods", "torque": "required_torque"}
    #: Results that have never been here.
    _NEWER = {"EventOccurrence", "Comparison", "ModelDifference", "LinkInertial", "WrittenInertials", "NearestPossible", "NearestTensor"}
    _imported = _on_first_use(__name__, _HOMES)

    def __getattr__(name: str) -> object:
        """Returns the object of a public name, or of a former one with a warning."""
        if name in _HOMES:
            value = globals()[name] = _imported(name)
            return value
        if name == "__version__":
            from ._native import VERSION

            return VERSION
        if name.startswith("_"):
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from . import results
        from ._deprecated import warn_of_name

        present = _FORMER.get(name, f"results.{name}")
        home, _, own = present.rpartition(".")
        if home and (own not in results.__all__ or name in _NEWER):
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        warn_of_name(f"polhode.{name}", f"polhode.{present}")
        return getattr(results if home else sys.modules[__name__], own)

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})
