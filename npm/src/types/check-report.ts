/* Types of crates/polhode-robot/schema/report.json, written by viewer/types.mjs; do not edit. */

/**
 * One file's result if one file was named, and otherwise a list of them.
 */
export type CheckReport = File | File[];
export type File = Checked | Unreadable;
/**
 * Nearest possible tensor, about the centre of mass along the inertial's axes.
 */
export type Nearest = Proposed | None;

/**
 * Model that was checked.
 */
export interface Checked {
  /**
   * Version of polhode.
   */
  polhode: string;
  /**
   * Path of the model.
   */
  file: string;
  /**
   * Language of the model.
   */
  format: "urdf" | "sdf" | "mjcf" | "usd" | "osim";
  /**
   * Name of the model, if it has one.
   */
  name: string | null;
  /**
   * Number of links.
   */
  links: number;
  /**
   * Number of links that state their mass.
   */
  inertials: number;
  /**
   * Files that the model includes.
   */
  includes: {
    /**
     * Path of the file.
     */
    file: string;
    /**
     * Number of links in the file.
     */
    links: number;
    /**
     * Number of inertials in the file.
     */
    inertials: number;
  }[];
  /**
   * Point that tensors are about.
   */
  inertia_about: "center_of_mass";
  /**
   * Sign of off-diagonal elements of tensors: -∫xy dm.
   */
  products: "negative_integral";
  /**
   * Number of findings of each severity.
   */
  counts: {
    /**
     * Number of impossible findings.
     */
    impossible: number;
    /**
     * Number of suspect findings.
     */
    suspect: number;
    /**
     * Number of notes.
     */
    note: number;
  };
  /**
   * Number of links by the severity of their worst finding.
   */
  verdicts: {
    /**
     * Number of links with an impossible finding.
     */
    impossible: number;
    /**
     * Number of links whose worst finding is suspect.
     */
    suspect: number;
    /**
     * Number of links whose worst finding is a note.
     */
    note: number;
    /**
     * Number of links without findings.
     */
    ok: number;
  };
  /**
   * Findings that count, in the order of the file.
   */
  findings: Finding[];
  /**
   * Findings that the model or the configuration allows, each with its reason.
   */
  allowed: Finding[];
  /**
   * Findings that are in the baseline.
   */
  known: Finding[];
  /**
   * Number of findings of disabled rules.
   */
  off: number;
  fix?: Fix;
}
/**
 * Finding about a model.
 */
export interface Finding {
  /**
   * Identifier that does not depend on changes elsewhere in the file.
   */
  id: string;
  /**
   * Code of the rule, such as inertia.triangle.
   */
  code: string;
  /**
   * Severity.
   */
  severity: "impossible" | "suspect" | "note";
  /**
   * Link or joint; empty if it is about the whole model.
   */
  link: string;
  /**
   * Names of the other links of the finding.
   */
  others: string[];
  /**
   * Line in the file, from 1.
   */
  line: number;
  /**
   * Column in characters, from 1.
   */
  column: number;
  /**
   * What is wrong, with numbers and units.
   */
  message: string;
  /**
   * Rule that is broken.
   */
  rule: string;
  /**
   * Numbers of the message by name.
   */
  numbers: {
    /**
     * Number in SI units (kg, m, kg·m²), or a ratio; null if it is not finite.
     */
    [k: string]: number | null;
  };
  repair: Repair | null;
  /**
   * Possible tensors nearest to an impossible one, if requested.
   */
  nearest?: {
    frobenius: Nearest;
    affine_invariant: Nearest;
  };
  /**
   * Path of the included file that contains it; for a xacro file, of the macro, or the name of the expanded text.
   */
  file?: string;
  /**
   * Reason why it is allowed.
   */
  reason?: string;
}
/**
 * Fix that is the only consistent one.
 */
export interface Repair {
  /**
   * What it does.
   */
  description: string;
  /**
   * Replacements of text; they do not overlap.
   */
  edits: {
    /**
     * Line in the file, from 1.
     */
    line: number;
    /**
     * Column in characters, from 1.
     */
    column: number;
    /**
     * Replaced text; null in an included file.
     */
    old: string | null;
    /**
     * New text.
     */
    new: string;
    /**
     * Name of the expanded text of a xacro file.
     */
    file?: string;
  }[];
}
/**
 * Proposed tensor, and its distance in one metric.
 */
export interface Proposed {
  /**
   * Moment, kg·m².
   */
  ixx: number;
  /**
   * Moment, kg·m².
   */
  iyy: number;
  /**
   * Moment, kg·m².
   */
  izz: number;
  /**
   * Product -∫xy dm, kg·m².
   */
  ixy: number;
  /**
   * Product -∫xz dm, kg·m².
   */
  ixz: number;
  /**
   * Product -∫yz dm, kg·m².
   */
  iyz: number;
  /**
   * Distance, kg·m² in the Frobenius norm; a number in the affine-invariant metric.
   */
  distance: number;
}
/**
 * No tensor at a finite distance.
 */
export interface None {
  /**
   * Reason.
   */
  none: string;
}
/**
 * Fixes, if requested.
 */
export interface Fix {
  /**
   * Path of the fixed model.
   */
  out: string | null;
  /**
   * Diff from the model to the fixed one.
   */
  diff: string;
  /**
   * Number of values that the fixes change.
   */
  changes: number;
  /**
   * Findings that are fixed.
   *
   * Items: Position in findings, from 0.
   */
  repaired: number[];
  /**
   * Findings whose fix was not applied.
   */
  left: {
    /**
     * Position in findings, from 0.
     */
    finding: number;
    /**
     * Code of the rule.
     */
    code: string | null;
    /**
     * Link or joint.
     */
    link: string | null;
    /**
     * Reason why the fix was not applied.
     */
    why: string;
  }[];
  /**
   * Number of findings in the fixed model.
   */
  remaining: number;
}
/**
 * File that cannot be read, or folder that contains no model.
 */
export interface Unreadable {
  /**
   * Version of polhode.
   */
  polhode: string;
  /**
   * Path of the file or folder.
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
