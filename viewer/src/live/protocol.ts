/* Types of crates/polhode-web/schema/protocol.json, written by viewer/types.mjs; do not edit. */
import type {ExplanationBlock, PageData, Shape} from "../data";

/**
 * Request of the page.
 */
export type Request =
  | ("documents" | "lessons" | "exercises" | "open_example")
  | {
      document: {
        /**
         * Number of the document.
         */
        id: number;
      };
    }
  | {
      mesh: {
        /**
         * Number of the document.
         */
        id: number;
      };
    }
  | {
      lesson: {
        /**
         * Identifier of the lesson.
         */
        id: string;
      };
    }
  | {
      motion: MotionRequest;
    }
  | {
      exercise: ExerciseRequest;
    }
  | {
      complete: CompleteRequest;
    }
  | {
      lesson_file: {
        /**
         * Path of the file in the source of files.
         */
        path: string;
      };
    }
  | {
      open: {
        /**
         * Path of the file in the source of files.
         */
        path: string;
        /**
         * Folder of a set of dropped files: a file of the set may refer only to files in it.
         */
        set?: string | null;
      };
    }
  | {
      report: ReportRequest;
    }
  | {
      particles: {
        /**
         * Number of the document.
         */
        id: number;
      };
    };
/**
 * Change of a text.
 */
export type Edit =
  | {
      /**
       * Key, such as "body.part[0].radius".
       */
      set: string;
      /**
       * Value as TOML, such as `"4 mm"`; null removes the key.
       */
      value: string | null;
    }
  | {
      /**
       * Attitude (w, x, y, z).
       *
       * @minItems 4
       * @maxItems 4
       *
       * Items: Component, dimensionless.
       */
      attitude: [number, number, number, number];
      /**
       * ω, body axes, rad/s.
       *
       * @minItems 3
       * @maxItems 3
       *
       * Items: Component, rad/s.
       */
      omega: [number, number, number];
    }
  | {
      /**
       * ω, body axes, rad/s.
       *
       * @minItems 3
       * @maxItems 3
       *
       * Items: Component, rad/s.
       */
      omega: [number, number, number];
    }
  | {
      /**
       * Principal moments, ascending, kg·m².
       *
       * @minItems 3
       * @maxItems 3
       *
       * Items: Component, kg·m².
       */
      moments: [number, number, number];
    };
/**
 * Kind of a table or a plan: the command that reads it, or particles, which are a body that turns.
 */
export type TableKind = "budget" | "identify" | "judge" | "particles";
/**
 * Answer to `{"document": {"id"}}`: current text of a scenario, the inspection of a mesh or a robot, or the kinds of a table.
 */
export type DocumentContent = ScenarioContent | MeshContent | RobotContent | TableDocument;

/**
 * Request of the page, and the answer of `polhode_web::Engine`. Both are JSON except where noted. Offsets in a text count UTF-16 units, as in JavaScript strings.
 */
export interface Exchange {
  request: Request;
  /**
   * Answer; those to `open`, `particles` and `open_example` are a DocumentInfo.
   */
  answer:
    | Documents
    | DocumentContent
    | MotionAnswer
    | CompleteAnswer
    | ReportAnswer
    | Lessons
    | Lesson
    | LessonFile
    | Exercises
    | ExerciseAnswer
    | DocumentInfo
    | Refused;
}
/**
 * `{"motion": MotionRequest}`: changes a scenario and computes its motion.
 *
 * The answer is JSON followed by rows of f64: the length of the JSON as a u64, the JSON, and the numbers, all little-endian. For each row in `page.motion` and `page.free`, the JSON has `{"f64": [at, count]}`, counted in numbers. The length of the JSON is a multiple of eight, so that the numbers can be read in place.
 */
export interface MotionRequest {
  /**
   * Document to whose files the scenario may refer.
   */
  document: number;
  /**
   * Text of the scenario.
   */
  text: string;
  /**
   * Edits, applied to the text one after the other.
   */
  edits: Edit[];
  /**
   * True to estimate the error of the motion, which is slow.
   */
  error: boolean;
  /**
   * True to write the worked solution, which is slow.
   */
  working: boolean;
  /**
   * `body` of the last answer. Data of the body that the page has already are not sent again.
   */
  body: string | null;
}
/**
 * `{"exercise": ExerciseRequest}`: makes an exercise, and grades answers to it.
 */
export interface ExerciseRequest {
  /**
   * Name of the topic.
   */
  topic: string;
  /**
   * Seed of the numbers.
   */
  seed: number;
  /**
   * True for the problem in symbols.
   */
  symbols: boolean;
  /**
   * Answers to be graded, in the form of the template; null for none.
   */
  answers: string | null;
  /**
   * True to return the solution.
   */
  solution: boolean;
}
/**
 * `{"complete": CompleteRequest}`: completions at a place of the text.
 */
export interface CompleteRequest {
  /**
   * Document to which the text belongs.
   */
  document: number;
  /**
   * Text of the scenario.
   */
  text: string;
  /**
   * Position of the cursor, in UTF-16 units.
   */
  at: number;
}
/**
 * `{"report": ReportRequest}`: report on a table.
 */
export interface ReportRequest {
  /**
   * Document with the table or the plan.
   */
  document: number;
  kind: TableKind;
  /**
   * Text of the plan, if it was edited.
   */
  text: string | null;
  /**
   * Scenario that is open, with its text: runs are judged by it.
   */
  scenario: {
    /**
     * Document of the scenario.
     */
    document: number;
    /**
     * Text of the scenario.
     */
    text: string;
  } | null;
  options: Options;
}
/**
 * Options of a command: fields of the slice's request.
 */
export interface Options {
  [k: string]: string | number | boolean;
}
/**
 * Answer to `"documents"`: documents in the order in which they were opened or dropped.
 */
export interface Documents {
  documents: DocumentInfo[];
  /**
   * Document to begin with; null if the reader must choose a lesson.
   */
  first: number | null;
}
/**
 * Entry of a document in a list.
 */
export interface DocumentInfo {
  /**
   * Number used in requests.
   */
  id: number;
  /**
   * Name, such as "t-handle.toml".
   */
  name: string;
  /**
   * Kind of document.
   */
  kind: "scenario" | "mesh" | "robot" | "table";
  /**
   * True if the file is a single mesh: `{"mesh": {"id"}}` shows it, whether it is closed or not.
   */
  mesh: boolean;
  /**
   * Changes when the file changes.
   */
  stamp: string;
}
/**
 * Text of a scenario.
 */
export interface ScenarioContent {
  kind: "scenario";
  /**
   * Current text.
   */
  text: string;
}
/**
 * Answer to `{"mesh": {"id"}}`: inspection of a mesh, also of a closed one with a motion. For a mesh, here and in `{"document": {"id"}}`, the answer is JSON followed by rows, like that of a motion: `{"f32": [at, count]}` and `{"u32": [at, count]}`, counted in numbers.
 */
export interface MeshContent {
  kind: "mesh";
  mesh: MeshInspection;
}
/**
 * Inspection of a mesh. It is closed if no finding is an error.
 */
export interface MeshInspection {
  /**
   * Name of the file.
   */
  name: string;
  /**
   * Coordinates x, y, z of each vertex, m.
   */
  vertices: Float32Array;
  /**
   * Indices of three vertices for each triangle.
   */
  triangles: Uint32Array;
  /**
   * Number of triangles in the file; greater than the number here if the mesh was made coarser.
   */
  of: number;
  findings: MeshFinding[];
}
/**
 * Finding about a mesh, with marked places.
 */
export interface MeshFinding {
  /**
   * Kind of finding.
   */
  code: string;
  /**
   * Severity.
   */
  severity: "error" | "warning" | "info";
  /**
   * What was found.
   */
  message: string;
  /**
   * Advice for a fix.
   */
  hint: string | null;
  /**
   * Marked edges as pairs of points x, y, z; empty if there are none.
   */
  edges: Float32Array;
  /**
   * Marked triangles as x, y, z of three corners.
   */
  faces: Float32Array;
}
/**
 * Inspection of a robot.
 */
export interface RobotContent {
  kind: "robot";
  robot: RobotInspection;
}
/**
 * Inspection of a robot with all joints at zero.
 */
export interface RobotInspection {
  /**
   * Name of the model, or of the file.
   */
  name: string;
  links: RobotLink[];
  /**
   * Items: Finding about a robot.
   */
  findings: {
    /**
     * Index of the link.
     */
    link: number | null;
    /**
     * Kind of finding.
     */
    code: string;
    /**
     * Severity.
     */
    severity: "impossible" | "suspect" | "note";
    /**
     * What was found.
     */
    message: string;
    /**
     * File of the place, if it is an included file.
     */
    file?: string;
    /**
     * Line of the place, from 1.
     */
    line: number;
    /**
     * Character of the place in its line, from 1.
     */
    column: number;
  }[];
  /**
   * Repaired file and its changes; null if no fix is the only one consistent with all data.
   */
  repair: {
    /**
     * Repaired text.
     */
    text: string;
    /**
     * Items: Line that the repair changes.
     */
    changes: {
      /**
       * Line, from 1.
       */
      line: number;
      /**
       * Line before the repair.
       */
      before: string;
      /**
       * Line after the repair.
       */
      after: string;
    }[];
  } | null;
}
/**
 * Link of a robot.
 */
export interface RobotLink {
  /**
   * Name of the link.
   */
  name: string;
  /**
   * Position of the link's frame in the model's frame, m.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Component, m.
   */
  position: [number, number, number];
  /**
   * Attitude of the link's frame in the model's frame (w, x, y, z).
   *
   * @minItems 4
   * @maxItems 4
   *
   * Items: Component, dimensionless.
   */
  quaternion: [number, number, number, number];
  /**
   * Visual geometry in the link's frame, or collision geometry if there is no visual.
   */
  shapes: Shape[];
  /**
   * Inertial data; null if the link has none.
   */
  inertial: {
    /**
     * Mass, kg.
     */
    mass: number;
    /**
     * Centre of mass in the link's frame, m.
     *
     * @minItems 3
     * @maxItems 3
     *
     * Items: Component, m.
     */
    center: [number, number, number];
    /**
     * Equivalent box along the principal axes; null for an unphysical tensor.
     */
    box: {
      /**
       * Edges, m.
       *
       * @minItems 3
       * @maxItems 3
       *
       * Items: Component, m.
       */
      size: [number, number, number];
      /**
       * Attitude of the box in the link's frame (w, x, y, z).
       *
       * @minItems 4
       * @maxItems 4
       *
       * Items: Component, dimensionless.
       */
      quaternion: [number, number, number, number];
    } | null;
  } | null;
  /**
   * Severity of the worst finding; none for a link without inertial data.
   */
  verdict: "impossible" | "suspect" | "ok" | "none";
}
/**
 * Table or plan, whose report is another request.
 */
export interface TableDocument {
  kind: "table";
  table: TableContent;
}
/**
 * Content of a table or a plan.
 */
export interface TableContent {
  /**
   * Possible kinds; the reader chooses if there are several.
   *
   * Items: Kind of a table.
   */
  kinds: {
    kind: TableKind;
    /**
     * Meaning of the kind, in a sentence.
     */
    what: string;
    fields: Field[];
  }[];
  /**
   * Text of a plan in TOML, which can be edited; null for a table.
   */
  text: string | null;
  /**
   * True if the log names a scenario that was dropped with it.
   */
  has_scenario: boolean;
}
/**
 * Option of a command: a field of its request.
 */
export interface Field {
  /**
   * Key of the request, and name of the command's option without its dashes.
   */
  key: string;
  /**
   * Description in a sentence.
   */
  what: string;
  /**
   * Form of the value.
   */
  form: "text" | "integer" | "flag" | "choice";
  /**
   * Values of a choice.
   */
  choices: string[];
}
/**
 * Changed text, and its motion or its errors.
 */
export interface MotionAnswer {
  /**
   * Text with the edits.
   */
  text: string;
  /**
   * Null if the text is not a scenario, or its motion cannot be computed.
   */
  motion: {
    /**
     * Data of the page.
     */
    page: PageData;
    /**
     * If it equals that of the request, `page.body.shapes`, `page.free.family` and `page.free.separatrix` are empty, and the previous ones are valid.
     */
    body: string;
  } | null;
  /**
   * Knobs; empty if the text is not TOML.
   */
  knobs: Knob[];
  /**
   * Switch of each torque.
   */
  switches: Switch[];
  /**
   * Errors: at most one, because the reader stops at the first.
   */
  errors: TextError[];
  /**
   * Computation time of the answer, ms.
   */
  took: number;
}
/**
 * A number of the scenario that can be changed.
 */
export interface Knob {
  /**
   * Key, such as "body.part[0].radius".
   */
  key: string;
  /**
   * Label, such as "crossbar: radius".
   */
  label: string;
  /**
   * Table of the scenario to which the number belongs.
   */
  group: "body" | "start" | "torque" | "wheel" | "run" | "other";
  /**
   * Value in the unit of the text: 4 for "4 mm".
   */
  value: number;
  /**
   * Unit in the text; empty for a plain number in SI units.
   */
  unit: string;
  /**
   * SI unit of a plain number for display: "m"; empty for a dimensionless number.
   */
  si: string;
  /**
   * Kind of quantity: "a length".
   */
  what: string;
  /**
   * Lower end of the slider, in the unit of the text.
   */
  low: number;
  /**
   * Upper end of the slider, in the unit of the text.
   */
  high: number;
  /**
   * Scale of the slider: equal steps, or, for positive quantities, equal factors.
   */
  scale: "linear" | "log";
  /**
   * Rank, the most informative first.
   */
  rank: number;
}
/**
 * A torque that can be switched on and off.
 */
export interface Switch {
  /**
   * Key, such as "torque[0].on".
   */
  key: string;
  /**
   * Name or model of the torque.
   */
  label: string;
  /**
   * True if the torque acts.
   */
  on: boolean;
}
/**
 * Error in a text; the place is null if the error has none.
 */
export interface TextError {
  /**
   * Description of the error, and the rule.
   */
  message: string;
  /**
   * Advice for a fix.
   */
  hint: string | null;
  /**
   * Start of the place in the text, in UTF-16 units.
   */
  from: number | null;
  /**
   * End of the place in the text, in UTF-16 units.
   */
  to: number | null;
  /**
   * Line of the place, from 1.
   */
  line: number | null;
  /**
   * Character of the place in its line, from 1.
   */
  column: number | null;
}
/**
 * Completions, and the interval that the chosen one replaces.
 */
export interface CompleteAnswer {
  /**
   * Start of the interval, in UTF-16 units.
   */
  from: number;
  /**
   * End of the interval, in UTF-16 units.
   */
  to: number;
  /**
   * Items: Completion.
   */
  options: {
    /**
     * Text to insert.
     */
    label: string;
    /**
     * Description, such as the unit.
     */
    detail: string;
  }[];
}
/**
 * Report on a table, or its error.
 */
export interface ReportAnswer {
  report: {
    /**
     * Title of the report.
     */
    title: string;
    /**
     * Self-contained page.
     */
    html: string;
    /**
     * Complete result as JSON.
     */
    json: string;
    /**
     * True if the command would exit with status 1.
     */
    has_failed: boolean;
  } | null;
  error: ReportError | null;
}
/**
 * Error of a table, a plan or the options; the place is null if it is not in the text of the document.
 */
export interface ReportError {
  /**
   * Description of the error, and the rule.
   */
  message: string;
  /**
   * Advice for a fix.
   */
  hint: string | null;
  /**
   * Start of the place in the text, in UTF-16 units.
   */
  from: number | null;
  /**
   * End of the place in the text, in UTF-16 units.
   */
  to: number | null;
  /**
   * Line of the place, from 1.
   */
  line: number | null;
  /**
   * Character of the place in its line, from 1.
   */
  column: number | null;
  /**
   * Places with their lines, as the command prints them; empty if there is none.
   */
  places: string;
}
/**
 * Answer to `"lessons"`; a teacher's own lesson comes first.
 */
export interface Lessons {
  lessons: LessonInfo[];
}
/**
 * Entry of a lesson in a list.
 */
export interface LessonInfo {
  /**
   * Identifier; `#lesson=ID` in the page's address opens the lesson.
   */
  id: string;
  /**
   * Title of the lesson.
   */
  title: string;
  /**
   * Subject of the lesson, in a sentence.
   */
  summary: string;
}
/**
 * Answer to `{"lesson": {"id"}}`.
 */
export interface Lesson {
  /**
   * Identifier; `#lesson=ID` in the page's address opens the lesson.
   */
  id: string;
  /**
   * Title of the lesson.
   */
  title: string;
  /**
   * Subject of the lesson, in a sentence.
   */
  summary: string;
  /**
   * Document of its scenario.
   */
  document: number;
  steps: LessonStep[];
}
/**
 * A step of a lesson: read, predict, change, see.
 */
export interface LessonStep {
  /**
   * Text to read.
   */
  text: string;
  /**
   * Question to answer before the motion is shown; null if there is no prediction.
   */
  question: {
    /**
     * Text of the question.
     */
    text: string;
    /**
     * Answers to choose from.
     */
    answers: string[];
    /**
     * Index of the right answer, from 0.
     */
    right: number;
    /**
     * Explanation of the right answer.
     */
    why: string;
  } | null;
  /**
   * Keys of the only knobs shown.
   */
  knobs: string[];
  /**
   * Scenario at the beginning of the step.
   */
  scenario: string;
  /**
   * Part of the worked solution shown with the step: the beginning of its heading; null for none.
   */
  working: string | null;
}
/**
 * Answer to `{"lesson_file": {"path"}}`.
 */
export interface LessonFile {
  /**
   * Identifier of the lesson.
   */
  id: string;
}
/**
 * Answer to `"exercises"`: topics in the order of the chapter.
 */
export interface Exercises {
  /**
   * Items: Topic of exercises.
   */
  topics: {
    /**
     * Name; `#exercise=TOPIC,SEED` in the page's address opens an exercise.
     */
    topic: string;
    /**
     * Title of the topic.
     */
    title: string;
    /**
     * True if the topic has a problem in symbols.
     */
    symbols: boolean;
  }[];
}
/**
 * Exercise, with grades and solution if they are requested.
 */
export interface ExerciseAnswer {
  /**
   * Problem, its title first.
   */
  problem: ExplanationBlock[];
  /**
   * Answers as TOML, with question marks.
   */
  template: string;
  /**
   * Null without answers, or if their text has an error.
   */
  grades:
    | {
        /**
         * Name of the answer.
         */
        name: string;
        /**
         * Grade of the answer.
         */
        grade: "right" | "wrong" | "wrong unit" | "missing";
        /**
         * Mistake, if it is recognized; empty for right and missing answers.
         */
        reason: string;
      }[]
    | null;
  /**
   * Errors in the text of the answers: at most one.
   */
  errors: TextError[];
  /**
   * Solution; null if it is not requested.
   */
  solution: ExplanationBlock[] | null;
}
/**
 * Answer to a request that is refused.
 */
export interface Refused {
  refusal: Refusal;
}
/**
 * Reason why there is no answer.
 */
export interface Refusal {
  /**
   * Kind of refusal.
   */
  kind: "bad_request" | "not_found" | "unprocessable" | "full" | "ended" | "internal";
  /**
   * Reason, and the rule.
   */
  message: string;
  /**
   * Advice for a fix.
   */
  hint: string | null;
}
