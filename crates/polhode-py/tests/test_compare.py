"""Comparison of two robot models."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import polhode
import pytest


def test_one_robot_in_two_languages_is_equal_and_a_change_is_not(examples: Path, tmp_path: Path) -> None:
    arm = examples / "robots" / "arm.urdf"
    same = polhode.compare(arm, examples / "robots" / "arm.xml", tolerance=1e-5)
    assert same.equal and len(same) == 0 and "agree within 1e-5" in str(same)
    other = tmp_path / "arm.urdf"
    text = arm.read_text()
    other.write_text(text.replace('<mass value="1.2"/>', '<mass value="1.5"/>', 1))
    found = polhode.compare(arm, other)
    assert not found.equal and [difference.code for difference in found] == ["compare.mass"]
    assert found[0].numbers == {"a": 1.2, "b": 1.5}
    assert found[0].a and found[0].b and '"1.5"' in other.read_text().splitlines()[found[0].b["line"] - 1]
    assert found.to_dict()["differences"][0]["message"] == found.differences[0].message
    assert polhode.compare(arm, other, tolerance=0.3).equal
    for again in (copy.deepcopy(found), pickle.loads(pickle.dumps(found))):
        assert again == found and str(again) == str(found)
    assert found != same and "1 difference)" in repr(found)


def test_names_are_mapped_and_errors_are_raised(examples: Path, tmp_path: Path) -> None:
    arm = examples / "robots" / "arm.urdf"
    other = tmp_path / "other.urdf"
    other.write_text(arm.read_text().replace('"forearm"', '"lower"'))
    names = tmp_path / "names.toml"
    names.write_text('[links]\nforearm = "lower"\n')
    assert polhode.compare(arm, other, map=names).equal
    names.write_text('[links]\nforearm = "lowr"\n')
    with pytest.raises(polhode.PolhodeError, match="lowr"):
        polhode.compare(arm, other, map=names)
    with pytest.raises(FileNotFoundError):
        polhode.compare(arm, tmp_path / "none.urdf")
    with pytest.raises(polhode.PolhodeError, match="tolerance"):
        polhode.compare(arm, arm, tolerance=0.0)
    with pytest.raises(TypeError, match="roots must be a list of folders"):
        polhode.compare(arm, arm, roots="models")  # type: ignore[arg-type]
