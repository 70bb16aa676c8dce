//! Bodies side by side, one in every lane.

use core::array::from_fn;

use super::Member;
use super::alone::Alone;
use super::crew::Share;
use super::forces::{Forces, Parts};
use super::pace::{Begin, Pace, finished};
use super::step::{self, Free, Gait, Law, Moving, STRETCH};
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number;
use crate::motion::error::MotionError;
use crate::motion::propagate::THIN;
use crate::motion::state::State;

/// Steps all members of a share.
///
/// Those with the same torques that start at the same time go side by side; those whose torques need more than cheap algebra, or care, go
/// alone.
pub(super) fn fly(share: &mut Share<'_>, times: &[f64], step: f64) {
    let members = share.members;
    let mut bodies: Vec<_> = members.iter().enumerate().map(|(k, member)| (k, parts(member))).collect();
    // In their order within each kind.
    let key = |k: usize, parts: &Option<Parts<'_>>| {
        (parts.as_ref().map(Parts::kind), members[k].start.time.to_bits())
    };
    bodies.sort_by_key(|(k, parts)| key(*k, parts));
    for kin in bodies.chunk_by(|a, b| key(a.0, &a.1) == key(b.0, &b.1)) {
        if kin.iter().any(|(_, parts)| parts.is_none()) {
            for (k, _) in kin {
                Alone::fly(share, *k, times, step);
                if !share.done(1) {
                    return;
                }
            }
            continue;
        }
        let kin: Vec<_> = kin.iter().filter_map(|(k, parts)| Some((*k, parts.as_ref()?))).collect();
        if !in_vectors(Flight { share, bodies: &kin, times, step }) {
            return;
        }
    }
}

/// Of a member that may go beside others.
fn parts(member: &Member) -> Option<Parts<'_>> {
    let [least, _, greatest] = member.rotor.principal().moments();
    // Along a needle rounding has to be told from torque.
    if least < THIN * greatest && !member.torques.is_empty() {
        return None;
    }
    Parts::of(member)
}

/// The flight of bodies of a kind, which start at the same time.
struct Flight<'a, 'b, 'c> {
    share: &'a mut Share<'c>,
    bodies: &'a [(usize, &'a Parts<'b>)],
    times: &'a [f64],
    step: f64,
}

/// Vectors that take their steps in turn: while one waits for its own numbers, the other goes on.
const ABREAST: usize = 2;

impl Work for Flight<'_, '_, '_> {
    /// False if the work is to end.
    type Output = bool;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> bool {
        self.fly(s.eight(0.0))
    }
}

impl Flight<'_, '_, '_> {
    #[inline(always)]
    fn fly<T: Number>(self, zero: T) -> bool {
        let Self { share, bodies, times, step } = self;
        for bodies in bodies.chunks(ABREAST * T::LANES) {
            let is_free = bodies.iter().all(|(_, parts)| parts.kind() == [false; 9]);
            if is_free {
                let laws = [Free; ABREAST];
                Wing::<T, Free> { zero, bodies, laws }.fly(share, times, step);
            } else {
                let laws = from_fn(|k| {
                    let row = bodies.chunks(T::LANES).nth(k).unwrap_or(bodies);
                    Forces::new(zero, &row.iter().map(|(_, parts)| *parts).collect::<Vec<_>>())
                });
                Wing::<T, Forces<'_, T>> { zero, bodies, laws }.fly(share, times, step);
            }
            if !share.done(bodies.len()) {
                return false;
            }
        }
        true
    }
}

/// As many bodies as go abreast. Lanes without a body follow the first.
struct Wing<'a, 'b, T: Number, L> {
    zero: T,
    bodies: &'a [(usize, &'a Parts<'b>)],
    laws: [L; ABREAST],
}

impl<T: Number, L: Law<T>> Wing<'_, '_, T, L> {
    #[inline(always)]
    fn fly(&self, share: &mut Share<'_>, times: &[f64], step: f64) {
        let members = share.members;
        let member = |k: usize| &members[self.bodies.get(k).unwrap_or(&self.bodies[0]).0];
        let start = member(0).start.time;
        let begin = |k: usize| Begin::of(member(k));
        let mut omega: [[T; 3]; ABREAST] = self.rows(|k, c| begin(k).omega[c]);
        let mut q: [[T; 4]; ABREAST] = self.rows(|k, c| begin(k).q[c]);
        // The last good state of each that still goes on.
        let mut last: Vec<Option<State>> = (0..self.bodies.len()).map(|k| Some(member(k).start)).collect();
        let mut time = start;
        for (n, &until) in times.iter().enumerate() {
            let pace = Pace::new(time, until, step, start, times);
            if let Ok(pace) = &pace
                && pace.count > 0
            {
                let moments = |k: usize| member(k).rotor.principal().moments();
                let gaits =
                    from_fn(|row| Gait::new(self.zero, |lane| moments(row * T::LANES + lane), pace.step));
                self.march(&gaits, pace, &mut omega, &mut q);
            }
            for ((k, (index, _)), last) in self.bodies.iter().enumerate().zip(&mut last) {
                let Some(before) = *last else { continue };
                let (row, lane) = (k / T::LANES, k % T::LANES);
                let now = match &pace {
                    Err(cause) => Err(cause.clone()),
                    Ok(_) if until == start => Ok(before),
                    Ok(_) => {
                        let (q, omega) =
                            (from_fn(|c| q[row][c].lane(lane)), from_fn(|c| omega[row][c].lane(lane)));
                        let state = finished(member(k), until, q, omega);
                        state.ok_or(MotionError::NotFinite { time: before.time })
                    }
                };
                *last = now.as_ref().ok().copied();
                match now {
                    Ok(state) => share.put(*index, n, &[state]),
                    Err(cause) => share.fail(*index, n, before, cause),
                }
            }
            time = until;
        }
    }

    /// Steps of one length.
    #[inline(always)]
    fn march(
        &self,
        gaits: &[Gait<T>; ABREAST],
        pace: &Pace,
        omega: &mut [[T; 3]; ABREAST],
        q: &mut [[T; 4]; ABREAST],
    ) {
        let mut y: [Moving<T>; ABREAST] =
            from_fn(|row| Moving { x: omega[row].map(|w| w * gaits[row].quarter), q: q[row] });
        let [start, middle, end] = &mut [0.0, 0.5, 1.0].map(|part| {
            let time = pace.time(part);
            from_fn::<_, ABREAST, _>(|row| self.laws[row].scene(time))
        });
        let (mut start, mut end) = (start, end);
        for n in 0..pace.count {
            let [half, whole] = [0.5, 1.0].map(|part| pace.time(n as f64 + part));
            for row in 0..ABREAST {
                let law = &self.laws[row];
                law.change(&mut middle[row], half);
                law.change(&mut end[row], whole);
            }
            step::step(gaits, &self.laws, [start, middle, end], &mut y);
            core::mem::swap(&mut start, &mut end);
            if (n + 1) % STRETCH == 0 {
                y = y.map(Moving::with_unit);
            }
        }
        y = y.map(Moving::with_unit);
        for row in 0..ABREAST {
            omega[row] = y[row].x.map(|x| x * gaits[row].rate);
            q[row] = y[row].q;
        }
    }

    /// Number c of each body.
    #[inline(always)]
    fn rows<const N: usize>(&self, number: impl Fn(usize, usize) -> f64) -> [[T; N]; ABREAST] {
        from_fn(|row| from_fn(|c| self.zero.each(|lane| number(row * T::LANES + lane, c))))
    }
}
