//! Errors of the search for ballast.

use crate::error::BudgetError;
use crate::errors::errors;
use crate::limit::LimitError;

errors! {
    /// Error of a problem that the search cannot solve.
    BallastError;

    /// The list of sites is empty.
    NoSites => ("the list has no site for ballast");
    /// A number is not allowed.
    Value {
        /// Name of the site, or `None` for a number of the search itself.
        site: Option<String>,
        /// Name of the number.
        what: &'static str,
        value: f64,
        /// Condition that it has to meet.
        rule: &'static str,
    } => ("{what}{} is {value}, but must be {rule}", of_site(site.as_deref()));
    /// A limit is of a kind that the search cannot treat.
    Limit {
        limit: String,
        /// Reason for the refusal.
        why: &'static str,
    } => ("the ballast search does not support the limit \"{limit}\": {why}");
    /// A number that was computed from the list and its limits is NaN or infinite.
    NotFinite {
        /// Name of the number.
        quantity: &'static str,
    } => ("{quantity} is not finite");
    /// A limit has no bound or an invalid number.
    NotLimit(error: LimitError) => ("{error}");
    /// The list has no such estimate.
    Budget(error: BudgetError) => ("{error}");
}

fn of_site(site: Option<&str>) -> String {
    site.map_or_else(String::new, |site| format!(" of the site \"{site}\""))
}
