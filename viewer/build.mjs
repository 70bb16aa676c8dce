// Builds the pages: the one that polhode writes, one HTML file with its style and script inside and a placeholder for the data, and that of
// `polhode live`, whose style and script are files of their own; and what notebooks have around the first. Writes
// crates/polhode-scenario/assets/viewer.html, crates/polhode-live/assets/ and crates/polhode-py/python/polhode/; with --check it only compares, and
// fails if those files are not this build.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const assets = (crate) => resolve(here, `../crates/${crate}/assets`);
const read = (path) => readFileSync(resolve(here, path), "utf8");
const version = (name) => JSON.parse(read(`node_modules/${name}/package.json`)).version;

const bundle = async (entry, options) => {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: !process.argv.includes("--plain"),
    charset: "utf8",
    legalComments: "none",
    write: false,
    logLevel: "warning",
    ...options,
  });
  return result.outputFiles[0].text.trim();
};

const script = (entry, codemirror) =>
  bundle(entry, {
    format: "iife",
    target: "es2022",
    loader: { ".txt": "text" },
    define: {
      THREE_VERSION: JSON.stringify(version("three")),
      UPLOT_VERSION: JSON.stringify(version("uplot")),
      OMGGIF_VERSION: JSON.stringify(version("omggif")),
      FFLATE_VERSION: JSON.stringify(version("fflate")),
      CODEMIRROR_VERSION: JSON.stringify(codemirror),
    },
  });
const style = (entry) => bundle(entry, { loader: { ".woff2": "dataurl" } });

const banner = `<!--
polhode viewer, MIT OR Apache-2.0. Built from viewer/ by "npm run build"; do not edit.
Contains three.js ${version("three")}, MIT licence, copyright 2010-2026 three.js authors,
uPlot ${version("uplot")}, MIT licence, copyright 2022 Leon Sorokin, omggif ${version("omggif")}, MIT licence, copyright 2013 Dean McNamee,
fflate ${version("fflate")}, MIT licence, copyright 2026 Arjun Barrett,
and a part of STIX Two Math, SIL Open Font License 1.1, copyright 2001-2021 The STIX Fonts Project Authors. Their licences stand under "About".
-->`;
// A function as replacement: "$&" in a script is not a pattern.
const put = (page, place, text) => {
  if (page.split(place).length !== 2) throw new Error(`index.html needs one ${place}`);
  return page.replace(place, () => text);
};
const inside = (what, text) => {
  if (new RegExp(`</${what}|<!--`, "i").test(text)) throw new Error(`the ${what} would end its element`);
  return `<${what}>${text}</${what}>`;
};

const index = read("index.html");
let replay = put(put(index, "<!--banner-->", banner), "<!--style-->", inside("style", await style("src/theme.css")));
replay = put(replay, "<!--script-->", inside("script", await script("src/main.ts", "")));
if (replay.split("<!--polhode-data-->").length !== 2) throw new Error("the page needs one place for the data");

// The server sends the policy.
let live = index.replace(/<meta http-equiv="Content-Security-Policy"[^>]*>\n/, "");
live = put(live, "<!--banner-->", banner.replace("\nuPlot", `\nCodeMirror ${version("@codemirror/view")}, MIT licence, copyright 2018-2026 Marijn Haverbeke and others,\nuPlot`));
live = put(live, "<!--style-->", '<link rel="icon" href="data:,">\n<link rel="stylesheet" href="live.css">');
live = put(live, "<!--polhode-data-->\n", "");
live = put(live, "<!--script-->", '<script src="live.js"></script>');

const wheel = resolve(assets("polhode-py"), "../python/polhode");
const display = await bundle("src/notebook/display.ts", { format: "iife", target: "es2022" });
inside("script", display);
const built = {
  [`${assets("polhode-scenario")}/viewer.html`]: replay,
  [`${assets("polhode-live")}/live.html`]: live,
  [`${assets("polhode-live")}/live.css`]: await style("src/live/live.css"),
  [`${assets("polhode-live")}/live.js`]: await script("src/live/main.ts", version("@codemirror/view")),
  [`${wheel}/_display.js`]: display,
  [`${wheel}/_widget.js`]: await bundle("src/notebook/widget.ts", { format: "esm", target: "es2022" }),
  [`${wheel}/_widget.css`]: await style("src/notebook/widget.css"),
};
for (const [path, text] of Object.entries(built)) {
  const name = relative(resolve(here, ".."), path);
  if (!process.argv.includes("--check")) {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
  } else if (!existsSync(path) || readFileSync(path, "utf8") !== text) {
    console.error(`${name} is not the build of viewer/: run \`npm run build\` there`);
    process.exitCode = 1;
  }
  console.log(`${name}: ${Math.round(Buffer.byteLength(text) / 1000)} kB`);
}
