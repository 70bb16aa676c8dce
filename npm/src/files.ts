/** Files of a request. */
import { refused } from "./error.js";
import { wellFormed } from "./plain.js";

/** Contents of files by name, as text or bytes. Names may have folders: "robot/meshes/arm.stl". */
export type Files = Readonly<Record<string, string | Uint8Array | ArrayBuffer>>;

/** Returns names and bytes of the files. */
export function toBytes(files: unknown): [string, Uint8Array][] {
  if (files === undefined || files === null) return [];
  if (Object.prototype.toString.call(files) !== "[object Object]") {
    throw refused("files must be an object", 'write files: {"NAME": text or bytes}');
  }
  return Object.entries(files).map(([name, content]) => [checked(name), bytes(name, content)]);
}

/** Returns a name whose spelling is the only one of its file. */
function checked(name: string): string {
  const parts = wellFormed(name, `files: the name ${JSON.stringify(name)}`).split("/");
  if (parts.some((part) => part === "" || part === "." || part === ".." || part.includes("\0"))) {
    throw refused(`files: the name ${JSON.stringify(name)} must be a relative path without empty parts, "." and ".."`, 'write names such as "robot/meshes/arm.stl"');
  }
  return name;
}

function bytes(name: string, content: unknown): Uint8Array {
  if (typeof content === "string") return new TextEncoder().encode(wellFormed(content, `files[${JSON.stringify(name)}]`));
  if (content instanceof Uint8Array) return content;
  if (content instanceof ArrayBuffer) return new Uint8Array(content);
  throw refused(`files[${JSON.stringify(name)}] must be text or bytes`, "pass a string, a Uint8Array or an ArrayBuffer");
}
