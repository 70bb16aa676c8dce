/* Types of crates/polhode-robot/schema/request.json, written by viewer/types.mjs; do not edit. */

/**
 * Robot and simulation models to check, and the policy for findings.
 */
export interface CheckRequest {
  /**
   * Models, and folders to search for them.
   */
  files?: string[];
  /**
   * Folders that contain packages, for package:// and model://. Meshes are opened only below these roots, the checked folders, the model's own folder, and an ancestor folder with the package's name.
   */
  root?: string[];
  /**
   * Programs that have to accept the models. A link that one of them refuses is an error instead of a note.
   */
  for?: ("mujoco" | "gazebo" | "drake" | "isaac")[];
  /**
   * Propose the possible tensors nearest to each impossible one, with their distances.
   */
  nearest?: boolean;
  /**
   * Lowest severity that fails; null for the value in the configuration, by default suspect.
   */
  "fail-on"?: "impossible" | "suspect" | "note" | null;
  /**
   * Notes fail too.
   */
  strict?: boolean;
  /**
   * Configuration file with severities of rules, allowances and exclusions, instead of polhode.toml.
   */
  config?: string | null;
  /**
   * Baseline file of known findings, which do not fail.
   */
  baseline?: string | null;
  /**
   * Also compute the fixes that are the only consistent ones.
   */
  fix?: boolean;
  /**
   * Today, YYYY-MM-DD, for allowances that expire; without it none has expired.
   */
  today?: string | null;
}
