//! Outcomes of members, and their columns.

mod columns;
mod extrema;
mod free;
mod instant;
mod member;
mod trajectory;

use polhode::motion::{Method, Scenario};

pub(crate) use columns::of as columns_of;
pub(crate) use member::Outcome;
pub(crate) use trajectory::{samples, table};

/// Returns true if members' motions are probably integrated in steps.
pub(crate) fn is_stepped(scenario: &Scenario) -> bool {
    let method = scenario.run().map_or(Method::Auto, |run| run.method);
    let driven =
        !scenario.torques().is_empty() || !scenario.wheels().is_empty() || !scenario.events().is_empty();
    scenario.prescribed().is_none() && (driven || !matches!(method, Method::Auto | Method::Exact))
}
