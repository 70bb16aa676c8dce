/** Requests to the engine, which computes in a worker of the page. */
import { motionAnswer } from "./motion-answer";
import { embedded } from "./embedded";
import type { CompleteAnswer, CompleteRequest, DocumentContent, DocumentInfo, Documents, ExerciseAnswer, ExerciseRequest, Exercises, Lesson, Lessons, MeshContent, MotionAnswer, MotionRequest, Refusal, ReportAnswer, ReportRequest } from "./protocol";
import { jsonAndRows } from "./rows";
import { Workshop } from "./workshop";

/** A refusal of the engine. */
export class Refused extends Error {
  readonly hint: string | null;

  constructor({ message, hint }: Refusal) {
    super(message);
    this.name = "Refused";
    this.hint = hint;
  }
}

/** Returns the message of an error, with advice if there is any. */
export function reason(problem: unknown): string {
  return [problem instanceof Error ? problem.message : String(problem), problem instanceof Refused ? problem.hint : null].filter(Boolean).join(" — ");
}

const workshop = new Workshop(embedded.module, embedded.worker);

export const engine = {
  documents: (): Promise<Documents> => ask("documents"),
  document: (id: number): Promise<DocumentContent> => ask({ document: { id } }),
  mesh: (id: number): Promise<MeshContent> => ask({ mesh: { id } }),
  motion: async (request: MotionRequest, signal: AbortSignal): Promise<MotionAnswer> => {
    const { bytes, took } = await answered({ motion: request }, { isKept: false, signal });
    return { ...motionAnswer(bytes), took };
  },
  report: (request: ReportRequest, signal: AbortSignal): Promise<ReportAnswer> => ask({ report: request }, { isKept: false, signal }),
  complete: (request: CompleteRequest, signal: AbortSignal): Promise<CompleteAnswer> => ask({ complete: request }, { isKept: false, signal }),
  lessons: (): Promise<Lessons> => ask("lessons"),
  lesson: (id: string): Promise<Lesson> => ask({ lesson: { id } }, { isKept: true }),
  exercises: (): Promise<Exercises> => ask("exercises"),
  exercise: (request: ExerciseRequest): Promise<ExerciseAnswer> => ask({ exercise: request }),
  /** Begins with a teacher's own lesson, and returns its id. */
  lessonFile: (path: string): Promise<{ id: string }> => ask({ lesson_file: { path } }, { isKept: true }),
  /** Adds a file, or replaces it. */
  put: async (path: string, bytes: Blob): Promise<void> => {
    await workshop.do({ path, bytes }, { isKept: true });
  },
  /** Opens a file. One of a set, a folder, may refer only to files of that folder. */
  open: (path: string, set: string | null = null): Promise<DocumentInfo> => ask({ open: { path, set } }, { isKept: true }),
  /** Opens a table again, as particles. */
  particles: (id: number): Promise<DocumentInfo> => ask({ particles: { id } }, { isKept: true }),
  openExample: (): Promise<DocumentInfo> => ask("open_example", { isKept: true }),
};

type How = Parameters<Workshop["do"]>[1];

async function ask<T>(message: unknown, how: How = { isKept: false }): Promise<T> {
  const { bytes } = await answered(message, how);
  const { json, withRows } = jsonAndRows<T>(bytes);
  return withRows(json);
}

async function answered(message: unknown, how: How): Promise<{ bytes: ArrayBuffer; took: number }> {
  const answer = await workshop.do({ request: JSON.stringify(message) }, how);
  const refusal = refusalIn(answer.bytes);
  if (refusal) throw new Refused(refusal);
  return answer;
}

const REFUSAL = new TextEncoder().encode('{"refusal":');

function refusalIn(bytes: ArrayBuffer): Refusal | null {
  const first = new Uint8Array(bytes, 0, Math.min(REFUSAL.length, bytes.byteLength));
  if (first.length < REFUSAL.length || !first.every((byte, k) => byte === REFUSAL[k])) return null;
  const { refusal } = JSON.parse(new TextDecoder().decode(bytes)) as { refusal: Refusal | null };
  return refusal ?? { kind: "internal", message: "the engine could not write its answer", hint: null };
}
