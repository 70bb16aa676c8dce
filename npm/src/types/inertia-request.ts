/* Types of crates/polhode-shape/schema/request.json, written by viewer/types.mjs; do not edit. */

/**
 * Files of bodies, and what they leave open, or a shape. Quantities are texts with a unit, such as "85 g", or numbers in SI units.
 */
export interface InertiaRequest {
  /**
   * Scenarios, meshes, molecules, particles, voxel grids, CAD reports and robot models.
   */
  files?: string[];
  /**
   * Box instead of files: edges along x, y, z, each with its unit, such as 20 cm, 10 cm, 6 cm; at most one shape.
   */
  box?: string | null;
  /**
   * Sphere: radius with its unit.
   */
  sphere?: string | null;
  /**
   * Ellipsoid: semi-axes along x, y, z.
   */
  ellipsoid?: string | null;
  /**
   * Cylinder along z: radius, length.
   */
  cylinder?: string | null;
  /**
   * Cylinder along z between two half balls: radius, length without these caps.
   */
  capsule?: string | null;
  /**
   * Cone with the centre of its base at the origin and its apex on +z: radius, height.
   */
  cone?: string | null;
  /**
   * Torus about z: radius of the ring's centre line, radius of the tube.
   */
  torus?: string | null;
  /**
   * Thin rod along z: length; with mass only.
   */
  rod?: string | null;
  /**
   * Thin disk perpendicular to z: radius; with mass only.
   */
  disk?: string | null;
  /**
   * Density of a mesh or shape, kg/m³ or with its unit; at most one of density, mass and material.
   */
  density?: string | number | null;
  /**
   * Mass of a mesh, shape or point cloud, kg or with its unit.
   */
  mass?: string | number | null;
  /**
   * Material of a mesh or shape by name.
   */
  material?: string | null;
  /**
   * Substances of parts of a mesh.
   *
   * Items: NAME=WHAT: name of the part, and its density, mass (both with unit) or material.
   */
  part?: string[];
  /**
   * Use the convex hull of each part of a mesh.
   */
  hull?: boolean;
  /**
   * Thickness of a sheet along a mesh, m or with its unit.
   */
  shell?: string | number | null;
  /**
   * Density of a mesh as a formula of x, y, z in m, kg/m³.
   */
  field?: string | null;
  /**
   * Tolerance for the estimated relative error of field, dimensionless.
   */
  tolerance?: string | number | null;
  /**
   * Distance up to which vertices of open edges are joined: a length with its unit, or a fraction of the mesh's size.
   */
  weld?: string | number | null;
  /**
   * Size up to which holes are closed: a length with its unit, or a fraction of the mesh's size.
   */
  fill?: string | number | null;
  /**
   * Largest share of the volume that closing all holes may leave uncertain: a percentage such as 5%, or a number.
   */
  "close-within"?: string | number | null;
  /**
   * Thickness of the walls of a printed mesh, m or with its unit.
   */
  walls?: string | number | null;
  /**
   * Thickness of the solid layers of a printed mesh under all that faces up, along z, m or with its unit.
   */
  "top-layers"?: string | number | null;
  /**
   * Thickness of the solid layers of a printed mesh over all that faces down, along z, m or with its unit.
   */
  "bottom-layers"?: string | number | null;
  /**
   * Density of a printed mesh behind its walls relative to the material's: a percentage such as 15%, or a number.
   */
  infill?: string | number | null;
  /**
   * Use the union of all parts of a mesh, so that overlapping regions count once.
   */
  union?: boolean;
  /**
   * Output file for the mesh after repairs; the format follows from the extension.
   */
  "write-mesh"?: string | null;
  /**
   * Unit of length of a file that states none.
   */
  unit?: string | null;
  /**
   * Unit of mass of a file that states none.
   */
  "mass-unit"?: string | null;
  /**
   * Isotopes of atoms for which the file names none.
   */
  isotopes?: "abundant" | "average" | null;
  /**
   * Sign of the products of inertia in a CAD report.
   */
  products?: "negative" | "positive" | null;
  /**
   * Decimal mark of a CAD report.
   */
  decimal?: "point" | "comma" | null;
  /**
   * Distances of voxels along the file's axes, m or with their units: one or three with commas between.
   */
  spacing?: string | number | null;
  /**
   * Centre of the first voxel, x,y,z, m or with their units.
   */
  origin?: string | number | null;
  /**
   * Density for a voxel value of 1, kg/m³ or with its unit.
   */
  "per-value"?: string | number | null;
  /**
   * Kind of the files, if it does not follow from the file extension.
   */
  format?:
    | "scenario"
    | "stl"
    | "obj"
    | "ply"
    | "points"
    | "off"
    | "gltf"
    | "3mf"
    | "dae"
    | "particles"
    | "cad"
    | "xyz"
    | "mol"
    | "pdb"
    | "robot"
    | "npy"
    | "nrrd"
    | null;
  /**
   * Additional reference point for the tensor, x,y,z from the origin, m or with their units; or corner, of a box.
   */
  about?: string | null;
  /**
   * Additional axes for the tensor: a unit quaternion w,x,y,z from the rotated axes to body axes.
   */
  along?: string | null;
}
