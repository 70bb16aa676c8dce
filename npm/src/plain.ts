/** Requests as JSON. */
import { refused } from "./error.js";

/** Largest depth of objects in a request; a valid one has 3 levels. */
const DEEPEST = 20;

/** Path of the request itself in messages. */
const REQUEST = "the request";

/**
 * Returns a request to a function as JSON. Values that JSON would change in silence are refused: it writes null
 * for NaN, and nothing for the contents of a Map.
 */
export function toJson(name: string, request: object): string {
  return JSON.stringify({ [name]: plain(request, REQUEST, 0) });
}

function plain(value: unknown, path: string, depth: number): unknown {
  if (depth > DEEPEST) throw refused(`${path} is nested too deeply`, "a request is plain data");
  if (value === null || value === undefined || typeof value === "boolean") return value;
  if (typeof value === "string") return wellFormed(value, path);
  if (typeof value === "number") {
    if (Number.isFinite(value)) return value;
    throw refused(`${path} = ${value} must be a finite number`, "leave the key out, or give null, for no value");
  }
  if (typeof value === "object") {
    const isList = Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
    if (isList) return Array.from(value as unknown as Iterable<unknown>, (item, k) => plain(item ?? null, `${path}[${k}]`, depth + 1));
    if (Object.prototype.toString.call(value) === "[object Object]") {
      const name = (key: string) => (path === REQUEST ? key : `${path}.${key}`);
      return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner, name(key), depth + 1)]));
    }
  }
  throw refused(`${path} must be plain data, not ${Object.prototype.toString.call(value).slice(8, -1)}`, "use numbers, strings, booleans, lists and objects");
}

/** Returns a text that UTF-8 can represent. */
export function wellFormed(text: string, path: string): string {
  if (text.isWellFormed()) return text;
  throw refused(`${path} contains half of a surrogate pair, which is not a character`, "pass the bytes of the file as a Uint8Array");
}
