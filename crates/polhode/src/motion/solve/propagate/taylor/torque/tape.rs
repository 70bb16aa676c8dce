//! Series of torques given as a graph. Coefficient n of each value follows from coefficients up to
//! n of its operands.

mod expand;
mod step;
#[cfg(test)]
mod tests;

use step::{Constant, TapeStep, classify};

use super::super::function::{
    angle, constant_power, hypotenuse, integral_by, integral_over, ratio, rows_convolution, rows_square,
};
use super::super::row::{Row, Series};
use super::super::scalar::{Composition, Scalars, power_difference, product, quotient, times_vector};
use super::super::sums::SeriesSums;
use super::norm::NormSeries;
use super::orbit::OrbitSeries;
use super::{Known, StepStart, cross, row};
use crate::math::algebra::Scalar as _;
use crate::math::frame::{Principal, Space};
use crate::math::number::Number;
use crate::math::rotation::{Rotation, wrap};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::torque::graph::{Graph, Operation, ScalarOperation, VectorOperation};
use crate::motion::solve::propagate::rounding::{ROUNDING, THIN};

/// Series of the values of a graph over one step.
#[derive(Clone, Debug)]
pub(in super::super) struct Tape<N> {
    /// All operations, and those whose results change during a step.
    steps: [Vec<TapeStep>; 2],
    torque: usize,
    numbers: Vec<Scalars<N>>,
    vectors: Vec<Series<N>>,
    /// Rates of the integrals among the vectors, or of their arguments.
    rates: Vec<Series<N>>,
    constants: Vec<N>,
    constant_vectors: Vec<Row<N>>,
    /// Matrices, by columns.
    matrices: Vec<[Row<N>; 3]>,
    /// Vectors that are fixed in space, space axes.
    fixed: Vec<Row<N>>,
    orbits: Vec<OrbitSeries<N>>,
    turns: Vec<TurnSeries<N>>,
    norms: Vec<NormSeries<N>>,
    compositions: Vec<Composition<N>>,
    time: N,
    /// Σ h a of the wheels at the start of the step, and its rate.
    wheels: [Row<N>; 2],
    /// Principal axes of each lane that are those of a needle; empty if there are none.
    thin: Vec<[bool; 3]>,
}

/// Rotation from a rest attitude: p = p₀ ∘ (rotation since the start of the step).
#[derive(Clone, Debug)]
struct TurnSeries<N> {
    /// Attitude of the principal axes at rest, for each lane.
    from: Vec<Rotation<Space, Principal>>,
    is_canonical: bool,
    start: Row<N>,
}

impl<N: Number> Tape<N> {
    /// Creates the series for all bodies whose graphs have these operations.
    pub(in super::super) fn of(zero: N, graph: &Graph) -> Self {
        let (none, [numbers, vectors]) = (Row::splat(zero), graph.counts);
        let (mut norms, mut compositions, mut rates) = (Vec::new(), Vec::new(), Vec::new());
        // degree of each number and vector so far
        let mut degrees = [Vec::new(), Vec::new()];
        let steps = graph.operations.iter().map(|&operation| {
            let beside = match operation {
                Operation::Scalar(ScalarOperation::Norm(_)) => {
                    norms.push(NormSeries::all(zero));
                    norms.len() - 1
                }
                Operation::Scalar(
                    ScalarOperation::HalfAngleOverSine(_) | ScalarOperation::HalfAngleSlope(_),
                ) => {
                    compositions.push(Composition::all(zero));
                    compositions.len() - 1
                }
                Operation::Vector(
                    VectorOperation::IntegralBy { .. } | VectorOperation::IntegralOver { .. },
                ) => {
                    rates.push(Series::all(zero));
                    rates.len() - 1
                }
                _ => 0,
            };
            let (constant, degree) = classify(operation, &degrees);
            let kind = match operation {
                Operation::Scalar(_) => &mut degrees[0],
                Operation::Vector(_) => &mut degrees[1],
            };
            kind.push(degree);
            TapeStep { operation, place: kind.len() - 1, beside, constant }
        });
        let steps: Vec<_> = steps.collect();
        let changing = steps.iter().filter(|step| step.constant != Constant::All).copied().collect();
        let turn = |is_canonical| TurnSeries {
            from: vec![Rotation::identity(); N::LANES],
            is_canonical,
            start: none,
        };
        Self {
            steps: [steps, changing],
            torque: graph.torque,
            numbers: vec![Scalars::all(zero); numbers],
            vectors: vec![Series::all(zero); vectors],
            rates,
            constants: vec![zero; graph.constants.len()],
            constant_vectors: vec![none; graph.vectors.len()],
            matrices: vec![[none; 3]; graph.matrices.len()],
            fixed: vec![none; graph.fixed.len()],
            orbits: graph.orbits.iter().map(|orbit| OrbitSeries::of(zero, orbit)).collect(),
            turns: graph.turns.iter().map(|&(_, is_canonical)| turn(is_canonical)).collect(),
            norms,
            compositions,
            time: zero,
            wheels: [none; 2],
            thin: Vec::new(),
        }
    }

    /// Sets the values of a lane's body. Its graph must have the same operations.
    pub(in super::super) fn set(&mut self, lane: usize, graph: &Graph, rotor: &Rotor) {
        for (place, &x) in self.constants.iter_mut().zip(&graph.constants) {
            place.put(lane, x);
        }
        for (place, &[x, y, z]) in self.constant_vectors.iter_mut().zip(&graph.vectors) {
            place.put(lane, Row([x, y, z, 0.0]));
        }
        for (columns, rows) in self.matrices.iter_mut().zip(&graph.matrices) {
            for (column, place) in columns.iter_mut().enumerate() {
                place.put(lane, Row([rows[0][column], rows[1][column], rows[2][column], 0.0]));
            }
        }
        for (place, &v) in self.fixed.iter_mut().zip(&graph.fixed) {
            place.put(lane, row(v));
        }
        for (series, orbit) in self.orbits.iter_mut().zip(&graph.orbits) {
            series.set(lane, orbit);
        }
        for (turn, (rest, _)) in self.turns.iter_mut().zip(&graph.turns) {
            turn.from[lane] = *rest * rotor.principal().rotation();
        }
        self.norms.iter_mut().for_each(|norm| norm.set(lane));
        let moments = rotor.principal().moments();
        let thin = moments.map(|moment| moment < THIN * moments[2]);
        if thin != [false; 3] || !self.thin.is_empty() {
            self.thin.resize(N::LANES, [false; 3]);
            self.thin[lane] = thin;
        }
    }

    /// Starts a step.
    #[inline(always)]
    pub(in super::super) fn start(&mut self, at: &StepStart<N>) {
        self.time = at.time;
        self.orbits.iter_mut().for_each(|orbit| orbit.start(at));
        self.norms.iter_mut().for_each(|norm| norm.start(at.time));
        for turn in &mut self.turns {
            for (lane, from) in turn.from.iter().enumerate() {
                let (_, attitude) = at.lane(lane);
                let p: Rotation<Principal, Principal> = from.inverse() * attitude;
                let p = if turn.is_canonical { p.canonical_quaternion() } else { p.quaternion() };
                turn.start.put(lane, Row(p));
            }
        }
        for &TapeStep { operation, place, .. } in &self.steps[1] {
            if let Operation::Vector(VectorOperation::Fixed(k)) = operation {
                self.vectors[place].set(0, at.resolved(self.fixed[k]).vector());
            }
        }
    }

    /// Sets h and ḣ of the wheels of a lane at the start of a step.
    pub(in super::super) fn start_wheels(&mut self, lane: usize, wheels: [Row; 2]) {
        for (place, wheels) in self.wheels.iter_mut().zip(wheels) {
            place.put(lane, wheels);
        }
    }

    /// Returns coefficient n of N. All other known series must be complete up to n.
    #[inline(always)]
    pub(in super::super) fn coefficient<M: SeriesSums<N = N>>(
        &mut self,
        n: usize,
        known: &Known<'_, M>,
    ) -> Row<N> {
        for orbit in &mut self.orbits {
            orbit.measure(known.s, n);
        }
        // Constants have only coefficient 0.
        let which = usize::from(n > 0);
        let steps = core::mem::take(&mut self.steps[which]);
        for step in &steps {
            self.evaluate(step, n, known);
        }
        self.steps[which] = steps;
        self.torque_at(n)
    }

    /// Returns coefficient n of N, once it is known.
    #[inline(always)]
    pub(in super::super) fn torque_at(&self, n: usize) -> Row<N> {
        self.without_rounding(self.vectors[self.torque].at(n))
    }

    #[inline(always)]
    fn evaluate<M: SeriesSums<N = N>>(&mut self, step: &TapeStep, n: usize, known: &Known<'_, M>) {
        match &step.operation {
            Operation::Scalar(operation) => {
                let value = self.number(operation, step, n, known);
                self.numbers[step.place][n] = value;
            }
            Operation::Vector(operation) => {
                let value = self.vector(operation, step, n, known);
                self.vectors[step.place].set(n, value.vector());
            }
        }
    }

    /// Computes the additional series that coefficient n + 1 needs.
    #[inline(always)]
    pub(in super::super) fn extend<M: SeriesSums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) {
        for &TapeStep { operation, place, .. } in &self.steps[1] {
            if let Operation::Vector(VectorOperation::Fixed(_)) = operation {
                // v̇ = v × Ω
                let next = known.s.cross(&self.vectors[place], &known.turning.rows, n).over(n + 1);
                self.vectors[place].set(n + 1, next.vector());
            }
        }
        for orbit in &mut self.orbits {
            orbit.extend(n, known);
        }
    }

    /// Returns coefficient n of one of the vectors, once it is known.
    #[inline(always)]
    pub(in super::super) fn vector_at(&self, place: usize, n: usize) -> Row<N> {
        self.vectors[place].at(n)
    }

    /// Returns the longest step for which the series is valid, s. The coefficients do not show this
    /// limit.
    #[inline(always)]
    pub(in super::super) fn reach(&self, endless: N) -> N {
        self.norms.iter().fold(endless, |least, norm| super::super::row::smaller(least, norm.reach(endless)))
    }

    /// Returns coefficient n of a number.
    #[inline(always)]
    fn number<M: SeriesSums<N = N>>(
        &mut self,
        operation: &ScalarOperation,
        &TapeStep { place: own, beside, constant: constants, .. }: &TapeStep,
        n: usize,
        known: &Known<'_, M>,
    ) -> N {
        use ScalarOperation as Op;
        let rows = &self.numbers;
        let zero = self.time.like(0.0);
        // A value that is constant over the step.
        let constant = |x: N| if n == 0 { x } else { zero };
        match *operation {
            Op::Constant(k) => constant(self.constants[k]),
            Op::Time if n == 1 => zero.like(1.0),
            Op::Time => constant(self.time),
            Op::OrbitSquare(k) => self.orbits[k].square[n],
            Op::OrbitInverseCube(k) => self.orbits[k].cube[n],
            Op::OrbitDistance(k) => constant(self.orbits[k].distance),
            Op::OrbitStrength(k) => constant(self.orbits[k].strength),
            Op::Negate(a) => zero - rows[a][n],
            Op::Scale(a, k) => self.constants[k] * rows[a][n],
            Op::Add(a, b) => rows[a][n] + rows[b][n],
            Op::Subtract(a, b) => rows[a][n] - rows[b][n],
            Op::Multiply(a, b) => match constants {
                Constant::First => rows[a][0] * rows[b][n],
                Constant::Second => rows[a][n] * rows[b][0],
                _ => product(&rows[a], &rows[b], n),
            },
            Op::Divide(a, b) if constants == Constant::Second => rows[a][n] / rows[b][0],
            Op::Divide(a, b) => quotient(&rows[a], &rows[b], &rows[own], n),
            Op::DivideOrZero(a, b) => {
                let value = quotient(&rows[a], &rows[b], &rows[own], n);
                value.zip(rows[b][0], |value, divisor| if divisor == 0.0 { 0.0 } else { value })
            }
            Op::Component(v, k) => self.vectors[v].at(n).0[k],
            Op::Dot(a, b) => {
                let (a, b) = (&self.vectors[a], &self.vectors[b]);
                let products = match constants {
                    Constant::First => a.at(0) * b.at(n),
                    Constant::Second => a.at(n) * b.at(0),
                    _ => known.s.product(a, b, n),
                };
                let [x, y, z, _] = products.0;
                x + y + z
            }
            Op::Norm(v) => self.norms[beside].coefficient(n, &self.vectors[v]),
            Op::TurnScalar(k) => self.turns[k].coefficient(known.turn(n)).0[0],
            Op::HalfAngleOverSine(a) | Op::HalfAngleSlope(a) => {
                let is_slope = matches!(operation, Op::HalfAngleSlope(_));
                let composition = &mut self.compositions[beside];
                if n == 0 {
                    (0..N::LANES).for_each(|lane| {
                        start_composition(composition, lane, rows[a][0].lane(lane), is_slope);
                    });
                }
                composition.extend(&rows[a], n);
                composition.series()[n]
            }
            _ if n == 0 => self.function(*operation),
            Op::Power(a, p) => constant_power(&rows[a], f64::from_bits(p), &rows[own], n),
            Op::PowerDifference([_, delta, power, sum], p) => {
                let of = [&rows[delta], &rows[sum], &rows[power]];
                power_difference(of, f64::from_bits(p), &rows[own], n)
            }
            Op::Hypot(a, b) => hypotenuse(&rows[a], &rows[b], &rows[own], n),
            // The other terms of the sum are zero.
            Op::IntegralBy { of, by, .. } if constants == Constant::Linear => {
                rows[of][1] * rows[by][n - 1] / zero.like(n as f64)
            }
            Op::IntegralBy { of, by, .. } => integral_by(&rows[of], &rows[by], n),
            Op::IntegralOver { of, over, .. } => integral_over(&rows[of], &rows[over], &rows[own], n),
            Op::Angle(a, b, square) => angle(&rows[a], &rows[b], &rows[square], &rows[own], n),
            Op::Wrapped(a) => rows[a][n],
            Op::GeneralPower(_, _, exponent) => integral_by(&rows[exponent], &rows[own], n),
            Op::Rough => zero.like(f64::NAN),
        }
    }

    /// Returns the value of a function at the start of the step, lane by lane.
    fn function(&self, operation: ScalarOperation) -> N {
        use ScalarOperation as Op;
        let at = |place: usize| self.numbers[place][0];
        match operation {
            Op::Power(a, p) => at(a).map(|x| match f64::from_bits(p) {
                0.5 => x.sqrt(),
                p => libm::pow(x, p),
            }),
            Op::PowerDifference([a, delta, ..], p) => {
                at(a).zip(at(delta), |a, delta| a.power_difference(delta, f64::from_bits(p)))
            }
            Op::Hypot(a, b) => at(a).zip(at(b), libm::hypot),
            Op::IntegralBy { start, of, .. } | Op::IntegralOver { start, of, .. } => {
                at(of).map(|x| start.of(x))
            }
            Op::Angle(a, b, _) => at(a).zip(at(b), libm::atan2),
            Op::Wrapped(a) => at(a).map(wrap),
            Op::GeneralPower(a, b, _) => at(a).zip(at(b), libm::pow),
            _ => self.time.like(f64::NAN),
        }
    }

    /// Returns coefficient n of a vector.
    #[inline(always)]
    fn vector<M: SeriesSums<N = N>>(
        &mut self,
        operation: &VectorOperation,
        &TapeStep { place: own, beside, constant, .. }: &TapeStep,
        n: usize,
        known: &Known<'_, M>,
    ) -> Row<N> {
        use VectorOperation as Op;
        let rows = &self.vectors;
        let none = Row::splat(self.time.like(0.0));
        match *operation {
            Op::Constant(k) if n == 0 => self.constant_vectors[k],
            Op::Constant(_) => none,
            Op::Omega => known.omega.rows.at(n),
            Op::Wheels => self.wheels.get(n).copied().unwrap_or(none),
            // This coefficient is known already.
            Op::Fixed(_) => rows[own].at(n),
            Op::Orbit(k) => self.orbits[k].rho.at(n),
            Op::Turn(k) => {
                let [_, x, y, z] = self.turns[k].coefficient(known.turn(n)).0;
                Row([x, y, z, none.0[0]])
            }
            Op::Negate(a) => none - rows[a].at(n),
            Op::Scale(a, k) => rows[a].at(n) * Row::splat(self.constants[k]),
            Op::Add(a, b) => rows[a].at(n) + rows[b].at(n),
            Op::Subtract(a, b) => rows[a].at(n) - rows[b].at(n),
            Op::Times(a, b) => match constant {
                Constant::First => rows[a].at(0) * Row::splat(self.numbers[b][n]),
                Constant::Second => rows[a].at(n) * Row::splat(self.numbers[b][0]),
                _ => times_vector(&self.numbers[b], &rows[a], n),
            },
            Op::Cross(a, b) => match constant {
                Constant::First => cross(rows[a].at(0), rows[b].at(n)),
                Constant::Second => cross(rows[a].at(n), rows[b].at(0)),
                _ => known.s.cross(&rows[a], &rows[b], n),
            },
            Op::Product(a, b) => match constant {
                Constant::First => rows[a].at(0) * rows[b].at(n),
                Constant::Second => rows[a].at(n) * rows[b].at(0),
                _ if a == b => rows_square(&rows[a], n),
                _ => known.s.product(&rows[a], &rows[b], n),
            },
            Op::IntegralBy { start, of, .. } | Op::IntegralOver { start, of, .. } if n == 0 => {
                let [x, y, z, rest] = rows[of].at(0).0;
                Row([x.map(|x| start.of(x)), y.map(|y| start.of(y)), z.map(|z| start.of(z)), rest])
            }
            Op::IntegralBy { .. } | Op::IntegralOver { .. } | Op::Quotient(..) => {
                self.implicit(operation, [own, beside], n)
            }
            Op::Image(k, a) => times(&self.matrices[k], rows[a].at(n)),
            Op::Of([x, y, z]) => {
                let [x, y, z] = [x, y, z].map(|place| self.numbers[place][n]);
                Row([x, y, z, none.0[0]])
            }
        }
    }

    /// Returns coefficient n of a quotient, or of an integral for n ≥ 1, component by component.
    /// y = ∫ u' w has n yₙ = Σ_{k≥1} k uₖ wₙ₋ₖ, and r = u'/d, as c = a/b, has d₀ rₙ = (u')ₙ − Σ_{k≥1}
    /// dₖ rₙ₋ₖ; y = ∫ r.
    ///
    /// exp u has w = y, tanh u has w = 1 − y², atan u has d = 1 + u². `rates` holds t u' or r.
    #[inline(always)]
    fn implicit(&mut self, operation: &VectorOperation, [own, beside]: [usize; 2], n: usize) -> Row<N> {
        use VectorOperation as Op;
        let rows = &self.vectors;
        let weighted = |row: Row<N>| row * Row::splat(self.time.like(n as f64));
        let ([a, b], last) = match *operation {
            Op::IntegralBy { of, by, .. } => {
                self.rates[beside].set(n, weighted(rows[of].at(n)));
                ([&self.rates[beside], &rows[by]], n)
            }
            Op::IntegralOver { over, .. } => ([&rows[over], &self.rates[beside]], n - 1),
            Op::Quotient(_, b) => ([&rows[b], &rows[own]], n),
            _ => return rows[own].at(n),
        };
        let sum = rows_convolution(a, b, last);
        match *operation {
            Op::IntegralOver { of, over, .. } => {
                let rate = ratio(weighted(rows[of].at(n)) - sum, rows[over].at(0));
                self.rates[beside].set(last, rate);
                rate.over(n)
            }
            Op::Quotient(a, b) => ratio(rows[a].at(n) - sum, rows[b].at(0)),
            _ => sum.over(n),
        }
    }

    /// Removes components of N that are only rounding, about the axis of a needle. Divided by the
    /// very small moment, they would make the needle spin.
    #[inline(always)]
    fn without_rounding(&self, mut torque: Row<N>) -> Row<N> {
        for (lane, thin) in self.thin.iter().enumerate() {
            let mut one = torque.lane(lane);
            let [x, y, z, _] = one.0;
            let least = ROUNDING * (x.abs() + y.abs() + z.abs());
            for (component, is_thin) in one.0.iter_mut().zip(thin) {
                if *is_thin && component.abs() < least {
                    *component = 0.0;
                }
            }
            torque.put(lane, one);
        }
        torque
    }
}

impl<N: Number> TurnSeries<N> {
    /// Returns p₀ ∘ (coefficient n of the rotation since the start of the step).
    #[inline(always)]
    fn coefficient(&self, turn: Row<N>) -> Row<N> {
        let ([w, x, y, z], [a, b, c, d]) = (self.start.0, turn.0);
        Row([
            w * a - x * b - y * c - z * d,
            w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a,
        ])
    }
}

/// Starts a lane of f(w) = arccos w/√(1 − w²), or of its derivative, at the initial w of a step.
fn start_composition<N: Number>(composition: &mut Composition<N>, lane: usize, w: f64, is_slope: bool) {
    let sine = ((1.0 - w) * (1.0 + w)).max(0.0).sqrt();
    composition.start(lane, [w.half_angle_over_sine(), w, sine], is_slope);
}

/// Returns A v, for A given by its columns.
#[inline(always)]
pub(super) fn times<N: Number>(columns: &[Row<N>; 3], v: Row<N>) -> Row<N> {
    let [x, y, z, _] = v.0;
    let [a, b, c] = *columns;
    a.mul_add(Row::splat(x), b.mul_add(Row::splat(y), c * Row::splat(z)))
}
