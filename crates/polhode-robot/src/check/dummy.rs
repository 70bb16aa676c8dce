//! Links that stand for a place: an IMU's, a fingertip's. Their numbers are made up, and nothing comes of them.

use super::body::Body;
use super::tree::Tree;

/// Links of a gram or less are frames that a simulator wanted a mass for.
pub(super) const FRAME: f64 = 1e-3;

/// A moment that is this part of those of the links that it is fixed to is not felt.
const NOT_FELT: f64 = 0.01;

/// How a link is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    /// It moves by itself, or it is what others hang on.
    Free,
    /// By a fixed joint.
    Fixed,
    /// By a fixed joint, and neither its mass nor its moments are felt beside what it is fixed to.
    Dummy,
}

/// Of each link, by the bodies of the model.
pub(super) fn held(tree: &Tree, bodies: &[Option<Body>]) -> Vec<Held> {
    let moment =
        |k: usize| bodies.get(k).and_then(Option::as_ref).map_or(0.0, |body| body.moments.values[2].max(0.0));
    let mut of_group = vec![0.0; bodies.len()];
    for k in 0..bodies.len() {
        if let Some(sum) = of_group.get_mut(tree.group(k)) {
            *sum += moment(k);
        }
    }
    let held = |k: usize| {
        if !tree.is_carried(k) {
            return Held::Free;
        }
        let others = of_group.get(tree.group(k)).map_or(0.0, |sum| sum - moment(k));
        let is_light = bodies.get(k).and_then(Option::as_ref).is_some_and(|body| body.mass <= FRAME);
        if is_light && moment(k) <= NOT_FELT * others { Held::Dummy } else { Held::Fixed }
    };
    (0..bodies.len()).map(held).collect()
}
