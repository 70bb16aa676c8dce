// A server that answers as `polhode live` does, with sample motions: for work on the page before the program is built.
// node test/stub.mjs [PORT]
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { samples } from "./sample.mjs";

const assets = resolve(dirname(fileURLToPath(import.meta.url)), "../../crates/polhode-live/assets");
const POLICY =
  "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src data:; connect-src 'self'; " +
  "worker-src blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";
const TEXT = `# A stub
title = "T-handle in free fall"

[[body.part]]
name = "bar"
shape = "cylinder"
radius = "5.5 mm"
length = "74 mm"

[start]
spin = { body = ["11 rad/s", "0.31 rad/s", "0.52 rad/s"] }

[run]
duration = "20 s"
samples = 2001
`;

/** Keys, and where their values stand. */
const KEYS = {
  "body.part[0].radius": /(radius = )("[^"]*"|\S+)/,
  "body.part[0].length": /(length = )("[^"]*"|\S+)/,
  "start.spin.body[0]": /(body = \[)("[^"]*"|[^,\]]+)/,
  "start.spin.body[1]": /(body = \[[^,]+, )("[^"]*"|[^,\]]+)/,
  "start.spin.body[2]": /(body = \[[^,]+, [^,]+, )("[^"]*"|[^,\]]+)/,
  "run.duration": /(duration = )("[^"]*"|\S+)/,
};

const made = new Map();
function pageOf(omega, radius) {
  const factor = Math.min(Math.max(Math.round(omega / 0.5) * 0.5, 0.5), 40) / 11;
  if (!made.has(factor)) {
    const page = samples.free();
    // The same motion, faster: times shrink and rates grow.
    const scale = (text, by) => {
      const all = new Float64Array(Uint8Array.from(Buffer.from(text, "base64")).buffer).map((x) => x * by);
      return Buffer.from(all.buffer).toString("base64");
    };
    page.motion.times = scale(page.motion.times, 1 / factor);
    page.motion.omega = scale(page.motion.omega, factor);
    page.motion.momentum = scale(page.motion.momentum, factor);
    page.motion.kinetic = scale(page.motion.kinetic, factor ** 2);
    made.set(factor, page);
  }
  const page = structuredClone(made.get(factor));
  page.body.shapes[0].radius = radius / 1000;
  return page;
}

function answer({ text, edits, body, working }) {
  for (const edit of edits) {
    if (edit.set && KEYS[edit.set]) text = text.replace(KEYS[edit.set], (_, before) => before + edit.value);
    if (edit.omega) text = text.replace(/body = \[[^\]]*\]/, `body = [${edit.omega.map((w) => JSON.stringify(`${Number(w.toPrecision(6))} rad/s`)).join(", ")}]`);
    if (edit.moments) text = text.replace(/shape = "cylinder"[^[]*/, `shape = "tensor"\nmoments = ${JSON.stringify(edit.moments)}\n\n`);
  }
  const numbers = {};
  for (const [key, pattern] of Object.entries(KEYS)) {
    const found = pattern.exec(text);
    if (!found) continue;
    const [, value, unit] = /^"?([-+.\deE]+)\s*([^"]*)"?$/.exec(found[2]) ?? [];
    const from = found.index + found[1].length;
    if (value === undefined || !["mm", "in", "rad/s", "s", ""].includes(unit)) {
      const line = text.slice(0, from).split("\n");
      const error = { message: `\`${unit ?? found[2]}\` is no unit of a length`, hint: 'lengths are in m, mm, in: "4 mm"', from, to: from + found[2].length, line: line.length, column: line.at(-1).length + 1 };
      return { text, motion: null, knobs: knobs(numbers), switches: [], errors: [error], took: 1 };
    }
    numbers[key] = { value: Number(value), unit };
  }
  const radius = numbers["body.part[0].radius"]?.value ?? 5;
  const page = pageOf(numbers["start.spin.body[0]"].value, radius);
  if (!working) page.explanation = [];
  page.scenario = text;
  const key = String(radius);
  if (body === key) page.body.shapes = [];
  return { text, motion: { page, body: key }, knobs: knobs(numbers), switches: [{ key: "torque[0].on", label: "drag", on: true }], errors: [], took: 2 };
}

function knobs(numbers) {
  return Object.entries(numbers).map(([key, { value, unit }], rank) => ({
    key,
    label: key.split(".").at(-1),
    group: key.split(".")[0].replace("body", "body"),
    value,
    unit,
    si: key.startsWith("start") ? "rad/s" : "m",
    what: "a number",
    low: value > 0 ? value / 10 : value - 1,
    high: value > 0 ? value * 10 : value + 1,
    scale: value > 0 ? "log" : "linear",
    rank,
  }));
}

export function serve(port = 0) {
  const file = { id: 1, name: "t-handle.toml", kind: "scenario", stamp: "1" };
  const state = { file, text: TEXT };
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, "http://stub").pathname.replace(/^\/token\//, "");
    const send = (type, content, status = 200) => {
      response.writeHead(status, { "Content-Type": type, "Content-Security-Policy": POLICY });
      response.end(content);
    };
    const json = (value, status) => send("application/json", JSON.stringify(value), status);
    const chunks = [];
    for await (const chunk of request) chunks.push(chunk);
    const asked = () => JSON.parse(Buffer.concat(chunks).toString());
    if (path === "") send("text/html", readFileSync(`${assets}/live.html`));
    else if (path === "live.js") send("text/javascript", readFileSync(`${assets}/live.js`));
    else if (path === "live.css") send("text/css", readFileSync(`${assets}/live.css`));
    else if (path === "documents") json({ documents: [state.file], first: 1 });
    else if (path === "document/1") json({ kind: "scenario", text: state.text });
    else if (path === "motion") json(answer(asked()));
    else if (path === "complete") {
      const { text, at } = asked();
      const from = at - /\w*$/.exec(text.slice(0, at))[0].length;
      json({ from, to: at, options: [{ label: "duration", detail: "how long, a time" }, { label: "density", detail: "kg/m³" }] });
    } else json({ message: `there is no ${path}`, hint: null }, 404);
  });
  return new Promise((resolve) => {
    server.listen(port, "127.0.0.1", () => resolve({ address: `http://127.0.0.1:${server.address().port}/token/`, state, close: () => server.close() }));
  });
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) console.log((await serve(Number(process.argv[2] ?? 0))).address);
