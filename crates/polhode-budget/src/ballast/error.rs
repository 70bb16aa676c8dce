//! Errors of the search for ballast.

use crate::error::BudgetError;
use crate::errors::errors;
use crate::limit::LimitError;

errors! {
    /// Error of a question that the search cannot answer.
    BallastError;

    /// There is no site.
    NoSites => ("there is no site for ballast");
    /// A number that is not allowed.
    Value {
        /// Name of the site, or `None` for a number of the question.
        site: Option<String>,
        /// Name of the number.
        what: &'static str,
        /// The number that was given.
        value: f64,
        /// Condition that it has to meet.
        rule: &'static str,
    } => ("{what}{} is {value}, and has to be {rule}", of_site(site.as_deref()));
    /// A limit that ballast cannot be found for.
    Limit {
        /// The limit.
        limit: String,
        /// Why not.
        why: &'static str,
    } => ("no ballast can be sought for the limit \"{limit}\": {why}");
    /// A number that was computed from the list and its limits is NaN or infinite.
    NotFinite {
        /// Name of the number.
        quantity: &'static str,
    } => ("{quantity} is not finite");
    /// A limit that says nothing.
    NotLimit(error: LimitError) => ("{error}");
    /// The list has no such estimate.
    Budget(error: BudgetError) => ("{error}");
}

fn of_site(site: Option<&str>) -> String {
    site.map_or_else(String::new, |site| format!(" of the site \"{site}\""))
}
