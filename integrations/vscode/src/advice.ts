/** Hovers and quick fixes of problems, hovers of keys, and completion. */
import { CodeAction, CodeActionKind, CompletionItem, CompletionItemKind, type Disposable, type DocumentSelector, Hover, languages, MarkdownString, type Position, Range, type TextDocument, WorkspaceEdit } from "vscode";
import type { Checker, Located } from "./checker";
import { kindOf } from "./kind";
import { span } from "./problem";
import { pageOf } from "./rules";
import { complete, describeKey } from "./toml";

const SELECTOR: DocumentSelector = [{ language: "xml" }, { language: "toml" }, { pattern: "**/*.{urdf,sdf,world,mjcf,xml,toml}" }];

/** Registers hovers, quick fixes and completion. */
export function advise(checker: Checker): Disposable[] {
  const hover = (document: TextDocument, position: Position): Hover | null => {
    const parts = checker.at(document, new Range(position, position)).map((problem) => describe(problem, document));
    const key = isScenario(document) ? describeKey(document.getText(), document.offsetAt(position)) : null;
    if (key !== null) parts.push(new MarkdownString(key));
    return parts.length > 0 ? new Hover(parts) : null;
  };
  const actions = (document: TextDocument, range: Range): CodeAction[] =>
    checker.at(document, range).flatMap((problem) => {
      const edit = editOf(problem, document);
      if (edit === null) return [];
      const action = new CodeAction(`polhode: ${problem.edits.map(({ old, new: text }) => `${old} → ${text}`).join(", ")}`, CodeActionKind.QuickFix);
      action.edit = edit;
      action.isPreferred = true;
      return [action];
    });
  const completions = (document: TextDocument, position: Position): CompletionItem[] => {
    if (!isScenario(document)) return [];
    const [text, at] = [document.getText(), document.offsetAt(position)];
    const found = complete(text, at);
    const range = found && new Range(document.positionAt(found.from), document.positionAt(found.to));
    const hasValue = /^[\w-]*\s*=/.test(text.slice(at, text.indexOf("\n", at) >>> 0));
    return (found?.items ?? []).map(({ text, detail, isKey }) => {
      const item = new CompletionItem(text, isKey ? CompletionItemKind.Property : CompletionItemKind.Value);
      item.detail = detail;
      item.insertText = isKey && !hasValue ? `${text} = ` : text;
      item.range = range!;
      item.filterText = text;
      return item;
    });
  };
  return [
    languages.registerHoverProvider(SELECTOR, { provideHover: hover }),
    languages.registerCodeActionsProvider(SELECTOR, { provideCodeActions: actions }, { providedCodeActionKinds: [CodeActionKind.QuickFix] }),
    languages.registerCompletionItemProvider(SELECTOR, { provideCompletionItems: completions }, "[", '"', "=", "{"),
  ];
}

function isScenario(document: TextDocument): boolean {
  return kindOf(document.uri.path, document.getText()) === "scenario";
}

/** Returns value, rule, fix and reason of a finding; the editor shows its message above. */
function describe({ code, severity, rule, why, fix, range }: Located, document: TextDocument): MarkdownString {
  const lines = [`**[${code}](${pageOf(code)})** (${severity === "impossible" && rule === null ? "error" : severity})`];
  for (const [label, words] of Object.entries({ Value: document.getText(range), Rule: rule, Fix: fix, Reason: why })) {
    if (words) lines.push(`**${label}:** ${words.replace(/[\\`*_{}[\]()#+\-!~<>|&]/g, "\\$&")}`);
  }
  return new MarkdownString(lines.join("  \n"));
}

/** Returns the edit of a fix; null if the module states none, or the document has another text at its places. */
function editOf({ edits }: Located, document: TextDocument): WorkspaceEdit | null {
  const edit = new WorkspaceEdit();
  for (const { line, column, old, new: text } of edits) {
    if (old === null || line > document.lineCount) return null;
    const [start, end] = span(document.lineAt(line - 1).text, column, [...old].length);
    const range = new Range(line - 1, start, line - 1, end);
    if (document.getText(range) !== old) return null;
    edit.replace(document.uri, range, text);
  }
  return edits.length > 0 ? edit : null;
}
