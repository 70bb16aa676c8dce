//! Channels of trajectories, for [`Trajectory::channel`](crate::motion::Trajectory::channel).

pub(super) mod gimbals;
pub(super) mod ground;

use super::channel::Channel;
use crate::motion::model::energy::Energy;

pub use gimbals::{AXIS_ANGLES, AXIS_RATES, GIMBALS};
pub use ground::{
    CONTACT, CONTACT_POINT, FRICTION, FRICTION_WORK, GROUND_WORK, NORMAL_FORCE, POSITION, SLIP,
};

/// Energy of any system, and the work done on it since the start.
pub const ENERGY: Channel<Energy> =
    Channel::new("energy", "", "energy, and work since the start", |row| Some(row.energy()));
