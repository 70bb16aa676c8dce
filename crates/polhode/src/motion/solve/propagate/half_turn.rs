//! Validity limit of springs and wires: half a turn, beyond which an attitude does not determine
//! the twist.
//!
//! Let q be the quaternion of the body, and r the quaternion at which the torsion is at rest. The
//! scalar part w of r⁻¹ ∘ q is cos ½θ, where θ is a spring's angle; it also vanishes at a twist of
//! half a turn of a wire. At the start of a step w > 0. The step ends at the first zero of w in its
//! dense output. Stages and series of a step may lie beyond this zero.

use crate::math::rotation::Attitude;
use crate::motion::model::passage::{Course, EventSide, Pieces};
use crate::motion::model::torque::TorqueModel;

/// Tolerance of w for rounding.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Acting torsion springs and wires.
#[derive(Clone, Debug, Default)]
pub(super) struct Torsions(Vec<Torsion>);

/// Attitude at rest, and the sign that makes w positive.
#[derive(Clone, Copy, Debug)]
struct Torsion {
    rest: Attitude,
    sign: f64,
}

/// w as a function of the time since the start of a step.
pub(super) type Cosine<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

impl Torsions {
    /// Selects the torsions among torques on a body of this attitude.
    pub(super) fn of<'a>(torques: impl Iterator<Item = &'a TorqueModel>, attitude: Attitude) -> Self {
        let rests = torques.filter_map(|torque| torque.model().rest());
        Self(rests.map(|rest| Torsion { rest, sign: cosine(rest, attitude).signum() }).collect())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns true if a torsion is twisted by half a turn, up to rounding.
    pub(super) fn is_half_turn(&self, attitude: Attitude) -> bool {
        self.0.iter().any(|torsion| cosine(torsion.rest, attitude).abs() <= ROUNDING)
    }

    /// Returns the time from the start of a step to the first half turn in it. `rate`: largest |ω|
    /// in the step. `cosine`: returns w of a torsion from its rest attitude.
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

/// Returns the scalar part of rest⁻¹ ∘ q.
pub(super) fn cosine(rest: Attitude, attitude: Attitude) -> f64 {
    let [w, ..] = (rest.inverse() * attitude).quaternion();
    w
}

fn half_turn(step: f64, rate: f64, w: &dyn Fn(f64) -> f64) -> Option<f64> {
    /// Factor by which the rate within the step may exceed that at its ends.
    const FASTER: f64 = 1.5;
    let [begin, end] = [0.0, step].map(w);
    // |ẇ| ≤ ½ |ω|: to reach zero and come back takes longer than the step.
    if begin > 0.0 && end > 0.0 && begin + end > 0.5 * FASTER * rate * step {
        return None;
    }
    let pieces = Pieces::of([0.0, step], rate * step);
    let values: Vec<[f64; 2]> = pieces.times().iter().map(|times| times.map(w)).collect();
    let course = Course { pieces: &pieces, values: &values, scale: 1.0, floor: 0.0, function: w };
    course.passages(EventSide::Above).passages.first().map(|(after, _)| *after)
}
