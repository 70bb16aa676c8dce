/** Answers: JSON, or JSON with rows of numbers after it, which are read in place. */

/** Size of the length of the JSON, bytes. */
const WORD = 8;
/** The character "{". */
const OPENING = 0x7b;
const KINDS = { f64: Float64Array, f32: Float32Array, u32: Uint32Array };

/**
 * Returns the JSON, and a function that replaces each `{"f64": [at, count]}` in a part of it by the
 * numbers.
 */
export function jsonAndRows<T>(bytes: ArrayBuffer): { json: T; withRows: <U>(value: U) => U } {
  // With rows, the first byte is that of a length, which is a multiple of eight; "{" is not.
  if (new Uint8Array(bytes)[0] === OPENING) return { json: JSON.parse(new TextDecoder().decode(bytes)) as T, withRows: (value) => value };
  const length = Number(new DataView(bytes).getBigUint64(0, true));
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, WORD, length))) as T;
  const withRows = <U>(value: U): U => {
    if (typeof value !== "object" || value === null) return value;
    for (const [kind, Numbers] of Object.entries(KINDS)) {
      if (!(kind in value)) continue;
      const [at, count] = (value as Record<string, [number, number]>)[kind];
      return new Numbers(bytes, WORD + length + Numbers.BYTES_PER_ELEMENT * at, count) as U;
    }
    if (Array.isArray(value)) return value.map((item: unknown) => withRows(item)) as U;
    return Object.fromEntries(Object.entries(value).map(([name, item]: [string, unknown]) => [name, withRows(item)])) as U;
  };
  return { json, withRows };
}
