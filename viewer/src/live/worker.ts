/**
 * Web Worker with the engine: a WebAssembly module (`crates/polhode-wasm`) that answers one request
 * after the other.
 */
import { XzReadableStream } from "xz-decompress";

import { bytesOf32768 } from "./base32768";
import type { Built, FromWorker, Packed, ToWorker } from "./work";

/** Functions of the module. */
interface Exports {
  memory: WebAssembly.Memory;
  /** Returns the place of `length` bytes for a file or a request. */
  input(length: number): number;
  /** Adds the input as a file: its path of `pathLength` bytes, then its content. */
  put(pathLength: number): void;
  /** Answers the input as a request, and returns the place of the answer. */
  answer(): number;
  answer_length(): number;
}

const scope = self as unknown as { onmessage: (event: MessageEvent<ToWorker>) => void; postMessage: (message: Built | FromWorker, transfer?: Transferable[]) => void };
let exported: Exports | null = null;
/** Message of a defect in the module. */
let defect = "";

const bytesAt = (at: number, length: number): Uint8Array<ArrayBuffer> => new Uint8Array(need().memory.buffer as ArrayBuffer, at >>> 0, length);

function need(): Exports {
  if (!exported) throw new Error("the engine has not started");
  return exported;
}

/** Compiles the module while it is unpacked. */
async function built({ text, length }: Packed): Promise<Built> {
  try {
    const bytes = new XzReadableStream(new Blob([bytesOf32768(text, length)]).stream());
    return { module: await WebAssembly.compileStreaming(new Response(bytes, { headers: { "Content-Type": "application/wasm" } })) };
  } catch (problem) {
    return { problem: String(problem) };
  }
}

function start(module: WebAssembly.Module): void {
  const page = {
    now: () => performance.now(),
    panicked: (at: number, length: number) => {
      defect = new TextDecoder().decode(bytesAt(at, length));
    },
  };
  exported = new WebAssembly.Instance(module, { page }).exports as unknown as Exports;
}

function input(...parts: Uint8Array[]): void {
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  let at = need().input(length);
  for (const part of parts) {
    bytesAt(at, part.length).set(part);
    at += part.length;
  }
}

function answer(request: string): ArrayBuffer {
  const module = need();
  input(new TextEncoder().encode(request));
  const at = module.answer();
  return bytesAt(at, module.answer_length()).slice().buffer;
}

scope.onmessage = ({ data }) => {
  try {
    if ("packed" in data) void built(data.packed).then((answer) => scope.postMessage(answer));
    else if ("module" in data) start(data.module);
    else if ("path" in data) {
      const path = new TextEncoder().encode(data.path);
      input(path, new Uint8Array(data.bytes));
      need().put(path.length);
      scope.postMessage({ done: null, took: 0 });
    } else {
      const since = performance.now();
      const done = answer(data.request);
      scope.postMessage({ done, took: performance.now() - since }, [done]);
    }
  } catch (problem) {
    scope.postMessage({ defect: defect || (problem instanceof WebAssembly.RuntimeError ? null : String(problem)) });
  }
};
