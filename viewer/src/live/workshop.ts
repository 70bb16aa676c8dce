/**
 * The worker with the engine, and what it has to know. A computation that nobody waits for is ended
 * with its worker; the next worker gets the same files and documents.
 */
import type { FromWorker, ToWorker } from "./work";

/** A file, or a request after which the engine has another document. */
export type Step = { path: string; bytes: Blob } | { request: string };

export interface Answered {
  bytes: ArrayBuffer;
  /** Time of the computation, ms. */
  took: number;
}

/** Error of a worker that has ended. */
export class Ended extends Error {
  constructor(defect: string | null) {
    const cause = defect === null ? "its memory of 1 GiB is full, or it has a defect" : `it has a defect: ${defect}`;
    super(`The engine of the page has ended: ${cause}. Use smaller files or a shorter motion, or the polhode command.`);
    this.name = "Ended";
  }
}

interface Job {
  step: Step;
  /** True for steps that each new worker repeats. */
  isKept: boolean;
  signal: AbortSignal | undefined;
  done: (answer: Answered) => void;
  fail: (problem: Error) => void;
}

export class Workshop {
  readonly #module: Promise<WebAssembly.Module>;
  readonly #script: string;
  readonly #kept: Step[] = [];
  readonly #waiting: Job[] = [];
  #worker: Worker | null = null;
  #job: Job | null = null;
  /** Ends the wait for the worker's answer. */
  #end: ((problem: Error) => void) | null = null;

  /** `script` is the address of the worker's script. */
  constructor(module: Promise<WebAssembly.Module>, script: string) {
    this.#module = module;
    this.#script = script;
  }

  /** Does a step after those that wait. An aborted signal ends it, also while it is computed. */
  do(step: Step, how: { isKept: boolean; signal?: AbortSignal }): Promise<Answered> {
    const { signal } = how;
    return new Promise((done, fail) => {
      const job: Job = { step, isKept: how.isKept, signal, done, fail };
      signal?.addEventListener("abort", () => this.#abort(job), { once: true });
      this.#waiting.push(job);
      if (!this.#job) void this.#go();
    });
  }

  #abort(job: Job): void {
    if (this.#job === job) this.#stop(aborted());
    else job.fail(aborted());
  }

  async #go(): Promise<void> {
    for (;;) {
      const job = this.#waiting.shift();
      this.#job = job ?? null;
      if (!job) return;
      if (job.signal?.aborted) {
        job.fail(aborted());
        continue;
      }
      try {
        this.#worker ??= await this.#start();
        const answer = await this.#ask(job.step);
        if (job.isKept) this.#keep(job.step);
        job.done(answer);
      } catch (problem) {
        job.fail(problem instanceof Error ? problem : new Error(String(problem)));
      }
    }
  }

  /** Keeps a step once; of a file, its latest content at its first place. */
  #keep(step: Step): void {
    const at = this.#kept.findIndex((kept) => ("path" in kept ? "path" in step && kept.path === step.path : "request" in step && kept.request === step.request));
    if (at < 0) this.#kept.push(step);
    else this.#kept[at] = step;
  }

  /** Starts a worker with the files and documents of the previous one. */
  async #start(): Promise<Worker> {
    const module = await this.#module;
    this.#worker = new Worker(this.#script);
    this.#worker.postMessage({ module } satisfies ToWorker);
    for (const step of this.#kept) await this.#ask(step);
    return this.#worker;
  }

  async #ask(step: Step): Promise<Answered> {
    const message: ToWorker = "path" in step ? { path: step.path, bytes: await step.bytes.arrayBuffer() } : step;
    const worker = this.#worker;
    if (!worker) throw aborted();
    return new Promise((done, fail) => {
      this.#end = fail;
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
        if ("defect" in data) this.#stop(new Ended(data.defect));
        else done({ bytes: data.done ?? new ArrayBuffer(0), took: data.took });
      };
      worker.onerror = (event) => this.#stop(new Error(event.message || "the page's engine cannot be started"));
      worker.postMessage(message, "bytes" in message ? [message.bytes] : []);
    });
  }

  #stop(problem: Error): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#end?.(problem);
  }
}

const aborted = (): DOMException => new DOMException("The request was cancelled.", "AbortError");
