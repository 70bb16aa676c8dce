"""Functions of PyTorch tensors: their derivatives, batches, and what they refuse.

No part of the gate, as PyTorch is large: `pip install torch`, and `pytest tests/test_torch.py`.
"""

from __future__ import annotations

import doctest
from collections.abc import Callable
from typing import Any

import numpy as np
import polhode
import pytest
from conftest import ROOT
from test_differentiable import ATTITUDE, INERTIA, MASSES, OMEGA, POINTS, POSITIONS, TIMES, TRIANGLES, VERTICES

torch = pytest.importorskip("torch", reason="the gate does not install PyTorch (0.5 GB)")
from polhode import torch as polhode_torch  # noqa: E402

#: PyTorch warns of what it does itself when it is first asked for a batch.
pytestmark = pytest.mark.filterwarnings("ignore:.*torch.jit.script.*:DeprecationWarning", "ignore:.*torch.jit.script.*:FutureWarning")

FUNCTIONS = {"free_motion": polhode_torch.free_motion, "particles": polhode_torch.particles, "mesh": polhode_torch.mesh, "body": polhode_torch.body}


def test_its_examples() -> None:
    """Those of the module, and that of the book."""
    assert doctest.testmod(polhode_torch).failed == 0
    page = (ROOT / "book" / "differentiable.md").read_text()
    (block,) = (block for block in page.split("```") if block.startswith("python\nimport torch"))
    names: dict[str, Any] = {}
    exec(block.removeprefix("python"), names)
    assert np.abs(names["omega"].detach().numpy() - [0.72, -1.05, 0.38]).max() < 1e-7


def leaf(value: Any) -> Any:
    return torch.tensor(value, dtype=torch.float64, requires_grad=True)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_gradcheck(name: str) -> None:
    """Backward and forward, against differences of PyTorch's own."""
    function, given = POINTS[name]
    leaves = [leaf(value) for value in given if np.asarray(value).dtype.kind == "f"]

    def whole(*moved: Any) -> tuple[Any, ...]:
        # Differences move one element of a tensor: its symmetric part is what counts.
        moved = tuple(0.5 * (one + one.mT) if one.shape[-2:] == (3, 3) and one.shape != (3,) and name != "mesh" else one for one in moved)
        return tuple(FUNCTIONS[name](*((moved[0], TRIANGLES, moved[1]) if name == "mesh" else moved)))

    assert torch.autograd.gradcheck(whole, leaves, rtol=1e-7, atol=1e-8, check_forward_ad=True)
    whole(*leaves)[1].sum().backward()
    _, *partials = function.with_partials(tuple(function.partials), *given)
    if name != "free_motion":
        for one, by, partial in zip(leaves, function.partials, partials):
            assert np.abs(one.grad.numpy() - partial[1:4].sum(axis=0)).max() < 1e-14 * max(1.0, np.abs(partial).max()), by


def test_values_and_batches() -> None:
    motion = polhode.FreeMotion(inertia=INERTIA, attitude=ATTITUDE, omega=OMEGA)
    found = polhode_torch.free_motion(INERTIA, ATTITUDE, OMEGA, TIMES)
    assert np.array_equal(found.omega, motion.at(TIMES).omega) and np.array_equal(found.attitude, motion.at(TIMES).attitude)
    assert polhode_torch.free_motion(INERTIA, ATTITUDE, OMEGA, 7.0).attitude.shape == (4,)
    spins = leaf(np.array([OMEGA, -2.0 * OMEGA, OMEGA[::-1]]))
    batch = polhode_torch.free_motion(INERTIA, ATTITUDE, spins, TIMES).omega
    assert batch.shape == (3, 4, 3) and np.array_equal(batch[0].detach(), found.omega)
    one = lambda omega: polhode_torch.free_motion(INERTIA, ATTITUDE, omega, TIMES).omega  # noqa: E731
    assert torch.equal(torch.func.vmap(one)(spins), batch)
    jacobians = torch.func.vmap(torch.func.jacrev(one))(spins)
    forward = torch.func.vmap(torch.func.jacfwd(one))(spins)
    (rows,) = torch.autograd.grad(batch[:, 3, 1].sum(), spins)
    assert torch.allclose(jacobians[:, 3, 1], rows, rtol=0, atol=1e-14) and torch.allclose(forward, jacobians, rtol=0, atol=1e-14)


def test_fewer_bits_are_converted() -> None:
    omega = torch.tensor(OMEGA, dtype=torch.float32, requires_grad=True)
    found = polhode_torch.free_motion(INERTIA, ATTITUDE, omega, TIMES)
    assert found.omega.dtype == torch.float64
    found.omega.sum().backward()
    assert omega.grad.dtype == torch.float32


SECOND: list[Callable[[Any, Any], Any]] = [
    lambda function, x: torch.autograd.functional.hessian(function, x),
    lambda function, x: torch.func.hessian(function)(x),
    lambda function, x: torch.func.jacrev(torch.func.jacrev(function))(x),
    lambda function, x: torch.func.jacfwd(torch.func.jacfwd(function))(x),
    lambda function, x: torch.autograd.grad(torch.autograd.grad(function(x), x, create_graph=True)[0].sum(), x),
    lambda function, x: torch.autograd.functional.hvp(function, x, torch.ones_like(x)),
]


@pytest.mark.parametrize("second", SECOND)
def test_second_derivatives_are_refused_and_never_zero(second: Callable[[Any, Any], Any]) -> None:
    for function, x in (
        (lambda omega: polhode_torch.free_motion(INERTIA, ATTITUDE, omega, TIMES).omega.sum(), leaf(OMEGA)),
        (lambda positions: polhode_torch.particles(MASSES, positions).inertia[0, 1] ** 2, leaf(POSITIONS)),
    ):
        with pytest.raises(polhode.PolhodeError, match="has only first derivatives"):
            second(function, x)


def test_what_is_refused() -> None:
    with pytest.raises(polhode.PolhodeError, match=r"omega\[0\] = nan must be finite"):
        polhode_torch.free_motion(INERTIA, ATTITUDE, torch.tensor(OMEGA) * torch.nan, TIMES)
    with pytest.raises(TypeError, match="times must be real numbers, not torch.complex128"):
        polhode_torch.free_motion(INERTIA, ATTITUDE, OMEGA, torch.tensor(TIMES) * 1j)
    with pytest.raises(TypeError, match="masses must be real numbers, not torch.bool"):
        polhode_torch.particles(torch.tensor(MASSES) > 0.0, POSITIONS)
    with pytest.raises(polhode.PolhodeError, match=r"triangles must have the shape \(…, m, 3\), not \(12,\)"):
        polhode_torch.mesh(VERTICES, TRIANGLES.ravel(), 1.0)
    # What backward needs must be as it was.
    omega, more = leaf(OMEGA), torch.zeros(3, dtype=torch.float64)
    moved = omega + more
    total = polhode_torch.free_motion(INERTIA, ATTITUDE, moved, TIMES).omega.sum()
    with torch.no_grad():
        moved.mul_(2.0)
    with pytest.raises(RuntimeError, match="modified by an inplace operation"):
        total.backward()
