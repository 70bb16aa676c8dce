// Runs the protocol's official inspector against `polhode mcp`: lists the tools and calls each of them, in both eras of the protocol.
//
//     node inspector.mjs POLHODE [INSPECTOR]
//
// POLHODE is the path of the command. INSPECTOR is the folder of @modelcontextprotocol/inspector 2 as npm has installed it; by default npx fetches it. The
// inspector needs Node 22.19.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const VERSION = "2.12.0";
const [polhode, installed] = process.argv.slice(2);
assert(polhode, "usage: node inspector.mjs POLHODE [INSPECTOR]");
const root = resolve(fileURLToPath(import.meta.url), "../../../..");
const home = mkdtempSync(join(tmpdir(), "polhode-inspector-"));
const program = installed
  ? [process.execPath, join(resolve(installed), "clients/launcher/build/index.js")]
  : ["npx", "--yes", `@modelcontextprotocol/inspector@${VERSION}`];

/** Runs the inspector, and returns its JSON with what it has printed besides. */
function inspect(era, options) {
  const server = ["--cwd", join(root, "examples"), "--protocol-era", era, "--format", "json", resolve(polhode), "mcp"];
  const [command, ...first] = [...program, "--cli", ...server, ...options];
  const run = spawnSync(command, first, { encoding: "utf8", env: { ...process.env, HOME: home }, maxBuffer: 1 << 26 });
  return { status: run.status, printed: run.stderr, json: run.stdout ? JSON.parse(run.stdout) : undefined };
}

/** Calls of each tool: arguments, exit status of the command, and a part of the text. */
const CALLS = [
  ["inertia", { files: ["bracket.stl"], unit: "mm", mass: "85 g" }, 0, "principal"],
  ["check", { files: ["robots/bad-arm.urdf"] }, 1, "inertia.triangle"],
  ["simulate", { file: "heavy-top.toml", samples: 3 }, 0, "nutation"],
  ["judge", { files: ["judge/tumbling.toml", "judge/pybullet-default.csv"] }, 1, "first-order integration"],
  ["explain", { file: "heavy-top.toml" }, 0, "Choose the axes"],
];

try {
  for (const era of ["legacy", "modern"]) {
    const listed = inspect(era, ["--method", "tools/list", "--strict"]);
    assert.equal(listed.status, 0, listed.printed);
    assert.match(listed.printed, /\b0 errors\b/);
    assert.deepEqual(listed.json.result.tools.map((tool) => tool.name), CALLS.map(([name]) => name));
    assert.doesNotMatch(listed.printed, /inputSchema/, "arguments are portable");
    console.log(`${era}: tools/list --strict: ${listed.printed.match(/\d+ errors.*/)[0]}`);
    for (const [name, given, status, part] of CALLS) {
      const call = (value) => inspect(era, ["--method", "tools/call", "--tool-name", name, "--tool-args-json", JSON.stringify(value)]);
      const { json, printed } = call(given);
      const { content, structuredContent, isError } = json.result;
      assert.equal(structuredContent.exit_status, status, printed);
      assert.equal(isError ?? false, false);
      assert(content[0].text.includes(part), content[0].text);
      const refused = call({ ...given, nothing: 1 }).json.result;
      assert.equal(refused.isError, true);
      assert.match(refused.content[0].text, /^error: \w+ has no argument "nothing"\nhint: /);
      console.log(`${era}: tools/call ${name}: exit status ${status}, and an invalid argument is refused`);
    }
  }
} finally {
  rmSync(home, { recursive: true });
}
