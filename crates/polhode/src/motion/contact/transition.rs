//! Transitions between phases: the equations that hold after a change of the contact.

use super::change::{ContactChange, ContactEvent};
use super::equations::{AXES, Kinetics, OMEGA, PLACE, Pivot, Regime, VELOCITY};
use super::flight;
use super::stepper::Stepper;
use super::system::OnGround;
use super::watch::{Kind, Watch};
use crate::math::algebra::Components;
use crate::math::root::root;
use crate::motion::error::MotionError;

/// Number of trial directions of slip.
const DIRECTIONS: u32 = 72;

/// Slip of trial evaluations at the onset, relative to the scale of velocities: much smaller than
/// the motion, much larger than rounding.
const TRIAL: f64 = 1e-8;

/// Relative slip with which slipping starts.
const BEGINNING: f64 = 2e-13;

impl OnGround<'_> {
    /// Determines the phase at the start of a body that friction may hold.
    ///
    /// # Errors
    /// The errors of [`OnGround::pass`].
    pub(super) fn settle_start(&mut self) -> Result<Option<ContactChange>, MotionError> {
        let stepper = &mut self.stepper;
        let y = stepper.variables().to_vec();
        let (Some(at), Kind::Touching(regime, _)) = (stepper.kinetics(&y), stepper.kind()) else {
            return Ok(None);
        };
        // Pivoting friction that holds the body from the start.
        if stepper.model.pivoting != 0.0 {
            let rate = at.relative.dot(at.normal);
            if rate.abs() <= 1e-13 * stepper.rate(&y) {
                stepper.enter(Kind::Touching(regime, Pivot::Held), y.clone());
                let holding = stepper.kinetics(&y).map_or(0.0, |at| at.holding);
                if stepper.watched(Watch::Holding).is_some_and(|margin| margin < 0.0) {
                    stepper.enter(Kind::Touching(regime, Pivot::Turning(-holding.signum())), y.clone());
                }
            } else {
                stepper.enter(Kind::Touching(regime, Pivot::Turning(rate.signum())), y.clone());
            }
        }
        self.settle()
    }

    /// Checks if the phase that begins can last.
    fn settle(&mut self) -> Result<Option<ContactChange>, MotionError> {
        const STRICT: [Watch; 6] =
            [Watch::Inertance, Watch::NormalForce, Watch::Grip, Watch::Holding, Watch::Ends, Watch::Fit];
        let broken = |watch: &&Watch| self.stepper.watched(**watch).is_some_and(|value| value < 0.0);
        match STRICT.iter().find(broken) {
            Some(watch) => self.pass(*watch),
            None => Ok(None),
        }
    }

    /// Continues after a watched function has vanished.
    ///
    /// # Errors
    /// [`MotionError::Painleve`]; [`MotionError::Undecided`] if changes do not end.
    pub(super) fn pass(&mut self, watch: Watch) -> Result<Option<ContactChange>, MotionError> {
        /// Maximum number of changes at one time.
        const MOST: usize = 32;
        let y = self.stepper.variables().to_vec();
        let time = self.stepper.time();
        if self.changes.iter().rev().take_while(|change| change.time == time).count() == MOST {
            return Err(MotionError::Undecided { time });
        }
        match (watch, self.stepper.kind()) {
            (Watch::NormalForce, _) => return self.leave(&y),
            (Watch::Inertance, _) => return Err(MotionError::Painleve { time }),
            (Watch::RollingRate, _) => return Ok(self.end(ContactChange::RollingStops)),
            (Watch::OtherRim, _) => return Ok(self.end(ContactChange::OtherRim)),
            (Watch::Slope, _) => return Ok(self.end(ContactChange::LiesFlat)),
            (Watch::Ends, _) => return Ok(self.end(ContactChange::TipsOver)),
            (Watch::Fit, _) => return Ok(self.end(ContactChange::Osculates)),
            (Watch::Gap, _) => {
                let (_, gap) = self.stepper.model.flight(1.0, &y);
                if gap.abs() > 1e-9 * self.stepper.size() {
                    return Err(MotionError::Undecided { time });
                }
                return Ok(self.end(ContactChange::Lands));
            }
            (Watch::Grip, _) => self.slip(&y, ContactChange::Slips)?,
            (Watch::SlipSpeed, _) => {
                self.enter_rolling(&y);
                if self.stepper.watched(Watch::Grip).is_some_and(|margin| margin < 0.0) {
                    let y = self.stepper.variables().to_vec();
                    self.slip(&y, ContactChange::SlipsAnew)?;
                } else {
                    self.note(ContactChange::Grips);
                }
            }
            (Watch::Turning, Kind::Touching(regime, Pivot::Turning(sense))) => {
                self.stepper.enter(Kind::Touching(regime, Pivot::Held), y.clone());
                if self.stepper.watched(Watch::Holding).is_some_and(|margin| margin < 0.0) {
                    self.stepper.enter(Kind::Touching(regime, Pivot::Turning(-sense)), y);
                } else {
                    self.note(ContactChange::PivotingStops);
                }
            }
            (Watch::Holding, Kind::Touching(regime, _)) => {
                let holding = self.stepper.kinetics(&y).map_or(0.0, |at| at.holding);
                self.stepper.enter(Kind::Touching(regime, Pivot::Turning(-holding.signum())), y);
                self.note(ContactChange::Pivots);
            }
            (Watch::Turning | Watch::Holding, _) => {}
        }
        self.settle()
    }

    fn note(&mut self, change: ContactChange) {
        self.changes.push(ContactEvent { time: self.stepper.time(), change });
    }

    fn end(&mut self, change: ContactChange) -> Option<ContactChange> {
        self.note(change);
        Some(change)
    }

    /// Leaves the ground.
    fn leave(&mut self, y: &[f64]) -> Result<Option<ContactChange>, MotionError> {
        let model = &self.stepper.model;
        let Some(at) = self.stepper.kinetics(y) else { return Ok(None) };
        if !model.may_fly() {
            return Ok(self.end(ContactChange::LiftsOff));
        }
        let [e1, e2, e3] = at.axes;
        let along = |v: Components<f64>| [e1.dot(v), e2.dot(v), e3.dot(v)];
        let position = model.ground.position([y[PLACE], y[PLACE + 1], y[PLACE + 2]]);
        let arm = along(at.arm);
        let mut flying = y[..PLACE].to_vec();
        flying.extend([0, 1, 2].map(|k| position[k] - arm[k]));
        flying.extend(along(at.velocity));
        flying.extend_from_slice(&y[y.len() - 2..]);
        debug_assert_eq!(flying.len(), flight::COUNT);
        self.stepper.enter(Kind::Flying, flying);
        let time = self.stepper.time();
        // A rolling law may have used friction for which N is too small. Without it, the remaining
        // force may press the body into the ground.
        let soon = time + 0.1 * self.stepper.expand(f64::INFINITY, time);
        if self.stepper.sinks(soon) {
            return Err(MotionError::Undecided { time });
        }
        self.note(ContactChange::LiftsOff);
        Ok(None)
    }

    /// Begins to slip.
    fn slip(&mut self, y: &[f64], change: ContactChange) -> Result<(), MotionError> {
        let Kind::Touching(_, pivot) = self.stepper.kind() else { return Ok(()) };
        let Some(rolling) = self.stepper.kinetics(y) else { return Ok(()) };
        let time = self.stepper.time();
        // At the threshold, slip grows from zero with the square of time.
        let friction = self.stepper.law().friction();
        let slowly = change == ContactChange::Slips && friction.sticking == friction.kinetic;
        if slowly && self.stepper.begin_to_slip(pivot) {
            self.note(change);
            return Ok(());
        }
        let direction =
            self.stepper.slip_direction(y, &rolling, pivot).ok_or(MotionError::Undecided { time })?;
        let slip = BEGINNING * self.stepper.speed(y);
        let variables = rolling.sliding(y, direction.scaled(slip));
        self.stepper.enter(Kind::Touching(Regime::Sliding, pivot), variables);
        self.note(change);
        Ok(())
    }

    /// Begins to roll.
    fn enter_rolling(&mut self, y: &[f64]) {
        let Kind::Touching(_, pivot) = self.stepper.kind() else { return };
        let mut rolling = y[..VELOCITY].to_vec();
        rolling.extend_from_slice(&y[y.len() - 2..]);
        self.stepper.enter(Kind::Touching(Regime::Rolling, pivot), rolling);
    }
}

impl Stepper {
    /// Returns the initial direction of slip, along the axes of the surface: the one in which
    /// friction lets the slip grow.
    fn slip_direction(&self, y: &[f64], rolling: &Kinetics<f64>, pivot: Pivot) -> Option<Components<f64>> {
        let force = rolling.tangential;
        let size = force.dot(force).sqrt();
        // At the threshold, slip grows from zero, opposite to the force that held the body.
        let against = (size > 0.0).then(|| force.scaled(-1.0 / size));
        let friction = self.law().friction();
        if friction.sticking == friction.kinetic
            && self.watched(Watch::Grip).is_some_and(|margin| {
                margin.abs() <= 1e-9 * (friction.sticking * rolling.normal_force).powi(2)
            })
        {
            return against;
        }
        let n = rolling.normal;
        let first = against.unwrap_or_else(|| any_across(n));
        let second = n.cross(first);
        let direction = |angle: f64| first.scaled(libm::cos(angle)) + second.scaled(libm::sin(angle));
        let slip = TRIAL * self.speed(y);
        let growth = |angle: f64| {
            let along = direction(angle);
            let y = rolling.sliding(y, along.scaled(slip));
            let at = self.model.kinetics(1.0, &y, Regime::Sliding, pivot);
            let rate = at.slip_rate(&self.model);
            [rate.dot(along), rate.dot(n.cross(along))]
        };
        let step = core::f64::consts::TAU / f64::from(DIRECTIONS);
        let mut best: Option<(f64, f64)> = None;
        for k in 0..DIRECTIONS {
            // Search the full circle.
            let from = (f64::from(k) - 0.5) * step;
            let [a, b] = [growth(from)[1], growth(from + step)[1]];
            if a != 0.0 && (a > 0.0) == (b > 0.0) {
                continue;
            }
            let angle = root(|angle| growth(angle)[1], [from, from + step], [a, b]);
            let grown = growth(angle)[0];
            if grown > 0.0 && best.is_none_or(|(most, _)| grown > most) {
                best = Some((grown, angle));
            }
        }
        best.map(|(_, angle)| direction(angle))
    }
}

fn any_across(Components([x, y, z]): Components<f64>) -> Components<f64> {
    let other = if x.abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let across = Components([x, y, z]).cross(Components(other));
    across.scaled(1.0 / across.dot(across).sqrt())
}

const _: () = assert!(AXES == 0 && OMEGA == 6 && PLACE == 9, "a flight has the same axes and ω");
