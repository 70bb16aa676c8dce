/**
 * Start of the page: unpacks its style, its script, the worker's script and the module of the
 * engine, which the page contains as gzip in base 85.
 */
import { bytesOf85 } from "./base85";

/** Parts of the viewer, as they are packed. */
export interface Viewer {
  style: string;
  script: string;
  worker: string;
}

export interface Embedded {
  module: Promise<WebAssembly.Module>;
  /** Address of the worker's script. */
  worker: string;
}

function unpacked(id: string): Response {
  const place = document.getElementById(id);
  const bytes = bytesOf85(place?.textContent ?? "", Number(place?.dataset.length));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")), { headers: { "Content-Type": "application/wasm" } });
}

async function start(): Promise<void> {
  const module = WebAssembly.compileStreaming(unpacked("polhode-module"));
  // A page that cannot compile the module says so when it asks the engine.
  module.catch(() => null);
  const { style, script, worker } = (await unpacked("polhode-viewer").json()) as Viewer;
  window.polhodeEmbedded = { module, worker: URL.createObjectURL(new Blob([worker], { type: "text/javascript" })) };
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
  place.textContent = `The page cannot start: ${problem instanceof Error ? problem.message : String(problem)}. It needs a browser of 2023 or later with WebAssembly.`;
});
