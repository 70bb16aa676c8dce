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
- :func:`stability`: steady motions and their stability; :func:`torque`: torque that a prescribed
  motion requires; :func:`spin`: free motion from two measured periods; :func:`explain`: the worked
  solution
- :class:`Ensemble`: many bodies at once; :mod:`polhode.batch` and :mod:`polhode.sweep`: parameter
  sweeps, on one machine or on clusters
- :func:`check`: checks of the inertias of a robot model; :func:`link_table`, :func:`fixed_groups`:
  its links as bodies
- :mod:`plot`: figures (requires Matplotlib); :func:`widget`: an interactive motion with sliders in
  a notebook

SI units: m, kg, s, rad, N·m, J. Quaternions are scalar first (w, x, y, z), Hamilton convention, and
take body components to space components. ω is given in body axes. Off-diagonal elements of an
inertia tensor are minus the integrals, so that L = I ω. Most arguments are keyword-only. Arrays of
any type are accepted if their values are exact in float64.
"""

from __future__ import annotations

from types import FunctionType as _Function

from . import plot, scenario, shapes
from ._body import Body
from ._budget import Budget, BudgetCase, BudgetLimit, BudgetRow, ErrorShare, budget
from ._check import CheckReport, ModelFinding, check
from ._derivatives import Derivatives, EventDerivatives
from ._ensemble import Ensemble
from ._ensemble_states import EnsembleStates, Failure, Stop
from ._error import PolhodeError, PolhodeWarning
from ._estimate import Estimate, Number, PrincipalEstimate, ResidualTest
from ._explain import Explanation, explain
from ._flight import Flight
from ._flights import Flights, find_flights
from ._free_motion import FreeMotion
from ._identified import (
    Edge,
    FlightFit,
    LeftOut,
    PayloadResult,
    SwingFit,
    SwingResult,
    Thin,
    TumbleResult,
    Unconstrained,
)
from ._identify import identify, identify_payload, identify_swings, identify_tumbles
from ._inertia import inertia
from ._judge import judge
from ._judgement import Cause, ErrorGrowth, ErrorPart, ErrorSplit, Judgement, Reading, TriedReading
from ._knob import Knob
from ._live import widget
from ._mass_derivatives import (
    BodyDerivatives,
    MeshDerivatives,
    ParticleDerivatives,
    mesh_derivatives,
    particle_derivatives,
)
from ._mass_properties import Finding, MassProperties, particles
from ._motion import Ending, Event, Motion
from ._native import VERSION as __version__
from ._robot import LinkRow, LinkTable, fixed_groups, link_table
from ._scenario import Scenario
from ._simulate import simulate
from ._spin import Tumbling, TumblingSpin, spin
from ._stability import (
    Equilibrium,
    Oscillation,
    Stability,
    SteadyMotions,
    SteadyOnGround,
    SteadyRotation,
    stability,
)
from ._states import MotionError, States
from ._substance import materials
from ._torque import RequiredTorque, torque

__all__ = [
    "Body",
    "BodyDerivatives",
    "Budget",
    "BudgetCase",
    "BudgetLimit",
    "BudgetRow",
    "Cause",
    "CheckReport",
    "Derivatives",
    "Edge",
    "Ending",
    "Ensemble",
    "EnsembleStates",
    "Equilibrium",
    "ErrorGrowth",
    "ErrorPart",
    "ErrorShare",
    "ErrorSplit",
    "Estimate",
    "Event",
    "EventDerivatives",
    "Explanation",
    "Failure",
    "Finding",
    "Flight",
    "FlightFit",
    "Flights",
    "FreeMotion",
    "Judgement",
    "Knob",
    "LeftOut",
    "LinkRow",
    "LinkTable",
    "MassProperties",
    "MeshDerivatives",
    "ModelFinding",
    "Motion",
    "MotionError",
    "Number",
    "Oscillation",
    "ParticleDerivatives",
    "PayloadResult",
    "PolhodeError",
    "PolhodeWarning",
    "PrincipalEstimate",
    "Reading",
    "RequiredTorque",
    "ResidualTest",
    "Scenario",
    "Stability",
    "States",
    "SteadyMotions",
    "SteadyOnGround",
    "SteadyRotation",
    "Stop",
    "SwingFit",
    "SwingResult",
    "Thin",
    "TriedReading",
    "TumbleResult",
    "Tumbling",
    "TumblingSpin",
    "Unconstrained",
    "__version__",
    "budget",
    "check",
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
    "particle_derivatives",
    "particles",
    "plot",
    "scenario",
    "shapes",
    "simulate",
    "spin",
    "stability",
    "torque",
    "widget",
]


def _named(public: type) -> None:
    """Sets the public module name of a class and its methods, for messages and pickling."""
    public.__module__ = __name__
    for name, member in vars(public).items():
        if isinstance(member, _Function) and not name.startswith("_"):
            member.__module__ = __name__


for _public in (
    Body,
    BodyDerivatives,
    Budget,
    BudgetCase,
    BudgetLimit,
    BudgetRow,
    Cause,
    CheckReport,
    Derivatives,
    Edge,
    Ending,
    Ensemble,
    EnsembleStates,
    Equilibrium,
    ErrorGrowth,
    ErrorPart,
    ErrorShare,
    ErrorSplit,
    Estimate,
    Event,
    EventDerivatives,
    Explanation,
    Failure,
    Finding,
    Flight,
    FlightFit,
    Flights,
    FreeMotion,
    Judgement,
    Knob,
    LeftOut,
    LinkRow,
    LinkTable,
    MassProperties,
    MeshDerivatives,
    ModelFinding,
    Motion,
    MotionError,
    Number,
    Oscillation,
    ParticleDerivatives,
    PayloadResult,
    PolhodeError,
    PolhodeWarning,
    PrincipalEstimate,
    Reading,
    RequiredTorque,
    ResidualTest,
    Scenario,
    Stability,
    States,
    SteadyMotions,
    SteadyOnGround,
    SteadyRotation,
    Stop,
    SwingFit,
    SwingResult,
    Thin,
    TriedReading,
    TumbleResult,
    Tumbling,
    TumblingSpin,
    Unconstrained,
):
    _named(_public)
del _public, _named
