/** Completion and description of keys in the text of a scenario. */
import { HEADERS, type Node, type Pair, tablesAt, valuesAt } from "./schema";

/** Completions, which replace the text between two offsets. */
export interface Completions {
  from: number;
  to: number;
  items: { text: string; detail: string; isKey: boolean }[];
}

const HEADER = /^[ \t]*\[\[?[ \t]*([A-Za-z_][\w.\- \t]*?)[ \t]*\]\]?[ \t\r]*(?:#.*)?$/;

/** Returns the completions at an offset of a text; null where there are none. */
export function complete(text: string, at: number): Completions | null {
  const start = text.lastIndexOf("\n", at - 1) + 1;
  const written = text.slice(start, at);
  const word = /[\w-]*$/.exec(written)![0];
  const header = /^[ \t]*(\[\[?[\w.\- \t]*)$/.exec(written);
  // Brackets and quotes that the editor has closed are replaced too.
  const closed = (closing: RegExp) => at + closing.exec(text.slice(at, at + 2))![0].length;
  if (header) return { from: at - header[1]!.length, to: closed(/^\]*/), items: HEADERS.map((text) => ({ text, detail: "table", isKey: false })) };
  const place = placeIn(written);
  if (place === null) return null;
  const table = tableAt(text, start);
  const path = [...table.path, ...place.path];
  const has = place.isInline ? place.has : table.has;
  if (place.isValue) {
    const open = written.replace(/"[^"]*"/g, (text) => " ".repeat(text.length));
    const from = /(?:"[^"]*|[\w.+-]*)$/.exec(open)!.index;
    const items = [...new Map(values(valuesAt(path, has)))].map(([text, detail]) => ({ text, detail, isKey: false }));
    return { from: start + from, to: closed(open[from] === '"' ? /^"?/ : /^/), items };
  }
  const keys = new Map<string, string>();
  for (const node of tablesAt(path, has)) {
    for (const [key, value] of Object.entries(node.properties ?? {})) keys.set(key, keys.get(key) || describe(value));
  }
  const items = [...keys].filter(([key]) => !has.some(([own]) => own === key)).map(([text, detail]) => ({ text, detail, isKey: true }));
  return { from: at - word.length, to: at, items };
}

/** Returns the description of the key at an offset: what it takes, with its unit. */
export function describeKey(text: string, at: number): string | null {
  const start = text.lastIndexOf("\n", at - 1) + 1;
  const left = /[\w-]*$/.exec(text.slice(start, at))![0];
  const key = left + /^[\w-]*/.exec(text.slice(at))![0];
  const place = placeIn(text.slice(start, at - left.length));
  if (key === "" || place === null || place.isValue) return null;
  const table = tableAt(text, start);
  const found = tablesAt([...table.path, ...place.path], place.isInline ? [] : table.has).flatMap((node) => node.properties?.[key] ?? []);
  return found.map(describe).find((words) => words !== "") ?? null;
}

/** Returns the path of the table at the start of a line, and the keys that it has before and after the line. */
function tableAt(text: string, start: number): { path: string[]; has: Pair[] } {
  const above = text.slice(0, start).split("\n");
  const first = above.findLastIndex((line) => HEADER.test(line));
  const path = HEADER.exec(above[first] ?? "")?.[1]?.split(".").map((key) => key.trim()) ?? [];
  const below = text.slice(start).split("\n").slice(1);
  const end = below.findIndex((line) => HEADER.test(line));
  const own = [...above.slice(first + 1), ...below.slice(0, end < 0 ? undefined : end)];
  return { path, has: pairs(own.join("\n")) };
}

function pairs(text: string): Pair[] {
  return [...text.matchAll(/^[ \t]*([\w-]+)[ \t]*[.=][ \t]*(?:"([^"\n]*)"|'([^'\n]*)')?/gm)].map(([, key, double, single]) => [key!, double ?? single ?? null]);
}

/** Level of a line (the line itself, an array or an inline table): the key whose value is written, the next part, the keys so far. */
type Level = { isTable: boolean; key: string[]; next: "key" | "value" | "comma"; has: Pair[] };

/** Returns the place at the end of a line's start: keys around it, if a value is written there, and if an inline table contains it. */
function placeIn(written: string): { path: string[]; isValue: boolean; isInline: boolean; has: Pair[] } | null {
  const [, left, rest] = /^[ \t]*([\w.-]*)[ \t]*(=.*)?$/.exec(written) ?? [];
  if (left === undefined) return null;
  if (rest === undefined) return left !== "" && /\s$/.test(written) ? null : { path: left.split(".").slice(0, -1), isValue: false, isInline: left.includes("."), has: [] };
  const levels: Level[] = [{ isTable: true, key: left.split("."), next: "value", has: [] }];
  for (const { 0: token, index } of rest.matchAll(/"(?:[^"\\]|\\.)*"?|'[^']*'?|[\w.+-]+|[^\s]/g)) {
    const level = levels.at(-1)!;
    const isLast = index + token.length === rest.length && !/^(?:"[^]*"|'[^]*')$/.test(token);
    if (token === "#") return null;
    else if (token === "{") levels.push({ isTable: true, key: [], next: "key", has: [] });
    else if (token === "[") levels.push({ isTable: false, key: [], next: "value", has: [] });
    else if (token === "}" || token === "]") {
      levels.pop();
      if (levels.length === 0) return null;
      levels.at(-1)!.next = "comma";
    } else if (token === "=") level.next = "value";
    else if (token === ",") [level.next, level.key] = level.isTable ? ["key", []] : ["value", level.key];
    else if (level.next === "value") level.next = isLast ? "value" : "comma";
    else if (level.next === "key" && isLast) level.key = token.split(".").slice(0, -1);
    else if (level.next === "key") {
      [level.key, level.next] = [token.split("."), "comma"];
      level.has.push([token, null]);
    }
  }
  const { next, has } = levels.at(-1)!;
  return next === "comma" ? null : { path: levels.flatMap(({ key }) => key), isValue: next === "value", isInline: levels.some(({ isTable }, k) => isTable && k > 0), has };
}

/** Returns the values that a schema allows: names, true and false, or an example with its unit. */
function values(nodes: readonly Node[]): [text: string, detail: string][] {
  return nodes.flatMap((node): [string, string][] => {
    if (node.enum) return node.enum.map((name) => [JSON.stringify(name), "name"]);
    if (node.type === "boolean") return [["true", "boolean"], ["false", "boolean"]];
    const example = /such as ("[^"]+")/.exec(node.description ?? "")?.[1];
    return example === undefined ? [] : [[example, node.description!]];
  });
}

function describe(node: Node): string {
  const count = node.type === "array" && node.items ? "an array; each: " : "";
  const of = node.items ?? node;
  if (of.description) return count + of.description;
  if (of.enum) return `one of ${of.enum.join(", ")}`;
  return node.properties || node.oneOf || node.anyOf || node.$ref ? "" : count + [of.type ?? []].flat().join(" or ");
}
