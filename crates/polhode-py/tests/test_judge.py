"""Motions of other programs, judged: what their numbers mean, how far they are off, why, and what is refused."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest
from conftest import matrix

INERTIA = np.array([[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]])
BODY = f"""
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
inertia = {INERTIA.tolist()}
[start]
attitude = {{ quaternion = [0.6, -0.3, 0.5, 0.2] }}
spin = {{ body = [0.7, -1.2, 0.4] }}
"""
#: Under a torque, so that neither T nor L is constant.
PUSHED = BODY + '[[torque]]\nmodel = "constant"\naxes = "body"\ntorque = ["0.05 N m", "-0.02 N m", "0.03 N m"]\n'
START = np.array([0.6, -0.3, 0.5, 0.2]) / np.linalg.norm([0.6, -0.3, 0.5, 0.2])
OMEGA = np.array([0.7, -1.2, 0.4])
TIMES = np.linspace(0.0, 6.0, 301)


@pytest.fixture(scope="module")
def exact() -> polhode.results.Motion:
    return polhode.simulate(PUSHED, times=TIMES)


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Quaternions, scalar first, row by row."""
    (w, x, y, z), (p, q, r, s) = a.T, b.T
    return np.column_stack(
        [w * p - x * q - y * r - z * s, w * q + x * p + y * s - z * r, w * r - x * s + y * p + z * q, w * s + x * r - y * q + z * p]
    )


def turn(vector: np.ndarray) -> np.ndarray:
    """exp of rotation vectors (n, 3)."""
    angle = np.linalg.norm(vector, axis=1, keepdims=True)
    return np.hstack([np.cos(0.5 * angle), 0.5 * np.sinc(0.5 * angle / np.pi) * vector])


def constant_omega() -> np.ndarray:
    """What a program makes that leaves ω × I ω out: a turn about one axis for ever."""
    return product(np.tile(START, (len(TIMES), 1)), turn(TIMES[:, None] * OMEGA))


def upwards(vectors: np.ndarray) -> np.ndarray:
    """Along axes x, z, -y of the scenario: y is up."""
    return vectors[:, [0, 2, 1]] * [1, 1, -1]


CONJUGATE = np.array([1, -1, -1, -1])
PLANTED: dict[str, tuple[Callable[[polhode.results.Motion], dict[str, Any]], dict[str, Any]]] = {
    "as polhode": (lambda m: {"attitude": m.attitude, "omega": m.omega}, {}),
    "without omega": (lambda m: {"attitude": m.attitude}, {"omega_axes": None}),
    "xyzw": (lambda m: {"attitude": m.attitude[:, [1, 2, 3, 0]], "omega": m.omega}, {"quaternion": "xyzw"}),
    "inverse": (lambda m: {"attitude": m.attitude * CONJUGATE, "omega": m.omega}, {"sense": "space_to_body"}),
    "omega along space": (lambda m: {"attitude": m.attitude, "omega": m.omega_space}, {"omega_axes": "space"}),
    "inverse xyzw, omega along space": (
        lambda m: {"attitude": (m.attitude * CONJUGATE)[:, [1, 2, 3, 0]], "omega": m.omega_space},
        {"quaternion": "xyzw", "sense": "space_to_body", "omega_axes": "space"},
    ),
    "y up is": (
        lambda m: {"attitude": np.hstack([m.attitude[:, :1], upwards(m.attitude[:, 1:])]), "omega": upwards(m.omega)},
        {"axes": "(x, z, −y)"},
    ),
    "y up is, declared": (
        lambda m: {"attitude": np.hstack([m.attitude[:, :1], upwards(m.attitude[:, 1:])]), "omega": upwards(m.omega), "axes": "x,z,-y"},
        {"axes": "(x, z, −y)"},
    ),
    "times from 100 s": (lambda m: {"attitude": m.attitude, "omega": m.omega, "times": m.times + 100.0}, {"time_origin": 100.0}),
    "matrices": (lambda m: {"attitude": np.array([matrix(q) for q in m.attitude]), "omega": m.omega}, {}),
    "matrices of the inverse": (
        lambda m: {"attitude": np.array([matrix(q).T for q in m.attitude]), "omega": m.omega},
        {"sense": "space_to_body"},
    ),
    "all declared": (
        lambda m: {
            "attitude": (m.attitude * CONJUGATE)[:, [1, 2, 3, 0]],
            "omega": m.omega_space,
            "quaternion": "xyzw",
            "sense": "space_to_body",
            "omega_axes": "space",
            "axes": "x,y,z",
            "time_origin": 0.0,
        },
        {"quaternion": "xyzw", "sense": "space_to_body", "omega_axes": "space"},
    ),
}


@pytest.mark.parametrize("name", PLANTED)
def test_what_the_numbers_mean_is_found(name: str, exact: polhode.results.Motion) -> None:
    given, differs = PLANTED[name]
    judgement = polhode.judge(PUSHED, **{"times": exact.times, **given(exact)})
    reading = judgement.reading
    meant = {"quaternion": "wxyz", "sense": "body_to_space", "axes": "(x, y, z)", "omega_axes": "body", "time_origin": 0.0, **differs}
    assert {key: getattr(reading, key) for key in meant} == pytest.approx(meant)
    assert reading.tried[0].residual < 1e-12 and not reading.from_own_start
    assert judgement.largest_attitude_error < 1e-12 and judgement.likeliest is None
    assert np.abs(judgement.times - exact.times).max() < 1e-12
    assert np.abs(np.abs((judgement.attitude * exact.attitude).sum(axis=1)) - 1).max() < 1e-13
    assert np.abs(np.abs((judgement.exact_attitude * exact.attitude).sum(axis=1)) - 1).max() < 1e-13
    assert np.abs(judgement.exact_omega - exact.omega).max() < 1e-12
    if judgement.omega is None:
        assert name == "without omega"
        rates = [judgement.omega_error, judgement.kinetic_energy_error, judgement.momentum_error, judgement.momentum_direction_error]
        assert rates == [None] * 4
    else:
        assert np.abs(judgement.omega - exact.omega).max() < 1e-12
        assert judgement.omega_error is not None and judgement.omega_error.max() < 1e-12


def test_a_scenario_is_judged_as_its_text(exact: polhode.results.Motion) -> None:
    attitude = exact.states.attitude
    by_text = polhode.judge(PUSHED, times=TIMES, attitude=attitude)
    by_object = polhode.judge(polhode.Scenario.from_toml(PUSHED), times=TIMES, attitude=attitude)
    assert by_object.reading == by_text.reading
    assert np.array_equal(by_object.attitude_error, by_text.attitude_error)
    with pytest.raises(TypeError, match="scenario must be a path"):
        polhode.judge(3, times=TIMES, attitude=attitude)  # type: ignore[arg-type]


def test_what_is_right_is_said_to_be(exact: polhode.results.Motion) -> None:
    judgement = polhode.judge(PUSHED, times=exact.times, attitude=exact.attitude, omega=exact.omega)
    assert judgement.is_exact and judgement.largest_attitude_error <= 3 * judgement.exact_to < 1e-11
    assert judgement.growth is None and judgement.causes == []
    assert repr(judgement).startswith("Judgement(301 rows, correct to ") and "\n" not in repr(judgement)
    assert "Correct: no error above" in judgement.report() == str(judgement)


def test_rotations_are_scalar_last_and_of_body_to_space(exact: polhode.results.Motion) -> None:
    judgement = polhode.judge(PUSHED, times=exact.times, attitude=exact.rotations(), omega=exact.omega)
    assert (judgement.reading.quaternion, judgement.reading.sense) == ("xyzw", "body_to_space")
    assert len(judgement.reading.tried) == 1 and judgement.largest_attitude_error < 1e-12
    inverse = polhode.judge(PUSHED, times=exact.times, attitude=exact.rotations().inv(), sense="space_to_body")
    assert inverse.reading.sense == "space_to_body" and inverse.largest_attitude_error < 1e-12
    with pytest.raises(polhode.PolhodeError, match="quaternion has no effect on a Rotation"):
        polhode.judge(PUSHED, times=exact.times, attitude=exact.rotations(), quaternion="wxyz")


def test_single_precision_is_noticed(exact: polhode.results.Motion) -> None:
    judgement = polhode.judge(PUSHED, times=exact.times, attitude=exact.attitude.astype(np.float32), omega=exact.omega.astype(np.float32))
    assert judgement.to_dict()["runs"][0]["single_precision"]
    assert 1e-9 < judgement.largest_attitude_error < 2e-7 and not judgement.is_exact


def test_errors_are_those_that_were_planted(exact: polhode.results.Motion) -> None:
    """Axes that are turned in the body, by more and more, and an ω that is too large."""
    theta = 1e-3 * np.array([0.4, -0.3, 0.9]) * (1 + TIMES[:, None])
    attitude, omega = product(exact.attitude, turn(theta)), 1.01 * exact.omega
    judgement = polhode.judge(PUSHED, times=TIMES, attitude=attitude, omega=omega)
    assert np.abs(judgement.attitude_error_vector - theta).max() < 1e-11
    assert np.abs(judgement.attitude_error - np.linalg.norm(theta, axis=1)).max() < 1e-11
    assert judgement.largest_attitude_error == judgement.attitude_error.max()
    assert judgement.last_attitude_error == judgement.attitude_error[-1]

    def relative(values: np.ndarray, right: np.ndarray) -> np.ndarray:
        return (values - right) / np.abs(right).max()

    speed, energy = np.linalg.norm(exact.omega, axis=1), exact.kinetic_energy
    momentum = np.linalg.norm(exact.momentum, axis=1)
    assert np.abs(judgement.omega_error - 0.01 * speed / speed.max()).max() < 1e-11
    assert np.abs(judgement.kinetic_energy_error - relative(1.01**2 * energy, energy)).max() < 1e-11
    assert np.abs(judgement.momentum_error - relative(1.01 * momentum, momentum)).max() < 1e-11
    in_space = np.array([matrix(q) @ INERTIA @ w for q, w in zip(attitude, omega)])
    sine = np.linalg.norm(np.cross(in_space, exact.momentum), axis=1) / (1.01 * momentum**2)
    assert np.abs(judgement.momentum_direction_error - np.arcsin(sine)).max() < 1e-9


def test_the_split_has_what_was_planted(exact: polhode.results.Motion) -> None:
    beta = np.array([0.004, -0.003, 0.009])
    judgement = polhode.judge(PUSHED, times=TIMES, attitude=product(exact.attitude, turn(np.tile(beta, (len(TIMES), 1)))))
    split = judgement.split
    parts = {part.name: part for part in split.parts}
    assert list(parts) == ["start", "body_axes", "clock", "rate", "drift"]
    assert parts["body_axes"].unit == "rad" and np.abs(np.array(parts["body_axes"].value) - beta).max() < 1e-10
    assert split.total == pytest.approx(np.linalg.norm(beta), rel=1e-10) and split.rest < 1e-10 and split.until == TIMES[-1]
    assert judgement.growth is not None and judgement.growth.kind == "power" and abs(judgement.growth.exponent) < 0.1


def test_a_term_that_is_left_out_is_named() -> None:
    omega = np.tile(OMEGA, (len(TIMES), 1))
    judgement = polhode.judge(BODY, times=TIMES, attitude=constant_omega(), omega=omega, engine="an engine", step=0.02)
    cause = judgement.likeliest
    assert cause is not None and cause.id == "no_gyroscopic_term" and cause.is_mistake and cause.named and cause.explained > 0.99
    assert cause == judgement.causes[0] and "ω × I ω" in cause.text and "ω × I ω" in cause.hint
    assert judgement.largest_attitude_error > 0.5 and (judgement.engine, judgement.step) == ("an engine", 0.02)
    assert repr(judgement).endswith("rad off, no_gyroscopic_term)")
    # Its ω is kept, and with it T: nothing of it is seen there.
    assert np.abs(judgement.kinetic_energy_error).max() < 1e-12


def replaced(array: np.ndarray, index: Any, value: Any) -> np.ndarray:
    array = array.copy()
    array[index] = value
    return array


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"attitude": None}, "give either run, or both times and attitude"),
        ({"times": None}, "give either run, or both times and attitude"),
        ({"attitude": np.ones((301, 3))}, r"attitude must have the shape \(n, 4\), or \(n, 3, 3\) for matrices, not \(301, 3\)"),
        ({"attitude": np.ones((301, 3, 4))}, r"attitude must have the shape \(n, 3, 3\), not \(301, 3, 4\)"),
        ({"attitude": np.ones((301, 3, 3))}, r"attitude\[0\]: \|RᵀR − 1\| = .* has to be a rotation"),
        ({"attitude": np.tile(np.diag([1.0, 1.0, -1.0]), (301, 1, 1))}, r"attitude\[0\]: det R = −1"),
        ({"times": TIMES[:, None]}, r"times must have the shape \(n,\)"),
        ({"times": replaced(TIMES, 17, np.nan)}, r"times\[17\] = nan must be finite"),
        ({"times": replaced(TIMES, 18, TIMES[16])}, r"row 18: the time 0.32 s is not later than 0.34 s"),
        ({"times": replaced(TIMES, 18, TIMES[17])}, r"row 18: the time 0.34 s is not later than 0.34 s"),
        ({"attitude": constant_omega()[:-2]}, "there are 299 attitudes but 301 times"),
        ({"omega": np.ones((299, 3))}, "there are 299 angular velocities but 301 times"),
        ({"omega": np.ones((301, 4))}, r"omega must have the shape \(n, 3\)"),
        ({"attitude": replaced(constant_omega(), (9, 2), np.inf)}, r"attitude\[9, 2\] = inf must be finite"),
        ({"attitude": replaced(constant_omega(), 9, 0.0)}, r"attitude\[9, 0\] = 0.0 must be part of a quaternion that is not zero"),
        ({"omega": replaced(np.ones((301, 3)), (5, 1), np.nan)}, r"omega\[5, 1\] = nan must be finite"),
        ({"times": TIMES[:1], "attitude": constant_omega()[:1]}, "a motion needs at least 2 rows"),
        ({"quaternion": "zyxw"}, "quaternion = 'zyxw' must be one of wxyz, xyzw"),
        ({"sense": "inverse"}, "sense = 'inverse' must be one of body_to_space, space_to_body"),
        ({"axes": "x,z,y"}, r'axes = "x,z,y" must be three right-handed axes'),
        ({"omega_axes": "space"}, "omega_axes has no effect without omega"),
        ({"columns": "time = t"}, "columns have no effect on arrays"),
        ({"step": 0.0}, "step = 0.0 must be positive"),
        ({"quaternion": "wxyz", "attitude": np.tile(np.eye(3), (301, 1, 1))}, "quaternion has no effect on matrices"),
        ({"time_origin": 1.0}, "a row at -1 s, before the scenario's start at 0 s\nhint: set time_origin, the run"),
        ({"run": "log.csv"}, "times and attitude have no effect on a log"),
    ],
)
def test_what_is_no_motion_is_refused(given: dict[str, Any], says: str) -> None:
    with pytest.raises(polhode.PolhodeError, match=says) as error:
        polhode.judge(BODY, **{"times": TIMES, "attitude": constant_omega(), **given})
    assert "--" not in str(error.value)


def test_what_cannot_be_read_is_asked() -> None:
    """Of a motion that is not one of the scenario's, and of two readings that both fit."""
    odd = np.random.default_rng(4).normal(size=(len(TIMES), 4))
    with pytest.raises(polhode.PolhodeError, match="no interpretation") as error:
        polhode.judge(BODY, times=TIMES, attitude=odd)
    assert 'quaternion="wxyz" or "xyzw", and sense="body_to_space" or "space_to_body"' in (error.value.hint or "")
    with pytest.raises(polhode.PolhodeError, match="no interpretation") as error:
        polhode.judge(BODY, times=TIMES, attitude=odd, quaternion="wxyz")
    assert 'sense="body_to_space"' in (error.value.hint or "") and "quaternion" not in (error.value.hint or "")
    judgement = polhode.judge(BODY, times=TIMES, attitude=odd, quaternion="wxyz", sense="body_to_space")
    assert judgement.largest_attitude_error > 1.0
    omega = np.random.default_rng(5).normal(size=(len(TIMES), 3))
    with pytest.raises(polhode.PolhodeError, match="no interpretation of the run's angular velocities") as error:
        polhode.judge(BODY, times=TIMES, attitude=constant_omega(), omega=omega)
    assert (error.value.hint or "").startswith('omega_axes="body" or omega_axes="space" compares it as written')


HEADER = "time_s,qx,qy,qz,qw,wx,wy,wz"


def write(path: Path, header: str, attitude: np.ndarray, omega: np.ndarray) -> Path:
    table = np.column_stack([TIMES, attitude[:, [1, 2, 3, 0]], omega])
    np.savetxt(path, table, fmt="%.17g", delimiter=",", header=header, comments="")
    return path


def test_a_log_is_judged_as_its_arrays(tmp_path: Path) -> None:
    attitude, omega = constant_omega(), np.tile(OMEGA, (len(TIMES), 1))
    arrays = polhode.judge(BODY, times=TIMES, attitude=attitude, omega=omega)
    scenario = tmp_path / "body.toml"
    scenario.write_text(BODY)
    for name, header, columns in (
        ("named.csv", "# engine = \"an engine\"\n# step = 0.01\n" + HEADER, None),
        ("other.csv", "when,a,b,c,d,e,f,g", "time = when, quaternion xyzw = a b c d, omega body = e f g"),
    ):
        path = write(tmp_path / name, header, attitude, omega)
        log = polhode.judge(scenario, path, columns=columns)
        for array in ("times", "attitude_error", "attitude_error_vector", "omega_error", "momentum_direction_error", "exact_attitude"):
            assert np.array_equal(getattr(log, array), getattr(arrays, array)), array
        assert log.likeliest is not None and log.likeliest.id == "no_gyroscopic_term"
        assert log.to_dict()["runs"][0]["path"] == str(path)
    named = polhode.judge(BODY, tmp_path / "named.csv")
    assert (named.engine, named.step) == ("an engine", 0.01)
    told = polhode.judge(BODY, str(tmp_path / "named.csv"), engine="another", step=0.005)
    assert (told.engine, told.step) == ("another", 0.005)


def test_errors_of_a_log_have_their_place(tmp_path: Path) -> None:
    path = write(tmp_path / "run.csv", HEADER, constant_omega(), np.tile(OMEGA, (len(TIMES), 1)))
    lines = path.read_text().splitlines()
    path.write_text("\n".join([*lines[:7], lines[7].replace(lines[7].split(",")[3], "nan"), *lines[8:]]))
    with pytest.raises(polhode.PolhodeError, match="nan") as error:
        polhode.judge(BODY, path)
    assert (error.value.path, error.value.line) == (str(path), 8)
    path.write_text("\n".join(lines))
    with pytest.raises(FileNotFoundError):
        polhode.judge(BODY, tmp_path / "nothing.csv")
    with pytest.raises(FileNotFoundError):
        polhode.judge(tmp_path / "nothing.toml", path)
    with pytest.raises(polhode.PolhodeError, match=r'columns: unknown word "wzyx" for quaternion'):
        polhode.judge(BODY, path, columns="quaternion wzyx = qw qz qy qx")
    with pytest.raises(polhode.PolhodeError, match="times and omega have no effect on a log"):
        polhode.judge(BODY, path, times=TIMES, omega=np.ones((301, 3)))
    odd = write(tmp_path / "odd.csv", HEADER, np.random.default_rng(4).normal(size=(301, 4)), np.ones((301, 3)))
    with pytest.raises(polhode.PolhodeError, match="no interpretation") as error:
        polhode.judge(BODY, odd)
    assert error.value.path == str(odd)


def test_a_judgement_is_that_of_the_command(tmp_path: Path) -> None:
    def command(*arguments: str, status: int = 0) -> str:
        done = subprocess.run([sys.executable, "-m", "polhode", *arguments], capture_output=True, text=True, timeout=200)
        assert done.returncode == status, done.stderr
        return done.stdout

    suite = tmp_path / "suite"
    command("judge", "--write-suite", str(suite))
    header, *rows = (suite / "exact" / "free-flips.csv").read_text().splitlines()
    # Each row has the state of the row before it.
    late = [",".join([row.split(",")[0], *before.split(",")[1:]]) for before, row in zip(rows, rows[1:])]
    run = suite / "free-flips.csv"
    run.write_text("\n".join(["# engine = \"one that is late\"", header, *late]))
    scenario = suite / "free-flips.toml"
    # With no word on the clock a row late is a clock that begins a row later.
    assert polhode.judge(scenario, run).is_exact
    judgement = polhode.judge(scenario, run, time_origin=0.0)
    files = [str(scenario), str(run), "--time-origin", "0"]
    assert judgement.to_dict() == json.loads(command("judge", *files, "--json", status=1))
    assert judgement.report() == command("judge", *files, status=1)
    assert judgement.page() == command("judge", *files, "--html", status=1)
    assert judgement._repr_markdown_() == command("judge", *files, "--markdown", status=1)
    assert judgement.likeliest is not None and judgement.likeliest.id == "time_shift"


def test_arrays_are_to_be_looked_at(exact: polhode.results.Motion) -> None:
    judgement = polhode.judge(PUSHED, times=TIMES, attitude=exact.attitude, omega=exact.omega)
    for it in (judgement, pickle.loads(pickle.dumps(judgement))):
        for name in (name for name, value in vars(polhode.results.Judgement).items() if isinstance(value, property)):
            array = getattr(it, name)
            if isinstance(array, np.ndarray):
                assert len(array) == len(it) == 301
                with pytest.raises(ValueError, match="read-only"):
                    array[0] = 0.0


def test_what_was_assumed_of_the_scenario_is_said(examples: Path) -> None:
    mesh = f'[[body.part]]\nshape = "mesh"\nfile = "{examples / "bracket.stl"}"\nmaterial = "aluminium"\n'
    sweep = '[sweep]\nmembers = 9\nseed = 7\nsampling = "monte carlo"\n[[sweep.vary]]\nkey = "start.spin.body[1]"\nuniform = { from = 1, to = 3 }\n'
    text = f"{mesh}[start]\nspin = {{ body = [0.1, 2, -0.3] }}\n[run]\nduration = 1\nsamples = 11\n{sweep}"
    with pytest.warns(polhode.PolhodeWarning):
        motion = polhode.simulate(text)
    with pytest.warns(polhode.PolhodeWarning) as heard:
        assert polhode.judge(text, times=motion.times, attitude=motion.attitude).is_exact
    assert [str(warning.message).split()[-1] for warning in heard] == ["[mesh.unit]", "[sweep.nominal]"]
    assert {warning.filename for warning in heard} == {__file__}


def test_a_free_body_needs_no_scenario(tmp_path: Path) -> None:
    moments = [1.1, 2.3, 1.7]
    exact = polhode.FreeMotion(moments=moments, omega=OMEGA, attitude=START).at(TIMES)
    judgement = polhode.judge(moments=moments, times=TIMES + 2.5, attitude=exact.attitude, omega=exact.omega)
    assert judgement.largest_attitude_error < 1e-14
    assert judgement.reading.time_origin == 2.5
    judgement = polhode.judge(moments=moments, start_omega=OMEGA, times=TIMES, attitude=constant_omega())
    assert judgement.likeliest is not None and judgement.likeliest.id == "no_gyroscopic_term"
    table = np.column_stack([TIMES, exact.attitude, exact.omega])
    np.savetxt(tmp_path / "run.csv", table, fmt="%.17g", delimiter=",", header="t,qw,qx,qy,qz,wx,wy,wz", comments="")
    assert polhode.judge(run=tmp_path / "run.csv", moments=moments).largest_attitude_error < 1e-14
    for wrong, says in [
        ({"times": TIMES, "attitude": exact.attitude}, "exactly one of scenario and moments"),
        ({"moments": moments, "times": TIMES, "attitude": exact.attitude}, "start_omega"),
        ({"moments": [1, 2, 9], "times": TIMES, "attitude": exact.attitude}, "is less than i3 = 9"),
        ({"moments": moments, "times": TIMES, "attitude": exact.attitude, "axes": "y,z,x"}, "axes has no effect with moments"),
        ({"moments": moments, "times": TIMES, "attitude": exact.attitude, "time_origin": 1.0}, "time_origin has no effect"),
        ({"scenario": BODY, "start_omega": OMEGA, "times": TIMES, "attitude": exact.attitude}, "without moments"),
    ]:
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.judge(**wrong)
