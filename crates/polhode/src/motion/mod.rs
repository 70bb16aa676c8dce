//! Motion: states in time, and what moves them. This module reads and writes no files.
//!
//! A [`Rotor`] is a body with the point that it turns about: its centre of mass, or a pivot. With L = I ω + h, I about that point and h the
//! momentum of its wheels, Euler's equations are
//!
//! L̇ = L × ω + N,  q̇ = ½ q ω,
//!
//! in body axes, q the attitude. The torque N is a sum of [`torque::TorqueModel`]s.
//!
//! # From torque to motion
//! [`Simulation`] takes a start to a [`Trajectory`]; [`Trajectory::compute`] is its short form. [`Method::Auto`] takes a closed form where
//! one is known ([`FreeMotion`], [`HeavyTop`], [`SwingingBody`]), which gives the state at any time at once; Taylor's method where all
//! torques are analytic; DOP853 elsewhere. [`Event`]s are found on the way, a [`GlobalError`] is estimated, and an [`Ensemble`] computes
//! many bodies at once.
//!
//! # From motion to torque
//! [`Prescribed`] motions have the torque N = L̇ − L × ω that they need ([`Required`]), and the force that each particle needs
//! ([`ParticleForce`]). A [`Shaft`] is a motion about a fixed axis with the reactions of its bearings; a [`Pendulum`] swings about one.
//!
//! # Bodies that something holds
//! [`contact`] has bodies that roll and slide on the ground, [`gimbal`] rotors in a Cardan suspension. The
//! same [`Simulation`] computes them; [`channel`]s of their trajectories have forces, angles and energies.
//!
//! # A body and its motion in one value
//! A [`Scenario`] is what a scenario file describes.

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
