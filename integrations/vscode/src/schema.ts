/** JSON schema of scenario files (`polhode schema scenario`): keys and values at a place. */
import schema from "scenario.schema.json";

/** Part of the schema. */
export interface Node {
  title?: string;
  description?: string;
  type?: string | string[];
  enum?: (string | number | boolean)[];
  properties?: Record<string, Node>;
  items?: Node;
  oneOf?: Node[];
  anyOf?: Node[];
  $ref?: string;
  $defs?: Record<string, Node>;
}

const ROOT = schema as Node;

/** Top-level tables and keys of a scenario. */
export const TABLES = Object.keys(ROOT.properties ?? {});

/** Headers of the tables. */
export const HEADERS = Object.entries(ROOT.properties ?? {})
  .filter(([key]) => key !== "title")
  .map(([key, { type }]) => (key === "body" ? "[[body.part]]" : type === "array" ? `[[${key}]]` : `[${key}]`));

/** Key and its text value, if it has one: `shape` and `box`. */
export type Pair = readonly [key: string, value: string | null];

/** Returns the forms of a value of a table; elements of arrays have their array's path. */
export function valuesAt(path: readonly string[], has: readonly Pair[]): Node[] {
  return inner(tablesAt(path.slice(0, -1), has), path.at(-1)!);
}

/** Returns the forms of a table at a path that its keys so far allow: a part with shape = "box" is a box. */
export function tablesAt(path: readonly string[], has: readonly Pair[]): Node[] {
  const fits = (node: Node) =>
    has.every(([key, value]) => {
      const names = node.properties?.[key]?.enum;
      return value === null || names === undefined || names.length !== 1 || names[0] === value;
    });
  return path.reduce(inner, alternatives(ROOT)).filter((node) => node.properties !== undefined && fits(node));
}

function inner(nodes: Node[], key: string): Node[] {
  return nodes.flatMap((node) => alternatives(node.properties?.[key]));
}

function alternatives(node: Node | undefined): Node[] {
  if (node === undefined) return [];
  if (node.$ref !== undefined) return alternatives(ROOT.$defs?.[node.$ref.replace("#/$defs/", "")]);
  const forms = [...(node.oneOf ?? []), ...(node.anyOf ?? []), ...(node.items ? [node.items] : [])];
  return forms.length > 0 ? forms.flatMap(alternatives) : [node];
}
