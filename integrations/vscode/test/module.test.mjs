// Requests to the module in threads, and problems of their outcomes.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { example, load, worker } from "./load.mjs";

const { Pool } = await load("pool");
const { ofFailures, ofReport, span } = await load("problem");
const { RULES, pageOf } = await load("rules");
const { TABLES, tablesAt } = await load("schema");

const pool = new Pool(worker);
after(() => pool.dispose());
const LIMIT = 120;
const PART = '[[body.part]]\nshape = "box"\nsize = ["20 cm", "10 cm", "6 cm"]\nmass = "2.5 kg"\n';

const robot = (text) => pool.ask("a.urdf", "check", { files: { "a.urdf": text } }, LIMIT);
const scenario = async (text, owner = "a.toml") => {
  const outcome = await pool.ask(owner, "inertia", { files: { "a.toml": text } }, LIMIT);
  return "failures" in outcome ? ofFailures(outcome.failures, "a.toml", "scenario") : [];
};

/** Returns a text after the edits of a problem, each of which replaces its old text. */
function fixed(text, { edits }) {
  const lines = text.split("\n");
  for (const { line, column, old, new: other } of edits.toSorted((a, b) => b.column - a.column)) {
    const [start, end] = span(lines[line - 1], column, [...old].length);
    assert.equal(lines[line - 1].slice(start, end), old);
    lines[line - 1] = lines[line - 1].slice(0, start) + other + lines[line - 1].slice(end);
  }
  return lines.join("\n");
}

test("each fix of a model removes its finding", async () => {
  let text = example("robots/bad-arm.urdf");
  const counts = [];
  for (;;) {
    const { value } = await robot(text);
    const found = value.reports.flatMap(ofReport);
    counts.push(found.length);
    for (const problem of found) assert.ok(problem.fix && problem.rule && problem.why, problem.code);
    const next = found.find(({ edits }) => edits.length > 0);
    if (!next) break;
    text = fixed(text, next);
  }
  assert.deepEqual(counts.at(0), 6);
  assert.deepEqual(counts.at(-1), 1);
  assert.ok(counts.every((count, k) => k === 0 || count < counts[k - 1]), counts.join());
});

test("each mistake in a scenario is at its place, and the nearest name is right", async () => {
  for (const [from, to] of [["mass", "mas"], ['"box"', '"boxx"'], ["shape", "shap"]]) {
    const text = PART.replace(from, to);
    const [problem] = await scenario(text);
    const line = text.split("\n")[problem.line - 1];
    assert.equal(line.slice(...span(line, problem.column, problem.length)), to);
    assert.match(problem.message, new RegExp(`hint: did you mean ${from}\\?`));
    assert.equal(fixed(text, problem), PART);
  }
  assert.deepEqual(await scenario(PART), []);
  const [absent] = await scenario('[[body.part]]\nshape = "mesh"\nfile = "a.stl"\ndensity = "2 g/cm^3"\n');
  assert.deepEqual([absent.line, absent.column, absent.message], [3, 8, 'file = "a.stl" must be a file that exists\nhint: file names are relative to the scenario']);
});

test("a fault of a named file is at the place that names it", async () => {
  const files = { "a.toml": '[[body.part]]\nshape = "mesh"\nfile = "a.stl"\ndensity = "2 g/cm^3"\n', "a.stl": new Uint8Array(90).fill(7) };
  const { failures } = await pool.ask("b", "inertia", { files, inputs: ["a.toml"] }, LIMIT);
  const [{ file, line, message }] = ofFailures(failures, "a.toml", "scenario");
  assert.deepEqual([file, line], ["a.toml", 3]);
  assert.ok(message.startsWith("a.stl: "), message);
});

test("the schema has the keys that the module takes", async () => {
  const tables = [["", []], ["[run]", ["run"]], ["[start]", ["start"]], [PART.trim(), ["body", "part"]], ['[[torque]]\nmodel = "constant"', ["torque"]]];
  for (const [head, path] of tables) {
    const before = path.length === 0 || path[0] === "body" ? "" : PART;
    const [problem] = await scenario(`${before}${head}\nqqqq = 1\n`);
    const known = /the known keys are (.*)$/.exec(problem.message)?.[1].split(", ");
    const model = /(shape|model) = "(\w+)"/.exec(head);
    const keys = path.length === 0 ? TABLES : tablesAt(path, model ? [[model[1], model[2]]] : []).flatMap(({ properties }) => Object.keys(properties));
    assert.deepEqual([...new Set(keys)].sort(), known?.sort(), `${head}: ${problem.message}`);
  }
});

test("a new request ends the old one, and the time limit a long one; others go on", async () => {
  const link = (k) => `<link name="l${k}"><inertial><mass value="0.9"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link><joint name="j${k}" type="fixed"><parent link="base"/><child link="l${k}"/></joint>\n`;
  const long = `<robot name="r"><link name="base"/>${Array.from({ length: 40_000 }, (_, k) => link(k)).join("")}</robot>`;
  const first = robot(long);
  const [second, other] = [robot(example("robots/arm.urdf")), scenario(PART, "other")];
  assert.deepEqual(await first, { ended: "superseded" });
  assert.equal((await second).value.reports[0].findings.length, 0);
  assert.deepEqual(await other, []);
  const start = Date.now();
  const late = pool.ask("a.urdf", "check", { files: { "a.urdf": long } }, 0.05);
  await scenario(PART, "meanwhile");
  assert.deepEqual(await late, { ended: "late" });
  assert.ok(Date.now() - start < 10_000);
});

test("each rule has a reason, a remedy and an address", () => {
  assert.ok(RULES.size > 40);
  assert.match(RULES.get("inertia.triangle").remedy, /\.$/);
  assert.ok(pageOf("mass.not_positive").endsWith("/rules.md#massnot_positive"));
});
