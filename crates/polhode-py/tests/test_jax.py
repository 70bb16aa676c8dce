"""Functions of JAX arrays: their derivatives forward and in reverse, compiled and mapped, and what they refuse."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pint
import polhode
import polhode.jax
import pytest
from test_differentiable import ATTITUDE, INERTIA, MASSES, OMEGA, POINTS, POSITIONS, TIMES, TRIANGLES, VERTICES

FUNCTIONS = {"free_motion": polhode.jax.free_motion, "particles": polhode.jax.particles, "mesh": polhode.jax.mesh, "body": polhode.jax.body}


@pytest.fixture(autouse=True)
def float64() -> Iterator[None]:
    with jax.enable_x64(True):
        yield


def flat(found: Any) -> Any:
    """All that a function gives as one array; of a tensor the six numbers."""
    if isinstance(found, polhode.jax.Motion):
        return jnp.concatenate([found.attitude, found.omega], -1)
    rows, columns = np.array([[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]])
    return jnp.concatenate([found.mass[None], found.center_of_mass, found.inertia[rows, columns]])


@pytest.mark.parametrize("name", FUNCTIONS)
def test_derivatives_are_the_partial_derivatives(name: str) -> None:
    """Forward and in reverse, compiled or not: of the same bits, but for the order of sums."""
    function, given = POINTS[name]
    places = tuple(k for k, argument in enumerate(function.arguments) if argument in function.partials)
    whole = lambda *arguments: flat(FUNCTIONS[name](*arguments))  # noqa: E731
    value, *partials = function.with_partials(tuple(function.partials), *given)
    assert np.array_equal(whole(*given), value) and np.array_equal(jax.jit(whole)(*given), value)
    found = [way(whole, argnums=places)(*map(jnp.asarray, given)) for way in (jax.jacfwd, jax.jacrev)]
    found += [jax.jit(way(whole, argnums=places))(*given) for way in (jax.jacfwd, jax.jacrev)]
    for k, (by, partial) in enumerate(zip(function.partials, partials)):
        expected = np.einsum("no,nm->nom", partial, np.eye(len(TIMES))) if by == "times" else partial
        for jacobians in found:
            assert jacobians[k].dtype == jnp.float64
            assert np.abs(jacobians[k] - expected).max() < 1e-14 * np.abs(expected).max(), by


def test_values_are_those_of_the_classes() -> None:
    motion = polhode.FreeMotion(inertia=INERTIA, attitude=ATTITUDE, omega=OMEGA)
    found = polhode.jax.free_motion(INERTIA, ATTITUDE, OMEGA, TIMES)
    assert np.array_equal(found.omega, motion.at(TIMES).omega) and np.array_equal(found.attitude, motion.at(TIMES).attitude)
    single = polhode.jax.free_motion(INERTIA, ATTITUDE, OMEGA, 7.0)
    assert single.omega.shape == (3,) and np.array_equal(single.attitude, motion.at(7.0).attitude)
    body = polhode.particles(masses=MASSES, positions=POSITIONS)
    numbers = polhode.jax.particles(MASSES, POSITIONS)
    assert numbers.mass == body.mass and np.array_equal(numbers.center_of_mass, body.center_of_mass) and np.array_equal(numbers.inertia, body.inertia)


def test_quantities_are_converted() -> None:
    units = pint.UnitRegistry()
    body, spin = INERTIA * 1e4 * units.kilogram * units.centimeter**2, np.rad2deg(OMEGA) * units.degree / units.second
    for times in (TIMES / 60.0 * units.minute, 7.0 / 60.0 * units.minute):
        found = polhode.jax.free_motion(body, ATTITUDE, spin, times)
        expected = polhode.jax.free_motion(INERTIA, ATTITUDE, OMEGA, times.to("s").magnitude)
        assert np.abs(found.omega - expected.omega).max() < 1e-13
    with pytest.raises(polhode.PolhodeError, match="omega is in degree, rad in SI, where an angular velocity belongs"):
        polhode.jax.free_motion(INERTIA, ATTITUDE, np.rad2deg(OMEGA) * units.degree, TIMES)


def test_a_chain_from_vertices_to_a_motion() -> None:
    """The gradient of what a motion does by the vertices of the body, against differences of the whole chain."""

    def turned(vertices: Any) -> Any:
        body = polhode.jax.mesh(vertices, TRIANGLES, 1.7)
        return jnp.sum(polhode.jax.free_motion(body.inertia, ATTITUDE, OMEGA, TIMES).attitude[-1] * jnp.array([0.3, -0.7, 1.1, 0.2]))

    gradient = jax.jit(jax.grad(turned))(VERTICES)
    step, moved = 1e-4, np.random.default_rng(2).normal(size=VERTICES.shape)
    slope = sum(w * sign * turned(VERTICES + sign * n * step * moved) for w, n in ((3 / 4, 1), (-3 / 20, 2), (1 / 60, 3)) for sign in (1, -1)) / step
    assert abs(jnp.sum(gradient * moved) - slope) < 1e-9 * abs(slope) and abs(slope) > 0.1


def test_quaternions_turn_and_do_not_stretch() -> None:
    """q · q̇ = 0, and a gradient by the start has no part along it."""
    along = jnp.array([0.3, -0.2, 0.5])
    motion, change = jax.jvp(lambda omega: polhode.jax.free_motion(INERTIA, ATTITUDE, omega, TIMES), (jnp.asarray(OMEGA),), (along,))
    assert np.abs(jnp.sum(motion.attitude * change.attitude, -1)).max() < 1e-14 and np.abs(change.attitude[1:]).max() > 0.1
    gradient = jax.grad(lambda attitude: polhode.jax.free_motion(INERTIA, attitude, OMEGA, TIMES).attitude[2, 1])(jnp.asarray(1.7 * ATTITUDE))
    assert abs(gradient @ ATTITUDE) < 1e-14 and np.abs(gradient).max() > 0.1
    tensor = jax.grad(lambda inertia: polhode.jax.free_motion(inertia, ATTITUDE, OMEGA, TIMES).omega[3, 0])(jnp.asarray(INERTIA))
    assert np.array_equal(tensor, tensor.T) and abs(tensor[0, 1]) > 0.01


def test_maps_are_batches() -> None:
    spins = jnp.array([OMEGA, -2.0 * OMEGA, OMEGA[::-1]])
    tensors = jnp.array([INERTIA, 2.0 * INERTIA])
    one = lambda inertia, omega: flat(polhode.jax.free_motion(inertia, ATTITUDE, omega, TIMES))  # noqa: E731
    mapped = jax.vmap(jax.vmap(one, (None, 0)), (0, None))
    expected = np.array([[one(inertia, omega) for omega in spins] for inertia in tensors])
    assert np.array_equal(mapped(tensors, spins), expected) and np.array_equal(jax.jit(mapped)(tensors, spins), expected)
    # What is mapped over has a batch of its own already.
    assert np.array_equal(jax.vmap(one, (0, None))(tensors, spins), expected)
    slopes = jax.vmap(jax.jacrev(one, argnums=1), (None, 0))(tensors[0], spins)
    assert np.array_equal(slopes[2], jax.jacrev(one, argnums=1)(tensors[0], spins[2]))
    tips = jax.vmap(lambda triangles: polhode.jax.mesh(VERTICES, triangles, 1.0).mass)(jnp.array([TRIANGLES, TRIANGLES[::-1]]))
    assert np.abs(tips - tips[0]).max() < 1e-15


SECOND: list[Callable[..., Any]] = [
    jax.hessian,
    lambda function: jax.jit(jax.hessian(function)),
    lambda function: jax.jacrev(jax.jacrev(function)),
    lambda function: jax.jacfwd(jax.jacfwd(function)),
    lambda function: jax.grad(lambda x: jnp.sum(jax.vjp(function, x)[1](1.0)[0])),
    lambda function: jax.grad(lambda x: jax.jvp(function, (x,), (jnp.ones_like(x),))[1]),
    lambda function: lambda x: jax.vmap(jax.hessian(function))(x[None]),
    lambda function: jax.jacfwd(jax.grad(jax.checkpoint(function))),
]


@pytest.mark.parametrize("second", SECOND)
def test_second_derivatives_are_refused_and_never_zero(second: Callable[..., Any]) -> None:
    for function, x in (
        (lambda omega: jnp.sum(polhode.jax.free_motion(INERTIA, ATTITUDE, omega, TIMES).omega), jnp.asarray(OMEGA)),
        (lambda positions: polhode.jax.particles(MASSES, positions).inertia[0, 1], jnp.asarray(POSITIONS)),
        # By one argument after another: partial derivatives by the masses depend on the positions.
        (lambda both: jnp.sum(polhode.jax.particles(both[:, 0], both[:, 1:]).inertia), jnp.column_stack([MASSES, POSITIONS])),
    ):
        with pytest.raises(polhode.PolhodeError, match="has only first derivatives"):
            second(function)(x)


def test_what_is_refused() -> None:
    bad = jnp.asarray(OMEGA) * jnp.nan
    whole = lambda omega: jnp.sum(polhode.jax.free_motion(INERTIA, ATTITUDE, omega, TIMES).omega)  # noqa: E731
    for call in (whole, jax.grad(whole)):
        with pytest.raises(polhode.PolhodeError, match=r"omega\[0\] = nan must be finite"):
            call(bad)
    with pytest.raises(jax.errors.JaxRuntimeError, match=r"PolhodeError: omega\[0\] = nan must be finite"):
        jax.block_until_ready(jax.jit(whole)(bad))
    with pytest.raises(TypeError, match="times must be real numbers, not complex128"):
        polhode.jax.free_motion(INERTIA, ATTITUDE, OMEGA, jnp.asarray(TIMES) * 1j)
    with pytest.raises(TypeError, match="masses must be real numbers, not truth values"):
        polhode.jax.particles(MASSES > 0.0, POSITIONS)
    with jax.enable_x64(False), pytest.raises(polhode.PolhodeError, match="free_motion needs float64, but JAX uses float32"):
        polhode.jax.free_motion(INERTIA, ATTITUDE, OMEGA, TIMES)
    small = polhode.jax.particles(jnp.asarray(MASSES, jnp.float32), POSITIONS)
    assert small.mass.dtype == jnp.float64
    gradient = jax.grad(lambda masses: polhode.jax.particles(masses, POSITIONS).mass)(jnp.asarray(MASSES, jnp.float32))
    assert gradient.dtype == jnp.float32 and np.array_equal(gradient, np.ones(4))


def test_polhode_does_not_import_jax() -> None:
    said = "import sys, polhode; assert 'jax' not in sys.modules and 'torch' not in sys.modules and 'pint' not in sys.modules"
    subprocess.run([sys.executable, "-c", said], check=True)
