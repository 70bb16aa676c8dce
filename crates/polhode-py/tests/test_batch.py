"""Plans and record batches, and sweeps in this process."""

from __future__ import annotations

import _thread
import hashlib
import json
import pickle
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pyarrow as pa
import pyarrow.parquet
import pytest
from conftest import PLAN, digest
from polhode import _pieces, batch, sweep


@pytest.fixture
def plan() -> batch.Plan:
    return batch.Plan(PLAN.format(members=2000))


def test_a_plan_says_what_it_varies(plan: batch.Plan, tmp_path: Path) -> None:
    assert plan.members == 2000 and len(plan.variables) == 3
    assert plan.variables[1] == ("start_spin_body_y_rad_s", "rad/s", "start.spin.body[1]")
    (tmp_path / "plan.toml").write_text(plan.text)
    assert batch.Plan(tmp_path / "plan.toml").digest == plan.digest != batch.Plan(PLAN.format(members=2001)).digest
    with pytest.raises(polhode.PolhodeError, match="plan.toml:6:8") as error:
        batch.Plan(PLAN.format(members=3).replace('"3 kg"', '"3 m"', 1))
    assert error.value.line == 6


def test_rows_are_the_same_wherever_a_table_is_cut(plan: batch.Plan) -> None:
    rows = batch.inputs(plan)
    whole = batch.simulate(rows, plan)
    assert rows.num_rows == whole.num_rows == 2000
    pieces = [batch.simulate(rows.slice(k, 333), plan) for k in range(0, 2000, 333)]
    assert pa.Table.from_batches(pieces).combine_chunks().equals(pa.Table.from_batches([whole]))
    table = batch.simulate(pa.Table.from_batches([rows.slice(0, 1000), rows.slice(1000)]), plan)
    assert table.equals(pa.Table.from_batches([whole]))
    assert batch.simulate(rows.slice(0, 0), plan).schema.equals(whole.schema, check_metadata=True)


def test_rows_say_what_the_library_says(plan: batch.Plan) -> None:
    rows = batch.simulate(batch.inputs(plan, range(100, 140)), plan)
    for row in rows.to_pylist():
        motion = polhode.FreeMotion(
            moments=[row["moment_1_kg_m2"], row["moment_2_kg_m2"], row["moment_3_kg_m2"]],
            omega=[row["start_spin_body_x_rad_s"], row["start_spin_body_y_rad_s"], -0.3],
        )
        assert row["regime"] == motion.regime and np.isclose(row["period_s"], motion.period, rtol=1e-14)
        end = [row[f"end_omega_body_{axis}_rad_s"] for axis in "xyz"]
        assert np.allclose(motion.at(60.0).omega, end, rtol=0, atol=1e-13)
    assert rows.schema.field("period_s").metadata[b"unit"] == b"s"


def test_members_that_are_no_bodies_are_rows_too(plan: batch.Plan) -> None:
    rows = batch.inputs(plan, range(0, 3))
    column = rows.schema.get_field_index("body_part_0_mass_kg")
    wrong = rows.set_column(column, rows.schema.field(column), pa.array([3.0, -1.0, 2.0]))
    done = batch.simulate(wrong, plan)
    assert done["status"].to_pylist() == ["complete", "failed", "complete"]
    assert done["cause"][1].as_py() and done["period_s"][1].as_py() is None


def test_what_are_no_rows_is_refused(plan: batch.Plan) -> None:
    rows = batch.inputs(plan, range(0, 3))
    for wrong, error, says in (
        (rows.drop_columns(["member"]), polhode.PolhodeError, "the column member is missing"),
        ([1.0, 2.0], TypeError, "rows must be a pyarrow RecordBatch or Table, a dataframe, or a mapping"),
        (rows.set_column(0, "member", pa.array([0.0, 1.0, 2.0])), TypeError, "member must hold whole numbers, not double"),
        (rows.set_column(0, "member", pa.array([0, None, 2])), polhode.PolhodeError, "has missing values"),
        (rows.set_column(0, "member", pa.array([0, -1, 2])), polhode.PolhodeError, "negative"),
        (rows.set_column(1, rows.column_names[1], pa.array(["a", "b", "c"])), TypeError, "must hold numbers, not string"),
    ):
        with pytest.raises(error, match=says):
            batch.simulate(wrong, plan)
    for members in (range(0, 2001), range(5, 2), range(0, 10, 2)):
        with pytest.raises(polhode.PolhodeError, match="must be a range"):
            batch.inputs(plan, members)


def test_a_plan_travels_as_its_text(plan: batch.Plan, tmp_path: Path, examples: Path) -> None:
    arrived = pickle.loads(pickle.dumps(plan))
    assert arrived.digest == plan.digest and pickle.loads(pickle.dumps(plan))._native is arrived._native
    # one that names a file, which is another one where it arrives
    (tmp_path / "part.stl").write_bytes((examples / "bracket.stl").read_bytes())
    body = '[[body.part]]\nshape = "mesh"\nfile = "part.stl"\nunit = "mm"\nmass = "1 kg"\n'
    start = PLAN.format(members=4).index("[start]")
    path = tmp_path / "mesh.toml"
    path.write_text(body + PLAN.format(members=4)[start:])
    sent = pickle.dumps(batch.Plan(path))
    assert pickle.loads(sent).members == 4
    batch._read.cache_clear()
    (tmp_path / "part.stl").write_bytes((examples / "bracket.stl").read_bytes().replace(b"\0\0\0\0", b"\0\0\0\0", 1) + b"\0")
    with pytest.raises(polhode.PolhodeError):
        pickle.loads(sent)


def test_a_sweep_is_a_folder_of_parts(plan: batch.Plan, tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    found = sweep.run(plan, tmp_path / "one", threads=2, progress=lambda *reached: told.append(reached))
    assert told[-1][1] == 2000 and max(done for done, _ in told) == 2000
    assert found.summary["members"]["asked"] == 2000 if isinstance(found.summary.get("members"), dict) else True
    assert json.loads((tmp_path / "one" / "summary.json").read_text()) == found.summary and str(found) == found.text
    table = pa.parquet.read_table(tmp_path / "one" / "members")
    assert table["member"].to_pylist() == list(range(2000))

    # what is lost is made again, with the same bytes
    before = digest(tmp_path / "one")
    first = min((tmp_path / "one" / "members").iterdir())
    bytes_before = hashlib.sha256(first.read_bytes()).hexdigest()
    first.unlink()
    sweep.run(plan, tmp_path / "one", threads=1, resume=True)
    assert hashlib.sha256(first.read_bytes()).hexdigest() == bytes_before and digest(tmp_path / "one") == before


def test_folders_are_guarded(plan: batch.Plan, tmp_path: Path) -> None:
    sweep.run(plan, tmp_path / "one")
    with pytest.raises(polhode.PolhodeError, match="already exists"):
        sweep.run(plan, tmp_path / "one")
    with pytest.raises(polhode.PolhodeError, match="another plan"):
        sweep.run(batch.Plan(PLAN.format(members=2001)), tmp_path / "one", resume=True)
    with pytest.raises(polhode.PolhodeError, match="resume and force"):
        sweep.run(plan, tmp_path / "one", resume=True, force=True)
    for on in ("dask", "spark://h:1", "ray://"):
        with pytest.raises(polhode.PolhodeError, match="is not a cluster"):
            sweep.run(plan, tmp_path / "two", on=on)


def test_an_interrupt_keeps_what_is_done(plan: batch.Plan, tmp_path: Path) -> None:
    def stop(done: int, members: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep.run(plan, tmp_path / "one", threads=1, progress=stop)
    kept = list((tmp_path / "one" / "members").glob("part-*.parquet"))
    assert kept and not (tmp_path / "one" / "summary.json").exists()
    sweep.run(plan, tmp_path / "one", resume=True)
    sweep.run(plan, tmp_path / "two")
    assert digest(tmp_path / "one") == digest(tmp_path / "two")


def test_the_command(plan: batch.Plan, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "plan.toml").write_text(plan.text)
    arguments = [str(tmp_path / "plan.toml"), "-o", str(tmp_path / "out"), "--json"]
    assert sweep.main(arguments) == 0
    assert json.loads(capsys.readouterr().out) == json.loads((tmp_path / "out" / "summary.json").read_text())
    assert sweep.main(arguments) == 2
    assert "already exists" in capsys.readouterr().err
    assert sweep.main([*arguments, "--resume"]) == 0


def test_what_rows_hold_is_kept_or_refused(plan: batch.Plan) -> None:
    rows = batch.inputs(plan, range(600))
    name = rows.schema.names[1]
    own = rows.append_column("status", pa.array(["mine"] * 600))
    degrees = rows.set_column(1, pa.field(name, pa.float64(), metadata={"unit": "deg/s"}), rows.column(1))
    numbers = [0.5] * 600
    numbers[417] = 2**60
    for wrong, says in (
        (own, "rows already have a column status"),
        (batch.simulate(rows, plan), "rows already have a column status"),
        (rows.append_column(name, rows.column(1)), f"there are 2 columns {name}"),
        (degrees, f"column {name} is in deg/s, as its field says, and must be in rad/s"),
        # counted in the table, not in a piece of it
        (rows.set_column(1, name, pa.array([int(x) for x in numbers])), r"\[417\] = 1152921504606846976"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            batch.simulate(wrong, plan)
    named = batch.simulate(rows.append_column("name", pa.array([f"body {k}" for k in range(600)])), plan)
    assert named["name"].to_pylist() == [f"body {k}" for k in range(600)]
    whole = pa.Table.from_batches([rows.slice(0, 100), rows.slice(100)])
    assert batch.simulate(whole, plan).equals(pa.Table.from_batches([batch.simulate(rows, plan)]))


def test_what_there_is_no_memory_for_is_refused(plan: batch.Plan) -> None:
    """More than addresses have bits for: an allocation that fails would end the process."""
    more = [f"start.spin.body[{k}]" for k in (2,)] + [f"body.part[0].moments[{k}]" for k in range(3)]
    more += [f"start.attitude.axis[{k}]" for k in range(3)]
    each = "".join(f'[[sweep.vary]]\nkey = "{key}"\nuniform = {{ from = 1.9, to = 2 }}\n' for key in more)
    with pytest.raises(MemoryError, match="not enough memory for the inputs of 1000000000000 members"):
        batch.inputs(batch.Plan(PLAN.format(members=10**12) + each))
    bodies = polhode.Ensemble(moments=[1, 2, 2.5], omega=np.ones((300_000, 3)))
    with pytest.raises(MemoryError, match="not enough memory for the states of 300000 members at 10000000 times"):
        bodies.at(np.zeros(10_000_000))


def test_pieces_do_not_shrink_while_the_processor_is_with_others() -> None:
    sizes: list[int] = []

    def piece(start: int, stop: int) -> tuple[int, int]:
        sizes.append(stop - start)
        time.sleep(0.6 * _pieces.LOOK if len(sizes) < 6 else 0.0)
        return start, stop

    found = _pieces.of(piece, 63, 1)
    assert [stop - start for start, stop in found] == sizes == [1, 2, 4, 8, 16, 32]
    assert [start for start, _ in found] == [0, 1, 3, 7, 15, 31]


@pytest.mark.usefixtures("ctrl_c")
@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_ends_rows_that_take_long(examples: Path, threads: int) -> None:
    """A table of few rows, each of them a long motion."""
    text = (examples / "formula.toml").read_text().replace('"4 min"', '"2e4 s"').replace("samples = 961", "samples = 2")
    text += '[sweep]\nmembers = 40\nseed = 7\nsampling = "monte carlo"\n[[sweep.vary]]\nkey = "start.spin.body[1]"\nuniform = { from = 1, to = 3 }\n'
    long = batch.Plan(text)
    rows = batch.inputs(long)
    done: list[int] = []
    timer = threading.Timer(0.2, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        batch._mapped(rows, batch._names(long), lambda columns: (done.append(len(columns[0][1])), long._native.simulate(columns))[1], threads)
    timer.join()
    assert sum(done) < 40


def test_threads_are_of_this_process_and_workers_of_a_cluster(tmp_path: Path) -> None:
    plan = batch.Plan(PLAN.format(members=10))
    with pytest.raises(polhode.PolhodeError, match="workers have no effect without a cluster"):
        sweep.run(plan, tmp_path / "one", workers=2)
    with pytest.raises(polhode.PolhodeError, match="threads have no effect on a cluster"):
        sweep.run(plan, tmp_path / "one", threads=2, on="dask://local")
    assert not (tmp_path / "one").exists()
