"""The solids of a STEP file, through the OpenCASCADE that the user has."""

from __future__ import annotations

from typing import Any

from . import _native
from ._error import PolhodeError

#: OpenCASCADE's lengths, m: whatever the file's unit is, it is asked for millimetres.
_UNIT = 1e-3

#: The error of its quadrature that is good enough, relative to the volume.
_ERROR = 1e-9


def solids(path: str) -> tuple[list[_native.Solid], _native.Step]:
    """The solids in m and at a density of 1 kg/m³, and what is to be said of the file."""
    try:
        from OCP.BRep import BRep_Tool
        from OCP.BRepCheck import BRepCheck_Analyzer
        from OCP.IFSelect import IFSelect_ReturnStatus
        from OCP.STEPControl import STEPControl_Reader
        from OCP.TopAbs import TopAbs_ShapeEnum as Kind
        from OCP.TopExp import TopExp_Explorer
    except ImportError as error:
        raise ImportError("STEP files need OpenCASCADE: pip install 'polhode[step]'") from error

    reader = STEPControl_Reader()
    if reader.ReadFile(path) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise PolhodeError(f"{path} is no STEP file that OpenCASCADE reads", "export it again, as AP203, AP214 or AP242")
    reader.SetSystemLengthUnit(1.0)
    reader.TransferRoots()
    shape = reader.OneShape()
    if shape is None or shape.IsNull():
        raise PolhodeError(f"{path} has no shapes", "export the solid body, not the empty document")

    def within(whole: Any, kind: Any, outside: Any = Kind.TopAbs_SHAPE) -> list[Any]:
        found, explorer = [], TopExp_Explorer(whole, kind, outside)
        while explorer.More():
            found.append(explorer.Current())
            explorer.Next()
        return found

    bodies: list[_native.Solid] = []
    invalid = []
    worst = 0.0
    all_solids = within(shape, Kind.TopAbs_SOLID)
    for number, solid in enumerate(all_solids, 1):
        for shell in within(solid, Kind.TopAbs_SHELL):
            if not BRep_Tool.IsClosed_s(shell):
                raise PolhodeError(f"{path}: solid {number} is open: one of its shells has edges of one face only", "close it in the CAD program")
        if not BRepCheck_Analyzer(solid).IsValid():
            invalid.append(number)
        body, error = _measured(solid)
        if not body["volume"] > 0.0:
            raise PolhodeError(f"{path}: solid {number} has the volume {body['volume']:.3g} m³", "its faces look inward: export it again")
        body["name"] = f"solid {number}" if len(all_solids) > 1 else ""
        bodies.append(body)
        worst = max(worst, error)
    left_out = len(within(shape, Kind.TopAbs_SHELL, Kind.TopAbs_SOLID)) + len(within(shape, Kind.TopAbs_FACE, Kind.TopAbs_SHELL))
    if not bodies:
        raise PolhodeError(f"{path} has no solid, but {left_out} surfaces", "close them to a solid in the CAD program")
    return bodies, {"left_out": left_out, "invalid": invalid, "error": worst}


def _measured(solid: Any) -> tuple[_native.Solid, float]:
    """Volume, area and moments, and the error of the volume that the quadrature estimates, relative."""
    from OCP.BRepGProp import BRepGProp
    from OCP.gp import gp_Pnt
    from OCP.GProp import GProp_GProps

    rough, surface = GProp_GProps(), GProp_GProps()
    BRepGProp.VolumeProperties_s(solid, rough)
    BRepGProp.SurfaceProperties_s(solid, surface)
    # About a point in the body: a place far from the origin costs no digits.
    near = rough.CentreOfMass() if rough.Mass() > 0.0 else gp_Pnt()
    fine = GProp_GProps(near)
    error = float(BRepGProp.VolumeProperties_s(solid, fine, _ERROR))
    center, tensor = fine.CentreOfMass(), fine.MatrixOfInertia()
    body: _native.Solid = {
        "name": "",
        "volume": fine.Mass() * _UNIT**3,
        "area": surface.Mass() * _UNIT**2,
        "center": [coordinate * _UNIT for coordinate in (center.X(), center.Y(), center.Z())],
        "tensor": [[tensor.Value(row, column) * _UNIT**5 for column in (1, 2, 3)] for row in (1, 2, 3)],
    }
    return body, abs(error)
