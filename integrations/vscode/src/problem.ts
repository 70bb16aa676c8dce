/** Problems of documents, from reports and failures of the module. */
import type { Failure, ModelReport } from "polhode";
import { RULES } from "./rules";

type Finding = ModelReport["findings"][number];

/** Replacement of text; `old` is null if the module does not state it. */
export type Edit = NonNullable<Finding["repair"]>["edits"][number];

/** Problem at a place. Lines and columns are from 1; columns are in characters. */
export interface Problem {
  /** Name of the file in the request. */
  file: string;
  line: number;
  column: number;
  /** Length of the place in characters; null if the module does not state it. */
  length: number | null;
  severity: Finding["severity"];
  /** Code of the rule, or `scenario`, `model` or `polhode`. */
  code: string;
  message: string;
  rule: string | null;
  why: string | null;
  fix: string | null;
  edits: Edit[];
}

/** Returns the findings of a check. */
export function ofReport({ file, findings }: ModelReport): Problem[] {
  return findings.map((finding) => {
    const { line, column, code, severity, message, rule, repair, link } = finding;
    const edits = repair?.edits ?? [];
    const here = edits.find((edit) => edit.line === line && edit.column === column);
    const { why = null, remedy = null } = RULES.get(code) ?? {};
    return {
      file: finding.file ?? file,
      line,
      column,
      length: here?.old ? [...here.old].length : null,
      severity,
      code,
      message: link === "" ? message : `${[link, ...finding.others].join(", ")}: ${message}`,
      rule,
      why,
      fix: repair?.description ?? remedy,
      edits,
    };
  });
}

/** Words of the module about a file that the request does not contain; on a page, the user has to drop it. */
const NOT_GIVEN = "must be a file that was opened or dropped together with the scenario";
const NOT_FOUND = "file names are relative to the scenario";

/** Returns the problems of a failed request about a file. A fault of a named file is also one of the file that names it. */
export function ofFailures(failures: readonly Failure[], name: string, code: string): Problem[] {
  return failures.map((failure) => {
    const places = [...failure.text.matchAll(/^ *--> (?:named here: )?(.*):(\d+):(\d+)\n *\|\n\d+ \| (.*)\n *\| ( *)(\^+)$/gm)];
    const [, file, line, column, excerpt, before, mark] = places.find(([, file]) => file === name) ?? places[0] ?? [];
    const old = [...(excerpt ?? "")].slice(before?.length, (before?.length ?? 0) + (mark?.length ?? 0)).join("");
    const [reason, hint] = failure.reason.endsWith(NOT_GIVEN) ? [failure.reason.replace(NOT_GIVEN, "must be a file that exists"), NOT_FOUND] : [failure.reason, failure.hint];
    const at = { line: Number(line ?? 1), column: Number(column ?? 1) };
    const subject = failure.file !== null && failure.file !== file && failure.file !== name ? `${failure.file}: ` : "";
    const suggested = /^did you mean (\S+)\?/.exec(hint ?? "")?.[1];
    // A name replaces a name, and a text in quotes another.
    const fits = suggested !== undefined && mark !== undefined && old.startsWith('"') === suggested.startsWith('"');
    return {
      file: file ?? failure.file ?? name,
      ...at,
      length: mark?.length ?? null,
      severity: "impossible",
      code: failure.kind === "defect" ? "polhode" : code,
      message: subject + reason + (hint === null ? "" : `\nhint: ${hint}`),
      rule: null,
      why: null,
      fix: hint,
      edits: fits ? [{ ...at, old, new: suggested }] : [],
    };
  });
}

/** Returns a remark about the whole document. */
export function remark(file: string, message: string): Problem {
  return { file, line: 1, column: 1, length: null, severity: "note", code: "polhode", message, rule: null, why: null, fix: null, edits: [] };
}

/** Returns start and end of a place in its line, in UTF-16 units. Without a length it is a value in quotes, a tag or a word. */
export function span(line: string, column: number, length: number | null): [start: number, end: number] {
  const characters = [...line];
  const start = characters.slice(0, column - 1).join("").length;
  if (length !== null) return [start, start + characters.slice(column - 1, column - 1 + length).join("").length];
  const rest = line.slice(start);
  const quote = line.charAt(start - 1);
  const value = quote === '"' || quote === "'" ? rest.split(quote, 1)[0]! : "";
  const place = value || (/^<?[^\s<>="']+/.exec(rest)?.[0] ?? rest.charAt(0));
  return [start, start + place.length];
}
