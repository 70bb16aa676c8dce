"""What an output of a notebook has of a motion: how much, and when with the viewer."""

from __future__ import annotations

import base64
import json
import re
import zlib
from pathlib import Path
from typing import Any

import nbformat
import polhode
import pytest
import trimesh
from nbclient import NotebookClient
from polhode import _display
from polhode.scenario import Part, Run, Start

#: What an output that shows a motion may add to a notebook, bytes of its file.
MOST = 550_000
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


def unpacked(output: str) -> dict[str, Any]:
    """The data in an output, as the viewer reads them."""
    (text,) = re.findall(r'class="polhode-packed">([^<]*)<', output)
    page: dict[str, Any] = json.loads(zlib.decompress(base64.b64decode(text)))
    return page


EXAMPLES = ["t-handle", "bracket", "water", "cubesat", "flat-spin", "gimbals", "eulers-disk", "rattleback", "heavy-top"]


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_output_has_the_data_of_the_page(examples: Path, name: str) -> None:
    motion = polhode.simulate(examples / f"{name}.toml", error="cheap")
    assert unpacked(motion._repr_html_()) == json.loads(motion._page_data)


def test_a_fine_mesh_is_coarser_in_an_output(tmp_path: Path) -> None:
    trimesh.creation.icosphere(subdivisions=6).apply_scale([0.1, 0.2, 0.3]).export(tmp_path / "fine.stl")
    body = Part(shape="mesh", file=tmp_path / "fine.stl", unit="m", density="1000 kg/m^3")
    motion = polhode.simulate(polhode.Scenario(body, start=Start(omega=[0.1, 3, 0.2]), run=Run(duration=60, samples=10_001)))
    output = motion._repr_html_()
    page, whole = unpacked(output), json.loads(motion._page_data)
    # Base64 of three indices of four bytes.
    shown, given = (len(data["body"]["shapes"][0]["triangles"]) // 16 for data in (page, whole))
    assert 9_000 < shown <= 10_000 < given and page["body"]["shapes"][0]["of"] == 81_920
    assert "simplified" in json.dumps(page["facts"]) and len(_display.pack(motion._output_data)) * 4 / 3 < MOST


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
    assert ['class="polhode-viewer"' in output["data"]["text/html"] for output in shown] == [True] + [False] * (len(shown) - 1)
    assert sizes[0] <= MOST + VIEWER
    assert max(sizes[1:]) <= MOST, sizes


def test_who_is_no_kernel_gets_the_viewer_each_time() -> None:
    motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
    for _ in range(2):
        html = motion._repr_html_()
        key, packed = _display.viewer()
        assert f'data-key="{key}">{base64.b64encode(packed).decode()}</script>' in html


class Kernel:
    """The parts of a kernel that the widget needs."""

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
    assert [other.run(None), other.run(None)] == [True, False], "of a kernel that was restarted"


def test_an_output_holds_no_markup_of_others() -> None:
    text = LONG.format(spin=1, samples=11).replace("[[body.part]]", 'title = "</script><img src=x>"\n[[body.part]]', 1)
    html = polhode.simulate(text)._repr_html_()
    assert "<img" not in html and html.count("<script") == html.count("</script>") == 3
    assert "&lt;/script&gt;&lt;img src=x&gt;" in html
