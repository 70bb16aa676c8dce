/** Kind of a document, by its name and content. */
import { TABLES } from "./schema";

/** Robot model (URDF, SDF, MJCF), or scenario (TOML). */
export type Kind = "robot" | "scenario";

/** Returns the kind of a document; null for every other file. */
export function kindOf(path: string, text: string): Kind | null {
  const extension = /\.(\w+)$/.exec(path.toLowerCase())?.[1] ?? "";
  if (extension === "toml") return isScenario(text) ? "scenario" : null;
  if (extension === "urdf") return "robot";
  if (["sdf", "world", "xml", "mjcf"].includes(extension)) return /^(robot|sdf|mujoco)$/.test(rootOf(text)) ? "robot" : null;
  return null;
}

/** Returns the name of the root element of XML; empty if the text does not begin as XML. */
function rootOf(text: string): string {
  const skipped = /(?:\s|\uFEFF)+|<\?[^]*?\?>|<!--[^]*?-->|<!DOCTYPE[^>]*>/y;
  let at = 0;
  while (skipped.test(text)) at = skipped.lastIndex;
  const root = /<([\w.:-]+)/y;
  root.lastIndex = at;
  return root.exec(text)?.[1] ?? "";
}

/**
 * Returns true if TOML has a table of a body or a start, and more top-level tables of scenarios than
 * others: Cargo.toml and a page's [head] and [body] are no scenarios.
 */
function isScenario(text: string): boolean {
  const names = new Set<string>();
  let isTop = true;
  for (const [, header, key] of text.matchAll(/^[ \t]*(?:\[\[?[ \t]*([A-Za-z_][\w-]*)[ \t]*(?:\.[^\]\n]*)?\]\]?[ \t\r]*(?:#.*)?|([A-Za-z_][\w-]*)[ \t]*[.=].*)$/gm)) {
    isTop &&= header === undefined;
    const name = header ?? (isTop ? key : undefined);
    if (name !== undefined && name !== "title") names.add(name);
  }
  const known = [...names].filter((name) => TABLES.includes(name)).length;
  return (names.has("body") || names.has("start")) && known > names.size - known;
}
