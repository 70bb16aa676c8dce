/**
 * What the live page and `polhode live` say to each other: the contract between `polhode-live`, which answers, and the page, which asks.
 *
 * Paths are relative to the page's own, which has the session's token in it. Bodies are JSON unless it is said otherwise. An answer that is
 * not 200 is `Refusal`. Offsets in a text count UTF-16 units, as strings of JavaScript do.
 */
import type { PageData, Shape } from "../data";

/** An answer that is not 200. */
export interface Refusal {
  message: string;
  hint: string | null;
}

/** `GET documents`: what was opened or dropped, in this order. Asked again twice a second, as a file may change. */
export interface Documents {
  documents: DocumentInfo[];
  /** What the page begins with; null if the reader is to choose a lesson. */
  first: number | null;
}

export interface DocumentInfo {
  id: number;
  /** "t-handle.toml" */
  name: string;
  kind: "scenario" | "mesh" | "robot";
  /** Its file is one mesh: `GET mesh/ID` shows it, whether it bounds a solid or not. */
  mesh: boolean;
  /** Differs if the file has changed. */
  stamp: string;
}

/** `GET document/ID`: a scenario's text as the file has it now; of a mesh or a robot what is found in it. */
export type DocumentContent =
  | { kind: "scenario"; text: string }
  | { kind: "mesh"; mesh: MeshInspection }
  | { kind: "robot"; robot: RobotInspection };

/**
 * `GET mesh/ID`: a mesh and what is found in it, also of one that bounds a solid and so has a motion. Of a mesh, here and in `GET document/ID`, the
 * answer is JSON with rows behind it, as that of `POST motion`: `{"f32": [at, count]}` and `{"u32": [at, count]}`, counted in numbers.
 */
export type MeshContent = Extract<DocumentContent, { kind: "mesh" }>;

/**
 * `POST motion`: change a scenario, and compute its motion. The answer is JSON with rows of f64 behind it: the length of the JSON as a u64, the
 * JSON, and the numbers, all little-endian. Where a row belongs into `page.motion` and `page.free` the JSON has `{"f64": [at, count]}`, counted
 * in numbers; its length is a multiple of eight, so that they can be read where they are.
 */
export interface MotionRequest {
  /** Whose files the scenario may name. */
  document: number;
  text: string;
  /** Applied to the text one after the other. */
  edits: Edit[];
  /** Of the page's parts, those that take time: the error of the numbers and the worked solution. */
  error: boolean;
  working: boolean;
  /** `body` of the last answer: what the page has of the body is not sent again. */
  body: string | null;
}

export type Edit =
  /** A value of the scenario by its key, "body.part[0].radius", as TOML: `"4 mm"`. Null takes the key away. */
  | { set: string; value: string | null }
  /** ω at the start, body axes, rad/s; the attitude stays. */
  | { omega: [number, number, number] }
  /** Attitude (w, x, y, z) and ω in body axes, rad/s, at the start. */
  | { attitude: [number, number, number, number]; omega: [number, number, number] }
  /** Principal moments, ascending, kg·m²: the body becomes a tensor with the mass, the centre of mass and the principal axes that it has. */
  | { moments: [number, number, number] };

export interface MotionAnswer {
  /** The text with the edits. */
  text: string;
  /** Null if it is no scenario, or if its motion cannot be computed. */
  motion: {
    page: PageData;
    /** If it is what was asked with, `page.body.shapes`, `page.free.family` and `page.free.separatrix` are empty, and the last ones are meant. */
    body: string;
  } | null;
  /** Empty if the text is no TOML. */
  knobs: Knob[];
  switches: Switch[];
  /** What is wrong: one error, as the reader stops there. */
  errors: TextError[];
  /** ms that the answer took. */
  took: number;
}

export interface TextError {
  message: string;
  hint: string | null;
  /** Where in the text; null if it is nowhere in it. */
  from: number | null;
  to: number | null;
  line: number | null;
  column: number | null;
}

/** A number of the scenario that can be turned. */
export interface Knob {
  /** "body.part[0].radius" */
  key: string;
  /** "crossbar: radius" */
  label: string;
  group: "body" | "start" | "torque" | "wheel" | "run" | "other";
  /** As it is written: 4 of "4 mm". */
  value: number;
  /** As it is written; empty of a plain number in SI. */
  unit: string;
  /** The unit of a plain number, to be shown: "m"; empty of a number without a dimension. */
  si: string;
  /** What it is: "a length". */
  what: string;
  /** As the value is written. */
  low: number;
  high: number;
  /** Equal steps, or equal factors: of what is positive. */
  scale: "linear" | "log";
  /** The most telling first. */
  rank: number;
}

/** A torque that can be switched on and off. */
export interface Switch {
  /** "torque[0].on" */
  key: string;
  label: string;
  on: boolean;
}

/** `POST complete`: what may stand at a place of the text. */
export interface CompleteRequest {
  document: number;
  text: string;
  at: number;
}

export interface CompleteAnswer {
  /** What the chosen one replaces. */
  from: number;
  to: number;
  options: { label: string; detail: string }[];
}

/**
 * `POST drop?name=part.stl&set=7`: bytes of a file as the body. Files of the same set, a number of the page's choice, lie in one folder, so that
 * a model finds its meshes. Then `POST open`.
 */
export interface OpenRequest {
  set: number;
  /** One of its files. */
  name: string;
}

/** A scenario is made of a body that is sound: its motion is shown at once. */
export type OpenAnswer = DocumentInfo;

/** A mesh, and what is wrong with it; it bounds a solid if nothing of it is an error. */
export interface MeshInspection {
  name: string;
  /** x y z of each vertex, m. */
  vertices: Float32Array;
  /** Three for each triangle. */
  triangles: Uint32Array;
  /** How many the file has; more than are here if it was made coarser. */
  of: number;
  findings: MeshFinding[];
}

export interface MeshFinding {
  code: string;
  severity: "error" | "warning" | "info";
  message: string;
  /** What to do about it. */
  hint: string | null;
  /** Pairs of points, x y z, of the edges that it marks; empty if it marks none. */
  edges: Float32Array;
  /** x y z of three corners for each triangle that it marks. */
  faces: Float32Array;
}

/** A robot as it stands with all joints at zero. */
export interface RobotInspection {
  name: string;
  links: RobotLink[];
  /** `file`, if the place is in one that the model includes. */
  findings: { link: number | null; code: string; severity: "impossible" | "suspect" | "note"; message: string; file?: string; line: number; column: number }[];
  /** The repaired file and what was changed; null if no fix is the only one that agrees with all evidence. */
  repair: { text: string; changes: { line: number; before: string; after: string }[] } | null;
}

export interface RobotLink {
  name: string;
  /** Of the link's frame in the model's: m, and (w, x, y, z). */
  position: [number, number, number];
  quaternion: [number, number, number, number];
  /** In the link's frame: its visual geometry, or its collision geometry where it has no visual. */
  shapes: Shape[];
  /** Null without an inertial. */
  inertial: {
    mass: number;
    /** In the link's frame. */
    center: [number, number, number];
    /** Of the equivalent box along the principal axes, m; null of an impossible tensor. */
    box: { size: [number, number, number]; quaternion: [number, number, number, number] } | null;
  } | null;
  verdict: "impossible" | "suspect" | "ok" | "none";
}

/** `GET lessons`; a teacher's own comes first. */
export interface Lessons {
  lessons: LessonInfo[];
}

export interface LessonInfo {
  /** Behind `#lesson=` in the page's address it is begun with. */
  id: string;
  title: string;
  summary: string;
}

/** `GET lesson/ID` */
export interface Lesson extends LessonInfo {
  /** Its scenario, among the documents from now on. */
  document: number;
  steps: LessonStep[];
}

/** Read, predict, turn, see. */
export interface LessonStep {
  text: string;
  /** A question with answers to choose from, `right` from 0; null if there is nothing to predict. */
  question: { text: string; answers: string[]; right: number; why: string } | null;
  /** Keys of knobs to turn, the only ones shown. */
  knobs: string[];
  /** The scenario that it begins with. */
  scenario: string;
  /** Which part of the worked solution stands beside it: the beginning of its heading; null for none. */
  working: string | null;
}
