#!/usr/bin/env python3
"""Seeds of the fuzz targets: examples, fixtures, and the texts that tests and documentation hold.

    python3 fuzz/seeds.py OUT       writes OUT/TARGET/… and OUT/TARGET.dict

Only the standard library. The same tree gives the same files.
"""

import hashlib
import io
import re
import struct
import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUT = Path(sys.argv[1])
LARGEST = 20_000

# Where texts of each target stand: Rust sources whose string literals they are.
TEXTS = {
    "stl": ["shape/tests/all/stl.rs", "shape/src/mesh/stl.rs"],
    "obj": ["shape/tests/all/obj.rs", "shape/src/mesh/obj.rs"],
    "ply": ["shape/tests/all/ply.rs", "shape/src/mesh/ply.rs"],
    "off": ["shape/tests/all/off.rs", "shape/src/mesh/off.rs"],
    "gltf": ["shape/tests/all/gltf/mod.rs", "shape/tests/all/gltf/broken.rs", "shape/tests/all/gltf/file.rs"],
    "collada": ["shape/tests/all/collada.rs"],
    "xyz": ["shape/tests/all/molecule.rs", "shape/src/molecule/xyz.rs"],
    "mol": ["shape/tests/all/molecule.rs", "shape/src/molecule/mol.rs"],
    "pdb": ["shape/tests/all/molecule.rs", "shape/src/molecule/pdb.rs"],
    "particles": ["shape/tests/all/particles.rs", "shape/src/particles.rs"],
    "voxel": ["shape/tests/all/voxel.rs", "shape/src/voxel/mod.rs"],
    "times": ["source/src/times.rs"],
    "budget": ["budget/tests/all/read/*.rs"],
    "motion_table": ["scenario/tests/all/prescribed.rs", "scenario/src/read/motion_table.rs"],
    "run_log": ["table/tests/all/log/*.rs", "table/src/log/mod.rs"],
    "cad": ["shape/tests/all/cad.rs", "shape/src/cad/mod.rs"],
    "unit": ["source/tests/all/unit.rs", "source/src/unit.rs", "source/src/unit/table.rs"],
    "expression": ["source/tests/all/expression.rs", "source/src/expression/mod.rs", "source/src/expression/parse.rs"],
    "formula": ["scenario/tests/all/torque_formula.rs", "scenario/tests/all/formula.rs", "source/src/expression/state.rs"],
    "urdf": ["robot/tests/all/urdf.rs", "robot/tests/all/bad_inertials.rs", "robot/tests/all/check_*.rs", "robot/tests/all/repair.rs",
             "robot/tests/all/lump.rs", "robot/tests/all/hostile.rs"],
    "sdf": ["robot/tests/all/sdf*.rs", "robot/tests/all/check_languages.rs", "robot/tests/all/check_tree.rs"],
    "mjcf": ["robot/tests/all/mjcf*.rs", "robot/tests/all/check_languages.rs"],
    "usd": ["robot/tests/all/usd.rs"], "osim": ["robot/tests/all/osim.rs"],
    "scenario": ["scenario/tests/all/scenario.rs", "scenario/tests/all/mistakes/*.rs", "scenario/tests/all/prescribed.rs",
                 "scenario/tests/all/book.rs", "scenario/src/read/mod.rs"],
    "plan": ["sweep/tests/all/plan/*.rs", "sweep/tests/all/*.rs", "sweep/src/plan/mod.rs"],
}

# Sources whose short literals are words of the format.
WORDS = {
    "stl": "shape/src/mesh/stl.rs", "obj": "shape/src/mesh/obj.rs", "ply": "shape/src/mesh/ply/*.rs",
    "off": "shape/src/mesh/off.rs", "gltf": "shape/src/mesh/gltf/*.rs", "threemf": "shape/src/mesh/threemf/*.rs",
    "collada": "shape/src/mesh/collada/*.rs", "mol": "shape/src/molecule/mol.rs", "pdb": "shape/src/molecule/pdb.rs",
    "xyz": "shape/src/molecule/xyz.rs", "particles": "shape/src/particles*.rs", "voxel": "shape/src/voxel/*.rs", "budget": "budget/src/read/**/*.rs",
    "motion_table": "scenario/src/read/motion_table.rs", "run_log": "table/src/log/*.rs", "cad": "shape/src/cad/*.rs", "unit": "source/src/unit/table.rs",
    "expression": "source/src/expression/*.rs", "formula": "polhode/src/motion/model/state_variables.rs",
    "urdf": "robot/src/read/urdf.rs", "sdf": "robot/src/read/sdf*.rs", "mjcf": "robot/src/read/mjcf/**/*.rs",
    "usd": "robot/src/read/usd/*.rs", "osim": "robot/src/read/osim*.rs",
    "scenario": "scenario/src/read/**/*.rs", "plan": "scenario/src/read/**/*.rs",
}

# What a text of the target has to hold, where a source has texts of several.
HOLDS = {"collada": "<COLLADA", "urdf": "<robot", "sdf": "<sdf", "mjcf": "<mujoco", "usd": "#usda", "osim": "<OpenSim", "gltf": "{", "scenario": "[", "plan": "[sweep",
         "motion_table": "time_s", "cad": "\n", "budget": "\n", "mol": "V2000", "pdb": "ATOM"}


def add(target, data):
    data = data.encode() if isinstance(data, str) else data
    if data and len(data) <= LARGEST:
        folder = OUT / target
        folder.mkdir(parents=True, exist_ok=True)
        (folder / hashlib.sha256(data).hexdigest()[:16]).write_bytes(data)


def sources(pattern):
    crate = pattern if pattern.startswith("polhode/") else "polhode-" + pattern
    return sorted((ROOT / "crates").glob(crate))


LITERAL = re.compile(r"""r(#+)"(.*?)"\1|'(?:\\.|[^\\'])'|"((?:[^"\\]|\\.)*)\"""", re.S)
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "0": "\0"}


def literals(text):
    """String literals of Rust, roughly; what is not one does no harm as a seed."""
    doc = "\n".join(re.findall(r"^\s*//[/!] ?(.*)$", text, re.M))
    code = re.sub(r"^\s*//.*$", "", text, flags=re.M)
    for part in (code, doc):
        for raw in LITERAL.finditer(part):
            if raw[1]:
                yield raw[2]
            elif raw[3]:
                plain = re.sub(r"\\\n\s*", "", raw[3])
                plain = re.sub(r"\\x([0-9a-fA-F]{2})", lambda m: chr(int(m[1], 16)), plain)
                plain = re.sub(r"\\u\{([0-9a-fA-F]+)\}", lambda m: chr(int(m[1], 16)), plain)
                yield re.sub(r"\\(.)", lambda m: ESCAPES.get(m[1], m[1]), plain, flags=re.S)


def from_texts():
    for target, patterns in TEXTS.items():
        for path in (path for pattern in patterns for path in sources(pattern)):
            for text in literals(path.read_text()):
                if HOLDS.get(target, "") in text and (len(text) > 12 or target in ("unit", "expression", "formula")):
                    text = text.replace("{{", "{").replace("}}", "}")
                    add(target, text)
                    if target in ("scenario", "plan") and "[run]" not in text:
                        add(target, text + "\n[run]\nduration = 1\nsamples = 3\n")
                    if target == "scenario" and "[[body.part]]" not in text:
                        add(target, BODY + text)


BODY = '[[body.part]]\nshape = "box"\nsize = [1.1, 2, 3]\nmass = "1.7 kg"\n[start]\nspin = { body = [0.3, 0.5, 0.9] }\n' \
       "[run]\nduration = 1\nsamples = 3\n"


def words():
    for target, pattern in WORDS.items():
        found = {word for path in sources(pattern) for word in literals(path.read_text())
                 if 2 <= len(word) <= 24 and word.isascii() and word.isprintable() and not set(word) & set('"\\{}')}
        lines = [f'"{word}"' for word in sorted(found)]
        (OUT / f"{target}.dict").write_text("\n".join(lines) + "\n")


def from_files():
    endings = {".stl": "stl", ".obj": "obj", ".ply": "ply", ".off": "off", ".glb": "gltf", ".gltf": "gltf", ".3mf": "threemf",
               ".xyz": "xyz", ".mol": "mol", ".pdb": "pdb", ".urdf": "urdf", ".sdf": "sdf", ".usda": "usd", ".osim": "osim", ".dae": "collada", ".csv": "motion_table"}
    for path in sorted(p for top in ("examples", "fixtures") for p in (ROOT / top).rglob("*") if p.is_file()):
        if path.parent.name == "budget" and path.suffix in (".csv", ".xlsx"):
            add("budget", path.read_bytes())
            if path.suffix == ".xlsx":
                with zipfile.ZipFile(path) as archive:
                    add("budget", archive.read("xl/worksheets/sheet1.xml").split(b"?>\n")[-1])
        elif path.suffix in endings:
            add(endings[path.suffix], path.read_bytes())
        elif path.suffix == ".xml" and b"<mujoco" in path.read_bytes():
            add("mjcf", path.read_bytes())
        elif path.suffix == ".toml" and path.is_relative_to(ROOT / "examples"):
            add("plan" if "[sweep]" in path.read_text() else "scenario", path.read_bytes())


# A tetrahedron and a box with generic numbers, in every format: what mutations start from has to be accepted.
TETRAHEDRON = ([(0.5, 0.25, -0.125), (2.5, 0.0, 0.375), (0.0, 3.0, 0.25), (0.75, 0.5, 1.75)],
               [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
BOX = ([(1.5 * (k & 1), 2.25 * (k >> 1 & 1), 0.75 * (k >> 2 & 1)) for k in range(8)],
       [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)])


def meshes():
    for points, faces in (TETRAHEDRON, BOX):
        corners = [[points[v] for v in face] for face in faces]
        lines = [" ".join(map(str, p)) for p in points]
        add("stl", b"\0" * 80 + struct.pack("<I", len(faces))
            + b"".join(struct.pack("<12fH", 0, 0, 0, *sum(c, ()), 0) for c in corners))
        add("stl", "solid a\n" + "".join(
            "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in c) + "endloop\nendfacet\n"
            for c in corners) + "endsolid a\n")
        add("obj", "".join(f"v {line}\n" for line in lines) + "g a\n" + "".join(f"f {a+1} {b+1} {c+1}\n" for a, b, c in faces))
        add("off", f"OFF\n{len(points)} {len(faces)} 0\n" + "\n".join(lines) + "\n" + "".join(f"3 {a} {b} {c}\n" for a, b, c in faces))
        ply = "ply\nformat {} 1.0\nelement vertex %d\nproperty {} x\nproperty {} y\nproperty {} z\nelement face %d\n" \
              "property list uchar int vertex_indices\nend_header\n" % (len(points), len(faces))
        add("ply", ply.format("ascii", *["float"] * 3) + "\n".join(lines) + "\n" + "".join(f"3 {a} {b} {c}\n" for a, b, c in faces))
        for name, order in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
            add("ply", ply.format(name, *["double"] * 3).encode() + b"".join(struct.pack(order + "3d", *p) for p in points)
                + b"".join(struct.pack(order + "B3i", 3, *f) for f in faces))
        data = b"".join(struct.pack("<3f", *p) for p in points) + b"".join(struct.pack("<3H", *f) for f in faces)
        data += b"\0" * (-len(data) % 4)
        views = f'"bufferViews":[{{"buffer":0,"byteLength":{12*len(points)}}},{{"buffer":0,"byteOffset":{12*len(points)},"byteLength":{6*len(faces)}}}]'
        low, high = [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]
        json = (f'{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0,"scale":[1,2,1]}}],'
                f'"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],"buffers":[{{"byteLength":{len(data)}}}],{views},'
                f'"accessors":[{{"bufferView":0,"componentType":5126,"count":{len(points)},"type":"VEC3","min":{low},"max":{high}}},'
                f'{{"bufferView":1,"componentType":5123,"count":{3*len(faces)},"type":"SCALAR"}}]}}')
        json += " " * (-len(json) % 4)
        body = struct.pack("<II", len(json), 0x4E4F534A) + json.encode() + struct.pack("<II", len(data), 0x004E4942) + data
        add("gltf", struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
        model = ('<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
                 '<object id="1" type="model"><mesh><vertices>' + "".join('<vertex x="%s" y="%s" z="%s"/>' % p for p in points)
                 + "</vertices><triangles>" + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in faces)
                 + '</triangles></mesh></object></resources><build><item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 6 7"/></build></model>')
        relation = ('<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship '
                    'Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            out = io.BytesIO()
            with zipfile.ZipFile(out, "w", method) as archive:
                for name, text in (("_rels/.rels", relation), ("3D/3dmodel.model", model)):
                    archive.writestr(zipfile.ZipInfo(name), text, compress_type=method)
            add("threemf", out.getvalue())
        floats = " ".join(" ".join(map(str, p)) for p in points)
        add("collada", f'<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="0.01"/></asset>'
            f'<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="f" count="{3*len(points)}">{floats}</float_array>'
            f'<technique_common><accessor source="#f" count="{len(points)}" stride="3"/></technique_common></source>'
            f'<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="{len(faces)}">'
            f'<input semantic="VERTEX" source="#v" offset="0"/><p>{" ".join(" ".join(map(str, f)) for f in faces)}</p></triangles></mesh></geometry>'
            f'</library_geometries><library_visual_scenes><visual_scene id="s"><node><translate>1 2 3</translate><rotate>0 0 1 30</rotate>'
            f'<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>')


def grids():
    import gzip
    for kind, code, values in (("<f8", "d", (1.5, 2, 0, 4, 5, 6, 7, 8)), ("|u1", "B", range(8)), (">i2", "h", range(8))):
        header = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': (2, 2, 2), }}"
        header += " " * (-(len(header) + 11) % 64) + "\n"
        order = ">" if kind.startswith(">") else "<"
        add("voxel", b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + struct.pack(order + "8" + code, *values))
    nrrd = ("NRRD0004\ntype: {}\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: {}\nspace dimension: 3\n"
            'space directions: (2,0,0) (0,2,0.5) (0,0,3)\nspace units: "mm" "mm" "mm"\nspace origin: (1,2,3)\n\n')
    data = struct.pack("<8H", *range(8))
    add("voxel", nrrd.format("ushort", "raw").encode() + data)
    add("voxel", nrrd.format("ushort", "gzip").encode() + gzip.compress(data, mtime=0))
    add("voxel", nrrd.format("float", "ascii").encode() + b"1 2 3 4.5 0 6e-1 7 8\n")
    add("particles", "mass_kg,x_m,y_m,z_m\n1.5,0,0.2,-3\n2,1,0,0\n0.5,0,1,4\n")
    add("particles", "x,y,z\n1,2,3\n-1,0,2\n")
    add("times", "# nights\n0\n36 h\n\n-2.5 d\n")
    add("motion_table", "time_s,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s\n0,1,2,3\n0.25,1,2.5,3\n0.5,1,3,3.25\n0.75,1,3,3\n")
    add("motion_table", "time_s,omega_space_x_rad_s,omega_space_y_rad_s,omega_space_z_rad_s\n0,1,2,3\n0.25,1,2.5,3\n1,1,3,3.25\n")
    add("motion_table", "time_s,attitude_w,attitude_x,attitude_y,attitude_z\n0,1,0,0,0\n0.25,0.9,0.1,0,0.1\n0.5,0.8,0.2,0,0.1\n0.75,0.7,0.3,0,0.1\n")
    add("run_log", "# step = 0.001\n# engine = \"a, b\"\ntime_s,attitude_w,attitude_x,attitude_y,attitude_z,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s\n"
        "0,1,0,0,0,0.5,2,-0.25\n0.125,0.8,-0.6,0,0,0.5,1.5e-1,3\n0.25,0.6,0.8,0,0,0,2.5,3\n")
    add("run_log", "# units = ms, deg, deg/s\r\nt;\"roll\";pitch;yaw;gyro_x;gyro_y;gyro_z;note\r\n0;10;20;-30;1;2;3;a\r\n250;11;22;-33;1;2;3;\r\n")
    add("run_log", "t r11 r12 r13 r21 r22 r23 r31 r32 r33\n0 1 0 0 0 1 0 0 0 1\n1 0.6 -0.8 0 0.8 0.6 0 0 0 1\n")
    add("run_log", '{"scenario": "a.toml", "step": 0.001}\n{"t": 0, "q": [1, 0, 0, 0], "omega": {"x": 1, "y": 2, "z": 0.5}}\n'
        '{"t": 0.5, "q": [0.8, 0, 0.6, 0], "omega": {"x": 1, "y": 2, "z": 0.25}}\n')
    add("run_log", '{"time": 0, "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}\n{"time": 2, "R": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}\n')
    add("mjcf", '<mujoco><compiler angle="degree"/><worldbody><body name="a" pos="1 2 3" euler="10 20 30"><inertial pos="0 0 0.1" mass="1.7" '
        'fullinertia="1 2 2.5 0.1 0.2 0.3"/><joint type="hinge" axis="0 1 1"/><geom type="box" size="0.1 0.2 0.3"/></body></worldbody></mujoco>')
    add("scenario", BODY)


def reports():
    """One body as four programs print it: m = 2.5 kg at c = (1, −2, 0.5) m, with the tensor about c and about the origin."""
    mass, (x, y, z) = 2.5, (1.0, -2.0, 0.5)
    central = [[10.0, -1.0, 0.5], [-1.0, 8.0, -0.75], [0.5, -0.75, 5.0]]
    c, square = (x, y, z), x * x + y * y + z * z
    origin = [[central[i][j] + mass * ((square if i == j else 0) - c[i] * c[j]) for j in range(3)] for i in range(3)]
    for sign in (1, -1):
        def printed(rows, letter, gap, comma=False):
            cells = [f"{letter}{'xyz'[i]}{'xyz'[j]}{gap}{rows[i][j] * (1 if i == j else sign):.3f}" for i in range(3) for j in range(3)]
            text = "\n".join("\t".join(cells[3 * i:3 * i + 3]) for i in range(3)) + "\n"
            return text.replace(".", ",") if comma else text
        solidworks = (f"Mass properties of bracket 12\n     Coordinate system: -- default --\n\nMass = 2500.00 grams\n\n"
                      f"Center of mass: ( meters )\n\tX = {x:.2f}\n\tY = {y:.2f}\n\tZ = {z:.2f}\n\n"
                      "Moments of inertia: ( kilograms *  square meters )\nTaken at the center of mass and aligned with the output coordinate system.\n"
                      + printed(central, "L", " = ") + "Moments of inertia: ( kilograms *  square meters )\nTaken at the output coordinate system.\n"
                      + printed(origin, "I", " = "))
        add("cad", solidworks)
        add("cad", re.sub(r"(\d)\.(\d)", r"\1,\2", solidworks))
        add("cad", f"Area\t5876.196 m^2\nDensity\t0.008 kg / m^3\nMass\t{mass} kg\nVolume\t556.5 m^3\nCenter of Mass\t{x} m, {y} m, {z} m\n\n"
            "Moment of Inertia at Center of Mass   (kg m^2)\n" + printed(central, "I", " = ") + "Moment of Inertia at Origin   (kg m^2)\n"
            + printed(origin, "I", " = "))
        row = lambda rows: "".join(f"I{a}x I{a}y I{a}z  " + "  ".join(f"{v * (1 if i == j else sign):.7e}" for j, v in enumerate(rows[i])) + "\n"
                                   for i, a in enumerate("xyz"))
        add("cad", f"VOLUME =  1.2345678e+05  M^3\nDENSITY =  7.8e-06 KILOGRAM / M^3\nMASS =  {mass:.7e} KILOGRAM\n\n"
            f"CENTER OF GRAVITY with respect to _PRT0001 coordinate frame:\nX   Y   Z    {x:.7e} {y:.7e} {z:.7e} M\n\n"
            "INERTIA with respect to _PRT0001 coordinate frame:  (KILOGRAM * M^2)\n\nINERTIA TENSOR:\n" + row(origin)
            + "\nINERTIA at CENTER OF GRAVITY with respect to _PRT0001 coordinate frame:  (KILOGRAM * M^2)\n\nINERTIA TENSOR:\n" + row(central))
        add("cad", f"Mass properties\nMass: {mass} kg\nCenter of mass\nX: {x} m\nY: {y} m\nZ: {z} m\nMoments of inertia (kg m\u00b2)\n"
            + printed(central, "L", "\n").replace("\t", "\n") + "Principal moments of inertia (kg m\u00b2)\nPx 4.82 Py 7.6 Pz 10.58\n")


from_texts()
from_files()
reports()
meshes()
grids()
words()
for folder in sorted(p for p in OUT.iterdir() if p.is_dir()):
    files = list(folder.iterdir())
    print(f"{folder.name:14} {len(files):5} files {sum(f.stat().st_size for f in files):9} bytes")
