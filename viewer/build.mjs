// Builds the page: one HTML file with its style and script inside, and a placeholder for the data.
// Writes crates/polhode-report/assets/viewer.html; with --check it only compares, and fails if that file is not this build.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const target = resolve(here, "../crates/polhode-report/assets/viewer.html");
const read = (path) => readFileSync(resolve(here, path), "utf8");
const version = (name) => JSON.parse(read(`node_modules/${name}/package.json`)).version;

const bundle = async (entry, options) => {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    charset: "utf8",
    legalComments: "none",
    write: false,
    logLevel: "warning",
    ...options,
  });
  return result.outputFiles[0].text.trim();
};

const script = await bundle("src/main.ts", {
  format: "iife",
  target: "es2022",
  loader: { ".txt": "text" },
  define: Object.fromEntries(["three", "uplot", "omggif"].map((name) => [`${name.toUpperCase()}_VERSION`, JSON.stringify(version(name))])),
});
const style = await bundle("src/theme.css", { loader: { ".woff2": "dataurl" } });
for (const [what, text] of [["script", script], ["style", style]]) {
  if (new RegExp(`</${what}|<!--`, "i").test(text)) throw new Error(`the ${what} would end its element`);
}

const banner = `<!--
polhode viewer, MIT OR Apache-2.0. Built from viewer/ by "npm run build"; do not edit.
Contains three.js ${version("three")}, MIT licence, copyright 2010-2026 three.js authors,
uPlot ${version("uplot")}, MIT licence, copyright 2022 Leon Sorokin, omggif ${version("omggif")}, MIT licence, copyright 2013 Dean McNamee,
and a part of STIX Two Math, SIL Open Font License 1.1, copyright 2001-2021 The STIX Fonts Project Authors. Their licences stand under "About".
-->`;
// A function as replacement: "$&" in a script is not a pattern.
const put = (page, place, text) => {
  if (page.split(place).length !== 2) throw new Error(`index.html needs one ${place}`);
  return page.replace(place, () => text);
};
let page = read("index.html");
page = put(page, "<!--banner-->", banner);
page = put(page, "<!--style-->", `<style>${style}</style>`);
page = put(page, "<!--script-->", `<script>${script}</script>`);
if (page.split("<!--polhode-data-->").length !== 2) throw new Error("the page needs one place for the data");

if (process.argv.includes("--check")) {
  if (readFileSync(target, "utf8") !== page) {
    console.error("crates/polhode-report/assets/viewer.html is not the build of viewer/: run `npm run build` there");
    process.exit(1);
  }
} else {
  mkdirSync(dirname(target), { recursive: true });
  writeFileSync(target, page);
}
console.log(`${Math.round(Buffer.byteLength(page) / 1000)} kB`);
