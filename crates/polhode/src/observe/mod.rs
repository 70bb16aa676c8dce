//! Observables of a motion: quantities derived from it without integration.
//!
//! - Accuracy of a computed motion: [`Drift`] of energy and momentum.
//! - Free motion: [`FreeRegime`] (kind, periods, flips), [`JacobiForm`] (ω(t) in elliptic
//!   functions), [`GeometricPhase`], [`SymmetricTop`], [`Cones`], and curves for drawing:
//!   [`Polhode`], [`Herpolhode`], [`MomentumTrace`], [`RollingCones`].
//! - Stability of steady motions: [`Stability`] of permanent rotations, with internal friction;
//!   [`SmallOscillations`] about equilibria under torque, on orbits and of tops; [`Libration`];
//!   [`LeastEnergySpin`], the final state under dissipation; [`SteadyOnGround`], for bodies that
//!   roll and spin on level ground.
//! - Observed quantities: [`TumblingPeriods`] of an asteroid and the inverse problem
//!   ([`TumblingSolution`]); [`RotationalConstants`] of a molecule.

pub(crate) mod cone;
pub(crate) mod curve;
pub(crate) mod drift;
pub(crate) mod geometric_phase;
pub(crate) mod herpolhode;
pub(crate) mod jacobi_form;
pub(crate) mod least_energy;
pub(crate) mod libration;
pub(crate) mod momentum_trace;
pub(crate) mod on_ground;
pub(crate) mod polhode;
mod polhode_family;
pub(crate) mod regime;
pub(crate) mod rolling_cones;
pub(crate) mod rotational_constants;
mod sampling;
pub(crate) mod small_oscillations;
pub(crate) mod stability;
pub(crate) mod symmetric_top;
pub(crate) mod tumbler;
pub(crate) mod tumbling;

pub use cone::Cones;
pub use curve::{Curve, CurveError};
pub use drift::Drift;
pub use geometric_phase::GeometricPhase;
pub use herpolhode::Herpolhode;
pub use jacobi_form::{JacobiForm, JacobiFunction};
pub use least_energy::LeastEnergySpin;
pub use libration::Libration;
pub use momentum_trace::MomentumTrace;
pub use on_ground::{
    BallInBowl, BallOnPlane, CirclingDisk, EndState, Place, RattleMode, Rattleback, SlipEnd, SpinInterval,
    SpinningEgg, StableSpins, SteadyMode, SteadyOnGround, SteadyPath, TippeTop, UprightWheel, VertexSpin,
};
pub use polhode::Polhode;
pub use regime::FreeRegime;
pub use rolling_cones::RollingCones;
pub use rotational_constants::{RotationalConstants, Top};
pub use small_oscillations::{OrbitalEquilibrium, OscillationMode, SmallOscillations, SteadyTop};
pub use stability::{DissipativeLimit, PermanentRotation, Stability};
pub use symmetric_top::{SymmetricTop, SymmetricTopKind};
pub use tumbler::{TumblerError, TumblingSolution};
pub use tumbling::{AxisConvention, TumblingPeriods};
