//! Properties of members that later calls use again.

use std::sync::{Arc, OnceLock};

use super::Member;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::free::{FreeBody, FreeMotion};
use crate::motion::solve::propagate::taylor::{Acting, BatchBody};

/// Closed form and decomposed torques of a member: empty before they were prepared, `None` if the
/// member has none.
#[derive(Clone, Debug, Default)]
pub(super) struct Prepared {
    closed: OnceLock<Option<ClosedForm>>,
    acting: OnceLock<Option<Arc<Acting>>>,
}

impl Prepared {
    /// Returns the closed form. `body`: that of the member before, whose axes are used again if
    /// this member has the same body.
    pub(super) fn closed(&self, member: &Member, body: &mut Option<FreeBody>) -> Option<&ClosedForm> {
        self.closed.get_or_init(|| closed_form(member, body)).as_ref()
    }

    /// Returns the decomposed torques, if they have a series. `last`: the member before, whose
    /// torques are used again if this member has equal ones.
    pub(super) fn acting(&self, member: &Member, last: Option<&BatchBody<'_>>) -> Option<&Arc<Acting>> {
        let Member { rotor, torques, .. } = member;
        let acting = || {
            let again = last.and_then(|last| last.acting_if_equal(rotor, torques));
            again.or_else(|| Acting::of(rotor, torques))
        };
        self.acting.get_or_init(acting).as_ref()
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
