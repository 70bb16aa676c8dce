/** The viewer, which a notebook holds once for all of its motions. */
import { bytesOf } from "../base64";
import { inflated } from "../packed";

interface Shared {
  /** By the hash of its text. */
  viewers: Map<string, Promise<string>>;
  /** What waits for one. */
  waiting: Map<string, ((viewer: Promise<string>) => void)[]>;
}

declare global {
  interface Window {
    /** Of all outputs and widgets in this document. */
    polhodeNotebook?: Shared;
  }
}

function shared(): Shared {
  window.polhodeNotebook ??= { viewers: new Map(), waiting: new Map() };
  return window.polhodeNotebook;
}

/** The viewer if it is known, or if an output in this document holds it. */
export function known(key: string): Promise<string> | null {
  const { viewers } = shared();
  const held = document.querySelector(`script.polhode-viewer[data-key="${CSS.escape(key)}"]`);
  if (!viewers.has(key) && held instanceof HTMLScriptElement) bring(key, bytesOf(held.text));
  return viewers.get(key) ?? null;
}

/** The viewer, deflated; who waits for it gets it. */
export function bring(key: string, packed: Uint8Array<ArrayBuffer>): Promise<string> {
  const { viewers, waiting } = shared();
  const viewer = viewers.get(key) ?? inflated(packed);
  viewers.set(key, viewer);
  for (const then of waiting.get(key) ?? []) then(viewer);
  waiting.delete(key);
  return viewer;
}

/** Calls back as soon as some output brings it. */
export function wait(key: string, then: (viewer: Promise<string>) => void): void {
  const { waiting } = shared();
  waiting.set(key, [...(waiting.get(key) ?? []), then]);
}
