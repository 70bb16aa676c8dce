"""Writes stages of USD and the masses that OpenUSD computes for their bodies.

    pip install usd-core
    python stages.py FOLDER COUNT [SEED]

Each stage has its own folder. `truth.json` lists the root layers, and for each body its mass in kg,
its centre in m and its tensor (xx, yy, zz, xy, xz, yz; about the centre, axes of the body) in kg·m².
The reference is `UsdPhysics.RigidBodyAPI.ComputeMassProperties`, in single precision. With the count
`kinds`, the folder gets one stage for each kind of composition: `tests/usd/kinds` is that of
`python stages.py kinds kinds 3` with usd-core 26.11. `POLHODE_USD_STAGES=FOLDER cargo test -p
polhode-robot --test all composed_stages` compares another folder.
"""

import json
import math
import random
import sys
from pathlib import Path

from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics, UsdShade, UsdUtils

KINDS = ["local", "reference", "payload", "sublayer", "variant", "inherit", "specialize", "instance", "package"]
ENDINGS = ["usda", "usdc", "usd"]


class Robot:
    """Random robot, written with one kind of composition."""

    def __init__(self, folder, kind, draw):
        self.folder, self.kind, self.draw = folder, kind, draw
        self.metres = draw.choice([1.0, 0.01, 0.001])
        self.kilograms = draw.choice([1.0, 0.001])

    def layer(self, name):
        """Creates a stage in a file of a random format, with the units of the robot."""
        ending = self.draw.choice(ENDINGS)
        stage = Usd.Stage.CreateNew(str(self.folder / f"{name}.{ending}"))
        UsdGeom.SetStageMetersPerUnit(stage, self.metres)
        UsdPhysics.SetStageKilogramsPerUnit(stage, self.kilograms)
        return stage

    def length(self, low=0.05, high=0.4):
        return self.draw.uniform(low, high) / self.metres

    def mass(self):
        return self.draw.uniform(0.5, 9) / self.kilograms

    def density(self):
        return self.draw.uniform(300, 8000) * self.metres**3 / self.kilograms

    def vector(self, size=0.3):
        return [self.draw.uniform(-size, size) / self.metres for _ in range(3)]

    def turn(self):
        return Gf.Quatf(*Gf.Vec4f(*[self.draw.gauss(0, 1) for _ in range(4)]).GetNormalized())

    def moments(self):
        unit = self.kilograms * self.metres**2
        a, b, c = [self.draw.uniform(0.01, 0.1) for _ in range(3)]
        return [(b + c) / unit, (a + c) / unit, (a + b) / unit]

    def place(self, prim):
        shape = UsdGeom.Xformable(prim)
        shape.AddTranslateOp().Set(Gf.Vec3d(*self.vector()))
        shape.AddOrientOp().Set(self.turn())

    def state(self, prim):
        """States some of mass, centre, moments and density of a body."""
        mass = UsdPhysics.MassAPI.Apply(prim)
        what = self.draw.choice(["all", "mass", "density", "none", "centre", "moments"])
        if what in ("all", "mass", "centre"):
            mass.CreateMassAttr(self.mass())
        if what == "density":
            mass.CreateDensityAttr(self.density())
        if what in ("all", "centre"):
            mass.CreateCenterOfMassAttr(Gf.Vec3f(*self.vector(0.1)))
        if what in ("all", "moments"):
            mass.CreateDiagonalInertiaAttr(Gf.Vec3f(*self.moments()))
            mass.CreatePrincipalAxesAttr(self.turn())

    def collider(self, stage, path):
        kind = self.draw.choice([UsdGeom.Cube, UsdGeom.Sphere, UsdGeom.Cylinder, UsdGeom.Capsule, UsdGeom.Cone])
        shape = kind.Define(stage, path)
        prim = shape.GetPrim()
        UsdPhysics.CollisionAPI.Apply(prim)
        self.place(prim)
        if kind is UsdGeom.Cube:
            shape.CreateSizeAttr(self.length())
        else:
            shape.CreateRadiusAttr(self.length())
        if kind not in (UsdGeom.Cube, UsdGeom.Sphere):
            shape.CreateHeightAttr(self.length())
            shape.CreateAxisAttr(self.draw.choice("XYZ"))
        if kind in (UsdGeom.Cube, UsdGeom.Sphere):
            shape.AddScaleOp().Set(Gf.Vec3f(*[self.draw.uniform(0.5, 2) for _ in range(3)]))
        elif self.draw.random() < 0.5:
            shape.AddScaleOp().Set(Gf.Vec3f(self.draw.uniform(0.5, 2)))
        what = self.draw.choice(["none", "none", "mass", "density", "material"])
        if what == "mass":
            UsdPhysics.MassAPI.Apply(prim).CreateMassAttr(self.mass())
        if what == "density":
            UsdPhysics.MassAPI.Apply(prim).CreateDensityAttr(self.density())
        if what == "material":
            self.bind(stage, prim, path + "_material")
        if self.draw.random() < 0.1:
            shape.GetPrim().SetActive(False)
        elif self.draw.random() < 0.1:
            UsdPhysics.CollisionAPI(prim).CreateCollisionEnabledAttr(False)

    def bind(self, stage, prim, path):
        material = UsdShade.Material.Define(stage, path)
        UsdPhysics.MaterialAPI.Apply(material.GetPrim()).CreateDensityAttr(self.density())
        purpose = self.draw.choice(["physics", UsdShade.Tokens.allPurpose])
        UsdShade.MaterialBindingAPI.Apply(prim).Bind(material, materialPurpose=purpose)

    def body(self, stage, path, is_placed=True):
        prim = UsdGeom.Xform.Define(stage, path).GetPrim()
        UsdPhysics.RigidBodyAPI.Apply(prim)
        if is_placed:
            self.place(prim)
        self.state(prim)
        for k in range(self.draw.randint(1, 3)):
            self.collider(stage, f"{path}/shape{k}")
        if self.draw.random() < 0.3:
            self.bind(stage, prim, f"{path}/material")
        return prim

    def write(self):
        """Writes all layers, and returns the path of the root layer."""
        root = self.layer("robot")
        UsdGeom.Xform.Define(root, "/robot")
        root.SetDefaultPrim(root.GetPrimAtPath("/robot"))
        self.body(root, "/robot/base")
        getattr(self, self.kind)(root)
        root.Save()
        return Path(root.GetRootLayer().realPath)

    def part(self):
        """Writes a body as a layer, and returns the name of the file."""
        part = self.layer("part")
        part.SetDefaultPrim(self.body(part, "/part"))
        self.body(part, "/part/finger")
        part.Save()
        return "./" + Path(part.GetRootLayer().realPath).name

    def local(self, root):
        self.body(root, "/robot/arm")
        self.body(root, "/robot/arm/hand")

    def change(self, root, path):
        """Overrides a mass and a shape of another layer."""
        if self.draw.random() < 0.5:
            UsdPhysics.MassAPI(root.OverridePrim(path)).CreateMassAttr(self.mass())
        if self.draw.random() < 0.5:
            root.OverridePrim(path + "/shape0").CreateAttribute("size", Sdf.ValueTypeNames.Double).Set(self.length())

    def reference(self, root):
        name = self.part()
        for side in ["left", "right"]:
            prim = root.DefinePrim(f"/robot/{side}", "Xform")
            prim.GetReferences().AddReference(name)
            self.change(root, f"/robot/{side}")

    def payload(self, root):
        root.DefinePrim("/robot/arm", "Xform").GetPayloads().AddPayload(self.part())
        self.change(root, "/robot/arm")

    def sublayer(self, root):
        under = self.layer("under")
        self.body(under, "/robot/arm")
        under.Save()
        root.GetRootLayer().subLayerPaths.append("./" + Path(under.GetRootLayer().realPath).name)
        self.change(root, "/robot/arm")

    def variant(self, root):
        name = self.part()
        prim = root.DefinePrim("/robot/arm", "Xform")
        sets = prim.GetVariantSets().AddVariantSet("size")
        for size in ["small", "large"]:
            sets.AddVariant(size)
            sets.SetVariantSelection(size)
            with sets.GetVariantEditContext():
                if size == "large":
                    prim.GetReferences().AddReference(name)
                else:
                    self.body(root, "/robot/arm/only")
        sets.SetVariantSelection(self.draw.choice(["small", "large"]))

    def inherit(self, root):
        root.CreateClassPrim("/_part")
        self.body(root, "/_part/body")
        for side in ["left", "right"]:
            root.DefinePrim(f"/robot/{side}", "Xform").GetInherits().AddInherit("/_part")
        self.change(root, "/robot/left/body")

    def specialize(self, root):
        root.CreateClassPrim("/_part")
        self.body(root, "/_part/body")
        root.DefinePrim("/robot/arm", "Xform").GetSpecializes().AddSpecialize("/_part")
        self.change(root, "/robot/arm/body")

    def instance(self, root):
        name = self.part()
        for side in ["left", "right"]:
            prim = root.DefinePrim(f"/robot/{side}", "Xform")
            prim.GetReferences().AddReference(name)
            prim.SetInstanceable(True)
            UsdGeom.Xformable(prim).ClearXformOpOrder()

    def package(self, root):
        self.reference(root)


def value(prim, name):
    return prim.GetAttribute(name).Get()


def information(prim, body, cache):
    """Returns volume, moments at density 1 and place of a shape for OpenUSD."""
    relative = cache.GetLocalToWorldTransform(prim) * cache.GetLocalToWorldTransform(body).GetInverse()
    transform = Gf.Transform(relative)
    x, y, z = transform.GetScale()
    info = UsdPhysics.RigidBodyAPI.MassInformation()
    center = [0.0, 0.0, 0.0]
    kind = prim.GetTypeName()
    if kind == "Cube":
        a, b, c = [value(prim, "size") * s for s in (x, y, z)]
        volume = a * b * c
        moments = [volume * (b * b + c * c) / 12, volume * (a * a + c * c) / 12, volume * (a * a + b * b) / 12]
    elif kind == "Sphere":
        a, b, c = [value(prim, "radius") * s for s in (x, y, z)]
        volume = 4 / 3 * math.pi * a * b * c
        moments = [volume * (b * b + c * c) / 5, volume * (a * a + c * c) / 5, volume * (a * a + b * b) / 5]
    else:
        r, h = value(prim, "radius") * x, value(prim, "height") * x
        k = "XYZ".index(value(prim, "axis"))
        disc = math.pi * r * r * h
        ball = 4 / 3 * math.pi * r**3
        if kind == "Cone":
            volume = disc / 3
            along, across = 0.3 * volume * r * r, volume * (0.15 * r * r + 3 / 80 * h * h)
            center[k] = -h / 4
        else:
            volume, along, across = disc, disc * r * r / 2, disc * (3 * r * r + h * h) / 12
            if kind == "Capsule":
                volume += ball
                along += 0.4 * ball * r * r
                across += ball * (0.4 * r * r + 3 / 8 * h * r + h * h / 4)
        moments = [across] * 3
        moments[k] = along
    info.volume = volume
    info.inertia = Gf.Matrix3f(moments[0], 0, 0, 0, moments[1], 0, 0, 0, moments[2])
    info.centerOfMass = Gf.Vec3f(*center)
    info.localPos = Gf.Vec3f(transform.GetTranslation())
    info.localRot = Gf.Quatf(transform.GetRotation().GetQuat())
    return info


def truth(path):
    """Returns the bodies of a stage."""
    stage = Usd.Stage.Open(str(path))
    metres = UsdGeom.GetStageMetersPerUnit(stage)
    kilograms = UsdPhysics.GetStageKilogramsPerUnit(stage)
    cache = UsdGeom.XformCache()
    bodies = {}
    for prim in stage.Traverse(Usd.TraverseInstanceProxies()):
        if not prim.HasAPI(UsdPhysics.RigidBodyAPI):
            continue
        mass, moments, center, axes = UsdPhysics.RigidBodyAPI(prim).ComputeMassProperties(
            lambda shape: information(shape, prim, cache)
        )
        if mass < 0 or not has_collider(prim):
            bodies[str(prim.GetPath())] = None
            continue
        turn = Gf.Matrix3d(Gf.Quatd(axes)).GetTranspose()
        tensor = turn * Gf.Matrix3d(Gf.Vec3d(moments)) * turn.GetTranspose()
        unit = kilograms * metres**2
        elements = [tensor[i][j] * unit for i, j in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]]
        bodies[str(prim.GetPath())] = {
            "mass": mass * kilograms,
            "center": [c * metres for c in center],
            "tensor": elements,
        }
    return bodies


def has_collider(body):
    """Returns true if OpenUSD computes the body from shapes, and not from a small sphere."""
    prims = iter(Usd.PrimRange(body, Usd.TraverseInstanceProxies()))
    for prim in prims:
        if prim != body and prim.HasAPI(UsdPhysics.RigidBodyAPI):
            prims.PruneChildren()
        elif prim.HasAPI(UsdPhysics.CollisionAPI) and UsdPhysics.CollisionAPI(prim).GetCollisionEnabledAttr().Get():
            return True
    return False


def main():
    folder, count = Path(sys.argv[1]).resolve(), sys.argv[2]
    draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    kinds = KINDS if count == "kinds" else [draw.choice(KINDS) for _ in range(int(count))]
    stages = []
    for k, kind in enumerate(kinds):
        name = kind if count == "kinds" else f"{k:03}-{kind}"
        (folder / name).mkdir(parents=True)
        path = Robot(folder / name, kind, draw).write()
        bodies = truth(path)
        if kind == "package":
            package = folder / f"{name}.usdz"
            UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(path)), str(package))
            for file in (folder / name).iterdir():
                file.unlink()
            (folder / name).rmdir()
            path, bodies = package, truth(package)
        stages.append({"file": str(path.relative_to(folder)), "bodies": bodies})
    (folder / "truth.json").write_text(json.dumps(stages, indent=1) + "\n")


main()
