//! Taylor coefficients of torques, principal axes: each model's from those of the motion before it.
//!
//! A model's series has four duties: `set` what the model of a lane's body says; then, as the expansion asks for them, `start` a step of a
//! lane at a state; for each n, give `coefficient` n of the torque, from coefficients up to n of everything that is known; and `extend`
//! its own series to n + 1.

mod affine;
mod drag;
mod formula;
mod gravity_gradient;
mod linear;
mod magnetic;
mod orbit;
mod torsion;

use super::recurrence::{Motion, Terms};
use super::row::{Row, Vectors};
use super::sums::Sums;
use crate::math::frame::{Principal, Space};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;
use crate::motion::rotor::Rotor;
use crate::motion::torque::{Attracted, ConstantTorque, DragLaw, MagneticField, TorqueModel};

pub(super) use affine::{Affine, split};
use drag::DragSeries;
use formula::FormulaSeries;
use gravity_gradient::GravityGradientSeries;
use linear::LinearSeries;
use magnetic::MagneticSeries;
use torsion::TorsionSeries;

/// The series of one torque over one step, if it is not among the [`Affine`].
#[derive(Clone, Debug)]
pub(super) enum TorqueSeries<N = f64> {
    /// Linear in a vector that is constant in space.
    Linear(Box<LinearSeries<N>>),
    GravityGradient(Box<GravityGradientSeries<N>>),
    Drag(Box<DragSeries<N>>),
    Torsion(Box<TorsionSeries<N>>),
    Magnetic(Box<MagneticSeries<N>>),
    /// Lane by lane: formulas have branches.
    Formula(Vec<Option<FormulaSeries>>),
}

/// The state that a step starts from.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepStart<N = f64> {
    pub(super) time: N,
    /// The quaternion of the principal axes.
    pub(super) attitude: Row<N>,
    /// Principal axes; and what rounding left of it.
    pub(super) omega: Row<N>,
    pub(super) omega_low: Row<N>,
}

impl<N: Number> StepStart<N> {
    /// Time and attitude of a lane.
    fn lane(&self, lane: usize) -> (f64, Rotation<Space, Principal>) {
        (self.time.lane(lane), Rotation::from_unit(self.attitude.lane(lane).0))
    }

    /// A vector of space along the principal axes, v + 2w (u × v) + 2 u × (u × v): as the product with a [`Rotation`] has it.
    #[inline(always)]
    fn seen(&self, v: Row<N>) -> Row<N> {
        let [w, x, y, z] = self.attitude.0;
        let two = Row::splat(w.like(2.0));
        let u = Row([-x, -y, -z, w.like(0.0)]);
        let t = cross(u, v) * two;
        v + t * Row::splat(w) + cross(u, t)
    }
}

/// a × b
#[inline(always)]
fn cross<N: Number>(a: Row<N>, b: Row<N>) -> Row<N> {
    let ([a1, a2, a3, zero], [b1, b2, b3, _]) = (a.0, b.0);
    Row([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1, zero])
}

/// Coefficients up to n, principal axes.
#[derive(Clone, Copy)]
pub(super) struct Known<'a, M: Sums> {
    /// How sums are done.
    pub(super) s: M,
    /// ω
    pub(super) omega: &'a Vectors<M::N>,
    /// Ω, at which the axes turn: ω unless friction inside the body makes a difference.
    pub(super) turning: &'a Vectors<M::N>,
    /// With the turn since the start of the step.
    pub(super) motion: &'a Motion<M::N>,
}

impl<'a, M: Sums> Known<'a, M> {
    /// Coefficient n of the turn since the start of the step.
    #[inline(always)]
    fn turn(&self, n: usize) -> Row<M::N> {
        self.motion[n].x.first()
    }

    /// Runs what is long apart.
    #[inline(always)]
    fn apart<R>(&self, work: impl FnOnce(&Known<'a, M>) -> R) -> R {
        let Self { omega, turning, motion, .. } = *self;
        self.s.apart(
            #[inline(always)]
            |s| work(&Known { s, omega, turning, motion }),
        )
    }
}

/// What the torques of bodies side by side have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Shape {
    Body,
    Linear,
    GravityGradient { is_circular: bool, points: Option<usize>, has_wheels: bool },
    Drag { is_quadratic: bool },
    Torsion { is_wire: bool },
    Magnetic { orbit_is_circular: Option<bool> },
    Formula,
}

impl Shape {
    /// That of a torque from outside, without a schedule.
    pub(super) fn of(model: &TorqueModel, rotor: &Rotor) -> Self {
        match model {
            TorqueModel::Constant(ConstantTorque::Space(_)) | TorqueModel::Gravity(_) => Self::Linear,
            TorqueModel::GravityGradient(model) => Self::GravityGradient {
                is_circular: model.orbit.is_circular(),
                points: match &model.attracted {
                    Attracted::Tensor => None,
                    Attracted::Points(points) => Some(points.len()),
                },
                has_wheels: gravity_gradient::has_wheels(rotor),
            },
            TorqueModel::Drag(model) => Self::Drag { is_quadratic: model.law() == DragLaw::Quadratic },
            TorqueModel::Torsion(model) => Self::Torsion { is_wire: model.axis().is_some() },
            TorqueModel::Magnetic(model) => Self::Magnetic {
                orbit_is_circular: match &model.field {
                    MagneticField::Uniform(_) => None,
                    MagneticField::Dipole { orbit, .. } => Some(orbit.is_circular()),
                },
            },
            TorqueModel::Formula(_) => Self::Formula,
            TorqueModel::Constant(ConstantTorque::Body(_))
            | TorqueModel::Thruster(_)
            | TorqueModel::EnergySink(_)
            | TorqueModel::Scheduled(_) => Self::Body,
        }
    }
}

/// The torques from outside: friction inside the body is none. (And a piece holds no schedules.)
pub(super) fn from_outside<'a>(torques: &[&'a TorqueModel]) -> impl Iterator<Item = &'a TorqueModel> {
    torques.iter().copied().filter(|model| !matches!(model, TorqueModel::EnergySink(_)))
}

impl<N: Number> TorqueSeries<N> {
    /// For all bodies with a model of this kind; `None` for what is always affine.
    pub(super) fn of(zero: N, model: &TorqueModel, rotor: &Rotor) -> Option<Self> {
        Some(match model {
            TorqueModel::Constant(ConstantTorque::Space(_)) | TorqueModel::Gravity(_) => {
                Self::Linear(Box::new(LinearSeries::all(zero)))
            }
            TorqueModel::GravityGradient(model) => {
                Self::GravityGradient(Box::new(GravityGradientSeries::of(zero, model, rotor)))
            }
            TorqueModel::Drag(_) => Self::Drag(Box::new(DragSeries::all(zero))),
            TorqueModel::Torsion(model) => Self::Torsion(Box::new(TorsionSeries::of(zero, model))),
            TorqueModel::Magnetic(model) => Self::Magnetic(Box::new(MagneticSeries::of(zero, model))),
            TorqueModel::Formula(_) => Self::Formula(vec![None; N::LANES]),
            TorqueModel::Constant(ConstantTorque::Body(_))
            | TorqueModel::Thruster(_)
            | TorqueModel::EnergySink(_)
            | TorqueModel::Scheduled(_) => return None,
        })
    }

    /// What a lane's body has; a model of this kind.
    pub(super) fn set(&mut self, lane: usize, model: &TorqueModel, rotor: &Rotor) {
        match (self, model) {
            (Self::Linear(series), model) => series.set_model(lane, model, rotor),
            (Self::GravityGradient(series), TorqueModel::GravityGradient(model)) => {
                series.set(lane, model, rotor);
            }
            (Self::Drag(series), TorqueModel::Drag(model)) => series.set(lane, model, rotor),
            (Self::Torsion(series), TorqueModel::Torsion(model)) => series.set(lane, model, rotor),
            (Self::Magnetic(series), TorqueModel::Magnetic(model)) => series.set(lane, model, rotor),
            (Self::Formula(series), TorqueModel::Formula(model)) => {
                series[lane] = Some(FormulaSeries::of(model, rotor));
            }
            _ => {}
        }
    }

    /// Starts a step.
    #[inline(always)]
    pub(super) fn start(&mut self, at: &StepStart<N>) {
        match self {
            Self::Linear(series) => series.start(at),
            Self::GravityGradient(series) => series.start(at),
            Self::Drag(series) => series.start(at),
            Self::Torsion(series) => series.start(at),
            Self::Magnetic(series) => series.start(at),
            Self::Formula(series) => {
                for (lane, series) in series.iter_mut().enumerate() {
                    let (time, attitude) = at.lane(lane);
                    series.iter_mut().for_each(|series| series.start(time, attitude));
                }
            }
        }
    }

    /// True if it has a vector of space that can be expanded beside the turn.
    pub(super) fn can_ride(&self) -> bool {
        matches!(self, Self::GravityGradient(_))
    }

    /// True if it and its vector, which moves in space, can be left to the recurrence.
    pub(super) fn moves(&self) -> bool {
        matches!(self, Self::GravityGradient(series) if series.is_simple())
    }

    /// What the recurrence then needs.
    pub(super) fn give(&self, terms: &mut Terms<N>, lane: usize, inverses: Row) {
        if let Self::GravityGradient(series) = self {
            series.give(terms, lane, inverses);
        }
    }

    /// Coefficient n of the vector, from the recurrence.
    pub(super) fn know(&mut self, n: usize, vector: Row<N>) {
        if let Self::GravityGradient(series) = self {
            series.know(n, vector);
        }
    }

    /// That vector at the start of a step, and its rate in space.
    #[inline(always)]
    pub(super) fn carried(&self) -> Option<[Row<N>; 2]> {
        match self {
            Self::GravityGradient(series) => Some(series.carried()),
            _ => None,
        }
    }

    /// The longest step that the series is good for, s, where its coefficients do not show it.
    #[inline(always)]
    pub(super) fn reach(&self, endless: N) -> N {
        match self {
            Self::Drag(series) => series.reach(endless),
            _ => endless,
        }
    }

    /// Coefficient n of N, once everything that is known is so up to n.
    #[inline(always)]
    pub(super) fn coefficient<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) -> Row<N> {
        match self {
            Self::Linear(series) => series.coefficient(n),
            Self::GravityGradient(series) => series.coefficient(n, known),
            Self::Drag(series) => series.coefficient(n, known),
            Self::Torsion(series) => known.apart(
                #[inline(always)]
                |known| series.coefficient(n, known),
            ),
            Self::Magnetic(series) => known.apart(
                #[inline(always)]
                |known| series.coefficient(n, known),
            ),
            Self::Formula(series) => {
                let (omega, turn) = (known.omega.rows[n], known.turn(n));
                let mut torque = Row::splat(omega.0[0].like(0.0));
                for (lane, series) in series.iter_mut().enumerate() {
                    if let Some(series) = series {
                        torque.put(lane, series.coefficient(n, omega.lane(lane), turn.lane(lane)));
                    }
                }
                torque
            }
        }
    }

    /// Finds what coefficient n + 1 needs beside the motion. If its vector of space is expanded beside the turn, it is given with
    /// coefficient n + 1 as v × Ω alone makes it, and returned as it is.
    #[inline(always)]
    pub(super) fn extend<M: Sums<N = N>>(
        &mut self,
        n: usize,
        known: &Known<'_, M>,
        turned: Option<Row<N>>,
    ) -> Option<Row<N>> {
        match self {
            // All that these need is the motion.
            Self::Drag(_) | Self::Torsion(_) | Self::Formula(_) => {}
            Self::Linear(series) => series.extend(n, known),
            Self::GravityGradient(series) => return Some(series.extend(n, known, turned)),
            Self::Magnetic(series) => known.apart(
                #[inline(always)]
                |known| series.extend(n, known),
            ),
        }
        None
    }
}

pub(super) fn row<Q, F>(v: Vector<Q, F>) -> Row {
    let [x, y, z] = v.to_array();
    Row([x, y, z, 0.0])
}
