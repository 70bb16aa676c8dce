"""Pages of the book with the measurements; their tables are between markers."""

from __future__ import annotations

import sys
from pathlib import Path
from statistics import median
from typing import Any

BOOK = Path(__file__).resolve().parents[2] / "book"
BEGIN, END = "<!-- begin: measured -->\n", "<!-- end: measured -->\n"

#: Names of engines and packages as printed, and the target overhead.
NAMES = {"dask": "Dask", "ray": "Ray"}
PACKAGES = {"polhode": "polhode", "distributed": "distributed", "ray": "Ray", "pyarrow": "PyArrow"}
BOUND = 0.15


def page(engine: str) -> Path:
    return BOOK / f"clusters-{engine}.md"


def overhead(rounds: list[dict[str, Any]], name: str, key: str) -> float:
    """Returns the median over the rounds of the relative overhead compared with the run in one process."""
    return float(median(of[name][key] / of["alone"][key] - 1.0 for of in rounds))


def part(engine: str, measured: dict[str, Any]) -> str:
    """Returns the text between the markers."""
    killed = f"{engine}, killed"
    # An incomplete round contributes its finished runs.
    rounds = [of for of in measured["rounds"] if "alone" in of and {engine, killed} & set(of)]
    undisturbed, disturbed = ([of for of in rounds if name in of] for name in (engine, killed))
    if not undisturbed or not disturbed:
        raise SystemExit(f"no round has the runs of {engine}: measure.py --more")
    hashes = {run["folder"] for of in measured["rounds"] for run in of.values()}
    if len(hashes) != 1:
        raise SystemExit(f"folders differ: {hashes}")
    workers, versions = measured["workers"], ", ".join(f"{PACKAGES[name]} {version}" for name, version in measured["versions"].items())
    out = (
        f"Measured in {measured['month']} on {measured['machine']}, with Python {measured['python']}, {versions}: "
        f"{measured['members']:,} members of `examples/sweeps/uncertain-satellite.toml`, {workers} threads or {workers} workers.\n\n"
        "| | time | processors' time | first part after | after the last part | others on the machine |\n|---|---|---|---|---|---|\n"
    )
    rows = {"alone": f"one process, {workers} threads", engine: f"{NAMES[engine]}, {workers} workers", killed: NAMES[engine] + ", workers killed: {}"}
    for number, of in enumerate(rounds, 1):
        for name, text in rows.items():
            if name in of:
                run = of[name]
                said = text.format(len(run["kills"])) + (f" (round {number})" if len(rounds) > 1 else "")
                out += (
                    f"| {said} | {run['time']:.0f} s | {run['processors']:.0f} s | {run['first']:.1f} s | {run['time'] - run['last']:.1f} s "
                    f"| {run['others']:.2f} processors |\n"
                )
    out += "\n**Overhead** over one process, of the processors' time: "
    kills = sum(len(of[killed]["kills"]) for of in disturbed)
    out += f"**{bounded(overhead(undisturbed, engine, 'processors'))}**; with {kills} workers killed {percent(overhead(disturbed, killed, 'processors'))}. "
    out += f"Of the time by the clock: {percent(overhead(undisturbed, engine, 'time'))}, and {percent(overhead(disturbed, killed, 'time'))} with workers killed.\n"
    return out + f"\nAll folders have the same bytes, SHA-256 of names and contents: `{hashes.pop()}`.\n"


def bounded(ratio: float) -> str:
    return f"{percent(ratio)}, {'within' if ratio <= BOUND else 'beyond'} the {100 * BOUND:.0f} % that are aimed at"


def percent(ratio: float) -> str:
    return f"{100 * ratio:.1f} %".replace("-", "−")


def between(text: str, engine: str) -> tuple[int, int]:
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        raise SystemExit(f"{page(engine).name} has no part between its markers")
    return text.index(BEGIN) + len(BEGIN), text.index(END)


def write(measured: dict[str, Any]) -> None:
    for engine in NAMES:
        text = page(engine).read_text()
        first, last = between(text, engine)
        page(engine).write_text(text[:first] + part(engine, measured) + text[last:])


def check(measured: dict[str, Any]) -> int:
    """Compares the pages with the generated ones; returns 1 if they differ, else 0."""
    wrong = []
    for engine in NAMES:
        text = page(engine).read_text()
        first, last = between(text, engine)
        if text[first:last] != part(engine, measured):
            wrong.append(f"{page(engine).name} does not say what was measured: measure.py --page")
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    return 1 if wrong else 0
