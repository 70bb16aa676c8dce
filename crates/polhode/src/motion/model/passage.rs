//! Passages of a function of time through zero, and the side of zero on which it is between them.
//!
//! A function has a side as soon as its value exceeds its rounding. If an interval begins at zero
//! to within rounding, the side is the one to which the function leaves. It is found at times at
//! increasing distances from the start. A passage is a change of the side. A function that only
//! touches zero therefore has no passage. A function that begins on another side than the one at
//! which the preceding interval ended has a passage at the start.

use crate::math::root::root;
use crate::math::sign_changes::{Node, SLOPE, Sought};

/// Upper limit of the rotation of the body in one piece of an interval, rad.
const TURN: f64 = 0.3;

/// Minimum and maximum number of pieces of a part of an interval.
const PIECES: [f64; 2] = [4.0, 256.0];

/// Upper limit of the number of pieces of an interval.
const MOST_PIECES: f64 = 4_194_304.0;

/// Rounding of a function relative to the size of its terms, and relative rounding of a time.
const ROUNDING: [f64; 2] = [16.0 * f64::EPSILON, 4.0 * f64::EPSILON];

/// Last known side of an event's value on which the motion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventSide {
    /// The motion is at the value and has not left it. A motion that starts there has not crossed
    /// it.
    At,
    /// The measure is above the value.
    Above,
    /// The measure is below the value.
    Below,
}

impl EventSide {
    pub(crate) const fn of(gap: f64) -> Self {
        if gap > 0.0 { Self::Above } else { Self::Below }
    }

    const fn sign(self) -> Option<f64> {
        match self {
            Self::At => None,
            Self::Above => Some(1.0),
            Self::Below => Some(-1.0),
        }
    }

    const fn passed(self) -> Self {
        match self {
            Self::At => Self::At,
            Self::Above => Self::Below,
            Self::Below => Self::Above,
        }
    }
}

/// Sampling times of an interval: the ends of its pieces, each with a second time nearby for the
/// slope. The second time is before the last end, and after all others.
#[derive(Clone, Debug)]
pub(crate) struct Pieces(Vec<[f64; 2]>);

impl Pieces {
    /// Divides an interval into parts of at most 256 pieces each. The phase of the function
    /// advances by `angle` in the interval, rad. Returns `None` if there are too many pieces.
    pub(crate) fn parts([from, to]: [f64; 2], angle: f64) -> Option<Vec<[f64; 2]>> {
        let pieces = (angle / TURN).ceil();
        if pieces > MOST_PIECES {
            return None;
        }
        let count = (pieces / PIECES[1]).ceil().max(1.0) as u32;
        let end =
            |k: u32| if k == count { to } else { from + (to - from) * (f64::from(k) / f64::from(count)) };
        Some((0..count).map(|k| [end(k), end(k + 1)]).collect())
    }

    /// Divides a part of an interval in which the phase of the function advances by this angle,
    /// rad.
    pub(crate) fn of([from, to]: [f64; 2], turn: f64) -> Self {
        let count = (turn / TURN).ceil().clamp(PIECES[0], PIECES[1]) as u32;
        let width = (to - from) / f64::from(count);
        let place = |k: u32| match k {
            k if k == count => [to, to - SLOPE * width],
            k => [from + f64::from(k) * width, from + (f64::from(k) + SLOPE) * width],
        };
        Self((0..=count).map(place).collect())
    }

    pub(crate) fn times(&self) -> &[[f64; 2]] {
        &self.0
    }

    /// Returns the latest time that equals `time` to within rounding.
    pub(crate) fn same(time: f64) -> f64 {
        time + ROUNDING[1] * time.abs()
    }
}

/// A function on an interval.
pub(crate) struct Course<'a> {
    pub(crate) pieces: &'a Pieces,
    /// Values at the sampling times of the pieces.
    pub(crate) values: &'a [[f64; 2]],
    /// Magnitude of the terms of the function. Its rounding is relative to it.
    pub(crate) scale: f64,
    /// Threshold, in addition to the rounding, below which the function counts as zero until it has
    /// exceeded it.
    pub(crate) floor: f64,
    pub(crate) function: &'a dyn Fn(f64) -> f64,
}

/// Passages in an interval.
#[derive(Clone, Debug)]
pub(crate) struct Passages {
    /// Side before the interval.
    before: EventSide,
    /// First time at which the function exceeds its rounding, and its side there.
    since: Option<(f64, EventSide)>,
    /// Times of the zero crossings, in ascending order, each with true if the function rises.
    pub(crate) passages: Vec<(f64, bool)>,
    /// Rounding of the function.
    pub(crate) noise: f64,
}

impl Passages {
    /// Creates an empty list of passages for a function that stays on its side.
    pub(crate) const fn none(before: EventSide, noise: f64) -> Self {
        Self { before, since: None, passages: Vec::new(), noise }
    }

    /// Returns the rounding of a function whose terms have this magnitude.
    pub(crate) const fn rounding(scale: f64) -> f64 {
        ROUNDING[0] * scale
    }

    /// True if the function has exceeded its rounding in the interval.
    pub(crate) const fn is_known(&self) -> bool {
        self.since.is_some()
    }

    /// Adds the passages of the next part of the interval.
    pub(crate) fn extend(&mut self, next: Self) {
        self.since = self.since.or(next.since);
        self.passages.extend(next.passages);
        self.noise = self.noise.max(next.noise);
    }

    /// Returns the side just after a time.
    pub(crate) fn side(&self, time: f64) -> EventSide {
        let first = match (self.before, self.since) {
            (EventSide::At, Some((since, side))) if since <= time => side,
            (before, _) => before,
        };
        let count = self.passages.iter().filter(|(passage, _)| *passage <= time).count();
        if count % 2 == 0 { first } else { first.passed() }
    }
}

impl Course<'_> {
    /// Finds the passages of a function whose side before the interval is `before`.
    pub(crate) fn passages(&self, before: EventSide) -> Passages {
        let noise = Passages::rounding(self.scale);
        let mut passages = Passages::none(before, noise);
        let Some(start) = self.start(noise) else { return passages };
        let sought = Sought { function: self.function, noise };
        let mut zeros = Vec::new();
        let mut run: Vec<Node> = start.into_iter().collect();
        let mut is_known = start.is_some();
        for k in 1..self.values.len() {
            let is_open = start.is_none() && passages.since.is_none();
            let node = self.node(k, if is_open { noise + self.floor } else { noise });
            if let Some(node) = node {
                if !is_known {
                    zeros.extend(sought.zeros(&run));
                    zeros.extend(run.last().and_then(|last| self.between(last, &node)));
                    run.clear();
                }
                run.push(node);
                passages.since = passages.since.or(Some((node.at, EventSide::of(node.value))));
            }
            is_known = node.is_some();
        }
        zeros.extend(sought.zeros(&run));
        let from = self.pieces.0.first().map_or(f64::NAN, |[from, _]| *from);
        if let Some(node) = start {
            passages.since = Some((from, EventSide::of(node.value)));
        }
        let Some((since, side)) = passages.since else { return passages };
        let mut rises = side == EventSide::Below;
        if before.sign().is_some() && before != side {
            let time = if start.is_some() { from } else { self.left([from, since]) };
            passages.passages.push((time, !rises));
        }
        for zero in zeros {
            passages.passages.push((zero, rises));
            rises = !rises;
        }
        passages
    }

    /// Returns the first node at which the function exceeds its rounding. The outer `None` means
    /// that the function has no values. The inner `None` means that it stays within rounding during
    /// the first piece.
    fn start(&self, noise: f64) -> Option<Option<Node>> {
        let (&[from, _], &[next, _]) = (self.pieces.0.first()?, self.pieces.0.get(1)?);
        let first = self.sampled(0)?;
        let noise = noise + self.floor;
        if self.is_beyond(&first, noise) {
            return Some(Some(first));
        }
        let step = SLOPE * (next - from);
        let mut delta = (ROUNDING[1] * from.abs()).max(step * (1.0 / (1_u64 << 40) as f64));
        while delta < next - from {
            let value = (self.function)(from + delta);
            let node = Node { at: from + delta, value, slope: first.slope };
            if self.is_beyond(&node, noise) {
                let step = step.min(next - node.at);
                let beside = node.at + step;
                let slope = ((self.function)(beside) - value) / (beside - node.at);
                return Some(Some(Node { slope, ..node }));
            }
            delta *= 4.0;
        }
        Some(None)
    }

    /// Returns a node at which the function exceeds its rounding: an end of a piece, or the second
    /// time next to it.
    fn node(&self, k: usize, noise: f64) -> Option<Node> {
        let node = self.sampled(k)?;
        if self.is_beyond(&node, noise) {
            return Some(node);
        }
        let (&[_, at], &[_, value]) = (self.pieces.0.get(k)?, self.values.get(k)?);
        let node = Node { at, value, ..node };
        self.is_beyond(&node, noise).then_some(node)
    }

    fn sampled(&self, k: usize) -> Option<Node> {
        let (&[at, beside], &[value, there]) = (self.pieces.0.get(k)?, self.values.get(k)?);
        Some(Node { at, value, slope: (there - value) / (beside - at) })
    }

    /// Checks if the value exceeds the rounding of the function and of the time.
    fn is_beyond(&self, node: &Node, noise: f64) -> bool {
        node.value.abs() > noise + ROUNDING[1] * (node.at * node.slope).abs()
    }

    /// Returns the passage between two nodes between which the function is within its rounding.
    fn between(&self, left: &Node, right: &Node) -> Option<f64> {
        let is_passed = (left.value > 0.0) != (right.value > 0.0);
        is_passed.then(|| root(self.function, [left.at, right.at], [left.value, right.value]))
    }

    /// Returns the time at which the function leaves its rounding to another side than before.
    fn left(&self, bracket: [f64; 2]) -> f64 {
        let [a, b] = bracket.map(self.function);
        if (a > 0.0) == (b > 0.0) { bracket[0] } else { root(self.function, bracket, [a, b]) }
    }
}
