// Tests in the extension host: the extension is the built one, `vscode` is VS Code's.
const assert = require("node:assert/strict");
const vscode = require("vscode");

const { commands, DiagnosticSeverity, Range, Uri, window, workspace } = vscode;
const { Error: ERROR, Warning: WARNING } = DiagnosticSeverity;
const ARM = "bad-arm.urdf";
const PART = '[[body.part]]\nshape = "box"\nsize = ["20 cm", "10 cm", "6 cm"]\nmass = "2.5 kg"\n';

/** Prints a line; other output of VS Code is not shown. */
const print = (line) => console.log(`polhode: ${line}`);

const address = (name) => Uri.joinPath(workspace.workspaceFolders[0].uri, name);
const own = (uri) => vscode.languages.getDiagnostics(uri).filter(({ source }) => source === "polhode");

/** Waits until a condition holds, and returns its value. */
async function until(what, get, limit = 30_000) {
  const start = Date.now();
  for (;;) {
    const value = await get();
    if (value) return value;
    if (Date.now() - start > limit) throw new Error(`after ${limit / 1000} s: ${what}`);
    await new Promise((done) => setTimeout(done, 20));
  }
}

async function open(name, content) {
  if (content !== undefined) await workspace.fs.writeFile(address(name), Buffer.from(content));
  const document = await workspace.openTextDocument(address(name));
  await window.showTextDocument(document);
  return document;
}

/** Checks a document by the command, and returns its diagnostics. */
async function checked(document) {
  await window.showTextDocument(document);
  await commands.executeCommand("polhode.check");
  return own(document.uri);
}

async function edit(document, from, to) {
  const at = document.getText().indexOf(from);
  assert.ok(at >= 0, from);
  const change = new vscode.WorkspaceEdit();
  change.replace(document.uri, new Range(document.positionAt(at), document.positionAt(at + from.length)), to);
  await workspace.applyEdit(change);
}

const fixes = (document, range) => commands.executeCommand("vscode.executeCodeActionProvider", document.uri, range, "quickfix");

async function hover(document, position) {
  const hovers = await commands.executeCommand("vscode.executeHoverProvider", document.uri, position);
  return hovers.flatMap(({ contents }) => contents.map((part) => part.value ?? part)).join("\n").replaceAll("\\", "");
}

const TESTS = {
  "findings of a URDF are at their places, without a command": async () => {
    const document = await open(ARM);
    const found = await until("no diagnostics", () => own(document.uri).length > 0 && own(document.uri));
    const rows = found.map(({ range, severity, code }) => [range.start.line + 1, document.getText(range), severity, code.value]);
    assert.deepEqual(rows, [
      [8, "15000000", WARNING, "inertia.unit"],
      [15, "1,2", ERROR, "number.malformed"],
      [24, "7020E-3", ERROR, "inertia.triangle"],
      [32, "-2.974890e-05", WARNING, "inertia.sign"],
      [32, "8.362104e-05", ERROR, "inertia.triangle"],
      [42, "1", WARNING, "inertia.placeholder"],
    ]);
    assert.ok(String(found[0].code.target).endsWith("rules.md#inertiaunit"), String(found[0].code.target));
  },
  "a hover has value, rule, reason and fix": async () => {
    const text = await hover(await open(ARM), new vscode.Position(23, 78));
    for (const part of ["inertia.triangle", "7020E-3", "the sum of any two principal moments is at least the third", "**Fix:** izz 7020E-3 → 7.020E-3"]) assert.ok(text.includes(part), text);
    const other = await hover(await open(ARM), new vscode.Position(41, 20));
    assert.match(other, /\*\*Fix:\*\* \w+/);
  },
  "a quick fix removes its finding, and all of them leave what has no certain fix": async () => {
    const document = await open(ARM);
    for (const code of ["inertia.triangle", "inertia.unit", "number.malformed", "inertia.sign"]) {
      const { range } = own(document.uri).find((one) => one.code.value === code);
      const [action] = await fixes(document, range);
      assert.ok(action.edit, code);
      const before = own(document.uri).length;
      await workspace.applyEdit(action.edit);
      const after = await checked(document);
      assert.ok(after.length < before, `${code}: ${after.map(({ message }) => message)}`);
    }
    assert.deepEqual(own(document.uri).map(({ code }) => code.value), ["inertia.placeholder"]);
    await edit(document, 'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"', 'ixx="2e-4" ixy="0" ixz="0" iyy="2e-4" iyz="0" izz="2e-4"');
    assert.deepEqual(await checked(document), []);
  },
  "an unknown key of a scenario is an error at the key, with the nearest name and a fix": async () => {
    const document = await open("box.toml", PART.replace("mass", "mas"));
    const [found] = await until("no diagnostics", () => own(document.uri).length > 0 && own(document.uri));
    assert.deepEqual([found.range.start.line, document.getText(found.range), found.severity, found.code.value], [3, "mas", ERROR, "scenario"]);
    assert.match(found.message, /unknown key "mas" .*\nhint: did you mean mass\?/);
    const [action] = await fixes(document, found.range);
    await workspace.applyEdit(action.edit);
    assert.deepEqual(await checked(document), []);
    assert.ok(document.getText().includes('\nmass = "2.5 kg"'), document.getText());
  },
  "diagnostics follow the typing": async () => {
    const document = await open("typed.toml", PART);
    assert.deepEqual(await checked(document), []);
    await edit(document, '"2.5 kg"', '"-2.5 kg"');
    const [found] = await until("no diagnostics", () => own(document.uri).length > 0 && own(document.uri));
    assert.equal(document.getText(found.range), '"-2.5 kg"');
    await edit(document, '"-2.5 kg"', '"2.5 kg"');
    await until("the diagnostics remain", () => own(document.uri).length === 0);
  },
  "keys, names and tables are completed": async () => {
    const document = await open("keys.toml", `${PART}\n[start]\nspin = { b\n[run]\nmethod = \n[`);
    const at = async (line, character) => {
      const { items } = await commands.executeCommand("vscode.executeCompletionItemProvider", document.uri, new vscode.Position(line, character));
      return items.map(({ label }) => label.label ?? label);
    };
    const keys = await at(4, 0);
    assert.ok(keys.includes("position") && keys.includes("density") && !keys.includes("mass") && !keys.includes("radius"), keys.join());
    assert.ok((await at(6, 10)).includes("space"), "inline table");
    assert.ok((await at(8, 9)).includes('"dop853"'), "names");
    assert.ok((await at(9, 1)).includes("[[torque]]"), "tables");
  },
  "an unrelated TOML file has no diagnostics, a sound model and a scenario with a mesh neither": async () => {
    const names = ["Cargo.toml", "page.toml", "t-handle.toml", "bracket.toml", "arm.sdf"];
    for (const name of names) await open(name);
    // The others are checked after this one.
    await checked(await open("last.toml", PART));
    await new Promise((done) => setTimeout(done, 1000));
    for (const name of names) assert.deepEqual(own(address(name)).map(({ message }) => message), [], name);
  },
  "meshes of packages and of relative names are read, a missing one is stated": async () => {
    const mesh = await workspace.fs.readFile(address("bracket.stl"));
    for (const name of ["src/arm_d/meshes/a.stl", "src/arm_d/urdf/b.stl", "src/parts/parts_d/d.stl", "lib/other_d/e.stl"]) await workspace.fs.writeFile(address(name), mesh);
    await workspace.fs.writeFile(address("src/arm_d/package.xml"), Buffer.from("<package><name>arm_d</name></package>"));
    await workspace.fs.writeFile(address("src/parts/parts_d/package.xml"), Buffer.from("<package><name>parts_d</name></package>"));
    await workspace.getConfiguration("polhode").update("roots", ["lib"], vscode.ConfigurationTarget.Workspace);
    const shape = (name) => `<visual><geometry><mesh filename="${name}" scale="0.001 0.001 0.001"/></geometry></visual>`;
    const link = (name, file) => `<link name="${name}"><inertial><mass value="0.3"/>\n<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>${shape(file)}</link>`;
    const files = ["package://arm_d/meshes/a.stl", "b.stl", "../meshes/a.stl", "package://parts_d/d.stl", "package://other_d/e.stl", "../meshes/c.stl"];
    const joints = files.slice(1).map((_, k) => `<joint name="j${k}" type="fixed"><parent link="l0"/><child link="l${k + 1}"/></joint>`);
    const document = await open("src/arm_d/urdf/arm.urdf", `<robot name="r">\n${files.map((file, k) => link(`l${k}`, file)).join("\n")}${joints.join("")}</robot>`);
    const found = await checked(document);
    const unreadable = found.filter(({ code }) => code.value === "geometry.unreadable");
    assert.deepEqual(unreadable.map(({ message }) => message), ['l5: "../meshes/c.stl": the file does not exist']);
    // Each mesh that is read gives its link a size.
    assert.ok(found.some(({ message }) => message.includes("impossible for the mass and size of 5 of them")), found.map(({ message }) => message).join("\n"));
    const scenario = await open("absent.toml", '[[body.part]]\nshape = "mesh"\nfile = "absent.stl"\ndensity = "2 g/cm^3"\n');
    assert.deepEqual((await checked(scenario)).map(({ message }) => message), ['file = "absent.stl" must be a file that exists\nhint: file names are relative to the scenario']);
  },
  "findings of an included MJCF file are in that file": async () => {
    const body = (name) => `<worldbody>\n<body name="${name}"><inertial pos="0 0 0" mass="1" diaginertia="1 1 3"/></body></worldbody>`;
    await workspace.fs.writeFile(address("mj/inc.xml"), Buffer.from(`<mujoco>${body("y")}</mujoco>`));
    const document = await open("mj/main.xml", `<mujoco><include file="inc.xml"/>${body("x")}</mujoco>`);
    await checked(document);
    assert.deepEqual(own(address("mj/inc.xml")).map(({ range, code }) => [range.start.line, code.value]), [[1, "inertia.triangle"]]);
  },
  "the policy of the workspace holds": async () => {
    const policy = '[[check.allow]]\nrule = "inertia.triangle"\nfile = "mj/*.xml"\nreason = "a test"\n';
    await workspace.fs.writeFile(address("polhode.toml"), Buffer.from(policy));
    const document = await open("mj/alone.xml", '<mujoco><worldbody><body name="x"><inertial pos="0 0 0" mass="1" diaginertia="1 1 3"/></body></worldbody></mujoco>');
    assert.deepEqual((await checked(document)).map(({ code }) => code.value), []);
    await workspace.fs.writeFile(address("polhode.toml"), Buffer.from(policy.replace("reason", "raeson")));
    await checked(document);
    assert.deepEqual(own(address("polhode.toml")).map(({ severity }) => severity), [ERROR]);
    await workspace.fs.delete(address("polhode.toml"));
  },
  "a file of 10 MB blocks nothing, and is ended by the time limit": async () => {
    const link = (k) => `<link name="l${k}"><inertial><mass value="0.9"/><inertia ixx="0.0004575" ixy="0" ixz="0" iyy="0.0069375" iyz="0" izz="7020E-3"/></inertial></link>\n<joint name="j${k}" type="fixed"><parent link="base"/><child link="l${k}"/></joint>\n`;
    const limit = (seconds) => workspace.getConfiguration("polhode").update("timeLimit", seconds, vscode.ConfigurationTarget.Workspace);
    const text = `<robot name="r"><link name="base"/>\n${Array.from({ length: 46_000 }, (_, k) => link(k)).join("")}</robot>`;
    assert.ok(text.length > 1e7, `${text.length}`);
    await limit(5);
    const large = await open("large.urdf", text);
    let [longest, last] = [0, Date.now()];
    const ticks = setInterval(() => {
      longest = Math.max(longest, Date.now() - last);
      last = Date.now();
    }, 5);
    const start = Date.now();
    const small = await open("small.toml", PART.replace("mass", "mas"));
    await until("no diagnostics", () => own(small.uri).length > 0);
    print(`    10 MB: another file is checked after ${Date.now() - start} ms; the extension host was busy for at most ${longest} ms`);
    clearInterval(ticks);
    // A build without optimization takes a minute for the large file, in its own thread.
    assert.ok(longest < 3000, `${longest}`);
    await until("neither findings nor a remark", () => own(large.uri).length > 0);
    await limit(0.01);
    const [found] = await checked(large);
    assert.deepEqual([found.severity, found.range.start.line], [WARNING, 0]);
    assert.match(found.message, /^not checked: the check takes longer than 0.01 s; raise the setting polhode.timeLimit/);
    await limit(undefined);
  },
  "a scenario is explained as Markdown, anything else is refused": async () => {
    await open("t-handle.toml");
    await commands.executeCommand("polhode.explain");
    const solution = workspace.textDocuments.find(({ uri }) => uri.scheme === "polhode");
    assert.ok(solution.getText().startsWith("# T-handle in free fall\n"), solution.getText().slice(0, 80));
    await until("no preview", () => window.tabGroups.all.some(({ tabs }) => tabs.some(({ label }) => label.startsWith("Preview"))));
  },
};

exports.run = async () => {
  let failed = 0;
  for (const [name, test] of Object.entries(TESTS)) {
    const start = Date.now();
    const problem = await test().then(() => null, (error) => error);
    print(`${problem ? "✖" : "✔"} ${name} (${Date.now() - start} ms)`);
    if (problem) print(String(problem.stack ?? problem));
    failed += problem ? 1 : 0;
    await commands.executeCommand("workbench.action.closeAllEditors");
  }
  print(`${Object.keys(TESTS).length - failed} passed, ${failed} failed`);
  if (failed > 0) throw new Error(`${failed} failed`);
};
