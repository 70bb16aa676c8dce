"""Classes of results.

Functions return objects of these classes; users need the names for annotations and ``isinstance``.

>>> import polhode
>>> from polhode.results import SwingFit, SwingResult
>>> polhode.results.Motion.__module__
'polhode.results'
"""

from __future__ import annotations

from ._budget import Budget, BudgetCase, BudgetLimit, BudgetRow, ErrorShare
from ._check import CheckReport, ModelFinding
from ._compare import Comparison, ModelDifference
from ._derivatives import Derivatives, EventDerivatives
from ._ensemble_states import EnsembleStates, Failure, Stop
from ._estimate import Estimate, Number, PrincipalEstimate, ResidualTest
from ._explain import Explanation
from ._flights import Flights
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
from ._inertials import LinkInertial, WrittenInertials
from ._judgement import Cause, ErrorGrowth, ErrorPart, ErrorSplit, Judgement, Reading, TriedReading
from ._mass_derivatives import BodyDerivatives, MeshDerivatives, ParticleDerivatives
from ._mass_properties import Finding
from ._motion import Ending, EventOccurrence, Motion
from ._nearest import NearestPossible, NearestTensor
from ._robot import LinkRow, LinkTable
from ._spin import Tumbling, TumblingSpin
from ._stability import (
    Equilibrium,
    Oscillation,
    Stability,
    SteadyMotions,
    SteadyOnGround,
    SteadyRotation,
)
from ._states import MotionError, States
from ._torque import RequiredTorque

__all__ = [
    "BodyDerivatives",
    "Budget",
    "BudgetCase",
    "BudgetLimit",
    "BudgetRow",
    "Cause",
    "CheckReport",
    "Comparison",
    "Derivatives",
    "Edge",
    "Ending",
    "EnsembleStates",
    "Equilibrium",
    "ErrorGrowth",
    "ErrorPart",
    "ErrorShare",
    "ErrorSplit",
    "Estimate",
    "EventDerivatives",
    "EventOccurrence",
    "Explanation",
    "Failure",
    "Finding",
    "FlightFit",
    "Flights",
    "Judgement",
    "LeftOut",
    "LinkInertial",
    "LinkRow",
    "LinkTable",
    "MeshDerivatives",
    "ModelDifference",
    "ModelFinding",
    "Motion",
    "MotionError",
    "NearestPossible",
    "NearestTensor",
    "Number",
    "Oscillation",
    "ParticleDerivatives",
    "PayloadResult",
    "PrincipalEstimate",
    "Reading",
    "RequiredTorque",
    "ResidualTest",
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
    "WrittenInertials",
]
