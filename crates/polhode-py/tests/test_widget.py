"""The widget without a page: knobs by the scenario's keys, values, refusals, and what is sent."""

from __future__ import annotations

import asyncio
import base64
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest
from polhode import Knob, PolhodeError, _display, _widget
from polhode.scenario import Drag, FormulaTorque, FunctionTorque, Part, Run, Start


@pytest.fixture
def racket() -> polhode.Scenario:
    return polhode.Scenario(
        Part(name="racket", shape="box", size=["20 cm", "13 cm", "3 cm"], mass="0.6 kg"),
        start=Start(omega=["0.01 rad/s", "5 rad/s", "0.02 rad/s"]),
        torques=[Drag(name="air", law="linear", coefficient=1e-4)],
        run=Run(duration=2, samples=21),
    )


def base64_of(data: str) -> str:
    return base64.b64encode(_display.pack(data)).decode()


def turned(widget: Any, turn: int, **values: float) -> dict[str, Any]:
    """As the page does it; the answer."""
    names = {"spin": "start.spin.body[1]", "mass": "body.part[0].mass"}
    widget.asked = {"turn": turn, "values": {**widget.asked["values"], **{names[name]: value for name, value in values.items()}}}
    answer: dict[str, Any] = widget.answer
    return answer


def test_a_knob_names_a_number_of_the_scenario(racket: polhode.Scenario) -> None:
    asked = ['body.part["racket"].mass', "start.omega[1]", "torques[0].coefficient", "body[0].size[2]", "run.duration"]
    keys = [knob["key"] for knob in polhode.widget(racket, asked).knobs]
    assert keys == ["body.part[0].mass", "start.spin.body[1]", "torque[0].coefficient", "body.part[0].size[2]", "run.duration"]
    assert polhode.widget(racket, ['torque["air"].coefficient']).knobs[0]["unit"] == "kg·m²/s"
    assert len(polhode.widget(racket).knobs) == 4
    (knob,) = polhode.widget(racket, {"start.omega[1]": Knob(low=1, high=9, label="spin")}).knobs
    assert {name: knob[name] for name in ("label", "unit", "value", "low", "high")} == {"label": "spin", "unit": "rad/s", "value": 5, "low": 1, "high": 9}


@pytest.mark.parametrize(
    ("knobs", "message", "hint"),
    [
        (["start.spn.body[1]"], "no number start.spn.body[1]", "did you mean start.spin.body[1]"),
        (["torque[1].coefficient"], "no number torque[1].coefficient", "torque[0].coefficient"),
        (["nothing"], "no number nothing", "known: start.spin.body[0], "),
        (["body[0].shape"], "no number body[0].shape", ""),
        (["start.omega[1]", "start.spin.body[1]"], "start.spin.body[1] is given twice", ""),
        ({"start.omega[1]": (9, 1)}, "low = 9 of start.spin.body[1] must be less than high = 1", ""),
        ({"start.omega[1]": (6, 9)}, "start.spin.body[1] is 5 rad/s, which is not from 6 to 9", "in the unit of the number"),
        ([], "at least one key", ""),
    ],
)
def test_a_knob_that_is_none_is_refused(racket: polhode.Scenario, knobs: Any, message: str, hint: str) -> None:
    with pytest.raises(PolhodeError) as refused:
        polhode.widget(racket, knobs)
    assert message in refused.value.message and hint in (refused.value.hint or "")


@pytest.mark.parametrize("knobs", ["start.omega[1]", 3, {"start.omega[1]": 3}, {"start.omega[1]": "fast"}])
def test_knobs_of_another_type_are_refused(racket: polhode.Scenario, knobs: Any) -> None:
    with pytest.raises(TypeError, match="knobs"):
        polhode.widget(racket, knobs)
    with pytest.raises(PolhodeError, match="error"):
        polhode.widget(racket, error="none")


def test_the_motion_is_that_of_the_values(racket: polhode.Scenario) -> None:
    widget = polhode.widget(racket, ["start.omega[1]", "body[0].mass"])
    assert widget.motion == polhode.simulate(racket) and widget.scenario == racket
    answer = turned(widget, 1, spin=7.5, mass=1.2)
    assert answer == {"turn": 1, "values": {"start.spin.body[1]": 7.5, "body.part[0].mass": 1.2}, "refusal": None, "notes": []}
    heavier = Part(name="racket", shape="box", size=["20 cm", "13 cm", "3 cm"], mass="1.2 kg")
    wanted = polhode.simulate(racket.replace(body=heavier, start=Start(omega=["0.01 rad/s", "7.5 rad/s", "0.02 rad/s"])))
    assert widget.motion == wanted and polhode.simulate(widget.scenario) == wanted
    assert widget.packed == _display.pack(wanted._output_data)


def test_what_is_refused_leaves_the_motion(racket: polhode.Scenario) -> None:
    widget = polhode.widget(racket, ["start.omega[1]", "body[0].mass"])
    before, packed = widget.motion, widget.packed
    refusal = turned(widget, 1, mass=-1.0)["refusal"]
    assert 'mass = "-1.0 kg" must be positive' in refusal["message"] and refusal["hint"] and refusal["key"] == "body.part[0].mass"
    assert widget.motion is before and widget.packed == packed and widget.values["body.part[0].mass"] == 0.6
    assert turned(widget, 2, mass=0.9)["refusal"] is None and widget.motion is not before


def test_values_are_set_in_python(racket: polhode.Scenario) -> None:
    widget = polhode.widget(racket, ["start.omega[1]", "body[0].mass"])
    widget.values = {"start.spin.body[1]": 6}
    assert widget.values == {"start.spin.body[1]": 6.0, "body.part[0].mass": 0.6} and np.isclose(widget.motion.omega[0, 1], 6)
    before = widget.motion
    with pytest.raises(PolhodeError, match="must be positive"):
        widget.values = {"body.part[0].mass": 0.0}
    with pytest.raises(PolhodeError, match="unknown knob mass"):
        widget.values = {"mass": 1.0}
    with pytest.raises(PolhodeError, match="finite"):
        widget.values = {"body.part[0].mass": np.inf}
    with pytest.raises(TypeError, match="mapping"):
        widget.values = 3  # type: ignore[assignment]
    assert widget.motion is before


def test_functions_of_python_stay() -> None:
    scenario = polhode.Scenario(
        Part(shape="box", size=["20 cm", "13 cm", "3 cm"], mass="0.6 kg"),
        torques=[FunctionTorque(function=lambda t: [0.0, 0.0, 1e-3])],
        start=Start(omega=[0, 0, 0]),
        run=Run(duration=2, samples=21),
    )
    widget = polhode.widget(scenario, ["run.duration"])
    widget.values = {"run.duration": 4}
    assert widget.motion.times[-1] == 4 and widget.motion.omega[-1, 2] > 0
    # What stands for the function is no number of the scenario.
    with pytest.raises(PolhodeError, match=r"no number torque\[0\].torque\[2\]"):
        polhode.widget(scenario, ["torque[0].torque[2]"])
    with pytest.raises(PolhodeError, match="no number run.samples"):
        polhode.widget(scenario, ["run.samples"])


def test_what_a_function_raises_is_shown() -> None:
    def law(t: float, omega: Any) -> list[float]:
        if omega[2] > 1.0:
            raise RuntimeError("too fast for me")
        return [0.0, 0.0, 0.0]

    scenario = polhode.Scenario(
        Part(shape="box", size=[0.2, 0.1, 0.03], mass=0.6), torques=[FunctionTorque(function=law)], start=Start(omega=[0, 0, 0.5]), run=Run(duration=1, samples=11)
    )
    widget = polhode.widget(scenario, ["start.omega[2]"])
    widget.asked = {"turn": 1, "values": {"start.spin.body[2]": 2.0}}
    assert widget.answer["refusal"]["message"] == "RuntimeError: too fast for me" and widget.motion.omega[0, 2] == 0.5


def test_warnings_are_shown(racket: polhode.Scenario) -> None:
    pushed = racket.replace(torques=[FormulaTorque(axes="body", torque=["0", "1/(1.0 - t)", "0"], units="SI")])
    widget = polhode.widget(pushed, ["start.omega[1]"])
    assert widget.answer["notes"][-1].startswith("the motion ends at t = ") and widget.motion.ending.kind == "failed"


def test_the_viewer_is_sent_when_it_is_asked_for(racket: polhode.Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    widget = polhode.widget(racket)
    sent: list[Any] = []
    monkeypatch.setattr(widget, "send", lambda *message: sent.append(message))
    key, viewer = _display.viewer()
    widget._bring(widget, {"viewer": "another"}, [])
    widget._bring(widget, {"viewer": key}, [])
    assert sent == [({"viewer": key}, [viewer])]


def test_where_there_are_no_widgets_the_motion_is_an_output(racket: polhode.Scenario) -> None:
    widget = polhode.widget(racket, ["start.omega[1]"])
    data, _ = widget._repr_mimebundle_()
    assert data["text/plain"] == "MotionWidget(a scenario: ωy = 5 rad/s)" and "application/vnd.jupyter.widget-view+json" in data
    assert base64_of(widget.motion._output_data) in data["text/html"]


def test_a_notebook_has_the_motion_that_was_shown_last_beside_the_widget(racket: polhode.Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[tuple[str, dict[str, str]]] = []
    for name in ("display", "update_display"):
        monkeypatch.setattr(f"IPython.display.{name}", lambda data, *_, display_id=None, **__: shown.append((display_id, data)))
    widget = polhode.widget(racket, ["start.omega[1]"])
    widget._ipython_display_()
    assert [display_id for display_id, _ in shown] == [None] and "widget-view" in str(shown[0][1].keys())
    shown.clear()
    monkeypatch.setattr(_display, "is_notebook", lambda: True)
    monkeypatch.setattr(_display, "brings_viewer", lambda: True)
    widget.values = {"start.spin.body[1]": 6.0}
    assert shown == [], "it is not displayed yet"
    widget._ipython_display_()
    (name, stored), (none, live) = shown
    assert name is not None and none is None and live["text/html"] == "" and "application/vnd.jupyter.widget-view+json" in live
    assert "data-beside" in stored["text/html"] and 'class="polhode-viewer"' in stored["text/html"] and stored["text/plain"] == ""
    assert base64_of(widget.motion._output_data) in stored["text/html"]
    # Without a loop at once, with the viewer that it has brought.
    widget.values = {"start.spin.body[1]": 7.0}
    again, last = shown[-1]
    assert again == name and last["text/html"] != stored["text/html"] and 'class="polhode-viewer"' in last["text/html"]
    assert base64_of(widget.motion._output_data) in last["text/html"]
    with pytest.raises(PolhodeError):
        widget.values = {"start.spin.body[1]": float("nan")}
    assert len(shown) == 3

    async def turns() -> None:
        for k in range(5):
            widget.values = {"start.spin.body[1]": 8.0 + k}
        assert len(shown) == 3
        await asyncio.sleep(_widget.RESTS + 0.2)

    # In a kernel once, after the last of several turns.
    asyncio.run(turns())
    assert len(shown) == 4 and base64_of(widget.motion._output_data) in shown[-1][1]["text/html"]


def test_anywidget_is_imported_only_for_a_widget(tmp_path: Path) -> None:
    (tmp_path / "anywidget.py").write_text("raise ImportError('not here')\n")
    asked = "import sys; sys.path.insert(0, '.'); import polhode; assert 'anywidget' not in sys.modules; polhode.widget(sys.argv[1])"
    example = Path(__file__).parents[3] / "examples" / "t-handle.toml"
    found = subprocess.run([sys.executable, "-c", asked, example], cwd=tmp_path, capture_output=True, text=True)
    assert "ImportError: widgets need anywidget: pip install anywidget" in found.stderr
