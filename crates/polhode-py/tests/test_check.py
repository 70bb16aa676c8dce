"""Robot models."""

from __future__ import annotations

from pathlib import Path

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
