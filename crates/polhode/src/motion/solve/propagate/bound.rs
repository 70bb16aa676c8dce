//! Bounds on a motion: detection of divergence, and of runs with too many steps.

use super::piece::Piece;
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::solve::limits::MOST_STEPS;

/// Number of steps after which the step size has settled.
const FIRST_STEPS: u64 = 64;

/// Number of consecutive steps with a projected count above the limit after which the run is
/// abandoned. A motion towards infinity shrinks its steps. DOP853 needs some 700 of them at a
/// tolerance of 1e-14.
pub(crate) const PATIENCE: u64 = 2000;

/// Plausibility bound on |ω| of a diverging motion, relative to the usual rate.
const BELIEVED: f64 = 1e3;

/// |ω|, relative to the usual rate, at which a motion is stopped immediately.
const ABSURD: f64 = 1e9;

/// Bound on |ω| and on the number of steps.
///
/// The usual rate is the largest of: |ω| at the start; √(N/I) whenever a torque begins to act,
/// where I is the least moment; and one radian in the whole run. No intended motion is 10⁹ times
/// faster. A motion that ends above 10³ times the usual rate is implausible.
///
/// `P` is a place on the trajectory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound<P> {
    usual_rate: f64,
    /// Start time of the motion, s.
    begun: f64,
    /// Start of the current sequence of steps whose |ω| exceeds the plausibility bound.
    plausible: Option<Plausible<P>>,
    /// Number of consecutive steps for which the end was too far away, and the number of the last
    /// of them.
    far: [u64; 2],
}

#[derive(Clone, Copy, Debug)]
struct Plausible<P> {
    time: f64,
    rate: f64,
    place: P,
    /// Number of the last step of this sequence.
    step: u64,
}

impl<P: Copy> Bound<P> {
    pub(super) fn new(piece: &Piece<'_>, start: &State) -> Self {
        let usual_rate = start.omega.norm().max(torque_rate(piece));
        Self { usual_rate, begun: start.time, plausible: None, far: [0; 2] }
    }

    /// Updates the usual rate when the acting torques change.
    pub(super) fn act(&mut self, piece: &Piece<'_>) {
        self.usual_rate = self.usual_rate.max(torque_rate(piece));
    }

    /// Updates the usual rate for the end of the motion, s.
    pub(super) fn end(&mut self, end: f64) {
        self.usual_rate = self.usual_rate.max(1.0 / (end - self.begun));
    }

    /// Returns the plausibility bound on |ω|, rad/s.
    pub(super) fn most(&self) -> f64 {
        BELIEVED * self.usual_rate
    }

    /// Checks |ω| after step number `step`. `before` returns time, |ω| and place of the start of
    /// the step.
    ///
    /// # Errors
    /// [`MotionError::RunAway`] if |ω| exceeds the larger of the two bounds.
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

    /// Checks the projected number of steps after step number `step`. `allowed`: next step, s.
    /// `now`: time and |ω|.
    ///
    /// # Errors
    /// [`MotionError::TooManySteps`] if it has exceeded the limit for `PATIENCE` steps, or
    /// [`MotionError::RunAway`] if that is the cause.
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

    /// Returns the last plausible place, if |ω| now exceeds the plausibility bound.
    pub(super) fn last_plausible(&self) -> Option<P> {
        self.plausible.map(|plausible| plausible.place)
    }

    /// Returns the reason why a motion cannot continue from `now` (time and |ω|).
    ///
    /// The reason is [`MotionError::RunAway`] if |ω| exceeds ten times the bound and has grown to
    /// it in less time than it took to reach the bound; otherwise `cause`. If |ω| tends to
    /// infinity, the steps become too small before |ω| reaches the larger bound.
    pub(super) fn explained(&self, cause: MotionError, [now, rate]: [f64; 2]) -> MotionError {
        match self.run_away() {
            Some((time, error)) if now - time < time - self.begun && rate > 10.0 * self.most() => error,
            _ => cause,
        }
    }

    /// Returns the time of the last plausible state, and the error that the motion has there.
    fn run_away(&self) -> Option<(f64, MotionError)> {
        let Plausible { time, rate, .. } = self.plausible?;
        Some((time, MotionError::RunAway { time, rate, most: self.most() }))
    }
}

/// Returns √(N/I), rad/s, where I is the least moment that is not zero.
fn torque_rate(piece: &Piece<'_>) -> f64 {
    let moments = piece.rotor.principal().moments();
    let least = moments.into_iter().find(|i| *i > 0.0).unwrap_or(f64::INFINITY);
    (piece.largest_torque / least).sqrt()
}
