/* Types of crates/polhode-npm/schema/free-motion/report.json, written by viewer/types.mjs; do not edit. */

/**
 * Torque-free motion. Arrays have one row after the other, a row for each time.
 */
export interface FreeMotionReport {
  /**
   * Version of polhode.
   */
  polhode: string;
  /**
   * Kind of motion.
   */
  regime: "at_rest" | "permanent" | "symmetric" | "long_axis" | "short_axis" | "separatrix";
  /**
   * Period of ω in the body, s; null if ω is constant or not periodic.
   */
  period_s: number | null;
  /**
   * Time between reversals of ω along the intermediate axis, s; null if there are none.
   */
  flip_interval_s: number | null;
  /**
   * Growth rate of a deviation from rotation about the intermediate axis, 1/s; null unless ω is near that axis.
   */
  growth_rate_per_s: number | null;
  /**
   * Mean rate of precession about the angular momentum, rad/s; null at rest.
   */
  precession_rate_rad_s: number | null;
  /**
   * Smallest and largest angle between the precessing axis and the angular momentum, rad.
   *
   * @minItems 2
   * @maxItems 2
   *
   * Items: Angle, rad; null at rest.
   */
  nutation_range_rad: [number | null, number | null];
  /**
   * Rotational kinetic energy, J.
   */
  kinetic_energy_j: number;
  /**
   * Magnitude of the angular momentum, kg·m²/s.
   */
  momentum_kg_m2_s: number;
  /**
   * Angular momentum, space axes, kg·m²/s.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Component of the angular momentum, kg·m²/s.
   */
  momentum_space_kg_m2_s: [number, number, number];
  /**
   * Times of the request, s.
   */
  times_s: Float64Array;
  /**
   * Angular velocity relative to space, body axes, rad/s: three numbers for each time.
   */
  omega_body_rad_s: Float64Array;
  /**
   * Attitude as unit quaternions (w, x, y, z), continuous in the order of the times: four numbers for each time.
   */
  attitude_wxyz: Float64Array;
}
