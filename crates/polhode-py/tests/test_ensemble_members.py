"""Members with mass properties, pivots, wheels and torques of their own: each has the bits that it has alone."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import polhode
import pytest
from polhode.scenario import (
    ConstantTorque,
    Drag,
    FormulaTorque,
    FunctionTorque,
    Gravity,
    GravityGradient,
    Orbit,
    Run,
    Start,
    Thruster,
    Torque,
    Wheel,
)

COUNT = 11
RNG = np.random.default_rng(8)
INERTIA = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
BODIES = [
    polhode.MassProperties(mass=0.7 + 0.3 * k, center_of_mass=[0.11, -0.07 * k, 0.23], inertia=INERTIA * (0.6 + 0.1 * k)) for k in range(COUNT)
]
OMEGA = RNG.normal(size=(COUNT, 3))
#: With w > 0: of the first attitude of a motion the sign is the start's, of that of an ensemble w ≥ 0.
ATTITUDE = np.abs(RNG.normal(size=(COUNT, 4))) * [1, -1, 1, 1]
PIVOTS = RNG.normal(scale=0.3, size=(COUNT, 3))
TIMES = [0.0, 0.3, 1.1, 4.0]
WEIGHT = Gravity(acceleration=[0.3, -0.4, -2.1])
DRAGS = [[Drag(law="linear", coefficient=[0.1 + 0.02 * k, 0.2, 0.3])] for k in range(COUNT)]
#: One whose momentum depends on how the body starts, and one that is held at its speed.
WHEELS = [
    [
        Wheel(axis=[0.5, -0.3, 0.9], inertia=0.2, speed=3.0 + 0.4 * k, motor_torque=0.05 * k, from_=0.2, until=0.9),
        Wheel(axis=[-0.2, 0.7, 0.1], inertia=0.1, speed=-5.0),
    ][: k % 3]
    for k in range(COUNT)
]


def start(k: int) -> Start:
    return Start(attitude={"quaternion": ATTITUDE[k]}, omega=OMEGA[k])


def require_the_bits_of_each(ensemble: polhode.Ensemble, given: list[dict[str, Any]]) -> None:
    """Requires the bits of :func:`polhode.simulate`, except for the start, which is returned as given."""
    states = ensemble.at(TIMES, threads=2)
    assert len(ensemble) == len(given) == COUNT and not states.failures
    assert states == ensemble.at(TIMES, threads=1)
    scenarios = [polhode.Scenario(BODIES[k], start=start(k), **given[k]) for k in range(COUNT)]
    assert polhode.Ensemble.from_scenarios(scenarios).at(TIMES) == states
    for k, scenario in enumerate(scenarios):
        alone = polhode.simulate(scenario, times=TIMES, error="cheap")
        assert np.array_equal(states.omega[k, 1:], alone.omega[1:]), k
        assert np.array_equal(states.attitude[k, 1:], alone.attitude[1:]), k
        assert np.abs(states.omega[k, 0] - OMEGA[k]).max() < 1e-14


def made(**changes: Any) -> polhode.Ensemble:
    return polhode.Ensemble(changes.pop("body", BODIES), **{"omega": OMEGA, "attitude": ATTITUDE, **changes})


def test_mass_and_centre_of_mass_are_those_of_the_body() -> None:
    """A thruster acts about the centre of mass, and a body that is free does not ask for its mass."""
    push = Thruster(position=[0.5, 0.2, -0.7], force=[0.04, -0.09, 0.03])
    require_the_bits_of_each(made(torques=[push]), [{"torques": [push]}] * COUNT)
    free = made().at(TIMES)
    assert free == polhode.Ensemble(inertia=[body.inertia for body in BODIES], omega=OMEGA, attitude=ATTITUDE).at(TIMES)
    assert np.array_equal(free.omega[3], polhode.FreeMotion(inertia=BODIES[3], omega=OMEGA[3], attitude=ATTITUDE[3]).at(TIMES).omega)


def test_bodies_are_given_in_several_ways() -> None:
    together = [polhode.Body({"main": body}) for body in BODIES]
    for body in (together, tuple(BODIES), iter(BODIES)):
        assert made(body=body, torques=[WEIGHT], pivot=PIVOTS) == made(torques=[WEIGHT], pivot=PIVOTS)
    assert polhode.Ensemble(inertia=BODIES, omega=OMEGA, attitude=ATTITUDE) == made()
    one = made(body=BODIES[2], torques=[WEIGHT], pivot=PIVOTS[1]).at(TIMES)
    assert one == made(body=[BODIES[2]] * COUNT, torques=[WEIGHT], pivot=[PIVOTS[1]] * COUNT).at(TIMES)


def test_bodies_are_held_at_pivots() -> None:
    own: list[dict[str, Any]] = [{"torques": [WEIGHT], "pivot": pivot} for pivot in PIVOTS]
    require_the_bits_of_each(made(torques=[WEIGHT], pivot=PIVOTS), own)
    shared = {"torques": [WEIGHT], "pivot": PIVOTS[4]}
    require_the_bits_of_each(made(**shared), [shared] * COUNT)
    # A pivot without gravity is the point that a body turns about all the same.
    require_the_bits_of_each(made(pivot=PIVOTS), [{"pivot": pivot} for pivot in PIVOTS])


def test_gravity_may_say_where_the_pivot_is() -> None:
    weights = [Gravity(acceleration=[0.3, -0.4, -2.1], pivot=pivot) for pivot in PIVOTS]
    assert made(torques=[[weight] for weight in weights]).at(TIMES) == made(torques=[WEIGHT], pivot=PIVOTS).at(TIMES)
    assert made(torques=weights[:1]).at(TIMES) == made(torques=[WEIGHT], pivot=PIVOTS[0]).at(TIMES)


def test_a_symmetric_top_has_a_closed_form() -> None:
    top = polhode.MassProperties(mass=1.3, center_of_mass=[0.0, 0.0, 0.2], inertia=[0.4, 0.4, 0.3])
    ensemble = polhode.Ensemble(top, omega=OMEGA * [1, 1, 20], attitude=ATTITUDE, pivot=[0, 0, 0], torques=[Gravity()])
    for k, states in enumerate(ensemble.at(TIMES)[k] for k in range(COUNT)):
        alone = polhode.Scenario(top, pivot=[0, 0, 0], start=Start(attitude={"quaternion": ATTITUDE[k]}, omega=OMEGA[k] * [1, 1, 20]), torques=[Gravity()])
        motion = polhode.simulate(alone, times=TIMES, error="cheap")
        assert "Lagrange's top by elliptic functions" in str(motion.summary)
        assert np.array_equal(states.omega, motion.omega) and np.array_equal(states.attitude, motion.attitude)


def test_wheels_are_of_all_or_of_each() -> None:
    require_the_bits_of_each(made(wheels=WHEELS), [{"wheels": wheels} for wheels in WHEELS])
    require_the_bits_of_each(made(wheels=WHEELS[2]), [{"wheels": WHEELS[2]}] * COUNT)


def test_torques_are_of_all_or_of_each() -> None:
    require_the_bits_of_each(made(torques=DRAGS), [{"torques": torques} for torques in DRAGS])
    several: list[list[Torque]] = [
        [],
        [ConstantTorque(axes="space", torque=[0.1, -0.2, 0.3], until=2.0)],
        [FormulaTorque(axes="body", torque=["0", "0.1[N m]*sin(t*1[rad/s])", "0"]), DRAGS[3][0]],
    ]
    each = [several[k % 3] for k in range(COUNT)]
    require_the_bits_of_each(made(torques=each), [{"torques": torques} for torques in each])
    text = '[[torque]]\nmodel = "drag"\nlaw = "linear"\ncoefficient = [0.14, 0.2, 0.3]'
    texts: list[Any] = [*DRAGS[:2], text, *DRAGS[3:]]
    assert made(torques=texts, wheels=WHEELS).at(TIMES) == made(torques=DRAGS, wheels=WHEELS).at(TIMES)


def test_orbits_are_of_all_or_of_each() -> None:
    orbits = [Orbit(altitude=(400.0 + 30.0 * k) * 1e3, inclination=0.3 * k) for k in range(COUNT)]
    given: dict[str, Any] = {"torques": [GravityGradient(), DRAGS[3][0]]}
    require_the_bits_of_each(made(**given, orbit=orbits), [{**given, "orbit": orbit} for orbit in orbits])
    require_the_bits_of_each(made(**given, orbit=orbits[2]), [{**given, "orbit": orbits[2]}] * COUNT)
    assert made(**given, orbit=orbits) != made(**given, orbit=orbits[::-1])


def test_everything_at_once() -> None:
    torques = [[WEIGHT, *drags] for drags in DRAGS]
    given = [{"torques": torques[k], "wheels": WHEELS[k], "pivot": PIVOTS[k]} for k in range(COUNT)]
    require_the_bits_of_each(made(torques=torques, wheels=WHEELS, pivot=PIVOTS), given)


def test_functions_are_of_all_or_of_each() -> None:
    """One that is shared is called once for all members, whichever lists it is in, and one that is not for its own."""
    calls: list[int] = []

    def many(omega: Any, member: Any) -> Any:
        calls.append(len(member))
        return -0.05 * (1 + member[:, None]) * omega

    shared = FunctionTorque(function=many, vectorized=True)
    lists = [[shared, *DRAGS[k]] if k % 2 else [FunctionTorque(function=lambda omega, k=k: -0.05 * (1 + k) * omega), *DRAGS[k]] for k in range(COUNT)]
    found = made(torques=lists, pivot=PIVOTS).at(TIMES, tolerance=1e-10)
    assert max(calls) == COUNT // 2
    alone = [[FunctionTorque(function=lambda omega, k=k: -0.05 * (1 + k) * omega), *DRAGS[k]] for k in range(COUNT)]
    assert np.abs(found.omega - made(torques=alone, pivot=PIVOTS).at(TIMES, tolerance=1e-10).omega).max() < 1e-12
    scenarios = [polhode.Scenario(BODIES[k], start=start(k), torques=lists[k], pivot=PIVOTS[k]) for k in range(COUNT)]
    assert polhode.Ensemble.from_scenarios(scenarios).at(TIMES, tolerance=1e-10) == found


def test_copies_and_equality() -> None:
    given: dict[str, Any] = {"torques": [[WEIGHT, *drags] for drags in DRAGS], "wheels": WHEELS, "pivot": PIVOTS}
    one = made(**given)
    for other in (copy.deepcopy(one), pickle.loads(pickle.dumps(one)), made(**given)):
        assert other == one and hash(other) == hash(one) and other.at(TIMES) == one.at(TIMES)
    for name, changed in {"torques": [WEIGHT], "wheels": WHEELS[::-1], "pivot": 1.1 * PIVOTS, "body": BODIES[::-1]}.items():
        assert made(**given | {name: changed}) != one
    assert repr(one) == "Ensemble(11 members)"
    scenarios = [polhode.Scenario(BODIES[k], start=start(k), torques=DRAGS[k]) for k in range(COUNT)]
    of = polhode.Ensemble.from_scenarios(scenarios)
    for other in (copy.deepcopy(of), pickle.loads(pickle.dumps(of)), polhode.Ensemble.from_scenarios(iter(scenarios))):
        assert other == of and len(other) == COUNT and other.at(TIMES) == of.at(TIMES)
    assert of != polhode.Ensemble.from_scenarios(scenarios[::-1]) and of != one


@pytest.mark.parametrize(
    ("changed", "says"),
    [
        ({"pivot": PIVOTS[:3]}, "body has 11, omega has 11, attitude has 11, pivot has 3|omega has 11.*pivot has 3"),
        ({"torques": DRAGS[:4]}, "torques has 4: give one for each member"),
        ({"wheels": WHEELS[:4]}, "wheels has 4: "),
        ({"body": BODIES[:5]}, "body has 5"),
        ({"body": []}, "body is an empty list"),
        ({"inertia": INERTIA}, "exactly one of body, moments and inertia"),
        ({"torques": [Gravity()]}, r"torques\[0\].*: .*pivot"),
        ({"torques": [Gravity(pivot=[0, 0, 0])], "pivot": PIVOTS}, r"torques\[0\].pivot: .*left out, since the pivot is given"),
        ({"torques": [GravityGradient()]}, r"torques\[0\].*: .*orbit"),
        ({"orbit": Orbit(altitude=-7e6)}, "orbit: the orbit.s radius = -621863 must be positive"),
        ({"orbit": [Orbit(altitude=5e5), *[Orbit(altitude="2 kg")] * 10]}, r"orbit\[1\].altitude: "),
        ({"torques": [GravityGradient()], "orbit": Orbit(altitude=5e5), "pivot": PIVOTS}, r"torques\[0\].model: .*left out, since the bodies are held"),
        ({"torques": [Drag(law="linear", coefficient=-1.0)]}, r"torques\[0\].coefficient: "),
        ({"torques": [*DRAGS[:6], [*DRAGS[6], Drag(law="linear", coefficient="1 kg")], *DRAGS[7:]]}, r"torques\[6\]\[1\].coefficient: "),
        ({"wheels": [Wheel(axis=[0, 0, 0], momentum=1.0)]}, r"wheels\[0\].axis: "),
        ({"wheels": [*[[]] * 4, [Wheel(axis=[0, 0, 1], inertia=90.0, speed=1.0)], *[[]] * 6]}, r"member 4: wheels\[4\]\[0\].inertia: "),
        ({"wheels": [Wheel(axis=[0, 0, 1], inertia=4.3, speed=1.0)]}, r"member 0: wheels\[0\].inertia: "),
    ],
)
def test_mistakes_are_refused(changed: dict[str, Any], says: str) -> None:
    with pytest.raises(polhode.PolhodeError, match=says):
        made(**changed)


def test_mistakes_in_kinds_are_refused() -> None:
    many: dict[str, Any] = {"moments": [1.0, 2.0, 2.5], "omega": OMEGA}
    for call, says in (
        (lambda: made(body="arm.urdf"), "body must be MassProperties or a Body, or a list of these, not str"),
        (lambda: made(body=[BODIES[0], INERTIA]), r"body\[1\] must be MassProperties or a Body, not an array of float64"),
        (lambda: made(torques=[DRAGS[0], 3]), r"torques\[1\] must be a list of Torque, not int"),
        (lambda: made(torques=[*DRAGS[:-1], [WHEELS[2][0]]]), r"torques\[10\]\[0\] must be a polhode.scenario.Torque, not Wheel"),
        (lambda: made(wheels=DRAGS[0]), r"wheels\[0\] must be a polhode.scenario.Wheel, not Drag"),
        (lambda: polhode.Ensemble.from_scenarios(BODIES), r"scenarios\[0\] must be a polhode.Scenario, not MassProperties"),
        (lambda: polhode.Ensemble.from_scenarios("top.toml"), "scenarios must be a list of polhode.Scenario, not str"),
        (lambda: polhode.Ensemble(**many, pivot=PIVOTS), "a body that is held at a pivot needs its mass and its centre of mass\nhint: give body"),
        (lambda: polhode.Ensemble(**many, torques=[Gravity(pivot=[0, 0, 1])]), "a body that is held at a pivot needs its mass"),
    ):
        with pytest.raises((TypeError, polhode.PolhodeError), match=says):
            call()


def test_scenarios_that_are_no_members_are_refused() -> None:
    good = polhode.Scenario(BODIES[0], start=start(0))
    body = "[[body.part]]\nshape = 'tensor'\nmass = 1\nmoments = [1, 2, 2.5]\n"
    ball = "[[body.part]]\nshape = 'sphere'\nradius = 0.1\nmass = 1\n"
    contact = f"{ball}[contact]\nlaw = 'rolling'\nsurface = {{ shape = 'sphere', radius = 0.1 }}\n"
    gimbals = f"{body}[gimbals]\nouter_axis = [0, 0, 1]\ninner_axis = [0, 1, 0]\n"
    shaft = f"{body}[shaft]\naxis = [0, 0, 1]\nbearings = [-1, 1]\nrate = 3\n"
    burn = "[[body.part]]\nname = 'fuel'\nshape = 'sphere'\nradius = 0.1\nmass = 1\n[mass_history]\nburn = [{ part = 'fuel', until = 3, left = 0.5 }]\nin_place = true\n"
    for text, says in (
        (contact, "member 1: an ensemble and contact exclude each other"),
        (gimbals, "member 1: an ensemble and gimbals exclude each other"),
        (shaft, "member 1: an ensemble and shaft exclude each other"),
        (f"{body}[prescribed]\naxis = [0, 3, 4]\nrate = 2\n", "member 1: an ensemble and prescribed exclude each other"),
        (burn, "member 1: an ensemble and mass_history exclude each other"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.Ensemble.from_scenarios([good, polhode.Scenario.from_toml(text)])
    for run in (Run(duration=1.0, method="dop853"), Run(duration=1.0, tolerance=1e-6)):
        with pytest.raises(polhode.PolhodeError, match=r"member 1: its \[run\] sets a method or a tolerance\nhint: delete it: Ensemble.at has"):
            polhode.Ensemble.from_scenarios([good, good.replace(run=run)])
    assert len(polhode.Ensemble.from_scenarios([good, good.replace(run=Run(duration=1.0, samples=7, method="auto", tolerance=1e-13))])) == 2


def test_what_is_noticed_is_said_once() -> None:
    off = Drag(name="brake", on=False, law="linear", coefficient=0.1)
    for call in (
        lambda: made(torques=[off]),
        lambda: made(torques=[[off]] * COUNT),
        lambda: polhode.Ensemble.from_scenarios([polhode.Scenario(body, torques=[off]) for body in BODIES]),
    ):
        with pytest.warns(polhode.PolhodeWarning) as heard:
            call()
        assert len(heard) == 1 and 'the torque "brake" is off, and no event switches it on' in str(heard[0].message)
