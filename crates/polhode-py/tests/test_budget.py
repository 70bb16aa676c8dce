"""Parts lists: the answers of the command, of dataframes and of columns; options and errors."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pandas
import polars
import polhode
import pyarrow
import pytest
from scipy.spatial.transform import Rotation

#: A frame of which all stands turned, a plate and a point with their errors, and something heavy.
COLUMNS: dict[str, list[Any]] = {
    "name": ["sat", "sat/plate", "sat/box", "sat/box/cells"],
    "quantity": [None, None, None, 3],
    "mass [kg]": [None, 2.25, None, "0.31 ± 0.02"],
    "x [mm]": [None, 11.0, None, -4.5],
    "y [mm]": [None, 0.0, None, 0.0],
    "z [mm]": [None, 0.0, None, 1.5],
    "at x [mm]": [None, 0.0, 110.25, None],
    "at y [mm]": [None, 0.0, 0.0, None],
    "at z [mm]": [None, 20.5, -30.0, None],
    "at z sd [mm]": [None, 0.5, 0.25, None],
    "shape": [None, "box", None, None],
    "size [mm]": [None, "200 × 100 × 3", None, None],
    "maturity": [None, "A", None, "B"],
    "allowable [kg]": [3.5, None, None, None],
}
PLAN: dict[str, Any] = {"title": "A plate", "growth": {"A": "4 %", "B": 0.2}, "result": {"draws": 50, "seed": 4}}


def csv(columns: dict[str, list[Any]]) -> str:
    rows = [list(columns), *zip(*columns.values())]
    return "".join(",".join("" if cell is None else str(cell) for cell in row) + "\n" for row in rows)


@pytest.fixture
def written(tmp_path: Path) -> Path:
    path = tmp_path / "plate.csv"
    head = '# title = "A plate"\n# growth = { A = "4 %", B = 0.2 }\n# result = { draws = 50, seed = 4 }\n'
    path.write_text(head + csv(COLUMNS), encoding="utf-8")
    return path


def command(*arguments: str | Path) -> str:
    done = subprocess.run([sys.executable, "-m", "polhode", "budget", *map(str, arguments)], capture_output=True, text=True, timeout=200)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_answers_are_those_of_the_command(written: Path) -> None:
    found, said = polhode.budget(written), json.loads(command(written, "--json"))
    assert found.to_dict() == said
    assert found.page() == command(written, "--html")
    assert found._repr_markdown_() == command(written, "--markdown")
    assert found.report() == command(written)
    assert (found.title, found.basis, len(found)) == ("A plate", "predicted", 1)
    case = said["configurations"][0]
    assert np.array_equal(found.covariance, case["estimate"]["covariance"])
    assert np.array_equal(found.inertia, case["estimate"]["inertia"])
    assert np.array_equal(found.only.moments, case["principal"]["moments"])
    assert found.only.scenario == command(written, "--body")


def test_numbers_are_the_sums() -> None:
    found = polhode.budget(COLUMNS, plan=PLAN).only
    plate, cells = 2.25 * 1.04, 3 * 0.31 * 1.2
    mass = plate + cells
    assert np.isclose(found.mass, mass, rtol=1e-14)
    x = (plate * 0.011 + cells * (0.11025 - 0.0045)) / mass
    z = (plate * 0.0205 + cells * (-0.03 + 0.0015)) / mass
    assert np.allclose(found.center_of_mass, [x, 0.0, z], rtol=1e-13, atol=1e-17)
    far = plate * ((0.011 - x) ** 2 + (0.0205 - z) ** 2) + cells * ((0.10575 - x) ** 2 + (-0.0285 - z) ** 2)
    assert np.isclose(found.inertia[1, 1], plate / 12 * (0.2**2 + 0.003**2) + far, rtol=1e-12)
    assert np.isclose(found.estimate["mass"].sd or 0.0, 3 * 1.2 * 0.02, rtol=1e-13)
    assert np.isclose(found.basic.values[0], 2.25 + 0.93) and found.predicted["mass"] == found.estimate["mass"]
    assert found.draws.shape == (50, 10)
    assert abs(found.draws[:, 0].mean() - mass) < 5 * found.draws[:, 0].std() / 7
    assert [error.source for error in found.errors["mass"]] == ["box/cells"]
    assert [row.name for row in found.rows] == COLUMNS["name"] and found.rows[3].parent == "sat/box" and found.rows[3].quantity == 3
    assert found.rows[0].margin is not None and np.isclose(found.rows[0].margin, 3.5 - mass)
    assert found.body.mass == found.mass and np.array_equal(found.body.inertia, found.inertia)


def test_tables_of_every_kind_are_the_same() -> None:
    columns = polhode.budget(COLUMNS, plan=PLAN)
    frame = pandas.DataFrame(COLUMNS)
    assert frame["mass [kg]"].dtype == object and frame["at z [mm]"].dtype == float
    text = {name: [None if cell is None else str(cell) for cell in cells] for name, cells in COLUMNS.items()}
    for table in (frame, frame.set_index(frame.index + 7), polars.DataFrame(text), pyarrow.table(text), pandas.DataFrame(text)):
        assert polhode.budget(table, plan=PLAN) == columns
    assert pickle.loads(pickle.dumps(columns)) == columns


def test_what_is_asked_is_answered() -> None:
    turned = np.array([[0.0, -1.0, 0.0], [0.8, 0.0, -0.6], [0.6, 0.0, 0.8]])
    point = np.array([0.1, -0.2, 0.3])
    found = polhode.budget(COLUMNS, plan=PLAN, basis="basic", about=point, axes=turned, draws=0)
    assert found.basis == "basic" and found.draws.shape == (0, 10)
    assert np.isclose(found.mass, 3.18)
    asked = found.only.asked_inertia
    assert asked is not None and np.allclose(asked, turned.T @ found.body.inertia_about(point) @ turned, rtol=1e-12)
    for same in (Rotation.from_matrix(turned), 2.0 * Rotation.from_matrix(turned).as_quat()[[3, 0, 1, 2]], {"matrix": turned}):
        again = polhode.budget(COLUMNS, plan=PLAN, basis="basic", about=point, axes=same, draws=0).only.asked_inertia
        assert again is not None and np.allclose(again, asked, rtol=0, atol=1e-14)
    one, other = (polhode.budget(COLUMNS, plan=PLAN, seed=seed).draws for seed in (5, 6))
    assert not np.array_equal(one, other)
    assert np.array_equal(one, polhode.budget(COLUMNS, plan=PLAN, seed=5, draws=80).draws[:50])


def test_configurations_have_names() -> None:
    columns = {name: [*cells, cells[1]] for name, cells in COLUMNS.items()}
    columns["configuration"] = [None, "flat", None, None, "tall"]
    columns["size [mm]"][4] = "3 × 100 × 200"
    found = polhode.budget(columns, plan=PLAN)
    assert [case.name for case in found] == ["flat", "tall"]
    assert found["flat"].inertia[0, 0] < found["tall"].inertia[0, 0]
    with pytest.raises(polhode.PolhodeError, match="several configurations: 'flat', 'tall'"):
        found.mass
    with pytest.raises(KeyError, match="not one of flat, tall"):
        found["long"]
    only = polhode.budget(columns, plan=PLAN, configuration="tall")
    assert only.mass == found["tall"].mass
    with pytest.raises(polhode.PolhodeError, match='unknown configuration "long"'):
        polhode.budget(columns, plan=PLAN, configuration="long")


def test_what_is_too_heavy_is_a_warning() -> None:
    heavy = {**COLUMNS, "allowable [kg]": [3.4, None, None, None]}
    with pytest.warns(polhode.PolhodeWarning, match="heavier than allowed, including the growth allowance"):
        assert polhode.budget(heavy, plan=PLAN).is_beyond


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mass [kg]": [None, -2.25, None, 0.31]}, "row 1: .*-2.25"),
        ({"mass [kg]": [None, "2.25 m", None, 0.31]}, "row 1"),
        ({"name": ["sat", "sat/plate", "sat/box", "sat/bix/cells"]}, 'row 3: .*"sat/bix"'),
        ({"maturity": [None, "Z", None, "B"]}, 'row 1: .*"Z"'),
        ({"quantity": [None, None, 3]}, "different lengths"),
    ],
)
def test_a_row_that_is_wrong_is_named(change: dict[str, list[Any]], message: str) -> None:
    with pytest.raises(polhode.PolhodeError, match=message):
        polhode.budget({**COLUMNS, **change}, plan=PLAN)


def test_what_is_no_list_is_refused(written: Path) -> None:
    with pytest.raises(TypeError, match="not int"):
        polhode.budget(3)
    with pytest.raises(TypeError, match=r"quantity\[3\] = True must be text or a number"):
        polhode.budget({**COLUMNS, "quantity": [None, None, None, True]}, plan=PLAN)
    with pytest.raises(polhode.PolhodeError, match="plan is only for a table"):
        polhode.budget(written, plan=PLAN)
    with pytest.raises(FileNotFoundError):
        polhode.budget(written.with_name("other.csv"))
    with pytest.raises(polhode.PolhodeError, match="basis = 'heavy' must be one of basic, predicted"):
        polhode.budget(written, basis="heavy")
    with pytest.raises(polhode.PolhodeError, match="draws"):
        polhode.budget(written, draws=3)
    wrong = written.read_text(encoding="utf-8").replace("2.25", "x")
    with pytest.raises(polhode.PolhodeError) as refused:
        polhode.budget(wrong)
    assert refused.value.line == 6


def test_limits_have_probabilities() -> None:
    limits = [
        {"of": "mass", "most": "3.5 kg"},
        {"name": "flat", "of": "spin ratio", "along": "z", "least": 1},
        {"of": "center distance", "along": "z", "within": "1 m"},
    ]
    found = polhode.budget(COLUMNS, plan={**PLAN, "limit": limits})
    assert [(limit.name, limit.unit, limit.met) for limit in found.limits] == [
        ("mass", "kg", True),
        ("flat", "", True),
        ("center distance along z", "m", True),
    ]
    mass = found.limits[0]
    assert mass.most == 3.5 and mass.least is None and mass.value == found.mass
    assert 0.5 < mass.probability < 1.0 and mass.interval[0] < mass.probability < mass.interval[1]
    assert found.only.errors["flat"] and str(mass).startswith("mass: met, probability ")
    with pytest.warns(polhode.PolhodeWarning, match="this limit is not met: mass"):
        assert polhode.budget(COLUMNS, plan={**PLAN, "limit": [{"of": "mass", "most": "3.4 kg"}]}).is_beyond
    with pytest.raises(polhode.PolhodeError, match="draws is 0"):
        polhode.budget(COLUMNS, plan={**PLAN, "limit": limits}, draws=0)
