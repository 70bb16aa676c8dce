//! Torques: a sum of models, each in its own file.

pub(crate) mod changing;
mod condensed;
pub(crate) mod constant;
pub(crate) mod drag;
pub(crate) mod energy_sink;
pub(crate) mod formula;
pub(crate) mod graph;
pub(crate) mod gravity;
pub(crate) mod gravity_gradient;
pub(crate) mod jacobian;
pub(crate) mod linearization;
pub(crate) mod magnetic;
pub(crate) mod model;
pub(crate) mod own;
mod packed;
pub(crate) mod parameter;
pub(crate) mod polynomial;
pub(crate) mod recorder;
pub(crate) mod scheduled;
pub(crate) mod separated;
pub(crate) mod tabulated;
pub(crate) mod tangent;
pub(crate) mod thruster;
pub(crate) mod time_polynomial;
pub(crate) mod torsion;
pub(crate) mod variation;
pub(crate) mod varied;

use core::fmt;

use model::Model;

use super::rotor::Rotor;
use super::state::State;
use super::wheel::Wheel;
use crate::math::frame::Body;
use crate::math::vector::Torque;

pub use super::law::{Law, LawInput, OrbitPosition};
pub use super::schedule::Schedule;
pub use constant::ConstantTorque;
pub use drag::{Drag, DragLaw};
pub use energy_sink::EnergySink;
pub use formula::FormulaTorque;
pub use gravity::UniformGravity;
pub use gravity_gradient::{Attracted, GravityGradient};
pub use jacobian::TorqueJacobian;
pub use magnetic::{Magnetic, MagneticField};
pub use own::{MemberState, OwnTorque};
pub use parameter::TorqueParameter;
pub use scheduled::Scheduled;
pub use tabulated::{Interpolation, Tabulated};
pub use thruster::Thruster;
pub use time_polynomial::{TimePolynomial, TorqueAxes};
pub use torsion::Torsion;

/// List of all models: the type of each, and its `Model` for the solvers.
macro_rules! models {
    ($($(#[$doc:meta])* $variant:ident($type:ty): $model:ty,)*) => {
        /// One torque about the rotor's reference point (centre of mass or pivot).
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum TorqueModel {
            $($(#[$doc])* $variant($type),)*
        }

        impl TorqueModel {
            pub(in crate::motion) fn model(&self) -> &dyn Model {
                match self {
                    $(Self::$variant(model) => {
                        let model: &$model = model;
                        model
                    })*
                }
            }
        }
    };
}

models! {
    /// Torque constant along body or space axes.
    Constant(ConstantTorque): ConstantTorque,
    /// Weight of a body held at a pivot.
    Gravity(UniformGravity): UniformGravity,
    /// Gravity gradient on an orbiting body.
    GravityGradient(Box<GravityGradient>): GravityGradient,
    /// Drag that opposes rotation.
    Drag(Drag): Drag,
    /// Torsion spring or wire.
    Torsion(Torsion): Torsion,
    /// Magnetic moment in a magnetic field.
    Magnetic(Box<Magnetic>): Magnetic,
    /// Force fixed to the body.
    Thruster(Thruster): Thruster,
    /// Energy dissipation inside the body.
    EnergySink(EnergySink): EnergySink,
    /// Torque given by formulas.
    Formula(Box<FormulaTorque>): FormulaTorque,
    /// Polynomial in time.
    Polynomial(TimePolynomial): TimePolynomial,
    /// Interpolated table of times and values.
    Tabulated(Box<Tabulated>): Tabulated,
    /// User-supplied law or function.
    Own(OwnTorque): OwnTorque,
    /// Another torque, restricted to the times of a schedule.
    Scheduled(Box<Scheduled>): Scheduled,
}

impl TorqueModel {
    /// Creates a torque from a user-supplied law, with a name.
    pub fn own(name: &'static str, law: impl Law + fmt::Debug + Send + Sync + 'static) -> Self {
        Self::Own(OwnTorque::law(name, law))
    }

    /// Creates a torque from a user-supplied function that returns N in body axes, N·m, with a
    /// name. It has no power series: DOP853 integrates it.
    pub fn function(
        name: &'static str,
        torque: impl Fn(&Rotor, &State) -> Torque<Body> + Send + Sync + 'static,
    ) -> Self {
        Self::Own(OwnTorque::function(name, torque))
    }

    /// Creates a torque from a function of many bodies and states, with a name; see
    /// [`TorqueModel::function`].
    /// The function returns one torque per body, in the same order. Each torque must not depend on
    /// the other bodies. An [`Ensemble`](crate::motion::Ensemble) calls it once per stage of a
    /// step, for all members.
    pub fn vectorized_function(
        name: &'static str,
        torques: impl Fn(&[MemberState<'_>]) -> Vec<Torque<Body>> + Send + Sync + 'static,
    ) -> Self {
        Self::Own(OwnTorque::vectorized(name, torques))
    }

    /// Returns the torque on the body in a state, body axes, N·m. An effect inside the body only
    /// has zero torque.
    pub fn torque(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        self.model().value(rotor, state)
    }

    /// Returns the potential energy of the torque, J; `None` if it has no potential.
    pub fn potential(&self, rotor: &Rotor, state: &State) -> Option<f64> {
        self.model().potential(rotor, state)
    }

    /// Returns the magnitude to which the rounding of the torque is relative, N·m.
    pub(crate) fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.model().scale(rotor, state)
    }

    /// Returns the coefficient α of an energy sink, 1/(N·m·s); zero for all other torques.
    pub(crate) fn sink(&self) -> f64 {
        self.model().sink()
    }

    /// Returns the names of the parameters with respect to which motions can be differentiated. In
    /// addition, "factor" is a multiplier of the whole torque.
    pub fn parameters(&self) -> &'static [&'static str] {
        self.model().parameters()
    }

    /// Returns the name used in scenario files and summaries.
    pub fn name(&self) -> &'static str {
        self.model().name()
    }

    /// Returns the first time after `time` at which the torque begins or ends to act, s; infinite
    /// if there is none.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        match self {
            Self::Scheduled(model) => model.schedule.next_change(time).min(model.torque.next_change(time)),
            Self::Tabulated(table) => table.next_change(time),
            _ => f64::INFINITY,
        }
    }

    /// True if the effect of the torque on a body with changing mass is not defined.
    pub(crate) fn needs_constant_mass(&self) -> bool {
        match self {
            Self::Scheduled(model) => model.torque.needs_constant_mass(),
            Self::GravityGradient(gravity) => matches!(gravity.attracted, Attracted::Points(_)),
            Self::EnergySink(_) => true,
            _ => false,
        }
    }

    /// Returns the number of pulses that begin in the interval (from, to].
    pub(crate) fn pulses_between(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Scheduled(model) => {
                model.schedule.pulses_between(from, to) + model.torque.pulses_between(from, to)
            }
            _ => 0.0,
        }
    }

    /// Returns the torque that acts from just after a time until the next change; `None` if it does
    /// not act then.
    pub(crate) fn acting(&self, time: f64) -> Option<&Self> {
        match self {
            Self::Scheduled(model) if model.schedule.is_on(time) => model.torque.acting(time),
            Self::Scheduled(_) => None,
            Self::Tabulated(table) => table.piece(time),
            model => Some(model),
        }
    }

    /// Returns true if the torque acts just after a time. A torque with a schedule or a table acts
    /// only at certain times.
    pub fn acts_at(&self, time: f64) -> bool {
        self.acting(time).is_some()
    }

    /// True if the torque begins, ends or changes its law at given times.
    pub(crate) const fn is_timed(&self) -> bool {
        matches!(self, Self::Scheduled(_) | Self::Tabulated(_))
    }
}

/// Returns the sum of the torques, body axes, N·m.
pub(crate) fn total_torque<'a>(
    models: impl IntoIterator<Item = &'a TorqueModel>,
    rotor: &Rotor,
    state: &State,
) -> Torque<Body> {
    models.into_iter().fold(Torque::ZERO, |sum, model| sum + model.torque(rotor, state))
}

/// Returns the sum of all potentials, J. `None` if some torque has no potential, if there is no
/// torque, or if a motor does work on the body.
pub(crate) fn total_potential(models: &[TorqueModel], rotor: &Rotor, state: &State) -> Option<f64> {
    if rotor.wheels().iter().any(Wheel::is_driven) {
        return None;
    }
    let (first, others) = models.split_first()?;
    others
        .iter()
        .try_fold(first.potential(rotor, state)?, |sum, model| Some(sum + model.potential(rotor, state)?))
}
