/**
 * The data of a page, packed for a notebook by `polhode` in Python (`_packed.py`): the length of the JSON as a u32, the JSON, and its rows of
 * numbers behind it, all deflated as zlib does.
 *
 * In the place of a row the JSON has a `PackedRow`. A number is (zero + q)/per with a whole number q < 2³²; of the rows of q stand differences
 * of some order, of either sign by turns (0, −1, 1, −2, …), column after column, the lowest bytes of all first.
 */
import type { PageData } from "./data";
import { BadData, checked } from "./decode";

interface PackedRow {
  row: { kind: "f64" | "f32" | "u32" | "float"; at: number; count: number; bytes: number; order: number; zero: number[]; per: number[] };
}

/** Of the length of the JSON. */
const WORD = 4;

/** Bits that a number of kind "float" has less than one of 32. */
const SHORT = 12;

/** What stands in an element as base64. */
export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64.trim()), (c) => c.charCodeAt(0));
}

export async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

/** The data, with typed arrays as rows. */
export async function unpack(packed: Uint8Array<ArrayBuffer>): Promise<PageData> {
  let bytes: ArrayBuffer;
  try {
    bytes = await inflated(packed);
  } catch {
    throw new BadData("the motion's data are damaged");
  }
  const length = new DataView(bytes).getUint32(0, true);
  const page = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, WORD, length))) as PageData;
  return withRows(checked(page), new Uint8Array(bytes, WORD + length)) as PageData;
}

function withRows(value: unknown, bytes: Uint8Array): unknown {
  if (typeof value !== "object" || value === null) return value;
  if (Array.isArray(value)) return value.map((item: unknown) => withRows(item, bytes));
  if ("row" in value) return numbers((value as PackedRow).row, bytes);
  return Object.fromEntries(Object.entries(value).map(([name, item]: [string, unknown]) => [name, withRows(item, bytes)]));
}

function numbers({ kind, at, count, bytes: width, order, zero, per }: PackedRow["row"], bytes: Uint8Array): Float64Array | Float32Array | Uint32Array {
  const columns = zero.length;
  const all = count * columns;
  if (at + all * width > bytes.length) throw new BadData("the motion's data end too early");
  const found = kind === "f32" ? new Float32Array(all) : kind === "u32" ? new Uint32Array(all) : new Float64Array(all);
  const whole = new Int32Array(count);
  const float = new Float32Array(whole.buffer);
  for (let column = 0; column < columns; column += 1) {
    for (let i = 0; i < count; i += 1) {
      let code = 0;
      for (let k = 0; k < width; k += 1) code |= bytes[at + k * all + column * count + i] << (8 * k);
      whole[i] = (code >>> 1) ^ -(code & 1);
    }
    // Sums beyond 32 bits come back: the last ones are within them.
    for (let k = 0; k < order; k += 1) for (let i = 1; i < count; i += 1) whole[i] += whole[i - 1];
    for (let i = 0; i < count; i += 1) {
      if (kind === "float") whole[i] <<= SHORT;
      found[i * columns + column] = kind === "float" ? float[i] : (zero[column] + (whole[i] >>> 0)) / per[column];
    }
  }
  return found;
}
