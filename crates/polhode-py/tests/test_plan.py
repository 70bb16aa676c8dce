"""Plans that are made of objects, and tables of the user's own on all threads."""

from __future__ import annotations

import pickle
import threading
import time

import numpy as np
import pandas
import polars
import polhode
import pyarrow as pa
import pytest
from polhode import batch
from polhode.batch import Plan, Vary
from polhode.scenario import ConstantTorque, Drag, Event, FunctionTorque, Run, Start

BODY = polhode.Body(
    {
        "bus": polhode.MassProperties(mass=3.0, center_of_mass=[0.1, -0.2, 0.3], inertia=[[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]),
        "arm": polhode.MassProperties(mass=0.7, center_of_mass=[-0.4, 0.1, 0.2], inertia=[0.2, 0.3, 0.4]),
    }
)
SCENARIO = polhode.Scenario(
    BODY,
    start=Start(omega=[0.1, 2.0, -0.3]),
    torques=[Drag(law="linear", coefficient=0.01), ConstantTorque(axes="space", torque=[0.01, 0.02, 0.03])],
    run=Run(duration=20.0, samples=2),
)
RATES = ["start.omega[0]", "start.omega[1]", "torques[0].coefficient"]
COVARIANCE = np.array([[4e-4, 5e-4, 1e-6], [5e-4, 1e-2, -2e-6], [1e-6, -2e-6, 1e-8]])
NAMES = ["start_spin_body_x_rad_s", "start_spin_body_y_rad_s", "torque_0_coefficient_kg_m2_s"]


def columns(rows: pa.RecordBatch, names: list[str]) -> np.ndarray:
    return np.stack([rows[name].to_numpy() for name in names])


def test_a_covariance_matrix_is_that_of_the_draws() -> None:
    mean = [0.2, 1.5, 0.02]
    given = {"covariance": COVARIANCE, "mean": mean}
    plan = Plan(SCENARIO, vary=[Vary(key=RATES, correlated=given)], members=2**14, sampling="sobol", seed=np.int64(3))
    drawn = columns(batch.inputs(plan), NAMES)
    size = np.sqrt(np.outer(np.diag(COVARIANCE), np.diag(COVARIANCE)))
    assert np.allclose(drawn.mean(axis=1), mean, rtol=0, atol=1e-3 * np.sqrt(np.diag(COVARIANCE)))
    assert np.allclose(np.cov(drawn) / size, COVARIANCE / size, rtol=0, atol=5e-3)
    # the matrix alone, about the numbers as they are
    alone = Plan(SCENARIO, vary=[Vary(key=RATES, correlated=COVARIANCE)], members=2**14, sampling="sobol", seed=3)
    moved = columns(batch.inputs(alone), NAMES)
    assert np.allclose(moved - drawn, (np.array([0.1, 2.0, 0.01]) - mean)[:, None], rtol=0, atol=1e-14)


def test_standard_deviations_and_correlations_are_the_same() -> None:
    sd = np.sqrt(np.diag(COVARIANCE))
    by_sd = Vary(key=RATES, correlated={"sd": sd, "correlation": COVARIANCE / np.outer(sd, sd)})
    one, other = (batch.inputs(Plan(SCENARIO, vary=[vary], members=100)) for vary in (Vary(key=RATES, correlated=COVARIANCE), by_sd))
    assert np.allclose(columns(one, NAMES), columns(other, NAMES), rtol=1e-13)
    # What NumPy computes is symmetric, with ones, but for rounding; more than that is refused.
    computed = np.corrcoef(columns(one, NAMES))
    computed[0, 1] += 1e-16
    Plan(SCENARIO, vary=[Vary(key=RATES, correlated={"sd": sd, "correlation": computed})], members=3)
    for i, j in ((0, 1), (1, 1)):
        wrong = computed.copy()
        wrong[i, j] += 1e-9
        with pytest.raises(polhode.PolhodeError, match=r"vary\[0\].correlated: correlation"):
            Plan(SCENARIO, vary=[Vary(key=RATES, correlated={"sd": sd, "correlation": wrong})], members=3)


def test_a_part_varies_by_the_covariance_of_its_ten_numbers() -> None:
    a = np.random.default_rng(4).normal(size=(10, 10)) * np.array([0.03, *3 * [0.01], *6 * [0.02]])[:, None] / 4
    plan = Plan(SCENARIO, vary=[Vary(key='body["bus"]', correlated=a @ a.T)], members=2**14, sampling="sobol")
    names = [variable.name for variable in plan.variables]
    assert names[0] == "body_part_bus_mass_kg" and names[-1] == "body_part_bus_inertia_yz_kg_m2" and len(names) == 10
    drawn = columns(batch.inputs(plan), names)
    size = np.sqrt(np.outer(np.diag(a @ a.T), np.diag(a @ a.T)))
    assert np.allclose(np.cov(drawn) / size, a @ a.T / size, rtol=0, atol=1e-2)
    assert np.allclose(drawn[:4].mean(axis=1), [3.0, 0.1, -0.2, 0.3], rtol=0, atol=1e-3)


def test_distributions_are_those_of_a_file() -> None:
    vary = [
        Vary(key="start.omega[0]", uniform=(-0.2, 0.2)),
        Vary(key="start.omega[1]", normal=("2 rad/s", "10 deg/s")),
        Vary(key="start.omega[2]", list_=np.array([-0.3, -0.2])),
        Vary(key="torques[0].coefficient", log_normal={"median": 0.01, "sigma": 0.3}),
        Vary(key='body["arm"].mass', triangular=[0.6, 0.7, 0.9]),
        Vary(key="run.duration", relative=0.01),
        Vary(key="torques[1].torque[1]", log_uniform=(0.01, 0.05)),
        Vary(key="body.inertia", dispersion=0.1),
    ]
    made = Plan(SCENARIO, vary=vary[:4], members=50, seed=9, questions={"fast": "start_spin_body_y_rad_s > 2 rad/s"})
    text = SCENARIO.to_toml() + """
[sweep]
members = 50
sampling = "monte carlo"
seed = 9
[sweep.questions]
fast = "start_spin_body_y_rad_s > 2 rad/s"
[[sweep.vary]]
key = "start.spin.body[0]"
uniform = { from = -0.2, to = 0.2 }
[[sweep.vary]]
key = "start.spin.body[1]"
normal = { mean = "2 rad/s", sd = "10 deg/s" }
[[sweep.vary]]
key = "start.spin.body[2]"
list = [-0.3, -0.2]
[[sweep.vary]]
key = "torque[0].coefficient"
log_normal = { median = 0.01, sigma = 0.3 }
"""
    assert batch.inputs(made).equals(batch.inputs(Plan(text)))
    assert len(Plan(SCENARIO, vary=vary[1:4] + vary[5:7], members=3).variables) == 5
    assert [variable.name for variable in Plan(SCENARIO, vary=[vary[4]], members=3).variables] == ["body_part_arm_mass_kg"]
    assert len(Plan(SCENARIO, vary=[vary[7]], members=3).variables) == 6
    grid = Plan(SCENARIO, vary=[vary[2], Vary(key="start.omega[1]", grid={"from": 1, "to": 3, "count": 5})], sampling="grid")
    assert grid.members == 10 and repr(grid) == "Plan(10 members, start_spin_body_z_rad_s, start_spin_body_y_rad_s varied)"
    arrived = pickle.loads(pickle.dumps(made))
    assert arrived == made and batch.inputs(arrived).equals(batch.inputs(made))


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"vary": [Vary(key="start.omegb[0]", relative=0.1)], "members": 3}, r"vary\[0\].key: .*start has no key \"omegb\""),
        ({"vary": [Vary(key=RATES[:2], correlated=[[1, 2], [2, 1]])], "members": 3}, r"vary\[0\].correlated: covariance"),
        ({"vary": [Vary(key=RATES[:2], correlated=COVARIANCE)], "members": 3}, r"vary\[0\].correlated: "),
        ({"vary": [Vary(key=RATES[0], relative=0.1)]}, "Plan: the key members is missing"),
        ({"vary": [Vary(key=RATES[0], relative=0.1)], "members": 3, "sampling": "dice"}, "sampling: "),
        ({"vary": [Vary(key=RATES[0], relative=0.1)], "members": 3, "questions": {"q": "x > 1"}}, "questions: "),
        ({"members": 3}, "Plan: the key vary is missing"),
        ({"vary": [Vary(key=RATES[0])], "members": 3}, r"vary\[0\]: "),
        ({"vary": [Vary(key=RATES[0], relative=0.1, uniform=(1, 2))], "members": 3}, r"vary\[0\]\.(relative|uniform): "),
    ],
)
def test_a_plan_that_is_none_names_the_argument(given: dict[str, object], says: str) -> None:
    with pytest.raises(polhode.PolhodeError, match=says) as error:
        Plan(SCENARIO, **given)
    assert error.value.line is None


def test_what_varies_is_looked_at() -> None:
    for keys, says in (
        ({"normal": (1, 2, 3)}, "vary.normal must have 2 numbers, mean, sd, not 3"),
        ({"correlated": np.ones((2, 3))}, "must be a square matrix"),
        ({"correlated": {"sd": [1, 2], "correlation": np.ones(4)}}, "must be a square matrix"),
        ({"correlated": np.ones(2)}, r"must have the shape \(n, n\)"),
        ({"correlated": [[1.0, np.nan], [0.0, 1.0]]}, "must be finite"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            Vary(key=["a", "b"], **keys)
    with pytest.raises(TypeError, match="vary.key must be text, not int"):
        Vary(key=3, relative=0.1)
    with pytest.raises(TypeError, match=r"vary\[1\] must be"):
        Plan(SCENARIO, vary=[Vary(key=RATES[0], relative=0.1), {"key": RATES[1]}], members=3)
    with pytest.raises(polhode.PolhodeError, match="are only for a Scenario"):
        Plan("a = 1\nb = 2", members=3)
    with pytest.raises(polhode.PolhodeError, match="vary is only for a Scenario"):
        Plan("plan.toml", vary=[Vary(key=RATES[0], relative=0.1)])
    for own in (
        SCENARIO.replace(torques=[FunctionTorque(function=lambda t: [0.0, 0.0, t])]),
        SCENARIO.replace(events=[Event(measure=lambda t: t - 1.0)]),
    ):
        with pytest.raises(polhode.PolhodeError, match="cannot be written into a file"):
            Plan(own, vary=[Vary(key="start.omega[0]", relative=0.1)], members=3)


@pytest.fixture(scope="module")
def plan() -> Plan:
    return Plan(SCENARIO, vary=[Vary(key=key, relative=0.1) for key in RATES], members=4)


def own(count: int) -> dict[str, np.ndarray]:
    """Values that no plan has drawn."""
    rng = np.random.default_rng(7)
    return dict(zip(NAMES, (rng.normal(size=count), rng.uniform(1, 3, count), rng.uniform(0.005, 0.02, count))))


def test_tables_of_ones_own_are_rows(plan: Plan) -> None:
    given = own(60)
    found = batch.simulate(given, plan, threads=1)
    assert isinstance(found, pa.Table) and found["member"].to_pylist() == list(range(60))
    assert (found[NAMES[1]].to_numpy() == given[NAMES[1]]).all() and found.schema.field(NAMES[1]).metadata[b"unit"] == b"rad/s"
    frame = pandas.DataFrame(given, index=np.arange(100, 160))
    for same in (frame, polars.DataFrame(given), pa.table({"member": np.arange(60), **given})):
        assert batch.simulate(same, plan).equals(found)
    labelled = batch.simulate(frame.assign(label=[f"row {k}" for k in range(60)], member=range(7, 67)), plan)
    assert labelled["label"][3].as_py() == "row 3" and labelled["member"][0].as_py() == 7
    # each is the scenario with its values
    for k in (0, 41):
        x, y, drag = (given[name][k] for name in NAMES)
        torques = [Drag(law="linear", coefficient=float(drag)), SCENARIO.torques[1]]
        motion = polhode.simulate(SCENARIO.replace(start=Start(omega=[x, y, -0.3]), torques=torques))
        end = [found[f"end_omega_body_{axis}_rad_s"][k].as_py() for axis in "xyz"]
        assert np.allclose(motion.omega[-1], end, rtol=0, atol=1e-15)
    shared = batch.simulate({**given, NAMES[2]: 0.01}, plan)
    assert set(shared[NAMES[2]].to_pylist()) == {0.01} and shared.num_rows == 60
    assert batch.trajectories(frame, plan).num_rows == 2 * 60


def test_tables_of_ones_own_are_looked_at(plan: Plan) -> None:
    given = own(5)
    for wrong, error, says in (
        ({NAMES[0]: given[NAMES[0]]}, polhode.PolhodeError, f"the column {NAMES[1]} is missing"),
        ({**given, NAMES[0]: given[NAMES[0]][:3]}, polhode.PolhodeError, f"{NAMES[0]} has 3, .*give one for each row"),
        ({**given, NAMES[0]: np.ones((5, 2))}, polhode.PolhodeError, r"must have the shape \(n,\)"),
        ({**given, NAMES[0]: np.array(list("abcde"))}, TypeError, "must hold numbers, not string"),
        ({**given, NAMES[0]: [True] * 5}, TypeError, "must be a number, not a truth value"),
        ({**given, "status": given[NAMES[0]]}, polhode.PolhodeError, "rows already have a column status"),
        ({**given, NAMES[0]: np.ma.masked_invalid([1, 2, np.nan, 3, 4])}, polhode.PolhodeError, "has masked elements"),
    ):
        with pytest.raises(error, match=says):
            batch.simulate(wrong, plan)


def test_rows_are_computed_on_as_many_threads_as_are_asked_for(plan: Plan, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two threads are at work at the same time, with the rows of one."""
    given, meet, threads = own(1500), threading.Barrier(2), set()
    from polhode import _pieces

    def counted(function: object, count: int, asked: int) -> list[object]:
        met = threading.local()

        def piece(start: int, stop: int) -> object:
            threads.add(threading.get_ident())
            if not hasattr(met, "done"):
                # Each waits for the other in its first piece: one after the other they would never meet.
                met.done = meet.wait(10.0) >= 0
            return function(start, stop)

        return of(piece, count, asked)

    of = _pieces.of
    one = batch.simulate(given, plan, threads=1)
    monkeypatch.setattr(_pieces, "of", counted)
    two = batch.simulate(given, plan, threads=np.int64(2))
    assert two.equals(one) and len(threads) == 2


def test_threads_of_rows_end_with_the_first_error() -> None:
    from polhode import _pieces

    done: list[int] = []

    def piece(start: int, stop: int) -> int:
        if start > 3:
            raise ZeroDivisionError("mine")
        time.sleep(0.01)
        done.append(start)
        return stop

    with pytest.raises(ZeroDivisionError, match="mine"):
        _pieces.of(piece, 10**9, 2)
    assert len(done) < 10 and _pieces.of(lambda start, stop: stop - start, 0, 4) == [0]
    assert sum(_pieces.of(lambda start, stop: stop - start, 10_000, 3)) == 10_000
    for wrong in (0, 1.5, True, "2"):
        with pytest.raises((TypeError, polhode.PolhodeError), match="threads"):
            batch.simulate({name: 1.0 for name in NAMES}, Plan(SCENARIO, vary=[Vary(key=key, relative=0.1) for key in RATES], members=4), threads=wrong)
