"""What an output of a notebook has of a motion: how much, how exactly, and when with the viewer."""

from __future__ import annotations

import base64
import json
import re
import struct
import zlib
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import polhode
import pytest
import trimesh
from nbclient import NotebookClient
from polhode import _display, _packed
from polhode.scenario import Part, Run, Start

#: What an output that shows a motion may add to a notebook, bytes of its file.
MOST = 200_000
#: And the viewer, once.
VIEWER = 400_000

LONG = """
[[body.part]]
shape = "box"
size = ["20 cm", "13 cm", "3 cm"]
mass = "0.6 kg"
[start]
spin = {{ body = [0.01, {spin}, 0.02] }}
[[torque]]
model = "drag"
law = "linear"
coefficient = "1e-5 N m s"
[run]
duration = "20 s"
samples = {samples}
"""


def unpacked(packed: bytes) -> dict[str, Any]:
    """As `viewer/src/packed.ts` does it, written here once more."""
    raw = zlib.decompress(packed)
    (length,) = struct.unpack_from("<I", raw)
    text, rows = raw[4 : 4 + length], np.frombuffer(raw[4 + length :], np.uint8)

    def row(kind: str, at: int, count: int, bytes: int, order: int, zero: list[float], per: list[float]) -> np.ndarray:
        planes = rows[at : at + bytes * count * len(zero)].reshape(bytes, len(zero), count).astype(np.uint32)
        code = sum((plane << np.uint32(8 * k) for k, plane in enumerate(planes)), np.zeros((len(zero), count), np.uint32))
        whole = (code >> np.uint32(1)) ^ (np.uint32(0) - (code & np.uint32(1)))
        for _ in range(order):
            whole = np.cumsum(whole, axis=1, dtype=np.uint32)
        if kind == "float":
            return (whole << np.uint32(12)).view(np.float32).astype(float).T
        return ((np.array(zero)[:, None] + whole) / np.array(per)[:, None]).T

    def filled(value: Any) -> Any:
        if isinstance(value, list):
            return [filled(one) for one in value]
        if not isinstance(value, dict):
            return value
        return row(**value["row"]) if "row" in value else {name: filled(one) for name, one in value.items()}

    page: dict[str, Any] = filled(json.loads(text))
    return page


def rows_of(value: Any, place: str = "") -> dict[str, str]:
    """The rows of a page's JSON, by their places: what is base64 and long enough to be no word."""
    if isinstance(value, dict):
        return {found: row for key, one in value.items() for found, row in rows_of(one, f"{place}.{key}").items()}
    if isinstance(value, list):
        return {found: row for k, one in enumerate(value) for found, row in rows_of(one, f"{place}[{k}]").items()}
    return {place: value} if isinstance(value, str) and re.fullmatch(r"[A-Za-z0-9+/]{80,}={0,2}", value) else {}


def at(page: Any, place: str) -> Any:
    for key, k in re.findall(r"\.(\w+)|\[(\d+)\]", place):
        page = page[key] if key else page[int(k)]
    return page


EXAMPLES = ["t-handle", "bracket", "water", "cubesat", "flat-spin", "gimbals", "eulers-disk", "rattleback", "heavy-top"]


@pytest.mark.parametrize("name", EXAMPLES)
def test_what_is_packed_is_what_the_page_has(examples: Path, name: str) -> None:
    motion = polhode.simulate(examples / f"{name}.toml", error="cheap")
    packed = _packed.pack(motion._output_data)
    page, given = unpacked(packed), json.loads(motion._output_data)
    assert page["facts"] == given["facts"] and page["explanation"] == given["explanation"] and page["title"] == given["title"]
    rows = rows_of(given)
    assert {".motion.times", ".motion.attitude", ".motion.omega"} <= rows.keys()
    for place, row in rows.items():
        found = at(page, place)
        assert isinstance(found, np.ndarray), f"{place} is not packed"
        kind = "<u4" if place.endswith(".triangles") else "<f4" if ".shapes[" in place else "<f8"
        wanted = np.frombuffer(base64.b64decode(row), kind).astype(float).reshape(found.shape)
        if ".drift[" in place:
            assert np.allclose(found, wanted, rtol=2.0**-11, atol=1e-37), place
        elif place.endswith(".triangles"):
            assert np.array_equal(found, wanted), place
        else:
            range_of = wanted.max(0) - wanted.min(0)
            bits = 15 if ".shapes[" in place else 19 if place.startswith(".free") else 23
            assert (abs(found - wanted) <= range_of * 2.0**-bits + np.spacing(abs(wanted).max())).all(), place
            assert (found[wanted == 0.0] == 0.0).all(), place


def test_many_samples_are_fewer_where_they_must_be(examples: Path) -> None:
    motion = polhode.simulate(examples / "eulers-disk.toml", error="cheap")
    whole = json.loads(motion._page_data)
    # Noise, which nothing packs.
    random = np.random.default_rng(1)
    for table in (whole["motion"], whole["motion"]["contact"]):
        for name, row in table.items():
            if name != "times" and isinstance(row, str) and rows_of(row):
                table[name] = base64.b64encode(random.normal(size=len(base64.b64decode(row)) // 8).tobytes()).decode()
    packed = _packed.pack(json.dumps(whole))
    page = unpacked(packed)
    assert len(packed) <= _packed.MOST
    count, times = page["motion"]["count"], page["motion"]["times"][:, 0]
    assert count == len(times) < whole["motion"]["count"] and np.isclose(times[-1], motion.times[-1], rtol=1e-7)
    assert page["findings"][-1]["message"] == "this notebook shows every 2nd of its samples; page() has them all"


def test_a_fine_mesh_is_coarser_in_an_output(tmp_path: Path) -> None:
    trimesh.creation.icosphere(subdivisions=6).apply_scale([0.1, 0.2, 0.3]).export(tmp_path / "fine.stl")
    body = Part(shape="mesh", file=tmp_path / "fine.stl", unit="m", density="1000 kg/m^3")
    motion = polhode.simulate(polhode.Scenario(body, start=Start(omega=[0.1, 3, 0.2]), run=Run(duration=60, samples=10_001)))
    assert len(_packed.pack_text(motion._output_data)) < MOST
    shown, whole = (unpacked(_packed.pack(data))["body"]["shapes"][0] for data in (motion._output_data, motion._page_data))
    assert 9_000 < len(shown["triangles"]) <= 10_000 < len(whole["triangles"]) and shown["of"] == 81_920
    assert "made coarser" in json.dumps(unpacked(_packed.pack(motion._output_data))["facts"])


def outputs(sources: list[str]) -> list[dict[str, Any]]:
    """What the last output of each cell is, in a notebook that a kernel has run."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in sources])
    NotebookClient(notebook, timeout=60, kernel_name="python3").execute()
    return [dict(cell.outputs[-1]) for cell in notebook.cells if cell.outputs]


def test_each_output_that_shows_a_motion_is_small(examples: Path) -> None:
    def motion(name: str) -> str:
        return f"polhode.simulate({str(examples / name)!r}, error='cheap')"

    shown = outputs(
        [
            "import polhode, warnings\nwarnings.simplefilter('ignore')",
            f"text = {LONG!r}",
            "polhode.simulate(text.format(spin=5, samples=1001))",
            "polhode.simulate(text.format(spin=5, samples=10_000))",
            "polhode.simulate(text.format(spin=500, samples=10_000))",
            "polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])",
            *(motion(f"{name}.toml") for name in EXAMPLES),
        ]
    )
    sizes = [len(json.dumps(output, ensure_ascii=False).encode()) for output in shown]
    assert len(sizes) == 4 + len(EXAMPLES)
    assert MOST < sizes[0] <= MOST + VIEWER, "the first has the viewer"
    assert max(sizes[1:]) <= MOST, sizes


def test_who_is_no_kernel_gets_the_viewer_each_time() -> None:
    motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
    for _ in range(2):
        html = motion._repr_html_()
        key, packed = _display.viewer()
        assert f'data-key="{key}">{base64.b64encode(packed).decode()}</script>' in html


class Kernel:
    """As much of a kernel as is asked."""

    cell: str | None = None

    def get_parent(self, channel: str) -> dict[str, Any]:
        return {"metadata": {} if self.cell is None else {"cellId": self.cell}}


class Shell:
    def __init__(self) -> None:
        self.kernel, self.execution_count = Kernel(), 0

    def run(self, cell: str | None) -> bool:
        self.kernel.cell = cell
        self.execution_count += 1
        return _display._outputs.brings_viewer()


def test_the_viewer_stays_where_it_was_brought(monkeypatch: pytest.MonkeyPatch) -> None:
    shell = Shell()
    monkeypatch.setattr(_display, "_outputs", _display._Cell())
    monkeypatch.setattr(_display, "_shell", lambda: shell)
    assert [shell.run("a"), _display._outputs.brings_viewer(), shell.run("b")] == [True, False, False]
    assert [shell.run("a"), shell.run("b"), shell.run(None)] == [True, False, False], "the first cell was run again"
    other = Shell()
    monkeypatch.setattr(_display, "_shell", lambda: other)
    assert [other.run(None), other.run(None)] == [True, False], "of a kernel that was started anew"


def test_an_output_holds_no_markup_of_others() -> None:
    text = LONG.format(spin=1, samples=11).replace("[[body.part]]", 'title = "</script><img src=x>"\n[[body.part]]', 1)
    html = polhode.simulate(text)._repr_html_()
    assert "<img" not in html and html.count("<script") == html.count("</script>") == 3
    assert "&lt;/script&gt;&lt;img src=x&gt;" in html
