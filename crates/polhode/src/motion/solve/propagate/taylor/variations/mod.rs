//! Derivatives of a motion (variational equations), as power series in addition to that of the
//! motion.
//!
//! A small rotation θ about the principal axes and a change δω satisfy
//!
//! θ̇ = θ × Ω + δΩ,  I δω̇ = δ(L × Ω + N) − δI ω̇
//!
//! δΩ and δ(L × Ω + N) are linear in θ, δω and the changed quantity. The graph of [`Linearization`]
//! provides the series of their coefficients; those of L × ω follow from ω.
//!
//! Each column of the derivatives is a solution. Six columns begin with a unit of θ or ω; the
//! others begin with zero and have a source term. Eight columns are computed in SIMD lanes.
mod columns;

use columns::{Block, Equations, NO_ROWS, Rates, Rows, Sum, WIDTH};

use super::Expansion;
use super::row::{Row, TERMS, Vectors};
use super::sums::{OneBody, SeriesSums as _};
use super::torque::{Known, StepStart, Tape, row};
use crate::math::frame::{Body, Principal};
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::torque::linearization::{Linearization, Slope};
use crate::motion::model::torque::parameter::ParameterKind;
use crate::motion::solve::propagate::piece::Piece;

/// Number of columns with respect to the start, the first ones.
const OF_STATE: usize = 6;
/// Number of columns with respect to the inertia. Those of the parameters follow.
const OF_INERTIA: usize = 6;
/// Derivatives of the motion of one body over one step.
#[derive(Clone, Debug)]
pub(super) struct Variations<'a> {
    parameters: Vec<(&'a TorqueModel, ParameterKind)>,
    to_body: Rotation<Body, Principal>,
    tape: Box<Tape<f64>>,
    by_state: [Slope; OF_STATE],
    /// Slopes with respect to the inertia and to the parameters.
    by_others: Vec<Slope>,
    /// Unit change of each element of the tensor, principal axes.
    of_inertia: [[[f64; 3]; 3]; OF_INERTIA],
    equations: Equations,
    omega: Box<Vectors>,
    rates: Vec<Rates>,
    blocks: Vec<Block>,
    /// Time at which the series begin, s; `None` if there are none yet.
    expanded_at: Option<f64>,
    order: usize,
}

impl<'a> Variations<'a> {
    /// Creates the derivatives of a motion that starts now. `parameters` adds columns to those of
    /// start and inertia.
    pub(super) fn new(
        piece: &Piece<'_>,
        time: f64,
        order: usize,
        parameters: Vec<(&'a TorqueModel, ParameterKind)>,
    ) -> Self {
        let to_body = piece.rotor.principal().rotation();
        let to_principal = to_body.inverse();
        let count = OF_STATE + OF_INERTIA + parameters.len();
        let mut blocks = vec![Block::new(); count.div_ceil(WIDTH)];
        for column in 0..OF_STATE {
            let axis = Direction::<Body>::from_array([0, 1, 2].map(|k| f64::from(u8::from(k == column % 3))));
            let along = (to_principal * axis).to_array();
            let first = 3 * (column / 3);
            for (place, x) in blocks[0].series[0][first..first + 3].iter_mut().zip(along) {
                place.put(column, x);
            }
        }
        let of_inertia = core::array::from_fn(|element| {
            let elements = core::array::from_fn(|k| f64::from(u8::from(k == element)));
            Symmetric3::from_elements(elements).rotated(&to_principal.matrix()).rows()
        });
        let (tape, by_state, by_others, equations) = recorded(piece, time, &parameters);
        Self {
            parameters,
            to_body,
            tape,
            by_state,
            by_others,
            of_inertia,
            equations,
            omega: Box::new(Vectors::all(0.0)),
            rates: vec![Rates::default(); TERMS],
            blocks,
            expanded_at: None,
            order,
        }
    }

    /// Continues from a time with other acting torques.
    pub(super) fn change(&mut self, piece: &Piece<'_>, time: f64) {
        self.rest(time);
        (self.tape, self.by_state, self.by_others, self.equations) = recorded(piece, time, &self.parameters);
    }

    /// Adds the effect of a shifted switching time to each column. `times`: derivative of this time
    /// for each column. `by`: jump of the rates of θ and ω, body axes.
    pub(super) fn jump(&mut self, times: &[f64], by: [Direction<Body>; 2]) {
        let [turning, acceleration] = by.map(|v| (self.to_body.inverse() * v).to_array());
        let rates = [turning, acceleration].concat();
        for (block, times) in self.blocks.iter_mut().zip(times.chunks(WIDTH)) {
            for (row, rate) in block.series[0].iter_mut().zip(&rates) {
                for (lane, time) in times.iter().enumerate() {
                    row.put(lane, row.lane(lane) + rate * time);
                }
            }
        }
    }

    /// Expands the derivatives about the start of a step whose motion is expanded already. Returns
    /// false if they are not finite.
    pub(super) fn expand(&mut self, expansion: &Expansion, start: &StepStart, piece: &Piece<'_>) -> bool {
        self.rest(start.time);
        self.tape.start(start);
        self.tape.start_wheels(0, [row(piece.wheel_momentum(start.time)), row(piece.motor_torque())]);
        in_vectors(Expand { variations: self, expansion });
        self.expanded_at = Some(start.time);
        let last = self.blocks.iter().flat_map(|block| &block.series[self.order]);
        last.fold(0.0, |sum, row| row.0.iter().fold(sum, |sum, x| sum + x * 0.0)) == 0.0
    }

    /// Returns all columns at a time within the step: θ and ω, body axes.
    pub(super) fn at(&self, time: f64) -> Vec<[f64; 6]> {
        let blocks = self.sums(time);
        let count = OF_STATE + self.by_others.len();
        let column = |k: usize| {
            let at = |row: usize| blocks[k / WIDTH][row].lane(k % WIDTH);
            let along = |first: usize| {
                let v = Direction::<Principal>::new(at(first), at(first + 1), at(first + 2));
                (self.to_body * v).to_array()
            };
            let ([a, b, c], [d, e, f]) = (along(0), along(3));
            [a, b, c, d, e, f]
        };
        (0..count).map(column).collect()
    }

    /// Restarts at a time within the last step.
    fn rest(&mut self, time: f64) {
        if self.expanded_at.is_some_and(|start| start != time) {
            let there = self.sums(time);
            for (block, there) in self.blocks.iter_mut().zip(there) {
                block.series[0] = there;
            }
        }
        self.expanded_at = None;
    }

    fn sums(&self, time: f64) -> Vec<Rows> {
        match self.expanded_at {
            Some(start) if start != time => {
                let mut sums = vec![NO_ROWS; self.blocks.len()];
                in_vectors(Sum { blocks: &self.blocks, order: self.order, h: time - start, sums: &mut sums });
                sums
            }
            _ => self.blocks.iter().map(|block| block.series[0]).collect(),
        }
    }

    /// Computes the matrices that multiply θ and δω, and the source terms.
    #[inline(always)]
    fn linearize<S: Machine>(&mut self, s: S, expansion: &Expansion) {
        for n in 0..=self.order {
            self.omega.set(n, expansion.omega_at(n));
        }
        let inside = expansion.inside.as_deref();
        let turning = inside.map_or(&*self.omega, |inside| &inside.turning);
        let known = Known { s: OneBody(s), omega: &self.omega, turning, motion: &expansion.motion };
        let inverses = expansion.inverses;
        for n in 0..self.order {
            let tape = &mut self.tape;
            tape.coefficient(n, &known);
            tape.extend(n, &known);
            let at = |place: Option<usize>| place.map_or(Row::ZERO, |place| tape.vector_at(place, n));
            let [x, y, z, _] = turning.rows.at(n).0;
            let rates = &mut self.rates[n];
            rates.turning = [[x, y, z], [-x, -y, -z]];
            let (mut of_omega, mut squares) = ([Row::ZERO; 3], [Row::ZERO; 3]);
            if !self.equations.has_friction {
                let omega = self.omega.rows.at(n);
                let momentum = inside.map_or(expansion.moments * omega, |inside| inside.momentum.at(n));
                of_omega = gyroscopic(expansion.moments, omega, momentum);
                squares = known.s.outer(&self.omega.rows, &self.omega.rows, n);
            }
            let put = |matrix: &mut [[f64; 3]; 3], column: usize, v: Row| {
                matrix.iter_mut().zip(v.0).for_each(|(row, x)| row[column] = x);
            };
            let (turns, faster) = self.by_state.split_at(3);
            for k in 0..3 {
                put(&mut rates.of_attitude, k, inverses * at(turns[k].torque));
                put(&mut rates.of_omega, k, inverses * (of_omega[k] + at(faster[k].torque)));
                put(&mut rates.bending, k, at(faster[k].turning));
            }
            // (n + 1) ωₙ₊₁ is coefficient n of ω̇.
            let acceleration = self.omega.rows.at(n + 1) * Row::splat((n + 1) as f64);
            for (k, slope) in self.by_others.iter().enumerate() {
                let of = self.of_inertia.get(k).map(|rows| of_element(rows, &squares, acceleration));
                let torque = inverses * (of.unwrap_or(Row::ZERO) + at(slope.torque));
                let (bending, column) = (at(slope.turning), OF_STATE + k);
                let rows = &mut self.blocks[column / WIDTH].sources[n];
                for i in 0..3 {
                    rows[i].put(column % WIDTH, bending.0[i]);
                    rows[3 + i].put(column % WIDTH, torque.0[i]);
                }
            }
        }
    }
}

/// Returns ∂(L × ω)/∂ωⱼ = eⱼ × (iⱼ ω − L), principal axes.
#[inline(always)]
fn gyroscopic(moments: Row, omega: Row, momentum: Row) -> [Row; 3] {
    let [i1, i2, i3, _] = moments.0;
    let [first, second, third] = [i1, i2, i3].map(|i| (Row::splat(i) * omega - momentum).0);
    [
        Row([0.0, -first[2], first[1], 0.0]),
        Row([second[2], 0.0, -second[0], 0.0]),
        Row([-third[1], third[0], 0.0, 0.0]),
    ]
}

/// Returns E ω × ω − E ω̇ for a symmetric matrix E, from the products ωᵢ ωⱼ.
#[inline(always)]
fn of_element(e: &[[f64; 3]; 3], squares: &[Row; 3], acceleration: Row) -> Row {
    let dot = |row: &[f64; 3], v: &Row| row[0] * v.0[0] + row[1] * v.0[1] + row[2] * v.0[2];
    let of = |i: usize, j: usize| dot(&e[i], &squares[j]);
    Row([
        of(1, 2) - of(2, 1) - dot(&e[0], &acceleration),
        of(2, 0) - of(0, 2) - dot(&e[1], &acceleration),
        of(0, 1) - of(1, 0) - dot(&e[2], &acceleration),
        0.0,
    ])
}

/// Records the derivatives of what acts as a graph.
fn recorded(
    piece: &Piece<'_>,
    time: f64,
    parameters: &[(&TorqueModel, ParameterKind)],
) -> (Box<Tape<f64>>, [Slope; OF_STATE], Vec<Slope>, Equations) {
    // The acting part of a torque can be a part of it, such as one piece of a table.
    let acting: Vec<_> = parameters
        .iter()
        .map(|(torque, kind)| {
            let part = torque.acting(time)?;
            let acts = piece.torques.iter().any(|acting| core::ptr::eq(*acting, part));
            acts.then_some((part, *kind))
        })
        .collect();
    let Linearization { graph, by_state, by_inertia, by_parameters } =
        Linearization::of(piece.rotor, &piece.torques, &acting);
    let mut tape = Box::new(Tape::of(0.0, &graph));
    tape.set(0, &graph, piece.rotor);
    let equations = Equations {
        has_friction: piece.sink != 0.0,
        has_attitude: by_state[..3].iter().any(|slope| slope.torque.is_some()),
    };
    (tape, by_state, by_inertia.into_iter().chain(by_parameters).collect(), equations)
}

/// Computation of the series of one step.
struct Expand<'v, 'a> {
    variations: &'v mut Variations<'a>,
    expansion: &'v Expansion,
}

impl Work for Expand<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Machine>(self, s: S) {
        let Self { variations, expansion } = self;
        s.apart(
            #[inline(always)]
            || variations.linearize(s, expansion),
        );
        let Variations { equations, blocks, rates, order, .. } = variations;
        for block in blocks {
            block.expand(s, *equations, &rates[..*order]);
        }
    }
}
