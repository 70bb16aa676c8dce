/* Types of crates/polhode-scenario/schema/simulate/report.json, written by viewer/types.mjs; do not edit. */

/**
 * Centre of mass, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector = [number | null, number | null, number | null];
/**
 * Inertia tensor about the centre of mass, body axes, kg·m².
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * Principal moments, ascending, kg·m².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector1 = [number | null, number | null, number | null];
/**
 * Axis, dimensionless.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector2 = [number | null, number | null, number | null];
/**
 * Rotation from principal axes to body axes, scalar first.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion = [number | null, number | null, number | null, number | null];
/**
 * Radii of gyration about the principal axes through the centre of mass, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector3 = [number | null, number | null, number | null];
/**
 * Reference point, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector4 = [number | null, number | null, number | null];
/**
 * Inertia tensor about the point, body axes, kg·m².
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix1 = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * Position relative to the central body at t = 0, space axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector5 = [number | null, number | null, number | null];
/**
 * Velocity relative to the central body at t = 0, space axes, m/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector6 = [number | null, number | null, number | null];
/**
 * Attitude R_space_body, scalar first, with w ≥ 0.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion1 = [number | null, number | null, number | null, number | null];
/**
 * Quaternion, scalar first, with w ≥ 0.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion2 = [number | null, number | null, number | null, number | null];
/**
 * The same quaternion, scalar last.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion3 = [number | null, number | null, number | null, number | null];
/**
 * Euler angles φ, θ, ψ about z, x, z, rad.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector7 = [number | null, number | null, number | null];
/**
 * Roll, pitch and yaw (φ, θ, ψ of the sequence 3-2-1), rad.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector8 = [number | null, number | null, number | null];
/**
 * Modified Rodrigues parameters, dimensionless.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector9 = [number | null, number | null, number | null];
/**
 * Rotation matrix, dimensionless.
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix2 = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * Roll, pitch and yaw relative to the orbit's axes, rad; absent without an orbit.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector10 = [number | null, number | null, number | null];
/**
 * ω relative to space, body axes, rad/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector11 = [number | null, number | null, number | null];
/**
 * ω relative to space, space axes, rad/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector12 = [number | null, number | null, number | null];
/**
 * Angular momentum L about the reference point, space axes, kg·m²/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector13 = [number | null, number | null, number | null];
/**
 * Velocity of the centre of mass, space axes, m/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector14 = [number | null, number | null, number | null];
/**
 * L at the start, space axes, kg·m²/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector15 = [number | null, number | null, number | null];
/**
 * Symmetry axis e, unit vector in body axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector16 = [number | null, number | null, number | null];
/**
 * Torque N at the start, body axes, N·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector17 = [number | null, number | null, number | null];
/**
 * Torque N at the start, space axes, N·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector18 = [number | null, number | null, number | null];
/**
 * Torque N, body axes, N·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector19 = [number | null, number | null, number | null];
/**
 * Force F = m a, body axes, N.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector20 = [number | null, number | null, number | null];
/**
 * Part of F along the arm from the reference point, body axes, N.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector21 = [number | null, number | null, number | null];
/**
 * Part of F across the arm, body axes, N.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector22 = [number | null, number | null, number | null];
/**
 * Torque r × F about the reference point, body axes, N·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector23 = [number | null, number | null, number | null];
/**
 * Attitude R_space_body, scalar first, with w ≥ 0.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion4 = [number | null, number | null, number | null, number | null];
/**
 * ω relative to space, body axes, rad/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector24 = [number | null, number | null, number | null];
/**
 * ω relative to space, space axes, rad/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector25 = [number | null, number | null, number | null];
/**
 * Angular momentum L about the reference point, space axes, kg·m²/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector26 = [number | null, number | null, number | null];
/**
 * Torque N about the reference point, body axes, N·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector27 = [number | null, number | null, number | null];
/**
 * Direction, unit vector in body axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector28 = [number | null, number | null, number | null];
/**
 * Direction, unit vector in space axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector29 = [number | null, number | null, number | null];
/**
 * Torque of the scenario, with the numbers of its model.
 */
export type Torque =
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "constant";
      /**
       * Axes that the components refer to.
       */
      axes: "body" | "space";
      torque_n_m: Vector30;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "gravity";
      /**
       * Axes that the components refer to.
       */
      axes: "space";
      acceleration_m_s2: Vector31;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "thruster";
      force_n: Vector32;
      position_m: Vector33;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "energy_sink";
      /**
       * Coefficient α of internal friction, 1/(N·m·s).
       */
      coefficient_per_n_m_s: number;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "torsion";
      /**
       * Stiffness, N·m/rad.
       */
      stiffness_n_m_per_rad: number;
      axis_space?: Vector34;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "drag";
      linear_n_m_s: Matrix3;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "drag";
      quadratic_n_m_s2: Matrix4;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "magnetic";
      moment_a_m2: Vector35;
      /**
       * Kind of field.
       */
      field: "uniform";
      field_t: Vector36;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "magnetic";
      moment_a_m2: Vector37;
      /**
       * Kind of field.
       */
      field: "dipole";
      dipole_a_m2: Vector38;
      /**
       * Gravitational parameter µ of the central body, m³/s².
       */
      orbit_mu_m3_s2: number;
      /**
       * Least distance from the central body, m.
       */
      orbit_periapsis_m: number;
      /**
       * Eccentricity, dimensionless.
       */
      orbit_eccentricity: number;
      /**
       * Period, s; absent for an open orbit.
       */
      orbit_period_s?: number;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "gravity_gradient";
      /**
       * Mass that is attracted: the inertia tensor or the points.
       */
      mass: "tensor" | "points";
      /**
       * Gravitational parameter µ of the central body, m³/s².
       */
      orbit_mu_m3_s2: number;
      /**
       * Least distance from the central body, m.
       */
      orbit_periapsis_m: number;
      /**
       * Eccentricity, dimensionless.
       */
      orbit_eccentricity: number;
      /**
       * Period, s; absent for an open orbit.
       */
      orbit_period_s?: number;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "formula";
      /**
       * Axes that the components refer to.
       */
      axes: "body" | "space";
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Name of the model in scenario files.
       */
      model: "table";
      /**
       * Axes that the components refer to.
       */
      axes: "body" | "space";
      /**
       * Interpolation between rows.
       */
      interpolation: "steps" | "linear" | "spline";
      /**
       * Time of the first row, s.
       */
      first_row_s: number;
      /**
       * Time of the last row, s.
       */
      last_row_s: number;
      /**
       * Greatest magnitude of the rows, N·m.
       */
      greatest_n_m: number;
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    }
  | {
      /**
       * Function of Python.
       */
      model: "function";
      schedule: Schedule;
      /**
       * Name of the torque.
       */
      name: string | null;
      /**
       * True if the torque acts from the start.
       */
      on: boolean;
    };
/**
 * Torque along these axes, N·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector30 = [number | null, number | null, number | null];
/**
 * Times at which it acts; null is always.
 */
export type Schedule =
  | null
  | {
      /**
       * Begin, s; null is from the start.
       */
      from_s: number | null;
      /**
       * End, s; null is without end.
       */
      until_s: number | null;
    }
  | {
      /**
       * Begin of the first pulse, s.
       */
      first_s: number;
      /**
       * Duration of a pulse, s.
       */
      width_s: number;
      /**
       * Time from pulse to pulse, s.
       */
      period_s: number;
      /**
       * Number of pulses; null is without end.
       */
      count: number | null;
    };
/**
 * Gravitational acceleration g, space axes, m/s².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector31 = [number | null, number | null, number | null];
/**
 * Force, body axes, N.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector32 = [number | null, number | null, number | null];
/**
 * Point of application, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector33 = [number | null, number | null, number | null];
/**
 * Direction of the wire, unit vector in space axes; absent for a spring in all directions.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector34 = [number | null, number | null, number | null];
/**
 * Matrix C of the torque −C ω, body axes, N·m·s.
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix3 = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * Matrix D of the torque −|ω| D ω, body axes, N·m·s².
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix4 = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * Magnetic moment, body axes, A·m².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector35 = [number | null, number | null, number | null];
/**
 * Field B, space axes, T.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector36 = [number | null, number | null, number | null];
/**
 * Magnetic moment, body axes, A·m².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector37 = [number | null, number | null, number | null];
/**
 * Moment of the dipole, space axes, A·m².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector38 = [number | null, number | null, number | null];
/**
 * Axis, unit vector in body axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector39 = [number | null, number | null, number | null];
/**
 * Centre of mass, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector40 = [number | null, number | null, number | null];
/**
 * Inertia tensor about the centre of mass, body axes, off-diagonal −∫xy dm, kg·m².
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix5 = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * Body on the ground; null for any other.
 */
export type Contact = {
  /**
   * Surface of the body.
   */
  surface:
    | {
        /**
         * Shape.
         */
        shape: "sphere";
        /**
         * Radius, m.
         */
        radius_m: number;
        center_body_m: Vector41;
        axes_in_body_wxyz: Quaternion5;
      }
    | {
        /**
         * Shape.
         */
        shape: "ellipsoid";
        semi_axes_m: Vector42;
        center_body_m: Vector43;
        axes_in_body_wxyz: Quaternion6;
      }
    | {
        /**
         * Shape.
         */
        shape: "rim";
        /**
         * Radius of the circle, m.
         */
        radius_m: number;
        /**
         * Radius of the tube, m; 0 is a sharp edge.
         */
        tube_m: number;
        /**
         * Thickness, m.
         */
        thickness_m: number;
        center_body_m: Vector44;
        axes_in_body_wxyz: Quaternion7;
      }
    | {
        /**
         * Shape.
         */
        shape: "cylinder";
        /**
         * Radius, m.
         */
        radius_m: number;
        /**
         * Length, m; null is without ends.
         */
        length_m: number | null;
        center_body_m: Vector45;
        axes_in_body_wxyz: Quaternion8;
      };
  /**
   * Ground.
   */
  ground:
    | {
        /**
         * Shape.
         */
        shape: "plane";
        axis: Vector46;
        /**
         * Rotation rate of the ground about this axis, rad/s.
         */
        rate_rad_s: number;
      }
    | {
        /**
         * Shape.
         */
        shape: "sphere";
        /**
         * Radius, m.
         */
        radius_m: number;
        /**
         * Side that is touched.
         */
        side: "inside" | "outside";
        axis: Vector47;
        /**
         * Rotation rate of the ground about this axis, rad/s.
         */
        rate_rad_s: number;
      }
    | {
        /**
         * Shape.
         */
        shape: "cylinder";
        /**
         * Radius, m.
         */
        radius_m: number;
        /**
         * Side that is touched.
         */
        side: "inside" | "outside";
        axis: Vector48;
        /**
         * Rotation rate of the ground about this axis, rad/s.
         */
        rate_rad_s: number;
      };
  /**
   * Law of friction.
   */
  law:
    | {
        /**
         * Rolling without slip.
         */
        name: "rolling";
        /**
         * Lever of rolling friction, m.
         */
        rolling_friction_m: number;
        /**
         * Lever of pivoting friction, m.
         */
        pivoting_friction_m: number;
      }
    | {
        /**
         * Sliding with or without friction.
         */
        name: "friction" | "frictionless";
        /**
         * Coefficient of kinetic friction, dimensionless.
         */
        friction: number;
        /**
         * Coefficient of static friction, dimensionless.
         */
        static_friction: number;
        /**
         * Coefficient of viscous friction, N·s/m.
         */
        viscous_n_s_m: number;
        /**
         * Lever of rolling friction, m.
         */
        rolling_friction_m: number;
        /**
         * Lever of pivoting friction, m.
         */
        pivoting_friction_m: number;
      };
  gravity_m_s2: Vector49;
  /**
   * Changes of the contact.
   */
  changes: {
    /**
     * Time, s.
     */
    time_s: number;
    /**
     * Kind of change.
     */
    change:
      | "slips"
      | "grips"
      | "slips again"
      | "lifts off"
      | "lands"
      | "pivoting stops"
      | "pivots"
      | "rolling stops"
      | "other rim"
      | "lies flat"
      | "tips over"
      | "osculates";
    /**
     * The change in words.
     */
    what: string;
  }[];
  /**
   * Largest change of T + U minus the works of friction and of the ground (relative).
   */
  energy_drift: number | null;
  start: ContactState;
  /**
   * State at the last sample.
   */
  final: ContactState | null;
} | null;
/**
 * Centre of the surface, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector41 = [number | null, number | null, number | null];
/**
 * Rotation from the surface's axes to body axes, scalar first.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion5 = [number | null, number | null, number | null, number | null];
/**
 * Semi-axes along the surface's axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector42 = [number | null, number | null, number | null];
/**
 * Centre of the surface, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector43 = [number | null, number | null, number | null];
/**
 * Rotation from the surface's axes to body axes, scalar first.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion6 = [number | null, number | null, number | null, number | null];
/**
 * Centre of the surface, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector44 = [number | null, number | null, number | null];
/**
 * Rotation from the surface's axes to body axes, scalar first.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion7 = [number | null, number | null, number | null, number | null];
/**
 * Centre of the surface, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector45 = [number | null, number | null, number | null];
/**
 * Rotation from the surface's axes to body axes, scalar first.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion8 = [number | null, number | null, number | null, number | null];
/**
 * Normal, unit vector in space axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector46 = [number | null, number | null, number | null];
/**
 * Axis of its rotation, unit vector in space axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector47 = [number | null, number | null, number | null];
/**
 * Axis, unit vector in space axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector48 = [number | null, number | null, number | null];
/**
 * Gravitational acceleration g, space axes, m/s².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector49 = [number | null, number | null, number | null];
/**
 * Centre of mass, space axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector50 = [number | null, number | null, number | null];
/**
 * Velocity of the centre of mass, space axes, m/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector51 = [number | null, number | null, number | null];
/**
 * Point of contact, or the lowest point in flight, space axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector52 = [number | null, number | null, number | null];
/**
 * The same point, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector53 = [number | null, number | null, number | null];
/**
 * Velocity of the body's point of contact relative to the ground, space axes, m/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector54 = [number | null, number | null, number | null];
/**
 * Force of friction, space axes, N.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector55 = [number | null, number | null, number | null];
/**
 * Rotor in gimbals; null for any other.
 */
export type Gimbals = {
  base_rate_rad_s: Vector56;
  gravity_m_s2: Vector57;
  outer_axis: Vector58;
  inner_axis: Vector59;
  rotor_axis_body: Vector60;
  crossing_body_m: Vector61;
  outer_gimbal: Gimbal;
  inner_gimbal: Gimbal;
  /**
   * Outer, inner and rotor axis.
   *
   * @minItems 3
   * @maxItems 3
   */
  axes: [
    {
      /**
       * How the axis is held.
       */
      hold: "free" | "locked" | "driven";
      /**
       * Angle at the start, rad.
       */
      angle_rad: number;
      /**
       * Rate of the angle at the start, rad/s.
       */
      rate_rad_s: number;
      /**
       * Damping, N·m·s/rad.
       */
      damping_n_m_s: number;
      /**
       * Stiffness of the spring, N·m/rad; null without a spring.
       */
      spring_n_m: number | null;
      /**
       * Angle at which the spring is slack, rad; null without a spring.
       */
      spring_rest_rad: number | null;
      /**
       * Constant torque about the axis, N·m.
       */
      torque_n_m: number;
    },
    {
      /**
       * How the axis is held.
       */
      hold: "free" | "locked" | "driven";
      /**
       * Angle at the start, rad.
       */
      angle_rad: number;
      /**
       * Rate of the angle at the start, rad/s.
       */
      rate_rad_s: number;
      /**
       * Damping, N·m·s/rad.
       */
      damping_n_m_s: number;
      /**
       * Stiffness of the spring, N·m/rad; null without a spring.
       */
      spring_n_m: number | null;
      /**
       * Angle at which the spring is slack, rad; null without a spring.
       */
      spring_rest_rad: number | null;
      /**
       * Constant torque about the axis, N·m.
       */
      torque_n_m: number;
    },
    {
      /**
       * How the axis is held.
       */
      hold: "free" | "locked" | "driven";
      /**
       * Angle at the start, rad.
       */
      angle_rad: number;
      /**
       * Rate of the angle at the start, rad/s.
       */
      rate_rad_s: number;
      /**
       * Damping, N·m·s/rad.
       */
      damping_n_m_s: number;
      /**
       * Stiffness of the spring, N·m/rad; null without a spring.
       */
      spring_n_m: number | null;
      /**
       * Angle at which the spring is slack, rad; null without a spring.
       */
      spring_rest_rad: number | null;
      /**
       * Constant torque about the axis, N·m.
       */
      torque_n_m: number;
    }
  ];
  /**
   * Largest change of T + U minus the works of axes and base (relative).
   */
  energy_drift: number | null;
  start: GimbalState;
  /**
   * State at the last sample.
   */
  final: GimbalState | null;
} | null;
/**
 * ω of the base relative to space, axes of the base, rad/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector56 = [number | null, number | null, number | null];
/**
 * Gravitational acceleration g, axes of the base, m/s².
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector57 = [number | null, number | null, number | null];
/**
 * Outer axis, unit vector in axes of the base.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector58 = [number | null, number | null, number | null];
/**
 * Inner axis with all angles zero, unit vector in axes of the base.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector59 = [number | null, number | null, number | null];
/**
 * Rotor axis, unit vector in body axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector60 = [number | null, number | null, number | null];
/**
 * Crossing of the axes, body axes, m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector61 = [number | null, number | null, number | null];
/**
 * Inertia tensor about the crossing, axes of the base with all angles zero, kg·m².
 *
 * @minItems 3
 * @maxItems 3
 */
export type Matrix6 = [
  [number | null, number | null, number | null],
  [number | null, number | null, number | null],
  [number | null, number | null, number | null]
];
/**
 * First moment m c from the crossing, axes of the base with all angles zero, kg·m.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector62 = [number | null, number | null, number | null];
/**
 * Angular momentum of rotor and gimbals about the crossing, space axes, kg·m²/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector63 = [number | null, number | null, number | null];
/**
 * Direction, unit vector in these axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector64 = [number | null, number | null, number | null];
/**
 * Direction, unit vector in body axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector65 = [number | null, number | null, number | null];
/**
 * Direction, unit vector in space axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector66 = [number | null, number | null, number | null];
/**
 * Direction, unit vector in body axes.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector67 = [number | null, number | null, number | null];
/**
 * Attitude R_space_body, scalar first, with w ≥ 0.
 *
 * @minItems 4
 * @maxItems 4
 *
 * Items: Component, dimensionless; null if it is not finite.
 */
export type Quaternion9 = [number | null, number | null, number | null, number | null];
/**
 * ω relative to space, body axes, rad/s.
 *
 * @minItems 3
 * @maxItems 3
 *
 * Items: Component, in the unit of the vector; null if it is not finite.
 */
export type Vector68 = [number | null, number | null, number | null];

/**
 * Motion of a scenario, as --json prints it and summary.json has it. SI units; null is what does not exist or is not finite. Moments, L and T are about the reference point of turns_about.
 */
export interface SimulateReport {
  /**
   * Version of polhode.
   */
  polhode: string;
  /**
   * Title of the scenario.
   */
  title: string | null;
  source: Source;
  /**
   * Mass, kg.
   */
  mass: number;
  /**
   * Sum of the volumes of the parts, m³.
   */
  volume: number | null;
  /**
   * Surface area of the only part, m².
   */
  surface_area: number | null;
  /**
   * Mass per volume, kg/m³.
   */
  density: number | null;
  center_of_mass: Vector;
  /**
   * Inertia tensor.
   */
  inertia: {
    /**
     * Reference point.
     */
    about: "center_of_mass";
    /**
     * Axes.
     */
    axes: "body";
    /**
     * Sign of off-diagonal elements: −∫xy dm.
     */
    products: "negative_integral";
    tensor: Matrix;
  };
  principal: Principal;
  gyration_radii: Vector3;
  /**
   * False if the computation could not go on to the end of the run.
   */
  complete: boolean;
  /**
   * End of the motion.
   */
  end: {
    /**
     * Time of the last sample, s.
     */
    time_s: number | null;
    /**
     * Reason.
     */
    reason: "end_of_run" | "event" | "contact" | "failure";
    /**
     * Name of the event that stopped the motion.
     */
    event: string | null;
    /**
     * Cause of a failure, or the change of the contact.
     */
    cause: string | null;
  };
  /**
   * Reference point at the first sample.
   */
  turns_about: {
    /**
     * Reference point.
     */
    what: "center_of_mass" | "pivot";
    point: Vector4;
    tensor: Matrix1;
    principal: Principal1;
  };
  /**
   * Orbit of the body.
   */
  orbit: {
    /**
     * Gravitational parameter µ of the central body, m³/s².
     */
    mu_m3_s2: number;
    /**
     * Eccentricity, dimensionless.
     */
    eccentricity: number;
    /**
     * Least distance from the central body, m.
     */
    periapsis_m: number;
    /**
     * Period, s; null for an open orbit.
     */
    period_s: number | null;
    /**
     * Mean motion, rad/s; null for an open orbit.
     */
    mean_motion_rad_s: number | null;
    start_position_m: Vector5;
    start_velocity_m_s: Vector6;
  } | null;
  /**
   * State at the start.
   */
  start: {
    /**
     * Time t, s.
     */
    time_s: number;
    attitude_wxyz: Quaternion1;
    attitude: Attitude;
    omega_body: Vector11;
    omega_space: Vector12;
    momentum_space: Vector13;
    velocity_space: Vector14;
  };
  /**
   * How the motion was computed.
   */
  run: {
    /**
     * Method of the scenario.
     */
    method: "auto" | "exact" | "taylor" | "dop853" | "splitting" | null;
    /**
     * Solver that ran.
     */
    method_used: "exact" | "taylor" | "dop853" | "splitting" | "prescribed" | "collocation" | "collocation+taylor";
    /**
     * Reason for the solver.
     */
    method_reason: string;
    /**
     * Bound on the error of each step: attitude in rad, ω relative; null if it sets no steps.
     */
    tolerance: number | null;
    /**
     * Steps of splitting.
     */
    splitting: {
      /**
       * Order of accuracy.
       */
      order: number;
      /**
       * Length of a step, s.
       */
      step_s: number;
    } | null;
    /**
     * Number of samples.
     */
    samples: number;
    /**
     * Time from the first to the last sample, s.
     */
    duration_s: number;
    /**
     * Cost of an integration.
     */
    steps: {
      /**
       * Number of accepted steps.
       */
      accepted: number;
      /**
       * Number of rejected steps.
       */
      rejected: number;
      /**
       * Number of evaluations of the equations.
       */
      evaluations: number;
    } | null;
  };
  /**
   * Kind of motion; null where only a free motion has a value.
   */
  motion: {
    /**
     * Kind of a free motion.
     */
    regime: "at_rest" | "permanent" | "symmetric" | "long_axis" | "short_axis" | "separatrix" | null;
    /**
     * Kind of the motion that the start would have without torque.
     */
    regime_at_start: "at_rest" | "permanent" | "symmetric" | "long_axis" | "short_axis" | "separatrix" | null;
    /**
     * Period of ω in the body, s.
     */
    period_s: number | null;
    /**
     * Mean period of the axis that L circles about L, s.
     */
    precession_period_s: number | null;
    /**
     * Period of the rotation about this axis, s.
     */
    rotation_period_s: number | null;
    /**
     * Time between reversals of ω along principal axis 2, s.
     */
    flip_interval_s: number | null;
    /**
     * Growth rate of a deviation from rotation about principal axis 2, 1/s.
     */
    growth_rate_per_s: number | null;
    /**
     * Kinetic energy of the rotation at the start, J.
     */
    kinetic_energy_j: number | null;
    /**
     * |L| at the start, kg·m²/s.
     */
    momentum_kg_m2_s: number | null;
    momentum_space_kg_m2_s: Vector15;
    /**
     * Free symmetric top.
     */
    symmetric_top: {
      axis: Vector16;
      /**
       * Moment I_e about the symmetry axis, kg·m².
       */
      axial_moment: number;
      /**
       * Moment I_t across the symmetry axis, kg·m².
       */
      transverse_moment: number;
      /**
       * Component of ω along e, rad/s.
       */
      spin_rad_s: number;
      /**
       * Rate Ω at which ω circles e in the body, right-handed about e, rad/s.
       */
      body_rate_rad_s: number;
      /**
       * Rate |L|/I_t at which ω and e circle L in space, rad/s.
       */
      space_rate_rad_s: number;
      /**
       * Half-angle of the body cone, between ω and ±e, rad.
       */
      body_cone_half_angle_rad: number;
      /**
       * Half-angle of the space cone, between ω and L, rad.
       */
      space_cone_half_angle_rad: number;
      /**
       * Angle between L and ±e, rad.
       */
      nutation_rad: number;
      /**
       * Largest |ê · (ω̂ × L̂)| of all samples, dimensionless.
       */
      coplanarity: number | null;
    } | null;
  };
  /**
   * Energy at both ends, and the work since the start.
   */
  energy: {
    /**
     * Kinetic energy at the first sample, J.
     */
    kinetic_start_j: number | null;
    /**
     * Kinetic energy at the last sample, J.
     */
    kinetic_end_j: number | null;
    /**
     * Potential energy at the first sample, J; null if a torque has none.
     */
    potential_start_j: number | null;
    /**
     * Potential energy at the last sample, J; null if a torque has none.
     */
    potential_end_j: number | null;
    /**
     * Work since the start, J.
     */
    work_j: number | null;
  };
  /**
   * Largest departure of all samples from what the exact motion keeps (relative).
   */
  drift: {
    /**
     * |T − T(0) − W|/max T, dimensionless.
     */
    work_energy: number | null;
    /**
     * |L − L(0) − ∫N dt|/max |L|, as vectors in space axes, dimensionless.
     */
    momentum: number | null;
    /**
     * |E − E(0)|/max(T, |U − U(0)|) with E = T + U, dimensionless; null if there is no torque or one has no potential.
     */
    total_energy: number | null;
    /**
     * |T − T(0)|/max T, dimensionless; null under torque.
     */
    kinetic_energy: number | null;
    /**
     * ||L| − |L(0)||/max |L|, dimensionless; null under torque.
     */
    momentum_magnitude: number | null;
  } | null;
  /**
   * Estimated error of the state at the last sample.
   */
  error: {
    /**
     * Angle between the computed and the exact attitude, rad.
     */
    attitude_rad: number;
    /**
     * |δω|/|ω|, dimensionless; null if it is unknown, or if ω is zero.
     */
    omega: number | null;
    /**
     * Effort of the estimate.
     */
    effort: "cheap" | "thorough";
    inputs: InputsError;
  } | null;
  /**
   * Torque that a prescribed motion needs.
   */
  required: {
    torque_body_n_m: Vector17;
    torque_space_n_m: Vector18;
    /**
     * Power N · ω at the start, W.
     */
    power_w: number | null;
    /**
     * Sample with the largest |N|.
     */
    largest_torque: {
      /**
       * Time, s.
       */
      time_s: number;
      torque_body_n_m: Vector19;
    } | null;
    /**
     * Forces on the particles at the start, if the body has no other parts.
     */
    particle_forces: {
      force_body_n: Vector20;
      along_body_n: Vector21;
      across_body_n: Vector22;
      torque_body_n_m: Vector23;
    }[];
  } | null;
  /**
   * Physical pendulum.
   */
  pendulum: {
    /**
     * Moment of inertia about the axis, kg·m².
     */
    moment: number;
    /**
     * Distance of the centre of mass from the axis, m.
     */
    arm_m: number;
    /**
     * Component of gravity across the axis, m/s².
     */
    gravity_m_s2: number;
    /**
     * Angle at the start from hanging straight down, right-handed about the axis, rad.
     */
    angle_rad: number;
    /**
     * Angular frequency ω₀ of small oscillations, rad/s.
     */
    small_frequency_rad_s: number | null;
    /**
     * Period 2π/ω₀ of small oscillations, s.
     */
    small_period_s: number | null;
    /**
     * Kind of motion.
     */
    swing: "rest" | "oscillation" | "separatrix" | "revolution";
    /**
     * Amplitude of the oscillation, rad.
     */
    amplitude_rad: number | null;
    /**
     * Exact period of the oscillation or revolution, s.
     */
    period_s: number | null;
  } | null;
  /**
   * Heavy symmetric top; angles are between the axis and the upward vertical.
   */
  heavy_top: {
    /**
     * Kind of path of the axis.
     */
    path:
      | "cusps"
      | "loops"
      | "waves"
      | "steady_slow"
      | "steady_fast"
      | "conical"
      | "planar"
      | "through_vertical"
      | "separatrix"
      | "sleeping"
      | "hanging";
    /**
     * Moment A about the pivot across the axis, kg·m².
     */
    transverse_moment: number;
    /**
     * Moment C about the axis, kg·m².
     */
    axial_moment: number;
    /**
     * Torque M g l of the weight with the axis level, N·m.
     */
    weight_torque_n_m: number;
    /**
     * Component ω₃ of ω along the axis, rad/s.
     */
    spin_rad_s: number;
    /**
     * Smallest and largest angle.
     *
     * @minItems 2
     * @maxItems 2
     *
     * Items: Angle, rad.
     */
    nutation_rad: [number, number];
    /**
     * Period of the angle, s; for steady precession that of small nutations.
     */
    nutation_period_s: number | null;
    /**
     * Rotation of the axis about the upward vertical in a period of nutation, rad.
     */
    precession_in_a_nutation_rad: number | null;
    /**
     * Mean precession rate about the upward vertical, rad/s.
     */
    mean_precession_rad_s: number | null;
    /**
     * Mean rate of the body about its axis, rad/s.
     */
    mean_spin_rad_s: number | null;
    /**
     * Spin above which the upright top is stable, rad/s.
     */
    sleeping_threshold_rad_s: number | null;
    /**
     * Slower rate of steady precession at the middle angle, rad/s.
     */
    steady_slow_rad_s: number | null;
    /**
     * Faster rate of steady precession at the middle angle, rad/s.
     */
    steady_fast_rad_s: number | null;
  } | null;
  /**
   * State at the last sample.
   */
  final: Sample | null;
  /**
   * Angles of the scenario.
   *
   * Items: Angle between a direction of the body and another direction.
   */
  pointings: {
    /**
     * Name of the angle.
     */
    name: string;
    body: Vector28;
    /**
     * Other direction: its name, or a unit vector in space axes.
     */
    to: ("nadir" | "velocity" | "orbit_normal" | "field") | Vector29;
    /**
     * Angle at the first sample, rad.
     */
    start_rad: number | null;
    /**
     * Angle at the last sample, rad.
     */
    end_rad: number | null;
    /**
     * Largest angle of the samples, rad.
     */
    largest_rad: number | null;
    /**
     * Time of the largest angle, s.
     */
    largest_time_s: number | null;
    /**
     * Largest angle that is allowed, rad.
     */
    limit_rad: number | null;
    /**
     * Share of the time within the limit, 0 to 1; the angle is linear between samples.
     */
    share_within: number | null;
  }[];
  /**
   * States at the requested times.
   */
  at: Sample[];
  /**
   * Torques of the scenario.
   */
  torques: Torque[];
  /**
   * Wheels of the scenario.
   */
  wheels: Wheel[];
  /**
   * Change of the mass properties.
   */
  mass_history: {
    /**
     * How mass leaves the body.
     */
    outflow: "none" | "in_place" | "exits";
    /**
     * Times at which a change begins or ends.
     *
     * Items: Time, s.
     */
    changes_at_s: number[];
    /**
     * Body at the last sample.
     */
    final: {
      /**
       * Mass, kg.
       */
      mass_kg: number;
      center_of_mass_m: Vector40;
      inertia_kg_m2: Matrix5;
    } | null;
  } | null;
  contact: Contact;
  gimbals: Gimbals;
  /**
   * Events of the scenario.
   */
  events: Event[];
  /**
   * Remarks on the scenario and its motion.
   */
  findings: Finding[];
}
/**
 * File of the scenario.
 */
export interface Source {
  /**
   * Path as given.
   */
  path: string;
  /**
   * Format of the file: scenario.
   */
  format: string;
}
/**
 * Principal moments and axes about the centre of mass.
 */
export interface Principal {
  moments: Vector1;
  /**
   * Principal axes, right-handed, unit vectors in body axes.
   *
   * @minItems 3
   * @maxItems 3
   */
  axes: [Vector2, Vector2, Vector2];
  quaternion_wxyz: Quaternion;
  /**
   * Symmetry of the moments.
   */
  symmetry: "point" | "rod" | "spherical" | "oblate" | "prolate" | "asymmetric";
}
/**
 * Principal moments and axes about the point.
 */
export interface Principal1 {
  moments: Vector1;
  /**
   * Principal axes, right-handed, unit vectors in body axes.
   *
   * @minItems 3
   * @maxItems 3
   */
  axes: [Vector2, Vector2, Vector2];
  quaternion_wxyz: Quaternion;
  /**
   * Symmetry of the moments.
   */
  symmetry: "point" | "rod" | "spherical" | "oblate" | "prolate" | "asymmetric";
}
/**
 * Attitude R_space_body in every convention.
 */
export interface Attitude {
  quaternion_wxyz: Quaternion2;
  quaternion_xyzw: Quaternion3;
  euler313_rad: Vector7;
  roll_pitch_yaw_rad: Vector8;
  mrp: Vector9;
  matrix: Matrix2;
  orbit_roll_pitch_yaw_rad?: Vector10;
}
/**
 * Effect of half a unit in the last place of the moments and the start.
 */
export interface InputsError {
  /**
   * Angle between the attitudes, rad.
   */
  attitude_rad: number;
  /**
   * |δω|/|ω|, dimensionless; null if it is unknown, or if ω is zero.
   */
  omega: number | null;
}
/**
 * State of a sample.
 */
export interface Sample {
  /**
   * Time t, s.
   */
  time_s: number;
  attitude_wxyz: Quaternion4;
  attitude: Attitude;
  omega_body: Vector24;
  omega_space: Vector25;
  momentum_space: Vector26;
  torque_body: Vector27;
}
/**
 * Wheel in the body.
 */
export interface Wheel {
  /**
   * Kind of element.
   */
  model: "wheel";
  axis_body: Vector39;
  /**
   * Momentum h along the axis at the start, kg·m²/s.
   */
  momentum_kg_m2_s: number;
  /**
   * Moment of inertia about the axis, kg·m²; absent without a motor.
   */
  inertia_kg_m2?: number;
  /**
   * Torque of the motor about the axis, N·m; absent without a motor.
   */
  motor_torque_n_m?: number;
  schedule: Schedule;
  /**
   * Name of the wheel.
   */
  name: string | null;
  /**
   * Speed relative to the body at the start, rad/s; null if the speed is held.
   */
  speed_rad_s: number | null;
  /**
   * Momentum along the axis at the last sample, kg·m²/s.
   */
  final_momentum_kg_m2_s: number | null;
  /**
   * Speed relative to the body at the last sample, rad/s; null if the speed is held.
   */
  final_speed_rad_s: number | null;
}
/**
 * State of the contact.
 */
export interface ContactState {
  /**
   * Time, s.
   */
  time_s: number;
  /**
   * Phase of the contact.
   */
  phase: "rolling" | "sliding" | "flying";
  center_m: Vector50;
  velocity_m_s: Vector51;
  contact_m: Vector52;
  contact_body_m: Vector53;
  /**
   * Normal force, N.
   */
  normal_force_n: number | null;
  slip_m_s: Vector54;
  friction_n: Vector55;
  /**
   * Kinetic energy with that of the centre of mass, J.
   */
  kinetic_energy_j: number | null;
  /**
   * Potential energy −m g · x of the centre of mass, J.
   */
  potential_energy_j: number | null;
  /**
   * Work of friction since the start, J.
   */
  friction_work_j: number | null;
  /**
   * Work of the moving ground since the start, J.
   */
  ground_work_j: number | null;
}
/**
 * Gimbal.
 */
export interface Gimbal {
  inertia_about_crossing: Matrix6;
  moment_kg_m: Vector62;
}
/**
 * State of the gimbals; lists are of the outer, the inner and the rotor axis.
 */
export interface GimbalState {
  /**
   * Time, s.
   */
  time_s: number;
  /**
   * Angles.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Angle of the axis, rad.
   */
  angles_rad: [number | null, number | null, number | null];
  /**
   * Rates of the angles.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Rate of the angle, rad/s.
   */
  rates_rad_s: [number | null, number | null, number | null];
  /**
   * Torques of locks and motors.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Torque about the axis, N·m.
   */
  holding_n_m: [number | null, number | null, number | null];
  momentum_space_kg_m2_s: Vector63;
  /**
   * Kinetic energy of rotor and gimbals, J.
   */
  kinetic_energy_j: number | null;
  /**
   * Potential energy of the weights, J; 0 with all centres of mass at the crossing.
   */
  potential_energy_j: number | null;
  /**
   * Energy of the springs, J.
   */
  spring_energy_j: number | null;
  /**
   * Work of damping since the start, J.
   */
  damping_work_j: number | null;
  /**
   * Work of motors since the start, J.
   */
  motor_work_j: number | null;
  /**
   * Work of constant torques since the start, J.
   */
  torque_work_j: number | null;
  /**
   * Work of the turning base since the start, J.
   */
  base_work_j: number | null;
}
/**
 * Event of the scenario.
 */
export interface Event {
  /**
   * Name of the event.
   */
  name: string;
  /**
   * Quantity that is measured.
   */
  measure:
    | (
        | "time"
        | "omega"
        | "kinetic_energy"
        | "total_energy"
        | "momentum"
        | "nutation"
        | "precession"
        | "spin"
        | "formula"
        | "function"
        | null
      )
    | {
        /**
         * Quantity.
         */
        of: "omega";
        /**
         * Axes that the components refer to.
         */
        axes: "body" | "space";
        along: Vector64;
      }
    | {
        /**
         * Quantity.
         */
        of: "angle";
        body: Vector65;
        space: Vector66;
      }
    | {
        /**
         * Quantity.
         */
        of: "angle";
        body: Vector67;
        /**
         * Other direction.
         */
        to: "nadir" | "velocity" | "orbit_normal" | "field" | "omega" | "momentum";
      };
  /**
   * Value that is passed, in unit.
   */
  value: number;
  /**
   * Unit of the value; empty for a formula or function.
   */
  unit: "s" | "rad/s" | "J" | "kg·m²/s" | "rad" | "";
  /**
   * Direction in which the value is passed.
   */
  direction: "rising" | "falling" | "either";
  /**
   * Action.
   */
  then:
    | ("record" | "stop")
    | {
        /**
         * Name of the torque.
         */
        switch: string | null;
        /**
         * Index in torques, from 0.
         */
        torque: number;
        /**
         * True if it is switched on.
         */
        on: boolean;
      };
  /**
   * Times at which it happened.
   */
  happened: {
    /**
     * Time, s.
     */
    time_s: number;
    /**
     * Direction in which the value was passed.
     */
    direction: "rising" | "falling";
    attitude_wxyz: Quaternion9;
    omega_body: Vector68;
  }[];
}
/**
 * Remark.
 */
export interface Finding {
  /**
   * Name of the kind of finding, such as body.rod.
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
   * Place in the input.
   */
  where: string | null;
}
