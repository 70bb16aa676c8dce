//! The limit of springs and wires: half a turn, beyond which an attitude does not determine the twist.
//!
//! Let q be the quaternion of the body and r that of a torsion's rest. The scalar part w of r⁻¹ ∘ q is cos ½θ of a
//! spring's angle θ, and vanishes with a wire's twist at half a turn. Where a step begins, w > 0. The step ends at
//! the first zero of w in its dense output: stages and series of a step may go beyond.

use crate::math::rotation::Attitude;
use crate::motion::model::passage::{Course, EventSide, Pieces};
use crate::motion::model::torque::TorqueModel;

/// Rounding of w.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The torsions that act.
#[derive(Clone, Debug, Default)]
pub(super) struct Torsions(Vec<Torsion>);

/// The attitude at rest, and the sign that makes w positive.
#[derive(Clone, Copy, Debug)]
struct Torsion {
    rest: Attitude,
    sign: f64,
}

/// w as a function of the time since a step began.
pub(super) type Cosine<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

impl Torsions {
    /// The torsions among torques that act on a body of this attitude.
    pub(super) fn of<'a>(torques: impl Iterator<Item = &'a TorqueModel>, attitude: Attitude) -> Self {
        let rests = torques.filter_map(|torque| torque.model().rest());
        Self(rests.map(|rest| Torsion { rest, sign: cosine(rest, attitude).signum() }).collect())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// True if a torsion is twisted by half a turn, except for rounding.
    pub(super) fn is_half_turn(&self, attitude: Attitude) -> bool {
        self.0.iter().any(|torsion| cosine(torsion.rest, attitude).abs() <= ROUNDING)
    }

    /// The time from the start of a step to the first half turn in it. The body turns at `rate` at most; `cosine`
    /// gives w of a torsion by its rest.
    pub(super) fn half_turn<'a>(
        &self,
        step: f64,
        rate: f64,
        cosine: impl Fn(Attitude) -> Cosine<'a>,
    ) -> Option<f64> {
        let first = |torsion: &Torsion| {
            let cosine = cosine(torsion.rest);
            half_turn(step, rate, &|after| torsion.sign * cosine(after))
        };
        self.0.iter().filter_map(first).reduce(f64::min)
    }
}

/// The scalar part of rest⁻¹ ∘ q.
pub(super) fn cosine(rest: Attitude, attitude: Attitude) -> f64 {
    let [w, ..] = (rest.inverse() * attitude).quaternion();
    w
}

fn half_turn(step: f64, rate: f64, w: &dyn Fn(f64) -> f64) -> Option<f64> {
    /// Allowance for a rate that is higher within the step than at its ends.
    const FASTER: f64 = 1.5;
    let [begin, end] = [0.0, step].map(w);
    // |ẇ| ≤ ½ |ω|: the way down to zero and up again takes longer than the step.
    if begin > 0.0 && end > 0.0 && begin + end > 0.5 * FASTER * rate * step {
        return None;
    }
    let pieces = Pieces::of([0.0, step], rate * step);
    let values: Vec<[f64; 2]> = pieces.times().iter().map(|times| times.map(w)).collect();
    let course = Course { pieces: &pieces, values: &values, scale: 1.0, floor: 0.0, function: w };
    course.passages(EventSide::Above).passages.first().map(|(after, _)| *after)
}
