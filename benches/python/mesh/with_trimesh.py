"""Mass properties of a mesh by trimesh."""

import trimesh


def prepare(vertices, triangles, density):
    return vertices, triangles, density


def solve(prepared):
    vertices, triangles, density = prepared
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    mesh.density = density
    return mesh.mass, mesh.center_mass, mesh.moment_inertia
