/**
 * Data of a page in a notebook, as `polhode` in Python stores them (`_display.py`): the page's JSON,
 * deflated as in zlib.
 */
import type { PageData } from "./data";
import { BadData, checked } from "./decode";

/** Returns the bytes that were deflated. */
export function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Blob> {
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).blob();
}

/** Returns the data of a page. Throws `BadData` if they are damaged. */
export async function unpack(packed: Uint8Array<ArrayBuffer>): Promise<PageData> {
  let text: string;
  try {
    text = await (await inflated(packed)).text();
  } catch {
    throw new BadData("the motion's data are damaged");
  }
  return checked(JSON.parse(text) as PageData);
}
