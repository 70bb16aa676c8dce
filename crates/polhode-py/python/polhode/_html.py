"""What notebooks show."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Iterable

if TYPE_CHECKING:
    from ._body import Body
    from ._mass_properties import MassProperties


def number(value: float) -> str:
    """Six digits."""
    return f"{value:.6g}"


def rows(head: Iterable[str], body: Iterable[tuple[str, Iterable[str]]]) -> str:
    """A table: its column heads, and rows with a head each. All of it is text."""
    heads = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    lines = "".join(
        f"<tr><th>{escape(name)}</th>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>" for name, cells in body
    )
    return f"<table><thead><tr><th></th>{heads}</tr></thead><tbody>{lines}</tbody></table>"


def mass_properties(body: MassProperties) -> str:
    """The tensor, the principal moments with their axes, and what was noticed."""
    center = ", ".join(map(number, body.center_of_mass))
    tensor = rows("xyz", zip("xyz", ([number(e) for e in row] for row in body.inertia)))
    principal = rows(
        ["moment, kg·m²", "axis x", "y", "z"],
        (
            (str(k + 1), [number(moment), *map(number, axis)])
            for k, (moment, axis) in enumerate(zip(body.moments, body.axes))
        ),
    )
    findings = "".join(f"<li>{escape(f.severity)}: {escape(f.message)}</li>" for f in body.findings)
    return (
        f"<div><p>mass {number(body.mass)} kg, centre of mass ({center}) m</p>"
        f"<p>inertia about the centre of mass, along body axes, off-diagonal = −∫xy dm, kg·m²</p>{tensor}"
        f"<p>principal, {escape(body.symmetry)}</p>{principal}" + (f"<ul>{findings}</ul>" if findings else "") + "</div>"
    )


def body(body: Body) -> str:
    """A row for each part, and the whole."""
    whole = body.mass_properties
    listed = [*body.parts.items(), ("together", whole)]
    table = rows(
        ["mass, kg", "x, m", "y, m", "z, m", "i1, kg·m²", "i2", "i3"],
        ((name, [number(part.mass), *map(number, part.center_of_mass), *map(number, part.moments)]) for name, part in listed),
    )
    return f"<div>{table}{mass_properties(whole)}</div>"


def frame(page: str, height: int = 640) -> str:
    """A page in a frame of its own: its scripts reach nothing outside."""
    return (
        f'<iframe sandbox="allow-scripts" srcdoc="{escape(page)}" '
        f'style="width: 100%; height: {height}px; border: 0" title="motion"></iframe>'
    )
