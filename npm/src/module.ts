/** WebAssembly modules with the functions of polhode (`crates/polhode-wasm`). */
import { PolhodeError, type Failure, refused } from "./error.js";
import { toBytes } from "./files.js";
import { toJson } from "./plain.js";

/** Functions of a module. */
interface Exports {
  memory: WebAssembly.Memory;
  /** Returns the place of `length` bytes for a file or a request. */
  input(length: number): number;
  /** Adds the input as a file: its path of `pathLength` bytes, then its content. */
  put(pathLength: number): void;
  /** Answers the input as a request, forgets the files, and returns the place of the answer. */
  answer(): number;
  answer_length(): number;
}

/** Answer of a module. */
type Answer = { value: unknown } | { failures: [Failure, ...Failure[]] } | { needs: "full" };

/** Place of an array among the numbers of an answer. */
interface Place {
  f64: [number, number];
}

/** An instance of a module. */
interface Running {
  exports: Exports;
  /** Message of a defect. */
  defect: string;
}

/** A module, compiled at its first use. */
class Module {
  readonly #url: URL;
  #compiled: Promise<WebAssembly.Module> | null = null;
  #started: Promise<Running> | null = null;

  constructor(url: URL) {
    this.#url = url;
  }

  /** Answers a request. Its files are known only during the call. */
  async answer(name: string, request: object, files: unknown): Promise<{ answer: Answer; numbers: Float64Array }> {
    const [message, given] = [new TextEncoder().encode(toJson(name, request)), toBytes(files)];
    for (;;) {
      const started = (this.#started ??= this.#start());
      const running = await started;
      // Another call may have stopped this instance meanwhile. From here to the answer nothing waits.
      if (this.#started !== started) continue;
      try {
        return this.#answer(running.exports, message, given);
      } catch (problem) {
        // An instance that has stopped is in an unknown state. The next call starts another one.
        this.#started = null;
        const hint = "this is a defect of polhode, or the memory is exhausted; please report it with the request";
        throw refused(`polhode stopped: ${running.defect || String(problem)}`, hint, "defect");
      }
    }
  }

  #answer(running: Exports, message: Uint8Array, files: [string, Uint8Array][]): { answer: Answer; numbers: Float64Array } {
    for (const [file, content] of files) {
      const path = new TextEncoder().encode(file);
      this.#input(running, path, content);
      running.put(path.length);
    }
    this.#input(running, message);
    return parsed(this.#bytes(running, running.answer(), running.answer_length()));
  }

  /** Starts an instance. A file that cannot be read is read again by the next call. */
  async #start(): Promise<Running> {
    try {
      this.#compiled ??= read(this.#url).then((bytes) => WebAssembly.compile(bytes));
      const running: Running = { exports: {} as Exports, defect: "" };
      const page = {
        panicked: (at: number, length: number) => {
          running.defect = new TextDecoder().decode(this.#bytes(running.exports, at, length));
        },
      };
      const instance = await WebAssembly.instantiate(await this.#compiled, { page });
      running.exports = instance.exports as unknown as Exports;
      return running;
    } catch (problem) {
      this.#compiled = this.#started = null;
      throw problem;
    }
  }

  #bytes(running: Exports, at: number, length: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(running.memory.buffer as ArrayBuffer, at >>> 0, length >>> 0);
  }

  #input(running: Exports, ...parts: Uint8Array[]): void {
    let at = running.input(parts.reduce((sum, part) => sum + part.length, 0));
    for (const part of parts) {
      this.#bytes(running, at, part.length).set(part);
      at += part.length;
    }
  }
}

/** Returns an answer: the length of its JSON as a u64, the JSON, and numbers as f64. */
function parsed(bytes: Uint8Array<ArrayBuffer>): { answer: Answer; numbers: Float64Array } {
  const WORD = 8;
  const copy = bytes.slice().buffer;
  const length = Number(new DataView(copy).getBigUint64(0, true));
  const answer = JSON.parse(new TextDecoder().decode(new Uint8Array(copy, WORD, length))) as Answer;
  return { answer, numbers: new Float64Array(copy, WORD + length) };
}

/** Returns the bytes of a file of the package. */
async function read(url: URL): Promise<BufferSource> {
  if (url.protocol === "file:" && "process" in globalThis) {
    // Bundlers for browsers must not follow this import.
    const name = "node:fs/promises";
    const { readFile } = (await import(/* webpackIgnore: true */ /* @vite-ignore */ name)) as { readFile(url: URL): Promise<Uint8Array<ArrayBuffer>> };
    return readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.href}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** Free motion, and checks of URDF models with STL and OBJ meshes. */
const SMALL = new Module(new URL("./polhode.wasm", import.meta.url));
/** All functions, for all files. */
const FULL = new Module(new URL("./polhode_full.wasm", import.meta.url));

/** Result of a request: JSON, and the numbers of its arrays. */
interface Result {
  value: unknown;
  numbers: Float64Array;
}

/** Answers a request by the small module, or by the full one if the files need it. */
export async function askSmall(name: string, request: object, files?: unknown): Promise<Result> {
  const { answer, numbers } = await SMALL.answer(name, request, files);
  return "needs" in answer ? askFull(name, request, files) : result(answer, numbers);
}

/** Answers a request by the full module. */
export async function askFull(name: string, request: object, files?: unknown): Promise<Result> {
  const { answer, numbers } = await FULL.answer(name, request, files);
  return result(answer, numbers);
}

function result(answer: Answer, numbers: Float64Array): Result {
  if ("failures" in answer) throw new PolhodeError(answer.failures);
  if ("needs" in answer) throw refused("polhode stopped: no module answers this request", null, "defect");
  return { value: answer.value, numbers };
}

/** Puts the arrays of a result at their places. */
export function withArrays({ value, numbers }: Result): unknown {
  if (Array.isArray(value)) return value.map((item: unknown) => withArrays({ value: item, numbers }));
  if (value === null || typeof value !== "object") return value;
  if ("f64" in value) {
    const [at, count] = (value as Place).f64;
    return numbers.slice(at, at + count);
  }
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, withArrays({ value: inner, numbers })]));
}
