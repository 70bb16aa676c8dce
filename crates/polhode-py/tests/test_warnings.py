"""Warnings: of all that was decided on the way, once, and at the line of the user."""

from __future__ import annotations

import inspect
import pickle
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import polhode
import pytest
from conftest import PLAN
from polhode import batch, sweep

MESH = """
[[body.part]]
shape = "mesh"
file = "{file}"
material = "aluminium"

[start]
spin = {{ body = [0.1, 2, -0.3] }}

[run]
duration = "3 s"
samples = 4
"""

SWEEP = """
[sweep]
members = 9
seed = 7
sampling = "monte carlo"

[[sweep.vary]]
key = "start.spin.body[1]"
uniform = { from = 1, to = 3 }
"""

#: The Earth's, so fast that it lies within the Earth.
UNDERGROUND = """
[orbit]
rate = "0.5 rad/s"
[[torque]]
model = "gravity_gradient"
"""


def warned(call: Callable[[], object]) -> list[str]:
    """What is warned of at the call's own line, and nowhere else."""
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        call()
    first = inspect.getsourcelines(call)[1]
    for warning in heard:
        assert issubclass(warning.category, polhode.PolhodeWarning)
        assert (warning.filename, warning.lineno) == (__file__, first), f"{warning.filename}:{warning.lineno}: {warning.message}"
    return [str(warning.message) for warning in heard]


def test_warnings_point_at_the_line_of_the_user(examples: Path, tmp_path: Path) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(MESH.format(file=examples / "bracket.stl") + SWEEP)
    bodies = {"moments": [1.0, 2.0, 2.5], "omega": [[1e3, 2e3, -1e3]]}
    runaway = polhode.Ensemble(**bodies, torques='[[torque]]\nmodel = "formula"\naxes = "body"\ntorque = ["0", "0", "1[kg m^2 s]*wz^3"]\n')
    calls: dict[str, Callable[[], object]] = {
        "[mesh.unit]": lambda: polhode.inertia(path),
        "[mass.assumed]": lambda: polhode.inertia(examples / "meshes" / "bracket.3mf"),
        "[sweep.nominal]": lambda: polhode.simulate(path),
        "failed": lambda: runaway.at([2.0]),
        "[orbit.underground]": lambda: polhode.Ensemble(**bodies, torques=UNDERGROUND),
        "is it in mm?": lambda: batch.Plan(path),
        "about 68.8 m long": lambda: sweep.run(path, tmp_path / "out"),
    }
    for words, call in calls.items():
        said = warned(call)
        assert sum(words in message for message in said) == 1, (words, said)


def test_a_copy_does_not_say_it_again(examples: Path, tmp_path: Path) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(MESH.format(file=examples / "bracket.stl") + SWEEP)
    with pytest.warns(polhode.PolhodeWarning):
        things = [
            polhode.inertia(path),
            polhode.simulate(path),
            batch.Plan(path),
            polhode.Ensemble(moments=[1, 2, 2.5], omega=np.ones((2, 3)), torques=UNDERGROUND),
        ]
    assert warned(lambda: [pickle.loads(pickle.dumps(thing)) for thing in things]) == []
    assert warned(lambda: sweep.run(things[2], tmp_path / "out")) == []


def test_members_that_are_not_possible_are_said() -> None:
    impossible = PLAN.format(members=40).replace('sd = "0.8 kg"', 'sd = "8 kg"')
    said = warned(lambda: batch.Plan(impossible))
    assert len(said) == 1 and "tested members are invalid" in said[0] and said[0].endswith("[sweep.members]")
