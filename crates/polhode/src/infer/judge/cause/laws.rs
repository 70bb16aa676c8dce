//! Mistakes in the equations of motion and in the torques.

use super::law::{Gyroscopic, Law, TorqueAxes, TorqueUse, Turning};
use super::name::Cause;
use super::trial::{Trials, fitted};
use crate::motion::model::state::State;

/// Default limits of |ω| in engines, rad/s: Unity, Jolt, PhysX.
const LIMITS: [f64; 3] = [7.0, 47.123_889_803_846_9, 100.0];

impl<'a> Trials<'a> {
    /// Tries Euler's equations with mistakes.
    pub(super) fn try_equations(&mut self) {
        let law = self.law.clone();
        self.try_law(Cause::NoGyroscopicTerm, &Law { gyroscopic: Gyroscopic::LeftOut, ..law.clone() });
        for (cause, turning) in
            [(Cause::OmegaBodyAsSpace, Turning::BodyAsSpace), (Cause::OmegaSpaceAsBody, Turning::SpaceAsBody)]
        {
            let with = |gyroscopic: Gyroscopic| (cause.clone(), Law { turning, gyroscopic, ..law.clone() });
            self.try_best_law([with(Gyroscopic::Right), with(Gyroscopic::OfAttitude)]);
        }
    }

    /// Tries damping of ω, and a limit of |ω|.
    pub(super) fn try_damping(&mut self) {
        let law = self.law.clone();
        let free = Law { gyroscopic: Gyroscopic::LeftOut, ..law.clone() };
        let scale = 1e-3 / self.duration();
        for base in [&law, &free] {
            // The gyroscopic term is more important than damping while the run and the exact motion
            // are close together.
            let term = self.tried.iter().find(|tried| tried.cause == Cause::NoGyroscopicTerm);
            if base.gyroscopic == Gyroscopic::LeftOut && term.is_some_and(|tried| tried.explained < 0.3) {
                continue;
            }
            let damped = |rate: f64| Law { damping: rate, ..base.clone() };
            let Some(rate) = fitted(&self.rows, scale, |rate| self.motion(&damped(rate))) else { continue };
            // A smaller damping cannot be distinguished from the error of a method.
            if rate > scale {
                let cause = match base.gyroscopic {
                    Gyroscopic::LeftOut => Cause::DampingWithoutGyroscopicTerm { rate },
                    _ => Cause::Damping { rate },
                };
                self.try_law(cause, &damped(rate));
            }
        }
        let greatest = self.rows.exact.iter().map(|state| state.omega.norm()).fold(0.0, f64::max);
        let logged = self.rows.omega.as_ref();
        let logged = logged.map(|omega| omega.iter().skip(1).map(|omega| omega.norm()).fold(0.0, f64::max));
        for limit in logged.map_or_else(|| LIMITS.to_vec(), |limit| vec![limit]) {
            if limit > 0.0 && greatest > 1.001 * limit {
                for base in [&law, &free] {
                    let gyroscopic = base.gyroscopic == Gyroscopic::Right;
                    let cut = Law { speed_limit: limit, ..base.clone() };
                    self.try_law(Cause::SpeedLimit { limit, gyroscopic }, &cut);
                }
            }
        }
    }

    /// Tries torques along other axes, reversed, omitted, and scaled.
    pub(super) fn try_torques(&mut self) {
        let law = self.law.clone();
        let count = law.torque_count();
        let each = (0..count).filter(|_| count > 1).map(Some);
        for which in (count > 0).then_some(None).into_iter().chain(each) {
            let torque = which.map(|k| law.torque_name(k));
            let right = TorqueUse { factor: 1.0, axes: TorqueAxes::Right };
            for (cause, usage) in [
                (Cause::TorqueLeftOut { torque }, TorqueUse { factor: 0.0, ..right }),
                (Cause::TorqueReversed { torque }, TorqueUse { factor: -1.0, ..right }),
                (Cause::TorqueBodyAsSpace { torque }, TorqueUse { axes: TorqueAxes::BodyAsSpace, ..right }),
                (Cause::TorqueSpaceAsBody { torque }, TorqueUse { axes: TorqueAxes::SpaceAsBody, ..right }),
            ] {
                self.try_law(cause, &law.using(which, usage));
            }
        }
        if count > 0 {
            const NOTICED: f64 = 2e-4;
            let scaled =
                |more: f64| law.using(None, TorqueUse { factor: 1.0 + more, axes: TorqueAxes::Right });
            let more = fitted(&self.rows, 1e-3, |more| self.motion(&scaled(more)));
            if let Some(more) = more.filter(|more| more.abs() > NOTICED) {
                self.try_law(Cause::TorqueScaled { factor: 1.0 + more }, &scaled(more));
            }
        }
    }

    /// Tries rows that belong to shifted times.
    pub(super) fn try_time_shift(&mut self) {
        let law = self.law.clone();
        let (times, start) = (self.rows.times.clone(), self.start);
        let shifted = |shift: f64| -> Vec<State> {
            let times: Vec<f64> = times.iter().map(|time| time + shift).collect();
            super::follow::follow(&law, start, &times, 20_000, |_| true)
        };
        if let Some(shift) = fitted(&self.rows, 1e-3 / self.rows.rate, shifted) {
            self.try_states(Cause::TimeShift { shift }, &shifted(shift));
        }
    }
}
