"""Writes bracket.stl: an angle bracket in millimetres, without a symmetry.

A base plate 60 x 40 x 5 with a hole of radius 8 off its middle, and an upright 5 thick whose top slopes from 35 down to
20. Every edge belongs to two triangles; normals point outward.

    python3 make_bracket.py
"""

import math
import struct
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


def write(path, triangles):
    with open(path, "wb") as file:
        file.write(b"angle bracket, millimetres".ljust(80, b"\0"))
        file.write(struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<3f", 0, 0, 0))  # a reader takes the normal from the winding
            for vertex in triangle:
                file.write(struct.pack("<3f", *vertex))
            file.write(struct.pack("<H", 0))


if __name__ == "__main__":
    write(Path(__file__).with_name("bracket.stl"), bracket())
