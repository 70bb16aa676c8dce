/**
 * Data of a page: the contract between `polhode-scenario`, which writes them, and the viewer.
 *
 * The page holds them as JSON in `<script id="polhode-data" type="application/json">`, with every
 * `<` written as `\u003c`. All quantities are in SI units and radians. Quaternions are (w, x, y, z)
 * and take components in body axes to components in space axes. Long rows of numbers are base64 of
 * little-endian numbers; in data of `polhode live`, rows of f64 are the numbers themselves.
 */
export interface PageData {
  version: 1;
  /** Title, such as "T-handle in free fall"; text, never markup. */
  title: string;
  /** Command that made the page: "polhode 0.1.0 simulate examples/t-handle.toml". */
  source: string;
  /** Text of the scenario file; null without one. */
  scenario: string | null;
  body: BodyData;
  motion: MotionData;
  /** Geometry of a free motion; null if the motion is not free. */
  free: FreeData | null;
  scene: SceneData;
  /** Geometry of a top: a body that gravity turns about a pivot; null for others. */
  top: TopData | null;
  /** Numbers to display: mass properties, regime, periods, accuracy. */
  facts: FactGroup[];
  findings: { severity: "info" | "warning"; message: string }[];
  /** Worked solution; empty without one. */
  explanation: ExplanationBlock[];
}

/** Base64 of little-endian f32 or u32. */
export type Base64 = string;

/** Base64 of little-endian f64, f32 or u32, or the numbers. */
export type Row = Base64 | Float64Array;
export type Row32 = Base64 | Float32Array;
export type Indices = Base64 | Uint32Array;

export interface BodyData {
  /** Mass, kg; null if only the moments are known. */
  mass: number | null;
  /** Inertia tensor about the point that the body turns about, body axes, kg·m². */
  inertia: [number[], number[], number[]];
  about: "centre of mass" | "pivot";
  /** Vector from that point to the centre of mass, body axes, m; zero for a free body. */
  lever: [number, number, number];
  principal: {
    /** Principal moments, ascending, kg·m². */
    moments: [number, number, number];
    /** Rotation from components along principal axes to components in body axes. */
    quaternion: [number, number, number, number];
  };
  /**
   * Uniform ellipsoid of the same mass and the same tensor about the centre of mass, centred there;
   * of 1 kg if the mass is null.
   */
  ellipsoid: EquivalentEllipsoid;
  /** Uniform box with the same mass and tensor; null if the mass is null. */
  box: EquivalentBox | null;
  /**
   * Shapes to display. Positions are relative to the point that the body turns about, in body axes.
   * If empty, the ellipsoid is shown.
   */
  shapes: Shape[];
}

export interface EquivalentEllipsoid {
  /** Semi-axes, m. */
  half: [number, number, number];
  /** Rotation from components along the semi-axes to components in body axes. */
  quaternion: [number, number, number, number];
}

export interface EquivalentBox {
  /** Edges, m. */
  size: [number, number, number];
  /** Rotation from components along the edges to components in body axes. */
  quaternion: [number, number, number, number];
}

export interface Placed {
  name: string;
  /** Position, m. */
  position: [number, number, number];
  /** Rotation from components along the shape's own axes to components in body axes. */
  quaternion: [number, number, number, number];
}

/**
 * A shape. The origin of a solid is its centre; cylinders, cones and capsules are along z; the tip
 * of a cone is at +z.
 */
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
        /** Coordinates x, y, z of each vertex, f32. */
        vertices: Row32;
        /** Indices of three vertices for each triangle, u32, counter-clockwise from outside. */
        triangles: Indices;
        /**
         * Number of triangles of the body; greater than the number here if the mesh was made
         * coarser.
         */
        of: number;
      }
    | {
        /** Balls: particles or atoms. */
        kind: "balls";
        /** Coordinates x, y, z of each centre, f32. */
        centers: Base64;
        /** Radii, f32, m. */
        radii: Base64;
        /** Colour of each ball, "#rrggbb". */
        colors: string[];
        labels: string[];
        /** Pairs of indices that sticks join. */
        sticks: [number, number][];
      }
  );

export interface MotionData {
  /** Number of samples n. */
  count: number;
  /** Method of computation: "exact", "dop853", … */
  method: string;
  /** Times, n × f64, s. */
  times: Row;
  /** Attitudes, 4 n × f64. */
  attitude: Row;
  /** Angular velocities, 3 n × f64, body axes, rad/s. */
  omega: Row;
  /** Angular momenta about the point that the body turns about, 3 n × f64, space axes, kg·m²/s. */
  momentum: Row;
  /** Torques, 3 n × f64, body axes, N·m; null without torque. */
  torque: Row | null;
  /** Kinetic energies, n × f64, J. */
  kinetic: Row;
  /** Potential energies, n × f64, J; null without a potential. */
  potential: Row | null;
  /**
   * Work of the torques, or of the motors of wheels, since the start, n × f64, J; null with a
   * potential and for a free body.
   */
  work: { name: string; values: Row } | null;
  /** Drifts of constants of the motion: lines of the drift plot, |value| relative, n × f64. */
  drift: { name: string; values: Row }[];
  /**
   * Wheels inside the body. `axis` is a unit vector, body axes. The rows are n × f64 along it:
   * angular momentum h, kg·m²/s; speed relative to the body, rad/s, null if the wheel is held;
   * torque of the motor on the wheel, N·m, null without a motor.
   */
  wheels: { name: string; axis: [number, number, number]; momentum: Row; speed: Row | null; motor: Row | null }[];
  /**
   * Angles between directions of the body and targets, n × f64, rad. `body`: direction, body axes,
   * a unit vector; `target`: index in `directions`; `limit`: largest angle that is allowed, rad.
   */
  pointings: { name: string; body: [number, number, number]; target: number; limit: number | null; values: Row }[];
  /**
   * Directions at a satellite, space axes: unit vectors, 3 n × f32, or one that is fixed. Names are
   * "nadir", "velocity", "B", "sun" and others.
   */
  directions: { name: string; fixed: [number, number, number] | null; values: Base64 | null }[];
  /** Events with time, s, and name; only the first ones if there are many. */
  events: { time: number; name: string }[];
  /** Number of all events. */
  eventCount: number;
  /**
   * Data of a body on the ground, whose centre of mass moves; null for other bodies, which turn
   * about the origin.
   */
  contact: ContactData | null;
  /**
   * False if the motion could not be computed to its end. Its last samples may then be far beyond
   * the others.
   */
  complete: boolean;
}

/** A body on the ground. Rows are f64; vectors are in space axes. */
export interface ContactData {
  ground: GroundData;
  /** Unit vector against gravity; null without gravity. */
  up: [number, number, number] | null;
  /** Surface that touches the ground, if the shapes do not show it; placed like these. */
  surface: Shape | null;
  /** Positions of the centre of mass, 3 n, m. */
  center: Row;
  /**
   * Contact points, 3 n, m; for a flying body, its lowest points. Relative to the centre of mass
   * and rotated back, they are points of the body.
   */
  point: Row;
  /** Normal forces, n, N. */
  normalForce: Row;
  /** Magnitudes of friction, n, N. */
  friction: Row;
  /** Speeds of the contact point of the body relative to the ground, n, m/s. */
  slip: Row;
  /** Work of friction since the start, n, J. */
  frictionWork: Row;
  /** Work that the ground has done by its own motion, n, J. */
  groundWork: Row;
  /** Successive phases, s: "rolling", "sliding" or "flying". */
  phases: { name: string; from: number; to: number }[];
}

/** The ground. Its centre, or a point of the plane, is the origin. */
export interface GroundData {
  form: "plane" | "sphere" | "cylinder";
  /** Radius, m; zero for a plane. */
  radius: number;
  /** True if the body is inside the ground surface. */
  inside: boolean;
  /** Axis, or for a plane the normal towards the body; a unit vector. */
  axis: [number, number, number];
  /** Rate of rotation of the ground about its axis, rad/s. */
  rate: number;
}

/** Reference directions for the path of a top's axis. */
export interface TopData {
  /** Unit vector from the pivot to the centre of mass, body axes. */
  axis: [number, number, number];
  /** Unit vector against gravity, space axes. */
  up: [number, number, number];
  /** Horizontal unit vectors at φ = 0 and φ = 90°. */
  across: [[number, number, number], [number, number, number]];
  /** Least and greatest inclination of a symmetric top, rad; null for others. */
  bounds: [number, number] | null;
}

/** Geometry of a free motion. Curves are f64, x y z of each point. */
export interface FreeData {
  regime: string;
  /** Period of ω in the body, s; null if there is none. */
  period: number | null;
  /** Magnitude |L|, kg·m²/s. */
  momentum: number;
  /** Kinetic energy T, J. */
  energy: number;
  /** ω along the polhode, body axes, rad/s; one period, closed. */
  polhode: Row;
  /** ω along the herpolhode, space axes, rad/s; some periods. */
  herpolhode: Row;
  /** Two separatrices on the unit sphere, principal axes. */
  separatrix: Row[];
  /** Other motions of the same body on the unit sphere, principal axes. */
  family: Row[];
  /** L/|L| of this motion on the unit sphere, principal axes; one period. */
  trace: Row;
  /**
   * Least and greatest angles, rad: between ω and ± the axis that L circles, and between ω and L.
   * `precession` is the sense of precession of a symmetric body; null for others.
   */
  cones: { body: [number, number]; space: [number, number]; precession: "prograde" | "retrograde" | null };
}

/** Data of the 3-D view other than the body. */
export interface SceneData {
  /**
   * Period that the eye follows: of the precession, or the longest one, s; null if nothing repeats.
   */
  period: number | null;
  /** Acceleration of gravity, space axes, m/s²; null if it exerts no torque on the body. */
  gravity: [number, number, number] | null;
  /** Orbit of a satellite; null without one. */
  orbit: OrbitData | null;
  /** Caption of each picture, one line. */
  captions: { body: string; poinsot: string | null; cones: string | null; sphere: string | null };
}

/**
 * A conic r = p/(1 + e · r̂) about the centre of attraction, space axes. r̂ is opposite to the nadir of
 * the directions.
 */
export interface OrbitData {
  /** Parameter p (semi-latus rectum), m. */
  parameter: number;
  /** Vector e to the periapsis, with the eccentricity as its length. */
  eccentricity: [number, number, number];
  /** Unit vector along r × v. */
  normal: [number, number, number];
  /** Radius of the central body, m; null if it is not known. */
  central: number | null;
}

export interface FactGroup {
  title: string;
  rows: { label: string; value: string; unit: string; note: string }[];
}

export type ExplanationBlock =
  | { kind: "heading"; level: 1 | 2 | 3; text: string }
  | { kind: "text"; text: string }
  /** Lines of a calculation; spaces may align columns. */
  | { kind: "lines"; lines: string[] }
  /** MathML made by polhode, and the same as plain text. */
  | { kind: "formula"; mathml: string; text: string }
  /** Graph as SVG made by polhode, with a description. */
  | { kind: "picture"; svg: string; text: string }
  | { kind: "table"; header: string[]; rows: string[][] };
