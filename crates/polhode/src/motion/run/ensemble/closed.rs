//! Cached closed forms of an ensemble.

use std::sync::OnceLock;

use super::Member;
use crate::motion::solve::closed_form::ClosedForm;

/// Cached closed form of a member: empty before it was prepared, `None` if the member has none.
#[derive(Clone, Debug, Default)]
pub(super) struct Closed(OnceLock<Option<ClosedForm>>);

impl Closed {
    pub(super) fn of(&self, Member { rotor, torques, start, .. }: &Member) -> Option<&ClosedForm> {
        self.0.get_or_init(|| ClosedForm::of(rotor, torques, *start).ok()).as_ref()
    }
}
