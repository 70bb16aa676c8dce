//! What a motion must not do: run away, or take more steps than there is time for.

use super::piece::Piece;
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::solve::limits::MOST_STEPS;

/// Steps after which the step has found its size.
const FIRST_STEPS: u64 = 64;

/// Number of consecutive steps for which the projected count may exceed the limit before the run is abandoned: they may shrink towards infinity, where DOP853 comes in some 700 at a
/// tolerance of 1e-14.
pub(crate) const PATIENCE: u64 = 2000;

/// The plausibility bound: |ω| of a motion that runs away, relative to what is usual.
const BELIEVED: f64 = 1e3;

/// |ω| that nothing has that is meant, relative to what is usual.
const ABSURD: f64 = 1e9;

/// A bound for |ω|, and for the number of steps.
///
/// What is usual is |ω| at the start, every √(N/I) at which something begins to act, I the least moment, and one radian in the whole run.
/// Nothing that is meant turns 10⁹ times faster. From 10³ times that on a motion is implausible, if it ends so.
///
/// P is a place on the trajectory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound<P> {
    usual_rate: f64,
    /// When the motion began, s.
    begun: f64,
    /// Start of the current run of steps whose |ω| exceeds the plausibility bound.
    plausible: Option<Plausible<P>>,
    /// For how many steps, one after the other, the end has been too far away, and the number of the last of them.
    far: [u64; 2],
}

#[derive(Clone, Copy, Debug)]
struct Plausible<P> {
    time: f64,
    rate: f64,
    place: P,
    /// The number of the last step since then.
    step: u64,
}

impl<P: Copy> Bound<P> {
    pub(super) fn new(piece: &Piece<'_>, start: &State) -> Self {
        let usual_rate = start.omega.norm().max(torque_rate(piece));
        Self { usual_rate, begun: start.time, plausible: None, far: [0; 2] }
    }

    /// What acts from now on.
    pub(super) fn act(&mut self, piece: &Piece<'_>) {
        self.usual_rate = self.usual_rate.max(torque_rate(piece));
    }

    /// When the motion is to end, s.
    pub(super) fn end(&mut self, end: f64) {
        self.usual_rate = self.usual_rate.max(1.0 / (end - self.begun));
    }

    /// |ω| from which on a motion is implausible if it ends so, rad/s.
    pub(super) fn most(&self) -> f64 {
        BELIEVED * self.usual_rate
    }

    /// Looks at |ω| after a step, the steps being numbered; `before` is asked for the time, |ω| and place where it began.
    ///
    /// # Errors
    /// [`MotionError::RunAway`].
    pub(super) fn require(
        &mut self,
        step: u64,
        rate: f64,
        before: impl FnOnce() -> (f64, f64, P),
    ) -> Result<(), MotionError> {
        if rate <= self.most() {
            self.plausible = None;
            return Ok(());
        }
        match &mut self.plausible {
            Some(plausible) if plausible.step + 1 == step => plausible.step = step,
            _ => {
                let (time, rate, place) = before();
                self.plausible = Some(Plausible { time, rate, place, step });
            }
        }
        match self.run_away() {
            Some((_, error)) if !(rate <= ABSURD * self.usual_rate) => Err(error),
            _ => Ok(()),
        }
    }

    /// Looks at how far the end is after a step, the steps being numbered; `allowed` is the next step, and `now` time and |ω|.
    ///
    /// # Errors
    /// [`MotionError::TooManySteps`], or [`MotionError::RunAway`] if that is why.
    pub(super) fn require_few_steps(
        &mut self,
        step: u64,
        allowed: f64,
        now: [f64; 2],
        end: f64,
    ) -> Result<(), MotionError> {
        let [time, _] = now;
        if step < FIRST_STEPS || !(step as f64 + (end - time) / allowed > MOST_STEPS as f64) {
            return Ok(());
        }
        let [count, last] = self.far;
        self.far = [if last + 1 == step { count + 1 } else { 1 }, step];
        if self.far[0] <= PATIENCE {
            return Ok(());
        }
        Err(self.explained(MotionError::TooManySteps { time, step: allowed, most: MOST_STEPS }, now))
    }

    /// The last plausible state, if the motion has left the bound.
    pub(super) fn last_plausible(&self) -> Option<P> {
        self.plausible.map(|plausible| plausible.place)
    }

    /// Why a motion cannot go on from here, time and |ω|: that it runs away, if |ω| has grown to ten times the bound within less time
    /// than it took to come there. Towards infinity steps shrink to nothing before |ω| is large enough by itself.
    pub(super) fn explained(&self, cause: MotionError, [now, rate]: [f64; 2]) -> MotionError {
        match self.run_away() {
            Some((time, error)) if now - time < time - self.begun && rate > 10.0 * self.most() => error,
            _ => cause,
        }
    }

    /// When it was last plausible, and what it is to end there.
    fn run_away(&self) -> Option<(f64, MotionError)> {
        let Plausible { time, rate, .. } = self.plausible?;
        Some((time, MotionError::RunAway { time, rate, most: self.most() }))
    }
}

/// √(N/I), rad/s, of the least moment that is one.
fn torque_rate(piece: &Piece<'_>) -> f64 {
    let moments = piece.rotor.principal().moments();
    let least = moments.into_iter().find(|i| *i > 0.0).unwrap_or(f64::INFINITY);
    (piece.largest_torque / least).sqrt()
}
