/**
 * Editor of the scenario's text. Errors are underlined, with their hints. The engine completes keys
 * and units.
 */
import { autocompletion, type CompletionContext, type CompletionResult, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { type Diagnostic, lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { element } from "../dom";
import type { DocumentInfo, TextError } from "./protocol";
import { engine } from "./engine";

/** Delay after the last keystroke, ms. */
const TYPED = 150;

const LOOK = EditorView.theme({
  "&": { backgroundColor: "var(--paper)", color: "var(--ink)", fontSize: "12.5px", height: "100%" },
  ".cm-scroller": { fontFamily: 'ui-monospace, "SF Mono", "Cascadia Mono", "DejaVu Sans Mono", monospace', lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused": { outline: "2px solid var(--focus)" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--quiet)", borderRight: "1px solid var(--line)" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--accent) 7%, transparent)" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "color-mix(in srgb, var(--accent) 28%, transparent) !important" },
  ".cm-tooltip": { backgroundColor: "var(--panel)", color: "var(--ink)", border: "1px solid var(--line)" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--paper)" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--danger)" },
});

const COLOURS = HighlightStyle.define([
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: [tags.string, tags.special(tags.string)], color: "var(--axis-3)" },
  { tag: [tags.number, tags.bool, tags.atom], color: "var(--axis-2)" },
  { tag: [tags.propertyName, tags.variableName], color: "var(--axis-1)" },
  { tag: [tags.bracket, tags.typeName, tags.heading], color: "var(--omega)" },
]);

/** Text that is edited: a scenario's or a plan's. */
export interface Edited {
  readonly document: DocumentInfo | null;
  readonly text: string;
  readonly errors: TextError[];
  listen(listener: { changed: () => void }): void;
  replace(text: string, kind: string): void;
  undo(): void;
  redo(): void;
}

export class Editor {
  readonly #session: Edited;
  readonly #view: EditorView;
  readonly #list: HTMLElement;
  #timer = 0;
  #isOwn = false;

  /** `what` names the text for screen readers: "scenario". */
  constructor(host: HTMLElement, session: Edited, what: string) {
    this.#session = session;
    this.#list = element("ul", { class: "errors", "aria-label": `Errors in the ${what}` });
    const box = element("div", { class: "editor" });
    host.append(box, this.#list);
    this.#view = new EditorView({ parent: box, state: EditorState.create({ doc: session.text, extensions: this.#extensions(what) }) });
    session.listen({ changed: () => this.update() });
    this.update();
  }

  /** Shows the session's text and its errors, and keeps the cursor. */
  update(): void {
    const { text, errors } = this.#session;
    const old = this.#view.state.doc.toString();
    // Text that is being typed is newer.
    if (old !== text && this.#timer === 0) {
      this.#isOwn = true;
      this.#view.dispatch({ changes: difference(old, text) });
      this.#isOwn = false;
    }
    if (this.#timer !== 0) return;
    this.#view.dispatch(setDiagnostics(this.#view.state, errors.map((error) => diagnostic(error, text.length))));
    this.#list.replaceChildren(...errors.map((error) => this.#item(error)));
    this.#list.hidden = errors.length === 0;
  }

  #extensions(what: string) {
    const session = this.#session;
    // The session has a single history, of knobs and of typing.
    const step = (run: () => void) => (): boolean => {
      this.#flush();
      run();
      return true;
    };
    return [
      lineNumbers(),
      drawSelection(),
      highlightActiveLine(),
      EditorView.lineWrapping,
      StreamLanguage.define(toml),
      syntaxHighlighting(COLOURS),
      lintGutter(),
      autocompletion({ override: [(context) => this.#complete(context)] }),
      keymap.of([
        { key: "Mod-z", run: step(() => session.undo()), preventDefault: true },
        { key: "Mod-y", mac: "Mod-Shift-z", run: step(() => session.redo()), preventDefault: true },
        { key: "Mod-Shift-z", run: step(() => session.redo()), preventDefault: true },
        ...completionKeymap,
        ...defaultKeymap,
      ]),
      LOOK,
      EditorView.contentAttributes.of({ "aria-label": `The ${what} as TOML`, spellcheck: "false" }),
      EditorView.updateListener.of((update) => {
        if (!update.docChanged || this.#isOwn) return;
        clearTimeout(this.#timer);
        this.#timer = window.setTimeout(() => this.#flush(), TYPED);
      }),
    ];
  }

  #flush(): void {
    if (this.#timer === 0) return;
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#session.replace(this.#view.state.doc.toString(), "typing");
  }

  async #complete(context: CompletionContext): Promise<CompletionResult | null> {
    const { document } = this.#session;
    if (document?.kind !== "scenario" || (!context.explicit && !context.matchBefore(/[\w."[\]-]+/))) return null;
    const stop = new AbortController();
    context.addEventListener("abort", () => stop.abort());
    try {
      const { from, to, options } = await engine.complete({ document: document.id, text: context.state.doc.toString(), at: context.pos }, stop.signal);
      return options.length > 0 ? { from, to, options: options.map(({ label, detail }) => ({ label, detail })) } : null;
    } catch {
      return null;
    }
  }

  #item({ message, hint, line, column, from }: TextError): HTMLElement {
    const words = element("span", {}, message, ...(hint ? [element("span", { class: "hint" }, ` hint: ${hint}`)] : []));
    if (from === null) return element("li", {}, words);
    const go = (): void => {
      this.#view.dispatch({ selection: { anchor: from }, scrollIntoView: true });
      this.#view.focus();
    };
    return element("li", {}, element("button", { type: "button", class: "small", click: go }, `${line}:${column}`), " ", words);
  }
}

function diagnostic({ message, hint, from, to }: TextError, length: number): Diagnostic {
  const start = Math.min(from ?? 0, length);
  const end = Math.min(Math.max(to ?? start, start), length);
  return { from: start, to: end, severity: "error", message: hint ? `${message}\nhint: ${hint}` : message };
}

/** Returns the single interval that differs. */
function difference(before: string, after: string): { from: number; to: number; insert: string } {
  const least = Math.min(before.length, after.length);
  let head = 0;
  while (head < least && before[head] === after[head]) head += 1;
  let tail = 0;
  while (tail < least - head && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail += 1;
  return { from: head, to: before.length - tail, insert: after.slice(head, after.length - tail) };
}
