//! Many bodies at one time: one body in every SIMD lane.

use core::hint::black_box;

use crate::math::lanes::Lanes;
use crate::math::machine::in_widest_vectors;
use crate::motion::model::state::State;
use crate::motion::solve::reach::is_within;

use super::FreeMotion;
use super::block::{Block, Vectors, WIDTH, one};
use super::compact::{
    CompactConstants, Frequencies, LabelledAxes, LeftFactor, ScalarThetaParameters, ThetaConstants,
    ThetaParameters,
};
use super::flow::{PhaseRates, Phases, Stages, ThetaArgument, UnnormalisedState};
use super::hyperbolic::Pulse;
use super::kernel::Kernel;
use super::trigonometric::Nomes;
use crate::motion::solve::phase::Elapsed;

/// Number of groups in a block. With two, the processor loads the numbers of the next bodies while
/// it computes. Four took 20 % longer.
const GROUPS: usize = 2;

/// Many free motions, stored so that SIMD lanes compute all their states at one time together.
///
/// Each state is bit-identical to that of [`FreeMotion::at`].
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, FreeMotions, State};
/// let motion = |w: f64| {
///     let omega = AngularVelocity::new(0.1 * w, 1.0, -0.2);
///     FreeMotion::of_moments([1.0, 2.0, 2.5], State { time: 0.0, attitude: Attitude::identity(), omega })
/// };
/// let motions = (1..=100).map(|k| motion(f64::from(k))).collect::<Result<Vec<_>, _>>()?;
/// let all = FreeMotions::of(&motions);
/// assert_eq!(all.at(1e6)[41], motions[41].at(1e6));
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FreeMotions {
    starts: Vec<State>,
    /// Earliest and latest start time, s.
    started: [f64; 2],
    /// [`FreeMotion::reach`] of each motion, s.
    reaches: Vec<f64>,
    /// Largest |t|, s, within the reach of every motion.
    known: f64,
    trigonometric: SeriesBatch<Nomes<Vectors>>,
    hyperbolic: SeriesBatch<Pulse<Vectors>>,
}

/// Bodies whose motions use the same kind of series, in groups of `WIDTH`. In the last group, the
/// first body of that group fills the unused lanes.
///
/// The data of each stage are stored in one array (structure of arrays). The processor can then
/// read four such arrays ahead of the computation; with one array of structures it waits for every
/// group.
#[derive(Clone, Debug)]
struct SeriesBatch<N> {
    count: usize,
    frequencies: Vec<Frequencies<Vectors>>,
    thetas: Vec<ThetaConstants<Vectors, N>>,
    left: Vec<LeftFactor<Vectors>>,
    axes: Vec<LabelledAxes<Vectors>>,
    long_times: Vec<LongTimes>,
    /// Index of each body among the states; empty if both have the same order.
    places: Vec<usize>,
    /// Longest time that is short for all bodies, if all start at t = 0 and count time in seconds.
    /// Otherwise negative, so that no time is short.
    reach: f64,
}

/// One group of bodies. Each stage computes only the numbers that it needs.
struct Group<'a, N> {
    batch: &'a SeriesBatch<N>,
    index: usize,
}

/// Constants needed only for long times, or for bodies that do not start at t = 0.
#[derive(Clone, Copy, Debug)]
struct LongTimes {
    third: Vectors,
    start: Vectors,
    unit: Vectors,
}

/// Index of a body, its motion, its compact constants, and the third word of its precession rate.
type PreparedBody<'a, N> = (usize, &'a FreeMotion, &'a CompactConstants<f64, N>, f64);

impl FreeMotions {
    /// Arranges the motions of a slice, in its order.
    pub fn of(motions: &[FreeMotion]) -> Self {
        let mut trigonometric = Vec::new();
        let mut hyperbolic = Vec::new();
        for (index, motion) in motions.iter().enumerate() {
            match &motion.kernel {
                Kernel::Trigonometric(compact, flow) => {
                    trigonometric.push((index, motion, compact, flow.phase_rates.precession.third));
                }
                Kernel::Hyperbolic(compact, flow) => {
                    hyperbolic.push((index, motion, compact, flow.phase_rates.precession.third));
                }
            }
        }
        let times = || motions.iter().map(|motion| motion.start.time);
        Self {
            started: [times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max)],
            starts: motions.iter().map(|motion| motion.start).collect(),
            reaches: motions.iter().map(|motion| motion.reach).collect(),
            known: motions.iter().map(known).fold(f64::INFINITY, f64::min),
            trigonometric: SeriesBatch::of(&trigonometric),
            hyperbolic: SeriesBatch::of(&hyperbolic),
        }
    }

    /// Returns the number of motions.
    pub const fn len(&self) -> usize {
        self.starts.len()
    }

    /// Returns true if the batch is empty.
    pub const fn is_empty(&self) -> bool {
        self.starts.is_empty()
    }

    /// Returns the state of every body at a time, s. A state beyond the reach of its motion is NaN,
    /// as from [`FreeMotion::at`].
    #[must_use]
    pub fn at(&self, time: f64) -> Vec<State> {
        let mut states = self.starts.clone();
        self.fill(time, &mut states);
        states
    }

    /// Writes the states at a time, s, into a slice, as [`FreeMotions::at`] returns them.
    ///
    /// Elements of the slice beyond the number of bodies are not changed. If the slice is shorter
    /// than the number of bodies, nothing is written.
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

/// Largest |t| that is certainly within the reach of a motion, s.
fn known(motion: &FreeMotion) -> f64 {
    motion.reach - motion.start.time.abs()
}

impl<N: ThetaParameters<Vectors>> SeriesBatch<N> {
    fn of<F: ScalarThetaParameters<Of<Vectors> = N>>(bodies: &[PreparedBody<'_, F>]) -> Self {
        let plain = |motion: &FreeMotion| motion.start.time == 0.0 && motion.unit == 1.0;
        let reach = |&(_, motion, compact, third): &PreparedBody<'_, F>| {
            if plain(motion) { compact.flow(third).phase_rates.reach } else { -1.0 }
        };
        let in_order = bodies.iter().enumerate().all(|(k, body)| k == body.0);
        let mut batch = Self {
            count: bodies.len(),
            frequencies: Vec::new(),
            thetas: Vec::new(),
            left: Vec::new(),
            axes: Vec::new(),
            long_times: Vec::new(),
            places: if in_order { Vec::new() } else { bodies.iter().map(|body| body.0).collect() },
            reach: bodies.iter().map(reach).fold(f64::INFINITY, f64::min),
        };
        for bodies in bodies.chunks(WIDTH) {
            let (compact, rest) = grouped(bodies);
            batch.frequencies.push(compact.frequencies);
            batch.thetas.push(compact.theta);
            batch.left.push(compact.left);
            batch.axes.push(compact.axes);
            batch.long_times.push(rest);
        }
        batch
    }

    fn fill(&self, time: f64, states: &mut [State]) {
        in_widest_vectors(
            #[inline(always)]
            || {
                let mut block = Block::<GROUPS>::new();
                let mut phase_rates = [PhaseRates::none(); GROUPS];
                let at = black_box(Lanes([time; WIDTH]));
                for first in (0..self.frequencies.len()).step_by(GROUPS) {
                    let groups = GROUPS.min(self.frequencies.len() - first);
                    let group = |g: usize| Group { batch: self, index: first + g };
                    if time.abs() <= self.reach {
                        let elapsed = Elapsed::since::<true>(at, at, Lanes([1.0; WIDTH]));
                        // A separate loop: otherwise the compiler would form vectors from the
                        // halves of both factors, lane by lane.
                        for (g, phase_rates) in phase_rates.iter_mut().enumerate().take(groups) {
                            *phase_rates = group(one(g)).near_phase_rates();
                        }
                        block.start_apart(
                            groups,
                            #[inline(always)]
                            |g| phase_rates[g].polhode_phase::<true, false>(&elapsed),
                            #[inline(always)]
                            |g| phase_rates[g].precession_phase::<true, false>(&elapsed),
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

impl<N: ThetaParameters<Vectors>> Group<'_, N> {
    /// Phase rates for times within the reach of all bodies.
    #[inline(always)]
    fn near_phase_rates(&self) -> PhaseRates<Vectors> {
        self.batch.frequencies[self.index].near_phase_rates(&self.batch.thetas[self.index])
    }

    #[inline(always)]
    fn phases(&self, time: Vectors) -> Phases<Vectors> {
        let LongTimes { third, start, unit } = self.batch.long_times[self.index];
        let phase_rates =
            self.batch.frequencies[self.index].phase_rates(&self.batch.thetas[self.index], third);
        let elapsed = Elapsed::since::<false>(start, time, unit);
        if elapsed.is_within(phase_rates.reach) {
            phase_rates.phases::<false, false>(&elapsed)
        } else {
            phase_rates.phases::<false, true>(&elapsed)
        }
    }
}

impl<N: ThetaParameters<Vectors>> Stages<Vectors> for Group<'_, N> {
    #[inline(always)]
    fn theta_argument(&self, phases: &Phases<Vectors>) -> ThetaArgument<Vectors> {
        self.batch.thetas[self.index].curve().theta_argument(phases)
    }

    #[inline(always)]
    fn unnormalised(&self, argument: &ThetaArgument<Vectors>) -> UnnormalisedState<Vectors> {
        self.batch.thetas[self.index].curve().unnormalised(argument)
    }

    #[inline(always)]
    fn state(&self, unnormalised: &UnnormalisedState<Vectors>) -> ([Vectors; 4], [Vectors; 3]) {
        self.batch.left[self.index].body_map(&self.batch.axes[self.index]).state(unnormalised)
    }
}

fn grouped<N: ScalarThetaParameters>(
    bodies: &[PreparedBody<'_, N>],
) -> (CompactConstants<Vectors, N::Of<Vectors>>, LongTimes) {
    let body = |lane: usize| bodies[if lane < bodies.len() { lane } else { 0 }];
    let compact = CompactConstants::assembled(&|get: &dyn Fn(&CompactConstants<f64, N>) -> f64| {
        Lanes::from_fn(|lane| get(body(lane).2))
    });
    let rest = LongTimes {
        third: Lanes::from_fn(|lane| body(lane).3),
        start: Lanes::from_fn(|lane| body(lane).1.start.time),
        unit: Lanes::from_fn(|lane| body(lane).1.unit),
    };
    (compact, rest)
}
