"""Attitudes that functions of the state receive."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._arrays import Floats
from ._error import PolhodeError

#: Largest sine of half an angle, or angle from a degenerate attitude, that is taken as zero.
_HALF, _DEGENERATE = 1e-8, 1e-7


class Turned:
    """Attitude of one body, or rows of attitudes of many.

    It takes body components to space components.
    """

    def __init__(self, quaternion: Any) -> None:
        self._quaternion = quaternion

    @property
    def _is_many(self) -> bool:
        return bool(self._quaternion.ndim > 1)

    def _parts(self) -> Any:
        """Returns w, x, y and z. Plain numbers are faster than arrays for one body."""
        return np.moveaxis(self._quaternion, -1, 0) if self._is_many else self._quaternion.tolist()

    def _joined(self, *parts: Any) -> Any:
        """Returns an array whose last axis has these parts."""
        return np.stack(parts, axis=-1) if self._is_many else np.array(parts)

    def as_quat(self, *, scalar_first: bool = False) -> Floats:
        """Returns the quaternion (…, 4): x, y, z, w as in SciPy, or w first."""
        return self._quaternion.copy() if scalar_first else np.roll(self._quaternion, -1, axis=-1)

    def as_matrix(self) -> Any:
        """Returns the rotation matrix R_space_body (…, 3, 3)."""
        w, x, y, z = self._parts()
        # R = (w² − q²) 1 + 2 q qᵀ + 2 w [q]×
        rows = (
            (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        )
        return np.stack([self._joined(*row) for row in rows], axis=-2) if self._is_many else np.array(rows)

    def apply(self, vector: npt.ArrayLike, inverse: bool = False) -> Any:
        """Returns the space components of a vector (3,) in body components, or of one for each body
        (n, 3); with ``inverse``, the reverse."""
        matrix = self.as_matrix()
        if inverse:
            matrix = matrix.swapaxes(-1, -2)
        if not self._is_many:
            return matrix @ np.asarray(vector)
        given = np.asarray(vector)
        if given.shape not in ((3,), (len(matrix), 3)):
            raise PolhodeError(f"a vector must have the shape (3,), or ({len(matrix)}, 3) with a row for each member, not {given.shape}")
        return (matrix @ given[..., None])[..., 0]

    def inv(self) -> Turned:
        """Returns the inverse rotation, which takes space components to body components."""
        return Turned(self._conjugate())

    def _conjugate(self) -> Any:
        w, x, y, z = self._parts()
        return self._joined(w, -x, -y, -z)

    def as_rotvec(self, degrees: bool = False) -> Any:
        """Returns the rotation vector (…, 3): axis times angle, at most π, in rad or degrees."""
        w, x, y, z = self._parts()
        sine = np.sqrt(x * x + y * y + z * z)
        sign = np.where(w < 0, -1.0, 1.0)
        is_small = sine < _HALF
        scale = sign * np.where(is_small, 2.0, 2.0 * np.arctan2(sine, sign * w) / np.where(is_small, 1.0, sine))
        found = self._joined(scale * x, scale * y, scale * z)
        return np.degrees(found) if degrees else found

    def as_euler(self, seq: str, degrees: bool = False) -> Any:
        """Returns the Euler angles (…, 3), in rad or degrees, from −π to π.

        ``seq`` has the axes, such as ``"ZXZ"`` about the axes of the body or ``"xyz"`` about the
        axes of space. Where two axes coincide, the third angle is zero.
        """
        # Bernardes, Viollet, PLoS ONE 17 (2022) e0276302
        i, j, k = _axes(seq)
        is_intrinsic = seq.isupper()
        if is_intrinsic:
            i, k = k, i
        is_symmetric = i == k
        if is_symmetric:
            k = 3 - i - j
        sign = float((i - j) * (j - k) * (k - i) // 2)
        w, *vector = self._parts()
        a, b, c, d = w, vector[i], vector[j], sign * vector[k]
        if not is_symmetric:
            a, b, c, d = w - vector[j], vector[i] + sign * vector[k], vector[j] + w, sign * vector[k] - vector[i]
        middle = 2.0 * np.arctan2(np.hypot(c, d), np.hypot(a, b))
        half_sum, half_difference = np.arctan2(b, a), np.arctan2(d, c)
        is_zero, is_half_turn = middle <= _DEGENERATE, middle >= np.pi - _DEGENERATE
        free = 2.0 * np.where(is_zero, half_sum, half_difference if is_intrinsic else -half_difference)
        is_degenerate = is_zero | is_half_turn
        first, third = half_sum - half_difference, half_sum + half_difference
        if is_intrinsic:
            first, third = third, first
        first, third = np.where(is_degenerate, free, first), np.where(is_degenerate, 0.0, third)
        if not is_symmetric:
            middle = middle - np.pi / 2
            if is_intrinsic:
                first = sign * first
            else:
                third = sign * third
        found = self._joined(_wrapped(first), middle, _wrapped(third))
        return np.degrees(found) if degrees else found


def _axes(seq: str) -> list[int]:
    """Returns the indices of the axes of Euler angles."""
    if not isinstance(seq, str) or len(seq) != 3 or not (set(seq) <= set("xyz") or set(seq) <= set("XYZ")) or seq[0] == seq[1] or seq[1] == seq[2]:
        raise PolhodeError(f"seq = {seq!r} must be three axes, such as 'ZXZ' about the axes of the body or 'xyz' about those of space; adjacent axes must differ")
    return ["xyz".index(axis) for axis in seq.lower()]


def _wrapped(angle: Any) -> Any:
    """Returns an angle between −2 π and 2 π reduced to −π … π."""
    return np.where(angle > np.pi, angle - 2 * np.pi, np.where(angle < -np.pi, angle + 2 * np.pi, angle))
