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


def ring(outer, inner):
    """Triangles between two loops around the hole, both counter-clockwise seen from +z."""
    cx, cy, _ = HOLE

    def by_angle(loop):
        return sorted((math.atan2(y - cy, x - cx) % (2 * math.pi), (x, y, z)) for x, y, z in loop)

    outer, inner = by_angle(outer), by_angle(inner)
    steps = sorted([(angle, 0) for angle, _ in outer] + [(angle, 1) for angle, _ in inner])
    place = [len(outer) - 1, len(inner) - 1]  # the last of each stands before angle 0
    loops = [outer, inner]
    triangles = []
    for _, which in steps:
        old = loops[which][place[which]][1]
        place[which] = (place[which] + 1) % len(loops[which])
        new = loops[which][place[which]][1]
        opposite = loops[1 - which][place[1 - which]][1]
        triangles.append((old, new, opposite) if which == 0 else (new, old, opposite))
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
