"""Solids of a STEP file, read with the user's OpenCASCADE."""

from __future__ import annotations

from typing import Any

from . import _native
from ._error import PolhodeError
from ._estimate import counted

#: Unit of OpenCASCADE's lengths, m. It converts all files to millimetres.
_UNIT = 1e-3

#: Error tolerances for OpenCASCADE's quadrature, relative to the volume. It bisects faces until the
#: volume reaches the tolerance, which does not bound the error of the tensor. The largest change
#: between the two tolerances is reported as the error. Without a tolerance, faces are not bisected
#: at all, and a hole with a free-form rim causes an error of 3e-4 of the volume.
_ERRORS = (1e-9, 1e-12)


def solids(path: str) -> tuple[list[_native.Solid], _native.Step]:
    """Returns the solids, in m and at a density of 1 kg/m³, and remarks about the file."""
    # Report a missing file before a missing library.
    with open(path, "rb") as file:
        is_empty = not file.read(1)
    try:
        from OCP.BRep import BRep_Tool
        from OCP.BRepCheck import BRepCheck_Analyzer
        from OCP.IFSelect import IFSelect_ReturnStatus
        from OCP.STEPControl import STEPControl_Reader
        from OCP.TopAbs import TopAbs_ShapeEnum as Kind
        from OCP.TopExp import TopExp_Explorer
    except ImportError as error:
        raise ImportError("STEP files need OpenCASCADE: pip install cadquery-ocp") from error

    if is_empty:
        raise PolhodeError(f"{path} is empty", "export it again")
    reader = STEPControl_Reader()
    if reader.ReadFile(path) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise PolhodeError(f"{path} is not a STEP file that OpenCASCADE can read", "export it again, as AP203, AP214 or AP242")
    named = _named(reader.StepModel(), path)
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
                raise PolhodeError(f"{path}: solid {number} is open: one of its shells has edges with only one face", "close it in the CAD program")
        if not BRepCheck_Analyzer(solid).IsValid():
            invalid.append(number)
        body, apart = _measured(solid)
        if not body["volume"] > 0.0:
            raise PolhodeError(f"{path}: solid {number} has the volume {body['volume']:.3g} m³", "its faces point inward: export it again")
        body["name"] = f"solid {number}" if len(all_solids) > 1 else ""
        bodies.append(body)
        worst = max(worst, apart)
    left_out = len(within(shape, Kind.TopAbs_SHELL, Kind.TopAbs_SOLID)) + len(within(shape, Kind.TopAbs_FACE, Kind.TopAbs_SHELL))
    if not bodies:
        raise PolhodeError(f"{path} has no solid, only {counted(left_out, 'surface')}", "join them into a closed solid in the CAD program")
    # A solid that occurs at several places counts once.
    different = 0
    for number, solid in enumerate(all_solids):
        different += not any(solid.IsPartner(other) for other in all_solids[:number])
    if different < named:
        raise PolhodeError(f"{path} has {named} solids, but OpenCASCADE reads only {different}", _AGAIN)
    return bodies, {"left_out": left_out, "invalid": invalid, "error": worst}


#: Entities that define the shape and position of solids. Errors in other entities, such as colours
#: and dimensions, do not affect them.
_SHAPES = (
    "StepGeom_GeometricRepresentationItem",
    "StepShape_TopologicalRepresentationItem",
    "StepRepr_MappedItem",
    "StepShape_ShapeRepresentation",
    "StepShape_ShapeDefinitionRepresentation",
    "StepShape_ContextDependentShapeRepresentation",
    "StepRepr_RepresentationRelationship",
    "StepRepr_ItemDefinedTransformation",
    "StepRepr_NextAssemblyUsageOccurrence",
)

_AGAIN = "the file is damaged, or has content that OpenCASCADE does not support: export it again, as AP203, AP214 or AP242"


def _named(model: Any, path: str) -> int:
    """Counts the solids in the file.

    OpenCASCADE skips entities that it cannot read, and assumes millimetres if there is no unit.
    Both cases are refused.
    """
    solids = 0
    for number in range(1, model.NbEntities() + 1):
        entity = model.Value(number)
        name = entity.DynamicType().Name()
        solids += entity.IsKind("StepShape_SolidModel")
        if name.startswith("StepVisual_") or not any(entity.IsKind(kind) for kind in _SHAPES):
            continue
        if entity.IsKind("StepShape_ShapeRepresentation"):
            context = entity.ContextOfItems()
            if context is None or "Unit" not in context.DynamicType().Name():
                raise PolhodeError(f"{path} has a shape without a unit of length", "export it again with its unit")
        check = model.Check(number, True)
        if check.NbFails():
            raise PolhodeError(f"{path}: OpenCASCADE cannot read entity {number}, {name.partition('_')[2]}: {check.CFail(1)}", _AGAIN)
    return solids


def _measured(solid: Any) -> tuple[_native.Solid, float]:
    """Returns volume, area and moments, and the largest relative difference of two quadratures in
    volume, centre and tensor."""
    from OCP.BRepGProp import BRepGProp
    from OCP.gp import gp_Pnt
    from OCP.GProp import GProp_GProps

    rough, surface = GProp_GProps(), GProp_GProps()
    BRepGProp.VolumeProperties_s(solid, rough)
    BRepGProp.SurfaceProperties_s(solid, surface, _ERRORS[0])
    # The reference point is in the body, so that a position far from the origin costs no accuracy.
    near = rough.CentreOfMass() if rough.Mass() > 0.0 else gp_Pnt()

    def moments(error: float) -> tuple[float, list[float], list[list[float]]]:
        found = GProp_GProps(near)
        BRepGProp.VolumeProperties_s(solid, found, error)
        center, tensor = found.CentreOfMass(), found.MatrixOfInertia()
        return (
            found.Mass(),
            [center.X(), center.Y(), center.Z()],
            [[tensor.Value(row, column) for column in (1, 2, 3)] for row in (1, 2, 3)],
        )

    (volume, center, tensor), other = moments(_ERRORS[1]), moments(_ERRORS[0])
    body: _native.Solid = {
        "name": "",
        "volume": volume * _UNIT**3,
        "area": surface.Mass() * _UNIT**2,
        "center": [coordinate * _UNIT for coordinate in center],
        "tensor": [[element * _UNIT**5 for element in row] for row in tensor],
    }
    if not volume > 0.0:
        return body, 0.0
    trace = sum(tensor[k][k] for k in range(3))
    apart = [abs(other[0] / volume - 1.0)]
    apart += [abs(a - b) / (trace / volume) ** 0.5 for a, b in zip(center, other[1])]
    apart += [abs(a - b) / trace for row, others in zip(tensor, other[2]) for a, b in zip(row, others)]
    return body, max(apart)
