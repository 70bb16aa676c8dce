/** The extension: checks documents when they are opened and changed, and has two commands. */
import { commands, EventEmitter, type ExtensionContext, languages, ProgressLocation, type TextDocument, Uri, window, workspace } from "vscode";
import { advise } from "./advice";
import { Checker } from "./checker";
import { gather } from "./files";
import { kindOf } from "./kind";
import { Pool } from "./pool";

/** Time limit of a worked solution, s; it can be cancelled. */
const SOLUTION = 600;

export function activate(context: ExtensionContext): void {
  const pool = new Pool(context.asAbsolutePath("dist/worker.mjs"));
  const checker = new Checker(pool);
  const solutions = new Solutions(pool);
  const checkAll = (): void => workspace.textDocuments.forEach((document) => checker.schedule(document));
  context.subscriptions.push(
    checker,
    pool,
    ...advise(checker),
    workspace.onDidOpenTextDocument((document) => checker.schedule(document, 0)),
    workspace.onDidChangeTextDocument(({ document }) => checker.schedule(document)),
    // A saved file may be named by others: a policy, a mesh, an included model.
    workspace.onDidSaveTextDocument(checkAll),
    workspace.onDidCloseTextDocument((document) => checker.forget(document)),
    workspace.onDidChangeConfiguration((change) => change.affectsConfiguration("polhode") && checkAll()),
    workspace.registerTextDocumentContentProvider("polhode", solutions),
    commands.registerCommand("polhode.check", () => withDocument((document) => checkNow(checker, document))),
    commands.registerCommand("polhode.explain", () => withDocument((document) => solutions.show(document))),
  );
  checkAll();
}

async function withDocument(use: (document: TextDocument) => Promise<void>): Promise<void> {
  const document = window.activeTextEditor?.document;
  if (document) await use(document);
  else void window.showErrorMessage("polhode: no file is open in the editor; open a model or a scenario");
}

async function checkNow(checker: Checker, document: TextDocument): Promise<void> {
  const name = workspace.asRelativePath(document.uri);
  if (kindOf(document.uri.path, document.getText()) === null) {
    void window.showErrorMessage(`polhode: ${name} is not a robot model (URDF, SDF, MJCF) and not a scenario (TOML with [[body.part]])`);
    return;
  }
  const found = await window.withProgress({ location: ProgressLocation.Window, title: `polhode: checking ${name}` }, () => checker.check(document));
  // A newer check shows its own result.
  if (found === null) return;
  if (found.length > 0) await commands.executeCommand("workbench.actions.view.problems");
  else void window.showInformationMessage(`polhode: no findings in ${name}`);
}

/** Worked solutions of scenarios, as Markdown documents. */
class Solutions {
  readonly #pool: Pool;
  readonly #texts = new Map<string, string>();
  readonly #changed = new EventEmitter<Uri>();
  readonly onDidChange = this.#changed.event;

  constructor(pool: Pool) {
    this.#pool = pool;
  }

  provideTextDocumentContent(address: Uri): string {
    return this.#texts.get(address.toString()) ?? "This worked solution is not available any more; run \"Explain This Scenario\" again.";
  }

  async show(document: TextDocument): Promise<void> {
    const name = workspace.asRelativePath(document.uri);
    if (kindOf(document.uri.path, document.getText()) !== "scenario") {
      void window.showErrorMessage(`polhode: ${name} is not a scenario, a TOML file with [[body.part]]`);
      return;
    }
    const owner = `explain ${document.uri.toString()}`;
    const progress = { location: ProgressLocation.Notification, title: `polhode: explaining ${name}`, cancellable: true };
    const outcome = await window.withProgress(progress, async (_, cancelled) => {
      cancelled.onCancellationRequested(() => this.#pool.end(owner));
      const { name: own, contents } = await gather(document, "scenario");
      const { [own]: scenario, ...files } = contents;
      return this.#pool.ask<string>(owner, "explain", { scenario, files }, SOLUTION);
    });
    if ("value" in outcome) await this.#preview(document.uri, outcome.value);
    else if ("failures" in outcome) void window.showErrorMessage(`polhode: ${outcome.failures.map(({ text }) => text.split("\n", 1)[0]).join("; ")}`);
    else if (outcome.ended === "late") void window.showErrorMessage(`polhode: the worked solution takes longer than ${SOLUTION} s; use polhode explain`);
  }

  async #preview(source: Uri, text: string): Promise<void> {
    const address = Uri.from({ scheme: "polhode", path: `${source.path.replace(/\.toml$/i, "")} (solution).md`, query: source.toString() });
    this.#texts.set(address.toString(), text);
    this.#changed.fire(address);
    const document = await languages.setTextDocumentLanguage(await workspace.openTextDocument(address), "markdown");
    await commands.executeCommand("markdown.showPreview", document.uri);
  }
}
