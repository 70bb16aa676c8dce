//! Collocation step: its polynomials, by iteration that starts from those of the previous step.
//!
//! Picard iteration evaluates y = y₀ + ∫ f repeatedly at the nodes. Each round first updates the
//! dynamic variables (as ω), then the kinematic ones that follow from them (as the axes). For an
//! oscillation of frequency Ω, round k multiplies the error by (Ωh)²/2k(2k − 1) instead of Ωh/k.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, II.7.
//! The Picard–Chebyshev iteration is the same method: X. Bai, J. L. Junkins, J. Astronaut. Sci. 58
//! (2011) 583.

use super::matrices::{HALF, NODES, Values, by_parity, coefficients, extrapolate, integrate};
use super::nodes::{legendre_integrals, legendre_values};
use super::system::{OUTPUTS, Places, ROOM, System, Variables};
use crate::math::algebra::Side;
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number as _;
use crate::motion::solve::propagate::taylor::length::{rough_exp2, rough_log2};

/// Largest number of rounds of a step. A step that needs more is too long.
const MOST_ROUNDS: u64 = 40;
/// Largest number of step lengths that are tried.
const MOST_TRIES: usize = 60;
/// Convergence threshold: last change of the iteration, relative to the sizes of the variables.
const CONVERGED: f64 = 5e-16;

/// Motion in the current step, and length of the next one.
#[derive(Clone, Debug)]
pub(in crate::motion) struct Collocation {
    tolerance: f64,
    variables: Variables,
    /// Indices of the kinematic variables.
    kinematic: Vec<usize>,
    /// Indices of the dynamic variables.
    dynamic: Vec<usize>,
    /// Proposed length of the next step.
    next: f64,
    /// True after the first step.
    is_known: bool,
    now: Box<Polynomials>,
    /// Buffer for the polynomials of a trial step.
    trial: Box<Polynomials>,
    /// Buffer for the values of a trial step at its nodes.
    values: Box<NodeValues>,
    work: StepWork,
}

/// Variables of a step at its nodes, their rates, and sums and differences of the latter.
#[derive(Clone, Debug)]
struct NodeValues {
    y: [Values; ROOM],
    f: [Values; ROOM],
    parities: [Values; ROOM],
}

impl NodeValues {
    const NONE: Self =
        Self { y: [Values::NONE; ROOM], f: [Values::NONE; ROOM], parities: [Values::NONE; ROOM] };
}

/// Polynomials of the motion in a step.
#[derive(Clone, Debug)]
struct Polynomials {
    start: [f64; ROOM],
    length: f64,
    /// Legendre coefficients of the rates of the variables.
    rates: [[f64; NODES]; ROOM],
    /// Legendre coefficients of the further functions.
    outputs: [[f64; NODES]; OUTPUTS],
}

impl Polynomials {
    const NONE: Self = Self {
        start: [0.0; ROOM],
        length: 0.0,
        rates: [[0.0; NODES]; ROOM],
        outputs: [[0.0; NODES]; OUTPUTS],
    };
}

impl Collocation {
    /// Creates the integrator without a state. `tolerance` is per step, relative to the sizes of
    /// the variables.
    pub(in crate::motion) fn new(system: &impl System, tolerance: f64) -> Self {
        let variables = system.variables();
        Self {
            tolerance,
            variables,
            kinematic: variables.kinematic.into_iter().flatten().collect(),
            dynamic: variables.dynamic.into_iter().flatten().collect(),
            next: f64::NAN,
            is_known: false,
            now: Box::new(Polynomials::NONE),
            trial: Box::new(Polynomials::NONE),
            values: Box::new(NodeValues::NONE),
            work: StepWork { evaluations: 0, rejected: 0 },
        }
    }

    /// Restarts with a step of about this length.
    pub(in crate::motion) fn begin(&mut self, length: f64) {
        self.next = length;
        self.is_known = false;
    }

    /// Computes a step from a state and returns its length; 0 if no step length succeeds.
    pub(in crate::motion) fn about(
        &mut self,
        system: &impl System,
        state: &[f64],
        sizes: &[f64],
        wanted: Wanted,
    ) -> f64 {
        self.trial.start.iter_mut().zip(state).for_each(|(place, y)| *place = *y);
        let mut weights = [0.0; ROOM];
        weights.iter_mut().zip(sizes).for_each(|(place, size)| *place = 1.0 / size);
        in_vectors(Advance { of: self, system, weights, wanted })
    }

    /// Returns variable k at the start of the step.
    pub(in crate::motion) fn start(&self, k: usize) -> f64 {
        self.now.start[k]
    }

    /// Returns the evaluations and the rejected trials since the last call.
    pub(in crate::motion) fn take_work(&mut self) -> StepWork {
        core::mem::take(&mut self.work)
    }

    /// Returns the changes of the variables after t.
    pub(in crate::motion) fn changes(&self, t: f64) -> [f64; ROOM] {
        let Polynomials { length, rates, .. } = &*self.now;
        let mut changes = [0.0; ROOM];
        if t == *length {
            for (place, series) in changes.iter_mut().zip(rates).take(self.variables.count) {
                *place = t * series[0];
            }
            return changes;
        }
        let basis = legendre_integrals(t / length);
        for (place, series) in changes.iter_mut().zip(rates).take(self.variables.count) {
            *place = length * series.iter().zip(basis).map(|(c, p)| c * p).sum::<f64>();
        }
        changes
    }

    /// Returns true if further function k certainly has no zero in the step, because |Pₙ| ≤ 1.
    pub(in crate::motion) fn keeps_its_sign(&self, k: usize) -> bool {
        let [mean, others @ ..] = &self.now.outputs[k];
        others.iter().map(|c| c.abs()).sum::<f64>() < mean.abs()
    }

    /// Returns further function k after t.
    pub(in crate::motion) fn output(&self, t: f64, k: usize) -> f64 {
        let basis = legendre_values(2.0 * t / self.now.length - 1.0);
        self.now.outputs[k].iter().zip(basis).map(|(c, p)| c * p).sum()
    }
}

/// Cost of steps.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::motion) struct StepWork {
    /// Number of evaluations of the equations, one per node.
    pub(in crate::motion) evaluations: u64,
    /// Number of rejected trials, which were too long.
    pub(in crate::motion) rejected: u64,
}

/// Request for a step.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Wanted {
    pub(in crate::motion) time: f64,
    /// Time from the start of the previous step to that of this one.
    pub(in crate::motion) since: f64,
    /// Factor by which the step is longer than proposed.
    pub(in crate::motion) stretch: f64,
    /// Largest length of the step.
    pub(in crate::motion) most: f64,
    /// First time at which the state may be evaluated. If the step ends before it, only the state
    /// at its end matters.
    pub(in crate::motion) first_look: f64,
}

/// Computation of a step from a state.
struct Advance<'a, F> {
    of: &'a mut Collocation,
    system: &'a F,
    /// Inverse sizes of the variables.
    weights: [f64; ROOM],
    wanted: Wanted,
}

impl<F: System> Work for Advance<'_, F> {
    type Output = f64;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> f64 {
        let Self { of, system, weights, wanted } = self;
        let Wanted { time, since, stretch, most, first_look } = wanted;
        let mut h = of.next * stretch;
        for _ in 0..MOST_TRIES {
            // Round h such that it is the exact difference of two times.
            h = (time + h.min(most)) - time;
            let before = of.is_known.then_some(&*of.now);
            let parts = [&of.kinematic[..], &of.dynamic];
            let trial = Trial { before, system, variables: &of.variables, parts, weights: &weights };
            let (rounds, solved) = trial.solved(s, [since, h], &mut of.values, &mut of.trial);
            of.work.evaluations += rounds * NODES as u64;
            let Some(error) = solved else {
                of.work.rejected += 1;
                h *= 0.5;
                continue;
            };
            // The error within the step is of order NODES + 1. The step aims well below the
            // tolerance, because a rejected step costs all of its rounds.
            let best = of.tolerance / 200.0;
            let factor = rough_exp2(rough_log2(best / error.max(1e-40)) / (NODES + 1) as f64);
            // The error at the end is of order 2 NODES, like the square of the truncation error of
            // the polynomial.
            let at_end = (1e3 * of.tolerance).min(0.1 * of.tolerance.sqrt()).max(of.tolerance);
            if error > if first_look < time + h { of.tolerance } else { at_end } {
                of.work.rejected += 1;
                h *= factor.clamp(0.25, 0.9);
                continue;
            }
            if h < most || factor < 1.0 {
                of.next = h * factor.clamp(0.25, 1.5) / stretch;
            }
            core::mem::swap(&mut of.now, &mut of.trial);
            of.is_known = true;
            return h;
        }
        0.0
    }
}

/// Step of a given length.
struct Trial<'a, F> {
    before: Option<&'a Polynomials>,
    system: &'a F,
    variables: &'a Variables,
    /// Indices of the kinematic and of the dynamic variables.
    parts: [&'a [usize]; 2],
    /// Inverse sizes of the variables.
    weights: &'a [f64; ROOM],
}

impl<F: System> Trial<'_, F> {
    /// Computes the polynomials. Returns the number of rounds and the error; `None` if the
    /// iteration does not converge.
    #[inline(always)]
    #[allow(
        clippy::redundant_closure_for_method_calls,
        reason = "a method that is given by its name is not compiled for the vectors of the machine: three times as slow"
    )]
    fn solved<S: Machine>(
        &self,
        s: S,
        [since, h]: [f64; 2],
        values: &mut NodeValues,
        to: &mut Polynomials,
    ) -> (u64, Option<f64>) {
        let Variables { count, kinematic, dynamic, quadratures, outputs } = self.variables;
        let [kinematic_places, dynamic_places] = self.parts;
        let NodeValues { y, f, parities } = values;
        // The nodes before the middle converge earlier than those after it.
        let mut goes_on = [true; 2];
        for (values, start) in y.iter_mut().zip(to.start) {
            *values = Values([[start; HALF]; 2]);
        }
        match self.before {
            Some(before) => extrapolate(s, &before.rates, before.length, f, self.parts, [since, h]),
            None => f.fill(Values::NONE),
        }
        integrate(s, f, [y, parities], &to.start, kinematic_places, h);
        let (mut last, mut rounds) = ([f64::INFINITY; 2], 0_u64);
        loop {
            rounds += 1;
            integrate(s, f, [y, parities], &to.start, dynamic_places, h);
            let of_kinematic = self.evaluate(
                s,
                y,
                f,
                goes_on,
                kinematic,
                #[inline(always)]
                |system, _, y| system.kinematic(y),
            );
            integrate(s, f, [y, parities], &to.start, kinematic_places, h);
            let of_dynamic = self.evaluate(
                s,
                y,
                f,
                goes_on,
                dynamic,
                #[inline(always)]
                |system, one, y| system.dynamic(one, y),
            );
            let mut change = [0.0; 2];
            for half in 0..2 {
                if goes_on[half] {
                    let [a, b, c, d, e, f, g, i] = s.eight_numbers(of_kinematic[half] + of_dynamic[half]);
                    let (now, last) = (h * (((a + b) + (c + d)) + ((e + f) + (g + i))).sqrt(), last[half]);
                    // The next change will be smaller by at least the same factor.
                    let next = if rounds > 1 { now * (now / last).min(1.0) } else { now };
                    goes_on[half] = !(next < CONVERGED || now < 1e-13 && now > 0.3 * last);
                    change[half] = now;
                }
            }
            if goes_on == [false; 2] {
                break;
            }
            let [after, before] = change;
            if !(after + before).is_finite() || rounds == MOST_ROUNDS || rounds > 8 && after > last[0] {
                return (rounds, None);
            }
            last = change;
        }
        let mut further = [Values::NONE; OUTPUTS];
        for half in 0..2 {
            let (one, variables) = loaded(s, y, half);
            let (rates, all) = self.system.quadratures(one, &variables);
            for (rate, place) in rates.iter().zip(quadratures) {
                if let Some(k) = *place {
                    f[k].0[half] = s.eight_numbers(rate.0);
                }
            }
            for (values, one) in further.iter_mut().zip(all) {
                values.0[half] = s.eight_numbers(one.0);
            }
        }
        for (series, values) in to.outputs.iter_mut().zip(&further).take(*outputs) {
            *series = coefficients(s, &by_parity(s, values));
        }
        to.length = h;
        let (mut last, mut before) = (0.0_f64, 0.0_f64);
        // Store all of them first: a multiplication can then broadcast them from memory to a
        // vector.
        for (parities, f) in parities.iter_mut().zip(f.iter()).take(*count) {
            *parities = by_parity(s, f);
        }
        let all = to.rates.iter_mut().zip(parities.iter()).zip(self.weights);
        for ((rates, parities), weight) in all.take(*count) {
            *rates = coefficients(s, parities);
            let [.., a, b, c, d] = *rates;
            let weight = h * weight;
            before = before.max(weight * a.abs()).max(weight * b.abs());
            last = last.max(weight * c.abs()).max(weight * d.abs());
        }
        // Estimate of the first truncated term, integrated.
        let ratio = if last < before { (last / before).sqrt() } else { 1.0 };
        let error = last * ratio / (2 * NODES + 2) as f64;
        (rounds, error.is_finite().then_some(error))
    }

    /// Computes the rates of one part of the variables at the nodes of the given halves. Returns
    /// the squares of their changes.
    #[inline(always)]
    fn evaluate<S: Machine, const N: usize>(
        &self,
        s: S,
        y: &[Values; ROOM],
        f: &mut [Values; ROOM],
        halves: [bool; 2],
        part: &Places<N>,
        rates_of: impl Fn(&F, Side<S::Eight>, &[Side<S::Eight>; ROOM]) -> [Side<S::Eight>; N],
    ) -> [S::Eight; 2] {
        let mut squares = [s.eight(0.0); 2];
        for half in 0..2 {
            if !halves[half] {
                continue;
            }
            let (one, variables) = loaded(s, y, half);
            let rates = rates_of(self.system, one, &variables);
            for (rate, place) in rates.iter().zip(part) {
                if let Some(k) = *place {
                    let change = (rate.0 - s.load_eight(&f[k].0[half])) * s.eight(self.weights[k]);
                    squares[half] = change.mul_add(change, squares[half]);
                    f[k].0[half] = s.eight_numbers(rate.0);
                }
            }
        }
        squares
    }
}

/// Returns the constant 1 and the variables at the nodes of a half.
#[inline(always)]
fn loaded<S: Machine>(s: S, y: &[Values; ROOM], half: usize) -> (Side<S::Eight>, [Side<S::Eight>; ROOM]) {
    let one = Side(s.eight(1.0));
    let mut variables = [one; ROOM];
    for (variable, values) in variables.iter_mut().zip(y) {
        *variable = Side(s.load_eight(&values.0[half]));
    }
    (one, variables)
}
