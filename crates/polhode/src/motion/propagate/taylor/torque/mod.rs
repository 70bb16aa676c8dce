//! Taylor coefficients of torques, principal axes: each model's from those of the motion before it.
//!
//! A model's series has three duties, which the expansion asks for in this order: `start` a step at a state; for each n, give
//! `coefficient` n of the torque, from coefficients up to n of everything that is known; and `extend` its own series to n + 1.

mod drag;
mod formula;
mod gravity_gradient;
mod linear;
mod magnetic;
mod orbit;
mod torsion;

use super::row::{Row, Series, Vectors};
use crate::math::frame::{Principal, Space};
use crate::math::lanes::{Fours, Plain};
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Vector};
use crate::motion::rotor::Rotor;
use crate::motion::torque::{ConstantTorque, TorqueModel};

use drag::DragSeries;
use formula::FormulaSeries;
use gravity_gradient::GravityGradientSeries;
use linear::LinearSeries;
use magnetic::MagneticSeries;
use torsion::TorsionSeries;

/// The series of one torque over one step.
#[derive(Clone, Debug)]
pub(super) enum TorqueSeries {
    /// Constant along the body's axes.
    Body(Row),
    /// Linear in a vector that is constant in space.
    Linear(Box<LinearSeries>),
    GravityGradient(Box<GravityGradientSeries>),
    Drag(Box<DragSeries>),
    Torsion(Box<TorsionSeries>),
    Magnetic(Box<MagneticSeries>),
    Formula(Box<FormulaSeries>),
}

/// The state that a step starts from.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepStart {
    pub(super) time: f64,
    pub(super) attitude: Rotation<Space, Principal>,
    pub(super) omega: AngularVelocity<Principal>,
}

/// Coefficients up to n, principal axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known<'a, S> {
    /// The machine's vectors.
    pub(super) s: S,
    /// ω
    pub(super) omega: &'a Vectors,
    /// Ω, at which the axes turn: ω unless friction inside the body makes a difference.
    pub(super) turning: &'a Vectors,
    /// The turn since the start of the step, (w, x, y, z).
    pub(super) turn: &'a Series,
}

impl<'a, S> Known<'a, S> {
    /// The same without vectors.
    #[inline(always)]
    fn plain(&self) -> Known<'a, Plain> {
        Known { s: Plain, omega: self.omega, turning: self.turning, turn: self.turn }
    }
}

impl TorqueSeries {
    /// `None` for what is no torque from outside.
    pub(super) fn of(model: &TorqueModel, rotor: &Rotor) -> Option<Self> {
        let to_principal = rotor.principal().rotation().inverse();
        Some(match model {
            TorqueModel::Constant(ConstantTorque::Body(n)) => Self::Body(row(to_principal * *n)),
            TorqueModel::Thruster(thruster) => Self::Body(row(to_principal * thruster.torque(rotor))),
            TorqueModel::Constant(ConstantTorque::Space(n)) => {
                Self::Linear(Box::new(LinearSeries::constant(*n, rotor)))
            }
            TorqueModel::Gravity(gravity) => Self::Linear(Box::new(LinearSeries::gravity(gravity, rotor))),
            TorqueModel::GravityGradient(model) => {
                Self::GravityGradient(Box::new(GravityGradientSeries::of(model, rotor)))
            }
            TorqueModel::Drag(model) => Self::Drag(Box::new(DragSeries::of(model, rotor))),
            TorqueModel::Torsion(model) => Self::Torsion(Box::new(TorsionSeries::of(model, rotor))),
            TorqueModel::Magnetic(model) => Self::Magnetic(Box::new(MagneticSeries::of(model, rotor))),
            TorqueModel::Formula(model) => Self::Formula(Box::new(FormulaSeries::of(model, rotor))),
            // A piece holds no schedules, and friction inside is no torque.
            TorqueModel::EnergySink(_) | TorqueModel::Scheduled(_) => return None,
        })
    }

    /// Starts a step.
    pub(super) fn start(&mut self, at: &StepStart) {
        match self {
            Self::Body(_) => {}
            Self::Linear(series) => series.start(at),
            Self::GravityGradient(series) => series.start(at),
            Self::Drag(series) => series.start(at),
            Self::Torsion(series) => series.start(at),
            Self::Magnetic(series) => series.start(at),
            Self::Formula(series) => series.start(at),
        }
    }

    /// The longest step that the series is good for, s, where its coefficients do not show it.
    pub(super) fn reach(&self) -> f64 {
        match self {
            Self::Drag(series) => series.reach(),
            _ => f64::INFINITY,
        }
    }

    /// Coefficient n of N, once everything that is known is so up to n.
    #[inline(always)]
    pub(super) fn coefficient<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) -> Row {
        match self {
            Self::Body(torque) if n == 0 => *torque,
            Self::Body(_) => Row::ZERO,
            Self::Linear(series) => series.coefficient(n),
            Self::GravityGradient(series) => series.coefficient(n, known),
            Self::Drag(series) => series.coefficient(n, known),
            // What is long stays out of the loop over n: all of it would be prepared for each n.
            Self::Torsion(series) => series.coefficient(n, &known.plain()),
            Self::Magnetic(series) => series.coefficient(n, &known.plain()),
            Self::Formula(series) => series.coefficient(n, &known.plain()),
        }
    }

    /// Finds what coefficient n + 1 needs beside the motion.
    #[inline(always)]
    pub(super) fn extend<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) {
        match self {
            // All that these need is the motion.
            Self::Body(_) | Self::Drag(_) | Self::Torsion(_) | Self::Formula(_) => {}
            Self::Linear(series) => series.extend(n, known),
            Self::GravityGradient(series) => series.extend(n, known),
            Self::Magnetic(series) => series.extend(n, &known.plain()),
        }
    }
}

pub(super) fn row<Q>(v: Vector<Q, Principal>) -> Row {
    let [x, y, z] = v.to_array();
    Row([x, y, z, 0.0])
}
