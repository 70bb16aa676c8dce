"""Writes bracket.stl and meshes/bracket.*: an angle bracket in millimetres, without a symmetry, in every mesh format.

A base plate 60 x 40 x 5 with a hole of radius 8 off its middle, and an upright 5 thick whose top slopes from 35 down to
20. Every edge belongs to two triangles; normals point outward. The coordinates of all files are those of the STL, which
has them in single precision.

    python3 make_bracket.py
"""

import json
import math
import struct
import zipfile
from pathlib import Path

LONG, WIDE, THICK = 60.0, 40.0, 5.0
HIGH, LOW = 35.0, 20.0  # the upright at y = 0 and at y = WIDE
HOLE = (38.0, 16.0, 8.0)  # x, y, radius
SEGMENTS = 48


def profile(y, height):
    """The L at one end, counter-clockwise seen from -y."""
    corners = [(0, 0), (LONG, 0), (LONG, THICK), (THICK, THICK), (THICK, height), (0, height)]
    return [(float(x), y, float(z)) for x, z in corners]


def hole(z):
    cx, cy, r = HOLE
    turns = [2 * math.pi * k / SEGMENTS for k in range(SEGMENTS)]
    return [(cx + r * math.cos(t), cy + r * math.sin(t), z) for t in turns]


def ring(corners, inner):
    """Triangles between a rectangle, from its lower left corner on, and the hole in it, both counter-clockwise seen from +z.

    Each quarter of the hole looks to its own corner, and each side to the vertex of the hole that is nearest to it.
    """
    quarter = SEGMENTS // 4
    triangles = []
    for q in range(4):
        corner, following = corners[(q + 2) % 4], corners[(q + 3) % 4]
        for k in range(q * quarter, (q + 1) * quarter):
            triangles.append((inner[k], corner, inner[(k + 1) % SEGMENTS]))
        triangles.append((corner, following, inner[(q + 1) * quarter % SEGMENTS]))
    return triangles


def bracket():
    near, far = profile(0.0, HIGH), profile(WIDE, LOW)
    fan = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    triangles = [(near[a], near[b], near[c]) for a, b, c in fan]
    triangles += [(far[a], far[c], far[b]) for a, b, c in fan]
    for k in range(6):
        a, b = k, (k + 1) % 6
        if k not in (0, 2):  # the faces of the base have the hole in them
            triangles += [(near[a], far[a], far[b]), (near[a], far[b], near[b])]
    bottom, top = hole(0.0), hole(THICK)
    triangles += ring([near[3], near[2], far[2], far[3]], top)
    triangles += [(a, c, b) for a, b, c in ring([near[0], near[1], far[1], far[0]], bottom)]
    for k in range(SEGMENTS):
        n = (k + 1) % SEGMENTS
        triangles += [(bottom[k], top[k], top[n]), (bottom[k], top[n], bottom[n])]
    return triangles


def single(vertex):
    """The vertex as the STL has it."""
    return struct.unpack("<3f", struct.pack("<3f", *vertex))


def indexed(triangles):
    """The vertices, each once, and the triangles by their numbers."""
    numbers = {}
    faces = [tuple(numbers.setdefault(single(vertex), len(numbers)) for vertex in triangle) for triangle in triangles]
    return list(numbers), faces


def write_stl(path, triangles):
    with open(path, "wb") as file:
        file.write(b"angle bracket, millimetres".ljust(80, b"\0"))
        file.write(struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<3f", 0, 0, 0))  # a reader takes the normal from the winding
            for vertex in triangle:
                file.write(struct.pack("<3f", *vertex))
            file.write(struct.pack("<H", 0))


def lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def write_obj(path, vertices, faces):
    rows = [("v", *vertex) for vertex in vertices] + [("f", *(k + 1 for k in face)) for face in faces]
    path.write_text("# angle bracket, millimetres\no bracket\n" + lines(rows), newline="\n")


def write_off(path, vertices, faces):
    rows = [(len(vertices), len(faces), 0), *vertices, *((3, *face) for face in faces)]
    path.write_text("OFF\n# angle bracket, millimetres\n" + lines(rows), newline="\n")


def write_ply(path, vertices, faces):
    header = ["ply", "format binary_little_endian 1.0", "comment angle bracket, millimetres"]
    header += [f"element vertex {len(vertices)}", *(f"property float {axis}" for axis in "xyz")]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    body = b"".join(struct.pack("<3f", *vertex) for vertex in vertices)
    body += b"".join(struct.pack("<B3i", 3, *face) for face in faces)
    path.write_bytes(("\n".join(header) + "\n").encode() + body)


def write_glb(path, vertices, faces):
    """glTF is in metres: the node makes millimetres of them."""
    points = b"".join(struct.pack("<3f", *vertex) for vertex in vertices)
    indices = b"".join(struct.pack("<3H", *face) for face in faces)
    indices += b"\0" * (-len(indices) % 4)
    bounds = {name: [pick(v[k] for v in vertices) for k in range(3)] for name, pick in (("min", min), ("max", max))}
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "bracket", "mesh": 0, "scale": [0.001, 0.001, 0.001]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3", **bounds},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(faces), "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(points), "target": 34962},
            {"buffer": 0, "byteOffset": len(points), "byteLength": 6 * len(faces), "target": 34963},
        ],
        "buffers": [{"byteLength": len(points) + len(indices)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(points) + len(indices), 0x004E4942) + points + indices
    path.write_bytes(struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks)


def write_3mf(path, vertices, faces):
    """Stored, not compressed, and without the time of day: the same bytes whoever writes them."""
    points = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>\n' for x, y, z in vertices)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n' for a, b, c in faces)
    declaration = '<?xml version="1.0" encoding="UTF-8"?>\n'
    files = {
        "[Content_Types].xml": '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
        "_rels/.rels": '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
        '<Relationship Target="/3D/3dmodel.model" Id="rel0" '
        'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
        "3D/3dmodel.model": '<model unit="millimeter" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>\n'
        f'<object id="1" name="bracket" type="model"><mesh><vertices>\n{points}</vertices><triangles>\n{triangles}'
        '</triangles></mesh></object>\n</resources><build><item objectid="1"/></build></model>',
    }
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        for name, text in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.create_system = 3
            archive.writestr(entry, declaration + text)


def write_dae(path, vertices, faces):
    points = "".join(f"{x} {y} {z}\n" for x, y, z in vertices)
    corners = "".join(f"{a} {b} {c}\n" for a, b, c in faces)
    path.write_text(
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">\n'
        '<asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>\n'
        '<library_geometries><geometry id="bracket" name="bracket"><mesh>\n'
        f'<source id="positions"><float_array id="coordinates" count="{3 * len(vertices)}">\n{points}</float_array>'
        f'<technique_common><accessor source="#coordinates" count="{len(vertices)}" stride="3">'
        + "".join(f'<param name="{axis}" type="float"/>' for axis in "XYZ")
        + "</accessor></technique_common></source>\n"
        '<vertices id="vertices"><input semantic="POSITION" source="#positions"/></vertices>\n'
        f'<triangles count="{len(faces)}"><input semantic="VERTEX" source="#vertices" offset="0"/><p>\n{corners}</p></triangles>\n'
        "</mesh></geometry></library_geometries>\n"
        '<library_visual_scenes><visual_scene id="scene"><node><instance_geometry url="#bracket"/></node></visual_scene>'
        '</library_visual_scenes>\n<scene><instance_visual_scene url="#scene"/></scene>\n</COLLADA>\n',
        newline="\n",
    )


if __name__ == "__main__":
    folder = Path(__file__).parent
    solid = bracket()
    write_stl(folder / "bracket.stl", solid)
    (folder / "meshes").mkdir(exist_ok=True)
    writers = {"obj": write_obj, "off": write_off, "ply": write_ply, "glb": write_glb, "3mf": write_3mf, "dae": write_dae}
    for ending, write in writers.items():
        write(folder / "meshes" / f"bracket.{ending}", *indexed(solid))
