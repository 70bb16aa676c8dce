"""STEP files, through OpenCASCADE.

No part of the gate, as OpenCASCADE is large: `pip install cadquery-ocp`, and `pytest tests/test_step.py`. What is said without it is tested everywhere.
"""

from __future__ import annotations

import math
import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest


def test_without_opencascade_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "OCP.BRep", None)
    monkeypatch.setitem(sys.modules, "OCP", None)
    (tmp_path / "part.step").write_text("ISO-10303-21;")
    with pytest.raises(ImportError, match=r"pip install cadquery-ocp"):
        polhode.inertia(tmp_path / "part.step", density=1.0)
    with pytest.raises(polhode.PolhodeError, match="unit has no effect on .* which is a STEP file"):
        polhode.inertia(tmp_path / "part.stp", unit="mm")


@pytest.fixture
def occ() -> Any:
    return pytest.importorskip("OCP.STEPControl", reason="STEP files need OpenCASCADE (cadquery-ocp), a large package that the gate does not install")


AXIS = np.array([0.3, -0.5, 0.8]) / math.sqrt(0.98)
PLACE = np.array([110.0, -70.0, 45.0])


def _write(path: Path, *shapes: Any, unit: str = "MM") -> Path:
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

    writer = STEPControl_Writer()
    Interface_Static.SetCVal_s("write.step.unit", unit)
    for shape in shapes:
        writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(path))
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    return path


def _placed() -> Any:
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    return gp_Ax2(gp_Pnt(*PLACE), gp_Dir(*AXIS))


def _round(axial: float, across: float) -> np.ndarray:
    """The tensor of a body of revolution."""
    along = np.outer(AXIS, AXIS)
    return axial * along + across * (np.eye(3) - along)


def _filleted() -> tuple[Any, np.ndarray, np.ndarray, float]:
    """A box whose twelve edges are rounded, turned and moved; the turn, its centre and its radius, mm."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
    from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
    from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    radius, angle = 2.5, 0.7
    box = BRepPrimAPI_MakeBox(gp_Pnt(-15, -10, -5), 30, 20, 10).Shape()
    rounded = BRepFilletAPI_MakeFillet(box)
    edge = TopoDS.Edge_s if hasattr(TopoDS, "Edge_s") else TopoDS.Edge
    explorer = TopExp_Explorer(box, TopAbs_ShapeEnum.TopAbs_EDGE)
    while explorer.More():
        rounded.Add(radius, edge(explorer.Current()))
        explorer.Next()
    turn, move = gp_Trsf(), gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(*AXIS)), angle)
    move.SetTranslation(gp_Vec(*PLACE))
    across = np.array([[0.0, -AXIS[2], AXIS[1]], [AXIS[2], 0.0, -AXIS[0]], [-AXIS[1], AXIS[0], 0.0]])
    rotation = np.eye(3) + math.sin(angle) * across + (1.0 - math.cos(angle)) * across @ across
    return BRepBuilderAPI_Transform(rounded.Shape(), move * turn, True).Shape(), rotation, PLACE, radius


def _rounded_box(radius: float, rotation: np.ndarray) -> tuple[float, np.ndarray]:
    """Volume and tensor of the box 30 x 20 x 10 mm with round edges, in mm: a box of 25 x 15 x 5 and all within the radius of it."""
    sides = np.array([30.0, 20.0, 10.0]) - 2.0 * radius
    a, b, c = sides
    volume = a * b * c + 2 * radius * (a * b + b * c + c * a) + math.pi * radius**2 * (a + b + c) + 4 / 3 * math.pi * radius**3
    # ∫x² of the slices across x, whose rounding is ρ = r cos θ at x = a/2 + r sin θ
    nodes, weights = np.polynomial.legendre.leggauss(60)
    theta, weights = 0.25 * math.pi * (nodes + 1.0), 0.25 * math.pi * weights

    def second(a: float, b: float, c: float) -> float:
        rho = radius * np.cos(theta)
        slices = b * c + 2 * rho * (b + c) + math.pi * rho**2
        ends = np.sum(weights * rho * (0.5 * a + radius * np.sin(theta)) ** 2 * slices)
        return float(2.0 * ((0.5 * a) ** 3 / 3.0 * (b * c + 2 * radius * (b + c) + math.pi * radius**2) + ends))

    xx, yy, zz = second(a, b, c), second(b, c, a), second(c, a, b)
    return volume, rotation @ np.diag([yy + zz, zz + xx, xx + yy]) @ rotation.T


def _assert_body(
    found: polhode.MassProperties, density: float, volume: float, center: np.ndarray, tensor: np.ndarray, digits: float = 1e-12
) -> None:
    """Of lengths in mm."""
    assert math.isclose(found.mass, density * volume * 1e-9, rel_tol=digits)
    assert np.allclose(found.center_of_mass, 1e-3 * np.asarray(center), rtol=0.0, atol=0.1 * digits)
    wanted = density * 1e-15 * tensor
    assert np.allclose(found.inertia, wanted, rtol=0.0, atol=30.0 * digits * wanted.max())
    assert not found.findings


def test_solids_of_closed_forms_off_the_origin(occ: Any, tmp_path: Path) -> None:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakeTorus

    radius, height, ring, tube, density = 7.0, 31.0, 20.0, 6.0, 2700.0
    cylinder = BRepPrimAPI_MakeCylinder(_placed(), radius, height).Shape()
    volume = math.pi * radius**2 * height
    tensor = volume * _round(radius**2 / 2, (3 * radius**2 + height**2) / 12)
    center = PLACE + 0.5 * height * AXIS
    # of other units the file itself has fewer digits
    for unit, digits in (("MM", 1e-12), ("INCH", 1e-11), ("M", 1e-11)):
        path = _write(tmp_path / f"cylinder-{unit}.step", cylinder, unit=unit)
        _assert_body(polhode.inertia(path, density=density), density, volume, center, tensor, digits)
    given = polhode.inertia(path, mass=1.5)
    assert math.isclose(given.mass, 1.5) and math.isclose(given.volume, volume * 1e-9, rel_tol=1e-11)

    torus = BRepPrimAPI_MakeTorus(_placed(), ring, tube).Shape()
    volume = 2.0 * math.pi**2 * ring * tube**2
    tensor = volume * _round(ring**2 + 0.75 * tube**2, ring**2 / 2 + 0.625 * tube**2)
    found = polhode.inertia(_write(tmp_path / "torus.stp", torus), density=density)
    _assert_body(found, density, volume, PLACE, tensor)
    assert math.isclose(found.surface_area, 4.0 * math.pi**2 * ring * tube * 1e-6, rel_tol=1e-9)


def test_a_filleted_box_that_is_turned(occ: Any, tmp_path: Path) -> None:
    shape, rotation, center, radius = _filleted()
    volume, tensor = _rounded_box(radius, rotation)
    found = polhode.inertia(_write(tmp_path / "box.step", shape), material="aluminium")
    _assert_body(found, 2700.0, volume, center, tensor)


def test_what_is_cut_and_what_is_left_are_the_whole(occ: Any, tmp_path: Path) -> None:
    """Their rims are free curves, which OpenCASCADE's quadrature without a tolerance gets wrong by 3e-4."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeTorus
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    shape, rotation, center, radius = _filleted()
    torus = BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(*PLACE), gp_Dir(0.1, 0.2, 0.9)), 8.0, 2.2).Shape()
    rest, cut = BRepAlgoAPI_Cut(shape, torus).Shape(), BRepAlgoAPI_Common(shape, torus).Shape()
    together = polhode.inertia(_write(tmp_path / "two.step", rest, cut), density=1000.0)
    volume, tensor = _rounded_box(radius, rotation)
    # the curves of the rims are fitted to 1e-7 mm at best
    assert math.isclose(together.volume, volume * 1e-9, rel_tol=1e-7)
    assert np.allclose(together.inertia, 1e-12 * tensor, rtol=0.0, atol=1e-7 * 1e-12 * tensor.max())
    parts = together.to_dict()["parts"]
    assert len(parts) > 1 and math.isclose(sum(part["mass"] for part in parts), together.mass, rel_tol=1e-12)


def test_what_is_no_solid_is_refused_or_said(occ: Any, tmp_path: Path) -> None:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Dir, gp_Pln, gp_Pnt

    face = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(1, 2, 3), gp_Dir(*AXIS)), 0.0, 2.0, 0.0, 3.0).Face()
    with pytest.raises(polhode.PolhodeError, match="has no solid, only 1 surface"):
        polhode.inertia(_write(tmp_path / "face.step", face), density=1.0)
    cylinder = BRepPrimAPI_MakeCylinder(_placed(), 2.0, 3.0).Shape()
    with pytest.warns(polhode.PolhodeWarning, match=r"1 shell or face that does not enclose a solid was left out \[step.not_a_solid\]"):
        polhode.inertia(_write(tmp_path / "both.step", cylinder, face), density=1.0)
    with pytest.warns(polhode.PolhodeWarning, match="mass.assumed"):
        polhode.inertia(_write(tmp_path / "alone.step", cylinder))
    broken = tmp_path / "broken.step"
    broken.write_text("ISO-10303-21;\nHEADER;\nnothing")
    with pytest.raises(polhode.PolhodeError, match="is not a STEP file that OpenCASCADE can read"):
        polhode.inertia(broken, density=1.0)
    empty = tmp_path / "empty.step"
    empty.touch()
    (tmp_path / "folder.step").mkdir()
    for name, kind in (("empty", polhode.PolhodeError), ("folder", IsADirectoryError), ("none", FileNotFoundError)):
        with pytest.raises(kind, match=f"{name}.step"):
            polhode.inertia(tmp_path / f"{name}.step", density=1.0)


def test_what_opencascade_passes_over_is_refused(occ: Any, tmp_path: Path) -> None:
    """It reads the ball alone of each of these, and of the last both in millimetres, and says nothing."""
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeSphere
    from OCP.gp import gp_Pnt

    ball = BRepPrimAPI_MakeSphere(gp_Pnt(80, 3, -7), 9.0).Shape()
    whole = _write(tmp_path / "whole.step", BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 10, 20, 30).Shape(), ball)
    assert math.isclose(polhode.inertia(whole, density=1e9).mass, 6000.0 + 4.0 / 3.0 * math.pi * 729.0, rel_tol=1e-12)
    for pattern, replacement, message in (
        (r"(MANIFOLD_SOLID_BREP\('',)#\d+", r"\1#99999", "cannot read entity .*, ManifoldSolidBrep"),
        ("MANIFOLD_SOLID_BREP", "MANIFOLD_SOLID", "cannot read entity .*, AdvancedBrepShapeRepresentation"),
        (r"(CLOSED_SHELL\('',\()[#\d,\s]+", r"\1", "has 2 solids, but OpenCASCADE reads only 1"),
        ("GLOBAL_UNIT_ASSIGNED", "OTHER_UNIT_ASSIGNED", "has a shape without a unit of length"),
    ):
        text, changed = re.subn(pattern, replacement, whole.read_text(), count=1)
        damaged = tmp_path / "damaged.step"
        damaged.write_text(text)
        assert changed
        with pytest.raises(polhode.PolhodeError, match=message):
            polhode.inertia(damaged, density=1e9)
