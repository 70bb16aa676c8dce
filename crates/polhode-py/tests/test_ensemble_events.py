"""Events of an ensemble's members are those that each has alone, to the bit."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import polhode
import pytest
from polhode.scenario import ConstantTorque, Drag, Event, FunctionTorque, Gravity, Run, Start, Wheel

COUNT = 9
RNG = np.random.default_rng(12)
INERTIA = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
BODIES = [
    polhode.MassProperties(mass=0.7 + 0.3 * k, center_of_mass=[0.11, -0.07 * k, 0.23], inertia=INERTIA * (0.6 + 0.1 * k)) for k in range(COUNT)
]
OMEGA = RNG.normal(size=(COUNT, 3))
ATTITUDE = np.abs(RNG.normal(size=(COUNT, 4))) * [1, -1, 1, 1]
TIMES = [0.0, 0.3, 1.1, 4.0]
DRAG = Drag(law="linear", coefficient=[0.3, 0.4, 0.5])
#: Some pass the rate and are stopped, some do not.
SLOW = Event(name="slow", measure="omega", value=0.8, direction="falling", then="stop")
TURN = Event(name="turn", measure="omega_body_x", value=0.05)
SPUN = Event(name="spun", measure="spin", value="40 deg")


def made(**changes: Any) -> polhode.Ensemble:
    return polhode.Ensemble(BODIES, **{"omega": OMEGA, "attitude": ATTITUDE, **changes})


def scenario(k: int, **given: Any) -> polhode.Scenario:
    return polhode.Scenario(BODIES[k], start=Start(attitude={"quaternion": ATTITUDE[k]}, omega=OMEGA[k]), run=Run(duration=4.0), **given)


def require_the_motions(ensemble: polhode.Ensemble, scenarios: list[polhode.Scenario]) -> polhode.results.EnsembleStates:
    states = ensemble.at(TIMES, threads=2)
    assert states == ensemble.at(TIMES, threads=1) == polhode.Ensemble.from_scenarios(scenarios).at(TIMES)
    for k, one in enumerate(scenarios):
        motion = polhode.simulate(one, times=TIMES, error="cheap")
        last = len(motion.times)
        assert states.events[k] == motion.events and states.endings[k] == motion.ending, k
        assert np.array_equal(states.reached[k, :last], motion.times), k
        assert np.array_equal(states.omega[k, :last], motion.omega) and np.array_equal(states.attitude[k, :last], motion.attitude), k
        # It stays where it was stopped.
        assert (states.omega[k, last:] == motion.omega[-1]).all() and (states.reached[k, last:] == motion.times[-1]).all(), k
    return states


def test_events_are_those_of_a_motion() -> None:
    events = [TURN, SLOW, SPUN]
    states = require_the_motions(made(torques=[DRAG], events=events), [scenario(k, torques=[DRAG], events=events) for k in range(COUNT)])
    stopped = [stop.member for stop in states.stops]
    assert 2 < len(stopped) < COUNT and stopped == sorted(stopped) and {stop.event for stop in states.stops} == {"slow"}
    assert [ending.kind for ending in states.endings] == ["stopped" if k in stopped else "complete" for k in range(COUNT)]
    times = states.event_times("slow")
    assert [(stop.member, stop.time) for stop in states.stops] == [(k, times[k]) for k in range(COUNT) if not np.isnan(times[k])]
    first = {k: event.time for k in range(COUNT) for event in reversed(states.events[k]) if event.name == "spun"}
    assert np.array_equal(states.event_times("spun"), [first.get(k, np.nan) for k in range(COUNT)], equal_nan=True)
    assert repr(states).startswith(f"EnsembleStates(9 members, 4 times, 0 … 4 s, {len(stopped)} stopped, ")
    some = states[7:2:-2]
    assert (len(some), some.failures) == (3, []) and (some.omega == states.omega[[7, 5, 3]]).all() and (some.times == states.times).all()
    assert some.events == [states.events[k] for k in (7, 5, 3)] and some.endings == [states.endings[k] for k in (7, 5, 3)]
    assert [stop.member for stop in some.stops] == [new for new, k in enumerate((7, 5, 3)) if k in stopped]
    assert states[:] == states and repr(states[:0]).startswith("EnsembleStates(0 members")
    with pytest.raises(TypeError, match="name must be text, not Event"):
        states.event_times(SLOW)  # type: ignore[arg-type]


def test_events_of_free_bodies_and_of_tops() -> None:
    events = [TURN, Event(name="leans", measure="nutation", value=1.2, then="stop")]
    require_the_motions(made(events=events), [scenario(k, events=events) for k in range(COUNT)])
    given: dict[str, Any] = {"torques": [Gravity(acceleration=[0.3, -0.4, -2.1])], "wheels": [Wheel(axis=[0.5, -0.3, 0.9], momentum=0.7)], "pivot": [-0.1, 0.2, 0.05]}
    energy = Event(name="energy", measure="kinetic_energy", value=4.0)
    states = require_the_motions(made(**given, events=[*events, energy]), [scenario(k, **given, events=[*events, energy]) for k in range(COUNT)])
    assert sum(map(len, states.events)) > 10 and states.stops


def test_events_are_of_all_or_of_each() -> None:
    """A member without any has the bits of one in an ensemble without."""
    each = [[], [SLOW], [TURN, SPUN]]
    lists = [each[k % 3] for k in range(COUNT)]
    states = made(torques=[DRAG], events=lists).at(TIMES)
    plain = made(torques=[DRAG]).at(TIMES)
    assert np.array_equal(states.omega[::3], plain.omega[::3]) and not any(states.events[::3])
    for k in (1, 2, 4, 5):
        assert states.events[k] == polhode.simulate(scenario(k, torques=[DRAG], events=lists[k]), times=TIMES, error="cheap").events


def test_events_switch_torques() -> None:
    push = ConstantTorque(name="push", on=False, axes="body", torque=[0.3, -0.2, 0.4])
    events = [Event(name="on", measure="time", value=0.7, then={"switch": "push", "on": True}), TURN]
    require_the_motions(made(torques=[push, DRAG], events=events), [scenario(k, torques=[push, DRAG], events=events) for k in range(COUNT)])


def test_events_of_functions() -> None:
    """A vectorized function receives the indices of the members."""
    drags = RNG.uniform(0.2, 0.6, size=COUNT)
    many = FunctionTorque(function=lambda omega, member: -drags[member, None] * omega, vectorized=True)
    states = made(torques=[many], events=[SLOW]).at(TIMES, tolerance=1e-10)
    for k in range(COUNT):
        one = FunctionTorque(function=lambda omega, k=k: -drags[k] * omega)
        alone = polhode.Ensemble(BODIES[k], omega=OMEGA[k], attitude=ATTITUDE[k], torques=[one], events=[SLOW]).at(TIMES, tolerance=1e-10)
        assert np.array_equal(states.omega[k], alone.omega[0]) and states.events[k] == alone.events[0], k

    def broken(t: float) -> Any:
        raise ZeroDivisionError("at some time") if t > 0.2 else None

    with pytest.raises(TypeError):
        made(torques=[FunctionTorque(function=broken)], events=[SLOW])

    def breaks(t: float, omega: Any) -> Any:
        return -0.1 * omega / (0.0 if t > 0.2 else 1.0) if t <= 0.2 else {}[t]

    with pytest.raises(KeyError):
        made(torques=[FunctionTorque(function=breaks)], events=[SLOW]).at(TIMES, tolerance=1e-10)


def test_a_member_that_cannot_go_on_has_the_events_before() -> None:
    runs_away = '[[torque]]\nmodel = "formula"\naxes = "body"\ntorque = ["0", "0", "1[kg m^2 s]*wz^3"]\n'
    fast = Event(name="fast", measure="omega_body_z", value=60.0)
    with pytest.warns(polhode.PolhodeWarning, match="1 of 2 members failed; the first is 1"):
        states = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=[[0.0, 0.0, 0.1], [0.0, 0.0, 50.0]], torques=runs_away, events=[fast]).at([0.0, 1.0])
    assert [len(events) for events in states.events] == [0, 1] and not states.stops
    assert states.endings[1] == ("failed", states.failures[0].cause, states.failures[0].time) and states.endings[0].kind == "complete"
    # ω̇ = ω³/I passes ω₁ at t = I/2 (1/ω₀² − 1/ω₁²).
    assert abs(states.events[1][0].time - 1.25 * (50.0**-2 - 60.0**-2)) < 1e-15


def test_copies_and_tables() -> None:
    ensemble = made(torques=[DRAG], events=[SLOW, TURN])
    states = ensemble.at(TIMES)
    for other in (copy.deepcopy(states), pickle.loads(pickle.dumps(states))):
        assert other == states and other.events == states.events and other.stops == states.stops
    again = pickle.loads(pickle.dumps(ensemble))
    assert again == ensemble and again.at(TIMES) == states and ensemble != made(torques=[DRAG], events=[SLOW])
    recorded = made(torques=[DRAG], events=[Event(name="slow", measure="omega", value=0.8, direction="falling"), TURN]).at(TIMES)
    assert recorded != states and not recorded.stops
    assert np.array_equal(states.columns()["time_s"], states.reached.ravel())


def test_mistakes_are_refused() -> None:
    for given, says in (
        ({"events": [Event(measure="nutation", value=4.0)]}, r"events\[0\].value: "),
        ({"events": [[]] * 3 + [[SLOW, Event(measure="colour", value=4.0)]] + [[]] * 5}, r"events\[3\]\[1\].measure: "),
        ({"events": [Event(measure="time", value=1.0, then={"switch": "push", "on": True})]}, r"events\[0\].then: "),
        ({"events": [Event(measure="total_energy", value=1.0)], "torques": [DRAG]}, "member 0: .*potential"),
        ({"events": [[SLOW]] * 4}, "events has 4: give one for each member"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            made(**given)
    with pytest.raises(TypeError, match=r"events\[0\] must be a polhode.scenario.Event, not Drag"):
        made(events=[DRAG])


def test_events_measure_functions() -> None:
    """Of each member its own: as `simulate` finds them, at the times of a formula of the same."""
    lean = Event(name="lean", measure=lambda attitude: attitude.apply([0.0, 0.0, 1.0])[2], value=0.3)
    spin = Event(name="spin", measure=lambda momentum: momentum[1], value=0.4, then="stop")
    formula = Event(name="formula", measure="formula", formula="Ly", value="0.4 N m s", then="stop")
    each = [[lean] if k % 3 == 0 else [TURN, lean, spin] if k % 3 == 1 else [lean, formula] for k in range(COUNT)]
    scenarios = [scenario(k, torques=[DRAG], events=each[k]) for k in range(COUNT)]
    require_the_motions(made(torques=[DRAG], events=each), scenarios)
    require_the_motions(polhode.Ensemble.from_scenarios(scenarios), scenarios)
    of_all = made(torques=[DRAG], events=[lean, spin]).at(TIMES)
    same = made(torques=[DRAG], events=[lean, formula]).at(TIMES)
    assert of_all.stops and [stop.member for stop in of_all.stops] == [stop.member for stop in same.stops]
    assert all(abs(one.time - other.time) < 1e-12 for one, other in zip(of_all.stops, same.stops))


def test_what_a_measured_function_raises() -> None:
    def breaks(t: float) -> float:
        return {}[t] if t > 0.2 else t

    events = [Event(name="own", measure=breaks, value=5.0)]
    with pytest.raises(KeyError):
        made(torques=[DRAG], events=events).at(TIMES)
    with pytest.raises(KeyError):
        polhode.Ensemble.from_scenarios([scenario(k, torques=[DRAG], events=events) for k in range(COUNT)]).at(TIMES)
