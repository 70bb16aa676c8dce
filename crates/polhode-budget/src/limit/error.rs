//! Errors of limits on a body.

use crate::error::BudgetError;
use crate::errors::errors;

errors! {
    /// Error of a limit that cannot be tested.
    LimitError;

    /// A limit has neither a least nor a greatest value.
    Open {
        limit: String,
    } => ("the limit \"{limit}\" allows every value"),
        hint: "give it the least value that is allowed, the greatest, or both";
    /// A number is out of range.
    Value {
        limit: String,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} of the limit \"{limit}\" is {value}, and has to be {rule}");
    /// A confidence level is not between 0 and 1.
    Level {
        value: f64,
    } => ("the level of confidence is {value}, and has to be above 0 and below 1");
    /// Draws on a basis that limits use are missing, or their numbers differ between both bases.
    Draws {
        /// Smallest and largest number of draws.
        given: [usize; 2],
    } => ("{} draws on one basis and {} on another, where limits need the same on each", given[0], given[1]);
    /// The list has no such estimate or draws.
    Budget(error: BudgetError) => ("{error}"), hint: error.hint();
}
