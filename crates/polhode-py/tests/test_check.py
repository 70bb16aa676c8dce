"""Robot models."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polhode
import pytest


def test_a_good_arm_is_ok_and_a_bad_one_is_not(examples: Path) -> None:
    good, bad = (polhode.check(examples / "robots" / name) for name in ("arm.urdf", "bad-arm.urdf"))
    assert good.ok and not bad.ok
    assert len(bad) == len(bad.findings) > 0
    text = (examples / "robots" / "bad-arm.urdf").read_text().splitlines()
    triangle = next(finding for finding in bad if finding.code == "inertia.triangle")
    assert triangle.severity == "impossible" and "inertia" in text[triangle.line - 1]
    assert triangle.numbers and all(isinstance(value, float) for value in triangle.numbers.values())
    assert bad.to_dict()["counts"]["impossible"] >= 1
    assert "forearm" in str(bad) and "forearm" in bad.table()


def test_what_is_no_model_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text("<robot>")
    with pytest.raises(polhode.PolhodeError):
        polhode.check(path)
    with pytest.raises(FileNotFoundError):
        polhode.check(tmp_path / "none.urdf")


def test_the_nearest_tensors_are_proposed_if_requested(examples: Path) -> None:
    path = examples / "robots" / "bad-arm.urdf"
    plain, proposed = polhode.check(path), polhode.check(path, nearest=True)
    assert all(finding.nearest is None for finding in plain) and "nearest" not in str(plain)
    broken = [finding.nearest for finding in proposed if finding.code == "inertia.triangle"]
    assert broken and "nearest possible tensor, Frobenius" in str(proposed)
    for near in broken:
        assert near is not None
        for metric in ("frobenius", "affine_invariant"):
            xx, yy, zz, xy, xz, yz = (near[metric][name] for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"))
            polhode.MassProperties(mass=1, inertia=[[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def test_nearest_tensors_of_a_tensor_about_another_point() -> None:
    centre, mass, offset = np.array([[0.7, 0.1, -0.2], [0.1, 1.1, 0.05], [-0.2, 0.05, 2.6]]), 1.7, np.array([0.3, -0.4, 0.5])
    about = centre + mass * (offset @ offset * np.eye(3) - np.outer(offset, offset))
    direct = polhode.nearest_possible(centre)
    moved = polhode.nearest_possible(about, about=[0.0, 0.1, 0.2], mass=mass, center_of_mass=offset + [0.0, 0.1, 0.2])
    assert direct.affine_invariant is not None and moved.affine_invariant is not None
    np.testing.assert_allclose(moved.frobenius.inertia, direct.frobenius.inertia, rtol=0, atol=1e-14)
    assert abs(np.linalg.norm(direct.frobenius.inertia - centre) - direct.frobenius.distance) < 1e-14
    assert abs(moved.affine_invariant.distance - direct.affine_invariant.distance) < 1e-13
    assert polhode.nearest_possible([-0.1, 1.0, 1.0]).affine_invariant is None
    with pytest.raises(TypeError, match="mass is required with about"):
        polhode.nearest_possible(about, about=[0, 0, 0])
    with pytest.raises(polhode.PolhodeError, match="symmetric"):
        polhode.nearest_possible([[1, 0.2, 0], [0, 1, 0], [0, 0, 3]])
