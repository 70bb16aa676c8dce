/** Messages between the page and the worker with the engine. */

/** Message to the worker: the module, a file, or a request in JSON. All but the first are answered. */
export type ToWorker = { module: WebAssembly.Module } | { path: string; bytes: ArrayBuffer } | { request: string };

/**
 * Answer of the worker, with the time of the computation, ms. After a defect the worker is not used
 * again; the module of a release has no message of it.
 */
export type FromWorker = { done: ArrayBuffer | null; took: number } | { defect: string | null };
