"""Volume of a mesh by manifold3d, which requires matching edges; it has no inertia tensor."""

import manifold3d
import numpy as np


def prepare(vertices, triangles, density):
    return vertices, triangles.astype(np.uint64), density


def solve(prepared):
    vertices, triangles, density = prepared
    solid = manifold3d.Manifold(manifold3d.Mesh64(vertices, triangles))
    return solid.volume() * density, None, None
