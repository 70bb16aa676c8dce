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

/** Key and its text value, if it has one: `shape` and `box`. */
export type Pair = readonly [key: string, value: string | null];

/** Returns the alternatives at a path of keys from the root; elements of arrays have their array's path. */
export function nodesAt(path: readonly string[]): Node[] {
  return path.reduce<Node[]>((nodes, key) => nodes.flatMap((node) => alternatives(node.properties?.[key])), alternatives(ROOT));
}

/** Returns the forms of a table at a path that its keys so far allow: a part with shape = "box" is a box. */
export function tablesAt(path: readonly string[], has: readonly Pair[]): Node[] {
  const fits = (node: Node) =>
    has.every(([key, value]) => {
      const names = node.properties?.[key]?.enum;
      return value === null || names === undefined || names.length !== 1 || names[0] === value;
    });
  return nodesAt(path).filter((node) => node.properties !== undefined && fits(node));
}

/** Returns true if the path is an array of tables, whose header is [[…]]. */
export function isArray(key: string): boolean {
  return ROOT.properties?.[key]?.type === "array";
}

function alternatives(node: Node | undefined): Node[] {
  if (node === undefined) return [];
  if (node.$ref !== undefined) return alternatives(ROOT.$defs?.[node.$ref.replace("#/$defs/", "")]);
  const inner = [...(node.oneOf ?? []), ...(node.anyOf ?? []), ...(node.items ? [node.items] : [])];
  return inner.length > 0 ? inner.flatMap(alternatives) : [node];
}
