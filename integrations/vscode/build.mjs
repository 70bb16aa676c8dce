// Builds the extension: node build.mjs [--check | --package]. POLHODE_NPM is the npm package's folder, POLHODE the command.
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { build } from "esbuild";

const { values: given } = parseArgs({ options: { check: { type: "boolean" }, package: { type: "boolean" } } });
const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, "../..");
const dist = resolve(here, "dist");
/** Largest size of the packed extension, bytes. */
const MOST = 8e6;

const module = firstOf("the npm package", "run cargo xtask npm, or name its folder in POLHODE_NPM", process.env.POLHODE_NPM, `${root}/target/npm/package`);
const command = firstOf("the command polhode", "run cargo build, or name the program in POLHODE", process.env.POLHODE, `${root}/target/release/polhode`, `${root}/target/debug/polhode`);

rmSync(dist, { recursive: true, force: true });
mkdirSync(dist);
writeFileSync(`${dist}/scenario.schema.json`, execFileSync(command, ["schema", "scenario"]));
const shared = { bundle: true, platform: "node", target: "node20", minify: true, logLevel: "warning", loader: { ".txt": "text" } };
const alias = { polhode: `${module}/index.js`, "scenario.schema.json": `${dist}/scenario.schema.json` };
await build({ ...shared, alias, entryPoints: [`${here}/src/extension.ts`], outfile: `${dist}/extension.js`, format: "cjs", external: ["vscode"] });
await build({ ...shared, alias, entryPoints: [`${here}/src/worker.ts`], outfile: `${dist}/worker.mjs`, format: "esm" });
for (const name of ["polhode.wasm", "polhode_full.wasm", "THIRD-PARTY-LICENSES.txt"]) copyFileSync(`${module}/${name}`, `${dist}/${name}`);

if (given.check || given.package) node("typescript/bin/tsc", "--project", here);
if (given.package) {
  copyFileSync(`${root}/LICENSE-MIT`, `${here}/LICENSE.txt`);
  const pages = "https://github.com/polhode/polhode";
  const links = ["--baseContentUrl", `${pages}/blob/main/integrations/vscode`, "--baseImagesUrl", `${pages}/raw/main/integrations/vscode`];
  node("@vscode/vsce/vsce", "package", "--no-dependencies", "--out", `${here}/polhode.vsix`, ...links);
  const { size } = statSync(`${here}/polhode.vsix`);
  console.log(`polhode.vsix: ${(size / 1e6).toFixed(1)} MB`);
  if (size > MOST) throw new Error(`polhode.vsix has ${size} bytes, more than ${MOST}`);
}

function node(script, ...words) {
  execFileSync(process.execPath, [`${here}/node_modules/${script}`, ...words], { cwd: here, stdio: "inherit" });
}

/** Returns the first path that exists. */
function firstOf(what, fix, ...paths) {
  const found = paths.find((path) => path && existsSync(path));
  if (!found) throw new Error(`${what} is not built; ${fix}`);
  return resolve(found);
}
