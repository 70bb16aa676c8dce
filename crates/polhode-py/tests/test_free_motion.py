"""Free motion: against references of many digits, SciPy's integrator, and the conservation of L in space."""

from __future__ import annotations

import pickle
import tomllib
from pathlib import Path

import numpy as np
import polhode
import pytest
from conftest import matrix
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

TURN = np.array([0.4, -0.7, 1.1, 0.3])


def test_states_have_the_digits_of_the_references(fixtures: Path) -> None:
    cases = tomllib.loads((fixtures / "free_asymmetric.toml").read_text())["case"]
    assert len(cases) > 3
    for case in cases:
        motion = polhode.FreeMotion(
            moments=[float(i) for i in case["moments"]],
            omega=[float(w) for w in case["omega0"]],
            attitude=[float(q) for q in case["attitude0"]],
            allow_unphysical=True,
        )
        rows = case["row"]
        states = motion.at([float(row["t"]) for row in rows])
        for row, omega, wxyz in zip(rows, *states):
            wanted = np.array([float(w) for w in row["omega"]])
            # 4e-15 is the library's own bound; decimal digits of the start are rounded, which grows with time.
            bound = 1e-14 * max(1.0, abs(float(row["t"])))
            assert np.abs(omega - wanted).max() <= bound * np.linalg.norm(wanted), case["name"]
            assert 1.0 - abs(wxyz @ [float(q) for q in row["attitude"]]) <= max(bound**2, 1e-15)


def test_energy_beyond_the_range_of_numbers_is_refused() -> None:
    for given in ({"moments": [1.37, 2.09, 2.91]}, {"inertia": np.diag([1.37, 2.09, 2.91])}):
        with pytest.raises(polhode.PolhodeError, match="too large for a double"):
            polhode.FreeMotion(**given, omega=[3e160, -5e160, 9e160], attitude=TURN)
        motion = polhode.FreeMotion(**given, omega=[3e150, -5e150, 9e150], attitude=TURN)
        assert np.isfinite(motion.kinetic_energy)


def test_a_time_beyond_reach_is_refused() -> None:
    motion = polhode.FreeMotion(moments=[1.37, 2.09, 2.91], omega=[0.3, -0.5, 0.9], attitude=TURN)
    assert np.isfinite(motion.at(1e22).omega).all()
    for times in (1e40, [0.0, -1e30, 2.0], 1e300):
        with pytest.raises(polhode.PolhodeError, match=r"too far away: this motion is known up to 2\.\de25 s"):
            motion.at(times)
    with pytest.raises(polhode.PolhodeError, match="finite"):
        motion.at([1.0, float("nan")])


def test_a_start_that_is_unit_to_rounding_keeps_its_bits() -> None:
    for k in range(1000):
        q = np.random.default_rng(k).normal(size=4)
        q = q / np.linalg.norm(q) * np.sign(q[0])
        motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.3, 0.5, 0.9], attitude=q)
        assert (motion.at(0.0).attitude == q).all()


def test_a_tensor_with_products_moves_as_euler_says(generic: polhode.MassProperties) -> None:
    inertia, start = generic.inertia, np.array([0.9, -1.3, 0.7])
    times = np.linspace(0.0, 12.0, 7)

    def euler(_: float, y: np.ndarray) -> np.ndarray:
        w, q = y[:3], y[3:]
        rate = np.linalg.solve(inertia, np.cross(inertia @ w, w))
        turning = 0.5 * np.array([-q[1:] @ w, *(q[0] * w + np.cross(q[1:], w))])
        return np.concatenate([rate, turning])

    wxyz = TURN / np.linalg.norm(TURN)
    solved = solve_ivp(euler, (0.0, 12.0), [*start, *wxyz], "DOP853", times, rtol=1e-12, atol=1e-13).y.T
    for motion in (
        polhode.FreeMotion(inertia=inertia, omega=start, attitude=TURN),
        polhode.FreeMotion(inertia=generic, omega=start, attitude=Rotation.from_matrix(matrix(TURN))),
    ):
        omega, attitude = motion.at(times)
        assert np.abs(omega - solved[:, :3]).max() < 1e-9
        assert (1.0 - np.abs((attitude * solved[:, 3:]).sum(axis=1))).max() < 1e-12


def test_rotations_are_scalar_first_here_and_scalar_last_in_scipy(generic: polhode.MassProperties) -> None:
    motion = polhode.FreeMotion(inertia=generic, omega=[0.9, -1.3, 0.7], attitude=TURN)
    times = np.array([0.0, 0.3, 4.0, 1e6])
    states, rotations = motion.at(times), motion.rotations(times)
    assert np.allclose(states.attitude[0], TURN / np.linalg.norm(TURN), rtol=0, atol=1e-15)
    for wxyz, r in zip(states.attitude, rotations.as_matrix()):
        assert np.allclose(matrix(wxyz), r, rtol=0, atol=1e-15)
    in_space = rotations.apply(states.omega @ generic.inertia)
    assert np.abs(in_space - motion.momentum).max() < 2e-14
    assert motion.rotations(0.3).as_matrix().shape == (3, 3)


def test_quaternions_are_continuous() -> None:
    motion = polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=[0.3, 0.5, 6.0], attitude=-TURN)
    _, attitude = motion.at(np.linspace(0.0, 50.0, 5001))
    assert attitude[0, 0] > 0.0 and (attitude[:, 0] < 0.0).any()
    assert (attitude[1:] * attitude[:-1]).sum(axis=1).min() > 0.9


def test_many_times_are_each_of_them() -> None:
    motion = polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=[0.3, 0.5, 0.9])
    # more than one piece, with a rest
    times = np.linspace(-1e3, 1e6, (1 << 16) + 12_345)
    omega, attitude = motion.at(times)
    for k in (0, 1, (1 << 16) - 1, 1 << 16, len(times) - 1):
        one = motion.at(times[k])
        assert np.array_equal(omega[k], one.omega)
        assert np.array_equal(np.abs(attitude[k]), np.abs(one.attitude))


def test_what_is_said_of_a_motion() -> None:
    motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
    assert motion.regime == "short_axis"
    assert np.isclose(motion.period, 39.10573419726872, rtol=1e-15)
    assert motion.flip_interval == 0.5 * motion.period
    assert np.isclose(motion.growth_rate, np.sqrt(1 / 3), rtol=1e-14)
    assert np.isclose(motion.kinetic_energy, 0.5 * (1e-4 + 2 + 3e-4))
    assert np.allclose(motion.momentum, [0.01, 2.0, 0.03])
    assert motion.precession_period == motion.summary["motion"]["precession_period_s"] > 0.0
    least, greatest = motion.nutation_range
    assert 0.0 < least < greatest < np.pi
    assert polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 2]).period is None
    assert polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 0]).regime == "at_rest"
    assert polhode.FreeMotion(moments=[8, 4, 0.4], omega=[0.1, 0.2, 5], allow_unphysical=True).period is not None
    # the order of moments is that of the body's axes
    turned = polhode.FreeMotion(moments=[3, 1, 2], omega=[0.01, 0.01, 1])
    assert np.isclose(turned.period, motion.period, rtol=1e-14) and turned.moments.tolist() == [1, 2, 3]


def test_copies_move_alike() -> None:
    motion = polhode.FreeMotion(inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]], omega=[1, 2, 3], attitude=TURN)
    copy = pickle.loads(pickle.dumps(motion))
    assert np.array_equal(copy.at([5.0]).omega, motion.at([5.0]).omega)


def test_rods_and_points_are_told_apart() -> None:
    assert polhode.FreeMotion(moments=[0, 2, 2], omega=[3, 1, 0.5]).regime != "at_rest"
    with pytest.raises(polhode.PolhodeError, match="no inertia"):
        polhode.FreeMotion(moments=[0, 0, 0], omega=[1, 0, 0])
