//! Torques N = M f(A ω), where f applies one function to each component, such as the saturated
//! law −k tanh(ω/ω₀). Each coefficient needs one convolution and one square.
//!
//! Coefficient n ≥ 1 of y = f(u), u = A ω, is yₙ = f′(u₀) uₙ + σₙ, where σₙ contains only
//! coefficients before n:
//!
//! tanh: y′ = w u′, w = 1 − y²:  n σₙ = Σ_{1≤k<n} k uₖ wₙ₋ₖ
//! exp and tan alike, with w = y and w = 1 + y²
//! atan: y′ = u′/d, d = 1 + u²:  n d₀ σₙ = −Σ_{1≤k<n} dₖ (n − k) yₙ₋ₖ
//!
//! The recurrence of the motion contains the linear part M f′(u₀) A. Its newest coefficient
//! therefore does not wait for that of the torque.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3.

use super::super::function::{rows_convolution, rows_square};
use super::super::row::{Row, Series};
use super::tape::times;
use crate::math::formula::Unary;
use crate::math::number::Number;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::torque::graph::{Graph, Operation, VectorOperation};
use crate::motion::solve::propagate::rounding::{ROUNDING, THIN};

/// Series of such a torque.
#[derive(Clone, Debug)]
pub(in super::super) struct Componentwise<N> {
    function: Unary,
    /// Columns of A, of M, and of M with each row divided by the moment of its axis.
    maps: [[Row<N>; 3]; 3],
    y: Series<N>,
    /// f′(u₀).
    slope: Row<N>,
    /// σ of the next coefficient.
    rest: Row<N>,
    /// Factors of the convolution: k uₖ and wₖ₊₁, or for atan −dₖ/d₀ and (k + 1) yₖ₊₁.
    factors: [Series<N>; 2],
    /// Series of u, for atan.
    u: Series<N>,
}

/// Returns the function, and the indices of A and M among the matrices of a graph; `None` for other
/// graphs. An index is `None` for the identity.
fn recognised(graph: &Graph) -> Option<(Unary, [Option<usize>; 2])> {
    let vectors = graph.operations.iter().filter_map(|operation| match operation {
        Operation::Vector(operation) => Some(*operation),
        Operation::Scalar(_) => None,
    });
    let vectors: Vec<_> = vectors.collect();
    // A vector as the image of another one.
    let image = |place: usize| match vectors.get(place) {
        Some(&VectorOperation::Image(k, of)) => (Some(k), of),
        _ => (None, place),
    };
    let (outer, y) = image(graph.torque);
    let (function, u) = match *vectors.get(y)? {
        VectorOperation::IntegralBy {
            start: start @ (Unary::Tanh | Unary::Tan | Unary::Exp), of, ..
        }
        | VectorOperation::IntegralOver { start: start @ Unary::Atan, of, .. } => (start, of),
        _ => return None,
    };
    let (inner, omega) = image(u);
    let is_omega = matches!(vectors.get(omega), Some(VectorOperation::Omega));
    is_omega.then_some((function, [inner, outer]))
}

impl<N: Number> Componentwise<N> {
    /// Creates the series for all bodies whose graphs have these operations; `None` for other
    /// torques.
    pub(in super::super) fn of(zero: N, graph: &Graph) -> Option<Self> {
        let (function, _) = recognised(graph)?;
        let (none, series) = (Row::splat(zero), Series::all(zero));
        Some(Self {
            function,
            maps: [[none; 3]; 3],
            y: series,
            slope: none,
            rest: none,
            factors: [series; 2],
            u: series,
        })
    }

    /// Sets the maps of a lane's body. `inverses`: inverses of its moments.
    pub(in super::super) fn set(&mut self, lane: usize, graph: &Graph, rotor: &Rotor, inverses: Row) {
        let Some((_, places)) = recognised(graph) else { return };
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let matrix = |k: Option<usize>| k.and_then(|k| graph.matrices.get(k)).copied().unwrap_or(unit);
        let [inner, mut outer] = places.map(matrix);
        // Remove entries that are only rounding, about the axis of a needle.
        let moments = rotor.principal().moments();
        let largest = outer.iter().flatten().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        for (row, moment) in outer.iter_mut().zip(moments) {
            let is_thin = moment < THIN * moments[2];
            row.iter_mut().filter(|x| is_thin && x.abs() < ROUNDING * largest).for_each(|x| *x = 0.0);
        }
        for column in 0..3 {
            let of = |rows: &[[f64; 3]; 3]| Row([rows[0][column], rows[1][column], rows[2][column], 0.0]);
            let columns = [of(&inner), of(&outer), of(&outer) * inverses];
            self.maps.iter_mut().zip(columns).for_each(|(map, value)| map[column].put(lane, value));
        }
    }

    /// Starts a step at ω. Returns the constant and the columns of the linear part of N/I: N/I = c +
    /// B ω + …
    #[inline(always)]
    pub(in super::super) fn start(&mut self, omega: Row<N>) -> (Row<N>, [Row<N>; 3]) {
        let [inner, _, acceleration] = &self.maps;
        let (one, zero) = (Row::splat(omega.0[0].like(1.0)), Row::splat(omega.0[0].like(0.0)));
        let u = times(inner, omega);
        let y = of_components(self.function, u);
        self.slope = match self.function {
            Unary::Tanh => one - y * y,
            Unary::Tan => one + y * y,
            Unary::Atan => {
                let [a, b, c, d] = (one + u * u).0;
                let [one, ..] = one.0;
                Row([one / a, one / b, one / c, one / d])
            }
            _ => y,
        };
        self.y.set(0, y);
        self.u.set(0, u);
        self.rest = zero;
        let columns = inner.map(|column| times(acceleration, self.slope * column));
        (times(acceleration, y) - times(&columns, omega), columns)
    }

    /// Computes coefficient n ≥ 1 from that of ω. Returns the part of coefficient n + 1 of N/I that
    /// is not linear in that of ω.
    #[inline(always)]
    pub(in super::super) fn extend(&mut self, n: usize, omega: Row<N>) -> Row<N> {
        let [inner, _, acceleration] = &self.maps;
        let (u, weight) = (times(inner, omega), Row::splat(omega.0[0].like(n as f64)));
        let y = self.slope.mul_add(u, self.rest);
        self.y.set(n, y.vector());
        let [first, second] = &mut self.factors;
        let none = Row::splat(omega.0[0].like(0.0));
        if self.function == Unary::Atan {
            self.u.set(n, u.vector());
            first.set(n, none - rows_square(&self.u, n) * self.slope);
            second.set(n - 1, y * weight);
        } else {
            first.set(n, u * weight);
            second.set(
                n - 1,
                match self.function {
                    Unary::Tanh => none - rows_square(&self.y, n),
                    Unary::Tan => rows_square(&self.y, n),
                    _ => y,
                },
            );
        }
        self.rest = rows_convolution(first, second, n).over(n + 1);
        times(acceleration, self.rest)
    }

    /// Returns coefficient n of N, once it is known.
    #[inline(always)]
    pub(in super::super) fn at(&self, n: usize) -> Row<N> {
        times(&self.maps[1], self.y.at(n))
    }
}

/// Returns a function of the three components.
#[inline(never)]
fn of_components<N: Number>(function: Unary, at: Row<N>) -> Row<N> {
    let [x, y, z, rest] = at.0;
    let [x, y, z] = [x, y, z].map(|x| x.map(|x| function.of(x)));
    Row([x, y, z, rest])
}

#[cfg(test)]
mod tests {
    use super::super::tape::Tape;
    use super::super::{Known, StepStart};
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::Position;
    use crate::math::formula::{Binary, Formula, Instruction};
    use crate::math::machine::Plain;
    use crate::motion::model::torque::{FormulaTorque, TorqueModel};
    use crate::motion::solve::propagate::taylor::all_zero;
    use crate::motion::solve::propagate::taylor::row::Vectors;
    use crate::motion::solve::propagate::taylor::sums::OneBody;

    /// Returns the graph of N = 0.7 f(k ω), component by component, with k = 1.3 … 1.5.
    fn graph(function: Unary, rotor: &Rotor) -> Graph {
        let times = Instruction::Binary(Binary::Multiply);
        let along = |k: usize| {
            let (factor, scale) = (Instruction::Constant(0.7), Instruction::Constant(1.3 + 0.1 * k as f64));
            let rate = Instruction::Variable(1 + k);
            Formula::new([factor, scale, rate, times, Instruction::Unary(function), times]).unwrap()
        };
        let law = TorqueModel::Formula(Box::new(FormulaTorque::Body([0, 1, 2].map(along))));
        Graph::of([&law], rotor).packed()
    }

    #[test]
    fn the_series_are_those_of_the_operations() {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap());
        let inverses = Row([0.5, 0.4, 0.3, 0.0]);
        let series = |n: usize| {
            let n = n as f64;
            Row([0.3 - 0.2 * n, 0.5 + 0.1 * n, 0.1 * n * n - 0.4, 0.0]) * Row([0.3_f64.powf(n); 4])
        };
        for function in [Unary::Tanh, Unary::Tan, Unary::Exp, Unary::Atan] {
            let graph = graph(function, &rotor);
            let mut tape = Tape::of(0.0, &graph);
            tape.set(0, &graph, &rotor);
            tape.start(&StepStart {
                time: 0.0,
                attitude: Row([1.0, 0.0, 0.0, 0.0]),
                omega: series(0),
                omega_low: Row::ZERO,
            });
            let mut torque = Componentwise::of(0.0, &graph).unwrap();
            torque.set(0, &graph, &rotor, inverses);
            let (mut omega, motion) = (Vectors::all(0.0), all_zero(0.0));
            let (mut rest, columns) = torque.start(series(0));
            for n in 0..20 {
                omega.set(n, series(n));
                let s = OneBody(Plain::<f64>::new());
                let known = Known { s, omega: &omega, turning: &omega, motion: &motion };
                let want = tape.coefficient(n, &known);
                let got = times(&columns, series(n)) + rest;
                rest = if n > 0 { torque.extend(n, series(n)) } else { Row::ZERO };
                for (got, want) in [(torque.at(n), want), (got, want * inverses)] {
                    let error = (got - want).largest();
                    let most = 1e-14 * want.largest().max(1e-3);
                    assert!(error < most, "{function:?}, {n}: {got:?} {want:?}");
                }
            }
        }
        let other = graph(Unary::Sin, &rotor);
        assert!(Componentwise::of(0.0, &other).is_none());
    }
}
