"""Bodies of what is no path: meshes of other libraries, triangles by their corners, open files."""

from __future__ import annotations

import io
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import polhode
import pytest
from conftest import ROOT

VERTICES = np.array([[0.1, -0.2, 0.3], [31.4, 0.2, -0.1], [0.3, 21.7, 0.2], [-0.2, 0.4, 11.9]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
BRACKET = ROOT / "examples" / "bracket.stl"


def tensors_agree(one: polhode.MassProperties, other: polhode.MassProperties) -> bool:
    return bool(np.allclose(one.inertia, other.inertia, rtol=1e-13) and np.isclose(one.mass, other.mass, rtol=1e-14))


def test_a_mesh_may_be_given_in_many_ways() -> None:
    wanted = polhode.inertia((VERTICES, TRIANGLES), unit="mm", density=2700.0)
    corners = VERTICES[TRIANGLES]
    for source in (
        [VERTICES, TRIANGLES],
        [VERTICES.tolist(), TRIANGLES.tolist()],
        SimpleNamespace(vertices=VERTICES, faces=TRIANGLES),
        SimpleNamespace(vertices=VERTICES, triangles=TRIANGLES, units=None),
        corners,
        corners.tolist(),
        corners[::-1],
    ):
        assert tensors_agree(polhode.inertia(source, unit="mm", density=2700.0), wanted)
    said = SimpleNamespace(vertices=VERTICES, faces=TRIANGLES, units="mm")
    assert tensors_agree(polhode.inertia(said, density=2700.0), wanted)
    assert polhode.inertia(said, unit="m", density=2.7e-6).mass == pytest.approx(wanted.mass)


def test_a_mesh_of_trimesh() -> None:
    import trimesh

    mesh = trimesh.load(BRACKET)
    wanted = polhode.inertia(BRACKET, unit="mm", density=1.0)
    assert tensors_agree(polhode.inertia(mesh, unit="mm", density=1.0), wanted)
    mesh.units = "mm"
    assert tensors_agree(polhode.inertia(mesh, density=1.0), wanted)
    assert tensors_agree(polhode.inertia(mesh.triangles, unit="mm", density=1.0), wanted)
    with pytest.raises(TypeError, match=r"not Scene: give its whole mesh, scene.to_mesh\(\)"):
        polhode.inertia(trimesh.Scene([mesh]), density=1.0)


def test_corners_that_are_apart_leave_holes() -> None:
    corners = VERTICES[TRIANGLES].copy()
    corners[0, 0, 2] += 1e-9
    with pytest.raises(polhode.PolhodeError, match="open|hole|edge"):
        polhode.inertia(corners, unit="mm", density=1.0)
    signed = VERTICES[TRIANGLES] - VERTICES[0]
    signed[1][signed[1] == 0.0] = -0.0
    assert polhode.inertia(signed, unit="mm", density=1.0).mass > 0.0


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("bracket.stl", {"unit": "mm", "mass": 0.4}),
        ("water.xyz", {}),
        ("t-handle.toml", {}),
        ("robots/arm.urdf", {"link": "forearm"}),
    ],
)
def test_an_open_file_is_its_file(name: str, options: dict[str, Any]) -> None:
    path = ROOT / "examples" / name
    if name.endswith("urdf"):
        options = {"link": polhode.link_table(path)[0].link}
    wanted = polhode.inertia(path, **options)
    with path.open("rb") as file:
        assert polhode.inertia(file, **options) == wanted
    nameless = polhode.inertia(io.BytesIO(path.read_bytes()), format=path.suffix, **options)
    assert nameless == wanted
    said = str(nameless) + str(nameless.to_dict()) + str(nameless.findings)
    assert "/tmp" not in said and str(path) not in said
    if not name.endswith("stl"):
        assert polhode.inertia(io.StringIO(path.read_text()), format=path.suffix.lstrip("."), **options) == wanted


def test_what_is_wrong_in_an_open_file_has_its_place() -> None:
    broken = io.StringIO("3\nwater\nO 0 0 0\nH 0 0 oops\nH 0 1 0\n")
    with pytest.raises(polhode.PolhodeError) as error:
        polhode.inertia(broken, format="xyz")
    assert error.value.line == 4 and error.value.path == "file.xyz" and "/tmp" not in str(error.value)
    with pytest.raises(polhode.PolhodeError, match='give the extension: format="stl"'):
        polhode.inertia(io.BytesIO(b"solid\n"))
    with pytest.raises(polhode.PolhodeError, match="format is only for open files"):
        polhode.inertia(BRACKET, format="stl")
    with pytest.raises(TypeError, match="bytes or text, not list"):
        polhode.inertia(SimpleNamespace(read=lambda: [1, 2], name="a.stl"))
    with pytest.raises(polhode.PolhodeError, match="density has no effect on file.xyz"):
        polhode.inertia(io.StringIO("1\n\nO 0 0 0\n"), format="xyz", density=1.0)
    with (ROOT / "examples" / "water.toml").open() as file, pytest.raises(FileNotFoundError) as missing:
        polhode.inertia(file)
    assert missing.value.filename == "water.xyz" and "/tmp" not in str(missing.value)
    for wrong in (7, {"vertices": VERTICES}, None):
        with pytest.raises(TypeError, match="source must be a path, an open file, a mesh"):
            polhode.inertia(wrong)
    with pytest.raises(polhode.PolhodeError, match=r"source must have the shape \(n, 3, 3\)"):
        polhode.inertia(VERTICES)


def test_a_body_is_a_mapping_and_a_subject() -> None:
    ball = polhode.shapes.sphere(radius=0.1, mass=1.0)
    body = polhode.Body({"a": ball, "b": ball.placed(position=[0.5, 0.2, -0.1])})
    assert "a" in body and "c" not in body and list(body) == ["a", "b"] == list(body.keys()) and len(body) == 2
    assert dict(body.items())["b"] == body["b"] and body.get("c") is None
    with pytest.raises(KeyError):
        body["c"]
    omega = [0.3, -0.2, 0.9]
    assert polhode.FreeMotion(inertia=body, omega=omega) == polhode.FreeMotion(inertia=body.mass_properties.inertia, omega=omega)
    turn = [0.4, -0.7, 1.1, 0.3]
    moved = body.placed(position=[1, 2, 3], rotation=turn)
    whole = body.mass_properties.placed(position=[1, 2, 3], rotation=turn)
    assert np.allclose(moved.mass_properties.inertia, whole.inertia, rtol=1e-12, atol=1e-15) and list(moved) == ["a", "b"]


def test_a_step_file_that_is_not_there_is_that_first(tmp_path: Path) -> None:
    """Whether there is an OpenCASCADE or not."""
    with pytest.raises(FileNotFoundError) as error:
        polhode.inertia(tmp_path / "part.step")
    assert error.value.errno == 2 and str(error.value.filename).endswith("part.step")
