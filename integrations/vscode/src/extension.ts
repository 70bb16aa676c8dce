/** The extension: checks documents when they are opened and changed, and has two commands. */
import { commands, EventEmitter, type ExtensionContext, languages, ProgressLocation, type TextDocument, Uri, window, workspace } from "vscode";
import { advise } from "./advice";
import { Checker } from "./checker";
import { gather } from "./files";
import { type Kind, kindOf } from "./kind";
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
    workspace.onDidCloseTextDocument((document) => checker.forget(document.uri.toString())),
    workspace.onDidChangeConfiguration((change) => change.affectsConfiguration("polhode") && checkAll()),
    workspace.registerTextDocumentContentProvider("polhode", solutions),
    commands.registerCommand("polhode.check", () => withDocument(["robot", "scenario"], (document, name) => checkNow(checker, document, name))),
    commands.registerCommand("polhode.explain", () => withDocument(["scenario"], (document, name) => solutions.show(document, name))),
  );
  checkAll();
}

/** Uses the document of the active editor, if it has one of the kinds. */
async function withDocument(kinds: Kind[], use: (document: TextDocument, name: string) => Promise<void>): Promise<void> {
  const document = window.activeTextEditor?.document;
  const kind = document ? kindOf(document.uri.path, document.getText()) : null;
  const what = `${kinds.includes("robot") ? "a robot model (URDF, SDF, MJCF) or " : ""}a scenario, a TOML file with [[body.part]]`;
  if (!document) void window.showErrorMessage(`polhode: no file is open in the editor; open ${what}`);
  else if (kind === null || !kinds.includes(kind)) void window.showErrorMessage(`polhode: ${workspace.asRelativePath(document.uri)} is not ${what}`);
  else await use(document, workspace.asRelativePath(document.uri));
}

async function checkNow(checker: Checker, document: TextDocument, name: string): Promise<void> {
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

  async show(document: TextDocument, name: string): Promise<void> {
    const owner = `explain ${document.uri.toString()}`;
    const progress = { location: ProgressLocation.Notification, title: `polhode: explaining ${name}`, cancellable: true };
    const outcome = await window.withProgress(progress, async (_, cancelled) => {
      cancelled.onCancellationRequested(() => this.#pool.end(owner));
      const { name: own, contents } = await gather(document, "scenario");
      const { [own]: scenario, ...files } = contents;
      return this.#pool.ask<string>(owner, "explain", { scenario, files }, SOLUTION);
    });
    if ("failures" in outcome) void window.showErrorMessage(`polhode: ${outcome.failures.map(({ text }) => text.split("\n", 1)[0]).join("; ")}`);
    else if ("value" in outcome) {
      const address = Uri.from({ scheme: "polhode", path: `${document.uri.path.replace(/\.toml$/i, "")} (solution).md`, query: document.uri.toString() });
      this.#texts.set(address.toString(), outcome.value);
      this.#changed.fire(address);
      await languages.setTextDocumentLanguage(await workspace.openTextDocument(address), "markdown");
      await commands.executeCommand("markdown.showPreview", address);
    } else if (outcome.ended === "late") void window.showErrorMessage(`polhode: the worked solution takes longer than ${SOLUTION} s; use polhode explain`);
  }
}
