//! What became of the members of an ensemble.

use super::member::{MemberCrossing, MemberFailure, MemberStop};
use super::motion::MemberMotion;
use crate::motion::run::ending::Ending;

/// What became of the members of an ensemble on their way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EnsembleOutcome {
    /// Those that could go no further, ascending.
    pub failures: Vec<MemberFailure>,
    /// Those that an event stopped, ascending.
    pub stops: Vec<MemberStop>,
    /// The events that happened, those that stopped a member too: member by member, and in the order of time within each.
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

    /// Adds what became of other members.
    pub(super) fn extend(&mut self, other: Self) {
        self.failures.extend(other.failures);
        self.stops.extend(other.stops);
        self.crossings.extend(other.crossings);
    }

    /// In the order of the members; of one member nothing changes its place.
    pub(super) fn sorted(mut self) -> Self {
        self.failures.sort_by_key(|failure| failure.member);
        self.stops.sort_by_key(|stop| stop.member);
        self.crossings.sort_by_key(|crossing| crossing.member);
        self
    }
}
