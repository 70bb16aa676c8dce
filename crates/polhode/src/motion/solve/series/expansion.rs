//! Taylor series of the solution of a system about a state.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3; À. Jorba, M. Zou, Exp. Math. 14
//! (2005) 99.

use super::graph::{Form, Step, System};
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number as _;
use crate::motion::solve::propagate::taylor::length::{order, reach, remainder, rough_exp2, rough_log2};

/// Capacity for the coefficients of a series, a multiple of four.
const ROOM: usize = 28;

/// Largest order. Sums are computed four terms at a time, and the rates need one more coefficient.
const MOST: usize = ROOM - 4;

/// Coefficients in ascending and in descending order, so that a convolution reads both forwards.
#[derive(Clone, Debug)]
struct Coefficients {
    ascending: [f64; ROOM],
    /// Coefficient n has the index ROOM − 1 − n. The zeros that follow cover the terms that a sum
    /// by fours reads beyond the end.
    descending: [f64; ROOM + 4],
}

impl Coefficients {
    const ZERO: Self = Self { ascending: [0.0; ROOM], descending: [0.0; ROOM + 4] };

    #[inline(always)]
    fn set(&mut self, n: usize, x: f64) {
        self.ascending[n] = x;
        self.descending[ROOM - 1 - n] = x;
    }
}

/// Returns `sums` + Σ aₖ bₙ₋ₖ, k = 0 … n, four terms at a time.
#[inline(always)]
fn convolution<S: Machine>(s: S, sums: S::Four, a: &Coefficients, b: &Coefficients, n: usize) -> S::Four {
    let (ahead, back) = (&a.ascending[..=n | 3], &b.descending[ROOM - 1 - n..]);
    let mut sums = sums;
    for (a, b) in ahead.as_chunks::<4>().0.iter().zip(back.as_chunks::<4>().0) {
        sums = s.load(a).mul_add(s.load(b), sums);
    }
    sums
}

#[inline(always)]
fn total<S: Machine>(s: S, sums: S::Four) -> f64 {
    let [a, b, c, d] = s.numbers(sums);
    (a + b) + (c + d)
}

/// System with the Taylor series of its solution about a state.
#[derive(Clone, Debug)]
pub(in crate::motion) struct Expansion {
    system: System,
    order: usize,
    /// Highest order whose coefficients are finite.
    last: usize,
    /// log₂ of the step length divided by the radius of convergence.
    reach: f64,
    steps: Vec<Coefficients>,
    variables: Vec<[f64; ROOM]>,
    outputs: Vec<[f64; ROOM]>,
}

impl Expansion {
    /// Creates an expansion without a state. `tolerance` is per step, relative to the sizes of the
    /// variables.
    pub(in crate::motion) fn new(system: System, tolerance: f64) -> Self {
        let order = order(tolerance).min(MOST);
        let [variables, outputs] = [&system.rates, &system.outputs].map(|all| vec![[0.0; ROOM]; all.len()]);
        let steps = vec![Coefficients::ZERO; system.steps.len()];
        Self {
            system,
            order,
            last: order,
            reach: reach(order, remainder(tolerance)),
            steps,
            variables,
            outputs,
        }
    }

    /// Computes the series about a state, and returns the largest step from it. `sizes`: scales of
    /// the variables and of the further functions.
    pub(in crate::motion) fn about(&mut self, state: &[f64], sizes: [&[f64]; 2]) -> f64 {
        for (series, &x) in self.variables.iter_mut().zip(state) {
            series[0] = x;
        }
        for coefficients in &mut self.steps {
            coefficients.ascending = [0.0; ROOM];
        }
        in_vectors(Coming(self));
        self.length(sizes)
    }

    /// Computes coefficient n of all series. The coefficients of the variables up to n must be
    /// known.
    #[inline(always)]
    fn work_out<S: Machine>(&mut self, s: S, n: usize) {
        for (own, step) in self.system.steps.iter().enumerate() {
            let steps = &mut self.steps;
            let value = match step {
                Step::Variable(k) => self.variables[*k][n],
                Step::Form(of) => form(s, of, steps, n),
                Step::Divide(..) | Step::Invert(_) | Step::Root(_) => {
                    // The coefficient is not known yet; zero does not contribute to the sums.
                    steps[own].set(n, 0.0);
                    implicit(s, step, steps, own, n)
                }
            };
            steps[own].set(n, value);
        }
        for (k, rate) in self.system.rates.iter().enumerate() {
            let rate = form(s, rate, &self.steps, n);
            if let Some(next) = self.variables[k].get_mut(n + 1) {
                *next = rate / (n + 1) as f64;
            }
        }
        for (k, output) in self.system.outputs.iter().enumerate() {
            self.outputs[k][n] = form(s, output, &self.steps, n);
        }
    }

    /// Returns the longest step for which the truncated terms are below the tolerance, from the
    /// last two finite coefficients.
    fn length(&mut self, [sizes, of_outputs]: [&[f64]; 2]) -> f64 {
        let log_radius = |n: usize| {
            let largest = |size: f64, (series, scale): (&[f64; ROOM], &f64)| {
                let x = series[n].abs() / scale;
                // maximum that propagates NaN
                if size.is_nan() || x <= size { size } else { x }
            };
            let size = self.variables.iter().zip(sizes).fold(0.0, largest);
            let size = self.outputs.iter().zip(of_outputs).fold(size, largest);
            if size.is_finite() { -rough_log2(size) / n as f64 } else { f64::NAN }
        };
        let pairs = (2..=self.order).rev().map(|n| (n, [log_radius(n), log_radius(n - 1)]));
        let finite = pairs.into_iter().find(|(_, [last, before])| !last.is_nan() && !before.is_nan());
        let Some((n, [last, before])) = finite else { return f64::NAN };
        self.last = n;
        rough_exp2(last.min(before) + self.reach)
    }

    /// Sets the series of a motion that is known otherwise, from the coefficients of the variables
    /// and of the further functions.
    pub(in crate::motion) fn impose(&mut self, variables: &[Vec<f64>], outputs: &[Vec<f64>]) {
        let fill = |series: &mut Vec<[f64; ROOM]>, given: &[Vec<f64>]| {
            for (series, given) in series.iter_mut().zip(given) {
                *series = [0.0; ROOM];
                series.iter_mut().zip(given).for_each(|(place, c)| *place = *c);
            }
        };
        fill(&mut self.variables, variables);
        fill(&mut self.outputs, outputs);
        self.last = variables.first().map_or(0, |series| series.len() - 1);
    }

    /// Returns the number of coefficients computed per step.
    pub(in crate::motion) const fn terms(&self) -> u64 {
        self.order as u64 + 1
    }

    /// Returns the change of variable k after h.
    pub(in crate::motion) fn change(&self, h: f64, k: usize) -> f64 {
        let [_, series @ ..] = &self.variables[k];
        series[..self.last].iter().rev().fold(0.0, |sum, c| sum * h + c) * h
    }

    /// Returns variable k after h.
    pub(in crate::motion) fn variable(&self, h: f64, k: usize) -> f64 {
        self.variables[k][0] + self.change(h, k)
    }

    /// Returns further function k after h.
    pub(in crate::motion) fn output(&self, h: f64, k: usize) -> f64 {
        self.outputs[k][..self.last].iter().rev().fold(0.0, |sum, c| sum * h + c)
    }
}

/// Computation of all coefficients in ascending order.
struct Coming<'e>(&'e mut Expansion);

impl Work for Coming<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Machine>(self, s: S) {
        for n in 0..=self.0.order {
            self.0.work_out(s, n);
        }
    }
}

/// Returns coefficient n of a quotient or a root, from its previous coefficients.
#[inline(always)]
fn implicit<S: Machine>(s: S, step: &Step, steps: &[Coefficients], own: usize, n: usize) -> f64 {
    let c = &steps[own];
    let known = |b: &Coefficients| total(s, convolution(s, s.splat(0.0), b, c, n));
    match *step {
        // b c = a
        Step::Divide(a, b) => (steps[a].ascending[n] - known(&steps[b])) / steps[b].ascending[0],
        Step::Invert(b) => {
            let one = if n == 0 { 1.0 } else { 0.0 };
            (one - known(&steps[b])) / steps[b].ascending[0]
        }
        // c c = a
        Step::Root(a) if n == 0 => steps[a].ascending[0].sqrt(),
        Step::Root(a) => 0.5 * (steps[a].ascending[n] - known(c)) / c.ascending[0],
        Step::Variable(_) | Step::Form(_) => f64::NAN,
    }
}

/// Returns coefficient n of a form.
#[inline(always)]
fn form<S: Machine>(s: S, form: &Form, steps: &[Coefficients], n: usize) -> f64 {
    let mut sum = if n == 0 { form.constant } else { 0.0 };
    for (factor, pairs) in &form.products {
        let mut sums = s.splat(0.0);
        for &[a, b] in pairs {
            sums = convolution(s, sums, &steps[a], &steps[b], n);
        }
        sum += factor * total(s, sums);
    }
    for &(a, factor) in &form.terms {
        sum += factor * steps[a].ascending[n];
    }
    sum
}
