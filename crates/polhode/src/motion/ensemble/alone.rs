//! One body, with any torques.

use core::cell::Cell;

use super::Member;
use super::crew::Share;
use super::pace::{Begin, Pace, finished};
use super::step::{Action, Gait, Law, Moving, STRETCH, step};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularMomentum, AngularVelocity, Torque};
use crate::motion::error::MotionError;
use crate::motion::propagate::bound::MOST_STEPS;
use crate::motion::propagate::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::simulation::require_few_pulses;
use crate::motion::state::State;
use crate::motion::torque::TorqueModel;

/// What acts on a body until something begins or ends.
pub(super) struct Alone<'a> {
    rotor: &'a Rotor,
    /// Without their schedules.
    torques: Vec<&'a TorqueModel>,
    /// Σ α
    sink: f64,
    /// Their largest sum, N·m: what rounding is relative to.
    largest: f64,
    /// h = `momentum` + `rate` (t − `time`)
    wheels: Option<Wheels>,
    /// A torque about an axis without inertia, if there was one.
    unbalanced: Cell<Option<(f64, f64)>>,
}

#[derive(Clone, Copy)]
struct Wheels {
    time: f64,
    momentum: AngularMomentum<Principal>,
    rate: Torque<Principal>,
}

impl<'a> Alone<'a> {
    /// Steps a member of a share through all times.
    pub(super) fn fly(share: &mut Share<'a>, k: usize, times: &[f64], step: f64) {
        let members = share.members;
        let member = &members[k];
        let start = member.start;
        let span = [start.time, times.last().copied().unwrap_or(start.time)];
        if let Err(cause) = require_few_pulses(&member.rotor, &member.torques, &|_| false, span) {
            return share.fail(k, 0, start, cause);
        }
        let Begin { mut omega, mut q } = Begin::of(member);
        let (mut time, mut last, mut steps) = (start.time, start, 0);
        for (n, &wanted) in times.iter().enumerate() {
            while time < wanted {
                let here = finished(member, time, q, omega).unwrap_or(last);
                let (alone, change) = Self::acting(member, &here);
                let until = wanted.min(change);
                let arrived = Pace::new(time, until, step, start.time, times).and_then(|pace| {
                    // Pieces may be shorter than steps, and many.
                    steps += pace.count;
                    if steps > MOST_STEPS {
                        return Err(MotionError::TooManySteps { time, step: pace.step, most: MOST_STEPS });
                    }
                    alone.march(&pace, &mut omega, &mut q)
                });
                if let Err(cause) = arrived {
                    return share.fail(k, n, last, cause);
                }
                time = until;
            }
            last = if wanted == start.time {
                start
            } else {
                match finished(member, wanted, q, omega) {
                    Some(state) => state,
                    None => return share.fail(k, n, last, MotionError::NotFinite { time: last.time }),
                }
            };
            share.put(k, n, &[last]);
        }
    }

    /// What acts just after a state, and until when.
    fn acting(member: &'a Member, state: &State) -> (Self, f64) {
        let (rotor, time) = (&member.rotor, state.time);
        let torques: Vec<_> = member.torques.iter().filter_map(|torque| torque.acting(time)).collect();
        let to_principal = rotor.principal().rotation().inverse();
        let changes = member.torques.iter().map(|torque| torque.next_change(time));
        let change = changes.chain(rotor.wheels().iter().map(|wheel| wheel.next_change(time)));
        let change = change.fold(f64::INFINITY, f64::min);
        let wheels = (!rotor.wheels().is_empty()).then(|| Wheels {
            time,
            momentum: to_principal * rotor.wheel_momentum(time),
            rate: to_principal * rotor.motor_torque(time),
        });
        let alone = Self {
            rotor,
            sink: torques.iter().map(|torque| torque.sink()).sum(),
            largest: torques.iter().map(|torque| torque.scale(rotor, state)).sum(),
            torques,
            wheels,
            unbalanced: Cell::new(None),
        };
        (alone, change)
    }

    /// Steps of one length, looking after each whether it was one.
    fn march(&self, pace: &Pace, omega: &mut [f64; 3], q: &mut [f64; 4]) -> Result<(), MotionError> {
        let gait = Gait::new(0.0, |_| self.rotor.principal().moments(), pace.step);
        let mut y = Moving { x: omega.map(|w| w * gait.quarter), q: *q };
        for n in 0..pace.count {
            let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| pace.time(n as f64 + part));
            let mut next = [y];
            step(&[gait], &[self], [&[start], &[middle], &[end]], &mut next);
            let [next] = next;
            if let Some((torque, time)) = self.unbalanced.get() {
                return Err(MotionError::TorqueWithoutInertia { torque, time });
            }
            if self.is_overtwisted(&y.q, &next.q) {
                return Err(MotionError::HalfTurn { time: start });
            }
            if next.x.iter().chain(&next.q).any(|number| !number.is_finite()) {
                return Err(MotionError::NotFinite { time: start });
            }
            y = if (n + 1) % STRETCH == 0 { next.with_unit() } else { next };
        }
        let y = y.with_unit();
        (*omega, *q) = (y.x.map(|x| x * gait.rate), y.q);
        Ok(())
    }

    /// True if a spring or wire went beyond half a turn.
    fn is_overtwisted(&self, before: &[f64; 4], after: &[f64; 4]) -> bool {
        self.torques.iter().any(|torque| match torque {
            TorqueModel::Torsion(torsion) => match (self.attitude(before), self.attitude(after)) {
                (Some(before), Some(after)) => torsion.passes_half_turn(before, after),
                _ => false,
            },
            _ => false,
        })
    }

    /// R_space_body of the attitude of the principal axes.
    fn attitude(&self, q: &[f64; 4]) -> Option<Rotation<Space, Body>> {
        let attitude = Rotation::<Space, Principal>::from_quaternion(*q).ok()?;
        Some(attitude * self.rotor.principal().rotation().inverse())
    }

    /// The torque from outside along principal axes.
    fn torque(&self, time: f64, q: &[f64; 4], omega: AngularVelocity<Principal>) -> Torque<Principal> {
        let Some(attitude) = self.attitude(q) else { return Torque::new(f64::NAN, f64::NAN, f64::NAN) };
        let r = self.rotor.principal().rotation();
        let state = State { time, attitude, omega: r * omega };
        let torque =
            self.torques.iter().fold(Torque::ZERO, |sum, model| sum + model.torque(self.rotor, &state));
        let torque = r.inverse() * torque;
        // Along a needle, gravity has no torque but that of its rounding; divided by so small a moment, it would spin it.
        let [i1, i2, i3] = self.rotor.principal().moments();
        let clean = |n: f64, i: f64| {
            if i < THIN * i3 && n.abs() < ROUNDING * self.largest { 0.0 } else { n }
        };
        let torque = Torque::new(clean(torque.x, i1), clean(torque.y, i2), torque.z);
        if i1 == 0.0 && torque.x != 0.0 {
            self.unbalanced.set(Some((torque.x, time)));
        }
        torque
    }
}

impl Law<f64> for &Alone<'_> {
    const ACTS: bool = true;
    /// The time.
    type Scene = f64;

    fn scene(&self, time: f64) -> f64 {
        time
    }

    fn change(&self, scene: &mut f64, time: f64) {
        *scene = time;
    }

    fn act(&self, &time: &f64, q: &[f64; 4], omega: &[f64; 3]) -> Action<f64> {
        let omega = AngularVelocity::<Principal>::from_array(*omega);
        let mut torque = self.torque(time, q, omega);
        let [i1, i2, i3] = self.rotor.principal().moments();
        let mut l = AngularMomentum::<Principal>::new(i1 * omega.x, i2 * omega.y, i3 * omega.z);
        // h × ω − ḣ
        if let Some(Wheels { time: since, momentum, rate }) = self.wheels {
            let h = momentum + (rate * (time - since)).as_quantity();
            let gyroscopic: Torque<Principal> = h.cross(omega);
            torque = torque + gyroscopic - rate;
            l += h;
        }
        // slip α L × ω, and L × of it
        let slip = (self.sink != 0.0).then(|| {
            let bending: Torque<Principal> = l.cross(omega);
            let slip: AngularVelocity<Principal> = (bending * self.sink).as_quantity();
            let pull: Torque<Principal> = l.cross(slip);
            torque += pull;
            slip.to_array()
        });
        Action { torque: torque.to_array(), slip }
    }
}
