"""How a notebook shows a motion: its data in each output, packed, and the viewer once.

The viewer goes into the first output of a kernel that shows a motion, and into that cell's again whenever it is run again. Outputs of the same document find it there, in a
notebook without a kernel and in pages made of it too. Who is no kernel of Jupyter's, or shows each output in a document of its own, gets it every time.
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

_FALLBACK = "A motion in three dimensions. It is shown where this notebook is trusted and scripts run: in Jupyter by “Trust Notebook”, and on pages that nbconvert makes."


@cache
def viewer() -> tuple[str, bytes]:
    """What names the viewer, and the viewer: the page without data, deflated."""
    packed = zlib.compress(_native.motion_page("motion", "").encode(), 9)
    return hashlib.sha256(packed).hexdigest()[:16], packed


def html(title: str, data: str, *, beside_widget: bool = False, brings_viewer: bool | None = None) -> str:
    """An output that shows a motion, whose page has these data; one beside a widget is seen where the widget is not. Whether it brings the viewer is known of an output that is there already."""
    key, packed = viewer()
    brought = ""
    if _outputs.brings_viewer() if brings_viewer is None else brings_viewer:
        brought = f'<script type="text/plain" class="polhode-viewer" data-key="{key}">{base64.b64encode(packed).decode("ascii")}</script>'
    return (
        f'<div class="polhode-motion" data-viewer="{key}"{" data-beside" if beside_widget else ""} style="min-height: 40px"><p>{escape(title)}: {_FALLBACK}</p>{brought}'
        f'<script type="text/plain" class="polhode-packed">{base64.b64encode(pack(data)).decode("ascii")}</script><script>{_script()}</script></div>'
    )


def pack(data: str) -> bytes:
    """Returns what a page holds as JSON, deflated; ``viewer/src/packed.ts`` reads it."""
    return zlib.compress(data.encode(), 9)


def data_of(page: str) -> str:
    """What a page holds."""
    return page.partition('<script id="polhode-data" type="application/json">')[2].partition("</script>")[0]


@cache
def _script() -> str:
    return Path(__file__).with_name("_display.js").read_text("utf-8")


def is_notebook() -> bool:
    """Whether outputs are in one document of a kernel's."""
    return _shell() is not None


def brings_viewer() -> bool:
    """Whether the output that is made now is to bring the viewer."""
    return _outputs.brings_viewer()


class _Cell:
    """The cell whose output has the viewer."""

    def __init__(self) -> None:
        self._kernel: object = None
        self._id: object = None
        self._count = 0

    def brings_viewer(self) -> bool:
        """Whether the output that is made now is to bring the viewer."""
        shell = _shell()
        if shell is None:
            return True
        kernel = shell.kernel
        cell = kernel.get_parent("shell").get("metadata", {}).get("cellId")  # which not all programs tell
        is_again = cell is not None and cell == self._id and shell.execution_count != self._count
        if kernel is self._kernel and not is_again:
            return False
        self._kernel, self._id, self._count = kernel, cell, shell.execution_count
        return True


_outputs = _Cell()


def _shell() -> Any:
    """The shell of a kernel whose outputs are in one document; ``None`` of any other program."""
    if "IPython" not in sys.modules or "google.colab" in sys.modules:
        return None
    shell = sys.modules["IPython"].get_ipython()
    return shell if hasattr(getattr(shell, "kernel", None), "get_parent") else None
