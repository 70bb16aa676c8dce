//! Many bodies at one time: a body in every lane.

use crate::math::lanes::{Lanes, in_widest_vectors};
use crate::motion::state::State;

use super::FreeMotion;
use super::block::{Block, GROUPS, Vectors, WIDTH};
use super::flow::{Family, Flow, Series};
use super::hyperbolic::Hyperbolic;
use super::kernel::Kernel;
use super::phase::Elapsed;
use super::trigonometric::Trigonometric;

/// Many free motions, arranged so that all their states at a time are computed side by side.
///
/// Each state has the bits that [`FreeMotion::at`] gives.
///
/// ```
/// use polhode::{AngularVelocity, Attitude, FreeMotion, FreeMotions, State};
/// let motion = |w: f64| {
///     let omega = AngularVelocity::new(0.1 * w, 1.0, -0.2);
///     FreeMotion::of_moments([1.0, 2.0, 2.5], State { time: 0.0, attitude: Attitude::identity(), omega })
/// };
/// let motions = (1..=100).map(|k| motion(f64::from(k))).collect::<Result<Vec<_>, _>>()?;
/// let all = FreeMotions::of(&motions);
/// assert_eq!(all.at(1e6)[41], motions[41].at(1e6));
/// # Ok::<(), polhode::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FreeMotions {
    starts: Vec<State>,
    /// Whether all start at t = 0.
    whole: bool,
    trigonometric: Vec<Group<Trigonometric<Vectors>>>,
    hyperbolic: Vec<Group<Hyperbolic<Vectors>>>,
}

/// Bodies whose motions have the same kind of series; the last group repeats its first body in the lanes left over.
#[derive(Clone, Debug)]
struct Group<S> {
    flow: Flow<Vectors, S>,
    start: Vectors,
    unit: Vectors,
    members: [usize; WIDTH],
}

impl FreeMotions {
    /// The motions of a slice, in its order.
    pub fn of(motions: &[FreeMotion]) -> Self {
        let mut trigonometric = Vec::new();
        let mut hyperbolic = Vec::new();
        for (index, motion) in motions.iter().enumerate() {
            match &motion.kernel {
                Kernel::Trigonometric(flow) => trigonometric.push((index, motion, flow)),
                Kernel::Hyperbolic(flow) => hyperbolic.push((index, motion, flow)),
            }
        }
        Self {
            starts: motions.iter().map(|motion| motion.start).collect(),
            whole: motions.iter().all(|motion| motion.start.time == 0.0),
            trigonometric: trigonometric.chunks(WIDTH).map(grouped).collect(),
            hyperbolic: hyperbolic.chunks(WIDTH).map(grouped).collect(),
        }
    }

    /// How many they are.
    pub const fn len(&self) -> usize {
        self.starts.len()
    }

    /// True if there is none.
    pub const fn is_empty(&self) -> bool {
        self.starts.is_empty()
    }

    /// The state of every body at a time, s.
    #[must_use]
    pub fn at(&self, time: f64) -> Vec<State> {
        let mut states = self.starts.clone();
        self.fill(time, &mut states);
        states
    }

    /// As [`FreeMotions::at`], into states that are there already. States beyond the number of bodies stay as they are.
    ///
    /// Does nothing if there are fewer states than bodies.
    pub fn fill(&self, time: f64, states: &mut [State]) {
        if states.len() < self.len() {
            return;
        }
        in_widest_vectors(
            #[inline(always)]
            || {
                let mut block = Block::new();
                for groups in self.trigonometric.chunks(GROUPS) {
                    compute(&mut block, groups, time, states, self.whole);
                }
                for groups in self.hyperbolic.chunks(GROUPS) {
                    compute(&mut block, groups, time, states, self.whole);
                }
            },
        );
        if self.whole && time != 0.0 {
            return;
        }
        for (state, start) in states.iter_mut().zip(&self.starts).filter(|(_, start)| start.time == time) {
            *state = *start;
        }
    }
}

fn grouped<S: Family>(bodies: &[(usize, &FreeMotion, &Flow<f64, S>)]) -> Group<S::Of<Vectors>> {
    let body = |lane: usize| bodies[if lane < bodies.len() { lane } else { 0 }];
    Group {
        flow: Flow::assembled(&|get: &dyn Fn(&Flow<f64, S>) -> f64| Lanes::from_fn(|lane| get(body(lane).2))),
        start: Lanes::from_fn(|lane| body(lane).1.start.time),
        unit: Lanes::from_fn(|lane| body(lane).1.unit),
        members: core::array::from_fn(|lane| body(lane).0),
    }
}

#[inline(always)]
fn compute<S: Series<Vectors>>(
    block: &mut Block,
    groups: &[Group<S>],
    time: f64,
    states: &mut [State],
    whole: bool,
) {
    let at = Lanes([time; WIDTH]);
    if whole {
        block.start::<true, _>(
            groups.len(),
            #[inline(always)]
            |g| &groups[g].flow,
            #[inline(always)]
            |g| Elapsed::since::<true>(groups[g].start, at, groups[g].unit),
        );
    } else {
        block.start::<false, _>(
            groups.len(),
            #[inline(always)]
            |g| &groups[g].flow,
            #[inline(always)]
            |g| Elapsed::since::<false>(groups[g].start, at, groups[g].unit),
        );
    }
    block.finish(
        groups.len(),
        #[inline(always)]
        |g| &groups[g].flow,
    );
    for (g, group) in groups.iter().enumerate() {
        for (lane, &member) in group.members.iter().enumerate() {
            states[member] = block.state(g, lane, time);
        }
    }
}
