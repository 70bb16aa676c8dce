"""Results as values: equality, length, parts of them, short texts, and tables of other libraries."""

from __future__ import annotations

import builtins
import copy
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import polhode
import polhode.batch
import pyarrow as pa
import pytest
from conftest import PLAN, ROOT
from polhode import shapes

TENSOR = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]
TIMES = np.linspace(-3.0, 17.0, 9)


def free(**other: Any) -> polhode.FreeMotion:
    given = {"inertia": TENSOR, "omega": [0.9, -1.3, 0.7], "attitude": [0.4, -0.7, 1.1, 0.3], **other}
    return polhode.FreeMotion(**given)


def ensemble(last: float = 0.4) -> polhode.Ensemble:
    return polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=[[0.1, 2.0, -0.3], [1.1, 0.2, last]])


def top() -> polhode.results.Motion:
    return polhode.simulate(ROOT / "examples" / "heavy-top.toml", times=np.linspace(0.0, 0.25, 6), error="cheap")


def test_what_is_equal_is_equal() -> None:
    """By value, whoever computed it; what differs in one number is another."""
    body, ball = polhode.MassProperties(mass=2.3, inertia=TENSOR), shapes.sphere(radius=0.1, mass=1.0)
    pairs = [
        (body, polhode.MassProperties(mass=2.3, inertia=TENSOR), polhode.MassProperties(mass=2.3, center_of_mass=[0, 0, 1e-300], inertia=TENSOR)),
        (polhode.Body({"a": body, "b": ball}), polhode.Body({"b": ball, "a": body}), polhode.Body({"a": body, "b": body})),
        (free(), free(attitude=[-0.8, 1.4, -2.2, -0.6]), free(omega=[0.9, -1.3, np.nextafter(0.7, 1.0)])),
        (free(), pickle.loads(pickle.dumps(free())), free(inertia=[3.1, 4.2, 5.3])),
        (free().at(TIMES), free().at(TIMES.tolist()), free().at(TIMES + 1e-9)),
        (free().error(TIMES), free().error(TIMES), free().error(TIMES + 1.0)),
        (ensemble(), ensemble(), ensemble(0.5)),
        (ensemble().at([0.0, 3.0]), ensemble().at([0.0, 3.0]), ensemble(0.5).at([0.0, 3.0])),
        (top(), copy.deepcopy(top()), polhode.simulate(ROOT / "examples" / "heavy-top.toml", times=[0.0, 0.25], error="cheap")),
        links(),
        inertials(),
        judged(),
        plans(),
    ]
    for one, same, other in pairs:
        assert one == same and not one != same, type(one)
        assert one != other and other != same and one != 3 and one != None, type(one)  # noqa: E711
    for value in (body, free(), ensemble(), top()):
        assert hash(value) == hash(pickle.loads(pickle.dumps(value)))


def judged() -> tuple[polhode.results.Judgement, ...]:
    scenario = '[[body.part]]\nshape = "tensor"\nmass = 1\nmoments = [1, 2, 2.5]\n[start]\nspin = { body = [0.3, -1.2, 0.4] }\n'
    times = np.linspace(0.0, 2.0, 21)
    omega, attitude = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, -1.2, 0.4]).at(times)
    late = polhode.FreeMotion(moments=[1, 2, 2.5], omega=[0.3, -1.2, 0.4]).at(times - 0.01).attitude
    one, same, other = (polhode.judge(scenario, times=times, attitude=given, quaternion="wxyz", sense="body_to_space", time_origin=0.0) for given in (attitude, attitude, late))
    return one, same, other


def plans() -> tuple[polhode.batch.Plan, ...]:
    return polhode.batch.Plan(PLAN.format(members=4)), polhode.batch.Plan(PLAN.format(members=4)), polhode.batch.Plan(PLAN.format(members=5))


def links() -> tuple[polhode.results.LinkTable, ...]:
    arm = ROOT / "examples" / "robots" / "arm.urdf"
    return polhode.link_table(arm), polhode.link_table(arm), polhode.link_table(arm, joints={"elbow": 0.3})


def inertials() -> tuple[polhode.results.WrittenInertials, ...]:
    arm = ROOT / "examples" / "robots" / "arm.urdf"
    return polhode.write_inertials(arm), polhode.write_inertials(arm), polhode.write_inertials(arm, material="steel")


def test_no_table_becomes_another_by_the_constructor_of_pandas() -> None:
    """It would take the elements of an iterator for rows: what has columns names what gives them, and rows that are named tuples are right."""
    motion = top()
    flights = polhode.results.Flights([polhode.Flight(times=[0, 0.01], gyro=[[1, 2, 3], [1.1, 1.9, 3]])])
    error = motion.error
    assert error is not None
    for value in (motion, motion.states, error, ensemble().at([0.0, 3.0]), free().at(TIMES), flights):
        kind = type(value).__name__
        for make in (pd.DataFrame, np.asarray, np.array):
            with pytest.raises(TypeError, match=rf"an? {kind} is not an array: use to_pandas\(\) for a DataFrame"):
                make(value)
        assert list(value.to_pandas().columns) == list(value.columns())
    parts = polhode.budget("name,mass [kg]\na,1\nb,2\n", draws=0)
    body = polhode.Body({"a": polhode.MassProperties(mass=2.3, inertia=TENSOR)})
    for value, named in ((links()[0], "to_csv"), (parts, "only.rows"), (body, "parts")):
        with pytest.raises(TypeError, match=named):
            pd.DataFrame(value)
    assert pd.DataFrame(parts.only.rows)["basic"].tolist() == [1.0, 2.0, 3.0]
    assert pd.DataFrame(parts.only.estimate)["name"].tolist()[:2] == ["mass", "x"]
    # Unpacking and iterating are as before.
    omega, attitude = motion.states
    assert omega.shape == (6, 3) and attitude.shape == (6, 4) and len(list(motion)) == 6


def test_states_have_a_length_and_parts() -> None:
    states = free().at(TIMES)
    omega, attitude = states
    assert len(states) == 9 and omega is states.omega and attitude is states.attitude
    one = states[-2]
    assert (one.times, one.omega.shape, one.attitude.shape) == (TIMES[-2], (3,), (4,)) and np.array_equal(one.omega, omega[7])
    assert np.array_equal(states[2:5].omega, omega[2:5]) and len(states[TIMES > 0.0]) == (TIMES > 0.0).sum()
    assert list(states.columns()) == [
        *("time_s", "attitude_w", "attitude_x", "attitude_y", "attitude_z"),
        *(f"omega_body_{axis}_rad_s" for axis in "xyz"),
    ]
    one.omega[:] = 99.0
    assert states == free().at(TIMES)
    with pytest.raises(TypeError):
        len(free().at(2.0))
    with pytest.raises(IndexError):
        states[9]


def test_an_ensemble_has_members() -> None:
    states = ensemble().at([0.0, 1.5, 4.0])
    assert len(states) == 2 and np.array_equal(states.times, [0.0, 1.5, 4.0])
    alone = polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=[1.1, 0.2, 0.4]).at([0.0, 1.5, 4.0])
    assert states[1] == alone and states[-1] == alone
    columns = states.columns()
    assert columns["member"].tolist() == [0, 0, 0, 1, 1, 1] and columns["time_s"].tolist() == [0.0, 1.5, 4.0] * 2
    assert np.array_equal(columns["omega_body_y_rad_s"], states.omega[:, :, 1].ravel())
    for array in (*states, states.reached, states.times):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 99.0
    with pytest.raises(ValueError, match="read-only"):
        pickle.loads(pickle.dumps(states)).omega[0, 0, 0] = 99.0


def test_a_motion_has_states() -> None:
    motion = top()
    assert len(motion) == 6 and [state.times for state in motion] == motion.times.tolist()
    assert motion[2] == motion.states[2] and np.array_equal(motion[1:4].omega, motion.omega[1:4])


def test_texts_are_short() -> None:
    many = np.linspace(0.0, 1e3, 200_000)
    shared = ensemble()
    for thing in (free().at(many), free().at(2.0), free().error(many[:5]), shared.at(many[:1000]), free(), shared, top(), *links()[:1], links()[0][0]):
        assert len(repr(thing)) < 300 and "\n" not in repr(thing), type(thing)
        if hasattr(thing, "_repr_html_") and not isinstance(thing, (polhode.FreeMotion, polhode.results.Motion)):
            assert len(thing._repr_html_()) < 8000, type(thing)


def test_tables_of_pandas_and_polars_and_arrow_are_the_columns() -> None:
    for result in (top(), free().at(TIMES), free().at(2.0), free().error(TIMES), ensemble().at([0.0, 3.0])):
        columns = result.columns()
        arrow = result.to_arrow()
        for table in (result.to_pandas(), result.to_polars(), arrow.to_pandas(), pl.DataFrame(result), pa.table(result).to_pandas()):
            assert list(table.columns) == list(columns)
            for name, values in columns.items():
                assert np.array_equal(table[name].to_numpy(), values) and table[name].to_numpy().dtype == values.dtype
        assert isinstance(result.to_pandas(), pd.DataFrame)
        for field in arrow.schema:
            assert not field.nullable and field.metadata[b"unit"] and field.metadata[b"description"], field.name
    assert top().to_arrow().schema.field("omega_body_y_rad_s").metadata[b"unit"] == b"rad/s"


def test_a_dataset_of_xarray_has_axes() -> None:
    import xarray as xr

    motion = top()
    found = motion.to_xarray()
    assert isinstance(found, xr.Dataset) and found.omega.dims == ("time", "axis") and found.attitude.dims == ("time", "component")
    assert np.array_equal(found.momentum.sel(axis="y"), motion.momentum[:, 1]) and found.omega.attrs["units"] == "rad/s"
    assert np.array_equal(found.time, motion.times) and np.array_equal(found.work_j, motion.work)
    assert len(found.data_vars) == 1 + len(motion.columns()) - 1 - 4 * 3 - 4 + 4
    shared = ensemble().at([0.0, 3.0])
    of_many = shared.to_xarray()
    assert of_many.omega.dims == ("member", "time", "axis") and of_many.omega.sel(member=1, time=3.0, axis="z") == shared.omega[1, 1, 2]
    assert free().at(2.0).to_xarray().omega.dims == ("axis",)


def test_a_library_that_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name in ("pandas", "polars"):
            raise ImportError(name)
        return real(name, *rest, **more)

    states = free().at(TIMES)
    monkeypatch.setattr("polhode._table.import_module", without)
    for name in ("pandas", "polars"):
        with pytest.raises(ImportError, match=f"to_{name} needs {name}: pip install {name}"):
            getattr(states, f"to_{name}")()


SCENARIO = """
[[body.part]]
shape = "mesh"
file = "part.stl"
unit = "mm"
mass = "0.4 kg"

[start]
spin = {{ body = [0.1, 2, -0.3] }}

[[torque]]
model = "drag"
law = "linear"
coefficient = "1e-4 N m s"

[[event]]
name = "slow"
measure = "omega_body_y"
value = "{slow} rad/s"
then = "stop"

[run]
duration = "3 s"
samples = 4
"""


def test_a_motion_is_known_between_its_samples(tmp_path: Path) -> None:
    """In any order, to the bits of a simulation that had these times from the start."""
    asked = [1.7, 0.3, 3.0, 0.0, 1.7]
    for example in ("heavy-top", "gravity-gradient", "prescribed-table", "torsion-pendulum"):
        path = ROOT / "examples" / f"{example}.toml"
        motion = polhode.simulate(path, times=[0.0, 0.5, 3.0], error="cheap")
        states, wanted = motion.at(asked), polhode.simulate(path, times=[0.0, 0.3, 1.7, 3.0], error="cheap")
        order = [2, 1, 3, 0, 2]
        assert np.abs(states.omega - wanted.omega[order]).max() < 1e-12 * np.abs(wanted.omega).max(), example
        assert np.abs(states.attitude - wanted.attitude[order]).max() < 1e-12, example
        one = motion.at(1.7)
        assert one.omega.shape == (3,) and np.array_equal(one.omega, states.omega[0])
    with pytest.raises(polhode.PolhodeError, match=r"times\[1\] = 3.5 must be at most 3.0, the last time of the motion"):
        motion.at([1.0, 3.5])
    with pytest.raises(polhode.PolhodeError, match="-0.1"):
        motion.at([-0.1])
    with pytest.raises(polhode.PolhodeError, match="shape"):
        motion.at([[1.0]])


def test_a_motion_that_stopped_is_known_up_to_there(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_bytes((ROOT / "examples" / "bracket.stl").read_bytes())
    path = tmp_path / "scenario.toml"
    path.write_text(SCENARIO.format(slow=1.5))
    motion = polhode.simulate(path)
    assert motion.ending.kind == "stopped" and motion.ending.time is not None
    last = motion.times[-1]
    assert np.array_equal(motion.at(last).omega, motion.omega[-1])
    before = motion.at(0.9 * last)
    with pytest.raises(polhode.PolhodeError, match="at most"):
        motion.at(last + 1e-6)
    # A copy computes it anew, in another folder too; not where a file has become another.
    sent = pickle.dumps(motion)
    assert pickle.loads(sent).at(0.9 * last) == before
    mesh = (tmp_path / "part.stl").read_bytes()
    (tmp_path / "part.stl").unlink()
    with pytest.raises(FileNotFoundError):
        pickle.loads(sent).at(0.9 * last)
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    facets = np.frombuffer(mesh[84:], record).copy()
    facets["corners"][..., 2] *= 1.3
    (tmp_path / "part.stl").write_bytes(mesh[:84] + facets.tobytes())
    with pytest.raises(polhode.PolhodeError, match="one of its files has changed"):
        pickle.loads(sent).at(0.9 * last)
    (tmp_path / "part.stl").write_bytes(mesh)
    path.write_text("")  # its text is in the copy
    assert pickle.loads(sent).at(0.9 * last) == before


def test_errors_have_parts() -> None:
    error = top().error
    assert error is not None
    part = error[1:3]
    assert isinstance(part, polhode.results.MotionError) and len(part) == 2 and (part.omega == error.omega[1:3]).all() and part != error
    assert error[-1].attitude == error.attitude[-1] and repr(error[-1]).startswith("MotionError(attitude ") and error[:] == error
    with pytest.raises(IndexError):
        error[len(error)]


def test_every_result_is_shown_in_a_notebook(examples: Path) -> None:
    path = examples / "t-handle.toml"
    scenario = polhode.Scenario.from_toml(path)
    shown = {
        "stability": (polhode.stability(path), "<pre>"),
        "spin": (polhode.spins_from_periods(moments=[3.0836, 3.235, 1.0], periods=[7.40, 5.38], convention="long"), "<pre>"),
        "scenario": (scenario, "<pre>title = &quot;T-handle"),
        "derivatives": (polhode.FreeMotion(moments=[1, 2, 3], omega=[0.1, 1, 0.2]).derivatives([0.0, 1.0]), "array (2, 6, 6)"),
        "particles": (polhode.particle_derivatives(masses=[1.0, 2.0, 3.0], positions=[[0, 0, 1], [1, 0, 0], [0, 2, 0]]), "array (10, 3, 3)"),
        "flight": (polhode.Flight(times=[0.0, 0.1], gyro=[[1.5, 2, 3], [1, 2, 3]]), "1.5, 2, 3, 1, 2, 3"),
        "plan": (polhode.batch.Plan(examples / "sweeps" / "uncertain-satellite.toml"), "500 members"),
        "error": (top().error, "<table>"),
    }
    for name, (result, words) in shown.items():
        assert words in result._repr_html_(), name
    # Formulas are Markdown's.
    explained = polhode.explain(path)
    assert explained._repr_html_() is None and explained._repr_markdown_()
