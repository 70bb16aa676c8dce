// The module of the engine in Node. POLHODE_MODULE names it, else it is the one that `cargo xtask web` has built.
import { readFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
export const path = process.env.POLHODE_MODULE ?? resolve(root, "target/page/polhode.wasm");

/** A fresh engine. `put` adds a file, `answer` gives the bytes of an answer, `ask` its JSON. */
export function engine(bytes = readFileSync(path)) {
  let defect = "";
  let exported;
  const page = {
    now: () => performance.now(),
    panicked: (at, length) => {
      defect = Buffer.from(exported.memory.buffer, at >>> 0, length).toString();
    },
  };
  exported = new WebAssembly.Instance(new WebAssembly.Module(bytes), { page }).exports;
  const input = (bytes) => {
    const at = exported.input(bytes.length) >>> 0;
    new Uint8Array(exported.memory.buffer, at, bytes.length).set(bytes);
  };
  const answer = (message) => {
    input(Buffer.from(typeof message === "string" ? message : JSON.stringify(message)));
    try {
      const at = exported.answer() >>> 0;
      return Buffer.from(exported.memory.buffer, at, exported.answer_length());
    } catch (problem) {
      throw new Error(defect || String(problem));
    }
  };
  const put = (path, content) => {
    const name = Buffer.from(path);
    input(Buffer.concat([name, Buffer.from(content)]));
    exported.put(name.length);
  };
  const ask = (message) => {
    const bytes = answer(message);
    if (bytes[0] === 0x7b) return JSON.parse(bytes.toString());
    return JSON.parse(bytes.subarray(8, 8 + Number(bytes.readBigUInt64LE(0))).toString());
  };
  return { put, answer, ask, memory: () => exported.memory.buffer.byteLength };
}
