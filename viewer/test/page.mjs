// Puts data into the built page. As a command: node test/page.mjs [DATA.json] [PAGE.html]; without data, the sample's.
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { samples } from "./sample.mjs";

const here = dirname(fileURLToPath(import.meta.url));
export const template = resolve(here, "../../crates/polhode-scenario/assets/viewer.html");

export function pageOf(data) {
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  const script = `<script id="polhode-data" type="application/json">${json}</script>`;
  return readFileSync(template, "utf8").replace("<!--polhode-data-->", () => script);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [data, page = resolve(here, "../out/page.html")] = process.argv.slice(2);
  const { mkdirSync } = await import("node:fs");
  mkdirSync(dirname(page), { recursive: true });
  writeFileSync(page, pageOf(data ? JSON.parse(readFileSync(data, "utf8")) : samples.free()));
  console.log(page);
}
