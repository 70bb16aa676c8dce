"""Scenarios: arrays, events, endings, Ctrl-C."""

from __future__ import annotations

import _thread
import json
import pickle
import threading
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest

def test_arrays_agree_with_each_other(examples: Path) -> None:
    motion = polhode.simulate(examples / "heavy-top.toml")
    n = len(motion)
    assert n == 2001 and motion.times[-1] == 2.0 and motion.ending.kind == "complete"
    assert motion.attitude.shape == (n, 4) and motion.torque.shape == (n, 3) and motion.work.shape == (n,)
    r = motion.rotations()
    assert np.abs(r.apply(motion.omega) - motion.omega_space).max() < 1e-12
    inertia = polhode.inertia(examples / "heavy-top.toml")
    about = inertia.inertia_about([0, 0, 0])
    assert np.abs(r.apply(motion.omega @ about) - motion.momentum).max() < 1e-15
    assert np.allclose(0.5 * (motion.omega * (motion.omega @ about)).sum(axis=1), motion.kinetic_energy, rtol=1e-13)
    weight = np.array([0, 0, -9.80665]) * inertia.mass
    torque = np.cross(inertia.center_of_mass, r.inv().apply(weight))
    assert np.abs(torque - motion.torque).max() < 1e-15
    total = motion.kinetic_energy + motion.potential_energy
    assert np.ptp(total) < 1e-12 * abs(total[0])
    columns = motion.columns()
    assert list(columns)[:6] == ["time_s", "attitude_w", "attitude_x", "attitude_y", "attitude_z", "omega_body_x_rad_s"]
    assert np.array_equal(columns["momentum_space_z_kg_m2_s"], motion.momentum[:, 2]) and len(columns) == 22
    assert np.array_equal(columns["work_j"], motion.work)
    assert np.array_equal(columns["attitude_error_rad"], motion.error.attitude)
    assert np.array_equal(columns["omega_error"], motion.error.omega)


def test_a_body_on_an_orbit_has_columns_of_where_it_points(examples: Path) -> None:
    motion = polhode.simulate(examples / "cubesat.toml")
    columns = motion.columns()
    position = np.column_stack([columns[f"position_space_{axis}_m"] for axis in "xyz"])
    camera = motion.rotations().apply([0.0, 0.0, 1.0])
    cosine = -(camera * position).sum(axis=1) / np.linalg.norm(position, axis=1)
    assert np.abs(np.cos(columns["camera_angle_rad"]) - cosine).max() < 1e-14
    assert motion.summary["pointings"][0]["largest_rad"] == columns["camera_angle_rad"].max()
    assert np.rad2deg(columns["orbit_pitch_rad"][0]) == pytest.approx(-7.0, abs=1e-12)


def test_wheels_have_columns(examples: Path) -> None:
    assert any(name.startswith("wheel_1_") for name in polhode.simulate(examples / "gyrostat.toml").columns())


def test_times_take_the_place_of_the_runs(examples: Path) -> None:
    whole = polhode.simulate(examples / "heavy-top.toml")
    some = polhode.simulate(examples / "heavy-top.toml", times=[0.5, 1.25])
    assert np.array_equal(some.times, [0.5, 1.25])
    assert np.abs(some.omega - whole.omega[[500, 1250]]).max() < 1e-9
    with pytest.raises(polhode.PolhodeError, match="not before the time that precedes it"):
        polhode.simulate(examples / "heavy-top.toml", times=[1.0, 0.5])


def test_a_summary_is_that_of_the_command(examples: Path) -> None:
    motion = polhode.simulate(examples / "t-handle.toml")
    assert motion.summary["motion"]["regime"] is not None
    assert json.dumps(motion.summary)
    assert motion.title in str(motion) and motion.title in repr(motion)


def test_what_was_assumed_is_said() -> None:
    text = '[[body.part]]\nshape = "sphere"\nradius = "20 mm"\nmass = "1 kg"\n[start]\nspin = { body = [0.1, 2, -0.3] }\n[run]\nduration = "2 s"\n'
    assert polhode.simulate(text).findings == []
    sweep = '[sweep]\nmembers = 9\nseed = 7\nsampling = "monte carlo"\n[[sweep.vary]]\nkey = "start.spin.body[1]"\nuniform = { from = 1, to = 3 }\n'
    with pytest.warns(polhode.PolhodeWarning, match=r"\[sweep.nominal\]"):
        motion = polhode.simulate(text + sweep)
    assert [finding.code for finding in motion.findings] == ["sweep.nominal"]


@pytest.mark.parametrize("kind", ["text", "file"])
def test_events_stop_a_motion(kind: str, tmp_path: Path, examples: Path) -> None:
    text = (examples / "events.toml").read_text()
    (tmp_path / "events.toml").write_text(text)
    motion = polhode.simulate(text if kind == "text" else str(tmp_path / "events.toml"))
    assert motion.events and all(event.time <= motion.times[-1] for event in motion.events)
    first = motion.events[0]
    assert first.name and np.isclose(np.linalg.norm(first.attitude), 1.0)
    if motion.ending.kind == "stopped":
        assert motion.ending.time == motion.times[-1]


def test_mistakes_have_their_place() -> None:
    with pytest.raises(polhode.PolhodeError, match="scenario.toml:3:10") as error:
        polhode.simulate('[[body.part]]\nshape = "sphere"\nradius = "20 kg"\nmass = "1 kg"\n')
    assert error.value.line == 3
    with pytest.raises(polhode.PolhodeError, match=r"no \[run\] section.*\nhint: give times"):
        polhode.simulate('[[body.part]]\nshape = "sphere"\nradius = "20 mm"\nmass = "1 kg"\n')
    with pytest.raises(FileNotFoundError):
        polhode.simulate("nowhere.toml")


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_ends_a_long_computation(examples: Path) -> None:
    text = (examples / "formula.toml").read_text().replace('"4 min"', '"1e8 s"').replace("samples = 961", "samples = 2")
    timer = threading.Timer(0.3, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        polhode.simulate(text)
    timer.join()
    # and the library is as it was
    assert polhode.simulate(examples / "heavy-top.toml", times=[0.1]).ending.kind == "complete"


def test_other_threads_run_meanwhile(examples: Path) -> None:
    text = (examples / "formula.toml").read_text().replace('"4 min"', '"1e5 s"').replace("samples = 961", "samples = 2")
    counted, done = [0], threading.Event()

    def count() -> None:
        while not done.is_set():
            counted[0] += 1
            done.wait(0.0001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    polhode.simulate(text)
    after = counted[0]
    done.set()
    thread.join()
    assert after > before + 1


def test_a_motion_that_fails_keeps_what_is_good() -> None:
    text = """
[[body.part]]
shape = "box"
size = ["0.3 m", "0.2 m", "0.1 m"]
mass = "1 kg"

[start]
spin = { body = ["0.1 rad/s", "0.2 rad/s", "1 rad/s"] }

[[torque]]
model = "formula"
axes = "body"
torque = ["0", "0", "1[kg m^2 s]*wz^3"]

[run]
duration = "1000 s"
samples = 11
"""
    with pytest.warns(polhode.PolhodeWarning, match="the motion ends at t = "):
        motion = polhode.simulate(text)
    assert motion.ending.kind == "failed" and motion.ending.time < 1000.0 and np.isfinite(motion.omega).all()


CHAOTIC = """
[[body.part]]
shape = "tensor"
mass = "1 kg"
inertia = [[1, 0, 0], [0, 2, 0], [0, 0, 2.5]]
[start]
spin = { body = [0.3, 0.5, 0.9] }
[orbit]
rate = "0.5 rad/s"
mu = "4e10 m^3/s^2"
[[torque]]
model = "gravity_gradient"
[run]
duration = "100 s"
samples = 11
"""


def test_a_motion_knows_how_far_it_may_be_off() -> None:
    with pytest.warns(polhode.PolhodeWarning, match="motion.error"):
        thorough = polhode.simulate(CHAOTIC, error="thorough")
    with pytest.warns(polhode.PolhodeWarning, match="motion.error"):
        cheap = polhode.simulate(CHAOTIC, error="cheap")
    for motion in (thorough, cheap):
        error = motion.error
        assert error is not None and all(column.shape == (11,) for column in error)
        # 2.5e-9 rad off at 100 s, held against 40 digits.
        assert 1.2e-9 < error.attitude[-1] < 1e-6 and error.attitude[1] < 1e-13
        assert (np.diff(error.attitude) >= 0).all()
    assert thorough.summary["error"]["effort"] == "thorough" and cheap.summary["error"]["effort"] == "cheap"
    with pytest.raises(polhode.PolhodeError, match="error = 'good' must be one of auto, cheap, thorough, none"):
        polhode.simulate(CHAOTIC, error="good")


def test_without_an_estimate_the_motion_is_the_same() -> None:
    body = polhode.MassProperties(mass=2.0, inertia=[[3.1, -0.4, 0.3], [-0.4, 4.2, -0.2], [0.3, -0.2, 5.3]])
    drag = polhode.scenario.Drag(law="linear", coefficient=0.2)
    start, run = polhode.scenario.Start(omega=[0.3, 0.5, 0.9]), polhode.scenario.Run(duration=3.0, samples=4)
    scenario = polhode.Scenario(body, start=start, torques=[drag], run=run)
    plain, estimated = polhode.simulate(scenario, error="none"), polhode.simulate(scenario)
    assert plain.error is None and estimated.error is not None
    assert (plain.omega == estimated.omega).all() and (plain.attitude == estimated.attitude).all()
    assert plain.extend(1.0, samples=3, error="none").error is None
    assert "error" not in str(plain).lower() or "not estimated" in str(plain)


def test_the_files_of_a_scenario_are_read_when_it_is_made(tmp_path: Path) -> None:
    corners = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
    faces = [(1, 3, 2), (1, 2, 4), (2, 3, 4), (1, 4, 3)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a} {b} {c}" for a, b, c in faces]
    mesh = tmp_path / "corner.obj"
    mesh.write_text("\n".join(lines))
    text = """
        [[body.part]]
        name = "corner"
        shape = "mesh"
        file = "corner.obj"
        unit = "m"
        density = "2 kg/m^3"
        [start]
        spin = { body = [0.3, 0.5, 0.9] }
        [run]
        duration = "3 s"
        samples = 3
    """
    scenario = polhode.Scenario.from_toml(text, folder=tmp_path)
    first = polhode.simulate(scenario)
    mesh.unlink()
    assert (polhode.simulate(scenario).omega == first.omega).all()
    # A copy reads the file again.
    with pytest.raises(FileNotFoundError, match="corner.obj"):
        polhode.simulate(pickle.loads(pickle.dumps(scenario)))


def test_a_free_motion_knows_what_its_inputs_are_worth() -> None:
    motion = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, -0.5, 0.9], attitude=[0.4, -0.7, 1.1, 0.3])
    times = [1e6, -1e3, 1.0]
    error = motion.error(times)
    assert error.attitude.max() < 2.1e-15 and (error.inputs_attitude[:2] / error.inputs_attitude[2] > [1e4, 1e2]).all()
    # A moment that differs in its last bit, in the same way.
    other = polhode.FreeMotion(moments=[1, np.nextafter(2, 3), 2.5], omega=[0.3, -0.5, 0.9], attitude=[0.4, -0.7, 1.1, 0.3])
    apart = np.linalg.norm(other.at(times).attitude - motion.at(times).attitude, axis=1)
    assert (apart < 4 * error.inputs_attitude).all() and (apart > 0.05 * error.inputs_attitude)[:2].all()
    with pytest.raises(polhode.PolhodeError, match="too far away"):
        motion.error([1e40])


def test_a_body_is_simulated_without_a_scenario() -> None:
    body = polhode.MassProperties(mass=2.0, inertia=[[3.1, -0.4, 0.3], [-0.4, 4.2, -0.2], [0.3, -0.2, 5.3]])
    omega, attitude = [0.3, -0.5, 0.9], [0.4, -0.7, 1.1, 0.3]
    drag = polhode.scenario.Drag(law="linear", coefficient=0.2)
    constant = polhode.scenario.ConstantTorque(axes="body", torque=[0.1, -0.2, 0.3])

    def law(t: float, omega: Any) -> Any:
        return 0.1 * np.sin(t) * omega

    def branches(t: float) -> list[float]:
        return [0.1 if t < 1.0 else 0.0, 0.0, 0.0]

    given = [(drag, [drag]), ([drag, constant], [drag, constant]), ([0.1, -0.2, 0.3], [constant]), (np.array([0.1, -0.2, 0.3]), [constant])]
    given += [(law, [polhode.scenario.torque(law)]), (branches, [polhode.scenario.FunctionTorque(function=branches, axes="body")]), (None, [])]
    for short, torques in given:
        start, run = polhode.scenario.Start(omega=omega, attitude=attitude), polhode.scenario.Run(duration=3.0, samples=4)
        whole = polhode.simulate(polhode.Scenario(body, start=start, torques=torques, run=run))
        found = polhode.simulate(body, omega=omega, attitude=attitude, torque=short, duration="3 s", samples=4)
        assert (found.omega == whole.omega).all() and (found.attitude == whole.attitude).all()
        timed = polhode.simulate(body, omega=omega, attitude=attitude, torque=short, times=[0.0, 1.0, 2.0, 3.0])
        assert (timed.omega == whole.omega).all()


def test_what_a_body_lacks_is_said() -> None:
    body = polhode.MassProperties(mass=2.0, inertia=[1.0, 2.0, 2.5])
    scenario = polhode.Scenario(body, start=polhode.scenario.Start(omega=[0, 0, 1]), run=polhode.scenario.Run(duration=1.0))
    for expected, call in {
        "omega is missing": lambda: polhode.simulate(body, duration=1.0),
        "either a duration": lambda: polhode.simulate(body, omega=[0, 0, 1]),
        "samples is for a duration": lambda: polhode.simulate(body, omega=[0, 0, 1], times=[0.0, 1.0], samples=3),
        "torque must have the shape": lambda: polhode.simulate(body, omega=[0, 0, 1], duration=1.0, torque=[1.0, 2.0]),
        "omega, duration: these arguments are for a body": lambda: polhode.simulate(scenario, omega=[0, 0, 1], duration=1.0),
    }.items():
        with pytest.raises(polhode.PolhodeError, match=expected):
            call()
