"""Several flights: a sequence and a table."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pandas
import polhode
import pyarrow as pa
import pytest
from scipy.spatial.transform import Rotation

RNG = np.random.default_rng(5)


def flight(name: str, start: float, count: int) -> polhode.Flight:
    return polhode.Flight(name=name, times=start + 0.01 * np.arange(count), gyro=RNG.normal(size=(count, 3)))


FIRST, SECOND = flight("first", 1.0, 4), flight("second", 3.0, 3)
TURNED = polhode.Flight(name="turned", attitude_times=[7.0, 7.25], attitude=Rotation.random(2, rng=5), times=[7.25, 7.5], gyro=RNG.normal(size=(2, 3)))
FLIGHTS = polhode.results.Flights([FIRST, SECOND, TURNED])


def test_they_are_a_sequence() -> None:
    assert len(FLIGHTS) == 3 and FLIGHTS[0] is FIRST and FLIGHTS[-1] is TURNED and [*FLIGHTS] == [FIRST, SECOND, TURNED]
    assert FLIGHTS[1:] == polhode.results.Flights([SECOND, TURNED]) != FLIGHTS and SECOND in FLIGHTS and FLIGHTS.index(SECOND) == 1
    assert isinstance(FLIGHTS[::2], polhode.results.Flights) and len(polhode.results.Flights()) == 0
    with pytest.raises(IndexError):
        FLIGHTS[3]
    with pytest.raises(TypeError, match=r"flights\[1\] must be a Flight, not str"):
        polhode.results.Flights([FIRST, "second"])
    with pytest.raises(TypeError, match="must be a list of Flight, not int"):
        polhode.results.Flights(3)


def test_they_are_values() -> None:
    for again in (pickle.loads(pickle.dumps(FLIGHTS)), copy.copy(FLIGHTS), copy.deepcopy(FLIGHTS), polhode.results.Flights(FLIGHTS)):
        assert again == FLIGHTS and not again != FLIGHTS
    other = polhode.Flight(name="first", times=FIRST.times, gyro=FIRST.gyro + [[1e-15, 0, 0]] * 4)
    assert polhode.results.Flights([other, SECOND, TURNED]) != FLIGHTS and FLIGHTS != [FIRST, SECOND, TURNED]
    with pytest.raises(TypeError):
        hash(FLIGHTS)


def test_they_are_short_in_words() -> None:
    assert repr(FLIGHTS) == "Flights(first, second, turned: 10 readings)" and repr(polhode.results.Flights()) == "Flights(none)"
    assert repr(polhode.results.Flights([FIRST] * 7)) == "Flights(first, first, …, first: 28 readings)"
    assert "10 rows" in FLIGHTS._repr_html_() and "0 rows" in polhode.results.Flights()._repr_html_()


def test_they_are_a_table_of_readings() -> None:
    columns = FLIGHTS.columns()
    assert columns["flight"].tolist() == [0] * 4 + [1] * 3 + [2] * 3
    assert columns["time_s"].tolist() == [*FIRST.times, *SECOND.times, 7.0, 7.25, 7.5]
    gyro = np.stack([columns[f"gyro_{axis}_rad_s"] for axis in "xyz"], axis=1)
    assert (gyro[:4] == FIRST.gyro).all() and (gyro[-2:] == TURNED.gyro).all() and np.isnan(gyro[-3]).all()
    attitude = np.stack([columns[f"attitude_{axis}"] for axis in "wxyz"], axis=1)
    assert (attitude[-3:-1] == TURNED.attitude).all() and np.isnan(attitude[[*range(7), -1]]).all()
    assert list(polhode.results.Flights([FIRST]).columns()) == ["flight", "time_s", *(f"gyro_{axis}_rad_s" for axis in "xyz")]
    assert list(polhode.results.Flights().columns()) == ["flight", "time_s"]
    # What is handed out is nobody else's.
    columns["gyro_x_rad_s"][:] = 0.0
    assert (FLIGHTS.columns()["gyro_x_rad_s"][:4] == np.asarray(FIRST.gyro)[:, 0]).all()


def test_the_libraries_of_tables_take_them() -> None:
    frame = FLIGHTS.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.groupby("flight").size().tolist() == [4, 3, 3]
    table = FLIGHTS.to_arrow()
    assert table.schema.field("gyro_x_rad_s").metadata[b"unit"] == b"rad/s" and table.schema.field("flight").type == pa.int64()
    assert FLIGHTS.to_polars().shape == (10, 9) and pa.table(FLIGHTS).schema.equals(table.schema, check_metadata=True)
    dataset = FLIGHTS.to_xarray()
    assert dict(dataset.sizes) == {"reading": 10, "axis": 3, "component": 4} and dataset["gyro"].attrs["units"] == "rad/s"


def test_a_log_is_cut_into_them() -> None:
    times = np.arange(0.0, 6.0, 0.01)
    gyro = np.full((600, 3), 0.01)
    for start, omega in ((100, [9.0, 1.0, 2.0]), (350, [1.0, 8.0, -5.0])):
        true = polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=omega).at(times[:120]).omega
        gyro[start : start + 120] = true + 0.02 * RNG.normal(size=(120, 3))
    found = polhode.find_flights(times=times, gyro=gyro)
    assert isinstance(found, polhode.results.Flights) and len(found) == 2 and found[0].name.startswith("flight 1, 1.")
    body = polhode.identify_tumbles(flights=found)
    assert [fit.name for fit in body.flights] == [flight.name for flight in found] and body == polhode.identify_tumbles(flights=[*found])


def test_times_go_forward() -> None:
    for name, given in (
        ("times", {"times": [0.0, 0.02, 0.02], "gyro": np.ones((3, 3))}),
        ("attitude_times", {"attitude_times": [1.0, 0.5], "attitude": Rotation.random(2, rng=1)}),
    ):
        with pytest.raises(polhode.PolhodeError, match=rf"{name}\[.\] = .* must be greater than the one before"):
            polhode.Flight(**given)
