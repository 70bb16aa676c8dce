//! Cached closed forms of an ensemble.

use std::sync::OnceLock;

use super::Member;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::free::{FreeBody, FreeMotion};

/// Cached closed form of a member: empty before it was prepared, `None` if the member has none.
#[derive(Clone, Debug, Default)]
pub(super) struct Closed(OnceLock<Option<ClosedForm>>);

impl Closed {
    /// Returns the closed form. `body`: that of the member before, whose axes are used again if
    /// this member has the same body.
    pub(super) fn of(&self, member: &Member, body: &mut Option<FreeBody>) -> Option<&ClosedForm> {
        self.0.get_or_init(|| closed_form(member, body)).as_ref()
    }
}

fn closed_form(
    Member { rotor, torques, start, .. }: &Member,
    body: &mut Option<FreeBody>,
) -> Option<ClosedForm> {
    if !torques.is_empty() {
        return ClosedForm::of(rotor, torques, *start).ok();
    }
    if !body.is_some_and(|body| body.is_of(rotor)) {
        *body = FreeBody::of(rotor).ok();
    }
    FreeMotion::of_body(body.as_ref()?, *start).ok().map(|motion| ClosedForm::Free(Box::new(motion)))
}
