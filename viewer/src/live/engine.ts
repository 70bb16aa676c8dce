/** Requests to the server, according to the protocol. */
import { motionAnswer } from "./motion-answer";
import { jsonAndRows } from "./rows";
import type {
  CompleteAnswer,
  CompleteRequest,
  DocumentContent,
  Documents,
  Lesson,
  Lessons,
  MeshContent,
  MotionAnswer,
  MotionRequest,
  OpenAnswer,
  OpenRequest,
  Refusal,
} from "./protocol";

/** A refusal of the server, or no answer. */
export class Refused extends Error {
  readonly hint: string | null;

  constructor({ message, hint }: Refusal) {
    super(message);
    this.name = "Refused";
    this.hint = hint;
  }
}

export const server = {
  documents: (): Promise<Documents> => ask("documents"),
  document: (id: number): Promise<DocumentContent> => content(`document/${id}`),
  mesh: (id: number): Promise<MeshContent> => content(`mesh/${id}`),
  motion: async (request: MotionRequest, signal: AbortSignal): Promise<MotionAnswer> => {
    const answer = await answered("motion", posted(request, signal));
    return motionAnswer(await answer.arrayBuffer());
  },
  complete: (request: CompleteRequest, signal: AbortSignal): Promise<CompleteAnswer> => ask("complete", posted(request, signal)),
  lessons: (): Promise<Lessons> => ask("lessons"),
  lesson: (id: string): Promise<Lesson> => ask(`lesson/${encodeURIComponent(id)}`),
  drop: (set: number, path: string, file: File): Promise<unknown> => {
    return ask(`drop?${new URLSearchParams({ name: path, set: String(set) })}`, { method: "POST", body: file });
  },
  open: (request: OpenRequest): Promise<OpenAnswer> => ask("open", posted(request)),
};

function posted(body: unknown, signal?: AbortSignal): RequestInit {
  const headers = { "Content-Type": "application/json" };
  return { method: "POST", headers, body: JSON.stringify(body), ...(signal ? { signal } : {}) };
}

async function ask<T>(path: string, init?: RequestInit): Promise<T> {
  return (await (await answered(path, init)).json()) as T;
}

/** Returns the content of a document. A mesh has rows of numbers. */
async function content<T extends DocumentContent>(path: string): Promise<T> {
  const answer = await answered(path);
  if (answer.headers.get("Content-Type") === "application/json") return (await answer.json()) as T;
  const { json, withRows } = jsonAndRows<T>(await answer.arrayBuffer());
  return withRows(json);
}

async function answered(path: string, init?: RequestInit): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(path, { cache: "no-store", ...init });
  } catch (problem) {
    if (problem instanceof DOMException && problem.name === "AbortError") throw problem;
    throw new Refused({ message: "polhode live does not answer", hint: "it has ended, or another program has its port; start it again" });
  }
  if (answer.ok) return answer;
  throw new Refused(await refusal(answer));
}

async function refusal(answer: Response): Promise<Refusal> {
  try {
    const { message, hint } = (await answer.json()) as Partial<Refusal>;
    if (typeof message === "string") return { message, hint: hint ?? null };
  } catch {
    // The body is not a refusal of the server.
  }
  return { message: `the server answers ${answer.status} ${answer.statusText}`, hint: null };
}
