/** Links that restore a state: the scenario's text, deflated, in the fragment of the address. */
import { base64Of, bytesOf } from "../base64";

/** Maximum length of a link, characters. Some programs cut off longer ones. */
export const LONGEST = 8000;

interface Linked {
  /** Name of the original document. */
  name: string;
  text: string;
}

export async function fragmentOf(linked: Linked): Promise<string> {
  const packed = new Blob([JSON.stringify(linked)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  return `#state=${base64Of(bytes).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** Returns null if there is none; throws if it is damaged. */
export async function readFragment(fragment: string): Promise<Linked | null> {
  const [, packed] = /^#state=([A-Za-z0-9_-]+)$/.exec(fragment) ?? [];
  if (packed === undefined) return null;
  const bytes = bytesOf(packed.replaceAll("-", "+").replaceAll("_", "/"));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const { name, text } = JSON.parse(await new Response(stream).text()) as Partial<Linked>;
  if (typeof name !== "string" || typeof text !== "string") throw new Error("the link holds no scenario");
  return { name, text };
}
