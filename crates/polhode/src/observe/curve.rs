//! A path as points near enough together to be drawn with straight lines.

use core::fmt;

use crate::math::vector::Vector;
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Points of a path in their order, with their times: no straight line from one to the next is farther from the path than was
/// asked.
///
/// Points are dense where the path bends, not where the motion takes its time. A closed curve ends with the point with which it
/// begins, one period later. What does not move is one point, and closed.
///
/// Distances are relative to the largest magnitude on the path, [`Curve::largest`].
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State};
/// use polhode::observe::Polhode;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.02) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let curve = Polhode::of(&motion, 1e-4)?.curve;
/// assert!(curve.is_closed() && curve.points().first() == curve.points().last());
/// assert!(curve.error() <= curve.tolerance());
/// for triangle in curve.fan() {
///     assert!(triangle.iter().all(|&vertex| vertex <= curve.points().len()));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<Q, F> {
    times: Vec<f64>,
    points: Vec<Vector<Q, F>>,
    closed: bool,
    largest: f64,
    tolerance: f64,
    error: f64,
}

/// Why a curve cannot be drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// A number outside its range.
    Parameter {
        /// What the number is.
        what: &'static str,
        /// The number.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
    /// The tolerance needs more points than are ever made, or the path winds too often.
    TooManyPoints {
        /// As far as it came, s.
        time: f64,
        /// The most points of a curve.
        most: usize,
    },
    /// Times that the tolerance needs differ by less than their rounding.
    StepTooSmall {
        /// The time, s.
        time: f64,
        /// The step between the first of them, s; smaller ones may be needed.
        step: f64,
    },
    /// A neighbouring motion does not exist.
    Motion(MotionError),
}

impl<Q, F> Curve<Q, F> {
    /// A path that is one point.
    pub(super) fn point(time: f64, point: Vector<Q, F>, tolerance: f64) -> Self {
        Self {
            times: vec![time],
            points: vec![point],
            closed: true,
            largest: point.norm(),
            tolerance,
            error: 0.0,
        }
    }

    /// The path through the points of states that were chosen for it.
    pub(super) fn through(
        states: &[State],
        closed: bool,
        [largest, tolerance, error]: [f64; 3],
        point: impl Fn(&State) -> Vector<Q, F>,
    ) -> Self {
        let times = states.iter().map(|state| state.time).collect();
        Self { times, points: states.iter().map(point).collect(), closed, largest, tolerance, error }
    }

    /// The same path, with every point mapped by a rotation into other axes.
    pub(super) fn mapped<G>(self, map: impl Fn(Vector<Q, F>) -> Vector<Q, G>) -> Curve<Q, G> {
        let Self { times, points, closed, largest, tolerance, error } = self;
        Curve { times, points: points.into_iter().map(map).collect(), closed, largest, tolerance, error }
    }

    /// When the motion is at each point, s; ascending.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The points, in the unit of their quantity.
    pub fn points(&self) -> &[Vector<Q, F>] {
        &self.points
    }

    /// True if the path comes back to where it begins; then the last point is the first again.
    pub const fn is_closed(&self) -> bool {
        self.closed
    }

    /// The largest magnitude on the path, in the unit of the points.
    pub const fn largest(&self) -> f64 {
        self.largest
    }

    /// The largest distance of the path from its straight lines that was asked for, relative to [`Curve::largest`].
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The largest such distance that was found, at seven places of every line; between them it is at most 2 % more.
    ///
    /// Above the tolerance only if that is finer than the rounding of ω.
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// The cone with its apex in the origin and this path as its rim, as triangles of vertices: the apex is vertex 0 and
    /// point k is vertex k + 1.
    pub fn fan(&self) -> Vec<[usize; 3]> {
        (1..self.points.len()).map(|k| [0, k, k + 1]).collect()
    }
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter { what, value, rule } => write!(f, "{what} = {value} must be {rule}"),
            Self::TooManyPoints { time, most } => {
                write!(
                    f,
                    "at t = {time:e} s the curve has more than {most} points: loosen its tolerance, or shorten it"
                )
            }
            Self::StepTooSmall { time, step } => {
                write!(
                    f,
                    "at t = {time:e} s the points are nearer together in time ({step:e} s) than it is rounded: start nearer to t = 0"
                )
            }
            Self::Motion(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for CurveError {}

impl From<MotionError> for CurveError {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}
