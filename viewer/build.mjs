// Builds the pages. Without arguments: the replay that polhode writes, one HTML file with its style and script inside and a placeholder for the
// data, and what notebooks have around it, in crates/polhode-scenario/assets/viewer.html and crates/polhode-py/python/polhode/; with --check it only
// compares, and fails if those files are not this build.
// With --module MODULE.wasm.xz --page PAGE.html [--commit COMMIT]: the interactive page, one file with the engine, the script and the style inside.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { build } from "esbuild";
import { engine } from "./engine.mjs";

const { values: given } = parseArgs({ options: { check: { type: "boolean" }, plain: { type: "boolean" }, module: { type: "string" }, page: { type: "string" }, commit: { type: "string" } } });
/** Samples of the first motion: ten in a second, in which the body turns by one radian. */
const FIRST_SAMPLES = 201;

const here = dirname(fileURLToPath(import.meta.url));
const assets = (crate) => resolve(here, `../crates/${crate}/assets`);
const read = (path) => readFileSync(resolve(here, path), "utf8");
const version = (name) => JSON.parse(read(`node_modules/${name}/package.json`)).version;

const bundle = async (entry, options) => {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: !given.plain,
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
      XZ_VERSION: JSON.stringify(version("xz-decompress")),
      CODEMIRROR_VERSION: JSON.stringify(codemirror),
    },
  });
const style = (entry) => bundle(entry, { loader: { ".woff2": "dataurl" } });

/** Imports a module of the viewer. */
const imported = async (path) => import(`data:text/javascript,${encodeURIComponent(await bundle(path, { format: "esm", target: "es2022" }))}`);

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
const built = given.module ? await interactive() : await replay();

/** The replay, and what notebooks have around it. */
async function replay() {
  let page = put(put(index, "<!--banner-->", banner), "<!--style-->", inside("style", await style("src/theme.css")));
  page = put(page, "<!--script-->", inside("script", await script("src/main.ts", "")));
  if (page.split("<!--polhode-data-->").length !== 2) throw new Error("the page needs one place for the data");
  const wheel = resolve(assets("polhode-py"), "../python/polhode");
  const display = await bundle("src/notebook/display.ts", { format: "iife", target: "es2022" });
  inside("script", display);
  return {
    [`${assets("polhode-scenario")}/viewer.html`]: page,
    [`${wheel}/_display.js`]: display,
    [`${wheel}/_widget.js`]: await bundle("src/notebook/widget.ts", { format: "esm", target: "es2022" }),
    [`${wheel}/_widget.css`]: await style("src/notebook/widget.css"),
  };
}

/**
 * The motion of the example, computed by the engine, for the time until the page has compiled it. To be small it has fewer samples, in
 * single precision, and no curves of other motions of the body.
 */
async function firstMotion(module) {
  const { motionAnswer } = await imported("src/live/motion-answer.ts");
  const { answer, ask } = engine(readFileSync(module));
  const { id } = ask('"open_example"');
  const { text } = ask({ document: { id } });
  const short = text.replace(/^samples = \d+$/m, `samples = ${FIRST_SAMPLES}`);
  if (short === text) throw new Error("the example does not state its samples");
  const bytes = answer({ motion: { document: id, text: short, edits: [], error: false, working: false, body: null } });
  const { page } = motionAnswer(Uint8Array.from(bytes).buffer).motion;
  const packed = (value) => {
    if (value instanceof Float64Array) return Buffer.from(Float64Array.from(value, Math.fround).buffer).toString("base64");
    if (typeof value !== "object" || value === null) return value;
    return Array.isArray(value) ? value.map(packed) : Object.fromEntries(Object.entries(value).map(([name, item]) => [name, packed(item)]));
  };
  return packed({ ...page, free: { ...page.free, family: [], separatrix: [] } });
}

/** Compresses a text as gzip, 4 % smaller than zlib does. */
async function smallest(text) {
  const { default: zopfli } = await import("@gfx/zopfli");
  return zopfli.gzipAsync(Buffer.from(text), { numiterations: 15 });
}

/**
 * The interactive page, in UTF-16: its parts are compressed, in base 32768; `src/live/boot.ts` and `worker.ts` unpack them. A browser knows the encoding
 * from the byte order mark, whatever a server says of it.
 */
async function interactive() {
  const codemirror = version("@codemirror/view");
  const { text32768 } = await imported("src/live/base32768.ts");
  const packed = (id, bytes) => `<script type="application/octet-stream" id="${id}" data-length="${bytes.length}">${text32768(bytes)}</script>`;
  const viewer = {
    style: await style("src/live/live.css"),
    script: await script("src/live/main.ts", codemirror),
    worker: await bundle("src/live/worker.ts", { format: "iife", target: "es2022" }),
    first: await firstMotion(given.module.replace(/\.xz$/, "")),
  };
  const parts = [
    packed("polhode-module", readFileSync(given.module)),
    packed("polhode-viewer", await smallest(JSON.stringify(viewer))),
    inside("script", await bundle("src/live/boot.ts", { format: "iife", target: "es2022" })),
  ];
  const policy = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:; connect-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; font-src data:";
  let page = index.replace(/(<meta http-equiv="Content-Security-Policy" content=")[^"]*/, (_, start) => start + policy);
  const licences = banner.replace("\nuPlot", `\nCodeMirror ${codemirror}, MIT licence, copyright 2018-2026 Marijn Haverbeke and others,\nxz-decompress ${version("xz-decompress")}, MIT licence, copyright Steve Sanderson and others,\nuPlot`);
  const built = given.commit ? `of commit ${given.commit} by "cargo xtask page"` : 'by "cargo xtask viewer"';
  page = put(page, "<!--banner-->", licences.replace('from viewer/ by "npm run build"', `with the engine, ${built}`));
  page = put(page, "<!--style-->", '<link rel="icon" href="data:,">\n<style id="starting">body > * { visibility: hidden } #problem { visibility: visible }</style>');
  page = put(page, "<!--polhode-data-->", "<!--polhode-files-->");
  page = put(page, '<meta charset="utf-8">\n', "");
  page = put(page, "<!--script-->", parts.join("\n"));
  return { [resolve(given.page)]: Buffer.from(`\ufeff${page}`, "utf16le") };
}

for (const [path, text] of Object.entries(built)) {
  const name = relative(resolve(here, ".."), path);
  if (!given.check) {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
  } else if (!existsSync(path) || readFileSync(path, "utf8") !== text) {
    console.error(`${name} is not the build of viewer/: run \`npm run build\` there`);
    process.exitCode = 1;
  }
  console.log(`${name}: ${Math.round(Buffer.byteLength(text) / 1000)} kB`);
}
