//! A torque that acts at its times only.

use super::TorqueModel;
use super::schedule::Schedule;

/// A torque and when it acts: the integrators stop at each change, so that no step goes across one.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheduled {
    /// What acts.
    pub torque: TorqueModel,
    /// When.
    pub schedule: Schedule,
}
