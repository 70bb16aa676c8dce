//! A rigid body that rolls, slides and spins on a surface, with one point of contact.
//!
//! The [`BodySurface`] of a body (a sphere, an ellipsoid, the rim of a disk or a hoop, a cylinder that lies) touches the [`Ground`] (a plane, level or not,
//! or turning; the inside or the outside of a sphere or a cylinder). A [`ContactLaw`] says what holds the point of contact: it rolls without slipping, or
//! there is friction, or none. [`ContactSimulation`] computes the motion by collocation where it is smooth and by Taylor series where it is not, with the changes between rolling, sliding and flying
//! ([`ContactChange`]) found on the way. Impacts are not computed: a motion ends where a body comes back to the ground.

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
mod reading;
pub(crate) mod reduced;
mod run;
mod sample;
mod setup;
mod simulation;
mod smooth;
mod start;
mod stepper;
mod surface;
mod trajectory;
mod transition;
mod watch;

pub use change::{ContactChange, ContactEvent, ContactPhase};
pub use ground::{Ground, GroundShape, GroundSide};
pub use law::{ContactLaw, Friction, Grip, Resistance};
pub use reduced::Footing;
pub use sample::ContactSample;
pub use simulation::{Contact, ContactSimulation};
pub use start::{ContactStart, StartVelocity};
pub use surface::{BodySurface, SurfaceShape};
pub use trajectory::{ContactEnding, ContactTrajectory};
