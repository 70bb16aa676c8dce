//! Curves: paths as points close enough to be connected by straight lines.

use core::fmt;

use crate::math::vector::Vector;
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Points of a path in their order, with their times. The straight lines between consecutive points
/// deviate from the path by no more than the tolerance.
///
/// The points are dense where the path bends, not where the motion is slow. A closed curve ends
/// with its first point, one period later. A path that does not move is one point, and counts as
/// closed.
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

/// Error of computing a curve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// A number is outside its range.
    Parameter {
        /// Name of the number.
        what: &'static str,
        /// Value of the number.
        value: f64,
        /// Rule that the number must obey.
        rule: &'static str,
    },
    /// The tolerance requires more points than the limit, or the path has too many turns.
    TooManyPoints {
        /// Time that was reached, s.
        time: f64,
        /// Maximum number of points of a curve.
        most: usize,
    },
    /// The times that the tolerance requires differ by less than their rounding.
    StepTooSmall {
        /// Time of the failure, s.
        time: f64,
        /// Step between the first of these times, s; smaller ones may be needed.
        step: f64,
    },
    /// A neighbouring motion does not exist.
    Motion(MotionError),
}

impl<Q, F> Curve<Q, F> {
    /// Returns a path that is one point.
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

    /// Returns the path through the points of states selected for it.
    pub(super) fn through(
        states: &[State],
        closed: bool,
        [largest, tolerance, error]: [f64; 3],
        point: impl Fn(&State) -> Vector<Q, F>,
    ) -> Self {
        let times = states.iter().map(|state| state.time).collect();
        Self { times, points: states.iter().map(point).collect(), closed, largest, tolerance, error }
    }

    /// Returns the path with every point mapped by a rotation into other axes.
    pub(super) fn mapped<G>(self, map: impl Fn(Vector<Q, F>) -> Vector<Q, G>) -> Curve<Q, G> {
        let Self { times, points, closed, largest, tolerance, error } = self;
        Curve { times, points: points.into_iter().map(map).collect(), closed, largest, tolerance, error }
    }

    /// Returns the time of each point, s; ascending.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Returns the points, in the unit of their quantity.
    pub fn points(&self) -> &[Vector<Q, F>] {
        &self.points
    }

    /// Returns true if the path is closed; then the last point equals the first.
    pub const fn is_closed(&self) -> bool {
        self.closed
    }

    /// Returns the largest magnitude on the path, in the unit of the points.
    pub const fn largest(&self) -> f64 {
        self.largest
    }

    /// Returns the requested largest distance of the path from its straight lines, relative to
    /// [`Curve::largest`].
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns the largest such distance found at seven places of every line; between them it is at
    /// most 2 % larger.
    ///
    /// It exceeds the tolerance only if the tolerance is less than the rounding of ω.
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// Returns the cone with its apex at the origin and this path as its rim, as triangles of
    /// vertex indices: the apex is vertex 0, and point k is vertex k + 1.
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
