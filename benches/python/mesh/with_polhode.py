"""Mass properties of a mesh by polhode, which looks whether it bounds a solid."""

import polhode


def prepare(vertices, triangles, density):
    return vertices, triangles, density


def solve(prepared):
    vertices, triangles, density = prepared
    body = polhode.inertia((vertices, triangles), density=density, unit="m")
    return body.mass, body.center_of_mass, body.inertia
