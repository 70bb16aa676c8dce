"""From a scenario to a motion with knobs."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from . import _arrays
from ._knob import Knobs, knobs_of
from ._scenario import Scenario

if TYPE_CHECKING:
    from ._widget import MotionWidget


def widget(scenario: Scenario | str | os.PathLike[str], knobs: Knobs | None = None, *, error: str = "auto") -> MotionWidget:
    """The motion of a scenario in a notebook, with knobs for numbers of it: each turn computes the motion in the kernel. It needs anywidget.

    While one motion is computed, only the last values that the knobs have meanwhile wait for the next. A value that is refused is shown with the reason, and the
    motion stays. Knobs are sliders and numbers; all of it can be reached by keyboard.

    Parameters
    ----------
    scenario
        A :class:`Scenario`, its file, or its text: a ``str`` of more than one line.
    knobs
        Keys of its numbers as files have them, such as ``"start.spin.body[2]"``, ``"torque[0].coefficient"`` or ``'body.part["rotor"].mass'``, or as arguments of
        :class:`Scenario` are called, ``"start.omega[2]"``; or a mapping from keys to a :class:`Knob` or to the ends ``(low, high)`` of its slider. Without them, the four
        numbers that tell most.
    error
        As :func:`simulate` has it.

    Returns
    -------
    MotionWidget
        Its ``motion`` is the :class:`Motion` that is shown, its ``scenario`` what that is of, and its ``values`` what the knobs are at, which may be set.

    Raises
    ------
    PolhodeError
        Of a key that is no number of the scenario, with those that are near; and as :func:`simulate`.

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
