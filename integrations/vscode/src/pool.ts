/** Threads that answer requests, so that no request blocks the editor. */
import { Worker } from "node:worker_threads";
import type { Failure } from "polhode";

/** Request to a function of the module. */
export interface Message {
  name: "check" | "inertia" | "explain";
  request: never;
}

/** Outcome of a request. `superseded`: a newer request of the same owner ended it. `late`: the time limit ended it. */
export type Outcome<T> = { value: T } | { failures: readonly Failure[] } | { ended: "superseded" | "late" };

/** Returns the failure of a thread that has stopped. */
export function defect(problem: unknown): Failure {
  const reason = `polhode stopped: ${String(problem)}; this is a defect, please report it with the file`;
  return { kind: "defect", text: reason, reason, file: null, line: null, column: null, hint: null };
}

interface Job {
  owner: string;
  message: { name: Message["name"]; request: object };
  /** Time limit, s. */
  limit: number;
  done(outcome: Outcome<unknown>): void;
}

/** Number of threads that may run at the same time. */
const MOST = 2;

export class Pool {
  readonly #script: string;
  readonly #running = new Map<string, { job: Job; worker: Worker; timer: NodeJS.Timeout }>();
  #waiting: Job[] = [];
  /** Thread that has loaded the module and has no request. */
  #idle: Worker | null = null;

  constructor(script: string) {
    this.#script = script;
  }

  /** Answers a request, and ends the previous request of the same owner. */
  ask<T>(owner: string, name: Message["name"], request: object, limit: number): Promise<Outcome<T>> {
    this.end(owner);
    return new Promise((resolve) => {
      this.#waiting.push({ owner, message: { name, request }, limit, done: resolve as Job["done"] });
      this.#next();
    });
  }

  /** Ends the request of an owner. */
  end(owner: string, ended: "superseded" | "late" = "superseded"): void {
    const waiting = this.#waiting.filter((job) => job.owner === owner);
    this.#waiting = this.#waiting.filter((job) => job.owner !== owner);
    for (const job of waiting) job.done({ ended });
    // A message that is already under way must not answer the next request.
    void this.#running.get(owner)?.worker.removeAllListeners().terminate();
    this.#finish(owner, { ended });
  }

  dispose(): void {
    for (const owner of [...this.#waiting.map((job) => job.owner), ...this.#running.keys()]) this.end(owner);
    void this.#idle?.terminate();
  }

  #next(): void {
    const job = this.#running.size < MOST ? this.#waiting.shift() : undefined;
    if (job === undefined) return;
    const worker = this.#idle ?? new Worker(this.#script);
    this.#idle = null;
    const timer = setTimeout(() => this.end(job.owner, "late"), 1000 * job.limit);
    this.#running.set(job.owner, { job, worker, timer });
    worker.removeAllListeners().on("message", (outcome: Outcome<unknown>) => {
      if (this.#idle === null) this.#idle = worker;
      else void worker.terminate();
      this.#finish(job.owner, outcome);
    });
    worker.on("error", (problem) => this.#finish(job.owner, { failures: [defect(problem)] }));
    worker.postMessage(job.message);
  }

  #finish(owner: string, outcome: Outcome<unknown>): void {
    const running = this.#running.get(owner);
    if (running === undefined) return;
    clearTimeout(running.timer);
    this.#running.delete(owner);
    running.job.done(outcome);
    this.#next();
  }
}
