"""Events that measure a function of Python's."""

from __future__ import annotations

import pickle
import traceback
from typing import Any

import numpy as np
import polhode
import pytest
from scipy.spatial.transform import Rotation

from polhode.scenario import Burn, Contact, Drag, ConstantTorque, Event, FunctionTorque, MassHistory, Part, Run, Start, Surface, Wheel

START = Start(omega=[0.4, -1.1, 2.3], attitude={"quaternion": [0.5, 0.5, -0.5, 0.5]})
TORQUES = [Drag(law="linear", coefficient=0.05), ConstantTorque(axes="space", torque=[0.1, -0.2, 0.3], name="push")]
FORMULA = Event(measure="formula", formula="r13 - 0.2*sin(t/(1 s))", value=0, name="formula")


def lean(t: float, attitude: Any) -> float:
    """What FORMULA says, with an attitude like SciPy's."""
    return float(attitude.apply([0, 0, 1])[0] - 0.2 * np.sin(t))


def scenario(body: polhode.MassProperties, *events: Event, **others: Any) -> polhode.Scenario:
    return polhode.Scenario(body, **{"start": START, "torques": TORQUES, "run": Run(duration=20.0, samples=41), **others}, events=list(events))


@pytest.mark.parametrize("method", ["taylor", "dop853", "splitting"])
def test_they_are_found_as_formulas_are(generic: polhode.MassProperties, method: str) -> None:
    run = Run(duration=20.0, samples=3, method=method, **({"step": 0.02} if method == "splitting" else {}))
    torques = TORQUES[1:] if method == "splitting" else TORQUES
    motion = polhode.simulate(scenario(generic, Event(measure=lean, name="function"), FORMULA, run=run, torques=torques), error="cheap")
    found = {name: [event for event in motion.events if event.name == name] for name in ("function", "formula")}
    assert len(found["function"]) == len(found["formula"]) > 5
    for one, other in zip(found["function"], found["formula"]):
        assert abs(one.time - other.time) < 1e-12 and one.rising == other.rising
        assert abs(lean(one.time, Rotation.from_quat(np.roll(one.attitude, -1)))) < 1e-9


def test_they_stop_and_switch(generic: polhode.MassProperties) -> None:
    stopped = polhode.simulate(scenario(generic, Event(measure=lambda omega: omega[2], value=2.0, direction="falling", then="stop", name="slow")))
    assert stopped.ending.kind == "stopped" and stopped.ending.cause == "slow" and abs(stopped.omega[-1, 2] - 2.0) < 1e-13
    same = polhode.simulate(scenario(generic, Event(measure="omega_body_z", value=2.0, direction="falling", then="stop", name="slow")), error="cheap")
    assert stopped == same
    off = {"switch": "push", "on": False}
    motions = [polhode.simulate(scenario(generic, Event(measure=what, value=2.5, then=off))) for what in (lambda t: t, "time")]
    assert np.allclose(motions[0].omega, motions[1].omega, rtol=0, atol=1e-13)


def test_they_are_told_momentum_of_a_body_with_wheels(generic: polhode.MassProperties) -> None:
    wheels = [Wheel(axis=[0, 1, 1], momentum="0.2 N m s")]
    events = [Event(measure=lambda momentum_space: momentum_space[0], value=4.5, name="function"), Event(measure="formula", formula="LX", value="4.5 N m s", name="formula")]
    motion = polhode.simulate(scenario(generic, *events, wheels=wheels))
    times = [[event.time for event in motion.events if event.name == name] for name in ("function", "formula")]
    assert len(times[0]) == len(times[1]) >= 1 and np.allclose(*times, rtol=0, atol=1e-13)


def test_a_free_motion_has_them_in_closed_form(generic: polhode.MassProperties) -> None:
    motion = polhode.simulate(scenario(generic, Event(measure=lambda omega: omega[0], name="x"), torques=[]))
    exact = polhode.simulate(scenario(generic, Event(measure="omega_body_x", value=0, name="x"), torques=[]))
    assert motion == exact and motion.summary["motion"] == exact.summary["motion"] and len(motion.events) > 3


def test_what_it_raises_is_raised_with_its_traceback(generic: polhode.MassProperties) -> None:
    calls = 0

    def mine(t: float) -> float:
        nonlocal calls
        calls += 1
        if t > 5.0:
            raise ZeroDivisionError("mine")
        return t + 1.0

    for torques in (TORQUES, []):
        with pytest.raises(ZeroDivisionError, match="mine") as raised:
            polhode.simulate(scenario(generic, Event(measure=mine), torques=torques))
        assert traceback.extract_tb(raised.value.__traceback__)[-1].name == "mine"
    before = calls
    with pytest.raises(ZeroDivisionError):
        polhode.simulate(scenario(generic, Event(measure=mine), run=Run(duration=1e3, samples=2)))
    assert calls - before < 2000, "the run ends with it"


@pytest.mark.parametrize(
    ("measure", "error", "says"),
    [
        (lambda t: [t, 1.0], polhode.PolhodeError, r"what an event measures at t = 0.0 s must be one number"),
        (lambda t: float("nan"), polhode.PolhodeError, "must be finite"),
        (lambda t: "fast", TypeError, "must be a real number, not text"),
        (lambda speed: 1.0, polhode.PolhodeError, "has the parameter speed, which is not part of the state"),
        (lambda kinetic_energy: 1.0, polhode.PolhodeError, "does not receive kinetic_energy"),
    ],
)
def test_a_function_that_measures_nothing_is_refused(generic: polhode.MassProperties, measure: Any, error: type[Exception], says: str) -> None:
    with pytest.raises(error, match=says):
        polhode.simulate(scenario(generic, Event(measure=measure)))


def test_what_goes_with_no_function_is_refused(generic: polhode.MassProperties) -> None:
    for keys, says in (({"formula": "wx"}, "formula have no effect with a function"), ({"value": float("inf")}, "value = inf must be finite")):
        with pytest.raises(polhode.PolhodeError, match=says):
            Event(measure=lean, **keys)
    with pytest.raises(TypeError, match="value must be a real number, not text"):
        Event(measure=lean, value="3 deg")
    with pytest.raises(polhode.PolhodeError, match="the key value is missing"):
        scenario(generic, Event(measure="omega"))
    one = scenario(generic, Event(measure=lean, name="lean"))
    with pytest.raises(polhode.PolhodeError, match="an event measures a Python function, which cannot be written into a file"):
        one.to_toml()
    with pytest.raises(polhode.PolhodeError, match="watches a function, of which only values are known"):
        polhode.simulate(one, derivatives=[])
    # It would be told of a body that is not there any more.
    lighter = {"mass_history": MassHistory(burn=[Burn(part="fuel", until=5.0)]), "torques": []}
    parts = [Part(name="fuel", shape="sphere", radius=0.1, mass=1.0), Part(shape="tensor", mass=2.0, moments=[3.0, 4.0, 5.0])]
    exhaust = {**lighter, "mass_history": MassHistory(burn=[Burn(part="fuel", until=5.0)], in_place=True)}
    with pytest.raises(polhode.PolhodeError, match="a function of the body"):
        polhode.simulate(polhode.Scenario(parts, start=START, run=Run(duration=9.0, samples=3), events=[Event(measure=lambda momentum: momentum[0])], **exhaust))
    motion = polhode.simulate(polhode.Scenario(parts, start=START, run=Run(duration=9.0, samples=3), events=[Event(measure=lambda omega: omega[0])], **exhaust))
    same = polhode.simulate(polhode.Scenario(parts, start=START, run=Run(duration=9.0, samples=3), events=[Event(measure="omega_body_x", value=0)], **exhaust))
    assert [event.time for event in motion.events] == [event.time for event in same.events]


def test_a_scenario_with_one_is_a_value(generic: polhode.MassProperties) -> None:
    one = scenario(generic, Event(measure=lean, name="lean", value=0.1), FORMULA)
    assert one == scenario(generic, Event(measure=lean, name="lean", value=0.1), FORMULA) != scenario(generic, Event(measure=lean, name="lean"), FORMULA)
    assert one != scenario(generic, Event(measure=lambda t: t, name="lean", value=0.1), FORMULA)
    assert pickle.loads(pickle.dumps(one)) == one and "lean" in repr(one.events[0])
    motion = polhode.simulate(one.replace(title="leaning"))
    assert motion.summary["events"][0]["measure"] == "function" and motion.summary["events"][0]["unit"] == ""
    assert "r13" not in motion.page() and motion == pickle.loads(pickle.dumps(motion))
    with pytest.raises(polhode.PolhodeError, match="does not contain the Python functions of its torques or events"):
        pickle.loads(pickle.dumps(motion)).at(1.0)


def test_beside_a_function_torque_and_on_the_ground(generic: polhode.MassProperties) -> None:
    torque = FunctionTorque(function=lambda omega: -0.05 * omega)
    motion = polhode.simulate(scenario(generic, Event(measure=lambda omega: omega @ omega, value=2.4**2, name="f"), Event(measure="omega", value=2.4, name="g"), torques=[torque]))
    assert len(motion.events) == 2 and abs(motion.events[0].time - motion.events[1].time) < 1e-12
    ball = polhode.Scenario(
        Part(shape="sphere", radius=0.1, mass=1.0),
        start=Start(omega=[0.0, 8.0, 1.0], velocity=[0.2, 0.1, 0.0]),
        contact=Contact(surface=Surface(shape="sphere", radius=0.1), law="friction", friction=0.2),
        events=[Event(measure=lambda omega: omega[1], value=4.0, name="f"), Event(measure="omega_body_y", value=4.0, name="g")],
        run=Run(duration=1.0, samples=3),
    )
    times = [[event.time for event in polhode.simulate(ball).events if event.name == name] for name in "fg"]
    assert times[0] == times[1] and len(times[0]) >= 1


@pytest.mark.usefixtures("ctrl_c")
def test_knobs_keep_them(generic: polhode.MassProperties) -> None:
    live = polhode.widget(scenario(generic, Event(measure=lean, name="lean")), ["start.omega[2]"])
    live.values = {"start.spin.body[2]": 1.5}
    assert live.scenario.events[0].measure is lean and live.motion.omega[0, 2] == 1.5
    with pytest.raises(polhode.PolhodeError, match="no number"):
        polhode.widget(scenario(generic, Event(measure=lean, name="lean")), ["event[0].value"])


def test_a_printed_scenario_says_what_no_file_can_hold(generic: polhode.MassProperties) -> None:
    printed = str(scenario(generic, Event(measure="omega", value=1.0), Event(measure=lean, name="lean")))
    assert printed.startswith("# event[1] is a Python function, which cannot be written into a file; zero is written instead.\n[[body.part]]")
