/** Errors of the package. */

/** Data of one failure. */
export interface Failure {
  /**
   * `request`: an invalid request. `input`: a file that cannot be read. `motion`: a motion that
   * cannot be computed. `defect`: a defect of polhode.
   */
  kind: "request" | "input" | "motion" | "defect";
  /** Reason, place with the line of the file, and advice, as the command prints them. */
  text: string;
  /** Reason and the broken rule, without place and advice. */
  reason: string;
  /** Name of the file; null if no file is concerned. */
  file: string | null;
  /** Line of the place in the file, from 1. */
  line: number | null;
  /** Character of the place in its line, from 1. */
  column: number | null;
  /** Advice for a fix. */
  hint: string | null;
}

/** Error of a request: its message states what is wrong, where, the rule and the fix. */
export class PolhodeError extends Error {
  override readonly name = "PolhodeError";
  readonly kind: Failure["kind"];
  readonly reason: string;
  readonly file: string | null;
  readonly line: number | null;
  readonly column: number | null;
  readonly hint: string | null;
  /** All failures, at least one: several files of a request may fail. The fields are of the first. */
  readonly failures: readonly Failure[];

  constructor(failures: readonly [Failure, ...Failure[]]) {
    super(failures.map((failure) => failure.text).join("\n\n"));
    const [first] = failures;
    this.kind = first.kind;
    this.reason = first.reason;
    this.file = first.file;
    this.line = first.line;
    this.column = first.column;
    this.hint = first.hint;
    this.failures = failures;
  }
}

/** Returns the error of an invalid request, or of a defect. */
export function refused(reason: string, hint: string | null, kind: "request" | "defect" = "request"): PolhodeError {
  const text = hint === null ? reason : `${reason}\nhint: ${hint}`;
  return new PolhodeError([{ kind, text, reason, file: null, line: null, column: null, hint }]);
}
