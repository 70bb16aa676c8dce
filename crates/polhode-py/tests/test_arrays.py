"""Arrays of every kind: taken with the bits that they have, or refused with the name, the element and the rule."""

from __future__ import annotations

import warnings

import numpy as np
import polhode
import pytest
from polhode import _arrays

MOMENTS = [1.25, 2.5, 3.125]
OMEGA = [0.375, -1.25, 0.0625]
TIMES = np.array([0.0, 0.5, -3.25, 1024.0])


def motion(**changed: object) -> polhode.FreeMotion:
    return polhode.FreeMotion(**({"moments": MOMENTS, "omega": OMEGA} | changed))


@pytest.mark.parametrize(
    "times",
    [
        TIMES.tolist(),
        tuple(TIMES),
        TIMES.astype(np.float32),
        TIMES.astype(np.float16),
        TIMES.astype(">f8"),
        TIMES.astype(">f4"),
        np.repeat(TIMES, 3)[::3],
        TIMES[::-1][::-1],
        np.asfortranarray(np.outer(TIMES, [1.0, 2.0]))[:, 0],
        np.frombuffer(b"?" + TIMES.tobytes(), np.float64, offset=1),
        np.ma.MaskedArray(TIMES),
    ],
    ids=["list", "tuple", "f4", "f2", "big-endian", "big-endian f4", "strided", "reversed", "fortran", "misaligned", "unmasked"],
)
def test_every_exact_array_gives_the_same_bits(times: object) -> None:
    wanted = motion().at(TIMES)
    found = motion().at(times)
    assert np.array_equal(found.omega, wanted.omega) and np.array_equal(found.attitude, wanted.attitude)


def test_whole_numbers_are_numbers() -> None:
    whole = polhode.FreeMotion(moments=np.array([1, 2, 3], dtype=np.uint8), omega=[1, -2, 3])
    assert np.array_equal(whole.at([7]).omega, polhode.FreeMotion(moments=[1.0, 2.0, 3.0], omega=[1.0, -2.0, 3.0]).at(7.0).omega[None])


def test_what_is_right_already_is_not_copied() -> None:
    assert np.shares_memory(_arrays.numbers("times", TIMES, ("n",)), TIMES)


def test_nothing_that_is_given_is_changed() -> None:
    times, omega = TIMES.copy(), np.array(OMEGA)
    motion(omega=omega).at(times)
    assert np.array_equal(times, TIMES) and np.array_equal(omega, OMEGA)


def test_tensors_of_single_precision_are_averaged_with_a_warning() -> None:
    """By 2e-7 of the greatest moment: the mean of both halves. By 2e-6: refused."""
    tensor = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
    turned, _ = np.linalg.qr(np.array([[0.9, -1.2, 0.3], [0.4, 0.8, -0.7], [-1.1, 0.2, 0.5]]))
    single = turned.astype(np.float32) @ tensor.astype(np.float32) @ turned.T.astype(np.float32)
    single[0, 1] = np.nextafter(single[1, 0], np.float32(9))
    assert single.dtype == np.float32 and 0 < np.abs(single - single.T).max() < 1e-6 * single.max()
    mean = 0.5 * (single.astype(float) + single.T.astype(float))
    said = r"inertia is not symmetric: its halves differ by [0-9.e-]+ of the greatest moment"
    for given in (single, single.astype(float), single.astype(float).tolist()):
        with pytest.warns(polhode.PolhodeWarning, match=said):
            body = polhode.MassProperties(mass=2.3, inertia=given)
        assert np.array_equal(body.inertia, mean)
    with pytest.warns(polhode.PolhodeWarning, match=said):
        motion = polhode.FreeMotion(inertia=single, omega=[0.3, -1.2, 0.4])
    assert motion == polhode.FreeMotion(inertia=mean, omega=[0.3, -1.2, 0.4])
    with pytest.warns(polhode.PolhodeWarning, match=said):
        members = polhode.Ensemble(inertia=np.array([tensor, single]), omega=[[0.3, -1.2, 0.4], [0.1, 0.2, -0.3]])
    assert members == polhode.Ensemble(inertia=np.array([tensor, mean]), omega=[[0.3, -1.2, 0.4], [0.1, 0.2, -0.3]])
    apart = tensor + np.array([[0, 2e-6 * 5.3, 0], [0, 0, 0], [0, 0, 0]])
    with pytest.raises(polhode.PolhodeError, match="symmetric"):
        polhode.MassProperties(mass=2.3, inertia=apart)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        polhode.MassProperties(mass=2.3, inertia=tensor.astype(np.float32))


def test_what_is_filled_shares_no_memory_with_the_times() -> None:
    motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
    both = np.empty(8 * 5)
    times, omega, attitude = both[:5], both[5:20].reshape(5, 3), both[20:].reshape(5, 4)
    times[:] = [0.0, 0.5, 1.0, 1.5, 2.0]
    states = motion.at(times, out=(omega, attitude))
    assert states == motion.at(times.tolist())
    overlapping = both[2:17].reshape(5, 3)
    for out in ((overlapping, np.empty((5, 4))), (np.empty((5, 3)), both[:20].reshape(5, 4))):
        with pytest.raises(ValueError, match="out shares memory with times"):
            motion.at(times, out=out)
    assert times.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]


def test_a_single_time_gives_a_single_state() -> None:
    omega, attitude = motion().at(0.5)
    assert omega.shape == (3,) and attitude.shape == (4,)
    assert np.array_equal(omega, motion().at([0.5]).omega[0])


def test_no_times_give_no_states() -> None:
    omega, attitude = motion().at([])
    assert omega.shape == (0, 3) and attitude.shape == (0, 4)


@pytest.mark.parametrize(
    ("changed", "says"),
    [
        ({"omega": [1.0, np.nan, 0.0]}, r"omega\[1\] = nan must be finite"),
        ({"omega": [1.0, 0.0, -np.inf]}, r"omega\[2\] = -inf must be finite"),
        ({"omega": [1.0, 2.0]}, r"omega must have the shape \(3,\), not \(2,\)"),
        ({"omega": [[1.0, 2.0, 3.0]]}, r"omega must have the shape \(3,\), not \(1, 3\)"),
        ({"omega": [1.0, 2.0, 2**53 + 1]}, r"omega\[2\] = 9007199254740993 must be a float64 exactly"),
        ({"omega": [1, 2, 2**53 + 1]}, r"omega\[2\] = 9007199254740993 must be a float64 exactly"),
        ({"omega": [[1.0], [2.0, 3.0]]}, "omega must have rows of one length"),
        ({"omega": np.ma.masked_equal([1.0, 2.0, 3.0], 2.0)}, "omega has masked elements"),
        ({"moments": [1.0, -2.0, 3.0]}, "-2"),
        ({"moments": [1.0, 1.0, 3.0]}, r"i1 \+ i2 = 2 kg·m² is less than i3 = 3"),
        ({"attitude": [0.0, 0.0, 0.0, 0.0]}, "attitude.* part of a quaternion that is not zero"),
        ({"attitude": [1.0, 0.0, 0.0]}, r"attitude must have the shape \(4,\), not \(3,\)"),
        ({"inertia": np.eye(3)}, "exactly one of moments and inertia"),
        ({"moments": None}, "exactly one of moments and inertia"),
        ({"moments": None, "inertia": [[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]]}, "symmetric"),
    ],
)
def test_values_are_refused_with_their_place(changed: dict[str, object], says: str) -> None:
    with pytest.raises(polhode.PolhodeError, match=says) as error:
        motion(**changed)
    assert isinstance(error.value, ValueError)


@pytest.mark.parametrize(
    ("value", "says"),
    [
        (["1", "2", "3"], "omega must be real numbers, not text"),
        (np.array([1.0, 2.0, 3.0j]), "omega must be real numbers, not complex numbers"),
        ([True, False, True], r"omega\[0\] = True must be a number, not a truth value"),
        (np.array([True, False, True]), "omega must be real numbers, not truth values"),
        ([1.0, None, 3.0], "NoneType among others"),
        ([1.0, {}, 3.0], "dict among others"),
        (np.array([1.0, 2.0, 3.0], dtype=np.longdouble), "more digits than float64"),
        (np.array(["2026-01-01"] * 3, dtype="M8[D]"), "datetime64"),
        (None, "NoneType"),
    ],
)
def test_types_are_refused(value: object, says: str) -> None:
    with pytest.raises(TypeError, match=says):
        motion(omega=value)


def test_numbers_with_a_unit_are_refused() -> None:
    class Quantity(np.ndarray):
        unit = "deg / s"

    with pytest.raises(TypeError, match="a unit that is neither"):
        motion(omega=np.array(OMEGA).view(Quantity))


def test_arguments_are_by_keyword() -> None:
    with pytest.raises(TypeError):
        polhode.FreeMotion(MOMENTS, OMEGA)  # type: ignore[call-arg, misc]
    with pytest.raises(TypeError):
        polhode.MassProperties(1.0, np.eye(3))  # type: ignore[call-arg, misc]


def test_times_are_refused_with_their_place() -> None:
    with pytest.raises(polhode.PolhodeError, match=r"times\[2\] = nan must be finite"):
        motion().at([0.0, 1.0, np.nan])
    with pytest.raises(polhode.PolhodeError, match=r"times must have the shape \(n,\)"):
        motion().at([[0.0, 1.0]])


def test_triangles_are_whole_numbers_that_are_there() -> None:
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for wrong, error, says in (
        ([[0, 2, 1], [0, 1, 4]], polhode.PolhodeError, r"triangles\[1, 2\] = 4 must be from 0 to 3"),
        ([[0, 2, -1]], polhode.PolhodeError, r"triangles\[0, 2\] = -1"),
        ([[0.0, 2.0, 1.0]], TypeError, "whole numbers, not float64"),
        ([0, 2, 1], polhode.PolhodeError, r"the shape \(m, 3\), not \(3,\)"),
    ):
        with pytest.raises(error, match=says):
            polhode.inertia((corners, wrong), density=1.0)
