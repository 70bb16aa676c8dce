"""Writes meshes.usdc, and prints volume, centre and tensor of its bodies in SI units.

    pip install usd-core trimesh numpy
    python meshes.py meshes.usdc

usd-core composes and places the instances, trimesh measures them. `tests/all/usd_meshes.rs` has the
numbers of usd-core 26.11 and trimesh 5.2.0. The tensor is xx, yy, zz, xy, xz, yz about the centre, axes of the
body, at 1 kg/m³.
"""

import sys

import numpy as np
import trimesh
from pxr import Gf, Usd, UsdGeom, UsdPhysics

CENTIMETRE = 0.01

stage = Usd.Stage.CreateNew(sys.argv[1])
UsdGeom.SetStageMetersPerUnit(stage, CENTIMETRE)
stage.CreateClassPrim("/_part")
mesh = UsdGeom.Mesh.Define(stage, "/_part/mesh")
outline = [(-3.1, -2.2), (4.2, -2.4), (4.5, -0.7), (-1.2, -0.4), (-1.0, 3.6), (-3.3, 3.9)]
mesh.GetPointsAttr().Set([(x, y, 0.3) for x, y in outline] + [(x + 0.4, y - 0.3, 2.9) for x, y in outline])
# Left-handed: clockwise seen from outside.
sides = [[k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k] for k in range(6)]
faces = [face[::-1] for face in [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11]] + sides]
mesh.GetFaceVertexCountsAttr().Set([len(face) for face in faces])
mesh.GetFaceVertexIndicesAttr().Set(sum(faces, []))
mesh.GetOrientationAttr().Set("leftHanded")
mesh.GetSubdivisionSchemeAttr().Set("none")

root = UsdGeom.Xform.Define(stage, "/robot")
stage.SetDefaultPrim(root.GetPrim())
root.AddTranslateOp().Set(Gf.Vec3d(12, -7, 31))
root.AddRotateXYZOp().Set(Gf.Vec3f(23, -41, 67))


def body(name):
    form = UsdGeom.Xform.Define(stage, f"/robot/{name}")
    UsdPhysics.RigidBodyAPI.Apply(form.GetPrim())
    UsdPhysics.MassAPI.Apply(form.GetPrim()).CreateMassAttr(1.7)
    return form


def part(path):
    form = UsdGeom.Xform.Define(stage, path)
    form.GetPrim().GetInherits().AddInherit("/_part")
    form.GetPrim().SetInstanceable(True)
    return form


base = body("base")
base.AddTranslateOp().Set(Gf.Vec3d(-4, 9, 2))
base.AddOrientOp().Set(Gf.Quatf(0.6, 0.3, -0.5, 0.55).GetNormalized())
mirrored = part("/robot/base/mirrored")
mirrored.AddTranslateOp().Set(Gf.Vec3d(3.3, -1.1, 6))
mirrored.AddRotateZYXOp().Set(Gf.Vec3f(15, -70, 33))
mirrored.AddScaleOp().Set(Gf.Vec3f(-1.3, 0.8, 2.1))
skew = Gf.Matrix4d(1.1, 0.2, -0.3, 0, 0.5, 0.9, 0.1, 0, -0.2, 0.4, 1.4, 0, -25, 14, -8, 1)
part("/robot/base/skew").AddTransformOp().Set(skew)
arm = body("arm")
arm.AddTranslateOp().Set(Gf.Vec3d(40, 0, 5))
arm.AddRotateYOp().Set(-38)
part("/robot/arm/plain").AddTranslateOp().Set(Gf.Vec3d(0.5, 0.25, -40))
stage.GetRootLayer().Save()

places = UsdGeom.XformCache()
# Fans have the signed volume of their polygons, because these are plane.
triangles = [[face[0], face[k + 1], face[k]] for face in faces for k in range(1, len(face) - 1)]
for form in (base, arm):
    world = places.GetLocalToWorldTransform(form.GetPrim())
    solids = []
    for instance in form.GetPrim().GetChildren():
        prim = instance.GetFilteredChildren(Usd.TraverseInstanceProxies())[0]
        place = places.GetLocalToWorldTransform(prim) * world.GetInverse()
        points = UsdGeom.Mesh(prim).GetPointsAttr().Get()
        points = CENTIMETRE * np.array([place.Transform(Gf.Vec3d(*point)) for point in points])
        solid = trimesh.Trimesh(points, triangles, process=False, validate=False)
        if solid.volume < 0:
            solid.invert()
        assert solid.is_watertight
        solids.append(solid)
    volume = sum(solid.volume for solid in solids)
    centre = sum(solid.volume * solid.center_mass for solid in solids) / volume
    tensor = np.zeros((3, 3))
    for solid in solids:
        d = solid.center_mass - centre
        tensor += solid.moment_inertia + solid.volume * (d @ d * np.eye(3) - np.outer(d, d))
    print(form.GetPath(), volume, list(centre), [tensor[k] for k in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]])
