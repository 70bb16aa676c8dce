"""Ensembles under functions: one call for many members is what a call for each is."""

from __future__ import annotations

import copy
import pickle
import traceback
from typing import Any

import numpy as np
import polhode
import pytest
from polhode.scenario import ConstantTorque, FunctionTorque, Run, Start

INERTIA = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
COUNT = 37
RNG = np.random.default_rng(5)
OMEGA = RNG.normal(size=(COUNT, 3))
ATTITUDE = RNG.normal(size=(COUNT, 4))
TENSORS = INERTIA * RNG.uniform(0.5, 2.0, size=(COUNT, 1, 1))
TIMES = [0.0, 0.3, 1.1, 4.0]
STRENGTH = RNG.uniform(0.05, 0.2, size=COUNT)


def ensemble(*torques: Any, count: int = COUNT) -> polhode.Ensemble:
    return polhode.Ensemble(inertia=TENSORS[:count], omega=OMEGA[:count], attitude=ATTITUDE[:count], torques=list(torques))


def one(t: Any, omega: Any, omega_space: Any, momentum: Any, momentum_space: Any, attitude: Any) -> Any:
    """Of all that a law may ask for, of one body."""
    up = attitude.apply([0.1, -0.2, 1.0], inverse=True)
    fixed = attitude.as_matrix()[0] * attitude.as_quat()[3] + 0.1 * attitude.as_quat(scalar_first=True)[1:]
    return -0.1 * omega + 0.05 * np.cos(t) * up + 0.03 * fixed - 0.01 * momentum + 0.02 * attitude.apply(omega_space + 0.1 * momentum_space, inverse=True)


def many(t: Any, omega: Any, omega_space: Any, momentum: Any, momentum_space: Any, attitude: Any) -> Any:
    """The same of many."""
    assert t.shape == (len(omega),) and omega.shape == omega_space.shape == momentum.shape == momentum_space.shape == (len(t), 3)
    up = attitude.apply([0.1, -0.2, 1.0], inverse=True)
    fixed = attitude.as_matrix()[:, 0] * attitude.as_quat()[:, 3:] + 0.1 * attitude.as_quat(scalar_first=True)[:, 1:]
    turned = attitude.apply(omega_space + 0.1 * momentum_space, inverse=True)
    return -0.1 * omega + 0.05 * np.cos(t)[:, None] * up + 0.03 * fixed - 0.01 * momentum + 0.02 * turned


@pytest.mark.parametrize("axes", ["body", "space"])
def test_one_call_is_what_many_are(axes: str) -> None:
    """With a built-in torque beside it that begins and ends on the way."""
    push = ConstantTorque(axes="body", torque=[0.1, -0.2, 0.05], from_=0.5, until=2.5)
    alone = ensemble(push, FunctionTorque(function=one, axes=axes)).at(TIMES, tolerance=1e-8)
    together = ensemble(push, FunctionTorque(function=many, axes=axes, vectorized=True)).at(TIMES, tolerance=1e-8)
    assert not alone.failures and not together.failures
    assert np.abs(together.omega - alone.omega).max() < 1e-12 and np.abs(together.attitude - alone.attitude).max() < 1e-12
    # What they are: one of them by the formula, which Taylor's method integrates.
    traced = ensemble(push, polhode.scenario.torque(one, axes=axes), count=5).at(TIMES, tolerance=1e-12)
    assert np.abs(traced.omega - together.omega[:5]).max() < 1e-6 and np.abs(together.omega[:, -1] - OMEGA).max() > 0.1


def test_calls_are_few_and_members_known() -> None:
    calls: list[int] = []
    seen: set[int] = set()

    def drag(t: Any, omega: Any, member: Any) -> Any:
        calls.append(len(member))
        seen.update(member.tolist())
        assert member.dtype.kind in "iu" and (np.diff(member) > 0).all()
        return -STRENGTH[member, None] * omega

    found = polhode.Ensemble(moments=[2.0, 2.0, 2.0], omega=OMEGA, torques=[FunctionTorque(function=drag, vectorized=True)]).at(TIMES)
    expected = OMEGA[:, None] * np.exp(-STRENGTH[:, None, None] * np.array(TIMES)[:, None] / 2.0)
    assert np.abs(found.omega - expected).max() < 1e-12 and seen == set(range(COUNT))
    assert calls[:2] == [COUNT, 1] and sum(calls) > 10 * len(calls)
    assert len(found.failures) == 0 and (found.reached == TIMES).all()


def test_simulate_calls_it_for_one(generic: polhode.MassProperties) -> None:
    found = [
        polhode.simulate(
            polhode.Scenario(generic, start=Start(omega=[0.3, -1.0, 0.4]), torques=[torque], run=Run(duration=2.0, samples=3)), error="cheap"
        )
        for torque in (FunctionTorque(function=one), FunctionTorque(function=many, vectorized=True))
    ]
    assert np.abs(found[0].omega - found[1].omega).max() < 1e-12


def test_what_it_raises_keeps_its_traceback() -> None:
    def late(t: Any, omega: Any) -> Any:
        if t.max() > 1.0:
            raise ZeroDivisionError("too late")
        return -0.1 * omega

    def early(omega: Any) -> Any:
        return omega / [][0]

    made = ensemble(FunctionTorque(function=late, vectorized=True))
    for _ in range(2):  # and a second time
        with pytest.raises(ZeroDivisionError, match="too late") as raised:
            made.at(TIMES)
        assert "late" in [frame.name for frame in traceback.extract_tb(raised.value.__traceback__)]
    assert len(made.at([0.0, 0.01])) == COUNT
    with pytest.raises(IndexError) as wrong:
        ensemble(FunctionTorque(function=early, vectorized=True))
    assert "early" in [frame.name for frame in traceback.extract_tb(wrong.value.__traceback__)]
    with pytest.raises(ZeroDivisionError):
        ensemble(FunctionTorque(function=lambda t: 1 / 0))


def test_what_is_refused() -> None:
    for law, says in (
        (lambda omega: omega[0], r"a row for each member, of shape \(37, 3\), not \(3,\)"),
        (lambda omega: omega - omega.mean(axis=0), "the torque of member 36 is .* alone and .* among others"),
        (lambda omega: np.zeros((len(omega), 3)) + omega[0], "the torque of member 36 is .* alone"),
        (lambda omega: omega * np.nan, "member 0: .*not finite|member 0: "),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            ensemble(FunctionTorque(function=law, vectorized=True))
    with pytest.raises(TypeError, match="the torque of a function must be real numbers"):
        ensemble(FunctionTorque(function=lambda omega: omega * 1j, vectorized=True))
    with pytest.raises(polhode.PolhodeError, match="the function has the parameter member"):
        FunctionTorque(function=lambda member: member)
    with pytest.raises(polhode.PolhodeError, match="does not receive kinetic_energy"):
        FunctionTorque(function=lambda kinetic_energy: [0, 0, 0])
    with pytest.raises(TypeError, match="FunctionTorque.vectorized must be True or False, not str"):
        FunctionTorque(function=many, vectorized="yes")


def test_a_member_that_cannot_go_on() -> None:
    def partial(t: Any, omega: Any, member: Any) -> Any:
        return np.where(((member == 3) & (t > 1.0))[:, None], np.nan, -0.1 * omega)

    with pytest.warns(polhode.PolhodeWarning, match="1 of 37 members failed; the first is 3"):
        found = ensemble(FunctionTorque(function=partial, vectorized=True)).at(TIMES, tolerance=1e-9)
    assert [failure.member for failure in found.failures] == [3] and found.failures[0].time == 0.3
    whole = ensemble(FunctionTorque(function=lambda omega: -0.1 * omega, vectorized=True)).at(TIMES, tolerance=1e-9)
    others = np.arange(COUNT) != 3
    assert np.array_equal(found.omega[others], whole.omega[others]) and np.isfinite(found.omega).all()


def test_copies() -> None:
    made = ensemble(FunctionTorque(function=many, vectorized=True))
    for other in (copy.deepcopy(made), pickle.loads(pickle.dumps(made))):
        assert other == made and np.array_equal(other.at(TIMES, tolerance=1e-8).omega, made.at(TIMES, tolerance=1e-8).omega)
    assert made != ensemble(FunctionTorque(function=one)) and made != ensemble()
