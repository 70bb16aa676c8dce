// The package as a user has it: the archive POLHODE_PACKAGE, installed into an empty folder.
import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

export const folder = mkdtempSync(join(tmpdir(), "polhode-npm-"));
writeFileSync(join(folder, "package.json"), '{"private": true, "type": "module"}');
execFileSync(process.platform === "win32" ? "npm.cmd" : "npm", ["install", "--offline", "--no-audit", "--no-fund", resolve(process.env.POLHODE_PACKAGE)], { cwd: folder });
writeFileSync(join(folder, "all.mjs"), 'export * from "polhode";\n');

export const polhode = await import(pathToFileURL(join(folder, "all.mjs")).href);

/** Robot with a lost exponent of izz, a mesh, and a second link. */
export const URDF = `<robot name="r"><link name="box"><inertial><origin xyz="0.01 -0.02 0.03" rpy="0.1 0.2 -0.3"/><mass value="2.3"/>
  <inertia ixx="0.0216667" ixy="0.001" ixz="-0.002" iyy="0.0166667" iyz="0.0004" izz="8.33333"/></inertial>
  <collision><geometry><box size="0.11 0.23 0.31"/></geometry></collision></link>
  <link name="wedge"><inertial><mass value="0.7"/><inertia ixx="0.5" ixy="0.01" ixz="0" iyy="0.4" iyz="0" izz="0.6"/></inertial>
  <collision><geometry><mesh filename="wedge.obj"/></geometry></collision></link>
  <joint name="j" type="revolute"><parent link="box"/><child link="wedge"/><axis xyz="0 0 1"/><origin xyz="0.2 0.1 -0.3"/></joint></robot>`;

/** The same robot with a physical tensor. */
export const SOUND = URDF.replace("8.33333", "0.0283333");

/** Tetrahedron with edges (2.1, 3.3, 0.9) m along the axes, away from the origin. */
export const WEDGE = "v 1 -2 3\nv 3.1 -2 3\nv 1 1.3 3\nv 1 -2 3.9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

export const MJCF = `<mujoco model="m"><worldbody><body name="arm"><freejoint/><inertial pos="0.1 0 0.2" mass="1.7" diaginertia="0.9 1.1 3.2"/>
  <geom type="box" size="0.1 0.2 0.3"/></body></worldbody></mujoco>`;

export const SCENARIO = `[[body.part]]
shape = "box"
size = ["11 cm", "23 cm", "31 cm"]
mass = "2.3 kg"
rotate = { axis = [1, 2, -1], angle = 0.4 }
[start]
attitude = { axis = [1, -2, 0.5], angle = 1.1 }
spin = { body = [0.1, 3.1, -0.2] }
[[torque]]
model = "drag"
law = "linear"
coefficient = [0.001, 0.002, 0.0015]
[run]
duration = "5 s"
samples = 41
`;

/** Requests of all functions, each with a result that JSON can hold. */
export const REQUESTS = [
  ["inertia", { cylinder: "7 cm, 31 cm", mass: "2.3 kg" }],
  ["inertia", { files: { "wedge.obj": WEDGE, "box.toml": SCENARIO }, inputs: ["box.toml"] }],
  ["inertia", { files: { "r.urdf": SOUND, "wedge.obj": WEDGE }, inputs: ["r.urdf"], lump: "all", joint: ["j=0.3 rad"] }],
  ["check", { files: { "r.urdf": URDF, "wedge.obj": WEDGE }, fix: true }],
  ["check", { files: { "m.xml": MJCF } }],
  ["freeMotion", { moments: [0.83, 1.7, 2.1], omega: [0.13, 2.9, -0.21], attitude: [0.1, -0.7, 0.5, 0.5], times: [-2.5, 0, 0.75, 12] }],
  ["simulate", { scenario: SCENARIO, at: ["1.5 s"] }],
  ["explain", { scenario: SCENARIO }],
];

/** Returns a result with typed arrays as lists. */
export const listed = (value) => JSON.parse(JSON.stringify(value, (_, inner) => (ArrayBuffer.isView(inner) ? [...inner] : inner)));
