// Puts the package together: node build.mjs --small MODULE.wasm --full MODULE.wasm --into FOLDER. TypeScript and its compiler are those of viewer/.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

const { values: given } = parseArgs({ options: { small: { type: "string" }, full: { type: "string" }, into: { type: "string" } } });
const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, "..");
const into = resolve(given.into);

rmSync(into, { recursive: true, force: true });
mkdirSync(into, { recursive: true });
execFileSync(process.execPath, [resolve(root, "viewer/node_modules/typescript/bin/tsc"), "--project", here, "--outDir", into], { stdio: "inherit" });
copyFileSync(given.small, resolve(into, "polhode.wasm"));
copyFileSync(given.full, resolve(into, "polhode_full.wasm"));
copyFileSync(resolve(here, "README.md"), resolve(into, "README.md"));
for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) copyFileSync(resolve(root, name), resolve(into, name));
// The version is that of the workspace.
const [, version] = /^version = "([^"]+)"/m.exec(readFileSync(resolve(root, "Cargo.toml"), "utf8"));
const { name, ...manifest } = JSON.parse(readFileSync(resolve(here, "package.json"), "utf8"));
writeFileSync(resolve(into, "package.json"), JSON.stringify({ name, version, ...manifest }, null, 2) + "\n");
