/** Rules of the checks, from the table of `polhode check --explain`. */
import table from "../../../crates/polhode-robot/src/rule/rules.txt";

/** Reason and remedy of each rule by its code. A section has the code, then title, reason and remedy on a line each. */
export const RULES = new Map([...table.matchAll(/^## (\S+) .*\n.*\n(.+)\n(.+)$/gm)].map(([, code, why, remedy]) => [code!, { why: why!, remedy: remedy! }]));

const BOOK = "https://github.com/polhode/polhode/blob/main/book";

/** Returns the address of the page about a code. */
export function pageOf(code: string): string {
  return RULES.has(code) ? `${BOOK}/rules.md#${code.replaceAll(".", "")}` : code === "scenario" ? `${BOOK}/scenario.md` : `${BOOK}/editor.md`;
}
