//! Outcomes of members, and the columns that hold them.

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

/// True if members' motions are computed in steps, as far as can be seen before.
pub(crate) fn is_stepped(scenario: &Scenario) -> bool {
    let method = scenario.run().map_or(Method::Auto, |run| run.method);
    let driven =
        !scenario.torques().is_empty() || !scenario.wheels().is_empty() || !scenario.events().is_empty();
    scenario.prescribed().is_none() && (driven || !matches!(method, Method::Auto | Method::Exact))
}
