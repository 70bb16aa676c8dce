"""Figures that display themselves in a notebook."""

from __future__ import annotations

import io

from matplotlib.figure import Figure


class ShownFigure(Figure):
    """A figure with its own PNG representation.

    IPython shows Matplotlib figures only after ``%matplotlib``.
    """

    def _repr_png_(self) -> bytes:
        png = io.BytesIO()
        self.savefig(png, format="png", dpi=self.dpi)
        return png.getvalue()
