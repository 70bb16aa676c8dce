"""Ensembles: each member has the bits that it has alone."""

from __future__ import annotations

import _thread
import os
import sys
import threading
import time

import numpy as np
import polhode
import pytest
from polhode import _native
from scipy.spatial.transform import Rotation

RNG = np.random.default_rng(20)
COUNT = 37
OMEGA = RNG.normal(size=(COUNT, 3))
#: Of random boxes: i1 + i2 ≥ i3.
SQUARES = RNG.uniform(0.1, 2.0, size=(COUNT, 3))
MOMENTS = SQUARES[:, [1, 2, 0]] + SQUARES[:, [2, 0, 1]]
TURNS = Rotation.from_rotvec(RNG.normal(size=(COUNT, 3)))
TENSORS = np.einsum("nij,nj,nkj->nik", TURNS.as_matrix(), MOMENTS, TURNS.as_matrix())
TENSORS = 0.5 * (TENSORS + TENSORS.transpose(0, 2, 1))
TIMES = [0.0, 0.7, 40.0, 1e5]

DRAG = """
[[torque]]
model = "formula"
axes = "body"
torque = ["-0.3[N m s]*wx", "0.1[N m]*sin(2[rad/s]*t)", "-0.2[N m s]*wz"]
"""


def test_free_members_have_the_bits_of_one_motion() -> None:
    ensemble = polhode.Ensemble(inertia=TENSORS, omega=OMEGA, attitude=TURNS)
    omega, attitude = states = ensemble.at(TIMES)
    assert omega.shape == (COUNT, 4, 3) and attitude.shape == (COUNT, 4, 4) and len(ensemble) == COUNT
    assert not states.failures and np.array_equal(states.reached, np.tile(TIMES, (COUNT, 1)))
    for k in range(COUNT):
        one = polhode.FreeMotion(inertia=TENSORS[k], omega=OMEGA[k], attitude=TURNS[k]).at(TIMES)
        assert np.array_equal(omega[k], one.omega) and np.array_equal(attitude[k], one.attitude)
    in_space = states.rotations(5).apply(omega[5] @ TENSORS[5])
    assert np.abs(in_space - in_space[0]).max() < 1e-13


def test_threads_and_neighbours_change_no_bit() -> None:
    times = [0.5, 3.0]
    whole = polhode.Ensemble(moments=MOMENTS, omega=OMEGA, torques=DRAG).at(times, threads=1)
    many = polhode.Ensemble(moments=MOMENTS, omega=OMEGA, torques=DRAG).at(times, threads=5)
    some = polhode.Ensemble(moments=MOMENTS[7:12], omega=OMEGA[7:12], torques=DRAG).at(times)
    assert np.array_equal(whole.omega, many.omega) and np.array_equal(whole.attitude, many.attitude)
    assert np.array_equal(whole.omega[7:12], some.omega) and np.array_equal(whole.attitude[7:12], some.attitude)


def test_what_all_share_is_given_once() -> None:
    one = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=OMEGA, attitude=[0.4, -0.7, 1.1, 0.3])
    each = polhode.Ensemble(
        moments=np.tile([1.0, 2.0, 2.5], (COUNT, 1)), omega=OMEGA, attitude=np.tile([0.4, -0.7, 1.1, 0.3], (COUNT, 1))
    )
    assert np.array_equal(one.at(TIMES).attitude, each.at(TIMES).attitude)
    assert len(polhode.Ensemble(moments=[1, 2, 2.5], omega=[1, 2, 3])) == 1
    assert len(polhode.Ensemble(moments=MOMENTS, omega=[1, 2, 3])) == COUNT


@pytest.mark.parametrize(
    ("changed", "says"),
    [
        ({"omega": OMEGA[:5]}, "omega has 5, moments has 37"),
        ({"omega": np.where(np.arange(3 * COUNT).reshape(-1, 3) == 20, np.nan, OMEGA)}, r"omega\[6, 2\] = nan must be finite"),
        ({"moments": np.where(np.arange(COUNT)[:, None] == 9, [1.0, 1.0, 3.0], MOMENTS)}, "member 9: .*i1 .* i2 = 2 "),
        ({"moments": None}, "exactly one"),
        ({"torques": "[[torque]]\nmodel = 'friction'"}, "torques:2:"),
        ({"torques": DRAG + "[run]\nduration = 1\n"}, r"only \[\[torque\]\] tables"),
        ({"attitude": np.zeros((COUNT, 4))}, r"attitude\[0, 0\]"),
        ({"omega": np.zeros((2, COUNT, 3))}, r"omega must have the shape \(n, 3\)"),
    ],
)
def test_mistakes_are_refused(changed: dict[str, object], says: str) -> None:
    with pytest.raises(polhode.PolhodeError, match=says):
        polhode.Ensemble(**({"moments": MOMENTS, "omega": OMEGA} | changed))


def test_mistakes_in_times_are_refused() -> None:
    ensemble = polhode.Ensemble(moments=MOMENTS, omega=OMEGA)
    for times, options, says in (
        ([1.0, 0.5], {}, "not before the time that precedes it"),
        ([-1.0], {}, "not before the start"),
        ([1.0], {"threads": 0}, "threads = 0 must be"),
        ([1.0], {"threads": 1.5}, "threads = 1.5 must be"),
        ([1.0], {"tolerance": 0.0}, "tolerance = 0.0 must be positive"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            ensemble.at(times, **options)


def test_a_member_that_cannot_go_on_is_said() -> None:
    spins = np.array([[0.0, 0.0, 0.1], [0.0, 0.0, 50.0]])
    ensemble = polhode.Ensemble(
        moments=[1.0, 2.0, 2.5], omega=spins, torques='[[torque]]\nmodel = "formula"\naxes = "body"\ntorque = ["0", "0", "1[kg m^2 s]*wz^3"]\n'
    )
    with pytest.warns(polhode.PolhodeWarning, match="1 of 2 members failed; the first is 1"):
        states = ensemble.at([0.0, 1.0])
    ((member, time, cause),) = states.failures
    # ω̇ = ω³/I grows beyond all bounds at t = I/(2 ω₀²).
    assert member == 1 and 0.0 < time < 2.5 / (2.0 * 50.0**2) and "diverges" in cause, cause
    assert np.isfinite(states.omega).all() and states.reached[0, 1] == 1.0


def test_a_method_is_chosen() -> None:
    free = polhode.Ensemble(inertia=TENSORS, omega=OMEGA, attitude=TURNS)
    closed = free.at([0.1, 0.4])
    assert np.array_equal(free.at([0.1, 0.4], method="exact").omega, closed.omega)
    for method in ["taylor", "dop853"]:
        states = free.at([0.1, 0.4], method=method)
        assert np.allclose(states.omega, closed.omega, rtol=0.0, atol=1e-12) and not np.array_equal(states.omega, closed.omega)
        assert np.allclose(states.attitude, closed.attitude, rtol=0.0, atol=1e-12)
    driven = polhode.Ensemble(moments=MOMENTS, omega=OMEGA, torques=DRAG)
    with pytest.warns(polhode.PolhodeWarning, match="37 of 37 members failed; the first is 0: .*closed form"):
        driven.at([0.1], method="exact")
    with pytest.raises(polhode.PolhodeError, match="method"):
        free.at([0.1], method="rk4")


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_ends_the_construction_of_an_ensemble() -> None:
    tensors, omega = np.tile(TENSORS, (20_000, 1, 1)), np.tile(OMEGA, (20_000, 1))
    begun = time.perf_counter()
    timer = threading.Timer(0.15, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        polhode.Ensemble(inertia=tensors, omega=omega)
    assert time.perf_counter() - begun < 1.0
    timer.join()


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_ends_an_ensemble() -> None:
    ensemble = polhode.Ensemble(moments=MOMENTS[0], omega=np.tile(OMEGA, (1000, 1)), torques=DRAG)
    timer = threading.Timer(0.2, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        ensemble.at([1e4], threads=1)
    timer.join()


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="macOS and Windows have no os.sched_setaffinity")
def test_threads_are_those_that_the_process_may_use() -> None:
    allowed = os.sched_getaffinity(0)
    assert 1 <= _native.available_threads() <= len(allowed)
    try:
        os.sched_setaffinity(0, {min(allowed)})
        assert _native.available_threads() == 1
    finally:
        os.sched_setaffinity(0, allowed)


def test_work_goes_on_beside_a_thread_of_python() -> None:
    """To look for Ctrl-C costs a switch of threads where another one computes, here half a second: at every few members it would be minutes."""
    ensemble = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=RNG.normal(size=(20_000, 3)))
    free = polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=[0.3, 0.5, 0.9])
    times, interval, stop = np.linspace(0.0, 1e3, 200_000), sys.getswitchinterval(), threading.Event()

    def work() -> float:
        began = time.perf_counter()
        ensemble.at([1.0])
        free.at(times)
        return time.perf_counter() - began

    def busy() -> None:
        while not stop.is_set():
            sum(range(1000))

    alone = work()
    thread = threading.Thread(target=busy)
    sys.setswitchinterval(0.5)
    thread.start()
    try:
        beside = work()
    finally:
        stop.set()
        thread.join()
        sys.setswitchinterval(interval)
    assert beside < 6.0 * alone + 8.0
