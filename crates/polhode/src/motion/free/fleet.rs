//! Many bodies at one time: a body in every lane.

use core::hint::black_box;

use crate::math::lanes::{Lanes, in_widest_vectors};
use crate::motion::reach::is_within;
use crate::motion::state::State;

use super::FreeMotion;
use super::block::{Block, Vectors, WIDTH, one};
use super::flow::{Pace, Phases, Raw, Stages, Turned};
use super::hyperbolic::Pulse;
use super::kernel::Kernel;
use super::phase::Elapsed;
use super::seed::{Course, Family, Labels, Left, Nucleus, Seed, Shape};
use super::trigonometric::Nomes;

/// Groups in a block: so few that the processor asks for the next bodies' numbers while it computes; four took a fifth more time.
const GROUPS: usize = 2;

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
    /// The first and the last time at which one starts.
    started: [f64; 2],
    /// How far from its start each is known, s.
    reaches: Vec<f64>,
    /// The longest time from 0 that all know.
    known: f64,
    trigonometric: Kin<Nomes<Vectors>>,
    hyperbolic: Kin<Pulse<Vectors>>,
}

/// Bodies whose motions have the same kind of series, in groups; the last group repeats its first body in the lanes left over.
///
/// What each stage asks for lies side by side: the processor reads four such rows from memory while it computes, where of one it
/// waits for each group.
#[derive(Clone, Debug)]
struct Kin<N> {
    count: usize,
    courses: Vec<Course<Vectors>>,
    shapes: Vec<Shape<Vectors, N>>,
    lefts: Vec<Left<Vectors>>,
    bodies: Vec<Labels<Vectors>>,
    rests: Vec<Rest>,
    /// The place of each among the states, where these are not in the same order.
    places: Vec<usize>,
    /// Where all start at t = 0 and count time in seconds, the longest time that is short for all; otherwise no time is.
    reach: f64,
}

/// A group, stage by stage: each makes only what it needs.
struct Group<'a, N> {
    kin: &'a Kin<N>,
    index: usize,
}

/// What only long times ask for, or bodies that do not start at t = 0.
#[derive(Clone, Copy, Debug)]
struct Rest {
    third: Vectors,
    start: Vectors,
    unit: Vectors,
}

/// A body's index, its motion, its seed and the third word of its precession.
type Body<'a, N> = (usize, &'a FreeMotion, &'a Seed<f64, N>, f64);

impl FreeMotions {
    /// The motions of a slice, in its order.
    pub fn of(motions: &[FreeMotion]) -> Self {
        let mut trigonometric = Vec::new();
        let mut hyperbolic = Vec::new();
        for (index, motion) in motions.iter().enumerate() {
            match &motion.kernel {
                Kernel::Trigonometric(seed, flow) => {
                    trigonometric.push((index, motion, seed, flow.pace.precession.third));
                }
                Kernel::Hyperbolic(seed, flow) => {
                    hyperbolic.push((index, motion, seed, flow.pace.precession.third));
                }
            }
        }
        let times = || motions.iter().map(|motion| motion.start.time);
        Self {
            started: [times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max)],
            starts: motions.iter().map(|motion| motion.start).collect(),
            reaches: motions.iter().map(|motion| motion.reach).collect(),
            known: motions.iter().map(known).fold(f64::INFINITY, f64::min),
            trigonometric: Kin::of(&trigonometric),
            hyperbolic: Kin::of(&hyperbolic),
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

    /// The state of every body at a time, s; not a number where it is not known, as of [`FreeMotion::at`].
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
        self.trigonometric.fill(time, states);
        self.hyperbolic.fill(time, states);
        if !(time.abs() <= self.known) {
            for ((state, start), &reach) in states.iter_mut().zip(&self.starts).zip(&self.reaches) {
                if !is_within(start, reach, time) {
                    *state = State::unknown(time);
                }
            }
        }
        let [first, last] = self.started;
        if !(first..=last).contains(&time) {
            return;
        }
        for (state, start) in states.iter_mut().zip(&self.starts).filter(|(_, start)| start.time == time) {
            *state = *start;
        }
    }
}

/// The longest time from 0 that is within a motion's reach.
fn known(motion: &FreeMotion) -> f64 {
    motion.reach - motion.start.time.abs()
}

impl<N: Nucleus<Vectors>> Kin<N> {
    fn of<F: Family<Of<Vectors> = N>>(bodies: &[Body<'_, F>]) -> Self {
        let plain = |motion: &FreeMotion| motion.start.time == 0.0 && motion.unit == 1.0;
        let reach = |&(_, motion, seed, third): &Body<'_, F>| {
            if plain(motion) { seed.flow(third).pace.reach } else { -1.0 }
        };
        let in_order = bodies.iter().enumerate().all(|(k, body)| k == body.0);
        let mut kin = Self {
            count: bodies.len(),
            courses: Vec::new(),
            shapes: Vec::new(),
            lefts: Vec::new(),
            bodies: Vec::new(),
            rests: Vec::new(),
            places: if in_order { Vec::new() } else { bodies.iter().map(|body| body.0).collect() },
            reach: bodies.iter().map(reach).fold(f64::INFINITY, f64::min),
        };
        for bodies in bodies.chunks(WIDTH) {
            let (seed, rest) = grouped(bodies);
            kin.courses.push(seed.course);
            kin.shapes.push(seed.shape);
            kin.lefts.push(seed.left);
            kin.bodies.push(seed.body);
            kin.rests.push(rest);
        }
        kin
    }

    fn fill(&self, time: f64, states: &mut [State]) {
        in_widest_vectors(
            #[inline(always)]
            || {
                let mut block = Block::<GROUPS>::new();
                let mut paces = [Pace::none(); GROUPS];
                let at = black_box(Lanes([time; WIDTH]));
                for first in (0..self.courses.len()).step_by(GROUPS) {
                    let groups = GROUPS.min(self.courses.len() - first);
                    let group = |g: usize| Group { kin: self, index: first + g };
                    if time.abs() <= self.reach {
                        let elapsed = Elapsed::since::<true>(at, at, Lanes([1.0; WIDTH]));
                        // In a loop of its own: the compiler would make vectors of the halves of both factors, lane by lane.
                        for (g, pace) in paces.iter_mut().enumerate().take(groups) {
                            *pace = group(one(g)).near_pace();
                        }
                        block.start_apart(
                            groups,
                            #[inline(always)]
                            |g| paces[g].polhode_phase::<true, false>(&elapsed),
                            #[inline(always)]
                            |g| paces[g].precession_phase::<true, false>(&elapsed),
                        );
                    } else {
                        block.start(
                            groups,
                            #[inline(always)]
                            |g| group(g).phases(at),
                        );
                    }
                    block.finish(groups, group);
                    let bodies = first * WIDTH..self.count.min((first + GROUPS) * WIDTH);
                    if self.places.is_empty() {
                        for (k, state) in states[bodies].iter_mut().enumerate() {
                            *state = block.state(k / WIDTH, k % WIDTH, time);
                        }
                    } else {
                        for (k, &place) in self.places[bodies].iter().enumerate() {
                            states[place] = block.state(k / WIDTH, k % WIDTH, time);
                        }
                    }
                }
            },
        );
    }
}

impl<N: Nucleus<Vectors>> Group<'_, N> {
    /// For times within the reach of all.
    #[inline(always)]
    fn near_pace(&self) -> Pace<Vectors> {
        self.kin.courses[self.index].near_pace(&self.kin.shapes[self.index])
    }

    #[inline(always)]
    fn phases(&self, time: Vectors) -> Phases<Vectors> {
        let Rest { third, start, unit } = self.kin.rests[self.index];
        let pace = self.kin.courses[self.index].pace(&self.kin.shapes[self.index], third);
        let elapsed = Elapsed::since::<false>(start, time, unit);
        if elapsed.is_within(pace.reach) {
            pace.phases::<false, false>(&elapsed)
        } else {
            pace.phases::<false, true>(&elapsed)
        }
    }
}

impl<N: Nucleus<Vectors>> Stages<Vectors> for Group<'_, N> {
    #[inline(always)]
    fn turned(&self, phases: &Phases<Vectors>) -> Turned<Vectors> {
        self.kin.shapes[self.index].curve().turned(phases)
    }

    #[inline(always)]
    fn raw(&self, turned: &Turned<Vectors>) -> Raw<Vectors> {
        self.kin.shapes[self.index].curve().raw(turned)
    }

    #[inline(always)]
    fn state(&self, raw: &Raw<Vectors>) -> ([Vectors; 4], [Vectors; 3]) {
        self.kin.lefts[self.index].frame(&self.kin.bodies[self.index]).state(raw)
    }
}

fn grouped<N: Family>(bodies: &[Body<'_, N>]) -> (Seed<Vectors, N::Of<Vectors>>, Rest) {
    let body = |lane: usize| bodies[if lane < bodies.len() { lane } else { 0 }];
    let seed =
        Seed::assembled(&|get: &dyn Fn(&Seed<f64, N>) -> f64| Lanes::from_fn(|lane| get(body(lane).2)));
    let rest = Rest {
        third: Lanes::from_fn(|lane| body(lane).3),
        start: Lanes::from_fn(|lane| body(lane).1.start.time),
        unit: Lanes::from_fn(|lane| body(lane).1.unit),
    };
    (seed, rest)
}
