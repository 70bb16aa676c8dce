/* Types of crates/polhode-shape/schema/report.json, written by viewer/types.mjs; do not edit. */

/**
 * One body's mass properties, or a list of them.
 */
export type InertiaReport = Result | Result[];
export type Result = Body | Failed;

/**
 * Mass properties of a body.
 */
export interface Body {
  /**
   * Version of polhode.
   */
  polhode: string;
  source: Source;
  /**
   * Mass, kg.
   */
  mass: number;
  /**
   * Enclosed volume, m³.
   */
  volume: number | null;
  /**
   * Surface area, m².
   */
  surface_area: number | null;
  /**
   * Mass per volume, kg/m³.
   */
  density: number | null;
  /**
   * Centre of mass in body axes, m.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: m.
   */
  center_of_mass: [number, number, number];
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
     * Sign of off-diagonal elements.
     */
    products: "negative_integral";
    /**
     * Tensor, kg·m²; off-diagonal elements are -∫xy dm.
     *
     * @minItems 3
     * @maxItems 3
     */
    tensor: [[number, number, number], [number, number, number], [number, number, number]];
  };
  principal: Principal;
  /**
   * Radii of gyration about the principal axes, m.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: m.
   */
  gyration_radii: [number, number, number];
  /**
   * Remarks on the file and its body.
   */
  findings: {
    /**
     * Code of the finding.
     */
    code: string;
    /**
     * Severity.
     */
    severity: "error" | "warning" | "info";
    /**
     * What was noticed.
     */
    message: string;
    /**
     * Place.
     */
    where: string | null;
  }[];
  /**
   * Tensor about another point.
   */
  inertia_about?: {
    /**
     * Reference point in body axes, m.
     *
     * @minItems 3
     * @maxItems 3
     *
     * Items: m.
     */
    point: [number, number, number];
    /**
     * Tensor about the point, kg·m²; off-diagonal elements are -∫xy dm.
     *
     * @minItems 3
     * @maxItems 3
     */
    tensor: [[number, number, number], [number, number, number], [number, number, number]];
    principal: Principal;
  };
  /**
   * Tensor along other axes.
   */
  inertia_in_axes?: {
    /**
     * Reference point.
     */
    about: "center_of_mass";
    /**
     * Rotation from the other axes to body axes, scalar first.
     *
     * @minItems 4
     * @maxItems 4
     *
     * Items: Component, dimensionless.
     */
    quaternion_wxyz: [number, number, number, number];
    /**
     * Tensor along the axes, kg·m²; off-diagonal elements are -∫xy dm.
     *
     * @minItems 3
     * @maxItems 3
     */
    tensor: [[number, number, number], [number, number, number], [number, number, number]];
  };
  /**
   * Parts of the body.
   */
  parts?: {
    /**
     * Name of the part.
     */
    name: string;
    /**
     * Mass, kg.
     */
    mass: number;
    /**
     * Enclosed volume, m³.
     */
    volume: number | null;
    /**
     * Mass per volume, kg/m³.
     */
    density: number | null;
    /**
     * Centre of mass in body axes, m.
     *
     * @minItems 3
     * @maxItems 3
     *
     * Items: m.
     */
    center_of_mass: [number, number, number];
  }[];
  molecule?: Molecule;
  /**
   * Sign of the products in a CAD report.
   */
  products_of_inertia?: {
    /**
     * Sign of the report's products.
     */
    given_as: "negative_integral" | "positive_integral";
    /**
     * Evidence for the sign.
     */
    decided_by: string;
    /**
     * Residual under the negative sign, in units of the report's rounding, dimensionless.
     */
    residual_negative: number | null;
    /**
     * Residual under the positive sign, in units of the report's rounding, dimensionless.
     */
    residual_positive: number | null;
    /**
     * Rounding of the report (relative).
     */
    rounding: number | null;
  };
  /**
   * Error bounds: of a mesh whose holes were closed, valid if each missing surface lies within the convex hull of its hole; of a printed mesh, from the cells at the boundary of the infill.
   */
  bounds?: {
    /**
     * Error bound of the volume, m³.
     */
    volume: number;
    /**
     * The same relative to the volume, dimensionless.
     */
    volume_share: number;
    /**
     * Error bound of the mass, kg.
     */
    mass: number;
    /**
     * Error bounds of the coordinates of the centre of mass, m.
     *
     * @minItems 3
     * @maxItems 3
     *
     * Items: m.
     */
    center_of_mass: [number, number, number];
    /**
     * Error bounds of the tensor's elements, kg·m².
     *
     * @minItems 3
     * @maxItems 3
     */
    inertia: [[number, number, number], [number, number, number], [number, number, number]];
    /**
     * Error bound of each principal moment, kg·m².
     */
    principal_moments: number;
  };
  /**
   * Estimated errors.
   */
  error_estimate?: {
    /**
     * Error of the mass, kg.
     */
    mass: number;
    /**
     * Error of the centre of mass, m.
     */
    center_of_mass: number;
    /**
     * Error of the tensor's elements relative to half its trace, dimensionless.
     */
    inertia: number;
  };
}
/**
 * Source of the body.
 */
export interface Source {
  /**
   * Path of the file, or name of the shape.
   */
  path: string;
  /**
   * Format of the file, such as stl or scenario; shape without a file.
   */
  format: string;
  /**
   * Lengths of a shape by name.
   */
  lengths_m?: {
    /**
     * Length, m.
     */
    [k: string]: number;
  };
  /**
   * Unit of length of the file, m.
   */
  unit_m?: number;
  /**
   * Metres were assumed.
   */
  unit_assumed?: boolean;
  /**
   * Encoding of a mesh file.
   */
  encoding?: string;
  /**
   * Number of triangles.
   */
  triangles?: number;
  /**
   * Number of triangles in the file, where another number was used.
   */
  triangles_in_file?: number;
  /**
   * Number of vertices.
   */
  vertices?: number;
  /**
   * Number of parts.
   */
  parts?: number;
  /**
   * Interpretation of a mesh.
   */
  taken_as?: "solid" | "convex_hull" | "sheet" | "union";
  /**
   * Vertices that were joined.
   */
  weld?: {
    /**
     * Number of vertices that were joined.
     */
    vertices: number;
    /**
     * Number of points that they were joined to.
     */
    points: number;
    /**
     * Largest distance of joined vertices, m.
     */
    largest_distance_m: number;
    /**
     * Number of removed triangles.
     */
    triangles_vanished: number;
    /**
     * Number of vertices inside open edges, at which these were split.
     */
    t_junctions: number;
    /**
     * Largest distance of such a vertex from its edge, m.
     */
    largest_offset_m: number;
    /**
     * Bound on the change of volume, m³.
     */
    volume_bound_m3: number;
  };
  /**
   * Holes that were closed.
   */
  fill?: {
    /**
     * Number of holes.
     */
    holes: number;
    /**
     * Number of new triangles.
     */
    triangles: number;
    /**
     * Size of the largest hole, m.
     */
    largest_m: number;
    /**
     * Bound on the missing volume, m³.
     */
    volume_bound_m3: number;
  };
  /**
   * Holes that were closed within bounds.
   */
  close_within?: {
    /**
     * Number of holes.
     */
    holes: number;
    /**
     * Number of new triangles.
     */
    triangles: number;
    /**
     * Size of the largest hole, m.
     */
    largest_m: number;
    /**
     * Centre of the largest hole, m; null without a hole.
     *
     * @minItems 3
     * @maxItems 3
     */
    largest_at_m: [number, number, number] | null;
    /**
     * Bound on the error of the volume by closing, m³.
     */
    volume_bound_m3: number;
  };
  /**
   * Walls and infill of a printed mesh.
   */
  print?: {
    /**
     * Thickness of the walls, m.
     */
    walls_m: number;
    /**
     * Thickness of the solid layers under all that faces up, m; 0 for none.
     */
    top_layers_m: number;
    /**
     * Thickness of the solid layers over all that faces down, m; 0 for none.
     */
    bottom_layers_m: number;
    /**
     * Density of the infill relative to the walls', dimensionless.
     */
    infill: number;
    /**
     * Volume of the infill, m³.
     */
    infill_volume_m3: number;
    /**
     * Bound on the error of that volume, m³.
     */
    infill_bound_m3: number;
  };
  /**
   * Bound on the error of the volume by closing and all repairs, m³.
   */
  volume_bound_m3?: number;
  /**
   * Union of parts.
   */
  union?: {
    /**
     * Number of parts.
     */
    parts: number;
    /**
     * Volume that several parts share, m³.
     */
    shared_m3: number;
    /**
     * Omitted volume, m³.
     */
    left_out_m3: number;
    /**
     * Bound on the error of the volume, m³.
     */
    volume_error_m3: number;
  };
  /**
   * Name of a molecule.
   */
  name?: string;
  /**
   * Number of atoms.
   */
  atoms?: number;
  /**
   * Position of the molecule in the file, from 1.
   */
  molecule?: number;
  /**
   * Program that a CAD report is from.
   */
  product?: string;
  /**
   * Number of particles.
   */
  particles?: number;
  /**
   * True if the particles have their own tensors.
   */
  tensors?: boolean;
  /**
   * Number of voxels along each axis.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: Number of voxels.
   */
  voxels?: [number, number, number];
  /**
   * Type of a voxel's value.
   */
  type?: string;
  /**
   * Number of voxels that are not empty.
   */
  filled?: number;
  /**
   * Title of a scenario.
   */
  title?: string | null;
  /**
   * Link of a robot whose frame is used.
   */
  link?: string | null;
  /**
   * Frame of a robot's body.
   */
  frame?: "link" | "model";
  /**
   * Links that were joined.
   */
  links?: string[];
  /**
   * Links without mass that were joined.
   */
  massless?: string[];
  /**
   * Values of joints that were given.
   */
  joints?: {
    /**
     * Value of the joint, rad or m.
     */
    [k: string]: number;
  };
  /**
   * Values of joints that follow others.
   */
  followers?: {
    /**
     * Value of the joint, rad or m.
     */
    [k: string]: number;
  };
  /**
   * Inertias at joints with rotors.
   */
  armatures?: {
    /**
     * Joint.
     */
    joint: string;
    /**
     * The joint slides.
     */
    slides: boolean;
    /**
     * Inertia of the links, kg·m², or kg where the joint slides.
     */
    inertia: number;
    /**
     * Armature of the rotor, kg·m², or kg where the joint slides.
     */
    armature: number;
    /**
     * Sum of both, kg·m², or kg where the joint slides.
     */
    total: number;
  }[];
  /**
   * Change of the tensor that makes it possible, kg·m².
   */
  rounding?: number;
}
/**
 * Principal moments and axes.
 */
export interface Principal {
  /**
   * Principal moments, ascending, kg·m².
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: kg·m².
   */
  moments: [number, number, number];
  /**
   * Principal axes, right-handed, as unit vectors in body axes.
   *
   * @minItems 3
   * @maxItems 3
   */
  axes: [[number, number, number], [number, number, number], [number, number, number]];
  /**
   * Rotation from principal axes to body axes, scalar first.
   *
   * @minItems 4
   * @maxItems 4
   *
   * Items: Component, dimensionless.
   */
  quaternion_wxyz: [number, number, number, number];
  /**
   * Symmetry of the moments.
   */
  symmetry: "point" | "rod" | "spherical" | "oblate" | "prolate" | "asymmetric";
}
/**
 * Rotational constants of a molecule.
 */
export interface Molecule {
  /**
   * Formula in Hill's order.
   */
  formula: string;
  /**
   * Number of atoms.
   */
  atoms: number;
  /**
   * Masses of atoms whose isotope is not named.
   */
  isotopes: "abundant" | "average";
  /**
   * Rotational constants A, B, C, GHz; null where it is infinite.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: GHz.
   */
  rotational_constants_ghz: [number | null, number | null, number | null];
  /**
   * Rotational constants A, B, C, cm⁻¹; null where it is infinite.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: cm⁻¹.
   */
  rotational_constants_cm1: [number | null, number | null, number | null];
  /**
   * Ray's asymmetry parameter κ, dimensionless.
   */
  ray_kappa: number | null;
  /**
   * Kind of top; null for an atom.
   */
  top: "linear" | "spherical" | "prolate" | "oblate" | "asymmetric" | null;
  /**
   * Relative difference of moments that count as equal, dimensionless.
   */
  top_tolerance: number | null;
  /**
   * Principal moments, u·Å²; null where it is infinite.
   *
   * @minItems 3
   * @maxItems 3
   *
   * Items: u·Å².
   */
  moments_u_angstrom2: [number | null, number | null, number | null];
  /**
   * Inertial defect, u·Å².
   */
  inertial_defect_u_angstrom2: number | null;
}
/**
 * File that could not be read.
 */
export interface Failed {
  /**
   * Version of polhode.
   */
  polhode: string;
  /**
   * Path of the file.
   */
  file: string;
  error: {
    /**
     * Line in the file, from 1.
     */
    line: number | null;
    /**
     * Column in characters, from 1.
     */
    column: number | null;
    /**
     * What is wrong.
     */
    message: string;
    /**
     * What to do.
     */
    hint: string | null;
  };
}
