/**
 * What a page shows: the contract between `polhode-scenario`, which writes it, and the viewer, which reads it.
 *
 * The page holds it as JSON in `<script id="polhode-data" type="application/json">`, every `<` written as `\u003c`. All is SI and
 * radians. Quaternions are (w, x, y, z) and take components in body axes to components in space axes. Long rows of numbers are base64
 * of little-endian numbers; what comes from `polhode live` has those of f64 as the numbers themselves.
 */
export interface PageData {
  version: 1;
  /** "T-handle in free fall"; text, never markup. */
  title: string;
  /** What made it: "polhode 0.1.0 simulate examples/t-handle.toml". */
  source: string;
  /** The scenario file as it was read; null without one. */
  scenario: string | null;
  body: BodyData;
  motion: MotionData;
  /** Null if the motion is not free. */
  free: FreeData | null;
  scene: SceneData;
  /** Of a body that gravity turns about a pivot; null of others. */
  top: TopData | null;
  /** Numbers beside the picture, ready to read: mass properties, regime, periods, evidence. */
  facts: FactGroup[];
  findings: { severity: "info" | "warning"; message: string }[];
  /** The worked solution; empty without one. */
  explanation: ExplanationBlock[];
}

/** Base64 of little-endian f32 or u32. */
export type Base64 = string;

/** Base64 of little-endian f64, f32 or u32, or the numbers. */
export type Row = Base64 | Float64Array;
export type Row32 = Base64 | Float32Array;
export type Indices = Base64 | Uint32Array;

export interface BodyData {
  /** kg; null if only the moments are known. */
  mass: number | null;
  /** Tensor about the point that the body turns about, body axes, kg·m². */
  inertia: [number[], number[], number[]];
  about: "centre of mass" | "pivot";
  /** From that point to the centre of mass, body axes, m; zero for a free body. */
  lever: [number, number, number];
  principal: {
    /** Ascending, kg·m². */
    moments: [number, number, number];
    /** Takes components along principal axes to components in body axes. */
    quaternion: [number, number, number, number];
  };
  /** The uniform ellipsoid of the same mass and of the same tensor about the centre of mass, where its middle is; of 1 kg if the mass is null. */
  ellipsoid: EquivalentEllipsoid;
  /** The uniform box of these; null if the mass is null. */
  box: EquivalentBox | null;
  /** What it looks like; places are from the point that the body turns about, in body axes. Empty: show the ellipsoid. */
  shapes: Shape[];
}

export interface EquivalentEllipsoid {
  /** Semi-axes, m. */
  half: [number, number, number];
  /** Takes components along them to components in body axes. */
  quaternion: [number, number, number, number];
}

export interface EquivalentBox {
  /** Edges, m. */
  size: [number, number, number];
  /** Takes components along the edges to components in body axes. */
  quaternion: [number, number, number, number];
}

export interface Placed {
  name: string;
  /** m */
  position: [number, number, number];
  /** Takes components along the shape's own axes to components in body axes. */
  quaternion: [number, number, number, number];
}

/** The origin of a solid is its middle; cylinders, cones and capsules lie along z; a cone's tip is at +z. */
export type Shape = Placed &
  (
    | { kind: "box"; size: [number, number, number] }
    | { kind: "ellipsoid"; half: [number, number, number] }
    | { kind: "cylinder"; radius: number; inner: number; height: number }
    | { kind: "cone"; bottom: number; top: number; height: number }
    | { kind: "capsule"; radius: number; height: number }
    | { kind: "torus"; radius: number; tube: number }
    | {
        kind: "mesh";
        /** f32, x y z of each vertex. */
        vertices: Row32;
        /** u32, three for each triangle, counter-clockwise from outside. */
        triangles: Indices;
        /** How many triangles the body has; more than are here if it was made coarser for the page. */
        of: number;
      }
    | {
        /** Balls: particles, atoms. */
        kind: "balls";
        /** f32, x y z of each. */
        centers: Base64;
        /** f32, m. */
        radii: Base64;
        /** One for each, "#rrggbb". */
        colors: string[];
        labels: string[];
        /** Pairs of indices that a stick joins. */
        sticks: [number, number][];
      }
  );

export interface MotionData {
  /** How many samples: n. */
  count: number;
  /** How it was computed: "exact", "dop853", … */
  method: string;
  /** f64, n, s. */
  times: Row;
  /** f64, 4 n. */
  attitude: Row;
  /** f64, 3 n, body axes, rad/s. */
  omega: Row;
  /** f64, 3 n, space axes, kg·m²/s, about the point that the body turns about. */
  momentum: Row;
  /** f64, 3 n, body axes, N·m; null without torque. */
  torque: Row | null;
  /** f64, n, J. */
  kinetic: Row;
  /** f64, n, J; null without a potential. */
  potential: Row | null;
  /** What the torques, or the motors of wheels, have done since the start: f64, n, J; null with a potential and for a free body. */
  work: { name: string; values: Row } | null;
  /** What should stay the same, and how much it moves: lines of the drift plot, |value| relative, f64, n. */
  drift: { name: string; values: Row }[];
  /**
   * Wheels inside the body. Axis: a unit vector, body axes. Along it, f64, n: the angular momentum h, kg·m²/s; the speed relative to the
   * body, rad/s, null where it is held; the motor's torque on the wheel, N·m, null without a motor.
   */
  wheels: { name: string; axis: [number, number, number]; momentum: Row; speed: Row | null; motor: Row | null }[];
  /** Angles from directions of the body to others: f64, n, rad. */
  pointings: { name: string; values: Row }[];
  /** What happened on the way, the first of it: t, s, and its name. */
  events: { time: number; name: string }[];
  /** How much happened in all. */
  eventCount: number;
  /** Of a body on the ground, whose centre of mass moves; null of any other, which turns about the origin. */
  contact: ContactData | null;
  /** False if the motion could not be computed to its end; its last samples may then be far beyond all others. */
  complete: boolean;
}

/** A body on the ground. Rows are f64; vectors are along the axes of space. */
export interface ContactData {
  ground: GroundData;
  /** Against gravity, a unit vector; null without gravity. */
  up: [number, number, number] | null;
  /** With what the body touches the ground, if its shapes do not show that; placed as they are. */
  surface: Shape | null;
  /** The centre of mass: 3 n, m. */
  center: Row;
  /** The point of contact; of what flies the lowest: 3 n, m. From the centre of mass and turned back it is the point in the body. */
  point: Row;
  /** n, N. */
  normalForce: Row;
  /** Its size: n, N. */
  friction: Row;
  /** The speed of the body's point of contact over the ground: n, m/s. */
  slip: Row;
  /** The work of friction since the start: n, J. */
  frictionWork: Row;
  /** The work that the ground has done by its own motion: n, J. */
  groundWork: Row;
  /** One after the other, s; "rolling", "sliding" or "flying". */
  phases: { name: string; from: number; to: number }[];
}

/** Its centre, or a point of the plane, is the origin. */
export interface GroundData {
  form: "plane" | "sphere" | "cylinder";
  /** m; zero of a plane. */
  radius: number;
  /** The body is in it. */
  inside: boolean;
  /** Of a plane the normal, towards the body; a unit vector. */
  axis: [number, number, number];
  /** At which it turns about its axis, rad/s. */
  rate: number;
}

/** What the path of a top's axis is measured from. */
export interface TopData {
  /** From the pivot to the centre of mass, a unit vector in body axes. */
  axis: [number, number, number];
  /** Against gravity, a unit vector in space axes. */
  up: [number, number, number];
  /** Across it, those of φ = 0 and φ = 90°. */
  across: [[number, number, number], [number, number, number]];
  /** The least and the greatest angle from the vertical of a symmetric top, rad; null of others. */
  bounds: [number, number] | null;
}

/** The geometry of a free motion. Curves are f64, x y z of each point. */
export interface FreeData {
  regime: string;
  /** Of ω in the body, s; null if it has none. */
  period: number | null;
  /** |L|, kg·m²/s. */
  momentum: number;
  /** T, J. */
  energy: number;
  /** ω along the polhode, body axes, rad/s; one period, closed. */
  polhode: Row;
  /** ω along the herpolhode, space axes, rad/s; some periods. */
  herpolhode: Row;
  /** On the unit sphere, principal axes: the two separatrices. */
  separatrix: Row[];
  /** On the unit sphere, principal axes: other motions of this body. */
  family: Row[];
  /** On the unit sphere, principal axes: this motion's L/|L|, one period. */
  trace: Row;
  /**
   * Least and greatest angles, rad: of ω from ± the axis that L circles, and of ω from L. The sense of the precession of a symmetric
   * body; null for any other.
   */
  cones: { body: [number, number]; space: [number, number]; precession: "prograde" | "retrograde" | null };
}

/** What the 3-D view shows besides the body. */
export interface SceneData {
  /** s: of the precession, or of the slowest of the periods, that the eye is to follow; null where nothing repeats. */
  period: number | null;
  /** Acceleration of gravity, space axes, m/s²; null if it does not turn the body. */
  gravity: [number, number, number] | null;
  /** A line on each picture. */
  captions: { body: string; poinsot: string | null; cones: string | null; sphere: string | null };
}

export interface FactGroup {
  title: string;
  rows: { label: string; value: string; unit: string; note: string }[];
}

export type ExplanationBlock =
  | { kind: "heading"; level: 1 | 2 | 3; text: string }
  | { kind: "text"; text: string }
  /** Lines of working, one below the other; columns may be lined up with spaces. */
  | { kind: "lines"; lines: string[] }
  /** MathML made by polhode, and the same as plain text. */
  | { kind: "formula"; mathml: string; text: string }
  /** A graph, as SVG made by polhode, and what it shows. */
  | { kind: "picture"; svg: string; text: string }
  | { kind: "table"; header: string[]; rows: string[][] };
