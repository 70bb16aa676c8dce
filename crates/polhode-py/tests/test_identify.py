"""Bodies from measurements: the answers of the command, of plans and of arrays; what is known of them, and what is refused."""

from __future__ import annotations

import dataclasses
import errno
import json
import pickle
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest
from scipy.spatial.transform import Rotation

NAMES = ("racket-like", "bifilar", "payload")
INERTIA = np.array([[0.031, 0.004, -0.003], [0.004, 0.042, 0.002], [-0.003, 0.002, 0.053]])


def command(*arguments: str | Path, status: int = 0) -> str:
    """What it prints; of a failure the error."""
    done = subprocess.run([sys.executable, "-m", "polhode", "identify", *map(str, arguments)], capture_output=True, text=True, timeout=200)
    assert done.returncode == status, done.stderr
    return done.stderr if status else done.stdout


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    from conftest import ROOT

    return {name: polhode.identify(ROOT / "examples" / "identify" / f"{name}.toml") for name in NAMES}


@pytest.mark.parametrize("name", NAMES)
def test_answers_are_those_of_the_command(name: str, found: dict[str, Any], examples: Path) -> None:
    plan, result = examples / "identify" / f"{name}.toml", found[name]
    said = json.loads(command(plan, "--json"))
    assert result.to_dict() == said
    assert result.report() == command(plan)
    if name == "payload":
        assert result.page() == command(plan, "--html")
        assert result._repr_markdown_() == command(plan, "--markdown")
    assert result.title == said["title"] and not result.has_model_error
    for estimate, of in [(result.estimate, said["estimate"])] + ([(result.about_origin, said["about_origin"])] if name == "payload" else []):
        assert [tuple(number) for number in estimate] == [(n["name"], n["unit"], n["value"], n["sd"], n.get("reason")) for n in of["numbers"]]
        assert np.array_equal(estimate.covariance, of["covariance"]) and np.array_equal(estimate.unknown, np.reshape(of["unknown"], (-1, len(estimate))))
        known = estimate.sd > 0.0
        assert np.allclose(np.diag(estimate.correlation)[known], 1.0) and np.isnan(np.diag(estimate.correlation)[~known]).all()
    # The triangle is a picture's outlines.
    assert result.principal.not_determined == said["principal"]["not_determined"]
    for key in said["principal"].keys() - {"triangle", "not_determined"}:
        value = said["principal"][key]
        assert np.array_equal(np.array(getattr(result.principal, key), float), np.array(value, float), equal_nan=True), key
    assert result.principal.axes.shape == (3, 3)
    tests = said["residuals"] if isinstance(said["residuals"], list) else [said["residuals"]]
    assert [test._asdict() for test in result.tests] == tests
    assert [finding.message for finding in result.findings] == [finding["message"] for finding in said["findings"]]


def test_residuals_are_arrays(found: dict[str, Any], examples: Path) -> None:
    tumble, swing, payload = (found[name] for name in NAMES)
    for flight, said in zip(tumble.flights, tumble.to_dict()["flights"], strict=True):
        assert np.array_equal(flight.gyro_residuals, said["gyro_residuals"]) and flight.attitude_residuals.shape == (0, 3)
        assert flight.used == len(flight.gyro_residuals) - len(flight.left_out) and flight.attitude is None
    assert all(fit.test.what.startswith("times and amplitudes") for fit in swing.swings)
    # χ² of all that was counted, but for the numbers that were measured besides.
    chi_square = sum((fit.residuals**2).sum() for fit in swing.swings)
    assert all(fit.residuals.shape == (3,) for fit in swing.swings)
    assert 0.0 < chi_square < swing.tests[0].reduced_chi_square * swing.tests[0].degrees_of_freedom
    # The wrench less what the numbers say of it.
    rows = np.loadtxt(examples / "identify" / "payload.csv", delimiter=",", skiprows=2)
    omega, alpha, acceleration, gravity, force, torque = (rows[:, k : k + 3] for k in (1, 4, 7, 10, 13, 16))
    values = dict(zip(payload.about_origin.names, payload.about_origin.values))
    h = np.array([values[f"moment {axis}"] for axis in "xyz"])
    six = [values[f"I{axes} about the origin"] for axes in ("xx", "yy", "zz", "xy", "xz", "yz")]
    inertia = np.array(six)[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]]
    bias = np.array([values[f"bias {name}"] for name in ("fx", "fy", "fz", "tx", "ty", "tz")])
    free = acceleration - gravity
    on_payload = values["mass"] * free + np.cross(alpha, h) + np.cross(omega, np.cross(omega, h))
    about = np.cross(h, free) + alpha @ inertia + np.cross(omega, omega @ inertia)
    assert np.abs(payload.force_residuals - (force + on_payload - bias[:3])).max() < 1e-4
    assert np.abs(payload.torque_residuals - (torque + about - bias[3:])).max() < 1e-5
    assert np.array_equal(payload.times, rows[:, 0]) and len(payload.left_out) == len(payload.to_dict()["left_out"])


def test_a_path_a_text_and_a_dictionary_are_one_plan(found: dict[str, Any], examples: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = examples / "identify"
    for name in NAMES:
        text = (folder / f"{name}.toml").read_text()
        monkeypatch.chdir(folder)
        from_path, from_text = polhode.identify(f"{name}.toml"), polhode.identify(text)
        from_dict = polhode.identify(tomllib.loads(text))
        assert type(from_path) is type(from_text) is type(from_dict) is type(found[name])
        # The same but for how the log's path is written in the text.
        assert from_text == from_dict and from_text.to_dict() == from_path.to_dict() == found[name].to_dict()
        assert from_text.estimate == found[name].estimate and from_text.tests == found[name].tests
    assert found["payload"] != found["bifilar"] and found["payload"] != 1


def test_flights_as_arrays(found: dict[str, Any], examples: Path) -> None:
    rows = np.loadtxt(examples / "identify" / "racket-like.csv", delimiter=",", skiprows=2)
    flights = polhode.find_flights(times=rows[:, 0], gyro=rows[:, 1:])
    assert [flight.name for flight in flights] == [fit.name for fit in found["racket-like"].flights]
    result = polhode.identify_tumbles(flights=flights, title="A racket, thrown four times")
    assert result.to_dict() == found["racket-like"].to_dict()
    assert "Arrays in Python" in result.report()
    assert np.allclose(result.inertia, result.inertia.T) and np.allclose(np.linalg.eigvalsh(result.inertia), result.principal.moments)
    one = polhode.identify_tumbles(flights=flights[0])
    assert len(one.flights) == 1 and one != result


def test_swings_as_dictionaries(found: dict[str, Any], examples: Path) -> None:
    plan = tomllib.loads((examples / "identify" / "bifilar.toml").read_text())
    swing = plan["swing"]
    result = polhode.identify_swings(
        mass=swing["mass"], center=swing["center"], numbers=swing["numbers"], tests=swing["test"], title=plan["title"]
    )
    assert result == found["bifilar"]
    body = result.body
    assert body is not None and np.array_equal(body.inertia[0, :2], [result.estimate["Ixx"].value, result.estimate["Ixy"].value])
    assert body.mass == result.estimate["mass"].value
    assert abs(body.inertia - [[0.0312, -0.0035, 0.0021], [-0.0035, 0.0458, 0.0027], [0.0021, 0.0027, 0.0561]]).max() < 4e-4
    # gravity where it is other, and numbers of NumPy
    elsewhere = polhode.identify_swings(
        mass=np.float64(3.2), center=np.array([0.004, -0.0026, 0.0033]), numbers=swing["numbers"], tests=swing["test"], gravity=9.78
    )
    assert elsewhere.estimate["gravity"].value == 9.78 and elsewhere.estimate["mass"].sd == 0.0


def test_logs_of_swings_as_arrays(examples: Path) -> None:
    plan = tomllib.loads((examples / "identify" / "rod-logs.toml").read_text())
    angle = np.loadtxt(examples / "identify" / "rod-angle.csv", delimiter=",", skiprows=1)
    rate = np.loadtxt(examples / "identify" / "rod-rate.csv", delimiter=",", skiprows=1)
    rate = rate[rate[:, 0] >= 1000.0]
    with pytest.warns(polhode.PolhodeWarning, match="identify.unknown"):
        by_file = polhode.identify(examples / "identify" / "rod-logs.toml")
    tests = plan["swing"]["test"]
    tests[0]["logged"] = {"times": angle[:, 0], "values": np.radians(angle[:, 1]), "signal": "angle", "sd": np.radians(0.1)}
    tests[1]["logged"] = {"times": rate[:, 0] / 1000.0, "values": rate[:, 1], "signal": "rate", "sd": 0.004}
    with pytest.warns(polhode.PolhodeWarning, match="identify.unknown"):
        by_array = polhode.identify_swings(mass=plan["swing"]["mass"], center=plan["swing"]["center"], tests=tests)
    assert by_array.estimate["Izz"].value == pytest.approx(by_file.estimate["Izz"].value, rel=1e-9)
    assert by_array.estimate["Izz"].sd == pytest.approx(by_file.estimate["Izz"].sd, rel=1e-6)
    del tests[0]["logged"]["values"]
    with pytest.raises(polhode.PolhodeError, match="the key values is missing"):
        polhode.identify_swings(mass=plan["swing"]["mass"], center=plan["swing"]["center"], tests=tests)


def test_wrenches_as_arrays(found: dict[str, Any], examples: Path) -> None:
    rows = np.loadtxt(examples / "identify" / "payload.csv", delimiter=",", skiprows=2)
    names = ("omega", "alpha", "acceleration", "gravity", "force", "torque")
    arrays = {name: rows[:, k : k + 3] for name, k in zip(names, range(1, 19, 3))}
    options: dict[str, Any] = {"wrench": "on_sensor", "bias": True, "title": "A tool at the wrist"}
    result = polhode.identify_payload(times=rows[:, 0], **arrays, **options, force_noise=0.05, torque_noise=2e-3)
    assert result.to_dict() == found["payload"].to_dict()
    assert np.array_equal(result.force_residuals, found["payload"].force_residuals)
    covariance = np.diag([0.05**2] * 3 + [2e-3**2] * 3)
    again = polhode.identify_payload(times=rows[:, 0], **arrays, **options, wrench_covariance=covariance)
    assert np.allclose(again.estimate.values, result.estimate.values, rtol=1e-9)
    other = {**arrays, "force": -arrays["force"], "torque": -arrays["torque"]}
    turned = polhode.identify_payload(times=rows[:, 0], **other, **{**options, "wrench": "on_payload"}, force_noise=0.05, torque_noise=2e-3)
    assert np.allclose(turned.estimate.values[:10], result.estimate.values[:10], rtol=1e-9)
    # gravity along axes of space, and attitudes
    attitude = [Rotation.align_vectors([[0, 0, -1]], [g])[0] for g in arrays["gravity"]]
    size = np.linalg.norm(arrays["gravity"], axis=1).mean()
    arrays["gravity"] = np.array([0, 0, -size])
    in_space = polhode.identify_payload(
        times=rows[:, 0], **arrays, **options, attitude=Rotation.concatenate(attitude), force_noise=0.05, torque_noise=2e-3
    )
    assert np.allclose(in_space.estimate.values, result.estimate.values, rtol=1e-3, atol=1e-6)
    assert result.body is not None and abs(result.body.mass - 1.85) < 1e-3


def thrown(omega: list[float], noise: float, seed: int, turn: Rotation | None = None, **more: Any) -> polhode.Flight:
    """A flight of the generic body, as a gyro with a bias and a camera see it."""
    times = np.arange(120) * 0.01
    motion = polhode.FreeMotion(inertia=INERTIA + more.pop("heavier", 0.0), omega=omega)
    rng = np.random.default_rng(seed)
    states = motion.at(times)
    attitude = motion.rotations(times)
    if turn is not None:
        more["attitude"] = attitude * Rotation.from_rotvec(1e-3 * rng.normal(size=(120, 3))) * turn
    return polhode.Flight(times=times, gyro=states.omega + [0.02, -0.03, 0.01] + noise * rng.normal(size=(120, 3)), **more)


THROWS = [[9.0, 1.0, 2.0], [1.5, 8.0, -5.0], [-2.0, 3.0, 9.0]]


def test_the_truth_is_within_its_errors() -> None:
    result = polhode.identify_tumbles(flights=[thrown(omega, 0.02, k) for k, omega in enumerate(THROWS)])
    moments = np.linalg.eigvalsh(INERTIA)
    elements = (INERTIA / moments[2])[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    truth = np.array([*elements, 0.02, -0.03, 0.01])
    assert (np.abs(result.estimate.values - truth) < 4.0 * result.estimate.sd).all()
    assert (result.estimate.sd[:6] < 0.01).all() and not result.scale_is_known
    # All grow alike: the direction that free motion does not show.
    (unknown,) = result.estimate.unknown
    assert np.allclose(unknown / np.linalg.norm(elements), np.array([*elements, 0, 0, 0]) / (elements @ elements), atol=1e-3) or np.allclose(
        -unknown / np.linalg.norm(elements), np.array([*elements, 0, 0, 0]) / (elements @ elements), atol=1e-3
    )
    assert np.isnan(result.principal.moment_sd).all() and result.estimate["Ixx/I3"].sd is not None


def test_something_known_says_how_large_the_body_is() -> None:
    added = np.diag([1e-3, 2e-3, 2.5e-3])
    flights = [thrown(omega, 0.02, k) for k, omega in enumerate(THROWS)]
    heavier = [thrown(omega, 0.02, 9 + k, heavier=added, added=added) for k, omega in enumerate(THROWS)]
    result = polhode.identify_tumbles(flights=[*flights, *heavier], gyro_noise=0.02)
    assert result.scale_is_known and result.estimate["Ixx"].unit == "kg·m²"
    assert (np.abs(result.inertia - INERTIA) < 4.0 * result.estimate.sd[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]]).all()


TORQUE = '[[torque]]\nmodel = "constant"\naxes = "body"\ntorque = [0.05, -0.02, 0.03]\n'
WHEEL = "[[wheel]]\naxis = [1, -2, 2]\nmomentum = 0.1\n"


@pytest.mark.parametrize(("known", "said"), [(TORQUE, {"torques": TORQUE}), (WHEEL, {"wheels": [([1, -2, 2], 0.1)]})])
def test_what_turns_the_body_says_how_large_it_is(known: str, said: dict[str, Any]) -> None:
    body = f'[[body.part]]\nshape = "tensor"\nmass = 1\ninertia = {INERTIA.tolist()}\n'
    times, rng, flights = np.arange(120) * 0.01, np.random.default_rng(0), []
    for omega in THROWS:
        motion = polhode.simulate(f"{body}[start]\nspin = {{ body = {omega} }}\n{known}", times=times)
        flights.append(polhode.Flight(times=times, gyro=motion.omega + 0.01 * rng.normal(size=(120, 3)), **said))
    result = polhode.identify_tumbles(flights=flights, gyro_noise=0.01, bias=False)
    assert result.scale_is_known and result.estimate.unknown.shape == (0, 6)
    assert (np.abs(result.inertia - INERTIA) < 4.0 * result.estimate.sd[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]]).all()
    assert (np.abs(result.estimate.sd) < 0.05 * np.trace(INERTIA)).all()


def test_attitudes_alone() -> None:
    times, rng, flights = np.arange(120) * 0.01, np.random.default_rng(4), []
    for omega in THROWS:
        attitude = polhode.FreeMotion(inertia=INERTIA, omega=omega).rotations(times)
        flights.append(polhode.Flight(attitude_times=times, attitude=attitude * Rotation.from_rotvec(1e-3 * rng.normal(size=(120, 3)))))
    assert repr(flights[0]) == "Flight('flight': 120 attitudes)"
    result = polhode.identify_tumbles(flights=flights, attitude_noise=1e-3)
    moments = np.linalg.eigvalsh(INERTIA)
    assert (np.abs(result.principal.ratios - moments[:2] / moments[2]) < 4 * result.principal.ratio_sd).all()
    assert result.flights[0].gyro_residuals.shape == (0, 3) and [test.what for test in result.tests] == ["attitude"]


def test_attitudes_beside_a_gyro() -> None:
    turn = Rotation.from_rotvec([0.3, -0.2, 0.5])
    flights = [thrown(omega, 0.02, k, turn) for k, omega in enumerate(THROWS)]
    assert repr(flights[0]) == "Flight('flight': 120 readings of a gyro, 120 attitudes)"
    result = polhode.identify_tumbles(flights=flights, attitude_noise=1e-3)
    assert np.abs(result.principal.ratios - np.linalg.eigvalsh(INERTIA)[:2] / np.linalg.eigvalsh(INERTIA)[2]).max() < 4 * result.principal.ratio_sd.max()
    assert [test.what for test in result.tests] == ["angular velocity", "attitude"]
    for fit in result.flights:
        assert fit.attitude is not None and fit.attitude_residuals.shape == (120, 3) and np.abs(fit.attitude_residuals).max() < 6e-3
    with pytest.raises(polhode.PolhodeError, match="the noise of the attitudes is missing"):
        polhode.identify_tumbles(flights=flights)


def test_what_is_not_known_is_said(examples: Path) -> None:
    swing = tomllib.loads((examples / "identify" / "bifilar.toml").read_text())["swing"]
    with pytest.warns(polhode.PolhodeWarning) as heard:
        one = polhode.identify_swings(mass=3.2, center=[0, 0, -0.003], numbers=swing["numbers"], tests=swing["test"][:1])
    assert {warning.filename for warning in heard} == {__file__}
    assert [str(warning.message).split()[-1] for warning in heard] == ["[identify.unknown]", "[identify.untested]"]
    assert [finding.code for finding in one.findings] == ["identify.unknown", "identify.untested"]
    assert one.body is None and one.principal is None and one.estimate["Iyz"].sd is None and one.tests == ()
    assert np.isnan(one.estimate.sd[5]) and one.estimate.unknown.shape == (5, len(one.estimate))
    assert np.allclose(np.linalg.norm(one.estimate.unknown, axis=1), 1.0)
    (fit,) = one.swings
    assert fit.moment is not None and fit.moment.sd == one.estimate["Ixx"].sd
    assert repr(one.estimate) == "Estimate(13 numbers, 5 directions unknown)"
    assert str(one.estimate).splitlines()[5] == "Iyy: not determined (it changes along an unobservable direction)"


def test_a_wrong_model_shows() -> None:
    flights = [thrown(omega, 0.02, k) for k, omega in enumerate(THROWS)]
    wobbly = [
        polhode.Flight(times=flight.times, gyro=flight.gyro + 0.3 * np.sin(25.0 * flight.times)[:, None] * [1.0, -0.5, 0.3])  # type: ignore[operator,arg-type]
        for flight in flights
    ]
    with pytest.warns(polhode.PolhodeWarning, match=r"errors are multiplied by .* \[identify.model\]"):
        result = polhode.identify_tumbles(flights=wobbly, gyro_noise=0.02)
    assert result.has_model_error and result.widening > 2.0 and "the residuals are not noise" in repr(result)


def test_answers_are_values(found: dict[str, Any]) -> None:
    for result in found.values():
        again = pickle.loads(pickle.dumps(result))
        assert again == result and again.estimate == result.estimate and again.report() == result.report() == str(result)
        assert dataclasses.is_dataclass(result)
        for it in (result, again):
            with pytest.raises(dataclasses.FrozenInstanceError):
                it.title = "another"
            with pytest.raises(ValueError, match="read-only"):
                it.estimate.values[0] = 0.0
        changed = dataclasses.replace(result.estimate, values=result.estimate.values + 1e-9)
        assert changed != result.estimate
        assert 'sandbox="allow-scripts"' in result._repr_html_()
        assert all(name in result.estimate._repr_html_() for name in result.estimate.names)
        assert len(repr(result)) < 120
    with pytest.raises(KeyError, match="'Iww' is not one of mass, center x"):
        found["payload"].estimate["Iww"]


def test_errors_are_those_of_the_command(tmp_path: Path, examples: Path) -> None:
    racket = (examples / "identify" / "racket-like.csv").read_text().splitlines()
    flight = thrown(THROWS[0], 0.02, 1)
    table = np.column_stack([flight.times, flight.gyro])  # type: ignore[arg-type]
    np.savetxt(tmp_path / "radians.csv", table, delimiter=",", header="time_s,gyro_x_deg_s,gyro_y_deg_s,gyro_z_deg_s", comments="")
    (tmp_path / "nan.csv").write_text("\n".join([*racket[:40], "0.5,nan,1,2", *racket[40:]]))
    (tmp_path / "short.csv").write_text("\n".join(racket[:4]))
    plans = {
        "radians": '[tumble]\nlog = "radians.csv"\n',
        "nan": '[tumble]\nlog = "nan.csv"\n',
        "short": '[tumble]\nlog = "short.csv"\n',
        "key": '[tumble]\nlogs = "short.csv"\n',
        "none": 'title = "nothing"\n',
        "unit": '[swing]\nmass = "3 m"\n',
    }
    for name, text in plans.items():
        path = tmp_path / f"{name}.toml"
        path.write_text(text)
        with pytest.raises(polhode.PolhodeError) as error:
            polhode.identify(path)
        said = command(path, status=2)
        assert said.splitlines()[0].removeprefix("error: ") in str(error.value), name
        if error.value.hint is not None:
            assert error.value.hint in said, name
    (tmp_path / "gone.toml").write_text('[tumble]\nlog = "gone.csv"\n')
    for path, named in ((tmp_path / "gone.toml", "gone.csv"), (tmp_path / "there is none.toml", str(tmp_path / "there is none.toml"))):
        with pytest.raises(FileNotFoundError) as missing:
            polhode.identify(path)
        assert missing.value.errno == errno.ENOENT and missing.value.filename.endswith(named)
        said = command(path, status=2).splitlines()[0].removeprefix("error: ")
        assert missing.value.strerror in said and missing.value.filename in said


def test_a_dictionary_has_no_lines(tmp_path: Path) -> None:
    with pytest.raises(polhode.PolhodeError, match="mass") as error:
        polhode.identify({"swing": {"mass": "3 m", "center": [0, 0, 0], "test": []}})
    assert error.value.path is None and error.value.line is None and "plan.toml" not in str(error.value)
    log = tmp_path / "odd \"name\"\u007f.csv"
    log.write_text("time_s,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s\n0,1,2,3\n0.1,1,2,oops\n")
    with pytest.raises(polhode.PolhodeError) as error:
        polhode.identify({"tumble": {"log": log}})
    assert error.value.path == str(log) and error.value.line == 3
    for plan, message in [
        ({"tumble": {"log": None}}, r"plan\['tumble'\]\['log'\] must be text"),
        ({"tumble": {3: "a"}}, r"plan\['tumble'\] has the key 3"),
        ({"tumble": {"log": [b"a"]}}, r"plan\['tumble'\]\['log'\]\[0\] must be text"),
    ]:
        with pytest.raises(TypeError, match=message):
            polhode.identify(plan)
    with pytest.raises(TypeError, match="plan must be a path"):
        polhode.identify(3)


def test_arrays_that_do_not_fit_are_refused() -> None:
    times, three = np.arange(20) * 0.1, np.ones((20, 3))
    for given, message in [
        ({"times": times[:3], "gyro": three}, "times and gyro must be of the same length, not 3 and 20"),
        ({"times": times, "gyro": np.ones((20, 2))}, r"gyro must have the shape \(n, 3\)"),
        ({"times": times, "gyro": three * np.nan}, "finite"),
        ({"times": times, "gyro": three, "attitude_times": times}, "attitude_times have no effect"),
        ({"times": times, "gyro": three, "attitude": np.ones((4, 4))}, "times and attitude must be of the same length"),
        ({"times": times, "gyro": three, "added": np.eye(2)}, "added must have the shape"),
    ]:
        with pytest.raises(polhode.PolhodeError, match=message):
            polhode.Flight(**given)
    flight = polhode.Flight(times=times, gyro=three)
    with pytest.raises(polhode.PolhodeError, match=r"times\[1\] = 0.0 must be greater than the one before"):
        polhode.Flight(times=times * 0.0, gyro=three)
    with pytest.raises(TypeError, match=r"flights\[1\] must be a Flight"):
        polhode.identify_tumbles(flights=[flight, 3])  # type: ignore[list-item]
    with pytest.raises(TypeError, match="flights must be"):
        polhode.identify_tumbles(flights="a")  # type: ignore[arg-type]
    with pytest.raises(polhode.PolhodeError, match="measured values in flights: 0; at least"):
        polhode.identify_tumbles(flights=[])
    with pytest.raises(polhode.PolhodeError, match="drag = 'cubic' must be one of linear, quadratic"):
        polhode.identify_tumbles(flights=flight, drag="cubic")
    with pytest.raises(polhode.PolhodeError, match=r"only \[\[torque\]\] tables"):
        polhode.identify_tumbles(flights=polhode.Flight(times=times, gyro=three, torques='title = "no"'))
    wrist: dict[str, Any] = {"times": times, "gravity": three, "wrench": "on_sensor"}
    wrist |= {name: three for name in ("omega", "alpha", "acceleration", "force", "torque")}
    for given, message in [
        ({"alpha": three[:4]}, "times and alpha must be of the same length"),
        ({"gravity": [0, 0, -9.81]}, "no attitudes are given"),
        ({"wrench": "on_table"}, "one of on_sensor, on_payload"),
        ({"force_noise": 0.1}, "give both force_noise and torque_noise, or neither"),
        ({"force_noise": 0.1, "torque_noise": 0.1, "wrench_covariance": np.eye(6)}, "contains all the noise"),
        ({"wrench_covariance": -np.eye(6)}, "positive definite"),
        ({"omega_noise": -1.0}, "the noise of an angular velocity is -1"),
        ({"kind": "ball"}, "one of plate, rod"),
        ({"times": times[:3], **{name: three[:3] for name in wrist if name not in ("times", "wrench")}}, "too few rows: 3; at least"),
    ]:
        with pytest.raises(polhode.PolhodeError, match=message):
            polhode.identify_payload(**{**wrist, **given})
