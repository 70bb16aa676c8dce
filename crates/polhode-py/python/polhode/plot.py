"""Figures of motions with Matplotlib. Each function returns a ``matplotlib.figure.Figure``.

They do not use ``pyplot``: a notebook shows the returned figure, and
``figure.savefig("omega.png")`` saves it. With ``ax=``, the functions draw into existing axes and
return their figure.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._arrays import Floats
from ._error import PolhodeError
from ._free_motion import FreeMotion
from ._motion import Motion

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Number of samples for a curve of a free motion.
SAMPLES = 2001


def omega(motion: FreeMotion | Motion, *, times: npt.ArrayLike | None = None, ax: Axes | None = None) -> Figure:
    """Plots ω in body axes over time.

    Only a free motion takes ``times``; the default is some periods.

    >>> import polhode
    >>> from polhode import plot
    >>> motion = polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])
    >>> figure = plot.omega(motion)
    >>> figure.axes[0].get_ylabel()
    'ω in the body (rad/s)'
    """
    at, rates, _ = _sampled(motion, times)
    figure, axes = _axes(ax)
    _lines(axes, at, rates, ["$ω_x$", "$ω_y$", "$ω_z$"], "ω in the body (rad/s)")
    return figure


def attitude(motion: FreeMotion | Motion, *, times: npt.ArrayLike | None = None, ax: Axes | None = None) -> Figure:
    """Plots the quaternion of the attitude over time."""
    at, _, quaternions = _sampled(motion, times)
    figure, axes = _axes(ax)
    _lines(axes, at, quaternions, ["w", "x", "y", "z"], "attitude (R_space_body)")
    return figure


def momentum(motion: Motion, *, ax: Axes | None = None) -> Figure:
    """Plots L in space axes over time. It is constant without torque."""
    _computed(motion)
    figure, axes = _axes(ax)
    _lines(axes, motion.times, motion.momentum, ["$L_x$", "$L_y$", "$L_z$"], "L in space (kg·m²/s)")
    return figure


def energy(motion: Motion, *, ax: Axes | None = None) -> Figure:
    """Plots the kinetic energy over time.

    Potential and total energy are added if every torque has a potential.
    """
    _computed(motion)
    figure, axes = _axes(ax)
    columns, names = [motion.kinetic_energy], ["T"]
    if motion.potential_energy is not None:
        columns += [motion.potential_energy, motion.kinetic_energy + motion.potential_energy]
        names += ["U", "T + U"]
    _lines(axes, motion.times, np.column_stack(columns), names, "energy (J)")
    return figure


def polhode(motion: FreeMotion, *, ax: Axes | None = None) -> Figure:
    """Plots the path of ω in principal axes, on the ellipsoid of constant kinetic energy.

    ``ax`` must have ``projection="3d"``.
    """
    if not isinstance(motion, FreeMotion):
        raise TypeError(f"motion must be a FreeMotion, whose ω stays on an ellipsoid, not {type(motion).__name__}")
    at, rates, _ = _sampled(motion, None)
    moments = motion.moments
    if not (moments > 0.0).all() or motion.kinetic_energy == 0.0:
        raise PolhodeError("a body at rest, or without inertia about an axis, has no inertia ellipsoid")
    figure, axes = _axes(ax, solid=True)
    radii = np.sqrt(2.0 * motion.kinetic_energy / moments)
    around, down = np.meshgrid(np.linspace(0.0, 2.0 * np.pi, 49), np.linspace(0.0, np.pi, 25))
    sphere = np.stack([np.cos(around) * np.sin(down), np.sin(around) * np.sin(down), np.cos(down)])
    axes.plot_wireframe(*(sphere * radii[:, None, None]), color="0.85", linewidth=0.5)
    axes.plot(*(rates @ motion.axes.T).T, color="C3")
    axes.set_box_aspect(radii)
    axes.set_xlabel("$ω_1$ (rad/s)")
    axes.set_ylabel("$ω_2$ (rad/s)")
    axes.set_zlabel("$ω_3$ (rad/s)")
    return figure


def _computed(motion: Motion) -> None:
    if not isinstance(motion, Motion):
        free = ": in a free motion it is constant" if isinstance(motion, FreeMotion) else ""
        raise TypeError(f"motion must be a Motion, not {type(motion).__name__}{free}")


def _sampled(motion: FreeMotion | Motion, times: npt.ArrayLike | None) -> tuple[Floats, Floats, Floats]:
    """Returns times, angular velocities and attitudes."""
    if isinstance(motion, Motion):
        if times is not None:
            raise PolhodeError("times are only for a FreeMotion: a Motion has its own times")
        return motion.times, motion.omega, motion.attitude
    if not isinstance(motion, FreeMotion):
        raise TypeError(f"motion must be a FreeMotion or a Motion, not {type(motion).__name__}")
    at = np.linspace(0.0, motion._sensible(), SAMPLES) if times is None else _arrays.numbers("times", times, ("n",))
    states = motion.at(at)
    return at, states.omega, states.attitude


def _axes(ax: Axes | None, solid: bool = False) -> tuple[Figure, Any]:
    """Returns the given axes with their figure, or new ones."""
    try:
        from matplotlib.axes import Axes

        from ._figure import ShownFigure
    except ImportError as error:
        raise ImportError("plots need Matplotlib: pip install matplotlib") from error
    if ax is None:
        made = ShownFigure(figsize=(6.0, 6.0) if solid else (8.0, 4.0), layout="constrained")
        return made, made.add_subplot(projection="3d" if solid else None)
    if not isinstance(ax, Axes):
        raise TypeError(f"ax must be axes of Matplotlib, not {type(ax).__name__}")
    if (ax.name == "3d") != solid:
        raise PolhodeError(f"ax has the projection {ax.name!r}, which this figure does not use", 'subplot_kw={"projection": "3d"} is for the polhode')
    figure = ax.get_figure(root=True)
    assert figure is not None  # removed axes have no figure, and cannot be used
    return figure, ax


def _lines(axes: Axes, times: Floats, rows: Floats, names: Sequence[str], label: str) -> None:
    axes.plot(times, rows, label=list(names))
    axes.set_xlabel("time t (s)")
    axes.set_ylabel(label)
    axes.grid(True, color="0.9")
    axes.legend(loc="upper right")
