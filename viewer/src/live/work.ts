/** Messages between the page and the worker with the engine. */

/** Bytes of the page in base 32768. */
export interface Packed {
  text: string;
  length: number;
}

/** Answer to the packed module. */
export type Built = { module: WebAssembly.Module } | { problem: string };

/** Message to the worker: the module, packed or not, a file, or a request in JSON. All but `module` are answered. */
export type ToWorker = { packed: Packed } | { module: WebAssembly.Module } | { path: string; bytes: ArrayBuffer } | { request: string };

/**
 * Answer of the worker, with the time of the computation, ms. After a defect the worker is not used
 * again; the module of a release has no message of it.
 */
export type FromWorker = { done: ArrayBuffer | null; took: number } | { defect: string | null };
