/** The viewer, which a notebook contains once for all its motions. */
import { bytesOf } from "../base64";
import { inflated } from "../packed";

interface Shared {
  /** Viewers by the hash of their text. */
  viewers: Map<string, Promise<string>>;
  /** Callbacks that wait for a viewer. */
  waiting: Map<string, ((viewer: Promise<string>) => void)[]>;
}

declare global {
  interface Window {
    /** State shared by all outputs and widgets in this document. */
    polhodeNotebook?: Shared;
  }
}

function shared(): Shared {
  window.polhodeNotebook ??= { viewers: new Map(), waiting: new Map() };
  return window.polhodeNotebook;
}

/** Returns the viewer if it is known or contained in an output of this document. */
export function known(key: string): Promise<string> | null {
  const { viewers } = shared();
  const held = document.querySelector(`script.polhode-viewer[data-key="${CSS.escape(key)}"]`);
  if (!viewers.has(key) && held instanceof HTMLScriptElement) bring(key, bytesOf(held.text));
  return viewers.get(key) ?? null;
}

/** Unpacks a viewer and passes it to all waiting callbacks. */
export function bring(key: string, packed: Uint8Array<ArrayBuffer>): Promise<string> {
  const { viewers, waiting } = shared();
  const viewer = viewers.get(key) ?? inflated(packed).then((text) => text.text());
  viewers.set(key, viewer);
  for (const then of waiting.get(key) ?? []) then(viewer);
  waiting.delete(key);
  return viewer;
}

/** Calls back once an output provides the viewer. */
export function wait(key: string, then: (viewer: Promise<string>) => void): void {
  const { waiting } = shared();
  waiting.set(key, [...(waiting.get(key) ?? []), then]);
}
