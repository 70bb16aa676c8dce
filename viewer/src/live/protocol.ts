/**
 * Protocol of the interactive page: the contract between the page and `polhode_web::Engine`.
 *
 * Requests and answers are JSON except where noted; a request is written here as
 * `{"motion": MotionRequest}`. Each may be answered by `{"refusal": Refusal}`. Offsets in a text
 * count UTF-16 units, as in JavaScript strings.
 */
import type { PageData, Shape } from "../data";

/** Reason why there is no answer. */
export interface Refusal {
  message: string;
  hint: string | null;
}

/** `"documents"`: documents in the order in which they were opened or dropped. */
export interface Documents {
  documents: DocumentInfo[];
  /** Document to begin with; null if the reader must choose a lesson. */
  first: number | null;
}

export interface DocumentInfo {
  id: number;
  /** Name, such as "t-handle.toml". */
  name: string;
  kind: "scenario" | "mesh" | "robot" | "table";
  /** True if the file is a single mesh: `{"mesh": {"id"}}` shows it, whether it is closed or not. */
  mesh: boolean;
  /** Changes when the file changes. */
  stamp: string;
}

/**
 * `{"document": {"id"}}`: current text of a scenario, the inspection of a mesh or a robot, or the
 * kinds of a table.
 */
export type DocumentContent =
  | { kind: "scenario"; text: string }
  | { kind: "mesh"; mesh: MeshInspection }
  | { kind: "robot"; robot: RobotInspection }
  | { kind: "table"; table: TableContent };

/** Command that reads a table; `{"particles": {"id"}}` opens the file again as a body that turns. */
export type TableKind = "budget" | "identify" | "judge" | "particles";

/** A table or a plan. */
export interface TableContent {
  /** Possible kinds; the reader chooses if there are several. */
  kinds: { kind: TableKind; what: string; fields: Field[] }[];
  /** Text of a plan in TOML; null for a table. */
  text: string | null;
  /** True if the log names a scenario that was dropped with it. */
  has_scenario: boolean;
}

/** Option of a command: a field of its request. */
export interface Field {
  key: string;
  what: string;
  form: "text" | "integer" | "flag" | "choice";
  choices: string[];
}

/** `{"report": ReportRequest}`: report on a table. */
export interface ReportRequest {
  document: number;
  kind: TableKind;
  /** Text of the plan, if it was edited. */
  text: string | null;
  /** Scenario by which a run is judged, if it does not name its own. */
  scenario: { document: number; text: string } | null;
  options: Options;
}

export type Options = Record<string, string | number | boolean>;

export interface ReportAnswer {
  /** Report as the command prints it with --html and --json. */
  report: { title: string; html: string; json: string; has_failed: boolean } | null;
  /** `places` are places with their lines, as the command prints them. */
  error: (TextError & { places: string }) | null;
}

/**
 * `{"mesh": {"id"}}`: inspection of a mesh, also of a closed one with a motion. For a mesh, here
 * and in `{"document": {"id"}}`, the answer is JSON followed by rows, like that of a motion:
 * `{"f32": [at, count]}` and `{"u32": [at, count]}`, counted in numbers.
 */
export type MeshContent = Extract<DocumentContent, { kind: "mesh" }>;

/**
 * `{"motion": MotionRequest}`: changes a scenario and computes its motion.
 *
 * The answer is JSON followed by rows of f64: the length of the JSON as a u64, the JSON, and the
 * numbers, all little-endian. For each row in `page.motion` and `page.free`, the JSON has
 * `{"f64": [at, count]}`, counted in numbers. The length of the JSON is a multiple of eight, so
 * that the numbers can be read in place.
 */
export interface MotionRequest {
  /** Document to whose files the scenario may refer. */
  document: number;
  text: string;
  /** Edits, applied to the text one after the other. */
  edits: Edit[];
  /** Requests for the slow parts of the page: the error of the numbers and the worked solution. */
  error: boolean;
  working: boolean;
  /** `body` of the last answer. Data of the body that the page has already are not sent again. */
  body: string | null;
}

export type Edit =
  /**
   * Value of the scenario by its key, "body.part[0].radius", as TOML: `"4 mm"`. Null removes the
   * key.
   */
  | { set: string; value: string | null }
  /** ω at the start, body axes, rad/s; the attitude is kept. */
  | { omega: [number, number, number] }
  /** Attitude (w, x, y, z) and ω in body axes, rad/s, at the start. */
  | { attitude: [number, number, number, number]; omega: [number, number, number] }
  /**
   * Principal moments, ascending, kg·m². The body becomes a tensor with the present mass, centre of
   * mass and principal axes.
   */
  | { moments: [number, number, number] };

export interface MotionAnswer {
  /** Text with the edits. */
  text: string;
  /** Null if the text is not a scenario, or its motion cannot be computed. */
  motion: {
    page: PageData;
    /**
     * If it equals that of the request, `page.body.shapes`, `page.free.family` and
     * `page.free.separatrix` are empty, and the previous ones are valid.
     */
    body: string;
  } | null;
  /** Knobs; empty if the text is not TOML. */
  knobs: Knob[];
  switches: Switch[];
  /** Errors: at most one, because the reader stops at the first. */
  errors: TextError[];
  /** Computation time of the answer, ms. */
  took: number;
}

export interface TextError {
  message: string;
  hint: string | null;
  /** Place in the text; null if the error has none. */
  from: number | null;
  to: number | null;
  line: number | null;
  column: number | null;
}

/** A number of the scenario that can be changed. */
export interface Knob {
  /** Key, such as "body.part[0].radius". */
  key: string;
  /** Label, such as "crossbar: radius". */
  label: string;
  group: "body" | "start" | "torque" | "wheel" | "run" | "other";
  /** Value in the unit of the text: 4 for "4 mm". */
  value: number;
  /** Unit in the text; empty for a plain number in SI units. */
  unit: string;
  /** SI unit of a plain number for display: "m"; empty for a dimensionless number. */
  si: string;
  /** Kind of quantity: "a length". */
  what: string;
  /** Ends of the slider, in the unit of the text. */
  low: number;
  high: number;
  /** Equal steps, or, for positive quantities, equal factors. */
  scale: "linear" | "log";
  /** Rank, the most informative first. */
  rank: number;
}

/** A torque that can be switched on and off. */
export interface Switch {
  /** Key, such as "torque[0].on". */
  key: string;
  label: string;
  on: boolean;
}

/** `{"complete": CompleteRequest}`: completions at a place of the text. */
export interface CompleteRequest {
  document: number;
  text: string;
  at: number;
}

export interface CompleteAnswer {
  /** Interval that the chosen completion replaces. */
  from: number;
  to: number;
  options: { label: string; detail: string }[];
}

/** Inspection of a mesh. It is closed if no finding is an error. */
export interface MeshInspection {
  name: string;
  /** Coordinates x, y, z of each vertex, m. */
  vertices: Float32Array;
  /** Indices of three vertices for each triangle. */
  triangles: Uint32Array;
  /** Number of triangles in the file; greater than the number here if the mesh was made coarser. */
  of: number;
  findings: MeshFinding[];
}

export interface MeshFinding {
  code: string;
  severity: "error" | "warning" | "info";
  message: string;
  /** Advice for a fix. */
  hint: string | null;
  /** Marked edges as pairs of points x, y, z; empty if there are none. */
  edges: Float32Array;
  /** Marked triangles as x, y, z of three corners. */
  faces: Float32Array;
}

/** Inspection of a robot with all joints at zero. */
export interface RobotInspection {
  name: string;
  links: RobotLink[];
  /** Findings; `file` is given if the place is in an included file. */
  findings: { link: number | null; code: string; severity: "impossible" | "suspect" | "note"; message: string; file?: string; line: number; column: number }[];
  /** Repaired file and its changes; null if no fix is the only one consistent with all data. */
  repair: { text: string; changes: { line: number; before: string; after: string }[] } | null;
}

export interface RobotLink {
  name: string;
  /** Pose of the link's frame in the model's frame: m, and (w, x, y, z). */
  position: [number, number, number];
  quaternion: [number, number, number, number];
  /** Visual geometry in the link's frame, or collision geometry if there is no visual. */
  shapes: Shape[];
  /** Inertial data; null if the link has none. */
  inertial: {
    mass: number;
    /** Centre of mass in the link's frame. */
    center: [number, number, number];
    /** Equivalent box along the principal axes, m; null for an unphysical tensor. */
    box: { size: [number, number, number]; quaternion: [number, number, number, number] } | null;
  } | null;
  verdict: "impossible" | "suspect" | "ok" | "none";
}

/** `"lessons"`; a teacher's own lesson comes first. */
export interface Lessons {
  lessons: LessonInfo[];
}

export interface LessonInfo {
  /** Identifier; `#lesson=ID` in the page's address opens the lesson. */
  id: string;
  title: string;
  summary: string;
}

/** `{"lesson": {"id"}}` */
export interface Lesson extends LessonInfo {
  /** Document of its scenario. */
  document: number;
  steps: LessonStep[];
}

/** A step of a lesson: read, predict, change, see. */
export interface LessonStep {
  text: string;
  /**
   * Question with answers to choose from, `right` counted from 0; null if there is no prediction.
   */
  question: { text: string; answers: string[]; right: number; why: string } | null;
  /** Keys of the only knobs shown. */
  knobs: string[];
  /** Scenario at the beginning of the step. */
  scenario: string;
  /**
   * Part of the worked solution shown with the step: the beginning of its heading; null for none.
   */
  working: string | null;
}
