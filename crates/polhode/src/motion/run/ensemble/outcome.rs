//! Outcome of the members of an ensemble.

use super::member::{MemberCrossing, MemberFailure, MemberStop};
use super::motion::MemberMotion;
use crate::motion::run::ending::Ending;

/// Failures, stops and events of the members of an ensemble.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EnsembleOutcome {
    /// Members that failed, ascending.
    pub failures: Vec<MemberFailure>,
    /// Members that an event stopped, ascending.
    pub stops: Vec<MemberStop>,
    /// Events that happened, including those that stopped a member. Order: by member, and by time
    /// within each member.
    pub crossings: Vec<MemberCrossing>,
}

impl EnsembleOutcome {
    /// Adds the events and the ending of a member.
    pub(super) fn add(&mut self, member: usize, MemberMotion { crossings, ending, .. }: MemberMotion) {
        self.crossings.extend(crossings.into_iter().map(|crossing| MemberCrossing { member, crossing }));
        match ending {
            Ending::Complete | Ending::Contact { .. } => {}
            Ending::Stopped { event, time } => self.stops.push(MemberStop { member, event, time }),
            Ending::Failed { cause, .. } => self.failures.push(MemberFailure { member, cause }),
        }
    }

    /// Adds the outcome of other members.
    pub(super) fn extend(&mut self, other: Self) {
        self.failures.extend(other.failures);
        self.stops.extend(other.stops);
        self.crossings.extend(other.crossings);
    }

    /// Sorts by member; the sort is stable.
    pub(super) fn sorted(mut self) -> Self {
        self.failures.sort_by_key(|failure| failure.member);
        self.stops.sort_by_key(|stop| stop.member);
        self.crossings.sort_by_key(|crossing| crossing.member);
        self
    }
}
