// Writes the TypeScript types of the page's protocol and of the npm package, from the JSON schemas of the Rust crates; with --check it only compares, and
// fails if a file is stale. `tsType` in a schema names a type that JSON cannot express.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { compile } from "json-schema-to-typescript";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const read = (path) => JSON.parse(readFileSync(resolve(root, "crates", path), "utf8"));

/** Name of the type, schema, and file of each schema. */
const TYPES = [
  ["Exchange", "polhode-web/schema/protocol.json", "viewer/src/live/protocol.ts", 'import type { ExplanationBlock, PageData, Shape } from "../data";'],
  ["InertiaRequest", "polhode-shape/schema/request.json", "npm/src/types/inertia-request.ts"],
  ["InertiaReport", "polhode-shape/schema/report.json", "npm/src/types/inertia-report.ts"],
  ["CheckRequest", "polhode-robot/schema/request.json", "npm/src/types/check-request.ts"],
  ["CheckReport", "polhode-robot/schema/report.json", "npm/src/types/check-report.ts"],
  ["FreeMotionRequest", "polhode-npm/schema/free-motion/request.json", "npm/src/types/free-motion-request.ts"],
  ["FreeMotionReport", "polhode-npm/schema/free-motion/report.json", "npm/src/types/free-motion-report.ts"],
  ["SimulateRequest", "polhode-scenario/schema/simulate/request.json", "npm/src/types/simulate-request.ts"],
  ["SimulateReport", "polhode-scenario/schema/simulate/report.json", "npm/src/types/simulate-report.ts"],
];

/** Definitions that several schemas of `polhode-scenario` refer to. */
const SHARED = read("polhode-scenario/schema/defs.json");

for (const [name, source, target, imports] of TYPES) {
  const { title, ...schema } = read(source);
  const shared = source.startsWith("polhode-scenario/") ? SHARED : {};
  const banner = [`/* Types of crates/${source}, written by viewer/types.mjs; do not edit. */`, imports].filter(Boolean).join("\n");
  const text = await compile({ ...schema, $defs: { ...shared, ...schema.$defs } }, name, {
    additionalProperties: false,
    bannerComment: banner,
    format: true,
    style: { printWidth: 140 },
  });
  const path = resolve(root, target);
  if (!process.argv.includes("--check")) {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
  } else if (!existsSync(path) || readFileSync(path, "utf8") !== text) {
    console.error(`${relative(root, path)} is stale: run \`npm run build\` in viewer/`);
    process.exitCode = 1;
  }
}
