"""Mass properties of a file or of triangles."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _source, _step
from ._error import PolhodeError
from ._mass_properties import MassProperties
from ._robot import positions
from ._substance import given, of_parts
from ._units import Quantity, has_units

#: Kind of a file by its extension.
_KINDS = {
    **dict.fromkeys(["stl", "obj", "ply", "off", "gltf", "glb", "3mf", "dae"], "mesh"),
    **dict.fromkeys(["xyz", "extxyz", "mol", "sdf", "sd", "pdb", "ent"], "molecule"),
    **dict.fromkeys(["csv", "tsv"], "particles"),
    **dict.fromkeys(["npy", "nrrd", "nhdr"], "voxels"),
    **dict.fromkeys(["step", "stp"], "step"),
    "toml": "scenario",
    "txt": "cad",
    "urdf": "robot",
    "usda": "robot",
    "osim": "robot",
}

#: Description of each kind, and the options that it accepts.
_OPTIONS = {
    "scenario": ("a scenario", set[str]()),
    "mesh": (
        "a mesh",
        {"density", "mass", "material", "parts", "field", "tolerance", "unit", "hull", "shell", "weld", "fill", "close_within", "walls", "top_layers", "bottom_layers", "infill", "union", "check"},
    ),
    "step": ("a STEP file", {"density", "mass", "material"}),
    "particles": ("a table of particles", {"mass", "unit", "mass_unit"}),
    "cad": ("a CAD report", {"unit", "mass_unit", "products", "decimal"}),
    "molecule": ("a molecule", {"isotopes", "molecule"}),
    "voxels": ("a voxel grid", {"unit", "spacing", "origin", "per_value"}),
    "robot": ("a robot model", {"link", "subtree", "joints"}),
}


def inertia(
    source: str | os.PathLike[str] | tuple[npt.ArrayLike, npt.ArrayLike] | npt.ArrayLike | Any,
    *,
    density: Quantity | None = None,
    mass: Quantity | None = None,
    material: str | None = None,
    parts: Mapping[str, str | Mapping[str, Any]] | None = None,
    field: str | None = None,
    tolerance: float | None = None,
    unit: str | float | None = None,
    hull: bool = False,
    shell: Quantity | None = None,
    weld: str | float | None = None,
    fill: str | float | None = None,
    close_within: str | float | None = None,
    walls: Quantity | None = None,
    top_layers: Quantity | None = None,
    bottom_layers: Quantity | None = None,
    infill: str | float | None = None,
    union: bool = False,
    check: bool = True,
    mass_unit: str | float | None = None,
    products: str | None = None,
    decimal: str | None = None,
    isotopes: str | None = None,
    molecule: int | None = None,
    spacing: npt.ArrayLike | None = None,
    origin: npt.ArrayLike | None = None,
    per_value: Quantity | None = None,
    link: str | None = None,
    subtree: str | None = None,
    joints: Mapping[str, float | str] | None = None,
    kind: str | None = None,
    format: str | None = None,
) -> MassProperties:
    """Computes mass, centre of mass and inertia tensor of a file, or of a mesh in memory.

    Parameters
    ----------
    source
        A path; an open file; ``(vertices, triangles)``; an object with ``vertices`` and ``faces``,
        such as a ``trimesh.Trimesh`` (in its ``units``, if it has any); or triangles (n, 3, 3)
        given by their corners.
    density, mass, material, parts, field, tolerance, unit, hull, shell, weld, fill, close_within, walls, top_layers, bottom_layers, infill, union, check
        Options for meshes; some also apply to other files.
    mass_unit, products, decimal, isotopes, molecule, spacing, origin, per_value, link, subtree, joints
        Options for other files. The notes list the options of each kind of file. Any other option
        is refused.
    kind
        Kind of the file, if its extension does not determine it: a name in the notes.
    format
        Extension that the name of an open file would have, if it has no name.

    Returns
    -------
    MassProperties
        Mass properties about the centre of mass, along the axes of the file. Assumptions and
        corrections are reported as :class:`PolhodeWarning` and in ``findings``.

    Raises
    ------
    PolhodeError
        If a file cannot be read (the error has ``path``, ``line`` and ``column``), a mesh is not
        closed, or an argument does not apply to the source.
    OSError
        If a file does not exist or cannot be opened.

    Notes
    -----
    ``mesh`` (.stl .obj .ply .off .gltf .glb .3mf .dae)
        ``density`` (kg/m³), ``mass`` (kg) or ``material``, at most one. ``parts`` sets a different
        material for parts by name: ``{"wheel": "steel", "hub": {"mass": 0.25}}``. ``field`` is the
        density in kg/m³ as a formula of x, y and z in m, such as ``"2700 - 300*hypot(x, y)"``,
        integrated until the estimated relative error is below ``tolerance`` (1e-10). ``unit`` is
        the unit of length, as ``"mm"`` or in m. ``hull=True`` replaces the mesh by its convex hull.
        ``shell`` makes it a sheet of that thickness, m. Arrays: vertices (n, 3), m unless ``unit``
        is given, and the indices from 0 of three vertices for each triangle (m, 3),
        counter-clockwise as seen from outside. ``weld`` joins vertices of open edges up to that
        distance apart, and ``fill`` then closes holes up to that width: lengths such as
        ``"0.01 mm"``, or plain numbers, fractions of the diagonal of the mesh's bounding box.
        Repairs and their possible effect are reported as a warning and in ``to_dict()["source"]``.
        ``close_within="5%"`` (or 0.05) closes all holes that remain, if they leave at most that
        share of the volume uncertain. ``to_dict()["bounds"]`` has error bounds of all results,
        valid if each missing surface lies within the convex hull of its hole. ``walls="1.2 mm"`` (m)
        and ``infill="15%"`` (or 0.15) are those of a print: points farther from the surface than
        the walls' thickness have that share of the density. ``top_layers`` and ``bottom_layers`` (m)
        are solid layers under all that faces up and over all that faces down; z is up.
        ``union=True`` counts overlapping volumes once, within a part and between parts.
        ``check=False`` omits the search for triangles that intersect. The mesh must still be closed
        and consistently oriented, and the finding ``mesh.unchecked`` states the omission. Use it
        for meshes that were checked before or are sound by construction, such as marching cubes,
        and for many small meshes: a volume that a surface encloses twice counts twice.
    ``step`` (.step .stp, ISO 10303-21)
        ``density``, ``mass`` or ``material``. OpenCASCADE computes the exact solids, each of them a
        part; install it with ``pip install cadquery-ocp`` (the extra ``step``). Lengths are in the
        file's unit. Volumes that solids share count for each of them; overlap is not detected.
    ``scenario`` (.toml)
        No options: a scenario is complete.
    ``particles`` (.csv)
        ``unit`` and ``mass_unit`` if the header has none; ``mass``, the total mass of points
        without masses.
    ``molecule`` (.xyz .mol .sdf .pdb)
        ``isotopes``: ``"abundant"`` (default) or ``"average"``; ``molecule``: index of one of
        several molecules, from 0.
    ``voxels`` (.npy .nrrd)
        ``spacing`` and ``origin`` (3,), m, and ``unit``, if the file lacks them; ``per_value``, the
        density for a value of 1, kg/m³.
    ``cad`` (.txt, a CAD program's report)
        ``products`` ``"negative"`` or ``"positive"``, ``decimal`` ``"point"`` or ``"comma"``,
        ``unit``, ``mass_unit``, if the report is ambiguous.
    ``robot`` (.urdf, .usda, .osim, or .sdf and .xml of a model)
        ``link``, the name of a link, in its own frame; or ``subtree``, the name of a link whose
        descendants are included, in the frame of that link. By default, all links as one body.
        ``joints`` are joint values by name, in rad or m, or as text such as ``"30 deg"``. Mimic
        joints follow their joint, and all other joints are at zero. :func:`fixed_groups` returns
        the groups of links that fixed joints connect, and :func:`link_table` all links.

    Examples
    --------
    >>> import polhode
    >>> vertices = [[0, 0, 0], [30, 0, 0], [0, 20, 0], [0, 0, 10]]
    >>> triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> wedge = polhode.inertia((vertices, triangles), unit="mm", material="aluminium")
    >>> round(1e3 * wedge.mass, 6)
    2.7

    The same mesh as triangles given by their corners:

    >>> import numpy as np
    >>> corners = np.array(vertices)[np.array(triangles)]
    >>> polhode.inertia(corners, unit="mm", material="aluminium").mass == wedge.mass
    True

    A mesh with a hole is refused. It is repaired only on request:

    >>> import warnings
    >>> with warnings.catch_warnings(record=True) as said:
    ...     warnings.simplefilter("always")
    ...     mended = polhode.inertia((vertices, triangles[:-1]), unit="mm", material="aluminium", fill="40 mm")
    >>> round(1e3 * mended.mass, 6), mended.to_dict()["source"]["fill"]["holes"], len(said)
    (2.7, 1, 1)
    """
    options = {
        "density": density,
        "mass": mass,
        "material": material,
        "parts": parts,
        "field": field,
        "tolerance": tolerance,
        "unit": unit,
        "hull": _arrays.truth("hull", hull) or None,
        "shell": shell,
        "weld": weld,
        "fill": fill,
        "close_within": close_within,
        "walls": walls,
        "top_layers": top_layers,
        "bottom_layers": bottom_layers,
        "infill": infill,
        "union": _arrays.truth("union", union) or None,
        "check": None if _arrays.truth("check", check) else False,
        "mass_unit": mass_unit,
        "products": products,
        "decimal": decimal,
        "isotopes": isotopes,
        "molecule": molecule,
        "spacing": spacing,
        "origin": origin,
        "per_value": per_value,
        "link": link,
        "subtree": subtree,
        "joints": joints,
    }
    if (unit is not None or _source.unit_of(source) is not None) and _source.has_units_of_length(source):
        raise PolhodeError("unit is given, but the vertices already have a unit: omit unit")
    mesh = _source.mesh_of(source)
    kind = None if kind is None else _arrays.choice("kind", kind, list(_OPTIONS))
    if format is not None and not hasattr(source, "read"):
        raise PolhodeError("format is only for open files: a path has its extension, and arrays are a mesh")
    if mesh is not None:
        if kind not in (None, "mesh"):
            raise PolhodeError(f"kind = {kind!r} has no effect on arrays, which are a mesh")
        _refuse_options("mesh", "the source", options)
        options["unit"] = _source.unit_of(source) if unit is None else unit
        return _read("mesh", None, mesh, options)._heard()

    def of_file(path: str) -> MassProperties:
        found = _kind(path, kind)
        _refuse_options(found, path, options)
        return _read(found, path, None, options)

    if hasattr(source, "read"):
        return _source.read(source, format, of_file)._heard()
    return of_file(_arrays.path("source", source))._heard()


def _kind(path: str, kind: str | None) -> str:
    """Returns the kind of a file: as given by the user, or from its extension or its root
    element."""
    if kind in ("mesh", "molecule"):
        # These kinds have many formats, so the extension is needed.
        endings = [f".{ending}" for ending, known in _KINDS.items() if known == kind]
        if f".{_ending(path)}" not in endings:
            words, _ = _OPTIONS[kind]
            raise PolhodeError(f"the extension of {path} is not a known format of {words}", f"known extensions: {' '.join(endings)}")
    if kind is not None:
        return kind
    ending = _ending(path)
    if ending in ("sdf", "xml", "world") and _native.is_robot(path):
        return "robot"
    if ending not in _KINDS:
        raise PolhodeError(f"{path} has an unknown file extension", f"choose its kind by kind, one of {', '.join(_OPTIONS)}")
    return _KINDS[ending]


def _ending(path: str) -> str:
    return Path(path).suffix.lower().lstrip(".")


def _refuse_options(kind: str, path: str, options: Mapping[str, object]) -> None:
    words, known = _OPTIONS[kind]
    for name, value in options.items():
        if value is not None and name not in known:
            hint = f"allowed: {', '.join(sorted(known))}" if known else "omit it: the file contains everything"
            raise PolhodeError(f"{name} has no effect on {path}, which is {words}", hint)
    if options["field"] is not None:
        for other in ("density", "mass", "material", "parts", "shell", "close_within", "union"):
            if options[other] is not None:
                raise PolhodeError(f"field and {other} are both given: the formula is the density of the whole solid")
    elif options["tolerance"] is not None:
        raise PolhodeError("tolerance has no effect without field")
    if (options["walls"] is None) != (options["infill"] is None):
        raise PolhodeError("walls and infill belong together", 'write walls="1.2 mm", infill="15%"')
    for layers in ("top_layers", "bottom_layers"):
        if options[layers] is not None and options["walls"] is None:
            raise PolhodeError(f"{layers} has no effect without walls")
    for other in ("hull", "shell", "union", "field", "close_within"):
        if options["walls"] is not None and options[other] is not None:
            raise PolhodeError(f"walls and {other} are both given: a print needs a closed mesh of one density")
    if options["close_within"] is not None and options["union"]:
        raise PolhodeError("close_within and union are both given: a union has no bounds")
    if options["parts"] is not None and options["union"]:
        raise PolhodeError("parts and union are both given: where parts overlap, the density would be ambiguous")
    for whole in ("hull", "shell"):
        for repair in ("weld", "fill", "close_within"):
            if options[whole] is not None and options[repair] is not None:
                raise PolhodeError(f"{whole} and {repair} are both given: a hull or a sheet does not need a closed mesh")
    if options["shell"] is not None and options["union"]:
        raise PolhodeError("shell and union are both given: a sheet follows the surface as it is")
    for whole in ("hull", "shell", "union"):
        if options[whole] is not None and options["check"] is not None:
            raise PolhodeError(f"{whole} and check=False are both given: check has no effect on a hull, a sheet or a union")
    if options["close_within"] is not None and options["check"] is not None:
        raise PolhodeError("close_within and check=False are both given: bounds need the search for intersections")
    if options["hull"] is not None and options["shell"] is not None:
        raise PolhodeError("hull and shell are both given: use either the convex hull or a sheet")


def _read(kind: str, path: str | None, source: Any, options: Mapping[str, Any]) -> MassProperties:
    def number(name: str) -> float | None:
        return None if options[name] is None else _arrays.positive(name, options[name])

    def triple(name: str) -> list[float] | None:
        return None if options[name] is None else _arrays.triple(name, options[name])

    def word(name: str, known: list[str]) -> str | None:
        return None if options[name] is None else _arrays.choice(name, options[name], known)

    length, weight = _unit(options["unit"], "unit", False), _unit(options["mass_unit"], "mass_unit", True)
    if kind == "mesh":
        substance = given(density=options["density"], mass=options["mass"], material=options["material"])
        how: _native.MeshOptions = {
            "unit": length,
            "hull": bool(options["hull"]),
            "shell": number("shell"),
            "weld": _beside_mesh("weld", options["weld"]),
            "fill": _beside_mesh("fill", options["fill"]),
            "close_within": _share("close_within", options["close_within"]),
            "print": _print(*(options[name] for name in ("walls", "top_layers", "bottom_layers", "infill"))),
            "union": bool(options["union"]),
            "check": options["check"] is None,
            "parts": of_parts(options["parts"]),
            "field": None if options["field"] is None else _arrays.text("field", options["field"]),
            "tolerance": number("tolerance"),
        }
        if path is None:
            if isinstance(source, np.ndarray):
                return MassProperties._of(_native.mesh_corners(source.reshape(-1, 9), how, substance))
            return MassProperties._of(_native.mesh_arrays(*_arrays.mesh(*source), how, substance))
        ending = _ending(path)
        return MassProperties._of(_native.mesh_file(path, "gltf" if ending == "glb" else ending, how, substance))
    assert path is not None
    if kind == "step":
        substance = given(density=options["density"], mass=options["mass"], material=options["material"])
        solids, said = _step.solids(path)
        return MassProperties._of(_native.step_solids(path, solids, said, substance))
    if kind == "scenario":
        return MassProperties._of(_native.scenario_file(path))
    if kind == "particles":
        return MassProperties._of(_native.particle_file(path, number("mass"), length, weight))
    if kind == "cad":
        products = word("products", ["negative", "positive"])
        decimal = word("decimal", ["point", "comma"])
        return MassProperties._of(_native.cad_file(path, products, decimal, length, weight))
    if kind == "voxels":
        per_value = number("per_value") or 1.0
        return MassProperties._of(_native.voxel_file(path, triple("spacing"), triple("origin"), length, per_value))
    if kind == "molecule":
        return _molecule(path, word("isotopes", ["abundant", "average"]), options["molecule"])
    link, subtree = (None if options[name] is None else _arrays.text(name, options[name]) for name in ("link", "subtree"))
    joints = positions(options["joints"])
    if link is not None and joints:
        raise PolhodeError("link and joints are both given: joint values have no effect on a link in its own frame")
    if link is not None and subtree is not None:
        raise PolhodeError("link and subtree are both given: use either a single link, or a link with its descendants")
    return MassProperties._of(_native.robot_file(path, link, subtree, joints))


def _molecule(path: str, isotopes: str | None, which: int | None) -> MassProperties:
    molecules = _native.molecule_file(path, isotopes == "average")
    if which is None and len(molecules) > 1:
        raise PolhodeError(f"{path} contains {len(molecules)} molecules", "choose one by molecule, from 0")
    which = None if which is None else _arrays.count("molecule", which, 0)
    if which is not None and which >= len(molecules):
        raise PolhodeError(f"molecule = {which} must be from 0 to {len(molecules) - 1}")
    return MassProperties._of(molecules[which or 0])


def _beside_mesh(name: str, length: str | float | None) -> str | None:
    """Returns a length with its unit, or a fraction of a mesh's size, as text."""
    if length is None or isinstance(length, str):
        return length
    of_size = not has_units(length)
    found = repr(_arrays.positive(name, length))
    return found if of_size else f"{found} m"


def _share(name: str, share: str | float | None) -> str | None:
    """Returns a share such as ``"5%"`` or ``0.05`` as text."""
    return share if share is None or isinstance(share, str) else repr(_arrays.number(name, share))


def _print(walls: float | None, top: float | None, bottom: float | None, infill: str | float | None) -> tuple[list[float], str] | None:
    """Returns the thicknesses of walls and layers, m, and the share of the infill."""
    share = _share("infill", infill)
    if walls is None or share is None:
        return None
    layers = [0.0 if value is None else _arrays.positive(name, value) for name, value in (("top_layers", top), ("bottom_layers", bottom))]
    return [_arrays.positive("walls", walls), *layers], share


def _unit(unit: str | float | None, name: str, of_mass: bool) -> float | None:
    """Returns a unit in m or kg."""
    if unit is None:
        return None
    if not isinstance(unit, str):
        return _arrays.positive(name, unit)
    try:
        return _native.unit(unit, of_mass)
    except PolhodeError as error:
        raise PolhodeError(f"{name} = {unit!r}: {error.message}", error.hint) from None
