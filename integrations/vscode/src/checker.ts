/** Checks of open documents, and their diagnostics. */
import { Diagnostic, type DiagnosticCollection, DiagnosticSeverity, type Disposable, languages, Range, type TextDocument, Uri, workspace } from "vscode";
import type { Checked } from "polhode";
import { gather, type Gathered, textOf } from "./files";
import { kindOf } from "./kind";
import type { Outcome, Pool } from "./pool";
import { ofFailures, ofReport, type Problem, remark, span } from "./problem";
import { pageOf } from "./rules";

/** Delay after the last keystroke, ms. */
const TYPED = 300;

/** Problem at its place in a document. */
export interface Located extends Problem {
  address: Uri;
  range: Range;
  /** Version of the document that was checked; null if it was not open. */
  version: number | null;
}

/** State of a document. */
interface State {
  shown: DiagnosticCollection;
  located: Located[];
  timer: NodeJS.Timeout | undefined;
  /** Number of checks that were started. */
  started: number;
}

/** Severities of diagnostics. */
const SEVERITIES = { impossible: DiagnosticSeverity.Error, suspect: DiagnosticSeverity.Warning, note: DiagnosticSeverity.Information };

export class Checker implements Disposable {
  readonly #pool: Pool;
  readonly #states = new Map<string, State>();

  constructor(pool: Pool) {
    this.#pool = pool;
  }

  /** Checks a document soon, if it is a model or a scenario. */
  schedule(document: TextDocument, delay = TYPED): void {
    // Other views, as of Git, have documents too.
    const isFile = ["file", "untitled"].includes(document.uri.scheme) || workspace.getWorkspaceFolder(document.uri) !== undefined;
    if (!isFile || kindOf(document.uri.path, document.getText()) === null) return this.forget(document.uri.toString());
    clearTimeout(this.#state(document).timer);
    this.#state(document).timer = setTimeout(() => void this.check(document), delay);
  }

  /** Checks a document; returns its problems, or null if it is no model or scenario, or a newer check has ended this one. */
  async check(document: TextDocument): Promise<Located[] | null> {
    const kind = kindOf(document.uri.path, document.getText());
    if (kind === null) return null;
    const state = this.#state(document);
    clearTimeout(state.timer);
    const [number, version] = [(state.started += 1), document.version];
    const gathered = await gather(document, kind);
    const isCurrent = () => state.started === number && document.version === version && this.#states.get(document.uri.toString()) === state;
    if (!isCurrent()) return null;
    const settings = workspace.getConfiguration("polhode", document.uri);
    const [limit, programs] = [settings.get<number>("timeLimit", 30), settings.get<string[]>("for", [])];
    const { name, contents: files } = gathered;
    const today = new Date().toISOString().slice(0, 10);
    const request = kind === "robot" ? { files, inputs: [name], root: [""], for: programs, today } : { files, inputs: [name] };
    const outcome = await this.#pool.ask<Checked>(document.uri.toString(), kind === "robot" ? "check" : "inertia", request, limit);
    if (!isCurrent() || ("ended" in outcome && outcome.ended === "superseded")) return null;
    const found = await located(problems(outcome, gathered, kind === "robot" ? "model" : "scenario", limit), gathered, document);
    if (!isCurrent()) return null;
    state.located = found;
    show(state);
    return state.located;
  }

  /** Removes the diagnostics of a document. */
  forget(key: string): void {
    const state = this.#states.get(key);
    clearTimeout(state?.timer);
    state?.shown.dispose();
    this.#states.delete(key);
    this.#pool.end(key);
  }

  /** Returns the problems in a range of a document, of its present text. */
  at(document: TextDocument, range: Range): Located[] {
    const isHere = ({ address, version, range: place }: Located) =>
      address.toString() === document.uri.toString() && (version === null ? !document.isDirty : version === document.version) && place.intersection(range) !== undefined;
    return [...this.#states.values()].flatMap(({ located }) => located).filter(isHere);
  }

  dispose(): void {
    for (const key of this.#states.keys()) this.forget(key);
  }

  #state(document: TextDocument): State {
    const key = document.uri.toString();
    const state = this.#states.get(key) ?? { shown: languages.createDiagnosticCollection("polhode"), located: [], timer: undefined, started: 0 };
    this.#states.set(key, state);
    return state;
  }
}

function problems(outcome: Outcome<Checked>, { name, left }: Gathered, code: string, limit: number): Problem[] {
  const remarks = left.map((text) => remark(name, text));
  if ("ended" in outcome) {
    return [{ ...remark(name, `not checked: the check takes longer than ${limit} s; raise the setting polhode.timeLimit, or run polhode check`), severity: "suspect" }];
  }
  if ("failures" in outcome) return [...ofFailures(outcome.failures, name, code), ...remarks];
  if (code === "scenario") return remarks;
  return [...outcome.value.reports.flatMap(ofReport), ...outcome.value.remarks.map((text) => remark(name, text)), ...remarks];
}

async function located(problems: Problem[], { addresses, name }: Gathered, document: TextDocument): Promise<Located[]> {
  const [lines, places] = [new Map<string, string[]>(), new Array<Located>()];
  for (const problem of problems) {
    const known = addresses.get(problem.file);
    const [file, address] = known ? [problem.file, known] : [name, document.uri];
    const open = workspace.textDocuments.find(({ uri }) => uri.toString() === address.toString());
    if (!lines.has(file)) lines.set(file, (await textOf(address)).split(/\r?\n/));
    const line = Math.min(known ? problem.line : 1, lines.get(file)!.length) - 1;
    const [start, end] = span(lines.get(file)![line]!, problem.column, problem.length);
    places.push({ ...problem, address, range: new Range(line, start, line, end), version: open?.version ?? null });
  }
  return places;
}

function show({ shown, located }: State): void {
  shown.clear();
  for (const address of new Map(located.map(({ address }) => [address.toString(), address])).values()) {
    const here = located.filter((one) => one.address.toString() === address.toString());
    shown.set(address, here.map(({ range, message, severity, code }) => {
      const diagnostic = new Diagnostic(range, message, SEVERITIES[severity]);
      diagnostic.source = "polhode";
      diagnostic.code = { value: code, target: Uri.parse(pageOf(code)) };
      return diagnostic;
    }));
  }
}
