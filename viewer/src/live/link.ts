/** A link that brings a state back: the scenario's text, deflated, behind the address's #. */
import { base64Of, bytesOf } from "../base64";

/** Longer ones are cut off by some programs, characters. */
export const LONGEST = 8000;

interface Linked {
  /** Of the document that it began with. */
  name: string;
  text: string;
}

export async function fragmentOf(linked: Linked): Promise<string> {
  const packed = new Blob([JSON.stringify(linked)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  return `#state=${base64Of(bytes).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** Null if there is none; throws if it is damaged. */
export async function readFragment(fragment: string): Promise<Linked | null> {
  const [, packed] = /^#state=([A-Za-z0-9_-]+)$/.exec(fragment) ?? [];
  if (packed === undefined) return null;
  const bytes = bytesOf(packed.replaceAll("-", "+").replaceAll("_", "/"));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const { name, text } = JSON.parse(await new Response(stream).text()) as Partial<Linked>;
  if (typeof name !== "string" || typeof text !== "string") throw new Error("the link holds no scenario");
  return { name, text };
}
