//! Rows of few digits, and steps in single precision.

use super::found::TriedCause;
use super::name::Cause;
use super::trial::Trials;
use crate::infer::judge::motion::ReadMotion;
use crate::math::rotation::Rotation;
use crate::motion::State;

/// How the numbers of a log are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rounding {
    /// To the 24 bits of single precision.
    Single,
    /// To so many digits behind the point.
    Decimals(u32),
}

/// More digits than these are no rounding that matters.
const MOST_DECIMALS: u32 = 8;

/// Rows that are looked at, at most.
const LOOKED: usize = 64;

/// 2⁻²⁴, the rounding of single precision.
const SINGLE: f64 = 1.0 / (1_u64 << 24) as f64;

impl Rounding {
    /// That of the attitudes of a log.
    pub(super) fn of(motion: &ReadMotion) -> Option<Self> {
        let stride = motion.attitude.len() / LOOKED + 1;
        // A number that is exact, such as the 1 of the start, has any rounding.
        let rows = || motion.attitude.iter().skip(1).step_by(stride).flatten().copied();
        if rows().all(is_single) {
            return Some(Self::Single);
        }
        (1..=MOST_DECIMALS).map(Self::Decimals).find(|rounding| rows().all(|x| rounding.rounded(x) == x))
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

/// Is it a number of single precision, or the shortest decimal of one?
fn is_single(x: f64) -> bool {
    let single = x as f32;
    f64::from(single) == x || format!("{single}").parse() == Ok(x)
}

impl Trials<'_> {
    /// The exact motion with rounded rows; and steps in single precision, which are not computed again but known by their size.
    pub(super) fn try_rounding(&mut self, motion: &ReadMotion, step: Option<f64>) {
        let Some(rounding) = Rounding::of(motion) else { return };
        let states: Vec<State> = self.rows.exact.iter().map(|state| rounding.state(state)).collect();
        self.try_states(Cause::RoundedRows(rounding.decimals()), &states);
        if rounding == Rounding::Single && !self.tried.iter().any(|tried| tried.passes) {
            let steps = self.duration() / step.unwrap_or(self.rows.spacing);
            let error = self.rows.base(usize::MAX);
            let part = |count: usize| self.rows.base(count).attitude;
            let count = self.rows.times.len();
            let grows = error.attitude > 2.0 * part(count / 4);
            let is_so_large = SINGLE < error.attitude && error.attitude < 2.0 * SINGLE * steps.max(1.0);
            self.tried.push(TriedCause {
                cause: Cause::SinglePrecisionArithmetic,
                residual: error.attitude,
                error: error.attitude,
                explained: 0.0,
                is_named: false,
                score: 1.0,
                passes: grows && is_so_large,
            });
        }
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
