//! Closed forms that an ensemble keeps.

use std::sync::OnceLock;

use super::Member;
use crate::motion::solve::closed_form::ClosedForm;

/// The closed form of a member, once it was prepared, if there is one.
#[derive(Clone, Debug, Default)]
pub(super) struct Closed(OnceLock<Option<ClosedForm>>);

impl Closed {
    pub(super) fn of(&self, Member { rotor, torques, start, .. }: &Member) -> Option<&ClosedForm> {
        self.0.get_or_init(|| ClosedForm::of(rotor, torques, *start).ok()).as_ref()
    }
}
