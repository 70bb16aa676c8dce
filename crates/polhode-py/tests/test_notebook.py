"""What notebooks show, and figures."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import polhode
import pytest
from polhode import plot, shapes


class Reader(HTMLParser):
    """Tags that close as they open."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def read(html: str) -> Reader:
    reader = Reader()
    reader.feed(html)
    reader.close()
    assert not reader.open
    return reader


def test_a_body_is_a_table(generic: polhode.MassProperties) -> None:
    shown = read(generic._repr_html_()).text
    for number in (*generic.inertia.ravel(), *generic.moments, generic.mass):
        assert f"{number:.6g}" in shown
    body = polhode.Body({"<script>": generic, "ball": shapes.sphere(radius=0.1, mass=1.0)})
    assert "<script>" in read(body._repr_html_()).text


def test_figures_show_the_numbers(examples: Path, tmp_path: Path) -> None:
    motion = polhode.simulate(examples / "heavy-top.toml")
    for figure, columns in (
        (plot.omega(motion), motion.omega),
        (plot.attitude(motion), motion.attitude),
        (plot.momentum(motion), motion.momentum),
        (plot.energy(motion), np.column_stack([motion.kinetic_energy, motion.potential_energy])),
    ):
        (axes,) = figure.axes
        for line, column in zip(axes.lines, columns.T):
            assert np.array_equal(line.get_xdata(), motion.times) and np.array_equal(line.get_ydata(), column)
        figure.savefig(tmp_path / "figure.png")
        assert (tmp_path / "figure.png").stat().st_size > 5000


def test_axes_may_be_given() -> None:
    from matplotlib.figure import Figure

    free, figure = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01]), Figure()
    flat, solid = figure.add_subplot(1, 2, 1), figure.add_subplot(1, 2, 2, projection="3d")
    assert plot.omega(free, ax=flat) is figure and plot.polhode(free, ax=solid) is figure
    assert len(flat.lines) == 3 and len(solid.lines) == 1 and len(figure.axes) == 2
    for wrong in (lambda: plot.omega(free, ax=solid), lambda: plot.polhode(free, ax=flat)):
        with pytest.raises(polhode.PolhodeError, match="projection"):
            wrong()
    with pytest.raises(TypeError, match="axes of Matplotlib, not str"):
        plot.omega(free, ax="left")  # type: ignore[arg-type]


def test_a_fresh_notebook_shows_figures() -> None:
    """Nobody asked for ``%matplotlib``: what IPython asks of an object it shows."""
    figure = plot.omega(polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01]))
    assert figure._repr_png_().startswith(b"\x89PNG")
    from IPython.core.formatters import DisplayFormatter  # of ipykernel, which the gate installs

    data, _ = DisplayFormatter().format(figure)
    assert data["image/png"].startswith(b"\x89PNG")


def test_a_polhode_lies_on_its_ellipsoid(generic: polhode.MassProperties) -> None:
    motion = polhode.FreeMotion(inertia=generic, omega=[0.9, -1.3, 0.7])
    (axes,) = plot.polhode(motion).axes
    path = np.array(axes.lines[0].get_data_3d())
    assert np.allclose(0.5 * motion.moments @ path**2, motion.kinetic_energy, rtol=1e-12)
    with pytest.raises(polhode.PolhodeError, match="inertia ellipsoid"):
        plot.polhode(polhode.FreeMotion(moments=[1, 2, 3], omega=[0, 0, 0]))
