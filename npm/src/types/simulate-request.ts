/* Types of crates/polhode-scenario/schema/simulate/request.json, written by viewer/types.mjs; do not edit. */

/**
 * Scenario whose motion is requested. Quantities are text with a unit, or numbers in SI units.
 */
export interface SimulateRequest {
  /**
   * Scenario with a [run] section, a TOML file.
   */
  file?: string;
  /**
   * Times of states to report in addition.
   *
   * Items: Times, s if a number: a text such as "2 s", "0 s, 1 s" or "0:1:0.1" has several.
   */
  at?: (string | number)[];
  /**
   * Estimate the error thoroughly.
   */
  error?: boolean;
  /**
   * The text has the details of the solver and the effect of rounding the inputs.
   */
  verbose?: boolean;
}
