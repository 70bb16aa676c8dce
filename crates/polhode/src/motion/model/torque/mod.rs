//! Torques: a sum of small models, each in its own file.

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
pub(crate) mod parameter;
pub(crate) mod polynomial;
pub(crate) mod recorder;
pub(crate) mod scheduled;
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

/// The list of all models: the type, and what the solvers ask of each.
macro_rules! models {
    ($($(#[$doc:meta])* $variant:ident($type:ty): $model:ty,)*) => {
        /// One cause of torque about the point that the body turns about.
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
    /// Constant along body or space axes.
    Constant(ConstantTorque): ConstantTorque,
    /// The weight of a body held at a pivot.
    Gravity(UniformGravity): UniformGravity,
    /// Gravity that differs from one end of an orbiting body to the other.
    GravityGradient(Box<GravityGradient>): GravityGradient,
    /// Resistance to turning.
    Drag(Drag): Drag,
    /// A torsion spring or wire.
    Torsion(Torsion): Torsion,
    /// A magnet in a field.
    Magnetic(Box<Magnetic>): Magnetic,
    /// A force fixed to the body.
    Thruster(Thruster): Thruster,
    /// Energy lost inside the body.
    EnergySink(EnergySink): EnergySink,
    /// Given by formulas.
    Formula(Box<FormulaTorque>): FormulaTorque,
    /// A polynomial in time.
    Polynomial(TimePolynomial): TimePolynomial,
    /// From a table.
    Tabulated(Box<Tabulated>): Tabulated,
    /// A law or a function of the user of this crate.
    Own(OwnTorque): OwnTorque,
    /// Another one, at its times only.
    Scheduled(Box<Scheduled>): Scheduled,
}

impl TorqueModel {
    /// A law of the user of this crate, by a name.
    pub fn own(name: &'static str, law: impl Law + fmt::Debug + Send + Sync + 'static) -> Self {
        Self::Own(OwnTorque::law(name, law))
    }

    /// Any function of the body and its state that gives N in body axes, N·m, by a name. It has no power series: DOP853 integrates it.
    pub fn function(
        name: &'static str,
        torque: impl Fn(&Rotor, &State) -> Torque<Body> + Send + Sync + 'static,
    ) -> Self {
        Self::Own(OwnTorque::function(name, torque))
    }

    /// As [`TorqueModel::function`], of many bodies in their states at once: it gives a torque for each of them, in their order, which must not depend on what
    /// others there are beside one. An [`Ensemble`](crate::motion::Ensemble) calls it once for each stage of the steps of all of its members.
    pub fn vectorized_function(
        name: &'static str,
        torques: impl Fn(&[MemberState<'_>]) -> Vec<Torque<Body>> + Send + Sync + 'static,
    ) -> Self {
        Self::Own(OwnTorque::vectorized(name, torques))
    }

    /// The torque on the body in a state, body axes, N·m. What acts inside the body only is none.
    pub fn torque(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        self.model().value(rotor, state)
    }

    /// The potential energy whose loss is this torque's work, J; `None` if it has none.
    pub fn potential(&self, rotor: &Rotor, state: &State) -> Option<f64> {
        self.model().potential(rotor, state)
    }

    /// The size that its rounding is relative to, N·m.
    pub(crate) fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.model().scale(rotor, state)
    }

    /// α of an energy sink, 1/(N·m·s); zero for everything else.
    pub(crate) fn sink(&self) -> f64 {
        self.model().sink()
    }

    /// The names of its numbers that motions can be differentiated by, beside "factor", which is what all of it is multiplied by.
    pub fn parameters(&self) -> &'static [&'static str] {
        self.model().parameters()
    }

    /// The name in scenario files and summaries.
    pub fn name(&self) -> &'static str {
        self.model().name()
    }

    /// When it begins or ends next after a time, s; infinite if it does not.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        match self {
            Self::Scheduled(model) => model.schedule.next_change(time).min(model.torque.next_change(time)),
            Self::Tabulated(table) => table.next_change(time),
            _ => f64::INFINITY,
        }
    }

    /// Is it unknown what it does to a body whose mass changes?
    pub(crate) fn needs_constant_mass(&self) -> bool {
        match self {
            Self::Scheduled(model) => model.torque.needs_constant_mass(),
            Self::GravityGradient(gravity) => matches!(gravity.attracted, Attracted::Points(_)),
            Self::EnergySink(_) => true,
            _ => false,
        }
    }

    /// How many pulses begin after a time and no later than another.
    pub(crate) fn pulses_between(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Scheduled(model) => {
                model.schedule.pulses_between(from, to) + model.torque.pulses_between(from, to)
            }
            _ => 0.0,
        }
    }

    /// What it is just after a time, until the next change; `None` if it does not act then.
    pub(crate) fn acting(&self, time: f64) -> Option<&Self> {
        match self {
            Self::Scheduled(model) if model.schedule.is_on(time) => model.torque.acting(time),
            Self::Scheduled(_) => None,
            Self::Tabulated(table) => table.piece(time),
            model => Some(model),
        }
    }

    /// Does it act just after a time? A torque with a schedule or a table does so at its times only.
    pub fn acts_at(&self, time: f64) -> bool {
        self.acting(time).is_some()
    }

    /// Does it begin, end or become another law at given times?
    pub(crate) const fn is_timed(&self) -> bool {
        matches!(self, Self::Scheduled(_) | Self::Tabulated(_))
    }
}

/// The sum of torques, body axes, N·m.
pub(crate) fn total_torque<'a>(
    models: impl IntoIterator<Item = &'a TorqueModel>,
    rotor: &Rotor,
    state: &State,
) -> Torque<Body> {
    models.into_iter().fold(Torque::ZERO, |sum, model| sum + model.torque(rotor, state))
}

/// The sum of all potentials, J; `None` if some torque has none (or there is no torque), or if a motor
/// does work on the body.
pub(crate) fn total_potential(models: &[TorqueModel], rotor: &Rotor, state: &State) -> Option<f64> {
    if rotor.wheels().iter().any(Wheel::is_driven) {
        return None;
    }
    let (first, others) = models.split_first()?;
    others
        .iter()
        .try_fold(first.potential(rotor, state)?, |sum, model| Some(sum + model.potential(rotor, state)?))
}
