"""What a scenario's commands answer, by call: stability, torque, worked solutions, spins of two periods; densities that vary, parts, materials."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import polhode
import pytest
from conftest import ROOT

EXAMPLES = ROOT / "examples"

BODY = """
[[body.part]]
shape = "tensor"
mass = "2.3 kg"
center_of_mass = ["0.11 m", "-0.07 m", "0.23 m"]
inertia = [["3.1 kg m^2", "0.4 kg m^2", "-0.3 kg m^2"], ["0.4 kg m^2", "4.2 kg m^2", "0.2 kg m^2"], ["-0.3 kg m^2", "0.2 kg m^2", "5.3 kg m^2"]]
"""
TENSOR = np.array([[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]])


def command(*arguments: object) -> Any:
    run = subprocess.run([sys.executable, "-m", "polhode", *map(str, arguments)], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def test_stability_is_the_commands() -> None:
    for name in ("t-handle", "gravity-gradient", "heavy-top", "gyrostat", "rattleback", "air-brake"):
        path = EXAMPLES / f"{name}.toml"
        found = polhode.stability(path)
        assert found.to_dict() == command("stability", path, "--json"), name
        assert "\n" not in repr(found) and len(str(found)) > 100
        assert found == polhode.stability(path)


def test_permanent_rotations_turn_about_principal_axes() -> None:
    found = polhode.stability(BODY + '[start]\nspin = { body = [0.3, -0.2, 0.9] }\n')
    momentum = np.linalg.norm(TENSOR @ [0.3, -0.2, 0.9])
    moments, axes = np.linalg.eigh(TENSOR)
    assert len(found.rotations) == 6 and found.equilibrium is None and found.ground is None
    for rotation in found.rotations:
        assert np.linalg.norm(rotation.momentum) == pytest.approx(momentum, rel=1e-12)
        assert np.linalg.norm(np.cross(rotation.omega, rotation.momentum)) < 1e-12
        assert rotation.kinetic_energy == pytest.approx(0.5 * rotation.omega @ rotation.momentum, rel=1e-12)
        k = int(np.argmax(np.abs(axes.T @ rotation.omega)))
        a, b, c = moments[k], *np.delete(moments, k)
        rate = np.linalg.norm(rotation.omega) * np.sqrt(abs((a - b) * (a - c)) / (b * c))
        assert (rotation.frequency or rotation.growth_rate) == pytest.approx(rate, rel=1e-10)
        assert (rotation.stability == "unstable") == (k == 1) == (rotation.growth_rate is not None)
    with pytest.raises(ValueError, match="read-only"):
        found.rotations[0].omega[0] = 1.0


def test_an_equilibrium_on_an_orbit_and_a_motion_on_the_ground() -> None:
    equilibrium = polhode.stability(EXAMPLES / "gravity-gradient.toml").equilibrium
    assert equilibrium is not None and equilibrium.modes and equilibrium.attitude.shape == (4,)
    assert equilibrium.is_stable == all(mode.growth_rate <= 1e-12 for mode in equilibrium.modes)
    on_ground = polhode.stability(EXAMPLES / "rattleback.toml")
    assert on_ground.ground is not None and on_ground.motions == () and on_ground.ground.modes.shape[1] == 2
    for name, says in (("prescribed-table", "prescribed"), ("spinning-stage", "mass properties of .* change"), ("gyrocompass", r"in gimbals.*\nhint: polhode.simulate computes")):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.stability(EXAMPLES / f"{name}.toml")


PRESCRIBED = BODY + """
[prescribed]
axis = [2, -1, 1.5]
rate = "1.7 rad/s"
acceleration = "0.4 rad/s^2"

[run]
duration = "3 s"
samples = 4
"""


def test_a_torque_is_what_euler_says() -> None:
    masses, positions = [0.7, 1.1], np.array([[0.3, -0.1, 0.2], [-0.5, 0.4, 0.1]])
    needed = polhode.required_torque(PRESCRIBED, masses=masses, positions=positions)
    axis = np.array([2, -1, 1.5]) / np.linalg.norm([2, -1, 1.5])
    assert np.array_equal(needed.times, [0.0, 1.0, 2.0, 3.0]) and len(needed) == 4
    rates = 1.7 + 0.4 * needed.times
    assert np.allclose(needed.omega, rates[:, None] * axis, rtol=1e-14) and np.allclose(needed.acceleration, 0.4 * axis, rtol=1e-13)
    wanted = needed.acceleration @ TENSOR + np.cross(needed.omega, needed.omega @ TENSOR)
    assert np.allclose(needed.torque, wanted, rtol=0, atol=1e-13)
    assert np.allclose(needed.power, (needed.torque * needed.omega).sum(axis=1), rtol=1e-13)
    energy = 0.5 * (needed.omega * (needed.omega @ TENSOR)).sum(axis=1)
    assert np.allclose(needed.work, energy - energy[0], rtol=0, atol=1e-12)
    center = np.array([0.11, -0.07, 0.23])
    arms = positions - center
    for k, (mass, arm) in enumerate(zip(masses, arms)):
        force = mass * (np.cross(needed.acceleration, arm) + np.cross(needed.omega, np.cross(needed.omega, arm)))
        assert np.allclose(needed.forces[:, k], force, rtol=0, atol=1e-13)
    assert needed.bearings is None
    columns = needed.columns()
    assert list(columns)[:2] == ["time_s", "omega_body_x_rad_s"] and np.array_equal(columns["force_2_body_y_n"], needed.forces[:, 1, 1])
    assert needed.to_arrow().schema.field("torque_space_z_n_m").metadata[b"unit"] == "N·m".encode()
    later = polhode.required_torque(PRESCRIBED, times=[0.5, 2.0])
    assert np.allclose(later.torque[1], needed.torque[2], rtol=1e-13) and later.forces.shape == (2, 0, 3)


def test_a_shaft_has_bearings_and_the_answer_is_the_commands() -> None:
    for name in ("shaft", "slew", "prescribed-table"):
        path = EXAMPLES / f"{name}.toml"
        needed = polhode.required_torque(path)
        assert needed.to_dict() == command("torque", path, "--json"), name
    shaft = polhode.required_torque(EXAMPLES / "shaft.toml")
    assert shaft.bearings is not None and shaft.bearings.shape == (len(shaft), 2, 3) and np.abs(shaft.bearings).max() > 0.0
    assert list(shaft.columns())[-1] == "bearing_2_body_z_n"
    for call, says in (
        (lambda: polhode.required_torque(BODY), r"no \[prescribed\] motion"),
        (lambda: polhode.required_torque(PRESCRIBED, masses=[1.0]), "give masses and positions together"),
        (lambda: polhode.required_torque(PRESCRIBED, times=[0.0, 0.0]), r"times\[0\] = 0.0 must be later than the one before it"),
        (lambda: polhode.required_torque(PRESCRIBED, masses=[-1.0], positions=[[0, 0, 0]]), r"masses\[0\] = -1.0 must be positive"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            call()


def test_a_worked_solution_has_all_its_forms() -> None:
    path = EXAMPLES / "t-handle.toml"
    solution = polhode.explain(path)
    assert solution.to_dict() == command("explain", path, "--json")
    for form, flag in ((solution.markdown, "--markdown"), (solution.html, "--html"), (solution.latex, "--latex")):
        said = subprocess.run([sys.executable, "-m", "polhode", "explain", str(path), flag], capture_output=True, text=True, check=True).stdout
        assert form.split() == said.split(), flag
    assert solution._repr_markdown_() == solution.markdown and "$" in solution.markdown
    assert str(solution) == solution.text and "\n" not in repr(solution)
    assert polhode.explain(path.read_text()).title == solution.title


def test_scenarios_that_are_objects_are_asked_too() -> None:
    from polhode import scenario

    one = polhode.Scenario.from_toml(EXAMPLES / "t-handle.toml")
    assert polhode.stability(one).rotations == polhode.stability(EXAMPLES / "t-handle.toml").rotations
    assert polhode.explain(one).title == polhode.explain(EXAMPLES / "t-handle.toml").title
    pushed = one.replace(torques=[scenario.FunctionTorque(function=lambda t, omega, attitude, momentum: (0.0, 0.0, 0.1))])
    with pytest.raises(polhode.PolhodeError, match="FunctionTorque"):
        polhode.explain(pushed)


def test_spins_have_their_periods() -> None:
    day = 86_400.0
    for convention, periods in (("long", (7.40, 5.38)), ("short", (2.1, 5.3))):
        for body in ({"moments": [3.0836, 3.235, 1.0]}, {"inertia": TENSOR}, {"inertia": polhode.MassProperties(mass=1.0, inertia=TENSOR)}):
            try:
                found = polhode.spins_from_periods(**body, periods=[p * day for p in periods], convention=convention)
            except polhode.PolhodeError as refused:
                assert "no spin of this body" in str(refused) and body != {"moments": [3.0836, 3.235, 1.0]}
                continue
            assert len(found) == len(found.spins) >= 1 and found.periods == (periods[0] * day, periods[1] * day)
            for one in found:
                motion = one.motion
                assert motion.regime == one.regime and np.linalg.norm(motion.momentum) == pytest.approx(one.momentum, rel=1e-9)
                if one.regime == f"{convention}_axis":
                    assert motion.precession_period == pytest.approx(periods[0] * day, rel=1e-8)
                    assert motion.rotation_period == pytest.approx(periods[1] * day, rel=1e-8)
    wanted = command("spin", "--moments", "3.0836,3.235,1", "--periods", "7.40 d, 5.38 d", "--convention", "long", "--json")
    assert polhode.spins_from_periods(moments=[3.0836, 3.235, 1.0], periods=[7.40 * day, 5.38 * day], convention="long").to_dict()["spins"] == wanted["spins"]
    for call, says in (
        (lambda: polhode.spins_from_periods(moments=[1, 2, 2.5], periods=[1, -1], convention="long"), r"periods\[1\] = -1.0 must be positive"),
        (lambda: polhode.spins_from_periods(moments=[1, 2, 2.5], periods=[1, 1], convention="middle"), "convention = 'middle' must be one of long, short"),
        (lambda: polhode.spins_from_periods(periods=[1, 1], convention="long"), "exactly one"),
        (lambda: polhode.spins_from_periods(moments=[1, 2, 2.5], periods=[1.0, 1e9], convention="short"), "the other convention"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            call()


def test_materials_are_those_of_meshes() -> None:
    known = polhode.materials()
    assert known["aluminium"] == 2700.0 and len(known) > 20 and list(known) == sorted(known)
    for name, density in known.items():
        assert polhode.shapes.box(size=[1, 1, 1], material=name).mass == pytest.approx(density)


def two_boxes(path: Path) -> Path:
    """Boxes of 2 × 1 × 1 and 1 × 1 × 3 cm, apart from each other, with names."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
    lines = []
    for k, (name, size, place) in enumerate((("wheel", [2, 1, 1], [0, 0, 0]), ("hub", [1, 1, 3], [5, -2, 0.5]))):
        lines += [f"o {name}", *(f"v {x} {y} {z}" for x, y, z in corners * size + place)]
        lines += [f"f {a + 8 * k} {b + 8 * k} {c + 8 * k}" for a, b, c in faces + 1]
    path.write_text("\n".join(lines) + "\n")
    return path


def test_parts_are_made_of_their_own(tmp_path: Path) -> None:
    path = two_boxes(tmp_path / "boxes.obj")
    wheel = polhode.shapes.box(size=[0.02, 0.01, 0.01], material="steel").placed(position=[0.01, 0.005, 0.005])
    hub = polhode.shapes.box(size=[0.01, 0.01, 0.03], mass=0.25).placed(position=[0.055, -0.015, 0.02])
    for parts, rest in (
        ({"wheel": "steel", "hub": {"mass": 0.25}}, {}),
        ({"wheel": {"density": 7850.0}}, {"mass": 0.25}),
        ({"hub": {"mass": 0.25}}, {"material": "steel"}),
    ):
        found = polhode.inertia(path, unit="cm", parts=parts, **rest)
        whole = wheel + hub
        assert found.mass == pytest.approx(whole.mass, rel=1e-12)
        assert np.allclose(found.center_of_mass, whole.center_of_mass, rtol=1e-12) and np.allclose(found.inertia, whole.inertia, rtol=1e-11, atol=1e-18)
    for parts, rest, says in (
        ({"tyre": "steel"}, {}, 'no part named "tyre"\nhint: its parts are "wheel", "hub"'),
        ({"wheel": "steel", "hub": "steel"}, {"density": 1.0}, "but every part is"),
        ({"wheel": "cheese"}, {}, "unknown material"),
        ({"wheel": {"density": -1.0}}, {}, r"parts\['wheel'\]\['density'\] = -1.0 must be positive"),
        ({"wheel": {"mass": 1.0, "density": 1.0}}, {}, "must have one of density, mass and material"),
        ({"wheel": 7850.0}, {}, r"parts\['wheel'\] must be a material or a dict, not float"),
        ("steel", {}, "parts must be a dict"),
        ({"wheel": "steel"}, {"union": True}, "parts and union are both given"),
    ):
        with pytest.raises((polhode.PolhodeError, TypeError), match=says):
            polhode.inertia(path, unit="cm", parts=parts, **rest)


def test_a_density_may_be_a_formula(tmp_path: Path) -> None:
    path = two_boxes(tmp_path / "boxes.obj")
    found = polhode.inertia(path, unit="cm", field="1000 + 2e4*x")
    # ∫ρ = ρ(centre) V of each, as the density is linear.
    masses = [(1000 + 2e4 * 0.01) * 2e-6, (1000 + 2e4 * 0.055) * 3e-6]
    assert found.mass == pytest.approx(sum(masses), rel=1e-9)
    # ∫x ρ = V (ρ₀ x̄ + k (x̄² + a²/12))
    first = sum(v * (1000 * x + 2e4 * (x * x + a * a / 12)) for v, x, a in ((2e-6, 0.01, 0.02), (3e-6, 0.055, 0.01)))
    assert found.center_of_mass[0] == pytest.approx(first / sum(masses), rel=1e-9)
    assert found.to_dict()["error_estimate"]["mass"] <= 1e-9 if "error_estimate" in found.to_dict() else True
    for options, says in (
        ({"field": "1000 + 2e4*q"}, "field: "),
        ({"field": "1000", "density": 1.0}, "field and density are both given"),
        ({"field": "1000", "union": True}, "field and union are both given"),
        ({"tolerance": 1e-6}, "tolerance has no effect without field"),
        ({"field": "x - 1"}, "density"),
    ):
        with pytest.raises(polhode.PolhodeError, match=says):
            polhode.inertia(path, unit="cm", **options)


def test_a_solution_by_lagrange_and_hamilton_is_that_of_the_command() -> None:
    path = EXAMPLES / "notes" / "11-04-pendulum.toml"
    for formalism, option in {"lagrange": "--lagrangian", "hamilton": "--hamiltonian"}.items():
        solution = polhode.explain(path, formalism=formalism)
        assert solution.to_dict() == command("explain", path, option, "--json")
    with pytest.raises(polhode.PolhodeError, match="must be one of newton, lagrange, hamilton"):
        polhode.explain(path, formalism="galilei")
