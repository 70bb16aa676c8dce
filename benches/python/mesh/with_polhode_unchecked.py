"""Mass properties of a mesh by polhode, without the search for self-intersections."""

import polhode


def prepare(vertices, triangles, density):
    return vertices, triangles, density


def solve(prepared):
    vertices, triangles, density = prepared
    body = polhode.inertia((vertices, triangles), density=density, unit="m", check=False)
    return body.mass, body.center_of_mass, body.inertia
