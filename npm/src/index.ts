/**
 * Mass properties and rotational motion of rigid bodies. All numbers are in SI units.
 *
 * Each function is pure: it reads only its arguments, and the same request has the same result. The
 * first call loads a WebAssembly module; computations run in the calling thread.
 */
import type { Files } from "./files.js";
import { refused } from "./error.js";
import { askFull, askSmall, withArrays } from "./module.js";
import type { Checked as ModelReport } from "./types/check-report.js";
import type { CheckRequest as CheckFields } from "./types/check-request.js";
import type { FreeMotionReport } from "./types/free-motion-report.js";
import type { FreeMotionRequest } from "./types/free-motion-request.js";
import type { Body } from "./types/inertia-report.js";
import type { InertiaRequest as InertiaFields } from "./types/inertia-request.js";
import type { SimulateReport } from "./types/simulate-report.js";
import type { SimulateRequest as SimulateFields } from "./types/simulate-request.js";

export { PolhodeError, type Failure } from "./error.js";
export type { Files } from "./files.js";
export type { Body, FreeMotionReport, FreeMotionRequest, ModelReport, SimulateReport };

/** Files of a request. */
interface Given {
  /** Contents of files by name. A file may refer only to files given here. */
  files?: Files;
}

/** Request for mass properties: files, or a shape such as `box`. */
export interface InertiaRequest extends Omit<InertiaFields, "files" | "write-mesh">, Given {
  /** Names of the files with bodies; by default all files. */
  inputs?: string[];
  /** Link of a robot, in its own frame. */
  link?: string;
  /** Links of a robot that are joined: groups held by fixed joints, or all. */
  lump?: "fixed" | "all";
  /** Link of a robot that is joined with all its descendants. */
  subtree?: string;
  /** Values of joints, rad or m or with a unit: `elbow=30 deg`; other joints are at zero. */
  joint?: string[];
}

/** Request of a check. */
export interface CheckRequest extends Omit<CheckFields, "files">, Given {
  files: Files;
  /** Names of models, and of folders to search for models; by default all models in `files`. */
  inputs?: string[];
}

/** Result of a check. */
export interface Checked {
  /** True if a finding is at least as severe as `fail-on`. */
  failed: boolean;
  /** Report on each model. */
  reports: ModelReport[];
  /** Remarks on the configuration and the baseline. */
  remarks: string[];
}

/** Scenario of a request. */
interface OfScenario extends Given {
  /** TOML text of the scenario; messages call it `scenario.toml`. */
  scenario: string;
}

/** Request for a motion. */
export interface SimulateRequest extends Omit<SimulateFields, "file" | "verbose">, OfScenario {}

/** Column of the table of a motion. */
export interface Column {
  /** Name with its unit: `omega_body_x_rad_s`. */
  name: string;
  /** Unit in SI symbols; `1` for a dimensionless number. */
  unit: string;
  /** Meaning of the numbers. */
  description: string;
}

/** Motion of a scenario. */
export interface Simulation {
  summary: SimulateReport;
  /** Columns in the order of the command's tables. */
  columns: Column[];
  /** Numbers of each column by its name, one for each sample. */
  channels: Record<string, Float64Array>;
}

/** Request for a worked solution. */
export type ExplainRequest = OfScenario;

/** Options of a worked solution. */
export interface ExplainOptions {
  /** Output format, by default `markdown`. `html` is a self-contained page. */
  format?: "markdown" | "html" | "latex" | "text";
}

/**
 * Computes mass, centre of mass, inertia tensor, principal moments and axes of bodies in files, or of
 * a shape.
 *
 * Returns a report for each body, in the order of the files.
 */
export async function inertia(request: InertiaRequest): Promise<Body[]> {
  const { files, inputs, ...rest } = of(request);
  const asked = { ...rest, files: inputs ?? Object.keys(files ?? {}) };
  return (await askFull("inertia", asked, files)).value as Body[];
}

/** Checks the inertias of robot models: URDF, SDF, MJCF and OpenSim. */
export async function check(request: CheckRequest): Promise<Checked> {
  const { files, inputs, ...rest } = of(request);
  const names = Object.keys(files ?? {});
  if (names.length === 0) throw refused("no model is given", 'write files: {"robot.urdf": text}');
  // The folder of all files is searched for models.
  const asked = { ...rest, files: inputs ?? (names.length > 1 ? [""] : names) };
  return (await askSmall("check", asked, files)).value as Checked;
}

/** Computes the torque-free motion of a body, in closed form, at any times. */
export async function freeMotion(request: FreeMotionRequest): Promise<FreeMotionReport> {
  return withArrays(await askSmall("free_motion", of(request))) as FreeMotionReport;
}

/** Computes the motion of a scenario: its summary, and the numbers of each sample. */
export async function simulate(request: SimulateRequest): Promise<Simulation> {
  const { files, ...rest } = scenario(request);
  const result = withArrays(await askFull("simulate", rest, files));
  const { summary, columns } = result as { summary: SimulateReport; columns: (Column & { values: Float64Array })[] };
  return {
    summary,
    columns: columns.map(({ name, unit, description }) => ({ name, unit, description })),
    channels: Object.fromEntries(columns.map(({ name, values }) => [name, values])),
  };
}

/** Writes the worked solution of a scenario, with every formula and number. */
export async function explain(request: ExplainRequest, options: ExplainOptions = {}): Promise<string> {
  const { files, ...rest } = scenario(request);
  return (await askFull("explain", { request: rest, ...of(options) }, files)).value as string;
}

/** Name of a scenario's file. */
const SCENARIO = "scenario.toml";

/** Returns a request with the scenario as a file. */
function scenario(request: OfScenario): { files: Files; file: string } {
  const { scenario: text, files, ...rest } = of(request);
  if (typeof text !== "string") throw refused("scenario must be the TOML text of a scenario", "write scenario: text");
  if ("file" in rest) throw refused("file is not a key of this request", "write scenario: the text of the file");
  if (files && SCENARIO in files) throw refused(`files[${JSON.stringify(SCENARIO)}] has the name of the scenario`, "give the file another name");
  return { ...rest, files: { ...files, [SCENARIO]: text }, file: SCENARIO };
}

/** Returns a request that is an object. */
function of<T>(request: T): T {
  if (Object.prototype.toString.call(request) === "[object Object]") return request;
  throw refused("the request must be an object", "write the keys of the request: {…}");
}
