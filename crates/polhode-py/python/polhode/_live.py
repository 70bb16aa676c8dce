"""Interactive motion of a scenario in a notebook."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from . import _arrays
from ._knob import Knobs, knobs_of
from ._scenario import Scenario

if TYPE_CHECKING:
    from ._widget import MotionWidget


def widget(scenario: Scenario | str | os.PathLike[str], knobs: Knobs | None = None, *, error: str = "auto") -> MotionWidget:
    """Shows the motion of a scenario in a notebook, with sliders for its numbers.

    It requires anywidget. Each change computes the motion in the kernel. During a computation, only
    the latest values wait for the next one. A value that is refused is shown with the reason, and
    the motion remains as it was. Each number has a slider and an input field, and everything can be
    used with the keyboard.

    Parameters
    ----------
    scenario
        A :class:`Scenario`, its file, or its text: a ``str`` of more than one line.
    knobs
        Keys of its numbers as in scenario files, such as ``"start.spin.body[2]"``,
        ``"torque[0].coefficient"`` or ``'body.part["rotor"].mass'``, or as the arguments of
        :class:`Scenario`, ``"start.omega[2]"``. Also a mapping from keys to a :class:`Knob` or to
        the ends ``(low, high)`` of its slider. The default is the four most informative numbers.
    error
        Method of the error estimate, as for :func:`simulate`.

    Returns
    -------
    MotionWidget
        Widget with the current :class:`Motion` in ``motion``, its scenario in ``scenario``, and the
        values of the knobs in ``values``, which can be set.

    Raises
    ------
    PolhodeError
        If a key is not a number of the scenario (the message lists similar keys), and as for
        :func:`simulate`.

    Examples
    --------
    >>> import polhode
    >>> from polhode.scenario import Part, Run, Start
    >>> racket = polhode.Scenario(
    ...     Part(shape="box", size=["20 cm", "13 cm", "3 cm"], mass="0.6 kg"),
    ...     start=Start(omega=["0.01 rad/s", "5 rad/s", "0.02 rad/s"]),
    ...     run=Run(duration=4, samples=401),
    ... )
    >>> live = polhode.widget(racket, {"start.omega[1]": (0, 20), "body[0].size[1]": polhode.Knob(low=1, high=19, label="width")})
    >>> live
    MotionWidget(a scenario: ωy = 5 rad/s, width = 13 cm)
    >>> live.values = {"start.spin.body[1]": 12}
    >>> float(live.motion.omega[0, 1])
    12.0
    >>> polhode.widget(racket, ["start.spin[1]"])
    Traceback (most recent call last):
    polhode.PolhodeError: knobs: the scenario has no number start.spin[1]
    hint: did you mean start.spin.body[1] or start.spin.body[2] or start.spin.body[0]?
    """
    error = _arrays.choice("error", error, ["auto", "cheap", "thorough"])
    given = scenario if isinstance(scenario, Scenario) else Scenario.from_toml(scenario)
    asked = knobs_of(given, knobs)
    try:
        from ._widget import MotionWidget
    except ImportError as problem:
        raise ImportError("widgets need anywidget: pip install anywidget") from problem
    return MotionWidget(given, asked, error)
