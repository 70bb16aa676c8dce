// The package in Node, compared with the command POLHODE.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { folder, MJCF, polhode, SCENARIO, SOUND, URDF, WEDGE } from "./package.mjs";

const { check, explain, freeMotion, inertia, PolhodeError, simulate } = polhode;

const scratch = mkdtempSync(join(tmpdir(), "polhode-npm-command-"));
const command = (files, ...words) => {
  for (const [name, text] of Object.entries(files)) writeFileSync(join(scratch, name), text);
  const { stdout, stderr, status } = spawnSync(resolve(process.env.POLHODE), words, { cwd: scratch, encoding: "utf8" });
  assert.ok(status === 0 || status === 1, stderr);
  return stdout;
};

/** Largest relative difference of numbers: machines with fused multiply–add have other last digits. */
const CLOSE = 1e-13;

/** Compares two values: everything is equal, but numbers may differ in their last digits. */
function close(found, expected, path = "") {
  if (typeof expected === "number" && typeof found === "number") {
    assert.ok(Math.abs(found - expected) <= CLOSE * Math.max(1, Math.abs(expected)), `${path}: ${found} is not ${expected}`);
  } else if (expected !== null && typeof expected === "object") {
    assert.deepEqual(Object.keys(found), Object.keys(expected), path);
    for (const key of Object.keys(expected)) close(found[key], expected[key], `${path}.${key}`);
  } else assert.equal(found, expected, path);
}

const refusal = async (promise) => {
  try {
    await promise;
  } catch (error) {
    assert.ok(error instanceof PolhodeError, String(error.stack));
    assert.ok(error.message.startsWith(error.reason) && error.failures.length > 0, error.message);
    return error;
  }
  return assert.fail("the request was not refused");
};

test("the examples of the README run", () => {
  const blocks = [...readFileSync(join(folder, "node_modules/polhode/README.md"), "utf8").matchAll(/```js\n(.*?)```/gs)];
  assert.equal(blocks.length, 3);
  for (const [k, [, text]] of blocks.entries()) {
    writeFileSync(join(folder, `example-${k}.mjs`), text);
    const printed = execFileSync(process.execPath, [`example-${k}.mjs`], { cwd: folder, encoding: "utf8" });
    assert.ok(printed.length > 20 && !printed.includes("undefined"), printed);
  }
});

test("inertia has the JSON of the command, bit for bit", async () => {
  const shape = JSON.parse(command({}, "inertia", "--cylinder", "7 cm, 31 cm", "--mass", "2.3 kg", "--about", "0.1, 0.2, -0.3", "--json"));
  assert.deepEqual(await inertia({ cylinder: "7 cm, 31 cm", mass: "2.3 kg", about: "0.1, 0.2, -0.3" }), [shape]);
  const files = { "wedge.obj": WEDGE, "box.toml": SCENARIO };
  const bodies = JSON.parse(command(files, "inertia", "wedge.obj", "--density", "4 kg/m^3", "--json"));
  assert.deepEqual(await inertia({ files, inputs: ["wedge.obj"], density: "4 kg/m^3" }), [bodies]);
  assert.deepEqual(await inertia({ files: { "box.toml": SCENARIO } }), [JSON.parse(command(files, "inertia", "box.toml", "--json"))]);
  const robot = { "r.urdf": SOUND, "wedge.obj": WEDGE };
  const joined = JSON.parse(command(robot, "inertia", "r.urdf", "--lump", "--joint", "j=20 deg", "--json"));
  assert.deepEqual(await inertia({ files: robot, inputs: ["r.urdf"], lump: "all", joint: ["j=20 deg"] }), [joined]);
});

test("check has the JSON of the command, for URDF and for other languages", async () => {
  const files = { "r.urdf": URDF, "wedge.obj": WEDGE };
  const found = await check({ files, inputs: ["r.urdf"], fix: true });
  close(found.reports, [JSON.parse(command(files, "check", "r.urdf", "--fix", "--json"))]);
  assert.deepEqual([found.failed, found.remarks], [true, []]);
  assert.ok(found.reports[0].findings.some((finding) => finding.code.startsWith("inertia.")));
  // Without `inputs` the folder is searched, as by `polhode check .`.
  assert.deepEqual((await check({ files, fix: true })).reports, found.reports);
  // The full module reads what the small one does not, and reports the same on what both read.
  const both = await check({ files: { ...files, "m.xml": MJCF } });
  close(both.reports.at(0), JSON.parse(command({ "m.xml": MJCF }, "check", "m.xml", "--json")));
  const { reports: [alone] } = await check({ files });
  assert.deepEqual(both.reports.at(1), alone);
  const config = await check({ files: { ...files, "polhode.toml": '[check]\nfail_on = "impossible"\nexclude = ["*.urdf"]\n' } });
  assert.deepEqual([config.failed, config.reports], [false, []]);
});

test("freeMotion has the states of simulate, bit for bit, and the periods of the command", async () => {
  const times = Float64Array.from({ length: 41 }, (_, k) => 0.125 * k);
  const free = await freeMotion({ moments: [0.83, 1.7, 2.1], omega: [0.13, 2.9, -0.21], attitude: [0.1, -0.7, 0.5, 0.5], times });
  const scenario = `[[body.part]]\nshape = "tensor"\nmass = 2.3\ninertia = [[0.83, 0, 0], [0, 1.7, 0], [0, 0, 2.1]]
[start]\nattitude = { quaternion = [0.1, -0.7, 0.5, 0.5] }\nspin = { body = [0.13, 2.9, -0.21] }\n[run]\nduration = 5\nsamples = 41\n`;
  const { summary, channels, columns } = await simulate({ scenario });
  assert.deepEqual(channels.time_s, times);
  assert.deepEqual(free.times_s, times);
  for (const [k, axis] of ["x", "y", "z"].entries()) assert.deepEqual(times.map((_, row) => free.omega_body_rad_s[3 * row + k]), channels[`omega_body_${axis}_rad_s`]);
  for (const [k, axis] of ["w", "x", "y", "z"].entries()) assert.deepEqual(times.map((_, row) => free.attitude_wxyz[4 * row + k]), channels[`attitude_${axis}`]);
  assert.deepEqual([columns[0].name, columns[0].unit], ["time_s", "s"]);
  assert.equal(summary.motion.regime, free.regime);
  const spin = JSON.parse(command({}, "spin", "--moments", "0.83,1.7,2.1", "--omega", "0.13,2.9,-0.21", "--attitude", "0.1,-0.7,0.5,0.5", "--json")).motion;
  for (const key of ["regime", "period_s", "flip_interval_s", "growth_rate_per_s", "kinetic_energy_j", "momentum_kg_m2_s", "momentum_space_kg_m2_s", "precession_rate_rad_s", "nutation_range_rad"]) {
    close(free[key], spin[key], key);
  }
  const none = await freeMotion({ moments: [0.83, 1.7, 2.1], omega: [0.13, 2.9, -0.21], times: [] });
  assert.deepEqual(none.attitude_wxyz, new Float64Array());
});

test("simulate and explain have the results of the command", async () => {
  const files = { "scenario.toml": SCENARIO };
  const { summary, channels } = await simulate({ scenario: SCENARIO, at: ["1.5 s"] });
  const expected = JSON.parse(command(files, "simulate", "scenario.toml", "--at", "1.5 s", "--json", "--no-page", "--force"));
  for (const key of ["mass", "inertia", "principal", "start", "final", "at", "motion"]) close(summary[key], expected[key], key);
  assert.equal(channels.kinetic_energy_j.length, 41);
  assert.equal(channels.kinetic_energy_j.at(-1), summary.final.kinetic_energy_j ?? channels.kinetic_energy_j.at(-1));
  // Remainders of rounding differ on a machine with fused multiply–add.
  const settled = (text) => text.split("\n").filter((line) => !/[0-9]e-1[3-9]|[0-9]\\times 10\^\{-1/.test(line)).join("\n");
  for (const format of ["markdown", "latex"]) {
    const text = await explain({ scenario: SCENARIO }, { format });
    assert.equal(settled(text), settled(command(files, "explain", "scenario.toml", `--${format}`)));
    assert.ok(settled(text).length > 0.95 * text.length);
  }
  assert.ok((await explain({ scenario: SCENARIO }, { format: "html" })).includes("<math"));
});

test("a scenario refers to files of the request only", async () => {
  const scenario = '[[body.part]]\nshape = "mesh"\nfile = "wedge.obj"\ndensity = 4\n';
  const text = await explain({ scenario: `${scenario}[start]\nspin = { body = [0.1, 3, 0.2] }\n`, files: { "wedge.obj": WEDGE } });
  assert.ok(text.includes("Euler"));
  const error = await refusal(explain({ scenario, files: { "other.obj": WEDGE } }));
  assert.match(error.message, /wedge\.obj/);
});

test("invalid requests are refused with the place, the rule and the fix", async () => {
  const cases = [
    [() => inertia({ box: "1 m, 2 m, 3 m", mass: 2, masss: 3 }), /masss/, null],
    [() => inertia({ box: "1 m, 2 m, 3 m" }), /mass/, null],
    [() => inertia({ box: "1 m, 2 m, 3 m", mass: NaN }), /^mass = NaN must be a finite number/, null],
    [() => inertia({ files: { "a.step": "ISO-10303-21;" } }), /STEP/, "a.step"],
    [() => inertia({ files: { "../a.obj": WEDGE }, mass: 1 }), /relative path/, null],
    [() => inertia({ files: { "a.obj": 7 }, mass: 1 }), /text or bytes/, null],
    [() => inertia({ files: { "a.obj": "v \ud800" }, mass: 1 }), /surrogate/, null],
    [() => inertia(null), /must be an object/, null],
    [() => check({}), /no model/, null],
    [() => check({ files: { "r.urdf": "<robot>" } }), /root element/, "r.urdf"],
    [() => check({ files: { "r.urdf": URDF }, for: ["gazebos"] }), /gazebos/, null],
    [() => freeMotion({ moments: [0.4, 1, 2], omega: [1, 2, 3], times: [0] }), /moments/, null],
    [() => freeMotion({ moments: [1, 2, 2.5], omega: [1, 2, Infinity], times: [0] }), /^omega\[2\] = Infinity/, null],
    [() => freeMotion({ moments: [1, 2, 2.5], omega: [1, 2, 3], times: new Map() }), /plain data, not Map/, null],
    [() => simulate({ scenario: SCENARIO.replace("11 cm", "-11 cm") }), /size/, "scenario.toml"],
    [() => simulate({ scenario: SCENARIO, files: { "scenario.toml": "" } }), /the name of the scenario/, null],
    [() => simulate({ scenario: SCENARIO, duration: 3 }), /duration/, null],
    [() => simulate({}), /TOML text/, null],
    [() => explain({ scenario: SCENARIO }, { format: "pdf" }), /pdf/, null],
    [() => explain({ scenario: SCENARIO }, { form: "latex" }), /form/, null],
  ];
  for (const [call, reason, file] of cases) {
    const error = await refusal(call());
    assert.match(error.reason, reason);
    assert.equal(error.file, file, error.message);
    assert.notEqual(error.kind, "defect");
  }
  const error = await refusal(simulate({ scenario: SCENARIO.replace("11 cm", "-11 cm") }));
  assert.deepEqual([error.kind, error.line, error.name], ["input", 3, "PolhodeError"]);
  const two = await refusal(check({ files: { "a.urdf": "<robot>", "b.urdf": "nothing", "c.urdf": URDF } }));
  assert.deepEqual(two.failures.map(({ file }) => file), ["a.urdf", "b.urdf"]);
});

test("damaged files are refused or read, and never stop the module", async () => {
  let seed = 12345;
  const next = (below) => ((seed = (Math.imul(seed, 1103515245) + 12345) >>> 0), (seed >>> 8) % below);
  const damaged = (text) => {
    const bytes = new TextEncoder().encode(text);
    for (let k = 0; k <= next(4); k++) bytes[next(bytes.length)] = next(20) ? 32 + next(95) : next(256);
    return bytes.subarray(0, next(5) ? bytes.length : next(bytes.length));
  };
  let refused = 0;
  for (let k = 0; k < 150; k++) {
    const calls = [
      check({ files: { "r.urdf": damaged(URDF), "wedge.obj": damaged(WEDGE) }, inputs: ["r.urdf"], fix: true }),
      check({ files: { "m.xml": damaged(MJCF) } }),
      inertia({ files: { "wedge.obj": damaged(WEDGE) }, density: 3, weld: "1 cm", hull: k % 2 === 0 }),
      inertia({ files: { "box.toml": damaged(SCENARIO) } }),
    ];
    for (const call of await Promise.allSettled(calls)) {
      if (call.status === "fulfilled") continue;
      assert.ok(call.reason instanceof PolhodeError && call.reason.kind !== "defect", String(call.reason.stack));
      refused++;
    }
  }
  assert.ok(refused > 100 && refused < 580, String(refused));
});

test("a module that stops is reported, and other calls start another", async () => {
  const files = { "r.urdf": URDF, "wedge.obj": WEDGE };
  const before = await check({ files });
  // More than the largest memory of a module.
  const [error, beside] = await Promise.all([refusal(check({ files: { "r.urdf": new Uint8Array(1_100_000_000) } })), check({ files })]);
  assert.deepEqual(beside, before);
  assert.deepEqual([error.kind, error.reason.startsWith("polhode stopped: ")], ["defect", true]);
  assert.deepEqual(await check({ files }), before);
});

test("the types accept the requests of the README, and refuse unknown keys", () => {
  const text = `import { check, freeMotion, inertia, simulate, type Body } from "polhode";
const bodies: Body[] = await inertia({ files: { "a.stl": new Uint8Array() }, inputs: ["a.stl"], unit: "mm", "mass-unit": "g" });
const moments: number[] = bodies[0]!.principal.moments.map((moment) => moment ?? NaN);
const { reports } = await check({ files: { "r.urdf": "" }, for: ["drake"], "fail-on": "note" });
const code: string = reports[0]!.findings[0]!.code;
const omega: Float64Array = (await freeMotion({ moments: [1, 2, 2.5], omega: [0, 1, 2], times: new Float64Array(3) })).omega_body_rad_s;
const channel: Float64Array | undefined = (await simulate({ scenario: "" })).channels.time_s;
// @ts-expect-error unknown key
await inertia({ masss: 3 });
// @ts-expect-error one component is missing
await freeMotion({ moments: [1, 2], omega: [0, 1, 2], times: [] });
export { moments, code, omega, channel };
`;
  writeFileSync(join(folder, "types.ts"), text);
  const options = { target: "ES2022", module: "NodeNext", strict: true, noUncheckedIndexedAccess: true, noEmit: true, lib: ["ES2023", "DOM"], types: [] };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions: options, files: ["types.ts"] }));
  const compiler = resolve(import.meta.dirname, "../../viewer/node_modules/typescript/bin/tsc");
  const { stdout, status } = spawnSync(process.execPath, [compiler, "--project", folder], { encoding: "utf8" });
  assert.equal(status, 0, stdout);
});

test("the archive has the modules, types and licences", () => {
  const read = (name) => readFileSync(join(folder, "node_modules/polhode", name));
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE", "THIRD-PARTY-LICENSES.txt", "index.d.ts", "polhode_full.wasm"]) assert.ok(read(name).length > 500, name);
  const [, version] = /^version = "([^"]+)"/m.exec(readFileSync(resolve(import.meta.dirname, "../../Cargo.toml"), "utf8"));
  assert.equal(JSON.parse(read("package.json")).version, version);
});
