/**
 * Start of the page: unpacks the script of the page, the worker's script and the module of the
 * engine, which the page contains as gzip in base 85.
 */
import { bytesOf85 } from "./base85";

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
  const [page, worker] = await Promise.all(["polhode-page", "polhode-worker"].map((id) => unpacked(id).text()));
  window.polhodeEmbedded = { module, worker: URL.createObjectURL(new Blob([worker], { type: "text/javascript" })) };
  const script = document.createElement("script");
  script.textContent = page;
  document.body.append(script);
}

start().catch((problem: unknown) => {
  const place = document.getElementById("problem");
  if (!place) return;
  place.hidden = false;
  place.textContent = `The page cannot start: ${problem instanceof Error ? problem.message : String(problem)}. It needs a browser of 2023 or later with WebAssembly.`;
});
