//! What is affine in ω and in one vector that is constant in space, of all torques together.
//!
//! N = c + A v + B ω, v̇ = v × Ω. Constant torques, thrusters, gravity and linear drag are of this kind: most motions need no more, and
//! v is expanded beside the turn.

use super::super::recurrence::Terms;
use super::super::row::Row;
use super::linear::{LinearSeries, times};
use super::{Shape, StepStart, drag, row};
use crate::math::number::Number;
use crate::motion::rotor::Rotor;
use crate::motion::torque::{ConstantTorque, TorqueModel};

/// N = c + A v + B ω.
#[derive(Clone, Debug)]
pub(in super::super) struct Affine<N> {
    seen: Option<LinearSeries<N>>,
    torque: Parts<N>,
    /// The same of N/I.
    acceleration: Parts<N>,
    is_none: bool,
}

/// c + A v + B ω
#[derive(Clone, Copy, Debug)]
struct Parts<N> {
    constant: Row<N>,
    /// Columns of A.
    seen: Option<[Row<N>; 3]>,
    /// Columns of B.
    omega: Option<[Row<N>; 3]>,
}

/// The models that are affine, and all others; only the first vector of space can be.
pub(in super::super) fn split<'a>(
    models: impl Iterator<Item = &'a TorqueModel>,
    rotor: &Rotor,
) -> [Vec<&'a TorqueModel>; 2] {
    let (mut affine, mut others, mut carries) = (Vec::new(), Vec::new(), false);
    for model in models {
        let belongs = match Shape::of(model, rotor) {
            Shape::Body | Shape::Drag { is_quadratic: false } => true,
            Shape::Linear => !core::mem::replace(&mut carries, true),
            _ => false,
        };
        if belongs { affine.push(model) } else { others.push(model) }
    }
    [affine, others]
}

impl<N: Number> Affine<N> {
    pub(in super::super) fn none(zero: N) -> Self {
        let nothing = Parts { constant: Row::splat(zero), seen: None, omega: None };
        Self { seen: None, torque: nothing, acceleration: nothing, is_none: true }
    }

    /// For bodies with models of these kinds.
    pub(in super::super) fn of(zero: N, models: &[&TorqueModel], rotor: &Rotor) -> Self {
        let none = Row::splat(zero);
        let has = |shape: Shape| models.iter().any(|model| Shape::of(model, rotor) == shape);
        let (carries, damped) = (has(Shape::Linear), has(Shape::Drag { is_quadratic: false }));
        let parts =
            Parts { constant: none, seen: carries.then_some([none; 3]), omega: damped.then_some([none; 3]) };
        Self {
            seen: carries.then(|| LinearSeries::all(zero)),
            torque: parts,
            acceleration: parts,
            is_none: models.is_empty(),
        }
    }

    /// What a lane's body has, and the inverses of its moments.
    pub(in super::super) fn set(
        &mut self,
        lane: usize,
        models: &[&TorqueModel],
        rotor: &Rotor,
        inverses: Row,
    ) {
        let to_principal = rotor.principal().rotation().inverse();
        let (mut constant, mut omega) = (Row::ZERO, [Row::ZERO; 3]);
        for model in models {
            match model {
                TorqueModel::Constant(ConstantTorque::Body(n)) => {
                    constant = constant + row(to_principal * *n);
                }
                TorqueModel::Thruster(thruster) => {
                    constant = constant + row(to_principal * thruster.torque(rotor));
                }
                TorqueModel::Drag(drag) => {
                    for (sum, column) in omega.iter_mut().zip(drag::columns(drag, rotor)) {
                        *sum = *sum + column;
                    }
                }
                model => self.seen.iter_mut().for_each(|seen| seen.set_model(lane, model, rotor)),
            }
        }
        let columns = self.seen.as_ref().map(|seen| seen.columns().map(|column| column.lane(lane)));
        let columns = columns.unwrap_or([Row::ZERO; 3]);
        self.torque.put(lane, constant, columns, omega);
        let over = |column: Row| inverses * column;
        self.acceleration.put(lane, over(constant), columns.map(over), omega.map(over));
    }

    /// What the recurrence needs of a lane.
    pub(in super::super) fn give(&self, terms: &mut Terms<N>, lane: usize) {
        let Parts { constant, seen, omega } = &self.acceleration;
        terms.constant.put(lane, constant.lane(lane));
        if let Some(columns) = seen {
            let column = columns.map(|column| column.lane(lane).0);
            for (diagonal, place) in terms.seen.iter_mut().enumerate() {
                let entry = |row: usize| column[(row + diagonal) % 3][row];
                place.put(lane, Row([entry(0), entry(1), entry(2), 0.0]));
            }
        }
        if let Some(columns) = omega {
            terms.is_damped = true;
            for (place, column) in terms.damping.iter_mut().zip(columns) {
                place.put(lane, column.lane(lane));
            }
        }
    }

    pub(in super::super) fn is_none(&self) -> bool {
        self.is_none
    }

    /// True if there is a v.
    #[inline(always)]
    pub(in super::super) fn carries(&self) -> bool {
        self.seen.is_some()
    }

    /// v at the start of a step.
    #[inline(always)]
    pub(in super::super) fn carried(&self, at: &StepStart<N>) -> Option<Row<N>> {
        self.seen.as_ref().map(|seen| seen.carried(at))
    }

    /// Coefficient n of N.
    #[inline(always)]
    pub(in super::super) fn torque(&self, n: usize, v: Row<N>, omega: Row<N>) -> Row<N> {
        self.torque.coefficient(n, v, omega)
    }

    /// Coefficient n of N/I.
    #[inline(always)]
    pub(in super::super) fn acceleration(&self, n: usize, v: Row<N>, omega: Row<N>) -> Row<N> {
        self.acceleration.coefficient(n, v, omega)
    }
}

impl<N: Number> Parts<N> {
    fn put(&mut self, lane: usize, constant: Row, seen: [Row; 3], omega: [Row; 3]) {
        self.constant.put(lane, constant);
        let places = self.seen.iter_mut().flatten().zip(seen);
        for (place, column) in places.chain(self.omega.iter_mut().flatten().zip(omega)) {
            place.put(lane, column);
        }
    }

    #[inline(always)]
    fn coefficient(&self, n: usize, v: Row<N>, omega: Row<N>) -> Row<N> {
        let mut sum = if n == 0 { self.constant } else { Row::splat(v.0[0].like(0.0)) };
        if let Some(columns) = &self.seen {
            sum = sum + times(columns, v);
        }
        if let Some(columns) = &self.omega {
            sum = sum + times(columns, omega);
        }
        sum
    }
}
