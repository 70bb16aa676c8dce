"""Possible tensors nearest to an impossible one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._arrays import Floats
from ._public import public
from ._units import Quantity


@public("polhode.results")
class NearestTensor(NamedTuple):
    """A possible tensor at a distance from a given one."""

    #: Tensor about the centre of mass (3, 3), kg·m².
    inertia: Floats
    #: Distance from the given tensor: kg·m² in the Frobenius norm, without a unit in the
    #: affine-invariant metric.
    distance: float


@public("polhode.results")
class NearestPossible(NamedTuple):
    """Possible tensors nearest to a given one, in two metrics."""

    #: Nearest tensor in the Frobenius norm.
    frobenius: NearestTensor
    #: Nearest tensor in the affine-invariant metric; the log-Euclidean distance is the same. ``None``
    #: if a principal moment is not positive, because every possible tensor is then infinitely far.
    affine_invariant: NearestTensor | None


def nearest_possible(
    inertia: npt.ArrayLike,
    *,
    about: npt.ArrayLike | None = None,
    mass: Quantity | None = None,
    center_of_mass: npt.ArrayLike = (0.0, 0.0, 0.0),
) -> NearestPossible:
    """Returns the possible inertia tensors nearest to a tensor that no body can have.

    The nearest tensors have the principal axes of the given one, and are those of a flat body, in the
    extreme of a rod. They do not correct an error: a measured or computed tensor is better. A possible
    tensor is its own nearest.

    Parameters
    ----------
    inertia
        Tensor (3, 3), or three moments, kg·m², about the centre of mass or about the point ``about``.
        Off-diagonal elements are *minus* the integrals, I_xy = -∫xy dm.
    about
        Reference point of the tensor (3,), m. It is moved to the centre of mass first. The default is
        the centre of mass.
    mass
        Mass, kg. It is only used with ``about``, and is then required.
    center_of_mass
        Centre of mass (3,), m. It is only used with ``about``.

    Returns
    -------
    NearestPossible
        Tensors about the centre of mass, with their distances.

    Raises
    ------
    PolhodeError
        If the tensor is not symmetric or not finite.

    Examples
    --------
    >>> import polhode
    >>> nearest = polhode.nearest_possible([1.0, 1.0, 2.3])
    >>> nearest.frobenius.inertia.diagonal().round(3)
    array([1.1, 1.1, 2.2])
    >>> round(nearest.affine_invariant.distance, 4)
    0.1141
    """
    tensor = np.asarray(_arrays.tensor("inertia", inertia))
    if about is not None:
        if mass is None:
            raise TypeError("mass is required with about: the tensor is moved to the centre of mass")
        offset = np.subtract(
            _arrays.triple("center_of_mass", center_of_mass), _arrays.triple("about", about)
        )
        steiner = float(offset @ offset) * np.eye(3) - np.outer(offset, offset)
        tensor = tensor - _arrays.positive("mass", mass) * steiner
    frobenius, affine_invariant = _native.nearest_tensors(tensor.tolist())
    return NearestPossible(_near(frobenius), None if affine_invariant is None else _near(affine_invariant))


def _near(near: tuple[list[list[float]], float]) -> NearestTensor:
    tensor, distance = near
    return NearestTensor(np.asarray(tensor), distance)
