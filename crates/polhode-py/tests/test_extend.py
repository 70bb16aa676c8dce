"""Motions that go on from their end."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import polhode
import pytest
from polhode.scenario import Burn, ConstantTorque, Contact, Drag, Drop, Event, FunctionTorque, GimbalAxis, Gimbals, MassHistory, Orbit, Part, Pulses, Run, Start, Surface, Wheel, torque

START = Start(omega=[0.4, -1.1, 2.3], attitude={"quaternion": [0.5, 0.5, -0.5, 0.5]})


def both(given: polhode.Scenario, first: float, further: float, samples: int = 7) -> tuple[polhode.results.Motion, polhode.results.Motion, polhode.results.Motion]:
    """A motion, what follows, and the same in one go at the times of both."""
    one = polhode.simulate(given.replace(run=Run(duration=first, samples=samples, method=given.run.method if given.run else None)))
    two = one.extend(further, samples=samples)
    return one, two, polhode.simulate(given, times=np.concatenate([one.times, two.times[1:]]))


def agree(one: polhode.results.Motion, two: polhode.results.Motion, whole: polhode.results.Motion, atol: float) -> None:
    """Both together are the whole."""
    for name in ("omega", "attitude", "momentum", "torque"):
        joined = np.concatenate([getattr(one, name), getattr(two, name)[1:]])
        assert np.allclose(joined, getattr(whole, name), rtol=0, atol=atol), name
    assert [event.name for event in (*one.events, *two.events)] == [event.name for event in whole.events]
    assert np.allclose([event.time for event in (*one.events, *two.events)], [event.time for event in whole.events], rtol=0, atol=100 * atol)
    assert two.ending.kind == whole.ending.kind
    # Work counts from where it begins.
    assert np.allclose(one.work[-1] + two.work, whole.work[len(one) - 1 :], rtol=0, atol=10 * atol)


SCENARIOS: dict[str, dict[str, Any]] = {
    "free": {},
    "torques in time": {
        "torques": [
            torque(lambda t, omega: [0.3 * np.sin(2.0 * t), -0.1 * omega[0], 0.2]),
            ConstantTorque(axes="space", torque=[0.5, 0.2, -0.4], pulses=Pulses(width=0.4, period=1.1)),
            ConstantTorque(axes="body", torque=[0.1, 0.0, 0.0], from_=1.0, until=4.0),
        ]
    },
    "wheels": {"wheels": [Wheel(axis=[0, 1, 1], inertia=0.02, speed=100.0, motor_torque=0.05, from_=1.0, until=4.5)], "torques": [Drag(law="quadratic", coefficient=0.02)]},
    "function": {"torques": [FunctionTorque(function=lambda t, omega: -0.1 * omega + np.array([0.0, 0.2 * np.cos(t), 0.0]))]},
    "orbit": {"orbit": Orbit(mu=1.0, position=[1.0, 0.2, 0.0], velocity=[0.1, 0.9, 0.3]), "torques": [polhode.scenario.GravityGradient()]},
}


@pytest.mark.parametrize("name", SCENARIOS)
def test_both_are_one(generic: polhode.MassProperties, name: str) -> None:
    events = [Event(measure="omega_body_x", value=0.1, name="x"), Event(measure=lambda t, omega: omega[1] - 0.1 * t, name="y")]
    given = polhode.Scenario(generic, start=START, run=Run(duration=6.0), events=events, **SCENARIOS[name])
    agree(*both(given, 2.3, 3.7), atol=1e-11)


def test_switches_stay_as_they_are(generic: polhode.MassProperties) -> None:
    """A torque that was switched off, one that was switched on, and one that comes later."""
    push, drag = ConstantTorque(axes="body", torque=[0.4, 0.0, 0.1], name="push"), Drag(law="linear", coefficient=0.2, name="drag", on=False)
    events = [
        Event(measure="time", value=1.0, then={"switch": "push", "on": False}, name="off"),
        Event(measure="time", value=1.7, then={"switch": "drag", "on": True}, name="drag"),
        Event(measure="time", value=4.0, then={"switch": "push", "on": True}, name="on"),
    ]
    given = polhode.Scenario(generic, start=START, run=Run(duration=6.0), torques=[push, drag], events=events)
    agree(*both(given, 2.3, 3.7), atol=1e-11)
    # three in a row
    one, two, _ = both(given, 0.9, 2.0)
    three = two.extend(3.1, samples=5)
    whole = polhode.simulate(given, times=three.times)
    assert np.allclose(three.omega, whole.omega, rtol=0, atol=1e-11) and [event.name for event in three.events] == ["on"]


def test_an_event_at_the_end_happens_once(generic: polhode.MassProperties) -> None:
    given = polhode.Scenario(generic, start=START, run=Run(duration=6.0), torques=[Drag(law="linear", coefficient=0.2)], events=[Event(measure="time", value=2.3, name="then")])
    for torques in (given.torques, ()):
        one, two, whole = both(given.replace(torques=torques), 2.3, 3.7)
        times = [event.time for event in (*one.events, *two.events)]
        assert times == [event.time for event in whole.events] == [2.3]


@pytest.mark.parametrize("torques", [(), (Drag(law="linear", coefficient=0.01),)])
def test_it_goes_on_from_where_an_event_stopped_it(generic: polhode.MassProperties, torques: Any) -> None:
    stop = Event(measure="omega_body_x", value=0.1, direction="rising", then="stop", name="x")
    given = polhode.Scenario(generic, start=START, run=Run(duration=60.0, samples=7), torques=torques, events=[stop])
    noted = polhode.simulate(given.replace(events=[Event(measure="omega_body_x", value=0.1, direction="rising", name="x")]))
    motion, times = polhode.simulate(given), []
    for _ in range(4):
        assert motion.ending.kind == "stopped" and motion.ending.cause == "x"
        times.append(motion.ending.time)
        motion = motion.extend(60.0, samples=3)
    assert np.allclose(times, [event.time for event in noted.events[:4]], rtol=0, atol=1e-11)


@pytest.mark.filterwarnings("ignore:.cap. is dropped at")
def test_mass_goes_on_leaving(generic: polhode.MassProperties) -> None:
    parts = [
        Part(name="fuel", shape="sphere", radius=0.2, mass=1.0, position=[0.1, -0.2, 0.3]),
        Part(name="cap", shape="sphere", radius=0.1, mass=0.2, position=[0.3, 0.1, -0.2]),
        Part(shape="tensor", mass=2.0, inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]),
    ]
    history = MassHistory(burn=[Burn(part="fuel", from_=0.5, until=5.0)], drop=[Drop(part="cap", time=4.0)], in_place=True)
    given = polhode.Scenario(parts, start=START, run=Run(duration=6.0), mass_history=history, torques=[ConstantTorque(axes="body", torque=[0.4, 0.0, 0.1])])
    agree(*both(given, 2.3, 3.7), atol=1e-10)


def test_a_given_motion_goes_on_too() -> None:
    given = polhode.Scenario(
        Part(shape="tensor", mass=2.0, moments=[3.0, 4.0, 5.0]),
        prescribed=polhode.scenario.Prescribed(euler313=[0.1, 0.4, -0.2], rates=[0.5, 0.0, 3.0]),
        run=Run(duration=2.0, samples=3),
    )
    one = polhode.simulate(given)
    assert np.allclose(one.extend(3.0, samples=4).torque, polhode.simulate(given, times=[2.0, 3.0, 4.0, 5.0]).torque, rtol=0, atol=1e-13)


def test_its_copies_go_on(generic: polhode.MassProperties) -> None:
    given = polhode.Scenario(generic, start=START, run=Run(duration=2.0, samples=3), torques=[Drag(law="linear", coefficient=0.2)])
    two = polhode.simulate(given).extend(1.0, samples=5)
    for again in (pickle.loads(pickle.dumps(two)), copy.deepcopy(two)):
        assert again == two and (again.at([2.0, 2.9]).omega == two.at([2.0, 2.9]).omega).all()
        assert again.extend(2.0, samples=3) == two.extend(2.0, samples=3)
    assert np.allclose(two.at(2.6).omega, polhode.simulate(given, times=[2.6]).omega[0], rtol=0, atol=1e-13)
    with pytest.raises(polhode.PolhodeError, match="at least 2.0, where this motion continues another one"):
        two.at(1.0)
    with pytest.raises(polhode.PolhodeError, match="at most 3.0"):
        two.at(3.5)
    assert "polhode-data" in two.page() and two.error is not None and two.summary["run"] is not None


def test_what_cannot_go_on_is_refused(examples: Any) -> None:
    ball = polhode.Scenario(
        Part(shape="sphere", radius=0.1, mass=1.0),
        start=Start(omega=[0.0, 8.0, 1.0], velocity=[0.2, 0.1, 0.0]),
        contact=Contact(surface=Surface(shape="sphere", radius=0.1), law="friction", friction=0.2),
        run=Run(duration=1.0, samples=3),
    )
    gyroscope = polhode.Scenario(
        Part(shape="cylinder", radius=0.05, length=0.02, mass=1.0),
        gimbals=Gimbals(outer_axis=[0, 0, 1], inner_axis=[1, 0, 0], rotor=GimbalAxis(rate=100.0), inner=GimbalAxis(angle=1.2)),
        run=Run(duration=0.1, samples=3),
    )
    for given, says in ((ball, "a body on the ground"), (gyroscope, "a rotor in gimbals")):
        motion = polhode.simulate(given)
        with pytest.raises(polhode.PolhodeError, match=f"cannot be continued from its end: it is that of {says}"):
            motion.extend(1.0)
    free = polhode.simulate(polhode.Scenario(Part(shape="sphere", radius=0.1, mass=1.0), start=Start(omega=[1, 2, 3]), run=Run(duration=1.0, samples=2)))
    for keys, says in (({"duration": 0.0}, "duration = 0.0 must be positive"), ({"duration": 1.0, "samples": 1}, "samples = 1 must be"), ({"duration": 1e-20}, "too short for 1001 samples"), ({"duration": 1.0, "error": "much"}, "error = 'much'")):
        with pytest.raises(polhode.PolhodeError, match=says):
            free.extend(**keys)


def test_one_that_failed_does_not_go_on(generic: polhode.MassProperties) -> None:
    grows = torque(lambda omega: 2.0 * omega)
    with pytest.warns(polhode.PolhodeWarning, match="the motion ends at"):
        motion = polhode.simulate(polhode.Scenario(generic, start=START, run=Run(duration=1e3, samples=3), torques=[grows]))
    with pytest.raises(polhode.PolhodeError, match="could not be computed further"):
        motion.extend(1.0)
