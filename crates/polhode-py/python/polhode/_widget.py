"""Notebook widget: sliders for numbers of a scenario, and the motion for their values."""

from __future__ import annotations

import asyncio
import secrets
import warnings
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from . import _display
from ._arrays import number
from ._error import PolhodeError, PolhodeWarning
from ._knob import with_values
from ._motion import Motion
from ._scenario import Scenario
from ._simulate import simulate

_HERE = Path(__file__).parent

#: Time without a change after which the stored output is updated, s.
RESTS = 0.5


class MotionWidget(anywidget.AnyWidget):
    """An interactive motion in a notebook, as :func:`polhode.widget` returns it.

    Attributes
    ----------
    values
        Values of the knobs by their keys in the scenario, in the units in which they are written.
        Setting them computes the motion and moves the sliders. Keys that are not set keep their
        values. A value that is refused raises :exc:`PolhodeError` and changes nothing.
    motion
        The current :class:`Motion`.
    scenario
        The :class:`Scenario` of the current motion.
    """

    _esm = (_HERE / "_widget.js").read_text("utf-8")
    _css = (_HERE / "_widget.css").read_text("utf-8")

    # Traits that the page's script uses: `viewer/src/notebook/widget.ts`.
    viewer_key = traitlets.Unicode().tag(sync=True)
    knobs = traitlets.List(traitlets.Dict()).tag(sync=True)
    #: Request of the page: a number that increases, and values.
    asked = traitlets.Dict().tag(sync=True)
    #: Answer to a request: its number, the values of the current motion, the refusal if any, and
    #: warnings.
    answer = traitlets.Dict().tag(sync=True)
    packed = traitlets.Bytes().tag(sync=True)

    def __init__(self, scenario: Scenario, knobs: list[dict[str, Any]], error: str) -> None:
        self._error = error
        self._first = scenario
        #: Identifier of the output next to the widget, once displayed, and whether it contains the
        #: viewer.
        self._stored: str | None = None
        self._brings_viewer: bool | None = None
        self._storing: asyncio.TimerHandle | None = None
        values = {knob["key"]: knob["value"] for knob in knobs}
        # An error at the start is raised to the caller.
        motion, notes = self._simulated(scenario)
        self._shown = scenario, motion
        super().__init__(
            viewer_key=_display.viewer()[0],
            knobs=knobs,
            asked={"turn": 0, "values": values},
            answer={"turn": 0, "values": values, "refusal": None, "notes": notes},
            packed=_display.pack(motion._output_data),
        )
        self.on_msg(self._bring)
        self.observe(self._turned, "asked")

    @property
    def motion(self) -> Motion:
        """The current motion."""
        return self._shown[1]

    @property
    def scenario(self) -> Scenario:
        """Scenario of the current motion."""
        return self._shown[0]

    @property
    def values(self) -> dict[str, float]:
        """Values of the knobs for the current motion, by key, in the units as written."""
        return dict(self.answer["values"])

    @values.setter
    def values(self, values: Mapping[str, float]) -> None:
        if not isinstance(values, Mapping):
            raise TypeError(f"values must be a mapping from keys to numbers, not {type(values).__name__}")
        unknown = [key for key in values if key not in self.answer["values"]]
        if unknown:
            raise PolhodeError(f"values: unknown knob {unknown[0]}", f"known knobs: {', '.join(self.answer['values'])}")
        new = {**self.answer["values"], **{key: number(key, value) for key, value in values.items()}}
        self._show(self.answer["turn"], new)

    def _show(self, turn: int, values: dict[str, float]) -> None:
        """Computes and shows the motion for these values; raises and changes nothing if it
        fails."""
        scenario = with_values(self._first, self.knobs, values)
        motion, notes = self._simulated(scenario)
        packed = _display.pack(motion._output_data)
        self._shown = scenario, motion
        with self.hold_sync():
            self.packed = packed
            self.answer = {"turn": turn, "values": values, "refusal": None, "notes": notes}
        self._store_later()

    def _turned(self, change: Mapping[str, Any]) -> None:
        """Answers a request of the page with a motion, or with the reason of a refusal."""
        turn, values = change["new"]["turn"], change["new"]["values"]
        try:
            self._show(turn, {knob["key"]: number(knob["key"], values[knob["key"]]) for knob in self.knobs})
        except PolhodeError as error:
            self._refuse(turn, values, error.message, error.hint)
        except KeyboardInterrupt:
            self._refuse(turn, values, "The computation was interrupted.", None)
        except Exception as error:  # raised by a torque that is a Python function
            self._refuse(turn, values, f"{type(error).__name__}: {error}", None)

    def _refuse(self, turn: int, values: Mapping[str, float], message: str, hint: str | None) -> None:
        shown = self.answer["values"]
        changed = [key for key, value in values.items() if value != shown.get(key)]
        key = changed[0] if len(changed) == 1 else None
        self.answer = {"turn": turn, "values": shown, "refusal": {"message": message, "hint": hint, "key": key}, "notes": []}

    def _simulated(self, scenario: Scenario) -> tuple[Motion, list[str]]:
        """Returns the motion, and the texts of its warnings."""
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always", PolhodeWarning)
            motion = simulate(scenario, error=self._error)
        return motion, [str(one.message) for one in heard]

    def _bring(self, _: object, message: object, __: object) -> None:
        """Sends the viewer to a page that does not have it."""
        key, viewer = _display.viewer()
        if isinstance(message, dict) and message.get("viewer") == key:
            self.send({"viewer": key}, [viewer])

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        """Returns the widget's output, with a static display of the motion for programs without
        widgets."""
        shown = super()._repr_mimebundle_(**kwargs)
        if shown is not None:
            shown[0]["text/html"] = self._html()
        return shown

    def _ipython_display_(self, **kwargs: Any) -> None:
        """Displays the widget, and a static output of the motion, which is hidden next to the
        widget.

        The static output is for notebooks without their kernel and for pages made from them.
        JupyterLab would show the widget of an output that has both, and nothing at all without the
        kernel.
        """
        display: Any = import_module("IPython.display").display
        if not _display.is_notebook():
            data, metadata = self._repr_mimebundle_(**kwargs) or ({"text/plain": repr(self)}, {})
            display(data, metadata=metadata, raw=True)
            return
        if self._stored is None:
            self._stored = secrets.token_hex(16)
            self._brings_viewer = _display.brings_viewer()
        display({"text/html": self._html(), "text/plain": ""}, raw=True, display_id=self._stored)
        shown = super()._repr_mimebundle_(**kwargs)
        if shown is not None:
            # The previous output suffices in programs without widgets.
            display({**shown[0], "text/html": ""}, metadata=shown[1], raw=True)

    def _html(self) -> str:
        motion = self.motion
        return _display.html(motion.title or "motion", motion._output_data, beside_widget=True, brings_viewer=self._brings_viewer)

    def _store_later(self) -> None:
        """Updates the static output with the current motion, once the knobs have not changed for a
        while."""
        if self._stored is None:
            return
        try:
            loop = asyncio.get_running_loop()
        except RuntimeError:
            self._store()
            return
        if self._storing is not None:
            self._storing.cancel()
        self._storing = loop.call_later(RESTS, self._store)

    def _store(self) -> None:
        update_display: Any = import_module("IPython.display").update_display
        update_display({"text/html": self._html(), "text/plain": ""}, raw=True, display_id=self._stored)

    def __repr__(self) -> str:
        at = ", ".join(f"{knob['label']} = {self.answer['values'][knob['key']]:g} {knob['unit']}".rstrip() for knob in self.knobs)
        return f"MotionWidget({self.motion.title or 'a scenario'}: {at})"
