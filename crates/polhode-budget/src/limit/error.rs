//! Errors of limits on a body.

use crate::error::BudgetError;
use crate::errors::errors;

errors! {
    /// Error of a limit that cannot be tested.
    LimitError;

    /// A limit has neither a least nor a greatest value.
    Open {
        limit: String,
    } => ("the limit \"{limit}\" has no bound"),
        hint: "give it a lower bound, an upper bound, or both";
    /// A number is out of range.
    Value {
        limit: String,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} of the limit \"{limit}\" is {value}, but must be {rule}");
    /// A confidence level is not between 0 and 1.
    Level {
        value: f64,
    } => ("the confidence level is {value}, but must be above 0 and below 1");
    /// Draws on a basis that limits use are missing, or their numbers differ between both bases.
    Draws {
        /// Smallest and largest number of draws.
        given: [usize; 2],
    } => ("{} draws for one mass basis and {} for another, but limits need equal numbers", given[0], given[1]);
    /// The list has no such estimate or draws.
    Budget(error: BudgetError) => ("{error}"), hint: error.hint();
}
