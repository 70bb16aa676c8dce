//! Series of torques that depend on time alone: all coefficients of an operation before the next.

use super::super::super::recurrence::over;
use super::super::super::row::Row;
use super::super::super::sums::SeriesSums;
use super::super::Known;
use super::step::{Constant, TapeStep, circle_length};
use super::{Tape, times};
use crate::math::formula::Unary;
use crate::math::number::Number;
use crate::motion::model::torque::graph::{Operation, ScalarOperation, VectorOperation};

impl<N: Number> Tape<N> {
    /// Computes all coefficients up to `order` of torques that depend on time alone.
    ///
    /// Each operation is evaluated completely before the next, except in the circles of integrals,
    /// such as sine and cosine.
    #[inline(always)]
    pub(in super::super::super) fn expand<M: SeriesSums<N = N>>(
        &mut self,
        order: usize,
        known: &Known<'_, M>,
    ) {
        let steps = core::mem::take(&mut self.steps[0]);
        let mut from = 0;
        while from < steps.len() {
            let circle = &steps[from..from + circle_length(&steps[from..])];
            from += circle.len();
            let is_done = match circle {
                [step] => self.expand_linear(step, order),
                [sine, cosine, _] => self.expand_wave([sine, cosine], order),
                _ => false,
            };
            if is_done {
                continue;
            }
            // Constants have only coefficient 0.
            let last = if circle[0].constant == Constant::All { 0 } else { order };
            for n in 0..=last {
                for step in circle {
                    self.evaluate(step, n, known);
                }
            }
        }
        self.steps[0] = steps;
    }

    /// Computes all coefficients of the sine and cosine of a linear function a + b t: (n + 1) sₙ₊₁ =
    /// b cₙ, (n + 1) cₙ₊₁ = −b sₙ. Returns false for other operations.
    #[inline(always)]
    fn expand_wave(&mut self, [sine, cosine]: [&TapeStep; 2], order: usize) -> bool {
        use ScalarOperation as Op;
        let (
            Operation::Scalar(Op::IntegralBy { start: Unary::Sin, of, .. }),
            Operation::Scalar(second @ Op::IntegralBy { start: Unary::Cos, .. }),
            Constant::Linear,
        ) = (sine.operation, cosine.operation, sine.constant)
        else {
            return false;
        };
        let Operation::Scalar(first) = sine.operation else { return false };
        let (mut s, mut c) = (self.function(first), self.function(second));
        let zero = self.time.like(0.0);
        let slope = self.numbers[of][1];
        let Some([sines, cosines, negatives]) = self.numbers.get_mut(sine.place..=sine.place + 2) else {
            return false;
        };
        for n in 0..=order {
            (sines[n], cosines[n], negatives[n]) = (s, c, zero - s);
            (s, c) = (over(slope * c, n + 1), over(zero - slope * s, n + 1));
        }
        true
    }

    /// Computes all coefficients of a linear operation. Returns false for others. The values are
    /// those of [`Tape::number`] and [`Tape::vector`].
    #[inline(always)]
    fn expand_linear(&mut self, &TapeStep { operation, place, .. }: &TapeStep, order: usize) -> bool {
        use ScalarOperation as S;
        use VectorOperation as V;
        let (numbers, vectors) = (&mut self.numbers, &mut self.vectors);
        match operation {
            Operation::Scalar(operation) => {
                let (known, [series, ..]) = numbers.split_at_mut(place) else { return false };
                match operation {
                    S::Negate(a) => {
                        let zero = self.time.like(0.0);
                        for n in 0..=order {
                            series[n] = zero - known[a][n];
                        }
                    }
                    S::Scale(a, k) => {
                        for n in 0..=order {
                            series[n] = self.constants[k] * known[a][n];
                        }
                    }
                    S::Add(a, b) => {
                        for n in 0..=order {
                            series[n] = known[a][n] + known[b][n];
                        }
                    }
                    S::Subtract(a, b) => {
                        for n in 0..=order {
                            series[n] = known[a][n] - known[b][n];
                        }
                    }
                    _ => return false,
                }
            }
            Operation::Vector(operation) => {
                let (known, [series, ..]) = vectors.split_at_mut(place) else { return false };
                match operation {
                    V::Of([x, y, z]) => {
                        let ([x, y, z], zero) = ([x, y, z].map(|place| &numbers[place]), self.time.like(0.0));
                        for n in 0..=order {
                            series.set(n, Row([x[n], y[n], z[n], zero]));
                        }
                    }
                    V::Image(k, a) => {
                        let columns = &self.matrices[k];
                        for n in 0..=order {
                            series.set(n, times(columns, known[a].at(n)).vector());
                        }
                    }
                    V::Add(a, b) => {
                        for n in 0..=order {
                            series.set(n, (known[a].at(n) + known[b].at(n)).vector());
                        }
                    }
                    _ => return false,
                }
            }
        }
        true
    }
}
