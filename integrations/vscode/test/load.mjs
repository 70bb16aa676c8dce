// Loads modules of src/ that do not use VS Code.
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
export const root = resolve(here, "../../..");
export const worker = resolve(here, "../dist/worker.mjs");
export const example = (name) => readFileSync(join(root, "examples", name), "utf8");

export async function load(name) {
  const { outputFiles } = await build({
    entryPoints: [resolve(here, `../src/${name}.ts`)],
    bundle: true,
    platform: "node",
    format: "esm",
    write: false,
    loader: { ".txt": "text" },
    alias: { "scenario.schema.json": resolve(here, "../dist/scenario.schema.json") },
  });
  const file = resolve(here, `../dist/test-${name}.mjs`);
  writeFileSync(file, outputFiles[0].text);
  try {
    return await import(pathToFileURL(file).href);
  } finally {
    rmSync(file);
  }
}
