"""Derivatives of motions: against central differences of whole motions, and covariances against what many motions do."""

from __future__ import annotations

import pickle
from collections.abc import Callable

import numpy as np
import polhode
import pytest
from scipy.spatial.transform import Rotation

INERTIA = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
OMEGA = np.array([0.7, -1.1, 0.4])
ATTITUDE = np.array([0.4, -0.7, 1.1, 0.3])
ATTITUDE /= np.linalg.norm(ATTITUDE)
PLACES = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]

States = tuple[np.ndarray, np.ndarray]


def changed(column: int, by: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Tensor, ω and attitude with one of θ, ω and Ixx … Iyz changed."""
    inertia, omega, attitude = INERTIA.copy(), OMEGA.copy(), Rotation.from_quat(ATTITUDE[[1, 2, 3, 0]])
    if column < 3:
        attitude = attitude * Rotation.from_rotvec(by * np.eye(3)[column])
    elif column < 6:
        omega[column - 3] += by
    else:
        i, j = PLACES[column - 6]
        inertia[i, j] = inertia[j, i] = inertia[i, j] + by
    return inertia, omega, attitude.as_quat()[[3, 0, 1, 2]]


def between(before: States, after: States) -> np.ndarray:
    """θ and ω from one state to another (n, 6)."""
    (omega, attitude), (omega_after, attitude_after) = before, after
    first, second = (Rotation.from_quat(wxyz[:, [1, 2, 3, 0]]) for wxyz in (attitude, attitude_after))
    return np.hstack([(first.inv() * second).as_rotvec(), omega_after - omega])


def differenced(states: Callable[[float], States], h: float = 5e-4) -> np.ndarray:
    """Central differences (n, 6) of fourth order."""
    here = states(0.0)

    def slope(h: float) -> np.ndarray:
        return (between(here, states(h)) - between(here, states(-h))) / (2.0 * h)

    return (4.0 * slope(0.5 * h) - slope(h)) / 3.0


def free(inertia: np.ndarray = INERTIA, omega: np.ndarray = OMEGA, attitude: np.ndarray = ATTITUDE) -> polhode.FreeMotion:
    return polhode.FreeMotion(inertia=inertia, omega=omega, attitude=attitude)


def test_free_motion_has_the_derivatives_of_differences() -> None:
    times = np.array([-2.0, 0.05, 3.0, 25.0])
    derivatives = free().derivatives(times)
    columns = np.concatenate([derivatives.by_start, derivatives.by_inertia], axis=2)
    for column in range(12):
        want = differenced(lambda h: free(*changed(column, h)).at(times))
        assert np.abs(columns[:, :, column] - want).max() < 1e-9 * max(1.0, np.abs(want).max()), column


def test_states_beside_derivatives_are_those_of_the_motion() -> None:
    times = np.array([0.0, 40.0, 3.0, -1e4])
    for motion in (free(), polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=OMEGA, attitude=ATTITUDE)):
        derivatives, states = motion.derivatives(times), motion.at(times)
        assert np.array_equal(derivatives.times, times)
        assert np.array_equal(derivatives.omega, states.omega)
        assert np.array_equal(derivatives.attitude, states.attitude)
    one = free().derivatives(3.0)
    for name in ("times", "omega", "attitude", "by_start", "by_inertia", "by_parameters"):
        # Of one time the quaternion has w ≥ 0.
        many = getattr(free().derivatives([3.0]), name)[0]
        assert np.array_equal(getattr(one, name), many) and np.shape(getattr(one, name)) == np.shape(many)
    assert one.covariance(start=np.eye(6)).shape == (6, 6)
    assert free().derivatives([]).by_start.shape == (0, 6, 6)


def test_the_size_of_the_body_does_not_show() -> None:
    derivatives = free().derivatives(np.linspace(0.0, 30.0, 7))
    elements = [INERTIA[place] for place in PLACES]
    assert np.abs(derivatives.by_inertia @ elements).max() < 1e-11


def test_a_covariance_is_that_of_many_motions() -> None:
    rng = np.random.default_rng(11)
    root = 1e-5 * rng.normal(size=(12, 12))
    joint = root @ root.T
    draws = rng.normal(size=(20_000, 12)) @ root.T
    inertia = np.repeat(INERTIA[None], len(draws), axis=0)
    for (i, j), by in zip(PLACES, draws[:, 6:].T):
        inertia[:, i, j] = inertia[:, j, i] = inertia[:, i, j] + by
    turned = (Rotation.from_quat(ATTITUDE[[1, 2, 3, 0]]) * Rotation.from_rotvec(draws[:, :3])).as_quat()[:, [3, 0, 1, 2]]
    states = polhode.Ensemble(inertia=inertia, omega=OMEGA + draws[:, 3:6], attitude=turned).at([6.0])
    derivatives = free().derivatives([6.0])
    there = between((derivatives.omega, derivatives.attitude), (states.omega[:, 0], states.attitude[:, 0]))
    drawn, said = np.cov(there.T), derivatives.covariance(joint=joint)[0]
    # 20,000 draws know a variance to 1 %, a correlation to 0.007.
    sd = np.sqrt(np.diag(said))
    assert np.abs(np.sqrt(np.diag(drawn)) / sd - 1.0).max() < 0.02
    assert np.abs((drawn - said) / np.outer(sd, sd)).max() < 0.04


def test_a_covariance_is_j_c_jt() -> None:
    rng = np.random.default_rng(12)
    motion = polhode.simulate(PUSHED, times=[0.0, 2.5], derivatives=["torque[1].xx", "torque[0].y"])
    derivatives = motion.derivatives
    assert derivatives is not None
    roots = [rng.normal(size=(n, n)) for n in (6, 6, 2)]
    start, inertia, parameters = (root @ root.T for root in roots)
    blocks = [derivatives.by_start[1], derivatives.by_inertia[1], derivatives.by_parameters[1]]
    want = sum(j @ c @ j.T for j, c in zip(blocks, (start, inertia, parameters)))
    assert np.allclose(derivatives.covariance(start=start, inertia=inertia, parameters=parameters)[1], want, rtol=1e-12)
    assert np.allclose(derivatives.covariance(inertia=inertia)[1], blocks[1] @ inertia @ blocks[1].T, rtol=1e-12)
    root = rng.normal(size=(14, 14))
    jacobian = np.hstack(blocks)
    assert np.allclose(derivatives.covariance(joint=root @ root.T)[1], jacobian @ root @ root.T @ jacobian.T, rtol=1e-12)


BODY = """
[[body.part]]
shape = "tensor"
mass = "2.3 kg"
inertia = {inertia}
[start]
attitude = {{ quaternion = {attitude} }}
spin = {{ body = {omega} }}
[[torque]]
name = "push"
model = "constant"
axes = "body"
torque = [0.3, {push}, 0.2]
[[torque]]
model = "drag"
law = "linear"
coefficient = [[{drag}, 0.02, 0.01], [0.02, 0.4, -0.03], [0.01, -0.03, 0.5]]
[[event]]
name = "faster"
measure = "omega_body_x"
value = 0.93
[run]
duration = 4
samples = 5
"""


def pushed(inertia: np.ndarray = INERTIA, omega: np.ndarray = OMEGA, attitude: np.ndarray = ATTITUDE, push: float = -0.4, drag: float = 0.3) -> str:
    return BODY.format(inertia=inertia.tolist(), omega=omega.tolist(), attitude=attitude.tolist(), push=push, drag=drag)


PUSHED = pushed()


def test_motion_under_torque_has_the_derivatives_of_differences() -> None:
    motion = polhode.simulate(PUSHED, derivatives=["torque[0].y", "torque[1].xx"])
    derivatives = motion.derivatives
    assert derivatives is not None and derivatives.parameters == ("torque[0].y", "torque[1].xx")
    assert np.array_equal(derivatives.times, motion.times)
    assert np.abs(derivatives.omega - motion.omega).max() < 1e-13
    (event,) = derivatives.events
    assert (event.name, motion.events[0].name) == ("faster", "faster") and abs(event.time - motion.events[0].time) < 1e-12
    columns = np.concatenate([derivatives.by_start, derivatives.by_inertia, derivatives.by_parameters], axis=2)
    at_event = np.hstack([event.by_start, event.by_inertia, event.by_parameters])
    of_time = np.concatenate([event.time_by_start, event.time_by_inertia, event.time_by_parameters])
    texts: list[Callable[[float], str]] = [lambda h, k=k: pushed(*changed(k, h)) for k in range(12)]
    texts += [lambda h: pushed(push=-0.4 + h), lambda h: pushed(drag=0.3 + h)]
    steps = (2.5e-4, -2.5e-4, 5e-4, -5e-4)
    for column, text in enumerate(texts):
        runs = {h: polhode.simulate(text(h), error="cheap") for h in (0.0, *steps)}
        want = differenced(lambda h: (runs[h].omega, runs[h].attitude))
        assert np.abs(columns[:, :, column] - want).max() < 1e-8, column
        crossings = {h: run.events[0] for h, run in runs.items()}
        want = differenced(lambda h: (np.array([crossings[h].omega]), np.array([crossings[h].attitude])))
        assert np.abs(at_event[:, column] - want[0]).max() < 1e-8, column
        coarse, fine = ((crossings[h].time - crossings[-h].time) / (2.0 * h) for h in (5e-4, 2.5e-4))
        assert abs(of_time[column] - (4.0 * fine - coarse) / 3.0) < 1e-8, column


def test_a_scenario_without_torque_has_those_of_free_motion() -> None:
    text = f'[[body.part]]\nshape = "tensor"\nmass = 1\ninertia = {INERTIA.tolist()}\n[start]\nattitude = {{ quaternion = {ATTITUDE.tolist()} }}\nspin = {{ body = {OMEGA.tolist()} }}\n'
    times = [0.0, 1.5, 20.0]
    under, closed = polhode.simulate(text, times=times, derivatives=[]).derivatives, free().derivatives(times)
    assert under is not None and under.by_parameters.shape == (3, 6, 0) and under.events == ()
    assert np.abs(under.by_start - closed.by_start).max() < 1e-11
    assert np.abs(under.by_inertia - closed.by_inertia).max() < 1e-11
    assert polhode.simulate(text, times=times).derivatives is None


def test_a_motion_that_stops_has_derivatives_as_far_as_it_goes() -> None:
    stops = PUSHED.replace("value = 0.93", 'value = 0.93\nthen = "stop"')
    motion = polhode.simulate(stops, derivatives=[])
    assert motion.derivatives is not None
    assert np.allclose(motion.derivatives.times, motion.times, rtol=1e-13) and motion.times[-1] < 4.0


def test_what_has_no_derivatives_is_refused() -> None:
    with pytest.raises(polhode.PolhodeError, match=r'derivatives\[1\] = "torque\[0\].stiffness" must be a parameter of a torque') as error:
        polhode.simulate(PUSHED, derivatives=["torque[1].xy", "torque[0].stiffness"])
    assert "torque[0].x, torque[0].y, torque[0].z, torque[0].factor, torque[1].xx" in str(error.value.hint)
    for odd in ("torque[2].factor", "torque[x].y", "start.spin.body[0]", "torque[0]y"):
        with pytest.raises(polhode.PolhodeError, match="must be a parameter of a torque"):
            polhode.simulate(PUSHED, derivatives=[odd])
    with pytest.raises(TypeError, match="derivatives must be a list"):
        polhode.simulate(PUSHED, derivatives="torque[0].y")
    with pytest.raises(polhode.PolhodeError, match="Taylor"):
        polhode.simulate(PUSHED.replace("samples = 5", 'samples = 5\nmethod = "dop853"'), derivatives=[])
    with pytest.raises(polhode.PolhodeError, match="not physical"):
        polhode.FreeMotion(moments=[1, 2, 9], omega=OMEGA, allow_unphysical=True).derivatives([1.0])
    with pytest.raises(polhode.PolhodeError, match="1e-8 of the greatest"):
        polhode.FreeMotion(moments=[0, 2, 2], omega=OMEGA).derivatives([1.0])
    with pytest.raises(polhode.PolhodeError, match="t = 1000 s the derivatives are too large"):
        polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 1, 0]).derivatives([0.0, 1e3])
    with pytest.raises(polhode.PolhodeError, match="too far away"):
        free().derivatives([1e40])


def test_covariances_that_are_none_are_refused() -> None:
    derivatives = free().derivatives([1.0])
    odd = np.eye(6)
    odd[0, 1] = 0.5
    twisted = np.eye(6)
    twisted[0, 1] = twisted[1, 0] = 1.5
    for given, message in [
        ({}, "no covariance is given"),
        ({"start": np.eye(5)}, r"start must have the shape \(6, 6\)"),
        ({"start": -np.eye(6)}, "variances"),
        ({"inertia": odd}, "the other side of the diagonal"),
        ({"inertia": twisted}, "two variances"),
        ({"joint": np.eye(13)}, r"joint must have the shape \(12, 12\)"),
        ({"joint": np.eye(12), "start": np.eye(6)}, "give either joint or start"),
        ({"start": np.full((6, 6), np.nan)}, "finite"),
    ]:
        with pytest.raises(polhode.PolhodeError, match=message):
            derivatives.covariance(**given)


def test_derivatives_are_values() -> None:
    motion = polhode.simulate(PUSHED, derivatives=["torque[0].factor"])
    derivatives = motion.derivatives
    assert derivatives is not None
    again = pickle.loads(pickle.dumps(derivatives))
    assert again == derivatives and pickle.loads(pickle.dumps(motion)).derivatives == derivatives
    assert derivatives != polhode.simulate(PUSHED, derivatives=[]).derivatives and derivatives != 3
    assert repr(derivatives) == "Derivatives(5 times, by start, inertia, torque[0].factor)"
    assert repr(free().derivatives(2.0)) == "Derivatives(t = 2 s, by start, inertia)"
    for it in (derivatives, again, *again.events):
        with pytest.raises(ValueError, match="read-only"):
            it.by_start[0] = 0.0
        with pytest.raises(AttributeError):
            it.by_start = np.zeros(3)
