"""Former names: each warns, names the present one, and gives the same object; pickles of them load."""

from __future__ import annotations

import ast
import importlib
import pickle
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import polhode
import pytest
from polhode.scenario import Drag, FunctionTorque, Run, torque

#: Results that have never been at the top of the package.
NEWER = {"EventOccurrence", "Comparison", "ModelDifference", "LinkInertial", "WrittenInertials", "NearestPossible", "NearestTensor"}

#: Former names at the top of the package, with what they are now.
FORMER = {
    **{name: getattr(polhode.results, name) for name in polhode.results.__all__ if name not in NEWER},
    **{"Event": polhode.results.EventOccurrence, "spin": polhode.spins_from_periods, "torque": polhode.required_torque},
}


@pytest.mark.parametrize("name", FORMER)
def test_a_former_name_warns_and_is_the_same_object(name: str) -> None:
    present = FORMER[name]
    place = "results." if isinstance(present, type) else ""
    with pytest.warns(DeprecationWarning, match=f"^polhode.{name} is deprecated .*: use polhode.{place}{present.__name__}$") as heard:
        assert getattr(polhode, name) is present
    assert heard[0].filename == __file__
    with pytest.warns(DeprecationWarning) as heard:
        exec(f"from polhode import {name} as found", own := {"__name__": "users_own"})
    assert own["found"] is present and {warning.filename for warning in heard} == {"<string>"}
    assert name not in polhode.__all__ and name not in dir(polhode)


def test_the_top_had_these_names() -> None:
    """The list of version 0.1.0, of which the present names are the rest."""
    assert len(FORMER) == 56 and len(polhode.__all__) == 38
    tree = ast.parse(Path(polhode.__file__).read_text())
    _, former = (node for node in tree.body if isinstance(node, ast.If))
    imported, *assigned = former.body
    assert isinstance(imported, ast.ImportFrom)
    names = [alias.asname for alias in imported.names] + [ast.unparse(one).partition(" = ")[0] for one in assigned]
    assert sorted(map(str, names)) == sorted(FORMER)
    for unknown in (*NEWER, "Flightz", "batchh"):
        with pytest.raises(AttributeError, match=f"module 'polhode' has no attribute '{unknown}'"):
            getattr(polhode, unknown)


def test_pickles_with_former_names_load(generic: polhode.MassProperties) -> None:
    """Bytes in which a class is named as it was."""
    racket = polhode.Scenario(
        generic,
        events=[polhode.scenario.Event(name="slow", measure="omega_body_x", value=0.0)],
        start=polhode.scenario.Start(omega=[0.3, 2.0, -0.1]),
        run=Run(duration=20.0, samples=3),
    )
    motion = polhode.simulate(racket)
    things = {"EventOccurrence": motion.events[0], "Motion": motion, "States": motion[1], "Ending": motion.ending}
    for name, thing in things.items():
        dumped = pickle.dumps(thing, protocol=0)
        assert f"cpolhode.results\n{name}\n".encode() in dumped
        former = "Event" if name == "EventOccurrence" else name
        before = dumped.replace(b"cpolhode.results\nEventOccurrence\n", b"cpolhode\nEvent\n").replace(b"cpolhode.results\n", b"cpolhode\n")
        with pytest.warns(DeprecationWarning, match="^polhode.[A-Z][A-Za-z]+ is deprecated") as heard:
            assert pickle.loads(before) == thing
        assert any(str(warning.message).startswith(f"polhode.{former} is") for warning in heard)


def brake(omega: np.ndarray) -> np.ndarray:
    return -0.1 * omega


def test_former_names_of_methods_and_attributes(generic: polhode.MassProperties) -> None:
    turn = [0.5, -0.1, 0.7, 0.2]
    scenario = polhode.Scenario(generic, torques=[Drag(law="linear", coefficient=0.1)])
    growth = polhode.results.ErrorGrowth("power", 0.5, None)
    acts = FunctionTorque(function=brake)
    for former, given, present, instead in (
        ("MassProperties.about", lambda: generic.about([1, 2, 3]), lambda: generic.inertia_about([1, 2, 3]), "MassProperties.inertia_about"),
        ("MassProperties.along", lambda: generic.along(turn), lambda: generic.inertia_along(turn), "MassProperties.inertia_along"),
        ("Ensemble.of", lambda: polhode.Ensemble.of([scenario]), lambda: polhode.Ensemble.from_scenarios([scenario]), "Ensemble.from_scenarios"),
        ("ErrorGrowth.law", lambda: growth.law, lambda: growth.kind, "ErrorGrowth.kind"),
        ("FunctionTorque.law", lambda: acts.law, lambda: acts.function, "FunctionTorque.function"),
        ("the argument law", lambda: FunctionTorque(law=brake), lambda: acts, "function"),  # type: ignore[call-arg]
        ("the argument law", lambda: torque(law=brake), lambda: torque(brake), "function"),  # type: ignore[call-arg]
    ):
        with pytest.warns(DeprecationWarning, match=f"^{former} is deprecated .*: use {instead}$") as heard:
            found = given()
        assert len(heard) == 1 and heard[0].filename == __file__
        assert np.array_equal(found, present()) if isinstance(found, np.ndarray) else found == present()
    with pytest.raises(TypeError, match="function is given twice: law is its former name"):
        FunctionTorque(function=brake, law=brake)  # type: ignore[call-arg]


def test_a_copy_of_a_function_torque_with_its_former_key_loads() -> None:
    acts = FunctionTorque(function=brake, name="brake")
    again = object.__new__(FunctionTorque)
    again.__setstate__({"law" if name == "function" else name: value for name, value in vars(acts).items()})
    assert again == acts == pickle.loads(pickle.dumps(acts))


def test_the_import_warns_of_nothing() -> None:
    code = "import polhode, polhode.batch, polhode.sweep, pickle; from polhode import *; pickle.loads(pickle.dumps(results.Stop(1, 'a', 0.5)))"
    subprocess.run([sys.executable, "-W", "error", "-c", code], check=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert importlib.import_module("polhode.results") is polhode.results
