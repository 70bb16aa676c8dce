"""Scenarios as objects: the reader's keys, texts and back, errors at their arguments, torques of one's own."""

from __future__ import annotations

import inspect
import json
import pickle
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import MISSING, fields
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import polhode
import pytest
from polhode import _native, scenario
from polhode._scenario import _ONE, _SEVERAL
from polhode._section import Section, key_of
from polhode.batch import Plan, Vary
from polhode.scenario import (
    ConstantTorque,
    Contact,
    Drag,
    Event,
    FormulaTorque,
    FunctionTorque,
    Gravity,
    Orbit,
    Part,
    Pulses,
    Run,
    Start,
    Surface,
    Wheel,
    torque,
    where,
)

BALL = '[[body.part]]\nname = "ball"\nshape = "sphere"\nradius = 0.02\nmass = 0.5\n'

#: Where files have the table of a class, with dots between the keys.
PLACES: dict[type[Section], str] = {
    Start: "start",
    Run: "run",
    Pulses: "torque.pulses",
    Orbit: "orbit",
    Wheel: "wheel",
    Event: "event",
    scenario.Pointing: "pointing",
    Contact: "contact",
    Surface: "contact.surface",
    scenario.Ground: "contact.ground",
    scenario.Gimbals: "gimbals",
    scenario.GimbalAxis: "gimbals.outer",
    scenario.GimbalBase: "gimbals.base",
    scenario.MassHistory: "mass_history",
    scenario.Burn: "mass_history.burn",
    scenario.Drop: "mass_history.drop",
    scenario.Exit: "mass_history.exit",
    scenario.Prescribed: "prescribed",
    scenario.Shaft: "shaft",
    scenario.Balance: "shaft.balance",
    scenario.Pendulum: "pendulum",
    Vary: "sweep.vary",
    **{kind: f"torque {kind.model}" for kind in scenario.Torque.__subclasses__() if kind is not FunctionTorque},
}


@pytest.fixture(scope="module")
def schema() -> dict[str, Any]:
    """What ``polhode schema scenario`` prints."""
    printed = subprocess.run([sys.executable, "-m", "polhode", "schema", "scenario"], check=True, capture_output=True, timeout=100)
    return dict(json.loads(printed.stdout))


def tables(schema: dict[str, Any], value: dict[str, Any], place: str = "") -> Iterator[tuple[str, set[str], set[str]]]:
    """The tables of a schema: place, keys, and keys that are required; of a torque the place has its model."""
    if "$ref" in value:
        value = schema["$defs"][value["$ref"].rsplit("/", 1)[1]]
    if keys := value.get("properties"):
        model = f"{place} {keys['model']['enum'][0]}" if place == "torque" else place
        yield model, set(keys), set(value.get("required", ()))
        for key, inner in keys.items():
            yield from tables(schema, inner, f"{place}.{key}".lstrip("."))
    for inner in (*value.get("anyOf", ()), *value.get("oneOf", ()), *([value["items"]] if "items" in value else ())):
        yield from tables(schema, inner, place)


def test_the_classes_have_the_keys_of_the_reader(schema: dict[str, Any]) -> None:
    keys: dict[str, set[str]] = {}
    required: dict[str, set[str]] = {}
    for place, known, needed in tables(schema, schema):
        keys[place] = keys.get(place, set()) | known
        required[place] = required.get(place, needed) & needed
    public = {getattr(scenario, name) for name in scenario.__all__}
    kinds = {kind for kind in public if isinstance(kind, type) and issubclass(kind, Section)}
    assert kinds - {scenario.Torque, FunctionTorque, Part} == set(PLACES) - {Vary}
    for kind, place in PLACES.items():
        known = keys[place] - {"model"}
        if kind is Start:
            spin = {key: name for name, key in Start._SPIN.items()}
            known = known - {"spin"} | {spin[key] for key in keys["start.spin"]}
        assert known == {key_of(field) for field in fields(kind)}, kind
        # A function of an event has a value unless one is given.
        needed = required[place] - ({"model", "value"} if kind is Event else {"model"})
        assert needed == {key_of(field) for field in fields(kind) if field.default is MISSING}, kind
    assert keys["gimbals.rotor"] < keys["gimbals.outer"] == keys["gimbals.inner"]
    assert keys[""] == {"title", "symbols", "body", "sweep", *(key for key, _ in (*_ONE.values(), *_SEVERAL.values()))}
    assert keys["body"] == {"part", "pivot"}
    plan = set(inspect.signature(Plan).parameters) - {"source"}
    assert keys["sweep"] == plan


def test_formulas_of_symbols_stand_in_place_of_quantities(tmp_path: Path) -> None:
    box = Part(shape="box", size=["b", "2*b", "b/2"], mass="M/4", position=["-b", 0, "b/3"])
    named = polhode.Scenario([box], symbols={"M": "3 kg", "b": "20 cm"}, pivot=[0, "b", 0])
    named.to_toml(tmp_path / "box.toml")
    read = polhode.Scenario.from_toml(tmp_path / "box.toml").replace(folder=".")
    assert read == named and read.symbols == {"M": "3 kg", "b": "20 cm"}
    body = polhode.inertia(tmp_path / "box.toml")
    assert body.mass == 0.75
    np.testing.assert_allclose(body.center_of_mass, [-0.2, 0, 0.2 / 3], rtol=1e-15)
    with pytest.raises(polhode.PolhodeError, match="a length belongs"):
        named.replace(symbols={"M": "3 kg", "b": "2 s"})


def test_files_fit_the_schema(schema: dict[str, Any], examples: Path) -> None:
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    files = [*examples.glob("*.toml"), *examples.glob("notes/*.toml"), *examples.glob("sweeps/*.toml")]
    assert len(files) > 50
    for path in files:
        written = json.loads(_native.scenario_tables(path, None))
        assert not (found := list(validator.iter_errors(written))), (path, found)
        written["body"]["part"][0]["zzz"] = 1
        assert not validator.is_valid(written), path


@pytest.mark.parametrize("name", sorted(path.name for path in (Path(__file__).resolve().parents[3] / "examples").glob("*.toml")))
def test_files_come_back(name: str, examples: Path, tmp_path: Path) -> None:
    """The scenario of a file, its text, and the scenario of that: all the same, and the same motion."""
    one = polhode.Scenario.from_toml(examples / name)
    again = polhode.Scenario.from_toml(one.to_toml(), folder=examples)
    assert again == one
    assert pickle.loads(pickle.dumps(one)) == one
    assert one.title is None or one.title in repr(one)


def test_a_file_and_its_object_move_alike(examples: Path) -> None:
    for name in ("gyrostat.toml", "heavy-top.toml", "events.toml", "coin.toml", "spinning-stage.toml"):
        times = [0.0, 0.1, 0.7]
        one, other = (polhode.simulate(given, times=times) for given in (examples / name, polhode.Scenario.from_toml(examples / name)))
        assert (one.omega == other.omega).all() and (one.attitude == other.attitude).all(), name


def test_a_scenario_is_made_of_objects(generic: polhode.MassProperties) -> None:
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_euler("ZXZ", [0.4, 0.7, -0.2])
    made = polhode.Scenario(
        generic,
        pivot=["10 cm", "-0.2 m", "3 cm"],
        start=Start(attitude=turned, omega_space=np.array([0.3, -1.2, 2.0])),
        torques=[Gravity(), Drag(law="quadratic", coefficient=np.diag([0.01, 0.02, 0.03]), until=2.5), ConstantTorque(axes="space", torque=[0, "2 N cm", 0], pulses=Pulses(width=0.1, period=0.5))],
        wheels=[Wheel(axis=[0, 1, 1], momentum="0.2 N m s", name="w")],
        events=[Event(measure="omega", value=1.0, then="stop")],
        run=Run(duration=3, samples=31),
        title="generic",
    )
    text = f"""
title = "generic"
[body]
pivot = [0.1, -0.2, 0.03]
[[body.part]]
shape = "tensor"
mass = 2.3
center_of_mass = [0.11, -0.07, 0.23]
inertia = {generic.inertia.tolist()}
[start]
attitude = {{ quaternion_xyzw = {turned.as_quat().tolist()} }}
spin = {{ space = [0.3, -1.2, 2] }}
[[torque]]
model = "gravity"
[[torque]]
model = "drag"
law = "quadratic"
coefficient = [0.01, 0.02, 0.03]
until = 2.5
[[torque]]
model = "constant"
axes = "space"
torque = [0, 0.02, 0]
pulses = {{ width = 0.1, period = 0.5 }}
[[wheel]]
name = "w"
axis = [0, 1, 1]
momentum = 0.2
[[event]]
measure = "omega"
value = 1
then = "stop"
[run]
duration = 3
samples = 31
"""
    one, other = polhode.simulate(made), polhode.simulate(text)
    assert np.allclose(one.omega, other.omega, rtol=0, atol=1e-14) and np.allclose(one.attitude, other.attitude, rtol=0, atol=1e-14)
    assert one.ending == other.ending
    shorter = made.replace(run=Run(duration=1, samples=11), events=[])
    assert len(polhode.simulate(shorter)) == 11 and shorter != made and shorter.wheels == made.wheels
    assert repr(made) == "Scenario(generic; 3 torques; 1 wheel; 1 event; 3 s)"
    named = polhode.Body({"a": generic, "b": generic.placed(position=[1, 2, 3])})
    assert [part.to_dict()["name"] for part in polhode.Scenario(named).body] == ["a", "b"]


def test_what_is_refused_is_named_as_an_argument(generic: polhode.MassProperties) -> None:
    def refused(**given: object) -> str:
        with pytest.raises((polhode.PolhodeError, TypeError)) as caught:
            polhode.Scenario(generic, **given)  # type: ignore[arg-type]
        return str(caught.value)

    assert refused(torques=[ConstantTorque(axes="body", torque=[0, 0, 1]), Drag(law="linear", coefficient=-1.0)]).startswith("torques[1].coefficient: ")
    assert refused(run=Run(duration="3 m")).startswith('run.duration: "m" is a length where a time belongs')
    assert refused(start=Start(omega=[0, 1], velocity=[1, 2, 3])).startswith("start.spin: ")
    assert refused(events=[Event(measure="omega", value=1)]).startswith("events[0]: ")
    assert _message(lambda: torque(lambda t: [t, 0, 1e400])).startswith("a number of a function = inf")
    assert refused(torques="drag").startswith("torques must be a list of Torque, not str")
    assert refused(torques=[Run(duration=1)]).startswith("torques[0] must be a polhode.scenario.Torque, not Run")
    assert refused(orbit=Orbit(mu=1.0)).startswith("orbit: ")
    assert refused(orbit=Orbit(altitude=5e5, radius=7e6)).startswith("orbit.")
    assert refused(torques=[scenario.Magnetic(moment=[0, 0, 1])]).startswith("torques[0]: ")
    assert "must be finite" in _message(lambda: Start(omega=[0, np.nan, 0]))
    assert "[sweep]" in _message(lambda: polhode.Scenario.from_toml(BALL + '[sweep]\nmembers = 2\nsampling = "monte carlo"\nvary = [{ key = "body.part[0].mass", uniform = { from = 1, to = 2 } }]\n'))
    with pytest.raises(FileNotFoundError):
        polhode.Scenario.from_toml("no-such-file.toml")


def _message(make: object) -> str:
    with pytest.raises(polhode.PolhodeError) as caught:
        make()  # type: ignore[operator]
    return str(caught.value)


def test_a_function_becomes_formulas(generic: polhode.MassProperties) -> None:
    """A law of all that there is, traced, against the same law of numbers through another integrator."""

    def law(t, omega, omega_space, momentum, momentum_space, attitude, kinetic_energy, k=0.3):  # type: ignore[no-untyped-def]
        up = attitude.apply([0.0, 0.0, 1.0], inverse=True)
        damped = -k * omega * np.linalg.norm(omega) + 0.02 * np.cross(up, [0.3, -0.1, 0.2])
        w, x, y, z = attitude.as_quat(scalar_first=True)
        turning = attitude.as_matrix()[0] * (w * w + x * x - 1) - 0.01 * momentum / (1 + kinetic_energy)
        return damped + turning * np.exp(-t / 3) + 0.1 * np.sin(2 * t) * np.array([1.0, y, z**2]) + 1e-3 * (omega_space + momentum_space)

    def numbers(t, omega, omega_space, momentum, momentum_space, attitude):  # type: ignore[no-untyped-def]
        return law(t, omega, omega_space, momentum, momentum_space, attitude, 0.5 * omega @ generic.inertia @ omega)

    def motion(acting: scenario.Torque) -> polhode.results.Motion:
        start = Start(attitude={"euler313": [0.3, 0.8, -0.4]}, omega=[0.5, -1.0, 2.0])
        return polhode.simulate(polhode.Scenario(generic, start=start, torques=[acting], run=Run(duration=4, samples=5)), error="cheap")

    traced, called = motion(torque(law)), motion(FunctionTorque(function=numbers))
    assert [each.summary["run"]["method_used"] for each in (traced, called)] == ["taylor", "dop853"]
    assert np.abs(traced.omega - called.omega).max() < 1e-11 and np.abs(traced.attitude - called.attitude).max() < 1e-11
    assert np.abs(traced.omega[-1] - traced.omega[0]).max() > 0.1


def test_what_no_formula_can_be_is_refused() -> None:
    def message(law: object) -> str:
        with pytest.raises((polhode.PolhodeError, TypeError)) as caught:
            torque(law)
        return str(caught.value)

    assert "branches on a symbol" in message(lambda t: [1, 0, 0] if t < 1 else [0, 0, 0])
    assert "not those of math" in message(lambda t: [__import__("math").sin(t), 0, 0])
    assert "np.arcsinh" in message(lambda omega: np.arcsinh(omega))
    assert "for equality" in message(lambda t: [1.0 * (t == 0), 0, 0])
    assert "shape (3,)" in message(lambda omega: omega[:2])
    assert "parameter speed" in message(lambda t, speed: [speed, 0, 0])
    assert "must be a function" in message([0, 0, 1])
    assert torque(lambda t, omega: where(t > 2, -omega, [0, 0, 1])).torque == ("if(t>2,-wx,0)", "if(t>2,-wy,0)", "if(t>2,-wz,1)")
    assert torque(lambda omega: np.array([2 - omega[0], -(omega[1] - 1), (omega[2] / -3) ** -2])).torque == ("2-wx", "-(wy-1)", "(wz/(-3))^(-2)")


def test_a_law_of_numbers_raises_its_own_error(generic: polhode.MassProperties) -> None:
    def law(t: float) -> list[float]:
        raise ZeroDivisionError("of my own")

    made = polhode.Scenario(generic, torques=[FunctionTorque(function=law)], run=Run(duration=1.0, samples=2))
    with pytest.raises(ZeroDivisionError, match="of my own") as caught:
        polhode.simulate(made)
    assert any(entry.name == "law" for entry in caught.traceback)
    with pytest.raises(polhode.PolhodeError, match="shape"):
        polhode.simulate(made.replace(torques=[FunctionTorque(function=lambda t: [1.0, 2.0])]))
    assert "cannot be written into a file" in _message(made.to_toml)
    # Nor does a page show a text that says something else.
    still = polhode.simulate(made.replace(torques=[FunctionTorque(function=lambda t: [0.0, 0.0, t])]))
    assert 'model = \\"constant\\"' not in still.page()
    assert "use the time t" in _message(lambda: FunctionTorque(function=law, until=2.0))


def test_ensembles_have_torques_as_objects() -> None:
    omega = np.array([[0.1, 2.0, 0.3], [1.0, 0.2, -0.4]])
    given = [Drag(law="linear", coefficient=0.1), torque(lambda omega: -0.05 * omega)]
    text = '[[torque]]\nmodel = "drag"\nlaw = "linear"\ncoefficient = 0.15\n'
    one, other = (polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega, torques=torques).at([0.0, 3.0]) for torques in (given, text))
    assert np.abs(one.omega - other.omega).max() < 1e-13
    law = FunctionTorque(function=lambda omega: -0.15 * omega)
    called = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega, torques=[law]).at([0.0, 3.0])
    assert np.abs(one.omega - called.omega).max() < 1e-12


def test_formulas_in_si_are_not_checked() -> None:
    formula = FormulaTorque(axes="body", torque=["-0.1*wx + 2", 0, "sin(t)"], units="SI")
    body = polhode.MassProperties(mass=1.0, inertia=[1.0, 2.0, 2.5])
    assert len(polhode.simulate(polhode.Scenario(body, torques=[formula], run=Run(duration=1, samples=3)))) == 3
    checked = FormulaTorque(axes="body", torque=["-0.1*wx + 2", 0, 0])
    assert "dimensions differ" in _message(lambda: polhode.Scenario(body, torques=[checked]))
