/* Types of crates/polhode-npm/schema/free-motion/request.json, written by viewer/types.mjs; do not edit. */

/**
 * Body whose torque-free motion is requested, and the times of its states.
 */
export interface FreeMotionRequest {
  /**
   * Moments of inertia about the centre of mass along the body's x, y and z axes, which are principal, kg·m².
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Moment of inertia, kg·m².
   */
  moments: [number, number, number];
  /**
   * Angular velocity relative to space at time 0, body axes, rad/s.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Component of the angular velocity, rad/s.
   */
  omega: [number, number, number];
  /**
   * Attitude at time 0: unit quaternion (w, x, y, z) that rotates body components to space components; by default the identity.
   *
   * @minItems 4
   * @maxItems 4
   *
   * Items: Component of the quaternion, dimensionless.
   */
  attitude?: [number, number, number, number];
  /**
   * Times of the states, s, in any order; negative times are before the start.
   */
  times: ArrayLike<number>;
}
