"""What `polhode.jax` and `polhode.torch` share: partial derivatives by differences of the sixth order, at generic points."""

from __future__ import annotations

from typing import Any

import numpy as np
import polhode
import pytest
from polhode._differentiable import BODY, FREE_MOTION, MESH, PARTICLES, Function

INERTIA = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])
ATTITUDE = np.array([0.5, -0.1, 0.7, 0.3]) / np.sqrt(0.84)
OMEGA = np.array([0.7, -1.1, 0.4])
TIMES = np.array([0.0, 1.3, -2.0, 7.0])
MASSES = np.array([1.2, 0.7, 0.9, 1.1])
POSITIONS = np.array([[0.3, -0.1, 0.2], [-0.5, 0.4, 0.1], [0.2, 0.6, -0.7], [-0.1, -0.5, 0.4]])
VERTICES = np.array([[0.1, 0.0, 0.0], [3.0, 0.0, 0.2], [0.0, 2.0, 0.3], [0.0, 0.4, 1.0]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
TENSORS = np.array([INERTIA, 0.5 * INERTIA[::-1, ::-1], INERTIA + np.diag([0.3, 0.2, 0.4]), np.diag([1.0, 2.0, 2.5])])

#: The functions with arguments: three different moments with products, masses that are not 1, centres of mass off the origin, all signs.
POINTS: dict[str, tuple[Function, list[Any]]] = {
    "free_motion": (FREE_MOTION, [INERTIA, ATTITUDE, OMEGA, TIMES]),
    # A quaternion of another length is the same attitude.
    "long_quaternion": (FREE_MOTION, [INERTIA, 1.7 * ATTITUDE, OMEGA, TIMES]),
    "particles": (PARTICLES, [MASSES, POSITIONS]),
    "mesh": (MESH, [VERTICES, TRIANGLES, np.array(1.7)]),
    "body": (BODY, [MASSES, POSITIONS, TENSORS]),
}


def difference(function: Function, given: list[Any], by: str, step: float = 1e-3) -> np.ndarray:
    """The partial derivatives by an argument, by differences of the sixth order; of a tensor by both elements that are one number, half of it each."""
    place = list(function.arguments).index(by)
    shape = given[place].shape
    found = np.zeros(function.value(*given).shape + shape)
    for index in np.ndindex(shape):
        for weight, times in ((3 / 4, 1), (-3 / 20, 2), (1 / 60, 3)):
            for sign in (1, -1):
                moved = given[place].copy()
                if by in ("inertia", "inertias"):
                    moved[index] += 0.5 * sign * times * step
                    moved[(*index[:-2], index[-1], index[-2])] += 0.5 * sign * times * step
                else:
                    moved[index] += sign * times * step
                value = function.value(*given[:place], moved, *given[place + 1 :])
                found[(..., *index)] += sign * weight * value / step
    return found


@pytest.mark.parametrize("name", POINTS)
def test_partial_derivatives_are_differences(name: str) -> None:
    function, given = POINTS[name]
    value, *partials = function.with_partials(tuple(function.partials), *given)
    assert np.array_equal(value, function.value(*given))
    for by, partial in zip(function.partials, partials):
        expected = difference(function, given, by)
        if by == "times":
            # Each row depends on its own time alone.
            assert np.abs(expected - np.einsum("nom,nm->nom", expected, np.eye(len(TIMES)))).max() < 1e-15
            expected = np.einsum("non->no", expected)
        assert partial.shape == expected.shape
        assert np.abs(partial - expected).max() < 1e-10 * max(1.0, np.abs(expected).max()), by
        assert np.abs(partial).max() > 0.1


def test_a_batch_is_each_of_it() -> None:
    spins = np.array([OMEGA, -2.0 * OMEGA, OMEGA[::-1]])[:, None, :]
    times = np.array([TIMES, TIMES + 1.0])
    value, by_omega = FREE_MOTION.with_partials(("omega",), INERTIA, ATTITUDE, spins, times)
    assert value.shape == (3, 2, 4, 7) and by_omega.shape == (3, 2, 4, 7, 3)
    one = FREE_MOTION.with_partials(("omega",), INERTIA, ATTITUDE, spins[2, 0], times[1])
    assert np.array_equal(value[2, 1], one[0]) and np.array_equal(by_omega[2, 1], one[1])
    assert FREE_MOTION.value(INERTIA, ATTITUDE, np.empty((0, 3)), TIMES).shape == (0, 4, 7)


def test_what_is_refused_says_where() -> None:
    wrong = np.array([OMEGA, [1.0, np.nan, 0.0]])
    for call, says in (
        (lambda: FREE_MOTION.value(INERTIA, ATTITUDE, wrong, TIMES), r"^of the batch, \[1\]: omega\[1\] = nan must be finite"),
        (lambda: FREE_MOTION.value(INERTIA[0], ATTITUDE, OMEGA, TIMES), r"^inertia must have the shape \(…, 3, 3\), not \(3,\)"),
        (lambda: FREE_MOTION.value(INERTIA, np.eye(3), OMEGA, TIMES), r"^attitude must have the shape \(…, 4\), not \(3, 3\)"),
        (lambda: FREE_MOTION.value(INERTIA, 0.0 * ATTITUDE, OMEGA, TIMES), r"^attitude\[0\] = 0.0 must be part of a quaternion that is not zero"),
        (lambda: FREE_MOTION.value(INERTIA + np.tri(3), ATTITUDE, OMEGA, TIMES), "not symmetric"),
        (lambda: FREE_MOTION.value(INERTIA, ATTITUDE, np.ones((2, 3)), np.ones((3, 4))), r"omega has \(2,\), times has \(3,\): leading axes must be"),
        (lambda: PARTICLES.value(MASSES[:3], POSITIONS), r"^positions must have the shape \(…, 3, 3\), not \(4, 3\)"),
        (lambda: PARTICLES.value(-MASSES, POSITIONS), r"^masses\[0\] = -1.2 must be positive"),
        (lambda: MESH.value(VERTICES, TRIANGLES, np.array(0.0)), "^density = 0.0 must be positive"),
        (lambda: MESH.value(VERTICES, TRIANGLES[:3], np.array(1.0)), "open"),
        (lambda: BODY.value(MASSES, POSITIONS, -TENSORS), "^part 0: "),
        (lambda: BODY.value(MASSES[:0], POSITIONS[:0], TENSORS[:0]), "^masses is empty"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            call()
