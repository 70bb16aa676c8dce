# %% [markdown]
# # A robot engineer: is this URDF right, and what goes into it?
#
# Each cell runs as it is: `python robot_engineer.py`, or in an editor that knows `# %%`.

# %%
from pathlib import Path

import numpy as np
import polhode

EXAMPLES = Path(__file__).resolve().parents[1]

# %% [markdown]
# A description that somebody typed by hand. Every finding has its line, the rule, and the numbers.

# %%
report = polhode.check(EXAMPLES / "robots" / "bad-arm.urdf")
for finding in report:
    print(f"line {finding.line:3}  {finding.severity:10}  {finding.link}: {finding.message}")
assert not report.ok

# %% [markdown]
# A part from CAD: the mesh in millimetres, its material, and the `<inertial>` to be pasted. The origin of the mesh is the link's.

# %%
bracket = polhode.inertia(EXAMPLES / "bracket.stl", unit="mm", material="aluminium")
print(bracket)
print(bracket.export("urdf", name="bracket"))

# %% [markdown]
# Every link, and the whole arm below them. Then what the shoulder carries as one body: how much harder is it to tilt when it is stretched out?

# %%
arm = EXAMPLES / "robots" / "arm.urdf"
print(polhode.link_table(arm))
for elbow in (0, 55, 110):
    carried = polhode.inertia(arm, subtree="upper_arm", joints={"elbow": f"{elbow} deg"})
    at_shoulder = carried.inertia_about([0.0, 0.0, 0.0])
    print(f"elbow {elbow:4.0f}°   I_yy about the shoulder {at_shoulder[1, 1]:.4f} kg·m²")

# %% [markdown]
# A payload of known shape, held 12 cm in front of the flange and turned by 30° about z.

# %%
turn = [np.cos(np.pi / 12), 0, 0, np.sin(np.pi / 12)]
payload = polhode.shapes.box(size=[0.10, 0.06, 0.04], mass=0.8).placed(position=[0.12, 0, 0], rotation=turn)
tool = polhode.inertia(arm, link="hand") + payload
print(f"tool: {tool.mass:.3f} kg at {tool.center_of_mass.round(4)} m")
np.testing.assert_allclose(tool.mass, polhode.inertia(arm, link="hand").mass + 0.8)
