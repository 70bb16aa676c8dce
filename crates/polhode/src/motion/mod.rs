//! Rotational motion of rigid bodies: states in time, and the torques that cause them. This module
//! does not read or write files.
//!
//! A [`Rotor`] is a body with the reference point about which it turns: its centre of mass, or a
//! pivot. With L = I ω + h, I about that point and h the angular momentum of its wheels, Euler's
//! equations are
//!
//! L̇ = L × ω + N,  q̇ = ½ q ω,
//!
//! in body axes, with q the attitude. The torque N is a sum of [`torque::TorqueModel`]s.
//!
//! # Forward dynamics
//! [`Simulation`] computes a [`Trajectory`] from a start; [`Trajectory::compute`] is its short
//! form. [`Method::Auto`] selects the method:
//!
//! - a closed form if one is known ([`FreeMotion`], [`HeavyTop`], [`SwingingBody`]), which gives
//!   the state at any time directly;
//! - Taylor's method if all torques are analytic;
//! - DOP853 otherwise.
//!
//! [`Event`]s are detected along the motion, a [`GlobalError`] is estimated, and an [`Ensemble`]
//! computes many bodies in one call.
//!
//! # Inverse dynamics
//! [`Required`] is the torque N = L̇ − L × ω that a [`Prescribed`] motion requires, and
//! [`ParticleForce`] the force on each particle. A [`Shaft`] turns about a fixed axis and has
//! bearing reactions; a [`Pendulum`] swings about one.
//!
//! # Supported bodies
//! [`contact`] has bodies that roll and slide on the ground, and [`gimbal`] rotors in a Cardan
//! suspension. The same [`Simulation`] computes them. The [`channel`]s of their trajectories have
//! forces, angles and energies.
//!
//! # Scenarios
//! A [`Scenario`] is one body and one motion, as in a scenario file.

pub mod contact;
pub(crate) mod error;
pub mod gimbal;
pub(crate) mod inverse;
pub(crate) mod model;
pub(crate) mod run;
pub(crate) mod solve;
pub(crate) mod task;

pub use error::MotionError;
pub use inverse::prescribed::{AttitudeTable, Prescribed, RateAxes, Turning, Uncertainty};
pub use inverse::required::{ParticleForce, Required};
pub use model::energy::Energy;
pub use model::event::{Crossing, Event, EventAction, Measure, Sense};
pub use model::event_detection::EventSide;
pub use model::event_function::EventFunction;
pub use model::kinematics::{
    KineticEnergySplit, MovingParticle, angular_momentum, momentum, rigid_acceleration, rigid_velocity,
};
pub use model::mass_history::{Exit, MassHistory, MassRates, MassRow, Outflow};
pub use model::orbit::{MU_EARTH, Orbit};
pub use model::orbital_elements::{Anomaly, OrbitalElements};
pub use model::pointing::{Pointing, Reference};
pub use model::rotor::Rotor;
pub use model::state::{State, StateError};
pub use model::state_derivatives::StateDerivatives;
pub use model::state_variables::StateVariables;
pub use model::torque;
pub use model::wheel::{Motor, Wheel};
pub use run::channel::{Channel, Series};
pub use run::channels as channel;
pub use run::derivative_log::CrossingDerivatives;
pub use run::derivatives::TrajectoryDerivatives;
pub use run::ending::{Ending, MethodReason};
pub use run::ensemble::{
    Ensemble, EnsembleOutcome, EnsembleStates, Member, MemberCrossing, MemberFailure, MemberStop,
};
pub use run::estimated_error::GlobalError;
pub use run::global_error::ErrorEffort;
pub use run::sample::Sample;
pub use run::simulation::Simulation;
pub use run::solution::{Solution, Steps};
pub use run::trajectory::Trajectory;
pub use solve::closed_form::ClosedForm;
pub use solve::free::{FreeMotion, FreeMotionDerivatives, FreeMotions, PermanentAxis, Regime};
pub use solve::heavy_top::{HeavyTop, SteadyPrecession, TopPath};
pub use solve::limits::{LOOSEST_TOLERANCE, TIGHTEST_TOLERANCE};
pub use solve::method::Method;
pub use solve::pendulum_motion::PendulumMotion;
pub use solve::propagate::splitting::SplittingOrder;
pub use solve::propagate::step_statistics::StepStatistics;
pub use solve::swinging_body::SwingingBody;
pub use task::asked::{ActingTorque, Forward, GroundContact, Mechanism, Suspension, Task};
pub use task::mounted_shaft::MountedShaft;
pub use task::pendulum::{Pendulum, Swing};
pub use task::run::Run;
pub use task::scenario::Scenario;
pub use task::shaft::{CorrectionMass, Reactions, Shaft, Unbalance};
