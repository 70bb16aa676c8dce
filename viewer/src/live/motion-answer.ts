/** The answer to a request for a motion. */
import type { MotionAnswer } from "./protocol";
import { jsonAndRows } from "./rows";

export function motionAnswer(bytes: ArrayBuffer): MotionAnswer {
  const { json, withRows } = jsonAndRows<MotionAnswer>(bytes);
  if (json.motion) {
    const { page } = json.motion;
    page.motion = withRows(page.motion);
    page.free = withRows(page.free);
  }
  return json;
}
