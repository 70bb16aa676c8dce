"""Torques that are Python functions: traced to formulas, and called with numbers."""

from __future__ import annotations

import copy
import inspect
import itertools
import math
import pickle
import warnings
from typing import Any, Callable

import numpy as np
import polhode
import pytest
from polhode import scenario
from polhode._attitude import Turned
from polhode.scenario import FormulaTorque, FunctionTorque, Run, Start, torque
from scipy.spatial.transform import Rotation

LIMITS = np.array([0.3, 0.2, 0.5])
MATRIX = np.array([[0.3, 0.1, -0.2], [0.4, -0.5, 0.1], [0.2, 0.6, 0.7]])


def _normalised(omega: Any, momentum: Any) -> Any:
    """Uses each value many times: written out, the formula would have more than 10⁶ characters."""
    v = omega
    for _ in range(6):
        v = np.cross(v / np.linalg.norm(v), LIMITS) + momentum / np.linalg.norm(momentum)
    return v


def _in_place(t: Any, omega: Any) -> Any:
    total = -0.3 * omega
    total *= 2
    total[1] += np.sin(t)
    return total


#: Functions of the state as people write them with NumPy.
FUNCTIONS: list[Callable[..., Any]] = [
    lambda omega: -0.2 * omega * np.sum(omega) + omega.sum() * omega.mean() * LIMITS,
    lambda omega: np.array([np.max(omega), omega.min(), np.mean(omega**2)]) + np.prod(omega) + omega.max(),
    lambda omega: np.clip(-2 * omega, -LIMITS, LIMITS) + omega.clip(-0.5, 0.6),
    lambda omega: np.clip(np.stack([-omega[0], 0.4, omega[2] ** 2]), -0.45, 0.3) + np.maximum(np.stack([omega[1], omega[0], 0.0]), 0.2),
    lambda t, omega: np.array([np.clip(omega[0], 0.1, None), np.clip(t, a_min=None, a_max=0.01), 0.2]),
    lambda omega: np.tanh(omega) + 0.1 * np.sinh(omega) + 0.2 * np.cosh(omega),
    lambda omega: np.log1p(omega**2) - np.expm1(omega / 3) + np.log10(2 + omega) + np.exp2(omega),
    lambda t, omega: np.heaviside(t - 0.4, 0.5) * omega + np.heaviside(0.4 - t, 0.5) * LIMITS,
    lambda t, omega: omega % 0.4 + np.mod(-omega, 0.7) + np.remainder(omega, -0.5) + 1.9 % (t + 0.7) * LIMITS,
    lambda t, omega: np.floor(3 * omega) + np.ceil(2 * omega) + math.floor(t + 1.5) + np.trunc(-3 * omega) + omega // 0.3,
    lambda t, omega: np.interp(t, [-1, 0, 0.02, 2], [0.3, 0.1, -0.2, 0.4]) * LIMITS,
    lambda omega: np.interp(omega, [-0.5, 0.2, 0.2, 0.6], [0.1, 0.5, 2, -1], left=-0.7, right=0.9),
    lambda t, omega: np.where(t > 0.3, omega, LIMITS) + np.where((t > -1) & (t < 2), 0.3, 0.0) + np.where(omega > 0, 1, omega),
    lambda omega: np.where(np.any(omega > 0.8), 1, 0.2) * omega + np.where(np.all(omega > -2), 0.3, 0) + np.where(np.logical_not(omega > 0), 0.1, 0),
    lambda omega: omega / np.linalg.norm(omega) + np.linalg.norm(np.array([omega, 2 * omega]), axis=1, keepdims=True)[1],
    lambda omega: np.dot(LIMITS, omega) * omega + omega.dot(omega) + np.dot(MATRIX, omega) + MATRIX @ omega + np.inner(omega, LIMITS),
    lambda omega: np.cross(omega, LIMITS) + np.einsum("ij,j->i", MATRIX, omega) + np.outer(omega, omega)[1],
    lambda t, omega: np.sin(np.array([t, 2 * t, omega[0]])) + np.concatenate([omega[:2], [t]]) + np.stack([omega[1], t, omega[2]]),
    lambda omega: np.std(omega) * omega + np.diff(np.append(omega, 0.3)) + np.sum(np.array([omega, LIMITS]), axis=0),
    lambda attitude: attitude.as_rotvec() + 0.01 * attitude.as_euler("zyx", degrees=True) + attitude.as_euler("ZXZ"),
    lambda attitude, omega: attitude.inv().apply(omega) + attitude.inv().as_rotvec(degrees=True) / 100 + attitude.inv().as_matrix()[1],
    _in_place,
    _normalised,
]


def _motion(generic: polhode.MassProperties, acting: scenario.Torque) -> polhode.results.Motion:
    start = Start(attitude={"euler313": [0.3, 0.8, -0.4]}, omega=[0.5, -0.9, 0.7])
    return polhode.simulate(polhode.Scenario(generic, start=start, torques=[acting], run=Run(duration=0.1, samples=2)), error="cheap")


@pytest.mark.parametrize("function", FUNCTIONS, ids=range(len(FUNCTIONS)))
def test_traced_and_called_functions_agree(generic: polhode.MassProperties, function: Callable[..., Any]) -> None:
    traced, called = _motion(generic, torque(function)), _motion(generic, FunctionTorque(function=function))
    assert np.abs(traced.omega - called.omega).max() < 3e-14
    assert np.abs(traced.omega[1] - traced.omega[0]).max() > 1e-4
    smooth = _motion(generic, torque(lambda t: [0, 0, 0]))
    assert np.abs(traced.omega[1] - smooth.omega[1]).max() > 1e-3


def test_attitudes_agree_with_scipy() -> None:
    rng = np.random.default_rng(2)
    quaternions = rng.normal(size=(50, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    # Rotations about one axis: these are degenerate for many sequences.
    about = [[np.cos(a), *np.sin(a) * np.eye(3)[k]] for k in range(3) for a in (0.0, 1e-10, 0.4, np.pi / 4, -np.pi / 4, np.pi / 2)]
    for quaternion in [*quaternions, *np.array(about)]:
        mine, theirs = Turned(quaternion), Rotation.from_quat(quaternion, scalar_first=True)
        assert np.abs(mine.as_rotvec() - theirs.as_rotvec()).max() < 1e-14
        assert np.abs(mine.as_rotvec(degrees=True) - theirs.as_rotvec(degrees=True)).max() < 1e-12
        assert np.abs(mine.inv().as_matrix() - theirs.inv().as_matrix()).max() < 1e-15
    sequences = ["".join(s) for s in itertools.product("xyz", repeat=3) if s[0] != s[1] != s[2]]
    for seq in [*sequences, *(seq.upper() for seq in sequences)]:
        mine, theirs = Turned(quaternions), Rotation.from_quat(quaternions, scalar_first=True)
        assert np.abs(mine.as_euler(seq) - theirs.as_euler(seq)).max() < 1e-13, seq
        assert np.abs(mine.as_euler(seq, degrees=True) - theirs.as_euler(seq, degrees=True)).max() < 1e-11, seq
        for quaternion in np.array(about):
            with warnings.catch_warnings():
                warnings.filterwarnings("ignore", message="Gimbal lock")
                angles = Rotation.from_quat(quaternion, scalar_first=True).as_euler(seq)
            # A half turn is π or −π by rounding.
            difference = Turned(quaternion).as_euler(seq) - angles + np.pi
            assert np.abs(difference % (2 * np.pi) - np.pi).max() < 1e-9, (seq, quaternion)
    assert Turned(quaternions).as_rotvec().shape == Turned(quaternions).inv().as_euler("xyz").shape == (50, 3)
    for wrong in ("zz", "xXy", "abc", "xxy"):
        with pytest.raises(polhode.PolhodeError, match="seq = "):
            Turned(quaternions).as_euler(wrong)


def test_a_long_formula_names_what_it_uses_often(generic: polhode.MassProperties) -> None:
    made = torque(_normalised)
    assert all(isinstance(text, str) and text.startswith("a1=") and len(text) < 2000 for text in made.torque)
    assert made == copy.deepcopy(made) == pickle.loads(pickle.dumps(made)) and eval(repr(made), vars(scenario)) == made
    given = polhode.Scenario(generic, start=Start(omega=[0.5, -0.9, 0.7]), torques=[made], run=Run(duration=0.1, samples=2))
    again = polhode.Scenario.from_toml(given.to_toml())
    assert again.torques == given.torques
    assert (polhode.simulate(again).omega == polhode.simulate(given).omega).all()
    written = FormulaTorque(axes="body", torque=["size = wx^2 + wy^2; -size/(1 + size)*wx", 0, 0], units="SI")
    direct = FormulaTorque(axes="body", torque=["-(wx^2 + wy^2)/(1 + (wx^2 + wy^2))*wx", 0, 0], units="SI")
    assert np.abs(_motion(generic, written).omega - _motion(generic, direct).omega).max() < 1e-15
    with pytest.raises(polhode.PolhodeError, match="unknown variable size"):
        polhode.Scenario(generic, torques=[FormulaTorque(axes="body", torque=["size = wx; size[N m s]", 0, 0])])


def test_refused_functions_are_named_as_they_are_called() -> None:
    def message(function: Callable[..., Any]) -> str:
        with pytest.raises((polhode.PolhodeError, TypeError)) as caught:
            torque(function)
        return str(caught.value)

    def set_one_by_one(omega: Any) -> Any:
        total = np.zeros(3)
        total[0] = -omega[0]
        return total

    long, table = message(lambda t: _grown(t) * LIMITS), np.arange(201.0)
    assert "too long" in long and "FunctionTorque" in long
    assert "np.interp has a table of 201 points" in message(lambda t: np.interp(t, table, table**2) * LIMITS)
    assert "np.interp" in message(lambda t: np.interp(t, [0, 1], [0, 1], period=2) * LIMITS)
    assert "xp of np.interp[1] = 0.0 must be at least the one before it" in message(lambda t: np.interp(t, [1, 0], [0, 1]) * LIMITS)
    assert "np.sum" in message(lambda omega: omega.sum(dtype=np.float32) * LIMITS)
    assert "np.max" in message(lambda omega: np.max(omega, initial=0) * LIMITS)
    assert "np.sum" in message(lambda omega: np.add.reduce(omega, initial=3.0) * LIMITS)
    assert "np.sort" in message(lambda omega: np.sort(omega))
    assert "np.linalg.inv" in message(lambda omega: np.linalg.inv(np.outer(omega, omega))[0])
    assert "np.where" in message(lambda t: np.where(t > 1) * LIMITS)
    assert "np.array([x, y, z])" in message(set_one_by_one)
    assert "np.stack([x, y, z])" in message(lambda omega: np.clip(np.array([omega[0], 0.2, omega[1]]), -1, 1))


def _grown(t: Any) -> Any:
    # No value is used twice.
    for k in range(8000):
        t = t + 0.1 * k
    return t


def test_functions_receive_only_what_they_take(generic: polhode.MassProperties, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[tuple[bool, float]] = []

    def law(omega_space: Any, /, t: float, *, momentum: Any, attitude: Any, momentum_space: Any, omega: Any, k: float = 0.1) -> list[float]:
        pairs = np.array([attitude.apply(omega), attitude.apply(momentum)]) - [omega_space, momentum_space]
        seen.append((type(t) is float and omega.shape == (3,), np.abs(pairs).max()))
        components: list[float] = (-k * momentum).tolist()
        return components

    signature, looked_up = inspect.signature, []

    def counted(function: Callable[..., Any]) -> inspect.Signature:
        looked_up.append(function)
        return signature(function)

    monkeypatch.setattr(inspect, "signature", counted)
    motion = _motion(generic, FunctionTorque(function=law))
    assert len(seen) > 30 > len(looked_up) > 0
    assert all(is_plain and difference < 1e-14 for is_plain, difference in seen)
    assert np.abs(motion.omega - _motion(generic, torque(lambda momentum: -0.1 * momentum)).omega).max() < 1e-14
    for found in (lambda t: (0.1, t, 1), lambda t: np.array([0.1, t, 1], dtype=np.float32), lambda t: [0.1, t, np.float32(1)]):
        assert _motion(generic, FunctionTorque(function=found)).omega.shape == (2, 3)
    for wrong in (lambda t: [t, 0.0], lambda t: np.zeros((3, 1)), lambda t: [0.0, 0.0, "1"], lambda t: 1j * LIMITS):
        with pytest.raises((polhode.PolhodeError, TypeError), match="torque of a function|three components"):
            _motion(generic, FunctionTorque(function=wrong))


def test_the_error_estimate_of_a_function_is_cheap_by_default(generic: polhode.MassProperties) -> None:
    def effort(acting: scenario.Torque, error: str) -> str:
        given = polhode.Scenario(generic, start=Start(omega=[0.5, -0.9, 0.7]), torques=[acting], run=Run(duration=1, samples=2))
        found: str = polhode.simulate(given, error=error).summary["error"]["effort"]
        return found

    function = FunctionTorque(function=lambda omega: -0.1 * omega)
    assert [effort(function, error) for error in ("auto", "cheap", "thorough")] == ["cheap", "cheap", "thorough"]
    assert effort(torque(lambda omega: -0.1 * omega), "auto") == "thorough"
