//! Rows with few digits, and steps in single precision.

use super::found::TriedCause;
use super::name::Cause;
use super::trial::Trials;
use crate::infer::judge::motion::ReadMotion;
use crate::math::rotation::Rotation;
use crate::motion::model::state::State;

/// Rounding of the numbers of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rounding {
    /// Rounded to the 24 bits of single precision.
    Single,
    /// Rounded to this number of decimals.
    Decimals(u32),
}

/// Largest number of decimals that counts as rounding.
const MOST_DECIMALS: u32 = 8;

/// Number of decimals that is below single precision.
const FEW_DECIMALS: u32 = 6;

/// Maximum number of rows that are examined.
const LOOKED: usize = 64;

/// Largest ratio of the error to the rounding error for which rounding explains it.
const LEVEL: f64 = 1.5;

/// Assumed number of steps between two rows, if it is unknown.
const MOST_STEPS_A_ROW: f64 = 100.0;

/// Relative rounding of single precision, 2⁻²⁴.
const SINGLE: f64 = 1.0 / (1_u64 << 24) as f64;

impl Rounding {
    /// Returns the rounding of the attitudes of a log.
    pub(super) fn of(motion: &ReadMotion) -> Option<Self> {
        let stride = motion.attitude.len() / LOOKED + 1;
        // An exact number, such as the 1 of the start, is consistent with any rounding.
        let rows = || motion.attitude.iter().skip(1).step_by(stride).flatten().copied();
        let all = |rounding: &Self| rows().all(|x| rounding.rounded(x) == x);
        let decimals = |least: u32, most: u32| (least..=most).map(Self::Decimals).find(all);
        let single = || is_shortest(rows()).then_some(Self::Single);
        let exactly = rows().all(is_near_single).then_some(Self::Single);
        exactly
            .or_else(|| decimals(1, FEW_DECIMALS))
            .or_else(single)
            .or_else(|| decimals(FEW_DECIMALS + 1, MOST_DECIMALS))
    }

    fn rounded(self, x: f64) -> f64 {
        match self {
            Self::Single => f64::from(x as f32),
            Self::Decimals(count) => {
                let scale = 10_f64.powi(count.cast_signed());
                (x * scale).round() / scale
            }
        }
    }

    fn state(self, state: &State) -> State {
        let attitude = state.attitude.quaternion().map(|x| self.rounded(x));
        let omega = state.omega.to_array().map(|x| self.rounded(x));
        State {
            attitude: Rotation::from_quaternion(attitude).unwrap_or(state.attitude),
            omega: omega.into(),
            ..*state
        }
    }
}

/// Returns true if it is a number of single precision, printed with nine digits or more.
fn is_near_single(x: f64) -> bool {
    (x - f64::from(x as f32)).abs() <= 1e-9 * x.abs()
}

/// Returns true if the numbers are the shortest decimals of single-precision numbers. Every decimal
/// of up to seven digits is one, so some numbers must have more digits.
fn is_shortest(mut rows: impl Iterator<Item = f64> + Clone) -> bool {
    let shortest = |x: f64| format!("{:e}", x as f32);
    let digits = |x: f64| {
        shortest(x).split('e').next().map_or(0, |digits| digits.bytes().filter(u8::is_ascii_digit).count())
    };
    rows.clone().any(|x| digits(x) > 7) && rows.all(|x| shortest(x).parse() == Ok(x))
}

impl Trials<'_> {
    /// Tries the exact motion with rounded rows, and steps in single precision. These are not
    /// reproduced bit by bit; they are recognised by the size of their errors.
    pub(super) fn try_rounding(&mut self, motion: &ReadMotion, step: Option<f64>) {
        let Some(rounding) = Rounding::of(motion) else { return };
        let states: Vec<State> = self.rows.exact.iter().map(|state| rounding.state(state)).collect();
        let error = self.rows.base(usize::MAX).attitude;
        let rounded =
            self.rows.exact.iter().zip(&states).map(|(a, b)| a.attitude.angle_to(b.attitude).powi(2));
        let rounded = (rounded.sum::<f64>() / states.len() as f64).sqrt();
        let is_rounding = error < LEVEL * rounded;
        self.try_states(Cause::RoundedRows(rounding.decimals()), &states);
        if let Some(tried) = self.tried.last_mut() {
            tried.passes = is_rounding;
        }
        if rounding != Rounding::Single || self.tried.iter().any(|tried| tried.passes) {
            return;
        }
        let steps =
            step.map_or(MOST_STEPS_A_ROW * self.duration() / self.rows.spacing, |h| self.duration() / h);
        let grows = error > 2.0 * self.rows.base(states.len() / 4).attitude;
        self.tried.push(TriedCause {
            cause: Cause::SinglePrecisionArithmetic,
            residual: error,
            error,
            explained: 0.0,
            is_named: false,
            score: 1.0,
            passes: grows && error < LEVEL * SINGLE * steps.max(1.0),
        });
    }
}

impl Rounding {
    const fn decimals(self) -> Option<u32> {
        match self {
            Self::Single => None,
            Self::Decimals(count) => Some(count),
        }
    }
}
