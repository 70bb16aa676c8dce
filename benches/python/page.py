"""Page of the book with the measurements: its tables are between markers; links and line counts are computed here."""

from __future__ import annotations

import ast
import io
import sys
import tokenize
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "book" / "peers.md"
BEGIN, END = "<!-- begin: {} -->\n", "<!-- end: {} -->\n"

#: Printed names, in the order of the rows.
NAMES = {"polhode": "polhode", "heyoka": "heyoka", "scipy": "SciPy", "mujoco": "MuJoCo", "trimesh": "trimesh"}


class Small(NamedTuple):
    """Program of the table of small meshes."""

    title: str
    package: str
    checks: str


#: Programs of the table of small meshes, by the ends of their names, in the order of the rows.
SMALL = {
    "polhode": Small("polhode", "polhode", "closed, oriented, no self-intersections"),
    "polhode_unchecked": Small("polhode, `check=False`", "polhode", "closed, oriented"),
    "trimesh": Small("trimesh", "trimesh", "nothing"),
    "manifold3d": Small("manifold3d, volume only", "manifold3d", "matching edges"),
}

#: Packages of that table alone.
SMALL_ONLY = {"manifold3d"}

#: Columns in which lower values are better.
COLUMNS = {"lines": "lines of code", "time": "time", "memory": "memory", "error": "error"}

#: Tokens that do not count as code.
SPACE = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER, tokenize.ENCODING}


def peers(folder: str) -> list[str]:
    """Returns the packages that have a program for a problem."""
    return [peer for peer in NAMES if program(folder, peer).exists()]


def program(folder: str, peer: str) -> Path:
    return HERE / folder / f"with_{peer}.py"


def lines_of_code(text: str) -> int:
    """Returns the number of lines with code. Comments, docstrings and blank lines do not count, except blank lines inside strings."""
    tree = ast.parse(text)
    documented = [node for node in ast.walk(tree) if isinstance(node, (ast.Module, ast.FunctionDef, ast.ClassDef)) and ast.get_docstring(node)]
    documentation = {line for node in documented for line in range(node.body[0].lineno, (node.body[0].end_lineno or 0) + 1)}
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    code = {line for token in tokens if token.type not in SPACE for line in range(token.start[0], token.end[0] + 1)}
    return len({line for line in code - documentation if text.splitlines()[line - 1].strip()})


def table(folder: str, measured: dict[str, dict[str, float]]) -> str:
    """Returns the rows of a problem; the minimum of each column is bold."""
    if list(measured) and set(measured) != set(peers(folder)):
        raise SystemExit(f"{folder} was measured of {sorted(measured)}, and has programs of {sorted(peers(folder))}: measure once more")
    rows = {peer: {"lines": lines_of_code(program(folder, peer).read_text()), **measured[peer]} for peer in peers(folder)}
    least = {column: min(row[column] for row in rows.values()) for column in COLUMNS}
    shown = {"lines": lambda n: f"{n:.0f}", "time": duration, "memory": lambda n: f"{n / 1e6:.0f} MB", "error": lambda e: f"{e:.1g}"}
    out = "| | lines of code | set-up | time | median, and 10 to 90 % | memory | error |\n|---|---|---|---|---|---|---|\n"
    for peer, row in rows.items():
        link = f"[{NAMES[peer]}](../benches/python/{folder}/{program(folder, peer).name})"
        cell = {column: f"**{shown[column](row[column])}**" if row[column] == least[column] else shown[column](row[column]) for column in COLUMNS}
        out += f"| {link} | {cell['lines']} | {duration(row['set_up'])} | {cell['time']} | {spread(row['spread'])} | {cell['memory']} | {cell['error']} |\n"
    return out


def small_meshes(measured: dict[str, Any]) -> str:
    """Returns the table of small meshes; the minimum of each column is bold. Empty if they were not measured."""
    if not measured:
        return ""
    rows, versions = measured["rows"], measured["versions"]
    sizes = sorted(next(iter(rows.values())), key=lambda size: int(size.replace(",", "")))
    least = {size: min(row[size]["time"] for row in rows.values()) for size in sizes}
    said = "".join(f" {NAMES.get(name, name)} {version}." for name, version in versions.items())
    out = "### Small meshes\n\nThe same of icospheres away from the origin, with vertices displaced by up to 1 µm: processor time by number of triangles.\n"
    out += f"manifold3d computes the volume and no tensor.{said}\n\n| | checks | {' | '.join(sizes)} | largest error |\n|---|---|{'---|' * len(sizes)}---|\n"
    for peer in (peer for peer in SMALL if peer in rows):
        row = rows[peer]
        link = f"[{SMALL[peer].title}](../benches/python/mesh/{program('mesh', peer).name})"
        cell = [f"**{duration(row[size]['time'])}**" if row[size]["time"] == least[size] else duration(row[size]["time"]) for size in sizes]
        out += f"| {link} | {SMALL[peer].checks} | {' | '.join(cell)} | {max(row[size]['error'] for size in sizes):.1g} |\n"
    return out


def behind(folder: str, measured: dict[str, dict[str, float]]) -> list[str]:
    """Returns the columns in which another package has a lower value than polhode."""
    lines = {peer: lines_of_code(program(folder, peer).read_text()) for peer in measured}
    rows = {peer: {**row, "lines": lines[peer]} for peer, row in measured.items()}
    return [column for column in COLUMNS if any(row[column] < rows["polhode"][column] for row in rows.values())]


def spread(times: list[float]) -> str:
    """Formats a median, and the times that a tenth of the solutions is below and above."""
    median, low, high = map(duration, times)
    return f"{median} ({low} to {high})"


def duration(seconds: float) -> str:
    """Formats a number with three digits."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size or unit == "µs":
            number = seconds / size
            return f"{number:.{max(0, 2 - len(str(int(number))) + 1)}f} {unit}" if number < 100 else f"{number:.0f} {unit}"
    raise AssertionError


def parts(measured: dict[str, Any]) -> dict[str, str]:
    """Returns the texts between the markers, by name."""
    import problem

    versions = measured["versions"]
    said = ", ".join(f"{NAMES.get(name, 'NumPy')} {version}" for name, version in versions.items())
    found = {
        "machine": f"Measured in {measured['month']} on {measured['machine']}, with Python {measured['python']}, {said}. "
        f"Load of the machine: {measured['load']:.1f} of its processors. "
        f"A process that has imported NumPy alone has {measured['idle'] / 1e6:.0f} MB.\n"
    }
    for of in problem.PROBLEMS:
        text = f"{of.text} Error: {of.error_of}.{' ' + of.without if of.without else ''}\n\n"
        found[of.folder] = text + table(of.folder, measured["problems"][of.folder])
    found["small_meshes"] = small_meshes(measured.get("small_meshes", {}))
    return found


def between(text: str, name: str) -> tuple[int, int]:
    """Returns the position in the page of the part with a name."""
    begin, end = BEGIN.format(name), END.format(name)
    if text.count(begin) != 1 or text.count(end) != 1:
        raise SystemExit(f"{PAGE.name} has no part {name!r} between its markers")
    return text.index(begin) + len(begin), text.index(end)


def write(measured: dict[str, Any]) -> None:
    text = PAGE.read_text()
    for name, part in parts(measured).items():
        first, last = between(text, name)
        text = text[:first] + part + text[last:]
    PAGE.write_text(text)


def check(measured: dict[str, Any]) -> int:
    """Compares the page with the generated one. Each column in which polhode is behind needs a paragraph with the reason."""
    import problem

    text, wrong = PAGE.read_text(), []
    for name, part in parts(measured).items():
        first, last = between(text, name)
        if text[first:last] != part:
            wrong.append(f"{PAGE.name}: the part {name!r} is not what was measured of these programs: measure, or --page")
    for of in problem.PROBLEMS:
        _, last = between(text, of.folder)
        prose = text[last:].split("<!-- begin")[0]
        for column in behind(of.folder, measured["problems"][of.folder]):
            if f"**{COLUMNS[column].capitalize()}.**" not in prose:
                wrong.append(f"{PAGE.name}: polhode is behind in {COLUMNS[column]} of {of.folder}, and no paragraph **{COLUMNS[column].capitalize()}.** says why")
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    return 1 if wrong else 0
