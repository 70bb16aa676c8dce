// Kinds of documents, names in them, and completion.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { example, load, root } from "./load.mjs";

const { kindOf } = await load("kind");
const { foldersIn, namesIn, plain } = await load("references");
const { complete, describeKey } = await load("toml");
const { span } = await load("problem");

test("the kind of a file follows from its content", () => {
  for (const folder of ["", "notes", "sweeps"]) {
    const names = readdirSync(join(root, "examples", folder)).filter((name) => name.endsWith(".toml"));
    assert.ok(names.length > 3);
    for (const name of names) assert.equal(kindOf(name, example(join(folder, name))), "scenario", name);
  }
  const others = ["Cargo.toml", "clippy.toml", "rustfmt.toml", "crates/polhode-py/pyproject.toml", "examples/identify/rod-logs.toml", "examples/identify/payload.toml"];
  for (const name of others) assert.equal(kindOf(name, readFileSync(join(root, name), "utf8")), null, name);
  assert.equal(kindOf("page.toml", "[head]\nx = 1\n[body]\ny = 2\n"), null);
  assert.equal(kindOf("a.toml", '[body]\nparts = [\n  [1, 2],\n]\n[unknown]\n[start]\n'), "scenario");
  assert.equal(kindOf("a.xml", '\uFEFF<?xml version="1.0"?>\n<!-- <package> -->\n<mujoco model="a">'), "robot");
  assert.equal(kindOf("package.xml", "<!-- a --><package><!-- b --><robot></robot></package>"), null);
  assert.equal(kindOf("caffeine.sdf", "caffeine\n  RDKit\n"), null);
  assert.equal(kindOf("arm.URDF", ""), "robot");
  assert.equal(kindOf("notes.txt", "<robot/>"), null);
});

test("names of files are found in every language", () => {
  const urdf = '<mesh filename="package://a/b.STL"/><texture filename="x.png"/><uri> model://c </uri><mesh filename=\'../d e.dae\'/><inertia ixx="0.5"/>';
  assert.deepEqual([...namesIn(urdf)], ["package://a/b.STL", "../d e.dae", "model://c"]);
  assert.deepEqual([...namesIn('file = "bracket.stl"\nradius = "2.5 cm"\nsize = ["0.5"]')], ["bracket.stl"]);
  assert.deepEqual(foldersIn('<compiler meshdir="assets" texturedir="t"/>'), ["assets"]);
  assert.equal(plain("p/urdf/../meshes/./a.stl"), "p/meshes/a.stl");
  assert.equal(plain("../meshes/a.stl"), "meshes/a.stl");
});

test("a place is the stated one, in UTF-16 units", () => {
  assert.deepEqual(span('<inertia ixx="7020E-3"/>', 15, null), [14, 21]);
  assert.deepEqual(span("  <visual>", 3, null), [2, 9]);
  assert.deepEqual(span("𝜔𝜔 = 3", 6, 1), [7, 8]);
  assert.deepEqual(span("", 1, null), [0, 0]);
});

/** Returns the completions at the bar. */
const at = (text) => complete(text.replace("|", ""), text.indexOf("|"))?.items.map((item) => item.text) ?? [];
const BALL = '[[body.part]]\nshape = "sphere"\nradius = "2 cm"\nmass = "3 kg"\n';

test("keys are those of the table, of its shape, that it does not have", () => {
  const keys = at('[[body.part]]\nshape = "cylinder"\nradius = "2 cm"\nle|\n[run]\nduration = "1 s"\n');
  assert.ok(keys.includes("length") && keys.includes("material"), keys.join());
  assert.ok(!keys.includes("radius") && !keys.includes("tube_radius") && !keys.includes("duration"), keys.join());
  assert.deepEqual(at(`${BALL}[start]\nspin = { body = [1, 2, 3], |`).sort(), ["momentum", "space"]);
  assert.ok(at(`${BALL}[run]\n|\nduration = 3\n`).includes("samples"));
  assert.ok(!at(`${BALL}[run]\n|\nduration = 3\n`).includes("duration"));
  assert.ok(at("|").includes("body"));
  for (const none of ["# a |", "[run]\nduration |", "[run]\nduration = 3 |", "x = { |", `${BALL}[run]\ntitle = "a |`]) assert.deepEqual(at(none), [], none);
});

test("values are names, or an example with its unit; headers are tables", () => {
  assert.ok(at(`${BALL}[[torque]]\nmodel = "gr|`).includes('"gravity_gradient"'));
  assert.deepEqual(at("[[body.part]]\nshape = \"sphere\"\nradius = |"), ['"25 mm"']);
  assert.deepEqual(at('[[body.part]]\nshape = "box"\nsize = ["1 m", |'), ['"25 mm"']);
  assert.deepEqual([complete('[run]\nmethod = "|"'.replace("|", ""), 16)].map(({ from, to }) => [from, to]), [[15, 17]]);
  assert.ok(at("[|").includes("[[wheel]]") && at("[[|]]").includes("[run]") && !at("[|").includes("[title]"));
  assert.equal(complete("[[]]", 2).to, 4);
});

test("a key is described with its unit", () => {
  const text = `${BALL}[start]\nspin = { body = [1, 2, 3] }\n`;
  assert.match(describeKey(text, text.indexOf("radius") + 3), /length, such as "25 mm"/);
  assert.match(describeKey(text, text.indexOf("body = ") + 1), /array; each: an angular velocity/);
  assert.equal(describeKey(text, text.indexOf("2 cm")), null);
  assert.equal(describeKey(text, 3), null);
});
