//! What can be wrong with a limit.

use crate::error::BudgetError;
use crate::errors::errors;

errors! {
    /// Error of a limit that has no answer.
    LimitError;

    /// Neither a least nor a greatest value.
    Open {
        /// The limit.
        limit: String,
    } => ("the limit \"{limit}\" allows every value"),
        hint: "give it the least value that is allowed, the greatest, or both";
    /// A number that cannot be.
    Value {
        /// The limit.
        limit: String,
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    } => ("{what} of the limit \"{limit}\" is {value}, and has to be {rule}");
    /// A level of confidence that is none.
    Level {
        /// As it was given.
        value: f64,
    } => ("the level of confidence is {value}, and has to be above 0 and below 1");
    /// No draws on a basis that limits are on, or not as many as on the other.
    Draws {
        /// The fewest and the most that there are.
        given: [usize; 2],
    } => ("{} draws on one basis and {} on another, where limits need the same on each", given[0], given[1]);
    /// The list has no such estimate or draws.
    Budget(error: BudgetError) => ("{error}"), hint: error.hint();
}
