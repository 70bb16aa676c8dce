/**
 * Data of the page as typed arrays. All checks are here: the results have the lengths that the
 * contract promises and finite numbers.
 */
import { bytesOf } from "./base64";
import type { Base64, Indices, PageData, Row, Row32 } from "./data";

/** Error for data that violate the contract. */
export class BadData extends Error {
  constructor(what: string) {
    super(what);
    this.name = "BadData";
  }
}

/** Finds the data in a document. */
export function readPage(from: Document): PageData {
  const text = from.getElementById("polhode-data")?.textContent;
  if (!text) throw new BadData("this page holds no motion; polhode writes it into a page of its own");
  return checked(JSON.parse(text) as PageData);
}

/** Checks that the data have the version that this page reads. */
export function checked(page: PageData): PageData {
  if (page.version !== 1) throw new BadData(`data of version ${String(page.version)}; this page reads version 1`);
  return page;
}

/** Returns finite 64-bit numbers, `length` of them if given. */
export function f64(row: Row, what: string, length?: number): Float64Array {
  const numbers = typeof row === "string" ? new Float64Array(decode(row, what, 8).buffer) : row;
  if (length !== undefined && numbers.length !== length) {
    throw new BadData(`${what}: ${numbers.length} numbers instead of ${length}`);
  }
  if (!areFinite(numbers)) throw new BadData(`${what}: a number is not finite`);
  return numbers;
}

/** Returns points of three 64-bit numbers. */
export function points(row: Row, what: string): Float64Array {
  const numbers = f64(row, what);
  if (numbers.length % 3 !== 0) throw new BadData(`${what}: ${numbers.length} numbers are not points`);
  return numbers;
}

/** Returns finite 32-bit numbers. */
export function f32(row: Row32, what: string): Float32Array {
  const numbers = typeof row === "string" ? new Float32Array(decode(row, what, 4).buffer) : row;
  if (!areFinite(numbers)) throw new BadData(`${what}: a number is not finite`);
  return numbers;
}

/** Returns indices below `limit`. */
export function indices(row: Indices, what: string, limit: number): Uint32Array {
  const numbers = typeof row === "string" ? new Uint32Array(decode(row, what, 4).buffer) : row;
  if (!areBelow(numbers, limit)) throw new BadData(`${what}: an index is beyond ${limit - 1}`);
  return numbers;
}

function areBelow(numbers: Uint32Array, limit: number): boolean {
  for (let i = 0; i < numbers.length; i += 1) if (numbers[i] >= limit) return false;
  return true;
}

// The product is NaN for numbers that are not finite, and 0 for all others.
function areFinite(numbers: Float32Array | Float64Array): boolean {
  let sum = 0;
  for (let i = 0; i < numbers.length; i += 1) sum += 0 * numbers[i];
  return sum === 0;
}

// Typed arrays have the byte order of the machine. All machines that run browsers are
// little-endian.
function decode(text: Base64, what: string, size: number): Uint8Array<ArrayBuffer> {
  let bytes: Uint8Array<ArrayBuffer>;
  try {
    bytes = bytesOf(text);
  } catch {
    throw new BadData(`${what}: not base64`);
  }
  if (bytes.length % size !== 0) throw new BadData(`${what}: ${bytes.length} bytes, not a multiple of ${size}`);
  return bytes;
}
