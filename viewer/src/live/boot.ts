/**
 * Start of the page: unpacks its style, its script and the worker's script, which the page contains
 * as gzip in base 32768. A worker unpacks the module of the engine meanwhile.
 */
import type { PageData } from "../data";
import { bytesOf32768 } from "./base32768";
import type { Built, Packed } from "./work";

/** Parts of the viewer, as they are packed. */
export interface Viewer {
  style: string;
  script: string;
  worker: string;
  /** Motion of the example, shown until the engine has started. */
  first: PageData;
}

export interface Embedded {
  module: Promise<WebAssembly.Module>;
  /** Address of the worker's script. */
  worker: string;
  first: PageData;
}

function packed(id: string): Packed {
  const place = document.getElementById(id);
  return { text: place?.textContent ?? "", length: Number(place?.dataset.length) };
}

async function viewer(): Promise<Viewer> {
  const { text, length } = packed("polhode-viewer");
  return new Response(new Blob([bytesOf32768(text, length)]).stream().pipeThrough(new DecompressionStream("gzip"))).json() as Promise<Viewer>;
}

/** Compiles the module in a worker of its own. */
function compiled(script: string): Promise<WebAssembly.Module> {
  const worker = new Worker(script);
  return new Promise<WebAssembly.Module>((done, fail) => {
    worker.onmessage = ({ data }: MessageEvent<Built>) => {
      if ("module" in data) done(data.module);
      else fail(new Error(data.problem));
    };
    worker.onerror = (event) => fail(new Error(event.message || "its worker cannot be started"));
    worker.postMessage({ packed: packed("polhode-module") });
  }).finally(() => worker.terminate());
}

async function start(): Promise<void> {
  const { style, script, worker: text, first } = await viewer();
  const worker = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  const module = compiled(worker);
  // A page that cannot compile the module says so when it asks the engine.
  module.catch(() => null);
  window.polhodeEmbedded = { module, worker, first };
  for (const [kind, text] of [["style", style], ["script", script]]) {
    const part = document.createElement(kind);
    part.textContent = text;
    document.body.append(part);
  }
  document.getElementById("starting")?.remove();
}

start().catch((problem: unknown) => {
  const place = document.getElementById("problem");
  if (!place) return;
  place.hidden = false;
  place.textContent = `The page cannot start: ${problem instanceof Error ? problem.message : String(problem)}. It needs a browser of June 2024 or later with WebAssembly.`;
});
