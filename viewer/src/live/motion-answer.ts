/** The answer to `POST motion`, whose rows of numbers stand behind its JSON: they are read where they are. */
import type { MotionAnswer } from "./protocol";

/** Of the length of the JSON, and of a number. */
const WORD = 8;

export function motionAnswer(bytes: ArrayBuffer): MotionAnswer {
  const length = Number(new DataView(bytes).getBigUint64(0, true));
  const answer = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, WORD, length))) as MotionAnswer;
  if (answer.motion) {
    const { page } = answer.motion;
    const rows = new Float64Array(bytes, WORD + length);
    page.motion = withRows(page.motion, rows);
    page.free = withRows(page.free, rows);
  }
  return answer;
}

/** In the place of each `{"f64": [at, count]}` so many of the numbers. */
function withRows<T>(value: T, rows: Float64Array): T {
  if (typeof value !== "object" || value === null) return value;
  if ("f64" in value) {
    const [at, count] = value.f64 as [number, number];
    return rows.subarray(at, at + count) as T;
  }
  if (Array.isArray(value)) return value.map((item: unknown) => withRows(item, rows)) as T;
  return Object.fromEntries(Object.entries(value).map(([name, item]: [string, unknown]) => [name, withRows(item, rows)])) as T;
}
