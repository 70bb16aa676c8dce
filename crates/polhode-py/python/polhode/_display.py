"""Display of a motion in a notebook: its packed data in each output, and the viewer once.

The viewer is part of a kernel's first output that shows a motion, and again of that cell's output
whenever the cell is run again. Other outputs of the same document find it there, also in a notebook
without a kernel and in pages made from it. Outside a Jupyter kernel, and in programs that show each
output in a document of its own, every output contains the viewer.
"""

from __future__ import annotations

import base64
import hashlib
import sys
import zlib
from functools import cache
from html import escape
from pathlib import Path
from typing import Any

from . import _native

_FALLBACK = "An interactive 3-D motion. It is shown if this notebook is trusted and scripts run: in Jupyter after “Trust Notebook”, and on pages from nbconvert."


@cache
def viewer() -> tuple[str, bytes]:
    """Returns a key that identifies the viewer, and the viewer: the page without data, deflated."""
    packed = zlib.compress(_native.motion_page("motion", "").encode(), 9)
    return hashlib.sha256(packed).hexdigest()[:16], packed


def html(title: str, data: str, *, beside_widget: bool = False, brings_viewer: bool | None = None) -> str:
    """Returns the HTML of an output that shows a motion.

    ``data`` is the JSON of the page. With ``beside_widget``, the output is visible only where the
    widget is not. ``brings_viewer`` says whether the output contains the viewer; give it for an
    output that exists already.
    """
    key, packed = viewer()
    brought = ""
    if _outputs.brings_viewer() if brings_viewer is None else brings_viewer:
        brought = f'<script type="text/plain" class="polhode-viewer" data-key="{key}">{base64.b64encode(packed).decode("ascii")}</script>'
    return (
        f'<div class="polhode-motion" data-viewer="{key}"{" data-beside" if beside_widget else ""} style="min-height: 40px"><p>{escape(title)}: {_FALLBACK}</p>{brought}'
        f'<script type="text/plain" class="polhode-packed">{base64.b64encode(pack(data)).decode("ascii")}</script><script>{_script()}</script></div>'
    )


def pack(data: str) -> bytes:
    """Returns the JSON of a page, deflated; ``viewer/src/packed.ts`` reads it."""
    return zlib.compress(data.encode(), 9)


def data_of(page: str) -> str:
    """Returns the JSON data of a page."""
    return page.partition('<script id="polhode-data" type="application/json">')[2].partition("</script>")[0]


@cache
def _script() -> str:
    return Path(__file__).with_name("_display.js").read_text("utf-8")


def is_notebook() -> bool:
    """Returns true if all outputs are in one document of a kernel."""
    return _shell() is not None


def brings_viewer() -> bool:
    """Returns true if the next output must contain the viewer."""
    return _outputs.brings_viewer()


class _Cell:
    """Tracks the cell whose output contains the viewer."""

    def __init__(self) -> None:
        self._kernel: object = None
        self._id: object = None
        self._count = 0

    def brings_viewer(self) -> bool:
        """Returns true if the next output must contain the viewer."""
        shell = _shell()
        if shell is None:
            return True
        kernel = shell.kernel
        cell = kernel.get_parent("shell").get("metadata", {}).get("cellId")  # not set by all programs
        is_again = cell is not None and cell == self._id and shell.execution_count != self._count
        if kernel is self._kernel and not is_again:
            return False
        self._kernel, self._id, self._count = kernel, cell, shell.execution_count
        return True


_outputs = _Cell()


def _shell() -> Any:
    """Returns the shell of a kernel whose outputs are in one document; ``None`` in any other
    program."""
    if "IPython" not in sys.modules or "google.colab" in sys.modules:
        return None
    shell = sys.modules["IPython"].get_ipython()
    return shell if hasattr(getattr(shell, "kernel", None), "get_parent") else None
