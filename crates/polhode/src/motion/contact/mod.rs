//! Rigid bodies that roll, slide and spin on a surface, with a single point of contact.
//!
//! The [`BodySurface`] of a body touches the [`Ground`]. A body surface is a sphere, an ellipsoid,
//! the rim of a disk or hoop, or a lying cylinder. The ground is a plane, level, inclined or
//! turning, or the inside or outside of a sphere or a cylinder. A [`ContactLaw`] states if the
//! contact never slips, or has friction, or is frictionless.
//!
//! [`Simulation::on_ground`](crate::motion::Simulation::on_ground) computes the motion: by
//! collocation where it is smooth, and by Taylor series elsewhere. It detects the changes between
//! rolling, sliding and flying ([`ContactChange`]). Impacts are not modelled: a motion ends when a
//! flying body reaches the ground.

mod arrangement;
mod change;
mod dual;
mod equations;
mod flight;
mod geometry;
mod ground;
mod law;
mod model;
mod onset;
mod phase;
pub(crate) mod problem;
mod reading;
pub(crate) mod reduced;
mod setup;
mod smooth;
mod start;
mod state;
mod stepper;
mod surface;
pub(crate) mod system;
mod transition;
mod watch;

pub use arrangement::Contact;
pub use change::{ContactChange, ContactEvent, ContactPhase};
pub use ground::{Ground, GroundShape, GroundSide};
pub use law::{ContactLaw, Friction, Grip, Resistance};
pub use reduced::Footing;
pub use start::{ContactStart, StartVelocity};
pub use state::ContactState;
pub use surface::{BodySurface, SurfaceShape};
